"""Press: what Typst makes of a document: a PDF, or the picture of a page; by the package typst, with its own fonts alone.

No font of the machine is used and no date is written, so that a document prints the same everywhere.
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import TYPE_CHECKING

from rotsolve.core.faults import MissingPackage
from rotsolve.page.typst_document import picture_page

if TYPE_CHECKING:
    from rotsolve.draw.paper.figure import Figure

PACKAGE = "typst"
MISSING = "a {} is made by the package typst, which is not installed: pip install 'rotsolve[pdf]'"
RESOLUTION = 192  # dots per inch of a PNG, twice those of a common screen


def lacks_press() -> bool:
    """Whether the package that compiles is missing."""
    return find_spec(PACKAGE) is None


def printed_document(source: str, kind: str = "pdf") -> bytes:
    """A Typst document as PDF, or its only page as PNG."""
    try:
        import typst
    except ModuleNotFoundError:
        raise MissingPackage(MISSING.format(kind.upper())) from None
    made = typst.compile(source.encode(), format=kind, ppi=RESOLUTION, ignore_system_fonts=True)
    assert isinstance(made, bytes), "a PNG has one page"
    return made


def printed_picture(figure: Figure, kind: str) -> bytes:
    """A picture on a page of its own size, as PDF or PNG."""
    from rotsolve.draw.paper.svg import plain_svg

    left, low, right, high = figure.box()
    return printed_document(picture_page(plain_svg(figure), right - left, high - low, figure.title), kind)
