"""Text: a formula as a textbook prints it, `½ M R²`, `−√(3 g (1 + sin θ₀)/L)`, as plain ASCII, and as LaTeX.

Every text can be read again by `parse` and then means the same (the order and the brackets may differ).
A piece of text knows how tightly it binds; whoever puts it into something brackets it where it binds too loosely.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.formula import (
    ELLIPTIC,
    Call,
    Constant,
    Decimal,
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
from rotsolve.algebra.notation.letters import GLYPHS, PRIME, name_to_text, superscripted

# How tightly a text binds. A call without brackets (`sin θ`, `√x`) may be a factor, but is no base of a power.
SUM, NEGATIVE, PRODUCT, QUOTIENT, CALL, POWER, ATOM = range(7)

BARE_NAMES = {"log": "ln", "asin": "arcsin", "acos": "arccos", "atan": "arctan", **ELLIPTIC}
ANGULAR = frozenset(("sin", "cos", "tan"))
BARE = ANGULAR | {"log", "asin", "acos", "atan"}

LARGEST_FRACTION_PART = 20, 100  # numerator and denominator up to which 7/10 stays a fraction and is not 0.7
MOST_DECIMALS = 6
TURN = 360  # degrees up to which an angle is told by them
LONG = 40  # digits from which on a number is written with its power of ten

Piece = tuple[str, int]


def to_text(formula: Formula, *, unicode: bool = True) -> str:
    """The formula as a line of text: textbook style, or with `unicode=False` ASCII with every `*` written."""
    if not unicode:
        return _ascii(formula)[0]
    known = formula.__dict__  # a page asks for the text of a formula several times
    if "text" not in known:
        known["text"] = _unicode(formula)[0]
    text: str = known["text"]
    return text


def number_to_text(value: Fraction) -> str:
    """A non-negative rational as `2`, `3/4` or, where the fraction would look odd, the exact decimal `9.8`."""
    text = str(value)
    if len(text) > LONG:
        return _power_of_ten(value) or text
    top, bottom = LARGEST_FRACTION_PART
    if value.denominator % 5 == 0 and (value.numerator > top or value.denominator > bottom):
        for decimals in range(1, MOST_DECIMALS + 1):
            scaled = value * 10**decimals
            if scaled.denominator == 1:
                digits = str(scaled.numerator).rjust(decimals + 1, "0")
                return f"{digits[:-decimals]}.{digits[-decimals:]}"
    return text


def _power_of_ten(value: Fraction) -> str | None:
    """`5e199` for a long number that is short so; None if it is not."""
    decimals = len(str(value.denominator))  # 10^(4 · digits) is a multiple of any 2^i 5^j of so many digits
    scaled = value * 10 ** (4 * decimals)
    digits = str(scaled.numerator).rstrip("0")
    if scaled.denominator > 1 or len(digits) > LONG:
        return None
    return f"{digits}e{len(str(scaled.numerator)) - len(digits) - 4 * decimals}"


def _number(value: Fraction, glyphs: bool) -> Piece:
    if glyphs and value in GLYPHS:
        return GLYPHS[value], CALL  # a glyph is no good base for a power
    text = number_to_text(value)
    return text, QUOTIENT if "/" in text else ATOM


def unsigned(formula: Formula) -> Formula | None:
    """The formula without its leading minus; None if it has none."""
    if isinstance(formula, Negative):
        return formula.operand
    if isinstance(formula, Number) and formula.value.numerator < 0:
        return Number(-formula.value)
    if isinstance(formula, Product):
        first = unsigned(formula.factors[0])
        return None if first is None else Product((first, *formula.factors[1:]))
    if isinstance(formula, Quotient):
        top = unsigned(formula.numerator)
        return None if top is None else Quotient(top, formula.denominator)
    return None


def _wrap(piece: Piece, level: int) -> str:
    """The text, in brackets if it binds more loosely than `level`."""
    return piece[0] if piece[1] >= level else f"({piece[0]})"


def ends_in_integral(formula: Formula) -> bool:
    """Whether the text ends in a differential: ∫ f dx, k ∫ f dx."""
    last = formula.factors[-1] if isinstance(formula, Product) and formula.factors else formula
    return isinstance(last, Integral)


def closing_level(formula: Formula) -> int:
    """How tightly what stands behind a minus has to bind: k ∫ f dx needs no brackets."""
    return NEGATIVE if isinstance(formula, Product) and ends_in_integral(formula) else PRODUCT


class Signs(Struct, frozen=True):
    """What stands between the terms of a sum, before a first negative one, and round a part that binds too loosely."""

    plus: str
    minus: str
    first: str
    brackets: Callable[[str], str]


ASCII = Signs(" + ", " - ", "-", "({})".format)
UNICODE = Signs(" + ", " − ", "−", "({})".format)


def join_terms(terms: tuple[Formula, ...], show: Callable[[Formula], Piece], signs: Signs) -> Piece:
    """The terms with their signs between them."""
    text = ""
    for term in terms:
        positive = unsigned(term)
        plain = term if positive is None else positive
        body, level = show(plain)
        if level <= NEGATIVE and not ends_in_integral(plain):  # its differential closes it
            body = signs.brackets(body)
        if text:
            text += f"{signs.plus if positive is None else signs.minus}{body}"
        else:
            text = body if positive is None else signs.first + body
            sole = level if positive is None else NEGATIVE
    return text, SUM if len(terms) > 1 else max(sole, NEGATIVE)


def _ascii(formula: Formula) -> Piece:
    positive = unsigned(formula)
    if positive is not None:
        return f"-{_wrap(_ascii(positive), PRODUCT)}", NEGATIVE
    match formula:
        case Number(value):
            return _number(value, glyphs=False)
        case Symbol(name) | Constant(name):
            return name, ATOM
        case Sum(terms):
            return join_terms(terms, _ascii, ASCII) if terms else ("0", ATOM)
        case Product(factors):
            pieces = [_ascii(factor) for factor in factors]
            leading = [_wrap(pieces[0], QUOTIENT if _is_fraction(factors[0]) else CALL)] if pieces else ["1"]
            return "*".join([*leading, *(_wrap(piece, CALL) for piece in pieces[1:])]), PRODUCT
        case Quotient(numerator, denominator):
            top = _ascii(numerator)
            text = f"({top[0]})" if top[1] in (SUM, NEGATIVE, QUOTIENT) else top[0]
            return f"{text}/{_wrap(_ascii(denominator), CALL)}", QUOTIENT
        case Power(base, exponent):
            return f"{_wrap(_ascii(base), ATOM)}^{_wrap(_ascii(exponent), ATOM)}", POWER
        case Call(function, arguments):
            return f"{function}({', '.join(_ascii(argument)[0] for argument in arguments)})", ATOM
        case Integral(integrand, variable, lower, upper):
            return f"integral({_ascii(integrand)[0]}, {variable}, {_ascii(lower)[0]}, {_ascii(upper)[0]})", ATOM
    raise TypeError(f"no text for {formula!r}")


def _unicode(formula: Formula) -> Piece:
    positive = unsigned(formula)
    if positive is not None:
        return f"−{_wrap(_unicode(positive), closing_level(positive))}", NEGATIVE
    match formula:
        case Decimal(text):
            return text, ATOM
        case Number(value):
            return _number(value, glyphs=True)
        case Symbol(name) | Constant(name):
            return name_to_text(name), ATOM
        case Sum(terms):
            return join_terms(terms, _unicode, UNICODE) if terms else ("0", ATOM)
        case Product(factors):
            level = NEGATIVE if ends_in_integral(formula) else PRODUCT
            return (_unicode_product(factors), level) if factors else ("1", ATOM)
        case Quotient(numerator, denominator):
            top = _unicode(numerator)
            text = f"({top[0]})" if top[1] in (SUM, NEGATIVE, QUOTIENT) else top[0]
            return f"{text}/{_wrap(_unicode(denominator), CALL)}", QUOTIENT
        case Power(base, exponent):
            return _unicode_power(base, exponent)
        case Call(function, arguments):
            return _unicode_call(function, arguments)
        case Integral(integrand, variable, lower, upper):
            body = _unicode(integrand)
            # A name with a `d` in front would look like the differential.
            looks = any(name.startswith("d") for name in integrand.symbols())
            text = f"({body[0]})" if body[1] <= NEGATIVE or looks else body[0]
            bounds = f"{_unicode(lower)[0]} → {_unicode(upper)[0]}"
            head = variable.partition("_")[0].removesuffix(PRIME).rstrip("0123456789")
            gap = "" if len(name_to_text(head)) == 1 else " "  # dt, dω, but d time
            return f"∫[{bounds}] {text} d{gap}{name_to_text(variable)}", NEGATIVE
    raise TypeError(f"no text for {formula!r}")


def _unicode_product(factors: tuple[Formula, ...]) -> str:
    """The factors side by side, with a dot before a number: 2·3 x."""
    text = ""
    for index, factor in enumerate(factors):
        piece = _unicode(factor)
        # `1/12 M` needs no bracket; `(L/2) M` gets one for the eye.
        body = _wrap(piece, QUOTIENT if index == 0 and _is_fraction(factor) else CALL)
        if trails(factor) and not (index == len(factors) - 1 or is_function(factors[index + 1])):
            body = _unicode_closed(factor)
        if index == len(factors) - 1 and isinstance(factor, Integral):
            body = piece[0]
        after = index > 0 and isinstance(factors[index - 1], Decimal)
        dot = "·" if after or body[0].isdigit() or body[0] in GLYPHS.values() else " "
        text = f"{text}{dot}{body}" if text else body
    return text


def _is_fraction(formula: Formula) -> bool:
    parts = (formula.numerator, formula.denominator) if isinstance(formula, Quotient) else (formula,)
    return all(isinstance(part, Number) for part in parts)


def is_function(formula: Formula) -> bool:
    """Whether the text begins with the name of a function that may go without brackets."""
    if isinstance(formula, Power):
        return _square_like(formula) and is_function(formula.base)
    return isinstance(formula, Call) and formula.function in BARE


def _square_like(formula: Power) -> bool:
    exponent = formula.exponent
    return isinstance(exponent, Number) and exponent.value.denominator == 1 and exponent.value > 0


def trails(formula: Formula) -> bool:
    """Whether the text ends in an argument without brackets, so that a further factor could be taken into it."""
    if isinstance(formula, Power):
        return _square_like(formula) and is_function(formula.base) and trails(formula.base)
    if not isinstance(formula, Call) or formula.function not in (*BARE, "sqrt"):
        return False
    return may_be_bare(as_told(formula.function, formula.arguments)[0])


def as_told(function: str, arguments: tuple[Formula, ...]) -> tuple[Formula, ...]:
    """The arguments of a function as they are written: the angle of a sine in degrees, sin 75°, where it is a short number of them."""
    degrees = degrees_of(arguments[0]) if function in ANGULAR and not isinstance(arguments[0], Constant) else None
    if degrees is None or abs(degrees) > TURN or 1000 % degrees.denominator:
        return arguments
    return (Decimal(f"{float(degrees):.9g}°".replace("-", "−")),)


def degrees_of(angle: Formula) -> Fraction | None:
    """The degrees of a multiple of π; None of all else."""
    match angle:
        case Constant():
            return Fraction(180)
        case Negative(operand):
            degrees = degrees_of(operand)
            return None if degrees is None else -degrees
        case Product((Number(value), Constant())):
            return 180 * value
        case Quotient(numerator, Number(value)) if value:
            degrees = degrees_of(numerator)
            return None if degrees is None else degrees / value
    return None


def may_be_bare(argument: Formula) -> bool:
    return isinstance(argument, Constant) or (isinstance(argument, Symbol) and not {".", "−"} & set(argument.name))


def _unicode_closed(formula: Formula) -> str:
    """The text of a function with its brackets: cos(θ), cos²(θ), √(x)."""
    if isinstance(formula, Power) and isinstance(formula.base, Call) and isinstance(formula.exponent, Number):
        call, raised = formula.base, superscripted(formula.exponent.value.numerator)
    else:
        assert isinstance(formula, Call)
        call, raised = formula, ""
    name = "√" if call.function == "sqrt" else BARE_NAMES.get(call.function, call.function)
    return f"{name}{raised}({_unicode(as_told(call.function, call.arguments)[0])[0]})"


def _unicode_call(function: str, arguments: tuple[Formula, ...]) -> Piece:
    arguments = as_told(function, arguments)
    inner = ", ".join(_unicode(argument)[0] for argument in arguments)
    if function == "abs":  # bars within bars could not be told apart
        return f"abs({inner})" if arguments[0].holds("abs") else f"|{inner}|", ATOM
    bare = len(arguments) == 1 and may_be_bare(arguments[0])
    if function == "sqrt":
        number = isinstance(arguments[0], Number) and arguments[0].value.denominator == 1 and arguments[0].value >= 0
        return f"√{inner}" if bare or number else f"√({inner})", CALL
    name = BARE_NAMES.get(function, function)
    if function in BARE:
        return f"{name} {inner}" if bare else f"{name}({inner})", CALL
    return f"{name}({inner})", CALL


def _unicode_power(base: Formula, exponent: Formula) -> Piece:
    whole = isinstance(exponent, Number) and exponent.value.denominator == 1
    if isinstance(base, Call) and base.function in BARE and whole and _square_like(Power(base, exponent)):
        assert isinstance(exponent, Number)
        raised = superscripted(exponent.value.numerator)
        (angle,) = as_told(base.function, base.arguments)
        inner = _unicode(angle)[0]
        body = f" {inner}" if may_be_bare(angle) else f"({inner})"
        return f"{BARE_NAMES.get(base.function, base.function)}{raised}{body}", CALL
    text = _wrap(_unicode(base), ATOM)
    if whole:
        assert isinstance(exponent, Number)
        return text + superscripted(exponent.value.numerator), POWER
    if isinstance(exponent, Number):
        return f"{text}^({'−' * (exponent.value < 0)}{number_to_text(abs(exponent.value))})", POWER
    return f"{text}^{_wrap(_unicode(exponent), ATOM)}", POWER
