"""Refusals are never false: what a help proposes leads on, a law that gives the answer is named, a complete scene is not called open."""

from __future__ import annotations

import math
import re

import pytest

from rotsolve.core.faults import UNSOLVED, SceneError, Unsolvable
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


BLAMING = ("too little is known", "contradict", "never reached", "nothing tells when")
SWINGING = {  # complete scenes in which the place at a time has no closed form: (bodies, connections, first state, question)
    "rod": (
        "rod: {shape: rod, mass: M, length: L}",
        "pin: {hinge: rod.start}",
        "rod.angle: 30 deg",
        "rod.angular_velocity",
    ),
    "plate": (
        "plate: {shape: rectangle, mass: M, sides: [L, L/2]}",
        "pin: {hinge: plate.corner1}",
        "plate.angle: 40 deg",
        "pin.force.y",
    ),
    "two rods": (
        "a: {shape: rod, mass: M, length: L}, b: {shape: rod, mass: M, length: L/2}",
        "pin: {hinge: a.start}, joint: {hinge: [a.end, b.start]}",
        "a.angle: 20 deg, b.angle: -50 deg",
        "b.angular_velocity",
    ),
    "wheel with a weight": (
        "wheel: {shape: disc, mass: M, radius: L}, lump: {mass: M}",
        "axle: {axle: wheel}, glue: {weld: [wheel.rim, lump]}",
        "wheel.angle: 10 deg",
        "lump.kinetic_energy",
    ),
}


def swinging(name: str, given: str, *, start: str | None = None) -> str:
    bodies, connections, angles, asked = SWINGING[name]
    first = f"{{{angles}, at rest: all}}" if start is None else start
    states = f"{{high: {first}, low: {{time: t1}}}}"
    lines = f"given: {{{given}}}\nbodies: {{{bodies}}}\nconnections: {{{connections}}}\n"
    return f"{lines}states: {states}\nfind: {{x: {asked} at low}}\n"


@pytest.mark.parametrize("given", ["M: 2 kg, L: 60 cm, t1: 0.2 s", "M: kg, L: m, t1: s"], ids=["numbers", "letters"])
@pytest.mark.parametrize("name", SWINGING)
def test_a_complete_scene_is_not_blamed(name: str, given: str) -> None:
    """What is refused is the motion, since the assembly of all bodies' equations has an answer."""
    fault = refusal(swinging(name, given)).fault
    assert not any(word in fault.message for word in BLAMING), fault.message
    assert "the accelerations vary from high to low" in fault.message
    assert "nothing is missing" in fault.help


@pytest.mark.parametrize("name", ["rod", "two rods"])
@pytest.mark.parametrize("start", ["at rest", "{}"])
def test_an_incomplete_scene_still_is_called_so(name: str, start: str) -> None:
    """The angle of a rod that weighs hangs on what nothing tells, and with it the answer of the assembly."""
    text = swinging(name, "M: 2 kg, L: 60 cm, t1: 0.2 s", start=start)
    assert "too little is known" in refusal(text).fault.message


def test_lines_that_contradict_each_other_are_still_called_so() -> None:
    text = swinging("rod", "M: 2 kg, L: 60 cm").replace("low: {time: t1}", "low: {rod.angle: 80 deg}")
    assert "never reached" in refusal(text).fault.message


def test_of_several_questions_each_refusal_is_held_against_the_assembly() -> None:
    text = swinging("rod", "M: 2 kg, L: 60 cm, t1: 0.2 s").replace(
        "find: {", "find: {a: rod.angular_acceleration at high, "
    )
    solution = solve(text)
    assert solution.answers["a"].float
    assert "is not solved by these laws" in str(solution.refused["x"])


HALF_TOLD = {  # first states that tell one rate of several: what is proposed may not contradict it
    "wheel on a spring": (
        "one: {mass: M, inertia: M*r^2, radius: r, moves: down}",
        "coil: {spring: [ceiling, one], stiffness: k}",
        "coil.elongation: 10 cm, one.velocity: 2 m/s",
        "one.kinetic_energy",
    ),
    "wheel that slides": (
        "one: {shape: disc, mass: M, radius: r, moves: right}",
        "base: {contact: [one, floor], friction: none}",
        "one.velocity: 2 m/s",
        "one.kinetic_energy",
    ),
    "load on a drum, beside a wheel": (
        "drum: {shape: disc, mass: M, radius: r, turns: clockwise}, load: {mass: M, moves: down}, one: {shape: disc, mass: M, radius: r}",
        "axle: {axle: drum}, cord: {string: [drum, load]}, stud: {axle: one}",
        "load.velocity: 2 m/s",
        "kinetic_energy",
    ),
}


@pytest.mark.parametrize("name", HALF_TOLD)
def test_what_a_help_proposes_contradicts_nothing(name: str) -> None:
    bodies, connections, lines, asked = HALF_TOLD[name]
    text = (
        "given: {M: 2 kg, r: 20 cm, k: 150 N/m}\nsurfaces: {floor: level}\n"
        f"bodies: {{{bodies}}}\nconnections: {{{connections}}}\n"
        f"states:\n  now: {{{lines}}}\n  later: {{time: 10 ms}}\nfind: {{x: {asked} at now}}\n"
    )
    proposed = PROPOSED.search(refusal(text).fault.help)
    assert proposed is not None and proposed[2] != "at rest", refusal(text).fault.help
    told = text.replace(f"now: {{{lines}}}", f"now: {{{lines}, {proposed[2].strip('{}')}}}")
    assert not solve(told).refused


HANGING = {
    "a spring of which no length is told": (
        """
given: {M: 2 kg, L: 1 m, k1: 30 N/m, kappa: unknown}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections:
  pin: {hinge: rod.start}
  wire: {torsion: rod, stiffness: kappa, rest_angle: 90 deg}
  coil: {spring: [ground, rod.at(L/2)], stiffness: k1}
states: {upright: {rod.angle: 90 deg, balance: true}}
find: {kappa: smallest kappa where upright is stable}
""",
        "hangs on elongation of coil at upright, which nothing tells",
    ),
}


@pytest.mark.parametrize(("text", "message"), HANGING.values(), ids=HANGING)
def test_an_answer_that_holds_what_nothing_tells_is_none(text: str, message: str) -> None:
    with pytest.raises(Unsolvable, match=message):
        solve(text)


LETS_GO = {  # complete scenes in which something that only pushes or pulls would have to do the opposite on the way
    "base": """
surfaces: {floor: level}
bodies: {cart: {mass: 1 kg, moves: right}, arm: {shape: rod, mass: 3 kg, length: 1 m}}
connections: {base: {contact: [cart, floor]}, pin: {hinge: [cart, arm.start]}}
states: {start: {arm.angle: 0, arm.angular_velocity: 12 rad/s, cart.velocity: 0}, end: {time: 0.3 s}}
find: {w: arm.angular_velocity at end}
""",
    "cord": """
bodies: {ring: {shape: ring, mass: 4 kg, radius: 50 cm, moves: up}, plate: {shape: rectangle, mass: 2 kg, sides: [80 cm, 40 cm]}}
connections: {cord: {string: [ring, ceiling]}, joint: {hinge: [ring.top, plate.center]}}
actions: {twist: {couple: 8 N m, on: ring}}
states: {start: {plate.angle: -40 deg, at rest: all}, end: {ring.displacement: 1.5 m}}
find: {a: ring.acceleration at end}
""",
}


@pytest.mark.parametrize("name", LETS_GO)
def test_what_lets_go_on_the_way_is_named_and_the_data_are_not_blamed(name: str) -> None:
    with pytest.raises(Unsolvable) as refused:
        solve(f"title: {name}{LETS_GO[name]}")
    assert f"`{name}` lets go on the way from `start` to `end`" in refused.value.fault.message
    assert refused.value.fault.kind in (
        UNSOLVED,
        "unsolvable",
    )  # not that the scene is incomplete, or contradicts itself


def test_words_of_one_body_and_of_a_bounce_that_are_not_solved() -> None:
    """Two hinges on one body are no two bodies; friction between what bounces is refused, and not left out."""
    rod = "title: Rod\nbodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}, ball: {mass: 1 kg, moves: right}}\n"
    pins = (
        "connections: {pin: {hinge: rod.start}, nail: {hinge: rod.end}}\nstates: {now: {rod.angle: 0, at rest: all}}\n"
    )
    with pytest.raises(Unsolvable, match="`rod` is a body that `nail` and another support hold at two points"):
        solve(f"{rod}{pins}find: {{F: pin.force.y at now}}")
    hit = (
        "connections: {pin: {hinge: rod.start}}\n"
        "states: {before: {rod.angle: -90 deg, at rest: rod, ball.velocity: 3 m/s}, after: {}}\n"
        "events: {hit: {collides: [ball, rod.end], restitution: 0.5, friction: 0.3, from: before, to: after}}\n"
    )
    with pytest.raises((SceneError, Unsolvable), match="friction of two bodies in `hit` is not solved yet"):
        solve(f"{rod}{hit}find: {{w: rod.angular_velocity at after}}")


VERGES = {  # a letter that is asked for where something is on the verge, and the scene
    "kappa": """
given: {M: 2 kg, L: 1 m, kappa: UNIT}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}, wire: {torsion: rod, stiffness: kappa, rest_angle: 90 deg}}
states: {up: {rod.angle: 90 deg, balance: true}}
find: {k: smallest kappa where up is stable}
""",
    "mu": """
given: {M: 2 kg, mu: UNIT}
surfaces: {ramp: {slope: 20 deg}}
bodies: {box: {mass: M, moves: down}}
connections: {base: {contact: [box, ramp], friction: mu}}
states: {now: {at rest: all}}
find: {k: smallest mu where base sticks}
""",
}


@pytest.mark.parametrize("letter", VERGES)
def test_the_verge_of_a_letter_that_is_given_is_asked_for_as_the_help_says(letter: str) -> None:
    scene = f"title: On the verge{VERGES[letter]}"
    for unit in ("N m/rad", "30 N m/rad") if letter == "kappa" else ("number", "0.3"):
        with pytest.raises(
            Unsolvable, match=f"`{letter}` is given, so that no smallest value of it is looked for"
        ) as refused:
            solve(scene.replace("UNIT", unit))
        assert f"`{letter}: unknown`" in refused.value.fault.help
    assert solve(scene.replace("UNIT", "unknown")).answers["k"].float > 0


UNTOLD = {  # contacts beside which something else carries the body as well, so that nothing tells how hard they are pressed
    "guide": (
        "cart: {mass: 10 kg, moves: SIDE}, wheel: {shape: disc, mass: 2 kg, radius: 0.3 m, turns: TURN}",
        "ax: {axle: [cart, wheel]}, touch: {contact: [wheel, floor], friction: 0.1}",
        "{couple: 100 N m, on: wheel, direction: TURN}",
        "cart",
    ),
    "second contact": (
        "cart: {mass: 10 kg, moves: SIDE}, wheel: {shape: disc, mass: 2 kg, radius: 0.3 m, turns: TURN}",
        "base: {contact: [cart, floor]}, ax: {axle: [cart, wheel]}, touch: {contact: [wheel, floor], friction: 0.1}",
        "{couple: 100 N m, on: wheel, direction: TURN}",
        "cart",
    ),
    "string": (
        "block: {mass: 2 kg, moves: SIDE}",
        "touch: {contact: [block, floor], friction: 0.1}, cord: {string: [ceiling, block]}",
        "{force: 50 N, on: block, direction: SIDE}",
        "block",
    ),
}


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize("kind", UNTOLD)
def test_that_nothing_tells_whether_something_slips_is_said(kind: str, side: str) -> None:
    bodies, links, action, asked = UNTOLD[kind]
    scene = f"""
title: Nothing tells how hard it is pressed
surfaces: {{floor: level}}
bodies: {{{bodies}}}
connections: {{{links}}}
actions: {{push: {action}}}
states: {{start: {{at rest: all}}}}
find: {{a: {asked}.acceleration at start}}
""".replace("SIDE", side).replace("TURN", "clockwise" if side == "right" else "counterclockwise")
    with pytest.raises(Unsolvable, match=r"whether friction holds .* from `start` on is not told") as refused:
        solve(scene)
    assert refused.value.fault.kind == UNSOLVED


def test_what_is_read_of_a_body_is_not_lost_on_the_way_to_a_help() -> None:
    """Records that note what of them is read are compared with what they hold beside their slots."""
    with pytest.raises(Unsolvable, match="too little is known to find `y`") as refused:
        solve("""
        plane: horizontal
        given: {m: 6 kg, R: 1 m, M: 3 kg, F: 19 N, v: 4 m/s}
        bodies: {one: {mass: m, moves: right}, two: {shape: disc, mass: M, radius: R}}
        connections: {bolt: {weld: [one, two.bottom]}}
        actions: {push: {force: F, on: one, direction: left, from: start, to: end}}
        states: {start: {one.velocity: -v}, end: {one.velocity: 0}}
        find: {y: bolt.torque at end}
        """)
    assert "say more about the state" in refused.value.fault.help


@pytest.mark.parametrize("word", ["sticks", "rolls"])
@pytest.mark.parametrize("friction", ["", ", friction: none"], ids=["left out", "none"])
def test_nothing_sticks_without_friction(word: str, friction: str) -> None:
    """What is said to hold where nothing rubs is refused by that name, whatever is asked."""
    scene = f"""
given: {{v: 3 m/s}}
surfaces: {{floor: level}}
bodies: {{wheel: {{shape: disc, mass: 2 kg, radius: 1 m, moves: right}}}}
connections: {{under: {{contact: [wheel, floor]{friction}}}}}
states: {{start: {{wheel.velocity: v}}, end: {{under: {word}}}}}
find: {{a: wheel.acceleration at end}}
"""
    with pytest.raises(Unsolvable, match=f"`under` has no friction: nothing {word} there"):
        solve(scene)


SUMS = {  # over a blow, and of one of several forces: what is told, and what is refused because it would be another sum
    "the work of all forces in a blow": (
        "hit: {impulse: 4 N s, on: b, direction: right, from: s, to: a}",
        "W: b.work during hit",
        "the work done on `b` in a blow is not solved yet",
    ),
    "the same, over the blow and what follows": (
        "hit: {impulse: 4 N s, on: b, direction: right, from: s, to: a}",
        "W: b.work.net from s to a",
        "the work done on `b` in a blow is not solved yet",
    ),
}
STRUCK_BLOCK = """
surfaces: {{ice: level}}
bodies: {{b: {{mass: 2 kg, moves: right}}}}
connections: {{base: {{contact: [b, ice]}}}}
states: {{s: {{b.velocity: 3 m/s}}, a: {{}}}}
events: {{{event}}}
find: {{{question}}}
"""


@pytest.mark.parametrize(("event", "question", "message"), SUMS.values(), ids=SUMS)
def test_sums_that_are_not_told_are_refused(event: str, question: str, message: str) -> None:
    with pytest.raises(Unsolvable, match=message):
        solve("title: struck" + STRUCK_BLOCK.format(event=event, question=question))


def test_the_impulse_of_a_belt_over_a_phase_is_no_nothing() -> None:
    with pytest.raises(Unsolvable, match="the impulse of `strap`, which turns `b` alone, is not solved yet"):
        solve(
            "title: belt\nbodies: {a: {inertia: 1 kg m^2, radius: 10 cm}, b: {inertia: 2 kg m^2, radius: 30 cm}}\n"
            "connections: {x: {axle: a}, y: {axle: b}, strap: {belt: [a, b]}}\nactions: {mot: {couple: 2 N m, on: a}}\n"
            "states: {s: {a.angular_velocity: 3 rad/s}, e: {time: 4 s}}\nfind: {q: strap.impulse from s to e}\n"
        )


def test_the_work_on_a_body_of_one_force_is_not_that_of_all() -> None:
    """μ m g d, F d and their sum, and the mean power of the friction."""
    found = solve("""title: pulled
given: {m: 2 kg, F: 30 N, mu: 0.2, d: 3 m}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}}
actions: {pull: {force: F, on: block, direction: right}}
states: {start: at rest, end: {block.displacement: d}}
find:
  W: block.work.base from start to end
  W2: block.work.pull from start to end
  N: block.work.net from start to end
  P: mean block.power.base from start to end
""")
    rub = -0.2 * 2 * 9.8 * 3
    took = math.sqrt(2 * 3 / ((30 - 0.2 * 2 * 9.8) / 2))
    assert [found[name].float for name in ("W", "W2", "N", "P")] == pytest.approx([rub, 90, 90 + rub, rub / took])


def test_the_work_on_a_body_of_what_acts_on_several_is_refused() -> None:
    with pytest.raises(Unsolvable, match="the work of `rope` on `a` alone is not solved yet"):
        solve(
            "title: pair\nbodies: {a: {mass: 1 kg, moves: up}, b: {mass: 2 kg, moves: down}, "
            "wheel: {shape: disc, mass: 1 kg, radius: 1 m}}\n"
            "connections: {pin: {axle: wheel}, rope: {string: [a, wheel, b]}}\nstates: {s: at rest, e: {b.displacement: 1 m}}\n"
            "find: {W: a.work.rope from s to e}\n"
        )


def test_what_a_weld_does_to_one_of_two_alone_is_no_nothing() -> None:
    text = (
        "title: welded\nbodies: {one: {shape: rod, mass: 2 kg, length: 1 m}, two: {shape: rod, mass: 1 kg, length: 60 cm}}\n"
        "connections: {pin: {hinge: one.start}, bolt: {weld: [one.end, two.start]}}\n"
        "states: {now: {one.angle: 0, two.angle: 90 deg, one.angular_velocity: -2 rad/s}}\nfind: {q: QUESTION}\n"
    )
    for question in ("two.force.bolt", "two.torque.bolt", "one.power.bolt"):
        with pytest.raises(Unsolvable, match=r"what `bolt` does to `(one|two)` alone is not solved yet"):
            solve(text.replace("QUESTION", question))


def test_means_over_no_time_and_of_what_has_no_turn_of_its_own() -> None:
    struck = STRUCK_BLOCK.format(
        event="hit: {impulse: 4 N s, on: b, direction: right, from: s, to: a}",
        question="q: mean b.velocity from s to a",
    )
    with pytest.raises(Unsolvable, match=r"no time passes over which `b\.velocity` could have a mean"):
        solve("title: struck" + struck)
    with pytest.raises(Unsolvable, match=r"the mean of `ax\.angular_velocity` is not solved yet"):
        solve(
            "title: wheel\nbodies: {w: {inertia: 2 kg m^2}}\nconnections: {ax: {axle: w}}\nactions: {mot: {couple: 3 N m, on: w}}\n"
            "states: {s: at rest, a: {time: 2 s}}\nfind: {q: mean ax.angular_velocity from s to a}\n"
        )


def test_a_rate_without_a_zero_has_its_least_energy_between_the_ends() -> None:
    """v = 5 − t + 3 t²/4 has no zero, and is least at t = 2/3 s."""
    found = solve(
        "title: pulled\nsurfaces: {floor: level}\nbodies: {b: {mass: 2 kg, moves: right}}\nconnections: {base: {contact: [b, floor]}}\n"
        "given: {c: 3 N/s, F: 2 N}\nactions: {pull: {force: c*time - F, on: b, direction: right}}\n"
        "states: {s: {b.velocity: 5 m/s}, e: {time: 2 s}}\nfind: {K: smallest b.kinetic_energy from s to e}\n"
    )
    assert found["K"].float == pytest.approx((5 - 1 / 3) ** 2)


def test_the_way_of_a_contact_in_a_blow_and_a_swing_in_space_at_any_time_are_no_internal_errors() -> None:
    struck = STRUCK_BLOCK.format(
        event="hit: {impulse: 4 N s, on: b, direction: right, from: s, to: a}",
        question="q: base.displacement during hit",
    )
    assert solve("title: struck" + struck)["q"].float == 0
    with pytest.raises(Unsolvable, match="`v` is not solved by these laws"):
        solve(
            "title: swing\nup: z\nbodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}\nconnections: {pin: {hinge: rod.start, along: y}}\n"
            "states: {s: {rod.angle: 0 deg, rod.angular_velocity: 0 rad/s}, e: {rod.angle: 90 deg}}\nfind: {v: rod.speed at any time}\n"
        )
