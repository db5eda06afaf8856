"""States: what the states of a scene fix, what stays as it was in an event, and the statements that come back as equations."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import PI, ZERO, Formula, Negative, Sum, Symbol, total
from rotsolve.core.equation import STATED, Equation
from rotsolve.core.facts import Facts, signed
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import CONSTANT, RATE, has_quantities, is_key, is_quantity, paths_in
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.core.writing import spoken
from rotsolve.language.noted import unread
from rotsolve.language.problem import COMES_TO, SETTLES, Condition, Path, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.flights import going_on_evenly
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.motion.owndata import is_own
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.paths.reader import PathReader


class Fixed(Struct, frozen=True):
    """Enters values into the registry; every instant is made anew, since it puts in what is fixed by then."""

    configuration: Configuration
    registry: Registry
    modes: Mapping[str, str]

    def instant(self, state: str, *, generic: bool = False) -> Instant:
        return Instant(self.configuration, self.registry, state, generic, self.modes)

    def fix(self, letter: Formula, value: Formula) -> None:
        """Give a letter its value; what is no letter of the laws is known already."""
        if is_quantity(letter) and letter != value:
            self.registry.known[letter.name] = value


def rates_of_body(word: str, instant: Instant, name: str) -> Iterator[Formula]:
    """Velocities or accelerations of a body: along its line or right and up, then of its turning."""
    motion, line = instant.motion(name), instant.line(name)
    if motion.kind == "line":
        yield instant.travel(word, name, line[1] if line else "")
    elif motion.kind == "plane":
        yield from (instant.component(word, name, axis) for axis in "xy")
    if motion.turns:
        yield instant.rate(f"angular_{word}", name)


def check_shafts(state: State, fixed: Fixed) -> None:
    """A body on a turning shaft is alone there: how others that are tied to it are carried round is not told."""
    for item in fixed.configuration.connections(state.name):
        if item.circling:
            name = item.touches()[0].owner
            if len(fixed.configuration.component(name, state.name)) > 1:
                raise NotYet(f"`{name}` on a turning shaft is tied to other bodies: that is not solved yet", state.span)


def check_steady(state: State, fixed: Fixed) -> None:
    """On a turning shaft bodies are steady, since they are accelerated towards it; elsewhere they are in balance."""
    carried = any(item.circling for item in fixed.configuration.connections(state.name))
    if state.balance and carried:
        raise NotYet("nothing is in balance on a turning shaft", state.span, "write `steady: true`")
    if state.steady and not carried:
        raise NotYet("`steady: true` is solved on a turning `shaft` only", state.span, "write `balance: true`")


def fix_balance(state: str, fixed: Fixed) -> None:
    """In equilibrium nothing accelerates."""
    instant = fixed.instant(state)
    for body in fixed.configuration.present(state):
        motion = instant.motion(body.name)
        for rate, _ in motion.acceleration.parts:
            fixed.fix(rate, ZERO)
        if motion.turns:
            fixed.fix(instant.rate("angular_acceleration", body.name), ZERO)


def prescribe(instant: Instant, fixed: Fixed, *, by_motion: bool = False) -> None:
    """What a drive prescribes at a moment, and rates of it that vanish; what goes `by_motion` itself waits for what the states say."""
    bodies = fixed.configuration.present(instant.state)
    drives = [drive for body in bodies for drive in fixed.configuration.drives(body.name, instant.state)]
    drives = [drive for drive in drives if any(paths_in(drive.function)) == by_motion]
    for drive in drives:
        if by_motion and drive.order < 2:
            word = spoken(drive.word)
            raise NotYet(f"a given {word} is a formula of `time` alone", help="give the acceleration instead")
        fixed.fix(instant.driven(drive, drive.word), instant.now(drive.function))
    for drive in drives:
        for word, function in drive.rates().items():
            if function == ZERO:
                fixed.fix(instant.driven(drive, word), ZERO)


RATES = ("velocity", "angular_velocity")


def keep_standing(start: str, end: str, fixed: Fixed) -> None:
    """What does not turn stands throughout a phase as it does at its start."""
    first, between, fresh = fixed.instant(start), fixed.instant(start, generic=True), fixed.instant(end)
    for body in fixed.configuration.present(end):
        if first.never_turns(body.name) and fresh.never_turns(body.name):
            keep_angle(body.name, first, between, fixed)
            keep_angle(body.name, first, fresh, fixed)


def carry_over(state: State, fixed: Fixed) -> None:
    """What an event before a state leaves as it was; after a phase how that stands which does not turn."""
    before = fixed.configuration.timeline.before(state.name)
    if before is None:
        return
    if before.event is None:
        keep_standing(before.start, state.name, fixed)
        return
    last, fresh = fixed.instant(before.start), fixed.instant(state.name)
    said = {line.path.owner for line in state.conditions if line.path and line.path.quantity in RATES}
    touched = touched_by(before, fixed) | said | ({"all"} if any(line.rest for line in state.conditions) else set())
    for item in fixed.configuration.connections(state.name):
        for word in item.kept:
            fixed.fix(fresh.ask(word, item.name), last.ask(word, item.name))
    keep_places(before, last, fresh, fixed)
    for body in fixed.configuration.present(state.name):
        keep_angle(body.name, last, fresh, fixed)
        if body.name not in touched and "all" not in touched:
            for one, other in kept_rates(body.name, last, fresh):
                fixed.fix(other, one)


def kept_rates(body: str, last: Instant, fresh: Instant) -> Iterator[tuple[Formula, Formula]]:
    """The rates of a body that an event leaves as they were, with those after it: what it lets go of an axis or a line goes on
    as its centre went."""
    kinds = [instant.motion(body).kind for instant in (last, fresh)]
    if kinds in (["axis", "plane"], ["line", "plane"]):
        centre, turns = last.velocity_at(body, fresh.frame(body).reference), last.motion(body).turns
        spin = signed(last.rate("angular_velocity", body), last.sense(body) * fresh.sense(body)) if turns else ZERO
        before = [centre.along(RIGHT), centre.along(UP), spin]
        yield from zip(before, rates_of_body("velocity", fresh, body), strict=False)
    elif kinds[0] == kinds[1]:
        rates = [rates_of_body("velocity", instant, body) for instant in (last, fresh)]
        yield from zip(*rates, strict=False)


def keep_angle(body: str, last: Instant, fresh: Instant, fixed: Fixed) -> None:
    """A body does not turn in an event; a new hinge counts the angle from its own side."""
    old, new = last.angle(body), fresh.angle(body)
    if new is not None:
        same = old is not None and fresh.offset(body) == last.offset(body)
        turned = last.orientation(body) + fresh.offset(body)
        fixed.fix(new, old if same and old is not None else turned.formula())


def keep_places(event: Interval, last: Instant, fresh: Instant, fixed: Fixed) -> None:
    """A body stays where it touches a curved surface, also one that it only meets in the event, and as high as it is on a track."""
    for body in fixed.configuration.present(event.end):
        tracks = [fixed.configuration.orbit(body.name, state) for state in (event.start, event.end)]
        if all(track is not None and track.radius is None for track in tracks):
            fixed.fix(fresh.ask("height", body.name), last.ask("height", body.name))
    met = event.event.begins() if event.event is not None else ()
    acting = {item.name for item in fixed.configuration.connections(event.start)}.union(met)
    for item in fixed.configuration.connections(event.end):
        surface = item.surface(fixed.configuration, event.end) if item.name in acting else None
        if surface is not None and surface.curved:
            fixed.fix(item.touching_angle(fresh), item.touching_angle(last))


def touched_by(interval: Interval, fixed: Fixed) -> frozenset[str]:
    """Bodies whose velocities an event changes."""
    from rotsolve.motion.encounters import participants

    found: frozenset[str] = frozenset()
    for ref in participants(interval, fixed.configuration):
        for state in (interval.start, interval.end):
            found |= fixed.configuration.component(ref.owner, state)
    return found


RATE_OF = {  # what is zero where a quantity is largest or smallest
    "angle": "angular_velocity",
    "rotation": "angular_velocity",
    "turns": "angular_velocity",
    "angular_velocity": "angular_acceleration",
    "displacement": "velocity",
    "height": "velocity",
    "velocity": "acceleration",
}


def moved_letter(told: Formula) -> tuple[Formula, int, Formula] | None:
    """A letter of the laws, the sign with which a formula holds it, and what is added to it; None of any other formula."""
    if is_quantity(told):
        return told, 1, ZERO
    names = [name for name in told.symbols() if is_key(name)]
    if len(names) != 1 or not isinstance(told, (Negative, Sum)):
        return None
    for sign in (1, -1):
        rest = simplify(told - signed(Symbol(names[0]), sign))
        if not has_quantities(rest):
            return Symbol(names[0]), sign, rest
    return None


class Statements(Struct):
    """Takes the lines of all states into the registry."""

    fixed: Fixed
    stated: list[tuple[Equation, Condition]] = field(default_factory=list)
    told: list[tuple[str, Condition]] = field(default_factory=list)  # the quantities that lines fix, by key
    told_by_facts: bool = False  # whether facts of bodies tell what some of them fix

    @property
    def configuration(self) -> Configuration:
        return self.fixed.configuration

    def take(self) -> list[tuple[Equation, Condition]]:
        """Fix what the states say, in the order of time; lines that fix no single quantity come back as equations."""
        for state in self.configuration.timeline.states:
            self._clock(state)
            prescribe(self.fixed.instant(state.name), self.fixed)
            prescribe(self.fixed.instant(state.name, generic=True), self.fixed)
        for state in self.configuration.timeline.states:
            check_shafts(state, self.fixed)
            carry_over(state, self.fixed)
            for condition in state.conditions:
                try:
                    self._take(state, condition)
                except NotYet as error:
                    raise NotYet(str(error), error.span or condition.span, error.help) from None
            if state.balance or state.steady:
                check_steady(state, self.fixed)
                going = going_on_evenly(state.name, self.configuration)
                self._rest(state, Condition(None, rest=True, owner="all", span=state.span), going)
                fix_balance(state.name, self.fixed)
        self._as_drawn(self.configuration.timeline.states[0].name)
        for state in self.configuration.timeline.states:
            for generic in (False, True):
                prescribe(self.fixed.instant(state.name, generic=generic), self.fixed, by_motion=True)
        while self._put_in():
            pass
        if any("at" in unread(item) or getattr(item, "at", None) for item in self.configuration.problem.connections):
            from rotsolve.equations.closing import check_closed

            for state in self.configuration.timeline.states:
                check_closed(state, self.fixed.instant(state.name))
        return self.stated

    def _as_drawn(self, state: str) -> None:
        """At first what stands as drawn does so, unless the scene says how it stands, or how far a wire to another is twisted."""
        for body in self.configuration.present(state):
            while self._put_in():
                pass
            first = self.fixed.instant(state)
            said = self.configuration.mentions.says(state, body.name, "angle")
            angle = first.angle(body.name) if first.drawn_at_first(body.name) and not said else None
            if angle is not None:
                self.fixed.fix(angle, first.offset(body.name).formula())

    def _put_in(self) -> bool:
        """Put what is fixed by now into what was taken before it was; whether an equation fixes one letter more by that."""
        known = self.fixed.registry.known
        for key, value in known.items():
            if not known.keys().isdisjoint(value.symbols()):
                known[key] = value.substitute({name: part for name, part in known.items() if name != key})
        for number, (equation, condition) in enumerate(self.stated):
            if known.keys().isdisjoint(equation.left.symbols()):
                continue
            left = simplify(equation.left.substitute(known))
            moved = moved_letter(left)
            if moved is not None and not has_quantities(equation.right):
                letter, sign, rest = moved
                self.fixed.fix(letter, signed(simplify(equation.right - rest), sign))
                del self.stated[number]
                return True
            self.stated[number] = replace(equation, left=left), condition
        return False

    def _clock(self, state: State) -> None:
        """The clock shows 0 at the first state, or the time that it says; a later one that says a time comes so long after the one before,
        an event takes none."""
        fresh, parts = self.fixed.instant(state.name), self.configuration.timeline.since(state.name)
        told = state.time_told
        if not parts:
            self.fixed.fix(fresh.time(), ZERO if told is None else told)
            return
        last = self.fixed.instant(parts[0].start).time()
        if all(part.event is not None for part in parts):
            self.fixed.fix(fresh.time(), last)
        if told is not None:
            self.fixed.fix(fresh.time(), simplify(last + told))
            phases = [part for part in parts if part.event is None] or list(parts)
            if len(phases) == 1:
                self.fixed.fix(fresh.ask("time", "", when=phases[0].name), told)

    def _take(self, state: State, condition: Condition) -> None:
        """Take rest, a quantity with a value, or a word."""
        path, value = condition.path, condition.value
        if is_own(condition, self.configuration.bodies):
            self._check_own(state, condition)  # the configuration has taken it
        elif condition.rest:
            self._rest(state, condition)
        elif path is None or path.quantity in OSCILLATING:
            return  # taken where the swings are placed
        elif condition.word == "slack":
            self.fixed.fix(self._letter(state.name, Path(path.owner, "tension")), ZERO)
        elif condition.word == "leaves":
            self._leaves(state, condition, path.owner)
        elif condition.word == "slips" and (verge := self._verge(path.owner, state.name)):
            label = f"{spoken(path.owner)} is on the point of slipping"
            self._state(*verge[0][:2], state.name, label, condition, cost=2)
        elif condition.word in COMES_TO:
            rate = RATE_OF.get(path.quantity)
            if rate is None:
                raise NotYet(f"`{condition.word}` of `{path.quantity}` is not solved yet")
            if condition.word == SETTLES:
                self._check_settling(state, path.owner)
            self._claim(self._letter(state.name, replace(path, quantity=rate)), ZERO, state.name, condition)
        elif value is not None and path.quantity != "time":
            if path.quantity == "turns":
                path, value = replace(path, quantity="rotation"), simplify(2 * PI * value)
            before = set(self.fixed.registry.spoken_of)
            letter = self._letter(state.name, path)
            self._claim(letter, value, state.name, condition)
            if is_quantity(letter):  # to speak of it here is no use of it
                self.told.append((letter.name, condition))
                self.fixed.registry.spoken_of.difference_update({letter.name} - before)

    def _check_settling(self, state: State, owner: str) -> None:
        """A speed settles where the forces go by it; what goes by the time or by its place is at most without a push for a moment."""
        before = self.configuration.timeline.before(state.name)
        name = self.configuration.host(owner, state.name) if owner in self.configuration.bodies else owner
        pace = "" if before is None or before.event is not None else self.configuration.pace(name, before.start)
        if pace not in (RATE, CONSTANT):
            message = f"`{owner}` settles at `{state.name}` only where what drives it goes by its speed"
            raise NotYet(message, state.span, "give the `time` of a later state, or say `largest` or `smallest`")

    def _claim(self, letter: Formula, value: Formula, state: str, condition: Condition) -> None:
        """Fix a letter that is free; what is known otherwise becomes an equation."""
        moved = moved_letter(letter)
        if moved is not None:
            letter, sign, rest = moved
            self.fixed.fix(letter, signed(simplify(value - rest) if rest != ZERO else value, sign))
        elif letter != value:
            path = condition.path
            label = "given" if not letter.symbols() else self._label(path) if path is not None else "stated"
            before = self.configuration.timeline.before(state)
            if condition.word in COMES_TO and path is not None:
                does = condition.word if condition.word == SETTLES else f"is {condition.word}"
                label = f"where the {spoken(path.quantity)} {does}, its rate is zero"
                state = before.name if before is not None else state  # it tells how long the phase takes
            self._state(letter, value, state, label, condition, cost=1 if isinstance(letter, Symbol) else 2)

    def _state(
        self, letter: Formula, value: Formula, section: str, label: str, condition: Condition, *, cost: int = 1
    ) -> None:
        """Write a line of a state as an equation."""
        self.stated.append((STATED.equation(letter, value, section, cost=cost, words=label), condition))

    def _leaves(self, state: State, condition: Condition, contact: str) -> None:
        """A contact is lost where the surface no longer pushes: N = 0."""
        after = self.configuration.timeline.after(state.name)
        if after is not None and after.event is None:
            raise NotYet(f"what comes after `{contact}` leaves is not solved yet", help="let it be the last state")
        item = self.configuration.connection(contact, state.name)
        surface = item.surface(self.configuration, state.name) if item is not None else None
        if surface is None or item is None:
            raise NotYet(f"`{contact}` does not hold a body on a surface at `{state.name}`")
        normal = self._letter(state.name, Path(contact, "normal_force"))
        label = f"{spoken(item.touches()[0].owner)} leaves the {spoken(surface.name)}"
        if not state.balance:
            self._state(normal, ZERO, state.name, label, condition)
            return
        self.fixed.fix(normal, ZERO)  # just about to leave: what no longer pushes is no force of the balance
        if item.grips():  # what rolls off something steep still grips as it leaves
            friction = self._letter(state.name, Path(contact, "friction_force"))
            label = f"no friction where the {spoken(surface.name)} does not push"
            self._state(friction, ZERO, state.name, label, condition)

    def _verge(self, owner: str, state: str) -> tuple[tuple[Formula, Formula, Formula], ...]:
        """What is equal on the point of slipping of what does not slip on in the scene."""
        item = self.configuration.connection(owner, state)
        return () if item is None or item.rubs() else item.verge(self.fixed.instant(state))

    def _label(self, path: Path) -> str:
        """What a stated equation is called: of one body against another, which two."""
        item = next((item for item in self.configuration.problem.connections if item.name == path.owner), None)
        if item is None or not item.between():
            return "stated"
        first, last = (spoken(ref.owner) for ref in item.between())
        return f"stated: {last} relative to {first}"

    def _check_own(self, state: State, condition: Condition) -> None:
        """A body's own data change in a phase, and no mass leaves: it would take angular momentum along."""
        before = self.configuration.timeline.before(state.name)
        if before is None or condition.path is None or condition.value is None:
            return
        name, word = condition.path.owner, condition.path.quantity
        if before.event is not None:
            raise NotYet(f"the {word} of `{name}` can't change in an event", help="let a phase lead to this state")
        earlier = self.configuration.body(name, before.start).mass
        lost = None if word != "mass" or earlier is None else earlier - condition.value
        if lost is not None and self.configuration.signs.by_numbers(lost) == 1:
            raise NotYet(f"what leaves `{name}` takes momentum along, which is not solved yet")

    def _letter(self, state: str, path: Path) -> Formula:
        """What a line of a state speaks of: a quantity of this moment, or of the phase that ends here."""
        instant = self.fixed.instant(state)
        if path.quantity == "displacement":
            return self._gone(path, instant)
        if path.quantity == "rotation":
            from rotsolve.motion.travels import angle_turned

            phases = [part for part in self.configuration.timeline.since(state) if part.event is None]
            return total([angle_turned(path.owner, part, instant) for part in phases])
        return PathReader(instant, lambda: self._facts(instant)).meaning(path).formula

    def _facts(self, instant: Instant) -> Facts:
        self.told_by_facts = True
        return free_bodies(instant)

    def _gone(self, path: Path, instant: Instant) -> Formula:
        """The way of a body since the state before, along its line or in one direction."""
        from rotsolve.paths.displacements import displacement_over

        parts = self.configuration.timeline.since(instant.state)
        instants = [(part, self.fixed.instant(part.start), self.fixed.instant(part.end)) for part in parts]
        return total([displacement_over(path, *ends) for ends in instants if ends[0].event is None])

    def _rest(self, state: State, condition: Condition, going: Collection[str] = ()) -> None:
        instant = self.fixed.instant(state.name)
        for body in self.configuration.present(state.name):
            if condition.owner in ("all", "", body.name) and body.name not in going:
                for rate in rates_of_body("velocity", instant, body.name):
                    self._claim(rate, ZERO, state.name, condition)
        for item in self.configuration.rides(state.name):
            if condition.owner in ("all", "", item.rider.owner):
                self.fixed.fix(instant.outward(item.rider.owner), ZERO)
