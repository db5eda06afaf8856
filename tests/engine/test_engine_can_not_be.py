"""What can not be before or after an event is seen, though nothing is asked of it.

A balance in which a string would have to push or a prop to pull by more than friction takes: what comes after it is withheld in numbers
and not confirmed in letters. A body that is caught and would turn into what it lies on: refused by name.
"""

from __future__ import annotations

import pytest

import rotsolve
from rotsolve import Unsolvable

CRATE = """
title: A crate that a tie holds, and friction with it
given: {m: MASS, mu: NUMBER, F: FORCE}
surfaces: {floor: level, side: {wall: BACK}}
bodies: {crate: {mass: m, moves: WAY}}
connections: {c: {contact: [crate, floor], friction: mu}, tie: {string: [side, crate]}}
actions: {push: {force: F, on: crate, direction: PUSHED}}
states: {rest: {balance: true}, free: {}}
events: {snip: {cuts: tie, from: rest, to: free}}
find: {a: crate.acceleration at free}
"""
BEAM = """
title: A beam on a stiff hinge, and what holds its end
given: {M: 6 kg, L: 2 m, F: FORCE, tau: 5 N m}
surfaces: {floor: level}
bodies: {beam: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: beam.start, friction_torque: tau}, hold: {HOLD}}
actions: {push: {force: F, on: beam.end, direction: up}}
states: {rest: {beam.angle: 0, balance: true}, free: {}}
events: {off: {removes: hold, from: rest, to: free}}
find: {al: beam.angular_acceleration at free}
"""
WHEEL = """
title: Two loads over a wheel that rubs, one of them held by a cord
given: {m: 5 kg, p: OTHER, R: 20 cm, tau: 1 N m, I: 0.1 kg m^2, m_wheel: 3 kg}
bodies: {A: {mass: p, moves: down}, B: {mass: m, moves: down}, wheel: {mass: m_wheel, inertia: I, radius: R}}
connections: {x: {axle: wheel, friction_torque: tau}, rope: {string: [A, wheel, B]}, hold: {string: [ceiling, A]}}
states: {rest: {balance: true}, free: {}}
events: {snip: {cuts: hold, from: rest, to: free}}
find: {a: B.acceleration at free}
"""
SIDES = {"right": "left", "left": "right"}


def crate(way: str, mass: str, number: str, force: str, *, pulled: bool) -> str:
    text = CRATE.replace("MASS", mass).replace("NUMBER", number).replace("FORCE", force)
    return text.replace("PUSHED", way if pulled else SIDES[way]).replace("WAY", way).replace("BACK", SIDES[way])


@pytest.mark.parametrize("way", SIDES)
def test_a_tie_does_not_push(way: str) -> None:
    """Against the wall 20 N are more than μ m g = 5.88 N; away from it the tie holds them, and 5 N friction alone."""
    with pytest.raises(Unsolvable, match="`tie` lets go at `rest`"):
        rotsolve.solve(crate(way, "3 kg", "0.2", "20 N", pulled=False))
    pulled = rotsolve.solve(crate(way, "3 kg", "0.2", "20 N", pulled=True))
    assert pulled.answers["a"].float == pytest.approx(20 / 3 - 0.2 * 9.8)
    assert all(item.holds for item in pulled.derivation.confirmed)
    assert rotsolve.solve(crate(way, "3 kg", "0.2", "5 N", pulled=False)).answers["a"].float == 0.0
    letters = rotsolve.solve(crate(way, "kg", "number", "N", pulled=False))
    assert [item.holds for item in letters.derivation.confirmed] == [None]


@pytest.mark.parametrize("hold", ["string: [ceiling, beam.end]", "contact: [beam.end, floor]"], ids=["cord", "prop"])
def test_what_holds_up_does_not_hold_down(hold: str) -> None:
    """F L − ½ M g L = 101 N m upwards against 5 N m of friction; with 10 N it is held up."""
    with pytest.raises(Unsolvable, match="`hold` lets go at `rest`"):
        rotsolve.solve(BEAM.replace("HOLD", hold).replace("FORCE", "80 N"))
    held = rotsolve.solve(BEAM.replace("HOLD", hold).replace("FORCE", "10 N"))
    assert held.answers["al"].float == pytest.approx((10 * 2 - 6 * 9.8 + 5) / (6 * 4 / 3))
    assert all(item.holds for item in held.derivation.confirmed)


def test_a_cord_does_not_hold_down_what_a_heavier_load_lifts() -> None:
    """m g R − p g R = 5.88 N m against τ = 1 N m; with p = 7 kg the cord holds p up."""
    with pytest.raises(Unsolvable, match="`hold` lets go at `rest`"):
        rotsolve.solve(WHEEL.replace("OTHER", "2 kg"))
    held = rotsolve.solve(WHEEL.replace("OTHER", "7 kg"))
    assert held.answers["a"].float == pytest.approx(-(2 * 9.8 * 0.2 - 1) * 0.2 / (0.1 + 12 * 0.04))
    assert all(item.holds for item in held.derivation.confirmed)


CAUGHT = """
title: A body on a floor of which one point is suddenly held
given: {m: kg, a: m, b: m, u: m/s}
surfaces: {floor: level}
bodies: {it: {BODY, mass: m, moves: WAY}}
connections: {c: {HOLD: [it, floor]}}
states: {before: {it.velocity: u}, after: {}}
events: {catch: {fixes: it.POINT, from: before, to: after}}
find: {w: it.angular_velocity at after}
"""
POINTS = {  # a point of a body, the way in which it slides or rolls when it is held, and whether that turns it off the floor
    ("shape: rectangle, sides: [a, b]", "contact", "corner2", "right"): True,
    ("shape: rectangle, sides: [a, b]", "contact", "corner1", "right"): False,
    ("shape: rectangle, sides: [a, b]", "contact", "corner1", "left"): True,
    ("shape: rectangle, sides: [a, b]", "contact", "corner2", "left"): False,
    ("shape: disc, radius: a", "rolls", "rim", "right"): True,  # its rim lies on the right
    ("shape: disc, radius: a", "rolls", "rim", "left"): False,
}


@pytest.mark.parametrize(("body", "hold", "point", "way"), POINTS)
def test_what_is_caught_does_not_turn_into_the_floor(body: str, hold: str, point: str, way: str) -> None:
    text = CAUGHT.replace("BODY", body).replace("HOLD", hold).replace("POINT", point).replace("WAY", way)
    if POINTS[body, hold, point, way]:
        assert all(item.holds for item in rotsolve.solve(text).derivation.confirmed)
    else:
        with pytest.raises(Unsolvable, match="it is pressed into what it lies on at `after`"):
            rotsolve.solve(text)


def test_a_ladder_that_is_caught_does_not_turn_into_its_wall() -> None:
    text = """
title: Ladder that slides down is caught
given: {m: 3 kg, L: 2 m, u: 0.5 m/s}
surfaces: {floor: level, side: {wall: left}}
bodies: {lad: {shape: rod, mass: m, length: L}}
connections: {foot: {contact: [lad.end, floor]}, head: {contact: [lad.start, side]}}
states: {before: {lad.angle: -60 deg, lad.end.velocity.x: u}, after: {}}
events: {catch: {fixes: lad.center, from: before, to: after}}
find: {w: lad.angular_velocity at after}
"""
    with pytest.raises(Unsolvable, match="lad is pressed into what it lies on"):
        rotsolve.solve(text)


LUMP_ON_A_SLOPE = """
title: Angular momentum about a lump that is welded to a crate on a slope
given: {m: 3 kg, q: 1 kg, a: 0.5 m, b: 0.4 m, beta: 20 deg, u: 2 m/s}
surfaces: {ramp: {slope: beta, down: right}}
bodies: {lump: {mass: q}, crate: {shape: rectangle, mass: m, sides: [a, b], moves: down}}
connections: {c: {contact: [crate, ramp]}, glue: {weld: [crate.corner3, lump]}}
states: {now: {SAID}}
find: {L: crate.angular_momentum about lump at now}
"""
ON_A_SLOPE = """
title: A crate on a slope, caught at a corner
given: {m: 3 kg, a: 0.5 m, b: 0.4 m, beta: 20 deg, u: 2 m/s}
surfaces: {ramp: {slope: beta, down: WAY}}
bodies: {crate: {shape: rectangle, mass: m, sides: [a, b], moves: down}}
connections: {c: {contact: [crate, ramp]}}
states: {before: {SAID}, after: {}}
EVENTS
find: {ASKED}
"""
CATCH = "events: {catch: {fixes: crate.CORNER, from: before, to: after}}"
ASKED = {
    "blow": "w: crate.angular_velocity at after",
    "moment": "L: crate.angular_momentum about crate.CORNER at before",
}


@pytest.mark.parametrize("asked", ASKED)
@pytest.mark.parametrize(("way", "corner", "lies"), [("right", "corner2", "-beta"), ("left", "corner1", "beta")])
def test_how_a_crate_stands_on_a_slope_is_asked_for_where_it_matters(
    asked: str, way: str, corner: str, lies: str
) -> None:
    """ω = 3 u b/(2 (a² + b²)) about the lower corner, L = ½ m u b; drawn upright they would hang on the slope."""
    text = ON_A_SLOPE.replace("WAY", way).replace("ASKED", ASKED[asked])
    text = text.replace("EVENTS", CATCH if asked == "blow" else "").replace("CORNER", corner)
    text = text if asked == "blow" else text.replace(", after: {}", "")
    with pytest.raises(Unsolvable, match="how `crate` stands on its slope nothing tells"):
        rotsolve.solve(text.replace("SAID", "crate.velocity: u"))
    (answer,) = rotsolve.solve(text.replace("SAID", f"crate.velocity: u, crate.angle: {lies}")).answers.values()
    true = {"blow": 3 * 2 * 0.4 / (2 * (0.25 + 0.16)), "moment": 0.5 * 3 * 2 * 0.4}
    assert abs(answer.float or 0.0) == pytest.approx(true[asked])


def test_a_body_that_is_welded_to_the_crate_stands_with_it() -> None:
    """L = ½ m u b about an upper corner, the way round the crate passes below it; where the lump is hangs on how the crate stands."""
    with pytest.raises(Unsolvable, match="how `crate` stands on its slope nothing tells, and so where `lump` is"):
        rotsolve.solve(LUMP_ON_A_SLOPE.replace("SAID", "crate.velocity: u"))
    told = rotsolve.solve(LUMP_ON_A_SLOPE.replace("SAID", "crate.velocity: u, crate.angle: -beta"))
    assert abs(told.answers["L"].float or 0.0) == pytest.approx(0.5 * 3 * 2 * 0.4)
