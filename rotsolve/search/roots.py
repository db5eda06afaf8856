"""Roots: which of several roots is meant: the first moment, the stable place, the first place reached, the expected sign."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import decided_by_size
from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number, Symbol, call
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, INERTIA, LENGTH, MASS
from rotsolve.core.derivation import Words
from rotsolve.core.passage import Passage
from rotsolve.core.symbols import POSITION, RATES, REST, is_key, key_of, of_kinds
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Given, references
from rotsolve.motion.positive import is_angle
from rotsolve.paths.meaning import NotYet
from rotsolve.search.expected import Expected
from rotsolve.search.first_reached import FirstReached, gaps_to_surfaces
from rotsolve.search.numbers import Numbers
from rotsolve.solver.steps import PickedRoot

if TYPE_CHECKING:
    from rotsolve.search.search import Search

BODILY = (LENGTH, MASS, INERTIA)
SAME = 1e-9  # relative difference up to which two places lie equally far to either side


class RootChoice(Struct, frozen=True):
    """Chooses between the roots of an equation; `definition` tells what an asked letter stands for."""

    scene: SceneEquations
    givens: Mapping[str, Given]
    numbers: Numbers
    definition: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[Formula], period: Formula | None = None) -> PickedRoot | None:
        """The root that is meant, with the reason; a `period` later the equation holds again."""
        picked = self._in_space(name, roots, period) if self.scene.configuration.problem.space else None
        if picked is not None:
            return picked
        outwards = [index for index, root in enumerate(roots) if self._lacks_numbers(root)]
        if outwards and len(roots) > 1 and self._on_shaft(name):
            return PickedRoot(outwards[0], ("out from the axis, where the shaft turns fast enough for it",))
        real = [(index, number) for index, root in enumerate(roots) if (number := self.numbers.of(root)) is not None]
        if len(roots) > 1 and any(
            map(self._lacks_numbers, roots)
        ):  # 0 for all values of a letter is the start, or none
            real = [(index, number) for index, number in real if number]
        if not real:
            return self._unnumbered(name, roots) if any(map(self._lacks_numbers, roots)) else None
        numbered = [(index, roots[index]) for index, _ in real]
        later = self._first_moment(name, numbered, period)
        if later is not None:
            return later
        if len(real) > 1 and len(front := [entry for entry in real if self.in_front(name, roots[entry[0]])]) < len(
            real
        ):
            real = front or real
            numbered = [(index, roots[index]) for index, _ in real]
        moved = [entry for entry in real if entry[1]]
        dropped: Words = ()
        if len(moved) < len(real) and moved and self._is_change(name):
            real, dropped = moved, ("the root 0 is the start itself",)
            numbered = [(index, roots[index]) for index, _ in real]
        if not dropped and len(real) > 1 and len(left := self._left(name, real, roots)) < len(real):
            real, dropped = left, ("the other root is the start itself",)
            numbered = [(index, roots[index]) for index, _ in real]
        if len(real) == 1:
            index, number = real[0]
            opposed = isinstance(roots[index], Number) and self._expected(name)[0](roots[index]) == -1
            return PickedRoot(index, dropped, fits=not opposed)
        return self._of_several(name, real, numbered, roots, period)

    def _in_space(self, name: str, roots: Sequence[Formula], period: Formula | None) -> PickedRoot | None:
        """What tells in space which root is meant: by the letter of the laws of which this is a multiple, else where a hinge comes."""
        from rotsolve.space.roots import chosen

        letter, worth = self._multiple(name, roots)
        return chosen(letter, worth, self.scene, self.numbers, period) or self._first_on_hinge(name, roots, period)

    def in_front(self, name: str, root: Formula) -> bool:
        """Whether with a root for its angle a body in balance lies in front of all surfaces that it touches, and is pushed by them."""
        if not any(state.balance for state in self.scene.configuration.timeline.states):
            return True
        from rotsolve.search.swings import balanced

        gaps = (
            gap
            for body, _, facts in balanced(name, self.scene)
            for gap in gaps_to_surfaces((body.name,), facts.state, self.scene)
        )
        if any(self.numbers.side(gap.substitute({name: root})) == -1 for gap in gaps):
            return False
        from rotsolve.search.pressing import pushes_of

        pushes = pushes_of(name, self.scene, self.numbers)
        return all(self.numbers.side(push.substitute({name: root})) != -1 for push in pushes)

    def _first_on_hinge(self, name: str, roots: Sequence[Formula], period: Formula | None) -> PickedRoot | None:
        """Of several angles of a body on a hinge in space the one to which it comes first."""
        from rotsolve.space.roots import way_on_hinge

        way = way_on_hinge(name, self.scene, self.numbers) if len(roots) > 1 else None
        places = [(index, root, root) for index, root in enumerate(roots) if self.numbers.of(root) is not None]
        if way is None or not places:
            return None
        reached = FirstReached(self.scene, self.numbers, self.definition)
        return reached.first_of(places, *way, ONE, again=period is not None)

    def _of_several(
        self,
        name: str,
        real: list[tuple[int, float]],
        numbered: list[tuple[int, Formula]],
        roots: Sequence[Formula],
        period: Formula | None,
    ) -> PickedRoot:
        """Of several roots that have numbers the one that is meant: a double one, the stable one, the first reached, the expected sign."""
        if all(self.numbers.side(root - numbered[0][1]) == 0 for _, root in numbered[1:]):
            return PickedRoot(real[0][0], ("the roots coincide: it is only just reached",))
        stable = self.coming_back(name, [root for _, root in numbered])
        if stable:
            found = sorted([real[place] for place in stable], key=lambda entry: entry[1] < 0)
            count = len({self._once_round(name, number) for _, number in found})
            one = "the stable one" if count == 1 else f"of {count} stable ones that nearest to zero"
            told: Words = (f"{one}: a body displaced from it comes back",)
            alike = tuple(index for index, _ in found)
            return PickedRoot(self._smallest(found, roots), told, guessed=count > 1, alike=alike)
        reached = FirstReached(self.scene, self.numbers, self.definition).choose(name, numbered, period)
        reached = self._first_round(name, numbered) if reached is None else reached
        if reached is not None:
            return reached
        fits, words = self._expected(name)
        fitting = [entry for entry in real if fits(roots[entry[0]]) == 1]
        if len(fitting) > 1 and (sooner := self._soonest(name, [(k, roots[k]) for k, _ in fitting])) is not None:
            return sooner
        if fitting:
            return PickedRoot(self._smallest(fitting, roots), words, guessed=len(fitting) > 1)
        if self._is_angle(name):
            return PickedRoot(self._smallest(real, roots), ("the smallest angle",), guessed=True)
        positive = [entry for entry in real if entry[1] >= 0]
        # where all have the wrong sign, one that fits lies farther
        opposed = all(isinstance(root, Number) and fits(root) == -1 for _, root in numbered)
        picked = self._smallest(positive or real, roots)
        return PickedRoot(picked, ("the positive root",), guessed=len(positive) != 1, fits=not opposed)

    def _first_round(self, name: str, roots: Sequence[tuple[int, Formula]]) -> PickedRoot | None:
        """Of several places on a round side of a body the one to which comes first what is told to move at the state before."""
        quantity = self.scene.registry.quantities.get(name)
        if quantity is None or quantity.kind != "angle" or quantity.owner in self.scene.configuration.bodies:
            return None
        found = Expected(self.scene, self.givens, self.numbers).round_from(quantity.owner, quantity.when)
        start = None if found is None else self.numbers.found(found[0])
        if found is None or start is None:
            return None
        sense, ways = found[1], list[tuple[float, int, int]]()
        for index, root in roots:
            place = self.numbers.of(root)
            if place is not None:
                way = (sense * (place - start)) % math.tau
                way = way if way > SAME else way + math.tau
                ways.append((way, index, round((start + sense * way - place) / math.tau)))
        if not ways:
            return None
        decided_by_size()
        _, index, turns = min(ways)
        return PickedRoot(index, ("the first place to which it comes",), Fraction(turns), 2 * PI)

    def _left(self, name: str, real: list[tuple[int, float]], roots: Sequence[Formula]) -> list[tuple[int, float]]:
        """Without the place from which a motion along a line sets out from rest, where it is looked for at rest again."""
        for start in self._left_at_rest(name):
            known = self.numbers.with_answers(start)
            begun = self.numbers.of(known) or 0.0
            exact = [(k, number) for k, number in real if self.numbers.side(roots[k] - known) != 0]
            return [(k, number) for k, number in exact if abs(number - begun) > SAME * abs(begun)] or real
        return real

    def _left_at_rest(self, name: str) -> Iterator[Formula]:
        """The places along lines, or along what carries a body, that a motion leaves from rest, and comes to rest again at one sought."""
        for passage in self.scene.passages.values():
            for travel in passage.travels:
                asked = travel.pace == POSITION and travel.end == Symbol(name)
                if asked and travel.kind == "line" and travel.before == ZERO and self._rests(travel.after, passage):
                    yield travel.start or ZERO
            for ride in self.scene.configuration.rides(passage.start.state):
                rider, states = ride.rider.owner, (passage.start.state, passage.end.state)
                start, end = (getattr(self.scene.configuration.body(rider, at).shape, "radius", None) for at in states)
                rates = [self.scene.instant(at).outward(rider) for at in states]
                if start is not None and end == Symbol(name) and rates == [ZERO, ZERO]:
                    yield start

    def _rests(self, rate: Formula, passage: Passage) -> bool:
        """Whether a rate at the end of a phase is zero, as told or by what ties it to others."""
        if not isinstance(rate, Symbol):
            return rate == ZERO
        ties = [rule.velocity[0] - rule.velocity[1] for rule in self.scene.facts(passage.end.state).rules]
        names = {rate.name}
        while len(more := names.union(*(tie.symbols() for tie in ties if tie.symbols() & names))) > len(names):
            names = more
        rates = of_kinds(names, RATES)
        try:
            found = solve_all([tie for tie in ties if tie.symbols() & names], rates)
        except (NotLinear, Singular):
            return False
        return is_zero(found.get(rate.name, rate))

    def _expected(self, name: str) -> tuple[Callable[[Formula], int], Words]:
        """Which sign a letter must have, +1 for a value that has it; also of one that a single other letter tells, as an angular momentum
        that of a turn, or a work a way: what that letter would be must have its sign."""
        expected = Expected(self.scene, self.givens, self.numbers)
        sign, words = expected.sign(name)
        worth: Formula = Symbol(name)
        for letter, value in () if sign else self._led_by(name):
            sign, words = expected.sign(letter)
            if not sign and self._is_rate(letter):  # its positive root is taken where it is asked for itself
                sign, words = 1, (Symbol(letter), " > 0")
            if sign:
                worth = value
                break
        return lambda value: sign * (self.numbers.side(worth.substitute({name: value})) or 0), words

    def _soonest(self, name: str, roots: Sequence[tuple[int, Formula]]) -> PickedRoot | None:
        """Of several roots of a letter that tells a time, as a mean velocity does, that of the first one; None where it tells none."""
        quantities = self.scene.registry.quantities
        for letter, value in self._led_by(name):
            times = [(self.numbers.of(value.substitute({name: root})), k) for k, root in roots]
            known = [(time, k) for time, k in times if time is not None]
            if letter in quantities and quantities[letter].kind == "time" and len(known) == len(times):
                decided_by_size()
                return PickedRoot(min(known)[1], ("the first time",))
        return None

    def _led_by(self, name: str) -> list[tuple[str, Formula]]:
        """The letters for which one stands that are found by it, or the only one that is not found, each with what it is by it."""
        own = self.definition(name) or self._spelled(name)
        found = {key: self.numbers.with_answers(Symbol(key)) for key in own.symbols() if is_key(key)} if own else {}
        led = [(key, value) for key, value in found.items() if name in value.symbols()]
        left = [key for key, value in found.items() if key in value.symbols()]
        if own is None or led or len(left) != 1:
            return [] if left else sorted(led)
        formula = own.substitute({key: value for key, value in found.items() if key != left[0]})
        rest, whole = (formula.substitute({left[0]: value}) for value in (ZERO, ONE))
        share = simplify(whole - rest)
        linear = share != ZERO and is_zero(formula - rest - share * Symbol(left[0]))
        return [(left[0], (Symbol(name) - rest) / share)] if linear else []

    def _is_rate(self, name: str) -> bool:
        """Whether a letter of the laws tells how fast something moves or turns."""
        quantity = self.scene.registry.quantities.get(name)
        return quantity is not None and quantity.kind in ("velocity", "angular_velocity")

    def _multiple(self, name: str, roots: Sequence[Formula]) -> tuple[str, Sequence[Formula]]:
        """The letter of the laws of which a letter of a question is a multiple, as a component of ω is one of the rate about an axis, with
        what the roots are of that.
        """
        formula = self.definition(name)
        letters = [key for key in formula.symbols() if is_key(key)] if formula is not None else []
        if formula is None or len(letters) != 1:
            return name, roots
        share = formula.substitute({letters[0]: ONE})
        if is_zero(share) or not is_zero(formula - share * Symbol(letters[0])):
            return name, roots
        return letters[0], [root / share for root in roots]

    def _spelled(self, name: str) -> Formula | None:
        """What the letter of a work stands for."""
        works = (work for passage in self.scene.passages.values() for work in passage.works)
        return next((work.spelled for work in works if work.amount == Symbol(name)), None)

    def _smallest(self, entries: Sequence[tuple[int, float]], roots: Sequence[Formula]) -> int:
        """The root nearest to zero, of two that are equally far the first."""
        chosen = [roots[index] for index, _ in entries]
        if len(entries) < 2 or not any(map(self.numbers.signs.lacking, chosen)):
            return nearest_to_zero(entries)
        return entries[self.numbers.least([call("abs", root) for root in chosen])][0]

    def _on_shaft(self, name: str) -> bool:
        """Whether a letter tells the angle at which a body stands steadily on a turning shaft."""
        if not any(state.steady for state in self.scene.configuration.timeline.states):
            return False
        from rotsolve.search.swings import on_shaft

        return bool(on_shaft(name, self.scene))

    def coming_back(self, name: str, roots: Sequence[Formula]) -> list[int]:
        """Places of the roots at which a body that stands somewhere comes back when it is displaced."""
        if not any(state.balance or state.steady for state in self.scene.configuration.timeline.states):
            return []
        if self.scene.configuration.problem.space:
            from rotsolve.space.carried_swings import stable_places

            return stable_places(name, roots, self.scene.dynamics, self.numbers)  # type: ignore[attr-defined]
        from rotsolve.search.swings import stable_roots

        letter, scale, shift = FirstReached(self.scene, self.numbers, self.definition).place_behind(name)
        return stable_roots(letter, [(root - shift) / scale for root in roots], self.scene, self.numbers.signs)

    def _first_moment(
        self, name: str, roots: Sequence[tuple[int, Formula]], period: Formula | None
    ) -> PickedRoot | None:
        """Of times that come again the first one after the state before."""
        quantity = self.scene.registry.quantities.get(name)
        side = self.numbers.side(period) if period is not None else None
        if quantity is None or quantity.kind != "time" or period is None or not side:
            return None
        period = period if side > 0 else -period
        begun = self._begun(quantity.when)
        counts = [] if begun is None else [(k, self.numbers.whole((begun - root) / period), root) for k, root in roots]
        moments = [(k, count + 1, root + (count + 1) * period) for k, count, root in counts if count is not None]
        if not moments:
            return None
        index, count, _ = moments[self.numbers.least([moment for _, _, moment in moments])]
        return PickedRoot(index, ("the first moment at which this holds",), Fraction(count), period)

    def _begun(self, when: str) -> Formula | None:
        """The time at the state before a state; 0 for the duration of a phase."""
        timeline = self.scene.configuration.timeline
        if timeline.interval(when) is not None:
            return ZERO
        before = timeline.before(when) if when in timeline.order else None
        return self.numbers.with_answers(self.scene.instant(before.start).time()) if before else None

    def _is_change(self, name: str) -> bool:
        """Whether a quantity is a change since the state before, or its time; a stretch is one where the spring was not stretched."""
        quantity = self.scene.registry.quantities.get(name)
        if quantity is None or quantity.kind != "elongation":
            return quantity is not None and quantity.kind in ("displacement", "rotation", "time")
        travels = (travel for passage in self.scene.passages.values() for travel in passage.travels)
        starts = [travel.start for travel in travels if travel.end == Symbol(name)]
        return all(start is None or self.numbers.found(start) == 0.0 for start in starts)

    def _is_angle(self, name: str) -> bool:
        """Whether a letter is an angle."""
        given, quantity = self.givens.get(name), self.scene.registry.quantities.get(name)
        if quantity is not None:
            return quantity.kind == "angle"
        return given is not None and (given.dimension is None or is_angle(given))

    def _once_round(self, name: str, number: float) -> float:
        """A root, of an angle that within half a turn, as far as two are told apart."""
        within = math.remainder(number, math.tau) if self._is_angle(name) else number
        return round(within / SAME) * SAME

    def _unnumbered(self, name: str, roots: Sequence[Formula]) -> PickedRoot:
        """Without numbers a root is chosen by the sign that the scene suggests: not negative unless said."""
        sign, words = Expected(self.scene, self.givens, self.numbers).sign(name)
        moved = [index for index, root in enumerate(roots) if root != ZERO] or [0]
        if sign < 0 and len(roots) > 1:
            return PickedRoot(moved[-1], words)
        return PickedRoot(moved[0], words or ("the root along the positive sense",))

    def _lacks_numbers(self, root: Formula) -> bool:
        """Whether a root holds a given without a number."""
        signs = self.numbers.signs
        return not signs.trials.keys() >= set(signs.lacking(root))


def among(fitting: Sequence[int], picked: PickedRoot) -> PickedRoot:
    """A root that is picked of those that fit, as one of all roots."""
    return replace(picked, root=fitting[picked.root], alike=tuple(fitting[index] for index in picked.alike))


def by_motion(name: str, roots: Sequence[Formula], search: Search) -> PickedRoot | None:
    """The rate in a scene in space with whose sense alone the motion comes to where a later state has it."""
    if len(roots) < 2 or not search.scene.configuration.problem.space:
        return None
    from rotsolve.search.ways_on_joints import only_sense, sense_set_out

    alone = only_sense(name, roots, search)
    alone = sense_set_out(name, roots, search) if alone is None else alone
    return None if alone is None else PickedRoot(alone, ("in the other sense it never comes there",))


def nearest_turn(
    name: str, picked: PickedRoot, roots: Sequence[Formula], period: Formula | None, search: Search
) -> PickedRoot:
    """The root of an angle that is sought from −180° to 180°, to which no motion comes, if it holds a whole turn on."""
    given = search.givens.get(name)
    if given is None or not given.asked or picked.reached or period is None or not search.may_be_angle(name):
        return picked
    parts, root = simplify(2 * PI / period), picked.of(roots)
    whole = isinstance(parts, Number) and parts.value.denominator == 1 and is_zero(picked.period - 2 * PI)
    if not whole or search.numbers.of(root) is None:
        return picked
    more = 1 if search.numbers.side(root + PI) == -1 else -1 if search.numbers.side(root - PI) == 1 else 0
    return replace(picked, turns=picked.turns + more) if more else picked


def nearest_to_zero(entries: Sequence[tuple[int, float]]) -> int:
    """The root nearest to zero, of two that are equally far the first; its size is compared only where there are several."""
    least = abs(min(entries, key=lambda entry: abs(entry[1]))[1])
    near = [entry for entry in entries if abs(entry[1]) <= least * (1 + SAME)]
    if len(entries) > 1:
        decided_by_size()
    return near[0][0]


def extreme_root(name: str, roots: Sequence[Formula], picked: PickedRoot, asked: Find, search: Search) -> PickedRoot:
    """The `largest` or the `smallest` root that a letter of the scene can be; the picked one where numbers do not tell.

    A size is positive; a rate in space has its sign, but for the least with which a motion is stable or steady.
    """
    from rotsolve.language.limited import letters_of_places
    from rotsolve.motion.limits import limits_of_scene

    numbers, given, word = search.numbers, search.givens[name], asked.modifier
    told = [limit for limit in limits_of_scene(search.scene.configuration) if name in limit.gap.symbols()]
    limits, strict = [limit.gap for limit in told], {limit.gap for limit in told if limit.strict}
    by_value = search.scene.configuration.problem.space and not (asked.where is not None and asked.where.word)
    signed = given.dimension is None or is_angle(given) or (by_value and given.dimension.matches(ANGULAR_VELOCITY))
    signed = signed or name in letters_of_places(search.scene.configuration.problem)
    limits += [] if signed else [Symbol(name)]
    if search.scene.configuration.problem.space:
        from rotsolve.space.steady import tilts_with

        limits += [gap for tilt in tilts_with(name, search.scene) for gap in (tilt, PI - tilt)]
    passed = () if search.ground is None else search.ground.passed_over.get(name, ())

    def beyond(root: Formula, gap: Formula) -> bool:
        return numbers.side(numbers.with_answers(gap.substitute({name: root}))) in (-1, 0 if gap in strict else -1)

    real = [index for index, root in enumerate(roots) if numbers.of(root) is not None and root not in passed]
    able = [index for index in real if not any(beyond(roots[index], gap) for gap in limits)]
    arguments = (ref.argument for ref in references(search.scene.configuration.problem) if ref.argument)
    placed = any(name in argument.symbols() for argument in arguments)
    bodily = given.dimension in BODILY and not (placed or signed)
    if bodily:  # without a length, or a mass, there is no body; a place is at an end too
        able = [index for index in able if numbers.side(roots[index]) == 1] or able
    choice = RootChoice(search.scene, search.givens, numbers, search.definitions.formula)
    stable = choice.coming_back(name, roots) if asked.where is None else []  # what a displaced body comes back to
    able = [index for index in able if index in stable] or able
    if not able:
        return picked
    sign = -1 if word == "largest" else 1
    best = able[numbers.least([sign * roots[index] for index in able])]
    alike = tuple(stable and able)
    return picked if best == picked.root else PickedRoot(best, (f"the {word}",), guessed=True, alike=alike)


def check_alone(name: str, roots: Sequence[Formula]) -> None:
    """Where a body on a line is in equilibrium has to be told where that may be at several places, of which several may be stable."""
    key = key_of(name) if is_key(name) else None
    if key is not None and key.kind == "displacement" and key.when.startswith(REST) and len(roots) > 1:
        body = spoken(key.owner)
        raise NotYet(f"`{body}` may be in equilibrium at {len(roots)} places: about which it swings is not told")
