"""The problems, in the order in which they are printed."""

from __future__ import annotations

from .driven_pulley import DRIVEN_PULLEY
from .in_space import BOOK, HEAVY_TOP, MIDDLE
from .period import PERIOD_60, PERIOD_170, PERIOD_179
from .pulleys import MASS_RATIO, NEARLY_EQUAL
from .rod import LONG, ROD, UPRIGHT
from .rolling_coin import COIN
from .two_rods import TWO_RODS

IN_PLANE = (
    *(ROD, UPRIGHT, TWO_RODS, DRIVEN_PULLEY, LONG),
    *(PERIOD_60, PERIOD_170, PERIOD_179, NEARLY_EQUAL, MASS_RATIO),
)
IN_SPACE = (BOOK, MIDDLE, HEAVY_TOP, COIN)
PROBLEMS = {problem.name: problem for problem in (*IN_PLANE, *IN_SPACE)}
