"""Unsolvable: a message with its place in the file."""

from __future__ import annotations

from rotsolve.core.faults import Span, Unsolvable
from rotsolve.language.problem import Problem

CHECK_DATA = "check the givens and what the states say"


def unsolvable(problem: Problem, message: str, span: Span | None = None, help: str = "") -> Unsolvable:
    """A message with its place in the file."""
    return Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)
