"""Read a scene: YAML text -> Problem, with all faults of the file at once."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping

from rotsolve.core.faults import Fault, SceneError
from rotsolve.language.problem import Problem
from rotsolve.language.words import quoted
from rotsolve.scene.reader.sections import Sections
from rotsolve.scene.reader.within import beyond_ends
from rotsolve.scene.tree.nodes import BYTES, Node, compose
from rotsolve.scene.values.scope import Scope

# what no text holds, and YAML's parser refuses
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufffe\uffff]")


def read_source(source: str | os.PathLike[str], settings: Mapping[str, str] | None = None) -> Problem:
    """The problem in a file, or in YAML text: a text has a line break, a path has none."""
    if isinstance(source, str) and "\n" in source:
        return read_text(source, settings=settings)
    return read_file(source, settings=settings)


def read_file(path: str | os.PathLike[str], settings: Mapping[str, str] | None = None) -> Problem:
    """The problem in a file; its size is checked before it is read."""
    name = os.fspath(path)
    try:
        size = os.path.getsize(name)
        if size > BYTES:
            raise too_large(size, name)
        with open(name, "rb") as stream:
            content = stream.read(BYTES + 1)
    except OSError as error:
        reason = error.strerror or "it can't be read"
        raise SceneError([Fault(f"can't read {quoted(name)}: {reason}", None, "", "file")]) from None
    if len(content) > BYTES:
        raise too_large(len(content), name)
    if b"\0" in content:
        raise SceneError(
            [Fault("this is no text file: it holds a NUL byte", None, "a scene is YAML text in UTF-8", "file")],
            (),
            name,
        )
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        message = f"line {line} is not UTF-8"
        raise SceneError([Fault(message, None, "save the file as UTF-8", "file")], (), name) from None
    return read_text(text, name, settings)


def too_large(size: int, name: str) -> SceneError:
    return SceneError(
        [Fault(f"the file has {size} bytes, more than {BYTES}", None, "a scene is a page of text", "limit")], (), name
    )


def read_text(text: str, file: str = "<text>", settings: Mapping[str, str] | None = None) -> Problem:
    """The problem in a text. Raises SceneError with all faults."""
    if len(text) > BYTES:
        raise too_large(len(text), file)
    text = text.replace("\r\n", "\n").replace("\r", "\n").removeprefix("\ufeff")
    control = CONTROL.search(text)
    if control is not None:
        line = text.count("\n", 0, control.start()) + 1
        message = f"a control character, U+{ord(control[0]):04X}, in line {line}"
        raise SceneError([Fault(message, None, "a scene is YAML text in UTF-8", "file")], (), file)
    return read_tree(*compose(text, file), file, settings)


def read_tree(
    root: Node, lines: tuple[str, ...], file: str = "<text>", settings: Mapping[str, str] | None = None
) -> Problem:
    """The problem in the tree of a text."""
    scope = Scope()
    problem = Sections(scope, root, dict(settings or {})).problem(file, lines)
    scope.faults.extend(beyond_ends(problem, scope.numbers) if problem is not None else ())
    if scope.faults:
        raise SceneError(scope.faults, lines, file)
    assert problem is not None
    return problem
