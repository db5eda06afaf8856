"""Meanings: what every letter of a scene stands for, also one that no derivation prints; worked out when someone asks."""

from __future__ import annotations

from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Equality
from rotsolve.core.symbols import TIME, is_key, key_of
from rotsolve.derivation.compose import DerivationComposer
from rotsolve.derivation.letters import in_printed_letters
from rotsolve.derivation.stages import all_names
from rotsolve.search.search import Search


class Meanings(Struct, frozen=True, dict=True):
    """The letters of a solved scene: quantities by their printed names."""

    composer: DerivationComposer

    @property
    def search(self) -> Search:
        return self.composer.search

    @cached_property
    def names(self) -> dict[str, str]:
        """The printed name of every quantity of the laws, by its key; the derivation's where it prints it."""
        return all_names(self.search, self.composer.letters)

    @cached_property
    def keys(self) -> dict[str, str]:
        """The key of every quantity, by its printed name."""
        return {printed: key for key, printed in self.names.items() if is_key(key)}

    @property
    def time(self) -> str:
        """The printed letter of the running time."""
        return self.composer.letters.time

    @cached_property
    def apart(self) -> Search:
        return self.search.apart()

    def closed(self, name: str) -> Formula | None:
        """The closed form of a printed letter in givens and the running time; None where there is none."""
        found: dict[str, Formula | None] = self.__dict__.setdefault("found", {})
        if name not in found:
            found[name] = self._closed(self.keys[name])
        return found[name]

    def _closed(self, key: str) -> Formula | None:
        known = self.search.scene.registry.known.get(key, Symbol(key))
        solved = self.search.solver.solved.get(key)
        if solved is not None and solved.formula is not None:
            known = solved.formula
        try:
            value = self.apart.settled(known)
        except (ValueError, ArithmeticError):  # no law settles it, or none in closed form
            return None
        return None if value is None else in_printed_letters(value, {TIME: self.time})

    def number(self, name: str) -> Certified | None:
        """The certified value of a printed letter, in SI units, where it has no closed form."""
        solved = self.search.solver.solved.get(self.keys[name])
        return None if solved is None else solved.number

    def dimension(self, name: str) -> Dimension:
        """What a printed letter measures."""
        return self.search.scene.registry.quantities[self.keys[name]].dimension

    def directed(self, find: str) -> bool:
        """Whether the sign of an answer says its direction: there are words for both, or it is a vector."""
        item = next((item for item in self.search.wholes() if item.find.name == find), None)
        if item is None:
            return False
        quantity = self.search.scene.registry.quantities.get(item.asked.letter)
        said = any(item.asked.words) or (quantity is not None and any((quantity.positive, quantity.negative)))
        return said or item.asked.vector is not None

    def letter(self, name: str) -> str:
        """The letter of a printed quantity without owner and state; its name where it has none."""
        quantity = self.search.scene.registry.quantities.get(self.keys[name])
        return name if quantity is None else quantity.letter

    def at_other_states(self, name: str) -> tuple[str, ...]:
        """The printed names of the same quantity at other states, and those of which `name` is the letter without the state."""
        key = key_of(self.keys[name]) if name in self.keys else None
        found = []
        for other, text in self.keys.items():
            one = key_of(text)
            alike = key is not None and (one.kind, one.owner, one.component) == (key.kind, key.owner, key.component)
            if other != name and not one.marked and (alike or (key is None and self.letter(other) == name)):
                found.append(other)
        return tuple(found)

    def sense(self, name: str) -> str:
        """What a letter shares its positive direction with: the travel or the turn of one owner; '' where it has no direction."""
        quantity = self.search.scene.registry.quantities.get(self.keys.get(name, ""))
        if quantity is None or quantity.kind == "angle" or not (quantity.positive or quantity.negative):
            return ""
        turns = quantity.kind == "rotation" or key_of(quantity.key).turns
        return f"{quantity.owner} {'turn' if turns else quantity.component or 'travel'}"

    @cached_property
    def laws(self) -> tuple[Equality, ...]:
        """All equations that the laws write, and what the questions stand for, in printed letters."""
        asked = [item.asked for item in self.search.wholes()]
        sides: list[tuple[Formula, Formula]] = [(Symbol(one.letter), one.formula) for one in asked if not one.direct]
        sides += [(one.left, one.right) for one in self.search.scene.equations if one.relation == "="]
        return tuple(
            Equality(in_printed_letters(left, self.names), in_printed_letters(right, self.names))
            for left, right in sides
        )
