"""Scenes in space beside those in the plane: whole processes, a problem more in one process, and a closed form of elliptic functions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from statistics import mean, median

from msgspec.structs import replace

from costs.clock import best, forget
from costs.problems import measured
from costs.processes import ROTSOLVE, Ratios, ratios
from costs.tables import Part, Target, below, share, table
from rotsolve.algebra.certified.ball import Certified

SLOWEST = 8  # files that are named
DIGITS = 15
RUNS = 200
RACKET = """\
title: Free asymmetric body after a thousand seconds
up: z
gravity: none
given: {I1: 0.00121 kg m^2, I2: 0.01638 kg m^2, I3: 0.01748 kg m^2, w1: 0.2 rad/s, w2: 12 rad/s, T: 1000 s}
bodies: {racket: {mass: 350 g, inertia: {principal: [I1, I2, I3]}}}
states: {start: {"racket.angular_velocity in body axes": [w1, w2, 0]}, later: {time: T}}
find:
  u_x: racket.angular_velocity.x at later in body axes
  u_y: racket.angular_velocity.y at later in body axes
  u_z: racket.angular_velocity.z at later in body axes
"""
Groups = Mapping[str, Sequence[Path]]


def part(groups: Groups, folder: Path, rounds: int) -> Part:
    """The tables of both groups, `in the plane` and `in space`, and the targets."""
    commands = {
        str(file.relative_to(folder)): [*ROTSOLVE, "solve", str(file)] for files in groups.values() for file in files
    }
    found = ratios(commands, rounds)
    cold = {group: {name: found[name] for name in names(files, folder)} for group, files in groups.items()}
    warm = {
        group: dict(zip(names(files, folder), (sum(one.values()) for one in measured(files, rounds)), strict=True))
        for group, files in groups.items()
    }
    numbers = closed_form()
    text = "\n\n".join(
        [
            f"Whole processes, cold: medians of {rounds} rounds, processor time as a multiple of that of `import sympy`.",
            table(("scenes", "files", "median", "mean", "90 %", "slowest"), [cold_row(*item) for item in cold.items()]),
            slowest({name: one.sympy for name, one in cold["in space"].items()}, "{:.2f} ×"),
            f"A problem more in one process, each solved once: ms of processor time, medians of {rounds} processes.",
            table(("scenes", "files", "median", "mean", "90 %", "slowest"), [row(*item) for item in warm.items()]),
            slowest(warm["in space"], "{:.0f} ms"),
            f"Closed forms, once solved: ω of a free asymmetric body after 1000 s by sn, cn and dn, each component to {DIGITS} certified "
            f"digits, with nothing remembered, best of {RUNS}.",
            table(("", "digits", "µs"), [[f"`{name}`", text, f"{1e6 * took:.0f}"] for name, text, took in numbers]),
        ]
    )
    return Part("Scenes in space", text, tuple(targets(cold, max(took for _, _, took in numbers))))


def names(files: Sequence[Path], folder: Path) -> list[str]:
    return [str(file.relative_to(folder)) for file in files]


def targets(cold: Mapping[str, Mapping[str, Ratios]], took: float) -> list[Target]:
    """Half of `import sympy` in space, a third of it in the plane; a millisecond for a closed form."""
    space, plane = (median(one.sympy for one in cold[group].values()) for group in ("in space", "in the plane"))
    return [
        below("cold solve in space, × `import sympy` (median file)", space, 0.5),
        below("cold solve in the plane, × `import sympy` (median file)", plane, 1 / 3),
        below("free asymmetric body after 1000 s, 15 digits of a component, ms", 1000 * took, 1),
    ]


def cold_row(group: str, found: Mapping[str, Ratios]) -> list[str]:
    values = [one.sympy for one in found.values()]
    return [group, str(len(values)), *(f"{value:.2f}" for value in spread(values))]


def row(group: str, found: Mapping[str, float]) -> list[str]:
    values = list(found.values())
    return [group, str(len(values)), *(f"{value:.1f}" for value in spread(values))]


def spread(values: Sequence[float]) -> tuple[float, float, float, float]:
    return median(values), mean(values), share(values, 0.9), max(values)


def slowest(found: Mapping[str, float], form: str) -> str:
    """The slowest files by name."""
    ordered = sorted(found.items(), key=lambda item: -item[1])[:SLOWEST]
    return f"Slowest: {', '.join(f'{name} {form.format(value)}' for name, value in ordered)}."


def closed_form() -> list[tuple[str, str, float]]:
    """By component its digits, and the least seconds that they take."""
    import rotsolve

    found = []
    for answer in rotsolve.solve(RACKET, digits=DIGITS).derivation.answers:
        value = answer.value
        assert value is not None, answer.name

        def digits(value: Certified = value) -> tuple[str, int]:
            return replace(value, ball=value.refine(DIGITS)).figures(DIGITS)

        text, sure = digits()
        assert sure == DIGITS, text
        found.append((answer.name, text, best(digits, RUNS, before=forget)))
    return found
