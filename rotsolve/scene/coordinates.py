"""Coordinates: limits of a lamina, the profile of a solid of revolution, and densities, as formulas of a shape's own coordinates."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.algebra.units.dimension import DIMENSIONS, Dimension
from rotsolve.core.letters import letters_of
from rotsolve.core.slicing import Range, coordinate
from rotsolve.elements.shapes import Shape
from rotsolve.elements.shapes.integrated import CARTESIAN, POLAR
from rotsolve.language.words import hint, joined, quoted
from rotsolve.scene.literals import Want, asked_letter
from rotsolve.scene.rough import rough
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Map, Node, Text
from rotsolve.scene.values import read_scalar

MEASURES = {"x": "length", "y": "length", "z": "length", "r": "length", "phi": "angle", "theta": "angle"}
DENSITIES = {"line": "density per length", "surface": "density per area", "volume": "density"}
LETTERS = {"line": "lambda", "surface": "sigma", "volume": "rho"}
FORM = "write `{x: [0, a], y: [0, b]}` or `{r: [0, R], phi: [0, pi]}`"


def of_coordinates(scope: Scope, node: Node, names: Collection[str], want: Want) -> Formula | None:
    """A formula of coordinates, which no letter of the scene may have as its name."""
    taken = [name for name in names if name in scope.givens and mentions(node, name)]
    if taken:
        message = f"`{taken[0]}` is a given, and a coordinate of `{want.owner}`"
        return scope.fault(node, message, f"give the given another name, such as `{taken[0]}0`", "name")
    extra: Mapping[str, Dimension] = {name: DIMENSIONS[MEASURES[name]] for name in names if name not in scope.givens}
    found = read_scalar(scope, node, replace(want, extra=extra))
    return None if found is None else found.substitute({name: coordinate(name) for name in extra})


def mentions(node: Node, name: str) -> bool:
    """Whether a written formula holds a name."""
    return isinstance(node, Text) and re.search(rf"(?<!\w){name}(?!\w)", node.value) is not None


def read_range(scope: Scope, node: Node, name: str, others: Collection[str], label: str, owner: str) -> Range | None:
    """`x: [0, a]`, where the limits may be formulas of the other coordinate."""
    if not isinstance(node, List) or len(node.items) != 2:
        return scope.fault(node, f"`{name}` wants its limits `[from, to]`", FORM, "form")
    want = Want(label, MEASURES[name], {"phi": "beta"}.get(name, name), owner)
    ends = [of_coordinates(scope, item, others, want) for item in node.items]
    if ends[0] is None or ends[1] is None:
        return None
    low, high = rough(ends[0], scope.numbers), rough(ends[1], scope.numbers)
    if low is not None and high is not None and low >= high:
        return scope.fault(node, f"the limits of `{name}` enclose nothing", "write the smaller first", "limits")
    return Range(coordinate(name), ends[0], ends[1])


def read_region(scope: Scope, node: Node, label: str, owner: str) -> tuple[Range, ...] | None:
    """The limits of x and y, or of r and phi."""
    if not isinstance(node, Map):
        return scope.fault(node, f"`{label}` wants the limits of two coordinates", FORM, "form")
    entries = scope.entries(node, f"`{label}`", (*CARTESIAN, *POLAR))
    pair = next((names for names in (CARTESIAN, POLAR) if set(entries) == set(names)), None)
    if pair is None:
        return scope.fault(node, f"`{label}` wants x and y, or r and phi", FORM, "missing")
    ranges = (read_range(scope, entry[1], name, {*pair} - {name}, label, owner) for name, entry in entries.items())
    one, other = ranges
    if one is None or other is None:
        return None
    if leans(one, other) and leans(other, one):
        message = f"the limits of `{label}` lean on each other"
        return scope.fault(node, message, "those of one coordinate must be fixed", "form")
    return one, other


def leans(one: Range, other: Range) -> bool:
    return other.variable.name in one.lower.symbols() | one.upper.symbols()


def read_profile(scope: Scope, node: Node, label: str, owner: str) -> tuple[Range, ...] | None:
    """`{z: [0, h], r: R*z/h}`; `r: [inner, outer]` for a hollow body."""
    form = "write `{z: [0, h], r: R*z/h}`"
    entries = scope.entries(node, f"`{label}`", ("z", "r"))
    if set(entries) != {"z", "r"}:
        return scope.fault(node, f"`{label}` wants the limits of z, and r", form, "missing")
    along = read_range(scope, entries["z"][1], "z", (), label, owner)
    written = entries["r"][1]
    want = Want(label, "length", "R", owner)
    if isinstance(written, List):
        radius = read_range(scope, written, "r", ("z",), label, owner)
    else:
        outer = of_coordinates(scope, written, ("z",), want)
        radius = None if outer is None else Range(coordinate("r"), ZERO, outer)
    return None if along is None or radius is None else (along, radius)


def read_density(
    scope: Scope, node: Node, owner: str, shape: type[Shape] | None, fields: dict[str, Any]
) -> Formula | None:
    """A density that is the same everywhere, or a formula of the coordinates of the shape."""
    built: Shape | None = fields.get("shape")
    if shape is None or built is None or built.spread not in DENSITIES:
        what = f"a {shape.word}" if shape else "a body without a shape"
        return scope.fault(node, f"{what} has no density", "give its `mass`", "form")
    names = built.variables()
    strange = [name for name in MEASURES if name not in names and name not in scope.givens and mentions(node, name)]
    if strange:
        message = f"{quoted(strange[0])} is no coordinate of `{owner}`"
        known = hint("", names, "coordinates") if names else f"the density of a {shape.word} is the same everywhere"
        return scope.fault(node, message, known, "unknown")
    if isinstance(node, (Map, List)):
        return scope.fault(node, f"`density` wants one value or a formula of {joined(names) or 'givens'}", kind="form")
    want = Want("density", DENSITIES[built.spread], LETTERS[built.spread], owner, "nonnegative")
    return of_coordinates(scope, node, names, want)


def told_by_both(scope: Scope, name: str, entries: Mapping[str, tuple[Text, Node]], fields: dict[str, Any]) -> None:
    """What a mass beside a density tells: what is `unknown`, else the one letter of the density, or size, that has no number."""
    density, mass, shape = fields.get("density"), fields.get("mass"), fields.get("shape")
    if density is None or mass is None or shape is None:
        return
    of_density, sizes = letters_behind(scope, density), letters_behind(scope, shape)
    if any(scope.givens[letter].asked for letter in (*of_density, *sizes, *letters_behind(scope, mass))):
        return
    free, left = [letter for letter in of_density if scope.givens[letter].value is None], shape.left_out()
    if len(free) == 1:
        scope.givens[free[0]] = replace(scope.givens[free[0]], asked=True)
    elif not free and len(left) == 1:
        declared = shape.declared[left[0]]
        want = Want(left[0], declared.dimension or "length", declared.letter or left[0][0], name)
        fields["shape"] = replace(shape, **{left[0]: asked_letter(scope, entries["density"][0], want)})
    else:
        message = f"`{name}` has both `mass` and `density`, and nothing is left that they tell"
        if free or left:
            several = joined([*(f"`{letter}`" for letter in free or left)])
            message = f"`{name}` has both `mass` and `density`: they tell one of {several}, and not which"
        scope.fault(entries["density"][0], message, "give one of them, or write `unknown` for what they tell", "form")


def letters_behind(scope: Scope, item: object) -> list[str]:
    """The givens of which something is made, and those of which they are."""
    found = [name for name in sorted(letters_of(item)) if name in scope.givens]
    for name in found:
        value = scope.givens[name].value
        found += [] if value is None else [one for one in letters_behind(scope, value) if one not in found]
    return found
