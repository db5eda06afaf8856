"""The house in figures: its size, its crumbs, how deep imports go, whether they run in a circle, and names that mean several things.

`python benchmarks/house.py` prints them for the package, `--list` with the names behind the figures, `--root FOLDER` for another copy.
tests/architecture holds the package to them.
"""

from __future__ import annotations

import argparse
import ast
from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
TOP, LATE, TYPES = "top", "late", "types"  # at module level, within a function, for type checkers alone
CRUMB = 40  # a file of fewer lines is hardly an idea of its own
Graph = Mapping[str, frozenset[str]]


class Import(NamedTuple):
    """One import: the module, its line, and whether it is TOP, LATE or for TYPES."""

    module: str
    line: int
    kind: str


class House:
    """The modules of a package, read but never run."""

    def __init__(self, root: Path = ROOT) -> None:
        self.package = root / "rotsolve"
        self.paths = {self.name(path): path for path in sorted(self.package.rglob("*.py"))}

    def name(self, path: Path) -> str:
        """`rotsolve.solver.step` for rotsolve/solver/step.py, `rotsolve.solver` for its `__init__.py`."""
        parts = path.relative_to(self.package.parent).with_suffix("").parts
        return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)

    @cached_property
    def texts(self) -> dict[str, str]:
        return {name: path.read_text(encoding="utf-8") for name, path in self.paths.items()}

    @cached_property
    def trees(self) -> dict[str, ast.Module]:
        return {name: ast.parse(text) for name, text in self.texts.items()}

    @cached_property
    def lengths(self) -> dict[str, int]:
        """Lines of each file."""
        return {name: len(text.splitlines()) for name, text in self.texts.items()}

    @cached_property
    def crumbs(self) -> list[str]:
        """Files of fewer than 40 lines, save those that only make a folder a package or a command."""
        made = ("__init__.py", "__main__.py")
        return [name for name, lines in self.lengths.items() if lines < CRUMB and self.paths[name].name not in made]

    @cached_property
    def imports(self) -> dict[str, list[Import]]:
        return {name: list(self._imports(tree, TOP)) for name, tree in self.trees.items()}

    def _imports(self, node: ast.AST, kind: str) -> Iterator[Import]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.Import):
                yield from (Import(alias.name, child.lineno, kind) for alias in child.names)
            elif isinstance(child, ast.ImportFrom):
                assert child.module and child.level == 0, f"line {child.lineno}: imports are absolute"
                whole = [f"{child.module}.{alias.name}" for alias in child.names]
                named = [module for module in whole if module in self.paths]
                yield from (Import(module, child.lineno, kind) for module in named or [child.module])
            else:
                yield from self._imports(child, kind_within(child, kind))

    def graph(self, *kinds: str) -> Graph:
        """Which modules of the package each one imports, by imports of some kinds."""
        return {
            name: frozenset(one.module for one in found if one.kind in kinds and one.module in self.paths) - {name}
            for name, found in self.imports.items()
        }

    @cached_property
    def classes(self) -> dict[str, list[str]]:
        """The modules that define each class name."""
        return self._defined(ast.ClassDef)

    @cached_property
    def functions(self) -> dict[str, list[str]]:
        """The modules that define each function name at module level, but for Python's own such as `__getattr__`."""
        return {name: modules for name, modules in self._defined(ast.FunctionDef).items() if not name.startswith("__")}

    def _defined(self, sort: type[ast.ClassDef] | type[ast.FunctionDef]) -> dict[str, list[str]]:
        found: dict[str, list[str]] = defaultdict(list)
        for name, tree in self.trees.items():
            for own in {node.name for node in tree.body if isinstance(node, sort)}:
                found[own].append(name)
        return dict(found)


def kind_within(node: ast.AST, kind: str) -> str:
    """The kind of an import that stands in a node."""
    if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
        return TYPES
    return LATE if kind == TOP and isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) else kind


def several(names: Mapping[str, list[str]]) -> dict[str, list[str]]:
    """The names that stand in more than one module."""
    return {name: modules for name, modules in sorted(names.items()) if len(modules) > 1}


def longest_chain(graph: Graph) -> list[str]:
    """The longest chain of modules each of which imports the next; the graph has no circle."""
    chains: dict[str, list[str]] = {}

    def chain(name: str) -> list[str]:
        if name not in chains:
            chains[name] = [name, *max((chain(other) for other in sorted(graph[name])), key=len, default=[])]
        return chains[name]

    return max(map(chain, graph), key=len)


def circle(graph: Graph) -> frozenset[str]:
    """The largest set of modules that all import each other by way of others; empty where there is none."""
    behind = {name: reached(name, graph) for name in graph}
    return max(
        (frozenset(other for other in found if name in behind[other]) for name, found in behind.items()), key=len
    )


def reached(name: str, graph: Graph) -> set[str]:
    """All modules that a module imports, by way of others too."""
    found: set[str] = set()
    pending = [name]
    while pending:
        fresh = graph[pending.pop()] - found
        found |= fresh
        pending.extend(fresh)
    return found


def figures(house: House) -> dict[str, int]:
    """All figures by what they count."""
    running, whole = house.graph(TOP), house.graph(TOP, LATE, TYPES)
    return {
        "lines": sum(house.lengths.values()),
        "files": len(house.paths),
        "files under 40 lines": len(house.crumbs),
        "depth of imports at start": 0 if circle(running) else len(longest_chain(running)),
        "depth of imports, late ones and those for types too": 0 if circle(whole) else len(longest_chain(whole)),
        "modules in a circle of imports, types counted": len(circle(house.graph(TOP, TYPES))),
        "modules in a circle of imports, late ones too": len(circle(whole)),
        "class names that stand twice": len(several(house.classes)),
        "function names in two modules": len(several(house.functions)),
    }


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=ROOT, help="the folder that holds rotsolve/")
    parser.add_argument("--list", action="store_true", help="the names behind the figures as well")
    asked = parser.parse_args()
    house = House(asked.root)
    for name, number in figures(house).items():
        print(f"{number:6}  {name}")
    if asked.list:
        for title, found in (("class", several(house.classes)), ("def", several(house.functions))):
            print(*(f"  {title} {name}: {', '.join(modules)}" for name, modules in found.items()), sep="\n")
        for module in house.crumbs:
            print(f"  {house.lengths[module]:3} lines: {module}")
        graph = house.graph(TOP)
        print("  deepest:", " → ".join(longest_chain(graph) if not circle(graph) else []))
        print("  circle:", *sorted(circle(house.graph(TOP, LATE, TYPES))))


if __name__ == "__main__":
    main()
