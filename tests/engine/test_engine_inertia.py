"""Shapes: their elements add up to what the table says; tensors of composites are those of particles that stand for the parts."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Mapping
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Number, Symbol
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.slicing import Range, coordinate
from rotsolve.core.vectors.tensor import AXES, ENTRIES, ROWS, InertiaTensor, Place, displaced
from rotsolve.elements.shapes import Shape
from rotsolve.elements.shapes.flat import Polygon, Rectangle, Triangle
from rotsolve.elements.shapes.half import Hemisphere, HemisphericalShell
from rotsolve.elements.shapes.integrated import Graded, Lamina, Revolution
from rotsolve.elements.shapes.round import Annulus, Cylinder, CylindricalShell, Disc, Ring, Sphere, SphericalShell
from rotsolve.elements.shapes.solid import Cone, Cuboid, Ellipsoid
from rotsolve.elements.shapes.thin import Arc, Rod
from rotsolve.elements.tables import SHAPES
from rotsolve.pipeline import solve

R, r, L, a, b, c = map(Symbol, ("R", "r", "L", "a", "b", "c"))
VALUES = {"R": 1.3, "r": 0.4, "L": 2.1, "a": 1.1, "b": 0.7, "c": 0.9, "t": 1.7}
WALLS = (("inner", r), ("outer", R))
X, Y, Z = map(coordinate, AXES)
QUARTER = (Range(X, ZERO, a), Range(Y, ZERO, b * X / a))
SLICED: tuple[Shape, ...] = (
    Rod(L),
    Arc(R, Symbol("t")),
    Disc(R),
    Ring(R),
    Annulus(WALLS),
    Rectangle((a, b)),
    Triangle((a, b, c)),
    Triangle((), ((ZERO, ZERO), (a, b), (-b, c))),
    Cylinder(R, L),
    CylindricalShell(R, (), L),
    CylindricalShell(None, WALLS, L),
    Sphere(R),
    SphericalShell(R),
    SphericalShell(None, WALLS),
    Hemisphere(R),
    HemisphericalShell(R),
    Cone(R, L),
    Cuboid((a, b, c)),
    Ellipsoid((a, b, c)),
    Lamina(frozenset(VALUES), QUARTER),
    Revolution(frozenset(VALUES), (Range(Z, ZERO, L), Range(coordinate("r"), r, r + R * Z / L))),
    Graded(frozenset(VALUES), Rod(L), X),
    Graded(frozenset(VALUES), Lamina(frozenset(VALUES), QUARTER), X * Y),
)
Numeric = Callable[[Formula, Mapping[str, float]], float]


@pytest.mark.parametrize("shape", SLICED, ids=lambda shape: f"{type(shape).__name__} {shape.word}")
def test_elements_add_up_to_the_table(shape: Shape, number: Numeric) -> None:
    cut = shape.slicing()
    assert cut is not None
    whole = number(cut.total(ONE), VALUES)
    assert whole == pytest.approx(number(shape.content(), VALUES))
    table = [number(part, VALUES) for part in (*shape.centroid(), shape.rise())]
    centre = [number(cut.total(cut.first(axis)), VALUES) / whole for axis in AXES]
    origin = [number(part, VALUES) for part in cut.origin]
    assert [x + y for x, y in zip(centre, origin, strict=True)] == pytest.approx(table, abs=1e-9)
    arm: Place = tuple(Number(Fraction(x)) for x in centre)  # type: ignore[assignment]
    tensor, less = shape.tensor(ONE), displaced(ONE, arm)
    for entry in ENTRIES:
        found = number(cut.total(cut.second(entry)), VALUES) / whole - number(less.entry(entry), VALUES)
        assert found == pytest.approx(number(tensor.entry(entry), VALUES), abs=1e-9), entry
    assert number(shape.moment(ONE), VALUES) == pytest.approx(number(tensor.zz, VALUES))


def test_every_shape_with_elements_is_among_them() -> None:
    held = {type(shape) for shape in SLICED} | {Polygon}
    assert [shape.word for shape in SHAPES if shape not in held and shape.rigid and shape.word != "particle"] == []


def test_a_coordinate_may_be_counted_from_elsewhere(number: Numeric) -> None:
    moved = Rod(L).slicing().measured_from((ZERO, ZERO, ZERO))
    assert moved is not None
    assert number(moved.total(moved.second("zz")), VALUES) == pytest.approx(VALUES["L"] ** 3 / 12)
    assert Disc(R).slicing().measured_from((R, ZERO, ZERO)) is None


def test_a_polygon_is_the_sum_of_its_triangles(number: Numeric) -> None:
    corners = [(0.0, 0.0), (2.0, 0.3), (1.7, 1.9), (-0.4, 1.1)]
    exact = tuple((Number(Fraction(x)), Number(Fraction(y))) for x, y in corners)
    tensor, centre, area = Polygon(exact).tensor(ONE), Polygon(exact).centroid(), Polygon(exact).measure()
    whole = [0.0] * 3
    for k in (1, 2):
        piece = [corners[0], corners[k], corners[k + 1]]
        (x1, y1), (x2, y2), (x3, y3) = piece
        share = ((x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)) / 2 / number(area, {})
        mids = [((p + q) / 2, (s + t) / 2) for (p, s), (q, t) in itertools.combinations(piece, 2)]
        for x, y in mids:  # a third of the mass in the middle of each side has the moments of a triangle
            u, v = x - number(centre[0], {}), y - number(centre[1], {})
            for index, part in enumerate((v * v, u * u, -u * v)):
                whole[index] += share / 3 * part
    assert [number(tensor.entry(entry), {}) for entry in ("xx", "yy", "xy")] == pytest.approx(whole)


def test_a_turned_tensor_keeps_trace_and_determinant_of_the_plane() -> None:
    tensor = InertiaTensor(Number(Fraction(2)), Number(Fraction(5)), Number(Fraction(6)), Number(Fraction(1)))
    cos, sin = Number(Fraction(3, 5)), Number(Fraction(4, 5))
    turned = tensor.turned(((cos, -sin, ZERO), (sin, cos, ZERO), (ZERO, ZERO, ONE)))
    assert turned.xx + turned.yy == Number(Fraction(7)) and turned.zz == tensor.zz
    assert simplify(turned.xx * turned.yy - turned.xy**2) == Number(Fraction(9))


# composites: each part stands for particles with the same mass, centre and second moments

Cloud = list[tuple[float, float, float, float]]


def cloud(shape: str, mass: float, sizes: tuple[float, ...]) -> Cloud:
    """Particles (m, x, y, z) with the second moments of a uniform shape."""
    if shape == "rod":
        return [(mass / 6, -sizes[0] / 2, 0, 0), (mass / 6, sizes[0] / 2, 0, 0), (mass * 2 / 3, 0, 0, 0)]
    if shape == "disc":
        d = sizes[0] / math.sqrt(2)
        return [(mass / 4, x, y, 0) for x, y in ((d, 0), (-d, 0), (0, d), (0, -d))]
    if shape == "sphere":
        d = sizes[0] * math.sqrt(3 / 5)
        ends = ((d, 0, 0), (0, d, 0), (0, 0, d))
        return [(mass / 6, s * x, s * y, s * z) for x, y, z in ends for s in (1, -1)]
    halves = [size / math.sqrt(12) for size in (*sizes, 0.0)[:3]]
    signs = list(itertools.product((1, -1), repeat=3))
    return [(mass / 8, *(s * half for s, half in zip(sign, halves, strict=True))) for sign in signs]


KINDS = {"rod": 1, "disc": 1, "sphere": 1, "rectangle": 2, "cuboid": 3}
size = st.integers(1, 30).map(lambda n: n / 10)
place = st.integers(-20, 20).map(lambda n: n / 10)
part = st.sampled_from(sorted(KINDS)).flatmap(
    lambda kind: st.tuples(
        st.just(kind),
        size,
        st.tuples(*[size] * KINDS[kind]),
        st.tuples(place, place, place),
        st.integers(-11, 12).map(lambda n: 15 * n),
    )
)


def written(name: str, item: tuple[str, float, tuple[float, ...], tuple[float, ...], int]) -> str:
    kind, mass, sizes, at, angle = item
    key = {"rod": "length", "disc": "radius", "sphere": "radius"}.get(kind)
    extent = f"{key}: {sizes[0]} m" if key else f"sides: [{', '.join(f'{x} m' for x in sizes)}]"
    spot = ", ".join("0" if x == 0 else f"{x} m" for x in at)
    return f"      {name}: {{shape: {kind}, mass: {mass} kg, {extent}, at: [{spot}], angle: {angle} deg}}"


@pytest.mark.exhaustive
@settings(max_examples=20, deadline=None)
@given(st.lists(part, min_size=1, max_size=3), st.tuples(place, place, place), st.booleans())
def test_tensor_of_a_composite_is_that_of_particles(
    parts: list[tuple[str, float, tuple[float, ...], tuple[float, ...], int]],
    point: tuple[float, ...],
    central: bool,
) -> None:
    lines = [written(f"p{k}", item) for k, item in enumerate(parts)]
    spot = ", ".join("0" if x == 0 else f"{x} m" for x in point)
    about = "" if central else " about body.Q"
    scene = "\n".join(
        [
            *("title: t", "bodies:", "  body:", "    parts:"),
            *lines,
            f"    points: {{Q: [{spot}]}}",
            f"find: {{T: body.inertia_tensor{about}}}\n",
        ]
    )
    particles: Cloud = []
    for kind, mass, sizes, at, angle in parts:
        cos, sin = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        for m, x, y, z in cloud(kind, mass, sizes):
            particles.append((m, at[0] + cos * x - sin * y, at[1] + sin * x + cos * y, at[2] + z))
    total = sum(m for m, *_ in particles)
    if central:
        point = tuple(sum(item[0] * item[k] for item in particles) / total for k in (1, 2, 3))
    expected = [[0.0] * 3 for _ in range(3)]
    for m, *rest in particles:
        arm = [x - y for x, y in zip(rest, point, strict=True)]
        for i, j in itertools.product(range(3), repeat=2):
            expected[i][j] += m * ((sum(x * x for x in arm) if i == j else 0) - arm[i] * arm[j])
    entries = {part.name: part.value.float for part in solve(scene).answers["T"].answer.components if part.value}
    for row, names in zip(expected, ROWS, strict=True):
        assert [entries[name] for name in names] == pytest.approx(row, abs=1e-9)


# what is refused, and two ways to one number

ARM = """title: t
given: {M: 2 kg, R: 20 cm, m: 1 kg, h: 30 cm, w: 4 rad/s}
bodies:
  wheel: {shape: disc, mass: M, radius: R, points: {P: [R, 0]}}
  rotor: {inertia: 2 kg m^2, radius: R}
  arm: {parts: {bead: {mass: m, at: [R, 0, h]}, hub: {shape: disc, mass: M, radius: R}}}
  frame: {shape: polygon, mass: M, corners: [[0, 0], [R, 0], [R, R]]}
connections: {axle: {axle: arm}}
states: {now: {arm.angular_velocity: w}}
find: {x: PHRASE}
"""


@pytest.mark.parametrize(
    ("phrase", "message"),
    [
        ("rotor.inertia along x", "only the moment of inertia of `rotor` about its axis is known"),
        ("frame.inertia by integration", "`frame` has no usual elements over which to integrate"),
        ("arm.inertia by integration", "`arm` is made of several pieces"),
        ("wheel.inertia along tangential", "`along tangential` is no axis of a moment of inertia"),
        ("wheel.inertia about rotor.center", "`rotor` is no point of `wheel`"),
        ("wheel.speed by integration", "`by integration` says nothing of `speed`"),
        ("arm.angular_momentum.x", "is asked about a point of its axis"),
        ("arm.angular_momentum.x about arm.bead", "is asked about a point of its axis"),
        ("wheel.angular_momentum.x about wheel.center", "turns about no fixed axis"),
    ],
)
def test_what_can_not_be_told_is_refused_by_name(phrase: str, message: str) -> None:
    with pytest.raises((SceneError, Unsolvable), match=re.escape(message)):
        solve(ARM.replace("PHRASE", phrase))


@pytest.mark.parametrize(
    "body", ["wheel.inertia about wheel.P", "wheel.gyration", "wheel.inertia_tensor.zz about wheel.P"]
)
def test_integration_gives_what_the_table_says(body: str) -> None:
    table, integrated = (
        solve(ARM.replace("PHRASE", phrase)).answers["x"] for phrase in (body, f"{body} by integration")
    )
    assert table.formula == integrated.formula


def test_both_ways_may_be_asked_in_one_scene() -> None:
    scene = ARM.replace("x: PHRASE", "x: wheel.inertia, y: wheel.inertia by integration")
    solution = solve(scene)
    assert solution.answers["x"].exact == solution.answers["y"].exact == "½ M R²"
    assert "rings of radius r" in solution.to("text")


def test_of_integrals_within_each_other_the_inner_one_is_carried_out_first() -> None:
    scene = """title: Sheet with a density that varies
given: {a: 3 m, b: 4 m, c: 2 kg/m^4}
bodies: {sheet: {shape: lamina, density: c*x*y, region: {x: [0, a], y: [0, b*x/a]}}}
find: {M: sheet.mass}"""
    text = " ".join(solve(scene).to("text").split())
    assert "M = (c b²/(2 a²)) ∫[0 → a] x³ dx M = (c b²/(2 a²)) (¼ a⁴) M = ⅛ c a² b²" in text


def test_an_integral_that_serves_two_questions_is_worked_out_once() -> None:
    scene = """title: Bowl that is full
given: {M: 3 kg, R: 0.2 m}
bodies: {bowl: {shape: solid of revolution, mass: M, profile: {z: [0, R], r: sqrt(R^2 - z^2)}}}
find: {z: bowl.cm.z, I: bowl.inertia}"""
    text = solve(scene).to("text")
    assert text.count("(R³ − ⅓ R³)") == 1


def test_angular_momentum_is_the_tensor_times_the_angular_velocity() -> None:
    scene = ARM.replace("x: PHRASE", "L: arm.angular_momentum about arm.center, T: arm.inertia_tensor about arm.center")
    answers = solve(scene).answers
    momentum = [answers["L"].components[axis].float for axis in AXES]
    column = [answers["T"].components[entry].float for entry in ("zx", "yz", "zz")]
    assert momentum == pytest.approx([4 * (x or 0.0) for x in column])
    assert momentum == pytest.approx([-4 * 1 * 0.3 * 0.2, 0, 4 * (0.2**2 + 2 * 0.2**2 / 2)])


def test_a_distance_that_the_scene_calls_d_is_not_explained_by_itself() -> None:
    plate = """title: Disc with a hole off its centre
given: {M: 5 kg, R: 30 cm, r: 5 cm, d: 15 cm, q: 5 cm}
bodies:
  wheel:
    shape: disc
    mass: M
    radius: R
    holes: {one: {shape: disc, radius: r, at: [d, 0]}, other: {shape: disc, radius: r, at: [-d, 0]}}
find: {I: wheel.inertia}
"""
    text = solve(plate).to("text")
    assert "m_one d²" in text and "(d =" not in text
    assert "(d = q)" in solve(plate.replace("[d, 0]", "[q, 0]").replace("[-d, 0]", "[-q, 0]")).to("text")
