"""Strings over and round pulleys and drums: tensions, and the rate rules of a string that neither stretches nor slips.

How it runs is told by its routing; the two ends of a leg move equally fast along it.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import SLIPPING, TAUT, TENSION, Force, Motion, Requirement, Rule
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import Vector, along_text, opposite
from rotsolve.core.writing import balance, spoken
from rotsolve.elements.connections.routing import Leg, Routing
from rotsolve.elements.shapes import round_part, taken_round
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Fact, Moment, Surroundings
from rotsolve.language.keys import amount, key


def is_post(ref: PointRef, scene: Surroundings) -> bool:
    """Whether a point is a post, round which a rope runs."""
    return ref.owner in scene.surfaces and scene.surfaces[ref.owner].post


def told_along(push: Vector, name: str, instant: Moment) -> str:
    """A pull along the line on which a body travels, in the words of that line: "up the slope"."""
    line = instant.line(instant.host(name))
    if line is None or len(push.parts) != 1:
        return ""
    gap = push.parts[0][1] - line[0]
    if gap.terms or gap.degrees % 180:
        return ""
    return line[1] if gap.degrees % 360 == 0 else opposite(line[1])


def pull_words(push: Vector, arm: Vector, kind: str, instant: Moment) -> tuple[str, str]:
    """How a pull is told: its direction for what travels; for what is held on an axis its turn, else where it pulls to."""
    direction = along_text(push.parts[0][1]) if len(push.parts) == 1 else ""
    if kind == "axis" and arm.parts:
        senses = {1: "turning it counterclockwise", -1: "turning it clockwise"}
        sense = senses.get(instant.configuration.signs.taken(arm.cross(push)) or 0, "")
        return sense, "" if sense else direction
    return direction or "along the string", ""


class String(Connection, frozen=True):
    """A string over, round and under what it touches, named in order from its first end (on the left) to its last."""

    word = "string"
    at_points = True
    about = "a string by what it touches, in order from its first end on the left to its last"
    quantities = ("tension", "force", "work", "power", "impulse", "length")
    instead = (
        "at one moment a string pulls with a force along it: `actions: {pull: {force: T, on: BODY.P, direction: [x, y, z]}}`, with"
        " `T: unknown` under `given` where that is sought"
    )
    words = ("slack", "taut", "slips", "sticks")
    string: tuple[PointRef, ...] = key(
        "points", "what it touches, in order", count=(2, 200), required=True, example="[left, pulley, right]"
    )
    pulls: tuple[tuple[str, str], ...] = key(
        "map of directions",
        "direction in which it pulls a body",
        default=(),
        choices=("left", "right", "up", "down"),
        refers=("body",),
        example="{left: down}",
    )
    over: tuple[str, ...] = key(
        "names",
        "pulleys that it passes over, turning them clockwise (the default)",
        default=(),
        refers=("body",),
        example="[pulley]",
    )
    under: tuple[str, ...] = key(
        "names",
        "pulleys that it passes under, turning them counterclockwise",
        default=(),
        refers=("body",),
        example="[pulley]",
    )
    along: str | None = key(
        "name", "the surface that it runs along", default=None, refers=("surface",), example="floor"
    )
    mass: Formula | None = amount(
        "mass of the string (a heavy rope is a body, `shape: rope`)",
        "mass",
        "m",
        "nonnegative",
        default=None,
        later=True,
    )

    friction: Formula | None = amount(
        "coefficient of friction on the post round which it runs, `string: [load, bollard, crate]`",
        "number",
        "mu",
        "nonnegative",
        default=None,
    )
    wrap: Formula | None = amount(
        "angle through which it touches the post", "angle", "phi", "positive", default=None, example="3/2 rev"
    )

    repeats = True

    def rubs(self) -> bool:
        return self.friction is not None

    def slider(self) -> PointRef:
        return self.string[-1]

    def slip(self, instant: Moment, *, acceleration: bool = False) -> Formula | None:
        """How fast it runs round its post towards its last end."""
        from rotsolve.elements.connections.posts import pace_past

        return pace_past(self.course(instant), acceleration=acceleration)

    def verge(self, instant: Moment) -> tuple[tuple[Formula, Formula, Formula], ...]:
        from rotsolve.elements.connections.posts import verge_round

        return verge_round(self, self.course(instant)) if self.friction is not None else ()

    def check(self, scene: Surroundings) -> None:
        """It leaves a wheel on a tangent of its rim, and pulls what it is tied to one way."""
        if self.friction is not None or any(is_post(ref, scene) for ref in self.string):
            from rotsolve.elements.connections.posts import check_round

            check_round(self, scene)
        ends = (self.string[0].owner, self.string[-1].owner)
        for name, way in self.pulls:
            if name not in ends:
                help = f"say it of {' or '.join(f'`{end}`' for end in ends if end)}"
                message = f"`pulls: {{{name}: {way}}}`: `{self.name}` does not end at `{name}`"
                raise Unsolvable(message, span=self.string[0].span, help=help)
        for ref in self.string:
            if ref.point in ("top", "bottom") and ref.owner in scene.bodies:
                help = f"write `{ref.owner}.rim`, with `under: {ref.owner}` where it passes below"
                raise Unsolvable("a string leaves a wheel where it touches the rim", span=ref.span, help=help)

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.string

    def turned(self) -> tuple[str, ...]:
        return tuple(ref.owner for ref in self.string[1:-1] if not ref.point)

    def hangs(self, body: Body) -> bool:
        """A body at an end of a string hangs from it where nothing else says how it travels, and a wheel under which it passes."""
        ends = (self.string[0], self.string[-1])
        if body.name in self.under:
            return body.name not in {ref.owner for ref in ends}
        return any(ref.owner == body.name and ref.point in (None, "center") for ref in ends)

    def pace(self, configuration: Surroundings, state: str) -> str:
        """Constant while all its legs keep their directions: bodies on lines and wheels turning about their centres."""
        for ref in self.string:
            host = configuration.host(ref.owner, state)
            if host in configuration.bodies and configuration.line(host, state) is None:
                place = ref if round_part(configuration.bodies[ref.owner], ref.point) else PointRef(ref.owner, "center")
                off = not configuration.balanced(host, state) or configuration.swings_round(place, state)
                if configuration.pivot(host, state) is None or off:
                    return "position"
        return "constant"

    def leans(self, configuration: Surroundings, state: str) -> tuple[str, ...]:
        """Not on what it winds on."""
        bodies = configuration.bodies
        ends = (ref for ref in self.string if ref.owner in bodies and not round_part(bodies[ref.owner], ref.point))
        return taken_round(ends, configuration, state)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """A tension for each strand, its pulls on the bodies, and the rule that the strand keeps its length."""
        course = self.course(instant)
        if self.friction is not None:
            from rotsolve.elements.connections.posts import round_post

            yield from round_post(self, course, instant)
            return
        for strand in course.strands():
            tension = self.tension(strand, course)
            yield Requirement(self.name, TAUT, tension, ZERO, "the string stays taut", "the string goes slack")
            for leg in strand:
                yield from self.pulls_of(leg, tension, instant)
        first, *others = course.strands()
        alike = self.over_one_wheel(course)
        yield from self.rules(course.legs if alike else first, instant, alike=alike)
        for strand in others:
            yield from self.rules(strand, instant)
        for part in course.to_rims():
            yield from self.rules(part, instant)

    def course(self, instant: Moment) -> Routing:
        """How it runs at a moment."""
        return Routing(self.name, self.string, dict(self.pulls), self.under, self.along, instant)

    def tension_at(self, name: str, instant: Moment) -> Formula | None:
        """Of the part that leaves a body or support towards the next one named; at the last one, of the part that arrives."""
        index = next((k for k, ref in enumerate(self.string) if ref.owner == name), None)
        if index is None:
            return None
        course = self.course(instant)
        wanted = course.legs[min(index, len(course.legs) - 1)]
        return next(self.tension(strand, course) for strand in course.strands() if wanted in strand)

    def tension(self, strand: tuple[Leg, ...], course: Routing) -> Formula:
        """The tension of a strand, named after the body that it ends at where the string has several."""
        instant = course.instant
        component = "" if len(strand) == len(course.legs) else course.end_of(strand)
        owner = next(ref.owner for ref in self.string if ref.owner in instant.configuration.bodies)
        return instant.ask("tension", self.name, when=instant.span(instant.host(owner)), component=component)

    def pulls_of(self, leg: Leg, tension: Formula, instant: Moment, *, slips: bool = False) -> Iterator[Force]:
        """The tension on the bodies at both ends of a leg; one that slips on what it runs round loses energy there."""
        for ref, arm, push in ((leg.first, leg.arms[0], leg.along), (leg.second, leg.arms[1], -leg.along)):
            if ref.owner in instant.configuration.bodies:
                way, place = told_along(push, ref.owner, instant), ""
                if not way:
                    way, place = pull_words(push, arm, instant.motion(ref.owner).kind, instant)
                name = instant.host(ref.owner)
                role = SLIPPING if slips else TENSION
                yield Force(self.name, role, name, tension, push, arm, "tension", way, place, internal=not slips)

    def over_one_wheel(self, course: Routing) -> bool:
        """Whether a wheel with inertia turns on an axle at rest between two bodies that do not turn: these move alike."""
        strands, instant = course.strands(), course.instant
        if len(strands) != len(course.legs) or len(strands) != 2:
            return False
        before, after = course.legs
        ends = [ref.owner for ref in (before.first, after.second)]
        if any(end not in instant.configuration.bodies or instant.motion(end).turns for end in ends):
            return False
        wheel = instant.motion(before.second.owner)
        feeds = [arm.turned(90).dot(leg.along) for leg, arm in ((before, before.arms[1]), (after, after.arms[0]))]
        return not wheel.velocity.parts and not wheel.acceleration.parts and feeds[0] == feeds[1]

    def rules(self, strand: tuple[Leg, ...], instant: Moment, *, alike: bool = False) -> Iterator[Rule]:
        """Σ over the legs of (rate of the second end − rate of the first end) along the leg = 0; of ends that move `alike` without the
        wheel between."""
        ends = [(leg, *end) for leg in strand for end in ((leg.second, leg.arms[1], 1), (leg.first, leg.arms[0], -1))]
        if alike:
            first, last = strand[0], strand[-1]
            ends = [(first, first.first, first.arms[0], 1), (last, last.second, last.arms[1], -1)]
        ends = [end for end in ends if end[1].owner in instant.configuration.bodies]  # the ground is at rest
        sides = []
        # a rim's centripetal part does not feed the string, which leaves it on a tangent
        for rate in (Motion.velocity_of, Motion.acceleration_of):
            terms = [(rate(instant.motion(ref.owner), arm).dot(leg.along), sign) for leg, ref, arm, sign in ends]
            sides.append(balance([(value, sign) for value, sign in terms if value != ZERO]))
        named = (ref.owner for leg in strand for ref in (leg.first, leg.second))
        bodies = tuple(dict.fromkeys(owner for owner in named if owner in instant.configuration.bodies))
        turning = any(instant.motion(name).turns for name in bodies) and len(strand) == 1
        label = "the string does not slip" if turning else "the string does not stretch"
        label = "both ends of the string move alike" if alike else label
        others = [name for name in bodies if not instant.motion(name).turns] if len(self.string) > 2 else []
        label += f", {spoken(others[0])}" if len(others) == 1 else ""
        linear = self.pace(instant.configuration, instant.state) == "constant"
        yield Rule(self.name, label, bodies, sides[0], sides[1], linear)
