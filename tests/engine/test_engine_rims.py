"""Bodies of several radii: what touches a rim names which one, whatever the order in which they are written; else it is refused."""

from __future__ import annotations

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

SCENE = """
title: Body of several radii
given: {{R: 30 cm, r: 10 cm, I: 0.1 kg m^2, m: 2 kg, F: 5 N, mu: 0.5, beta: 20 deg, w: 3 rad/s}}
surfaces: {{ramp: {{slope: beta, down: right}}, floor: level}}
bodies: {{d: {{mass: m, inertia: I, {radii}}}, b: {{mass: m}}, a: {{inertia: I, radius: r}}, c: {{inertia: I, radius: r}},
  e: {{inertia: I, radius: R}}}}
{rest}
"""
RADII = ("radii: {big: R, small: r}", "radii: {small: r, big: R}")
HELD = "axle: {axle: d}"
NOW = "\nstates: {now: {a.angular_velocity: w}}"
ELEMENTS = {  # what stands round the body, where `d` stands for its rim, and what is asked
    "rolls": ("connections: {x: {rolls: [d, ramp]}}", "d.acceleration"),
    "contact": ("connections: {x: {contact: [d, ramp], friction: mu}}", "d.acceleration"),
    "string": (f"connections: {{{HELD}, x: {{string: [d, b]}}}}", "b.acceleration"),
    "string over it": (f"connections: {{{HELD}, x: {{string: [a, d, b]}}, n: {{axle: a}}}}", "b.acceleration"),
    "belt": (f"connections: {{{HELD}, n: {{axle: a}}, x: {{belt: [a, d]}}}}{NOW}", "d.angular_velocity"),
    "gear": (f"connections: {{{HELD}, n: {{axle: a}}, x: {{gear: [a, d]}}}}{NOW}", "d.angular_velocity"),
    "brake": (
        f"connections: {{{HELD}}}\nactions: {{x: {{press: F, on: d, friction: mu}}}}\nstates: {{now: {{d.angular_velocity: w}}}}",
        "d.angular_acceleration",
    ),
    "pull off it": (
        f"connections: {{{HELD}}}\nactions: {{x: {{force: F, on: d, direction: right, over: true}}}}",
        "d.angular_acceleration",
    ),
    "along its turn": (f"connections: {{{HELD}}}\nactions: {{x: {{force: F, on: d}}}}", "d.angular_acceleration"),
    "tangential": (
        f"connections: {{{HELD}}}\nactions: {{x: {{force: F, on: d, direction: tangential}}}}",
        "d.angular_acceleration",
    ),
    "rims": (
        f"connections: {{{HELD}, n: {{axle: a}}, x: {{contact: [d, a], press: F, friction: mu}}}}\n"
        "states: {now: {d.angular_velocity: w, a.angular_velocity: 0}}",
        "d.angular_acceleration",
    ),
    "clutch": (
        "connections: {axle: {axle: [d, e]}, x: {clutch: [d, e], press: F, friction: mu}}\n"
        "states: {now: {d.angular_velocity: w, e.angular_velocity: 0}}",
        "d.angular_acceleration",
    ),
}  # fmt: skip


def written(element: str, radii: str, rim: str = "") -> str:
    rest, asked = ELEMENTS[element]
    named = rest
    for place in ("[d,", " d]", " d,", "on: d}"):
        if rim and "x: {" in named:
            head, tail = named.split("x: {", 1)
            named = head + "x: {" + tail.replace(place, place.replace("d", f"d.{rim}"), 1)
    used = [name for name in ("b", "a", "c") if f" {name}]" in rest or f"[{name}," in rest or f" {name}," in rest]
    scene = SCENE.format(radii=radii, rest=f"{named}\nfind: {{y: {asked}{' at now' if 'states' in rest else ''}}}")
    for name, words in (
        ("b", ", b: {mass: m}"),
        ("a", ", a: {inertia: I, radius: r}"),
        ("c", ", c: {inertia: I, radius: r}"),
    ):
        scene = scene if name in used else scene.replace(words, "")
    return scene


def answer(scene: str) -> float:
    (only,) = solve(scene).answers.values()
    assert only.float is not None
    return only.float


@pytest.mark.parametrize("radii", RADII)
@pytest.mark.parametrize("element", ELEMENTS)
def test_of_several_rims_one_is_named(element: str, radii: str) -> None:
    """Alone it is refused, where it stands and with the names; by name each rim gives another answer."""
    with pytest.raises(Unsolvable, match=r"has the rims `(big|small)`, `(big|small)`: on which one is `x`") as refused:
        solve(written(element, radii))
    assert refused.value.fault.span is not None
    assert refused.value.fault.help in ("name it: `d.big`", "name it: `d.small`")
    big, small = (answer(written(element, radii, rim)) for rim in ("big", "small"))
    assert big != pytest.approx(small)


@pytest.mark.parametrize("element", ELEMENTS)
def test_one_rim_needs_no_name(element: str) -> None:
    """One named radius, the radius itself and the outer one of a shape are the rim of a body that is named alone."""
    named = answer(written(element, RADII[0], "big"))
    assert answer(written(element, "radii: {big: R}")) == pytest.approx(named)
    assert answer(written(element, "radius: R")) == pytest.approx(named)
    if element != "clutch":  # of which the face matters, not the rim alone
        assert answer(written(element, "shape: annulus, radii: {inner: r, outer: R}")) == pytest.approx(named)


@pytest.mark.parametrize("point", ["rim", "top", "bottom"])
def test_points_of_several_rims_are_asked_of_one(point: str) -> None:
    scene = written("brake", RADII[0], "big")
    for changed in (scene.replace("d.angular_acceleration", f"d.{point}.speed"), scene.replace("d.big", f"d.{point}")):
        with pytest.raises(Exception, match=f"has the rims `big`, `small`: of which one is this the `{point}`"):
            solve(changed)
    assert answer(scene.replace("d.angular_acceleration", "d.big.speed")) == pytest.approx(0.9)
    assert answer(
        written("brake", "radii: {rim: R, axle: r}", "rim").replace("d.angular_acceleration", "d.rim.speed")
    ) == pytest.approx(0.9)
