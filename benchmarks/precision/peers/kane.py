"""Kane's equations by `sympy.physics.mechanics`, as its documentation has them for bodies in space, before scipy integrates them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..problem import Kane, Problem, Way
from .integrators import motion_of

Function = Callable[[Any, Any], Any]


def kane(problem: Problem, setting: str) -> list[float]:
    """`KanesMethod`, `lambdify` with common subexpressions, u̇ by `numpy.linalg.solve` at each call, DOP853."""
    import sympy as sp
    from scipy.integrate import solve_ivp
    from sympy.physics import mechanics

    build, tolerance = motion_of(problem).kane, float(setting)
    assert build is not None, problem.name
    model = build(sp, mechanics)
    rates, read = derived(model)
    done = solve_ivp(rates, (0, float(problem.until)), model.start, method="DOP853", rtol=tolerance, atol=tolerance)
    return [float(value) for value in read(done.y[:, -1])]


def derived(model: Kane) -> tuple[Function, Callable[[Any], list[float]]]:
    """f(t, y) of y = (places, speeds), and what is asked as a function of y."""
    import numpy as np
    import sympy as sp
    from sympy.physics.mechanics import KanesMethod

    method = KanesMethod(model.frame, model.places, model.speeds, kd_eqs=model.kinematics)
    method.kanes_equations(model.bodies, model.loads)
    letters = [*model.places, *model.speeds]
    given = method.kindiffdict()
    places = [given[place.diff()] for place in model.places]
    rate, read = (sp.lambdify([letters], part, modules="math", cse=True) for part in (places, model.asked))
    masses, forces = (method.mass_matrix, method.forcing.xreplace(given))
    system = sp.lambdify([letters], [masses.tolist(), list(forces)], modules="math", cse=True)

    def rates(time: Any, state: Any) -> Any:
        matrix, right = system(state)
        return [*rate(state), *np.linalg.solve(matrix, right)]

    return rates, read


KANE = {"sympy Kane + DOP853": Way(("sympy", "scipy"), "rtol = atol", ("1e-6", "1e-9", "1e-12"), kane)}
