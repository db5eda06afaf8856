"""Kept: the rates at a later state of bodies that hang together, on one joint of the ground or on none, by what they keep on the way.

For where their motion is too long to be followed, or a motor gives what it takes. What stays is worked out at both states from places and
velocities in space, with several numbers for how bodies stand of which no line tells it; it is quadratic in the rates that are open. To an
angle a body comes in the sense in which that is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.space.arrows import (
    ALONG,
    Arrow,
    Z,
    arrow_length,
    crossed,
    inner_product,
    less,
    normed,
    product_of,
    rotation_about,
    rows_back,
    scaled,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.quadratics import quadratic, shared_roots
from rotsolve.confirm.space.readings import Reading
from rotsolve.confirm.space.rig import Lines, Rig, Told
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import SPEED, SPINS, TURNING, Rates
from rotsolve.confirm.space.worlds import Manner, Moving, World, natural_rate, with_rates
from rotsolve.core.symbols import TIME
from rotsolve.language.bodies import Joint
from rotsolve.language.elements import Action
from rotsolve.language.problem import Path, State, Term

GUESSES = (0.7, 1.1, 1.9)  # for angles that no line tells
UPRIGHT = 1e-12  # how nearly a direction is that of the vertical
STILL_SHARE = 1e-9  # of the square of the largest rate: a second rate that is none
WAY = 48  # places on the way at which it is looked whether it gets on
NEVER = "by what its bodies keep, its motion never comes there"
NOT_KEPT = "what its bodies keep on the way to its state"


def kept_manners(rig: Rig, start: World, state: State, put: Told) -> list[Manner]:
    """The ways in which all moves at a later state with what it has kept since the state before, told apart by the rates on joints."""
    root = root_alone(rig)
    passed = time_alone(rig, root, state)
    motors = any(joint.motor for joint in rig.joints.values())
    leader = None if motors or passed is not None else leading_joint(rig, state)
    for share in (number / WAY for number in range(1, WAY) if leader is not None):  # it has to get there
        assert leader is not None
        there = Underway(rig, state, put, leader, turned_at(start, leader), share)
        if not any(True for _ in roots_kept(rig, root, start, Stance(rig, there, GUESSES[0]))):
            raise Unfit(NEVER)
    if leader is not None:
        check_setting_out(rig, start, state, leader)
    stances = [Stance(rig, Lines(rig, state, put), guess) for guess in GUESSES]
    found = [list(roots_kept(rig, root, start, stance, passed)) for stance in stances]
    if root is None and found[0] and turns_on_line(rig, start):
        stances = [turned_on_line(rig, start, found[0][0], Lines(rig, state, put), guess) for guess in GUESSES]
        found = [list(roots_kept(rig, root, start, stance)) for stance in stances]
    if not found[0] and not stances[0].open:
        raise Unfit(NEVER)
    if not found[0] or len({len(ways) for ways in found}) > 1:
        raise NotConfirmed(NOT_KEPT)
    ordered = [sorted(ways, key=lambda world: spins_of(rig, world)) for ways in found]
    return [Manner(tuple(worlds), 0.0) for worlds in zip(*ordered, strict=True)]


def turns_on_line(rig: Rig, start: World) -> bool:
    """Whether all begins at rest, and one body carries all others on axles of one direction, so that all it does is turn about one line."""
    carriers = {joint.carrier.owner for joint in rig.joints.values()}
    ways = [start.stance.way(joint) for joint in rig.joints.values() if joint.turning]
    along = all(arrow_length(crossed(ways[0], way)) <= UPRIGHT for way in ways) and len(ways) == len(rig.joints)
    moving = max((abs(part) for part in start.now.values.values()), default=0.0)
    return along and len(carriers) == 1 and moving == 0.0


def turned_on_line(rig: Rig, start: World, found: World, lines: Lines, angle: float) -> Stance:
    """A stance in which the body that carries all others is turned by an angle from the start, about the line about which it turns."""
    (carrier,) = {joint.carrier.owner for joint in rig.joints.values()}
    omega = times_arrow(rows_back(found.stance.turned(carrier)), found.now.arrow(TURNING, carrier))
    stance = Stance(rig, lines, angle)
    if arrow_length(omega) > 0.0:
        turned = rotation_about(normed(omega), angle)
        stance.put(carrier, product_of(start.stance.turned(carrier), turned), found.stance.place(carrier))
    return stance


class Underway(Lines):
    """What a state tells, on the way to it: the joint that leads there is turned by a share of its way, and how fast no line says."""

    def __init__(self, rig: Rig, state: State, put: Told, leader: Joint, begun: float, share: float) -> None:
        super().__init__(rig, state, put)
        end = self.told(leader.body.owner, "angle") or 0.0
        self.lines = []
        self.put = {(self.name, leader.body.owner, "angle"): begun + share * (end - begun)}


def time_alone(rig: Rig, root: Joint | None, state: State) -> float | None:
    """The time that a state tells and nothing else, up to which the angular momentum about the joint of the ground grows by what couples
    give; None of a state that tells more."""
    lines = [line for line in state.conditions if line.path is not None]
    if len(lines) != 1 or lines[0].path is None or lines[0].path.quantity != "time" or lines[0].value is None:
        return None
    drives = (part for joint in rig.joints.values() for _, part in joint.drive)
    rolls = any(joint.rolls for joint in rig.joints.values())
    if root is None or root.powered or rolls or state.steady or any(TIME in part.symbols() for part in drives):
        raise NotConfirmed(NOT_KEPT)
    return rig.value(lines[0].value)


def leading_joint(rig: Rig, state: State) -> Joint | None:
    """The only joint of which the state tells to what angle it has turned, where nothing else is told than that; None where nothing is."""
    lines = [line for line in state.conditions if line.path is not None]
    if not lines and not state.conditions and not state.steady:
        return None
    joints = [rig.main(line.path.owner) for line in lines if line.path is not None and line.path.quantity == "angle"]
    if len(lines) != 1 or len(joints) != 1 or joints[0] is None or not joints[0].turning or state.steady:
        raise NotConfirmed(NOT_KEPT)
    return joints[0]


def sets_out_away(rig: Rig, start: World, state: State) -> bool:
    """Whether a body on a hinge turns at first away from the angle that a later state tells, or one on a slide on what turns does not go
    towards its place."""
    lines = Lines(rig, state, {})
    for joint in rig.joints.values():
        if joint.sliding and joint.carrier.owner in rig.bodies and not slides_towards(rig, start, state, joint):
            return True  # past what drives it outwards it may not come
        end = lines.told(joint.body.owner, "angle") if joint.turning else None
        if end is not None and (end - turned_at(start, joint)) * rate_on_joint(start.now, joint) < 0.0:
            return True
    return False


def slides_towards(rig: Rig, start: World, state: State, joint: Joint) -> bool:
    """Whether a body on a slide goes at first towards the place at which a later state has it; not where that is no place on the slide."""
    from rotsolve.confirm.space.flight import Flight

    flight, towards = Flight(rig, start, state), False
    for line in state.conditions:
        path = line.path
        if path is None or (path.owner, path.quantity) != (joint.body.owner, "position"):
            continue
        rate, gap = flight.rate_of(line), flight.gap_of(line)(start)
        if rate is None or gap * rate(start) > 0.0:
            return False
        towards |= gap * rate(start) < 0.0
    return towards


def check_setting_out(rig: Rig, start: World, state: State, leader: Joint) -> None:
    """Refuse what sets out away from its angle, or from rest in balance: whether and how it comes there was not followed."""
    end = Lines(rig, state, {}).told(leader.body.owner, "angle")
    if end is None:
        return
    way, rate = end - turned_at(start, leader), rate_on_joint(start.now, leader)
    if rate == 0.0:
        rate = rate_on_joint(start.found, leader)
        if abs(rate) <= STILL_SHARE * max((abs(part) for part in start.now.values.values()), default=1.0) ** 2:
            raise NotConfirmed("it rests in balance at first, from where the least push decides")
    if way * rate < 0.0:
        raise NotConfirmed("it sets out the other way, and whether it turns back was not looked at")


def turned_at(world: World, joint: Joint) -> float:
    """How far a body is turned about its joint in a world."""
    before = world.stance.swung.get(joint.body.owner)
    return world.stance.angle(joint) if before is None else before


def root_alone(rig: Rig) -> Joint | None:
    """The only joint with the ground, of bodies that are held by one joint each and may roll on what is at rest, on which nothing acts but
    their weights, and couples on the first of them; None of bodies of which one carries all others, and nothing holds that."""
    joints = [joint for joint in rig.joints.values() if not rolls_at_rest(rig, joint)]
    roots = [joint for joint in joints if joint.carrier.owner not in rig.bodies]
    plain = not any(joint.rolls or joint.flat or joint.sliding or joint.pitch is not None for joint in joints)
    each = len({joint.body.owner for joint in joints}) == len(joints) == len(rig.bodies) - (not roots)
    led = any(body.moved for body in rig.bodies.values())
    if len(roots) > 1 or not (plain and each and joints) or led or (rig.gravity and not roots):
        raise NotConfirmed(NOT_KEPT)
    root = roots[0] if roots else None
    if rig.problem.actions and not (root is not None and twisted_alone(rig, root)):
        raise NotConfirmed(NOT_KEPT)
    return root


def rolls_at_rest(rig: Rig, joint: Joint) -> bool:
    """Whether a body that another joint holds rolls on what is at rest, which gives it no power."""
    return joint.rolls and joint.carrier.owner not in rig.bodies and rig.main(joint.body.owner) is not None


def twisted_alone(rig: Rig, root: Joint) -> bool:
    """Whether all that acts are couples that stay, on a body that turns about one axis in the ground: they do the work C · n φ."""
    there = all(ref.owner == root.body.owner for action in rig.problem.actions for ref in action.touches())
    return (
        bool(root.turning)
        and not root.powered
        and there
        and all(is_steady_couple(rig, one) for one in rig.problem.actions)
    )


def is_steady_couple(rig: Rig, action: Action) -> bool:
    """Whether an action is a couple that is the same at all times, wherever the bodies are."""
    size = action.strength()
    parts = size if isinstance(size, tuple) else (size,)
    told = all(isinstance(part, Formula) and part.symbols() <= rig.numbers.keys() - {TIME} for part in parts)
    return action.twists() and told and not (action.from_ or action.to)


def worked(rig: Rig, root: Joint, world: World) -> float:
    """The work of the couples on the first body, from where it is drawn."""
    names = {action.name for action in rig.problem.actions}
    way, turned = world.stance.way(root), turned_at(world, root)
    return sum(inner_product(way, item.couple) * turned for item in world.efforts.list if item.owner in names)


def roots_kept(
    rig: Rig, root: Joint | None, start: World, stance: Stance, passed: float | None = None
) -> Iterator[World]:
    """The worlds of a stance with as much of what is kept as at the start, in which each body comes to its angle as it must; some told time
    later those with as much angular momentum as couples give it."""
    moving = Moving(stance)
    count, scale = len(moving.moving.free), natural_rate(moving)
    wanted = kept_of(rig, root, start, None if passed is None else 0.0)

    def world_with(openly: Sequence[float]) -> World:
        now = moving.rates(openly)
        return World(stance, moving.efforts, now, now)

    def over(openly: Sequence[float]) -> list[float]:
        return [a - b for a, b in zip(kept_of(rig, root, world_with(openly), passed), wanted, strict=True)]

    model = quadratic(over, count, scale) if count else None
    if model is None or len(wanted) < count:
        raise NotConfirmed(NOT_KEPT)
    for found in shared_roots(model):
        openly = with_rates([0.0] * count, range(count), [part * scale for part in found])
        world = world_with(openly)
        if comes_so(rig, start, world):
            (whole,) = moving.way([openly]).worlds[:1]
            yield whole


def kept_of(rig: Rig, root: Joint | None, world: World, passed: float | None) -> list[float]:
    """What stays: on a joint of the ground, or on none; after a told time what couples have given taken off."""
    if root is not None and passed is not None:
        return kept_with_impulse(rig, root, world, passed)
    return kept_afloat(rig, world) if root is None else kept_on_ground(rig, root, world)


def kept_afloat(rig: Rig, world: World) -> list[float]:
    """The momentum, the angular momentum about the common centre of mass, and without motors the energy, along the axes of space."""
    masses = {name: rig.solid(name).mass for name in rig.bodies}
    momentum = sum_of(*(scaled(mass, world.now.arrow(SPEED, name)) for name, mass in masses.items()))
    centre = scaled(
        1.0 / sum(masses.values()), sum_of(*(scaled(masses[name], world.stance.place(name)) for name in masses))
    )
    turning = whole_momentum(rig, centre, world)
    kept = [*momentum, *turning]
    return kept if any(joint.powered for joint in rig.joints.values()) else [*kept, energy_in(world)]


def kept_with_impulse(rig: Rig, root: Joint, world: World, passed: float) -> list[float]:
    """The angular momentum about the free direction of the root, without what couples that stay have given it in some time: C · n t; and
    the axial rates of wheels that turn freely."""
    way, names = free_way(rig, root, world.stance), {action.name for action in rig.problem.actions}
    if way is None:
        raise NotConfirmed(NOT_KEPT)
    given = sum(inner_product(way, item.couple) for item in world.efforts.list if item.owner in names)
    momentum = inner_product(way, whole_momentum(rig, world.stance.held_at(root), world))
    return [momentum - given * passed, *axial_rates(rig, root, world)]


def axial_rates(rig: Rig, root: Joint, world: World) -> Iterator[float]:
    """ω along its axle of each wheel, the same all round that, which turns freely on what carries it and carries nothing: Euler's equation
    with I₁ = I₂."""
    carriers = {joint.carrier.owner for joint in rig.joints.values()}
    for joint in (joint for joint in rig.joints.values() if joint is not root and joint.turning):
        name, way = joint.body.owner, world.stance.way(joint)
        own = [times_arrow(world.stance.turned(name), ALONG[axis]) for axis in range(3) if rig.symmetric(name, axis)]
        wheel = any(arrow_length(crossed(axis, way)) <= UPRIGHT for axis in own) and rig.solid(name).whole
        if wheel and not joint.powered and name not in carriers:
            yield inner_product(way, world.now.arrow(TURNING, name))


def kept_on_ground(rig: Rig, root: Joint, world: World) -> list[float]:
    """What stays: the angular momentum about the free direction of the root, where only weights act; the energy without the work of
    couples, less Ω L where the root is driven round at Ω."""
    way, kept = free_way(rig, root, world.stance), list[float]()
    drive, inner = dict(root.drive), [joint for joint in rig.joints.values() if joint is not root]
    momentum = None if way is None else inner_product(way, whole_momentum(rig, world.stance.held_at(root), world))
    pushed = bool(rig.problem.actions) or any(joint.rolls for joint in rig.joints.values())
    if momentum is not None and not (root.powered or pushed):
        kept.append(momentum)
    if root.motor or any(joint.powered for joint in inner):
        return kept
    rate = drive.get("angular_velocity") if len(drive) == 1 else None
    if drive and (momentum is None or rate is None or TIME in rate.symbols()):
        return kept
    energy = energy_in(world) - worked(rig, root, world)
    return [*kept, energy if rate is None else energy - rig.value(rate) * (momentum or 0.0)]


def energy_in(world: World) -> float:
    """The kinetic energy of all bodies, and that of their weights."""
    return Reading(world).energy(Path("", "energy"), Term(Path("", "energy")))


def free_way(rig: Rig, root: Joint, stance: Stance) -> Arrow | None:
    """The direction about which neither the ground nor a weight turns the bodies."""
    if root.free:
        return Z
    if not root.turning:
        return None
    way = stance.way(root)
    upright = arrow_length(crossed(way, Z)) <= UPRIGHT
    return way if upright or not rig.gravity else None


def whole_momentum(rig: Rig, origin: Arrow, world: World) -> Arrow:
    """Σ I ω + r × m v, from a place."""
    parts = list[Arrow]()
    for name in rig.bodies:
        arm = less(world.stance.place(name), origin)
        parts.append(times_arrow(world.efforts.tensor(name), world.now.arrow(TURNING, name)))
        parts.append(crossed(arm, scaled(rig.solid(name).mass, world.now.arrow(SPEED, name))))
    return sum_of(*parts)


def comes_so(rig: Rig, start: World, world: World) -> bool:
    """Whether no body passes the angle that it comes to, for the first time, the other way."""
    for joint in rig.joints.values():
        name = joint.body.owner
        if not joint.turning or name in world.stance.open or world.stance.lines.told(name, "angle") is None:
            continue
        way = world.stance.angle(joint) - turned_at(start, joint)
        if way * rate_on_joint(world.now, joint) < 0.0:
            return False
    return True


def rate_on_joint(now: Rates, joint: Joint) -> float:
    return now.one(SPINS, joint.owner)


def spins_of(rig: Rig, world: World) -> list[float]:
    """How fast all joints turn, roughly: what tells ways apart."""
    return [round(rate_on_joint(world.now, joint), 6) for joint in rig.joints.values() if joint.turning]
