"""The period of a pendulum from rest: by its elliptic integral, or as four times the time up to where it hangs, φ = π."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

from ..problem import FLOATS, Problem, Way
from .engines import mujoco_start, pymunk_start
from .integrators import FEW, LONGEST, METHODS, derived_rates, motion_of

TOO_LATE = 100.0  # s: no quarter of a period lasts so long
SMALL_SWINGS = 4 / math.sqrt(9.8)  # 4/ω₀: T = (4/ω₀) K


def half_angle_from_upright(problem: Problem) -> float:
    """φ₀/2; cos²(θ₀/2) = sin²(φ₀/2) loses nothing near the upright position, where 1 − sin²(θ₀/2) would."""
    return float(motion_of(problem).start(FLOATS)[0]) / 2


def ellipkm1(problem: Problem, setting: str) -> list[float]:
    """scipy.special.ellipkm1, K by its complementary parameter."""
    from scipy.special import ellipkm1

    return [SMALL_SWINGS * float(ellipkm1(math.sin(half_angle_from_upright(problem)) ** 2))]


def scipy(problem: Problem, setting: str, method: str, rates: Any = None) -> list[float]:
    """`solve_ivp` by a method, with rtol = atol and a terminal event."""
    from scipy.integrate import solve_ivp

    def hangs(time: float, state: Any) -> float:
        return float(state[0]) - math.pi

    hangs.terminal = True  # type: ignore[attr-defined]
    motion, tolerance = motion_of(problem), float(setting)
    rates, start = rates or motion.rates(FLOATS), motion.start(FLOATS)
    done = solve_ivp(rates, (0, TOO_LATE), start, method, rtol=tolerance, atol=tolerance, events=hangs)
    return [4 * float(done.t_events[0][0])]


def sympy(problem: Problem, setting: str) -> list[float]:
    """Lagrange's equation by `sympy.physics.mechanics`, `lambdify` and DOP853."""
    return scipy(problem, setting, "DOP853", derived_rates(motion_of(problem)))


def elliptic_k(problem: Problem, setting: str) -> list[str]:
    """`sympy.elliptic_k` to so many digits."""
    import sympy as sp

    angle = motion_of(problem).start(FLOATS._replace(number=sp.Rational, pi=sp.pi))[0]
    return [str((4 / sp.sqrt(sp.Rational("9.8")) * sp.elliptic_k(sp.cos(angle / 2) ** 2)).evalf(int(setting)))]


def ellipk(problem: Problem, setting: str) -> list[str]:
    """`mpmath.ellipk` with so many digits."""
    from mpmath import mp

    mp.dps = int(setting)
    return [mp.nstr(4 / mp.sqrt(mp.mpf("9.8")) * mp.ellipk(mp.cos(high_angle(problem, mp) / 2) ** 2), mp.dps)]


def quad(problem: Problem, setting: str) -> list[str]:
    """`mpmath.quad` of 1/√(cos² ψ + k′² sin² ψ) with so many digits, split where it is steep."""
    from mpmath import mp

    mp.dps = int(setting)
    steep = mp.sin(high_angle(problem, mp) / 2)  # k′
    # From the far end, ψ = 0 there: 1/√(sin² ψ + k′² cos² ψ), steep within k′ of it.
    places = [mp.mpf(0), *(steep * 4**power for power in range(60) if steep * 4**power < 1), mp.pi / 2]
    return [
        mp.nstr(
            4 / mp.sqrt(mp.mpf("9.8")) * mp.quad(lambda psi: 1 / mp.hypot(mp.sin(psi), steep * mp.cos(psi)), places),
            mp.dps,
        )
    ]


def high_angle(problem: Problem, mp: Any) -> Any:
    """φ₀ in mpmath."""
    return motion_of(problem).start(FLOATS._replace(number=mp.mpf, pi=+mp.pi))[0]


def heyoka(problem: Problem, setting: str) -> list[float]:
    """`taylor_adaptive` with a terminal event."""
    import heyoka as hy

    motion = motion_of(problem)
    letters = hy.make_vars("y0", "y1")
    rates = motion.rates(FLOATS._replace(sin=hy.sin, cos=hy.cos))(hy.time, letters)
    hangs = hy.t_event(letters[0] - math.pi)
    system = list(zip(letters, rates, strict=True))
    integrator = hy.taylor_adaptive(system, motion.start(FLOATS), tol=float(setting), t_events=[hangs])
    integrator.propagate_until(TOO_LATE, max_delta_t=LONGEST)
    return [4 * float(integrator.time)]


def passage(step: float, before: tuple[float, float], after: tuple[float, float]) -> float:
    """How far into a step φ = π, by the cubic through both ends and their slopes (bisected)."""
    (start, slope), (end, last) = ((angle - math.pi, speed * step) for angle, speed in (before, after))

    def place(share: float) -> float:
        rest = 1 - share
        ends = start * (1 + 2 * share) * rest * rest + end * (3 - 2 * share) * share * share
        return ends + slope * share * rest * rest - last * share * share * rest

    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if place(middle) < 0 else (low, middle)
    return high * step


def mujoco(problem: Problem, setting: str) -> list[float]:
    """RK4 steps up to where φ passes π, interpolated by a cubic."""
    import mujoco as mj

    model, data = mujoco_start(problem, setting)
    step, before = float(setting), (0.0, 0.0)
    while data.qpos[0] < math.pi and data.time < TOO_LATE:
        before = (data.qpos[0], data.qvel[0])
        mj.mj_step(model, data)
    return [4 * (data.time - step + passage(step, before, (data.qpos[0], data.qvel[0])))]


def pymunk(problem: Problem, setting: str) -> list[float]:
    """Steps up to where φ passes π, interpolated by a cubic."""
    kind, space, bodies = pymunk_start(problem)
    step, number = float(setting), 0
    state = before = kind.leave(bodies)
    while state[0] < math.pi and number * step < TOO_LATE:
        space.step(step)
        number += 1
        before, state = state, kind.leave(bodies)
    return [4 * ((number - 1) * step + passage(step, (before[0], before[1]), (state[0], state[1])))]


PERIODS = {
    "scipy ellipkm1": Way(("scipy",), "double", ("53 bits",), ellipkm1),
    **{f"scipy {method}": Way(("scipy",), "rtol = atol", FEW, partial(scipy, method=method)) for method in METHODS},
    "mpmath ellipk": Way(("mpmath",), "digits", ("15", "30", "50"), ellipk),
    "mpmath quad": Way(("mpmath",), "digits", ("15", "30"), quad),
    "sympy elliptic_k": Way(("sympy",), "digits", ("15", "30", "50"), elliptic_k),
    "sympy + DOP853": Way(("sympy", "scipy"), "rtol = atol", FEW, sympy),
    "heyoka": Way(("heyoka",), "tol", ("1e-6", "2.2e-16"), heyoka),
    "MuJoCo RK4": Way(("mujoco",), "step", ("1e-2", "1e-3"), mujoco),
    "pymunk": Way(("pymunk",), "step", ("1e-2", "1e-4"), pymunk),
}
