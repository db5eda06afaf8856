"""What is refused by name: every row of the table in docs/finding.md is printed by a scene, and what it says to do instead leads on."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

PAGE = Path(__file__).parents[2] / "docs" / "finding.md"
GIVEN = "given: {M: 2 kg, m: 1 kg, R: 30 cm, L: 80 cm, w: 4 rad/s, c: 0.2 N m s, F: 6 N, t1: 0.2 s, tau: 1 N m}\n"
ROD = "bodies: {rod: {shape: rod, mass: M, length: L}}\nconnections: {pin: {hinge: rod.start}}\n"
FALL = "states: {high: {rod.angle: 20 deg, at rest: all}, low: {rod.angle: -30 deg}}\n"
OIL = "actions: {oil: {couple: -c*rod.angular_velocity, on: rod}}\n"
MAST = "mast: {shaft: rod.start, turning: w}"
TRUCK = (
    "surfaces: {floor: level}\n"
    "bodies: {truck: {mass: M, moves: right}, wheel: {shape: disc, mass: m, radius: R}, other: {shape: disc, mass: m, radius: R/2}}\n"
    "connections: {under: {contact: [truck, floor]}, mount: {axle: [truck, wheel]}"
)
ATWOOD = (
    "bodies: {one: {mass: m, moves: down}, pulley: {shape: disc, mass: M, radius: R}, two: {mass: M, moves: down}}\n"
    "connections: {stud: {axle: pulley}, cord: {string: [one, pulley, two]}}\nstates: {now: {at rest: all}}\n"
)
BELT = (
    "bodies: {wheel: {shape: disc, mass: m, radius: R}, other: {shape: disc, mass: m, radius: R/2}}\n"
    "connections: {mount: {axle: wheel}, stud: {axle: other}, strap: {belt: [wheel, other]}}\n"
    "actions: {drive: {couple: tau, on: wheel}}\nstates: {now: {at rest: all}}\n"
)
CLUTCHED = (
    "given: {s: unknown, r: 0.1 m, P: 100 N}\n"
    "bodies: {load: {mass: s, moves: down}, drum: {inertia: 1 kg m^2, radius: r}, disc: {inertia: 2 kg m^2, radius: 3*r}}\n"
    "connections:\n  pivot: {axle: [drum, disc]}\n  grip: {clutch: [drum, disc], friction_torque: 5 N m}\n  rope: {string: [load, drum]}\n"
    "actions: {shoe: {press: P, on: disc.rim, friction: 0.5}}\nstates: {rest: {balance: true}}\n"
)
LINKS = "bodies: {a: {shape: rod, mass: M, length: L}, b: {shape: rod, mass: m, length: L}}\n"
STEADY = "states: {now: {rod.angle: -60 deg, at rest: all}}\n"
REST = "states: {now: {at rest: all}}\n"
LOPSIDED = "wheel: {radius: R, %sparts: {hoop: {shape: disc, mass: M, radius: R}, lump: {mass: m, at: [R/2, 0]}}}"
SWING = "find: {x: period of small swings}\n"
TOP = (
    "given: {M: 0.2 kg, l: 5 cm, A: 6e-4 kg m^2, C: 8e-5 kg m^2, T: 2 s}\nup: z\n"
    "bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}}\n"
    "connections: {floor: {ball: top.tip}}\n"
)
NODS = (
    "states: {start: {top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: %s, top.nutation: 0 rad/s}, "
    "low: {top.tilt: largest}}\n"
)
ROLLERS = (
    "given: {M: 6 kg, m: 2 kg, R: 10 cm, r: 5 cm, F: 12 N}\nsurfaces: {floor: level}\n"
    "bodies: {plank: {mass: M, moves: right, shape: rectangle, sides: [1 m, r]}, one: {shape: disc, mass: m, radius: R, moves: right}, "
    "two: {shape: disc, mass: m, radius: R, moves: right}}\n"
    "connections: {a: {rolls: [one, floor]}, b: {rolls: [two, floor]}, c: {contact: [plank, one], friction: any}, d: {D, friction: any}}\n"
    "actions: {pull: {force: F, on: plank, direction: right}}\nstates: {now: {at rest: all}}\nfind: {x: plank.acceleration}\n"
).replace("{D, ", "{contact: [plank, two], ")
ALONE = ROLLERS.replace(", d: {contact: [plank, two], friction: any}", "")
EDGED = (
    "given: {M: 2 kg, L: 1 m, d: 20 cm, h: 80 cm, w: 2 rad/s}\nsurfaces: {edge: {corner: h, side: left}}\n"
    "bodies: {rod: {shape: rod, mass: M, length: L, turns: clockwise}}\n"
    "connections: {touch: {contact: [rod.at(L/2 - d), edge], friction: any}}\n"
    "states: {now: {rod.angle: 0, at rest: all}, later: {rod.angle: -40 deg}}\nfind: {x: rod.angular_velocity at later}\n"
)
IN_HOOP = (
    "given: {M: 2 kg, m: 1 kg, R: 30 cm}\nsurfaces: {floor: level}\n"
    "bodies: {hoop: {shape: ring, mass: M, radius: R, moves: right}, bead: {shape: particle, mass: m}}\n"
    "connections: {base: {rolls: [hoop, floor]}, touch: {contact: [bead, hoop], inside: true}}\n"
    "states: {now: {touch.angle: -60 deg, at rest: all}}\nfind: {x: hoop.acceleration}\n"
)
BLOW = "states: {before: {at rest: all}, after: {}}\n"
SPIN = "states: {now: {wheel.angular_velocity: 1 rad/s}}\nfind: {x: wheel.angular_acceleration at now}\n"

HUNG = (
    "bodies: {ring: {shape: ring, mass: M, radius: R, moves: down}, bob: {mass: m, moves: right}}\n"
    "connections: {cord: {string: [ceiling, ring]}}\nstates: {before: {at rest: [ring], bob.velocity: 2 m/s}, after: {}}\n"
    "events: {hit: {joins: [bob, ring.center], from: before, to: after}}\nfind: {x: bob.velocity.x at after}\n"
)

EGG = "surfaces: {floor: level}\nbodies: {egg: {mass: M, moves: right, shape: ellipsoid, sides: [R, R/2, R/2]}}\n"
ROCKS = (
    "surfaces: {floor: level}\nbodies: {half: {shape: hemisphere, mass: M, radius: R, moves: right, turns: clockwise}}\n"
    "connections: {base: {rolls: [half, floor]}}\n"
)
ALPHA = "find: {x: half.angular_acceleration at now}\n"
SLED = (
    "surfaces: {floor: level}\nbodies: {sled: {mass: M, moves: right}}\n"
    "connections: {base: {contact: [sled, floor], friction: 0.3}, coil: {spring: [ground, sled], stiffness: 400 N/m}}\n"
)
GOES_ON = "find: {x: sled.velocity at end}\n"
PULLED = (
    "given: {m: kg, F: N, T: s, mu: number}\nsurfaces: {floor: level}\nbodies: {box: {mass: m, moves: right}}\n"
    "connections: {base: {contact: [box, floor], friction: mu}}\n"
    "actions: {pull: {force: F*sin(pi*time/T), on: box, direction: right}}\n"
    "states: {start: at rest, end: {time: T}}\nfind: {x: box.velocity at end}\n"
)
CREEPS = (
    "given: {m: kg, u: m/s, F: N, f: N/m, b: m, d: m}\nsurfaces: {floor: level}\nbodies: {box: {mass: m, moves: right}}\n"
    "connections: {base: {contact: [box, floor]}}\n"
    "actions: {push: {force: f*box.displacement - F*exp(-box.displacement/b), on: box, direction: right}}\n"
    "states: {start: {box.velocity: u}, far: {box.displacement: d}}\nfind: {x: box.velocity at far}\n"
)
SPUN = (
    "bodies: {wheel: {shape: disc, mass: m, radius: R}}\nconnections: {mount: {axle: wheel, friction_torque: tau}}\n"
    "states: {start: {wheel.angular_velocity: w}, end: {time: 20 s}}\nfind: {x: wheel.angular_velocity at end}\n"
)
ROCKED = (
    LINKS
    + "connections: {nail: {hinge: a.start, angular_velocity: w}, foot: {hinge: b.start}, pin: {slot: [a.end, b.at(L/2)]}}\n"
    "states: {now: {a.angle: 80 deg, b.angle: 20 deg}%s}\n"
)
NO_ANSWER = re.compile("(?:there is no answer|no answer is found): ")

TWO_ANGLES = """given: {L: 1 m, b: 0.7 m, w: 2 rad/s, p: unknown, q: ANGLE}
bodies: {one: {shape: rod, mass: 1 kg, length: L}, two: {shape: rod, mass: 1 kg, length: b}}
connections: {j: {hinge: one.start}, k: {hinge: [one.end, two.start]}}
states:
  now: {one.angle: p, two.angle: q, one.angular_velocity: w, two.angular_velocity: w, two.end.velocity.x: -1 m/s TOLD}
find: {v: one.end.velocity.y}
"""
DOUBLE = LINKS + "connections: {nail: {hinge: a.start}, pin: {hinge: [a.end, b.start]}}\n"
MODE = "find: {x: period of mode 1}\n"
IN_A_ROW = (
    "surfaces: {floor: level}\nbodies: {one: {mass: M, moves: right}, two: {mass: m, moves: right}, three: {mass: M, moves: right}%s}\n"
    "connections: {base1: {contact: [one, floor]}, base2: {contact: [two, floor]}, base3: {contact: [three, floor]}, "
    "coil1: {spring: [ground, one], stiffness: 3 N/cm}, coil2: {spring: [one, two], stiffness: 2 N/cm}, "
    "coil3: {spring: [two, three], stiffness: 5 N/cm}%s}\n" + MODE
)
FOURTH = (
    ", four: {mass: m, moves: right}",
    ", base4: {contact: [four, floor]}, coil4: {spring: [three, four], stiffness: 7 N/cm}",
)
LIFT = (
    "bodies: {lift: {mass: 100 kg, acceleration: [0, RISE]}, rod: {shape: rod, mass: m, length: L}}\n"
    "connections: {hook: {hinge: [lift, rod.start]}}\n" + SWING
)
GOES_ROUND = (
    "states: {start: {top.tilt: 50 deg, top.axial_rate: 900 rad/s, top.precession: smallest, steady: true}, "
    "later: {top.precession_angle: 40 deg%s}}\n"
)
BAR = (
    "up: z\ngravity: none\nbodies: {bar: {shape: rod, mass: 0, length: sqrt(2*R^2 + L^2)}}\n"
    "connections: {one: {collar: [[0, R, L], bar.start], along: y}, two: {collar: [[R, 0, 0], bar.end], along: x}}\n"
    "states: {now: {bar.start.velocity: [0, 0.2 m/s, 0]}}\n"
)
CUBE = "up: z\nbodies: {cube: {shape: cuboid, mass: M, sides: [L, L, L], points: {P: [L/2, 0, 0]}}}\n"
STRUCK = (
    "events: {one: {impulse: 1 N s, on: cube.P, direction: z, from: before, to: %s}, "
    "two: {impulse: 2 N s, on: cube.P, direction: y, from: %s, to: after}}\nfind: {x: cube.angular_velocity at after}\n"
)
LIES = (
    "plane: horizontal\nsurfaces: {table: level}\nbodies: {disc: {shape: disc, mass: m, radius: R}}\n"
    "connections: {pin: {axle: disc}, face: {contact: [disc, table], friction: 0.3}}\n"
    "states: {now: {disc.angular_velocity: w}}\nfind: {x: face.torque at now}\n"
)
POST = (
    "surfaces: {beam: post}\nbodies: {one: {mass: m, moves: up}, two: {mass: M, moves: down}}\n"
    "connections: {rope: {string: [one, beam, two], friction: 0.1, wrap: 180 deg}}\n"
    "states: {now: {at rest: all}, after: {}}\nfind: {x: two.acceleration at now}\n"
)
BANDED = (
    "plane: horizontal\nbodies: {drum: {shape: disc, mass: m, radius: R}}\nconnections: {stud: {axle: drum}}\n"
    "actions: {brake: {band: F, on: drum.rim, friction: 0.25, wrap: 200 deg, direction: clockwise}}\n"
    "states: {now: {drum.angular_velocity: w}}\n"
)
DROPPED = (
    "surfaces: {floor: level, hill: {dome: R}}\nbodies: {rod: {shape: rod, mass: m, length: L}}\n"
    "states: {before: {rod.angle: 0 deg, rod.velocity: [0 m/s, -3 m/s], rod.angular_velocity: 0 rad/s}, after: {}}\n"
    "events: {hit: {collides: [rod.end, floor], restitution: 0.5, from: before, to: after}}\n"
    "find: {x: rod.angular_velocity at after}\n"
)
MET = (
    "bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: right}}\nconnections: {pin: {hinge: rod.start}}\n"
    "states: {before: {rod.angle: -90 deg, at rest: rod, ball.velocity: 3 m/s}, after: {}}\n"
    "events: {hit: {collides: [ball, rod.end], restitution: 0.5, from: before, to: after}}\n"
    "find: {x: rod.angular_velocity at after}\n"
)
CAUGHT = (
    "bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m}}\n"
    "states: {before: {rod.angle: 90 deg, at rest: rod, ball.velocity: [3 m/s, 0 m/s]}, after: {}, end: {time: 1 s}}\n"
    "events: {hit: {joins: [ball, rod.end], from: before, to: after}}\n"
)
HINGED = (
    "given: {mu: 0.2}\nsurfaces: {floor: level}\nbodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}\n"
    "connections: {pin: {hinge: rod.start}}\n"
    "states: {before: {rod.angle: -30 deg, rod.angular_velocity: -3 rad/s}, after: {}%s}\n"
    "events: {hit: {collides: [rod.end, floor], restitution: %s, friction: mu, from: before, to: after}%s}\n"
)
CRADLE = (
    "plane: horizontal\nbodies: {one: {mass: m, moves: right}, two: {mass: m, moves: right}, three: {mass: m, moves: right}}\n"
    "states: {before: {one.velocity: 3 m/s, at rest: [two, three]}, %safter: {}}\n"
    "events: {h1: {collides: [one, two], restitution: 0.9, from: before, to: %s}, "
    "h2: {collides: [two, three], restitution: 0.9, from: %s, to: after}}\nfind: {x: three.velocity at after}\n"
)
FLIES = "bodies: {ball: {mass: m}}\nstates: {start: {ball.velocity: [1 m/s, 2 m/s]}, end: {time: t1}}\n"
WIRE = (
    "gravity: none\nbodies: {wheel: {shape: disc, mass: m, radius: R}}\n"
    "connections: {stud: {axle: wheel}, wire: {torsion: wheel, stiffness: 0.5 N m/rad}}\n"
    "states: {start: {wheel.angle: 40 deg, at rest: all}, end: {LATER}}\nfind: {x: mean wheel.kinetic_energy from start to end}\n"
)
CRATE = (
    "surfaces: {ramp: {slope: 35 deg, down: left}}\nbodies: {crate: {mass: m, moves: up}}\n"
    "connections: {base: {contact: [crate, ramp], friction: 0.3}}\n"
    "states: {start: {crate.velocity: w*R}, end: {time: 2 s}}\nfind: {x: mean base.friction_force from start to end}\n"
)
BOTH_WHEELS = (
    "plane: horizontal\nbodies: {one: {shape: disc, mass: m, radius: R}, two: {shape: disc, mass: M, radius: R}}\n"
    "connections: {stud: {axle: %s, angular_momentum: tau*time}}\n"
    "states: {start: {}, end: {time: t1}}\nfind: {x: one.angular_velocity at end}\n"
)
BY_ENERGY = (
    "plane: horizontal\nbodies: {one: {shape: disc, mass: m, radius: R}}\n"
    "connections: {stud: {axle: one, LAW}}\nstates: {start: {}, end: {time: t1}}\nfind: {x: one.angular_velocity at end}\n"
)
BARS = (
    "given: {L: 50 cm, d: PLACE, w: 3 rad/s, M: 2 kg}\ngravity: none\n"
    "bodies: {a: {shape: rod, mass: M, length: L}, b: {shape: rod, mass: M, length: L}, c: {shape: rod, mass: M, length: L}}\n"
    "connections: {A: {hinge: a.start, at: [0, 0]}, D: {hinge: b.start, at: [d, 0]}, B: {hinge: [a.end, c.start]}, "
    "C: {hinge: [b.end, c.end]}}\nstates: {now: {a.angle: 90 deg, c.angle: 0, a.angular_velocity: w TOLD}}\n"
    "find: {x: b.angular_velocity}\n"
)
ALL_TOLD = BARS.replace(" TOLD", ", b.angle: 90 deg").replace("PLACE", "50 cm")
ON_A_WEDGE = (
    "surfaces: {floor: level, ramp: {slope: 30 deg, of: wedge}}\nbodies: {wedge: {mass: 2*m, moves: left}, bar: {mass: m}}\n"
    "connections: {base: {contact: [wedge, floor]}, slide: {contact: [bar, ramp]}TIED}\nACTING"
    "states: {start: {TOLDat rest: all}}\nfind: {x: wedge.acceleration}\n"
)
IN_A_BOWL = (
    "surfaces: {floor: level, bowl: {hollow: R, of: block}}\nbodies: {block: {mass: 2*m, moves: left}, bead: {mass: m}}\n"
    "connections: {base: {contact: [block, floor]}, slide: {contact: [bead, bowl]}}\nfind: {x: period of small swings}\n"
)
ON_AN_ARM = (
    "surfaces: {floor: level}\nbodies: {block: {mass: 2*m, moves: left}, arm: {shape: rod, mass: 0, length: R}, bob: {mass: m}}\n"
    "connections: {base: {contact: [block, floor]}, pin: {hinge: [block, arm.start]}, tied: {weld: [arm.end, bob]}}\n"
    "find: {x: period of small swings}\n"
)
ON_A_TURNING_PLATE = (
    "surfaces: {ramp: {slope: 30 deg, of: plate}}\nbodies: {plate: {shape: rectangle, mass: m, sides: [1 m, 10 cm]}, bar: {mass: m}}\n"
    "connections: {pin: {hinge: plate.corner1}, slide: {contact: [bar, ramp]}}\nstates: {start: at rest}\n"
    "find: {x: plate.angular_acceleration}\n"
)
CASES = {  # a scene that is refused, and the same said in another way that is answered, where there is one
    "a spring on a wedge": (
        ON_A_WEDGE.replace("TIED", ", coil: {spring: [ground, bar], stiffness: 100 N/m}")
        .replace("ACTING", "")
        .replace("TOLD", "coil.elongation: 1 cm, "),
        ON_A_WEDGE.replace("TIED", "")
        .replace("ACTING", "actions: {pull: {force: 1 N, on: bar, direction: left}}\n")
        .replace("TOLD", ""),
    ),
    "a side that turns": (ON_A_TURNING_PLATE, ""),
    "swings in a free bowl": (IN_A_BOWL, ON_AN_ARM),
    "damped fall": (
        ROD + OIL + FALL + "find: {x: rod.angular_velocity at low}\n",
        ROD + "actions: {oil: {couple: -tau, on: rod}}\n" + FALL + "find: {x: rod.angular_velocity at low}\n",
    ),
    "several letters at once": (
        TWO_ANGLES.replace("ANGLE", "unknown").replace(" TOLD", ", two.end.velocity.y: 2.4 m/s"),
        TWO_ANGLES.replace("ANGLE", "20 deg").replace(" TOLD", "").replace("v: one.end.velocity.y", "p: smallest p"),
    ),
    "many turns back": (
        SLED.replace("0.3", "0.01")
        + "states: {start: {coil.elongation: L, at rest: all}, end: {time: 5 s}}\n"
        + GOES_ON,
        SLED + "states: {start: {coil.elongation: L, at rest: all}, end: {time: 0.5 s}}\n" + GOES_ON,
    ),
    "turns back in letters": (
        (SLED + "states: {start: {coil.elongation: L, at rest: all}, end: {time: T}}\n" + GOES_ON).replace(
            "400 N/m", "k"
        ),
        "",
    ),
    "gives way in letters": (
        PULLED,
        PULLED.replace("kg", "2 kg").replace("T: s", "T: 2 s").replace(": N", ": 9 N").replace("number", "0.2"),
    ),
    "slowest in letters": (
        CREEPS,
        CREEPS.replace(
            "m: kg, u: m/s, F: N, f: N/m, b: m, d: m", "m: 1 kg, u: 9 m/s, F: 1 N, f: 2 N/m, b: 1 m, d: 1 m"
        ),
    ),
    "comes to rest": (
        SPUN + "actions: {drive: {couple: tau/2*exp(-time/t1), on: wheel}}\n",
        SPUN + "actions: {drive: {couple: tau/2, on: wheel}}\n",
    ),
    "time of a fall": (
        ROD + FALL + "find: {x: time from high to low}\n",
        ROD + FALL + "find: {x: rod.angular_velocity at low}\n",
    ),
    "place at a time": (
        ROD
        + "states: {high: {rod.angle: 20 deg, at rest: all}, low: {time: t1}}\nfind: {x: rod.angular_velocity at low}\n",
        ROD + FALL + "find: {x: rod.angular_velocity at low}\n",
    ),
    "lopsided on a line": (
        f"bodies: {{{LOPSIDED % 'moves: down, '}}}\nactions: {{pull: {{force: F, on: wheel.center, direction: up}}}}\n"
        + REST
        + "find: {x: wheel.angular_acceleration at now}\n",
        f"bodies: {{{LOPSIDED % ''}}}\nactions: {{pull: {{force: F, on: wheel.center, direction: up}}}}\n"
        + REST
        + "find: {x: wheel.angular_acceleration at now}\n",
    ),
    "tied on a shaft": (
        "bodies: {rod: {shape: rod, mass: M, length: L}, wheel: {shape: disc, mass: m, radius: R}}\n"
        f"connections: {{{MAST}, stud: {{axle: [rod, wheel]}}}}\n"
        + STEADY
        + "find: {x: rod.angular_acceleration at now}\n",
        "bodies: {rod: {shape: rod, mass: M, length: L}, bob: {mass: m}}\n"
        f"connections: {{{MAST}, bolt: {{weld: [rod.end, bob]}}}}\n"
        + STEADY
        + "find: {x: rod.angular_acceleration at now}\n",
    ),
    "momentum on a shaft": (
        f"bodies: {{rod: {{shape: rod, mass: M, length: L}}}}\nconnections: {{{MAST}}}\n{STEADY}find: {{x: rod.angular_momentum at now}}\n",
        f"bodies: {{rod: {{shape: rod, mass: M, length: L}}}}\nconnections: {{{MAST}}}\n{STEADY}find: {{x: rod.kinetic_energy at now}}\n",
    ),
    "balance on a shaft": (
        f"bodies: {{rod: {{shape: rod, mass: M, length: L}}}}\nconnections: {{{MAST}}}\n"
        "states: {now: {balance: true}}\nfind: {x: rod.angle at now}\n",
        f"bodies: {{rod: {{shape: rod, mass: M, length: L}}}}\nconnections: {{{MAST.replace('w}', '6 rad/s}')}}}\n"
        "states: {now: {steady: true}}\nfind: {x: rod.angle at now}\n",
    ),
    "mass told by its moment on a shaft": (
        "bodies: {wheel: {mass: M, inertia: M*R^2, radius: R}}\nconnections: {mast: {shaft: wheel.center, turning: w}}\n"
        + SPIN,
        "bodies: {wheel: {shape: ring, mass: M, radius: R}}\nconnections: {mast: {shaft: wheel.center, turning: w}}\n"
        + SPIN,
    ),
    "brake on what travels": (
        TRUCK + "}\nactions: {block: {press: F, on: wheel.rim, friction: 0.5}}\n"
        "states: {now: {wheel.angular_velocity: w, truck.velocity: 1 m/s}}\nfind: {x: wheel.angular_acceleration at now}\n",
        TRUCK + "}\nactions: {block: {couple: 0.5*F*R, on: wheel, direction: clockwise}}\n"
        "states: {now: {wheel.angular_velocity: w, truck.velocity: 1 m/s}}\nfind: {x: wheel.angular_acceleration at now}\n",
    ),
    "rubbing axle on what travels": (
        TRUCK.replace("[truck, wheel]", "[truck, wheel], friction_torque: tau") + "}\n"
        "states: {now: {wheel.angular_velocity: w, truck.velocity: 1 m/s}}\nfind: {x: wheel.angular_acceleration at now}\n",
        TRUCK + "}\nactions: {rub: {couple: tau, on: wheel, direction: clockwise}}\n"
        "states: {now: {wheel.angular_velocity: w, truck.velocity: 1 m/s}}\nfind: {x: wheel.angular_acceleration at now}\n",
    ),
    "belt to what travels": (
        TRUCK
        + ", stud: {axle: other}, strap: {belt: [wheel, other]}}\nactions: {drive: {couple: tau, on: wheel}}\n"
        + REST
        + "find: {x: wheel.angular_acceleration at now}\n",
        TRUCK
        + ", stud: {axle: [truck, other]}, strap: {belt: [wheel, other]}}\nactions: {drive: {couple: tau, on: wheel}}\n"
        + REST
        + "find: {x: wheel.angular_acceleration at now}\n",
    ),
    "support of a belt": (BELT + "find: {x: stud.force.y at now}\n", BELT + "find: {x: strap.force at now}\n"),
    "tension of a string over a heavy pulley": (
        ATWOOD + "find: {x: cord.tension at now}\n",
        ATWOOD + "find: {x: cord.two.tension at now}\n",
    ),
    "blow that lifts": (
        "surfaces: {floor: level}\nbodies: {block: {mass: m, moves: right}}\nconnections: {base: {contact: [block, floor]}}\n"
        + BLOW
        + "events: {hit: {impulse: 1 N s, on: block, direction: 60 deg, from: before, to: after}}\nfind: {x: block.velocity at after}\n",
        "bodies: {block: {mass: m}}\n"
        + BLOW
        + "events: {hit: {impulse: 1 N s, on: block, direction: 60 deg, from: before, to: after}}\nfind: {x: block.velocity.x at after}\n",
    ),
    "blow to the side of a line": (HUNG, ""),
    "top that nods after a time": (
        TOP
        + "states: {start: {top.tilt: 20 deg, top.axial_rate: 400 rad/s, top.precession: 0 rad/s, top.nutation: 0 rad/s}, "
        "later: {time: T}}\nfind: {th: top.tilt at later}\n",
        "",
    ),
    "swings of what is not symmetric": (
        TOP.replace("[A, A, C]", "[A, 1.05*A, C]") + "states: {now: {top.tilt: 180 deg, at rest: all}}\n" + SWING,
        TOP + "states: {now: {top.tilt: 180 deg, at rest: all}}\n" + SWING,
    ),
    "swings of any size in space": (
        TOP + "states: {now: {top.tilt: 170 deg, at rest: all}}\nfind: {x: period of swings from now}\n",
        "",
    ),
    "time of what is not symmetric": (
        TOP.replace("[A, A, C]", "[A, 1.05*A, C]") + NODS % "0 rad/s" + "find: {x: time from start to low}\n",
        TOP + NODS % "0 rad/s" + "find: {x: time from start to low}\n",
    ),
    "time from a state that nods": (
        TOP + (NODS % "0 rad/s").replace("nutation: 0", "nutation: 1") + "find: {x: time from start to low}\n",
        TOP + NODS % "0 rad/s" + "find: {x: time from start to low}\n",
    ),
    "period of what passes through the vertical": (
        TOP + NODS % "C*300 rad/s/(A*(1 + cos(25 deg)))" + "find: {x: top.period at start}\n",
        "",
    ),
    "period of what never comes back": (
        TOP.replace("T: 2 s", "T: 2 s, w: 2*sqrt(M*g*l*A*3/4)/C, th: 60 deg, g: 9.8 m/s^2")
        + (NODS % "C*w/(A*(1 + cos(th)))").replace("300 rad/s", "w").replace("25 deg", "th")
        + "find: {x: top.period at start}\n",
        "",
    ),
    "angle to a tilt between": (
        TOP
        + (NODS % "0 rad/s").replace("largest", "26 deg")
        + "find: {x: change of top.precession_angle from start to low}\n",
        TOP + NODS % "0 rad/s" + "find: {x: change of top.precession_angle from start to low}\n",
    ),
    "verge of a clutch": (
        CLUTCHED + "find: {x: largest s where grip sticks}\n",
        CLUTCHED.replace("s: unknown", "s: 4 kg") + "find: {x: grip.torque at rest}\n",
    ),
    "pendulum after a time": (
        "given: {m: 2 kg, T: 1 s, l: 1 m}\nup: z\n"
        "bodies: {rod: {shape: rod, mass: m, length: l, points: {P: [l/4, 0, 0]}}}\n"
        "connections: {pin: {hinge: rod.start, along: y}}\n"
        "states: {start: {rod.angle: 0 deg, rod.angular_velocity: 0 rad/s}, later: {time: T}}\n"
        "find: {v: rod.P.velocity at later}\n",
        "",
    ),
    "modes in oil": (DOUBLE + OIL.replace("rod", "a") + MODE, DOUBLE + MODE),
    "swings by the way gone": (
        SLED.replace(", friction: 0.3", "")
        + "actions: {push: {force: -F*sled.displacement/L, on: sled, direction: right}}\n"
        + SWING,
        SLED.replace(", friction: 0.3", "") + SWING,
    ),
    "swings in several ways": (
        DOUBLE
        + "states: {now: {a.angle: -60 deg, b.angle: -80 deg, at rest: all}}\nfind: {x: period of swings from now}\n",
        DOUBLE + MODE,
    ),
    "four ways to swing": (IN_A_ROW % FOURTH, IN_A_ROW % ("", "")),
    "swings on what is led in time": (LIFT.replace("RISE", "time*(2 m/s^3)"), LIFT.replace("RISE", "2 m/s^2")),
    "angle of precession without a time": (
        TOP + GOES_ROUND % "" + "find: {x: top.precession at later}\n",
        TOP.replace("2 s", "unknown") + GOES_ROUND % ", time: T" + "find: {x: T}\n",
    ),
    "linkage in time": (BAR + "find: {x: bar.end.velocity at any time}\n", BAR + "find: {x: bar.end.velocity}\n"),
    "two joints": (
        CUBE + "connections: {one: {ball: cube}, two: {clamp: cube.P}}\nfind: {x: cube.kinetic_energy}\n",
        CUBE
        + "connections: {one: {hinge: cube, along: z, bearings: [-L, L]}}\nstates: {now: {cube.angular_velocity: w}}\n"
        + "find: {x: cube.kinetic_energy}\n",
    ),
    "bar about its line": (
        BAR + "find: {x: bar.angular_velocity in bar axes}\n",
        BAR + "find: {x: bar.angular_velocity in space axes}\n",
    ),
    "length of a bar": (
        BAR.replace(", length: sqrt(2*R^2 + L^2)", "") + "find: {x: bar.end.velocity}\n",
        BAR + "find: {x: bar.end.velocity}\n",
    ),
    "two blows at once": (
        CUBE + "states: {before: {at rest: all}, after: {}}\n" + STRUCK % ("after", "before"),
        CUBE + "states: {before: {at rest: all}, between: {}, after: {}}\n" + STRUCK % ("between", "between"),
    ),
    "travels over a table": (
        LIES.replace("radius: R", "radius: R, moves: right").replace("pin: {axle: disc}, ", ""),
        LIES,
    ),
    "disc about its rim": (
        LIES.replace("axle: disc", "hinge: disc.rim"),
        LIES.replace("axle: disc", "hinge: disc.end")
        .replace("shape: disc", "shape: rod")
        .replace("radius: R", "length: L"),
    ),
    "face of what has no shape": (LIES.replace("shape: disc", "inertia: m*R^2"), LIES),
    "static friction over a face": (LIES.replace("0.3", "{static: 0.4, kinetic: 0.3}"), LIES),
    "two ends without a post": (POST.replace("one, beam, two", "one, two"), POST.replace(", after: {}", "")),
    "blow with a post": (
        POST + "events: {hit: {impulse: 1 N s, on: two, direction: down, from: now, to: after}}\n",
        POST.replace(", after: {}", ""),
    ),
    "axle under a band": (BANDED + "find: {x: stud.force at now}\n", BANDED + "find: {x: brake.torque at now}\n"),
    "axle over a face": (
        LIES.replace("disc.angular_velocity: w", "at rest: all").replace("face.torque", "pin.force"),
        LIES.replace("disc.angular_velocity: w", "at rest: all"),
    ),
    "rough blow beside a contact": (
        DROPPED.replace("rod: {shape: rod, mass: m, length: L}", "rod: {shape: disc, mass: m, radius: R}")
        .replace("rod.angle: 0 deg, rod.velocity: [0 m/s, -3 m/s]", "rod.velocity: [2 m/s, 0 m/s]")
        .replace("hill: {dome: R}", "side: {wall: right}")
        .replace("states:", "connections: {lies: {contact: [rod, floor]}}\nstates:")
        .replace("rod.end, floor", "rod, side")
        .replace("restitution: 0.5", "restitution: 0.5, friction: 0.2"),
        DROPPED.replace("restitution: 0.5", "restitution: 0.5, friction: 0.2").replace("0 deg", "-60 deg"),
    ),
    "two coefficients in a blow": (
        (HINGED % ("", "0", "") + "find: {x: rod.angular_velocity at after}\n").replace(
            "friction: mu", "friction: {static: mu, kinetic: 0.1}"
        ),
        (HINGED % ("", "0", "") + "find: {x: rod.angular_velocity at after}\n").replace("mu: 0.2", "mu: 2"),
    ),
    "slip that turns back": (
        HINGED % ("", "0.5", "") + "find: {x: rod.angular_velocity at after}\n",
        HINGED.replace("mu: 0.2", "mu: 0.2, J: unknown")
        % (
            ", end: {rod.angular_velocity: 1.5 rad/s}",
            "0",
            ", back: {impulse: J, on: rod.end, direction: [-mu, 1], from: after, to: end}",
        )
        + "find: {x: J}\n",
    ),
    "cradle": (CRADLE % ("", "after", "before"), CRADLE % ("mid: {}, ", "mid", "mid")),
    "one of two blows would pull": (
        DROPPED.replace(
            "events: {",
            "events: {other: {collides: [rod.at(3*L/4), floor], restitution: 0.5, from: before, to: after}, ",
        ),
        DROPPED,
    ),
    "blow off a dome": (DROPPED.replace("rod.end, floor", "rod.end, hill"), DROPPED),
    "rough blow of two bodies": (MET.replace("restitution: 0.5", "restitution: 0.5, friction: 0.2"), MET),
    "mean of a vector": (
        FLIES + "find: {x: mean ball.momentum from start to end}\n",
        FLIES + "find: {x: mean ball.momentum.y from start to end}\n",
    ),
    "mean of a size": (
        BELT.replace("now: {at rest: all}", "now: {at rest: all}, end: {time: t1}")
        + "find: {x: mean strap.force by wheel.rotation from now to end}\n",
        BELT.replace("now: {at rest: all}", "now: {at rest: all}, end: {time: t1}")
        + "find: {x: mean drive.torque by wheel.rotation from now to end}\n",
    ),
    "mean of friction up and back": (CRATE, CRATE.replace("time: 2 s", "crate.velocity: 0")),
    "mean of what swings for a time": (
        WIRE.replace("LATER", "time: 20 s"),
        WIRE.replace("LATER", "wheel.angle: 0"),
    ),
    "mean energy of a fall": (
        ROD + FALL + "find: {x: mean rod.kinetic_energy by rod.rotation from high to low}\n",
        ROD + FALL + "find: {x: mean rod.torque.gravity by rod.rotation from high to low}\n",
    ),
    "mean of a damped fall": (
        ROD + OIL + FALL + "find: {x: mean rod.kinetic_energy from high to low}\n",
        "",
    ),
    "settling by the place": (
        ROD
        + FALL.replace("rod.angle: -30 deg", "rod.angular_velocity: settles")
        + "find: {x: rod.angular_velocity at low}\n",
        ROD
        + FALL.replace("rod.angle: -30 deg", "rod.angular_velocity: smallest")
        + "find: {x: rod.angular_velocity at low}\n",
    ),
    "linkage that does not close": (ALL_TOLD.replace("d: 50 cm", "d: 60 cm"), ALL_TOLD),
    "linkage of which an angle is missing": (
        BARS.replace(" TOLD", "").replace("PLACE", "50 cm").replace("gravity: none\n", ""),
        ALL_TOLD.replace("gravity: none\n", ""),
    ),
    "linkage between letters": (ALL_TOLD.replace("d: 50 cm", "d: m"), ALL_TOLD),
    "momentum of several wheels": (BOTH_WHEELS % "[one, two]", BOTH_WHEELS % "one"),
    "energy that comes to nothing": (
        BY_ENERGY.replace("LAW", "kinetic_energy: tau*cos(time/t1)^2"),
        BY_ENERGY.replace("LAW", "angular_velocity: w*cos(time/t1)"),
    ),
    "pin along an arm": (
        ROCKED % ", later: {a.angle: 1 rad}" + "find: {x: b.angular_velocity at later}\n",
        ROCKED % "" + "find: {x: b.angular_velocity at now}\n",
    ),
    "way of what is caught": (
        CAUGHT + "find: {x: ball.cm.displacement.x from before to end}\n",
        CAUGHT + "find: {x: rod.end.displacement.x from after to end}\n",
    ),
    "an ellipse that rolls": (
        f"{EGG}connections: {{base: {{rolls: [egg, floor]}}}}\n{SWING}",
        f"{EGG.replace('shape: ellipsoid, sides: [R, R/2, R/2]', 'shape: hemisphere, radius: R')}"
        f"connections: {{base: {{rolls: [egg, floor]}}}}\n{SWING}",
    ),
    "an ellipse that lies": (f"{EGG}connections: {{base: {{contact: [egg, floor]}}}}\n{SWING}", ""),
    "a half ball in a bowl": (
        "surfaces: {bowl: {hollow: L}}\nbodies: {half: {shape: hemisphere, mass: M, radius: R}}\n"
        f"connections: {{base: {{rolls: [half, bowl]}}}}\n{SWING}",
        "surfaces: {bowl: {hollow: L}}\nbodies: {half: {shape: sphere, mass: M, radius: R}}\n"
        f"connections: {{base: {{rolls: [half, bowl]}}}}\n{SWING}",
    ),
    "which is on top": (ALONE.replace("[plank, one]", "[one, plank]"), ALONE),
    "rollers of two sizes": (
        ROLLERS.replace("two: {shape: disc, mass: m, radius: R", "two: {shape: disc, mass: m, radius: r"),
        ROLLERS,
    ),
    "a plank on a roller and on the floor": (ROLLERS.replace("[plank, two], friction: any", "[plank, floor]"), ROLLERS),
    "a mass on a roller": (ALONE.replace(", shape: rectangle, sides: [1 m, r]", ""), ALONE),
    "in a hoop or on it": (IN_HOOP.replace(", inside: true", ""), IN_HOOP),
    "a rod slips on over an edge": (
        EDGED.replace("any", "0.1").replace("angle: 0", "angle: -30 deg"),
        EDGED.replace("-40 deg", "-10 deg").replace("any", "0.9"),
    ),
    "a rod slides over an edge": (EDGED.replace(", friction: any", ""), EDGED),
    "swings in a hoop that rolls": (IN_HOOP.replace("x: hoop.acceleration", "x: period of small swings"), IN_HOOP),
    "beyond the round side": (f"{ROCKS}{REST.replace('at rest: all', 'half.angle: 20 deg, at rest: all')}{ALPHA}", ""),
    "a round side that ends on the way": (
        f"{ROCKS}states: {{now: {{half.angle: -30 deg, half.angular_velocity: 3*w}}, end: {{half.rotation: 170 deg}}}}\n"
        "find: {x: half.angular_velocity at end}\n",
        f"{ROCKS}states: {{now: {{half.angle: -30 deg, half.angular_velocity: 3*w}}, end: {{half.rotation: 90 deg}}}}\n"
        "find: {x: half.angular_velocity at end}\n",
    ),
}


def rows() -> list[str]:
    """The messages of the table, with … for the names of a scene."""
    text = PAGE.read_text(encoding="utf-8")
    lines = text[text.index("| what is printed |") :].split("\n\n")[0].splitlines()[2:]
    return [line.split("|")[1].strip() for line in lines]


def given_with(text: str) -> str:
    """A scene with the usual letters, if it has none of its own; k and T have no numbers."""
    if text.startswith("given:"):
        return text
    return (GIVEN.replace("}", ", k: N/m, T: s}") if ": k" in text else GIVEN) + text


@cache
def refused(text: str) -> str:
    """Why a scene has no answer, or in letters why one of its cases has none."""
    try:
        found = solve(text)
    except (Unsolvable, SceneError) as error:
        return (error.fault if isinstance(error, Unsolvable) else error.faults[0]).message
    said = ["".join(word for word in check.words if isinstance(word, str)) for check in found.checks]
    return next(words[found.end() :] for words in said if (found := NO_ANSWER.search(words)))


def fits(row: str, message: str) -> bool:
    pattern = re.escape(row.replace("`", "")).replace("…", ".+")
    return re.fullmatch(pattern, message.replace("`", "")) is not None


@pytest.mark.parametrize("case", CASES)
def test_what_is_refused_by_name_stands_in_the_table(case: str) -> None:
    message = refused(given_with(CASES[case][0]))
    assert [row for row in rows() if fits(row, message)], message


def test_every_row_of_the_table_is_printed() -> None:
    messages = [refused(given_with(text)) for text, _ in CASES.values()]
    assert not [row for row in rows() if not any(fits(row, message) for message in messages)]


@pytest.mark.parametrize("case", [name for name, (_, other) in CASES.items() if other])
def test_what_is_to_be_said_instead_is_answered(case: str) -> None:
    assert not solve(given_with(CASES[case][1])).refused
