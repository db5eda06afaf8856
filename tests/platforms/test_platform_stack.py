"""STACK: what Maxima is given has the values of our answers, by a reader of its own and, where it is installed, by Maxima itself."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from random import Random
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import pytest

from platform_rules import html_of, maxima_value
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import PI as PI_CONSTANT
from rotsolve.algebra.formula import Call, Number, Power, Product, Quotient, Sum, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.grading.verdict import RIGHT
from rotsolve.platforms.known import parts_for_platforms
from rotsolve.platforms.maxima import NoMaxima, letters_in_maxima, to_maxima
from rotsolve.platforms.moodle_files import MoodleFiles
from sheets_made import ROOT, judge_of, judged, made, sheets_of

SCENES = sorted((ROOT / "problems").rglob("*.yaml"))
PULLEYS = str(ROOT / "problems/pulleys/atwood.yaml")


def stack_questions(files: dict[str, bytes]) -> list[Element]:
    return [one for one in ElementTree.fromstring(files["stack.xml"]) if one.attrib["type"] == "stack"]


@pytest.mark.sampled(40)
@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_formulas_have_the_values_of_the_answers(scene: Path) -> None:
    """Each formula, right or of a mistake, has in Maxima's words the value that the exact form has, at random numbers."""
    sheets = sheets_of(str(scene))
    if not sheets:
        pytest.skip("no answer")
    one, random = sheets[0].problems[0], Random(7)
    judge = judge_of(one)
    for part in parts_for_platforms(one, judge, 4):
        for known in part.formulas:
            names = sorted(known.formula.symbols())
            letters = letters_in_maxima(names)
            values = {name: parse(f"{random.uniform(0.2, 1.4):.3f}") for name in names}
            try:
                text = to_maxima(known.formula, letters)
                exact = evaluate(known.formula, values).float
            except (NoMaxima, ValueError, ZeroDivisionError):
                continue
            numbers = {letters[name]: evaluate(value, {}).float for name, value in values.items()}
            assert maxima_value(text, numbers) == pytest.approx(exact, rel=1e-9, abs=1e-12)
        for known in part.formulas[1:]:
            assert known.share < 1
        if part.formulas:
            assert judged(judge, part.part.name, to_text(part.formulas[0].formula)).verdict.outcome == RIGHT


def test_every_kind_of_formula() -> None:
    """Brackets, signs, roots and functions."""
    a, b = Symbol("a"), Symbol("b")
    letters, numbers = {"a": "a", "b": "b"}, {"a": 0.7, "b": 1.9}
    values = {"a": parse("0.7"), "b": parse("1.9")}
    formulas = [
        *(Quotient(a, Quotient(b, a)), Power(Sum((a, -b)), Number(2)), Power(a, Power(b, a)), -(a - (b - a)), -(a**2)),  # type: ignore[operator]
        *(Product((Sum((a, b)), Quotient(a, b))), Quotient(Product((a, b)), Product((b, b))), PI_CONSTANT * a / 3),
        *(
            Call(name, (Quotient(a, b),))
            for name in ("sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sqrt", "abs")
        ),
        *(parse(f"{name}(a)") for name in ("sinh", "tanh", "arsinh", "lg")),
        Call("atan2", (a, b)),
        Power(Call("sin", (a,)), Number(2)),
    ]
    for formula in formulas:
        assert maxima_value(to_maxima(formula, letters), numbers) == pytest.approx(
            evaluate(formula, values).float, rel=1e-12
        )
    with pytest.raises(NoMaxima):
        to_maxima(Call("ellipk", (a,)), letters)


def test_letters_are_free() -> None:
    """No letter is a constant of Maxima, none has a sign that STACK can not read, and no two are alike."""
    found = letters_in_maxima(["e", "e0", "theta_0", "omega'", "i", "x˙", "pi"])
    assert len(set(found.values())) == len(found)
    assert not {"e", "i", "pi"} & set(found.values())
    assert all(re.fullmatch(r"[A-Za-z]\w*", typed) for typed in found.values())
    assert found["theta_0"] == "theta_0"


def test_a_question_of_stack_is_whole() -> None:
    """Its text has its field, its tree leads from node to node and ends, and its own test is the right answer."""
    for question in stack_questions(made(MoodleFiles(4, "en"), sheets_of(PULLEYS))):
        text = question.findtext("questiontext/text") or ""
        html_of(text)
        assert text.count("[[input:ans1]]") == text.count("[[validation:ans1]]") == 1
        nodes = question.findall("prt/node")
        assert [node.findtext("name") for node in nodes] == [str(place) for place in range(len(nodes))]
        assert [node.findtext("falsenextnode") for node in nodes] == [*map(str, range(1, len(nodes))), "-1"]
        assert nodes[0].findtext("truescore") == "1" and {node.findtext("answertest") for node in nodes} == {"AlgEquiv"}
        assert question.findtext("qtest/testinput/value") in (question.findtext("questionvariables/text") or "")
        words = [node.findtext("truefeedback/text") or "" for node in nodes[1:]]
        assert words and all("it looks as if" in said for said in words)
        allowed = (question.findtext("input/allowwords") or "").split(",")
        assert {"M", "g", "m1", "m2"} <= {*allowed}


def variables_of(question: Element, chosen: int) -> dict[str, float]:
    """The numbers of the variables of a question for one variant, by a reader of its own."""
    found: dict[str, float] = {}
    for line in (question.findtext("questionvariables/text") or "").splitlines():
        name, _, value = line.rstrip(";").partition(":")
        if value.startswith("["):
            listed = value.removesuffix("[rotk]").strip("[]").split(",")
            found[name] = maxima_value(listed[chosen], {})
        elif value.startswith("float("):
            inner = re.fullmatch(r"float\(subst\(\[(.*?)\],(.*)\)/\((.*)\)\)", value)
            assert inner is not None
            letters = {one.partition("=")[0]: found[one.partition("=")[2]] for one in inner[1].split(",")}
            try:
                found[name] = maxima_value(inner[2], letters) / maxima_value(inner[3], {})
            except ZeroDivisionError:
                raise AssertionError(f"{name} has no value") from None
    return found


def test_variants_have_the_numbers_of_their_key() -> None:
    """With variants a question holds the values of all of them, a seed for each, and Maxima's number is that of the key."""
    sheets = sheets_of(PULLEYS, variants=4)
    questions = stack_questions(made(MoodleFiles(4, "en"), sheets))
    assert questions
    for question in questions:
        assert [one.text for one in question.findall("deployedseed")] == ["1", "2", "3", "4"]
        assert (question.findtext("questionvariables/text") or "").startswith("rotk:rand(4)+1;")
        assert question.findtext("questionnote/text") == "variant {#rotk#}"
        text = question.findtext("questiontext/text") or ""
        label = (question.findtext("name/text") or "").split()[0].removeprefix("1")
        for place, sheet in enumerate(sheets):
            assert f"[[if test='rotk={place + 1}']]" in text
            one = sheet.problems[0]
            answer = next(answer for part, answer in one.answers() if part.label == label)
            assert answer.value is not None
            assert variables_of(question, place)["ta"] == pytest.approx(answer.value.float, rel=1e-12)


@pytest.mark.skipif(shutil.which("maxima") is None, reason="Maxima is not installed")
def test_maxima_itself_agrees() -> None:
    """Maxima reads the variables of each question, and has the numbers of our reader."""
    for question in stack_questions(made(MoodleFiles(4, "en"), sheets_of(PULLEYS, variants=4))):
        variables = (question.findtext("questionvariables/text") or "").replace("rand(4)+1", "3")
        names = re.findall(r"^(t\w+):", variables, re.MULTILINE)
        program = f"display2d:false$ {variables.replace(';', '$')} for v in [{','.join(names)}] do print(float(v));"
        done = subprocess.run(
            ["maxima", "--very-quiet", "--batch-string", program], capture_output=True, text=True, check=True
        )
        numbers = [float(line) for line in done.stdout.split() if re.fullmatch(r"-?\d+\.\d+(e-?\d+)?", line)]
        wanted = variables_of(question, 2)
        assert numbers[-len(names) :] == pytest.approx([wanted[name] for name in names], rel=1e-12)
