"""Results: answers as they are printed: the exact form, the certified value in a unit, the direction in words, why there is no number."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate, multiple_of
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ELLIPTIC, ONE, PI, ZERO, Call, Formula, Product, Quotient, Symbol
from rotsolve.algebra.units.dimension import ANGLE, word_of
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.derivation import Answer, Derivation, Equality, Words
from rotsolve.core.equation import COMPONENTS
from rotsolve.core.letters import system_told
from rotsolve.core.symbols import TIME, has_quantities
from rotsolve.core.vectors.tensor import ENTRIES, ONE_AXIS
from rotsolve.core.writing import spoken
from rotsolve.derivation.directions import Directions
from rotsolve.derivation.letters import Letters
from rotsolve.language.problem import ANY_TIME, Body, Find, Given, Problem, Term, TimeValue
from rotsolve.questions.find import Asked, component
from rotsolve.search.answers import Answered, Chosen
from rotsolve.search.search import Search
from rotsolve.solver.steps import Found


def with_missing_told(derivation: Derivation, problem: Problem) -> Derivation:
    """The derivation with a remark at each answer that has no number since the scene leaves a mass or a size out."""
    missing = {given.name: given for given in problem.givens if given.automatic and given.value is None}
    return replace(derivation, answers=tuple(with_reason(answer, missing, problem) for answer in derivation.answers))


def with_reason(answer: Answer, missing: Mapping[str, Given], problem: Problem) -> Answer:
    if answer.formula is None or answer.remark:
        return answer
    numbered = {given.name for given in problem.givens if given.value is not None}
    if answer.value is None and answer.formula.symbols() <= numbered:
        return replace(answer, remark=(f"no number: {undefined(answer.formula, problem)}",))
    names = [name for name in missing if name in answer.formula.symbols()]
    if not names:
        return answer
    words: list[str | Formula] = ["no number: "]
    for name in names:
        words += [" " if name != names[0] else "", Symbol(name), f", the {meaning_of_given(missing[name], problem)},"]
    return replace(answer, remark=(*words, " is not given" if len(names) == 1 else " are not given"))


def undefined(formula: Formula, problem: Problem) -> str:
    """Why a formula has no number with these givens."""
    try:
        evaluate(formula, {given.name: given.value for given in problem.givens if given.value is not None}, digits=4)
    except (Undefined, ZeroDivisionError) as reason:
        return str(reason)
    return "with these givens it is not defined"


def meaning_of_given(given: Given, problem: Problem) -> str:
    """What an automatic letter stands for, and where it could be given: "mass of block in line 4"."""
    kind = word_of(given.dimension) or "value"
    owner = given.name.partition("_")[2]
    body = next((body for body in every_body(problem.bodies) if body.name in (owner, owner.rstrip("_"))), None)
    if body is None:
        return f"{kind} of {spoken(owner.rstrip('_'))}"
    line = f" in line {body.span.line}" if body.span is not None else ""
    size = "radius" if kind == "length" and given.name.startswith("R") else kind
    return f"{size} of {spoken(body.name)}{line}"


def every_body(bodies: Iterable[Body]) -> Iterator[Body]:
    """Bodies with the parts that they are made of."""
    for body in bodies:
        yield body
        yield from every_body(part.body for part in body.parts)


LONG = 220  # nodes of a formula beyond which it is left in letters found before
DIGITS = 4  # of an angle that is told in a remark
FEW, MANY, SHORTER = 40, 120, 3  # nodes of one with elliptic functions; of one that is so many times shorter in letters


NAMING = ("torque", "impulse", "frequency")  # quantities whose unit the dimension alone does not tell


class Results(Struct, frozen=True):
    """The answers of a search in the letters of its derivation."""

    search: Search
    letters: Letters
    at: TimeValue | None = None  # when functions of time are evaluated

    def answers(self) -> tuple[Answer, ...]:
        """All answers in the order in which the scene asks; the entries of a matrix or vector as one."""
        groups: dict[str, list[Answered | Chosen]] = {}
        for item in self.search.in_order():
            groups.setdefault(item.find.group, []).append(item)
        return tuple(self._group(name, group) for name, group in groups.items())

    def _group(self, name: str, group: list[Answered | Chosen]) -> Answer:
        """A label, or what is answered under one name."""
        labels = [item for item in group if isinstance(item, Chosen)]
        whole = [item for item in group if isinstance(item, Answered)]
        return self.label(labels[0]) if labels else self._whole(name, whole)

    def _whole(self, name: str, group: list[Answered]) -> Answer:
        """One answer, or a matrix or vector with its entries as components."""
        parts = tuple(self.answer(answered) for answered in group)
        if not group[0].asked.find.whole:
            return parts[0]
        entries = tuple(replace(part, name=part.name.removeprefix(f"{name}_")) for part in parts)
        alike: dict[str, list[str]] = {}
        for answered, part in zip(group, entries, strict=True):
            if part.name in ONE_AXIS:
                alike.setdefault(answered.asked.letter, []).append(f"I_{part.name}")
        equal = [" = ".join(names) for names in alike.values() if len(names) > 1]
        products = [part for part in entries if part.name in ENTRIES and part.name not in ONE_AXIS]
        vanish = products and all(part.formula == ZERO for part in products)
        said = [*equal, *(["the products of inertia vanish"] if vanish else [])]
        remark: Words = (f"by symmetry {', and '.join(said)}",) if said else ()
        first = entries[0]
        return Answer(name, Symbol(name), None, None, first.unit, first.dimension, components=entries, remark=remark)

    def answer(self, answered: Answered) -> Answer:
        """The exact form, the certified value and the direction in words."""
        asked, found = answered.asked, answered.found
        formula = self.letters.printed(self._readable(answered)) if found.formula is not None else None
        unit = asked.find.unit or usual_unit(asked, self.search.scene.configuration.problem)
        value = self._value_in(found, unit) if self._lasts(asked.find) is not False else None
        parts = self.components(answered)
        ways = Directions(self.search, answered)
        direction = ways.words(value, parts)
        return Answer(
            asked.find.name,
            self._symbol(asked),
            formula,
            value,
            unit,
            asked.dimension,
            direction,
            components=parts if asked.resolves else (),
            angle=self._slope(parts) if asked.points else None,
            remark=self._when(answered) or self._counted_round(answered),
            brief=not answered.parts or any(part.formula == ZERO for part in parts),
            closed=found.formula,
            positive=ways.positive,
            until=self._until(answered),
            rivals=self._rivals(asked),
            pointing=self.letters.words(ways.condition() if value is None and not direction else ()),
            leading=self._leading(found, unit),
        )

    def _leading(self, found: Found, unit: Unit | None) -> Words:
        """ "≈ 2 m g/M = 0.0392 m/s² for m ≪ M", of what the scene assumes to be small."""
        problem = self.search.scene.configuration.problem
        if problem.space or not problem.assume or found.formula is None or has_quantities(found.formula):
            return ()
        from rotsolve.derivation.leading import leading_words

        factor = unit.factor if unit is not None else ONE
        told = leading_words(found.formula, unit, self.search, lambda form: self.value(form / factor))
        return self.letters.words(told)

    def _rivals(self, asked: Asked) -> tuple[Formula, ...]:
        """What else the equation lets a letter of the scene be that a question settles."""
        roots = (self.search.solver.with_found(root) for root in self.search.rivals.get(asked.letter, ()))
        return tuple(root for root in roots if not has_quantities(root))

    def _when(self, answered: Answered) -> Words:
        """The time at which a function of time has the value that is printed, between which states it does, or that it is no time of its
        phase."""
        found, find = answered.found, answered.asked.find
        if found.formula is None or not find.runs:
            return ()
        begun = [state for state, sign, held in self._ends(find) if sign > 0 and held is None]
        end = self._until(answered)
        part = ", ".join(
            (*(f"from {spoken(state)} on" for state in begun[:1]), *([f"up to {spoken(end)}"] if end else ()))
        )
        if self.at is None:
            return (part,) if part else ()
        moment: Words = (self.letters.printed(Symbol(TIME)), f" = {self.at.text}")
        if self._lasts(find) is False:
            return (*moment, " is not in this phase")
        if TIME in found.formula.symbols():
            return (f"{part}, at " if part else "at ", *moment)
        return (part,) if part else ()

    def _counted_round(self, answered: Answered) -> Words:
        """A direction below 0 that a size and an angle tell, as it is counted from 0 to 360°."""
        pool, angle = self.search.planner.pool, answered.found.formula
        by_parts = any(pool[index].law == COMPONENTS for index in answered.used)
        if angle is None or answered.asked.dimension != ANGLE or not by_parts:
            return ()
        value, round_on = (self.value(turned * 180 / PI) for turned in (angle, angle + 2 * PI))
        if value is None or round_on is None or value.sign != -1:
            return ()
        return (f"{round_on.figures(DIGITS)[0]}° counted to 360°",)

    def _until(self, answered: Answered) -> str:
        """The state up to which a function of time holds: one on the way, or any that letters do not tell to be after the moment at which
        it is told; nothing where that is known to be before it."""
        find = answered.asked.find
        if answered.found.formula is None or not find.runs:
            return ""
        if self.at is not None:
            return next((state for state, sign, held in self._ends(find) if sign < 0 and held is None), "")
        return next(filter(None, (self._end(term) for term in find.terms if term.at == ANY_TIME)), "")

    def _end(self, term: Term) -> str:
        """The state at which the laws end by which a function of time is told, where the scene does not name it."""
        from rotsolve.questions.functions_of_time import phases_of

        timeline = self.search.scene.configuration.timeline
        end = phases_of(term, self.search.scene)[-1].end
        return end if timeline.state(end).opened else ""

    def _lasts(self, find: Find) -> bool | None:
        """Whether the phases of a function of time hold the moment at which it is evaluated; None where letters do not tell."""
        held = [held for *_, held in self._ends(find)]
        return False if False in held else None if None in held else True

    def _ends(self, find: Find) -> Iterator[tuple[str, int, bool | None]]:
        """The states between which a function of time holds, +1 for the first and −1 for the last, and whether the moment at which it is
        evaluated lies on that side of them; None where letters do not tell."""
        if self.at is None:
            return
        scene, beside = self.search.scene, self.search.beside()
        from rotsolve.questions.functions_of_time import phases_of

        for term in find.terms:
            if term.at != ANY_TIME:
                continue
            named = phases_of(term, scene)
            ends = [(named[0].start, 1)]
            if scene.configuration.timeline.after(named[-1].end) is not None:  # else it goes on as before
                ends.append((named[-1].end, -1))
            for state, sign in ends:
                end = beside.settle(scene.instant(state).time()) if beside is not None else None
                gap = self.value(sign * (self.at.value - end)) if end is not None else None
                yield state, sign, None if gap is None else gap.float >= 0

    def label(self, chosen: Chosen) -> Answer:
        """The answer to a choice: the label, with the comparisons as its reason."""
        name = chosen.find.name
        sides = [self.answer(side) for side in chosen.sides]
        weighed = tuple(form for side in sides if (form := side.closed or side.formula) is not None)
        word, reason = chosen.word, self.reason(chosen)
        return Answer(name, Symbol(name), None, None, None, None, word=word, remark=reason, weighed=weighed)

    def reason(self, chosen: Chosen) -> Words:
        """c: 4 rad > 3.142 rad; a: 3 rad ≤ 3.142 rad: what was chosen first."""
        words: list[str | Formula] = []
        for verdict in sorted(chosen.verdicts, key=lambda item: not item.holds):
            words += ["; " if words else "", f"{verdict.label}: "]
            if verdict.own is not None:
                words += self.amount(verdict.own)
                continue
            for number, item in enumerate(verdict.compared):
                words += [", " if number else "", *self.amount(item.left), f" {item.relation} "]
                words += self.amount(item.right)
        return tuple(words)

    def amount(self, answered: Answered) -> Words:
        """A quantity by its number with the unit, else by its letter."""
        answer = self.answer(answered)
        if answer.value is None:
            return (answer.formula or answer.symbol,)
        unit = "" if answer.unit is None else answer.unit.text
        try:
            return (f"{answer.value.text(4)} {unit}".strip(),)
        except Undefined:
            return (answer.symbol,)

    def _symbol(self, asked: Asked) -> Formula:
        """The letter of an answer: its own name; of a component the letter that the derivation uses, if it does."""
        name = Symbol(self.letters.of_find(asked.find))
        printed = self.letters.printed(Symbol(asked.letter)) if asked.whole else name
        return Symbol(asked.find.name) if has_quantities(printed) else printed

    def components(self, answered: Answered) -> tuple[Answer, ...]:
        """The x and y parts of a vector: as the derivation found them, else worked out aside."""
        if answered.parts:
            return tuple(self.answer(part) for part in answered.parts)
        vector = answered.asked.vector
        if vector is None:
            return ()
        found = []
        for axis in "xy":
            part = component(answered.asked, vector, axis)
            value = self._settled(part.formula)
            if has_quantities(value):
                return ()
            found.append(self.answer(Answered(part, Found(part.letter, value), ())))
        return tuple(found)

    def _settled(self, value: Formula) -> Formula:
        """A formula with all letters of the laws worked out, as far as they can be."""
        value = self.search.solver.with_answers(self._solved(value))
        if has_quantities(value):
            value = self.search.apart().settled(value) or value
        return self.search.solver.simplify(value)

    def _slope(self, parts: tuple[Answer, ...]) -> Certified | None:
        """The angle of a slanted vector to the horizontal, in degrees."""
        x, y = (part.formula for part in parts) if parts else (None, None)
        if x is None or y is None or not all(part.value is not None and part.value.sign for part in parts):
            return None
        return self.value(Call("atan", (Call("abs", (y / x,)),)) * 180 / PI)

    def _readable(self, answered: Answered) -> Formula:
        """The closed form; one that no page would hold stays in the letters found before."""
        formula = answered.found.formula
        assert formula is not None
        alike = (item.steps for item in self.search.answered if item.asked.letter == answered.asked.letter)
        own = next((steps for steps in alike if steps[0] < steps[1]), answered.steps)  # of what was settled before, too
        steps = self.search.solver.steps[slice(*own)]
        return readable(steps[-1].chain)[-1].right if steps and length(formula) > FEW else formula

    def _value_in(self, found: Found, unit: Unit | None) -> Certified | None:
        """The certified value in a unit."""
        factor = unit.factor if unit is not None else ONE
        if found.formula is not None:
            return self.value(found.formula / factor)
        number = found.number
        if number is None or factor == ONE:
            return number
        return multiple_of(number, ONE / factor)

    def value(self, formula: Formula) -> Certified | None:
        values = {**self.search.values, **({} if self.at is None else {TIME: self.at.value})}
        letters = formula.symbols() - set(values)
        solved = self.search.solver.solved
        roots = {name: number for name in letters if name in solved and (number := solved[name].number) is not None}
        if letters - set(roots):
            return None
        try:
            return evaluate(formula, values, roots=roots)
        except Undefined:
            return None

    def _solved(self, value: Formula) -> Formula:
        """All letters in a formula by what the steps found for them."""
        for step in reversed(self.search.solver.steps):
            if step.result in value.symbols():
                value = value.substitute({step.result: step.chain[-1].right})
        return value


def readable(chain: tuple[Equality, ...]) -> tuple[Equality, ...]:
    """A chain of equalities without a last one that no page would hold, where the one before tells the same letter."""
    if len(chain) < 2 or not hard_to_read(chain[-1].right, length(chain[-2].right)):
        return chain
    told = chain[-2].left == chain[-1].left and not chain[-2].left.symbols() & chain[-2].right.symbols()
    return chain[:-1] if told else chain


def without_reordered(chain: Sequence[Equality]) -> tuple[Equality, ...]:
    """A chain of equalities without those that the next one only writes in another order."""
    later = (*chain[1:], None)
    return tuple(one for one, after in zip(chain, later, strict=True) if after is None or not same_factors(one, after))


def same_factors(one: Equality, after: Equality) -> bool:
    """Whether two equalities have the same left side, and products of the same factors on their right."""
    if one.left != after.left or one.right.symbols() != after.right.symbols():
        return False
    return above_and_below(one.right) == above_and_below(after.right)


def above_and_below(formula: Formula) -> tuple[Counter[Formula], Counter[Formula]]:
    """The factors of a product, and those below the line, in no order."""
    if isinstance(formula, Quotient):
        (above, below), (under, over) = above_and_below(formula.numerator), above_and_below(formula.denominator)
        return above + over, below + under
    parts = formula.factors if isinstance(formula, Product) else (formula,)
    return Counter(parts), Counter()


def hard_to_read(formula: Formula, lettered: int) -> bool:
    """Whether a formula is rather left in letters found before, in which it has so many nodes: arguments of elliptic functions can not
    be seen through, nor those of an angle that is told by two lengths."""
    longest = MANY if lettered * SHORTER < length(formula) else LONG
    return length(formula) > (FEW if formula.holds(*ELLIPTIC, "atan2") else longest) and lettered <= LONG


def usual_unit(asked: Asked, problem: Problem) -> Unit | None:
    """The unit that the field uses for a dimension, in the system of all givens; none for a pure number."""
    if asked.dimension is None:
        return None
    quantity = asked.find.terms[0].path.quantity if len(asked.find.terms) == 1 else ""
    kind = quantity if quantity in NAMING else ""
    system = system_told(problem.givens)
    if system is not None:
        from rotsolve.algebra.units.systems import unit_in

        return unit_in(system, asked.dimension, kind) or unit_for(asked.dimension, kind or None)
    return unit_for(asked.dimension, kind or None)
