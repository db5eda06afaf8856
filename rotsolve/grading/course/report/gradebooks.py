"""Gradebooks: the marks as tables that Moodle and Canvas import. A student whose marks are not all given yet is in neither of them.

Moodle's importer (grade/import/csv) finds a user by one column, the number, the address or the name for the login. It gives the marks of
a row whose cell is empty to the user of the row before, and an unknown user ends the whole import: so a row without that mark is left out.
Canvas (lib/gradebook_importer.rb) wants its five columns in this order and the row of points. It takes `ID` for a number of its own, so a
student's number belongs under `SIS User ID`; a name that ends with a number in brackets is taken for that of an assignment there.
"""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from io import StringIO

from rotsolve.grading.course.report.results import MarkedClass, Result
from rotsolve.grading.course.report.student import marks_text
from rotsolve.grading.course.students import IDENTITIES
from rotsolve.grading.verdict import OPEN_OUTCOMES
from rotsolve.run.delivery import harmless

MOODLE, CANVAS = "gradebook-moodle.csv", "gradebook-canvas.csv"
MOODLE_HEADS = {"email": "Email address", "number": "ID number", "login": "Username"}  # the likeliest first
CANVAS_HEADS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
CANVAS_KNOWS = ("canvas", "number", "login", "name")  # students by, the surest first
POINTS = "    Points Possible"
AN_ASSIGNMENT = re.compile(r"(?P<title>.*?)\s*\((?P<number>\d+)\)")  # as Canvas exports one


def with_all_marks(course: MarkedClass) -> list[Result]:
    """The students whose marks are all given."""
    return [result for result in course.results if not result.sheet.outcomes() & {*OPEN_OUTCOMES}]


def told_of_several(results: Sequence[Result], kind: str) -> frozenset[str]:
    """What several students have, so that it tells none of them: a number that was typed wrong, a name."""
    count = Counter(identity_of(result, kind) for result in results)
    return frozenset(value for value, times in count.items() if times > 1)


def identity_of(result: Result, kind: str) -> str:
    """What a student is found by, as it is compared."""
    return result.student.identity(kind)


def identity_for_moodle(course: MarkedClass) -> str:
    """The column by which most students can be found."""
    assert MOODLE_HEADS.keys() == {*IDENTITIES}
    return max(MOODLE_HEADS, key=lambda kind: sum(bool(getattr(one.student, kind)) for one in with_all_marks(course)))


def known_to_moodle(course: MarkedClass) -> list[Result]:
    """The students that Moodle can find, whose marks are all given."""
    kind = identity_for_moodle(course)
    unsure = {"", *told_of_several(course.results, kind)}
    return [one for one in with_all_marks(course) if identity_of(one, kind) not in unsure]


def known_to_canvas(course: MarkedClass) -> list[Result]:
    """The students that Canvas can find, by the surest mark that they have, whose marks are all given."""
    unsure = {kind: {"", *told_of_several(course.results, kind)} for kind in CANVAS_KNOWS}
    found = []
    for one in with_all_marks(course):
        surest = next((kind for kind in CANVAS_KNOWS if getattr(one.student, kind)), "name")
        if identity_of(one, surest) not in unsure[surest]:
            found.append(one)
    return found


def moodle_table(course: MarkedClass) -> str:
    """A row a student: what Moodle knows them by, the name for a reader, the total, and on a sheet the marks of each problem."""
    kind = identity_for_moodle(course)
    tasks = course.task.tasks if len(course.task.tasks) > 1 else ()
    problems = [f"{course.task.title}: {task.number}. {task.title}" for task in tasks]
    rows = [[MOODLE_HEADS[kind], "Name", course.task.title, *problems]]
    for result in known_to_moodle(course):
        marks = [one.marks for one in result.sheet.problems] if tasks else []
        known = getattr(result.student, kind)
        rows.append([known, result.student.name, *map(marks_text, (result.sheet.marks, *marks))])
    return as_csv(rows)


def canvas_table(course: MarkedClass) -> str:
    """A row a student below that of the points. The total alone: an assignment for each problem would count it twice."""
    rows = [[*CANVAS_HEADS, canvas_heading(course)], [POINTS, "", "", "", "", marks_text(course.of)]]
    for result in known_to_canvas(course):
        one = result.student
        rows.append([one.name, one.canvas, one.number, one.login, one.section, marks_text(result.sheet.marks)])
    return as_csv(rows)


def canvas_heading(course: MarkedClass) -> str:
    """The assignment: as a column of the class has it, `Homework 4 (1234)`, else the title, in which no number is taken for one."""
    title = course.task.title.strip()
    for heading in course.columns.unused:
        found = AN_ASSIGNMENT.fullmatch(heading)
        if found and found["title"].casefold() == title.casefold():
            return heading
    found = AN_ASSIGNMENT.fullmatch(title)
    return f"{found['title']} [{found['number']}]" if found else title


def as_csv(rows: Iterable[Sequence[str]]) -> str:
    """Rows with commas between their cells; nothing in them that a spreadsheet would work out."""
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows([[harmless(cell) for cell in row] for row in rows])
    return text.getvalue()
