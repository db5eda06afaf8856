"""Plan: which laws a derivation goes by, for what, and in which order, said before it begins; from its laws and steps alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.formula import Formula, Sum, Symbol
from rotsolve.core.derivation import Answer, Derivation, Equality, ForceLine, LawLine, Section
from rotsolve.core.equation import (
    ABOUT_CONTACT,
    ANGULAR_MOMENTUM_IN_SPACE,
    BLOWS,
    CONSERVATION,
    DERIVATIVE,
    INERTIA,
    INTEGRATED,
    KINETIC_ENERGY_AT,
    PARALLEL_AXES,
    RATE_IN_AXES,
    RATE_IN_STILL_AXES,
    ROTATION,
    RULE,
    RULE_OF_WAYS,
    SECOND_LAW,
    STABILITY,
    STEADY_LIMIT,
    STEADY_TRAVEL,
    STEADY_TURN,
    STRETCH,
    TRAVEL_AT_ANY_TIME,
    TRAVEL_BY_MEAN,
    TURN_AT_ANY_TIME,
    TURN_BY_MEAN,
    TWISTS,
    UNTWISTED,
    WORK_AND_ENERGY,
)
from rotsolve.core.writing import and_joined
from rotsolve.page.backing import Backing
from rotsolve.page.blocks import Phrase
from rotsolve.page.wording import enumerated

FEWEST = 2  # laws of a derivation that needs a plan
FOR = " for {}"
LIMITS = {  # what wants a plan though it is one law
    STABILITY.name: "what a small disturbance of the motion of {} does: at the limit nothing drives it back",
    STEADY_LIMIT.name: "steady precession of {} by τ = Ω × L: at the limit both of its rates are one",
}
APART = frozenset(law.name for law in (INERTIA, INTEGRATED, PARALLEL_AXES, KINETIC_ENERGY_AT))
TIES = frozenset(law.name for law in (RULE, RULE_OF_WAYS, STRETCH))  # what ties motions together
SAID = {  # how a plan speaks of a law, with its bodies behind it where it is written for each; of others by their labels
    SECOND_LAW.name: "Newton's second law for {}",
    ROTATION.name: "Newton's law for rotation for {}",
    ABOUT_CONTACT.name: "Newton's law for rotation about the point of contact for {}",
    CONSERVATION.name: "the conservation of energy",
    WORK_AND_ENERGY.name: "work and energy",
    DERIVATIVE.name: "the derivative of the energy",
    BLOWS.name: "impulse and change of momentum for {}",
    TWISTS.name: "angular impulse and change of angular momentum for {}",
    UNTWISTED.name: "angular impulse and change of angular momentum for {}",
    RATE_IN_AXES.name: "the rate of the angular momentum in axes that turn, τ = dL/dt + Ω × L, for {}",
    RATE_IN_STILL_AXES.name: "the rate of the angular momentum, τ = dL/dt, for {}",
    ANGULAR_MOMENTUM_IN_SPACE.name: "the angular momentum of {} by its components",
    **dict.fromkeys(
        (
            law.name
            for law in (STEADY_TRAVEL, STEADY_TURN, TRAVEL_BY_MEAN, TURN_BY_MEAN, TRAVEL_AT_ANY_TIME, TURN_AT_ANY_TIME)
        ),
        "the equations of constant acceleration for {}",
    ),
}

ABOUT_BOTH = "Newton's law for rotation about the centre of mass and about the point of contact for {}"


def plan_of(derivation: Derivation) -> tuple[Phrase, ...]:
    """The plan, sentence by sentence; nothing where there is little to plan."""
    sections = planned_once([section for section in derivation.sections if section.laws])
    if sum(len(section.laws) for section in sections) < FEWEST:
        return tuple(map(limit_planned, (law for section in sections for law in section.laws if law.name in LIMITS)))
    if len(sections) == 1:
        return tuple(plan_sentences(sections[0], derivation))
    found = found_in(sections, derivation)
    return tuple(plan_stage(*stage) for stage in zip(range(1, len(sections) + 1), sections, found, strict=True))


def planned_once(sections: Sequence[Section]) -> Sequence[Section]:
    """The sections to plan: of cases of letters that are planned alike the first."""
    cases: dict[tuple[Equality, ...], list[Section]] = {}
    for section in sections:
        cases.setdefault(section.case, []).append(section)
    planned = {tuple(tuple(principles(section.laws)) for section in own) for own in cases.values()}
    return next(iter(cases.values())) if len(planned) == 1 else sections


def limit_planned(law: LawLine) -> Phrase:
    """By what a limit is told, where that is all that there is."""
    return (capital(LIMITS[law.name].format(and_joined(law.bodies or ("all",)))) + ".",)


def plan_sentences(section: Section, derivation: Derivation) -> Iterator[Phrase]:
    """What a scene of one instant or phase is solved by, and what ties its motions together."""
    laws, ties = principles(section.laws), ties_of(section.laws)
    if laws:
        yield (capital(f"{and_joined(laws)}."),)
    yield from map(turned_alone, telling_forces(section))
    yield from only_torques(section)
    if laws and ties:
        yield (f"The motions are tied together: {and_joined(ties)}.",)


def telling_forces(section: Section) -> Iterator[ForceLine]:
    """The bodies that one unknown force alone turns, of which Newton's second law tells the size."""
    for line in section.forces:
        letters = set() if line.turned is None else line.turned[1].symbols()
        laws = [law for law in section.laws if law.name == SECOND_LAW.name]
        if letters and any(letters & (law.equation.left.symbols() | law.equation.right.symbols()) for law in laws):
            yield line


def only_torques(section: Section) -> Iterator[Phrase]:
    """ "About the point of contact only F (R − r) turns reel.", where one torque alone acts about it."""
    for law in section.laws:
        left = law.equation.left
        if law.name == ABOUT_CONTACT.name and not isinstance(left, Sum) and len(law.bodies) == 1:
            yield ("About the point of contact only the torque ", left, f" turns {law.bodies[0]}.")


def turned_alone(line: ForceLine) -> Phrase:
    """Why Newton's second law is needed as well: "Only the friction f turns disc: it is unknown, and Newton's second law tells it."."""
    assert line.turned is not None
    noun, letter = line.turned
    return (f"Only the {noun} ", letter, f" turns {line.body}: it is unknown, and Newton's second law tells it.")


def plan_stage(number: int, section: Section, found: Sequence[Answer]) -> Phrase:
    """One stage of several, and what it is the first to find: "2. From after to top: the conservation of energy; this gives ω."."""
    laws, backing = principles(section.laws), Backing(section, is_principle)
    own = [(answer.symbol,) for answer in found if not laws or any(map(backing.rests, symbols_told(answer)))]
    gives = ("; this gives ", *enumerated(own)) if own else ()
    head = f"{number}. {section.title}{': ' if section.title else ''}"
    return (f"{head}{and_joined(laws or plain_labels(section.laws))}", *gives, ".")


def found_in(sections: Sequence[Section], derivation: Derivation) -> list[list[Answer]]:
    """The answers that each section finds: where its letter is told first, of a vector without one where its last component is."""
    told = [set[Formula]() if section.supposed else letters_told(section) for section in sections]
    found: list[list[Answer]] = [[] for _ in sections]
    for answer in derivation.answers:
        own = [place for place, ends in enumerate(told) if answer.symbol in ends]
        parts = [place for place, ends in enumerate(told) if any(letter in ends for letter in symbols_told(answer))]
        if own or parts:
            found[own[0] if own else parts[-1]].append(answer)
    return found


def letters_told(section: Section) -> set[Formula]:
    """The letters that the laws and steps of a section tell."""
    ends = {move.chain[-1].left for move in section.moves if move.chain}
    return {*ends, *(law.equation.left for law in section.laws)}


def symbols_told(answer: Answer) -> list[Symbol]:
    """The letters that stand for an answer in steps: its own, and those of its components."""
    return [one.symbol for one in (answer, *answer.components) if isinstance(one.symbol, Symbol)]


def principles(laws: Sequence[LawLine]) -> list[str]:
    """The laws of motion, conservation and kinematics, each once, those of the same bodies side by side."""
    bodies: dict[str, list[str]] = {}
    for law in laws:
        if is_principle(law):
            own = bodies.setdefault(SAID.get(law.name) or head_of(law), [])
            own += [body for body in law.bodies[:1] if body not in own]
    alike: dict[tuple[str, ...], list[str]] = {}
    for said, own in bodies.items():
        alike.setdefault(tuple(own) if said.endswith(FOR) else (said,), []).append(said)
    alike = {own: list(about_both(group)) for own, group in alike.items()}
    return [
        f"{and_joined([said.removesuffix(FOR) for said in group])}{FOR.format(and_joined(own))}"
        if group[0].endswith(FOR)
        else and_joined(group).format(and_joined(bodies[group[0]] or ("",)))
        for own, group in alike.items()
    ]


def about_both(group: Sequence[str]) -> Iterator[str]:
    """The laws of the same bodies, that for rotation about two points named once."""
    both = [SAID[law.name] for law in (ROTATION, ABOUT_CONTACT)]
    if not set(both) <= set(group):
        yield from group
        return
    yield from dict.fromkeys(ABOUT_BOTH if said in both else said for said in group)


def is_principle(law: LawLine) -> bool:
    """Whether a law is one of motion, conservation or kinematics, and not a tie or what a quantity is."""
    return law.name not in TIES and bool(law.family or law.name in SAID)


def ties_of(laws: Sequence[LawLine]) -> list[str]:
    """What ties motions together, each once: "the string does not slip"."""
    return list(dict.fromkeys(head_of(law) for law in laws if law.name in TIES))


def head_of(law: LawLine) -> str:
    """The label of a law up to its first comma that is not within brackets: "torque of ball about (0, 0, 0)"."""
    depth = 0
    for place, letter in enumerate(law.law):
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if not depth and law.law.startswith(", ", place):
            return law.law[:place]
    return law.law


def plain_labels(laws: Sequence[LawLine]) -> list[str]:
    """What remains: what quantities are by their definitions."""
    own = [law for law in laws if law.name not in APART] or laws
    return list(dict.fromkeys(head_of(law) for law in own))


def capital(words: str) -> str:
    """A sentence with its first letter large."""
    return words[:1].upper() + words[1:]
