"""Finds: a `find` line of the scene as one formula over the letters of the laws, with the letter that stands for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, Quotient, Sum, Symbol, add, sqrt
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, NONE, Dimension, DimensionError, dimension_of
from rotsolve.algebra.units.quantities import number_in_unit
from rotsolve.core.derivation import Words
from rotsolve.core.equation import DEFINITION, KINETIC_ENERGY, Equation, Law
from rotsolve.core.quantity import OSCILLATING, QUANTITIES
from rotsolve.core.symbols import asked_symbol, component_symbol, has_quantities, is_key, is_quantity
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector
from rotsolve.core.vectors.tensor import AXES, ENTRIES
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Given, Term
from rotsolve.paths.meaning import Meaning, NotYet, whole_vector
from rotsolve.questions.terms import DIFFERENCE, magnitude, meaning_of

if TYPE_CHECKING:
    from rotsolve.core.passage import Alteration
    from rotsolve.equations.swing import Swing
    from rotsolve.questions.functions_of_time import Beside


class Asked(Struct, frozen=True):
    """An asked quantity: its name, what it is made of, and the letter that stands for it in the laws.

    `letter` is the quantity's own letter where the question is just that quantity, else a letter made for the question; `section` is
    where its definition belongs. `parts` are the questions for the components of a vector, which are answered before its size; each
    of them, and each quantity that a choice compares, knows its `whole` by name. `moving` is a velocity without which the question
    has no meaning; `said` is a remark with formulas in it, `definitions` are the steps that lead to the formula, and
    `laws` what this question alone speaks of, such as when a wheel reverses.
    """

    find: Find
    formula: Formula
    letter: str
    dimension: Dimension | None
    vector: Vector | None = None
    remark: str = ""
    label: str = ""
    law: Law = DEFINITION
    section: str = ""
    words: tuple[str, str] = ("", "")
    parts: tuple[Asked, ...] = ()
    whole: str = ""
    moving: Vector = NOWHERE
    said: Words = ()
    definitions: tuple[Equation, ...] = ()
    laws: tuple[Equation, ...] = ()
    swings: tuple[tuple[Swing, str], ...] = ()  # with what is asked of each: its period or frequency

    @property
    def direct(self) -> bool:
        """Whether the question is a single quantity of the laws."""
        return isinstance(self.formula, Symbol) and self.formula.name == self.letter

    def same_as(self, other: Asked) -> bool:
        """Whether both ask for the same, under whatever names."""
        return self.letter == other.letter or (self.formula, self.section) == (other.formula, other.section)

    @property
    def of_givens(self) -> bool:
        """Whether the question is made of givens alone, so that no law has a say in it."""
        return not self.find.terms and not has_quantities(self.formula)

    @property
    def points(self) -> bool:
        """Whether a vector or a part of one is asked, not a mere speed."""
        return self.vector is not None and self.find.terms[0].path.quantity != "speed"

    @property
    def resolves(self) -> bool:
        """Whether a whole vector is asked, not one component of it."""
        return self.vector is not None and whole_vector(self.find.terms[0].path)


def in_parts(question: Asked) -> Asked:
    """The question for a vector with those for its components in front: v_x and v_y, then v = √(v_x² + v_y²).

    A vector of one part needs none: its size and its direction are seen at once.
    """
    vector = question.vector
    if vector is None or not question.resolves or len(vector.parts) < 2:
        return question
    if ZERO in (vector.along(RIGHT), vector.along(UP)):
        return question
    parts = tuple(component(question, vector, axis) for axis in "xy")
    headings = [heading for _, heading in vector.parts]
    if len(headings) == 2 and (headings[0] - headings[1]).cos() == ZERO and headings[0].terms:
        return replace(question, parts=parts)  # such as √(a_t² + a_n²), shorter than by x and y
    size = sqrt(add(*(Symbol(part.letter) ** 2 for part in parts)))
    return replace(question, formula=size, parts=parts)


def component(question: Asked, vector: Vector, axis: str) -> Asked:
    """The question for one component of a vector."""
    formula = vector.along(RIGHT if axis == "x" else UP)
    direct = is_quantity(formula)
    letter = formula.name if isinstance(formula, Symbol) and direct else component_symbol(question.letter, axis)
    side, words = ("horizontally", ("right", "left")) if axis == "x" else ("vertically", ("up", "down"))
    return Asked(
        of_component(question.find, axis),
        formula,
        letter,
        question.dimension,
        label=f"{question.label}, {side}",
        law=question.law,
        section=question.section,
        words=words,
        whole=question.find.name,
    )


def conversion(find: Find, given: Given) -> Words:
    """1° = π/180 rad, so 15 · π/180 rad = π/12 rad; nothing where the unit stays."""
    old, new = given.unit, find.unit
    if given.value is None or given.value.symbols() or old is None or new is None or old.factor == new.factor:
        return ()
    number, factor = number_in_unit(given.value, old), simplify(number_in_unit(old.factor, new))
    unit = new.after("")
    known: Words = (f"{old.after('1')} = ", factor, unit)
    if number == ONE:
        return known
    return (*known, ": ", number, " · ", factor, unit, " = ", simplify(number * factor), unit)


FRICTION = "friction over normal force"  # the least coefficient that keeps it from slipping
ENERGIES = ("kinetic_energy", "potential_energy", "energy")


def find_label(find: Find, dimensions: Mapping[str, Dimension]) -> str:
    """What a `find` line that is a quotient is called, by the `dimensions` of its letters; nothing where its parts do not tell."""
    formula = find.formula
    if not isinstance(formula, Quotient):
        return ""
    top, bottom = formula.numerator, formula.denominator
    paths = {f"#{index}": term.path for index, term in enumerate(find.terms)}
    upper, lower = (paths.get(side.name) if isinstance(side, Symbol) else None for side in (top, bottom))
    sides = [(path.quantity, path.owner) for path in (upper, lower) if path is not None]
    if [quantity for quantity, _ in sides] == ["friction_force", "normal_force"] and sides[0][1] == sides[1][1]:
        return FRICTION
    above, below = dimension_in(top, dimensions), dimension_in(bottom, dimensions)
    if top == 2 * PI and below == ANGULAR_VELOCITY:
        return "period, the time of one turn"
    if above is None or above != below or above == NONE:
        return ""
    return f"share of the {spoken(lower.quantity)}" if lower is not None and lower.quantity in ENERGIES else "ratio"


def label_within(meanings: Sequence[Meaning]) -> str:
    """The law of the one quantity of which a `find` line is an expression; nothing where that is a letter of the laws, or has none."""
    if len(meanings) != 1 or meanings[0].plain or isinstance(meanings[0].formula, Symbol):
        return ""
    return meanings[0].label


def dimension_in(formula: Formula, dimensions: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of a part of a question, where it is known."""
    try:
        return dimension_of(formula, dimensions)
    except (DimensionError, KeyError, ValueError):
        return None


def entries(find: Find, scene: SceneEquations) -> tuple[Find, ...]:
    """A question for a matrix or a vector in space as questions for its entries; any other question alone."""
    if scene.configuration.problem.space:
        from rotsolve.space.entries import entries_in_space

        return entries_in_space(find)
    if len(find.terms) != 1 or find.formula != Symbol("#0") or find.terms[0].path.component is not None:
        return (find,)
    term = find.terms[0]
    names = components(term, scene)
    return tuple(replace(of_component(find, name), whole=find.name) for name in names) or (find,)


def of_component(find: Find, name: str) -> Find:
    """The same line for one component of its only path: `v_x` with `ball.velocity.x`."""
    term = find.terms[0]
    path = replace(term.path, component=name)
    return replace(find, name=f"{find.name}_{name}", terms=(replace(term, path=path),))


def components(term: Term, scene: SceneEquations) -> tuple[str, ...]:
    """The entries that belong to a question for a whole: all of a tensor; the coordinates in which a body extends."""
    path = term.path
    if path.owner not in scene.configuration.bodies:
        return ()
    if path.quantity == "inertia_tensor":
        return ENTRIES
    if path.quantity not in ("cm", "angular_momentum") or term.modifier:
        return ()
    flat = scene.reader(scene.configuration.timeline.states[0].name).is_flat(path.owner, term)
    if path.quantity == "cm":
        return AXES[:2] if flat else AXES
    return AXES if term.about is not None and not flat else ()


Earlier = Mapping[str, tuple[Formula, "Dimension | None"]]  # answers found before, by name


def question_for(
    find: Find, scene: SceneEquations, earlier: Earlier = MappingProxyType({}), beside: Beside | None = None
) -> Asked:
    """What a `find` line asks for; it may speak of `earlier` answers by name."""
    planar = not scene.configuration.problem.space
    terms = [term for term in find.terms if term.path.quantity in OSCILLATING and planar]
    swings = tuple((scene.swing(term), term.path.quantity) for term in terms)
    question, altered = quantity_asked(find, scene, earlier, beside), scene.configuration.alteration
    question = written_in_order(question, scene)
    return replace(question if altered is None else rewritten(question, altered), swings=swings)


def written_in_order(question: Asked, scene: SceneEquations) -> Asked:
    """The question with the products in its formula, and in what it alone speaks of, as the laws of the scene write theirs."""
    steps, laws = (tuple(map(scene.put_in_order, told)) for told in (question.definitions, question.laws))
    return replace(question, formula=scene.in_order(question.formula), definitions=steps, laws=laws)


def rewritten(question: Asked, altered: Alteration) -> Asked:
    """The question with what leads to it changed on purpose; a direct one is told by the laws alone."""
    steps, laws = (tuple(altered.rewritten(told)) for told in (question.definitions, question.laws))
    question = replace(question, definitions=steps, laws=laws)
    if question.direct:
        return question
    meaning = altered.rewritten(
        [question.law.equation(Symbol(question.letter), question.formula, question.section, words=question.label)]
    )
    return replace(question, formula=meaning[0].right if meaning else question.formula)


def quantity_asked(find: Find, scene: SceneEquations, earlier: Earlier, beside: Beside | None) -> Asked:
    """The formula of a `find` line, and the letter that stands for it."""
    refuse_modified_whole(find, scene)
    if scene.configuration.problem.space:
        from rotsolve.space.entries import refuse_mixed_axes, refuse_products

        refuse_products(find)
        refuse_mixed_axes(find, scene)
    meanings = meanings_of_terms(find, scene, beside)
    if any(term.path.quantity == "kinetic_energy" for term in find.terms):
        from rotsolve.questions.energies import with_named_energies

        meanings = with_named_energies(find, meanings, scene)
    formula = find_formula(find, [meaning.formula for meaning, _ in meanings], earlier)
    own = meanings[0][0] if len(meanings) == 1 and find.formula == Symbol("#0") else None  # where one path is all of it
    known = known_dimensions(meanings, scene, earlier)
    dimension = own.dimension if own is not None else dimension_in(find.formula, known)
    label = find_label(find, known) or label_within([meaning for meaning, _ in meanings])
    share = label != "" and any(term.path.quantity == "kinetic_energy" for term in find.terms[-1:])
    question = Asked(
        find,
        formula,
        asked_symbol(find.name),
        dimension,
        label=label,
        law=KINETIC_ENERGY if share else DEFINITION,
        section=meanings[0][1] if meanings else "",
        definitions=tuple(dict.fromkeys(step for meaning, _ in meanings for step in meaning.definitions)),
        laws=tuple(law for meaning, _ in meanings for law in meaning.laws),
    )
    givens = {given.name: given for given in scene.configuration.problem.givens}
    given = givens.get(formula.name) if isinstance(formula, Symbol) else None
    if isinstance(formula, Symbol) and (is_key(formula.name) or (given is not None and given.asked)):
        question = replace(question, letter=formula.name)
        return question if own is None else replace(question, vector=own.vector, words=own.words)
    if given is not None:
        note = conversion(find, given)
        words = "conversion of units" if note else "" if own is None else own.label
        return Asked(find, formula, question.letter, dimension, label=words, said=note)
    return question if own is None else of_one_path(question, own)


def refuse_modified_whole(find: Find, scene: SceneEquations) -> None:
    """Refuse a modifier in front of more than one quantity, which would be left out; of an unknown letter it says which root is meant."""
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    sought = any(given.asked for given in scene.configuration.problem.givens if given.name == letter)
    if find.modifier not in ("", "size of") and find.where is None and not sought:
        if find.runs or any(other.runs and other.name == letter for other in scene.configuration.problem.finds):
            help = "give a moment a letter, `later: {time: t1}` and `t1: s` under `given`, and ask for it `at later`"
            raise NotYet(f"`{find.modifier}` of a function of time is not solved as such", find.span, help)
        message = f"`{find.modifier}` in `{find.text.strip()}` is solved of a single quantity, or of an earlier answer over its open letter"
        raise NotYet(message, find.span)


def meanings_of_terms(find: Find, scene: SceneEquations, beside: Beside | None) -> list[tuple[Meaning, str]]:
    """The meanings of all terms; of forces of which the laws tell their sum alone, where it is that sum that is asked, the first as all."""
    try:
        return [meaning_of(term, scene, beside) for term in find.terms]
    except NotYet:
        if not scene.configuration.problem.space:
            from rotsolve.questions.forced import forced_swings

            if (forced := forced_swings(find, scene.configuration)) is not None:
                raise forced from None
            raise
        if len(find.terms) < 2:
            raise
        from rotsolve.space.supports import with_supports_together

        terms = with_supports_together(find, scene)
        if terms is None:
            raise
    nothing = Meaning(ZERO, QUANTITIES["force"].dimension), ""
    return [nothing if term is None else meaning_of(term, scene, beside) for term in terms]


def find_formula(find: Find, meanings: Sequence[Formula], earlier: Earlier) -> Formula:
    """The arithmetic of a `find` line with the meanings of its paths, and the letters of earlier answers, put in."""
    values = {f"#{index}": meaning for index, meaning in enumerate(meanings)}
    values |= {name: letter for name, (letter, _) in earlier.items() if name != find.name}
    formula = find.formula.substitute(values)
    if isinstance(formula, Sum) and len(set(formula.terms)) < len(formula.terms):  # of entries that are alike
        formula = simplify(formula)
    elif isinstance(formula, Call) and len(find.terms) > 1:  # of vectors that are alike in part
        formula = formula.transform(lambda part: simplify(part) if isinstance(part, Sum) else part, Sum)
    return magnitude(formula) if find.modifier == "size of" else formula


def of_one_path(question: Asked, meaning: Meaning) -> Asked:
    """A question that is a single path, with all that is to be said of it; that for a vector with its components."""
    modifier, whole = question.find.terms[0].modifier, question.find.modifier == ""
    question = replace(
        question,
        vector=meaning.vector,
        remark=meaning.remark,
        label=meaning.label,
        law=meaning.law,
        words=meaning.words if modifier == "" and whole else ("", ""),
        moving=meaning.moving,
        said=meaning.said,
    )
    return in_parts(question) if modifier in ("", "mean", *DIFFERENCE) and whole else question


def known_dimensions(
    meanings: Sequence[tuple[Meaning, str]], scene: SceneEquations, earlier: Earlier
) -> dict[str, Dimension]:
    """The dimensions of givens, of earlier answers and of the paths of a `find` line."""
    known = {given.name: given.dimension for given in scene.configuration.problem.givens if given.dimension is not None}
    known.update({name: dimension for name, (_, dimension) in earlier.items() if dimension is not None})
    known.update({f"#{index}": meaning.dimension for index, (meaning, _) in enumerate(meanings)})
    return known
