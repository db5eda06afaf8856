"""Command: `rotsolve key`: sheets and answer keys of problems into a folder, each file whole or not at all, and the exit code."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.keys.files import NamedContent, sheet_files
from rotsolve.keys.sheets import Sheet
from rotsolve.keys.variants import worked_variants
from rotsolve.keys.working import Worked
from rotsolve.language.problem import Problem
from rotsolve.run import advancing
from rotsolve.run.attempt import BAD, PIPED, SOLVED, failure_outcome, scenes
from rotsolve.run.delivery import say, summary, write_file
from rotsolve.scene.read import read_file


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


def run_key(request: KeyRequest) -> int:
    """Write the files of all problems that can be solved, and say which can not; the exit code is the worst one."""
    files = scenes(request.files)
    if PIPED in files:
        return refuse_key("keys are made of files, and standard input is none")
    if request.solutions and set(request.formats) == {"csv"}:
        return refuse_key("derivations have no place in CSV; ask for another format beside it, as -f csv -f html")
    chosen = Problems(files, request)
    if request.variants and chosen.problems and not any(problem.vary for problem in chosen.problems.values()):
        return refuse_key("none of these problems says under `vary` what may vary; leave --variants out")
    with advancing("sheets") as tell:
        code = write_files(named_texts(chosen.sheets(tell), request), request.folder)
    if chosen.failed and len(files) > 1:
        say(summary(chosen.failed, len(files)), follows=True)
    return max(code, chosen.code)


def refuse_key(message: str) -> int:
    print(f"error: {message}", file=sys.stderr)
    return BAD


class Problems:
    """The problems of one command by their names; one that fails is said and left out, and loses no other."""

    def __init__(self, files: Sequence[str], request: KeyRequest) -> None:
        self.request = request
        self.code = SOLVED
        self.failed: list[str] = []
        self.problems: dict[str, Problem] = {}
        self.files = dict(zip(problem_names(files), files, strict=True))
        for name, file in self.files.items():
            try:
                problem = read_file(file)
            except Exception as error:
                self.fail(name, error)
            else:
                self.problems[name] = problem if request.variants else replace(problem, vary=None)

    def fail(self, name: str, error: Exception) -> None:
        """Say why a problem has no place on the sheets."""
        outcome = failure_outcome(self.files[name], error)
        say(outcome.message, follows=bool(self.failed))
        self.failed.append(outcome.file)
        self.code = max(self.code, outcome.code)

    def sheets(self, tell: Callable[[float], None]) -> Iterator[Sheet]:
        """One sheet for each variant, with all problems that have an answer; it tells how many are behind."""
        count = max(1, self.request.variants)
        drawn = {name: worked_variants(problem, count, self.request.seed) for name, problem in self.problems.items()}
        repeating = set[str]()
        for number in range(1, count + 1):
            found: list[tuple[str, Worked]] = []
            for name in [*drawn]:
                try:
                    variant, worked = next(drawn[name])
                except Exception as error:
                    self.fail(name, error)
                    del drawn[name]
                    continue
                if variant.repeats == 1 and self.problems[name].vary is not None and name not in repeating:
                    repeating.add(name)
                    has = f"{number - 1} different variants" if number > 2 else "one variant only"
                    say(f"note: {self.files[name]} has {has}: from {number} on they come again", follows=False)
                found.append((name, worked))
            tell(number / count)
            if found:
                yield Sheet(number if self.request.variants else 0, tuple(found), self.request.seed)


def problem_names(files: Sequence[str]) -> list[str]:
    """The names of the problems: those of their files, with their folders where two files have one name."""
    count = Counter(Path(file).stem for file in files)
    return [Path(file).stem if count[Path(file).stem] == 1 else str(Path(file).with_suffix("")) for file in files]


def named_texts(sheets: Iterable[Sheet], request: KeyRequest) -> Iterator[NamedContent]:
    """All files, those of a variant as soon as it is there; none where nothing was solved."""
    places = len(str(request.variants)) if request.variants else 0
    writers = [
        sheet_files(name, places, request.digits, solved=request.solutions, language=request.language)
        for name in request.formats
    ]
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
