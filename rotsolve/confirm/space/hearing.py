"""Hearing: answers at one set of numbers: those that the assembly can find itself, and those that it has to put in and test.

A tilt that no line tells, or a letter that is asked for, is put in: then the equations of all bodies have to leave nothing over. By how
much they do is told in terms of the answer, by Gauss's and Newton's step towards the nearest number with which they hold.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cached_property, partial

from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.units.dimension import ANGLE, Dimension
from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.course.scans import Scans
from rotsolve.confirm.linear import solved_generally
from rotsolve.confirm.space.arrows import arrow_length
from rotsolve.confirm.space.inquiry import Inquiry, only_one
from rotsolve.confirm.space.rig import NODAL, Told
from rotsolve.confirm.space.ties import SPEED
from rotsolve.core.derivation import Answer
from rotsolve.language.block import spoken_of_at
from rotsolve.language.limited import limited_letters
from rotsolve.language.problem import EXTREMES, Find, Problem

STEP = 1e-5  # by how much an answer that is put in is changed, to see what it changes
CHANGED, SAME_NUMBER = 0.3, 1e-9  # the same, to see whether a question hangs on it at all
SURE = 1e-7  # of what such a change leaves over: beside it that is something
TRAVELLING = (
    1e-5  # of v over the largest length: a rate beside which 1e-9 is still more than a float's rounding of that
)
LEAST = 1e-12  # for a mass, a length or a rate of which a scene has none
UNTESTED = "no equation tests it"
VERGES = ("stable", "steady")
SOUGHT = ("tilt",)  # what tells how a body stands

Put = dict[tuple[str, str, str], str]  # what no line of a state tells, by the names of the answers that are put in


def answers_put_in(problem: Problem) -> Put:
    """The answers that are put in for what tells how bodies stand, where no line of their state does."""
    found: Put = {}
    for find in problem.finds:
        if find.formula != Symbol("#0") or len(find.terms) != 1 or find.where is not None:
            continue
        term = find.terms[0]
        name = term.at or (problem.states[0].name if len(problem.states) == 1 else None)
        state = next((state for state in problem.states if state.name == name), None)
        if state is not None and state is not problem.states[0] and not state.steady:
            continue  # the motion leads to it
        if state is None or term.path.quantity not in SOUGHT or term.modifier:
            continue
        lines = [line for line in state.conditions if line.path is not None and line.path.owner == term.path.owner]
        words = [line.path.quantity for line in lines if line.path is not None and line.value is not None]
        nods = any(
            line.path is not None and line.path.quantity in NODAL for line in lines
        )  # else it is that from its own momentum
        if nods and term.path.quantity not in words:
            found[state.name, term.path.owner, term.path.quantity] = find.group
    return found


class Hearing:
    """A scene at one set of numbers; `told` are answers put in for what tells how bodies stand."""

    finely = False  # whether motions are followed as nearly as floats allow

    def __init__(self, problem: Problem, known: Mapping[str, float], told: Told, scans: Scans | None = None) -> None:
        self.problem, self.known, self.told, self.scans = problem, known, told, scans or Scans()
        sought = {find.formula for find in problem.finds if find.where is not None}
        self.letters = [given.name for given in problem.givens if given.asked and Symbol(given.name) not in sought]
        self.put = answers_put_in(problem)

    @cached_property
    def inquiry(self) -> Inquiry:
        inquiry = Inquiry(self.problem, self.known, self.told)
        inquiry.finely = self.finely
        return inquiry

    def more_finely(self) -> Hearing:
        """The same, with its motions followed as nearly as floats allow."""
        other = Hearing(self.problem, self.known, self.told, self.scans)
        other.finely = True
        return other

    def is_put_in(self, find: Find) -> bool:
        return find.group in self.put.values() or self.letter(find) is not None

    def letter(self, find: Find) -> str | None:
        """The letter of the scene for which a question asks."""
        asked = find.formula.name if isinstance(find.formula, Symbol) and not find.terms else None
        return asked if asked in self.letters else None

    def numbers_of(self, finds: Sequence[Find], name: str, part: str) -> list[float]:
        """What the assembly has for a part of an answer, in each way in which the scene may move."""
        if finds[0].extreme and (found := self.extreme_over_letter(finds[0])) is not None:
            return [found]
        own = next((find for find in finds if find.name == f"{name}_{part}"), None)
        asked = (finds[0], part) if own is None else (own, "")
        if self.doubt is not None and self.hangs_on_put_in(*asked):
            raise self.doubt
        return self.inquiry.numbers(*asked)

    def extreme_over_letter(self, find: Find) -> float | None:
        """`largest Q` over a letter; None of what is asked otherwise."""
        from rotsolve.confirm.extremes import extreme_over, letter_of_extreme, phrase_of

        phrase = phrase_of(find, self.problem)
        letter = letter_of_extreme(find, self.problem)
        if letter is None:
            return None
        value, begun = self.by_letter(phrase, letter.name), self.known.get(letter.name, 1.0)
        reach, sized = self.reach(letter.name), letter.name in limited_letters(self.problem)

        def scan() -> float:
            return extreme_over(letter, find.extreme, begun, value, reach, sized=sized)[1]

        return self.scans.once(find, letter, self.known, None, scan)

    # what is put in

    @cached_property
    def places(self) -> list[tuple[str, str, str] | str]:
        """All that is put in: of bodies, and letters."""
        return [*self.told, *(name for name in self.letters if name in self.known)]

    def left(self, changes: Mapping[int, float]) -> list[float]:
        """What the equations leave over with changed answers."""
        return self.changed({self.places[place]: change for place, change in changes.items()}).left_over()

    def changed(self, changes: Mapping[tuple[str, str, str] | str, float]) -> Inquiry:
        """The scene with changed answers."""
        told, known = dict(self.told), dict(self.known)
        for key, change in changes.items():
            if isinstance(key, str):
                known[key] += change
            else:
                told[key] += change
        return Inquiry(self.problem, known, told)

    def steps(self) -> list[float]:
        return [STEP * (self.size(place) or 1.0) for place in self.places]

    def size(self, place: tuple[str, str, str] | str) -> float:
        """How large what is put in is; an angle counts as a radian at least, since none of its functions knows a smaller one."""
        number = self.known[place] if isinstance(place, str) else self.told[place]
        return max(abs(number), 1.0 if self.is_angle(place) else 0.0)

    def is_angle(self, place: tuple[str, str, str] | str) -> bool:
        dimension = self.dimension(place)
        return not isinstance(place, str) or (dimension is not None and dimension.matches(ANGLE))

    def dimension(self, place: tuple[str, str, str] | str) -> Dimension | None:
        return next((given.dimension for given in self.problem.givens if given.name == place), None)

    @cached_property
    def corrections(self) -> list[float]:
        """By how much each answer would have to be another, relative to its size, for the equations to leave nothing over."""
        if not self.places:
            return []
        base, steps = self.left({}), self.steps()
        columns = []
        for place, step in enumerate(steps):
            try:
                up, down = self.left({place: step}), self.left({place: -step})
            except Unfit:  # a state that tells an answer as well breaks with it
                raise NotConfirmed(UNTESTED) from None
            if not len(up) == len(down) == len(base):  # other equations hold near it, as of what stands just upright
                raise NotConfirmed(UNTESTED)
            columns.append([(a - b) / 2 for a, b in zip(up, down, strict=True)])
        count = len(columns)
        most = max((abs(part) for column in columns for part in column), default=0.0)
        sizes = [max(map(abs, column), default=0.0) for column in columns]
        if not most or min(sizes) <= SURE * STEP * max(1e-300, most):
            raise NotConfirmed(UNTESTED)
        rows = [
            {j: sum(a * b for a, b in zip(columns[i], columns[j], strict=True)) for j in range(count)}
            for i in range(count)
        ]
        right = [-sum(a * b for a, b in zip(columns[i], base, strict=True)) for i in range(count)]
        found = solved_generally(rows, right, count)
        if found.free:
            raise NotConfirmed(UNTESTED)
        after = [
            part + sum(c[n] * x for c, x in zip(columns, found.values, strict=True)) for n, part in enumerate(base)
        ]
        if max(map(abs, after), default=0.0) > 0.2 * most and max(map(abs, base)) > 0.2 * most:
            return [math.inf] * count  # no number near it makes them hold
        return [value * STEP for value in found.values]

    @cached_property
    def doubt(self) -> NotConfirmed | None:
        """Why what is put in is not confirmed; None where it is."""
        try:
            sure = max(map(abs, self.corrections), default=0.0) <= STEP
        except NotConfirmed as reason:
            return reason
        return None if sure else NotConfirmed("answers that it hangs on are not confirmed")

    @cached_property
    def with_others(self) -> list[Inquiry]:
        """The scene with another number of each answer that is put in."""
        return [self.changed({place: CHANGED * self.size(place)}) for place in self.places]

    def hangs_on_put_in(self, find: Find, part: str) -> bool:
        """Whether a question has other numbers where what is put in has others, or none: not what lies before it on the way."""
        try:
            own = self.inquiry.numbers(find, part)
            others = [inquiry.numbers(find, part) for inquiry in self.with_others]
        except (NotConfirmed, Unfit, ArithmeticError, ValueError):
            return True
        least = SAME_NUMBER * max(map(abs, own), default=0.0)
        return any(
            len(other) != len(own) or any(abs(a - b) > least for a, b in zip(own, other, strict=True))
            for other in others
        )

    @cached_property
    def other_sets(self) -> list[dict[str, float]]:
        """Other numbers for several letters that are put in with which the equations leave nothing over either."""
        from rotsolve.confirm.space.together import other_sets

        return list(other_sets(self))

    def correction(self, find: Find) -> float:
        """By how much an answer would have to be another for the equations to leave nothing over."""
        place = self.places.index(self.place_of(find))
        return self.corrections[place] / STEP * self.steps()[place]

    def place_of(self, find: Find) -> tuple[str, str, str] | str:
        """What is put in for a question."""
        letter = self.letter(find)
        key = letter if letter is not None else next(key for key, name in self.put.items() if name == find.group)
        if key not in self.places:
            raise NotConfirmed(UNTESTED)
        return key

    # conditions

    def under_condition(self, find: Find, own: float) -> float:
        """The number of a letter under a condition, which is that of the answer where the condition holds with it, or only just holds."""
        from rotsolve.confirm.space.verge import gap_under, just_holds, step_to

        condition = find.where
        if find.terms or not isinstance(find.formula, Symbol) or condition is None:
            raise NotConfirmed("a quantity under a condition")
        if condition.word in EXTREMES and condition.phrase is not None:
            from rotsolve.confirm.extremes import extreme_place

            given = next((given for given in self.problem.givens if given.name == find.formula.name), None)
            if given is None:
                raise NotConfirmed("an extreme over no letter of the scene")
            value = self.by_letter(condition.phrase, given.name)
            reach, sized = self.reach(given.name), given.name in limited_letters(self.problem)
            word = condition.word

            def scan() -> float:
                return extreme_place(given, word, own, value, reach, sized=sized)

            return self.scans.once(find, given, self.known, own, scan)
        with_letter = partial(self.with_letter, find.formula.name)
        if condition.word in VERGES:
            part = spoken_of_at(self.problem, condition.owner)  # what it does not speak of may move there anyhow
            return just_holds(find, own, partial(Hearing(part, self.known, self.told).with_letter, find.formula.name))
        return step_to(gap_under(condition, with_letter), own)

    def reach(self, letter: str) -> float | None:
        """Up to where from 0 a letter can be, where there is such an end."""
        from rotsolve.confirm.extremes import end_of_range

        end = end_of_range(letter, self.problem)
        return None if end is None else self.inquiry.rig.value(end)

    def by_letter(self, phrase: Find, letter: str) -> Callable[[float], float]:
        """The number of a quantity by that of a letter."""
        from rotsolve.confirm.extremes import plainly_asked

        plain = plainly_asked(phrase)
        return lambda value: only_one(self.with_letter(letter, value).numbers(plain, ""))

    def with_letter(self, letter: str, value: float) -> Inquiry:
        """The scene with another number of a letter."""
        return Inquiry(self.problem, {**self.known, letter: value}, self.told)

    # sizes

    def natural(self, answer: Answer) -> float:
        """The size that a quantity of its dimension has in the scene, by its masses, lengths and rates."""
        return self.usual(answer.dimension or next((part.dimension for part in answer.components), None))

    def usual(self, dimension: Dimension | None) -> float:
        """The size that quantities of a dimension have in the scene; 0 where nothing tells one."""
        if dimension is None or not self.problem.bodies:
            return 0.0
        mass, span, rate = self.scales
        return float(mass**dimension.mass * span**dimension.length * rate**-dimension.time)

    @cached_property
    def scales(self) -> tuple[float, float, float]:
        """The largest mass, length and rate, as forces and couples that are told would make it too, and beside these what rounding makes of
        speeds: a blow through the centre turns nothing."""
        rig, masses, spans, rates, speeds = self.inquiry.rig, [LEAST], [LEAST], [LEAST], [0.0]
        forces, couples = [0.0], [0.0]
        for name in rig.bodies:
            own = rig.solid(name)
            trace = sum(own.tensor[k][k] for k in range(3))
            masses.append(own.mass)
            spans.append(math.sqrt(trace / own.mass) if own.mass > 0 and trace > 0 else 0.0)
        for state in self.problem.states or (None,):
            with suppress(NotConfirmed, Unfit):
                world = self.inquiry.ways(None if state is None else state.name)[0].worlds[0]
                spans += [arrow_length(item.arm) for item in world.efforts.list]
                spans += [arrow_length(world.stance.place(name)) for name in rig.bodies]
                forces += [arrow_length(item.force) for item in world.efforts.list]
                couples += [arrow_length(item.couple) for item in world.efforts.list]
                for (kind, _, _), part in world.now.values.items():
                    (speeds if kind == SPEED else rates).append(abs(part))
        mass, span = max(masses), max(spans)
        if mass <= LEAST:  # all is light: forces do not hang on how fast it goes
            span = span if span > LEAST else 1.0
            rate = max(*rates, TRAVELLING * max(speeds) / span)
            return (max(forces) + max(couples) / span) / (span * rate * rate), span, rate
        pushed = math.sqrt((max(forces) + max(couples) / span) / (mass * span))
        return mass, span, max(*rates, TRAVELLING * max(speeds) / span, math.sqrt(rig.gravity / span), pushed)
