"""Choosing: which quantities of a motion are shown: places and speeds where nothing else is asked for, or those that are named."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.core.faults import Unsolvable
from rotsolve.language.words import did_you_mean, nearest_name
from rotsolve.simulation.report import columns_of, quantity_word
from rotsolve.simulation.run import Run

MOTION, FORCES = "motion", "forces"  # names of all that is shown otherwise, and of all forces and torques
EXERTED = ("tension", "normal_force", "friction_force", "force", "torque", "friction_torque")
NAMED = 40  # names that a message lists


def chosen_names(run: Run, wanted: Sequence[str]) -> tuple[str, ...]:
    """The names of what is asked for, each once."""
    if not wanted:
        return columns_of(run)
    told = told_in_order(run)
    found: dict[str, None] = {}
    for word in (part.strip() for item in wanted for part in item.split(",")):
        names = list(meant_by(word, told, run))
        if not names:
            raise untold(word, told, run)
        found |= dict.fromkeys(names)
    return tuple(found)


def told_in_order(run: Run) -> list[str]:
    """All that the motion tells at some time: of bodies, then of connections, as the scene lists them."""
    owners = [item.name for item in (*run.problem.bodies, *run.problem.connections)]
    places = {owner: number for number, owner in enumerate(owners)}
    names = {name for part in run.regimes for name in part.system.outputs}
    return sorted(names, key=lambda name: (places.get(name.partition(".")[0], len(owners)), name))


def meant_by(word: str, told: Sequence[str], run: Run) -> Iterator[str]:
    """What a word stands for: a quantity, all of one kind, all of a body or a connection, or one of the two sets that have a name."""
    if word == MOTION:
        yield from columns_of(run)
    elif word == FORCES:
        yield from (name for name in told if quantity_word(name) in EXERTED)
    else:
        yield from (name for name in told if word in (name, quantity_word(name)) or name.startswith(f"{word}."))


def untold(word: str, told: Sequence[str], run: Run) -> Unsolvable:
    names = ", ".join(told[:NAMED]) + (", …" if len(told) > NAMED else "")
    meant = did_you_mean(nearest_name(word, told))
    help = (
        f"{meant}{' ' * bool(meant)}it tells {names}; `{FORCES}` are all forces, `{MOTION}` is what is shown otherwise"
    )
    return Unsolvable(f"the motion tells no `{word}`", help=help, lines=run.problem.lines, file=run.problem.file)
