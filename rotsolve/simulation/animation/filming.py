"""Filming: the pictures of a motion that has been followed."""

from __future__ import annotations

from rotsolve.confirm import NotConfirmed
from rotsolve.draw.paper.reel import Reel
from rotsolve.draw.pictures import picture_words, undrawable
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.motion.configuration import Configuration
from rotsolve.simulation.animation.reading import MotionReading


def film(reading: MotionReading) -> Reel:
    """The pictures of a motion at the moments of a reading."""
    problem = reading.run.problem
    if not problem.bodies:
        raise undrawable("the scene has no bodies to draw", problem)
    try:
        return (space_film if problem.space else plane_film)(reading)
    except (NotConfirmed, ArithmeticError) as error:
        raise undrawable(f"where the bodies are is not told well enough for a picture: {error}", problem) from None


def plane_film(reading: MotionReading) -> Reel:
    from rotsolve.draw.plane.filming import motion_pictures
    from rotsolve.draw.plane.moving import moving_stage
    from rotsolve.simulation.animation.ways import PlaneMoments

    configuration = Configuration(reading.run.problem)
    numbers = numbers_for(configuration)
    stage = moving_stage(configuration, numbers, first_state(reading), PlaneMoments(reading))
    return motion_pictures(stage, reading.run.problem.title, picture_words(reading.run.problem))


def space_film(reading: MotionReading) -> Reel:
    from rotsolve.draw.space.moving import MovingSpaceStage, space_pictures
    from rotsolve.simulation.animation.turns import solid_ways

    configuration = Configuration(reading.run.problem)
    numbers = numbers_for(configuration)
    stage = MovingSpaceStage(configuration, numbers, first_state(reading), solid_ways(reading))
    return space_pictures(stage, reading.run.problem.title, picture_words(reading.run.problem))


def first_state(reading: MotionReading) -> str:
    """The name of the state from which the motion starts, '' where the scene has none."""
    return next((state.name for state in reading.run.problem.states), "")
