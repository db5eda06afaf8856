"""The pages about the code name what is there: rooms, modules, classes and tests."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("ARCHITECTURE.md", "docs/decisions.md", "docs/glossary.md")
FILE = re.compile(r"`((?:[a-z_]+/)+(?:[a-z_]+(?:\.py)?)?)`")  # `laws/table.py`, `search/friction`, `keys/`
NAMED = re.compile(r"`(rotsolve[\w.]*)(?::([\w.]+))?`")
ROOTS = (ROOT, ROOT / "rotsolve", ROOT / "rotsolve" / "algebra")


def text_of(page: str) -> str:
    return (ROOT / page).read_text(encoding="utf-8")


@pytest.mark.parametrize("page", PAGES)
def test_files_are_there(page: str) -> None:
    missing = [
        name
        for name in FILE.findall(text_of(page))
        if not any((root / name).exists() or (root / f"{name}.py").exists() for root in ROOTS)
    ]
    assert not missing


@pytest.mark.parametrize("page", PAGES)
def test_names_are_there(page: str) -> None:
    for module, name in NAMED.findall(text_of(page)):
        found: object = import_module(module)
        for part in filter(None, name.split(".")):
            assert hasattr(found, part), f"{page}: {module} has no {name}"
            found = getattr(found, part)


@pytest.mark.parametrize("page", PAGES)
def test_tests_that_are_named_are_there(page: str) -> None:
    for name in re.findall(r"tests/[\w/]+(?:\.\w+)?", text_of(page)):
        assert (ROOT / name).exists(), f"{page}: {name}"
    for name in re.findall(r"\b(test_extending_\w+\.py)", text_of(page)):
        assert (ROOT / "tests" / "extending" / name).exists(), f"{page}: {name}"


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page: str) -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", text_of(page)):
        assert "://" in target or ((ROOT / page).parent / target).exists(), target


def test_the_glossary_has_each_word_once() -> None:
    words = re.findall(r"^\| ([^|]+?) \|", text_of("docs/glossary.md"), re.MULTILINE)
    assert len(words) > 40 and len(set(words)) == len(words)
    assert words[2:] == sorted(words[2:], key=str.lower)
