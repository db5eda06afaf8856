"""Papers: what a class has handed in so far, in `papers.csv` of the report. Another file adds to it; the last paper of a student counts.

A file that is handed in again is taken as corrected: its rows take the place of those that it had for the same students. What only an
earlier run has stays.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Mapping, Sequence
from io import StringIO
from itertools import groupby
from pathlib import Path

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.columns import SEPARATORS
from rotsolve.grading.course.handed_in import MARK, HandedInError, content_of, file_error
from rotsolve.grading.course.questions import Asked, SheetTask
from rotsolve.grading.course.students import IDENTITIES, Student
from rotsolve.grading.course.table import Entry, plain_cell
from rotsolve.grading.verdict import Paper
from rotsolve.language.words import hint, quoted
from rotsolve.run.delivery import harmless

PAPERS = "papers.csv"
WHOSE = ("name", "number", "email", "login", "section", "canvas")  # columns, and fields of a student
FILE, LINE, VARIANT, UNREAD, REMARKS, WORKING = "file", "line", "variant", "not marked", "remarks", "working"
HELD = "columns"  # the answers that the file had columns of
BETWEEN = "; "  # two lines of working


class KnownStudent(Struct):
    """A student with all rows that are theirs, in the order in which they were handed in."""

    student: Student
    rows: list[Entry]
    remarks: list[str] = field(default_factory=list)

    @property
    def counting(self) -> Entry:
        """What counts: the last answers that can be read, with the last variant that was told before; and what is to be said of others."""
        variant, said = "", list[str]()
        papers: tuple[Paper, ...] | None = None
        read = [row for row in self.rows if row.papers is not None]
        last = (read or self.rows)[-1]
        for place, row in enumerate(self.rows):
            variant = row.variant or variant
            if row.papers is None:
                if papers is not None:
                    said.append(f"a later paper, in {named_row(row, last)}, can't be read: {BETWEEN.join(row.remarks)}")
                continue
            own = tuple(replace(paper, variant=paper.variant or variant) for paper in row.papers)
            papers = own if papers is None else tuple(map(followed_by, papers, own))
            if any(replaces(later, row) for later in self.rows[place + 1 :]):
                said.append(f"handed in before, in {named_row(row, last)}: the later answers count")
            if any(leaves_empty(later, row) for later in self.rows[place + 1 :]):
                said.append(f"what the later paper leaves empty stands as in {named_row(row, last)}")
        remarks = (*last.remarks, *said, *self.remarks)
        return replace(last, student=self.student, papers=papers, remarks=remarks, variant=last.variant or variant)


def followed_by(paper: Paper, later: Paper) -> Paper:
    """A paper with what a later one says; of an answer that the later one does not have, the earlier one stands."""
    if not later.answers and not later.working:
        return paper
    said = {name: text for name, text in later.answers.items() if text or not paper.answers.get(name)}
    return replace(later, answers={**paper.answers, **said}, working=later.working or paper.working)


def replaces(later: Entry, entry: Entry) -> bool:
    """Whether a later row says something else of an answer."""
    return any(one and other and one != other for one, other in shared_answers(later, entry))


def leaves_empty(later: Entry, entry: Entry) -> bool:
    """Whether a later row has an answer's column, and nothing in it."""
    return any(one and not other for one, other in shared_answers(later, entry))


def shared_answers(later: Entry, entry: Entry) -> Iterator[tuple[str, str]]:
    """What a row and a later one have in the columns of the same answers."""
    for one, other in zip(entry.papers or (), later.papers or (), strict=False):
        yield from ((one.answers[name], other.answers[name]) for name in one.answers.keys() & other.answers.keys())


def named_row(entry: Entry, beside: Entry) -> str:
    """Which row it is, with its file where that is another."""
    return entry.place if entry.file == beside.file else f"{entry.place} of {entry.file}"


class KnownStudents:
    """The students of a class, by their rows."""

    def __init__(self, rows: Iterable[Entry]) -> None:
        self.all: list[KnownStudent] = []
        self.by_identity: dict[tuple[str, str], KnownStudent] = {}
        self.by_words: dict[frozenset[str], list[KnownStudent]] = {}
        for _, own in groupby(rows, key=lambda entry: entry.file):
            self.add_file(list(own))

    def add_file(self, rows: Sequence[Entry]) -> None:
        """The rows of one file. Two of them are of one student only by a number or address; by a name alone those of other files are."""
        alike: dict[frozenset[str], list[Entry]] = {}
        before = {words: list(found) for words, found in self.by_words.items()}
        for entry in rows:
            known = self.identified(entry.student)
            if known is not None and known.student.named_alike(entry.student):
                self.give(known, entry)
            elif known is not None:
                said = f"{self.shared(known.student, entry.student)} stands with two names: {{}}"
                known.remarks.append(said.format(f"{entry.student.called}, in {named_row(entry, known.rows[0])}"))
                own = said.format(f"{known.student.called}, in {named_row(known.rows[0], entry)}")
                self.all.append(KnownStudent(entry.student, [entry], [own]))
            elif self.namesakes(entry.student, before):
                alike.setdefault(entry.student.words, []).append(entry)
            else:
                self.give(KnownStudent(entry.student, []), entry)
        for same in alike.values():
            self.give_by_name(same, self.namesakes(same[0].student, before))

    def give_by_name(self, rows: Sequence[Entry], holders: Sequence[KnownStudent]) -> None:
        """Rows of a name to its holders, where it is clear which is whose."""
        if len(rows) == len(holders):
            for holder, entry in zip(holders, rows, strict=True):
                self.give(holder, entry)
            return
        where = ", ".join(named_row(holder.rows[-1], rows[0]) for holder in holders)
        why = f"whose paper is this? The name stands in {where} too: add the student's number"
        for entry in rows:
            self.all.append(KnownStudent(entry.student, [replace(entry, papers=None, remarks=(*entry.remarks, why))]))

    def identified(self, student: Student) -> KnownStudent | None:
        """The holder with the surest mark that both have."""
        for kind in IDENTITIES:
            holder = self.by_identity.get((kind, student.identity(kind)))
            if holder is not None and holder.student.same_identity(student):
                return holder
        return None

    def shared(self, one: Student, other: Student) -> str:
        """What two students both have."""
        kind = next(kind for kind in IDENTITIES if getattr(one, kind) and getattr(other, kind))
        return f"the {kind} {getattr(other, kind)}"

    def namesakes(self, student: Student, among: Mapping[frozenset[str], list[KnownStudent]]) -> list[KnownStudent]:
        """Those of the same name who share no number or address that would tell."""
        found = among.get(student.words, []) if student.words else []
        return [holder for holder in found if holder.student.same_identity(student) is None]

    def give(self, holder: KnownStudent, entry: Entry) -> None:
        """One more row of a student, new or known."""
        if not holder.rows:
            self.all.append(holder)
            self.by_words.setdefault(holder.student.words, []).append(holder)
        written = holder.student.number
        holder.student = entry.student.completed(holder.student)
        if written and holder.student.number != written:
            said = f"the number {holder.student.number} is {written} in {named_row(holder.rows[-1], entry)}"
            holder.remarks.append(f"{said}: taken as the same")
        holder.rows.append(entry)
        for kind in IDENTITIES:
            if getattr(holder.student, kind):
                self.by_identity.setdefault((kind, holder.student.identity(kind)), holder)


def with_file(earlier: Sequence[Entry], fresh: Sequence[Entry]) -> list[Entry]:
    """All rows, those of the file that is handed in now in the place of those that it had for the same students."""
    file = fresh[0].file
    if all(entry.file != file for entry in earlier):
        return [*earlier, *fresh]
    holders = KnownStudents(fresh)
    names = {entry.student.words for entry in fresh}
    left = [
        entry
        for entry in earlier
        if entry.file == file and holders.identified(entry.student) is None and entry.student.words not in names
    ]
    first = next(place for place, entry in enumerate(earlier) if entry.file == file)
    others = [entry for entry in earlier[first:] if entry.file != file]
    return [*earlier[:first], *fresh, *left, *others]


# the table


def columns_of_papers(sheet: SheetTask) -> dict[str, Asked | int]:
    """The columns of answers, and of working, by their headings in words that stay when problems change their places."""
    answers = {sheet.key(asked, short=True): asked for asked in sheet.asked()}
    workings = {sheet.key((place, WORKING), short=True): place for place in range(len(sheet.tasks))}
    return {**answers, **workings}


def papers_table(rows: Sequence[Entry], sheet: SheetTask, separator: str, mark: str) -> str:
    """All rows as a table, which `read_papers` reads."""
    columns = columns_of_papers(sheet)
    text = StringIO()
    writer = csv.writer(text, delimiter=separator, lineterminator="\n")
    writer.writerow([FILE, LINE, *WHOSE, VARIANT, HELD, *columns, UNREAD, REMARKS])
    for entry in rows:
        whose = [getattr(entry.student, kind) for kind in WHOSE]
        said = [cell_of(entry.papers, what) for what in columns.values()]
        unread = "" if entry.papers is not None else "yes"
        held = " ".join(key for key, what in columns.items() if is_held(entry.papers, what))
        row = [entry.file, str(entry.line), *whose, entry.variant, held, *said, unread, BETWEEN.join(entry.remarks)]
        writer.writerow([harmless(cell) for cell in row])
    return mark + text.getvalue()


def is_held(papers: Sequence[Paper] | None, what: Asked | int) -> bool:
    """Whether the table of a row had a column of an answer."""
    return papers is not None and not isinstance(what, int) and what[1] in papers[what[0]].answers


def cell_of(papers: Sequence[Paper] | None, what: Asked | int) -> str:
    """An answer, or the working of a problem."""
    if papers is None:
        return ""
    if isinstance(what, int):
        return BETWEEN.join(papers[what].working)
    return papers[what[0]].answers.get(what[1], "")


def read_papers(folder: Path, sheet: SheetTask) -> tuple[list[Entry], str]:
    """What was handed in before, and what separates its cells; nothing where there is no such table. Raises HandedInError for one of
    another sheet."""
    path = folder / PAPERS
    if not path.is_file():
        return [], ""
    text = content_of(str(path)).removeprefix(MARK)
    lines = text.split("\n")
    wanted = columns_of_papers(sheet)
    known = {FILE, LINE, *WHOSE, VARIANT, HELD, *wanted, UNREAD, REMARKS}
    heads = (next(csv.reader(lines[:1], delimiter=sign), []) for sign in SEPARATORS)
    separator, head = max(zip(SEPARATORS, heads, strict=True), key=lambda item: len(known.intersection(item[1])))
    strange = next((cell for cell in head if cell not in known), None)
    if strange is not None or not {FILE, LINE, "name"} <= {*head}:
        help = f"{hint(strange or '', tuple(wanted), 'asked')}; for another sheet, take another folder, or --anew"
        message = (
            f"these papers have a column {quoted(strange)}, which is not asked"
            if strange
            else "this table has lost columns"
        )
        span = Span(1, max(1, lines[0].find(strange or "") + 1), max(1, len(strange or "")))
        raise HandedInError([Fault(message, span, help)], lines, str(path))
    try:
        reader = csv.reader(StringIO(text, newline=""), delimiter=separator, strict=True)
        return list(entries_kept(reader, wanted, sheet, str(path))), separator
    except csv.Error as error:
        raise file_error(
            f"the table can't be read: {error}", "restore it, or begin again with --anew", str(path)
        ) from None


def entries_kept(
    reader: Iterator[list[str]], wanted: Mapping[str, Asked | int], sheet: SheetTask, path: str
) -> Iterator[Entry]:
    """The rows below the headings."""
    head = next(reader)
    for cells in reader:
        if not any(cells):
            continue
        row = {name: plain_cell(cells, place) for place, name in enumerate(head)}
        if not row[LINE].isdecimal() or not row[FILE]:
            message, help = (
                f"a row has no file or no line: {', '.join(cells)[:60]}",
                "restore it, or begin again with --anew",
            )
            raise file_error(message, help, path)
        student = Student(**{kind: row.get(kind, "") for kind in WHOSE})
        variant, remarks = row.get(VARIANT, ""), row.get(REMARKS, "")
        papers = None if row.get(UNREAD) else tuple(kept_papers(row, wanted, sheet, student, variant))
        yield Entry(int(row[LINE]), student, papers, (remarks,) if remarks else (), variant, row[FILE])


def kept_papers(
    row: Mapping[str, str], wanted: Mapping[str, Asked | int], sheet: SheetTask, student: Student, variant: str
) -> Iterator[Paper]:
    """The papers of a row, one for each problem."""
    held = row.get(HELD, "").split()
    for place in range(len(sheet.tasks)):
        answers = {
            what[1]: row.get(key, "")
            for key, what in wanted.items()
            if not isinstance(what, int) and what[0] == place and (row.get(key) or key in held)
        }
        working = row.get(sheet.key((place, WORKING), short=True), "")
        lines = tuple(part.strip() for part in working.split(";") if part.strip())
        yield Paper(student.called, answers, lines, variant)
