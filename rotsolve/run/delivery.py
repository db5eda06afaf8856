"""Delivery: pages go to standard output as they come, or as one document to a file; messages to standard error, in the same order."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING

from rotsolve.page.formats import DATA, format_named
from rotsolve.run.attempt import BAD, SOLVED, FileOutcome, SolveRequest

if TYPE_CHECKING:
    from pathlib import Path

    from rotsolve.page.columns import TextLine

NAMED = 10  # files that were not solved, at the end of a long run
NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
FORMULA = ("=", "+", "-", "@", "\t", "\r", "＝", "＋", "－", "＠")  # with these a cell begins that is worked out


def deliver(outcomes: Iterable[FileOutcome], request: SolveRequest) -> int:
    """Write what the files gave; the worst exit code among them."""
    code, pages = SOLVED, 0
    kept, failed = list[FileOutcome](), list[str]()
    for outcome in outcomes:
        code = max(code, outcome.code)
        if not request.streams:
            kept.append(outcome)
        elif outcome.page is not None:
            write_page(outcome.page, follows=pages > 0)
            pages += 1
        if outcome.message:
            say(outcome.message, follows=bool(failed))
            failed.append(outcome.file)
    if kept:
        code = max(code, write_document(kept, request))
    if failed and len(request.files) > 1:
        say(summary(failed, len(request.files)), follows=True)
    return code


def write_page(page: str | tuple[TextLine, ...], *, follows: bool) -> None:
    """One page of text, with a rule before it where it follows another."""
    from rotsolve.page.columns import SEPARATOR, TextLine

    if isinstance(page, str):
        sys.stdout.write(f"\n{SEPARATOR}\n\n{page}" if follows else page)
    else:
        from rotsolve.page.terminal import show

        rule = (TextLine(""), TextLine(SEPARATOR, "rule"), TextLine(""))
        show((*rule, *page) if follows else page, sys.stdout)
    sys.stdout.flush()


def say(message: str, *, follows: bool) -> None:
    """A message on standard error, with a blank line before it where it follows another."""
    sys.stdout.flush()
    print(f"\n{message}" if follows else message, file=sys.stderr, flush=True)


def summary(failed: Sequence[str], total: int) -> str:
    """Which files were not solved: in a long run their messages stand far above."""
    more = f" and {len(failed) - NAMED} more" if len(failed) > NAMED else ""
    return f"{len(failed)} of {total} files not solved: {', '.join(failed[:NAMED])}{more}"


def write_document(outcomes: Sequence[FileOutcome], request: SolveRequest) -> int:
    """All that was solved as one document, to the file or to standard output; nothing where nothing was solved."""
    if not any(outcome.page for outcome in outcomes) and (not for_programs(request) or len(outcomes) == 1):
        return SOLVED
    return put_content(request.output, joined_document(outcomes, request))


def for_programs(request: SolveRequest) -> bool:
    """Whether programs read what is written, which want to know of failures too."""
    return format_named(request.format).use == DATA


def put_content(output: str | None, content: str | bytes) -> int:
    """Write to the file that is named, whole or not at all, or to standard output."""
    if output is not None:
        return write_file(output, content)
    if isinstance(content, bytes):
        sys.stdout.flush()
        sys.stdout.buffer.write(content)
    else:
        sys.stdout.write(content)
    return SOLVED


def joined_document(outcomes: Sequence[FileOutcome], request: SolveRequest) -> str | bytes:
    """All that was solved as one document; for programs, among several, also what was not."""
    chosen, bodies = format_named(request.format, request.language), []
    for outcome in outcomes:
        if isinstance(outcome.page, str):
            bodies.append(outcome.page)
        elif for_programs(request):
            from rotsolve.page.blocks import FixedPage

            failed = {"file": outcome.file, "solved": False, "kind": outcome.kind, "error": outcome.message}
            bodies.append(chosen.body(FixedPage(values=failed)))
    return chosen.file(bodies)


def write_file(name: str, content: str | bytes) -> int:
    """Write the whole content or nothing: into a new file beside the old one, which it then replaces."""
    from pathlib import Path

    path = Path(os.path.realpath(name))
    data = content.encode("utf-8") if isinstance(content, str) else content
    try:
        if path.exists() and not path.is_file():  # /dev/stdout, a named pipe
            path.write_bytes(data)
            return SOLVED
        with replacing(path) as fresh:
            fresh.write_bytes(data)
    except OSError as error:
        print(f"error: cannot write {name}: {error.strerror or error}", file=sys.stderr)
        return BAD
    return SOLVED


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A new file beside another, which it replaces when all has been written, and as which it may be read by the same; else it goes."""
    mode = path.stat().st_mode & 0o777 if path.exists() else None
    fresh = path.with_name(f".{path.name}.{os.getpid()}.new")
    try:
        yield fresh
        if mode is not None:
            fresh.chmod(mode)
        fresh.replace(path)
    except BaseException:
        with suppress(OSError):
            fresh.unlink()
        raise


def harmless(text: str) -> str:
    """The text as a spreadsheet keeps it: an apostrophe in front of what it would take for a formula, and is no number; one more where
    apostrophes stand there, so that taking one away gives the text again."""
    return f"'{text}" if text.lstrip("'").startswith(FORMULA) and not re.fullmatch(NUMBER, text) else text
