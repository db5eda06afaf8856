"""Elements: scenes put together at random from the tables of the language, mostly in ways that make sense."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rotsolve.core.quantity import ACTION, BODY, EVENT, LINK, POINT, QUANTITIES, SYSTEM, QuantityKind
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS, SHAPES
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.kinds import Kinds
from trials.case import Case
from trials.draw import Draw
from trials.scene import Scene, changed, read

UNITS = {
    "number": "", "angle": "deg", "length": "m", "mass": "kg", "time": "s", "velocity": "m/s", "acceleration": "m/s^2",
    "angular velocity": "rad/s", "angular acceleration": "rad/s^2", "force": "N", "torque": "N m", "stiffness": "N/m",
    "moment of inertia": "kg m^2", "torsional stiffness": "N m/rad", "power": "W", "impulse": "N s",
}  # fmt: skip
ROLES = {  # what a connection usually joins
    "string": (
        ("block", "wheel", "block"),
        ("wheel", "block"),
        ("ceiling", "wheel"),
        ("block", "wheel", "wheel", "block"),
    ),
    "contact": (("block", "surface"), ("wheel", "surface"), ("rod", "surface"), ("block", "block")),
    "rolls": (("wheel", "surface"), ("wheel", "block")),
    "spring": (("ground", "block"), ("ceiling", "block"), ("block", "block")),
    "torsion": (("wheel",), ("wheel", "wheel")),
    "weld": (("rod", "block"), ("rod", "rod"), ("rod", "wheel")),
    "drapes": (("rope", "wheel"), ("rope", "ground")),
    "rides": (("block", "wheel"),),
    "unrolls": (("wheel", "surface"),),
}
SHAPED = {"wheel": ("disc", "ring", "cylinder", "sphere", "spherical shell"), "rod": ("rod",), "rope": ("rope",)}
POINTS = {"rod": ("start", "end", "center", "at(0.25 m)"), "wheel": ("rim", "center", "top"), "block": (), "rope": ()}
USUAL = (
    "acceleration",
    "velocity",
    "angular_acceleration",
    "angular_velocity",
    "kinetic_energy",
    "angle",
    "rotation",
    "displacement",
    "inertia",
    "time",
)
SEEDS = ("problems", "tests/engine/scenes")


class Builder:
    """One random scene as it grows."""

    def __init__(self, draw: Draw) -> None:
        self.draw = draw
        self.given: dict[str, str] = {}
        self.roles: dict[str, str] = {}
        self.links: dict[str, str] = {}
        self.scene: Scene = {"title": "Put together at random", "given": self.given}

    def value(self, dimension: str) -> str:
        """A quantity: a letter that is given, or a number in place."""
        known = self.draw.size(UNITS.get(dimension, ""), 0.2, 9.0)
        if dimension == "angle":
            known = self.draw.angle()
        if dimension == "number":
            known = self.draw.share()
        if self.draw.often(0.6):
            name = f"q{len(self.given) + 1}"
            self.given[name] = known.text
            return name
        return known.text

    def bodies(self) -> None:
        made: dict[str, Any] = {}
        for number in range(1, self.draw.chance.choice((1, 1, 2, 2, 3)) + 1):
            role = self.draw.pick("block", "wheel", "wheel", "rod", "rod", "block", "other")
            name = f"{role}{number}"
            body: dict[str, Any] = {}
            if role == "other":
                shape = self.draw.chance.choice(SHAPES)
                body["shape"] = shape.word
                for word, declared in keys_of(shape):
                    if declared.kind in ("quantity", "quantities") and (declared.required or self.draw.often(0.7)):
                        body[word] = self.key(declared)
            elif role in SHAPED:
                body["shape"] = self.draw.pick(*SHAPED[role])
                body["length" if role == "rod" else "radius"] = self.value("length")
            body["mass"] = self.value("mass")
            if role == "block" or self.draw.often(0.2):
                body["moves"] = self.draw.pick("up", "down", "left", "right")
            if role == "wheel":
                body["turns"] = self.draw.pick("clockwise", "counterclockwise")
            self.roles[name] = role
            made[name] = body
        self.scene["bodies"] = made

    def owners(self, role: str) -> list[str]:
        return [name for name, own in self.roles.items() if own == role] or list(self.roles)

    def several(self, roles: tuple[str, ...]) -> list[str]:
        """Points of different bodies, mostly; the ground where no body is left."""
        found: list[str] = []
        for role in roles:
            tries = [self.point(role) for _ in range(4)]
            taken = {point.partition(".")[0] for point in found}
            free = [point for point in tries if point.partition(".")[0] not in taken]
            found.append(free[0] if free else tries[0] if self.draw.often(0.1) else "ground")
        return found

    def point(self, role: str = "") -> str:
        """A body, or a point of it."""
        if role == "surface":
            surfaces = self.scene.setdefault("surfaces", {})
            name = f"plane{len(surfaces) + 1}"
            surfaces[name] = self.draw.chance.choice(
                ("level", {"slope": self.value("angle"), "down": self.draw.pick("left", "right")})
            )
            return name
        if role in ("ground", "ceiling"):
            return role
        name = self.draw.chance.choice(self.owners(role))
        points = POINTS.get(self.roles[name], ("center", "cm"))
        return (
            f"{name}.{self.draw.pick(*points)}"
            if points and self.draw.often(0.6 if self.roles[name] == "rod" else 0.2)
            else name
        )

    def key(self, declared: Key) -> Any:
        """A value of the kind that a key takes."""
        kind = declared.kind
        if kind == "quantity":
            return self.value(declared.dimension or "number")
        if kind == "quantities":
            return [self.value(declared.dimension or "number") for _ in range((declared.count or (2, 2))[0])]
        if kind in ("choice", "direction"):
            return self.draw.pick(*declared.choices) if declared.choices else "right"
        if kind == "flag":
            return self.draw.pick("true", "false")
        if kind == "friction":
            return self.draw.chance.choice(("none", "any", self.value("number")))
        if kind == "point":
            return self.point()
        if kind == "points":
            low, high = declared.count or (1, 2)
            return self.several(("",) * self.draw.chance.randint(low, min(high, low + 1)))
        return self.draw.chance.choice([*self.links, *self.roles])

    def connections(self) -> None:
        made: dict[str, Any] = {}
        for name, role in self.roles.items():
            if role == "wheel" and self.draw.often(0.7):
                made[f"axle_{name}"] = {"axle": name}
            elif role in ("rod", "other") and self.draw.often(0.8):
                made[f"pin_{name}"] = {
                    "hinge": f"{name}.{self.draw.pick('start', 'center', 'start') if role == 'rod' else 'center'}"
                }
            elif role == "block" and self.draw.often(0.5):
                made[f"base_{name}"] = {
                    "contact": [name, self.point("surface")],
                    "friction": self.draw.chance.choice(("none", "any", self.value("number"))),
                }
        for number in range(self.draw.chance.choice((0, 1, 1, 2))):
            element = self.draw.chance.choice([item for item in CONNECTIONS if not item.later])
            name = f"link{number + 1}"
            made[name] = self.filled(element, ROLES.get(element.word, ()))
        words = {item.word for item in CONNECTIONS}
        self.links = {name: next(word for word in item if word in words) for name, item in made.items()}
        self.scene["connections"] = made

    def filled(self, element: Any, roles: tuple[tuple[str, ...], ...] = ()) -> dict[str, Any]:
        """An element with its keys, the points by the roles that they usually have."""
        found: dict[str, Any] = {}
        for word, declared in keys_of(element):
            if word == element.word and roles and self.draw.often(0.85):
                found[word] = self.several(self.draw.chance.choice(roles))
            elif word == "on":
                found[word] = self.point("wheel" if element.word in ("press", "couple", "power") else "")
            elif declared.required or (word not in ("from", "to", "along") and self.draw.often(0.15)):
                found[word] = self.key(declared)
        return found if element.word in found else {element.word: None, **found}

    def actions(self) -> None:
        usual = [item for item in ACTIONS if item.word != "press" or "wheel" in self.roles.values()]
        made = {
            f"act{number + 1}": self.filled(self.draw.chance.choice(usual))
            for number in range(self.draw.chance.choice((0, 0, 1, 1, 2)))
        }
        if made:
            self.scene["actions"] = made

    def states(self) -> None:
        count = self.draw.chance.choice((0, 1, 2, 2, 3))
        made: dict[str, Any] = {}
        for number in range(1, count + 1):
            lines: dict[str, str] = {}
            if number == 1 and self.draw.often(0.6):
                lines["at rest"] = "all"
            for name, role in self.roles.items():
                if role == "rod" and (number == 1 or self.draw.often(0.5)):
                    lines[f"{name}.angle"] = self.draw.pick(
                        "0 deg", "-90 deg", "30 deg", "-30 deg", self.value("angle")
                    )
                elif number > 1 and self.draw.often(0.3):
                    word, unit = self.draw.chance.choice(
                        (("displacement", "m"), ("velocity", "m/s"))
                        if role == "block"
                        else (("rotation", "rad"), ("angular_velocity", "rad/s"))
                    )
                    lines[f"{name}.{word}"] = self.draw.size(unit).text
                elif number == 1 and "at rest" not in lines and self.draw.often(0.5):
                    lines[f"{name}.{'velocity' if role == 'block' else 'angular_velocity'}"] = self.draw.size(
                        "m/s" if role == "block" else "rad/s"
                    ).text
            if number > 1 and not lines:
                lines["time"] = self.draw.size("s").text
            made[f"state{number}"] = lines
        if made:
            self.scene["states"] = made
        if count > 1 and self.draw.often(0.15):
            event = self.filled(self.draw.chance.choice(EVENTS))
            place = self.draw.chance.randint(1, count - 1)
            self.scene["events"] = {"event1": {**event, "from": f"state{place}", "to": f"state{place + 1}"}}
            made[f"state{place + 1}"] = {} if self.draw.often(0.8) else made[f"state{place + 1}"]

    def questions(self) -> None:
        self.scene["find"] = {
            f"x{number}": self.question() for number in range(1, self.draw.chance.choice((1, 2, 3)) + 1)
        }

    def question(self) -> str:
        """A quantity of something that has it, with a clause."""
        choice, asked = self.asked()
        states = list(self.scene.get("states", {}))
        at = f" at {self.draw.pick(*states)}" if states else ""
        over = f" from {states[0]} to {states[-1]}" if len(states) > 1 and self.draw.often(0.4) else at
        part = f".{self.draw.pick(*asked.components)}" if asked.components and self.draw.often(0.3) else ""
        size = self.draw.pick("", "", "", "size of ", "change of ", "lost ")
        return f"{size}{choice}{'.' if choice else ''}{asked.word}{part}{over}"

    def asked(self) -> tuple[str, QuantityKind]:
        """Something in the scene, and a quantity that it has; now and then one that it has not."""
        things: dict[str, list[str]] = {
            BODY: list(self.roles),
            POINT: [self.point() for _ in range(2)],
            LINK: list(self.links),
            ACTION: list(self.scene.get("actions", {})),
            EVENT: list(self.scene.get("events", {})),
            SYSTEM: [""],
        }
        owner = self.draw.chance.choice(
            [kind for kind in (BODY, BODY, BODY, POINT, LINK, LINK, ACTION, EVENT, SYSTEM) if things[kind]]
        )
        choice = self.draw.chance.choice(things[owner])
        known = [kind for kind in QUANTITIES.values() if owner in kind.owners and not kind.later]
        usual = [kind for kind in known if kind.word in USUAL]
        words = self.words(owner, choice)
        fitting = [kind for kind in known if kind.word in words] if words else usual if self.draw.often(0.7) else known
        return choice, self.draw.chance.choice(known if self.draw.often(0.1) else fitting or known)

    def words(self, owner: str, name: str) -> tuple[str, ...]:
        """The quantities of a connection, an action or an event."""
        tables: dict[str, tuple[str, Kinds[Any]]] = {
            LINK: ("connections", CONNECTIONS),
            ACTION: ("actions", ACTIONS),
            EVENT: ("events", EVENTS),
        }
        if owner not in tables:
            return ()
        section, table = tables[owner]
        entry = self.scene.get(section, {}).get(name, {})
        return next((item.quantities for item in table if item.word in entry), ())


def built(draw: Draw) -> Case:
    """A scene put together from the tables."""
    builder = Builder(draw)
    for part in (builder.bodies, builder.connections, builder.actions, builder.states, builder.questions):
        part()
    return Case(builder.scene)


def files() -> list[Path]:
    """The scenes that come with the project."""
    root = Path(__file__).resolve().parents[2]
    return sorted(path for folder in SEEDS for path in (root / folder).rglob("*.yaml"))


def altered(draw: Draw) -> Case:
    """A scene of the project with other numbers, and perhaps a question more."""
    from trials.alike import QUANTITY

    scene = read(draw.chance.choice(files()).read_text(encoding="utf-8"))

    def other(text: str) -> str:
        if not draw.often(0.5):
            return text
        return QUANTITY.sub(lambda found: f"{new(found['number'])}{found['pi'] or ''} {found['unit']}", text)

    def new(number: str) -> str:
        figure = draw.size("", 0.5, 5.0).text.strip()
        if draw.style == "plain" or "/" in number:
            return figure if draw.often(0.5) else number
        return f"{figure}e{draw.chance.randint(-9, 9)}" if "e" not in figure else figure

    result: Scene = {
        key: changed(part, other) if key in ("given", "bodies", "states") else part for key, part in scene.items()
    }
    if draw.often(0.3) and "bodies" in result:
        builder = Builder(draw)
        builder.scene = result
        builder.roles = dict.fromkeys(result["bodies"], "block")
        builder.links = {}
        result = {**result, "find": {**result["find"], "extra": builder.question()}}
    return Case(result)
