"""Fault: one thing wrong with a scene, its place and its cure; the errors that rotsolve raises, as printed text."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

INCOMPLETE, CONTRADICTORY = "incomplete", "contradictory"  # kinds of refusals that blame what the scene says
UNREACHED = "unreached"  # of those that say that a motion never comes to a state, which such data are too
UNSOLVED = "unsolved"  # of those that say what the program does not solve: there may be an answer
MOST_RELATED = 4  # places that are shown beside that of a fault
WIDTH = 100  # columns of a source line that are shown around the caret


class Span(Struct, frozen=True):
    """Where something stands in the file: 1-based line and column, length in characters."""

    line: int
    column: int
    length: int = 1


class Related(Struct, frozen=True):
    """Another place of which a fault speaks, with what stands there: "`m` is given here"."""

    span: Span
    note: str


class Fault(Struct, frozen=True):
    """One fault: what is wrong, where, and how to cure it. `kind` is a short word: 'yaml', 'limit', 'name', 'not yet', …

    Of one that is `broken` no more is known than which law or line can not hold. `related` are other places that it speaks of, as
    where a letter is given that is used here. Faults with one `cause`, if they tell any, are told once.
    """

    message: str
    span: Span | None = None
    help: str = ""
    kind: str = "scene"
    broken: bool = False
    related: tuple[Related, ...] = ()
    cause: str = ""


class RotsolveError(Exception):
    """What all errors have in common that rotsolve raises on purpose: the text of each says what is wrong, where, and what would help.

    `file` is '' and `line` and `column`, from 1 on, are None where it is about no place in a file. Errors can be pickled and copied.
    """

    file: str = ""

    @property
    def first(self) -> Fault:
        """The first thing that is wrong."""
        return Fault(str(self))

    @property
    def line(self) -> int | None:
        """The line of the file."""
        return self.first.span.line if self.first.span else None

    @property
    def column(self) -> int | None:
        """The column in that line."""
        return self.first.span.column if self.first.span else None

    @property
    def message(self) -> str:
        """What is wrong, in one sentence."""
        return self.first.message

    @property
    def help(self) -> str:
        """What would help, '' where nothing is known."""
        return self.first.help

    def __reduce__(self) -> tuple[Any, ...]:
        return error_again, (type(self), self.args, self.__dict__)


def error_again(kind: type[RotsolveError], args: tuple[Any, ...], state: Mapping[str, Any]) -> RotsolveError:
    """An error as it was, made by what pickling and copying has kept of it."""
    error = kind.__new__(kind, *args)
    error.args = args
    error.__dict__.update(state)
    return error


class MissingPackage(RotsolveError, ModuleNotFoundError):
    """A package that only some uses of rotsolve take, and that is not installed; says how to get it."""


def missing_package(use: str, name: str, extra: str) -> MissingPackage:
    """`tables take pandas: pip install 'rotsolve[frames]'`."""
    return MissingPackage(f"{use} {name}: pip install 'rotsolve[{extra}]'")


class SceneError(RotsolveError):
    """A scene that can't be read: every fault of the file, in the order of the file."""

    def __init__(self, faults: Iterable[Fault], lines: Sequence[str] = (), file: str = "") -> None:
        self.faults = one_per_cause(faults)
        self.lines = tuple(lines)
        self.file = file
        super().__init__(self.render())

    def render(self) -> str:
        """The text of all faults, a blank line between two."""
        return "\n\n".join(render(fault, self.lines, self.file) for fault in self.faults)

    @property
    def first(self) -> Fault:
        """The first fault of the file."""
        return self.faults[0]

    @property
    def not_yet(self) -> bool:
        """Whether the scene is well formed and only uses words whose physics is not there yet."""
        return all(fault.kind == "not yet" for fault in self.faults)


def one_per_cause(faults: Iterable[Fault]) -> tuple[Fault, ...]:
    """The faults sorted by place, the first one reported at each place; those of one cause, or in the same words, as the first of them,
    which names the others."""
    placed: dict[object, Fault] = {}
    for fault in faults:
        placed.setdefault(place_of(fault) or fault.message, fault)
    found: dict[object, Fault] = {}
    for fault in sorted(placed.values(), key=lambda fault: place_of(fault) or (0, 0)):
        key = fault.cause or (fault.message, fault.help)
        first = found.setdefault(key, fault)
        if first is not fault and fault.span is not None and len(first.related) < MOST_RELATED:
            found[key] = replace(first, related=(*first.related, Related(fault.span, "and here")))
    return tuple(found.values())


def place_of(fault: Fault) -> tuple[int, int] | None:
    """Line and column of a fault that has a place."""
    return (fault.span.line, fault.span.column) if fault.span is not None else None


def render(fault: Fault, lines: Sequence[str], file: str) -> str:
    """One fault as text: message, place, source line with a caret below, the places that are related to it, help."""
    text = [f"error: {printable(fault.message)}"]
    span = fault.span
    shown = [other for other in fault.related if 1 <= other.span.line <= len(lines)]
    gutter = max(
        (len(str(place.line)) for place in (span, *(other.span for other in shown)) if place is not None), default=0
    )
    if span is None:
        if file:
            text.append(f"  --> {printable(file)}")
    else:
        text.append(f"  --> {printable(file)}:{span.line}:{span.column}")
        text.extend(excerpt(span, lines, gutter) if 1 <= span.line <= len(lines) else ())
    before = span.line if span is not None else 0
    for other in shown:
        source, caret = excerpt(other.span, lines, gutter, other.note)
        once = other.span.line == before and len(lines[before - 1]) <= WIDTH  # a line is not clipped twice alike
        text.extend((caret,) if once else (source, caret))
        before = other.span.line
    if fault.help:
        text.append(f"help: {printable(fault.help)}")
    return "\n".join(text)


def excerpt(span: Span, lines: Sequence[str], gutter: int, note: str = "") -> tuple[str, str]:
    """The source line, its number so wide, and the caret line with a note behind it; a long line is clipped around the caret."""
    line = lines[span.line - 1]
    start = min(span.column - 1, len(line))
    length = max(1, min(span.length, len(line) - start))
    first = 0 if len(line) <= WIDTH else max(0, min(start - WIDTH // 3, len(line) - WIDTH))
    shown = printable(line[first : first + WIDTH]).rstrip()
    before, after = "…" if first else "", "…" if first + WIDTH < len(line) else ""
    length = max(1, min(length, first + WIDTH - start))
    indent = " " * (len(before) + start - first)
    caret = f" {' ' * gutter} | {indent}{'^' * length} {printable(note)}".rstrip()
    return f" {span.line:>{gutter}} | {before}{shown}{after}", caret


def printable(text: str) -> str:
    """The text with everything that would move or colour the terminal replaced, one character for one."""
    spaced = text.replace("\t", " ")
    if spaced.isprintable():
        return spaced
    return "".join(character if character.isprintable() else "\N{REPLACEMENT CHARACTER}" for character in spaced)


class Unsolvable(RotsolveError):
    """A well-formed scene without an answer: what is missing, contradictory or out of reach."""

    kind = "unsolvable"

    def __init__(
        self,
        message: str,
        *,
        span: Span | None = None,
        help: str = "",
        lines: Sequence[str] = (),
        file: str = "",
        kind: str = "",
        others: Sequence[Fault] = (),
    ) -> None:
        self.fault = Fault(message, span, help, kind or self.kind)
        self.lines = tuple(lines)
        self.file = file
        self.others = tuple(others)  # why other questions have no answer either
        super().__init__(self.render())

    @property
    def first(self) -> Fault:
        """Why there is no answer."""
        return self.fault

    def render(self) -> str:
        """The message with its place, as printed, and those of other questions."""
        told = dict.fromkeys(render(fault, self.lines, self.file) for fault in (self.fault, *self.others))
        return "\n\n".join(told)


class Contradicted(Unsolvable):
    """A scene whose data contradict each other, so that no question about what they tell has an answer."""

    kind = CONTRADICTORY

    def retold(self, fault: Fault) -> None:
        """Tell it by another fault, which says more of why."""
        self.fault = fault
        self.args = (self.render(),)


class Impossible(Unsolvable):
    """An asked letter that would have to be what it can not be: what hangs on it has no answer either."""


class NoSteadyMotion(Unsolvable):
    """A state that is said to be steady, with which no steady motion goes: nothing that is asked of it has an answer."""


class NeverReached(Contradicted):
    """A `state` to which the motion never gets: what is asked of the states before it may have an answer.

    Where that is `sure` it does not get there on its way back either.
    """

    kind = UNREACHED
    state = ""
    sure = False
