"""A cluster of this machine: two workers, one of which is killed half way; and what is said of clusters that can't mark."""

from __future__ import annotations

import os
import re
import signal
import sys
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from random import Random
from typing import Any

import pytest

from rotsolve.grading.course.stream import cluster, run
from rotsolve.grading.course.stream.assignment import BATCH, Assignment, MarkedRows, named_batch
from rotsolve.grading.course.stream.cluster import AHEAD, Cluster, ClusterError, told_version
from rotsolve.grading.course.stream.kept import KeptBatches

distributed = pytest.importorskip("distributed")
Command = Callable[..., Any]
ASSIGNMENT = Assignment(b"", 1, None)
BATCHES = 8


@pytest.fixture(scope="module")
def workers() -> Iterator[Any]:
    """A scheduler with two workers, each a process with one thread; what dies is given up at once."""
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": ":0"}
    with distributed.LocalCluster(**options, silence_logs=50) as local:
        local.scheduler.allowed_failures = 1  # once may be chance, twice is no more
        yield local


def papers(count: int) -> str:
    """Papers of every kind, and hardly two alike."""
    random = Random(1)
    answers = ("2mg/(2m+M)", "m g/(m+M)", "9.8 m/s²", "2mg/(2m+M", "")
    rows = [
        f"S{number % 3000},{random.choice(answers)},{random.uniform(1, 40):.4f} rad/s²,{random.choice(('m(g-a)', '10.9 N'))},m g - T = m a"
        for number in range(count)
    ]
    return "\n".join(["name,a,alpha,T,working", *rows]) + "\n"


@pytest.fixture
def written(command: Command) -> Command:
    """The command, with papers for some batches, the last of which is not full."""
    Path("class.csv").write_text(papers(BATCHES * BATCH - 30), encoding="utf-8")
    return command


def test_a_worker_that_is_killed_half_way(written: Command, workers: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is lost, nothing stands twice, and the marks are those of this process."""
    local = written("class.csv", "-o", "local.csv")
    plain, stored, killed = KeptBatches.store, list[int](), list[int]()

    def store(self: KeptBatches, number: int, rows: MarkedRows) -> None:
        plain(self, number, rows)
        stored.append(number)
        if len(stored) == BATCHES // 4:
            client = distributed.default_client()
            busy = max(client.processing().items(), key=lambda item: len(item[1]))
            assert busy[1], "the worker that is killed has no batch"
            killed.append(client.run(os.getpid, workers=[busy[0]])[busy[0]])
            os.kill(killed[0], signal.SIGKILL)

    monkeypatch.setattr(KeptBatches, "store", store)
    ran = written("class.csv", "-o", "marks.csv", "--cluster", workers.scheduler_address)
    assert killed and (ran.code, ran.err) == (1, "")
    assert sorted(stored) == list(range(BATCHES))
    lines = [line.split(",")[0] for line in Path("marks.csv").read_text(encoding="utf-8").splitlines()[1:]]
    assert lines == [str(number) for number in range(2, BATCHES * BATCH - 28)]
    assert Path("marks.csv").read_bytes() == Path("local.csv").read_bytes()
    assert ran.out == local.out.replace("local.csv", "marks.csv")


def test_a_report_is_that_of_this_process(command: Command, workers: Any) -> None:
    Path("class.csv").write_text(papers(BATCH + 20), encoding="utf-8")
    there = ("--cluster", workers.scheduler_address)
    assert command("class.csv", *there) == command("class.csv")
    for folder, words in (("here", ()), ("there", there)):
        assert command("class.csv", "-o", folder, *words).code == 1
    here, other = (
        {path.relative_to(folder): path.read_bytes() for path in Path(folder).rglob("*.*")}
        for folder in ("here", "there")
    )
    assert here == other and len(here) == BATCH + 26


def test_few_batches_are_out(command: Command, workers: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """However many papers there are, only some batches are read that are not kept yet."""
    Path("class.csv").write_text("name,a,alpha,T\n" + "Ada,g,g/R,0\n" * (20 * BATCH), encoding="utf-8")
    read, most = 0, 0
    plain, varied = KeptBatches.store, run.varied_entry

    def counting(entry: Any, variant: int | None) -> Any:
        nonlocal read, most
        read += 1
        most = max(most, read)
        return varied(entry, variant)

    def store(self: KeptBatches, number: int, rows: MarkedRows) -> None:
        nonlocal read
        read -= len(rows.rows)
        plain(self, number, rows)

    monkeypatch.setattr(run, "varied_entry", counting)
    monkeypatch.setattr(KeptBatches, "store", store)
    command("class.csv", "-o", "marks.csv", "--cluster", workers.scheduler_address)
    assert read == 0 and most <= (2 * AHEAD + 1) * BATCH


def dying(assignment: Assignment, batch: int) -> int:
    if batch == 3:
        os._exit(1)
    return batch


def test_papers_that_kill_whoever_marks_them(workers: Any) -> None:
    with Cluster(workers.scheduler_address) as there, pytest.raises(ClusterError) as error:
        list(there.each(dying, ASSIGNMENT, ((number, number) for number in range(6)), named_batch))
    died = r"2 workers died one after the other that had papers \d+ to \d+, perhaps by others"
    assert re.fullmatch(rf"{died} that they had: has each enough memory\?", str(error.value))


# clusters that can't mark


def said(command: Command, address: str) -> str:
    """The one line of a run that can't begin, and leaves nothing."""
    Path("class.csv").write_text("name,a\nAda,g\n", encoding="utf-8")
    ran = command("class.csv", "-o", "marks.csv", "--cluster", address)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert not list(Path().glob("marks*"))
    return str(ran.err)


def test_no_scheduler(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    message = "error: no scheduler answers at tcp://127.0.0.1:9: `dask scheduler` starts one\n"
    assert said(command, "tcp://127.0.0.1:9") == message


@pytest.mark.parametrize("address", ["foo://127.0.0.1:9", "two words", "tcp://"])
def test_no_address(command: Command, address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    assert said(command, address) == f"error: {address} is no address of a scheduler, as tcp://10.0.0.1:8786 is\n"


def test_no_worker(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    with distributed.LocalCluster(n_workers=0, dashboard_address=":0", silence_logs=50) as local:
        address = local.scheduler_address
        start = f"`dask worker {address} --nthreads 1` starts one"
        assert said(command, address) == f"error: no worker is at {address}: {start}\n"


def test_another_version(command: Command, workers: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "__version__", "9.9")
    worker, rest = said(command, workers.scheduler_address).removeprefix("error: ").split(" ", 1)
    assert worker.startswith("tcp://") and rest == "has rotsolve 0.1.0, here it is 9.9: install the same everywhere\n"


def test_a_worker_of_another_version_that_comes_later(workers: Any) -> None:
    from rotsolve.grading.course.stream.marker import rows_of_worker

    later = Assignment(b"", 1, None, False, "9.9")
    with (
        Cluster(workers.scheduler_address) as there,
        pytest.raises(ClusterError, match=r"a worker has rotsolve 0\.1\.0"),
    ):
        list(there.each(rows_of_worker, later, [(0, [])], named_batch))


def test_a_worker_without_rotsolve() -> None:
    assert told_version("tcp://w", PackageNotFoundError("rotsolve")).startswith(
        "tcp://w has no rotsolve that can be used"
    )


def test_no_worker_is_left(workers: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    for word in ("LOOK", "LEFT"):
        monkeypatch.setattr(cluster, word, 0.1)
    monkeypatch.setattr(Cluster, "workers", lambda self: {})
    with Cluster(workers.scheduler_address) as there, pytest.raises(ClusterError, match="no worker is left at tcp"):
        list(there.each(sleeping, ASSIGNMENT, [(0, 5)], named_batch))


def sleeping(assignment: Assignment, batch: float) -> float:
    from time import sleep

    sleep(batch)
    return batch


def test_a_scheduler_that_is_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 2)
    local = distributed.LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=":0")
    with (
        local,
        Cluster(local.scheduler_address) as there,
        pytest.raises(ClusterError, match=r"the scheduler at .* is gone"),
    ):
        for _ in there.each(sleeping, ASSIGNMENT, ((number, 0.2) for number in range(100)), named_batch):
            local.close(timeout=2)


def test_without_the_package(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    message = "error: a cluster takes distributed: pip install 'rotsolve[cluster]'\n"
    assert said(command, "tcp://127.0.0.1:9") == message


def test_one_paper_takes_no_cluster(command: Command) -> None:
    ran = command("--answer", "a = g", "--cluster", "tcp://127.0.0.1:9")
    assert ran.code == 2 and "a cluster marks a class's table, .csv or .parquet" in ran.err
