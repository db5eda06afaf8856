"""Chains of rods drawn at random and struck: by blows, by balls, by what is fixed in their way, one or two at once, held against the
momenta of all bodies, written here."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, field

import numpy as np
import pytest

from linked import Array, Bodies, direction
from rotsolve import Unsolvable, solve

SCENES = 48
RIGHT, UP = direction(0), direction(math.pi / 2)
PULLS = "would have to pull each other"


@dataclass
class Chain:
    """Jointed rods, at rest or gliding, on a post or free, with what meets them; the same as a scene and as bodies."""

    held: bool
    rods: list[tuple[float, float, int]]  # mass, length, angle in degrees
    speed: tuple[float, float] = (0.0, 0.0)
    balls: list[str] = field(default_factory=list)
    events: list[str] = field(default_factory=list)
    pushes: list[tuple[str, Array, Array]] = field(default_factory=list)
    hits: list[tuple[str, list[tuple[str, Array, Array]], float]] = field(default_factory=list)
    before: dict[str, Array] = field(default_factory=dict)
    told: list[str] = field(default_factory=list)
    bodies: Bodies = field(default_factory=Bodies)

    def __post_init__(self) -> None:
        place = np.zeros(2)
        self.starts = []
        for number, (mass, length, angle) in enumerate(self.rods):
            way = length * direction(math.radians(angle))
            self.starts.append(place)
            self.bodies.add(f"r{number}", mass, mass * length**2 / 12, place + way / 2)
            self.before[f"r{number}"] = np.array([*self.speed, 0.0])
            if number:
                self.bodies.pin(f"p{number}", place, f"r{number}", f"r{number - 1}")
            place = place + way
        if self.held:
            self.bodies.pin("post", np.zeros(2), "r0")

    def spot(self, number: int, at: float) -> Array:
        """The point of a rod at a share of its length."""
        _, length, angle = self.rods[number]
        return self.starts[number] + at * length * direction(math.radians(angle))

    def blow(self, name: str, number: int, at: float, way: Array, size: float) -> None:
        spot = f"r{number}.at({at * self.rods[number][1]!r} m)"
        self.event(name, f"impulse: {size} N s, on: {spot}, direction: {way.tolist()}")
        self.pushes.append((f"r{number}", self.spot(number, at), size * way / math.hypot(*way)))

    def ball(self, name: str, number: int, at: float, word: str, size: tuple[float, float, float]) -> None:
        """A ball that comes along a line: its mass, its speed, e."""
        mass, speed, bounce = size
        way, place = {"right": RIGHT, "up": UP, "left": -RIGHT, "down": -UP}[word], self.spot(number, at)
        self.bodies.add(f"b{name}", mass, 1e-15, place)
        self.before[f"b{name}"] = np.array([*(speed * way), 0.0])
        self.balls.append(f"b{name}: {{mass: {mass} kg, moves: {word}}}")
        self.told.append(f"b{name}.velocity: {speed} m/s")
        self.event(name, f"collides: [b{name}, r{number}.at({at * self.rods[number][1]!r} m)], restitution: {bounce}")
        self.hits.append((name, [(f"r{number}", place, way), (f"b{name}", place, -way)], bounce))

    def stop(self, name: str, number: int, at: float, bounce: float) -> None:
        """A smooth floor or wall in the way of a point."""
        surface, way = ("floor", UP) if self.speed[1] < 0 else ("side", -RIGHT)
        self.event(name, f"collides: [r{number}.at({at * self.rods[number][1]!r} m), {surface}], restitution: {bounce}")
        self.hits.append((name, [(f"r{number}", self.spot(number, at), way)], bounce))

    def event(self, name: str, what: str) -> None:
        self.events.append(f"{name}: {{{what}, from: before, to: after}}")

    def scene(self) -> str:
        names = range(len(self.rods))
        rods = [f"r{k}: {{shape: rod, mass: {m} kg, length: {b} m}}" for k, (m, b, _) in enumerate(self.rods)]
        joints = [f"p{k}: {{hinge: [r{k - 1}.end, r{k}.start]}}" for k in names if k]
        joints += ["post: {hinge: r0.start}"] if self.held else []
        still = any(self.speed)
        told = [f"r{k}.angle: {angle} deg" for k, (_, _, angle) in enumerate(self.rods)] + self.told
        told += (
            [f"r{k}.angular_velocity: 0" for k in names]
            if still
            else [f"at rest: [{', '.join(f'r{k}' for k in names)}]"]
        )
        told += [f"r0.velocity: [{self.speed[0]} m/s, {self.speed[1]} m/s]"] if still else []
        asked = [f"w{k}: r{k}.angular_velocity at after" for k in names]
        asked += [
            f"x{k}: p{k}.impulse.x during {self.first}, y{k}: p{k}.impulse.y during {self.first}" for k in names if k
        ]
        asked += [f"h: post.impulse.x during {self.first}"] if self.held else []
        for name, _, _ in self.hits:
            asked.append(f"J{name}: size of {name}.impulse during {name}, W{name}: {name}.work during {name}")
        asked.append("Q: lost kinetic_energy from before to after")
        return (
            "title: Chain\nplane: horizontal\nsurfaces: {floor: level, side: {wall: right}}\n"
            f"bodies: {{{', '.join([*rods, *self.balls])}}}\n"
            f"connections: {{{', '.join(joints)}}}\nstates: {{before: {{{', '.join(told)}}}, after: {{}}}}\n"
            f"events: {{{', '.join(self.events)}}}\nfind: {{{', '.join(asked)}}}\n"
        )

    @property
    def first(self) -> str:
        return self.events[0].partition(":")[0]

    def truth(self) -> dict[str, float]:
        before = np.concatenate([self.before[name] for name in self.bodies.names])
        after, impulses = self.bodies.bounced(before, self.pushes, self.hits)
        found = {f"w{k}": float(after[3 * self.bodies.names.index(f"r{k}") + 2]) for k in range(len(self.rods))}
        for k in range(1, len(self.rods)):
            found |= {f"x{k}": impulses[f"p{k}.x"], f"y{k}": impulses[f"p{k}.y"]}
        found |= {"h": impulses["post.x"]} if self.held else {}
        for name, parts, _ in self.hits:
            mean = float(self.bodies.row(parts) @ (before + after)) / 2
            found |= {f"J{name}": impulses[name], f"W{name}": impulses[name] * mean}
        return found | {"Q": self.bodies.energy(before) - self.bodies.energy(after)}


def drawn(number: int) -> Chain:
    """A chain and one or two blows at once."""
    draw = random.Random(f"struck {number}")
    rods = [
        (draw.choice((1.0, 2.0, 0.5)), draw.choice((0.4, 0.5, 1.0)), 15 * draw.randrange(-11, 13))
        for _ in range(draw.choice((1, 2, 2, 3)))
    ]
    gliding = draw.random() < 0.35
    speed = draw.choice(((1.0, 0.0), (-2.0, -3.0), (2.0, -1.0))) if gliding else (0.0, 0.0)
    chain = Chain(not gliding and draw.random() < 0.6, rods, speed)
    for name in ("one", "two")[: draw.choice((1, 2))]:
        body, at = draw.randrange(len(rods)), draw.choice((0.25, 0.5, 0.75, 1.0))
        if gliding:
            chain.stop(name, body, at, draw.choice((0.0, 0.5, 1.0)))
        elif draw.random() < 0.4:
            way = np.array([draw.choice((1.0, -2.0, 0.5)), draw.choice((0.0, 1.0, -1.5))])
            chain.blow(name, body, at, way, draw.choice((1.0, 2.5)))
        else:
            size = (draw.choice((0.2, 1.0)), draw.choice((2.0, 5.0)), draw.choice((0.0, 0.6, 1.0)))
            chain.ball(name, body, at, draw.choice(("right", "up", "left", "down")), size)
    return chain


@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", range(SCENES))
def test_a_struck_chain_keeps_the_momenta(number: int) -> None:
    """What is answered is right; a blow that would have to pull is refused."""
    chain = drawn(number)
    try:
        truth = chain.truth()
    except np.linalg.LinAlgError:
        with pytest.raises(Unsolvable):
            solve(chain.scene())
        return
    if any(truth[f"J{name}"] < -1e-9 for name, _, _ in chain.hits):
        with pytest.raises(Unsolvable, match=PULLS):
            solve(chain.scene())
        return
    solution = solve(chain.scene())
    found = {name: answer.float for name, answer in solution.answers.items()}
    assert not solution.derivation.refused and all(item.holds for item in solution.derivation.confirmed)
    assert found == pytest.approx(truth, rel=1e-8, abs=1e-9)
