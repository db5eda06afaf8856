"""Strings: blocks, pulleys and drums tied together."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mpmath import cos, mpf, sin

from trials.case import Case, G, Train, letters, scene
from trials.draw import Draw, Value, radians

SHAPES = {
    "disc": Fraction(1, 2),
    "cylinder": Fraction(1, 2),
    "ring": Fraction(1),
    "sphere": Fraction(2, 5),
    "spherical shell": Fraction(2, 3),
}


def wheel(draw: Draw, mass: Value, radius: Value, given: dict[str, str], number: int) -> tuple[dict[str, str], mpf]:
    """A wheel as a scene writes it, and its moment of inertia about its axle."""
    if draw.often(0.2):
        inertia = draw.size("kg m^2", 0.01, 1.0)
        given[f"I{number}"] = inertia.text
        return {"inertia": f"I{number}", "radius": f"R{number}"}, inertia.x
    shape = draw.pick(*SHAPES)
    share = mpf(SHAPES[shape].numerator) / SHAPES[shape].denominator
    return {"shape": shape, "mass": f"M{number}", "radius": f"R{number}"}, share * mass.x * radius.x**2


class Block:
    """A block at one end of a string: hanging, on a slope or on the level, rough or not."""

    def __init__(self, draw: Draw, name: str, first: bool) -> None:
        self.name, self.first = name, first
        self.mass = draw.size("kg")
        self.given = {f"m_{name}": self.mass.text}
        self.place = draw.pick("hangs", "hangs", "slope", "level")
        words = {"hangs": ("up", "down"), "slope": ("up", "down"), "level": ("right", "left")}[self.place]
        self.moves = draw.pick(*words)
        forth = words[0] if first or self.place == "level" else words[1]
        self.sign = 1 if self.moves == forth else -1
        self.pull = mpf(0)  # of gravity, along the run of the string
        self.normal = mpf(0)
        self.static = self.kinetic = mpf(0)
        self.angle = draw.angle() if self.place == "slope" else None
        weight = self.mass.x * G
        if self.place == "hangs":
            self.pull = -weight if first else weight
        elif self.angle is not None:
            self.given[f"b_{name}"] = self.angle.text
            self.pull = weight * sin(radians(self.angle)) * (-1 if first else 1)
            self.normal = weight * cos(radians(self.angle))
        else:
            self.normal = weight
        self.rough = self.place != "hangs" and draw.often(0.4)
        if self.rough:
            friction = draw.share(6)
            self.given[f"mu_{name}"] = friction.text
            self.static = self.kinetic = friction.x * self.normal

    def enter(self, bodies: dict[str, Any], surfaces: dict[str, Any], connections: dict[str, Any]) -> None:
        bodies[self.name] = {"mass": f"m_{self.name}", "moves": self.moves}
        if self.place == "hangs":
            return
        under = f"under_{self.name}"
        surfaces[under] = (
            {"slope": f"b_{self.name}", "down": "left" if self.first else "right"} if self.angle else "level"
        )
        rough = {"friction": f"mu_{self.name}"} if self.rough else {}
        connections[f"base_{self.name}"] = {"contact": [self.name, under], **rough}


def train(draw: Draw, wheels: int | None = None) -> Case:
    """Two blocks tied by a string that runs over wheels, with friction and couples."""
    count = draw.chance.choice((1, 1, 1, 2, 3)) if wheels is None else wheels
    ends = Block(draw, "one", True), Block(draw, "two", False)
    given: dict[str, str] = {**ends[0].given, **ends[1].given}
    bodies: dict[str, Any] = {}
    surfaces: dict[str, Any] = {}
    connections: dict[str, Any] = {}
    actions: dict[str, Any] = {}
    system = Train()
    resisting = mpf(0)
    for end in ends:
        end.enter(bodies, surfaces, connections)
        system.body(end.mass.x, mpf(1), force=end.pull)
        resisting += end.kinetic
    senses = []
    for number in range(1, count + 1):
        radius, mass = draw.size("m", 0.05, 0.5), draw.size("kg")
        given[f"R{number}"], given[f"M{number}"] = radius.text, mass.text
        body, inertia = wheel(draw, mass, radius, given, number)
        turns = draw.pick("clockwise", "clockwise", "counterclockwise")
        senses.append((1 if turns == "clockwise" else -1) / radius.x)
        bodies[f"wheel{number}"] = {**body, "turns": turns}
        connections[f"axle{number}"] = {"axle": f"wheel{number}"}
        system.body(inertia, 1 / radius.x)
        if wheels is None and draw.often(0.2):
            rub = draw.size("N m", 0.1, 2.0)
            given[f"q{number}"] = rub.text
            connections[f"axle{number}"]["friction_torque"] = f"q{number}"
            resisting += rub.x / radius.x
        if wheels is None and draw.often(0.2):
            couple = draw.size("N m", 0.1, 9.0)
            given[f"C{number}"] = couple.text
            sense = draw.pick("clockwise", "counterclockwise")
            actions[f"motor{number}"] = {"couple": f"C{number}", "on": f"wheel{number}", "direction": sense}
            system.push((1 if sense == "clockwise" else -1) * couple.x, 1 / radius.x)
    connections["cord"] = {"string": ["one", *(f"wheel{k}" for k in range(1, count + 1)), "two"]}
    pace = system.accelerations(resisting)[0]
    used = {
        name: text
        for name, text in given.items()
        if name[0] != "M" or any(name in body.values() for body in bodies.values())
    }
    case = Case(
        scene(
            "Blocks and wheels", given=used, surfaces=surfaces, bodies=bodies, connections=connections, actions=actions
        )
    )
    case.ask("a", "one.acceleration", ends[0].sign * pace)
    case.ask("alpha", f"wheel{count}.angular_acceleration", senses[-1] * pace)
    if not any(end.rough for end in ends) and not any("friction_torque" in item for item in connections.values()):
        case.ask("T", "cord.one.tension", ends[0].mass.x * pace - ends[0].pull)
        case.ask("S", "cord.two.tension", ends[1].pull - ends[1].mass.x * pace)
    if pace and wheels is None and draw.often(0.4):
        moved(case, draw, ends[0], pace)
    return case


def moved(case: Case, draw: Draw, end: Block, pace: mpf) -> None:
    """A state some way on: how fast, and after what time."""
    way = draw.size("m", 0.5, 5.0)
    case.scene["given"]["d"] = way.text
    sign = end.sign * (1 if pace > 0 else -1)
    case.scene["states"] = {"start": "at rest", "end": {f"{end.name}.displacement": "d" if sign > 0 else "-d"}}
    find, case.scene["find"] = case.scene["find"], {}
    case.scene["find"] = {name: f"{phrase} at start" for name, phrase in find.items()}
    case.ask("v", f"{end.name}.velocity at end", sign * (2 * abs(pace) * way.x) ** mpf("0.5"))
    case.ask("t", "time from start to end", (2 * way.x / abs(pace)) ** mpf("0.5"))


def stepped_drum(draw: Draw) -> Case:
    """A drum of two radii with a block on each."""
    m, n, big, small, inertia = (
        draw.size("kg"),
        draw.size("kg"),
        draw.size("m", 0.1, 0.9),
        draw.size("m", 0.1, 0.9),
        draw.size("kg m^2"),
    )
    first, second, turns = draw.pick("up", "down"), draw.pick("up", "down"), draw.pick("clockwise", "counterclockwise")
    bodies = {
        "drum": {"inertia": "I", "radii": {"big": "R", "small": "r"}, "turns": turns},
        "one": {"mass": "m", "moves": first},
        "two": {"mass": "n", "moves": second},
    }
    connections = {
        "axle": {"axle": "drum"},
        "cord": {"string": ["one", "drum.small"]},
        "rope": {"string": ["drum.big", "two"]},
    }
    system = Train()  # the turn of the drum, clockwise
    system.body(inertia.x, mpf(1))
    system.body(m.x, small.x, force=-m.x * G)
    system.body(n.x, big.x, force=n.x * G)
    turn = system.accelerations()[0]
    given = letters(m=m, n=n, R=big, r=small, I=inertia)
    case = Case(scene("Stepped drum", given=given, bodies=bodies, connections=connections))
    case.ask("a", "one.acceleration", turn * small.x * (1 if first == "up" else -1))
    case.ask("b", "two.acceleration", turn * big.x * (1 if second == "down" else -1))
    case.ask("alpha", "drum.angular_acceleration", turn * (1 if turns == "clockwise" else -1))
    case.ask("T", "cord.tension", m.x * (G + turn * small.x))
    case.ask("S", "rope.tension", n.x * (G - turn * big.x))
    return case


def moving_pulley(draw: Draw) -> Case:
    """A load under a moving pulley, a weight beyond a fixed one."""
    K, m, M, n, r, R = (
        draw.size("kg"),
        draw.size("kg"),
        draw.size("kg"),
        draw.size("kg"),
        draw.size("m", 0.05, 0.5),
        draw.size("m", 0.05, 0.5),
    )
    bodies = {
        "moving": {"shape": "disc", "mass": "K", "radius": "r", "moves": "up"},
        "load": {"mass": "m", "moves": "up"},
        "fixed": {"shape": "ring", "mass": "M", "radius": "R", "turns": "clockwise"},
        "weight": {"mass": "n", "moves": "down"},
    }
    connections = {
        "axle": {"axle": "fixed"},
        "hook": {"string": ["moving.center", "load"]},
        "cord": {"string": ["ceiling", "moving", "fixed", "weight"], "under": "moving"},
    }
    system = Train()  # the load up
    system.body(K.x + m.x, mpf(1), force=-(K.x + m.x) * G)
    system.body(K.x / 2, mpf(1))
    system.body(M.x + n.x, mpf(2))
    system.push(n.x * G, mpf(2))
    pace = system.accelerations()[0]
    case = Case(
        scene("Moving pulley", given=letters(K=K, m=m, M=M, n=n, r=r, R=R), bodies=bodies, connections=connections)
    )
    case.ask("a", "weight.acceleration", 2 * pace)
    case.ask("b", "load.acceleration", pace)
    case.ask("T", "hook.tension", m.x * (G + pace))
    case.ask("S", "cord.weight.tension", n.x * (G - 2 * pace))
    return case


def double_atwood(draw: Draw) -> Case:
    """A pulley that hangs from a pulley, with blocks on both."""
    m, n, p, K, r, M, R = (draw.size(unit) for unit in ("kg", "kg", "kg", "kg", "m", "kg", "m"))
    bodies = {
        "first": {"mass": "m", "moves": "down"},
        "second": {"mass": "n", "moves": "down"},
        "third": {"mass": "p", "moves": "down"},
        "top": {"shape": "disc", "mass": "M", "radius": "R", "turns": "clockwise"},
        "low": {"shape": "disc", "mass": "K", "radius": "r", "turns": "clockwise", "moves": "down"},
    }
    connections = {
        "axle": {"axle": "top"},
        "upper": {"string": ["third", "top", "low.center"]},
        "under": {"string": ["first", "low", "second"]},
    }
    system = Train(2)  # the third block down, the low pulley's turn
    zero, one = mpf(0), mpf(1)
    system.body(p.x, one, zero, force=p.x * G)
    system.body(M.x / 2, one, zero)
    system.body(K.x, -one, zero, force=K.x * G)
    system.body(K.x * r.x**2 / 2, zero, one)
    system.body(m.x, -one, -r.x, force=m.x * G)
    system.body(n.x, -one, r.x, force=n.x * G)
    pace, turn = system.accelerations()
    case = Case(
        scene(
            "Double Atwood machine",
            given=letters(m=m, n=n, p=p, K=K, r=r, M=M, R=R),
            bodies=bodies,
            connections=connections,
        )
    )
    case.ask("a", "third.acceleration", pace)
    case.ask("b", "first.acceleration", -pace - r.x * turn)
    case.ask("c", "second.acceleration", -pace + r.x * turn)
    case.ask("T", "under.first.tension", m.x * (G + pace + r.x * turn))
    return case


def yoyo(draw: Draw) -> Case:
    """A body that unwinds from its thread, on a rim or a hub."""
    M, R, r = draw.size("kg"), draw.size("m", 0.02, 0.5), draw.size("m", 0.01, 0.5)
    given, end, inertia, radius = letters(M=M, R=R), "yoyo", M.x * R.x**2 / 2, R.x
    body: dict[str, Any] = {"shape": "cylinder", "mass": "M", "radius": "R", "moves": "down"}
    if draw.often(0.5):
        own = draw.size("kg m^2", 0.001, 1.0)
        given, end, inertia, radius = letters(M=M, I=own, r=r), "yoyo.hub", own.x, r.x
        body = {"mass": "M", "inertia": "I", "radii": {"hub": "r"}, "moves": "down"}
    pace = M.x * G / (M.x + inertia / radius**2)
    case = Case(
        scene("Yo-yo", given=given, bodies={"yoyo": body}, connections={"thread": {"string": ["ceiling", end]}})
    )
    case.ask("a", "yoyo.acceleration", pace)
    case.ask("T", "thread.tension", M.x * (G - pace))
    return case
