"""What the benchmarks write into docs/benchmarks.md: the machine and the date, and a section of their own each."""

from __future__ import annotations

import os
import platform
import re
from datetime import UTC, datetime
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent / "docs"
PAGE = DOCS / "benchmarks.md"
TITLE = """\
# Benchmarks

Each section is written by the program that it names, and says when and on what it was measured.
"""


def machine() -> str:
    """The day and the machine in one line: `2026-01-31 · 2 cores · AMD EPYC · CPython 3.11.7 · Linux`."""
    cores = os.cpu_count() or 1
    parts = (
        f"{datetime.now(UTC):%Y-%m-%d}",
        f"{cores} core{'' if cores == 1 else 's'}",
        processor(),
        f"{platform.python_implementation()} {platform.python_version()}",
        platform.system(),
    )
    return " · ".join(parts)


def processor() -> str:
    """The model of the processor as the system names it, else its architecture."""
    try:
        described = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.machine()
    named = re.search(r"^model name\s*:\s*(.+)$", described, re.MULTILINE)
    return named[1].strip() if named else platform.machine()


def write_section(name: str, markdown: str, page: Path = PAGE) -> None:
    """Put the section `name` into the page, between its markers: in place of the one before, or at the end."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    section = f"{begin}\n\n{markdown.strip()}\n\n{end}"
    text = page.read_text(encoding="utf-8") if page.exists() else TITLE
    before, found, rest = text.partition(begin)
    after = rest.partition(end)[2]
    text = f"{before}{section}{after}" if found else f"{text.rstrip()}\n\n{section}\n"
    page.write_text(text, encoding="utf-8")
