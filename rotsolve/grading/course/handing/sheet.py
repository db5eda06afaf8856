"""Sheet: what one student hands in, as lines of text or as YAML."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.handing.content import MARK, HandedInError
from rotsolve.grading.course.handing.naming import meant, split
from rotsolve.grading.verdict import Paper
from rotsolve.language.words import hint, quoted
from rotsolve.scene.tree.nodes import List, Map, Node, Text, compose

YAML = (".yaml", ".yml")
STUDENT, VARIANT, WORKING = "student", "variant", "working"
OWN = (STUDENT, VARIANT, WORKING)  # keys beside the names of the answers
MARGIN = re.compile(r"\s|#|-\s|[\w\\$]+:(\s|$)")  # how each line of a YAML map begins
LINES, LONGEST = 10_000, 200_000


def read_sheet(text: str, file: str, asked: Sequence[str]) -> Paper:
    """The paper of one student. The file's name says whether it is YAML; of what has no such name, its lines do."""
    text = text.removeprefix(MARK)
    lines = text.split("\n")
    if not text.strip():
        raise HandedInError([Fault("nothing is handed in", None, f"write `{asked[0]} = …`", "file")], (), file)
    if len(lines) > LINES or len(text) > LONGEST:
        message = f"more than {LINES} lines or {LONGEST} characters"
        raise HandedInError([Fault(message, None, "hand in one student's answers; a class is a .csv")], (), file)
    named_so = file.lower().endswith(YAML)
    if named_so or all(MARGIN.match(line) for line in lines if line):
        return from_yaml(text, file, asked)
    return from_lines(lines, file, asked)


def from_lines(lines: Sequence[str], file: str, asked: Sequence[str]) -> Paper:
    """`a = …` is an answer, the last one where there are several; `student:` and `variant:` say whose; all else is working."""
    told: dict[str, str] = {}
    found: dict[str, int] = {}
    working: dict[int, str] = {}
    for number, line in enumerate(lines):
        said = split(line)
        name = meant(said[0], asked) if said else None
        if said and name is None and said[0].lower() in OWN[:2] and ":" in line:
            told[said[0].lower()] = said[1]
        elif said and name is not None:
            if name in found:
                working[found[name]] = lines[found[name]].strip()
            found[name] = number
        elif line.strip() and not line.lstrip().startswith("#"):
            working[number] = line.strip()
    answers = {name: text_after(lines[found[name]]) for name in asked if name in found}
    if not answers:
        raise HandedInError([none_of(asked, "=")], lines, file)
    return Paper(told.get(STUDENT, ""), answers, tuple(working[key] for key in sorted(working)), told.get(VARIANT, ""))


def text_after(line: str) -> str:
    said = split(line)
    return said[1] if said else line.strip()


def from_yaml(text: str, file: str, asked: Sequence[str]) -> Paper:
    """`a: …`, and beside the answers `student`, `variant` and `working`, a text or a list of them."""
    root, lines = compose(text, file)
    if not isinstance(root, Map):
        raise HandedInError([Fault("answers are a map", root.span, f"write `{asked[0]}: …`")], lines, file)
    faults: list[Fault] = []
    told: dict[str, str] = {}
    working: tuple[str, ...] = ()
    for key, node in root.entries:
        name = meant(key.value, asked) or key.value
        if name not in asked and name not in OWN:
            faults.append(Fault(f"{quoted(name)} is not asked", key.span, hint(name, (*asked, *OWN), "keys")))
        elif name in told:
            faults.append(Fault(f"{quoted(name)} stands here twice", key.span, "leave one out"))
        elif name == WORKING and name not in asked:
            told[name] = ""
            working = tuple(line for item in items(node, faults) for line in item.split("\n") if line.strip())
        else:
            told[name] = single(name, node, faults).replace("\n", " ")
    answers = {name: told[name] for name in asked if told.get(name)}
    if faults or not answers:
        raise HandedInError(faults or [none_of(asked, ":")], lines, file)
    student, variant = ("" if name in asked else told.get(name, "") for name in (STUDENT, VARIANT))
    return Paper(student, answers, working, variant)


def none_of(asked: Sequence[str], sign: str) -> Fault:
    blank = " " if sign == "=" else ""
    return Fault("there is no answer", None, f"write `{asked[0]}{blank}{sign} …`; asked: {', '.join(asked)}")


def items(node: Node, faults: list[Fault]) -> list[str]:
    """The texts of a list, or the one text."""
    nodes = node.items if isinstance(node, List) else (node,)
    return [single(WORKING, item, faults) for item in nodes]


def single(name: str, node: Node, faults: list[Fault]) -> str:
    """One text; of anything else, what to write instead."""
    if isinstance(node, Text):
        return node.value.strip()
    help = 'write it in quotes, as "(3, 4) N"' if isinstance(node, List) else "write one text"
    faults.append(Fault(f"{quoted(name)} is no single text", node.span, help))
    return ""


def from_answers(texts: Sequence[str], asked: Sequence[str]) -> Paper:
    """The answers of the command line, each `a = …`, or the text alone where one thing is asked."""
    answers: dict[str, str] = {}
    faults: list[Fault] = []
    for number, text in enumerate(texts, 1):
        said = split(text)
        name = meant(said[0], asked) if said else None
        if name in answers:
            faults.append(Fault(f"{quoted(str(name))} is answered twice", Span(number, 1), "leave one out"))
        elif said and name is not None:
            answers[name] = said[1]
        elif len(asked) == 1 and len(texts) == 1:
            answers[asked[0]] = text.strip()
        else:
            faults.append(unnamed(text, said[0] if said else "", number, asked))
    given = {name: text for name, text in answers.items() if text}
    if faults or not given:
        raise HandedInError(faults or [none_of(asked, "=")], texts, "--answer")
    return Paper("", given)


def unnamed(text: str, name: str, number: int, asked: Sequence[str]) -> Fault:
    """An answer that does not say which of those that are asked it is."""
    span = Span(number, 1, max(1, len(name or text)))
    if re.fullmatch(r"\S+", name):
        return Fault(f"{quoted(name)} is not asked", span, hint(name, asked, "asked"))
    return Fault("which answer is this?", span, f"write `{asked[0]} = …`; asked: {', '.join(asked)}")
