"""XML text: what stands in the files of platforms: letters that XML can hold, decimal numbers, and the bytes of a whole file."""

from __future__ import annotations

import re
from fractions import Fraction
from io import BytesIO
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def writable(text: str) -> str:
    """A text without letters that XML can not hold."""
    return NO_XML.sub("\N{REPLACEMENT CHARACTER}", text)


def plain_decimal(value: Fraction, places: int = 7) -> str:
    """A decimal number, exact as far as its places go."""
    text = f"{float(value):.{places}f}"
    return text.rstrip("0").rstrip(".") or "0"


def xml_bytes(root: Element) -> bytes:
    """The file of an element."""
    stream = BytesIO()
    ElementTree.ElementTree(root).write(stream, "utf-8", xml_declaration=True)
    return stream.getvalue() + b"\n"
