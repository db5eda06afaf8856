"""Refusals are never false: what a help proposes leads on, a law that gives the answer is named, a complete scene is not called open."""

from __future__ import annotations

import re

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

PROPOSED = re.compile(r"`states: \{(\w+): (\{.*\}|at rest)\}`")
INCOMPLETE = {  # scenes that leave one thing out, with `states` as a map in one line each
    "rod without its angle": """
bodies: {rod: {shape: rod, mass: 1 kg, length: 50 cm}}
connections: {pin: {hinge: rod.start}}
states:
  now: {at rest: all}
find: {alpha: rod.angular_acceleration at now}
""",
    "wheel without its speed": """
bodies: {wheel: {shape: disc, mass: 2 kg, radius: 20 cm}, load: {mass: 1 kg, moves: down}}
connections: {axle: {axle: wheel}, cord: {string: [wheel, load]}}
states:
  start: {}
  end: {load.displacement: 2 m}
find: {v: load.velocity at end}
""",
    "spring without its stretch": """
surfaces: {table: level}
given: {k: 200 N/m}
bodies: {cart: {mass: 2 kg, moves: right}}
connections: {under: {contact: [cart, table]}, coil: {spring: [ground, cart], stiffness: k}}
states:
  now: {at rest: all}
find: {a: cart.acceleration at now}
""",
}


def refusal(text: str, law: str | None = None) -> Unsolvable:
    with pytest.raises(Unsolvable) as caught:
        solve(text, law=law)
    return caught.value


@pytest.mark.parametrize("name", INCOMPLETE)
def test_what_a_help_proposes_leads_on(name: str) -> None:
    text = INCOMPLETE[name]
    proposed = PROPOSED.search(refusal(text).fault.help)
    assert proposed is not None, refusal(text).fault.help
    state, lines = proposed[1], proposed[2].strip("{}") if proposed[2] != "at rest" else "at rest: all"
    told = re.sub(
        rf"^  {state}: \{{(.*)\}}$",
        lambda line: f"  {state}: {{{', '.join(filter(None, (line[1], lines)))}}}",
        text,
        flags=re.M,
    )
    assert told != text
    assert not solve(told).refused


BULLET = """
given: {M: 2 kg, m: 20 g, L: 1 m, u: 30 m/s}
bodies: {rod: {shape: rod, mass: M, length: L}, bullet: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: rod, bullet.velocity: u}, after: {}}
events: {hit: {joins: [bullet, rod.end], from: before, to: after}}
find: {w: rod.angular_velocity at after}
"""


@pytest.mark.parametrize("law", ["energy", "newton"])
def test_a_law_that_gives_the_answer_is_named(law: str) -> None:
    reason = refusal(BULLET, law).fault
    assert "can not tell `w`" in reason.message and "--law angular-momentum" in reason.help
    assert solve(BULLET, law="angular-momentum").answers["w"].float


def test_what_is_missing_is_not_laid_to_the_data() -> None:
    """Nothing tells when `end` is: that no time passes contradicts the laws, but not the data."""
    crane = "bodies: {disc: {shape: disc, mass: 2 kg, radius: 10 cm}, b: {mass: 3 kg, moves: down}, c: {mass: 3 kg, moves: right}}\n"
    tied = "surfaces: {floor: level}\nconnections: {axle: {axle: disc}, s: {string: [disc, b]}, l: {contact: [c, floor]}}\n"
    solution = solve(
        crane + tied + "states: {go: at rest, end: {}}\nfind: {v: b.velocity at end, a: b.acceleration at go}\n"
    )
    assert solution.answers["a"].value == "7.35"
    assert "nothing tells when `end` is reached" in solution.refused["v"].fault.help


@pytest.mark.parametrize(
    ("given", "value"), [("W/g", "98"), ("W/(g)", "98"), ("(W/g)", "98"), ("W/(2*g)", "49"), ("W/g/2", "49")]
)
def test_a_given_that_others_make_is_no_unit(given: str, value: str) -> None:
    scene = "given: {W: 98 N, g: 9.8 m/s^2, m: %s}\nbodies: {load: {mass: m}}\nconnections: {cord: {string: [ceiling, load]}}\n"
    assert solve(scene % given + "states: {now: at rest}\nfind: {T: cord.tension at now}\n").answers["T"].value == value


def test_a_unit_of_what_is_measured_stays_a_unit() -> None:
    scene = (
        "given: {m: 2 kg, s: 3 m, v: m/s}\nbodies: {load: {mass: m, moves: down}}\nstates: {now: {load.velocity: v}}\n"
    )
    assert solve(scene + "find: {p: load.momentum at now}\n").answers["p"].exact == "m v"


@pytest.mark.parametrize("written", ["W/2 m", "W^2 m", "W/2 kg"])
@pytest.mark.parametrize("given", ["m: 3 kg", "q: 3 kg"])
def test_what_can_be_read_in_two_ways_is_written_in_one(written: str, given: str) -> None:
    scene = "given: {W: 98 N, %s}\nbodies: {load: {mass: 1 kg, moves: down}}\nfind: {T: %s}\n"
    with pytest.raises(SceneError) as caught:
        solve(scene % (given, written))
    (fault,) = caught.value.faults
    for proposal in re.findall(r"`([/^].*?)`", fault.help):
        assert solve(scene % (given, "W" + proposal)).answers["T"].float
