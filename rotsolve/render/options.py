"""Options: what a reader may choose about the printing of a derivation."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.render.layout import WIDTH


class Options(Struct, frozen=True):
    """Significant digits of the numbers, columns of a text page, and the file that the scene came from."""

    digits: int = 4
    width: int = WIDTH
    file: str = ""
