"""Letters: which quantities a derivation prints, and under which names."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Integral, Product, Symbol
from rotsolve.algebra.notation.letters import DOT, INDEXED, PRIME
from rotsolve.core.derivation import Words
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import DOTTED, MARKED, SECOND, TIME, is_key, key_of
from rotsolve.derivation.drafts import Diagrams, Draft
from rotsolve.language.problem import Body, Find
from rotsolve.search.search import Search


class Letters:
    """The printed letters of the sections into which a search's derivation is drafted; some go `by` the letter of another."""

    def __init__(
        self, search: Search, drafts: Sequence[Draft], diagrams: Diagrams, by: Mapping[str, str] | None = None
    ) -> None:
        self.search = search
        self.by = by or {}
        self.drafts = drafts
        self.diagrams = diagrams
        self.problem = search.scene.configuration.problem
        self.names = self._names()

    def words(self, words: Words) -> Words:
        """Words with the letters of the printed derivation."""
        return tuple(self.printed(part) if isinstance(part, Formula) else part for part in words)

    def printed(self, formula: Formula) -> Formula:
        """A formula in printed letters, the variables of integration too."""
        return in_printed_letters(formula, self.names)

    @cached_property
    def symbols(self) -> dict[str, Formula]:
        """The printed letter of every quantity that occurs."""
        return {key: Symbol(name) for key, name in self.names.items()}

    @cached_property
    def time(self) -> str:
        """The letter of the running time: an ordinary t where nothing else is."""
        taken = {*(given.name for given in self.problem.givens), *(find.name for find in self.problem.finds)}
        return TIME if "t" in taken else "t"

    def of_find(self, find: Find) -> str:
        """The name of an answer; ω(t) where it is a function of time."""
        return f"{find.name}({self.time})" if find.runs else find.name

    def tells(self, given: str) -> bool:
        """Whether a given is the scene's own, occurs in what is printed, or in the value of such a one."""
        entry = self.search.givens[given]
        if entry.span is not None and not entry.automatic:
            return True
        found = (answered.found.formula for answered in self.search.answered)
        if given in self._occurring or any(given in formula.symbols() for formula in found if formula is not None):
            return True
        others = ((other.name, other.value) for other in self.search.givens.values())
        return any(value is not None and given in value.symbols() and self.tells(name) for name, value in others)

    # which letters occur

    @cached_property
    def in_use(self) -> set[str]:
        """Letters that an equation or an answer speaks of."""
        written = {name for draft in self.drafts for name in self._in_equations(draft)}
        return written | {name for item in self.search.answered for name in item.asked.formula.symbols()}

    @cached_property
    def _occurring(self) -> tuple[str, ...]:
        """All letters that are printed, each once, in the order in which they occur."""
        found: dict[str, None] = {}
        for draft in self.drafts:
            found |= dict.fromkeys(self._in_equations(draft))
            found |= dict.fromkeys(self.diagrams.givens(draft))
        for answered in (*self.search.answered, *(side for chosen in self.search.chosen for side in chosen.sides)):
            found |= dict.fromkeys(sorted(answered.asked.formula.symbols()))
        for draft in self.drafts:
            found |= dict.fromkeys(self._in_remarks(draft))
        return tuple(found)

    def _in_remarks(self, draft: Draft) -> Iterator[str]:
        """Letters of what is said beside the laws of a section."""
        laws = (self.search.planner.pool[index] for index in draft.laws)
        for part in (part for law in laws for part in law.remark if isinstance(part, Formula)):
            yield from sorted(part.symbols())

    def _in_equations(self, draft: Draft) -> Iterator[str]:
        """Letters of the laws and steps of a section."""
        for left, right in self._equalities(draft):
            yield from sorted(left.symbols() | right.symbols())
            yield from sorted(bound(left) | bound(right))

    def _equalities(self, draft: Draft) -> Iterator[tuple[Formula, Formula]]:
        """Both sides of the laws of a section, then of its steps."""
        pool = self.search.planner.pool
        yield from ((pool[index].left, pool[index].right) for index in draft.laws)
        yield from ((one.left, one.right) for step in draft.steps for one in step.chain)

    # their names

    def _names(self) -> dict[str, str]:
        """Printed names of all quantities that occur."""
        chosen = self._of_answers()
        taken = frozenset(given.name for given in self.problem.givens)
        if self.time != TIME:
            chosen[TIME] = self.time
        others = [key for key in self._occurring if key not in chosen]
        chosen |= self._running(others, taken | set(chosen.values()), chosen.get(TIME, TIME))
        indices = own_indices(self.problem.bodies)
        taken -= set(chosen.values())
        occurring = tuple(key for key in self._occurring if key not in self.by)
        names = self.search.scene.registry.letters(occurring, taken, chosen, indices, self._placeless)
        for goes, stays in self.by.items():
            names[goes] = names.get(stays, stays)
        return names | names_with_dots(self._occurring, names)

    @property
    def _placeless(self) -> frozenset[str]:
        """Moments of inertia in space whose place goes without saying, since none is taken from one axis to another."""
        laws = (self.search.planner.pool[index].law for draft in self.drafts for index in draft.laws)
        return frozenset(("inertia",)) if self.problem.space and not any(law.shifts for law in laws) else frozenset()

    def _of_answers(self) -> dict[str, str]:
        """The names that the scene gives to what it asks for; a component that was asked before keeps that name."""
        chosen: dict[str, str] = {}
        for asked in (item.asked for item in self.search.answered):
            if not asked.whole and not is_key(asked.find.name):  # else it keeps its quantity's letter
                chosen.setdefault(asked.letter, self.of_find(asked.find))
        taken = frozenset(given.name for given in self.problem.givens)
        every = [part.asked for item in self.search.answered for part in (item, *item.parts)]
        for asked in (item for item in every if item.whole and not item.direct):
            twin = next((item for item in self.search.wholes() if item.asked.same_as(asked)), None)
            if twin is not None:
                chosen.setdefault(asked.letter, twin.asked.find.name)
                continue
            name = asked.find.name
            while name in taken | set(chosen.values()):
                name += "_"
            chosen.setdefault(asked.letter, name)
        return chosen

    def _running(self, used: Iterable[str], taken: frozenset[str], time: str) -> dict[str, str]:
        """Letters for what runs through a phase, the same in every phase: ω(t), or plain ω where it is summed over."""
        quantities, over = self.search.scene.registry.quantities, self._integrated()
        running = [item for key in used if (item := quantities.get(key)) is not None and item.runs]
        owners: dict[str, set[tuple[str, str, str]]] = {}
        for item in running:
            owners.setdefault(item.letter, set()).add((item.kind, item.owner, item.component))
        names = {}
        for item in running:
            alone = len(owners[item.letter]) == 1
            plain = "_".join(filter(None, (item.letter, item.component, "" if alone else item.owner)))
            if item.key in over:
                names[item.key] = plain if plain not in taken else plain + PRIME
                continue
            places = {key for key, inside in over.items() if item.key in inside} - {TIME}
            way = quantities.get(places.pop()) if len(places) == 1 else None
            names[item.key] = f"{plain}({time if way is None else way.letter})"
        return names

    def _integrated(self) -> dict[str, set[str]]:
        """Variables of integration, each with the letters of what is summed over it."""
        found: dict[str, set[str]] = {}
        sides = (side for draft in self.drafts for pair in self._equalities(draft) for side in pair)
        for node in (node for side in sides for node in side.walk(Integral)):
            if isinstance(node, Integral):
                found.setdefault(node.variable, set()).update(node.integrand.symbols())
        return found


def names_with_dots(used: Collection[str], names: Mapping[str, str]) -> dict[str, str]:
    """The names of rates of coordinates, and of the rates of these: those of the coordinates with a dot or two."""
    found = {}
    for name in used:
        key = key_of(name)
        own = replace(key, kind=key.kind.removeprefix(DOTTED).removeprefix(DOTTED))
        if own != key and own.name in names:
            found[name] = names[own.name] + DOT * key.kind.count(DOTTED)
        word = key.kind.removeprefix(SECOND)
        letter = QUANTITIES[word].letter if word != key.kind and name in names else ""
        if letter and names[name].startswith(letter + MARKED):  # ω̇ of the laws in space, unless a question calls it α
            found[name] = letter + names[name].removeprefix(letter + MARKED) + DOT
    return found


def own_indices(bodies: Iterable[Body]) -> dict[str, str]:
    """The index that the letters of a body have in common, as m₂ and R₂, where no other body has it."""
    found: dict[str, str] = {}
    for body in bodies:
        sizes = [getattr(body.shape, name, None) for name in (body.shape.declared if body.shape else ())]
        letters = [item.name for item in (body.mass, body.inertia, *sizes) if isinstance(item, Symbol)]
        indices = {match[2] for letter in letters if (match := INDEXED.fullmatch(letter))}
        if len(indices) == 1:
            found[body.name] = indices.pop()
    return {name: index for name, index in found.items() if list(found.values()).count(index) == 1}


def listed(names: Iterable[str]) -> Words:
    """Names of answers with commas between."""
    return tuple(part for name in names for part in (", ", Symbol(name)))[1:]


def in_printed_letters(formula: Formula, names: Mapping[str, str]) -> Formula:
    """A formula with its letters renamed, the variables of integration too."""
    if names.keys().isdisjoint(formula.symbols()) and not formula.holds(Integral):
        return formula

    def relabelled(node: Formula) -> Formula:
        if isinstance(node, Symbol):
            return Symbol(names[node.name]) if node.name in names else node
        old = node.children()
        new = tuple(map(relabelled, old))
        if any(before is not after for before, after in zip(old, new, strict=True)):
            node = (
                Product(new) if isinstance(node, Product) else node.with_children(new)
            )  # ½ (2 m) v² stays as it is written
        if isinstance(node, Integral) and node.variable in names:
            return Integral(node.integrand, names[node.variable], node.lower, node.upper)
        return node

    return relabelled(formula)


def multiple_in(factors: Sequence[Formula]) -> Formula | None:
    """The number of a multiple among factors, which stays as it is written there: 2 of ½ (2 m) v²."""
    return next((factor.factors[0] for factor in factors if isinstance(factor, Product)), None)


def bound(formula: Formula) -> set[str]:
    """Letters inside integrals, bound ones too."""
    inside = [node for node in formula.walk(Integral) if isinstance(node, Integral)]
    return {name for node in inside for name in {node.variable, *node.integrand.symbols()}}
