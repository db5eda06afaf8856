"""States in space that tell their times: each is so long after the one before, as in the plane; what does not hang on it is answered."""

from __future__ import annotations

import math

import pytest

from rotsolve import SceneError, simulate, solve
from rotsolve.solution import Solution

IN_PLANE = """
title: T
given: {tau: 2 N m}
bodies: {d: {shape: disc, mass: 2 kg, radius: 1 m}}
connections: {post: {axle: d}}
actions: {push: {couple: tau, on: d}}
states: {start: {d.angular_velocity: 0, d.angle: 0}, mid: {time: 1 s}, end: {time: 3 s}}
find: {w1: d.angular_velocity at mid, w2: d.angular_velocity at end, a1: d.angle at mid, a2: d.angle at end}
"""
IN_SPACE = (
    IN_PLANE.replace("given", "up: z\ngravity: none\ngiven")
    .replace("axle: d", "hinge: d.center, along: z")
    .replace("couple: tau", "couple: [0, 0, tau]")
    .replace("d.angular_velocity at", "d.angular_velocity.z at")
)
FREE = """
title: T
up: z
bodies: {p: {mass: 1 kg, inertia: {principal: [1 kg m^2, 1 kg m^2, 2 kg m^2]}}}
states:
  start: {p.angular_velocity: [1 rad/s, 0, 3 rad/s], p.velocity: [1 m/s, 0, 5 m/s]}
  mid: {time: 1 s}
  end: {time: 0.5 s}
  last: {time: 2 s}
find: {w: p.angular_velocity at last in body axes, v: p.velocity at last}
"""
DRIVEN = """
title: T
up: z
gravity: none
bodies: {d: {shape: disc, mass: 2 kg, radius: 1 m}}
connections: {post: {hinge: d.center, along: z, angle: 1 rad/s^2*time^2}}
states: {start: FIRST, mid: {time: 1 s}, end: {time: 3 s}}
find: {w0: d.angular_velocity.z at start, w1: d.angular_velocity.z at mid, w2: d.angular_velocity.z at end}
"""
BOX = """
title: T
up: z
gravity: none
given: {m: 3 kg, a: 0.6 m, b: 0.4 m, c: 0.2 m, J: 2 N s}
bodies: {box: {shape: cuboid, mass: m, sides: [a, b, c], points: {P: [a/2, b/2, c/2]}}}
states: {before: at rest, after: {}, later: {time: 1 s}}
events: {hit: {impulse: J, on: box.P, direction: [0, 0, -1], from: before, to: after}}
find:
  w: box.angular_velocity at later in body axes
  L: box.angular_momentum at later
  v: box.velocity at later
  w0: box.angular_velocity at after
  K: box.kinetic_energy at after
"""
TOP = """
title: T
up: z
given: {M: 0.3 kg, l: 0.06 m, A: 0.0015 kg m^2, C: 0.0003 kg m^2, w3: 250 rad/s, theta: 40 deg}
bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l], head: [0, 0, l]}}}
connections: {floor: {ball: top.tip}}
"""
NODDING = (
    TOP
    + """
states: {start: {top.tilt: theta, top.axial_rate: w3, top.precession: 0 rad/s, top.nutation: 0 rad/s}, later: {time: 0.1 s}}
find: {th: top.tilt at later, Lz: top.angular_momentum.z at later, w: top.axial_rate at later, L: top.angular_momentum at start}
"""
)
STRUCK = (
    TOP
    + """
states: {before: {top.tilt: theta, top.axial_rate: w3, top.precession: 0 rad/s, top.nutation: 0 rad/s}, after: AFTER}
events: {hit: {impulse: 0.02 N s, on: top.head, direction: x, from: before, to: after}}
find: {nu: top.nutation at after, p: top.precession at after, w: top.axial_rate at after, om: top.angular_velocity at after}
"""
)


def numbers(solution: Solution) -> dict[str, list[float]]:
    """All answers, each with its parts."""
    answers = ((item.name, item.components or (item,)) for item in solution.derivation.answers)
    return {name: [float(part.value.refine(20)) for part in parts if part.value is not None] for name, parts in answers}


def confirmed(solution: Solution) -> set[str]:
    return {item.name for item in solution.derivation.confirmed if item.holds}


def test_a_disc_turns_as_in_the_plane() -> None:
    """α = τ/I = 2 rad/s²: after 1 s, and 3 s later, which is 4 s after the start."""
    expected = {"w1": [2], "w2": [8], "a1": [1], "a2": [16]}
    for text in (IN_PLANE, IN_SPACE):
        solution = solve(text)
        found = numbers(solution)
        assert all(found[name] == pytest.approx(value) for name, value in expected.items())
        assert confirmed(solution) == set(expected)


def test_a_free_body_goes_on_from_state_to_state() -> None:
    """ω goes round its axis at ω₃ (I₃ − I₁)/I₁ = 3 rad/s, and it falls, for 3.5 s in all."""
    solution = solve(FREE)
    found = numbers(solution)
    assert found["w"] == pytest.approx([math.cos(10.5), math.sin(10.5), 3])
    assert found["v"] == pytest.approx([1, 0, 5 - 9.8 * 3.5])
    assert confirmed(solution) == {"w", "v"}


@pytest.mark.parametrize(("first", "start"), [("{}", 0), ("{time: 2 s}", 2)])
def test_the_running_time_counts_from_the_first_state(first: str, start: float) -> None:
    """ω = 2 t rad/s², with t = 0 at the first state, or what that tells."""
    solution = solve(DRIVEN.replace("FIRST", first))
    assert numbers(solution) == {"w0": [2 * start], "w1": [2 * (start + 1)], "w2": [2 * (start + 4)]}
    assert confirmed(solution) == {"w0", "w1", "w2"}


def test_a_time_counts_from_a_state_to_which_an_angle_leads() -> None:
    """3 s after 4 rad/s at 4 rad ω is 6 rad/s more."""
    text = IN_SPACE.replace("mid: {time: 1 s}", "mid: {d.angle: 4 rad, d.angular_velocity: 4 rad/s}").partition("find")[
        0
    ]
    solution = solve(text + "find: {w2: d.angular_velocity.z at end, a2: d.angle at end}\n")
    found = numbers(solution)
    assert found["w2"] == pytest.approx([10])
    assert found["a2"] == pytest.approx([4 + 4 * 3 + 9])


@pytest.mark.parametrize("text", [IN_PLANE, IN_SPACE], ids=["plane", "space"])
def test_a_simulation_comes_to_each_state_so_long_after_the_one_before(text: str) -> None:
    run = simulate(text, 6)
    assert [item.state for item in run.events] == ["mid", "end"]
    assert [item.time for item in run.events] == pytest.approx([1, 4])


def test_what_letters_leave_open_of_a_struck_box_takes_nothing_else_with_it() -> None:
    """J at (a, b, c)/2 downwards: L = r × J, ω by the moments of a cuboid, v = J/m."""
    solution = solve(BOX)
    found = numbers(solution)
    assert found["L"] == pytest.approx([-0.4, 0.6, 0])
    assert found["v"] == pytest.approx([0, 0, -2 / 3])
    moments = [3 * (0.16 + 0.04) / 12, 3 * (0.36 + 0.04) / 12]
    rates = [-0.4 / moments[0], 0.6 / moments[1]]
    assert found["w0"] == pytest.approx([*rates, 0])
    assert found["K"] == pytest.approx([(2 / 3) ** 2 * 1.5 + (-0.4 * rates[0] + 0.6 * rates[1]) / 2])
    assert confirmed(solution) == {"L", "v", "w0", "K"}
    assert "whether L² is more or less than 2 E I" in str(solution.refused["w"])


def test_what_stays_of_a_top_that_nods_is_told() -> None:
    """I₃ ω₃, and L_z = I₃ ω₃ cos θ where it does not precess at first."""
    solution = solve(NODDING)
    found, size = numbers(solution), 0.0003 * 250
    tilt = math.radians(40)
    assert found["Lz"] == pytest.approx([size * math.cos(tilt)])
    assert found["w"] == pytest.approx([250])
    assert found["L"] == pytest.approx([0, -size * math.sin(tilt), size * math.cos(tilt)])
    assert "`rotsolve simulate` follows it" in str(solution.refused["th"])


@pytest.mark.parametrize("after", ["{}", "{top.tilt: theta}"])
def test_a_blow_leaves_a_top_at_its_tilt(after: str) -> None:
    """J along e₁ at 2 l from the tip changes A φ̇ sin θ by 2 l J, the nutation and ω₃ not at all."""
    solution = solve(STRUCK.replace("AFTER", after))
    found = numbers(solution)
    assert found["p"] == pytest.approx([0.12 * 0.02 / (0.0015 * math.sin(math.radians(40)))])
    assert found["nu"] == [0]
    assert found["w"] == pytest.approx([250])
    assert confirmed(solution) == {"p", "nu", "w", "om"}


def test_an_event_takes_no_time() -> None:
    with pytest.raises(SceneError, match="what the state says of `time` says nothing here"):
        solve(
            BOX.replace("after: {}", "after: {time: 1 s}").partition("find")[0] + "find: {v: box.velocity at later}\n"
        )
