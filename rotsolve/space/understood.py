"""Understood: which clauses of a question, and of a line of a state, have a meaning in space for which quantities; any other is refused by
its name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from msgspec.structs import replace

from rotsolve.core.faults import Unsolvable
from rotsolve.core.quantity import DIRECTED, INERTIAL
from rotsolve.core.vectors.tensor import ENTRIES
from rotsolve.core.vectors.triple import AXES
from rotsolve.language.problem import Condition, Path, Term
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.space.supports import HELD

ABOUT = frozenset(  # what may be asked about a point
    ("torque", "angular_momentum", "inertia", "inertia_tensor", "principal_moments", "principal_axis", "gyration", "cm")
)
ALONG = frozenset(("inertia", "gyration"))  # what may be asked along a direction
RELATIVE = frozenset(("velocity", "speed", "acceleration", "force"))  # what may be asked relative to a body
TOLD_RELATIVE = ("position", "velocity", "acceleration")  # what a state may tell relative to a body
TURNING = ("angular_velocity", "angular_acceleration")
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
OF_VECTORS = frozenset((*AXES, "net", "gravity", HELD, "1", "2", "3", *INERTIAL))  # the same of vectors


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


def refuse_dropped_told(lines: Iterable[Condition], hinged: Callable[[str], bool]) -> None:
    """Refuse a line of a state of which a frame or axes mean nothing in space; `hinged` are bodies that turn about one axis in what carries
    them.
    """
    for line in lines:
        if line.path is None:
            continue
        word, axes = line.path.quantity, line.axes
        text = f"{'.'.join(filter(None, (line.path.owner, line.path.point)))}.{word}"
        if line.relative and word not in TOLD_RELATIVE:
            message = f"a state tells how a body goes `relative to {line.relative}`, not its `{word}`"
            help = f"leave `relative to {line.relative}` out"
            if word in TURNING and hinged(line.path.owner):
                help = (
                    f"write `{text}: 3 rad/s{'^2' if word == TURNING[1] else ''}`: that counts against what carries it"
                )
            elif word in TURNING:
                help = f"write `{text}: [x, y, z]` as it is in space"
            raise Unsolvable(message, span=line.span, help=help)
        along = line.relative or {"position": "space", "vertical": "body"}.get(word, "")
        if along and axes not in ("", along, *([line.path.owner] if along == "body" else ())):
            seen = f"{text} relative to {along}" if line.relative else text
            whose = {"space": "space", "body": "its body"}.get(along, f"`{along}`")
            help = f"leave `in {axes} axes` out, and tell its components along those"
            raise Unsolvable(f"`{seen}` is told along the axes of {whose}", span=line.span, help=help)
