"""Complete: a problem made ready for the laws: letters for what a scene leaves out. Missing is never zero; what can not be is refused."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, total
from rotsolve.algebra.units.dimension import DIMENSIONS
from rotsolve.core.drive import Drive
from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import TIME, has_quantities, paths_in
from rotsolve.elements.shapes import Particle, Shape, shape_of
from rotsolve.language.elements import Action, Connection
from rotsolve.language.keys import varying_values
from rotsolve.language.problem import Body, Given, Part, PointRef, Problem
from rotsolve.motion.admissible import check, check_rigid
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.flights import with_flights
from rotsolve.motion.instant import Instant
from rotsolve.motion.mounts import on_mounts
from rotsolve.motion.named_alone import with_all_points
from rotsolve.motion.owndata import versions
from rotsolve.motion.positive import positive_letters
from rotsolve.motion.rigid import between_ends, centre_of_mass, locate, materials, pieces, tidy


def check_values(configuration: Configuration) -> None:
    """A value that varies speaks of a body that moves as it is said to, and that is tied to the body on which it acts."""
    for state in configuration.timeline.states:
        if state.conditions:
            configuration.present(state.name)  # refuses own data of bodies that can not be so
        check_rigid(configuration, state.name)
        items = configuration.connections(state.name)
        for host in {configuration.host(owner, state.name): None for item in items for owner, *_ in item.prescribes()}:
            for drive in configuration.drives(host, state.name):  # refuses what can not be driven so
                check_bounded(drive, configuration)
        instant = Instant(configuration, Registry(), state.name)
        for item in configuration.acting(state.name):
            for value in varying_values(item):
                for path in paths_in(value):
                    check_path(item, path, instant)


def check_bounded(drive: Drive, configuration: Configuration) -> None:
    """What is given has an acceleration when the clock starts, not one without bounds as that of √time."""
    first = configuration.timeline.states[0]
    try:
        for function in drive.rates().values():
            if TIME in function.symbols():
                simplify(function.substitute({TIME: ZERO if first.time_told is None else first.time_told}))
    except ZeroDivisionError:
        message = f"what is given of `{drive.body}` changes beyond all bounds when the clock starts"
        help = "let the clock start later: `time: 1 s` in the first state"
        raise Unsolvable(message, span=configuration.bodies[drive.body].span, help=help) from None


def check_path(item: Connection | Action, path: tuple[str, str, str], instant: Instant) -> None:
    """The body that a path of an element's value speaks of moves so, and with the body on which the element acts."""
    name, owner, word = path
    configuration = instant.configuration
    held = [ref for ref in item.touches() if ref.owner in configuration.bodies]
    motion = instant.motion(owner)
    if motion.kind != "line" if word in ("displacement", "velocity") else not motion.turns:
        how = "travel along a line" if word in ("displacement", "velocity") else "turn"
        raise Unsolvable(f"there is no `{name}`: `{owner}` does not {how}", span=held[-1].span)
    if instant.host(owner) not in configuration.component(held[-1].owner, instant.state):
        message = f"`{item.name}` varies with a body that is not tied to `{held[-1].owner}`: not solved yet"
        raise Unsolvable(message, span=held[-1].span)


class MadeLetters:
    """Makes letters that are not taken, and remembers them as givens without a value."""

    def __init__(self, problem: Problem) -> None:
        self.taken = {given.name for given in problem.givens}
        self.made: list[Given] = []
        self.positive = positive_letters(problem.givens)

    def make(self, letter: str, owner: str, dimension: str) -> Formula:
        name = f"{letter}_{owner}"
        while name in self.taken:
            name += "_"
        self.taken.add(name)
        self.made.append(Given(name, None, DIMENSIONS[dimension], automatic=True))
        return Symbol(name)


def completed(problem: Problem) -> Problem:
    """The problem with automatic letters for what is left out; a fault only if one survives in an answer."""
    problem = with_flights(on_mounts(with_all_points(problem)))
    bodies_named = {body.name for body in problem.bodies}
    surfaces = {surface.name: surface for surface in problem.surfaces}
    problem = replace(problem, events=tuple(item.completed(bodies_named, surfaces) for item in problem.events))
    check(problem)
    letters, held = MadeLetters(problem), {ref.owner for item in problem.connections for ref in item.fixed_points()}
    wheels = {name for item in problem.connections for name in item.turned()}
    riders = {ride.rider.owner for item in problem.connections if (ride := item.ride()) is not None}
    bodies = []
    for body in problem.bodies:
        bodies.append(
            _rider(body, letters) if body.name in riders else complete_body(body, letters, body.name in wheels)
        )
    if problem.states:
        versions(bodies, problem.states)  # refuses what can't differ between states
    connections = (*[item.completed(letters, held) for item in problem.connections], *_guides(bodies))
    return replace(problem, bodies=tuple(bodies), connections=connections, givens=(*problem.givens, *letters.made))


def _guides(bodies: list[Body]) -> list[Connection]:
    """What drives the bodies whose motions are prescribed."""
    driven = [body for body in bodies if body.moved]
    if not driven:
        return []
    from rotsolve.elements.connections.drives import guide

    return [guide(body) for body in driven]


def complete_body(body: Body, letters: MadeLetters, wheel: bool = False) -> Body:
    shape = _shape(body.shape, body, letters) if body.shape is not None else None
    mass = body.mass
    parts = body.parts and tuple([_part(part, letters) for part in body.parts])
    holes = body.holes and tuple([_hole(hole, shape, letters) for hole in body.holes])
    if shape is not None:
        shape = shape.following(letters.positive)
    if body.tensor is not None or (
        body.axis and body.inertia is not None
    ):  # in space the point stays that of the scene
        return body if mass is not None else replace(body, mass=letters.make("m", body.name, "mass"))
    if body.density is not None and shape is not None and has_quantities(body.density):
        from rotsolve.elements.shapes.integrated import Graded

        shape = Graded(letters.positive, shape, body.density)
        mass = body.mass or shape.measure()
    elif body.density is not None and shape is not None and mass is None:
        whole, *cut = materials(replace(body, shape=shape, holes=holes)) if holes else (ONE,)
        left = (whole - total(cut)) / whole
        mass = body.density * (shape.content() if not holes else simplify(shape.content() * left))
    elif mass is None and not body.parts:
        mass = letters.make("m", body.name, "mass")
    radius, inertia = body.radius, body.inertia
    if shape is None and not body.parts and (wheel or body.turns is not None):
        if radius is None and not body.radii:
            radius = letters.make("R", body.name, "length")
        if inertia is None and body.gyration is None and mass != ZERO:
            inertia = letters.make("I", body.name, "moment of inertia")
    same = mass is body.mass and shape is body.shape and radius is body.radius and inertia is body.inertia
    if not same or parts or holes:
        body = replace(body, shape=shape, mass=mass, parts=parts, holes=holes, radius=radius, inertia=inertia)
    return _central(body)


def _rider(body: Body, letters: MadeLetters) -> Body:
    """A body that rides on another is a particle at its `radius` from the axis."""
    own = shape_of(body).centroid()[0]
    radius = (own if own != ZERO else body.radius) or letters.make("r", body.name, "length")
    return complete_body(replace(body, shape=Particle(radius), radius=None), letters, False)


def _central(body: Body) -> Body:
    """The body with its moment of inertia about the centre of mass, where the scene gives it about another point."""
    if body.inertia is None or body.inertia_about is None or body.mass is None:
        return body
    arm = locate(body, PointRef(body.name, body.inertia_about)) - centre_of_mass(pieces(body))
    distance = tidy(arm)
    return replace(body, inertia=simplify(body.inertia - body.mass * distance.dot(distance)))


def _part(part: Part, letters: MadeLetters) -> Part:
    part = _spanned(part, letters)
    return replace(part, body=complete_body(part.body, letters, False))


def _hole(hole: Part, shape: Shape | None, letters: MadeLetters) -> Part:
    from rotsolve.elements.shapes.material import bored

    own = hole.body.shape
    if own is not None:  # how deep it is nobody has to say
        hole = replace(hole, body=replace(hole.body, shape=_shape(own, hole.body, letters, ("radius",))))
    return _spanned(bored(hole, shape), letters)


def _spanned(part: Part, letters: MadeLetters) -> Part:
    """A rod as long as its ends are apart, where nobody says otherwise."""
    shape = part.body.shape
    if shape is None or not shape.slender or shape.reach() is not None or part.start is None or part.end is None:
        return part
    size: dict[str, Any] = {"length": between_ends(part.start, part.end, letters.positive)}
    return replace(part, body=replace(part.body, shape=replace(shape, **size)))


def _shape(shape: Shape, body: Body, letters: MadeLetters, words: Collection[str] = ("radius", "length")) -> Shape:
    changes: dict[str, Any] = {}
    for name in (name for name in shape.left_out() if name in words):
        declared = shape.declared[name]
        changes[name] = letters.make(declared.letter or name[0], body.name, declared.dimension or "length")
    return replace(shape, **changes) if changes else shape


def configured(problem: Problem) -> Configuration:
    """The problem with letters for what it leaves out; refused where a value in it can not be."""
    try:
        configuration = Configuration(completed(problem))
        check_values(configuration)
    except Unsolvable as error:
        fault = error.fault
        raise Unsolvable(
            fault.message, span=fault.span, help=fault.help, lines=problem.lines, file=problem.file
        ) from None
    faults = []
    for body in configuration.problem.bodies:
        shifted = body.inertia if body.inertia_about is not None else None
        if shifted is not None and configuration.signs.by_numbers(shifted) == -1:
            message = f"the inertia of `{body.name}` about `{body.inertia_about}` is smaller than m d², its mass at its centre of mass"
            faults.append(Fault(message, body.span, "", "limits"))
    if faults:
        raise SceneError(faults, problem.lines, problem.file)
    return configuration
