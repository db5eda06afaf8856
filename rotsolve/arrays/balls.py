"""Balls: a program over balls, set by set: each result with a bound on its error that holds for certain."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import inf, nan, nextafter
from operator import add, mul, neg, sub, truediv
from typing import Any

import numpy as np

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.certified.balls import Ball
from rotsolve.algebra.certified.elliptic import OF_PARAMETER
from rotsolve.algebra.flints import acb, arb
from rotsolve.algebra.tape import BITS
from rotsolve.arrays import Program

FIRST = 80  # bits; a double has 53: what is lost on the way to a result seldom shows in it
ACCURATE = 50  # bits to which a result is known well enough
MORE = (200, BITS)  # bits where too much is lost
METHODS: Mapping[str, Callable[..., Any]] = {
    "add": add,
    "subtract": sub,
    "multiply": mul,
    "divide": truediv,
    "negative": neg,
    "power": pow,
    "abs": abs,
    "atan2": arb.atan2,
    "ellipk": lambda x: acb(x).elliptic_k().real if x < 1 else arb(nan),
    **OF_PARAMETER,
    **{name: getattr(arb, name) for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log")},
}


class Evaluator:
    """A program at one precision: its constants as balls, its operations as functions."""

    def __init__(self, program: Program, names: Sequence[str], bits: int) -> None:
        self.bits = bits
        self.results = program.results
        self.places: list[Ball] = [None] * len(program.operations)
        self.letters: list[tuple[int, int]] = []
        self.steps: list[tuple[int, Callable[..., Any], tuple[int, ...]]] = []
        for place, item in enumerate(program.operations):
            if item.kind == "letter":
                self.letters.append((place, names.index(item.name)))
            elif item.kind == "number":
                with Precision(bits):
                    self.places[place] = +arb(item.numbers[0])
            else:
                self.steps.append((place, METHODS[item.kind], item.values))

    def balls(self, row: Sequence[float]) -> list[Ball]:
        """The results for one set of inputs; not a number where an operation is not defined."""
        places = self.places
        for place, column in self.letters:
            places[place] = arb(row[column])
        for place, function, operands in self.steps:
            if len(operands) == 2:
                places[place] = function(places[operands[0]], places[operands[1]])
            elif len(operands) == 1:
                places[place] = function(places[operands[0]])
            else:
                places[place] = function(*[places[operand] for operand in operands])
        return [places[place] for place in self.results]


def ball_results(program: Program, values: Mapping[str, Any], bounds: int) -> list[tuple[Any, Any]]:
    """The results with their errors for all sets of values, which are taken as exact; NaN where a bound may be negative."""
    inputs = [np.asarray(column, dtype=np.float64) for column in values.values()]
    shape = np.broadcast_shapes(*(item.shape for item in inputs))
    rows = zip(*(np.broadcast_to(item, shape).reshape(-1).tolist() for item in inputs), strict=True)
    wanted = len(program.results) - bounds
    first, *others = (Evaluator(program, tuple(values), bits) for bits in (FIRST, *MORE))
    found: list[float] = []
    with Precision(FIRST):
        for row in rows if inputs else [()]:
            balls = first.balls(row)
            if not all(map(close_enough, balls)):
                balls = more_closely(row, balls, others)
            holds = all(ball >= 0 for ball in balls[wanted:])
            for ball in balls[:wanted]:
                found += nearest_double(ball) if holds else (nan, inf)
    table = np.array(found).reshape(-1, wanted, 2)
    return [(table[:, index, 0].reshape(shape), table[:, index, 1].reshape(shape)) for index in range(wanted)]


def more_closely(row: Sequence[float], balls: list[Ball], evaluators: Iterable[Evaluator]) -> list[Ball]:
    """The results at higher precisions, until all are known as closely as a double."""
    for evaluator in evaluators:
        with Precision(evaluator.bits):
            balls = evaluator.balls(row)
        if all(map(close_enough, balls)):
            break
    return balls


def close_enough(ball: Ball) -> bool:
    return bool(ball.rel_accuracy_bits() >= ACCURATE or ball.is_zero())


def nearest_double(ball: Ball) -> tuple[float, float]:
    """The nearest double, and how far at most the value is from it."""
    if not ball.is_finite():
        return nan, inf
    middle = float(ball)
    return middle, nextafter(float((ball - middle).abs_upper()), inf)
