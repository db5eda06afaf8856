"""Explain: why there is no answer, in the scene's words: what is missing or contradictory, where, and what may help."""

from rotsolve.inquiry.explain.contradictory import contradicted, said_otherwise, turns_back
from rotsolve.inquiry.explain.missing import no_answer, refuse_unsolved
from rotsolve.inquiry.explain.unsolvable import unsolvable

__all__ = [
    "contradicted",
    "no_answer",
    "refuse_unsolved",
    "said_otherwise",
    "turns_back",
    "unsolvable",
]
