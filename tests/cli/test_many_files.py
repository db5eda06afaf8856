"""Many files at a time: in order, each with its time limit, and what ends the process of one file is that file's error alone.

What goes wrong goes wrong for real: a process is killed, and a file takes for ever. A `sitecustomize` that every Python of the
command imports arranges for that by the names of files.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from rotsolve import solve
from rotsolve.cli import main

PROBLEMS = Path(__file__).resolve().parents[2] / "problems" / "pulleys"
HOOK = """\
import os, signal, time
from pathlib import Path
import rotsolve.pipeline

solve = rotsolve.pipeline.solve

def hindered(source, **options):
    stem = "" if "\\n" in str(source) else Path(source).stem
    if stem in ("killed", "endless"):
        Path(source).with_suffix(".pid").write_text(str(os.getpid()))
    if stem == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    if stem == "quits":
        os._exit(3)
    while stem == "endless":
        time.sleep(0.01)
    if stem == "slow":
        time.sleep(1)
    return solve(source, **options)

rotsolve.pipeline.solve = hindered
"""
KILLED = "error: the process that solved killed.yaml was ended by the signal SIGKILL\n"
QUITS = "error: the process that solved quits.yaml ended with code 3\n"
ENDLESS = "error: endless.yaml takes longer than 1 s, the time limit\n"

Command = Callable[..., "subprocess.Popen[str]"]


@pytest.fixture
def command(tmp_path: Path) -> Iterator[Command]:
    """Start `rotsolve solve` in a folder of scenes, as the leader of a process group of its own."""
    scene = (PROBLEMS / "atwood.yaml").read_text(encoding="utf-8")
    for name in ("a", "b", "endless", "killed", "quits", "slow"):
        (tmp_path / f"{name}.yaml").write_text(scene, encoding="utf-8")
    (tmp_path / "hook").mkdir()
    (tmp_path / "hook" / "sitecustomize.py").write_text(HOOK, encoding="utf-8")
    started: list[subprocess.Popen[str]] = []

    def start(*arguments: str) -> subprocess.Popen[str]:
        paths = [str(tmp_path / "hook"), *filter(None, [os.environ.get("PYTHONPATH")])]
        process = subprocess.Popen(
            [sys.executable, "-m", "rotsolve", "solve", "--width", "100", *arguments],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            start_new_session=True,
            preexec_fn=lambda: signal.signal(
                signal.SIGINT, signal.SIG_DFL
            ),  # which is ignored where tests run in the background
        )
        started.append(process)
        return process

    yield start
    for process in started:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()


def ran(process: subprocess.Popen[str], text: str = "") -> tuple[int, str, str]:
    out, err = process.communicate(text, timeout=120)
    return process.returncode, out, err


@pytest.fixture(scope="module")
def page() -> str:
    return solve(PROBLEMS / "atwood.yaml").to("text", width=100)


def rule(*pages: str) -> str:
    return f"\n{'─' * 72}\n\n".join(pages)


def test_the_order_is_that_of_the_files(command: Command, page: str) -> None:
    """The slowest file comes first, and of the two others one is another scene."""
    other = solve(PROBLEMS / "block-on-disc.yaml").to("text", width=100)
    code, out, err = ran(command("slow.yaml", str(PROBLEMS / "block-on-disc.yaml"), "a.yaml", "--jobs", "3"))
    assert (code, out, err) == (0, rule(page, other, page), "")


def test_a_killed_process_and_one_that_leaves_are_errors_of_their_files(command: Command, page: str) -> None:
    code, out, err = ran(command("a.yaml", "killed.yaml", "quits.yaml", "b.yaml", "--jobs", "2"))
    assert (code, out) == (1, rule(page, page))
    assert err == f"{KILLED}\n{QUITS}\n2 of 4 files not solved: killed.yaml, quits.yaml\n"


@pytest.mark.sampled(2)
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_file_that_takes_too_long_is_given_up(command: Command, page: str, jobs: str) -> None:
    code, out, err = ran(command("endless.yaml", "a.yaml", "--time-limit", "1s", "--jobs", jobs))
    assert (code, out, err) == (1, page, f"{ENDLESS}\n1 of 2 files not solved: endless.yaml\n")


def test_json_stays_one_document(command: Command) -> None:
    files = ("killed.yaml", "a.yaml", "endless.yaml")
    code, out, err = ran(command(*files, "--format", "json", "--jobs", "2", "--time-limit", "1s"))
    killed, solved, endless = json.loads(out)
    assert (code, err) == (1, f"{KILLED}\n{ENDLESS}\n2 of 3 files not solved: killed.yaml, endless.yaml\n")
    assert killed == {"file": "killed.yaml", "solved": False, "kind": "crash", "error": KILLED.rstrip("\n")}
    assert (solved["file"], solved["solved"]) == ("a.yaml", True)
    assert endless["kind"] == "time limit"


def test_a_page_is_there_while_a_later_file_is_at_work(command: Command, page: str) -> None:
    process = command("a.yaml", "endless.yaml", "--jobs", "2")
    assert process.stdout is not None
    assert process.stdout.read(len(page)) == page
    assert process.poll() is None


def test_standard_input_is_read_once_and_solved_elsewhere(command: Command, page: str, tmp_path: Path) -> None:
    text = (tmp_path / "a.yaml").read_text(encoding="utf-8")
    assert ran(command("-", "a.yaml", "--jobs", "2"), text) == (0, rule(page, page), "")


def test_an_interrupt_ends_all_processes(command: Command, page: str, tmp_path: Path) -> None:
    process = command("a.yaml", "endless.yaml", "b.yaml", "--jobs", "2")
    assert process.stdout is not None
    assert process.stdout.read(len(page)) == page
    written = tmp_path / "endless.pid"
    await_(lambda: written.exists() and written.read_text() != "")
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to all processes of the command
    code, out, err = ran(process)
    assert (code, out, err) == (130, "", "interrupted\n")
    await_(lambda: not alive(int(written.read_text())))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("later", [0.0, 0.1, 0.3])
def test_an_interrupt_while_processes_start_ends_them_too(command: Command, later: float) -> None:
    process = command("endless.yaml", "endless.yaml", "--jobs", "2")
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    if not children.exists():
        pytest.skip("no list of the processes of a process here")
    await_(lambda: len(children.read_text().split()) > 1)  # what keeps track, and what makes copies of itself
    time.sleep(later)
    os.killpg(process.pid, signal.SIGINT)
    assert ran(process) == (130, "", "interrupted\n")


def test_a_reader_that_goes_away_ends_all_processes(command: Command, tmp_path: Path) -> None:
    process = command("endless.yaml", "a.yaml", "--jobs", "2", "--time-limit", "1s")
    assert process.stdout is not None
    process.stdout.close()
    assert process.wait(60) == 141
    await_(lambda: not alive(int((tmp_path / "endless.pid").read_text())))


def await_(condition: Callable[[], bool], seconds: float = 60) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it does not happen"
        time.sleep(0.02)


def alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    status = Path(f"/proc/{process}/stat")
    return not status.exists() or status.read_text().rpartition(")")[2].split()[0] != "Z"


@pytest.mark.parametrize(
    ("limit", "message"),
    [
        ("10kg", "`10kg` is no time; write 10s"),
        ("0s", "`0s` is not positive; write 10s"),
        ("ten", "`ten`: a quantity begins with a number"),
    ],
)
def test_a_time_limit_is_a_time(limit: str, message: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["solve", "a.yaml", "--time-limit", limit])
    assert left.value.code == 2
    assert message in " ".join(capsys.readouterr().err.split())
