"""One letter for what a rule says to be the same: both ends of a string move alike, so that a page writes one v for both.

Only where no step solves such a rule for something else, and where not both have names that the scene gives them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from rotsolve.algebra.formula import Symbol
from rotsolve.core.derivation import Words, in_a_row
from rotsolve.core.equation import RULE, RULE_OF_WAYS, Equation
from rotsolve.core.symbols import ACCELERATIONS, RATES, is_key, key_of
from rotsolve.core.writing import and_joined, spoken
from rotsolve.solver.steps import Step

MOTIONS = (*RATES, *ACCELERATIONS, "displacement", "rotation")


def one_letter_for(
    laws: Sequence[int], pool: Sequence[Equation], steps: Sequence[Step], asked: frozenset[str]
) -> dict[int, tuple[str, str]]:
    """The rules by which a quantity goes by the letter of another: by their places in the pool, which letter goes by which."""
    found: dict[int, tuple[str, str]] = {}
    named = {name for index in laws for name in pool[index].symbols() if not is_key(name)}
    targets = {step.target for step in steps}
    for index in laws:
        rule = pool[index]
        if rule.law not in (RULE, RULE_OF_WAYS) or len(rule.bodies) < 2 or ("law", index) in targets:
            continue
        if not isinstance(rule.left, Symbol) or not isinstance(rule.right, Symbol):
            continue
        pair = rule.left.name, rule.right.name
        kinds = {key_of(name).kind for name in pair if is_key(name)}
        if len(kinds) != 1 or kinds.isdisjoint(MOTIONS) or (named | asked).issuperset(pair):
            continue
        goes, stays = pair if pair[0] not in named | asked else (pair[1], pair[0])
        if all(goes not in other for other in found.values()):
            found[index] = goes, stays
    return found


def said_alike(found: Mapping[int, tuple[str, str]], pool: Sequence[Equation]) -> Iterator[Words]:
    """ "Both ends of the string move alike: the same d, v for light and heavy", rule by rule."""
    by_label: dict[str, list[int]] = {}
    for index in found:
        by_label.setdefault(pool[index].label, []).append(index)
    for label, rules in by_label.items():
        owners = {key_of(name).owner for index in rules for name in found[index] if is_key(name)}
        bodies = [spoken(name) for name in pool[rules[0]].bodies if name in owners or len(owners) < 2]
        letters = in_a_row(Symbol(found[index][1]) for index in rules)
        yield (f"{label[0].upper()}{label[1:]}: the same ", *letters, f" for {and_joined(bodies)}")
