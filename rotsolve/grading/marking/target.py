"""Target: what one answer of a solved scene is held against: a number or formula, the parts of a vector or matrix, a word."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import NONE, Dimension
from rotsolve.algebra.units.dimension import TIME as DURATION
from rotsolve.algebra.units.unit_table import ONE_UNIT
from rotsolve.core.derivation import Answer
from rotsolve.core.quantity import EITHER_WAY
from rotsolve.core.symbols import TIME, key_of
from rotsolve.core.vectors.tensor import AXES
from rotsolve.derivation.letters import in_printed_letters
from rotsolve.derivation.meanings import Meanings
from rotsolve.grading.comparing.numbers import certified_number
from rotsolve.grading.comparing.scalars import Close, Same, Scalar
from rotsolve.language.marks import Marking, marking_of
from rotsolve.language.problem import Problem
from rotsolve.motion.positive import positive_letters
from rotsolve.solution import Solution


class Target(Struct, frozen=True, eq=False):
    """An answer with its marking: `whole` is the number or the size, `parts` the components, which `labels` name, `options` the words
    to choose from."""

    name: str
    marking: Marking
    whole: Scalar | None = None
    parts: tuple[Scalar, ...] = ()
    labels: tuple[str, ...] = ()
    rows: int = 1
    word: str = ""
    options: tuple[str, ...] = ()
    directional: bool = False  # whether the published answer is the direction alone
    either: bool = False  # whether it is a line, which points either way


class SceneLetters(Struct, frozen=True, dict=True):
    """The letters of a scene: which name what, their dimensions and values, and the closed forms of the answers."""

    solution: Solution
    meanings: Meanings

    @classmethod
    def of(cls, solution: Solution) -> SceneLetters:
        assert solution.trace.meanings is not None
        return cls(solution, solution.trace.meanings())

    @property
    def problem(self) -> Problem:
        return self.solution.problem

    @cached_property
    def runs(self) -> bool:
        """Whether the running time is a letter of the answers."""
        return any(find.runs for find in self.problem.finds)

    @cached_property
    def givens(self) -> frozenset[str]:
        """The letters in which closed forms are written, as they are printed."""
        names = {given.name for given in self.problem.givens}
        return frozenset(names | ({self.meanings.time} if self.runs else set()))

    @property
    def values(self) -> dict[str, Formula]:
        return self.problem.values

    @cached_property
    def positive(self) -> frozenset[str]:
        """The givens that are surely positive."""
        return positive_letters(self.problem.givens)

    @cached_property
    def answers(self) -> frozenset[str]:
        """The names of all answers."""
        return frozenset(answer.name for answer in self.solution.derivation.answers)

    @cached_property
    def told(self) -> frozenset[str]:
        """The letters that answers may hold beside givens: those of all answers and of their components."""
        parts = {
            part.name for answer in self.solution.derivation.answers if not answer.rows for part in answer.components
        }
        return self.answers | (parts - self.givens)

    @cached_property
    def closed(self) -> dict[str, Formula]:
        """The closed forms of the answers that have one, by name."""
        forms = ((answer.name, self.written(answer.closed)) for answer in self.solution.derivation.answers)
        return {name: form for name, form in forms if form is not None}

    @cached_property
    def printed(self) -> frozenset[str]:
        """The letters that the laws print."""
        return frozenset(name for name, key in self.meanings.keys.items() if not key_of(key).marked)

    @cached_property
    def constants(self) -> frozenset[str]:
        """The letters of moments of inertia that the laws print: those are the bodies' own, whatever moves."""
        return frozenset(name for name in self.printed if key_of(self.meanings.keys[name]).kind == "inertia")

    def meaning(self, name: str) -> Formula | None:
        """The closed form of a letter that is no given."""
        closed = self.closed.get(name)
        return self.meanings.closed(name) if closed is None and name in self.meanings.keys else closed

    def spelled_out(self, formula: Formula) -> Formula | None:
        """A formula with the closed forms of all letters that are no givens and no answers; None where one has none."""
        forms = {name: self.meaning(name) for name in formula.symbols() - self.givens - self.told}
        known = {name: form for name, form in forms.items() if form is not None}
        return formula.substitute(known) if len(known) == len(forms) else None

    def written(self, closed: Formula | None) -> Formula | None:
        """A closed form with the variables of its integrals as they are printed."""
        names = {key: name for key, name in self.meanings.names.items() if key != TIME}
        return None if closed is None else in_printed_letters(closed, names)

    def meant(self, typed: Formula) -> Formula:
        """A typed formula with the running time under its own name, and with bare letters at the state that is asked about."""
        names = {bare: Symbol(name) for bare, name in self.bare.items()}
        if self.runs:
            names[self.meanings.time] = Symbol(TIME)
        return typed.substitute(names) if names else typed

    @cached_property
    def bare(self) -> dict[str, str]:
        """Letters that are printed with the name of a state alone, by the letter without it: ω for ω_end where something is asked at the
        end, and nothing else is called so there."""
        keys = {name: key_of(key).when for name, key in self.meanings.keys.items()}
        asked = {keys[name] for name in self.answers if name in keys}
        found: dict[str, list[str]] = {}
        for name, key in keys.items():
            head, _, state = name.partition("_")
            if state and state == key and state in asked and head not in keys and head not in self.givens | self.told:
                found.setdefault(head, []).append(name)
        return {head: names[0] for head, names in found.items() if len(names) == 1}

    @cached_property
    def near(self) -> dict[str, str]:
        """What may be typed for letters of the scene, where no other can be meant, and the laws print none such."""
        from rotsolve.grading.reading.near import near_letters  # most lines have the letters themselves

        return near_letters(self.givens | self.told, {*self.printed, *self.bare})

    @cached_property
    def numbers(self) -> dict[str, float]:
        """The numbers of givens and answers in SI units, as far as they have one."""
        found = {name: certified_number(value, {}) for name, value in self.values.items()}
        numbers = {name: value.float for name, value in found.items() if value is not None}
        for answer in self.solution.derivation.answers:
            factor = certified_number((answer.unit or ONE_UNIT).factor, {})
            if answer.value is not None and factor is not None and not answer.components:
                numbers[answer.name] = answer.value.float * factor.float
        return numbers

    @cached_property
    def dimensions(self) -> dict[str, Dimension]:
        """What each letter measures, as far as it is known."""
        known = {given.name: given.dimension for given in self.problem.givens}
        known |= {answer.name: answer.dimension for answer in self.solution.derivation.answers}
        if self.runs:
            known[TIME] = DURATION
        return {name: dimension for name, dimension in known.items() if dimension is not None}


def targets_of(letters: SceneLetters, same: Same, close: Close) -> Iterator[Target]:
    """What every answer is held against, in the order of the questions."""
    from rotsolve.grading.marking.pointing import level_side, sized_direction

    finds = {find.group: find for find in letters.problem.finds}
    published = {entry.name: entry for entry in letters.problem.answers}
    for answer in letters.solution.derivation.answers:
        marking = marking_of(letters.problem.marking, answer.name)
        find, entry = finds[answer.name], published.get(answer.name)
        if answer.word:
            labels = tuple(option.label for option in find.choice.options) if find.choice else ()
            yield Target(answer.name, marking, word=answer.word, options=labels)
            continue
        told = entry is not None and entry.formula is None and not (entry.value or entry.values or entry.formulas)
        rows = answer.rows
        one_row = not rows or len(rows) == 1
        parts = tuple(scalar_of(part, marking, letters, (same, close), one_row) for part in entries_of_answer(answer))
        directed = letters.meanings.directed(answer.name)
        turns = [term.path.quantity for term in find.terms] == ["turns"]
        whole = None if rows else scalar_of(answer, marking, letters, (same, close), directed, turns)
        if whole is not None:
            sized = "" if answer.direction else sized_direction(letters, find)
            level = level_side(letters.problem, find, answer.direction or sized)
            whole = replace(whole, sized=sized, level=level) if sized or level else whole
        directional = told and bool(answer.direction)
        either = [term.path.quantity for term in find.terms if not term.other] == [*EITHER_WAY]
        yield Target(answer.name, marking, whole, parts, labels_of(answer), len(rows) or 1, "", (), directional, either)


def entries_of_answer(answer: Answer) -> tuple[Answer, ...]:
    """The components of a vector, or the entries of a matrix row by row."""
    return tuple(part for row in answer.rows for part in row) or answer.components


def labels_of(answer: Answer) -> tuple[str, ...]:
    """What the components or entries are called: x, y, z of a vector, xx, xy, … of a tensor."""
    if len(answer.rows) > 1:
        return tuple(one + other for one in AXES for other in AXES)
    return tuple(part.name.rpartition("_")[2] for part in answer.components)


def scalar_of(
    answer: Answer,
    marking: Marking,
    letters: SceneLetters,
    compare: tuple[Same, Close],
    directed: bool,
    turns: bool = False,
) -> Scalar:
    """One number or formula of an answer."""
    return Scalar(
        letters.written(answer.closed),
        answer.value,
        answer.unit or ONE_UNIT,
        answer.dimension or NONE,
        marking,
        *compare,
        letters.values,
        letters.dimensions,
        letters.numbers,
        letters.closed,
        answer.direction,
        answer.positive,
        directed,
        turns,
    )
