"""States and phases: the named instants, the lines that hold at them, and what differs between two of them."""

from __future__ import annotations

import re

from msgspec.structs import replace

from rotsolve.core.quantity import DIRECTED, QUANTITIES
from rotsolve.language.grammar import NAMED_AXES, PHASE
from rotsolve.language.problem import COMES_TO, EXTREMES, SETTLES, Condition, Path, Phase, State
from rotsolve.language.words import hint, quoted
from rotsolve.scene.elements import read_value
from rotsolve.scene.in_space import read_three
from rotsolve.scene.literals import Want
from rotsolve.scene.paths import read_path
from rotsolve.scene.phrases import swings_path, swings_said
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Node, Text
from rotsolve.scene.values import read_scalar

SETTLING = ("velocity", "angular_velocity")  # what settles after a long time
NEVER_ENDING = ("infinity", "inf", "oo", "forever")
FORM = "write `{rod.angle: 30 deg}`, `at rest`, or `{}`"


def read_state(scope: Scope, name: str, key: Text, node: Node) -> State | None:
    """One entry of `states`."""
    if isinstance(node, Text):
        if " ".join(node.value.split()) == "at rest":
            return State(name, (Condition(None, rest=True, owner="all", span=node.span),), span=key.span)
        return scope.fault(node, f"state `{name}` can't be {quoted(node.value)}", FORM, "form")
    if isinstance(node, List):
        return scope.fault(node, f"state `{name}` wants a map, but this is a list", FORM, "form")
    conditions: list[Condition] = []
    flags = {"balance": False, "steady": False}
    for word, (line, written) in scope.entries(node, f"state `{name}`").items():
        if word in flags:
            flags[word] = read_true(scope, line, written)
        elif word == "at rest":
            conditions.extend(read_at_rest(scope, written))
        else:
            conditions.extend(conditions_of_line(scope, name, line, written))
    if scope.space and flags["balance"]:  # nothing turns, and nothing starts to
        conditions.append(Condition(None, rest=True, owner="all", span=key.span))
        flags["steady"] = True
    return State(name, tuple(conditions), flags["balance"], flags["steady"], key.span)


def read_true(scope: Scope, key: Text, node: Node) -> bool:
    if isinstance(node, Text) and node.value.strip() == "true":
        return True
    scope.fault(node, f"`{key.value}` can only be `true`", "leave the line out otherwise", "choice")
    return False


def read_at_rest(scope: Scope, node: Node) -> list[Condition]:
    """`at rest: all`, one body, or a list of bodies."""
    items = node.items if isinstance(node, List) else (node,)
    found = []
    for item in items:
        word = item.value.strip() if isinstance(item, Text) else ""
        if word == "all" or scope.kinds.get(word) == "body":
            found.append(Condition(None, rest=True, owner=word, span=item.span))
        else:
            scope.unknown(item, word or "…", "body", ["all", *scope.names("body")], "bodies")
    return found


def conditions_of_line(scope: Scope, state: str, line: Text, node: Node) -> list[Condition]:
    """One line: a word about a connection, an extreme, a component each for a list, or a value."""
    text = line.value.strip()
    if " from " in text:
        help = "give each body its own angle"
        scope.fault(line, "a state tells the angle of one body, not of two against each other", help, "form")
        return []
    if scope.space:
        return spatial_lines(scope, state, line, node)
    start = line.value.index(text)
    if scope.kinds.get(text) == "connection":
        return connection_word(scope, text, line, node)
    path = swings_path(scope, line) if swings_said(text) else read_path(scope, line, start, start + len(text))
    if path is None:
        return []
    word = node.value.strip() if isinstance(node, Text) else ""
    if word == SETTLES and path.quantity not in SETTLING:
        help = "it is said of a velocity or an angular velocity"
        scope.fault(node, f"`{SETTLES}` says nothing of `{path.quantity}`", help, "choice")
        return []
    if word in COMES_TO:
        return [Condition(path, word=word, span=line.span)]
    if word in NEVER_ENDING:
        help = f"say what it comes close to after a long time: `wheel.angular_velocity: {SETTLES}`"
        scope.fault(node, f"no state is reached at `{word}`", help, "unknown")
        return []
    if (
        isinstance(node, List)
        and len(node.items) == 2
        and "x" in QUANTITIES[path.quantity].components
        and not path.component
    ):
        parts = []
        for component, item in zip("xy", node.items, strict=True):
            part = Path(path.owner, path.quantity, path.point, path.argument, component, path.span)
            parts.extend(value_condition(scope, state, part, line, item))
        return parts
    return value_condition(scope, state, path, line, node)


EXTREME = ("precession", "tilt")  # of which a state in space says that it is largest or smallest
SEEN = re.compile(r"(?P<path>\S+)(?: relative to (?P<relative>\w+))?(?: in (?P<axes>\w+) axes)?")


def spatial_lines(scope: Scope, state: str, line: Text, node: Node) -> list[Condition]:
    """A line of a scene in space: `PATH [relative to BODY] [in … axes]: value`, of a vector its three components."""
    text = " ".join(line.value.split())
    match = SEEN.fullmatch(text)
    if match is None:
        scope.fault(line, f"{quoted(text)} is no line of a state", "write `body.quantity [relative to BODY]`", "form")
        return []
    for word, names in (("relative", ("body",)), ("axes", ("body",))):
        if match[word] and match[word] not in (*scope.names(*names), *(NAMED_AXES if word == "axes" else ())):
            scope.unknown(line, match[word], "body", scope.names(*names), "bodies")
            return []
    if scope.kinds.get(match["path"]) == "connection":
        return connection_word(scope, match["path"], line, node)
    path = read_path(scope, line, line.value.index(match["path"]), line.value.index(match["path"]) + len(match["path"]))
    if path is None:
        return []
    axes, relative = match["axes"] or "", match["relative"] or ""
    word = node.value.strip() if isinstance(node, Text) else ""
    if word in EXTREMES:
        if path.quantity in EXTREME:
            return [Condition(path, word=word, span=line.span)]
        message = f"where `{text}` is {word} is no line of a state in space"
        help = f"what turns back has the rate 0: tell that, and as `{text}` a letter that is `unknown`"
        scope.fault(node, message, help, "form")
        return []
    if not isinstance(node, List) or path.component or path.quantity not in DIRECTED:
        found = value_condition(scope, state, path, line, node)
        return [replace(item, axes=axes, relative=relative) for item in found]
    kind = QUANTITIES[path.quantity]
    owner = "_".join(part for part in (path.owner, path.point) if part)
    parts = read_three(scope, node, Want(text, kind.measures, kind.letter, owner, hint=state)) or ()
    return [
        Condition(replace(path, component=axis), part, span=line.span, axes=axes, relative=relative, whole=True)
        for axis, part in zip("xyz", parts, strict=False)
    ]


def value_condition(scope: Scope, state: str, path: Path, line: Text, node: Node) -> list[Condition]:
    kind = QUANTITIES[path.quantity]
    owner = "_".join(part for part in (path.owner, path.point if path.point != "at" else "", path.component) if part)
    limits = "nonnegative" if kind.nonnegative else ""
    want = Want(line.value.strip(), kind.measures, kind.letter, owner or state, limits, hint=state)
    found = read_scalar(scope, node, want)
    return [] if found is None else [Condition(path, found, span=line.span)]


def connection_word(scope: Scope, name: str, line: Text, node: Node) -> list[Condition]:
    """`grip: rolls`, `cord: slack`."""
    cls = scope.elements.get(name)
    if cls is None:
        return []
    allowed: tuple[str, ...] = getattr(cls, "words", ())
    word = node.value.strip() if isinstance(node, Text) else ""
    if word in allowed:
        return [Condition(Path(name, "", span=line.span), word=word, owner=name, span=line.span)]
    if allowed:
        shown = word or node.shown
        scope.fault(node, f"`{name}` can't be {quoted(shown)}", hint(word, allowed, "it can be"), "choice")
    else:
        own = getattr(cls, "quantities", ())
        quantities = ", ".join(word for word in own if scope.space or not QUANTITIES[word].space)
        scope.fault(line, f"`{name}` needs a quantity here", f"write `{name}.quantity`: {quantities}", "path")
    return []


def read_phase(scope: Scope, name: str, key: Text, node: Node) -> Phase | None:
    """One entry of `phases`."""
    entries = scope.entries(node, f"phase `{name}`", PHASE)
    found = {}
    for word, (line, written) in entries.items():
        declared = PHASE[word]
        if declared.later:
            scope.later(line, word)
        elif (item := read_value(scope, declared, written, word, name)) is not None:
            found[word] = item
    for word, declared in PHASE.items():
        if declared.required and word not in entries:
            scope.fault(key, f"phase `{name}` needs `{word}`", f"add it: {declared.help}", "missing")
    if "from" not in found or "to" not in found:
        return None
    return Phase(name, found["from"], found["to"], found.get("without", ()), key.span)
