"""Sense: whether a composition tells a scene that can be: the assembly holds its first state, and follows it to the last one."""

from __future__ import annotations

from rotsolve.confirm import NotConfirmed, OverBudget
from rotsolve.confirm.course.following import Broken, Course
from rotsolve.confirm.course.node import Astray, Budget
from rotsolve.confirm.course.samples import sets_of_numbers
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_text
from trials.scene import Scene, written

INSTANTS = 900  # of one body that it may cost to follow
TOLD_WRONG = ("what the state says can not be fulfilled", "what is held can not be held together")


def makes_sense(scene: Scene) -> bool:
    """Whether what the states tell can be, and comes about: no speeds against what holds, no place to which nothing gets.

    What the assembly does not know may make sense.
    """
    try:
        problem = configured(read_text(written(scene) + "\n")).problem
        Course(problem, next(sets_of_numbers(problem)), Budget(INSTANTS)).hold()
    except (Astray, Broken, OverBudget):
        return False
    except NotConfirmed as reason:
        return str(reason) not in TOLD_WRONG
    except (ArithmeticError, SceneError, Unsolvable, ValueError):  # refused by name
        return True
    return True
