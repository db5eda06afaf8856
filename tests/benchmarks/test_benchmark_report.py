"""What the benchmarks write into docs/benchmarks.md."""

from __future__ import annotations

import platform
from pathlib import Path

from report import machine, write_section


def test_a_section_is_written_in_its_own_place(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    write_section("one", "## One", page)
    write_section("two", "## Two", page)
    write_section("one", "## One, anew", page)
    text = page.read_text(encoding="utf-8")
    assert text.startswith("# Benchmarks")
    assert "## One\n" not in text
    assert text.index("## One, anew") < text.index("<!-- one: end -->") < text.index("## Two")
    again = text
    write_section("two", "## Two", page)
    assert page.read_text(encoding="utf-8") == again


def test_the_machine_is_named_without_its_host() -> None:
    described = machine()
    assert platform.python_version() in described
    assert platform.node() not in described
