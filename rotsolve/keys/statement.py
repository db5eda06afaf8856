"""Statement: what a student is told of a problem: its text with the givens filled in, the other givens, and what is asked."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import greek
from rotsolve.algebra.notation.letters import parts as letter_parts
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.writing import spoken
from rotsolve.page.blocks import Math, Phrase, Styled
from rotsolve.page.values import given_equation, given_value
from rotsolve.scene.statement import prose_and_slots, slots

if TYPE_CHECKING:
    from rotsolve.keys.working import Worked
    from rotsolve.language.problem import Find, Given

PATH = re.compile(r"[^\W\d]\w*(?:\.at\([^)]*\)|\.\w+)+")  # rod.end.speed
WORD = re.compile(r"(?<![\w./^])(?<!\d )[A-Za-z]\w*(?![\w/^])")  # no unit behind its number
ENGLISH = ("a", "A", "I")
AXES = ("x", "y", "z", "xx", "yy", "zz", "xy", "yz", "zx")


class Statement(Struct, frozen=True):
    """The title, the paragraphs of the text, the givens that it does not name, what is asked, and which way answers are positive."""

    title: str
    text: tuple[Phrase, ...]
    givens: tuple[Phrase, ...]
    finds: tuple[Phrase, ...]
    positive: tuple[Phrase, ...]


def statement(worked: Worked) -> Statement:
    """What a problem says."""
    problem = worked.problem
    givens = {given.name: given for given in problem.givens}
    letters = frozenset(filter(is_letter, (*givens, *(find.group for find in problem.finds))))
    named = {slot.name for slot in slots(problem.text)}
    others = [
        given
        for given in problem.givens
        if not given.asked and given.name not in named and (not given.automatic or given.name in worked.told)
    ]
    return Statement(
        problem.title,
        tuple(filled_text(paragraph, givens, letters) for paragraph in paragraphs(problem.text)),
        tuple((given_equation(given),) for given in others),
        tuple(asked_phrases(problem.finds)),
        tuple((answer.symbol, f": {answer.positive}") for answer in worked.answers if answer.positive),
    )


def paragraphs(text: str) -> list[str]:
    """The paragraphs of a text: blank lines stand between them where there are any, else each line is one, as YAML folds them."""
    pieces = re.split(r"\n\s*\n", text) if re.search(r"\n\s*\n", text) else text.split("\n")
    return [" ".join(piece.split()) for piece in pieces if piece.strip()]


def is_letter(name: str) -> bool:
    """Whether a name is a letter, perhaps with something below it, and no English word."""
    letter = letter_parts(name)
    return letter is not None and len(greek(letter.head)) == 1 and name not in ENGLISH


def filled_text(text: str, givens: Mapping[str, Given], letters: Collection[str]) -> Phrase:
    """A paragraph with its givens."""
    said: list[str | Formula | Math | Styled] = []
    for part in prose_and_slots(text):
        if isinstance(part, str):
            said += prose_with_letters(part, letters)
        else:
            value = given_value(givens[part.name]) if part.alone else None
            said.append(given_equation(givens[part.name]) if value is None else Math((value,)))
    return tuple(said)


def prose_with_letters(prose: str, letters: Collection[str]) -> Iterator[str | Symbol]:
    """Prose in which words that are letters of the scene, such as `m2` and `theta`, are letters."""
    position = 0
    for match in WORD.finditer(prose):
        if match[0] in letters:
            yield from (prose[position : match.start()], Symbol(match[0]))
            position = match.end()
    yield prose[position:]


def asked_phrases(finds: tuple[Find, ...]) -> Iterator[Phrase]:
    """What is asked, by letters and in words: a (acceleration of block); of a choice its options."""
    first: dict[str, Find] = {}
    for find in finds:
        first.setdefault(find.group, find)
    for group, find in first.items():
        said = choice_options(find) if find.choice is not None else phrase_in_words(find.text)
        plain = not said or said.split()[0] == group  # a letter of the scene, which the text speaks of
        yield (Symbol(group),) if plain else (Symbol(group), f" ({said})")


def choice_options(find: Find) -> str:
    """The options of a choice: which is largest: a: speed of rod; b: speed of disc."""
    assert find.choice is not None
    said = []
    for option in find.choice.options:
        sides = [phrase_in_words(side.text) for side in option.sides]
        signs = [f" {sign} " for sign in option.signs] + [""]
        said.append(f"{option.label}: {''.join(side + sign for side, sign in zip(sides, signs, strict=True))}")
    bound = f" {phrase_in_words(find.choice.bound.text)}" if find.choice.bound is not None else ""
    test = f"which is {find.choice.test}{bound}: " if find.choice.test else "which holds: "
    return test + "; ".join(said)


def phrase_in_words(phrase: str) -> str:
    """A phrase of the language for people: `rod.end.speed at lowest` is the speed of rod end at lowest."""
    return spoken(PATH.sub(lambda match: path_in_words(match[0]), phrase))


def path_in_words(path: str) -> str:
    """`rod.end.speed` as speed of rod end, `pivot.force.x` as x component of force of pivot."""
    words = [re.sub(r"at\((.*)\)", r"at \1", word) for word in re.findall(r"at\([^)]*\)|\w+", path)]
    place = max((index for index, word in enumerate(words) if word in QUANTITIES), default=len(words) - 1)
    owner, quantity, part = " ".join(words[:place]), words[place], " ".join(words[place + 1 :])
    told = f"{part} component of {quantity}" if part in AXES else f"{part} {quantity}".strip()
    return f"{told} of {owner}" if owner else told
