"""Simulation: a scene as it moves in time, by the equations of motion that its own laws make."""

from rotsolve.simulation.simulating import Run, simulate

__all__ = ["Run", "simulate"]
