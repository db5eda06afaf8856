"""Bodies on fixed axes: Newton's second law for each heavy point on its circle."""

from __future__ import annotations

from math import cos, pi, sin, sqrt
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.particles import (
    Cloud,
    Motion,
    X,
    Y,
    Z,
    cuboid,
    cylinder,
    degrees_between,
    derivatives,
    disc,
    moment,
    points,
    rectangle,
    tensor,
    together,
    turn,
    two_bearings,
)

Answers = dict[str, Any]
SIZE = np.linalg.norm


def steadily(cloud: Cloud, axis: Any, rate: float) -> Motion:
    """A body that turns steadily about an axis through the origin."""
    return Motion.about_origin(cloud, lambda t: turn(axis, rate * t), rate)


def cube_edge(n: Numbers) -> Answers:
    motion = steadily(cuboid(n.M, n.a, n.a, n.a).moved(np.full(3, n.a / 2)), Z, n.omega)
    momentum = motion.angular_momentum()
    return {"L": momentum, "gap": degrees_between(momentum, Z), "tau": motion.torque()}


def cylinder_like_a_sphere(n: Numbers) -> Answers:
    motion = steadily(cylinder(n.M, n.R, sqrt(3) * n.R), (1, 0, 1), n.omega)
    return {"tau": SIZE(motion.torque()), "L": SIZE(motion.angular_momentum())}


def oblique_cylinder(n: Numbers) -> Answers:
    body, axis = cylinder(n.M, n.R, n.h), (sin(n.beta), 0, cos(n.beta))
    return {"I": moment(body, axis), "tau": steadily(body, axis, n.omega).torque()[1]}


def plate_diagonal(n: Numbers) -> Answers:
    plate, axis = rectangle(n.M, n.a, n.b), np.array([n.a, n.b, 0])
    motion = steadily(plate, axis, n.omega)
    momentum = motion.angular_momentum()
    return {
        "L": momentum,
        "tau": motion.torque(),
        "tau_45": steadily(plate, (1, 1, 0), n.omega).torque(),
        "I": moment(plate, axis),
        "K": motion.kinetic_energy(),
        "gap": degrees_between(momentum, axis),
    }


def plate_normal(n: Numbers) -> Answers:
    motion = steadily(rectangle(n.M, n.a, n.b), Z, n.omega)
    return {"L": motion.angular_momentum(), "tau": motion.torque()}


def plates_on_their_diagonals(n: Numbers) -> Answers:
    square = steadily(rectangle(n.M, n.a, n.a), (1, 1, 0), n.omega)
    axis, reach = (n.a, n.b, 0), sqrt(n.a**2 + n.b**2) / 2
    oblong = steadily(rectangle(n.M, n.a, n.b), axis, n.omega)
    first, second = two_bearings(oblong.force(), oblong.torque(), axis, -reach, reach)
    assert np.allclose(first, -second)
    return {"tau_1": SIZE(square.torque()), "tau_2": SIZE(oblong.torque()), "F": SIZE(first)}


def shaft_out_of_balance(n: Numbers) -> Answers:
    lumps = points((n.m, n.e * X + n.c / 2 * Z), (n.m, -n.e * X - n.c / 2 * Z))
    motion = steadily(lumps, Z, n.w)
    first, second = two_bearings(motion.force(), motion.torque(), Z, -n.b / 2, n.b / 2)
    return {"I_zx": tensor(lumps)[2, 0], "tau": motion.torque(), "F_1": first, "F_2": second}


def skew_disc(n: Numbers) -> Answers:
    """The masses that balance it: the product of inertia is linear in them."""
    wheel = disc(n.M, n.R).turned(turn(Y, n.phi))
    motion = steadily(wheel, Z, n.omega)
    first, _ = two_bearings(motion.force(), motion.torque(), Z, -n.D / 2, n.D / 2)
    unit = tensor(together(wheel, points((1, n.rb * X + n.c * Z), (1, -n.rb * X - n.c * Z))))[2, 0]
    own = tensor(wheel)[2, 0]
    off = steadily(disc(n.M, n.R).moved(n.e * X), Z, n.omega)
    return {
        "I_zx": own,
        "tau": SIZE(motion.torque()),
        "F_1": SIZE(first),
        "F_s": SIZE(off.force()),
        "m_b": own / (own - unit),
    }


def skew_rod(n: Numbers) -> Answers:
    end = n.l * (sin(n.alpha) * X + cos(n.alpha) * Z)
    motion = steadily(points((n.m, end), (n.m, -end)), Z, n.omega)
    momentum = motion.angular_momentum()
    sizes = {"L_0": SIZE(momentum), "tau": SIZE(motion.torque())}
    return {"L": momentum, "gap": degrees_between(momentum, Z), **sizes}


def momentum_of_a_particle(n: Numbers) -> Answers:
    return {"L": n.m * np.cross(n.a * (X + Z), n.v * Y)}


def gate_on_a_leaning_post(n: Numbers) -> Answers:
    """α = −U'(φ)/I of what can turn about the post alone."""
    stand = turn(X, pi / 2 - n.beta)
    gate = rectangle(n.M, n.b, n.h).moved(n.b / 2 * X).turned(stand)
    post = stand @ Y

    def energy(angle: Any) -> Any:
        return n.g * (gate.masses @ (gate.places @ turn(post, n.phi + angle).T)[:, 2])

    inertia = moment(gate, post)
    return {"alpha": abs(derivatives(energy, 1.0)[1]) / inertia, "I": inertia}


def two_plane_balancing(n: Numbers) -> Answers:
    """The places at which neither bearing is pushed: their forces are linear in these."""

    def pushed(places: Any) -> Any:
        x1, y1, x2, y2 = places
        lumps = (n.m1, n.r1 * X + n.d * Z), (n.m2, n.r2 * Y + 2 * n.d * Z)
        rotor = points(*lumps, (n.mb, x1 * X + y1 * Y), (n.mb, x2 * X + y2 * Y + 3 * n.d * Z))
        motion = steadily(rotor, Z, n.n)
        return np.concatenate([force[:2] for force in two_bearings(motion.force(), motion.torque(), Z, -n.d, 4 * n.d)])

    still = pushed(np.zeros(4))
    slopes = np.array([pushed(place) - still for place in np.eye(4)]).T
    return dict(zip(("x1", "y1", "x2", "y2"), np.linalg.solve(slopes, -still), strict=True))


def masses_that_balance_a_rotor(n: Numbers) -> Answers:
    """Lumps with m r = p: the moments about each of the two planes vanish, 3 d p_F + Σ z m r = 0 and 3 d p_N + Σ (3 d − z) m r = 0."""
    lumps = (n.m1, n.r1 * X + n.d * Z), (n.m2, n.r2 * Y + 2 * n.d * Z)
    near = -sum(m * (3 * n.d - r[2]) * (r[0] + 1j * r[1]) for m, r in lumps) / (3 * n.d)
    far = -sum(m * r[2] * (r[0] + 1j * r[1]) for m, r in lumps) / (3 * n.d)
    masses = {name: abs(p) / n.r for name, p in (("mN", near), ("mF", far))}
    return {**masses, "qN": np.angle(near, deg=True), "qF": np.angle(far, deg=True)}


def gyrocompass_let_go(n: Numbers) -> Answers:
    """dL/dt = A dω/dt + (C − A) ω₃ de₃/dt has no part along the hinge: what turns the rotor there would have to turn a light gimbal."""
    axle, earth = turn(X, n.eta) @ Z, n.W * Z
    carried = np.cross(earth, axle)
    axial = (earth + n.s * axle) @ axle
    return {"alpha": -(n.A * n.s * carried + (n.C - n.A) * axial * carried) @ X / n.A}


CALCULATIONS = {
    "cube-edge": cube_edge,
    "cylinder-like-a-sphere": cylinder_like_a_sphere,
    "gate-on-a-leaning-post": gate_on_a_leaning_post,
    "momentum-of-a-particle": momentum_of_a_particle,
    "oblique-cylinder": oblique_cylinder,
    "plate-diagonal": plate_diagonal,
    "plate-normal": plate_normal,
    "plates-on-their-diagonals": plates_on_their_diagonals,
    "shaft-out-of-balance": shaft_out_of_balance,
    "skew-disc": skew_disc,
    "skew-rod": skew_rod,
    "two-plane-balancing": two_plane_balancing,
    "masses-that-balance-a-rotor": masses_that_balance_a_rotor,
    "gyrocompass-let-go": gyrocompass_let_go,
}
