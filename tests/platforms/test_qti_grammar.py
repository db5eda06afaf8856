"""The grammars of QTI: what they refuse, and that they hold nothing but what our packages hold."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

import pytest

from pages import FALL
from platform_rules import all_named, read_package
from qti_schemas import SCHEMAS, VERSIONS, package_faults
from rotsolve.platforms.qti_files import QtiFiles
from sheets_made import ROOT, made, sheets_of

MATHML = "{http://www.w3.org/1998/Math/MathML}"
ITEM, TEST, MANIFEST = "items/p1a.xml", "test.xml", "imsmanifest.xml"
DECLARED = [f"{{http://www.w3.org/2001/XMLSchema}}{kind}" for kind in ("element", "attribute")]
SHEET = """\
sheet: All that a page can hold
instructions: Take $g = 9.8\\,\\mathrm{m/s^2}$ on *every* page.
problems:
  - fall.yaml
  - PROBLEMS/inside-a-body/falling-chimney.yaml
  - PROBLEMS/space/link-between-two-cranks.yaml
  - PROBLEMS/angular-momentum/momentum-as-a-function-of-time.yaml
  - PROBLEMS/kinematics/plate-moved-by-machine.yaml
"""  # all kinds of answers, matrices, dots, integrals
AUTHORED = """\
text: |
  A bucket of mass {m} hangs from a rope on a disc of mass {value of M}, **not *slipping***, theta is {theta0}.

  3. Draw the forces:
     - of the bucket,
     - of the disc.
  4. How *fast* does it fall?

  ![A winch](winch.svg)
"""


@cache
def packages() -> dict[str, dict[str, bytes]]:
    """The files of the packages of a problem."""
    found = made(QtiFiles(4, "en"), sheets_of(str(ROOT / "problems/pulleys/block-on-disc.yaml")))
    return {name: read_package(content) for name, content in found.items()}


def first(root: Element, name: str) -> Element:
    return all_named(root, name)[0]


def beside(element: Element, name: str) -> str:
    """The name of an element of HTML, in the namespace of another one."""
    return f"{element.tag.partition('}')[0]}}}{name}"


def reversed_children(element: Element) -> None:
    element[:] = [*element][::-1]


def renamed(element: Element, name: str, value: str) -> None:
    """Another value of an attribute, under the name that it has in the version."""
    key = next(key for key in element.attrib if key.replace("-", "").lower() == name.lower())
    element.set(key, value)


def bare_feedback(feedback: Element) -> None:
    """What is said straight in the feedback in 3.0, and in a body in 2.1: as the other version has it."""
    if feedback.tag.endswith("qti-modal-feedback"):
        feedback[:] = [*feedback[0]]
    else:
        SubElement(feedback, beside(feedback, "contentBody"))


WRONG: dict[str, tuple[str, Callable[[Element], object]]] = {
    "an element": (ITEM, lambda root: SubElement(first(root, "p"), beside(root, "br"))),
    "an element of HTML in another namespace": (ITEM, lambda root: SubElement(first(root, "p"), f"{MATHML}b")),
    "a block in a line": (ITEM, lambda root: SubElement(first(root, "p"), beside(root, "p"))),
    "a line in the body": (ITEM, lambda root: SubElement(first(root, "itemBody"), beside(root, "b"))),
    "text in the body": (ITEM, lambda root: setattr(first(root, "itemBody"), "text", "How fast?")),
    "rows without a body": (ITEM, lambda root: SubElement(first(root, "table"), beside(root, "tr"))),
    "a table without rows": (ITEM, lambda root: first(root, "table").clear()),
    "an attribute": (ITEM, lambda root: first(root, "img").set("class", "wide")),
    "an image without words": (ITEM, lambda root: first(root, "img").attrib.pop("alt")),
    "an item without a title": (ITEM, lambda root: root.attrib.pop("title")),
    "an identifier with a blank": (ITEM, lambda root: root.set("identifier", "p 1")),
    "an order of parts": (ITEM, reversed_children),
    "an answer twice": (ITEM, lambda root: root.insert(0, first(root, "responseDeclaration"))),
    "a field of nothing": (
        ITEM,
        lambda root: renamed(first(root, "textEntryInteraction"), "responseIdentifier", "OTHER"),
    ),
    "a rule of nothing": (ITEM, lambda root: renamed(first(root, "variable"), "identifier", "OTHER")),
    "an outcome of nothing": (ITEM, lambda root: renamed(first(root, "setOutcomeValue"), "identifier", "OTHER")),
    "a kind of number": (ITEM, lambda root: renamed(first(root, "responseDeclaration"), "baseType", "real")),
    "a tolerance of one number": (ITEM, lambda root: renamed(first(root, "equal"), "tolerance", "0.1")),
    "a tolerance of words": (ITEM, lambda root: renamed(first(root, "equal"), "tolerance", "a b")),
    "a comparison of one": (ITEM, lambda root: first(root, "equal").remove(first(root, "variable"))),
    "feedback as in the other version": (ITEM, lambda root: bare_feedback(first(root, "modalFeedback"))),
    "a view": (ITEM, lambda root: first(root, "rubricBlock").set("view", "student")),
    "a fraction of three": (ITEM, lambda root: SubElement(first(root, "mfrac"), f"{MATHML}mn")),
    "an element of mathematics": (ITEM, lambda root: SubElement(first(root, "mrow"), f"{MATHML}mstyle")),
    "an attribute of mathematics": (ITEM, lambda root: first(root, "mo").set("stretchy", "true")),
    "a width without a unit": (ITEM, lambda root: first(root, "mspace").set("width", "0.2")),
    "a section twice": (TEST, lambda root: renamed(first(root, "testPart"), "identifier", "sheet")),
    "a mode": (TEST, lambda root: renamed(first(root, "testPart"), "navigationMode", "free")),
    "a test without a part": (TEST, lambda root: root.remove(first(root, "testPart"))),
    "an item without a file": (TEST, lambda root: first(root, "assessmentItemRef").attrib.pop("href")),
    "an order of the manifest": (MANIFEST, reversed_children),
    "an order of a resource": (MANIFEST, lambda root: reversed_children(first(root, "resource"))),
    "what needs nothing that is there": (
        MANIFEST,
        lambda root: first(root, "dependency").set("identifierref", "resource-9"),
    ),
    "a name twice": (MANIFEST, lambda root: first(root, "resource").set("identifier", "manifest")),
    "a kind of resource": (MANIFEST, lambda root: first(root, "resource").set("type", "imsqti_test_xmlv2p2")),
    "another schema": (MANIFEST, lambda root: setattr(first(root, "schema"), "text", "IMS Content")),
}


@pytest.mark.parametrize("package", VERSIONS)
@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_wrong_is_refused(package: str, wrong: str) -> None:
    files = packages()[package]
    assert package_faults(package, files) == []
    name, change = WRONG[wrong]
    root = ElementTree.fromstring(files[name])
    change(root)
    assert package_faults(package, files | {name: ElementTree.tostring(root)})


@pytest.mark.parametrize(("package", "taken"), [("qti21.zip", False), ("qti30.zip", True)])
def test_where_rubrics_stand(package: str, taken: bool) -> None:
    """In 2.1 before all else in an item, in 3.0 anywhere."""
    files = packages()[package]
    root = ElementTree.fromstring(files[ITEM])
    body, rubric = first(root, "itemBody"), first(root, "rubricBlock")
    assert body[0] is rubric
    body[:] = [*body[1:], rubric]
    assert (package_faults(package, files | {ITEM: ElementTree.tostring(root)}) == []) == taken


def test_the_grammars_hold_nothing_else(tmp_path: Path) -> None:
    """Each element and attribute of the grammars stands in a sheet that has all that a page can hold, with variants."""
    told = re.sub(r"text: >\n.*?(?=given)", lambda _: AUTHORED, FALL, flags=re.DOTALL)
    (tmp_path / "fall.yaml").write_text(told, encoding="utf-8")
    (tmp_path / "winch.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', encoding="utf-8")
    (tmp_path / "sheet.yaml").write_text(SHEET.replace("PROBLEMS", str(ROOT / "problems")), encoding="utf-8")
    found = made(QtiFiles(4, "en"), sheets_of(str(tmp_path / "sheet.yaml"), variants=2))
    for package, version in VERSIONS.items():
        written = set()
        for name, content in read_package(found[package]).items():
            for element in ElementTree.fromstring(content).iter() if name.endswith(".xml") else ():
                written |= {last(element.tag), *map(last, element.attrib)}
        known = set()
        for name in ("mathml", "html", "common", f"qti{version}", f"manifest{version}"):
            parts = ElementTree.parse(SCHEMAS / f"{name}.xsd").iter()
            known |= {part.get("name") or last(part.attrib["ref"]) for part in parts if part.tag in DECLARED}
        assert written == known | {"schemaLocation"}


def last(name: str) -> str:
    """A name without its namespace."""
    return re.split("[}:]", name)[-1]
