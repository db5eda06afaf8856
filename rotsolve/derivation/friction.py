"""Friction shown: the sections that tell why contacts can not stick, before those of the answers."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.algebra.formula import Symbol, call
from rotsolve.core.derivation import Equality, Move, Section, Words
from rotsolve.core.writing import spoken
from rotsolve.derivation.compose import DerivationComposer
from rotsolve.search.friction import SlippingContact


def slipping_sections(contacts: Iterable[SlippingContact]) -> tuple[tuple[Section, ...], int]:
    """A section for each contact that can not stick, and the number of the next equation."""
    sections: list[Section] = []
    number = 1
    for contact in contacts:
        section, number = section_of_slipping(contact, number)
        sections.append(section)
    return tuple(sections), number


def section_of_slipping(shown: SlippingContact, first: int) -> tuple[Section, int]:
    """The section that shows why a contact can not stick, and the number of the next equation."""
    composer = DerivationComposer(shown.search, first)
    body = spoken(shown.contact.lying())
    derivation = composer.derivation(())
    laws = tuple(law for section in derivation.sections for law in section.laws)
    moves = tuple(move for section in derivation.sections for move in section.moves)
    static = shown.contact.static()
    needed, normal = shown.friction.found.formula, shown.normal.found.formula
    assert static is not None and needed is not None and normal is not None
    limit = shown.search.solver.simplify(static * normal)
    sizes = [
        certified.text(4).lstrip("−")
        for value in (needed, limit)
        if (certified := composer.results.value(value)) is not None
    ]
    letter = Symbol(composer.letters.names[shown.friction.asked.letter])
    words: Words = (f"{' N > '.join(sizes)} N: more than the contact can give, so {body} slips",)
    move = Move(
        "",
        (Equality(call("abs", letter), static * Symbol(composer.letters.names[shown.normal.asked.letter]), ">"),),
        None,
        words,
    )
    return Section(f"Does {body} slip? Suppose it does not", (), (), laws, (*moves, move)), first + len(
        composer.numbers
    )
