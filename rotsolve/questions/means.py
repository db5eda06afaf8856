"""Means: of a quantity over the time of a phase or several, ∫ Q dt/t, or over a turn or a way, ∫ Q dθ/θ."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Symbol, total
from rotsolve.core.facts import signed
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.quantity import MEAN_OF, QUANTITIES
from rotsolve.core.symbols import CONSTANT, POSITION, RATE, TIME, at_any_time, has_quantities, is_key, key_of
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path, Term
from rotsolve.laws.momentum import over_time
from rotsolve.paths.meaning import Meaning, NotYet, path_text
from rotsolve.questions.spans import over_interval, spanned

if TYPE_CHECKING:
    from rotsolve.questions.functions_of_time import Beside

IMPULSES = ("impulse", "angular_impulse")
RATE_OF = {"rotation": "angular_velocity", "displacement": "velocity"}  # of what a mean may be taken by


def mean(term: Term, start: str, end: str, scene: SceneEquations, beside: Beside | None) -> tuple[Meaning, str]:
    """Work over time for a power, the change over time for a rate, else ∫ Q dt/t; by a turn or a way ∫ Q dθ/θ."""
    by = term.by if isinstance(term.by, Path) else None
    intervals = scene.configuration.timeline.between(start, end)
    phases = [scene.passages[interval.name] for interval in intervals if interval.name in scene.passages]
    if not phases:
        raise NotYet(f"no time passes over which `{path_text(term.path)}` could have a mean")
    over, section = spanned(Term(by or Path("", "time")), start, end, scene)
    kind, word = QUANTITIES[term.path.quantity], spoken(term.path.quantity)
    label = f"mean {word}" + ("" if by is None else f" by the {by.quantity} of {spoken(by.owner)}")
    known = summed_elsewhere(term, start, end, scene, beside) if by is None else None
    if known is not None:
        vector = None if known.vector is None else known.vector.times(ONE / over.formula)
        quotient = known.formula / over.formula
        return Meaning(quotient, kind.dimension, vector, label=label, laws=known.laws, plain=True), section
    check_one_way(term.path, phases, scene)
    whole = total([summed_up(term, by, passage, scene) for passage in phases])
    return Meaning(whole / over.formula, kind.dimension, label=label, plain=True), section


def check_one_way(path: Path, phases: Sequence[Passage], scene: SceneEquations) -> None:
    """What is told by its size and a word for its direction points one way all the time."""
    said = path_text(path)
    found = [scene.reader(phase.start.state).meaning(path) for phase in phases]
    ways = {meaning.words[0] for meaning in found if meaning.formula != ZERO}
    if path.quantity == "friction_force" and len(ways) > 1:
        raise NotYet(f"`{said}` turns round on the way: that is not solved yet", help="ask for each phase of its own")
    held = path.owner not in scene.configuration.bodies and scene.configuration.connection(
        path.owner, phases[0].start.state
    )
    if (
        path.quantity == "force"
        and held
        and path.component is None
        and len(found[0].vector.parts if found[0].vector else ()) < 2
    ):
        raise NotYet(f"the mean of `{said}`, which is told by its size, is not solved yet", help="ask for `.x` or `.y`")


def summed_elsewhere(term: Term, start: str, end: str, scene: SceneEquations, beside: Beside | None) -> Meaning | None:
    """What the laws have a sum of, or a change: of a power the work, of a velocity the way, of an acceleration the velocity gained."""
    from rotsolve.questions.terms import meaning_of

    summed = MEAN_OF.get(term.path.quantity)
    if summed is None:
        return None
    item = scene.configuration.connection(term.path.owner, start)
    if item is not None and summed in RATE_OF and summed not in item.quantities:
        help = "ask for that of the body that it holds"
        raise NotYet(f"the mean of `{path_text(term.path)}` is not solved yet", help=help)
    path, modifier = replace(term.path, quantity=summed), "change of" if summed.endswith("velocity") else ""
    try:
        return meaning_of(replace(term, path=path, modifier=modifier, start=start, end=end), scene, beside)[0]
    except NotYet:
        if summed not in IMPULSES or term.path.owner in scene.configuration.bodies:
            raise
        return None  # a force or torque that varies with the motion


def summed_up(term: Term, by: Path | None, passage: Passage, scene: SceneEquations) -> Formula:
    """∫ Q dt over a phase, or ∫ Q dθ: of what stays the same Q t or Q θ, else by the time, the place or the rate by which all goes."""
    start = passage.start.state
    first, midway = (scene.reader(start, generic=generic).meaning(term.path, term) for generic in (False, True))
    if first.vector is not None and len(first.vector.parts) > 1 and term.path.component is None:
        raise NotYet(
            f"the mean of `{path_text(term.path)}`, which has a direction, is not solved yet",
            help="ask for `.x` or `.y`",
        )
    first, midway = (along_its_line(term.path, meaning) for meaning in (first, midway))
    varies = TIME in midway.formula.symbols() or at_any_time(midway.formula.symbols())
    if by is not None and not varies:
        interval = scene.configuration.timeline.interval(passage.name)
        assert interval is not None
        return first.formula * over_interval(by, interval, scene)
    if by is None and not varies:
        return over_time(first.formula, midway.formula, passage)
    lead = lead_of_mean(term.path, passage, scene)
    value = midway.formula
    if by is not None:
        rate = scene.reader(start, generic=True).meaning(replace(by, quantity=RATE_OF[by.quantity])).formula
        if lead is not None and lead.pace == POSITION and lead.arm == ONE and rate in (lead.moving, -lead.moving):
            return along_place(signed(value, 1 if rate == lead.moving else -1), lead)
        value = value * rate
    if lead is None:
        return Integral(value, TIME, *passage.times)
    if lead.pace == RATE and isinstance(lead.moving, Symbol):
        return Integral(simplify(value / lead.acceleration), lead.moving.name, lead.before, lead.after)
    return along_place(simplify(value / lead.moving), lead)


def along_its_line(path: Path, meaning: Meaning) -> Meaning:
    """A force that acts along one line with its sign there, not its size."""
    if (
        path.quantity != "force"
        or path.component is not None
        or meaning.vector is None
        or len(meaning.vector.parts) != 1
    ):
        return meaning
    return replace(meaning, formula=meaning.vector.parts[0][0])


def along_place(value: Formula, lead: Travel) -> Formula:
    """∫ Q dx along the way of a coordinate, counted along its positive sense."""
    assert lead.start is not None and lead.end is not None and isinstance(lead.coordinate, Symbol)
    others = [name for name in value.symbols() - {lead.coordinate.name} if is_key(name) and key_of(name).midst]
    if others and not lead.leads:
        raise NotYet(f"the mean of what goes by the place of `{lead.body}` and by its speed there is not solved yet")
    if has_quantities(lead.start) or has_quantities(lead.end):  # it may turn back before
        message = f"the mean of what goes by the place of `{lead.body}` is solved between states that tell the place"
        raise NotYet(message)
    start, end = (signed(place, lead.sense) for place in (lead.start, lead.end))
    return Integral(signed(value, lead.sense), lead.coordinate.name, start, end)


def lead_of_mean(path: Path, passage: Passage, scene: SceneEquations) -> Travel | None:
    """The coordinate, or the rate, by which goes what a path speaks of; None where all goes by the time."""
    owner = path.owner if path.owner in scene.configuration.bodies else ""
    host = scene.instant(passage.start.state).host(owner) if owner else ""
    group = next((group for group in passage.groups if host in group), None)
    travels = [travel for travel in passage.travels if group is None or travel.body in group]
    leads = [travel for travel in travels if travel.leads]
    paces = {travel.pace for travel in travels if travel.given not in (0, 1)}
    if not leads and paces <= {CONSTANT, TIME}:
        return None
    leads = leads or [travel for travel in travels if travel.pace == POSITION and travel.start is not None]
    if len(leads) == 1 and isinstance(leads[0].moving if leads[0].pace == RATE else leads[0].coordinate, Symbol):
        return leads[0]
    message = (
        f"the mean of `{path_text(path)}`, which goes by more than one of time, place and speed, is not solved yet"
    )
    raise NotYet(message)
