"""A second route to every answer of problems/space: calculations from the scene's numbers, which share no code with rotsolve.

What a calculation takes are the givens in SI units, what it returns the answers by their names under `find`, in the units of the file:
numbers, vectors, tensors, or words.
"""

from __future__ import annotations

from second_route import (
    bearings,
    events,
    free_bodies,
    linkages,
    rolling,
    tensors,
    tops,
    turning_frames,
    turns,
    turntables,
)

MODULES = (bearings, events, free_bodies, linkages, rolling, tensors, tops, turning_frames, turns, turntables)
CALCULATIONS = {name: calculation for module in MODULES for name, calculation in module.CALCULATIONS.items()}
