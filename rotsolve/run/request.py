"""Request and outcome: what one command asked for, and what each of its files gave. Both go to other processes and come back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct, field

if TYPE_CHECKING:
    from rotsolve.render.layout import Line

SOLVED, UNSOLVED, BAD = 0, 1, 2


class Request(Struct, frozen=True):
    """What the command line asked for."""

    files: tuple[str, ...]
    law: str | None = None
    format: str = "text"
    output: str | None = None
    digits: int = 4
    settings: dict[str, str] = field(default_factory=dict)
    show: str | None = None
    width: int = 120
    at: str | None = None
    jobs: int = 1
    time_limit: float | None = None  # seconds a file
    profile: bool = False
    coloured: bool = False  # whether pages are lines with their roles, for a terminal

    @property
    def streams(self) -> bool:
        """Whether a page may be written before the next one is there; other formats, and files, are written as a whole."""
        return self.output is None and self.format == "text"


class Outcome(Struct, frozen=True):
    """What one file gave: a page (text, or lines for a terminal that wants colours), or a message with its exit code."""

    file: str
    code: int
    page: str | tuple[Line, ...] | None = None
    message: str = ""
    kind: str = ""
