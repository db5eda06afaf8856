"""Second told: a second way to an answer as a section, its laws numbered behind all others, with names for letters of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.core.derivation import Cited, Equality, LawLine, Move, Section
from rotsolve.core.equation import Equation
from rotsolve.core.symbols import is_key
from rotsolve.derivation.second_ways import Putting, SecondWay
from rotsolve.derivation.stages import all_names

if TYPE_CHECKING:
    from rotsolve.derivation.compose import DerivationComposer


def second_section(way: SecondWay, composer: DerivationComposer) -> Section:
    """Why it is another way, its laws and its steps."""
    letters, first = composer.letters, max(composer.numbers.values(), default=composer.first - 1) + 1
    own = {name for one in way.laws for side in (one.equality.left, one.equality.right) for name in side.symbols()}
    if any(is_key(name) and name not in letters.names for name in own):
        letters.names |= {name: text for name, text in all_names(composer.search, letters).items() if name in own}
    laws = tuple(
        LawLine(
            number, one.law.label, equality_shown(one.equality, composer), letters.words(one.remark), one.law.law.name
        )
        for number, one in enumerate(way.laws, first)
    )
    moves = tuple(step_told(step, first, composer) for step in way.steps)
    return Section("", remarks=(letters.words(way.why),), laws=laws, moves=moves)


def step_told(step: Putting, first: int, composer: DerivationComposer) -> Move:
    """A step of a second way, whose laws are numbered from the `first` on."""
    marks = {id(composer.pool[int(index)]): f"({n})" for (kind, index), n in composer.numbers.items() if kind == "law"}

    def mark(law: Equation | int | None) -> str:
        return f"({law + first})" if isinstance(law, int) else marks.get(id(law), "")

    cited = tuple(Cited(composer.letters.printed(letter), mark(law)) for letter, law in step.put)
    return Move("", tuple(equality_shown(one, composer) for one in step.chain), put=cited, into=mark(step.into))


def equality_shown(equality: Equality, composer: DerivationComposer) -> Equality:
    return Equality(composer.shown(equality.left), composer.shown(equality.right), equality.relation)
