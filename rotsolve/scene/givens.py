"""Givens: the letters of the scene with their values, dimensions and dependencies; `--set` overrides."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from math import isfinite
from numbers import Integral, Real

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.dimension import BY_NAME, Dimension, Kind, kind_of
from rotsolve.algebra.units.quantities import UnitError, parse_quantity, parse_unit, unit_for
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.faults import Span
from rotsolve.core.quantity import NUMBER
from rotsolve.language.problem import Given
from rotsolve.language.words import hint, quoted
from rotsolve.scene.literals import LITERAL, Want, dimension_in_words, unit_fault
from rotsolve.scene.rough import remember
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import Map, Node, Text
from rotsolve.scene.values import agreed_dimension, expression, told_foreign

NOWHERE = Span(0, 0)  # a setting of the command line has no place in the file
FORM_OF_SETTING = 'write a text with its unit, such as "2 kg"'
FORMS = "write a value `2 kg`, a unit alone `kg`, `number`, `unknown`, or a formula of other givens `2*R`"


def read_givens(scope: Scope, node: Node | None, settings: Mapping[str, str]) -> None:
    """Read the `given` section into the scope; `settings` replace values."""
    entries = scope.entries(node, "`given`") if node is not None else {}
    texts: dict[str, Text] = {}
    for name, (key, written) in entries.items():
        if scope.kinds.get(name) != "given" or scope.places.get(name) != key.span:
            continue
        if isinstance(written, Text):
            texts[name] = written
        else:
            scope.fault(written, f"given `{name}` wants one value", FORMS, "form")
    originals: dict[str, Text | None] = {}
    for name, text in settings.items():
        if scope.kinds.get(name) == "given":
            originals[name] = texts.get(name)
            texts[name] = Text(text, NOWHERE, exact=False)
        else:
            help = hint(name, scope.names("given"), "givens")
            scope.fault(None, f"--set {quoted(name)}: no such given", help, "unknown")
    for name in texts:
        scope.givens[name] = Given(name, None, None, span=texts[name].span)
    made: dict[str, Formula] = {}
    for name, written in texts.items():
        read_given(scope, name, written, made)
    resolve_givens(scope, made, texts)
    for name, original in originals.items():
        check_setting(scope, name, original)


def settings_in_text(scope: Scope, node: Node | None, settings: Mapping[str, object]) -> dict[str, str]:
    """Settings as texts: a number from Python has the unit that the file declares, where that is one of SI; else it is a fault."""
    texts: dict[str, str] = {}
    for name, value in settings.items():
        if isinstance(value, str):
            texts[name] = value
            continue
        number = number_in_text(value)
        declared = node.get(name) if isinstance(node, Map) else None
        if number is None:
            scope.fault(None, f"--set {name}: {quoted(str(value))} is no value", FORM_OF_SETTING, "form")
        elif scope.kinds.get(name) == "given" and (unit := unit_of_setting(scope, name, number, declared)) is not None:
            texts[name] = f"{number} {unit}".rstrip()
        elif scope.kinds.get(name) != "given":
            texts[name] = number  # it is no given, which is said of it
    return texts


def number_in_text(value: object) -> str | None:
    """A number of Python, NumPy, `fractions` or `decimal` as a scene writes it; None for what is none."""
    if isinstance(value, (bool, complex)) or not isinstance(value, (Real, Decimal)):
        return None
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Fraction):
        return str(value)
    if not isfinite(value):
        return None
    return str(value) if isinstance(value, Decimal) else repr(float(value))


def unit_of_setting(scope: Scope, name: str, number: str, declared: Node | None) -> str | None:
    """The unit in which a number without one is meant, '' of a pure number; None, with a fault, where that is not clear."""
    text = declared.value.strip() if isinstance(declared, Text) else ""
    unit: Unit | None = None
    if text != "number":
        try:
            unit = parse_quantity(text).unit if LITERAL.fullmatch(text) else parse_unit(text)
        except UnitError:
            return scope.fault(None, f"--set {name}: the number {number} has no unit", FORM_OF_SETTING, "unit")
    if unit is None or (unit.scale == 1 and not unit.pi_power):
        return "" if unit is None else unit.text
    plain = unit_for(unit.dimension).text
    message = f"--set {name}: {number} may be in {unit.text}, as in the file, or in {plain}"
    return scope.fault(None, message, f'write "{number} {unit.text}" or "{number} {plain}"', "unit")


def read_given(scope: Scope, name: str, written: Text, made: dict[str, Formula]) -> None:
    """One given: unknown, a number with its unit, a unit alone, or a formula of others (kept in `made`)."""
    text = written.value.strip()
    given = Given(name, None, None, text=text, span=written.span if written.span.line else None)
    scope.givens[name] = given
    if text == "unknown":
        scope.givens[name] = replace(given, asked=True)
        scope.dimensions[name] = None
    elif text == "number":
        scope.givens[name] = replace(given, dimension=NUMBER)
        scope.dimensions[name] = NUMBER
    elif (LITERAL.fullmatch(text) and number_with_unit(scope, given, written)) or letter_with_unit(scope, given):
        pass
    elif told_foreign(scope, written):
        scope.dimensions[name] = None
        scope.lost.add(name)
    elif (
        LITERAL.fullmatch(text)
        and not re.search(r"[-+*/^(]", text[1:])
        and not set(re.findall(r"\w+", text)) & scope.givens.keys()
    ):
        scope.dimensions[name] = None
        try:
            parse_quantity(text)
        except UnitError as error:
            unit_fault(scope, written, error)
    elif text.replace("_", " ") in BY_NAME and text not in scope.givens:
        kind_as_unit(scope, name, written, BY_NAME[text.replace("_", " ")])
    else:
        formula = expression(scope, written, Want(name, None, "q", name, words=("unknown", "number")), None)
        scope.dimensions[name] = None
        if formula is not None:
            made[name] = formula


def kind_as_unit(scope: Scope, name: str, written: Text, kind: Kind) -> None:
    """`theta: angle`: refused, with the unit that says so."""
    scope.dimensions[name] = kind.dimension
    value = f", or a value, `{name}: {kind.example}`" if kind.example else ""
    message = f"{quoted(written.value.strip())} is a kind of quantity, not a unit"
    scope.fault(written, message, f"write a unit, `{name}: {kind.unit}`{value}", "unit")


def number_with_unit(scope: Scope, given: Given, written: Text) -> bool:
    """`2 kg`, also where `kg` is a given too: in this section a number and a unit is a quantity."""
    try:
        quantity = parse_quantity(given.text)
    except UnitError:
        return False
    if rather_givens(scope, given.text, quantity.dimension):
        return False
    scope.givens[given.name] = replace(given, value=quantity.value, dimension=quantity.dimension, unit=quantity.unit)
    scope.dimensions[given.name] = quantity.dimension
    remember(scope.numbers, given.name, quantity.value)
    return True


def letter_with_unit(scope: Scope, given: Given) -> bool:
    """`m: kg`, a letter with a dimension and no number."""
    try:
        unit = parse_unit(given.text)
    except UnitError:
        return False
    if rather_givens(scope, given.text, unit.dimension):
        return False
    scope.givens[given.name] = replace(given, dimension=unit.dimension, unit=unit)
    scope.dimensions[given.name] = unit.dimension
    return True


def rather_givens(scope: Scope, text: str, dimension: Dimension) -> bool:
    """Whether `W/g` is made of other givens: all names in it are such, and nothing is measured in what it would be as a unit."""
    names = set(re.findall(r"[^\W\d]\w*", text))
    return len(names) > 1 and names <= scope.givens.keys() and (dimension == NUMBER or kind_of(dimension) is None)


def resolve_givens(scope: Scope, made: dict[str, Formula], texts: Mapping[str, Text]) -> None:
    """Dimensions and rough numbers of givens made of others, in the order of dependence; cycles are faults."""
    pending = dict(made)
    while pending:
        ready = [name for name, formula in pending.items() if not formula.symbols() & pending.keys()]
        if not ready:
            name_circle(scope, pending, texts)
            return
        for name in ready:
            resolve_one(scope, name, pending.pop(name), texts[name])


def resolve_one(scope: Scope, name: str, formula: Formula, written: Text) -> None:
    known = {symbol: scope.dimensions.get(symbol) for symbol in formula.symbols()}
    dimension = None if None in known.values() else agreed_dimension(scope, written, formula, known)
    scope.givens[name] = replace(scope.givens[name], value=formula, dimension=dimension)
    scope.dimensions[name] = dimension
    remember(scope.numbers, name, formula)
    whole = formula.substitute(scope.made)
    if any(scope.givens[letter].value is None for letter in whole.symbols()):
        scope.made[name] = whole


def name_circle(scope: Scope, pending: Mapping[str, Formula], texts: Mapping[str, Text]) -> None:
    """Name one circle of givens."""
    way = [next(iter(pending))]
    while (name := min(pending[way[-1]].symbols() & pending.keys())) not in way:
        way.append(name)
    circle = [*way[way.index(name) :], name]
    message = f"givens in a circle: {' → '.join(circle)}"
    scope.fault(texts[circle[0]], message, "give one of them a value or a unit", "circle")


def check_setting(scope: Scope, name: str, original: Text | None) -> None:
    """A setting must keep the dimension that the file declares."""
    text = original.value.strip() if original else ""
    new = scope.givens[name].dimension
    try:
        found = parse_quantity(text) if LITERAL.fullmatch(text) else parse_unit(text) if text else None
    except UnitError:
        return
    if found is not None and new is not None and not new.matches(found.dimension):
        before = f"`{name}` is {dimension_in_words(found.dimension)} in the file"
        scope.fault(None, f"--set {name}: {before}, but this is {dimension_in_words(new)}", kind="dimension")
        scope.dimensions[name] = found.dimension  # no further faults from the same cause
