"""Equilibrium: the angle at which the forces on a hinged body balance and drive it back when it is displaced."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.solving.linear import solve_linear
from rotsolve.algebra.exact.solving.roots import solve_trig
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Symbol
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.core.registry import SEPARATOR
from rotsolve.laws import groups
from rotsolve.paths import NotYet

PLACES = ("elongation", "angle")  # what balance decides
SEVERAL_WAYS = "can move in several ways: the swings of such bodies are not solved yet"
STATE_IT = "give a state with its angle and `balance: true`, and say `about` it"
EXTREMES = (Fraction(1), Fraction(1000), Fraction(1, 1000))  # values of letters without a number, each in turn


def stable_angle(still: Facts, group: frozenset[str], values: Mapping[str, Formula]) -> tuple[str, Formula] | None:
    """The letter of the one angle that balance decides by itself, and its stable value; None where springs have a say in it."""
    supplies = [term for body in still.bodies if body.name in group for term in groups.supply(body)]
    rates, allowed = groups.freedom(still, group, supplies)
    if rates and allowed is None:
        raise NotYet(f"{', '.join(f'`{name}`' for name in sorted(group))} {SEVERAL_WAYS}")
    balance = groups.drive(still, group)
    if balance is None or balance == (ZERO, ZERO):
        raise NotYet("nothing drives these bodies back to an equilibrium: there are no swings")
    drive = balance[0] - balance[1]
    letters = [name for name in sorted(drive.symbols()) if name.split(SEPARATOR)[0] in PLACES]
    if not any(inside_function(drive, name) for name in letters):
        root = solve_linear(drive, letters[0]) if len(letters) == 1 else None
        return (letters[0], root) if isinstance(root, (Number, Symbol)) else None
    if len(letters) > 1:
        raise NotYet("where these bodies are in equilibrium is not told", help=STATE_IT)
    slope = differentiate(drive, letters[0]) * turning_rate(letters[0], still, group)
    roots = [candidate.formula for candidate in solve_trig(drive, letters[0])]
    if not roots:
        raise NotYet("the equilibrium has no closed form", help=STATE_IT)
    stable = [root for root in roots if sign(slope.substitute({letters[0]: root}), values) == -1]
    if len(stable) != 1:
        raise NotYet("the stable equilibrium is not told", help=STATE_IT)
    return letters[0], simplify(stable[0])


def turning_rate(angle: str, still: Facts, group: frozenset[str]) -> Formula:
    """How fast an angle grows, counterclockwise, when the group's one free rate is 1."""
    grown = next(rate for body in still.bodies if body.name in group for rate in rate_of(angle, body))
    rates, allowed = groups.freedom(still, group, [grown])
    assert allowed is not None
    free = next(name for name in rates if allowed.get(name) is None)
    return differentiate(grown.substitute(allowed), free)


def rate_of(angle: str, body: BodyFacts) -> Iterator[Formula]:
    """How fast an angle grows: a body's own by its spin, that of its place on a circle by v/ρ."""
    bend = body.motion.bend
    if angle.split(SEPARATOR)[1] == body.name:
        yield body.motion.spin
    elif bend is not None and angle in bend.outward.formula().symbols():
        yield body.motion.velocity.along(bend.outward.turned(90)) / bend.radius


def inside_function(value: Formula, name: str) -> bool:
    """Whether a letter stands in a sine or cosine."""
    return any(isinstance(node, Call) and name in node.symbols() for node in value.walk(Call))


def sign(value: Formula, values: Mapping[str, Formula]) -> int | None:
    """The sign of a formula; of one with letters without a number, that which it has for all kinds of positive values."""
    if is_zero(value):
        return 0
    open_ = sorted(value.symbols() - set(values))
    found = set()
    for letter, size in [("", EXTREMES[0]), *((name, size) for name in open_ for size in EXTREMES[1:])]:
        filled = {name: Number(size if name == letter else EXTREMES[0]) for name in open_}
        try:
            found.add(evaluate(value, {**values, **filled}, digits=5).sign)
        except (Undefined, ValueError):
            return None
    return found.pop() if len(found) == 1 else None
