"""Ties: something comes to rest, or begins to roll, exactly at the instant or place that is asked: forces are those from then on."""

from __future__ import annotations

import re

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

CLUTCH = """
given: {I: 1 kg m^2, J: 1 kg m^2, tau: 2 N m, Q: 1 N m, w: 3 rad/s, T: 1 s}
bodies: {a: {inertia: I}, b: {inertia: J}}
connections: {stud: {axle: [a, b]}, cl: {clutch: [a, b], friction_torque: tau}}
actions: {motor: {couple: Q, on: a}}
states: {start: {a.angular_velocity: w, b.angular_velocity: 0}, end: {time: T}}
find: {T1: cl.torque at end, al: a.angular_acceleration at end}
"""
SLOPE = """
given: {m: 2 kg, beta: 30 deg, mu: MU, T: 2 s, g: 10 m/s^2, u: (sin(beta) + mu * cos(beta)) * g * T, d: u * T / 2}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {box: {mass: m, moves: up}}
connections: {touch: {contact: [box, ramp], friction: mu}}
states: {start: {box.velocity: u}, end: {END}}
find: {a: box.acceleration at end, v: box.velocity at end}
"""
BALL = """
given: {m: 2 kg, R: 1 m, mu: 0.2, g: 10 m/s^2, u: 7 m/s, d: 6 m}
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: SIDE}}
connections: {touch: {contact: [ball, floor], friction: mu}}
states: {start: {ball.velocity: u, ball.angular_velocity: 0}, end: {END}}
find: {a: ball.acceleration at end, v: ball.velocity at end}
"""
PUSHED = """
given: {m: 2 kg, c: 3 N/s, mu: 0.1, g: 10 m/s^2, u: 5 m/s}
surfaces: {floor: level}
bodies: {box: {mass: m, moves: right}}
connections: {touch: {contact: [box, floor], friction: mu}}
actions: {push: {force: c * time, on: box, direction: left}}
states: {start: {box.velocity: u}, end: {time: 2 s}}
find: {a: box.acceleration at end, v: box.velocity at end}
"""
BRAKED = """
given: {I: 2 kg m^2, R: 0.5 m, mu: 0.4, P: 10 N, w: 3 rad/s, Q: 1 N m}
bodies: {wheel: {inertia: I, radius: R}}
connections: {ax: {axle: wheel}}
actions: {shoe: {press: P, on: wheel.rim, friction: mu}, motor: {couple: Q, on: wheel}}
states: {start: {wheel.angular_velocity: w}, end: {END}}
find: {a: wheel.angular_acceleration at end, v: wheel.angular_velocity at end}
"""
SINE, COSINE = 0.5, 0.8660254037844386
TIES = {
    "clutch locks": (CLUTCH, {"T1": 0.5, "al": 0.5}),
    "held on a slope, by time": (SLOPE.replace("MU", "0.7").replace("END", "time: T"), {"a": 0.0, "v": 0.0}),
    "held on a slope, by place": (
        SLOPE.replace("MU", "0.7").replace("END", "box.displacement: d"),
        {"a": 0.0, "v": 0.0},
    ),
    "slides back": (SLOPE.replace("MU", "0.2").replace("END", "time: T"), {"a": 10 * (0.2 * COSINE - SINE), "v": 0.0}),
    "mirrored": (
        SLOPE.replace("MU", "0.2").replace("END", "box.displacement: d").replace("left", "right"),
        {"a": 10 * (0.2 * COSINE - SINE), "v": 0.0},
    ),
    "rolls, by time": (BALL.replace("SIDE", "right").replace("END", "time: 1 s"), {"a": 0.0, "v": 5.0}),
    "rolls, by place": (BALL.replace("SIDE", "left").replace("END", "ball.displacement: d"), {"a": 0.0, "v": 5.0}),
    "by a force that grows": (PUSHED, {"a": -2.0, "v": 0.0}),
    "braked": (BRAKED.replace("END", "time: 6 s"), {"a": 0.0, "v": 0.0}),
    "braked, by angle": (BRAKED.replace("END", "wheel.rotation: 9 rad"), {"a": 0.0, "v": 0.0}),
}


@pytest.mark.parametrize(("text", "true"), TIES.values(), ids=list(TIES))
def test_forces_are_those_from_then_on(text: str, true: dict[str, float]) -> None:
    """By hand: what rests is held, or driven back by what is more than friction; a state that follows changes nothing."""
    found = solve(text)
    assert {name: found.answers[name].float for name in true} == {
        name: pytest.approx(value, abs=1e-12) for name, value in true.items()
    }
    assert {item.holds for item in found.derivation.confirmed} == {True}


LETTERS = {
    "block, by time": (
        """
given: {m: kg, mu: number, u: m/s, T: s}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: SIDE}}
connections: {base: {contact: [block, floor], friction: mu}}
states: {start: {block.velocity: u}, end: {time: T}}
find: {a: block.acceleration at end, f: base.friction_force at end}
""",
        {
            "a": {("0", ("u ≤ μ g T",)), ("−μ g", ("u > μ g T",))},
            "f": {("0", ("u ≤ μ g T",)), ("μ m g", ("u > μ g T",))},
        },
        "",
    ),
    "block, by place": (
        """
given: {m: kg, mu: number, u: m/s, d: m}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: SIDE}}
connections: {base: {contact: [block, floor], friction: mu}}
states: {start: {block.velocity: u}, end: {block.displacement: d}}
find: {v: block.velocity at end, a: block.acceleration at end}
""",
        {
            "v": {("√(u² − 2 μ g d)", ("μ ≤ u²/(2 g d)",))},
            "a": {("−μ g", ("μ < u²/(2 g d)",)), ("0", ("μ = u²/(2 g d)",))},
        },
        "if μ > u²/(2 g d) there is no answer",
    ),
    "wheel, by angle": (
        """
gravity: none
given: {I: kg m^2, q: N m, w: rad/s, n: rad}
bodies: {wheel: {inertia: I}}
connections: {ax: {axle: wheel, friction_torque: q}}
states: {start: {wheel.angular_velocity: w}, end: {wheel.rotation: n}}
find: {a: wheel.angular_acceleration at end, v: wheel.angular_velocity at end}
""",
        {
            "a": {("−q/I", ("I > 2 q n/w²",)), ("0", ("I = 2 q n/w²",))},
            "v": {("√((I w² − 2 q n)/I)", ("I ≥ 2 q n/w²",))},
        },
        "if I < 2 q n/w² there is no answer",
    ),
    "rod in a rubbing hinge": (
        """
given: {M: kg, L: m, q: N m}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start, friction_torque: q}}
states: {start: {rod.angle: 0, at rest: all}, low: {rod.angle: -90 deg}}
find: {w: rod.angular_velocity at low, W: pin.work from start to low, a: rod.angular_acceleration at start}
""",
        {
            "w": {("−√(3 (M g L − π q)/M)/L", ("q ≤ M g L/π",))},
            "W": {("−½ π q", ("q ≤ M g L/π",))},
        },
        "if q > M g L/π there is no answer for w, W",
    ),
    "rod up to where it is driven on": (
        """
given: {M: kg, L: m, w: rad/s}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {low: {rod.angle: -90 deg, rod.angular_velocity: w}, level: {rod.angle: 0}}
find: {v: rod.angular_velocity at level}
""",
        {"v": {("√((L w² − 3 g)/L)", ("L ≥ 3 g/w²",))}},
        "if L < 3 g/w² there is no answer",
    ),
    "rod up to its balance": (
        """
given: {M: kg, L: m, w: rad/s}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {low: {rod.angle: -90 deg, rod.angular_velocity: w}, top: {rod.angle: 90 deg}}
find: {v: rod.angular_velocity at top, Fy: pin.force.y at top}
""",
        {
            "v": {("√((L w² − 6 g)/L)", ("L > 6 g/w²",))},
            "Fy": {("½ M (8 g − L w²)", ("L > 6 g/w²",))},
        },
        "if L ≤ 6 g/w² there is no answer",
    ),
    "ring on a slope": (
        """
given: {M: kg, R: m, w: rad/s, mu: number, beta: rad}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {wheel: {shape: ring, mass: M, radius: R, moves: up, turns: clockwise}}
connections: {grip: {contact: [wheel, ramp], friction: mu}}
states: {start: {wheel.velocity: 0, wheel.angular_velocity: w}, one: {grip: rolls}}
find: {a: wheel.acceleration at one}
""",
        {"a": {("−½ g sin β", ("μ > ½ tan β",))}},
        "if μ = ½ tan β no answer is given for a: one is never reached",
    ),
}


WAYS = [(name, side) for name in LETTERS for side in ("right", "left") if side == "right" or "SIDE" in LETTERS[name][0]]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("name", "side"), WAYS)
def test_letters_say_so_at_equality(name: str, side: str) -> None:
    """An edge belongs to the case whose value is found on it, or is told alone; what is only neared is not reached."""
    text, true, said = LETTERS[name]
    found = solve(text.replace("SIDE", side))
    for letter, cases in true.items():
        assert {(case.exact, case.conditions) for case in found.answers[letter].branches} == cases
    assert said in str(found).replace("`", "").replace("\n  ", " ")
    assert all(item.holds and not item.astray for item in found.derivation.confirmed)


@pytest.mark.parametrize("asked", ["v: rod.angular_velocity at top", "Fy: pin.force.y at top"])
def test_a_balance_is_not_reached_from_elsewhere(asked: str) -> None:
    """With just the energy of the upper balance a pendulum comes ever nearer to it, for ever."""
    text = LETTERS["rod up to its balance"][0].replace("M: kg, L: m, w: rad/s", "M: 2 kg, L: 1 m, g: 10 m/s^2, w: W")
    text = re.sub("find: .*", "find: {" + asked + "}", text)
    with pytest.raises(Unsolvable, match="`top` is never reached from `low`") as fault:
        solve(text.replace("W}", "sqrt(6 * g / L)}"))
    assert fault.value.fault.help == "nothing drives rod where it would come to rest"
    assert solve(text.replace("W}", "sqrt(7 * g / L)}")).answers[asked.partition(":")[0]].float != 0.0


@pytest.mark.parametrize("asked", ["t: time from start to one", "a: wheel.acceleration at one"])
def test_what_slips_on_as_fast_never_rolls(asked: str) -> None:
    """At μ = ½ tan β the rim of the ring gains as much speed down the slope as its turn loses."""
    text = LETTERS["ring on a slope"][0].replace("M: kg, R: m, w: rad/s", "M: 1 kg, R: 1 m, w: 3 rad/s")
    text = re.sub("find: .*", "find: {" + asked + "}", text.replace("beta: rad", "beta: 0.3 rad"))
    with pytest.raises(Unsolvable, match="`one` is never reached from `start`"):
        solve(text.replace("mu: number", "mu: 0.5 * tan(beta)"))
    assert solve(text.replace("mu: number", "mu: 0.6 * tan(beta)")).answers[asked[0]].float
