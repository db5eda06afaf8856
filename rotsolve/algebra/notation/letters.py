"""Letters: how an ASCII name such as `theta0` is written in text (θ₀), in LaTeX (\\theta_{0}), and read back.

Reading and printing share these tables, so that what is printed can always be read again.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache

from msgspec import Struct
from msgspec.structs import replace

_GREEK = """
    α alpha β beta γ gamma δ delta ε epsilon ζ zeta η eta θ theta ι iota κ kappa λ lambda μ mu ν nu ξ xi π pi ρ rho
    σ sigma τ tau υ upsilon φ phi χ chi ψ psi ω omega
    Γ Gamma Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi Σ Sigma Φ Phi Ψ Psi Ω Omega
"""
_GREEK_WORDS = _GREEK.split()
LETTER_NAMES = dict(zip(_GREEK_WORDS[::2], _GREEK_WORDS[1::2], strict=True))  # θ -> theta
GREEK_LETTERS = {name: letter for letter, name in LETTER_NAMES.items()}  # theta -> θ
# Other code points that look like these letters: micro sign, ohm sign, increment, and the curly variants.
LETTER_NAMES |= {"µ": "mu", "Ω": "Omega", "∆": "Delta", "ϑ": "theta", "ϕ": "phi", "ϵ": "epsilon", "ϱ": "rho"}

SUBSCRIPTS = dict(zip("0123456789aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", strict=True))
_LETTERS = frozenset(SUBSCRIPTS) - frozenset("0123456789")  # H_x, r_i
_UNSUBSCRIPT = {sub: plain for plain, sub in SUBSCRIPTS.items()}
SUPERSCRIPTS = dict(zip("0123456789-+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", strict=True))
_UNSUPERSCRIPT = {raised: plain for plain, raised in SUPERSCRIPTS.items()}

FRACTIONS = {  # glyph -> value
    glyph: Fraction(int(parts[0]), int(parts[1:]))
    for glyph, parts in zip(
        "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅐⅛⅜⅝⅞⅑⅒",
        ["12", "13", "23", "14", "34", "15", "25", "35", "45", "16", "56", "17", "18", "38", "58", "78", "19", "110"],
        strict=True,
    )
}
DOTS = "…"  # what stands for a formula that no page can hold
GLYPHS = {value: glyph for glyph, value in FRACTIONS.items()}

_GREEK_CLASS = "".join(LETTER_NAMES)
_SUB_CLASS = "".join(_UNSUBSCRIPT)
# A run of name characters, and the names into which a run falls apart at its Greek letters and subscripts: `2πr`, `m₁g`.
RUN = rf"[A-Za-z{_GREEK_CLASS}][A-Za-z0-9_{_GREEK_CLASS}{_SUB_CLASS}]*"
SEGMENT = rf"(?:[{_GREEK_CLASS}][0-9]*|[A-Za-z][A-Za-z0-9]*)[{_SUB_CLASS}]*(?:_[A-Za-z0-9{_GREEK_CLASS}]+)*"

INDEXED = re.compile(r"([A-Za-z]+)_?([0-9]+)")  # m1, omega_2
_WORDED = re.compile(r"([A-Za-z]+)([0-9]*)_([A-Za-z0-9_]+)")  # a_end, theta0_end
_CHANGE = rf"[dD]elta_([A-Za-z]|{'|'.join(GREEK_LETTERS)})_?([0-9]*)"  # delta_theta, delta_K1; compiled late: rare
_RUNNING = re.compile(r"([A-Za-z0-9_]+)\(([A-Za-z0-9_]+)\)")  # omega(t)
PRIME = "'"  # marks a variable of integration beside its end: omega'
DOT = "˙"  # behind the letter of a coordinate: its rate, x˙ is ẋ, and x˙˙ ẍ
_OVER = ("", "\u0307", "\u0308")  # the dots above a letter
_TRAILING_INDEX = re.compile(r"(?<=[A-Za-z])_?([0-9]+)$")


def spellings(raw: str) -> tuple[str, ...]:
    """The ASCII names that `raw` may stand for, the likeliest first: `ω₂` is `omega2` or `omega_2`."""
    digits_plain: list[str] = []
    digits_joined: list[str] = []
    in_subscript = False
    for char in raw:
        plain = _UNSUBSCRIPT.get(char)
        if plain is None:
            piece = LETTER_NAMES.get(char, char)
            digits_plain.append(piece)
            digits_joined.append(piece)
        else:
            joint = "" if in_subscript else "_"
            digits_plain.append(plain if plain.isdigit() else joint + plain)
            digits_joined.append(joint + plain if plain.isdigit() else plain)
        in_subscript = plain is not None
    if raw[0] in "Δ∆" and raw[1:2].isalpha() and raw[1] not in _UNSUBSCRIPT:  # Δθ is delta_theta
        return tuple(f"{delta}_{name}" for delta in ("delta", "Delta") for name in spellings(raw[1:]))
    first, second = "".join(digits_plain), "".join(digits_joined)
    index = _TRAILING_INDEX.search(first)
    if index is None:
        return (first,) if first == second else (first, second)
    head = first[: index.start()]
    return tuple(dict.fromkeys((first, second, head + index[1], f"{head}_{index[1]}")))


def subscripted(text: str) -> str:
    return "".join(SUBSCRIPTS[char] for char in text)


def superscripted(number: int) -> str:
    return "".join(SUPERSCRIPTS[char] for char in str(number))


def from_superscript(text: str) -> str:
    """ASCII digits and signs of a run of superscripts."""
    return "".join(_UNSUPERSCRIPT[char] for char in text)


def greek(head: str) -> str:
    """The Greek letter of that name; any other head as it stands."""
    return GREEK_LETTERS.get(head, head)


class Letter(Struct, frozen=True):
    """A name in its parts: Δ in front, the letter, what stands below it (digits, a word), a prime, dots, and what it is a function of."""

    head: str
    index: str = ""
    word: str = ""
    change: bool = False
    prime: bool = False
    dots: int = 0
    of: str = ""


def parts(name: str) -> Letter | None:
    """The parts of an ASCII name; None for one that no letter is made of, such as a path."""
    if name[1:6] == "elta_" and (match := re.fullmatch(_CHANGE, name)):
        return Letter(match[1], match[2], change=True)
    if match := _RUNNING.fullmatch(name):
        inner = parts(match[1])
        return None if inner is None else replace(inner, of=match[2])
    if name.endswith(PRIME):
        inner = parts(name.removesuffix(PRIME))
        return None if inner is None else replace(inner, prime=True)
    if name.endswith(DOT):
        inner = parts(name.removesuffix(DOT))
        return None if inner is None else replace(inner, dots=inner.dots + 1)
    if match := INDEXED.fullmatch(name):
        return Letter(match[1], match[2])
    if match := _WORDED.fullmatch(name):
        return Letter(match[1], match[2], match[3])
    return Letter(name) if name.isalpha() and name.isascii() else None


@lru_cache(2048)
def name_to_text(name: str) -> str:
    """An ASCII name as a textbook writes it: `theta0` is θ₀, `H_x` is Hₓ, `delta_K` is ΔK, `omega(t)` is ω(t); paths stay."""
    letter = parts(name)
    if letter is None:
        return name
    low = not letter.index and letter.word in _LETTERS
    below = subscripted(letter.word) if low else f"_{letter.word}" if letter.word else ""
    head = greek(letter.head) + _OVER[letter.dots]
    text = f"{'Δ' * letter.change}{head}{subscripted(letter.index)}{below}{'′' * letter.prime}"
    return f"{text}({name_to_text(letter.of)})" if letter.of else text


def _latex_head(head: str) -> str:
    if head in GREEK_LETTERS:
        # \\epsilon is drawn ϵ, which is not the letter that the text form prints.
        return r"\varepsilon" if head == "epsilon" else rf"\{head}"
    return head if len(head) == 1 else rf"\mathrm{{{head}}}"


def _latex_subscript(text: str) -> str:
    if text in GREEK_LETTERS:
        return _latex_head(text)
    return text if len(text) == 1 or text.isdigit() else rf"\mathrm{{{text.replace('_', ',')}}}"


def name_to_latex(name: str) -> str:
    """An ASCII name in LaTeX: `theta0` is \\theta_{0}, `a_end` is a_{\\mathrm{end}}."""
    letter = parts(name)
    if name == DOTS:
        return r"\dots"
    if letter is None:
        return rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"
    below = ",".join(filter(None, (letter.index, _latex_subscript(letter.word) if letter.word else "")))
    plain = _latex_head(letter.head)
    head = rf"\{'d' * letter.dots}ot{{{plain}}}" if letter.dots else plain
    text = rf"\Delta {head}" if letter.change else head
    text += (f"_{{{below}}}" if below else "") + PRIME * letter.prime
    return f"{text}({name_to_latex(letter.of)})" if letter.of else text
