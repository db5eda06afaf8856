"""Filming: the pictures of a motion that has been followed."""

from __future__ import annotations

from rotsolve.confirm import NotConfirmed
from rotsolve.draw.paper.reel import Reel
from rotsolve.draw.pictures import picture_words, undrawable
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.motion.configuration import Configuration
from rotsolve.simulation.animation.course import Course


def film(course: Course) -> Reel:
    """The pictures of a motion at the moments of a course."""
    problem = course.run.problem
    if not problem.bodies:
        raise undrawable("the scene has no bodies to draw", problem)
    try:
        return (space_film if problem.space else plane_film)(course)
    except (NotConfirmed, ArithmeticError) as error:
        raise undrawable(f"where the bodies are is not told well enough for a picture: {error}", problem) from None


def plane_film(course: Course) -> Reel:
    from rotsolve.draw.plane.filming import motion_pictures
    from rotsolve.draw.plane.moving import moving_stage
    from rotsolve.simulation.animation.ways import PlaneMoments

    configuration = Configuration(course.run.problem)
    numbers = numbers_for(configuration)
    stage = moving_stage(configuration, numbers, first_state(course), PlaneMoments(course))
    return motion_pictures(stage, course.run.problem.title, picture_words(course.run.problem))


def space_film(course: Course) -> Reel:
    from rotsolve.draw.space.moving import MovingSpaceStage, space_pictures
    from rotsolve.simulation.animation.turns import solid_ways

    configuration = Configuration(course.run.problem)
    numbers = numbers_for(configuration)
    stage = MovingSpaceStage(configuration, numbers, first_state(course), solid_ways(course))
    return space_pictures(stage, course.run.problem.title, picture_words(course.run.problem))


def first_state(course: Course) -> str:
    """The name of the state from which the motion starts, '' where the scene has none."""
    return next((state.name for state in course.run.problem.states), "")
