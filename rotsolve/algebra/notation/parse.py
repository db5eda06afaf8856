"""Parse: text to Formula, by a Pratt parser with a symbol table; nothing is evaluated and nothing is simplified.

Rules that are not obvious:
- implicit multiplication (`2 m g`) binds like `*`, and `*` and `/` go from left to right: `1/2 m v^2` is (1/2) m v²,
  hence a denominator that is a product needs its bracket, `a/(b c)`. `strict=True` refuses `a/b c` as ambiguous unless
  a/b is a fraction of plain numbers;
- a run of letters that is no name is split into names, longest first (`mg`), except where the reader could take it in
  two ways: after a slash (`a/mg`) and after a function without brackets (`sin ωt`);
- a function without brackets takes one symbol or number: `sin θ`, `sin² θ`; `sin θ²`, `sin 2 θ`, `sin⁻¹ θ` are refused,
  since textbooks differ about their meaning;
- names win over functions and constants: with `pi` in the table, `pi` is a symbol.
"""

from __future__ import annotations

from collections.abc import Collection

from rotsolve.algebra.formula import (
    FUNCTIONS,
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
from rotsolve.algebra.notation.cursor import CLOSERS, STARTS, Cursor
from rotsolve.algebra.notation.letters import FRACTIONS, from_superscript
from rotsolve.algebra.notation.limits import check_depth, check_power, rational
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, Token, read_number, resolve, tokenize

__all__ = ["FormulaError", "Parser", "parse", "rational"]


def parse(text: str, names: Collection[str] | None = None, *, paths: bool = False, strict: bool = False) -> Formula:
    """The formula that `text` writes; `names` are the known symbols (None: any), `paths` admits `rod.end.speed`."""
    parser = Parser(text, tokenize(text), names, paths, strict)
    result = parser.sum()
    if parser.token.kind != "end":
        raise parser.unexpected()
    check_depth(result, len(text))
    return result


def _minus(operand: Formula) -> Formula:
    return Number(-operand.value) if isinstance(operand, Number) else Negative(operand)


def _product(factors: list[Formula]) -> Formula:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


class Parser(Cursor):
    """One pass over the tokens; a method reads one level of the grammar, from sums down to single names."""

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

    def term(self) -> Formula:
        """A product with its sign: −a b is −(a b)."""
        sign = self.sign()
        if sign:
            self.enter()
            operand = self.term()
            self.depth -= 1
            return _minus(operand) if sign == "-" else operand
        factors = [self.factor()]
        while True:
            if self.token.kind == "*":
                self.next()
                factors.append(self.signed_factor())
            elif self.token.kind == "/":
                factors = self.divided(_product(factors))
            elif self.starts_factor():
                factors.append(self.factor())
            else:
                return _product(factors)

    def divided(self, numerator: Formula) -> list[Formula]:
        """The quotient that a slash begins, as the factors that are read so far."""
        start = self.next().start
        first = self.token
        if self.expand() > 1:
            raise self.two_ways(start, first.end, "the denominator in brackets")
        result = Quotient(numerator, self.signed_factor())
        if self.strict and self.token.kind != "number" and self.starts_factor() and rational(result) is None:
            raise self.two_ways(start, self.token.end, "brackets")
        return [result]

    def signed_factor(self) -> Formula:
        sign = self.sign()
        if sign is None:
            return self.factor()
        self.enter()
        operand = self.signed_factor()
        self.depth -= 1
        return _minus(operand) if sign == "-" else operand

    def factor(self) -> Formula:
        """A primary with its power."""
        first = self.token
        base = self.primary()
        if self.token.kind not in ("^", "raised"):
            return base
        result = Power(base, self.exponent(base, first.start))
        if self.token.kind in ("^", "raised"):
            raise self.two_ways(first.start, self.token.end, "brackets around the inner power")
        return result

    def exponent(self, base: Formula, start: int) -> Formula:
        """The exponent after `base`, within the caps."""
        mark = self.next()
        if mark.kind == "raised":
            exponent: Formula = Number(read_number(from_superscript(mark.text), mark.start))
        else:
            self.enter()
            exponent = self.signed_factor()
            self.depth -= 1
        check_power(base, exponent, start, self.tokens[self.index - 1].end)
        return exponent

    def primary(self) -> Formula:
        """A number, a name, a bracket, a function of something, a root, or an integral."""
        if self.at_path():
            return self.path()
        self.expand()
        token = self.token
        if token is self.stop or (token.kind not in STARTS and token.kind != "|"):
            raise self.unexpected()
        self.next()
        if token.kind in CLOSERS:
            inner = self.bracketed(token)
            return Call("abs", (inner,)) if token.kind == "|" else inner
        if token.kind == "number":
            if self.names is not None and any(letter in self.names for letter in "eE" if letter in token.text):
                raise self.two_ways(token.start, token.end, "10^… or, for the symbol, spaces")
            return Number(read_number(token.text, token.start))
        if token.kind == "fraction":
            return Number(FRACTIONS[token.text])
        if token.kind == "symbol":
            return Symbol(token.text)
        if token.kind == "constant":
            return PI
        return self.integral() if token.kind == "∫" else self.function(token)

    def function(self, token: Token) -> Formula:
        """What follows the name of a function (or √), which is already read: sin(x), sin x, sin² x."""
        name = "sqrt" if token.kind == "√" else token.text
        square = self.function_power(token) if self.token.kind in ("^", "raised") and token.kind != "√" else None
        if name == "integral":
            return self.integral_call(token)
        if self.token.kind in ("(", "["):
            result: Formula = Call(name, self.arguments(self.next(), FUNCTIONS[name], token))
        elif FUNCTIONS[name] == 1:
            result = Call(name, (self.bare_argument(token),))
        else:
            raise FormulaError(f"`{name}` needs brackets: {name}(y, x)", token.start, token.end)
        if square is None:
            return result
        if self.token.kind in ("^", "raised"):
            raise self.two_ways(token.start, self.token.end, "brackets")
        check_power(result, square, token.start, self.tokens[self.index - 1].end)
        return Power(result, square)

    def function_power(self, token: Token) -> Number:
        mark = self.next()
        number = self.next() if mark.kind == "^" and self.token.kind == "number" else mark
        text = from_superscript(mark.text) if mark.kind == "raised" else number.text
        if not text.isdigit():
            name = token.text
            inverse = name in ("sin", "cos", "tan") and (text.startswith("-") or self.token.kind in ("-", "("))
            end = mark.end if mark.kind == "raised" else self.token.end
            raise self.two_ways(token.start, end, f"a{name}(x) or 1/{name}(x)" if inverse else f"({name}(x))^…")
        return Number(read_number(text, number.start))

    def bare_argument(self, token: Token) -> Formula:
        """The argument of a function without brackets; what a reader could take for a longer one is refused."""
        first = self.token
        if first.kind not in STARTS and first.kind != "|":
            raise FormulaError(f"`{token.text}` needs an argument", token.start, token.end)
        self.enter()
        pieces = self.expand()
        argument = self.primary()
        self.depth -= 1
        after = self.token
        plain = isinstance(argument, Number) and token.kind == "√"
        longer = after.kind in STARTS and after is not self.stop and not plain and not self.at_function()
        if pieces > 1 or longer or after.kind in ("^", "raised"):
            cure = f"{token.text}(…) with its argument in brackets"
            raise self.two_ways(token.start, max(first.end, after.end), cure)
        return argument

    def at_function(self) -> bool:
        return self.token.kind in ("name", "function") and self.expand() > 0 and self.token.kind == "function"

    def arguments(self, opening: Token, count: int, function: Token) -> tuple[Formula, ...]:
        """The arguments up to the closing bracket, `count` of them."""
        self.open_bracket(opening)
        found = [self.sum()]
        while self.token.kind == ",":
            self.next()
            found.append(self.sum())
        self.close_bracket()
        if len(found) != count:
            end = self.tokens[self.index - 1].end
            message = f"`{function.text}` takes {count} argument{'s' * (count > 1)}, not {len(found)}"
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
