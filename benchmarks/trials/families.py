"""Families: problems at parameters where floating point loses its figures, each with its answer by mpmath at 150 figures."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from mpmath import atan, cos, ellipk, exp, mp, mpf, sin, sqrt, tan

from trials.case import Case, Family, G, Train, given, letters, scene, tenth
from trials.draw import FIGURES, Draw, Value, exactly, radians
from trials.figures import wrong
from trials.kinds import KINDS
from trials.outcome import outcome
from trials.scene import written


def atwood() -> Iterator[Case]:
    """m₁ and m₂ = m₁ (1 + 10⁻ᵏ) on a heavy pulley."""
    for power in range(1, 25):
        m, n, M, R = (
            given(Fraction(2), "kg"),
            given(2 + 2 * tenth(power), "kg"),
            given(Fraction(3), "kg"),
            given(Fraction(1, 5), "m"),
        )
        bodies = {
            "left": {"mass": "m", "moves": "up"},
            "right": {"mass": "n", "moves": "down"},
            "pulley": {"shape": "disc", "mass": "M", "radius": "R", "turns": "clockwise"},
        }
        connections = {"axle": {"axle": "pulley"}, "cord": {"string": ["left", "pulley", "right"]}}
        case = Case(scene("Atwood", given=letters(m=m, n=n, M=M, R=R), bodies=bodies, connections=connections))
        pace = (n.x - m.x) * G / (m.x + n.x + M.x / 2)
        case.ask("a", "left.acceleration", pace)
        case.ask("T", "cord.left.tension", m.x * (G + pace))
        case.ask("D", "cord.right.tension - cord.left.tension", M.x * pace / 2)
        yield case


def unequal() -> Iterator[Case]:
    """Masses in the ratio 10ᵏ, and the small difference of the tensions."""
    for power in range(-12, 13):
        m, n = given(Fraction(10) ** power, "kg"), given(Fraction(3), "kg")
        bodies = {
            "left": {"mass": "m", "moves": "up"},
            "right": {"mass": "n", "moves": "down"},
            "pulley": {"shape": "ring", "mass": "m", "radius": "10 cm", "turns": "clockwise"},
        }
        connections = {"axle": {"axle": "pulley"}, "cord": {"string": ["left", "pulley", "right"]}}
        case = Case(scene("Unequal masses", given=letters(m=m, n=n), bodies=bodies, connections=connections))
        pace = (n.x - m.x) * G / (2 * m.x + n.x)
        case.ask("a", "right.acceleration", pace)
        case.ask("D", "cord.right.tension - cord.left.tension", m.x * pace)
        yield case


def upright() -> Iterator[Case]:
    """A rod let go 10⁻ᵏ rad from upright, when it lies level and just after its start."""
    for power in range(1, 13):
        eps = given(tenth(power), "rad")
        case = Case(
            scene(
                "Rod from upright",
                given={"M": "2 kg", "L": "1.5 m", "eps": eps.text},
                bodies={"rod": {"shape": "rod", "mass": "M", "length": "L"}},
                connections={"pin": {"hinge": "rod.start"}},
                states={
                    "up": {"rod.angle": "90 deg - eps", "at rest": "all"},
                    "next": {"rod.angle": "90 deg - 2*eps"},
                    "level": {"rod.angle": "0 deg"},
                },
            )
        )
        L = mpf("1.5")
        case.ask("alpha", "rod.angular_acceleration at up", -3 * G * sin(eps.x) / (2 * L))
        case.ask("w", "rod.angular_velocity at next", -sqrt(6 * G / L * sin(3 * eps.x / 2) * sin(eps.x / 2)))
        case.ask("u", "rod.angular_velocity at level", -sqrt(3 * G * cos(eps.x) / L))
        yield case


def turns() -> Iterator[Case]:
    """A rod at an angle of 10ᵏ turns and 30°, and a disc that turns so far."""
    for power in range(0, 7):
        angle = given(Fraction(360) * 10**power + 30, "deg")
        case = Case(
            scene(
                "Many turns",
                given={"M": "2 kg", "L": "1.5 m", "theta": angle.text},
                bodies={
                    "rod": {"shape": "rod", "mass": "M", "length": "L"},
                    "disc": {"shape": "disc", "mass": "M", "radius": "L"},
                },
                connections={"pin": {"hinge": "rod.start"}, "axle": {"axle": "disc"}},
                actions={"motor": {"couple": "3 N m", "on": "disc"}},
                states={"start": {"rod.angle": "theta", "at rest": "all"}, "end": {"disc.rotation": "theta"}},
            )
        )
        L, turn = mpf("1.5"), radians(angle)
        case.ask("alpha", "rod.angular_acceleration at start", -3 * G * cos(mp.pi / 6) / (2 * L))
        case.ask("w", "disc.angular_velocity at end", sqrt(2 * turn * 3 / L**2))
        case.ask("n", "disc.turns from start to end", turn / (2 * mp.pi))
        yield case


def pendulum() -> Iterator[Case]:
    """A rod that swings from 10⁻ᵏ° and from 180° − 10⁻ᵏ°."""
    for power in range(0, 13):
        for number in (tenth(power), 180 - tenth(power)):
            theta = given(number, "deg")
            case = Case(
                scene(
                    "Pendulum",
                    given={"L": "1.2 m", "theta": theta.text},
                    bodies={"rod": {"shape": "rod", "mass": "2 kg", "length": "L"}},
                    connections={"pin": {"hinge": "rod.start"}},
                    states={"released": {"rod.angle": "theta - 90 deg", "at rest": "all"}},
                )
            )
            case.ask(
                "T", "period of swings from released", 4 * sqrt(mpf("0.8") / G) * ellipk(sin(radians(theta) / 2) ** 2)
            )
            yield case


def verge() -> Iterator[Case]:
    """A block on a slope whose tan differs from μ by 10⁻ᵏ of it, and a cylinder whose grip is just enough or just not."""
    for power in range(3, 25):
        for sign in (1, -1):
            mu = given(Fraction(3, 4), "")
            slope = atan(exactly(mu.number)) * 180 / mp.pi * (1 + sign * mpf(10) ** -power)
            beta = given(Fraction(int(mp.floor(slope * mpf(10) ** 30)), 10**30), "deg")
            case = Case(
                scene(
                    "On the verge",
                    given={"mu": mu.text, "beta": beta.text},
                    surfaces={"ramp": {"slope": "beta", "down": "left"}},
                    bodies={"block": {"mass": "2 kg", "moves": "down"}},
                    connections={"base": {"contact": ["block", "ramp"], "friction": "mu"}},
                    states={"now": "at rest"},
                )
            )
            angle = radians(beta)
            slides = tan(angle) > mu.x
            case.ask("a", "block.acceleration", G * (sin(angle) - mu.x * cos(angle)) if slides else mpf(0))
            yield case


def steep() -> Iterator[Case]:
    """A ladder, a slope and a chain at 10⁻ᵏ° from the vertical, where tan has its pole."""
    for power in range(0, 13):
        beta = given(90 - tenth(power), "deg")
        case = Case(
            scene(
                "Steep",
                given={"beta": beta.text},
                surfaces={"floor": "level", "side": {"wall": "right"}},
                bodies={"ladder": {"shape": "rod", "mass": "12 kg", "length": "4 m"}},
                connections={
                    "foot": {"contact": ["ladder.start", "floor"]},
                    "head": {"contact": ["ladder.end", "side"]},
                },
                actions={"rope": {"force": "unknown", "on": "ladder.start", "direction": "right"}},
                states={"still": {"ladder.angle": "beta", "balance": "true"}},
            )
        )
        case.ask("F", "rope.force", 6 * G / tan(radians(beta)))
        case.ask("P", "head.normal_force", 6 * G / tan(radians(beta)))
        yield case


def spool() -> Iterator[Case]:
    """A spool pulled at nearly the angle at which it does not roll, cos φ = r/R, and with r nearly R."""
    for power in range(1, 20):
        r, R = given(Fraction(1, 2) + tenth(power), "m"), given(Fraction(1), "m")
        yield _spool(given(Fraction(60), "deg"), r, R)
        yield _spool(given(tenth(min(power, 12)), "deg"), given(1 - tenth(power), "m"), R)


def _spool(phi: Value, r: Value, R: Value) -> Case:
    case = Case(
        scene(
            "Spool",
            given=letters(phi=phi, r=r, R=R),
            surfaces={"floor": "level"},
            bodies={
                "spool": {
                    "mass": "3 kg",
                    "inertia": "0.5 kg m^2",
                    "radii": {"flange": "R", "hub": "r"},
                    "moves": "right",
                }
            },
            connections={"base": {"rolls": ["spool.flange", "floor"]}},
            actions={"thread": {"force": "8 N", "on": "spool.hub", "direction": "phi", "under": "true"}},
        )
    )
    case.ask("a", "spool.acceleration", 8 * (cos(radians(phi)) - r.x / R.x) / (3 + mpf("0.5") / R.x**2))
    return case


def tube() -> Iterator[Case]:
    """A tube whose wall is 10⁻ᵏ of its radius."""
    for power in range(1, 25):
        r = given(1 - tenth(power), "m")
        case = Case(
            scene(
                "Thin tube",
                given={"R": "1 m", "r": r.text, "rho": "7800 kg/m^3"},
                bodies={
                    "tube": {
                        "shape": "cylindrical shell",
                        "radii": {"inner": "r", "outer": "R"},
                        "length": "2 m",
                        "density": "rho",
                    }
                },
            )
        )
        mass = 7800 * 2 * mp.pi * (1 - r.x) * (1 + r.x)
        case.ask("m", "tube.mass", mass)
        case.ask("I", "tube.inertia", mass * (1 + r.x**2) / 2)
        yield case


def late() -> Iterator[Case]:
    """A flywheel in oil after 10ᵏ times its time constant, and before."""
    for power in range(-12, 5):
        time_ = given(Fraction(10) ** power, "s")
        case = Case(
            scene(
                "Flywheel in oil",
                gravity="none",
                given={"I": "0.5 kg m^2", "c": "0.5 N m s", "w": "30 rad/s", "T": time_.text},
                bodies={"wheel": {"inertia": "I"}},
                connections={"axle": {"axle": "wheel"}},
                actions={"oil": {"couple": "-c*wheel.angular_velocity", "on": "wheel"}},
                states={"off": {"wheel.angular_velocity": "w"}, "end": {"time": "T"}},
            )
        )
        case.ask("u", "wheel.angular_velocity at end", 30 * exp(-time_.x))
        yield case


def chains() -> Iterator[Case]:
    """A string over 1 to 40 heavy pulleys between two blocks that nearly balance."""
    for count in (1, 2, 3, 5, 10, 20, 40):
        m, n = given(Fraction(2), "kg"), given(2 + tenth(9), "kg")
        bodies: dict[str, object] = {"left": {"mass": "m", "moves": "up"}, "right": {"mass": "n", "moves": "down"}}
        connections: dict[str, object] = {}
        system = Train()
        system.body(m.x, mpf(1), force=-m.x * G)
        system.body(n.x, mpf(1), force=n.x * G)
        names = [f"wheel{number}" for number in range(1, count + 1)]
        for number, name in enumerate(names, 1):
            bodies[name] = {"shape": "disc", "mass": f"{number} kg", "radius": "10 cm", "turns": "clockwise"}
            connections[f"axle{number}"] = {"axle": name}
            system.body(mpf(number) / 2, mpf(1))
        links = ["left", *names, "right"]
        connections["cord"] = {"string": links}
        case = Case(scene("Chain of pulleys", given=letters(m=m, n=n), bodies=bodies, connections=connections))
        case.ask("a", "right.acceleration", system.accelerations()[0])
        yield case


def drawn(style: str, rounds: int) -> Callable[[], Iterator[Case]]:
    """All kinds of random scenes in one style."""
    return lambda: (kind(Draw(f"family-{kind.__name__}-{number}", style)) for kind in KINDS for number in range(rounds))


FAMILIES: tuple[Family, ...] = (
    Family("Atwood machine, nearly equal masses", "m₂ = m₁ (1 + 10⁻¹ … 10⁻²⁴)", atwood),
    Family("masses of very different size, small difference of tensions", "ratio 10⁻¹² … 10¹²", unequal),
    Family("rod let go near upright", "10⁻¹ … 10⁻¹² rad", upright),
    Family("many turns", "1 … 10⁶ turns and 30°", turns),
    Family("period of a pendulum", "from 10⁻¹² … 1°, 179° … 180° − 10⁻¹²°", pendulum),
    Family("sticks or slips", "tan β = μ to 10⁻³ … 10⁻²⁴", verge),
    Family("ladder near the vertical", "90° − 1° … 90° − 10⁻¹²°", steep),
    Family("spool near its critical angle, and r near R", "10⁻¹ … 10⁻¹⁹", spool),
    Family("thin tube, r near R", "wall 10⁻¹ … 10⁻²⁴", tube),
    Family("flywheel in oil, early and late", "10⁻¹² … 10⁴ time constants", late),
    Family("chain of pulleys between nearly equal masses", "1 … 40 pulleys", chains, (6,)),
    Family("all kinds of scenes, over 24 decades", "each value 10⁻¹² … 10¹²", drawn("wide", 8), (6,)),
    Family("all kinds of scenes, values nearly equal", "10⁻³ … 10⁻²⁴, angles to 10⁻¹⁵°", drawn("close", 8), (6,)),
)


@dataclass
class Row:
    """What a family gave: how many scenes and numbers, what was wrong, what the confirmation kept back, and the slowest scene."""

    family: Family
    cases: int = 0
    numbers: int = 0
    wrongs: int = 0
    withheld: int = 0  # numbers that are not printed since the assembly contradicts them; they are judged all the same
    slowest: float = 0.0


def tried(family: Family) -> Row:
    """Solve a family at all of its parameters, and print what is wrong."""
    with mp.workdps(FIGURES):
        row = Row(family)
        for case in family.cases():
            row.cases += 1
            text = written(case.scene)
            for digits in family.digits:
                faults = list(judged(row, case, text, digits))
                row.wrongs += len(faults)
                if faults:
                    print(f"{family.name}, {digits} digits: {'; '.join(faults)}\n{text}", flush=True)
                    break
    told = f"{row.cases} scenes, {row.numbers} numbers, {row.wrongs} wrong, {row.withheld} withheld"
    print(f"{family.name}: {told}", time.strftime("%H:%M:%S"), flush=True)
    return row


def judged(row: Row, case: Case, text: str, digits: int) -> Iterator[str]:
    """What is wrong with the numbers of a scene; what the confirmation keeps back is asked for without it."""
    found = outcome(text, digits)
    row.slowest = max(row.slowest, found.seconds)
    answers, message = found.answers, found.message
    if kept := case.expected.keys() - answers.keys():
        again = outcome(text, digits, confirm=False)
        row.withheld += len(kept & again.answers.keys())
        answers, message = again.answers | answers, again.message or message
    for name, true in case.expected.items():
        if name not in answers:
            yield f"{name}: not answered {message.partition(chr(10))[0]}".rstrip()
            continue
        row.numbers += 1
        if fault := wrong(answers[name], true, digits):
            yield f"{name}: {fault}"
