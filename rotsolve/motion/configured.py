"""Configured: a problem that has been read, made ready for the laws; refused where a value in it can not be."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.language.problem import Problem
from rotsolve.motion.checks.varying import check_values
from rotsolve.motion.complete import completed
from rotsolve.motion.configuration import Configuration


def configured(problem: Problem) -> Configuration:
    """The problem with letters for what it leaves out; refused where a value in it can not be."""
    try:
        configuration = Configuration(completed(problem))
        check_values(configuration)
    except Unsolvable as error:
        fault = error.fault
        raise Unsolvable(
            fault.message, span=fault.span, help=fault.help, lines=problem.lines, file=problem.file
        ) from None
    faults = list(negative_inertia(configuration.problem))
    if faults:
        raise SceneError(faults, problem.lines, problem.file)
    return configuration


def negative_inertia(problem: Problem) -> Iterator[Fault]:
    """Moments of inertia given about a point that are smaller than m d² alone."""
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    for body in problem.bodies:
        if body.inertia is None or body.inertia_about is None or body.inertia.symbols() - set(values):
            continue
        sign = evaluate(body.inertia, values, digits=3).sign
        if sign is not None and sign < 0:
            message = f"the inertia of `{body.name}` about `{body.inertia_about}` is smaller than m d², its mass at its centre of mass"
            yield Fault(message, body.span, "", "limits")
