"""Bounces off surfaces, and flights up to a place: held against sums made here, and refused by name where they can not be."""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable
from rotsolve.elements.collisions import Bounces
from rotsolve.pipeline import solve

R, SHARE, G = 0.02, 0.4, 9.8
BODY = "bodies: {ball: {shape: sphere, mass: 100 g, radius: 2 cm}}\n"
SURFACES = "surfaces: {floor: level, side: {wall: right}, ramp: {slope: 30 deg}, hill: {dome: 1 m}}\n"
ASKED = "find: {x: ball.velocity.x at after, y: ball.velocity.y at after, w: ball.angular_velocity at after}\n"


def numbers(scene: str) -> dict[str, float]:
    solution = solve(scene)
    assert [check for check in solution.checks if check.holds is False] == []
    assert not solution.derivation.refused
    assert all(item.holds for item in solution.derivation.confirmed), solution.derivation.confirmed
    return {name: float(answer.float or 0.0) for name, answer in solution.answers.items()}


def struck(velocity: tuple[float, float], spin: float, how: str, against: str = "floor", body: str = BODY) -> str:
    x, y = velocity
    return (
        f"title: Bounce\n{SURFACES}{body}"
        f"states: {{before: {{ball.velocity: [{x} m/s, {y} m/s], ball.angular_velocity: {spin} rad/s}}, after: {{}}}}\n"
        f"events: {{hit: {{collides: [ball, {against}], {how}, from: before, to: after}}}}\n{ASKED}"
    )


def bounced(
    velocity: tuple[float, float],
    spin: float,
    away: tuple[float, float],
    e: float,
    mu: float = math.inf,
    back: float = 0.0,
) -> list[float]:
    """Off a surface with the normal `away`: friction takes what it needs to stop the slip, or send it back, up to μ times the push."""
    along = (away[1], -away[0])
    came = -(velocity[0] * away[0] + velocity[1] * away[1])
    slid = velocity[0] * along[0] + velocity[1] * along[1]
    slip = slid + spin * R
    rub = -(1 + back) * slip / (1 + 1 / SHARE)
    if abs(rub) > mu * (1 + e) * came:
        rub = -math.copysign(mu * (1 + e) * came, slip)
    new = slid + rub
    return [
        e * came * away[0] + new * along[0],
        e * came * away[1] + new * along[1],
        spin + rub / (SHARE * R),
    ]


FLOOR, SIDE, RAMP, CEILING = (0.0, 1.0), (-1.0, 0.0), (0.5, math.sqrt(3) / 2), (0.0, -1.0)


@pytest.mark.parametrize(
    ("velocity", "spin", "against", "away", "e", "mu"),
    [
        ((3, -4), 150, "floor", FLOOR, 0.7, 0.2),  # it slips all through
        ((3, -4), -300, "floor", FLOOR, 0.7, 0.2),  # top spin drives it on
        ((3, -4), -150, "floor", FLOOR, 0.7, 0.2),  # it rolls already
        ((1, -5), 0, "floor", FLOOR, 0.9, 0.9),  # it grips
        ((-2, -3), 40, "floor", FLOOR, 0.6, 0.05),
        ((4, 1), 30, "side", SIDE, 0.6, 0.3),
        ((1, -5), 0, "ramp", RAMP, 0.5, 0.1),
        ((1, 5), 20, "ceiling", CEILING, 0.5, 0.6),
    ],
)
def test_whether_it_slips_is_decided_by_its_friction(
    velocity: tuple[float, float], spin: float, against: str, away: tuple[float, float], e: float, mu: float
) -> None:
    found = numbers(struck(velocity, spin, f"restitution: {e}, friction: {mu}", against))
    assert list(found.values()) == pytest.approx(bounced(velocity, spin, away, e, mu), rel=1e-9)


@pytest.mark.parametrize(
    ("how", "mu", "back"), [("", 0, 0), (", friction: any", math.inf, 0), (", tangential: 0.6", math.inf, 0.6)]
)
def test_smooth_rough_and_elastic_along_the_surface(how: str, mu: float, back: float) -> None:
    found = numbers(struck((2, -3), 10, f"restitution: 0.8{how}"))
    assert list(found.values()) == pytest.approx(bounced((2, -3), 10, FLOOR, 0.8, mu, back), rel=1e-9)


def test_a_body_may_bounce_off_what_is_fixed_in_its_way() -> None:
    scene = (
        "title: Door\nplane: horizontal\ngiven: {w: 2 rad/s, e: 0.4}\nbodies: {door: {shape: rod, mass: 20 kg, length: 1 m}}\n"
        "connections: {post: {hinge: door.start}}\nstates: {before: {door.angle: 0, door.angular_velocity: w}, after: {}}\n"
        "events: {stop: {collides: [door.at(80 cm), ground], restitution: e, from: before, to: after}}\n"
        "find: {w2: door.angular_velocity at after, H: post.impulse.y during stop}\n"
    )
    blow = 20 / 3 * 2 * 1.4 / 0.8  # I Δω/x
    assert list(numbers(scene).values()) == pytest.approx([-0.8, blow - 20 * 0.5 * 2 * 1.4])


def test_in_letters_it_slips_or_grips_case_by_case() -> None:
    scene = (
        "title: Letters\ngiven: {m: kg, r: m, u: m/s, v: m/s, e: number, mu: number}\nsurfaces: {floor: level}\n"
        "bodies: {ball: {shape: sphere, mass: m, radius: r}}\n"
        "states: {before: {ball.velocity: [u, -v], ball.angular_velocity: 0}, after: {}}\n"
        "events: {hit: {collides: [ball, floor], restitution: e, friction: mu, from: before, to: after}}\n"
        "find: {x: ball.velocity.x at after}\n"
    )
    values = {"m": 0.1, "r": 0.02, "u": 3.0, "v": 4.0, "e": 0.5}
    for mu in (0.05, 0.1, 0.2, 0.6):
        settings = {name: str(value) for name, value in {**values, "mu": mu}.items()}
        units = {"m": " kg", "r": " m", "u": " m/s", "v": " m/s"}
        solution = solve(scene, settings={name: value + units.get(name, "") for name, value in settings.items()})
        assert solution.answers["x"].float == pytest.approx(bounced((3, -4), 0, FLOOR, 0.5, mu)[0])
    answer = next(item for item in solve(scene).derivation.answers if item.name == "x")
    assert len(answer.otherwise) == 1 and answer.conditions


REFUSED = {
    "does not come towards the floor": struck((3, 4), 0, "restitution: 0.5"),
    "a blow off `hill` is not solved yet": struck((0, -3), 0, "restitution: 0.5", "hill"),
    "nothing tells which way `ground` is rough": struck((0, -3), 0, "restitution: 0.5, friction: 0.2", "ground"),
    "nothing tells along which line": struck((1, -3), 0, "restitution: 0.5", "ground"),
    "a `tangential` restitution and a coefficient": struck((0, -3), 0, "restitution: 1, friction: 0.2, tangential: 1"),
    "with which point `ball` strikes": struck(
        (0, -3), 0, "restitution: 1", body="bodies: {ball: {shape: rod, mass: 1 kg, length: 1 m}}\n"
    ),
    "grips `foot`, which is smooth": struck((1, -3), 0, "restitution: 0")
    .replace("collides: [ball, floor], restitution: 0", "grips: foot")
    .replace("states:", "connections: {foot: {contact: [ball, floor]}}\nstates:"),
    "which `roll` holds": struck((3, 0), 0, "restitution: 1, friction: 0.2", "side").replace(
        "states:", "connections: {roll: {rolls: [ball, floor]}}\nstates:"
    ),
    "does not move towards": struck((0, -3), 0, "restitution: 1")
    .replace("radius: 2 cm", "radius: 2 cm, moves: right")
    .replace("ball.velocity: [0 m/s, -3 m/s]", "ball.velocity: 3 m/s")
    .replace("velocity.x", "velocity")
    .replace(" y: ball.velocity.y at after,", ""),
    "has two components": (
        f"title: Flight\n{BODY}"
        "states: {a: {ball.velocity: [1 m/s, 2 m/s], ball.angular_velocity: 0}, b: {ball.displacement: 1 m}}\n"
        "find: {t: time from a to b}\n"
    ),
    "`b` is never reached": (
        f"title: Flight\n{BODY}"
        "states: {a: {ball.velocity: [1 m/s, 2 m/s], ball.angular_velocity: 0}, b: {ball.displacement.y: 1 m}}\n"
        "find: {t: time from a to b}\n"
    ),
}


@pytest.mark.parametrize("reason", REFUSED)
def test_what_can_not_be_is_refused_by_name(reason: str) -> None:
    with pytest.raises(Unsolvable, match=reason):
        solve(REFUSED[reason])


AGAIN = (
    f"title: Later\n{SURFACES}{BODY}"
    "states: {before: {ball.velocity: [1 m/s, -3 m/s], ball.angular_velocity: 0}, after: {}, later: {time: SPAN}}\n"
    "events: {hit: {collides: [ball, floor], restitution: 0.5, from: before, to: after}}\n"
    "find: {y: ball.displacement.y from after to later}\n"
)


def test_what_has_bounced_does_not_go_through_the_floor() -> None:
    assert numbers(AGAIN.replace("SPAN", "0.2 s"))["y"] == pytest.approx(1.5 * 0.2 - G / 2 * 0.04)
    with pytest.raises(Unsolvable, match="`ball` and `floor` meet again"):
        solve(AGAIN.replace("SPAN", "1 s"))
    refused = solve(AGAIN.replace("SPAN", "1 s"), confirm=False)
    assert any(check.holds is False for check in refused.checks)


LOOP = (
    "title: Loop\ngiven: {R: 40 cm, v: 3.5 m/s}\nsurfaces: {loop: {hollow: R}}\nbodies: {ball: {mass: 50 g, moves: right}}\n"
    "connections: {touch: {contact: [ball, loop]}}\n"
    "states: {low: {touch.angle: -90 deg, ball.velocity: v}, off: {touch: leaves}, later: {LATER}}\n"
    "find: {h: ball.height at later, x: ball.displacement.x from off to later}\n"
)


def test_what_leaves_a_loop_flies_on_inside_it() -> None:
    """sin θ = (v² − 2 g R)/3 g R where it leaves, with v₁² = g R sin θ."""
    sine = (3.5**2 - 2 * G * 0.4) / (3 * G * 0.4)
    speed, cosine = math.sqrt(G * 0.4 * sine), math.sqrt(1 - sine**2)
    rise = (speed * cosine) ** 2 / (2 * G)
    found = numbers(LOOP.replace("LATER", "ball.velocity.y: 0"))
    assert found["h"] == pytest.approx(0.4 * (1 + sine) + rise)
    assert found["x"] == pytest.approx(-speed * sine * speed * cosine / G)
    with pytest.raises(Unsolvable, match="`ball` and `loop` meet again"):
        solve(LOOP.replace("LATER", "time: 0.5 s"))


def test_the_turns_of_what_rolls_off_an_edge_go_on_as_they_were_counted() -> None:
    scene = (
        "title: Edge\nsurfaces: {top: level}\nbodies: {ball: {shape: sphere, mass: 100 g, radius: 2 cm, moves: right}}\n"
        "connections: {touch: {rolls: [ball, top]}}\n"
        "states: {o: {ball.velocity: 2 m/s}, a: {ball.displacement: 1 m}, b: {}, c: {ball.displacement.y: -1 m}}\n"
        "events: {fly: {removes: touch, from: a, to: b}}\n"
        "find: {x: ball.displacement.x from o to c, n: ball.turns from o to c, t: time from b to c}\n"
    )
    span = math.sqrt(2 / G)
    assert list(numbers(scene).values()) == pytest.approx([1 + 2 * span, (50 + 100 * span) / math.tau, span])


def test_the_first_moment_at_a_place_is_meant() -> None:
    scene = (
        f"title: Up\n{BODY}"
        "states: {a: {ball.velocity: [1 m/s, 6 m/s], ball.angular_velocity: 3 rad/s}, b: {ball.displacement.y: 1 m}}\n"
        "find: {t: time from a to b, v: ball.velocity.y at b, n: ball.turns from a to b}\n"
    )
    span = (6 - math.sqrt(36 - 2 * G)) / G
    assert list(numbers(scene).values()) == pytest.approx([span, 6 - G * span, 3 * span / math.tau])


def test_the_assembly_contradicts_a_wrong_blow(monkeypatch: pytest.MonkeyPatch) -> None:
    """A solver that takes half of the restitution is told so by the assembly's own facts."""
    scene = struck((2, -3), 10, "restitution: 0.8, friction: any").replace("x: ball.velocity.x at after, ", "")
    bounce = Bounces.bounce

    def weaker(self: Bounces, *ends: object) -> object:
        found = bounce(self, *ends)  # type: ignore[arg-type]
        return None if found is None else (found[0] / 2, *found[1:])

    monkeypatch.setattr(Bounces, "bounce", weaker)
    refused = [item.fault.message for item in solve(scene).derivation.refused]
    assert len(refused) == 1 and "contradicts `y`" in refused[0]
