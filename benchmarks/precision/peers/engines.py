"""Engines that step bodies through time: MuJoCo and pymunk."""

from __future__ import annotations

from typing import Any

from ..problem import FLOATS, Problem, PymunkModel, Way
from .integrators import motion_of


def mujoco(problem: Problem, setting: str) -> list[float]:
    """RK4 with a fixed step; where something drives, it is asked at every stage of a step."""
    import mujoco as mj

    motion = motion_of(problem)
    model, data = mujoco_start(problem, setting)
    kind = motion.mujoco
    assert kind is not None, problem.name
    if (drive := kind.control) is not None:

        def control(model: mj.MjModel, data: mj.MjData) -> None:
            data.ctrl[0] = drive(data.time)

        mj.set_mjcb_control(control)
    mj.mj_step(model, data, nstep=round(float(problem.until) / float(setting)))
    mj.set_mjcb_control(None)
    return motion.read([*kind.leave(data.qpos.tolist()), *kind.leave(data.qvel.tolist())], FLOATS.pi)


def mujoco_start(problem: Problem, setting: str) -> tuple[Any, Any]:
    """The model with its time step, and its data at the start."""
    import mujoco as mj

    motion = motion_of(problem)
    kind, start = motion.mujoco, motion.start(FLOATS)
    assert kind is not None, problem.name
    model = mj.MjModel.from_xml_string(kind.xml.format(step=setting))
    data, half = mj.MjData(model), len(start) // 2
    data.qpos[:], data.qvel[:] = kind.enter(start[:half]), kind.enter(start[half:])
    return model, data


def mujoco_in_space(problem: Problem, setting: str) -> list[float]:
    """The same for a body that turns about any axis, of which its rotation and its angular velocity are read at the end."""
    import mujoco as mj

    kind = motion_of(problem).turned
    assert kind is not None, problem.name
    model = mj.MjModel.from_xml_string(kind.xml.format(step=setting))
    data = mj.MjData(model)
    data.qpos[:], data.qvel[:] = kind.places, kind.speeds
    mj.mj_step(model, data, nstep=round(float(problem.until) / float(setting)))
    mj.mj_kinematics(model, data)  # a step leaves the rotation of its start
    return kind.read(data.xmat[1].reshape(3, 3).tolist(), data.qvel[-3:].tolist())


def pymunk(problem: Problem, setting: str) -> list[float]:
    """Semi-implicit Euler steps, joints by 30 iterations of impulses and without a lag in what they correct."""
    motion, step = motion_of(problem), float(setting)
    kind, space, bodies = pymunk_start(problem)
    for number in range(round(float(problem.until) / step)):
        if kind.push is not None:
            kind.push(bodies, number * step)
        space.step(step)
    return motion.read(kind.leave(bodies), FLOATS.pi)


def pymunk_start(problem: Problem) -> tuple[PymunkModel, Any, list[Any]]:
    """The model, and a space with its bodies at the start."""
    import pymunk as pm

    motion = motion_of(problem)
    kind, space = motion.pymunk, pm.Space()
    assert kind is not None, problem.name
    space.gravity, space.iterations = (0, -9.8), 30
    return kind, space, kind.build(pm, space, motion.start(FLOATS))


MUJOCO = {"MuJoCo RK4": Way(("mujoco",), "step", ("1e-2", "1e-3", "1e-4"), mujoco)}
MUJOCO_IN_SPACE = {"MuJoCo RK4": MUJOCO["MuJoCo RK4"]._replace(solve=mujoco_in_space)}
PYMUNK = {"pymunk": Way(("pymunk",), "step", ("1e-2", "1e-3", "1e-4", "1e-5"), pymunk)}
ENGINES = MUJOCO | PYMUNK
