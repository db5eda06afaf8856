"""Names: how students are told of the things of a scene: "the bucket", "block 2", "the string A"; of contacts by the bodies that touch."""

from __future__ import annotations

import re
from functools import cached_property
from typing import Any

from rotsolve.core.writing import spoken
from rotsolve.language.problem import Problem

WORD = re.compile(r"[a-z]{3,}(?: [a-z]+)*")  # a name that is a noun, perhaps with others round it
NUMBERED = re.compile(r"([a-z]{3,}) ?(\d+)")  # block2
COUNTED = frozenset(("one", "two", "three", "four", "five", "both"))


class NameWords:
    """The names of one problem as words."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.elements: dict[str, Any] = {
            item.name: item for item in (*problem.connections, *problem.actions, *problem.events)
        }
        self.bodies = frozenset(body.name for body in problem.bodies)

    def thing(self, name: str) -> str:
        """A thing with its article: the bucket, block 2, A; of a connection whose name is no word what it is: the string A."""
        words = spoken(name)
        numbered = NUMBERED.fullmatch(words)
        if numbered:
            return f"{numbered[1]} {numbered[2]}"
        if WORD.fullmatch(words):
            return words if words in COUNTED else f"the {words}"
        kind = getattr(self.elements.get(name), "word", "")
        return f"the {spoken(kind)} {words}" if kind else words

    @cached_property
    def said(self) -> dict[str, str]:
        """The names as others write them, and as they are told; the longest first."""
        problem = self.problem
        names = [item.name for item in (*problem.bodies, *problem.surfaces, *self.elements.values())]
        names += [part.body.name for body in problem.bodies for part in (*body.parts, *body.holes)]
        return {spoken(name): self.thing(name) for name in sorted(names, key=len, reverse=True) if name}

    @cached_property
    def placed(self) -> re.Pattern[str] | None:
        """Finds names behind the words that come before one, and those with a genitive."""
        names = "|".join(map(re.escape, self.said))
        return (
            re.compile(
                rf"\b(?P<before>of|on|to|about|relative to|in|by) (?P<the>the )?(?P<name>{names})\b(?P<behind>'s)?"
            )
            if names
            else None
        )

    def worded(self, text: str) -> str:
        """A text about the scene with its names as they are told: "acceleration of block2" as acceleration of block 2."""
        return text if self.placed is None else self.placed.sub(self.told, text)

    def told(self, found: re.Match[str]) -> str:
        before, name = found["before"], found["name"]
        if before in ("in", "by") and not found["behind"]:  # in rod axes, by the rotation
            return found[0]
        return f"{before} {self.said[name]}{found['behind'] or ''}"

    def touching(self, contact: str) -> tuple[str, str] | None:
        """Both things that touch at a contact; None where it is not between two."""
        item = next((item for item in self.problem.connections if item.name == contact), None)
        owners = [*dict.fromkeys(ref.owner for ref in item.touches() if ref.owner)] if item is not None else []
        return (self.surface(owners[0]), self.surface(owners[1])) if len(owners) == 2 else None

    def surface(self, name: str) -> str:
        return f"the {name}" if name in ("ground", "ceiling") else self.thing(name)

    def at_contact(self, contact: str, does: str) -> str:
        """What a contact does, told of its bodies: the ladder does not slip on the floor."""
        both = self.touching(contact)
        return f"{both[0]} {does} on {both[1]}" if both else f"{self.thing(contact)} {does}"


def names_told(problem: Problem) -> frozenset[str]:
    """The names of a scene, as it writes them and as students are told of them, which are the same in all languages."""
    from rotsolve.page.languages.names import names_of_scene

    told = (name.removeprefix("the ") for name in NameWords(problem).said.values())
    return names_of_scene(problem) | frozenset(told)
