"""Integrators on a motion that sticks and slips: one slip after another, each up to the event that its speed is 0."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from ..problem import FLOATS, Mathematics, Problem, Rates, Sticking, Way
from .integrators import INTEGRATORS, LONGEST, METHODS, TOLERANCES, motion_of

Slip = Callable[
    [Any, list[Any], int], tuple[Any, list[Any], bool]
]  # (time, state, sense) → time, state, whether it came to rest


def sticking_of(problem: Problem) -> Sticking:
    """The friction of a problem that has one."""
    sticking = motion_of(problem).sticking
    assert sticking is not None, problem.name
    return sticking


def alternate(problem: Problem, maths: Mathematics, slip: Slip) -> list[Any]:
    """What is asked after slip, rest, slip, …; each slip by `slip`, the end of each rest by its closed form."""
    sticking, until = sticking_of(problem), maths.number(problem.until)
    time, state = maths.number("0"), motion_of(problem).start(maths)
    while True:
        if not (sense := sticking.leaving(maths, time)):
            time, sense = sticking.breakaway(maths, time)
        at_rest = time < until
        if at_rest:
            time, state, at_rest = slip(time, state, sense)
        if not at_rest:
            return motion_of(problem).read(state, maths.pi)
        state = [state[0], maths.number("0")]


def solve_slips(problem: Problem, setting: str, method: str, rates: Callable[[int], Rates]) -> list[float]:
    """Each slip by `solve_ivp` with rtol = atol and a terminal event."""
    from scipy.integrate import solve_ivp

    until, tolerance = float(problem.until), float(setting)

    def slip(time: float, state: list[float], sense: int) -> tuple[float, list[float], bool]:
        def rest(time: float, state: Any) -> float:
            return float(sense * state[1])

        rest.terminal, rest.direction = True, -1  # type: ignore[attr-defined]
        done = solve_ivp(rates(sense), (time, until), state, method, rtol=tolerance, atol=tolerance, events=rest)
        return float(done.t[-1]), [float(value) for value in done.y[:, -1]], done.status == 1

    return alternate(problem, FLOATS, slip)


def scipy(problem: Problem, setting: str, method: str) -> list[float]:
    """The slips by `solve_ivp`, of the equations as they stand."""
    return solve_slips(problem, setting, method, partial(sticking_of(problem).slipping, FLOATS))


def sympy(problem: Problem, setting: str) -> list[float]:
    """The slips by Lagrange's equations of `sympy.physics.mechanics`, `lambdify` and DOP853."""
    import sympy as sp
    from sympy.physics.mechanics import LagrangesMethod, ReferenceFrame, dynamicsymbols

    motion, friction = motion_of(problem), sticking_of(problem)
    angle, time, sense = dynamicsymbols("q"), dynamicsymbols._t, sp.Symbol("s")
    speed = angle.diff(time)
    fixed, turning = ReferenceFrame("N"), ReferenceFrame("B")
    turning.orient_axis(fixed, fixed.z, angle)
    couple = friction.couple(sp, time, speed, sense)
    assert motion.lagrangian is not None, problem.name
    method = LagrangesMethod(
        motion.lagrangian(sp, [angle], [speed]), [angle], forcelist=[(turning, couple * fixed.z)], frame=fixed
    )
    method.form_lagranges_equations()
    letters = sp.symbols("y:2")
    moving = list(method.rhs().xreplace({speed: letters[1], angle: letters[0]}))
    rates = sp.lambdify((time, letters, sense), moving, modules="math", cse=True)
    return solve_slips(problem, setting, "DOP853", lambda sense: lambda time, state: rates(time, state, sense))


def mpmath(problem: Problem, setting: str) -> list[str]:
    """The slips by `odefun` with so many digits, their ends by `findroot`."""
    from mpmath import mp

    mp.dps = int(setting)
    friction, maths = sticking_of(problem), Mathematics(mp.mpf, mp.sin, mp.cos, mp.asin, +mp.pi)
    until, look = maths.number(problem.until), maths.number("0.05")

    def slip(time: Any, state: list[Any], sense: int) -> tuple[Any, list[Any], bool]:
        moving = mp.odefun(friction.slipping(maths, sense), time, state)
        late = time + look
        while late < until and sense * moving(late)[1] > 0:
            late += look
        if sense * moving(min(late, until))[1] > 0:
            return until, moving(until), False
        rest = mp.findroot(lambda instant: moving(instant)[1], (late - look, late), solver="anderson")
        return rest, moving(rest), True

    return [mp.nstr(value, mp.dps) for value in alternate(problem, maths, slip)]


def heyoka(problem: Problem, setting: str) -> list[float]:
    """`taylor_adaptive` with the sense as a parameter and a terminal event, which a step without events opens: there the speed is 0 too."""
    import heyoka as hy

    friction, until = sticking_of(problem), float(problem.until)
    letters = hy.make_vars("y0", "y1")
    rates = friction.slipping(FLOATS._replace(sin=hy.sin, cos=hy.cos), hy.par[0])(hy.time, letters)
    rest = hy.t_event(hy.par[0] * letters[1], direction=hy.event_direction.negative)
    system = list(zip(letters, rates, strict=True))
    options = {"tol": float(setting), "pars": [1.0]}
    opening = hy.taylor_adaptive(system, [0.0, 0.0], **options)
    integrator = hy.taylor_adaptive(system, [0.0, 0.0], t_events=[rest], **options)

    def slip(time: float, state: list[float], sense: int) -> tuple[float, list[float], bool]:
        opening.time, opening.state[:], opening.pars[0] = time, state, sense
        opening.step(max_delta_t=min(LONGEST / 10, until - time))
        integrator.time, integrator.state[:], integrator.pars[0] = opening.time, opening.state, sense
        integrator.reset_cooldowns()
        outcome = integrator.propagate_until(until, max_delta_t=LONGEST)[0]
        return integrator.time, list(integrator.state), outcome != hy.taylor_outcome.time_limit

    return [float(value) for value in alternate(problem, FLOATS, slip)]


OWN: dict[str, Callable[[Problem, str], list[Any]]] = {
    "mpmath odefun": mpmath,
    "heyoka": heyoka,
    "sympy + DOP853": sympy,
}
STICKING = {
    **{
        f"scipy {method}": Way(("scipy",), "rtol = atol", TOLERANCES, partial(scipy, method=method))
        for method in METHODS
    },
    **{name: INTEGRATORS[name]._replace(solve=solve) for name, solve in OWN.items()},
}
