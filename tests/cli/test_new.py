"""`rotsolve new`: every kind of scene to start from is read, fits the schema, is solved and confirmed; no file is written over unasked."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml

import rotsolve as package
from rotsolve.scene.schema import json_schema
from rotsolve.templates import template, template_kinds

Run = Callable[..., Any]
KINDS = template_kinds()


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_is_solved_and_confirmed(kind: str) -> None:
    text = template(kind)
    jsonschema.Draft202012Validator(json_schema()).validate(yaml.load(text, yaml.BaseLoader))
    solution = package.solve(text)
    assert not solution.refused and solution.answers
    assert [item.name for item in solution.derivation.confirmed if item.holds is not True] == []
    assert [check.words for check in solution.derivation.checks if check.holds is not True] == []


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_says_what_it_is_and_how_to_go_on(kind: str) -> None:
    text = template(kind)
    assert KINDS[kind] and text.startswith("# ") and text.isascii() and text.endswith("\n")
    assert max(map(len, text.splitlines())) <= 120


def test_the_kinds_are_listed(rotsolve: Run) -> None:
    ran = rotsolve("new")
    assert (ran.code, ran.err) == (0, "")
    assert [line.split()[0] for line in ran.out.splitlines()] == list(KINDS)
    assert len(KINDS) >= 20 and {
        "pulley",
        "incline",
        "rolling",
        "hinged-rod",
        "collision",
        "top",
        "swing",
        "ladder",
    } <= {*KINDS}


def test_a_kind_is_written_and_never_over_another_file(
    rotsolve: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = rotsolve("new", "rolling")
    assert (ran.code, ran.out) == (0, "rolling.yaml is written; solve it with: rotsolve solve rolling.yaml\n")
    assert Path("rolling.yaml").read_text(encoding="utf-8") == template("rolling")
    Path("rolling.yaml").write_text("mine", encoding="utf-8")
    ran = rotsolve("new", "rolling")
    assert (ran.code, ran.out) == (2, "")
    assert (
        ran.err
        == "error: rolling.yaml is there already\nhelp: name another file with -o, or write over it with --force\n"
    )
    assert Path("rolling.yaml").read_text(encoding="utf-8") == "mine"
    assert rotsolve("new", "rolling", "--force").code == 0
    assert Path("rolling.yaml").read_text(encoding="utf-8") == template("rolling")
    assert rotsolve("new", "top", "-o", "mine.yaml").code == 0 and Path("mine.yaml").is_file()
    assert rotsolve("new", "top", "-o", ".", "--force").code == 2
    assert rotsolve("new", "top", "-o", "nowhere/top.yaml").code == 2


def test_a_kind_goes_to_standard_output(rotsolve: Run) -> None:
    ran = rotsolve("new", "rolling", "-o", "-")
    assert (ran.code, ran.out, ran.err) == (0, template("rolling"), "")


@pytest.mark.parametrize("kind", ["rolin", "../rolling", "rolling.yaml", ""])
def test_an_unknown_kind_is_told_the_nearest(rotsolve: Run, kind: str) -> None:
    ran = rotsolve("new", kind)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"error: unknown kind `{kind}`; ") and ", rolling, " in ran.err
    assert ("did you mean `rolling`?" in ran.err) == bool(kind)


def test_a_file_needs_a_kind(rotsolve: Run) -> None:
    assert rotsolve("new", "-o", "x.yaml").code == 2
