"""Problem: what a scene file says, checked and with every value as an exact formula in SI units. No physics."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.faults import Span as Span
from rotsolve.core.letters import Given as Given
from rotsolve.language.bodies import Body as Body
from rotsolve.language.bodies import Part as Part
from rotsolve.language.bodies import PointRef as PointRef
from rotsolve.language.bodies import Turn as Turn

if TYPE_CHECKING:
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.language.bodies import Surface
    from rotsolve.language.elements import Action, Connection, Event
    from rotsolve.language.marks import Marking


class Path(Struct, frozen=True):
    """A quantity: owner (body, connection, action or empty for the whole system), point, quantity, component.

    `rod.end.acceleration.x` -> owner rod, point end, quantity acceleration, component x;
    `string.block.tension` -> owner string, point block; `kinetic_energy` -> owner ''; `beam.at(x).bending_moment` -> argument x.
    """

    owner: str
    quantity: str
    point: str | None = None
    argument: Formula | None = None
    component: str | None = None
    span: Span | None = None


class Condition(Struct, frozen=True):
    """One line of a state, event or `where`: path = value; a word (`grip: rolls`, `string: slack`, `… : largest`) is in `word`.

    In space components are along `axes` ('' for those of space), and may be `relative` to a body whose axes turn;
    a line of three components is three of these, which are `whole`.
    `rest` = True for `at rest` (owner 'all' or one body), path None. After `where` a quantity with its clauses is in `phrase`, path None.
    """

    path: Path | None
    value: Formula | None = None
    word: str | None = None
    rest: bool = False
    owner: str = ""
    span: Span | None = None
    phrase: Find | None = None
    axes: str = ""
    relative: str = ""
    whole: bool = False


class State(Struct, frozen=True):
    """A named instant with the lines that hold at it.

    One that the scene does not name, at which the laws of a phase end, has in `opened` what happens then; `senses` tells of all that rubs
    which way it slips or turns just then: +1, −1, or 0 where it has come to rest.
    """

    name: str
    conditions: tuple[Condition, ...] = ()
    balance: bool = False
    steady: bool = False
    span: Span | None = None
    opened: str = ""
    senses: tuple[tuple[str, int], ...] = ()

    @property
    def time_told(self) -> Formula | None:
        """The `time` that it tells: so long after the state before; at the first one what the clock shows."""
        lines = (line for line in self.conditions if line.path is not None and line.path.quantity == "time")
        return next((line.value for line in lines if line.value is not None), None)

    @property
    def stands(self) -> bool:
        """Whether all stands still at it and goes on so: in balance, or steady with rates that are told to be nothing."""
        rates = [
            line.value for line in self.conditions if line.path is not None and line.path.quantity == "angular_velocity"
        ]
        return self.balance or (self.steady and bool(rates) and all(rate == ZERO for rate in rates))


class Phase(Struct, frozen=True):
    """The motion from one state to the next; `without` names connections that do not act in it."""

    name: str
    start: str
    end: str
    without: tuple[str, ...] = ()
    span: Span | None = None


EXTREMES = ("largest", "smallest")
SMALL_BESIDE = "<<"  # between two letters of `assume`: the first is small beside the second
SETTLES = "settles"  # of a velocity: what it comes ever closer to, whether from above or from below
COMES_TO = (*EXTREMES, SETTLES)  # what a state may say of a quantity whose rate is nothing there
MODE = "mode "  # with its number the modifier of what is asked of one of several ways in which bodies swing
ANY_TIME = "any time"  # in place of a state: the moment that runs through a phase


class Term(Struct, frozen=True):
    """One operand of a `find`: a path with its modifier and its own time.

    modifier: '', 'size of', 'change of', 'lost', 'total', 'mean', 'largest', 'smallest'; of the periods and frequencies of swings
    In space components are asked in `axes` (space, body, node, or those of a body that is named) and `relative` to a body; of an
    `angle of` two vectors `other` is the second.
    'small swings' or 'mode 1' (`at` an equilibrium) or 'swings' (from `start`); of a `ratio of` two amplitudes `other` is the second.
    A mean may be taken `by` a turn or a way, a path; of an inertia `by` is the word for how it is found.
    A `time from A to B` has path.quantity 'time'. `at` names one state or is ANY_TIME, `during` a phase or event, `start`/`end` two states.
    """

    path: Path
    modifier: str = ""
    at: str | None = None
    during: str | None = None
    start: str | None = None
    end: str | None = None
    about: PointRef | None = None
    along: Formula | str | tuple[Formula, ...] | None = None
    by: str | Path | None = None
    axes: str | None = None
    relative: str | None = None
    other: Term | None = None


class Option(Struct, frozen=True):
    """One option of a choice: a quantity, or several compared by `signs` (<, >, ≤, ≥, =), one between each two."""

    label: str
    sides: tuple[Find, ...]
    signs: tuple[str, ...] = ()


class WhichOf(Struct, frozen=True):
    """`which of` the options: the `largest` or `smallest`, what is `above` or `below` a bound; no test: whose comparison holds."""

    options: tuple[Option, ...]
    test: str = ""
    bound: Find | None = None


class Find(Struct, frozen=True):
    """An asked quantity: `formula` over givens, earlier answers and the placeholders `#0`, `#1`, … of `terms`.

    An entry of a matrix or vector that is asked for as a whole has the name of that in `whole`.
    A `choice` is answered by the label of an option; `terms` are then all that its options speak of.
    """

    name: str
    formula: Formula
    terms: tuple[Term, ...]
    modifier: str = ""
    where: Condition | None = None
    unit: Unit | None = None
    text: str = ""
    span: Span | None = None
    whole: str = ""
    choice: WhichOf | None = None

    @property
    def group(self) -> str:
        """The name under which the scene asks for it."""
        return self.whole or self.name

    @property
    def seeks(self) -> str:
        """The letter whose value it seeks: `F where N = P`; '' of other questions."""
        return (
            self.formula.name if self.where is not None and isinstance(self.formula, Symbol) and not self.terms else ""
        )

    @property
    def extreme_letter(self) -> str:
        """The letter of which it asks the `largest` or the `smallest` value that fits the scene; '' of other questions."""
        alone = isinstance(self.formula, Symbol) and not self.terms and self.where is None
        return self.formula.name if alone and self.modifier in EXTREMES else ""  # type: ignore[attr-defined]

    @property
    def verge(self) -> bool:
        """Whether it asks with what value of a letter something is on the point of slipping: `largest F where touch sticks`."""
        return self.where is not None and self.where.word in ("sticks", "rolls")

    @property
    def extreme(self) -> str:
        """`largest` or `smallest` in front of a question without a condition, of the whole or of its only quantity."""
        words = [self.modifier, *(term.modifier for term in self.terms if len(self.terms) == 1)]
        return next((word for word in words if word in EXTREMES), "") if self.where is None else ""

    @property
    def runs(self) -> bool:
        """Whether it asks for a function of time."""
        return any(term.at == ANY_TIME for term in self.terms)


class TimeValue(Struct, frozen=True):
    """A time at which functions of time are evaluated: as written, and in seconds."""

    text: str
    value: Formula


class Published(Struct, frozen=True):
    """A published answer beside an asked quantity: `text` as written (number and unit, formula or word), `value` when it is one.

    `values` are the numbers of a vector, of a matrix row by row, or of several roots; `formulas` the exact entries; `at` says when
    a function of time has the number.
    """

    name: str
    text: str
    formula: Formula | None = None
    value: Formula | None = None
    unit: Unit | None = None
    span: Span | None = None
    values: tuple[Formula, ...] = ()
    formulas: tuple[Formula, ...] = ()
    tolerance: Formula | None = None
    at: TimeValue | None = None


class Wording(Struct, frozen=True):
    """How a sheet asks for the answer of one name: the text as the scene writes it."""

    name: str
    text: str
    span: Span | None = None


class Varied(Struct, frozen=True):
    """A given with the values that it may take, each as a scene writes it: `1.5 kg`."""

    name: str
    values: tuple[str, ...]


class Comparison(Struct, frozen=True):
    """left − right, a formula of givens, has one of the `signs`; `text` is the condition as written."""

    gap: Formula
    signs: tuple[int, ...]
    text: str


class Variation(Struct, frozen=True):
    """What a scene says under `vary`: the letters that vary, in the order of the file, and the conditions on them."""

    letters: tuple[Varied, ...]
    conditions: tuple[Comparison, ...] = ()


class Problem(Struct, frozen=True):
    """A whole scene. `connections`, `actions`, `surfaces`, `events` hold the elements of rotsolve.elements."""

    title: str
    file: str
    source: str = ""
    text: str = ""
    lines: tuple[str, ...] = ()
    givens: tuple[Given, ...] = ()
    gravity: Formula | None = None
    gravity_in: str = (
        ""  # the body with which the weight turns, along its own −z; '' where it keeps its direction in space
    )
    plane: str = "vertical"
    space: bool = False  # whether it is a scene in space, with z up
    surfaces: tuple[Surface, ...] = ()
    bodies: tuple[Body, ...] = ()
    connections: tuple[Connection, ...] = ()
    actions: tuple[Action, ...] = ()
    states: tuple[State, ...] = ()
    phases: tuple[Phase, ...] = ()
    events: tuple[Event, ...] = ()
    assume: tuple[str, ...] = ()
    finds: tuple[Find, ...] = ()
    answers: tuple[Published, ...] = ()
    ask: tuple[Wording, ...] = ()
    marking: tuple[Marking, ...] = ()
    vary: Variation | None = None
    settings: tuple[tuple[str, str], ...] = ()  # values that were said in place of those of the lines

    @property
    def values(self) -> dict[str, Formula]:
        """The givens that have a value."""
        return {given.name: given.value for given in self.givens if given.value is not None}

    @property
    def sought(self) -> frozenset[str]:
        """The letters that are asked for: their values are answers."""
        return frozenset(given.name for given in self.givens if given.asked)

    @property
    def trials(self) -> dict[str, Formula]:
        """The numbers at which it is looked what the case of the letters without a value is."""
        return {given.name: given.trial for given in self.givens if given.trial is not None}


def references(item: object) -> Iterator[PointRef | Path]:
    """All points and paths that a part of a scene speaks of."""
    if isinstance(item, (PointRef, Path)):
        yield item
    elif isinstance(item, tuple):
        for part in item:
            yield from references(part)
    elif isinstance(item, Struct) and not isinstance(item, Formula):
        for name in item.__struct_fields__:
            part = getattr(item, name)
            if isinstance(part, (tuple, Struct)):
                yield from references(part)


def before(state: str, problem: Problem) -> Problem | None:
    """The problem up to a state, without it and what is asked there or later; None where nothing is left, or an event, a phase in which
    something is gone or an action leads to what is left out."""
    names = [item.name for item in problem.states]
    kept = set(names[: names.index(state)]) if state in names else set()
    phases = tuple(phase for phase in problem.phases if phase.without or {phase.start, phase.end} <= kept)
    ends = [*(event.to for event in problem.events), *(phase.end for phase in phases)]
    ends += [name for action in problem.actions for name in (action.from_, action.to) if name is not None]
    finds = asked_before(names.index(state) if state in names else 0, problem)
    if not kept or not finds or not kept.issuperset(ends):
        return None
    states = tuple(item for item in problem.states if item.name in kept)
    return replace(problem, states=states, phases=phases, finds=finds)


def asked_before(place: int, problem: Problem) -> tuple[Find, ...]:
    """The questions that speak of some of the first states alone, so many, or of what is between them."""
    states = {item.name for item in problem.states[:place]}
    spans: dict[str | None, tuple[str | None, ...]]
    spans = {event.name: (event.from_, event.to) for event in problem.events}
    spans |= {phase.name: (phase.start, phase.end) for phase in problem.phases}
    return tuple(find for find in problem.finds if asked_within(find, states, spans))


def asked_within(find: Find, states: Collection[str], spans: Mapping[str | None, tuple[str | None, ...]]) -> bool:
    """Whether all that a question speaks of is at some states, between them, or during what joins them."""
    if find.where is not None or find.choice is not None or not find.terms:
        return False
    named = [(term.at, term.start, term.end, *spans.get(term.during, ())) for term in find.terms]
    times = [[time for time in several if time is not None] for several in named]
    return all(set(told) <= set(states) for told in times)
