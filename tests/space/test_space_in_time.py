"""Motions in space in closed form: ω, axes and momenta at a time, against power series of Euler's equations and of Ṙ = R ω× in 50 digits.

The series are made in `carried_on`, from the moments and the start alone. Every answer is held against the assembly too, where it does
not take too long.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import permutations

import mpmath
import pytest

from carried_on import agree, carried
from rotsolve import Unsolvable, solve
from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb


def scene(
    moments: Sequence[str], start: Sequence[str], find: str, later: str = "later: {time: T}", time: str = "1"
) -> str:
    letters = ", ".join(f"I{k}: {value} kg m^2" for k, value in enumerate(moments, 1))
    rates = ", ".join(f"{value} rad/s" for value in start)
    states = ", ".join(filter(None, (f'start: {{"b.angular_velocity": [{rates}], b.velocity: [0, 0, 0]}}', later)))
    return (
        f"title: T\nup: z\ngravity: none\ngiven: {{{letters}, T: {time} s, m: 1 kg, r: 2 m}}\n"
        "bodies: {b: {mass: m, inertia: {principal: [I1, I2, I3]}, points: {P: [r, 0, r]}}}\n"
        f"states: {{{states}}}\nfind: {{{find}}}\n"
    )


def components(text: str, name: str = "w", digits: int = 25, **options: object) -> list[arb]:
    derivation = solve(text, **options).derivation
    answer = next(item for item in derivation.answers if item.name == name)
    assert [item.name for item in derivation.confirmed if item.holds] == [name] or not options.get("confirm", True)
    return [part.value.refine(digits) for part in answer.components]


CASES = {  # moments, ω at first, time
    "round the axis of the largest moment": (("1", "2", "3"), ("0.3", "0.4", "2"), "3"),
    "round the axis of the smallest moment": (("1", "2", "3"), ("2", "0.5", "-0.3"), "3"),
    "negative rates": (("1", "2", "3"), ("-0.3", "-0.4", "-2"), "2.5"),
    "at a turning point": (("1.5", "2", "3"), ("0.7", "0", "2"), "4"),
    "at the other turning point": (("1", "2", "2.5"), ("0", "0.9", "2"), "4"),
    "at the other turning point, backwards": (("1", "2", "2.5"), ("0", "-0.9", "2"), "4"),
    "near the middle axis": (("1", "2", "3"), ("1e-10", "1.5", "0"), "8"),
    "1e-12 from between both cases": (("1", "2", "3"), ("1.7320508075689", "0.2", "1"), "5"),
    "nearly symmetric": (("2", "2.0000000001", "3"), ("1", "0.5", "2"), "3"),
    "a lamina": (("1", "2", "3"), ("0.2", "1", "0.1"), "6"),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", CASES)
def test_an_asymmetric_body_turns_by_elliptic_functions(name: str) -> None:
    moments, start, time = CASES[name]
    found = components(scene(moments, start, "w: b.angular_velocity at later in body axes", time=time))
    agree(found, carried(moments, start, time)[0])


@pytest.mark.parametrize("order", list(permutations(range(3))))
def test_the_order_of_its_axes_changes_nothing(order: tuple[int, int, int]) -> None:
    moments, start = ("1", "2.2", "3"), ("0.5", "-0.7", "1.1")
    turned = [[values[k] for k in order] for values in (moments, start)]
    found = components(scene(*turned, "w: b.angular_velocity at later in body axes", time="2"), confirm=False)
    agree(found, carried(*turned, "2")[0])


@pytest.mark.parametrize("signs", [(1, 1, 1), (-1, -1, 1), (1, -1, -1), (-1, 1, -1)])
def test_turned_by_half_turns_it_is_the_same(signs: tuple[int, int, int]) -> None:
    start = ("0.5", "0.7", "1.1")
    turned = [f"{'-' if sign < 0 else ''}{value}" for sign, value in zip(signs, start, strict=True)]
    find = "w: b.angular_velocity at later in body axes"
    whole, found = (
        components(scene(("1", "2.2", "3"), rates, find, time="2"), confirm=False) for rates in (start, turned)
    )
    with Precision(200):
        assert all(abs(sign * a - b) < 1e-24 for sign, a, b in zip(signs, whole, found, strict=True))


def test_after_a_thousand_seconds_it_has_as_many_digits() -> None:
    """T = 4 K(m)/p takes whole periods away; a power series from there on."""
    moments, start = ("1", "2", "3"), ("0.3", "0.4", "2")
    with mpmath.workdps(70):
        a, b, c = (mpmath.mpf(value) for value in moments)
        x, y, z = (mpmath.mpf(value) for value in start)
        below, above = c * (c - a) * z**2 + b * (b - a) * y**2, a * (c - a) * x**2 + b * (c - b) * y**2
        pace, m = mpmath.sqrt((c - b) * below / (a * b * c)), (b - a) * above / ((c - b) * below)
        period = 2 * mpmath.pi / mpmath.agm(1, mpmath.sqrt(1 - m)) / pace
        rest = mpmath.mpf(1000) - period * mpmath.floor(1000 / period)
        text = mpmath.nstr(rest, 65)
    find = "w: b.angular_velocity at later in body axes, P: b.period at start"
    answers = {
        item.name: item for item in solve(scene(moments, start, find, time="1000"), confirm=False).derivation.answers
    }
    agree([part.value.refine(25) for part in answers["w"].components], carried(moments, start, text)[0])
    agree([answers["P"].value.refine(25)], [period])


def test_between_both_cases_it_turns_by_hyperbolic_functions() -> None:
    moments, start = ("1", "2", "3"), ("sqrt(3)*(-1 rad/s)", "1 rad/s", "-1 rad/s")
    text = scene(moments, ("1", "1", "1"), "w: b.angular_velocity at later in body axes", time="2")
    text = text.replace("[1 rad/s, 1 rad/s, 1 rad/s]", f"[{', '.join(start)}]")
    with mpmath.workdps(80):
        rates = (mpmath.nstr(-mpmath.sqrt(3), 75), "1", "-1")
    derivation = solve(text).derivation
    (answer,) = derivation.answers
    assert not any("sn(" in str(part.formula) for part in answer.components)
    agree([part.value.refine(25) for part in answer.components], carried(moments, rates, "2")[0])
    with pytest.raises(Unsolvable, match="never back: it has no period"):
        solve(text.replace("w: b.angular_velocity at later in body axes", "P: b.period at start"))


SYMMETRIC = {
    "flat": (("2", "2", "3"), ("1", "-0.5", "2"), "3"),
    "long": (("2", "2", "0.5"), ("0.4", "0.3", "-3"), "2"),
    "a sphere": (("2", "2", "2"), ("1", "-0.5", "2"), "2"),
    "about its axis": (("2", "2", "3"), ("0", "0", "-2"), "2"),
    "across its axis": (("2", "2", "3"), ("0", "1.5", "0"), "2"),
    "about x": (("3", "2", "2"), ("1", "-0.5", "2"), "3"),
    "about y": (("2", "3", "2"), ("1", "-0.5", "2"), "3"),
    "about its middle axis": (("1", "2", "3"), ("0", "-1.5", "0"), "2"),
    "at rest": (("1", "2", "3"), ("0", "0", "0"), "2"),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", SYMMETRIC)
def test_a_symmetric_body_goes_round_its_angular_momentum(name: str) -> None:
    """ω in both axes, its own axes, and the velocity of a point, ω × R r."""
    moments, start, time = SYMMETRIC[name]
    find = (
        "w: b.angular_velocity at later in body axes, o: b.angular_velocity at later, x: b.x_axis at later, z: b.z_axis at later, "
        "v: b.P.velocity at later, L: b.angular_momentum at later"
    )
    solution = solve(scene(moments, start, find, time=time))
    found = {item.name: [part.value.refine(25) for part in item.components] for item in solution.derivation.answers}
    omega, rows = carried(moments, start, time)
    with mpmath.workdps(60):
        turned = lambda vector: [mpmath.fdot(row, vector) for row in rows]  # noqa: E731
        arm, rate = turned([2, 0, 2]), turned(omega)
        agree(found["w"], omega)
        agree(found["o"], rate)
        agree(found["x"], turned([1, 0, 0]))
        agree(found["z"], turned([0, 0, 1]))
        agree(
            found["v"], [rate[(i + 1) % 3] * arm[(i + 2) % 3] - rate[(i + 2) % 3] * arm[(i + 1) % 3] for i in range(3)]
        )
        agree(found["L"], [mpmath.mpf(a) * mpmath.mpf(b) for a, b in zip(moments, start, strict=True)])
    assert all(item.holds for item in solution.derivation.confirmed)


def test_shapes_turn_by_their_own_moments() -> None:
    """A box of 3 kg with sides of 0.6, 0.4 and 0.2 m has 1, 2 and 2.6 times 0.05 kg m²."""
    text = (
        "title: T\nup: z\ngravity: none\nbodies: {b: {shape: cuboid, mass: 3 kg, sides: [0.6 m, 0.4 m, 0.2 m]}}\n"
        "states: {start: {b.angular_velocity: [1 rad/s, 3 rad/s, 0.5 rad/s], b.velocity: [0, 0, 0]}, later: {time: 1 s}}\n"
        "find: {w: b.angular_velocity at later in body axes}\n"
    )
    agree(components(text), carried(("1", "2", "2.6"), ("1", "3", "0.5"), "1")[0])


def test_a_mark_on_a_wheel_goes_round_with_it() -> None:
    text = (
        "title: T\nup: z\nbodies: {w: {shape: disc, mass: 1 kg, radius: 1 m, points: {P: [1 m, 0, 0]}}}\n"
        "connections: {a: {axle: w, along: y}}\nstates: {start: {w.angular_velocity: 3 rad/s}, later: LATER}\n"
        "find: {v: w.P.velocity at later}\n"
    )
    found = [float(part) for part in components(text.replace("LATER", "{time: 2 s}"), "v")]
    assert found == pytest.approx([-3 * math.sin(6), 0, -3 * math.cos(6)])
    with pytest.raises(Unsolvable, match="how `w` stands at `later` nothing tells"):
        solve(text.replace("LATER", "{w.angular_velocity: 3 rad/s}"))


def test_functions_of_time_are_those_of_a_later_state() -> None:
    moments, start = ("1", "2", "3"), ("0.3", "0.4", "2")
    at = components(scene(moments, start, "w: b.angular_velocity at any time in body axes", later=""), at="3 s")
    later = components(scene(moments, start, "w: b.angular_velocity at later in body axes", time="3"), confirm=False)
    with Precision(200):
        assert all(abs(a - b) < 1e-24 for a, b in zip(at, later, strict=True))


def test_by_way_of_another_state_it_comes_to_the_same() -> None:
    moments, start = ("1", "2", "3"), ("0.3", "0.4", "2")
    find = "w: b.angular_velocity at later in body axes"
    whole = components(scene(moments, start, find, time="3"), confirm=False)
    parted = components(scene(moments, start, find, later="between: {time: 1 s}, later: {time: T}", time="2"))
    with Precision(200):
        assert all(abs(a - b) < 1e-24 for a, b in zip(whole, parted, strict=True))


def test_letters_take_case_by_case_what_numbers_decide() -> None:
    """No branch is taken silently: each answer has its conditions, and with numbers each is that of the case."""
    text = (
        "title: T\nup: z\ngravity: none\ngiven: {I1: 1 kg m^2, I2: 2 kg m^2, I3: 3 kg m^2, w1: rad/s, w3: rad/s, T: 1 s}\n"
        "bodies: {b: {mass: 1 kg, inertia: {principal: [I1, I2, I3]}}}\n"
        'states: {start: {"b.angular_velocity": [w1, 0, w3], b.velocity: [0, 0, 0]}, later: {time: T}}\n'
        "find: {w: b.angular_velocity at later in body axes}\n"
    )
    (answer,) = solve(text).derivation.answers
    cases = [answer, *answer.otherwise]
    assert len(cases) >= 2 and all(case.conditions for case in cases)


def test_a_free_body_falls_while_it_turns() -> None:
    text = (
        "title: T\nup: z\ngiven: {g: 10 m/s^2}\nbodies: {b: {shape: disc, mass: 2 kg, radius: 1 m}}\n"
        "states: {start: {b.angular_velocity: [1 rad/s, 0, 3 rad/s], b.velocity: [1 m/s, 0, 4 m/s]}, later: {time: 0.5 s}}\n"
        "find: {v: b.velocity at later, e: b.z_axis at later, K: b.kinetic_energy at later}\n"
    )
    answers = {item.name: item for item in solve(text).derivation.answers}
    assert [part.value.float for part in answers["v"].components] == pytest.approx([1, 0, -1])
    assert answers["K"].value.float == pytest.approx(2 / 2 * 2 + 0.5 * 1 / 2 * 1 + 9 / 2)
    agree(
        [part.value.refine(25) for part in answers["e"].components], [row[2] for row in carried("112", "103", "0.5")[1]]
    )


EULER = """title: T
up: z
given: {I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, m: 1 kg}
bodies: {top: {mass: m, inertia: {principal: [I1, I1, I3]}, axis: z}}
states:
  now: {top.tilt: 25 deg, top.precession: 3 rad/s, top.spin: 5 rad/s, top.nutation: 1 rad/s, top.velocity: [0, 0, 0]}
  later: {time: 0.1 s}
find:
  phi: top.precession_angle at later
  theta: top.tilt at later
  psi: top.spin_angle at later
  p: top.precession at later
  n: top.nutation at later
  s: top.spin at later
"""


def test_euler_angles_of_a_free_body_are_told_by_its_axis() -> None:
    """Differences of the angles are the rates, and the assembly gives the same."""
    derivation = solve(EULER).derivation
    first = {item.name: item for item in derivation.answers}
    beside = {item.name: item for item in solve(EULER.replace("0.1 s", "0.1000001 s")).derivation.answers}
    assert all(item.holds for item in derivation.confirmed)
    for angle, rate in (("phi", "p"), ("theta", "n"), ("psi", "s")):
        slope = (beside[angle].value.refine(30) - first[angle].value.refine(30)) / 1e-7
        assert float(slope) == pytest.approx(first[rate].value.float, rel=1e-5)


HINGES = {  # a scene, and what is known of it by hand
    "nothing drives it": ("", "start: {b.angular_velocity: 3 rad/s}", {"a": 6, "w": 3}),
    "from an angle": ("", "start: {b.angular_velocity: 3 rad/s, b.angle: 1 rad}", {"a": 7, "w": 3}),
    "a couple of 2 N m, I = 1/3 kg m²": (
        "actions: {c: {couple: [0, 0, 2 N m], on: b}}\n",
        "start: {b.angular_velocity: 1 rad/s}",
        {"a": 14, "w": 13},
    ),
}


@pytest.mark.parametrize("name", HINGES)
def test_about_a_fixed_axis_the_acceleration_is_constant(name: str) -> None:
    actions, start, known = HINGES[name]
    text = (
        "title: T\nup: z\nbodies: {b: {shape: rod, mass: 1 kg, length: 1 m}}\nconnections: {h: {hinge: b.start, along: z}}\n"
        f"{actions}states: {{{start}, later: {{time: 2 s}}}}\n"
        "find: {a: b.angle at later, w: b.angular_velocity.z at later, e: b.x_axis at later}\n"
    )
    derivation = solve(text).derivation
    answers = {item.name: item for item in derivation.answers}
    assert {name: answers[name].value.float for name in known} == pytest.approx(known)
    assert answers["e"].components[0].value.float == pytest.approx(float(mpmath.cos(known["a"])))
    assert all(item.holds for item in derivation.confirmed)


STEADY = """title: T
up: z
given: {M: 150 g, l: 4 cm, I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, w3: 300 rad/s, theta: 25 deg}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {now: {top.tilt: theta, top.axial_rate: w3, WHICHsteady: true}, later: {time: 0.5 s}}
find: {phi: top.precession_angle at later, psi: top.spin_angle at later, p: top.precession at now, s: top.spin at now}
"""


@pytest.mark.parametrize("which", ["smallest", "largest"])
def test_the_spin_angle_alone_goes_by_the_root_that_is_meant(which: str) -> None:
    """It was that of the other one: of two positive roots of its own equation the first was taken."""
    text = STEADY.replace("WHICH", f"top.precession: {which}, ")
    alone = text.partition("find:")[0] + "find: {psi: top.spin_angle at later}\n"
    whole = {item.name: item.value.float for item in solve(text, confirm=False).derivation.answers}
    (answer,) = solve(alone, confirm=False).derivation.answers
    assert answer.value is not None and answer.value.float == pytest.approx(whole["psi"])


@pytest.mark.parametrize("which", ["smallest", "largest"])
def test_a_steady_precession_goes_on(which: str) -> None:
    found = solve(STEADY.replace("WHICH", f"top.precession: {which}, "), confirm=False).derivation.answers
    answers = {item.name: item.value.float for item in found}
    assert (answers["phi"], answers["psi"]) == pytest.approx((answers["p"] / 2, answers["s"] / 2))


FREE = 'start: {"b.angular_velocity in body axes": [1 rad/s, 2 rad/s, 0.5 rad/s], b.velocity: [0, 0, 0]}'
BODY = "bodies: {b: {mass: 1 kg, inertia: {principal: [1 kg m^2, 2 kg m^2, 3 kg m^2]}}}\n"
SYMMETRIC_BODY = BODY.replace("1 kg m^2, 2 kg m^2, 3 kg m^2]", "2 kg m^2, 2 kg m^2, 3 kg m^2]").replace(
    "}}}", "}, axis: z}}"
)
STRUCK = BODY.replace("}}}", "}, points: {P: [1 m, 1 m, 1 m]}}}")
NODDING = (
    "bodies: {top: {mass: 0.3 kg, inertia: {about: tip, principal: [15 kg cm^2, 15 kg cm^2, 3 kg cm^2]}, axis: z, "
    "points: {tip: [0, 0, -6 cm]}}}\nconnections: {floor: {ball: top.tip}}\n"
    "states: {start: {top.tilt: 40 deg, top.axial_rate: 250 rad/s, top.precession: 0 rad/s, top.nutation: 0 rad/s}, later: {time: 0.1 s}}\n"
)
REFUSED = {  # a scene, and what is said of it
    "axes that are not principal": (
        "gravity: none\nbodies: {b: {mass: 1 kg, inertia: {tensor: [[2 kg m^2, 0.1 kg m^2, 0], [0.1 kg m^2, 3 kg m^2, 0], "
        f"[0, 0, 4 kg m^2]]}}}}}}\nstates: {{{FREE}, later: {{time: 2 s}}}}\nfind: {{w: b.angular_velocity at later in body axes}}\n",
        "the own axes of `b` are not its principal ones",
    ),
    "what is told twice": (
        f"gravity: none\n{BODY}states: {{{FREE}, later: {{time: 2 s, b.angular_velocity: [1 rad/s, 0, 0]}}}}\n"
        "find: {w: b.angular_velocity at later in body axes}\n",
        "how `b` stands and turns at `later` follows from the time that has passed",
    ),
    "a top that nods": (
        f"{NODDING}find: {{th: top.tilt at later}}\n",
        "how `top`, which leans, stands and turns when time has passed is not solved",
    ),
    "node axes": (
        f"gravity: none\n{SYMMETRIC_BODY}states: {{start: {{b.tilt: 30 deg, b.precession: 1 rad/s, b.spin: 2 rad/s, b.nutation: 0 rad/s, "
        "b.velocity: [0, 0, 0]}, later: {time: 2 s}}\nfind: {v: b.angular_velocity at later in node axes}\n",
        "the node axes of `b` when time has passed are not solved",
    ),
    "what a blow leaves open": (
        f"gravity: none\n{STRUCK}states: {{before: at rest, after: {{}}, later: {{time: 2 s}}}}\n"
        "events: {hit: {impulse: 2 N s, on: b.P, direction: [0, 0, -1], from: before, to: after}}\n"
        "find: {w: b.angular_velocity at later in body axes}\n",
        "whether L² is more or less than 2 E I of the middle axis of `b` is not told",
    ),
    "a pendulum": (
        "bodies: {b: {shape: rod, mass: 1 kg, length: 1 m}}\nconnections: {h: {hinge: b.start, along: y}}\n"
        "states: {now: {b.angular_velocity: 1 rad/s}, later: {time: 1 s}}\nfind: {w: b.angular_velocity at later}\n",
        "its motion in time has no closed form that is known here",
    ),
    "two steady precessions": (
        STEADY.replace("WHICH", "").partition("up: z\n")[2],
        "two steady motions are possible, and nothing tells which is meant",
    ),
    "a body that carries a rotor": (
        "gravity: none\nbodies: {b: {mass: 1 kg, inertia: {principal: [3 kg m^2, 3 kg m^2, 3 kg m^2]}}, "
        "c: {mass: 1 kg, inertia: {principal: [1 kg m^2, 1 kg m^2, 1.5 kg m^2]}, axis: z}}\n"
        "connections: {a: {axle: [b, c], along: x}}\n"
        "states: {start: {b.angular_velocity: [1 rad/s, 2 rad/s, 0], c.spin: 3 rad/s}, later: {time: 2 s}}\n"
        "find: {w: b.angular_velocity at later}\n",
        "its motion in time has no closed form that is known here",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_solved_in_time_is_refused_by_name(name: str) -> None:
    text, said = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{text}")
    assert said in str(caught.value)
