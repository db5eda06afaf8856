"""Solution: what `rotsolve.solve` returns, with its answers, steps and checks, and its printing in every format."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import cached_property, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import AnswerConfirmation, Check, Derivation, Refusal, Section
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import Fault, Unsolvable, missing_package
from rotsolve.language.words import hint
from rotsolve.page.depth import DETAILS, FULL, NORMAL, NUMBERS, STEPS
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.formats import WIDTH, format_named
from rotsolve.page.languages import ENGLISH

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.arrays import ManyAnswers
    from rotsolve.derivation.meanings import Meanings
    from rotsolve.derivation.requirements import Validity
    from rotsolve.language.problem import Problem
    from rotsolve.search.acting import ActingWays
    from rotsolve.solution.answer import AnswerView
    from rotsolve.solution.picture import PictureView
    from rotsolve.solution.symbols import Symbols


class Trace(Struct, frozen=True):
    """The stages before the derivation as text; each is made only when someone asks for it."""

    facts: Callable[[], str]
    equations: Callable[[], str]
    plan: Callable[[], str]
    validity: Callable[[], Validity] | None = None  # for which numbers the closed forms hold
    meanings: Callable[[], Meanings] | None = None  # what the letters of the scene stand for
    anew: Callable[[Mapping[str, str], str | None], Resolved] | None = None  # with other values, at another time
    idle: tuple[Fault, ...] = ()  # what the scene says and nothing has read
    acting: Callable[[], ActingWays | None] = lambda: None  # what tells which way forces act
    by_law: Callable[[str], Derivation] | None = None  # the same questions by another law
    letter: Callable[[str], Formula | float | None] | None = None  # what a letter of the laws is, if only aside
    # other roots for a letter of the scene, if only on the way
    others: Callable[[str], tuple[Formula, ...]] = lambda _: ()
    points: tuple[Mapping[str, Fraction], ...] = ()  # numbers of which letters the cases of the answers were found
    confirmation: Callable[[], tuple[AnswerConfirmation, ...]] | None = None  # what an assembly says of the answers
    again: Callable[[], Solution] | None = None  # the same solution, found once more

    def __reduce__(self) -> tuple[Any, ...]:
        """What pickling keeps: how the scene is solved again, which is done when one of the stages is asked for."""
        if self.again is None:
            raise TypeError("only a whole solution can be pickled, as `rotsolve.solve` gives it")
        told = {name: getattr(self, name) for name in self.__struct_fields__}
        late = tuple(name for name, value in told.items() if name in LATE and value is not None)
        return trace_again, (self.again, late, {name: told[name] for name in KEPT})


KEPT = ("idle", "points", "again", "anew")
LATE = ("acting", "facts", "equations", "plan", "validity", "meanings", "by_law", "letter", "others", "confirmation")


def trace_again(again: Callable[[], Solution], late: Iterable[str], kept: Mapping[str, Any]) -> Trace:
    """The stages of a solution that has been pickled: it is solved again when one of them is asked for."""
    found: list[Trace] = []

    def stage(name: str, *given: Any) -> Any:
        if not found:
            found.append(again().trace)
        return getattr(found[0], name)(*given)

    made: dict[str, Any] = {**kept, **{name: partial(stage, name) for name in late}}
    return Trace(**made)


class Resolved(Struct, frozen=True):
    """A scene solved again with other values: its solution, or `why` it has none; of what numbers were `asked` on the way.

    Where more than signs of numbers has decided something it is `by_size`: other numbers of the same signs may decide otherwise.
    """

    solution: Solution | None
    why: str
    asked: tuple[Formula, ...]
    by_size: bool


class Solution(Struct, frozen=True, dict=True, eq=False):
    """A solved scene: `print` it for the derivation, take its answers by their names, `solution["a"]`, or its parts.

    Two are equal where they answer the same problem with the same. It can be pickled: the answers and the derivation travel, what comes
    before them is worked out again where it is asked for.
    """

    problem: Problem
    derivation: Derivation
    trace: Trace
    digits: int = 4

    @cached_property
    def answers(self) -> Mapping[str, AnswerView]:
        """The answers by their names under `find`."""
        from rotsolve.solution.answer import AnswerView

        letters = tuple(given.name for given in self.problem.givens)
        return MappingProxyType(
            {answer.name: AnswerView(answer, self.digits, letters) for answer in self.derivation.answers}
        )

    def __getitem__(self, name: str) -> AnswerView:
        """The answer of a name, `alpha` or `α`; raises the reason of a question that has none, KeyError where there is no such question."""
        if name in self.answers:
            return self.answers[name]
        meant = {printed: own for own in (*self.answers, *self.refused) for printed in (own, name_to_text(own))}
        if meant.get(name) in self.refused:
            raise self.refused[meant[name]]
        if name not in meant:
            raise KeyError(f"nothing is asked by the name `{name}`: {hint(name, tuple(self.answers), 'answers')}")
        return self.answers[meant[name]]

    def __iter__(self) -> Iterator[str]:
        return iter(self.answers)

    def __len__(self) -> int:
        return len(self.answers)

    def __contains__(self, name: object) -> bool:
        return name in self.answers

    def keys(self) -> Iterable[str]:
        """The names of the answers."""
        return self.answers.keys()

    def values(self) -> Iterable[AnswerView]:
        """The answers."""
        return self.answers.values()

    def items(self) -> Iterable[tuple[str, AnswerView]]:
        """The answers with their names."""
        return self.answers.items()

    @cached_property
    def symbols(self) -> Symbols:
        """The letters of the scene as SymPy has them, `solution.symbols.m`; SymPy is imported when one is asked for."""
        from rotsolve.motion.positive import positive_letters
        from rotsolve.solution.symbols import Symbols

        made = (
            part.closed or part.formula for answer in self.derivation.answers for part in (answer, *answer.components)
        )
        letters = (name for form in made if form is not None for name in sorted(form.symbols()))
        names = dict.fromkeys((*(given.name for given in self.problem.givens), *letters))
        return Symbols(names, positive_letters(self.problem.givens))

    def to_frame(self) -> Any:
        """The answers as a table of pandas, a row for each, of vectors and tensors a row for each part, `L.x`."""
        from rotsolve.solution.frames import frame_of_answers

        return frame_of_answers(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solution):
            return NotImplemented
        mine, theirs = ((one.problem, one.digits, dict(one.answers), list(one.refused)) for one in (self, other))
        return mine == theirs

    def __hash__(self) -> int:
        return hash((self.problem.lines, self.problem.settings, self.digits, tuple(self.answers.values())))

    def __deepcopy__(self, _: Any) -> Solution:
        return self

    def __dask_tokenize__(self) -> tuple[Any, ...]:
        return "rotsolve", self.problem.lines, self.problem.settings, self.digits, tuple(map(str, self.values()))

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
    ) -> ManyAnswers:
        """The answers for many sets of givens at once, by NumPy: `values` are numbers or arrays in SI units, by the givens' names.

        Givens that are left out keep their values. Each set gets what solving the scene for it gives: the arrays, by the answers' names
        and in their units, hold NaN where that is no number, and `reasons` of what comes back says why. `certified` gives pairs of arrays,
        values and bounds on their errors. Arrays of dask give arrays of dask. `as_decided` takes the closed forms of this solution for all
        sets, without a look at what its numbers have decided. A table of pandas does for `values`, its columns being the givens. Raises
        NotForMany where no set has an answer, a name is that of no given, or numbers are complex.
        """
        from rotsolve.arrays import NotForMany

        if self.trace.anew is None or self.trace.validity is None:
            raise NotForMany("how the answers were found is not known: solve the scene again")
        try:
            from rotsolve.arrays.many import answers_as_decided, answers_of_sets, real_numbers
        except ModuleNotFoundError:
            raise missing_package("arrays take", "NumPy", "arrays") from None
        own = {name: real_numbers(name, values[name]) for name in values}
        return (answers_as_decided if as_decided else answers_of_sets)(self, own, certified)

    @cached_property
    def cases(self) -> dict[frozenset[str], list[Any]]:
        """What has been solved for sets of other values, by the names of these."""
        return {}

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
        from rotsolve.solution.picture import PictureView

        return PictureView(self.problem, acting=self.trace.acting)

    def __repr__(self) -> str:
        return f"<Solution of {self.derivation.title!r}: {', '.join(self.answers)}>"

    def __str__(self) -> str:
        return self.to("text").rstrip("\n")

    def _repr_html_(self) -> str:
        from rotsolve.page.html_rows import notebook_piece

        return notebook_piece(self.body("html"))

    def _repr_markdown_(self) -> str:
        return self.to("markdown")

    def _repr_latex_(self) -> str:
        return self.body("latex", pictures=False)


def with_refused(refused: Iterable[Refusal], problem: Problem, solution: Solution) -> Solution:
    """The solution for some questions of a problem, and why it has no answer to the others."""
    finds = tuple(dict.fromkeys((Symbol(find.group),) for find in problem.finds))
    told = (*solution.derivation.refused, *refused)
    return replace(solution, problem=problem, derivation=replace(solution.derivation, refused=told, finds=finds))
