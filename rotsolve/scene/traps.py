"""YAML's traps in words: what its parser stumbles over, and what it reads quietly as something else."""

from __future__ import annotations

import re
from typing import Any

from rotsolve.core.faults import Fault, Related, Span
from rotsolve.language.words import quoted
from rotsolve.scene.tree import DEPTH

QUOTE, UNQUOTE = "put the text in quotes", "close it, or leave both out"
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


def merge(span: Span) -> Fault:
    return Fault("`<<` is a YAML merge, which scenes don't use", span, "write the keys themselves", "yaml")


def no_yaml(problem: str) -> Fault:
    return Fault(f"this is not YAML: {problem}", None, "see docs/language.md for a scene to start from", "yaml")


def yaml_fault(error: Any, lines: tuple[str, ...]) -> Fault:
    """The parser's complaint in the scene's words."""
    from rotsolve.scene.brackets import bracket_fault  # only a faulty scene pays for it

    mark = error.problem_mark or error.context_mark
    problem = str(error.problem or error.context or "")
    if "quoted scalar" in f"{error.context} {problem}":
        mark = error.context_mark or mark
        problem = "quoted scalar"
    if mark is None:
        return no_yaml(problem)
    line = lines[mark.line] if mark.line < len(lines) else ""
    if "\t" in line[: len(line) - len(line.lstrip())]:
        tabs = line[: len(line) - len(line.lstrip())]
        span = Span(mark.line + 1, tabs.index("\t") + 1, tabs.count("\t"))
        return Fault("a tab in the indentation", span, "indent with spaces", "yaml")
    bare = (
        None
        if "quoted scalar" in problem or "nesting" in problem
        else bracket_fault(lines) or misplaced(problem, mark, lines)
    )
    if bare is not None:
        return bare
    if "expected ',' or" in problem and re.search(r"[\]}]\s*$", line[: mark.column]) is None:
        return no_comma(mark, line)
    message, help = explained(problem, line, mark.column)
    return Fault(message, Span(mark.line + 1, mark.column + 1), help, "yaml")


def misplaced(problem: str, mark: Any, lines: tuple[str, ...]) -> Fault | None:
    """A line without its colon, or indented as no other is, which is seen in the lines above the parser's place; None where none is."""
    above = next(
        (number for number in range(min(mark.line, len(lines)) - 1, -1, -1) if holds_text(lines[number])), None
    )
    line, before = lines[mark.line] if mark.line < len(lines) else "", "" if above is None else lines[above]
    text, indent, before_indent = before.strip(), indented(line), indented(before)
    if above is None or "expected ',' or" in problem:
        return None
    span = Span(above + 1, before_indent + 1, len(text))
    if not re.search(r":(\s|$)", text) and not text.startswith(("-", "#")):
        return without_colon(text, span) if "indicator" not in problem else None
    if "indicator" in problem:
        return in_no_list(line, mark.line, lines)
    own = Span(mark.line + 1, indent + 1, max(1, len(line.strip())))
    related = (Related(span, f"indented by {before_indent}"),)
    if "mapping values" in problem and indent > before_indent and re.match(r"[^\s:]+:\s", line.strip()):
        message = f"this line is indented by {indent}, further than the one above it, which holds a value already"
        return Fault(message, own, f"indent it by {before_indent}, as the line above", "yaml", related=related)
    if "expected key" in problem or "expected <block end>" in problem:
        open_ = sorted(
            {indented(lines[number]) for number in range(above + 1) if holds_text(lines[number])}, reverse=True
        )
        fitting = min(open_, key=lambda other: abs(other - indent))
        if indent not in open_ or before_indent > indent:
            message = f"this line is indented by {indent}, which fits no line above"
            return Fault(
                message, own, f"indent it as the line to which it belongs, by {fitting}", "yaml", related=related
            )
    return None


def holds_text(line: str) -> bool:
    """Whether a line holds more than blanks and a comment."""
    return bool(line.strip()) and not line.lstrip().startswith("#")


def indented(line: str) -> int:
    """How many blanks stand in front of a line."""
    return len(line) - len(line.lstrip(" "))


def without_colon(text: str, span: Span) -> Fault:
    """A line that is no `name: value`: what it may have meant."""
    name, _, value = text.partition(" ")
    squeezed = re.fullmatch(r"([A-Za-z]\w*):(\S.*)", text)
    if squeezed:
        return Fault(
            f"no space after the colon in {quoted(text)}", span, f"write `{squeezed[1]}: {squeezed[2]}`", "yaml"
        )
    meant = re.fullmatch(r"([A-Za-z][\w.]*)\s*(?:=|\s)\s*(\S.*)", text)
    help = f"write `{meant[1]}: {meant[2]}`" if meant else f"write `{name}:`" if not value else "write `name: value`"
    return Fault(f"no colon in {quoted(text)}", span, help, "yaml")


def in_no_list(line: str, number: int, lines: tuple[str, ...]) -> Fault | None:
    """A line behind `- …` lines that has no `-`: the list is none."""
    begins = (
        k for k in range(number - 1, -1, -1) if re.match(r"\s*-\s", lines[k]) and indented(lines[k]) <= indented(line)
    )
    first = next(begins, None)
    if first is None:
        return None
    here = Related(Span(number + 1, indented(line) + 1, len(line.strip())), "goes on without it")
    help = "leave out the `-`: a scene has `name: value` lines"
    return Fault("`-` begins a list", Span(first + 1, indented(lines[first]) + 1), help, "yaml", related=(here,))


def explained(problem: str, line: str, column: int) -> tuple[str, str]:
    """What is wrong and the cure, by the parser's words and the character that it stands at."""
    here = line[column : column + 1]
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
        return "a quotation mark that is never closed", UNQUOTE
    if "expected ',' or" in problem:
        return "a comma is missing", "write `{a: 1, b: 2}` and `[a, b]`"
    if "expected ':'" in problem:
        return "a name without `: value`", "write `name: value`, with a space after the colon"
    if "nesting depth" in problem:  # PyYAML 6.0.4 reads ahead of its events, and gives up by itself at 1000 levels
        return TOO_DEEP
    if "special characters" in problem or "control characters" in problem:
        return "a control character", "keep the file to plain text"
    return f"this is not YAML: {problem}", "check indentation, brackets and quotation marks"


def no_comma(mark: Any, line: str) -> Fault:
    """Within brackets something follows a value: a bracket of its own, or the next name without a comma before it."""
    here, place = line[mark.column : mark.column + 1], Span(mark.line + 1, mark.column + 1)
    if here in ("[", "{"):
        help = f'{QUOTE} within `{{…}}`: "b.inertia along [1, 0, 1]"; or a comma is missing'
        return Fault(f"a `{here}` inside a text", place, help, "yaml")
    before, name = re.fullmatch(r"(.*?)([\w.]*)", line[: mark.column], re.DOTALL).groups()  # type: ignore[union-attr]
    if before.rstrip().endswith(";"):
        return Fault("`;` where a comma is wanted", Span(mark.line + 1, len(before.rstrip())), "write `,`", "yaml")
    if not name:
        return Fault("a comma is missing", place, "write `{a: 1, b: 2}` and `[a, b]`", "yaml")
    return Fault(
        f"no comma before `{name}`", Span(mark.line + 1, len(before) + 1, len(name)), f"write `, {name}`", "yaml"
    )


def null_fault(name: str, span: Span, before: str) -> Fault:
    """A key without a value: `{post: }`, a comma inside a number or a bracket, a missing space after the colon."""
    if before.count("(") > before.count(")") or re.fullmatch(r"[^(]*\)", name):
        return Fault("a comma inside brackets splits this value", span, f'{QUOTE}: `{{p: "f(x, y)"}}`', "yaml")
    if re.match(r"\d", name):
        message = f"a comma splits this value: {quoted(name)} stands alone"
        number = f"{before.strip()}.{name}" if re.fullmatch(r"[-+]?\d+", before.strip()) else "12.5 kg"
        return Fault(message, span, f"write a decimal point: `{number}`", "yaml")
    match = re.fullmatch(r"([A-Za-z]\w*):(\S.*)", name)
    if match:
        return Fault(f"no space after the colon in {quoted(name)}", span, f"write `{match[1]}: {match[2]}`", "yaml")
    if name == "at rest":
        return Fault("`at rest` does not say of what", span, "write `at rest: all`", "yaml")
    if re.fullmatch(r"[A-Za-z][\w.]*(\s*=\s*|\s+)\S.*", name, re.DOTALL):
        return without_colon(name, span)
    help = f"write `{name if len(name) < 30 else 'name'}: …`, or remove it"
    return Fault(f"{quoted(name)} has no value", span, help, "yaml")
