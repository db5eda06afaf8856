"""Moodle: the questions of a quiz in Moodle XML: numerical ones with units, multiple choice, essays; and the frame that all of them have.

Moodle compares a number with each answer in their order, after it is turned into the first unit: |x − v| ≤ tolerance. Without a unit that
it knows it takes away the penalty. Marks are shares of the question's, of which it knows only some (`GRADES`).
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Mapping
from fractions import Fraction
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from rotsolve.grading.comparing.numbers import may_lack
from rotsolve.language import marks
from rotsolve.page.blocks import Phrase
from rotsolve.platforms.fragments import FragmentHtml
from rotsolve.platforms.known import Box, KnownNumbers, PlatformPart
from rotsolve.platforms.typed_units import typed_units
from rotsolve.platforms.xml_text import plain_decimal, writable, xml_bytes

PLACE = "@@PLUGINFILE@@/"  # before the name of a file of a question
GRADES = tuple(
    Fraction(*share)
    for share in (
        *((1, 1), (9, 10), (5, 6), (4, 5), (3, 4), (7, 10), (2, 3), (3, 5), (1, 2), (2, 5), (1, 3), (3, 10)),
        *((1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 10), (1, 20), (0, 1)),
    )
)
LONGEST_NAME = 250
NO_UNITS, TYPED_UNITS = "3", "0"  # how units are asked for
UNGRADED, OUT_OF_MOST = "0", "2"  # how a missing unit is marked: not at all, with a share of the question's marks
AGAIN = "0.3333333"  # what another try costs in quizzes that have them


def quiz_xml(questions: Iterable[Element]) -> bytes:
    """A file that Moodle imports."""
    quiz = Element("quiz")
    quiz.extend(questions)
    ElementTree.indent(quiz, " ")
    return xml_bytes(quiz)


def category(*path: str) -> Element:
    """What puts the questions behind it into a category of the course."""
    question = Element("question", type="category")
    text_in(SubElement(question, "category"), "/".join(("$course$/top", *map(step_of_path, path))))
    return question


def step_of_path(name: str) -> str:
    """The name of a category in a path, which Moodle divides at each `/` that stands alone, and whose blanks it takes away."""
    step = name[:LONGEST_NAME].replace("/", "//")
    return f"{' ' if step.startswith('/') else ''}{step}{' ' if step.endswith('/') else ''}"


def text_in(parent: Element, text: str) -> None:
    SubElement(parent, "text").text = writable(text)


def html_in(parent: Element, tag: str, html: str, files: Mapping[str, bytes] | None = None) -> Element:
    """A field of HTML with the files that it shows."""
    field = SubElement(parent, tag, format="html")
    text_in(field, html)
    for name, content in (files or {}).items():
        if PLACE + name in html:
            file = SubElement(field, "file", name=name, path="/", encoding="base64")
            file.text = b64encode(content).decode("ascii")
    return field


class QuestionFrame:
    """What the questions of one problem have in common: what is told, the solution, and the files of both."""

    def __init__(self, printer: FragmentHtml, told: str, solution: str) -> None:
        self.printer, self.told, self.solution = printer, told, solution

    def question(self, kind: str, name: str, asked: str, points: Fraction) -> Element:
        """A question without its answers."""
        question = Element("question", type=kind)
        text_in(SubElement(question, "name"), name[:LONGEST_NAME])
        html_in(question, "questiontext", f"{self.told}\n{asked}", self.printer.files)
        html_in(question, "generalfeedback", self.solution, self.printer.files)
        for tag, value in (
            ("defaultgrade", plain_decimal(points)),
            ("penalty", AGAIN),
            ("hidden", "0"),
            ("idnumber", ""),
        ):
            SubElement(question, tag).text = value
        return question

    def said(self, parent: Element, phrases: Iterable[Phrase]) -> None:
        """The feedback of an answer."""
        html_in(parent, "feedback", self.printer.sentence(*phrases))

    def numerical(self, name: str, asked: str, part: PlatformPart, place: int, points: Fraction) -> Element:
        """A question for one number; of a vector for the component at that place."""
        box = part.boxes[place]
        question = self.question("numerical", name, asked, points)
        seen: set[tuple[str, str]] = set()
        for known in part.numbers:
            number, margin, share = known.numbers[place], known.margins[place], known_share(part, known, place)
            if share is None or (number, margin) in seen:
                continue
            seen.add((number, margin))
            answer = SubElement(question, "answer", fraction=grade_text(share), format="moodle_auto_format")
            text_in(answer, number)
            self.said(answer, known.said)
            SubElement(answer, "tolerance").text = margin
        self.units(question, part, box)
        return question

    def units(self, question: Element, part: PlatformPart, box: Box) -> None:
        """The units that an answer may have, and what it costs to leave them out."""
        units = typed_units(box.unit, box.unit.dimension)
        if units:
            listed = SubElement(question, "units")
            for spelling, many in units:
                unit = SubElement(listed, "unit")
                SubElement(unit, "multiplier").text = f"{many:.12g}"
                SubElement(unit, "unit_name").text = spelling
        free = part.marking.unit == marks.OPTIONAL or may_lack(box.unit, box.unit.dimension) or not units
        fields = (
            ("unitgradingtype", UNGRADED if free else OUT_OF_MOST),
            ("unitpenalty", plain_decimal(part.unit_cost)),
            ("showunits", TYPED_UNITS if units else NO_UNITS),
            ("unitsleft", "0"),
        )
        for tag, value in fields:
            SubElement(question, tag).text = value

    def choice(self, name: str, asked: str, part: PlatformPart, points: Fraction) -> Element:
        """A multiple choice of which one option is right; Moodle shuffles them, unless they have labels."""
        question = self.question("multichoice", name, asked, points)
        shuffled = "false" if part.in_words else "true"
        numbering = "none" if part.in_words else "abc"
        for tag, value in (("single", "true"), ("shuffleanswers", shuffled), ("answernumbering", numbering)):
            SubElement(question, tag).text = value
        for tag in ("correctfeedback", "partiallycorrectfeedback", "incorrectfeedback"):
            html_in(question, tag, "")
        for place in part.order:
            option = part.options[place]
            share = option.share if place else Fraction(1)
            answer = SubElement(question, "answer", fraction=grade_text(share), format="html")
            text_in(answer, self.printer.sentence(option.shown))
            self.said(answer, option.said)
        return question

    def essay(self, name: str, asked: str, answer: str, points: Fraction) -> Element:
        """A question that a teacher marks: for an answer that Moodle can not compare."""
        question = self.question("essay", name, asked, points)
        fields = (
            ("responseformat", "editor"),
            ("responserequired", "1"),
            ("responsefieldlines", "5"),
            ("attachments", "0"),
        )
        for tag, value in fields:
            SubElement(question, tag).text = value
        html_in(question, "graderinfo", answer)
        html_in(question, "responsetemplate", "")
        return question


def known_share(part: PlatformPart, known: KnownNumbers, place: int) -> Fraction | None:
    """What a number is worth in a box by itself; None of one that is right there though the others are wrong."""
    right = part.numbers[0]
    if known is right:
        return Fraction(1)
    if len(part.boxes) > 1:
        off = abs(Fraction(known.numbers[place]) - Fraction(right.numbers[place]))
        return None if off <= Fraction(right.margins[place]) else known.share
    return known.share


def grade_text(share: Fraction) -> str:
    """The share in percent, the nearest of those that Moodle knows."""
    nearest = min(GRADES, key=lambda grade: abs(grade - share))
    return plain_decimal(nearest * 100, places=5)
