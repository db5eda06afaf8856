"""rotsolve: solves textbook rotational mechanics, exactly and with its derivation.

>>> import rotsolve
>>> solution = rotsolve.solve("problems/pulleys/block-on-disc.yaml")  # a path, or the text of a scene
>>> solution.answers["a"].exact
'2 m g/(2 m + M)'
>>> print(solution)  # the whole derivation, as the command `rotsolve solve` prints it

Everything is imported when it is first used: `import rotsolve` alone costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rotsolve.core.faults import SceneError, Unsolvable
    from rotsolve.pipeline import solve
    from rotsolve.simulation import Run, simulate
    from rotsolve.solution import AnswerView, Solution

__version__ = "0.1.0"
__all__ = ["AnswerView", "Run", "SceneError", "Solution", "Unsolvable", "__version__", "simulate", "solve"]

_HOMES = {  # public name -> the module that defines it
    "AnswerView": "rotsolve.solution",
    "Run": "rotsolve.simulation",
    "SceneError": "rotsolve.core.faults",
    "Solution": "rotsolve.solution",
    "Unsolvable": "rotsolve.core.faults",
    "simulate": "rotsolve.simulation",
    "solve": "rotsolve.pipeline",
}


def __getattr__(name: str) -> Any:
    """Import a public name from its home on first use."""
    if name not in _HOMES:
        raise AttributeError(f"module 'rotsolve' has no attribute {name!r}")
    value = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
