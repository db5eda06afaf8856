"""What may be asked in space: the component of one of the forces on a body, the angular momentum of all bodies, axes in a condition, a
couple where what drives stands still; and of what stands upright no more than its angles tell.

The numbers are vector algebra by numpy.
"""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from rotsolve import Unsolvable, solve

BEAD = """up: z
gravity: none
given: {m: 0.2 kg, R: 0.5 m, W: 3 rad/s, u: UVALUE}
bodies:
  disc: {shape: disc, mass: 0, radius: R, points: {O: [-R, 0, 0]}}
  bead: {shape: particle, mass: m}
connections: {axis: {hinge: disc.O, along: z, angular_velocity: W}}
actions: {rim: {force: any, on: bead}}
states:
  now:
    bead.position relative to disc: [2*R, 0, 0]
    bead.velocity relative to disc: [0, u, 0]
    bead.acceleration relative to disc: [-u^2/R, 0, 0]
"""


def test_one_of_the_forces_on_a_body_has_components() -> None:
    find = "find: {F: bead.force.coriolis.x, G: bead.force.centrifugal.x}\n"
    found = solve(BEAD.replace("UVALUE", "2 m/s") + find).answers
    assert found["F"].float == pytest.approx(2 * 0.2 * 2 * 3)
    assert found["G"].float == pytest.approx(0.2 * 9 * 1.0)


def test_a_condition_may_be_of_two_of_them() -> None:
    """Irodov 1.115: the inertial forces together vanish where u = −W R."""
    find = "find: {u_0: u where bead.force.coriolis.x + bead.force.centrifugal.x = 0 N}\n"
    assert solve(BEAD.replace("UVALUE", "unknown") + find).answers["u_0"].float == pytest.approx(-1.5)


CAR = """up: z
gravity: none
given: {M: 1200 kg, L: 0.5 m, m: 60 kg, R: 0.4 m, v: 20 m/s, rho: 80 m, n: unknown, q: 30 deg}
bodies:
  car: {mass: 0, angular_velocity: [0, 0, v/rho]}
  wheel: {shape: disc, mass: m, radius: R}
connections: {axle: {axle: [car, wheel], along: y, angular_velocity: n}}
find: {n: FIND}
"""


@pytest.mark.parametrize(
    "find",
    [
        "n where axle.torque.x in car axes = M*v^2/rho*L",
        "n where axle.torque.x = M*v^2/rho*L in car axes",
        "n where axle.torque.x in car axes = M*v^2/rho*L in rev/s",
        "n where axle.torque.x = M*v^2/rho*L in rev/s",
    ],
)
def test_a_condition_may_say_along_which_axes(find: str) -> None:
    """Kleppner and Kolenkow, problem 7.5: n = 2 M v L/(m R²), against the sense in which the wheels roll."""
    n = -2 * 1200 * 20 * 0.5 / (60 * 0.16) / (2 * pi if find.endswith("rev/s") else 1)
    assert solve(CAR.replace("FIND", find)).answers["n"].float == pytest.approx(n)


PARTICLES = """up: z
gravity: none
given: {h: 0.9 m}
bodies: {A: {shape: particle, mass: 3 kg}, B: {shape: particle, mass: 2 kg}}
states:
  now:
    A.position: [1.2 m, 0 m, 1 m]
    A.velocity: [4 m/s, 2 m/s, 2 m/s]
    B.position: [0 m, h, 0 m]
    B.velocity: [3 m/s, -1 m/s, 2 m/s]
find: {FIND}
"""
PLACES = np.array([[1.2, 0, 1.0], [0, 0.9, 0]])
MOMENTA = np.array([3 * np.array([4.0, 2, 2]), 2 * np.array([3.0, -1, 2])])


@pytest.mark.parametrize(("about", "point"), [("[0, 0, 0]", (0, 0, 0)), ("[0, h, 2*h]", (0, 0.9, 1.8))])
def test_all_bodies_together_have_an_angular_momentum(about: str, point: tuple[float, ...]) -> None:
    whole = np.cross(PLACES - np.array(point), MOMENTA).sum(axis=0)
    found = solve(
        PARTICLES.replace("FIND", f'H: "angular_momentum about {about}", z: "angular_momentum.z about {about}"')
    )
    assert [part.float for part in found.answers["H"].components.values()] == pytest.approx(list(whole))
    assert found.answers["z"].float == pytest.approx(whole[2])
    assert all(item.holds for item in found.derivation.confirmed)


def test_about_which_point_is_not_guessed() -> None:
    with pytest.raises(Unsolvable, match="nothing tells about which point"):
        solve(PARTICLES.replace("FIND", "H: angular_momentum"))


SHIP = """up: z
gravity: none
given: {m: 20000 kg, k: 0.6 m, n: 2000 rev/min, phi: 6 deg, T: 30 s}
bodies:
  ship: {mass: 0}
  rotor: {mass: m, inertia: m*k^2, axis: z}
connections:
  pitch: {hinge: ship, along: y, DRIVE}
  shaft: {axle: [ship, rotor], along: x, angular_velocity: n}
states: {now: {time: 0 s}}
find: {C: size of shaft.torque}
"""


@pytest.mark.parametrize("drive", ["angle: phi*sin(2*pi*time/T)", "angular_velocity: 2*pi*phi/T*cos(2*pi*time/T)"])
def test_what_swings_through_its_middle_has_no_angular_acceleration(drive: str) -> None:
    """Khurmi and Gupta, Theory of Machines, example 14.6: C = I n φ 2π/T, whatever the rotor's inertia across its axis."""
    couple = 20000 * 0.36 * (2000 * 2 * pi / 60) * (6 * pi / 180) * 2 * pi / 30
    assert solve(SHIP.replace("DRIVE", drive)).answers["C"].float == pytest.approx(couple)


TOP = """up: z
given: {M: 0.5 kg, l: 5 cm, I1: 2e-3 kg m^2, I3: 5e-4 kg m^2, s: 300 rad/s, a: 3 m/s^2, F: unknown, g: 9.81 m/s^2}
bodies:
  cart: {mass: 0, acceleration: [a, 0, 0]}
  top: {mass: M, inertia: {about: O, principal: [I1, I1, I3]}, axis: z, points: {O: [0, 0, -l]}}
connections: {pin: {ball: [cart, top.O]}}
states: {now: {STATE}}
find: {al: top.angular_acceleration}
"""
UPRIGHT = "top.tilt: TILT, top.axial_rate: s, top.precession: 0 rad/s, top.nutation: 0 rad/s"


@pytest.mark.parametrize("tilt", ["0 deg", "180 deg"])
def test_where_what_stands_upright_leans_its_angles_do_not_tell(tilt: str) -> None:
    with pytest.raises(Unsolvable, match="stands upright at `now`, where its tilt and precession don't tell"):
        solve(TOP.replace("STATE", UPRIGHT.replace("TILT", tilt)).replace("F: unknown, ", ""))


def test_its_angular_velocity_tells() -> None:
    found = solve(TOP.replace("STATE", "top.angular_velocity: [0, 0, s]").replace("F: unknown, ", ""))
    assert [part.float for part in found.answers["al"].components.values()] == pytest.approx(
        [0, -0.5 * 3 * 0.05 / 2e-3, 0]
    )


def test_no_force_is_told_by_them() -> None:
    scene = TOP.replace("STATE", UPRIGHT.replace("TILT", "0 deg")).replace("al: top.angular_acceleration", "F: F")
    scene = scene.replace("[cart, top.O]", "top.O").replace("  cart: {mass: 0, acceleration: [a, 0, 0]}\n", "")
    with pytest.raises(Unsolvable, match="too little is known to find `F`"):
        solve(
            scene.replace("states:", "actions: {f: {force: F, on: top.cm, direction: x}}\nstates:").replace(
                "a: 3 m/s^2, ", ""
            )
        )


SIGN = """up: z
given: {W: 270 lbf, g: 32.2 ft/s^2, T1: unknown, T2: unknown}
bodies:
  sign:
    shape: rectangle
    mass: W/g
    sides: [8 ft, 5 ft]
    turned: {about: x, by: 90 deg}
    points: {A: [-4 ft, 2.5 ft, 0 ft], B: [4 ft, 2.5 ft, 0 ft], E: [2 ft, 2.5 ft, 0 ft]}
connections: {joint: {ball: sign.A}}
actions: {BD: {force: T1, on: sign.B, direction: [-8, 8, 4]}, EC: {force: T2, on: sign.E, direction: [-6, -2, 3]}}
states: {now: STATE}
find: {T1: T1, T2: T2, A: joint.force}
"""


@pytest.mark.parametrize(
    "state",
    [
        "{balance: true}",
        "{at rest: all, steady: true}",
        "{sign.angular_velocity: [0, 0, 0], sign.angular_acceleration: [0, 0, 0]}",
    ],
)
def test_what_stands_in_space_is_held_in_balance(state: str) -> None:
    """Beer and Johnston, Statics, sample problem 4.9, with its places in numbers: three points at one height, which cancels."""
    found = solve(SIGN.replace("STATE", state))
    assert found.answers["T1"].float == pytest.approx(270 * 3 / 8)
    assert found.answers["T2"].float == pytest.approx(270 * 7 / 6)
    pulls = [101.25 * np.array([-8, 8, 4]) / 12, 315 * np.array([-6, -2, 3]) / 7]
    held = -np.array([0, 0, -270]) - sum(pulls)
    assert [part.float for part in found.answers["A"].components.values()] == pytest.approx(list(held))
    assert all(item.holds for item in found.derivation.confirmed)
