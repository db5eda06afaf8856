"""Server: the Language Server Protocol over standard input and output, by pygls; all that it tells is worked out in the other modules.

Lines count from 1 in faults and spans and from 0 in the protocol. Columns here are characters; the client may count in other units,
which the codec of its workspace translates.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterable
from functools import partial

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.workspace import PositionCodec

from rotsolve import __version__
from rotsolve.core.faults import CONTRADICTORY, INCOMPLETE, UNREACHED, UNSOLVED, Fault, Span
from rotsolve.editor.completion import offers_at
from rotsolve.editor.fixes import fixes
from rotsolve.editor.help import help_at
from rotsolve.editor.offers import Offer
from rotsolve.editor.places import OutlineEntry, declared_at, symbols
from rotsolve.editor.scene_text import SceneText
from rotsolve.editor.trial import BackgroundTrial
from rotsolve.elements.tables import SHAPES
from rotsolve.scene.elements import TABLES

PAUSE = 0.2  # seconds without a key before what is written is read
SORTS = {  # of offers, as the protocol has them
    "key": types.CompletionItemKind.Property,
    "name": types.CompletionItemKind.Variable,
    "element": types.CompletionItemKind.Struct,
    "quantity": types.CompletionItemKind.Field,
    "component": types.CompletionItemKind.Field,
    "point": types.CompletionItemKind.Reference,
    "unit": types.CompletionItemKind.Unit,
    "word": types.CompletionItemKind.Keyword,
    "function": types.CompletionItemKind.Function,
}
MILD = {  # what is no fault of the text: the scene may be right, and only not solved
    UNSOLVED: types.DiagnosticSeverity.Information,
    "not yet": types.DiagnosticSeverity.Information,
    INCOMPLETE: types.DiagnosticSeverity.Warning,
    CONTRADICTORY: types.DiagnosticSeverity.Warning,
    UNREACHED: types.DiagnosticSeverity.Warning,
}


class SceneServer(LanguageServer):
    """What is known of the open texts."""

    def __init__(self) -> None:
        super().__init__("rotsolve", __version__, text_document_sync_kind=types.TextDocumentSyncKind.Full)
        self.texts: dict[str, SceneText] = {}
        self.waiting: dict[str, asyncio.TimerHandle] = {}
        self.trial = BackgroundTrial()
        register(self)

    @property
    def codec(self) -> PositionCodec:
        return self.workspace.position_codec

    def is_open(self, uri: str) -> bool:
        """Whether a text is open, as the client names it: the workspace has its own spelling of what is written with %20."""
        return any(document.uri == uri for document in self.workspace.text_documents.values())

    def scene(self, uri: str) -> SceneText:
        """A text as it is now; of one that is not open, nothing."""
        source = self.workspace.get_text_document(uri).source if self.is_open(uri) else ""
        known = self.texts.get(uri)
        if known is None or known.whole != source:
            known = self.texts[uri] = SceneText(source)
        return known

    def position(self, uri: str, position: types.Position) -> tuple[int, int]:
        """Line and column in characters, both from 0, of a position of the client."""
        found = self.codec.position_from_client_units(self.scene(uri).lines, position)
        return found.line, found.character

    def range(self, uri: str, span: Span | None) -> types.Range:
        """A span as the client counts; that of a fault without a place is the first line."""
        lines = self.scene(uri).lines
        if span is None or not 1 <= span.line <= len(lines):
            whole = types.Range(types.Position(0, 0), types.Position(0, len(lines[0])))
            return self.codec.range_to_client_units(lines, whole)
        start, end = span.column - 1, min(span.column - 1 + span.length, len(lines[span.line - 1]))
        own = types.Range(types.Position(span.line - 1, start), types.Position(span.line - 1, max(start, end)))
        return self.codec.range_to_client_units(lines, own)

    def publish(self, uri: str, faults: Iterable[Fault]) -> None:
        """Show faults at their places."""
        shown = [self.diagnostic(uri, fault) for fault in faults]
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, shown))

    def diagnostic(self, uri: str, fault: Fault) -> types.Diagnostic:
        message = fault.message + (f"\n{fault.help}" if fault.help else "")
        severity = MILD.get(fault.kind, types.DiagnosticSeverity.Error)
        related = [
            types.DiagnosticRelatedInformation(types.Location(uri, self.range(uri, other.span)), other.note)
            for other in fault.related
        ]
        place = self.range(uri, fault.span)
        return types.Diagnostic(
            place, message, severity, code=fault.kind, source="rotsolve", related_information=related or None
        )

    def check(self, uri: str, *, solve: bool = False) -> None:
        """Read a text and show its faults; one that has none is solved if that is asked for."""
        self.forget_pause(uri)
        if not self.is_open(uri):
            return
        scene = self.scene(uri)
        self.publish(uri, scene.faults)
        if solve and scene.is_scene and not scene.faults:
            loop = asyncio.get_running_loop()
            self.trial.begin(
                scene.whole, lambda found: loop.call_soon_threadsafe(self.show_trial, uri, scene.whole, found)
            )

    def show_trial(self, uri: str, text: str, found: tuple[Fault, ...]) -> None:
        """Show what a trial has found out, if the text is still the one that was tried."""
        if self.is_open(uri) and self.scene(uri).whole == text:
            self.publish(uri, found)

    def check_soon(self, uri: str) -> None:
        """Read a text when nothing has been written for a moment."""
        self.forget_pause(uri)
        self.trial.stop()
        self.waiting[uri] = asyncio.get_running_loop().call_later(PAUSE, partial(self.check, uri))

    def forget_pause(self, uri: str) -> None:
        if (timer := self.waiting.pop(uri, None)) is not None:
            timer.cancel()


def register(server: SceneServer) -> None:
    """The features of the server."""
    server.feature(types.INITIALIZED)(on_start)
    server.feature(types.TEXT_DOCUMENT_DID_OPEN)(on_open)
    server.feature(types.TEXT_DOCUMENT_DID_CHANGE)(on_change)
    server.feature(types.TEXT_DOCUMENT_DID_SAVE)(on_save)
    server.feature(types.TEXT_DOCUMENT_DID_CLOSE)(on_close)
    options = types.CompletionOptions(trigger_characters=[".", " ", "{", "["])
    server.feature(types.TEXT_DOCUMENT_COMPLETION, options)(completion)
    server.feature(types.TEXT_DOCUMENT_HOVER)(hover)
    kinds = types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix])
    server.feature(types.TEXT_DOCUMENT_CODE_ACTION, kinds)(code_actions)
    server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)(document_symbols)
    server.feature(types.TEXT_DOCUMENT_DEFINITION)(definition_of)


def on_start(server: SceneServer, params: types.InitializedParams) -> None:
    """Load all shapes and elements, so that the first completion need not wait for them."""
    for table in (SHAPES, *(table for _, table in TABLES.values())):
        list(table)


def on_open(server: SceneServer, params: types.DidOpenTextDocumentParams) -> None:
    server.check(params.text_document.uri, solve=True)


def on_change(server: SceneServer, params: types.DidChangeTextDocumentParams) -> None:
    server.check_soon(params.text_document.uri)


def on_save(server: SceneServer, params: types.DidSaveTextDocumentParams) -> None:
    server.check(params.text_document.uri, solve=True)


def on_close(server: SceneServer, params: types.DidCloseTextDocumentParams) -> None:
    uri = params.text_document.uri
    server.forget_pause(uri)
    server.texts.pop(uri, None)
    server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))


def completion(server: SceneServer, params: types.CompletionParams) -> types.CompletionList:
    uri = params.text_document.uri
    line, column = server.position(uri, params.position)
    found, typed = offers_at(server.scene(uri), line, column)
    place = server.range(uri, Span(line + 1, column - typed + 1, typed))
    asked = server.client_capabilities.text_document
    stops = bool(asked and asked.completion and (item := asked.completion.completion_item) and item.snippet_support)
    items = [item_of(offer, place, number, stops) for number, offer in enumerate(found)]
    return types.CompletionList(is_incomplete=False, items=items)


def item_of(offer: Offer, place: types.Range, number: int, stops: bool) -> types.CompletionItem:
    """An offer in the words of the protocol, with stops of the tab key where the client knows them; offers keep their order."""
    formats = types.InsertTextFormat
    return types.CompletionItem(
        offer.word,
        kind=SORTS[offer.sort],
        documentation=types.MarkupContent(types.MarkupKind.Markdown, offer.help) if offer.help else None,
        sort_text=f"{number:04}",
        filter_text=offer.word,
        insert_text_format=formats.Snippet if offer.snippet and stops else formats.PlainText,
        text_edit=types.TextEdit(place, (offer.insert or offer.word) if stops else offer.plain),
    )


def hover(server: SceneServer, params: types.HoverParams) -> types.Hover | None:
    uri = params.text_document.uri
    found = help_at(server.scene(uri), *server.position(uri, params.position))
    if found is None:
        return None
    text, span = found
    return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, text), server.range(uri, span))


def code_actions(server: SceneServer, params: types.CodeActionParams) -> list[types.CodeAction]:
    """The fixes of faults that lie in a range."""
    uri = params.text_document.uri
    first, last = params.range.start.line, params.range.end.line
    found: list[types.CodeAction] = []
    for fix in fixes(server.scene(uri).faults):
        place = server.range(uri, fix.span)
        before = (place.end.line, place.end.character) < (first, params.range.start.character)
        beyond = (place.start.line, place.start.character) > (last, params.range.end.character)
        if not before and not beyond:
            edit = types.WorkspaceEdit(changes={uri: [types.TextEdit(place, fix.word)]})
            told = [server.diagnostic(uri, fix.fault)]
            found.append(types.CodeAction(f"Write `{fix.word}`", types.CodeActionKind.QuickFix, told, edit=edit))
    if len(found) == 1:
        found[0].is_preferred = True
    return found


def document_symbols(server: SceneServer, params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
    uri = params.text_document.uri
    return [protocol_symbol(server, uri, symbol, types.SymbolKind.Namespace) for symbol in symbols(server.scene(uri))]


def protocol_symbol(
    server: SceneServer, uri: str, symbol: OutlineEntry, kind: types.SymbolKind
) -> types.DocumentSymbol:
    lines = server.scene(uri).lines
    own = server.range(uri, symbol.span)
    end = server.range(uri, Span(symbol.last, 1, len(lines[symbol.last - 1]))).end
    inner = [protocol_symbol(server, uri, item, types.SymbolKind.Variable) for item in symbol.inner]
    return types.DocumentSymbol(
        symbol.name or "…", kind, types.Range(own.start, end), own, symbol.detail, children=inner
    )


def definition_of(server: SceneServer, params: types.DefinitionParams) -> types.Location | None:
    uri = params.text_document.uri
    span = declared_at(server.scene(uri), *server.position(uri, params.position))
    return None if span is None else types.Location(uri, server.range(uri, span))


def serve() -> None:
    """Serve until the client says that it is enough. Nothing else may write where the protocol is written."""
    server = SceneServer()
    with open(os.dup(0), "rb") as reader, open(os.dup(1), "wb") as writer:
        os.dup2(2, 1)
        try:
            server.start_io(reader, writer)
        finally:
            server.trial.end()
