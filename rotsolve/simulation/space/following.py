"""Following in space: what a scene with `up: z` can be followed through, and what is refused by name."""

from __future__ import annotations

from collections.abc import Mapping

from rotsolve.algebra.tape import Exact
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import State
from rotsolve.motion.configuration import Configuration
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.following import Follower
from rotsolve.simulation.space.compiling import SpaceSystem, compiled_in_space
from rotsolve.simulation.space.watching import watches_in_space
from rotsolve.simulation.system import System
from rotsolve.simulation.watches import Watch
from rotsolve.space.arrangement import JointedBodies


class SpaceFollower(Follower):
    """Follows a scene in space from its first state on."""

    def arrange(self) -> None:
        self.scene, self.modes = self.configuration, {}
        refuse_unfollowed(self.configuration)

    def begun(self) -> System:
        return compiled_in_space(self.configuration)

    def looked_for(self, system: System, ahead: State | None, since: Mapping[str, Exact]) -> list[Watch]:
        assert isinstance(system, SpaceSystem)
        return watches_in_space(system, ahead, since)

    def _reconfigured(self, state: State) -> bool:
        """Nothing begins or ends to act in space; an event is not followed."""
        after = self.configuration.timeline.after(state.name)
        if after is not None and after.event is not None:
            self.found.ended = f"`{after.name}` happens at `{state.name}`: what comes after that is not followed"
        return False


def refuse_unfollowed(configuration: Configuration) -> None:
    """Refuse by name what is not followed in time."""
    problem = configuration.problem
    held = JointedBodies(problem, configuration.signs)
    for action in problem.actions:
        if action.from_ is not None or action.to is not None:
            raise NotYet(f"`{action.name}` acts between two states: that is not followed in space yet")
    if held.closing is not None:
        owner, span = held.closing
        raise NotYet(f"`{owner}` closes a linkage in space: that is not followed in time yet", span)
    for joint in held.joints:
        words = unfollowed(joint, held)
        if words:
            raise NotYet(f"`{joint.owner}`: {words} not followed in time yet", joint.body.span)
    for name, body in held.bodies.items():
        led = {word for word, _, _ in body.moved}
        if led and held.main(name) is not None:
            raise NotYet(f"`{name}` is led, and held by a joint: that is not followed in time yet", body.span)
        if "acceleration" in led:
            help = "tell its `velocity` or `position` by `time`"
            raise NotYet(f"`{name}` is led by an acceleration: how fast it moves is not told", body.span, help)
    for line in configuration.timeline.states[0].conditions:
        if line.path is not None and line.path.quantity == "vertical":
            help = f"tell the `tilt` of `{line.path.owner}`, or how it is `turned`"
            raise NotYet("how a body stands by its `vertical` alone is not followed in time yet", line.span, help)


def unfollowed(joint: Joint, held: JointedBodies) -> str:
    """What of a joint is not followed, in words; '' of others."""
    if joint.sliding or joint.flat:
        return "what slides is"
    if joint.motor:
        return "a motor that gives what it takes is"
    carrier, name = joint.carrier.owner, joint.body.owner
    if joint.rolls and (len(held.of_body(name)) > 1 or held.bodies[name].moved):
        return "what rolls and is held, carried or led is"
    if carrier in held.bodies and (held.wheel(carrier) or any(other.rolls for other in held.of_body(carrier))):
        return "what a wheel carries is"
    return ""
