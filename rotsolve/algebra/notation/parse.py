"""Parse: text to Formula, by a Pratt parser with a vocabulary; nothing is evaluated and nothing is simplified.

Rules that are not obvious:
- implicit multiplication (`2 m g`) binds like `*`, and `*` and `/` go from left to right: `1/2 m v^2` is (1/2) m v²,
  hence a denominator that is a product needs its bracket, `a/(b c)`. A strict vocabulary refuses `a/b c` as ambiguous unless
  a/b is a fraction of plain numbers;
- a run of letters that is no name is split into names, longest first (`mg`), except where the reader could take it in
  two ways: after a slash (`a/mg`) and after a function without brackets (`sin ωt`);
- a function without brackets takes one symbol or number: `sin θ`, `sin² θ`; `sin θ²`, `sin 2 θ`, `sin⁻¹ θ` are refused,
  since textbooks differ about their meaning;
- names win over functions and constants: with `pi` in the table, `pi` is a symbol.

With forks, what is refused without them is read in every way that makes sense, which one by one the forks choose:
- what follows a slash without a mark: `mg/2k` is mg/(2k) or (mg/2) k; what stands close together belongs together. A function does
  not go into the denominator, `g/2L sin θ`, and nothing does behind a fraction of two numbers, `1/2mv^2`, but for π, `1/2π`;
- the argument of a function without brackets: `sin 2θ/3`, `sin ωt`, `√3g/L`, `sin θ^2`;
- an exponent without brackets: `e^-kt`, `x^1/2`;
- `sin^-1 x` is arcsin x or 1/sin x.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction

from rotsolve.algebra.formula import (
    FUNCTIONS,
    ONE,
    PI,
    Call,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)
from rotsolve.algebra.notation.cursor import CLOSERS, STARTS, Cursor, Vocabulary
from rotsolve.algebra.notation.derived import DERIVED
from rotsolve.algebra.notation.letters import FRACTIONS, from_superscript
from rotsolve.algebra.notation.limits import check_depth, check_power, rational
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, Lexer, Token, literal_number, resolve

HALF_TURN = Number(Fraction(180))


def parse(text: str, names: Collection[str] | None = None, *, paths: bool = False, strict: bool = False) -> Formula:
    """The formula that `text` writes; `names` are the known symbols (None: any), `paths` admits `rod.end.speed`."""
    result = Parser(text, Lexer(text).tokenize(), Vocabulary(names, paths, strict)).formula()
    check_depth(result, len(text))
    return result


def _minus(operand: Formula) -> Formula:
    return Number(-operand.value) if isinstance(operand, Number) else Negative(operand)


def _product(factors: list[Formula]) -> Formula:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


class Parser(Cursor):
    """One pass over the tokens; a method reads one level of the grammar, from sums down to single names."""

    def formula(self) -> Formula:
        """The formula that all tokens write."""
        result = self.sum()
        if self.token.kind != "end":
            raise self.unexpected()
        return result

    def bracketed(self, opening: Token) -> Formula:
        """The sum up to the mark that closes `opening`, which is already read."""
        self.open_bracket(opening)
        inner = self.sum()
        self.close_bracket()
        return inner

    def sum(self) -> Formula:
        terms = [self.term()]
        while self.token.kind in ("+", "-"):
            if self.token.kind == "+":
                self.next()
            terms.append(self.term())
        return terms[0] if len(terms) == 1 else Sum(tuple(terms))

    def sign(self) -> str | None:
        """The sign in front, read; None where there is none."""
        return self.next().kind if self.token.kind in ("+", "-") else None

    def signed(self, read: Callable[[], Formula]) -> Formula:
        """The sign ahead, and what is read behind it."""
        sign = self.sign()
        self.enter()
        operand = read()
        self.depth -= 1
        return _minus(operand) if sign == "-" else operand

    def term(self) -> Formula:
        """A product with its sign: −a b is −(a b)."""
        if self.token.kind in ("+", "-"):
            return self.signed(self.term)
        factors = [self.factor()]
        while True:
            if self.token.kind == "*":
                self.next()
                factors.append(self.signed_factor())
            elif self.token.kind == "/":
                factors = [self.divided(_product(factors))]
            elif self.starts_factor():
                factors.append(self.factor())
            else:
                return _product(factors)

    def divided(self, numerator: Formula) -> Formula:
        """The quotient that a slash begins: over one factor, or over several that stand side by side."""
        slash, first = self.next(), self.token
        if self.expand() > 1:
            self.refuse(slash.start, first.end, "the denominator in brackets")
        below = [self.signed_factor()]
        while self.starts_factor() and self.belongs_below(numerator, below, slash, first):
            below.append(self.factor())
        return Quotient(numerator, _product(below))

    def belongs_below(self, numerator: Formula, below: list[Formula], slash: Token, first: Token) -> bool:
        """Whether the factor ahead stands in the denominator, whose factors so far are given."""
        if self.forks is None:
            plain = self.token.kind == "number" or rational(Quotient(numerator, below[0])) is not None
            if self.vocabulary.strict and not plain:
                raise self.two_ways(slash.start, self.token.end, "brackets")
            return False
        if self.at_function():
            return False
        close = self.tight()
        if len(below) == 1 and not close and self.tokens[self.index - 1].kind in (")", "]"):
            return False  # a/(b) c has its bracket
        if len(below) == 1 and below[0] != PI and not numerator.symbols() and not below[0].symbols():
            return close and self.token.kind == "constant" and self.forks.choose(False)
        return (len(below) > 1 and close) or self.forks.choose(close or first.start > slash.end)

    def signed_factor(self) -> Formula:
        return self.signed(self.signed_factor) if self.token.kind in ("+", "-") else self.factor()

    def factor(self) -> Formula:
        """A primary with its power."""
        first = self.token
        base = self.primary()
        if self.token.kind not in ("^", "raised"):
            return base
        result = self.powered(base, first.start)
        if self.token.kind in ("^", "raised"):
            raise self.two_ways(first.start, self.token.end, "brackets around the inner power")
        return result

    def powered(self, base: Formula, start: int) -> Formula:
        """The power of a base that begins at a place."""
        exponent = self.exponent(base, start)
        return Call("exp", (exponent,)) if self.is_euler(base) else Power(base, exponent)

    def is_euler(self, base: Formula) -> bool:
        """Whether a power of a letter is one of e."""
        return isinstance(base, Symbol) and base.name == self.vocabulary.euler

    def exponent(self, base: Formula, start: int) -> Formula:
        """The exponent after `base`, within the caps; with forks, one without a bracket may go on: `e^-kt`, `x^1/2`."""
        mark = self.next()
        closed = mark.kind == "raised" or self.token.kind in ("(", "[")
        if mark.kind == "raised":
            exponent: Formula = literal_number(from_superscript(mark.text), mark.start)
        else:
            self.enter()
            exponent = self.signed_factor()
            self.depth -= 1
        check_power(base, exponent, start, self.tokens[self.index - 1].end)
        if closed or self.forks is None:
            return exponent
        longer = self.longer_exponent(exponent, self.is_euler(base))
        if longer is not exponent:
            check_power(base, longer, start, self.tokens[self.index - 1].end)
        return longer

    def longer_exponent(self, first: Formula, natural: bool) -> Formula:
        """What is read of an exponent with what follows it: letters and a slash behind e^, a slash in 1/2."""
        assert self.forks is not None
        factors = [first]
        while natural and self.multiplies() and self.forks.choose(self.tight()):
            factors.append(self.factor())
        result = _product(factors)
        if self.token.kind == "/" and (natural or self.at_root(result)) and self.forks.choose(natural or result == ONE):
            result = self.divided(result)
            above, below = result.children()
            if isinstance(above, Number) and isinstance(below, Number):
                return above / below
        return result

    def at_root(self, power: Formula) -> bool:
        """Whether power/number ahead is an exponent that textbooks have: 1/2, 1/3, 3/2."""
        below = self.tokens[self.index + 1]
        return isinstance(power, Number) and (str(power.value), below.text) in (("1", "2"), ("1", "3"), ("3", "2"))

    def multiplies(self) -> bool:
        """Whether a factor without a mark follows, which is no function: its name ends a run of letters."""
        return self.starts_factor() and not self.at_function()

    def primary(self) -> Formula:
        """A number, a name, a bracket, a function of something, a root, or an integral; perhaps in degrees."""
        if self.at_path():
            return self.path()
        self.expand()
        token = self.token
        if token is self.stop or (token.kind not in STARTS and token.kind != "|"):
            raise self.unexpected()
        self.next()
        result = self.after_first(token)
        while self.token.kind == "°":
            self.next()
            result = Quotient(Product((result, PI)), HALF_TURN)
        return result

    def after_first(self, token: Token) -> Formula:
        """The primary that begins with a token, which is already read."""
        if token.kind in CLOSERS:
            inner = self.bracketed(token)
            return Call("abs", (inner,)) if token.kind == "|" else inner
        if token.kind == "number":
            return self.number(token)
        if token.kind == "fraction":
            return Number(FRACTIONS[token.text])
        if token.kind == "symbol":
            return Symbol(token.text)
        if token.kind == "constant":
            return PI
        return self.integral() if token.kind == "∫" else self.function(token)

    def number(self, token: Token) -> Formula:
        """A number; `2e3` may be 2 e 3 where a letter is called e."""
        letter = "e" if "e" in token.text else "E" if "E" in token.text else ""
        names = self.vocabulary.names
        if not letter or names is None or letter not in names:
            return literal_number(token.text, token.start)
        self.refuse(token.start, token.end, "10^… or, for the symbol, spaces")
        if self.forks is None or self.forks.choose(True):
            return literal_number(token.text, token.start)
        cut = token.text.index(letter)
        sign = [mark for mark in token.text[cut + 1] if mark in "+-−"]
        after = token.start + cut + 1
        pieces = [Token("symbol", letter, after - 1, after)]
        pieces += [Token("+" if mark == "+" else "-", mark, after, after + 1) for mark in sign]
        pieces.append(Token("number", token.text[cut + 1 + len(sign) :], after + len(sign), token.end))
        self.tokens[self.index : self.index] = pieces
        return literal_number(token.text[:cut], token.start)

    def function(self, token: Token) -> Formula:
        """What follows the name of a function (or √), which is already read: sin(x), sin x, sin² x."""
        name = "sqrt" if token.kind == "√" else token.text
        if name == "integral":
            return self.integral_call(token)
        rooted = token.kind == "√" or (name == "sqrt" and self.forks is not None)
        power = self.function_power(token) if self.token.kind in ("^", "raised") and not rooted else None
        inverse = self.vocabulary.inverses.get(name) if power is not None and power.value == -1 else None
        if inverse is not None and self.forks is not None and self.forks.choose(True):
            name, power = inverse, None
        count = FUNCTIONS.get(name, 1)
        if self.token.kind in ("(", "["):
            arguments = self.arguments(self.next(), count, token)
        elif count == 1:
            arguments = (self.bare_argument(token),)
        else:
            raise FormulaError(f"`{name}` needs brackets: {name}(y, x)", token.start, token.end)
        derived = DERIVED.get(name)
        result = derived(*arguments) if derived is not None else Call(name, arguments)
        if power is None:
            return result
        if self.token.kind in ("^", "raised"):
            self.refuse(token.start, self.token.end, "brackets")
        check_power(result, power, token.start, self.tokens[self.index - 1].end)
        return Power(result, power)

    def function_power(self, token: Token) -> Number:
        """The whole number in sin² θ, sin^2 θ; with forks also in sin⁻¹ x and sin^{-1} x."""
        mark = self.next()
        if mark.kind == "raised":
            text = from_superscript(mark.text)
            if self.forks is None and not text.isdigit():
                raise self.unclear_power(token, text, mark.end)
            return literal_number(text, mark.start)
        braced = self.forks is not None and self.token.kind == "("
        if braced:
            self.next()
        negative = self.forks is not None and self.sign() == "-"
        digits = self.next()
        if digits.kind != "number" or not digits.text.isdigit():
            raise self.unclear_power(token, digits.text, digits.end)
        if braced:
            self.expect(")")
        number = literal_number(digits.text, digits.start)
        return Number(-number.value) if negative else number

    def unclear_power(self, token: Token, power: str, end: int) -> FormulaError:
        """The fault of a power of a function that is no whole number."""
        name = token.text
        inverse = self.forks is None and name in ("sin", "cos", "tan") and power[:1] in ("-", "(")
        return self.two_ways(token.start, end, f"a{name}(x) or 1/{name}(x)" if inverse else f"({name}(x))^…")

    def bare_argument(self, token: Token) -> Formula:
        """The argument of a function without brackets: one symbol or number; with forks perhaps more."""
        first = self.token
        if first.kind not in STARTS and first.kind != "|":
            raise FormulaError(f"`{token.text}` needs an argument", token.start, token.end)
        self.enter()
        pieces = self.expand()
        argument, after = self.primary(), self.token
        if self.forks is not None:
            argument = self.longer_argument(argument, token, first.start)
        elif pieces > 1 or self.could_be_longer(argument, token):
            cure = f"{token.text}(…) with its argument in brackets"
            raise self.two_ways(token.start, max(first.end, after.end), cure)
        self.depth -= 1
        return argument

    def could_be_longer(self, argument: Formula, token: Token) -> bool:
        """Whether a reader could take what follows for a part of an argument without brackets."""
        if self.token.kind in ("^", "raised"):
            return True
        plain = isinstance(argument, Number) and token.kind == "√"
        return self.token.kind in STARTS and self.token is not self.stop and not plain and not self.at_function()

    def longer_argument(self, first: Formula, token: Token, start: int) -> Formula:
        """What is read of an argument without brackets: numbers and the letter or the run of letters after them, or more."""
        assert self.forks is not None
        root = token.kind == "√" or token.text == "sqrt"
        factors = [first]
        while True:
            if self.token.kind in ("^", "raised"):
                if not self.forks.choose(root or token.text in self.vocabulary.powered):
                    break
                factors[-1] = self.powered(factors[-1], start)
            elif self.multiplies():
                if not self.goes_on(factors, root):
                    break
                factors.append(self.primary())
            elif self.token.kind == "/" and self.forks.choose(root and len(factors) > 1):
                return self.divided(_product(factors))
            else:
                break
        return _product(factors)

    def goes_on(self, factors: list[Formula], root: bool) -> bool:
        """Whether the factor ahead belongs to the argument: sin 2θ, sin ωt, √2gh."""
        assert self.forks is not None
        if isinstance(factors[-1], Quotient):
            return False  # degrees end an argument
        numeric = all(isinstance(factor, Number) for factor in factors)
        bracket, close = self.token.kind in ("(", "[", "|"), self.tight()
        if numeric and not root and not bracket:
            return True
        in_run = len(factors) > 1 and not numeric and close and not bracket
        return in_run or self.forks.choose(close and (root or not bracket))

    def at_function(self) -> bool:
        return self.token.kind in ("name", "function") and self.expand() > 0 and self.token.kind == "function"

    def arguments(self, opening: Token, count: int, function: Token) -> tuple[Formula, ...]:
        """The arguments up to the closing bracket, `count` of them."""
        self.open_bracket(opening)
        found, decimal = [self.sum()], False
        while self.token.kind == ",":
            decimal = {self.tokens[self.index - 1].kind, self.tokens[self.index + 1].kind} == {"number"}
            self.next()
            found.append(self.sum())
        self.close_bracket()
        if len(found) != count:
            end = self.tokens[self.index - 1].end
            cure = "; a decimal number takes a point" if decimal else ""
            message = f"`{function.text}` takes {count} argument{'s' * (count > 1)}, not {len(found)}{cure}"
            raise FormulaError(message, function.start, end)
        return tuple(found)

    def variable(self, index: int, sign: Token) -> str:
        """The name of the variable of integration, which is the token at `index`."""
        if index <= 0 or self.tokens[index].kind not in ("name", "symbol"):
            raise FormulaError("an integral needs its variable: ∫[a → b] f dx", sign.start, sign.end)
        return resolve(self.tokens[index], None, (), split=False)[0].text

    def integral(self) -> Formula:
        """∫[lower → upper] integrand dx, after the ∫."""
        sign = self.tokens[self.index - 1]
        if self.token.kind != "[":
            raise FormulaError("an integral needs its bounds: ∫[a → b] f dx", sign.start, sign.end)
        self.open_bracket(self.next())
        lower = self.sum()
        self.expect("→")
        upper = self.sum()
        self.close_bracket()
        where = self.differential(self.index)
        variable = self.variable(where + 1, sign)
        outer, self.stop = self.stop, self.tokens[where]
        self.bound.append(variable)
        self.enter()
        integrand = self.term()
        if self.token is not self.stop:
            raise self.unexpected()
        self.index += 2
        self.depth -= 1
        self.stop = outer
        self.bound.pop()
        return Integral(integrand, variable, lower, upper)

    def integral_call(self, token: Token) -> Formula:
        """integral(integrand, variable, lower, upper), the plain form, after the name."""
        opening = self.next()
        variable = self.variable(self.find(self.index, ",") + 1, token) if opening.kind == "(" else ""
        if not variable:
            raise FormulaError("write integral(f, x, a, b)", token.start, token.end)
        self.open_bracket(opening)
        self.bound.append(variable)
        integrand = self.sum()
        self.bound.pop()
        self.expect(",")
        self.next()
        self.expect(",")
        lower = self.sum()
        self.expect(",")
        upper = self.sum()
        self.close_bracket()
        return Integral(integrand, variable, lower, upper)

    def path(self) -> Formula:
        """A dotted path, `rod.end.speed` or `rod.at(3*L/4)`, as a symbol of that name."""
        name = self.path_name()
        while self.token.kind == "." and self.tokens[self.index - 1].end == self.token.start:
            dot = self.next()
            if self.token.kind != "name" or self.token.start != dot.end:
                raise self.unexpected()
            last = self.path_name()
            name += f".{last}"
            if last == "at" and self.token.kind == "(" and self.token.start == self.tokens[self.index - 1].end:
                inner = to_text(self.bracketed(self.next()), unicode=False)
                name += f"({inner.replace(' ', '')})"
        return Symbol(name)

    def path_name(self) -> str:
        return resolve(self.next(), None, (), split=False)[0].text
