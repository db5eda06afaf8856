"""Sizes that follow from places and from the whole: rods from start to end in space, corners, bores as deep as what they are cut through.

Values by hand, and every answer by the assembly of all bodies' equations.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import SceneError, Unsolvable, solve

HEAD = "given: {m: 3 kg, k: 2 kg/m, b: 0.2 m, c: 0.3 m, w: 10 rad/s}\n"
ROD = "bodies: {r: {points: {A: [0, 0, 0]}, parts: {q: {shape: rod, AMOUNT, start: START, end: END}}}}\n"
FIND = "find: {I: r.inertia_tensor about r.A, M: r.mass}\n"
BLOCK = (
    "given: {M: 2 kg, a: 0.3 m, b: 0.2 m, c: 0.1 m, r: 0.05 m}\nbodies: {o: {shape: WHOLE, BY, holes: {h: {HOLE}}}}\n"
)
REST = 0.006 - math.pi * 0.05**2 * 0.1  # of a box with a bore along z


def rod(start: str, end: str, amount: str = "mass: m") -> str:
    return HEAD + ROD.replace("AMOUNT", amount).replace("START", start).replace("END", end) + FIND


def block(whole: str, by: str, hole: str, find: str = "{I: o.inertia along z}") -> str:
    return BLOCK.replace("WHOLE", whole).replace("BY", by).replace("HOLE", hole) + f"find: {find}\n"


def box_with_bore(mass: float, depth: float) -> float:
    """I_z of the box with a bore along z through its middle."""
    bore = math.pi * 0.05**2 * depth
    density = mass / (0.006 - bore)
    return density * (0.006 * (0.09 + 0.04) / 12 - bore * 0.05**2 / 2)


def along(length: float, x: float, y: float, z: float) -> tuple[float, ...]:
    """m L²/3 (1 − n nᵀ) of a rod of 3 kg from the origin: xx, yy, zz, xy, yz, zx."""
    third, (x, y, z) = 3 * length**2 / 3, (part / length for part in (x, y, z))
    return tuple(third * part for part in (1 - x * x, 1 - y * y, 1 - z * z, -x * y, -y * z, -z * x))


CASES = {
    "a rod along z": (rod("[0, 0, 0]", "[0, 0, b]"), {"I": along(0.2, 0, 0, 0.2), "M": 3}),
    "down": (rod("[0, 0, 0]", "[0, 0, -b]"), {"I": along(0.2, 0, 0, 0.2), "M": 3}),
    "slanted": (rod("[0, 0, 0]", "[b, 2*b, 2*b]"), {"I": along(0.6, 0.2, 0.4, 0.4), "M": 3}),
    "level, as before": (rod("[0, 0, 0]", "[b, 2*b, 0]"), {"I": along(0.2 * 5**0.5, 0.2, 0.4, 0), "M": 3}),
    "its ends above one another, not at the origin": (
        rod("[b, 0, -b]", "[b, 0, b]"),
        {"I": (0.04, 0.16, 0.12, 0, 0, 0), "M": 3},
    ),
    "by a density: λ d": (
        rod("[0, 0, 0]", "[b, 2*b, 2*b]", "density: 5*k/2"),
        {"I": along(0.6, 0.2, 0.4, 0.4), "M": 3},
    ),
    "by a density, along z alone": (rod("[0, 0, 0]", "[0, 0, c]", "density: k"), {"M": 0.6}),
    "of a length that is told, the same": (
        rod("[0, 0, 0]", "[b, 2*b, 2*b]", "mass: m, length: 3*b"),
        {"I": along(0.6, 0.2, 0.4, 0.4), "M": 3},
    ),
    "on an axis: K = ½ I ω², τ = I_xz ω²": (
        "gravity: none\n"
        + rod("[-b, 0, -c]", "[b, 0, c]").replace(
            FIND, "connections: {x: {hinge: r.A, along: z, angular_velocity: w}}\n"
        )
        + "find: {K: r.kinetic_energy, T: x.torque.y}\n",
        {"K": 0.5 * 3 * 0.04 / 3 * 100, "T": -3 * 0.2 * 0.3 / 3 * 100},
    ),
    "a rod with a gap, which is a rod too": (
        "given: {m: 2 kg, b: 0.2 m}\nbodies: {r: {shape: rod, length: 4*b, mass: m, "
        "holes: {q: {shape: rod, start: [0, 0, 0], end: [b, 0, 0]}}}}\nfind: {I: r.inertia along z about r.center}\n",
        {"I": 5 * 2 * 0.04 / 3},
    ),
    "corners in space, with and without their height": (
        "given: {m: 36 kg, a: 1 m}\nbodies: {t: {shape: triangle, mass: m, corners: [[0, 0, 0], [a, 0], [0, a, 0]]},\n"
        "  p: {shape: polygon, mass: m, corners: [[0, 0], [a, 0], [0, a]]}}\n"
        "find: {I: t.inertia_tensor, J: p.inertia_tensor, P: t.principal_moments}\n",
        {"I": (2, 2, 4, 1, 0, 0), "J": (2, 2, 4, 1, 0, 0), "P": (1, 3, 4)},
    ),
    "a bore along z through a box, by its mass": (
        block("cuboid", "mass: M, sides: [a, b, c]", "shape: cylinder, radius: r"),
        {"I": box_with_bore(2, 0.1)},
    ),
    "by a density": (
        block(
            "cuboid", "density: 1000 kg/m^3, sides: [a, b, c]", "shape: cylinder, radius: r, length: c", "{n: o.mass}"
        ),
        {"n": 1000 * REST},
    ),
    "half through: in the middle, so that it stays symmetric": (
        block("cuboid", "mass: M, sides: [a, b, c]", "shape: cylinder, radius: r, length: c/2"),
        {"I": box_with_bore(2, 0.05)},
    ),
    "a bore half as long as a cylinder": (
        block("cylinder", "mass: M, radius: 2*r, length: c", "shape: cylinder, radius: r, length: c/2"),
        {"I": 2 / (4 * 2 - 1) * (4 * 2 * 0.02 * 0.5 * 0.5 - 0.0025 / 2)},
    ),
    "a bore across a box, which goes on in y": (
        block(
            "cuboid",
            "mass: M, sides: [a, b, c]",
            "shape: cylinder, radius: r/2, length: b, turned: {about: x, by: 90 deg}",
            "{I: o.inertia along y}",
        ),
        {"I": 2 / (0.006 - math.pi * 0.000625 * 0.2) * (0.006 * 0.1 / 12 - math.pi * 0.000625 * 0.2 * 0.000625 / 2)},
    ),
    "a ball with a ball in it": (
        block("sphere", "mass: M, radius: 2*r", "shape: sphere, radius: r"),
        {"I": 0.4 * 2 * (0.1**5 - 0.05**5) / (0.1**3 - 0.05**3)},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_sizes_are_those_of_space(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    for answer in derivation.answers:
        parts = answer.components or (answer,)
        found = [part.value.float for part in parts if part.value is not None]
        wanted = known.get(answer.name, found)
        wanted = wanted if isinstance(wanted, tuple | list) else [wanted]
        assert found == pytest.approx(list(wanted), rel=1e-9, abs=1e-12), answer.name
    assert {item.name for item in derivation.confirmed if item.holds} >= known.keys()


def test_a_bore_through_a_box_in_the_plane() -> None:
    """The same in a scene of the plane."""
    scene = block("cuboid", "mass: M, sides: [a, b, c]", "shape: cylinder, radius: r", "{I: o.inertia}")
    assert solve(f"title: T\n{scene}").answers["I"].float == pytest.approx(box_with_bore(2, 0.1), rel=1e-9)


REFUSED = {
    "a length that is not that between its ends": (
        rod("[0, 0, 0]", "[0, 0, b]", "mass: m, length: 2*b"),
        "the rod `q` is not as long as its ends are apart",
    ),
    "one that letters do not tell to be so": (
        rod("[0, 0, 0]", "[0, 0, b]", "mass: m, length: d").replace("given: {", "given: {d: m, "),
        "the rod `q` is not as long as its ends are apart",
    ),
    "a place beside its ends": (rod("[0, 0, 0]", "[0, 0, b]", "mass: m, at: [0, 0, b]"), "place the rod `q` already"),
    "a turn beside its ends": (
        rod("[0, 0, 0]", "[0, 0, b]", "mass: m, turned: {about: x, by: 90 deg}"),
        "place the rod `q` already",
    ),
    "a rod that begins where it ends": (rod("[0, 0, b]", "[0, 0, b]"), "the rod `q` begins where it ends"),
    "ends of what is no rod": (
        rod("[0, 0, 0]", "[0, 0, b]", "mass: m, radius: b").replace("shape: rod", "shape: disc"),
        "those of a rod, and `q` is none",
    ),
    "a bore of which nothing tells how long it is": (
        block("cuboid", "mass: M, sides: [a, b, c]", "shape: cylinder, radius: r/4, turned: {about: x, by: 90 deg}"),
        "how long the hole `h` is nothing tells",
    ),
    "one in a ball": (
        block("sphere", "mass: M, radius: 2*r", "shape: cylinder, radius: r/2"),
        "how long the hole `h` is nothing tells",
    ),
    "a disc cut out of a ball": (
        block("sphere", "mass: M, radius: 2*r", "shape: disc, radius: r/2"),
        "how much of `o` the hole `h` takes away nothing tells",
    ),
    "a disc cut through a box, whose moments about other axes nothing tells": (
        block("cuboid", "mass: M, sides: [a, b, c]", "shape: disc, radius: r"),
        "only the moment of inertia of `h` about its axis is known",
    ),
    "a ball cut out of a sheet": (
        block("rectangle", "mass: M, sides: [a, b]", "shape: sphere, radius: r"),
        "how much of `o` the hole `h` takes away nothing tells",
    ),
    "corners that are not in one plane with its axes": (
        "given: {m: 1 kg, a: 1 m}\nbodies: {t: {shape: triangle, mass: m, corners: [[0, 0, a], [a, 0, 0], [0, a, 0]]}}\n"
        "find: {I: t.inertia_tensor}\n",
        "the corners of a flat body lie in its own x-y plane",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_sizes_can_not_be_is_refused(name: str) -> None:
    scene, words = REFUSED[name]
    with pytest.raises((SceneError, Unsolvable)) as refusal:
        solve(f"title: T\nup: z\n{scene}")
    assert words in str(refusal.value)
