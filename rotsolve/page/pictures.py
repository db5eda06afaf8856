"""Pictures on a page: a scene, or bars, as SVG, TikZ or, for Typst, SVG, drawn where it is printed; nothing where it can not be drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from rotsolve.page.bars import Bars
from rotsolve.page.blocks import PageBlock, Picture

if TYPE_CHECKING:
    from rotsolve.page.printer import Lines

TEXT_WIDTH = 453  # points, of a page of Typst
BEGIN, TIKZ = "\\begin{document}\n", "\\usepackage{tikz}\n"


def drawn(printed: Callable[..., Lines]) -> dict[type[PageBlock], Callable[..., Lines]]:
    """The blocks that are drawn, each printed in this way."""
    return dict.fromkeys((Picture, Bars), printed)


def picture_in_svg(block: Picture | Bars) -> Iterator[str]:
    """A figure of a web page, on white as that is."""
    from rotsolve.draw.paper.svg import svg

    figure = block.figure()
    if figure is not None:
        yield f"<figure>{svg(figure, adapts=False)}</figure>"


def picture_in_tikz(block: Picture | Bars) -> Iterator[str]:
    """A picture in the middle of a line of its own."""
    from rotsolve.draw.paper.tikz import tikz

    figure = block.figure()
    if figure is not None:
        yield from (r"\begin{center}", tikz(figure).rstrip("\n"), r"\end{center}", "")


def picture_in_typst(block: Picture | Bars) -> Iterator[str]:
    """A picture in the middle of the page, no wider than its text."""
    from rotsolve.algebra.notation.typst import typst_string
    from rotsolve.draw.paper.svg import plain_svg

    figure = block.figure()
    if figure is not None:
        left, _, right, _ = figure.box()
        yield from (f"#picture({min(right - left, TEXT_WIDTH):.2f}pt, {typst_string(plain_svg(figure))})", "")


def with_tikz(document: str) -> str:
    """A document that loads the package of its pictures, where it has any."""
    return document.replace(BEGIN, TIKZ + BEGIN, 1) if r"\begin{tikzpicture}" in document else document
