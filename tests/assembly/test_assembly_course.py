"""The course of a scene, followed by the assembly from state to state, held against what is found by hand."""

from __future__ import annotations

import math

import pytest

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.asked import Asker
from rotsolve.confirm.course.following import Broken, Course
from rotsolve.confirm.course.node import Budget
from rotsolve.confirm.course.samples import sets_of_numbers
from rotsolve.motion.complete import configured
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_source

G = 9.8
CLOSE = 1e-8


def asked(text: str, said: float = math.nan, instants: int = 5000, **numbers: float) -> dict[str, float]:
    """What the assembly answers to the questions of a scene; `said` is tried where a letter is asked for."""
    problem = configured(read_source("title: by hand\n" + text)).problem
    known = {**next(sets_of_numbers(problem)), **numbers}
    asker = Asker(problem, Course(problem, known, Budget(instants)))
    return {find.name: asker.answer(find, {"": said}).number for find in problem.finds}


BLOCK = """
given: {m: 2 kg, mu: 0.25, u: 6 m/s}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}}
"""


def test_what_slides_stops_and_stays() -> None:
    """v²/(2 μ g) from u to rest, however long one waits; its friction has then done − ½ m u²."""
    text = f"""{BLOCK}
states: {{start: {{block.velocity: u}}, end: {{time: 30 s}}}}
find: {{v: block.velocity at end, x: block.displacement from start to end, W: base.work from start to end}}
"""
    found = asked(text)
    assert found["v"] == pytest.approx(0.0, abs=1e-9)
    assert found["x"] == pytest.approx(36 / (2 * 0.25 * G), rel=CLOSE)
    assert found["W"] == pytest.approx(-36.0, rel=CLOSE)


def test_a_ball_slides_and_then_rolls() -> None:
    """v = 5 u/7 from t = 2 u/(7 μ g) on."""
    text = """
given: {R: 11 cm, u: 5 m/s, mu: 0.2, T: 9 s}
surfaces: {lane: level}
bodies: {bowl: {shape: sphere, mass: 3 kg, radius: R, moves: right, turns: clockwise}}
connections: {grip: {contact: [bowl, lane], friction: mu}}
states: {thrown: {bowl.velocity: u, bowl.angular_velocity: 0}, rolling: {grip: rolls}, late: {time: T}}
find: {t: time from thrown to rolling, v: bowl.velocity at late, w: bowl.angular_velocity at late}
"""
    found = asked(text)
    assert found["t"] == pytest.approx(2 * 5 / (7 * 0.2 * G), rel=CLOSE)
    assert found["v"] == pytest.approx(25 / 7, rel=CLOSE)
    assert found["w"] == pytest.approx(25 / 7 / 0.11, rel=CLOSE)


def test_a_slip_turns_round_on_a_slope() -> None:
    """Up against gravity and friction, down against friction alone: each leg by its own deceleration."""
    text = """
given: {beta: 30 deg, mu: 0.2, u: 7 m/s}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {crate: {mass: 4 kg, moves: up}}
connections: {base: {contact: [crate, ramp], friction: mu}}
states: {start: {crate.velocity: u}, back: {crate.displacement: 0}}
find: {v: crate.velocity at back, t: time from start to back}
"""
    up, down = (G * (math.sin(math.pi / 6) + sign * 0.2 * math.cos(math.pi / 6)) for sign in (1, -1))
    way = 49 / (2 * up)
    found = asked(text)
    assert found["v"] == pytest.approx(-math.sqrt(2 * down * way), rel=CLOSE)
    assert found["t"] == pytest.approx(7 / up + math.sqrt(2 * way / down), rel=CLOSE)


def test_a_state_that_repeats_the_first_is_the_next_one() -> None:
    text = """
given: {u: 6 m/s}
bodies: {stone: {mass: 1 kg, moves: up}}
states: {thrown: {stone.velocity: u}, caught: {stone.displacement: 0}}
find: {v: stone.velocity at caught, t: time from thrown to caught}
"""
    assert asked(text) == pytest.approx({"v": -6.0, "t": 12 / G}, rel=CLOSE)


ROD = """
given: {L: 1.2 m}
bodies: {rod: {shape: rod, mass: 2 kg, length: L}}
connections: {pin: {hinge: rod.start}}
"""


def test_a_rod_swings_down_by_its_energy_and_in_steps() -> None:
    """ω² = 3 g/L (sin φ₀ − sin φ) without the time, and the time by the elliptic integral."""
    states = "states: {up: {rod.angle: -20 deg, at rest: all}, low: {rod.angle: -90 deg}}"
    speed = asked(f"{ROD}{states}\nfind: {{w: rod.angular_velocity at low}}", instants=80)["w"]
    square = 3 * G / 1.2 * (1 - math.sin(math.radians(20)))
    assert speed == pytest.approx(-math.sqrt(square), rel=CLOSE)
    found = asked(f"{ROD}{states}\nfind: {{t: time from up to low, w: rod.angular_velocity at low}}")
    assert found["w"] == pytest.approx(-math.sqrt(square), rel=CLOSE)
    assert found["t"] == pytest.approx(agm_period(math.radians(70), math.sqrt(1.5 * G / 1.2)) / 4, rel=CLOSE)


def agm_period(largest: float, omega: float) -> float:
    """T = 2π/(ω agm(1, cos ½θ)): the period of a pendulum of any size."""
    a, b = 1.0, math.cos(largest / 2)
    for _ in range(30):
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi / (omega * a)


def test_swings_small_and_large() -> None:
    text = f"""{ROD}
states: {{up: {{rod.angle: 10 deg, at rest: all}}}}
find: {{T: period of small swings, T1: period of swings from up, f: frequency of small swings}}
"""
    found, omega = asked(text), math.sqrt(1.5 * G / 1.2)
    assert found["T"] == pytest.approx(2 * math.pi / omega, rel=1e-6)
    assert found["f"] == pytest.approx(omega / (2 * math.pi), rel=1e-6)
    assert found["T1"] == pytest.approx(agm_period(math.radians(100), omega), rel=1e-6)


def test_a_force_that_varies_with_the_way_and_a_drag() -> None:
    """v = √(k/m) d for a force k (d − x) over d; v = u exp(−c t/m) against a drag c v."""
    text = """
given: {m: 2 kg, k: 50 N/m, d: 0.3 m, c: 3 N s/m, u: 4 m/s}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}, sled: {mass: m, moves: right}}
connections: {base: {contact: [block, floor]}, road: {contact: [sled, floor]}}
actions:
  pull: {force: k*(d - block.displacement), on: block, direction: right}
  drag: {force: -c*sled.velocity, on: sled, direction: right}
states: {start: {block.velocity: 0, sled.velocity: u}, end: {time: 0.3 s}}
find: {x: block.displacement from start to end, v: sled.velocity at end, W: drag.work from start to end}
"""
    found = asked(text)
    assert found["x"] == pytest.approx(0.3 * (1 - math.cos(math.sqrt(25) * 0.3)), rel=1e-7)
    assert found["v"] == pytest.approx(4 * math.exp(-0.45), rel=1e-7)
    assert found["W"] == pytest.approx(16 * (math.exp(-0.9) - 1), rel=1e-7)


def test_a_blow_and_what_the_hinge_takes_of_it() -> None:
    """ω = 3 m u/((M + 3 m) L) for a bullet into the end of a hanging rod; the pin gives − ½ M m u/(M + 3 m)."""
    text = """
given: {M: 2 kg, L: 80 cm, m: 50 g, u: 100 m/s}
bodies: {rod: {shape: rod, mass: M, length: L}, bullet: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, rod.angular_velocity: 0, bullet.velocity: u}, after: {}}
events: {hit: {joins: [bullet, rod.end], from: before, to: after}}
find: {w: rod.angular_velocity at after, J: pin.impulse.x during hit, Q: lost kinetic_energy during hit}
"""
    found, w = asked(text), 3 * 0.05 * 100 / (2.15 * 0.8)
    assert found["w"] == pytest.approx(w, rel=CLOSE)
    assert found["J"] == pytest.approx(2 * 0.4 * w + 0.05 * 0.8 * w - 5, rel=CLOSE)
    assert found["Q"] == pytest.approx(250 - 0.5 * (2 / 3 + 0.05) * 0.64 * w**2, rel=CLOSE)


LEAN = """
given: {m: 3 kg, F: unknown, mu: 0.4, s: 400 cm}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {base: {contact: [crate, floor], friction: mu}}
actions: {push: {force: F, on: crate, direction: right}}
"""


def test_a_verge_is_tried_on_both_sides() -> None:
    text, verge = f"{LEAN}\nfind: {{F: largest F where base sticks}}", 0.4 * 3 * G
    assert asked(text, verge, F=verge) == {"F": verge}
    for wrong in (0.9 * verge, 1.1 * verge):
        with pytest.raises(Broken, match="base"):
            asked(text, wrong, F=wrong)


def test_a_letter_that_is_asked_for_makes_all_lines_hold() -> None:
    """The push that gives 2 m/s after 4 m against friction: F = m (v²/2s + μ g)."""
    text = f"""{LEAN}
states: {{start: at rest, end: {{crate.displacement: s, crate.velocity: 2 m/s}}}}
find: {{F: F}}
"""
    right = 3 * (0.5 + 0.4 * G)
    assert asked(text, right, F=right) == {"F": right}
    with pytest.raises(NotConfirmed):
        asked(text, 1.01 * right, F=1.01 * right)


def test_a_motion_that_costs_too_much_is_not_followed() -> None:
    text = f"""{ROD}
states: {{up: {{rod.angle: 80 deg, at rest: all}}, late: {{time: 60 s}}}}
find: {{w: rod.angular_velocity at late}}
"""
    with pytest.raises(NotConfirmed, match="too long"):
        asked(text, instants=300)


WHEEL_ON_A_SPRING = """
given: {R: 1.7 m, M: 3.8 kg, mu: 0.56, k: 68 N/m, x: 1.2 m, v: 3.5 m/s, w: 5.6 rad/s, t: 0.76 s, g: 9.8 m/s^2}
surfaces: {floor: level}
bodies: {wheel: {shape: disc, mass: M, radius: R, moves: left}}
connections: {base: {contact: [wheel, floor], friction: mu}, coil: {spring: [ground, wheel], stiffness: k}}
states: {start: {coil.elongation: x, wheel.velocity: v, wheel.angular_velocity: w}, end: {time: t}}
find: {T: time from start to end, e: coil.elongation at end}
"""


@pytest.mark.parametrize("time", [0.1, 0.3, 0.5, 0.76, 1.1])
def test_what_rolls_slips_again_where_friction_does_not_do(time: float) -> None:
    """A wheel on a spring slips, rolls, and slips again; it is followed up to the very time that is told."""
    M, R, k, limit = 3.8, 1.7, 68.0, 0.56 * 3.8 * 9.8
    steps = 40000
    x, u, spin, step = 1.2, -3.5, 5.6, time / steps  # to the right; counterclockwise
    for _ in range(steps):
        slip = u + R * spin
        held = k * x / 3  # what keeps a disc rolling
        f = -limit if slip > 1e-3 else limit if slip < -1e-3 else max(-limit, min(limit, held))
        u += (f - k * x) / M * step
        spin += f * R / (0.5 * M * R * R) * step
        x += u * step
    found = asked(WHEEL_ON_A_SPRING.replace("t: 0.76 s", f"t: {time} s"))
    assert found["T"] == pytest.approx(time, rel=1e-12)
    assert found["e"] == pytest.approx(x, abs=2e-3)


@pytest.mark.parametrize("way", ["left", "right"])
@pytest.mark.parametrize("angle", [0, 28])
def test_the_way_of_a_loaded_wheel_that_rolls_is_that_of_its_centre(angle: int, way: str) -> None:
    """It has turned by φ = d/R; ½ I ω² about where it touches is what weight and force have done. The lump is on the right at first."""
    sign, beta, phi = 1 if way == "left" else -1, math.radians(angle), 1.1 / 1.6  # +1: it turns counterclockwise
    down = (-sign * math.cos(beta), -math.sin(beta))
    text = f"""
surfaces: {{ramp: {{slope: {angle} deg, down: {way}}}}}
bodies:
  one: {{radius: 1.6 m, moves: down, parts: {{hoop: {{shape: disc, mass: 1.3 kg, radius: 1.6 m}}, lump: {{mass: 1.4 kg, at: [0.8 m, 0]}}}}}}
connections: {{base: {{rolls: [one, ramp]}}}}
actions: {{pull: {{force: 9 N + (4 N/m)*one.displacement, on: one.center, direction: [{down[0]}, {down[1]}]}}}}
states: {{start: {{at rest: all}}, end: {{one.displacement: 1.1 m}}}}
find: {{w: one.angular_velocity at end}}
"""
    if angle == 0:
        text = text.replace("{slope: 0 deg, down: " + way + "}", "level").replace("moves: down", f"moves: {way}")
    lump = (0.8 * math.cos(phi), sign * 0.8 * math.sin(phi))  # from the centre
    speed = (1.6 * down[0] - sign * lump[1], 1.6 * down[1] + sign * lump[0])  # of the lump, per ω
    inertia = 1.3 * 1.6**2 * 1.5 + 1.4 * (speed[0] ** 2 + speed[1] ** 2)
    gained = 2.7 * G * 1.1 * math.sin(beta) - 1.4 * G * lump[1] + 9 * 1.1 + 2 * 1.1**2
    assert abs(asked(text)["w"]) == pytest.approx(math.sqrt(2 * gained / inertia), rel=1e-6)


@pytest.mark.parametrize(("turn", "way"), [("right", 1), ("left", -1)])
@pytest.mark.parametrize("far", [170, 200, 270])
def test_a_place_round_a_bowl_is_counted_past_half_a_turn(turn: str, way: int, far: int) -> None:
    """A marble that rolls over the top: v² = u² - (10/7) g h, wherever its angle or its way along the bowl is told, in two steps or one."""
    low = -90 if way > 0 else 270  # what goes round to the left comes from there to 0
    angle = low + way * far
    lines = [f"touch.angle: {angle} deg", f"ball.displacement: {0.9 * math.radians(far):.15f} m"]
    for line in lines:
        for side in ("", f"side: {{touch.angle: {low + way * 60} deg}}, ") if line is lines[0] else ("",):
            found = asked(f"""
given: {{u: 9 m/s}}
surfaces: {{bowl: {{hollow: 1 m}}}}
bodies: {{ball: {{shape: sphere, mass: 1 kg, radius: 0.1 m, moves: {turn}}}}}
connections: {{touch: {{rolls: [ball, bowl]}}}}
states: {{low: {{touch.angle: {low} deg, ball.velocity: u}}, {side}past: {{{line}}}}}
find: {{v: ball.speed at past}}
""")
            high = 0.9 * (1 - math.cos(math.radians(far)))
            assert found["v"] == pytest.approx(math.sqrt(81 - 10 / 7 * G * high), rel=CLOSE)


@pytest.mark.parametrize("times", [3, 30, 300, 3000])
def test_a_bead_that_is_flung_out_far(times: int) -> None:
    """(I + m r²) ω stays, however much longer than the first guess it takes, in which no step has numbers."""
    found = asked(f"""
plane: horizontal
given: {{b: 0.1 m, w: 0.07 rad/s}}
bodies: {{bar: {{inertia: 0.06 kg m^2}}, bead: {{mass: 0.2 kg}}}}
connections: {{axle: {{axle: bar}}, track: {{rides: [bead, bar], friction: none}}}}
states: {{start: {{bead.radius: b, bead.velocity.radial: 0, bar.angular_velocity: w}}, end: {{bead.radius: {times}*b}}}}
find: {{w2: bar.angular_velocity at end}}
""")
    assert found["w2"] == pytest.approx(0.07 * 0.062 / (0.06 + 0.002 * times**2), rel=1e-6)


ACROSS = {  # what is asked across a blow that joins what has come from elsewhere, and what it is
    "lost energy from start to rest": 0.5 * 2 * 36.0,
    "lost potential_energy from start to rest": 0.0,
    "b.displacement from start to rest": (2 * math.sqrt(36 - 2 * 1.96 * 2) / 5) ** 2 / (2 * 0.26 * 9.8),
    "a.displacement from start to rest": 2 + (2 * math.sqrt(36 - 2 * 1.96 * 2) / 5) ** 2 / (2 * 0.26 * 9.8),
}


@pytest.mark.parametrize("asked_for", ACROSS)
def test_what_has_come_to_be_joined_was_there(asked_for: str) -> None:
    """The assembly puts a body that joins another where they meet; its way there, and its energy, are not those of that step."""
    found = solve(f"""title: Across an event
bodies: {{a: {{mass: 2 kg, moves: right}}, b: {{mass: 3 kg, moves: right}}}}
surfaces: {{floor: level}}
connections: {{fa: {{contact: [a, floor], friction: 0.2}}, fb: {{contact: [b, floor], friction: 0.3}}}}
states: {{start: {{a.velocity: 6 m/s, b.velocity: 0}}, meet: {{a.displacement: 2 m}}, one: {{}}, rest: {{a.velocity: 0}}}}
events: {{hit: {{joins: [a, b], from: meet, to: one}}}}
find: {{x: {asked_for}}}
""")
    assert found.answers["x"].float == pytest.approx(ACROSS[asked_for])
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_height_that_a_body_has_come_from_is_lost_with_it(side: str) -> None:
    """A block slides down a slope into another, which holds it: all its energy m g d sin β is lost."""
    found = solve(f"""title: Down a slope into another
bodies: {{a: {{mass: 2 kg, moves: down}}, b: {{mass: 3 kg, moves: down}}}}
surfaces: {{ramp: {{slope: 20 deg, down: {side}}}}}
connections: {{fa: {{contact: [a, ramp], friction: none}}, fb: {{contact: [b, ramp], friction: 0.9}}}}
states: {{start: {{at rest: all}}, meet: {{a.displacement: 2 m}}, one: {{}}, rest: {{a.velocity: 0}}}}
events: {{hit: {{joins: [a, b], from: meet, to: one}}}}
find: {{s: b.displacement from one to rest, E: lost energy from start to rest, x: a.displacement.x from start to meet}}
""")
    s, slope = found.answers["s"].float, math.radians(20)
    assert found.answers["E"].float == pytest.approx(9.8 * math.sin(slope) * (2 * 2 + 5 * s))
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("turns", ["counterclockwise", "clockwise"])
@pytest.mark.parametrize(("tau", "end"), [(6.0, 0.0), (2.0, 1.5)])
def test_what_does_not_change_at_all_is_largest_from_the_first(tau: float, end: float, turns: str) -> None:
    """A wheel that friction holds does not come nearer to any speed: its largest one is none, and nothing tells when that is."""
    text = f"""
given: {{I: 2 kg m^2, Q: 5 N m, c: 2 N m s, tau: {tau} N m}}
bodies: {{wheel: {{inertia: I, turns: {turns}}}}}
connections: {{axle: {{axle: wheel, friction_torque: tau}}}}
actions: {{motor: {{couple: Q - c*wheel.angular_velocity, on: wheel}}}}
states: {{start: at rest, mid: {{time: 0.5 s}}, end: {{wheel.angular_velocity: largest}}}}
find: {{w: wheel.angular_velocity at end}}
"""
    assert asked(text)["w"] == pytest.approx(end, rel=CLOSE, abs=1e-9)
    if not end:
        with pytest.raises(NotConfirmed, match="nothing tells when"):
            asked(text.replace("w: wheel.angular_velocity at end", "t: time from mid to end"))


@pytest.mark.parametrize("small", [1e-2, 1e-3, 2e-4])
def test_a_small_speed_that_is_only_approached_is_told_closely(small: float) -> None:
    """(Q − τ)/c, whatever the size of Q − τ."""
    text = f"""
given: {{I: 2 kg m^2, Q: {1 + small} N m, c: 2 N m s, tau: 1 N m}}
bodies: {{wheel: {{inertia: I}}}}
connections: {{axle: {{axle: wheel, friction_torque: tau}}}}
actions: {{motor: {{couple: Q - c*wheel.angular_velocity, on: wheel}}}}
states: {{start: at rest, end: {{wheel.angular_velocity: largest}}}}
find: {{w: wheel.angular_velocity at end}}
"""
    assert asked(text)["w"] == pytest.approx(small / 2, rel=1e-6)


@pytest.mark.parametrize("tau", [1.0, 3.0, 3.999])
def test_however_slow_it_is_followed_to_its_rest(tau: float) -> None:
    """(Q − c t − τ)/I from rest: largest at (Q − τ)/c, at rest at twice that, wherever that is next to nothing."""
    text = f"""
given: {{I: 2 kg m^2, Q: 4 N m, c: 5 N m/s, tau: {tau} N m}}
bodies: {{wheel: {{inertia: I}}}}
connections: {{axle: {{axle: wheel, friction_torque: tau}}}}
actions: {{motor: {{couple: Q - c*time, on: wheel}}}}
states: {{start: at rest, top: {{wheel.angular_velocity: largest}}, end: {{wheel.angular_velocity: 0}}}}
find: {{w: wheel.angular_velocity at top, t: time from start to end, n: wheel.rotation from start to end}}
"""
    found, left = asked(text), 4 - tau
    assert found["w"] == pytest.approx(left**2 / 20, rel=1e-6)
    assert found["t"] == pytest.approx(2 * left / 5, rel=1e-6)
    assert found["n"] == pytest.approx(2 * left**3 / 150, rel=1e-6)


@pytest.mark.parametrize("rest", ["bar.angular_velocity: 0", "at rest: all"])
def test_a_place_where_it_stops_is_reached_though_rounding_passes_it_by(rest: str) -> None:
    """An angle that is sought, at which the bar is at rest: it only comes to it, while its rate passes through nothing."""
    scene = f"""
title: Bullet that a hanging bar catches
given: {{M: 4.5 kg, L: 0.75 m, m: 0.02 kg, u: 270 m/s, g: 9.8 m/s^2, theta: unknown}}
bodies: {{bar: {{shape: rod, mass: M, length: L}}, bullet: {{mass: m, moves: right}}}}
connections: {{pin: {{hinge: bar.start}}}}
states:
  before: {{bar.angle: -90 deg, at rest: bar, bullet.velocity: u}}
  after: {{}}
  turned: {{bar.angle: theta - 90 deg, {rest}}}
events: {{hit: {{joins: [bullet, bar.end], from: before, to: after}}}}
find: {{theta: theta}}
"""
    solution = solve(scene)
    share = 3 * 0.02**2 * 270**2 / (9.8 * 0.75 * (4.5 + 2 * 0.02) * (4.5 + 3 * 0.02))
    assert solution.answers["theta"].float == pytest.approx(math.acos(1 - share))
    assert [item.holds for item in solution.derivation.confirmed] == [True]
