"""Finds: an asked quantity of the scene as one formula over the letters of the laws, at its own states, phases and events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Symbol, add, negate
from rotsolve.algebra.units.dimension import Dimension, DimensionError, dimension_of
from rotsolve.core.heading import Vector
from rotsolve.core.quantity import BY_WORD, DIMENSIONS, OSCILLATING
from rotsolve.core.registry import SEPARATOR
from rotsolve.inquiry.history import History
from rotsolve.inquiry.questions import Meaning, NotYet, path_text
from rotsolve.inquiry.swings.swing import Swing
from rotsolve.inquiry.transfers import impulse, potential_change, work
from rotsolve.motion.passages import angle_turned, displacement
from rotsolve.scene.model import Find, Path, Term

SPANNED = ("displacement", "rotation", "turns", "work", "impulse", "angular_impulse", "time", "distance")
STORED = ("potential_energy", "energy")
DIFFERENCE = ("change of", "lost")


@dataclass(frozen=True)
class Asked:
    """An asked quantity: its name, what it is made of, and the letter that stands for it in the laws.

    `letter` is the quantity's own letter where the question is just that quantity, else a letter made for the question; `section` is
    where its definition belongs.
    """

    find: Find
    formula: Formula
    letter: str
    dimension: Dimension | None
    vector: Vector | None = None
    remark: str = ""
    label: str = ""
    section: str = ""
    words: tuple[str, str] = ("", "")
    swings: tuple[tuple[Swing, str], ...] = ()  # with what is asked of each: its period or frequency

    @property
    def direct(self) -> bool:
        """Whether the question is a single quantity of the laws."""
        return isinstance(self.formula, Symbol) and self.formula.name == self.letter


class Unclear(NotYet):
    """A question that the scene does not settle: which state, which end."""


Earlier = Mapping[str, tuple[Formula, "Dimension | None"]]  # answers found before, by name


def asked(find: Find, history: History, earlier: Earlier = MappingProxyType({})) -> Asked:
    """What a `find` line asks for; it may speak of `earlier` answers by name."""
    terms = [term for term in find.terms if term.path.quantity in OSCILLATING]
    swings = tuple((history.swing(term), term.path.quantity) for term in terms)
    return replace(quantity_asked(find, history, earlier), swings=swings)


def quantity_asked(find: Find, history: History, earlier: Earlier) -> Asked:
    """The formula of a `find` line, and the letter that stands for it."""
    meanings = [meaning_of(term, history) for term in find.terms]
    values = {f"#{index}": meaning.formula for index, (meaning, _) in enumerate(meanings)}
    values |= {name: letter for name, (letter, _) in earlier.items() if name != find.name}
    formula = find.formula.substitute(values)
    if find.modifier == "size of":
        formula = Call("abs", (formula,)) if formula.symbols() else formula
    single = len(meanings) == 1 and find.formula == Symbol("#0")
    first = meanings[0][0] if meanings else None
    section = meanings[0][1] if meanings else ""
    dimension = first.dimension if single and first is not None else dimension_of_find(find, meanings, history, earlier)
    if isinstance(formula, Symbol) and (SEPARATOR in formula.name or is_unknown(formula.name, history)):
        words = first.words if single and first else ("", "")
        return Asked(
            find,
            formula,
            formula.name,
            dimension,
            first.vector if single and first else None,
            section=section,
            words=words,
        )
    vector = first.vector if single and first is not None else None
    letter = f"asked{SEPARATOR}{find.name}"
    if not single or first is None:
        return Asked(find, formula, letter, dimension, vector, "", "", section)
    words = first.words if find.terms[0].modifier == "" else ("", "")
    return Asked(find, formula, letter, dimension, vector, first.remark, first.label, section, words)


def is_unknown(name: str, history: History) -> bool:
    """Whether a letter of the scene is itself asked for."""
    return any(given.name == name and given.asked for given in history.arrangement.problem.givens)


def dimension_of_find(
    find: Find, meanings: list[tuple[Meaning, str]], history: History, earlier: Earlier
) -> Dimension | None:
    """Dimension of an arithmetic expression of paths and givens."""
    known = {given.name: given.dimension for given in history.arrangement.problem.givens if given.dimension is not None}
    known.update({name: dimension for name, (_, dimension) in earlier.items() if dimension is not None})
    known.update({f"#{index}": meaning.dimension for index, (meaning, _) in enumerate(meanings)})
    try:
        return dimension_of(find.formula, known)
    except (DimensionError, KeyError, ValueError):
        return None


def meaning_of(term: Term, history: History) -> tuple[Meaning, str]:
    """A term's meaning, and the state, phase or event where it belongs."""
    timeline = history.arrangement.timeline
    if term.path.quantity in OSCILLATING:
        swing = history.swing(term)
        return Meaning(swing.letters[term.path.quantity], BY_WORD[term.path.quantity].dimension), swing.harmonic
    start, end = term.start, term.end
    if term.during is not None:
        interval = timeline.interval(term.during)
        if interval is None:
            raise Unclear(f"there is no phase or event `{term.during}`")
        start, end = interval.start, interval.end
    if term.modifier in ("largest", "smallest", "total"):
        raise NotYet(
            f"`{term.modifier} {term.path.quantity}` is not solved yet",
            help="ask for it at a state, or from one state to another",
        )
    if term.path.quantity in SPANNED and term.modifier not in DIFFERENCE:
        return spanned(term, start, end, history)
    if term.modifier in DIFFERENCE and start and end:
        return difference(term, start, end, history)
    if term.modifier == "mean" and start and end:
        return mean(term, start, end, history)
    return at_state(term, history)


def at_state(term: Term, history: History) -> tuple[Meaning, str]:
    """The meaning at one state: the one named, the only one, or any where it is the same throughout."""
    states = [term.at] if term.at else [state.name for state in history.arrangement.timeline.states]
    found: dict[Formula, tuple[Meaning, str]] = {}
    failed: NotYet | None = None
    for state in states:
        try:
            meaning = history.reader(state).meaning(term.path, term)
        except NotYet as error:
            failed = error
            continue
        if term.modifier == "size of":
            meaning = replace(meaning, formula=Call("abs", (meaning.formula,)))
        found.setdefault(meaning.formula, (meaning, section_of(term.path, meaning, state, history)))
    if not found:
        raise failed or Unclear("nothing is asked")
    if len(found) > 1:
        raise Unclear(
            f"`{path_text(term.path)}` is not the same at all states", help=f"say `at` which: {', '.join(states)}"
        )
    return next(iter(found.values()))


def section_of(path: Path, meaning: Meaning, state: str, history: History) -> str:
    """Where a definition is written: with the accelerations of a phase, or at its state."""
    moments = {name.split(SEPARATOR)[3] for name in meaning.formula.symbols() if name.count(SEPARATOR) == 3}
    if (
        BY_WORD[path.quantity].word in ("velocity", "speed", "kinetic_energy", "angular_momentum", "momentum")
        or state in moments
    ):
        return state
    return history.section(state)


def spanned(term: Term, start: str | None, end: str | None, history: History) -> tuple[Meaning, str]:
    """A quantity of one or several phases: the sum over them."""
    arrangement, timeline = history.arrangement, history.arrangement.timeline
    path, kind = term.path, BY_WORD[term.path.quantity]
    names = [state.name for state in timeline.states]
    if term.at is not None and term.at in names:
        start, end = names[max(0, names.index(term.at) - 1)], term.at
    start, end = start or names[0], end or names[-1]
    if names.index(start) >= names.index(end):
        help = (
            f"say `from … to …` with two of: {', '.join(names)}"
            if len(names) > 1
            else "give `states`, at least two of them"
        )
        raise Unclear(f"`{path.quantity}` runs from one state to a later one", help=help)
    intervals = timeline.between(start, end)
    if path.quantity == "time":
        duration = history.instant(end).time() - history.instant(start).time()
        if len(intervals) == 1 and intervals[0].name in history.passages:
            duration = history.passages[intervals[0].name].duration
        return Meaning(duration, kind.dimension), intervals[-1].name
    result: Formula = ZERO
    for interval in intervals:
        instant = history.instant(interval.start)
        name = instant.host(path.owner) if path.owner in arrangement.bodies else path.owner
        if path.quantity == "displacement" or path.quantity == "distance":
            part = displacement(name, interval, instant) if interval.event is None else ZERO
        elif path.quantity in ("rotation", "turns"):
            part = angle_turned(path.owner, interval, instant) if interval.event is None else ZERO
        elif path.quantity in ("impulse", "angular_impulse"):
            part = impulse(path, interval.name, interval.start, history)
        else:
            part = work(path, interval.name, history)
        result = add(result, part)
    if path.quantity == "turns":
        result = result / (2 * PI)
    return Meaning(result, kind.dimension), intervals[-1].name


def difference(term: Term, start: str, end: str, history: History) -> tuple[Meaning, str]:
    """Change (later minus earlier) or loss (earlier minus later)."""
    if term.path.quantity in STORED:
        return stored_difference(term, start, end, history)
    first = history.reader(start).meaning(term.path, term)
    last = history.reader(end).meaning(term.path, term)
    change = first.formula - last.formula if term.modifier == "lost" else last.formula - first.formula
    intervals = history.arrangement.timeline.between(start, end)
    label = f"{term.modifier.replace('lost', 'loss of')} {first.label}"
    return Meaning(change, first.dimension, label=label), intervals[-1].name


def stored_difference(term: Term, start: str, end: str, history: History) -> tuple[Meaning, str]:
    """Change or loss of potential energy (of one body: its weight's alone), or of kinetic and potential energy together."""
    result: Formula = ZERO
    intervals = history.arrangement.timeline.between(start, end)
    for interval in intervals:
        passage = history.passages.get(interval.name)
        if passage is not None:
            result = add(result, potential_change(term.path.owner, passage))
    if term.path.quantity == "energy":
        kinetic = replace(term.path, quantity="kinetic_energy")
        gained = [history.reader(state).meaning(kinetic, term).formula for state in (start, end)]
        result = add(result, gained[1] - gained[0])
    word = term.path.quantity.replace("_", " ")
    label = f"{term.modifier.replace('lost', 'loss of')} {word}"
    return Meaning(negate(result) if term.modifier == "lost" else result, DIMENSIONS["energy"], label=label), intervals[
        -1
    ].name


def mean(term: Term, start: str, end: str, history: History) -> tuple[Meaning, str]:
    """Mean over time: work over time for a power, angle or way over time for a rate."""
    whole = {
        "power": "work",
        "angular_velocity": "rotation",
        "velocity": "displacement",
        "angular_acceleration": "angular_velocity",
    }
    summed = whole.get(term.path.quantity)
    if summed is None:
        raise NotYet(f"the mean of `{term.path.quantity}` is not solved yet")
    duration, section = spanned(Term(Path("", "time")), start, end, history)
    other = replace(
        term, path=replace(term.path, quantity=summed), modifier="change of" if summed == "angular_velocity" else ""
    )
    amount, _ = meaning_of(replace(other, start=start, end=end), history)
    word = term.path.quantity.replace("_", " ")
    return Meaning(
        amount.formula / duration.formula, BY_WORD[term.path.quantity].dimension, label=f"mean {word}"
    ), section
