"""Names: what the quantities of a motion are called, and how one that can not be simulated is refused."""

from __future__ import annotations

from rotsolve.core.registry import SEPARATOR, Registry
from rotsolve.inquiry.questions import NotYet
from rotsolve.simulation.tape.series import needed
from rotsolve.simulation.tape.tape import Tape, Unwritable


def key(word: str, owner: str, when: str, component: str = "") -> str:
    return SEPARATOR.join((word, owner, component, when))


def letters_in(tape: Tape, *places: int) -> set[str]:
    """The letters on which values rest."""
    found = (tape.operations[place] for place in needed(tape, places))
    return {operation.name for operation in found if operation.kind == "letter"}


def component_of(letter: str) -> str:
    return letter.split(SEPARATOR)[2]


def path(letter: str) -> str:
    """The name of a quantity as the scene language writes it: `block.velocity`, `pivot.force.x`, `string.block.tension`."""
    word, owner, component, _ = letter.split(SEPARATOR)
    if word == "tension" and component:
        return f"{owner}.{component}.{word}"
    return ".".join(filter(None, (owner, word, component)))


def said(letter: str, registry: Registry) -> str:
    """A quantity in words."""
    return f"`{path(letter)}`" if letter in registry.quantities else f"value of `{letter}`"


def refusal(error: Unwritable, registry: Registry) -> NotYet:
    """What can not be simulated, by its name."""
    letter = str(error)
    if letter in registry.quantities:
        return NotYet(f"how `{path(letter)}` runs in time is not told")
    if SEPARATOR not in letter and " " not in letter:
        return NotYet(f"`{letter}` has no number", help=f"give it one, or say --set {letter}=…")
    return NotYet(f"{letter} is not simulated yet")
