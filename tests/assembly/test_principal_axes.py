"""Principal moments and axes in the assembly, against numpy's, also of tensors whose diagonal is the same all along."""

from __future__ import annotations

import random

import numpy as np
import pytest

from rotsolve.confirm.space.principal import moments_and_axes


@pytest.mark.parametrize("alike", [True, False])
def test_they_are_eigenvalues_and_eigenvectors(alike: bool) -> None:
    chance = random.Random(7)
    for _ in range(400):
        tensor = np.diag([4.0 if alike else chance.uniform(1, 9) for _ in range(3)])
        for i, j in ((0, 1), (1, 2), (2, 0)):
            tensor[i, j] = tensor[j, i] = chance.choice((0.0, 0.5, -0.5, 1.0, -1.0, chance.uniform(-2, 2)))
        a, b, c = (tuple(map(float, row)) for row in tensor)
        found = moments_and_axes(((a[0], a[1], a[2]), (b[0], b[1], b[2]), (c[0], c[1], c[2])))
        assert [moment for moment, _ in found] == pytest.approx(list(np.linalg.eigvalsh(tensor)), abs=1e-12)
        for moment, axis in found:
            assert tensor @ np.array(axis) == pytest.approx(moment * np.array(axis), abs=1e-12)
