"""Courses: how quantities run in time: as functions of the running time, where they vanish, where they are largest."""

from rotsolve.questions.courses.beside import Beside
from rotsolve.questions.courses.extremes import extreme
from rotsolve.questions.courses.running import at_any_time, phases_of, way
from rotsolve.questions.courses.whole import whole_way

__all__ = ["Beside", "at_any_time", "extreme", "phases_of", "way", "whole_way"]
