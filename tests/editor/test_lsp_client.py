"""`rotsolve lsp` as an editor uses it: a client of pygls starts the process, and speaks to it over its pipes."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from lsprotocol import types
from pygls.lsp.client import LanguageClient

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
SCENE = (PROBLEMS / "pulleys" / "block-on-disc.yaml").read_text(encoding="utf-8")
URI = "file:///scene.yaml"
BAD = """title: Spin — ½ 𝛚
given: {m: 2 kg, R: 20 cm}
bodies:
  wheel: {shape: dics, mass: m, radius: R, colour: 3}
find: {a: wheel.angel}
"""
PATIENCE = 30.0  # seconds; on a machine at work the process starts late


class Editor(LanguageClient):
    """A client that keeps what is shown."""

    def __init__(self) -> None:
        super().__init__("a test", "1")
        self.shown: asyncio.Queue[list[types.Diagnostic]] = asyncio.Queue()

        @self.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def show(params: types.PublishDiagnosticsParams) -> None:
            self.shown.put_nowait(list(params.diagnostics))

    async def next(self) -> list[types.Diagnostic]:
        return await asyncio.wait_for(self.shown.get(), PATIENCE)

    def write(self, text: str, version: int) -> None:
        document = types.VersionedTextDocumentIdentifier(version, URI)
        whole = [types.TextDocumentContentChangeWholeDocument(text)]
        self.text_document_did_change(types.DidChangeTextDocumentParams(document, whole))

    async def complete(self, line: int, column: int) -> list[types.CompletionItem]:
        document = types.TextDocumentIdentifier(URI)
        where = types.CompletionParams(document, types.Position(line, column))
        found = await asyncio.wait_for(self.text_document_completion_async(where), PATIENCE)
        assert isinstance(found, types.CompletionList)
        return list(found.items)


@asynccontextmanager
async def session(
    text: str, encodings: list[types.PositionEncodingKind] | None = None, *, stops: bool = False, uri: str = URI
) -> AsyncIterator[Editor]:
    """An editor with one text open; at its end the server leaves as it is asked to."""
    editor = Editor()
    await editor.start_io(sys.executable, "-m", "rotsolve", "lsp")
    general = types.GeneralClientCapabilities(position_encodings=encodings)
    completion = types.CompletionClientCapabilities(
        completion_item=types.ClientCompletionItemOptions(snippet_support=stops)
    )
    asked = types.TextDocumentClientCapabilities(completion=completion)
    able = types.ClientCapabilities(general=general, text_document=asked)
    await asyncio.wait_for(editor.initialize_async(types.InitializeParams(able)), PATIENCE)
    editor.initialized(types.InitializedParams())
    document = types.TextDocumentItem(uri, "yaml", 1, text)
    editor.text_document_did_open(types.DidOpenTextDocumentParams(document))
    yield editor
    await asyncio.wait_for(editor.shutdown_async(None), PATIENCE)
    editor.exit(None)
    process = editor._server
    assert process is not None
    assert await asyncio.wait_for(process.wait(), PATIENCE) == 0
    await editor.stop()


def edited(text: str, edit: types.TextEdit) -> str:
    """The text with an edit within one line; columns in UTF-16."""
    lines = text.split("\n")
    line = lines[edit.range.start.line].encode("utf-16-le")
    new = (
        line[: 2 * edit.range.start.character]
        + edit.new_text.encode("utf-16-le")
        + line[2 * edit.range.end.character :]
    )
    lines[edit.range.start.line] = new.decode("utf-16-le")
    return "\n".join(lines)


@pytest.mark.parametrize(
    "uri",
    [
        "file:///my%20scenes/a.yaml",
        "file:///c%3A/a.yaml",
        "file:///Gr%C3%B6%C3%9Fe.yaml",
        "file:///a+b[1].yaml",
        "untitled:1",
    ],
)
def test_a_text_is_known_by_any_name(uri: str) -> None:
    asyncio.run(named(uri))


async def named(uri: str) -> None:
    """Faults are shown, and of a text that is not open nothing is told."""
    async with session(BAD, uri=uri) as editor:
        assert len(await editor.next()) == 3
        other = types.TextDocumentIdentifier("file:///not%20open.yaml")
        assert await editor.text_document_hover_async(types.HoverParams(other, types.Position(1, 17))) is None


def test_a_fault_names_the_other_places_that_it_speaks_of() -> None:
    asyncio.run(related_places())


async def related_places() -> None:
    """A letter in use whose unit does not fit: the given is another place of the same file."""
    async with session(SCENE.replace("R: 20 cm", "R: 20 s").replace("R: 0.2 m", "R: 0.2 s")) as editor:
        (found,) = [item for item in await editor.next() if item.code == "dimension"]
        (other,) = found.related_information or ()
        assert other.location.uri == URI and other.message == "`R` is given here"
        line = SCENE.split("\n")[other.location.range.start.line]
        assert line.startswith("given:") and line[other.location.range.start.character] == "R"


def test_a_session_from_faults_to_a_solved_scene() -> None:
    asyncio.run(whole_session())


async def whole_session() -> None:
    async with session(BAD) as editor:
        found = await editor.next()
        assert [(item.range.start.line, item.message.split("\n")[0]) for item in found] == [
            (3, "unknown shape `dics`"),
            (3, "unknown key `colour` in body `wheel`"),
            (4, "`wheel` has no quantity `angel`"),
        ]
        assert {item.severity for item in found} == {types.DiagnosticSeverity.Error}
        text, version = BAD, 1
        document = types.TextDocumentIdentifier(URI)
        for diagnostic in found:
            context = types.CodeActionContext([diagnostic])
            actions = await editor.text_document_code_action_async(
                types.CodeActionParams(document, diagnostic.range, context)
            )
            for action in actions or ():
                assert (
                    isinstance(action, types.CodeAction) and action.edit is not None and action.edit.changes is not None
                )
                text = edited(text, action.edit.changes[URI][0])
        assert "shape: disc" in text and "wheel.angle" in text
        text = text.replace(", colour: 3", "")
        editor.write(text, version := version + 1)
        assert await editor.next() == []
        hovered = await editor.text_document_hover_async(types.HoverParams(document, types.Position(1, 17)))
        assert hovered is not None and isinstance(hovered.contents, types.MarkupContent)
        assert hovered.contents.value == "`R` = 20 cm = 0.2 m, a length (m)"
        editor.write(text + "states: {end: {wheel.", version := version + 1)
        await editor.next()
        labels = [item.label for item in await editor.complete(5, 21)]
        assert {"angle", "angular_velocity", "rim"} <= {*labels}
        symbols = await editor.text_document_document_symbol_async(types.DocumentSymbolParams(document))
        assert [item.name for item in symbols or ()] == ["title", "given", "bodies", "find", "states"]
        place = await editor.text_document_definition_async(types.DefinitionParams(document, types.Position(4, 12)))
        assert isinstance(place, types.Location) and place.range.start == types.Position(3, 2)


@pytest.mark.parametrize(
    "encoding", [types.PositionEncodingKind.Utf16, types.PositionEncodingKind.Utf8, types.PositionEncodingKind.Utf32]
)
def test_columns_are_counted_as_the_client_counts(encoding: types.PositionEncodingKind) -> None:
    text = (
        'bodies: {disc: {shape: disc, mass: 2 kg, radius: 1 m}}\nfind: {a: disc.mass, b: "disc.inertia  + disc.𝛚𝛚"}\n'
    )
    unit = {"utf-16": "utf-16-le", "utf-8": "utf-8", "utf-32": "utf-32-le"}[encoding.value]
    size = {"utf-16": 2, "utf-8": 1, "utf-32": 4}[encoding.value]

    async def ask() -> None:
        async with session(text, [encoding]) as editor:
            (fault,) = await editor.next()
            line = text.split("\n")[1].encode(unit)
            shown = line[size * fault.range.start.character : size * fault.range.end.character].decode(unit)
            assert shown == "𝛚𝛚", fault

    asyncio.run(ask())


def test_what_the_solver_refuses_is_shown_at_its_place() -> None:
    """On opening and on saving; what is written on since is not told what was wrong before."""

    async def ask() -> None:
        async with session(SCENE.replace("M: 5 kg", "M: unknown")) as editor:
            assert await editor.next() == []
            (found, *_) = await editor.next()
            assert found.severity == types.DiagnosticSeverity.Warning and found.code == "incomplete"
            assert SCENE.split("\n")[found.range.start.line].strip().startswith("a:")
            editor.write(SCENE, 2)
            assert await editor.next() == []
            editor.text_document_did_save(types.DidSaveTextDocumentParams(types.TextDocumentIdentifier(URI)))
            assert await editor.next() == []
            assert await editor.next() == [], "what is solved has nothing against it"

    asyncio.run(ask())


@pytest.mark.parametrize(
    ("stops", "text"),
    [(True, "{shape: rod, mass: ${1:3 kg}, length: ${2:20 cm}}"), (False, "{shape: rod, mass: 3 kg, length: 20 cm}")],
)
def test_snippets_are_for_editors_that_know_them(stops: bool, text: str) -> None:
    async def ask() -> None:
        async with session("bodies:\n  a: ", stops=stops) as editor:
            item = next(item for item in await editor.complete(1, 5) if item.label == "rod")
            assert isinstance(item.text_edit, types.TextEdit) and item.text_edit.new_text == text
            assert (item.insert_text_format == types.InsertTextFormat.Snippet) == stops

    asyncio.run(ask())
