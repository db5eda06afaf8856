"""Python as its users know it: answers by name and as numbers, SymPy's symbols, settings, dicts, copies, notebooks, errors, types."""

from __future__ import annotations

import copy
import pickle
import re
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction
from html.parser import HTMLParser
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from pebble import ProcessPool

import rotsolve
from rotsolve import HandedInError, RotsolveError, Run, SceneError, Solution, Unsolvable, check, simulate, solve

ROOT = Path(__file__).resolve().parent.parent
DISC = ROOT / "problems" / "pulleys" / "block-on-disc.yaml"
ROD = ROOT / "problems" / "hinged" / "rod-30.yaml"
SCENE: dict[str, Any] = {
    "title": "Block on a disc",
    "given": {"m": "2 kg", "I": "0.1 kg m^2", "R": "20 cm", "mu": "number", "L": "2*R", "beta": "30 deg"},
    "bodies": {"block": {"mass": "m", "moves": "down"}, "disc": {"inertia": "I", "radius": "R", "turns": "clockwise"}},
    "connections": {"axle": {"axle": "disc"}, "string": {"string": ["disc", "block"]}},
    "find": {"a": "block.acceleration", "k": "block.acceleration*mu/L*sin(beta)"},
}


def scene(**given: str) -> dict[str, Any]:
    """The scene with these givens alone beside its masses and its radius."""
    kept = {name: SCENE["given"][name] for name in ("m", "I", "R")}
    return {**SCENE, "given": {**kept, **given}, "find": {"a": "block.acceleration"}}


@pytest.fixture(scope="module")
def solution() -> Solution:
    return solve(DISC)


@pytest.fixture(scope="module")
def run() -> Run:
    return simulate(ROD, "1 s")


def test_answers_are_taken_by_their_names(solution: Solution) -> None:
    assert solution["α"] is solution["alpha"] is solution.answers["alpha"]
    assert list(solution) == list(solution.keys()) == list(dict(solution.items())) == ["a", "alpha", "T"]
    assert len(solution) == 3 and "a" in solution and "b" not in solution
    with pytest.raises(KeyError, match="nothing is asked by the name `aplha`: did you mean `alpha`"):
        solution["aplha"]


def test_a_question_without_an_answer_raises_its_reason() -> None:
    states = {"start": "at rest", "end": {}}
    asked = {"a": "block.acceleration", "t": "time from start to end"}
    partly = solve(scene() | {"states": states, "find": asked})
    assert "a" in partly and "t" not in partly
    with pytest.raises(Unsolvable) as reason:
        partly["t"]
    assert reason.value is partly.refused["t"] and reason.value.line


def test_answers_are_numbers(solution: Solution) -> None:
    a = solution["a"]
    assert float(a) == a.float == pytest.approx(196 / 45, rel=1e-15)
    assert (f"{a:.2f}", f"{a}") == ("4.36", str(a))
    assert np.asarray(list(solution.values()), dtype=float).tolist() == [float(one) for one in solution.values()]
    assert a.certified(30) == "4.35555555555555555555555555556"
    assert (a.in_unit("cm/s^2"), a.si) == (pytest.approx(43560 / 100 - 4 / 90), pytest.approx(196 / 45))
    with pytest.raises(ValueError, match="`kg` is no unit of `a`, which is an acceleration"):
        a.in_unit("kg")


def test_what_is_no_number_says_what_it_is() -> None:
    letters = solve(scene(m="kg", I="kg m^2", R="m"))
    with pytest.raises(TypeError, match="`a` has no number, since letters have none"):
        float(letters["a"])
    choice = solve(ROOT / "problems" / "space" / "stability-of-three-axes.yaml")
    with pytest.raises(TypeError, match="no number but a word"):
        float(choice["unstable"])
    tensor = next(
        view for view in solve(ROOT / "problems" / "space" / "plate-diagonal.yaml").values() if view.answer.rows
    )
    with pytest.raises(TypeError, match=r"take one of its parts, \['x'\]"):
        float(tensor)
    assert float(tensor["x"]) == tensor.components["x"].float
    with pytest.raises(KeyError, match="has no part `q`"):
        tensor["q"]


def test_other_units_are_those_of_the_same_kind() -> None:
    rolled = solve(ROD)
    assert rolled["omega"].in_unit("rev/s") == pytest.approx(float(rolled["omega"]) / 2 / np.pi)
    assert rolled["I"].in_unit("kg cm^2") == pytest.approx(1e4 * float(rolled["I"]))


# SymPy


def test_symbols_are_the_plain_ones(solution: Solution) -> None:
    a = solution["a"]
    m, M, g = sympy.symbols("m M g")
    assert a.sympy == 2 * m * g / (2 * m + M)
    assert solution.symbols["m"] == solution.symbols.m == m
    assert a.sympy.subs({"m": 2}) == a.sympy.subs(m, 2) == a.sympy.subs(solution.symbols.m, 2) == a.subs(m=2)
    assert set(solution.symbols) == {"m", "M", "R", "g"}
    for wrong in (lambda: solution.symbols["q"], lambda: a.subs(q=1)):
        with pytest.raises(KeyError, match="no letter `q`: letters: m, M, R, g"):
            wrong()
    with pytest.raises(AttributeError, match="no letter `q`"):
        _ = solution.symbols.q


def test_names_that_sympy_reads_otherwise_are_letters() -> None:
    """SymPy takes the text I for √−1; `answer.subs` and the symbol itself do not."""
    a = solve(scene())["a"]
    m, inertia, R, g = (solve(scene()).symbols[name] for name in ("m", "I", "R", "g"))
    assert a.subs(I=0) == a.subs({"I": 0}) == a.sympy.subs(inertia, 0) == g
    assert sympy.simplify(a.sympy - m * g * R**2 / (m * R**2 + inertia)) == 0


def test_values_are_put_in_at_once(solution: Solution) -> None:
    m, M = solution.symbols.m, solution.symbols.M
    assert solution["a"].subs(m=M, M=m) == 2 * M * solution.symbols.g / (2 * M + m)


def test_symbols_with_what_the_scene_knows(solution: Solution) -> None:
    known = solution.symbols.assumed
    assert all(known[name].is_positive for name in "mMR")
    assert solution["a"].subs(known).is_positive
    assert sympy.limit(solution["a"].subs(known), known["M"], sympy.oo) == 0


@pytest.mark.sampled(6)
@pytest.mark.parametrize("path", sorted((ROOT / "problems").glob("*/*.yaml")), ids=lambda path: path.stem)
def test_what_sympy_says_is_what_is_printed(path: Path) -> None:
    found = solve(path, confirm=False)
    known = {
        name: value for name, value in ((item.name, item.value) for item in found.problem.givens) if value is not None
    }
    from rotsolve.algebra.certified.ball import evaluate

    numbers = {name: evaluate(value, known, digits=30).ball.str(25, radius=False) for name, value in known.items()}
    for view in found.values():
        if view.float is None or view.sympy is None or view.sympy.has(sympy.Integral):
            continue
        if view.sympy.free_symbols <= {sympy.Symbol(name) for name in known} and "ellip" not in str(view.sympy):
            worth = view.subs({name: sympy.Float(text, 25) for name, text in numbers.items()}).evalf(20)
            assert float(worth) == pytest.approx(view.si, rel=1e-9, abs=1e-12), view.name


# scenes and settings


def test_a_dict_is_a_scene() -> None:
    assert solve(scene())["a"] == solve(scene(m=2, I=Fraction(1, 10)) | {"given": scene()["given"]})["a"]
    numbers = scene() | {
        "bodies": {**SCENE["bodies"], "disc": {"inertia": "I", "radius": "R", "at": [np.float64(0), 0]}}
    }
    with pytest.raises(SceneError) as error:
        solve(numbers)
    assert (error.value.file, error.value.line is not None) == ("<dict>", True)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"given": {"m": object()}}, "this dict holds a value of the kind `object`"),
        ({}, "the scene has no `find`"),
        ({"find": {"a": {1, 2}}}, "error: "),
    ],
)
def test_a_dict_that_is_none_is_refused(wrong: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        solve(wrong)
    round_about: dict[str, Any] = {"find": {}}
    round_about["find"]["x"] = round_about
    with pytest.raises(SceneError, match="this dict holds itself"):
        solve(round_about)


@pytest.mark.parametrize("mass", [3, 3.0, np.float64(3), np.int64(3), Fraction(3), Decimal("3.0"), "3 kg", "3000 g"])
def test_numbers_have_the_unit_of_the_scene(mass: object) -> None:
    assert solve(scene(), settings={"m": mass})["a"] == solve(scene(m="3 kg"))["a"]


@pytest.mark.parametrize(
    ("letter", "number", "words"),
    [
        ("R", 0.2, '--set R: 0.2 may be in cm, as in the file, or in m\n.*\nhelp: write "0.2 cm" or "0.2 m"'),
        ("beta", 30, '--set beta: 30 may be in °, as in the file, or in rad\n.*\nhelp: write "30 °" or "30 rad"'),
        ("L", 1.5, "--set L: the number 1.5 has no unit\n.*\nhelp: write a text with its unit"),
        ("m", True, "--set m: `True` is no value"),
        ("m", float("nan"), "--set m: `nan` is no value"),
        ("m", [1], r"--set m: `\[1\]` is no value"),
        ("q", 1, "--set `q`: no such given"),
        ("m", -1, "`mass` can't be negative"),
    ],
)
def test_a_number_that_may_mean_several_things_is_refused(letter: str, number: object, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        solve(SCENE, settings={letter: number})
    assert solve(SCENE, settings={"mu": 0.3})["k"].float


def test_a_problem_is_solved_with_other_settings() -> None:
    problem = rotsolve.read(scene(), settings={"m": 3})
    assert rotsolve.read(problem) is problem
    again = solve(problem, settings={"I": 0.2})
    assert again["a"] == solve(scene(m="3 kg", I="0.2 kg m^2"))["a"]
    assert again.evaluate_many({"R": [0.2]})["a"][0] == pytest.approx(float(again["a"]))


# copies


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda item: pickle.loads(pickle.dumps(item))])
def test_what_is_copied_says_the_same(copied: Any, solution: Solution, run: Run) -> None:
    again = copied(solution)
    assert again == solution and hash(again) == hash(solution) and again["a"] == solution["a"]
    assert str(again) == str(solution) and again["a"].certified(40) == solution["a"].certified(40)
    assert again.facts_text() == solution.facts_text()
    assert again.evaluate_many({"m": [1.0]})["a"][0] == pytest.approx(2.8)
    assert copied(solution["a"]) == solution["a"] and copied(solution.problem) == solution.problem
    moved = copied(run)
    assert moved == run and hash(moved) == hash(run) and moved.at(0.3) == run.at(0.3) and str(moved) == str(run)
    marked = copied(check(DISC, {"a": "4.36 m/s^2"}))
    assert marked["a"].right
    many = copied(solution.evaluate_many({"m": [1.0, -1.0]}))
    assert many.reasons["a"][1] and many.units["a"] == "m/s²"


@pytest.mark.sampled(5)
@pytest.mark.parametrize("path", sorted((ROOT / "problems").glob("*/*.yaml")), ids=lambda path: path.stem)
def test_the_solution_of_every_problem_can_be_pickled(path: Path) -> None:
    """Numbers without a closed form too, with the means to know them better."""
    found = solve(path, confirm=False)
    again = pickle.loads(pickle.dumps(found))
    assert again == found and again.to("text") == found.to("text")
    assert [view.certified(18) for view in again.values()] == [view.certified(18) for view in found.values()]


def test_equal_are_those_that_say_the_same(solution: Solution) -> None:
    other = solve(DISC, settings={"m": 3})
    assert solution == solve(DISC) != other and solution != "a"
    assert len({solution, solve(DISC), other}) == 2
    assert {solution["T"], solve(DISC)["T"], other["T"]} == {solution["T"], other["T"]}
    assert solve(DISC, digits=6)["a"] != solution["a"]


def acceleration(source: Any) -> Any:
    """What another process does."""
    return solve(source, settings={"m": 1})


def test_solutions_and_errors_come_back_from_other_processes(solution: Solution) -> None:
    with ProcessPool(1, context=get_context("spawn")) as pool:
        found = pool.schedule(acceleration, args=[solution.problem]).result()
        assert found["a"] == solve(DISC, settings={"m": 1})["a"]
        with pytest.raises(SceneError) as error:
            pool.schedule(acceleration, args=[{"find": {"a": "b"}}]).result()
    assert error.value.file == "<dict>" and error.value.faults


# errors


def raised(work: Any) -> RotsolveError:
    with pytest.raises(RotsolveError) as error:
        work()
    return error.value


ERRORS = {
    "SceneError": lambda: solve(scene() | {"find": {"a": "block.aceleration"}}),
    "Unsolvable": lambda: solve(scene() | {"find": {"a": "disc.kinetic_energy"}}),
    "NotForMany": lambda: solve(DISC).evaluate_many({"q": [1]}),
    "HandedInError": lambda: check(DISC, {"b": 1}),
    "NotMarked": lambda: check(DISC, {"a": 1}, variant=3),
}


@pytest.mark.parametrize("name", ERRORS)
def test_errors_have_names_and_places(name: str) -> None:
    error = raised(ERRORS[name])
    assert isinstance(error, getattr(rotsolve, name))
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.line, again.help) == (type(error), str(error), error.line, error.help)
    assert error.message in str(error)
    if name in ("SceneError", "Unsolvable", "HandedInError"):
        assert error.file == "<dict>" and error.line and error.column
        assert f"<dict>:{error.line}:{error.column}" in str(error)


@pytest.mark.parametrize(
    ("package", "use", "extra"),
    [
        ("pandas", lambda run: run.to_frame(), "frames"),
        ("pandas", lambda run: solve(DISC).to_frame(), "frames"),
        ("matplotlib.figure", lambda run: run.plot(), "plot"),
        ("numpy", lambda run: run.at([0.1]), "arrays"),
    ],
)
def test_what_is_missing_is_named(
    package: str, use: Any, extra: str, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    from rotsolve.simulation import plot

    plot.figure_kind.cache_clear()
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(rotsolve.MissingPackage, match=re.escape(f"pip install 'rotsolve[{extra}]'")) as error:
        use(run)
    assert isinstance(error.value, ModuleNotFoundError)


# tables, curves, checking


def test_answers_are_a_table(solution: Solution) -> None:
    table = solution.to_frame()
    assert list(table.index) == ["a", "alpha", "T"] and list(table["unit"]) == ["m/s²", "rad/s²", "N"]
    assert table.loc["a", "value"] == float(solution["a"]) and table.loc["a", "exact"] == "2 m g/(2 m + M)"
    parts = solve(ROOT / "problems" / "space" / "plate-diagonal.yaml").to_frame()
    assert any("." in name for name in parts.index)


def test_a_run_is_read_at_many_times(run: Run) -> None:
    times = np.array([[0.0, 0.25], [0.5, 1.0]])
    found = run.at(times, "rod.angle")
    assert list(found) == ["rod.angle"]
    for place, time in np.ndenumerate(times):
        assert (found["rod.angle"][0][place], found["rod.angle"][1][place]) == run.at(float(time))["rod.angle"]
    assert run.at(np.int64(1)) == run.at(1) == run.at("1 s")
    assert set(run.at(0, "forces")) == {"pivot.force.x", "pivot.force.y"}
    for wrong in ([0.0, 2.0], 2.0, -1, float("nan")):
        with pytest.raises(ValueError, match="was followed from 0 to 1 s"):
            run.at(wrong)
    with pytest.raises(Unsolvable, match=r"the motion tells no `rod\.foo`"):
        run.at(0, "rod.foo")


def test_what_has_no_value_at_some_times_is_marked() -> None:
    """The grip's friction is told while it slips as when it rolls; what begins later has no number before."""
    ball = simulate(ROOT / "problems" / "rolling" / "bowling-ball.yaml", "2 s")
    found = ball.at([0.1, 1.9])
    assert set(found) == set(ball.told)
    for values, bounds in found.values():
        assert np.array_equal(np.isnan(values), np.isinf(bounds))


def test_a_run_is_a_table(run: Run) -> None:
    table = run.to_frame(5, "rod", bounds=True)
    assert table.index.name == "t" and list(table.index) == [0, 0.25, 0.5, 0.75, 1]
    value, bound = run.at(0.25)["rod.angle"]
    assert (table.loc[0.25, "rod.angle"], table.loc[0.25, "rod.angle bound"]) == (value, bound)
    assert len(run.to_frame()) == 101 and list(run.to_frame([0.5]).columns) == ["rod.angle", "rod.angular_velocity"]


def test_a_run_is_drawn(run: Run, tmp_path: Path) -> None:
    figure = run.plot(["motion", "forces"], tmp_path / "rod.svg")
    assert len(figure.axes) == 3
    shown = figure._repr_svg_()
    assert shown.startswith("<?xml") and "<script" not in shown and not re.search("https?://(?!www.w3.org)", shown)
    assert (tmp_path / "rod.svg").read_text(encoding="utf-8").count("<svg") == 1


def test_a_students_answers_are_checked(solution: Solution) -> None:
    told = {"a": "2 m g/(2 m + M)", "α": 21.78, "working": ["T R = I alpha", "a = g"]}
    marked = check(solution, told)
    assert [one.outcome for one in marked.verdicts.values()] == ["right", "partly right", "no answer"]
    assert marked["alpha"].remarks == ("the unit is missing: rad/s²",) and marked["T"].text == ""
    assert (marked.right, marked.marks, marked.of, len(marked)) == (False, 1.75, 3.0, 3)
    assert [line.right for line in marked.working] == [True, False]
    assert "1.75 of 3" in str(marked) and list(marked.to_frame()["marks"]) == [1.0, 0.75, 0.0]
    text = "a = 4.356 m/s^2\nalpha = 21.78 rad/s^2\nT = 10.89 N"
    assert check(DISC, text).right and check(DISC, "a = 4.356 m/s^2")["a"].right


def test_answers_of_a_file_and_of_a_variant_are_checked(tmp_path: Path) -> None:
    (tmp_path / "ada.txt").write_text("a = 1.4 m/s^2\n", encoding="utf-8")
    atwood = ROOT / "problems" / "pulleys" / "atwood.yaml"
    assert check(atwood, tmp_path / "ada.txt")["a"].right
    assert not check(atwood, tmp_path / "ada.txt", variant=1)["a"].right
    with pytest.raises(HandedInError, match="which answer is this"):
        check(atwood, "1.4 m/s^2")


SLOPE = """
title: Cylinder on a slope
given: {M: 2 kg, R: 0.1 m, beta: 30 deg, g: 9.8 m/s^2}
gravity: g
surfaces: {slope: {slope: beta, down: right}}
bodies: {cylinder: {shape: cylinder, mass: M, radius: R, moves: down, turns: clockwise}}
connections: {grip: {rolls: [cylinder, slope]}}
find: {a: cylinder.acceleration, alpha: cylinder.angular_acceleration, f: grip.friction_force}
"""


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A sheet of two problems."""
    place = tmp_path_factory.mktemp("homework")
    (place / "roll.yaml").write_text(SLOPE, encoding="utf-8")
    (place / "sheet.yaml").write_text(f"sheet: Homework\nproblems: [{DISC}, roll.yaml]\n", encoding="utf-8")
    return place / "sheet.yaml"


def test_answers_to_a_sheet_are_checked(homework: Path) -> None:
    """In a map, flat or by problem, in a text, and in one line: named as on the command line."""
    flat = {
        "1.a": "2 m g/(2 m + M)",
        "roll.a": "3.27 m/s^2",
        "f": "3.27 N",
        "roll.working": ["M g sin(beta) - f = M a"],
    }
    marked = check(homework, flat)
    assert list(marked) == ["1.a", "1.alpha", "1.T", "2.a", "2.alpha", "2.f"]
    assert [name for name in marked if marked[name].right] == ["1.a", "2.a", "2.f"]
    assert (
        marked["roll.a"].text == "3.27 m/s^2"
        and marked["f"].right
        and [line.right for line in marked.working] == [True]
    )
    assert (marked.marks, marked.of, marked.right) == (3.0, 6.0, False) and "3 of 6" in str(marked)
    assert [one.marks for one in marked.problems] == [1.0, 2.0] and marked.problems[1]["a"].right
    for name in ("a", "3.a", "1.f"):
        with pytest.raises(KeyError, match="nothing is asked by the name"):
            marked[name]
    nested = {"1": {"a": flat["1.a"]}, "roll": {"a": flat["roll.a"], "f": flat["f"], "working": flat["roll.working"]}}
    text = "Problem 1:\na = 2 m g/(2 m + M)\nProblem 2:\na = 3.27 m/s^2\nf = 3.27 N\nM g sin(beta) - f = M a"
    for told in (nested, text):
        assert str(check(homework, told)) == str(marked)
    assert check(str(homework), "2.f = 3.27 N")["2.f"].right
    with pytest.raises(HandedInError, match="which answer is this"):
        check(homework, "a = 1")
    assert pickle.loads(pickle.dumps(marked))["2.f"].right


# notebooks


class Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.found: dict[str, int] = {}
        self.fetched: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found[tag] = self.found.get(tag, 0) + 1
        self.fetched += [name for name, _ in attrs if name in ("src", "href", "xlink:href")]


def test_a_notebook_shows_formulas_and_the_picture_without_a_network(solution: Solution, run: Run) -> None:
    shown = {item: Tags() for item in ("solution", "answer", "run", "marks")}
    for (_, reader), item in zip(shown.items(), (solution, solution["a"], run, check(DISC, {"a": "1"})), strict=True):
        reader.feed(item._repr_html_())
        assert reader.fetched == [] and "script" not in reader.found and "link" not in reader.found
        assert reader.found["style"] == 1 + reader.found.get("svg", 0) and reader.found["div"] >= 1
    assert shown["solution"].found["svg"] == 1 and shown["solution"].found["math"] > 10
    assert shown["answer"].found["math"] == 3 and shown["run"].found["table"] == 1
    assert solution["a"]._repr_latex_().count(r"\frac") == 1


# the package itself


def test_public_names_are_there() -> None:
    assert set(rotsolve.__all__) <= set(dir(rotsolve))
    for name in rotsolve.__all__:
        assert getattr(rotsolve, name) is not None
    with pytest.raises(AttributeError, match="has no attribute 'sovle'"):
        _ = rotsolve.sovle


def test_importing_loads_next_to_nothing() -> None:
    told = "import sys; before = set(sys.modules); import rotsolve; print(*sorted(m for m in sys.modules if m.startswith('rotsolve')))"
    done = subprocess.run([sys.executable, "-c", told], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["rotsolve"]


USER = """\
import rotsolve
from rotsolve import AnswerView, Run, Solution

solution: Solution = rotsolve.solve({"title": "t"}, settings={"m": 2})
answer: AnswerView = solution["a"]
number: float = float(answer) + answer.in_unit("m/s^2")
names: list[str] = list(solution)
run: Run = rotsolve.simulate("a.yaml", until="2 s")
value, bound = run.at(0.5)["rod.angle"]
total: float = value + bound
marks: float = rotsolve.check(solution, {"a": 1}).marks
valid = solution.evaluate_many({"m": [1.0]}).valid
try:
    pass
except rotsolve.SceneError as error:
    line: int | None = error.line
"""


@pytest.mark.exhaustive
def test_users_have_types(tmp_path: Path) -> None:
    (tmp_path / "user.py").write_text(USER, encoding="utf-8")
    (tmp_path / "wrong.py").write_text(
        "import rotsolve\nrotsolve.solve(3)\nrotsolve.solve('a')['b'].valeu\n", encoding="utf-8"
    )
    arguments = ["--strict", "--cache-dir", str(tmp_path / "cache"), "--config-file", str(ROOT / "pyproject.toml")]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *arguments, str(tmp_path / "user.py"), str(tmp_path / "wrong.py")],
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
    )
    assert [line.partition(":")[0].endswith("wrong.py") for line in done.stdout.splitlines()[:-1]] == [True, True], (
        done.stdout
    )
