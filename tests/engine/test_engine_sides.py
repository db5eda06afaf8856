"""Sides of bodies: what slides or rolls on a slope, in a bowl or on a dome that goes with its body, held against linear equations and the
conserved quantities by hand."""

from __future__ import annotations

from itertools import product
from math import asin, cos, degrees, pi, radians, sin, sqrt

import numpy
import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

G, M, m, B, R = 9.8, 3.0, 1.0, radians(30), 0.5
GIVEN = "title: x\ngiven: {M: 3 kg, m: 1 kg, beta: 30 deg, R: 50 cm, r: 5 cm, h: 40 cm, MORE}\n"
WEDGE = (
    GIVEN + "surfaces: {floor: level, ramp: {slope: beta, down: DOWN, of: wedge}}\n"
    "bodies: {wedge: {mass: M, moves: MOVES}, block: {SHAPE mass: m}}\n"
    "connections: {base: {contact: [wedge, floor]BASE}, slide: {TOUCH: [block, ramp]RUBS}}\nACTIONS"
)
PLAIN = {
    "MORE": "F: 1 N", "DOWN": "right", "MOVES": "right", "SHAPE": "", "BASE": "", "TOUCH": "contact", "RUBS": "", "ACTIONS": "",
}  # fmt: skip
BOWL = (
    GIVEN
    + "surfaces: {floor: level, curve: {CURVE: R, of: cart}}\nbodies: {cart: {mass: M, moves: MOVES}, bead: {mass: m}}\n"
    "connections: {base: {contact: [cart, floor]}, slide: {contact: [bead, curve]}}\n"
)


def scene(text: str, tail: str, **changes: str) -> str:
    for word, value in (PLAIN | changes).items():
        text = text.replace(word, value)
    return text + tail


def numbers(text: str) -> dict[str, float]:
    solution = solve(text)
    assert not solution.refused, solution.refused
    assert "confirmed with numbers" in " ".join(str(solution).split()), str(solution)
    return {name: float(answer.value) for name, answer in solution.answers.items()}


def on_wedge(side: int, mu: float, floor: float = 0.0, turning: float = 0.0, push: float = 0.0) -> dict[str, float]:
    """A to the right, w down the slope as seen from the wedge, N, by Newton's laws as linear equations; side +1 where it falls to the
    right; turning is I/(m r²) of what rolls, else it rubs with μ; the floor with its own, against the way of the wedge."""
    out, down = numpy.array([side * sin(B), cos(B)]), numpy.array([side * cos(B), -sin(B)])
    way = numpy.sign(push) or -side
    rows, right = numpy.zeros((6, 6)), numpy.zeros(6)  # of A, a_x, a_y, w, N, N of the floor; friction f up the slope
    per_normal, per_rate = (0.0, turning * m) if turning else (mu, 0.0)
    for k in (0, 1):
        rows[k, 1 + k] = -m
        rows[k, 4] = out[k] - per_normal * down[k]
        rows[k, 3] = -per_rate * down[k]
        right[k] = m * G * k
    rows[2] = [-M, 0, 0, per_rate * down[0], -out[0] + per_normal * down[0], -floor * way]
    right[2] = -push
    rows[3] = [0, 0, 0, per_rate * down[1], -out[1] + per_normal * down[1], 1]
    right[3] = M * G
    for k in (0, 1):
        rows[4 + k, 1 + k], rows[4 + k, 3] = -1, down[k]
        rows[4 + k, 0] = 1 - k
    found = numpy.linalg.solve(rows, right)
    return dict(zip(("A", "x", "y", "w", "N"), map(float, found), strict=False))


FINDS = "A: wedge.acceleration at s, x: block.acceleration.x at s, y: block.acceleration.y at s, "
FINDS += "w: slide.acceleration at s, N: slide.normal_force at s"
CASES = {
    "smooth": ({}, {}),
    "rough side": ({"RUBS": ", friction: 0.2"}, {"mu": 0.2}),
    "rough floor": ({"BASE": ", friction: 0.05"}, {"floor": 0.05}),
    "both rough": ({"RUBS": ", friction: 0.2", "BASE": ", friction: 0.05"}, {"mu": 0.2, "floor": 0.05}),
    "a cylinder": ({"TOUCH": "rolls", "SHAPE": "shape: cylinder, radius: r,"}, {"turning": 0.5}),
    "a hoop": ({"TOUCH": "rolls", "SHAPE": "shape: ring, radius: r,"}, {"turning": 1.0}),
    "a ball on a rough floor": (
        {"TOUCH": "rolls", "SHAPE": "shape: sphere, radius: r,", "BASE": ", friction: 0.02"},
        {"turning": 0.4, "floor": 0.02},
    ),
}  # fmt: skip


@pytest.mark.parametrize(("case", "down", "moves"), list(product(CASES, ("left", "right"), ("left", "right"))))
def test_on_a_wedge_that_is_free(case: str, down: str, moves: str) -> None:
    changes, said = CASES[case]
    text = scene(WEDGE, f"states: {{s: at rest}}\nfind: {{{FINDS}}}\n", DOWN=down, MOVES=moves, **changes)
    right = on_wedge(1 if down == "right" else -1, **{"mu": 0.0, **said})
    expected = right | {"A": right["A"] * (1 if moves == "right" else -1)}
    assert numbers(text) == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize("push", [4.0, -4.0])
def test_a_wedge_that_is_pushed(push: float) -> None:
    actions = f"actions: {{push: {{force: {push} N, on: wedge, direction: right}}}}\n"
    text = scene(WEDGE, f"states: {{s: at rest}}\nfind: {{{FINDS}}}\n", ACTIONS=actions)
    assert numbers(text) == pytest.approx(on_wedge(1, 0.0, push=push), rel=2e-3)


def test_the_speeds_below_are_those_of_energy_and_momentum() -> None:
    """m v = M V, and m g h = ½ m v² + ½ M V² with the side kept; the wedge has gone by m/(M + m) of the way on it."""
    tail = "states: {s: at rest, e: {block.displacement.y: -h}}\nfind: {V: wedge.velocity at e, "
    tail += "X: wedge.displacement from s to e, s1: slide.displacement from s to e}\n"
    found = numbers(scene(WEDGE, tail, MOVES="left"))
    sliding = sqrt(2 * G * 0.4 * (M + m) / (M + m * sin(B) ** 2))
    assert found["V"] == pytest.approx(m * sliding * cos(B) / (M + m), rel=1e-3)
    assert found["X"] == pytest.approx(m * 0.4 / numpy.tan(B) / (M + m), rel=1e-3)
    assert found["s1"] == pytest.approx(0.4 / sin(B), rel=1e-3)


@pytest.mark.parametrize(("word", "sign"), [("largest", 1), ("smallest", -1)])
def test_it_is_kept_by_an_acceleration_or_a_push(word: str, sign: int) -> None:
    """The force on it leans by β ± arctan μ."""
    lean = numpy.tan(B + sign * numpy.arctan(0.3))
    states = "states: {s: at rest}\n"
    driven = scene(
        WEDGE, states + f"find: {{a: {word} a where slide sticks}}\n", RUBS=", friction: 0.3", MORE="a: unknown"
    )
    driven = driven.replace("moves: right", "acceleration: [a, 0]")
    assert numbers(driven)["a"] == pytest.approx(G * lean, rel=1e-3)
    push = "actions: {push: {force: F, on: wedge, direction: right}}\n"
    pushed = scene(
        WEDGE,
        states + f"find: {{F: {word} F where slide sticks}}\n",
        RUBS=", friction: 0.3",
        MORE="F: unknown",
        ACTIONS=push,
    )
    assert numbers(pushed)["F"] == pytest.approx((M + m) * G * lean, rel=1e-3)


PLACES = [("hollow", 180, 240), ("hollow", 0, -60), ("hollow", 200, 290), ("dome", 90, 60), ("dome", 90, 120)]
PLACES += [("wire", 90, -20), ("wire", 90, 200)]


@pytest.mark.parametrize(("place", "moves"), list(product(PLACES, ("left", "right"))))
def test_on_a_round_side(place: tuple[str, int, int], moves: str) -> None:
    """φ̇ by energy with the momentum that is conserved, N by the acceleration to the middle, the way of the cart by the centre of mass."""
    curve, first, last = place
    p, q, sense = radians(first), radians(last), 1 if moves == "right" else -1
    tail = f"states: {{s: {{slide.angle: {first} deg, at rest: all}}, e: {{slide.angle: {last} deg}}}}\n"
    tail += "find: {V: cart.velocity at e, v: bead.velocity.x at e, X: cart.displacement from s to e, N: slide.normal_force at e}\n"
    rate = sqrt(2 * m * G * R * (sin(p) - sin(q)) / (m - m**2 * sin(q) ** 2 / (M + m))) / R * (1 if q > p else -1)
    cart = m * R * rate * sin(q) / (M + m)
    towards = m * (R * rate**2 - G * sin(q)) / (1 + m / M * cos(q) ** 2)  # A = −N cos q/M acts on the bead as well
    expected = {
        "V": sense * cart,
        "v": cart - R * rate * sin(q),
        "X": -sense * m * R * (cos(q) - cos(p)) / (M + m),
        "N": -towards if curve == "dome" else towards,
    }
    found = numbers(scene(BOWL, tail, CURVE=curve, MOVES=moves))
    assert found == pytest.approx(expected, rel=2e-3, abs=1e-9)


@pytest.mark.parametrize("heavy", ["M", "2*m", "m", "m/2"])
def test_where_it_leaves_a_free_dome(heavy: str) -> None:
    """m c³ − 3 (M + m) c + 2 (M + m) = 0, c the cosine of the angle from the upright; V with u² = g R c."""
    mass = {"M": 3.0, "2*m": 2.0, "m": 1.0, "m/2": 0.5}[heavy]
    tail = "states: {s: {slide.angle: 90 deg, at rest: all}, e: {slide: leaves}}\n"
    tail += "find: {phi: slide.angle at e in deg, V: cart.velocity at e}\n"
    text = scene(BOWL, tail, CURVE="dome", MOVES="left").replace("cart: {mass: M", f"cart: {{mass: {heavy}")
    c = next(float(x.real) for x in numpy.roots([m, 0, -3 * (mass + m), 2 * (mass + m)]) if 0 < x.real < 1)
    assert numbers(text) == pytest.approx(
        {"phi": degrees(asin(c)), "V": m * c * sqrt(G * R * c) / (mass + m)}, rel=2e-3
    )


@pytest.mark.parametrize("speed", [2.0, -2.0])
def test_how_high_it_comes_in_a_free_bowl(speed: float) -> None:
    """There it goes with the cart; to the left it comes to the other root."""
    tail = f"states: {{s: {{slide.angle: -90 deg, slide.velocity: {speed} m/s, cart.velocity: 0}}, e: {{slide.velocity: 0}}}}\n"
    tail += "find: {phi: slide.angle at e, V: cart.velocity at e}\n"
    phi = asin(speed**2 * M / (M + m) / (2 * G * R) - 1)
    expected = {"phi": phi if speed > 0 else -pi - phi, "V": speed * m / (M + m)}
    assert numbers(scene(BOWL, tail, CURVE="hollow")) == pytest.approx(expected, rel=1e-3)


def test_where_it_leaves_a_free_dome_with_a_speed_is_refused() -> None:
    """Its equation holds u and u² at once, and no law here tells one of them."""
    tail = "states: {s: {slide.angle: 90 deg, slide.velocity: 1 m/s, cart.velocity: 0}, e: {slide: leaves}}\n"
    with pytest.raises(Unsolvable, match="`phi` is not solved by these laws"):
        solve(scene(BOWL, tail + "find: {phi: slide.angle at e in deg}\n", CURVE="dome"))


def test_a_box_on_a_truck_of_told_acceleration() -> None:
    """It needs no road; one that rises too is no level to lie on."""
    truck = (
        "title: x\ngiven: {m: 2 kg, mu: 0.3, a: ASKED}\n"
        "bodies: {truck: {mass: 10 kg, acceleration: [a, UP]}, box: {mass: m, moves: right}}\n"
        "connections: {grip: {contact: [box, truck], friction: mu}}\nstates: {start: at rest}\nfind: {x: WHAT}\n"
    )
    told = truck.replace("ASKED", "2 m/s^2").replace("WHAT", "grip.friction_force").replace("UP", "0")
    assert numbers(told) == pytest.approx({"x": 4.0})
    sought = truck.replace("ASKED", "unknown").replace("x: WHAT", "a: largest a where grip sticks").replace("UP", "0")
    assert numbers(sought) == pytest.approx({"a": 0.3 * G})
    with pytest.raises(Unsolvable, match="nothing tells on what `truck`"):
        solve(told.replace("[a, 0]", "[a, 1 m/s^2]"))


def test_a_block_on_a_plank_that_is_only_guided() -> None:
    text = (
        "title: x\ngiven: {M: 3 kg, m: 1 kg, F: 4 N}\nbodies: {plank: {mass: M, moves: right}, block: {mass: m, moves: right}}\n"
        "connections: {grip: {contact: [block, plank], friction: 0.3}}\nactions: {pull: {force: F, on: plank}}\n"
        "states: {start: at rest}\nfind: {a: block.acceleration, N: grip.normal_force}\n"
    )
    assert numbers(text) == pytest.approx({"a": 1.0, "N": m * G}, rel=1e-3)


LIFT = GIVEN.replace("MORE", "a: A0") + (
    "surfaces: {ramp: {slope: beta, of: lift}}\nbodies: {lift: {mass: M, moves: up, acceleration: [0, a]}, block: {mass: m}}\n"
    "connections: {slide: {contact: [block, ramp]}}\nstates: {s: at rest}\nfind: {N: slide.normal_force, w: slide.acceleration}\n"
)


def test_in_a_lift() -> None:
    assert numbers(LIFT.replace("A0", "2 m/s^2")) == pytest.approx(
        {"N": m * (G + 2) * cos(B), "w": (G + 2) * sin(B)}, rel=1e-3
    )
    assert "leaves the surface" in str(solve(LIFT.replace("A0", "-12 m/s^2")))


def test_a_wedge_on_a_wedge() -> None:
    """Three bodies, two sides: A of the lower, by the equations of both contacts."""
    text = scene(WEDGE, "", MOVES="left").replace("of: wedge}}", "of: wedge}, top: {slope: 20 deg, of: block}}")
    text = text.replace("mass: m}}", "mass: m}, third: {mass: 2*m}}").replace(
        "[block, ramp]}}", "[block, ramp]}, upon: {contact: [third, top]}}"
    )
    found = numbers(text + "states: {s: at rest}\nfind: {A: wedge.acceleration, N: upon.normal_force}\n")
    g2, k = radians(20), 2 * m
    n1, n2 = (sin(B), cos(B)), (sin(g2), cos(g2))
    rows = numpy.array([  # A to the left, a_x, a_y of the block, b_x, b_y of the third, N1, N2
        [M, 0, 0, 0, 0, -n1[0], 0],
        [0, m, 0, 0, 0, -n1[0], n2[0]],
        [0, 0, m, 0, 0, -n1[1], n2[1]],
        [0, 0, 0, k, 0, 0, -n2[0]],
        [0, 0, 0, 0, k, 0, -n2[1]],
        [n1[0], n1[0], n1[1], 0, 0, 0, 0],
        [0, -n2[0], -n2[1], n2[0], n2[1], 0, 0],
    ])  # fmt: skip
    right = numpy.linalg.solve(rows, [0, 0, -m * G, 0, -k * G, 0, 0])
    assert found == pytest.approx({"A": right[0], "N": right[6]}, rel=1e-3)


UNDER = "base: {contact: [wedge, floor]BASE}"
PLATE = "wedge: {shape: rectangle, sides: [1 m, 1 m], mass: M}"
REFUSED = {
    "which turns": WEDGE.replace("wedge: {mass: M, moves: MOVES}", PLATE).replace(
        UNDER, "base: {hinge: wedge.corner1}"
    ),
    "nothing tells how `wedge`": WEDGE.replace("moves: MOVES", "").replace(UNDER + ", ", ""),
    "not just down": WEDGE.replace("SHAPE mass: m", "mass: m, moves: down"),
    "a side of `wedge`, is not solved yet": WEDGE.replace("SHAPE", "shape: rod, length: 1 m,"),
    "which lies on `ramp`, a side": WEDGE.replace("RUBS}}", "}, cord: {string: [block, ground]}}"),
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_is_not_solved_is_refused_by_name(words: str) -> None:
    text = scene(REFUSED[words], "states: {s: at rest}\nfind: {N: slide.normal_force}\n")
    with pytest.raises((Unsolvable, SceneError), match=words):
        solve(text)


@pytest.mark.parametrize("turns", ["", ", turns: counterclockwise", ", turns: clockwise"])
@pytest.mark.parametrize(("start", "way"), [(200, 1), (340, -1)])
def test_a_ball_that_rolls_down_a_free_bowl_spins_the_way_it_rolls(start: int, way: int, turns: str) -> None:
    """M V²/2 + m (V + u)²/2 + m u²/5 = m g (R − r) (1 − sin 20°), M V + m (V + u) = 0; to the right through the bottom it turns clockwise,
    which counts as positive unless the scene says otherwise."""
    solution = solve(f"""
    given: {{M: 3 kg, m: 1 kg, R: 50 cm, r: 5 cm}}
    surfaces: {{floor: level, bowl: {{hollow: R, of: block}}}}
    bodies: {{block: {{mass: M}}, ball: {{shape: sphere, mass: m, radius: r{turns}}}}}
    connections: {{under: {{contact: [block, floor]}}, touch: {{rolls: [ball, bowl]}}}}
    states: {{start: {{touch.angle: {start} deg, at rest: all}}, low: {{touch.angle: 270 deg}}}}
    find: {{w: ball.angular_velocity at low}}
    """)
    whole = 3 * (1 / 4) ** 2 / 2 + (3 / 4) ** 2 / 2 + 1 / 5
    u = sqrt(9.8 * 0.45 * (1 - sin(radians(20))) / whole)
    sense = -1 if "counter" in turns else 1
    assert solution.answers["w"].float == pytest.approx(sense * way * u / 0.05)
    assert all(item.holds for item in solution.derivation.confirmed)
