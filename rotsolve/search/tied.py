"""Tied: which of what rubs moves with what, as strings, joints and gears tie it, and the ways in which all of it may begin to move."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product

from msgspec import Struct

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula
from rotsolve.core.symbols import RATES, of_kinds
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.laws.groups import by_one, one_motion
from rotsolve.motion.instant import Instant
from rotsolve.motion.rubs import Rub

MOST_WAYS = 81  # in which several may stick and slip that are tried: all of four
Unit = Mapping[Rub, int]  # what slips only together, by its senses when the first slips along its own


class Tied(Struct, frozen=True):
    """A group of what rubs in a phase, in the scene in which all of it slips."""

    group: Sequence[Rub]
    scene: SceneEquations
    signs: SignOracle

    @property
    def instant(self) -> Instant:
        return self.scene.instant(self.group[0].state, virtual=True)

    def ties(self) -> list[Formula]:
        """What rules say to be zero, of speeds."""
        rules = self.scene.facts(self.group[0].state, virtual=True).rules
        return [first - second for rule in rules for first, second in [rule.velocity]]

    def in_one_motion(self) -> bool:
        """Whether the speeds of all that rubs follow from one, by strings and joints: of two blocks on a spring each has its own."""
        instant = self.instant
        return by_one_of([rub.drift(instant) or ZERO for rub in self.group], self.ties()) is not None

    def senses(self, way: int) -> dict[str, int]:
        """The senses in which all of a group move when the first goes one way, as the rules make the others go with it."""
        rules = list(self.scene.facts(self.group[0].state, virtual=True).rules)
        instant = self.instant
        speeds = {rub.key: rub.drift(instant) for rub in self.group}
        sides = [side for rule in rules for side in rule.velocity]
        sides += [speed for speed in speeds.values() if speed is not None]
        rates = of_kinds({name for side in sides for name in side.symbols()}, RATES)
        allowed = one_motion(rates, rules) or {}
        senses = {}
        for rub in self.group:
            slip, speed = rub.rate(instant), speeds[rub.key]
            if slip is not None and simplify(slip.substitute(allowed)) == ZERO:
                # the rules keep it at rest whichever way the rest moves: how much it grips stays open
                senses[rub.key] = 0
                continue
            senses[rub.key] = self.way_of(speed.substitute(allowed) if speed is not None else ONE)
        first = next((sense for sense in senses.values() if sense), 1)
        return {key: sense * first * way for key, sense in senses.items()}

    def way_of(self, speed: Formula) -> int:
        """The sign of a speed where the one that all hang on is positive."""
        rate = speed.substitute(dict.fromkeys(of_kinds(speed.symbols(), RATES), ONE))
        return -1 if self.signs.taken(rate) == -1 else 1

    def units(self) -> list[Unit]:
        """What slips only together: a wheel's axle and the brake on it, blocks that a string ties."""
        instant, ties = self.instant, self.ties()
        units: list[dict[Rub, int]] = []
        slips = {rub: rub.rate(instant) or ZERO for rub in self.group}
        for rub in self.group:
            for unit in units:
                first = next(iter(unit))
                sense = self.together(slips[first], slips[rub], ties)
                if sense:
                    unit[rub] = sense
                    break
            else:
                units.append({rub: 1})
        return list(units)

    def together(self, one: Formula, other: Formula, ties: list[Formula]) -> int:
        """The sense in which one slips when the other slips along its own; 0 where each may slip alone, or the rules keep one at rest."""
        solved = by_one_of([one, other], ties)
        if solved is None:
            return 0
        speeds = [simplify(speed.substitute(solved)) for speed in (one, other)]
        return 0 if ZERO in speeds else self.way_of(speeds[0]) * self.way_of(speeds[1])


def by_one_of(speeds: Sequence[Formula], ties: list[Formula]) -> dict[str, Formula] | None:
    """All that is tied to some speeds in terms of one rate; None where they hang on several."""
    tied = of_kinds({name for speed in speeds for name in speed.symbols()}, RATES)
    if len(tied) < 2:
        return {}
    reached = set(tied)
    while len(
        more := reached.union(*(of_kinds(tie.symbols(), RATES) for tie in ties if tie.symbols() & reached))
    ) > len(reached):
        reached = more
    return by_one(of_kinds(reached, RATES), ties)


def ways_of(units: Sequence[Unit]) -> list[dict[Rub, int]] | None:
    """The ways in which several may stick (0) and slip (1, -1), those in which the fewest slip first; None where these are too many."""
    if 3 ** len(units) > MOST_WAYS:
        return None
    ways = sorted(product((0, 1, -1), repeat=len(units)), key=lambda way: sum(map(abs, way)))
    return [
        {rub: sense * own for unit, sense in zip(units, way, strict=True) for rub, own in unit.items()} for way in ways
    ]
