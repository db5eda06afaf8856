"""The tension of the string on a block of 10⁶ kg that hangs from a disc of 10⁻⁶ kg and 0.2 m: three linear equations."""

from __future__ import annotations

from typing import Any

from ..problem import Problem, Way

MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable"/></option>
  <default><equality solref="{step} 1" solimp="0.9999 0.9999 0.001 0.5 2"/></default>
  <worldbody>
    <body>
      <joint name="block" type="slide" axis="0 0 -1"/>
      <inertial pos="0 0 0" mass="1e6" diaginertia="1 1 1"/>
    </body>
    <body>
      <joint name="disc" type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0" mass="1e-6" diaginertia="1e-8 2e-8 1e-8"/>
    </body>
  </worldbody>
  <equality><joint joint1="block" joint2="disc" polycoef="0 0.2 0 0 0"/></equality>
</mujoco>"""


def newton(number: Any) -> tuple[list[list[Any]], list[Any]]:
    """m a + T = m g,  I α − R T = 0,  a − R α = 0, for a, α, T."""
    mass, inertia, radius, gravity = (number(text) for text in ("1000000", "0.00000002", "0.2", "9.8"))
    zero, one = number("0"), number("1")
    rows = [[mass, zero, one], [zero, inertia, -radius], [one, -radius, zero]]
    return rows, [mass * gravity, zero, zero]


def numpy(problem: Problem, setting: str) -> list[float]:
    """`numpy.linalg.solve` in double precision."""
    import numpy as np

    return [float(np.linalg.solve(*newton(float))[2])]


def scipy(problem: Problem, setting: str) -> list[float]:
    """`scipy.linalg.solve` in double precision."""
    from scipy.linalg import solve

    return [float(solve(*newton(float))[2])]


def mpmath(problem: Problem, setting: str) -> list[str]:
    """`mpmath.lu_solve` with so many digits."""
    from mpmath import mp

    mp.dps = int(setting)
    rows, right = newton(mp.mpf)
    return [mp.nstr(mp.lu_solve(mp.matrix(rows), mp.matrix(right))[2], mp.dps)]


def sympy(problem: Problem, setting: str) -> list[str]:
    """`sympy.solve` on exact numbers, then so many digits."""
    import sympy as sp

    letters = sp.symbols("a alpha T")
    rows, right = newton(sp.Rational)
    equations = [
        sum((factor * letter for factor, letter in zip(row, letters, strict=True)), -value)
        for row, value in zip(rows, right, strict=True)
    ]
    return [str(sp.solve(equations, letters)[letters[2]].evalf(int(setting)))]


def mechanics(problem: Problem, setting: str) -> list[float]:
    """Lagrange's equations of `sympy.physics.mechanics` with a multiplier for the string, by `lambdify`."""
    import numpy as np
    import sympy as sp
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    way, angle = dynamicsymbols("x theta")
    speed, turning = (place.diff(dynamicsymbols._t) for place in (way, angle))
    mass, inertia, radius, gravity = sp.symbols("m I R g")
    energy = mass * speed**2 / 2 + inertia * turning**2 / 2 + mass * gravity * way
    method = LagrangesMethod(energy, [way, angle], hol_coneqs=[way - radius * angle])
    method.form_lagranges_equations()
    letters = (mass, inertia, radius, gravity)
    matrix, forcing = (
        sp.lambdify(letters, part.subs({speed: 0, turning: 0}))
        for part in (method.mass_matrix_full, method.forcing_full)
    )
    values = (1e6, 2e-8, 0.2, 9.8)
    return [abs(float(np.linalg.solve(matrix(*values), forcing(*values))[-1, 0]))]


def mujoco(problem: Problem, setting: str) -> list[float]:
    """The couple that the equality exerts on the disc, over its radius, when the string has just been let go."""
    import mujoco as mj

    model = mj.MjModel.from_xml_string(MODEL.format(step=setting))
    data = mj.MjData(model)
    mj.mj_forward(model, data)
    return [float(data.qfrc_constraint[1]) / 0.2]


LINEAR = {
    "numpy.linalg": Way(("numpy",), "double", ("53 bits",), numpy),
    "scipy.linalg": Way(("scipy",), "double", ("53 bits",), scipy),
    "mpmath lu_solve": Way(("mpmath",), "digits", ("15", "30", "50"), mpmath),
    "sympy solve": Way(("sympy",), "digits", ("15", "30", "50"), sympy),
    "sympy mechanics": Way(("sympy", "numpy"), "double", ("53 bits",), mechanics),
    "MuJoCo": Way(("mujoco",), "step", ("1e-2", "1e-4"), mujoco),
}
