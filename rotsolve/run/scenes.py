"""Scenes: the files that the words of a command stand for: names, folders, and patterns that the shell has left as they are."""

from __future__ import annotations

from glob import glob, has_magic
from pathlib import Path

SUFFIXES = (".yaml", ".yml")
PIPED = "-"


def scenes(names: tuple[str, ...]) -> tuple[str, ...]:
    """Every file once, in the order of the names; in the place of a folder or pattern the scenes in it, in the order of their paths."""
    return tuple(dict.fromkeys(file for name in names for file in meant(name)))


def meant(name: str) -> list[str]:
    """What one name stands for; itself where it stands for nothing, so that the message can say so."""
    path = Path(name)
    if name == PIPED or path.is_file():
        return [name]
    if path.is_dir():
        return within(path) or [name]
    if has_magic(name):
        found = sorted(map(Path, glob(name, recursive=True)))
        return [file for item in found for file in (within(item) if item.is_dir() else [str(item)])] or [name]
    return [name]


def within(folder: Path) -> list[str]:
    """The scenes of a folder and of the folders in it."""
    return sorted(str(path) for path in folder.rglob("*") if path.suffix in SUFFIXES and path.is_file())
