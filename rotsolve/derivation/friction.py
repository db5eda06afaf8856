"""Friction shown: the sections that tell why contacts can not stick, before those of the answers."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.algebra.formula import Symbol, call
from rotsolve.core.derivation import Equality, Move, Section, Words
from rotsolve.core.writing import spoken
from rotsolve.derivation.compose import DerivationComposer
from rotsolve.search.friction import Trial


def trial_sections(trials: Iterable[Trial]) -> tuple[tuple[Section, ...], int]:
    """A section for each contact that can not stick, and the number of the next equation."""
    sections: list[Section] = []
    number = 1
    for trial in trials:
        section, number = trial_section(trial, number)
        sections.append(section)
    return tuple(sections), number


def trial_section(trial: Trial, first: int) -> tuple[Section, int]:
    """The section that shows why a contact can not stick, and the number of the next equation."""
    composer = DerivationComposer(trial.search, first)
    body = spoken(trial.contact.lying())
    derivation = composer.derivation(())
    laws = tuple(law for section in derivation.sections for law in section.laws)
    moves = tuple(move for section in derivation.sections for move in section.moves)
    static = trial.contact.static()
    needed, normal = trial.friction.found.formula, trial.normal.found.formula
    assert static is not None and needed is not None and normal is not None
    limit = trial.search.solver.simplify(static * normal)
    sizes = [
        certified.text(4).lstrip("−")
        for value in (needed, limit)
        if (certified := composer.results.value(value)) is not None
    ]
    letter = Symbol(composer.letters.names[trial.friction.asked.letter])
    words: Words = (f"{' N > '.join(sizes)} N: more than the contact can give, so {body} slips",)
    move = Move(
        "",
        (Equality(call("abs", letter), static * Symbol(composer.letters.names[trial.normal.asked.letter]), ">"),),
        None,
        words,
    )
    return Section(f"Does {body} slip? Suppose it does not", (), (), laws, (*moves, move)), first + len(
        composer.numbers
    )
