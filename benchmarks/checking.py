"""What it costs to judge a line of a student, once the scene is solved: reading it in all ways, and the verdict; of a wrong line, also to
look for its mistake; and papers in a stream.

    python benchmarks/checking.py [--lines N] [--each N] [--seed S] [--papers N] [--write]

Lines are made from the answers of every fourth bundled problem: rewritten right forms, forms with a slip, lines that can be read in two
ways, numbers with units; no answer has a line twice. Wrong lines are marked as those of a class: answers with a known mistake in them,
formulas with a slip, wrong numbers; the first of a problem pays for the search that all others share. All times are processor times.
`--papers` is how many are marked in a stream, after a tenth as many, by this process and by one and two workers; 0 leaves that out,
as `--lines 0` does all else. `--write` puts the tables into docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import gc
import time
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache, cached_property
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
from rotsolve.grading.marking.explaining import Explaining
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.marking.target import Target
from rotsolve.grading.mistakes.wrong_answers import Wrong
from rotsolve.grading.verdict import Paper
from rotsolve.start import GARBAGE

PROBLEMS = Path(__file__).resolve().parent.parent / "problems"
EACH = 4  # of so many problem files, one is taken
WANTED = 200  # µs for a line
WANTED_WRONG = 20  # ms for nine in ten wrong lines of a class
LONG = 10**6  # characters of a line that nobody means
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

    @cached_property
    def mistaken(self) -> list[Wrong]:
        """The mistakes of the scene with the answers that they give."""
        return list(Explaining(self.judge.letters).wrong_answers)


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
    """A form whose brackets are left out: a product below a slash."""
    letters = sorted(name for name in subject.letters if name.isalpha() and len(name) == 1)
    chosen = random.choices(letters or ["π"], k=random.randint(1, 3))
    product = "".join(sorted(chosen, reverse=True))  # so that they are no tan
    return f"{random.randint(2, 999)} {random.choice(letters or ['π'])}/{random.randint(2, 999)}{product}^2"


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


# wrong lines


def slip_of_power(subject: Subject, random: Random) -> str:
    """A product of powers of the letters of an answer, as if it had been guessed."""
    letters = sorted(subject.closed.symbols())
    return " ".join(
        f"{name}^{random.choice([-1, 1, 2])}" for name in random.sample(letters, random.randint(1, len(letters)))
    )


def with_mistake(subject: Subject, random: Random, as_number: bool) -> str:
    """An answer to the scene with one of the known mistakes in it; where there is none, a slip."""
    found = [answers[subject.target.name] for _, answers in subject.mistaken if subject.target.name in answers]
    if as_number:
        numbers = [
            f"{one.value.float:.5g} {one.unit.text if one.unit else ''}" for one in found if one.value is not None
        ]
        return random.choice(numbers or [quantity(subject, random)])
    forms = [one.closed for one in found if one.closed is not None and length(one.closed) <= LONGEST]
    return random.choice(STYLES)(random.choice(forms)) if forms else wrong(subject, random)


WRONG_KINDS: dict[str, Callable[[Subject, Random], str]] = {
    "mistake, formula": lambda subject, random: with_mistake(subject, random, False),
    "mistake, number": lambda subject, random: with_mistake(subject, random, True),
    "slip in a formula": wrong,
    "guessed formula": slip_of_power,
    "wrong number": quantity,
}


def class_of(asked: Sequence[Subject], each: int, random: Random) -> list[tuple[str, Subject, str]]:
    """The wrong lines of a class that has one problem to do, with their kinds, in any order; none twice."""
    lines = {
        (subject.target.name, text): (kind, subject, text)
        for kind, made in WRONG_KINDS.items()
        for subject in asked
        for text in (made(subject, random) for _ in range(each))
    }
    handed = list(lines.values())
    random.shuffle(handed)
    return handed


def marked_class(asked: Sequence[Subject], each: int, random: Random) -> list[tuple[str, float]]:
    """The kinds of the wrong lines of a class with the milliseconds that each took; of the first one, with the search that all share."""
    handed = class_of(asked, each, random)
    judge = Judge(asked[0].judge.letters.solution)
    judge.texts.targets  # noqa: B018 -- what right lines need too
    times = []
    for place, (kind, subject, text) in enumerate(handed):
        start = time.process_time()
        judge.mark(Paper("", {subject.target.name: text}))
        times.append((kind if place else "first of its problem", (time.process_time() - start) * 1e3))
    return times


def each_first(asked: Sequence[Subject], random: Random) -> list[float]:
    """The milliseconds of a wrong line of each kind for one answer, each as if it were the first of its problem."""
    times = []
    for _, subject, text in class_of([random.choice(asked)], 1, random):
        judge = Judge(subject.judge.letters.solution)
        judge.texts.targets  # noqa: B018 -- what right lines need too
        start = time.process_time()
        judge.mark(Paper("", {subject.target.name: text}))
        times.append((time.process_time() - start) * 1e3)
    return times


def of_long_line(subject: Subject) -> float:
    """The milliseconds for a paper with an answer and a line of working of a million characters."""
    text = "m g + " * (LONG // 6)
    start = time.process_time()
    subject.judge.mark(Paper("", {subject.target.name: text}, (text,)))
    return (time.process_time() - start) * 1e3


def wrong_page(each: int, seed: int) -> str:
    """The section on wrong lines."""
    random = Random(f"wrong {seed}")
    by_scene: dict[int, list[Subject]] = {}
    for subject in subjects():
        by_scene.setdefault(id(subject.judge), []).append(subject)
    first = next(iter(by_scene.values()))
    marked_class(first, each, Random(0))  # what is imported late
    found: dict[str, list[float]] = {}
    for asked in by_scene.values():
        for kind, spent in marked_class(asked, each, random):
            found.setdefault(kind, []).append(spent)
    found["all of them"] = [one for times in found.values() for one in times]
    found["each as the first"] = [one for asked in by_scene.values() for one in each_first(asked, random)]
    rows = [
        (kind, str(len(times)), *(f"{value:.1f}" for value in (share(times, 0.5), share(times, 0.9), max(times))))
        for kind, times in found.items()
    ]
    slowest = share(found["all of them"], 0.9)
    return "\n\n".join(
        (
            "## Wrong lines",
            f"`python benchmarks/checking.py`, {machine()}",
            f"Processor time to mark a wrong answer and to look for its mistake, in ms, for {len(by_scene)} problems.",
            table(("lines", "number", "half below", "90 % below", "most"), rows),
            f"Nine in ten take no more than {slowest:.1f} ms; {WANTED_WRONG} were wanted, which is "
            f"{'met' if slowest <= WANTED_WRONG else 'not met'}. A paper with an answer and a line of working of a million "
            f"characters takes {of_long_line(first[0]):.1f} ms.",
        )
    )


# the page


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
    parser.add_argument("--each", type=int, default=6, help="wrong lines of each kind for each answer (6)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--papers", type=int, default=20_000, help="papers in a stream, 0 for none (20000)")
    parser.add_argument("--write", action="store_true", help="put the tables into docs/benchmarks.md")
    told = parser.parse_args()
    gc.set_threshold(GARBAGE)  # as in the command
    sections = (
        {"checking": f"{page(told.lines, told.seed)}\n\n{wrong_page(told.each, told.seed)}"} if told.lines else {}
    )
    if told.papers:
        sections["papers"] = stream_page(told.papers // 10, told.papers)
    for name, text in sections.items():
        print(text, end="\n\n")
        if told.write:
            write_section(name, text)


if __name__ == "__main__":
    main()
