"""Lagrange's equations as records: T and V of systems written by hand, and where the law is written at all.

tests/engine/test_engine_laws.py holds them against the other laws on all scenes of this folder.
"""

from __future__ import annotations

import subprocess
import sys

import pytest
import sympy

from rotsolve import Unsolvable, solve
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, Formula, Symbol, call, total
from rotsolve.algebra.sympy_bridge import to_sympy
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian

x, v, a, q, w, b, m, M, L, g, Omega = map(Symbol, ("x", "v", "a", "q", "w", "b", "m", "M", "L", "g", "Omega"))
SIN, COS = call("sin", q), call("cos", q)
X, Q = GeneralizedCoordinate(x, "v", "way"), GeneralizedCoordinate(q, "w", "angle")
RISE = L * SIN * w  # of a bob at −L cos q


def cart_with_pendulum() -> Lagrangian:
    """T = ½ (M + m) v² + m L v w cos q + ½ m L² w², V = −m g L cos q."""
    kinetic = ((M + m) * v**2 / 2, m * L * v * w * COS, m * L**2 * w**2 / 2)
    return Lagrangian((X, Q), kinetic, (-(m * g * RISE),), (), {"x": v, "q": w}, {"v": a, "w": b}, {})


def bead_on_a_turning_hoop() -> Lagrangian:
    """T = ½ m L² (w² + Ω² sin² q), V = −m g L cos q."""
    kinetic = (m * L**2 * w**2 / 2, m * L**2 * Omega**2 * SIN**2 / 2)
    return Lagrangian((Q,), kinetic, (-(m * g * RISE),), (), {"q": w}, {"w": b}, {})


def same(one: Formula, other: Formula) -> bool:
    return is_zero(one - other)


def test_equations_of_a_pendulum_on_a_cart_are_those_of_sympy() -> None:
    motion, t = cart_with_pendulum(), sympy.Symbol("t")
    place, angle = sympy.Function("X")(t), sympy.Function("Q")(t)
    names = {
        "x": place,
        "v": place.diff(t),
        "a": place.diff(t, 2),
        "q": angle,
        "w": angle.diff(t),
        "b": angle.diff(t, 2),
    }

    def told(value: Formula) -> sympy.Expr:
        return to_sympy(value).subs({letter: names[letter.name] for letter in to_sympy(value).free_symbols & LETTERS})

    LETTERS = {to_sympy(Symbol(name)) for name in names}
    energy = told(total(motion.kinetic)) + told(m * g * L * COS)
    for coordinate, function in ((X, place), (Q, angle)):
        expected = energy.diff(function.diff(t)).diff(t) - energy.diff(function)
        found = told(total([*motion.inertial(coordinate)])) - told(total(motion.efforts(coordinate)))
        assert sympy.simplify(expected - found) == 0


def test_what_does_not_occur_is_cyclic_and_its_momentum_stays() -> None:
    motion = cart_with_pendulum()
    assert motion.cyclic(X) and not motion.cyclic(Q)
    assert same(total(motion.momentum(X)), (M + m) * v + m * L * w * COS)


def test_the_potential_of_a_weight_and_the_energy_that_stays() -> None:
    motion = cart_with_pendulum()
    assert motion.potential is not None and motion.energy is not None and motion.natural
    assert same(total(motion.potential), -(m * g * L * COS))
    assert same(total(motion.energy), total(motion.kinetic) - m * g * L * COS)


def test_of_what_is_carried_round_the_energy_function_stays() -> None:
    """h = T₂ − T₀ + V of a bead on a hoop that turns at Ω, which is not T + V."""
    motion = bead_on_a_turning_hoop()
    assert not motion.natural and motion.energy is not None
    expected = m * L**2 * (w**2 - Omega**2 * SIN**2) / 2 - m * g * L * COS
    assert same(total(motion.energy), expected)
    assert same(motion.in_time(total(motion.energy)), w * (total([*motion.inertial(Q)]) - total(motion.efforts(Q))))


def test_a_power_that_is_no_gradient_has_no_potential() -> None:
    """x w + 2 q v: its parts by q and x differ in their cross derivatives."""
    motion = Lagrangian((X, Q), (), (x * w + 2 * q * v,), (), {"x": v, "q": w}, {"v": a, "w": b}, {})
    assert motion.potential is None


def test_a_place_without_a_rate_is_noticed() -> None:
    open_place = Symbol("angle|other||…now")
    motion = Lagrangian((Q,), (m * w**2 * call("sin", open_place),), (), (), {"q": w}, {"w": b}, {})
    assert not motion.closed


def test_a_weight_on_a_track_of_unknown_form_has_no_potential() -> None:
    """Its slope is an angle of which nothing tells how it grows: no constant under an integral."""
    slope = Symbol("angle|track||…now")
    motion = Lagrangian((X,), (m * v**2 / 2,), (-(m * g * v * call("sin", slope)),), (), {"x": v}, {"v": a}, {})
    assert motion.closed and motion.potential is None and motion.energy is None


DISC = """title: Block on a disc
given: {m: 2 kg, M: 5 kg, R: 0.2 m}
bodies: {disc: {shape: disc, mass: M, radius: R, turns: clockwise}, block: {mass: m, moves: down}}
connections: {axle: {axle: disc}, cord: {string: [disc, block]}}
find: {FIND}
"""


def test_nothing_of_it_is_loaded_or_written_where_it_is_not_asked_for() -> None:
    program = (
        "import sys; from rotsolve import solve; text = sys.argv[1]\n"
        "page = str(solve(text)); assert 'Lagrange' not in page\n"
        "assert not [name for name in sys.modules if 'lagrang' in name]\n"
        "solve(text, law='lagrange'); assert [name for name in sys.modules if 'lagrang' in name]"
    )
    subprocess.run([sys.executable, "-c", program, DISC.replace("FIND", "a: block.acceleration")], check=True)


def test_letters_and_the_tension_that_takes_newtons_laws() -> None:
    text = DISC.replace("{m: 2 kg, M: 5 kg, R: 0.2 m}", "{m: kg, M: kg, R: m}")
    found = solve(text.replace("FIND", "a: block.acceleration, T: cord.tension"), law="lagrange")
    assert found.answers["a"].exact == "2 m g/(2 m + M)" and found.answers["T"].exact == "m M g/(2 m + M)"
    assert "Lagrange's equations alone do not give T: Newton's laws were used as well" in str(found)
    with pytest.raises(Unsolvable, match="Lagrange's equations do not settle anything") as refusal:
        solve(text.replace("FIND", "F: axle.force.x"), law="lagrange")
    assert "it takes Newton's laws" in str(refusal.value)


def test_two_ways_to_move_are_two_coordinates() -> None:
    """A rod on a rod: both angles, each with its equation written out by dotted letters."""
    text = """title: Two rods
given: {M: 3 kg, m: 2 kg, L: 1 m, l: 0.5 m}
bodies: {upper: {shape: rod, mass: M, length: L}, lower: {shape: rod, mass: m, length: l}}
connections: {pivot: {hinge: upper.start}, pin: {hinge: [upper.end, lower.start]}}
states: {now: {upper.angle: -60 deg, lower.angle: -30 deg, upper.angular_velocity: 2 rad/s, lower.angular_velocity: -1 rad/s}}
find: {alpha: upper.angular_acceleration, beta: lower.angular_acceleration}
"""
    found, plain = solve(text, law="lagrange"), solve(text)
    page = found.to("text", width=300)
    assert (
        page.count("Lagrange's equation, angle of") == 2
        and "θ̈_lower" in page
        and "\\ddot{\\theta}" in found.to("latex")
    )
    assert "\\partial" in found.to("latex") and "?" not in found.to("latex")
    for name in ("alpha", "beta"):
        assert found.answers[name].float == pytest.approx(plain.answers[name].float, rel=1e-12)


def test_a_simplified_pace_is_constant() -> None:
    assert simplify(cart_with_pendulum().pace(Q)) == ONE
