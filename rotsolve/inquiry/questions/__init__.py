"""Questions: what a path of the scene language stands for, as a formula in the quantities of the laws."""

from rotsolve.inquiry.questions.asked import Asked, component, in_parts, whole_vector
from rotsolve.inquiry.questions.meaning import Meaning, NotYet, Unclear, label_of, path_text, size_of, spoken_point
from rotsolve.inquiry.questions.points import resting
from rotsolve.inquiry.questions.reader import Reader

__all__ = [
    "Asked",
    "Meaning",
    "NotYet",
    "Reader",
    "Unclear",
    "component",
    "in_parts",
    "label_of",
    "path_text",
    "resting",
    "size_of",
    "spoken_point",
    "whole_vector",
]
