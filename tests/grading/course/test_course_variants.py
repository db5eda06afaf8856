"""Variants: what the key of a variant says is right for it and for no other; each is marked as the scene says."""

from __future__ import annotations

import csv
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Command = Callable[..., Any]
WINCH = """\
title: A bucket on a winch
given: {m: 2 kg, M: 5 kg, R: 0.2 m, g: 9.8 m/s^2}
gravity: g
bodies:
  bucket: {mass: m, moves: down}
  drum: {shape: disc, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: drum}, rope: {string: [drum, bucket]}}
find: {a: bucket.acceleration, alpha: drum.angular_acceleration, T: rope.tension}
vary: {m: 1.0 kg to 3.0 kg by 0.5 kg, M: 4 kg to 8 kg by 1 kg, R: [0.15 m, 0.20 m, 0.25 m], where: M > 2*m}
marking: {a: 2, alpha: 2, T: {points: 2, tolerance: 2 %}}
"""
SLOPE = """\
title: A cylinder that rolls or slips
given: {M: 2 kg, R: 0.1 m, beta: 30 deg, mu: 0.5, g: 9.8 m/s^2}
gravity: g
surfaces: {slope: {slope: beta, down: right}}
bodies: {cylinder: {shape: cylinder, mass: M, radius: R, moves: down, turns: clockwise}}
connections: {grip: {contact: [cylinder, slope], friction: mu}}
find: {a: cylinder.acceleration, alpha: cylinder.angular_acceleration}
vary: {mu: [0.05, 0.1, 0.15, 0.3, 0.5], beta: [20 deg, 30 deg, 40 deg], M: [1 kg, 2 kg]}
marking: {all: 3}
"""


def key() -> dict[str, dict[str, dict[str, str]]]:
    """The rows of the key of thirty variants, by variant and answer."""
    from rotsolve.keys.command import KeyRequest, run_key

    assert run_key(KeyRequest(("scene.yaml",), "handout", ("csv",), 30, 7)) == 0
    found: dict[str, dict[str, dict[str, str]]] = {}
    with Path("handout", "key.csv").open(encoding="utf-8", newline="") as stream:
        for row in csv.DictReader(stream):
            found.setdefault(row["variant"], {})[row["answer"]] = row
    assert [*found] == [str(number) for number in range(1, 31)]
    return found


def marks(command: Command, rows: list[list[str]], names: list[str]) -> list[str]:
    """The marks of a class of these rows."""
    with Path("class.csv").open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows([["name", "variant", *names], *rows])
    command("class.csv", "--variants", "30", "--seed", "7", "-o", "report", "--anew")
    with Path("report", "marks.csv").open(encoding="utf-8", newline="") as stream:
        return [row["marks"] for row in csv.DictReader(stream)]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("scene", [WINCH, SLOPE], ids=["one way", "rolls or slips"])
def test_the_key_of_a_variant_is_right_for_it(command: Command, scene: str) -> None:
    """As numbers and as formulas; as numbers of another variant it is wrong, unless both have the same ones."""
    Path("scene.yaml").write_text(scene, encoding="utf-8")
    found = key()
    names = [*found["1"]]
    numbers = {variant: [f"{row['value']} {row['unit']}" for row in rows.values()] for variant, rows in found.items()}
    formulas = {variant: [row["exact"] for row in rows.values()] for variant, rows in found.items()}
    for answers in (numbers, formulas):
        rows = [[f"Student {variant}", variant, *texts] for variant, texts in reversed(answers.items())]
        assert set(marks(command, rows, names)) == {"6"}
    others = {variant: numbers[str(int(variant) % 30 + 1)] for variant in numbers}
    given = marks(command, [[f"Student {variant}", variant, *texts] for variant, texts in others.items()], names)
    same = [all(left == right for left, right in zip(numbers[one], others[one], strict=True)) for one in numbers]
    assert [mark == "6" for mark in given] == same


@pytest.mark.exhaustive
def test_a_formula_of_the_other_branch_is_wrong(command: Command) -> None:
    """Where the cylinder rolls, what holds where it slips is wrong, and the other way round."""
    Path("scene.yaml").write_text(SLOPE, encoding="utf-8")
    found = key()
    rolls, slips = "2/3 g sin β", "g (sin β − μ cos β)"
    rows = [[variant, variant, rolls] for variant in found] + [[variant, variant, slips] for variant in found]
    expected = ["⅔" in answers["a"]["exact"] for answers in found.values()]
    assert True in expected and False in expected
    given = [mark == "3" for mark in marks(command, rows, ["a"])]
    assert given == expected + [not one for one in expected]


def test_a_variant_is_marked_as_the_scene_says(command: Command) -> None:
    """Points and tolerances stand in the scene alone: the tension may be off by 2 %, the acceleration by 1 %, and α follows from it."""
    Path("scene.yaml").write_text(WINCH, encoding="utf-8")
    answers = key()["1"]
    off = [f"{float(row['value']) * 1.015:.5g} {row['unit']}" for row in answers.values()]
    assert marks(command, [["Ada", "1", *off]], [*answers]) == ["3.5"]


@pytest.mark.parametrize(("words", "code"), [(("--seed", "7"), 0), (("--seed", "8"), 1)])
def test_the_variant_on_the_command_line(command: Command, words: tuple[str, str], code: int) -> None:
    Path("scene.yaml").write_text(WINCH, encoding="utf-8")
    answers = key()["2"]
    lines = [f"{name} = {row['value']} {row['unit']}" for name, row in answers.items()]
    Path("bob.txt").write_text("\n".join(lines), encoding="utf-8")
    assert command("bob.txt", "--variant", "2", *words).code == code
    assert "variant 2" in command("bob.txt", "--variant", "2", *words).out


@pytest.mark.sampled(2)
@pytest.mark.parametrize("scene", [WINCH, SLOPE], ids=["one way", "rolls or slips"])
def test_mistakes_of_a_variant_are_those_of_the_scene_with_its_numbers(
    command: Command, scene: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They are solved once for all variants; solving each anew says the same."""
    Path("scene.yaml").write_text(scene, encoding="utf-8")
    from rotsolve.grading.course.examiner import Judges
    from rotsolve.grading.mistakes.wrong_answers import WrongAnswers
    from rotsolve.keys.variants import worked_variants
    from rotsolve.scene.read import read_file

    rows = []
    for variant, worked in worked_variants(read_file("scene.yaml"), 12, 7):
        wrong = [answers["a"].value for _, answers in WrongAnswers.of(worked.problem) if "a" in answers]
        numbers = [value.float for value in wrong if value is not None]
        rows += [
            [f"S{variant.number}", str(variant.number), f"{numbers[place % len(numbers)]:.5g} m/s²"]
            for place in (0, 3, 5)
        ]
    shared = remarks(command, rows)
    monkeypatch.setattr(Judges, "forms", lambda judges, solution: None)
    assert remarks(command, rows) == shared
    assert sum("it looks as if" in said for said in shared) > 20


def remarks(command: Command, rows: list[list[str]]) -> list[str]:
    """What is said of the answers of a class."""
    marks(command, rows, ["a"])
    with Path("report", "marks.csv").open(encoding="utf-8", newline="") as stream:
        return [row["remarks"] for row in csv.DictReader(stream)]


def test_papers_that_tell_no_variant_are_pointed_out(command: Command) -> None:
    Path("scene.yaml").write_text(WINCH, encoding="utf-8")
    Path("class.csv").write_text("name,variant,a\nAda,1,2mg/(2m+M)\nBob,,2mg/(2m+M)\n", encoding="utf-8")
    ran = command("class.csv", "--variants", "30", "--seed", "7", "-o", "report")
    assert "Papers that tell no variant: Bob. They were marked with the numbers of the problem itself." in ran.out
    assert "No column is named alpha, T." in ran.out
    Path("class.csv").write_text("name,a\nAda,2mg/(2m+M)\n", encoding="utf-8")
    ran = command("class.csv", "--variants", "30", "--seed", "7", "-o", "report")
    assert "No paper tells its variant. They were marked with the numbers of the problem itself." in ran.out


def test_a_seed_that_can_not_be_that_of_the_sheets_is_pointed_out(command: Command) -> None:
    Path("scene.yaml").write_text(WINCH, encoding="utf-8")
    rows = "".join(f"S{number},{number},{number + 50}.5 m/s²\n" for number in range(1, 6))
    Path("class.csv").write_text(f"name,variant,a\n{rows}", encoding="utf-8")
    ran = command("class.csv", "--variants", "30", "--seed", "7", "-o", "report")
    assert (
        "None of the answers with numbers in papers with a variant have marks: is 7 the seed of the sheets?" in ran.out
    )


def test_a_right_answer_behind_another_value_is_to_be_looked_at(command: Command) -> None:
    Path("scene.yaml").write_text(WINCH, encoding="utf-8")
    Path("class.csv").write_text("name,a\nAda,a = m g = 2mg/(2m+M)\nBob,g = 9.8\n", encoding="utf-8")
    command("class.csv", "-o", "report", "-f", "markdown")
    text = Path("report/summary.md").read_text(encoding="utf-8")
    looked_at = text.partition("To be looked at")[2]
    assert "is another value, but the answer is right" in looked_at and "can't decide on g = 9.8" in looked_at
