"""Marginal time a problem, in one process that has imported everything: each problem once, by stage."""

from __future__ import annotations

import json
import pkgutil
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from statistics import mean, median

from costs.processes import run, seconds
from costs.tables import Part, below, share, table

STAGES = {  # the stages of the profile that make up a column
    "read": ("read",),
    "solve": ("arrange", "friction", "laws", "plan", "solve"),
    "verify": ("verify",),
    "confirm": ("confirm",),
    "render": ("compose", "render"),
    "rest": ("import",),  # of what is imported already
}
SHARE = 0.03  # of `import sympy` that a problem may take


def measure(files: Sequence[Path]) -> list[dict[str, float]]:
    """Milliseconds of each problem by column, in this process, which must be fresh: what is solved twice is remembered."""
    import rotsolve
    from rotsolve.profile import recording, stage

    for module in pkgutil.walk_packages(rotsolve.__path__, "rotsolve."):
        if not module.name.endswith("__main__") and ".arrays" not in module.name:
            import_module(module.name)
    found = []
    for file in files:
        with recording() as profile:
            solution = rotsolve.solve(file)
            with stage("render", whole=True):
                solution.to("text")
        found.append(
            {name: 1000 * sum(profile.spent.get(part, 0.0) for part in parts) for name, parts in STAGES.items()}
        )
    return found


def measured(files: Sequence[Path], rounds: int) -> list[dict[str, float]]:
    """By problem and column, medians over so many fresh processes."""
    command = [sys.executable, sys.argv[0], "--measure", "problems", *map(str, files)]
    runs = [json.loads(run(command).stdout) for _ in range(rounds)]
    return [{name: median(one[index][name] for one in runs) for name in STAGES} for index in range(len(files))]


def part(files: Sequence[Path], folder: Path, rounds: int) -> Part:
    """The table of columns, the slowest problems, and the target."""
    sympy = 1000 * median(seconds([sys.executable, "-c", "import sympy"]) for _ in range(2 * rounds + 1))
    found = measured(files, rounds)
    whole = [sum(columns.values()) for columns in found]
    columns = {**{name: [one[name] for one in found] for name in STAGES}, "everything": whole}
    rows = [
        [name, *(f"{value:.2f}" for value in (median(values), mean(values), share(values, 0.9), max(values)))]
        for name, values in columns.items()
    ]
    slowest = sorted(zip(whole, files, strict=True), reverse=True)[:5]
    text = "\n\n".join(
        [
            f"Milliseconds of processor time a problem, {len(files)} problems in one process, each solved once; "
            f"medians of {rounds} processes. `import sympy` takes {sympy:.0f} ms.",
            table(("", "median", "mean", "90 %", "slowest"), rows),
            "Slowest: " + ", ".join(f"{file.relative_to(folder)} {spent:.0f} ms" for spent, file in slowest) + ".",
        ]
    )
    medians = ", ".join(f"{name} {median(values):.1f}" for name, values in columns.items() if name != "everything")
    why = f"no stage stands out ({medians}), and within them no function: it is many small steps of exact algebra in Python"
    target = "marginal time a problem, × `import sympy` (median)"
    return Part("A problem more in one process", text, (below(target, median(whole) / sympy, SHARE, "{:.3f}", why),))
