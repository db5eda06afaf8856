"""Families in space: tops, free bodies, tensors, shafts and coins where nearly equal terms or many decades meet."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from mpmath import acos, atan2, cos, ellipfun, ellipk, matrix, mp, mpf, pi, sin, sqrt

from trials.case import Case, Family, G, given, letters, scene, tenth
from trials.draw import Value, exactly, radians

DIGITS = (6, 50)
TOP = {
    "mass": "M",
    "inertia": {"about": "tip", "principal": ["A", "A", "C"]},
    "axis": "z",
    "points": {"tip": ["0", "0", "-l"]},
}
MASS, ARM = given(Fraction(1, 5), "kg"), given(Fraction(1, 25), "m")
ACROSS, ALONG = given(Fraction(1, 1600), "kg m^2"), given(Fraction(1, 12500), "kg m^2")
SIXTY = given(Fraction(60), "deg")  # of a rational cosine, so that tops can be chosen as near to an edge as is liked
WEIGHT = MASS.x * G * ARM.x


def top(title: str, rate: Value, tilt: Value, states: dict[str, object], gravity: str = "9.8 m/s^2") -> Case:
    """A symmetric top on its tip that turns at `rate` about its axis and leans by `tilt`."""
    values = {**letters(M=MASS, l=ARM, A=ACROSS, C=ALONG, w=rate, theta=tilt), "g": gravity}
    return Case(
        scene(
            title, up="z", given=values, bodies={"top": TOP}, connections={"floor": {"ball": "top.tip"}}, states=states
        )
    )


def let_go() -> Iterator[Case]:
    """A top that is let go and spins with 10ᵏ rad/s: how far it sinks, how fast it goes round there, and how long it takes."""
    for power in range(0, 13):
        rate = given(Fraction(10) ** power, "rad/s")
        case = top("Top let go", rate, SIXTY, {"start": released("0 rad/s"), "low": {"top.tilt": "largest"}})
        nods(case, rate, mpf(0), "low")
        yield case


def nearly_steady() -> Iterator[Case]:
    """A top that goes round at 4 rad/s, and spins faster or slower by 10⁻ᵏ than a steady precession at this tilt takes."""
    turning = Fraction(4)
    steady = (MASS.number * ARM.number * Fraction("9.8") / turning + ACROSS.number * turning / 2) / ALONG.number
    for power in range(1, 25):
        rate = given(steady * (1 + (-1) ** power * tenth(power)), "rad/s")
        end = "largest" if power % 2 else "smallest"
        case = top("Top that hardly nods", rate, SIXTY, {"start": released("4 rad/s"), "end": {"top.tilt": end}})
        nods(case, rate, mpf(4), "end")
        yield case


def released(precession: str) -> dict[str, str]:
    return {"top.tilt": "theta", "top.axial_rate": "w", "top.precession": precession, "top.nutation": "0 rad/s"}


def nods(case: Case, rate: Value, precession: mpf, end: str) -> None:
    """u̇² = b (u − u₀)(u − u₁)(u − u₂) for u = cos θ: the tilt at the other end, the precession there, and T = 2 K(m)/p."""
    a, b, first = ALONG.x * rate.x / ACROSS.x, 2 * WEIGHT / ACROSS.x, cos(radians(SIXTY))
    about = precession * (1 - first**2) + a * first  # angular momentum about the vertical, over A
    middle = -(precession**2) * (1 - first**2) - a**2
    last = first * middle + 2 * a * about - b
    root = sqrt(middle**2 - 4 * b * last)
    other, beyond = (-middle - root) / (2 * b), (-middle + root) / (2 * b)
    low, high = sorted((first, other))
    case.ask("theta_1", f"top.tilt at {end}", acos(other))
    case.ask("D", "theta_1 - theta", acos(other) - acos(first))
    case.ask("W", f"top.precession at {end}", (about - a * other) / (1 - other**2))
    pace = sqrt(b * (beyond - low)) / 2
    case.ask("T", "top.period at start", 2 * ellipk((high - low) / (beyond - low)) / pace)


def least_spin() -> Iterator[Case]:
    """A top that spins faster by 10⁻ᵏ than it must to lean steadily: both precessions, whose difference goes as its root."""
    least = Fraction(125)  # I₃² ω² = 4 A M g l cos θ for g = 10 m/s²
    for power in range(1, 25):
        rate = given(least * (1 + tenth(power)), "rad/s")
        case = top(
            "Top near its least spin",
            rate,
            SIXTY,
            {"now": {"top.tilt": "theta", "top.axial_rate": "w", "steady": "true"}},
            "10 m/s^2",
        )
        axial = ALONG.x * rate.x
        root = sqrt(axial**2 - mpf(10) ** -4)
        case.ask("a", "smallest top.precession at now", (axial - root) / ACROSS.x)
        case.ask("b", "largest top.precession at now", (axial + root) / ACROSS.x)
        yield case


def near_the_edge() -> Iterator[Case]:
    """A free body with I, 2 I, 3 I that is thrown 10⁻ᵏ off its middle axis: its period, and how it turns after 20 s."""
    moments = tuple(given(Fraction(number, 1000), "kg m^2") for number in (1, 2, 3))
    for power in range(1, 13):
        yield thrown(moments, given(5 * tenth(power), "rad/s"), given(Fraction(5), "rad/s"), Fraction(20))


def long_after() -> Iterator[Case]:
    """A racket that turns over and over: after 10ᵏ s."""
    moments = tuple(given(Fraction(text), "kg m^2") for text in ("0.00121", "0.01638", "0.01748"))
    for power in range(0, 13):
        yield thrown(moments, given(Fraction(1, 5), "rad/s"), given(Fraction(12), "rad/s"), Fraction(10) ** power)


def thrown(moments: tuple[Value, ...], off: Value, main: Value, after: Fraction) -> Case:
    """ω = (a nd, w cd, s sd)(p t, m) of ω = (a, w, 0) at first, put into Euler's equations for p, m and s."""
    time = given(after, "s")
    values = letters(**dict(zip(("A", "B", "C"), moments, strict=True)), a=off, w=main, T=time)
    case = Case(
        scene(
            "Thrown body",
            up="z",
            gravity="none",
            given=values,
            bodies={"body": {"mass": "1 kg", "inertia": {"principal": ["A", "B", "C"]}}},
            states={"start": {"body.angular_velocity in body axes": ["a", "w", "0"]}, "later": {"time": "T"}},
        )
    )
    A, B, C = (moment.x for moment in moments)
    small, large = (C - A) * (B - A) * off.x**2 / (B * C), (C - B) * (B - A) * main.x**2 / (A * C)
    pace, m = sqrt(small + large), large / (small + large)
    turn = mp.fmod(pace * time.x, 4 * ellipk(m))
    sn, cn, dn = (ellipfun(name, turn, m=m) for name in ("sn", "cn", "dn"))
    case.ask("T_r", "body.period at start", 4 * ellipk(m) / pace)
    case.ask("w_x", "body.angular_velocity.x at later in body axes", off.x / dn)
    case.ask("w_y", "body.angular_velocity.y at later in body axes", main.x * cn / dn)
    case.ask("w_z", "body.angular_velocity.z at later in body axes", (A - B) * off.x * main.x / (C * pace) * sn / dn)
    return case


def nearly_spherical() -> Iterator[Case]:
    """A free body whose moments along and across differ by 10⁻ᵏ, either way."""
    for power in range(1, 25):
        A = given(Fraction(1, 50), "kg m^2")
        C = given(A.number * (1 + (-1) ** power * tenth(power)), "kg m^2")
        case = Case(
            scene(
                "Nearly spherical body",
                up="z",
                gravity="none",
                given={**letters(A=A, C=C), "w": "10 rad/s", "v": "4 rad/s"},
                bodies={"body": {"inertia": {"principal": ["A", "A", "C"]}, "axis": "z"}},
                states={"now": {"body.angular_velocity": ["v", "0", "w"]}},
            )
        )
        spin = (A.x - C.x) * 10 / A.x
        case.ask("psi", "body.spin", spin)
        case.ask("phi", "body.precession", sqrt(16 * A.x**2 + 100 * C.x**2) / A.x)
        case.ask("T", "body.period at now", 2 * pi / abs(spin))
        gap = atan2(40 * abs(A.x - C.x), 16 * A.x + 100 * C.x)
        case.ask("gap", "angle of body.angular_momentum from body.angular_velocity", gap)
        yield case


def nearly_equal_moments() -> Iterator[Case]:
    """A tensor that is a sphere's but for 10⁻ᵏ of another one, which has one principal axis along z."""
    shape = ((1, 2, 0), (2, 0, 0), (0, 0, 2))
    for power in range(1, 25):
        tensor = [[2 * (row == column) + tenth(power) * shape[row][column] for column in range(3)] for row in range(3)]
        entries = [[given(entry, "kg m^2").text for entry in line] for line in tensor]
        case = Case(
            scene(
                "Nearly spherical tensor",
                up="z",
                bodies={"body": {"mass": "1 kg", "inertia": {"tensor": entries, "about": "cm"}}},
            )
        )
        moments = sorted(mp.eigsy(matrix([[exactly(entry) for entry in line] for line in tensor]), eigvals_only=True))
        case.ask("I_p", "body.principal_moments")
        case.expected |= {f"I_p.{number}": moment for number, moment in enumerate(moments, 1)}
        yield case


def oblique() -> Iterator[Case]:
    """A block that turns about its diagonal through a place off its centre, its length and the far bearing over decades."""
    for power in range(-12, 13):
        a, q = given(Fraction(10) ** power, "m"), given(Fraction(10) ** -power, "m")
        body = {"shape": "cuboid", "mass": "m", "sides": ["a", "b", "c"], "points": {"P": ["e", "0", "0"]}}
        shaft = {"hinge": "block.P", "along": ["a", "b", "c"], "bearings": ["-p", "q"], "angular_velocity": "w"}
        case = Case(
            scene(
                "Oblique shaft",
                up="z",
                gravity="none",
                given={
                    **letters(a=a, q=q),
                    **{"m": "6 kg", "b": "1 m", "c": "2 m", "e": "1 cm", "p": "30 cm", "w": "50 rad/s"},
                },
                bodies={"block": body},
                connections={"shaft": shaft},
            )
        )
        near, far = bearings(a.x, q.x)
        case.ask("F_1", "size of shaft.bearing1.force", near)
        case.ask("F_2", "size of shaft.bearing2.force", far)
        yield case


def bearings(a: mpf, q: mpf) -> tuple[mpf, mpf]:
    """Sizes of F₁ and F₂: F₁ + F₂ = −m ω² r⊥ and q F₂ − p F₁ = τ × n, τ = ω² n × I n about the place held."""
    mass, p, square = mpf(6), mpf("0.3"), mpf(2500)
    sides = (a, mpf(1), mpf(2))
    length = sqrt(mp.fsum(side**2 for side in sides))
    n, centre = [side / length for side in sides], (-mpf("0.01"), mpf(0), mpf(0))
    own = [mass * (mp.fsum(side**2 for side in sides) - side**2) / 12 for side in sides]
    along = mp.fdot(centre, n)
    across = [place - along * part for place, part in zip(centre, n, strict=True)]
    # I n about the place held, less its part along n, which is all that n × I n has.
    turned = [moment * part - mass * place * along for moment, part, place in zip(own, n, centre, strict=True)]
    inward = mp.fdot(turned, n)
    # τ × n of τ = ω² n × X is ω² (X − n (n · X))
    couple = [square * (entry - inward * part) for entry, part in zip(turned, n, strict=True)]
    push = [-mass * square * place for place in across]
    second = [(entry + p * force) / (p + q) for entry, force in zip(couple, push, strict=True)]
    first = [force - other for force, other in zip(push, second, strict=True)]
    return mp.norm(matrix(first)), mp.norm(matrix(second))


def upright_coin() -> Iterator[Case]:
    """A coin that rolls in a circle and leans by 10⁻ᵏ°: both precessions, over many decades."""
    for power in range(0, 13):
        theta = given(90 - tenth(power), "deg")
        case = Case(
            scene(
                "Coin near upright",
                up="z",
                given={"theta": theta.text, "R": "2 cm", "s": "30 rad/s", "g": "9.8 m/s^2"},
                surfaces={"table": "level"},
                bodies={"coin": {"shape": "disc", "mass": "0.01 kg", "radius": "R"}},
                connections={"grip": {"rolls": ["coin", "table"]}},
                states={"now": {"coin.tilt": "theta", "coin.spin": "s", "steady": "true"}},
            )
        )
        sine, cosine = sin(radians(theta)), sin(pi / 180 * mpf(10) ** -power)
        # 5/4 R Ω² sin θ cos θ + 3/2 R s Ω sin θ + g cos θ = 0
        square, plain, weight = sine * cosine / 40, mpf("0.9") * sine, G * cosine
        root = sqrt(plain**2 - 4 * square * weight)
        case.ask("a", "smallest coin.precession at now", (-plain - root) / (2 * square))
        case.ask("b", "largest coin.precession at now", -2 * weight / (plain + root))
        yield case


IN_SPACE: tuple[Family, ...] = tuple(
    Family(name, parameters, cases, DIGITS)
    for name, parameters, cases in (
        ("top let go, slow and fast", "spin 1 … 10¹² rad/s", let_go),
        ("top that hardly nods", "spin steady (1 ± 10⁻¹ … 10⁻²⁴)", nearly_steady),
        ("leaning top near its least spin", "spin least (1 + 10⁻¹ … 10⁻²⁴)", least_spin),
        ("free body near its middle axis", "10⁻¹ … 10⁻¹² off", near_the_edge),
        ("free asymmetric body, long after", "1 … 10¹² s", long_after),
        ("free symmetric body, nearly spherical", "I₃ = I₁ (1 ± 10⁻¹ … 10⁻²⁴)", nearly_spherical),
        ("tensor of nearly equal principal moments", "10⁻¹ … 10⁻²⁴ from a sphere's", nearly_equal_moments),
        ("block on an oblique shaft, forces of its bearings", "lengths 10⁻¹² … 10¹² m", oblique),
        ("coin in a circle near upright", "leans by 1 … 10⁻¹²°", upright_coin),
    )
)
