"""A body that rolls on the rim of one of its parts: as one that is welded together of the same, and as energy says."""

from __future__ import annotations

from itertools import product
from math import radians, sin, sqrt

import pytest

from rotsolve.pipeline import solve

M, m, R, g, u = 5.0, 1.0, 0.5, 10.0, 1.0
SHAPES = {"ring": 1.0, "disc": 0.5}
BODY = {
    "parts": "hoop: {{parts: {{wheel: {{shape: {shape}, mass: 5 kg, radius: R}}, lead: {{mass: 1 kg, at: [0, R]}}}}, moves: {way}}}",
    "weld": "hoop: {{shape: {shape}, mass: 5 kg, radius: R, moves: {way}, points: {{P: [0, R]}}}}, lead: {{mass: 1 kg}}",
}
JOINED = {
    "parts": "touch: {rolls: [hoop.wheel, floor]}",
    "weld": "touch: {rolls: [hoop, floor]}, glue: {weld: [hoop.P, lead]}",
}


ON = {"right": (30, 0, -90), "left": (150, 180, 270)}  # where the lead gets on its way down


@pytest.mark.parametrize(
    ("made", "shape", "way", "angle"),
    [(made, shape, way, angle) for made, shape, way in product(BODY, SHAPES, ON) for angle in ON[way]],
)
def test_it_rolls_on_the_rim_of_a_part(made: str, shape: str, way: str, angle: float) -> None:
    """½ (k M R² + M R² + m d²) ω² + m g R sin φ stays, where d² = 2 R² (1 + sin φ) is from the point of contact to the lead."""
    solution = solve(f"""title: A wheel with a lead at its rim
given: {{R: 0.5 m, u: 1 m/s, g: 10 m/s^2}}
surfaces: {{floor: level}}
bodies: {{{BODY[made].format(shape=shape, way=way)}}}
connections: {{{JOINED[made]}}}
states: {{top: {{hoop.velocity: u, hoop.angle: 90 deg}}, gone: {{hoop.angle: {angle} deg}}}}
find: {{v: hoop.velocity at gone, N: touch.normal_force at top}}
""")

    def inertia(phi: float) -> float:
        return (1 + SHAPES[shape]) * M * R**2 + 2 * m * R**2 * (1 + sin(phi))

    wanted = (
        sqrt(
            (inertia(radians(90)) * (u / R) ** 2 + 2 * m * g * R * (1 - sin(radians(angle)))) / inertia(radians(angle))
        )
        * R
    )
    assert solution.answers["v"].float == pytest.approx(wanted, rel=2e-3)
    assert solution.answers["N"].float == pytest.approx((M + m) * g - m * u**2 / R, rel=2e-3)
    assert all(item.holds for item in solution.derivation.confirmed) and solution.derivation.confirmed
