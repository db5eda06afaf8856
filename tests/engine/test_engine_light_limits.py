"""What Checks says of a mass that is left out is so: by the printed answers, with one that is next to nothing."""

from __future__ import annotations

import pytest

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.confirm.course.samples import holding, with_givens
from rotsolve.confirm.course.sizes import size_drawn
from rotsolve.confirm.numbers import value_of
from rotsolve.pipeline import solve

RING = """
given: {M: kg, m: kg, R: m, mu: number}
surfaces: {ice: level}
bodies: {ring: {shape: ring, mass: M, radius: R, moves: right, turns: clockwise}, bead: {mass: m}}
connections: {tie: {weld: [ring.rim, bead]}, touch: {contact: [ring, ice], friction: mu}}
states: {start: {ring.angle: 0, at rest: all}}
find: {a: ring.acceleration at start}
"""
SLED = """
given: {M: kg, m: kg, mu: number}
surfaces: {table: level}
bodies: {sled: {mass: M, moves: right}, load: {mass: m, moves: down}, p: {shape: disc, mass: 0}}
connections: {base: {contact: [sled, table], friction: mu}, axle: {axle: p}, rope: {string: [sled, p, load]}}
states: {start: at rest}
find: {a: load.acceleration at start, T: rope.tension at start}
"""
DRUM = """
given: {M: kg, m: kg, I: kg m^2, R: m, r: m}
bodies: {drum: {inertia: I, radii: {big: R, small: r}, turns: clockwise}, crate: {mass: M, moves: up}, load: {mass: m, moves: down}}
connections: {ax: {axle: drum}, rope: {string: [crate, drum.small]}, cable: {string: [drum.big, load]}}
states: {start: at rest}
find: {b: r where crate.acceleration is largest}
"""
WINCH = """
given: {M: kg, m: kg, R: m}
bodies: {drum: {shape: disc, mass: M, radius: R, turns: clockwise}, load: {mass: m, moves: down}}
connections: {ax: {axle: drum}, rope: {string: [drum, load]}}
states: {start: at rest}
find: {a: load.acceleration at start, T: rope.tension at start}
"""
KINDS = {"a bead on a ring": RING, "a load that draws a sled": SLED, "where a largest value is": DRUM, "a winch": WINCH}


@pytest.mark.parametrize("text", KINDS.values(), ids=list(KINDS))
def test_what_is_said_of_a_mass_next_to_nothing_is_so(text: str) -> None:
    """At an ordinary place, with the answer that holds there for so small a mass."""
    solution = solve("title: by hand\n" + text)
    for check in solution.checks:
        if " → 0 gives " not in check.words:
            continue
        letter, _, asked, _, told, *_ = check.words  # and what that means
        assert isinstance(letter, Symbol)
        assert isinstance(asked, Symbol)
        assert isinstance(told, Formula)
        numbers = {given.name: size_drawn(given, 0, place) for place, given in enumerate(solution.problem.givens)}
        numbers = {**with_givens(solution.problem, numbers), letter.name: 1e-9}
        case = holding(solution.answers[asked.name].answer, numbers)
        assert case is not None
        assert case.formula is not None
        assert value_of(case.formula, numbers) == pytest.approx(value_of(told, numbers), rel=1e-6)


def test_it_is_still_said_where_it_is_so() -> None:
    assert any(" → 0 gives " in check.words for check in solve("title: by hand\n" + WINCH).checks)
