"""Tensors of inertia, moments about axes and energies: sums over heavy points."""

from __future__ import annotations

from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.particles import X, Y, Z, cone, cuboid, moment, points, rectangle, tensor, turn

Answers = dict[str, Any]


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
    invariants = {"tr": one + two + three, "I_2": one * two + two * three + three * one, "I_3": one * two * three}
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


CALCULATIONS = {
    "box-about-its-diagonal": box_about_its_diagonal,
    "box-turned": box_turned,
    "cone-about-its-tip": cone_about_its_tip,
    "cube-corner": cube_corner,
    "kinetic-energy-of-a-cube": kinetic_energy_of_a_cube,
    "plate-about-a-corner": plate_about_a_corner,
    "rigid-rotator": rigid_rotator,
    "three-masses-tensor": three_masses_tensor,
}
