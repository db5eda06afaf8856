"""Compose: a solved inquiry as a derivation: letters, sections in the order of time, numbered laws, steps, answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from rotsolve.algebra.formula import Formula, Integral, Symbol
from rotsolve.algebra.notation.letters import PRIME, name_to_text
from rotsolve.core.derivation import Check, Derivation, Equality, ForceLine, LawLine, Move, Section, Words
from rotsolve.core.equation import NEWTON
from rotsolve.core.facts import Facts, Force
from rotsolve.core.registry import SEPARATOR, TIME
from rotsolve.core.writing import spoken
from rotsolve.inquiry.answering import Inquiry
from rotsolve.inquiry.compose.comparisons import comparisons
from rotsolve.inquiry.compose.draft import Draft, drafts_of, title
from rotsolve.inquiry.compose.result import Results, readable
from rotsolve.inquiry.compose.slope import slope
from rotsolve.inquiry.compose.states import state_words
from rotsolve.motion.freebody import free_bodies
from rotsolve.scene.model import Find, Moment, Problem
from rotsolve.solver import Ref, Step

SENTENCES = ("energy", "angular-momentum")  # the remarks of these laws are sentences of their own
SECOND_LAW = "Newton's second law"
UNSEEN = ("reaction", "grip")  # told in a free-body diagram only where an equation speaks of them
WITH_FORCES = ("newton", "energy", "angular-momentum")


class Composer:
    """Turns what an inquiry found into a derivation."""

    def __init__(self, inquiry: Inquiry, first: int = 1, at: Moment | None = None) -> None:
        self.inquiry = inquiry
        self.first = first  # number of the first equation
        self.history = inquiry.history
        self.problem: Problem = self.history.arrangement.problem
        self.pool = inquiry.planner.pool
        self.drafts = drafts_of(inquiry)
        self.names = self._names()
        self.numbers = self._numbers()
        self.results = Results(inquiry, self.printed, self._named, at)

    def derivation(self, checks: tuple[Check, ...], before: tuple[Section, ...] = ()) -> Derivation:
        """The whole derivation; `before` are sections that decide something first, such as stick or slip."""
        sections = [*before, *(self._section(draft) for draft in self.drafts)]
        if len(sections) == 1:
            sections = [Section("", sections[0].forces, sections[0].remarks, sections[0].laws, sections[0].moves)]
        return Derivation(
            title=self.problem.title,
            source=self.problem.source,
            givens=tuple(
                given for given in self.problem.givens if given.value is not None and self._spoken_of(given.name)
            ),
            finds=tuple(dict.fromkeys((Symbol(item.find.group),) for item in self.inquiry.in_order())),
            states=tuple(state_words(state, self._reached(state.name)) for state in self.problem.states),
            conventions=self._conventions(),
            sections=tuple(sections),
            answers=self.results.answers(),
            checks=checks,
            equations_written=len(self.history.equations),
            equations_used=sum(len(draft.laws) for draft in self.drafts),
        )

    def _reached(self, state: str) -> str:
        """What is said of a state that has no lines of its own."""
        before = self.history.arrangement.timeline.before(state)
        return "the clock starts" if before is None else "as the event leaves it" if before.event else "later"

    # sections

    def _section(self, draft: Draft) -> Section:
        laws = tuple(self._law(index) for index in draft.laws)
        moves = [move for step in draft.steps for move in (self._move(step), *self._slope(step))]
        moves += [move for chosen in draft.choices for move in comparisons(chosen, self.results)]
        return Section(title(draft.key, self.history), self._forces(draft), self._remarks(draft), laws, tuple(moves))

    def _law(self, index: int) -> LawLine:
        equation = self.pool[index]
        remark = () if equation.family in SENTENCES else equation.remark
        return LawLine(
            self.numbers[("law", index)],
            equation.label,
            Equality(self.printed(equation.left), self.printed(equation.right), equation.relation),
            self.words(remark),
        )

    def _move(self, step: Step) -> Move:
        chain = tuple(Equality(self.printed(one.left), self.printed(one.right)) for one in readable(step.chain))
        number = self.numbers.get(("step", step.number))
        return Move(self._sources(step), chain, number, self.words(step.reason))

    def _slope(self, step: Step) -> Iterator[Move]:
        """Behind the step that gives the size of a vector its direction."""
        for answered in self.inquiry.wholes():
            if answered.parts and answered.steps[0] < answered.steps[1] == step.number:
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
            return name_to_text(self.names.get(str(ref[1]), str(ref[1])))
        number = self.numbers.get(ref)
        return f"({number})" if number is not None else ""

    def _numbers(self) -> dict[Ref, int]:
        """Running numbers of laws, and of the steps that a later one uses, in the order of printing."""
        used = {ref for step in self.inquiry.solver.steps for ref in (step.target, *step.sources) if ref[0] == "step"}
        numbers: dict[Ref, int] = {}
        for draft in self.drafts:
            for index in draft.laws:
                numbers[("law", index)] = len(numbers) + self.first
            for step in draft.steps:
                if ("step", step.number) in used:
                    numbers[("step", step.number)] = len(numbers) + self.first
        return numbers

    def _forces(self, draft: Draft) -> tuple[ForceLine, ...]:
        """Free-body diagrams in words of the bodies whose dynamics a section uses."""
        equations = [self.pool[index] for index in draft.laws]
        names = {name for equation in equations if equation.family in WITH_FORCES for name in equation.bodies}
        facts = self._facts_of(draft)
        if facts is None:
            return ()
        return tuple(self._force_line(body.name, facts, draft.laws) for body in facts.diagrams if body.name in names)

    def _facts_of(self, draft: Draft) -> Facts | None:
        """The facts that a section is about: of its state, of its phase, or of swings; none of an event.

        Where the section of a phase writes Newton's laws at one state alone, they are those of that state.
        """
        timeline, key = self.history.arrangement.timeline, draft.key
        for swing in self.history.swings.values():
            if key in (swing.section, swing.balanced):
                return free_bodies(swing.near if key == swing.section else swing.rest)
        moments = {self.pool[index].section for index in draft.laws if self.pool[index].family == NEWTON}
        if len(moments) == 1 and moments <= set(timeline.order):
            key = moments.pop()
        interval = timeline.interval(key)
        if interval is not None:
            if interval.event is not None:
                return None
            return self.history.facts(interval.start, generic=self.history.varies(interval))
        return self.history.facts(key) if key in timeline.order else None

    def _force_line(self, name: str, facts: Facts, laws: list[int]) -> ForceLine:
        """Forces, with their letters where equations speak of them, and in brackets those that have no say in them."""
        body = facts.body(name)
        assert body is not None
        pushed = any(
            self.pool[index].label.startswith(SECOND_LAW) and name in self.pool[index].bodies for index in laws
        )
        spoken_of, silent = [], []
        for item in body.acting:
            size = item.size if isinstance(item, Force) else item.torque
            if isinstance(item, Force) and body.motion.kind == "axis" and not pushed and not item.arm.parts:
                silent.append("weight" if item.role == "weight" else str(item.words[0]).strip())
                continue
            letters = {letter for letter in size.symbols() if SEPARATOR in letter}
            if letters <= self._in_use:
                spoken_of.append(self.words(item.words))
            elif item.role not in UNSEEN:
                spoken_of.append(nameless(item.words))
        return ForceLine(spoken(name), tuple(spoken_of), body.positive, without_torque(list(dict.fromkeys(silent))))

    def _remarks(self, draft: Draft) -> tuple[Words, ...]:
        """Why what is conserved is conserved, as sentences."""
        remarks = {
            self.pool[index].remark: None
            for index in draft.laws
            if self.pool[index].family in SENTENCES and self.pool[index].remark
        }
        return tuple(self.words(remark) for remark in remarks)

    # letters

    @cached_property
    def _in_use(self) -> set[str]:
        """Letters that an equation or an answer speaks of."""
        written = {name for draft in self.drafts for name in self._in_equations(draft)}
        return written | {name for item in self.inquiry.answered for name in item.asked.formula.symbols()}

    def _names(self) -> dict[str, str]:
        """Printed names of all quantities that occur."""
        chosen: dict[str, str] = {}
        for answered in self.inquiry.answered:
            if (
                not answered.asked.whole and SEPARATOR not in answered.asked.find.name
            ):  # else it keeps its quantity's letter
                chosen.setdefault(answered.asked.letter, self._named(answered.asked.find))
        taken = frozenset(given.name for given in self.problem.givens)
        every = [part for item in self.inquiry.answered for part in (item, *item.parts)]
        for part in (item for item in every if item.asked.whole and not item.asked.direct):
            twin = next((item for item in self.inquiry.wholes() if item.asked.same_as(part.asked)), None)
            if twin is not None:
                chosen.setdefault(part.asked.letter, twin.asked.find.name)
                continue
            name = part.asked.find.name
            while name in taken | set(chosen.values()):
                name += "_"
            chosen.setdefault(part.asked.letter, name)
        used: dict[str, None] = {}
        for name in self._occurring():
            used[name] = None
        taken = frozenset(given.name for given in self.problem.givens)
        if self.time != TIME:
            chosen[TIME] = self.time
        others = [key for key in used if key not in chosen]
        chosen |= self._running(others, taken | set(chosen.values()), chosen.get(TIME, TIME))
        return self.history.registry.letters(used, taken - set(chosen.values()), chosen)

    @cached_property
    def time(self) -> str:
        """The letter of the running time: an ordinary t where nothing else is."""
        taken = {*(given.name for given in self.problem.givens), *(find.name for find in self.problem.finds)}
        return TIME if "t" in taken else "t"

    def _named(self, find: Find) -> str:
        """The name of an answer; ω(t) where it is a function of time."""
        return f"{find.name}({self.time})" if find.runs else find.name

    def _running(self, used: Iterable[str], taken: frozenset[str], time: str) -> dict[str, str]:
        """Letters for what runs through a phase, the same in every phase: ω(t), or plain ω where it is summed over."""
        quantities, over = self.history.registry.quantities, self._integrated()
        running = [item for key in used if (item := quantities.get(key)) is not None and item.runs]
        owners: dict[str, set[tuple[str, str, str]]] = {}
        for item in running:
            owners.setdefault(item.letter, set()).add((item.kind, item.owner, item.component))
        names = {}
        for item in running:
            alone = len(owners[item.letter]) == 1
            plain = "_".join(filter(None, (item.letter, item.component, "" if alone else item.owner)))
            if item.key in over:
                names[item.key] = plain if plain not in taken else plain + PRIME
                continue
            places = {key for key, inside in over.items() if item.key in inside} - {TIME}
            way = quantities.get(places.pop()) if len(places) == 1 else None
            names[item.key] = f"{plain}({time if way is None else way.letter})"
        return names

    def _integrated(self) -> dict[str, set[str]]:
        """Variables of integration, each with the letters of what is summed over it."""
        found: dict[str, set[str]] = {}
        for draft in self.drafts:
            sides = [side for index in draft.laws for side in (self.pool[index].left, self.pool[index].right)]
            sides += [side for step in draft.steps for one in step.chain for side in (one.left, one.right)]
            for side in sides:
                for node in side.walk():
                    if isinstance(node, Integral):
                        found.setdefault(node.variable, set()).update(node.integrand.symbols())
        return found

    def _occurring(self) -> Iterable[str]:
        """All letters that are printed, in the order in which they occur."""
        for draft in self.drafts:
            yield from self._in_equations(draft)
            yield from self._in_forces(draft)
        for answered in (*self.inquiry.answered, *(side for chosen in self.inquiry.chosen for side in chosen.sides)):
            yield from sorted(answered.asked.formula.symbols())

    def _in_equations(self, draft: Draft) -> Iterator[str]:
        """Letters of the laws and steps of a section."""
        for index in draft.laws:
            yield from sorted(self.pool[index].symbols())
            yield from sorted(bound(self.pool[index].left) | bound(self.pool[index].right))
        for step in draft.steps:
            for one in step.chain:
                yield from sorted(one.left.symbols() | one.right.symbols())
                yield from sorted(bound(one.left) | bound(one.right))

    def _in_forces(self, draft: Draft) -> Iterable[str]:
        """Givens in the forces that a free-body diagram names, supports left out."""
        equations = [self.pool[index] for index in draft.laws]
        names = {name for equation in equations if equation.family in WITH_FORCES for name in equation.bodies}
        facts = self._facts_of(draft)
        for body in facts.diagrams if facts is not None else ():
            if body.name in names:
                for item in body.acting:
                    if item.role not in UNSEEN:
                        letters = (item.size if isinstance(item, Force) else item.torque).symbols()
                        yield from sorted(name for name in letters if SEPARATOR not in name)

    @cached_property
    def letters(self) -> dict[str, Formula]:
        return {key: Symbol(name) for key, name in self.names.items()}

    def words(self, words: Words) -> Words:
        """Words with the letters of the printed derivation."""
        return tuple(self.printed(part) if isinstance(part, Formula) else part for part in words)

    def printed(self, formula: Formula) -> Formula:
        """A formula in printed letters, the variables of integration too."""
        return in_letters(formula, self.names)

    def _spoken_of(self, name: str) -> bool:
        """Whether a given is the scene's own or occurs in what is printed."""
        given = self.inquiry.givens[name]
        if given.span is not None and not given.automatic:
            return True
        printed = set(self._occurring())
        return name in printed or any(
            name in (a.found.formula.symbols() if a.found.formula else ()) for a in self.inquiry.answered
        )

    # head

    def _conventions(self) -> tuple[Words, ...]:
        angles = any(name.startswith("angle" + SEPARATOR) for name in self.history.registry.quantities)
        said: list[Words] = [("angles from the rightward horizontal, counterclockwise positive",)] if angles else []
        arrangement = self.history.arrangement
        if arrangement.mentions.functions:
            first = arrangement.timeline.states[0].name
            said.append((self.printed(Symbol(TIME)), f" = 0 at {spoken(first)}" if first else " is the running time"))
        for swing in self.history.swings.values():
            what = "angle turned" if swing.turns else "displacement"
            said.append((self.printed(swing.coordinate), f": {what} from the equilibrium"))
            said += [(f"{spoken(name)} is so long that it keeps its direction",) for name in swing.long]
        return tuple(dict.fromkeys(said))


def in_letters(formula: Formula, names: Mapping[str, str]) -> Formula:
    """A formula with its letters renamed, the variables of integration too."""

    def change(node: Formula) -> Formula:
        if isinstance(node, Symbol):
            return Symbol(names[node.name]) if node.name in names else node
        if isinstance(node, Integral) and node.variable in names:
            return Integral(node.integrand, names[node.variable], node.lower, node.upper)
        return node

    return formula.transform(change)


def bound(formula: Formula) -> set[str]:
    """Letters inside integrals, bound ones too."""
    inside = [node for node in formula.walk() if isinstance(node, Integral)]
    return {name for node in inside for name in {node.variable, *node.integrand.symbols()}}


def nameless(words: Words) -> Words:
    """The words of a force whose letter no equation has: "normal force, up"."""
    told = [part for part in words if not isinstance(part, Formula)]
    return ("".join(part.rstrip() if k < len(told) - 1 else part for k, part in enumerate(told)),)


def without_torque(silent: list[str]) -> tuple[Words, ...]:
    """Which forces on a body on an axis act at that axis."""
    if not silent:
        return ()
    listed = " and ".join(silent)
    support = "axle" if any(name.startswith("axle") for name in silent) else "pivot"
    verb = "act" if len(silent) > 1 else "acts"
    return ((f"{listed} {verb} at the {support}: no torque about it",),)
