"""QTI files: a sheet and its variants as content packages, `qti21.zip` and `qti30.zip`, with the same items in both."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.keys.files import NamedContent, SheetFiles
from rotsolve.keys.sheets import Sheet, SheetProblem, instructions
from rotsolve.platforms.fragments import FragmentHtml, fragments_in, problem_blocks, solution_blocks
from rotsolve.platforms.judges import ProblemJudges
from rotsolve.platforms.known import PlatformPart, parts_for_platforms
from rotsolve.platforms.qti import QTI_21, QTI_30, Dialect, ItemWriter
from rotsolve.platforms.qti_package import PackedItem, PackedProblem, package

PACKAGES = {"qti21.zip": QTI_21, "qti30.zip": QTI_30}
IMAGES = "../images/"  # as seen from an item


class WorkedItem(Struct, frozen=True):
    """One variant of a problem with what is known of it, as HTML."""

    variant: int
    one: SheetProblem
    parts: tuple[PlatformPart, ...]
    printer: FragmentHtml
    told: str
    solution: str

    def packed(self, dialect: Dialect) -> tuple[PackedItem, ...]:
        """Its items, one for each part."""
        writer = ItemWriter(dialect, self.printer)
        images = tuple(name for name in self.printer.files if f"{IMAGES}{name}" in self.told + self.solution)
        several = len(self.parts) > 1
        found = []
        for part in self.parts:
            identifier = f"p{self.one.listed.number}{part.part.label}{f'-v{self.variant}' if self.variant else ''}"
            title = f"{self.one.listed.number}{part.part.label if several else ''} {self.one.marked.title}"
            found.append(PackedItem(identifier, writer.item(identifier, title, self.told, self.solution, part), images))
        return tuple(found)


class QtiFiles(SheetFiles):
    """Makes the packages."""

    def __init__(self, digits: int, language: str) -> None:
        self.digits, self.language = digits, language
        self.judges = ProblemJudges()
        self.problems: dict[int, list[WorkedItem]] = {}
        self.title, self.rubric = "", ""
        self.head = fragments_in(language, "images/")  # as seen from the test

    def add(self, sheet: Sheet) -> Iterator[NamedContent]:
        if not self.problems:
            self.title = sheet.set.title or "Problems"
            self.rubric = self.head.fragment(instructions(sheet.set))
        for one in sheet.problems:
            parts = parts_for_platforms(one, self.judges.judge(one), self.digits)
            printer = fragments_in(self.language, IMAGES)
            texts = printer.fragment(problem_blocks(one)), printer.fragment(solution_blocks(one, self.digits))
            self.problems.setdefault(one.listed.number, []).append(
                WorkedItem(sheet.variant, one, parts, printer, *texts)
            )
        yield from ()

    def close(self) -> Iterator[NamedContent]:
        images = dict(self.head.files)
        for worked in self.problems.values():
            for one in worked:
                images |= one.printer.files
        for name, dialect in PACKAGES.items():
            problems = [self.packed(worked, dialect) for worked in self.problems.values()]
            yield name, package(dialect, self.title, problems, images, self.rubric, ItemWriter(dialect, self.head))

    def packed(self, worked: list[WorkedItem], dialect: Dialect) -> PackedProblem:
        listed, title = worked[0].one.listed, worked[0].one.marked.title
        return PackedProblem(f"problem-{listed.number}", title, tuple(one.packed(dialect) for one in worked))
