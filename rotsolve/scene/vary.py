"""Vary: `m: 1 kg to 3 kg by 0.5 kg`, `theta: [30 deg, 45 deg]`, and `where: M > m`, a condition or a list of them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from rotsolve.algebra.formula import Formula, Number
from rotsolve.algebra.units.quantities import UnitError, UnitValue, number_in_unit, parse_quantity
from rotsolve.algebra.units.unit_table import ONE_UNIT, Unit
from rotsolve.language.problem import Comparison, Given, Variation, Varied
from rotsolve.language.words import quoted
from rotsolve.scene.literals import Want, dimension_in_words, unit_fault
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Map, Node, Text
from rotsolve.scene.values import agreed_dimension, expression

WHERE = "where"
FORM = "write a range `1 kg to 3 kg by 0.5 kg`, or a list `[30 deg, 45 deg]`"
RANGE = re.compile(r"\s*(?P<start>.+?)\s+to\s+(?P<stop>.+?)(?:\s+by\s+(?P<step>.+?))?\s*", re.DOTALL)
SIGN = re.compile(r"<=|>=|==|!=|[<>=≤≥≠]")
SIGNS = {"<": (-1,), ">": (1,), "≤": (-1, 0), "≥": (0, 1), "=": (0,), "≠": (-1, 1)}
SIGNS |= {"<=": SIGNS["≤"], ">=": SIGNS["≥"], "==": SIGNS["="], "!=": SIGNS["≠"]}
DECIMALS = re.compile(r"\d*\.(\d+)")
MOST = 10_000  # values of one letter


def read_vary(scope: Scope, node: Node) -> Variation | None:
    """The whole section; None after a fault."""
    if not isinstance(node, Map):
        return scope.fault(node, "`vary` wants a map", "write `vary: {m: 1 kg to 3 kg by 0.5 kg}`", "form")
    before = len(scope.faults)
    entries = scope.entries(node, "`vary`")
    where = entries.pop(WHERE, None)
    letters = [read_varied(scope, name, key, written) for name, (key, written) in entries.items()]
    if not entries and len(scope.faults) == before:
        scope.fault(node, "`vary` names no letter that varies", FORM, "form")
    varied = tuple(item for item in letters if item is not None)
    conditions = tuple(conditions_of(scope, where[1], set(entries))) if where is not None else ()
    return Variation(varied, conditions) if len(scope.faults) == before else None


def check_told(scope: Scope, variation: Variation, told: Mapping[str, Node]) -> None:
    """What is told with the number of a letter that varies would be wrong for all variants but one."""
    for name in (item.name for item in variation.letters):
        value = scope.givens[name].text
        for section, node in told.items():
            if isinstance(node, Text) and (found := re.search(rf"(?<![\w.]){re.escape(value)}(?!\w)", node.value)):
                help = f"write `{{{name}}}` or `{{value of {name}}}`" if section == "text" else "choose another"
                message = f"`{section}` tells {quoted(value)}, the value of `{name}`, which varies"
                scope.fault(node.part(*found.span()), message, help, "form")


def read_varied(scope: Scope, name: str, key: Text, node: Node) -> Varied | None:
    """One given with its values."""
    given = scope.givens.get(name)
    if given is None or scope.kinds.get(name) != "given":
        return scope.unknown(key, name, "given", scope.names("given"), "givens", " in `vary`")
    if given.asked:
        return scope.fault(key, f"`{name}` is asked for: it can't vary", "let givens vary that have a value", "form")
    if isinstance(node, List):
        values = listed_values(scope, given, node)
    elif isinstance(node, Text) and (match := RANGE.fullmatch(node.value)):
        values = stepped_values(scope, given, node, match)
    else:
        return scope.fault(node, f"`{name}` varies over nothing", FORM, "form")
    return Varied(name, values) if values else None


def read_given_value(scope: Scope, given: Given, node: Text) -> UnitValue | None:
    """One value, with the dimension that the given has."""
    try:
        found = parse_quantity(node.value.strip())
    except UnitError as error:
        return unit_fault(scope, node, error)
    wanted = scope.dimensions.get(given.name)
    if given.unit is not None and found.unit is None:
        return scope.fault(node, f"{quoted(node.value.strip())} has no unit, but `{given.name}` has", FORM, "unit")
    if wanted is not None and not found.dimension.matches(wanted):
        shown = f"{quoted(node.value.strip())} is {dimension_in_words(found.dimension)}"
        message = f"`{given.name}` is {dimension_in_words(wanted)}, but {shown}"
        cause = f"dimension of {given.name}"
        return scope.fault(node, message, kind="dimension", related=scope.given_at(given.name), cause=cause)
    return found


def listed_values(scope: Scope, given: Given, node: List) -> tuple[str, ...]:
    """The values of a list, all different."""
    found: dict[Formula, str] = {}
    before = len(scope.faults)
    for item in node.items:
        if not isinstance(item, Text):
            scope.fault(item, f"`{given.name}` wants a list of values", FORM, "form")
            continue
        value = read_given_value(scope, given, item)
        if value is not None and value.value in found:
            scope.fault(item, f"{quoted(item.value.strip())} stands twice in the list", kind="choice")
        elif value is not None:
            found[value.value] = item.value.strip()
    if len(node.items) < 2 and len(scope.faults) == before:
        scope.fault(node, f"`{given.name}` has nothing to choose from", "a list has two values at least", "form")
    return tuple(found.values()) if len(scope.faults) == before else ()


def stepped_values(scope: Scope, given: Given, node: Text, match: re.Match[str]) -> tuple[str, ...]:
    """The values of a range, from its start by equal steps to its stop."""
    if match["step"] is None:
        help = f"write `{match['start']} to {match['stop']} by …`"
        scope.fault(node, f"the range {quoted(node.value.strip())} has no step", help, "form")
        return ()
    parts = [node.cut(*match.span(word)) for word in ("start", "stop", "step")]
    found = [read_given_value(scope, given, part) for part in parts]
    known = [value for value in found if value is not None]
    if len(known) < len(found):
        return ()
    unit = known[0].unit or ONE_UNIT
    numbers = [number_in_unit(value.value, unit) for value in known]
    sizes = [number.value for number in numbers if isinstance(number, Number)]
    if len(sizes) < len(numbers):
        scope.fault(node, f"the units of {quoted(node.value.strip())} have no ratio", "write all three in one", "unit")
        return ()
    start, stop, step = sizes
    if not in_steps(scope, node, match, start, stop, step):
        return ()
    point = DECIMALS.match(match["start"].lstrip("+-−"))
    least = len(point[1]) if point else 0
    return tuple(value_in_unit(start + step * count, least, unit) for count in range(int((stop - start) / step) + 1))


def in_steps(scope: Scope, node: Text, match: re.Match[str], start: Fraction, stop: Fraction, step: Fraction) -> bool:
    """Whether equal steps lead from the start to the stop, and not too many."""
    if step <= 0:
        scope.fault(node.cut(*match.span("step")), "the step of a range must be positive", kind="limits")
    elif stop <= start:
        scope.fault(node, f"the range {quoted(node.value.strip())} ends before it begins", kind="limits")
    elif ((stop - start) / step).denominator > 1:
        message = f"steps of {quoted(match['step'])} from {quoted(match['start'])} do not meet {quoted(match['stop'])}"
        scope.fault(node, message, "choose a step that divides the range", "limits")
    elif (stop - start) / step >= MOST:
        scope.fault(node, f"the range has more than {MOST} values", "take larger steps", "limit")
    else:
        return True
    return False


def value_in_unit(number: Fraction, least: int, unit: Unit) -> str:
    """A number as a scene writes it, as a decimal where it has an end, with as many places as the start of its range at least."""
    for places in range(least, least + 40):
        scaled = number * 10**places
        if scaled.denominator == 1:
            digits = str(abs(scaled.numerator)).rjust(places + 1, "0")
            text = f"{digits[:-places]}.{digits[-places:]}" if places else digits
            return unit.after(f"{'-' * (number < 0)}{text}")
    return unit.after(str(number))


def conditions_of(scope: Scope, node: Node, varied: set[str]) -> Iterator[Comparison]:
    """The comparisons that `where` writes."""
    for item in node.items if isinstance(node, List) else (node,):
        marks = list(SIGN.finditer(item.value)) if isinstance(item, Text) else []
        if not isinstance(item, Text) or not marks:
            scope.fault(item, "`where` wants a comparison of givens", "write `where: M > m`, or a list of such", "form")
            continue
        before = set(scope.givens)
        places = [0, *(place for mark in marks for place in mark.span()), len(item.value)]
        sides = [read_side(scope, item.cut(*places[k : k + 2]), varied) for k in range(0, len(places), 2)]
        made = {name: given for name, given in scope.givens.items() if name not in before}
        yield from comparisons_of(scope, item, [SIGNS[mark[0]] for mark in marks], sides, made)
        for name in made:  # the quantities in a condition are numbers, not letters of the scene
            del scope.givens[name], scope.dimensions[name]
            scope.numbers.pop(name, None)


def read_side(scope: Scope, node: Text, varied: set[str]) -> Formula | None:
    """One side of a comparison, whose letters all have numbers."""
    if not node.value:
        return scope.fault(node, "a comparison lacks a side", "write `where: M > m`", "form")
    formula = expression(scope, node, Want(WHERE), None)
    for name in sorted(formula.symbols() - varied) if formula is not None else ():
        if scope.givens[name].value is None:
            return scope.fault(node, f"`{name}` has no number", "give it one, or let it vary", "missing")
    return formula


def comparisons_of(
    scope: Scope, node: Text, signs: list[tuple[int, ...]], sides: list[Formula | None], made: Mapping[str, Given]
) -> Iterator[Comparison]:
    """A comparison for each sign, between what stands on its two sides."""
    known = {name: dimension for name, dimension in scope.dimensions.items() if dimension is not None}
    numbers = {name: given.value for name, given in made.items() if given.value is not None}
    for allowed, left, right in zip(signs, sides, sides[1:], strict=False):
        if left is None or right is None:
            return
        gap = left - right
        if agreed_dimension(scope, node, gap, known, "only quantities of one kind can be compared") is None:
            return
        yield Comparison(gap.substitute(numbers), allowed, node.value.strip())
