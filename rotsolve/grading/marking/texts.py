"""Texts: what is found in one text by itself, whoever wrote it; equal texts are judged once."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, Symbol
from rotsolve.algebra.units.dimension import NONE
from rotsolve.confirm.course.samples import holds
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.equality import SampledRegion, close_everywhere
from rotsolve.grading.comparing.here import same_in
from rotsolve.grading.comparing.numbers import certified_number, rounds_to
from rotsolve.grading.comparing.readings import opposite_vector, scalar_judged, typed_in, vector_judged
from rotsolve.grading.comparing.scalars import Close, Same, is_turned_by, pointing_judged
from rotsolve.grading.comparing.signs import cut_direction, is_direction
from rotsolve.grading.comparing.uncertain import with_uncertainty
from rotsolve.grading.marking.target import SceneLetters, Target, targets_of
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.choices import options_named, plain_words
from rotsolve.grading.reading.conditions import CONDITIONAL, Claim, claims_in
from rotsolve.grading.reading.definitions import Defined, cut_definitions, told_before
from rotsolve.grading.reading.everyday import cut_clause, everyday, quotient_of_ratio, without_nouns
from rotsolve.grading.reading.lines import ABOUT, EQUALS, chain_members, cut_aside, with_plain_numbers, without_asides
from rotsolve.grading.reading.prose import last_statement, nouns_for, without_prose
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, AnswerError, LineReading, Names
from rotsolve.grading.reading.spoken import in_english
from rotsolve.grading.reading.tokens import plain_width
from rotsolve.grading.reading.uncertainty import cut_uncertainty
from rotsolve.grading.verdict import RIGHT, UNDECIDED, VALUELESS, WRONG, Finding, Remark, found
from rotsolve.language.marks import FORM, UNIT

if TYPE_CHECKING:
    from rotsolve.grading.marking.axes import OtherAxes
    from rotsolve.grading.marking.own_letters import OwnLetters

LONGEST_ECHO = 400  # characters of a line that is said back
CHAIN = "chain"  # the kind of a remark on the way to an answer
MISFIT = 4  # the preference of a reading that does not measure what is asked
ASIDE = "aside"  # the kind of a remark on words that are passed over
EMPTY = "empty"  # the kind of the remark on a text that is no answer, as `?`
NOTHING = re.compile(r"[\s?.\-–—/]*|n\s*/\s*a|idk|no idea|(?:i )?do(?:n't| not) know|no answer", re.IGNORECASE)


class JudgedText(Struct, frozen=True):
    """One text, judged by itself: the reading that was used (None where there is none), and what was found."""

    reading: LineReading | None
    finding: Finding
    read_as: str = ""

    def saying(self, *remarks: Remark) -> JudgedText:
        """The same with more that is said of it."""
        return replace(self, finding=replace(self.finding, remarks=(*self.finding.remarks, *remarks)))


class Texts:
    """Judges the texts that answer the questions of one solved scene."""

    def __init__(self, letters: SceneLetters, same: Same, close: Close) -> None:
        self.letters, self.same, self.close = letters, same, close

    @classmethod
    def of(cls, letters: SceneLetters, domain: SampledRegion) -> Texts:
        """Those of a scene whose formulas are compared in a domain."""
        return cls(
            letters,
            lambda left, right: same_in(domain, left, right),
            lambda left, right, share: close_everywhere(left, right, domain, share),
        )

    @cached_property
    def targets(self) -> dict[str, Target]:
        """What every answer is held against, by its name, in the order of the questions."""
        return {target.name: target for target in targets_of(self.letters, self.same, self.close)}

    @cached_property
    def others(self) -> OtherAxes:
        """The answers along other axes than those that are asked."""
        from rotsolve.grading.marking.axes import OtherAxes

        return OtherAxes(self.letters.problem, self.same, self.close)

    @remembered
    def judged(self, target: Target, text: str, defined: Defined = ()) -> JudgedText:
        """What is found in a text; `defined` are letters that the student brought in before."""
        long = AnswerError.of_length(text)
        if long is not None:
            return unreadable(long)
        text = everyday(in_english(plain_width(text)))
        if NOTHING.fullmatch(text):
            return JudgedText(None, found(WRONG, EMPTY, "not answered"))
        if target.word:
            bodies = nouns_for(*(body.name for body in self.letters.problem.bodies))
            return JudgedText(None, word_judged(text, target, self.names(target).nouns | bodies))
        if is_direction(without_letter(text)):
            return JudgedText(None, direction_judged(without_letter(text), target))
        if target.parts and self._names_components(target, text):
            return self._in_axes(target, text, defined)
        text = with_plain_numbers(text, self.names(target))
        claims = claims_in(text, self.names(target)) if CONDITIONAL.search(text) else ()
        claim = self._claimed(claims) if claims else None
        if claim is not None:
            text = claim.text
        text, told = cut_definitions(text, self.names(target), self.letters.constants, self.letters.dimensions)
        return self._answering(target, text, (*defined, *told))

    def _claimed(self, claims: tuple[Claim, ...]) -> Claim | None:
        """The answer that is given for the numbers of the scene; None where they do not tell."""
        letters = {
            name for one in claims for side in one.conditions for name in side.left.symbols() | side.right.symbols()
        }
        if not letters <= self.letters.numbers.keys():
            return None
        numbers = dict(self.letters.numbers)
        told = [one for one in claims if one.conditions and all(holds(each, numbers) for each in one.conditions)]
        return next(iter([*told, *(one for one in claims if not one.conditions)]), None)

    def _answering(self, target: Target, text: str, defined: Defined) -> JudgedText:
        """What is found in the last statement of a line that tells the answer; an earlier one with another value is said to be so."""
        names = self.names(target)
        line, before = last_statement(text, names)
        if line != text:
            front = text[: len(text) - len(line.lstrip())]
            told = told_before(front, names, self.letters.constants, self.letters.dimensions)
            defined = (*defined, *told)
        line, aside = cut_aside(line, names)
        line, uncertainty = cut_uncertainty(line)
        line, said = cut_clause(line, self.words_elsewhere(target))
        line = without_nouns(line, names.nouns, names.letters)
        if target.whole is not None and target.whole.dimension.matches(NONE):
            line = quotient_of_ratio(line)
        one = self._in_axes(target, without_asides(without_prose(line, names), names), defined)
        if uncertainty is not None and one.reading is not None:
            one = replace(one, finding=with_uncertainty(one.finding, one.reading, uncertainty, target.whole))
        if aside and one.reading is not None:
            one = one.saying(Remark(ASIDE, (f"`{aside}` is passed over",)))
        if said and one.reading is not None:
            one = one.saying(Remark(ASIDE, (f"`{said}` is passed over",)))
        near = names.near_name(line)
        if near and one.reading is not None:
            one = one.saying(Remark("letter", (Symbol(near), " is taken as ", Symbol(target.name))))
        if before and self._is_other(target, before, defined):
            return one.saying(Remark(CHAIN, (f"`{before.strip()}` is another value",)))
        return one

    def _is_other(self, target: Target, before: str, defined: Defined) -> bool:
        """Whether an earlier statement tells another answer."""
        finding = self.judged(target, before, defined).finding
        return finding.outcome == WRONG and not finding.flaws

    @remembered
    def names(self, target: Target, more: frozenset[str] = frozenset()) -> Names:
        """The letters that an answer may hold, those of the scene and more, and how many components it has."""
        components = len(target.parts) // target.rows
        near = frozenset(typed for typed, name in self.letters.near.items() if name == target.name)
        return Names(
            self.letters.givens | more, self.letters.told, target.name, components, self.nouns(target.name), near
        )

    @remembered
    def nouns(self, name: str) -> frozenset[str]:
        """The words for what an answer is: those of its quantities, and of whose they are."""
        finds = [find for find in self.letters.problem.finds if find.group == name]
        paths = [term.path for find in finds for term in find.terms]
        whose = [word for path in paths for word in (path.owner, path.point or "", path.quantity)]
        return nouns_for(*whose, *(term.modifier for find in finds for term in find.terms))

    @remembered
    def words_elsewhere(self, target: Target) -> frozenset[str]:
        """Words that may say that something else is meant: letters of the scene, and the names of bodies that are not asked about."""
        bodies = nouns_for(*(body.name for body in self.letters.problem.bodies))
        letters = {name for name in self.letters.givens | self.letters.told if name not in "aA"}
        return (bodies - self.nouns(target.name)) | letters

    def _names_components(self, target: Target, text: str) -> bool:
        """Whether a text tells a vector or matrix by the names of its components."""
        from rotsolve.grading.reading.matrices import told_components  # only vectors and matrices need it

        return any(told_components(text, self.names(target), target.labels))

    def _in_axes(self, target: Target, text: str, defined: Defined) -> JudgedText:
        """What is found in an answer, along the axes that are asked or those that the student names."""
        if not self.letters.problem.space:
            return self._told(target, text, defined)
        from rotsolve.grading.marking.axes import NODES, cut_axes, named_axes

        line, named = cut_axes(text, self.letters.problem)
        asked = named_axes(self.letters.problem, target.name)
        if named not in ("", asked):
            return self._along(target, line, defined, named)
        own = self._told(target, line, defined)
        if own.finding.outcome != WRONG or own.reading is None or own.reading.basis != NODES or named:
            return own
        along = self._along(target, line, defined, "node")
        return along if along.finding.outcome != UNDECIDED else own

    def _along(self, target: Target, line: str, defined: Defined, axes: str) -> JudgedText:
        """What is found along other axes than those that are asked; undecided where nothing tells them."""
        other = self.others.target(target.name, axes)
        if isinstance(other, str):
            words = f"can't tell its components in {axes} axes: {other}"
            return JudgedText(None, found(UNDECIDED, "axes", words))
        one = self._told(other, line, defined)
        return one.saying(Remark("axes", (f"read in {axes} axes",)))

    def _told(self, target: Target, text: str, defined: Defined) -> JudgedText:
        """What is found in an answer: of a vector its named components, the last member of a chain, or one value."""
        if target.parts:
            from rotsolve.grading.reading.matrices import named_components

            try:
                told = named_components(text, self.names(target), target.labels)
            except AnswerError as error:
                return unreadable(error)
            if told is not None:
                return self._best(target, text, (told,))
        listed = self.letters.problem.space and re.search(r"[,;]\s", text) and not set(text).intersection("([<{")
        if listed and target.parts and target.rows == 1:  # components without brackets
            bare = self._value(target, f"({without_letter(text)})", defined)
            if bare.reading is not None and bare.reading.kind == VECTOR:
                return bare
        chain = chain_members(text, self.names(target)) if target.rows == 1 else ()
        if chain:
            found_in = [self._value(target, member, defined) for member in chain]
            return exact_before_rounded(target, found_in, text) or chain_judged(found_in, chain)
        return self._value(target, text, defined)

    def _value(self, target: Target, text: str, defined: Defined) -> JudgedText:
        """What is found in one value: by the letters as the student defined them, else by the scene's."""
        if not defined or target.rows > 1:
            return self._by_scene(target, text)
        from rotsolve.grading.marking.own_letters import OwnLetters  # few define letters

        own = OwnLetters.of(defined, self.letters, target, self.same)
        try:
            one = self._by_own(target, text, own) or self._by_scene(target, text)
        except AnswerError as error:  # knows more letters, so that it blames the right one
            by_scene = self._by_scene(target, text)
            one = unreadable(error) if by_scene.reading is None else by_scene
        return one if one.reading is None else self._with_own_numbers(target, one, one.reading, own)

    def _by_own(self, target: Target, text: str, own: OwnLetters) -> JudgedText | None:
        """What is found in one value by letters that the student defined; None where it holds none."""
        from rotsolve.grading.marking.own_letters import holds_letters, in_own_letters

        line, direction = cut_direction(text)
        readings = read_line(line, self.names(target, self.letters.constants.union(own.forms)))
        if not any(holds_letters(one, own.forms) for one in readings):
            return None
        put = [in_own_letters(one, own.forms) for one in readings]
        told = [None if one.formula is None else self.letters.spelled_out(one.formula) for one in put]
        meant = tuple(
            replace(one, formula=form)
            for one, form in zip(put, told, strict=True)
            if form is not None or one.formula is None
        )
        return self._best(target, text, with_direction(meant, direction)) if meant else None

    def _with_own_numbers(self, target: Target, one: JudgedText, reading: LineReading, own: OwnLetters) -> JudgedText:
        """What is found with the numbers that the student gave to letters of the scene, and what differs from the scene."""
        from rotsolve.grading.marking.own_letters import in_own_letters

        finding = one.finding
        if own.numbers and reading.kind != NUMBER and (finding.right or finding.flaws):
            number = own.worked_out(self.meant(reading), self.letters, target)
            by_number = self._read(target, number)
            if not by_number.right:
                reading = number if own.near else in_own_letters(reading, own.numbers)
                finding = by_number
        return JudgedText(reading, finding, one.read_as).saying(*own.remarks)

    def _by_scene(self, target: Target, text: str) -> JudgedText:
        """What is found in one value: by the letters of the scene, else with units in it, else with letters of the laws."""
        line, direction = cut_direction(text)
        try:
            best = self._best(target, text, with_direction(self._readings(target, line), direction))
        except AnswerError as error:
            best = unreadable(error)
        plain = best.reading is not None and best.reading.figures is not None  # 4.36 m/s² can be read in one way only
        if best.finding.outcome == RIGHT or target.rows > 1 or plain:
            return best
        from rotsolve.grading.reading.quantities import quantity_readings  # a right answer seldom needs it

        others = quantity_readings(line, self.names(target), self.letters.dimensions, best.reading is not None)
        if best.reading is None:
            try:
                others = (*others, *self._with_laws(line, target))
            except AnswerError as error:  # knows more letters, so that it blames the right one
                best = unreadable(error)
            others = others or self._with_near(line, target)
        if not others:
            return best
        other = self._best(target, text, with_direction(others, direction))
        if best.reading is None and self._is_rather_letters(target, other):
            return best
        return other if best.reading is None or preference(other.finding) < preference(best.finding) else best

    def _is_rather_letters(self, target: Target, one: JudgedText) -> bool:
        """Whether a unit that does not measure what is asked has letters of the scene in it, as N/m behind a formula with m."""
        if preference(one.finding) != MISFIT or one.reading is None or one.reading.unit is None:
            return False
        words = re.findall(r"[^\W\d_]+", one.reading.unit.text)
        return one.reading.kind == FORMULA and not self.names(target).letters.isdisjoint(words)

    def _readings(self, target: Target, line: str) -> tuple[LineReading, ...]:
        """All readings that a line allows by the letters of the scene."""
        if target.rows == 1:
            return read_line(line, self.names(target))
        from rotsolve.grading.reading.matrices import read_matrix

        return read_matrix(line, self.names(target))

    def _with_laws(self, line: str, target: Target) -> tuple[LineReading, ...]:
        """The readings of a line with letters that no motion has to be solved for, I for the moment of inertia, in terms of the givens."""
        names = self.names(target, self.letters.constants)
        return tuple(
            replace(reading, written=reading.text, formula=formula)
            for reading in read_line(line, names)
            if reading.formula is not None and (formula := self.letters.spelled_out(reading.formula)) is not None
        )

    def _with_near(self, line: str, target: Target) -> tuple[LineReading, ...]:
        """The readings of a line with letters that the scene does not have, each of which can mean only one of its own."""
        from rotsolve.grading.reading.near import with_near
        from rotsolve.grading.reading.quantities import quantity_readings

        near = {typed: name for typed, name in self.letters.near.items() if name != target.name}
        names, measured = self.names(target, frozenset(near)), self.letters.dimensions
        measured |= {typed: measured[name] for typed, name in near.items() if name in measured}
        try:
            readings = read_line(line, names)
        except AnswerError:
            readings = ()
        found = (*readings, *quantity_readings(line, names, measured, bool(readings)))
        return tuple(with_near(reading, near) for reading in found)

    def _best(self, target: Target, text: str, readings: tuple[LineReading, ...]) -> JudgedText:
        """By the reading that makes the line right, else by the likeliest one."""
        tried: list[tuple[LineReading, Finding]] = []
        for reading in readings:
            tried.append((reading, self._read(target, reading)))
            if preference(tried[-1][1]) == 0:
                break
        reading, finding = min(tried, key=lambda item: preference(item[1]))
        if finding.outcome == WRONG and not finding.flaws and any(one.cut for one in readings):
            finding = found(UNDECIDED, "reading", "it can be read in more ways than were tried: brackets make it plain")
        plain = reading is readings[0] and reading.kind == NUMBER  # a number with its unit, as it stands there
        echo = reading.text if len(readings) > 1 and len(text) <= LONGEST_ECHO and not plain else ""
        return JudgedText(reading, finding, "" if echo == without_letter(text) else echo)

    def _read(self, target: Target, reading: LineReading) -> Finding:
        """The finding for one reading."""
        reading, closed = self.meant(reading), self.letters.closed.get(target.name)
        own = closed is not None and target.name in closed.symbols()
        if reading.formula is not None and target.name in reading.formula.symbols() and not own:
            return found(WRONG, "form", "the answer speaks of itself")
        if target.parts:
            finding = vector_judged(reading, target.parts, target.whole, target.labels)
            if finding.right or not target.either or reading.kind != VECTOR:
                return finding
            return vector_judged(opposite_vector(reading), target.parts, target.whole, target.labels)
        assert target.whole is not None
        return scalar_judged(reading, target.whole)

    def meant(self, reading: LineReading) -> LineReading:
        """A reading with its formulas in the letters of closed forms."""
        if not self.letters.runs:
            return reading
        formula = None if reading.formula is None else self.letters.meant(reading.formula)
        return replace(reading, formula=formula, parts=tuple(self.meant(part) for part in reading.parts))


def exact_before_rounded(target: Target, found_in: list[JudgedText], text: str) -> JudgedText | None:
    """What is found in `√10 m/s ≈ 3 m/s`: an exact value or a formula that is right is the answer, whatever figures its rounded one has."""
    *_, exact, rounded = found_in
    if target.whole is None or exact.reading is None or rounded.reading is None or not _is_about(text):
        return None
    value, typed = exact.reading, rounded.reading
    unit = typed.unit or value.unit or target.whole.unit
    flaws = set(exact.finding.flaws) - ({UNIT} if typed.unit is not None else set())
    right = (exact.finding.right or exact.finding.flaws) and not flaws
    if not right or value.figures is not None or value.formula is None or typed.kind != NUMBER or typed.formula is None:
        return None
    factor = (value.unit or unit).factor if value.kind == NUMBER else ONE
    number = certified_number(value.formula * factor / unit.factor, target.whole.values)
    if not unit.dimension.matches(target.whole.dimension) or number is None:
        return None
    if not rounds_to(typed_in(typed), number):
        return None
    kept = tuple(remark for remark in exact.finding.remarks if remark.kind != "unit")
    return replace(exact, finding=Finding(RIGHT, kept))


def _is_about(text: str) -> bool:
    """Whether the last sign between the members of a chain says that they are only nearly equal."""
    signs = EQUALS.findall(text)
    return bool(signs) and signs[-1] in ABOUT


def chain_judged(found_in: list[JudgedText], chain: tuple[str, ...]) -> JudgedText:
    """What is found in a chain of values: its last member is the answer; an earlier one that is another value is said to be so."""
    *earlier, last = found_in
    finding = last.finding
    if finding.outcome == WRONG and any(remark.kind == "dimension" for remark in finding.remarks):
        said = "what stands between the signs of equality does not belong together"
        return JudgedText(None, found(UNDECIDED, CHAIN, said))
    if finding.right and any(one.finding.right and FORM not in one.finding.flaws for one in earlier):
        flaws = tuple(flaw for flaw in finding.flaws if flaw != FORM)
        remarks = tuple(remark for remark in finding.remarks if FORM in flaws or remark.kind != FORM)
        finding = Finding(finding.outcome, remarks, flaws)
    for one, member in zip(earlier, chain, strict=False):
        failed = one.finding.outcome == WRONG and not one.finding.flaws
        if (
            finding.right and last.reading is not None and last.reading.direction
        ):  # the sign of all is told by its words
            failed = failed and any(remark.kind != "sign" for remark in one.finding.remarks)
        if one.finding.right if finding.outcome == WRONG else failed:
            start, end = len(member) - len(member.lstrip()), len(member.rstrip())
            words = f"`{member.strip()}` {'is right' if one.finding.right else 'is another value'}"
            finding = replace(finding, remarks=(*finding.remarks, Remark(CHAIN, (words,), start, end)))
            break
    return replace(last, finding=finding)


def with_direction(readings: tuple[LineReading, ...], direction: str) -> tuple[LineReading, ...]:
    """The readings with the direction that words behind the line tell."""
    return tuple(replace(one, direction=direction) for one in readings) if direction else readings


def unreadable(error: AnswerError) -> JudgedText:
    """What is found in a text that can't be read."""
    remark = Remark("reading", (str(error),), error.start, error.end)
    return JudgedText(None, Finding(UNDECIDED, (remark,)))


def preference(finding: Finding) -> int:
    """The order in which the readings of one line are preferred: none is called wrong while another may be right."""
    if finding.outcome == WRONG and finding.flaws:
        return 1
    if any(remark.kind == VALUELESS for remark in finding.remarks):
        return 5
    if finding.outcome == WRONG and any(remark.kind in ("dimension", "form") for remark in finding.remarks):
        return MISFIT  # another reading measures what is asked
    return {RIGHT: 0, UNDECIDED: 2, WRONG: 3}[finding.outcome]


def without_letter(text: str) -> str:
    """A text without the letter of the answer in front."""
    return text.rpartition("=")[2].strip()


def word_judged(text: str, target: Target, nouns: frozenset[str]) -> Finding:
    """The finding for a label, or several in any order."""
    if plain_words(text) == plain_words(target.word):
        return Finding(RIGHT)
    wanted = options_named(target.word, target.options)
    typed = options_named(without_letter(text), target.options, nouns)
    if typed is None:
        alone = len(re.findall(r"\w+", without_letter(text))) == 1  # one word, which is none of them
        return found(WRONG if alone else UNDECIDED, "reading", f"choose from: {', '.join(target.options)}")
    return Finding(RIGHT if typed == wanted else WRONG)


def direction_judged(text: str, target: Target) -> Finding:
    """The finding for a direction in words where a number could stand."""
    asked = target.whole
    if asked is None or not asked.direction:
        return found(WRONG, "form", "words are no answer here")
    other = pointing_judged(text, asked)
    if other is not None:
        return other
    if is_turned_by(text, asked):
        return found(WRONG, "direction", f"it points another way: {asked.direction}")
    if target.directional:
        return Finding(RIGHT)
    return found(WRONG, "form", "the direction is right; its size is asked for")
