"""Bounds of motions that magnify what steps and roundings leave out, against references of 60 digits (benchmarks/precision/references)."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_source
from rotsolve.simulation import simulate
from rotsolve.simulation.bounded import ALONE, FLOAT_BITS, ROUNDED, Tolerances
from rotsolve.simulation.following import Follower

SCENES = Path(__file__).resolve().parents[2] / "benchmarks" / "scenes"
TWO_RODS = {  # after 10 s, in rad and rad/s
    "upper.angle": "-2.29473367222082739477728587090263906137",
    "lower.angle": "-15.9409442299723879621547028031723739562",
    "upper.angular_velocity": "-3.99402957459215939293046833005796696151",
    "lower.angular_velocity": "4.68501683389120544405002721357031426694",
}
BOOK = {  # spun at 5 rad/s about its middle axis, 10⁻¹⁰ of that off it, after 20 s
    "book.angular_velocity.x in body axes": "0.0000018527790756140762388024264738945461984605242",
    "book.angular_velocity.z in body axes": "0.00000106970245910305214442204500497265326427973188",
}
BETWEEN = (
    1e-12,
    3e-13,
    2e-13,
    1e-13,
    5e-14,
    3e-14,
    2e-14,
    1.5e-14,
    1e-14,
    5e-15,
    5e-16,
)  # from steps that count to roundings


@pytest.mark.parametrize("tolerance", BETWEEN)
def test_bounds_of_two_rods_hold(tolerance: float) -> None:
    """At 2e-14 a finer run that rounds on purpose agreed with the main one nine times better than that did with the truth."""
    scene = configured(read_source(SCENES / "two-rods.yaml"))
    (part,) = Follower(scene, 10.0, Tolerances(tolerance)).followed().regimes
    for item, ball in zip(part.system.variables, part.state(10.0), strict=True):
        assert abs(Fraction(float(ball.mid())) - Fraction(TWO_RODS[item.name])) <= Fraction(float(ball.rad())), (
            item.name
        )


def test_bounds_of_what_flips_hold() -> None:
    """Two runs of balls with the same bits once agreed by chance in roundings that the flip had magnified."""
    spin = {"wx": "5e-10 rad/s", "wy": "5 rad/s", "wz": "0 rad/s"}
    told = simulate(SCENES / "thrown-book.yaml", until="20 s", accuracy=5e-9, settings=spin).at(20.0)
    for name, exact in BOOK.items():
        value, bound = told[name]
        assert abs(Fraction(value) - Fraction(exact)) <= Fraction(bound), name


def test_one_run_tells_the_error_only_where_steps_leave_out_more_than_roundings() -> None:
    assert [len(Tolerances(main).ways) for main in (ALONE, ALONE / 2, ROUNDED, ROUNDED / 2)] == [2, 3, 3, 3]
    main, finer = Tolerances(1e-20, 120).ways
    assert finer.bits > main.bits == 120 > FLOAT_BITS
