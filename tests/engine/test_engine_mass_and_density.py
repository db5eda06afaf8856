"""A mass beside a density: it tells what else of the body has no number, or is refused by name where nothing is left to tell."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

GIVEN = "given: {M: 5 kg, R: 30 cm, k: unknown, h: 2 cm, rho: 7800 kg/m^3, a: 40 kg/m^2}\n"


@pytest.mark.parametrize(
    ("body", "find", "number"),
    [
        ("{shape: disc, radius: R, mass: M, density: k*r}", "body.inertia", 3 / 5 * 5 * 0.3**2),
        ("{shape: disc, radius: R, mass: M, density: k*r}", "k", 3 * 5 / (2 * math.pi * 0.3**3)),
        ("{shape: disc, radius: R, mass: M, density: a + k*r}", "k", (5 / math.pi / 0.09 - 40) / 0.2),
        ("{shape: rod, length: R, mass: M, density: k*x^2}", "body.inertia about body.start", 3 / 5 * 5 * 0.3**2),
        ("{shape: sphere, radius: R, mass: M, density: k}", "k", 5 / (4 / 3 * math.pi * 0.3**3)),
        ("{shape: cylinder, length: h, mass: M, density: rho}", "body.inertia", 5**2 / (2 * math.pi * 7800 * 0.02)),
        ("{shape: cylinder, radius: R, mass: M, density: rho}", "body.length", 5 / (7800 * math.pi * 0.09)),
        ("{shape: cylinder, radius: unknown, length: h, mass: M, density: rho}", "body.radius", 0.1010061),
        ("{shape: disc, radius: R, mass: unknown, density: a}", "body.mass", 40 * math.pi * 0.09),
    ],
)
def test_it_tells_what_is_left(body: str, find: str, number: float) -> None:
    given = GIVEN if "k" in find + body else GIVEN.replace("k: unknown, ", "")
    name = "k" if find == "k" else "x"
    solution = solve(f"title: Told twice\n{given}bodies: {{body: {body}}}\nfind: {{{name}: {find}}}\n")
    assert float(solution.answers[name].value) == pytest.approx(number, rel=1e-3)
    assert "confirmed with numbers" in solution.to("text")


def test_letters_without_numbers_give_the_moment_by_the_mass() -> None:
    scene = (
        "title: t\ngiven: {M: kg, R: m, k: kg/m^3}\nbodies: {wheel: {shape: disc, radius: R, mass: M, density: k*r}}\n"
    )
    answer = solve(scene + "find: {I: wheel.inertia}\n").answers["I"]
    assert str(answer.exact) == "⅗ M R²"


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("{shape: cylinder, radius: R, length: h, mass: M, density: rho}", "nothing is left that they tell"),
        ("{shape: cylinder, mass: M, density: rho}", "they tell one of `radius`, `length`, and not which"),
        (
            "{shape: disc, radius: R, mass: M, density: a, holes: {gap: {shape: disc, radius: h}}}",
            "has both `mass` and",
        ),
        ("{parts: {p: {shape: disc, radius: R, mass: M, density: a}}}", "`p` has both `mass` and `density`"),
    ],
)
def test_it_is_refused_where_nothing_or_too_much_is_left(body: str, message: str) -> None:
    given = GIVEN.replace("k: unknown, ", "")
    with pytest.raises(SceneError, match=message):
        solve(f"title: t\n{given}bodies: {{body: {body}}}\nfind: {{x: body.inertia}}\n")


def test_two_bodies_of_one_density_contradict_each_other() -> None:
    bodies = "{one: {shape: rod, mass: M, density: k, length: R}, two: {shape: rod, mass: 2*M, density: k, length: R}}"
    with pytest.raises(Unsolvable, match="contradict each other"):
        solve(f"title: t\n{GIVEN}bodies: {bodies}\nfind: {{I: one.inertia, J: two.inertia, k: k}}\n")


def test_a_density_that_would_be_negative_is_none() -> None:
    given = GIVEN.replace("M: 5 kg", "M: 3 kg").replace("a: 40", "a: 36")
    with pytest.raises(Unsolvable, match="its density would be negative somewhere"):
        solve(
            f"title: t\n{given}bodies: {{b: {{shape: disc, radius: R, mass: M, density: a + k*r}}}}\nfind: {{k: k}}\n"
        )


@pytest.mark.parametrize(
    ("told", "said"),
    [("density: q*r", "stands for several alike"), ("mass: 5 kg, density: q", "has both `mass` and `density`")],
)
def test_what_stands_for_several_alike_has_one_of_both(told: str, said: str) -> None:
    """The mass would be that of each, its density that of one or of all."""
    body = f"{{shape: disc, radius: R, count: 2, {told}}}"
    text = f"title: t\ngiven: {{R: 20 cm, q: 300 kg/m^3}}\nbodies: {{two: {body}}}\nfind: {{x: two.inertia}}\n"
    with pytest.raises(SceneError, match=said):
        solve(text)
