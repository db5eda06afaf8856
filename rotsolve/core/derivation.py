"""Derivation: what a solution says, as data. Its page is made by rotsolve.page.

`Words` mix prose and formulas, so that every output format sets the formulas in its own way.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import ONE, ZERO, Formula
from rotsolve.core.faults import Fault
from rotsolve.core.vectors.tensor import AXES, ENTRIES, ROWS

if TYPE_CHECKING:
    from rotsolve.algebra.certified.ball import Certified
    from rotsolve.algebra.units.dimension import Dimension
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.core.letters import Given

Words = tuple["str | Formula", ...]
NEXT = "\n"  # a part of the remark of a law behind which another sentence begins
SHOWN = "\t"  # a part of a sentence that stands before and behind what has a line of its own


def in_a_row(letters: Iterable[Formula]) -> Words:
    """a, T, N."""
    words: list[str | Formula] = []
    for letter in letters:
        words += [", ", letter] if words else [letter]
    return tuple(words)


def direction_in_words(way: tuple[Formula, ...]) -> Words:
    """A direction by its components: "x", "−y", or "(p, q, 1)"."""
    parts = [(axis, part) for axis, part in zip(AXES, way, strict=False) if part != ZERO]
    if len(parts) == 1 and parts[0][1] in (ONE, -ONE):
        axis, part = parts[0]
        return (axis if part == ONE else f"−{axis}",)
    return ("(", *in_a_row(way), ")")


def sentences(words: Words) -> tuple[Words, ...]:
    """The sentences of a remark."""
    found: list[Words] = [()]
    for part in words:
        if part == NEXT:
            found.append(())
        else:
            found[-1] = (*found[-1], part)
    return tuple(found)


def in_lines(sentence: Words) -> tuple[Words, ...]:
    """The lines of a sentence, in which what has one of its own keeps its sign before it; signs behind nothing are left out."""
    found: list[Words] = [()]
    for part in sentence:
        if part != SHOWN:
            found[-1] = (*found[-1], part)
        else:
            found.append(() if found[-1][:1] == (SHOWN,) else (SHOWN,))
    return tuple(line for line in found if line not in ((), (SHOWN,)))


class Equality(Struct, frozen=True):
    """left = right, each as written; `relation` may also be ≤, ≥, <, >, ≈ or ≠."""

    left: Formula
    right: Formula
    relation: str = "="


class ForceLine(Struct, frozen=True):
    """The forces on one body in words ("weight m g, down"), its declared positive sense, and remarks in brackets.

    `turned` is the only force that has a torque where a law for the rotation of the body is written, by noun and letter, if it is unknown.
    """

    body: str
    forces: tuple[Words, ...]
    positive: str = ""
    remarks: tuple[Words, ...] = ()
    turned: tuple[str, Formula] | None = None


class LawLine(Struct, frozen=True):
    """One numbered equation with the law or rule that it states: "Newton's second law, block"; `remark` in brackets.

    `name` is the identity of the law, `family` one of those that `--law` may name, or '' for rules and definitions.
    """

    number: int
    law: str
    equation: Equality
    remark: Words = ()
    name: str = ""
    family: str = ""
    bodies: tuple[str, ...] = ()


class Cited(Struct, frozen=True):
    """What a step uses: a letter as the equation of some number tells it; "" and the letter alone for an answer found before."""

    letter: Formula | None
    mark: str = ""


class Move(Struct, frozen=True):
    """One step of algebra: `sources` ("(3) and (4) in (2)"), the chain of equalities that it gives, its number if used later.

    `reason` says why where a choice is made ("the rod turns clockwise: ω < 0"). What is `put` into which equation stands there letter by
    letter; nothing for what is no step of that kind. Of an equation solved before, `another` root is meant. `divisor` is the equation by
    which it was divided. Behind what is put in, several letters that hang on others, `alone` is all that is unknown; where one
    equation is divided by another it is what cancels.
    """

    sources: str
    chain: tuple[Equality, ...]
    number: int | None = None
    reason: Words = ()
    put: tuple[Cited, ...] = ()
    into: str = ""
    another: bool = False
    divisor: str = ""
    alone: Formula | None = None


class Section(Struct, frozen=True):
    """What belongs to one instant, phase or event: forces, laws, algebra, in the order in which a textbook shows them.

    `title` is empty where the scene has one instant only. `remarks` are sentences such as why energy is conserved. What is `supposed` is
    shown not to be so: the letters have other values there. Of letters it holds in a `case`, under these conditions.
    """

    title: str
    forces: tuple[ForceLine, ...] = ()
    remarks: tuple[Words, ...] = ()
    laws: tuple[LawLine, ...] = ()
    moves: tuple[Move, ...] = ()
    supposed: bool = False
    case: tuple[Equality, ...] = ()


class Answer(Struct, frozen=True):
    """An asked quantity: exact form, certified value in `unit`, and its direction in words.

    `formula` is None where no closed form exists; `value`, signed like it, is None where a given has no number. `direction` is that of
    the value with its sign ("−12.73 rad/s² (clockwise)"), and `positive` that of a positive value where a negative one has another.
    `components` hold the parts of a vector answer, whose `formula` and
    `value` are the size; `angle` is that of a slanted vector to the horizontal, in degrees; `brief` vectors are told by
    size and direction alone where people read. `closed` is the closed form in givens alone; `formula` may hold other answers.
    Of letters it holds under `conditions`; `otherwise` has the answers under others. `weighed` is what a choice compared, in its order;
    `until` is the state on the way up to which a function of time holds. Of a letter of the scene `rivals` are other roots of the equation
    that gave it. Of letters that leave its direction open `pointing` says with which it is which: "right if R > r". `leading` is what it
    comes to where a letter is small beside another, as the scene assumes.
    """

    name: str
    symbol: Formula
    formula: Formula | None
    value: Certified | None
    unit: Unit | None
    dimension: Dimension | None
    direction: str = ""
    word: str = ""
    components: tuple[Answer, ...] = ()
    remark: Words = ()
    angle: Certified | None = None
    brief: bool = False
    closed: Formula | None = None
    positive: str = ""
    conditions: tuple[Equality, ...] = ()
    otherwise: tuple[Answer, ...] = ()
    weighed: tuple[Formula, ...] = ()
    until: str = ""
    rivals: tuple[Formula, ...] = ()
    pointing: Words = ()
    leading: Words = ()

    @property
    def rows(self) -> tuple[tuple[Answer, ...], ...]:
        """The entries of a matrix row by row, of a vector without a size as its only row; nothing for other answers."""
        parts = {part.name: part for part in self.components}
        if self.formula is not None or self.value is not None:
            return ()
        if set(parts) == set(ENTRIES):
            return tuple(tuple(parts[name] for name in row) for row in ROWS)
        return (self.components,) if self.components else ()


class Check(Struct, frozen=True):
    """One confirmation, or one objection when `holds` is False; None where it could not be decided. `label` says how it failed.

    What is said of a letter that is `vanishing` goes for a case that holds however small it is, of one that is `growing` however large.
    What is a `limit` stands by itself. A second way goes by a `law` of FAMILIES; what is `bare` says that all agrees, and
    shows nothing of it. `more` says that letters have more cases, which are not worked out. An objection that is `beyond` is about
    what comes after all that the answers tell, and says nothing against them.
    """

    words: Words
    holds: bool | None = True
    label: str = ""
    vanishing: str = ""
    growing: str = ""
    limit: bool = False
    law: str = ""
    bare: bool = False
    more: bool = False
    beyond: bool = False


class AnswerConfirmation(Struct, frozen=True):
    """What the independent assembly says of an answer: it `holds`, it does not, or None: not confirmed, and `why`.

    `answered` and `found` are the numbers of the answer and of the assembly in SI units, entry by entry of a vector. `astray` are
    numbers of letters, within what is printed with the answer, with which the motion does not come to what is asked. `also` tells of a
    value against the sense of a letter that makes it so as well, and of an approximation how near it comes. Of one that is `rivalled`
    another value does as well: nothing is wrong with the way to it, and others stand beside it.
    """

    name: str
    holds: bool | None
    why: str = ""
    answered: tuple[float, ...] = ()
    found: tuple[float, ...] = ()
    astray: bool = False
    also: str = ""
    rivalled: bool = False


class Trial(Struct, frozen=True):
    """One way in which what rubs was supposed to move at the start of a phase, what that gave, and whether it can be so.

    `supposed` names what rubs, each with its motion; `found` says what tells, in letters of the givens; `holds` is None where it does not.
    """

    supposed: tuple[tuple[str, str], ...]
    found: tuple[Words, ...]
    holds: bool | None
    why: str = ""


class Refusal(Struct, frozen=True):
    """A question without an answer, by its name under `find`: why, where, and what may help."""

    name: str
    fault: Fault


class Derivation(Struct, frozen=True):
    """The whole solution of a problem; `trials` are those that decided how everything moves that rubs.

    `refused` are the questions that have no answer; they take no other with them.
    `places` are those of the points on bodies, `events` what happens at each.
    `confirmed` says of each answer whether an assembly of all bodies' equations gives the same; nothing where nobody asked. `insights` are
    sentences about what the answers say, `second` finds one of them once more in a way of its own.
    """

    title: str
    source: str
    givens: tuple[Given, ...]
    finds: tuple[Words, ...]
    states: tuple[Words, ...]
    conventions: tuple[Words, ...]
    sections: tuple[Section, ...]
    answers: tuple[Answer, ...]
    checks: tuple[Check, ...]
    equations_written: int = 0
    equations_used: int = 0
    trials: tuple[Trial, ...] = ()
    refused: tuple[Refusal, ...] = ()
    confirmed: tuple[AnswerConfirmation, ...] = ()
    insights: tuple[Words, ...] = ()
    second: tuple[Section, ...] = ()
    places: tuple[Words, ...] = ()
    events: tuple[Words, ...] = ()
