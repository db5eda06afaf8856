"""Which way a body goes at a state, where it went another way before: told by how it is tied to what goes one way, or by the time."""

from __future__ import annotations

from math import cos, pi, sin, sqrt

import pytest

from rotsolve.pipeline import solve

G = 9.8


def answers(text: str) -> dict[str, float | None]:
    """The answers of a scene, all of them confirmed."""
    solution = solve("title: by hand\n" + text)
    assert not solution.refused
    assert all(item.holds for item in solution.derivation.confirmed)
    return {name: answer.float for name, answer in solution.answers.items()}


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("until", "thrown", "moves", "event"),
    [  # half of all: each two values of different axes together
        (until, thrown, moves, (late + down + (thrown > 0)) % 2 == 0)
        for late, until in enumerate((0.1, 0.83, 2.3))
        for thrown in (-1.4, 1.4)
        for down, moves in enumerate(("up", "down"))
    ],
)
def test_what_swings_on_a_spring_turns_back_any_number_of_times(
    until: float, thrown: float, moves: str, event: bool
) -> None:
    """y = y₀ cos ωt + (u/ω) sin ωt about its place of balance, whether it starts with its speed u or is given it by a blow."""
    mass, stiff, stretch = 3.2, 180.0, 0.66
    omega, sign = sqrt(stiff / mass), 1 if moves == "up" else -1
    blow = f"{{hit: {{impulse: {abs(mass * thrown)} N s, 'on': one, direction: {'up' if thrown > 0 else 'down'}, from: start, to: after}}}}"
    found = answers(f"""
bodies: {{one: {{mass: {mass} kg, moves: {moves}}}}}
connections: {{coil: {{spring: [ceiling, one], stiffness: {stiff} N/m}}}}
states:
  start: {{coil.elongation: {stretch} m, {"at rest: all" if event else f"one.velocity: {sign * thrown} m/s"}}}
  {"after: {}" if event else ""}
  end: {{time: {until} s}}
{f"events: {blow}" if event else ""}
find: {{v: one.velocity at end}}
""")
    first = mass * G / stiff - stretch  # below the place of balance, counted up
    expected = -first * omega * sin(omega * until) + thrown * cos(omega * until)
    assert found["v"] == pytest.approx(sign * expected)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("moves", ["right", "left"])
@pytest.mark.parametrize("angles", [(50, -20), (130, 200), (130, 160), (-150, -40)])
@pytest.mark.parametrize("given", [True, False])
def test_a_truck_goes_back_where_the_rod_on_it_swings_past_the_level(
    angles: tuple[int, int], moves: str, given: bool
) -> None:
    """Its momentum is that of the rod against it, (m₁ + m₂) V = m₁ d ω sin θ, with ω as the rod falls."""
    rod, truck, length = 3.1, 3.3, 1.8
    masses = (f"mass: {rod} kg, ", f"mass: {truck} kg, ") if given else ("mass: m1, ", "mass: m2, ")
    solution = solve(f"""
title: by hand
given: {{{"" if given else f"m1: {rod} kg, m2: {truck} kg"}}}
surfaces: {{floor: level}}
bodies: {{one: {{{masses[0]}shape: rod, length: {length} m}}, cart: {{{masses[1]}moves: {moves}}}}}
connections: {{mount: {{hinge: [cart, one.at(0.6 m)]}}}}
states: {{start: {{one.angle: {angles[0]} deg, at rest: all}}, end: {{one.angle: {angles[1]} deg}}}}
find: {{v: cart.velocity at end}}
""")
    assert all(item.holds for item in solution.derivation.confirmed)
    arm, whole = 0.3, rod + truck
    start, end = (angle * pi / 180 for angle in angles)
    inertia = rod * length**2 / 12 + rod * arm**2 - (rod * arm * sin(end)) ** 2 / whole
    rate = sqrt(2 * rod * G * arm * (sin(start) - sin(end)) / inertia) * (1 if angles[1] > angles[0] else -1)
    speed = rod * arm * sin(end) * rate / whole
    assert solution.answers["v"].float == pytest.approx(speed if moves == "right" else -speed)


def test_how_far_a_truck_has_gone_does_not_tell_which_way_it_goes() -> None:
    """It has gone to the left while the rod fell to the level, d = −m₁ a (cos θ − cos θ₀)/(m₁ + m₂), and comes back from there."""
    solution = solve("""
title: by hand
surfaces: {floor: level}
bodies: {one: {mass: 3.1 kg, shape: rod, length: 1.8 m}, cart: {mass: 3.3 kg, moves: right}}
connections: {mount: {hinge: [cart, one.at(0.6 m)]}}
states: {start: {one.angle: 50 deg, at rest: all}, end: {one.angle: -20 deg}}
find: {d: cart.displacement from start to end, v: cart.velocity at end}
""")
    gone = -3.1 * 0.3 * (cos(pi / 9) - cos(5 * pi / 18)) / 6.4
    assert solution.answers["d"].float == pytest.approx(gone)
    assert solution.answers["v"].float == pytest.approx(0.2129475041)
    assert all(item.holds for item in solution.derivation.confirmed)
