"""Marking: verdicts and marks for all that a student handed in, with following through, and the working line by line."""
