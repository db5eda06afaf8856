"""Sheet files: what they say, every fault at its place, and the points of parts, scaled exactly."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from pages import FALL
from rotsolve import cli
from rotsolve.core.faults import SceneError
from rotsolve.keys.parts import exact_points, part_label, parts_of, scaled_marking
from rotsolve.keys.problem_set import problem_as_set, read_problem_set, set_of_files
from rotsolve.language.marks import Deduction
from rotsolve.language.problem import Problem, Wording
from rotsolve.scene.read import read_text

Key = Callable[..., tuple[int, str]]
SHEET = """\
sheet: Homework 4
course: Mechanics I
paper: letter
room: 3 cm
problems:
  - fall.yaml
  - {problem: plain.yaml, name: roll, points: 5, room: none, ruled: yes, picture: no, page: new}
"""


def written(folder: Path, text: str) -> Path:
    file = folder / "sheet.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def test_a_sheet_file_says_which_problems_there_are(page: Path) -> None:
    found = read_problem_set(written(page, SHEET))
    assert (found.title, found.course, found.paper, found.date) == ("Homework 4", "Mechanics I", "letter", "")
    first, second = found.problems
    assert (first.number, first.name, first.points, first.layout.room) == (1, "fall", None, 30)
    assert (second.number, second.name, second.points, second.layout.room) == (2, "roll", 5, 0)
    assert (second.layout.ruled, second.layout.picture, second.layout.new_page) == (True, False, True)
    assert found.listed("2") is found.listed("roll") is second and found.listed("plain") is None
    assert Path(second.path) == page / "plain.yaml"


FAULTS = [
    ("sheet: Homework 4", "shet: H", "sheet.yaml:1:1\n 1 | shet: H\n   | ^^^^\nhelp: did you mean `sheet`?"),
    ("sheet: Homework 4", "course2: x", "error: the sheet has no `sheet`\n  --> sheet.yaml\nhelp: add it: the title"),
    ("paper: letter", "paper: a5", "error: `paper` can't be `a5`\n  --> sheet.yaml:3:8"),
    ("room: 3 cm", "room: 3 kg", "error: `room` can't be `3 kg`\n  --> sheet.yaml:4:7"),
    ("room: 3 cm", "room: 3 m", "write a height up to 250 mm, such as `3 cm`, or `none`"),
    ("fall.yaml", "fal.yaml", "error: there is no file `fal.yaml` in `.`\n  --> sheet.yaml:6:5"),
    ("fall.yaml", "fal.yaml", "help: did you mean `fall.yaml`?"),
    ("- fall.yaml", "- {name: a}", "error: problem 1 of the sheet has no file\n  --> sheet.yaml:6:5"),
    ("- fall.yaml", "- [fall.yaml]", "error: problem 1 wants `name: value` lines, but this is a list"),
    ("name: roll", "name: fall", "error: two problems are called `fall`, the first in line 6\n  --> sheet.yaml:7:33"),
    ("name: roll", "name: a.b", "error: `a.b` can't be the short name of a problem"),
    ("name: roll", "name: 12", "of which not all are digits"),
    ("points: 5", "points: many", "error: `points` can't be `many`\n  --> sheet.yaml:7:47"),
    ("picture: no", "picture: perhaps", "error: `picture` wants `true` or `false`"),
    ("page: new", "page: old", "error: `page` can't be `old`"),
    ("course: Mechanics I", "instructions: 'take $g'", "a formula begins in `instructions` and does not end"),
    ("course: Mechanics I", "instructions: 'take {g}'", "error: `{g}` in `instructions` names no given"),
    ("room: 3 cm", "room:", "`room`"),
]


@pytest.mark.parametrize(("old", "new", "message"), FAULTS, ids=[fault[1] for fault in FAULTS])
def test_faults_are_told_at_their_place(
    page: Path, monkeypatch: pytest.MonkeyPatch, old: str, new: str, message: str
) -> None:
    assert old in SHEET
    written(page, SHEET.replace(old, new, 1))
    monkeypatch.chdir(page)
    with pytest.raises(SceneError) as caught:
        read_problem_set("sheet.yaml")
    assert message in str(caught.value)


def test_all_faults_of_a_sheet_are_told_at_once(page: Path) -> None:
    with pytest.raises(SceneError) as caught:
        read_problem_set(written(page, SHEET.replace("letter", "a5").replace("3 cm", "3 kg").replace("fall", "fal")))
    assert len(caught.value.faults) == 3


@pytest.mark.parametrize("command", ["solve", "draw", "simulate"])
def test_a_sheet_is_no_scene(page: Path, capsys: pytest.CaptureFixture[str], command: str) -> None:
    file = written(page, SHEET)
    with pytest.raises(SystemExit) as left:
        cli.main([command, str(file), *(["-o", str(page / "x.svg")] if command == "draw" else [])])
    said = capsys.readouterr().err
    assert left.value.code == 2
    assert "error: this file is a sheet of problems, and no scene" in said and "`rotsolve key" in said


def test_a_sheet_file_and_named_files_make_the_same(key: Key, page: Path) -> None:
    written(page, "sheet: Two\npaper: letter\nproblems: [fall.yaml, plain.yaml]\n")
    assert key("sheet.yaml", "-o", "one", "-f", "html", "-f", "json", "--solutions") == (0, "")
    named = ("fall.yaml", "plain.yaml", "--title", "Two", "--paper", "letter")
    assert key(*named, "-o", "other", "-f", "html", "-f", "json", "--solutions") == (0, "")
    for file in sorted((page / "one").iterdir()):
        assert file.read_bytes() == (page / "other" / file.name).read_bytes(), file.name


def test_what_the_command_says_goes_before_the_file(key: Key, page: Path) -> None:
    written(page, SHEET)
    more = ("--title", "Quiz", "--paper", "a4", "--room", "15mm", "--ruled", "--no-pictures")
    assert key("sheet.yaml", "-o", "out", *more) == (0, "")
    html = (page / "out" / "sheet.html").read_text("utf-8")
    assert "<h1>Quiz</h1>" in html and "size: A4" in html and "<svg" not in html
    assert html.count('<div class="room"><i></i></div>') == 5


def test_a_problem_that_fails_keeps_its_number(key: Key, page: Path) -> None:
    written(page, "sheet: T\nproblems: [open.yaml, fall.yaml]\n")
    code, said = key("sheet.yaml", "-o", "out", "-f", "markdown")
    assert code == 1 and "open.yaml" in said
    assert "## 2. Bucket & rope" in (page / "out" / "sheet.md").read_text("utf-8")


# parts and points


def problem(marking: str = "", ask: str = "") -> Problem:
    return read_text(FALL + (f"marking: {marking}\n" if marking else "") + (f"ask: {ask}\n" if ask else ""))


def test_parts_are_in_the_order_of_find_unless_all_are_worded() -> None:
    assert [(part.label, part.name) for part in parts_of(problem())] == [("a", "a"), ("b", "alpha"), ("c", "T")]
    some = problem(ask="{T: the pull}")
    assert [part.name for part in parts_of(some)] == ["a", "alpha", "T"]
    every = problem(ask="{T: the pull, a: how it falls, alpha: how it turns}")
    assert [(part.label, part.name) for part in parts_of(every)] == [("a", "T"), ("b", "a"), ("c", "alpha")]


def test_labels_go_on_behind_z() -> None:
    assert [part_label(place) for place in (0, 25, 26, 51, 52, 701, 702)] == ["a", "z", "aa", "az", "ba", "zz", "aaa"]


@given(
    st.lists(st.fractions(0, 20, max_denominator=12), min_size=3, max_size=3), st.fractions(0, 50, max_denominator=9)
)
def test_points_are_scaled_exactly(own: list[Fraction], wanted: Fraction) -> None:
    marked = problem(marking="{a: 2}")
    names = ("a", "alpha", "T")
    marked = replace(
        marked,
        marking=tuple(replace(marked.marking[0], name=name, points=p) for name, p in zip(names, own, strict=True)),
    )
    scaled = [one.points for one in scaled_marking(marked, wanted)]
    assert sum(scaled) == wanted
    for one, before in zip(scaled, own, strict=True):
        assert one * sum(own) == before * wanted or not sum(own)


def test_what_flaws_cost_is_scaled_with_the_points() -> None:
    marked = problem(marking="{all: {points: 2, deduct: {unit: 1/2, rounding: 25 %}}}")
    (first, *_) = scaled_marking(marked, Fraction(18))
    assert first.points == 6
    assert dict(first.deduct)["unit"] == Deduction(Fraction(3, 2))
    assert dict(first.deduct)["rounding"] == Deduction(Fraction(1, 4), share=True)


def test_a_problem_of_a_set_is_marked_in_its_points(page: Path) -> None:
    found = read_problem_set(written(page, SHEET))
    assert [part.points for part in parts_of(problem_as_set(found.problems[1]))] == [Fraction(5, 2)] * 2
    assert [part.points for part in parts_of(problem_as_set(found.problems[0]))] == [1, 1, 1]
    assert [one.name for one in set_of_files(["a/x.yaml", "b/x.yaml", "y.yaml"]).problems] == ["a/x", "b/x", "y"]


@pytest.mark.parametrize(
    ("points", "said"), [("3", "3"), ("5/2", "2.5"), ("8/3", "8/3"), ("1/4", "0.25"), ("1/8", "1/8")]
)
def test_points_are_printed_exactly(points: str, said: str) -> None:
    assert exact_points(Fraction(points)) == said


def test_wordings_name_answers_and_givens() -> None:
    for ask, message in (("{b: x}", "unknown key `b` in `ask`"), ("{T: 'with {q}'}", "`{q}` in the wording of `T`")):
        with pytest.raises(SceneError, match="error") as caught:
            problem(ask=ask)
        assert message in str(caught.value)
    assert problem(ask="{T: the pull}").ask == (Wording("T", "the pull", problem(ask="{T: the pull}").ask[0].span),)
