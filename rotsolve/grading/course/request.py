"""Request: what the command line asked for, and what its exit codes mean."""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

ALL_RIGHT, NOT_ALL_RIGHT, BAD = 0, 1, 2
TABLES = (".csv", ".tsv", ".tab")
SUFFIXES = {".md": "markdown", ".markdown": "markdown", ".html": "html", ".htm": "html", ".json": "json"}
FORMATS = ("text", "markdown", "html", "json")
SEED = 1


class Request(Struct, frozen=True):
    """The problem, the answers in a file (`-` for standard input) or as typed, and how they are marked and shown."""

    problem: str
    answers: str = ""
    typed: tuple[str, ...] = ()
    output: str | None = None
    format: str | None = None
    variant: int | None = None
    variants: int | None = None
    seed: int = SEED
    width: int = 120

    @property
    def of_class(self) -> bool:
        """Whether the answers are a table."""
        return self.answers.lower().endswith(TABLES)

    @property
    def shown_as(self) -> str:
        """The format that was asked for, else that of the output file's name, else text."""
        named_so = SUFFIXES.get(Path(self.output).suffix.lower()) if self.output and not self.of_class else None
        return self.format or named_so or "text"
