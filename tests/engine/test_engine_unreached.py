"""A state that is never reached takes no question about the states before it with it: these are answered, and that it is not is said."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8
SCENES = {
    "stops": (
        """
surfaces: {floor: level}
bodies: {one: {mass: 2 kg, moves: WAY}}
connections: {base: {contact: [one, floor], friction: 0.4}}
states: {start: {one.velocity: 1 m/s}, end: {one.displacement: 1 m}}
""",
        -0.4 * G,
    ),
    "turns back": (
        """
surfaces: {ramp: {slope: 30 deg, down: WAY}}
bodies: {one: {mass: 2 kg, moves: up}}
connections: {base: {contact: [one, ramp]}}
states: {start: {one.velocity: 1 m/s}, end: {one.displacement: 1 m}}
""",
        -0.5 * G,
    ),
    "is never pushed": (
        """
surfaces: {floor: level}
bodies: {one: {mass: 2 kg, moves: WAY}, two: {mass: 1 kg, moves: WAY}}
connections: {base: {contact: [one, floor]}, under: {contact: [two, floor]}}
states: {start: {one.velocity: 3 m/s, two.velocity: 0}, after: {}, end: {one.velocity: 0}}
events: {hit: {joins: [one, two], from: start, to: after}}
""",
        0.0,
    ),
}


@pytest.mark.parametrize("way", ["right", "left"])
@pytest.mark.parametrize("name", SCENES)
def test_what_is_asked_of_the_first_state_is_answered(name: str, way: str) -> None:
    scene, acceleration = SCENES[name]
    early, late = "a: one.acceleration at start", "v: one.acceleration at end"
    for questions in (f"{early}, {late}", f"{late}, {early}", early):
        solution = solve(f"title: unreached{scene.replace('WAY', way)}find: {{{questions}}}\n")
        assert solution.answers["a"].float == pytest.approx(acceleration)
        assert set(solution.refused) == ({"v"} if late in questions else set())
        assert all(item.holds for item in solution.derivation.confirmed)
        (said,) = [check for check in solution.derivation.checks if check.holds is False]
        assert "end is never reached from" in str(said.words[0])
    with pytest.raises(Unsolvable, match="reached"):
        solve(f"title: unreached{scene.replace('WAY', way)}find: {{{late}}}\n")


def test_what_an_event_leads_to_from_there_tells_the_states_before() -> None:
    """A connection that an event begins later would act from the start, were the event left out."""
    with pytest.raises(Unsolvable, match="never reached"):
        solve("""
title: unreached
surfaces: {floor: level}
bodies: {one: {mass: 2 kg, moves: right}}
connections: {base: {contact: [one, floor], friction: 0.4}}
states: {start: {one.velocity: 1 m/s}, end: {one.displacement: 1 m}, after: {}}
events: {hit: {impulse: 2 N s, 'on': one, direction: right, from: end, to: after}}
find: {a: one.acceleration at start, v: one.velocity at after}
""")


@pytest.mark.parametrize("lasts", ["from: start, to: end", "to: end", "from: start"])
def test_an_action_that_lasts_until_there_is_no_error_of_its_own(lasts: str) -> None:
    """A push that is too weak: what the action is told by may be the state that is left out."""
    scene = f"""
given: {{m: 2 kg, F: 3 N}}
surfaces: {{floor: level}}
bodies: {{one: {{mass: m, moves: right}}}}
connections: {{base: {{contact: [one, floor], friction: 0.5}}}}
actions: {{push: {{force: F, on: one, direction: right, {lasts}}}}}
states: {{start: {{at rest: all}}, end: {{one.displacement: 100 cm}}}}
find: {{v: one.velocity at start}}
"""
    try:
        found = solve("title: too weak\n" + scene)
    except Unsolvable as error:
        assert "`end` is never reached" in str(error)
    else:
        assert found.answers["v"].float == 0.0


@pytest.mark.parametrize("moves", ["right", "left"])
@pytest.mark.parametrize(("share", "reached"), [("0.3", False), ("0.45", False), ("0.55", True), ("0.8", True)])
def test_a_rope_runs_off_on_the_side_on_which_more_of_it_hangs(moves: str, share: str, reached: bool) -> None:
    """v² = 2 g b (L − b)/L at the end where it hangs longer; nothing brings it back to the other."""
    text = f"""
title: A rope over a peg
given: {{m: 1 kg, L: 2 m, b: {share}*L}}
bodies: {{rope: {{shape: rope, mass: m, length: L, moves: {moves}}}}}
connections: {{over: {{drapes: [rope, ground]}}}}
states: {{start: {{over.length: b, at rest: all}}, off: {{over.length: L}}}}
find: {{v: rope.velocity at off}}
"""
    if not reached:
        with pytest.raises(Unsolvable, match="never reached"):
            solve(text)
        return
    hangs = 2 * float(share)
    assert solve(text).answers["v"].float == pytest.approx((9.8 * hangs * (2 - hangs)) ** 0.5)


SPRING = """
given: {m: 1 kg, g: 10 m/s^2, k: 20 N/m, mu: 0.2, u: U m/s}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: left}}
connections: {base: {contact: [block, floor], friction: mu}, coil: {spring: [ground, block], stiffness: k}}
states: {start: {coil.elongation: 0, block.velocity: u}, far: {block.velocity: 0}, back: {coil.elongation: 0}}
find: {FIND}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize("size", [0.4, 0.9, 1.1, 1.5])
@pytest.mark.parametrize("side", ["left", "right"])
def test_the_state_that_is_not_reached_is_the_one_that_is_named(size: float, side: str) -> None:
    """A block on a spring with friction stops at k x = √(k m u² + (μ m g)²) − μ m g, and comes back by k x ≥ 4 μ m g/2 alone."""
    text = SPRING.replace("U", str(size)).replace("moves: left", f"moves: {side}")
    found = solve(text.replace("FIND", "x: coil.elongation at far, v: block.velocity at back"), confirm=False)
    far = (math.sqrt(20 * size**2 + 4) - 2) / 20
    assert abs(found.answers["x"].float) == pytest.approx(far)
    if far > 2 * 2 / 20:
        assert abs(found.answers["v"].float) == pytest.approx(math.sqrt(20 * far**2 - 2 * 2 * far))
        return
    (refused,) = found.derivation.refused
    assert refused.fault.message == "`back` is never reached from `far`"
    with pytest.raises(Unsolvable, match="`back` is never reached from `far`"):
        solve(text.replace("FIND", "v: block.velocity at back"))


def test_letters_answer_what_comes_before() -> None:
    text = SPRING.replace("1 kg, g: 10 m/s^2, k: 20 N/m, mu: 0.2, u: U", "kg, k: N/m, mu: number, u:")
    found = solve(text.replace("FIND", "x: coil.elongation at far, v: block.velocity at back"), confirm=False)
    assert {case.exact for case in found.answers["x"].branches} == {"(μ m g − √(m (k u² + μ² m g²)))/k"}
    assert "far` is never reached" not in str(found)
    assert "there is no answer for v: `back` is never reached from `far`" in str(found).replace("\n  ", " ")


STRUCK = """
given: {M: 2 kg, L: 1 m, J: 1 N s, x: 0.9 m}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: all}, after: {}, level: {rod.angle: 0}}
events: {blow: {impulse: J, on: rod.at(x), direction: right, from: before, to: after}}
find: {w: rod.angular_velocity at level, P: pin.impulse.x during blow, E: change of rod.kinetic_energy during blow}
"""


def test_a_blow_on_the_way_is_answered() -> None:
    """What the hinge gives, J (3 x/2 L − 1), and the energy, 3 J² x²/2 M L², are told before the rod turns back."""
    found = solve(STRUCK)
    assert found.answers["P"].float == pytest.approx(0.35)
    assert found.answers["E"].float == pytest.approx(3 * 0.81 / 4)
    (refused,) = found.derivation.refused
    assert (refused.name, refused.fault.message) == ("w", "`level` is never reached from `after`")
    letters = solve(STRUCK.replace("2 kg", "kg").replace("1 m,", "m,").replace("1 N s", "N s").replace("0.9 m", "m"))
    assert not letters.answers["P"].answer.conditions
    assert letters.answers["w"].answer.conditions


BRAKED = """
given: {M: 10 kg, I: 2 kg m^2, R: 0.5 m, h: 1 m, F: PRESS, mu: 0.5, g: 10 m/s^2}
bodies: {drum: {inertia: I, mass: 1 kg, radius: R, turns: WAY}, load: {mass: M, moves: DRIVE}}
connections: {axle: {axle: drum}, rope: {string: [load, drum]}}
actions: {brake: {press: F, on: drum, friction: mu, from: mid, to: end}}
states: {start: at rest, mid: {load.displacement: h}, end: {load.velocity: 0}}
find: {QUESTIONS}
"""
QUESTIONS = ("s: load.displacement from mid to end", "W: brake.work from mid to end", "t: time from mid to end")


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("asked", "turns"),
    [
        (QUESTIONS, "clockwise"),
        *((one, ("counterclockwise", "clockwise")[k % 2]) for k, one in enumerate(zip(QUESTIONS))),
    ],
    ids=["all", "s", "W", "t"],
)
def test_a_speed_that_is_needed_as_its_square_alone_has_a_way_too(asked: tuple[str, ...], turns: str) -> None:
    """A load of 10 kg falls h, then a brake holds against it: μ F > M g stops it after s = h M g/(μ F − M g), a weaker one never."""
    text = BRAKED.replace("WAY", turns).replace("DRIVE", "down").replace("QUESTIONS", ", ".join(asked))
    stopped = solve(text.replace("PRESS", "400 N"))
    speed = math.sqrt(2 * 100 / (10 + 2 / 0.25))
    told = {"s": 1.0, "W": -200.0, "t": 2 / speed}
    assert all(answer.float == pytest.approx(told[name]) for name, answer in stopped.answers.items())
    with pytest.raises(Unsolvable, match="`end` is never reached from `mid`"):
        solve(text.replace("PRESS", "100 N"))
    letters = solve(text.replace("PRESS", "N").replace("10 kg", "kg").replace("0.5, g", "number, g"), confirm=False)
    for answer in letters.answers.values():
        assert len(answer.branches) == 1 and answer.answer.conditions


def test_a_square_that_is_negative_bars_what_needs_it_alone() -> None:
    """The load does not rise by itself."""
    text = BRAKED.replace("WAY", "clockwise").replace("DRIVE", "up").replace("QUESTIONS", QUESTIONS[0])
    for press in ("400 N", "100 N"):
        with pytest.raises(Unsolvable, match="`mid` is never reached from `start`"):
            solve(text.replace("PRESS", press))


def test_what_a_blow_gives_is_told_though_the_phase_after_it_has_a_name() -> None:
    """v = m u/(m + M) whether or not they slide so far, also where `phases` names the way to the state that is not reached."""
    scene = """
title: A puck sticks to a crate, and both slide to an edge, perhaps
given: {m: kg, M: kg, u: m/s, mu: number, d: m}
surfaces: {table: level}
bodies: {puck: {mass: m, moves: right}, crate: {mass: M, moves: right}}
connections: {p: {contact: [puck, table], friction: mu}, q: {contact: [crate, table], friction: mu}}
states: {before: {puck.velocity: u, crate.velocity: 0}, after: {}, edge: {crate.displacement: d}}
events: {hit: {joins: [puck, crate], from: before, to: after}}
phases: {slide: {from: after, to: edge}}
find: {v: crate.velocity at after, w: crate.velocity at edge}
"""
    answers = solve(scene, confirm=False).answers
    assert [case.conditions for case in answers["v"].branches] == [()]
    assert answers["w"].conditions
