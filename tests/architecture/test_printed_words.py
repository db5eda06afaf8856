"""What is printed is for readers: no code outside the rooms that print decides by it, compares it, or takes it apart."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import rotsolve

PACKAGE = Path(rotsolve.__file__).parent
PRINTING = ("page", "cli", "run")  # rooms that set words in lines and columns
READING = (
    "scene",
    "language/words.py",
    "grading/reading",
    "grading/course",
)  # their words are those that somebody else wrote
FILES = sorted(
    path
    for path in PACKAGE.rglob("*.py")
    if not any(path.relative_to(PACKAGE).as_posix().startswith(room) for room in (*PRINTING, *READING))
)
PRINTED = {"label", "words", "otherwise", "kept", "remark", "remarks", "positive", "noun", "said"}
DISSECTING = {
    *(
        "startswith",
        "endswith",
        "removeprefix",
        "removesuffix",
        "partition",
        "rpartition",
        "split",
        "rsplit",
        "splitlines",
    ),
    *("strip", "lstrip", "rstrip", "find", "rfind", "index", "count", "lower", "casefold", "isdigit", "isalpha"),
}
PATTERNS = {"match", "search", "fullmatch", "findall", "finditer", "sub"}


def is_printed(node: ast.AST, names: set[str]) -> bool:
    """Whether an expression is printed text, or a part of it: `law.label`, `force.words[0]`, `str(need.words[-1])`, or a name for one."""
    match node:
        case ast.Attribute(attr=attr):
            return attr in PRINTED and not (isinstance(node.value, ast.Name) and node.value.id in ("self", "cls"))
        case ast.Name(id=name):
            return name in names
        case ast.Subscript(value=value):
            return is_printed(value, names)
        case ast.Call(func=ast.Name(id="str"), args=[value]):
            return is_printed(value, names)
        case ast.Call(func=ast.Attribute(attr=attr, value=value)):
            return attr in DISSECTING and is_printed(value, names)
        case ast.JoinedStr(values=values):
            return any(isinstance(part, ast.FormattedValue) and is_printed(part.value, names) for part in values)
    return False


def is_empty(node: ast.AST) -> bool:
    return (isinstance(node, ast.Constant) and node.value in ("", None)) or (
        isinstance(node, ast.Tuple) and not node.elts
    )


def named(scope: ast.AST) -> set[str]:
    """Names that stand for printed text within a function."""
    names: set[str] = set()
    for node in ast.walk(scope):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and is_printed(node.value, names):
            names |= {target.id for target in node.targets if isinstance(target, ast.Name)}
        if (
            isinstance(node, ast.comprehension | ast.For)
            and is_printed(node.iter, names)
            and isinstance(node.target, ast.Name)
        ):
            names.add(node.target.id)
    return names


def readings(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Where printed text is read, by line."""
    scopes = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.Lambda)] or [tree]
    for scope in (tree, *scopes):
        names = named(scope) if scope is not tree else set[str]()
        for node in ast.walk(scope):
            match node:
                case ast.Call(func=ast.Attribute(attr=attr, value=value)) if attr in DISSECTING:
                    read = is_printed(value, names)
                case ast.Call(func=ast.Attribute(attr=attr), args=args) if attr in PATTERNS:
                    read = any(is_printed(value, names) for value in args)
                case ast.Compare(left=left, comparators=others):
                    sides = [
                        part
                        for side in (left, *others)
                        for part in (side.elts if isinstance(side, ast.Tuple) else [side])
                    ]
                    read = any(is_printed(side, names) for side in sides) and not any(map(is_empty, (left, *others)))
                case ast.Match(subject=subject):
                    read = is_printed(subject, names)
                case _:
                    read = False
            if read:
                yield node.lineno, ast.unparse(node)[:120]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(PACKAGE).with_suffix("").as_posix())
def test_nobody_reads_printed_words(path: Path) -> None:
    found = sorted(set(readings(ast.parse(path.read_text(encoding="utf-8")))))
    assert not found, f"{path.name} reads what is printed: ask the law, the role or the kind instead"


ONCE = (  # what the package did once
    """law.label.startswith("Newton's second law")""",
    "law.label.startswith(ALONG_THE_WAY)",
    "equation.family == KINEMATICS and equation.label.startswith('constant')",
    "energy.label == DERIVATIVE and index not in allowed",
    "(0 if equation.family else 1, equation.label == DERIVATIVE, index)",
    "'kinetic energy' in equation.label",
    "'parallel axes' not in equation.label",
    "phases.setdefault(equation.section, {}).setdefault(equation.label, []) if equation.label in phases else None",
    "str(need.words[-1]).partition(': ')[2]",
    "'leaves' in need.otherwise",
    "(item.owner, item.otherwise) == (rub.contact.name, 'slips')",
    "item.otherwise != 'slips'",
    "str(item.words[0]).strip()",
    "body.positive.partition(',')[0].endswith('slope')",
    "str(force.words[0]).startswith('axle')",
    "str(force.words[-1]).lstrip(', ')",
    "any(part.startswith('axle') for part in force.words)",
)


@pytest.mark.parametrize("text", ONCE)
def test_the_test_sees_it(text: str) -> None:
    assert list(readings(ast.parse(f"def decided(law):\n    return {text}")))


def test_a_name_for_printed_words_is_seen_through() -> None:
    assert list(readings(ast.parse("def decided(law):\n    told = law.label\n    return told == 'power'")))
    assert not list(readings(ast.parse("def decided(law):\n    return law.label != '' and law.law == SECOND_LAW")))
