"""Sought: what a scene asks for, in words around its letters: "angular velocity ω of rod just after the hit"."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Number, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.core.derivation import Words
from rotsolve.core.quantity import OSCILLATING, QUANTITIES
from rotsolve.core.writing import spoken
from rotsolve.derivation.headings import moment_title
from rotsolve.language.problem import ANY_TIME, Find, Path, Term
from rotsolve.motion.timeline import Timeline
from rotsolve.paths.meaning import label_of

PLAIN = Symbol("#0")  # the formula of a question for one quantity alone
NAMES = {"inertia": "moment of inertia", "gyration": "radius of gyration", "cm": "centre of mass"}  # of quantities
SWINGS = ("small swings", "swings")  # modifiers that say of which motion a period is
WITHIN = ("gravity", "net", "rotational", "translational")  # components that the name of a quantity has in it
COUNTED = ("rotations", "translations")  # components that are quantities of their own
SAID = {
    "coriolis": "Coriolis",
    "euler": "Euler",
    "1": "first",
    "2": "second",
    "3": "third",
}  # components as they are said

CONDITIONS = {"stable": "is stable", "steady": "is steady"}  # of words behind `where`, as they are said


def sought_words(find: Find, timeline: Timeline) -> Words:
    """The letter of a question, within words where it asks for one quantity, or for what fulfils a condition."""
    letter, condition = Symbol(find.group), condition_in_words(find, timeline)
    if condition:
        return (*of_condition(find, timeline), " for which ", *condition)
    term = plain_term(find)
    if term is None or find.where is not None:
        return (letter, " = ", find.formula) if of_earlier(find) else (letter,)
    before, (word, owner) = part_asked(find, term), named(find, term)
    behind = f"{owner}{observed_in(term)}{moment_words(term, timeline)}"
    if before.endswith(" of the "):
        return (before.removesuffix("of the "), letter, f" of the {word}{behind}")
    return (f"{before}{word} ", letter, behind) if behind else (f"{before}{word} ", letter)


def of_earlier(find: Find) -> bool:
    """Whether a question is an expression of givens and earlier answers."""
    alone = isinstance(find.formula, Symbol) or bool(find.terms or find.modifier or find.where)
    return not alone and find.choice is None


def plain_term(find: Find) -> Term | None:
    """The quantity of a question for one quantity alone that has a name; None of others."""
    term = find.terms[0] if len(find.terms) == 1 and find.formula == PLAIN and find.choice is None else None
    if term is None or term.other is not None or (not term.path.owner and term.path.quantity in OSCILLATING):
        return None
    return term


def of_condition(find: Find, timeline: Timeline) -> Words:
    """What is asked under a condition: "smallest value v_d of v", "largest F", "speed v of rod"."""
    if find.terms:
        return sought_words(replace(find, where=None), timeline)
    letter, modifier = Symbol(find.group), f"{find.modifier} " if find.modifier else ""
    if find.formula == letter:
        return (modifier, letter) if modifier else (letter,)
    return (f"{modifier}value ", letter, " of ", find.formula)


def condition_in_words(find: Find, timeline: Timeline) -> Words:
    """The condition of a question in words: "upright is stable", "x component of the impulse of pin in the hit = 0"; nothing where it has
    none, or one that is no quantity alone."""
    condition = find.where
    if condition is None or (not find.terms and not isinstance(find.formula, Symbol)):
        return ()
    phrase = condition.phrase
    if phrase is None:
        return (f"{spoken(condition.owner)} {CONDITIONS.get(condition.word or '', condition.word)}",)
    term = plain_term(phrase)
    if term is None:
        return ()
    said = (
        f"the {part_asked(phrase, term)}{''.join(named(phrase, term))}{observed_in(term)}{moment_words(term, timeline)}"
    )
    if condition.value is None:
        return (f"{said} is {condition.word}",)
    if isinstance(condition.value, Number) and condition.value != ZERO:
        return (f"{said} = {unit_for(QUANTITIES[term.path.quantity].dimension).after(to_text(condition.value))}",)
    return f"{said} = ", condition.value


def named(find: Find, term: Term) -> tuple[str, str]:
    """What a quantity is called, and of what it is: "moment of inertia", " of disc about the centre"."""
    quantity, component = term.path.quantity, term.path.component or ""
    head, _, owner = label_of(term.path, replace(term, relative=None)).partition(spoken(quantity))
    if component in COUNTED and not find.whole:
        return component, owner
    return head + NAMES.get(quantity, spoken(quantity)), owner


def part_asked(find: Find, term: Term) -> str:
    """What of the quantity is asked for: its size, its x component, a tangential part, its mean."""
    modifier = find.modifier or term.modifier
    component = "" if find.whole else term.path.component or ""
    before = "" if modifier in SWINGS or not modifier else f"{modifier} "
    if before.endswith("of "):
        before = f"{before.replace('of change', 'of the change')}the "
    which, _, axis = component.rpartition(" ")
    if axis in ("x", "y", "z"):
        before, component = f"{before}{axis} component of the ", which
    return before if component in ("", *WITHIN, *COUNTED) else f"{before}{SAID.get(component, component)} "


def observed_in(term: Term) -> str:
    """In which axes, relative to which body, or in which swings."""
    swings = f" in {term.modifier}" if term.modifier in SWINGS else ""
    if term.relative:
        return f"{swings} relative to {spoken(term.relative)}"
    return f"{swings} in {term.axes} axes" if term.axes else swings


def moment_words(term: Term, timeline: Timeline) -> str:
    """At which state, or between which, where a scene has several; by what way or turn a mean is taken."""
    if len(timeline.named) < 2:
        return ""
    if term.start is not None and term.end is not None:
        by = f" by the {term.by.quantity} of {spoken(term.by.owner)}" if isinstance(term.by, Path) else ""
        return f"{by} from {spoken(term.start)} to {spoken(term.end)}"
    if term.during is not None:
        return f" in the {spoken(term.during)}"
    if term.at is None or term.at == ANY_TIME or term.at not in timeline.order:
        return ""
    title = moment_title(term.at, timeline)
    return f" {title[:1].lower()}{title[1:]}"
