"""Moments: what all questions about one instant start from."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet


class Moment(Struct, frozen=True):
    """An instant with its facts, which are worked out when a question needs them."""

    instant: Instant
    facts: Callable[[], Facts]

    def body(self, name: str) -> BodyFacts:
        found = self.facts().body(self.instant.host(name))
        if found is None:
            raise NotYet(f"`{name}` is not there{self._moment()}")
        return found

    def _moment(self) -> str:
        return f" at `{self.instant.state}`" if self.instant.state else ""

    def _turned_by(self, owner: str) -> str:
        """The body on which a connection or action acts."""
        refs = [
            ref
            for item in self.instant.configuration.acting(self.instant.state)
            if item.name == owner
            for ref in item.touches()
            if ref.owner in self.instant.configuration.bodies
        ]
        return refs[-1].owner if refs else ""
