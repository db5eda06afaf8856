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


PULLED = """title: what the motion of others tells
given: {m: 2 kg, M: 3 kg, mu: 0.2, R: 20 cm, u: 1 m/s}
surfaces: {t: level}
bodies:
  box: {mass: M, moves: right}
  w: {shape: disc, mass: 1 kg, radius: R, turns: TURN}
  load: {mass: m, moves: down}
connections: {c: {contact: [box, t], friction: mu}, ax: {axle: w}, s: {string: STRING}}
states: {start: {TOLD}}
find: {f: c.friction_force at start, a: box.acceleration at start}
"""


TOLD = [
    ("load.velocity: u", 1),
    ("load.velocity: -u", -1),
    ("w.angular_velocity: u/R", 1),
    ("w.angular_velocity: -u/R", -1),
    ("w.top.velocity: u", 1),
    ("box.velocity: -u", -1),
]


@pytest.mark.parametrize(
    ("told", "way", "side", "letters"),
    [  # each on both sides, once in letters, in turn on either side for both ways
        (*said, side, (place // 2 + at) % 2 == 0)
        for place, said in enumerate(TOLD)
        for at, side in enumerate(("right", "left"))
    ],
)
def test_friction_is_against_a_motion_that_others_tell(told: str, way: int, side: str, letters: bool) -> None:
    """A box on a table tied over a wheel to a load, on either side: M + m + ½ M_w times a is m g less way · μ M g."""
    string, turn = {"right": ("[box, w, load]", "clockwise"), "left": ("[load, w, box]", "counterclockwise")}[side]
    text = (
        PULLED.replace("STRING", string)
        .replace("TURN", turn)
        .replace("TOLD", told)
        .replace("moves: right", f"moves: {side}")
    )
    text = text.replace("u: 1 m/s", "u: m/s").replace("mu: 0.2", "mu: number") if letters else text
    solution = solve(text, confirm=False)
    answers = solution.answers
    back = {"right": "left", "left": "right"}[side]
    assert answers["f"].direction == (back if way > 0 else side)
    many = solution.evaluate_many({"mu": [0.2], "u": [1.0]}) if letters else {}
    value = many["a"][0] if letters else answers["a"].float
    assert value == pytest.approx((2 - way * 0.2 * 3) * 9.8 / (2 + 3 + 0.5))


@pytest.mark.parametrize(("spin", "word", "pull"), [(30, "right", 1), (-30, "left", -1), (5, "left", -1)])
def test_a_wheel_slips_as_its_centre_is_drawn_and_it_turns(spin: int, word: str, pull: int) -> None:
    """The lowest point of a cylinder drawn by a load goes on with u − R ω."""
    text = PULLED.replace("box: {mass: M", "box: {shape: cylinder, mass: M, radius: R").replace(
        "STRING", "[box.center, w, load]"
    )
    text = text.replace("TURN", "clockwise").replace("TOLD", f"load.velocity: 2*u, box.angular_velocity: {spin} rad/s")
    answers = solve(text).answers
    assert answers["f"].direction == word
    assert answers["a"].float == pytest.approx((2 + pull * 0.2 * 3) * 9.8 / (2 + 3 + 0.5))
