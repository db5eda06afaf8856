"""Working: equations that a student writes on the way, each held against the scene's solution.

A line is right where it holds with what the letters stand for there, and says something; a chain a = b = c is as many equations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import combinations, islice, pairwise, product

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import RealBalls, Undefined
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import ZERO, Formula, Negative, Sum, Symbol, negate
from rotsolve.algebra.notation.letters import spellings
from rotsolve.algebra.units.dimension import Dimension, DimensionError, describe, dimension_of
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.formulas import NUMBERS_ALONE, letters_put_in, worth_the_same
from rotsolve.grading.comparing.scalars import Same
from rotsolve.grading.marking.explaining import Explaining, mistake_finding
from rotsolve.grading.marking.target import SceneLetters
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.definitions import Defined, definition, is_introduced, without_introduction
from rotsolve.grading.reading.everyday import everyday, without_head
from rotsolve.grading.reading.lines import with_plain_numbers
from rotsolve.grading.reading.near import with_near
from rotsolve.grading.reading.records import EQUATION, AnswerError, LineReading, Names
from rotsolve.grading.reading.tokens import MAX_LENGTH, plain_width
from rotsolve.grading.verdict import (
    RIGHT,
    UNDECIDED,
    WRONG,
    Finding,
    JudgedLine,
    Remark,
    Verdict,
    all_findings,
    found,
    listed_letters,
)
from rotsolve.language.marks import ALL, marking_of

USUAL = 0.01  # the share by which the two sides of a line with decimals may differ, where the tolerance is no share
DECIMAL = re.compile(r"\d[.,]\d")
NAME = re.compile(r"[^\W\d_]\w*")
BETWEEN = re.compile(  # statements of a line
    r"[()\[\]{}]|;|=>|[-–]+>|[→⇒⟹⟶∴]|\\(?:Rightarrow|rightarrow|implies|to|therefore)(?![A-Za-z])|,(?=\s)|,?\s(?:so|hence|thus|therefore|and|also|und)\s"
)
MOST_STATES = 24  # ways in which the letters of a line are meant at one state or another
MOST_SENSES = 6  # of positive directions that are tried the other way, one or two at a time


class Context(Struct, frozen=True):
    """What a student's letters mean beside the scene's: those brought in on the way, and the motions that are counted the other way."""

    defined: tuple[tuple[str, Formula], ...] = ()
    turned: frozenset[str] = frozenset()


PLAIN = Context()


class WorkingJudge:
    """Judges lines of working; each text once in a context."""

    def __init__(self, letters: SceneLetters, answers: frozenset[str], same: Same, explaining: Explaining) -> None:
        self.letters = letters
        self.answers = answers
        self.same = same
        self.explaining = explaining

    def lines(self, texts: tuple[str, ...]) -> tuple[JudgedLine, ...]:
        """The verdict on each line; the first wrong one is marked. Lines that hold when some motion is counted the other way throughout
        are right."""
        verdicts = self.verdicts(texts, frozenset())
        if any(verdict.outcome == WRONG for verdict in verdicts):
            verdicts = self.by_own_senses(texts) or self.by_own_letters(texts) or verdicts
        first = next((index for index, verdict in enumerate(verdicts) if verdict.outcome == WRONG), None)
        return tuple(
            JudgedLine(text, verdict, index == first)
            for index, (text, verdict) in enumerate(zip(texts, verdicts, strict=True))
        )

    def by_own_senses(self, texts: tuple[str, ...]) -> list[Verdict] | None:
        """The verdicts with the positive directions by which no line is wrong; None where there are none such."""
        words = {word for text in texts if len(text) <= MAX_LENGTH for word in NAME.findall(text)}
        senses = dict.fromkeys(
            sense for word in sorted(words) for name in self.meant(word) if (sense := self.letters.meanings.sense(name))
        )
        for count in (1, 2):
            for turned in islice(combinations(senses, count), MOST_SENSES):
                verdicts = self.verdicts(texts, frozenset(turned))
                if not any(verdict.outcome == WRONG for verdict in verdicts):
                    said = f"with your own positive direction of {' and '.join(sense.split()[0] for sense in turned)}"
                    remark = Remark("sign", (said,))
                    return [
                        replace(one, remarks=(*one.remarks, remark)) if one.outcome == RIGHT else one
                        for one in verdicts
                    ]
        return None

    def by_own_letters(self, texts: tuple[str, ...]) -> list[Verdict] | None:
        """The verdicts with moments of inertia as the lines define them, I for that of the whole; None where a line is wrong with these
        too, or none is right by them."""
        own = tuple(one for one in self.own_letters(texts) if one[1] in self.letters.constants)
        verdicts = self.verdicts(texts, frozenset(), own) if own else []
        used = any(
            verdict.outcome == RIGHT and any(index < place and self.speaks_of(text, name) for index, name, _ in own)
            for place, (text, verdict) in enumerate(zip(texts, verdicts, strict=False))
        )
        return verdicts if used and not any(verdict.outcome == WRONG for verdict in verdicts) else None

    def speaks_of(self, text: str, name: str) -> bool:
        return any(name in spellings(word) for word in NAME.findall(text))

    def verdicts(
        self, texts: tuple[str, ...], turned: frozenset[str], own: tuple[tuple[int, str, Formula], ...] = ()
    ) -> list[Verdict]:
        """The verdict on each line, letters that a line brings in being known from there on; `own` are letters of the scene that mean
        what the lines say."""
        found, defined = list[Verdict](), (*self.definitions(texts), *own)
        for count, text in enumerate(texts):
            known = tuple((name, form) for index, name, form in defined if index < count)
            brings = next(((name, form) for index, name, form in defined if index == count), None)
            found.append(self.verdict(text, Context((*known, brings) if brings else known, turned)))
            if brings is not None and "=" not in text.partition("=")[2]:
                remark = Remark("defined", (Symbol(brings[0]), " is taken as what you say"))
                found[-1] = Verdict(UNDECIDED, "", (remark,))
        return found

    @remembered
    def definitions(self, texts: tuple[str, ...]) -> tuple[tuple[int, str, Formula], ...]:
        """The letters that the lines bring in: in which line, and what they stand for in letters of the scene."""
        found: list[tuple[int, str, Formula]] = []
        for index, text in enumerate(texts):
            if len(text) > MAX_LENGTH:
                continue
            told = definition(plain_width(text), self.names(tuple(name for _, name, _ in found)))
            if told is not None:
                found.append((index, told[0], told[1].substitute({name: form for _, name, form in found})))
        return tuple(found)

    @remembered
    def own_letters(self, texts: tuple[str, ...]) -> tuple[tuple[int, str, Formula], ...]:
        """The letters of the scene that the lines define: moments of inertia, and givens for which a word says so, `let M = 0`."""
        defined = self.definitions(texts)
        names, put = self.names(tuple(name for _, name, _ in defined)), {name: form for _, name, form in defined}
        found: list[tuple[int, str, Formula]] = []
        for index, text in enumerate(texts):
            own = self.letters.constants | (self.letters.givens if is_introduced(text) else frozenset())
            told = None
            if own and len(text) <= MAX_LENGTH:
                told = definition(plain_width(text), names, own, self.letters.dimensions)
            if told is not None and told[0] in own:
                found.append((index, told[0], told[1].substitute(put)))
        return tuple(found)

    def defined(self, texts: tuple[str, ...]) -> tuple[Defined, Defined]:
        """The letters that the lines define: the student's own, and those of the scene."""
        both = (self.definitions(texts), self.own_letters(texts)) if texts else ((), ())
        brought, own = (tuple((name, form) for _, name, form in found) for found in both)
        return brought, own

    @remembered
    def verdict(self, text: str, context: Context = PLAIN) -> Verdict:
        long = AnswerError.of_length(text)
        if long is not None:
            return Verdict(UNDECIDED, "", (Remark("reading", (str(long),), long.start, long.end),))
        plain = everyday(with_plain_numbers(plain_width(text), self.names()))
        finding = self.all_links(without_head(plain, self.names().letters), context)
        if finding.outcome == UNDECIDED and is_introduced(plain):  # the word may be letters of the scene
            finding = self.all_links(without_introduction(plain), context)
        return Verdict(finding.outcome, "", finding.remarks)

    def all_links(self, line: str, context: Context) -> Finding:
        """The finding for all equations of a line; one that says nothing counts only where no other says more."""
        links = [self.link(*link, context) for part in statements_of(line) for link in equations_of(*part)]
        return all_findings([one for one in links if all(remark.kind != "trivial" for remark in one.remarks)] or links)

    @remembered
    def names(self, defined: tuple[str, ...] = ()) -> Names:
        """The letters that a line may hold: those of the scene, those that its laws print, with or without a state, and the student's."""
        printed = self.letters.printed
        keys = self.letters.meanings.keys
        bare = {self.letters.meanings.letter(name) for name in printed if name in keys}
        return Names(self.letters.givens | printed | frozenset(self.letters.bare) | bare | set(defined), self.answers)

    def meant(self, word: str) -> tuple[str, ...]:
        """The printed letters that a typed one may stand for: itself, and the same at other states."""
        name = next((one for one in spellings(word) if one in self.names().letters), "")
        if not name or name in self.letters.givens:
            return ()
        own = (self.letters.bare.get(name, name),)
        others = (other for other in self.letters.meanings.at_other_states(name) if other not in own)
        return (*own, *(other for other in others if self.letters.meaning(other) != ZERO))  # at rest many a line holds

    # one equation

    def link(self, text: str, start: int, context: Context) -> Finding:
        """The finding for one equation of a line, which begins at `start`, by the reading that makes it right."""
        try:
            readings = self.readings(text, tuple(name for name, _ in context.defined))
        except AnswerError as error:
            kind = "undeclared" if error.unknown else "reading"
            remark = Remark(kind, (str(error),), start + error.start, start + error.end)
            return Finding(UNDECIDED, (remark,))
        tried = [self.equation(reading, text, context) for reading in readings]
        return next((finding for finding in tried if finding.right), tried[0])

    def readings(self, text: str, defined: tuple[str, ...]) -> tuple[LineReading, ...]:
        """All readings of an equation; with near letters where it has others than the scene."""
        try:
            return read_line(text, self.names(defined))
        except AnswerError as error:
            if not error.unknown:
                raise
            near = {
                typed: name for typed, name in self.letters.near.items() if typed not in self.names(defined).letters
            }
            try:
                readings = read_line(text, self.names((*defined, *near)))
            except AnswerError:
                raise error from None
            return tuple(with_near(reading, near) for reading in readings)

    def equation(self, reading: LineReading, text: str, context: Context) -> Finding:
        """The finding for one reading of an equation: by each state at which its letters can be meant, the asked one first."""
        if reading.kind != EQUATION or reading.formula is None or reading.right is None:
            return found(UNDECIDED, "form", "a line of working is an equation")
        sides = tuple(side.substitute(dict(context.defined)) for side in (reading.formula, reading.right))
        first: Finding | None = None
        for put in self.states(sides[0].symbols() | sides[1].symbols()):
            left, right = (self.letters.meant(side.substitute(put)) for side in sides)
            finding = self.statement(self.turned(left, context), self.turned(right, context), text)
            letters = tuple(remark for remark in reading.remarks if remark.kind == "letter")
            finding = replace(finding, remarks=(*finding.remarks, *letters)) if letters else finding
            if finding.right and not by_numbers_alone(finding):
                return finding
            first = finding if first is None or (by_numbers_alone(finding) and first.outcome == WRONG) else first
        assert first is not None
        return first

    def states(self, names: frozenset[str]) -> Iterator[dict[str, Formula]]:
        """The ways in which letters can be meant at one state or another, as they stand first."""
        choices = {name: self.meant(name) for name in sorted(names - self.letters.givens)}
        several = {
            name: options for name, options in choices.items() if len(options) > 1 or options[:1] not in ((), (name,))
        }
        for chosen in islice(product(*several.values()), MOST_STATES):
            yield {name: Symbol(option) for name, option in zip(several, chosen, strict=True)}

    def turned(self, side: Formula, context: Context) -> Formula:
        """A side in the scene's own positive directions."""
        sense = self.letters.meanings.sense
        return side.substitute(
            {name: -Symbol(name) for name in side.symbols() if context.turned and sense(name) in context.turned}
        )

    def statement(self, left: Formula, right: Formula, text: str) -> Finding:
        """The finding for left = right in letters of the scene."""
        if self.identical(left, right):
            return found(UNDECIDED, "trivial", "true whatever the letters stand for: it says nothing")
        open_ = [name for name in sorted(left.symbols() | right.symbols()) if not self.settled(name)]
        if open_:
            return found(UNDECIDED, "undeclared", f"the scene does not tell what {open_[0]} is")
        holds = self.holds(left, right, text)
        if holds is not False:
            return Finding(UNDECIDED if holds is None else RIGHT)
        unitless = one_is_a_number(left, right) or DECIMAL.search(text)  # numbers lost their units when they were read
        return (
            (None if unitless else self.misfit(left, right))
            or self.sign(left, right)
            or self.mistake(left, right)
            or self.equal_for_numbers(left, right)
            or Finding(WRONG)
        )

    def identical(self, left: Formula, right: Formula) -> bool:
        """Whether two sides are the same whatever their letters stand for: most differ where each letter has some number of its own."""
        names = sorted(left.symbols() | right.symbols())
        numbers = {name: arb(3 * place + 2) / (2 * place + 5) for place, name in enumerate(names)}
        try:
            gap = RealBalls({}, bound=numbers)(left - right)
            return bool(gap.contains(0)) and equal(left, right)
        except (Undefined, ValueError, ArithmeticError):
            return False

    def settled(self, name: str) -> bool:
        """Whether it is known what a letter stands for."""
        return name in self.letters.givens or self.letters.meaning(name) is not None or self.number(name) is not None

    def number(self, name: str) -> Certified | None:
        """The number of a letter without a closed form, in SI units."""
        meanings = self.letters.meanings
        return meanings.number(name) if name in meanings.keys else None

    def told(self, side: Formula) -> Formula:
        """A side with the closed forms of its letters."""
        forms = {name: self.letters.meaning(name) for name in side.symbols() - self.letters.givens}
        return side.substitute({name: form for name, form in forms.items() if form is not None})

    def holds(self, left: Formula, right: Formula, text: str) -> bool | None:
        """Whether an equation holds on the scene's solution: exactly, or in its decimals."""
        sides = [self.told(side) for side in (left, right)]
        held = self.same(sides[0] - sides[1], ZERO) or self.same(*sides)
        if held is True or (held is None and self.is_law(left - right)):
            return True
        if DECIMAL.search(text) or one_is_a_number(left, right):
            return self.nearly(*sides)
        return False if held is None and self.differ(*sides) else held

    def is_law(self, residue: Formula) -> bool:
        """Whether an equation is a law of the scene, of whose letters not all have a closed form."""
        laws = self.letters.meanings.laws
        sides = (side for law in laws for side in (law.left - law.right, law.right - law.left))
        return any(self.identical(residue, side) for side in sides)

    def differ(self, left: Formula, right: Formula) -> bool:
        """Whether the numbers of both sides surely differ."""
        gap = self.value(left - right)
        return gap is not None and bool(gap.sign)

    def nearly(self, left: Formula, right: Formula) -> bool | None:
        """Whether both sides agree to the tolerance, as a share of their largest term; None where they have no number."""
        terms = [number.float for side in (left, right) for term in side_terms(side) if (number := self.value(term))]
        sides = [self.value(side) for side in (left, right)]
        if None in sides:
            return None
        tolerance = marking_of(self.letters.problem.marking, ALL).tolerance.share
        share = USUAL if tolerance is None else float(tolerance)
        low, high = (side.float for side in sides if side is not None)
        return abs(low - high) <= share * max(abs(term) for term in (*terms, low, high))

    def value(self, side: Formula) -> Certified | None:
        names = side.symbols() - self.letters.values.keys()
        roots = {name: number for name in names if (number := self.number(name)) is not None}
        try:
            return evaluate(side, self.letters.values, roots=roots) if len(roots) == len(names) else None
        except (Undefined, ZeroDivisionError):
            return None

    # what is wrong

    def equal_for_numbers(self, left: Formula, right: Formula) -> Finding | None:
        """The finding for a line that holds for the scene's own numbers alone: a = g/2 where M = 2 m. One in which nothing was put in that
        shows, as m g = M a or T = m a, may be another law that holds by chance: nothing is decided."""
        sides, values = [self.told(side) for side in (left, right)], self.letters.values
        if not worth_the_same(sides[0], sides[1], values):
            return None
        names = left.symbols() | right.symbols()
        unknown, lacks = names - self.letters.givens, sides[0].symbols() ^ sides[1].symbols()
        put = letters_put_in(sides[0], sides[1], lacks, values, self.same)
        solved = any(isinstance(side, Symbol) for side in (left, right)) or not names.issuperset(put)
        if len(unknown) > 1 or (unknown and not solved):
            return found(UNDECIDED, NUMBERS_ALONE, "it holds for the numbers of the scene, not in letters")
        return found(RIGHT, NUMBERS_ALONE, "right with the number of ", *listed_letters(put), " put in")

    def misfit(self, left: Formula, right: Formula) -> Finding | None:
        """Sides that measure different things; None where they do not, or where that is not known."""
        known = self.dimensions(left.symbols() | right.symbols())
        if known is None:
            return None
        try:
            sides = [dimension_of(side, known) for side in (left, right)]
        except DimensionError as error:
            return found(WRONG, "dimension", f"its parts do not fit together: {error.message}")
        if ZERO in (left, right) or sides[0].matches(sides[1]):
            return None
        one, other = (describe(side, article=True) for side in sides)
        return found(WRONG, "dimension", f"the left side is {one}, but the right side is {other}")

    def dimensions(self, names: frozenset[str]) -> dict[str, Dimension] | None:
        """What the letters measure; None where one is not known."""
        meanings, known = self.letters.meanings, self.letters.dimensions
        found = {
            name: known.get(name) or (meanings.dimension(name) if name in meanings.keys else None) for name in names
        }
        dimensions = {name: dimension for name, dimension in found.items() if dimension is not None}
        return dimensions if len(dimensions) == len(found) else None

    def sign(self, left: Formula, right: Formula) -> Finding | None:
        """The term whose sign alone is wrong, where there are several: T in m g + T = m a."""
        terms = [*side_terms(left), *(negate(term) for term in side_terms(right))]
        for term in terms if len(terms) > 2 else ():
            if self.same(self.told(left - right - term - term), ZERO):
                shown = term.operand if isinstance(term, Negative) else term
                return found(WRONG, "mistake", "it would hold with the other sign of ", shown)
        return None

    def mistake(self, left: Formula, right: Formula) -> Finding | None:
        """The mistake with which the equation holds, where all its letters are givens or answers."""
        names = (left.symbols() | right.symbols()) - self.letters.givens
        if not names or not names <= self.letters.closed.keys():
            return None
        for mistake, answers in self.explaining.wrong_answers:
            forms = {name: answer.closed for name, answer in answers.items() if name in names}
            if not forms or any(form is None or form == ZERO for form in forms.values()):
                continue  # where a force is nothing, many a line holds
            put = {name: form for name, form in forms.items() if form is not None}
            sides = [self.told(side.substitute(put)) for side in (left, right)]
            if self.same(*sides):
                return mistake_finding(mistake)
        return None


def statements_of(text: str) -> list[tuple[str, int]]:
    """The statements of a line, and where they begin: I = ½ M R², ω = v/R; the whole of it where one of them is no equation."""
    cuts, depth = [(0, 0)], 0
    for sign in BETWEEN.finditer(text):
        depth += (sign[0] in "([{") - (sign[0] in ")]}")
        if not depth and sign[0] not in "()[]{}":
            cuts.append(sign.span())
    ends = [start for start, _ in cuts[1:]] + [len(text)]
    parts = [(text[start:end], start) for (_, start), end in zip(cuts, ends, strict=True)]
    parts = [part for part in parts if part[0].strip(" .$")]
    return parts if len(parts) > 1 and all("=" in part for part, _ in parts) else [(text, 0)]


def equations_of(text: str, at: int = 0) -> Iterator[tuple[str, int]]:
    """The equations of a statement that begins at a place, and where they begin: a = b, b = c of the chain a = b = c."""
    pieces = [match.span() for match in re.finditer("[^=]+", text)]
    if len(pieces) < 3:
        yield text, at
        return
    for (start, _), (_, end) in pairwise(pieces):
        yield text[start:end], at + start


def by_numbers_alone(finding: Finding) -> bool:
    """Whether a line was found to hold for the scene's own numbers only."""
    return any(remark.kind == NUMBERS_ALONE for remark in finding.remarks)


def one_is_a_number(left: Formula, right: Formula) -> bool:
    """Whether one side is a number other than zero."""
    return any(not side.symbols() and side != ZERO for side in (left, right))


def side_terms(side: Formula) -> tuple[Formula, ...]:
    inner = side.operand if isinstance(side, Negative) else side
    return inner.terms if isinstance(inner, Sum) else (inner,)
