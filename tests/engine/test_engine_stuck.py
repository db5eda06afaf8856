"""What sticks to a rim wherever that is turned, and what sticks through a blow though it slips from then on: against sums written here."""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

G = 9.8
SIDES = {"top": 90, "bottom": -90, "small": 0}


def answers(scene: str) -> dict[str, float]:
    solution = solve(scene)
    assert not solution.refused
    assert all(item.holds for item in solution.derivation.confirmed)
    return {name: answer.float for name, answer in solution.answers.items()}


SPOOL = """title: Clay on a rim of a spool that hangs by another
given: {{M: 2.3 kg, r: 1.2 m, m: 0.85 kg, w: 3.6 rad/s, v: 3.7 m/s}}
bodies:
  spool: {{{spool}}}
  clay: {{mass: m, moves: {way}}}
connections: {{pin: {{hinge: spool.{held}}}}}
states: {{start: {{spool.angle: {angle} deg, spool.angular_velocity: -w, clay.velocity: v}}, after: {{}}, end: {{spool.angle: {end} deg}}}}
events: {{hit: {{joins: [clay, spool.{point}], from: start, to: after}}}}
find: {{w_1: spool.angular_velocity at after, K: spool.kinetic_energy at after, dU: change of potential_energy from after to end}}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize("point", ["small", "top", "bottom"])
@pytest.mark.parametrize("angle", [-90, -60, 200])
@pytest.mark.parametrize("way", ["right", "down"])
def test_a_rim_is_met_where_it_is_in_space_and_goes_round_from_there(point: str, angle: int, way: str) -> None:
    M, r, m, w, v, turn = 2.3, 1.2, 0.85, -3.6, 3.7, math.radians(-20)
    lean, side = math.radians(angle), math.radians(SIDES[point])
    wheel = "mass: M, inertia: M*r^2, radii: {big: 2*r, small: r}", "big", r, 5 * M * r**2
    spool, held, reach, inertia = (
        wheel if point == "small" else ("shape: disc, mass: M, radius: 2*r", "rim", 2 * r, 6 * M * r**2)
    )
    x, y = 2 * r * math.cos(lean) + reach * math.cos(side), 2 * r * math.sin(lean) + reach * math.sin(side)
    ahead, up = (v, 0.0) if way == "right" else (0.0, -v)
    both = inertia + m * (x * x + y * y)
    after = (inertia * w + m * (x * up - y * ahead)) / both
    rise = M * 2 * r * (math.sin(lean + turn) - math.sin(lean)) + m * (x * math.sin(turn) + y * math.cos(turn) - y)
    scene = SPOOL.format(spool=spool, held=held, point=point, angle=angle, way=way, end=angle - 20)
    if after > 0 or both * after**2 / 2 < G * rise:  # it goes the other way, or turns back before
        pytest.skip("it does not get there by the shorter way")
    assert answers(scene) == pytest.approx({"w_1": after, "K": inertia * after**2 / 2, "dU": G * rise}, rel=1e-6)


PLATE = """title: Clay on a corner of a plate that hangs by its centre
given: {{b: 0.63 m, M: 5.5 kg, m: 3.6 kg}}
bodies: {{plate: {{shape: rectangle, mass: M, sides: [b, b/2]}}, clay: {{mass: m, moves: left}}}}
connections: {{pin: {{hinge: plate.center}}}}
states: {{start: {{plate.angle: {angle} deg, at rest: plate, clay.velocity: 1.7 m/s}}, after: {{}}, end: {{plate.angle: {end} deg}}}}
events: {{hit: {{joins: [clay, plate.corner2], from: start, to: after}}}}
find: {{K: plate.kinetic_energy at end}}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("angle", "end"), [(60, -20), (0, -40), (20, 15)])
def test_an_angle_is_counted_on_after_something_sticks(angle: int, end: int) -> None:
    b, M, m, u = 0.63, 5.5, 3.6, 1.7
    reach, lean = math.hypot(b / 2, b / 4), math.atan2(-b / 4, b / 2)
    first, last = lean + math.radians(angle), lean + math.radians(end)
    own = M * (b**2 + b**2 / 4) / 12
    both = own + m * reach**2
    w = m * u * reach * math.sin(first) / both
    energy = both * w**2 / 2 + m * G * reach * (math.sin(first) - math.sin(last))
    assert answers(PLATE.format(angle=angle, end=end)) == pytest.approx({"K": energy * own / both}, rel=1e-6)


KNOCKED = """title: Crate on a steep slope that is knocked into it
given: {{m: 4 kg, beta: 63 deg, mu: 0.73, J: 3.8 N s, d: 1.8 m}}
surfaces: {{ramp: {{slope: beta, down: {down}}}}}
bodies: {{crate: {{mass: m, moves: {moves}}}}}
connections: {{base: {{contact: [crate, ramp], friction: mu}}}}
states: {{start: at rest, after: {{}}, end: {{crate.displacement: {sign}d}}}}
events: {{hit: {{impulse: J, on: crate, direction: {aim}, from: start, to: after}}}}
find: {{v: crate.velocity at end, v_0: crate.velocity at after}}
"""


@pytest.mark.parametrize(("down", "into", "along"), [("left", "right", "left"), ("right", "left", "right")])
@pytest.mark.parametrize("moves", ["up", "down"])
def test_what_a_blow_presses_fast_sticks_through_it(down: str, into: str, along: str, moves: str) -> None:
    """J cos β up the slope is less than μ J sin β: it stands right after the blow, and slides down from rest."""
    beta, mu, d, sign = math.radians(63), 0.73, 1.8, -1 if moves == "up" else 1
    scene = KNOCKED.format(down=down, aim=into, moves=moves, sign="-" if sign < 0 else "")
    speed = math.sqrt(2 * G * (math.sin(beta) - mu * math.cos(beta)) * d)
    assert answers(scene) == pytest.approx({"v": sign * speed, "v_0": 0.0}, rel=1e-9)


@pytest.mark.parametrize("held", ["{axle: wheel, friction_torque: 3 N m}", "{axle: wheel}"])
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_what_rubs_holds_what_rests_before_a_blow(held: str, turns: str) -> None:
    brake = "" if "friction" in held else "actions: {brake: {press: 20 N, on: wheel.rim, friction: 0.4}}"
    scene = f"""title: Wheel at rest that is struck
bodies: {{wheel: {{shape: disc, mass: 5 kg, radius: 1 m, turns: {turns}}}, gear: {{shape: disc, mass: 2 kg, radius: 0.5 m}}}}
connections: {{axle: {held}, stub: {{axle: gear}}, mesh: {{gear: [wheel, gear]}}}}
{brake}
states: {{start: at rest, after: {{}}}}
events: {{hit: {{impulse: 6 N s, on: wheel.rim, direction: down, from: start, to: after}}}}
find: {{a: wheel.angular_acceleration at start, w: wheel.angular_velocity at after}}
"""
    sense = 1 if turns == "clockwise" else -1
    assert answers(scene) == pytest.approx({"a": 0.0, "w": sense * 6 / (2.5 + 0.25 * 4)}, rel=1e-9)


@pytest.mark.parametrize("held", ["spring: [ceiling, crate], stiffness: 90 N/m", "string: [ceiling, crate]"])
def test_what_hangs_beside_does_not_say_what_keeps_it_upright(held: str) -> None:
    """A weight welded to the corner would turn it: the answer is that of a guide, and it is said that nothing tells of one."""
    scene = f"""title: Crate that hangs, with a weight at its side
bodies: {{crate: {{mass: 2 kg, moves: down}}, wheel: {{shape: disc, mass: 1 kg, radius: 30 cm}}}}
connections: {{tie: {{{held}}}, bolt: {{weld: [crate, wheel.rim]}}}}
states: {{start: {{at rest: all{", tie.elongation: 10 cm" if "spring" in held else ""}}}}}
find: {{a: crate.acceleration at start}}
"""
    told = solve(scene).derivation.confirmed
    assert [(item.holds, item.why) for item in told] == [
        (None, "what keeps `crate` from turning the scene does not tell")
    ]


def test_what_a_guide_pushes_is_no_momentum_that_is_kept() -> None:
    scene = """title: Rod on a block that a spring holds
given: {v: 1 m/s}
bodies: {block: {mass: 3 kg, moves: up}, rod: {shape: rod, mass: 2 kg, length: 1 m}}
connections: {coil: {spring: [ceiling, block], stiffness: 90 N/m}, joint: {hinge: [block, rod.start]}}
states: {start: {rod.angle: -40 deg, coil.elongation: 10 cm, block.velocity: v, rod.angular_velocity: 4 rad/s}, end: {block.velocity: 0}}
find: {u: rod.cm.velocity.x at end}
"""
    with pytest.raises(Unsolvable, match="not solved by these laws"):
        solve(scene)


@pytest.mark.parametrize("spindle", ["axle: [roller, wheel]", "hinge: [roller.center, wheel.center]"])
@pytest.mark.parametrize(("base", "spin"), [("rolls: [roller, floor]", 1.5), ("contact: [roller, floor]", 1.0)])
@pytest.mark.parametrize("moves", ["left", "right"])
def test_a_wheel_on_the_axle_of_what_rolls_goes_along_steadily(
    spindle: str, base: str, spin: float, moves: str
) -> None:
    scene = f"""title: Wheel on the axle of a roller
surfaces: {{floor: level}}
bodies: {{roller: {{shape: disc, mass: 4 kg, radius: 0.5 m, moves: {moves}}}, wheel: {{shape: ring, mass: 2 kg, radius: 0.3 m}}}}
connections: {{base: {{{base}}}, spindle: {{{spindle}}}}}
actions: {{push: {{force: 16 N, on: roller, direction: {moves}}}, twist: {{couple: 0.9 N m, on: wheel}}}}
states: {{start: {{at rest: all}}, end: {{time: 3 s}}}}
find: {{v: roller.velocity at end, w: wheel.angular_velocity at end, K: wheel.kinetic_energy at end}}
"""
    a, spun = 16 / (4 * spin + 2), 0.9 / (2 * 0.09) * 3
    truth = {"v": 3 * a, "w": spun, "K": (3 * a) ** 2 + 0.09 * spun**2}
    assert answers(scene) == pytest.approx(truth, rel=1e-9)


@pytest.mark.parametrize("points", ["disc.top, rod.start", "rod.center, disc.bottom", "disc.rim, rod.end"])
def test_weights_turn_nothing_about_the_centre_of_mass_of_all(points: str) -> None:
    """However it stands, which nothing tells."""
    scene = f"""title: Rod welded to a disc, thrown up with a couple on it
given: {{R: 1 m, M: 3.4 kg, L: 0.71 m, m: 4.5 kg, Q: 4.6 N m}}
bodies: {{disc: {{shape: disc, mass: M, radius: R}}, rod: {{shape: rod, mass: m, length: L}}}}
connections: {{bolt: {{weld: [{points}]}}}}
actions: {{twist: {{couple: Q, on: disc}}}}
states: {{start: {{at rest: all}}}}
find: {{a: disc.angular_acceleration at start}}
"""
    R, M, L, m = 1.0, 3.4, 0.71, 4.5
    spots = {"top": (0, R), "bottom": (0, -R), "rim": (R, 0), "start": (-L / 2, 0), "end": (L / 2, 0), "center": (0, 0)}
    (x, y), (u, v) = (spots[point.split(".")[1]] for point in points.split(", "))
    apart = M * m / (M + m) * ((x - u) ** 2 + (y - v) ** 2)
    assert answers(scene) == pytest.approx({"a": 4.6 / (M * R**2 / 2 + m * L**2 / 12 + apart)}, rel=1e-9)


@pytest.mark.parametrize(("side", "spin"), [("left", "5.6"), ("right", "-5.6")])
def test_what_stops_slipping_unseen_is_named_where_an_answer_is_withheld(side: str, spin: str) -> None:
    """A disc that a spring pulls back as it slips, until it rolls: for that the laws have no closed form."""
    scene = f"""title: Disc that slips on a floor beside a spring
given: {{R: 1.7 m, M: 3.8 kg, k: 68 N/m}}
surfaces: {{floor: level}}
bodies: {{disc: {{shape: disc, mass: M, radius: R, moves: {side}}}}}
connections: {{base: {{contact: [disc, floor], friction: 0.56}}, coil: {{spring: [ground, disc], stiffness: k}}}}
states: {{start: {{coil.elongation: 1.2 m, disc.velocity: 3.5 m/s, disc.angular_velocity: {spin} rad/s}}, end: {{time: 0.76 s}}}}
find: {{x: coil.elongation at end}}
"""
    with pytest.raises(Unsolvable, match=r"`base` .*slip.* on the way from `start` to `end`"):
        solve(scene)


@pytest.mark.parametrize("point", ["rim", "top"])
def test_what_flies_towards_a_body_is_where_they_meet(point: str) -> None:
    scene = f"""title: Clay that sticks to a ring on a shaft
bodies: {{ring: {{shape: ring, mass: 1.5 kg, radius: 86 cm}}, clay: {{mass: 4.6 kg, moves: right}}}}
connections: {{pin: {{hinge: ring.center}}}}
states: {{start: {{ring.angle: -40 deg, at rest: ring, clay.velocity: 4 m/s}}, after: {{}}}}
events: {{hit: {{joins: [clay, ring.{point}], from: start, to: after}}}}
find: {{U: change of potential_energy from start to after}}
"""
    assert answers(scene) == {"U": 0.0}


@pytest.mark.parametrize("point", ["rim", "top", "center"])
def test_a_weld_on_a_rim_goes_round_with_it(point: str) -> None:
    """The torque of a weld is about the mark to which it is made, wherever that has gone."""
    r, M, m, Q, a, d = 0.37, 2.9, 4.2, 7.4, 4.7, math.radians(70)
    side, reach = math.radians(90 if point == "top" else 0), 0.0 if point == "center" else r
    scene = f"""title: Disc welded to a rim
bodies: {{wheel: {{shape: disc, mass: 2.9 kg, radius: 37 cm}}, disc: {{shape: disc, mass: 4.2 kg, radius: 48 cm}}}}
connections: {{axle: {{axle: wheel}}, bolt: {{weld: [wheel.{point}, disc.center]}}}}
actions: {{twist: {{couple: 7.4 N m, on: wheel}}}}
states: {{start: {{wheel.angular_velocity: 4.7 rad/s}}, end: {{wheel.rotation: 70 deg}}}}
find: {{tau: bolt.torque at end, F_x: bolt.force.x at end}}
"""
    both = M * r**2 / 2 + m * 0.48**2 / 2 + m * reach**2
    alpha = (Q - m * G * reach * math.cos(side + d)) / both
    w2 = a**2 + 2 * (Q * d - m * G * reach * (math.sin(side + d) - math.sin(side))) / both
    ahead = -reach * (alpha * math.sin(side + d) + w2 * math.cos(side + d))
    assert answers(scene) == pytest.approx({"tau": m * 0.48**2 / 2 * alpha, "F_x": m * ahead}, rel=1e-6, abs=1e-9)
    last_named = scene.replace(f"[wheel.{point}, disc.center]", f"[disc.center, wheel.{point}]")
    assert answers(last_named)["tau"] == pytest.approx(-m * 0.48**2 / 2 * alpha, rel=1e-6)


@pytest.mark.parametrize("moves", ["left", "right"])
@pytest.mark.parametrize("scale", [1, 4])
def test_a_work_found_numerically_is_that_of_the_way_in_which_it_rolls(moves: str, scale: int) -> None:
    """A loaded sphere rolls up to its turn: the other root, back beyond the start, is nearer to zero."""
    M, m, R, Q, v = 3.2 * scale, 5.9 * scale, 1.9, 12.0 * scale, 4.1
    scene = f"""title: Sphere with a rod at its bottom, rolling
surfaces: {{floor: level}}
bodies: {{ball: {{shape: sphere, mass: {M} kg, radius: {R} m, moves: {moves}}}, rod: {{shape: rod, mass: {m} kg, length: 0.59 m}}}}
connections: {{base: {{rolls: [ball, floor]}}, bolt: {{weld: [ball.bottom, rod.center]}}}}
actions: {{twist: {{couple: {Q} N m, on: ball}}}}
states: {{start: {{ball.velocity: {v} m/s}}, end: {{ball.velocity: 0}}}}
find: {{W: twist.work from start to end}}
"""
    first = (0.7 * M * R**2 + m * 0.59**2 / 24) * (v / R) ** 2
    low, high = 0.0, 1.5
    for _ in range(60):
        middle = (low + high) / 2
        moving = first + Q * middle > m * G * R * (1 - math.cos(middle))
        low, high = (middle, high) if moving else (low, middle)
    assert answers(scene) == pytest.approx({"W": Q * low}, rel=1e-6)


@pytest.mark.parametrize("time", [0.4, 1.2])
@pytest.mark.parametrize("spin", ["", "-"])
def test_the_force_of_a_weld_goes_round_with_what_spins(time: float, spin: str) -> None:
    scene = f"""title: Plate with a disc welded to it, spinning on ice
plane: horizontal
bodies: {{plate: {{shape: rectangle, mass: 2 kg, sides: [80 cm, 40 cm]}}, disc: {{shape: disc, mass: 3 kg, radius: 20 cm}}}}
connections: {{bolt: {{weld: [plate.corner3, disc.center]}}}}
states: {{start: {{plate.velocity: [1 m/s, 2 m/s], plate.angular_velocity: {spin}2.7 rad/s}}, end: {{time: {time} s}}}}
find: {{F_x: bolt.force.x at end, F_y: bolt.force.y at end}}
"""
    turn = (-1 if spin else 1) * 2.7 * time
    x, y = 0.4 * 2 / 5, 0.2 * 2 / 5  # of the disc from the centre of mass
    pull = -3 * 2.7**2
    truth = {
        "F_x": pull * (x * math.cos(turn) - y * math.sin(turn)),
        "F_y": pull * (x * math.sin(turn) + y * math.cos(turn)),
    }
    assert answers(scene) == pytest.approx(truth, rel=1e-6)


@pytest.mark.parametrize("twist", [1.7, -5.0])
def test_what_sticks_to_the_top_of_a_wheel_on_ice_goes_round_with_it(twist: float) -> None:
    R, M, m, u = 0.8, 2.0, 1.5, 3.9
    scene = f"""title: Clay that sticks to a wheel on ice
surfaces: {{ice: level}}
bodies: {{wheel: {{shape: disc, mass: {M} kg, radius: {R} m, moves: left}}, clay: {{mass: {m} kg, moves: right}}}}
connections: {{base: {{contact: [wheel, ice]}}}}
actions: {{twist: {{couple: {twist} N m, on: wheel}}}}
states: {{start: {{at rest: wheel, clay.velocity: {u} m/s}}, after: {{}}}}
events: {{hit: {{joins: [clay, wheel.top], from: start, to: after}}}}
find: {{a: clay.acceleration at after}}
"""
    own = M * R**2 / 2
    ahead = m * u / (M + m * (1 + M * R**2 / own))
    spin, alpha = -M * ahead * R / own, twist / (own + M * m / (M + m) * R**2)
    assert answers(scene)["a"] == pytest.approx(math.hypot(R * spin**2, alpha * R * M / (M + m)), rel=1e-6)
