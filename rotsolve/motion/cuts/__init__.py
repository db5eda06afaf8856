"""Cuts: a rod cut through at a point: the piece on one side as a body of its own, with what the rest does to it at the cut.

Along a rod x runs from its start. At the cut the part before x acts on the part beyond it with the compression along the rod (a push),
the shear across it (to the left-hand side of the way from start to end) and the bending moment (clockwise): all three are positive where
a level rod, drawn from left to right, is pressed, pushed up at the cut, and bent so that it sags.
"""

from rotsolve.motion.cuts.piece import cuts_at

__all__ = ["cuts_at"]
