"""By problem: what one student hands in to a whole sheet, as lines of text, as YAML or on the command line, as a paper for each problem.

Each problem's paper is read as if the lines of the others were empty, so that faults keep their places.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.handed_in import (
    MARGIN,
    MARK,
    OWN,
    YAML,
    HandedInError,
    Parts,
    file_error,
    from_answers,
    from_lines,
    from_map,
    from_yaml,
    name_and_text,
    no_answer_fault,
    read_sheet,
)
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.verdict import Paper
from rotsolve.language.words import hint, quoted
from rotsolve.scene.tree import Map, Node, Text, compose

HEAD = re.compile(r"\s*(?:(?P<word>problem|aufgabe)\s+)?(?P<name>[\w-]+)\s*(?P<sign>[:.)])?\s*", re.IGNORECASE)
WORKING = "working"


def read_papers_of_student(text: str, file: str, sheet: SheetTask) -> tuple[Paper, ...]:
    """The papers of one student to all problems; of a scene alone, the one."""
    if not sheet.is_sheet:
        task = sheet.tasks[0]
        return (read_sheet(text, file, tuple(task.letters), task.parts),)
    text = text.removeprefix(MARK)
    if not text.strip():
        raise file_error("nothing is handed in", f"write `{sheet.names()[0]} = …`", file)
    lines = text.split("\n")
    if file.lower().endswith(YAML) or all(MARGIN.match(line) for line in lines if line):
        return papers_in_map(text, file, sheet)
    return papers_in_lines(lines, file, sheet)


def read_map_of_student(text: str, file: str, sheet: SheetTask) -> tuple[Paper, ...]:
    """The same of a YAML map."""
    if sheet.is_sheet:
        return papers_in_map(text, file, sheet)
    task = sheet.tasks[0]
    return (from_yaml(text, file, tuple(task.letters), task.parts),)


def papers_in_lines(lines: Sequence[str], file: str, sheet: SheetTask) -> tuple[Paper, ...]:
    """`Problem 1:` begins a problem, and `1.a = …` names an answer of it anywhere."""
    own = [[""] * len(lines) for _ in sheet.tasks]
    faults: list[Fault] = []
    current = 0 if len(sheet.tasks) == 1 else None
    for number, line in enumerate(lines):
        head, said = HEAD.fullmatch(line), name_and_text(line)
        begun = sheet.problem(head["name"]) if head and (head["word"] or head["sign"]) else None
        if begun is not None:
            current = begun
        elif said and said[0].lower() in OWN[:2] and ":" in line:
            for text in own:
                text[number] = line
        elif line.strip() and not line.lstrip().startswith("#"):
            place, kept = place_and_line(line, current, sheet)
            if place is None:
                span = Span(number + 1, 1, max(1, len(line)))
                help = f"write `Problem {sheet.tasks[0].number}:` above it, or `{sheet.names()[0]} = …`"
                faults.append(Fault("of which problem is this?", span, help))
            else:
                own[place][number] = kept
    if faults:
        raise HandedInError(faults, lines, file)
    papers = []
    for task, text in zip(sheet.tasks, own, strict=True):
        asked = tuple(task.letters)
        answered = any(name_and_text(line) for line in text)
        papers.append(from_lines_or_none(text, file, asked, task.parts) if answered else Paper("", {}))
    return known_papers(papers, lines, file, sheet)


def place_and_line(line: str, current: int | None, sheet: SheetTask) -> tuple[int | None, str]:
    """Which problem a line is of, and the line without what says so, every letter in its place."""
    said = name_and_text(line)
    head, dot, rest = said[0].partition(".") if said else ("", "", "")
    place = sheet.problem(head) if dot else None
    if said and place is not None:
        start = line.index(head) + len(head) + 1
        if rest.strip().lower() == WORKING:
            start = len(line) - len(line.split(rest, 1)[1].lstrip(" :="))
        elif (name := sheet.tasks[place].named(rest)) is not None and name != rest.strip():
            return place, f"{name} = {said[1]}"  # by its label
        return place, " " * start + line[start:]
    if current is not None:
        return current, line
    meant = sheet.meant(said[0]) if said else None
    return (meant[0] if meant else None), line


def from_lines_or_none(lines: Sequence[str], file: str, asked: Sequence[str], parts: Parts) -> Paper:
    """The paper in some lines; without an answer it is working alone."""
    try:
        return from_lines(lines, file, asked, parts)
    except HandedInError:
        kept = [line.strip() for line in lines if line.strip()]
        told = [said for said in map(name_and_text, kept) if said and said[0].lower() in OWN[:2]]
        words = {said[0].lower(): said[1] for said in told}
        ways = tuple(line for line in kept if not ((said := name_and_text(line)) and said[0].lower() in OWN[:2]))
        return Paper(words.get(OWN[0], ""), {}, ways, words.get(OWN[1], ""))


def papers_in_map(text: str, file: str, sheet: SheetTask) -> tuple[Paper, ...]:
    """`roll: {a: …, working: […]}` or `roll.a: …`, and beside the problems `student` and `variant`."""
    root, lines = compose(text, file)
    if not isinstance(root, Map):
        raise HandedInError([Fault("answers are a map", root.span, f"write `{sheet.names()[0]}: …`")], lines, file)
    own: list[list[tuple[Text, Node]]] = [[] for _ in sheet.tasks]
    shared, faults = list[tuple[Text, Node]](), list[Fault]()
    for key, node in root.entries:
        head, _, rest = key.value.partition(".")
        place, meant = sheet.problem(head), sheet.meant(key.value)
        if key.value in OWN[:2]:
            shared.append((key, node))
        elif place is not None and not rest and isinstance(node, Map):
            own[place] += node.entries
        elif place is not None and rest.strip() == WORKING:
            own[place].append((Text(WORKING, key.span), node))
        elif meant is not None:
            own[meant[0]].append((Text(meant[1], key.span), node))
        else:
            words = (*sheet.names(), *(task.name for task in sheet.tasks), *OWN[:2])
            faults.append(Fault(f"{quoted(key.value)} is not asked", key.span, hint(key.value, words, "keys")))
    papers = []
    for task, entries in zip(sheet.tasks, own, strict=True):
        whole = Map((*shared, *entries), root.span)
        try:
            papers.append(from_map(whole, lines, file, tuple(task.letters), task.parts) if entries else Paper("", {}))
        except HandedInError as error:
            faults += error.faults
    if faults:
        raise HandedInError(faults, lines, file)
    told = {key.value: node.value for key, node in shared if isinstance(node, Text)}
    papers = [Paper(told.get(OWN[0], ""), one.answers, one.working, told.get(OWN[1], "")) for one in papers]
    return known_papers(papers, lines, file, sheet)


def known_papers(papers: Sequence[Paper], lines: Sequence[str], file: str, sheet: SheetTask) -> tuple[Paper, ...]:
    """The papers, of which one has an answer at least."""
    if not any(paper.answers for paper in papers):
        raise HandedInError([no_answer_fault(sheet.names(), "=")], lines, file)
    return tuple(papers)


def papers_of_answers(texts: Sequence[str], sheet: SheetTask, file: str = "--answer") -> tuple[Paper, ...]:
    """The answers of the command line, each `1.a = …`; of a scene alone `a = …`."""
    if not sheet.is_sheet:
        task = sheet.tasks[0]
        return (from_answers(texts, tuple(task.letters), task.parts, file),)
    own: list[list[str]] = [[] for _ in sheet.tasks]
    faults: list[Fault] = []
    for number, text in enumerate(texts, 1):
        said = name_and_text(text)
        meant = sheet.meant(said[0]) if said else None
        if said and meant:
            own[meant[0]].append(f"{meant[1]} = {said[1]}")
        else:
            word = said[0] if said else text
            help = hint(word, sheet.names(), "asked")
            faults.append(Fault("which answer is this?", Span(number, 1, max(1, len(word))), help))
    if faults:
        raise HandedInError(faults, texts, file)
    return tuple(
        from_answers(texts, tuple(task.letters), task.parts, file) if texts else Paper("", {})
        for task, texts in zip(sheet.tasks, own, strict=True)
    )
