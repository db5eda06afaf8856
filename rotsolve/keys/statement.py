"""Statement: what a student is told of a problem: its text with the givens filled in, the other givens, and what is asked."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.letters import greek
from rotsolve.algebra.notation.letters import parts as letter_parts
from rotsolve.keys.asked import asked_in_words
from rotsolve.keys.parts import SheetPart, parts_of
from rotsolve.page.blocks import Bullet, Bullets, Math, PageBlock, Paragraph, Phrase, authored
from rotsolve.page.values import given_equation, given_value
from rotsolve.scene.statement import Filler, Slot, Tex, slots, statement_blocks, wording_phrase
from rotsolve.scene.tex import tex_phrase

if TYPE_CHECKING:
    from rotsolve.keys.working import Worked
    from rotsolve.language.problem import Given, Problem

WORD = re.compile(r"(?<![\w./^])(?<!\d )[A-Za-z]\w*(?![\w/^])")  # no unit behind its number
ENGLISH = ("a", "A", "I")


class AskedPart(Struct, frozen=True):
    """What is asked in one part; `worded` by the author of the scene."""

    part: SheetPart
    words: Phrase
    worded: bool


class Statement(Struct, frozen=True):
    """The title, the text, the givens that it does not name, what is asked, and which way answers are positive."""

    title: str
    text: tuple[PageBlock, ...]
    givens: tuple[Phrase, ...]
    parts: tuple[AskedPart, ...]
    positive: tuple[Phrase, ...]


def statement(worked: Worked, marked: Problem | None = None) -> Statement:
    """What a problem says; `marked` is it with the points of its sheet."""
    problem = worked.problem
    givens = {given.name: given for given in problem.givens}
    letters = frozenset(filter(is_letter, (*givens, *(find.group for find in problem.finds))))
    said = filler(givens, letters)
    texts = (problem.text, *(wording.text for wording in problem.ask))
    told = {slot.name for text in texts for slot in slots(text)}
    others = [
        given
        for given in problem.givens
        if not given.asked and given.name not in told and (not given.automatic or given.name in worked.told)
    ]
    return Statement(
        problem.title,
        tuple(map(by_author, statement_blocks(problem.text, said, os.path.dirname(problem.file)))),
        tuple((given_equation(given),) for given in others),
        tuple(parts_in_words(problem, marked or problem, said)),
        tuple((answer.symbol, f": {answer.positive}") for answer in worked.answers if answer.positive),
    )


def is_letter(name: str) -> bool:
    """Whether a name is a letter, perhaps with something below it, and no English word."""
    letter = letter_parts(name)
    return letter is not None and len(greek(letter.head)) == 1 and name not in ENGLISH


def filler(givens: Mapping[str, Given], letters: Collection[str]) -> Filler:
    """What says a piece of a text: prose with its letters, a given with its value, a formula of TeX."""

    def said(piece: str | Slot | Tex) -> Phrase:
        if isinstance(piece, str):
            return tuple(prose_with_letters(piece, letters))
        if isinstance(piece, Tex):
            return tex_phrase(piece.tex)
        value = given_value(givens[piece.name]) if piece.alone else None
        return (given_equation(givens[piece.name]) if value is None else Math((value,)),)

    return said


def prose_with_letters(prose: str, letters: Collection[str]) -> Iterator[str | Symbol]:
    """Prose in which words that are letters of the scene, such as `m2` and `theta`, are letters."""
    position = 0
    for match in WORD.finditer(prose):
        if match[0] in letters:
            yield from (prose[position : match.start()], Symbol(match[0]))
            position = match.end()
    yield prose[position:]


def parts_in_words(problem: Problem, marked: Problem, said: Filler) -> Iterator[AskedPart]:
    """What is asked, part by part: in the words of the author, else in words made of the scene."""
    wordings = {wording.name: wording.text for wording in problem.ask}
    parts = parts_of(marked)
    made = asked_in_words(problem) if any(part.name not in wordings for part in parts) else {}
    for part in parts:
        if part.name in wordings:
            yield AskedPart(part, by_author_alone(wording_phrase(wordings[part.name], said)), True)
        else:
            yield AskedPart(part, made[part.name], False)


def by_author(block: PageBlock) -> PageBlock:
    """A block whose words are those of the author of the scene, and are the same in all languages."""
    match block:
        case Paragraph():
            return Paragraph(by_author_alone(block.words))
        case Bullets():
            return replace(block, items=tuple(map(item_by_author, block.items)))
    return block


def item_by_author(item: Bullet) -> Bullet:
    return replace(item, words=by_author_alone(item.words), inner=tuple(map(item_by_author, item.inner)))


def by_author_alone(words: Phrase) -> Phrase:
    """Words of the author of a problem, with its letters."""
    return tuple(authored(part) if isinstance(part, str) else part for part in words)
