"""The rules of QTI 2.1 and 3.0 that our files have to keep, as a table written from the text of the information models.

Of each element: the attributes that it must have and those that it may have besides, and its children in order, as a regular expression of
their names. Names are those of 2.1; 3.0 writes them with hyphens, and wraps the content of feedback and rubrics in a content body.
"""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

from platform_rules import local, of_21

MATHML = "http://www.w3.org/1998/Math/MathML"
INLINE = "(?:span|b|i|code|img|math|textEntryInteraction)"
BLOCK = "(?:p|h1|h2|h3|h4|ul|ol|table|div|pre|rubricBlock|choiceInteraction|extendedTextInteraction)"
FLOW = f"(?:{INLINE}|{BLOCK})*"
EXPRESSION = "(?:and|equal|match)"
TABLE: dict[str, tuple[str, str, str]] = {  # required attributes, others, children
    "assessmentItem": (
        "identifier title adaptive timeDependent",
        "lang schemaLocation",
        "(responseDeclaration)*(outcomeDeclaration)*(itemBody)?(responseProcessing)?(modalFeedback)*",
    ),
    "responseDeclaration": ("identifier cardinality baseType", "", "(correctResponse)?"),
    "outcomeDeclaration": ("identifier cardinality baseType", "", "(defaultValue)?"),
    "correctResponse": ("", "", "(value)+"),
    "defaultValue": ("", "", "(value)+"),
    "value": ("", "", ""),
    "itemBody": ("", "", f"{BLOCK}*"),
    "rubricBlock": ("view", "use", f"{BLOCK}*"),
    "modalFeedback": ("outcomeIdentifier identifier showHide", "", FLOW),
    "choiceInteraction": ("responseIdentifier shuffle maxChoices", "", "(prompt)?(simpleChoice)+"),
    "prompt": ("", "", f"{INLINE}*"),
    "simpleChoice": ("identifier", "", FLOW),
    "textEntryInteraction": ("responseIdentifier", "expectedLength", ""),
    "extendedTextInteraction": ("responseIdentifier", "expectedLines", "(prompt)?"),
    "responseProcessing": ("", "", "(responseCondition)*"),
    "responseCondition": ("", "", "(responseIf)(responseElseIf)*(responseElse)?"),
    "responseIf": ("", "", f"{EXPRESSION}(setOutcomeValue)*"),
    "responseElseIf": ("", "", f"{EXPRESSION}(setOutcomeValue)*"),
    "setOutcomeValue": ("identifier", "", "(baseValue|sum)"),
    "and": ("", "", f"{EXPRESSION}+"),
    "equal": ("toleranceMode", "tolerance", "(variable)(baseValue)"),
    "match": ("", "", "(variable)(baseValue)"),
    "variable": ("identifier", "", ""),
    "baseValue": ("baseType", "", ""),
    "assessmentTest": ("identifier title", "schemaLocation", "(outcomeDeclaration)*(testPart)+(outcomeProcessing)?"),
    "testPart": ("identifier navigationMode submissionMode", "", "(assessmentSection)+"),
    "assessmentSection": (
        "identifier title visible",
        "",
        "(selection)?(rubricBlock)*(assessmentSection|assessmentItemRef)*",
    ),
    "selection": ("select", "withReplacement", ""),
    "assessmentItemRef": ("identifier href", "", ""),
    "outcomeProcessing": ("", "", "(setOutcomeValue)+"),
    "sum": ("", "", "(testVariables)+"),
    "testVariables": ("variableIdentifier", "", ""),
    "p": ("", "class", f"{INLINE}*"),
    "div": ("", "class", FLOW),
    "pre": ("", "class", f"{INLINE}*"),
    **{f"h{level}": ("", "class", f"{INLINE}*") for level in range(1, 7)},
    **dict.fromkeys(("span", "b", "i", "code"), ("", "class", f"{INLINE}*")),
    "img": ("src alt", "", ""),
    "ul": ("", "class", "(li)+"),
    "ol": ("", "class", "(li)+"),
    "li": ("", "class", FLOW),
    "table": ("", "class", "(tbody)+"),
    "tbody": ("", "", "(tr)+"),
    "tr": ("", "", "(td|th)+"),
    "td": ("", "class colspan", FLOW),
    "th": ("", "class", FLOW),
}
VALUES = {
    "cardinality": {"single"},
    "baseType": {"float", "identifier", "string"},
    "showHide": {"show", "hide"},
    "shuffle": {"true", "false"},
    "adaptive": {"true", "false"},
    "timeDependent": {"true", "false"},
    "visible": {"true", "false"},
    "toleranceMode": {"exact", "absolute"},
    "navigationMode": {"linear", "nonlinear"},
    "submissionMode": {"individual", "simultaneous"},
    "use": {"scoring", "instructions"},
}
IDENTIFIER = re.compile(r"[A-Za-z_][\w.-]*")
WRAPPED = ("modalFeedback", "rubricBlock")
TEXT = frozenset(
    (
        *("p", "span", "b", "i", "code", "pre", "td", "th", "li", "div", "h1", "h2", "h3", "h4"),
        *("simpleChoice", "prompt", "value", "baseValue", "modalFeedback"),
    )
)


def faults(element: Element, version: str) -> list[str]:
    """What breaks a rule."""
    found: list[str] = []
    space = element.tag[1:].partition("}")[0]
    check(element, version, space, found)
    return found


def check(element: Element, version: str, space: str, found: list[str]) -> None:
    name, children = of_21(local(element)), list(element)
    if element.tag == f"{{{MATHML}}}math":
        found += [f"{one.tag} within math" for one in element.iter() if not one.tag.startswith(f"{{{MATHML}}}")]
        return
    if name not in TABLE or not element.tag.startswith(f"{{{space}}}"):
        found.append(f"no element {element.tag}")
        return
    prefixed = local(element).startswith("qti-")
    html = name in TABLE and list(TABLE).index(name) >= list(TABLE).index("p")
    if prefixed != (version == "3.0" and not html):
        found.append(f"{local(element)} is not how {version} writes it")
    required, others, order = TABLE[name]
    attributes = {of_21(local_name(key)): value for key, value in element.attrib.items()}
    found += [f"{name} lacks {one}" for one in required.split() if one not in attributes]
    found += [f"{name} has {one}" for one in attributes if one not in f"{required} {others}".split()]
    found += [f"{name} {one}={value}" for one, value in attributes.items() if value not in VALUES.get(one, {value})]
    found += [
        f"identifier {value}"
        for one, value in attributes.items()
        if one.endswith("dentifier") and not IDENTIFIER.fullmatch(value)
    ]
    if name == "rubricBlock" and ("use" in attributes) != (version == "3.0"):
        found.append("use of a rubric")
    if name in WRAPPED and version == "3.0":
        if [local(one) for one in children] != ["qti-content-body"]:
            found.append(f"{name} without its body")
        children = list(children[0])
    names = [of_21(local(one)) for one in children]
    if not re.fullmatch(order, "".join(names)):
        found.append(f"{name} holds {names}")
    texts = [element.text or "", *(one.tail or "" for one in element)]
    if name not in TEXT and "".join(texts).strip():
        found.append(f"{name} holds text {''.join(texts).strip()[:30]!r}")
    for one in children:
        check(one, version, space, found)


def local_name(key: str) -> str:
    return key.rpartition("}")[2]
