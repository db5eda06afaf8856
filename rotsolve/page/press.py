"""Press: what Typst makes of a document: a PDF, or the picture of a page; by the package typst, with its own fonts alone.

No font of the machine is used and no date is written, so that a document prints the same everywhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType
from typing import TYPE_CHECKING

from rotsolve.algebra.notation.typst import typst_string
from rotsolve.core.faults import MissingPackage
from rotsolve.page.typst_document import picture_page

if TYPE_CHECKING:
    from rotsolve.draw.paper.figure import Figure

PACKAGE = "typst"
MISSING = "a {} is made by the package typst, which is not installed: pip install 'rotsolve[pdf]'"
NO_IMAGES: Mapping[str, bytes] = MappingProxyType({})
RESOLUTION = 192  # dots per inch of a PNG, twice those of a common screen


def lacks_press() -> bool:
    """Whether the package that compiles is missing."""
    return find_spec(PACKAGE) is None


def printed_document(source: str, kind: str = "pdf", images: Mapping[str, bytes] = NO_IMAGES) -> bytes:
    """A Typst document as PDF, or its only page as PNG, with the images to which it refers by their names."""
    try:
        import typst
    except ModuleNotFoundError:
        raise MissingPackage(MISSING.format(kind.upper())) from None
    with TemporaryDirectory() as folder:  # within which alone Typst reads files
        for name, content in images.items():
            Path(folder, name).write_bytes(content)
        main = Path(folder, "main.typ")
        main.write_text(source, encoding="utf-8")
        made = typst.compile(str(main), root=folder, format=kind, ppi=RESOLUTION, ignore_system_fonts=True)
    assert isinstance(made, bytes), "a PNG has one page"
    return made


def printed_picture(figure: Figure, kind: str) -> bytes:
    """A picture on a page of its own size, as PDF or PNG."""
    from rotsolve.draw.paper.svg import plain_svg

    left, low, right, high = figure.box()
    return printed_document(picture_page(plain_svg(figure), right - left, high - low, figure.title), kind)


def printed_image(name: str, content: bytes) -> bytes:
    """An image on a page of its own size, as PDF."""
    page = f"#set page(width: auto, height: auto, margin: 0pt)\n#image({typst_string(name)})\n"
    return printed_document(page, images={name: content})
