"""Friction that holds something is drawn, named and counted the way in which it acts, where its number tells that."""

from __future__ import annotations

import pytest

from rotsolve.algebra.notation.text import to_text
from rotsolve.pipeline import solve

WHEEL = """
given: {{m: 2 kg, R: 0.1 m, F: 3 N, r: {r}, b: 20 deg}}
surfaces: {{road: {surface}}}
bodies: {{wheel: {{shape: disc, mass: m, radius: R, radii: {{hub: r}}, moves: {moves}}}}}
connections: {{grip: {{rolls: [wheel, road]}}}}
actions: {action}
find: {{f: {question}}}
"""
LEVEL, SLOPE = "level", "{slope: b}"
PULL = "{pull: {force: F, on: wheel.hub, side: top, direction: right}}"
TURN = "{drive: {couple: 0.1 N m, on: wheel}}"


def answer(text: str):  # type: ignore[no-untyped-def]
    return solve(text).derivation.answers[0]


@pytest.mark.parametrize(
    ("surface", "moves", "action", "size", "way"),
    [
        (SLOPE, "up", "{}", 2 * 9.8 * 0.3420201433 / 3, "up the slope"),
        (SLOPE, "down", "{}", 2 * 9.8 * 0.3420201433 / 3, "up the slope"),
        (LEVEL, "right", "{drive: {couple: 0.3 N m, on: wheel}}", 2 / 3 * 3, "right"),
        (LEVEL, "right", "{drive: {couple: -0.3 N m, on: wheel}}", 2 / 3 * 3, "left"),
        (LEVEL, "right", "{pull: {force: F, on: wheel, direction: right}}", 1.0, "left"),
        (LEVEL, "right", "{pull: {force: F, on: wheel, direction: left}}", 1.0, "right"),
        (LEVEL, "left", "{pull: {force: F, on: wheel, direction: left}}", 1.0, "right"),
    ],
)
def test_friction_is_named_as_it_acts(surface: str, moves: str, action: str, size: float, way: str) -> None:
    """A disc that rolls: f = ⅓ m g sin β on a slope, ⅔ τ/R of a couple, ⅓ F of a pull at its centre."""
    text = WHEEL.format(r="5 cm", surface=surface, moves=moves, action=action, question="grip.friction_force")
    found = answer(text)
    assert found.value is not None and found.value.float == pytest.approx(size)
    assert found.direction == way
    page = solve(text).to("text", width=120)
    assert f"friction f, {way}" in " ".join(page.split())


def test_it_is_a_size_in_what_is_made_of_it() -> None:
    scene = WHEEL.format(
        r="5 cm", surface=LEVEL, moves="right", action="{pull: {force: F, on: wheel, direction: left}}", question="{}"
    )
    found = answer(scene.replace("{}}", "grip.friction_force + 3 N}"))
    assert found.value is not None and found.value.float == pytest.approx(4.0)


def test_in_letters_it_is_named_as_they_are_meant() -> None:
    found = solve(
        """
given: {m: kg, R: m, tau: N m}
surfaces: {road: level}
bodies: {wheel: {shape: disc, mass: m, radius: R, moves: right}}
connections: {grip: {rolls: [wheel, road]}}
actions: {drive: {couple: tau, on: wheel}}
find: {f: grip.friction_force}
"""
    )
    (answer,) = found.derivation.answers
    assert answer.direction == "right" and answer.formula is not None and to_text(answer.formula) == "2 τ/(3 R)"
    page = " ".join(found.to("text").split())
    assert "friction f, right" in page and "τ > 0" in page


def test_a_brake_that_holds_either_way() -> None:
    """A weight on either side of a drum that a block holds."""
    for side, way in (("over: drum", "counterclockwise"), ("under: drum", "clockwise")):
        text = f"""
given: {{m: 2 kg, M: 3 kg, R: 0.1 m, mu: 0.5, F: 100 N}}
bodies: {{drum: {{shape: disc, mass: M, radius: R}}, load: {{mass: m}}}}
connections: {{axle: {{axle: drum}}, rope: {{string: [drum, load], {side}}}}}
actions: {{brake: {{press: F, on: drum.rim, friction: mu}}}}
states: {{now: {{at rest: all, balance: true}}}}
find: {{f: brake.friction_force}}
"""
        found = answer(text)
        assert found.value is not None and found.value.float == pytest.approx(19.6), side
        assert way in found.direction


def test_friction_that_turns_round_keeps_its_sense() -> None:
    """A pull 2 N − k t that changes its sign: one sense at both moments, or a change of it would be that of sizes."""
    scene = """
given: {m: 2 kg, R: 0.1 m, k: 5 N/s}
surfaces: {road: level}
bodies: {wheel: {shape: disc, mass: m, radius: R, moves: right}}
connections: {grip: {rolls: [wheel, road]}}
actions: {pull: {force: 2 N - k*time, on: wheel, direction: right}}
states: {one: {at rest: all}, two: {time: 1 s}}
find: {first: grip.friction_force at one, then: grip.friction_force at two}
"""
    first, then = solve(scene).derivation.answers
    assert first.value is not None and then.value is not None
    assert (first.value.float, then.value.float) == (pytest.approx(2 / 3), pytest.approx(-1.0))
    assert (first.direction, then.direction) == ("left", "right")
