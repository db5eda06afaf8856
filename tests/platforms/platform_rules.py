"""What a platform does with a file, written anew from what is published of it: the readers and the rules that the tests hold files against.

Nothing of rotsolve is used here. Moodle: question/format.php, format/xml, type/numerical, type/multichoice, type/multianswer of
its source. QTI: the information models.
"""

from __future__ import annotations

import math
import re
import zipfile
from base64 import b64decode
from dataclasses import dataclass, field
from html import unescape
from io import BytesIO
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

MOODLE_GRADES = {
    *(
        "100",
        "90",
        "83.33333",
        "80",
        "75",
        "70",
        "66.66667",
        "60",
        "50",
        "40",
        "33.33333",
        "30",
        "25",
        "20",
        "16.66667",
    ),
    *("14.28571", "12.5", "11.11111", "10", "5", "0"),
}
NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?")


@dataclass
class MoodleQuestion:
    """A question as Moodle holds it after the import."""

    kind: str
    name: str
    category: str
    text: str
    feedback: str
    grade: float
    answers: list[tuple[str, float, float, str]]  # number or text, tolerance, fraction, feedback
    units: dict[str, float] = field(default_factory=dict)
    grading: str = "0"
    penalty: float = 0.0
    files: dict[str, bytes] = field(default_factory=dict)

    def grade_of(self, response: str) -> tuple[float, str]:
        """The fraction of the marks for what is typed, and the feedback."""
        value, multiplier = self.parsed(response)
        if value is None:
            return 0.0, ""
        for number, tolerance, fraction, feedback in self.answers:
            low, high = float(number) - tolerance, float(number) + tolerance
            room = 1e-14 * max(1.0, abs(float(number)))
            scaled = value if multiplier is None else value * multiplier
            for tried, good in ((scaled, multiplier is not None), (value, False)):
                if low - room <= tried <= high + room:
                    lost = 0.0 if good or self.grading == "0" else self.penalty
                    return max(0.0, fraction - lost), feedback
        return 0.0, ""

    def parsed(self, response: str) -> tuple[float | None, float | None]:
        plain = response.replace(" ", "")
        plain = re.sub(r"(?:e|E|(?:x|\*|×)10(?:\^|\*\*))([+-]?\d+)", r"e\1", plain)
        plain = plain.replace(",", "") if "." in plain or plain.count(",") > 1 else plain.replace(",", ".")
        found = NUMBER.match(plain)
        if found is None:
            return None, None
        unit = plain[found.end() :]
        return float(found[0]), 1 / self.units[unit] if unit in self.units else None


def read_moodle(content: bytes) -> list[MoodleQuestion]:
    """The questions of a file; a fault of it is an AssertionError."""
    quiz = ElementTree.fromstring(content)
    assert quiz.tag == "quiz"
    category, found = "", []
    for question in quiz:
        assert question.tag == "question"
        kind = question.attrib["type"]
        if kind == "category":
            category = "/".join(steps_of_path(said(question, "category/text")))
            assert category.startswith("$course$/top/")
            continue
        found.append(read_question(question, kind, category))
    return found


def steps_of_path(path: str) -> list[str]:
    """The names of categories: a path is divided at each `/` that stands alone; what is longer than the database holds stops the import."""
    names = [step.replace("//", "/").strip() for step in re.split("(?<!/)/(?!/)", path)]
    assert all(0 < len(name) <= 255 for name in names), names
    return names


def read_question(question: Element, kind: str, category: str) -> MoodleQuestion:
    name, text = said(question, "name/text"), said(question, "questiontext/text")
    assert name and len(name) <= 255 and text
    html_of(text), html_of(said(question, "generalfeedback/text"))
    files = {}
    for one in question.iter("file"):
        assert one.attrib["encoding"] == "base64" and one.attrib["path"] == "/"
        files[one.attrib["name"]] = b64decode(one.text or "", validate=True)
    for place in re.findall(r'@@PLUGINFILE@@/([^"]+)"', text):
        assert place in files, place
    answers = []
    for answer in question.findall("answer"):
        assert answer.attrib["fraction"] in MOODLE_GRADES, answer.attrib
        fraction = float(answer.attrib["fraction"]) / 100
        told = (said(answer, "text"), float(answer.findtext("tolerance") or 0), fraction, said(answer, "feedback/text"))
        answers.append(told)
    if kind in ("numerical", "multichoice"):
        assert len(answers) > (kind == "multichoice") and max(one[2] for one in answers) == 1.0
    if kind == "multichoice":
        assert question.findtext("single") == "true" and question.findtext("answernumbering") in ("abc", "none")
    units = {
        unit.findtext("unit_name") or "": float(unit.findtext("multiplier") or 0) for unit in question.iter("unit")
    }
    assert all(units.values()) and not any(" " in name or len(name) > 50 for name in units)
    assert len({name.casefold() for name in units}) == len(units)  # MySQL tells no capitals apart, and wants each once
    penalty, grading = float(question.findtext("unitpenalty") or 0), question.findtext("unitgradingtype") or "0"
    assert 0 <= penalty <= 1 and grading in "012"
    grade = float(question.findtext("defaultgrade") or 0)
    return MoodleQuestion(
        kind,
        name,
        category,
        text,
        said(question, "generalfeedback/text"),
        grade,
        answers,
        units,
        grading,
        penalty,
        files,
    )


def said(element: Element, path: str) -> str:
    found = element.find(path)
    return "" if found is None else found.text or ""


def html_of(html: str) -> Element:
    """HTML that is well formed, as all of ours is."""
    return ElementTree.fromstring(f"<div>{html}</div>")


def plain(html: str) -> str:
    return "".join(html_of(html).itertext())


CLOZE = re.compile(r"\{(\d*):(NUMERICAL|MULTICHOICE_VS?):((?:\\.|[^\\}])*)\}", re.DOTALL)
ALTERNATIVE = re.compile(r"(?:(=)|%(-?\d+)%)?(.+?)(?<!\\)(?<!&)(?<!&amp;)(?:#(.*))?$", re.DOTALL)
IN_BOX = re.compile(r"-?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?")  # numbers as a box has them


def read_cloze(text: str) -> list[tuple[int, str, list[tuple[str, float, float, str]]]]:
    """The boxes of a Cloze: weight, kind, and their answers."""
    found = []
    for weight, kind, body in CLOZE.findall(text):
        answers = []
        for one in re.split(r"(?<!\\)~", body):
            right, percent, answer, feedback = ALTERNATIVE.fullmatch(one).groups()  # type: ignore[union-attr]
            fraction = 1.0 if right else float(percent or 0) / 100
            number, _, tolerance = answer.partition(":") if kind == "NUMERICAL" else (answer, "", "0")
            assert kind != "NUMERICAL" or (IN_BOX.fullmatch(number) and IN_BOX.fullmatch(tolerance))
            answers.append((in_box(number), float(tolerance or 0), fraction, in_box(feedback or "")))
        assert len(answers) > (kind != "NUMERICAL") and max(one[2] for one in answers) == 1.0
        found.append((int(weight or 1), kind, answers))
    return found


def in_box(text: str) -> str:
    """HTML of a box: Moodle undoes entities once, then the signs that are marked; what is left has to be well formed."""
    found = unescape(text).replace(r"\}", "}").replace(r"\#", "#")
    html_of(found)
    return found


# QTI


def local(element: Element) -> str:
    return element.tag.rpartition("}")[2]


def of_21(name: str) -> str:
    """The name of 2.1 for one of 3.0: responseIdentifier for response-identifier, itemBody for qti-item-body."""
    head, *rest = name.removeprefix("qti-").split("-")
    return head + "".join(part.capitalize() for part in rest)


@dataclass
class QtiItem:
    """An item as a delivery engine holds it."""

    identifier: str
    element: Element
    kinds: dict[str, str]
    defaults: dict[str, str]
    right: dict[str, str]
    feedback: dict[str, str]

    def outcomes(self, responses: dict[str, object]) -> dict[str, str]:
        """The outcomes after response processing."""
        found = dict(self.defaults)
        for condition in all_named(self.element, "responseCondition"):
            for branch in condition:
                test, *rules = list(branch) if of_21(local(branch)) != "responseElse" else [None, *branch]
                if test is None or self.holds(test, responses):
                    for rule in rules:
                        assert of_21(local(rule)) == "setOutcomeValue"
                        found[rule.attrib["identifier"]] = rule[0].text or ""
                    break
        return found

    def holds(self, test: Element, responses: dict[str, object]) -> bool:
        name = of_21(local(test))
        if name == "and":
            return all(self.holds(one, responses) for one in test)
        variable, value = test
        typed = responses.get(variable.attrib["identifier"])
        if typed is None:
            return False
        if name == "match":
            return typed == value.text
        assert name == "equal"
        attributes = {of_21(key): one for key, one in test.attrib.items()}
        wanted = float(value.text or "")
        if attributes["toleranceMode"] == "exact":
            return float(typed) == wanted  # type: ignore[arg-type]
        below, above = map(float, attributes["tolerance"].split())
        return wanted - below <= float(typed) <= wanted + above  # type: ignore[arg-type]

    def score(self, responses: dict[str, object]) -> tuple[float, str]:
        found = self.outcomes(responses)
        return float(found["SCORE"]), self.feedback.get(found.get("FEEDBACK", ""), "")


def all_named(element: Element, name: str) -> list[Element]:
    return [one for one in element.iter() if of_21(local(one)) == name]


def read_item(content: bytes) -> QtiItem:
    root = ElementTree.fromstring(content)
    kinds, right, defaults = {}, {}, {}
    for one in all_named(root, "responseDeclaration"):
        kinds[one.attrib["identifier"]] = one.attrib.get("baseType") or one.attrib["base-type"]
        for value in all_named(one, "value"):
            right[one.attrib["identifier"]] = value.text or ""
    for one in all_named(root, "outcomeDeclaration"):
        for value in all_named(one, "value"):
            defaults[one.attrib["identifier"]] = value.text or ""
    feedback = {one.attrib["identifier"]: "".join(one.itertext()) for one in all_named(root, "modalFeedback")}
    return QtiItem(root.attrib["identifier"], root, kinds, defaults, right, feedback)


def read_package(content: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(BytesIO(content)) as archive:
        assert archive.testzip() is None
        return {name: archive.read(name) for name in archive.namelist()}


# Maxima


def maxima_value(text: str, values: dict[str, float]) -> float:
    """The value of an expression of Maxima, by a reader of its own."""
    words = re.findall(r"%?[A-Za-z_]\w*|\d+|[-+*/^(),]", text)
    assert "".join(words) == text.replace(" ", "")
    value, rest = summed(words, values)
    assert not rest
    return value


def summed(words: list[str], values: dict[str, float]) -> tuple[float, list[str]]:
    minus = words[0] == "-"
    value, words = multiplied(words[1:] if minus else words, values)
    value = -value if minus else value
    while words and words[0] in "+-":
        sign, (other, words) = words[0], multiplied(words[1:], values)
        value = value + other if sign == "+" else value - other
    return value, words


def multiplied(words: list[str], values: dict[str, float]) -> tuple[float, list[str]]:
    value, words = raised(words, values)
    while words and words[0] in "*/":
        sign, (other, words) = words[0], raised(words[1:], values)
        value = value * other if sign == "*" else value / other
    return value, words


def raised(words: list[str], values: dict[str, float]) -> tuple[float, list[str]]:
    value, words = atom(words, values)
    if words and words[0] == "^":
        exponent, words = raised(words[1:], values)
        value = value**exponent
    return value, words


def atom(words: list[str], values: dict[str, float]) -> tuple[float, list[str]]:
    first, *rest = words
    if first == "(":
        value, rest = summed(rest, values)
        assert rest[0] == ")"
        return value, rest[1:]
    if first.isdigit():
        return float(first), rest
    if rest[:1] == ["("]:
        arguments, rest = [], rest
        while rest[0] in "(,":
            value, rest = summed(rest[1:], values)
            arguments.append(value)
        return {"abs": abs}.get(first, getattr(math, first, None))(*arguments), rest[1:]  # type: ignore[misc]
    return {"%pi": math.pi, **values}[first], rest
