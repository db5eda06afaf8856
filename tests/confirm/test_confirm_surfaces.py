"""Problems with curved surfaces, corners and points that are suddenly held, solved again with plain numbers.

Motions are integrated step by step (RK4) until contact is lost or the end is reached; blows are sums over many point masses or small
systems of linear equations for the impulses. Nothing here uses the solver's formulas.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product

import pytest

from rotsolve.pipeline import solve
from stepping import Course, G, answer, linear, numbers, reach


def test_sphere_rolls_off_the_sphere_where_the_push_ends() -> None:
    big, small = 1.0, 0.1
    path, start = big + small, 1e-5

    def force(_: float, phi: float, rate: float) -> float:
        return 5 / 7 * G * math.sin(phi) / path

    rate = math.sqrt(5 / 7 * G / path) * start  # as it creeps away from the top
    _, phi, rate = reach(force, start, rate, lambda _, phi, rate: G * math.cos(phi) - path * rate**2)
    assert answer("sphere-off-sphere", "phi") == pytest.approx(phi, rel=1e-8)
    assert answer("sphere-off-sphere", "v") == pytest.approx(path * rate, rel=1e-8)
    assert answer("sphere-off-sphere", "omega") == pytest.approx(path * rate / small, rel=1e-8)


def test_block_leaves_the_dome_where_the_push_ends() -> None:
    radius, speed, mass = 3.0, 2.0, 2.0
    _, phi, rate = reach(
        lambda _, phi, rate: G * math.sin(phi) / radius,
        0,
        speed / radius,
        lambda _, phi, rate: G * math.cos(phi) - radius * rate**2,
    )
    assert answer("block-off-dome", "N") == pytest.approx(mass * (G - speed**2 / radius))
    assert answer("block-off-dome", "theta") == pytest.approx(math.pi / 2 - phi, rel=1e-9)
    assert answer("block-off-dome", "v") == pytest.approx(radius * rate, rel=1e-9)
    assert answer("block-off-dome", "d") == pytest.approx(radius * (1 - math.cos(phi)), rel=1e-9)


def hollow(path: float) -> Course:
    """A ball that rolls in a hollow: acceleration of its angle from the lowest place, its centre on a circle of this radius."""
    return lambda _, phi, rate: -5 / 7 * G * math.sin(phi) / path


@pytest.mark.parametrize("more", [-0.01, 0.0, 0.01])
def test_ball_stays_on_the_loop_from_the_height_found_on(more: float) -> None:
    path = 0.40 - 0.02
    height = answer("loop-the-loop", "h") + more
    rate = math.sqrt(10 / 7 * G * height) / path  # at the bottom, angles counted from there
    *_, rate = reach(hollow(path), 0, rate, lambda _, phi, rate: phi - math.pi)
    push = path * rate**2 - G
    assert math.isclose(push, 0, abs_tol=1e-9) if not more else (push > 0) == (more > 0)
    if not more:
        assert answer("loop-the-loop", "v") == pytest.approx(path * rate, rel=1e-9)


def test_marble_in_the_bowl_step_by_step() -> None:
    path, small, mass, beta = 0.30 - 0.02, 0.02, 0.02, math.radians(60)

    force = hollow(path)
    *_, rate = reach(force, beta, 0.0, lambda _, phi, rate: phi)
    start = -force(0, beta, 0) * path
    assert answer("marble-in-bowl", "a") == pytest.approx(start)
    assert answer("marble-in-bowl", "f") == pytest.approx(mass * (G * math.sin(beta) - start))
    assert answer("marble-in-bowl", "v") == pytest.approx(-path * rate, rel=1e-9)
    assert answer("marble-in-bowl", "omega") == pytest.approx(-path * rate / small, rel=1e-9)
    assert answer("marble-in-bowl", "N") == pytest.approx(mass * (G + path * rate**2), rel=1e-9)


@pytest.mark.parametrize(
    ("name", "mass", "radius", "height", "arm"),
    [("wheel-on-step-pushed", 0.8, 0.06, 0.03, 0.0), ("wheel-on-step-pulled", 3.0, 0.20, 0.08, 0.20)],
)
def test_wheel_on_the_point_of_leaving_the_floor(
    name: str, mass: float, radius: float, height: float, arm: float
) -> None:
    up, left = (
        (radius - height) / radius,
        math.sqrt(1 - ((radius - height) / radius) ** 2),
    )  # the edge's push on the wheel
    # unknown: pull, push of the edge, friction of the edge along (up, left) turned a quarter clockwise: (up, left) -> right, up
    pull, _, friction = linear(
        [
            (1.0, -left, up, 0.0),
            (0.0, up, left, mass * G),
            (-arm, 0.0, radius, 0.0),  # friction acts at the edge, so that it turns the wheel counterclockwise
        ]
    )
    assert answer(name, "F") == pytest.approx(pull)
    if arm:
        assert answer(name, "f") == pytest.approx(abs(friction))


def after_the_bump(speed: float) -> float:
    """Angular velocity of a ball that rolls against a step: the impulses of the edge stop its touching point."""
    mass, radius, height = 3.0, 0.20, 0.08
    up = radius - height
    side = math.sqrt(radius**2 - up**2)
    inertia = 0.4 * mass * radius**2
    # the edge is `side` to the right of the centre and `up` below it; clockwise turn w, velocity (x, y), impulse (p, q)
    _, _, turn, _, _ = linear(
        [
            (mass, 0.0, 0.0, -1.0, 0.0, mass * speed),
            (0.0, mass, 0.0, 0.0, -1.0, 0.0),
            (0.0, 0.0, inertia, up, side, inertia * speed / radius),
            (1.0, 0.0, -up, 0.0, 0.0, 0.0),
            (0.0, 1.0, -side, 0.0, 0.0, 0.0),
        ]
    )
    return turn


@pytest.mark.parametrize("factor", [0.999, 1.001])
def test_ball_rolls_over_the_step_from_the_speed_found_on(factor: float) -> None:
    radius, height = 0.20, 0.08
    turn = after_the_bump(answer("ball-rolls-over-step", "u") * factor)
    begin = math.acos(
        (radius - height) / radius
    )  # of the radius to the edge from the vertical; it shrinks on the way up

    def force(_: float, phi: float, rate: float) -> float:
        return 5 / 7 * G * math.sin(phi) / radius

    _, phi, _ = reach(force, begin, -turn, lambda _, phi, rate: phi if factor > 1 else rate)
    assert (phi < 1e-9) == (factor > 1)
    if factor > 1:
        assert answer("ball-rolls-over-step", "omega") * factor == pytest.approx(turn)


Mass = tuple[float, float, float]  # mass and place


def held(masses: Sequence[Mass], at: tuple[float, float], speed: float) -> tuple[float, tuple[float, float], float]:
    """Masses that fall with a speed when a point is caught: counterclockwise turn, impulse, and share of the energy that is lost."""
    inertia = sum(m * ((x - at[0]) ** 2 + (y - at[1]) ** 2) for m, x, y in masses)
    turn = sum(m * (x - at[0]) * -speed for m, x, _ in masses) / inertia
    impulse = (
        sum(-m * turn * (y - at[1]) for m, _, y in masses),
        sum(m * (turn * (x - at[0]) + speed) for m, x, _ in masses),
    )
    whole = sum(m for m, _, _ in masses)
    return turn, impulse, 1 - inertia * turn**2 / (whole * speed**2)


def spread(length: float) -> list[float]:
    """Places from 0 to a length that carry equal masses with the mean and the mean square of a uniform spread: Gauss's two points."""
    half = length / 2
    return [half - half / math.sqrt(3), half + half / math.sqrt(3)]


def test_rod_caught_at_its_end() -> None:
    mass, length, speed = 2.0, 1.2, 3.0
    turn, impulse, lost = held([(mass / 2, x, 0.0) for x in spread(length)], (0, 0), speed)
    assert answer("rod-caught-at-end", "omega") == pytest.approx(-turn)
    assert answer("rod-caught-at-end", "v_end") == pytest.approx(-turn * length)
    assert answer("rod-caught-at-end", "J") == pytest.approx(math.hypot(*impulse))
    assert answer("rod-caught-at-end", "share") == pytest.approx(lost)


def test_plate_caught_at_a_corner() -> None:
    mass, side, speed = 2.0, 0.4, 3.0
    masses = [(mass / 4, x, y) for x, y in product(spread(side), spread(side))]
    turn, impulse, lost = held(masses, (0, 0), speed)
    assert answer("plate-caught-at-corner", "omega") == pytest.approx(-turn)
    assert answer("plate-caught-at-corner", "J") == pytest.approx(math.hypot(*impulse))
    assert answer("plate-caught-at-corner", "share") == pytest.approx(lost)


@pytest.mark.parametrize("factor", [0.999, 1.001])
def test_block_falls_over_the_ridge_from_the_speed_found_on(factor: float) -> None:
    mass, side = 5.0, 0.3
    masses = [(mass / 4, x, y) for x, y in product(spread(side), spread(side))]
    inertia = sum(m * ((x - side) ** 2 + y**2) for m, x, y in masses)
    turn = answer("block-trips-over-ridge", "u") * factor * sum(m * y for m, _, y in masses) / inertia  # clockwise
    arm = side / math.sqrt(2)

    def force(_: float, phi: float, rate: float) -> float:
        """Of the angle of the diagonal from the vertical, which shrinks while the block tips."""
        return mass * G * arm * math.sin(phi) / inertia

    _, phi, _ = reach(force, math.pi / 4, -turn, lambda _, phi, rate: phi if factor > 1 else rate)
    assert (phi < 1e-9) == (factor > 1)
    assert answer("block-trips-over-ridge", "omega") * factor == pytest.approx(-turn)


SHOT = """title: Marble shot up in a bowl
given: {{R: 3 m, r: 20 cm, u: 2 m/s}}
surfaces: {{bowl: {{hollow: R}}}}
bodies: {{marble: {{shape: sphere, radius: r, moves: {way}}}}}
connections: {{touch: {{rolls: [marble, bowl]}}}}
states: {{bottom: {{touch.angle: -90 deg, marble.velocity: u}}, high: {{at rest: all}}}}
find:
  theta: touch.angle at high in deg
  beta: touch.angle + 90 deg at high in deg
  s: marble.displacement from bottom to high
"""
LOST = """title: Ball let go too low for the loop
given: {{R: 3 m, r: 20 cm, h: 5.5 m}}
surfaces: {{slide: profile unknown, loop: {{hollow: R}}}}
bodies: {{ball: {{shape: sphere, mass: 2 kg, radius: r, moves: {way}}}}}
connections: {{touch: {{rolls: [ball, slide, loop]}}}}
states: {{start: {{ball.height: h, at rest: all}}, off: {{touch: leaves}}}}
find: {{theta: touch.angle at off in deg, v: ball.speed at off}}
"""


@pytest.mark.parametrize(("way", "sign"), [("right", 1), ("left", -1)])
def test_places_on_a_circle_are_the_first_on_the_way(way: str, sign: int) -> None:
    """The same motion to both sides; angles run on from where the body starts."""
    path = 3 - 0.2
    _, high, _ = reach(hollow(path), 0, 2 / path, lambda _, phi, rate: rate)
    found = numbers(solve(SHOT.format(way=way)))
    assert found["theta"] == pytest.approx(-math.pi / 2 + sign * high, rel=1e-8)
    assert found["beta"] == pytest.approx(sign * high, rel=1e-8)
    assert found["s"] == pytest.approx(path * high, rel=1e-8)

    start = math.sqrt(10 / 7 * G * 5.5) / path
    _, off, rate = reach(
        hollow(path),
        0,
        start,
        lambda _, phi, rate: path * rate**2 + G * math.cos(phi),
    )
    found = numbers(solve(LOST.format(way=way)))
    assert found["theta"] == pytest.approx(-math.pi / 2 + sign * off, rel=1e-8)
    assert found["v"] == pytest.approx(path * rate, rel=1e-8)


def test_a_ball_that_falls_off_the_loop_is_objected_to() -> None:
    scene = LOST.format(way="right").replace("touch: leaves", "touch.angle: 90 deg").replace("5.5 m", "7 m")
    objections = [check for check in solve(scene).checks if check.holds is False]
    assert len(objections) == 1


def test_rod_slides_down_on_ice() -> None:
    mass, length, theta = 2.0, 1.2, math.radians(60)
    half, inertia = length / 2, 2.0 * 1.2**2 / 12

    def force(_: float, angle: float, rate: float) -> float:
        """Lagrange's equation of the height ½ L sin θ: the centre goes straight down."""
        own = inertia + mass * half**2 * math.cos(angle) ** 2
        return (mass * half**2 * math.sin(angle) * math.cos(angle) * rate**2 - mass * G * half * math.cos(angle)) / own

    *_, rate = reach(force, theta, 0.0, lambda _, angle, rate: angle)
    falls = half * math.cos(theta) * force(0, theta, 0)
    assert answer("rod-slips-on-ice", "N") == pytest.approx(mass * (G + falls))
    assert answer("rod-slips-on-ice", "omega") == pytest.approx(-rate, rel=1e-9)
    assert answer("rod-slips-on-ice", "v") == pytest.approx(-half * rate, rel=1e-9)


def test_ladder_let_go_at_a_smooth_wall_by_elimination() -> None:
    """Pushes of floor and wall, accelerations of the centre and of the turn: forces, torques and two ends kept on their surfaces."""
    mass, length, theta = 12.0, 4.0, math.radians(60)
    right, up = length / 2 * math.cos(theta), length / 2 * math.sin(theta)  # from the centre to the head
    inertia = sum(mass / 2 * (s - length / 2) ** 2 for s in spread(length))
    floor, wall, ahead, rise, turn = linear(
        [
            (0.0, 1.0, mass, 0.0, 0.0, 0.0),  # the wall pushes to the left
            (1.0, 0.0, 0.0, -mass, 0.0, mass * G),
            (-right, up, 0.0, 0.0, -inertia, 0.0),  # counterclockwise
            (0.0, 0.0, 0.0, 1.0, -right, 0.0),  # the foot keeps its height
            (0.0, 0.0, 1.0, 0.0, -up, 0.0),  # the head keeps to the wall
        ]
    )
    assert answer("ladder", "N1") == pytest.approx(floor, rel=1e-9)
    assert answer("ladder", "N2") == pytest.approx(wall, rel=1e-9)
    assert answer("ladder", "alpha") == pytest.approx(turn, rel=1e-9)
    assert answer("ladder", "a") == pytest.approx(math.hypot(ahead, rise), rel=1e-9)
    assert answer("ladder", "a_foot") == pytest.approx(abs(ahead + turn * up), rel=1e-9)


def test_ladder_leaves_the_wall_where_its_push_ends() -> None:
    length = 4.0

    def force(_: float, angle: float, rate: float) -> float:
        """Of the angle to the floor, while both ends touch: the centre goes on a circle of half the length."""
        return -1.5 * G / length * math.cos(angle)

    def push(_: float, angle: float, rate: float) -> float:
        """Acceleration of the centre away from the wall."""
        return -(math.sin(angle) * force(0, angle, rate) + math.cos(angle) * rate**2)

    _, angle, rate = reach(force, math.radians(60), 0.0, push)
    assert answer("ladder-leaves-wall", "phi") == pytest.approx(-angle, rel=1e-9)
    assert answer("ladder-leaves-wall", "omega") == pytest.approx(-rate, rel=1e-9)


def test_rod_tips_over_about_its_foot() -> None:
    mass, length, beta, start = 2.0, 1.2, math.radians(30), 1e-6

    def force(_: float, angle: float, rate: float) -> float:
        """Of the angle from the vertical, about the foot."""
        return 1.5 * G / length * math.sin(angle)

    creeping = math.sqrt(1.5 * G / length) * start  # as it leaves the upright place
    *_, rate = reach(force, start, creeping, lambda _, angle, rate: angle - beta)
    turn, half = force(0, beta, rate), length / 2
    up = -half * (math.sin(beta) * turn + math.cos(beta) * rate**2)
    ahead = half * (math.cos(beta) * turn - math.sin(beta) * rate**2)
    assert answer("rod-tips-on-floor", "omega") == pytest.approx(rate, rel=1e-8)
    assert answer("rod-tips-on-floor", "N") == pytest.approx(mass * (G + up), rel=1e-8)
    assert answer("rod-tips-on-floor", "f") == pytest.approx(mass * ahead, rel=1e-8)  # to the right


def test_blow_on_the_end_of_a_rod() -> None:
    mass, length, blow = 5.0, 0.9, 3.0
    places = [x - length / 2 for x in spread(length)]  # two equal masses on a light rod behave like the rod
    # each mass takes the blow times a share: the shares add up to 1, and their moment is that of the blow
    shares = linear([(1.0, 1.0, 1.0), (places[0], places[1], length / 2)])
    speeds = [share * blow / (mass / 2) for share in shares]
    turn = (speeds[1] - speeds[0]) / (places[1] - places[0])
    centre = (speeds[0] + speeds[1]) / 2
    assert answer("blow-on-rod-on-ice", "v") == pytest.approx(centre)
    assert answer("blow-on-rod-on-ice", "omega") == pytest.approx(turn)
    assert answer("blow-on-rod-on-ice", "v_end") == pytest.approx(centre + turn * length / 2)
    assert answer("blow-on-rod-on-ice", "d") == pytest.approx(centre / turn)
    assert answer("blow-on-rod-on-ice", "K") == pytest.approx(sum(mass / 4 * speed**2 for speed in speeds))
    pieces = 1000  # of the farther half, each held on its circle round the centre
    pull = math.fsum(mass / 2 / pieces * turn**2 * (k + 0.5) / pieces * length / 2 for k in range(pieces))
    assert answer("blow-on-rod-on-ice", "F") == pytest.approx(pull)


def test_wheel_set_down_slides_for_an_instant_and_rolls() -> None:
    mass, radius, turn, speed, pushed = 2.0, 0.4, 30.0, 0.0, 0.0
    start = 0.25 * mass * radius**2 * turn**2
    small = 1e-5  # impulse of one tooth after the other
    while speed < radius * turn:
        pushed, speed, turn = pushed + small, speed + small / mass, turn - small * radius / (mass * radius**2 / 2)
    end = 0.25 * mass * radius**2 * turn**2 + mass * speed**2 / 2
    assert answer("spinning-wheel-set-down", "v") == pytest.approx(speed, rel=1e-5)
    assert answer("spinning-wheel-set-down", "J") == pytest.approx(pushed, rel=1e-5)
    assert answer("spinning-wheel-set-down", "share") == pytest.approx(1 - end / start, rel=1e-5)
