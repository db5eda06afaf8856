"""Inertia in space: the entries of a body's inertia tensor about a point as letters, with the steps that define them; turned into axes.

I_P = I_cm + M (d² 1 − d dᵀ); of a body symmetric about n, I = I_t (1 − n nᵀ) + I_a n nᵀ; in turned axes I' = R I Rᵀ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate, rounded_once
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, multiply, negate
from rotsolve.algebra.units.dimension import INERTIA as KG_M2
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.equation import INERTIA, LONG_ENTRY, PARALLEL_AXES, PART_OF_ROOTS, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.symbols import ACROSS_AXIS
from rotsolve.core.vectors.tensor import AXES, ENTRIES, ONE_AXIS, InertiaTensor, displaced
from rotsolve.core.vectors.triple import (
    NOTHING,
    Rows,
    Triple,
    dot_product,
    is_axis,
    minus,
    rotated,
    scaled_by,
    square_of,
    vector_sum,
)
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Given
from rotsolve.laws import inertia
from rotsolve.laws.centre_of_mass import Told, Unknown, plain
from rotsolve.laws.integration import NotSliced
from rotsolve.motion.spread import Spread
from rotsolve.space.arrangement import JointedBodies

CM = "cm"


class Tensors(Struct):
    """The tensors of a scene; `steps` are what defines the letters in them, in the order in which they were asked for."""

    held: JointedBodies
    registry: Registry
    givens: tuple[Given, ...]
    positive: frozenset[str]
    section: str
    steps: dict[Equation, None]
    said: set[Formula] = field(
        default_factory=set
    )  # moments of which it is said about which other axes they are the same
    numbers: dict[str, Certified | None] = field(default_factory=dict)  # of letters

    def about(self, name: str, point: Triple, spot: str) -> InertiaTensor:
        """The tensor about a point of a body, in its own axes; `spot` is the point's name."""
        body = self.held.bodies[name]
        spot = CM if self.same_place(point, self.held.centre(name)) else spot
        if body.tensor is not None:
            return self._shifted(name, body.tensor, self.told_about(name), point, spot)
        if body.inertia is not None or body.gyration is not None:
            return self._of_axis(name, point, spot)
        spread = self._spread(name, point, spot)
        entries: dict[str, Formula] = {}
        for word in ENTRIES:
            try:
                told = inertia.moment(spread, word)
            except Unknown as error:
                help = "give each part a shape in place of its inertia, and each hole one that has a depth"
                raise Unsolvable(f"{error}: its tensor in space nothing tells", span=body.span, help=help) from None
            except NotSliced as error:
                help = "give that shape to a body of its own, clamped to this one"
                lines, file = self.held.problem.lines, self.held.problem.file
                raise Unsolvable(str(error), span=body.span, help=help, lines=lines, file=file) from None
            entries[word] = self.entry(name, word, spot, told, entries)
        alike: dict[Formula, list[str]] = {}
        for word in ONE_AXIS:
            alike.setdefault(entries[word], []).append(word[0])
        self.say_alike({one: axes[1:] for one, axes in alike.items() if isinstance(one, Symbol) and len(axes) > 1})
        return InertiaTensor(**entries)

    def entry(self, name: str, word: str, spot: str, told: Told, before: Mapping[str, Formula]) -> Formula:
        """An entry as a letter with what it stands for; of a moment that is the same as one before, that."""
        same = self.same_moment(word, told, before) if spot != CM and told.definitions else None
        if same is not None:
            return before[same]
        self.keep(told.definitions)
        if told.formula == ZERO or isinstance(told.formula, Symbol):
            return told.formula
        return self.letter(name, word, spot, told.formula, told.label)

    def keep(self, steps: Iterable[Equation]) -> None:
        """Remember what defines letters, of each once."""
        known = {step.left for step in self.steps}
        self.steps.update((step, None) for step in steps if step.left not in known)

    def say_alike(self, alike: Mapping[Formula, list[str]]) -> None:
        """Say beside the steps that define moments of inertia about which other axes they are the same; once of each."""
        new = {moment: axes for moment, axes in alike.items() if moment not in self.said}
        if new:
            self.said |= new.keys()
            self.steps = {beside(step, new[step.left]) if step.left in new else step: None for step in self.steps}

    def same_moment(self, word: str, told: Told, before: Mapping[str, Formula]) -> str | None:
        """The axis of an entry before about which the moment of inertia is the same; None where there is none."""
        if word not in ONE_AXIS:
            return None
        whole = self.spelled(plain(told.formula, told.definitions))
        return next(
            (other for other in ONE_AXIS if other in before and is_zero(self.spelled(before[other]) - whole)), None
        )

    def spelled(self, value: Formula) -> Formula:
        """A formula with what the letters of moments of inertia stand for, in textbook form."""
        return simplify(self.put_in(value), positive=self.positive)

    def put_in(self, value: Formula) -> Formula:
        """A formula with what the letters of moments of inertia stand for, as it is."""
        told = {step.left.name: step.right for step in self.steps if isinstance(step.left, Symbol)}
        while told.keys() & value.symbols():
            value = value.substitute(told)
        return value

    def number(self, value: Formula, signs: SignOracle) -> Certified | None:
        """The number of a formula by those of its letters, in the case that is looked at; None where one has none."""
        told = {step.left.name: step.right for step in self.steps if isinstance(step.left, Symbol)}
        roots: dict[str, Certified] = {}
        for name in sorted(told.keys() & value.symbols()):
            if name not in self.numbers:
                found = self.number(told[name], signs)
                self.numbers[name] = None if found is None else rounded_once(found)
            number = self.numbers[name]
            if number is None:
                return None
            roots[name] = number
        try:
            return evaluate(value, {**signs.values, **signs.trials}, digits=8, roots=roots)
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def behind(self, value: Formula) -> tuple[Equation, ...]:
        """The steps that define the letters of a formula, and those of what they stand for."""
        told = {step.left.name: step for step in self.steps if isinstance(step.left, Symbol)}
        found: set[Equation] = set()
        pending = sorted(told.keys() & value.symbols())
        while pending:
            step = told[pending.pop()]
            if step not in found:
                found.add(step)
                pending += sorted(told.keys() & step.right.symbols())
        return tuple(step for step in self.steps if step in found)

    def letter(self, name: str, word: str, spot: str, formula: Formula, label: str, shifts: bool = False) -> Formula:
        """A letter for an entry, with what it stands for."""
        where = "" if spot == CM else f"_{spot}"
        quantity = SceneQuantity("inertia", name, "", f"{word}{where}", "I", KG_M2)
        law = PARALLEL_AXES if shifts else INERTIA
        symbol = self.registry.ask(quantity)
        self.keep([law.equation(symbol, formula, self.section, (name,), words=label)])
        return symbol

    def work_out_first(self, tensor: InertiaTensor) -> None:
        """Let the entries of a long tensor be worked out by themselves, before what they are part of: as numbers, where there are such."""
        own = {step.left for word in ENTRIES for step in self.behind(tensor.entry(word))}
        law, cost = LONG_ENTRY, LONG_ENTRY.cost
        self.steps = {replace(step, law=law, cost=cost) if step.left in own else step: None for step in self.steps}

    def part(
        self, name: str, spot: str, words: str, letter: str, index: str, value: Formula, dimension: Dimension
    ) -> Formula:
        """A letter for a part of the principal moments and axes of a body about a point, with what it stands for."""
        component = "_".join(filter(None, (index, spot)))
        symbol = self.registry.ask(SceneQuantity(words, name, "", component, letter, dimension))
        long = any(step.law == LONG_ENTRY and step.left in value.walk(Symbol) for step in self.steps)
        law = LONG_ENTRY if long else PART_OF_ROOTS
        self.keep([law.equation(symbol, value, self.section, (name,), words=words)])
        return symbol

    def _spread(self, name: str, point: Triple, spot: str) -> Spread:
        """The pieces of a body as seen from a point."""
        held = self.held
        return Spread(
            name,
            held.pieces(name),
            held.mass(name),
            self.registry,
            self.section,
            point,
            spot,
            point == held.centre(name),
            None,
            False,
            False,
            NOTHING,
            self.positive,
            tuple((given.name, given.dimension) for given in self.givens),
            axes=self._named_axes(name),
        )

    def _named_axes(self, name: str) -> str:
        """What the axes of a body are called: those of one that nods on a ball joint e₁ to e₃; '' where the letter of its axis would name
        that of another body."""
        joint = self.held.main(name)
        if joint is None or self.held.axis(name) is None:
            return "xyz"
        if joint.free:
            return "123" if name in self.held.nodding else ""
        return "" if joint.carrier.owner in self.held.bodies else "xyz"

    def _shifted(self, name: str, given: InertiaTensor, told: Triple, point: Triple, spot: str) -> InertiaTensor:
        """A tensor that is given about the point `told` about another one: down to the centre of mass by −M d², up again by M d²."""
        if self.same_place(told, point):
            return given
        centre, mass = self.held.centre(name), self.held.mass(name)
        down, up = (displaced(mass, vector_sum(place, minus(centre))) for place in (told, point))
        entries = {}
        for word in ENTRIES:
            change = add(up.entry(word), negate(down.entry(word)))
            entry = given.entry(word)
            if change != ZERO and not self.held.vanishes(change):
                entry = self.letter(
                    name, word, spot, add(entry, change), f"moment of inertia, {spoken(name)}, parallel axes", True
                )
            entries[word] = entry
        return InertiaTensor(**entries)

    def same_place(self, one: Triple, other: Triple) -> bool:
        """Whether two places are the same."""
        return one == other or all(self.held.vanishes(a - b) for a, b in zip(one, other, strict=True))

    def told_about(self, name: str) -> Triple:
        """The point about which the scene tells a body's inertia, in its own axes."""
        from rotsolve.language.problem import PointRef

        about = self.held.bodies[name].inertia_about
        return self.held.centre(name) if about is None else self.held.spot(PointRef(name, about))

    def _of_axis(self, name: str, point: Triple, spot: str) -> InertiaTensor:
        """Of a body of which the scene tells one moment, that about its axis; the moment across has a letter, and no number."""
        held, body = self.held, self.held.bodies[name]
        axis = held.axis(name) or (ZERO, ZERO, ONE)
        mass, centre, told = held.mass(name), held.centre(name), self.told_about(name)
        axial = body.inertia if body.inertia is not None else multiply(mass, (body.gyration or ZERO) ** 2)
        out = vector_sum(told, minus(centre))
        on_axis = scaled_by(dot_product(axis, out), axis)
        beside = square_of(
            vector_sum(out, minus(on_axis))
        )  # how far from the axis the point is about which it is told, squared
        axial = axial if self.held.vanishes(beside) else simplify(axial - mass * beside)
        across = self.registry.ask(SceneQuantity("inertia", name, "", ACROSS_AXIS, "I", KG_M2))
        return self._shifted(name, round_about_way(axis, axial, across), vector_sum(centre, on_axis), point, spot)


def beside(step: Equation, axes: Sequence[str]) -> Equation:
    """The step that defines a moment of inertia with the other axes about which it is the same."""
    words = f"by symmetry the same about {' and '.join(axes)}"
    return replace(step, remark=(*step.remark, *(("; ",) if step.remark else ()), words))


def round_about_way(axis: Triple, axial: Formula, across: Formula) -> InertiaTensor:
    """I_t (1 − n nᵀ) + I_a n nᵀ of a unit vector n."""
    entries = {}
    for word in ENTRIES:
        i, j = (AXES.index(letter) for letter in word)
        both = multiply(axis[i], axis[j])
        one = ONE if i == j else ZERO
        entries[word] = add(multiply(across, add(one, negate(both))), multiply(axial, both))
    return InertiaTensor(**entries)


def in_axes(tensor: InertiaTensor, own: Rows, about: Triple | None, axis: Triple | None) -> InertiaTensor:
    """A tensor in the axes into which `own` turns a body's own ones; of one that is symmetric about `axis`, which lies `about` in them."""
    if own == ((ONE, ZERO, ZERO), (ZERO, ONE, ZERO), (ZERO, ZERO, ONE)):
        return tensor
    if about is not None and axis is not None and is_axis(axis):
        across = (axis[1], axis[2], axis[0])
        axial, other = (entry_along(tensor, way) for way in (axis, across))
        return round_about_way(about, axial, other)
    return tensor.turned(own)


def entry_along(tensor: InertiaTensor, direction: Triple) -> Formula:
    """nᵀ I n: the moment of inertia about a direction."""
    return dot_product(direction, product(tensor, direction))


def product(tensor: InertiaTensor, vector: Triple) -> Triple:
    """I v."""
    rows = ((tensor.xx, tensor.xy, tensor.zx), (tensor.xy, tensor.yy, tensor.yz), (tensor.zx, tensor.yz, tensor.zz))
    return rotated(rows, vector)


def moment_along(tensor: InertiaTensor, direction: Triple) -> Formula:
    """Σ n_i n_j I_ij of a unit vector, with the squares drawn together."""
    x, y, z = direction
    terms = (
        multiply(tensor.xx, squared(x)),
        multiply(tensor.yy, squared(y)),
        multiply(tensor.zz, squared(z)),
        multiply(2 * ONE, multiply(tensor.xy, multiply(x, y))),
        multiply(2 * ONE, multiply(tensor.yz, multiply(y, z))),
        multiply(2 * ONE, multiply(tensor.zx, multiply(z, x))),
    )
    result: Formula = ZERO
    for term in terms:
        result = add(result, term)
    return result


def squared(part: Formula) -> Formula:
    return part if part in (ZERO, ONE) else simplify(part**2)
