"""System: a scene as it moves, as differential equations: the numbers of its state with their rates on a tape, and all that they tell."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any

from msgspec import Struct

from rotsolve.algebra.flints import arb
from rotsolve.algebra.tape import ONE, Exact, Unwritable
from rotsolve.core.facts import Facts
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import TIME, is_key, key_of
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.series import BALLS, FLOATS, Arithmetic, Expansion, nearest_float
from rotsolve.simulation.tape import Scalar, SeriesTape, vanishes


class Variable(Struct, frozen=True):
    """One number of the state of motion: its name, its letter, its first value, and the place of its rate on the tape.

    An angle is counted from `origin` right angles, so that close to the vertical or level no digits are lost. The numbers of one `vector`
    have a size together.
    """

    name: str
    letter: str
    start: Exact
    rate: int
    origin: int = 0
    vector: str = ""


class System(Struct, frozen=True):
    """A scene as it moves: a tape, the numbers of its state, and all that can be told of it by the state.

    `outputs` are places on the tape by names; `letters` those of all letters of the laws.
    """

    tape: SeriesTape
    variables: tuple[Variable, ...]
    outputs: Mapping[str, int]
    letters: Mapping[str, int]


class PlanarSystem(System, frozen=True):
    """A scene of the plane as it moves, with the moment at which all its places and speeds are letters."""

    facts: Facts
    moment: Instant


class Readout:
    """Reads values on the tape of a system by the numbers of its state at a moment, in balls or in floats."""

    def __init__(self, system: System, places: Mapping[Any, int], arithmetic: Arithmetic = BALLS) -> None:
        self.letters = [system.letters[item.letter] for item in system.variables]
        self.clock, self.places = system.letters[TIME], places
        self.number: Callable[[Scalar], Scalar] = float if arithmetic is FLOATS else arb
        self.expansion = Expansion(system.tape, list(places.values()), arithmetic)

    def read(self, time: float, state: Sequence[Scalar]) -> dict[Any, Scalar]:
        letters = {place: self.number(number) for place, number in zip(self.letters, state, strict=True)}
        self.expansion.begin({**letters, self.clock: self.number(time)})
        return {name: self.expansion.lists[place][0] for name, place in self.places.items()}


def path_name(letter: str) -> str:
    """The name of a quantity as the scene language writes it: `block.velocity`, `pivot.force.x`, `string.block.tension`."""
    key = key_of(letter)
    if key.kind == "tension" and key.component:
        return f"{key.owner}.{key.component}.{key.kind}"
    return ".".join(filter(None, (key.owner, key.kind, key.component)))


def named_in_text(letter: str, registry: Registry) -> str:
    """A quantity in words."""
    return f"`{path_name(letter)}`" if letter in registry.quantities else f"value of `{letter}`"


def unnumbered(letter: str) -> NotYet:
    """A letter of the scene that would need a number."""
    return NotYet(f"`{letter}` has no number", help=f"give it one, or say --set {letter}=…")


def refusal(error: Unwritable, registry: Registry) -> NotYet:
    """What can not be simulated, by its name."""
    letter = error.letter
    if letter in registry.quantities:
        return NotYet(f"how `{path_name(letter)}` runs in time is not told")
    if letter and not is_key(letter):
        return unnumbered(letter)
    return NotYet(f"{error} is not simulated yet")


ANTIDERIVATIVES: Mapping[str, tuple[str, Exact]] = {"cos": ("sin", ONE), "sin": ("cos", -ONE)}


def told_by_others(
    tape: SeriesTape, variables: Sequence[Variable], letters: Mapping[str, int], used: Collection[str]
) -> dict[str, int]:
    """The places on the tape of those numbers of a state that others tell at any moment; what is `used` stays."""
    found: dict[str, int] = {}
    holding: set[str] = set()  # numbers by which others are told
    for item in variables:
        if item.letter in holding or item.letter in used:
            continue
        others = {other.rate: other for other in variables if other is not item and other.letter not in found}
        place = integrated(tape, item.rate, others, letters)
        if place is not None:
            start = value_at_first(tape, place, variables, letters)
            found[item.letter] = tape.sum([(place, ONE), (tape.number(item.start - start), ONE)])
            holding |= tape.letters_under(place)
    return found


def integrated(tape: SeriesTape, rate: int, others: Mapping[int, Variable], letters: Mapping[str, int]) -> int | None:
    """What has a rate Σ c f(φ) φ̇, f constant, a sine or a cosine; None where it is not of this form."""
    constant, terms = tape.combination(rate)
    if not terms or not vanishes(constant):
        return None
    parts: list[tuple[int, Exact]] = []
    for place, factor in terms.items():
        if place in others:
            parts.append((letters[others[place].letter], factor))
            continue
        found = integrated_product(tape, place, others, letters)
        if found is None:
            return None
        parts.append((found[0], factor * found[1]))
    return tape.sum(parts)


def integrated_product(
    tape: SeriesTape, place: int, others: Mapping[int, Variable], letters: Mapping[str, int]
) -> tuple[int, Exact] | None:
    """The antiderivative of cos φ φ̇ or sin φ φ̇ with its sign."""
    operation = tape.operations[place]
    for function, speed in (operation.values, operation.values[::-1]) if operation.kind == "times" else ():
        inner = tape.operations[function]
        if speed in others and inner.kind in ANTIDERIVATIVES and inner.values == (letters[others[speed].letter],):
            kind, sign = ANTIDERIVATIVES[inner.kind]
            return tape.function(kind, inner.values[0]), sign
    return None


def value_at_first(tape: SeriesTape, place: int, variables: Sequence[Variable], letters: Mapping[str, int]) -> Exact:
    """What a sum of numbers of the state, of their sines and cosines is worth at first."""
    starts = {letters[item.letter]: item.start for item in variables}
    total, terms = tape.combination(place)
    for value, factor in terms.items():
        operation = tape.operations[value]
        number = starts[value] if value in starts else starts[operation.values[0]]
        if operation.kind in ANTIDERIVATIVES:
            number = tape.constant(tape.function(operation.kind, tape.number(number)))
        total = total + factor * number
    return total


OFF = 1e-7  # part of the largest acceleration by which the two may differ
ASIDE = (0.137, -0.211, 0.093, 0.171, -0.059)  # how far from the first state the rules are held against each other
PAIRS = {"velocity": "acceleration", "angular_velocity": "angular_acceleration"}


def check_rules(system: PlanarSystem) -> None:
    """Refuse a scene whose speeds do not change as its accelerations say, at a state near the first one."""
    pairs = [(path_name(speed), place, system.letters[rate]) for speed, place, rate in dependent_speeds(system)]
    places = [place for _, *both in pairs for place in both]
    expansion = Expansion(system.tape, [*places, *(item.rate for item in system.variables)], FLOATS)
    lists = expansion.lists
    state = [nearest_float(item.start) + ASIDE[k % len(ASIDE)] for k, item in enumerate(system.variables)]
    letters = [system.letters[item.letter] for item in system.variables]
    try:
        expansion.begin({**dict(zip(letters, state, strict=True)), system.letters[TIME]: ASIDE[0]})
    except (ValueError, ZeroDivisionError, OverflowError):
        return  # beside where it starts it is no state of the scene
    for item, place in zip(system.variables, letters, strict=True):
        if place in lists:
            lists[place].append(lists[item.rate][0])
    if system.letters[TIME] in lists:
        lists[system.letters[TIME]].append(1.0)
    expansion.extend(1)
    largest = max([abs(lists[rate][0]) for *_, rate in pairs], default=0.0)
    for name, speed, rate in pairs:
        slope = lists[speed][1] if len(lists[speed]) > 1 else 0.0
        if abs(slope - lists[rate][0]) > OFF * largest:
            raise NotYet(f"the rules tell `{name}` for one moment alone, not how it goes on: not simulated yet")


def dependent_speeds(system: PlanarSystem) -> Sequence[tuple[str, int, str]]:
    """The speeds that are told by others, with their places and the letters of their accelerations."""
    found = []
    keys = {letter: key_of(letter) for letter in system.letters}
    accelerations = {(key.kind, key.owner, key.component): letter for letter, key in keys.items() if key.kind}
    own = {item.letter for item in system.variables}
    for letter, place in system.letters.items():
        key = keys[letter]
        rate = accelerations.get((PAIRS.get(key.kind, ""), key.owner, key.component))
        if rate is not None and letter not in own:
            found.append((letter, place, rate))
    return found
