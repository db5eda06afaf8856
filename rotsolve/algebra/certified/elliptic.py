"""Elliptic functions of Jacobi, the incomplete integral F and those of the third kind Π over real balls, of a parameter m = k² from 0 to 1.

sn u = sin am u, cn u = cos am u, dn u = √(1 − m sn² u), where u = F(am u, m) = ∫ dx/√(1 − m sin² x) from 0 to am u
(Landau & Lifshitz, Mechanics, §37; by theta functions of z = u/(2 K) and τ = i K(1 − m)/K(m): NIST Handbook, 22.2).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from rotsolve.algebra.flints import acb, arb

Ball = Any  # flint's arb


def jacobi(function: str, u: Ball, m: Ball) -> Ball:
    """sn, cn or dn of u with the parameter m; no number where the ball of m goes beyond 0 or 1.

    At m = 0 these are sin u, cos u and 1, at m = 1 tanh u, 1/cosh u and 1/cosh u.
    """
    if m.is_zero():
        return {"ellipsn": u.sin, "ellipcn": u.cos, "ellipdn": lambda: arb(1)}[function]()
    if (1 - m).is_zero():
        return u.tanh() if function == "ellipsn" else u.sech()
    if not 0 < m < 1:
        return arb.nan()
    quarter = acb(m).elliptic_k().real
    z = u / (2 * quarter)
    if not z.is_finite():
        return arb.nan()
    z -= 2 * nearest_whole(z / 2)  # all three have the period 4 K
    return by_thetas((function,), z, m, quarter)[0]


def by_thetas(functions: tuple[str, ...], z: Ball, m: Ball, quarter: Ball) -> list[Ball]:
    """Some of sn, cn and dn of u = 2 K z, K being a quarter of the period."""
    tau = acb(0, acb(1 - m).elliptic_k().real / quarter)
    _, *still = (part.real for part in acb(0).modular_theta(tau))
    moved = [part.real for part in acb(z).modular_theta(tau)]
    shares = {
        "ellipsn": (still[1], still[0], 0),
        "ellipcn": (still[2], still[0], 1),
        "ellipdn": (still[2], still[1], 2),
    }
    return [above / below * moved[which] / moved[3] for above, below, which in map(shares.__getitem__, functions)]


def nearest_whole(x: Ball) -> Ball:
    """A whole number beside the middle of a ball."""
    return arb((x.mid() + 0.5).floor().mid())


def amplitude(u: Ball, m: Ball) -> Ball:
    """am u, by am(u + 2 k K) = am u + k π within two quarters of the period; at m = 0 u, at m = 1 arctan sinh u."""
    if m.is_zero():
        return u
    if (1 - m).is_zero():
        return u.sinh().atan()
    if not 0 < m < 1:
        return arb.nan()
    quarter = acb(m).elliptic_k().real
    z = u / (2 * quarter)
    if not z.is_finite():
        return arb.nan()
    halves = nearest_whole(z)
    rest = z - halves
    if not abs(rest) < 1:  # beyond, the heading below would be that of another turn
        return arb.nan()
    sine, cosine = by_thetas(("ellipsn", "ellipcn"), rest, m, quarter)
    return halves * arb.pi() + arb.atan2(sine, cosine)


def first_kind(phi: Ball, m: Ball) -> Ball:
    """F(φ, m) = ∫ dx/√(1 − m sin² x) from 0 to φ, of any φ; at m = 1 artanh sin φ, up to a quarter turn."""
    if m.is_zero():
        return phi
    if (1 - m).is_zero():
        return phi.sin().atanh() if abs(phi) < arb.pi() / 2 else arb.nan()
    return acb.elliptic_f(acb(phi), acb(m)).real if m < 1 else arb.nan()


def third_kind(n: Ball, m: Ball) -> Ball:
    """Π(n, m) = ∫ dx/((1 − n sin² x) √(1 − m sin² x)) over a quarter turn; no number for n or m of 1 and more."""
    return acb.elliptic_pi(acb(n), acb(m)).real if n < 1 and m < 1 else arb.nan()


def third_kind_up_to(n: Ball, phi: Ball, m: Ball) -> Ball:
    """Π(n, φ, m), the same from 0 to any φ: Π(n, φ + k π, m) = Π(n, φ, m) + 2 k Π(n, m).

    Within a quarter turn by Carlson's integrals (NIST Handbook, 19.25.14); about one by the rule of the mean.
    """
    if not (n < 1 and m < 1 and phi.is_finite()):
        return arb.nan()
    halves, quarter = nearest_whole(phi / arb.pi()), arb.pi() / 2
    rest = phi - halves * arb.pi()
    whole = third_kind(n, m) if not halves.is_zero() or not abs(rest) <= quarter else arb(0)
    if abs(rest) <= quarter:
        return 2 * halves * whole + by_carlson(n, rest, m)
    end, sign = (quarter, 1) if rest.mid() > 0 else (-quarter, -1)
    sine = rest.union(end).sin()
    square = sine * sine
    return (2 * halves + sign) * whole + (rest - end) / ((1 - n * square) * (1 - m * square).sqrt())


def by_carlson(n: Ball, phi: Ball, m: Ball) -> Ball:
    """s R_F(c², 1 − m s², 1) + ⅓ n s³ R_J(c², 1 − m s², 1, 1 − n s²) with s = sin φ and c = cos φ, within a quarter turn."""
    sine, cosine = phi.sin(), phi.cos()
    square = sine * sine
    above, below = acb((cosine * cosine).nonnegative_part()), acb(1 - m * square)
    first = acb.elliptic_rf(above, below, 1).real
    return sine * (first + n * square / 3 * acb.elliptic_rj(above, below, 1, acb(1 - n * square)).real)


OF_PARAMETER: Mapping[str, Callable[..., Ball]] = {  # their last argument is m
    **{name: partial(jacobi, name) for name in ("ellipsn", "ellipcn", "ellipdn")},
    "ellipam": amplitude,
    "ellipf": first_kind,
    "ellippi": third_kind,
    "ellippiinc": third_kind_up_to,
}


def elliptic_float(function: str, *arguments: float) -> float:
    """One of these functions, or K(m), of floats, the last of which is m; ValueError where it has no value."""
    *first, m = map(arb, arguments)
    if function == "ellipk":
        found = acb(m).elliptic_k().real if m < 1 else arb.nan()
    else:
        found = OF_PARAMETER[function](*first, m) if 0 <= m <= 1 else arb.nan()
    if not found.is_finite():
        raise ValueError(f"no value of {function}")
    return float(found.mid())
