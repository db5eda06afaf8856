"""Solving: the equations of a plan one unknown at a time, each elimination kept as a step."""

from rotsolve.solver.solver import ENTANGLED, Solver
from rotsolve.solver.step import Choice, Contradiction, Found, NoClosedForm, Redundant, Ref, Step

__all__ = ["ENTANGLED", "Choice", "Contradiction", "Found", "NoClosedForm", "Redundant", "Ref", "Solver", "Step"]
