"""Cases told: the answers of all cases of letters side by side, each with the conditions under which it holds."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from fractions import Fraction
from functools import partial
from itertools import zip_longest

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import equal, simplify
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Answer, Check, Derivation, Equality, Section, Words, in_a_row
from rotsolve.core.faults import UNSOLVED, Unsolvable
from rotsolve.derivation.closing import Closing, Held, Solved, answer_put, unanswered_in
from rotsolve.derivation.ranges import at_ends_of_ranges
from rotsolve.language.problem import Problem
from rotsolve.search.cases import Needed
from rotsolve.search.edges import Edge, Edges
from rotsolve.search.lettersigns import Proviso
from rotsolve.search.letterspace import Glance, LetterSpace
from rotsolve.search.provisos import Region, condition_line, follows, limits_told, needed, shown, united

NOTHING = Fraction(1, 10**6)  # share of a mass that is left of it where it is next to nothing
MORE_CASES = "of other letters there are more cases, which are not worked out: give them numbers"


class CaseTeller(Struct, frozen=True):
    """The cases with an answer, those without one, and the letters that tell them apart."""

    good: Sequence[Solved]
    bad: Sequence[Solved]
    space: LetterSpace
    edges: Edges[Derivation]
    bare: dict[
        tuple[Equality, str], tuple[Edge | None, list[Formula]]
    ]  # edges on which answers are not known, and these by their symbols
    more: bool = (
        False  # whether there are others, which are not solved: then each answer has all the conditions of its case
    )

    def derivation(self) -> Derivation:
        """The derivation of the first case, with the others behind it: what differs between them says when it holds."""
        full = [case for case in self.good if not any(says_more(other, case) for other in self.good)]
        main = full[0].found
        assert main is not None
        named = dict.fromkeys(answer.name for case in self.good for answer in told_in(case))
        answers = tuple(self.piecewise(name) for name in in_order(named, self.space.problem))
        told = self.headings(full)
        sections = main.sections
        if len(told) > 1:
            sections = tuple(section for key, case in told.items() for section in headed(key, case, main.states))
        refused = tuple(item for item in main.refused if item.name not in named)
        own = [check for check in main.checks if self.goes_for(check, full[0])]
        ends = () if len(full) > 1 else at_ends_of_ranges(answers, self.space)
        checks = (*own, *ends, *doubts_besides(main, self.good), *self.failing(set(named)))
        said = (*main.conventions, *((words,) for words in (*self.space.assumptions(), *limits_told(self.space))))
        insights, second = (main.insights, main.second) if len(told) <= 1 else ((), ())  # else they are of one case
        changes = {"sections": sections, "checks": checks, "conventions": said, "refused": refused}
        return replace(main, answers=answers, insights=insights, second=second, **changes)

    def goes_for(self, check: Check, case: Solved) -> bool:
        """Whether what is said of a letter that is next to nothing, or beyond all measure, is said of a case that holds there."""
        name, share = (check.growing, 1 / NOTHING) if check.growing else (check.vanishing, NOTHING)
        place = {**case.point, name: case.point.get(name, Fraction(1)) * share} if name else {}
        return not name or not Glance(self.space, place).fails(case.conditions)

    def headings(self, full: Sequence[Solved]) -> dict[tuple[Equality, ...], Solved]:
        """Of cases with the same answers the first, by where they hold."""
        told: list[Held] = []
        for case in full:
            own = [other for other in full if same_forms(case, other)]
            if own[0] is case:
                told.append(Held(told_in(case), own, self.apart(own)[0]))
        regions = Closing(self.edges).closed(told) if len(told) > 1 else []
        return {self.equalities(region): held.own[0] for region, held in zip(regions, told, strict=bool(regions))}

    def piecewise(self, name: str) -> Answer:
        """An answer with the conditions under which it holds, and what it is in other cases, on their edges too."""
        groups: list[tuple[Answer, list[Solved]]] = []
        for case in self.good:
            answer = next((answer for answer in told_in(case) if answer.name == name), None)
            if answer is None:
                continue
            group = next((own for other, own in groups if same_form(answer, other)), None)
            if group is None:
                groups.append((answer, [case]))
            else:
                group.append(case)
        closing = Closing(self.edges, name)
        held = [
            Held((answer,), own, region)
            for answer, own in groups
            for region in self.apart(closing.parted(answer, own), needing=True)
        ]
        closed = closing.closed(held)
        regions = list(zip(closed, held, strict=True))
        told = [
            replace(answer, conditions=self.equalities(region))
            for answer, _ in groups
            for region in united([own for own, item in regions if item.answers[0] is answer], self.space)
        ]
        alone, bare = closing.alone(held, closed)
        told += self.told_on_edges(alone)
        known = {edge.equality for edge, *_ in alone}
        untold = [replace(shown(one, self.space), relation="=") for one in closing.untold]
        for equality, edge in [*((edge.equality, edge) for edge in bare), *((one, None) for one in untold)]:
            other = "other " if equality in known else ""
            lacking = self.bare.setdefault((equality, other), (edge, []))[1]
            lacking += [] if told[0].symbol in lacking else [told[0].symbol]
        return replace(told[0], otherwise=tuple(told[1:]))

    def told_on_edges(self, alone: Sequence[tuple[Edge, Solved, Answer]]) -> list[Answer]:
        """What holds on edges alone, with the conditions under which it does."""
        groups: list[tuple[Edge, Answer, list[Region]]] = []
        for edge, case, answer in alone:
            try:
                put = answer_put(answer, edge, self.space)
            except ZeroDivisionError:  # its form has no value there: of that edge nothing is told
                continue
            like = (found for other, told, found in groups if other.equality == edge.equality and same_form(told, put))
            regions = next(like, None)
            if regions is None:
                groups.append((edge, put, [case.conditions]))
            else:
                regions.append(case.conditions)
        return [
            replace(answer, conditions=(edge.equality, *self.equalities(needed(region, self.space))))
            for edge, answer, regions in groups
            for region in united(regions, self.space)
        ]

    def apart(self, own: Sequence[Solved], *, needing: bool = False) -> list[Region]:
        """Where cases of one answer hold, in as few regions as are found; with what their answers need."""
        needs = [needs_within(case) if needing and not case.objected else () for case in own]
        if all(alike_provisos(one, needs[0]) for one in needs):
            return [needed((*region, *needs[0]), self.space) for region in self.regions(own)]
        told = [needed((*self.regions([case])[0], *extra), self.space) for case, extra in zip(own, needs, strict=True)]
        return [needed(region, self.space) for region in united(told, self.space)]

    def regions(self, cases: Sequence[Solved]) -> list[Region]:
        """Where one of some cases holds."""
        return [needed(region, self.space) for region in united([case.bars for case in cases], self.space)]

    def needing(self) -> list[tuple[Needed, list[Solved]]]:
        """What answers need, each once, with the cases in which they do."""
        found: list[tuple[Needed, list[Solved]]] = []
        for case in self.good:
            for need in () if case.objected else case.needs:
                like = (
                    own for other, own in found if other.proviso.same(need.proviso) and other.failing == need.failing
                )
                cases = next(like, None)
                if cases is None:
                    found.append((need, [case]))
                else:
                    cases.append(case)
        return found

    def lacking(self, named: Collection[str]) -> list[tuple[list[str], str, list[Solved]]]:
        """The questions that have no answer in some of the cases, those together that have none for one reason in the same ones."""
        refused: dict[tuple[str, str], list[Solved]] = {}
        for case in self.good:
            for item in case.found.refused if case.found is not None else ():
                if item.name in named:
                    refused.setdefault((item.name, item.fault.message), []).append(case)
        found: list[tuple[list[str], str, list[Solved]]] = []
        for (name, why), cases in refused.items():
            like = next((names for names, reason, own in found if reason == why and own == cases), None)
            if like is None:
                found.append(([name], why, cases))
            else:
                like.append(name)
        return found

    def equalities(self, provisos: Sequence[Proviso]) -> tuple[Equality, ...]:
        """Conditions as a page tells them."""
        return tuple(dict.fromkeys(shown(one, self.space) for one in provisos))

    def failing(self, named: Collection[str]) -> tuple[Check, ...]:
        """Where there is no answer, or none for one of those that are named, and why."""
        found: dict[Words, None] = {}
        alike: dict[Words, list[Solved]] = {}
        for case in self.bad:
            if case.found is not None and any(alike_provisos(case.conditions, one.conditions) for one in self.good):
                continue  # what it needs is told by the other
            alike.setdefault(why_no_answer(case), []).append(case)
        for why, cases in alike.items():
            none = self.lack_words(*map(refusal_kind, cases))
            for region in map(partial(self.closed_without, why, ()), self.regions(cases)):
                found[(f"{self.where(region)}{none}: ", *why)] = None
        for names, reason, cases in self.lacking(named):
            letters = [part for name in names for part in (", ", Symbol(name))][1:]
            told = (item for case in cases if case.found is not None for item in case.found.refused)
            none = self.lack_words(*(item.fault.kind for item in told if item.name in names))
            for region in map(partial(self.closed_without, (reason,), names), self.regions(cases)):
                found[(f"{self.where(region)}{none} for ", *letters, f": {reason}")] = None
        for need, cases in self.needing():
            broken = Proviso(simplify(-need.proviso.gap), not need.proviso.strict)
            for region in self.regions(cases):
                if follows(need.proviso, region, self.space):
                    continue  # it can not fail there
                line = in_a_line(self.equalities(needed((*region, broken), self.space)))
                found[(f"if {line} {self.lack_words()}: ", *need.failing)] = None
        for (equality, other), (edge, lacking) in self.bare.items():
            solved = None if edge is None else self.edges.solved_at(edge)
            said = why_no_answer(solved) if solved is not None and unanswered_in(solved) else ()
            if said not in alike:
                line = f"if {in_a_line((equality,))} no {other}answer is given for "
                found[(line, *in_a_row(lacking), *((": ", *said) if said else ()))] = None
        checks = [Check(words, None) for words in found]
        return (*checks, *([Check((MORE_CASES,), None, more=True)] if self.more else []))

    def where(self, region: Sequence[Proviso]) -> str:
        """The condition of a region at the head of what is said of it; nothing where it is all there is."""
        line = in_a_line(self.equalities(region))
        return f"if {line} " if line else ""

    def lack_words(self, *kinds: str) -> str:
        """What is said where there is none: of a letter that is sought only those values are known to which the ways tried lead, and
        that something is not solved is no reason why there should be none."""
        problem = self.space.problem
        sought = problem.sought or any(find.seeks for find in problem.finds)
        return "no answer is found" if sought or UNSOLVED in kinds else "there is no answer"

    def closed_without(self, why: Words, names: Collection[str], region: Region) -> Region:
        """A region without an answer, or with none for those that are named, with those of its edges on which there is none for the same
        reason, and no others that are known."""

        def open_at(one: Proviso) -> bool:
            edge = self.edges.known_at(one, region)
            case = None if edge is None else self.edges.solved_at(edge)
            if case is None:  # of an edge that is not solved nothing is said
                return one.strict or edge is not None or self.edges.untold(one.gap)
            if unanswered_in(case):
                return why_no_answer(case) != why
            return not names or bool({answer.name for answer in told_in(case)}.intersection(names))

        return tuple(replace(one, strict=open_at(one)) for one in region)


def with_cases(cases: Sequence[Solved], edges: Edges[Derivation], *, more: bool) -> Derivation:
    """The derivation of all cases; those to which their own checks object count only where there are no others."""
    good = [case for case in cases if case.found is not None and not case.objected]
    good = good or [case for case in cases if case.found is not None]
    return CaseTeller(good, [case for case in cases if case not in good], edges.space, edges, {}, more).derivation()


def doubts_besides(main: Derivation, cases: Sequence[Solved]) -> tuple[Check, ...]:
    """What other cases than that of a derivation leave open of themselves, each once: an answer of theirs stands beside it."""
    checks = (check for case in cases if case.found is not None for check in case.found.checks)
    return tuple(dict.fromkeys(check for check in checks if check.holds is None and check not in main.checks))


def needs_within(case: Solved) -> tuple[Proviso, ...]:
    """What the answers of a case need."""
    return tuple(need.proviso for need in case.needs)


def alike_provisos(one: Sequence[Proviso], other: Sequence[Proviso]) -> bool:
    """Whether these conditions are those."""
    return len(one) == len(other) and all(any(map(proviso.same, other)) for proviso in one)


def same_form(one: Answer, other: Answer) -> bool:
    """Whether two cases answer a question alike; a choice with the values that it was made by, a function of time for as long."""
    weighed = list(zip_longest(one.weighed, other.weighed))
    if not all(first is not None and last is not None and equal(first, last) for first, last in weighed):
        return False
    words = [
        (answer.name, answer.word, answer.direction, answer.positive, answer.until, len(answer.components))
        for answer in (one, other)
    ]
    if words[0] != words[1] or not all(map(same_form, one.components, other.components)):
        return False
    forms = (one.closed or one.formula, other.closed or other.formula)
    if forms[0] is None or forms[1] is None:
        return forms[0] is forms[1]
    return equal(forms[0], forms[1])


def same_forms(one: Solved, other: Solved) -> bool:
    """Whether two cases have the same answers; where they hold up to a state on the way, with the same states."""
    if any(answer.until for answer in told_in(one)) and states_of(one) != states_of(other):
        return False
    return len(told_in(one)) == len(told_in(other)) and all(map(same_form, told_in(one), told_in(other)))


def says_more(one: Solved, other: Solved) -> bool:
    """Whether a case has all the answers of another, and more."""
    known = {answer.name: answer for answer in told_in(one)}
    return len(known) > len(told_in(other)) and all(
        answer.name in known and same_form(answer, known[answer.name]) for answer in told_in(other)
    )


def states_of(case: Solved) -> tuple[Words, ...]:
    """What is said of the states of a case, those on its way among them."""
    return case.found.states if case.found is not None else ()


def told_in(case: Solved) -> tuple[Answer, ...]:
    """The answers of a case."""
    return case.found.answers if case.found is not None else ()


def in_order(names: Iterable[str], problem: Problem) -> list[str]:
    """Names of answers as they are asked for."""
    order = {find.group: place for place, find in reversed(list(enumerate(problem.finds)))}
    return sorted(names, key=lambda name: order.get(name, len(order)))


def headed(key: tuple[Equality, ...], case: Solved, known: Sequence[Words]) -> tuple[Section, ...]:
    """The sections of a case below its conditions, and the states on its way that are not known."""
    assert case.found is not None
    own = tuple(words for words in states_of(case) if words not in known)
    title, sections = f"If {in_a_line(key)}", case.found.sections
    if len(sections) == 1 and not sections[0].title:
        return (replace(sections[0], title=title, remarks=(*own, *sections[0].remarks), case=key),)
    inner = (replace(one, title=one.title or "So", case=key) for one in sections)
    return Section(title, remarks=own, case=key), *inner


def in_a_line(conditions: Sequence[Equality]) -> str:
    """Conditions in a line of text."""
    return " and ".join(map(condition_line, conditions))


def refusal_kind(case: Solved) -> str:
    """The kind of the fault for which a case without an answer was refused."""
    return case.fault.fault.kind if isinstance(case.fault, Unsolvable) else ""


def why_no_answer(case: Solved) -> Words:
    """Why a case has no answer: what its checks object to, else the fault for which it was refused."""
    if case.found is not None:
        return next(check.words for check in case.found.checks if check.holds is False)
    fault = getattr(case.fault, "fault", None)
    return (str(fault.message if fault is not None else case.fault),)
