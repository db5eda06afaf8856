"""Hinged: rods with loads about a hinge, held, let go, and falling; and ladders."""

from __future__ import annotations

from mpmath import cos, mpf, sin, sqrt

from trials.case import Case, G, letters, scene
from trials.draw import Draw, Value, radians


def loaded(draw: Draw) -> tuple[Case, mpf, mpf, mpf]:
    """A rod about its start with a load welded on its end or at a place: the scene, its mass, its moment of mass, its inertia."""
    M, L, m = draw.size("kg"), draw.size("m"), draw.size("kg")
    case = Case(
        scene(
            "Rod about a hinge",
            given=letters(M=M, L=L),
            bodies={"rod": {"shape": "rod", "mass": "M", "length": "L"}},
            connections={"pin": {"hinge": "rod.start"}},
        )
    )
    mass, moment, inertia = M.x, M.x * L.x / 2, M.x * L.x**2 / 3
    if draw.often(0.4):
        case.scene["given"]["m"] = m.text
        case.scene["bodies"]["bob"] = {"mass": "m"}
        place, at = draw.chance.choice((("rod.end", mpf(1)), ("rod.at(L/3)", mpf(1) / 3), ("rod.center", mpf(1) / 2)))
        case.scene["connections"]["joint"] = {"weld": [place, "bob"]}
        mass, moment, inertia = mass + m.x, moment + m.x * at * L.x, inertia + m.x * (at * L.x) ** 2
    return case, mass, moment, inertia


def released(draw: Draw) -> Case:
    """Let go from rest at an angle, perhaps with a couple: angular acceleration and force of the hinge."""
    case, mass, moment, inertia = loaded(draw)
    theta = signed(draw, draw.angle())
    case.scene["given"]["theta"] = theta.text
    case.scene["states"] = {"now": {"rod.angle": "theta", "at rest": "all"}}
    angle = radians(theta)
    couple = mpf(0)
    if draw.often(0.3):
        C = draw.size("N m")
        case.scene["given"]["C"] = C.text
        case.scene["actions"] = {"motor": {"couple": "C", "on": "rod"}}
        couple = C.x
    alpha = (couple - moment * G * cos(angle)) / inertia
    case.ask("alpha", "rod.angular_acceleration", alpha)
    case.ask("Fx", "pin.force.x", -moment * sin(angle) * alpha)
    case.ask("Fy", "pin.force.y", mass * G + moment * cos(angle) * alpha)
    return case


def signed(draw: Draw, angle: Value) -> Value:
    """The angle, or the one below the level."""
    return angle if draw.often(0.6) else Value(f"-{angle.text}", -angle.number)


def falls(draw: Draw) -> Case:
    """Let go at one angle, looked at at a lower one, perhaps with a first push."""
    case, mass, moment, inertia = loaded(draw)
    start, end = draw.angle(), signed(draw, draw.angle())
    if start.number <= end.number:
        start, end = Value(end.text, end.number), Value(start.text, start.number)
    if start.number == end.number:
        end = Value("-89 deg", -89)  # type: ignore[arg-type]
    case.scene["given"] |= {"theta": start.text, "phi": end.text}
    case.scene["states"] = {"high": {"rod.angle": "theta", "at rest": "all"}, "low": {"rod.angle": "phi"}}
    one, other = radians(start), radians(end)
    drop = 2 * cos((one + other) / 2) * sin((one - other) / 2)  # sin θ − sin φ
    spin = -sqrt(2 * moment * G * drop / inertia)
    alpha = -moment * G * cos(other) / inertia
    case.ask("omega", "rod.angular_velocity at low", spin)
    case.ask("alpha", "rod.angular_acceleration at low", alpha)
    case.ask("Fx", "pin.force.x at low", moment * (-sin(other) * alpha - cos(other) * spin**2))
    case.ask("Fy", "pin.force.y at low", mass * G + moment * (cos(other) * alpha - sin(other) * spin**2))
    case.ask("K", "kinetic_energy at low", moment * G * drop)
    return case


def held(draw: Draw) -> Case:
    """A boom held level by a force at an angle at its end, with a load on it."""
    M, L, m, phi = draw.size("kg"), draw.size("m"), draw.size("kg"), draw.angle()
    case = Case(
        scene(
            "Boom held by a chain",
            given=letters(M=M, L=L, m=m, phi=phi),
            bodies={"boom": {"shape": "rod", "mass": "M", "length": "L"}, "load": {"mass": "m"}},
            connections={"hinge": {"hinge": "boom.start"}, "place": {"weld": ["boom.at(L/4)", "load"]}},
            actions={"chain": {"force": "unknown", "on": "boom.end", "direction": "180 deg - phi"}},
            states={"rest": {"boom.angle": "0", "balance": "true"}},
        )
    )
    pull = (M.x / 2 + m.x / 4) * G / sin(radians(phi))
    case.ask("T", "chain.force at rest", pull)
    case.ask("Fx", "hinge.force.x at rest", pull * cos(radians(phi)))
    case.ask("Fy", "hinge.force.y at rest", (M.x + m.x) * G - pull * sin(radians(phi)))
    return case


def ladder(draw: Draw) -> Case:
    """A ladder on a smooth floor and wall as it is let go."""
    M, L, theta = draw.size("kg"), draw.size("m"), draw.angle()
    case = Case(
        scene(
            "Ladder",
            given=letters(M=M, L=L, theta=theta),
            surfaces={"floor": "level", "side": {"wall": "right"}},
            bodies={"ladder": {"shape": "rod", "mass": "M", "length": "L"}},
            connections={"foot": {"contact": ["ladder.start", "floor"]}, "head": {"contact": ["ladder.end", "side"]}},
            states={"released": {"ladder.angle": "theta", "at rest": "all"}},
        )
    )
    angle = radians(theta)
    case.ask("alpha", "ladder.angular_acceleration", -3 * G * cos(angle) / (2 * L.x))
    case.ask("N", "foot.normal_force", M.x * G * (1 - 3 * cos(angle) ** 2 / 4))
    case.ask("P", "head.normal_force", 3 * M.x * G * sin(angle) * cos(angle) / 4)
    return case
