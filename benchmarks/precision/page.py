"""The section of docs/benchmarks.md: what was measured and how, the targets, the pictures and all rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib.metadata import PackageNotFoundError, version

from report import machine

from .measure import Row
from .peers.ours import ways
from .problem import Problem
from .problems import IN_PLANE, IN_SPACE
from .reach import figures, milliseconds
from .worker import LIMIT, SLOW

PACKAGES = ("numpy", "scipy", "mpmath", "sympy", "heyoka", "mujoco", "pymunk")
HEAD = """\
## Run time against error

`python benchmarks/work_precision.py`, {measured}

Each problem is a scene that rotsolve reads, and the same in plain mathematics for the others, in the variables that suit
them best (angles from upright, where the rod starts next to it). Errors are against references of 60 digits, on which two
routes agree that share nothing but the numbers of the problem (`--references` makes them anew): the largest error of the
asked quantities, relative where a number is asked, absolute (rad, rad/s) where a state is. **Whole process** is the
processor time (user and system) of a fresh process from start to exit, the median of {rounds} that took turns with all
others, so that what else the machine does counts little: of ours the command `rotsolve solve` or `rotsolve simulate`, of the others a
script in Python. **Clock** is the time that passed meanwhile, **one more** the processor time of a further solve in the same
process; heyoka compiles on several processors at once. What takes longer than {limit} is given up.
"""
HEAD_IN_SPACE = """\
## Run time against error in space

`python benchmarks/work_precision.py --space`, {measured}

Measured as above, {rounds} processes for each row; what takes longer than {limit} is given up. scipy, mpmath and heyoka go by the
equations that suit them best: vectors where they do, of the coin its tilt, nutation, precession and ω₃. **sympy Kane** derives its
own by `KanesMethod`: by a quaternion for the book, by Euler angles for the top and the coin. **MuJoCo** turns the book and the top on
a ball joint, whose quaternion is read; it has no joint for a coin that rolls, so a thin cylinder stands on a plane with friction
there, as stiff as its step allows. A solve of more than {slow} is not repeated: **one more** is then the first, with imports, as of Kane.
"""


def in_space(problems: Sequence[Problem]) -> bool:
    """Whether all of them are problems in space, which have a section of their own."""
    return {problem.name for problem in problems} <= {problem.name for problem in IN_SPACE}


def versions() -> str:
    """`scipy 1.17.1, …`, and what is not installed."""
    found = []
    for package in PACKAGES:
        try:
            found.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            found.append(f"{package} not installed: its rows are missing")
    return ", ".join(found)


def section(problems: Sequence[Problem], rows: Sequence[Row], rounds: int, pictures: Sequence[str]) -> str:
    """The whole section in Markdown: of problems in space where all of them are."""
    whole, form = (len(IN_SPACE), HEAD_IN_SPACE) if in_space(problems) else (len(IN_PLANE), HEAD)
    measured = f"{machine()}; {versions()}. Of {whole} problems {len(problems)} were run."
    head = form.format(measured=measured, rounds=rounds, limit=f"{LIMIT} s", slow=f"{SLOW} s")
    parts = [head, "### Targets\n", *targets(problems, rows), ""]
    parts += [f"![Run time against error]({name})\n" for name in pictures]
    parts.append("### All rows\n")
    for problem in problems:
        parts += [*table(problem, [row for row in rows if row.problem == problem.name]), ""]
    return "\n".join(parts)


def targets(problems: Sequence[Problem], rows: Sequence[Row]) -> Iterator[str]:
    """A table of all targets."""
    yield "| target | measured | met |"
    yield "| --- | --- | --- |"
    found = list(figures(problems, rows))
    for figure in found:
        yield f"| {figure.target} | {figure.figure} | {'yes' if figure.met else '**no**'} |"
    missed = [figure for figure in found if not figure.met and figure.why]
    if missed:
        yield "\nWhat keeps the others from being met:\n"
    yield from (f"- {figure.target}: {figure.why}." for figure in missed)


def table(problem: Problem, rows: Sequence[Row]) -> Iterator[str]:
    """The rows of a problem, folded."""
    known = ways(problem)
    with_drift = any(row.drift is not None for row in rows)
    yield f"<details><summary>{problem.title}</summary>\n"
    yield f"`{problem.scene}`{''.join(f' --set &quot;{text}&quot;' for text in problem.sets)}, in {problem.unit}.\n"
    if problem.left_out:
        yield f"Not here: {problem.left_out}.\n"
    yield f"| who | setting | error | claimed | whole process | clock | one more |{' drift |' if with_drift else ''}"
    yield f"| --- | --- | --- | --- | --- | --- | --- |{' --- |' if with_drift else ''}"
    for row in rows:
        start = f"| {row.peer} | {known[row.peer].setting} {row.setting} |"
        if row.failed:
            yield f"{start} {row.failed} | | | | |{' |' if with_drift else ''}"
            continue
        claimed = f"{max(row.bounds):.1e}" if row.bounds else ""
        times = " | ".join(milliseconds(seconds) for seconds in (row.cpu, row.wall, row.marginal))
        drift = f" {row.drift:.1e} |" if with_drift else ""
        yield f"{start} {row.error:.1e} | {claimed} | {times} |{drift}"
    yield "\n</details>"
