"""Problem set: which problems a sheet has, in which order, under which names, with which points and how much room: of a sheet file, or
of the problems that a command names.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Number
from rotsolve.algebra.units.dimension import LENGTH
from rotsolve.core.faults import SceneError, Span
from rotsolve.keys.parts import scaled_marking
from rotsolve.language.keys import Key
from rotsolve.language.problem import Problem
from rotsolve.language.sheet_keys import A4, LISTED, SHEET
from rotsolve.language.words import hint, quoted
from rotsolve.scene.elements import read_choice, read_flag
from rotsolve.scene.literals import parsed_quantity
from rotsolve.scene.marking import read_marks
from rotsolve.scene.read import is_sheet, read_file, text_of_file, tree_of_text
from rotsolve.scene.scope import Scope
from rotsolve.scene.statement import check_text
from rotsolve.scene.tree import List, Map, Node, Text

SHORT_NAME = re.compile(r"(?!\d+$)[\w-]{1,40}")
Entries = dict[str, tuple[Text, Node]]
ROOM = Fraction(20)  # millimetres for an answer
MOST_ROOM = 250


class ProblemLayout(Struct, frozen=True):
    """How a problem stands on the paper: the millimetres of room for each answer, with lines or blank, its picture, a page of its own."""

    room: Fraction = ROOM
    ruled: bool = False
    picture: bool = True
    new_page: bool = False


USUAL = ProblemLayout()


class SetProblem(Struct, frozen=True):
    """A problem of a set: its number from 1 on, its short name, its file, and its points where the sheet tells them."""

    number: int
    name: str
    path: str
    points: Fraction | None = None
    layout: ProblemLayout = USUAL
    span: Span | None = None


class ProblemSet(Struct, frozen=True):
    """The problems of a sheet, and what stands at its head; `file` and `lines` are those of the sheet file, if there is one."""

    title: str
    problems: tuple[SetProblem, ...]
    course: str = ""
    date: str = ""
    instructions: str = ""
    paper: str = A4
    file: str = ""
    lines: tuple[str, ...] = ()

    def listed(self, word: str) -> SetProblem | None:
        """The problem with this number or short name, as `1` or `roll` in the column `roll.a` of a class."""
        return next((one for one in self.problems if word in (str(one.number), one.name)), None)


def set_of_files(files: Sequence[str], title: str = "", paper: str = A4, layout: ProblemLayout = USUAL) -> ProblemSet:
    """The problems of some files in their order, each by the stem of its file, with the folder where two have one stem."""
    count = Counter(Path(file).stem for file in files)
    names = [Path(file).stem if count[Path(file).stem] == 1 else str(Path(file).with_suffix("")) for file in files]
    listed = (
        SetProblem(number, name, file, layout=layout)
        for number, (name, file) in enumerate(zip(names, files, strict=True), 1)
    )
    return ProblemSet(title, tuple(listed), paper=paper)


def is_sheet_file(path: str) -> bool:
    """Whether a file lists problems, and is none itself; what can't be read is no sheet, so that its reader says why."""
    try:
        return is_sheet(tree_of_text(text_of_file(path), path)[0])
    except SceneError:
        return False


def read_problem_set(path: str | os.PathLike[str]) -> ProblemSet:
    """The set that a sheet file lists. Raises SceneError with all faults of the file; the problems themselves are not read."""
    file = os.fspath(path)
    root, lines = tree_of_text(text_of_file(file), file)
    return SetReader(root, file, lines).read()


def problem_as_set(one: SetProblem) -> Problem:
    """The problem of a file, marked in the points of its sheet. Raises SceneError with the faults of that file."""
    problem = read_file(one.path)
    return replace(problem, marking=scaled_marking(problem, one.points))


class SetReader:
    """Reads a sheet file; all its faults are told at once."""

    def __init__(self, root: Node, file: str, lines: tuple[str, ...]) -> None:
        self.root, self.file, self.lines = root, file, lines
        self.scope = Scope()

    def read(self) -> ProblemSet:
        scope = self.scope
        entries = scope.entries(self.root, "a sheet", SHEET)
        written = {key.value for key, _ in self.root.entries} if isinstance(self.root, Map) else {*SHEET}
        for word, key in SHEET.items():
            if key.required and word not in written:
                scope.fault(None, f"the sheet has no `{word}`", f"add it: {key.help}", "missing")
        said = {word: self.value(SHEET[word], node, word) for word, (_, node) in entries.items() if word != "problems"}
        known = {word: value for word, value in said.items() if value is not None}
        usual = layout_of(USUAL, known)
        problems = tuple(self.problems(entries["problems"][1], usual)) if "problems" in entries else ()
        if "instructions" in entries:
            check_text(scope, entries["instructions"][1], self.lines, "`instructions`", self.file)
        if scope.faults:
            raise SceneError(scope.faults, self.lines, self.file)
        texts = {word: known.get(word, "") for word in ("course", "date", "instructions")}
        return ProblemSet(
            known["sheet"], problems, **texts, paper=known.get("paper", A4), file=self.file, lines=self.lines
        )

    def problems(self, node: Node, usual: ProblemLayout) -> Iterator[SetProblem]:
        """The problems in their order; those with a fault are left out."""
        items = node.items if isinstance(node, List) else (node,)
        if not items or isinstance(node, Map):
            self.scope.fault(
                node, "`problems` wants a list of files", "write `problems: [winch.yaml, roll.yaml]`", "form"
            )
            return
        names: dict[str, Span] = {}
        for number, item in enumerate(items, 1):
            listed = self.listed(number, item, usual)
            if listed is not None and listed.span is not None:
                if listed.name in names:
                    message = f"two problems are called `{listed.name}`, the first in line {names[listed.name].line}"
                    help = "give one of them another name: `{problem: …, name: …}`"
                    self.scope.fault(listed.span, message, help, "name")
                names.setdefault(listed.name, listed.span)
                yield listed

    def listed(self, number: int, item: Node, usual: ProblemLayout) -> SetProblem | None:
        """One problem: a file alone, or a map."""
        if isinstance(item, Text):
            entries: Entries = {"problem": (item, item)} if not item.empty else {}
        else:
            entries = self.scope.entries(item, f"problem {number}", LISTED)
        if "problem" not in entries:
            help = "name its file: `winch.yaml`, or `{problem: winch.yaml, points: 6}`"
            return self.scope.fault(item, f"problem {number} of the sheet has no file", help, "missing")
        said = {word: self.value(LISTED[word], node, word) for word, (_, node) in entries.items()}
        known = {word: value for word, value in said.items() if value is not None}
        if "problem" not in known or len(known) < len(said):
            return None
        path, place = known["problem"], entries.get("name", entries["problem"])[1]
        name = known.get("name") or Path(path).stem
        if not SHORT_NAME.fullmatch(name):
            message = f"{quoted(name)} can't be the short name of a problem"
            help = "write `name:` with letters, digits, `-` and `_`, of which not all are digits"
            return self.scope.fault(place, message, help, "name")
        return SetProblem(number, name, path, known.get("points"), layout_of(usual, known), place.span)

    def value(self, key: Key, node: Node, word: str) -> Any:
        """What stands under a key; None after a fault."""
        return READERS[key.kind](self, key, node, word)

    def text(self, key: Key, node: Node, word: str) -> str | None:
        if isinstance(node, Text):
            return node.value.strip()
        return self.scope.fault(node, f"`{word}` wants a text", "put it in quotes", "form")

    def problem_file(self, key: Key, node: Node, word: str) -> str | None:
        """A file that is there, as seen from here."""
        written = self.text(key, node, word)
        if written is None:
            return None
        path = Path(self.file).parent / written
        if path.is_file():
            return str(path)
        folder = path.parent
        there = sorted(item.name for item in folder.glob("*.yaml")) if folder.is_dir() else []
        message = f"there is no file {quoted(written)}" + (f" in {quoted(str(folder))}" if folder.is_dir() else "")
        return self.scope.fault(node, message, hint(path.name, there[:20], "scenes"), "file")

    def room(self, key: Key, node: Node, word: str) -> Fraction | None:
        """Millimetres of room for an answer."""
        found = room_in_mm(node.value) if isinstance(node, Text) else None
        if found is not None:
            return found
        return self.scope.fault(
            node,
            f"`{word}` can't be {node.shown}",
            f"write a height up to {MOST_ROOM} mm, such as `3 cm`, or `none`",
            "form",
        )


def layout_of(usual: ProblemLayout, known: dict[str, Any]) -> ProblemLayout:
    """The layout with what keys say of it."""
    picture = known.get("picture", known.get("pictures", usual.picture))
    return ProblemLayout(known.get("room", usual.room), known.get("ruled", usual.ruled), picture, "page" in known)


def room_in_mm(text: str) -> Fraction | None:
    """The millimetres of `3 cm`, 0 for `none`; None for what is no height that a page has."""
    if text.strip() in ("none", "0"):
        return Fraction(0)
    found = parsed_quantity(text.strip())
    if found is None or not found.dimension.matches(LENGTH) or not isinstance(found.value, Number):
        return None
    return found.value.value * 1000 if 0 <= found.value.value * 1000 <= MOST_ROOM else None


READERS: dict[str, Callable[[SetReader, Key, Node, str], Any]] = {
    "text": SetReader.text,
    "word": SetReader.text,
    "file": SetReader.problem_file,
    "room": SetReader.room,
    "choice": lambda reader, key, node, word: read_choice(reader.scope, key, node, word, ""),
    "flag": lambda reader, key, node, word: read_flag(reader.scope, key, node, word, ""),
    "marks": lambda reader, key, node, word: read_marks(reader.scope, key, node, word),
}
