"""What only pulls or pushes is asked at each of its parts, whatever is asked: strings over heavy pulleys, brakes, corners on slopes."""

from __future__ import annotations

import pytest

import rotsolve
from compositions.freed import holds

PULLEY = """
title: Two loads over a heavy pulley that a couple turns
given: {m: kg, M: kg, I: kg m^2, R: m, Q: N m}
bodies: {left: {mass: m, moves: up}, p: {inertia: I, radius: R, turns: clockwise}, right: {mass: M, moves: down}}
connections: {axle: {axle: p}, rope: {string: [left, p, right]}}
actions: {motor: {couple: Q, on: p}}
states: {start: at rest}
"""
NUMBERS = {"m": "1 kg", "M": "1 kg", "I": "1 kg m^2", "R": "1 m"}
ASKED = {
    "left": "T: rope.left.tension",
    "right": "T: rope.right.tension",
    "axle": "F: size of axle.force",
    "rate": "a: left.acceleration",
}


@pytest.mark.parametrize("asked", ASKED.values(), ids=ASKED)
def test_all_parts_of_a_string_have_to_pull(asked: str) -> None:
    """T_right = M (g − a) with a = (Q + (M − m) g R) R/(I + (m + M) R²): at these numbers Q < 29.4 N m."""
    solution = rotsolve.solve(f"{PULLEY}find: {{{asked}}}")
    (answer,) = solution.answers.values()
    limits = answer.conditions
    assert any("Q <" in limit for limit in limits), limits
    assert not any(check.holds is False for check in solution.derivation.checks)


@pytest.mark.parametrize("asked", ASKED.values(), ids=ASKED)
@pytest.mark.parametrize(("couple", "taut"), [("29 N m", True), ("30 N m", False)])
def test_a_slack_part_is_told_in_numbers(asked: str, couple: str, taut: bool) -> None:
    settings = {**NUMBERS, "Q": couple}
    try:
        solution = rotsolve.solve(f"{PULLEY}find: {{{asked}}}", settings=settings)
    except rotsolve.Unsolvable as error:
        assert not taut and "rope" in str(error)
        return
    objected = any(check.holds is False for check in solution.derivation.checks)
    assert objected is not taut


BRAKE = """
title: Brake that is let off
given: {I: kg m^2, R: m, w: rad/s, mu: number, P: N, c: %s}
bodies: {wheel: {inertia: I, radius: R}}
connections: {axle: {axle: wheel}}
actions: {brake: {press: P - c*%s, on: wheel.rim, friction: mu}}
states: {start: {wheel.angular_velocity: w}, end: {%s}}
find: {we: wheel.angular_velocity at end}
"""
BRAKES = {
    "by time": BRAKE % ("N/s", "time", "time: 2 s"),
    "by turn": BRAKE % ("N", "wheel.rotation", "wheel.rotation: 2 rad"),
}
SLOW = {"I": "1 kg m^2", "R": "0.1 m", "w": "10 rad/s", "mu": "0.1"}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("text", BRAKES.values(), ids=BRAKES)
def test_a_brake_block_never_pulls_in_letters(text: str) -> None:
    """P ≥ c t at the end, where it presses least."""
    answer = rotsolve.solve(text, confirm=False).answers["we"]
    cases = [answer, *answer.otherwise]
    assert all(any(condition.startswith("P ≥ c ") for condition in case.conditions) for case in cases)


@pytest.mark.parametrize("text", BRAKES.values(), ids=BRAKES)
@pytest.mark.parametrize(("press", "pushes"), [("5 N", True), ("4 N", True), ("3.9 N", False)])
def test_a_brake_block_never_pulls_in_numbers(text: str, press: str, pushes: bool) -> None:
    units = "N/s" if "time: 2 s" in text else "N"
    solution = rotsolve.solve(text, settings={**SLOW, "P": press, "c": f"2 {units}"})
    told = [str(check.words) for check in solution.derivation.checks if check.holds is False]
    assert bool(told) is not pushes
    assert pushes or "would have to pull" in told[0]


CRATE = """
title: Crate on two edges
given: {m: 2 kg, a: 1 m, b: 0.5 m, beta: 20 deg}
surfaces: {ramp: {slope: beta, down: %s}}
bodies: {crate: {shape: rectangle, mass: m, sides: [a, b]}}
connections: {l: {contact: [crate.corner1, ramp], friction: any}, r: {contact: [crate.corner2, ramp], friction: none}}
states: {now: {%sat rest: all, balance: true}}
find: {Nl: l.normal_force, Nr: r.normal_force}
"""


@pytest.mark.parametrize(("down", "lean", "sign"), [("right", "-beta", 1.0), ("left", "beta", -1.0)])
def test_corners_on_a_slope_lie_along_it(down: str, lean: str, sign: float) -> None:
    """N = m g (a cos β ∓ b sin β)/(2 a) by torques about the other corner; told level, they can not both touch."""
    answers = rotsolve.solve(CRATE % (down, f"crate.angle: {lean}, ")).answers
    assert answers["Nl"].float == pytest.approx(2 * 9.8 * (0.9396926 - sign * 0.5 * 0.3420201) / 2, rel=1e-6)
    assert answers["Nr"].float == pytest.approx(2 * 9.8 * (0.9396926 + sign * 0.5 * 0.3420201) / 2, rel=1e-6)
    for untold in ("", "crate.angle: 0 deg, "):
        with pytest.raises(rotsolve.Unsolvable, match=r"do not both lie on `ramp`"):
            rotsolve.solve(CRATE % (down, untold))


def test_what_goes_by_the_angle_itself_does_not_come_again_a_turn_later() -> None:
    """θ̈ = −k² θ from 0 with ω₀ = 8 rad/s turns back at 8 rad, and is back after π/k with −ω₀."""
    scene = """
title: Wheel driven back to a place
given: {w0: 8 rad/s, f: 0.4 rad, k: 1 s^-1}
bodies: {wheel: {shape: disc, mass: 1 kg, radius: 1 m}}
connections: {axle: {axle: wheel, angular_acceleration: "-k^2*wheel.angle"}}
states: {start: {wheel.angle: 0, wheel.angular_velocity: w0}, end: {wheel.angle: f}, back: {wheel.angle: 0}}
find: {t: time from start to back, w: wheel.angular_velocity at back}
"""
    answers = rotsolve.solve(scene).answers
    assert (answers["t"].float, answers["w"].float) == pytest.approx((3.14159265359, -8.0), rel=1e-8)


@pytest.mark.parametrize("under", ["table: level", "table: {slope: 30 deg, down: left}"], ids=["level", "slope"])
def test_a_string_without_a_pulley_pulls_along_one_line(under: str) -> None:
    """A block on a table and a load that falls: nothing leads the string over the edge, so nothing says how it pulls them."""
    scene = f"""
title: Block and load
given: {{m: 1 kg, M: 3 kg}}
surfaces: {{{under}}}
bodies: {{block: {{mass: M}}, load: {{mass: m, moves: down}}}}
connections: {{base: {{contact: [block, table]}}, rope: {{string: [block, load]}}}}
find: {{T: rope.tension}}
"""
    with pytest.raises(rotsolve.Unsolvable, match="along different lines"):
        rotsolve.solve(scene)
    pulley = scene.replace("[block, load]", "[block, p, load]").replace(
        "bodies: {", "bodies: {p: {shape: disc, mass: 0}, "
    )
    tension = rotsolve.solve(pulley.replace("connections: {", "connections: {a: {axle: p}, ")).answers["T"].float
    assert tension == pytest.approx(9.8 * 3 / 4 * (1.0 if "level" in under else 1.5))


SWELLING = {
    "lift": (
        """
title: Crate under a force that swells and dies
given: {m: kg, F: N, c: N/s^2, T: s}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {base: {contact: [crate, floor]}}
actions: {push: {force: F, on: crate, direction: right}, lift: {force: c*time*(T - time), on: crate, direction: up}}
states: {start: at rest, end: {time: T}}
find: {N: base.normal_force at end, v: crate.velocity at end}
""",
        "c ≤ 4 m g/T²",
        {"m": "2 kg", "F": "1 N", "T": "2 s"},
        19.6,
    ),
    "drum": (
        """
title: Load on a drum that a couple turns back
given: {I: kg m^2, R: m, m: kg, c: N m/s^2, T: s}
bodies: {drum: {inertia: I, radius: R, turns: clockwise}, load: {mass: m, moves: down}}
connections: {axle: {axle: drum}, rope: {string: [drum.rim, load]}}
actions: {motor: {couple: c*time*(T - time), on: drum}}
states: {start: at rest, end: {time: T}}
find: {v: load.velocity at end}
""",
        "I ≥ c R T²/(4 g)",
        {"I": "2 kg m^2", "R": "1 m", "m": "1 kg", "T": "2 s"},
        19.6,
    ),
}


@pytest.mark.parametrize("kind", SWELLING)
def test_what_lets_go_only_within_a_phase_is_a_condition(kind: str) -> None:
    """The push is least at T/2: m g − c T²/4, and m (I g − R c T²/4)/(I + m R²)."""
    text, condition, _, _ = SWELLING[kind]
    for answer in rotsolve.solve(text).answers.values():
        assert answer.conditions == (condition,)
        assert not answer.otherwise


@pytest.mark.parametrize("kind", SWELLING)
@pytest.mark.parametrize(("share", "holds"), [(0.99, True), (1.0, True), (1.01, False)])
def test_what_lets_go_only_within_a_phase_is_told_in_numbers(kind: str, share: float, holds: bool) -> None:
    text, _, numbers, limit = SWELLING[kind]
    units = "N/s^2" if kind == "lift" else "N m/s^2"
    solution = rotsolve.solve(text, settings={**numbers, "c": f"{share * limit:.3f} {units}"}, confirm=False)
    assert any(check.holds is False for check in solution.derivation.checks) is not holds


def test_a_push_that_is_largest_within_a_phase_asks_for_nothing() -> None:
    text = SWELLING["lift"][0].replace("direction: up", "direction: down")
    assert all(not answer.conditions for answer in rotsolve.solve(text).answers.values())


LUMP = """
title: Load on a wheel with a lump on it
given: {m: kg, M: kg, I: kg m^2, R: m, b: m}
bodies:
  wheel: {inertia: I, mass: 1 kg, radius: R, turns: clockwise, points: {P: [0, b]}}
  lump: {mass: M}
  load: {mass: m, moves: down}
connections: {axle: {axle: wheel}, bolt: {weld: [wheel.P, lump]}, rope: {string: [wheel.rim, load]}}
states: {start: {wheel.rotation: 0, at rest: all}, low: {wheel.rotation: %s}}
find: {v: load.velocity at low}
"""


@pytest.mark.parametrize(
    ("turn", "passes"), [("180 deg", True), ("100 deg", True), ("80 deg", False), ("540 deg", True)]
)
def test_what_lets_go_only_on_the_way_from_place_to_place(turn: str, passes: bool) -> None:
    """With the lump level, a quarter turn on: T = m (I g + M g b (b − R))/(I + m R² + M b²): M b (R − b) = I at 320 kg."""
    text = LUMP % turn
    (answer,) = rotsolve.solve(text, confirm=False).answers.values()
    for mass, slack in (("300 kg", False), ("330 kg", passes)):
        numbers = {"I": "20 kg m^2", "R": "0.5 m", "b": "0.25 m", "m": "1 kg", "M": mass}
        solution = rotsolve.solve(text, settings=numbers, confirm=False)
        assert any(check.holds is False for check in solution.derivation.checks) is slack
        known = solution.problem.values
        cases = [answer.answer, *answer.answer.otherwise]
        fitting = [case for case in cases if all(holds(one, known) for one in case.conditions)]
        assert bool(fitting) is not slack
