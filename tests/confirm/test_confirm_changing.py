"""Bodies that change, ride, brake and rub: confirmed by stepping hand-written equations of motion in time, without the solver's laws."""

from __future__ import annotations

import math

import pytest

from stepping import PROBLEMS, G, Rate, State, answers, run, until

SCENES = PROBLEMS.parent / "tests" / "engine" / "scenes"


def smooth(x: float) -> tuple[float, float, float]:
    """A way from 0 to 1 that starts and ends at rest, with its first and second derivatives."""
    return 3 * x**2 - 2 * x**3, 6 * x - 6 * x**2, 6 - 12 * x


@pytest.mark.parametrize(
    ("name", "inertia", "mass", "start", "end", "omega", "asked"),
    [
        ("man-walks-inwards", 120 * 2.2**2 / 2, 65.0, 2.2, 0.7, 1.6, ("omega_f", "W")),
        ("beads-drawn-inwards", 0.06, 0.4, 0.45, 0.15, 4.0, ("w2", "W")),
    ],
)
def test_what_rides_inwards_by_its_coriolis_force(
    name: str, inertia: float, mass: float, start: float, end: float, omega: float, asked: tuple[str, str]
) -> None:
    """The rider pushes the carrier round with the force 2 m ṙ ω + m r α; along the way it is drawn with m (r̈ − r ω²)."""

    def rate(time: float, state: State) -> State:
        share, speed, growth = smooth(time)
        radius, inward, change = start + (end - start) * share, (end - start) * speed, (end - start) * growth
        turn = -2 * mass * radius * inward * state[0] / (inertia + mass * radius**2)
        drawing = mass * (change - radius * state[0] ** 2) * inward
        pushing = mass * (2 * inward * state[0] + radius * turn) * radius * state[0]
        return turn, drawing + pushing + inertia * turn * state[0]

    final = run(rate, (omega, 0.0), 1.0)
    found = answers(name)
    assert found[asked[0]] == pytest.approx(final[0], rel=1e-9)
    assert found[asked[1]] == pytest.approx(final[1], rel=1e-9)


def test_man_with_weights_by_a_growing_moment_of_inertia() -> None:
    """d(I ω) = 0 stepped, and his work as ½ ∫ (−dI) ω²: what it takes to draw masses in against m r ω²."""

    def rate(time: float, state: State) -> State:
        inertia, growth = 15 - 12 * time, -12.0
        return -growth * state[0] / inertia, -growth * state[0] ** 2 / 2

    final = run(rate, (0.6 * math.pi, 0.0), 1.0)
    found = answers("man-with-weights")
    assert found["omega_f_rad"] == pytest.approx(final[0], rel=1e-9)
    assert found["delta_K"] == pytest.approx(final[1], rel=1e-9)


def test_beads_drawn_in_by_their_coriolis_force_until_the_bar_turns_twice_as_fast() -> None:
    """Drawn in evenly, they push the bar round with 2 m ṙ ω each, less what they take up themselves."""
    bar, mass, start, turn, inward = 0.06, 2 * 0.2, 0.45, 4.0, 0.1

    def rate(time: float, state: State) -> State:
        radius = start - inward * time
        return (2 * mass * radius * inward * state[0] / (bar + mass * radius**2),)

    time, _ = until(rate, (turn,), lambda _, state: state[0] - 2 * turn)
    assert answers("beads-to-double-speed")["r"] == pytest.approx(start - inward * time, rel=1e-9)


def test_sand_on_a_turntable_grain_by_grain() -> None:
    """A grain dm that falls on the disc is rubbed up to its speed: that brakes with r² ω dm, and half the rubbing's power is heat."""
    disc, radius = 3.0 * 0.25**2 / 2, 0.2

    def rate(fallen: float, state: State) -> State:
        return -(radius**2) * state[0] / (disc + fallen * radius**2), (radius * state[0]) ** 2 / 2

    turn, heat = run(rate, (4.0, 0.0), 0.8)
    found = answers("sand-on-a-turntable")
    assert found["omega"] == pytest.approx(turn, rel=1e-9)
    assert found["Q"] == pytest.approx(heat, rel=1e-9)


def test_bead_flung_along_a_bar_in_the_turning_frame() -> None:
    """r̈ = r ω² on the smooth bar, whose push −2 m ṙ ω − m r α turns the bar back."""
    bar, mass = 1.2 * 0.8**2 / 3, 0.5

    def rate(_: float, state: State) -> State:
        radius, outward, turn = state
        return outward, radius * turn**2, -2 * mass * radius * outward * turn / (bar + mass * radius**2)

    _, (radius, outward, turn) = until(rate, (0.2, 0.0, 6.0), lambda _, state: 0.8 - state[0])
    found = answers("bead-flung-along-a-bar")
    assert found["omega"] == pytest.approx(turn, rel=1e-9)
    assert found["u"] == pytest.approx(outward, rel=1e-9)
    assert found["v"] == pytest.approx(math.hypot(outward, radius * turn), rel=1e-9)


def test_man_walking_round_by_the_force_of_his_feet() -> None:
    """He speeds up smoothly to u for a second, then walks on; his feet push the rim back with what speeds him up."""
    mass, radius, inertia, speed = 70.0, 2.0, 420.0, 1.5

    def rate(time: float, state: State) -> State:
        table, man, _, _, _ = state
        # rate of the angular velocity relative to the table
        wanted = 0.0 if time > 1 else smooth(time)[1] * speed / radius
        force = wanted / (1 / (mass * radius) + radius / inertia)
        return -force * radius / inertia, force / (mass * radius), table, man, force * radius * (man - table)

    time, final = until(rate, (0.0,) * 5, lambda _, state: 2 * math.pi - (state[3] - state[2]))
    found = answers("man-walks-round")
    assert time > 1
    for key, value in zip(("omega_t", "omega_m", "theta_t", "theta_m", "W"), final, strict=True):
        assert found[key] == pytest.approx(value, rel=1e-6), key


def test_wheel_on_a_stool_by_rubbing_hand_and_motor() -> None:
    """A hand rubs with a torque of its own until the wheel is at rest against him, then drives it back."""
    stool, wheel, omega = 1.6375, 0.4625, 57.7

    def rub(time: float, state: State) -> State:
        torque = 1.3 + math.sin(7 * time) ** 2
        return torque / stool, -torque / wheel, torque * (state[1] - state[0])

    _, stopped = until(rub, (0.0, omega, 0.0), lambda _, state: state[1] - state[0])
    _, turned = until(rub, (stopped[0], stopped[1], 0.0), lambda _, state: state[1] - state[0] + omega)
    found = answers("wheel-on-a-stool")
    assert found["omega1"] == pytest.approx(stopped[0], rel=1e-9)
    assert found["Q"] == pytest.approx(stopped[2], rel=1e-9)
    assert found["omega2"] == pytest.approx(turned[0], rel=1e-9)
    assert found["W"] == pytest.approx(-turned[2], rel=1e-9)


def test_brake_block_by_the_rubbed_length() -> None:
    """Time, turns and the heat f · (length of rim that has passed under the block)."""
    inertia, radius, friction = 90 * 0.34**2 / 2, 0.34, 0.2 * 20

    def rate(_: float, state: State) -> State:
        return -friction * radius / inertia, state[0], friction * radius * state[0]

    time, final = until(rate, (90 * 2 * math.pi / 60, 0.0, 0.0), lambda _, state: state[0])
    found = answers("brake-block")
    assert found["t"] == pytest.approx(time, rel=1e-9)
    assert found["n"] == pytest.approx(final[1] / (2 * math.pi), rel=1e-9)
    assert found["Q"] == pytest.approx(final[2], rel=1e-9)
    assert found["tau"] == pytest.approx(-friction * radius)
    assert found["alpha"] == pytest.approx(rate(0, final)[0])


def test_clutch_by_friction_of_the_plates() -> None:
    first, second, torque, omega = 1.0, 3.0, 12.0, 20 * math.pi

    def rate(_: float, state: State) -> State:
        one, two = state[:2]
        return -torque / first, torque / second, one, two, torque * (one - two)

    time, final = until(rate, (omega, 0.0, 0.0, 0.0, 0.0), lambda _, state: state[0] - state[1])
    found = answers("clutch-of-two-discs")
    assert found["t"] == pytest.approx(time, rel=1e-9)
    share = final[4] / (first * omega**2 / 2)
    for key, value in zip(("omega", "a1", "a2", "Q", "share"), (final[0], *final[2:], share), strict=True):
        assert found[key] == pytest.approx(value, rel=1e-9), key


def test_wheels_rubbed_together_by_friction_at_the_rims() -> None:
    """Friction at the rims slows one and speeds up the other; heat is friction times the length slipped."""
    (one, two), (large, small), friction = (0.8, 0.5), (0.2, 0.1), 0.4 * 25

    def rate(_: float, state: State) -> State:
        slip = large * state[0] + small * state[1]
        return -friction * large / one, -friction * small / two, friction * slip

    time, final = until(rate, (60.0, 0.0, 0.0), lambda _, state: large * state[0] + small * state[1])
    found = answers("wheels-rubbed-together")
    for key, value in zip(("t", "w1", "w2", "Q"), (time, *final), strict=True):
        assert found[key] == pytest.approx(value, rel=1e-9), key
    before, after = one * 60.0, one * final[0] + two * final[1]
    assert abs(before - after) > 1, "angular momentum is not conserved here"


def test_cylinder_between_floor_and_wall_by_energy_rubbed_away() -> None:
    """N + μ S = m g and S = μ N by fixed-point iteration; the spin energy goes into friction at both places."""
    mass, radius, omega, mu = 4.0, 0.12, 45.0, 0.25
    floor = side = 0.0
    for _ in range(60):
        floor, side = mass * G - mu * side, mu * floor
    energy = mass * radius**2 / 2 * omega**2 / 2
    angle = energy / (mu * (floor + side) * radius)
    found = answers("cylinder-between-floor-and-wall")
    assert found["N"] == pytest.approx(floor, rel=1e-9)
    assert found["n"] == pytest.approx(angle / (2 * math.pi), rel=1e-9)
    assert found["t"] == pytest.approx(2 * angle / omega, rel=1e-9)


def sliding(share: float, mu: float, radius: float, way: float) -> Rate:
    """Velocity, spin (forward turn positive), place and angle of a round body with I = share · m R² whose contact slides one way."""

    def rate(_: float, state: State) -> State:
        return -way * mu * G, way * mu * G / (share * radius), state[0], state[1]

    return rate


def test_ball_with_back_spin_by_steps() -> None:
    radius, mu = 0.11, 0.3
    rate = sliding(0.4, mu, radius, 1.0)
    start = (2.0, -80.0, 0.0, 0.0)
    first, turning = until(rate, start, lambda _, state: state[0])
    second, rolling = until(rate, start, lambda _, state: state[0] - radius * state[1])
    found = answers("ball-with-back-spin")
    expected = {"t1": first, "x1": turning[2], "t2": second, "v": rolling[0], "x2": rolling[2]}
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-9), key


def test_bowling_ball_by_steps() -> None:
    """Friction slows it and turns it until it rolls; the heat is friction times the length slipped."""
    mass, radius, mu, speed = 6.0, 0.11, 0.21, 8.5
    slide = sliding(0.4, mu, radius, 1.0)

    def rate(time: float, state: State) -> State:
        return *slide(time, state[:4]), mu * mass * G * (state[0] - radius * state[1])

    time, final = until(rate, (speed, 0.0, 0.0, 0.0, 0.0), lambda _, state: state[0] - radius * state[1])
    found = answers("bowling-ball")
    expected = {"t": time, "v": final[0], "x": final[2], "share": final[4] / (mass * speed**2 / 2)}
    expected |= dict(zip(("a", "alpha"), rate(0, final)[:2], strict=True))
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-9), key


def test_spinning_cylinder_set_down_by_steps() -> None:
    radius, mu, omega = 0.1, 0.2, 60.0
    time, final = until(
        sliding(0.5, mu, radius, -1.0), (0.0, omega, 0.0, 0.0), lambda _, state: radius * state[1] - state[0]
    )
    found = answers("spinning-cylinder-set-down")
    kept = (final[0] ** 2 + 0.5 * (radius * final[1]) ** 2) / (0.5 * (radius * omega) ** 2)
    expected = {"t": time, "v": final[0], "x": final[2], "n": final[3] / (2 * math.pi), "share": 1 - kept}
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-9), key


def test_ball_up_a_slope_and_back_by_steps() -> None:
    """Rolling: 7/5 m a = −m g sin β all the way, friction turns the ball."""
    mass, beta, speed = 0.5, math.radians(20), 3.0
    slowing = -5 * G * math.sin(beta) / 7

    def rate(_: float, state: State) -> State:
        return slowing, state[0]

    up, top = until(rate, (speed, 0.0), lambda _, state: state[0])
    down, back = until(rate, top, lambda _, state: state[1])
    found = answers("ball-rolls-up-and-back")
    expected = {"s": top[1], "t": up, "T": up + down, "v": back[0], "f": -0.4 * mass * slowing}
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-6), key


def test_a_driven_clutch_that_slips_and_then_sticks() -> None:
    plate, disc, motor, friction = 0.6, 0.9, 2.0, 9.0

    def slipping(_: float, state: State) -> State:
        return (motor - friction) / plate, friction / disc, state[0] - state[1]

    time, one = until(slipping, (30.0, 0.0, 0.0), lambda _, state: state[0] - state[1])
    together = motor / (plate + disc)
    found = answers("clutch-slips-and-sticks", SCENES)
    expected = {"t": time, "wd": -one[1], "we": one[0] + together * 5, "tq": -disc * together, "slid": one[2]}
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-9), key


def test_driven_wheels_that_slip_at_their_rims_and_then_roll() -> None:
    (large, small), (radius, rim), motor, friction = (3 * 0.2**2 / 2, 0.15**2), (0.2, 0.15), 0.3, 0.5 * 20

    def slipping(_: float, state: State) -> State:
        return (motor - friction * radius) / large, friction * rim / small

    time, even = until(slipping, (50.0, -2.0), lambda _, state: radius * state[0] - rim * state[1])
    growth = motor / (large + small * (radius / rim) ** 2)
    found = answers("contact-wheels-slip-then-roll", SCENES)
    assert found["t"] == pytest.approx(time, rel=1e-9)
    assert found["wl"] == pytest.approx(even[0], rel=1e-9)
    assert found["ws"] == pytest.approx(even[1] + growth * radius / rim * 10, rel=1e-9)
    assert found["f"] == pytest.approx(small * growth * radius / rim / rim, rel=1e-9)


def test_a_load_on_a_brake_that_is_too_weak_or_strong_enough() -> None:
    friction, radius, hub, inertia, mass = 0.4 * 50, 0.25, 0.1, 0.1, 30.0
    falling = (mass * G * hub - friction * radius) / (inertia / hub + mass * hub)
    found = answers("action-press-slips", SCENES)
    assert found["a"] == pytest.approx(falling, rel=1e-9)
    assert found["T"] == pytest.approx(mass * (G - falling), rel=1e-9)
    slower = run(lambda time, _: (-0.4 * 8 * time * radius / 0.2,), (12.0,), 0.5)
    assert found["omega"] == pytest.approx(slower[0], rel=1e-9)
    holding = answers("action-press-holds", SCENES)
    assert holding["f"] == pytest.approx(8 * G * hub / radius, rel=1e-9) and holding["f"] < 0.4 * 150


def test_a_carpet_that_unrolls_by_lagranges_equation() -> None:
    """L = ¾ m ẋ² − m g r with r² = R² (1 − x/ℓ), m = M (1 − x/ℓ), stepped in time; its length ℓ does not matter for the speeds."""
    whole, radius, length = 24.0, 0.2, 7.0

    def rate(_: float, state: State) -> State:
        speed, way = state
        left = 1 - way / length
        push = 0.75 * speed**2 / length + 1.5 * G * radius * math.sqrt(left) / length
        return push / (1.5 * left), speed

    def speed_at(now: float) -> float:
        _, state = until(rate, (0.0, 0.0), lambda _, state: length * (1 - (now / radius) ** 2) - state[1])
        return state[0]

    found = answers("carpet-unrolls")
    assert found["v"] == pytest.approx(speed_at(0.15), rel=1e-6)
    assert found["omega"] == pytest.approx(speed_at(0.15) / 0.15, rel=1e-6)
    assert found["v_h"] == pytest.approx(speed_at(0.1), rel=1e-6)
    assert found["m"] == whole / 4
    assert found["K"] == pytest.approx(0.75 * whole / 4 * found["v_h"] ** 2, rel=1e-12)
