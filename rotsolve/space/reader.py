"""Reader in space: what a path of a question stands for at a moment; vectors by components, along the axes that the question names."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Sum, Symbol, add, call, multiply, sqrt
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.core.equation import KINETIC_ENERGY
from rotsolve.core.quantity import DIRECTED, INERTIAL, QUANTITIES
from rotsolve.core.symbols import has_quantities, key_of
from rotsolve.core.vectors.tensor import ENTRIES, InertiaTensor
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    AXES,
    NOTHING,
    Triple,
    cross_product,
    dot_product,
    length_of,
    minus,
    scaled_by,
    square_of,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import PointRef
from rotsolve.language.grammar import ANGLE_OF
from rotsolve.language.problem import Find, Path, Problem, Term
from rotsolve.paths.meaning import Meaning, NotYet, label_of, path_text
from rotsolve.space.arrangement import NODAL
from rotsolve.space.attitude import IN_SPACE, Axes
from rotsolve.space.energies import height_above, kinetic_energies
from rotsolve.space.inertia import CM, in_axes, moment_along, product
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.passing import joint_shock
from rotsolve.space.telling import turns_untold

INERTIAL_NAMES = {
    "centrifugal": "centrifugal force on {body}, −m Ω × (Ω × r)",
    "euler": "Euler force on {body}, −m (dΩ/dt) × r",
    "coriolis": "Coriolis force on {body}, −2 m Ω × v",
}
Seen = tuple[Triple, Axes]  # a vector and the axes along which its components are
AT_REST = (
    "inertia",
    "inertia_tensor",
    "principal_moments",
    "principal_axis",
    "freedoms",
    "mass",
    "cm",
)  # asked of what need not move


def entries_in_space(find: Find) -> tuple[Find, ...]:
    """A question for a vector or a tensor as questions for its entries; any other question alone."""
    if len(find.terms) != 1 or find.modifier or not proportional(find.formula):
        return (find,)
    term = find.terms[0]
    names = entries_of(term)
    whole = term.path.component
    parts = []
    for name in names:
        path = replace(term.path, component=name if whole is None else f"{whole} {name}")
        parts.append(replace(find, name=f"{find.name}_{name}", terms=(replace(term, path=path),), whole=find.name))
    return tuple(parts) or (find,)


def proportional(formula: Formula) -> bool:
    """Whether a formula is a multiple of its only quantity by givens, so that it may be a vector."""
    rest = formula.substitute({"#0": ONE})
    return "#0" in formula.symbols() and (formula == Symbol("#0") or is_zero(formula - rest * Symbol("#0")))


def entries_of(term: Term) -> tuple[str, ...]:
    """The names of the entries of what a term asks for; none of a scalar."""
    path = term.path
    if term.modifier not in ("", "change of", "mean") or path.component in (*AXES, *ENTRIES):
        return ()
    if path.quantity in DIRECTED or path.quantity == "cm":
        return AXES
    if path.quantity == "principal_moments" and path.component is None:
        return ("1", "2", "3")
    return ENTRIES if path.quantity == "inertia_tensor" else ()


class SpaceReader:
    """Reads paths at one moment; `moments` are those of all states."""

    def __init__(self, dynamics: SpaceLaws, moments: Mapping[str, SpaceLaws], problem: Problem) -> None:
        self.dynamics, self.moments, self.problem = dynamics, moments, problem
        self.moment, self.held = dynamics.moment, dynamics.moment.held
        self.bodies = self.held.bodies

    def meaning(self, path: Path, term: Term | None = None) -> Meaning:
        """What a path stands for; raises `NotYet` for what has no meaning here."""
        term = term or Term(path)
        if term.modifier == ANGLE_OF and term.other is not None:
            return self.between(term, term.other)
        kind = QUANTITIES[path.quantity]
        unwritten = self.dynamics.unwritten
        refused = next((unwritten[owner] for owner in self.concerned(path.owner) if owner in unwritten), None)
        if path.quantity not in AT_REST and not self.told_onward(path, term):
            if refused is not None:
                raise NotYet(refused.fault.message, refused.fault.span or path.span, refused.fault.help)
            self.refuse_nodding_on(path)
        found = self.vector_meant(path, term) if path.quantity in DIRECTED else self.scalar(path, term)
        meaning = found if isinstance(found, Meaning) else Meaning(found, kind.dimension)
        self.refuse_untold_turn(path, meaning.formula)
        laws = dict.fromkeys((*meaning.laws, *self.dynamics.tensors.behind(meaning.formula)))
        return replace(
            meaning,
            label=meaning.label or inertial_label(path) or label_of(plainly_named(path), term),
            laws=tuple(laws),
        )

    def concerned(self, owner: str) -> tuple[str, ...]:
        """The bodies whose laws tell of a body, a connection or an action."""
        joint = self.held.joint(owner)
        if joint is not None:
            return joint.body.owner, joint.carrier.owner
        acting = (ref.owner for item in self.problem.actions if item.name == owner for ref in item.touches())
        return (owner, *acting)

    # vectors

    def vector_meant(self, path: Path, term: Term) -> Formula:
        """A component of a vector along the axes that are asked for, or its size."""
        if self.stays(path, term):
            assert self.moment.onward is not None
            return SpaceReader(self.moment.onward.before, self.moments, self.problem).vector_meant(path, term)
        vector, axes = self.vector(path, term)
        asked = self.asked_axes(path, term)
        component = (path.component or "").split()[-1:] or [""]
        if component[0] not in AXES:
            return self.moment.tidy(length_of(vector))
        found = axes.to(asked, vector)
        return tidied_part(found[AXES.index(component[0])])

    def stays(self, path: Path, term: Term) -> bool:
        """Whether an angular momentum is asked that has stayed in space since the state before, or its part along the vertical."""
        onward = self.moment.onward
        asked = path.quantity == "angular_momentum" and term.about is None and term.axes in (None, "", "space")
        if not asked or path.owner not in self.bodies or onward is None:
            return False
        return onward.turns_freely(path.owner) or (path.component == "z" and onward.keeps_vertical(path.owner))

    def told_onward(self, path: Path, term: Term) -> bool:
        """Whether the time that has passed tells what is asked, however the body turns by then: what stays, or flies."""
        onward, name = self.moment.onward, path.owner
        if onward is None or name not in self.bodies or term.relative or term.axes not in (None, "", "space"):
            return False
        if path.quantity == "kinetic_energy":
            return onward.turns_freely(name) and onward.centre_velocity(name) is not None
        flown = path.quantity in ("velocity", "momentum", "speed") and path.point in (None, CM)
        return self.stays(path, term) or (flown and onward.centre_velocity(name) is not None)

    def refuse_nodding_on(self, path: Path) -> None:
        """Refuse what hangs on how a body that nods stands where the state tells nothing but its time; ω₃ and the energy stay."""
        moment, name = self.moment, path.owner
        if name not in self.bodies or path.quantity in ("axial_rate", "energy") or not moment.tells_time_alone():
            return
        if moment.nods(name) and not moment.keeps_momentum(name) and not moment.goes_on(name):
            message = f"how `{name}`, which nods, stands and turns when time has passed is not solved"
            raise NotYet(message, path.span, "`rotsolve simulate` follows it")

    def refuse_untold_turn(self, path: Path, formula: Formula) -> None:
        """Refuse what hangs on how far a body that its weight turns has gone round or spun since the first state; of others L tells it."""
        for key in map(key_of, turns_untold(formula)):
            if self.held.main(key.owner) is None or self.problem.gravity is None:
                continue
            gone = "spun about its axis" if key.kind == "spin_angle" else "gone round"
            message = f"how far `{key.owner}` has {gone} by `{key.when}` nothing tells"
            help = f"ask `in node axes`, which do not hang on that, or tell `{key.owner}.{key.kind}` in that state"
            raise NotYet(message, path.span, help)

    def asked_axes(self, path: Path, term: Term) -> Axes:
        """The axes that a question names, those of space where it names none."""
        name = path.owner if path.owner in self.bodies else self.body_of(path)
        return self.moment.named_axes(term.axes or "", name)

    def body_of(self, path: Path) -> str:
        """The body on which a connection or action acts."""
        joint = self.held.joint(path.owner)
        if joint is not None:
            return joint.body.owner
        action = next((item for item in self.problem.actions if item.name == path.owner), None)
        if action is None:
            raise NotYet(f"`{path_text(path)}` has no meaning in space")
        return action.touches()[0].owner

    def vector(self, path: Path, term: Term) -> Seen:
        """A vector, and the axes along which its components are."""
        reading = (OF_BODIES if path.owner in self.bodies else OF_ELEMENTS).get(path.quantity)
        if reading is None:
            raise NotYet(f"`{path_text(path)}` is not solved in space yet")
        if term.relative and (path.component or "").split()[:1] not in ([which] for which in INERTIAL):
            return self.relative(path, term)
        return reading(self, path, term)

    def relative(self, path: Path, term: Term) -> Seen:
        """The velocity or acceleration of a body in a frame that turns, as the state tells its motion there."""
        from rotsolve.space.frames import Relative, frame_of

        if path.quantity not in ("velocity", "acceleration") or path.point not in (None, CM):
            raise NotYet(f"`{path_text(path)} relative to` a body is not solved in space yet", path.span)
        if frame_of(self.moment, path.owner) != term.relative:
            help = f"tell `{path.owner}.position relative to {term.relative}` in the state, and its velocity there"
            raise NotYet(f"how `{path.owner}` moves in `{term.relative}` nothing tells", path.span, help)
        found = Relative(self.moment, path.owner, term.relative or "")
        return found.slip if path.quantity == "velocity" else found.faster, found.axes

    def point(self, path: Path) -> PointRef:
        """The point of a path, the centre of mass of a body that is named alone."""
        return PointRef(path.owner, path.point or CM, path.argument, span=path.span)

    def angular_velocity(self, path: Path, term: Term) -> Seen:
        own = self.moment.attitude(path.owner)
        return own.omega, own.axes

    def angular_acceleration(self, path: Path, term: Term) -> Seen:
        own = self.moment.attitude(path.owner)
        return vector_sum(own.rates, self.dynamics.carried_round(path.owner, own.omega)), own.axes

    def velocity(self, path: Path, term: Term) -> Seen:
        if path.point in (None, CM):
            return self.moment.of_mass(path.owner, "velocity")
        return self.moment.velocity(self.point(path)), self.moment.axes(path.owner)

    def acceleration(self, path: Path, term: Term) -> Seen:
        if path.point in (None, CM):
            return self.moment.of_mass(path.owner, "acceleration")
        return self.moment.acceleration(self.point(path)), self.moment.axes(path.owner)

    def momentum(self, path: Path, term: Term) -> Seen:
        velocity, axes = self.velocity(replace(path, point=None), term)
        return scaled_by(self.held.mass(path.owner), velocity), axes

    def about(self, path: Path, term: Term) -> tuple[Triple, str]:
        """The point about which a torque or an angular momentum is asked, from the reference of its body, and its name."""
        if term.about is None:
            return self.dynamics.about(path.owner)
        joint = self.held.joint(term.about.owner)
        ref = joint.body if joint is not None else term.about
        if ref.owner != path.owner:
            from rotsolve.space.places import way_to

            return way_to(self.moment, path.owner, ref), ""
        return self.moment.arm(PointRef(ref.owner, ref.point or "center", ref.argument)), ref.point or "center"

    def angular_momentum(self, path: Path, term: Term) -> Seen:
        """L = I ω about a point at rest; about the centre of mass; about another point with r × m v of the centre of mass."""
        name, own = path.owner, self.moment.attitude(path.owner)
        place, _ = self.about(path, term)
        at_rest, own_point = self.dynamics.about(name)
        if place == at_rest:
            tensor = self.dynamics.tensor(name, own_point)
            letters, _ = self.dynamics.letters_of(name, tensor, own, own_point)
            return letters, own.axes
        spin = product(self.dynamics.tensor(name, CM), own.omega)
        arm = vector_sum(self.moment.arm(PointRef(name, CM)), minus(place))
        velocity = self.moment.velocity(PointRef(name, CM))
        return vector_sum(spin, cross_product(arm, scaled_by(self.held.mass(name), velocity))), own.axes

    def torque(self, path: Path, term: Term) -> Seen:
        """The torque on a body about a point: of all forces (`net`), of its weight, of one connection or action."""
        place, _ = self.about(path, term)
        which = (path.component or "net").split()[0]
        which = "net" if which in AXES else which
        torque = NOTHING
        for push in self.dynamics.pushes.on(path.owner):
            if which in ("net", push.owner):
                torque = vector_sum(torque, push.torque(place))
        if which == "net":
            return self.rate_of_momentum(path, place), self.moment.axes(path.owner)
        return torque, self.moment.axes(path.owner)

    def rate_of_momentum(self, path: Path, place: Triple) -> Triple:
        """What all torques together come to: dL/dt about the point at rest or the centre of mass, else the sum of the torques."""
        at_rest, point = self.dynamics.about(path.owner)
        if place != at_rest:
            torque = NOTHING
            for push in self.dynamics.pushes.on(path.owner):
                torque = vector_sum(torque, push.torque(place))
            return torque
        own, tensor = self.moment.attitude(path.owner), self.dynamics.tensor(path.owner, point)
        letters, _ = self.dynamics.letters_of(path.owner, tensor, own, point)
        return vector_sum(product(tensor, own.rates), self.dynamics.carried_round(path.owner, letters))

    def force(self, path: Path, term: Term) -> Seen:
        """The force on a body: of all (`net`: m a), its weight, of one connection or action; in a frame that turns its inertial ones."""
        which = (path.component or "net").split()[0]
        which = "net" if which in AXES else which
        axes = self.moment.axes(path.owner)
        if which in INERTIAL:
            from rotsolve.space.frames import frame_of, inertial_force

            return inertial_force(self.moment, path, term.relative or frame_of(self.moment, path.owner), which)
        if which == "net":
            acceleration, _ = self.acceleration(replace(path, point=None), term)
            return scaled_by(self.held.mass(path.owner), acceleration), axes
        return self.forces_of(path.owner, which), axes

    def own_axis(self, path: Path, term: Term) -> Seen:
        """The direction of one of a body's own axes, along these."""
        return AS_DRAWN[AXES.index(path.quantity[0])], self.moment.own_axes(path.owner)

    def rotation_axis(self, path: Path, term: Term) -> Seen:
        """The axis of the rotation that all turns of a body come to: n ∝ the part of R that changes sign when it is transposed."""
        from rotsolve.space.rotations import axis_of

        return axis_of(self.moment.own_axes(path.owner).standing, path, self.held.vanishes), IN_SPACE

    def principal_axis(self, path: Path, term: Term) -> Seen:
        from rotsolve.space.principal import lone_axis

        tensor = self.tensor_about(path, term)
        return lone_axis(tensor, self.dynamics.tensors.spelled, path, self.held.vanishes), self.moment.own_axes(
            path.owner
        )

    # of connections and actions

    def joint_force(self, path: Path, term: Term) -> Seen:
        """The force of a connection on the body that it holds, or of one of its bearings."""
        name = self.body_of(path)
        self.refuse_shared(name, path, term)
        pushes = [push for push in self.dynamics.pushes.on(name) if push.owner == path.owner and push.force != NOTHING]
        if path.point is not None:
            pushes = [push for number, push in enumerate(pushes, 1) if path.point == f"bearing{number}"]
        if len(pushes) == 1:
            return pushes[0].force, pushes[0].axes
        return self.forces_of(name, path.owner), self.moment.axes(name)

    def refuse_shared(self, name: str, path: Path, term: Term) -> None:
        """Refuse the part of a force along the line through two balls, of which the laws tell only the sum for both."""
        main = self.held.main(name)
        supports = self.held.supports(name)
        if len(supports) < 2 or main is None or path.owner not in [joint.owner for joint in supports]:
            return
        component = (path.component or "").split()[-1:] or [""]
        line = self.moment.axes(name).to(self.asked_axes(path, term), self.moment.direction(name, main))
        if component[0] not in AXES or not self.held.vanishes(line[AXES.index(component[0])]):
            both = " and ".join(f"`{joint.owner}`" for joint in supports)
            message = f"`{path_text(path)}` is statically indeterminate: along the line through {both} only the sum of their forces is told"
            raise NotYet(message, path.span, "ask for a component across that line, `in body axes` where it turns")

    def joint_impulse(self, path: Path, term: Term) -> Seen:
        """The impulse of a joint on the body that it holds, or of a blow itself, in the event that leads to this moment."""
        before = self.moment.before
        joint = self.held.joint(path.owner)
        if before is None:
            raise NotYet(f"`{path_text(path)}` is that of a blow: ask for it at the state after one", path.span)
        if joint is None:
            raise NotYet(f"`{path_text(path)}` is not solved in space yet", path.span)
        return joint_shock(joint, self.moments[before.when]).push, before.axes(joint.body.owner)

    def forces_of(self, name: str, owner: str) -> Triple:
        """What one connection, action or gravity pushes a body with, in the axes of the body."""
        axes, force = self.moment.axes(name), NOTHING
        for push in self.dynamics.pushes.on(name):
            force = vector_sum(force, push.along(axes) if push.owner == owner else NOTHING)
        return force

    def joint_torque(self, path: Path, term: Term) -> Seen:
        """The torque of a connection or action about the point held, or about another one."""
        name = self.body_of(path)
        place, _ = self.about(replace(path, owner=name), term)
        torque = NOTHING
        for push in self.dynamics.pushes.on(name):
            torque = vector_sum(torque, push.torque(place) if push.owner == path.owner else NOTHING)
        return torque, self.moment.axes(name)

    # angles between vectors

    def between(self, term: Term, other: Term) -> Meaning:
        """tan = |a × b|/(a · b) of vectors in one plane of the axes, cos = a · b/(|a| |b|) of others."""
        one, axes = self.vector(term.path, term)
        two, others = self.vector(other.path, other)
        two = others.to(axes, two)
        if sum(part != ZERO for part in cross_product(one, two)) > 1:
            cosine = simplify(dot_product(one, two) / sqrt(multiply(square_of(one), square_of(two))))
            return Meaning(Call("acos", (cosine,)), ANGLE, label="angle between two vectors, cos = a · b/(|a| |b|)")
        words = "angle between two vectors, tan = |a × b|/(a · b)"
        return Meaning(call("atan2", length_of(cross_product(one, two)), dot_product(one, two)), ANGLE, label=words)

    # scalars

    def scalar(self, path: Path, term: Term) -> Formula | Meaning:
        """A quantity without a direction."""
        if path.quantity in NODAL:
            return self.of_nodding(path)
        reading = SCALARS.get(path.quantity)
        if reading is None or (path.owner and path.owner not in self.bodies and path.quantity != "freedoms"):
            raise NotYet(f"`{path_text(path)}` is not solved in space yet")
        return reading(self, path, term)

    def of_nodding(self, path: Path) -> Formula | Meaning:
        """An Euler angle or its rate; of a free symmetric body the rates about its angular momentum."""
        moment = self.moment
        spin = moment.axle_spin(path.owner) if path.quantity == "spin" else None
        if spin is not None:
            return spin
        if moment.nods(path.owner) and moment.keeps_momentum(path.owner):
            from rotsolve.space.free import in_euler_angles_of

            return in_euler_angles_of(moment, path)
        if not moment.nods(path.owner):
            from rotsolve.space.free import about_own_momentum

            return about_own_momentum(self.dynamics, path)
        if path.quantity == "axial_rate" and moment.told(path.owner, "axial_rate") is None:
            return Meaning(
                moment.attitude(path.owner).omega[2], QUANTITIES["axial_rate"].dimension, label="ω₃ = ψ̇ + φ̇ cos θ"
            )
        return moment.ask(path.quantity, path.owner)

    def kinetic_energy(self, path: Path, term: Term) -> Meaning:
        """½ Σ I_ij ω_i ω_j about a point at rest; else about the centre of mass, and ½ M v²."""
        names = [path.owner] if path.owner else list(self.held.order)
        terms: list[Formula] = []
        for name in names:
            turning, travelling = kinetic_energies(self.dynamics, name, path.component or "")
            terms += [turning, travelling]
        formula: Formula = ZERO
        for term_ in terms:
            formula = add(formula, term_)
        return Meaning(
            formula,
            QUANTITIES["kinetic_energy"].dimension,
            label="kinetic energy, ½ ω · I ω + ½ M v²",
            law=KINETIC_ENERGY,
        )

    def energy(self, path: Path, term: Term) -> Meaning:
        """K + M g h, h from the point about which the body turns."""
        gravity = self.problem.gravity
        result = self.kinetic_energy(path, term).formula
        for name in [path.owner] if path.owner else list(self.held.order):
            if gravity is not None:
                result = add(
                    result, multiply(multiply(self.held.mass(name), gravity), height_above(self.dynamics, name))
                )
        return Meaning(result, QUANTITIES["energy"].dimension, label="energy, ½ ω · I ω + M g h")

    def tensor_about(self, path: Path, term: Term) -> InertiaTensor:
        """The tensor of a body about the point that is asked, in its own axes."""
        ref = term.about
        point = PointRef(path.owner, CM) if ref is None else PointRef(path.owner, ref.point or "center", ref.argument)
        joint = None if ref is None else self.held.joint(ref.owner)
        point = point if joint is None else joint.body
        if point.owner != path.owner or (ref is not None and joint is None and ref.owner != path.owner):
            raise NotYet(f"`{path.quantity}` of `{path.owner}` is told about its own points", path.span)
        return self.dynamics.own_tensor(point)

    def inertia(self, path: Path, term: Term) -> Meaning:
        """nᵀ I n about a direction, in the body's own axes; about its axis where none is named."""
        tensor = self.tensor_about(path, term)
        along = term.along if isinstance(term.along, tuple) else self.held.axis(path.owner)
        if along is None:
            joint = self.held.main(path.owner)
            along = joint.turning[0] if joint is not None and joint.turning else None
        if along is None:
            raise NotYet(
                f"about which axis is the moment of inertia of `{path.owner}` asked?", help="say `along [x, y, z]`"
            )
        x, y, z = along
        direction = unit_along((x, y, z), self.moment.positive)
        formula, steps = moment_along(tensor, direction), tuple(self.dynamics.tensors.steps)
        words = "moment of inertia about an axis, Σ nᵢ nⱼ Iᵢⱼ"
        return Meaning(formula, QUANTITIES["inertia"].dimension, label=words, laws=steps)

    def inertia_tensor(self, path: Path, term: Term) -> Meaning:
        """An entry along the body's own axes, or those that are asked for: R I Rᵀ."""
        tensor = self.tensor_about(path, term)
        if term.axes == "space":
            tensor = in_axes(tensor, self.moment.own_axes(path.owner).standing, None, None)
        entry = (path.component or "zz").split()[-1]
        words = "inertia tensor, R I Rᵀ" if term.axes == "space" else "inertia tensor"
        steps = tuple(self.dynamics.tensors.steps)
        return Meaning(
            tidied_part(tensor.entry(entry)),
            QUANTITIES["inertia_tensor"].dimension,
            label=f"{words}, {entry}",
            laws=steps,
        )

    def principal_moments(self, path: Path, term: Term) -> Meaning:
        from rotsolve.space.principal import principal_moment

        tensor, number = self.tensor_about(path, term), (path.component or "1").split()[-1]
        spelled, signs = self.dynamics.tensors.spelled, self.moment.signs

        def side(gap: Formula) -> int | None:
            sign = signs.decide(gap)
            return signs.whatever_way(gap) if sign is None else sign

        found = principal_moment(tensor, spelled, number, path, self.held.vanishes, side)
        steps = tuple(self.dynamics.tensors.steps)
        return Meaning(found, QUANTITIES["inertia"].dimension, label="principal moment of inertia", laws=steps)

    def rotation_angle(self, path: Path, term: Term) -> Meaning:
        """cos = (trace R − 1)/2."""
        rows = self.moment.own_axes(path.owner).standing
        trace = add(add(rows[0][0], rows[1][1]), rows[2][2])
        return Meaning(
            Call("acos", (simplify((trace - ONE) / 2),)),
            ANGLE,
            label="angle of the whole rotation, 1 + 2 cos = trace R",
        )

    def angle(self, path: Path, term: Term) -> Formula:
        """How far a body is turned about its hinge."""
        found = self.moment.stood(path.owner, "angle") if self.moment.hangs_on_hinge(path.owner) else None
        if found is None:
            raise NotYet(f"`{path_text(path)}` is not told at `{self.moment.when}`", path.span)
        return found

    def freedoms(self, path: Path, term: Term) -> Formula:
        from rotsolve.space.freedoms import freedoms_of

        return freedoms_of(self.held, path)

    def stability(self, path: Path, term: Term) -> Meaning:
        from rotsolve.space.stability import growth

        return growth(self.dynamics, path)

    def centre_of_mass(self, path: Path, term: Term) -> Meaning:
        """A component of Σ m r/Σ m in the body's own axes, from the centre of its shape or from another of its points."""
        place = self.held.centre(path.owner)
        if term.about is not None:
            if term.about.owner != path.owner:
                raise NotYet(f"the centre of mass of `{path.owner}` is told from its own points", path.span)
            place = way_between(self.held.spot(term.about), place)
        axis = (path.component or "").split()[-1:] or [""]
        if axis[0] not in AXES:
            raise NotYet(f"`{path_text(path)}` is a place", path.span, "ask for `cm`, or for `cm.x`, `cm.y`, `cm.z`")
        found = tidied_part(place[AXES.index(axis[0])])
        return Meaning(found, QUANTITIES["cm"].dimension, label="centre of mass, Σ m r/Σ m")

    def mass(self, path: Path, term: Term) -> Formula:
        return self.held.mass(path.owner)

    def speed(self, path: Path, term: Term) -> Formula:
        return tidied_part(length_of(self.velocity(path, term)[0]))

    def period(self, path: Path, term: Term) -> Meaning:
        from rotsolve.space.free import period_of_turning

        return period_of_turning(self.dynamics, path)


def tidied_part(value: Formula) -> Formula:
    """A component with what cancels left out, where it is a sum."""
    return simplify(value) if isinstance(value, Sum) or not has_quantities(value) else value


def plainly_named(path: Path) -> Path:
    """A path with a component that a label can name."""
    component = (path.component or "").split()[0] if path.component else None
    return replace(path, component=component)


def inertial_label(path: Path) -> str:
    """What an inertial force is called, "Coriolis force on bead, −2 m Ω × v"; nothing for other paths."""
    told = INERTIAL_NAMES.get((path.component or "").split()[0] if path.component else "", "")
    return told.format(body=spoken(path.owner))


OF_BODIES: dict[str, Callable[[SpaceReader, Path, Term], Seen]] = {
    "angular_velocity": SpaceReader.angular_velocity,
    "angular_acceleration": SpaceReader.angular_acceleration,
    "velocity": SpaceReader.velocity,
    "acceleration": SpaceReader.acceleration,
    "momentum": SpaceReader.momentum,
    "angular_momentum": SpaceReader.angular_momentum,
    "torque": SpaceReader.torque,
    "force": SpaceReader.force,
    "x_axis": SpaceReader.own_axis,
    "y_axis": SpaceReader.own_axis,
    "z_axis": SpaceReader.own_axis,
    "rotation_axis": SpaceReader.rotation_axis,
    "principal_axis": SpaceReader.principal_axis,
}
OF_ELEMENTS: dict[str, Callable[[SpaceReader, Path, Term], Seen]] = {
    "force": SpaceReader.joint_force,
    "torque": SpaceReader.joint_torque,
    "impulse": SpaceReader.joint_impulse,
}
SCALARS: dict[str, Callable[[SpaceReader, Path, Term], Formula | Meaning]] = {
    "kinetic_energy": SpaceReader.kinetic_energy,
    "energy": SpaceReader.energy,
    "inertia": SpaceReader.inertia,
    "inertia_tensor": SpaceReader.inertia_tensor,
    "principal_moments": SpaceReader.principal_moments,
    "rotation_angle": SpaceReader.rotation_angle,
    "angle": SpaceReader.angle,
    "freedoms": SpaceReader.freedoms,
    "stability": SpaceReader.stability,
    "mass": SpaceReader.mass,
    "cm": SpaceReader.centre_of_mass,
    "speed": SpaceReader.speed,
    "period": SpaceReader.period,
}
