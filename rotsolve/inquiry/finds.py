"""Finds: an asked quantity of the scene as one formula over the letters of the laws, at its own states, phases and events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, Symbol, add, negate
from rotsolve.algebra.units.dimension import Dimension, DimensionError, dimension_of
from rotsolve.core.quantity import BY_WORD, DIMENSIONS, OSCILLATING
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.core.vectors.tensor import AXES, ENTRIES
from rotsolve.inquiry.courses import SPANNED, Beside, at_any_time, extreme, way, whole_way
from rotsolve.inquiry.history import History
from rotsolve.inquiry.questions import (
    Asked,
    Meaning,
    NotYet,
    Unclear,
    in_parts,
    label_of,
    path_text,
    size_of,
    spoken_point,
    whole_vector,
)
from rotsolve.inquiry.questions.conversion import conversion
from rotsolve.inquiry.transfers import blow, impulse, potential_change, work
from rotsolve.motion.bodies.rigid import tidy
from rotsolve.motion.phases.travels import angle_turned
from rotsolve.scene.model import ANY_TIME, Find, Path, PointRef, Term

STORED = ("potential_energy", "energy")
DIFFERENCE = ("change of", "lost")


Earlier = Mapping[str, tuple[Formula, "Dimension | None"]]  # answers found before, by name


def asked(find: Find, history: History, earlier: Earlier = MappingProxyType({}), beside: Beside | None = None) -> Asked:
    """What a `find` line asks for; it may speak of `earlier` answers by name."""
    terms = [term for term in find.terms if term.path.quantity in OSCILLATING]
    swings = tuple((history.swing(term), term.path.quantity) for term in terms)
    return replace(quantity_asked(find, history, earlier, beside), swings=swings)


def quantity_asked(find: Find, history: History, earlier: Earlier, beside: Beside | None) -> Asked:
    """The formula of a `find` line, and the letter that stands for it."""
    meanings = [meaning_of(term, history, beside) for term in find.terms]
    laws = tuple(law for meaning, _ in meanings for law in meaning.laws)
    values = {f"#{index}": meaning.formula for index, (meaning, _) in enumerate(meanings)}
    values |= {name: letter for name, (letter, _) in earlier.items() if name != find.name}
    formula = find.formula.substitute(values)
    if find.modifier == "size of":
        formula = Call("abs", (formula,)) if formula.symbols() else formula
    single = len(meanings) == 1 and find.formula == Symbol("#0")
    first = meanings[0][0] if meanings else None
    section = meanings[0][1] if meanings else ""
    definitions = tuple(dict.fromkeys(step for meaning, _ in meanings for step in meaning.definitions))
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
            definitions=definitions,
            laws=laws,
        )
    vector = first.vector if single and first is not None else None
    givens = {given.name: given for given in history.arrangement.problem.givens}
    if isinstance(formula, Symbol) and formula.name in givens:
        note, label = conversion(find, givens[formula.name]), "conversion of units"
        return Asked(find, formula, f"asked{SEPARATOR}{find.name}", dimension, label=label if note else "", said=note)
    letter = f"asked{SEPARATOR}{find.name}"
    if not single or first is None:
        return Asked(find, formula, letter, dimension, vector, "", "", section, definitions=definitions, laws=laws)
    plain = find.terms[0].modifier == "" and find.modifier == ""
    resolved = find.terms[0].modifier in ("", "mean", *DIFFERENCE) and find.modifier == ""
    question = Asked(
        find,
        formula,
        letter,
        dimension,
        vector,
        first.remark,
        first.label,
        section,
        first.words if plain else ("", ""),
        moving=first.moving,
        said=first.said,
        definitions=definitions,
        laws=laws,
    )
    return in_parts(question) if resolved else question


def entries(find: Find, history: History) -> tuple[Find, ...]:
    """A question for a matrix or a vector in space as questions for its entries; any other question alone."""
    if len(find.terms) != 1 or find.formula != Symbol("#0") or find.terms[0].path.component is not None:
        return (find,)
    term = find.terms[0]
    names = components(term, history)
    return tuple(
        replace(
            find,
            name=f"{find.name}_{name}",
            terms=(replace(term, path=replace(term.path, component=name)),),
            whole=find.name,
        )
        for name in names
    ) or (find,)


def components(term: Term, history: History) -> tuple[str, ...]:
    """The entries that belong to a question for a whole: all of a tensor; the coordinates in which a body extends."""
    path = term.path
    if path.owner not in history.arrangement.bodies:
        return ()
    if path.quantity == "inertia_tensor":
        return ENTRIES
    if path.quantity not in ("cm", "angular_momentum") or term.modifier:
        return ()
    flat = history.reader(history.arrangement.timeline.states[0].name).is_flat(path.owner, term)
    if path.quantity == "cm":
        return AXES[:2] if flat else AXES
    return AXES if term.about is not None and not flat else ()


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


def meaning_of(term: Term, history: History, beside: Beside | None = None) -> tuple[Meaning, str]:
    """A term's meaning, and the state, phase or event where it belongs."""
    timeline = history.arrangement.timeline
    if term.path.quantity in OSCILLATING:
        swing = history.swing(term)
        return Meaning(swing.letters[term.path.quantity], BY_WORD[term.path.quantity].dimension), swing.harmonic
    start, end = term.start, term.end
    if term.at == ANY_TIME:
        return at_any_time(term, history)
    if term.during is not None:
        interval = timeline.interval(term.during)
        if interval is None:
            raise Unclear(f"there is no phase or event `{term.during}`")
        start, end = interval.start, interval.end
    if term.modifier == "total" or term.path.quantity == "distance":
        return whole_way(term, *span(term, start, end, history), history, beside)
    if term.modifier in ("largest", "smallest"):
        return extreme(term, *span(term, start, end, history), history, beside)
    if term.path.quantity in SPANNED and term.modifier not in DIFFERENCE:
        return spanned(term, start, end, history)
    if term.modifier in DIFFERENCE and start and end:
        return difference(term, start, end, history)
    if term.modifier == "mean" and start and end:
        return mean(term, start, end, history, beside)
    return at_state(term, history)


def at_state(term: Term, history: History) -> tuple[Meaning, str]:
    """The meaning at one state: the one named, the only one, or any where it is the same throughout."""
    states = [term.at] if term.at else list(history.arrangement.timeline.named)
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
    start, end = span(term, start, end, history)
    intervals = timeline.between(start, end)
    if path.quantity == "displacement" and path.point is not None:
        return of_point(term, start, end, history), intervals[-1].name
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
            part = way(path, name, interval, instant) if interval.event is None else ZERO
        elif path.quantity in ("rotation", "turns"):
            part = angle_turned(path.owner, interval, instant) if interval.event is None else ZERO
        elif path.quantity in ("impulse", "angular_impulse"):
            part = impulse(path, interval.name, interval.start, history)
        else:
            part = work(path, interval.name, history)
        result = add(result, part)
    if path.quantity == "turns":
        result = result / (2 * PI)
    vector = blow(path, intervals[0].name, history) if path.quantity == "impulse" and len(intervals) == 1 else None
    return Meaning(result, kind.dimension, vector, label=label_of(path, term)), intervals[-1].name


def of_point(term: Term, start: str, end: str, history: History) -> Meaning:
    """Displacement of a point of a body on a fixed axis: where it is at the end less where it was."""
    path, dimension = term.path, DIMENSIONS["length"]
    ref = PointRef(path.owner, path.point, path.argument)
    instants = [history.instant(state) for state in (start, end)]
    host = instants[0].host(path.owner)
    turning = all(item.motion(host).kind == "axis" and item.angle(host) is not None for item in instants)
    if not turning or any(item.host(path.owner) != host for item in instants):
        raise NotYet(
            f"the displacement of `{path.owner}.{path.point}` is not solved yet",
            help=f"solved is a point of a body on a fixed axis whose angle the states tell: `{host}.angle`",
        )
    way = instants[1].point(ref) - instants[0].point(ref)
    label = f"displacement of {spoken_point(path)}"
    if path.component in ("x", "y"):
        return Meaning(way.along(RIGHT if path.component == "x" else UP), dimension, label=label)
    if path.component is not None:
        raise NotYet(f"the {path.component} part of a displacement has no meaning", help="ask for `x` or `y`")
    return Meaning(size_of(way), dimension, way, label=label)


def span(term: Term, start: str | None, end: str | None, history: History) -> tuple[str, str]:
    """The states from and to which a quantity is asked; from the state before to one that is named, else over the whole scene."""
    names = list(history.arrangement.timeline.named)
    if term.at is not None and term.at in names:
        start, end = names[max(0, names.index(term.at) - 1)], term.at
    start, end = start or names[0], end or names[-1]
    if names.index(start) >= names.index(end):
        help = (
            f"say `from … to …` with two of: {', '.join(names)}"
            if len(names) > 1
            else "give `states`, at least two of them"
        )
        raise Unclear(f"`{term.path.quantity}` runs from one state to a later one", help=help)
    return start, end


def difference(term: Term, start: str, end: str, history: History) -> tuple[Meaning, str]:
    """Change (later minus earlier) or loss (earlier minus later)."""
    if term.path.quantity in STORED:
        return stored_difference(term, start, end, history)
    first = history.reader(start).meaning(term.path, term)
    last = history.reader(end).meaning(term.path, term)
    section = history.arrangement.timeline.between(start, end)[-1].name
    label = f"{term.modifier.replace('lost', 'loss of')} {first.label}"
    earlier, later = (last, first) if term.modifier == "lost" else (first, last)
    if earlier.vector is not None and later.vector is not None and whole_vector(term.path):
        gap = tidy(later.vector - earlier.vector)
        return Meaning(size_of(gap), first.dimension, gap, label=label), section
    return Meaning(later.formula - earlier.formula, first.dimension, label=label), section


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


def mean(term: Term, start: str, end: str, history: History, beside: Beside | None) -> tuple[Meaning, str]:
    """Mean over time: work over time for a power, angle or way over time for a rate, its change for an acceleration."""
    whole = {
        "power": "work",
        "angular_velocity": "rotation",
        "velocity": "displacement",
        "speed": "distance",
        "acceleration": "velocity",
        "angular_acceleration": "angular_velocity",
        "force": "impulse",
        "torque": "angular_impulse",
    }
    summed = whole.get(term.path.quantity)
    if summed is None:
        raise NotYet(f"the mean of `{term.path.quantity}` is not solved yet")
    duration, section = spanned(Term(Path("", "time")), start, end, history)
    other = replace(
        term, path=replace(term.path, quantity=summed), modifier="change of" if summed.endswith("velocity") else ""
    )
    amount, _ = meaning_of(replace(other, start=start, end=end), history, beside)
    word = term.path.quantity.replace("_", " ")
    vector = None if amount.vector is None else amount.vector.times(ONE / duration.formula)
    return Meaning(
        amount.formula / duration.formula,
        BY_WORD[term.path.quantity].dimension,
        vector,
        label=f"mean {word}",
        laws=amount.laws,
    ), section
