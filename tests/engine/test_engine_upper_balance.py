"""What has just the energy for its upper balance comes there ever more slowly: no later state is reached."""

from __future__ import annotations

import pytest

from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of
from rotsolve.core.faults import NeverReached, Unsolvable
from rotsolve.pipeline import solve

ROD = "rod: {shape: rod, mass: M, length: L%s}"
SCENES = {  # the letters with their numbers at the edge, g among them; the bodies; what holds them, what happens; how fast it is down there
    "a rod": (
        {"M": (2.0, "kg"), "L": (1.0, "m"), "w": (6.0, "rad/s"), "g": (6.0, "m/s^2")},
        ROD,
        "hinge: rod.start",
        "start: {rod.angle: -90 deg, rod.angular_velocity: w}",
        "",
        -6.0,
    ),
    "a disc that hangs by its rim": (
        {"M": (2.0, "kg"), "R": (1.0, "m"), "w": (4.0, "rad/s"), "g": (6.0, "m/s^2")},
        "rod: {shape: disc, mass: M, radius: R%s}",
        "hinge: rod.top",
        "start: {rod.angle: -90 deg, rod.angular_velocity: w}",
        "",
        -4.0,
    ),
    "a rod with a lump": (
        {"M": (3.0, "kg"), "L": (1.0, "m"), "m": (1.0, "kg"), "w": (6.0, "rad/s"), "g": (7.2, "m/s^2")},
        f"{ROD}, lump: {{mass: m}}",
        "hinge: rod.start}, tie: {weld: [rod.end, lump]",
        "start: {rod.angle: -90 deg, rod.angular_velocity: w}",
        "",
        -6.0,
    ),
    "a rod that a dart hits": (
        {"M": (1.0, "kg"), "L": (1.0, "m"), "m": (1.0, "kg"), "u": (4.0, "m/s"), "g": (2.0, "m/s^2")},
        f"{ROD}, dart: {{mass: m, moves: WAY}}",
        "hinge: rod.start",
        "before: {rod.angle: -90 deg, at rest: rod, dart.velocity: u}, start: {}",
        "events: {hit: {joins: [dart, rod.end], from: before, to: start}}",
        -3.0,
    ),
    "a rod off which a ball bounces": (
        {
            "M": (1.0, "kg"),
            "L": (1.0, "m"),
            "m": (1.0, "kg"),
            "u": (4.0, "m/s"),
            "e": (0.5, "number"),
            "g": (3.375, "m/s^2"),
        },
        f"{ROD}, ball: {{mass: m, moves: WAY}}",
        "hinge: rod.start",
        "before: {rod.angle: -90 deg, at rest: rod, ball.velocity: u}, start: {}",
        "events: {hit: {collides: [ball, rod.end], restitution: e, from: before, to: start}}",
        -4.5,
    ),
}
TURNS = {"": ("largest", "right"), ", turns: clockwise": ("smallest", "left")}


def scene(name: str, turns: str, top: str, **numbers: float) -> str:
    """A scene in letters, or with numbers for them."""
    letters, bodies, held, first, events, _ = SCENES[name]
    given = ", ".join(
        f"{one}: {f'{numbers[one]} {unit}'.removesuffix(' number') if numbers else unit}"
        for one, (_, unit) in letters.items()
    )
    return f"""
title: {name}
given: {{{given}}}
gravity: g
bodies: {{{(bodies % turns).replace("WAY", TURNS[turns][1])}}}
connections: {{pin: {{{held}}}}}
states: {{{first}, top: {{{top}}}, back: {{rod.angle: -90 deg}}}}
{events}
find: {{v: rod.angular_velocity at back}}
"""


IN_TURN = [(name, tuple(TURNS)[place % len(TURNS)]) for place, name in enumerate(SCENES)]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("name", "turns"), IN_TURN)
def test_letters_leave_the_edge_out(name: str, turns: str) -> None:
    letters, *_, right = SCENES[name]
    (answer,) = solve(scene(name, turns, f"rod.angle: {TURNS[turns][0]}"), confirm=False).answers.values()
    edge = {one: number for one, (number, _) in letters.items()}
    for g, there in ((0.97, None), (1.0, None), (1.03, right), (2.0, right)):
        numbers = {**edge, "g": g * edge["g"]}
        case = holding(answer.answer, numbers)
        assert (case is None) == (there is None), f"{answer} at {g} of the edge"
        if case is not None and case.formula is not None:
            assert value_of(case.formula, numbers) == pytest.approx(there)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("name", "turns"), IN_TURN)
@pytest.mark.parametrize("rests", [False, True])
def test_numbers_on_the_edge_are_refused(name: str, turns: str, rests: bool) -> None:
    """Whether the highest place is told as such, or as that at which it is at rest; a little less is answered."""
    letters, *_, right = SCENES[name]
    edge = {one: number for one, (number, _) in letters.items()}
    top = "rod.angular_velocity: 0" if rests else f"rod.angle: {TURNS[turns][0]}"
    with pytest.raises(NeverReached, match="is never reached"):
        solve(scene(name, turns, top, **edge))
    with pytest.raises(Unsolvable):
        solve(scene(name, turns, top, **{**edge, "g": 0.97 * edge["g"]}))
    solution = solve(scene(name, turns, top, **{**edge, "g": 1.03 * edge["g"]}))
    assert solution.answers["v"].float == pytest.approx(right)
    assert all(item.holds for item in solution.derivation.confirmed)


def test_at_its_highest_it_is_up_there_also_on_the_edge() -> None:
    """The highest place itself is told, as a speed is to which a drag leads: the limit."""
    text = scene("a rod", "", "rod.angle: largest", M=2.0, L=1.0, w=6.0, g=6.0)
    solution = solve(text.replace("find: {", "find: {phi: rod.angle at top, "))
    assert solution.answers["phi"].float == pytest.approx(1.5707963)
    assert "v" in solution.refused


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("name", "turns"), IN_TURN)
def test_it_does_not_come_to_rest_up_there(name: str, turns: str) -> None:
    """The state at which it is at rest is itself not reached on the edge, as its `rod.angle: largest` is; in letters that is left out."""
    letters, *_ = SCENES[name]
    edge = {one: number for one, (number, _) in letters.items()}
    ask = ("v: rod.angular_velocity at back", "th: rod.rotation from start to top")
    with pytest.raises(NeverReached, match="is never reached"):
        solve(scene(name, turns, "rod.angular_velocity: 0", **edge).replace(*ask))
    (answer,) = solve(scene(name, turns, "rod.angular_velocity: 0").replace(*ask), confirm=False).answers.values()
    for g, there in ((0.97, False), (1.0, False), (1.03, True), (2.0, True)):
        case = holding(answer.answer, {**edge, "g": g * edge["g"]})
        assert (case is not None) == there, f"{answer} at {g} of the edge"


STRUCK = """given: {M: 2 kg, L: 1 m, m: 1 kg, u: unknown, e: RATIO}
bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: rod, ball.velocity: u}, after: {}, up: {rod.angle: 90 deg, STANDS}}
events: {hit: {collides: [ball, rod.end], restitution: e, from: before, to: after}}
find: {u: u, w: rod.angular_velocity at after, V: ball.velocity at up}
"""


@pytest.mark.parametrize("ratio", [0.5, 1.0])
@pytest.mark.parametrize("stands", ["balance: true", "at rest: rod"])
def test_what_nothing_holds_goes_on_while_all_else_comes_to_its_balance(ratio: float, stands: str) -> None:
    """By hand: ⅙ M L² w² = M g L, m u L = ⅓ M L² w + m v L, L w − v = e u; the ball goes on with v."""
    solution = solve(STRUCK.replace("RATIO", str(ratio)).replace("STANDS", stands))
    w = (6 * 9.8) ** 0.5
    u = 5 / 3 * w / (1 + ratio)
    assert solution.answers["w"].float == pytest.approx(w, rel=1e-12)
    assert solution.answers["u"].float == pytest.approx(u, rel=1e-12)
    assert solution.answers["V"].float == pytest.approx(w - ratio * u, rel=1e-12)
    assert not any(item.holds is False for item in solution.derivation.confirmed)


def test_what_is_pushed_is_not_in_balance() -> None:
    text = STRUCK.replace("RATIO", "0.5").replace("STANDS", "balance: true")
    with pytest.raises(Unsolvable, match="Newton's second law, ball"):
        solve(text + "actions: {push: {force: 2 N, on: ball, direction: right}}\n")
