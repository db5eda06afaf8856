"""What is sought in the plane and may have another sense, start or place: it is told, marked or refused, and never taken in silence.

By hand: a rod M, L on a hinge at its end has K = M L² ω²/6 and comes down from the angle q with K = M g L (1 + sin q)/2; a rod on a
spring from a place above its hinge stands where M g (L/2) cos q is the spring's torque.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from rotsolve import Solution, Unsolvable, solve

ROD = """
given: {M: 2 kg, L: 1 m, g: 9.8 m/s^2, SOUGHT}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {STATES}
find: {FIND}
"""
SPEED = ROD.replace("SOUGHT", "w: unknown").replace(
    "STATES", "now: {rod.angle: 30 deg, rod.angular_velocity: w, rod.end.speed: 3 m/s}"
)
FALLEN = ROD.replace("SOUGHT", "q: unknown").replace(
    "STATES", "up: {rod.angle: q, at rest: all}, low: {rod.angle: -90 deg, TOLD}"
)
SPRUNG = """
given: {M: 2 kg, L: 1 m, k: 30 N/m, X: PLACE m, h: 1.2 m, l0: 0.5 m, g: 9.8 m/s^2LETTER}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}, coil: {spring: [[X, h], rod.end], stiffness: k, rest_length: l0}}
states: {now: {STATE}}
find: {FIND}
"""


def notes(solution: Solution) -> dict[str, tuple[bool | None, str]]:
    return {one.name: (one.holds, one.also or one.why) for one in solution.derivation.confirmed}


@pytest.mark.parametrize(
    ("find", "value"),
    [
        ("w: w", 3),
        ("v: rod.end.velocity.y", 3 * math.sqrt(3) / 2),
        ("l: rod.angular_momentum", 2),
        ("P: rod.power.gravity", -3 * 9.8 * math.sqrt(3) / 2),
    ],
)
def test_a_speed_tells_no_sense(find: str, value: float) -> None:
    found = solve(SPEED.replace("FIND", find))
    assert found.answers[find[0]].float == pytest.approx(value)
    holds, said = notes(found)[find[0]]
    assert holds
    assert "w = -3 in SI units makes it so too".removeprefix("w" if find[0] == "w" else "") in said


def test_what_either_sense_makes_so_has_no_note() -> None:
    assert notes(solve(SPEED.replace("FIND", "K: rod.kinetic_energy"))) == {"K": (True, "")}


@pytest.mark.parametrize(("speed", "fits"), [("3 m/s", True), ("4 m/s", False)])
def test_a_speed_stands_beside_a_rate_of_the_other_sense(speed: str, fits: bool) -> None:
    scene = ROD.replace("SOUGHT", "w: -3 rad/s").replace("FIND", "v: rod.end.velocity.y")
    scene = scene.replace("STATES", f"now: {{rod.angle: 0, rod.angular_velocity: w, rod.end.speed: {speed}}}")
    if fits:
        assert notes(solve(scene)) == {"v": (True, "")}
    else:
        with pytest.raises(Unsolvable, match="contradict"):
            solve(scene)


@pytest.mark.parametrize("find", ["q: q", "w: rod.angular_velocity at low", "a: rod.angular_acceleration at up"])
def test_a_start_angle_that_no_question_asks_for_may_be_another(find: str) -> None:
    """1 + sin q = 8/9.8: −10.6° and −169.4°, from which the rod comes to −90° the other way round."""
    with pytest.raises(Unsolvable, match=r"q = −169\.416° makes it so too"):
        solve(FALLEN.replace("TOLD", "kinetic_energy: 8 J").replace("FIND", find))


@pytest.mark.parametrize(("word", "told"), [("", r"q = −8\.60722° makes it so too"), ("largest ", "and is larger")])
def test_where_one_start_leads_the_other_way_the_other_is_tried(word: str, told: str) -> None:
    """ω = +5 rad/s at −90°: at once from −171.4°, and on the way back from −8.6°."""
    with pytest.raises(Unsolvable, match=told):
        solve(FALLEN.replace("TOLD", "rod.angular_velocity: 5 rad/s").replace("FIND", f"q: {word}q"))


def test_another_root_of_another_law_is_no_objection() -> None:
    found = solve(FALLEN.replace("TOLD", "rod.angular_velocity: 5 rad/s").replace("FIND", "q: smallest q"))
    assert found.answers["q"].float == pytest.approx(math.radians(-171.3928), abs=1e-5)
    assert all(check.holds is not False for check in found.checks)


def test_what_no_start_leads_to_is_refused() -> None:
    with pytest.raises(Unsolvable, match="no `q` is found that fits"):
        solve(FALLEN.replace("TOLD", "rod.angular_velocity: 7.9 rad/s").replace("FIND", "q: q"))


def stable(place: float) -> list[float]:
    """The angles at which the torques turn from forwards to back, in degrees."""

    def drive(q: float) -> float:
        x, y = math.cos(q), math.sin(q)
        length = math.hypot(place - x, 1.2 - y)
        pull = 30 * (length - 0.5) / length
        return pull * (x * (1.2 - y) - y * (place - x)) - 9.8 * math.cos(q)

    angles = [-math.pi + math.tau * (k + 0.5) / 5000 for k in range(5000)]
    return [math.degrees(a) for a, b in pairwise(angles) if drive(a) > 0 >= drive(b)]


@pytest.mark.parametrize("place", [0.0, 0.3])
@pytest.mark.parametrize(("find", "of"), [("x: q in deg", lambda q: q), ("x: 90 deg - q in deg", lambda q: 90 - q)])
def test_of_two_stable_places_the_other_is_told(place: float, find: str, of) -> None:  # type: ignore[no-untyped-def]
    near, far = sorted(stable(place), key=abs)
    scene = SPRUNG.replace("PLACE", f"{place}").replace("LETTER", ", q: unknown").replace("FIND", find)
    found = solve(scene.replace("STATE", "rod.angle: q, balance: true"))
    assert found.answers["x"].float == pytest.approx(of(near), abs=0.1)
    holds, said = notes(found)["x"]
    assert holds is None
    assert float(said.split(" = ")[1].split("°")[0]) == pytest.approx(far, abs=0.1)
    assert "of 2 stable ones" in " ".join(str(found).split())


def test_one_stable_place_is_confirmed() -> None:
    scene = SPRUNG.replace("PLACE", "-0.8").replace("LETTER", ", q: unknown").replace("FIND", "q: q")
    (only,) = stable(-0.8)
    found = solve(scene.replace("STATE", "rod.angle: q, balance: true"))
    assert found.answers["q"].float == pytest.approx(math.radians(only), abs=2e-3)
    assert notes(found) == {"q": (True, "")}


def test_what_settles_stays_on_its_hinge() -> None:
    """Where nothing tells the angle the assembly finds it by letting the rod go."""
    scene = SPRUNG.replace("PLACE", "0").replace("LETTER", "").replace("FIND", "p: rod.angle, F: coil.force")
    found = solve(scene.replace("STATE", "balance: true"))
    assert notes(found) == {"p": (True, ""), "F": (True, "")}
    assert found.answers["p"].float == pytest.approx(math.radians(stable(0.0)[0]), abs=2e-3)


def test_a_time_at_which_nothing_comes_about_is_no_endless_search() -> None:
    """I α + M g (L/2) cos θ of an arm that is led to and fro stays above 2.2 N m."""
    with pytest.raises(Unsolvable) as refused:
        solve("""
given: {phi: 30 deg, T: 2 s, t1: unknown}
bodies: {arm: {shape: rod, mass: 1 kg, length: 0.8 m}}
connections: {hub: {hinge: arm.start, angle: phi*sin(2*pi*time/T)}}
states: {start: {time: 0 s}, now: {time: t1}}
find: {t: t1 where hub.torque = 0.5 N m at now}
""")
    assert "too long" not in str(refused.value)
