"""The grammars of the packages that rotsolve writes, QTI 2.1 and 3.0: XSD files of our own in `schemas`, which libxml2 holds files against.

An element, attribute or value that rotsolve does not write yet is a fault: whoever adds one reads the standard, and widens the
grammar. It may allow less than the standard, never more.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from lxml import etree

SCHEMAS = Path(__file__).parent / "schemas"
VERSIONS = {"qti21.zip": "21", "qti30.zip": "30"}


@cache
def grammar(name: str) -> etree.XMLSchema:
    return etree.XMLSchema(etree.parse(SCHEMAS / f"{name}.xsd"))


def schema_faults(content: bytes, name: str) -> list[str]:
    """What breaks the grammar of that name, with the lines."""
    schema = grammar(name)
    return [] if schema.validate(etree.fromstring(content)) else [str(one) for one in schema.error_log]


def package_faults(package: str, files: dict[str, bytes]) -> list[str]:
    """What breaks the grammars of its version in a package: its manifest, its test, and its items."""
    version, found = VERSIONS[package], []
    for name, content in files.items():
        if name.endswith(".xml"):
            kind = "manifest" if name == "imsmanifest.xml" else "qti"
            found += [f"{name}: {fault}" for fault in schema_faults(content, f"{kind}{version}")]
    return found
