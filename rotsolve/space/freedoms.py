"""Freedoms: in how many independent ways a body can move: 6 less the rank of what its joints hold (Grübler; each is a lower pair)."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula, formula
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.space.arrangement import JointedBodies

WHOLE = {"translations": 3, "rotations": 3, "": 6}


def freedoms_of(held: JointedBodies, path: Path) -> Formula:
    """Of a body: all six, or those that its joint, or two balls together, leave; of a joint those that it leaves."""
    which = path.component or ""
    joint = held.joint(path.owner)
    several = path.owner in held.bodies and len(held.of_body(path.owner)) > len(held.supports(path.owner)) > 0
    if several or (joint is None and path.owner not in held.bodies):
        raise NotYet(f"`{path_text(path)}`: the freedoms of what several joints hold are not solved yet", path.span)
    if joint is None:
        touching = held.of_body(path.owner)
        joint = held.main(path.owner) or (touching[0] if touching else None)
        carrier = "" if joint is None else joint.carrier.owner
        if carrier in held.bodies and not held.bodies[carrier].moved:
            help = f"ask for those that its joint leaves, `{joint.owner}.freedoms`" if joint is not None else ""
            raise NotYet(f"`{path_text(path)}`: `{carrier}`, which carries it, moves as well", path.span, help)
    if joint is not None and joint.rolls:
        raise NotYet(f"`{path_text(path)}`: the freedoms of what rolls are not solved yet", path.span)
    if joint is None and held.pointlike(path.owner):
        return formula({"translations": 3, "rotations": 0, "": 3}[which])
    return formula(WHOLE[which] if joint is None else left_by(joint)[which])


def left_by(joint: Joint) -> dict[str, int]:
    """How many translations and rotations a joint leaves; of a screw both are one and the same."""
    turns = 3 if joint.free else len(joint.turning)
    slides = len(joint.sliding)
    if joint.flat:
        turns, slides = 1, 2
    both = turns + slides - (1 if joint.pitch is not None else 0)
    return {"translations": slides, "rotations": turns, "": both}
