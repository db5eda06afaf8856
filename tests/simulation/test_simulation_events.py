"""What happens on the way of a simulated motion: stops, stick and slip, slack strings, surfaces that are left, states that are reached."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from rotsolve import Unsolvable, simulate
from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.simulation.report import run_lines
from scenes import DRIVEN_PULLEY, PENDULUM, SHAKEN, SLIDING, TWO_RODS

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"


def test_a_thrown_block_stops_and_stays() -> None:
    run = simulate(SLIDING, 5)
    (stop,) = run.events
    assert stop.what == "base: slipping ends"
    assert abs(stop.time - 4 / (0.25 * 9.8)) <= stop.bound
    value, bound = run.at(5)["block.position"]
    assert abs(value - 16 / (2 * 0.25 * 9.8)) <= bound + 1e-15
    assert run.at(5)["block.velocity"] == (0.0, 0.0)


def test_a_state_is_reached_at_the_moment_at_which_slipping_ends() -> None:
    """What happens at once is told together, and the block stays where it stops."""
    scene = SLIDING.replace(
        "{thrown: {block.velocity: v}}", "{thrown: {block.velocity: v}, still: {block.velocity: 0}}"
    )
    run = simulate(scene, 5)
    assert {event.state or event.what for event in run.events} == {"base: slipping ends", "still"}
    assert run.events[0].time == run.events[1].time
    assert run.at(5)["block.velocity"] == (0.0, 0.0)


def test_a_block_that_is_shaken_sticks_and_slips() -> None:
    """It lets go where F sin ω t = μₛ m g; v = F/(m ω) (cos ω t₀ − cos ω t) − μ g (t − t₀) tells where it stops."""
    run = simulate(SHAKEN, 2)
    slip, stop, again = run.events[:3]
    first = math.asin(0.4 * 2 * 9.8 / 12) / 3
    assert slip.what == "base begins to slip" and abs(slip.time - first) <= slip.bound + 1e-16

    def speed(t: float) -> float:
        return 12 / (2 * 3) * (math.cos(3 * first) - math.cos(3 * t)) - 0.3 * 9.8 * (t - first)

    assert stop.what == "base: slipping ends" and abs(speed(stop.time)) < 1e-13
    assert abs(again.time - (math.pi / 3 + first)) <= again.bound + 4e-16
    at_rest = run.at((stop.time + again.time) / 2)
    assert at_rest["block.velocity"] == (0.0, 0.0)
    assert "base.friction_force" in at_rest


def test_a_pulley_on_a_rubbing_axle_turns_to_and_fro() -> None:
    run = simulate(DRIVEN_PULLEY, 10)
    first = run.events[0]
    assert first.what == "pulley begins to turn"
    assert abs(first.time - math.asin(1 / (12 * 0.2)) / 2) <= first.bound + 1e-16
    assert {event.what for event in run.events} == {"pulley begins to turn", "pulley comes to rest"}
    assert run.drift.energy is not None and run.drift.energy < 1e-9


def test_a_state_is_reached_and_its_time_told() -> None:
    run = simulate(PROBLEMS / "hinged" / "rod-30.yaml", 1)
    (lowest,) = run.events
    assert lowest.state == "lowest"
    speed, bound = run.at(lowest.time)["rod.angular_velocity"]
    assert abs(speed + math.sqrt(3 * 9.8 * 1.5)) <= bound + 1e-14


@pytest.mark.parametrize(
    ("file", "what", "time"),
    [
        ("varying-forces/drum-rope-goes-slack", "the string goes slack", 0.5 * 9.8 / (3 * 0.2)),
        ("pulleys/chain-off-table", "the rope's other end has run off", None),
        ("rolling/block-off-dome", "block leaves the surface", None),
        ("hinged/ladder-leaves-wall", "ladder leaves the surface", None),
    ],
)
def test_what_ends_a_motion_is_said(file: str, what: str, time: float | None) -> None:
    run = simulate(PROBLEMS / f"{file}.yaml", 20)
    assert what in [event.what for event in run.events] and run.ended.startswith(what)
    assert run.end == run.events[-1].time
    assert time is None or abs(run.end - time) <= run.events[-1].bound + 1e-15
    with pytest.raises(ValueError, match="was followed from 0 to"):
        run.at(20)


def test_a_ladder_leaves_the_wall_at_two_thirds_of_its_height() -> None:
    run = simulate(PROBLEMS / "hinged" / "ladder-leaves-wall.yaml", 5)
    start, end = (math.sin(run.at(time)["ladder.angle"][0]) for time in (0, run.end))
    assert abs(end / start - 2 / 3) < 1e-12


def test_a_block_leaves_a_dome_where_its_weight_no_longer_bends_its_way() -> None:
    """m g sin φ = m v²/R and v² = u² + 2 g R (1 − sin φ): sin φ = 2/3 + u²/(3 g R)."""
    run = simulate(PROBLEMS / "rolling" / "block-off-dome.yaml", 5)
    angle, bound = run.at(run.end)["touch.angle"]
    late = run.events[-1].bound * run.at(run.end)["block.velocity"][0] / 3
    assert abs(math.sin(angle) - (2 / 3 + 2**2 / (3 * 9.8 * 3))) <= bound + late + 1e-15


def test_two_rods_end_where_a_far_finer_run_ends() -> None:
    run, fine = simulate(TWO_RODS, 10, 1e-8), simulate(TWO_RODS, 10, 1e-14)
    exact = fine.at(10)
    for name, (value, bound) in run.at(10).items():
        assert abs(value - exact[name][0]) <= bound + exact[name][1]
    assert max(bound for name, (_, bound) in run.at(10).items() if name.endswith(".angle")) < 1e-8


def test_what_can_not_be_simulated_is_refused_by_name() -> None:
    with pytest.raises(Unsolvable, match="`omega` has no number"):
        simulate(PROBLEMS / "hinged" / "conical-pendulum.yaml")
    with pytest.raises(Unsolvable, match="`carpet` changes on the way: not simulated yet"):
        simulate(PROBLEMS / "rolling" / "carpet-unrolls.yaml")
    with pytest.raises(Unsolvable, match="a motion is followed from t = 0 on"):
        simulate(DRIVEN_PULLEY.replace("start: at rest", "start: {time: 2 s, at rest: all}"), 1)
    with pytest.raises(Unsolvable, match="the angle of `rod` at first is not told"):
        simulate(PROBLEMS / "swings" / "swinging-rod.yaml")


@pytest.mark.parametrize(("until", "accuracy"), [(0, 1e-9), (-1, 1e-9), (math.inf, 1e-9), ("3 kg", 1e-9), (1, 0.5)])
def test_a_time_or_accuracy_that_is_none_is_refused(until: str | float, accuracy: float) -> None:
    with pytest.raises(ValueError):
        simulate(PENDULUM.format(angle="0 deg"), until, accuracy)


@pytest.mark.parametrize("accuracy", [1e-3, 1e-5, 1e-6, 1e-9, 1e-14, 1e-20])
def test_what_comes_to_rest_stays_at_any_accuracy(accuracy: float) -> None:
    """Its speed at that moment is 0 up to what the steps leave out, which must not pass for slipping on."""
    run = simulate(PROBLEMS / "rolling" / "bowling-ball.yaml", 3, accuracy)
    speed, bound = run.at(3)["ball.velocity"]
    assert abs(speed - 5 * 8.5 / 7) <= bound + 1e-15
    assert len(simulate(DRIVEN_PULLEY, 10, accuracy).events) == len(simulate(DRIVEN_PULLEY, 10, 1e-9).events)


def test_numbers_beyond_floats_hold_what_follows_from_the_state() -> None:
    """α = −3 g cos θ₀/(2 L) at release, from constants that are no floats."""
    run = simulate(PROBLEMS / "hinged" / "rod-30.yaml", 1, 1e-20)
    ball = run.balls(0.0)["rod.angular_acceleration"]
    with Precision(200):
        assert ball.contains(-arb(147) / 10 * (arb(3).sqrt() / 2)) and ball.rad() < 1e-20


def test_what_stands_says_so() -> None:
    run = simulate(PROBLEMS / "inside-a-body" / "falling-chimney.yaml", 2)
    assert "where nothing pushes it" in " ".join(line.text for line in run_lines(run, 120))


def test_states_that_are_not_reached_are_named() -> None:
    early, late = (simulate(PROBLEMS / "hinged" / "rod-30.yaml", until) for until in (0.1, 1))
    assert (early.unreached, late.unreached) == (("lowest",), ())
    assert "Not reached by t = 0.1 s: `lowest`." in str(early) and "Not reached" not in str(late)
    assert "Nothing moves" not in str(early)
    assert repr(late).startswith("<Run of “Rod released from an angle”: 0 to 1 s, 1 event;")
