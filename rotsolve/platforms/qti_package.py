"""QTI package: a zip with items, their images, a test that holds them in order, and the manifest that lists all of it."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from xml.etree.ElementTree import Element, SubElement

from msgspec import Struct

from rotsolve.platforms.qti import INSTANCE, SCORE, Dialect, ItemWriter, xml_file
from rotsolve.platforms.xml_text import writable

BEGINNING = (1980, 1, 1, 0, 0, 0)  # the time of all files: the same sheet gives the same bytes
TEST = "test.xml"


class PackedItem(Struct, frozen=True):
    """An item with its name, and the images that it shows."""

    identifier: str
    element: Element
    images: tuple[str, ...]

    @property
    def href(self) -> str:
        return f"items/{self.identifier}.xml"


class PackedProblem(Struct, frozen=True):
    """A problem of the test: its title, and its items, variant by variant."""

    identifier: str
    title: str
    variants: tuple[tuple[PackedItem, ...], ...]


def package(
    dialect: Dialect,
    title: str,
    problems: Sequence[PackedProblem],
    images: Mapping[str, bytes],
    rubric: str,
    writer: ItemWriter,
) -> bytes:
    """The zip; `rubric` is what is to be known before the first problem."""
    items = [item for problem in problems for variant in problem.variants for item in variant]
    content: dict[str, bytes] = {"imsmanifest.xml": xml_file(manifest(dialect, items, images))}
    content[TEST] = xml_file(assessment_test(dialect, title, problems, rubric, writer))
    content |= {item.href: xml_file(item.element) for item in items}
    content |= {f"images/{name}": image for name, image in images.items()}
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in content.items():
            entry = zipfile.ZipInfo(name, BEGINNING)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            archive.writestr(entry, data)
    return stream.getvalue()


def assessment_test(
    dialect: Dialect, title: str, problems: Iterable[PackedProblem], rubric: str, writer: ItemWriter
) -> Element:
    """The test: a section for each problem, of whose variants one is drawn."""
    test = dialect.root("assessmentTest", identifier="test", title=title)
    outcome = dialect.add(test, "outcomeDeclaration", identifier=SCORE, cardinality="single", baseType="float")
    dialect.add(dialect.add(outcome, "defaultValue"), "value", "0")
    part = dialect.add(test, "testPart", identifier="part", navigationMode="nonlinear", submissionMode="individual")
    whole = dialect.add(part, "assessmentSection", identifier="sheet", title=title, visible="true")
    if rubric:
        use = {"use": "instructions"} if dialect.hyphens else {}
        writer.wrapped(dialect.add(whole, "rubricBlock", view="candidate", **use), rubric)
    for problem in problems:
        section = dialect.add(
            whole, "assessmentSection", identifier=problem.identifier, title=problem.title, visible="true"
        )
        if len(problem.variants) > 1:
            dialect.add(section, "selection", select="1")
        for number, items in enumerate(problem.variants, 1):
            within = section
            if len(problem.variants) > 1:
                names = {"identifier": f"{problem.identifier}-{number}", "title": f"{problem.title} ({number})"}
                within = dialect.add(section, "assessmentSection", visible="false", **names)
            for item in items:
                dialect.add(within, "assessmentItemRef", identifier=item.identifier, href=item.href)
    total = dialect.add(dialect.add(test, "outcomeProcessing"), "setOutcomeValue", identifier=SCORE)
    dialect.add(dialect.add(total, "sum"), "testVariables", variableIdentifier=SCORE)
    return test


def manifest(dialect: Dialect, items: Sequence[PackedItem], images: Mapping[str, bytes]) -> Element:
    """The list of all files: the test, which depends on its items, and those on their images."""

    def named(name: str) -> str:
        return f"{{{dialect.package}}}{name}"

    root = Element(named("manifest"), identifier="manifest")
    root.set(f"{{{INSTANCE}}}schemaLocation", f"{dialect.package} {dialect.package_schema}")
    metadata = SubElement(root, named("metadata"))
    for name, value in zip(("schema", "schemaversion"), dialect.metadata, strict=True):
        SubElement(metadata, named(name)).text = value
    SubElement(root, named("organizations"))
    resources = SubElement(root, named("resources"))

    def resource(identifier: str, kind: str, href: str, needs: Iterable[str]) -> None:
        found = SubElement(resources, named("resource"), identifier=identifier, type=kind, href=href)
        SubElement(found, named("file"), href=href)
        for need in needs:
            SubElement(found, named("dependency"), identifierref=need)

    names = {image: f"image-{place}" for place, image in enumerate(images, 1)}
    resource("resource-test", dialect.resource.format("test"), TEST, [f"resource-{item.identifier}" for item in items])
    for item in items:
        needs = [names[image] for image in item.images]
        resource(f"resource-{item.identifier}", dialect.resource.format("item"), item.href, needs)
    for image, identifier in names.items():
        resource(identifier, "webcontent", writable(f"images/{image}"), ())
    return root
