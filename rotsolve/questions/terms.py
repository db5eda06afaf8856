"""Terms: what one path of a question means at its state, in its phase or event, or as a function of time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import Call, Formula, Number, Product, Symbol
from rotsolve.core.quantity import OSCILLATING, SPANNED
from rotsolve.core.symbols import MOMENTUM_SIZE, is_key, key_of
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.grammar import ANGLE_OF
from rotsolve.language.problem import ANY_TIME, EXTREMES, Path, Term
from rotsolve.paths.meaning import Meaning, NotYet, Unclear, path_text

if TYPE_CHECKING:
    from rotsolve.questions.functions_of_time import Beside

DIFFERENCE = ("change of", "lost")
OF_A_MOMENT = ("velocity", "speed", "kinetic_energy", "angular_momentum", "momentum")


def meaning_of(term: Term, scene: SceneEquations, beside: Beside | None = None) -> tuple[Meaning, str]:
    """A term's meaning, and the state, phase or event where it belongs."""
    meaning, section = signed_meaning(term, scene, beside)
    if term.modifier == "size of":
        meaning = replace(meaning, formula=scene.configuration.signs.unbarred(magnitude(meaning.formula)))
    return meaning, section


def magnitude(formula: Formula) -> Formula:
    """|x|; of a multiple of a root or a size the same, of a number without its minus."""
    if isinstance(formula, Number):
        return Number(abs(formula.value))
    if isinstance(formula, Symbol) and is_key(formula.name) and key_of(formula.name).kind == MOMENTUM_SIZE:
        return formula
    parts = formula.factors if isinstance(formula, Product) else (formula,)
    bare = all(
        part.function in ("abs", "sqrt") if isinstance(part, Call) else isinstance(part, Number) and part.value > 0
        for part in parts
    )
    return formula if bare or not formula.symbols() else Call("abs", (formula,))


def signed_meaning(term: Term, scene: SceneEquations, beside: Beside | None) -> tuple[Meaning, str]:
    """The meaning of a term with its sign, whether or not its size is asked."""
    if term.path.quantity in OSCILLATING and not scene.configuration.problem.space:
        swing = scene.swing(term)
        return Meaning(swing.letters[term.path.quantity], swing.dimension(term.path.quantity)), swing.harmonic
    start, end = term.start, term.end
    if scene.configuration.problem.space:
        if term.at == ANY_TIME:
            refuse_modifier(term)
            from rotsolve.questions.functions_of_time import phases_of

            phase = phases_of(term, scene)[0].name
            return scene.reader_in(phase).meaning(term.path, term), phase  # type: ignore[attr-defined]
        if term.path.quantity in OSCILLATING:
            return scene.small_swings(term)  # type: ignore[attr-defined, no-any-return]
        if start or term.during:
            return scene.between(term)  # type: ignore[attr-defined, no-any-return]
        if term.modifier in EXTREMES:
            return scene.steady_extreme(term)  # type: ignore[attr-defined, no-any-return]
        refuse_modifier(term)
        return at_state(term, scene)
    if term.at == ANY_TIME:
        from rotsolve.questions.functions_of_time import meaning_at_any_time

        return meaning_at_any_time(term, scene)
    if term.during is not None:
        ends = scene.configuration.timeline.whole(term.during)
        if ends is None:
            raise Unclear(f"there is no phase or event `{term.during}`")
        start, end = ends
    if term.modifier in ("", "size of") and term.path.quantity not in ("distance", *SPANNED):
        return at_state(term, scene)
    return from_to(term, start, end, scene, beside)


def from_to(
    term: Term, start: str | None, end: str | None, scene: SceneEquations, beside: Beside | None
) -> tuple[Meaning, str]:
    """The meaning of what is asked over a time: of a way, a sum, a mean, an extreme or a difference between two states."""
    from rotsolve.questions.spans import span, spanned

    if term.modifier == "total" or term.path.quantity == "distance":
        from rotsolve.questions.functions_of_time import whole_way

        return whole_way(term, *span(term, start, end, scene), scene, beside)
    if term.modifier in ("largest", "smallest"):
        from rotsolve.questions.functions_of_time import extreme

        return extreme(term, *span(term, start, end, scene), scene, beside)
    if term.path.quantity in SPANNED and term.modifier == "mean":
        word = term.path.quantity
        message = f"`{path_text(term.path)}` is that of a whole phase, and has no mean"
        raise NotYet(message, term.path.span, f"leave `mean` out, or ask for the mean of what makes up the {word}")
    if term.path.quantity in SPANNED and term.modifier not in DIFFERENCE:
        return spanned(term, start, end, scene)
    if term.modifier in DIFFERENCE and start and end:
        from rotsolve.questions.spans import change_or_loss

        return change_or_loss(term, start, end, scene)
    if term.modifier == "mean" and start and end:
        from rotsolve.questions.means import mean

        return mean(term, start, end, scene, beside)
    refuse_modifier(term)
    return at_state(term, scene)


def refuse_modifier(term: Term) -> None:
    """Refuse what is asked over a time, `lost` or `mean`, where one state is named."""
    if term.modifier not in ("", "size of", ANGLE_OF):
        message = f"`{term.modifier} {path_text(term.path)}` is asked over a time, and no two states are named"
        raise NotYet(message, term.path.span, "say `from` one state `to` another")


def at_state(term: Term, scene: SceneEquations) -> tuple[Meaning, str]:
    """The meaning at one state: the one named, the only one, or any where it is the same throughout."""
    states = [term.at] if term.at else list(scene.configuration.timeline.named)
    found: dict[Formula, tuple[Meaning, str]] = {}
    failed: NotYet | None = None
    for state in states:
        try:
            meaning = scene.reader(state).meaning(term.path, term)
        except NotYet as error:
            failed = error
            continue
        found.setdefault(meaning.formula, (meaning, section_of_definition(term.path, meaning, state, scene)))
    if not found:
        raise failed or Unclear("nothing is asked")
    if len(found) > 1:
        raise Unclear(
            f"`{path_text(term.path)}` is not the same at all states", help=f"say `at` which: {', '.join(states)}"
        )
    return next(iter(found.values()))


def section_of_definition(path: Path, meaning: Meaning, state: str, scene: SceneEquations) -> str:
    """Where a definition is written: with the accelerations of a phase, or at its state."""
    moments = {key_of(name).when for name in meaning.formula.symbols() if is_key(name)}
    return state if path.quantity in OF_A_MOMENT or state in moments else scene.section(state)
