"""Paths: what a path of the scene language stands for, as a formula in the quantities of the laws."""

from rotsolve.paths.meaning import Meaning, NotYet, Unclear, label_of, path_text, size_of, spoken_point
from rotsolve.paths.points import resting
from rotsolve.paths.reader import Reader

__all__ = [
    "Meaning",
    "NotYet",
    "Reader",
    "Unclear",
    "label_of",
    "path_text",
    "resting",
    "size_of",
    "spoken_point",
]
