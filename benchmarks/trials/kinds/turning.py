"""Turning: wheels on gears and belts, speeded up, slowed by drag, run back; and bodies made of pieces."""

from __future__ import annotations

from mpmath import log, mp, mpf

from trials.case import Case, G, Train, letters, scene
from trials.draw import Draw


def gears(draw: Draw) -> Case:
    """Wheels in a row that drive each other by gears or belts, with a block on the last."""
    count = draw.chance.choice((2, 2, 3, 4))
    given: dict[str, str] = {}
    bodies: dict[str, object] = {}
    connections: dict[str, object] = {}
    system, ratio, senses = Train(), mpf(1), []
    before = None
    for number in range(1, count + 1):
        inertia, radius = draw.size("kg m^2"), draw.size("m", 0.05, 0.5)
        given |= {f"I{number}": inertia.text, f"R{number}": radius.text}
        turns = draw.pick("clockwise", "counterclockwise")
        if before is not None:
            kind = draw.pick("gear", "belt")
            ratio *= before.x / radius.x * (-1 if kind == "gear" else 1)
            connections[f"link{number}"] = {kind: [f"wheel{number - 1}", f"wheel{number}"]}
        bodies[f"wheel{number}"] = {"inertia": f"I{number}", "radius": f"R{number}", "turns": turns}
        connections[f"axle{number}"] = {"axle": f"wheel{number}"}
        senses.append(ratio * (-1 if turns == "clockwise" else 1))
        system.body(inertia.x, ratio)
        before = radius
    couple = draw.size("N m")
    given["C"] = couple.text
    actions = {"motor": {"couple": "C", "on": "wheel1", "direction": "counterclockwise"}}
    system.push(couple.x, mpf(1))
    if draw.often(0.5):
        mass = draw.size("kg")
        assert before is not None
        given["m"] = mass.text
        bodies["load"] = {"mass": "m", "moves": "up"}
        connections["cord"] = {"string": ["load", f"wheel{count}"]}
        system.body(mass.x, -ratio * before.x, force=-mass.x * G)
    turn = system.accelerations()[0]
    case = Case(
        scene("Wheels that drive each other", given=given, bodies=bodies, connections=connections, actions=actions)
    )
    case.ask("alpha", "wheel1.angular_acceleration", senses[0] * turn)
    case.ask("beta", f"wheel{count}.angular_acceleration", senses[-1] * turn)
    return case


def speeded(draw: Draw) -> Case:
    """A wheel brought from one speed to another by a force on its rim."""
    M, R, F, w, t = draw.size("kg"), draw.size("m", 0.05, 0.9), draw.size("N"), draw.size("rad/s"), draw.size("s")
    case = Case(
        scene(
            "Wheel pulled at its rim",
            given=letters(M=M, R=R, F=F, w=w, T=t),
            bodies={"wheel": {"shape": "disc", "mass": "M", "radius": "R"}},
            connections={"axle": {"axle": "wheel"}},
            actions={"pull": {"force": "F", "on": "wheel.rim", "direction": "tangential"}},
            states={"start": {"wheel.angular_velocity": "w"}, "end": {"time": "T"}},
        )
    )
    alpha = 2 * F.x / (M.x * R.x)
    angle = w.x * t.x + alpha * t.x**2 / 2
    case.ask("alpha", "wheel.angular_acceleration at start", alpha)
    case.ask("omega", "wheel.angular_velocity at end", w.x + alpha * t.x)
    case.ask("n", "wheel.turns from start to end", angle / (2 * mp.pi))
    case.ask("W", "pull.work from start to end", F.x * R.x * angle)
    case.ask("a", "size of wheel.rim.acceleration at end", R.x * mp.sqrt(alpha**2 + (w.x + alpha * t.x) ** 4))
    return case


def dragged(draw: Draw) -> Case:
    """A flywheel slowed by a torque that goes by its speed."""
    inertia, c, w, share = draw.size("kg m^2"), draw.size("N m s", 0.01, 1.0), draw.size("rad/s"), draw.share()
    case = Case(
        scene(
            "Flywheel in oil",
            gravity="none",
            given={**letters(I=inertia, c=c, w=w), "s": share.text},
            bodies={"wheel": {"inertia": "I"}},
            connections={"axle": {"axle": "wheel"}},
            actions={"oil": {"couple": "-c*wheel.angular_velocity", "on": "wheel"}},
            states={"off": {"wheel.angular_velocity": "w"}, "later": {"wheel.angular_velocity": "s*w"}},
        )
    )
    case.ask("alpha", "wheel.angular_acceleration at off", -c.x * w.x / inertia.x)
    case.ask("t", "time from off to later", -log(share.x) * inertia.x / c.x)
    case.ask("n", "wheel.turns from off to later", inertia.x * w.x * (1 - share.x) / (2 * mp.pi * c.x))
    return case


def reversed_turn(draw: Draw) -> Case:
    """A wheel that slows down and perhaps runs back: net and whole angle."""
    w, a, t = draw.size("rad/s"), draw.size("rad/s^2"), draw.size("s")
    case = Case(
        scene(
            "Wheel that may run back",
            given=letters(w=w, a=a, T=t),
            bodies={"wheel": {"inertia": "1 kg m^2"}},
            connections={"axle": {"axle": "wheel", "angular_acceleration": "-a"}},
            states={"start": {"wheel.angle": "0", "wheel.angular_velocity": "w"}, "end": {"time": "T"}},
        )
    )
    net = w.x * t.x - a.x * t.x**2 / 2
    turning = w.x / a.x
    back = turning < t.x
    case.ask("net", "wheel.rotation from start to end", net)
    case.ask("whole", "total wheel.rotation from start to end", w.x**2 / a.x - net if back else net)
    case.ask("most", "largest wheel.angle from start to end", w.x**2 / (2 * a.x) if back else net)
    case.ask("omega", "wheel.angular_velocity at end", w.x - a.x * t.x)
    return case


def pieces(draw: Draw) -> Case:
    """A body made of a rod, a disc and a particle: centre of mass and moments of inertia."""
    m, L, M, R, p, d = draw.size("kg"), draw.size("m"), draw.size("kg"), draw.size("m"), draw.size("kg"), draw.size("m")
    parts = {
        "stick": {"shape": "rod", "mass": "m", "length": "L", "start": ["0", "0"], "end": ["0", "-L"]},
        "bob": {"shape": "disc", "mass": "M", "radius": "R", "at": ["0", "-L"]},
        "nut": {"mass": "p", "at": ["0", "d"]},
    }
    case = Case(
        scene(
            "Body of three pieces",
            given=letters(m=m, L=L, M=M, R=R, p=p, d=d),
            bodies={"clock": {"parts": parts, "points": {"O": ["0", "0"]}}},
        )
    )
    mass = m.x + M.x + p.x
    height = (p.x * d.x - m.x * L.x / 2 - M.x * L.x) / mass
    about = m.x * L.x**2 / 3 + M.x * (R.x**2 / 2 + L.x**2) + p.x * d.x**2
    case.ask("y", "clock.cm.y", height)
    case.ask("I", "clock.inertia about clock.O", about)
    case.ask("J", "clock.inertia", about - mass * height**2)
    case.ask("k", "clock.gyration about clock.O", mp.sqrt(about / mass))
    return case
