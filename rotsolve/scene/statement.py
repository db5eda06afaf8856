"""Statement: the text of a problem as it is written: prose with a small Markdown, formulas of TeX between dollar signs, and slots:
`{m}` stands for a given with its value, `m = 2 kg`, and `{value of m}` for `2 kg` alone.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.core.faults import Span
from rotsolve.language.problem import Wording
from rotsolve.language.words import hint, quoted
from rotsolve.scene.scope import UNKNOWN, Scope
from rotsolve.scene.tree import Node, Text

if TYPE_CHECKING:
    from rotsolve.page.blocks import PageBlock, Phrase
    from rotsolve.page.statement_blocks import Image

PIECES = re.compile(
    r"(?P<dollar>\\\$)|\{\{|\}\}|(?P<tex>\$(?=\S)(?:[^$\\\n]|\\.|\n(?!\s*\n))*?(?<=\S)\$(?!\d))|\{(?P<inner>[^{}]*)\}"
)
OPEN = re.compile(r"(?<![\w$\\])\$(?=[A-Za-z\\])")  # a formula seems to begin
MARKED = re.compile(r"[*\\]|(?<!\w)_|!\[|^\s*(?:[-+]|\d+[.)])\s", re.MULTILINE)  # what Markdown may read
LISTED = re.compile(r"\s*(?:[-+*]|\d+[.)])\s|\s{2}")
HELD = 0xE000  # letters from here on, which no language uses, stand for the formulas and slots of a text
HELD_LETTER = re.compile("([\ue000-\uf8ff])")
ALONE = "value of "
KINDS = (".png", ".jpg", ".jpeg", ".svg")


class Slot(Struct, frozen=True):
    """A place in the text where a given is told: with its letter, or by its value `alone`; `text` is the place as written."""

    name: str
    alone: bool
    text: str


class Tex(Struct, frozen=True):
    """A formula of TeX, without the dollar signs round it."""

    tex: str


Filler = Callable[["str | Slot | Tex"], "Phrase"]  # what a page says for prose, a slot or a formula


def prose_and_slots(text: str) -> Iterator[str | Slot | Tex]:
    """The text in pieces of prose, formulas and slots; `{{` and `}}` are braces."""
    position = 0
    for match in PIECES.finditer(text):
        yield text[position : match.start()]
        position = match.end()
        if match["tex"] is not None:
            yield Tex(match["tex"][1:-1])
        elif match["inner"] is not None:
            words = " ".join(match["inner"].split())
            yield Slot(words.removeprefix(ALONE), words.startswith(ALONE), match[0])
        else:
            yield match[0][-1] if match["dollar"] is None else r"\$"
    yield text[position:]


def slots(text: str) -> Iterator[Slot]:
    """The slots of a text."""
    return (part for part in prose_and_slots(text) if isinstance(part, Slot))


def statement_blocks(text: str, said: Filler, folder: str = "") -> Iterator[PageBlock]:
    """The paragraphs, lists and images of a text, with what is `said` in them; files of images are found from the `folder`."""
    whole, pieces = held_apart(text)
    fill = with_pieces(said, pieces)
    if MARKED.search(whole):
        from rotsolve.scene.markdown import marked_blocks  # few texts have any

        yield from marked_blocks("\n\n".join(paragraphs(whole, keep=True)), fill, folder)
        return
    from rotsolve.page.blocks import Paragraph

    yield from (Paragraph(fill(paragraph)) for paragraph in paragraphs(whole))


def wording_phrase(text: str, said: Filler) -> Phrase:
    """A line of words, as the title of a problem or what it asks: Markdown that stands within a line."""
    whole, pieces = held_apart(text)
    fill = with_pieces(said, pieces)
    line = " ".join(whole.split())
    if not MARKED.search(line):
        return fill(line)
    from rotsolve.scene.markdown import marked_line

    return marked_line(line, fill)


def held_apart(text: str) -> tuple[str, list[Slot | Tex]]:
    """The text with a letter for each formula and slot, and these."""
    pieces: list[Slot | Tex] = []
    found = []
    for piece in prose_and_slots(HELD_LETTER.sub("\N{REPLACEMENT CHARACTER}", text)):
        if not isinstance(piece, str):
            found.append(chr(HELD + len(pieces)))
            pieces.append(piece)
        else:
            found.append(piece)
    return "".join(found), pieces


def with_pieces(said: Filler, pieces: list[Slot | Tex]) -> Callable[[str], Phrase]:
    """What fills prose in which letters stand for formulas and slots."""

    def fill(prose: str) -> Phrase:
        parts = (pieces[ord(part) - HELD] if HELD_LETTER.fullmatch(part) else part for part in HELD_LETTER.split(prose))
        return tuple(item for part in parts if part for item in said(part))

    return fill


def paragraphs(text: str, keep: bool = False) -> list[str]:
    """The paragraphs of a text: blank lines stand between them where there are any, else each line is one, as YAML folds them.

    To `keep` their lines is for lists, of which every line stands by itself without a blank one.
    """
    if re.search(r"\n\s*\n", text):
        pieces = re.split(r"\n\s*\n", text)
        return (
            [piece.rstrip() for piece in pieces]
            if keep
            else [" ".join(piece.split()) for piece in pieces if piece.strip()]
        )
    lines = [line.rstrip() if keep else " ".join(line.split()) for line in text.split("\n") if line.strip()]
    if not keep:
        return lines
    joined: list[str] = []
    for line in lines:
        if joined and LISTED.match(line):
            joined[-1] += f"\n{line}"
        else:
            joined.append(line)
    return joined


# reading, with all faults at their places


def read_wordings(
    scope: Scope, node: Node, asked: Iterable[str], lines: tuple[str, ...], file: str
) -> tuple[Wording, ...]:
    """How answers are asked for, in the order of the file."""
    found = []
    for name, (_, item) in scope.entries(node, "`ask`", asked).items():
        if isinstance(item, Text):
            check_text(scope, item, lines, f"the wording of `{name}`", file, in_line=True)
            found.append(Wording(name, item.value.strip(), item.span))
        else:
            scope.fault(item, f"the wording of `{name}` wants a text", "put it in quotes", "form")
    return tuple(found)


def check_text(
    scope: Scope, node: Node, lines: tuple[str, ...], what: str, file: str, *, in_line: bool = False
) -> None:
    """A fault for each slot that names no given, each formula that is not understood, and each image that is not there."""
    if not isinstance(node, Text):
        return
    names = scope.names("given")
    for piece in prose_and_slots(node.value):
        if isinstance(piece, Slot) and piece.name not in names:
            place = written_at(piece.text, node, lines)
            message, help = f"{quoted(piece.text)} in {what} names no given", hint(piece.name, names, "givens")
            scope.fault(place, message, help, "unknown", cause=f"{UNKNOWN}{piece.name}")
        elif isinstance(piece, Tex):
            check_formula(scope, piece.tex, node, lines)
        elif isinstance(piece, str) and (start := OPEN.search(piece)):
            place = written_at(piece[start.start() :].split("\n")[0][:20], node, lines)
            closing = r"close it with another `$`, or write `\$` for the sign itself"
            scope.fault(place, f"a formula begins in {what} and does not end", closing, "formula")
    if "![" in node.value or (MARKED.search(node.value) and in_line):
        check_images(scope, node, lines, what, file, in_line)


def check_formula(scope: Scope, tex: str, node: Text, lines: tuple[str, ...]) -> None:
    """A fault at the place in a formula that is not understood."""
    from rotsolve.scene.tex import UNDERSTOOD, tex_phrase

    try:
        tex_phrase(tex)
    except FormulaError as error:
        place = written_at(f"${tex}$", node, lines)
        if place is not node.span:
            place = Span(place.line, place.column + 1 + error.start, max(1, error.end - error.start))
        help = f"did you mean `{error.suggestion}`? {UNDERSTOOD}" if error.suggestion else UNDERSTOOD
        scope.fault(place, f"the formula {quoted(f'${tex}$')}: {error.message}", help, "formula")


def check_images(scope: Scope, node: Text, lines: tuple[str, ...], what: str, file: str, in_line: bool) -> None:
    """A fault for each image that is none."""
    from rotsolve.page.statement_blocks import Image
    from rotsolve.scene.markdown import NoMarkdown

    def plainly(piece: str | Slot | Tex) -> Phrase:
        return (piece,) if isinstance(piece, str) else ()

    try:
        if in_line:
            wording_phrase(node.value, plainly)
            return
        for block in statement_blocks(node.value, plainly, os.path.dirname(file)):
            if isinstance(block, Image) and (wrong := fault_of_image(block)):
                place = written_at(os.path.basename(block.path), node, lines)
                scope.fault(
                    place,
                    wrong,
                    "write `![what it shows](picture.png)`, the file as seen from the scene's folder",
                    "file",
                )
    except NoMarkdown as error:
        scope.fault(written_at(error.text, node, lines), f"{error} in {what}", error.help, "form")


def fault_of_image(image: Image) -> str:
    """What is wrong with an image; '' where nothing is."""
    folder, file = os.path.split(image.path)
    name = quoted(file)
    if not image.alt.strip():
        return f"the image {name} has no words for those who do not see it"
    if "://" in image.path:
        return f"{quoted(image.path)} is no file: nothing is fetched from a network"
    if os.path.splitext(file)[1].lower() not in KINDS:
        return f"the image {name} is of no kind that every format can print: {', '.join(KINDS)}"
    if not os.path.isfile(image.path):
        return f"there is no image {name} in {quoted(folder or os.curdir)}"
    return (
        ""
        if image.content() is not None
        else f"{name} holds no image, or one of more than {image.most // 1_000_000} MB"
    )


def written_at(snippet: str, node: Text, lines: tuple[str, ...]) -> Span:
    """Where something of a text stands in its file; a text over several lines is searched for it."""
    found = ((number, line.find(snippet)) for number, line in enumerate(lines, 1) if number >= node.span.line)
    return next((Span(number, at + 1, len(snippet)) for number, at in found if at >= 0), node.span)
