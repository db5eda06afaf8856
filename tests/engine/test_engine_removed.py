"""A body that is taken away leaves all that touched it: the others go on without its weight, its rope, its hinge."""

from __future__ import annotations

from math import cos, pi, sin, sqrt

import pytest

from rotsolve.pipeline import solve

G, M, m, n, L, R, k, d, u = 9.8, 3.0, 2.0, 4.0, 1.0, 0.5, 50.0, 0.4, 3.0
GIVEN = "title: x\ngiven: {M: 3 kg, m: 2 kg, n: 4 kg, L: 1 m, R: 50 cm, k: 50 N/m, d: 40 cm, Q: 3 N m, w: 2 rad/s, u: 3 m/s}\n"
ROD, LOAD = "rod: {shape: rod, mass: M, length: L}", "load: {mass: m}"
DISC = "{shape: disc, mass: MASS, radius: R}"

FALLEN = sqrt(2 * (M / 2 + m) * G * sin(pi / 4) / (M / 3 + m))
LOW = sqrt(FALLEN**2 + 3 * G * (1 - sin(pi / 4)))
STUCK = m * u / (M / 3 + m)
CASES = {  # by what held the body: bodies, connections and more, states up to the one before, the body, states after, true values
    "a weld": (
        f"bodies: {{{ROD}, {LOAD}}}",
        "pin: {hinge: rod.start}, coil: {spring: [ground, rod.at(d)], stiffness: k}, glue: {weld: [rod.end, load]}",
        "now: {rod.angle: 0, balance: true}", "load", "",
        {"rod.angular_acceleration at off": 3 * m * G / (M * L),
         "pin.force.y at off": M * G + M * 3 * m * G / M / 2 - (M / 2 + m) * G * L / d,
         "coil.elongation at now": -(M / 2 + m) * G * L / (k * d)},
    ),
    "a weld, in motion": (
        f"bodies: {{{ROD}, {LOAD}}}", "pin: {hinge: rod.start}, glue: {weld: [rod.end, load]}",
        "start: {rod.angle: 0, at rest: all}, now: {rod.angle: -45 deg}", "load", "end: {rod.angle: -90 deg}",
        {"rod.angular_velocity at now": -FALLEN, "rod.angular_velocity at end": -LOW,
         "kinetic_energy at off": M / 6 * FALLEN**2, "kinetic_energy at end": M / 6 * LOW**2},
    ),
    "a string": (
        f"bodies: {{disc: {DISC.replace('MASS', 'M')}, one: {{mass: m, moves: down}}, two: {{mass: n, moves: down}}}}",
        "axle: {axle: disc}, first: {string: [disc.rim, one]}, second: {string: [disc.rim, two]}",
        "start: {at rest: all}, now: {time: 1 s}", "one", "end: {time: 1 s}",
        {"two.acceleration at off": n * G / (n + M / 2), "second.tension at off": n * G * M / 2 / (n + M / 2),
         "two.velocity at end": (m + n) * G / (m + n + M / 2) + n * G / (n + M / 2)},
    ),
    "a hinge": (
        f"bodies: {{{ROD}, next: {{shape: rod, mass: m, length: L}}}}", "pin: {hinge: rod.start}, joint: {hinge: [rod.end, next.start]}",
        "now: {rod.angle: 0, next.angle: 0, at rest: all}", "next", "",
        {"rod.angular_acceleration at off": -1.5 * G / L, "pin.force.y at off": M * G / 4},
    ),
    "a contact": (
        "surfaces: {ice: level}\nactions: {push: {force: 10 N, on: cart, direction: right}}\n"
        "bodies: {cart: {mass: M, moves: right}, puck: {mass: m, moves: right}}",
        "low: {contact: [cart, ice]}, high: {contact: [puck, cart], friction: any}", "now: {at rest: all}", "puck", "",
        {"cart.acceleration at now": 10 / (M + m), "cart.acceleration at off": 10 / M, "low.normal_force at off": M * G},
    ),
    "an axle that it shares": (
        f"actions: {{push: {{couple: Q, on: a}}}}\nbodies: {{a: {DISC.replace('MASS', 'M')}, b: {DISC.replace('MASS', 'm')}}}",
        "x: {axle: [b, a]}", "now: {a.angular_velocity: w, b.angular_velocity: w}", "b", "",
        {"a.angular_acceleration at off": 3 / (M * R**2 / 2), "kinetic_energy at off": M * R**2 / 4 * 4, "x.force at off": M * G},
    ),
    "a spring": (
        f"bodies: {{block: {{mass: M, moves: up}}, {LOAD}}}", "s: {spring: [ceiling, block], stiffness: k}, glue: {weld: [block, load]}",
        "now: {balance: true}", "load", "", {"block.acceleration at off": m * G / M, "s.elongation at now": (M + m) * G / k},
    ),
}  # fmt: skip
SCENE = "{bodies}\nconnections: {{{more}}}\nstates: {{{before}, off: {{}}{after}}}\n"
SCENE += "events: {{gone: {{removes: {body}, from: now, to: off}}}}\n"


@pytest.mark.parametrize(("bodies", "more", "before", "body", "after", "true"), CASES.values(), ids=CASES)
def test_what_is_taken_away_holds_nothing_any_more(
    bodies: str, more: str, before: str, body: str, after: str, true: dict[str, float]
) -> None:
    text = GIVEN + SCENE.format(bodies=bodies, more=more, before=before, body=body, after=after and ", " + after)
    questions = {f"q{number}": path for number, path in enumerate(true)}
    answers = solve(text + f"find: {{{', '.join(f'{name}: {path}' for name, path in questions.items())}}}\n").answers
    for name, path in questions.items():
        assert answers[name].float == pytest.approx(true[path], abs=1e-12), path


def test_what_stuck_may_be_taken_off_again() -> None:
    """What an event joined and another one removes: the rod goes on as fast, without the mass."""
    text = GIVEN + f"bodies: {{{ROD}, clay: {{mass: m, moves: right}}}}\nconnections: {{pin: {{hinge: rod.start}}}}\n"
    text += "states: {before: {rod.angle: -90 deg, at rest: rod, clay.velocity: u}, after: {}, off: {}, top: {rod.angle: -60 deg}}\n"
    text += (
        "events: {hit: {joins: [clay, rod.end], from: before, to: after}, cut: {removes: clay, from: after, to: off}}\n"
    )
    answers = solve(text + "find: {A: rod.angular_velocity at off, B: rod.angular_velocity at top}\n").answers
    assert answers["A"].float == pytest.approx(STUCK)
    assert answers["B"].float == pytest.approx(sqrt(STUCK**2 - 3 * G / L * (1 - cos(pi / 6))))


@pytest.mark.parametrize(("gone", "lump"), [("pin", 0.0), ("pin", 1.0), ("axle", 0.0)])
def test_what_is_let_go_of_its_axis_goes_on_as_its_centre_went(gone: str, lump: float) -> None:
    """ω² = 2 S g sin 50°/I with S = M L/2 + m L, I = M L²/3 + m L²; the centre, S/(M + m) from the pin, has ω times that across the rod."""
    weld = "\nbodies: {rod: {shape: rod, mass: M, length: L}, lump: {mass: m}}\nconnections: {glue: {weld: [rod.end, lump]}, "
    bare = "\nbodies: {rod: {shape: rod, mass: M, length: L}}\nconnections: {"
    held = "hinge" if gone == "pin" else "axle"
    whole = "M*(rod.cm.velocity.END)" + (" + m*(lump.velocity.END)" if lump else "")
    text = (
        f"given: {{M: 3 kg, {'m: 1 kg, ' if lump else ''}L: 1 m, T: 0.2 s}}{weld if lump else bare}{gone}: {{{held}: rod.start}}}}\n"
        "states: {start: {rod.angle: 0, at rest: all}, low: {rod.angle: -50 deg}, free: {}, later: {time: T}}\n"
        f"events: {{off: {{removes: {gone}, from: low, to: free}}}}\n"
        "find: {w: rod.angular_velocity at free, W: rod.angular_velocity at later, "
        f"x: {whole.replace('END', 'x at free')}, y: {whole.replace('END', 'y at free')}, Y: {whole.replace('END', 'y at later')}}}"
    )
    solution = solve(text, digits=10)
    assert all(item.holds for item in solution.derivation.confirmed)
    moment, inertia, angle = M / 2 + lump, M / 3 + lump, 5 * pi / 18
    rate = -sqrt(2 * moment * G * sin(angle) / inertia)
    momentum = [rate * moment * sin(angle), rate * moment * cos(angle)]
    true = [rate, *momentum, rate, momentum[1] - (M + lump) * G * 0.2]
    assert [float(solution.answers[name].value or 0) for name in ("w", "x", "y", "W", "Y")] == pytest.approx(true)


@pytest.mark.parametrize(
    ("told", "turned"), [("rod.rotation: -180 deg", pi), ("rod.angle: -270 deg", pi), ("rod.rotation: -90 deg", pi / 2)]
)
def test_a_rod_let_go_at_its_lowest_turns_on_at_its_rate(told: str, turned: float) -> None:
    """Let go level it has ω = √(3 g/L), which stays: the time is turned/ω, and its centre falls ½ g t²."""
    text = (
        "given: {M: 3 kg, L: 1 m}\nbodies: {rod: {shape: rod, mass: M, length: L}}\nconnections: {pin: {hinge: rod.start}}\n"
        f"states: {{start: {{rod.angle: 0, at rest: all}}, low: {{rod.angle: -90 deg}}, free: {{}}, end: {{{told}}}}}\n"
        "events: {off: {removes: pin, from: low, to: free}}\nfind: {t: time from free to end, d: rod.displacement.y from free to end}"
    )
    solution = solve(text, digits=10)
    time = turned / sqrt(3 * G)
    assert [float(solution.answers[name].value or 0) for name in ("t", "d")] == pytest.approx([time, -G * time**2 / 2])
    assert all(item.holds for item in solution.derivation.confirmed)
