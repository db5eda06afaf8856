"""Depth: how much of a derivation a page tells, and how many numbers stand in it."""

from __future__ import annotations

FEWEST_TERMS = 4  # of a sum that gets a letter of its own where it comes back
LONG = 24  # nodes of an answer from which on its letter stands for it in another one
BRIEF, NORMAL, FULL = "brief", "normal", "full"
DETAILS = (BRIEF, NORMAL, FULL)  # laws and answers; the plan, forces and steps too; the way of a second law as well
NONE, RESULTS, STEPS = "none", "results", "steps"
NUMBERS = (
    NONE,
    RESULTS,
    STEPS,
)  # letters wherever there are formulas; values of the answers; numbers put in where a step tells one
