"""docs/editors.md: its settings are what they say they are, and Neovim, where it is installed, works with the one for it."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from rotsolve.cli import COMMANDS
from rotsolve.language.grammar import SECTIONS

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "editors.md").read_text(encoding="utf-8")
SCENE = """title: Spin
given: {m: 2 kg, R: 20 cm}
bodies:
  wheel: {shape: dics, mass: m, radius: R}
find: {a: wheel.angle}
"""
TRY = """
local told = {}
vim.cmd("edit scene.yaml")
vim.wait(30000, function() return #vim.diagnostic.get(0) > 0 end, 50)
for _, found in ipairs(vim.diagnostic.get(0)) do
  table.insert(told, found.lnum .. ":" .. found.col .. " " .. found.message:match("[^\\n]*"))
end
local client = vim.lsp.get_clients()[1]
local function ask(method, params)
  params.textDocument = { uri = vim.uri_from_bufnr(0) }
  return client:request_sync(method, params, 30000, 0).result
end
table.insert(told, ask("textDocument/hover", { position = { line = 1, character = 17 } }).contents.value)
local range = { start = { line = 3, character = 17 }, ["end"] = { line = 3, character = 21 } }
local action = ask("textDocument/codeAction", { range = range, context = { diagnostics = {} } })[1]
vim.lsp.util.apply_workspace_edit(action.edit, client.offset_encoding)
table.insert(told, vim.api.nvim_buf_get_lines(0, 3, 4, false)[1])
vim.wait(30000, function() return #vim.diagnostic.get(0) == 0 end, 50)
table.insert(told, "left: " .. #vim.diagnostic.get(0))
vim.fn.writefile(told, "told.txt")
vim.cmd("qa!")
"""


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


def test_the_settings_can_be_read_and_start_the_server() -> None:
    schema, server = map(json.loads, blocks("json"))
    assert list(schema["yaml.schemas"]) == ["./scene.schema.json"]
    assert [server["glspc.server.command"], *server["glspc.server.commandArguments"]] == ["rotsolve", "lsp"]
    helix = tomllib.loads(blocks("toml")[0])
    named = helix["language-server"]["rotsolve"]
    assert [named["command"], *named["args"]] == ["rotsolve", "lsp"] and "lsp" in COMMANDS
    assert helix["language"] == [{"name": "yaml", "language-servers": ["rotsolve"]}]


def test_all_commands_of_the_page_are_there() -> None:
    assert {*re.findall(r"rotsolve ([a-z]+)\b", PAGE)} <= {*COMMANDS, "is"}
    assert "rotsolve schema > scene.schema.json" in PAGE and "find" in SECTIONS


@pytest.mark.parametrize("number", [0, 1], ids=["vim.lsp.config", "vim.lsp.start"])
def test_neovim_works_with_its_settings(tmp_path: Path, number: int) -> None:
    editor = shutil.which("nvim")
    if editor is None:
        pytest.skip("no Neovim here")
    version = re.search(r"v0\.(\d+)", subprocess.run([editor, "--version"], capture_output=True, text=True).stdout)
    if version is None or int(version[1]) < 11:
        pytest.skip("this Neovim is older than 0.11")
    (tmp_path / "scene.yaml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "init.lua").write_text(blocks("lua")[number], encoding="utf-8")
    (tmp_path / "try.lua").write_text(TRY, encoding="utf-8")
    command = [editor, "--headless", "--clean", "-u", "init.lua", "-c", "luafile try.lua"]
    path = os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"]))
    subprocess.run(
        command, cwd=tmp_path, env={**os.environ, "PATH": path}, timeout=120, check=False, capture_output=True
    )
    assert (tmp_path / "told.txt").read_text(encoding="utf-8").splitlines() == [
        "3:17 unknown shape `dics`",
        "`R` = 20 cm = 0.2 m, a length (m)",
        "  wheel: {shape: disc, mass: m, radius: R}",
        "left: 0",
    ]
