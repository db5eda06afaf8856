"""Reading: what a student may write, as formulas, numbers with units, vectors, words and equations."""

from rotsolve.grading.reading.names import Names
from rotsolve.grading.reading.read import read_answer
from rotsolve.grading.reading.records import AnswerError, Reading

__all__ = ["AnswerError", "Names", "Reading", "read_answer"]
