r"""TeX: the formulas that a statement writes between dollar signs, as formulas of the program, which every format prints in its way.

A small part of TeX, read as TeX reads it: each letter is a variable of its own, `mgh` is m g h; what stands upright behind a number is
its unit, `9.8\,\mathrm{m/s^2}`; what is not understood is refused at its place. Nothing of the text reaches a page as it stands.
"""

from __future__ import annotations

import re
from fractions import Fraction

from rotsolve.algebra.formula import (
    ONE,
    PI,
    Call,
    Decimal,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)
from rotsolve.algebra.notation.letters import GREEK_LETTERS, PRIME
from rotsolve.algebra.notation.letters import parts as letter_parts
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.quantities import UnitError, parse_unit
from rotsolve.language.words import nearest_name, quoted
from rotsolve.page.blocks import Amount, Math, Matrix, Phrase, Styled

LONGEST = 500  # letters of a formula
DEEPEST = 30  # brackets and braces within each other
SIGNS = {
    **dict.fromkeys(("=", "<", ">"), ""),
    **{r"\lt": "<", r"\gt": ">", r"\le": "≤", r"\leq": "≤", r"\ge": "≥", r"\geq": "≥", r"\ne": "≠", r"\neq": "≠"},
    **{r"\approx": "≈", r"\to": "→", r"\rightarrow": "→", r"\ll": "≪", r"\gg": "≫", r"\pm": "±"},
    **{"≤": "≤", "≥": "≥", "≠": "≠", "≈": "≈", "→": "→", "≪": "≪", "≫": "≫", "±": "±"},
}  # between two formulas
PROSE = {",": ", ", ";": "; ", r"\quad": " ", r"\qquad": " ", r"\dots": "…", r"\ldots": "…"}
GREEK = {rf"\{name}": name for name in GREEK_LETTERS if name != "pi"}
GREEK |= {rf"\var{name}": name for name in ("epsilon", "theta", "phi", "rho", "sigma")}
FUNCTIONS = {rf"\{name}": name for name in ("sin", "cos", "tan", "exp")}
FUNCTIONS |= {r"\ln": "log", r"\arcsin": "asin", r"\arccos": "acos", r"\arctan": "atan"}
FRACTIONS = (r"\frac", r"\dfrac", r"\tfrac")
WORDS = (r"\text", r"\textrm")
UPRIGHT = (*WORDS, r"\mathrm", r"\unit")
SILENT = (r"\left", r"\right", r"\,", r"\;", r"\:", r"\!", r"\ ", r"\displaystyle", "~")
TIMES = (r"\cdot", r"\times", "·", "×", "*")
DEGREES = (r"\circ", r"\degree", "°")
KNOWN = (
    *GREEK,
    *FUNCTIONS,
    *FRACTIONS,
    *UPRIGHT,
    *SILENT,
    *TIMES,
    *DEGREES,
    *SIGNS,
    *PROSE,
    r"\sqrt",
    r"\pi",
    r"\Delta",
    r"\%",
)
NUMBER = re.compile(r"\d+(?:(?:\.|\{,\})\d+)?")
SPACE = re.compile(r"\\[,;: ]|~")
UPRIGHT_GROUP = re.compile(r"\{((?:[^{}\\]|\\[,;: ]|\\cdot|\^\{-?\d+\})*)\}")
RAISED = re.compile(r"\^\{(-?\d+)\}")
TOKEN = re.compile(rf"{NUMBER.pattern}|\\[A-Za-z]+|\\.|[^\W\d_]|\S")
UNDERSTOOD = r"understood are letters with `_` and `^`, numbers, `\frac`, `\sqrt`, `\sin`, `\alpha`, `\le`, `\approx`, `\mathrm{m/s}`"


def tex_phrase(tex: str) -> Phrase:
    """The formulas of a text of TeX with the signs and words between them. Raises FormulaError."""
    if len(tex) > LONGEST:
        raise FormulaError(f"a formula has more than {LONGEST} letters", 0, len(tex))
    return TexReader(tex).phrase()


class TexReader:
    """Reads the tokens of a text from left to right; a method reads one level of what formulas are made of."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = [(match[0], match.start()) for match in TOKEN.finditer(text)]
        self.place = self.depth = 0
        self.bars = False  # whether a bar ahead closes one that is open

    # tokens

    @property
    def ahead(self) -> str:
        """The next token that says something; '' at the end."""
        while self.place < len(self.tokens) and self.tokens[self.place][0] in SILENT:
            self.place += 1
        return self.tokens[self.place][0] if self.place < len(self.tokens) else ""

    @property
    def column(self) -> int:
        """Where the next token stands."""
        return self.tokens[self.place][1] if self.ahead else len(self.text)

    def take(self) -> str:
        token = self.ahead
        self.place += 1
        return token

    def taken(self, token: str) -> bool:
        """Whether this token is next, which is read then."""
        if self.ahead != token:
            return False
        self.place += 1
        return True

    def stop(self, message: str, suggestion: str | None = None) -> FormulaError:
        return FormulaError(message, self.column, self.column + max(1, len(self.ahead)), suggestion)

    def unexpected(self) -> FormulaError:
        """What is said of a token that has no meaning here."""
        token = self.ahead
        if not token:
            return self.stop("the formula ends too early")
        if token in KNOWN or len(token) == 1:
            return self.stop(f"{quoted(token)} can't stand here")
        return self.stop(f"{quoted(token)} is not understood in a text", nearest_name(token, KNOWN))

    # a line of formulas

    def phrase(self) -> Phrase:
        """Formulas with the signs between them, and words."""
        found: list[str | Formula | Math | Styled] = []
        row: list[str | Formula | Amount | Matrix] = []
        if not self.ahead:
            raise self.stop("there is no formula between the dollar signs")
        while self.ahead:
            if words := self.words():
                found += [Math(tuple(row)), words] if row else [words]
                row = []
            elif self.ahead in SIGNS:
                sign = self.take()
                row.append(SIGNS[sign] or sign)
            elif row and not isinstance(row[-1], str):
                raise self.unexpected()
            else:
                row.append(self.amount() or self.sum())
        return (*found, Math(tuple(row))) if row else tuple(found)

    def words(self) -> str:
        """Words or a comma between formulas, `\\text{ for }`; '' where none are ahead."""
        if self.ahead in PROSE:
            return PROSE[self.take()]
        place = self.place
        if self.ahead in UPRIGHT:
            self.take()
            inner = self.upright()
            if inner.strip() and not is_unit(inner.strip()):
                return inner
        self.place = place
        return ""

    def upright(self) -> str:
        """What stands in the braces ahead, as it is written."""
        start = self.column
        found = UPRIGHT_GROUP.match(self.text, start)
        if found is None:
            closed = self.text.find("}", start)
            if self.ahead != "{" or closed < 0:
                raise self.stop("braces are wanted here")
            raise FormulaError("within upright letters stand letters alone", start, closed)
        while self.place < len(self.tokens) and self.tokens[self.place][1] < found.end():
            self.place += 1
        return RAISED.sub(r"^\1", SPACE.sub(" ", found[1]).replace(r"\cdot", "·"))

    def amount(self) -> Amount | None:
        """A number alone with its unit, if that is what stands here: `9{,}8\\,\\mathrm{m/s^2}`, `30^\\circ`."""
        place, minus = self.place, self.taken("-")
        if NUMBER.fullmatch(self.ahead):
            number = plain_number_text(self.take()) + self.power_of_ten()
            unit = self.unit()
            if self.ahead in ("", *SIGNS, *PROSE):
                return Amount(f"{'−' * minus}{number}", parse_unit(unit) if unit else None)
        self.place = place
        return None

    def power_of_ten(self) -> str:
        """`\\times 10^{-3}` as e-3; '' where there is none."""
        place = self.place
        if self.ahead in TIMES and self.take() and self.taken("10") and self.taken("^"):
            braced = self.taken("{")
            sign = "-" if self.taken("-") else ""
            if self.ahead.isdecimal():
                digits = self.take()
                if not braced or self.taken("}"):
                    return f"e{sign}{digits}"
        self.place = place
        return ""

    def unit(self) -> str:
        """The unit ahead; '' where there is none."""
        place = self.place
        if self.taken(r"\%") or self.taken("%"):
            return "%"
        if self.ahead in DEGREES:
            return self.take() and "deg"
        if self.taken("^") and (self.ahead in DEGREES or (self.taken("{") and self.ahead in DEGREES)):
            self.take()
            self.taken("}")
            return "deg"
        self.place = place
        if self.ahead in UPRIGHT:
            wanted = self.take() not in WORDS
            column, inner = self.column, self.upright().strip()
            if is_unit(inner):
                return inner
            if wanted:
                raise FormulaError(f"{quoted(inner)} is no unit", column + 1, column + 1 + len(inner))
            self.place = place
        return ""

    # a formula

    def sum(self) -> Formula:
        """Products with signs between them."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise self.stop(f"nested too deep: at most {DEEPEST} levels")
        terms = [self.signed()]
        while self.ahead in ("+", "-", "−"):
            terms.append(self.signed())
        self.depth -= 1
        return terms[0] if len(terms) == 1 else Sum(tuple(terms))

    def signed(self) -> Formula:
        sign = self.take() if self.ahead in ("+", "-", "−") else "+"
        term = self.product()
        return term if sign == "+" else negative_as_told(term)

    def product(self) -> Formula:
        """Factors side by side; a slash divides what is there by the factor behind it."""
        factors = [self.factor()]
        while True:
            if self.ahead in TIMES:
                self.take()
                factors.append(self.factor())
            elif self.taken("/"):
                factors = [quotient_as_told(joined_factors(factors), self.factor())]
            elif self.starts():
                factors.append(self.factor())
            else:
                return joined_factors(factors)

    def starts(self) -> bool:
        """Whether a factor stands ahead."""
        token = self.ahead
        if token in UPRIGHT or token in SIGNS or token in PROSE:
            return False
        begins = token in (*GREEK, *FUNCTIONS, *FRACTIONS, r"\sqrt", r"\pi", r"\Delta", "(", "[", "{", "|")
        if token == "|" and self.bars:
            return False
        return begins or bool(NUMBER.fullmatch(token)) or (len(token) == 1 and token.isalpha())

    def factor(self) -> Formula:
        """An atom with its power."""
        if self.ahead in FUNCTIONS:
            return self.function()
        base = self.atom()
        return self.raised(base)

    def raised(self, base: Formula) -> Formula:
        if not self.taken("^"):
            return base
        if self.ahead in DEGREES:
            raise self.stop("an angle in degrees stands alone, or behind sin, cos, tan")
        if self.ahead.isdecimal() and len(self.ahead) > 1:  # x^12 is x¹ 2
            raise self.stop("write braces round a number of several digits")
        return Power(base, self.argument())

    def function(self) -> Formula:
        """`\\sin \\theta`, `\\sin^2(2 x)`: what it is taken of stands in brackets, or is one letter or number."""
        name = FUNCTIONS[self.take()]
        power = self.argument() if self.taken("^") else None
        bracketed = self.ahead in CLOSED_BY
        angle = self.number_with_degrees() if NUMBER.fullmatch(self.ahead) else self.raised(self.atom())
        if not bracketed and self.starts() and self.ahead not in FUNCTIONS:
            raise self.stop("write brackets round what the function is taken of")
        call = Call(name, (angle,))
        return call if power is None else Power(call, power)

    def number_with_degrees(self) -> Formula:
        number = self.take()
        return Decimal(f"{plain_number_text(number)}°") if self.unit() == "deg" else number_as_told(number)

    def argument(self) -> Formula:
        """What a command or `^` takes: a group in braces, or one letter or digit."""
        if self.ahead == "{":
            return self.atom()
        if self.ahead.isdecimal() and len(self.ahead) > 1:  # \frac12
            digits, column = self.tokens[self.place]
            self.tokens[self.place : self.place + 1] = [(digits[0], column), (digits[1:], column + 1)]
        return negative_as_told(self.atom()) if self.taken("-") else self.atom()

    def atom(self) -> Formula:
        token = self.ahead
        if NUMBER.fullmatch(token):
            return number_as_told(self.take())
        if token in CLOSED_BY:
            return self.group(token)
        if token in FRACTIONS:
            self.take()
            return quotient_as_told(self.argument(), self.argument())
        if self.taken(r"\sqrt"):
            return self.root()
        if self.taken(r"\pi"):
            return PI
        if token in GREEK or token == r"\Delta" or (len(token) == 1 and token.isalpha()):
            return self.letter()
        raise self.unexpected()

    def group(self, opening: str) -> Formula:
        """What stands in brackets, braces or bars."""
        start = self.column
        self.take()
        outer, self.bars = self.bars, opening == "|"
        inner = self.sum()
        self.bars = outer
        if not self.taken(CLOSED_BY[opening]):
            if self.ahead:
                raise self.unexpected()
            raise FormulaError(f"this `{opening}` is never closed", start, start + 1)
        return Call("abs", (inner,)) if opening == "|" else inner

    def root(self) -> Formula:
        """√x, or with `[n]` x^(1/n)."""
        if self.taken("["):
            nth = self.sum()
            if not self.taken("]"):
                raise self.unexpected()
            return Power(self.argument(), quotient_as_told(ONE, nth))
        return Call("sqrt", (self.argument(),))

    def letter(self) -> Formula:
        """A letter with what stands below it, its prime, and the letter that it is a function of."""
        start = self.column
        change = self.taken(r"\Delta")
        token = self.ahead
        if change and not (token in GREEK or (len(token) == 1 and token.isalpha())):
            return Symbol("Delta")
        self.take()
        head = GREEK.get(token) or (token if token.isascii() else NAMES.get(token, ""))
        below = self.index() if self.taken("_") else ""
        name = f"{'delta_' * change}{head}{below}"
        if self.taken("'") or self.taken("’"):
            name += PRIME
        if not head or letter_parts(name) is None or (head == "delta" and below.startswith("_")):
            raise FormulaError(
                f"{quoted(self.text[start : self.column])} is no letter that can be printed", start, self.column
            )
        return Symbol(name + self.of())

    def index(self) -> str:
        """What stands below a letter: digits, or a word behind a `_`."""
        start = self.column
        if self.ahead in UPRIGHT:
            self.take()
            text = self.upright()
        elif self.ahead == "{":
            text = self.braced_index()
        else:
            token = self.take()
            text = GREEK.get(token, token[:1] if token.isdecimal() else token)
            if token.isdecimal() and len(token) > 1:
                raise FormulaError("write braces round an index of several digits", start, start + len(token))
        word = re.sub(r"[\s,]+", "_", text.strip())
        if not re.fullmatch(r"[A-Za-z0-9]+(?:_[A-Za-z0-9]+)*", word):
            raise FormulaError(f"{quoted(text)} can't stand below a letter", start, max(self.column, start + 1))
        return word if word.isdecimal() else f"_{word}"

    def braced_index(self) -> str:
        """Letters, digits and upright words in braces."""
        self.take()
        found = ""
        while self.ahead and not self.taken("}"):
            if self.ahead in UPRIGHT:
                self.take()
                found += self.upright()
            else:
                token = self.take()
                found += GREEK.get(token, token if token.isalnum() or token == "," else "?")
        return found

    def of(self) -> str:
        """`(t)` behind the letter of a function; '' where there is none."""
        following = [token for token, _ in self.tokens[self.place : self.place + 3]]
        if len(following) == 3 and following[0] == "(" and following[2] == ")":
            name = GREEK.get(following[1], following[1] if following[1].isascii() and following[1].isalpha() else "")
            if name:
                self.place += 3
                return f"({name})"
        return ""


CLOSED_BY = {"(": ")", "[": "]", "{": "}", "|": "|"}
NAMES = {letter: name for name, letter in GREEK_LETTERS.items()}


def joined_factors(factors: list[Formula]) -> Formula:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def plain_number_text(token: str) -> str:
    """A number with a decimal point, whichever sign it was written with."""
    return token.replace("{,}", ".")


def negative_as_told(term: Formula) -> Formula:
    """The term with a minus, which a number has itself."""
    return Number(-term.value) if isinstance(term, Number) else Negative(term)


def quotient_as_told(above: Formula, below: Formula) -> Formula:
    """A fraction, as a number where it is one in lowest terms: ½."""
    if isinstance(above, Number) and isinstance(below, Number) and below.value > 1:
        value = above.value / below.value
        if below.value == value.denominator:
            return Number(value)
    return Quotient(above, below)


def number_as_told(token: str) -> Formula:
    """A number as it is written: a decimal one keeps its digits."""
    text = plain_number_text(token)
    return Number(Fraction(text)) if text.isdecimal() else Decimal(text)


def is_unit(text: str) -> bool:
    """Whether a text is a unit."""
    try:
        parse_unit(text)
    except UnitError:
        return False
    return True
