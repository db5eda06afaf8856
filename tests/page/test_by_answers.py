"""A long answer stands in later ones by its letter, on the page alone."""

from __future__ import annotations

from pathlib import Path

from rotsolve import solve

PROBLEM = Path(__file__).parents[2] / "problems" / "space" / "rod-falls-on-a-turning-shaft.yaml"


def text_of(scene: str) -> str:
    return solve(scene).to("text", width=200)


def test_a_later_answer_has_the_letter() -> None:
    told = text_of(PROBLEM.read_text(encoding="utf-8")).partition("Answers")[2]
    assert "F = √((3 I₀ (W² − w₀²)/(2 L)" in told
    assert "W = w₀ (3 I₀ + M L² cos² θ)/(3 I₀ + M L²)" in told


def test_an_answer_above_it_has_not() -> None:
    """Nothing stands by a letter that is told further down."""
    asked = "  W: shaft.angular_velocity.z at level\n"
    scene, _, _ = PROBLEM.read_text(encoding="utf-8").partition("answers:")
    told = text_of(scene.replace(asked, "") + asked).partition("Answers")[2]
    assert "W" not in told.partition("F = ")[2].partition("W = ")[0]


def test_programs_have_the_letters_of_the_scene() -> None:
    (force,) = [one for one in solve(PROBLEM.read_text(encoding="utf-8")).derivation.answers if one.name == "F"]
    assert force.closed is not None
    assert "W" not in force.closed.symbols()
