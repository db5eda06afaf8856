"""Sheets: the pages of one variant: the statements without answers, the answers, the derivations."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.keys.layouts import Layout
from rotsolve.keys.statement import statement
from rotsolve.keys.working import Worked
from rotsolve.render import Format
from rotsolve.render.options import Options


class Sheet(Struct, frozen=True):
    """The problems of one variant by their names; its number is 0 where there are no variants, which are drawn by the seed."""

    variant: int
    problems: tuple[tuple[str, Worked], ...]
    seed: int = 0

    @property
    def mark(self) -> str:
        """What tells the variant behind a title."""
        return f", variant {self.variant} (seed {self.seed})" if self.variant else ""


def problem_sheet(sheet: Sheet, layout: Layout) -> str:
    """The statements, without answers."""
    return layout.sheet(statement_lines(sheet, layout))


def statement_lines(sheet: Sheet, layout: Layout) -> Iterator[str]:
    yield layout.heading(1, f"Problems{sheet.mark}")
    for number, (_, worked) in enumerate(sheet.problems, 1):
        said = statement(worked, layout.voice)
        yield layout.heading(2, f"{number}. {said.title}")
        yield from (layout.paragraph("", text) for text in said.text)
        if said.givens:
            yield layout.paragraph("Given", ", ".join(said.givens))
        yield layout.paragraph("Find", "; ".join(said.finds))
        if said.positive:
            yield layout.paragraph("Positive", "; ".join(said.positive))


def key_lines(sheet: Sheet, layout: Layout, digits: int) -> Iterator[str]:
    """The answers of one variant."""
    level = 2
    if sheet.variant:
        yield layout.heading(level, f"Variant {sheet.variant}")
        level += 1
    for number, (_, worked) in enumerate(sheet.problems, 1):
        yield layout.heading(level, f"{number}. {layout.voice.prose(worked.problem.title)}")
        givens = [layout.voice.math(layout.voice.given(given)) for given in worked.shown()]
        if givens:
            yield layout.paragraph("Given", ", ".join(givens))
        yield from layout.answers(worked.answers, digits)


def solutions(sheet: Sheet, format: Format, digits: int) -> list[str]:
    """The derivations, one after the other."""
    bodies = []
    for name, worked in sheet.problems:
        derivation = worked.derivation()
        told = replace(derivation, title=f"{derivation.title}{sheet.mark}")
        bodies.append(format.body(told, Options(digits=digits, file=name)))
    return bodies
