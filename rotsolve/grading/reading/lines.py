"""Lines: what stands round the values of a line: words that say nothing of it, directions, signs of equality, decimal commas.

Blanks take the place of words as `about`, so that every other character keeps its column. Of a chain
`a = 2/3 · 9.81 · 0.5 = 3.27 m/s²` the last member is the answer, the others are the way to it. A decimal comma is read as a point, with a
remark; so are groups of three digits.
"""

from __future__ import annotations

import re

from rotsolve.algebra.notation.cursor import Forks
from rotsolve.algebra.notation.tokens import FUNCTION_NAMES, FormulaError, Token
from rotsolve.grading.reading.numbers import (
    are_letters,
    could_be_number,
    cut_at_unit,
    is_kind,
    is_unit_run,
    likely_number,
)
from rotsolve.grading.reading.prose import LEADING
from rotsolve.grading.reading.records import Names
from rotsolve.grading.reading.tokens import MAX_LENGTH, tokens_of
from rotsolve.grading.reading.vocabulary import run_meaning
from rotsolve.grading.verdict import Remark

_ABOUT = re.compile(
    r"(?P<before>^|[=≈:])\s*(?:ca|approx|approximately|about|roughly|circa)\b\.?(?=\s*[-+−]?[\d.√(\\])", re.IGNORECASE
)
_TRANSPOSED = re.compile(
    r"(?<=[\])}])\s*(?:\^\s*(?:\{\s*)?(?:\\(?:top|mathsf\{T\}|mathrm\{T\}|intercal)|T(?![A-Za-z]))(?:\s*\})?|ᵀ)"
)
_TIMES_TEN = re.compile(r"(?<=[0-9])(?P<gap>\s*)[xX](?=\s*10\s*(?:\^|\*\*|[⁻⁰¹²³⁴-⁹]))")  # 5.12x10^-1
_THOUSANDS = re.compile(
    r"(?<![\w.,^])[0-9]{1,3}(?:(?:[ \u00a0\u2009\u202f'’]|\\,)[0-9]{3})+(?![\w^]|[⁻⁰¹²³⁴-⁹])"
)  # 14 700
_ASIDE = re.compile(r"(?<=[\w.²³°)])\s+\((?P<words>[A-Za-zäöüß][A-Za-zäöüß ,'’-]+)\)[\s.]*$")
_DENIES = frozenset(("not", "no", "or", "if", "when", "wrong", "nicht", "oder", "falls", "wenn", "minus", "times"))
LEAST_WORD = 3  # letters of a word in an aside, else they may be letters of the scene
_IS = re.compile(r"^(?P<name>\s*\\?[^\W\d_][\w{}\\]*\s*)(?P<sign>:(?!=)|(?<=\s)is\b)(?=\s*\S)")
_SIGNED = r"[-+−]?\d+(?:[.,]\d+)?"
_SPACED = re.compile(rf"[\[(](?P<numbers>\s*{_SIGNED}(?:\s+{_SIGNED})+\s*)[\])]")
_BARRED = re.compile(r"[\[(](?P<parts>[^|;()\[\]]*(?:\|[^|;()\[\]]+)+)[\])]")
_JUST_NAMED = re.compile(r"\s*([^\W\d_]\w*)\s(?=\s*[-+−]?[\d.])")  # a 2.96 m/s²
_CAPITAL = re.compile(r"(?<![A-Za-z_\\])(?:SIN|COS|TAN|SQRT|Sin|Cos|Tan|Sqrt)(?![A-Za-z_])")
_PER = re.compile(  # metres per second squared
    r"(?<=[A-Za-z²³Å\d])(?P<blank>\s+)(?P<word>per|pro|je|squared|cubed|zum [Qq]uadrat|hoch zwei|hoch drei)\b"
)
_PER_MARKS = {
    **dict.fromkeys(("per", "pro", "je"), "/"),
    **dict.fromkeys(("squared", "zum Quadrat", "zum quadrat", "hoch zwei"), "^2"),
    **dict.fromkeys(("cubed", "hoch drei"), "^3"),
}
_SECONDS = re.compile(  # else it is the secant
    r"(?<=[\d\s/·*])secs?(?![A-Za-z])\.?(?=\s*(?:\^?\(?[-−]?\d\)?|[⁻²³¹]+)?\s*(?:$|[/;,)*·]|per\b|squared|cubed))"
)
_SQUARE = re.compile(
    r"(?P<power>square|cubic|Quadrat|Kubik)(?P<gap>\s*)(?P<unit>[a-zµ]*(?:met(?:er|re)s?|inch(?:es)?|feet|foot|yards?|sekunden?|seconds?))\b"
)
_DIRECTIONS = {
    "left": r"left(?:wards?)?|←|\\leftarrow",
    "right": r"right(?:wards?)?|→|\\rightarrow",
    "up": r"up(?:wards?|hill)?|vertically up(?:wards?)?|↑|\\uparrow",
    "down": r"down(?:wards?|hill)?|vertically down(?:wards?)?|↓|\\downarrow",
    "counterclockwise": r"counter-?\s?clockwise|anti-?\s?clockwise|ccw|↺",
    "clockwise": r"clockwise|cw|↻",
    "forward": r"forwards?",
    "back": r"back(?:wards?)?",
}
_GROUPS = "|".join(f"(?P<{word}>{pattern})" for word, pattern in _DIRECTIONS.items())
_SLOPE = r"(?P<slope>\s+(?:along\s+)?the\s+(?:slope|incline|inclined plane|plane|ramp|hill))?"
_TAIL = (  # compiled when a line first needs it
    rf"(?<![A-Za-z_\\])[\s,;(\[]*(?:\\text\s*\{{\s*)?(?:(?:directed|pointing|acting|to|towards|on)\s+)*(?:the\s+)?(?:{_GROUPS}){_SLOPE}[\s).}}\]$]*$"
)
_ENDINGS = "ft ht rd ds up wn se cw ck ne pe mp ll ow"
ENDINGS = frozenset((*_ENDINGS.split(), *"←→↑↓↺↻"))  # the last letters of these words
LONGEST_DIRECTION = 80  # columns of such words
EQUALS = re.compile(r"(?<![<>!]):?==?|[≈≃＝]|\\(?:approx|simeq)(?![A-Za-z])")
ABOUT = frozenset(("≈", "≃", "\\approx", "\\simeq"))
# what stands between members
_LEADS = re.compile(rf"=>|⇒|[-–]>|→|∴|(?:[,;]\s*)?(?:\bthat is\b|\bi\.e\.),?|{EQUALS.pattern}|;")
WORD_ENDS = ("s", ".", ",")  # how the leads end that are words
_IN_BRACKETS = re.compile(r"(?P<formula>.*\S)\s+\((?P<value>[≈\s]*[-+−]?\d[^()]*)\)\s*$")  # 3/5 g sin β (2.49 m/s²)
_NAME = r"\\?[^\W\d_][\w{}\\]*(?:\(t\))?"
_ALONE = re.compile(rf"[\s$]*({_NAME})[\s$]*")
_SET = str.maketrans("", "", "\\{}$ ")  # what only says how letters are set: \omega_{0} is omega_0
# `a = 3 m/s², T` before another `=`
_NEXT_ANSWER = re.compile(
    rf"(?:[,;\n]|\b(?:and|or|so|hence|thus|then|therefore|und|oder)\b|&|\\\\)\s*\$?\s*{_NAME}\s*$"
)
CALLED = tuple(FUNCTION_NAMES)  # in the brackets behind them commas part arguments


def without_asides(text: str, names: Names) -> str:
    """The line without words that say nothing of its value."""
    if _ABOUT.search(text):
        text = _ABOUT.sub(lambda match: match["before"] + blanks(match[0][len(match["before"]) :]), text)
    if "," in text or ";" in text or "&" in text:
        text = _TRANSPOSED.sub(lambda match: blanks(match[0]), text)
    if names.components > 1:
        text = with_parting_marks(text, names.components)
    elif names.asked not in names.givens and (told := _JUST_NAMED.match(text)) and names.is_asked(told[1]):
        text = f"{text[: told.end() - 1]}={text[told.end() :]}"
    text = _IS.sub(lambda match: f"{match['name']}{'=':>{len(match['sign'])}}", text)
    text = _PER.sub(lambda match: match["blank"] + _PER_MARKS[match["word"]].ljust(len(match["word"])), text)
    text = _SECONDS.sub(lambda match: "s".ljust(len(match[0])), text)
    text = _SQUARE.sub(powered_behind, text)
    text = _CAPITAL.sub(lambda match: match[0].lower(), text)
    return text


def with_parting_marks(text: str, count: int) -> str:
    """The components of a vector parted by `;` where there are `count` with blanks between, `[5 -5 -5]`, or bars: `(5|-5|-5)`."""
    spaced = _SPACED.search(text)
    if spaced is not None and len(spaced["numbers"].split()) == count:
        numbers = re.sub(r"\s(?=\S)", ";", spaced["numbers"].strip()).rjust(len(spaced["numbers"].rstrip()))
        return text[: spaced.start("numbers")] + numbers.ljust(len(spaced["numbers"])) + text[spaced.end("numbers") :]
    barred = _BARRED.search(text)
    if barred is not None and barred["parts"].count("|") == count - 1 and text.count("|") == count - 1:
        return text.replace("|", ";")
    return text


def with_plain_numbers(text: str, names: Names) -> str:
    """The line with a mark for the x of `5.12x10^-1`, and without the gaps of `14 700`, each in its columns."""
    if "x" not in names.letters and "X" not in names.letters:
        text = _TIMES_TEN.sub(r"\g<gap>*", text)
    return _THOUSANDS.sub(lambda match: re.sub(r"[^0-9]", "", match[0]).rjust(len(match[0])), text)


def cut_aside(text: str, names: Names) -> tuple[str, str]:
    """The line without the words in brackets behind its number, `14.7 J (friction)`, and these; '' where they may say something else."""
    match = _ASIDE.search(text)
    words = [] if match is None else re.findall(r"[^\W\d_]+", match["words"])
    if match is None or not any(char.isdigit() for char in text[: match.start()]):
        return text, ""
    means_more = any(
        len(word) < LEAST_WORD or word.lower() in _DENIES or is_unit_run(word) or run_meaning(word, names.letters)
        for word in words
        if word.lower() not in LEADING
    )
    if means_more or direction_behind(text, 0)[0]:
        return text, ""
    return text[: match.start()], match[0].strip(" .")


def powered_behind(match: re.Match[str]) -> str:
    """`square metres` as metres², in as many columns."""
    power = "²" if match["power"] in ("square", "Quadrat") else "³"
    return f"{match['unit']}{power}".ljust(len(match[0]))


def blanks(words: str) -> str:
    return " " * len(words)


# directions


def direction_behind(text: str, start: int) -> tuple[str, int]:
    """The direction that the last words of a line tell ('' if none), and where these words begin."""
    ending = text.rstrip(" .)}]$")[-2:].lower()
    if ending not in ENDINGS and ending[-1:] not in ENDINGS:
        return "", len(text)
    match = re.compile(_TAIL, re.IGNORECASE).search(text, max(start, len(text) - LONGEST_DIRECTION))
    if match is None or not text[start : match.start()].strip():
        return "", len(text)
    word = next(name for name in _DIRECTIONS if match[name])
    return (f"{word} the slope" if match["slope"] else word), match.start()


# chains


def chain_members(text: str, names: Names) -> tuple[str, ...]:
    """The members of a chain, each at its place in the line, with blanks before it; nothing where the line is none.

    A name in front that is the one asked for is no member. What tells another name, or is an equation with the asked one in it, is no
    chain of values, nor are several answers in one line.
    """
    pieces = _chain_pieces(text, names) if len(text) <= MAX_LENGTH else []
    if len(pieces) < 2:
        return ()
    alone = _ALONE.fullmatch(pieces[0])
    if not pieces[0].strip(" $") or (alone and names.is_asked(alone[1].removesuffix("(t)").translate(_SET))):
        pieces = pieces[1:]
    elif alone or _holds_asked(pieces[0], names):
        return ()
    whole = len(pieces) > 1 and all(piece.strip(" $") for piece in pieces)
    return tuple(pieces) if whole and not any(_NEXT_ANSWER.search(piece) for piece in pieces[:-1]) else ()


def _chain_pieces(text: str, names: Names) -> list[str]:
    """What stands between the signs of equality, those that lead from one value to the next, and a value in brackets behind a formula."""
    pieces, start = [], 0
    for sign in _LEADS.finditer(text):
        if EQUALS.fullmatch(sign[0]) is None and _open_brackets(text[start : sign.start()]):
            continue  # ; in a vector, → between the ends of an integral
        if sign[0][-1:] in WORD_ENDS and not any(char.isdigit() for char in text[sign.end() :]):
            continue  # −8 N, i.e. left
        pieces.append(" " * start + text[start : sign.start()])
        start = sign.end()
    last = " " * start + text[start:]
    behind = _IN_BRACKETS.fullmatch(last)
    if behind and any(char.isalpha() for char in behind["formula"]) and _is_number_with_unit(behind["value"], names):
        return [*pieces, behind["formula"], " " * behind.start("value") + behind["value"]]
    return [*pieces, last]


def _is_number_with_unit(text: str, names: Names) -> bool:
    """Whether a text is a number with a unit, which is not made of letters of the scene."""
    try:
        parts = cut_at_unit(tokens_of(text.replace("≈", " ")), names.letters)
    except FormulaError:
        return False
    if not parts.has_unit or not could_be_number(parts):
        return False
    return not are_letters(parts.unit[:-1], names.letters) or (is_kind(parts.unit) and likely_number(parts))


def _open_brackets(text: str) -> int:
    """How many brackets are open."""
    return sum((char in "([{") - (char in ")]}") for char in text)


def _holds_asked(piece: str, names: Names) -> bool:
    """Whether the name that is asked for stands in a piece as a word of its own."""
    return any(names.is_asked(match[0]) for match in re.finditer(r"[^\W\d_]\w*", piece))


# commas


def with_points(tokens: list[Token], forks: Forks) -> tuple[list[Token], tuple[Remark, ...]]:
    """The tokens with `4,36` as one number, and a remark for each; `12,000` may be twelve thousand."""
    if all(token.kind != "," for token in tokens):
        return tokens, ()
    result: list[Token] = []
    remarks: list[Remark] = []
    index = 0
    paired: list[bool] = []  # whether each open bracket holds the arguments of a function
    while index < len(tokens):
        token = tokens[index]
        if token.kind == "(":
            before = tokens[index - 1] if index else token
            paired.append(before.kind == "name" and before.text.endswith(CALLED))
        elif token.kind == ")" and paired:
            paired.pop()
        groups = [] if any(paired) else digit_groups(tokens, index)
        if len(groups) > 1:
            number, remark = joined_number(groups, forks)
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


def joined_number(groups: list[Token], forks: Forks) -> tuple[Token, Remark]:
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
