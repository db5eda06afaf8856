"""Integrators of y′ = f(t, y): scipy, mpmath, heyoka, and sympy.physics.mechanics, which derives f before scipy integrates it."""

from __future__ import annotations

from functools import partial
from typing import Any

from ..problem import FLOATS, Mathematics, Motion, Problem, Way

TOLERANCES = ("1e-6", "1e-9", "1e-12", "2.3e-14")  # the last is the tightest that scipy accepts
LONGEST = 0.1  # s, for a step of heyoka
FEW = ("1e-6", "1e-12")  # for what is no motion at heart
METHODS = ("RK45", "DOP853", "LSODA", "Radau")


def motion_of(problem: Problem) -> Motion:
    """The motion of a problem that has one."""
    assert problem.motion is not None, problem.name
    return problem.motion


def scipy(problem: Problem, setting: str, method: str) -> list[float]:
    """`solve_ivp` by a method, with rtol = atol."""
    from scipy.integrate import solve_ivp

    motion, tolerance = motion_of(problem), float(setting)
    rates, start = motion.rates(FLOATS), motion.start(FLOATS)
    done = solve_ivp(rates, (0, float(problem.until)), start, method=method, rtol=tolerance, atol=tolerance)
    return motion.read([float(value) for value in done.y[:, -1]], FLOATS.pi)


def mpmath(problem: Problem, setting: str) -> list[str]:
    """`odefun` (Taylor series) with so many digits."""
    from mpmath import mp

    mp.dps = int(setting)
    motion, maths = motion_of(problem), Mathematics(mp.mpf, mp.sin, mp.cos, mp.asin, +mp.pi)
    state = mp.odefun(motion.rates(maths), 0, motion.start(maths))(mp.mpf(problem.until))
    return [mp.nstr(value, mp.dps) for value in motion.read(state, mp.pi)]


def heyoka(problem: Problem, setting: str) -> list[float]:
    """`taylor_adaptive` in double precision with a tolerance.

    Its steps are bounded: from the symmetric start of the two rods the last coefficients vanish, and the first step would be far too long.
    """
    import heyoka as hy

    motion, start = motion_of(problem), motion_of(problem).start(FLOATS)
    letters = hy.make_vars(*(f"y{index}" for index in range(len(start))))
    rates = motion.rates(FLOATS._replace(sin=hy.sin, cos=hy.cos))(hy.time, letters)
    system = [
        (letter, 0 * letter + rate) for letter, rate in zip(letters, rates, strict=True)
    ]  # a plain number is no expression
    integrator = hy.taylor_adaptive(system, start, tol=float(setting))
    integrator.propagate_until(float(problem.until), max_delta_t=LONGEST)
    return motion.read([float(value) for value in integrator.state], FLOATS.pi)


def sympy(problem: Problem, setting: str) -> list[float]:
    """Lagrange's equations by `sympy.physics.mechanics`, `lambdify` with common subexpressions, DOP853."""
    from scipy.integrate import solve_ivp

    motion, tolerance = motion_of(problem), float(setting)
    rates, start = derived_rates(motion), motion.start(FLOATS)
    done = solve_ivp(rates, (0, float(problem.until)), start, method="DOP853", rtol=tolerance, atol=tolerance)
    return motion.read([float(value) for value in done.y[:, -1]], FLOATS.pi)


def derived_rates(motion: Motion) -> Any:
    """f(t, y) from the Lagrangian."""
    import sympy as sp
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    places = dynamicsymbols(f"q:{len(motion.start(FLOATS)) // 2}")
    speeds = [place.diff(dynamicsymbols._t) for place in places]
    assert motion.lagrangian is not None
    method = LagrangesMethod(motion.lagrangian(sp, places, speeds), places)
    method.form_lagranges_equations()
    letters = sp.symbols(f"y:{2 * len(places)}")
    replaced = dict(zip([*speeds, *places], [*letters[len(places) :], *letters[: len(places)]], strict=True))
    rates = sp.lambdify((sp.Symbol("t"), letters), list(method.rhs().xreplace(replaced)), modules="math", cse=True)
    return rates


INTEGRATORS = {
    **{
        f"scipy {method}": Way(("scipy",), "rtol = atol", TOLERANCES, partial(scipy, method=method))
        for method in METHODS
    },
    "mpmath odefun": Way(("mpmath",), "digits", ("15", "30"), mpmath),
    "heyoka": Way(("heyoka",), "tol", ("1e-6", "1e-9", "1e-12", "2.2e-16"), heyoka),
    "sympy + DOP853": Way(("sympy", "scipy"), "rtol = atol", ("1e-6", "1e-9", "1e-12"), sympy),
}
