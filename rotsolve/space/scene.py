"""Scene in space: its moments, and all that the laws write about them, as the search and the derivation see them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cached_property, reduce
from itertools import chain
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import (
    PI,
    ZERO,
    Call,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Symbol,
    add,
    call,
    multiply,
    negate,
)
from rotsolve.algebra.units.dimension import ANGULAR_MOMENTUM, Dimension, product_rank
from rotsolve.core.derivation import Words, in_a_row
from rotsolve.core.equation import LAGRANGE_EQUATION, RATES_OF_MOMENTUM, Equation, Law
from rotsolve.core.facts import Facts
from rotsolve.core.faults import Fault, Unsolvable
from rotsolve.core.quantity import DIRECTED, QUANTITIES
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import GENERIC, is_key, key_of, of_kinds, paths_in
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import AXES, NOTHING, Triple, length_of, triple
from rotsolve.core.writing import spoken, with_powers
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Condition, Path, State, Term
from rotsolve.motion.timeline import OPEN, Interval
from rotsolve.paths.meaning import Meaning, NotYet, Unclear
from rotsolve.space.arrangement import NODAL, JointedBodies
from rotsolve.space.attitude import STANDING_HELP
from rotsolve.space.euler_rules import axial_rules, turning_rules
from rotsolve.space.inertia import Tensors
from rotsolve.space.lasting import refuse_left
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.lines import told_of_forces, told_unread
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.pushes import Pushes
from rotsolve.space.told_once import refuse_told_twice
from rotsolve.space.understood import refuse_dropped_told
from rotsolve.space.untold import ANGLE_HELP, law_whatever_the_angle, untold_in

if TYPE_CHECKING:
    from rotsolve.equations.swing import Swing
    from rotsolve.space.reader import SpaceReader

SIZE_OF_CHANGE = "size of change of"
CHANGES = ("change of", "lost")
PUSHING = ("force", "torque")
ROTATING = (*RATES_OF_MOMENTUM, LAGRANGE_EQUATION)  # what tells a steady precession


class SpaceEquations(SceneEquations, dict=True):
    """One reading of a scene in space."""

    def __post_init__(self) -> None:
        """Nothing is fixed beforehand: each moment puts in what its state tells."""

    @cached_property
    def hanging(self) -> list[Equation]:
        """The laws that hang on an angle that nothing tells, which are left out."""
        return []

    @cached_property
    def held(self) -> JointedBodies:
        return JointedBodies(self.configuration.problem, self.configuration.signs)

    @cached_property
    def tensors(self) -> Tensors:
        """The inertia tensors of all bodies, which do not change."""
        problem, first = self.configuration.problem, self.configuration.timeline.states[0].name
        return Tensors(self.held, self.registry, problem.givens, self.configuration.positive, first, {})

    @cached_property
    def dynamics(self) -> Mapping[str, SpaceLaws]:
        """What the laws speak of at each state."""
        found: dict[str, SpaceLaws] = {}
        timeline = self.configuration.timeline
        for state in timeline.states:
            if state.name == OPEN:
                continue
            found[state.name] = self.laws_at(state, state.name)
            moment, before = found[state.name].moment, timeline.before(state.name)
            moment.first = state is timeline.states[0]
            if before is not None:
                moment.come_after(found[before.start].moment, "" if before.event is None else before.event.name)
                self.lead_on(before, found[before.start], moment)
                if before.event is None:
                    moment.lines = self.lines_after(found[before.start])
        return found

    @cached_property
    def running(self) -> Mapping[str, SpaceLaws]:
        """What the laws speak of at any time of each phase, by its name, where functions of time are asked for."""
        found: dict[str, SpaceLaws] = {}
        phases = (item for item in self.configuration.timeline.intervals if item.event is None)
        for interval in phases if self.configuration.mentions.functions else ():
            laws = found[interval.name] = self.laws_at(State(interval.name), interval.start)
            laws.moment.at, laws.moment.first, laws.moment.later = f"{GENERIC}{interval.start}", False, True
            laws.moment.met = self.dynamics[interval.start].moment.met
            self.lead_on(interval, self.dynamics[interval.start], laws.moment)
        return found

    @cached_property
    def swings(self) -> dict[str, Swing]:
        """None that the laws are written for: those of a steady motion are told by its effective potential."""
        return {}

    def lines_after(self, laws: SpaceLaws) -> dict[str, Triple]:
        """About which own directions bodies turn on that nothing holds and that carry others."""
        held = laws.moment.held
        if all(joint.carrier.owner not in held.bodies for joint in held.joints):
            return {}
        from rotsolve.space.together import lines_of_turning

        return lines_of_turning(laws)

    def laws_at(self, state: State, since: str) -> SpaceLaws:
        """What the laws speak of at one moment, with the joints that there are since a state."""
        problem = self.configuration.problem
        moment = SpaceMoment(self.held.since(since), self.registry, state, self.configuration)
        pushes = Pushes(moment, problem.gravity, problem.actions)
        altered = self.configuration.alteration
        written = SpaceLaws if altered is None or altered.in_space is None else altered.in_space
        return written(moment, pushes, self.tensors, fast="fast spin" in problem.assume)

    def lead_on(self, interval: Interval, before: SpaceLaws, later: SpaceMoment) -> None:
        """Let the moment before a phase tell what happens up to a later one, where times are told."""
        if self.timed and interval.event is None:
            from rotsolve.space.lapse import Lapse

            later.onward = Lapse(before, later)

    @cached_property
    def timed(self) -> bool:
        """Whether a later state tells its time, or functions of time are asked for."""
        lines = (line.path for state in self.configuration.problem.states[1:] for line in state.conditions)
        return self.configuration.mentions.functions or any(
            path is not None and (path.owner, path.quantity) == ("", "time") for path in lines
        )

    def reader(self, state: str, *, generic: bool = False) -> SpaceReader:  # type: ignore[override]
        from rotsolve.space.reader import SpaceReader

        return SpaceReader(self.dynamics[state], self.dynamics, self.configuration.problem)

    def facts(self, state: str, *, generic: bool = False, virtual: bool = False) -> Facts:
        """No planar facts, since its laws are written from its own geometry; what surfaces have to obey."""
        laws = self.dynamics.get(state)
        needs = () if laws is None else tuple(laws.pushes.needs())
        return Facts(state, state, (), (), needs, ())

    def settled_first(self) -> Iterator[str]:
        """The rates of steady precessions, of which a scene says whether the smaller or the larger one is meant, and largest and smallest
        tilts."""
        for laws in self.dynamics.values():
            moment = laws.moment
            tilts = (moment.nodding(name).angles[1] for name in self.held.order if moment.extreme_tilt(name))
            yield from (tilt.name for tilt in tilts if isinstance(tilt, Symbol) and is_key(tilt.name))
            for name in self.held.order if moment.state.steady else ():
                rate = moment.ask("precession", name) if moment.nods(name) else ZERO
                if isinstance(rate, Symbol):
                    self.refuse_unspun(name, laws)
                    yield rate.name

    def refuse_unspun(self, name: str, laws: SpaceLaws) -> None:
        """Refuse a steady precession of what is level and does not spin, where numbers or the scene say so."""
        if laws.moment.nodding(name).angles[1] == PI / 2:
            from rotsolve.space.roots import refuse_level_unspun

            refuse_level_unspun(name, laws, self.configuration.problem)

    def diagram_words(self, state: str) -> Iterator[Words]:
        """What acts on each body: forces with their places, couples, by components."""
        laws = self.dynamics.get(state)
        for name in self.held.order if laws is not None else ():
            assert laws is not None
            try:
                acting = tuple(laws.pushes.on(name))
            except Unsolvable:  # what holds it is asked for its freedoms alone
                continue
            for force in acting:
                words: list[str | Formula] = [f"{spoken(name)}, {spoken(force.owner)}: "]
                if force.force != NOTHING:
                    words += [
                        "force (",
                        *in_a_row(force.force),
                        ") in ",
                        force.axes.name,
                        " axes at (",
                        *in_a_row(force.arm),
                        ")",
                    ]
                if force.couple != NOTHING:
                    words += [
                        " and " * (len(words) > 1),
                        "couple (",
                        *in_a_row(force.couple),
                        ") in ",
                        force.axes.name,
                        " axes",
                    ]
                yield tuple(words)

    def small_beside(self) -> Iterator[tuple[Formula, Formula]]:
        """The precession of a fast top beside its spin, as it is told, else beside ω₃."""
        for laws in self.dynamics.values() if "fast spin" in self.configuration.problem.assume else ():
            for name in (name for name in self.held.order if laws.moment.nods(name) and laws.goes_round_fast(name)):
                spins = (laws.moment.told(name, word) for word in ("spin", "axial_rate"))
                spin = next((spin for spin in spins if spin is not None), None)
                yield laws.moment.nodding(name).rates[0], spin or laws.moment.ask("axial_rate", name)

    def idle_assumptions(self, used: Collection[Equation]) -> Iterator[str]:
        """The assumptions that leave nothing out: `fast spin` where no law of a body that precesses is used, nor its nutation."""
        if "fast spin" not in self.configuration.problem.assume:
            return
        moments = {laws.moment.when: laws.moment for laws in self.dynamics.values()}
        turning = (law for law in used if law.law in ROTATING and law.section in moments)
        precessing = any(moments[law.section].nods(name) for law in turning for name in law.bodies)
        if not precessing and not any(laws.fast_nutation for laws in self.dynamics.values()):
            yield "fast spin"

    def unwritten_law(self) -> Fault | None:
        """Why the laws of a body could not be written, at the first state at which they were not; or on what angle one hangs."""
        parts = (part for laws in self.dynamics.values() for part in (laws.unwritten, laws.untravelled))
        found = next((error.fault for part in parts for error in part.values()), None)
        lasting = (law for law in self.hanging if law.section not in self.dynamics)  # what would stay on the way
        names = [name for law in lasting for name in untold_in(add(law.left, law.right))]
        if found is not None or not names:
            return found
        key = key_of(names[0])
        moment = next((laws.moment for laws in self.dynamics.values() if laws.moment.when == key.when), None)
        if moment is None:  # of what goes on in time
            return None
        hinged = self.held.main(key.owner) is not None
        return Fault(moment.lost(key.owner), help=ANGLE_HELP.format(key.owner) if hinged else STANDING_HELP)

    def unread_lines(self) -> Iterator[Condition]:
        """The lines of states that no moment has read; a time alone says of what moment is asked, though the answer may not hang on it."""
        for laws in self.dynamics.values():
            lines = () if laws.moment.tells_time_alone() else laws.moment.state.conditions
            yield from (line for number, line in enumerate(lines) if number not in laws.moment.used)

    def conventions(self, used: Collection[Equation]) -> Iterator[Words]:
        """Along which axes the components are that are not those of space; what the numbers of the scene make special."""
        from rotsolve.space.conventions import conventions

        return conventions(self, used)

    def places(self) -> Iterator[Words]:
        """Where the points of bodies are of which it speaks."""
        from rotsolve.space.conventions import placed_points

        return placed_points(self)

    # its products as a textbook writes them

    def put_in_order(self, equation: Equation) -> Equation:
        """An equation with its products in order."""
        remark = tuple(self.in_order(part) if isinstance(part, Formula) else part for part in equation.remark)
        return replace(equation, left=self.in_order(equation.left), right=self.in_order(equation.right), remark=remark)

    def in_order(self, formula: Formula) -> Formula:
        """A formula with its products in order, functions last, repeated factors as powers: I₁ Ω sin² θ for sin(θ) I₁ Ω sin θ."""

        def change(node: Formula) -> Formula:
            if not isinstance(node, Product):
                return node
            bare = [part.operand if isinstance(part, Negative) else part for part in node.factors]
            whole = with_powers(reduce(multiply, sorted(bare, key=self.place_in_product)))
            turned = sum(isinstance(part, Negative) for part in node.factors) % 2
            return negate(whole) if turned else whole

        return formula.transform(change)

    def place_in_product(self, factor: Formula) -> tuple[int, int]:
        """Where a factor stands: numbers, letters by what they measure, what is in brackets, the L of Ω L, functions, sines first."""
        base = factor.base if isinstance(factor, Power) else factor
        if isinstance(base, Call):
            return 4, 0 if base.function == "sin" else 1
        if not isinstance(base, Symbol):
            return 0 if isinstance(base, Number) else 2, 0
        quantity = self.registry.quantities.get(base.name)
        if quantity is None:
            return 1, product_rank(self.given_dimensions.get(base.name))
        return 3 if quantity.dimension == ANGULAR_MOMENTUM else 1, product_rank(quantity.dimension)

    @cached_property
    def given_dimensions(self) -> dict[str, Dimension | None]:
        """What the letters of the scene measure."""
        return {given.name: given.dimension for given in self.configuration.problem.givens}

    def section(self, state: str) -> str:
        return state

    def steady_extreme(self, term: Term) -> tuple[Meaning, str]:
        """The smaller or larger precession of a steady motion: its law with a letter of its own for that root."""
        state = term.at or (self.configuration.timeline.states[0].name)
        dynamics, path = self.dynamics[state], term.path
        if path.quantity != "precession" or not dynamics.moment.state.steady or not dynamics.moment.nods(path.owner):
            from rotsolve.space.steady import OF_QUANTITY

            steady = dynamics.moment.state.steady and path.quantity in NODAL
            if path.quantity in NODAL:
                help = "say `steady: true` in its state, with its `tilt` and its `spin` or `axial_rate`"
                message = f"the {term.modifier} `{path.quantity}` is asked of a steady precession"
                raise NotYet(message, path.span, OF_QUANTITY if steady else help)
            message = f"over what `{path.quantity}` is {term.modifier} nothing tells: no letter of the scene is open"
            raise NotYet(message, path.span, "leave one that it hangs on without a value: `x: unknown` under `given`")
        own, kind = dynamics.moment.ask("precession", path.owner), QUANTITIES["precession"]
        from rotsolve.space.roots import word_told

        if isinstance(own, Symbol) and word_told(path.owner, state, self) == term.modifier:
            return Meaning(own, kind.dimension), state  # the root that the state itself has
        root = self.registry.ask(SceneQuantity("precession", path.owner, state, term.modifier, "Omega", kind.dimension))
        restated = (law for found in self.restated.values() for law in found)
        written = (*map(self.put_in_order, dynamics.equations()), *restated)
        laws = [
            law for law in written if law.law in ROTATING and law.section == state and own.symbols() & law.symbols()
        ]
        if not isinstance(own, Symbol) or not laws:
            self.refuse_unspun(path.owner, dynamics)
            if (refused := dynamics.unwritten.get(path.owner)) is not None:
                raise NotYet(refused.fault.message, refused.fault.span or path.span, refused.fault.help)
            raise NotYet(f"`{path.owner}` has one `precession` only", path.span, f"leave out `{term.modifier}`")
        beside = (self.beside_extreme(law, own.name, root, term.modifier, state) for law in first_of_each(laws))
        return Meaning(root, kind.dimension, laws=tuple(chain.from_iterable(beside))), state

    def beside_extreme(self, law: Equation, own: str, root: Formula, word: str, state: str) -> Iterator[Equation]:
        """A law with a letter of its own for one root, and those of the forces and couples in it, which have such letters too."""
        others = [
            self.put_in_order(item)
            for item in self.dynamics[state].equations()
            if item.bodies != law.bodies or item.law != law.law
        ]
        named: dict[str, Formula] = {own: root}
        taken, waiting = [law], sorted(of_kinds(law.symbols(), PUSHING))
        while waiting:
            name = waiting.pop()
            quantity = self.registry.quantities.get(name)
            if quantity is None or name in named:
                continue
            component = f"{quantity.component} {word}"
            named[name] = self.registry.ask(replace(quantity, component=component))
            for item in (item for item in others if name in item.symbols() and item not in taken):
                taken.append(item)
                waiting += sorted(of_kinds(item.symbols(), PUSHING))
        yield from (item.renamed(named) for item in taken)

    def small_swings(self, term: Term) -> tuple[Meaning, str]:
        """The period or frequency of small swings about a steady motion."""
        if self.held.closing is not None:
            from rotsolve.space.links import beyond_one_moment

            raise beyond_one_moment(self.held, "swings")
        from rotsolve.space.swings import small_swings

        return small_swings(self.dynamics, term)

    def steady_limit(self, owner: str, state: str) -> Equation | None:
        """Where the steady precession of a body is just possible; None where it has none with two roots."""
        from rotsolve.space.stability import steady_limit

        try:
            return self.put_in_order(steady_limit(self.dynamics[state], owner))
        except NotYet:
            return None

    def verge(self, condition: Condition) -> Equation:
        """Where the motion of a state is just stable, or just possible as a steady one."""
        dynamics = self.dynamics[condition.owner]
        spoken_of = {line.path.owner for line in dynamics.moment.state.conditions if line.path is not None}
        names = [name for name in self.held.order if dynamics.moment.nods(name) and name in spoken_of]
        if condition.word == "stable":
            names += [name for name in self.held.order if name in spoken_of and dynamics.moment.swings_on(name)]
        if not names:
            where = f"up to where the motion at `{condition.owner}` is {condition.word}"
            raise NotYet(f"{where} is solved for what has a tilt, or stands on a hinge", condition.span)
        if len(names) != 1:
            raise NotYet(
                f"of which body the motion at `{condition.owner}` is {condition.word} nothing tells", condition.span
            )
        from rotsolve.space.stability import limit_of, steady_limit

        limit = steady_limit if condition.word == "steady" else limit_of
        return self.put_in_order(limit(dynamics, names[0]))

    def reader_in(self, phase: str) -> SpaceReader:
        """What paths mean at any time of a phase."""
        from rotsolve.space.reader import SpaceReader

        return SpaceReader(self.running[phase], self.dynamics, self.configuration.problem)

    def between(self, term: Term) -> tuple[Meaning, str]:
        """The change of a quantity from one state to a later one, along axes that stay."""
        path, word = term.path, term.modifier
        if path.quantity == "time" and term.start is not None:
            from rotsolve.space.nutation import time_between

            return time_between(self.dynamics, self.configuration.timeline, term)
        self.refuse_other_side(path, term)
        if path.quantity == "precession_angle" and word == CHANGES[0] and term.start is not None:
            from rotsolve.space.nutation import angle_between

            found = angle_between(self.dynamics, self.configuration.timeline, term)
            if found is not None:
                return found
        if term.during is not None:
            lasts = self.configuration.timeline.whole(term.during)
            if lasts is None:
                raise Unclear(f"there is no phase or event `{term.during}`")
            start, end = lasts
            if path.quantity in ("impulse", "angular_impulse"):
                return self.reader(end).meaning(path, replace(term, during=None)), end
            term = replace(term, during=None, start=start, end=end)
        assert term.start is not None and term.end is not None
        if word == SIZE_OF_CHANGE:
            return self.size_of_change(term)
        if word not in CHANGES:
            raise NotYet(f"`{word} {path.quantity}` from one state to another is not solved in space yet", path.span)
        ends = [self.reader(state).meaning(path, replace(term, modifier="")) for state in (term.start, term.end)]
        first, last = (end.formula for end in ends)
        formula = add(last, negate(first)) if word != "lost" else add(first, negate(last))
        laws = tuple(dict.fromkeys(law for end in ends for law in end.laws))
        label = f"change, {ends[0].label}" if word != "lost" else f"what is lost, {ends[0].label}"
        return Meaning(formula, ends[0].dimension, label=label, laws=laws, plain=ends[0].plain), term.end

    def refuse_other_side(self, path: Path, term: Term) -> None:
        """Refuse the change of a tilt that is told beyond 0 to 180°, since the laws tell others within."""
        if path.quantity != "tilt" or term.start is None or term.end is None:
            return
        for state in (term.start, term.end):
            told = self.dynamics[state].moment.told(path.owner, "tilt")
            if told is not None and self.configuration.signs.taken(heading(told).sin()) == -1:
                message = (
                    f"the tilt of `{path.owner}` at `{state}` is told beyond 0 to 180°, so that its change is not told"
                )
                raise NotYet(message, path.span, "tell it from 0 to 180°, the `precession_angle` half a turn on")

    def size_of_change(self, term: Term) -> tuple[Meaning, str]:
        """√(Δx² + Δy² + Δz²) of a vector, |Δ| of a number."""
        if term.path.quantity not in DIRECTED or (term.path.component or "").split()[-1:] in ([axis] for axis in AXES):
            meaning, state = self.between(replace(term, modifier=CHANGES[0]))
            return replace(meaning, formula=call("abs", meaning.formula), label="size of the change", plain=True), state
        parts = []
        for axis in AXES:
            path = replace(term.path, component=" ".join(filter(None, (term.path.component, axis))))
            parts.append(self.between(replace(term, path=path, modifier=CHANGES[0])))
        meaning, state = parts[0]
        whole = tuple(self.dynamics[state].moment.tidy(part.formula) for part, _ in parts)
        return replace(meaning, formula=length_of(triple(whole)), label="size of the change", plain=True), state

    def _restating(self) -> Iterator[Equation]:
        """Lagrange's equations at each state, and what they keep over phases."""
        from rotsolve.space.lagrangian import by_lagrange_in_space

        if self.held.closing is not None:  # its coordinates are tied to each other
            return iter(())
        return by_lagrange_in_space(self)

    def refuse_without(self) -> None:
        """Refuse a phase in which something that holds a body, or acts on one, does so no more: its laws are those of all phases."""
        for phase in self.configuration.problem.phases:
            if phase.without:
                named = " and ".join(f"`{name}`" for name in phase.without)
                message = f"a phase without {named} is not solved in space"
                raise Unsolvable(message, span=phase.span, help="begin a scene of its own with what is left then")

    def refuse_turned(self) -> None:
        """Refuse a body that is drawn `turned` and of which a state tells Euler angles: they count from how it is drawn unturned."""
        leaning = (name for name in self.held.order if any(laws.moment.nods(name) for laws in self.dynamics.values()))
        for body in (self.held.bodies[name] for name in leaning):
            if body.turned:
                message = f"`{body.name}` is drawn `turned`, and a state tells how it stands by its Euler angles"
                raise Unsolvable(message, span=body.span, help="leave `turned` out")

    def refuse_varying(self) -> None:
        """Refuse actions that go by how a body stands or moves, which `simulate` follows alone."""
        for action in self.configuration.problem.actions:
            strength, ref = action.strength(), action.touches()[0]
            parts = () if isinstance(strength, str) else strength if isinstance(strength, tuple) else (strength,)
            if any(path for part in parts for path in paths_in(part)):
                message = f"`{action.name}` goes by how a body stands or moves, which is not solved in space"
                raise Unsolvable(message, span=ref.span, help="`rotsolve simulate` follows it")

    def _written(self) -> Iterator[Equation]:
        """All that the laws say at each state, whatever the angles are that nothing tells."""
        for law in self._written_openly():
            plain = law_whatever_the_angle(law)
            if plain is not None:
                yield law if plain is law else self.put_in_order(plain)
            else:
                self.hanging.append(law)

    def _written_openly(self) -> Iterator[Equation]:
        """All that the laws say at each state, with letters for angles that nothing tells."""
        self.refuse_varying()
        self.refuse_without()
        self.refuse_turned()
        if self.held.closing is not None:
            from rotsolve.space.links import refuse_in_course

            functions = self.configuration.mentions.functions
            refuse_in_course(self.held, self.configuration.problem.states, functions=functions)
        if self.configuration.problem.gravity_in:
            from rotsolve.space.weight_in_frame import refuse_weight_in_frame

            refuse_weight_in_frame(self.held)
        lines = (line for state in self.configuration.problem.states for line in state.conditions)
        refuse_dropped_told(lines, lambda name: (joint := self.held.main(name)) is not None and bool(joint.turning))
        for body in self.held.bodies.values():
            self.held.refuse_drawn_otherwise(body)
        for dynamics in self.dynamics.values():
            refuse_told_twice(dynamics.moment)
        for dynamics in (*self.dynamics.values(), *self.running.values()):
            yield from (self.put_in_order(one) for one in dynamics.equations())
            yield from axial_rules(dynamics)
            yield from turning_rules(dynamics)
            yield from told_of_forces(dynamics, self.dynamics)
            if dynamics.moment.onward is not None:
                yield from dynamics.moment.onward.equations()
        for interval in self.configuration.timeline.intervals:
            if interval.end == OPEN or self.configuration.timeline.at_rest(interval):
                continue
            ends = self.dynamics[interval.start], self.dynamics[interval.end]
            if interval.event is None and ends[0].moment.state.steady:
                refuse_left(ends[0].moment, ends[1].moment)
            laws = struck_in(interval, *ends) if interval.event is not None else kept_in(interval, *ends)
            laws = chain(laws, self.in_turning_frames(interval), self.tilts_on_from(interval))
            yield from map(self.put_in_order, laws)
        for dynamics in self.dynamics.values():
            yield from told_unread(dynamics, self.dynamics)
        yield from map(self.put_in_order, self.tensors.steps)

    def tilts_on_from(self, interval: Interval) -> Iterator[Equation]:
        """What leads from a tilt without nutation to an extreme one, where it nods at states on the way."""
        last, timeline = self.dynamics[interval.end], self.configuration.timeline
        nodding = [name for name in self.held.order if last.moment.nods(name) and last.moment.extreme_tilt(name)]
        between: Interval | None = interval
        while nodding and between is not None and between.event is None:
            laws = self.dynamics[between.start]
            still = [name for name in nodding if laws.moment.nodding(name).rates[1] == ZERO]
            nodding = [name for name in nodding if name not in still]
            for name in still if between is not interval else ():
                from rotsolve.space.passing import left_alone, turning_tilts

                if left_alone(laws, name):
                    yield from turning_tilts(name, interval, laws, last)
            between = timeline.before(between.start)

    def in_turning_frames(self, interval: Interval) -> Iterator[Equation]:
        """The energy in the frame of what is driven at a constant rate, over a phase."""
        carrying = {joint.carrier.owner for joint in self.held.joints if joint.carrier.owner in self.held.bodies}
        driven = any(joint.drive and joint.body.owner in carrying for joint in self.held.joints)
        if not driven or interval.event is not None:
            return iter(())
        from rotsolve.space.turning_frame import energy_in_frame

        return energy_in_frame(self, interval)


def struck_in(interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """What holds through an event."""
    from rotsolve.space.struck import through

    return through(interval, before, after)


def kept_in(interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """What bodies keep in a phase, each by itself and all together."""
    from rotsolve.space.passing import conserved
    from rotsolve.space.together import kept_together

    yield from conserved(interval, before, after)
    yield from kept_together(interval, before, after)


def first_of_each(laws: Iterable[Equation]) -> list[Equation]:
    """The first equation by each law."""
    found: dict[Law, Equation] = {}
    for one in laws:
        found.setdefault(one.law, one)
    return list(found.values())
