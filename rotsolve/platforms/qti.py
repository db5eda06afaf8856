"""QTI: items of Question and Test Interoperability, in version 2.1 or 3.0, which differ in names and in what wraps feedback.

An item is one part of a problem. Its boxes take bare numbers, since a response of base type float has no unit: the unit stands behind them.
Response processing compares with each known answer in turn: `equal` with an absolute tolerance, all boxes of a vector together.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from msgspec import Struct

from rotsolve.page.blocks import Math, Phrase
from rotsolve.platforms.fragments import FragmentHtml
from rotsolve.platforms.known import KnownNumbers, KnownOption, PlatformPart
from rotsolve.platforms.xml_text import plain_decimal, writable, xml_bytes

MATHML = "http://www.w3.org/1998/Math/MathML"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
CAPITAL = re.compile(r"[A-Z]")
SCORE, MOST, SAID, ANSWER = "SCORE", "MAXSCORE", "FEEDBACK", "RESPONSE"
NOT_IN_ITEMS = {"ol": ("start",), "img": ("class",)}  # attributes that HTML has and QTI 2.1 has not
LENGTH = "12"  # characters of a box


class Dialect(Struct, frozen=True):
    """A version of QTI: its namespaces, where its schema is found, the types of its resources, and how it writes names."""

    version: str
    namespace: str
    schema: str
    package: str  # the namespace of the manifest
    package_schema: str
    metadata: tuple[str, str]  # schema and its version, as a manifest tells them
    resource: str  # types of resources, with {} for item and test
    hyphens: bool  # qti-item-body for itemBody

    def tag(self, name: str) -> str:
        """The name of an element."""
        return f"{{{self.namespace}}}{f'qti-{hyphened(name)}' if self.hyphens else name}"

    def add(self, parent: Element, name: str, text: str | None = None, **attributes: str) -> Element:
        """A new element within another."""
        child = SubElement(parent, self.tag(name), self.attributes(attributes))
        child.text = None if text is None else writable(text)
        return child

    def attributes(self, attributes: dict[str, str]) -> dict[str, str]:
        """Attributes under their names."""
        return {hyphened(name) if self.hyphens else name: writable(value) for name, value in attributes.items()}

    def root(self, name: str, **attributes: str) -> Element:
        """The element of a whole file, with the place of its schema."""
        root = Element(self.tag(name), self.attributes(attributes))
        root.set(f"{{{INSTANCE}}}schemaLocation", f"{self.namespace} {self.schema}")
        return root


QTI_21 = Dialect(
    "2.1",
    "http://www.imsglobal.org/xsd/imsqti_v2p1",
    "http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd",
    "http://www.imsglobal.org/xsd/imscp_v1p1",
    "http://www.imsglobal.org/xsd/qti/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd",
    ("QTIv2.1 Package", "1.0.0"),
    "imsqti_{}_xmlv2p1",
    False,
)
QTI_30 = Dialect(
    "3.0",
    "http://www.imsglobal.org/xsd/imsqtiasi_v3p0",
    "https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqti_asiv3p0_v1p0.xsd",
    "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1",
    "https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqtiv3p0_imscpv1p2_v1p0.xsd",
    ("QTI Package", "3.0.0"),
    "imsqti_{}_xmlv3p0",
    True,
)


def hyphened(name: str) -> str:
    """responseIdentifier as response-identifier."""
    return CAPITAL.sub(lambda letter: f"-{letter[0].lower()}", name)


def xml_file(root: Element) -> bytes:
    """A file; the namespace of the root needs no prefix."""
    ElementTree.register_namespace("xsi", INSTANCE)
    spaces = {root.tag[1:].partition("}")[0]: "", MATHML: "m"}
    for uri, prefix in spaces.items():
        ElementTree.register_namespace(prefix, uri)
    return xml_bytes(root)


class ItemWriter:
    """Writes the items of one problem."""

    def __init__(self, dialect: Dialect, printer: FragmentHtml) -> None:
        self.dialect, self.printer = dialect, printer
        self.add = dialect.add

    def item(self, identifier: str, title: str, told: str, solution: str, part: PlatformPart) -> Element:
        """The item of a part."""
        language = {"{http://www.w3.org/XML/1998/namespace}lang": self.printer.code}
        item = self.dialect.root(
            "assessmentItem", identifier=identifier, title=title, adaptive="false", timeDependent="false"
        )
        item.attrib |= language
        points = part.part.points
        self.responses(item, part)
        for name, kind, value in (
            (SCORE, "float", "0"),
            (MOST, "float", plain_decimal(points)),
            (SAID, "identifier", None),
        ):
            outcome = self.add(item, "outcomeDeclaration", identifier=name, cardinality="single", baseType=kind)
            if value is not None:
                self.add(self.add(outcome, "defaultValue"), "value", value)
        body = self.add(item, "itemBody")
        self.solution(body, solution)  # 2.1 wants rubrics before all else
        self.markup(body, told)
        self.interaction(body, part)
        said = self.processing(item, part)
        for name, phrases in said:
            self.wrapped(
                self.add(item, "modalFeedback", outcomeIdentifier=SAID, identifier=name, showHide="show"),
                self.printer.sentence(*phrases),
            )
        return item

    # what is asked

    def responses(self, item: Element, part: PlatformPart) -> None:
        """What is answered, with what is right."""
        if part.numbers:
            for name, number in zip(names_of_boxes(part), part.numbers[0].numbers, strict=True):
                self.declared(item, name, "float", number)
        elif part.options:
            self.declared(item, ANSWER, "identifier", option_name(part, 0))
        else:
            self.declared(item, ANSWER, "string", None)

    def declared(self, item: Element, name: str, kind: str, right: str | None) -> None:
        response = self.add(item, "responseDeclaration", identifier=name, cardinality="single", baseType=kind)
        if right is not None:
            self.add(self.add(response, "correctResponse"), "value", right)

    def interaction(self, body: Element, part: PlatformPart) -> None:
        """The question with its fields."""
        if part.options and not part.numbers:
            choice = self.add(
                body,
                "choiceInteraction",
                responseIdentifier=ANSWER,
                shuffle=str(not part.in_words).lower(),
                maxChoices="1",
            )
            self.words(self.add(choice, "prompt"), part.asked)
            for place in part.order:
                self.words(
                    self.add(choice, "simpleChoice", identifier=option_name(part, place)), part.options[place].shown
                )
            return
        self.words(SubElement(body, self.plain("p")), part.asked)
        if not part.numbers:
            self.add(body, "extendedTextInteraction", responseIdentifier=ANSWER, expectedLines="4")
        for name, box in zip(names_of_boxes(part), part.boxes, strict=True) if part.numbers else ():
            line = SubElement(body, self.plain("p"))
            self.words(line, (Math((box.symbol, "=")), " "))
            field = self.add(line, "textEntryInteraction", responseIdentifier=name, expectedLength=LENGTH)
            if box.unit.text:
                field.tail = " "
                self.markup(line, self.printer.math(self.printer.unit(box.unit)))

    def solution(self, body: Element, solution: str) -> None:
        """The solution, for those who mark."""
        use = {"use": "scoring"} if self.dialect.hyphens else {}
        self.wrapped(self.add(body, "rubricBlock", view="scorer tutor", **use), solution)

    # how it is marked

    def processing(self, item: Element, part: PlatformPart) -> list[tuple[str, tuple[Phrase, ...]]]:
        """The rules by which an answer has its score; the feedback that they show, by its names."""
        processing = self.add(item, "responseProcessing")
        known: Sequence[KnownNumbers | KnownOption] = part.numbers or part.options
        if not known:
            return []
        condition = self.add(processing, "responseCondition")
        said: list[tuple[str, tuple[Phrase, ...]]] = []
        for place, one in enumerate(known):
            rule = self.add(condition, "responseElseIf" if place else "responseIf")
            if part.numbers:
                self.numbers_equal(rule, part, place)
            else:
                self.chosen(rule, part, place)
            share = one.share if place or part.numbers else Fraction(1)
            self.outcome(rule, SCORE, "float", plain_decimal(share * part.part.points))
            if one.said:
                said.append((f"SAID_{place}", one.said))
                self.outcome(rule, SAID, "identifier", said[-1][0])
        return said

    def outcome(self, rule: Element, name: str, kind: str, value: str) -> None:
        self.add(self.add(rule, "setOutcomeValue", identifier=name), "baseValue", value, baseType=kind)

    def numbers_equal(self, rule: Element, part: PlatformPart, place: int) -> None:
        """Whether the numbers of all boxes are those that are known."""
        known = part.numbers[place]
        all_of = self.add(rule, "and") if len(part.boxes) > 1 else rule
        for name, number, margin in zip(names_of_boxes(part), known.numbers, known.margins, strict=True):
            mode = (
                {"toleranceMode": "absolute", "tolerance": f"{margin} {margin}"}
                if float(margin)
                else {"toleranceMode": "exact"}
            )
            equal = self.add(all_of, "equal", **mode)
            self.add(equal, "variable", identifier=name)
            self.add(equal, "baseValue", number, baseType="float")

    def chosen(self, rule: Element, part: PlatformPart, place: int) -> None:
        match = self.add(rule, "match")
        self.add(match, "variable", identifier=ANSWER)
        self.add(match, "baseValue", option_name(part, place), baseType="identifier")

    # HTML

    def plain(self, name: str) -> str:
        """An element of HTML, which stands in the namespace of QTI."""
        return f"{{{self.dialect.namespace}}}{name}"

    def wrapped(self, parent: Element, html: str) -> None:
        """HTML within an element that holds some; in 3.0 within one more."""
        self.markup(self.add(parent, "contentBody") if self.dialect.hyphens else parent, html)

    def words(self, parent: Element, phrase: Phrase) -> None:
        """Words with mathematics."""
        paragraph = ElementTree.fromstring(f"<div>{self.printer.sentence(phrase)}</div>")[0]
        self.moved(parent, paragraph)

    def markup(self, parent: Element, html: str) -> None:
        """HTML at the end of an element."""
        self.moved(parent, ElementTree.fromstring(f"<div>{html}</div>"))

    def moved(self, parent: Element, source: Element) -> None:
        """What stands in an element of HTML, at the end of an element of QTI."""
        text = source.text or ""
        if len(parent):
            parent[-1].tail = (parent[-1].tail or "") + text
        elif text:
            parent.text = (parent.text or "") + text
        for child in source:
            parent.append(self.renamed(child, self.dialect.namespace))

    def renamed(self, source: Element, space: str) -> Element:
        """An element of HTML with its namespace; the rows of a table stand in a body, as QTI wants them."""
        space = MATHML if source.tag == "math" else space
        kept = {name: value for name, value in source.attrib.items() if name not in NOT_IN_ITEMS.get(source.tag, ())}
        found = Element(f"{{{space}}}{source.tag}", kept)
        within = SubElement(found, f"{{{space}}}tbody") if source.tag == "table" else found
        within.text, found.tail = source.text, source.tail
        within.extend(self.renamed(child, space) for child in source)
        return found


def names_of_boxes(part: PlatformPart) -> Sequence[str]:
    """The names of the responses: RESPONSE, or one for each component."""
    if len(part.boxes) == 1:
        return (ANSWER,)
    return [f"{ANSWER}_{place}" for place in range(1, len(part.boxes) + 1)]


def option_name(part: PlatformPart, place: int) -> str:
    """The name of an option, which a page may show to who looks for it: it tells no more than the order."""
    return f"OPTION_{part.order.index(place) + 1}"
