"""Showing: pages of a report, one format a file, all of them in the table LAYOUTS."""

from __future__ import annotations

from importlib import import_module

from msgspec import Struct

from rotsolve.grading.course.report.page import Page


class Layout(Struct, frozen=True):
    """A format of pages: its name, and how its files end."""

    name: str
    suffix: str

    def document(self, page: Page) -> str:
        """The page as a complete file."""
        return str(import_module(f"rotsolve.grading.course.showing.{self.name}").document(page))


LAYOUTS = (Layout("text", ".txt"), Layout("markdown", ".md"), Layout("html", ".html"))


def layout_named(name: str) -> Layout:
    return next(layout for layout in LAYOUTS if layout.name == name)
