"""Solve: the equations of a plan one unknown at a time, the asked one last, keeping every step as a textbook would write it.

Trivial equations (I = ½ M R², a = R α) are put into the others without a line of their own; every other elimination is a step.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

from msgspec import field

from rotsolve.algebra.certified.ball import Certified, decided_by_size, evaluate, rounded_once
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import REMEMBERED, is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ELLIPTIC, ONE, ZERO, Formula, Integral, Symbol
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.equation import ENERGY, FOUND, KINEMATICS, Equation
from rotsolve.core.symbols import ACCELERATIONS, key_of, of_kinds
from rotsolve.matching import Plan
from rotsolve.solver.isolation import LONGEST, TOO_LONG, Isolation
from rotsolve.solver.steps import (
    Contradiction,
    Found,
    Item,
    NoClosedForm,
    NumbersWanted,
    Redundant,
    Ref,
    Step,
    Unprintable,
    elimination_kind,
    held_as_factor,
    inner,
    isolated,
    line_in_letters,
    line_of,
    monomial,
    moved_alone,
    only_squared,
    put_square,
)
from rotsolve.solver.textbook import part_of_whole, quarters_turned, seen_through_no_more, with_constants_in_front

FORCES = ("tension", "force", "normal_force", "friction_force", "impulse")
SHORT_SHARE = 60  # nodes of a share of an energy, with both energies put in, that is a line of its own
MOTION = (*ACCELERATIONS, "velocity", "angular_velocity")
PAIR = 2  # equations of which the one may be divided by the other
ROUNDS = 8  # values put in one after the other, since one may speak of the next
NUMERICALLY: Words = ("no closed form: solved numerically, with certified digits",)
SUMMED_NUMERICALLY: Words = ("no closed form: the integral is worked out numerically, with certified digits",)
UNPRINTABLE: dict[
    frozenset[tuple[Formula, Formula]], None
] = {}  # equations of plans whose closed forms no page can hold
ENTANGLED = "no unknown can be told from the others"

# equation, unknown, its value, and why it is this root; None where the elimination needs no line of its own
Elimination = tuple[Item, str, Formula, "Words | None"]


class Solver(Isolation, kw_only=True):
    """Solves plans one after the other; remembers answers and steps."""

    pool: list[Equation]
    refs: dict[int, Ref] = field(default_factory=dict)
    tried: set[int] = field(default_factory=set)  # the equations of all plans that were tried
    running: frozenset[str] = frozenset(("time",))  # letters that run during a phase
    lone: bool = False  # whether one thing alone is asked, so that nobody needs what is divided out on the way
    steps: list[Step] = field(default_factory=list)
    derived: list[tuple[Equation, Ref]] = field(default_factory=list)
    told: dict[str, Formula] = field(default_factory=dict)  # what was eliminated on the way to the answers

    def solve(self, plan: Plan) -> Found:
        """Carry a plan out; the steps are kept only when it succeeds."""
        kept, derived, told = len(self.steps), len(self.derived), dict(self.told)
        self.tried.update(plan.equations)
        try:
            found = self._in_letters_or_together(plan)
        except (Redundant, Contradiction, NoClosedForm, NumbersWanted, Undefined, ZeroDivisionError) as error:
            del self.steps[kept:], self.derived[derived:]
            self.told = told
            if isinstance(error, ZeroDivisionError):
                raise NoClosedForm("it would take a division by zero") from None
            raise
        self.solved[plan.asked] = found
        return found

    def _in_letters_or_together(self, plan: Plan) -> Found:
        """In letters as far as a page can hold them; else all equations at once, with numbers."""
        if self._rather_a_number(plan):
            self.solved.update(self._told_in_numbers(plan))
            return self.solved[plan.asked]
        kept, told = len(self.steps), dict(self.told)
        told_by = frozenset((self.pool[index].left, self.pool[index].right) for index in plan.equations)
        try:
            if told_by not in UNPRINTABLE:
                return self._solve(plan)
        except Unprintable:
            UNPRINTABLE[told_by] = None
            while len(UNPRINTABLE) > REMEMBERED:
                del UNPRINTABLE[next(iter(UNPRINTABLE))]
        del self.steps[kept:]
        self.told = told
        return self._by_numbers(plan)

    def _rather_a_number(self, plan: Plan) -> bool:
        """Whether a law tells the asked letter that is told by a number, each equation of its plan one by others, all with numbers."""
        laws = [self.pool[index] for index in plan.equations]
        if not any(law.law.numbered and law.left == Symbol(plan.asked) for law in laws):
            return False
        if {law.left for law in laws} != set(map(Symbol, plan.unknowns)):
            return False
        letters = {name for law in laws for name in law.symbols()} - set(plan.unknowns)
        known = {name: self.with_answers(Symbol(name)).symbols() for name in letters}
        numbered = {name for name, found in self.solved.items() if found.number is not None}
        return all(one <= {*self.signs.values, *numbered} for one in known.values())

    def _told_in_numbers(self, plan: Plan) -> dict[str, Found]:
        """The unknowns of a plan in which each equation tells one by others, as numbers."""
        told = {
            law.left.name: law.right for law in (self.pool[k] for k in plan.equations) if isinstance(law.left, Symbol)
        }
        closed = {name: found.formula for name, found in self.solved.items() if found.formula is not None}
        numbers = {name: found.number for name, found in self.solved.items() if found.number is not None}

        def number(name: str) -> Certified:
            if name not in numbers:
                value = self.with_answers(told[name]) if closed.keys() & told[name].symbols() else told[name]
                roots = {other: number(other) for other in sorted(value.symbols() & (told.keys() | numbers.keys()))}
                numbers[name] = rounded_once(evaluate(value, self.signs.values, roots=roots))
            return numbers[name]

        decided_by_size()
        return {name: Found(name, None, number(name)) for name in plan.unknowns}

    def _by_numbers(self, plan: Plan) -> Found:
        """All unknowns of a plan with the numbers of the scene, each to be asked for afterwards."""
        from rotsolve.solver.together import Together, lacking, staged

        stages = staged({index: self.pool[index] for index in plan.equations}, plan.unknowns)
        closed = {name: found.formula for name, found in self.solved.items() if found.formula is not None}
        known = {name: found.number for name, found in self.solved.items() if found.number is not None}
        missing = lacking(stages, (*closed, *known, *self.signs.values))
        if missing:
            raise NumbersWanted(f"{TOO_LONG}: give a number to {', '.join(f'`{name}`' for name in missing[:3])}")
        runs = {name for value in closed.values() for name in value.symbols() & self.running} - self.signs.values.keys()
        if runs:
            raise NumbersWanted(f"{TOO_LONG} at any time: ask for it at a state that tells its time")
        numbers = Together(stages, {**self.signs.values, **closed}, known).numbers()
        found = {name: Found(name, None, number) for name, number in numbers.items()}
        refs = [self.refs.get(index, ("law", index)) for index in plan.equations]
        last = self.pool[plan.equations[-1]]
        item = Item(refs[-1], plan.equations[-1], last.left, last.right, last.section, list(refs[:-1]))
        self._keep(
            item, [Equality(item.left, item.right)], plan.asked, (f"{TOO_LONG}: solved together with the numbers",)
        )
        self.solved.update(found)
        return found[plan.asked]

    def with_found(self, value: Formula) -> Formula:
        """Answers put in, and what was eliminated on the way to them; not what leads back to itself, as x by ω(x) once x is sought."""
        put = set[str]()
        for _ in range(ROUNDS):
            value = self.with_answers(value)
            names = [name for name in value.symbols() if name in self.told]
            used = {name: self.told[name] for name in names if name not in put or not self._leads_back(name)}
            if not used:
                break
            put.update(used)
            value = value.substitute(used)
        return value

    def _leads_back(self, name: str) -> bool:
        """Whether what tells a letter speaks of it again, by way of answers and of what was eliminated."""
        seen, todo = set[str](), [name]
        while todo:
            one = todo.pop()
            answer = self.solved.get(one)
            telling = self.told.get(one) if answer is None or answer.formula is None else answer.formula
            new = telling.symbols() - seen if telling is not None else ()
            seen.update(new)
            todo += new
        return name in seen

    def _solve(self, plan: Plan) -> Found:
        """Eliminate one unknown after the other, until the last equation holds the asked one alone."""
        laws = [(index, self.pool[index]) for index in plan.equations]
        items = [Item(self.refs.get(k, ("law", k)), k, law.left, law.right, law.section) for k, law in laws]
        for item in items:
            self._put_in_functions(item)
            self._divide(item)
        unknowns = set(plan.unknowns)
        while len(items) > 1:
            if len(items) == PAIR and self._divide_one_by_other(items, unknowns, plan.asked):
                break
            found = self._next(items, unknowns, plan.asked) or self._within_function(items, unknowns, plan.asked)
            item, name = found[:2] if found else self._eliminate_square(items, unknowns, plan.asked)
            items.remove(item)
            unknowns.discard(name)
            if found is not None:
                self._eliminate(items, *found, unknowns)
        if items[0].unknowns(unknowns) - {plan.asked}:
            raise Redundant(items[0].index)  # an unknown was left over, so that two of the equations said the same
        return self._last(items[0], plan.asked)

    def _put_in_functions(self, item: Item) -> None:
        """Answers that run during a phase are put in at once (a letter would hide what is integrated), and so are zeros; elliptic ones
        only where something is integrated."""
        held = item.left.symbols() | item.right.symbols() | inner(item)
        solved = [(name, found.formula) for name, found in self.solved.items() if name in held]
        told = {name: value for name, value in solved if value is not None}
        summed = item.left.holds(Integral) or item.right.holds(Integral)
        used = {
            name: value
            for name, value in told.items()
            if value == ZERO or (self.running & value.symbols() and (summed or not value.holds(*ELLIPTIC)))
        }
        if used:
            self._substitute(item, used, [("known", name) for name in used])

    def _divide_one_by_other(self, items: list[Item], unknowns: set[str], asked: str) -> bool:
        """Of two laws that hold one more unknown as a factor, F d = I α and m g d = (I + m d²) α, the one is divided by the other."""
        whole = [item for item in items if asked in item.unknowns(unknowns)]
        if not self.lone or len(whole) != 1 or any(self.pool[item.index].family in ("", KINEMATICS) for item in items):
            return False
        (one,), other = whole, next(item for item in items if item is not whole[0])
        shared = other.unknowns(unknowns)
        if len(shared) != 1 or not of_kinds(shared, MOTION) or isolated(other, name := next(iter(shared))) is not None:
            return False
        above, below = held_as_factor(one, name), held_as_factor(other, name)
        if above is None or below is None or self.signs.sign(below[0]) not in (-1, 1):
            return False
        self.told[name] = self.simplify(below[0] / below[1])
        one.left, one.right = above[0] / below[0], above[1] / below[1]
        one.sources += [ref for ref in (other.ref, *other.sources) if ref not in one.sources]
        one.divisor = other.ref
        items.remove(other)
        unknowns.discard(name)
        return True

    def _divide(self, item: Item) -> None:
        """Both sides divided by what they have in common, in a step of its own."""
        common = self.pool[item.index].common
        if common == ONE or item.sources:
            return
        item.left, item.right = (self.simplify(side / common) for side in (item.left, item.right))
        step = self._keep(item, [Equality(item.left, item.right)], "", ("both sides divided by ", common, " ≠ 0"))
        item.ref = ("step", step.number)

    def _next(self, items: list[Item], unknowns: set[str], asked: str) -> Elimination | None:
        """What to eliminate next, the most trivial first; None where that is a square, or none can be told from the others."""
        ranked: list[tuple[tuple[int, ...], Item, str]] = []
        held = [item.unknowns(unknowns) for item in items]
        holders = Counter(name for names in held for name in names)
        for item, names in zip(items, held, strict=True):
            self._check_alive(item, names)
            for name in sorted(names - {asked}):
                explicit = isolated(item, name)
                others = holders[name] - 1
                kind = elimination_kind(item, name, names, items)
                if kind == 2 and key_of(name).kind in ACCELERATIONS and self.pool[item.index].family == KINEMATICS:
                    kind = 4  # v = a t tells a speed by the acceleration, not the other way round
                # rules that lead to the asked unknown first; forces are eliminated rather than accelerations
                away = (
                    int(asked not in names) if kind == 2 else int(key_of(name).kind not in FORCES) if kind == 4 else 0
                )
                ranked.append(((kind, away, others, len(names), 0 if explicit else 1), item, name))
        ranked.sort(key=lambda entry: entry[0])
        return self._first_linear(ranked, items)

    def _first_linear(self, ranked: list[tuple[tuple[int, ...], Item, str]], items: list[Item]) -> Elimination | None:
        """Of the best-ranked eliminations the one with the shortest result."""
        best: tuple[int, Elimination] | None = None
        rank: tuple[int, ...] | None = None
        for key, item, name in ranked:
            if best is not None and key[:4] != (rank or ())[:4]:
                break
            if key[0] == 3 and self._told_square(item, name, items) is not None:
                return None
            found = self.value_in(item, name, alone=key[0] in (1, 3))
            if found is None or (found[0] == ZERO and key[3] > 1):
                continue  # of c x = 0 either may be nothing, as long as c is not known
            value, reason = found
            summed = item.left.holds(Integral) or item.right.holds(Integral)
            trivial = key[0] in (0, 2) and (key[0] == 0 or monomial(value)) and not summed
            if best is None or length(value) < best[0]:
                best, rank = (length(value), (item, name, value, None if trivial else reason)), key
        return best[1] if best else None

    def _within_function(self, items: list[Item], unknowns: set[str], asked: str) -> Elimination | None:
        """The first equation whose only unknown stands within a function and is not within an integral."""
        for item in items:
            names = item.unknowns(unknowns)
            if len(names) == 1 and asked not in names and not names & inner(item):
                name = names.pop()
                found = None if self._told_square(item, name, items) is not None else self.value_within(item, name)
                if found is not None:
                    return item, name, *found
        return None

    def _check_alive(self, item: Item, names: set[str]) -> None:
        """An equation without unknowns left says nothing, or something false."""
        if not names:
            gap = self.with_answers(item.left - item.right)
            raise Redundant(item.index) if is_zero(gap, self.positive) else Contradiction(item.index)

    def _check_nothing(self, item: Item, value: Formula) -> None:
        """What comes out as nothing does not where the answers found before make the factor before it vanish: 0 v² = 0."""
        if value == ZERO and self.solved and is_zero(self.with_answers(item.left - item.right), self.positive):
            raise Redundant(item.index)

    def _eliminate(
        self, items: list[Item], item: Item, name: str, value: Formula, reason: Words | None, unknowns: set[str]
    ) -> None:
        """Write the step where it deserves a line, and put the value into the other equations."""
        self._check_nothing(item, value)
        self.told[name] = value
        refs: list[Ref] = [item.ref, *item.sources]
        restated = not item.sources and not reason and isolated(item, name) == value
        if not restated and (reason is not None or (item.sources and self.pool[item.index].family)):
            more = [
                *self.like_terms(item, name),
                *self.bounds_put_in(item, name, value),
                *self.function_alone(item, name, value),
            ]
            step = self._keep(item, line_of(item, name, value, more), name, reason or ())
            refs = [("step", step.number)]
            self.derived.append((FOUND.equation(Symbol(name), value, item.section), refs[0]))
        for other in items:
            if name in other.unknowns({name}):
                self._substitute(other, {name: value}, refs)
                gap = other.left - other.right
                if not other.unknowns(unknowns) or (len(items) == 1 and is_zero(gap, self.positive)):
                    self._check_alive(other, set())

    def _told_square(self, item: Item, name: str, items: list[Item]) -> Formula | None:
        """The square of an unknown that one equation tells and that all others hold as its square alone."""
        if not all(only_squared(other, name) for other in items if name in other.unknowns({name})):
            return None
        gap = item.left - item.right
        if self.hollow(gap, name):
            raise Redundant(item.index)
        return self.square_in(gap, name)

    def _eliminate_square(self, items: list[Item], unknowns: set[str], asked: str) -> tuple[Item, str]:
        """Where an unknown occurs only as its square, put the square in: v² = 2 a h."""
        for item in sorted(
            items, key=lambda item: (len(item.unknowns(unknowns)), self.pool[item.index].family != ENERGY)
        ):
            for name in sorted(item.unknowns(unknowns) - {asked}):
                value = self._told_square(item, name, items)
                if value is None or (value == ZERO and item.unknowns(unknowns) - {name}):
                    continue
                self._check_nothing(item, value)
                square = Symbol(name) ** 2
                refs: list[Ref] = [item.ref, *item.sources]
                if (item.left, item.right) != (square, value):
                    chain = [Equality(item.left, item.right)] if item.sources else []
                    chain += [*self.bounds_put_in(item, name), *self.like_terms(item, name), Equality(square, value)]
                    refs = [("step", self._keep(item, chain, "", ()).number)]
                    self.derived.append((FOUND.equation(square, value, item.section), refs[0]))
                for other in items:
                    if other is not item and name in other.unknowns({name}):
                        other.left, other.right = (put_square(side, name, value) for side in (other.left, other.right))
                        other.sources.extend(ref for ref in refs if ref not in other.sources)
                return item, name
        raise NoClosedForm(ENTANGLED)

    def _substitute(self, item: Item, values: Mapping[str, Formula], refs: Sequence[Ref]) -> None:
        """Put values into an equation, and remember where they come from."""
        sides = [side.substitute(values) for side in (item.left, item.right)]
        if sum(map(length, sides)) > LONGEST:
            raise Unprintable(TOO_LONG)
        item.left, item.right = (self.tidied(self.unrooted(quarters_turned(side))) for side in sides)
        item.sources.extend(ref for ref in refs if ref not in item.sources and ref != item.ref)

    def _keep(self, item: Item, chain: Sequence[Equality], name: str, reason: Words) -> Step:
        """Write a step under the next number; a line that has been written before is only cited."""
        refs = item.ref, tuple(item.sources), (*map(with_constants_in_front, chain[:-1]), *chain[-1:])
        again = (step for step in self.steps if (step.target, step.sources, step.chain) == refs)
        if (written := next(again, None)) is not None:
            return written
        step = Step(len(self.steps) + 1, *refs, name, item.section, reason, item.divisor)
        self.steps.append(step)
        return step

    def _last(self, item: Item, asked: str) -> Found:
        """The asked unknown from the last equation."""
        written = isolated(item, asked)
        candidates, more = self.roots(item, asked)
        if not candidates:
            root, words = self.certified_root(item, asked)
            reason = (*NUMERICALLY, "; ", *words) if words else NUMERICALLY
            self._keep(item, [Equality(item.left, item.right)], asked, reason)
            return Found(asked, None, root)
        picked = self.choice(asked, candidates, item.left - item.right)
        if picked is None:
            raise Contradiction(item.index)
        value = self.chosen(picked, candidates).transform(self.without_bars, "abs")
        self._check_nothing(item, value)
        final = self.with_answers(value)
        final = final if seen_through_no_more(final) else self.shortest(final)
        more = more or [
            *self.bounds_put_in(item, asked, final),
            *self.function_alone(item, asked, candidates[picked.root]),
        ]
        more = [*self.like_terms(item, asked), *more]
        reason = picked.words or (SUMMED_NUMERICALLY if final.holds(Integral) else ())
        moved = moved_alone(item, asked) or value
        if item.sources or written is None or moved.symbols() & set(self.solved):
            value = moved
        if final != value:
            used = [name for name in self.solved if name in value.symbols()]
            first = self._in_letters(asked, value, final, more, written)
            item.sources[:0] = [("known", name) for name in used]
            self._keep(item, line_in_letters(item, asked, first, final), asked, reason)
        elif item.sources or written != final:
            self._keep(item, line_of(item, asked, final, more), asked, reason)
        others = tuple(self.simplify(self.with_answers(c)) for k, c in enumerate(candidates) if k != picked.root)
        return Found(asked, final, None, others)

    def _in_letters(
        self, asked: str, value: Formula, final: Formula, more: Sequence[Equality], written: Formula | None
    ) -> list[Equality]:
        """What stands before an answer: it in the letters found before, and what leads there and on."""
        letter = Symbol(asked)
        if written is not None and written.holds(Integral):
            return [Equality(letter, written), *more]
        if written is not None and part_of_whole(written):
            share = self.with_answers(written)
            put_in = [Equality(letter, share)] if length(share) <= SHORT_SHARE else []
            return [*more, Equality(letter, written), *put_in]
        drawn = self.drawn_together(value)
        together = [Equality(letter, drawn)] if drawn not in (None, value, final) else []
        return [*more, Equality(letter, value), *together]
