"""Stability: what small disturbances of a steady motion of one body do, from its equations of motion made linear in them, in numbers.

With a small rotation η away from the motion and a change δω of its angular velocity, in axes that turn at Ω and from which the motion looks
the same at all times: η̇ = δω + S η with S = (ω − Ω) ×, and δω̇ = A η + B δω with A = ∂α/∂η, B = ∂α/∂ω − Ω ×. In η and its rate,
η̈ = (A − B S) η + (B + S) η̇: a fast spin, of which nothing grows, cancels there before it can hide what grows slowly.
Of a free body only its own components of ω change: ω̇ = ∂α/∂ω δω, however it is turned. The eigenvalues λ tell what grows.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    arrow_length,
    crossed,
    inner_product,
    less,
    normed,
    product_of,
    rotation_about,
    scaled,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.masses import about_point, total_rows
from rotsolve.confirm.space.rig import Lines, Rig
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import EULER, TURNING, of_turning, three_ties
from rotsolve.confirm.space.worlds import Moving, World

TURN = 1e-4  # of the rotation by which derivatives are found, by differences to the fourth order
UPRIGHT = 1e-9  # how nearly an axis stands upright
GROWS = 1e-3  # of the largest rate: what grows no faster is as it is by rounding
ITERATIONS = 200

Matrix = list[list[float]]
Motion = Callable[[Turned, Arrow], Arrow]  # the angular acceleration that goes with a rotation and an angular velocity


def eigenvalues_of(world: World, name: str) -> list[complex]:
    """The rates λ with which small disturbances of a steady motion go as exp(λ t); a world keeps those of its bodies."""
    known: dict[str, list[complex]] = world.__dict__.setdefault("_eigenvalues", {})
    if name not in known:
        known[name] = found_eigenvalues(world, name)
    return known[name]


def found_eigenvalues(world: World, name: str, frame: Arrow | None = None) -> list[complex]:
    """Those in axes that turn at a rate at which the motion looks the same at all times; where none is told, as they come."""
    rig, turned, omega = world.stance.rig, world.stance.turned(name), world.now.arrow(TURNING, name)
    motion, free = motion_of(rig, name), all(name != joint.body.owner for joint in rig.joints.values())
    if not free and not world.stance.lines.nods(name):
        raise NotConfirmed("the stability of what is held and does not nod")
    frame = omega if free else frame or axes_rate(world, name, omega)
    if arrow_length(less(motion(turned, omega), crossed(frame, omega))) > 1e-7 * (1.0 + arrow_length(omega) ** 2):
        raise NotConfirmed("the stability of what is not steady")
    if free:
        columns = rate_slopes(motion, turned, omega)
        return eigenvalues([[column[i] for column in columns] for i in range(3)])
    return eigenvalues(beside_idle(made_linear(motion, turned, omega, frame), turned, rig.idle(name)))


def axes_rate(world: World, name: str, omega: Arrow) -> Arrow:
    """The rate of axes from which a steady motion looks the same at all times: those of its precession; where its axis stands upright, at
    rest if it is the same all round, else its own."""
    third, rig = world.stance.nodes(name).third, world.stance.rig
    if math.hypot(third[0], third[1]) > UPRIGHT:
        return scaled(world.now.one(EULER, name, 0), ALONG[2])
    axis = rig.axis(name) or ALONG[2]
    way = max(range(3), key=lambda k: abs(axis[k]))
    return STILL if rig.symmetric(name, way) else omega


def motion_of(rig: Rig, name: str) -> Motion:
    """The angular acceleration of a body by itself, however it is turned and turns."""
    if any(
        name in (joint.body.owner, joint.carrier.owner) and joint.carrier.owner in rig.bodies
        for joint in rig.joints.values()
    ):
        raise NotConfirmed("the stability of what is held by another body")

    def alpha(turned: Turned, omega: Arrow) -> Arrow:
        stance = Stance(rig, Lines(rig, None, {}))
        stance.put(name, turned)
        standing = Moving(stance, three_ties(of_turning(name), omega, None))
        equations, found = standing.forced(standing.rates([0.0] * len(standing.moving.free)))
        return equations.named(found.values).arrow(TURNING, name)

    return alpha


def made_linear(motion: Motion, turned: Turned, omega: Arrow, frame: Arrow) -> Matrix:
    """The matrix of (η, η̇)."""
    by_rates = rate_slopes(motion, turned, omega)
    by_rates = [less(column, crossed(frame, way)) for column, way in zip(by_rates, ALONG, strict=True)]
    rows: Matrix = [[float(j == i + 3) for j in range(6)] for i in range(6)]
    for k, way in enumerate(ALONG):
        slide = crossed(less(omega, frame), way)
        by_turn = slope(lambda h, way=way: motion(product_of(rotation_about(way, h), turned), omega), TURN)  # type: ignore[misc]
        carried = sum_of(*(scaled(part, column) for part, column in zip(slide, by_rates, strict=True)))
        for i in range(3):
            rows[3 + i][k] = by_turn[i] - carried[i]
            rows[3 + i][3 + k] = by_rates[k][i] + slide[i]
    return rows


def beside_idle(matrix: Matrix, turned: Turned, idle: Sequence[Arrow]) -> Matrix:
    """The matrix for what leans alone: how a thin body spins about its own line means nothing, and does nothing to how it leans."""
    if not idle:
        return matrix
    line = times_arrow(turned, idle[0])
    across = normed(crossed(line, min(ALONG, key=lambda way: abs(inner_product(way, line)))))
    ways = (across, crossed(line, across))
    bases = [[*(STILL,) * block, way, *(STILL,) * (1 - block)] for block in range(2) for way in ways]
    flat = [[part for arrow in base for part in arrow] for base in bases]
    moved = [[sum(row[k] * base[k] for k in range(6)) for row in matrix] for base in flat]
    return [[sum(a * b for a, b in zip(base, other, strict=True)) for other in moved] for base in flat]


def rate_slopes(motion: Motion, turned: Turned, omega: Arrow) -> list[Arrow]:
    """∂α/∂ω by columns, exact: the accelerations are quadratic in the rates."""
    size = arrow_length(omega) or 1.0
    pairs = [[motion(turned, sum_of(omega, scaled(side * size, way))) for side in (1.0, -1.0)] for way in ALONG]
    return [scaled(0.5 / size, less(up, down)) for up, down in pairs]


def slope(function: Callable[[float], Arrow], h: float) -> Arrow:
    """The derivative at 0: (8 (f(h) − f(−h)) − (f(2 h) − f(−2 h)))/12 h."""
    near, far = less(function(h), function(-h)), less(function(2 * h), function(-2 * h))
    return scaled(1.0 / (12.0 * h), less(scaled(8.0, near), far))


# eigenvalues


def eigenvalues(matrix: Matrix) -> list[complex]:
    """The roots of the characteristic polynomial, by Faddeev and Le Verrier, in units of the largest rate."""
    size = len(matrix)
    turns = size // 2 if size > 3 else 0  # the first of them are angles
    rates = [abs(part) for row in matrix[turns:] for part in row[turns:]]
    scale = max(math.sqrt(abs(trace(multiplied(matrix, matrix)))), *rates)
    if not scale:
        return [0j] * size
    even = [[matrix[i][j] / scale * scale ** ((j >= turns) - (i >= turns)) for j in range(size)] for i in range(size)]
    powers, coefficients = [[float(i == j) for j in range(size)] for i in range(size)], [1.0]
    for k in range(1, size + 1):
        product = multiplied(even, powers)
        coefficients.append(-trace(product) / k)
        powers = [
            [part + (coefficients[k] if i == j else 0.0) for j, part in enumerate(row)] for i, row in enumerate(product)
        ]
    return [root * scale for root in polynomial_roots(coefficients)]


def polynomial_roots(coefficients: Sequence[float]) -> list[complex]:
    """All roots of a polynomial, its first coefficient 1: those that are 0 first, the others by Durand and Kerner."""
    left = list(coefficients)
    found: list[complex] = []
    while len(left) > 1 and abs(left[-1]) <= 1e-9:
        found.append(0j)
        left.pop()
    count = len(left) - 1
    points = [(0.4 + 0.9j) ** k for k in range(count)]
    for _ in range(ITERATIONS):
        moved = 0.0
        for k in range(count):
            value = 0j
            for part in left:
                value = value * points[k] + part
            apart = math.prod([points[k] - other for j, other in enumerate(points) if j != k])
            step = value / (apart or 1e-30)
            points[k] -= step
            moved = max(moved, abs(step))
        if moved < 1e-14:
            break
    return [*found, *points]


def multiplied(a: Matrix, b: Matrix) -> Matrix:
    size = len(a)
    return [[sum(a[i][k] * b[k][j] for k in range(size)) for j in range(size)] for i in range(size)]


def trace(matrix: Matrix) -> float:
    return sum(matrix[k][k] for k in range(len(matrix)))


# what they say


def is_stable(world: World, name: str) -> bool:
    """Whether no small disturbance grows."""
    found = eigenvalues_of(world, name)
    return max(root.real for root in found) <= GROWS * max(map(abs, found))


def swaying_rate(world: World, name: str) -> Arrow | None:
    """The rate I₃ ω/2 I₁ of axes in which an upright symmetric top sways in a plane that stays; None of others."""
    rig, omega = world.stance.rig, world.now.arrow(TURNING, name)
    joint = rig.on_ground(name)
    if joint is None or joint.turning or not world.stance.lines.nods(name):
        return None
    third = world.stance.nodes(name).third
    if math.hypot(third[0], third[1]) > UPRIGHT or axes_rate(world, name, omega) != STILL:
        return None
    own = rig.solid(name)
    tensor = total_rows(world.efforts.tensor(name), about_point(own.mass, world.stance.arm(joint.body)))
    return scaled(tensor[2][2] / (2.0 * tensor[0][0]), omega)


def growth_squared(world: World, name: str) -> float:
    """λ² of the only disturbance that does not just stay as it is."""
    frame = swaying_rate(world, name)
    found = eigenvalues_of(world, name) if frame is None else found_eigenvalues(world, name, frame)
    return only_square(found)


def only_square(found: Sequence[complex]) -> float:
    """λ² where ± λ are the only eigenvalues that are not 0."""
    most = max(map(abs, found))
    squares = [root * root for root in found if abs(root) > GROWS * max(most, 1e-9)]
    if not squares or any(abs(one - squares[0]) > 1e-5 * abs(squares[0]) for one in squares):
        raise NotConfirmed("several small disturbances, each with a rate of its own")
    return sum(one.real for one in squares) / len(squares)
