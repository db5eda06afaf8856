"""Expected: the signs that the motion of a scene tells of: which way a body goes, and what is a size."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, call, sqrt
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.core.derivation import Words
from rotsolve.core.equation import MOMENTUM
from rotsolve.core.facts import signed
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.quantity import FREQUENCIES, PLANE
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import POSITION, RATES, key_of, of_kinds, phase_midst
from rotsolve.core.vectors.heading import heading
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Given, PointRef
from rotsolve.laws.groups import one_motion
from rotsolve.motion.timeline import Interval
from rotsolve.search.numbers import Numbers


class Expected(Struct, frozen=True):
    """What the motion of a scene tells of signs."""

    scene: SceneEquations
    givens: Mapping[str, Given]
    numbers: Numbers

    def sign(self, name: str) -> tuple[int, Words]:
        """The sign that a quantity must have, and why: (+1, −1 or 0 where nothing tells)."""
        quantity = self.scene.registry.quantities.get(name)
        if quantity is None:
            return (1, (Symbol(name), " > 0")) if self._is_size(name) else (0, ())
        sliding = self._by_momentum(name, quantity) if quantity.kind == "velocity" else 0
        if sliding:
            return self._told(quantity.kind, quantity.owner, name, sliding)
        if quantity.kind in ("velocity", "angular_velocity") and not quantity.component:
            return self._direction(quantity.kind, quantity.owner, quantity.when, name)
        if quantity.kind == "velocity" and quantity.component in PLANE:
            found = self._direction(quantity.kind, quantity.owner, quantity.when, name, quantity.component)
            if found[0]:
                return found
        if quantity.kind == "velocity" and quantity.component == "radial":
            return self._along_carrier(quantity.owner, quantity.when, name)
        if quantity.kind == "velocity" and quantity.when in self.scene.configuration.timeline.order:
            return self._by_turn(name, quantity)
        if quantity.kind in ("displacement", "rotation"):
            return self._onward(quantity.kind, quantity.owner, quantity.when, quantity.component)
        if quantity.kind in ("time", "tension", "mass", "normal_force", "period", *FREQUENCIES):
            return 1, (Symbol(name), " > 0")
        return 0, ()

    def _is_size(self, name: str) -> bool:
        """Whether a given has a dimension, so that it is meant to be positive, and is no place."""
        given = self.givens.get(name)
        if given is None or given.dimension is None or given.dimension.matches(ANGLE):
            return False
        from rotsolve.language.limited import letters_of_places

        return name not in letters_of_places(self.scene.configuration.problem)

    def _direction(self, kind: str, owner: str, state: str, name: str, axis: str = "") -> tuple[int, Words]:
        """Which way a body moves at a state, along an axis where it moves freely: the way it has gone since the state before, else as it
        started or is pushed.

        After an event, or at the first state, it is the way to the angle of the next state.
        """
        timeline = self.scene.configuration.timeline
        midst = phase_midst(state)
        if midst and (around := timeline.after(midst)) is not None:
            whole = "rotation" if kind == "angular_velocity" else "displacement"
            return self._onward(whole, owner, around.name, axis)
        if state not in timeline.order:
            return 0, ()
        before, after = timeline.before(state), timeline.after(state)
        first = before is None or before.event is not None
        phase = after if first and after is not None else before
        wanted = "turn" if kind == "angular_velocity" else "line"
        travel = self._travel(phase.name, owner, wanted, axis) if phase is not None else None
        if travel is None or phase is None:
            return 0, ()
        timed = 0 if first else self._in_time(travel, self.scene.passages[phase.name])
        if timed:
            return self._told(kind, owner, name, timed)
        change = travel.end - travel.start if travel.start is not None and travel.end is not None else None
        gone = travel.change if change is None else change
        if first:
            sign = self.numbers.sign((change,))
        elif self.numbers.found(gone) == 0.0:  # it has come back
            sign = -self.numbers.onset(travel)
        else:
            sign = self.numbers.sign((gone,)) or self.numbers.onset(travel)
        return self._told(kind, owner, name, sign) if sign else (0, ())

    def _in_time(self, travel: Travel, passage: Passage) -> int:
        """Which way a body moves after a known time where the push changes evenly with the place: v₀ cos ω t + (a₀/ω) sin ω t."""
        lead = next((one for one in passage.travels if one.leads and one.pace == POSITION), None)
        if lead is None or not isinstance(lead.coordinate, Symbol) or self.numbers.found(passage.duration) is None:
            return 0
        rate, start = self.numbers.push(lead.acceleration), self.numbers.push(travel.initial)
        slope = differentiate(rate, lead.coordinate.name) if rate is not None else None
        if (
            start is None and rate is not None and lead.start is not None and lead is travel
        ):  # the push at its first place
            start = rate.substitute({lead.coordinate.name: signed(lead.start, lead.sense)})
        if slope is None or start is None or lead.coordinate.name in slope.symbols():
            return 0
        square = -(self.numbers.with_answers(slope) * lead.sense / lead.arm)
        side, time = self.numbers.side(square), passage.duration
        if side == 0:
            return self.numbers.sign([travel.before + start * time])
        omega = sqrt(square if side == 1 else -square)
        grown, turned = call("exp", omega * time), [call(word, omega * time) for word in ("cos", "sin")]
        if side == -1:
            turned = [(grown + 1 / grown) / 2, (grown - 1 / grown) / 2]
        return self.numbers.sign([travel.before * turned[0] + start / omega * turned[1]])

    def _travel(self, interval: str, owner: str, kind: str, axis: str = "") -> Travel | None:
        """How a body goes along its line, or an axis, or turns, in a phase."""
        passage = self.scene.passages.get(interval)
        travels = passage.travels if passage is not None else ()
        return next((item for item in travels if (item.body, item.kind, item.axis) == (owner, kind, axis)), None)

    def _told(self, kind: str, owner: str, name: str, sign: int) -> tuple[int, Words]:
        """A sign with the words for it: "rod turns clockwise: ω > 0"."""
        quantity = self.scene.registry.quantities[name]
        verb = "turns" if kind == "angular_velocity" else "moves"
        words = quantity.positive if sign > 0 else quantity.negative
        return sign, (f"{spoken(owner)} {verb} {words}: ", Symbol(name), " > 0" if sign > 0 else " < 0")

    def _by_turn(self, name: str, quantity: SceneQuantity) -> tuple[int, Words]:
        """Which way a part of a velocity points: as the rules tie it to the turn of the body."""
        rules = list(self.scene.facts(quantity.when).rules)
        names = {letter for rule in rules for side in rule.velocity for letter in side.symbols()}
        rates = of_kinds(names, RATES)
        tied = (one_motion(rates, rules) or {}).get(name)
        turns = of_kinds(tied.symbols(), RATES) if tied is not None else []
        if tied is None or len(turns) != 1 or key_of(turns[0]).component:
            return 0, ()
        share = self.numbers.found(tied.substitute({turns[0]: ONE}))
        sign, words = self.sign(turns[0])
        return (0, ()) if not share else (sign if share > 0 else -sign, words)

    def _by_momentum(self, name: str, quantity: SceneQuantity) -> int:
        """The sign of a velocity that the rules and the momentum which is conserved tie to one rate alone, V = c u: that at which a body
        slides round a side of another, or turns on one, which goes to where the next state has it."""
        timeline = self.scene.configuration.timeline
        before = timeline.before(quantity.when) if quantity.when in timeline.order else None
        if before is None or before.event is not None:
            return 0
        rules = [rule.velocity[0] - rule.velocity[1] for rule in self.scene.facts(quantity.when).rules]
        kept = [
            one.left - one.right for one in self.scene.equations if (one.law, one.section) == (MOMENTUM, before.name)
        ]
        letters = of_kinds({letter for side in rules for letter in side.symbols()}, ("velocity",))
        slides = [letter for letter in letters if key_of(letter).owner not in self.scene.configuration.bodies]
        if not slides:  # round a body the speed along it has no letter
            speeds = dict(self._speeds_round(quantity.when))
            slides, rules = list(speeds), [*rules, *(speed - Symbol(letter) for letter, speed in speeds.items())]
        lead, way = self._lead(rules, slides, before, turns=bool(kept))
        if not way or lead == name:
            return way
        share = self._shared([*rules, *kept], name, lead)
        if share is None or self.numbers.side(share.substitute({lead: ZERO})) != 0:  # it moves without that too
            return 0
        return way * self.numbers.sign([share.substitute({lead: ONE})])

    def _lead(
        self, rules: Sequence[Formula], slides: Sequence[str], before: Interval, *, turns: bool
    ) -> tuple[str, int]:
        """The one rate at which bodies slide on others at the end of a phase, else at which one turns, and its sense."""
        if slides:
            return slides[0], self._slides_to(key_of(slides[0]).owner, before) if len(slides) == 1 else 0
        letters = {letter for side in rules for letter in side.symbols()}
        turning = of_kinds(letters, ("angular_velocity",)) if turns else []
        return (turning[0], self.sign(turning[0])[0]) if len(turning) == 1 else ("", 0)

    def _speeds_round(self, state: str) -> Iterator[tuple[str, Formula]]:
        """The speed u at which each body that lies on a round one that travels goes round it, as seen from the centre of that: to the
        right over its top or through its bottom."""
        configuration, instant = self.scene.configuration, self.scene.instant(state)
        for item in configuration.connections(state):
            surface = item.surface(configuration, state) if item.lying() and item.carrier(configuration) else None
            out = item.away(instant) if surface is not None and surface.curved else None
            if out is not None:
                own, below = instant.motion(item.lying()), instant.motion(item.carrier(configuration))
                passing = own.velocity - below.velocity_of(instant.hub(PointRef(item.carrier(configuration))))
                yield f"slide|{item.name}||{state}", passing.along(out.turned(-90))

    def _shared(self, ties: Sequence[Formula], name: str, lead: str) -> Formula | None:
        """A rate by the one to which it is tied; None where more than that tells it."""
        told = {letter: Symbol(letter) for tie in ties for letter in tie.symbols()}
        places = {letter: self.numbers.with_answers(told[letter]) for letter in told.keys() - of_kinds(told, RATES)}
        values = self.scene.configuration.problem.values
        ties = [simplify(tie.substitute(places).substitute(values)) for tie in ties]
        held = {letter for tie in ties for letter in of_kinds(tie.symbols(), RATES)} - {lead}
        try:
            return solve_all(ties, sorted(held)).get(name)
        except (NotLinear, Singular):
            return None

    def round_from(self, owner: str, state: str) -> tuple[Formula, int] | None:
        """Where on a round side of another body a body is at the state before one, and the sense in which it goes round from there."""
        timeline = self.scene.configuration.timeline
        before = timeline.before(state) if state in timeline.order else None
        item = self.scene.configuration.connection(owner, before.start) if before is not None else None
        if before is None or before.event is not None or item is None or not item.carrier(self.scene.configuration):
            return None
        first = self.scene.instant(before.start)
        out, angle = item.away(first), item.touching_angle(first)
        along = self.numbers.sign([first.ask("velocity", owner, when=first.moving, letter="u")])
        if out is None or not along:
            return None
        return angle, along if (out - heading(angle)).degrees % 360 else -along

    def _slides_to(self, owner: str, phase: Interval) -> int:
        """The sense in which a body slides round a surface in a phase, positive to the right over its top or through its bottom."""
        first, last = (self.scene.instant(state) for state in (phase.start, phase.end))
        item = self.scene.configuration.connection(owner, phase.end)
        out = item.away(last) if item is not None else None
        if item is None or out is None:
            return 0
        angles = [item.touching_angle(moment) for moment in (first, last)]
        over = 1 if (out - heading(angles[1])).degrees % 360 else -1
        return over * self.numbers.sign([angles[1] - angles[0]])

    def _along_carrier(self, rider: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body slides along another: outwards where its distance from the axis has grown."""
        configuration = self.scene.configuration
        before = configuration.timeline.before(state) if state in configuration.timeline.order else None
        if before is None:
            return 0, ()
        places = [getattr(configuration.body(rider, when).shape, "radius", None) for when in (before.start, state)]
        grown = self.numbers.of(places[1] - places[0]) if places[0] is not None and places[1] is not None else None
        if not grown:
            return 0, ()
        way, relation = ("outwards", " > 0") if grown > 0 else ("inwards", " < 0")
        return (1 if grown > 0 else -1), (f"{spoken(rider)} slides {way}: ", Symbol(name), relation)

    def _onward(self, kind: str, owner: str, interval: str, axis: str = "") -> tuple[int, Words]:
        """Which way a body goes in a phase: as it moves at the start, else as it is pushed."""
        travel = self._travel(interval, owner, "line" if kind == "displacement" else "turn", axis)
        if travel is None:
            return 0, ()
        sign = self.numbers.onset(travel) or self.numbers.sign((travel.after,))
        return (sign, ("the way in which it starts to move",)) if sign else (0, ())
