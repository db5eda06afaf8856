"""Shrink: the smallest scene that still shows a fault, by leaving out one entry after the other."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator

from trials.scene import Scene

Path = tuple[str, ...]


def shrunk(scene: Scene, faulty: Callable[[Scene], bool], tries: int = 60) -> Scene:
    """The scene without all that can be left out one by one while it stays faulty."""
    again = True
    while again and tries > 0:
        again = False
        for path in entries(scene):
            smaller = without(scene, path)
            tries -= 1
            if tries > 0 and faulty(smaller):
                scene, again = smaller, True
                break
    return scene


def entries(scene: Scene) -> Iterator[Path]:
    """Everything that can be left out: questions first, then actions, states' lines and the rest."""
    for section in ("find", "actions", "states", "connections", "bodies", "given", "surfaces", "events"):
        part = scene.get(section)
        if not isinstance(part, dict):
            continue
        for name in list(part):
            yield (section, name)
            if section in ("states", "bodies") and isinstance(part[name], dict):
                for word in part[name]:
                    yield (section, name, word)


def without(scene: Scene, path: Path) -> Scene:
    result = copy.deepcopy(scene)
    part = result
    for name in path[:-1]:
        part = part[name]
    del part[path[-1]]
    return {name: part for name, part in result.items() if part != {}}
