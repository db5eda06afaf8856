"""Simulation: a scene as it moves in time, by the equations of motion that its own laws make."""

from rotsolve.simulation.run import Run
from rotsolve.simulation.simulating import simulate

__all__ = ["Run", "simulate"]
