"""What rubs, whichever way it turns: brakes, clutches and rims against plain arithmetic; own data under outside torques."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.notation.parse import parse
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

FIRST, SECOND, TAU = 2.0, 3.0, 6.0
SENSES = ("counterclockwise", "clockwise")


def values(text: str) -> dict[str, float]:
    found = {name: answer.float for name, answer in solve(text).answers.items()}
    return {name: number for name, number in found.items() if number is not None}


@pytest.mark.parametrize("sense", SENSES)
@pytest.mark.parametrize(("w", "u"), [(10.0, 4.0), (4.0, 10.0), (-6.0, 5.0), (-2.0, -9.0), (3.0, 0.0)])
def test_a_clutch_brings_both_to_the_mean_weighted_by_inertia(w: float, u: float, sense: str) -> None:
    sign = 1 if sense == "counterclockwise" else -1
    found = values(f"""
title: Clutch
plane: horizontal
given: {{I: {FIRST} kg m^2, J: {SECOND} kg m^2, tau: {TAU} N m}}
bodies: {{one: {{inertia: I}}, two: {{inertia: J, turns: {sense}}}}}
connections: {{axle: {{axle: [one, two]}}, grip: {{clutch: [one, two], friction_torque: tau}}}}
states: {{start: {{one.angular_velocity: {w} rad/s, two.angular_velocity: {sign * u} rad/s}}, end: {{grip: sticks}}}}
find: {{t: time from start to end, v: two.angular_velocity at end, Q: lost kinetic_energy from start to end}}
""")
    together = (FIRST * w + SECOND * u) / (FIRST + SECOND)
    assert found["t"] == pytest.approx(FIRST * SECOND / (FIRST + SECOND) * abs(w - u) / TAU)
    assert found["v"] == pytest.approx(sign * together)
    assert found["Q"] == pytest.approx(FIRST * SECOND / (FIRST + SECOND) * (w - u) ** 2 / 2)


@pytest.mark.parametrize("sense", SENSES)
@pytest.mark.parametrize(("w", "u"), [(10.0, 4.0), (4.0, -20.0), (-6.0, 5.0), (3.0, 0.0), (0.0, -8.0)])
def test_rims_slip_until_they_run_equally_fast(w: float, u: float, sense: str) -> None:
    sign = 1 if sense == "counterclockwise" else -1
    found = values(f"""
title: Two wheels
plane: horizontal
given: {{I: {FIRST} kg m^2, J: {SECOND} kg m^2, R: 0.5 m, r: 0.2 m, F: 10 N, mu: 0.3}}
bodies: {{one: {{inertia: I, radius: R, turns: {sense}}}, two: {{inertia: J, radius: r}}}}
connections: {{left: {{axle: one}}, right: {{axle: two}}, touch: {{contact: [one, two], friction: mu, press: F}}}}
states: {{start: {{one.angular_velocity: {sign * w} rad/s, two.angular_velocity: {u} rad/s}}, end: {{touch: rolls}}}}
find: {{t: time from start to end, w1: one.angular_velocity at end, w2: two.angular_velocity at end}}
""")
    slip = 0.5 * w + 0.2 * u
    blow = slip / (0.5**2 / FIRST + 0.2**2 / SECOND)  # the impulse of friction at the rims
    assert found["t"] == pytest.approx(abs(blow) / 3)
    assert found["w1"] == pytest.approx(sign * (w - 0.5 * blow / FIRST))
    assert found["w2"] == pytest.approx(u - 0.2 * blow / SECOND)


@pytest.mark.parametrize("sense", SENSES)
@pytest.mark.parametrize("w", [9.0, -9.0])
def test_a_brake_block_acts_against_the_turn_whichever_way(w: float, sense: str) -> None:
    found = values(f"""
title: Brake
plane: horizontal
given: {{I: {FIRST} kg m^2, R: 0.5 m, F: 10 N, mu: 0.3}}
bodies: {{wheel: {{inertia: I, radius: R, turns: {sense}}}}}
connections: {{axle: {{axle: wheel}}}}
actions: {{block: {{press: F, on: wheel.rim, friction: mu}}}}
states: {{start: {{wheel.angular_velocity: {w} rad/s}}, end: at rest}}
find: {{t: time from start to end, n: wheel.rotation from start to end, W: block.work from start to end}}
""")
    assert found["t"] == pytest.approx(9 * FIRST / 1.5)
    assert found["n"] == pytest.approx(w * 9 * FIRST / 3)
    assert found["W"] == pytest.approx(-FIRST * 81 / 2)


@pytest.mark.parametrize("press", [30.0, 60.0])
def test_a_brake_block_holds_against_a_motor_if_it_is_strong_enough(press: float) -> None:
    found = values(f"""
title: Brake and motor
plane: horizontal
given: {{I: {FIRST} kg m^2, R: 0.5 m, F: {press} N, mu: 0.3, M: 6 N m}}
bodies: {{wheel: {{inertia: I, radius: R}}}}
connections: {{axle: {{axle: wheel}}}}
actions: {{block: {{press: F, on: wheel.rim, friction: mu}}, motor: {{couple: M, on: wheel, direction: clockwise}}}}
states: {{start: at rest, end: {{time: 2 s}}}}
find: {{w: wheel.angular_velocity at end, f: block.friction_force at start}}
""")
    excess = max(0.0, 6 - 0.3 * press * 0.5)
    assert found["w"] == pytest.approx(-excess)
    assert abs(found["f"]) == pytest.approx(min(0.3 * press, 12))


def test_a_slip_that_an_earlier_phase_leaves_goes_on() -> None:
    found = values(f"""
title: Clutch watched half way
plane: horizontal
given: {{I: {FIRST} kg m^2, J: {SECOND} kg m^2, tau: {TAU} N m}}
bodies: {{one: {{inertia: I}}, two: {{inertia: J}}}}
connections: {{axle: {{axle: [one, two]}}, grip: {{clutch: [one, two], friction_torque: tau}}}}
states:
  start: {{one.angular_velocity: 0, two.angular_velocity: 10 rad/s}}
  half:  {{time: 1 s}}
  end:   {{grip: sticks}}
find: {{u: two.angular_velocity at half, v: one.angular_velocity at end, t: time from half to end}}
""")
    assert found["u"] == pytest.approx(8)
    assert found["v"] == pytest.approx(6)
    assert found["t"] == pytest.approx(1)


def test_without_numbers_letters_stand_for_positive_sizes() -> None:
    solution = solve("""
title: Clutch in letters
plane: horizontal
given: {I: kg m^2, J: kg m^2, w: rad/s, tau: N m}
bodies: {one: {inertia: I}, two: {inertia: J}}
connections: {axle: {axle: [one, two]}, grip: {clutch: [one, two], friction_torque: tau}}
states: {start: {one.angular_velocity: w, two.angular_velocity: 0}, end: {grip: sticks}}
find: {t: time from start to end}
""")
    formula = solution.answers["t"].formula
    assert formula is not None
    assert equal(formula, parse("I*J*w/(tau*(I + J))", formula.symbols()), formula.symbols())


def test_own_data_change_under_a_constant_friction_torque() -> None:
    """Angular impulse of the axle: I₂ ω₂ = I₁ ω₁ − τ t; the rest of the energy comes from the inner forces."""
    found = values("""
title: Skater on a rubbing axle
plane: horizontal
given: {I: 4 kg m^2, J: 1.5 kg m^2, w: 5 rad/s, tau: 0.8 N m}
bodies: {skater: {inertia: I}}
connections: {axle: {axle: skater, friction_torque: tau}}
states: {wide: {skater.angular_velocity: w}, narrow: {skater.inertia: J, time: 2 s}}
find: {u: skater.angular_velocity at narrow}
""")
    assert found["u"] == pytest.approx((4 * 5 - 0.8 * 2) / 1.5)


def test_sand_that_falls_on_a_turning_disc() -> None:
    found = values("""
title: Sand
plane: horizontal
given: {M: 6 kg, R: 0.5 m, r: 0.4 m, m: 1 kg, w: 5 rad/s}
bodies: {disc: {shape: disc, mass: M, radius: R}, sand: {mass: 0, radius: r, count: 3}}
connections: {axle: {axle: disc}, heap: {rides: [sand, disc]}}
states: {empty: {disc.angular_velocity: w}, full: {sand.mass: m}}
find: {u: disc.angular_velocity at full, q: sand.radius at full}
""")
    own = 6 * 0.25 / 2
    assert found["u"] == pytest.approx(own * 5 / (own + 3 * 0.16))
    assert found["q"] == pytest.approx(0.4)


@pytest.mark.parametrize("bodies", ["one: {inertia: I}, two: {inertia: J}", "two: {inertia: J}, one: {inertia: I}"])
@pytest.mark.parametrize(("pair", "sign"), [("[one, two]", 1), ("[two, one]", -1)])
def test_the_torque_of_a_clutch_is_that_on_the_body_that_it_names_last(bodies: str, pair: str, sign: int) -> None:
    found = values(f"""
title: A motor takes a disc along by a clutch that sticks
plane: horizontal
given: {{I: {FIRST} kg m^2, J: {SECOND} kg m^2, tau: {TAU} N m, T: 5 N m}}
bodies: {{{bodies}}}
connections: {{axle: {{axle: {pair}}}, grip: {{clutch: {pair}, friction_torque: tau}}}}
actions: {{motor: {{couple: T, on: one}}}}
states: {{start: at rest}}
find: {{x: grip.torque}}
""")
    assert found["x"] == pytest.approx(sign * 5 * SECOND / (FIRST + SECOND))


def test_three_wheels_in_one_contact_are_refused_by_name() -> None:
    with pytest.raises(Unsolvable, match="two wheels rub on each other in a contact, and `touch` names 3 bodies"):
        solve("""
title: Three wheels
bodies: {a: {radius: 1 m, mass: 1 kg}, b: {radius: 1 m, mass: 1 kg}, c: {radius: 1 m, mass: 1 kg}}
connections: {one: {axle: a}, two: {axle: b}, three: {axle: c}, touch: {contact: [a, b, c]}}
find: {x: a.angular_acceleration}
""")


GROWING = """
given: {R: 25 cm, mu: 0.4, c: 8 N/s, I: 0.2 kg m^2, w: 12 rad/s}
bodies: {wheel: {inertia: I, radius: R}}
connections: {pin: {axle: wheel}}
actions: {shoe: {press: c*time, on: wheel, friction: mu}}
states: {start: {wheel.angular_velocity: w}, later: {time: LATER}}
find: {v: wheel.angular_velocity at later, s: wheel.rotation from start to later}
"""
IN_OIL = """
given: {I: 0.2 kg m^2, w: 12 rad/s, k: 0.05 N m s, tau: 0.3 N m}
bodies: {wheel: {inertia: I}}
connections: {pin: {axle: wheel, friction_torque: tau}}
actions: {oil: {couple: -k*wheel.angular_velocity, on: wheel}}
states: {start: {wheel.angular_velocity: w}, later: {time: LATER}}
find: {v: wheel.angular_velocity at later, s: wheel.rotation from start to later}
"""
IN_AIR = """
given: {m: 2 kg, u: 12 m/s, k: 0.05 kg/s, mu: 0.3}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}}
actions: {air: {force: -k*block.velocity, on: block, direction: right}}
states: {start: {block.velocity: u}, later: {time: LATER}}
find: {v: block.velocity at later, s: block.displacement from start to later}
"""


def stepped(rate: Callable[[float, float], float], speed: float, until: float) -> tuple[float, float]:
    """Speed and way by midpoint steps of dv/dt = rate(t, v), at rest from where it stops."""
    step, way, time = 1e-4, 0.0, 0.0
    while speed > 0 and time < until:
        middle = speed + rate(time, speed) * step / 2
        way, speed, time = way + middle * step, speed + rate(time + step / 2, middle) * step, time + step
    return max(speed, 0.0), way


@pytest.mark.parametrize("until", [0.6, 30.0])
@pytest.mark.parametrize(
    ("text", "rate", "first"),
    [
        (GROWING, lambda t, v: -0.4 * 8 * t * 0.25 / 0.2, 12.0),
        (IN_OIL, lambda t, v: -(0.3 + 0.05 * v) / 0.2, 12.0),
        (IN_AIR, lambda t, v: -0.3 * 9.8 - 0.05 * v / 2, 12.0),
    ],
)
def test_what_does_not_slow_down_steadily_stops_too(
    text: str, rate: Callable[[float, float], float], first: float, until: float
) -> None:
    """Friction never drives back what it has stopped, whether it grows with time or drag helps it."""
    found = values(text.replace("LATER", f"{until} s"))
    assert (found["v"], found["s"]) == pytest.approx(stepped(rate, first, until), rel=2e-4, abs=1e-9)


def test_letters_tell_both_whether_it_stops_and_whether_it_goes_on() -> None:
    answer = solve(GROWING.replace("8 N/s", "N/s").replace("LATER", "3 s")).answers["v"]
    assert {case.exact for case in (answer, *answer.otherwise)} == {"0", "w − μ c R t_later²/(2 I)"}
    assert all(case.conditions for case in (answer, *answer.otherwise))


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize(("way", "size"), [("wheel.turns: n", math.sqrt(4 * math.pi * 4 * 3 / 2)), ("time: 3 s", 4.5)])
def test_the_speed_with_which_a_wheel_is_set_going_against_its_friction(turns: str, way: str, size: float) -> None:
    """½ I ω² = τ 2π n, or I ω = τ t: no wheel that is set going is held by its axle."""
    found = solve(f"""title: With what speed it runs so far
gravity: none
given: {{I: 2 kg m^2, tau: 3 N m, n: 4, w: unknown}}
bodies: {{wheel: {{inertia: I, turns: {turns}}}}}
connections: {{axle: {{axle: wheel, friction_torque: tau}}}}
states: {{hit: {{wheel.angular_velocity: w}}, stop: {{wheel.angular_velocity: 0, {way}}}}}
find: {{w: w}}
""")
    assert found.answers["w"].float == pytest.approx(size)
