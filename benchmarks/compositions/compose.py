"""Compose: one body or two, held, joined, driven, told of and asked in the ways that the language has; a scene for each choice.

A scene is drawn from six tables: what the first body is, how it is held, what is joined to it, what acts, what the states say, and what is
asked. What can not be (sense.py) is drawn again, but for one in ten, so that it is refused rightly is tried too. `covering` draws so that
every pair of entries of two tables comes soon.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import combinations, count

from compositions.acted import ACTS
from compositions.asked import ASKED, asked
from compositions.body import KINDS
from compositions.held import HOLDS
from compositions.joined import JOINS
from compositions.parts import Composition
from compositions.sense import makes_sense
from compositions.told import TOLD
from trials.scene import Scene

TABLES: dict[str, tuple[str, ...]] = {
    "body": tuple(kind.word for kind in KINDS),
    "held": tuple(HOLDS),
    "joined": tuple(JOINS),
    "acted": tuple(ACTS),
    "told": tuple(TOLD),
    "asked": tuple(ASKED),
}
SENSELESS = 0.1  # share of the scenes that can not be that is kept
Choice = tuple[str, ...]  # one entry of each table


class Unfit(ValueError):
    """Entries that make no scene together: a particle on an axle, a question about a string where there is none."""


def composed(choice: Choice, chance: random.Random) -> Scene:
    """The scene of one entry of each table; raises Unfit where they make none."""
    body, held, joined, acted, told, question = choice
    if senseless(body, held, joined) and chance.random() > SENSELESS:
        raise Unfit(choice)
    composition = Composition(chance)
    kind = next(kind for kind in KINDS if kind.word == body)
    composition.add(kind, "one")
    if HOLDS[held](composition, "one") is False:
        raise Unfit(choice)
    if any(made(composition) is False for made in (JOINS[joined], ACTS[acted], TOLD[told])):
        raise Unfit(choice)
    if not asked(composition, question):
        raise Unfit(choice)
    return composition.scene(", ".join(choice))


def senseless(body: str, held: str, joined: str) -> bool:
    """Whether nothing tells how the bodies move: without mass, or kept by a word alone on a line from which they would turn."""
    if body == "light rod" and joined not in ("welded", "hinged", "mounted"):
        return True
    return held in ("hangs", "spring") and (body == "loaded wheel" or joined in ("welded", "hinged"))


def drawn(seed: int, number: int) -> tuple[Choice, Scene]:
    """The scene of a number: entries at random until they make one."""
    chance = random.Random(f"compositions-{seed}-{number}")
    while True:
        choice = tuple(chance.choice(table) for table in TABLES.values())
        try:
            scene = composed(choice, chance)
        except Unfit:
            continue
        if makes_sense(scene) or chance.random() < SENSELESS:
            return choice, scene


def covering(seed: int, tries: int = 8) -> Iterator[tuple[Choice, Scene]]:
    """Scenes without end; of several drawn, the one with most pairs of entries that have not come yet."""
    seen: set[tuple[tuple[int, str], ...]] = set()
    for start in count(step=tries):
        best = max(
            (drawn(seed, start + number) for number in range(tries)), key=lambda found: len(pairs(found[0]) - seen)
        )
        seen |= pairs(best[0])
        yield best


def pairs(choice: Choice) -> set[tuple[tuple[int, str], ...]]:
    """All pairs of its entries, each with its table."""
    return set(combinations(enumerate(choice), 2))
