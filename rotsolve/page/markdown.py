"""Markdown: headings and lists, with the formulas as LaTeX between dollar signs, as notebooks and web pages show them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import ClassVar

from rotsolve.page.blocks import CODE, FAULT, LABEL, NAME, STRONG, Bullet, Bullets, Paragraph, Table, Title
from rotsolve.page.tex import TexPrinter

SPECIAL = re.compile(r"([\\`*_\[\]<>$|#~])")


class Markdown(TexPrinter):
    """Pages as Markdown."""

    between = "\n\n"
    styles: ClassVar = {NAME: "**{}**", LABEL: "**{}:** ", STRONG: "**{}**", FAULT: "**{}**"}

    def prose(self, text: str) -> str:
        return SPECIAL.sub(r"\\\1", text)

    def styled(self, style: str, text: str) -> str:
        return inline_code(text) if style == CODE else super().styled(style, text)

    def title(self, block: Title) -> Iterator[str]:
        yield f"{'#' * block.level} {self.words(block.words)}"

    def paragraph(self, block: Paragraph) -> Iterator[str]:
        yield self.words(block.words)

    def bullets(self, block: Bullets) -> Iterator[str]:
        for item in block.items:
            yield from self._bullet(item, "")

    def _bullet(self, item: Bullet, inset: str) -> Iterator[str]:
        yield f"{inset}- {self.words(item.words)}"
        for inner in item.inner:
            yield from self._bullet(inner, inset + "  ")
        if item.code:
            fence = "`" * max(3, longest_run(item.code[0]) + 1)
            yield ""
            yield from (f"{inset}  {line}" for line in (f"{fence}text", *item.code, fence))

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
