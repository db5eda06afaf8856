"""Scenes: the files that the words of a command stand for: names, folders, and patterns that the shell has left as they are.

A name that is a file, as nearly every one, needs neither `pathlib` nor `glob`: these take a fiftieth of a cold run to load.
"""

from __future__ import annotations

import os

SUFFIXES = (".yaml", ".yml")
PIPED = "-"


def scenes(names: tuple[str, ...]) -> tuple[str, ...]:
    """Every file once, in the order of the names; in the place of a folder or pattern the scenes in it, in the order of their paths."""
    return tuple(dict.fromkeys(file for name in names for file in meant(name)))


def meant(name: str) -> list[str]:
    """What one name stands for; itself where it stands for nothing, so that the message can say so."""
    if name == PIPED or os.path.isfile(name):
        return [name]
    if os.path.isdir(name):
        return within(name) or [name]
    return fitting(name) or [name]


def fitting(pattern: str) -> list[str]:
    """The scenes that fit a pattern, and those of the folders that do; none where it is an ordinary name."""
    from glob import glob, has_magic
    from pathlib import Path

    found = sorted(map(Path, glob(pattern, recursive=True))) if has_magic(pattern) else []
    return [file for path in found for file in (within(str(path)) if path.is_dir() else [str(path)])]


def within(name: str) -> list[str]:
    """The scenes of a folder and of the folders in it."""
    from pathlib import Path

    folder = Path(name)
    return sorted(str(path) for path in folder.rglob("*") if path.suffix in SUFFIXES and path.is_file())
