"""Facts on paper: forces and couples with their directions in numbers, and with the letters that a derivation prints for them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.core.facts import BodyFacts, Facts, Force
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import is_key
from rotsolve.core.vectors.heading import Vector
from rotsolve.derivation.letters import own_indices
from rotsolve.draw.paper.figure import Point, shifted_by, unit_of
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.motion.instant import Instant
from rotsolve.questions.find import question_for

if TYPE_CHECKING:
    from rotsolve.search.acting import ActingWays

SOME = 0.35  # for what nothing tells, and no picture shows to scale


class SceneFacts:
    """The facts of a scene at the state of a stage; `ways` tells which way forces act, once the scene is solved."""

    def __init__(self, stage: PlaneStage, scene: SceneEquations | None = None, ways: ActingWays | None = None) -> None:
        self.stage = stage
        self.scene = scene or SceneEquations(stage.configuration)
        self.ways = ways
        self._told: dict[tuple[Formula, str], int | None] = {}

    @cached_property
    def instant(self) -> Instant:
        return self.scene.instant(self.stage.state)

    @cached_property
    def facts(self) -> Facts:
        """All forces and couples at the state."""
        return self.scene.facts(self.stage.state)

    @cached_property
    def letters(self) -> Mapping[str, Formula]:
        """The printed letters of what is in the facts: what is asked for has the name of its question."""
        problem, registry = self.stage.configuration.problem, self.scene.registry
        used = [key for body in self.facts.bodies for item in body.acting for key in sorted(item.size.symbols())]
        used += [key for body in self.facts.bodies if body.inertia for key in sorted(body.inertia.letter.symbols())]
        chosen = dict(self._asked(frozenset(used)))
        taken = frozenset(given.name for given in problem.givens) - set(chosen.values())
        names = registry.letters(list(dict.fromkeys(used)), taken, chosen, own_indices(problem.bodies))
        return {key: Symbol(name) for key, name in names.items()}

    def _asked(self, used: frozenset[str]) -> Iterator[tuple[str, str]]:
        """The names of questions that ask for a letter of the facts and nothing else."""
        quantities = self.scene.registry.quantities
        kinds = {quantities[key].kind for key in used if key in quantities}
        owners = {quantities[key].owner for key in used if key in quantities}
        for find in self.stage.configuration.problem.finds:
            if len(find.terms) != 1 or find.formula != Symbol("#0"):
                continue
            path = find.terms[0].path
            if path.quantity not in kinds or path.owner not in owners:
                continue
            try:
                asked = question_for(find, self.scene)
            except (Unsolvable, ArithmeticError, LookupError, ValueError, AttributeError):
                continue
            if is_key(asked.letter) and asked.letter in used and not is_key(find.name):
                yield asked.letter, find.name

    def way_of(self, size: Formula, owner: str = "") -> int | None:
        """Whether what is told by a size acts the way in which that is counted, +1, against it, −1, or not at all, 0, by the answers; where
        they do not tell it by what the scene requires, as of strings, which only pull. None where nothing tells it."""
        if (size, owner) not in self._told:
            sign = self.stage.configuration.signs.sign(size) if self.ways is None else self.ways.sign(size, owner)
            if sign is None and any(need.left == size and need.right == ZERO for need in self.facts.requirements):
                sign = 1
            self._told[size, owner] = sign
        return self._told[size, owner]

    # numbers

    def number(self, formula: Formula) -> float:
        """A formula of quantities in numbers: angles as they are drawn, for what no picture shows something."""
        letters = dict(self.stage.model.letters)
        for name in formula.symbols():
            if name not in letters:
                letters[name] = self.quantity(name)
        try:
            return float(value_of(formula, letters))
        except (NotConfirmed, ArithmeticError, ValueError):
            return SOME

    def quantity(self, key: str) -> float:
        """A quantity that the scene asks of a body or contact."""
        kind = self.scene.registry.quantities.get(key)
        if kind is None or kind.kind != "angle":
            return SOME
        if kind.owner in self.stage.bodies:
            turn = self.stage.q[self.stage.model.seats[kind.owner].turn]
            return turn + self.stage.model.lean(kind.owner)
        for item in self.stage.model.acting.connections:
            if item.name == kind.owner and item.lying() in self.stage.bodies:
                seat = self.stage.model.seats[item.lying()]
                return math.atan2(self.stage.q[seat.first + 1], self.stage.q[seat.first])
            if item.name == kind.owner:
                owners = [ref.owner for ref in item.touches() if ref.owner in self.stage.bodies]
                return sum(self.stage.q[self.stage.model.seats[name].turn] for name in owners[-1:])
        return SOME

    def arrow(self, vector: Vector) -> Point:
        """A vector in numbers."""
        found = (0.0, 0.0)
        for size, heading in vector.parts:
            angle = self.number(heading.formula())
            found = shifted_by(found, (math.cos(angle), math.sin(angle)), self.number(size))
        return found

    def reference(self, host: str) -> Point:
        """Where the reference point of a body, from which its forces are told, is on the stage."""
        x, y = self.arrow(self.instant.frame(host).reference)
        return self.stage.bodies[host].spot((x, y))

    def applied(self, force: Force) -> Point:
        """Where a force acts, on the stage: the arm is told as the body stands in the facts, which is as it stands here."""
        return shifted_by(self.reference(force.body), self.arrow(force.arm))

    def acting(self, body: BodyFacts) -> Iterator[tuple[int, Force, Point, Point, int | None]]:
        """The forces on a body, as they act: each with its number, where it acts, its unit vector, and which way that is of its letter."""
        for number, force in enumerate(body.forces):
            way = self.way_of(force.size, force.owner)
            if way != 0:
                x, y = unit_of(self.arrow(force.direction))
                turned = -1.0 if way == -1 else 1.0
                yield number, force, self.applied(force), (turned * x, turned * y), way
