"""Blows in the assembly, held against momentum and angular momentum written by hand."""

from __future__ import annotations

import math

import pytest

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.blow import Struck, struck
from rotsolve.confirm.instant import placed
from rotsolve.confirm.model import Model
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_source


def through(text: str, *, solved: bool = True) -> tuple[Model, Struck]:
    """The rates after the only event of a scene; one that the laws do not solve is taken as it is read."""
    read = read_source("title: by hand\n" + text + "\nfind: {t: 1 s}\n")
    problem = configured(read).problem if solved else read
    event = problem.events[0]
    before = placed(Model(problem, {}, event.from_ or ""))
    assert before.clash == 0.0
    model = Model(problem, {}, event.to or "")
    found = struck(model, before, event)
    assert found.clash == 0.0
    return model, found


def spin(model: Model, found: Struck, name: str) -> float:
    assert model.seats[name].turn not in found.placed.open
    return found.placed.speed[model.seats[name].turn]


def test_a_hinged_rod_struck_at_its_end() -> None:
    """I ω = J L; the hinge gives ½ J back along the blow."""
    model, found = through(
        """
given: {M: 2 kg, L: 90 cm, J: 3 N s}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: all}, after: {}}
events: {hit: {impulse: J, on: rod.end, direction: right, from: before, to: after}}"""
    )
    assert spin(model, found, "rod") == pytest.approx(3 * 3 / (2 * 0.9))
    assert found.impulses["pin", "x"] == pytest.approx(1.5)


def test_two_jointed_links_at_an_angle() -> None:
    """Six equations of two free rods and the two components of the joint's impulse, solved by hand."""
    model, found = through(
        """
plane: horizontal
given: {m: 2 kg, a: 50 cm, J: 3 N s}
bodies: {one: {shape: rod, mass: m, length: a}, two: {shape: rod, mass: m, length: a}}
connections: {pin: {hinge: [one.end, two.start]}}
states: {still: {one.angle: 0, two.angle: 60 deg, at rest: all}, struck: {}}
events: {blow: {impulse: J, on: one.start, direction: up, from: still, to: struck}}"""
    )
    assert spin(model, found, "one") == pytest.approx(-11.2747253)
    assert spin(model, found, "two") == pytest.approx(1.58241758)


def test_a_flail_on_ice_hit_by_a_puck() -> None:
    model, found = through(
        """
plane: horizontal
given: {M: 3 kg, m: 1 kg, a: 80 cm, b: 40 cm, n: 500 g, u: 4 m/s}
bodies: {staff: {shape: rod, mass: M, length: a}, swipe: {shape: rod, mass: m, length: b}, puck: {mass: n, moves: up}}
connections: {thong: {hinge: [staff.end, swipe.start]}}
states: {still: {staff.angle: 0, swipe.angle: 0, puck.velocity: u, at rest: [staff, swipe]}, struck: {}}
events: {hit: {joins: [puck, swipe.end], from: still, to: struck}}"""
    )
    assert spin(model, found, "staff") == pytest.approx(-0.714285714)
    assert spin(model, found, "swipe") == pytest.approx(7.14285714)


def test_a_ball_on_a_rough_floor_struck_at_its_centre() -> None:
    """J − f = m v, f R = I ω: v = 5 J/(7 m)."""
    _, found = through(
        """
given: {m: 2 kg, R: 10 cm, J: 4 N s}
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: right}}
connections: {touch: {rolls: [ball, floor]}}
states: {still: {at rest: all}, hit: {}}
events: {blow: {impulse: J, on: ball.center, direction: right, from: still, to: hit}}"""
    )
    assert found.placed.speed[0] == pytest.approx(10 / 7)
    assert found.impulses["touch", "friction"] == pytest.approx(-8 / 7)


def test_two_bars_on_posts_of_their_own_lock() -> None:
    """Joined tip to tip they are a triangle."""
    model, found = through(
        """
plane: horizontal
given: {M: 3 kg, m: 1 kg, a: 60 cm, b: 30 cm, w: 5 rad/s}
bodies: {long: {shape: rod, mass: M, length: a}, short: {shape: rod, mass: m, length: b}}
connections: {post1: {hinge: long.start}, post2: {hinge: short.start}}
states:
  before: {long.angle: 60 deg, long.angular_velocity: -w, short.angle: 90 deg, short.angular_velocity: 0}
  after: {}
events: {clash: {joins: [long.end, short.end], from: before, to: after}}""",
        solved=False,
    )
    assert spin(model, found, "long") == pytest.approx(0.0, abs=1e-12)
    assert spin(model, found, "short") == pytest.approx(0.0, abs=1e-12)


def test_a_ball_bounces_off_a_hanging_rod() -> None:
    """Angular momentum about the hinge, and e times the speed of approach."""
    model, found = through(
        """
given: {M: 2 kg, L: 1 m, m: 200 g, u: 6 m/s, e: 0.8}
bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: rod, ball.velocity: u}, after: {}}
events: {hit: {collides: [ball, rod.end], restitution: e, from: before, to: after}}"""
    )
    w, v = spin(model, found, "rod"), found.placed.speed[model.seats["ball"].first]
    assert w - v == pytest.approx(0.8 * 6)
    assert 2 / 3 * w + 0.2 * v == pytest.approx(0.2 * 6)


def test_a_cord_that_hangs_slack_after_a_blow_lets_go() -> None:
    """Struck upwards a hanging block leaves its cord; struck downwards it is held."""
    scene = """
given: {{m: 2 kg, J: 3 N s}}
bodies: {{block: {{mass: m, moves: up}}}}
connections: {{cord: {{string: [ceiling, block]}}}}
states: {{before: {{at rest: all}}, after: {{}}}}
events: {{hit: {{impulse: J, on: block, direction: {way}, from: before, to: after}}}}"""
    _, found = through(scene.format(way="up"))
    assert found.placed.speed[1] == pytest.approx(1.5)
    assert found.impulses.get(("cord", "tension0"), 0.0) == 0.0
    _, found = through(scene.format(way="down"))
    assert found.placed.speed[1] == pytest.approx(0.0, abs=1e-12)
    assert found.impulses["cord", "tension0"] == pytest.approx(3.0)


def test_a_rim_is_met_where_it_is_in_space() -> None:
    """A particle falls on the rightmost point of a disc that hangs turned by −130°: angular momentum about the hinge."""
    model, found = through(
        """
given: {m: 2 kg, M: 3 kg, R: 50 cm, v: 4 m/s}
bodies: {disc: {shape: disc, mass: M, radius: R}, clay: {mass: m, moves: down}}
connections: {pin: {hinge: disc.bottom}}
states: {start: {disc.angle: -40 deg, at rest: disc, clay.velocity: v}, after: {}}
events: {hit: {joins: [clay, disc.rim], from: start, to: after}}"""
    )
    x, y = 0.5 * (math.cos(math.radians(-40)) + 1), 0.5 * math.sin(math.radians(-40))
    inertia = 1.5 * 3 * 0.25 + 2 * (x * x + y * y)
    assert spin(model, found, "disc") == pytest.approx(-2 * 4 * x / inertia)


LYING = """
given: {{M: 3 kg, m: 2 kg, L: 1 m, u: 3 m/s}}
surfaces: {{ice: level}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}, puck: {{mass: m, moves: right}}}}
connections: {{pin: {{hinge: rod.start}}, base: {{contact: [puck, ice], friction: 0.3}}}}
states: {{before: {{rod.angle: {angle} deg, at rest: rod, puck.velocity: {speed}}}, after: {{}}}}
events: {{hit: {{joins: [{ends}], from: before, to: after}}}}"""


@pytest.mark.parametrize("ends", ["puck, rod.end", "rod.end, puck"])
@pytest.mark.parametrize(("angle", "speed"), [(-90, "u"), (-90, "-u"), (-50, "u"), (-130, "-u")])
def test_what_lies_on_the_floor_goes_round_with_a_rod(angle: float, speed: str, ends: str) -> None:
    """Angular momentum about the hinge: m u L sin φ = (M/3 + m) L² ω; the floor does not hold what lifts off it."""
    model, found = through(LYING.format(angle=angle, speed=speed, ends=ends))
    before = 2 * (3 if speed == "u" else -3) * -math.sin(math.radians(angle))
    assert spin(model, found, "rod") == pytest.approx(before / (3 / 3 + 2))
    assert spin(model, found, "puck") == pytest.approx(before / (3 / 3 + 2))
    assert "base" not in {owner for owner, _ in found.impulses}


@pytest.mark.parametrize(("angle", "speed"), [(-130, "u"), (-50, "-u"), (50, "u"), (90, "u")])
def test_what_a_rod_would_push_into_the_floor_is_not_confirmed(angle: float, speed: str) -> None:
    with pytest.raises(NotConfirmed, match="`base` is in the way"):
        through(LYING.format(angle=angle, speed=speed, ends="puck, rod.end"))
