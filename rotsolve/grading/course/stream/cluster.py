"""Cluster: batches marked by the workers of a scheduler of dask. A worker that dies gives its batches back, and others mark them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, nullcontext
from time import monotonic
from types import TracebackType
from typing import Any, TypeVar

from rotsolve import __version__
from rotsolve.core.faults import RotsolveError, missing_package
from rotsolve.grading.course.stream.assignment import Assignment, OtherVersion

Given = TypeVar("Given")
Done = TypeVar("Done")
PATIENCE = 20.0  # seconds for a scheduler to answer, and for a first worker to be there
LEFT = 60.0  # seconds without any worker, after which it is given up
LOOK = 5.0  # seconds after which it is looked whether workers are left
AHEAD = 2  # batches that are out at a time, for each worker


class ClusterError(RotsolveError):
    """Why a cluster can't mark."""


def joined_cluster(address: str | None) -> AbstractContextManager[Cluster | None]:
    """The cluster at an address, where there is one."""
    return nullcontext() if address is None else Cluster(address)


class Cluster:
    """The workers of a scheduler, to be used by `with`; each of them has the rotsolve that is here."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.distributed = quiet_distributed()
        try:
            self.client = self.distributed.Client(address, timeout=PATIENCE)
        except (OSError, TimeoutError) as error:
            raise ClusterError(f"no scheduler answers at {address}: `dask scheduler` starts one") from error
        except (ValueError, TypeError) as error:
            raise ClusterError(f"{address} is no address of a scheduler, as tcp://10.0.0.1:8786 is") from error

    def __enter__(self) -> Cluster:
        try:
            self.refuse_others()
        except BaseException:
            self.client.close()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.client.close()

    def refuse_others(self) -> None:
        """ClusterError where no worker is there, or one has another rotsolve or none."""
        start = f"`dask worker {self.address} --nthreads 1` starts one"
        try:
            self.client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            raise ClusterError(f"no worker is at {self.address}: {start}") from None
        # a function of Python's own, which a worker without rotsolve has too
        from importlib.metadata import version

        for worker, found in self.client.run(version, "rotsolve", on_error="return").items():
            if found != __version__:
                raise ClusterError(told_version(worker, found))

    def each(
        self,
        work: Callable[[Assignment, Given], Done],
        assignment: Assignment,
        batches: Iterable[tuple[int, Given]],
        named: Callable[[int], str],
    ) -> Iterator[tuple[int, Done]]:
        """What comes of each batch, with its number, once, as soon as it is there; few are out at a time. `named` says which it is."""
        out: dict[Any, int] = {}
        for number, batch in batches:
            while len(out) >= AHEAD * max(1, len(self.workers())):
                yield self.first_done(out, named)
            out[self.client.submit(work, assignment, batch, pure=False)] = number
        while out:
            yield self.first_done(out, named)

    def workers(self) -> dict[str, int]:
        """The workers that are there, with their threads."""
        try:
            found: dict[str, int] = self.client.nthreads()
        except Exception:  # whatever a connection that is gone raises
            raise self.lost() from None
        return found

    def lost(self) -> ClusterError:
        return ClusterError(f"the scheduler at {self.address} is gone")

    def first_done(self, out: dict[Any, int], named: Callable[[int], str]) -> tuple[int, Any]:
        """The first batch that is done, which is taken out of those that are not."""
        self.wait_for(list(out))
        future = next(one for one in out if one.done())
        number = out.pop(future)
        if future.status == "cancelled":
            raise self.lost()
        try:
            return number, future.result()
        except self.distributed.KilledWorker as error:
            died = f"{error.allowed_failures + 1} workers died one after the other that had {named(number)}"
            raise ClusterError(f"{died}, perhaps by others that they had: has each enough memory?") from None
        except OtherVersion as error:
            raise ClusterError(told_version("a worker", str(error))) from None
        except ModuleNotFoundError as error:
            raise ClusterError(told_version("a worker", error)) from None
        except (OSError, self.distributed.CancelledError):
            raise self.lost() from None

    def wait_for(self, futures: list[Any]) -> None:
        """Wait until one is done; ClusterError where there is nobody any more to do it."""
        seen = monotonic()
        while True:
            try:
                self.distributed.wait(futures, timeout=LOOK, return_when="FIRST_COMPLETED")
                return
            except TimeoutError:
                if self.workers():
                    seen = monotonic()
                elif monotonic() - seen > LEFT:
                    raise ClusterError(f"no worker is left at {self.address}") from None
            except self.distributed.CancelledError:
                raise self.lost() from None


def told_version(worker: str, found: object) -> str:
    """Which rotsolve a worker has, where it has not ours."""
    has = f"rotsolve {found}" if isinstance(found, str) else "no rotsolve that can be used"
    return f"{worker} has {has}, here it is {__version__}: install the same everywhere"


def quiet_distributed() -> Any:
    """The package that speaks with a scheduler; what it logs of connections is said by errors of ours."""
    try:
        import dask

        dask.config.set(logging={"distributed": "critical", "distributed.client": "critical"})
        import distributed
    except ModuleNotFoundError:
        raise missing_package("a cluster takes", "distributed", "cluster") from None
    return distributed
