"""Moments of inertia and centres of mass, confirmed by quadrature in plain Python that shares nothing with the solver."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from mpmath import fp

from rotsolve.pipeline import solve
from stepping import answers, numbers

quad = fp.quad  # in double precision, which is fast


def plate(
    x0: float, x1: float, low: Callable[[float], float], high: Callable[[float], float], weight: Callable[..., float]
) -> dict[str, float]:
    """Mass, first and second moments of a plate by integration over x and y."""

    def total(part: Callable[[float, float], float]) -> float:
        return float(quad(lambda x: quad(lambda y: weight(x, y) * part(x, y), [low(x), high(x)]), [x0, x1]))

    return {
        "m": total(lambda x, y: 1),
        "x": total(lambda x, y: x),
        "y": total(lambda x, y: y),
        "xx": total(lambda x, y: x * x),
        "yy": total(lambda x, y: y * y),
        "xy": total(lambda x, y: x * y),
    }


def test_annulus_with_a_hole() -> None:
    found = answers("annulus-with-a-hole")
    M, R, r, q, c = 1.8, 0.3, 0.1, 0.04, 0.2

    def over(low: float, high: float, shift: float, part: Callable[[float, float], float]) -> float:
        """The integral over a ring with its centre at x = shift."""
        return float(
            quad(
                lambda d: quad(lambda t: d * part(shift + d * math.cos(t), d * math.sin(t)), [0, math.pi, 2 * math.pi]),
                [low, high],
            )
        )

    def left(part: Callable[[float, float], float]) -> float:
        return over(r, R, 0, part) - over(0, q, c, part)

    sigma = M / left(lambda x, y: 1)
    x = sigma * left(lambda x, y: x) / M
    polar = sigma * left(lambda x, y: x * x + y * y)
    assert found["x"] == pytest.approx(x, rel=1e-9)
    assert found["I_O"] == pytest.approx(polar, rel=1e-9)
    assert found["I_cm"] == pytest.approx(polar - M * x * x, rel=1e-9)
    assert found["I_d"] == pytest.approx(sigma * left(lambda x, y: y * y), rel=1e-9)


def test_door_with_a_window() -> None:
    found = answers("door-with-a-window")
    M, w, h, p, d = 24, 0.9, 2.0, 0.5, 0.4
    whole = plate(0, w, lambda x: -h / 2, lambda x: h / 2, lambda x, y: 1)
    hole = plate(w / 2 - p / 2, w / 2 + p / 2, lambda x: d - p / 2, lambda x: d + p / 2, lambda x, y: 1)
    sigma = M / (whole["m"] - hole["m"])
    moment = sigma * (whole["xx"] - hole["xx"])
    assert found["I"] == pytest.approx(moment, rel=1e-9)
    assert found["k"] == pytest.approx(math.sqrt(moment / M), rel=1e-9)
    assert found["y"] == pytest.approx(sigma * (whole["y"] - hole["y"]) / M, rel=1e-9)


def test_bucket_on_a_pulley_with_spokes_by_energy() -> None:
    """The bucket falls by 1 m: v from energy with the pulley cut into small pieces, a from v² = 2 a s."""
    found = answers("pulley-with-spokes")
    M, R, m_s, M_h, r, m_b, g, pieces = 2, 0.4, 0.25, 1.5, 0.1, 3, 9.8, 20000
    middles = [(k + 0.5) / pieces for k in range(pieces)]
    spoke = math.fsum(m_s / pieces * (u * R) ** 2 for u in middles)
    hub = math.fsum(M_h * 2 * u / pieces * (u * r) ** 2 for u in middles)
    moment = M * R**2 + 4 * spoke + hub
    assert found["I"] == pytest.approx(moment, rel=1e-7)
    assert found["k"] == pytest.approx(math.sqrt(moment / (M + 4 * m_s + M_h)), rel=1e-7)
    speed = math.sqrt(2 * m_b * g / (m_b + moment / R**2))
    assert found["a"] == pytest.approx(speed**2 / 2, rel=1e-7)


def test_hemisphere_in_spherical_coordinates() -> None:
    found = answers("hemisphere")
    M, R = 3, 0.2

    def total(part: Callable[[float, float], float]) -> float:
        """The integral over the hemisphere of a function of the distance from the axis and the height."""
        return float(
            quad(
                lambda d: quad(
                    lambda t: 2 * math.pi * d * d * math.sin(t) * part(d * math.sin(t), d * math.cos(t)),
                    [0, math.pi / 2],
                ),
                [0, R],
            )
        )

    rho = M / total(lambda s, z: 1)
    z = rho * total(lambda s, z: z) / M
    assert found["z_cm"] == pytest.approx(z, rel=1e-9)
    assert found["I_z"] == pytest.approx(rho * total(lambda s, z: s * s), rel=1e-9)
    assert found["I_x"] == pytest.approx(rho * total(lambda s, z: s * s / 2 + z * z) - M * z * z, rel=1e-9)


def test_semicircular_plate_in_cartesian_coordinates() -> None:
    found = answers("semicircular-plate")
    M, R = 3, 0.2
    got = plate(-R, R, lambda x: 0, lambda x: math.sqrt(R * R - x * x), lambda x, y: 1)
    y = got["y"] / got["m"]
    polar = M * (got["xx"] + got["yy"]) / got["m"]
    assert found["cm.x"] == 0
    assert found["cm.y"] == pytest.approx(y, rel=1e-9)
    assert found["I_O"] == pytest.approx(polar, rel=1e-9)
    assert found["I_cm"] == pytest.approx(polar - M * y * y, rel=1e-9)


def test_disc_that_grows_thinner_by_particles() -> None:
    found = answers("disc-thinner-outwards")
    sigma, R, pieces = 5, 0.3, 20000
    radii = [(k + 0.5) * R / pieces for k in range(pieces)]
    masses = [2 * math.pi * d * R / pieces * sigma * (1 - d / R) for d in radii]
    moment = math.fsum(m * d * d for m, d in zip(masses, radii, strict=True))
    assert found["M"] == pytest.approx(math.fsum(masses), rel=1e-7)
    assert found["I"] == pytest.approx(moment, rel=1e-7)
    assert found["k"] == pytest.approx(math.sqrt(moment / math.fsum(masses)), rel=1e-7)


def test_a_density_of_two_coordinates() -> None:
    scene = """
title: Sheet that grows thicker
given: {a: 0.5 m, b: 0.3 m, c: 4 kg/m^4}
bodies: {sheet: {shape: lamina, density: c*x*y, region: {x: [0, a], y: [0, b*x/a]}}}
find: {m: sheet.mass, at: sheet.cm, T: sheet.inertia_tensor about sheet.center, I: sheet.inertia}
""".replace("at:", "place:")
    found = numbers(solve(scene))
    a, b, c = 0.5, 0.3, 4
    got = plate(0, a, lambda x: 0, lambda x: b * x / a, lambda x, y: c * x * y)
    assert found["m"] == pytest.approx(got["m"], rel=1e-9)
    assert found["place.x"] == pytest.approx(got["x"] / got["m"], rel=1e-9)
    assert found["place.y"] == pytest.approx(got["y"] / got["m"], rel=1e-9)
    assert found["T.xx"] == pytest.approx(got["yy"], rel=1e-9)
    assert found["T.xy"] == pytest.approx(-got["xy"], rel=1e-9)
    assert found["T.zz"] == pytest.approx(got["xx"] + got["yy"], rel=1e-9)
    assert found["I"] == pytest.approx(got["xx"] + got["yy"] - (got["x"] ** 2 + got["y"] ** 2) / got["m"], rel=1e-9)


def test_a_hollow_solid_of_revolution_and_a_graded_ball() -> None:
    scene = """
title: Cup and ball
given: {M: 3 kg, R: 0.2 m, h: 0.4 m, q: 0.1 m, rho0: 5 kg/m^3}
bodies:
  cup: {shape: solid of revolution, mass: M, profile: {z: [0, h], r: [q, q + R*z/h]}}
  ball: {shape: sphere, radius: R, density: rho0*(1 - r/R)}
find: {I: cup.inertia, z: cup.cm.z, X: cup.inertia along x, J: ball.inertia, k: ball.gyration}
"""
    found = numbers(solve(scene))
    M, R, h, q, rho0 = 3, 0.2, 0.4, 0.1, 5

    def total(part: Callable[[float, float], float]) -> float:
        return float(quad(lambda z: quad(lambda s: 2 * math.pi * s * part(s, z), [q, q + R * z / h]), [0, h]))

    rho = M / total(lambda s, z: 1)
    z = rho * total(lambda s, z: z) / M
    assert found["I"] == pytest.approx(rho * total(lambda s, z: s * s), rel=1e-9)
    assert found["z"] == pytest.approx(z, rel=1e-9)
    assert found["X"] == pytest.approx(rho * total(lambda s, z: s * s / 2 + z * z) - M * z * z, rel=1e-9)
    mass = float(quad(lambda d: 4 * math.pi * d * d * rho0 * (1 - d / R), [0, R]))
    moment = float(quad(lambda d: 8 * math.pi / 3 * d**4 * rho0 * (1 - d / R), [0, R]))
    assert found["J"] == pytest.approx(moment, rel=1e-9)
    assert found["k"] == pytest.approx(math.sqrt(moment / mass), rel=1e-9)


def test_an_integral_without_closed_form_is_certified() -> None:
    scene = """
title: Plate under a curve that no textbook integrates
given: {M: 3 kg, a: 0.5 m, b: 0.3 m}
bodies: {plate: {shape: lamina, mass: M, region: {x: [0, a], y: [0, b*exp(-x^3/a^3)]}}}
find: {I: plate.inertia along y about plate.center}
"""
    solution = solve(scene)
    got = plate(0, 0.5, lambda x: 0, lambda x: 0.3 * math.exp(-((x / 0.5) ** 3)), lambda x, y: 1)
    assert numbers(solution)["I"] == pytest.approx(3 * got["xx"] / got["m"], rel=1e-9)
