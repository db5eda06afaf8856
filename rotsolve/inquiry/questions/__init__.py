"""Questions: what a path of the scene language stands for, as a formula in the quantities of the laws."""

from rotsolve.inquiry.questions.meaning import Meaning, NotYet, Unclear, path_text
from rotsolve.inquiry.questions.reader import Reader

__all__ = ["Meaning", "NotYet", "Reader", "Unclear", "path_text"]
