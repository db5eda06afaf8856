"""Mechanics: what hangs on the mass of a body at one instant, and its own data: energies, momenta, forces; sums over all bodies."""

from __future__ import annotations

import math

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.course.reading import (
    NATURAL,
    Reading,
    Reckoned,
    bends,
    component_of,
    counted,
    cross,
    natural,
    number,
    of_body,
    point_place,
    rates,
    scalar,
    second_rate,
    values,
    vector,
)
from rotsolve.language.problem import Path, Term


def kinetic_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    """½ m v² + ½ I ω²: of the body alone."""
    rigid = at.model.seats[path.owner].rigid
    speed, spin = rates(point_place(at, path.owner, "cm")), at.pose.turn(path.owner).rate
    travel, turning = 0.5 * rigid.mass * scalar(speed, speed), 0.5 * rigid.inertia * spin * spin
    if path.owner in at.model.whirled:
        from rotsolve.confirm.carried import about_shaft

        turning += 0.5 * at.model.whirled[path.owner] ** 2 * about_shaft(path.owner, at.model, at.pose)
    if at.axis(path.owner) is not None:
        turning, travel = travel + turning, 0 * travel
    return number({"rotational": turning, "translational": travel}.get(path.component or "", travel + turning))


def height_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m g y: only differences count."""
    rigid = at.model.seats[path.owner].rigid
    return number(rigid.mass * at.model.gravity * point_place(at, path.owner, "cm")[1].value)


def body_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(kinetic_energy(at, path, term).number + height_energy(at, path, term).number)


def momentum(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m v: along the line of travel where there is one."""
    mass, speed = at.model.seats[path.owner].rigid.mass, rates(point_place(at, path.owner, "cm"))
    way = (mass * speed[0], mass * speed[1])
    line = at.line(path.owner)
    if path.component is None and line is not None:
        return number(scalar(way, line), math.hypot(*way))
    return component_of(way, path.component)


def angular_momentum(at: Node, path: Path, term: Term | None) -> Reckoned:
    """r × m v + I ω about a named point, else about the axis or the centre of mass; along the positive turn."""
    if path.component not in (None, "z") or path.point is not None:
        raise NotConfirmed("an angular momentum in space, or that of a part")
    rigid, centre = at.model.seats[path.owner].rigid, point_place(at, path.owner, "cm")
    middle = at.reference(path.owner, term)
    arm = (centre[0].value - middle[0], centre[1].value - middle[1])
    orbital = rigid.mass * cross(arm, rates(centre))
    spin = rigid.inertia * at.pose.turn(path.owner).rate
    return number((orbital + spin) * at.model.sense(path.owner), abs(orbital) + abs(spin))


def net_force(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m a of the centre of mass, or the weight alone."""
    rigid = at.model.seats[path.owner].rigid
    way = bends(point_place(at, path.owner, "cm"), at)
    if path.component == "gravity":
        return vector((0.0, -rigid.mass * at.model.gravity))
    if path.component in NATURAL:
        found = natural(at, Path(path.owner, "force", "cm", component=path.component), way)
        return number(rigid.mass * found.number, rigid.mass * found.size)
    return component_of((rigid.mass * way[0], rigid.mass * way[1]), None if path.component == "net" else path.component)


def torque(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Of all forces, d(r × m v + I ω)/dt about a point that stays, or of the weight alone."""
    rigid, centre = at.model.seats[path.owner].rigid, point_place(at, path.owner, "cm")
    middle = at.reference(path.owner, term)
    arm = (centre[0].value - middle[0], centre[1].value - middle[1])
    if path.component == "gravity":
        found = -arm[0] * rigid.mass * at.model.gravity
    elif path.component not in (None, "net"):
        raise NotConfirmed(f"the torque of `{path.component}` alone")
    else:
        push = bends(centre, at)
        found = rigid.mass * cross(arm, push) + rigid.inertia * second_rate(at.pose.turn(path.owner), at)
    return number(found * counted(at, path), rigid.mass * at.model.gravity * math.hypot(*arm))


def power(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m a · v + I α ω, or that of the weight alone."""
    rigid, centre = at.model.seats[path.owner].rigid, point_place(at, path.owner, "cm")
    speed = rates(centre)
    if path.component == "gravity":
        return number(-rigid.mass * at.model.gravity * speed[1])
    if path.component not in (None, "net"):
        raise NotConfirmed(f"the power of `{path.component}` alone")
    turn = at.pose.turn(path.owner)
    return number(rigid.mass * scalar(bends(centre, at), speed) + rigid.inertia * second_rate(turn, at) * turn.rate)


def instantaneous_centre(at: Node, path: Path, term: Term | None) -> Reckoned:
    """From the centre of mass, where v + ω × r = 0."""
    speed, spin = rates(point_place(at, path.owner, "cm")), at.pose.turn(path.owner).rate
    if spin == 0.0:
        raise NotConfirmed("a body that does not turn has no instantaneous centre")
    return component_of((-speed[1] / spin, speed[0] / spin), path.component)


def period(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(2 * math.pi / abs(at.pose.turn(path.owner).rate))


def own_data(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Mass, radius or length of a body; of what rides on another its distance from the axis."""
    if path.quantity == "mass":
        return number(at.model.seats[path.owner].rigid.mass)
    body = at.model.body(path.owner)
    if path.quantity == "radius":
        radius = radius_of(body, None, at.model.value)
        if radius is None and body.shape is not None and getattr(body.shape, "radius", None) is not None:
            radius = at.model.value(body.shape.radius)
        if radius is not None:
            return number(radius)
    length = getattr(body.shape, "length", None)
    if path.quantity == "length" and length is not None:
        return number(at.model.value(length))
    raise NotConfirmed(f"the {path.quantity} of `{path.owner}`")


def inertia(at: Node, path: Path, term: Term | None) -> Reckoned:
    """About the centre of mass, or I + m d² about a named point; the radius of gyration √(I/m)."""
    if (term is not None and term.along is not None) or path.point is not None:
        raise NotConfirmed("a moment of inertia about an axis in the plane, or of a part")
    rigid, moment = at.model.seats[path.owner].rigid, at.model.seats[path.owner].rigid.inertia
    if term is not None and term.about is not None:
        middle, centre = at.reference(path.owner, term), values(point_place(at, path.owner, "cm"))
        moment += rigid.mass * ((centre[0] - middle[0]) ** 2 + (centre[1] - middle[1]) ** 2)
    return number(moment if path.quantity == "inertia" else math.sqrt(moment / rigid.mass))


def body_height(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(at.height(path.owner))


def of_scene(at: Node, path: Path, term: Term | None) -> Reckoned:
    """The sum over all bodies."""
    if path.quantity == "time":
        return number(at.time)
    if path.quantity in ("kinetic_energy", "mass", "momentum"):
        parts = [of_body(at, Path(name, path.quantity, component=path.component), None) for name in at.model.seats]
        if path.quantity == "momentum" and path.component is None:
            raise NotConfirmed("a momentum of all bodies without its component")
        return number(math.fsum(part.number for part in parts), max(part.size for part in parts))
    if path.quantity == "angular_momentum":
        return angular_momentum_of_all(at, path, term)
    if path.quantity in ("potential_energy", "energy"):
        parts = [of_body(at, Path(name, path.quantity), None) for name in at.model.seats]
        return number(math.fsum(part.number for part in parts) + at.stored(), max(part.size for part in parts))
    raise NotConfirmed(f"`{path.quantity}` of the whole scene")


def angular_momentum_of_all(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Σ (r × m v + I ω) about one point, or each about its axis; along the turn that those that turn have in common as positive."""
    names = list(at.model.seats)
    turning = [name for name in names if name in at.model.held]
    turning = turning or [name for name in names if at.model.seats[name].rigid.inertia > 0.0]
    senses = {at.model.sense(name) for name in turning}
    if len(senses) != 1:
        raise NotConfirmed("an angular momentum of bodies that count their turns differently")
    parts = [(at.model.sense(name), angular_momentum(at, replace(path, owner=name), term)) for name in names]
    found = math.fsum(sense * part.number for sense, part in parts) * senses.pop()
    return number(found, max(part.size for _, part in parts))


def period_of_swings(at: Node, path: Path, term: Term | None) -> Reckoned:
    """The period of small swings about a state, or their frequency, by the slope of what drives the body back."""
    from rotsolve.confirm.course.swings import Small, period_as_asked

    return period_as_asked(Small(at, path.owner).period(told=at.model.acting.state.balance), path.quantity)


OF_BODIES: dict[str, Reading] = {
    **dict.fromkeys(("swing_period", "frequency", "angular_frequency"), period_of_swings),
    "kinetic_energy": kinetic_energy,
    "potential_energy": height_energy,
    "energy": body_energy,
    "momentum": momentum,
    "angular_momentum": angular_momentum,
    "force": net_force,
    "torque": torque,
    "power": power,
    "instantaneous_centre": instantaneous_centre,
    "period": period,
    "height": body_height,
    **dict.fromkeys(("inertia", "gyration"), inertia),
    **dict.fromkeys(("mass", "radius", "length"), own_data),
}
