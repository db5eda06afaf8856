"""Kinetic energies by name: what is lost or shared is told by K₁ before and K₂ after, as textbooks do, and not in one long line."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ENERGY
from rotsolve.core.equation import KINETIC_ENERGY_AT, Equation
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import is_quantity
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Term
from rotsolve.paths.meaning import Meaning

KINETIC = "kinetic_energy"
SIGNS = {"lost": (1, -1), "change of": (-1, 1), "": (1,)}  # of K at the moments of which a term speaks


def with_named_energies(
    find: Find, meanings: list[tuple[Meaning, str]], scene: SceneEquations
) -> list[tuple[Meaning, str]]:
    """The meanings with K at each moment as a letter of its own, where moments are compared and none of them is asked for itself."""
    if scene.configuration.problem.space:
        return meanings
    energies = Energies(scene)
    moments = {
        (term.path.owner, state)
        for term in find.terms
        for state in energies.moments(term)
        if energies.is_told(term, state)
    }
    if len(moments) < 2 or moments & energies.asked():
        return meanings
    last = max((state for _, state in moments), key=energies.order.index)
    pairs = zip(find.terms, meanings, strict=True)
    return [
        (energies.renamed(term, meaning, last) if energies.moments(term) else meaning, own)
        for term, (meaning, own) in pairs
    ]


class Energies:
    """The kinetic energies of which the questions of a scene speak, and the letters by which they are told."""

    def __init__(self, scene: SceneEquations) -> None:
        self.scene = scene
        self.order = scene.configuration.timeline.named

    def moments(self, term: Term) -> list[str]:
        """When a term speaks of a kinetic energy, as far as it names states."""
        if term.path.quantity != KINETIC or term.modifier not in SIGNS:
            return []
        ends = self.scene.configuration.timeline.whole(term.during) if term.during else (term.start, term.end)
        named = (ends or (None,)) if term.modifier else (term.at,)
        return [state for state in named if state] if set(named) <= set(self.order) else []

    def asked(self) -> set[tuple[str, str]]:
        """The moments at which a question asks for a kinetic energy and nothing else."""
        alone = (find.terms[0] for find in self.scene.configuration.problem.finds if len(find.terms) == 1)
        return {(term.path.owner, state) for term in alone if not term.modifier for state in self.moments(term)}

    def value(self, term: Term, state: str) -> Formula:
        """K at a moment, by the speeds there."""
        return self.scene.reader(state).meaning(term.path, Term(term.path, at=state)).formula

    def is_told(self, term: Term, state: str) -> bool:
        """Whether K is worth a letter: neither nothing nor one itself."""
        value = self.value(term, state)
        return value.symbols() != frozenset() and not is_quantity(value)

    def letter(self, owner: str, state: str) -> Formula:
        """K₁ of the first moment at which that of an owner is compared, K₂ of the second."""
        terms = [term for find in self.scene.configuration.problem.finds for term in find.terms]
        compared = {name for term in terms if term.path.owner == owner for name in self.moments(term)} | {state}
        number = [name for name in self.order if name in compared].index(state) + 1
        return self.scene.registry.ask(SceneQuantity(KINETIC, owner, state, "", f"K{number}", ENERGY))

    def renamed(self, term: Term, meaning: Meaning, section: str) -> Meaning:
        """K at one moment, or the difference of two, in letters, with the definitions that tell these in a section."""
        told: list[Formula] = []
        definitions: list[Equation] = []
        for state in self.moments(term):
            value = self.value(term, state)
            told.append(self.letter(term.path.owner, state) if self.is_told(term, state) else value)
            if self.is_told(term, state):
                definitions.append(_definition(told[-1], value, section, state))
        first, *last = (part if sign > 0 else -part for sign, part in zip(SIGNS[term.modifier], told, strict=True))
        formula = first if not last else last[0] + first if SIGNS[term.modifier][0] < 0 else first + last[0]
        return replace(meaning, formula=formula, definitions=(*meaning.definitions, *definitions))


def _definition(letter: Formula, value: Formula, section: str, state: str) -> Equation:
    """K = ½ m v² + ½ I ω² at a state."""
    defines = letter.name if isinstance(letter, Symbol) else ""
    return KINETIC_ENERGY_AT.equation(letter, value, section, defines=defines, moment=spoken(state))
