"""Sheets: the pages of one variant: the statements without answers, the answers, the derivations."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.keys.statement import statement
from rotsolve.page.blocks import Answers, Labelled, Labels, Page, PageBlock, Paragraph, Phrase, Title, authored
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.text import plain_text

if TYPE_CHECKING:
    from rotsolve.keys.working import Worked
from rotsolve.page.values import answer_row, given_equation


class Sheet(Struct, frozen=True):
    """The problems of one variant by their names; its number is 0 where there are no variants, which are drawn by the seed."""

    variant: int
    problems: tuple[tuple[str, Worked], ...]
    seed: int = 0

    @property
    def mark(self) -> str:
        """What tells the variant behind a title."""
        return f", variant {self.variant} (seed {self.seed})" if self.variant else ""


class SheetPage(Page, frozen=True):
    """The statements of one variant, without answers."""

    sheet: Sheet

    def blocks(self) -> Iterator[PageBlock]:
        yield Title(1, (f"Problems{self.sheet.mark}",))
        for number, (_, worked) in enumerate(self.sheet.problems, 1):
            said = statement(worked)
            yield Title(2, (authored(f"{number}. {said.title}"),))
            yield from (Paragraph(authored_line(line)) for line in said.text)
            rows = (
                Labelled("Given", said.givens, ", "),
                Labelled("Find", said.finds),
                Labelled("Positive", said.positive),
            )
            yield Labels(tuple(row for row in rows if row.items))

    def names(self) -> frozenset[str]:
        from rotsolve.page.languages.names import names_of_scene

        return frozenset().union(*(names_of_scene(worked.problem) for _, worked in self.sheet.problems))

    def data(self) -> dict[str, Any]:
        return with_variant(self.sheet, [statement_data(name, worked) for name, worked in self.sheet.problems])


def authored_line(words: Phrase) -> Phrase:
    """Words of the author of a problem, with its letters."""
    return tuple(authored(part) if isinstance(part, str) else part for part in words)


def statement_data(name: str, worked: Worked) -> dict[str, Any]:
    """What a problem says, as plain text."""
    said = statement(worked)
    lists = {"given": said.givens, "find": said.finds, "positive": said.positive}
    return {
        "problem": name,
        "title": plain_text((said.title,)),
        "text": "\n".join(map(plain_text, said.text)),
        **{key: [*map(plain_text, items)] for key, items in lists.items()},
    }


def with_variant(sheet: Sheet, problems: list[dict[str, Any]]) -> dict[str, Any]:
    """The data of problems with the number of their variant."""
    return {**({"variant": sheet.variant, "seed": sheet.seed} if sheet.variant else {}), "problems": problems}


def key_blocks(sheet: Sheet, digits: int) -> Iterator[PageBlock]:
    """The answers of one variant."""
    level = 3 if sheet.variant else 2
    if sheet.variant:
        yield Title(2, (f"Variant {sheet.variant}",))
    for number, (_, worked) in enumerate(sheet.problems, 1):
        yield Title(level, (authored(f"{number}. {worked.problem.title}"),))
        givens = tuple((given_equation(given),) for given in worked.shown())
        yield Labels((Labelled("Given", givens, ", "),) if givens else ())
        yield Answers(tuple(answer_row(answer, digits) for answer in worked.answers))


def key_data(sheet: Sheet, digits: int) -> dict[str, Any]:
    """The answers of one variant, as `rotsolve solve --format json` gives them."""
    from rotsolve.page.data import answer_data, given_data

    problems = [
        {
            "problem": name,
            "title": worked.problem.title,
            "given": [given_data(given) for given in worked.shown()],
            "answers": [answer_data(answer, digits) for answer in worked.answers],
        }
        for name, worked in sheet.problems
    ]
    return with_variant(sheet, problems)


def solution_pages(sheet: Sheet, digits: int) -> Iterator[DerivationPage]:
    """The derivations, one after the other."""
    for name, worked in sheet.problems:
        derivation = worked.derivation()
        titled = replace(derivation, title=f"{derivation.title}{sheet.mark}")
        yield DerivationPage(titled, digits, name, scene=worked.problem)
