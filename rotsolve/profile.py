"""Profile: where the time of a solution goes, stage by stage. While nobody asks for one, a stage costs one comparison.

    with recording() as profile:
        with stage("read"):
            …
    profile.spent  # {"read": 0.0012, "import": 0.0031} in seconds of processor time

A stage within another takes its time from that one, unless the outer one is `whole`: what a check plans and solves is time of the check.
"""

from __future__ import annotations

import builtins
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, nullcontext
from functools import wraps
from time import process_time
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])
IMPORT = "import"
NOTHING: Any = nullcontext()


class Profile:
    """The seconds spent in each stage, those of a kind of work within all stages, and what was left out."""

    def __init__(self) -> None:
        self.began = process_time()
        self.spent: dict[str, float] = {}
        self.within: dict[str, float] = {}
        self.skipped: dict[str, list[str]] = {}
        self.counts: dict[str, int] = {}
        self._open: list[tuple[str, bool]] = []
        self._kinds: set[str] = set()
        self._changed = self.began

    @contextmanager
    def stage(self, name: str, whole: bool) -> Iterator[None]:
        outer = self._open[-1] if self._open else ("", False)
        self._book()
        self._open.append(outer if outer[1] and name != IMPORT else (name, whole))
        try:
            yield
        finally:
            self._book()
            self._open.pop()

    def _book(self) -> None:
        """The time since the last change of stages belongs to the innermost one."""
        now = process_time()
        if self._open:
            name = self._open[-1][0]
            self.spent[name] = self.spent.get(name, 0.0) + now - self._changed
        self._changed = now

    @contextmanager
    def kind(self, name: str) -> Iterator[None]:
        """Work of one kind, in whatever stage it is done; work within such work counts once."""
        if name in self._kinds:
            yield
            return
        self._kinds.add(name)
        start = process_time()
        try:
            yield
        finally:
            self._kinds.remove(name)
            self.within[name] = self.within.get(name, 0.0) + process_time() - start


_profile: Profile | None = None


def stage(name: str, *, whole: bool = False) -> Any:
    """A stage of the solution, for `with`."""
    return NOTHING if _profile is None else _profile.stage(name, whole)


def staged(name: str) -> Callable[[Function], Function]:
    """A function that is a stage of the solution."""
    return measured(lambda profile: profile.stage(name, False))


def of_kind(name: str) -> Callable[[Function], Function]:
    """A function that does a kind of work in several stages."""
    return measured(lambda profile: profile.kind(name))


def measured(booked: Callable[[Profile], Any]) -> Callable[[Function], Function]:
    """A function whose time is booked where a profile is recorded."""

    def decorate(function: Function) -> Function:
        @wraps(function)
        def timed(*given: Any, **named: Any) -> Any:
            if _profile is None:
                return function(*given, **named)
            with booked(_profile):
                return function(*given, **named)

        return cast(Function, timed)

    return decorate


def skipped(what: str, names: Iterable[str]) -> None:
    """What a solution has left out, as the bodies that no law is written for."""
    if _profile is not None:
        _profile.skipped.setdefault(what, []).extend(names)


def counted(what: str, number: int) -> None:
    """How many there were, as of equations."""
    if _profile is not None:
        _profile.counts[what] = _profile.counts.get(what, 0) + number


@contextmanager
def recording() -> Iterator[Profile]:
    """All stages within are recorded, and imports as a stage of their own."""
    global _profile
    before, plain_import = _profile, builtins.__import__
    profile = _profile = Profile()

    def timed_import(*given: Any, **named: Any) -> Any:
        with profile.stage(IMPORT, True):
            return plain_import(*given, **named)

    builtins.__import__ = timed_import
    try:
        yield profile
    finally:
        _profile, builtins.__import__ = before, plain_import
