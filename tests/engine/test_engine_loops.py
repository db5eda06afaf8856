"""Over the highest place of a loop: what goes past it must still press there, also where no state of the scene is there."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8
LOOP = """
title: Over the highest place of a loop
given: {given}
surfaces: {{loop: {{hollow: R}}}}
bodies: {{ball: {body}}}
connections: {{touch: {touch}}}
states: {{low: {{touch.angle: {low} deg, ball.velocity: u}}, far: {{touch.angle: {far} deg}}}}
find: {{v: ball.speed at far, N: touch.normal_force at far}}
"""
BODIES = {  # the body, how it touches the loop, its 1 + I/(m r²), and how large it is
    "bead": ("{mass: 2 kg, moves: WAY}", "{contact: [ball, loop], friction: none}", 1.0, 0.0),
    "marble": ("{shape: sphere, mass: 2 kg, radius: 0.1 m, moves: WAY}", "{rolls: [ball, loop]}", 1.4, 0.1),
    "hoop": ("{shape: ring, mass: 2 kg, radius: 0.2 m, moves: WAY}", "{rolls: [ball, loop]}", 2.0, 0.2),
}
WAYS = [("right", -90, 130), ("right", -90, 180), ("right", -90, 250), ("left", -90, -310), ("left", 270, 0)]


def scene(kind: str, way: str, low: float, far: float, given: str) -> str:
    body, touch, _, _ = BODIES[kind]
    return LOOP.format(body=body.replace("WAY", way), touch=touch, low=low, far=far, given=given)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("kind", BODIES)
@pytest.mark.parametrize(("way", "low", "far"), WAYS)
def test_what_passes_the_highest_place_presses_there(kind: str, way: str, low: int, far: int) -> None:
    """Of κ = 1 + I/(m r²): u² ≥ (1 + 4/κ) g ρ on the circle ρ of its centre; with less it falls off on the way."""
    _, _, share, size = BODIES[kind]
    radius = 1.0 - size
    least = math.sqrt((1 + 4 / share) * G * radius)
    for part in (1.05, 0.95):
        text = scene(kind, way, low, far, f"{{R: 1 m, u: {part * least} m/s}}")
        if part < 1.0:
            with pytest.raises(Unsolvable, match=r"lets go|contradicts"):
                solve(text)
            continue
        found = solve(text)
        high = radius * (1 + math.sin(math.radians(far)))
        square = (part * least) ** 2 - 2 * G * high / share
        press = 2 * (square / radius - G * math.sin(math.radians(far)))
        assert found.answers["v"].float == pytest.approx(math.sqrt(square))
        assert found.answers["N"].float == pytest.approx(press)
        assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("kind", BODIES)
@pytest.mark.parametrize("way", ["right", "left"])
def test_in_letters_that_is_a_condition(kind: str, way: str) -> None:
    low, far = (-90, 200) if way == "right" else (270, -20)
    found = solve(scene(kind, way, low, far, "{R: m, u: m/s}"), confirm=False)
    _, _, share, size = BODIES[kind]
    limit = math.sqrt((1 + 4 / share) * G * (1 - size))
    (one,) = [case for case in (found.derivation.answers[0], *found.derivation.answers[0].otherwise) if case.conditions]
    from rotsolve.confirm.course.samples import holds

    for part in (0.8, 0.99, 1.01, 3.0):
        numbers = {"R": 1.0, "u": part * limit, "g": G, "R_ball": size}
        assert all(holds(condition, numbers) for condition in one.conditions) == (part > 1), part


def test_what_turns_back_below_the_highest_place_is_not_asked_to_pass_it() -> None:
    found = solve(scene("bead", "right", -90, -10, "{R: 1 m, u: 5 m/s}"))
    assert [state.name for state in found.problem.states] == ["low", "far"]
    assert found.answers["v"].float == pytest.approx(math.sqrt(25 - 2 * G * (1 + math.sin(math.radians(-10)))))


def test_from_a_slide_it_takes_more_than_to_be_as_high() -> None:
    """A bead let go at h on a track of any form passes the loop's highest place where R ≤ 2 h/5, not already where R < h/2."""
    found = solve("""
title: Down a slide and once round a loop
given: {R: m, h: m}
surfaces: {slide: profile unknown, loop: {hollow: R}}
bodies: {bead: {mass: 2 kg, moves: right}}
connections: {touch: {contact: [bead, slide, loop], friction: none}}
states: {start: {bead.height: h, at rest: all}, low: {touch.angle: -90 deg}, again: {touch.angle: 270 deg}}
find: {v: bead.velocity at again}
""")
    from rotsolve.confirm.course.samples import holds

    for height, passes in ((2.6, True), (2.4, False), (2.1, False), (1.9, False)):
        cases = [found.derivation.answers[0], *found.derivation.answers[0].otherwise]
        numbers = {"R": 1.0, "h": height, "g": G}
        assert any(all(holds(line, numbers) for line in case.conditions) for case in cases) == passes, height


SLIDE = """
title: Down a slide, and to a place in a loop
given: {{R: 40 cm, h: {height} m}}
surfaces: {{slide: profile unknown, loop: {{hollow: R}}}}
bodies: {{block: {{mass: 50 g, moves: {way}}}}}
connections: {{touch: {{contact: [block, slide, loop], friction: none}}}}
states: {{start: {{block.height: h, at rest: all}}, far: {{touch.angle: {far}}}}}
find: {{v: block.velocity at far}}
"""
FAR = [  # the place, how it moves, whether it has passed the highest place
    ("180 deg", "right", True),
    ("100 deg", "right", True),
    ("270 deg", "right", True),
    ("-180 deg", "right", True),
    ("630 deg", "right", True),
    ("0 deg", "left", True),
    ("-360 deg", "left", True),
    ("-90 deg", "right", False),
    ("270 deg", "left", False),
    ("-90 deg", "left", False),
    ("180 deg", "left", False),
    ("-180 deg", "left", False),
    ("0 deg", "right", False),
]


@pytest.mark.parametrize(("far", "way", "passes"), FAR)
def test_from_a_slide_the_highest_place_is_passed_where_no_state_is_there(far: str, way: str, passes: bool) -> None:
    """With h = 2.2 R it falls off at sin φ = 4/5, 53° above the middle; with 2.6 R it does not."""
    for height, holds in ((0.88, not passes), (1.04, True)):
        found = solve(SLIDE.format(height=height, far=far, way=way))
        failed = [check for check in found.derivation.checks if check.holds is False]
        assert (not failed) == holds, (height, failed)


def test_whether_a_place_in_letters_is_beyond_the_highest_one_is_not_decided() -> None:
    text = SLIDE.format(height=0.88, far="a", way="right").replace("h: 0.88 m", "h: 0.88 m, a: deg")
    found = solve(text)
    said = " ".join(str(check) for check in found.derivation.checks if check.holds is None)
    assert "leaves the surface" in said


TWO = """
title: Down one track and on along another surface
given: {{m: 1 kg, h: 1.4 m}}
surfaces: {{slide: profile unknown, other: {other}}}
bodies: {{ball: {{mass: m, moves: right}}}}
connections: {{a: {{contact: [ball, slide], friction: none}}, b: {{contact: [ball, other], friction: {friction}}}}}
{phases}
states: {{start: {{ball.height: h, at rest: all}}, low: {{ball.height: 0}}, end: {{ball.{end}}}}}
find: {{v: ball.velocity at low}}
"""
PHASES = "phases: {down: {from: start, to: low, without: b}, further: {from: low, to: end, without: a}}"


@pytest.mark.parametrize(
    ("other", "friction", "end"), [("profile unknown", "none", "height: 0.5 m"), ("level", "0.3", "velocity: 0")]
)
def test_what_is_on_two_tracks_at_once_is_refused(other: str, friction: str, end: str) -> None:
    text = TWO.format(other=other, friction=friction, end=end, phases="")
    with pytest.raises(Unsolvable, match="on `slide` and on `other` at once") as refused:
        solve(text)
    assert "without: b" in refused.value.fault.help
    found = solve(TWO.format(other=other, friction=friction, end=end, phases=PHASES))
    assert found.answers["v"].float == pytest.approx(math.sqrt(2 * G * 1.4))


def test_how_high_something_is_on_a_track_stays_through_an_event() -> None:
    """A string is cut while the ball is 30 cm high; it goes on up to where it was let go."""
    found = solve("""
title: Down a track, while something else is cut loose
given: {m: 1 kg, h: 1.4 m}
surfaces: {slide: profile unknown}
bodies: {ball: {mass: m, moves: right}, lamp: {mass: 2 kg, moves: down}}
connections: {a: {contact: [ball, slide], friction: none}, cord: {string: [ceiling, lamp]}}
states: {start: {ball.height: h, at rest: all}, mid: {ball.height: 0.3 m}, then: {}, high: {ball.velocity: 0}}
events: {snap: {cuts: cord, from: mid, to: then}}
find: {y: ball.height at high, z: ball.height at then}
""")
    assert found.answers["y"].float == pytest.approx(1.4)
    assert found.answers["z"].float == pytest.approx(0.3)
