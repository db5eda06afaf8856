"""Parts: a composition as it grows: bodies, what holds and joins them, and how each can move."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import Any

from compositions.body import KINDS, Kind
from compositions.letters import Letters
from trials.scene import Scene

LINE, TURN, SWING, PLANE, ROLL, ARC = "line", "turn", "swing", "plane", "roll", "arc"  # ways of moving


@dataclass
class Composition:
    """A scene as it grows; `ways` says how each body moves."""

    chance: random.Random
    letters: Letters = field(init=False)
    kinds: dict[str, Kind] = field(default_factory=dict)
    ways: dict[str, str] = field(default_factory=dict)
    bodies: dict[str, dict[str, Any]] = field(default_factory=dict)
    sections: dict[str, dict[str, Any]] = field(default_factory=dict)
    loose: list[str] = field(default_factory=list)  # bodies that fly towards the others
    tied: list[str] = field(default_factory=list)  # bodies whose speed follows from that of the first, or that rest
    riders: list[str] = field(default_factory=list)  # beads that slide freely along the first body
    gripped: list[str] = field(
        default_factory=list
    )  # round bodies that roll, so that their turn follows from their travel

    def __post_init__(self) -> None:
        self.letters = Letters(self.chance)

    def add(self, kind: Kind, name: str) -> None:
        self.kinds[name] = kind
        self.bodies[name] = kind.entry(self.letters, name)

    def second(self, *words: str) -> None:
        """A second body, of one of the kinds."""
        word = self.pick(*words)
        self.add(next(kind for kind in KINDS if kind.word == word), "two")

    def put(self, section: str, name: str, entry: Any) -> None:
        self.sections.setdefault(section, {})[name] = entry

    def pick(self, *options: str) -> str:
        return self.chance.choice(options)

    def often(self, share: float) -> bool:
        return self.chance.random() < share

    def place(self, name: str) -> str:
        """A point of a body."""
        return self.chance.choice(self.places(name))

    def places(self, name: str) -> list[str]:
        """All points of a body."""
        return self.kinds[name].places(name, self.bodies[name])

    def middle(self, name: str) -> str:
        """Its centre, or itself where it is a particle."""
        return f"{name}.center" if self.kinds[name].rims else name

    def friction(self) -> str:
        """What a rough contact says: a coefficient, `any` or `none`."""
        return self.letters.new("mu", "") if self.often(0.6) else self.pick("any", "none")

    def holds_fast(self, name: str) -> None:
        """A body that what holds it lets roll at most: no turn of its own is told, or it rests."""
        (self.gripped if self.ways[name] == ROLL else self.tied).append(name)

    def has(self, word: str) -> list[str]:
        """The names of connections of a kind."""
        return [name for name, entry in self.sections.get("connections", {}).items() if word in entry]

    def scene(self, title: str) -> Scene:
        order = ("surfaces", "connections", "actions", "states", "events", "find")
        rest = {section: self.sections[section] for section in order if section in self.sections}
        surfaces = {"surfaces": rest.pop("surfaces")} if "surfaces" in rest else {}
        plane = {"plane": "horizontal"} if self.sections.get("plane") else {}
        return {"title": title, **plane, "given": self.letters.given, **surfaces, "bodies": self.bodies, **rest}
