"""Friction shown: the sections that tell why contacts can not stick, before those of the answers."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.algebra.formula import call
from rotsolve.core.derivation import Equality, Move, Section, Words
from rotsolve.core.symbols import of_kinds
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
    composer, body = DerivationComposer(shown.search, first), spoken(shown.contact.lying())
    sections = composer.derivation(()).sections
    laws = tuple(law for section in sections for law in section.laws)
    moves = tuple(move for section in sections for move in section.moves)
    static = shown.contact.static()
    needed, normal = shown.friction.found.formula, shown.normal.found.formula
    assert static is not None and needed is not None and normal is not None
    limit = shown.search.solver.simplify(static * normal)
    unit = "N s" if of_kinds([shown.friction.asked.letter], ("impulse",)) else "N"
    numbers = [composer.results.value(value) for value in (needed, limit)]
    sizes = [number.text(4).lstrip("−") for number in numbers if number is not None]
    compared = f"{f' {unit} > '.join(sizes)} {unit}: " if len(sizes) == len(numbers) else ""
    words: Words = (f"{compared}more than the contact can give, so {body} slips",)
    friction, push = (composer.letters.symbols[force.asked.letter] for force in (shown.friction, shown.normal))
    sign = None if numbers[0] is None else numbers[0].sign
    size = call("abs", friction) if not sign else friction * sign
    move = Move("", (Equality(size, static * push, ">"),), None, words)
    section = Section(f"Does {body} slip? Suppose it does not", (), (), laws, (*moves, move), supposed=True)
    return section, first + len(composer.numbers)
