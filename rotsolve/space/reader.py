"""Reader in space: what a path of a question stands for at a moment; vectors by components, along the axes that the question names."""

from __future__ import annotations

from collections.abc import Callable

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, add, call, multiply, negate, sqrt, total
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.core.derivation import Words
from rotsolve.core.equation import KINETIC_ENERGY, VANISHING
from rotsolve.core.quantity import DIRECTED, EITHER_WAY, QUANTITIES
from rotsolve.core.symbols import key_of
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    cross_product,
    dot_product,
    length_of,
    square_of,
    unit_along,
    way_between,
)
from rotsolve.core.writing import spoken
from rotsolve.language.grammar import ANGLE_OF
from rotsolve.language.problem import Path, Term
from rotsolve.paths.meaning import Meaning, NotYet, label_of, path_text
from rotsolve.space.arrangement import NODAL
from rotsolve.space.attitude import IN_SPACE, STANDING_HELP
from rotsolve.space.energies import energy_in_words, height_above, kinetic_energies, power_of
from rotsolve.space.inertia import CM, in_axes, moment_along
from rotsolve.space.telling import turns_untold
from rotsolve.space.understood import refuse_dropped
from rotsolve.space.untold import ANGLE_HELP, law_whatever_the_angle, untold_in, whatever_the_angle
from rotsolve.space.vector_reader import VectorReader, tidied_part

PRINCIPAL_AXIS = ", (I − λ 1) e = 0, |e| = 1"
INERTIAL_NAMES = {
    "centrifugal": "centrifugal force on {body}, −m Ω × (Ω × r)",
    "euler": "Euler force on {body}, −m (dΩ/dt) × r",
    "coriolis": "Coriolis force on {body}, −2 m Ω × v",
}
AT_REST = (
    "inertia",
    "inertia_tensor",
    "principal_moments",
    "principal_axis",
    "freedoms",
    "mass",
    "cm",
    "gyration",
)  # asked of what need not move

OF_OPEN_CHAINS = ("freedoms", "stability", "period")  # which are not told of closed linkages


class SpaceReader(VectorReader):
    """Reads paths at one moment."""

    def meaning(self, path: Path, term: Term | None = None) -> Meaning:
        """What a path stands for; raises `NotYet` for what has no meaning here."""
        term = term or Term(path)
        refuse_dropped(path, term)
        if self.held.closing is not None and path.quantity in OF_OPEN_CHAINS:
            from rotsolve.space.links import beyond_one_moment

            raise beyond_one_moment(self.held, "can move" if path.quantity == "freedoms" else "goes on")
        if term.modifier == ANGLE_OF and term.other is not None:
            return self.whatever_angle(path, self.between(term, term.other))
        kind = QUANTITIES[path.quantity]
        unwritten = self.dynamics.unwritten
        refused = next((unwritten[owner] for owner in self.concerned(path.owner) if owner in unwritten), None)
        if path.quantity not in AT_REST and not self.told_onward(path, term):
            if refused is not None:
                raise NotYet(refused.fault.message, refused.fault.span or path.span, refused.fault.help)
            self.refuse_nodding_on(path)
        found = self.vector_meant(path, term) if path.quantity in DIRECTED else self.scalar(path, term)
        meaning = self.whatever_angle(path, found if isinstance(found, Meaning) else Meaning(found, kind.dimension))
        self.refuse_untold_turn(path, meaning.formula)
        told = meaning.label or inertial_label(path)
        known_by = PRINCIPAL_AXIS if path.quantity == "principal_axis" else self.by_arm(path, term)
        laws = dict.fromkeys((*meaning.laws, *self.dynamics.tensors.behind(meaning.formula)))
        return replace(
            meaning,
            formula=self.held.signs.unbarred(meaning.formula),
            label=told or f"{label_of(plainly_named(path), term)}{known_by}",
            plain=not (told or known_by),
            laws=tuple(laws),
            said=meaning.said or (self.axis_ground(path, term) if known_by == PRINCIPAL_AXIS else ()),
        )

    def by_arm(self, path: Path, term: Term) -> str:
        """What the angular momentum of a particle about a point is, or the torque on it."""
        if term.about is None or path.owner not in self.bodies or not self.held.pointlike(path.owner):
            return ""
        return {"angular_momentum": ", r × m v", "torque": ", r × F"}.get(path.quantity, "")

    def concerned(self, owner: str) -> tuple[str, ...]:
        """The bodies whose laws tell of a body, a connection or an action."""
        joint = self.held.joint(owner)
        if joint is not None:
            return joint.body.owner, joint.carrier.owner
        tied = [item for item in self.held.couplings if item.owner == owner]
        if tied:
            return tied[0].first.owner, tied[0].second.owner
        acting = (ref.owner for item in self.problem.actions if item.name == owner for ref in item.touches())
        return (owner, *acting)

    # vectors

    def vector_meant(self, path: Path, term: Term) -> Formula | Meaning:
        """A component of a vector along the axes that are asked for, or its size."""
        if self.stays(path, term):
            assert self.moment.onward is not None
            return SpaceReader(self.moment.onward.before, self.moments, self.problem).vector_meant(path, term)
        vector, axes = self.vector(path, term)
        asked = self.asked_axes(path, term)
        component = (path.component or "").split()[-1:] or [""]
        if component[0] not in AXES:
            return self.shared_size(path, term) or self.moment.tidy(length_of(vector))
        if axes.lost and asked == IN_SPACE and vector != NOTHING:
            raise NotYet(axes.lost, path.span, f"ask for it `in body axes`, or {STANDING_HELP}")
        found = axes.to(asked, vector)
        if self.by_arm(path, term) and all(tidied_part(part) == ZERO for part in found):
            return Meaning(ZERO, QUANTITIES[path.quantity].dimension, law=VANISHING)
        return tidied_part(found[AXES.index(component[0])])

    def shared_size(self, path: Path, term: Term) -> Meaning | None:
        """The size of an angular momentum as a letter, where the scene asks for what is told by it as well; None of others."""
        from rotsolve.space.free import BY_SIZE, size_as_letter

        asked = (item.path for find in self.problem.finds for item in find.terms)
        shared = any(item.owner == path.owner and item.quantity in BY_SIZE for item in asked)
        name, moment = path.owner, self.moment
        if path.quantity != "angular_momentum" or term.about is not None or not shared or self.held.of_body(name):
            return None
        if moment.nods(name) or path.point is not None:
            return None
        momentum, _ = self.angular_momentum(path, term)
        size, laws = size_as_letter(self.dynamics, name, momentum)
        return Meaning(size, QUANTITIES[path.quantity].dimension, laws=laws) if laws else None

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
            message = f"how `{name}`, which leans, stands and turns when time has passed is not solved"
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

    def whatever_angle(self, path: Path, meaning: Meaning) -> Meaning:
        """What does not hang on how far bodies are turned about their hinges where nothing tells that; refused by name what does."""
        formula, laws = whatever_the_angle(meaning.formula), tuple(map(law_whatever_the_angle, meaning.laws))
        if formula is not None and None not in laws:
            return replace(meaning, formula=formula, laws=tuple(law for law in laws if law is not None))
        sides = (part for law in meaning.laws for part in (law.left, law.right))
        key = key_of(untold_in(total([meaning.formula, *sides]))[0])
        message = self.moments[key.when].moment.lost(key.owner, f"`{path_text(path)}`")
        seen = f"ask for it `in {key.owner} axes`, or " if path.quantity in DIRECTED else ""
        hinged = self.held.main(key.owner) is not None
        raise NotYet(message, path.span, f"{seen}{ANGLE_HELP.format(key.owner) if hinged else STANDING_HELP}")

    def between(self, term: Term, other: Term) -> Meaning:
        """tan = |a × b|/(a · b) of vectors in one plane of the axes, cos = a · b/(|a| |b|) of others.

        Of vectors at two states their components along the axes that are named are compared, those of space where none are.
        """
        one, axes = self.vector(term.path, term)
        if other.at in (None, term.at):
            two, others = self.vector(other.path, other)
            two = others.to(axes, two)
        else:
            there = SpaceReader(self.moments[other.at], self.moments, self.problem)
            two, others = there.vector(other.path, other)
            one = axes.to(self.asked_axes(term.path, term), one)
            two = others.to(there.asked_axes(other.path, other), two)
        if NOTHING in (one, two):
            lost = path_text((term if one == NOTHING else other).path)
            raise NotYet(f"`{lost}` is nothing, so that it is at no angle from anything", term.path.span)
        along = dot_product(one, two)
        if {term.path.quantity, other.path.quantity}.intersection(EITHER_WAY):
            side = self.side(along)
            along = call("abs", along) if side is None else negate(along) if side < 0 else along
        if sum(part != ZERO for part in cross_product(one, two)) > 1:
            cosine = simplify(along / sqrt(multiply(square_of(one), square_of(two))))
            return Meaning(Call("acos", (cosine,)), ANGLE, label="angle between two vectors, cos = a · b/(|a| |b|)")
        words = "angle between two vectors, tan = |a × b|/(a · b)"
        return Meaning(call("atan2", length_of(cross_product(one, two)), along), ANGLE, label=words)

    # scalars

    def scalar(self, path: Path, term: Term) -> Formula | Meaning:
        """A quantity without a direction."""
        if path.quantity in NODAL:
            return self.of_nodding(path)
        reading = SCALARS.get(path.quantity)
        of_elements = path.quantity in ("freedoms", "power")
        if reading is None or (path.owner and path.owner not in self.bodies and not of_elements):
            raise NotYet(f"`{path_text(path)}` is not solved in space yet", help=self.of_body_instead(path, SCALARS))
        if not path.owner and path.quantity not in OF_SCENE:
            raise NotYet(f"`{path_text(path)}` of all bodies together is not solved in space", path.span, "name a body")
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
        turning, travelling = self.turning_and_travelling(path)
        return Meaning(
            add(turning, travelling),
            QUANTITIES["kinetic_energy"].dimension,
            label=f"kinetic energy{energy_in_words(self.dynamics, path.owner, (turning, travelling))}",
            law=KINETIC_ENERGY,
        )

    def turning_and_travelling(self, path: Path) -> tuple[Formula, Formula]:
        """The energy of rotation and that of travel, of a body or of all."""
        names = [path.owner] if path.owner else list(self.held.order)
        parts = [kinetic_energies(self.dynamics, name, path.component or "") for name in names]
        return total([turning for turning, _ in parts]), total([travelling for _, travelling in parts])

    def energy(self, path: Path, term: Term) -> Meaning:
        """K + M g h, h from the point about which the body turns."""
        terms, height = self.turning_and_travelling(path), self.potential_energy(path, term).formula
        words = energy_in_words(self.dynamics, path.owner, terms, height)
        return Meaning(add(add(*terms), height), QUANTITIES["energy"].dimension, label=f"energy{words}")

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

    def gyration(self, path: Path, term: Term) -> Meaning:
        """√(I/M) about an axis."""
        inertia = self.inertia(path, term)
        formula = sqrt(inertia.formula / self.held.mass(path.owner))
        return replace(
            inertia, formula=formula, dimension=QUANTITIES["gyration"].dimension, label="radius of gyration, √(I/M)"
        )

    def potential_energy(self, path: Path, term: Term) -> Meaning:
        """M g h, h from the point about which the body turns."""
        gravity = self.problem.gravity
        formula: Formula = ZERO
        for name in [path.owner] if path.owner else list(self.held.order):
            if gravity is not None:
                weight = multiply(self.held.mass(name), gravity)
                formula = add(formula, multiply(weight, height_above(self.dynamics, name)))
        return Meaning(formula, QUANTITIES["potential_energy"].dimension, label="potential energy, M g h")

    def power(self, path: Path, term: Term) -> Formula:
        """Of all that acts on a body (`net`), of its weight, of a connection or an action."""
        name = self.body_of(path) if path.owner not in self.bodies else path.owner
        which = (path.component or "net") if path.owner in self.bodies else path.owner
        own = [push for push in self.dynamics.pushes.on(name) if which in ("net", push.owner)]
        return self.moment.tidy(total([power_of(push, self.moment) for push in own]))

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
        from rotsolve.space.principal_factors import in_factors
        from rotsolve.space.principal_letters import PRINCIPAL

        told, number = self.of_roots(path, term), int((path.component or "1").split()[-1])
        found = principal_moment(told, number, path)
        return Meaning(found, QUANTITIES["inertia"].dimension, label=PRINCIPAL, said=in_factors(told))

    def axis_ground(self, path: Path, term: Term) -> Words:
        """Of which principal moment the axis is asked."""
        moment, _ = self.principal_pair(path, term)
        numbered = (path.component or "").split(" ")[0].isdecimal()
        return "λ = ", moment, "" if numbered else ", which stands alone"

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
            what, when = path_text(path), self.moment.when
            told = f"tell a letter there, `{what}: q` with `q: unknown`, and what holds there, and ask for `q`"
            help = told if self.moment.state.time_told is None else "`rotsolve simulate` follows it"
            raise NotYet(f"`{what}` is not told at `{when}`", path.span, help)
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
        return total([self.held.mass(name) for name in ([path.owner] if path.owner else self.held.order)])

    def speed(self, path: Path, term: Term) -> Formula:
        return tidied_part(length_of(self.vector(replace(path, quantity="velocity"), term)[0]))

    def period(self, path: Path, term: Term) -> Meaning:
        from rotsolve.space.free import period_of_turning

        return period_of_turning(self.dynamics, path)


def plainly_named(path: Path) -> Path:
    """A path with a component that a label can name."""
    component = (path.component or "").split()[0] if path.component else None
    return replace(path, component=component)


def inertial_label(path: Path) -> str:
    """What an inertial force is called, "Coriolis force on bead, −2 m Ω × v"; nothing for other paths."""
    told = INERTIAL_NAMES.get((path.component or "").split()[0] if path.component else "", "")
    return told.format(body=spoken(path.owner))


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
    "gyration": SpaceReader.gyration,
    "potential_energy": SpaceReader.potential_energy,
    "power": SpaceReader.power,
}

OF_SCENE = frozenset(
    {"kinetic_energy", "potential_energy", "energy", "mass", "freedoms"}
)  # asked without a body: of all
