"""Freedoms: in how many independent ways a body can move: 6 less the rank of what its joints hold (Grübler; each is a lower pair)."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula, formula
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.space.arrangement import JointedBodies

WHOLE = {"translations": 3, "rotations": 3, "": 6}


def freedoms_of(held: JointedBodies, path: Path) -> Formula:
    """Of a body held by at most one joint: all six, or those that this leaves; of a joint those that it leaves."""
    which = path.component or ""
    joints = held.of_body(path.owner) if path.owner in held.bodies else ()
    joint = held.joint(path.owner)
    if len(joints) > 1 or (joint is None and path.owner not in held.bodies):
        raise NotYet(f"`{path_text(path)}`: the freedoms of what several joints hold are not solved yet", path.span)
    joint = joint or (joints[0] if joints else None)
    return formula(WHOLE[which] if joint is None else left_by(joint)[which])


def left_by(joint: Joint) -> dict[str, int]:
    """How many translations and rotations a joint leaves; of a screw both are one and the same."""
    turns = 3 if joint.free else len(joint.turning)
    slides = len(joint.sliding)
    if joint.flat:
        turns, slides = 1, 2
    both = turns + slides - (1 if joint.pitch is not None else 0)
    return {"translations": slides, "rotations": turns, "": both}
