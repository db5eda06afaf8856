"""A phase that does without a connection does so up to its end, also where that is the last state, or where an event comes next."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G, H = 9.8, 1.4
SLIDES = """
title: down a rough slide, up a smooth one
given: {{m: 1 kg, R: 3 cm, h: 1.4 m}}
surfaces: {{rough: profile unknown, smooth: profile unknown}}
bodies: {{ball: {{shape: sphere, mass: m, radius: R, moves: right}}}}
connections: {{a: {{{first}: [ball, rough]}}, b: {{{last}: [ball, smooth]}}}}
states: {{start: {{ball.height: h, at rest: all}}, low: {{ball.height: 0}}, high: {{{line}}}}}
phases: {{down: {{from: start, to: low, without: b}}, up: {{from: low, to: high, without: a}}}}
find: {{v: ball.velocity at low, x: {asked} at high}}
"""


def number(text: str, name: str = "x") -> float:
    value = solve(text).answers[name].float
    assert value is not None
    return value


@pytest.mark.parametrize(
    ("line", "asked"), [("ball.velocity: 0", "ball.height"), ("ball.height: 0.5 m", "ball.velocity")]
)
@pytest.mark.parametrize(("first", "last"), [("rolls", "contact"), ("contact", "contact"), ("rolls", "rolls")])
def test_what_turns_goes_on_turning_on_the_smooth_slide(first: str, last: str, line: str, asked: str) -> None:
    text = SLIDES.format(first=first, last=last, line=line, asked=asked)
    square = 2 * G * H / (1.4 if first == "rolls" else 1.0)
    kept = 1.4 if last == "rolls" else 1.0  # of what goes up its turn goes with it, or stays
    expected = kept * square / (2 * G) if asked == "ball.height" else math.sqrt(square - 2 * G * 0.5 / kept)
    assert number(text, "v") == pytest.approx(math.sqrt(square), rel=1e-3)
    assert number(text) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("next_", ["", "after: {}"])
def test_a_spring_is_not_there_at_the_end_of_the_way_without_it(next_: str) -> None:
    event = "events: {hit: {joins: [b, o], from: near, to: after}}" if next_ else ""
    text = f"""
title: let go by a spring
surfaces: {{floor: level}}
bodies: {{b: {{mass: 2 kg, moves: right}}, o: {{mass: 3 kg, moves: right}}}}
connections: {{c: {{contact: [b, floor]}}, d: {{contact: [o, floor]}}, s: {{spring: [ground, b], stiffness: 100 N/m}}}}
states:
  go: {{s.elongation: -0.2 m, b.velocity: 0, o.velocity: 0}}
  free: {{b.displacement: 0.2 m}}
  near: {{b.displacement: 1 m}}
  {next_}
{event}
phases: {{push: {{from: go, to: free}}, later: {{from: free, to: near, without: s}}}}
find: {{v: b.velocity at near, x: b.acceleration at near}}
"""
    assert number(text, "v") == pytest.approx(math.sqrt(2.0))
    assert number(text) == 0.0


ROLLER = """
title: disc drawn by its centre
surfaces: {{floor: level}}
bodies: {{disc: {{shape: disc, mass: 1 kg, radius: 0.1 m, moves: right}}}}
connections: {{touch: {{rolls: [disc, floor]}}}}
actions: {{pull: {{force: 3 N, on: disc, direction: right}}}}
states: {{go: {{at rest: all}}, end: {{disc.displacement: 1 m}}}}
phases: {{way: {{from: go, to: end{without}}}}}
find: {{x: disc.velocity at end, w: disc.angular_velocity at end}}
"""


def test_a_roller_on_a_way_without_its_contact_does_not_turn() -> None:
    assert number(ROLLER.format(without="")) == pytest.approx(2.0)
    assert number(ROLLER.format(without=", without: touch")) == pytest.approx(math.sqrt(6.0), rel=1e-3)
    assert number(ROLLER.format(without=", without: touch"), "w") == 0.0


TIMES = """
title: on a spring at any time
surfaces: {{floor: level}}
bodies: {{b: {{mass: 2 kg, moves: right}}}}
connections: {{c: {{contact: [b, floor]}}, s: {{spring: [ground, b], stiffness: 100 N/m}}}}
states: {{start: {{s.elongation: 0.1 m, b.velocity: {speed} m/s}}{end}}}
find: {{x: {asked} at any time}}
"""


@pytest.mark.parametrize("asked", ["s.elongation", "b.velocity", "b.displacement", "s.force"])
@pytest.mark.parametrize("end", ["", ", end: {time: 2 s}"])
@pytest.mark.parametrize("speed", ["0", "0.5", "-0.5"])
def test_a_swing_at_any_time_is_refused_as_what_it_is(speed: str, end: str, asked: str) -> None:
    """Nothing is wrong with the scene: a time that is told comes."""
    with pytest.raises(Unsolvable, match="the motion of `b` as a function of time is not solved yet") as refused:
        solve(TIMES.format(speed=speed, end=end, asked=asked))
    assert refused.value.fault.span is not None


@pytest.mark.parametrize("speed", [0.4, 1.0, 1.7])
def test_how_long_a_bead_goes_inwards_in_a_driven_tube(speed: float) -> None:
    """r = r₁ cosh w t − (u/w) sinh w t, so that it comes to rest where tanh w t = u/(w r₁)."""
    text = f"""
title: bead in a driven tube
plane: horizontal
given: {{r1: 0.6 m, u: {speed} m/s, w: 3 rad/s, r: unknown}}
bodies: {{rod: {{shape: rod, mass: 1 kg, length: 1 m}}, bead: {{mass: 2 kg}}}}
connections: {{pin: {{hinge: rod.start, angular_velocity: w}}, track: {{rides: [bead, rod], friction: none}}}}
states:
  start: {{bead.radius: r1, bead.velocity.radial: -u}}
  near: {{bead.velocity.radial: 0, bead.radius: r}}
find: {{x: time from start to near}}
"""
    assert number(text) == pytest.approx(math.atanh(speed / 1.8) / 3, rel=1e-3)
