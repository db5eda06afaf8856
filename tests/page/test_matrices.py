"""Matrices and vectors: one pair of brackets in text, one pmatrix in Markdown and LaTeX, rows of names in JSON."""

from __future__ import annotations

import json

import pytest

from rotsolve.pipeline import solve
from rotsolve.solution import Solution

SCENE = """
title: A plate and a particle above it
given: {M: 3 kg, a: 40 cm, b: 30 cm, m: 1 kg, h: 20 cm}
bodies:
  body:
    parts:
      plate: {shape: rectangle, mass: M, sides: [a, b]}
      bead: {mass: m, at: [a, 0, h]}
find: {T: body.inertia_tensor about body.center, c: body.cm}
"""


@pytest.fixture(scope="module")
def solution() -> Solution:
    return solve(SCENE)


def test_text_sets_a_matrix_with_its_numbers_beside_it(solution: Solution) -> None:
    text = solution.to("text", width=120)
    assert "T = ⎢ 0" in text
    assert "⎡ 0.0625   0      −0.08  ⎤" in text
    assert "⎢ 0        0.24   0      ⎥ kg m²" in text
    assert "⎣ −0.08    0      0.2225 ⎦" in text
    assert "T_zx = −m a h" in text
    assert "c = (m a/(M + m), 0, m h/(M + m))" in text
    assert "= (0.1, 0, 0.05) m" in text


@pytest.mark.parametrize("form", ["markdown", "latex"])
def test_markdown_and_latex_set_a_pmatrix(solution: Solution, form: str) -> None:
    text = solution.to(form)
    assert text.count(r"\begin{pmatrix}") == text.count(r"\end{pmatrix}") == 4
    assert r"0.0625 & 0 & -0.08 \\" in text.replace("−", "-")


def test_json_names_the_entries_row_by_row(solution: Solution) -> None:
    tensor, centre = json.loads(solution.to("json"))["answers"]
    assert tensor["rows"] == [["xx", "xy", "zx"], ["xy", "yy", "yz"], ["zx", "yz", "zz"]]
    assert {part["name"]: part["value"] for part in tensor["components"]}["zx"] == "-0.08"
    assert centre["rows"] == [["x", "y", "z"]]


def test_python_has_the_entries_by_name(solution: Solution) -> None:
    assert solution.answers["T"].components["zx"].float == pytest.approx(-0.08)
    assert solution.answers["c"].components["z"].exact == "m h/(M + m)"


def test_what_symmetry_says_is_said(solution: Solution) -> None:
    ball = solve(
        SCENE.replace("T: body.inertia_tensor about body.center, c: body.cm", "T: ball.inertia_tensor").replace(
            "bodies:", "bodies:\n  ball: {shape: sphere, mass: M, radius: a}"
        )
    )
    assert "by symmetry I_xx = I_yy = I_zz, and the products of inertia vanish" in ball.to("text")
