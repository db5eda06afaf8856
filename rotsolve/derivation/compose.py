"""Compose: a solved search as a derivation: its head, sections in the order of time, numbered laws, steps, comparisons, answers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property, partial

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Number, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import (
    Answer,
    Check,
    Cited,
    Derivation,
    Equality,
    LawLine,
    Move,
    Section,
    Trial,
    Words,
    in_a_row,
    sentences,
)
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, LAGRANGE, Equation
from rotsolve.core.facts import BodyFacts, Force
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.symbols import ACCELERATIONS, COORDINATE, TIME, is_key, key_of, of_kinds
from rotsolve.core.vectors.heading import heading
from rotsolve.core.writing import spoken
from rotsolve.derivation.drafts import Diagrams, Draft, drafts_of
from rotsolve.derivation.headings import section_title
from rotsolve.derivation.insights import insights, told_in_letters
from rotsolve.derivation.letters import Letters
from rotsolve.derivation.one_letter import one_letter_for, said_alike
from rotsolve.derivation.results import LONG, Results, readable, without_reordered
from rotsolve.derivation.second_ways import second_way
from rotsolve.derivation.sought import sought_words
from rotsolve.language.problem import Condition, Path, Problem, State, TimeValue
from rotsolve.search.answers import Answered, Chosen
from rotsolve.search.search import Search
from rotsolve.solver.steps import Ref, Step


def state_words(state: State, bare: str, printed: Callable[[Formula], Formula]) -> Words:
    """What the scene says of a state, on one line, with its letters as they are `printed`; `bare` where it says nothing."""
    if state.opened:
        return (f"{spoken(state.name)}: {state.opened}",)
    parts, vectors = list[str](), dict[tuple[str, ...], list[str]]()
    for line in state.conditions:
        if line.rest:
            parts.append("at rest" if line.owner in ("", "all") else f"{spoken(line.owner)} at rest")
        elif line.path is not None:
            value = stated(printed(line.value)) if line.value is not None else line.word or ""
            whole = vector_words(line)
            if whole:
                vectors.setdefault(whole, []).append(value)
                continue
            parts.append(" ".join(word for word in (*line_words(line), value) if word))
    parts += [f"{' '.join(words)} ({', '.join(values)})" for words, values in vectors.items()]
    parts += [
        word for word, so in (("in balance", state.balance), ("steady", state.steady and not state.balance)) if so
    ]
    return (f"{spoken(state.name)}: " + (", ".join(parts) if parts else bare),)


def line_words(line: Condition) -> tuple[str, ...]:
    """Of what a line speaks: "block velocity x"."""
    assert line.path is not None
    owner = spoken(".".join(part for part in (line.path.owner, line.path.point) if part))
    quantity, component = spoken(line.path.quantity), line.path.component or ""
    said = OSCILLATING.get(line.path.quantity)
    what = f"{said} of small swings" if said else quantity
    kind, axis = ("", component) if component in ("x", "y", "z") else (component, "")
    return (owner, kind, what, axis)


def vector_words(line: Condition) -> tuple[str, ...]:
    """The same of a vector of which a line in space tells a component of three; nothing for other lines."""
    path = line.path
    if path is None or not line.whole:
        return ()
    owner = spoken(".".join(part for part in (path.owner, path.point) if part))
    seen = f"relative to {spoken(line.relative)}" if line.relative else f"in {line.axes} axes" if line.axes else ""
    return tuple(word for word in (owner, spoken(path.quantity), seen) if word)


def stated(value: Formula) -> str:
    """A value as a state says it: angles that are multiples of π in degrees."""
    turned = heading(value)
    if not turned.degrees:
        return to_text(value)
    if not turned.terms:
        return f"{turned.degrees}°".replace("-", "−")
    rest = to_text(simplify(value - Number(Fraction(turned.degrees, 180)) * PI))
    if rest.startswith("−") and turned.degrees > 0:
        return f"{turned.degrees}° − {rest[1:]}"
    return f"{rest} {'−' if turned.degrees < 0 else '+'} {abs(turned.degrees)}°"


LETTERS = ("phi", "delta", "psi")


def slope_move(vector: Answer, results: Results) -> Move | None:
    """The line that tells the angle to the horizontal; None where a component is nothing or has no number."""
    if vector.angle is None or vector.brief:
        return None
    x, y = vector.components
    assert x.formula is not None and y.formula is not None
    ratio = y.formula / x.formula
    letter = Symbol(free_letter(vector.name, results))
    tangent = Call("tan", (letter,))
    back = y.value is not None and x.value is not None and y.value.sign != x.value.sign
    sides = Equality(tangent, -(y.symbol / x.symbol) if back else y.symbol / x.symbol)
    chain = (sides,) if length(ratio) > LONG else (sides, Equality(tangent, positive_ratio(ratio, results)))
    return Move(f"direction of {name_to_text(vector.name)}", chain, None, (letter, " to the horizontal"))


def positive_ratio(ratio: Formula, results: Results) -> Formula:
    """The size of a quotient whose sign the numbers tell."""
    value = results.value(ratio)
    return results.search.solver.simplify(-ratio if value is not None and (value.sign or 0) < 0 else ratio)


def unbarred_by_value(node: Formula, results: Results) -> Formula:
    """What stands between bars, or its opposite, where the numbers tell its sign."""
    if not isinstance(node, Call) or node.function != "abs":
        return node
    (inside,) = node.arguments
    value = results.value(results.search.solver.with_found(inside))
    return node if value is None or not value.sign else inside if value.sign > 0 else -inside


def free_letter(name: str, results: Results) -> str:
    """A letter for the angle that the scene does not use; each of several vectors has its own."""
    search = results.search
    taken = {*search.givens, *(item.asked.find.name for item in search.answered)}
    free = next((letter for letter in LETTERS if letter not in taken), f"angle_{LETTERS[0]}")
    alone = sum(bool(item.parts) for item in search.wholes()) == 1
    return free if alone else f"{free}_{name}"


def comparisons(chosen: Chosen, results: Results) -> Iterator[Move]:
    """δ_c > π (4 rad > 3.142 rad), with the label in front."""
    alone = len(results.search.chosen) == 1
    for verdict in chosen.verdicts:
        name = verdict.label if alone else f"{verdict.label} ({name_to_text(chosen.find.name)})"
        for item in verdict.compared:
            numbers = (*results.amount(item.left), f" {item.relation} ", *results.amount(item.right))
            left, right = (compared_formula(side, results) for side in (item.left, item.right))
            told = all(isinstance(word, str) for word in numbers)
            yield Move(name, (Equality(left, right, item.relation),), None, numbers if told else ())


def compared_formula(answered: Answered, results: Results) -> Formula:
    """A compared quantity as the derivation writes it: by its letter, or the givens that it is made of."""
    asked = answered.asked
    return results.letters.printed(asked.formula if asked.of_givens else Symbol(asked.letter))


def mark_name(ref: Ref, names: Mapping[str, str]) -> str:
    """The printed name of an answer found before."""
    return names.get(str(ref[1]), str(ref[1]))


SEVERAL = 2  # letters that hang on others
SENTENCES = (ENERGY, ANGULAR_MOMENTUM, LAGRANGE)  # the remarks of these laws are sentences of their own


def in_sentences(equation: Equation) -> bool:
    """Whether the remark of an equation is a sentence of its own, ahead of the laws."""
    return equation.family in SENTENCES or equation.law.explained


class DerivationComposer:
    """Turns what a search found into a derivation."""

    def __init__(self, search: Search, first: int = 1, at: TimeValue | None = None) -> None:
        self.search = search
        self.first = first  # number of the first equation
        self.scene = search.scene
        self.problem: Problem = self.scene.configuration.problem
        self.pool = search.planner.pool
        self.drafts = drafts_of(search)
        self.diagrams = Diagrams(self.scene, self.pool)
        asked = {item.asked.letter: item.find.whole for item in search.answered}
        laws = [index for draft in self.drafts for index in draft.laws]
        self.tied = one_letter_for(laws, self.pool, search.solver.steps, frozenset(asked))
        self.letters = Letters(search, self.drafts, self.diagrams, dict(self.tied.values()))
        self.other_roots, self.alike = (
            dict[int, int](),
            dict[int, int](),
        )  # laws that an earlier one says already, with that
        if len({(self.pool[index].label, self.pool[index].section) for index in laws}) < len(laws):
            from rotsolve.derivation.written_before import written_before

            self.other_roots, self.alike = written_before(laws, self.pool, asked, search.solver.steps)
        self.numbers = self._numbers()
        self.results = Results(search, self.letters, at)
        self.told: set[Words] = set()  # sentences about a whole scene, which are told once
        self.way = second_way(told_in_letters(search), search)

    def derivation(
        self, checks: tuple[Check, ...], before: tuple[Section, ...] = (), trials: tuple[Trial, ...] = ()
    ) -> Derivation:
        """The whole derivation; `before` are sections that decide something first, such as stick or slip."""
        sections = [*before, *(self._section(draft) for draft in self.drafts)]
        if len(sections) == 1:
            sections = [replace(sections[0], title="")]
        numbered = [given for given in self.problem.givens if given.value is not None]
        return Derivation(
            title=self.problem.title,
            source=self.problem.source,
            givens=tuple(given for given in numbered if self.letters.tells(given.name)),
            finds=self._sought(),
            states=tuple(self._states()),
            conventions=self._conventions(),
            places=tuple(self.scene.places()),
            events=tuple(self._events()),
            sections=tuple(sections),
            answers=self.results.answers(),
            checks=checks,
            equations_written=len(self.search.equations),
            equations_used=sum(1 for draft in self.drafts for _ in self._once(draft.laws)),
            trials=trials,
            insights=tuple(map(self.letters.words, insights(self.search, self._turned_alone(), self.way))),
            second=self._second(),
        )

    def _second(self) -> tuple[Section, ...]:
        """The second way to an answer."""
        if self.way is None:
            return ()
        from rotsolve.derivation.second_told import second_section

        return (second_section(self.way, self),)

    def _turned_alone(self) -> Iterator[tuple[BodyFacts, Force]]:
        """The bodies that one force alone turns, with that force."""
        return (pair for draft in self.drafts for pair in self.diagrams.alone(draft))

    def _reached(self, state: str) -> str:
        """What is said of a state that has no lines of its own."""
        before = self.scene.configuration.timeline.before(state)
        if before is None:
            return "the clock starts"
        return f"just after the {spoken(before.event.name)}" if before.event is not None else "later"

    # sections

    def _section(self, draft: Draft) -> Section:
        laws = tuple(self._grounded_once(draft))
        steps = (step for step in draft.steps if not (step.target[0] == "law" and step.target[1] in self.alike))
        moves = [move for step in steps for move in (self._move(step), *self._slope(step))]
        moves += [move for chosen in draft.choices for move in comparisons(chosen, self.results)]
        forces = self.diagrams.lines(draft, self.letters.in_use, self.letters.words)
        return Section(section_title(draft.key, self.scene), forces, self._remarks(draft), laws, tuple(moves))

    def _grounded_once(self, draft: Draft) -> Iterator[LawLine]:
        """The laws of a section; of the components of one question the first alone has the ground of all beside it."""
        wholes = {item.asked.letter: item.find.whole for item in self.search.answered if not item.asked.direct}
        first: dict[tuple[str, Words], int] = {}
        for index in self._once(draft.laws):
            law, left = self._law(index), self.pool[index].left
            whole = wholes.get(left.name, "") if isinstance(left, Symbol) else ""
            again = whole and first.setdefault((whole, law.remark), law.number) != law.number
            yield replace(law, remark=self._with_alike(index, () if again else law.remark))

    def _once(self, laws: Iterable[int]) -> Iterator[int]:
        """The laws that no earlier one says already."""
        return (index for index in laws if all(index not in said for said in (self.other_roots, self.alike, self.tied)))

    def _with_alike(self, index: int, remark: Words) -> Words:
        """The remark at a law, and of what letters it tells the same."""
        letters = (self.pool[other].left for other, first in self.alike.items() if first == index)
        alike = self.letters.words(in_a_row(letters))
        return (*remark, *(("; ",) if remark else ()), "the same for ", *alike) if alike else remark

    def _law(self, index: int) -> LawLine:
        equation = self.pool[index]
        remark = () if in_sentences(equation) else equation.remark
        return LawLine(
            self.numbers[("law", index)],
            equation.label,
            Equality(self.shown(equation.left), self.shown(equation.right), equation.relation),
            self.letters.words(remark),
            equation.law.name,
            equation.family,
            tuple(map(spoken, equation.bodies)),
        )

    def _move(self, step: Step) -> Move:
        chain = without_reordered(
            [Equality(self.shown(one.left), self.shown(one.right)) for one in readable(step.chain)]
        )
        if len(chain) > 1 and not isinstance(chain[0].left, Symbol) and chain[0] == self._written(step.target):
            chain = chain[1:]  # what is put in is a number
        number = self.numbers.get(("step", step.number))
        sources, reason = self._sources(step), self.letters.words(step.reason)
        into = "" if step.target[0] == "words" else self._mark(step.target)
        if step.target[0] == "law" and step.target[1] in self.other_roots:
            letters = self.letters.printed(Symbol(step.result)).symbols()
            solved = tuple(line for line in chain if not letters & line.right.symbols())
            return Move(f"another root of {into}", solved, number, reason, into=into, another=True)
        own = (step.target, step.divisor)
        others = (ref for ref in step.sources if into and ref not in own and self._mark(ref) not in ("", into))
        put = dict.fromkeys(self._cited(ref, step) for ref in others)
        divisor = self._mark(step.divisor) if step.divisor else ""
        return Move(sources, chain, number, reason, tuple(put), into, divisor=divisor, alone=self._alone(step))

    def _alone(self, step: Step) -> Formula | None:
        """The one unknown that is left where several letters that hang on others are put in."""
        keys = {name for name in step.chain[0].left.symbols() | step.chain[0].right.symbols() if is_key(name)}
        if step.divisor:
            gone = [
                name
                for name in self._told_by(step.target) & self._told_by(step.divisor) - keys
                if of_kinds([name], ACCELERATIONS)
            ]
            return self.letters.printed(Symbol(gone[0])) if len(gone) == 1 else None
        others = [ref for ref in step.sources if ref != step.target]
        hanging = [ref for ref in others if len([*filter(is_key, self._told_by(ref))]) > 1]
        if keys != {step.result} or len(hanging) < SEVERAL or step.chain[0].left == Symbol(step.result):
            return None
        return self.letters.printed(Symbol(step.result))

    def _written(self, ref: Ref) -> Equality | None:
        """An equation as it stands among the laws."""
        return self._law(int(ref[1])).equation if ref[0] == "law" and ref in self.numbers else None

    def shown(self, formula: Formula) -> Formula:
        """A formula in printed letters, without bars round what the numbers tell the sign of: −ω for |ω| of what turns clockwise."""
        return self.letters.printed(formula.transform(partial(unbarred_by_value, results=self.results), "abs"))

    def _cited(self, ref: Ref, step: Step) -> Cited:
        """What a step puts in: the letter that an equation tells, which is gone behind it, and the number of that equation."""
        mark = self._mark(ref)
        if ref[0] == "known":
            return Cited(Symbol(mark_name(ref, self.letters.names)))
        if ref[0] == "step":
            return Cited(self.letters.printed(self._steps[int(ref[1])].chain[-1].left), mark)
        elsewhere = [self._gone(other, step) for other in step.sources if other != ref]
        gone = [name for name in self._gone(ref, step) if [name] not in elsewhere]  # each letter is told by one of them
        equation = self.pool[int(ref[1])]
        alone = [name for name in gone if Symbol(name) in (equation.left, equation.right)]
        told = alone if len(alone) == 1 else gone
        return Cited(self.letters.printed(Symbol(told[0])) if len(told) == 1 else None, mark)

    def _gone(self, ref: Ref, step: Step) -> list[str]:
        """The letters of an equation which others in a step have as well, and which are gone behind it."""
        others = {name for other in (step.target, *step.sources) if other != ref for name in self._told_by(other)}
        left = step.chain[0].left.symbols() | step.chain[0].right.symbols()
        return [name for name in sorted(self._told_by(ref) & others - left) if is_key(name)]

    def _told_by(self, ref: Ref) -> frozenset[str]:
        """The letters of an equation that is cited."""
        if ref[0] == "law":
            return self.pool[int(ref[1])].symbols()
        chain = self._steps[int(ref[1])].chain if ref[0] == "step" else ()
        return chain[-1].left.symbols() | chain[-1].right.symbols() if chain else frozenset()

    @cached_property
    def _steps(self) -> dict[int, Step]:
        """The steps of the search by their numbers."""
        return {step.number: step for step in self.search.solver.steps}

    def _slope(self, step: Step) -> Iterator[Move]:
        """Behind the step that gives the size of a vector its direction."""
        for answered in self.search.wholes():
            if answered.parts and answered.steps[0] < answered.steps[1] == step.number:
                move = slope_move(self.results.answer(answered), self.results)
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
            return name_to_text(mark_name(ref, self.letters.names))
        number = self.numbers.get(ref)
        return f"({number})" if number is not None else ""

    def _numbers(self) -> dict[Ref, int]:
        """Running numbers of laws, and of the steps that a later one uses, in the order of printing."""
        used = {ref for step in self.search.solver.steps for ref in (step.target, *step.sources) if ref[0] == "step"}
        numbers: dict[Ref, int] = {}
        for draft in self.drafts:
            for index in (index for index in draft.laws if index not in self.tied):
                first = self.other_roots.get(index, self.alike.get(index))
                numbers[("law", index)] = (
                    len(set(numbers.values())) + self.first if first is None else numbers["law", first]
                )
            for step in draft.steps:
                if ("step", step.number) in used:
                    numbers[("step", step.number)] = len(set(numbers.values())) + self.first
        return numbers

    def _remarks(self, draft: Draft) -> tuple[Words, ...]:
        """Why what is conserved is, and into what a body is cut, as sentences."""
        laws = [law for law in map(self.pool.__getitem__, draft.laws) if in_sentences(law) and law.remark]
        remarks = dict.fromkeys(line for law in laws for line in sentences(law.remark))
        fresh = [line for line in remarks if line not in self.told]
        self.told.update(line for law in laws if len(lines := sentences(law.remark)) > 1 for line in lines)
        alike = said_alike({index: self.tied[index] for index in draft.laws if index in self.tied}, self.pool)
        return tuple(map(self.letters.words, (*fresh, *alike)))

    # head

    def _sought(self) -> tuple[Words, ...]:
        """What is asked for, a vector once."""
        timeline = self.scene.configuration.timeline
        conditional = {find.name: find for find in self.problem.finds if find.where is not None}
        finds = (conditional.get(item.find.name, item.find) for item in self.search.in_order())
        return tuple(dict.fromkeys(sought_words(find, timeline) for find in finds))

    def _states(self) -> Iterator[Words]:
        """What the scene says of each state."""
        for state in self.problem.states:
            yield state_words(state, self._reached(state.name), self.letters.printed)

    def _events(self) -> Iterator[Words]:
        """What happens at each event."""
        for event in self.problem.events:
            words = self.letters.words(event.told())
            if words:
                yield (f"{spoken(event.name)}: ", *words)

    def _angles(self) -> bool:
        """Whether the page speaks of the angle of a body, and not only of one that is level, at 0."""
        if self.problem.space:
            return False
        kinds = {key_of(name).kind for name in self.letters.names} | {path.quantity for path in self._paths()}
        return not kinds.isdisjoint(("angle", COORDINATE + "angle")) or any(
            swing.turns and self.scene.configuration.heavy for swing in self.scene.swings.values()
        )

    def _paths(self) -> list[Path]:
        """What is asked for, and what states tell, but that it is nothing."""
        told = [line for state in self.problem.states for line in state.conditions if line.value != ZERO]
        asked = [term.path for find in self.problem.finds for term in find.terms]
        return [*asked, *(line.path for line in told if line.path is not None)]

    def _aside(self) -> Iterator[Words]:
        """Of which bodies the angle is that of the direction to a common centre of mass, and not of an axis of their own."""
        turned = [path.owner for path in self._paths() if path.quantity == "angle"]
        configuration = self.scene.configuration
        first = self.scene.instant(configuration.timeline.states[0].name)
        for name in dict.fromkeys(name for name in turned if name in configuration.bodies):
            if first.measured_aside(name):
                whose = "the common" if configuration.cluster(first.host(name), first.state) else "its"
                yield (f"the angle of {spoken(name)} is that of the line from its axis to {whose} centre of mass",)

    def _conventions(self) -> tuple[Words, ...]:
        said: list[Words] = []
        if self._angles():
            said += [("angles from the rightward horizontal, counterclockwise positive",), *self._aside()]
        used = [self.pool[index] for draft in self.drafts for index in draft.laws]
        said += map(self.letters.words, self.scene.conventions(used))
        configuration = self.scene.configuration
        if configuration.mentions.functions:
            first = configuration.timeline.states[0].name
            start = f" = 0 at {spoken(first)}" if first else " is the running time"
            said.append((self.letters.printed(Symbol(TIME)), start))
        for swing in self.scene.swings.values():
            for kind, what in (("rotation", "angle"), ("displacement", "displacement")):
                places = [place for place in swing.coordinates if key_of(place.name).kind == kind]
                shown = [place for place in places if place.name in self.letters.names or swing.number is None]
                if shown:
                    turned = " turned" if kind == "rotation" else ""
                    said.append(
                        (
                            *in_a_row(map(self.letters.printed, shown)),
                            f": {what}{'s' * (len(shown) > 1)}{turned} from the equilibrium",
                        )
                    )
            said += [(f"{spoken(name)} is so long that it keeps its direction",) for name in swing.long]
        return tuple(dict.fromkeys(said))
