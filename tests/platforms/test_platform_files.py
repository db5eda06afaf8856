"""The files for platforms: what is in them, that nothing a user writes breaks them, and that they are the same each time."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from pages import FALL
from platform_rules import (
    all_named,
    html_of,
    local,
    of_21,
    plain,
    read_cloze,
    read_item,
    read_moodle,
    read_package,
    steps_of_path,
)
from rotsolve import cli
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.page.blocks import authored
from rotsolve.platforms.cloze import choice_box
from rotsolve.platforms.fragments import FragmentHtml, fragments_in
from rotsolve.platforms.known import KnownOption, PlatformPart
from rotsolve.platforms.moodle import (
    GRADES,
    LONGEST_NAME,
    QuestionFrame,
    category,
    grade_text,
    html_in,
    quiz_xml,
    text_in,
)
from rotsolve.platforms.moodle_files import MoodleFiles
from rotsolve.platforms.qti import option_name
from rotsolve.platforms.qti_files import QtiFiles
from rotsolve.platforms.typed_units import typed_units
from rotsolve.platforms.xml_text import plain_decimal, writable
from sheets_made import ROOT, judge_of, judged, made, sheets_of

DISC = str(ROOT / "problems/pulleys/block-on-disc.yaml")
NASTY = (
    r"""<script>alert(1)</script> ]]> & "q" 'a' $$x$$ \(y\) \[z\] {1:NUMERICAL:=1} """
    r"""[[input:ans1]] {@x@} {#n#} @@PLUGINFILE@@/x </text>"""
)
MEANT_BY_PLATFORMS = re.compile(r"\\\(|\\\[|\$\$|\{\d*:|\[\[|\{@|\{#|@@PLUGINFILE")


@pytest.fixture
def key(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[..., tuple[int, str]]:
    """Run `rotsolve key` in a folder with a problem that varies."""
    (tmp_path / "fall.yaml").write_text(FALL, encoding="utf-8")
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> tuple[int, str]:
        with pytest.raises(SystemExit) as left:
            cli.main(["key", *arguments])
        return int(left.value.code or 0), capsys.readouterr().err

    return run


# what users write


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.text(max_size=60))
@example(NASTY)
@example("\x00\x08\ud7ff￿ \U0001f600")
def test_no_text_breaks_a_file(text: str) -> None:
    """A text comes back as it is, but for what XML can not hold, and no platform sees a sign of its own in it."""
    html = FragmentHtml().sentence((authored(text),))
    assert not MEANT_BY_PLATFORMS.search(html)
    kept = re.sub("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "�", text)
    assert plain(html).replace("\r", "\n") == kept.replace("\r\n", "\n").replace("\r", "\n")
    question = category(text)
    text_in(question, text), html_in(question, "feedback", html)
    found = ElementTree.fromstring(quiz_xml([question]))
    assert (found.findtext("question/text") or "").replace("\r", "\n") == kept.replace("\r\n", "\n").replace("\r", "\n")


@settings(max_examples=60, deadline=None)
@given(st.text(max_size=40), st.text(max_size=40))
@example(NASTY, NASTY[::-1])
@example("a ~ b # c } d \\", "1 < 2 & 'x' &amp; &#126; \\")
def test_a_box_of_a_cloze_holds_any_text(shown: str, said: str) -> None:
    """What Moodle makes of a box is the HTML that stands anywhere else."""
    printer = FragmentHtml()
    first, other = (KnownOption((authored(f"({text}"),), Fraction(0), ((authored(text),),)) for text in (shown, said))
    part = PlatformPart(None, (), None, None, options=(first, other))  # type: ignore[arg-type]
    ((weight, kind, answers),) = read_cloze(choice_box(QuestionFrame(printer, "", ""), part, 3))
    assert (weight, kind) == (3, "MULTICHOICE_VS")
    for (text, _, share, feedback), place in zip(answers, part.order, strict=True):
        option = part.options[place]
        assert share == (0.0 if place else 1.0)
        for held, html in ((text, printer.words(option.shown)), (feedback, printer.sentence(*option.said))):
            assert ElementTree.tostring(html_of(held)) == ElementTree.tostring(html_of(html.replace("\n", " ")))


@settings(max_examples=60, deadline=None)
@given(st.lists(st.text(min_size=1, max_size=12).filter(str.strip), min_size=1, max_size=3))
@example(["Homework 4/", "/1. Disc", "a/b//c", "m/s"])
@example(["x" * 400])
def test_paths_of_categories_are_divided_as_they_were(names: list[str]) -> None:
    path = steps_of_path(category(*names).findtext("category/text") or "")
    assert path[:2] == ["$course$", "top"]
    assert path[2:] == [writable(name[:LONGEST_NAME]).strip() for name in names]


def test_a_nasty_title_and_text(tmp_path: Path) -> None:
    """The title and the text of a scene stand in all files as they are, and break none."""
    quoted = NASTY.replace("'", "''")
    scene = tmp_path / "nasty.yaml"
    told = FALL.replace("title: Bucket & rope", f"title: '{quoted}'")
    told = re.sub(r"text: >\n.*?\n\n.*?\n", lambda _: "", told, flags=re.DOTALL)
    scene.write_text(told, encoding="utf-8")
    sheets = sheets_of(str(scene))
    for question in read_moodle(made(MoodleFiles(4, "en"), sheets)["moodle.xml"]):
        assert NASTY[:200] in question.name
    for content in made(QtiFiles(4, "en"), sheets).values():
        files = read_package(content)
        for name, data in files.items():
            if name.startswith("items/"):
                assert NASTY in read_item(data).element.attrib["title"]


# Moodle


def test_variants_of_several_parts_are_one_cloze_each() -> None:
    """A category holds one question for each variant, with the numbers of its key, and weights that are as the points."""
    sheets = sheets_of(DISC.replace("block-on-disc", "atwood"), variants=3)
    questions = read_moodle(made(MoodleFiles(4, "en"), sheets)["moodle.xml"])
    clozes = [one for one in questions if one.kind == "cloze"]
    assert len(clozes) == 3 and len({one.category for one in clozes}) == 1
    assert [one.category for one in questions].count(clozes[0].category) == 3
    for sheet, question in zip(sheets, clozes, strict=True):
        boxes = read_cloze(question.text)
        one = sheet.problems[0]
        values = []
        for _, answer in one.answers():
            values += [part.value for part in answer.components] if answer.components else [answer.value]
        assert len(boxes) == len(values)
        for (weight, kind, answers), value in zip(boxes, values, strict=True):
            assert kind == "NUMERICAL" and weight >= 1
            number, tolerance, fraction, _ = answers[0]
            assert value is not None and fraction == 1.0
            assert float(number) == pytest.approx(value.float, abs=tolerance / 900 + 1e-15)
        said = "".join(answer[3] for box in boxes for answer in box[2])
        assert "it looks as if the tension was taken as the weight of the light" in said


def test_choices_words_and_letters(tmp_path: Path) -> None:
    """An answer in words is a choice with the labels of its options; one in letters alone is a choice of formulas."""
    words = ROOT / "problems"
    chosen = next(path for path in sorted(words.rglob("*.yaml")) if "which of" in path.read_text(encoding="utf-8"))
    sheets = sheets_of(str(chosen))
    one = sheets[0].problems[0]
    judge = judge_of(one)
    questions = read_moodle(made(MoodleFiles(4, "en"), sheets)["moodle.xml"])
    found = [
        question
        for question in questions
        if question.kind == "multichoice" and not question.category.endswith("choice")
    ]
    names = [answer.name for _, answer in one.answers() if answer.word]
    assert len(found) >= len(names) > 0
    for question, name in zip(found, names, strict=False):
        assert [plain(answer[0])[1].lower() for answer in question.answers] == [*"abcdefgh"][: len(question.answers)]
        for text, _, fraction, _ in question.answers:
            label = re.match(r"\((\w+)\)", plain(text))
            assert label is not None
            part = judged(judge, name, label[1])
            assert fraction == pytest.approx(float(part.marks / part.of))


def test_grades_are_those_that_moodle_knows() -> None:
    assert [grade_text(grade) for grade in GRADES][:3] == ["100", "90", "83.33333"]
    assert plain_decimal(GRADES[4] * 100) == "75"


@pytest.mark.parametrize("text", ["m/s²", "N", "rad/s", "kg m²/s", "J", "N m", "°", "Hz", "s", "ft/s"])
def test_units_that_are_typed(text: str) -> None:
    """Each name is read by our own reader of units as well, and has the multiplier that it has there."""
    unit = parse_unit(text)
    units = typed_units(unit, unit.dimension)
    assert units[0][1] == 1.0 and len(units) >= 2
    for name, many in units:
        other = parse_unit(re.sub(r"[·*]", " ", name)) if re.search(r"[·*]", name) or " " not in text else None
        if other is not None:
            ratio = float(unit.scale / other.scale) * 3.141592653589793 ** (unit.pi_power - other.pi_power)
            assert many == pytest.approx(ratio, rel=1e-10), name


# QTI


@pytest.mark.parametrize("in_words", [False, True])
def test_the_name_of_an_option_does_not_tell_the_right_one(in_words: bool) -> None:
    """The right one is the first of what is known; its name goes by the order, which is that of labels or of what the options are."""
    options = tuple(KnownOption((text,), Fraction(0)) for text in ("(b) sin", "(c) tan", "(a) cos"))
    part = PlatformPart(None, (), None, None, options=options, in_words=in_words)  # type: ignore[arg-type]
    assert [option_name(part, place) for place in range(3)] == ["OPTION_2", "OPTION_3", "OPTION_1"]


@pytest.mark.parametrize("variants", [0, 3])
def test_a_package_is_whole(variants: int) -> None:
    """The manifest lists every file once, the test every item, of variants one; all of it keeps the rules of its version."""
    sheets = sheets_of(DISC.replace("block-on-disc", "atwood"), variants=variants)
    for name, content in made(QtiFiles(4, "en"), sheets).items():
        version = {"qti21.zip": "2.1", "qti30.zip": "3.0"}[name]
        files = read_package(content)
        manifest, test = (ElementTree.fromstring(files[one]) for one in ("imsmanifest.xml", "test.xml"))
        hrefs = [one.attrib["href"] for one in manifest.iter() if local(one) == "file"]
        assert sorted(hrefs) == sorted(files.keys() - {"imsmanifest.xml"})
        assert [local(one) for one in manifest] == ["metadata", "organizations", "resources"]
        names = [one.attrib["identifier"] for one in manifest.iter() if local(one) == "resource"]
        assert len(set(names)) == len(names)
        assert {one.attrib["identifierref"] for one in manifest.iter() if local(one) == "dependency"} <= {*names}
        kinds = {one.attrib["type"] for one in manifest.iter() if local(one) == "resource"}
        assert kinds == {f"imsqti_{kind}_xmlv{version.replace('.', 'p')}" for kind in ("item", "test")} | {"webcontent"}
        listed = [one.attrib["href"] for one in all_named(test, "assessmentItemRef")]
        assert sorted(listed) == sorted(one for one in files if one.startswith("items/"))
        assert [one.attrib["select"] for one in all_named(test, "selection")] == (["1"] if variants else [])
        for item in listed:
            root = read_item(files[item]).element
            for image in root.iter():
                if local(image) == "img":
                    assert image.attrib["src"].replace("../", "") in files


def test_both_versions_say_the_same() -> None:
    """The items of 3.0 are those of 2.1 under the names of 3.0, as an independent converter of packages makes them too."""
    from qti_convert import upgrade_qti2_to_qti3 as convert

    packages = made(QtiFiles(4, "en"), sheets_of(DISC))
    older, newer = read_package(packages["qti21.zip"]), read_package(packages["qti30.zip"])

    def tree(element: ElementTree.Element) -> tuple[object, ...]:
        attributes = {
            of_21(key.rpartition("}")[2]): one for key, one in element.attrib.items() if "schema" not in key.lower()
        }
        return (element.tag, sorted(attributes.items()), (element.text or "").strip(), *map(tree, element))

    for name, content in older.items():
        if name.endswith(".xml") and name != "imsmanifest.xml":
            upgraded = ElementTree.fromstring(convert(content.decode()).encode())
            assert tree(upgraded) == tree(ElementTree.fromstring(newer[name])), name


# the page


def test_the_commands_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each command of docs/platforms.md runs, and writes the files that the page names."""
    page = (ROOT / "docs/platforms.md").read_text(encoding="utf-8")
    monkeypatch.chdir(ROOT)
    commands = re.findall(r"^rotsolve (.*)$", page, flags=re.MULTILINE)
    assert len(commands) == 2
    for command in commands:
        arguments = command.split()
        folder = tmp_path / arguments[arguments.index("-o") + 1]
        arguments[arguments.index("-o") + 1] = str(folder)
        with pytest.raises(SystemExit) as left:
            cli.main(arguments)
        assert left.value.code == 0
        assert {path.name for path in folder.iterdir()} == set(re.findall(r"`([\w.]+\.(?:xml|zip))`", page)) - {
            "test.xml"
        }


# the command


def test_the_command_writes_them_alike_each_time(key: Callable[..., tuple[int, str]], tmp_path: Path) -> None:
    """Two runs give the same bytes; pages and platforms can be asked for together."""
    for folder in ("one", "two"):
        assert key("fall.yaml", "-o", folder, "--variants", "2", "-f", "moodle", "-f", "qti", "-f", "csv") == (0, "")
    names = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert names == ["key.csv", "moodle.xml", "qti21.zip", "qti30.zip", "sheets.csv", "stack.xml"]
    for name in names:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()
    with zipfile.ZipFile(tmp_path / "one" / "qti30.zip") as archive:
        assert archive.namelist()[0] == "imsmanifest.xml"


def test_an_unknown_format_is_refused(key: Callable[..., tuple[int, str]]) -> None:
    code, message = key("fall.yaml", "-o", "x", "-f", "moodl")
    assert code == 2 and "moodle" in message


def test_german(key: Callable[..., tuple[int, str]]) -> None:
    """The words of the program are German, numbers that are compared keep their points."""
    files = made(MoodleFiles(4, "de"), sheets_of(DISC))
    question = next(one for one in read_moodle(files["moodle.xml"]) if one.kind == "numerical")
    assert "Gegeben" in question.text and question.answers[0][0] == "4.35556"
    assert fragments_in("de").code == "de"
