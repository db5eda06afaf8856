"""What the assembly contradicts is withheld, whatever in the engine is spoilt; what it can't follow is said not to be confirmed."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol, formula, sqrt
from rotsolve.confirm.verdicts import confirmations, confirmed
from rotsolve.core.facts import Couple, Force
from rotsolve.core.faults import Unsolvable
from rotsolve.derivation.directions import Directions
from rotsolve.elements.actions import AppliedForce
from rotsolve.elements.collisions import Collides
from rotsolve.elements.connections.springs import Spring
from rotsolve.elements.connections.strings import String
from rotsolve.elements.connections.supports import Axle
from rotsolve.pipeline import solve

WINCH = """title: A bucket on a drum with friction
given: {m: 2 kg, M: 5 kg, R: 0.2 m, tau: 0.5 N m}
bodies: {bucket: {mass: m, moves: down}, drum: {shape: disc, mass: M, radius: R, turns: clockwise}}
connections: {axle: {axle: drum, friction_torque: tau}, rope: {string: [drum, bucket]}}
find: {a: bucket.acceleration, T: rope.tension, k: drum.mass}
"""
DOOR = """title: A pushed door
plane: horizontal
given: {M: 9 kg, L: 90 cm, F: 20 N}
bodies: {door: {shape: rod, mass: M, length: L}}
connections: {post: {hinge: door.start}}
actions: {push: {force: F, on: door.at(2*L/3), direction: tangential}}
find: {alpha: door.angular_acceleration, k: door.mass}
"""
BOUNCE = """title: A ball bounces off a hanging rod
given: {M: 2 kg, L: 1 m, m: 200 g, u: 6 m/s}
bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: rod, ball.velocity: u}, after: {}}
events: {hit: {collides: [ball, rod.end], restitution: 0.8, from: before, to: after}}
find: {w: rod.angular_velocity at after, k: rod.mass}
"""
COIL = """title: A load let go on a stretched spring
given: {m: 2 kg, k: 150 N/m}
bodies: {load: {mass: m, moves: down}}
connections: {coil: {spring: [ceiling, load], stiffness: k}}
states: {now: {coil.elongation: 2 cm, at rest: all}}
find: {a: load.acceleration at now, q: load.mass}
"""


def against(fact: Any) -> Any:
    return replace(fact, torque=-fact.torque) if isinstance(fact, Couple) else fact


def at_the_middle(fact: Any) -> Any:
    return replace(fact, arm=fact.arm.times(formula(1) / formula(2))) if isinstance(fact, Force) else fact


def stiffer(fact: Any) -> Any:
    return replace(fact, size=fact.size * 2) if isinstance(fact, Force) else fact


MUTANTS: dict[str, tuple[str, type, Callable[[Any], Any]]] = {
    "half an arm of a string": (WINCH, String, at_the_middle),
    "friction that drives": (WINCH, Axle, against),
    "a shorter arm": (DOOR, AppliedForce, at_the_middle),
    "a stiffer spring": (COIL, Spring, stiffer),
}


@pytest.mark.parametrize("name", MUTANTS)
def test_an_engine_that_is_spoilt_answers_nothing_wrong(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    text, element, change = MUTANTS[name]
    right = {key: answer.float for key, answer in solve(text).answers.items()}
    facts = element.facts  # type: ignore[attr-defined]

    def spoilt(self: Any, instant: Any) -> Iterator[Any]:
        yield from map(change, facts(self, instant))

    monkeypatch.setattr(element, "facts", spoilt)
    try:
        wrong = solve(text, confirm=False).answers
        assert any(abs(answer.float - right[key]) > 1e-3 for key, answer in wrong.items() if answer.float is not None)
        found = solve(text)
    except Unsolvable as error:
        assert "not confirmed" in error.render() or "contradict" in error.render()
        return
    assert found.refused
    assert all("not confirmed" in reason.render() for reason in found.refused.values())
    assert all(answer.float == pytest.approx(right[key]) for key, answer in found.answers.items())


def test_a_blow_that_is_spoilt_is_withheld(monkeypatch: pytest.MonkeyPatch) -> None:
    bounce = Collides.bounce

    def weaker(self: Any, before: Any, after: Any) -> Any:
        found = bounce(self, before, after)
        return found and (found[0] * formula(1) / formula(2), *found[1:])

    monkeypatch.setattr(Collides, "bounce", weaker)
    found = solve(BOUNCE)
    assert list(found.refused) == ["w"]
    assert list(found.answers) == ["k"]


@pytest.mark.parametrize("factor", [-1.0, 1.001, 0.0])
@pytest.mark.parametrize("text", [WINCH, DOOR, BOUNCE, COIL])
def test_an_answer_that_is_a_little_off_or_turned_round_is_contradicted(text: str, factor: float) -> None:
    solution = solve(text)
    assert all(item.holds for item in solution.derivation.confirmed)
    name = solution.derivation.confirmed[0].name
    verdicts = solution.derivation.confirmed
    moved = tuple(factor * value for value in verdicts[0].answered)
    from rotsolve.confirm.course.reading import number
    from rotsolve.confirm.course.verdict import compared

    assert compared(name, {"": moved[0]}, number(verdicts[0].found[0])).holds is False
    derivation = replace(solution.derivation, confirmed=(replace(verdicts[0], holds=False), *verdicts[1:]))
    left = confirmed(derivation, solution.problem)
    assert name not in [answer.name for answer in left.answers]
    assert left.sections == ()
    assert [refusal.name for refusal in left.refused] == [name]


def test_where_all_is_contradicted_nothing_is_printed() -> None:
    solution = solve(DOOR)
    verdicts = tuple(replace(item, holds=False) for item in solution.derivation.confirmed)
    with pytest.raises(Unsolvable, match=r"not confirmed: .*`alpha`, `k`"):
        confirmed(replace(solution.derivation, confirmed=verdicts), solution.problem)


def test_it_is_left_out_on_request() -> None:
    plain, full = solve(WINCH, confirm=False), solve(WINCH)
    assert plain.derivation.confirmed == ()
    assert "solved with numbers" not in str(plain)
    assert "confirmed with numbers" in " ".join(str(full).split())
    checks = [one.words[0] for one in full.derivation.checks]
    assert "another sum over the masses gives the same " in checks


def test_json_carries_what_is_confirmed() -> None:
    data = json.loads(solve(WINCH).to("json"))
    assert data["confirmed"] == [{"name": name, "confirmed": True, "reason": ""} for name in "aTk"]


def test_what_is_not_followed_is_said_with_its_reason() -> None:
    text = DOOR.replace("k: door.mass", "B: door.at(L/2).bending_moment")
    item = solve(text).derivation.confirmed[1]
    assert (item.name, item.holds) == ("B", None)
    assert "bending moment" in item.why
    assert "not confirmed: B" in str(solve(text))


def test_letters_are_tried_at_numbers_of_every_case() -> None:
    text = WINCH.replace("2 kg", "kg").replace("5 kg", "kg").replace("0.2 m", "m").replace("0.5 N m", "N m")
    assert all(item.holds is not False for item in solve(text).derivation.confirmed)


def test_both_values_are_shown(tmp_path: Path) -> None:
    lines = solve(WINCH, confirm=False).confirmation_text().splitlines()
    assert lines[0] == "a: confirmed"
    assert lines[1].startswith("  answered 3.8")


@pytest.mark.parametrize("state", ["{block.velocity: 0}", "{time: 3 s}"])
def test_friction_at_the_last_state_is_that_of_its_phase_or_of_what_comes_then(state: str) -> None:
    text = f"""title: A block comes to rest
given: {{mu: 0.2, u: 2 m/s}}
surfaces: {{floor: level}}
bodies: {{block: {{mass: 2 kg, moves: right}}}}
connections: {{base: {{contact: [block, floor], friction: mu}}}}
states: {{start: {{block.velocity: u}}, end: {state}}}
find: {{f: base.friction_force at end, x: block.displacement from start to end}}
"""
    assert all(item.holds for item in solve(text).derivation.confirmed)


@pytest.mark.parametrize(("rim", "turned"), [("outer", 2.0), ("inner", 1.25)])
def test_a_rim_is_a_place_on_the_right_of_its_wheel(rim: str, turned: float) -> None:
    text = f"""title: A rolling washer
given: {{R: 20 cm, u: 3 m/s}}
surfaces: {{floor: level}}
bodies: {{washer: {{shape: annulus, mass: 2 kg, radii: {{inner: R/2, outer: R}}, moves: right}}}}
connections: {{base: {{rolls: [washer.outer, floor]}}}}
states: {{start: {{washer.velocity: u}}}}
find: {{v: washer.{rim}.speed at start}}
"""
    item = solve(text).derivation.confirmed[0]
    assert item.holds
    assert item.found[0] == pytest.approx(3 * turned**0.5)


@pytest.mark.parametrize("corner", ["corner1", "corner2", "corner3"])
def test_what_hangs_in_balance_is_placed_where_it_comes_to_rest(corner: str) -> None:
    """Nothing but the balance tells how a plate hangs: its centre of mass is below the nail, whichever corner that holds."""
    solution = solve(f"""
title: Plate hung from a corner
bodies: {{plate: {{shape: rectangle, mass: 2 kg, sides: [40 cm, 30 cm]}}}}
connections: {{nail: {{hinge: plate.{corner}}}}}
states: {{hangs: {{balance: true}}}}
find: {{theta: plate.angle at hangs}}
""")
    assert solution.answers["theta"].float == pytest.approx(-math.pi / 2)
    assert [item.holds for item in solution.derivation.confirmed] == [True]


SLIDES = """title: A crate slides to the right, or to the left
given: {m: 2 kg, u: 3 m/s, mu: 0.4}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: WAY}}
connections: {base: {contact: [crate, floor], friction: mu}}
states: {start: {crate.velocity: u}}
find: {f: base.friction_force at start}
"""


@pytest.mark.parametrize("way", ["right", "left"])
def test_friction_that_is_told_to_point_the_other_way_is_withheld(way: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of friction the size is an answer, and its direction a word beside it: both are held against the assembly."""
    text = SLIDES.replace("WAY", way)
    assert all(item.holds for item in solve(text).derivation.confirmed)
    told = Directions.words
    other = {"left": "right", "right": "left"}
    monkeypatch.setattr(Directions, "words", lambda *given: other[told(*given)])
    with pytest.raises(Unsolvable, match="point the other way"):
        solve(text)


def test_a_formula_without_a_real_value_where_there_is_one_is_told() -> None:
    """√(m − M) for the acceleration of a crate that is pulled: for M > m nothing on the page would say that it is none."""
    solution = solve("""title: A pulled crate
given: {m: kg, M: kg, F: N}
surfaces: {ice: level}
bodies: {crate: {mass: m + M, moves: right}}
connections: {base: {contact: [crate, ice]}}
actions: {pull: {force: F, on: crate, direction: right}}
find: {a: crate.acceleration}
""")
    root = sqrt(Symbol("m") - Symbol("M"))
    spoilt = [replace(answer, formula=root, closed=root) for answer in solution.derivation.answers]
    (verdict,) = confirmations(spoilt, solution.problem, None, lambda numbers: True)
    assert verdict.holds is False or "no real value" in verdict.why
