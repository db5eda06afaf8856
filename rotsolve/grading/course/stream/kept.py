"""Kept: the batches that have been marked, a file each by its number, until all are there: what was interrupted goes on from them.

A batch that is marked twice is written twice to the same file, so that no row can stand twice in what is made of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from hashlib import file_digest, sha256
from pathlib import Path

import msgspec

from rotsolve import __version__
from rotsolve.grading.course.examination import Examination
from rotsolve.grading.course.stream.assignment import MarkedRows
from rotsolve.run.delivery import replacing

OF = "of-this-run"  # the file that tells what the batches are of
OURS = re.compile(r"of-this-run|\d{8}\.rows|\.(of-this-run|\d{8}\.rows)\.\d+\.new")


class KeptBatches:
    """The folder beside the output; those of another problem, other papers or another choice are removed first."""

    def __init__(self, output: str, told: str, anew: bool = False) -> None:
        self.folder, self.told = Path(f"{output}.parts"), told
        note = self.folder / OF
        if anew or not note.is_file() or note.read_text(encoding="utf-8") != told:
            self.remove()
            self.folder.mkdir(exist_ok=True)
            with replacing(note) as fresh:
                fresh.write_text(told, encoding="utf-8")
        self.numbers = {int(path.stem) for path in self.folder.glob("*.rows") if self.readable(path)}

    def readable(self, path: Path) -> bool:
        """Whether a file is whole, as it may not be where the machine went down."""
        try:
            return OURS.fullmatch(path.name) is not None and bool(read_rows(path).rows)
        except msgspec.MsgspecError:
            return False

    def file(self, number: int) -> Path:
        return self.folder / f"{number:08d}.rows"

    def store(self, number: int, rows: MarkedRows) -> None:
        """Keep a batch: the whole file or none."""
        with replacing(self.file(number)) as fresh:
            fresh.write_bytes(msgspec.msgpack.encode(rows))
        self.numbers.add(number)

    def in_order(self) -> Iterator[MarkedRows]:
        """The batches as the input has them, one at a time."""
        return (read_rows(self.file(number)) for number in sorted(self.numbers))

    def remove(self) -> None:
        """Remove what is ours, and the folder where nothing else is in it."""
        if self.folder.is_dir():
            for path in self.folder.iterdir():
                if OURS.fullmatch(path.name):
                    path.unlink()
            with suppress(OSError):
                self.folder.rmdir()


def read_rows(path: Path) -> MarkedRows:
    return msgspec.msgpack.decode(path.read_bytes(), type=MarkedRows)


def told_run(examination: Examination, papers: str, variant: int | None, size: int) -> str:
    """What batches are of, as a digest: what is asked and how it is marked, the bytes of the papers, the variant of those that name
    none, and how many papers a batch has."""
    with open(papers, "rb") as stream:
        content = file_digest(stream, "sha256").hexdigest()
    first, tasks = examination.judges[0], examination.task.tasks
    asked = [
        (one.problem.lines, task.number, task.name, list(task.labels.items()), list(map(str, task.points.values())))
        for one, task in zip(examination.judges, tasks, strict=True)
    ]
    marking = [__version__, examination.task.is_sheet, asked, first.seed, first.count]
    return sha256(msgspec.json.encode([marking, Path(papers).suffix.lower(), content, variant, size])).hexdigest()
