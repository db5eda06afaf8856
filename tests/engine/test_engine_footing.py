"""Bodies that are joined and led along a line, each on a surface of its own: what lies under it carries each."""

from __future__ import annotations

from itertools import permutations
from math import cos, radians, sin

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

G = 9.8
MASSES, ROUGH = {"one": 2.0, "two": 3.0, "three": 1.0}, {"one": 0.2, "two": 0.5, "three": 0.1}
FLOORS = {"level": 0.0, "{slope: 20 deg, down: left}": 20.0, "{slope: 20 deg, down: right}": -20.0}
LETTERS = {"one": "m", "two": "M", "three": "c"}


def scene(
    names: list[str],
    floor: str,
    link: str,
    *,
    moves: dict[str, str] | None = None,
    pulled: tuple[str, float, float] | None = None,
    states: str,
    find: str,
    more: str = "",
) -> str:
    """Bodies in a row on a floor, tied to each other as `link` says."""
    bodies = ", ".join(
        f"{name}: {{mass: {MASSES[name]} kg, moves: {(moves or {}).get(name, 'right')}}}" for name in names
    )
    lying = "\n".join(f"  c_{name}: {{contact: [{name}, floor], friction: {ROUGH[name]}}}" for name in names)
    pull = ""
    if pulled is not None:
        pull = f"\nactions: {{pull: {{force: {pulled[1]} N, on: {pulled[0]}, direction: {pulled[2]} deg}}}}"
    return f"""
title: A row of crates
surfaces: {{floor: {floor}}}
bodies: {{{bodies}}}
connections:
{lying}
{link}{more}{pull}
states: {states}
find: {{{find}}}
"""


def normals(names: list[str], floor: float, pulled: tuple[str, float, float] | None = None) -> dict[str, float]:
    """N of each, by Newton's law across the floor for that one alone; `floor` is how far it is turned counterclockwise."""
    found = {name: MASSES[name] * G * cos(radians(floor)) for name in names}
    if pulled is not None:
        found[pulled[0]] -= pulled[1] * sin(radians(pulled[2] - floor))
    return found


def rate(names: list[str], floor: float, way: float, pulled: tuple[str, float, float] | None = None) -> float:
    """The acceleration to the right or up the slope of all while they slip along `way`."""
    rubbing = sum(ROUGH[name] * push for name, push in normals(names, floor, pulled).items())
    mass = sum(MASSES[name] for name in names)
    pull = 0.0 if pulled is None else pulled[1] * cos(radians(pulled[2] - floor))
    return (pull - way * rubbing) / mass - G * sin(radians(floor))


@pytest.mark.parametrize(
    ("order", "floor"),
    [
        (order, floor)
        for place, order in enumerate(permutations(["one", "two", "three"]))
        for at, floor in enumerate(FLOORS)
        if (place + at) % 2 == 0
    ],
)
def test_each_of_three_that_are_welded_is_carried_by_the_floor_under_it(floor: str, order: tuple[str, ...]) -> None:
    first, second, third = order
    welds = f"  g: {{weld: [{first}, {second}]}}\n  h: {{weld: [{third}, {second}]}}"
    pulled = ("two", 35.0, 25.0)
    asked = ", ".join(f"N{name}: c_{name}.normal_force at s, f{name}: c_{name}.friction_force at s" for name in order)
    text = scene(list(order), floor, welds, pulled=pulled, states="{s: {one.velocity: 1 m/s}, e: {time: 0.1 s}}", find=
                 f"a: one.acceleration at s, v: two.velocity at e, W: c_three.work from s to e, {asked}")  # fmt: skip
    solution = solve(text)
    found, turned = {name: answer.float for name, answer in solution.answers.items()}, FLOORS[floor]
    pushes, a = normals(list(order), turned, pulled), rate(list(order), turned, 1.0, pulled)
    way = 0.1 + a * 0.01 / 2
    expected = {"a": a, "v": 1 + 0.1 * a, "W": -ROUGH["three"] * pushes["three"] * way}
    expected |= {f"N{name}": push for name, push in pushes.items()}
    expected |= {f"f{name}": ROUGH[name] * push for name, push in pushes.items()}
    assert found == pytest.approx(expected)
    assert all(item.holds for item in solution.derivation.confirmed)


SENSES = [("right", "right"), ("right", "left"), ("left", "right"), ("left", "left")]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("floor", "senses", "joins"),
    [
        (floor, senses, ("one, two", "two, one")[(at + place) % 2])
        for at, floor in enumerate(FLOORS)
        for place, senses in enumerate(SENSES)
    ],
)
def test_two_that_meet_slide_on_together_and_come_to_rest(floor: str, joins: str, senses: tuple[str, str]) -> None:
    moves = dict(zip(("one", "two"), senses, strict=True))
    sign = {name: 1 if word == "right" else -1 for name, word in moves.items()}
    event = f"\nevents: {{hit: {{joins: [{joins}], from: before, to: after}}}}"
    states = (
        f"{{before: {{one.velocity: {6 * sign['one']} m/s, two.velocity: 0}}, after: {{}}, end: {{two.velocity: 0}}}}"
    )
    find = (
        "V: two.velocity at after, d: two.displacement from after to end, s: one.displacement from after to end, "
        "t: time from after to end, W: c_one.work from after to end, Q: c_two.work from after to end, "
        "f: c_one.friction_force at after, E: lost kinetic_energy from after to end, L: lost kinetic_energy during hit"
    )
    solution = solve(scene(["one", "two"], floor, "", moves=moves, states=states + event, find=find))
    found, turned = {name: answer.float for name, answer in solution.answers.items()}, FLOORS[floor]
    v, a, pushes = 12 / 5, rate(["one", "two"], turned, 1.0), normals(["one", "two"], turned)
    way = -(v**2) / (2 * a)
    works = [-ROUGH[name] * pushes[name] * way for name in ("one", "two")]
    expected = {"V": sign["two"] * v, "d": sign["two"] * way, "s": sign["one"] * way, "t": -v / a, "W": works[0]}
    expected |= {"Q": works[1], "E": 5 * v**2 / 2, "L": 2 * 36 / 2 - 5 * v**2 / 2}
    friction = found.pop("f")
    assert found == pytest.approx(expected)
    assert abs(friction) == pytest.approx(ROUGH["one"] * pushes["one"])
    assert all(item.holds for item in solution.derivation.confirmed)


def welded_at_rest(pulled: tuple[str, float, float]) -> str:
    """Two crates in one that rest on a floor when one is pulled."""
    joined, find = "  g: {weld: [one, two]}", "a: two.acceleration"
    return scene(["one", "two"], "level", joined, pulled=pulled, states="{s: at rest}", find=find)


@pytest.mark.parametrize("pull", [5.0, 19.0, 20.0, 40.0])
def test_both_give_way_when_the_pull_is_more_than_both_limits_together(pull: float) -> None:
    """0.2 · 19.6 N + 0.5 · 29.4 N = 18.62 N, less what the pull lifts; how what holds is shared, nothing tells."""
    pulled = ("one", pull, 10.0)
    assert solve(welded_at_rest(pulled)).answers["a"].float == pytest.approx(
        max(0.0, rate(["one", "two"], 0.0, 1.0, pulled))
    )


def test_how_friction_that_holds_two_is_shared_is_refused() -> None:
    for floor in FLOORS:
        pulled = ("one", 0.3, 10.0)
        find = "a: two.acceleration, f: c_one.friction_force"
        text = scene(["one", "two"], floor, "  g: {weld: [one, two]}", pulled=pulled, states="{s: at rest}", find=find)
        solution = solve(text)
        assert list(solution.answers) == ["a"]
        assert (
            "friction force of c one at s, friction force of c two at s" in solution.derivation.refused[0].fault.message
        )


def test_in_letters_each_is_carried() -> None:
    text = """
title: Crates
given: {m: kg, M: kg, u: m/s, mu: number, k: number, b: rad}
surfaces: {hill: {slope: b, down: right}}
bodies: {one: {mass: m, moves: down}, two: {mass: M, moves: down}}
connections:
  c1: {contact: [one, hill], friction: mu}
  c2: {contact: [two, hill], friction: k}
  glue: {weld: [one, two]}
states: {start: {one.velocity: u}}
find: {a: two.acceleration, N: c2.normal_force, f: c1.friction_force}
"""
    found = solve(text).answers
    numbers = {"m": 2.0, "M": 3.0, "mu": 0.2, "k": 0.5, "b": 0.3, "g": G, "u": 1.0}
    m, M, mu, k, b = (numbers[name] for name in ("m", "M", "mu", "k", "b"))
    expected = {
        "a": G * sin(b) - G * cos(b) * (mu * m + k * M) / (m + M),
        "N": M * G * cos(b),
        "f": mu * m * G * cos(b),
    }
    told = "m: 2 kg, M: 3 kg, u: 1 m/s, mu: 0.2, k: 0.5, b: 0.3 rad"
    in_numbers = solve(text.replace("m: kg, M: kg, u: m/s, mu: number, k: number, b: rad", told)).answers
    for name, value in expected.items():
        assert in_numbers[name].float == pytest.approx(value)
        assert found[name].formula == in_numbers[name].formula


CARGO = """
title: Cargo on one of two crates
surfaces: {floor: level}
bodies: {one: {mass: 2 kg, moves: right}, two: {mass: 3 kg, moves: right}, three: {mass: 1 kg, moves: right}}
connections:
  c1: {contact: [one, floor], friction: 0.2}
  c2: {contact: [two, floor], friction: 0.3}
  g1: {weld: [ONE, three]}
  g2: {weld: [SECOND]}
states: {start: {one.velocity: 8 m/s}}
find: {a: one.acceleration, N: c1.normal_force}
"""


@pytest.mark.parametrize(("bearer", "weights"), [("one", (3, 3)), ("two", (2, 4))])
def test_what_lies_on_nothing_is_borne_by_what_it_is_joined_to(bearer: str, weights: tuple[int, int]) -> None:
    solution = solve(CARGO.replace("ONE", bearer).replace("SECOND", "one, two"))
    first, second = (weight * G for weight in weights)
    assert solution.answers["N"].float == pytest.approx(first)
    assert solution.answers["a"].float == pytest.approx(-(0.2 * first + 0.3 * second) / 6)
    assert all(item.holds for item in solution.derivation.confirmed)


def test_of_a_bridge_between_two_nothing_tells_how_they_bear_it() -> None:
    with pytest.raises((SceneError, Unsolvable), match="too little is known"):
        solve(CARGO.replace("ONE", "one").replace("SECOND", "three, two"))


STACK = """
title: A crate that stays on the back of another
surfaces: {floor: FLOOR}
bodies: {one: {mass: 2 kg, moves: right}, two: {mass: 3 kg, moves: right}}
connections:
  c1: {contact: [one, floor], friction: 0.6}
  c2: {contact: [two, one], friction: 0.3}
states: {before: {one.velocity: 8 m/s, two.velocity: 2 m/s}, after: {}, end: {one.velocity: 0}}
events: {hit: {joins: [JOINS], from: before, to: after}}
find:
  V: one.velocity at after
  a: two.acceleration at after
  N: c1.normal_force at after
  P: c2.normal_force at after
  d: two.displacement from after to end
"""


@pytest.mark.parametrize("floor", FLOORS)
@pytest.mark.parametrize("joins", ["one, two", "two, one"])
def test_the_lower_of_two_that_are_joined_carries_both(floor: str, joins: str) -> None:
    solution, turned = solve(STACK.replace("FLOOR", floor).replace("JOINS", joins)), radians(FLOORS[floor])
    a = -G * (sin(turned) + 0.6 * cos(turned))
    found = {name: answer.float for name, answer in solution.answers.items()}
    expected = {"V": 4.4, "a": a, "N": 5 * G * cos(turned), "P": 3 * G * cos(turned), "d": -(4.4**2) / (2 * a)}
    assert found == pytest.approx(expected)
    assert all(item.holds for item in solution.derivation.confirmed)


@pytest.mark.parametrize("tied", ["one", "two"])
def test_a_string_over_a_pulley_draws_both(tied: str) -> None:
    more = f"""
  g: {{weld: [one, two]}}
  pin: {{axle: wheel}}
  rope: {{string: [{tied}, wheel, load]}}
"""
    text = scene(
        ["one", "two"],
        "level",
        "",
        more=more,
        states="{s: {one.velocity: 1 m/s}}",
        find="a: load.acceleration, T: rope.tension",
    )
    text = text.replace("bodies: {", "bodies: {load: {mass: 2 kg, moves: down}, wheel: {mass: 0, radius: 10 cm}, ")
    found = solve(text).answers
    a = (2 * G - sum(ROUGH[name] * MASSES[name] * G for name in ("one", "two"))) / 7
    assert (found["a"].float, found["T"].float) == pytest.approx((a, 2 * (G - a)))


def test_what_lifts_one_of_two_off_does_not_hold() -> None:
    """The law is told for what stays on its surface: with one that would be lifted off there is no acceleration, and that is said."""
    with pytest.raises(Unsolvable, match="`c_one` lets go at `s`"):
        solve(welded_at_rest(("one", 50.0, 30.0)))
