"""Calculus: derivatives, and integrals of what textbooks integrate by hand; SymPy is asked only beyond that."""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction

from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.normal import Problem, coefficients, simplify
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
    total,
)


def differentiate(f: Formula, name: str) -> Formula:
    """df/d(name), not simplified beyond trivial zeros and ones."""
    if isinstance(f, Symbol):
        return ONE if f.name == name else ZERO
    if name not in f.symbols():
        return ZERO
    if isinstance(f, Sum):
        return total([differentiate(term, name) for term in f.terms])
    if isinstance(f, Negative):
        return negate(differentiate(f.operand, name))
    if isinstance(f, Product):
        return _product_rule(f, name)
    if isinstance(f, Quotient):
        top, bottom = differentiate(f.numerator, name), differentiate(f.denominator, name)
        first = divide(top, f.denominator)
        return add(first, negate(divide(multiply(f.numerator, bottom), _power(f.denominator, 2))))
    if isinstance(f, Power):
        return _power_rule(f, name)
    if isinstance(f, Call):
        return _chain_rule(f, name)
    if isinstance(f, Integral):
        return _leibniz(f, name)
    raise ValueError(f"no derivative of {f!r}")


def _power(base: Formula, n: int) -> Formula:
    return ONE if n == 0 else base if n == 1 else Power(base, Number(Fraction(n)))


def _product_rule(f: Product, name: str) -> Formula:
    terms = []
    for k, factor in enumerate(f.factors):
        slope = differentiate(factor, name)
        for other in (*f.factors[:k], *f.factors[k + 1 :]):
            slope = multiply(slope, other)
        terms.append(slope)
    return total(terms)


def _power_rule(f: Power, name: str) -> Formula:
    slope = differentiate(f.base, name)
    if name not in f.exponent.symbols():
        exponent = add(f.exponent, Number(Fraction(-1)))
        lower = ONE if exponent == ZERO else f.base**exponent
        return multiply(multiply(f.exponent, lower), slope)
    growth = multiply(differentiate(f.exponent, name), call("log", f.base))
    return multiply(f, add(growth, multiply(f.exponent, divide(slope, f.base))))


def _chain_rule(f: Call, name: str) -> Formula:
    if f.function == "ellipk":
        raise ValueError(f"no derivative of {f!r}")
    u = f.arguments[0]
    slope = differentiate(u, name)
    if f.function == "atan2":
        x = f.arguments[1]
        top = add(multiply(x, slope), negate(multiply(u, differentiate(x, name))))
        return divide(top, add(_power(x, 2), _power(u, 2)))
    if f.function == "sin":
        return multiply(slope, call("cos", u))
    if f.function == "cos":
        return negate(multiply(slope, call("sin", u)))
    if f.function == "exp":
        return multiply(slope, f)
    below = {
        "tan": lambda: _power(call("cos", u), 2),
        "sqrt": lambda: multiply(Number(Fraction(2)), f),
        "log": lambda: u,
        "asin": lambda: call("sqrt", add(ONE, negate(_power(u, 2)))),
        "acos": lambda: negate(call("sqrt", add(ONE, negate(_power(u, 2))))),
        "atan": lambda: add(ONE, _power(u, 2)),
        "abs": lambda: divide(f, u),
    }[f.function]()
    return divide(slope, below)


def _leibniz(f: Integral, name: str) -> Formula:
    upper = multiply(f.integrand.substitute({f.variable: f.upper}), differentiate(f.upper, name))
    lower = multiply(f.integrand.substitute({f.variable: f.lower}), differentiate(f.lower, name))
    result = add(upper, negate(lower))
    if f.variable != name and name in f.integrand.symbols():
        inner = differentiate(f.integrand, name)
        result = add(result, Integral(inner, f.variable, f.lower, f.upper))
    return result


def integrate_polynomial(f: Formula, name: str) -> Formula | None:
    """An antiderivative of a Laurent polynomial in `name`, or of sin, cos, exp of linear arguments; None otherwise."""
    if name not in f.symbols():
        return multiply(f, Symbol(name))
    problem = Problem([f], extra=(name,))
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
                term = _antiderivative(problem, (part, powers[-1]), atom, n - len(powers) + 1, name)
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
    for coefficient, exponents in ring.terms(num):
        key = tuple(e if hit else 0 for e, hit in zip(exponents, inside, strict=True))
        rest = tuple(0 if hit else e for e, hit in zip(exponents, inside, strict=True))
        parts.setdefault(key, {})[rest] = coefficient
    return [(ring.context.from_dict(terms), key) for key, terms in parts.items()]


def _atom_product(ring: Field, above: tuple[int, ...], below: tuple[int, ...]) -> Formula:
    """The product of atoms with exponents above − below, all exponentials in one; ONE where there is none."""
    result: Formula = ONE
    exponent: Formula = ZERO
    for atom, up, down in zip(ring.atoms, above, below, strict=True):
        n = up - down
        if n and isinstance(atom, Call) and atom.function == "exp":
            exponent = add(exponent, multiply(Number(Fraction(n)), atom.arguments[0]))
        elif n:
            result = multiply(result, _power(atom, n))
    return result if exponent == ZERO else multiply(result, call("exp", exponent))


def _logarithm(problem: Problem, num: Poly, powers: list[Poly], name: str) -> Formula | None:
    """∫ k/(a + b x) dx = (k/b) log(a + b x)."""
    ring = problem.field
    if len(powers) != 2 or num.degrees()[ring.index[Symbol(name)]]:
        return None
    if any(num.degrees()[k] and ring.mentions(k, name) for k in range(len(ring.atoms))):
        return None
    line = powers[0] + powers[1] * ring.gens[ring.index[Symbol(name)]]
    return multiply(problem.shaper.ratio(ring.cancel((num, powers[1]))), call("log", problem.shaper.poly(line)))


def _antiderivative(problem: Problem, factor: Ratio, atom: Formula, n: int, name: str) -> Formula | None:
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
        found = _antiderivative_of_root(atom, n, name)
        return None if found is None else multiply(constant, found)
    if n or not isinstance(atom, (Call, Power, Product)):
        return None
    if isinstance(atom, Call) and atom.function in ("sin", "cos", "exp"):
        slope = _constant_slope(atom.arguments[0], name)
        if slope is None:
            return None
        other = {"sin": negate(call("cos", *atom.arguments)), "cos": call("sin", *atom.arguments), "exp": atom}
        return simplify(multiply(constant, divide(other[atom.function], slope)))
    found = _antiderivative_of_squares(atom, name)
    return None if found is None else multiply(constant, found)


def _antiderivative_of_squares(atom: Formula, name: str) -> Formula | None:
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
        return divide(_power(s, 2), multiply(two, slope))
    if len(factors) == 1 and factors[0] in (_power(s, 3), _power(c, 3)):
        one, other = (c, s) if factors[0] == _power(s, 3) else (s, c)  # sin³ = sin (1 − cos²)
        cube = add(one, negate(divide(_power(one, 3), Number(Fraction(3)))))
        return divide(negate(cube) if other == s else cube, slope)
    if len(factors) == 1 and factors[0] in (_power(s, 2), _power(c, 2)):
        half = divide(multiply(s, c), multiply(two, slope))
        linear = divide(Symbol(name), two)
        return add(linear, negate(half) if factors[0] == _power(s, 2) else half)
    powers = [int(f.exponent.value) if isinstance(f, Power) and isinstance(f.exponent, Number) else 1 for f in factors]
    shares = [sum(n for n, one in zip(powers, calls, strict=True) if one == base) for base in (s, c)]
    if min(powers) < 0:
        return None
    found = _antiderivative_of_powers(s, c, *shares)
    return add(divide(found[0], slope), multiply(Number(found[1]), Symbol(name)))


def _antiderivative_of_powers(s: Formula, c: Formula, m: int, n: int) -> tuple[Formula, Fraction]:
    """∫ sinᵐ u cosⁿ u du as (part in sine and cosine, coefficient of u), by the reductions from n to n − 2 and from m to m − 2."""
    if (m, n) == (0, 0):
        return ZERO, Fraction(1)
    if n == 1 or (m, n) == (1, 0):
        return (divide(_power(s, m + 1), Number(Fraction(m + 1))) if n else negate(c)), Fraction(0)
    if n >= 2:
        first, factor = multiply(_power(s, m + 1), _power(c, n - 1)), Fraction(n - 1, m + n)
        rest, linear = _antiderivative_of_powers(s, c, m, n - 2)
    else:
        first, factor = negate(multiply(_power(s, m - 1), c)), Fraction(m - 1, m)
        rest, linear = _antiderivative_of_powers(s, c, m - 2, n)
    return add(divide(first, Number(Fraction(m + n))), multiply(Number(factor), rest)), factor * linear


def _antiderivative_of_root(root: Call, n: int, name: str) -> Formula | None:
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
    lower = _antiderivative_of_root(root, n - 2, name)
    assert lower is not None
    first = negate(multiply(_power(x, n - 1), cube))
    rest = multiply(multiply(p, Number(Fraction(n - 1))), lower)
    return divide(add(first, rest), multiply(q, Number(Fraction(n + 2))))


def _constant_slope(argument: Formula, name: str) -> Formula | None:
    """The slope of a linear argument, None where it is not linear."""
    problem = Problem([differentiate(argument, name)])
    slope = problem.shortest(problem.ratio())
    return None if name in slope.symbols() or slope == ZERO else slope


def integrate(
    f: Formula, name: str, lower: Formula, upper: Formula, *, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) from lower to upper in closed form, None where neither this module nor SymPy finds one."""
    found = integrate_by_hand(f, name, lower, upper, positive=positive)
    if found is not None:
        return found
    from rotsolve.algebra.sympy_bridge import definite_integral

    return definite_integral(f, name, lower, upper, positive)


def integrate_by_hand(
    f: Formula, name: str, lower: Formula, upper: Formula, *, positive: Collection[str] = ()
) -> Formula | None:
    """∫ f d(name) by this module alone; an antiderivative with a pole or logarithm only where both ends have one known sign."""
    primitive = integrate_polynomial(f, name)
    if primitive is None or not _continuous(primitive, name, lower, upper, positive):
        return None
    high = primitive.substitute({name: upper})
    return simplify(add(high, negate(primitive.substitute({name: lower}))), positive=positive)


def carried_out(
    f: Formula, positive: Collection[str] = (), tidied: Callable[[Formula], Formula] | None = None
) -> Formula:
    """All integrals in closed form where there is one, each result `tidied`."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Integral):
            return node
        done = integrate(node.integrand, node.variable, node.lower, node.upper, positive=positive)
        return node if done is None else tidied(done) if tidied else done

    return f.transform(change)


def _continuous(primitive: Formula, name: str, lower: Formula, upper: Formula, positive: Collection[str]) -> bool:
    """Whether the antiderivative has no pole in `name`, or both ends are certainly positive."""
    singular = any(
        (isinstance(node, Quotient) and name in node.denominator.symbols())
        or (isinstance(node, Call) and node.function == "log" and name in node.symbols())
        for node in primitive.walk()
    )
    return not singular or all(_is_positive(end, positive) for end in (lower, upper))


def _is_positive(end: Formula, positive: Collection[str]) -> bool:
    if isinstance(end, Number):
        return end.value > 0
    if isinstance(end, (Sum, Product, Quotient)):
        return all(_is_positive(child, positive) for child in end.children())
    return isinstance(end, Symbol) and end.name in positive
