"""Equations, and the laws that they state: each law has an identity, by which it is asked for; what it is called is printed only.

To add a law: a row here or beside its function (`Law(name, words, family, cost)`), and a row in rotsolve/laws/table.py that says for
what it is written. `Law.equation` fills in the words.
"""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, Formula, Integral
from rotsolve.core.derivation import Words
from rotsolve.core.writing import spoken

NEWTON, ENERGY, ANGULAR_MOMENTUM, LAGRANGE = "newton", "energy", "angular-momentum", "lagrange"
KINEMATICS = "kinematics"  # motion in time: used with every law, but not where only one moment is looked at
SECOND_CHOICE = 5  # laws of this cost restate others: they serve only a law that is asked for, or a confirmation


class Family(Struct, frozen=True):
    """What `--law` may name: laws by which a problem can be solved alone. `words` is how it is said, `gives` the verb that follows.

    Laws that are written `only_asked` for restate the others: no scene is solved or confirmed by them unless `--law` names them.
    """

    name: str
    words: str
    gives: str = "gives"
    only_asked: bool = False

    @property
    def does(self) -> str:
        """The verb in front of another one: does, do."""
        return "does" if self.gives.endswith("s") else "do"


FAMILIES = {  # an equation without a family serves them all
    one.name: one
    for one in (
        Family(NEWTON, "Newton's laws", "give"),
        Family(ENERGY, "energy"),
        Family(ANGULAR_MOMENTUM, "angular momentum"),
        Family(LAGRANGE, "Lagrange's equations", "give", only_asked=True),
    )
}


class Law(Struct, frozen=True):
    """What an equation states. `name` is its identity.

    `words` is its label, with braces for what an equation fills in; {body} is the first of its bodies. `family` is one of FAMILIES,
    KINEMATICS, or '' for rules and definitions; `cost` orders plans (a textbook's first choice costs least).
    """

    name: str
    words: str = "{words}"
    family: str = ""
    cost: int = 2
    steady: str = (
        ""  # the coordinate, of those of constant acceleration: of all of one in a phase only two are independent
    )
    mean: bool = False  # of these, mean velocity × time
    condenses: bool = False  # may stand in for one of Newton's laws of its bodies
    shifts: bool = False  # takes a moment of inertia to another axis, by M d² as its last term
    kinetic: bool = False  # says what a kinetic energy is
    apart: bool = False  # tells a letter that is worked out by itself, before what it is part of
    numbered: bool = False  # of these, one that stays a letter with a number, if the scene has numbers: no page would hold its closed form
    explained: bool = False  # its remark is a sentence of its own, ahead of the laws

    def equation(
        self,
        left: Formula,
        right: Formula,
        section: str,
        bodies: tuple[str, ...] = (),
        remark: Words = (),
        *,
        cost: int | None = None,
        defines: str = "",
        relation: str = "=",
        common: Formula = ONE,
        **words: str,
    ) -> Equation:
        """left = right by this law, its label filled in with `words`."""
        label = self.words.format(body=spoken(bodies[0]) if bodies else "", **words)
        own = self.cost if cost is None else cost
        return Equation(left, right, self, section, label, own, remark, defines, bodies, relation, common)


class Equation(Struct, frozen=True):
    """left = right, by a law.

    `section` is the state, phase or event where it is written, `label` what is printed beside it, `cost` that of its law or its own.
    `defines` names the symbol that a definition introduces, which the solver puts in first. `relation` is ≈ where small quantities have
    been left out. `common` is what both sides are multiples of, known and not 0, by which a step divides them.
    """

    left: Formula
    right: Formula
    law: Law
    section: str
    label: str = ""
    cost: int = 2
    remark: Words = ()
    defines: str = ""
    bodies: tuple[str, ...] = ()
    relation: str = "="
    common: Formula = ONE

    @property
    def family(self) -> str:
        return self.law.family

    def symbols(self) -> frozenset[str]:
        return self.left.symbols() | self.right.symbols()

    def summed(self) -> frozenset[str]:
        """Letters within its integrals, which it can not be solved for."""
        if not (self.left.holds(Integral) or self.right.holds(Integral)):
            return frozenset()
        integrals = [
            node for side in (self.left, self.right) for node in side.walk(Integral) if isinstance(node, Integral)
        ]
        return frozenset(name for node in integrals for name in node.integrand.symbols())

    def renamed(self, names: dict[str, Formula]) -> Equation:
        remark = tuple(part.substitute(names) if isinstance(part, Formula) else part for part in self.remark)
        left, right, common = (part.substitute(names) for part in (self.left, self.right, self.common))
        return replace(self, left=left, right=right, remark=remark, common=common)


# Newton's laws

SECOND_LAW = Law("second law", "Newton's second law, {body}{component}", NEWTON, 3)
ACROSS = Law("second law across what turns", "Newton's second law, {rider}, across {carrier}", NEWTON, 3)
ALONG_TURNING = Law("sliding along what turns", "motion of {rider} along {carrier}, r̈ = ω² r", NEWTON, 3)
CARRIED = Law("carried apart", "Newton's second law, {whole}{component}: what it lies on carries it", NEWTON, 3)
ROTATION = Law("rotation", "Newton's law for rotation, {body}{about}", NEWTON, 3)
ABOUT_CONTACT = Law("rotation about a point of contact", "Newton's law for rotation, {body} about {point}", NEWTON, 2)
TORQUES = Law("torques", "balance of torques, {body} about {point}", NEWTON, 3)
CUT_TORQUES = Law("balance at a cut", "balance of torques about the cut, {body}", NEWTON, 3)
SUMMED_OVER_WAY = Law("summed over the way", "Newton's law summed over the {over}, {body}", NEWTON, 5)
POINT_OF_SLIPPING = Law("point of slipping", "on the point of slipping, f = μₛ N", NEWTON)
VERGE = Law("verge of slipping", "on the point of slipping", NEWTON)

ANGULAR_MOMENTUM_IN_SPACE = Law("angular momentum in space", "angular momentum, {body}{about}, along {axis}", cost=1)
COUPLE_OF_BEARINGS = Law("couple of bearings", "couple of the bearings of {owner}, along {axis}", NEWTON, 2)
SIZE_OF_MOMENTUM = Law("size of the angular momentum", "size of the angular momentum, {body}", cost=1)
RATE_IN_AXES = Law("rate of angular momentum in axes", "τ = {rate}, {body}{about}{along}", NEWTON, 3)
RATE_IN_STILL_AXES = Law("rate of angular momentum in axes that stay", "τ = dL/dt, {body}{about}{along}", NEWTON, 3)
RATES_OF_MOMENTUM = (RATE_IN_AXES, RATE_IN_STILL_AXES)

# energy

FROM_STATE_TO_STATE, FROM_REST = "K₁ + U₁ = K₂ + U₂", "U₁ − U₂ = K₂"  # forms of the conservation of energy
CONSERVATION = Law("conservation of energy", "conservation of energy{since}, {form}", ENERGY, 4)
WORK_AND_ENERGY = Law("work and energy", "work and energy, K₁ + U₁ + W = K₂ + U₂", ENERGY, 4)
TURNING_FRAME = Law(
    "energy in a turning frame", "energy in the frame that turns with {driven}, K′₁ + U′₁{work} = K′₂ + U′₂", ENERGY, 4
)
POWER = Law("power", "power and kinetic energy", ENERGY, 12)
DERIVATIVE = Law("derivative of the energy", "derivative of the energy", ENERGY, 5, condenses=True)
WORK = Law("work", "work of {owner}", cost=3, explained=True)
WAY_OF_SLIP = Law("way of an even slip", "way by which {owner} slides", cost=1, steady="slip")

# momentum and angular momentum

MOMENTUM = Law("momentum", "{words}", ANGULAR_MOMENTUM, 3)
CENTRE_STAYS = Law("momentum summed over the time", "{words}", ANGULAR_MOMENTUM, 5)
BLOWS = Law("blows", "impulse = change of momentum, {body}", ANGULAR_MOMENTUM, 4)
TWISTS = Law("twists", "angular impulse = change of angular momentum, {body}{about}", ANGULAR_MOMENTUM, 4)
UNTWISTED = Law("untwisted", "no angular impulse, {body}{about}", ANGULAR_MOMENTUM, 3)
COMMON_AXIS = Law("angular momentum about an axis", "{words}", ANGULAR_MOMENTUM, 3)
ANGLES_TURNED = Law("angles turned", "angular momentum summed over the time", ANGULAR_MOMENTUM, 5)
RATE = Law("rate of angular momentum", "angular momentum about {point}: its rate is the torque", ANGULAR_MOMENTUM, 5)
UNPRESSED = Law("unpressed", "{owner} can not pull, and nothing presses", cost=2)
RESTITUTION = Law("restitution", "coefficient of restitution")

# Lagrange's equations

LAGRANGE_EQUATION = Law("Lagrange's equation", "Lagrange's equation, {coordinate}", LAGRANGE, 5)
ENERGY_FUNCTION = Law("energy of the Lagrangian", "{words}", LAGRANGE, 5)
TURNING_TILTS = Law(
    "turning tilts", "energy and conserved momenta between two tilts without nutation, {body}", LAGRANGE, 5
)
DIVIDED_TILTS = Law("divided tilts", "energy divided by the momentum of the precession angle, {body}", LAGRANGE, 5)
CYCLIC = Law("momentum of a cyclic coordinate", "conserved, since cyclic: momentum of {coordinate}", LAGRANGE, 5)

# motion

RULE = Law("rule")  # of rates and accelerations
RULE_OF_WAYS = Law("rule of ways", family=KINEMATICS)
STRETCH = Law("stretch")
GIVEN_MOTION = Law("given motion", "{quantity} {letters}, {body}", KINEMATICS, 1)
PERIOD = Law("period", "period of {body}, T = 2π/ω", KINEMATICS, 1)
STEADY = Law("steady rotation", "{body} turns steadily", KINEMATICS, 1)
STEADY_TRAVEL = Law("constant acceleration", "constant acceleration, {body}", KINEMATICS, steady="way")
STEADY_TURN = Law("constant angular acceleration", "constant angular acceleration, {body}", KINEMATICS, steady="angle")
TRAVEL_BY_MEAN = Law("mean velocity", STEADY_TRAVEL.words, KINEMATICS, 3, steady="way", mean=True)
TURN_BY_MEAN = Law("mean angular velocity", STEADY_TURN.words, KINEMATICS, 3, steady="angle", mean=True)
TRAVEL_AT_ANY_TIME = Law(
    "travel at any time", "constant acceleration, at any time, {body}", KINEMATICS, 3, steady="way at any time"
)
TURN_AT_ANY_TIME = Law(
    "turn at any time", "constant angular acceleration, at any time, {body}", KINEMATICS, 3, steady="angle at any time"
)
IN_TIME = Law("in time", "{words}, {body}", KINEMATICS)
PART_IN_TIME = Law("part of a motion in time", "{words}, {body}", KINEMATICS, apart=True)
BY_PLACE = Law("by place", "{words}, {body}", KINEMATICS)
COORDINATE = Law("coordinate", "{words}, {body}", KINEMATICS, 1)
SEPARATED_BY_RATE = Law("separated by rate", "separating the variables, {words}, {body}", KINEMATICS, 3)
SPEED_AT_PLACE = Law("speed at any place", "speed at any place, {words}, {body}", KINEMATICS, 3)
SEPARATED_BY_PLACE = Law("separated by place", "separating the variables, {words}, {body}", KINEMATICS, 3)
TIME_ELAPSED = Law("time elapsed", "time elapsed", KINEMATICS, 1)
REVERSAL = Law("reversal", family=KINEMATICS, cost=1)

# inertia and the centre of mass

INERTIA = Law("inertia", cost=1)  # what a mass, a centre of mass or a moment of inertia is
INTEGRATED = Law("inertia by integration", cost=1, explained=True)  # the same as an integral over elements
FACE_FRICTION = Law("friction over a face", cost=1, explained=True)  # a torque as an integral over elements
PARALLEL_AXES = Law("parallel axes", cost=1, shifts=True)
PART_OF_ROOTS = Law("part of the roots of a cubic", "{words}", cost=1, apart=True)
LONG_ENTRY = Law(
    "entry of a long tensor", "{words}", cost=0, apart=True, numbered=True
)  # rather than what else tells it

# small swings

HARMONIC = Law("simple harmonic motion", "simple harmonic motion")
PENDULUM = Law("pendulum", "equation of motion of a pendulum")
SMALL_SWINGS = Law("small swings", "small swings", cost=1)
SWINGS = Law("period of swings", cost=1)
NORMAL_MODE = Law("normal mode", "angular frequency of {mode}", cost=1, explained=True)
DAMPING_RATE = Law("damping rate", "{words}", cost=1, explained=True)
DAMPED_SWINGS = Law("damped swings", "{words}", cost=1)
MODE_SHAPE = Law("shape of a mode", "{words}", cost=1)
SMALL_DISTURBANCE = Law(
    "small disturbance", family=NEWTON, cost=1
)  # of a steady motion in space, by what its torques are then
SMALL_NUTATION = Law("small nutation", family=ENERGY, cost=1)  # in the effective potential of the energy
STABILITY = Law("stability", "limit of stability, nothing drives it back")
STEADY_LIMIT = Law(
    "limit of steady precession", "limit of steady precession, both rates of precession are one", explained=True
)

# what the scene and its questions say

STATED = Law("stated")
CONDITION = Law("condition", "the condition{words}")
DEFINITION = Law("definition", cost=1)
VANISHING = Law("vector that vanishes", "{words}", cost=1)  # whose components are told all the same
COMPONENTS = Law("components", "{words}", cost=1)  # of a size and an angle that are both sought
KINETIC_ENERGY = Law("kinetic energy", cost=1, kinetic=True)
KINETIC_ENERGY_AT = Law("kinetic energy at a moment", "kinetic energy, {moment}", cost=1, kinetic=True, apart=True)
FOUND = Law("found", "", cost=0)  # found before: no law of its own


def frame_remark(driven: str) -> Words:
    """Why the energy in the frame that turns with a body stays: what does no work there."""
    still = f"{driven} turns steadily: in its frame what drives it does no work, nor does the Coriolis force"
    return (f"{still}; the centrifugal force m ω² r has the potential energy −½ m ω² r²",)
