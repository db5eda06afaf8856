"""Guides: whatever outside the scene moves a body as is prescribed, with a force and a couple of unknown size."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula
from rotsolve.core.drive import TRAVELLING, TURNING
from rotsolve.core.facts import Couple, Force, signed
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, unit
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.language.problem import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant


class Guide(Connection, frozen=True):
    """What a body's own keys `velocity`, `angle`, … stand for; no scene writes it as a connection."""

    word = "guide"
    quantities = ("force", "torque")
    pointed = ("guided",)

    guided: tuple[PointRef, ...] = ()
    motions: tuple[tuple[str, str, Formula], ...] = ()

    def prescribes(self) -> Iterator[tuple[str, str, str, Formula]]:
        for word, component, function in self.motions:
            yield self.guided[0].owner, word, component, function

    def pace(self, configuration: Configuration, state: str) -> str:
        paces = [drive.pace for drive in configuration.drives(self.guided[0].owner, state)]
        return max(paces, key=("constant", "time").index)

    def facts(self, instant: Instant) -> Iterator[Fact]:
        """A couple where its turning is prescribed, a force at the centre of mass where its travel is."""
        name = instant.host(self.guided[0].owner)
        words = {word for word, _, _ in self.motions}
        if words & set(TURNING):
            size = instant.ask("torque", self.name, when=instant.span(name), words=instant.turn_words(name))
            yield Couple(self.name, "drive", name, signed(size, instant.sense(name)), ("driving torque ", size))
        if words & set(TRAVELLING):
            for component, direction, said in self._ways(name, instant):
                size = instant.ask("force", self.name, when=instant.span(name), component=component)
                words_ = ("driving force ", size, f", {said}")
                yield Force(self.name, "drive", name, size, unit(direction), instant.frame(name).cm, words_)

    def _ways(self, name: str, instant: Instant) -> Iterator[tuple[str, Heading, str]]:
        """Along the body's line, or right and up."""
        line = instant.configuration.line(name, instant.state)
        if line is not None:
            yield "", line[0], line[1]
        else:
            yield from (("x", RIGHT, "right"), ("y", UP, "up"))


def guide(body: Body) -> Guide:
    """The guide of a body whose motion is prescribed."""
    return Guide(f"drive of {body.name}", (PointRef(body.name, span=body.span),), body.moved)
