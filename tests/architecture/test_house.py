"""The house: no circle of imports, not too deep, and names that stand for one thing. `python benchmarks/house.py --list` tells more."""

from __future__ import annotations

from pathlib import Path

import pytest

import house

MOST_CRUMBS, MOST_SHARED_NAMES, DEEPEST = 25, 60, 30


@pytest.fixture(scope="module")
def rooms() -> house.House:
    return house.House()


def test_no_module_imports_itself_by_way_of_others(rooms: house.House) -> None:
    """Imports for type checkers count."""
    assert not house.circle(rooms.graph(house.TOP, house.TYPES))


def test_imports_are_not_deep(rooms: house.House) -> None:
    chain = house.longest_chain(rooms.graph(house.TOP))
    assert len(chain) <= DEEPEST, " → ".join(chain)


def test_a_class_name_means_one_thing(rooms: house.House) -> None:
    assert house.several(rooms.classes) == {}


def test_function_names_are_rarely_shared(rooms: house.House) -> None:
    shared = house.several(rooms.functions)
    assert len(shared) <= MOST_SHARED_NAMES, shared


def test_a_file_is_an_idea(rooms: house.House) -> None:
    assert len(rooms.crumbs) <= MOST_CRUMBS, rooms.crumbs


def package(folder: Path, **files: str) -> house.House:
    """A package of a few files, to see that the figures can be wrong."""
    (folder / "rotsolve").mkdir()
    for name, text in files.items():
        (folder / "rotsolve" / f"{name}.py").write_text(text, encoding="utf-8")
    return house.House(folder)


def test_a_circle_for_types_alone_is_found(tmp_path: Path) -> None:
    for_types = "if TYPE_CHECKING:\n    from rotsolve.a import A\n"
    found = package(tmp_path, a="from rotsolve.b import B\n", b=f"from rotsolve import c\n{for_types}", c="")
    assert house.circle(found.graph(house.TOP)) == frozenset()
    assert house.circle(found.graph(house.TOP, house.TYPES)) == {"rotsolve.a", "rotsolve.b"}
    assert house.longest_chain(found.graph(house.TOP)) == ["rotsolve.a", "rotsolve.b", "rotsolve.c"]


def test_late_imports_and_shared_names_are_found(tmp_path: Path) -> None:
    late = "def f():\n    import rotsolve.b\n    class Inner: pass\n"
    found = package(tmp_path, a=f"{late}class A: pass\n", b="def f(): pass\nclass A: pass\n")
    assert found.graph(house.LATE)["rotsolve.a"] == {"rotsolve.b"}
    assert house.several(found.functions) == {"f": ["rotsolve.a", "rotsolve.b"]}
    assert list(house.several(found.classes)) == ["A"]
    assert house.figures(found)["files under 40 lines"] == 2
