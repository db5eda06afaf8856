"""Rough blows whose push turns what strikes, or what hangs on joints: held against the slip followed by ever more push (Routh)."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from linked import Array, Bodies, direction
from rotsolve import Unsolvable, solve

RIGHT, UP = direction(0), direction(math.pi / 2)
TURNS, GAINS = "the slip of .* turns back", "would gain energy"


def followed(inverse: Array, speeds: tuple[float, float], mu: float, bounce: float) -> tuple[float, float, bool]:
    """The impulses along and across a floor until the point leaves it, and whether its slip turns back: friction against the slip by
    the push, as long as it slips; what stops sticks where friction can hold it, and else goes on, the other way round."""
    (tt, tn), (_, nn) = inverse
    slip, rise = speeds
    goal, along, across, turned = -bounce * rise, 0.0, 0.0, False
    sense = math.copysign(1, slip) if abs(slip) > 1e-12 else 0.0
    for _ in range(3):
        holds = sense == 0 and abs(tn) <= mu * tt
        if sense == 0 and not holds:
            sense = math.copysign(1, tn)
        share = -tn / tt if holds else -sense * mu  # of the push
        gain, lift = tn + tt * share, nn + tn * share
        most = (goal - rise) / lift if lift > 1e-12 else math.inf
        stops = -slip / gain if not holds and sense * gain < 0 else math.inf
        push = min(most, stops if stops > 1e-15 else math.inf)
        if math.isinf(push):  # a joint jams it: no push is enough
            return along, across, True
        along, across = along + share * push, across + push
        slip, rise = slip + gain * push, rise + lift * push
        if push == most:
            return along, across, turned
        before, sense = sense, 0.0
        turned = abs(tn) > mu * tt and math.copysign(1, tn) != before
    raise AssertionError


class Strikes:
    """One or two rods, free or on a post, whose end strikes a rough floor."""

    def __init__(self, number: int) -> None:
        draw = random.Random(f"rough {number}")
        self.lengths = [draw.choice((0.5, 1.0)) for _ in range(draw.choice((1, 1, 2)))]
        self.angles = [15 * draw.randrange(-11, 0) for _ in self.lengths]
        self.held = draw.random() < 0.35
        self.speed = (draw.choice((0.0, 1.0, -2.0, 4.0)), draw.choice((-1.0, -3.0)))
        self.mu, self.bounce = draw.choice((0.1, 0.3, 0.7, 1.5)), draw.choice((0.0, 0.3, 0.8))
        self.bodies, place = Bodies(), np.zeros(2)
        before: list[Array] = []
        for k, (length, angle) in enumerate(zip(self.lengths, self.angles, strict=True)):
            way = length * direction(math.radians(angle))
            self.bodies.add(f"r{k}", 2, 2 * length**2 / 12, place + way / 2)
            middle = place + way / 2
            spin = -2.0 if self.held else 0.0
            before.append(np.array([-spin * middle[1], spin * middle[0], spin] if self.held else [*self.speed, 0.0]))
            if k:
                self.bodies.pin("pin", place, f"r{k}", f"r{k - 1}")
            place = place + way
        if self.held:
            self.bodies.pin("post", np.zeros(2), "r0")
        self.before, self.tip, self.last = np.concatenate(before), place, f"r{len(self.lengths) - 1}"

    def scene(self) -> str:
        names = range(len(self.lengths))
        rods = ", ".join(
            f"r{k}: {{shape: rod, mass: 2 kg, length: {length} m}}" for k, length in enumerate(self.lengths)
        )
        joints = ["post: {hinge: r0.start}"] * self.held + ["pin: {hinge: [r0.end, r1.start]}"] * (len(names) > 1)
        spin = "-2 rad/s" if self.held else "0"
        told = [f"r{k}.angle: {angle} deg, r{k}.angular_velocity: {spin}" for k, angle in enumerate(self.angles)]
        told += [] if self.held else [f"r0.velocity: [{self.speed[0]} m/s, {self.speed[1]} m/s]"]
        asked = ", ".join(f"w{k}: r{k}.angular_velocity at after" for k in names)
        return (
            f"title: Rough\nsurfaces: {{floor: level}}\nbodies: {{{rods}}}\nconnections: {{{', '.join(joints)}}}\n"
            f"states: {{before: {{{', '.join(told)}}}, after: {{}}}}\n"
            f"events: {{hit: {{collides: [{self.last}.end, floor], restitution: {self.bounce}, friction: {self.mu}, "
            f"from: before, to: after}}}}\n"
            f"find: {{{asked}, x: hit.impulse.x during hit, y: hit.impulse.y during hit}}\n"
        )

    def truth(self) -> tuple[dict[str, float], bool]:
        """The answers, and whether the slip turns back."""
        bodies, tip = self.bodies, self.tip
        ways = [(self.last, tip, way) for way in (RIGHT, UP)]
        rows = np.array([bodies.row([way]) for way in ways])
        changes = np.array([bodies.struck(0 * self.before, [way])[0] for way in ways])
        along, across, turned = followed(rows @ changes.T, tuple(rows @ self.before), self.mu, self.bounce)
        after = self.before + along * changes[0] + across * changes[1]
        spins = {f"w{k}": float(after[3 * k + 2]) for k in range(len(self.lengths))}
        self.lost = bodies.energy(self.before) - bodies.energy(after)
        return spins | {"x": along, "y": across}, turned


@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", range(48))
def test_a_rough_blow_goes_as_its_slip_goes(number: int) -> None:
    case = Strikes(number)
    came = -float(case.bodies.row([(case.last, case.tip, UP)]) @ case.before)
    if abs(came) < 1e-9:
        pytest.skip("it only just touches the floor")
    if came < 0:
        with pytest.raises(Unsolvable, match="does not come towards"):
            solve(case.scene())
        return
    truth, turned = case.truth()
    if turned or case.lost < -1e-9:
        with pytest.raises(Unsolvable, match=TURNS if turned else GAINS):
            solve(case.scene())
        return
    solution = solve(case.scene())
    assert not solution.derivation.refused and all(item.holds for item in solution.derivation.confirmed)
    assert {name: answer.float for name, answer in solution.answers.items()} == pytest.approx(truth, rel=1e-8, abs=1e-9)


@pytest.mark.parametrize(("blow", "before", "aim"), [(8, 1, -120), (1, 1, -120), (5, 0, -95), (5, -1, -100)])
def test_what_resists_rolling_resists_in_a_blow(blow: float, before: float, aim: float) -> None:
    """A ring hit on top: about where it touches 2 M R² (ω' − ω) = 2 R J cos φ ∓ b Jₙ, against the turn with which it leaves the blow."""
    found = (
        solve(f"""
given: {{R: 0.69 m, M: 3.2 kg, b: 18 mm, J: {blow} N s, v: {before} m/s, phi: {aim} deg}}
surfaces: {{floor: level}}
bodies: {{ring: {{shape: ring, mass: M, radius: R, moves: right}}}}
connections: {{base: {{rolls: [ring, floor], rolling_friction: b}}}}
states: {{start: {{ring.velocity: v}}, after: {{}}}}
events: {{hit: {{impulse: J, on: ring.top, direction: phi, from: start, to: after}}}}
find: {{w: ring.angular_velocity at after}}
""")
        .answers["w"]
        .float
    )
    inertia, way = 2 * 3.2 * 0.69**2, math.radians(aim)
    free = before / 0.69 + 2 * 0.69 * blow * math.cos(way) / inertia
    drag = 0.018 * blow * math.sin(-way) / inertia
    assert found == pytest.approx(free - math.copysign(drag, free), rel=1e-6)
