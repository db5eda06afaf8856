"""Pages in another language: each block with its prose translated, sentence by sentence, the formulas in it as slots.

Words of the scene's author (`authored`), names before lists and formulas stay as they are.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

from msgspec.structs import replace

from rotsolve.core.derivation import Check
from rotsolve.page import blocks
from rotsolve.page.languages.language import FORMULAS, Language, Translation
from rotsolve.page.statement_blocks import Question, SheetHead

HELD = re.compile(f"([{chr(FORMULAS)}-{chr(FORMULAS + 0x18FF)}])")  # letters that stand for formulas


class TranslatedPage(blocks.Page, frozen=True):
    """A page in another language; what it holds for programs is as before."""

    page: blocks.Page
    language: Language

    def blocks(self) -> Iterator[blocks.PageBlock]:
        translator = Translator(Translation(self.language, self.page.names()))
        yield from map(translator.block, self.page.blocks())

    @property
    def spaced(self) -> bool:
        return self.page.spaced

    def data(self) -> dict[str, Any]:
        return self.page.data()


class Translator:
    """Translates blocks."""

    def __init__(self, translation: Translation) -> None:
        self.text = translation.translate

    def phrase(self, words: blocks.Phrase) -> blocks.Phrase:
        """A line of words, translated as a whole: its formulas may come in another order."""
        held = [part for part in words if not isinstance(part, str)]
        if len(held) == len(words):
            return tuple(map(self._held, words))
        letters = iter(range(len(held)))
        text = "".join(part if isinstance(part, str) else chr(FORMULAS + next(letters)) for part in words)
        pieces = HELD.split(self.text(text))
        return tuple(
            self._held(held[ord(piece) - FORMULAS]) if number % 2 else piece
            for number, piece in enumerate(pieces)
            if piece
        )

    def _held(self, part: Any) -> Any:
        """What stands within words: of styled ones labels are phrases."""
        if isinstance(part, blocks.Styled) and part.style in (blocks.LABEL, blocks.FAULT, blocks.STRONG):
            return replace(part, text=self.text(part.text))
        return part

    def phrases(self, many: Iterable[blocks.Phrase]) -> tuple[blocks.Phrase, ...]:
        return tuple(map(self.phrase, many))

    def block(self, block: blocks.PageBlock) -> blocks.PageBlock:
        """The block with its prose translated."""
        match block:
            case blocks.Title() | blocks.Paragraph():
                return replace(block, words=self.phrase(block.words))
            case blocks.Bullets():
                return replace(block, items=tuple(map(self._bullet, block.items)))
            case blocks.Table():
                rows = tuple(map(self.phrases, block.rows))
                return replace(block, columns=tuple(map(self.text, block.columns)), rows=rows)
            case SheetHead():
                fields = tuple(replace(field, label=self.text(field.label)) for field in block.fields)
                return replace(block, title=self.phrase(block.title), fields=fields)
            case Question():
                return replace(block, words=self.phrase(block.words), points=self.text(block.points))
            case blocks.Labels():
                return replace(block, rows=tuple(map(self._labelled, block.rows)))
            case blocks.Listing():
                return replace(block, caption=self.text(block.caption), rows=tuple(map(self._listed, block.rows)))
            case blocks.Formulas():
                return self._formulas(block)
            case blocks.Answers():
                return replace(block, rows=tuple(map(self._answer, block.rows)))
            case blocks.Checks():
                return replace(block, checks=tuple(map(self._check, block.checks)))
        return block

    def _bullet(self, item: blocks.Bullet) -> blocks.Bullet:
        return replace(item, words=self.phrase(item.words), inner=tuple(map(self._bullet, item.inner)))

    def _labelled(self, row: blocks.Labelled) -> blocks.Labelled:
        return replace(row, label=self.text(row.label), items=self.phrases(row.items))

    def _listed(self, row: blocks.Listed) -> blocks.Listed:
        said, remarks = self.phrases(row.said), self.phrases(row.remarks)
        return replace(row, said=said, beside=self.text(row.beside), remarks=remarks)

    def _formulas(self, block: blocks.Formulas) -> blocks.Formulas:
        rows = tuple(replace(row, said=self.phrase(row.said), remark=self.phrase(row.remark)) for row in block.rows)
        return replace(block, caption=self.text(block.caption), remarks=self.phrases(block.remarks), rows=rows)

    def _answer(self, row: blocks.AnswerRow) -> blocks.AnswerRow:
        asides, parts = tuple(map(self._aside, row.asides)), tuple(map(self._answer, row.components))
        return replace(row, asides=asides, notes=self.phrases(row.notes), components=parts)

    def _aside(self, aside: str) -> str:
        """Which way an answer points; in brackets where its sign says so too."""
        inner = aside.removeprefix("(").removesuffix(")")
        return f"({self.text(inner)})" if f"({inner})" == aside else self.text(aside)

    def _check(self, check: Check) -> Check:
        label = blocks.Checks.label(check)
        return replace(check, words=self.phrase(check.words), label=self.text(label))
