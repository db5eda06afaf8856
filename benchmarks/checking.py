"""What it costs to judge a line of a student, once the scene is solved: reading it in all ways, and the verdict; and papers in a stream.

    python benchmarks/checking.py [--lines N] [--seed S] [--papers N] [--write]

Lines are made from the answers of every fourth bundled problem: rewritten right forms, forms with a slip, lines that can be read in two
ways, numbers with units; no answer has a line twice. All times are processor times. `--papers` is how many are marked
in a stream, after a tenth as many, by this process and by one and two workers; 0 leaves that out. `--write` puts the tables into
docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import gc
import time
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path
from random import Random
from statistics import mean

from costs.streams import stream_page
from costs.tables import share, table
from report import machine, write_section
from rotsolve import solve
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ELLIPTIC, Formula, Integral, Number, Power, Product, Quotient, Sum, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.typeset import to_latex
from rotsolve.core.symbols import TIME
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.marking.target import Target
from rotsolve.process import GARBAGE

PROBLEMS = Path(__file__).resolve().parent.parent / "problems"
EACH = 4  # of so many problem files, one is taken
WANTED = 200  # µs for a line
WHY = (
    "not met: what is not right as it stands is looked at in other ways before it is called wrong: with units in it, with numbers in place "
    "of letters, for the signs of the scene's own numbers, with the other sign"
)
STYLES: tuple[Callable[[Formula], str], ...] = (
    to_text,
    to_latex,
    lambda formula: to_text(formula, unicode=False),
    lambda formula: to_text(formula).replace(" + ", "+").replace(" − ", "-").replace(") (", ")("),
)


class Subject:
    """One answer of a scene, with its judge."""

    def __init__(self, closed: Formula, unit: str, judge: Judge, target: Target) -> None:
        self.closed, self.unit, self.judge, self.target = closed, unit, judge, target
        self.letters = frozenset((*judge.letters.givens, *judge.letters.told))


LONGEST = 300  # nodes of a formula that somebody types: of longer ones the judge says that it can't decide


@cache
def subjects() -> tuple[Subject, ...]:
    """The answers with a closed form of all scenes."""
    found = []
    for file in sorted(PROBLEMS.glob("*/*.yaml"))[::EACH]:
        solution = solve(file)
        judge = Judge(solution)
        for answer in solution.derivation.answers:
            closed = judge.letters.closed.get(answer.name)
            # of these "can't decide" is said, however they are written
            elliptic = closed is not None and closed.holds(*ELLIPTIC, Integral)
            if closed is not None and closed.symbols() and length(closed) <= LONGEST and not elliptic:
                unit = "" if answer.unit is None else answer.unit.text
                typed = closed.substitute({TIME: Symbol(judge.letters.meanings.time)})  # t, as it is printed
                found.append(Subject(typed, unit, judge, judge.targets[answer.name]))
    return tuple(found)


def mixed(formula: Formula, random: Random) -> Formula:
    """The formula with its terms and factors in another order."""
    children = [mixed(child, random) for child in formula.children()]
    if isinstance(formula, (Sum, Product)):
        random.shuffle(children)
        children.sort(key=lambda child: not isinstance(child, Number))  # nobody writes m 2
        return Sum(tuple(children)) if isinstance(formula, Sum) else Product(tuple(children))
    return formula.with_children(tuple(children)) if children else formula


def right(subject: Subject, random: Random) -> str:
    """An equivalent form: in another order, perhaps with a fraction that is not cancelled or a power in place of it."""
    form = mixed(subject.closed, random)
    factor = Number(Fraction(random.randint(2, 9)))
    if isinstance(form, Quotient) and random.random() < 0.5:
        form = Quotient(Product((factor, form.numerator)), Product((factor, form.denominator)))
    if isinstance(form, Quotient) and random.random() < 0.2:
        form = Product((form.numerator, Power(form.denominator, Number(Fraction(-1)))))
    return random.choice(STYLES)(form)


def wrong(subject: Subject, random: Random) -> str:
    """A form with a slip in it: a factor too many."""
    form = mixed(subject.closed, random)
    slip = random.choice([Number(Fraction(random.randint(2, 9))), *map(Symbol, sorted(form.symbols()))])
    return random.choice(STYLES)(Product((slip, form)))


def two_ways(subject: Subject, random: Random) -> str:
    """A form whose brackets are left out: 1/2 in front, or a product below a slash."""
    letters = sorted(name for name in subject.letters if name.isalpha() and len(name) == 1)
    chosen = random.choices(letters or ["π"], k=random.randint(1, 3))
    product = "".join(sorted(chosen, reverse=True))  # so that they are no tan
    return f"{random.randint(1, 999)}/{random.randint(2, 999)}{product}^2"


def quantity(subject: Subject, random: Random) -> str:
    """A number in the unit of the answer."""
    return f"{random.uniform(0.1, 99):.{random.randint(2, 6)}f} {subject.unit}".strip()


KINDS: dict[str, Callable[[Subject, Random], str]] = {
    "right formula": right,
    "wrong formula": wrong,
    "two readings": two_ways,
    "number with unit": quantity,
}


def judged(text: str, subject: Subject) -> float:
    """The microseconds for one line."""
    start = time.process_time()
    subject.judge.texts.judged(subject.target, text)
    return (time.process_time() - start) * 1e6


def measured(kind: str, asked: Sequence[Subject], lines: int, seed: int) -> list[float]:
    """The times of so many different lines of one kind."""
    random, seen = Random(f"{kind} {seed}"), set[tuple[int, str]]()
    spent: list[float] = []
    for index in range(4 * lines):
        place = index % len(asked)
        text = KINDS[kind](asked[place], random)
        if (place, text) not in seen and len(spent) < lines:
            seen.add((place, text))
            spent.append(judged(text, asked[place]))
    return spent


def page(lines: int, seed: int) -> str:
    """The section with its table."""
    asked = list(subjects())
    for kind in KINDS:  # what is worked out once for a scene, and what is imported late
        measured(kind, asked, 3 * len(asked), seed + 1)
    found = {kind: measured(kind, asked, lines, seed) for kind in KINDS}
    found["all of them"] = [one for times in found.values() for one in times]
    rows = [
        (kind, str(len(times)), *(f"{value:.0f}" for value in (mean(times), share(times, 0.5), share(times, 0.9))))
        for kind, times in found.items()
    ]
    average = mean(found["all of them"])
    return "\n\n".join(
        (
            "## Checking",
            f"`python benchmarks/checking.py`, {machine()}",
            "Processor time for the verdict on one line, once the scene is solved, in µs; no answer has a line twice.",
            table(("lines", "number", "mean", "half below", "90 % below"), rows),
            f"A line takes {average:.0f} µs; {WANTED} were wanted, which is {'met' if average <= WANTED else WHY}.",
        )
    )


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="What it costs to judge a line.")
    parser.add_argument("--lines", type=int, default=2000, help="lines of each kind, 0 for none (2000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--papers", type=int, default=20_000, help="papers in a stream, 0 for none (20000)")
    parser.add_argument("--write", action="store_true", help="put the tables into docs/benchmarks.md")
    told = parser.parse_args()
    gc.set_threshold(GARBAGE)  # as in the command
    sections = {"checking": page(told.lines, told.seed)} if told.lines else {}
    if told.papers:
        sections["papers"] = stream_page(told.papers // 10, told.papers)
    for name, text in sections.items():
        print(text, end="\n\n")
        if told.write:
            write_section(name, text)


if __name__ == "__main__":
    main()
