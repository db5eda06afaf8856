"""Tally: what the head of a summary says of papers, as counts that add up, so that a million of them need not be held at once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from fractions import Fraction

from msgspec import Struct, field

from rotsolve.grading.course.columns import Columns
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import Asked, SheetTask
from rotsolve.grading.course.report.student import marks_text
from rotsolve.grading.verdict import OPEN_OUTCOMES
from rotsolve.page.blocks import Paragraph
from rotsolve.page.text import plain_text

NAMED = 10  # papers that are named in one sentence
TELLING = 3  # papers of which none having a right number may be chance
LUCKY = 4  # of so many answers with numbers in them one has marks by chance, or since it is the same in all variants


class Tally(Struct):
    """Counts of papers: all of them, by their marks, and by whether they tell a variant; exact marks are written as texts of fractions."""

    papers: int = 0
    marks: dict[str, int] = field(default_factory=dict)  # of those that were marked, how many have which marks
    of: str = ""  # the most that a paper can have
    full: int = 0
    open: int = 0  # answers that could not be decided, with no marks so far
    variants: int = 0  # papers that tell one
    without: int = 0  # marked papers that tell none
    named: list[str] = field(default_factory=list)  # the first of these
    varied: int = 0  # marked papers that tell one
    numbers: int = 0  # answers with a number in them, in these
    right: int = 0  # those of them that have marks
    faultless: int = 0  # papers of which all is right

    @property
    def marked(self) -> int:
        """How many papers were marked."""
        return self.without + self.varied

    @property
    def all_faultless(self) -> bool:
        """Whether all is right in every paper."""
        return self.faultless == self.papers

    def count(self, name: str, variant: str, marked: MarkedSheet | None) -> None:
        """Count one paper more; None is one that could not be marked."""
        self.papers += 1
        self.variants += bool(variant)
        if marked is None:
            return
        self.of = self.of or str(marked.of)
        self.faultless += marked.all_right
        self.full += marked.marks >= marked.of
        self.open += sum(part.verdict.outcome in OPEN_OUTCOMES for part in marked.parts)
        self.marks[str(marked.marks)] = self.marks.get(str(marked.marks), 0) + 1
        if not variant:
            self.without += 1
            self.named = [*self.named, name][:NAMED]
            return
        numbers = [part for part in marked.parts if any(char.isdigit() for char in part.text)]
        self.varied += 1
        self.numbers += len(numbers)
        self.right += sum(bool(part.marks) for part in numbers)

    def add(self, other: Tally) -> None:
        """Count the papers of another tally, which come after these."""
        self.marks = dict(Counter(self.marks) + Counter(other.marks))
        self.of = self.of or other.of
        self.named = [*self.named, *other.named][:NAMED]
        for word in ("papers", "full", "open", "variants", "without", "varied", "numbers", "right", "faultless"):
            setattr(self, word, getattr(self, word) + getattr(other, word))


def head_of_class(
    task: SheetTask, columns: Columns, held: Collection[Asked], tally: Tally, seed: int | None
) -> Iterator[str]:
    """What a summary begins with, a sentence a line; `held` are the answers that there are columns of, in this table or before."""
    for paragraph in (*overview(tally, seed), *about_columns(task, columns, held), *doubtful_variants(tally, seed)):
        yield plain_text(paragraph.words)


def overview(tally: Tally, seed: int | None) -> Iterator[Paragraph]:
    """How many papers there are, and their marks in a sentence; the seed of the variants where the problem has such."""
    left = tally.papers - tally.marked
    without = f", {left} of them not marked" if left else ""
    yield Paragraph((f"{tally.papers} {'paper' if tally.papers == 1 else 'papers'}{without}.",))
    if tally.marked:
        counts = {Fraction(text): count for text, count in tally.marks.items()}
        mean = sum((marks * count for marks, count in counts.items()), Fraction(0)) / tally.marked
        figures = (
            f"mean {marks_text(mean)}, median {marks_text(median_of_counts(counts))}, best {marks_text(max(counts))}"
        )
        yield Paragraph((f"Of {marks_text(Fraction(tally.of))} marks: {figures}; {tally.full} with full marks.",))
    if tally.open:
        one = tally.open == 1
        yield Paragraph(
            (
                f"{tally.open} {'answer has' if one else 'answers have'} no marks yet and {'counts' if one else 'count'} as 0.",
            )
        )
    if tally.variants and seed is not None:
        yield Paragraph((f"Variants by seed {seed}.",))


def median_of_counts(counts: dict[Fraction, int]) -> Fraction:
    """The median of marks of which it is told how many papers have them."""
    total, below = sum(counts.values()), 0
    found = []
    for marks in sorted(counts):
        found += [marks for place in ((total - 1) // 2, total // 2) if below <= place < below + counts[marks]]
        below += counts[marks]
    return sum(found, Fraction(0)) / 2


def about_columns(task: SheetTask, columns: Columns, held: Collection[Asked]) -> Iterator[Paragraph]:
    """Headings that may have meant something else, and answers that no column holds."""
    yield from (Paragraph((said,)) for said in columns.remarks)
    absent = [task.key(asked) for asked in task.asked() if asked not in held]
    if absent:
        yield Paragraph((f"No column is named {', '.join(absent)}.",))


def doubtful_variants(tally: Tally, seed: int | None) -> Iterator[Paragraph]:
    """Papers of a problem with variants that tell none, and a seed that can not be that of the sheets."""
    if seed is None:
        return
    if tally.without:
        named = f"{', '.join(tally.named)}{', …' if tally.without > NAMED else ''}"
        whose = f"Papers that tell no variant: {named}" if tally.varied else "No paper tells its variant"
        yield Paragraph((f"{whose}. They were marked with the numbers of the problem itself.",))
    if tally.varied >= TELLING and tally.right * LUCKY < tally.numbers:
        said = f"{tally.right} of {tally.numbers}" if tally.right else "None"
        yield Paragraph(
            (
                f"{said} of the answers with numbers in papers with a variant have marks: is {seed} the seed of the sheets?",
            )
        )
