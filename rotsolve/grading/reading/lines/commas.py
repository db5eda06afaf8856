"""Commas: a decimal comma is read as a point, with a remark; so are groups of three digits."""

from __future__ import annotations

import re

from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.grading.reading.grammar.forks import Forks
from rotsolve.grading.verdict import Remark

PAIRED = frozenset(("atan2", "arctan2", "integral"))  # functions whose arguments commas part


def with_points(tokens: list[Token], forks: Forks) -> tuple[list[Token], tuple[Remark, ...]]:
    """The tokens with `4,36` as one number, and a remark for each; `12,000` may be twelve thousand."""
    if all(token.kind != "," for token in tokens):
        return tokens, ()
    result: list[Token] = []
    remarks: list[Remark] = []
    index = 0
    paired: list[bool] = []  # whether each open bracket holds the arguments of such a function
    while index < len(tokens):
        token = tokens[index]
        if token.kind == "(":
            paired.append(index > 0 and tokens[index - 1].text in PAIRED)
        elif token.kind == ")" and paired:
            paired.pop()
        groups = [] if any(paired) else digit_groups(tokens, index)
        if len(groups) > 1:
            number, remark = joined(groups, forks)
            result.append(number)
            remarks.append(remark)
            index += 2 * len(groups) - 1
        else:
            result.append(token)
            index += 1
    return result, tuple(remarks)


def digit_groups(tokens: list[Token], index: int) -> list[Token]:
    """The numbers from a place on that commas join without a space."""
    groups: list[Token] = []
    while tokens[index].kind == "number":
        groups.append(tokens[index])
        comma = tokens[min(index + 1, len(tokens) - 1)]
        following = tokens[min(index + 2, len(tokens) - 1)]
        joins = comma.kind == "," and tokens[index].end == comma.start and comma.end == following.start
        if not joins or not following.text[:1].isdigit() or not tokens[index].text.isdigit():
            break
        index += 2
    return groups


def joined(groups: list[Token], forks: Forks) -> tuple[Token, Remark]:
    """One number out of the groups, with what is to be said about it."""
    first, last = groups[0], groups[-1]
    typed = ",".join(token.text for token in groups).rstrip(".")
    heads = [re.match("[0-9]*", token.text) for token in groups]
    sizes = [len(head[0]) if head else 0 for head in heads]
    threes = sizes[0] <= 3 and set(sizes[1:]) == {3} and first.text[0] != "0"
    pointed = "." in typed
    if (pointed or len(groups) > 2) and not threes:
        raise FormulaError(f"`{typed}` is no number: it has too many marks", first.start, last.end)
    if threes and (pointed or len(groups) > 2 or forks.choose(last.text == "000")):
        text = typed.replace(",", "")
        words = f"`{typed}` is read as {text}"
    else:
        text = typed.replace(",", ".")
        words = f"`{typed}` is read as {text}: a decimal number takes a point"
    return Token("number", text, first.start, last.end), Remark("comma", (words,), first.start, last.end)
