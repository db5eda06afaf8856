"""Standing: the angles at which bodies that can move in several ways hang in balance, each told by the forces along its own coordinate."""

from __future__ import annotations

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.roots import solve_trig
from rotsolve.algebra.formula import Call, Formula
from rotsolve.core.facts import Facts
from rotsolve.core.symbols import key_of, of_kinds
from rotsolve.equations.carriers import carried_accelerations
from rotsolve.equations.equilibrium import PLACES, STATE_IT, growth_rate
from rotsolve.laws.groups import rates_of
from rotsolve.laws.modes import FreeWays, generalized_forces, independent_ways
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet

NOT_TOLD = "where these bodies are in equilibrium is not told"


def stable_angles(rest: Instant, still: Facts, group: frozenset[str], signs: SignOracle) -> dict[str, Formula]:
    """Angle after angle of which one force alone speaks, where that drives it back: in a stable equilibrium each coordinate alone is."""
    bodies = [body for body in still.bodies if body.name in group]
    rates = sorted({name for body in bodies for name in rates_of(body)}, key=wanted)
    ways = independent_ways(still, group, rates, is_zero, carried_accelerations(rest, still, group))
    if ways is None:
        raise NotYet(NOT_TOLD, help=STATE_IT)
    found: dict[str, Formula] = {}
    pushes = generalized_forces(bodies, ways)
    while True:
        pushes = [simplify(push.substitute(found)) for push in pushes]
        open_ = [(place, in_functions(push)) for place, push in enumerate(pushes)]
        place, letter = next(((k, names[0]) for k, names in open_ if len(names) == 1), (0, ""))
        if not letter:
            break
        slope = differentiate(pushes[place], letter) * growth_of_angle(letter, still, ways, ways.rates[place])
        roots = [
            root for root in solve_trig(pushes[place], letter) if signs.of_sizes(slope.substitute({letter: root})) == -1
        ]
        if len(roots) != 1:
            raise NotYet("the stable equilibrium is not told", help=STATE_IT)
        found[letter] = simplify(roots[0])
    if any(names for _, names in open_):
        raise NotYet(NOT_TOLD, help=STATE_IT)
    return found


def wanted(rate: str) -> tuple[bool, bool, str]:
    """Turns first, then ways along a line, then those of what moves freely."""
    key = key_of(rate)
    return not key.turns, key.component != "", rate


def in_functions(push: Formula) -> list[str]:
    """The angles and stretches of which a force speaks, where one of them stands in a sine or cosine; else none."""
    calls = [node for node in push.walk(Call) if isinstance(node, Call)]
    letters = of_kinds(push.symbols(), PLACES)
    return letters if any(letter in node.symbols() for letter in letters for node in calls) else []


def growth_of_angle(angle: str, still: Facts, ways: FreeWays, way: str) -> Formula:
    """How fast an angle grows, counterclockwise, with one of the ways."""
    grown = growth_rate(angle, still.bodies)
    return differentiate(grown.substitute(dict(ways.virtual)), way)
