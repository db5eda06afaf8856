"""Whatever a file holds, reading it ends soon and with a Problem or a SceneError."""

import os
import random
import time

from rotsolve.core.faults import SceneError
from rotsolve.scene.read import read_text

RUNS = int(os.environ.get("ROTSOLVE_FUZZ", "10000"))
SEEDS = [
    """title: Two blocks
given: {m: 2 kg, M: 5 kg, R: 0.2 m, mu: 0.3, beta: 30 deg, k: 40 N/m, x: unknown, F: 3 N, t1: 1 s}
surfaces: {ramp: {slope: beta, down: left}, floor: level, side: {wall: left}}
bodies:
  block: {mass: m, moves: up}
  wheel: {shape: disc, mass: M, radius: 20 cm, turns: clockwise, points: {P: [R/2, 0]}}
  drum: {inertia: 2 kg m^2, radii: {big: R, small: R/2}}
  rod: {shape: rod, mass: 3 kg, length: 2*R, parts: {bob: {mass: m, at: [0, 3 cm]}}}
connections:
  pin: {hinge: rod.start}
  axle: {axle: wheel, friction_torque: 2 N m}
  base: {contact: [block, ramp], friction: {static: 0.4, kinetic: mu}}
  cord: {string: [block, wheel.rim, drum.small], under: [wheel]}
  coil: {spring: [ground, block], stiffness: k}
actions: {push: {force: F*time/t1, on: rod.at(R/3), direction: [1, 2]}, twist: {couple: 2 N m, on: drum}}
states:
  start: {at rest: all, rod.angle: 90 deg, wheel.angular_velocity: 3 rad/s}
  end: {base: slips, rod.angle: 0, time: 2 s}
  after: {}
events: {hit: {collides: [block, rod.end], restitution: 0.5, from: end, to: after}}
find:
  a: size of block.acceleration/wheel.angular_acceleration at start in cm
  f: (lost kinetic_energy during hit)/(kinetic_energy at end)
  t: time from start to end
answers: {a: 2*m/M, f: {value: 3 %, tolerance: 1 %}}
""",
    "bodies: {a: {shape: rod, length: 2 m}}\nconnections: {pin: {hinge: a.start}}\nfind: {T: a.inertia about pin}\n",
]
ALPHABET = "abmRxyz019.,:;{}[]()*/+-^#&|>!%@`'\"?~ \n\t\\_=<°π²é\u202e"
WORDS = [
    "rod",
    "wheel.rim",
    "at",
    "from",
    "to",
    "in",
    "where",
    "about",
    "2 m",
    "3 kg",
    "unknown",
    "none",
    "at rest",
    "m",
    "M",
    "- ",
    ": ",
    "{",
    "}",
    "[",
    "]",
]
WORDS += [
    "1e999",
    "9^9^9",
    "0/0",
    "<<",
    "*a",
    "&a",
    "!!python/object:x",
    "---",
    "size of",
    "lost",
    "time",
    "g",
    "(",
    ")",
    ".at(",
    "\n",
    "  ",
    "at(at(",
    "rod.at(x).velocity",
]


def mutated(chance: random.Random, text: str) -> str:
    """The text with a few places changed."""
    for _ in range(chance.randint(1, 4)):
        place = chance.randrange(len(text) + 1)
        until = min(len(text), place + chance.choice((0, 0, 1, 2, 5, 20)))
        kind = chance.random()
        if kind < 0.4:
            put = chance.choice(ALPHABET)
        elif kind < 0.8:
            put = chance.choice(WORDS)
        else:
            start = chance.randrange(len(text) + 1)
            put = text[start : start + chance.randint(1, 30)]
        text = text[:place] + put + text[until:]
    return text


def random_text(chance: random.Random) -> str:
    parts = [
        chance.choice(ALPHABET) if chance.random() < 0.6 else chance.choice(WORDS) for _ in range(chance.randint(0, 60))
    ]
    return "".join(parts)


def outcome(text: str, settings: dict[str, str] | None = None) -> str:
    """The messages of a text; it must not end in anything but a Problem or a SceneError, nor take long."""
    start = time.process_time()
    try:
        read_text(text, settings=settings)
        message = ""
    except SceneError as error:
        assert error.faults
        message = str(error)
    assert time.process_time() - start < 10, text[:200]
    return message


def test_seeds_are_sound() -> None:
    for seed in SEEDS:
        assert outcome(seed) == ""


def test_mutated_scenes_and_random_texts() -> None:
    chance = random.Random(7)
    for number in range(RUNS):
        text = (
            random_text(chance)
            if number % 5 == 4
            else mutated(chance, chance.choice(SEEDS[:1] if number % 3 else SEEDS))
        )
        for character in outcome(text):
            assert character == "\n" or character.isprintable()


def test_settings_of_any_kind() -> None:
    chance = random.Random(11)
    for _ in range(RUNS // 20):
        outcome(SEEDS[0], {"m": random_text(chance)})


def test_hostile_sizes_end_soon() -> None:
    bomb = "a: &a [x, x]\n" + "\n".join(f"a{n}: &a{n} [*a, *a]" for n in range(30))
    chain = "given: {" + ", ".join(f"a{n}: a{n + 1}*a{n + 1}" for n in range(300)) + ", a300: 2}\n"
    cases = [
        bomb,
        "[" * 100_000,
        "{a: " * 50_000,
        "- " * 100_000,
        "a: " + "x" * 900_000,
        "find: {a: " + "(" * 900 + "}",
        "find: {a: " + "-" * 990 + "b}",
        "given: {a: " + "9" * 100_000 + "}",
        "given: {a: 9^9^9^9}",
        chain + "bodies: {b: {mass: a0}}\nfind: {x: a0}\n",
        "given:\n" + "".join(f"  a{n}: {n} kg\n" for n in range(30_000)),
        "bodies: {b: {" + "parts: {p: {" * 60 + "}" * 200,
        "a\n" * 300_000,
        "? " * 100_000,
        "'" * 200_001,
        "#" * 900_000,
        "find: {" + ", ".join(f"x{n}: rodd.end" for n in range(3000)) + "}",
    ]
    for text in cases:
        assert outcome(text)
