"""Sliding: what slides freely along a body that turns: Newton's laws with the rate at which its distance grows, and its way in time.

Across the body N = m (r α + 2 ω v): the second part is what Coriolis' force asks. About the axis I α + 2 m r v ω = τ, since I grows. On
what is driven steadily r̈ = ω² r, so that r = r₁ cosh ωt + (v₁/ω) sinh ωt.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, add, call, divide, multiply
from rotsolve.algebra.notation.derived import cosh, sinh
from rotsolve.core.derivation import Words
from rotsolve.core.equation import ACROSS, ALONG_TURNING, ROTATION, Equation
from rotsolve.core.facts import BodyFacts, Slider, signed
from rotsolve.core.writing import law, spoken
from rotsolve.laws.newton import about, response, torques
from rotsolve.laws.table import AtMoment, OverPhase
from rotsolve.laws.turning_frame import disturbed, turned_steadily

GROWS = ("I grows at the rate 2 m r v",)
GROWN = ("ω r + v grows as e^(ω t)",)
CORIOLIS = ("r α, and 2 ω v of what goes out at v",)


def across_what_turns(at: AtMoment) -> Iterator[Equation]:
    """N = m (r α + 2 ω v) across, and I α + 2 m r v ω = τ about the axis."""
    for body in at.facts.bodies:
        if not body.sliding or body.drawn or body.motion.kind != "axis":
            continue
        for item in body.sliding:
            if item.push is None:
                continue
            pushes = [
                item.push,
                *(force.vector.along(item.outward.turned(90)) for force in body.forces if force.part == item.name),
            ]
            turning = item.place * body.motion.spin_rate + 2 * body.motion.spin * item.speed
            left, right = law([push for push in pushes if push != ZERO], multiply(item.mass, turning))
            rider, carrier = spoken(item.name), spoken(body.name)
            yield ACROSS.equation(left, right, at.section, (body.name,), CORIOLIS, rider=rider, carrier=carrier)
        grown = [signed(momentum_gained(item, body), body.motion.sense) for item in body.sliding]
        left, right = law(torques(body), sum(grown, start=response(body)))
        yield ROTATION.equation(left, right, at.section, (body.name,), GROWS, about=about(body))


def momentum_gained(item: Slider, body: BodyFacts) -> Formula:
    """2 m r v ω, by which angular momentum grows since I does."""
    return 2 * item.mass * item.place * item.speed * body.motion.spin


def along_what_is_driven(over: OverPhase) -> Iterator[Equation]:
    """r₂ = r₁ cosh ωt + (v₁/ω) sinh ωt and v₂ = ω r₁ sinh ωt + v₁ cosh ωt, and t by both: ω r + v grows as e^(ωt)."""
    passage = over.passage
    for body in passage.midst.bodies:
        ends = [turned_steadily(body.name, facts) for facts in (passage.start, passage.end)]
        alone = frozenset((body.name,)) in passage.groups and not passage.midst.potentials
        if not body.sliding or body.drawn or None in ends or not alone or disturbed(body, passage):
            continue
        riders = zip(*(end.sliding for end in ends if end is not None), strict=True)
        for first, last in riders:
            for left, right, said in slid_in_time(first, last, body.motion.spin, passage.duration):
                rider, carrier = spoken(first.name), spoken(body.name)
                yield ALONG_TURNING.equation(
                    left, right, over.section, (body.name,), said, rider=rider, carrier=carrier
                )


def slid_in_time(first: Slider, last: Slider, rate: Formula, time: Formula) -> Iterator[tuple[Formula, Formula, Words]]:
    """Place and speed after a time; and the time by both, (1/ω) ln((ω r₂ + v₂)/(ω r₁ + v₁))."""
    passed = multiply(rate, time)
    wide, high = cosh(passed), sinh(passed)
    yield last.place, add(first.place * wide, divide(first.speed, rate) * high), ()
    yield last.speed, add(rate * first.place * high, first.speed * wide), ()
    before, after = (add(rate * one.place, one.speed) for one in (first, last))
    if not is_zero(before):
        yield time, divide(call("log", divide(after, before)), rate), GROWN
