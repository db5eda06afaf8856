"""Letters that are asked for lie where their keys let them be, in numbers and in letters; asked friction is against the motion."""

from __future__ import annotations

import pytest

from rotsolve.algebra.notation.text import to_text
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

SLOWED = """
title: A block slides to rest
given: {{m: 2 kg, u: {u}, d: {d}, mu: unknown}}
surfaces: {{ramp: {{slope: 20 deg, down: left}}}}
bodies: {{box: {{mass: m, moves: up}}}}
connections: {{base: {{contact: [box, ramp], friction: mu}}}}
states: {{start: {{box.velocity: u}}, end: {{box.velocity: 0, box.displacement: d}}}}
find: {{mu: mu}}
"""
STRUCK = """
title: What bounces off a hinged rod
plane: horizontal
given: {{M: 2 kg, L: 1 m, m: 1 kg, u: 3 m/s, e: unknown, w: {w}}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}, ball: {{mass: m, moves: up}}}}
connections: {{pin: {{hinge: rod.start}}}}
states: {{before: {{rod.angle: 0, at rest: rod, ball.velocity: u}}, after: {{rod.angular_velocity: w}}}}
events: {{hit: {{collides: [ball, rod.end], restitution: e, from: before, to: after}}}}
find: {{e: e}}
"""
STRETCHED = """
title: A load falls onto its spring
given: {{m: 2 kg, k: unknown, d: 10 cm, v: {v}}}
bodies: {{load: {{mass: m, moves: down}}}}
connections: {{coil: {{spring: [ceiling, load], stiffness: k}}}}
states: {{start: {{coil.elongation: 0, at rest: all}}, low: {{coil.elongation: d, load.velocity: v}}}}
find: {{k: k}}
"""
BEAM = """
title: A load on a beam between two strings
given: {{M: 10 kg, m: 20 kg, L: 2 m, x: unknown, T: {T}}}
bodies: {{beam: {{shape: rod, mass: M, length: L}}, load: {{mass: m}}}}
connections: {{rest: {{weld: [beam.at(x), load]}}, one: {{string: [ceiling, beam.start]}}, two: {{string: [ceiling, beam.end]}}}}
states: {{now: {{beam.angle: 0, balance: true}}}}
find: {{x: x where two.tension = T}}
"""
WINDLASS = """
title: A load on a drum with a stiff bearing
given: {{m: 1 kg, R: 20 cm, tau: unknown, mu: 0.5, P: unknown}}
bodies: {{drum: {{shape: disc, mass: m, radius: R}}, load: {{mass: m, moves: down}}}}
connections: {{axle: {{axle: drum{stiff}}}, cord: {{string: [{rope}]}}}}
actions: {{{brake}}}
find: {{x: {asked} where load.acceleration = {rate}}}
"""


@pytest.mark.parametrize(
    ("text", "good", "bad", "said"),
    [
        (SLOWED, {"u": "3 m/s", "d": "1 m"}, {"u": "3 m/s", "d": "1.5 m"}, "in `base` it can't be negative"),
        (STRUCK, {"w": "3 rad/s"}, {"w": "8 rad/s"}, "in `hit` it must lie from 0 to 1"),
        (STRUCK, {"w": "2 rad/s"}, {"w": "1 rad/s"}, "in `hit` it must lie from 0 to 1"),
        (STRETCHED, {"v": "1 m/s"}, {"v": "3 m/s"}, "in `coil` it must be positive"),
        (BEAM, {"T": "200 N"}, {"T": "265 N"}, "a place on `beam`"),
        (BEAM, {"T": "50 N"}, {"T": "30 N"}, "a place on `beam`"),
    ],
)
def test_nothing_is_answered_that_can_not_be(text: str, good: dict[str, str], bad: dict[str, str], said: str) -> None:
    """The same scene with a number that some letter fulfils, and with one that none does."""
    solve(text.format(**good))
    with pytest.raises(Unsolvable, match=said):
        solve(text.format(**bad))


def test_in_letters_it_is_a_condition() -> None:
    """0 ≤ e ≤ 1 for w from 3mu/(L(M + 3m)) to twice that"""
    found = solve(STRUCK.format(w="rad/s"))
    bounds = {one.relation: to_text(one.right) for one in found.derivation.answers[0].conditions}
    assert bounds == {"≥": "3 m u/(L (M + 3 m))", "≤": "6 m u/(L (M + 3 m))"}
    assert sum("no answer is found" in str(check.words) for check in found.checks) == 2


@pytest.mark.parametrize("rope", ["drum, load", "load, drum"])
@pytest.mark.parametrize(("rate", "torque"), [("0", 1.96), ("2 m/s^2", 1 * (9.8 - 2) * 0.2 - 0.02 * 2 / 0.2)])
def test_asked_friction_is_against_the_motion(rope: str, rate: str, torque: float) -> None:
    """τ = m (g − a) R − I a/R on either side of the drum, and as much by a brake: μ P R."""
    stiff = solve(
        WINDLASS.format(stiff=", friction_torque: tau", rope=rope, brake="", asked="tau", rate=rate).replace(
            ", mu: 0.5, P: unknown", ""
        )
    )
    assert stiff.answers["x"].float == pytest.approx(torque)
    brake = "stop: {press: P, on: drum.rim, friction: mu}"
    pressed = solve(
        WINDLASS.format(stiff="", rope=rope, brake=brake, asked="P", rate=rate).replace("tau: unknown, ", "")
    )
    assert pressed.answers["x"].float == pytest.approx(torque / (0.5 * 0.2))
