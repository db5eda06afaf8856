"""The table of laws: what is written for which part of a scene. The scene's equations are a loop over it.

To add a law from anywhere: a `Law` (rotsolve/core/equation.py) with a name, the words of its label, its family and its cost; a function
that takes what its scope holds (one of the records below) and yields `LAW.equation(left, right, section, bodies, …)`; and a row

    Principle((LAW,), (PHASE,), function)

in `LAWS`. The place in the table is the order in which the equations of one scope are written, which only decides between plans that cost
the same; of equal equations of one family the cheapest is kept. Nothing else is to be touched: `--law`, the plan, the derivation, the
confirmation of answers and the mistakes go by the law that an equation knows. A row may name its function as "module:function" of this
room; it is loaded when its scope is met first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.equation import (
    ABOUT_CONTACT,
    ACROSS,
    ALONG_TURNING,
    ANGLES_TURNED,
    BLOWS,
    BY_PLACE,
    CARRIED,
    CENTRE_STAYS,
    COMMON_AXIS,
    CONSERVATION,
    COORDINATE,
    CUT_TORQUES,
    CYCLIC,
    DERIVATIVE,
    ENERGY_FUNCTION,
    FACE_FRICTION,
    GIVEN_MOTION,
    IN_TIME,
    INERTIA,
    LAGRANGE_EQUATION,
    MOMENTUM,
    PERIOD,
    POWER,
    RATE,
    RESTITUTION,
    ROTATION,
    RULE,
    RULE_OF_WAYS,
    SECOND_LAW,
    SEPARATED_BY_PLACE,
    SEPARATED_BY_RATE,
    SPEED_AT_PLACE,
    STEADY,
    STEADY_TRAVEL,
    STEADY_TURN,
    STRETCH,
    SUMMED_OVER_WAY,
    TIME_ELAPSED,
    TORQUES,
    TRAVEL_AT_ANY_TIME,
    TRAVEL_BY_MEAN,
    TURN_AT_ANY_TIME,
    TURN_BY_MEAN,
    TURNING_FRAME,
    TWISTS,
    UNPRESSED,
    WAY_OF_SLIP,
    WORK,
    WORK_AND_ENERGY,
    Equation,
    Law,
)
from rotsolve.core.facts import Facts, Rule

if TYPE_CHECKING:
    from rotsolve.core.lagrangian import Lagrangian
    from rotsolve.core.passage import Encounter, Passage

STATE = "state"  # AtMoment: each state
GROUP = "group"  # OfGroup: tied bodies at a state
PHASE = "phase"  # OverPhase
MIDST = "midst"  # AtMoment: any moment of a phase in which accelerations vary, or of which a function of time is asked
RUNNING = "running"  # OverPhase: up to any moment of a phase of which a function of time is asked
EVENT = "event"  # ThroughEvent
BETWEEN = "between"  # OverPhase: each phase, behind all states, phases and events
HELD = "held"  # AtMoment: each state, behind all phases, with how contacts that it says to roll or stick tie the speeds for rules
REST = "rest"  # AtMoment: an equilibrium about which bodies swing
NEAR = "near"  # AtMoment: these bodies displaced from it
SWINGING = "swinging"  # OfGroup: these bodies, at rest and displaced
FOLLOWED = "followed"  # AtMoment: a moment of a simulation, for its forces and accelerations
SPEEDS = "speeds"  # AtMoment: a moment of a simulation, for its speeds
MOTION = "motion"  # OfMotion: tied bodies at a moment, as energies, where `--law lagrange` asks for it
KEPT = "kept"  # BetweenMoments: the same over a phase


class AtMoment(Struct, frozen=True):
    """One moment: its facts, and the sections for what holds in its whole phase and for what holds at its state alone."""

    facts: Facts
    section: str
    state: str


class OfGroup(Struct, frozen=True):
    """Bodies that are tied, at one moment; `virtual` are the facts with the velocities of any motion that the rules allow."""

    facts: Facts
    virtual: Facts
    group: frozenset[str]
    section: str


class OverPhase(Struct, frozen=True):
    """A phase; `earlier` are those that lead to it with no event between.

    `thought` are facts in its midst with velocities that are only thought of, for whose letters `changes` has displacements and angles
    turned: in the whole phase, or up to any moment. What rolls or sticks from its end on is `held` there by rules.
    """

    passage: Passage
    section: str
    earlier: tuple[Passage, ...]
    thought: Facts
    changes: Mapping[str, Formula]
    lasts: Mapping[str, Formula]
    held: tuple[Rule, ...] = ()


class ThroughEvent(Struct, frozen=True):
    """An event that takes no time."""

    encounter: Encounter
    section: str


class OfMotion(Struct, frozen=True):
    """How tied bodies can move, in letters of places and rates, and what puts in for these what they are at a moment."""

    motion: Lagrangian
    now: Callable[[Formula], Formula]
    section: str
    bodies: tuple[str, ...]


class BetweenMoments(Struct, frozen=True):
    """The same at the first and the last moment of a phase, with the works of what has no potential."""

    motion: Lagrangian
    first: Callable[[Formula], Formula]
    last: Callable[[Formula], Formula]
    section: str
    bodies: tuple[str, ...]
    works: tuple[Formula, ...] = ()


class Principle(Struct, frozen=True):
    """One row: the laws that a function writes, and for what: `scopes` are of one kind of record."""

    laws: tuple[Law, ...]
    scopes: tuple[str, ...]
    function: str | Callable[[Any], Iterator[Equation]]


@cache
def loaded(name: str) -> Callable[[Any], Iterator[Equation]]:
    """A function of this room by its module and name."""
    module, _, function = name.partition(":")
    found: Callable[[Any], Iterator[Equation]] = getattr(import_module(f"rotsolve.laws.{module}"), function)
    return found


def equations_for(
    scope: str, at: AtMoment | OfGroup | OverPhase | ThroughEvent | OfMotion | BetweenMoments
) -> Iterator[Equation]:
    """All that the laws write for one part of a scene."""
    for row in LAWS:
        if scope in row.scopes:
            yield from (loaded(row.function) if isinstance(row.function, str) else row.function)(at)


STEADY_ACCELERATION = (
    STEADY_TRAVEL,
    STEADY_TURN,
    TRAVEL_BY_MEAN,
    TURN_BY_MEAN,
    TRAVEL_AT_ANY_TIME,
    TURN_AT_ANY_TIME,
)

LAWS = (
    Principle((INERTIA,), (STATE, MIDST, NEAR), "newton:moments_of_inertia"),
    Principle((FACE_FRICTION,), (STATE, MIDST), "newton:frictions_of_faces"),
    Principle((FACE_FRICTION,), (FOLLOWED,), "newton:frictions_summed_up"),
    Principle((SECOND_LAW,), (STATE, MIDST, REST, NEAR, FOLLOWED), "newton:second_law"),
    Principle((ACROSS, ROTATION), (STATE,), "newton:where_things_slide"),
    Principle((CARRIED,), (STATE, MIDST, REST, NEAR, FOLLOWED), "newton:carried_apart"),
    Principle((ROTATION,), (STATE, MIDST, REST, NEAR, FOLLOWED), "newton:law_of_rotation"),
    Principle((ABOUT_CONTACT,), (STATE, MIDST), "groups:rotation_about_contacts"),
    Principle((TORQUES,), (STATE,), "newton:balance_of_torques"),
    Principle((INERTIA, SECOND_LAW, ROTATION, CUT_TORQUES), (STATE,), "newton:laws_of_pieces"),
    Principle((RULE,), (STATE, MIDST, NEAR, FOLLOWED), "rules:rules_for_accelerations"),
    Principle((RULE,), (STATE, MIDST, HELD, SPEEDS), "rules:rules_for_velocities"),
    Principle((GIVEN_MOTION,), (STATE, MIDST, SPEEDS, FOLLOWED), "rules:rates_of_given_motion"),
    Principle((PERIOD, STEADY), (STATE,), "rules:steady_rotation"),
    Principle((RATE,), (GROUP, SWINGING), "groups:rate_of_angular_momentum"),
    Principle((DERIVATIVE, POWER), (GROUP,), "groups:rate_of_energy"),
    Principle((POWER,), (SWINGING,), "groups:power_of_forces"),
    Principle((CONSERVATION, WORK_AND_ENERGY), (PHASE,), "energy:conservation"),
    Principle((TURNING_FRAME,), (PHASE,), "energy:in_turning_frames"),
    Principle((ALONG_TURNING,), (PHASE,), "energy:along_what_turns"),
    Principle((WORK, WAY_OF_SLIP), (PHASE,), "works:works_spelled"),
    Principle(
        (*STEADY_ACCELERATION, IN_TIME, BY_PLACE, SUMMED_OVER_WAY, COORDINATE, TIME_ELAPSED),
        (PHASE,),
        "kinematics:motion_over_phase",
    ),
    Principle((SEPARATED_BY_RATE, SEPARATED_BY_PLACE, SPEED_AT_PLACE), (PHASE,), "kinematics:separated"),
    Principle((TWISTS, BLOWS), (PHASE,), "momentum:impulses_over"),
    Principle((MOMENTUM, CENTRE_STAYS), (PHASE,), "momentum:momentum_without_force"),
    Principle((MOMENTUM,), (PHASE,), "momentum:turning_without_torque"),
    Principle((COMMON_AXIS, ANGLES_TURNED), (PHASE,), "momentum:about_common_axes"),
    Principle((COMMON_AXIS,), (PHASE,), "past_surfaces:about_points_of_surfaces"),
    Principle((RULE_OF_WAYS,), (PHASE, RUNNING), "rules:rules_for_displacements"),
    Principle((RULE_OF_WAYS,), (PHASE,), "rules:ways_by_links"),
    Principle((RULE,), (PHASE,), "rules:rules_to_the_end"),
    Principle((STRETCH,), (BETWEEN,), "rules:elongations"),
    Principle((COMMON_AXIS, MOMENTUM), (EVENT,), "momentum:group_through_event"),
    Principle((BLOWS, TWISTS), (EVENT,), "momentum:bodies_through_event"),
    Principle((UNPRESSED,), (EVENT,), "momentum:nothing_pressed"),
    Principle((RESTITUTION,), (EVENT,), "momentum:restitution"),
    Principle((RULE,), (EVENT,), "rules:rules_through_event"),
    Principle((LAGRANGE_EQUATION,), (MOTION,), "lagrange:equations_of_motion"),
    Principle((CYCLIC,), (KEPT,), "lagrange:conserved_momenta"),
    Principle((ENERGY_FUNCTION,), (KEPT,), "lagrange:energy_over"),
)
