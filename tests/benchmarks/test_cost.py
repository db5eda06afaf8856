"""The benchmark of costs: scenes in space apart from those in the plane, and what a closed form of elliptic functions takes."""

from __future__ import annotations

from fractions import Fraction

import pytest

from cost import groups, page
from costs import in_space
from costs.in_space import closed_form, targets
from costs.processes import Ratios
from costs.tables import Part
from trials.case import given
from trials.families_in_space import thrown


def test_every_problem_is_in_the_plane_or_in_space() -> None:
    whole, few = groups(quick=False), groups(quick=True)
    assert not set(whole["in the plane"]) & set(whole["in space"])
    assert all(file.parent.name == "space" for file in whole["in space"])
    assert all(0 < len(few[group]) < len(files) for group, files in whole.items())


def test_the_closed_form_is_the_one_by_mpmath(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(in_space, "RUNS", 2)
    moments = tuple(given(Fraction(text), "kg m^2") for text in ("0.00121", "0.01638", "0.01748"))
    case = thrown(moments, given(Fraction(1, 5), "rad/s"), given(Fraction(12), "rad/s"), Fraction(1000))
    for name, text, took in closed_form():
        true = case.expected[name.replace("u", "w")]
        assert abs(float(text.replace("−", "-")) - float(true)) < 1e-13
        assert took > 0


def test_targets_speak_of_the_median_file_of_each_group() -> None:
    cold = {
        "in space": {name: Ratios(1, 1, ratio) for name, ratio in (("a", 0.4), ("b", 0.45), ("c", 2.0))},
        "in the plane": {"d": Ratios(1, 1, 0.36)},
    }
    found = targets(cold, 0.0008)
    assert [(target.reached, target.met) for target in found] == [("0.45", True), ("0.36", False), ("0.80", True)]
    text = page([Part("Scenes in space", "…", tuple(found))], "Cost in space", " --space")
    assert text.startswith("## Cost in space\n\n`python benchmarks/cost.py --space`")
