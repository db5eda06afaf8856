"""Euler rules: how a body that stands by its Euler angles turns, where a state tells ω₃, the parts of ω, or an extreme of its tilt."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import PI, ZERO
from rotsolve.core.equation import RULE, Equation
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import AXES
from rotsolve.core.writing import spoken
from rotsolve.space.attitude import NODE
from rotsolve.space.laws import NODE_NAMES, SpaceLaws


def axial_rules(dynamics: SpaceLaws) -> Iterator[Equation]:
    """ω₃ = ψ̇ + φ̇ cos θ, where the state tells ω₃."""
    moment = dynamics.moment
    for name in moment.held.order:
        if not moment.nods(name) or moment.told(name, "spin") is not None:
            continue
        if moment.axes(name).name == NODE or moment.told(name, "axial_rate") is not None:
            turning = moment.nodding(name)
            along = turning.rates[2] + turning.rates[0] * heading(turning.angles[1]).cos()
            words = "ω₃ = ψ̇ + φ̇ cos θ"
            yield RULE.equation(moment.ask("axial_rate", name), along, moment.when, (name,), words=words)


def turning_rules(dynamics: SpaceLaws) -> Iterator[Equation]:
    """How a body turns that stands by its Euler angles, where the state tells the components of its angular velocity, or their rates."""
    moment = dynamics.moment
    for name in filter(moment.nods, moment.held.order):
        if moment.extreme_tilt(name) and moment.told(name, "nutation") is None:
            words = f"{spoken(name)} nods no more where its tilt is an extreme"
            yield RULE.equation(moment.ask("nutation", name), ZERO, moment.when, (name,), words=words)
        if moment.nodding(name).angles[1] in (ZERO, PI):  # upright, the rates of its Euler angles do not tell any ω
            continue
        for word in ("angular_velocity", "angular_acceleration"):
            told = moment.vector_told(name, word)
            if told is None:
                continue
            attitude, (vector, named, _) = moment.attitude(name), told
            own = attitude.omega if word == "angular_velocity" else attitude.alpha
            parts = moment.named_axes(named, name).to(attitude.axes, vector)
            for axis, turns, part in zip(AXES, own, parts, strict=True):
                words = f"{spoken(word)} of {spoken(name)}, along {NODE_NAMES[axis] if attitude.axes.name == NODE else axis}"
                yield RULE.equation(turns, part, moment.when, (name,), words=words)
