"""Unheld: the rates of bodies that nothing holds and nothing but their weight acts on, written out.

I α = I ω × ω about each centre of mass, which falls with g. The equations of a rig say the same, but set up and eliminated at every look
they take some seven times as long: on the way of a body that tumbles for long that is most of a run.
"""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.confirm.space.arrows import Arrow, Turned, crossed, inner_product, rows_back, scaled, times_arrow
from rotsolve.confirm.space.efforts import DOWN
from rotsolve.confirm.space.principal import moments_and_axes
from rotsolve.confirm.space.rig import THIN, Rig

Gains = Callable[[str, Turned, Arrow], tuple[Arrow, Arrow]]


def gains_unheld(rig: Rig) -> Gains | None:
    """α and the acceleration of the centre of mass by the name of a body, its rotation and ω; None where anything holds or drives one, or
    a body has no inertia about some axis."""
    problem = rig.problem
    if problem.connections or problem.actions or any(body.moved for body in rig.bodies.values()):
        return None
    tensors: dict[str, Turned] = {}
    inverses: dict[str, Turned] = {}
    for name in rig.bodies:
        own = rig.solid(name)
        moments = [moment for moment, _ in moments_and_axes(own.tensor)]
        if own.mass <= 0.0 or min(moments) <= THIN * max(moments):
            return None
        tensors[name], inverses[name] = own.tensor, inverted_tensor(own.tensor)
    fall = scaled(rig.gravity, DOWN)

    def gains(name: str, rows: Turned, omega: Arrow) -> tuple[Arrow, Arrow]:
        own = times_arrow(rows_back(rows), omega)  # in the body's own axes, in which its tensor stays
        gain = times_arrow(inverses[name], crossed(times_arrow(tensors[name], own), own))
        return times_arrow(rows, gain), fall

    return gains


def inverted_tensor(rows: Turned) -> Turned:
    """The inverse of a tensor, I⁻¹, by the cross products of its rows."""
    a, b, c = rows
    first, second, third = crossed(b, c), crossed(c, a), crossed(a, b)
    size = inner_product(a, first)
    return scaled(1.0 / size, first), scaled(1.0 / size, second), scaled(1.0 / size, third)
