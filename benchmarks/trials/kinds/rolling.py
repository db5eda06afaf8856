"""Rolling: bodies on slopes and floors that roll, slide, or do either as friction allows."""

from __future__ import annotations

from mpmath import cos, mpf, sign, sin, sqrt, tan

from trials.case import Case, G, letters, scene
from trials.draw import Draw, radians

ROUND = {
    "cylinder": mpf(1) / 2,
    "ring": mpf(1),
    "sphere": mpf(2) / 5,
    "spherical shell": mpf(2) / 3,
    "disc": mpf(1) / 2,
}


def on_slope(draw: Draw) -> Case:
    """A round body on a rough slope: it rolls where μ is large enough, else slides and turns."""
    shape = draw.pick(*ROUND)
    k, m, R, beta, mu = ROUND[shape], draw.size("kg"), draw.size("m", 0.05, 0.5), draw.angle(), draw.share()
    side = draw.pick("left", "right")
    rolls = draw.often(0.5)
    base = {"rolls": ["body", "ramp"]} if rolls else {"contact": ["body", "ramp"], "friction": "mu"}
    given = letters(m=m, R=R, beta=beta) | ({} if rolls else {"mu": mu.text})
    case = Case(
        scene(
            "Body on a slope",
            given=given,
            surfaces={"ramp": {"slope": "beta", "down": side}},
            bodies={"body": {"shape": shape, "mass": "m", "radius": "R", "moves": "down"}},
            connections={"base": base},
        )
    )
    angle = radians(beta)
    pull = G * sin(angle)
    sticks = rolls or mu.x >= k / (1 + k) * tan(angle)
    pace = pull / (1 + k) if sticks else pull - mu.x * G * cos(angle)
    turn = pace / R.x if sticks else mu.x * G * cos(angle) / (k * R.x)
    case.ask("a", "body.acceleration", pace)
    case.ask("alpha", "size of body.angular_acceleration", turn)
    case.ask("f", "size of base.friction_force", m.x * (pull - pace))
    case.ask("N", "base.normal_force", m.x * G * cos(angle))
    return case


def pulled(draw: Draw) -> Case:
    """A spool pulled by the thread on its hub, at an angle."""
    M, inertia, R, r, F, phi = (
        draw.size("kg"),
        draw.size("kg m^2", 0.01, 1.0),
        draw.size("m", 0.1, 0.9),
        draw.size("m", 0.1, 0.9),
        draw.size("N"),
        draw.angle(),
    )
    case = Case(
        scene(
            "Spool pulled by its thread",
            given=letters(M=M, I=inertia, R=R, r=r, F=F, phi=phi),
            surfaces={"floor": "level"},
            bodies={"spool": {"mass": "M", "inertia": "I", "radii": {"flange": "R", "hub": "r"}, "moves": "right"}},
            connections={"base": {"rolls": ["spool.flange", "floor"]}},
            actions={"thread": {"force": "F", "on": "spool.hub", "direction": "phi", "under": "true"}},
        )
    )
    pace = F.x * (cos(radians(phi)) - r.x / R.x) / (M.x + inertia.x / R.x**2)
    case.ask("a", "spool.acceleration", pace)
    case.ask("f", "size of base.friction_force", abs(M.x * pace - F.x * cos(radians(phi))))
    case.ask("N", "base.normal_force", M.x * G - F.x * sin(radians(phi)))
    return case


def thrown(draw: Draw) -> Case:
    """A round body thrown along a rough floor with some spin, until it rolls."""
    shape = draw.pick(*ROUND)
    k, m, R, u, mu, w = (
        ROUND[shape],
        draw.size("kg"),
        draw.size("m", 0.05, 0.5),
        draw.size("m/s"),
        draw.share(),
        draw.size("rad/s"),
    )
    spin = draw.pick("none", "forward", "back")
    said = {"none": "0", "forward": "w", "back": "-w"}[spin]
    forward = {"none": mpf(0), "forward": w.x, "back": -w.x}[spin]  # clockwise rolls to the right
    slip = u.x - R.x * forward
    case = Case(
        scene(
            "Body thrown along a floor",
            given=letters(m=m, R=R, u=u, mu=mu) | ({} if spin == "none" else {"w": w.text}),
            surfaces={"floor": "level"},
            bodies={"ball": {"shape": shape, "mass": "m", "radius": "R", "moves": "right", "turns": "clockwise"}},
            connections={"grip": {"contact": ["ball", "floor"], "friction": "mu"}},
            states={"thrown": {"ball.velocity": "u", "ball.angular_velocity": said}, "rolling": {"grip": "rolls"}},
        )
    )
    if not slip:
        return case
    push = -sign(slip) * mu.x * G
    time = abs(slip) / (mu.x * G * (1 + 1 / k))
    case.ask("a", "ball.acceleration at thrown", push)
    case.ask("t", "time from thrown to rolling", time)
    case.ask("v", "ball.velocity at rolling", u.x + push * time)
    case.ask("x", "ball.displacement from thrown to rolling", u.x * time + push * time**2 / 2)
    case.ask("omega", "ball.angular_velocity at rolling", (u.x + push * time) / R.x)
    return case


def slides_down(draw: Draw) -> Case:
    """A block on a rough slope with a level push: it stays, or slides one way or the other."""
    m, beta, mu, F = draw.size("kg"), draw.angle(), draw.share(), draw.size("N")
    pushed = draw.often(0.5)
    case = Case(
        scene(
            "Block on a rough slope",
            given=letters(m=m, beta=beta, mu=mu) | ({"F": F.text} if pushed else {}),
            surfaces={"ramp": {"slope": "beta", "down": "left"}},
            bodies={"block": {"mass": "m", "moves": "up"}},
            connections={"base": {"contact": ["block", "ramp"], "friction": "mu"}},
            actions={"push": {"force": "F", "on": "block", "direction": "right"}} if pushed else {},
            states={"now": "at rest"},
        )
    )
    angle, force = radians(beta), F.x if pushed else mpf(0)
    up = force * cos(angle) - m.x * G * sin(angle)
    normal = m.x * G * cos(angle) + force * sin(angle)
    stays = abs(up) <= mu.x * normal
    friction = -up if stays else -sign(up) * mu.x * normal
    case.ask("a", "block.acceleration", (up + friction) / m.x if not stays else mpf(0))
    case.ask("f", "size of base.friction_force", abs(friction))
    case.ask("N", "base.normal_force", normal)
    if not stays and draw.often(0.5):
        way = draw.size("m")
        case.scene["given"]["d"] = way.text
        case.scene["states"] = {"now": "at rest", "later": {"block.displacement": "d" if up > 0 else "-d"}}
        case.scene["find"] = {name: f"{phrase} at now" for name, phrase in case.scene["find"].items()}
        pace = abs(up + friction) / m.x
        case.ask("v", "block.velocity at later", sign(up) * sqrt(2 * pace * way.x))
    return case
