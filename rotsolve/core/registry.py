"""Registry: the quantities of a scene (kind, owner, time), what the scene says of them, and the letters that print them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from msgspec import Struct, field

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import LENGTH, Dimension
from rotsolve.core.symbols import COURSE, PHASE, SPOKEN, TIME, SymbolKey, phase_midst

SPAN = "time"  # the kind of how long a phase takes
COURSES = ("angle", "rotation", "angular_velocity", "position", "displacement", "velocity")


class SceneQuantity(Struct, frozen=True):
    """One quantity: `acceleration` of `block` in `now`.

    `positive`, `negative` are the words for the two directions ("down", "up"); empty for sizes such as a tension.
    """

    kind: str
    owner: str
    when: str
    component: str
    letter: str
    dimension: Dimension
    positive: str = ""
    negative: str = ""

    @property
    def key(self) -> str:
        return SymbolKey(self.kind, self.owner, self.component, self.when).name

    @property
    def runs(self) -> bool:
        """Whether it is a coordinate or a rate in the midst of a phase, which a textbook writes as a function of time."""
        return phase_midst(self.when) != "" and self.kind in COURSES

    @property
    def symbol(self) -> Symbol:
        return Symbol(self.key)


class Registry(Struct):
    """All quantities by key, the values that states fix, and which of them someone has asked for.

    The only mutable thing of a run: elements and laws ask for letters here while they write.
    """

    quantities: dict[str, SceneQuantity] = field(default_factory=dict)
    known: dict[str, Formula] = field(default_factory=dict)
    spoken_of: set[str] = field(default_factory=set)

    def ask(self, quantity: SceneQuantity) -> Formula:
        """The symbol of a quantity, or its value where the scene fixes it."""
        key = quantity.key
        self.quantities.setdefault(key, quantity)
        self.spoken_of.add(key)
        return self.known.get(key, Symbol(key))

    def coordinate(self, name: str) -> Symbol:
        """The printed letter of a variable of integration: x, or x₁ where a given has that name."""
        quantity = SceneQuantity(f"coordinate {name}", "1", "", "", name, LENGTH)
        self.ask(quantity)
        return quantity.symbol

    def fix(self, quantity: SceneQuantity, value: Formula) -> None:
        self.quantities.setdefault(quantity.key, quantity)
        self.known[quantity.key] = value

    def letters(
        self,
        used: Iterable[str],
        taken: frozenset[str],
        chosen: dict[str, str],
        indices: Mapping[str, str],
        placeless: frozenset[str] = frozenset(),
    ) -> dict[str, str]:
        """Printed names of the used quantities: the plain letter where it is unambiguous, else with owner or time as index.

        `chosen` holds names that the scene itself gives (an asked quantity has the name of its question); `indices` those of
        bodies, by which a₂ is the acceleration of m₂; `placeless` are kinds whose index tells an axis and then a place, which is left out.
        """
        names = dict(chosen)
        occupied = set(taken) | set(chosen.values())
        pending = [self.quantities[key] for key in used if key in self.quantities and key not in chosen]
        names |= _without_places([item for item in pending if item.kind in placeless], occupied)
        occupied |= set(names.values())
        pending = [quantity for quantity in pending if quantity.key not in names]
        plain, timed = _indices(chosen.get(TIME, TIME), indices)
        phased = _by_phase(pending, occupied)
        for way in (*map(_each, plain), _numbered, *map(_each, (*phased, *timed))):
            found = way(pending, occupied)
            names |= found
            occupied |= set(found.values())
            pending = [quantity for quantity in pending if quantity.key not in found]
        for number, quantity in enumerate(pending, 1):
            names[quantity.key] = f"{quantity.letter}_{quantity.owner}_{number}"
        return names


def _each(index: Callable[[SceneQuantity], str]) -> Callable[[list[SceneQuantity], set[str]], dict[str, str]]:
    """The names by one index, of those quantities that have one, do not share it and find it free."""

    def named(pending: list[SceneQuantity], occupied: set[str]) -> dict[str, str]:
        wanted: dict[str, list[SceneQuantity]] = {}
        for quantity in pending:
            wanted.setdefault(index(quantity), []).append(quantity)
        return {
            group[0].key: name for name, group in wanted.items() if name and len(group) == 1 and name not in occupied
        }

    return named


def _without_places(pending: list[SceneQuantity], occupied: set[str]) -> dict[str, str]:
    """I_x for I_x_cm, and I_x_plate where bodies share it: of all or none, so that one letter never means two places."""
    axes = {item.key: item.letter + "_" + item.component.partition("_")[0] for item in pending if item.component}
    shared = len(set(axes.values())) < len(axes)
    names = {item.key: axes[item.key] + f"_{item.owner}" * shared for item in pending if item.key in axes}
    return {} if len(set(names.values())) < len(names) or occupied & set(names.values()) else names


def _numbered(pending: list[SceneQuantity], occupied: set[str]) -> dict[str, str]:
    """a₁, a₂ for what one letter is in one phase after the other, where nothing else has that letter with a number."""
    names: dict[str, str] = {}
    groups: dict[str, list[SceneQuantity]] = {}
    for quantity in pending:
        groups.setdefault(quantity.letter, []).append(quantity)
    for letter, group in groups.items():
        wanted = [f"{letter}{number}" for number in range(1, len(group) + 1)]
        alike = len({(quantity.owner, quantity.component) for quantity in group}) == 1 and not group[0].component
        phases = all(PHASE in quantity.when or phase_midst(quantity.when) != "" for quantity in group)
        phases = phases and not any(quantity.runs for quantity in group)
        free = not {f"{letter}{number}" for number in range(10)} & occupied
        if alike and phases and free and len(group) > 1 and not letter[-1].isdigit():
            names |= {quantity.key: name for quantity, name in zip(group, wanted, strict=True)}
    return names


def _by_phase(pending: list[SceneQuantity], occupied: set[str]) -> tuple[Index, ...]:
    """t₂, else a₂_block, else Δt, for what is told of the second phase that a page has, or of any moment in its midst."""
    starts = dict.fromkeys(start for quantity in pending if (start := _start_of_phase(quantity.when)))
    numbers = {start: str(number) for number, start in enumerate(starts, 1)}
    # letters that a number already tells bodies by, or moments
    counted = {name[:-1] for name in occupied if name[-1:].isdigit()}

    def numbered(*owner: str) -> Index:
        def index(q: SceneQuantity) -> str:
            number = numbers.get(_start_of_phase(q.when), "")
            free = number and q.letter.isalpha() and (owner or q.letter not in counted)
            return _join(q.letter + number, q.component, *(q.owner for _ in owner)) if free else ""

        return index

    return numbered(), numbered("owner"), lambda q: f"delta_{q.letter}" if q.kind == SPAN and PHASE in q.when else ""


def _start_of_phase(when: str) -> str:
    """The state in which the phase starts of which something is told; none where it is told of a state."""
    return phase_midst(when) or (when.partition(PHASE)[0] if PHASE in when else "")


def _join(*parts: str) -> str:
    """A letter with owners and times as its index: words joined, no marks."""
    for mark, word in (*SPOKEN.items(), (COURSE, ""), ("+", " ")):  # rod+bullet: what turns as one
        parts = tuple(part.replace(mark, word) for part in parts)
    return "_".join("_".join(part.split()) for part in parts if part)


Index = Callable[[SceneQuantity], str]


def _indices(time: str, indices: Mapping[str, str]) -> tuple[tuple[Index, ...], tuple[Index, ...]]:
    """Ways to index a letter, from the plainest on, without and with a time; ω(t) for one in the midst of a phase."""

    def of_body(quantity: SceneQuantity, body: str) -> str:
        index = indices.get(body, "") if quantity.letter.isalpha() else ""
        return quantity.letter + index if index else _join(quantity.letter, quantity.component)

    plain: tuple[Index, ...] = (
        lambda q: of_body(q, q.component) + (f"({time})" if q.runs else ""),
        lambda q: _join(q.letter, q.component) + (f"({time})" if q.runs else ""),
        lambda q: of_body(q, q.owner) + (f"({time})" if q.runs else ""),
        lambda q: _join(q.letter, q.component, q.owner) + (f"({time})" if q.runs else ""),
    )
    return plain, (
        lambda q: _join(q.letter, q.component, q.when),
        lambda q: _join(q.letter, q.component, q.owner, q.when),
    )
