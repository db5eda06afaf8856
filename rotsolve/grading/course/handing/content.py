"""Content: the bytes of a file of answers as text, or what is wrong with them."""

from __future__ import annotations

import codecs
import sys
from pathlib import Path

from rotsolve.core.faults import Fault, SceneError, Span
from rotsolve.language.words import quoted
from rotsolve.run.scenes import PIPED

BYTES = 50_000_000  # a class of a hundred thousand, with its working
MARK = "\ufeff"  # at the start of a file that a spreadsheet has saved as UTF-8
OTHER_MARKS = {codecs.BOM_UTF16_LE: "UTF-16", codecs.BOM_UTF16_BE: "UTF-16"}
SAVE = "save it as UTF-8; spreadsheets call it `CSV UTF-8`"


class HandedInError(SceneError):
    """Answers that can't be read: every fault of the file, with its place."""


def content_of(file: str) -> str:
    """The text of a file, or of standard input for `-`, with plain line breaks; a byte order mark stays in front."""
    try:
        content = sys.stdin.buffer.read(BYTES + 1) if file == PIPED else bytes_of(Path(file))
    except OSError as error:
        raise fault(f"can't read {quoted(file)}: {error.strerror or error}") from None
    if len(content) > BYTES:
        raise fault(f"the file has more than {BYTES} bytes", "split the class", file)
    return text_of(content, file).replace("\r\n", "\n").replace("\r", "\n")


def bytes_of(path: Path) -> bytes:
    with path.open("rb") as stream:
        return stream.read(BYTES + 1)


def text_of(content: bytes, file: str) -> str:
    """The bytes as UTF-8."""
    for mark, encoding in OTHER_MARKS.items():
        if content.startswith(mark):
            raise fault(f"the file is {encoding}, not UTF-8", SAVE, file)
    if b"\0" in content:
        raise fault("this is no text file: it holds a NUL byte", SAVE, file)
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        before = content[: error.start]
        line = before.count(b"\n") + 1
        start = before.rpartition(b"\n")[2].decode("utf-8")
        byte = f"the byte {content[error.start]:02X}"
        raise fault(f"{byte} is not UTF-8", SAVE, file, Span(line, len(start) + 1)) from None


def fault(message: str, help: str = "", file: str = "", span: Span | None = None) -> HandedInError:
    """The error of a file with a single fault."""
    return HandedInError([Fault(message, span, help, "file")], (), file)
