"""`rotsolve lsp` without what it needs, and what it leaves alone."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from importlib.machinery import ModuleSpec
from typing import Any

import pytest

Run = Callable[..., Any]


def test_without_pygls_it_says_what_to_install(rotsolve: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    found = importlib.util.find_spec

    def without(name: str, package: str | None = None) -> ModuleSpec | None:
        return None if name == "pygls" else found(name, package)

    monkeypatch.setattr("rotsolve.cli.lsp.find_spec", without)
    ran = rotsolve("lsp")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        "error: the language server needs pygls, which is not installed\nhelp: pip install 'rotsolve[editor]'\n"
    )
