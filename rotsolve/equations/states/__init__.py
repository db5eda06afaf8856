"""States: what the states of a scene fix, and what stays as it was from one to the next."""

from rotsolve.equations.states.fixed import Fixed
from rotsolve.equations.states.statements import Statements

__all__ = ["Fixed", "Statements"]
