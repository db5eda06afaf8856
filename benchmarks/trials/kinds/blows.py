"""Blows: what hits a hinged rod and stays, bounces off, or strikes it."""

from __future__ import annotations

from mpmath import mpf

from trials.case import Case, letters, scene
from trials.draw import Draw, Value


def hanging(draw: Draw) -> tuple[Case, Value, Value]:
    M, L = draw.size("kg"), draw.size("m")
    return (
        Case(
            scene(
                "Hanging rod",
                given=letters(M=M, L=L),
                bodies={"rod": {"shape": "rod", "mass": "M", "length": "L"}},
                connections={"pin": {"hinge": "rod.start"}},
                states={"before": {"rod.angle": "-90 deg", "rod.angular_velocity": "0"}, "after": {}},
            )
        ),
        M,
        L,
    )


def joined(draw: Draw) -> Case:
    """A dart that stays in a hanging rod, at a place along it."""
    case, M, L = hanging(draw)
    m, u, share = draw.size("kg"), draw.size("m/s"), draw.share()
    case.scene["given"] |= {**letters(m=m, u=u), "s": share.text}
    case.scene["bodies"]["dart"] = {"mass": "m", "moves": "right"}
    case.scene["states"]["before"]["dart.velocity"] = "u"
    case.scene["events"] = {"hit": {"joins": ["dart", "rod.at(s*L)"], "from": "before", "to": "after"}}
    arm = share.x * L.x
    spin = m.x * u.x * arm / (M.x * L.x**2 / 3 + m.x * arm**2)
    case.ask("w", "rod.angular_velocity at after", spin)
    rod = M.x * L.x**2 / 3
    case.ask("Q", "lost kinetic_energy during hit", m.x * u.x**2 / 2 * rod / (rod + m.x * arm**2))
    return case


def bounced(draw: Draw) -> Case:
    """A ball that bounces off the end of a hanging rod."""
    case, M, L = hanging(draw)
    m, u, e = draw.size("kg"), draw.size("m/s"), draw.share()
    case.scene["given"] |= {**letters(m=m, u=u), "e": e.text}
    case.scene["bodies"]["ball"] = {"mass": "m", "moves": "right"}
    case.scene["states"]["before"]["ball.velocity"] = "u"
    case.scene["events"] = {
        "hit": {"collides": ["ball", "rod.end"], "restitution": "e", "from": "before", "to": "after"}
    }
    spin = (1 + e.x) * m.x * u.x / (L.x * (M.x / 3 + m.x))
    case.ask("w", "rod.angular_velocity at after", spin)
    case.ask("v", "ball.velocity at after", (m.x - e.x * M.x / 3) * u.x / (m.x + M.x / 3))
    return case


def struck(draw: Draw) -> Case:
    """A blow on a hanging rod, and the impulse of its hinge."""
    case, M, L = hanging(draw)
    J, share = draw.size("N s"), draw.share()
    case.scene["given"] |= {"J": J.text, "s": share.text}
    case.scene["events"] = {
        "hit": {"impulse": "J", "on": "rod.at(s*L)", "direction": "right", "from": "before", "to": "after"}
    }
    spin = 3 * J.x * share.x / (M.x * L.x)
    case.ask("w", "rod.angular_velocity at after", spin)
    case.ask("P", "pin.impulse.x during hit", J.x * (3 * share.x / 2 - 1))
    case.ask("K", "kinetic_energy at after", mpf(3) / 2 * (J.x * share.x) ** 2 / M.x)
    return case
