"""The asked block: no law is written for what no question can depend on, and the answers are those of the whole scene."""

from __future__ import annotations

import re
from pathlib import Path
from time import process_time

import pytest
from msgspec.structs import replace

from rotsolve import SceneError, Unsolvable, pipeline, solve, solving
from rotsolve.derivation.drafts import drafts_of
from rotsolve.language.block import asked_block, left_out
from rotsolve.language.problem import Find, Problem
from rotsolve.scene.read import read_file, read_text
from rotsolve.search.search import Search

ROOT = Path(__file__).resolve().parents[2]
LANGUAGE = re.findall(r"^```yaml\n(.*?)^```$", (ROOT / "docs" / "language.md").read_text("utf-8"), re.M | re.S)
SCENES = {
    **{path.stem: path.read_text("utf-8") for path in sorted((ROOT / "tests" / "engine" / "scenes").glob("*.yaml"))},
    **{path.stem: path.read_text("utf-8") for path in sorted((ROOT / "problems").glob("*/*.yaml"))},
    **{f"language {number}": text for number, text in enumerate(LANGUAGE) if "find:" in text},
}


def page(number: int, *, more: str = "") -> str:
    """A page of so many scenes of a block on a disc; the first is asked."""
    rows = range(1, number + 1)
    bodies = "".join(
        f"  block{row}: {{mass: m, moves: down}}\n  disc{row}: {{shape: disc, mass: M, radius: R}}\n" for row in rows
    )
    joints = "".join(
        f"  axle{row}: {{axle: disc{row}}}\n  string{row}: {{string: [disc{row}, block{row}]}}\n" for row in rows
    )
    given = "given: {m: 2 kg, M: 5 kg, R: 0.2 m, k: 3 N/m}\n"
    return f"{given}bodies:\n{bodies}connections:\n{joints}find: {{a: block1.acceleration}}\n{more}"


def beside(text: str) -> list[str]:
    problem = read_text(text)
    return left_out(problem, asked_block(problem))


PAIR = """\
given: {{m: 2 kg, k: 8 N/m, v: 3 m/s, l: 1 m, mu: 0.1 {unknown}}}
surfaces: {{floor: level}}
bodies:
  one: {{mass: {one}, moves: right}}
  two: {{mass: m, moves: right}}
connections: {{left: {{contact: [one, floor], friction: mu}}, right: {{contact: [two, floor], friction: mu}}{more}}}
{rest}
"""


def pair(rest: str, *, one: str = "m", unknown: str = "", more: str = "") -> str:
    return PAIR.format(rest=rest, one=one, unknown=f", {unknown}: unknown" if unknown else "", more=more)


@pytest.mark.parametrize(
    ("text", "names"),
    [
        # one state: what is not tied is left out, also what lies on the same surface
        (pair("states: {now: {one.velocity: v, two.velocity: v}}\nfind: {a: one.acceleration}"), ["two"]),
        (pair("states: {now: {one.velocity: v, two.velocity: v}}\nfind: {a: one.acceleration + two.acceleration}"), []),
        # a connection, an action between bodies ties
        (
            pair("find: {a: one.acceleration}", more=", cord: {string: [one, two]}"),
            [],
        ),
        # an energy is one of all bodies
        (pair("states: {now: {one.velocity: v, two.velocity: v}}\nfind: {K: kinetic_energy}"), []),
        # the same unknown letter ties, also through what is made of it
        (
            pair("states: {now: {one.velocity: x, two.velocity: v}}\nfind: {a: one.acceleration, x: x}", unknown="x"),
            ["two"],
        ),
        (pair("states: {now: {one.velocity: x, two.velocity: x}}\nfind: {a: one.acceleration}", unknown="x"), []),
        (
            pair(
                "states: {now: {one.velocity: v, two.velocity: v}}\nfind: {a: one.acceleration}",
                one="m + x",
                unknown="x",
            ),
            ["two"],
        ),
        # what can tell how long it takes ties: lines of a later state, not those of the first
        (
            pair(
                "states: {start: {one.velocity: v, two.velocity: v}, end: {one.velocity: 0}}\nfind: {s: one.displacement from start to end}"
            ),
            ["two"],
        ),
        (
            pair(
                "states: {start: {one.velocity: v, two.velocity: 0}, end: {two.velocity: v}}\nfind: {s: one.displacement from start to end}"
            ),
            [],
        ),
        (
            pair(
                "states: {start: {one.velocity: v, two.velocity: v}, end: {at rest: all}}\nfind: {s: one.displacement from start to end}"
            ),
            [],
        ),
        (
            pair("states: {start: {at rest: all}, end: {one.displacement: l}}\nfind: {s: one.velocity at end}"),
            ["two"],
        ),
        # an event ties its bodies to the clock
        (
            pair(
                "states: {start: {one.velocity: v, two.velocity: v}, end: {}}\n"
                "events: {blow: {impulse: 2 N s, on: two, direction: right, from: start, to: end}}\nfind: {s: one.velocity at end}"
            ),
            [],
        ),
    ],
)
def test_what_is_left_out(text: str, names: list[str]) -> None:
    assert beside(text) == names


def questions(problem: Problem) -> list[Problem]:
    """The problem with one question at a time, where that leaves something out."""

    def alone(find: Find) -> Problem:
        return replace(problem, finds=(find,), answers=())

    return [part for part in map(alone, problem.finds) if asked_block(part) is not part]


def answers(problem: Problem) -> list[str]:
    try:
        return [str(answer) for answer in pipeline.solve_problem(problem, confirm=False).answers.values()]
    except (Unsolvable, SceneError) as error:
        return [str(error)]


@pytest.mark.exhaustive
def test_the_answers_are_those_of_the_whole_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each question of every scene that there is, alone: once with its block, once with all laws."""
    parts = [part for text in SCENES.values() for part in questions(read_text(text))]
    assert len(parts) > 50
    monkeypatch.setattr(
        pipeline, "refuse_idle", lambda solutions, problem: None
    )  # what is idle in one block may be in the whole
    by_block = [answers(part) for part in parts]
    monkeypatch.setattr(pipeline, "asked_block", lambda problem: problem)
    assert by_block == [answers(part) for part in parts]


def test_no_law_is_written_for_what_is_left_out() -> None:
    few, many = solve(page(1)), solve(page(50))
    assert many.derivation.equations_written == few.derivation.equations_written
    assert str(many).replace("block1", "block").replace("disc1", "disc") == str(few).replace("block1", "block").replace(
        "disc1", "disc"
    )
    assert "left out, since nothing that is asked depends on it: block2, disc2, block3" in many.facts_text()
    assert "block2" not in many.equations_text()


@pytest.mark.sampled(3)
@pytest.mark.parametrize("folder", sorted({path.parent.name for path in (ROOT / "problems").glob("*/*.yaml")}))
def test_no_step_is_derived_that_is_not_printed(folder: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Checks derive by searches of their own; that of the answers holds what the page shows."""
    searches: list[Search] = []
    composed = solving.composed
    monkeypatch.setattr(solving, "composed", lambda *given: searches.append(given[1]) or composed(*given))
    for path in sorted((ROOT / "problems" / folder).glob("*.yaml"))[:3]:
        solve(path)
        derived = {step.number for step in searches[-1].solver.steps}
        assert derived == {step.number for draft in drafts_of(searches[-1]) for step in draft.steps}, path.name


def test_friction_is_decided_only_where_it_is_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    from rotsolve.search import friction

    tried: list[str] = []
    real = friction.Trials.tried
    monkeypatch.setattr(friction.Trials, "tried", lambda *given: tried.append(given[2].name) or real(*given))
    solve(pair("actions: {pull: {force: 1 N, on: one, direction: right}}\nfind: {a: one.acceleration}"))
    assert tried == ["left"]


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ("actions: {push: {force: 2 N, on: blok2, direction: right}}\n", "unknown body or surface `blok2`"),
        ("actions: {push: {force: 2 N + 3 kg, on: block2, direction: right}}\n", "don't agree"),
        (
            "actions: {push: {force: k*disc2.displacement, on: block2, direction: right}}\n",
            "`disc2` does not travel along a line",
        ),
    ],
)
def test_faults_are_found_in_what_is_left_out_too(more: str, message: str) -> None:
    with pytest.raises((SceneError, Unsolvable)) as caught:
        solve(page(3, more=more))
    assert message in str(caught.value)


def test_a_page_of_a_hundred_scenes_takes_little_more_than_one_of_ten() -> None:
    small, large = read_text(page(10)), read_text(page(100))
    pipeline.solve_problem(small)

    def least(problem: Problem, *, confirm: bool) -> float:
        times = []
        for _ in range(5):
            start = process_time()
            pipeline.solve_problem(problem, confirm=confirm)
            times.append(process_time() - start)
        return min(times)

    assert least(large, confirm=False) < 3 * least(small, confirm=False)
    assert least(large, confirm=True) < 15 * least(
        small, confirm=True
    )  # the assembly is of all bodies: ten times as many


def test_reading_a_scene_of_one_block_costs_nothing() -> None:
    problem = read_file(ROOT / "problems" / "pulleys" / "atwood.yaml")
    assert asked_block(problem) is problem
