"""Terminal: the same lines as plain text, in the colours that the terminal has. Nothing else imports rich."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TextIO

from rich.console import Console
from rich.markup import escape
from rich.progress import Progress
from rich.text import Text

from rotsolve.page.columns import TextLine

STYLES = {
    "title": "bold underline",
    "heading": "bold",
    "answer": "bold green",
    "check": "dim",
    "fault": "bold red",
    "doubt": "bold yellow",
    "rule": "dim",
}


def show(lines: Iterable[TextLine], stream: TextIO) -> None:
    """Write lines to a terminal in colour; the characters are those of the plain text."""
    console = Console(file=stream, highlight=False, markup=False, emoji=False, soft_wrap=True)
    for line in lines:
        styled = Text(line.text, style=STYLES.get(line.role, ""))
        if line.heading:
            styled.stylize("bold", 0, line.heading)
        console.print(styled)


class Bar:
    """A progress bar over a number of files, which goes away while pages are written and at the end."""

    def __init__(self, total: int, stream: TextIO) -> None:
        self.bar = Progress(*Progress.get_default_columns(), console=Console(file=stream), transient=True)
        self.task = self.bar.add_task("solving", total=total)

    def show(self, done: int) -> None:
        """Show it with so many files behind."""
        self.bar.update(self.task, completed=done)
        self.bar.start()

    def hide(self) -> None:
        self.bar.stop()


class Advance:
    """A bar for one long calculation, told how much of it is done; it goes away at the end."""

    def __init__(self, what: str, stream: TextIO) -> None:
        self.bar = Progress(console=Console(file=stream), transient=True)
        self.bar.start()
        self.task = self.bar.add_task(escape(what), total=1.0)

    def to(self, part: float) -> None:
        self.bar.update(self.task, completed=part)

    def done(self) -> None:
        self.bar.stop()
