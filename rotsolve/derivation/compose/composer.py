"""Compose: a solved search as a derivation: its head, sections in the order of time, numbered laws, steps, answers."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import Check, Derivation, Equality, LawLine, Move, Section, Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY
from rotsolve.core.registry import SEPARATOR, TIME
from rotsolve.core.writing import spoken
from rotsolve.derivation.compose.comparisons import comparisons
from rotsolve.derivation.compose.diagrams import Diagrams
from rotsolve.derivation.compose.draft import Draft, drafts_of, title
from rotsolve.derivation.compose.letters import Letters
from rotsolve.derivation.compose.result import Results, readable
from rotsolve.derivation.compose.states import state_words
from rotsolve.language.problem import Problem, TimeValue
from rotsolve.search.search import Search
from rotsolve.solver import Ref, Step

SENTENCES = (ENERGY, ANGULAR_MOMENTUM)  # the remarks of these laws are sentences of their own


class Composer:
    """Turns what a search found into a derivation."""

    def __init__(self, search: Search, first: int = 1, at: TimeValue | None = None) -> None:
        self.search = search
        self.first = first  # number of the first equation
        self.scene = search.scene
        self.problem: Problem = self.scene.configuration.problem
        self.pool = search.planner.pool
        self.drafts = drafts_of(search)
        self.diagrams = Diagrams(self.scene, self.pool)
        self.letters = Letters(search, self.drafts, self.diagrams)
        self.numbers = self._numbers()
        self.results = Results(search, self.letters, at)

    def derivation(self, checks: tuple[Check, ...], before: tuple[Section, ...] = ()) -> Derivation:
        """The whole derivation; `before` are sections that decide something first, such as stick or slip."""
        sections = [*before, *(self._section(draft) for draft in self.drafts)]
        if len(sections) == 1:
            sections = [Section("", sections[0].forces, sections[0].remarks, sections[0].laws, sections[0].moves)]
        return Derivation(
            title=self.problem.title,
            source=self.problem.source,
            givens=tuple(
                given for given in self.problem.givens if given.value is not None and self.letters.tells(given.name)
            ),
            finds=tuple(dict.fromkeys((Symbol(item.find.group),) for item in self.search.in_order())),
            states=tuple(state_words(state, self._reached(state.name)) for state in self.problem.states),
            conventions=self._conventions(),
            sections=tuple(sections),
            answers=self.results.answers(),
            checks=checks,
            equations_written=len(self.scene.equations),
            equations_used=sum(len(draft.laws) for draft in self.drafts),
        )

    def _reached(self, state: str) -> str:
        """What is said of a state that has no lines of its own."""
        before = self.scene.configuration.timeline.before(state)
        return "the clock starts" if before is None else "as the event leaves it" if before.event else "later"

    # sections

    def _section(self, draft: Draft) -> Section:
        laws = tuple(self._law(index) for index in draft.laws)
        moves = [move for step in draft.steps for move in (self._move(step), *self._slope(step))]
        moves += [move for chosen in draft.choices for move in comparisons(chosen, self.results)]
        forces = self.diagrams.lines(draft, self.letters.in_use, self.letters.words)
        return Section(title(draft.key, self.scene), forces, self._remarks(draft), laws, tuple(moves))

    def _law(self, index: int) -> LawLine:
        equation = self.pool[index]
        remark = () if equation.family in SENTENCES else equation.remark
        return LawLine(
            self.numbers[("law", index)],
            equation.label,
            Equality(self.letters.printed(equation.left), self.letters.printed(equation.right), equation.relation),
            self.letters.words(remark),
        )

    def _move(self, step: Step) -> Move:
        chain = tuple(
            Equality(self.letters.printed(one.left), self.letters.printed(one.right)) for one in readable(step.chain)
        )
        number = self.numbers.get(("step", step.number))
        return Move(self._sources(step), chain, number, self.letters.words(step.reason))

    def _slope(self, step: Step) -> Iterator[Move]:
        """Behind the step that gives the size of a vector its direction."""
        for answered in self.search.wholes():
            if answered.parts and answered.steps[0] < answered.steps[1] == step.number:
                from rotsolve.derivation.compose.slope import slope

                move = slope(self.results.answer(answered), self.results)
                if move is not None:
                    yield move

    def _sources(self, step: Step) -> str:
        """(3) and (4) in (2)."""
        target = self._mark(step.target)
        sources = [self._mark(ref) for ref in step.sources if ref != step.target]
        marks = list(dict.fromkeys(mark for mark in sources if mark and mark != target))
        marks.sort(key=lambda mark: (mark.startswith("("), int(mark[1:-1]) if mark.startswith("(") else 0))
        if not marks:
            return f"from {target}" if target else ""
        listed = marks[0] if len(marks) == 1 else ", ".join(marks[:-1]) + " and " + marks[-1]
        return f"{target} with {listed}" if step.target[0] == "words" else f"{listed} in {target}"

    def _mark(self, ref: Ref) -> str:
        if ref[0] == "words":
            return str(ref[1])
        if ref[0] == "known":
            return name_to_text(self.letters.names.get(str(ref[1]), str(ref[1])))
        number = self.numbers.get(ref)
        return f"({number})" if number is not None else ""

    def _numbers(self) -> dict[Ref, int]:
        """Running numbers of laws, and of the steps that a later one uses, in the order of printing."""
        used = {ref for step in self.search.solver.steps for ref in (step.target, *step.sources) if ref[0] == "step"}
        numbers: dict[Ref, int] = {}
        for draft in self.drafts:
            for index in draft.laws:
                numbers[("law", index)] = len(numbers) + self.first
            for step in draft.steps:
                if ("step", step.number) in used:
                    numbers[("step", step.number)] = len(numbers) + self.first
        return numbers

    def _remarks(self, draft: Draft) -> tuple[Words, ...]:
        """Why what is conserved is conserved, as sentences."""
        remarks = {
            self.pool[index].remark: None
            for index in draft.laws
            if self.pool[index].family in SENTENCES and self.pool[index].remark
        }
        return tuple(self.letters.words(remark) for remark in remarks)

    # head

    def _conventions(self) -> tuple[Words, ...]:
        angles = any(name.startswith("angle" + SEPARATOR) for name in self.scene.registry.quantities)
        said: list[Words] = [("angles from the rightward horizontal, counterclockwise positive",)] if angles else []
        configuration = self.scene.configuration
        if configuration.mentions.functions:
            first = configuration.timeline.states[0].name
            said.append(
                (self.letters.printed(Symbol(TIME)), f" = 0 at {spoken(first)}" if first else " is the running time")
            )
        for swing in self.scene.swings.values():
            what = "angle turned" if swing.turns else "displacement"
            said.append((self.letters.printed(swing.coordinate), f": {what} from the equilibrium"))
            said += [(f"{spoken(name)} is so long that it keeps its direction",) for name in swing.long]
        return tuple(dict.fromkeys(said))
