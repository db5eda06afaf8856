"""What rubs is decided in the open: the trials are data of the derivation, and look at one scene."""

from __future__ import annotations

from pathlib import Path

import pytest

from rotsolve import solve
from rotsolve.core.derivation import Trial
from rotsolve.equations.states import Statements

HERE = Path(__file__).parent / "scenes"
PROBLEMS = HERE.parent.parent.parent / "problems"


def trials(path: Path) -> tuple[Trial, ...]:
    return solve(path).derivation.trials


def test_each_way_in_which_two_rubs_may_move_is_a_trial() -> None:
    """A block on a block on a slope: both stick, one slips, the other does, until one way can be."""
    made = trials(HERE / "contact-stack-on-slope.yaml")
    assert [trial.supposed for trial in made] == [
        (("base", "sticks"), ("grip", "sticks")),
        (("base", "sticks"), ("grip", "slips")),
        (("base", "sticks"), ("grip", "slips back")),
        (("base", "slips"), ("grip", "sticks")),
    ]
    assert [trial.holds for trial in made] == [False, False, False, True]
    assert [trial.why for trial in made] == [
        "base lacks friction",
        "base lacks friction",
        "base lacks friction",
        "what sticks has friction enough, and what slips speeds up that way",
    ]
    assert all(trial.found for trial in made)


def test_a_contact_that_can_not_stick_says_what_it_would_take() -> None:
    made = trials(PROBLEMS / "pulleys" / "table-block.yaml")
    assert [(trial.supposed, trial.holds, trial.why) for trial in made] == [
        ((("base", "sticks"),), False, "more than the contact can give")
    ]
    assert [words[0] for words in made[0].found] == ["friction needed: ", "friction at most: "]


def test_what_moves_both_ways_round_is_tried_both_ways() -> None:
    made = trials(HERE / "clutch-plates-weak.yaml")
    assert [(trial.supposed[0][1], trial.holds) for trial in made] == [("slips", False), ("slips back", True)]


def test_a_scene_without_rubs_has_no_trials() -> None:
    assert trials(PROBLEMS / "pulleys" / "block-on-disc.yaml") == ()


def test_all_trials_share_what_the_states_say(monkeypatch: pytest.MonkeyPatch) -> None:
    taken: list[int] = []
    real = Statements.take
    monkeypatch.setattr(Statements, "take", lambda self: taken.append(1) or real(self))
    assert len(trials(HERE / "contact-stack-on-slope.yaml")) == 4
    assert len(taken) == 1
