"""What a platform would mark right is right for `check`, and the other way round: over the problems, by rules written anew."""

from __future__ import annotations

from pathlib import Path
from random import Random
from unicodedata import normalize

import pytest

from platform_rules import QtiItem, plain, read_item, read_moodle, read_package
from rotsolve.grading.verdict import RIGHT, UNDECIDED
from rotsolve.keys.sheets import key_data
from rotsolve.page.text import plain_text
from rotsolve.platforms.known import KnownNumbers, PlatformPart, parts_for_platforms
from rotsolve.platforms.moodle_files import MoodleFiles
from rotsolve.platforms.qti_files import QtiFiles
from sheets_made import ROOT, judge_of, judged, made, sheets_of

SCENES = sorted((ROOT / "problems").rglob("*.yaml"))
EDGE = 0.004  # the share of the margin beside its edge in which rounding of the file may tell
TRIES = 6


def typed(numbers: list[float], part: PlatformPart) -> str:
    """Numbers as a student writes them, with many figures."""
    unit, written = part.boxes[0].unit, [f"{number:.10g}" for number in numbers]
    if len(written) == 1:
        return unit.after(written[0])
    if len(part.answer.rows) > 1:
        wide = len(part.answer.rows[0])
        rows = [written[first : first + wide] for first in range(0, len(written), wide)]
        return unit.after(f"[{', '.join('[' + ', '.join(row) + ']' for row in rows)}]")
    return unit.after(f"({', '.join(written)})")


def tried(part: PlatformPart, random: Random) -> list[list[float]]:
    """Numbers round the right ones, and some that are far off; none on the very edge."""
    right, margins = map(float, part.numbers[0].numbers), map(float, part.numbers[0].margins)
    pairs = list(zip(right, margins, strict=True))
    offs = [
        [
            random.choice((-1, 1)) * random.choice((random.uniform(0, 1 - EDGE), random.uniform(1 + EDGE, 4)))
            for _ in pairs
        ]
        for _ in range(TRIES)
    ]
    return [[number + off * margin for (number, margin), off in zip(pairs, some, strict=True)] for some in offs]


@pytest.mark.sampled(50)
@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_platforms_mark_as_check_does(scene: Path) -> None:
    """Right by the platform's rule is right for check; known wrong answers have the marks and the words of check."""
    sheets = sheets_of(str(scene))
    if not sheets:
        pytest.skip("no answer")
    one = sheets[0].problems[0]
    judge, random = judge_of(one), Random(scene.stem)
    parts = parts_for_platforms(one, judge, 4)
    questions = read_moodle(made(MoodleFiles(4, "en"), sheets)["moodle.xml"])
    files = made(QtiFiles(4, "en"), sheets)
    items = {name: read_package(content) for name, content in files.items()}
    numerical = iter([question for question in questions if question.kind == "numerical"])
    for part in parts:
        item = read_item(items["qti21.zip"][f"items/p1{part.part.label}.xml"])
        newer = read_item(items["qti30.zip"][f"items/p1{part.part.label}.xml"])
        assert item.right == newer.right and float(item.defaults["MAXSCORE"]) == float(part.part.points)
        if not part.numbers:
            continue
        boxes = [next(numerical) for _ in part.boxes]
        for numbers in tried(part, random):
            found = judged(judge, part.part.name, typed(numbers, part))
            if found.verdict.outcome == UNDECIDED:
                continue
            share = float(found.marks / found.of)
            score, _ = qti_score(item, numbers)
            assert score == qti_score(newer, numbers)[0]
            assert (score == float(part.part.points)) == (share == 1), (part.part.name, numbers, found)
            grades = [
                box.grade_of(f"{number:.10g} {box_unit}")[0]
                for box, number, box_unit in zip(boxes, numbers, units(boxes), strict=True)
            ]
            assert all(grade == 1 for grade in grades) == (share == 1), (part.part.name, numbers, found)
        for known in part.numbers:
            numbers = [float(number) for number in known.numbers]
            score, said = qti_score(item, numbers)
            if known is part.numbers[0] or numbers != [float(number) for number in part.numbers[0].numbers]:
                first = judged(judge, part.part.name, typed_exactly(known.numbers, part))
                assert score == pytest.approx(float(first.marks)), (known, first)
                words = [plain_text(remark.words) for remark in first.verdict.remarks]
                if not any(covers(other, numbers) for other in part.numbers[: part.numbers.index(known)]):
                    assert letters(said) == letters("".join(words)), (said, words)
    assert next(numerical, None) is None


@pytest.mark.sampled(30)
@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_what_rounding_on_the_way_makes_of_a_number_is_worth_the_same(scene: Path) -> None:
    """However narrow the band is between what an answer may be off and how far rounding takes it."""
    sheets = sheets_of(str(scene))
    if not sheets:
        pytest.skip("no answer")
    one = sheets[0].problems[0]
    judge = judge_of(one)
    for part in parts_for_platforms(one, judge, 4):
        asked = judge.targets[part.part.name].whole
        if len(part.numbers) < 1 or len(part.boxes) != 1 or asked is None:
            continue
        right, margin = float(part.numbers[0].numbers[0]), float(part.numbers[0].margins[0])
        band = float(judge.explaining.spread(asked)) * abs(right) - margin
        for side in (1, -1) if band > EDGE * margin else ():
            number = right + side * (margin + band / 2)
            found = judged(judge, part.part.name, typed([number], part))
            known = next((one for one in part.numbers if covers(one, [number])), None)
            assert float(found.marks / found.of) == float(known.share if known else 0), (part.part.name, number, found)


def test_a_narrow_band_is_known() -> None:
    """The force at the lowest point, 23.8875 N: 1 % is right, 1.12 % is what rounding makes it, and what lies between has part marks."""
    one = sheets_of(str(ROOT / "problems" / "hinged" / "rod-30.yaml"))[0].problems[0]
    part = next(part for part in parts_for_platforms(one, judge_of(one), 4) if part.part.name == "F_low")
    found = [next(known.share for known in part.numbers if covers(known, [number])) for number in (23.7, 23.63, 24.14)]
    assert [str(share) for share in found] == ["1", "3/4", "3/4"]


def covers(known: KnownNumbers, numbers: list[float]) -> bool:
    """Whether numbers are those of a known answer already: a platform sees no figures, 1.6 and 1.600 are the same to it."""
    sides = zip(known.numbers, known.margins, numbers, strict=True)
    return all(abs(float(number) - typed) <= float(margin) for number, margin, typed in sides)


def letters(text: str) -> str:
    """The letters and digits of a text, however they are set."""
    return "".join(sign for sign in normalize("NFKD", text) if sign.isalnum())


def typed_exactly(numbers: tuple[str, ...], part: PlatformPart) -> str:
    unit = part.boxes[0].unit
    if len(numbers) == 1:
        return unit.after(numbers[0])
    return typed([float(number) for number in numbers], part)


def units(boxes: list) -> list[str]:  # type: ignore[type-arg]
    return [next(iter(box.units), "") for box in boxes]


def qti_score(item: QtiItem, numbers: list[float]) -> tuple[float, str]:
    names = list(item.kinds)
    return item.score(dict(zip(names, numbers, strict=True)))


@pytest.mark.sampled(120)
@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_numbers_of_the_key(scene: Path) -> None:
    """The right numbers, their tolerance and points are those of `rotsolve key -f json`."""
    sheets = sheets_of(str(scene))
    if not sheets:
        pytest.skip("no answer")
    one = sheets[0].problems[0]
    known = {answer["name"]: answer for answer in key_data(sheets[0], 10)["problems"][0]["answers"]}
    for part in parts_for_platforms(one, judge_of(one), 4):
        key = known[part.part.name]
        assert key["part"] == part.part.label and key["points"] in (
            str(part.part.points),
            f"{float(part.part.points):g}",
        )
        entries = key["components"] or [key]
        for box, number, margin, entry in (
            zip(
                part.boxes,
                *(
                    zip(
                        *[(a, b) for a, b in zip(part.numbers[0].numbers, part.numbers[0].margins, strict=True)],
                        strict=True,
                    )
                ),
                entries,
                strict=True,
            )
            if part.numbers
            else ()
        ):
            value = float(entry["value"])
            assert float(number) == pytest.approx(value, abs=float(margin) / 900 + 1e-14), part
            assert box.unit.text == entry["unit"]
            if key["tolerance"].endswith("%") and value:
                assert float(margin) == pytest.approx(abs(value) * float(key["tolerance"].rstrip(" %")) / 100, rel=1e-4)


def test_choices_hold_the_mistakes() -> None:
    """Multiple choice: one right option, and the numbers of mistakes with their words."""
    questions = read_moodle(
        made(MoodleFiles(4, "en"), sheets_of(str(ROOT / "problems/pulleys/block-on-disc.yaml")))["moodle.xml"]
    )
    choice = next(
        question for question in questions if question.kind == "multichoice" and question.name.startswith("1a")
    )
    assert choice.category.endswith("/multiple choice")
    found = {plain(answer[0]): (answer[2], plain(answer[3])) for answer in choice.answers}
    assert found["4.356m/s2"][0] == 1.0 and found["−4.356m/s2"][0] == 0.0
    assert found["9.800m/s2"] == (0.0, "it looks as if the moment of inertia of the disc was left out")
    assert [fraction for fraction, _ in found.values()].count(1.0) == 1


def test_units_are_multipliers_and_cost_what_marking_says() -> None:
    """A value in another unit is right, without one it loses what `marking` says, as `check` has it."""
    sheets = sheets_of(str(ROOT / "problems/pulleys/block-on-disc.yaml"))
    judge = judge_of(sheets[0].problems[0])
    question = next(
        one for one in read_moodle(made(MoodleFiles(4, "en"), sheets)["moodle.xml"]) if one.kind == "numerical"
    )
    for text in (
        "4.356 m/s²",
        "435.6 cm/s^2",
        "4.356",
        "4356 mm/s²",
        "9.8 m/s²",
        "-4.356 m/s^2",
        "4.44 m/s²",
        "0.004356 km/s^2",
    ):
        found = judged(judge, "a", text)
        assert question.grade_of(text)[0] == pytest.approx(float(found.marks / found.of)), text
    assert judged(judge, "a", "4.356").verdict.outcome != RIGHT
