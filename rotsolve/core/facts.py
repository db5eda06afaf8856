"""Facts: what a free-body diagram shows. Elements state them, laws read them; neither knows the other.

Signs: torques, angular velocities and angular accelerations in facts are counterclockwise positive; `Motion.sense` turns them
into the sense that the scene declares. Vectors are in the plane, headings counterclockwise from the rightward horizontal.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct, field

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, call, negate
from rotsolve.core.derivation import Words
from rotsolve.core.drive import Drive
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, Heading, Vector
from rotsolve.core.vectors.triple import square as square
from rotsolve.core.writing import spoken


class Bend(Struct, frozen=True):
    """The circle on which a body's centre travels: its radius, and the direction from its centre to the body's."""

    radius: Formula
    outward: Heading


class Whirl(Struct, frozen=True):
    """What a turning upright shaft does: all goes round it at `rate`; the reference of the body is at `distance` on its right.

    The picture is the upright plane that turns with it: a point at x from the axis goes across the picture with rate · x.
    """

    rate: Formula
    distance: Formula

    def across(self, arm: Vector) -> Formula:
        """Speed square to the picture, Ω x, of a point by its arm from the reference."""
        return self.rate * (self.distance + arm.along(RIGHT))

    def inwards(self, arm: Vector) -> Vector:
        """Ω² x towards the axis."""
        away = self.distance + arm.along(RIGHT)
        return Vector(((square(self.rate) * away, RIGHT.turned(180)),)) if away != ZERO else NOWHERE


class Motion(Struct, frozen=True):
    """How a body can move, about its reference point (the fixed pivot, the centre of what rolls, else the centre of mass).

    kind: 'axis' turns about a fixed point; 'line' travels along `heading` (and turns if `turns`); 'plane' moves freely;
    where the line is a circle, `bend` is that circle and `heading` its tangent; 'still' does not move. `velocity`,
    `acceleration` are those of the reference; `spin`, `spin_rate` are ccw ω and α.
    `sense` is +1 where the declared positive turn is counterclockwise. `orientation` turns the body's own axes into space.
    """

    kind: str
    velocity: Vector = NOWHERE
    acceleration: Vector = NOWHERE
    spin: Formula = ZERO
    spin_rate: Formula = ZERO
    sense: int = 1
    turns: bool = False
    heading: Heading | None = None
    orientation: Heading = field(default_factory=Heading)
    reference: Vector = NOWHERE
    bend: Bend | None = None
    whirl: Whirl | None = None

    def velocity_of(self, arm: Vector) -> Vector:
        """v_P = v + ω × r in the picture, r from the reference."""
        return self.velocity + arm.turned(90).times(self.spin)

    def acceleration_of(self, arm: Vector) -> Vector:
        """a_P = a + α × r − ω² r in the picture, r from the reference; on a turning shaft also Ω² x towards it."""
        own = self.acceleration + arm.turned(90).times(self.spin_rate) + arm.turned(180).times(square(self.spin))
        return own if self.whirl is None else own + self.whirl.inwards(arm)

    def whirl_at(self, arm: Vector) -> Whirl | None:
        """The turning shaft as a piece sees it whose reference is at an arm from that of the whole."""
        return None if self.whirl is None else Whirl(self.whirl.rate, self.whirl.distance + arm.along(RIGHT))


class Role(Struct, frozen=True):
    """What a force or couple is to the body on which it acts; `name` is its identity. Laws ask its questions, never its name.

    To add one: a row below, or a record of its own beside the element that states it.
    """

    name: str
    weighs: bool = False  # m g: energy counts it by the height of the body
    stores: bool = False  # its work is told by a potential energy
    loses: bool = False  # its work is given or taken for good
    inner: bool = False  # between parts of one body or system, whose work together is told elsewhere
    powered: bool = False  # known by its power
    pulls: bool = False  # along a string
    presses: bool = False  # across a surface
    loads: bool = False  # of these, by what lies on the body, which does not hold it
    rubs: bool = False  # along a surface or at an axle, against the slip or as large as it takes to prevent it
    springs: bool = False  # by how far a spring is stretched
    holds: bool = False  # what a support does to what it holds
    axle: bool = False  # of a support in whose axis a wheel turns
    unseen: bool = False  # told in a free-body diagram only where an equation speaks of it
    meshes: bool = False  # between rims, where the way it points hangs on where the wheels stand: told by its size
    hides: str = ""  # why nothing tells the force of what holds its body: what else it does to that
    noun: str = ""  # what all forces of this role are called where several are listed


WEIGHT = Role("weight", weighs=True, stores=True, noun="weight")
HANGING = Role("hanging", stores=True)  # the weight of a part of a rope
TENSION = Role("tension", pulls=True)
SLIPPING = Role("tension of a rope that slips on a post", pulls=True, loses=True)
NORMAL = Role("normal", presses=True)
LOAD = Role("load", presses=True, loads=True)
FRICTION = Role("friction", loses=True, rubs=True)
SHARED_FRICTION = Role(
    "friction shared over a face",
    loses=True,
    rubs=True,
    hides="holds it at many places, and how it is shared is not told",
)
BAND = Role("friction of a band", loses=True, rubs=True, hides="draws on it from where its ends run, which is not told")
REACTION = Role("reaction", holds=True, unseen=True)
AXLE = Role("axle", holds=True, axle=True, unseen=True)
GUIDE = Role("guide")  # what a slot does to its pin, and the pin to the slot, across it
GRIP = Role("grip", unseen=True)  # of a rope and the wheel over which it runs
SPRING = Role("spring", stores=True, springs=True)
TORSION = Role("torsion", stores=True)
APPLIED = Role("applied")
DRIVE = Role("drive", loses=True)  # whatever makes a given motion true
COUPLING = Role("coupling", meshes=True)
PULL = Role("pull of a belt", hides="presses on it as strongly as it was put on")
POWERED = Role("power", powered=True)
INNER = Role("inner", loses=True, inner=True)
BLOW = Role("blow")  # from outside the scene
CONTACT = Role("contact")  # of bodies that meet


class Force(Struct, frozen=True):
    """A force on a body: size along a unit vector, acting at `arm` from the body's reference point.

    `noun` and `way` say what it is and where it points, `place` to what it belongs. `works` is False where its point is at rest or moves
    across it (reactions, rolling friction, normal forces), so that energy may leave it out.
    """

    owner: str
    role: Role
    body: str
    size: Formula
    direction: Vector
    arm: Vector
    noun: str
    way: str = ""
    place: str = ""
    works: bool = True
    internal: bool = False  # ideal connection: its powers on all its bodies add up to nothing
    part: str = ""  # of several bodies that are joined the one on which it acts, where that is told

    @property
    def words(self) -> Words:
        return told(self.noun, self.size, self.place, self.way)

    @property
    def vector(self) -> Vector:
        return self.direction.times(self.size)

    @property
    def torque(self) -> Formula:
        """r × F about the reference, counterclockwise positive; a slanted unit vector's components are drawn together."""
        torque = self.arm.cross(self.vector)
        return torque if len(self.direction.parts) == 1 else simplify(torque)


class Couple(Struct, frozen=True):
    """A couple on a body, counterclockwise positive; `size` is what it is told by."""

    owner: str
    role: Role
    body: str
    torque: Formula
    noun: str
    size: Formula
    way: str = ""
    place: str = ""
    internal: bool = False

    @property
    def words(self) -> Words:
        return told(self.noun, self.size, self.place, self.way)


def told(noun: str, size: Formula, place: str, way: str) -> Words:
    """A force or couple as a diagram says it: "kinetic friction f of the block, right"."""
    behind = (f" {place}" if place else "") + (f", {way}" if way else "")
    return (f"{noun} ", size, behind) if behind else (f"{noun} ", size)


class Rule(Struct, frozen=True):
    """A rate rule: left = right, for velocities and for accelerations.

    `linear` says that the coefficients never change, so that the rule holds for displacements and angles turned as well. There is no
    rule for accelerations where sizes change on the way.
    """

    owner: str
    label: str
    bodies: tuple[str, ...]
    velocity: tuple[Formula, Formula]
    acceleration: tuple[Formula, Formula] | None
    linear: bool = True
    remark: Words = ()
    bent: Words = ()  # what is said of the accelerations alone


class Need(Struct, frozen=True):
    """A kind of requirement; `grips` where it is friction that has to suffice: |f| ≤ μₛ N; `placed` where it is about places or
    speeds, which change though all forces stay; `closed` where it is met on its edge as well, `strict` where that is another scene;
    `stands` where it is about how a body stands at a state."""

    name: str
    grips: bool = False
    placed: bool = False
    closed: bool = False
    strict: bool = False
    stands: bool = False


TAUT, TOUCHES, REACHES, GRIPS = Need("taut"), Need("touches"), Need("reaches"), Need("grips", grips=True)
BINDS = Need("binds", closed=True)  # a band or a rope round what it does not slip on
APART = Need("apart", placed=True)  # of bodies that have met
GAINS = Need("gains", placed=True)  # no blow gives energy
COMES = Need("comes", placed=True)  # what strikes a surface, towards it
IN_FRONT = Need("in front", placed=True, closed=True)  # what has struck a surface, of that
MEETS = Need("meets", placed=True, strict=True)  # of several blows at once each: something comes together
PUSHES = Need("pushes")  # of several blows at once each, and of a rough one
TURNS = Need("turns", closed=True)  # the slip of what friction turns too, in a blow, back
SLIDES = Need("slides", placed=True, closed=True)  # what slips through a blow, on the same way
LIFTS = Need("lifts", placed=True)  # what is taken along leaves what it lay on
PRESSES = Need("presses", placed=True, closed=True)  # a brake block does not pull
LIES = Need("lies", placed=True, closed=True, stands=True)  # a ladder in front of its wall, and not in it
ROCKS = Need("rocks", placed=True, closed=True, stands=True)  # half a cylinder on its round side
STANDS = Need("stands", placed=True, closed=True)  # a crate on its base
ON_THE_WAY = Need("on the way", placed=True, closed=True)  # what is least within a phase


class Requirement(Struct, frozen=True):
    """An inequality that the answer must obey: left ≥ right. `kept` says what holds then, "" where that is not worth a
    word, `otherwise` what really happens else."""

    owner: str
    kind: Need
    left: Formula
    right: Formula
    kept: str
    otherwise: str


class Potential(Struct, frozen=True):
    """Potential energy stored in a spring at an instant: by its elongation, which grows at `rate`; or by the length of a rope that hangs.

    `label` says how the elongation grows in a phase; where it is `placed`, the places of its ends tell it at once.
    """

    owner: str
    energy: Formula
    elongation: Formula
    rate: Formula
    bodies: tuple[str, ...]
    words: Words
    label: str = "the spring stretches with the motion"
    placed: bool = False


class Summed(Struct, frozen=True):
    """The friction torque of a face, τ = ∫ r μ dN: its letter, the integral over its elements, its label, and what these are."""

    owner: str
    letter: Formula
    integral: Formula
    label: str
    bodies: tuple[str, ...]
    words: Words = ()


class Sweep(Struct, frozen=True):
    """What a turning shaft asks of a body: what its pieces' m a add up to about the reference, counterclockwise, is rate² ∫ x y dm (the
    `moment`), y up from the reference; `inertia` is that about the shaft, ∫ (x² + z²) dm.
    """

    rate: Formula
    moment: Formula
    inertia: Formula


class GivenMotion(Struct, frozen=True):
    """A given motion at one moment: the drive, the letters of the moment by their words, and its running time."""

    drive: Drive
    letters: Mapping[str, Formula]
    time: Formula


class Inertia(Struct, frozen=True):
    """Moment of inertia about the pivot, else the centre of mass; of a cut-off piece also its mass: the letter, and what defines it."""

    letter: Formula
    formula: Formula
    label: str
    remark: Words = ()


class Slider(Struct, frozen=True):
    """What slides freely along a body that turns: its mass, its speed outwards and its distance from the axis, the way out, the push on it
    across that, counterclockwise positive."""

    name: str
    mass: Formula
    speed: Formula
    place: Formula
    outward: Heading
    push: Formula | None  # nothing of several, whose pushes together turn nothing


class BodyFacts(Struct, frozen=True):
    """One body at one instant: inertia, motion and all that acts on it."""

    name: str
    mass: Formula
    inertia: Inertia | None
    motion: Motion
    cm: Vector  # centre of mass from the reference point
    axes: tuple[Heading, ...]  # directions along which Newton's second law is written
    positive: str
    forces: tuple[Force, ...]
    couples: tuple[Couple, ...]
    round: bool = False
    period: Formula | None = None  # of a steady rotation, where the scene speaks of it
    along: tuple[str, ...] = ()  # what the axes are called, where that is not plain
    sweep: Sweep | None = None
    axis: str = ""  # the support on whose axis it turns; bodies with the same one have that axis in common
    lays: bool = False  # it lays itself out, layer by layer
    changing: bool = False  # its mass or moment of inertia changes in the phase, so that I α is not all of dL/dt
    slanted: bool = False  # it travels along a slope
    sliding: tuple[Slider, ...] = ()  # all that slides freely along it
    drawn: bool = False  # whether its own data change otherwise than by what slides freely
    footings: tuple[
        tuple[str, ...], ...
    ] = ()  # of joined bodies on a line: those that are carried apart from each other

    @property
    def acting(self) -> tuple[Force | Couple, ...]:
        """All that acts on it, forces before couples."""
        return (*self.forces, *self.couples)

    @property
    def supported(self) -> bool:
        """Whether something on which it lies presses on it."""
        return any(force.role.presses and not force.role.loads for force in self.forces)

    @property
    def about(self) -> Vector:
        """The point about which its law of rotation is written, from the reference: the fixed pivot, else the centre of mass."""
        return NOWHERE if self.motion.kind == "axis" else self.cm

    def torque_of(self, item: Force | Couple) -> Formula:
        """Of a force or couple about that point, counterclockwise positive."""
        if isinstance(item, Couple) or not self.about.parts:
            return item.torque
        return simplify((item.arm - self.about).cross(item.vector))

    @property
    def pressed(self) -> bool:
        """Whether a surface pushes it."""
        return any(force.role.presses for force in self.forces)

    @property
    def centre_velocity(self) -> Vector:
        return self.motion.velocity_of(self.cm)

    @property
    def centre_acceleration(self) -> Vector:
        return self.motion.acceleration_of(self.cm)


class Cut(Struct, frozen=True):
    """A piece of a rod, cut free: as a body whose reference is its centre of mass, its mass, and where the cut is from there.

    `index` marks the letters of what is found at the cut.
    """

    body: BodyFacts
    mass: Inertia
    at: Vector
    index: str
    jumps: bool = False  # whether something acts just at the cut, so that shear and compression jump there


class Facts(Struct, frozen=True):
    """All facts at one instant."""

    state: str
    span: str
    bodies: tuple[BodyFacts, ...]
    rules: tuple[Rule, ...]
    requirements: tuple[Requirement, ...]
    potentials: tuple[Potential, ...]
    given: tuple[GivenMotion, ...] = ()
    cuts: tuple[Cut, ...] = ()
    sums: tuple[Summed, ...] = ()

    def body(self, name: str) -> BodyFacts | None:
        return next((body for body in self.diagrams if body.name == name), None)

    @property
    def diagrams(self) -> tuple[BodyFacts, ...]:
        """All free-body diagrams: of the bodies, and of pieces of them."""
        return (*self.bodies, *(cut.body for cut in self.cuts))


def signed(value: Formula, sense: int) -> Formula:
    """`value` counted along a sense: itself for +1, its negative for −1."""
    return value if sense > 0 else negate(value)


def enough(owner: str, size: Formula, most: Formula, verb: str) -> Requirement:
    """Friction that holds is at most as large as it can be, |f| ≤ f_max: else it slips, or a wheel turns."""
    return Requirement(owner, GRIPS, most, call("abs", size), f"does not {verb}", f"{verb}s")


def held_still(owner: str, name: str, motion: Motion) -> Rule:
    """A body that friction holds: ω = 0, α = 0."""
    label = f"friction holds {spoken(name)}"
    velocity, acceleration = ((signed(rate, motion.sense), ZERO) for rate in (motion.spin, motion.spin_rate))
    return Rule(owner, label, (name,), velocity, acceleration)
