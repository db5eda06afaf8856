"""Asked: what a line of `find` is in the course of the scene, by the assembly's own numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Sum, Symbol
from rotsolve.algebra.units.dimension import ACCELERATION, ANGULAR_ACCELERATION, FORCE, TORQUE
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Astray, Node
from rotsolve.confirm.course.reading import Reckoned, number, of_body, vector
from rotsolve.confirm.numbers import options_that_hold, value_of
from rotsolve.confirm.rows import EDGE
from rotsolve.core.quantity import OSCILLATING, QUANTITIES, SPANNED
from rotsolve.core.symbols import PLACES
from rotsolve.core.writing import spoken
from rotsolve.language.problem import ANY_TIME, Condition, Find, Path, Problem, Term

if TYPE_CHECKING:
    from rotsolve.confirm.course.scans import Scans

MEANS = {  # what the mean of a quantity is the mean of, over time
    "power": ("work", ""),
    "angular_velocity": ("rotation", ""),
    "velocity": ("displacement", ""),
    "speed": ("distance", ""),
    "acceleration": ("velocity", "change of"),
    "angular_acceleration": ("angular_velocity", "change of"),
    "force": ("impulse", ""),
    "torque": ("angular_impulse", ""),
}

OF_RATES, OF_FORCES = (ACCELERATION, ANGULAR_ACCELERATION), (FORCE, TORQUE)

Said = Mapping[str, "float | str"]


class Asker:
    """Reads what is asked from the course of a scene; answers found before may be spoken of by name."""

    def __init__(self, problem: Problem, course: Course, scans: Scans | None = None) -> None:
        self.problem, self.course, self.scans = problem, course, scans
        self.earlier: dict[str, float] = {}

    def answer(self, find: Find, said: Said) -> Reckoned:
        """The value of a question; `said` is what the program answers, which a condition or an unknown letter is tried with."""
        if find.choice is not None:
            return Reckoned({}, 1.0, options_that_hold(find.choice, lambda side: self.valued(side).number))
        if find.where is not None and isinstance(said.get(""), float):
            from rotsolve.confirm.course.conditions import tried

            return tried(find, float(said[""]), self.course, self.valued_beside, self.scans)
        if find.extreme and (most := self.largest(find)) is not None:
            return number(most)
        found = self.valued(find)
        if "" in found.values:
            self.earlier[find.name] = found.number
        return found

    def valued_beside(self, find: Find, course: Course) -> float:
        """The number of a question in another course."""
        return Asker(self.problem, course, self.scans).valued(find).number

    def largest(self, find: Find) -> float | None:
        """The largest or smallest value of a quantity over an open letter; None of what is asked otherwise."""
        from rotsolve.confirm.course.over_a_letter import largest_value

        if not find.terms and self.is_asked(find):
            return None
        return largest_value(find, self.course, self.valued_beside, self.scans)

    def valued(self, find: Find) -> Reckoned:
        """A path, or arithmetic over paths, givens and earlier answers."""
        terms = [self.term(term) for term in find.terms]
        if len(terms) == 1 and find.formula == Symbol("#0"):
            found = terms[0]
        elif not terms and self.is_asked(find):
            return self.letter(find)
        else:
            self.look_up(find)
            letters: dict[str, Any] = {**self.course.letters, **self.earlier}
            letters |= {f"#{index}": term.number for index, term in enumerate(terms)}
            size = max((abs(term.number) for term in terms), default=0.0) if isinstance(find.formula, Sum) else 0.0
            sized = any(term.sized for term in terms)
            found = number(float(value_of(find.formula, letters)), size, sized=sized)
        if find.modifier == "size of":
            return number(abs(found.number), found.size)
        return found

    def look_up(self, find: Find) -> None:
        """The answers that a question speaks of by name."""
        for name in find.formula.symbols() - self.earlier.keys() - self.course.letters.keys():
            other = next((item for item in self.problem.finds if item.name == name and item is not find), None)
            if other is not None and other.where is None:
                self.earlier[name] = self.valued(other).number

    def is_asked(self, find: Find) -> bool:
        """Whether it asks for a letter of the scene that has no number."""
        return any(given.asked and Symbol(given.name) == find.formula for given in self.problem.givens)

    def letter(self, find: Find) -> Reckoned:
        """A letter that is asked for has the answer's number, which is right where all lines of all states hold with it."""
        name = find.formula.name if isinstance(find.formula, Symbol) else ""
        self.course.settle(name)
        from rotsolve.confirm.course.sought import stands_at

        for state in self.problem.states if stands_at(self.problem, name) else ():
            check_pushed(self.course.node(state.name))
        return number(float(self.course.letters[name]))

    # one term

    def term(self, term: Term) -> Reckoned:
        """One path with its modifier and its own time."""
        found = self.timed(term)
        return number(abs(found.number), found.size) if term.modifier == "size of" else found

    def timed(self, term: Term) -> Reckoned:
        path = term.path
        if path.quantity in OSCILLATING:
            from rotsolve.confirm.course.swings import swinging

            return swinging(self.course, term)
        if term.at == ANY_TIME:
            raise NotConfirmed("a function of time")
        if isinstance(term.by, str):
            term = replace(term, by=None)
        if term.modifier in ("", "size of"):
            return self.over(term) if path.quantity in SPANNED else self.at_state(term)
        if term.modifier in ("change of", "lost"):
            start, end = self.ends(term)
            sign = -1.0 if term.modifier == "lost" else 1.0
            pairs = [(met, put) for put, met in self.course.brought(start, end)]
            changes = [(self.read(start, term), self.read(end, term))]
            changes += [(reading(one, path, term), reading(other, path, term)) for one, other in pairs]
            return change_over(changes, sign)
        if term.modifier == "mean":
            return self.mean(term)
        if term.modifier == "total":
            return self.total(term)
        raise NotConfirmed(f"`{term.modifier}` of a quantity on its way")

    def ends(self, term: Term) -> tuple[str, str]:
        """The states from and to which a term is asked: its phase or event, the state before the one named, or the whole scene."""
        names = self.course.names
        if term.during is not None:
            return self.course.ends(term.during)
        if term.at is not None and term.at in names:
            return names[max(0, names.index(term.at) - 1)], term.at
        return term.start or names[0], term.end or names[-1]

    def at_state(self, term: Term) -> Reckoned:
        """At the state that is named, else at any at which it is told."""
        if term.during is not None:
            return self.over(term)
        reason: NotConfirmed | None = None
        for state in [term.at] if term.at else self.course.names:
            try:
                return self.read(state, term)
            except NotConfirmed as error:
                reason = reason or error
        raise reason or NotConfirmed("no state tells it")

    def read(self, state: str, term: Term) -> Reckoned:
        """The meaning of a path at a state; Astray for what goes by the forces there where something that only pushes or pulls would do
        the opposite."""
        at, dimension = self.course.node(state), QUANTITIES[term.path.quantity].dimension
        if dimension in (*OF_RATES, *OF_FORCES):
            own = term.path.owner if dimension in OF_FORCES else ""  # its own push says by its sign that it lets go
            letting = [(kind, owner) for owner, kind in at.moment.lifted if kind == EDGE or owner != own]
            if letting:
                from rotsolve.confirm.course.astray import letting_go

                words = letting_go(*letting[0])
                raise Astray(f"{words} at `{state}`" if state else words)
        if term.path.quantity in PLACES:
            check_pushed(at)
        return reading(at, term.path, term)

    def over(self, term: Term) -> Reckoned:
        """What comes together between two states: time, way, angle, work, impulse."""
        from rotsolve.confirm.course.spans import SPANS, Between

        start, end = self.ends(term)
        function = SPANS.get(term.path.quantity)
        if function is None:
            raise NotConfirmed(f"`{term.path.quantity}` between two states")
        return function(Between(self.course, start, end), term)

    def mean(self, term: Term) -> Reckoned:
        """What is summed over time, by the time."""
        summed = MEANS.get(term.path.quantity)
        start, end = self.ends(term)
        if summed is None or isinstance(term.by, Path):
            return self.mean_of(term, start, end)
        time = self.course.time(start, end)
        if time == 0.0:
            raise NotConfirmed("a mean over no time")
        path = replace(term.path, quantity=summed[0])
        whole = self.timed(replace(term, path=path, modifier=summed[1], start=start, end=end, at=None, during=None))
        return Reckoned({key: part / time for key, part in whole.values.items()}, whole.size / time)

    def mean_of(self, term: Term, start: str, end: str) -> Reckoned:
        """∫ Q dt by the time, or ∫ Q dx by the way or turn that `by` speaks of."""
        from rotsolve.confirm.course.spans import SPANS, Between

        span, by = Between(self.course, start, end), term.by if isinstance(term.by, Path) else None
        rate = None if by is None else Path(by.owner, "angular_velocity" if by.quantity == "rotation" else "velocity")
        plain = replace(term, modifier="", by=None, start=None, end=None, at=None, during=None)

        begun = reading(self.course.node(start), plain.path, plain).values

        def effort(at: Node) -> float:
            found = reading(at, plain.path, plain)
            size = along_first(found.values, begun) if "x" in begun else found.number
            return size * (1.0 if rate is None else reading(at, rate).number)

        over = self.course.time(start, end) if by is None else SPANS[by.quantity](span, Term(by)).number
        if over == 0.0:
            raise NotConfirmed("a mean over no time" if by is None else "a mean over no way")
        whole = span.sum(effort)
        return number(whole.number / over, whole.size / abs(over))

    def total(self, term: Term) -> Reckoned:
        """Both ways added."""
        start, end = self.ends(term)
        word = {"rotation": "total rotation", "turns": "total turns", "displacement": "distance"}.get(
            term.path.quantity
        )
        if word is None:
            raise NotConfirmed(f"the total of `{term.path.quantity}`")
        from rotsolve.confirm.course.spans import SPANS, Between

        return SPANS[word](Between(self.course, start, end), term)


def along_first(found: Mapping[str, float], begun: Mapping[str, float]) -> float:
    """The part of a vector along the way in which it points at first."""
    size = math.hypot(begun["x"], begun["y"])
    if size == 0.0:
        raise NotConfirmed("the mean of a vector that is nothing at first")
    return (found["x"] * begun["x"] + found["y"] * begun["y"]) / size


def change_over(changes: Sequence[tuple[Reckoned, Reckoned]], sign: float) -> Reckoned:
    """The sum of the last less the first of each pair; of vectors by components."""
    if all("x" in one.values for pair in changes for one in pair):
        x, y = (sign * math.fsum(last.values[axis] - first.values[axis] for first, last in changes) for axis in "xy")
        return vector((x, y))
    size = max(abs(one.number) for pair in changes for one in pair)
    return number(sign * math.fsum(last.number - first.number for first, last in changes), size)


def reading(at: Node, path: Path, term: Term | None = None) -> Reckoned:
    """The meaning of a path at one instant."""
    if path.owner in at.model.seats:
        return of_body(at, path, term)
    if not path.owner:
        from rotsolve.confirm.course.mechanics import of_scene

        return of_scene(at, path, term)
    from rotsolve.confirm.course.elements import OF_ELEMENTS

    found = OF_ELEMENTS.get(path.quantity)
    if found is None:
        raise NotConfirmed(f"{spoken(path.quantity)} of a connection or an action")
    return found(at, path, term)


__all__ = ["Asker", "Condition", "reading"]


def check_pushed(at: Node) -> None:
    """Astray where something that only pushes or pulls would have to do the opposite at a place in balance."""
    state = at.model.acting.state
    for owner in at.moment.unheld if state.balance else ():
        raise Astray(f"`{owner}` lets go at `{state.name}`: there is no balance")
