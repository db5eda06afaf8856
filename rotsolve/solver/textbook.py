"""Textbook form: what is found put in, integrals carried out, products in their usual order."""

from __future__ import annotations

from collections.abc import Mapping

from rotsolve.algebra.calculus import integrate
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Call, Formula, Integral
from rotsolve.core.heading import heading
from rotsolve.solver.step import Found


def quarters_turned(value: Formula) -> Formula:
    """A formula with quarter turns taken out of its sines and cosines: sin(φ + π/2) is cos φ."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Call) or node.function not in ("sin", "cos"):
            return node
        turn = heading(node.arguments[0])
        if not turn.degrees or turn.degrees % 90 or not turn.terms:
            return node
        return turn.sin() if node.function == "sin" else turn.cos()

    return value.transform(change)


class Textbook:
    """Formulas as a textbook writes them, by the order of the letters, the signs of the givens and the answers found so far."""

    order: tuple[str, ...]
    positive: frozenset[str]
    values: Mapping[str, Formula]
    solved: dict[str, Found]

    def simplify(self, value: Formula) -> Formula:
        """Textbook form; bars round a value whose sign the numbers tell are taken off."""
        value = simplify(value, order=self.order, positive=self.positive)
        if any(isinstance(node, Call) and node.function == "abs" for node in value.walk()):
            value = simplify(value.transform(self._without_bars), order=self.order, positive=self.positive)
        return value

    def _without_bars(self, node: Formula) -> Formula:
        """|x| as x or −x where the numbers tell its sign."""
        if not (isinstance(node, Call) and node.function == "abs"):
            return node
        try:
            sign = evaluate(self.with_answers(node.arguments[0]), self.values, digits=3).sign
        except (Undefined, ValueError):
            return node
        return node.arguments[0] * sign if sign is not None else node

    def with_answers(self, value: Formula) -> Formula:
        """Answers found before put in."""
        known = {name: found.formula for name, found in self.solved.items() if found.formula is not None}
        used = {name: known[name] for name in value.symbols() if name in known}
        return value.substitute(used) if used else value

    def carried_out(self, value: Formula) -> Formula:
        """All integrals in closed form where there is one."""

        def change(node: Formula) -> Formula:
            if not isinstance(node, Integral):
                return node
            done = integrate(node.integrand, node.variable, node.lower, node.upper, positive=self.positive)
            return node if done is None else self.simplify(done)

        return value.transform(change)
