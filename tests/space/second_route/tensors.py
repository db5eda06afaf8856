"""Tensors of inertia, moments about axes and energies: sums over heavy points."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.particles import (
    Cloud,
    X,
    Y,
    Z,
    ball,
    cone,
    cuboid,
    cylinder,
    degrees_between,
    moment,
    points,
    rectangle,
    sphere,
    tensor,
    together,
    tube,
    turn,
)

Answers = dict[str, Any]
Calculation = Callable[[Numbers], Answers]


def box_about_its_diagonal(n: Numbers) -> Answers:
    return {"I_d": moment(cuboid(n.m, n.w, n.h, n.d), (n.w, n.h, n.d))}


def box_turned(n: Numbers) -> Answers:
    return {"I": tensor(cuboid(n.m, n.w, n.h, n.d).turned(turn(Z, n.phi)))}


def cone_about_its_tip(n: Numbers) -> Answers:
    body = cone(n.M, n.R, n.h)
    return {"I": tensor(body), "I_s": moment(body, (n.R, 0, -n.h))}


def cube_corner(n: Numbers) -> Answers:
    whole = tensor(cuboid(n.M, n.a, n.a, n.a).moved(np.full(3, n.a / 2)))
    (one, two, three), axes = np.linalg.eigh(whole)
    axis = axes[:, 0] * np.sign(axes[0, 0])  # towards the body
    invariants = {"tr": one + two + three, "c_2": one * two + two * three + three * one, "det": one * two * three}
    return {"I": whole, "I_p": [one, two, three], "e": axis, **invariants}


def plate_about_a_corner(n: Numbers) -> Answers:
    whole = tensor(rectangle(n.M, n.a, n.a).moved(n.a / 2 * (X + Y)))
    return {"I": whole, "I_p": list(np.linalg.eigvalsh(whole))}


def three_masses_tensor(n: Numbers) -> Answers:
    whole = tensor(points((n.m, n.a * X), (n.m, n.a * (Y + 2 * Z)), (n.m, n.a * (2 * Y + Z))))
    return {"I": whole, "I_p": list(np.linalg.eigvalsh(whole))}


def rigid_rotator(n: Numbers) -> Answers:
    """Two atoms of 3 μ and 1.5 μ: their reduced mass is μ."""
    atoms = points((3 * n.mu, n.r / 3 * Z), (1.5 * n.mu, -2 * n.r / 3 * Z))
    velocities = np.cross(n.omega * X, atoms.places)
    size = float(np.linalg.norm(atoms.masses @ np.cross(atoms.places, velocities)))
    energy = float(atoms.masses @ (velocities**2).sum(axis=1)) / 2
    across = moment(atoms, X)
    return {"I_1": across, "I_3": moment(atoms, Z), "L": size, "T": energy, "T_L": size**2 / (2 * across)}


def kinetic_energy_of_a_cube(n: Numbers) -> Answers:
    omega, body = np.array([n.wx, n.wy, n.wz]), cuboid(n.m, n.a, n.a, n.a)

    def energy(places: Any, velocity: Any) -> float:
        return float(body.masses @ ((velocity + np.cross(omega, places)) ** 2).sum(axis=1)) / 2

    return {
        "K_O": energy(body.moved(np.full(3, n.a / 2)).places, 0 * X),
        "K_cm": energy(body.places, 0 * X),
        "K": energy(body.places, n.v * X),
    }


def of_one(build: Callable[[Numbers], Cloud], name: str = "I_tensor") -> Calculation:
    """The tensor of a body about the origin."""
    return lambda n: {name: tensor(build(n))}


def two_spheres_tensor(n: Numbers) -> Answers:
    both = together(ball(n.m1, n.r1).moved(n.x1 * X), ball(n.m2, n.r2).moved(n.x2 * X))
    centre = both.masses @ both.places / both.mass
    return {"x_com": centre[0], "I_tensor": tensor(both.moved(-centre))}


def particle_off_the_plane(n: Numbers) -> Answers:
    bead = points((n.m, n.r * X + n.z * Z))
    momentum = tensor(bead) @ (n.omega * Z)
    angle = np.radians(degrees_between(momentum, Z))
    return {"L": momentum, "L_axis": momentum[2], "L_perp": abs(momentum[0]), "angle_to_omega": angle}


CALCULATIONS: dict[str, Calculation] = {
    "box-about-a-point": of_one(lambda n: cuboid(n.m, n.w, n.h, n.d).moved(np.array([n.xs, n.ys, n.zs])), "I_A"),
    "box-about-its-diagonal": box_about_its_diagonal,
    "box-turned": box_turned,
    "cone-about-its-tip": cone_about_its_tip,
    "cube-corner": cube_corner,
    "kinetic-energy-of-a-cube": kinetic_energy_of_a_cube,
    "particle-off-the-plane": particle_off_the_plane,
    "plate-about-a-corner": plate_about_a_corner,
    "rigid-rotator": rigid_rotator,
    "tensor-box": of_one(lambda n: cuboid(n.m, n.w, n.h, n.d)),
    "tensor-cube": of_one(lambda n: cuboid(n.M, n.a, n.a, n.a)),
    "tensor-cylinder": of_one(lambda n: cylinder(n.m, n.r, n.h)),
    "tensor-ellipsoid": of_one(lambda n: Cloud(ball(n.m, 1.0).masses, ball(n.m, 1.0).places * [n.a, n.b, n.c])),
    "tensor-hollow-sphere": of_one(lambda n: sphere(n.m, n.r)),
    "tensor-lamina": of_one(lambda n: rectangle(n.M, n.a, n.b)),
    "tensor-solid-sphere": of_one(lambda n: ball(n.m, n.r)),
    "tensor-tube": of_one(lambda n: tube(n.m, n.r, n.h)),
    "three-masses-tensor": three_masses_tensor,
    "two-spheres-tensor": two_spheres_tensor,
}
