"""Solve: the equations of a plan one unknown at a time, the asked one last, keeping every step as a textbook would write it.

Trivial equations (I = ½ M R², a = R α) are put into the others without a line of their own; every other elimination is a step.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from rotsolve.algebra.calculus.periodic import period_of
from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.exact.normal import coefficients, is_zero
from rotsolve.algebra.exact.solving.linear import solve_linear
from rotsolve.algebra.exact.solving.roots import solve_polynomial, solve_trig
from rotsolve.algebra.exact.solving.unwrap import solve_unwrapped
from rotsolve.algebra.exact.writing.shape import length
from rotsolve.algebra.formula import ZERO, Call, Formula, Integral, Number, Power, Sum, Symbol
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.equation import Equation
from rotsolve.plan import Plan
from rotsolve.solver.item import Item, inner, isolated, kind_of, monomial, moved_alone, only_squared, put_square
from rotsolve.solver.step import Choice, Chooser, Contradiction, Found, NoClosedForm, Redundant, Ref, Step
from rotsolve.solver.textbook import Textbook, quarters_turned

FORCES = ("tension|", "force|", "normal_force|", "friction_force|", "impulse|")
ROUNDS = 8  # values put in one after the other, since one may speak of the next
ENTANGLED = "no unknown can be told from the others"

# equation, unknown, its value, and why it is this root; None where the elimination needs no line of its own
Elimination = tuple[Item, str, Formula, "Words | None"]


@dataclass
class Solver(Textbook):
    """Solves plans one after the other; remembers answers and steps."""

    pool: list[Equation]
    order: tuple[str, ...]
    positive: frozenset[str]
    values: Mapping[str, Formula]
    choose: Chooser
    refs: dict[int, Ref] = field(default_factory=dict)
    running: frozenset[str] = frozenset(("time",))  # letters that run during a phase
    numeric: bool = False  # whether a root may be found numerically where there is no closed form
    steps: list[Step] = field(default_factory=list)
    solved: dict[str, Found] = field(default_factory=dict)
    derived: list[tuple[Equation, Ref]] = field(default_factory=list)
    told: dict[str, Formula] = field(default_factory=dict)  # what was eliminated on the way to the answers

    def solve(self, plan: Plan) -> Found:
        """Carry a plan out; the steps are kept only when it succeeds."""
        kept, derived, told = len(self.steps), len(self.derived), dict(self.told)
        try:
            found = self._solve(plan)
        except (Redundant, Contradiction, NoClosedForm, Undefined, ZeroDivisionError) as error:
            del self.steps[kept:], self.derived[derived:]
            self.told = told
            if isinstance(error, ZeroDivisionError):
                raise NoClosedForm("it would take a division by zero") from None
            raise
        self.solved[plan.asked] = found
        return found

    def with_found(self, value: Formula) -> Formula:
        """Answers put in, and what was eliminated on the way to them."""
        for _ in range(ROUNDS):
            value = self.with_answers(value)
            used = {name: self.told[name] for name in value.symbols() if name in self.told}
            if not used:
                break
            value = value.substitute(used)
        return value

    def _solve(self, plan: Plan) -> Found:
        """Eliminate one unknown after the other, until the last equation holds the asked one alone."""
        laws = [(index, self.pool[index]) for index in plan.equations]
        items = [Item(self.refs.get(k, ("law", k)), k, law.left, law.right, law.section) for k, law in laws]
        for item in items:
            self._put_in_functions(item)
        unknowns = set(plan.unknowns)
        while len(items) > 1:
            found: Elimination | None
            try:
                found = self._next(items, unknowns, plan.asked)
            except NoClosedForm:
                found = self._within_function(items, unknowns, plan.asked)
            if found is None:
                item, name = self._eliminate_square(items, unknowns, plan.asked)
            else:
                item, name = found[:2]
            items.remove(item)
            unknowns.discard(name)
            if found is not None:
                self._eliminate(items, *found, unknowns)
        if items[0].unknowns(unknowns) - {plan.asked}:
            raise Redundant(items[0].index)  # an unknown was left over, so that two of the equations said the same
        return self._last(items[0], plan.asked)

    def _put_in_functions(self, item: Item) -> None:
        """Answers that run during a phase are put in at once (a letter would hide what is integrated), and so are zeros."""
        running = {
            name: found.formula
            for name, found in self.solved.items()
            if found.formula is not None and (self.running & found.formula.symbols() or found.formula == ZERO)
        }
        used = {
            name: value
            for name, value in running.items()
            if name in item.left.symbols() | item.right.symbols() | inner(item)
        }
        if used:
            self._substitute(item, used, [("known", name) for name in used])

    def _next(self, items: list[Item], unknowns: set[str], asked: str) -> Elimination:
        """What to eliminate next, the most trivial first."""
        ranked: list[tuple[tuple[int, ...], Item, str]] = []
        for item in items:
            names = item.unknowns(unknowns)
            self._check_alive(item, names)
            for name in sorted(names - {asked}):
                explicit = isolated(item, name)
                others = sum(1 for other in items if other is not item and name in other.unknowns(unknowns))
                kind = kind_of(item, name, names)
                # rules that lead to the asked unknown first; forces are eliminated rather than accelerations
                away = int(asked not in names) if kind == 2 else int(not name.startswith(FORCES)) if kind == 3 else 0
                ranked.append(((kind, away, others, len(names), 0 if explicit else 1), item, name))
        ranked.sort(key=lambda entry: entry[0])
        return self._first_linear(ranked, asked)

    def _first_linear(self, ranked: list[tuple[tuple[int, ...], Item, str]], asked: str) -> Elimination:
        """Of the best-ranked eliminations the one with the shortest result."""
        best: tuple[int, Elimination] | None = None
        rank: tuple[int, ...] | None = None
        for key, item, name in ranked:
            if best is not None and key[:4] != (rank or ())[:4]:
                break
            found = self._value(item, name, alone=key[0] <= 1)
            if found is None:
                continue
            value, reason = found
            trivial = key[0] in (0, 2) and (key[0] == 0 or monomial(value))
            if best is None or length(value) < best[0]:
                best, rank = (length(value), (item, name, value, None if trivial else reason)), key
        if best is None:
            raise NoClosedForm(ENTANGLED)
        return best[1]

    def _value(self, item: Item, name: str, *, alone: bool) -> tuple[Formula, Words] | None:
        """The value of an unknown from one equation: as written where it stands alone, else solved; and why it is this root."""
        explicit = isolated(item, name)
        if explicit is not None:
            explicit = self.carried_out(explicit)
            return (self.simplify(explicit) if item.sources else explicit), ()
        gap = item.left - item.right
        if name not in inner(item):
            gap = self.carried_out(item.left) - self.carried_out(item.right)
        value = solve_linear(gap, name, order=self.order, positive=self.positive)
        if value is not None and self._hollow(gap, name):
            raise Redundant(item.index)
        if value is None and alone:
            return self._root(name, solve_polynomial(gap, name, order=self.order, positive=self.positive), gap)
        return None if value is None else (value, ())

    def _within_function(self, items: list[Item], unknowns: set[str], asked: str) -> Elimination | None:
        """An equation whose only unknown stands within a function: sin n t = 0, log(u) = 3."""
        for item in items:
            names = item.unknowns(unknowns)
            if len(names) == 1 and asked not in names and not names & inner(item):
                name, gap = names.pop(), self.carried_out(item.left) - self.carried_out(item.right)
                if is_zero(gap, self.positive):
                    raise Redundant(item.index)
                roots = solve_unwrapped(gap, name, order=self.order, positive=self.positive)
                roots = roots or [
                    angle.formula for angle in solve_trig(gap, name, order=self.order, positive=self.positive)
                ]
                found = self._root(name, roots, gap)
                if found is not None:
                    return item, name, *found
        return None

    def _root(self, name: str, roots: Sequence[Formula], gap: Formula) -> tuple[Formula, Words] | None:
        """The root that is meant of several, and why it is."""
        choice = self._choice(name, roots, gap) if roots else None
        return (self._chosen(choice, roots), choice.words) if choice else None

    def _check_alive(self, item: Item, names: set[str]) -> None:
        """An equation without unknowns left says nothing, or something false."""
        if not names:
            gap = self.with_answers(item.left - item.right)
            raise Redundant(item.index) if is_zero(gap, self.positive) else Contradiction(item.index)

    def _eliminate(
        self, items: list[Item], item: Item, name: str, value: Formula, reason: Words | None, unknowns: set[str]
    ) -> None:
        """Write the step where it deserves a line, and put the value into the other equations."""
        self.told[name] = value
        refs: list[Ref] = [item.ref, *item.sources]
        if reason is not None or (item.sources and self.pool[item.index].family):
            step = self._step(item, name, value, reason or ())
            refs = [("step", step.number)]
            self.derived.append((Equation(Symbol(name), value, "", item.section, "", 0), refs[0]))
        for other in items:
            if name in other.unknowns({name}):
                self._substitute(other, {name: value}, refs)
                gap = other.left - other.right
                if not other.unknowns(unknowns) or (len(items) == 1 and is_zero(gap, self.positive)):
                    self._check_alive(other, set())

    def _eliminate_square(self, items: list[Item], unknowns: set[str], asked: str) -> tuple[Item, str]:
        """Where an unknown occurs only as its square, put the square in: v² = 2 a h."""
        for item in items:
            for name in sorted(item.unknowns(unknowns) - {asked}):
                parts = coefficients(item.left - item.right, name, order=self.order, positive=self.positive)
                others = [other for other in items if other is not item and name in other.unknowns({name})]
                if (
                    parts is None
                    or len(parts) != 3
                    or parts[1] != ZERO
                    or not all(only_squared(other, name) for other in others)
                ):
                    continue
                square, value = Symbol(name) ** 2, self.simplify(-parts[0] / parts[2])
                refs: list[Ref] = [item.ref, *item.sources]
                if item.sources:
                    chain = [Equality(item.left, item.right), Equality(square, value)]
                    refs = [("step", self._keep(item, chain, "", ()).number)]
                for other in others:
                    other.left, other.right = (put_square(side, square, value) for side in (other.left, other.right))
                    other.sources.extend(ref for ref in refs if ref not in other.sources)
                return item, name
        raise NoClosedForm(ENTANGLED)

    def _substitute(self, item: Item, values: Mapping[str, Formula], refs: Sequence[Ref]) -> None:
        """Put values into an equation, and remember where they come from."""
        item.left, item.right = (
            self.tidied(quarters_turned(side.substitute(values))) for side in (item.left, item.right)
        )
        item.sources.extend(ref for ref in refs if ref not in item.sources and ref != item.ref)

    def _step(self, item: Item, name: str, value: Formula, reason: Words, more: Sequence[Equality] = ()) -> Step:
        """The printed line of an elimination: the equation with everything put in, then the unknown alone."""
        chain = []
        if item.sources and isolated(item, name) is None:
            chain.append(Equality(item.left, item.right))
        elif item.sources and isolated(item, name) != value:
            chain.append(Equality(Symbol(name), isolated(item, name) or value))
        chain.extend(more)
        result = Equality(Symbol(name), value)
        if not chain or chain[-1] != result:
            chain.append(result)
        return self._keep(item, chain, name, reason)

    def _keep(self, item: Item, chain: Sequence[Equality], name: str, reason: Words) -> Step:
        """Write a step under the next number."""
        step = Step(len(self.steps) + 1, item.ref, tuple(item.sources), tuple(chain), name, item.section, reason)
        self.steps.append(step)
        return step

    def _last(self, item: Item, asked: str) -> Found:
        """The asked unknown from the last equation."""
        written = isolated(item, asked)
        integrals = written is not None and any(isinstance(node, Integral) for node in written.walk())
        candidates, more, reason = self._roots(item, asked)
        if not candidates:
            return self._numeric(item, asked)
        picked = self._choice(asked, candidates, item.left - item.right)
        if picked is None:
            raise Contradiction(item.index)
        value = self._chosen(picked, candidates)
        final = self._shortest(self.with_answers(value))
        if any(isinstance(node, Integral) for node in final.walk()):
            reason = ("no closed form: the integral is worked out numerically, with certified digits",)
        value = moved_alone(item, asked) or value
        if final != value:
            used = [name for name in self.solved if name in value.symbols()]
            first = [*more, Equality(Symbol(asked), written if written is not None and integrals else value)]
            item.sources[:0] = [("known", name) for name in used]
            self._keep_written(item, asked, first, final, picked.words or reason)
        elif item.sources or written != final:
            self._step(item, asked, final, picked.words or reason, more)
        others = tuple(self.simplify(self.with_answers(c)) for k, c in enumerate(candidates) if k != picked.root)
        return Found(asked, final, None, others)

    def _choice(self, name: str, roots: Sequence[Formula], gap: Formula) -> Choice | None:
        """The root that is meant, of the equation gap = 0."""
        period = period_of(self.with_answers(self.carried_out(gap)), name)
        if len(roots) == 1 and period is None:
            return Choice(0)
        return self.choose(name, [self.with_answers(root) for root in roots], period)

    def _chosen(self, choice: Choice, roots: Sequence[Formula]) -> Formula:
        """The root itself, whole turns or periods beyond it."""
        return self.simplify(choice.of(roots)) if choice.turns else roots[choice.root]

    def _shortest(self, value: Formula) -> Formula:
        """Textbook form, unless it is what a power of a sum comes to when it is multiplied out."""
        final = self.simplify(value)
        bare = value.arguments[0] if isinstance(value, Call) and value.function == "abs" else None
        if bare is not None and length(bare) < length(final) and is_zero(bare - final, self.positive):
            return bare
        roots = [node.arguments[0] for node in value.walk() if isinstance(node, Call) and node.function == "sqrt"]
        sums = all(isinstance(root, Sum) for root in roots)
        much = 1 if is_size(value) else Fraction(3, 2)
        return value if sums and much * length(value) < length(final) else final

    def _keep_written(self, item: Item, asked: str, first: list[Equality], final: Formula, reason: Words) -> None:
        """A step whose first equality is in letters found before, and whose last has them put in."""
        chain = [equality for k, equality in enumerate(first) if k == 0 or equality != first[k - 1]]
        explicit = isolated(item, asked)
        if explicit is None and any(ref[0] != "known" for ref in item.sources):
            chain.insert(0, Equality(item.left, item.right))
        chain.append(Equality(Symbol(asked), final))
        self._keep(item, chain, asked, reason)

    def _hollow(self, gap: Formula, name: str) -> bool:
        """Whether an unknown drops out once the answers found before are put in: letters such as a₁ and a₂ are not independent."""
        whole = self.with_answers(gap)
        return whole != gap and is_zero(whole, self.positive)

    def _roots(self, item: Item, asked: str) -> tuple[list[Formula], list[Equality], Words]:
        """Closed forms of the asked unknown, with the line before the root where it is one."""
        left, right = self.carried_out(item.left), self.carried_out(item.right)
        gap = left - right
        written = isolated(item, asked)
        if written is not None:
            return [self._shortest(self.carried_out(written))], [], ()
        parts = coefficients(gap, asked, order=self.order, positive=self.positive)
        if parts is not None and len(parts) < 2:
            raise (
                Redundant(item.index) if is_zero(self.with_answers(gap), self.positive) else Contradiction(item.index)
            )
        if parts is not None and len(parts) <= 3:
            if self._hollow(gap, asked):
                raise Redundant(item.index)
            roots = solve_polynomial(gap, asked, order=self.order, positive=self.positive)
            pure = len(parts) == 3 and parts[1] == ZERO
            square = [Equality(Symbol(asked) ** 2, self.simplify(-parts[0] / parts[2]))] if pure else []
            return roots, square or self._unfolded(item, Equality(left, right)), ()
        if is_zero(self.with_answers(gap), self.positive):
            raise Redundant(item.index)
        for solve in (solve_polynomial, solve_unwrapped):
            for whole in dict.fromkeys((gap, self.with_answers(gap))):
                roots = solve(whole, asked, order=self.order, positive=self.positive)
                if roots:
                    return roots, self._unfolded(item, Equality(left, right)), ()
        trig = solve_trig(self.with_answers(gap), asked, order=self.order, positive=self.positive)
        return [candidate.formula for candidate in trig], [], ()

    def _unfolded(self, item: Item, done: Equality) -> list[Equality]:
        """The equation with its integrals carried out, where that is not how it stands."""
        return [] if (done.left, done.right) == (item.left, item.right) else [done]

    def _numeric(self, item: Item, asked: str) -> Found:
        """A certified root where there is no closed form."""
        if not self.numeric:
            raise NoClosedForm("it has no closed form")
        gap = self.with_answers(self.carried_out(item.left) - self.carried_out(item.right))
        if gap.symbols() - set(self.values) - {asked}:
            raise NoClosedForm("it has no closed form, and not every given has a number")
        for reach in (10, 1000, 10**6):
            roots = real_roots(gap, asked, self.values, -reach, reach)
            if roots.roots:
                picked = self.choose(asked, [as_formula(root) for root in roots.roots], None)
                reason: Words = ("no closed form: solved numerically, with certified digits",)
                self._keep(item, [Equality(item.left, item.right)], asked, reason)
                return Found(asked, None, roots.roots[picked.root if picked else 0])
        raise NoClosedForm("no real value satisfies the equations")


def is_size(value: Formula) -> bool:
    """Whether a formula is the root of a sum of squares, as the size of a vector is."""
    root = value.arguments[0] if isinstance(value, Call) and value.function == "sqrt" else value
    return isinstance(root, Sum) and all(isinstance(term, Power) for term in root.terms)


def as_formula(root: Certified) -> Formula:
    """A certified root as a number, for choosing between roots only."""
    return Number(Fraction(root.float))
