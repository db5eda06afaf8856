"""Markdown: the small part of it that texts of problems may use: bold, italic, lists and images, read by markdown-it.

All else, HTML among it, is prose that stands on the page as it was typed. `fill` says what a page has for a piece of prose.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import groupby
from typing import Any
from urllib.parse import unquote

from msgspec.structs import replace

from rotsolve.page.blocks import BOLD, BOTH, ITALIC, Bullet, Bullets, PageBlock, Paragraph, Phrase, Styled
from rotsolve.page.statement_blocks import Image

Fill = Callable[[str], Phrase]
RULES = ["emphasis", "list", "image", "escape"]
STYLES = {(True, False): BOLD, (False, True): ITALIC, (True, True): BOTH}
NO_IMAGE = "write `![what it shows](picture.png)`; a name with blanks stands in `<…>`"


class NoMarkdown(ValueError):
    """What can not stand in a text: the message, the text that is meant, and what to write."""

    def __init__(self, message: str, text: str, help: str) -> None:
        super().__init__(message)
        self.text, self.help = text, help


@cache
def parser() -> Any:
    """What reads Markdown; its rules that are not named here are off."""
    from markdown_it import MarkdownIt

    return MarkdownIt("zero", {"html": False}).enable(RULES)


def marked_blocks(text: str, fill: Fill, folder: str) -> Iterator[PageBlock]:
    """The blocks of a text."""
    tokens = parser().parse(text)
    yield from TokenReader(tokens, fill, folder).blocks()


def marked_line(text: str, fill: Fill) -> Phrase:
    """A line of words, in which no image stands."""
    (inline,) = parser().parseInline(text)
    return marked_words(inline.children or (), fill)


class TokenReader:
    """Turns the tokens of a text into blocks."""

    def __init__(self, tokens: Sequence[Any], fill: Fill, folder: str) -> None:
        self.tokens, self.fill, self.folder = iter(tokens), fill, folder

    def blocks(self) -> Iterator[PageBlock]:
        for token in self.tokens:
            if token.type == "inline":
                yield from self.paragraph(token.children or ())
            elif token.type in ("bullet_list_open", "ordered_list_open"):
                items, start = self.items(token)
                yield Bullets(items, start)

    def paragraph(self, children: Sequence[Any]) -> Iterator[PageBlock]:
        """Words, with the images that stand in them below each other."""
        for image, group in groupby(children, lambda child: child.type == "image"):
            if image:
                yield from map(self.image, group)
            elif words := trimmed(marked_words([*group], self.fill)):
                yield Paragraph(words)

    def image(self, token: Any) -> Image:
        """An image, whose file is found from the folder of the scene."""
        source = unquote(str(token.attrs["src"]))
        return Image(source if "://" in source else os.path.join(self.folder, source), token.content)

    def items(self, opening: Any) -> tuple[tuple[Bullet, ...], int | None]:
        """The items of a list, and the first of their numbers."""
        found: list[Bullet] = []
        closing = opening.type.replace("open", "close")
        for token in self.tokens:
            if token.type == closing and token.level == opening.level:
                break
            if token.type == "list_item_open":
                found.append(self.item(token.level))
        start = int(opening.attrs.get("start", 1)) if opening.type.startswith("ordered") else None
        return tuple(found), start

    def item(self, level: int) -> Bullet:
        """One item, with the list within it."""
        bullet = Bullet(())
        for token in self.tokens:
            if token.type == "list_item_close" and token.level == level:
                break
            if token.type == "inline":
                words = marked_words(token.children or (), self.fill)
                bullet = replace(bullet, words=(*bullet.words, " ", *words) if bullet.words else words)
            elif token.type in ("bullet_list_open", "ordered_list_open"):
                inner, start = self.items(token)
                bullet = replace(bullet, inner=(*bullet.inner, *inner), start=start)
        return bullet


def marked_words(children: Sequence[Any], fill: Fill) -> Phrase:
    """Words with what is bold or italic in them; formulas are set as ever."""
    found: list[Any] = []
    bold = italic = False
    for child in children:
        if child.type == "image":
            message = "an image stands between paragraphs, not in a list or a line"
            raise NoMarkdown(message, child.content or "![", "put it on a line of its own, with blank lines round it")
        if child.type.startswith("strong"):
            bold = child.type == "strong_open"
        elif child.type.startswith("em"):
            italic = child.type == "em_open"
        elif "![" in child.content and child.type == "text":
            raise NoMarkdown("this is no image", "![", NO_IMAGE)
        else:
            words = fill(" ".join(child.content.split("\n")))
            style = STYLES.get((bold, italic))
            found += words if style is None else [part for word in words for part in styled_words(style, word)]
    return tuple(part for part in found if part != "")


def styled_words(style: str, word: Any) -> Iterator[Any]:
    """Prose in a style, with the blanks round it outside; all else as it is."""
    if not isinstance(word, str) or not word.strip():
        yield word
        return
    inner = word.strip()
    yield from (word[: len(word) - len(word.lstrip())], Styled(style, inner), word[len(word.rstrip()) :])


def trimmed(words: Phrase) -> Phrase:
    """Words without blanks at their ends; nothing where there are blanks alone."""
    found = list(words)
    if found and isinstance(found[0], str):
        found[0] = found[0].lstrip()
    if found and isinstance(found[-1], str):
        found[-1] = found[-1].rstrip()
    return tuple(part for part in found if part != "")
