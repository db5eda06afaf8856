"""States: what the scene says of each named instant, in words."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import PI, Formula, Number
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Words
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.vectors.heading import heading
from rotsolve.core.writing import spoken
from rotsolve.language.problem import State


def state_words(state: State, bare: str) -> Words:
    """What the scene says of a state, on one line; `bare` where it says nothing."""
    parts = []
    for line in state.conditions:
        if line.rest:
            parts.append("at rest" if line.owner in ("", "all") else f"{spoken(line.owner)} at rest")
        elif line.path is not None:
            value = stated(line.value) if line.value is not None else line.word or ""
            owner = spoken(".".join(part for part in (line.path.owner, line.path.point) if part))
            quantity, component = spoken(line.path.quantity), line.path.component or ""
            said = OSCILLATING.get(line.path.quantity)
            what = f"{said} of small swings" if said else quantity
            kind, axis = ("", component) if component in ("x", "y") else (component, "")
            parts.append(" ".join(word for word in (owner, kind, what, axis, value) if word))
    parts += [word for word, so in (("in balance", state.balance), ("steady", state.steady)) if so]
    return (f"{spoken(state.name)}: " + (", ".join(parts) if parts else bare),)


def stated(value: Formula) -> str:
    """A value as a state says it: angles that are multiples of π in degrees."""
    turned = heading(value)
    if not turned.degrees:
        return to_text(value)
    if not turned.terms:
        return f"{turned.degrees}°".replace("-", "−")
    rest = to_text(simplify(value - Number(Fraction(turned.degrees, 180)) * PI))
    if rest.startswith("−") and turned.degrees > 0:
        return f"{turned.degrees}° − {rest[1:]}"
    return f"{rest} {'−' if turned.degrees < 0 else '+'} {abs(turned.degrees)}°"
