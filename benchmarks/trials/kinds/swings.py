"""Swings: periods of pendulums, small and large, and of bodies on springs and wires."""

from __future__ import annotations

from mpmath import ellipk, mp, mpf, sin, sqrt

from trials.case import Case, G, letters, scene
from trials.draw import Draw, radians


def small(draw: Draw) -> Case:
    """A rod hinged at a place along it: small swings."""
    M, L = draw.size("kg"), draw.size("m")
    share = draw.share(4)
    case = Case(
        scene(
            "Rod on a nail",
            given={**letters(M=M, L=L), "s": share.text},
            bodies={"rod": {"shape": "rod", "mass": "M", "length": "L"}},
            connections={"nail": {"hinge": "rod.at(s*L)"}},
        )
    )
    arm = abs(mpf(1) / 2 - share.x) * L.x
    inertia = L.x**2 / 12 + arm**2
    case.ask("T", "period of small swings", 2 * mp.pi * sqrt(inertia / (G * arm)))
    case.ask("w", "angular_frequency of small swings", sqrt(G * arm / inertia))
    return case


def wide(draw: Draw) -> Case:
    """A rod about its end that swings through a large angle."""
    M, L, theta = draw.size("kg"), draw.size("m"), draw.angle(5, 179)
    case = Case(
        scene(
            "Rod swinging far",
            given=letters(M=M, L=L, theta=theta),
            bodies={"rod": {"shape": "rod", "mass": "M", "length": "L"}},
            connections={"pin": {"hinge": "rod.start"}},
            states={"released": {"rod.angle": "theta - 90 deg", "at rest": "all"}, "low": {"rod.angle": "-90 deg"}},
        )
    )
    half = sin(radians(theta) / 2) ** 2
    case.ask("T", "period of swings from released", 4 * sqrt(2 * L.x / (3 * G)) * ellipk(half))
    case.ask("omega", "size of rod.angular_velocity at low", sqrt(6 * G * half / L.x))
    return case


def torsion(draw: Draw) -> Case:
    """A disc on a torsion wire, turned and let go."""
    M, R, kappa, theta = draw.size("kg"), draw.size("m"), draw.size("N m/rad"), draw.angle()
    case = Case(
        scene(
            "Disc on a wire",
            given=letters(M=M, R=R, kappa=kappa, theta=theta),
            bodies={"disc": {"shape": "disc", "mass": "M", "radius": "R"}},
            connections={"axle": {"axle": "disc"}, "wire": {"torsion": "disc", "stiffness": "kappa"}},
            states={"turned": {"disc.angle": "theta", "at rest": "all"}, "through": {"disc.angle": "0"}},
        )
    )
    inertia = M.x * R.x**2 / 2
    case.ask("alpha", "disc.angular_acceleration at turned", -kappa.x * radians(theta) / inertia)
    case.ask("omega", "size of disc.angular_velocity at through", sqrt(kappa.x / inertia) * radians(theta))
    case.ask("T", "period of small swings", 2 * mp.pi * sqrt(inertia / kappa.x))
    return case


def sprung(draw: Draw) -> Case:
    """A block on a spring on a smooth floor, stretched and let go."""
    m, k, x, share = draw.size("kg"), draw.size("N/m"), draw.size("m"), draw.share(9)
    case = Case(
        scene(
            "Block on a spring",
            given={**letters(m=m, k=k, x=x), "s": share.text},
            surfaces={"floor": "level"},
            bodies={"block": {"mass": "m", "moves": "right"}},
            connections={
                "base": {"contact": ["block", "floor"]},
                "coil": {"spring": ["ground", "block"], "stiffness": "k"},
            },
            states={"pulled": {"coil.elongation": "x", "at rest": "all"}, "later": {"coil.elongation": "s*x"}},
        )
    )
    case.ask("a", "block.acceleration at pulled", -k.x * x.x / m.x)
    case.ask("v", "block.velocity at later", -sqrt(k.x / m.x * (1 - share.x) * (1 + share.x)) * x.x)
    case.ask("t", "time from pulled to later", mp.acos(share.x) * sqrt(m.x / k.x))
    return case
