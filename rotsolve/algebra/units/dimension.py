"""Dimension: what a quantity is made of (length, mass, time), and whether a formula's parts fit together.

Angle is a *soft* dimension: it is carried along, so that a torque (J/rad) can be told from an energy, but two
dimensions match when all else agrees, since textbooks write v = ω R.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from functools import cache

from msgspec import Struct

from rotsolve.algebra.formula import (
    ZERO,
    Call,
    Constant,
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
from rotsolve.algebra.notation.letters import superscripted
from rotsolve.algebra.notation.limits import rational
from rotsolve.algebra.notation.text import to_text

Exponent = int | Fraction


class Dimension(Struct, frozen=True):
    """length^… · mass^… · time^… · angle^…"""

    length: Exponent = 0
    mass: Exponent = 0
    time: Exponent = 0
    angle: Exponent = 0

    def matches(self, other: Dimension) -> bool:
        """Whether both are the same but for angle."""
        return (self.length, self.mass, self.time) == (other.length, other.mass, other.time)

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(
            self.length + other.length, self.mass + other.mass, self.time + other.time, self.angle + other.angle
        )

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    def __pow__(self, exponent: Exponent) -> Dimension:
        return Dimension(self.length * exponent, self.mass * exponent, self.time * exponent, self.angle * exponent)


class DimensionError(ValueError):
    """Parts of a formula that do not fit together."""

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.message = message


OTHER_RANK = 3  # of constants of other dimensions, such as those of a law of force

NONE = Dimension()
LENGTH = Dimension(length=1)
MASS = Dimension(mass=1)
TIME = Dimension(time=1)
ANGLE = Dimension(angle=1)
AREA = LENGTH**2
VOLUME = LENGTH**3
FREQUENCY = TIME**-1
VELOCITY = LENGTH / TIME
ACCELERATION = VELOCITY / TIME
ANGULAR_VELOCITY = ANGLE / TIME
ANGULAR_ACCELERATION = ANGULAR_VELOCITY / TIME
FORCE = MASS * ACCELERATION
ENERGY = FORCE * LENGTH
TORQUE = ENERGY / ANGLE
POWER = ENERGY / TIME
MOMENTUM = MASS * VELOCITY
INERTIA = TORQUE / ANGULAR_ACCELERATION
ANGULAR_MOMENTUM = TORQUE * TIME
STIFFNESS = FORCE / LENGTH
TORSION_STIFFNESS = TORQUE / ANGLE
PRESSURE = FORCE / AREA
LINE_DENSITY = MASS / LENGTH
AREA_DENSITY = MASS / AREA
DENSITY = MASS / VOLUME
DAMPING = FORCE / VELOCITY
ROTARY_DAMPING = TORQUE / ANGULAR_VELOCITY


class Kind(Struct, frozen=True):
    """A kind of quantity: its name with its article, the unit in which it is printed, and all else that goes by kind.

    `word` is what keys of the language and messages call it where that is not its name, empty where they never do; `rank` its place
    in a printed product; `positive` says whether a letter of it surely is; `example` is a value for messages.
    """

    name: str
    article: str
    unit: str
    dimension: Dimension
    word: str | None = None
    rank: int = OTHER_RANK
    positive: bool = False
    example: str = ""

    @property
    def words(self) -> str:
        return f"{self.article} {self.name}".strip()


KINDS = (  # of kinds with one dimension, the first is meant where nobody says which; ranks: m g, F R, M R², I ω, m v L, ½ k x², M g L cos θ
    Kind("pure number", "a", "", NONE, word="number", rank=0, example="0.5"),
    Kind("length", "a", "m", LENGTH, rank=12, positive=True, example="20 cm"),
    Kind("mass", "a", "kg", MASS, rank=1, positive=True, example="3 kg"),
    Kind("time", "a", "s", TIME, rank=16, positive=True, example="2 s"),
    Kind("angle", "an", "rad", ANGLE, rank=15, example="30 deg"),
    Kind("area", "an", "m²", AREA),
    Kind("volume", "a", "m³", VOLUME),
    Kind("rate", "a", "1/s", FREQUENCY, word=""),
    Kind("frequency", "a", "Hz", FREQUENCY),
    Kind("squared rate", "a", "1/s²", FREQUENCY**2),
    Kind("velocity", "a", "m/s", VELOCITY, rank=11, example="4 m/s"),
    Kind("acceleration", "an", "m/s²", ACCELERATION, rank=9, positive=True, example="9.8 m/s^2"),
    Kind("angular velocity", "an", "rad/s", ANGULAR_VELOCITY, rank=13, example="3 rad/s"),
    Kind("angular acceleration", "an", "rad/s²", ANGULAR_ACCELERATION, rank=14, example="2 rad/s^2"),
    Kind("force", "a", "N", FORCE, rank=6, example="12 N"),
    Kind("torque", "a", "N m", TORQUE, rank=7, example="5 N m"),
    Kind("energy or torque", "an", "J", ENERGY, word=""),
    Kind("energy", "an", "J", ENERGY, example="10 J"),
    Kind("work", "", "J", ENERGY, word=""),
    Kind("power", "a", "W", POWER, rank=8, example="500 W"),
    Kind("momentum", "a", "kg m/s", MOMENTUM, rank=10, example="3 kg m/s"),
    Kind("impulse", "an", "N s", MOMENTUM, example="2 N s"),
    Kind("moment of inertia", "a", "kg m²", INERTIA, rank=2, positive=True, example="2 kg m^2"),
    Kind("angular momentum", "an", "kg m²/s", ANGULAR_MOMENTUM, example="3 kg m^2/s"),
    Kind("angular impulse", "an", "N m s", ANGULAR_MOMENTUM),
    Kind("stiffness", "a", "N/m", STIFFNESS, rank=4, positive=True, example="200 N/m"),
    Kind(
        "torsion stiffness",
        "a",
        "N m/rad",
        TORSION_STIFFNESS,
        word="torsional stiffness",
        rank=5,
        positive=True,
        example="0.5 N m/rad",
    ),
    Kind("line density", "a", "kg/m", LINE_DENSITY, word="density per length"),
    Kind("area density", "an", "kg/m²", AREA_DENSITY, word="density per area"),
    Kind("density", "a", "kg/m³", DENSITY),
    Kind("pressure", "a", "Pa", PRESSURE),
    Kind("damping", "a", "N s/m", DAMPING),
    Kind("rotary damping", "a", "N m s/rad", ROTARY_DAMPING),
    Kind("force per time", "a", "N/s", FORCE / TIME),
    Kind("force per time squared", "a", "N/s²", FORCE / TIME**2),
    Kind("torque per time", "a", "N m/s", TORQUE / TIME),
    Kind("torque per time squared", "a", "N m/s²", TORQUE / TIME**2),
)
BY_NAME = {kind.word or kind.name: kind for kind in KINDS if kind.word != ""}  # as the language calls them
DIMENSIONS = {word: kind.dimension for word, kind in BY_NAME.items()}
_RANKS = {kind.dimension: kind.rank for kind in reversed(KINDS)}
_POSITIVE = {kind.dimension for kind in KINDS if kind.positive} | {
    MASS * LENGTH**2
}  # an inertia as scenes write it, in kg m²


def product_rank(dimension: Dimension | None) -> int:
    """Where letters of this dimension stand in a printed product."""
    return OTHER_RANK if dimension is None else _RANKS.get(dimension, OTHER_RANK)


def is_positive(dimension: Dimension | None) -> bool:
    """Whether all quantities of this dimension are positive, as masses and lengths."""
    return dimension in _POSITIVE


def word_of(dimension: Dimension | None) -> str | None:
    """What the language calls a dimension."""
    return next((word for word, own in DIMENSIONS.items() if own == dimension), None)


def kind_of(dimension: Dimension, name: str | None = None) -> Kind | None:
    """The kind of that dimension: the one called `name`, else the first with the same angle, else the first."""
    matching = [kind for kind in KINDS if kind.dimension.matches(dimension)]
    exact = [kind for kind in matching if kind.dimension.angle == dimension.angle]
    named = [kind for kind in matching if kind.name == name]
    return next(iter((*named, *exact, *matching)), None)


def base_unit_text(dimension: Dimension) -> str:
    """The dimension in base units: `kg m³/s`."""
    units = {"kg": dimension.mass, "m": dimension.length, "rad": dimension.angle, "s": dimension.time}
    return product_of_units(units.items())


def product_of_units(parts: Collection[tuple[str, Exponent]]) -> str:
    """Units with their exponents: `kg m²/s`, with a bracket around several below the slash."""
    above = " ".join(unit_power(unit, exponent) for unit, exponent in parts if exponent > 0)
    below = [unit_power(unit, -exponent) for unit, exponent in parts if exponent < 0]
    if not below:
        return above
    return f"{above or '1'}/{below[0]}" if len(below) == 1 else f"{above or '1'}/({' '.join(below)})"


def unit_power(unit: str, exponent: Exponent) -> str:
    """A unit with its power: s², s^(1/2)."""
    if exponent == 1:
        return unit
    whole = Fraction(exponent)
    return unit + superscripted(whole.numerator) if whole.denominator == 1 else f"{unit}^({whole})"


@cache
def describe(dimension: Dimension, *, article: bool = False) -> str:
    """Words for messages: `force (N)`, with `article=True` `a force (N)`."""
    kind = kind_of(dimension)
    if kind is None:
        return f"{'a ' * article}quantity in {base_unit_text(dimension)}"
    name = kind.words if article else kind.name
    return f"{name} ({kind.unit})" if kind.unit else name


class LetterDimensions(dict[str, Dimension]):
    """The dimensions of letters, and of the functions of them that have been met: a long formula holds the same ones many times."""

    def __init__(self, symbols: Mapping[str, Dimension]) -> None:
        super().__init__(symbols)
        self.calls: dict[Formula, Dimension | None] = {}


def dimension_of(formula: Formula, symbols: Mapping[str, Dimension]) -> Dimension:
    """The dimension of a formula; `DimensionError` if its parts do not fit together. Zero fits everything."""
    return _dimension(formula, LetterDimensions(symbols)) or NONE


def printed_dimension(formula: Formula, symbols: Mapping[str, Dimension]) -> Dimension:
    """The dimension by whose unit a number of a formula is told: with the angle of its terms, if there is a kind of such quantities, else
    without any: ω + v/R in rad/s, v + ω R in m/s, 1 + θ² is a pure number."""
    whole = dimension_of(formula, symbols)
    terms = [dimension_of(term, symbols) for term in formula.terms] if isinstance(formula, Sum) else [whole]
    most = max(terms, key=lambda term: term.angle**2)
    return most if any(kind.dimension == most for kind in KINDS) else whole / ANGLE**whole.angle


def fits_everything(formula: Formula, symbols: Mapping[str, Dimension]) -> bool:
    """Whether a formula whose parts fit together is a zero as it is written, 0 or 0·m, which has any dimension."""
    return _dimension(formula, LetterDimensions(symbols)) is None


def _dimension(formula: Formula, symbols: LetterDimensions) -> Dimension | None:
    """The dimension; None for a zero, which has any."""
    match formula:
        case Number(value):
            return NONE if value else None
        case Constant():
            return NONE
        case Symbol(name):
            if name not in symbols:
                raise DimensionError(f"the dimension of {to_text(formula)} is not known")
            return symbols[name]
        case Negative(operand):
            return _dimension(operand, symbols)
        case Sum(terms):
            return _common(terms, symbols)
        case Product(factors):
            return _product_dimension(factors, symbols)
        case Quotient(numerator, denominator):
            above, below = _dimension(numerator, symbols), _dimension(denominator, symbols)
            return None if above is None else above / (below or NONE)
        case Power(base, exponent):
            return _power_dimension(base, exponent, symbols)
        case Call(function, arguments):
            if formula not in symbols.calls:
                symbols.calls[formula] = _call_dimension(function, arguments, symbols)
            return symbols.calls[formula]
        case Integral():
            return _integral(formula, symbols)
    raise TypeError(f"no dimension for {formula!r}")


def _common(terms: tuple[Formula, ...], symbols: LetterDimensions) -> Dimension | None:
    """The one dimension of all terms; a plain number added to an angle is one too."""
    first: tuple[Formula, Dimension] | None = None
    angle = False
    for term in terms:
        dimension = _dimension(term, symbols)
        if dimension is None:
            continue
        angle = angle or dimension == ANGLE
        if first is None:
            first = term, dimension
        elif not dimension.matches(first[1]):
            left, right = (_say(part) for part in (first[0], term))
            there, here = describe(first[1], article=True), describe(dimension, article=True)
            raise DimensionError(f"{left} is {there}, but {right} is {here}")
    return ANGLE if angle else None if first is None else first[1]


def _say(formula: Formula) -> str:
    return to_text(formula.operand if isinstance(formula, Negative) else formula)


def _product_dimension(factors: tuple[Formula, ...], symbols: LetterDimensions) -> Dimension | None:
    result = NONE
    zero = False
    for factor in factors:
        dimension = _dimension(factor, symbols)
        zero = zero or dimension is None
        result = result * (dimension or NONE)
    return None if zero else result


def _power_dimension(base: Formula, exponent: Formula, symbols: LetterDimensions) -> Dimension | None:
    above = _dimension(exponent, symbols)
    if above is not None and not above.matches(NONE):
        raise DimensionError(f"the exponent {_say(exponent)} is {describe(above, article=True)}, not a pure number")
    dimension = _dimension(base, symbols)
    value = rational(exponent)
    if dimension is None:
        return NONE if value == 0 else None
    if value is not None:
        return dimension**value
    if not dimension.matches(NONE):
        what = describe(dimension, article=True)
        raise DimensionError(f"{_say(base)} is {what}, so its exponent must be a number, not {_say(exponent)}")
    return NONE


def _call_dimension(function: str, arguments: tuple[Formula, ...], symbols: LetterDimensions) -> Dimension | None:
    if function == "atan2":
        _common(arguments, symbols)
        return ANGLE
    dimension = _dimension(arguments[0], symbols)
    if function == "abs":
        return dimension
    if function == "sqrt":
        return None if dimension is None else dimension ** Fraction(1, 2)
    for argument in arguments:
        dimension = _dimension(argument, symbols)
        if dimension is not None and not dimension.matches(NONE):
            wanted = "an angle" if function in ("sin", "cos", "tan") else "a pure number"
            what = describe(dimension, article=True)
            raise DimensionError(f"{function} takes {wanted}, but {_say(argument)} is {what}")
    return ANGLE if function.startswith("a") else NONE


def _integral(formula: Integral, symbols: LetterDimensions) -> Dimension | None:
    """The integrand's dimension times the variable's, which the bounds must have too."""
    bounds = _common((formula.lower, formula.upper), symbols)
    known = {**({} if bounds is None else {formula.variable: bounds}), "time": TIME, **symbols}
    variable = known.get(formula.variable)
    if variable is None:
        raise DimensionError(f"the dimension of {to_text(Symbol(formula.variable))} is not known")
    if bounds is not None and not bounds.matches(variable):
        what = f"{describe(bounds, article=True)}, but {to_text(Symbol(formula.variable))} is"
        bound = formula.lower if formula.upper == ZERO else formula.upper
        raise DimensionError(f"the bound {_say(bound)} is {what} {describe(variable, article=True)}")
    integrand = _dimension(formula.integrand, LetterDimensions(known))
    return None if integrand is None else integrand * variable
