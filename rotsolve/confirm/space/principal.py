"""Principal moments and axes of a tensor in numbers, by Jacobi's turns: each makes one product of inertia nothing."""

from __future__ import annotations

import math

from rotsolve.confirm.space.arrows import ALONG, Arrow, Turned, product_of, rotation_about, seen_from

SWEEPS = 12
NOTHING = 1e-16  # of the largest entry


def moments_and_axes(tensor: Turned) -> list[tuple[float, Arrow]]:
    """The moments from the smallest on, each with a unit vector along its axis."""
    turn = ALONG
    size = max(abs(part) for row in tensor for part in row)
    for _ in range(SWEEPS):
        for axis, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
            if abs(tensor[i][j]) > NOTHING * size:
                angle = 0.5 * math.atan2(2.0 * tensor[i][j], tensor[i][i] - tensor[j][j])
                if abs(angle) > 0.25 * math.pi:  # of both turns the smaller: with the other they may never end
                    angle -= math.copysign(0.5 * math.pi, angle)
                step = rotation_about(ALONG[axis], -angle)
                tensor, turn = seen_from(step, tensor), product_of(step, turn)
        if all(abs(tensor[i][j]) <= NOTHING * size for i, j in ((0, 1), (1, 2), (2, 0))):
            break
    return sorted((tensor[k][k], turn[k]) for k in range(3))
