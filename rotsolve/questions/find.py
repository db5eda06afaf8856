"""Finds: a `find` line of the scene as one formula over the letters of the laws, with the letter that stands for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.equation import DEFINITION, KINETIC_ENERGY
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.registry import SEPARATOR
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find
from rotsolve.paths import Meaning
from rotsolve.questions.conversion import conversion
from rotsolve.questions.question import Asked, in_parts
from rotsolve.questions.ratios import dimension_in, label_of
from rotsolve.questions.terms import DIFFERENCE, meaning_of, size

if TYPE_CHECKING:
    from rotsolve.core.alteration import Alteration
    from rotsolve.questions.courses import Beside

Earlier = Mapping[str, tuple[Formula, "Dimension | None"]]  # answers found before, by name


def asked(
    find: Find, scene: SceneEquations, earlier: Earlier = MappingProxyType({}), beside: Beside | None = None
) -> Asked:
    """What a `find` line asks for; it may speak of `earlier` answers by name."""
    terms = [term for term in find.terms if term.path.quantity in OSCILLATING]
    swings = tuple((scene.swing(term), term.path.quantity) for term in terms)
    question, altered = quantity_asked(find, scene, earlier, beside), scene.configuration.alteration
    return replace(question if altered is None else rewritten(question, altered), swings=swings)


def rewritten(question: Asked, altered: Alteration) -> Asked:
    """The question with what leads to it changed on purpose; a direct one is told by the laws alone."""
    steps = tuple(altered.rewritten(question.definitions))
    if question.direct:
        return replace(question, definitions=steps)
    meaning = altered.rewritten(
        [question.law.equation(Symbol(question.letter), question.formula, question.section, words=question.label)]
    )
    return replace(question, definitions=steps, formula=meaning[0].right if meaning else question.formula)


def quantity_asked(find: Find, scene: SceneEquations, earlier: Earlier, beside: Beside | None) -> Asked:
    """The formula of a `find` line, and the letter that stands for it."""
    meanings = [meaning_of(term, scene, beside) for term in find.terms]
    formula = formula_of(find, [meaning.formula for meaning, _ in meanings], earlier)
    own = meanings[0][0] if len(meanings) == 1 and find.formula == Symbol("#0") else None  # where one path is all of it
    known = known_dimensions(meanings, scene, earlier)
    dimension = own.dimension if own is not None else dimension_in(find.formula, known)
    label = label_of(find, known)
    share = label != "" and any(term.path.quantity == "kinetic_energy" for term in find.terms[-1:])
    question = Asked(
        find,
        formula,
        f"asked{SEPARATOR}{find.name}",
        dimension,
        label=label,
        law=KINETIC_ENERGY if share else DEFINITION,
        section=meanings[0][1] if meanings else "",
        definitions=tuple(dict.fromkeys(step for meaning, _ in meanings for step in meaning.definitions)),
        laws=tuple(law for meaning, _ in meanings for law in meaning.laws),
    )
    givens = {given.name: given for given in scene.configuration.problem.givens}
    if isinstance(formula, Symbol) and (SEPARATOR in formula.name or is_unknown(formula.name, scene)):
        question = replace(question, letter=formula.name)
        return question if own is None else replace(question, vector=own.vector, words=own.words)
    if isinstance(formula, Symbol) and formula.name in givens:
        note = conversion(find, givens[formula.name])
        return Asked(find, formula, question.letter, dimension, label="conversion of units" if note else "", said=note)
    return question if own is None else of_one_path(question, own)


def formula_of(find: Find, meanings: Sequence[Formula], earlier: Earlier) -> Formula:
    """The arithmetic of a `find` line with the meanings of its paths, and the letters of earlier answers, put in."""
    values = {f"#{index}": meaning for index, meaning in enumerate(meanings)}
    values |= {name: letter for name, (letter, _) in earlier.items() if name != find.name}
    formula = find.formula.substitute(values)
    return size(formula) if find.modifier == "size of" else formula


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


def is_unknown(name: str, scene: SceneEquations) -> bool:
    """Whether a letter of the scene is itself asked for."""
    return any(given.name == name and given.asked for given in scene.configuration.problem.givens)


def known_dimensions(
    meanings: Sequence[tuple[Meaning, str]], scene: SceneEquations, earlier: Earlier
) -> dict[str, Dimension]:
    """The dimensions of givens, of earlier answers and of the paths of a `find` line."""
    known = {given.name: given.dimension for given in scene.configuration.problem.givens if given.dimension is not None}
    known.update({name: dimension for name, (_, dimension) in earlier.items() if dimension is not None})
    known.update({f"#{index}": meaning.dimension for index, (meaning, _) in enumerate(meanings)})
    return known
