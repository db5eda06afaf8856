"""Questions about how the mass of a body is spread: moments of inertia, radius of gyration, centre of mass, angular momentum in space."""

from __future__ import annotations

import re
from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, add, multiply, negate, total
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.equation import Equation
from rotsolve.core.facts import Inertia
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector, heading
from rotsolve.core.vectors.tensor import AXES, Place
from rotsolve.core.writing import flat, is_negative
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.laws import inertia
from rotsolve.laws.centre_of_mass import Told, Unknown, arm_of, centre
from rotsolve.laws.integration import NotSliced, mass, mass_beside_density
from rotsolve.motion.positive import positive_letters
from rotsolve.motion.rigid import Frame, centre_of_mass, locate, pieces, rise, tidy
from rotsolve.motion.spread import Spread
from rotsolve.paths.meaning import AtInstant, Meaning, NotYet
from rotsolve.paths.shares import joined

ENTRY_OF = {"x": "xx", "y": "yy", "z": "zz"}


class OfInertias(AtInstant, frozen=True):
    """Reads paths about the spread of a body's mass."""

    def meaning(self, path: Path, term: Term | None) -> Meaning:
        """The meaning of `inertia`, `gyration`, `inertia_tensor`, `cm`, `mass` or a component of `angular_momentum` of a body."""
        try:
            told = self._told(path, term)
        except (Unknown, NotSliced) as error:
            raise NotYet(str(error)) from None
        dimension = QUANTITIES[path.quantity].dimension
        return Meaning(
            told.formula, dimension, label=told.label, said=told.said, definitions=told.definitions, law=told.law
        )

    def masses_told_twice(self) -> Iterator[Equation]:
        """What the mass and the density of a body say together, where the scene tells both."""
        configuration = self.instant.configuration
        for body in configuration.present(self.instant.state):
            if body.density is not None:
                yield from mass_beside_density(self._spread(body.name, None), body.density)

    def is_flat(self, name: str, term: Term) -> bool:
        """Whether the centres of mass of all pieces lie at the height of the point about which is asked."""
        if term.about is not None and self.instant.configuration.pivot(name, self.instant.state) is None:
            return True  # only what turns about an axis has an angular momentum in space so far
        height = self._point(name, term)[1] if term.about is not None else ZERO
        return all(is_zero(piece.height - height) for piece in self._own(name).pieces)

    def _own(self, name: str) -> Frame:
        """The body alone, in its own axes."""
        if not joined(name, self.instant):
            return self.instant.frame(name)
        items = pieces(self.instant.body(name))
        return Frame(items, centre_of_mass(items), NOWHERE)

    def _letter(self, name: str) -> Inertia | None:
        """The moment of inertia with which the laws speak of a body that is not joined to another."""
        return None if joined(name, self.instant) else self.body(name).inertia

    def _told(self, path: Path, term: Term | None) -> Told:
        if path.quantity == "angular_momentum":
            return self._angular_momentum(path, term)
        if not shape_of(self.instant.body(path.owner)).rigid:
            raise NotYet(f"`{path.owner}` is no rigid body: it has no `{path.quantity}`")
        if path.quantity == "cm":
            return self._centre(path, term)
        if path.quantity == "mass":
            spread = self._spread(path.owner, None)
            letter, defined = mass(spread, spread.pieces[0])
            return Told(letter, "mass", (), defined)
        if path.quantity == "inertia_tensor":
            spread = self._spread(path.owner, term)
            entry = path.component or "zz"
            known = inertia.perpendicular(spread) if entry == "zz" else None
            return known or inertia.by_symmetry(spread, entry) or inertia.moment(spread, entry)
        told = self._moment_of_inertia(path, term)
        return inertia.gyration(self._spread(path.owner, term), told) if path.quantity == "gyration" else told

    def _centre(self, path: Path, term: Term | None) -> Told:
        """A coordinate of the centre of mass, from where the coordinates of the body begin."""
        if path.component not in AXES:
            raise NotYet(f"say which coordinate: `{path.owner}.cm.x`, `.y` or `.z`")
        spread = self._spread(path.owner, term)
        told = centre(spread, path.component)
        begin = spread.begin[AXES.index(path.component)]
        return replace(told, formula=told.formula - begin) if len(spread.pieces) > 1 and begin != ZERO else told

    def _moment_of_inertia(self, path: Path, term: Term | None) -> Told:
        """About the axis that is asked for; the letter of the laws where they use just this one."""
        spread = self._spread(path.owner, term)
        along = term.along if term is not None else None
        facts = self._letter(path.owner)
        if along in (None, "z"):
            own = self._own(path.owner)
            held = self.instant.configuration.pivot(path.owner, self.instant.state) is not None  # by a hinge or axle
            counted = own.reference if held else own.reference + own.cm  # about which the letter is
            there = not tidy(self._point(path.owner, term)[0] - counted).parts
            plain = (len(spread.pieces) == 1 and spread.pieces[0].shape.tabled) or held
            if facts is not None and there and plain and not spread.integrates:
                return Told(facts.letter, "")
            return self._perpendicular(path, term, spread) or inertia.moment(spread, "zz")
        if isinstance(along, tuple):
            raise NotYet("an axis in space is for scenes with `up: z`")
        if not isinstance(along, str):
            return inertia.along(spread, heading(along or ZERO))
        if along not in ENTRY_OF:
            raise NotYet(
                f"`along {along}` is no axis of a moment of inertia", help="write `along x`, `y`, `z` or an angle"
            )
        return inertia.moment(spread, ENTRY_OF[along])

    def _perpendicular(self, path: Path, term: Term | None, spread: Spread) -> Told | None:
        """I_z = I_x + I_y of a flat body where both are asked for about the same point."""
        if term is None or spread.integrates:
            return None
        across = {bare(replace(term, path=path, along=axis)) for axis in "xy"}
        return inertia.perpendicular(spread) if across <= self._asked() else None

    def _asked(self) -> set[Term]:
        """What the scene asks for, wherever it does."""
        return {bare(other) for find in self.instant.configuration.problem.finds for other in find.terms}

    def _spread(self, name: str, term: Term | None) -> Spread:
        """The pieces of a body and the point about which is asked."""
        instant = self.instant
        own, body = self._own(name), instant.body(name)
        point, height, ref = self._point(name, term)
        x, y = point.along(RIGHT), point.along(UP)
        central = not tidy(point - own.reference - own.cm).parts and height == rise(body, PointRef(name, "cm"))
        facts = self._letter(name)
        centred = facts is not None and not own.cm.parts and len(own.pieces) == 1 and own.pieces[0].shape.tabled
        integrates = term is not None and term.by == "integration"
        doubled = term is not None and integrates and bare(replace(term, by=None)) in self._asked()
        return Spread(
            name,
            own.pieces,
            simplify(total([piece.mass for piece in own.pieces])) if len(own.pieces) > 1 else own.pieces[0].mass,
            instant.registry,
            instant.state,
            (x, y, height),
            "cm" if central else _index_of_point(ref),
            central,
            facts.letter if facts is not None and centred and not doubled else None,
            integrates,
            doubled,
            shape_of(body).begin(),
            positive_letters(instant.configuration.problem.givens),
            tuple((given.name, given.dimension) for given in instant.configuration.problem.givens),
        )

    def _point(self, name: str, term: Term | None) -> tuple[Vector, Formula, PointRef | None]:
        """The point about which is asked, in the body's axes, and its height: the centre of mass where nothing is said."""
        instant = self.instant
        about = term.about if term is not None else None
        if about is None:
            own = self._own(name)
            return own.reference + own.cm, rise(instant.body(name), PointRef(name, "cm")), None
        support = instant.configuration.connection(about.owner, instant.state)
        points = support.touches() if support is not None else (about,)
        named = [ref for ref in points if ref.owner in instant.configuration.bodies]
        for ref in sorted(named, key=lambda ref: ref.owner != name):
            if instant.host(ref.owner) == instant.host(name):
                other = instant.body(ref.owner)
                return self._seen(locate(other, ref), ref.owner, name), rise(other, ref), ref
        raise NotYet(f"`{about.owner}` is no point of `{name}`", about.span)

    def _seen(self, place: Vector, other: str, name: str) -> Vector:
        """A place in the axes of a body that is joined to another, in the axes of that."""
        if other == name:
            return place
        seats = [self.instant.configuration.seat(item, self.instant.state) for item in (other, name)]
        return (seats[0].place(place) - seats[1].at).rotated(-seats[1].turned)

    def _angular_momentum(self, path: Path, term: Term | None) -> Told:
        """A component of L = Σ r × m v about a point of the axis: of a body that turns about z, (I_zx, I_yz, I_zz) ω."""
        motion = self.instant.motion(path.owner)
        if motion.kind != "axis":
            raise NotYet(f"`{path.owner}` turns about no fixed axis: its angular momentum in space is not solved yet")
        if motion.orientation != RIGHT:
            raise NotYet(f"the components of an angular momentum in space are those of `{path.owner}` as it is drawn")
        point, _, ref = self._point(path.owner, term)
        if joined(path.owner, self.instant):
            raise NotYet(
                f"the angular momentum in space of `{path.owner}` alone, which is joined to another, is not solved yet"
            )
        if ref is None or tidy(point - self.instant.frame(path.owner).reference).parts:
            raise NotYet(
                f"a part of the angular momentum of `{path.owner}` is asked about a point of its axis",
                help="write `about` with a point on the axis",
            )
        spread = self._spread(path.owner, term)
        axis = path.component or "z"
        spin = motion.spin
        if all(piece.shape.pointlike for piece in spread.pieces):
            terms = [_orbital(arm_of(spread, piece), piece.mass, spin, axis) for piece in spread.pieces]
            speed = ("v = ", negate(spin) if is_negative(spin) else spin, " × r, perpendicular to the axis")
            return Told(total(flat(terms)), f"angular momentum, L = Σ r × m v, along {axis}", speed)
        told = inertia.moment(spread, {"x": "zx", "y": "yz", "z": "zz"}[axis])
        return Told(multiply(told.formula, spin), f"angular momentum along {axis}, I_{axis}z ω", (), told.definitions)


def _orbital(arm: Place, mass: Formula, spin: Formula, axis: str) -> Formula:
    """A component of r × m v with v = ω × r = ω (−y, x, 0)."""
    x, y, z = arm
    if axis == "z":
        return multiply(multiply(mass, add(ZERO if x == ZERO else x**2, ZERO if y == ZERO else y**2)), spin)
    lever = multiply(multiply(mass, z), multiply(spin, x if axis == "x" else y))
    return negate(lever)


def bare(term: Term) -> Term:
    """A term without the places in the file where it stands."""
    about = None if term.about is None else replace(term.about, span=None)
    return replace(term, path=replace(term.path, span=None, component=None), about=about)


def _index_of_point(ref: PointRef | None) -> str:
    """The index that a letter about a point has."""
    if ref is None:
        return "cm"
    if ref.argument is not None:
        return re.sub(r"\W+", "", to_text(ref.argument, unicode=False))
    return ref.point or "center"
