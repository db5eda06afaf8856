"""YAML's traps in words: what its parser stumbles over, and what it reads quietly as something else."""

from __future__ import annotations

import re
from typing import Any

from rotsolve.core.faults import Fault, Span
from rotsolve.language.words import quoted

QUOTE = "put the text in quotes"
DEPTH = 40
TOO_DEEP = f"more than {DEPTH} levels inside one another", "a scene needs no more than ten"


def alias(name: str, span: Span) -> Fault:
    message = f"{quoted('*' + name)} is a YAML alias, which scenes don't use"
    return Fault(message, span, f"a product needs two factors; for a text that starts with `*`, {QUOTE}", "yaml")


def anchor(name: str, span: Span) -> Fault:
    message = f"{quoted('&' + name)} is a YAML anchor, which scenes don't use"
    return Fault(message, span, f"for a text that starts with `&`, {QUOTE}", "yaml")


def tag(name: str, span: Span) -> Fault:
    message = f"{quoted(name)} is a YAML tag, which scenes don't use"
    return Fault(message, span, f"for a text that starts with `!`, {QUOTE}", "yaml")


def no_yaml(problem: str) -> Fault:
    return Fault(f"this is not YAML: {problem}", None, "see docs/language.md for a scene to start from", "yaml")


def yaml_fault(error: Any, lines: tuple[str, ...]) -> Fault:
    """The parser's complaint in the scene's words."""
    mark = error.problem_mark or error.context_mark
    problem = str(error.problem or error.context or "")
    if "quoted scalar" in f"{error.context} {problem}":
        mark = error.context_mark or mark
        problem = "quoted scalar"
    if mark is None:
        return no_yaml(problem)
    line = lines[mark.line] if mark.line < len(lines) else ""
    span = Span(mark.line + 1, mark.column + 1)
    message, help = explained(problem, line, mark.column, lines[: mark.line + 1])
    return Fault(message, span, help, "yaml")


def explained(problem: str, line: str, column: int, above: tuple[str, ...]) -> tuple[str, str]:
    """What is wrong and the cure, by the parser's words and the character that it stands at."""
    here = line[column : column + 1]
    if here == "\t" or "\t" in line[: len(line) - len(line.lstrip())]:
        return "a tab in the indentation", "indent with spaces"
    if "mapping values are not allowed" in problem or "<document start>" in problem:
        before = next((text.strip() for text in reversed(above[:-1]) if text.strip() and text.strip()[0] != "#"), "")
        if before and ":" not in before:
            return f"the line before this has no colon: {quoted(before)}", "write `name: value`"
    if "mapping values are not allowed" in problem:
        return "a `: ` inside a text", f'{QUOTE}: `title: "Ball: up and down"`; or the line above is indented less'
    if re.search(r"[\]}]\s*$", line[:column]) and here and here not in ",]}:":
        behind = quoted(line[column:].strip())
        return f"text after a closing bracket: {behind}", "a unit belongs to each number: `[0, 3 N]`"
    if "cannot start any token" in problem:
        return f"a value can't start with {quoted(here)}", QUOTE
    if "undefined alias" in problem or "alias or anchor" in problem or "expected alphabetic or numeric" in problem:
        return "a value that starts with `*` or `&`", QUOTE
    if "quoted scalar" in problem or "found unexpected end of stream" in problem:
        return "a quotation mark that is never closed", "close it, or leave both out"
    if "expected ',' or" in problem:
        return (
            "a bracket that is never closed, or a comma missing",
            'write `{a: 1, b: 2}` and `[a, b]`; a phrase with brackets in it stands in quotes within `{…}`: "b.inertia along [1, 0, 1]"',
        )
    if "expected ':'" in problem:
        return "a name without `: value`", "write `name: value`, with a space after the colon"
    if "nesting depth" in problem:  # PyYAML 6.0.4 reads ahead of its events, and gives up by itself at 1000 levels
        return TOO_DEEP
    if "special characters" in problem or "control characters" in problem:
        return "a control character", "keep the file to plain text"
    return f"this is not YAML: {problem}", "check indentation, brackets and quotation marks"


def null_fault(name: str, span: Span, before: str) -> Fault:
    """A key without a value: `{post: }`, a comma inside a number or a bracket, a missing space after the colon."""
    if before.count("(") > before.count(")") or re.fullmatch(r"[^(]*\)", name):
        return Fault("a comma inside brackets splits this value", span, f'{QUOTE}: `{{p: "f(x, y)"}}`', "yaml")
    if re.match(r"\d", name):
        message = f"a comma splits this value: {quoted(name)} stands alone"
        return Fault(message, span, "write a decimal point: `12.5 kg`", "yaml")
    match = re.fullmatch(r"([A-Za-z]\w*):(\S.*)", name)
    if match:
        return Fault(f"no space after the colon in {quoted(name)}", span, f"write `{match[1]}: {match[2]}`", "yaml")
    help = f"write `{name if len(name) < 30 else 'name'}: …`, or remove it"
    return Fault(f"{quoted(name)} has no value", span, help, "yaml")
