"""What acts inside rods, blows on them and heavy ropes, by routes of their own: many point masses, sums over time, quadrature."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import mpmath
import pytest

from stepping import G, State, answer, bisect, given, reach, run, until

PIECES = 4000


def inside(mass: float, length: float, angle: float, spin: float, rate: float, x: float) -> tuple[float, float, float]:
    """(bending moment, shear, compression) at x of a rod turning about its start: what its point masses beyond x ask for."""
    along, across = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    bending = shear = compression = 0.0
    for k in range(PIECES):
        s = (k + 0.5) / PIECES * (length - x) + x
        m = mass / length * (length - x) / PIECES
        pull = [m * (rate * s * across[i] - spin**2 * s * along[i]) for i in (0, 1)]
        pull[1] += m * G  # what holds it must carry its weight too
        compression += pull[0] * along[0] + pull[1] * along[1]
        shear += pull[0] * across[0] + pull[1] * across[1]
        bending -= (s - x) * (pull[0] * across[0] + pull[1] * across[1])
    return bending, shear, compression


@cache
def fall(length: float, down_to: float) -> tuple[float, float]:
    """(angular velocity, angular acceleration) of a hinged rod of point masses that tips over from the upright."""
    arms = [(k + 0.5) / 200 * length for k in range(200)]
    inertia, moment = sum(arm**2 for arm in arms), sum(arms)

    def rate(_: float, angle: float, spin: float) -> float:
        return -moment * G * math.cos(angle) / inertia

    *_, spin = reach(rate, math.pi / 2 - 1e-5, 0.0, lambda _, angle, spin: angle - down_to, 1e-2)
    return spin, rate(0, down_to, spin)


@pytest.mark.parametrize("part", [0.0, 0.2, 1 / 3, 0.7])
def test_a_falling_chimney_is_held_together_by_what_its_bricks_need(part: float) -> None:
    name = "falling-chimney"
    mass, length, angle = (given(name, letter) for letter in ("M", "L", "theta"))
    spin, rate = fall(length, angle)
    found = inside(mass, length, angle, spin, rate, part * length)
    for asked, expected in zip(("B", "V", "C"), found, strict=True):
        assert answer(name, asked, x=part * length) == pytest.approx(expected, rel=3e-4, abs=2e-4 * mass * G)


def test_a_chimney_breaks_where_a_search_finds_most_bending() -> None:
    name = "falling-chimney"
    mass, length, angle = (given(name, letter) for letter in ("M", "L", "theta"))
    spin, rate = fall(length, angle)
    most = max((inside(mass, length, angle, spin, rate, k / 60 * length)[0], k / 60 * length) for k in range(61))
    assert answer(name, "x_B") == pytest.approx(most[1], rel=1e-9)
    assert answer(name, "B_max") == pytest.approx(most[0], rel=1e-4)


def test_the_top_of_a_chimney_outruns_free_fall_at_the_angle_of_a_step_by_step_fall() -> None:
    name = "chimney-tip-outruns-gravity"
    length, angle = given(name, "L"), answer(name, "theta")
    for shift, slower in ((0.01, True), (-0.01, False)):
        spin, rate = fall(length, angle + shift)
        downward = -(rate * length * math.cos(angle + shift) - spin**2 * length * math.sin(angle + shift))
        assert (downward < G) == slower
    assert answer(name, "omega") == pytest.approx(fall(length, angle)[0], rel=1e-4)


@pytest.mark.parametrize("part", [0.0, 0.3, 0.9])
def test_a_whirled_rod_is_pulled_by_the_integral_of_what_is_beyond(part: float) -> None:
    name = "whirled-rod"
    mass, load, length, spin = (given(name, letter) for letter in ("M", "m", "L", "omega"))
    rod = mpmath.quad(lambda s: mass / length * spin**2 * s, [part * length, length])
    assert answer(name, "T", x=part * length) == pytest.approx(float(rod) + load * spin**2 * length, rel=1e-12)


@pytest.mark.parametrize("part", [0.1, 0.5, 0.8])
def test_a_rod_just_let_go_bends_as_its_point_masses_do(part: float) -> None:
    name = "released-rod-inside"
    mass, length = given(name, "M"), given(name, "L")
    arms = [(k + 0.5) / PIECES for k in range(PIECES)]
    rate = -G * sum(arms) / sum(arm**2 for arm in arms) / length
    bending, shear, _ = inside(mass, length, 0.0, 0.0, rate, part * length)
    assert answer(name, "B", x=part * length) == pytest.approx(bending, rel=1e-5, abs=1e-5)
    assert answer(name, "V", x=part * length) == pytest.approx(shear, rel=1e-5, abs=1e-5)


def test_a_plank_is_cut_on_its_left_where_the_program_cuts_on_its_right() -> None:
    name = "plank-on-trestles"
    mass, crate, length, b, a, x = (given(name, letter) for letter in ("M", "m", "L", "b", "a", "x"))
    boards = [((k + 0.5) / PIECES * length, mass * G / PIECES) for k in range(PIECES)]
    loads = [*boards, (a, crate * G)]
    push = sum(weight * (length - place) for place, weight in loads) / (length - b)
    assert answer(name, "N") == pytest.approx(push, rel=1e-9)
    for asked, cut in (("B", x), ("B_a", a)):
        left = [(place, weight) for place, weight in loads if place < cut]
        bending = push * (cut - b) - sum(weight * (cut - place) for place, weight in left)
        assert answer(name, asked) == pytest.approx(bending, rel=1e-6)
    assert answer(name, "V") == pytest.approx(push - sum(weight for place, weight in loads if place < x), rel=1e-3)


@pytest.mark.parametrize("place", [0.2, 0.6, 0.9])
def test_a_short_strong_push_gives_the_hinge_the_impulse_of_a_blow(place: float) -> None:
    name, short = "centre-of-percussion", 1e-4
    mass, length, blow = (given(name, letter) for letter in ("M", "L", "J"))
    inertia = mass * sum(((k + 0.5) / PIECES * length) ** 2 for k in range(PIECES)) / PIECES

    def rate(_: float, state: State) -> State:
        angle, spin, _ = state
        turned = (blow / short * place * math.cos(angle) - mass * G * length / 2 * math.sin(angle)) / inertia
        sideways = mass * length / 2 * (turned * math.cos(angle) - spin**2 * math.sin(angle))
        return spin, turned, sideways - blow / short

    _, spin, hinge = run(rate, (0.0, 0.0, 0.0), short, 100)
    assert answer(name, "omega", x=place) == pytest.approx(spin, rel=1e-3)
    assert answer(name, "J_pin", x=place) == pytest.approx(hinge, rel=1e-3, abs=1e-3)


def test_the_point_of_a_struck_rod_that_stays_is_found_by_bisection() -> None:
    name = "rod-on-ice-blow"
    mass, length, place, blow = (given(name, letter) for letter in ("M", "L", "a", "J"))
    arms = [(k + 0.5) / PIECES * length - length / 2 for k in range(PIECES)]
    spin = blow * (place - length / 2) / (mass * sum(arm**2 for arm in arms) / PIECES)
    still = bisect(lambda y: blow / mass + spin * (y - length / 2), 0.0, length)
    assert answer(name, "y_0") == pytest.approx(still, rel=1e-6)
    assert answer(name, "omega") == pytest.approx(spin, rel=1e-6)


def test_a_ball_that_bounces_like_a_spring_leaves_the_hand_alone_at_the_sweet_spot() -> None:
    name = "bat-sweet-spot"
    mass, lump, ball, length, speed, bounce = (given(name, letter) for letter in ("M", "m", "m_b", "L", "u", "e"))
    place, inertia, lever = answer(name, "x"), (mass / 3 + lump) * length**2, (mass / 2 + lump) * length
    stiff = 1e7

    def rate(_: float, state: State) -> State:
        pressed, closing = state[0], state[1] - place * state[2]
        push = max(0.0, stiff * pressed * (1 if closing > 0 else bounce**2))  # gives back e² of the energy
        turned = push * place / inertia
        return closing, -push / ball, turned, lever * turned - push

    _, final = until(rate, (0.0, speed, 0.0, 0.0), lambda _, state: state[0], 1e-7)
    assert answer(name, "v") == pytest.approx(final[1], rel=1e-3)
    assert answer(name, "omega") == pytest.approx(final[2], rel=1e-3)
    assert abs(final[3]) < 1e-9 * ball * speed


def test_two_hinged_rods_bend_as_their_point_masses_ask_for() -> None:
    name = "two-rods-released-inside"
    inner, outer, length = (given(name, letter) for letter in ("M", "m", "L"))
    first, second = answer(name, "alpha_1"), answer(name, "alpha_2")
    arms = [(k + 0.5) / PIECES * length for k in range(PIECES)]
    near = [inner / PIECES * (first * s + G) for s in arms]  # what holds each mass must give it, upwards
    far = [outer / PIECES * (first * length + second * s + G) for s in arms]
    assert sum(f * s for f, s in zip(far, arms, strict=True)) == pytest.approx(0, abs=1e-4)  # none about the joint
    pull = sum(far)
    assert sum(f * s for f, s in zip(near, arms, strict=True)) + pull * length == pytest.approx(0, abs=1e-4)
    middle = length / 2
    bent = sum(f * (s - middle) for f, s in zip(near, arms, strict=True) if s > middle) + pull * middle
    assert answer(name, "B_1") == pytest.approx(-bent, rel=1e-4)
    bent = sum(f * (s - middle) for f, s in zip(far, arms, strict=True) if s > middle)
    assert answer(name, "B_2") == pytest.approx(-bent, rel=1e-4)


def test_a_rod_swung_with_that_spin_pulls_at_nothing_when_it_is_upright() -> None:
    name = "rod-over-the-top"
    length = given(name, "L")

    *_, spin = reach(
        lambda _, angle, spin: -1.5 * G * math.cos(angle) / length,
        -math.pi / 2,
        answer(name, "omega_0"),
        lambda _, angle, spin: angle - math.pi / 2,
    )
    assert answer(name, "omega") == pytest.approx(spin, rel=1e-8)
    assert spin**2 * length / 2 == pytest.approx(G, rel=1e-8)  # weight alone bends the way of its centre


def test_a_plank_tips_where_its_boards_and_the_child_balance_on_the_right_trestle() -> None:
    name = "plank-tips"
    mass, child, length, back = (given(name, letter) for letter in ("M", "m", "L", "c"))
    boards = [((k + 0.5) / PIECES * length, mass / PIECES) for k in range(PIECES)]
    planks = sum(m * (x - length + back) for x, m in boards)
    tips = bisect(lambda x: planks + child * (x - length + back), 0.0, length)
    assert answer(name, "a") == pytest.approx(tips, rel=1e-9)
    assert answer(name, "N") == pytest.approx((mass + child) * G, rel=1e-12)


@pytest.mark.parametrize("part", [0.1, 0.5, 0.75])
def test_a_ladder_is_cut_at_its_foot_where_the_program_cuts_at_its_top(part: float) -> None:
    name = "ladder-inside"
    mass, length, angle = (given(name, letter) for letter in ("M", "L", "theta"))
    rungs = [((k + 0.5) / PIECES * length, mass * G / PIECES) for k in range(PIECES)]
    wall = sum(weight * s * math.cos(angle) for s, weight in rungs) / (length * math.sin(angle))
    x = part * length
    below = [(s, weight) for s, weight in rungs if s < x]
    right, up = (
        wall,
        mass * G - sum(weight for _, weight in below),
    )  # the floor's push on the foot, less the weight below
    assert answer(name, "C", x=x) == pytest.approx(right * math.cos(angle) + up * math.sin(angle), rel=1e-3)
    assert answer(name, "V", x=x) == pytest.approx(up * math.cos(angle) - right * math.sin(angle), rel=1e-3, abs=0.1)
    bending = (mass * G * math.cos(angle) - wall * math.sin(angle)) * x
    bending -= sum(weight * (x - s) * math.cos(angle) for s, weight in below)
    assert answer(name, "B", x=x) == pytest.approx(bending, rel=1e-6)


def beads(number: int, mass: float, length: float, hanging: float, rim: float, *, rest_hangs: bool) -> float:
    """Force of gravity forward along a chain of beads: down on one side of a rim, up the other, nothing on a table or a drum."""
    force = 0.0
    for k in range(number):
        place = hanging - (k + 0.5) / number * length  # from the last point of the rim, forward
        if place > 0:
            force += mass / number * G
        elif place > -math.pi * rim:
            force += mass / number * G * math.cos(-place / rim)
        elif rest_hangs:
            force -= mass / number * G
    return force


def slide(inertia: float, force: Callable[[float], float], start: float, end: float) -> float:
    """The speed at the end of a way from rest."""
    *_, speed = reach(lambda _, x, v: force(x) / inertia, start, 0.0, lambda _, x, v: x - end, 4e-3)
    return speed


def test_beads_run_over_a_pulley_as_the_rope_does() -> None:
    name = "rope-over-pulley"
    mass, length, wheel, rim, hanging = (given(name, letter) for letter in ("m", "L", "M", "R", "b"))
    inertia = mass + wheel / 2

    def force(x: float) -> float:
        return beads(200, mass, length, x, rim, rest_hangs=True)

    fine = beads(PIECES, mass, length, hanging, rim, rest_hangs=True)
    assert answer(name, "a") == pytest.approx(fine / inertia, rel=1e-3)
    assert answer(name, "v") == pytest.approx(slide(inertia, force, hanging, length - math.pi * rim), rel=5e-3)
    assert answer(name, "omega") * rim == pytest.approx(answer(name, "v"))


@pytest.mark.parametrize("name", ["rope-over-peg", "chain-off-table"])
def test_beads_run_off_as_the_rope_does(name: str) -> None:
    mass, length, hanging = (given(name, letter) for letter in ("m", "L", "b"))

    def force(x: float) -> float:
        return beads(200, mass, length, x, 0.0, rest_hangs=name == "rope-over-peg")

    assert answer(name, "a") == pytest.approx(force(hanging) / mass, rel=1e-9)
    assert answer(name, "v") == pytest.approx(slide(mass, force, hanging, length), rel=1e-3)


def test_beads_unwind_with_their_bucket() -> None:
    name = "bucket-on-heavy-rope"
    mass, length, drum, load, hanging, way = (given(name, letter) for letter in ("m", "L", "M", "m_b", "b", "h"))
    inertia = mass + drum / 2 + load

    def force(x: float) -> float:
        return load * G + beads(200, mass, length, x, 0.0, rest_hangs=False)

    assert answer(name, "a") == pytest.approx(force(hanging) / inertia, rel=1e-9)
    assert answer(name, "a_low") == pytest.approx(force(hanging + way) / inertia, rel=1e-9)
    assert answer(name, "T") == pytest.approx(load * (G - force(hanging) / inertia), rel=1e-9)
    assert answer(name, "v") == pytest.approx(slide(inertia, force, hanging, hanging + way), rel=1e-3)
