"""Running: paths of bodies in values that vary: `couple: M0 + k*wheel.rotation`, `force: -b*block.velocity`."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.quantity import BY_WORD
from rotsolve.core.varying import PLACES, RATES
from rotsolve.language.words import quoted
from rotsolve.scene.phrase.paths import read_path
from rotsolve.scene.tree.nodes import Text
from rotsolve.scene.values.pieces import Piece
from rotsolve.scene.values.scope import Scope

WORDS = (*PLACES, *RATES)


def running_path(scope: Scope, node: Text, piece: Piece) -> Formula | None:
    """The letter that stands for a path in a value that varies, named as the path is written; None after a fault."""
    path = read_path(scope, node, piece.start, piece.end)
    if path is None:
        return None
    if path.owner not in scope.bodies or path.point or path.component or path.quantity not in WORDS:
        help = f"write `body.quantity` with one of: {', '.join(WORDS)}"
        scope.fault(path.span, f"a value can't vary with {quoted(piece.text)}", help, "formula")
        return None
    scope.dimensions[piece.text] = BY_WORD[path.quantity].dimension
    return Symbol(piece.text)
