"""docs/notebooks: each runs from its first cell to its last and says what it said when it was stored; nothing in it is of one machine."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

BOOKS = sorted((Path(__file__).resolve().parent.parent / "docs" / "notebooks").glob("*.ipynb"))
DRAWN = ("image/png", "image/svg+xml")  # curves, of which the bytes are matplotlib's
OF_A_MACHINE = re.compile(
    r"/home/|/tmp/|/root|/Users/|site-packages|[A-Z]:\\\\|https?://(?!www\.w3\.org/)|<script|0x[0-9a-f]{6,}"
)


def executed(book: Any, folder: Path) -> Any:
    """The notebook after a run in a new kernel, without what is of this run alone."""
    made = nbformat.from_dict(book)
    NotebookClient(
        made, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(folder)}}, record_timing=False
    ).execute()
    made.metadata["language_info"] = {"name": "python"}
    return made


def told(book: Any) -> list[Any]:
    """What each cell says, pictures of curves aside."""
    return [said(output) for cell in book.cells if cell.cell_type == "code" for output in cell.outputs]


def said(output: Any) -> Any:
    if output.output_type == "stream":
        return output.name, output.text
    assert output.output_type in ("execute_result", "display_data"), output
    return [kind for kind in DRAWN if kind in output.data] or output.data["text/plain"], sorted(output.data)


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_says_what_is_stored(path: Path, regenerate: bool) -> None:
    stored = nbformat.read(path, as_version=4)
    made = executed(nbformat.read(path, as_version=4), path.parent)
    if regenerate:
        nbformat.write(made, path)
        return
    assert told(made) == told(stored)


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_of_no_machine_and_needs_no_network(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert not OF_A_MACHINE.search(text), OF_A_MACHINE.search(text)
    assert any(cell.outputs for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code")


def test_there_are_two() -> None:
    assert [path.stem for path in BOOKS] == ["physicist", "teacher"]
