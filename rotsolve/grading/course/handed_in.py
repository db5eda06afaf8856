"""Handed in: what one student hands in, as lines of text or as YAML; its bytes as text, and the asked names in any of their spellings."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

from rotsolve.algebra.notation.letters import RUN, name_to_text, spellings
from rotsolve.core.faults import Fault, SceneError, Span
from rotsolve.grading.reading.records import spelled_alike
from rotsolve.grading.verdict import Paper
from rotsolve.language.words import hint, quoted
from rotsolve.run.attempt import PIPED
from rotsolve.scene.encoding import decoded
from rotsolve.scene.tree import List, Map, Node, Text, compose

BYTES = 50_000_000  # a class of a hundred thousand, with its working
MARK = "\ufeff"  # at the start of a file that a spreadsheet has saved as UTF-8
SAVE = "save it as UTF-8; spreadsheets call it `CSV UTF-8`"
LATEX = str.maketrans("", "", "\\{}$ ")  # $\omega_{0}$ is omega_0
LINE = re.compile(r"\s*(?P<name>[^=:≈]{1,60}?)\s*[=:≈](?![=:≈])\s*(?P<text>.*)", re.DOTALL)
# $a = 2 m$ as a whole
MATHEMATICS = re.compile(r"\s*(?:\${1,2}([^$]*)\${1,2}|\\\((.*)\\\)|\\\[(.*)\\\])\s*", re.DOTALL)
YAML = (".yaml", ".yml")
STUDENT_KEY, VARIANT_KEY, WORKING_KEY = "student", "variant", "working"
OWN = (STUDENT_KEY, VARIANT_KEY, WORKING_KEY)  # keys beside the names of the answers
MARGIN = re.compile(r"\s|#|-\s|[\w\\$]+:(\s|$)")  # how each line of a YAML map begins
LINES, LONGEST = 10_000, 200_000
Parts = Mapping[str, str]  # L_x of L: the names of components, each with that of the vector or tensor
NO_PARTS: Parts = MappingProxyType({})


class HandedInError(SceneError):
    """Answers that can't be read: every fault of the file, with its place."""


def content_of(file: str) -> str:
    """The text of a file, or of standard input for `-`, with plain line breaks; a byte order mark stays in front."""
    try:
        content = sys.stdin.buffer.read(BYTES + 1) if file == PIPED else bytes_of(Path(file))
    except OSError as error:
        raise file_error(f"can't read {quoted(file)}: {error.strerror or error}") from None
    if len(content) > BYTES:
        raise file_error(f"the file has more than {BYTES} bytes", "split the class", file)
    try:
        return decoded(content, file, SAVE).replace("\r\n", "\n").replace("\r", "\n")
    except SceneError as error:
        raise HandedInError(error.faults, error.lines, file) from None


def bytes_of(path: Path) -> bytes:
    with path.open("rb") as stream:
        return stream.read(BYTES + 1)


def file_error(message: str, help: str = "", file: str = "", span: Span | None = None) -> HandedInError:
    """The error of a file with a single fault."""
    return HandedInError([Fault(message, span, help, "file")], (), file)


# names


def meant_answer(name: str, asked: Iterable[str]) -> str | None:
    """The asked name that is meant, None where it is none of them."""
    names = tuple(asked)
    if name.strip() in names:
        return name.strip()
    plain = name.strip().translate(LATEX).strip("|")  # |L| where the size is asked
    if not re.fullmatch(RUN, plain):
        return None
    said = {plain, *spellings(plain)}
    printed = {name_to_text(text) for text in said}
    exactly = next((item for item in names if item in said or name_to_text(item) in printed), None)
    found = [item for item in names if spelled_alike(plain, item)]
    return exactly or (found[0] if len(found) == 1 else None)


def name_and_text(line: str) -> tuple[str, str] | None:
    """`a = 2 m`, `a: 2 m` or `a ≈ 2 m` as name and text; None where the line is not of that form."""
    whole = MATHEMATICS.fullmatch(line)
    match = LINE.fullmatch(next(filter(None, whole.groups()), "") if whole else line)
    return (match["name"], match["text"].rstrip()) if match else None


def as_whole_vectors(answers: Mapping[str, str], asked: Sequence[str], parts: Parts) -> dict[str, str]:
    """The answers in the order in which they are asked, those that are told by components as one: `L_x = …; L_y = …`."""
    told: dict[str, list[str]] = {}
    for name, text in answers.items():
        if name not in asked:
            told.setdefault(parts[name], []).append(f"{name} = {text}")
    whole = {name: "; ".join(lines) for name, lines in told.items()} | {
        name: answers[name] for name in answers if name in asked
    }
    return {name: whole[name] for name in asked if name in whole}


# papers


def read_sheet(text: str, file: str, asked: Sequence[str], parts: Parts = NO_PARTS) -> Paper:
    """The paper of one student. The file's name says whether it is YAML; of what has no such name, its lines do.

    `parts` are the names of the components of vectors that are asked, each with that of the whole.
    """
    text = text.removeprefix(MARK)
    lines = text.split("\n")
    if not text.strip():
        raise file_error("nothing is handed in", f"write `{asked[0]} = …`", file)
    if len(lines) > LINES or len(text) > LONGEST:
        message = f"more than {LINES} lines or {LONGEST} characters"
        raise HandedInError([Fault(message, None, "hand in one student's answers; a class is a .csv")], (), file)
    named_so = file.lower().endswith(YAML)
    if named_so or all(MARGIN.match(line) for line in lines if line):
        return from_yaml(text, file, asked, parts)
    return from_lines(lines, file, asked, parts)


def from_lines(lines: Sequence[str], file: str, asked: Sequence[str], parts: Parts) -> Paper:
    """`a = …` is an answer, the last one where there are several; `student:` and `variant:` say whose; all else is working."""
    told: dict[str, str] = {}
    found: dict[str, tuple[int, str]] = {}
    working: dict[int, str] = {}
    for number, line in enumerate(lines):
        said = name_and_text(line)
        name = meant_answer(said[0], (*asked, *parts)) if said else None
        if said and name is None and said[0].lower() in OWN[:2] and ":" in line:
            told[said[0].lower()] = said[1]
        elif said and name is not None:
            if name in found:
                earlier, _ = found[name]
                working[earlier] = lines[earlier].strip()
            found[name] = number, said[1]
        elif line.strip() and not line.lstrip().startswith("#"):
            working[number] = line.strip()
    answers = as_whole_vectors({name: text for name, (_, text) in found.items()}, asked, parts)
    if not answers:
        raise HandedInError([no_answer_fault(asked, "=")], lines, file)
    ways = tuple(working[number] for number in sorted(working))
    return Paper(told.get(STUDENT_KEY, ""), answers, ways, told.get(VARIANT_KEY, ""))


def from_yaml(text: str, file: str, asked: Sequence[str], parts: Parts) -> Paper:
    """`a: …`, and beside the answers `student`, `variant` and `working`, a text or a list of them."""
    root, lines = compose(text, file)
    return from_map(root, lines, file, asked, parts)


def from_map(root: Node, lines: Sequence[str], file: str, asked: Sequence[str], parts: Parts) -> Paper:
    """The same of a map that has been read."""
    if not isinstance(root, Map):
        raise HandedInError([Fault("answers are a map", root.span, f"write `{asked[0]}: …`")], lines, file)
    faults: list[Fault] = []
    told: dict[str, str] = {}
    working: tuple[str, ...] = ()
    for key, node in root.entries:
        name = meant_answer(key.value, (*asked, *parts)) or key.value
        if name not in asked and name not in OWN and name not in parts:
            faults.append(Fault(f"{quoted(name)} is not asked", key.span, hint(name, (*asked, *OWN), "keys")))
        elif name in told:
            faults.append(Fault(f"{quoted(name)} stands here twice", key.span, "leave one out"))
        elif name == WORKING_KEY and name not in asked:
            told[name] = ""
            items = [single_text(name, item, faults) for item in (node.items if isinstance(node, List) else (node,))]
            working = tuple(line for item in items for line in item.split("\n") if line.strip())
        else:
            told[name] = single_text(name, node, faults).replace("\n", " ")
    given = {name: text for name, text in told.items() if text and (name in asked or name in parts)}
    answers = as_whole_vectors(given, asked, parts)
    if faults or not answers:
        raise HandedInError(faults or [no_answer_fault(asked, ":")], lines, file)
    student, variant = ("" if name in asked else told.get(name, "") for name in (STUDENT_KEY, VARIANT_KEY))
    return Paper(student, answers, working, variant)


def no_answer_fault(asked: Sequence[str], sign: str) -> Fault:
    blank = " " if sign == "=" else ""
    return Fault("there is no answer", None, f"write `{asked[0]}{blank}{sign} …`; asked: {', '.join(asked)}")


def single_text(name: str, node: Node, faults: list[Fault]) -> str:
    """One text; of anything else, what to write instead."""
    if isinstance(node, Text):
        return node.value.strip()
    help = 'write it in quotes, as "(3, 4) N"' if isinstance(node, List) else "write one text"
    faults.append(Fault(f"{quoted(name)} is no single text", node.span, help))
    return ""


def from_answers(texts: Sequence[str], asked: Sequence[str], parts: Parts = NO_PARTS, file: str = "--answer") -> Paper:
    """The answers of the command line, each `a = …`, or the text alone where one thing is asked."""
    answers: dict[str, str] = {}
    faults: list[Fault] = []
    for number, text in enumerate(texts, 1):
        said = name_and_text(text)
        name = meant_answer(said[0], (*asked, *parts)) if said else None
        if name in answers:
            faults.append(Fault(f"{quoted(str(name))} is answered twice", Span(number, 1), "leave one out"))
        elif said and name is not None:
            answers[name] = said[1]
        elif len(asked) == 1 and len(texts) == 1:
            answers[asked[0]] = text.strip()
        else:
            faults.append(unnamed_fault(text, said[0] if said else "", number, asked))
    given = as_whole_vectors({name: text for name, text in answers.items() if text}, asked, parts)
    if faults or not given:
        raise HandedInError(faults or [no_answer_fault(asked, "=")], texts, file)
    return Paper("", given)


def unnamed_fault(text: str, name: str, number: int, asked: Sequence[str]) -> Fault:
    """An answer that does not say which of those that are asked it is."""
    span = Span(number, 1, max(1, len(name or text)))
    if re.fullmatch(r"\S+", name):
        return Fault(f"{quoted(name)} is not asked", span, hint(name, asked, "asked"))
    return Fault("which answer is this?", span, f"write `{asked[0]} = …`; asked: {', '.join(asked)}")
