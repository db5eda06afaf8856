"""Keys of problems in space: every problem is on sheet and key in all formats, with the numbers of its solution, also in variants."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pages import ROOT
from rotsolve.arrays import single_answers
from rotsolve.confirm.verdicts import confirmations
from rotsolve.keys.command import KeyRequest, run_key
from rotsolve.keys.variants import worked_variants
from rotsolve.page.values import certified_digits, machine_number
from rotsolve.pipeline import made_ready
from rotsolve.scene.read import read_file
from solutions import solved

FILES = sorted((ROOT / "problems" / "space").glob("*.yaml"))
VARYING = [file for file in FILES if "\nvary:" in file.read_text("utf-8")]
PRINTED = ("html", "text", "markdown", "latex")
SUFFIXES = {"html": "html", "text": "txt", "markdown": "md", "latex": "tex"}
VARIANTS = 4


def told_numbers(answer: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The numbers of one answer of a key, of a vector those of its components."""
    if answer["value"] is None:
        yield from ((f"{answer['name']}.{part['name']}", part["value"]) for part in answer["components"])
    else:
        yield answer["name"], answer["value"]


def test_the_key_has_the_numbers_of_the_solutions_in_every_format(tmp_path: Path) -> None:
    some = FILES[::3]
    request = KeyRequest(tuple(map(str, some)), str(tmp_path), (*PRINTED, "json", "csv"), solutions=True)
    assert run_key(request) == 0
    (sheet,) = json.loads((tmp_path / "key.json").read_text("utf-8"))["sheets"]
    assert [item["problem"] for item in sheet["problems"]] == [file.stem for file in some]
    rows = list(csv.DictReader(io.StringIO((tmp_path / "key.csv").read_text("utf-8"), newline="")))
    for file, item in zip(some, sheet["problems"], strict=True):
        answers = {name: one for name, one in single_answers(solved(file).derivation.answers) if one.value is not None}
        expected = {name: machine_number(certified_digits(one.value, 4)[0]) for name, one in answers.items()}
        told = dict(entry for answer in item["answers"] if not answer["word"] for entry in told_numbers(answer))
        assert {name: told[name] for name in expected} == expected, file.stem
        listed = {row["answer"]: row["value"] for row in rows if row["problem"] == file.stem}
        assert {name: listed[name] for name in expected} == expected, file.stem
    for format in PRINTED:
        for page in ("sheet", "key", "solutions"):
            assert (tmp_path / f"{page}.{SUFFIXES[format]}").stat().st_size > 5_000


def test_six_problems_in_space_or_more_vary() -> None:
    assert len(VARYING) >= 6


@pytest.mark.parametrize("file", VARYING, ids=lambda file: file.stem)
def test_variants_in_space_are_those_of_their_numbers_and_confirmed(file: Path) -> None:
    """Each is the scene solved anew with its numbers, and the assembly in space gives the same."""
    problem = read_file(file)
    for variant, worked in worked_variants(problem, VARIANTS, seed=3):
        anew = dict(single_answers(solve_with(file, dict(variant.settings))))
        for name, one in single_answers(worked.answers):
            assert one.value is not None and anew[name].value is not None
            assert one.value.text(9) == anew[name].value.text(9), (variant.settings, name)
        whole = made_ready(worked.problem)[0].problem
        verdicts = confirmations(worked.answers, whole, worked.like.trace.letter, lambda _: True)
        assert [item.name for item in verdicts if item.holds] == [answer.name for answer in worked.answers]


def solve_with(file: Path, settings: dict[str, str]) -> tuple[Any, ...]:
    from rotsolve.pipeline import solve_problem

    return solve_problem(read_file(file, settings)).complete().derivation.answers


def test_a_changed_number_changes_the_key() -> None:
    """The variants of a problem differ in the answers that their letters are in."""
    found = [worked for _, worked in worked_variants(read_file(VARYING[0]), VARIANTS, seed=3)]
    forms = [dict(single_answers(worked.answers)) for worked in found]
    assert all(forms[0].keys() == other.keys() for other in forms)
    assert len({tuple(str(one.value and one.value.text(6)) for one in form.values()) for form in forms}) == VARIANTS
