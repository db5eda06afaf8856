"""The few flint types that the algebra needs, loaded without the thirty others that `import flint` brings along.

`import flint` takes about 33 ms, these types 20 ms. The package's own `__init__` is skipped by an empty package that stands
in while the submodules load, and is taken away again, so that a later `import flint` (SymPy's, say) is an ordinary one.
"""

from __future__ import annotations

import copyreg
import importlib
import importlib.util
import sys
from types import ModuleType
from typing import Any


def _load(names: tuple[str, ...]) -> list[ModuleType]:
    """The submodules of flint with these names, without running `flint/__init__.py`."""
    full = [f"flint.{name}" for name in names]
    spec = None if "flint" in sys.modules else importlib.util.find_spec("flint")
    if spec is None or spec.submodule_search_locations is None:
        return [importlib.import_module(name) for name in full]
    package = ModuleType("flint")
    package.__path__ = list(spec.submodule_search_locations)
    package.__spec__ = spec
    sys.modules["flint"] = package
    try:
        return [importlib.import_module(name) for name in full]
    finally:
        if sys.modules.get("flint") is package:
            del sys.modules["flint"]


_pyflint, _fmpz, _fmpq, _arb, _mpoly = _load(("pyflint", "types.fmpz", "types.fmpq", "types.arb", "types.fmpz_mpoly"))
context = _pyflint.ctx
fmpz = _fmpz.fmpz
fmpq = _fmpq.fmpq
arb = _arb.arb
fmpz_mpoly = _mpoly.fmpz_mpoly
fmpz_mpoly_ctx = _mpoly.fmpz_mpoly_ctx


def ball_parts(ball: Any) -> tuple[Any, ...]:
    """How pickling keeps a ball: its middle and its radius, each m·2^e exactly; what is not finite by its text."""
    if not ball.is_finite():
        return arb, (ball.str(radius=False),)
    middle, radius = ([int(part) for part in point.man_exp()] for point in (ball.mid(), ball.rad()))
    return exact_ball, (*middle, *radius)


def exact_ball(middle: int, exponent: int, radius: int, power: int) -> Any:
    """The ball of m·2^e with a radius of r·2^p, whatever the working precision is."""
    return arb((middle, exponent), (radius, power))


copyreg.pickle(arb, ball_parts)


def __getattr__(name: str) -> Any:
    """What few scenes need, loaded where it is asked for: complex balls (acb), and polynomials in one letter (fmpz_poly)."""
    if name not in ("acb", "fmpz_poly"):
        raise AttributeError(name)
    return getattr(_load((f"types.{name}",))[0], name)
