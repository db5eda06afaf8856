"""Chains of hinged rods, two to ten, let go, at speeds and pushed, with all joint forces, against all bodies' equations at once."""

from __future__ import annotations

import random
import time

import numpy as np
import pytest

from linked import Bodies, direction
from rotsolve import Unsolvable, solve

G = 9.8
HOW = ("let go", "at speeds", "pushed", "pushed at speeds")


def chain(seed: int, count: int, how: str, *, hangs: bool, letters: bool = False) -> tuple[str, dict[str, float]]:
    """The scene of a random chain, and what is true of it."""
    dice, bodies = random.Random(seed), Bodies()
    lines, joints, state, asked, truth = [], [], [], [], dict[str, float]()
    end, speed, speeds = np.zeros(2), np.zeros(2), list[float]()
    for k in range(count):
        mass, length, angle = dice.randint(1, 5), dice.randint(3, 9) / 10, dice.randrange(0, 360, 5)
        spin = dice.randint(-4, 4) if "speeds" in how else 0
        way = direction(np.radians(angle))
        across = spin * np.array([-way[1], way[0]])
        bodies.add(f"r{k}", mass, mass * length**2 / 12, end + length / 2 * way)
        speeds += [*(speed + length / 2 * across), spin]
        lines.append(f"  r{k}: {{shape: rod, mass: {f'm{k}' if letters else f'{mass} kg'}, length: {length} m}}")
        if k or hangs:
            joints.append(f"  pin{k}: {{hinge: {f'[r{k - 1}.end, r{k}.start]' if k else 'r0.start'}}}")
            bodies.pin(f"pin{k}", end, f"r{k}", f"r{k - 1}" if k else "")
        state += [f"r{k}.angle: {angle} deg", f"r{k}.angular_velocity: {spin} rad/s"]
        end, speed = end + length * way, speed + length * across
    pushes = [(f"r{k}", bodies.places[k], np.array([0, -bodies.masses[k] * G if hangs else 0])) for k in range(count)]
    pushes += [(f"r{count - 1}", end, np.array([6.0, 0]))] if "pushed" in how else []
    rates, forces = bodies.moving(np.array(speeds), pushes)
    for k in range(count):
        truth[f"a{k}"] = rates[3 * k + 2]
        asked.append(f"  a{k}: r{k}.angular_acceleration at now")
    for name, value in forces.items():
        truth[name.replace(".", "_")] = value
        asked.append(f"  {name.replace('.', '_')}: {name.replace('.', '.force.')} at now")
    state += [] if hangs else ["r0.velocity: [{:.15g} m/s, {:.15g} m/s]".format(*speeds[:2])]
    newline = "\n"
    return (
        f"""title: Rods
plane: {"vertical" if hangs else "horizontal"}
given: {{{", ".join(f"m{k}: kg" for k in range(count)) if letters else "F: 6 N"}}}
bodies:
{newline.join(lines)}
connections:
{newline.join(joints)}
actions: {{{f"push: {{force: 6 N, on: r{count - 1}.end, direction: right}}" if "pushed" in how else ""}}}
states: {{now: {{{", ".join(state)}}}}}
find:
{newline.join(asked)}
""",
        truth,
    )


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("count", "how", "hangs"),
    [  # two and three rods in every way; of longer chains each either hangs or lies on ice, the next one the other way round
        (count, how, hangs)
        for place, count in enumerate((2, 3, 4, 6, 10))
        for at, how in enumerate(HOW)
        for hangs in (True, False)
        if count < 4 or hangs == ((place + at) % 2 == 0)
    ],
)
def test_accelerations_and_all_joint_forces(count: int, how: str, hangs: bool) -> None:
    scene, truth = chain(10 * count + HOW.index(how), count, how, hangs=hangs)
    answers = solve(scene, confirm=False).answers
    assert {name: answers[name].float for name in truth} == pytest.approx(truth, rel=1e-9, abs=1e-9)


def test_the_cost_grows_like_the_links() -> None:
    """Twenty rods take some four times as long as five: each of them has as many equations as the next."""
    times = {}
    for count in (5, 20):
        scene, _ = chain(count, count, "at speeds", hangs=True)
        start = time.process_time()
        solve(scene)
        times[count] = time.process_time() - start
    assert times[20] < 16 * times[5]


def test_what_no_page_holds_in_letters_is_refused_by_name() -> None:
    """Letters without a number: the refusal says so, and which of them want one."""
    scene, _ = chain(1, 4, "let go", hangs=True, letters=True)
    with pytest.raises(Unsolvable, match="too long to print in letters") as refused:
        solve(scene)
    assert "`m0`" in str(refused.value)


def test_the_derivation_says_that_numbers_were_put_in() -> None:
    scene, _ = chain(1, 4, "let go", hangs=True)
    assert "too long to print in letters: solved together with the numbers" in " ".join(solve(scene).to().split())
