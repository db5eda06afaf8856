"""Telling: what a state of a scene in space tells: its lines, its time, and what the time that has passed since the one before tells."""

from __future__ import annotations

from typing import NoReturn, Self

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import PI, ZERO, Formula, Symbol, add
from rotsolve.core.faults import Unsolvable
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import MARKED, SECOND, TIME, of_kinds, phase_midst
from rotsolve.core.vectors.triple import AXES, Triple
from rotsolve.language.problem import Condition, State
from rotsolve.motion.arrangement import Arrangement
from rotsolve.space.arrangement import ANGLES, NODAL, JointedBodies
from rotsolve.space.attitude import Onward

TURNED = (*NODAL, "vertical", "angular_velocity", "angular_acceleration")  # words that tell how a body stands or turns


def turns_untold(value: Formula) -> list[str]:
    """The symbols in it for how far bodies have gone round and spun since the first state, which nothing tells."""
    return of_kinds(value.symbols(), ("precession_angle", "spin_angle"))


class TellingMoment:
    """One state, as its lines tell it: their values, and letters for what they leave open."""

    def __init__(self, held: JointedBodies, registry: Registry, state: State, known: Arrangement) -> None:
        self.held, self.registry, self.state, self.arrangement = held, registry, state, known
        self.positive, self.order, self.signs = known.positive, known.order, known.signs
        self.when = state.name
        self.at = state.name  # as the keys of its quantities say it
        self.before: TellingMoment | None = None  # the moment before an event that leads to this one
        self.met: dict[
            str, TellingMoment
        ] = {}  # the moments before the events up to this one, which may have brought joints
        self.steadily = False  # whether the state before is steady, and nothing happens between
        self.onward: Onward | None = None  # what happens from the state before on, where times are told
        self.first = True  # whether the scene begins with it
        self.later = False  # whether time has passed since the first state
        self.lines: dict[
            str, Triple
        ] = {}  # own directions about which bodies that nothing holds have turned up to it, whatever happened
        self.used: set[int] = set()  # the lines of the state that something has read, by their places

    def come_after(self, before: Self, event: str) -> None:
        """Tell that another moment lies before this one: just before an event, or a time before it."""
        self.later, self.met = before.later or not event, dict(before.met)
        self.steadily = before.state.steady and not event
        if event:
            self.before = self.met[event] = before

    def tidy(self, value: Formula) -> Formula:
        """A formula in textbook form."""
        return simplify(value, order=self.order, positive=self.positive)

    # what the state tells

    def line(self, owner: str, word: str, component: str = "", point: str | None = None) -> Condition | None:
        """The line of the state about a quantity of a body, or about a component of it."""
        for number, line in enumerate(self.state.conditions):
            path = line.path
            if path is not None and (path.owner, path.quantity, path.component or "", path.point) == (
                owner,
                word,
                component,
                point,
            ):
                self.used.add(number)
                return line
        return None

    def rests(self, owner: str) -> bool:
        """Whether the state says that a body is at rest."""
        for number, line in enumerate(self.state.conditions):
            if line.rest and line.owner in ("", "all", owner):
                self.used.add(number)
                return True
        return False

    def now(self, value: Formula) -> Formula:
        """A formula of the time at this moment; by t where nothing tells it, and 0 where it is that then, as sin ω t at the start."""
        if TIME not in value.symbols():
            return value
        clock = self.clock()
        self.hangs_on_time()
        if clock is None:
            return value
        then = value.substitute({TIME: clock})
        if clock == ZERO:  # sin 0 and cos 0 are numbers
            return simplify(then)
        return ZERO if is_zero(then) else then

    def clock(self) -> Formula | None:
        """The running time: its letter in the midst of a phase; at the first state as told, else 0; at a later one that of the
        state before and what has passed since, through an event as before."""
        if phase_midst(self.at):
            return Symbol(TIME)
        if self.before is not None:
            return self.before.clock()
        told = self.state.time_told
        if self.first:
            return ZERO if told is None else told
        start = None if self.onward is None else self.onward.before.moment.clock()
        return None if told is None or start is None else add(start, told)

    def tells_time_alone(self) -> bool:
        """Whether a later state tells its time and nothing else, so that it is some moment of the motion from the state before."""
        paths = [line.path for line in self.state.conditions]
        alone = bool(paths) and all(path is not None and (path.owner, path.quantity) == ("", "time") for path in paths)
        return alone and self.onward is not None and not self.state.steady

    def hangs_on_time(self) -> None:
        """Take note that something hangs on the times of this state and of those before; an event takes none."""
        earlier = self.before
        if earlier is None:
            self.line("", "time")
            earlier = None if self.onward is None else self.onward.before.moment
        if earlier is not None:
            earlier.hangs_on_time()

    def goes_on(self, name: str) -> bool:
        """Whether it is told in closed form how a body stands and turns, by the time that has passed."""
        onward = self.onward
        if onward is None:
            return False
        try:
            found = onward.steady(name) or onward.hinged(name) or onward.attitude(name) is not None
        except Unsolvable:  # it does, but not in a form that is solved
            found = True
        if found:
            self.hangs_on_time()
        return found

    def keeps_momentum(self, name: str) -> bool:
        """Whether the angular momentum of a body has stayed in space since the state before."""
        return self.onward is not None and self.onward.turns_freely(name)

    def told(self, owner: str, word: str) -> Formula | None:
        """The value that the state gives to a quantity of a body; of one that precesses steadily that to which time has brought it."""
        if self.onward is not None and self.told_by_time(owner, word):
            return self.onward.told(owner, word)
        line = self.line(owner, word)
        value = None if line is None else line.value
        return self.right_angle(value) if word in ANGLES and value is not None else value

    def told_by_time(self, owner: str, word: str) -> bool:
        """Whether the time that has passed tells an Euler angle of a body, or a rate, whatever the state says: it precesses steadily."""
        return self.onward is not None and word in NODAL and self.onward.steady(owner)

    @remembered
    def right_angle(self, angle: Formula) -> Formula:
        """An angle; one that is upright, level or upside down by the number of its letter as that, since then steady motions are others, as
        they are of two bodies that lean in one plane."""
        exact = (ZERO, PI / 2, PI, -PI / 2) if angle.symbols() else ()
        return next((way for way in exact if self.held.vanishes(angle - way)), angle)

    def vector_told(self, owner: str, word: str, point: str | None = None) -> tuple[Triple, str, str] | None:
        """The components that the state gives to a vector of a body, the name of their axes, and to what body they are relative.

        Of the angular velocity of a ball that rolls it may tell some: the others have letters, which rolling tells.
        """
        lines = [self.line(owner, word, axis, point) for axis in AXES]
        found = [line for line in lines if line is not None]
        if not found:
            return None
        parted = word == "angular_velocity" and found[0].axes in ("", "space") and self.held.rolling(owner) is not None
        if len(found) < len(AXES) and parted:
            parts = [
                self.ask(word, owner, axis) if line is None or line.value is None else line.value
                for axis, line in zip(AXES, lines, strict=True)
            ]
            return (parts[0], parts[1], parts[2]), found[0].axes, found[0].relative
        if len(found) < len(AXES):
            missing = ", ".join(axis for axis, line in zip(AXES, lines, strict=True) if line is None)
            help = f"write all three: `{owner}.{word}: [x, y, z]`"
            raise Unsolvable(f"of `{owner}.{word}` nothing tells {missing}", span=found[0].span, help=help)
        parts = [ZERO if line is None or line.value is None else line.value for line in lines]
        return (parts[0], parts[1], parts[2]), found[0].axes, found[0].relative

    def told_against(self, owner: str, word: str, point: str | None, frame: str) -> bool:
        """Whether the state tells a vector of a body as seen from another one (from the ground by '') and along the axes of that."""
        paths = [(line, line.path) for line in self.state.conditions if line.path is not None]
        found = [line for line, path in paths if (path.owner, path.quantity, path.point) == (owner, word, point)]
        return bool(found) and all(
            line.relative == frame and line.axes in ("", frame or "space") and line.path and line.path.component in AXES
            for line in found
        )

    def vector_kept(self, owner: str, word: str) -> tuple[Triple, str, str] | None:
        """What the state tells of how a body stands or where it is; through an event as before."""
        told = self.vector_told(owner, word)
        return told if told is not None or self.before is None else self.before.vector_kept(owner, word)

    def ask(self, word: str, owner: str, component: str = "", letter: str = "", kind: str = "") -> Formula:
        """The letter of a quantity at this moment, or the value that the state gives it."""
        known = self.told(owner, word) if not component and not kind else None
        entry = QUANTITIES[word]
        quantity = SceneQuantity(kind or word, owner, self.at, component, letter or entry.letter, entry.dimension)
        if known is not None:
            self.registry.fix(quantity, known)
        return self.registry.ask(quantity)

    def rate_of(self, word: str, owner: str) -> Formula:
        """How fast a rate changes; not at all where the state is steady."""
        if self.state.steady or (self.onward is not None and self.onward.steady(owner)):
            return ZERO
        entry = QUANTITIES["angular_acceleration"]
        kind = SECOND + word
        quantity = SceneQuantity(kind, owner, self.at, "", f"{QUANTITIES[word].letter}{MARKED}", entry.dimension)
        return self.registry.ask(quantity)

    def refuse_told_anyhow(self, name: str) -> None:
        """Refuse lines that tell once more how a body stands or turns at a state to which time leads."""
        for line in self.state.conditions:
            path = line.path
            if (path is not None and path.owner == name and path.quantity in TURNED) or (
                line.rest and line.owner in ("all", "", name)
            ):
                self.refuse_told_in_time(name, line)

    def refuse_told_in_time(self, name: str, line: Condition) -> NoReturn:
        """Refuse a line that tells once more, or otherwise, what the time that has passed tells."""
        message = f"how `{name}` stands and turns at `{self.when}` follows from the time that has passed"
        raise Unsolvable(message, span=line.span, help="leave out this line, or the `time` of the state")
