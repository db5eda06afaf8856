"""Remembered: what a frozen object answers once, it answers the same way ever after."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from typing import Any, TypeVar, cast

Method = TypeVar("Method", bound=Callable[..., Any])


def remembered(method: Method) -> Method:
    """A method that keeps its answers with its object, which must not change; the arguments must be hashable, and be no keywords.

    functools.cache would hash the whole object at each call, and keep it alive.
    """
    name = f"_{method.__name__}_answers"

    @wraps(method)
    def answer(self: Any, *asked: Any) -> Any:
        try:
            return self.__dict__[name][asked]
        except KeyError:
            pass
        found = method(self, *asked)
        self.__dict__.setdefault(name, {})[asked] = found
        return found

    return cast(Method, answer)


@contextmanager
def forgetting(*objects: object) -> Iterator[None]:
    """What objects are asked inside leaves no answers with them: whoever asks again has it worked out, and noted, anew."""
    kept = [{name: dict(known) for name, known in vars(one).items() if name.endswith("_answers")} for one in objects]
    try:
        yield
    finally:
        for one, answers in zip(objects, kept, strict=True):
            for name in [name for name in vars(one) if name.endswith("_answers")]:
                vars(one)[name] = answers.get(name, {})
