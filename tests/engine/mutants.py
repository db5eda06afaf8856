"""Mutants: scenes spoilt at random, from a seed: lines left out, values swapped, words changed, angles squared, masses gone."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.])")
ANGLE = re.compile(r"-?\d+(?:\.\d+)? deg\b")
MASS = re.compile(r"\d+(?:\.\d+)? k?g\b(?! m)")
WORD = re.compile(r"[A-Za-z_]\w*")
BODY = re.compile(r"^  (\w+): *\{", re.MULTILINE)
STATE = re.compile(r"^  (\w+): ", re.MULTILINE)
WORDS = (
    *("left", "right", "up", "down", "clockwise", "counterclockwise", "taut", "slack", "rolls", "slips", "sticks"),
    *("largest", "smallest", "all", "ground", "rim", "cm", "velocity", "acceleration", "angular_velocity", "tension"),
    *("angular_acceleration", "force", "normal_force", "friction_force", "kinetic_energy", "torque", "displacement"),
    *("rotation", "work", "angle", "unknown", "disc", "rod", "ring", "none", "any", "impulse", "power", "time"),
)
ASKED = (
    *("velocity", "speed", "acceleration", "angular_velocity", "angular_acceleration", "angle", "rotation"),
    *("displacement", "height", "position", "force", "torque", "tension", "normal_force", "friction_force", "impulse"),
    *("kinetic_energy", "potential_energy", "energy", "work", "power", "momentum", "angular_momentum", "inertia"),
    *("gyration", "radius", "length", "mass", "cm", "turns", "distance", "elongation", "stiffness", "friction"),
)
UNITS = {
    **{"velocity": "m/s", "angular_velocity": "rad/s", "displacement": "m", "angle": "deg", "rotation": "rad"},
    **{"acceleration": "m/s^2", "angular_acceleration": "rad/s^2"},
}


def without_line(chance: random.Random, text: str) -> str:
    lines = text.splitlines()
    del lines[chance.randrange(len(lines))]
    return "\n".join(lines) + "\n"


def replaced(chance: random.Random, text: str, pattern: re.Pattern[str], choices: tuple[str, ...]) -> str:
    found = list(pattern.finditer(text))
    if not found:
        return without_line(chance, text)
    place = chance.choice(found)
    return text[: place.start()] + chance.choice(choices) + text[place.end() :]


def swapped(chance: random.Random, text: str) -> str:
    found = list(NUMBER.finditer(text))
    if len(found) < 2:
        return without_line(chance, text)
    one, other = sorted(chance.sample(found, 2), key=lambda item: item.start())
    middle = text[one.end() : other.start()]
    return text[: one.start()] + other.group() + middle + one.group() + text[other.end() :]


def number(chance: random.Random, text: str) -> str:
    return replaced(chance, text, NUMBER, ("0", "1e-30", "1e30", "1e300", "90", "-1", "1/3"))


def angle(chance: random.Random, text: str) -> str:
    return replaced(chance, text, ANGLE, ("0 deg", "90 deg", "-90 deg", "180 deg", "89.9999 deg"))


def mass(chance: random.Random, text: str) -> str:
    return replaced(chance, text, MASS, ("0 kg", "1e9 kg", "1e-9 kg"))


def word(chance: random.Random, text: str) -> str:
    known = [item for item in WORD.finditer(text) if item.group() in WORDS]
    pattern = re.compile(rf"\b{chance.choice(known).group()}\b") if known else WORD
    return replaced(chance, text, pattern, WORDS)


def contradiction(chance: random.Random, text: str) -> str:
    """One more line in a state, of some body and some size."""
    body = chance.choice(BODY.findall(text) or ["block"])
    quantity = chance.choice(list(UNITS))
    line = f"{body}.{quantity}: {chance.choice(('0', '1', '-3', '1000'))} {UNITS[quantity]}"
    start = text.find("\nstates:")
    spots = [item.end() + start for item in re.finditer(r"\{(?=[^{}]*\})", text[start:])] if start >= 0 else []
    if spots:
        place = chance.choice(spots)
        return f"{text[:place]}{line}, {text[place:]}"
    return f"{text}\nstates: {{start: at rest, end: {{{line}}}}}\n"


def question(chance: random.Random, text: str) -> str:
    """Another question instead of all that are asked."""
    owner = chance.choice(STATE.findall(text) or ["block"])
    path = owner + chance.choice(("", "", "", ".cm", ".rim", ".end")) + "." + chance.choice(ASKED)
    path += chance.choice(("", "", "", ".x", ".tangential", ".net"))
    start = text.find("\nstates:")
    states = STATE.findall(text[start:]) if start >= 0 else []
    times = [
        "",
        "",
        *(f" at {state}" for state in states),
        *(f" from {one} to {two}" for one in states for two in states),
    ]
    modifier = chance.choice(("", "", "", "size of ", "change of ", "lost ", "mean ", "total ", "largest "))
    return text[: text.find("\nfind:")] + f"\nfind: {{q: {modifier}{path}{chance.choice(times)}}}\n"


CHANGES: tuple[Callable[[random.Random, str], str], ...] = (
    *(without_line, swapped, number, angle, mass, word),
    *(contradiction, contradiction, question, question),
)


def mutant(chance: random.Random, text: str) -> str:
    """A scene with one or two changes."""
    for _ in range(chance.choice((1, 1, 2))):
        text = chance.choice(CHANGES)(chance, text)
    return text
