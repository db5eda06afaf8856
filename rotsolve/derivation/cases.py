"""Cases told: the answers of all cases of letters side by side, each with the conditions under which it holds."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Answer, Check, Derivation, Equality, Section, Words
from rotsolve.search.cases import Case, LetterSpace, Proviso, separating, shown

Solved = Case[Derivation]


def with_cases(cases: Sequence[Solved], space: LetterSpace) -> Derivation:
    """The derivation of the first case with an answer, with the others behind it: what differs between them says when it holds."""
    good = [case for case in cases if case.found is not None and not case.objected]
    good = good or [case for case in cases if case.found is not None]
    main = good[0].found
    assert main is not None
    bad = [case for case in cases if case not in good]
    answers = tuple(piecewise(place, good, bad, space) for place in range(len(main.answers)))
    told = {case_key(case, good, bad, space): case for case in reversed(good)}
    sections = main.sections
    if len(told) > 1:
        sections = tuple(section for key, case in reversed(told.items()) for section in headed(key, case, space))
    checks = (*main.checks, *no_answers(bad, good, space))
    said = (*main.conventions, *((words,) for words in space.assumptions()))
    return replace(main, answers=answers, sections=sections, checks=checks, conventions=said)


def piecewise(place: int, good: Sequence[Solved], bad: Sequence[Solved], space: LetterSpace) -> Answer:
    """An answer with the conditions under which it holds, and what it is in other cases."""
    groups: list[tuple[Answer, list[Solved]]] = []
    for case in good:
        assert case.found is not None
        answer = case.found.answers[place]
        group = next((own for other, own in groups if same_answer(answer, other)), None)
        if group is None:
            groups.append((answer, [case]))
        else:
            group.append(case)
    told = []
    for answer, own in groups:
        others = [case for case in (*good, *bad) if case not in own]
        for conditions in alternatives(own, others):
            told.append(replace(answer, conditions=tuple(shown(one, space) for one in conditions)))
    return replace(told[0], otherwise=tuple(told[1:]))


def alternatives(own: Sequence[Solved], others: Sequence[Solved]) -> list[tuple[Proviso, ...]]:
    """The conditions that tell cases of one answer from all others, for all of them together where that goes."""
    whole = separating(own, others)
    if whole is not None:
        return [whole]
    return [separating([case], others) or case.conditions for case in own]


def same_answer(one: Answer, other: Answer) -> bool:
    """Whether two cases answer a question alike."""
    if (one.word, len(one.components)) != (other.word, len(other.components)):
        return False
    forms = (one.closed or one.formula, other.closed or other.formula)
    if forms[0] is None or forms[1] is None:
        return forms[0] is forms[1] and all(map(same_answer, one.components, other.components))
    return equal(forms[0], forms[1])


def case_key(case: Solved, good: Sequence[Solved], bad: Sequence[Solved], space: LetterSpace) -> tuple[Equality, ...]:
    """The conditions that tell a case from those whose answers differ from its own."""
    own = [other for other in good if alike(case, other)]
    others = [other for other in (*good, *bad) if other not in own]
    conditions = alternatives(own, others)[0]
    return tuple(shown(one, space) for one in conditions)


def alike(one: Solved, other: Solved) -> bool:
    """Whether two cases have the same answers."""
    assert one.found is not None and other.found is not None
    return all(map(same_answer, one.found.answers, other.found.answers))


def headed(key: tuple[Equality, ...], case: Solved, space: LetterSpace) -> tuple[Section, ...]:
    """The sections of a case below its conditions."""
    assert case.found is not None
    title = "If " + " and ".join(told(one) for one in key)
    return (Section(title), *(replace(one, title=one.title or "So") for one in case.found.sections))


def told(condition: Equality) -> str:
    """A condition in a line of text."""
    return f"{to_text(condition.left)} {condition.relation} {to_text(condition.right)}"


def no_answers(bad: Sequence[Solved], good: Sequence[Solved], space: LetterSpace) -> tuple[Check, ...]:
    """Where there is no answer, and why."""
    found: list[Check] = []
    for case in bad:
        conditions = separating([case], good) or case.conditions
        words = " and ".join(told(shown(one, space)) for one in conditions)
        check = Check((f"if {words} there is no answer: ", *why_none(case)), None)
        if check not in found:
            found.append(check)
    return tuple(found)


def why_none(case: Solved) -> Words:
    """Why a case has no answer: what its checks object to, else the fault for which it was refused."""
    if case.found is not None:
        return next(check.words for check in case.found.checks if check.holds is False)
    fault = getattr(case.fault, "fault", None)
    return (str(fault.message if fault is not None else case.fault),)
