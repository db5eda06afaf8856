"""Grammar: a formula as students write it, with a fork wherever the program's own notation asks for a bracket.

- what follows a slash without a mark: `mg/2k` is mg/(2k) or (mg/2) k, `1/2mv^2` (1/2) m v² or 1/(2mv²); what stands close together
  belongs together, save behind a fraction of two numbers;
- the argument of a function without brackets: `sin 2θ/3`, `sin ωt`, `√3g/L`, `sin θ^2`;
- an exponent without brackets: `e^-kt`, `x^1/2`;
- `sin^-1 x` is arcsin x or 1/sin x.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from rotsolve.algebra.formula import FUNCTIONS, ONE, PI, Call, Formula, Number, Power, Product, Quotient, Symbol
from rotsolve.algebra.notation.cursor import STARTS
from rotsolve.algebra.notation.letters import from_superscript
from rotsolve.algebra.notation.limits import MAX_TREE_DEPTH, check_depth, check_power
from rotsolve.algebra.notation.parse import Parser
from rotsolve.algebra.notation.tokens import FormulaError, Token, read_number
from rotsolve.grading.reading.forks import Forks
from rotsolve.grading.reading.runs import EULER, INVERSE, RECIPROCAL, REMEMBERED, TAKES_POWER, run_fault, run_meaning

ELLIPTIC = "K"  # which is an integral before a bracket, where no letter is called so
HALF_TURN = Number(Fraction(180))


def read_formula(text: str, tokens: list[Token], names: frozenset[str], forks: Forks) -> Formula:
    """The formula that some tokens write, the last of which is an `end`."""
    grammar = Grammar(text, tokens, names, forks)
    result = grammar.sum()
    if grammar.token.kind != "end":
        raise grammar.unexpected()
    if len(tokens) > MAX_TREE_DEPTH // 2:  # fewer can not make so deep a tree
        check_depth(result, len(text))
    return result


def _product_of(factors: list[Formula]) -> Formula:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


@lru_cache(REMEMBERED)
def _known_number(text: str) -> Number:
    return Number(read_number(text))


def literal_number(token: Token) -> Number:
    """The exact number that a token writes; the same few are met over and over."""
    try:
        return _known_number(token.text)
    except FormulaError:
        return Number(read_number(token.text, token.start))  # fails again, at its place


class Grammar(Parser):
    """The parser of the program's own notation, with forks in place of its refusals."""

    def __init__(self, text: str, tokens: list[Token], names: frozenset[str], forks: Forks) -> None:
        super().__init__(text, list(tokens), names, False, False)
        self.letters = names
        self.forks = forks

    def tight(self) -> bool:
        """Whether the next token stands close to the one before it."""
        return self.tokens[self.index - 1].end == self.token.start

    def multiplies(self) -> bool:
        """Whether a factor without a mark follows, which is no function: its name ends a run of letters."""
        return self.starts_factor() and not self.at_function()

    def expand(self) -> int:
        """What a run of letters means, from memory where it is known; with e where a power of it follows."""
        token = self.token
        if token.kind != "name":
            return 1
        if self.bound:
            return super().expand()
        if token.text == ELLIPTIC and ELLIPTIC not in self.letters and self.tokens[self.index + 1].kind == "(":
            self.tokens[self.index] = Token("function", "ellipk", token.start, token.end)
            return 1
        powered = token.text.endswith(EULER) and self.tokens[self.index + 1].kind in ("^", "raised")
        names = self.letters | {EULER} if powered else self.letters
        found = run_meaning(token.text, names)
        if found is None:
            raise run_fault(token, names)
        start, end = token.start, token.end
        pieces = [Token(piece.kind, piece.text, start + piece.start, start + piece.end) for piece in found[:-1]]
        last = found[-1]
        self.tokens[self.index : self.index + 1] = [*pieces, Token(last.kind, last.text, start + last.start, end)]
        return len(found)

    def divided(self, numerator: Formula) -> list[Formula]:
        """The numerator over what follows: over one factor, or over several that stand side by side."""
        slash = self.next()
        spaced = self.token.start > slash.end
        below = [self.signed_factor()]
        fraction = isinstance(numerator, Number) and isinstance(below[0], Number)
        while self.starts_factor():
            function, close = self.at_function(), self.tight()
            in_run = len(below) > 1 and close and not function
            if len(below) == 1 and not close and self.tokens[self.index - 1].kind in (")", "]"):
                break  # a/(b) c has its bracket
            if not in_run and not self.forks.choose(not fraction and not function and (close or spaced)):
                break
            below.append(self.factor())
        return [Quotient(numerator, _product_of(below))]

    def factor(self) -> Formula:
        result = super().factor()
        if isinstance(result, Power) and result.base == Symbol(EULER) and EULER not in self.letters:
            return Call("exp", (result.exponent,))
        return result

    def primary(self) -> Formula:
        result = self.number() if self.token.kind == "number" else super().primary()
        while self.token.kind == "°":
            self.next()
            result = Quotient(Product((result, PI)), HALF_TURN)
        return result

    def number(self) -> Formula:
        """A number; `2e3` may be 2 e 3 where a letter is called e."""
        token = self.next()
        letter = "e" if "e" in token.text else "E" if "E" in token.text else ""
        if letter not in self.letters or self.forks.choose(True):
            return literal_number(token)
        cut = token.text.index(letter)
        sign = [mark for mark in token.text[cut + 1] if mark in "+-−"]
        after = token.start + cut + 1
        pieces = [Token("symbol", letter, after - 1, after)]
        pieces += [Token("+" if mark == "+" else "-", mark, after, after + 1) for mark in sign]
        pieces.append(Token("number", token.text[cut + 1 + len(sign) :], after + len(sign), token.end))
        self.tokens[self.index : self.index] = pieces
        return Number(read_number(token.text[:cut], token.start))

    def exponent(self, base: Formula, start: int) -> Formula:
        """The exponent; one that begins without a bracket may go on: `e^-kt`, `x^1/2`."""
        if self.token.kind == "raised":
            mark = self.next()
            raised = _known_number(from_superscript(mark.text))
            check_power(base, raised, start, mark.end)
            return raised
        closed = self.tokens[self.index + 1].kind in ("(", "[")
        result = super().exponent(base, start)
        if closed:
            return result
        longer = self.exponent_goes_on(result, base == Symbol(EULER) and EULER not in self.letters)
        if longer is not result:
            check_power(base, longer, start, self.tokens[self.index - 1].end)
        return longer

    def exponent_goes_on(self, first: Formula, natural: bool) -> Formula:
        """What is read of an exponent with what follows it: letters and a slash behind e^, a slash in 1/2."""
        factors = [first]
        while natural and self.multiplies() and self.forks.choose(self.tight()):
            factors.append(self.factor())
        result = _product_of(factors)
        if self.token.kind == "/" and (natural or self.at_root(result)) and self.forks.choose(natural or result == ONE):
            result = self.divided(result)[0]
            above, below = result.children()
            if isinstance(above, Number) and isinstance(below, Number):
                return above / below
        return result

    def at_root(self, power: Formula) -> bool:
        """Whether power/number ahead is an exponent that textbooks have: 1/2, 1/3, 3/2."""
        below = self.tokens[self.index + 1]
        return isinstance(power, Number) and (str(power.value), below.text) in (("1", "2"), ("1", "3"), ("3", "2"))

    def function(self, token: Token) -> Formula:
        """A function of what stands in brackets or, without them, of what follows."""
        name = "sqrt" if token.kind == "√" else token.text
        if name not in FUNCTIONS and name not in RECIPROCAL:
            return super().function(token)  # integral(f, x, a, b)
        power = self.function_power(token) if self.token.kind in ("^", "raised") and name != "sqrt" else None
        if power is not None and power.value == -1 and name in INVERSE and self.forks.choose(True):
            name, power = INVERSE[name], None
        count = FUNCTIONS.get(name, 1)
        if self.token.kind in ("(", "["):
            arguments = self.arguments(self.next(), count, token)
        elif count == 1:
            arguments = (self.bare_argument(token),)
        else:
            raise FormulaError(f"`{name}` needs brackets: {name}(y, x)", token.start, token.end)
        known = RECIPROCAL.get(name)
        result: Formula = Quotient(ONE, Call(known, arguments)) if known else Call(name, arguments)
        if power is None:
            return result
        check_power(result, power, token.start, self.tokens[self.index - 1].end)
        return Power(result, power)

    def function_power(self, token: Token) -> Number:
        """The whole number in sin² θ, sin^2 θ, sin^{-1} x."""
        mark = self.next()
        if mark.kind == "raised":
            return Number(read_number(from_superscript(mark.text), mark.start))
        braced = self.token.kind == "("
        if braced:
            self.next()
        negative = self.sign() == "-"
        digits = self.next()
        if digits.kind != "number" or not digits.text.isdigit():
            raise self.two_ways(token.start, digits.end, f"({token.text}(x))^…")
        if braced:
            self.expect(")")
        value = read_number(digits.text, digits.start)
        return Number(-value if negative else value)

    def bare_argument(self, token: Token) -> Formula:
        """The argument of a function without brackets: numbers and the letter or the run of letters after them, or more."""
        first = self.token
        if first.kind not in STARTS and first.kind != "|":
            raise FormulaError(f"`{token.text}` needs an argument", token.start, token.end)
        self.enter()
        root = token.kind == "√" or token.text == "sqrt"
        factors = [self.primary()]
        while True:
            numeric = all(isinstance(factor, Number) for factor in factors)
            if self.token.kind in ("^", "raised"):
                if not self.forks.choose(token.text in TAKES_POWER or root):
                    break
                factors[-1] = Power(factors[-1], self.exponent(factors[-1], first.start))
            elif self.multiplies():
                if not self.goes_on(factors, root, numeric):
                    break
                factors.append(self.primary())
            elif self.token.kind == "/" and self.forks.choose(root and len(factors) > 1):
                factors = self.divided(_product_of(factors))
                break
            else:
                break
        self.depth -= 1
        return _product_of(factors)

    def goes_on(self, factors: list[Formula], root: bool, numeric: bool) -> bool:
        """Whether the factor ahead belongs to the argument: sin 2θ, sin ωt, √2gh."""
        if isinstance(factors[-1], Quotient):
            return False  # degrees end an argument
        bracket, close = self.token.kind in ("(", "[", "|"), self.tight()
        if numeric and not root and not bracket:
            return True
        in_run = len(factors) > 1 and not numeric and close and not bracket
        return in_run or self.forks.choose(close and (root or not bracket))
