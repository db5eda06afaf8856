"""Every word of a scene in space takes part, or is refused by name: words that contradict each other, that mean nothing where they
stand, or that tell once more what is told already.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import SceneError, Unsolvable, solve

HEAD = "title: t\nup: z\n"
TOP = "top: {mass: 0.2 kg, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}"
GIVEN = "given: {l: 5 cm, A: 6e-4 kg m^2, C: 8e-5 kg m^2, w: 400 rad/s, th: 20 deg}\n"
ROD = "bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m, points: {P: [0.3 m, 0, 0]}}}\n"
HINGE = "connections: {pin: {hinge: rod.start, along: y}}\n"
BOX = "bodies: {box: {shape: cuboid, mass: 2 kg, sides: [0.6 m, 0.4 m, 0.2 m], points: {P: [0.3 m, 0.2 m, 0.1 m]}}}\n"
RATE = "box.angular_velocity: [1 rad/s, 2 rad/s, 3 rad/s]"


def top(state: str, find: str, *, body: str = TOP, more: str = "", given: str = GIVEN) -> str:
    held = "connections: {floor: {ball: top.tip}}\n"
    return f"{HEAD}{more}{given}bodies: {{{body}}}\n{held}states: {{now: {{{state}}}}}\nfind: {find}\n"


def rod(state: str, find: str = "{al: rod.angular_acceleration}", more: str = "") -> str:
    return f"{HEAD}{ROD}{HINGE}{more}states: {{now: {{{state}}}}}\nfind: {find}\n"


def box(state: str, find: str = "{L: box.angular_momentum}", more: str = "", body: str = BOX) -> str:
    return f"{HEAD}gravity: none\n{body}{more}states: {{now: {{{state}}}}}\nfind: {find}\n"


STOOD = "rod.angle: 20 deg, rod.angular_velocity: 3 rad/s"
FAST = "assume: [fast spin]\n"
WHEEL = (
    "bodies: {wheel: {shape: disc, mass: 2 kg, radius: 0.2 m}, fork: {mass: 0, angular_velocity: [0, 0, 2 rad/s]}}\n"
)
AXLE = "connections: {ax: {axle: [fork, wheel], along: x, angular_velocity: 5 rad/s}}\n"
HOLE = "bodies: {b: {shape: sphere, mass: 2 kg, radius: 0.3 m, holes: {a: {HOLE}}}}\nfind: {I: b.inertia_tensor}\n"
SHAPE = "bodies: {b: {SHAPE}}\nfind: {I: b.inertia_tensor}\n"
DRIVEN = "connections: {pin: {hinge: rod.start, along: y, angle: 2 rad/s*time, angular_velocity: 3 rad/s}}\n"

CARRIED = f"""{HEAD}{GIVEN.replace("th: 20 deg", "s: unknown")}
bodies: {{table: {{mass: 0, points: {{P: [2*l, 0, 0]}}}}, {TOP}}}
connections: {{axis: {{hinge: table, along: z, angular_velocity: 3 rad/s}}, floor: {{ball: [table.P, top.tip]}}}}
states: {{now: {{top.tilt: 30 deg, top.precession_angle: 90 deg, top.precession: RATE, top.spin: s, steady: true}}}}
find: {{s: s}}
"""
COLLAR = f"""{HEAD}
bodies: {{col: {{mass: 2 kg, inertia: {{principal: [1 kg m^2, 2 kg m^2, 2.5 kg m^2]}}, points: {{J: [-0.05 m, -0.02 m, -0.1 m]}}}}}}
connections: {{s: {{JOINT, along: z}}}}
states: {{now: {{col.angular_velocity: 5 rad/s, TOLD}}}}
find: {{v: col.velocity, w_J: col.J.velocity, K: col.kinetic_energy, a: col.acceleration}}
"""

DISC = "pl: {shape: disc, mass: 0.5 kg, radius: 8 cm, points: {A: [0, 0, 8 cm]}}"
LUMP = "rd: {shape: sphere, mass: 0.05 kg, radius: 1 cm}"
TURNS = '"pl.angular_velocity in body axes": [2 rad/s, 0, 9 rad/s], pl.velocity: [0, 1 m/s, 0]'
CLAMPED = f"bodies: {{{DISC}, {LUMP}}}\nconnections: {{c: {{clamp: [pl.A, rd.center]}}}}\n"
PUSHED = f"bodies: {{{DISC}}}\nactions: {{c: {{PUSH, direction: x}}}}\n"


def disc(find: str, bodies: str) -> str:
    return f"{HEAD}gravity: none\n{bodies}states: {{now: {{{TURNS}}}}}\nfind: {find}\n"


ROLLING = """{HEAD}given: {{W: 3 rad/s}}
bodies: {{table: {{shape: disc, mass: 0, LEANS}}, ball: {{shape: sphere, mass: 0.4 kg, radius: 10 cm}}}}
connections: {{axis: {{hinge: table.center, along: z, angular_velocity: W}}, grip: {{rolls: [ball, table]}}}}
ACTS
states: {{now: {{"ball.position relative to table": [30 cm, 0, 10 cm], ball.angular_velocity.z: 0 rad/s, steady: true}}}}
find: {{v: ball.velocity}}
"""
OBLIQUE = HINGE.replace("along: y", "along: [0, 3/5, 4/5]")
LOADED = f"{TOP.replace('points: {', 'points: {H: [0, 0, l], ')}, lp: {{shape: particle, mass: LOAD}}"


def rolling(leans: str = "points: {P: [0, 0, 0]}", acts: str = "") -> str:
    return ROLLING.format(HEAD=HEAD).replace("LEANS", leans).replace("ACTS", acts)


def swinging(hinge: str, state: str, more: str = "") -> str:
    return (
        f"{HEAD}{ROD}{hinge}{more}states: {{now: {{{state}, steady: true}}}}\nfind: {{al: rod.angular_acceleration}}\n"
    )


def loaded(load: str) -> str:
    scene = top(
        "top.tilt: th, top.axial_rate: w, top.precession: smallest, steady: true", "{O: top.precession}", more=FAST
    )
    return scene.replace(TOP, LOADED.replace("LOAD", load)).replace("top.tip}}", "top.tip}, c: {clamp: [top.H, lp]}}")


BALLS = "what stays of `ball`, which rolls on `table`, `steady: true` does not say"
REFUSED = {
    "a steady ball on a turntable": (rolling(), BALLS),
    "a steady ball on a leaning turntable": (rolling("turned: {about: y, by: 10 deg}"), BALLS),
    "a steady ball that is pushed on a turntable": (
        rolling(acts="actions: {f: {force: [1 N, 0, 0], on: ball.center}}"),
        BALLS,
    ),
    "a rod that swings through its lowest place, steady": (
        swinging(HINGE, "rod.angle: 90 deg, rod.angular_velocity: 3 rad/s"),
        "the weight of `rod` keeps its direction while that goes round",
    ),
    "a rod that swings on an oblique hinge, steady": (
        swinging(OBLIQUE, "rod.angle: 90 deg, rod.angular_velocity: 3 rad/s"),
        "the weight of `rod` keeps its direction while that goes round",
    ),
    "a force of one direction on what turns steadily": (
        swinging(
            HINGE,
            "rod.angle: 0 deg, rod.angular_velocity: 3 rad/s",
            "gravity: none\nactions: {f: {force: [1 N, 0, 0], on: rod.P}}\n",
        ),
        "`f` keeps its direction while `rod` goes round",
    ),
    "a fast spin of a top that carries a lump": (
        loaded("200 g"),
        "`top` carries `lp`, and the spin is taken to be fast",
    ),
    "a first rate of either sense": (
        f"{HEAD}given: {{w0: unknown}}\n{ROD}{HINGE}states: {{s: {{rod.angle: 20 deg, rod.angular_velocity: w0}}, "
        "now: {rod.angle: -50 deg, rod.angular_velocity: 0 rad/s}}\nfind: {w0: w0}\n",
        "in which sense `rod` turns at `s` nothing tells",
    ),
    "the precession of a part of what moves as one": (
        disc("{O: pl.precession}", CLAMPED),
        "told of a free body alone, and `pl` carries `rd`",
    ),
    "the spin of a part of what moves as one": (
        disc("{s: pl.spin}", CLAMPED),
        "told of a free body alone",
    ),
    "the tilt about an angular momentum that changes": (
        disc("{t: pl.tilt}", PUSHED.replace("PUSH", "couple: 2 N m, on: pl")),
        "an angular momentum that stays, and what acts on `pl` may turn it",
    ),
    "the precession under a force off the centre": (
        disc("{O: pl.precession}", PUSHED.replace("PUSH", "force: 2 N, on: pl.A")),
        "an angular momentum that stays, and what acts on `pl` may turn it",
    ),
    "a tilt on a hinge": (rod(f"{STOOD}, rod.tilt: 30 deg"), "on a `hinge`: .* not its `tilt`"),
    "a spin on a hinge of the ground": (rod(f"{STOOD}, rod.spin: 2 rad/s"), "not its `spin`"),
    "a vertical on a hinge": (rod(f"{STOOD}, rod.vertical: [0, 0, 1]"), "not its `vertical`"),
    "a tilt on a carried axle": (
        f"{HEAD}{WHEEL}{AXLE}states: {{now: {{wheel.angle: 0 deg, wheel.tilt: 20 deg}}}}\nfind: {{F: ax.force}}\n",
        "on an? `axle`: .* not its `tilt`",
    ),
    "three components on a hinge": (rod("rod.angle: 0 deg, rod.angular_velocity: [0, 1 rad/s, 0]"), "one number"),
    "an angle of a free body": (box(f"{RATE}, box.angle: 20 deg"), "on no `hinge` and no `axle`"),
    "a stand told twice": (
        top("top.tilt: th, top.vertical: [0, 0, 1], top.axial_rate: w, steady: true", "{W: smallest top.precession}"),
        "by its Euler angles and by its `vertical`",
    ),
    "a rate of what is at rest": (
        top("top.tilt: th, top.axial_rate: w, at rest: top", "{al: top.angular_acceleration}"),
        "is at rest at `now`, and its `axial_rate` is told",
    ),
    "drawn turned, and Euler angles": (
        top("top.tilt: th, top.axial_rate: w", "{K: top.energy}", body=TOP[:-1] + ", turned: {about: x, by: 40 deg}}"),
        "is drawn `turned`, and a state tells how it stands by its Euler angles",
    ),
    "drawn turned, and another vertical": (
        box(
            '"box.angular_velocity in body axes": [1 rad/s, 2 rad/s, 3 rad/s], box.vertical: [0.36, 0.48, 0.8]',
            more="connections: {k: {ball: box.P}}\n",
            body=BOX.replace("sides", "turned: {about: x, by: 30 deg}, sides"),
        ),
        "is drawn `turned`, and its `vertical` at `now` is another one",
    ),
    "fast spin without a top": (
        box(RATE).replace("up: z\n", f"up: z\n{FAST}"),
        "`assume: fast spin` says nothing here",
    ),
    "fast spin where nothing precesses steadily": (
        f"{HEAD}{FAST}{GIVEN}bodies: {{{TOP}}}\nconnections: {{floor: {{ball: top.tip}}}}\nstates:\n"
        "  start: {top.tilt: th, top.axial_rate: w, top.precession: 0 rad/s, top.nutation: 0 rad/s}\n"
        "  low: {top.tilt: largest}\nfind: {th1: top.tilt at low}\n",
        "`assume: fast spin` says nothing here",
    ),
    "a phase without a joint": (
        f"{HEAD}{ROD}{HINGE}states: {{a: {{{STOOD}}}, e: {{rod.angle: 60 deg}}}}\n"
        "phases: {fall: {from: a, to: e, without: pin}}\nfind: {w: rod.angular_velocity at e}\n",
        "a phase without `pin` is not solved in space",
    ),
    "a direction beside any": (
        box("at rest: box", more="actions: {f: {force: any, on: box.P, direction: y}}\n", find="{F: f.force}"),
        "has a `direction`, and `force: any`",
    ),
    "a direction beside components": (
        box("at rest: box", more="actions: {f: {couple: [1 N m, 0, 0], on: box, direction: y}}\n"),
        "has a `direction`, and its components",
    ),
    "a place and another velocity": (
        box(
            "",
            "{v: box.velocity}",
            body=BOX.replace("sides", "position: [time*1 m/s, 0, 0], velocity: [0, 2 m/s, 0], sides"),
        ).replace("states: {now: {}}\n", ""),
        "the `position` and the `velocity` of `box` contradict",
    ),
    "a drive told twice": (
        f"{HEAD}{ROD}{DRIVEN}find: {{w: rod.angular_velocity}}\n",
        "the `angle` and the `angular_velocity`",
    ),
    "a hole without a shape": (
        HEAD + HOLE.replace("HOLE", "mass: 0.5 kg, at: [0.1 m, 0, 0]"),
        "has no `shape` that has a size",
    ),
    "a hole with an inertia": (
        HEAD + HOLE.replace("HOLE", "shape: sphere, radius: 1 cm, inertia: 1 kg m^2"),
        "inertia of its own",
    ),
    "a hole in what has no shape": (
        HEAD + SHAPE.replace("SHAPE", "inertia: 1 kg m^2, mass: 1 kg, holes: {a: {shape: sphere, radius: 1 cm}}"),
        "has no shape out of which",
    ),
    "parts beside a tensor": (
        HEAD
        + SHAPE.replace(
            "SHAPE", "mass: 1 kg, inertia: {principal: [1 kg m^2, 1 kg m^2, 1 kg m^2]}, parts: {q: {mass: 1 kg}}"
        ),
        "has parts beside an inertia tensor",
    ),
    "an annulus without radii": (HEAD + SHAPE.replace("SHAPE", "shape: annulus, mass: 2 kg"), "needs `radii`"),
    "a rope": (
        HEAD + SHAPE.replace("SHAPE", "shape: rope, mass: 2 kg, length: 1 m"),
        "is a rope, which is not solved in space",
    ),
    "limits that cross": (
        HEAD + SHAPE.replace("SHAPE", "shape: lamina, mass: 2 kg, region: {x: [0, 1 m], y: [x, 0.6 m]}"),
        "limits of `y` cross",
    ),
    "a profile that crosses": (
        HEAD + SHAPE.replace("SHAPE", "shape: solid of revolution, mass: 2 kg, profile: {z: [0, 1 m], r: [0.5 m, z]}"),
        "limits of `r` cross",
    ),
    "a density below nothing": (
        HEAD + SHAPE.replace("SHAPE", "shape: rod, length: 1 m, density: 3 kg/m^2*(x - 0.3 m)"),
        "density would be negative",
    ),
    "more than once round": (
        HEAD + SHAPE.replace("SHAPE", "shape: lamina, mass: 2 kg, region: {r: [0, 1 m], phi: [0, 5*pi]}"),
        "more than once",
    ),
    "an arc beyond a circle": (
        HEAD + SHAPE.replace("SHAPE", "shape: arc, mass: 1 kg, radius: 1 m, opening: 400 deg"),
        "once round",
    ),
    "bearings at one place": (
        f"{HEAD}{ROD}connections: {{pin: {{hinge: rod.center, along: z, bearings: [0.1 m, 0.1 m]}}}}\n"
        "states: {now: {rod.angular_velocity: 3 rad/s}}\nfind: {F: pin.bearing1.force}\n",
        "both bearings of `pin` are at one place",
    ),
    "a point with the name of another": (
        HEAD
        + SHAPE.replace("SHAPE", "shape: cone, mass: 1 kg, radius: 0.2 m, length: 0.4 m, points: {tip: [0, 0, 0.1 m]}"),
        "`tip` names a point of `b` already",
    ),
    "a body with the name of axes": (box(RATE).replace("box", "node"), "`node` can't be a name in space"),
    "a stable top that is pushed": (
        top(
            "top.tilt: 0 deg, top.axial_rate: s, steady: true",
            "{s: smallest s where now is stable}",
            given=GIVEN.replace("th: 20 deg", "s: unknown"),
            more="actions: {f: {force: [0, 0, -1 N], on: top.cm}}\n",
        ),
        "`f` acts on it beside its weight",
    ),
    "separate hinges": (
        f"{HEAD}bodies: {{one: {{shape: rod, mass: 1 kg, length: 1 m}}, two: {{shape: rod, mass: 1 kg, length: 1 m}}}}\n"
        "connections: {p: {hinge: one.start, along: y}, q: {hinge: two.end, along: z}}\n"
        "states: {now: {one.angle: 0 deg, one.angular_velocity: 3 rad/s, two.angle: 0 deg, two.angular_velocity: 0 rad/s}}\n"
        "find: {L: one.angular_momentum about two.cm}\n",
        "how far `p` and `q` are apart nothing tells",
    ),
    "a place beside a slide": (
        f"{HEAD}bodies: {{arm: {{mass: 0, points: {{P: [1 m, 0, 0]}}}}, bead: {{shape: particle, mass: 1 kg}}}}\n"
        "connections: {hub: {hinge: arm, along: z, angular_velocity: 2 rad/s}, guide: {slide: [arm.P, bead], along: x}}\n"
        'states: {now: {"bead.position relative to arm": [0.3 m, 0, 0], "bead.velocity relative to arm": [1 m/s, 0, 0]}}\n'
        "find: {N: guide.force}\n",
        "where `bead` is on `arm` is told by `guide`",
    ),
    "a product of vectors": (box(RATE, "{d: box.angular_momentum*box.angular_velocity}"), "the product of two vectors"),
    "an answer that a swing never comes to": (
        f"{HEAD}{ROD}{HINGE}states: {{a: {{rod.angle: -90 deg, rod.angular_velocity: 0.5 rad/s}}, e: {{rod.angle: -120 deg}}}}\n"
        "find: {w: rod.angular_velocity at e}\n",
        "`e` is never reached from `a`",
    ),
    "a steady top that is carried round at another rate": (
        CARRIED.replace("RATE", "5 rad/s"),
        "`top` precesses steadily at `now` only as `table` goes round",
    ),
    "a steady top that is carried round at a rate to be found": (
        CARRIED.replace("RATE", "largest")
        .replace("spin: s", "spin: 300 rad/s")
        .replace("{s: s}", "{W: top.precession}"),
        "`top` precesses steadily at `now` only as `table` goes round",
    ),
    "a blow after which either sense will do": (
        f"{HEAD}bodies: {{rod: {{shape: rod, mass: 2 kg, length: 1 m}}}}\nconnections: {{pin: {{hinge: rod.start, along: y}}}}\n"
        "states: {a: {rod.angle: 90 deg, rod.angular_velocity: 0 rad/s}, b: {}, e: {rod.angle: 20 deg}}\n"
        "events: {hit: {impulse: J, on: rod.end, direction: [1, 0, 0], from: a, to: b}}\nunknown: [J]\n"
        "find: {J: largest J where rod.angular_velocity = -1 rad/s at e}\n",
        "in which sense `rod` turns at `.` nothing tells",
    ),
    "a slide of which the energy is told": (
        f"{HEAD}bodies: {{bead: {{shape: particle, mass: 2 kg}}}}\nconnections: {{guide: {{slide: bead, along: x}}}}\n"
        "states: {now: {bead.kinetic_energy: 9 J}}\nfind: {v: bead.velocity}\n",
        "in which sense `bead` goes at `now` nothing tells",
    ),
    "a sleeve off the centre of mass, told to slide as if it did not turn": (
        COLLAR.replace("JOINT", "sleeve: col.J").replace("TOLD", "col.velocity: [0, 0, 0.3 m/s]"),
        "(?s)`col.J` can only slide along `s`.*col.J.velocity",
    ),
    "a screw that is told to go at another rate than it turns": (
        COLLAR.replace("JOINT", "screw: col.J, pitch: 20 mm").replace("TOLD", "col.velocity: [0, 0, 0.3 m/s]"),
        "contradict",
    ),
    "where a hinge turns back": (
        rod(f"{STOOD}}}, far: {{rod.angle: largest"),
        "is largest is no line of a state in space",
    ),
    "an axis across that of a shape": (
        HEAD + SHAPE.replace("SHAPE", "shape: disc, mass: 1 kg, radius: 0.2 m, axis: x"),
        "a disc is drawn about its own z, and `axis` names another one",
    ),
    "an axis of a part": (
        HEAD + SHAPE.replace("SHAPE", "parts: {d: {shape: disc, mass: 1 kg, radius: 0.2 m, axis: x, at: [0, 0, 0]}}"),
        "`axis` says nothing of a part",
    ),
    "one moment alone": (
        HEAD + SHAPE.replace("SHAPE", "inertia: 2 kg m^2, mass: 1 kg"),
        "only the moment of inertia of `b`",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_means_nothing_or_contradicts_is_refused_by_name(case: str) -> None:
    scene, match = REFUSED[case]
    with pytest.raises((Unsolvable, SceneError), match=match):
        solve(scene)


def test_a_top_that_goes_round_with_its_table_is_steady() -> None:
    """About the tip, with the inertial force M Ω² b outward through cm: s = 490.173 rad/s of the same top, worked out apart."""
    text = CARRIED.replace("RATE", "3 rad/s").replace("l: 5 cm", "l: 5 cm, g: 9.8 m/s^2")
    value = solve(text).complete().derivation.answers[0].value
    a, c, big, reach, rate, tilt = 6e-4, 8e-5, 0.2, 0.05, 3.0, math.radians(30)
    felt = big * 9.8 * reach * math.sin(tilt) + big * rate**2 * 2 * reach * reach * math.cos(tilt)
    axial = (felt / (rate * math.sin(tilt)) + a * rate * math.cos(tilt)) / c
    assert value is not None and math.isclose(value.float, axial - rate * math.cos(tilt), rel_tol=1e-9)


@pytest.mark.parametrize("told", ["col.velocity: [-0.1 m/s, 0.25 m/s, 0.3 m/s]", "col.J.velocity: [0, 0, 0.3 m/s]"])
def test_a_sleeve_off_the_centre_of_mass_is_told_how_it_slides(told: str) -> None:
    """v = s n × c + u n with c = (0.05, 0.02, 0.1) m, s = 5 rad/s; K = ½ M v² + ½ I_z s²."""
    answers = solve(COLLAR.replace("JOINT", "sleeve: col.J").replace("TOLD", told)).complete().derivation.answers
    values = [part.value.float for answer in answers[:3] for part in (answer.components or (answer,)) if part.value]
    assert values == pytest.approx([-0.1, 0.25, 0.3, 0, 0, 0.3, 0.1625 + 31.25])


def test_a_velocity_told_beside_the_acceleration_is_read() -> None:
    """K = ½ m v², P = m a · v: of each told vector something hangs on it."""
    acted = "actions: {f: {force: any, on: box}}\n"
    told = "box.velocity: [1 m/s, 2 m/s, 0 m/s], box.acceleration: [3 m/s^2, 1 m/s^2, 0 m/s^2], box.angular_velocity: [0, 0, 0 rad/s]"
    answers = solve(box(told, "{K: box.kinetic_energy, P: f.power}", more=acted)).complete().derivation.answers
    assert [answer.value.float for answer in answers if answer.value] == pytest.approx([5, 10])


def test_a_screw_on_an_arm_is_told_along_the_axes_of_that() -> None:
    """u = s p/2π along (3, 0, 4)/5 of an arm that stands at 20°, told by u: ω = Ω k + s (0.6 cos 20°, 0.6 sin 20°, 0.8)."""
    told = "[p*s/(2*pi)*3/5, 0, p*s/(2*pi)*4/5]"
    scene = f"""{HEAD}given: {{p: 20 mm, s: 5 rad/s}}
bodies: {{arm: {{mass: 0, points: {{P: [0.3 m, 0, 0]}}}}, nut: {{mass: 1 kg, inertia: {{principal: [1 kg m^2, 2 kg m^2, 3 kg m^2]}}}}}}
connections: {{hub: {{hinge: arm, along: z, angular_velocity: 3 rad/s}}, k: {{screw: [arm.P, nut], along: [3/5, 0, 4/5], pitch: p}}}}
states: {{now: {{arm.angle: 20 deg, nut.velocity relative to arm: {told}}}}}
find: {{w: nut.angular_velocity}}
"""
    parts = solve(scene).complete().derivation.answers[0].components
    turned = math.radians(20)
    found = [part.value.float for part in parts if part.value]
    assert found == pytest.approx([3 * math.cos(turned), 3 * math.sin(turned), 7])


HELD = (
    HEAD
    + """bodies:
  arm: {shape: rod, mass: 1 kg, length: 1 m, points: {P: [0.3 m, 0, 0]}}
  nut: {mass: 0.5 kg, inertia: {principal: [0.02 kg m^2, 0.03 kg m^2, 0.025 kg m^2]}, points: {H: [0.1 m, 0, 0], K: [-0.1 m, 0, 0]}}
connections: {hub: {hinge: arm.start, along: z, angular_velocity: 3 rad/s}, JOINTS}
states: {now: {arm.angle: 90 deg, LINE}}
find: {w: nut.angular_velocity}
"""
)
TURNING = {  # joints about whose axis a body turns, and how a message calls them
    "k: {hinge: [arm.P, nut.H], along: x}": "a `hinge`",
    "k: {sleeve: [arm.P, nut.H], along: x}": "a `sleeve`",
    "k: {screw: [arm.P, nut.H], along: x, pitch: 2 mm}": "a `screw`",
    "k: {axle: [arm.P, nut], along: x}": "an `axle`",
    "k: {ball: nut.H}, l: {ball: nut.K}": "the joints `k` and `l`",
}
KEEPING = {"k: {slide: [arm.P, nut.H], along: x}": "a `slide`", "k: {clamp: [arm.P, nut.H]}": "a `clamp`"}


@pytest.mark.parametrize(("joints", "words"), (TURNING | KEEPING).items())
def test_what_a_joint_tells_is_refused_by_the_name_of_that_joint(joints: str, words: str) -> None:
    told = {"nut.tilt: 30 deg": "`tilt`", "'nut.angular_velocity': [1 rad/s, 0, 0]": "one number, about the axis"}
    for line, said in told.items():
        if joints in TURNING or "tilt" in line:
            with pytest.raises(Unsolvable, match=f"`nut` is on {words}: .*{said}"):
                solve(HELD.replace("JOINTS", joints).replace("LINE", line))


@pytest.mark.parametrize("joints", TURNING)
def test_the_one_number_that_is_written_instead_is_read(joints: str) -> None:
    told = HELD.replace("JOINTS", joints).replace("LINE", "nut.angular_velocity: 3 rad/s")
    assert solve(told).complete().derivation.confirmed[0].holds is True


SEEN = {  # lines of a state with a frame or axes that mean nothing for them
    "'nut.angular_velocity relative to arm': [1 rad/s, 0, 0]": "not its `angular_velocity`",
    "'nut.angular_acceleration relative to arm': [1 rad/s^2, 0, 0]": "not its `angular_acceleration`",
    "nut.kinetic_energy relative to arm: 2 J": "not its `kinetic_energy`",
    "nut.velocity relative to arm in space axes: [1 m/s, 0, 0]": "told along the axes of `arm`",
    "nut.position relative to arm in space axes: [1 m, 0, 0]": "told along the axes of `arm`",
    "nut.position in arm axes: [1 m, 0, 0]": "told along the axes of space",
    "nut.vertical in arm axes: [0, 0, 1]": "told along the axes of its body",
}


@pytest.mark.parametrize("line", SEEN)
def test_a_frame_or_axes_that_nothing_reads_are_refused(line: str) -> None:
    with pytest.raises(Unsolvable, match=SEEN[line]):
        solve(HELD.replace(", JOINTS", "").replace("LINE", line))


@pytest.mark.parametrize("joints", ["", ", k: {ball: nut.H}", ", k: {ball: [arm.P, nut.H]}"])
@pytest.mark.parametrize("word", ["velocity", "acceleration"])
def test_how_a_body_turns_is_told_along_the_axes_of_another_one(joints: str, word: str) -> None:
    """The x axis of the arm lies along y."""
    unit = "rad/s" if word == "velocity" else "rad/s^2"
    told = f"'nut.angular_{word} in arm axes': [15 {unit}, 0, 0]"
    told += ", nut.angular_velocity: [0, 0, 0]" if word == "acceleration" else ""
    scene = (
        HELD.replace(", JOINTS", joints)
        .replace("LINE", told)
        .replace("w: nut.angular_velocity", f"w: nut.angular_{word}")
    )
    scene = scene.replace("states:", "actions: {c: {couple: any, on: nut}}\nstates:")
    derivation = solve(scene).complete().derivation
    found = [part.value.float for part in derivation.answers[0].components if part.value]
    assert found == pytest.approx([0, 15, 0])
    assert derivation.confirmed[0].holds is True


def test_two_bodies_are_not_told_along_the_axes_of_each_other() -> None:
    told = "'nut.angular_velocity in arm axes': [1 rad/s, 0, 0], 'arm.angular_velocity in nut axes': [1 rad/s, 0, 0]"
    scene = HELD.replace("hinge: arm.start, along: z, angular_velocity: 3 rad/s", "ball: arm.start")
    with pytest.raises(Unsolvable, match="of which it is not told yet how it stands"):
        solve(scene.replace(", JOINTS", "").replace("arm.angle: 90 deg, LINE", told))
