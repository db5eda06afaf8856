"""From state to state in space: what is clamped to a body goes with it, rates have the sense in which the body comes there, and a state is
steady only where what acts goes round with what it acts on. The numbers come from the energy written by hand.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from rotsolve import SceneError, Unsolvable, simulate, solve
from rotsolve.confirm.space.verdict import SQUARED, by_squares

WHEEL = """up: z
given: {m: 2 kg, R: 0.5 m, M: 0.5 kg, g: 9.8 m/s^2}
bodies: {wheel: {shape: disc, mass: m, radius: R, turned: {about: x, by: 90 deg}, points: {P: [R, 0, 0]}}, lump: LUMP}
connections: {axis: {hinge: wheel.center, along: z}, fast: {clamp: [wheel.P, lump]}}
states: {start: {wheel.angular_velocity: 0 rad/s, wheel.angle: 0 deg}, low: {wheel.angle: -90 deg}}
find: {w: size of wheel.angular_velocity at low, v: lump.speed at low, F: axis.force.z at low}
"""
OBLIQUE = """up: z
given: {m: 2 kg, b: 1 m, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: m, length: b}}
connections: {post: {hinge: rod.start, along: ALONG}}
states: {s0: {rod.angular_velocity: RATE, rod.angle: 0 deg}, s1: {rod.angle: FIRST}, s2: {rod.angle: LAST}}
find: {w: rod.angular_velocity at s2}
"""
TOP = """up: z
given: {M: 0.2 kg, l: 5 cm, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, g: 9.8 m/s^2}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l], Q: [0, 0, l]}}}
connections: {floor: {ball: top.tip}}
"""
NODS = "top.axial_rate: 400 rad/s, top.precession: 0 rad/s, top.nutation: 1 rad/s"


def numbers(text: str) -> dict[str, list[float]]:
    """The numbers of all answers, each of which is confirmed."""
    derivation = solve(f"title: t\n{text}").complete().derivation
    assert all(item.holds for item in derivation.confirmed), [(item.name, item.why) for item in derivation.confirmed]
    return {
        answer.name: [part.value.float for part in (answer.components or (answer,)) if part.value is not None]
        for answer in derivation.answers
    }


@pytest.mark.parametrize("lump", ["{shape: particle, mass: M}", "{shape: sphere, mass: M, radius: R/5}"])
def test_what_is_clamped_to_a_wheel_falls_with_it(lump: str) -> None:
    """½ (½ m R² + M R² + I) ω² = M g R, I = ⅖ M r² of a ball about its centre."""
    own = 0.0 if "particle" in lump else 0.4 * 0.5 * 0.1**2
    rate = math.sqrt(2 * 0.5 * 9.8 * 0.5 / (0.5 * 2 * 0.25 + 0.5 * 0.25 + own))
    found = numbers(WHEEL.replace("LUMP", lump))
    assert found["w"] == pytest.approx([rate])
    assert found["v"] == pytest.approx([rate * 0.5])
    assert found["F"] == pytest.approx([2.5 * 9.8 + 0.5 * rate**2 * 0.5])


def test_a_couple_on_a_clamped_particle_turns_what_carries_it() -> None:
    """½ (⅓ m b² + M b²) ω² = Q φ; also as it is followed: φ = ½ α t²."""
    text = """up: z
given: {m: 2 kg, M: 0.5 kg, b: 1 m, Q: 3 N m}
bodies: {rod: {shape: rod, mass: m, length: b}, lump: {shape: particle, mass: M}}
connections: {post: {hinge: rod.start, along: z}, fast: {clamp: [rod.end, lump]}}
actions: {c: {couple: [0, 0, Q], on: lump}}
states: {a: {rod.angular_velocity: 0 rad/s, rod.angle: 0 deg}, e: {rod.angle: 2 rad}}
find: {w: rod.angular_velocity.z at e}
"""
    inertia = 2 / 3 + 0.5
    assert numbers(text)["w"] == pytest.approx([math.sqrt(2 * 3 * 2 / inertia)])
    alone = text.replace(", e: {rod.angle: 2 rad}", "").replace(
        "find: {w: rod.angular_velocity.z at e}", "find: {al: rod.angular_acceleration.z}"
    )
    assert numbers(alone)["al"] == pytest.approx([3 / inertia])
    assert simulate(f"title: t\n{alone}", until="1 s").at(1.0)["rod.angle"][0] == pytest.approx(0.5 * 3 / inertia)


@pytest.mark.parametrize(
    ("along", "rate", "first", "last"),
    [
        ("[0, 3/5, 4/5]", -9.0, -100, -200),
        ("[0, 3/5, 4/5]", 9.0, 100, 200),
        ("[0, -3/5, -4/5]", 9.0, 100, 200),
        ("[0, 3/5, 4/5]", 1.0, 60, 30),
        ("y", 1.0, 60, 30),
    ],
)
def test_a_rate_has_the_sense_in_which_the_rod_comes_there(along: str, rate: float, first: int, last: int) -> None:
    """½ I ω² − M g h with h = −½ b n_y sin φ; ω along n as φ goes from the second state to the third."""
    scene = OBLIQUE.replace("ALONG", along).replace("RATE", f"{rate} rad/s")
    found = numbers(scene.replace("FIRST", f"{first} deg").replace("LAST", f"{last} deg"))["w"]
    way = [0.0, 1.0, 0.0] if along == "y" else [0.0, 0.6, 0.8] if "-" not in along else [0.0, -0.6, -0.8]
    size = math.sqrt(rate**2 + 3 * 9.8 * way[1] * math.sin(math.radians(last)))
    sense = 1 if last > first else -1
    assert found == pytest.approx([sense * size * part for part in way])


def test_a_top_rises_after_its_largest_tilt() -> None:
    states = f"start: {{top.tilt: 20 deg, {NODS}}}, ext: {{top.tilt: largest}}, fin: {{top.tilt: 21 deg}}"
    found = numbers(
        f"{TOP}states: {{{states}}}\nfind: {{n: top.nutation at fin, v: top.velocity.y at fin in node axes}}\n"
    )
    assert found["n"] == pytest.approx([-1.4728], rel=1e-4)
    assert found["v"] == pytest.approx([0.05 * 1.4728], rel=1e-4)


def test_the_comparison_of_rates_knows_their_sense() -> None:
    assert by_squares((5.597,), (5.597,), 1.0, SQUARED)
    assert not by_squares((5.597,), (-5.597,), 1.0, SQUARED)
    assert by_squares((1e-6,), (-1e-6,), 1.0, SQUARED)


def test_a_way_back_in_letters_is_on_condition() -> None:
    """A rod that sets out at w₀ comes back past 30° only if it has not the energy to go over the top, b w₀² < 3 g."""
    text = OBLIQUE.replace("ALONG", "y").replace("RATE", "w0").replace("FIRST", "60 deg").replace("LAST", "30 deg")
    text = text.replace("{m: 2 kg, b: 1 m, g: 9.8 m/s^2}", "{m: kg, b: m, w0: rad/s}")
    page = solve(f"title: t\n{text}").complete().to("text")
    assert "(if b < 3 g/w₀²)" in page
    with pytest.raises(Unsolvable, match="never reached"):
        solve(f"title: t\n{text.replace('w0: rad/s', 'w0: 9 rad/s').replace('m: kg, b: m', 'm: 1 kg, b: 1 m')}")


@pytest.mark.parametrize(
    ("find", "more"),
    [("{w: w0 where rod.angular_velocity.y = -1 rad/s at e}", ""), ("{w: w0}", ", rod.angular_velocity: -1 rad/s")],
)
def test_either_sense_of_a_first_rate_is_refused(find: str, more: str) -> None:
    text = f"""up: z
given: {{m: 2 kg, b: 1 m, w0: unknown}}
bodies: {{rod: {{shape: rod, mass: m, length: b}}}}
connections: {{post: {{hinge: rod.start, along: y}}}}
states: {{a: {{rod.angular_velocity: w0, rod.angle: 60 deg}}, e: {{rod.angle: 20 deg{more}}}}}
find: {find}
"""
    with pytest.raises(Unsolvable, match="in which sense `rod` turns at `a` nothing tells"):
        solve(f"title: t\n{text}")


STEADY = "states: {now: {top.tilt: 30 deg, top.spin: 300 rad/s, steady: true}}\nfind: {W: smallest top.precession}\n"
CARRIED = """up: z
given: {W: 4 rad/s, b: 20 cm, L: 60 cm, M: 1.5 kg, x: unknown}
bodies: {table: {shape: disc, mass: 0, points: {P: [b, 0, 0]}TURNED}, rod: {shape: rod, mass: M, length: L}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: W}, pin: {hinge: [table.P, rod.start], along: y}}
ACTIONSstates: {now: {rod.angle: x, steady: true}}
find: {x: largest x in deg}
"""
COIN = """up: z
given: {M: 10 g, R: 1 cm, W: 4 rad/s, s: unknown}
bodies: {coin: {shape: disc, mass: M, radius: R}, table: {shape: disc, mass: 0}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: W}, grip: {rolls: [coin, table]}}
states: {now: {"coin.position relative to table": [0.1 m, 0 m, R], coin.tilt: 90 deg, coin.precession_angle: 90 deg,
  coin.precession: 2 rad/s, coin.spin: s, steady: true}}
find: {s: s}
"""
PASSING = {
    "a couple that stays as it is": (
        f"{TOP}actions: {{c: {{couple: [0.01 N m, 0, 0], on: top}}}}\n{STEADY}",
        "`c` keeps its",
    ),
    "a level force": (f"{TOP}actions: {{c: {{force: [0.5 N, 0, 0], on: top.Q}}}}\n{STEADY}", "`c` keeps its"),
    "a force on a table": (
        CARRIED.replace("ACTIONS", "actions: {p: {force: [5 N, 0, 0], on: rod.end}}\n").replace("TURNED", ""),
        "`p` keeps its",
    ),
    "a leaning table": (
        CARRIED.replace("ACTIONS", "").replace("TURNED", ", turned: {about: y, by: 30 deg}"),
        "the weight of `rod` keeps its",
    ),
    "a coin that goes round otherwise": (COIN, "contradict"),
}


@pytest.mark.parametrize("case", PASSING)
def test_what_is_steady_for_an_instant_alone_is_refused(case: str) -> None:
    text, said = PASSING[case]
    with pytest.raises((Unsolvable, SceneError), match=said):
        solve(f"title: t\n{text}")


def test_what_goes_round_with_a_level_table_is_steady() -> None:
    """tan x = (b + ⅔ L cos x) W²/g below the level: M g ½ L cos x = M W² sin x (½ L b + ⅓ L² cos x)."""
    found = numbers(CARRIED.replace("ACTIONS", "").replace("TURNED", ""))["x"]
    angle = math.radians(found[0])
    weight, flung = 9.8 * 0.3 * math.cos(angle), 16 * math.sin(angle) * (0.3 * 0.2 + 0.12 * math.cos(angle))
    assert weight == pytest.approx(flung)


@pytest.mark.parametrize(
    "joint", ["{hinge: table.corner1, along: [3/5, 4/5, 0], ", "{axle: table.center, along: [3/5, 4/5, 0], "]
)
def test_an_angle_that_a_drive_tells_in_time_is_told(joint: str) -> None:
    """φ = q sin n t, φ̇ = q n cos n t at the time of the state."""
    text = f"""up: z
given: {{q: 0.4 rad, n: 3 rad/s, T: 0.7 s}}
bodies: {{table: {{shape: rectangle, mass: 2 kg, sides: [60 cm, 40 cm]}}}}
connections: {{axis: {joint}angle: q*sin(n*time)}}}}
states: {{now: {{time: T}}}}
find: {{th: table.angle, w: table.angular_velocity}}
"""
    if "axle" in joint:
        text = text.replace(
            "shape: rectangle, mass: 2 kg, sides: [60 cm, 40 cm]", "shape: disc, mass: 2 kg, radius: 30 cm"
        )
    found = numbers(text)
    rate = 1.2 * math.cos(2.1)
    assert found["th"] == pytest.approx([0.4 * math.sin(2.1)])
    assert found["w"] == pytest.approx([0.6 * rate, 0.8 * rate, 0.0])


def test_two_balls_on_a_moving_body_are_refused() -> None:
    text = """up: z
bodies:
  car: {mass: 0, angular_velocity: [0.5 rad/s, 0, 2 rad/s]}
  rot: {shape: cuboid, mass: 2 kg, sides: [0.4 m, 0.2 m, 0.1 m], points: {A: [-0.2 m, 0.05 m, 0], B: [0.2 m, 0.1 m, 0]}}
connections: {l: {ball: [car, rot.A]}, r: {ball: [car, rot.B]}}
states: {now: {rot.angle: 30 deg, rot.angular_velocity: 4 rad/s}}
find: {w: rot.angular_velocity}
"""
    with pytest.raises(Unsolvable, match="two balls on `car`"):
        solve(f"title: t\n{text}")


def test_a_chain_of_clamps_is_pushed_at_its_end() -> None:
    """½ I ω² + M g h with F Δy of the point pushed; a rod, an arm on its end and a ball on that, on an oblique hinge off the origin."""
    text = """up: z
given: {m: 2 kg, M: 0.5 kg, b: 1 m, d: 0.3 m, F: 3 N, r: 10 cm, g: 9.8 m/s^2}
bodies:
  ball: {shape: sphere, mass: M, radius: r, points: {E: [0, r, 0]}}
  arm: {shape: rod, mass: M, length: d}
  rod: {shape: rod, mass: m, length: b}
connections:
  outer: {clamp: [arm.end, ball]}
  inner: {clamp: [rod.end, arm.start]}
  post: {hinge: [[0, 0, b], rod.start], along: [0, 3/5, -4/5]}
actions: {f: {force: [0, F, 0], on: ball.E}}
states: {s0: {rod.angle: 0 deg, rod.angular_velocity: 6 rad/s}, s1: {rod.angle: 100 deg}}
find: {w: rod.angular_velocity at s1, v: ball.E.velocity at s1}
"""
    found, way = numbers(text), np.array([0.0, 0.6, -0.8])
    across = np.array([[0, 0.8, 0.6], [-0.8, 0, 0], [-0.6, 0, 0]])  # way ×
    turn = np.eye(3) + math.sin(math.radians(100)) * across + (1 - math.cos(math.radians(100))) * across @ across
    pieces = ((2.0, 0.5), (0.5, 1.15), (0.5, 1.3))  # masses at their distances along the rod
    inertia = sum(mass * place**2 for mass, place in pieces) + 2 / 12 + 0.5 * 0.09 / 12 + 0.4 * 0.5 * 0.01
    pushed = np.array([1.3, 0.1, 0.0])
    lifted = 9.8 * sum(mass * place for mass, place in pieces) * turn[2, 0]
    rate = math.sqrt(36 + 2 * (3 * (turn @ pushed - pushed)[1] - lifted) / inertia)
    assert found["w"] == pytest.approx(list(rate * way))
    assert found["v"] == pytest.approx(list(np.cross(rate * way, turn @ pushed)))
