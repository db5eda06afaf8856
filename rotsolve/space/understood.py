"""Understood: which clauses of a question have a meaning in space for which quantities; any other is refused by its name."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.core.quantity import DIRECTED, INERTIAL
from rotsolve.core.vectors.tensor import ENTRIES
from rotsolve.core.vectors.triple import AXES
from rotsolve.language.problem import Path, Term
from rotsolve.paths.meaning import NotYet, path_text

ABOUT = frozenset(  # what may be asked about a point
    ("torque", "angular_momentum", "inertia", "inertia_tensor", "principal_moments", "principal_axis", "gyration", "cm")
)
ALONG = frozenset(("inertia", "gyration"))  # what may be asked along a direction
RELATIVE = frozenset(("velocity", "speed", "acceleration", "force"))  # what may be asked relative to a body
IN_AXES = frozenset((*DIRECTED, "inertia_tensor"))  # what may be asked along axes
WORDS = {  # of scalars: what may stand behind their names
    "kinetic_energy": frozenset(("rotational", "translational")),
    "power": frozenset(("net", "gravity")),
    "inertia_tensor": frozenset(ENTRIES),
    "principal_moments": frozenset("123"),
    "cm": frozenset(AXES),
    "freedoms": frozenset(("translations", "rotations")),
}
EXERTED = ("force", "torque", "power")  # what an action or a joint exerts has a question of its own
OF_VECTORS = frozenset((*AXES, "net", "gravity", "1", "2", "3", *INERTIAL))  # the same of vectors


def refuse_dropped(path: Path, term: Term) -> None:
    """Refuse a question with a clause that means nothing for its quantity in space."""
    clause = next(dropped(path, term), "")
    if clause:
        plain = replace(path, component=None)
        help = "leave it out: docs/language.md lists what each quantity takes in space"
        word = clause.removeprefix(".")
        if word != clause and path.quantity in EXERTED:
            help = f"what `{word}` exerts is asked of itself, `{word}.{path.quantity}`; else leave it out"
        raise NotYet(f"`{clause}` is not solved of `{path_text(plain)}` in space", path.span, help)


def dropped(path: Path, term: Term) -> Iterator[str]:
    """The clauses that have no meaning."""
    quantity = path.quantity
    known = OF_VECTORS if quantity in DIRECTED else WORDS.get(quantity, frozenset())
    yield from (f".{word}" for word in (path.component or "").split() if word not in known)
    if term.about is not None and quantity not in ABOUT:
        yield f"about {term.about.owner}"
    if term.along is not None and quantity not in ALONG:
        yield "along"
    if term.relative and quantity not in RELATIVE:
        yield f"relative to {term.relative}"
    if term.axes and quantity not in IN_AXES:
        yield f"in {term.axes} axes"
    if term.axes not in (None, "", "space", "body") and quantity == "inertia_tensor":
        yield f"in {term.axes} axes"
    if term.by is not None:
        yield f"by {term.by}"
