"""Blows on bodies that are connected, against M Δv = Jᵀ Λ of all bodies at once, written here from places alone."""

from __future__ import annotations

import random

import numpy as np
import pytest

from linked import Bodies, direction
from rotsolve import Unsolvable, solve


def chain(seed: int, count: int, held: str) -> tuple[str, dict[str, float]]:
    """A random chain of rods, free on ice, hanging from a hinge or a cart, struck anywhere in any direction: scene and truth."""
    dice = random.Random(seed)
    bodies, truth = Bodies(), dict[str, float]()
    lines, joints, at_rest, asked = [], [], [], []
    end = np.zeros(2)
    if held == "cart":
        bodies.add("cart", 3.0, 1.0, (0, 0))
        bodies.rows += [
            ("base.y", [("cart", end, direction(np.pi / 2))]),
            ("cart.turn", [("cart", direction(0), direction(np.pi / 2))]),
        ]
        lines.append("  cart: {mass: 3 kg, moves: right}")
        joints += ["  base: {contact: [cart, floor]}", "  pin0: {hinge: [cart, r0.start]}"]
    elif held == "hinge":
        joints.append("  pin0: {hinge: r0.start}")
    spots = []
    for k in range(count):
        mass, length, angle = dice.randint(1, 5), dice.randint(3, 9) / 10, dice.randrange(0, 360, 5)
        way = direction(np.radians(angle))
        lump = dice.random() < 0.3
        extra, place = (dice.randint(1, 3), dice.randint(1, 9) * length / 10) if lump else (0, 0.0)
        centre = (mass * length / 2 + extra * place) / (mass + extra)
        inertia = mass * length**2 / 12 + mass * (centre - length / 2) ** 2 + extra * (centre - place) ** 2
        bodies.add(f"r{k}", mass + extra, inertia, end + centre * way)
        lines.append(f"  r{k}: {{shape: rod, mass: {mass} kg, length: {length} m}}")
        if lump:
            lines.append(f"  lump{k}: {{mass: {extra} kg}}")
            joints.append(f"  fast{k}: {{weld: [r{k}.at({place} m), lump{k}]}}")
        if k:
            joints.append(f"  pin{k}: {{hinge: [r{k - 1}.end, r{k}.start]}}")
            bodies.pin(f"pin{k}", end, f"r{k}", f"r{k - 1}")
        elif held != "free":
            bodies.pin("pin0", end, "r0", "cart" if held == "cart" else "")
        at_rest.append(f"r{k}.angle: {angle} deg")
        spots.append((end, way, length))
        end = end + length * way
    hit, aim = dice.randrange(count), dice.randrange(0, 360, 7)
    start, way, length = spots[hit]
    where = dice.randint(0, 10) * length / 10
    push = (f"r{hit}", start + where * way, 4 * direction(np.radians(aim)))
    after, impulses = bodies.struck(np.zeros(3 * len(bodies.names)), [push])
    if held == "cart":
        truth["N"] = impulses["base.y"] + impulses["cart.turn"]
        truth["v"] = after[0]
        asked.append("  v: cart.velocity at after")
    for k in range(count):
        truth[f"w{k}"] = after[3 * bodies.names.index(f"r{k}") + 2]
        asked.append(f"  w{k}: r{k}.angular_velocity at after")
    for name, value in impulses.items():
        if name.startswith("pin"):
            joint, axis = name.split(".")
            truth[f"J_{joint}_{axis}"] = value
            asked.append(f"  J_{joint}_{axis}: {joint}.impulse.{axis} during blow")
    newline = "\n"
    return (
        f"""title: Rods struck
{"" if held == "cart" else "plane: horizontal"}
surfaces: {{floor: level}}
bodies:
{newline.join(lines)}
connections:
{newline.join(joints) or "  {}"}
states:
  before: {{at rest: all, {", ".join(at_rest)}}}
  after: {{}}
events: {{blow: {{impulse: 4 N s, on: r{hit}.at({where} m), direction: {aim} deg, from: before, to: after}}}}
find:
{newline.join(asked)}
""",
        truth,
    )


HELD = ("cart", "free", "hinge")


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("count", "seed", "held"),
    [  # of each number of rods three chains, each of them held in two ways
        *((count, (at + more) % 3, held) for count in (1, 2, 3, 4) for at, held in enumerate(HELD) for more in (0, 1)),
        *((10, 0, held) for held in HELD),
    ],
)
def test_rods_struck_anywhere_in_any_direction(seed: int, count: int, held: str) -> None:
    """All angular velocities, and both components of every joint's impulse; a cart that would have to be pulled down leaves the floor."""
    scene, truth = chain(100 * count + seed, count, held)
    if truth.pop("N", 1) < 0:
        few = scene.partition("\n  w1:")[
            0
        ]  # each question is tried alone too: as many as chains of two have are enough
        with pytest.raises(Unsolvable, match="in `blow` cart leaves the surface"):
            solve(few if count > 2 else scene, confirm=False)
        return
    answers = solve(scene, confirm=False).answers
    assert {name: answers[name].float for name in truth} == pytest.approx(truth, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("question", ["block.momentum.y", "block.velocity.y", "block.kinetic_energy", "block.velocity"])
@pytest.mark.parametrize(
    "mass", ["block: {mass: m, moves: right}", "block: {shape: disc, mass: m, radius: 0.2, moves: left}"]
)
def test_what_is_struck_off_a_surface_leaves_it_whatever_is_asked(mass: str, question: str) -> None:
    """A surface does not pull back what is struck upwards."""
    scene = f"""
given: {{m: 2 kg, J: 4 N s}}
surfaces: {{floor: level}}
bodies: {{{mass.replace("0.2", "20 cm")}}}
connections: {{base: {{contact: [block, floor], friction: 0.3}}}}
states: {{start: {{at rest: all}}, after: {{}}}}
events: {{hit: {{impulse: J, on: block, direction: WAY, from: start, to: after}}}}
find: {{x: {question} at after}}
"""
    with pytest.raises(Unsolvable, match="leaves the surface"):
        solve(scene.replace("WAY", "up"))
    assert solve(scene.replace("WAY", "-30 deg")).answers["x"].float is not None


@pytest.mark.parametrize(
    "question", ["x: stone.kinetic_energy", "x: wheel.angular_acceleration", "x: wheel.angular_velocity"]
)
@pytest.mark.parametrize(("way", "moves"), [("right", "left"), ("right", "right")])
def test_a_stone_that_sticks_to_the_rim_of_a_wheel_lifts_it(way: str, moves: str, question: str) -> None:
    """The stone on the right-hand rim goes down as the wheel rolls off to the right: the floor would have to pull."""
    scene = f"""
given: {{R: 1 m, M: 3.8 kg, m: 0.61 kg, u: 3.7 m/s}}
surfaces: {{floor: level}}
bodies: {{wheel: {{shape: disc, mass: M, radius: R, moves: {moves}}}, stone: {{mass: m, moves: {way}}}}}
connections: {{base: {{contact: [wheel, floor], friction: any}}}}
states: {{start: {{at rest: [wheel], stone.velocity: u}}, after: {{}}}}
events: {{hit: {{joins: [stone, wheel.rim], from: start, to: after}}}}
find: {{{question} at after, y: wheel.angular_acceleration at after}}
"""
    with pytest.raises(Unsolvable, match="leaves the surface"):
        solve(scene)


KNOCKED = """
title: Two crates on one rough floor
given: {{m: {m} kg, M: {M} kg, u: {u} m/s, w: {w} m/s, mu: 0.3, e: 0.8}}
surfaces: {{floor: level}}
bodies: {{{bodies}}}
connections: {{c1: {{contact: [one, floor], friction: mu}}, c2: {{contact: [two, floor], friction: mu}}}}
states: {{before: {{one.velocity: u, two.velocity: w}}, after: {{}}, end: {{time: 1 ms}}}}
events: {{hit: {{collides: [one, two], restitution: e, from: before, to: after}}}}
find: {{f: c1.friction_force.x at after, h: c2.friction_force.x at after, a: one.acceleration at after}}
"""


@pytest.mark.parametrize("order", [("one", "two"), ("two", "one")])
@pytest.mark.parametrize(
    ("m", "M", "u", "w"), [(3, 0.5, 2, 0), (0.5, 3, 2, 0), (1, 2, 3, -1), (2, 1, 1, -3), (2, 3, 4, 1)]
)
def test_friction_after_a_blow_is_against_the_way_in_which_each_then_goes(
    m: float, M: float, u: float, w: float, order: tuple[str, str]
) -> None:
    """v = (m u + M w ∓ e … (u − w))/(m + M): none is held by the floor through the blow, which is finite in friction."""
    masses = {"one": "m", "two": "M"}
    bodies = ", ".join(f"{name}: {{mass: {masses[name]}, moves: right}}" for name in order)
    text = KNOCKED.format(m=m, M=M, u=u, w=w, bodies=bodies).replace(".friction_force.x", ".friction_force")
    derivation = solve(text, confirm=False).derivation
    middle, apart = (m * u + M * w) / (m + M), 0.8 * (u - w)
    speeds = {"f": middle - M * apart / (m + M), "h": middle + m * apart / (m + M)}
    found = {answer.name: answer for answer in derivation.answers}
    assert {name: found[name].direction for name in speeds} == {
        name: "left" if speed > 0 else "right" for name, speed in speeds.items()
    }
    assert found["a"].value is not None
    assert found["a"].value.float == pytest.approx(-0.3 * 9.8 if speeds["f"] > 0 else 0.3 * 9.8)


@pytest.mark.parametrize(("J", "ahead"), [(2.0, True), (8.0, False)])
def test_a_kick_against_a_plank_leaves_what_lies_on_it_as_it_was(J: float, ahead: bool) -> None:
    """The plank alone takes the blow, M u − J; the block on it slips, forwards on the plank either way."""
    derivation = solve(f"""
title: Kick against a plank with a block on it
given: {{m: 2 kg, M: 3 kg, J: {J} N s, u: 2 m/s, mu: 0.5, k: 0.1}}
surfaces: {{floor: level}}
bodies: {{plank: {{mass: M, moves: right}}, block: {{mass: m, moves: right}}}}
connections: {{below: {{contact: [plank, floor], friction: k}}, grip: {{contact: [block, plank], friction: mu}}}}
states: {{before: {{plank.velocity: u, block.velocity: u}}, after: {{}}}}
events: {{kick: {{impulse: J, on: plank, direction: left, from: before, to: after}}}}
find: {{f: below.friction_force at after, q: grip.friction_force at after, v: block.velocity at after, V: plank.velocity at after}}
""").derivation
    found = {answer.name: answer for answer in derivation.answers}
    assert (found["f"].direction, found["q"].direction) == ("left" if ahead else "right", "left")
    numbers = {name: answer.value.float for name, answer in found.items() if answer.value is not None}
    assert (numbers["v"], numbers["V"]) == pytest.approx((2.0, 2.0 - J / 3))
    assert all(item.holds for item in derivation.confirmed)


@pytest.mark.parametrize("joined", ["[one, two]", "[two, one]"])
def test_what_runs_into_a_crate_on_a_rough_floor_takes_it_along(joined: str) -> None:
    """Neither floor presses any more through the blow, so that none of its friction stops them: V = m u/(m + M)."""
    solution = solve(f"""
title: One crate runs into another and sticks
given: {{m: 2 kg, M: 3 kg, u: 5 m/s, mu: 0.4}}
surfaces: {{floor: level}}
bodies: {{one: {{mass: m, moves: right}}, two: {{mass: M, moves: right}}}}
connections: {{c1: {{contact: [one, floor], friction: mu}}, c2: {{contact: [two, floor], friction: mu}}}}
states: {{before: {{one.velocity: u, two.velocity: 0}}, after: {{}}}}
events: {{hit: {{joins: {joined}, from: before, to: after}}}}
find: {{V: two.velocity at after}}
""")
    assert solution.answers["V"].float == pytest.approx(2.0)
    assert all(item.holds for item in solution.derivation.confirmed)


KICKS = [(1.0, 0.0), (-1.0, 0.0), (3.0, 1.0), (-3.0, 1.0), (2.0, -1.0)]
ROUND = [("sphere", 0.4), ("cylinder", 0.5), ("spherical shell", 2 / 3)]


@pytest.mark.parametrize(
    ("J", "height", "shape", "c", "way"),
    [  # each kick in both ways, with two of the shapes
        (*kick, *ROUND[(number + turn) % 3], way)
        for number, kick in enumerate(KICKS)
        for turn, way in enumerate(("right", "left"))
    ],
)
def test_what_is_kicked_while_it_rolls_rolls_again(shape: str, c: float, J: float, height: float, way: str) -> None:
    """By the angular momentum about the floor, which no friction changes: (1 + c) m v = (1 + c) m u + J (1 + h/R)."""
    m, R, u, mu, g = 2.0, 0.1, 3.0, 0.2, 9.8
    spot = {0.0: "center", 1.0: "top", -1.0: "bottom"}[height]
    kick = way if J > 0 else {"right": "left", "left": "right"}[way]
    found = solve(f"""
title: Kick against what rolls
given: {{m: {m} kg, R: {R} m, u: {u} m/s, J: {abs(J)} N s, mu: {mu}}}
surfaces: {{floor: level}}
bodies: {{wheel: {{shape: {shape}, mass: m, radius: R, moves: {way}, turns: {"clockwise" if way == "right" else "counterclockwise"}}}}}
connections: {{base: {{contact: [wheel, floor], friction: mu}}}}
states: {{before: {{base: rolls, wheel.velocity: u}}, after: {{}}, end: {{base: rolls}}}}
events: {{kick: {{impulse: J, on: wheel.{spot}, direction: {kick}, from: before, to: after}}}}
find: {{v: wheel.velocity at end, t: time from after to end, x: wheel.displacement from after to end}}
""")
    start, end = u + J / m, u + J * (1 + height) / (m * (1 + c))
    t = abs(end - start) / (mu * g)
    told = {name: answer.float for name, answer in found.answers.items()}
    assert told == pytest.approx({"v": end, "t": t, "x": (start + end) / 2 * t})
    assert all(item.holds for item in found.derivation.confirmed)
