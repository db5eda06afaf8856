"""Encoding: the bytes of a file as text; what is no UTF-8 is refused at its byte, with the encoding that it seems to be in."""

from __future__ import annotations

from rotsolve.core.faults import Fault, SceneError, Span

MARKS = {  # by the bytes that a file in it begins with; the longer ones first
    b"\xff\xfe\0\0": "UTF-32",
    b"\0\0\xfe\xff": "UTF-32",
    b"\xff\xfe": "UTF-16",
    b"\xfe\xff": "UTF-16",
}
SAVE = "save the file as UTF-8"
LOOKED_AT = 1000  # bytes at the beginning that tell UTF-16 without its mark


def decoded(content: bytes, file: str, help: str = SAVE) -> str:
    """The text of a file, its byte order mark still in front. Raises SceneError for what is no text in UTF-8."""
    encoding = next((name for mark, name in MARKS.items() if content.startswith(mark)), "") or without_mark(content)
    if encoding:
        raise SceneError([Fault(f"the file is {encoding}, not UTF-8", None, help, "file")], (), file)
    if b"\0" in content:
        raise SceneError([Fault("this is no text file: it holds a NUL byte", None, help, "file")], (), file)
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        place, lines = span_of_byte(content, error.start), content.decode("latin-1").split("\n")
        message, lines[place.line - 1] = told_byte(content, error.start)
        raise SceneError([Fault(message, place, help, "file")], lines, file) from None


def without_mark(content: bytes) -> str:
    """UTF-16 where it has no mark: of a text in letters of the West every other byte is nothing; '' of all else."""
    begin = content[:LOOKED_AT]
    nothing = [begin[side::2].count(0) for side in (0, 1)]
    return "UTF-16" if len(begin) > 3 and max(nothing) > 0.4 * len(begin) and min(nothing) == 0 else ""


def span_of_byte(content: bytes, place: int) -> Span:
    """Line and column of a byte before which all is UTF-8."""
    before = content[:place].decode("utf-8", errors="replace").removeprefix("\ufeff")
    return Span(before.count("\n") + 1, len(before.rpartition("\n")[2]) + 1)


def told_byte(content: bytes, place: int) -> tuple[str, str]:
    """What a byte is that begins no letter of UTF-8, and its line as it would be read.

    Windows-1252 is Latin-1 with letters more: what no byte of the file uses of it, it is called by its plainer name.
    """
    start, end = content.rfind(b"\n", 0, place) + 1, content.find(b"\n", place)
    line = content[start : end if end >= 0 else None]
    byte = content[place : place + 1]
    encoding = "cp1252" if any(0x80 <= code <= 0x9F for code in content) else "latin-1"
    letter = byte.decode(encoding, errors="replace")
    name = "Windows-1252" if encoding == "cp1252" else "Latin-1"
    seems = f": in {name} it is `{letter}`" if letter.isprintable() and letter != "\ufffd" else ""
    prefix = line[: place - start].decode("utf-8", errors="replace")
    rest = line[place - start :].decode(encoding, errors="replace")
    return f"the byte {byte[0]:02X} is not UTF-8{seems}", f"{prefix}{rest}"
