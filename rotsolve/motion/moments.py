"""Moments of inertia of what turns: about its pivot, else its centre of mass, each with its letter and what defines it."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Power, Product, Quotient, Sum, Symbol, sqrt, total
from rotsolve.core.drive import Drive
from rotsolve.core.facts import Inertia
from rotsolve.core.faults import Unsolvable
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.symbols import TIME
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body
from rotsolve.motion.positive import positive_letters
from rotsolve.motion.rigid import Frame, RigidPiece, mass_of, moment_about, tidy

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration


def moment_of_inertia(body: Body, configuration: Configuration, state: str, registry: Registry) -> Inertia:
    """The letter for the moment of inertia about the reference, with its formula; a given one is its own letter."""
    own, carried = configuration.frame(body.name, state), configuration.carried(body.name, state)
    formula, remark = moment_about(*about_its_turn(body.name, configuration, state))
    if formula == ZERO:
        return Inertia(ZERO, ZERO, "")
    letter = inertia_letter(body, configuration, state)
    label = inertia_label(body, configuration, state, own, carried[1:])
    return Inertia(registry.ask(letter) if isinstance(letter, SceneQuantity) else letter, formula, label, remark)


def by_inertia(drive: Drive, configuration: Configuration, state: str) -> Drive:
    """The rate that is given by a momentum or an energy as a function of time: ω = L/I, ω = √(2 K/I), v = p/m."""
    body, word, told = configuration.body(drive.body, state), drive.word, drive.function
    if configuration.changing(drive.body, state):
        message = f"the {spoken(word)} of `{drive.body}` is given, and its own data change: that is not solved yet"
        raise Unsolvable(message, span=body.span)
    if word == "momentum":
        return replace(drive, word="velocity", function=told / mass_of(body), told=(word, told))
    letter = inertia_letter(body, configuration, state)
    inertia = letter.symbol if isinstance(letter, SceneQuantity) else letter
    if is_zero(moment_about(*about_its_turn(drive.body, configuration, state))[0]):
        message = f"`{drive.body}`, of which the {spoken(word)} is given, has no moment of inertia"
        raise Unsolvable(message, span=body.span, help="give it a mass, or give its `angular_velocity`")
    rate = told / inertia if word == "angular_momentum" else speed_by_energy(told, inertia, drive.body, configuration)
    return replace(drive, word="angular_velocity", function=rate, told=(word, told))


def speed_by_energy(energy: Formula, inertia: Formula, name: str, configuration: Configuration) -> Formula:
    """√(2 K/I) as a function of time; an energy that may come to nothing on the way does not tell which way it turns after that."""
    positive = {TIME, *positive_letters(configuration.problem.givens)}
    if not surely_positive(energy, positive):
        message = f"the kinetic energy of `{name}` may be nothing on the way: which way it turns then is not told"
        raise Unsolvable(message, span=configuration.bodies[name].span, help="give its `angular_velocity`")
    return simplify(sqrt(2 * energy / inertia), positive=frozenset((*positive, *inertia.symbols())))


def surely_positive(formula: Formula, letters: Collection[str]) -> bool:
    """Whether a formula of positive letters is positive by its form: a sum, product, quotient or power of such."""
    if isinstance(formula, Number):
        return formula.value > 0
    if isinstance(formula, Symbol):
        return formula.name in letters
    if isinstance(formula, Power):
        return surely_positive(formula.base, letters)
    if isinstance(formula, Call) and formula.function == "exp":
        return True
    return isinstance(formula, (Sum, Product, Quotient)) and all(
        surely_positive(child, letters) for child in formula.children()
    )


def centre_of_turn(name: str, configuration: Configuration, state: str) -> Vector:
    """The reference of what a pivot holds, else the centre of mass."""
    own = configuration.frame(name, state)
    held = configuration.pivot(name, state) is not None
    return own.reference if held or not own.cm.parts else own.reference + own.cm


def about_its_turn(
    name: str, configuration: Configuration, state: str
) -> tuple[tuple[RigidPiece, ...], Vector, tuple[str, ...]]:
    """What a moment of inertia is made of: the pieces, the point about which they turn, the order of the letters."""
    return configuration.frame(name, state).pieces, centre_of_turn(name, configuration, state), configuration.order


def inertia_letter(body: Body, configuration: Configuration, state: str) -> SceneQuantity | Formula:
    """What stands for the moment of inertia in the laws: as the scene gives it for just this axis, else a letter of its own."""
    own, carried = configuration.frame(body.name, state), configuration.carried(body.name, state)
    given = given_inertia(body, own, len(carried) > 1)
    given = given or given_together(carried, centre_of_turn(body.name, configuration, state), own, configuration, state)
    if given is not None:
        return given
    kind, since = QUANTITIES["inertia"], configuration.since(body.name, state)
    changes = any(configuration.since(body.name, other) for other in configuration.timeline.order)
    name = f"{kind.letter}_total" if len(carried) > 1 and not changes else kind.letter
    when = since or (configuration.timeline.states[0].name if changes else "")
    version = " ".join(part for part in (when, point_of_time(body.name, configuration, state)) if part)
    return SceneQuantity("inertia", "+".join(carried), "", version, name, kind.dimension)


def point_of_time(name: str, configuration: Configuration, state: str) -> str:
    """The point about which a body turns at this state, where it turns about another one, or freely, at other states."""
    pivots = {configuration.pivot(name, other.name) for other in configuration.timeline.states}
    pivot = configuration.pivot(name, state)
    return pivot.point or "center" if pivot is not None and len(pivots) > 1 else ""


def given_inertia(body: Body, own: Frame, joined: bool) -> Formula | None:
    """The moment of inertia where the scene gives it for just this axis, so that nothing is left to define."""
    simple = body.inertia is not None and not own.cm.parts and not joined and not body.parts and not body.holes
    return body.inertia if simple else None


def given_together(
    carried: tuple[str, ...], point: Vector, own: Frame, configuration: Configuration, state: str
) -> Formula | None:
    """I₁ + I₂ of bodies that turn as one about their common axis, where the scene gives each of them."""
    given = [configuration.body(name, state).inertia for name in carried]
    on_axis = all(not tidy(piece.at - point).parts for piece in own.pieces)
    if len(given) < 2 or not on_axis or len(own.pieces) != len(given):
        return None
    return total([inertia for inertia in given if inertia is not None]) if None not in given else None


def inertia_label(body: Body, configuration: Configuration, state: str, own: Frame, members: tuple[str, ...]) -> str:
    """Words for a moment of inertia, such as "rod about its end"."""
    shape = shape_of(body)
    noun = shape.noun or shape.word
    if members or body.parts or shape.pointlike:
        noun = spoken(body.name)
    if members:
        noun += " with " + " and ".join(spoken(name) for name in members)
    pivot = configuration.pivot(body.name, state)
    if any(configuration.ride(name, state) for name in members):
        return f"moment of inertia, {noun}"
    if not own.cm.parts:
        return f"moment of inertia, {noun}" + (" about its centre" if shape.slender else "")
    if pivot is None:
        return f"moment of inertia, {noun} about the centre of mass"
    if shape.slender and pivot.point in ("start", "end") and not members:
        return f"moment of inertia, {noun} about its end"
    return f"moment of inertia, {noun} about the {'axis' if shape.pointlike and not body.parts else 'pivot'}"
