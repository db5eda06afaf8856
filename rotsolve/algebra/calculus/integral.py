"""Integrals: antiderivatives of what textbooks integrate by hand, definite integrals, and how both stand on a page with their bounds."""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction
from functools import partial

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.normal import Fractions, coefficients, is_zero, simplify
from rotsolve.algebra.formula import (
    ONE,
    ZERO,
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
    add,
    call,
    divide,
    multiply,
    negate,
    power,
    total,
)


def antiderivative(f: Formula, name: str) -> Formula | None:
    """An antiderivative of a Laurent polynomial in `name`, or of sin, cos, exp of linear arguments; None otherwise."""
    if name not in f.symbols():
        return multiply(f, Symbol(name))
    problem = Fractions([f], extra=(name,))
    ring = problem.field
    num, den = ring.cancel(problem.ratio())
    i = ring.index[Symbol(name)]
    inside = [ring.mentions(k, name) for k in range(len(ring.atoms))]
    below, atoms = _bottom(ring, den, inside)
    powers = ring.coefficients(below, i)
    if any(below.degrees()[k] for k, hit in enumerate(inside) if hit):
        return None
    if sum(1 for part in powers if len(part)) != 1:
        return _logarithm(problem, num, powers, name) if not any(atoms) else None
    terms: list[Formula] = []
    for piece, key in _pieces(ring, num, inside):
        atom = _atom_product(ring, key, atoms)
        for n, part in enumerate(ring.coefficients(piece, i)):
            if len(part):
                term = _of_term(problem, (part, powers[-1]), atom, n - len(powers) + 1, name)
                if term is None:
                    return None
                terms.append(term)
    return total(terms)


def _bottom(ring: Field, den: Poly, inside: list[bool]) -> tuple[Poly, tuple[int, ...]]:
    """The denominator without its monomial of atoms that hold the name, and the exponents of that monomial."""
    exponents = den.term_content().monomial(0)
    atoms = tuple(int(e) if hit else 0 for e, hit in zip(exponents, inside, strict=True))
    return den / ring.context.term(1, atoms), atoms


def _pieces(ring: Field, num: Poly, inside: list[bool]) -> list[tuple[Poly, tuple[int, ...]]]:
    """The numerator split by the exponents of the atoms that hold the name."""
    parts: dict[tuple[int, ...], dict[tuple[int, ...], int]] = {}
    for exponents, coefficient in ring.terms(num).items():
        key = tuple(e if hit else 0 for e, hit in zip(exponents, inside, strict=True))
        rest = tuple(0 if hit else e for e, hit in zip(exponents, inside, strict=True))
        parts.setdefault(key, {})[rest] = coefficient
    return [(ring.poly(terms), key) for key, terms in parts.items()]


def _atom_product(ring: Field, above: tuple[int, ...], below: tuple[int, ...]) -> Formula:
    """The product of atoms with exponents above − below, all exponentials in one; ONE where there is none."""
    result: Formula = ONE
    exponent: Formula = ZERO
    for atom, up, down in zip(ring.atoms, above, below, strict=True):
        n = up - down
        if n and isinstance(atom, Call) and atom.function == "exp":
            exponent = add(exponent, multiply(Number(Fraction(n)), atom.arguments[0]))
        elif n:
            result = multiply(result, power(atom, n))
    return result if exponent == ZERO else multiply(result, call("exp", exponent))


def _logarithm(problem: Fractions, num: Poly, powers: list[Poly], name: str) -> Formula | None:
    """∫ k/(a + b x) dx = (k/b) log(a + b x)."""
    ring = problem.field
    if len(powers) != 2 or num.degrees()[ring.index[Symbol(name)]]:
        return None
    if any(num.degrees()[k] and ring.mentions(k, name) for k in range(len(ring.atoms))):
        return None
    line = powers[0] + powers[1] * ring.gens[ring.index[Symbol(name)]]
    return multiply(problem.shaper.ratio(ring.cancel((num, powers[1]))), call("log", problem.shaper.poly(line)))


def _of_term(problem: Fractions, factor: Ratio, atom: Formula, n: int, name: str) -> Formula | None:
    """∫ factor · atom · nameⁿ d(name)."""
    ring = problem.field
    x = Symbol(name)
    if atom == ONE and n != -1:
        power = ring.gens[ring.index[x]] ** abs(n + 1)
        top, bottom = factor
        pair = (top * power, bottom * (n + 1)) if n >= 0 else (top, bottom * power * (n + 1))
        return problem.shaper.ratio(ring.cancel(pair))
    constant = problem.shaper.ratio(ring.cancel(factor))
    if atom == ONE:
        return multiply(constant, call("log", x))
    if isinstance(atom, Call) and atom.function == "sqrt" and n >= 0:
        found = _of_root(atom, n, name)
        return None if found is None else multiply(constant, found)
    if n or not isinstance(atom, (Call, Power, Product)):
        return None
    if isinstance(atom, Call) and atom.function in ("sin", "cos", "exp"):
        slope = _constant_slope(atom.arguments[0], name)
        if slope is None:
            return None
        other = {"sin": negate(call("cos", *atom.arguments)), "cos": call("sin", *atom.arguments), "exp": atom}
        return simplify(multiply(constant, divide(other[atom.function], slope)))
    found = _of_trig_product(atom, name)
    return None if found is None else multiply(constant, found)


def _of_trig_product(atom: Formula, name: str) -> Formula | None:
    """∫ sinᵐ cosⁿ of one linear argument."""
    factors = atom.factors if isinstance(atom, Product) else (atom,)
    calls = [f.base if isinstance(f, Power) else f for f in factors]
    if not all(isinstance(c, Call) and c.function in ("sin", "cos") for c in calls):
        return None
    if len({c.children() for c in calls}) != 1:
        return None
    argument = calls[0].children()[0]
    slope = _constant_slope(argument, name)
    if slope is None:
        return None
    two = Number(Fraction(2))
    s, c = call("sin", argument), call("cos", argument)
    if len(factors) == 2 and all(isinstance(f, Call) for f in factors):
        return divide(power(s, 2), multiply(two, slope))
    if len(factors) == 1 and factors[0] in (power(s, 3), power(c, 3)):
        one, other = (c, s) if factors[0] == power(s, 3) else (s, c)  # sin³ = sin (1 − cos²)
        cube = add(one, negate(divide(power(one, 3), Number(Fraction(3)))))
        return divide(negate(cube) if other == s else cube, slope)
    if len(factors) == 1 and factors[0] in (power(s, 2), power(c, 2)):
        half = divide(multiply(s, c), multiply(two, slope))
        linear = divide(Symbol(name), two)
        return add(linear, negate(half) if factors[0] == power(s, 2) else half)
    powers = [int(f.exponent.value) if isinstance(f, Power) and isinstance(f.exponent, Number) else 1 for f in factors]
    shares = [sum(n for n, one in zip(powers, calls, strict=True) if one == base) for base in (s, c)]
    if min(powers) < 0:
        return None
    found = _of_trig_powers(s, c, *shares)
    return add(divide(found[0], slope), multiply(Number(found[1]), Symbol(name)))


def _of_trig_powers(s: Formula, c: Formula, m: int, n: int) -> tuple[Formula, Fraction]:
    """∫ sinᵐ u cosⁿ u du as (part in sine and cosine, coefficient of u), by the reductions from n to n − 2 and from m to m − 2."""
    if (m, n) == (0, 0):
        return ZERO, Fraction(1)
    if n == 1 or (m, n) == (1, 0):
        return (divide(power(s, m + 1), Number(Fraction(m + 1))) if n else negate(c)), Fraction(0)
    if n >= 2:
        first, factor = multiply(power(s, m + 1), power(c, n - 1)), Fraction(n - 1, m + n)
        rest, linear = _of_trig_powers(s, c, m, n - 2)
    else:
        first, factor = negate(multiply(power(s, m - 1), c)), Fraction(m - 1, m)
        rest, linear = _of_trig_powers(s, c, m - 2, n)
    return add(divide(first, Number(Fraction(m + n))), multiply(Number(factor), rest)), factor * linear


def _of_root(root: Call, n: int, name: str) -> Formula | None:
    """∫ xⁿ √(p − q x²) dx with a number q > 0, by the reduction from n to n − 2."""
    parts = coefficients(root.arguments[0], name)
    if parts is None or len(parts) != 3 or parts[1] != ZERO or not isinstance(parts[2], Number) or parts[2].value >= 0:
        return None
    x, p, q = Symbol(name), parts[0], negate(parts[2])
    cube = multiply(root.arguments[0], root)
    if n == 1:
        return negate(divide(cube, multiply(Number(Fraction(3)), q)))
    if n == 0:
        arc = divide(multiply(p, call("asin", divide(multiply(x, call("sqrt", q)), call("sqrt", p)))), call("sqrt", q))
        return divide(add(multiply(x, root), arc), Number(Fraction(2)))
    lower = _of_root(root, n - 2, name)
    assert lower is not None
    first = negate(multiply(power(x, n - 1), cube))
    rest = multiply(multiply(p, Number(Fraction(n - 1))), lower)
    return divide(add(first, rest), multiply(q, Number(Fraction(n + 2))))


def _constant_slope(argument: Formula, name: str) -> Formula | None:
    """The slope of a linear argument, None where it is not linear."""
    problem = Fractions([differentiate(argument, name)])
    slope = problem.shortest(problem.ratio())
    return None if name in slope.symbols() or slope == ZERO else slope


def integrate(
    f: Formula, name: str, lower: Formula, upper: Formula, *, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) from lower to upper in closed form, None where neither a textbook nor SymPy finds one."""
    f = without_sizes(f, name, lower, upper, positive)
    found = integrate_by_hand(f, name, lower, upper, positive=positive)
    if found is not None:
        return found
    from rotsolve.algebra.sympy_bridge import definite_integral

    found = definite_integral(f, name, lower, upper, positive)
    return found if found is not None and agrees(found, Integral(f, name, lower, upper), positive) else None


def without_sizes(f: Formula, name: str, lower: Formula, upper: Formula, positive: Collection[str]) -> Formula:
    """|x| as x where both ends are positive or zero, as −x where both are negative or zero."""
    x = Symbol(name)
    for sign, size in ((ONE, x), (negate(ONE), negate(x))):
        ends = (simplify(multiply(sign, end), positive=positive) for end in (lower, upper))
        if all(is_zero(end) or _is_positive(end, positive) for end in ends):
            return f.transform(partial(_put_for, call("abs", x), size), "abs")
    return f


def _put_for(old: Formula, new: Formula, node: Formula) -> Formula:
    return new if node == old else node


def agrees(found: Formula, integral: Integral, positive: Collection[str]) -> bool:
    """Whether nothing tells an integral from what SymPy has for it, at sets of numbers at which it has a value.

    SymPy 1.14 has 0 for ∫ₐᵇ −I/(Q + c x |x|) dx with letters of either sign, and logarithms of negative numbers for others.
    """
    from rotsolve.algebra.certified.ball import Precision
    from rotsolve.algebra.certified.balls import RealBalls, Undefined

    letters = sorted(found.symbols() | integral.symbols())
    for step in range(1, TRIED + 1):
        sizes = [Fraction(1 + step * place % 11, 4) for place in range(1, len(letters) + 1)]
        signs = [1 if letter in positive or step % 2 else -1 for letter in letters]
        values = {name: Number(sign * size) for name, sign, size in zip(letters, signs, sizes, strict=True)}
        known = False
        try:
            with Precision(64):
                wanted = RealBalls(values)(integral)
                known = wanted.is_finite()
                told = RealBalls(values)(found)
        except (Undefined, ZeroDivisionError):
            if known:
                return False
            continue
        if known and told.is_finite() and not told.overlaps(wanted):
            return False
    return True


def integrate_by_hand(
    f: Formula, name: str, lower: Formula, upper: Formula, *, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) without SymPy; an antiderivative with a pole or logarithm only where both ends have one known sign."""
    primitive = antiderivative(f, name)
    if primitive is None or not _continuous(primitive, name, lower, upper, positive):
        return None
    high = primitive.substitute({name: upper})
    return simplify(add(high, negate(primitive.substitute({name: lower}))), positive=positive)


def carried_out(f: Formula, positive: Collection[str]) -> Formula:
    """All integrals in closed form where there is one."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Integral):
            return node
        done = integrate(node.integrand, node.variable, node.lower, node.upper, positive=positive)
        return node if done is None else done

    return f.transform(change, Integral)


def _continuous(primitive: Formula, name: str, lower: Formula, upper: Formula, positive: Collection[str]) -> bool:
    """Whether the antiderivative has no pole in `name`, or both ends are certainly positive."""
    singular = any(
        (isinstance(node, Quotient) and name in node.denominator.symbols())
        or (isinstance(node, Call) and node.function == "log" and name in node.symbols())
        for node in primitive.walk(Quotient, "log")
    )
    return not singular or all(_is_positive(end, positive) for end in (lower, upper))


def _is_positive(end: Formula, positive: Collection[str]) -> bool:
    if isinstance(end, Number):
        return end.value > 0
    if isinstance(end, (Sum, Product, Quotient)):
        return all(_is_positive(child, positive) for child in end.children())
    return isinstance(end, Symbol) and end.name in positive


TWO = Number(Fraction(2))
TRIED = 10  # sets of numbers at which an integral is held against what SymPy has for it
Tidy = Callable[[Formula], Formula]


def at_bounds(integral: Integral, tidy: Tidy) -> Formula | None:
    """k (F(upper) − F(lower)) with what does not vary in front; an end where F vanishes is not written. None without an F."""
    name = integral.variable
    constant, rest = split(tidy(integral.integrand), name)
    primitive = written_antiderivative(rest, name, tidy)
    if primitive is None:
        return None
    terms = [tidy(term) for term in terms_of_antiderivative(primitive, name)]
    if len(terms) == 1:
        factor, terms[0] = split(terms[0], name)
        if isinstance(constant, Quotient) and factor != ONE and is_zero(at(terms[0], name, integral.lower, tidy)):
            last = at(terms[0], name, integral.upper, tidy)
            return Product((constant, multiply(factor, last)))  # (2 M/R²) (¼ R⁴), as it is found
        constant = tidy(multiply(constant, factor))
        if isinstance(terms[0], Call) and terms[0].function == "log":  # k (ln u − ln l) = k ln(u/l)
            last, first = (at(terms[0].arguments[0], name, end, tidy) for end in (integral.upper, integral.lower))
            return multiply(constant, call("log", divide(last, first)))
    high, low = (total([at(term, name, end, tidy) for term in terms]) for end in (integral.upper, integral.lower))
    if is_zero(low):
        return in_front(constant, high)
    if is_zero(high):
        return in_front(negate(constant), low)
    symmetric = is_zero(integral.lower + integral.upper)
    if len(terms) > 1 and symmetric and is_zero(high + low):  # an even function from −a to a
        return multiply(TWO, in_front(constant, high))
    return in_front(constant, high - low)


def written_antiderivative(f: Formula, name: str, tidy: Tidy) -> Formula | None:
    """What a textbook integrates by hand, and k ln g of k g′/g."""
    found = antiderivative(f, name)
    if found is not None or not isinstance(f, Quotient):
        return found
    slope = tidy(differentiate(f.denominator, name))
    share = tidy(f.numerator / slope)
    return None if name in share.symbols() else multiply(share, call("log", f.denominator))


def at(term: Formula, name: str, end: Formula, tidy: Tidy) -> Formula:
    """A term at an end: functions as they stand there, and (½ L)³ and (−R)³, but R² R as R³."""
    bare = end.operand if isinstance(end, Negative) else end
    raised = any(isinstance(node, Power) and name in node.symbols() for node in term.walk())
    alone = end != bare and split(term, name)[0] == ONE
    if alone or (raised and not isinstance(bare, (Symbol, Number))):
        return term.substitute({name: end})
    calls = dict.fromkeys(node for node in term.walk() if isinstance(node, Call) and name in node.symbols())
    letters: dict[Formula, Symbol] = {call: Symbol(f"|{number}") for number, call in enumerate(calls)}
    there = tidy(term.transform(lambda node: letters.get(node) or node).substitute({name: end}))
    return there.substitute({letter.name: call.substitute({name: end}) for call, letter in letters.items()})


def split(f: Formula, name: str) -> tuple[Formula, Formula]:
    """A product as its factors without a letter, and those with it."""
    if name not in f.symbols():
        return f, ONE
    if isinstance(f, Negative):
        constant, rest = split(f.operand, name)
        return negate(constant), rest
    if isinstance(f, Quotient):
        (above, top), (below, bottom) = split(f.numerator, name), split(f.denominator, name)
        return divide(above, below), divide(top, bottom)
    if isinstance(f, Product):
        constant, rest = ONE, ONE
        for factor in f.factors:
            own, varying = split(factor, name)
            constant, rest = multiply(constant, own), multiply(rest, varying)
        return constant, rest
    return ONE, f


def terms_of_antiderivative(f: Formula, name: str) -> list[Formula]:
    """The terms of an antiderivative: a factor in front of a sum goes to each."""
    if isinstance(f, Sum):
        return [part for term in f.terms for part in terms_of_antiderivative(term, name)]
    constant, rest = split(f, name)
    return [multiply(constant, part) for part in terms_of_antiderivative(rest, name)] if isinstance(rest, Sum) else [f]


def in_front(constant: Formula, value: Formula) -> Formula:
    """k (a − b), and M R⁴/(2 R²) of a single term."""
    if isinstance(constant, Negative):
        return negate(in_front(constant.operand, value))
    if isinstance(constant, Quotient) and not isinstance(value, Sum):
        return divide(multiply(constant.numerator, value), constant.denominator)
    return multiply(constant, value)
