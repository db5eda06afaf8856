"""Which of several roots is meant: the first moment, the next place on the way, the stable equilibrium; observed constants."""

from __future__ import annotations

import math

import mpmath
import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve


def value(scene: str, name: str) -> float:
    found = solve(scene).answers[name].float
    assert found is not None
    return found


ALTERNATING = """title: Drum under an alternating torque
given: {{I: 0.5 kg m^2, M0: 3 N m, w: 4 rad/s}}
bodies: {{drum: {{inertia: I}}}}
connections: {{axle: {{axle: drum}}}}
actions: {{motor: {{couple: M0*sin(w*time), on: drum}}}}
states: {{{states}}}
find: {{{find}}}
"""


@pytest.mark.parametrize(
    ("states", "find", "expected"),
    [
        ("start: at rest, fast: {drum.angular_velocity: largest}", "x: drum.angular_velocity at fast", 3),
        ("start: at rest, still: {drum.angular_velocity: 0}", "x: time from start to still", math.pi / 2),
        ("start: at rest, still: {drum.angular_velocity: 0}", "x: drum.rotation from start to still", 0.75 * math.pi),
        (
            "start: at rest, fast: {drum.angular_velocity: largest}, still: {drum.angular_velocity: 0}",
            "x: time from fast to still",
            math.pi / 4,
        ),
        (
            "start: at rest, still: {drum.angular_velocity: 0}, again: {drum.angular_velocity: 0}",
            "x: time from start to again",
            math.pi,
        ),
    ],
)
def test_of_times_that_come_again_the_first_after_the_state_before(states: str, find: str, expected: float) -> None:
    assert value(ALTERNATING.format(states=states, find=find), "x") == pytest.approx(expected, rel=1e-9)


def test_the_way_goes_on_from_a_state_that_was_only_found_on_the_way() -> None:
    scene = """title: Constant torque against one that grows with the angle
given: {I: 0.02 kg m^2, M: 1.2 N m, k: 0.8 N m/rad}
bodies: {disc: {inertia: I}}
connections: {axle: {axle: disc}}
actions: {motor: {couple: M - k*disc.angle, on: disc}}
states: {start: {disc.angle: 0, at rest: all}, fast: {disc.angular_velocity: largest}, far: {disc.angle: largest}}
find: {w: disc.angular_velocity at fast, theta: disc.angle at far, t: time from start to far}
"""
    assert value(scene, "w") == pytest.approx(1.2 / math.sqrt(0.016), rel=1e-9)
    assert value(scene, "theta") == pytest.approx(3, rel=1e-9)
    assert value(scene, "t") == pytest.approx(math.pi * math.sqrt(0.02 / 0.8), rel=1e-9)


def test_a_body_left_in_balance_hangs_below_its_hinge() -> None:
    scene = """title: Plate hung from a corner
given: {M: 2 kg, a: 40 cm, b: 30 cm}
bodies: {plate: {shape: rectangle, mass: M, sides: [a, b]}}
connections: {nail: {hinge: plate.corner1}}
states: {hangs: {balance: true}}
find: {theta: plate.angle at hangs}
"""
    assert value(scene, "theta") == pytest.approx(-math.pi / 2, rel=1e-9)


def test_a_coefficient_of_drag_follows_from_an_observed_time() -> None:
    scene = """title: Wheel braked by a torque as the root of its speed
given: {I: 1.5 kg m^2, w0: 36 rad/s, c: unknown, T: 12 s}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel}}
actions: {brake: {couple: -c*sqrt(wheel.angular_velocity), on: wheel}}
states: {start: {wheel.angular_velocity: w0}, still: {time: T, wheel.angular_velocity: 0}}
find: {c: c, mean: mean wheel.angular_velocity from start to still}
"""
    assert value(scene, "c") == pytest.approx(2 * 1.5 * 6 / 12, rel=1e-9)  # T = 2 I √ω₀/c
    assert value(scene, "mean") == pytest.approx(12, rel=1e-9)


def test_turns_in_a_state_and_two_phases_by_kinematics_alone() -> None:
    scene = """title: Flywheel that makes forty turns to a stop
given: {w: 1.5 rad/s}
bodies: {wheel: {inertia: 3 kg m^2}}
connections: {axle: {axle: wheel, angular_acceleration: unknown}}
states: {start: {wheel.angular_velocity: w}, half: {wheel.turns: 20}, stop: {wheel.turns: 20, wheel.angular_velocity: 0}}
find: {t: time from start to stop, t1: time from start to half}
"""
    solution = solve(scene)
    assert value(scene, "t") == pytest.approx(160 * math.pi / 1.5, rel=1e-9)
    assert value(scene, "t1") == pytest.approx(80 * math.pi * (2 - math.sqrt(2)) / 1.5, rel=1e-9)
    assert "Newton" not in str(solution) and "energy" not in str(solution)


def test_a_condition_may_set_two_quantities_equal() -> None:
    scene = """title: Wheel from rest, when its rim's two accelerations are equal
given: {a: 0.5 rad/s^2, R: 40 cm, T: unknown}
bodies: {wheel: {radius: R}}
connections: {axle: {axle: wheel, angular_acceleration: a}}
states: {start: at rest, then: {time: T}}
find: {T: T where wheel.rim.acceleration.normal = wheel.rim.acceleration.tangential at then}
"""
    assert value(scene, "T") == pytest.approx(math.sqrt(2), rel=1e-9)
    with pytest.raises(SceneError, match="don't agree"):
        solve(scene.replace("acceleration.tangential at", "velocity at"))


def test_a_function_of_time_that_is_not_defined_at_the_start() -> None:
    scene = """title: Instantaneous centre of a disc that starts to turn
given: {v: 0.8 m/s, e: 3 rad/s^2}
bodies: {disc: {shape: disc, mass: 1 kg, radius: 0.2 m, velocity: [v, 0], angular_acceleration: e}}
states: {start: {disc.angular_velocity: 0}}
find: {y: disc.instantaneous_centre.y at any time}
"""
    found = solve(scene, at="2 s").answers["y"].float
    assert found == pytest.approx(0.8 / 6, rel=1e-9)


def test_what_is_made_of_a_numerical_root_has_its_digits() -> None:
    """A rod on a torsion wire sags from the level, where the wire is relaxed, to the balance that is nearest."""
    text = """
given: {L: 1 m, M: 2 kg, k: 3 N m/rad, theta: unknown}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}, wire: {torsion: rod, stiffness: k}}
states: {rest: {rod.angle: theta, balance: true}}
find: {theta: theta, tau: wire.torque at rest, h: L*sin(theta)}
"""
    answers = solve(text, digits=30).answers
    with mpmath.workdps(40):
        root = mpmath.findroot(lambda x: mpmath.mpf("9.8") * mpmath.cos(x) + 3 * x, -1.2)
        for name, value in {"theta": root, "tau": -3 * root, "h": mpmath.sin(root)}.items():
            assert answers[name].value == mpmath.nstr(value, 30, strip_zeros=False), name


def test_an_equation_that_every_value_fulfils_gives_no_root() -> None:
    """Energy with the time and the turn that the same law tells: true at any speed, though its logarithms do not show it."""
    with pytest.raises(Unsolvable, match="too little is known"):
        solve("""
title: A wheel with a motor of given power beside a couple, and nothing said of its end
given: {M: 3 N m, P: 1 W, I: 390 kg m^2, w: 1.5 rad/s}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel}}
actions: {pull: {couple: M, on: wheel}, motor: {power: P, on: wheel}}
states: {one: {wheel.angular_velocity: w}, two: {}}
find: {x: lost wheel.angular_velocity from one to two}
""")


WIRE = """title: Disc on a wire
given: {{I: 2 kg m^2, k: 3 N m/rad, w: {speed} rad/s, b: {begin} rad, r: {rest} rad}}
bodies: {{disc: {{inertia: I, turns: {turns}}}}}
connections: {{axle: {{axle: disc}}, wire: {{torsion: disc, stiffness: k, rest_angle: r}}}}
states: {{go: {{disc.angle: b, disc.angular_velocity: w}}, far: {{disc.angular_velocity: 0}}}}
find: {{phi: disc.angle at far, q: wire.torque at far, t: disc.rotation from go to far}}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize("turns", ["counterclockwise", "clockwise"])
@pytest.mark.parametrize(
    ("speed", "begin", "rest"), [(1, 0, 0), (9, 1, 0), (-30, 2, 5), (12, -20, 1), (0, 9, 0), (0, -15, 2)]
)
def test_a_wire_knows_turns(speed: float, begin: float, rest: float, turns: str) -> None:
    """It turns on to r ± √((b − r)² + I ω²/κ), however many turns that is; let go, to the other side."""
    scene = WIRE.format(speed=speed, begin=begin, rest=rest, turns=turns)
    sense = 1 if turns == "counterclockwise" else -1
    way = math.copysign(1, speed * sense) if speed else math.copysign(1, rest - begin)
    far = rest + way * math.sqrt((begin - rest) ** 2 + 2 * speed**2 / 3)
    assert value(scene, "phi") == pytest.approx(far)
    assert value(scene, "t") == pytest.approx((far - begin) * sense)


@pytest.mark.parametrize("load", [False, True])
def test_a_wire_in_letters_has_no_cases_of_turns(load: bool) -> None:
    """Shot from its rest angle, whatever the letters are; a load on a string goes along as far as that stays taut."""
    scene = WIRE.format(speed=1, begin=0, rest=0, turns="counterclockwise")
    for number, letter in (("2 kg m^2", "kg m^2"), ("3 N m/rad", "N m/rad"), ("1 rad/s", "rad/s")):
        scene = scene.replace(number, letter, 1)
    if load:
        scene = scene.replace("inertia: I", "inertia: I, radius: 10 cm").replace(
            "}}\nconnections: {", "}, load: {mass: 1 kg, moves: up}}\nconnections: {s: {string: [disc, load]}, "
        )
    answers = solve(scene, confirm=False).answers
    assert not answers["phi"].otherwise
    assert len(answers["phi"].conditions) == load


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize(("friction", "couple"), [(0.5, 0.0), (0.0, -0.5), (0.0, 0.5), (0.0, 5.0), (0.3, 0.6)])
def test_where_friction_or_a_couple_tells_turns_apart_the_first_place_is_meant(
    friction: float, couple: float, mirrored: bool
) -> None:
    """A rod let go from level comes to rest at the first place at which its kinetic energy is gone: no place a turn later is like it."""
    start, way = (math.pi, 1) if mirrored else (0.0, -1)
    found = solve(f"""
title: A rod let go from level
bodies: {{rod: {{shape: rod, mass: 2 kg, length: 1 m}}}}
connections: {{pin: {{hinge: rod.start, friction_torque: {friction} N m}}}}
actions: {{turn: {{couple: {-couple * way} N m, on: rod}}}}
states: {{start: {{rod.angle: {180 if mirrored else 0} deg, at rest: all}}, far: {{rod.angular_velocity: 0}}}}
find: {{phi: rod.angle at far}}
""")
    gone = 1e-4
    while 9.8 * math.sin(gone) > (friction + couple) * gone:
        gone += 1e-4
    assert found.answers["phi"].float == pytest.approx(start + way * gone, abs=2e-4)
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("moves", ["down", "up"])
@pytest.mark.parametrize("stretched", [0.1, 0.3])
@pytest.mark.parametrize("asked", ["coil.elongation at top", "load.displacement from start to top"])
def test_what_a_string_brings_to_rest_has_left_its_start(moves: str, stretched: float, asked: str) -> None:
    """A load let go on a string over a pulley, held by a spring at its other end: it swings about m g/k = 0.196 m and rests beyond it."""
    found = value(
        f"""title: A load held by a spring over a pulley
bodies: {{load: {{mass: 2 kg, moves: {moves}}}, wheel: {{shape: disc, mass: 1 kg, radius: 0.1 m}}, hook: {{mass: 0, moves: up}}}}
connections: {{ax: {{axle: wheel}}, rope: {{string: [hook, wheel, load]}}, coil: {{spring: [ground, hook], stiffness: 100 N/m}}}}
states: {{start: {{coil.elongation: {stretched} m, at rest: all}}, top: {{load.velocity: 0}}}}
find: {{x: {asked}}}
""",
        "x",
    )
    far = 2 * 0.196 - stretched
    way = (far - stretched) * (1 if moves == "down" else -1)
    assert found == pytest.approx(far if asked.startswith("coil") else way)


@pytest.mark.parametrize(("force", "count"), [("5 N", 2), ("2 N", 1)])
def test_of_several_stable_balances_it_is_said_how_many(force: str, count: int) -> None:
    """F L sin p = c p: a column that buckles (F L > c) leans to either side, else it stands at p = 0 alone."""
    found = solve(f"""title: Level column on a spring hinge pushed along itself
gravity: none
given: {{L: 1 m, c: 3 N m/rad, F: {force}, p: unknown}}
bodies: {{rod: {{shape: rod, mass: 1 kg, length: L}}}}
connections: {{pin: {{hinge: rod.start}}, wire: {{torsion: rod, stiffness: c}}}}
actions: {{push: {{force: F, on: rod.end, direction: left}}}}
states: {{rest: {{rod.angle: p, balance: true}}}}
find: {{p: p}}
""")
    angle = found.answers["p"].float
    assert angle is not None
    assert float(force.split()[0]) * math.sin(angle) == pytest.approx(3 * angle, abs=1e-12)
    assert ("of 2 stable ones" in str(found).replace("\n", " ")) == (count == 2)


@pytest.mark.parametrize("time", [0.4, 1.4, 2.3, 3.3])
def test_what_goes_by_a_rate_has_its_sign_however_often_that_turned_round(time: float) -> None:
    """From rest a couple twists a ring against a wire: ω = Q Ω/k sin Ω t, with Ω² = k/(M R²) for the ring, whose centre stays."""
    scene = f"""
given: {{R: 0.6 m, M: 1 kg, k: 24 N m/rad, Q: 11 N m, t1: {time} s}}
surfaces: {{floor: level}}
bodies: {{ring: {{shape: ring, mass: M, radius: R}}, cart: {{mass: 2 kg, moves: left}}}}
connections: {{under: {{contact: [cart, floor]}}, mount: {{axle: [cart, ring]}}, wire: {{torsion: ring, stiffness: k}}}}
actions: {{twist: {{couple: Q, on: ring}}}}
states: {{start: {{at rest: all}}, end: {{time: t1}}}}
find: {{q: QUESTION at end}}
"""
    beat = math.sqrt(24 / 0.36)
    rate = 11 * beat / 24 * math.sin(beat * time)
    true = {
        "ring.angular_momentum about ring.bottom": 0.36 * rate,
        "twist.power": 11 * rate,
        "ring.top.velocity.x": -0.6 * rate,
    }
    for question, expected in true.items():
        assert value(scene.replace("QUESTION", question), "q") == pytest.approx(expected, rel=1e-6), question


@pytest.mark.parametrize("time", [0.2, 0.6, 1.3])
def test_what_goes_by_several_rates_has_the_sign_of_each(time: float) -> None:
    """A ball rolls to and fro on a spring: (7/5) M ẍ = −k x; about where it touches it has (7/5) M R v, clockwise as it goes right."""
    scene = f"""
given: {{R: 0.5 m, M: 5 kg, k: 70 N/m, x: 1 m, t1: {time} s}}
surfaces: {{floor: level}}
bodies: {{ball: {{shape: sphere, mass: M, radius: R, moves: right}}}}
connections: {{base: {{rolls: [ball, floor]}}, coil: {{spring: [ground, ball], stiffness: k}}}}
states: {{start: {{coil.elongation: x, at rest: all}}, end: {{time: t1}}}}
find: {{q: ball.angular_momentum about ball.bottom at end}}
"""
    beat = math.sqrt(70 / 7)
    assert value(scene, "q") == pytest.approx(-7 * 0.5 * beat * math.sin(beat * time), rel=1e-6)
