"""Borne on what is round, or leaning with its side: planks on rollers, rods on edges, cylinders on cylinders, by their own equations."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from rotsolve import solve
from rotsolve.core.faults import Unsolvable
from rotsolve.solution import Solution

G = 9.8
SHARES = {"ring": 1.0, "disc": 0.5, "sphere": 0.4}  # of m r² in a moment of inertia


def number(solution: Solution, name: str) -> float:
    return float(solution.answers[name].value)


def gauss(rows: list[list[float]]) -> list[float]:
    """The solution of linear equations, the right side last in each row."""
    left = [list(map(Fraction, row)) for row in rows]
    for k in range(len(left)):
        pivot = max(range(k, len(left)), key=lambda i: abs(left[i][k]))
        left[k], left[pivot] = left[pivot], left[k]
        left[k] = [part / left[k][k] for part in left[k]]
        for i, row in enumerate(left):
            if i != k:
                left[i] = [a - row[k] * b for a, b in zip(row, left[k], strict=True)]
    return [float(row[-1]) for row in left]


@pytest.mark.parametrize("shape", SHARES)
@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("beta", [0, 25])
def test_a_plank_on_rollers_moves_twice_as_fast_as_they(shape: str, count: int, beta: int) -> None:
    """(M + n (m + I/R²)/4) A = F + (M + n m/2) g sin β."""
    rollers = [f"r{k}: {{shape: {shape}, mass: 2 kg, radius: 10 cm, moves: down}}" for k in range(count)]
    under = [f"u{k}: {{rolls: [r{k}, ramp]}}" for k in range(count)]
    over = [f"o{k}: {{contact: [plank, r{k}], friction: any}}" for k in range(count)]
    surface = f"{{slope: {beta} deg}}" if beta else "level"
    scene = (
        f"surfaces: {{ramp: {surface}}}\n"
        f"bodies: {{plank: {{shape: rectangle, sides: [2 m, 5 cm], mass: 6 kg, moves: down}}, {', '.join(rollers)}}}\n"
        f"connections: {{{', '.join([*under, *over])}}}\nactions: {{pull: {{force: 12 N, on: plank}}}}\n"
        "states: {start: {at rest: all}}\nfind: {A: plank.acceleration, a: r0.acceleration, f: size of o0.friction_force}\n"
    )
    scene = scene.replace("moves: down", "moves: right") if not beta else scene
    found = solve(scene, digits=12)
    down = G * math.sin(math.radians(beta))
    expected = (12 + (6 + count * 2 / 2) * down) / (6 + count * 2 * (1 + SHARES[shape]) / 4)
    assert number(found, "A") == pytest.approx(expected)
    assert number(found, "a") == pytest.approx(expected / 2)
    assert number(found, "f") == pytest.approx(abs((6 * expected - 12 - 6 * down) / count), abs=1e-9)
    assert not any("not confirmed" in str(check) for check in found.checks)


@pytest.mark.parametrize("angle", [-50, -20, 0, 35])
@pytest.mark.parametrize("spin", [-2.0, 0.0, 3.0])
def test_a_rod_on_a_smooth_edge_is_pushed_square_to_itself(angle: int, spin: float) -> None:
    """M a = N n + M g, I α = N s, a · n + α s = 2 ω v · t, s from the middle to the edge."""
    long, mass, s, fast = 1.0, 2.0, -0.2, 0.4
    side = "left" if angle < 0 else "right"
    scene = (
        f"surfaces: {{edge: {{corner: 1 m, side: {side}}}}}\nbodies: {{rod: {{shape: rod, mass: 2 kg, length: 1 m}}}}\n"
        "connections: {touch: {contact: [rod.at(30 cm), edge]}}\n"
        f"states: {{now: {{rod.angle: {angle} deg, rod.angular_velocity: {spin} rad/s, rod.velocity.x: {fast} m/s}}}}\n"
        "find: {N: touch.normal_force, alpha: rod.angular_acceleration, x: rod.acceleration.x, y: rod.acceleration.y}\n"
    )
    c, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    upward = (-spin * s + fast * sine) / c  # of v · n = −ω s
    along = fast * c + upward * sine
    x, y, alpha, push = gauss(
        [
            [mass, 0, 0, sine, 0],
            [0, mass, 0, -c, -mass * G],
            [0, 0, mass * long**2 / 12, -s, 0],
            [-sine, c, s, 0, 2 * spin * along],
        ]
    )
    if push < 0:
        with pytest.raises(Unsolvable):
            solve(scene)
        return
    found = solve(scene, digits=12)
    for name, value in (("N", push), ("alpha", alpha), ("x", x), ("y", y)):
        assert number(found, name) == pytest.approx(value, abs=1e-9), name


@pytest.mark.parametrize("theta", [35, 60, 110])
@pytest.mark.parametrize("inside", [True, False])
def test_a_cylinder_on_a_rolling_one_goes_by_lagrange(theta: int, inside: bool) -> None:
    """T and V of both, x of the large one and φ of the line of centres, at rest: M q̈ = Q."""
    large, small, wide, thin = 4.0, 1.0, 0.3, 0.05
    share = 1.0 if inside else 0.5
    theta = -theta if inside else theta
    scene = (
        "surfaces: {floor: level}\n"
        f"bodies: {{big: {{shape: {'ring' if inside else 'disc'}, mass: 4 kg, radius: 30 cm, moves: right}}, "
        "small: {shape: disc, mass: 1 kg, radius: 5 cm}}\n"
        "connections: {base: {rolls: [big, floor]}, "
        f"touch: {{rolls: [small, big], inside: {str(inside).lower()}}}}}\n"
        f"states: {{now: {{touch.angle: {theta} deg, at rest: all}}}}\n"
        "find: {A: big.acceleration, alpha: small.angular_acceleration}\n"
    )
    c, s = math.cos(math.radians(theta)), math.sin(math.radians(theta))
    circle = wide - thin if inside else wide + thin
    # ω of the small one = p ẋ + q φ̇: its touching point goes along the rim as that of the large one does, ω = −ẋ/R
    p, q = (-1.0 / thin, -circle / thin) if inside else (1.0 / thin, circle / thin)
    spin = 0.5 * small * thin**2
    rows = [
        [large * (1 + share) + small + spin * p * p, -small * circle * s + spin * p * q, 0.0],
        [-small * circle * s + spin * p * q, small * circle**2 + spin * q * q, -small * G * circle * c],
    ]
    x, phi = gauss(rows)
    found = solve(scene, digits=12)
    assert number(found, "A") == pytest.approx(x)
    assert number(found, "alpha") == pytest.approx(p * x + q * phi)


def test_a_place_that_is_told_goes_with_the_height_of_the_edge() -> None:
    scene = (
        "given: {h: 1 m}\nsurfaces: {floor: level, wall: {corner: h, side: right}}\n"
        "bodies: {rod: {shape: rod, mass: 2 kg, length: 2 m}}\n"
        "connections: {foot: {contact: [rod.start, floor], friction: any}, lean: {contact: [PLACE, wall]}}\n"
        "states: {rest: {rod.angle: 45 deg, balance: true}}\nfind: {N: lean.normal_force}\n"
    )
    told, derived = (solve(scene.replace("PLACE", place), digits=12) for place in ("rod.at(sqrt(2)*h)", "rod"))
    assert number(told, "N") == pytest.approx(number(derived, "N")) == pytest.approx(2 * G * 0.5)
    with pytest.raises(Unsolvable, match="is not as high above its foot"):
        solve(scene.replace("PLACE", "rod.at(h)"))


def test_of_two_places_in_balance_that_is_taken_at_which_all_push() -> None:
    """A rod over a peg with its end at a wall: at −θ the balance of torques holds as well, and the wall would have to pull."""
    scene = (
        "given: {L: 80 cm, d: 5 cm, theta: unknown}\nsurfaces: {side: {wall: left}, peg: {corner: 1 m, side: right}}\n"
        "bodies: {rod: {shape: rod, mass: 2 kg, length: L}}\n"
        "connections: {end: {contact: [rod.start, side]}, lean: {contact: [rod.at(d/cos(theta)), peg]}}\n"
        "states: {rest: {rod.angle: theta, balance: true}}\nfind: {theta: theta in deg}\n"
    )
    assert number(solve(scene, digits=12), "theta") == pytest.approx(60)


@pytest.mark.parametrize("asked", ["bead.velocity.x", "bead.velocity.y", "hoop.velocity"])
@pytest.mark.parametrize("end", [-90, -60, -130])
@pytest.mark.parametrize(("start", "way"), [(-20, -1), (-160, 1)])
@pytest.mark.parametrize("moves", ["right", "left"])
def test_what_slides_in_a_free_hoop_goes_to_where_it_comes_next(
    asked: str, end: int, start: int, way: int, moves: str
) -> None:
    """Each alone: by energy and momentum u of the bead as seen from the hoop, along it the way in which its angle changes."""
    text = (
        "title: x\ngiven: {M: 1 kg, m: 200 g, R: 30 cm}\nsurfaces: {ice: level}\n"
        f"bodies: {{hoop: {{shape: ring, mass: M, radius: R, moves: {moves}}}, bead: {{shape: particle, mass: m}}}}\n"
        "connections: {base: {contact: [hoop, ice]}, touch: {contact: [bead, hoop], inside: true}}\n"
        f"states: {{high: {{touch.angle: {start} deg, at rest: all}}, low: {{touch.angle: {end} deg}}}}\n"
        f"find: {{x: {asked} at low}}"
    )
    heavy, light, radius, angle = 1.0, 0.2, 0.3, math.radians(end)
    drop = radius * (math.sin(math.radians(start)) - math.sin(angle))
    along = -way * math.sin(angle), way * math.cos(angle)
    back = -light * along[0] / (heavy + light)  # V/u, by momentum
    rates = {"bead.velocity.x": along[0] + back, "bead.velocity.y": along[1], "hoop.velocity": back}
    kinetic = heavy * back**2 + light * (rates["bead.velocity.x"] ** 2 + along[1] ** 2)
    speed = math.sqrt(2 * light * 9.8 * drop / kinetic)
    sense = -1 if asked == "hoop.velocity" and moves == "left" else 1
    assert number(solve(text), "x") == pytest.approx(sense * speed * rates[asked], rel=1e-3, abs=1e-12)
