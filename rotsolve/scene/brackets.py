"""Brackets: which bracket of a file that is no YAML is never closed, closes nothing or is closed by another one.

The parser finds out only where something stands that can't, which may be lines below; here a line that begins a new name, indented no
further than the line of the bracket, ends what the bracket holds.
"""

from __future__ import annotations

import re

from msgspec import Struct

from rotsolve.core.faults import Fault, Related, Span
from rotsolve.scene.traps import UNQUOTE

CLOSING = {"{": "}", "[": "]"}
OPENING = {closing: opening for opening, closing in CLOSING.items()}
HEAD = re.compile(r"(?P<indent>\s*)(?:-\s+)*(?:[^\s#'\"\[\]{},][^#\[\]{}\"]*?:(?:\s+|$))?")
NEW_NAME = re.compile(r"\s*(?:-\s+)?[^\s\[\]{},#'\":][^\[\]{},#]*?:(?:\s|$)")
COMMENT = re.compile(r"(?:^|\s)#.*$")


class Bracket(Struct, frozen=True):
    """An opening bracket, with its line and column from 0, and how far its line is indented."""

    mark: str
    line: int
    column: int
    indent: int

    @property
    def span(self) -> Span:
        return Span(self.line + 1, self.column + 1)


def bracket_fault(lines: tuple[str, ...]) -> Fault | None:
    """The fault of the first bracket that has no other; None where all fit."""
    whole, scan = BracketScan(lines, by_indent=False), BracketScan(lines, by_indent=True)
    whole.run()
    scan.run()
    if whole.fault is None and not whole.open and not scan.quote:
        return None
    return scan.fault or (scan.never_closed(len(lines)) if scan.open else whole.fault)


class BracketScan:
    """Goes through the lines with the brackets that are open; ends at the first fault."""

    def __init__(self, lines: tuple[str, ...], *, by_indent: bool) -> None:
        self.lines = lines
        self.by_indent = by_indent
        self.open: list[Bracket] = []
        self.fault: Fault | None = None
        self.quote = ""  # the quotation mark within which the scan is, and where it begins
        self.quoted = Bracket("", 0, 0, 0)
        self.block = -1  # how far the line is indented whose text goes on below

    def run(self) -> None:
        for number, line in enumerate(self.lines):
            if self.fault is not None:
                return
            indent = len(line) - len(line.lstrip())
            if not line.strip() or line.lstrip().startswith("#"):
                continue
            if self.block >= 0 and indent > self.block:
                continue
            self.block = -1
            if self.by_indent and self.quote and indent <= self.quoted.indent and NEW_NAME.match(line):
                self.fault = Fault("a quotation mark that is never closed", self.quoted.span, UNQUOTE, "yaml")
                return
            if self.by_indent and self.open and indent <= self.open[-1].indent and NEW_NAME.match(line):
                self.fault = self.never_closed(number)
                return
            self.read(number, line, indent)

    def read(self, number: int, line: str, indent: int) -> None:
        """One line: from where a value in brackets or quotes begins."""
        start = 0
        if not self.open and not self.quote:
            head = HEAD.match(line)
            start = head.end() if head is not None else indent
            value = line[start:]
            if value[:1] in ("|", ">"):
                self.block = indent
            if value[:1] not in (*CLOSING, "'", '"'):
                self.plain(number, start, COMMENT.sub("", value))
                return
        self.flow(number, line, start, indent)

    def plain(self, number: int, start: int, value: str) -> None:
        """A text without brackets round it that has names in it and ends with a bracket: its opening one is missing."""
        closing = value.rstrip()[-1:]
        if (
            closing in OPENING
            and value.count(closing) > value.count(OPENING[closing])
            and ("," in value or ": " in value)
        ):
            span = Span(number + 1, start + len(value.rstrip()))
            first = value.split()[0].rstrip(":,")
            help = f"write `{OPENING[closing]}` in front of `{first}`"
            begin = Related(Span(number + 1, start + 1), f"`{OPENING[closing]}` is missing here")
            self.fault = Fault(f"`{closing}` closes nothing", span, help, "yaml", related=(begin,))

    def flow(self, number: int, line: str, start: int, indent: int) -> None:
        """What stands in brackets or quotes; behind them a line has nothing but a comment."""
        place = start
        while place < len(line) and self.fault is None:
            letter = line[place]
            if self.quote:
                place += self.within_quotes(line, place)
                continue
            if letter == "#" and line[place - 1 : place] in ("", " ", "\t"):
                return
            if letter in ("'", '"') and line[:place].rstrip()[-1:] in ("", ",", ":", "{", "[", "-"):
                self.quote, self.quoted = letter, Bracket(letter, number, place, indent)
            elif letter in CLOSING:
                self.open.append(Bracket(letter, number, place, indent))
            elif letter in OPENING:
                self.close(letter, number, place, line)
            place += 1

    def within_quotes(self, line: str, place: int) -> int:
        """How many letters on the scan goes within a quotation, which `''` or a backslash do not end."""
        pair = line[place : place + 2]
        if pair == "''" == self.quote * 2 or (self.quote == '"' and pair[:1] == "\\"):
            return 2
        if line[place] == self.quote:
            self.quote = ""
        return 1

    def close(self, letter: str, number: int, place: int, line: str) -> None:
        """A closing bracket: of the last that is open, or a fault."""
        if self.open and CLOSING[self.open[-1].mark] == letter:
            self.open.pop()
            return
        span, last = Span(number + 1, place + 1), self.open[-1] if self.open else None
        if last is None:
            self.fault = Fault(f"`{letter}` closes nothing", span, "leave it out", "yaml")
        elif any(CLOSING[bracket.mark] == letter for bracket in self.open):
            wanted = CLOSING[last.mark]
            here = Related(span, f"`{wanted}` is missing before this")
            help = f"write `{wanted}{letter}`, or leave `{last.mark}` out"
            self.fault = Fault(f"`{last.mark}` is never closed", last.span, help, "yaml", related=(here,))
        elif CLOSING[last.mark] in line[place + 1 :]:
            help = f"write `{OPENING[letter]}` where the list begins, or leave it out"
            self.fault = Fault(f"`{letter}` closes nothing", span, help, "yaml")
        else:
            here = Related(last.span, f"`{last.mark}` opens here")
            message, help = f"`{letter}` can't close `{last.mark}`", f"write `{CLOSING[last.mark]}`"
            self.fault = Fault(message, span, help, "yaml", related=(here,))

    def never_closed(self, before: int) -> Fault:
        """The fault of the last bracket that is open where a line begins that it can't hold, or the file ends."""
        last = self.open[-1]
        kept = [number for number in range(last.line, before) if COMMENT.sub("", self.lines[number]).strip()]
        end = COMMENT.sub("", self.lines[kept[-1]]).rstrip()
        ended = (
            [bracket for bracket in self.open if bracket.indent >= last.indent]
            if before < len(self.lines)
            else self.open
        )
        missing = "".join(CLOSING[bracket.mark] for bracket in reversed(ended))
        place = Related(Span(kept[-1] + 1, len(end) + 1), f"`{missing}` is missing here")
        help = f"write `{missing}` at the end of line {kept[-1] + 1}"
        return Fault(f"`{last.mark}` is never closed", last.span, help, "yaml", related=(place,))
