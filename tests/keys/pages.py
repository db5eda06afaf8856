"""Small problems for the tests of keys: one that varies, one without a text, one that can't be solved."""

from __future__ import annotations

from pathlib import Path

from rotsolve.core.derivation import Answer
from rotsolve.page.values import certified_digits

ROOT = Path(__file__).resolve().parents[2]
FALL = """\
title: Bucket & rope
source: the answer is m g
text: >
  A bucket of mass {m} hangs from a rope that is wound on a disc of mass {value of M}, theta is {theta0}.

  How fast does it fall? Nothing costs 5 $.
given: {m: 2 kg, M: 5 kg, R: 0.2 m, theta0: 30 deg}
bodies: {bucket: {mass: m, moves: down}, reel: {shape: disc, mass: M, radius: R, turns: clockwise}}
connections: {axle: {axle: reel}, rope: {string: [reel, bucket]}}
find: {a: bucket.acceleration, alpha: reel.angular_acceleration, T: rope.tension}
vary:
  m: 1.0 kg to 3.0 kg by 0.5 kg
  M: [4 kg, 5 kg, 6000 g]
  where: M > 2*m
"""
PLAIN = """\
title: Pendulum without a text
given: {L: 1 m}
bodies: {rod: {shape: rod, length: L}}
connections: {pin: {hinge: rod.start}}
states: {held: {rod.angle: 0 deg, at rest: all}}
find: {v: rod.end.acceleration.y at held, F: pin.force.x at held}
"""
OPEN = """\
title: No answer
bodies: {block: {mass: 1 kg, moves: down}}
find: {v: block.velocity}
"""


def said(answer: Answer) -> tuple[object, ...]:
    """All that an answer tells: its words, its digits, its components."""
    numbers = certified_digits(answer.value, 12), certified_digits(answer.angle, 12)
    return (answer.name, answer.direction, answer.word, numbers, tuple(map(said, answer.components)))
