"""Command: `rotsolve key`: sheets and answer keys of problems into a folder, each file whole or not at all, and the exit code."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import SceneError
from rotsolve.keys.files import NamedContent, SheetFiles, sheet_files
from rotsolve.keys.problem_set import (
    ProblemLayout,
    ProblemSet,
    is_sheet_file,
    problem_as_set,
    read_problem_set,
    set_of_files,
)
from rotsolve.keys.sheets import Sheet, SheetProblem
from rotsolve.keys.variants import worked_variants
from rotsolve.language.problem import Problem
from rotsolve.run import advancing
from rotsolve.run.attempt import BAD, PIPED, SOLVED, failure_outcome, scenes
from rotsolve.run.delivery import say, summary, write_file


class KeyRequest(Struct, frozen=True):
    """What the command line asked for; without variants the problems are taken as they stand."""

    files: tuple[str, ...]
    folder: str
    formats: tuple[str, ...] = ("html",)
    variants: int = 0
    seed: int = 1
    solutions: bool = False
    digits: int = 4
    language: str = "en"
    title: str = ""
    paper: str = ""
    pictures: bool = True
    room: Fraction | None = None  # millimetres for each answer
    ruled: bool = False


Makers = Mapping[str, Callable[[KeyRequest], SheetFiles]]  # of formats of rooms below this one, by their names


def run_key(request: KeyRequest, others: Makers = MappingProxyType({})) -> int:
    """Write the files of all problems that can be solved, and say which can not; the exit code is the worst one. `others` make the
    files of formats that are no pages."""
    if PIPED in request.files:
        return refuse_key("keys are made of files, and standard input is none")
    if request.solutions and set(request.formats) == {"csv"}:
        return refuse_key("derivations have no place in CSV; ask for another format beside it, as -f csv -f html")
    try:
        chosen = Problems(asked_set(request), request)
    except SceneError as error:
        return refuse_key(error.render().removeprefix("error: "))
    if request.variants and chosen.problems and not any(problem.vary for problem in chosen.problems.values()):
        return refuse_key("none of these problems says under `vary` what may vary; leave --variants out")
    with advancing("sheets") as tell:
        code = write_files(named_texts(chosen.sheets(tell), makers(request, others, chosen.set.paper)), request.folder)
    if chosen.failed and len(chosen.set.problems) > 1:
        say(summary(chosen.failed, len(chosen.set.problems)), follows=True)
    return max(code, chosen.code)


def asked_set(request: KeyRequest) -> ProblemSet:
    """The problems that a command names, or those of its sheet file, with what the command says of the sheet."""
    files = scenes(request.files)
    alone = len(files) == 1 and is_sheet_file(files[0])
    found = read_problem_set(files[0]) if alone else set_of_files(files)
    listed = tuple(replace(one, layout=asked_layout(one.layout, request)) for one in found.problems)
    return replace(found, title=request.title or found.title, paper=request.paper or found.paper, problems=listed)


def asked_layout(layout: ProblemLayout, request: KeyRequest) -> ProblemLayout:
    """The layout of a problem as the command has it; what that does not say is as before."""
    room = layout.room if request.room is None else request.room
    return replace(layout, room=room, ruled=layout.ruled or request.ruled, picture=layout.picture and request.pictures)


def refuse_key(message: str) -> int:
    print(f"error: {message}", file=sys.stderr)
    return BAD


class Problems:
    """The problems of one command by their numbers; one that fails is said and left out, and loses no other."""

    def __init__(self, set: ProblemSet, request: KeyRequest) -> None:
        self.set, self.request = set, request
        self.code = SOLVED
        self.failed: list[str] = []
        self.problems: dict[int, Problem] = {}
        self.listed = {one.number: one for one in set.problems}
        for number, one in self.listed.items():
            try:
                problem = problem_as_set(one)
            except Exception as error:
                self.fail(number, error)
            else:
                self.problems[number] = problem if request.variants else replace(problem, vary=None)

    def fail(self, number: int, error: Exception) -> None:
        """Say why a problem has no place on the sheets."""
        outcome = failure_outcome(self.listed[number].path, error)
        say(outcome.message, follows=bool(self.failed))
        self.failed.append(outcome.file)
        self.code = max(self.code, outcome.code)

    def sheets(self, tell: Callable[[float], None]) -> Iterator[Sheet]:
        """One sheet for each variant, with all problems that have an answer; it tells how many are behind."""
        count = max(1, self.request.variants)
        drawn = {key: worked_variants(problem, count, self.request.seed) for key, problem in self.problems.items()}
        repeating: dict[int, bool] = {}
        for number in range(1, count + 1):
            found: list[SheetProblem] = []
            for key in [*drawn]:
                try:
                    variant, worked = next(drawn[key])
                except Exception as error:
                    self.fail(key, error)
                    del drawn[key]
                    continue
                if variant.repeats == 1 and self.problems[key].vary is not None and key not in repeating:
                    repeating[key] = True
                    has = f"{number - 1} different variants" if number > 2 else "one variant only"
                    path = self.listed[key].path
                    say(f"note: {path} has {has}: from {number} on they come again", follows=False)
                found.append(SheetProblem(self.listed[key], self.problems[key], worked))
            tell(number / count)
            if found:
                mark = number if self.request.variants else 0
                yield Sheet(mark, tuple(found), self.request.seed, self.set)


def makers(request: KeyRequest, others: Makers, paper: str) -> list[SheetFiles]:
    """What makes the files of each format that is asked for."""
    places = len(str(request.variants)) if request.variants else 0
    return [
        others[name](request)
        if name in others
        else sheet_files(name, places, request.digits, solved=request.solutions, language=request.language, paper=paper)
        for name in request.formats
    ]


def named_texts(sheets: Iterable[Sheet], writers: Sequence[SheetFiles]) -> Iterator[NamedContent]:
    """All files, those of a variant as soon as it is there; none where nothing was solved."""
    empty = True
    for sheet in sheets:
        empty = False
        for writer in writers:
            yield from writer.add(sheet)
    for writer in writers if not empty else ():
        yield from writer.close()


def write_files(files: Iterable[NamedContent], folder: str) -> int:
    """Write the files one by one, each whole or not at all; a run that was interrupted can be run again."""
    for name, content in files:
        try:
            Path(folder).mkdir(parents=True, exist_ok=True)
        except OSError as error:
            return refuse_key(f"cannot make the folder {folder}: {error.strerror or error}")
        code = write_file(str(Path(folder, name)), content)
        if code != SOLVED:
            return code
    return SOLVED
