"""`rotsolve simulate`: its table, its numbers, its picture, and what it refuses."""

from __future__ import annotations

import csv
import importlib.util
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCENE = "problems/hinged/rod-30.yaml"
EXPECTED = Path(__file__).parent / "expected" / "simulate-rod.txt"


def simulate(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "rotsolve", "simulate", *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1"}
    return subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120, check=False)


def test_the_table_at_eighty_columns(expected: Callable[[Path, str], None]) -> None:
    ran = simulate(SCENE, "--until", "2s", "--width", "80")
    assert (ran.returncode, ran.stderr) == (0, "")
    expected(EXPECTED, ran.stdout.partition("\nAccuracy\n")[0] + "\n")  # which depends on the machine's sine
    assert max(map(len, ran.stdout.splitlines())) <= 80


def test_numbers_with_their_bounds() -> None:
    ran = simulate(SCENE, "--until", "1s", "--step", "0.25s", "--csv")
    rows = list(csv.DictReader(ran.stdout.splitlines()))
    assert [float(row["time"]) for row in rows] == [0, 0.25, 0.5, 0.75, 1]
    assert all(0 <= float(row["rod.angle bound"]) < 1e-8 for row in rows)
    assert float(rows[0]["rod.angular_acceleration"]) == pytest.approx(-12.7305734356)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        ((SCENE, "--until", "3kg"), 2, "is no time"),
        ((SCENE, "--until", "0s"), 2, "is not positive"),
        ((SCENE, "--until", "1e12s"), 2, "is not from 1e-09 s to 1e+09 s"),
        ((SCENE, "--step", "1e-6s"), 2, "more than 100000 rows"),
        ((SCENE, "--accuracy", "nan"), 2, "it is no number"),
        (("problems/angular-momentum/disc-drop.yaml",), 1, "begins with the event `drop`"),
        ((SCENE, "--plot", "rod.pdf"), 2, "is no .svg or .png"),
        ((SCENE, "--plot", "rod.svg", "--csv"), 2, "either a picture or numbers"),
        ((SCENE, "--animate", "rod.gif"), 2, "is no .html"),
        ((SCENE, "--animate", "rod.html", "--csv"), 2, "either a page or numbers"),
        ((SCENE, "--animate", "rod.html", "--plot", "rod.svg"), 2, "either a page or a plot"),
        ((SCENE, "--show", "forces", "--csv"), 2, "--csv prints all quantities"),
        ((SCENE, "--show", "tension"), 1, "the motion tells no `tension`"),
        (("problems/kinematics/angle-units.yaml", "--animate", "units.html"), 1, "no bodies to draw"),
        (("problems/swings/swinging-rod.yaml", "--animate", "rod.html"), 1, "the angle of `rod` at first is not told"),
        ((SCENE, "--until", "1s", "--animate", "no/such/folder/rod.html"), 2, "cannot write no/such/folder/rod.html"),
        ((SCENE, "--accuracy", "2"), 2, "not in the range"),
        (("nowhere.yaml",), 2, "read `nowhere.yaml`: No such file"),
        (("problems/swings/swinging-rod.yaml",), 1, "the angle of `rod` at first is not told"),
    ],
)
def test_what_is_refused(arguments: tuple[str, ...], code: int, words: str) -> None:
    ran = simulate(*arguments)
    assert ran.returncode == code and words in " ".join(ran.stderr.split()) and "Traceback" not in ran.stderr


@pytest.mark.parametrize("kind", ["svg", "png"])
def test_a_picture_is_drawn_or_its_package_named(tmp_path: Path, kind: str) -> None:
    path = tmp_path / f"rod.{kind}"
    ran = simulate(SCENE, "--until", "1s", "--plot", str(path))
    if importlib.util.find_spec("matplotlib") is None:
        assert (ran.returncode, ran.stderr) == (2, "error: drawing takes matplotlib: pip install 'rotsolve[plot]'\n")
    else:
        assert ran.returncode == 0 and path.stat().st_size > 1000
        assert ran.stderr == f"wrote {path}: t = 0 to 1 s\n"


def test_a_page_moves(tmp_path: Path) -> None:
    path = tmp_path / "rod.html"
    ran = simulate(SCENE, "--until", "1s", "--step", "0.5s", "--animate", str(path))
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", f"wrote {path}: t = 0 to 1 s\n")
    page = path.read_text(encoding="utf-8")
    assert page.startswith("<!DOCTYPE html>") and '"times":["0.0","0.5","1.0"]' in page


def test_quantities_are_chosen_by_name() -> None:
    def columns(*names: str) -> list[str]:
        options = (option for name in names for option in ("--show", name))
        ran = simulate("problems/pulleys/atwood.yaml", "--until", "1s", *options)
        return next(line for line in ran.stdout.splitlines() if line.strip().startswith("t  ")).split()[1:]

    assert columns() == columns("motion")
    assert columns("string.light.tension") == ["string.light.tension"]
    assert columns("tension") == columns("string") == ["string.heavy.tension", "string.light.tension"]
    assert columns("velocity,light.position", "pulley.angle") == [
        "light.velocity", "heavy.velocity", "light.position", "pulley.angle",
    ]  # fmt: skip
    assert set(columns("forces")) >= {"string.heavy.tension", "axle.force.y"}


def test_numbers_go_into_a_file(tmp_path: Path) -> None:
    path = tmp_path / "rod.csv"
    ran = simulate(SCENE, "--until", "0.1s", "--csv", "-o", str(path))
    assert (ran.returncode, ran.stdout) == (0, "")
    assert ran.stderr == f"wrote {path}: t = 0 to 0.1 s; not reached: lowest\n"
    assert path.read_text(encoding="utf-8") == simulate(SCENE, "--until", "0.1s", "--csv").stdout
    refused = simulate(SCENE, "--until", "0.1s", "-o", str(path))
    assert refused.returncode == 2 and "--csv" in refused.stderr
