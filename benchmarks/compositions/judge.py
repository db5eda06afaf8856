"""Judge: what became of a composition, and whether the same scene said in other ways is answered the same."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from fractions import Fraction

from compositions import freed
from compositions.compose import drawn
from compositions.relations import LAWS, RELATIONS
from rotsolve.scene.read import read_source, read_text
from rotsolve.search.complete import unsolved
from trials.outcome import BAD, INTERNAL, NOT_YET, OBJECTED, SOLVED, UNSOLVABLE, Outcome, Printed, outcome
from trials.reflect import not_mirrored, reflected
from trials.scene import Scene, written
from trials.trial import Result

DIGITS = 7
LIMIT = 2.0  # seconds of CPU that a scene may take
CLOSE = Fraction(1, 10**5)  # relative: answers are printed to 7 figures
LETTERED = "in letters, with the numbers put in"
REFLECTED = "with its angles in a mirror"
IDLE = "says nothing here"
ON_THE_WAY = (
    "lets go", "turns back", "meet again", "comes back", "tips over", "on the way from", "an end of its round side", "is not reached:",
)  # fmt: skip
FALSE_WORDS = ("contradict", "too little is known", "never reached")
RIGHT, UNCONFIRMED, NAMED, UNTRUE, UNTELLABLE, SAID, SILENT, SLOW, BROKEN = (
    "right",
    "not confirmed",
    "refused by name",
    "refused falsely",
    "refused, and the assembly has no answer either",
    "wrong and said",
    "wrong and silent",
    "too slow",
    "broken",
)
Retold = Callable[[Scene, Outcome, random.Random], Iterator[str]]
VERDICTS = (RIGHT, UNCONFIRMED, NAMED, UNTRUE, UNTELLABLE, SAID, SILENT, SLOW, BROKEN)


def run(seed: int, number: int) -> Result:
    """Compose the scene of a number, solve it, and judge: the verdict is its outcome, the reason its only fault."""
    choice, scene = drawn(seed, number)
    found = outcome(written(scene), DIGITS)
    verdict, why = judged(scene, found, random.Random(f"relations-{seed}-{number}"))
    return Result(number, ", ".join(choice), verdict, found.seconds, (why,) if why else (), written(scene))


def judged(scene: Scene, found: Outcome, chance: random.Random, retold: Retold | None = None) -> tuple[str, str]:
    """The verdict about a scene, with its reason; `retold` says how it is answered otherwise when it is said otherwise."""
    if found.kind == BAD and IDLE in found.message:
        return NAMED, found.message.splitlines()[0]
    if found.kind in (INTERNAL, BAD):
        return BROKEN, found.message.splitlines()[0]
    if found.seconds > LIMIT:
        return SLOW, f"{found.seconds:.1f} s"
    if found.kind in (NOT_YET, UNSOLVABLE):
        return refused(found.message, scene, list(scene["find"]))
    differing = next((retold or differences)(scene, found, chance), "")
    if differing:
        return SILENT, differing
    assert found.solution is not None
    for name, reason in found.solution.refused.items():  # one question of several
        return refused(str(reason), scene, [name])
    unsure = unconfirmed(found)
    return (UNCONFIRMED, unsure) if unsure else (RIGHT, "")


def refused(message: str, scene: Scene, names: list[str]) -> tuple[str, str]:
    """The verdict about a refusal: what the assembly contradicts, what is missing by its name, or what is said to be wrong with the scene:
    falsely where the assembly answers it."""
    said = message.splitlines()[0]
    if "not confirmed" in said:  # with what happens on the way, or without a word of why
        return (NAMED if any(word in said for word in ON_THE_WAY) else SAID), said
    if not any(word in said for word in FALSE_WORDS):
        return NAMED, said
    return (UNTRUE if answered_by_assembly(scene, names, said) else UNTELLABLE), said


def answered_by_assembly(scene: Scene, names: list[str], message: str) -> bool:
    """Whether the independent assembly finds all of some questions by itself: the scene is complete.

    Lines that are said to contradict each other have to hold in it.
    """
    contradictory = "contradict" in message or "never reached" in message
    return unsolved(read_source(written(scene) + "\n"), names, None, whole=contradictory) is not None


def unconfirmed(found: Outcome) -> str:
    """What the checks say is not confirmed."""
    assert found.solution is not None
    open_ = (item for item in found.solution.derivation.confirmed if item.holds is None)
    return next((f"not confirmed: {item.why}" for item in open_), "")


def differences(scene: Scene, found: Outcome, chance: random.Random) -> Iterator[str]:
    """How the scene said in one other way, drawn at random, or by another law, is answered otherwise."""
    names = [*RELATIONS, *LAWS, LETTERED, REFLECTED]
    name = chance.choice(names)
    if name == LETTERED:
        lettered = freed.differences(read_text(written(scene) + "\n"))
        yield from (f"{name}: {text}\n{written(scene)}" for text in lettered if not text.startswith(freed.REFUSED))
        return
    if name == REFLECTED:
        other = reflected(scene)
        yield from not_mirrored(found, outcome(written(other), DIGITS), scene) if other is not None else ()
        return
    if name in LAWS:
        yield from differing(found, outcome(written(scene), DIGITS, law=name), f"by {name}", scene)
        return
    for other in RELATIONS[name](scene, chance):
        yield from differing(found, outcome(written(other), DIGITS), name, other)


def differing(one: Outcome, other: Outcome, name: str, scene: Scene) -> Iterator[str]:
    """What two outcomes that must be the same do not have in common."""
    if other.kind not in (SOLVED, OBJECTED):
        assert one.solution is not None
        if set(scene["find"]) <= set(one.solution.refused):
            return
        if other.kind in (INTERNAL, BAD) or name in ("each question alone", "in another order", "by other names"):
            yield f"{name}: {other.message.splitlines()[0]}\n{written(scene)}"
        return
    for key, value in other.answers.items():
        if key in one.answers and apart(one.answers[key], value):
            yield f"{name}: {key} = {value.text} instead of {one.answers[key].text}\n{written(scene)}"


def apart(one: Printed, other: Printed) -> bool:
    """Whether two printed numbers differ by more than their last figures."""
    if one.number is None or other.number is None:
        return False
    return abs(one.number - other.number) > CLOSE * max(abs(one.number), abs(other.number), Fraction(1, 10**9))
