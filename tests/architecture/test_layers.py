"""The architecture: imports run one way, heavy packages come late, nothing runs text, and files stay small."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[2] / "rotsolve"
FILES = sorted(PACKAGE.rglob("*.py"))
LAYERS = (  # each may import those before it, and itself; names on one line do not import each other
    ("together",),
    ("profile", "lean"),
    ("algebra",),
    ("core",),
    ("language",),
    ("elements",),
    ("confirm",),
    ("motion",),
    ("laws",),
    ("matching",),
    ("plan",),
    ("solver",),
    ("paths",),
    ("equations",),
    ("space",),
    ("questions",),
    ("search",),
    ("derivation",),
    ("draw",),
    ("page",),
    ("arrays",),
    ("solution",),
    ("scene",),
    ("solving",),
    ("seeking",),
    ("apart",),
    ("overtold",),
    ("undriven",),
    ("pipeline",),
    ("run",),
    ("drawing",),
    ("keys",),
    ("grading",),
    ("platforms",),
    ("simulation",),
    ("editor",),
    ("templates",),
    ("process",),
    ("cli",),
    ("start",),
    ("__main__",),
)
LATE: set[tuple[str, str]] = set()  # imports upwards that are allowed within functions, each one a debt
HEAVY = {"sympy", "numpy", "scipy", "mpmath", "pint", "matplotlib", "pandas", "dask", "distributed", "pyarrow"}
RUNS_TEXT = {"eval", "exec", "parse_expr", "sympify", "__import__", "compile"}
FUNCTION_LINES, FILE_LINES, FOLDER_FILES = 40, 300, 12


def name(path: Path) -> str:
    """`page.text` for rotsolve/page/text.py."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def layer(module: str) -> tuple[int, str]:
    """The layer's height, and its name: the longest that the module's name starts with."""
    fitting = [
        (height, label)
        for height, labels in enumerate(LAYERS)
        for label in labels
        if module == label or module.startswith(label + ".")
    ]
    assert fitting, f"{module} has no place in LAYERS"
    return max(fitting, key=lambda item: len(item[1]))


def typing_only(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)


def imports(node: ast.AST, *, late: bool) -> Iterator[tuple[str, int]]:
    """Imported modules with their lines: at module level, with `late` within functions too; never those for types only."""
    for child in ast.iter_child_nodes(node):
        if typing_only(child) or (not late and isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef))):
            continue
        if isinstance(child, ast.Import):
            yield from ((alias.name, child.lineno) for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            assert child.level == 0, f"line {child.lineno}: imports are absolute"
            modules = [f"{child.module}.{alias.name}" for alias in child.names if is_module(child, alias)]
            yield from ((module, child.lineno) for module in modules or [child.module or ""])
        else:
            yield from imports(child, late=late)


@cache
def is_there(path: Path) -> bool:
    return path.is_dir() or path.with_suffix(".py").is_file()


def is_module(node: ast.ImportFrom, alias: ast.alias) -> bool:
    """Whether `from package import name` means a module of the package."""
    return is_there(PACKAGE.parent.joinpath(*(node.module or "").split("."), alias.name))


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"), str(path))


@cache
def imported(path: Path, *, late: bool) -> tuple[tuple[str, int], ...]:
    """What a file imports, worked out once for all tests."""
    return tuple(imports(tree(path), late=late))


def upward(path: Path, *, late: bool) -> Iterator[tuple[str, str, int]]:
    """The imports of a file that do not go down: the two layers, and the line."""
    own = name(path)
    if not own:
        return  # the package itself hands out what all layers define
    height, label = layer(own)
    for module, line in imported(path, late=late):
        if module.startswith("rotsolve."):
            other_height, other = layer(module.removeprefix("rotsolve."))
            if other_height >= height and other != label:
                yield label, other, line


@pytest.mark.parametrize("path", FILES, ids=name)
def test_imports_run_one_way(path: Path) -> None:
    assert not list(upward(path, late=False))
    assert not [found for found in upward(path, late=True) if found[:2] not in LATE]


def test_no_debt_is_kept_longer_than_needed() -> None:
    assert {found[:2] for path in FILES for found in upward(path, late=True)} == LATE


@pytest.mark.parametrize("path", FILES, ids=name)
def test_heavy_packages_are_imported_by_the_step_that_needs_them(path: Path) -> None:
    at_start = {module.partition(".")[0]: line for module, line in imported(path, late=False)}
    arrays = {"numpy"} if name(path).startswith("arrays.") else set()  # which are imported late as a whole
    assert not (HEAVY - arrays) & at_start.keys(), at_start
    if name(path) != "page.terminal":
        ever = {module.partition(".")[0] for module, _ in imported(path, late=True)}
        assert "rich" not in ever


@pytest.mark.parametrize("path", FILES, ids=name)
def test_only_known_packages_are_imported(path: Path) -> None:
    ours = {"rotsolve", "sympy", "typer", "yaml", "rich", "flint", "msgspec", "pebble", "markdown_it"}
    ours |= {"numpy", "dask", "matplotlib", "pandas", "typst", "pygls", "lsprotocol", "distributed", "pyarrow"}
    known = ours | set(sys.stdlib_module_names)
    assert {module.partition(".")[0] for module, _ in imported(path, late=True)} <= known


@pytest.mark.parametrize("path", FILES, ids=name)
def test_nothing_runs_text(path: Path) -> None:
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Call):
            called = ast.unparse(node.func)
            assert called not in RUNS_TEXT, f"{path.name}:{node.lineno}: {called}"
            assert called.rpartition(".")[2] not in ("parse_expr", "sympify"), f"{path.name}:{node.lineno}: {called}"
            if called.rpartition(".")[0] == "yaml":
                assert called.rpartition(".")[2] not in ("load", "full_load", "unsafe_load"), (
                    f"{path.name}:{node.lineno}"
                )


@pytest.mark.parametrize("path", FILES, ids=name)
def test_modules_say_what_they_are(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert not text.strip() or ast.get_docstring(tree(path)), "no docstring"


def test_budgets(capsys: pytest.CaptureFixture[str]) -> None:
    """What is over a budget is reported; only what is far over it fails."""
    over, far = [], []
    for path in FILES:
        length = len(path.read_text(encoding="utf-8").splitlines())
        sizes = [(name(path), length, FILE_LINES)]
        for node in ast.walk(tree(path)):
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
                size = (node.end_lineno or node.lineno) - node.lineno + 1
                sizes.append((f"{name(path)}.{node.name}", size, FUNCTION_LINES))
        over += [item for item in sizes if item[1] > item[2]]
        far += [item for item in sizes if item[1] > 2 * item[2]]
    for folder in {path.parent for path in FILES}:
        count = len(list(folder.glob("*.py")))
        over += [(name(folder / "__init__.py") or "rotsolve", count, FOLDER_FILES)] if count > FOLDER_FILES else []
    with capsys.disabled():
        for what, size, budget in over:
            print(f"\n  over budget: {what} has {size} (of {budget})", end="")
    assert not far
