"""In space: what only scenes with `up: z` can say (directions, turns, tensors), and what mixes plane and space."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, negate
from rotsolve.algebra.units.dimension import Dimension, DimensionError, dimension_of
from rotsolve.core.vectors.tensor import ROWS, InertiaTensor
from rotsolve.language.bodies import Turn
from rotsolve.language.words import hint, quoted
from rotsolve.scene.literals import Want, infer
from rotsolve.scene.scope import Nothing, Scope
from rotsolve.scene.tree import List, Map, Node, Text
from rotsolve.scene.values import read_scalar

Direction = tuple[Formula, Formula, Formula]
ALONG = {"x": (ONE, ZERO, ZERO), "y": (ZERO, ONE, ZERO), "z": (ZERO, ZERO, ONE)}
WORDS: dict[str, Direction] = {
    **ALONG,
    **{f"-{axis}": (negate(x), negate(y), negate(z)) for axis, (x, y, z) in ALONG.items()},
    "up": ALONG["z"],
    "down": (ZERO, ZERO, negate(ONE)),
    "right": ALONG["x"],
    "left": (negate(ONE), ZERO, ZERO),
}
LONG_DECIMAL = re.compile(r"[-+]?\d*\.\d{7,}")  # as of a direction that is worked out elsewhere
UP_HELP = "a scene in space has `up: z` at the top"


def in_space_only(scope: Scope, place: Any, word: str) -> Nothing:
    """A word of space in a scene of the plane."""
    return scope.fault(place, f"`{word}` is for scenes in space, and this one is in the plane", UP_HELP, "mixed")


def in_plane_only(scope: Scope, place: Any, word: str, instead: str = "") -> Nothing:
    """A word of the plane in a scene in space, and what says the same there."""
    help = (
        instead
        or "leave out `up: z` where all moves in one plane, or say it with the words of space (docs/language.md)"
    )
    return scope.fault(place, f"`{word}` is for scenes in the plane, and this one is in space", help, "mixed")


def read_three(scope: Scope, node: Node, want: Want) -> Direction | None:
    """Three components `[x, y, z]`."""
    if not isinstance(node, List) or len(node.items) != 3:
        return scope.fault(node, f"`{want.label}` wants `[x, y, z]` in space", "write its three components", "form")
    found = [read_scalar(scope, item, wanted_part(want, axis)) for axis, item in zip("xyz", node.items, strict=True)]
    x, y, z = found
    return None if x is None or y is None or z is None else (x, y, z)


def wanted_part(want: Want, axis: str) -> Want:
    """What is wanted of one component: a letter of its own."""
    owner = f"{want.owner}_{axis}" if want.owner else axis
    return Want(want.label, want.dimension, want.letter, owner, varies=want.varies)


def read_way(scope: Scope, node: Node, label: str, owner: str = "") -> Direction | None:
    """`x`, `-y`, `up` or `[x, y, z]`, of which only the direction counts; not of length 0."""
    if isinstance(node, Text):
        word = node.value.strip()
        if word in WORDS:
            return WORDS[word]
        return scope.fault(node, f"{quoted(word)} is no direction in space", hint(word, WORDS, "directions"), "choice")
    if isinstance(node, Map) or len(node.items) != 3:
        return scope.fault(node, f"`{label}` wants `x`, `y`, `z` or `[x, y, z]`", kind="form")
    x, y, z = read_ratio(scope, node, label, owner)
    if x is None or y is None or z is None:
        return None
    if all(scope.side(part) == 0 for part in (x, y, z)):
        return scope.fault(
            node, f"`{label}` is a direction of length 0", "it needs a component that is not 0", "limits"
        )
    return (x, y, z)


def read_ratio(scope: Scope, node: List, label: str, owner: str) -> list[Formula | None]:
    """The components of a direction, of which only the ratio counts: a length in place beside letters is a letter too, and keeps its
    dimension. So is a long decimal, of which all digits would stand in each formula."""
    words = {word for item in node.items if isinstance(item, Text) for word in re.findall(r"\w+", item.value)}
    lettered = not words.isdisjoint(scope.givens)
    letters = "xyz" if lettered else ("", "", "")
    parts = [
        read_scalar(
            scope,
            item,
            Want(label, "number", "n", f"{owner}_{axis}")
            if isinstance(item, Text) and LONG_DECIMAL.fullmatch(item.value.strip())
            else Want(label, letter=letter, owner=owner),
        )
        for axis, letter, item in zip("xyz", letters, node.items, strict=False)
    ]
    infer_from_beside(scope, [part for part in parts if part is not None and part != ZERO])
    return parts


def infer_from_beside(scope: Scope, parts: Sequence[Formula]) -> None:
    """Give a letter of unknown dimension that with which all components of a direction have one."""
    known: dict[str, Dimension] = {name: own for name, own in scope.dimensions.items() if own is not None}
    told = set[Dimension]()
    for part in parts:
        if part.symbols() <= known.keys():
            with suppress(DimensionError):
                told.add(dimension_of(part, known))
    for part in parts if len(told) == 1 else ():
        missing = sorted(part.symbols() - known.keys())
        found = infer(part, missing, scope.dimensions, next(iter(told)))
        if found is not None:
            scope.dimensions[missing[0]] = found


def read_turning_gravity(scope: Scope, node: Map) -> tuple[Node | None, Node | None]:
    """`gravity: {size: g, in: earth}`: its size, where one is told, and what names the body with which it turns."""
    if not scope.space:
        in_space_only(scope, node, "gravity: {…}")
        return None, None
    entries = scope.entries(node, "`gravity`", ("size", "in"))
    if "in" not in entries:
        scope.fault(node, "`gravity` needs `in`", "write `gravity: {size: g, in: earth}`, or its size alone", "missing")
        return None, None
    return (entries["size"][1] if "size" in entries else None), entries["in"][1]


def read_axis(scope: Scope, node: Node, owner: str) -> Direction | None:
    """The symmetry axis of a body: one of its own axes."""
    word = node.value.strip() if isinstance(node, Text) else ""
    if word in ALONG:
        return ALONG[word]
    return scope.fault(node, "`axis` wants `x`, `y` or `z`", "draw the body so that its axis is one of its own", "form")


def read_rotations(scope: Scope, node: Node, owner: str) -> tuple[Turn, ...] | None:
    """`turned: {about: x, by: 30 deg}`, or a list of such, one after the other about axes that stay in space."""
    items = node.items if isinstance(node, List) else (node,)
    found = []
    for item in items:
        entries = scope.entries(item, "`turned`", ("about", "by"))
        for word in ("about", "by"):
            if isinstance(item, Map) and word not in entries:
                scope.fault(item, f"`turned` needs `{word}`", "write `turned: {about: x, by: 30 deg}`", "missing")
        if "about" not in entries or "by" not in entries:
            return None
        about = read_way(scope, entries["about"][1], "about", owner)
        by = read_scalar(scope, entries["by"][1], Want("by", "angle", "theta", owner))
        if about is None or by is None:
            return None
        found.append(Turn(about, by))
    return tuple(found)


def read_principal(scope: Scope, node: Node, owner: str) -> InertiaTensor | None:
    """`principal: [I1, I2, I3]`: the tensor along the body's own axes; moments that a body can have."""
    if not isinstance(node, List) or len(node.items) != 3:
        return scope.fault(node, "`principal` wants `[I1, I2, I3]`", kind="form")
    found = [
        read_scalar(scope, item, Want("principal", "moment of inertia", "I", f"{owner}_{axis}", "nonnegative"))
        for axis, item in zip("xyz", node.items, strict=True)
    ]
    x, y, z = found
    if x is None or y is None or z is None:
        return None
    check_moments(scope, node, (x, y, z))
    return InertiaTensor(x, y, z)


def check_moments(scope: Scope, node: Node, moments: Direction) -> None:
    """None of three moments is larger than the other two together: I_x + I_y ≥ I_z, since Σ m z² ≥ 0."""
    x, y, z = moments
    for name, spare in (("x", y + z - x), ("y", z + x - y), ("z", x + y - z)):
        if scope.side(spare) == -1:
            message = f"no body has these moments of inertia: I_{name} is larger than the other two together"
            scope.fault(node, message, "Σ m z² = (I_x + I_y − I_z)/2 can't be negative", "limits")


def read_tensor(scope: Scope, node: Node, owner: str) -> InertiaTensor | None:
    """`tensor: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]`: its products are −Σ m x y; symmetric."""
    rows = node.items if isinstance(node, List) else ()
    if len(rows) != 3 or not all(isinstance(row, List) and len(row.items) == 3 for row in rows):
        return scope.fault(node, "`tensor` wants three rows of three", "products of inertia are −Σ m x y", "form")
    entries: dict[str, Formula] = {}
    for names, row in zip(ROWS, rows, strict=True):
        for name, item in zip(names, row.items if isinstance(row, List) else (), strict=True):
            found = read_scalar(scope, item, Want("tensor", "moment of inertia", "I", f"{owner}_{name}"))
            if found is None:
                return None
            if name in entries and scope.side(simplify(entries[name] - found)) != 0:
                message = f"an inertia tensor is symmetric, but this has two values for I_{name}"
                return scope.fault(item, message, kind="limits")
            entries.setdefault(name, found)
    check_definite(scope, node, InertiaTensor(**entries))
    return InertiaTensor(**entries)


def check_definite(scope: Scope, node: Node, tensor: InertiaTensor) -> None:
    """The second moments Σ m xᵢ xⱼ of a body, J = ½ (trace I) 1 − I, have no negative minor along the diagonal."""
    half = (tensor.xx + tensor.yy + tensor.zz) / 2
    xx, yy, zz = half - tensor.xx, half - tensor.yy, half - tensor.zz
    xy, yz, zx = tensor.xy, tensor.yz, tensor.zx
    minors = (xx, yy, zz, xx * yy - xy**2, yy * zz - yz**2, zz * xx - zx**2)
    whole = xx * (yy * zz - yz**2) - xy * (xy * zz - yz * zx) - zx * (zx * yy - xy * yz)
    if any(scope.side(minor) == -1 for minor in (*minors, whole)):
        message = "no body has this inertia tensor: a moment of inertia would be larger than the other two together"
        scope.fault(node, message, "each Σ m x², and so each minor of ½ (trace I) − I, can't be negative", "limits")
