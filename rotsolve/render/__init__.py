"""Printing a derivation: one output format a file, all of them in the table FORMATS.

A format's module has `body(derivation, options) -> str` and `document(bodies) -> str`, and is imported when it is asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.render.options import Options

if TYPE_CHECKING:
    from rotsolve.core.derivation import Derivation


class Format(Struct, frozen=True):
    """An output format: its name, the file names that it goes by, and what it is for."""

    name: str
    suffixes: tuple[str, ...]
    help: str

    def body(self, derivation: Derivation, options: Options) -> str:
        """One derivation, as it stands within a document."""
        return str(import_module(f"rotsolve.render.{self.name}").body(derivation, options))

    def document(self, bodies: Sequence[str]) -> str:
        """A complete document of one or several derivations."""
        return str(import_module(f"rotsolve.render.{self.name}").document(bodies))


FORMATS = (
    Format("text", (".txt",), "plain text in aligned columns"),
    Format("markdown", (".md", ".markdown"), "Markdown with the formulas as LaTeX"),
    Format("latex", (".tex",), "a complete LaTeX document"),
    Format("html", (".html", ".htm"), "a page for a browser, with the formulas as MathML"),
    Format("json", (".json",), "everything, for programs"),
)


def format_named(name: str) -> Format:
    """The format of that name; a KeyError names the ones there are."""
    for item in FORMATS:
        if item.name == name:
            return item
    raise KeyError(f"unknown format {name!r}: {', '.join(item.name for item in FORMATS)}")


def format_of_file(file: str) -> Format | None:
    """The format that goes by the file's name, if any."""
    lower = file.lower()
    return next((item for item in FORMATS if lower.endswith(item.suffixes)), None)
