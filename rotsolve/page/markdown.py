"""Markdown: headings and lists, with the formulas as LaTeX between dollar signs, as notebooks and web pages show them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

from rotsolve.page import blocks
from rotsolve.page.blocks import (
    BOLD,
    BOTH,
    CODE,
    FAULT,
    ITALIC,
    LABEL,
    NAME,
    STRONG,
    Bullet,
    Bullets,
    Paragraph,
    Table,
    Title,
)
from rotsolve.page.printer import Lines
from rotsolve.page.statement_blocks import Image
from rotsolve.page.tex import TexPrinter

SPECIAL = re.compile(r"([\\`*_\[\]<>$|#~])")


class Markdown(TexPrinter):
    """Pages as Markdown."""

    between = "\n\n"
    styles: ClassVar = {NAME: "**{}**", LABEL: "**{}:** ", STRONG: "**{}**", FAULT: "**{}**"}
    styles |= {BOLD: "**{}**", ITALIC: "*{}*", BOTH: "***{}***"}

    def prose(self, text: str) -> str:
        return SPECIAL.sub(r"\\\1", text)

    def styled(self, style: str, text: str) -> str:
        return inline_code(text) if style == CODE else super().styled(style, text)

    def title(self, block: Title) -> Iterator[str]:
        yield f"{'#' * block.level} {self.words(block.words)}"

    def paragraph(self, block: Paragraph) -> Iterator[str]:
        yield self.words(block.words)

    def bullets(self, block: Bullets) -> Iterator[str]:
        for item, mark in zip(block.items, block.marks, strict=True):
            yield from self._bullet(item, "", mark or "-")

    def _bullet(self, item: Bullet, inset: str, mark: str) -> Iterator[str]:
        yield f"{inset}{mark} {self.words(item.words)}"
        for inner, own in zip(item.inner, item.list.marks, strict=True):
            yield from self._bullet(inner, inset + " " * (len(mark) + 1), own or "-")
        if item.code:
            fence = "`" * max(3, longest_run(item.code[0]) + 1)
            yield ""
            yield from (f"{inset}  {line}" for line in (f"{fence}text", *item.code, fence))

    def own(self) -> dict[type[blocks.PageBlock], Callable[..., Lines]]:
        return super().own() | {Image: self.image}

    def image(self, block: Image) -> Iterator[str]:
        yield f"![{self.prose(block.alt)}]({block.name})"

    def table(self, block: Table) -> Iterator[str]:
        """A table; the first cells are links where they lead to files."""
        yield f"| {' | '.join(map(self.prose, block.columns))} |"
        yield "|" + " --- |" * len(block.columns)
        targets = block.targets or ("",) * len(block.rows)
        for row, target in zip(block.rows, targets, strict=True):
            first, *others = map(self.words, row)
            yield f"| {' | '.join([f'[{first}](<{target}>)' if target else first, *others])} |"

    def document(self, bodies: Sequence[str]) -> str:
        """Pages with a rule between two."""
        return "\n---\n\n".join(bodies)


def inline_code(text: str) -> str:
    """The text as code, between as many backquotes as it takes."""
    fence = "`" * (longest_run(text) + 1)
    blank = " " if text.startswith("`") or text.endswith("`") else ""
    return f"{fence}{blank}{text}{blank}{fence}"


def longest_run(text: str) -> int:
    """How many backquotes stand behind each other."""
    return max(map(len, re.findall("`+", text)), default=0)


PRINTER = Markdown()
