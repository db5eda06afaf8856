"""Lsp: `rotsolve lsp`: the language server that editors start."""

from __future__ import annotations

import sys
from importlib.util import find_spec

import typer

from rotsolve.process import USAGE

LACKING = "error: the language server needs pygls, which is not installed\nhelp: pip install 'rotsolve[editor]'"


def lsp_command() -> None:
    """Serve an editor in which scenes are written.

    It tells faults, completions, help and fixes by the Language Server Protocol, on standard input and output. An editor
    starts it; docs/editors.md says how. It needs pip install 'rotsolve[editor]'.

    \b
    Example, the command by which an editor starts it:
      rotsolve lsp
    """
    if find_spec("pygls") is None or find_spec("lsprotocol") is None:
        print(LACKING, file=sys.stderr)
        raise typer.Exit(USAGE)
    from rotsolve.editor.server import serve

    serve()
