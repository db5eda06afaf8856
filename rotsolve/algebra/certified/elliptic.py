"""Elliptic functions of Jacobi, the incomplete integral F and the complete Π of the third kind over real balls, of a parameter m = k² from
0 to 1.

sn u = sin am u, cn u = cos am u, dn u = √(1 − m sn² u), where u = F(am u, m) = ∫ dx/√(1 − m sin² x) from 0 to am u
(Landau & Lifshitz, Mechanics, §37; by theta functions of z = u/(2 K) and τ = i K(1 − m)/K(m): NIST Handbook, 22.2).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
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
    quarter, other = acb(m).elliptic_k().real, acb(1 - m).elliptic_k().real
    z, tau = u / (2 * quarter), acb(0, other / quarter)
    if not z.is_finite():
        return arb.nan()
    z -= 2 * arb((z.mid() / 2 + 0.5).floor().mid())  # all three have the period 4 K
    _, *still = (part.real for part in acb(0).modular_theta(tau))
    moved = [part.real for part in acb(z).modular_theta(tau)]
    above, below, which = {
        "ellipsn": (still[1], still[0], 0),
        "ellipcn": (still[2], still[0], 1),
        "ellipdn": (still[2], still[1], 2),
    }[function]
    return above / below * moved[which] / moved[3]


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


TWO_ARGUMENTS: Mapping[str, Callable[[Ball, Ball], Ball]] = {
    "ellipsn": lambda u, m: jacobi("ellipsn", u, m),
    "ellipcn": lambda u, m: jacobi("ellipcn", u, m),
    "ellipdn": lambda u, m: jacobi("ellipdn", u, m),
    "ellipf": first_kind,
    "ellippi": third_kind,
}


def elliptic_float(function: str, x: float, m: float = 0.0) -> float:
    """One of these functions, or K(x), of floats; ValueError where it has no value."""
    if function == "ellipk":
        found = acb(x).elliptic_k().real if x < 1 else arb.nan()
    else:
        found = TWO_ARGUMENTS[function](arb(x), arb(m)) if 0 <= m <= 1 else arb.nan()
    if not found.is_finite():
        raise ValueError(f"no value of {function}")
    return float(found.mid())
