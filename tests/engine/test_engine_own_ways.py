"""What rubs on bodies that no string ties to one motion sticks or slips each for itself: against plain arithmetic, in letters too."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from functools import cache

import pytest

import rotsolve
from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of

G = 9.8
Numbers = Mapping[str, float]


def sliding(push: float, most: float, mass: float) -> float:
    """The acceleration of what a force sets going against a friction that is at most so large."""
    return 0.0 if abs(push) <= most else (push - most if push > 0 else push + most) / mass


SPRING = """
title: Two rough blocks with a stretched spring between
given: {M: kg, n: kg, mu: number, nu: number, k: N/m, d: m}
surfaces: {table: level}
bodies: {one: {mass: M, moves: WAY}, two: {mass: n, moves: WAY}}
connections:
  b1: {contact: [one, table], friction: mu}
  b2: {contact: [two, table], friction: nu}
  coil: {spring: [one, two], stiffness: k}
states: {start: {coil.elongation: d, at rest: all}}
find: {b: one.acceleration at start, c: two.acceleration at start}
"""
PULLED = """
title: A cord round a pulled pulley, an end on each of two rough blocks
given: {M: kg, n: kg, mu: number, nu: number, F: N}
surfaces: {table: level}
bodies: {one: {mass: M, moves: WAY}, two: {mass: n, moves: WAY}, roll: {mass: 0, moves: WAY}}
connections:
  b1: {contact: [one, table], friction: mu}
  b2: {contact: [two, table], friction: nu}
  cord: {string: [one, roll, two], pulls: {one: WAY, two: WAY}}
actions: {pull: {force: F, on: roll, direction: WAY}}
states: {start: at rest}
find: {a: roll.acceleration at start, b: one.acceleration at start, c: two.acceleration at start}
"""
DRUM = """
title: A cord from a stiff drum round a pulled pulley to a rough block
given: {I: kg m^2, R: m, n: kg, nu: number, Q: N m, F: N}
surfaces: {table: level}
bodies: {drum: {inertia: I, radius: R, turns: clockwise}, two: {mass: n, moves: right}, roll: {mass: 0, moves: right}}
connections:
  axle: {axle: drum, friction_torque: Q}
  b2: {contact: [two, table], friction: nu}
  cord: {string: [drum, roll, two], pulls: {two: right}}
actions: {pull: {force: F, on: roll, direction: right}}
states: {start: at rest}
find: {b: drum.angular_acceleration at start, c: two.acceleration at start}
"""


def by_spring(x: Numbers) -> dict[str, float]:
    force = x["k"] * x["d"]
    own = {"b": sliding(force, x["mu"] * x["M"] * G, x["M"]), "c": sliding(-force, x["nu"] * x["n"] * G, x["n"])}
    return own


def by_cord(x: Numbers) -> dict[str, float]:
    half = x["F"] / 2
    b, c = sliding(half, x["mu"] * x["M"] * G, x["M"]), sliding(half, x["nu"] * x["n"] * G, x["n"])
    return {"a": (b + c) / 2, "b": b, "c": c}


def by_drum(x: Numbers) -> dict[str, float]:
    turn = sliding(x["F"] * x["R"] / 2, x["Q"], x["I"])
    return {"b": turn, "c": sliding(x["F"] / 2, x["nu"] * x["n"] * G, x["n"])}


def mirrored(b: Callable[[Numbers], dict[str, float]]) -> Callable[[Numbers], dict[str, float]]:
    """With `moves: left` the first body stands on the left all the same: the spring pulls it against its positive sense."""
    return lambda x: {name: -value for name, value in b(x).items()}


SCENES = {
    "a spring": (SPRING.replace("WAY", "right"), by_spring),
    "a spring, to the left": (SPRING.replace("WAY", "left"), mirrored(by_spring)),
    "a pulled pulley": (PULLED.replace("WAY", "right"), by_cord),
    "a pulled pulley, to the left": (PULLED.replace("WAY", "left"), by_cord),
    "a stiff drum": (DRUM, by_drum),
}
SETS = 40


@pytest.mark.parametrize("name", SCENES)
def test_each_sticks_or_slips_for_itself(name: str) -> None:
    text, plain = SCENES[name]
    answers = {key: view.answer for key, view in rotsolve.solve(text, confirm=False).answers.items()}
    given = [part.split(":")[0].strip() for part in text.split("given: {")[1].split("}")[0].split(",")]
    rng, moving = random.Random(name), set()
    for _ in range(SETS):
        numbers = {letter: round(rng.uniform(0.05, 2.0), 3) for letter in given}
        numbers |= {letter: round(rng.uniform(1, 40), 2) for letter in given if letter in ("F", "k")}
        true = plain(numbers)
        moving.add(tuple(value != 0 for value in true.values()))
        for key, value in true.items():
            case = holding(answers[key], {**numbers, "g": G})
            form = None if case is None else case.closed or case.formula
            assert form is not None, f"{key} has no case at {numbers}"
            assert value_of(form, {**numbers, "g": G}) == pytest.approx(value)
    assert len(moving) >= 3  # it has seen what slips alone


@pytest.mark.parametrize(("mu", "nu"), [(0.1, 0.5), (0.5, 0.1), (0.1, 0.1), (0.6, 0.6)])
def test_of_two_blocks_on_a_movable_pulley_one_may_hold(mu: float, nu: float) -> None:
    """T − μ M g = M b, T − ν n g = n c, m g − 2 T = m (b + c)/2, with b = 0 or c = 0 where the cord pulls too weakly there."""
    M, n, m = 1.0, 2.0, 1.0
    found = rotsolve.solve(f"""
title: Two blocks on tables and a load on a movable pulley between them
given: {{M: {M} kg, n: {n} kg, m: {m} kg, mu: {mu}, nu: {nu}}}
surfaces: {{table: level}}
bodies:
  left_: {{mass: M, moves: right}}
  right_: {{mass: n, moves: left}}
  p1: {{mass: 0}}
  p2: {{mass: 0}}
  roll: {{mass: 0, moves: down}}
  load: {{mass: m, moves: down}}
connections:
  b1: {{contact: [left_, table], friction: mu}}
  b2: {{contact: [right_, table], friction: nu}}
  a1: {{axle: p1}}
  a2: {{axle: p2}}
  cord: {{string: [left_, p1, roll, p2, right_], under: [roll]}}
  hook: {{string: [roll.center, load]}}
states: {{start: at rest}}
find: {{b: left_.acceleration at start, c: right_.acceleration at start}}
""").answers
    ways = []
    for slips in ((1, 1), (1, 0), (0, 1), (0, 0)):
        free = sum(on / mass for on, mass in zip(slips, (M, n), strict=True))
        drag = (mu * slips[0] + nu * slips[1]) * G  # b + c = T free − drag
        pull = (m * G + m * drag / 2) / (2 + m * free / 2)
        b, c = slips[0] * (pull / M - mu * G), slips[1] * (pull / n - nu * G)
        holds = (slips[0] or pull <= mu * M * G) and (slips[1] or pull <= nu * n * G)
        ways += [(b, c)] if holds and b >= 0 and c >= 0 else []
    assert ways
    assert (found["b"].float, found["c"].float) == pytest.approx(ways[0])


RIMS = """
title: Two pressed wheels, both on stiff axles, and a motor
given: {Q: MOTOR N m, I: 1 kg m^2, J: 2 kg m^2, R: 1 m, r: 0.5 m, P: 10 N, mu: MU, tau: 2 N m, q: OTHER N m}
bodies: {one: {inertia: I, radius: R, turns: clockwise}, two: {inertia: J, radius: r, turns: clockwise}}
connections:
  ax: {axle: one, friction_torque: tau}
  bx: {axle: two, friction_torque: q}
  touch: {contact: [one, two], friction: mu, press: P}
actions: {motor: {couple: Q, on: one}}
states: {start: at rest}
find: {b: one.angular_acceleration at start, c: two.angular_acceleration at start}
"""


@pytest.mark.parametrize(
    ("motor", "mu", "other", "first", "second"),
    [
        (1, 0.3, 1, 0, 0),  # its own axle holds it
        (30, 0.3, 1, 30 - 2 - 3, (1 - 0.3 * 10 * 0.5) / 2),  # the rims slip
        (4.5, 0.3, 2, 0, 0),  # both axles together hold them: 4.5 < 2 + 2·1/0.5, and the rims give 3 > 2.5
        (5.5, 0.3, 2, 0.5, 0),  # the rims slip, too weak for the other axle
        (8, 0.9, 1, (8 - 2 - 1 / 0.5) / (1 + 2 / 0.25), -(8 - 2 - 1 / 0.5) / (1 + 2 / 0.25) / 0.5),  # they roll
    ],
)
def test_two_wheels_that_rub_each_other_and_their_axles(
    motor: float, mu: float, other: float, first: float, second: float
) -> None:
    text = RIMS.replace("MOTOR", str(motor)).replace("MU", str(mu)).replace("OTHER", str(other))
    found = rotsolve.solve(text).answers
    assert (found["b"].float, found["c"].float) == pytest.approx((first, second))


ALL_AT_REST = {
    "two blocks thrown apart": """
surfaces: {floor: level}
bodies: {a: {mass: m, moves: left}, b: {mass: M, moves: right}}
connections: {c1: {contact: [a, floor], friction: mu}, c2: {contact: [b, floor], friction: nu}}
states: {start: {a.velocity: u, b.velocity: v}, end: {at rest: all}}
find: {x: a.displacement from start to end, y: b.displacement from start to end, t: time from start to end}
""",
    "two wheels on stiff axles": """
plane: horizontal
bodies: {a: {inertia: m}, b: {inertia: M}}
connections: {c1: {axle: a, friction_torque: mu}, c2: {axle: b, friction_torque: nu}}
states: {start: {a.angular_velocity: u, b.angular_velocity: v}, end: {at rest: all}}
find: {x: a.rotation from start to end, y: b.rotation from start to end, t: time from start to end}
""",
}


@cache
def all_at_rest(name: str) -> Mapping[str, rotsolve.AnswerView]:
    turning = ["kg m^2", "kg m^2", "rad/s", "rad/s", "N m", "N m"]
    units = turning if "wheels" in name else ["kg", "kg", "m/s", "m/s", "number", "number"]
    givens = ", ".join(
        f"{letter}: {unit}" for letter, unit in zip(("m", "M", "u", "v", "mu", "nu"), units, strict=True)
    )
    return rotsolve.solve(f"title: t\ngiven: {{{givens}}}{ALL_AT_REST[name]}", confirm=False).answers


@pytest.mark.parametrize("numbers", [(1.0, 3.0), (3.0, 1.0), (2.0, 2.5)])
@pytest.mark.parametrize("name", ALL_AT_REST)
def test_all_rest_when_the_last_does(name: str, numbers: tuple[float, float]) -> None:
    """x = u²/(2 a), y = v²/(2 b), t the later of u/a and v/b, whichever is named first."""
    answers = all_at_rest(name)
    u, v = numbers
    known = {"m": 1.3, "M": 0.7, "u": u, "v": v, "mu": 0.4, "nu": 0.3, "g": G}
    a, b = (0.4 / 1.3, 0.3 / 0.7) if "wheels" in name else (0.4 * G, 0.3 * G)
    for key, true in {"x": u**2 / (2 * a), "y": v**2 / (2 * b), "t": max(u / a, v / b)}.items():
        case = holding(answers[key].answer, known)
        assert case is not None
        assert value_of(case.closed or case.formula, known) == pytest.approx(true)


@pytest.mark.parametrize("guide", ["", ", moves: up"])
def test_a_wheel_that_hangs_in_a_string_goes_up_and_down_without_a_word(guide: str) -> None:
    """Ceiling, under a disc M, over a light pulley to a weight m: a = 2 g (2 m − M)/(8 m + 3 M) up."""
    M, m = 2.0, 3.0
    found = rotsolve.solve(f"""
title: A movable pulley
given: {{M: {M} kg, m: {m} kg, R: 10 cm}}
bodies: {{low: {{shape: disc, mass: M, radius: R{guide}}}, top: {{mass: 0}}, small: {{mass: m, moves: down}}}}
connections: {{axle: {{axle: top}}, cord: {{string: [ceiling, low, top, small], under: low}}}}
states: {{start: at rest}}
find: {{a: low.acceleration at start, b: small.acceleration at start}}
""").answers
    rise = 2 * G * (2 * m - M) / (8 * m + 3 * M)
    assert (found["a"].float, found["b"].float) == pytest.approx((rise, 2 * rise))


def test_nothing_acts_on_a_place_of_the_scene() -> None:
    with pytest.raises(rotsolve.SceneError, match="nothing acts on a place of the scene"):
        rotsolve.solve(
            SPRING.replace("WAY", "right").replace("states:", "actions: {f: {force: 1 N, on: [0, 0]}}\nstates:")
        )


@pytest.mark.parametrize(
    "held",
    [
        ("left: {contact: [bar.at(c), floor]}", "right: {contact: [bar.at(d), floor]}", "left.normal_force"),
        ("left: {string: [ceiling, bar.at(c)]}", "right: {string: [ceiling, bar.at(d)]}", "left.tension"),
        ("left: {contact: [bar.at(c), floor]}", "right: {string: [ceiling, bar.at(d)]}", "left.normal_force"),
    ],
)
def test_a_bar_on_two_supports_in_either_order(held: tuple[str, str, str]) -> None:
    """A (d − c) = M g (d − L/2) + m g (d − x), where that and the other one are positive: with c < d or c > d."""
    first, second, force = held
    answer = (
        rotsolve.solve(
            f"""
title: A level bar with a load
given: {{M: kg, L: m, c: m, d: m, m: kg, x: m}}
surfaces: {{floor: level}}
bodies: {{bar: {{shape: rod, mass: M, length: L}}}}
connections:
  {first}
  {second}
actions: {{load: {{force: m*g, on: bar.at(x), direction: down}}}}
states: {{now: {{bar.angle: 0, balance: true}}}}
find: {{A: {force}}}
""",
            confirm=False,
        )
        .answers["A"]
        .answer
    )
    rng, orders = random.Random(force + second), set()
    for _ in range(60):
        known = {"M": 10.0, "m": 1.0, "L": 1.0, "g": G} | {name: round(rng.uniform(0.02, 0.98), 3) for name in "cdx"}
        c, d, x = (known[name] for name in "cdx")
        load = 10 * 0.5 + 1 * x  # the moment of both about the start, in units of g
        one, two = (11 * d - load) / (d - c) * G, (11 * c - load) / (c - d) * G
        case = holding(answer, known)
        assert (case is not None) == (one > 0 and two > 0)
        if case is not None:
            orders.add(c < d)
            assert value_of(case.closed or case.formula, known) == pytest.approx(one)
    assert orders == {True, False}


SHARED_SHAFT = """
title: A driven wheel and a braked one on a stiff axle, with a clutch between
given: {I: kg m^2, J: kg m^2, R: m, C: N m, tau: N m, kap: N m, P: N, mu: number}
bodies: {one: {inertia: I}, two: {inertia: J, radius: R}}
connections:
  p: {axle: [one, two], friction_torque: tau}
  k: {clutch: [one, two], friction_torque: kap}
actions: {shoe: {press: P, friction: mu, on: two.rim}, twist: {couple: C, on: one}}
states: {start: at rest}
find: {al: one.angular_acceleration at start, be: two.angular_acceleration at start}
"""


def least(x: Numbers) -> tuple[float, float]:
    """The accelerations at which ½ I α² + ½ J β² − C α + τ |α| + (τ + μ P R) |β| + κ |α − β| is least, of all that can be (Gauss's
    principle with friction)."""
    drag = x["tau"] + x["mu"] * x["P"] * x["R"]

    def constraint(a: float, b: float) -> float:
        kinetic = x["I"] * a * a / 2 + x["J"] * b * b / 2 - x["C"] * a
        return kinetic + x["tau"] * abs(a) + drag * abs(b) + x["kap"] * abs(a - b)

    ways = [(0.0, 0.0)]
    ways += [((x["C"] - (x["tau"] + drag) * way) / (x["I"] + x["J"]),) * 2 for way in (1, -1)]
    for one in (1, 0, -1):
        for two in (1, 0, -1):
            for slip in (1, -1):
                a = (x["C"] - x["tau"] * one - x["kap"] * slip) / x["I"] if one else 0.0
                b = (x["kap"] * slip - drag * two) / x["J"] if two else 0.0
                ways.append((a, b))
    return min(ways, key=lambda way: constraint(*way))


@pytest.mark.exhaustive
def test_axle_and_brake_of_one_wheel_are_overcome_together() -> None:
    """Each alone would be held by the other; not all of the many cases are worked out."""
    answers = {key: view.answer for key, view in rotsolve.solve(SHARED_SHAFT, confirm=False).answers.items()}
    rng, seen = random.Random(7), set()
    for _ in range(400):
        numbers = {name: rng.uniform(0.1, 3) for name in ("I", "J", "R", "C", "tau", "kap", "P", "mu")}
        numbers |= {"C": 3 * numbers["C"], "g": G}
        for key, value in zip(("al", "be"), least(numbers), strict=True):
            case = holding(answers[key], numbers)
            if case is not None:
                form = case.closed or case.formula
                assert form is not None and value_of(form, numbers) == pytest.approx(value, abs=1e-9)
                seen.add(form)
    assert len(seen) >= 3


LIFTED = """
title: A flywheel lifts a load by a clutch and a gear, whose drum rubs on its axle, until the clutch sticks
given: {I: kg m^2, m: kg, r: m, w: rad/s, tau: N m, C: N m}
bodies: {fly: {inertia: I}, plate: {inertia: 2*I, radius: 2*r}, drum: {inertia: I, radius: r}, load: {mass: m, moves: up}}
connections:
  shaft: {axle: [fly, plate]}
  post: {axle: drum, friction_torque: C}
  k: {clutch: [fly, plate], friction_torque: tau}
  mesh: {gear: [plate, drum]}
  rope: {string: [load, drum]}
states: {start: {fly.angular_velocity: w, at rest: [plate, drum, load]}, one: {k: sticks}}
find: {h: load.displacement from start to one, T: rope.tension at one}
"""


@pytest.mark.exhaustive
def test_of_a_product_that_vanishes_neither_factor_is_taken_to() -> None:
    """½ t (r ω + v) = 0 tells no time, since the rope says r ω + v = 0: friction goes on against the turn as the load rises.

    From then on 7 I + 4 m r² goes with (m g r + C) / r: T = m (7 I g − 4 C r)/(7 I + 4 m r²).
    """
    answers = rotsolve.solve(LIFTED, confirm=False).answers
    rng = random.Random(5)
    for _ in range(30):
        x = {name: rng.uniform(0.2, 1) for name in ("I", "m", "r", "w", "C")} | {"g": G}
        x["tau"] = 2 * (x["C"] + x["m"] * G * x["r"]) * rng.uniform(1.1, 3)
        tension = x["m"] * (7 * x["I"] * G - 4 * x["C"] * x["r"]) / (7 * x["I"] + 4 * x["m"] * x["r"] ** 2)
        rise = x["r"] * (x["tau"] - 2 * x["C"] - 2 * x["m"] * G * x["r"]) / (3 * x["I"] + 2 * x["m"] * x["r"] ** 2)
        slowing = x["tau"] / x["I"] + rise / (2 * x["r"])  # of the flywheel against the plate
        height = rise * (x["w"] / slowing) ** 2 / 2
        for name, value in (("T", tension), ("h", height)):
            case = holding(answers[name].answer, x)
            if tension > 0:
                form = None if case is None else case.closed or case.formula
                assert form is not None and value_of(form, x) == pytest.approx(value)
