"""Functions of time: quantities at any time of a phase, whole ways there and back, and where a quantity is largest or smallest."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cmp_to_key
from itertools import pairwise

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate, in_powers, period_of
from rotsolve.algebra.certified.ball import Certified, decided_by_size, evaluate
from rotsolve.algebra.certified.balls import Ball, Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import degree, simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import PI, ZERO, Formula, total
from rotsolve.core.equation import REVERSAL, Equation
from rotsolve.core.quantity import QUANTITIES, SPANNED
from rotsolve.core.symbols import CONSTANT, TIME
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.motion.instant import Instant
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import rotation, so_far
from rotsolve.paths.displacements import way
from rotsolve.paths.meaning import Meaning, NotYet, Unclear, path_text, vector_size

FIGURES = 30  # to which a zero is known before it is told from the end of a phase


class Beside(Struct, frozen=True):
    """Settles formulas of the laws without a trace, and looks at them as functions of time."""

    settle: Callable[[Formula], Formula | None]
    signs: SignOracle

    @property
    def values(self) -> Mapping[str, Formula]:
        """The numbers of all letters, of those without one that in the case that is looked at."""
        return {**self.signs.values, **self.signs.trials}

    def settled(self, value: Formula, what: str) -> Formula:
        """A formula with every letter of the laws worked out; refused where the laws do not tell it as a function of time."""
        found = self.settle(value)
        if found is None or found.symbols() - set(self.values) - {TIME}:
            raise NotYet(
                f"`{what}` is not known as a function of time with numbers for all its letters",
                help="name the turning point as a state, such as `{wheel.angular_velocity: 0}`",
            )
        return found

    def number(self, value: Formula, time: Formula | None = None) -> float:
        """A rough value, at a time where it depends on it."""
        decided_by_size()
        known = self.values if time is None else {**self.values, TIME: time}
        try:
            return evaluate(value, known, digits=12).float
        except (Undefined, ZeroDivisionError):
            raise NotYet("a value on the way is not defined") from None

    def side(self, value: Formula) -> int:
        """The sign of a value that does not depend on time; 0 where no precision tells it from 0."""
        number = self.signs.supposed(value)
        if number is None:
            raise NotYet("a value on the way is not defined")
        return number.sign or 0

    def zeros(self, function: Formula, start: Formula, end: Formula) -> list[Formula]:
        """The times between the ends at which a function of time changes its sign, in order and in closed form."""
        if TIME not in function.symbols():
            return []
        if is_linear_in_time(function):
            (root,) = solve_polynomial(function, TIME)
            return [root] if self.side(root - start) > 0 > self.side(root - end) else []
        found = real_roots(function, TIME, self.values, start, end)
        if not found.complete:
            raise NotYet("where it changes its sign can not be told for certain")
        first, last = self.ball(start), self.ball(end)
        inside = [root for root in found.roots if first < root.refine(FIGURES) < last]
        exact = solve_polynomial(function, TIME) or solve_trig(function, TIME)
        if self.signs.trials.keys() & (function.symbols() | start.symbols() | end.symbols()):
            self.suppose_within(function, exact, start, end)
        return [self._closed(root, exact, period_of(function, TIME)) for root in inside]

    def suppose_within(self, function: Formula, exact: Sequence[Formula], start: Formula, end: Formula) -> None:
        """Make it a condition of the case which zeros of a function lie between the ends; a swing has too many to tell."""
        if not exact or period_of(function, TIME) is not None:
            raise NotYet("how often it changes its sign depends on the givens: give them numbers")
        for root in exact:
            for gap in (root - start, end - root):
                self.signs.supposed(gap)

    def ball(self, value: Formula) -> Ball:
        """A value that does not depend on time, to many figures."""
        return evaluate(value, self.values, digits=FIGURES).ball

    def _closed(self, root: Certified, exact: list[Formula], period: Formula | None) -> Formula:
        """The closed form of a zero, whole periods later where the motion swings."""
        for form in exact:
            with suppress(Undefined):  # a root that is no real number
                periods = 0 if period is None else round((root.float - self.number(form)) / self.number(period))
                whole = form if period is None else form + periods * period
                if self.ball(whole).overlaps(root.refine(FIGURES)):
                    return simplify(whole)
        raise NotYet("the moment at which it changes its sign has no closed form")


def is_linear_in_time(function: Formula) -> bool:
    """Whether a function of time is linear, so that its zero needs no choice."""
    return degree(function, TIME) == 1


def phases_of(term: Term, scene: SceneEquations) -> tuple[Interval, ...]:
    """The phases in which a function of time is asked; several only where a given motion is one function throughout."""
    timeline = scene.configuration.timeline
    intervals = timeline.between(term.start, term.end) if term.start and term.end else timeline.intervals
    wanted = (interval for interval in intervals if interval.event is None)
    named = tuple(
        interval
        for interval in wanted
        if term.during in (None, interval.name, interval.whole) and not timeline.state(interval.start).opened
    )
    if not named:
        raise Unclear("a function of time is asked of a phase", help="say `at any time during PHASE`")
    if len(named) > 1 and not (
        term.path.owner in scene.configuration.bodies and one_function(term.path.owner, intervals, scene)
    ):
        names = ", ".join(f"`from {interval.start} to {interval.end}`" for interval in named)
        raise Unclear("the motion may be another function in each phase", help=f"say in which: {names}")
    return named


def meaning_at_any_time(term: Term, scene: SceneEquations) -> tuple[Meaning, str]:
    """The meaning at the running time, with its sign, in the phase that is named or in the only one."""
    named = phases_of(term, scene)
    if term.modifier not in ("", "size of"):
        raise NotYet(f"`{term.modifier}` of a function of time is not solved yet")
    check_pace(term.path, named[0], scene)
    start, path = named[0].start, term.path
    if path.quantity in SPANNED:
        middle = scene.instant(start, generic=True)
        return Meaning(run_up(path, middle), QUANTITIES[path.quantity].dimension), named[0].name
    return scene.reader(start, generic=True).meaning(path, term), named[0].name


def check_pace(path: Path, interval: Interval, scene: SceneEquations) -> None:
    """A motion whose acceleration goes by the place or the speed is not written as a function of the running time."""
    name = scene.instant(interval.start).host(path.owner) if path.owner in scene.configuration.bodies else ""
    for travel in scene.passages[interval.name].travels:
        if travel.body == name and travel.pace not in (CONSTANT, TIME) and travel.given not in (0, 1):
            help = "ask for it at a state whose time is a letter: `end: {time: t1}`"
            raise NotYet(f"the motion of `{name}` as a function of time is not solved yet", help=help)


def one_function(name: str, intervals: tuple[Interval, ...], scene: SceneEquations) -> bool:
    """Whether a body moves by one given function through several phases, with no event between them."""
    drives = {scene.configuration.drives(name, interval.start) for interval in intervals}
    return len(drives) == 1 and drives != {()} and all(interval.event is None for interval in intervals)


def run_up(path: Path, middle: Instant) -> Formula:
    """What has come together from the start of a phase up to the running time."""
    if path.owner not in middle.configuration.bodies:
        raise NotYet(f"`{path_text(path)}` as a function of time is not solved yet")
    name = middle.host(path.owner)
    if path.quantity == "displacement":
        return way(path, name, None, middle)
    if path.quantity in ("rotation", "turns"):
        turned = middle.as_counted(so_far("rotation", name, middle), path.owner)
        return turned / (2 * PI) if path.quantity == "turns" else turned
    raise NotYet(f"`{path.quantity}` as a function of time is not solved yet")


RATE = {"rotation": "angular_velocity", "displacement": "velocity"}


def whole_way(term: Term, start: str, end: str, scene: SceneEquations, beside: Beside | None) -> tuple[Meaning, str]:
    """∫|ω| dt or ∫|v| dt: the sizes of the parts between the moments of reversal, added up."""
    path, first = term.path, scene.instant(start)
    name = first.host(path.owner)
    arm: Formula | None = None
    word = {"distance": "displacement", "turns": "rotation"}.get(path.quantity, path.quantity)
    if path.quantity == "distance" and first.motion(name).kind == "axis":
        reach = first.point(PointRef(path.owner, path.point or "cm", path.argument))
        word, arm = "rotation", reach.parts[0][0] if len(reach.parts) == 1 else vector_size(reach)
    if word not in RATE or beside is None or path.owner not in scene.configuration.bodies:
        raise NotYet(f"the total of `{path_text(path)}` is not solved yet")
    pieces: list[Formula] = []
    laws: list[Equation] = []
    intervals = scene.configuration.timeline.between(start, end)
    for interval in intervals:
        if interval.event is None:
            found, reversals = reversed_parts(word, name, path, interval, scene, beside)
            pieces, laws = pieces + found, laws + reversals
    result = total(pieces)
    whole = "angle turned" if word == "rotation" else "way"
    label = f"whole {whole} of {spoken(name)}" + (", both ways added" if laws else "")
    if arm is not None:
        result, label = arm * result, f"way of a point on {spoken(name)}, s = r φ"
    if path.quantity == "turns":
        result = result / (2 * PI)
    return Meaning(result, QUANTITIES[path.quantity].dimension, label=label, laws=tuple(laws)), intervals[-1].name


def reversed_parts(
    word: str, name: str, path: Path, interval: Interval, scene: SceneEquations, beside: Beside
) -> tuple[list[Formula], list[Equation]]:
    """The parts of one phase, each counted positive, with what tells when the motion reverses and how far it has come then."""
    first, middle = scene.instant(interval.start), scene.instant(interval.start, generic=True)
    times = [beside.settled(scene.instant(state).time(), "time") for state in (interval.start, interval.end)]
    if beside.side(times[1] - times[0]) != 1:
        help = "give numbers to the letters" if beside.signs.trials else ""
        raise NotYet(f"how long `{interval.name}` lasts is not told by these laws", help=help)
    speed = beside.settled(rate_along(word, name, middle), RATE[word])
    change = (
        rotation(name, interval, first) if word == "rotation" else way(replace(path, owner=name), name, interval, first)
    )
    turns = beside.zeros(speed, times[0], times[1])
    marks: list[Formula] = [ZERO]
    laws: list[Equation] = []
    for number, moment in enumerate(turns, 1):
        come = beside.settled(so_far(word, name, middle), word)
        turn = Reversal(word, name, interval, str(number) if len(turns) > 1 else "", speed, moment, come)
        marks.append(turn.until(first))
        laws += turn.laws(first)
    marks.append(change)
    moments = [times[0], *turns, times[1]]
    result = []
    for number, (before, after) in enumerate(pairwise(marks)):
        middle_of = (moments[number] + moments[number + 1]) / 2
        forward = beside.side(speed.substitute({TIME: middle_of})) >= 0
        result.append(after - before if forward else before - after)
    return result, laws


def rate_along(word: str, name: str, middle: Instant) -> Formula:
    """ω or v along the line, at any moment."""
    if word == "rotation":
        return middle.rate("angular_velocity", name)
    if middle.motion(name).kind != "line":
        raise NotYet(f"`{name}` does not move along a line", help="the whole way is known of bodies on a line")
    line = middle.configuration.line(name, middle.state)
    return middle.travel("velocity", name, line[1] if line else "")


class Reversal(Struct, frozen=True):
    """A moment of a phase at which a body reverses: the functions of time of its rate and of its way, and when the rate vanishes."""

    word: str
    name: str
    interval: Interval
    number: str
    speed: Formula
    moment: Formula
    come: Formula

    @property
    def when(self) -> str:
        return (
            f"{self.interval.name} reversal of {self.word} {self.number}".strip()
        )  # a body may turn back before it runs back

    def until(self, first: Instant) -> Formula:
        """The letter for the angle turned, or the way gone, until then."""
        letter = ("phi" if self.word == "rotation" else "s") + self.number
        return first.ask(self.word, self.name, when=self.when, letter=letter)

    def laws(self, first: Instant) -> Iterator[Equation]:
        """The rate vanishes, and how far the body has come by then."""
        letter, way_ = ("ω", "angle turned") if self.word == "rotation" else ("v", "way")
        body, time = spoken(self.name), first.ask("time", self.name, when=self.when, letter=f"t_r{self.number}")
        plain = is_linear_in_time(self.speed)
        zero = (self.speed.substitute({TIME: time}), ZERO) if plain else (time, self.moment)
        remark = () if plain else (f"a zero of {letter} = ", self.speed)
        phase, come = self.interval.name, self.come.substitute({TIME: time})
        yield REVERSAL.equation(*zero, phase, (), remark, words=f"{body} reverses where {letter} = 0")
        yield REVERSAL.equation(self.until(first), come, phase, words=f"{way_} until {body} reverses")


class ExtremeValue(Struct, frozen=True):
    """A value that may be the greatest, where it is taken, and the moment within the phase if it is no end."""

    value: Formula
    interval: Interval
    state: str
    moment: Formula | None = None
    function: Formula = ZERO


def extreme(term: Term, start: str, end: str, scene: SceneEquations, beside: Beside | None) -> tuple[Meaning, str]:
    """Ends of the phases against the moments between them at which the rate of the quantity vanishes."""
    if beside is None or term.path.quantity in SPANNED:
        raise NotYet(f"`{term.modifier} {term.path.quantity}` is not solved yet")
    found: list[ExtremeValue] = []
    for interval in scene.configuration.timeline.between(start, end):
        if interval.event is None:
            found += extreme_values(term, interval, scene, beside)
    if not found:
        message = (
            f"between `{start}` and `{end}` no time passes in which `{term.path.quantity}` could be {term.modifier}"
        )
        raise NotYet(message, help=f"leave `{term.modifier}` out: it has one value at `{end}`")
    sense = 1 if term.modifier == "largest" else -1

    def order(one: ExtremeValue, other: ExtremeValue) -> int:
        return sense * beside.side(one.value - other.value)

    best = max(found, key=cmp_to_key(order))
    name = f"{term.modifier} {spoken(term.path.quantity)}"
    if best.moment is None:
        meaning = scene.reader(best.state).meaning(term.path, term)
        others = any(candidate.moment is not None for candidate in found)
        why = "more than anywhere between" if term.modifier == "largest" else "less than anywhere between"
        remark = f"at {spoken(best.state)}: {why if others else 'its rate vanishes nowhere between'}"
        return replace(meaning, label=f"{name} of {spoken(term.path.owner)}", remark=remark), best.state
    return at_moment_of_extreme(term, best, name, scene)


def extreme_values(term: Term, interval: Interval, scene: SceneEquations, beside: Beside) -> list[ExtremeValue]:
    """Both ends of a phase, and every moment between at which the rate changes its sign."""
    meaning = scene.reader(interval.start, generic=True).meaning(term.path, term)
    function = beside.settled(meaning.formula, term.path.quantity)
    times = [beside.settled(scene.instant(state).time(), "time") for state in (interval.start, interval.end)]
    values = [function.substitute({TIME: time}) for time in times]
    ends = [ExtremeValue(values[0], interval, interval.start), ExtremeValue(values[1], interval, interval.end)]
    slope = simplify(differentiate(function, TIME))
    inside = beside.zeros(slope, times[0], times[1])
    return [*ends, *(ExtremeValue(function.substitute({TIME: at}), interval, "", at, function) for at in inside)]


def at_moment_of_extreme(term: Term, best: ExtremeValue, name: str, scene: SceneEquations) -> tuple[Meaning, str]:
    """The value at the moment at which the rate vanishes, with that moment as a letter of its own."""
    first = scene.instant(best.interval.start)
    owner = spoken(term.path.owner)
    when = " ".join(filter(None, (best.interval.name, name, term.path.point, term.path.component)))
    time = first.ask("time", term.path.owner, when=when, letter="t_m")
    assert best.moment is not None
    slope = in_powers(simplify(differentiate(best.function, TIME)), TIME)
    zero = (slope.substitute({TIME: time}), ZERO) if is_linear_in_time(slope) else (time, best.moment)
    law = REVERSAL.equation(*zero, best.interval.name, words=f"{name}, {owner}: its rate is zero")
    value, dimension = best.function.substitute({TIME: time}), QUANTITIES[term.path.quantity].dimension
    known = scene.reader(best.interval.start, generic=True).meaning(term.path, term)
    label = f"{name} of {owner}"
    return Meaning(value, dimension, label=label, law=known.law, words=known.words, laws=(law,)), best.interval.name
