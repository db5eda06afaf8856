"""Friction that reverses where what swings turns back: half swing by half swing, against the closed form of each, until it is held."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8


def values(text: str) -> dict[str, float]:
    """The answers of a scene, all of them confirmed."""
    solution = solve("title: by hand\n" + text)
    assert not solution.refused
    assert all(item.holds for item in solution.derivation.confirmed)
    assert not [check for check in solution.derivation.checks if check.holds is None]
    found = {name: answer.float for name, answer in solution.answers.items()}
    return {name: number for name, number in found.items() if number is not None}


def swung(place: float, speed: float, rate: float, slips: float, holds: float, until: float) -> tuple[float, float]:
    """Place and speed of x'' = −rate² (x ± slips) after a time, half swing by half swing; at rest where |x| ≤ holds."""
    if not speed and abs(place) <= holds:
        return place, 0.0
    if speed > 0 or (not speed and place < 0):
        mirrored = swung(-place, -speed, rate, slips, holds, until)
        return -mirrored[0], -mirrored[1]
    phase = math.atan2(-speed / rate, place - slips)  # it goes down about the place `slips`, and turns at a phase of π
    width, left = math.hypot(place - slips, speed / rate), (math.pi - phase) / rate
    if left >= until:
        angle = phase + rate * until
        return slips + width * math.cos(angle), -width * rate * math.sin(angle)
    return swung(slips - width, 0.0, rate, slips, holds, until - left)


WHEEL = """
bodies: {wheel: {inertia: 0.2 kg m^2%s}}
connections: {axle: {axle: wheel, friction_torque: 0.8 N m}, wire: {torsion: wheel, stiffness: 3 N m/rad}}
states: {start: {wheel.angle: %s rad, at rest: all}, end: {time: %s s}}
find: {th: wheel.angle at end, w: wheel.angular_velocity at end}
"""


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    ("angle", "until", "turns"),
    [
        (2.2, 0.7, ", turns: clockwise"),
        (2.2, 1.3, ""),
        (-2.2, 1.3, ", turns: clockwise"),
        (-1.0, 1.2, ""),
        (2.2, 10.0, ", turns: clockwise"),
        (0.2, 3.0, ""),
    ],
)
def test_a_wheel_on_a_torsion_wire_with_friction_in_its_axle(angle: float, until: float, turns: str) -> None:
    found = values(WHEEL % (turns, angle, until))
    expected = swung(angle, 0.0, math.sqrt(3 / 0.2), 0.8 / 3, 0.8 / 3, until)
    sign = -1 if turns else 1
    assert (found["th"], sign * found["w"]) == pytest.approx(expected, abs=1e-9)


BLOCK = """
given: {m: 1 kg, k: 100 N/m, mus: 0.6, muk: 0.4}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: %s}}
connections: {base: {contact: [block, floor], friction: {static: mus, kinetic: muk}}, coil: {spring: [ground, block], stiffness: k}}
states: {start: {coil.elongation: %s cm, block.velocity: %s m/s}, end: {time: %s s}}
find: {x: coil.elongation at end, v: block.velocity at end}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("stretch", "speed", "until", "moves"),
    [(30, 0, 0.7, "right"), (30, 0, 2.0, "left"), (0, 3, 0.4, "left"), (0, 3, 0.1, "right")],
)
def test_a_block_on_a_spring_on_a_rough_floor(stretch: float, speed: float, until: float, moves: str) -> None:
    sign = 1 if moves == "right" else -1
    found = values(BLOCK % (moves, stretch, sign * speed, until))
    expected = swung(stretch / 100, speed, 10.0, 0.4 * G / 100, 0.6 * G / 100, until)
    assert (found["x"], sign * found["v"]) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("until", [0.3, 1.5, 8.0])
def test_a_wheel_that_is_thrown_against_a_couple_that_grows_with_its_rotation(until: float) -> None:
    found = values(f"""
bodies: {{wheel: {{inertia: 0.5 kg m^2}}}}
connections: {{axle: {{axle: wheel, friction_torque: 1 N m}}}}
actions: {{back: {{couple: -2 N m*wheel.rotation, on: wheel}}}}
states: {{start: {{wheel.angular_velocity: 4 rad/s}}, end: {{time: {until} s}}}}
find: {{w: wheel.angular_velocity at end, phi: wheel.rotation from start to end}}
""")
    assert (found["phi"], found["w"]) == pytest.approx(swung(0.0, 4.0, 2.0, 0.5, 0.5, until), abs=1e-9)


def test_turning_points_that_the_scene_names_are_the_same() -> None:
    """Each half swing takes π √(I/k), and 2 τ/k off the width."""
    text = WHEEL % ("", 2.2, 0.3)
    text = text.replace("end: {", "one: {wheel.angular_velocity: 0}, two: {wheel.angular_velocity: 0}, end: {")
    found = values(text.replace("find: {", "find: {t: time from one to two, a: wheel.angle at two, "))
    assert found["t"] == pytest.approx(math.pi * math.sqrt(0.2 / 3))
    assert found["a"] == pytest.approx(2.2 - 4 * 0.8 / 3)
    assert found["th"] == pytest.approx(swung(found["a"], 0.0, math.sqrt(3 / 0.2), 0.8 / 3, 0.8 / 3, 0.3)[0])


LETTERS = """
title: letters
given: {I: kg m^2, k: N m/rad, tau: N m, T: s, th0: rad}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel, friction_torque: tau}, wire: {torsion: wheel, stiffness: k}}
states: {start: {wheel.angle: th0, at rest: all}, end: {time: T}}
find: {th: wheel.angle at end}
"""


def test_letters_tell_the_first_half_swing_and_refuse_the_others_by_name() -> None:
    solution = solve(LETTERS)
    answer = solution.answers["th"]
    found = [[str(line) for line in case.conditions] for case in (answer, *answer.otherwise)]
    assert sorted(found) == [["τ > k th₀"], ["τ ≤ k th₀", "T ≤ π √(I/k)"]]
    said = " ".join(str(word) for check in solution.derivation.checks if check.holds is None for word in check.words)
    assert "wheel turns back, and its friction with it" in said


BACK = """title: up and back
given: {u: 2 m/s, beta: 30 deg, R: 10 cm}
surfaces: {ramp: {slope: beta, down: DOWN}}
bodies: {body: {SHAPE, mass: 1 kg, moves: WAY}}
connections: {base: {TOUCH: [body, ramp]}}
states: {start: {body.velocity: SPEED}, end: {body.displacement: 0}}
find: {QUESTION}
"""


@pytest.mark.parametrize("down", ["left", "right"])
@pytest.mark.parametrize(("way", "speed"), [("up", "u"), ("down", "-u")])
@pytest.mark.parametrize(
    ("shape", "touch", "share"), [("shape: sphere, radius: R", "rolls", 7 / 5), ("", "contact", 1)]
)
def test_what_comes_back_to_where_it_was_goes_the_other_way(
    shape: str, touch: str, share: float, way: str, speed: str, down: str
) -> None:
    """Up and down again: twice u²/(2 a) with a = g sin β less the share of the rolling, in 2 u/a; also where the way alone is asked."""
    text = BACK.replace("SHAPE, ", f"{shape}, " if shape else "").replace("TOUCH", touch)
    text = text.replace("WAY", way).replace("SPEED", speed).replace("DOWN", down)
    a = 9.8 / 2 / share
    for question, value in (
        ("d: body.distance", 4 / a),
        ("t: time from start to end", 4 / a),
        ("v: body.speed at end", 2),
    ):
        asked = text.replace("QUESTION", f"{question} from start to end" if "distance" in question else question)
        assert next(iter(solve(asked).answers.values())).float == pytest.approx(value)
    letters = text.replace("u: 2 m/s", "u: m/s").replace("QUESTION", "d: body.distance from start to end")
    way_there_and_back = "u²/(g sin β)" if touch == "contact" else "7 u²/(5 g sin β)"
    assert solve(letters).answers["d"].exact == way_there_and_back


PASSING = """title: past the rest place of a spring, on a rough floor, and back
given: {m: 1 kg, k: 10 N/m, u: SPEED, mu: 0.5}
surfaces: {floor: level}
bodies: {box: {mass: m, moves: WAY}}
connections: {base: {contact: [box, floor], friction: mu}, coil: {spring: [ground, box], stiffness: k}}
states: {start: {coil.elongation: 0, box.velocity: u}, far: {box.velocity: 0}, back: {coil.elongation: 0}}
find: {QUESTION}
"""
THERE = {"x": "box.displacement from start to far", "v": "box.speed at back", "Q": "base.work from start to back"}


def there_and_back(speed: float) -> dict[str, float] | None:
    """½ m u² = ½ k x² + μ m g x; back ½ m v² = ½ k x² − μ m g x, if that is positive and k x > μ m g."""
    x = (-4.9 + math.sqrt(4.9**2 + 10 * speed**2)) / 10
    left = 5 * x**2 - 4.9 * x
    return None if left <= 0 else {"x": x, "v": math.sqrt(2 * left), "Q": -2 * 4.9 * x}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("way", ["right", "left"])
@pytest.mark.parametrize("name", THERE)
@pytest.mark.parametrize("speed", [0.2, 3.5, 6.0])
def test_what_friction_holds_where_it_turns_back_comes_to_no_other_place(speed: float, name: str, way: str) -> None:
    """Held at `far`, or on its way back: then `back` is never reached, and no answer speaks of it; what is asked of `far` stands."""
    text = PASSING.replace("WAY", way).replace("SPEED", f"{speed} m/s").replace("QUESTION", f"{name}: {THERE[name]}")
    true = there_and_back(speed)
    if true is None and name == "x":
        found = solve(text)
        assert found.answers["x"].float == pytest.approx((-4.9 + math.sqrt(4.9**2 + 10 * speed**2)) / 10)
        assert any(check.holds is False and "never reached" in str(check.words) for check in found.checks)
    elif true is None:
        with pytest.raises(Unsolvable, match="is never reached"):
            solve(text)
    else:
        assert solve(text, confirm=False).answers[name].float == pytest.approx(true[name])


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", THERE)
def test_in_letters_it_comes_back_under_conditions(name: str) -> None:
    """Only the case in which it passes again has answers, whatever is asked; numbers on either side of it agree with that."""
    solution = solve(
        PASSING.replace("WAY", "right").replace("SPEED", "m/s").replace("QUESTION", f"{name}: {THERE[name]}"),
        confirm=False,
    )
    speeds = [0.2, 2.0, 3.5, 6.0]
    for speed, found in zip(speeds, solution.evaluate_many({"u": speeds})[name], strict=True):
        true = there_and_back(speed)
        if true is None and name == "x":  # the way to `far` is there, whether it comes back or not
            assert found == pytest.approx((-4.9 + math.sqrt(4.9**2 + 10 * speed**2)) / 10)
        else:
            assert math.isnan(found) if true is None else found == pytest.approx(true[name])


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_what_comes_back_from_a_speed_that_is_sought_is_asked_where_it_turns(turns: str) -> None:
    """A wheel with friction that a couple turns back: W = -τ φ would be that of a wheel that had gone straight there."""
    back = "counterclockwise" if turns == "clockwise" else "clockwise"
    scene = f"""title: Turned back
given: {{Q: 3 N m, tau: 1 N m, w: unknown}}
bodies: {{wheel: {{inertia: 1 kg m^2, turns: {turns}}}}}
connections: {{ax: {{axle: wheel, friction_torque: tau}}}}
actions: {{q: {{couple: Q, on: wheel, direction: {back}}}}}
states:
  start: {{wheel.angle: 0, wheel.angular_velocity: w}}
  TURN
  end: {{wheel.angle: ANGLE rad, wheel.angular_velocity: -2 rad/s}}
find: {{W: ax.work from start to end, K: wheel.kinetic_energy at start}}
"""
    sign = -1 if turns == "clockwise" else 1  # angles are counted counterclockwise
    scene = scene.replace("ANGLE", str(2 * sign))
    with pytest.raises(Unsolvable, match="comes back to `end`") as refused:
        solve(scene.replace("TURN", ""))
    assert "a state between `start` and `end`" in refused.value.fault.help
    found = solve(scene.replace("TURN", "turn: {wheel.angular_velocity: 0}"))
    assert found.answers["W"].float == pytest.approx(-4)  # it turns at 3 rad: (Q - τ) · 1 = ½ 2²
    assert found.answers["K"].float == pytest.approx(12)
    with pytest.raises(Unsolvable, match="goes the other way to `turn`"):
        solve(scene.replace("TURN", "turn: {wheel.angular_velocity: 0}").replace(f"turns: {turns}", f"turns: {back}"))
