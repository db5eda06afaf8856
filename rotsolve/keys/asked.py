"""Asked: what a problem asks, in plain words made of its scene where `ask` has none: "a, the acceleration of the bucket".

Nothing is said as the language writes it: a name is a word, or stands behind the word for what it names; what is on the verge of slipping
is told by the bodies that touch; of a question for several quantities at once the formula, with words for each.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Quotient, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import kind_of
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.core.quantity import OSCILLATING, QUANTITIES
from rotsolve.core.writing import spoken
from rotsolve.derivation.sought import SWINGS, moment_words, named, observed_in, part_asked
from rotsolve.keys.letters import words_of_letter
from rotsolve.keys.names import NameWords
from rotsolve.language.problem import Condition, Find, Option, Path, Problem, Term, WhichOf
from rotsolve.motion.timeline import timeline
from rotsolve.page.blocks import Math, Phrase, authored, joined_phrases

ONE_TERM = Symbol("#0")
TOUCHING = ("normal_force", "friction_force")  # forces that two bodies exert on each other where they touch
HOLDS = {"sticks": "does not slip", "rolls": "rolls without slipping"}  # what a contact does, as its body does it
KEEPS = {"stable": "is stable", "steady": "is steady"}
ORDERED = ("1", "2", "3")  # components that are told by their place
COMPARED = {"<": "<", ">": ">", "<=": "≤", ">=": "≥", "≤": "≤", "≥": "≥", "=": "="}


def asked_in_words(problem: Problem) -> dict[str, Phrase]:
    """What is asked, by the names under `find`."""
    words = AskedWords(problem)
    return {group: words.phrase(find) for group, find in words.first.items()}


class AskedWords:
    """Says what the questions of one problem ask."""

    def __init__(self, problem: Problem) -> None:
        self.problem, self.timeline = problem, timeline(problem)
        self.names = NameWords(problem)
        self.first: dict[str, Find] = {}
        for find in problem.finds:
            self.first.setdefault(find.group, replace(find, name=find.group))

    @cached_property
    def letters(self) -> frozenset[str]:
        return frozenset((*(given.name for given in self.problem.givens), *self.first))

    def phrase(self, find: Find) -> Phrase:
        """The letter of a question with what it stands for."""
        letter = Symbol(find.group)
        unit: Phrase = (", in ", authored(find.unit.text)) if find.unit is not None and find.unit.text else ()
        said = self.said(find)
        if said and isinstance(said[0], Math):
            return (Math((letter, "=", *said[0].parts)), *said[1:], *unit)
        return (letter, *((", ", *said) if said else ()), *unit)

    def said(self, find: Find) -> Phrase:
        """What a question asks; of an expression the formula first."""
        if find.choice is not None:
            return self.choice(find.choice)
        if find.where is not None:
            return (*self.sought(find), " for which ", *self.condition(find.where))
        return self.sought(find)

    def sought(self, find: Find) -> Phrase:
        """What is sought, whatever its condition."""
        if len(find.terms) == 1 and find.formula == ONE_TERM:
            return (self.quantity(find, find.terms[0]),)
        if find.terms or not isinstance(find.formula, Symbol):
            return self.expression(find)
        return self.letter(find, find.formula.name)

    def letter(self, find: Find, name: str) -> Phrase:
        """A letter by itself: what it stands for in the scene, or the quantity that another line asks for."""
        earlier = self.first.get(name)
        if earlier is not None and earlier.name != find.name and earlier.formula != find.formula:
            words: Phrase = (f"the {find.modifier} value of " if find.modifier else "", Symbol(name))
            return words if find.modifier else (Math((Symbol(name),)),)
        given = next((given for given in self.problem.givens if given.name == name), None)
        if given is not None and given.value is not None and not given.asked:  # in another unit
            return (Math((Symbol(name),)),)
        own = words_of_letter(self.problem, name, self.names, self.at_state)
        if own or find.modifier:
            return (f"the {' '.join(filter(None, (find.modifier, own or 'value')))}",)
        kind = kind_of(given.dimension) if given is not None and given.dimension is not None else None
        return () if kind is None else (kind.words,)

    # quantities

    def quantity(self, find: Find, term: Term) -> str:
        """One quantity with its article: the largest velocity of the block at the start."""
        return f"the {self.bare(find, term)}"

    def bare(self, find: Find, term: Term) -> str:
        """One quantity without its article."""
        if term.other is not None or term.modifier == "angle of":
            return self.of_two(find, term)
        if not term.path.owner and term.path.quantity in OSCILLATING:
            swings = term.modifier if term.modifier not in SWINGS else f"the {term.modifier}"
            return f"{OSCILLATING[term.path.quantity]} of {swings}{self.moment(term)}"
        if term.path.quantity in TOUCHING and (both := self.names.touching(term.path.owner)):
            word = f"{part_asked(find, term)}{spoken(term.path.quantity)}"
            return f"{word} between {both[0]} and {both[1]}{self.moment(term)}"
        asked = replace(find, where=None)
        part = part_asked(asked, term)
        word, owner = named(asked, term)
        if term.path.component in ORDERED:
            word = word.removesuffix("s")  # of the principal moments the first
        end = f" on the side of {self.names.thing(term.path.point)}" if term.path.point in self.names.bodies else ""
        return f"{self.names.worded(f'{part}{word}{owner}{observed_in(term)}')}{end}{self.moment(term)}"

    def of_two(self, find: Find, term: Term) -> str:
        """What is asked of two quantities: the angle between them, the ratio of their amplitudes."""
        assert term.other is not None
        if term.modifier == "angle of":
            sides = (replace(side, modifier="", other=None, at=None) for side in (term, term.other))
            one, other = (self.quantity(find, side) for side in sides)
            return f"angle between {one} and {other}{self.moment(term)}"
        one, other = (
            f"the {side.path.component} of {self.names.thing(side.path.owner)}" for side in (term, term.other)
        )
        return f"ratio of the amplitudes of {one} and {other} in {term.modifier}{self.moment(term)}"

    def moment(self, term: Term) -> str:
        """At which state, or between which; nothing of an event that is asked for itself."""
        if term.during is not None and term.during == term.path.owner:
            return ""
        return self.names.worded(moment_words(term, self.timeline))

    def at_state(self, path: Path, state: str) -> str:
        """A quantity at a state, as a line of that has it."""
        return self.bare(Find("", ONE_TERM, (Term(path),)), Term(path, at=state))

    # expressions

    def expression(self, find: Find) -> Phrase:
        """A formula of several quantities, and what its letters stand for; a ratio of two in words."""
        formula = find.formula
        if find.modifier == "size of" and isinstance(formula, Call):
            formula = formula.arguments[0]
        if formula == Quotient(Symbol("#0"), Symbol("#1")) and len(find.terms) == 2:
            plain = replace(find, modifier="")
            one, other = (self.quantity(plain, term) for term in find.terms)
            return (f"the ratio of {one} to {other}",)
        letters = dict(self.letters_of(find))
        formula = find.formula.substitute({place: Symbol(letter) for place, (letter, _) in letters.items()})
        meanings = dict(letters.values())
        where = joined_phrases(((Symbol(letter), f" is {said}") for letter, said in meanings.items()), "; ")
        return (Math((formula,)), *((", where ", *where) if where else ()))

    def letters_of(self, find: Find) -> Iterator[tuple[str, tuple[str, str]]]:
        """A letter for each quantity of an expression, and what it stands for."""
        known = dict[str, str]()
        for place, term in enumerate(find.terms):
            said = self.quantity(replace(find, modifier="", whole=""), term)
            if said not in known:
                known[said] = self.free(QUANTITIES[term.path.quantity].letter, [*known.values()])
            yield f"#{place}", (known[said], said)

    def free(self, letter: str, taken: list[str]) -> str:
        """A letter that stands for nothing yet."""
        names = (letter, *(f"{letter.rstrip('0123456789')}{number}" for number in range(1, 100)))
        return next(name for name in names if name not in self.letters and name not in taken)

    # conditions and choices

    def condition(self, condition: Condition) -> Phrase:
        """What has to hold: the ladder does not slip on the floor, the normal force of the wall is 0."""
        phrase = condition.phrase
        if phrase is None:
            if condition.word in HOLDS:
                return (self.names.at_contact(condition.owner, HOLDS[condition.word]),)
            state = spoken(condition.owner)
            return (f"the motion {KEEPS.get(condition.word or '', condition.word)}{self.state(state)}",)
        value = condition.value
        said = self.sought(phrase) if phrase.terms else (phrase.formula,)
        if value is None:
            return (*said, f" is {condition.word}")
        if isinstance(said[0], Math):  # an expression: f − k N = 0, where …
            return (Math((*said[0].parts, "=", value)), *said[1:])
        return (*said, " is ", *self.amount(value, phrase))

    def state(self, name: str) -> str:
        """When something is so; nothing where its name tells nothing."""
        return "" if name in ("now", "start") else f" when {name}"

    def amount(self, value: Formula, phrase: Find) -> Phrase:
        """The value that a quantity has to have."""
        if isinstance(value, Number) and value != ZERO:
            return (unit_for(QUANTITIES[phrase.terms[0].path.quantity].dimension).after(to_text(value)),)
        return ("zero",) if value == ZERO else (value,)

    def choice(self, choice: WhichOf) -> Phrase:
        """The options of a choice: which is largest: (a) the speed of the rod; (b) the speed of the disc."""
        bound: Phrase = () if choice.bound is None else (" ", *self.side(choice.bound))
        options = joined_phrases(map(self.option, choice.options), "; ")
        return (f"which is {choice.test}" if choice.test else "which holds", *bound, ": ", *options)

    def option(self, option: Option) -> Phrase:
        """An option with its label, as answers name it."""
        sides = [self.side(side) for side in option.sides]
        signs: list[Phrase] = [(), *((" ", Math((COMPARED[sign],)), " ") for sign in option.signs)]
        return (
            f"({option.label}) ",
            *(part for pair in zip(signs, sides, strict=True) for one in pair for part in one),
        )

    def side(self, side: Find) -> Phrase:
        """One side of a comparison: a quantity in words, a number as it is written, a formula of letters."""
        if side.terms:
            return self.sought(side)
        if side.formula.symbols():
            return (side.formula,)
        return (side.text.replace(" deg", "°"),)
