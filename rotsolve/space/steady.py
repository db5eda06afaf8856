"""Steady: which root of what a steady motion is asked for is meant: a tilt, a rate, or a letter of the scene.

Upright (sin θ = 0) a body does not precess, though the laws hold there: such a tilt is taken only where there is no other. Of several
others a question says by `smallest` or `largest` which it means; where none does, it is refused by name.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import PI, Formula, Symbol, add, call
from rotsolve.algebra.units.dimension import ANGLE, ANGULAR_VELOCITY
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import is_key, key_of
from rotsolve.language.limited import letters_of_places
from rotsolve.language.problem import EXTREMES
from rotsolve.solver.steps import PickedRoot

if TYPE_CHECKING:
    from rotsolve.equations.scene_equations import SceneEquations
    from rotsolve.search.numbers import Numbers

SMALL = 1e-9
TURN = 2 * PI
UPRIGHT = "upright it does not precess: sin θ ≠ 0"
SEVERAL = "several motions are possible, and nothing tells which is meant"
ONLY_UPRIGHT = "no tilt but upright or upside down is steady with these rates"
TAKES = "at a tilt between a top on a fixed point takes |M g l − I₃ ω₃ φ̇| < I₁ φ̇²: a faster precession, or another spin"
OF_LETTER = "write `smallest {name}` or `largest {name}`, one of them in a scene"
STABLE_ALONE = (
    "and among all with `angular_velocity: 0 rad/s, angular_acceleration: 0 rad/s` in place of `steady: true`"
)
OF_QUANTITY = "give it a letter, `x: unknown`, in the state, and ask for `smallest x` or `largest x`"


class Sought(Struct, frozen=True):
    """A letter that a steady motion is asked for: its name, the word of the question, and the tilts in which it stands."""

    name: str
    word: str
    tilts: tuple[Formula, ...]
    steady: bool
    size: bool  # whether it is taken as positive: a mass, a length or their like, and a place of which no extreme is asked
    help: str


def steady_letter(name: str, scene: SceneEquations) -> Sought | None:
    """What is asked of a steady motion under a name; None for what is not."""
    problem, states = scene.configuration.problem, scene.configuration.timeline.states
    tilts: tuple[Formula, ...]
    if is_key(name):
        key = key_of(name)
        steady = any(state.name == key.when and state.steady for state in states)
        tilts = (Symbol(name),) if key.kind == "tilt" else ()
        sought = key.kind in ("tilt", "spin", "axial_rate") and not key.component
        return Sought(name, "", tilts, True, False, OF_QUANTITY) if steady and sought else None
    given = next((given for given in problem.givens if given.name == name and given.asked), None)
    tilts = tilts_with(name, scene)
    steady = any(state.steady for state in states)
    if given is None or not (steady or tilts):
        return None
    finds = [find for find in problem.finds if find.formula == Symbol(name) and not find.terms]
    if any(find.where is not None for find in finds):
        return None  # the condition says which
    words = {find.modifier for find in finds}
    word = words.pop() if len(words) == 1 else ""
    rate = given.dimension is None or any(given.dimension.matches(kind) for kind in (ANGLE, ANGULAR_VELOCITY))
    by_value = rate or (word in EXTREMES and name in letters_of_places(problem))
    return Sought(name, word, tilts, steady, not by_value, OF_LETTER.format(name=name))


def tilts_with(name: str, scene: SceneEquations) -> tuple[Formula, ...]:
    """The tilts that states tell by a letter, which lie from 0 to 180°."""
    lines = (line for state in scene.configuration.timeline.states for line in state.conditions)
    return tuple(
        line.value
        for line in lines
        if line.path is not None and line.path.quantity == "tilt" and line.value is not None
        if name in line.value.symbols()
    )


def of_steady(
    sought: Sought, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers, period: Formula | None
) -> PickedRoot | None:
    """The root that is meant, with the reason; of an angle that between −180° and 180°. None where none of them is real."""
    round_ = period is not None and is_zero(period - TURN)
    turns = [turns_missing(root, numbers) if round_ else 0 for root in roots]
    picked = meant(sought, [root + TURN * turn for root, turn in zip(roots, turns, strict=True)], scene, numbers)
    return None if picked is None else replace(picked, turns=Fraction(turns[picked.root]))


def meant(sought: Sought, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers) -> PickedRoot | None:
    """Which root is meant, as they are."""
    left = [k for k, root in enumerate(roots) if numbers.of(root) is not None or lacks_numbers(root, numbers)]
    if sought.size:
        left = [k for k in left if numbers.side(roots[k]) in (1, None)] or left
    reasons, tilted = list[str](), list[int]()
    if sought.tilts:
        left = [k for k in left if possible_tilt(sought, roots[k], numbers)]
        tilted = [
            k
            for k in left
            if sought.steady and not all(upright(tilt, sought, roots[k], numbers) for tilt in sought.tilts)
        ]
        reasons += [UPRIGHT] if tilted and len(tilted) < len(left) else []
        left = tilted or left
    others: list[int] = []
    for k in left if sought.size else within_a_turn(roots, left, numbers):
        if all(numbers.side(roots[k] - roots[other]) != 0 for other in others):
            others.append(k)
    if not others:
        return None
    if len(others) == 1:
        return PickedRoot(others[0], (reasons[0],) if reasons else ())
    if not sought.word and differ_in_sign([roots[k] for k in others]):
        return None  # one motion seen from both sides: the ordinary choice is the positive one
    if sought.word not in EXTREMES and sought.steady and sought.tilts and not tilted:
        problem = scene.configuration.problem
        raise Unsolvable(ONLY_UPRIGHT, help=TAKES, lines=problem.lines, file=problem.file)
    stable = places_that_last(sought, [roots[k] for k in others], scene, numbers)
    if sought.word not in EXTREMES or any(lacks_numbers(roots[k], numbers) for k in others):
        raise several_motions(sought, [(roots[k], place in stable) for place, k in enumerate(others)], scene, numbers)
    left = [others[place] for place in stable] or others
    sign = -1 if sought.word == "largest" else 1
    index = left[numbers.least([sign * roots[k] for k in left])]
    among = f"of {len(stable)} stable ones among {len(others)}" if stable else f"of {len(others)}"
    only = f"the only stable one of {len(others)}"
    told = f"{only if len(stable) == 1 else f'the {sought.word} {among}'}: a body displaced from it comes back"
    return PickedRoot(index, (told if stable else f"the {sought.word} {among}",))


def places_that_last(sought: Sought, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers) -> list[int]:
    """Which of several angles on a hinge are such that a displaced body comes back; none where that is not looked at."""
    if is_key(sought.name) or not sought.steady or sought.tilts:
        return []
    from rotsolve.space.carried_swings import stable_places

    return stable_places(sought.name, roots, scene.dynamics, numbers)  # type: ignore[attr-defined]


def several_motions(
    sought: Sought, roots: Sequence[tuple[Formula, bool]], scene: SceneEquations, numbers: Numbers
) -> Unsolvable:
    """That several values fit, with which to choose; what is known of where a displaced body comes back is said."""
    problem = scene.configuration.problem
    find = next((find for find in problem.finds if find.formula == Symbol(sought.name) and not find.terms), None)
    help = sought.help
    if any(stable for _, stable in roots):
        help += f"; both look among the stable ones, {STABLE_ALONE}"
    return Unsolvable(
        SEVERAL, span=None if find is None else find.span, help=help, lines=problem.lines, file=problem.file
    )


def turns_missing(root: Formula, numbers: Numbers) -> int:
    """By how many whole turns an angle must be changed to lie between −180° and 180°; 0 where nothing tells."""
    return numbers.whole((PI - root) / TURN) or 0


def within_a_turn(roots: Sequence[Formula], left: Sequence[int], numbers: Numbers) -> list[int]:
    """Those of several roots, found numerically, that are not beyond ±180° and whole turns from another one, with which all is the same."""
    values = {k: value for k in left if (value := numbers.of(roots[k])) is not None}

    def again(value: float) -> bool:
        gaps = ((value - other) / (2 * math.pi) for other in values.values())
        return any(round(gap) and abs(gap - round(gap)) < SMALL for gap in gaps)

    return [k for k in left if k not in values or abs(values[k]) <= math.pi + SMALL or not again(values[k])]


def differ_in_sign(roots: Sequence[Formula]) -> bool:
    """Whether there are two roots that differ in their sign alone."""
    return len(roots) == 2 and is_zero(add(*roots))


def lacks_numbers(root: Formula, numbers: Numbers) -> bool:
    """Whether a root holds a letter without a number."""
    return not numbers.signs.trials.keys() >= set(numbers.signs.lacking(root))


def possible_tilt(sought: Sought, root: Formula, numbers: Numbers) -> bool:
    """Whether the tilts lie from 0 to 180° with a root, as far as numbers tell."""
    values = [numbers.of(tilt.substitute({sought.name: root})) for tilt in sought.tilts]
    return all(value is None or -SMALL < value < math.pi + SMALL for value in values)


def upright(tilt: Formula, sought: Sought, root: Formula, numbers: Numbers) -> bool:
    """Whether a tilt is 0 or 180° with a root."""
    found = simplify(call("sin", tilt.substitute({sought.name: root})))
    size = numbers.of(found)
    return size is not None and abs(size) < SMALL
