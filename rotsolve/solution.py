"""Solution: what `rotsolve.solve` returns, with its answers, steps and checks, and its printing in every format."""

from __future__ import annotations

import builtins
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.core.derivation import Answer, AnswerConfirmation, Check, Derivation, Refusal, Section
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import Fault, Unsolvable
from rotsolve.page.depth import DETAILS, FULL, NORMAL, NUMBERS, STEPS
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.formats import WIDTH, format_named
from rotsolve.page.languages import ENGLISH

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.derivation.meanings import Meanings
    from rotsolve.derivation.requirements import Validity
    from rotsolve.language.problem import Problem
    from rotsolve.search.acting import ActingWays


class Trace(Struct, frozen=True):
    """The stages before the derivation as text; each is made only when someone asks for it."""

    facts: Callable[[], str]
    equations: Callable[[], str]
    plan: Callable[[], str]
    validity: Callable[[], Validity] | None = None  # for which numbers the closed forms hold
    meanings: Callable[[], Meanings] | None = None  # what the letters of the scene stand for
    # the solution in letters of the case that some numbers are of, and the signs that it took
    case: Callable[[Mapping[str, Formula]], tuple[Solution, Mapping[Formula, int]]] | None = None
    idle: tuple[Fault, ...] = ()  # what the scene says and nothing has read
    acting: Callable[[], ActingWays | None] = lambda: None  # what tells which way forces act
    by_law: Callable[[str], Derivation] | None = None  # the same questions by another law
    letter: Callable[[str], Formula | float | None] | None = None  # what a letter of the laws is, if only aside
    # other roots for a letter of the scene, if only on the way
    others: Callable[[str], tuple[Formula, ...]] = lambda _: ()
    points: tuple[Mapping[str, Fraction], ...] = ()  # numbers of which letters the cases of the answers were found
    confirmation: Callable[[], tuple[AnswerConfirmation, ...]] | None = None  # what an assembly says of the answers


class AnswerView(Struct, frozen=True):
    """One answer, ready for use in Python. Numbers are in `unit`, signed in the declared sense."""

    answer: Answer
    digits: int = 4

    @property
    def name(self) -> str:
        """The name under `find`."""
        return self.answer.name

    @property
    def formula(self) -> Formula | None:
        """The exact form as a formula; None where there is no closed form."""
        return self.answer.formula

    @property
    def exact(self) -> str | None:
        """The exact form as a textbook prints it."""
        from rotsolve.algebra.notation.text import to_text

        return None if self.answer.formula is None else to_text(self.answer.formula)

    @property
    def value(self) -> str | None:
        """The number as text, every digit of it certified, as `-4.5e-05` where it is small; None without one."""
        from rotsolve.page.values import certified_digits, machine_number

        return machine_number(certified_digits(self.answer.value, self.digits)[0]) or None

    @property
    def float(self) -> builtins.float | None:
        """The number as a float."""
        return None if self.answer.value is None else self.answer.value.float

    @property
    def unit(self) -> str:
        """The unit of `value`, '' for a pure number."""
        return "" if self.answer.unit is None else self.answer.unit.text

    @property
    def direction(self) -> str:
        """The direction in words, '' where there is none."""
        return self.answer.direction

    @property
    def angle(self) -> builtins.float | None:
        """The angle of a slanted vector to the horizontal, in degrees; None of all else."""
        return None if self.answer.angle is None else self.answer.angle.float

    @property
    def conditions(self) -> tuple[str, ...]:
        """What letters have to fulfil for it to hold: ("P ≤ μ m g",)."""
        from rotsolve.algebra.notation.text import to_text

        sides = ((to_text(one.left), one.relation, to_text(one.right)) for one in self.answer.conditions)
        return tuple(map(" ".join, sides))

    @property
    def otherwise(self) -> tuple[AnswerView, ...]:
        """The answers under other conditions."""
        return tuple(AnswerView(other, self.digits) for other in self.answer.otherwise)

    @property
    def branches(self) -> tuple[AnswerView, ...]:
        """It and the answers under other conditions."""
        return self, *self.otherwise

    @property
    def word(self) -> str:
        """The answer to a question that asks for a word: "slips"."""
        return self.answer.word

    @property
    def components(self) -> Mapping[str, AnswerView]:
        """The parts of a vector answer by name: `v_x` and `v_y` of `v`."""
        return MappingProxyType({part.name: AnswerView(part, self.digits) for part in self.answer.components})

    @property
    def sympy(self) -> Any:
        """The exact form as a SymPy expression; SymPy is imported here."""
        from rotsolve.algebra.sympy_bridge import to_sympy

        return None if self.answer.formula is None else to_sympy(self.answer.formula)

    def __repr__(self) -> str:
        return f"<AnswerView {self}>"

    def __str__(self) -> str:
        from rotsolve.page.text import answer_text
        from rotsolve.page.values import answer_row

        return answer_text(answer_row(self.answer, self.digits))


class PictureView(Struct, frozen=True):
    """The picture of a scene at one of its states, the first unless another is named; drawn when it is asked for."""

    problem: Problem
    state: str = ""
    acting: Callable[[], ActingWays | None] = lambda: None

    def at(self, state: str) -> PictureView:
        """The same scene at another state."""
        return replace(self, state=state)

    @property
    def svg(self) -> str:
        """The scene as SVG."""
        from rotsolve.draw.paper.svg import svg
        from rotsolve.draw.pictures import scene_picture

        return svg(scene_picture(self.problem, self.state))

    @property
    def tikz(self) -> str:
        """The scene as a `tikzpicture`."""
        from rotsolve.draw.paper.tikz import tikz
        from rotsolve.draw.pictures import scene_picture

        return tikz(scene_picture(self.problem, self.state))

    @property
    def free_bodies(self) -> str:
        """The free-body diagrams as SVG: at the states of which the scene asks, unless another is named."""
        from rotsolve.draw.paper.svg import svg
        from rotsolve.draw.pictures import free_body_picture

        return svg(free_body_picture(self.problem, self.state, self.acting()))

    def _repr_svg_(self) -> str:
        return self.svg


class Solution(Struct, frozen=True, dict=True):
    """A solved scene: `print` it for the derivation, or take its parts."""

    problem: Problem
    derivation: Derivation
    trace: Trace
    digits: int = 4

    @cached_property
    def answers(self) -> Mapping[str, AnswerView]:
        """The answers by their names under `find`."""
        return MappingProxyType({answer.name: AnswerView(answer, self.digits) for answer in self.derivation.answers})

    @cached_property
    def refused(self) -> Mapping[str, Unsolvable]:
        """The questions without an answer by their names under `find`, each with its reason."""
        lines, file = self.problem.lines, self.problem.file
        told = {item.name: item.fault for item in self.derivation.refused}
        return MappingProxyType(
            {
                name: Unsolvable(fault.message, span=fault.span, help=fault.help, lines=lines, file=file)
                for name, fault in told.items()
            }
        )

    def complete(self) -> Solution:
        """The solution where every question has its answer; raises the reason of the first that has none."""
        for reason in self.refused.values():
            raise reason
        return self

    @property
    def steps(self) -> tuple[Section, ...]:
        """Forces, laws and algebra, one section for each instant, phase or event."""
        return self.derivation.sections

    @property
    def checks(self) -> tuple[Check, ...]:
        """What confirms the answers, or objects to them."""
        return self.derivation.checks

    def facts_text(self) -> str:
        """The facts that the elements of the scene state."""
        return self.trace.facts()

    def equations_text(self) -> str:
        """All equations that the laws give."""
        return self.trace.equations()

    def plan_text(self) -> str:
        """The equations that were chosen, and for which unknowns."""
        return self.trace.plan()

    def confirmation_text(self) -> str:
        """Each answer with its number and that of the assembly that confirms or contradicts it."""
        from rotsolve.confirm.verdicts import confirmation_lines

        return confirmation_lines(() if self.trace.confirmation is None else self.trace.confirmation())

    def evaluate_many(
        self, values: Mapping[str, Any], *, certified: bool = False, as_decided: bool = False
    ) -> dict[str, Any]:
        """The answers for many sets of givens at once, by NumPy: `values` are numbers or arrays in SI units, by the givens' names.

        Givens that are left out keep their values. Results are in the answers' units, NaN where a string would go slack, a contact
        open, or a sign on which the scene hangs be another. `certified` gives pairs of arrays, values and bounds on their errors. Where the
        numbers have decided more (what slips, which root is meant) each set is answered by the case that it is of, unless all are to be
        answered `as_decided` by those of the scene. Else some of the sets, the smallest and largest among them, are held against the
        assembly of all bodies' equations: NotForMany with the set where it contradicts one, or with which no such scene can be.
        """
        from rotsolve.arrays import NotForMany, evaluate_many

        valid = None if self.trace.validity is None else self.trace.validity()
        if valid is None:
            raise NotForMany("how the answers were found is not known: solve the scene again")
        if as_decided:
            return evaluate_many(self.derivation.answers, self.problem.givens, valid, values, certified)
        if self.trace.case is not None and (valid.decided or self.by_cases):
            from rotsolve.arrays.cases import evaluate_by_cases

            found = evaluate_by_cases(self.trace.case, self.problem.givens, valid, values, certified)
        else:
            found = evaluate_many(self.derivation.answers, self.problem.givens, valid, values, certified)
        from rotsolve.arrays.held import hold_sets

        numbers = {name: result[0] for name, result in found.items()} if certified else found
        hold_sets(self.problem, self.derivation.answers, self.trace.letter, values, numbers)
        return found

    @property
    def by_cases(self) -> bool:
        """Whether an answer holds under conditions."""
        return any(answer.conditions for answer in self.derivation.answers)

    @property
    def page(self) -> DerivationPage:
        """The derivation as blocks that a format prints."""
        return self.page_with()

    def page_with(self, *, pictures: bool = False, detail: str = NORMAL, numbers: str = STEPS) -> DerivationPage:
        """The derivation as blocks, with as much of it and as many numbers as is asked for."""
        if detail not in DETAILS or numbers not in NUMBERS:
            raise ValueError(f"detail is one of {', '.join(DETAILS)}, and numbers one of {', '.join(NUMBERS)}")
        file = getattr(self.problem, "file", "")
        page = DerivationPage(self.derivation, self.digits, file, scene=self.problem, detail=detail, numbers=numbers)
        others = tuple(self.other_ways()) if detail == FULL else ()
        return replace(page, pictured=self.problem if pictures else None, others=others)

    def other_ways(self) -> Iterator[tuple[str, Derivation]]:
        """The same questions by each law by which a check has found the same, with what that law is called."""
        for check in self.derivation.checks:
            if check.law and check.holds and self.trace.by_law is not None:
                with suppress(Unsolvable):
                    yield FAMILIES[check.law].words, self.trace.by_law(check.law)

    def body(
        self,
        format: str = "text",
        *,
        width: int | None = None,
        pictures: bool = True,
        language: str = ENGLISH,
        detail: str = NORMAL,
        numbers: str = STEPS,
    ) -> str:
        """The derivation as it stands within a larger document: 'text', 'markdown', 'latex', 'typst', 'html' or 'json'.

        In LaTeX (with the packages amsmath and tikz), Typst and HTML with the picture of the scene, unless without `pictures`. `detail`
        may be 'brief' (laws and answers), 'normal' or 'full' (the way of a second law too), `numbers` 'none', 'results' or 'steps'. The
        `language` is English, or that of another table ('de').
        """
        page = self.page_with(pictures=pictures, detail=detail, numbers=numbers)
        return format_named(format, language).body(page, width or WIDTH)

    def to(self, format: str = "text", *, language: str = ENGLISH, **told: Any) -> str:
        """The derivation as a complete document: 'text', 'markdown', 'latex', 'typst', 'html' or 'json'; a PDF is made by `pdf`. All else
        is as for `body`."""
        if format_named(format).binary:
            raise ValueError(f"a {format} document is no text: `{format}()` gives its bytes")
        return format_named(format, language).document([self.body(format, language=language, **told)])

    def pdf(self, *, language: str = ENGLISH, **told: Any) -> bytes:
        """The derivation as a PDF, with the package typst; with what may be said for `body`."""
        content = format_named("pdf", language).file([self.body("pdf", language=language, **told)])
        assert isinstance(content, bytes)
        return content

    @property
    def picture(self) -> PictureView:
        """The picture of the scene, which a notebook shows."""
        return PictureView(self.problem, acting=self.trace.acting)

    def __repr__(self) -> str:
        return f"<Solution of {self.derivation.title!r}: {', '.join(self.answers)}>"

    def __str__(self) -> str:
        return self.to("text").rstrip("\n")

    def _repr_html_(self) -> str:
        return self.body("html")

    def _repr_markdown_(self) -> str:
        return self.to("markdown")

    def _repr_latex_(self) -> str:
        return self.body("latex", pictures=False)


def with_refused(refused: Iterable[Refusal], problem: Problem, solution: Solution) -> Solution:
    """The solution for some questions of a problem, and why it has no answer to the others."""
    finds = tuple(dict.fromkeys((Symbol(find.group),) for find in problem.finds))
    told = (*solution.derivation.refused, *refused)
    return replace(solution, problem=problem, derivation=replace(solution.derivation, refused=told, finds=finds))
