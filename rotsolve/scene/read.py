"""Read a scene: YAML text -> Problem: its sections in the order in which they lean on each other, with all faults of the file at once."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Container, Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from functools import partial
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any, TypeGuard

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import note
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ACCELERATION, describe
from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.core.faults import Fault, SceneError, Span
from rotsolve.language.grammar import APPROXIMATIONS, SECTIONS
from rotsolve.language.problem import SMALL_BESIDE, Given, Problem, references
from rotsolve.language.words import nearest_name, quoted
from rotsolve.scene.answers import read_published
from rotsolve.scene.bodies import read_body
from rotsolve.scene.elements import read_element, read_value
from rotsolve.scene.encoding import decoded
from rotsolve.scene.givens import read_givens, settings_in_text
from rotsolve.scene.in_space import in_plane_only, in_space_only
from rotsolve.scene.literals import Want
from rotsolve.scene.mending import mended
from rotsolve.scene.phrases import read_find
from rotsolve.scene.rough import size
from rotsolve.scene.scope import Scope
from rotsolve.scene.states import read_phase, read_state
from rotsolve.scene.tree import BYTES, List, Map, Node, Text, compose
from rotsolve.scene.values import read_scalar

if TYPE_CHECKING:
    from rotsolve.language.marks import Marking
    from rotsolve.language.problem import Variation, Wording

Source = str | os.PathLike[str] | Mapping[str, Any] | Problem  # what says a scene


def read_source(source: Source, settings: Mapping[str, object] | None = None) -> Problem:
    """The problem in a file, in YAML text (a text has a line break, a path has none), in a dict of its sections; or one that has been read.

    `settings` replace values of givens: texts such as "2 kg", or numbers where the unit in the scene is one of SI.
    """
    if isinstance(source, Problem):
        told = {**dict(source.settings), **(settings or {})}
        return read_text("\n".join(source.lines), source.file, told) if settings else source
    if isinstance(source, Mapping):
        return read_text(written_yaml(source), "<dict>", settings)
    if isinstance(source, str) and "\n" in source:
        return read_text(source, settings=settings)
    return read_file(source, settings=settings)


def written_yaml(sections: Mapping[str, Any]) -> str:
    """A dict as YAML text; faults of a scene, or of answers, show lines of this text."""
    from yaml import SafeDumper, YAMLError, dump

    class Writer(SafeDumper):  # type: ignore[misc]
        """Writes what stands in several places wherever it stands."""

        def ignore_aliases(self, data: object) -> bool:
            return True

    try:
        return str(dump(plain_values(sections), Dumper=Writer, sort_keys=False, allow_unicode=True, width=math.inf))
    except (YAMLError, RecursionError) as error:
        kind = type(error.args[-1]).__name__ if isinstance(error, YAMLError) else ""
        message = f"this dict holds a value of the kind `{kind}`" if kind else "this dict holds itself"
        fault = Fault(message, None, "it may hold texts, numbers, lists and dicts", "form")
        raise SceneError([fault], (), "<dict>") from None


def plain_values(value: Any) -> Any:
    """Dicts, lists and numbers of any kind as those that YAML writes."""
    if isinstance(value, Mapping):
        return {key: plain_values(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain_values(item) for item in value]
    if isinstance(value, (Fraction, Decimal)):
        return str(value)
    if isinstance(value, Real) and not isinstance(value, bool):
        return int(value) if isinstance(value, Integral) else float(value)
    return value


def read_file(path: str | os.PathLike[str], settings: Mapping[str, object] | None = None) -> Problem:
    """The problem in a file."""
    return read_text(text_of_file(path), os.fspath(path), settings)


def text_of_file(path: str | os.PathLike[str]) -> str:
    """What a file holds; its size is checked before it is read."""
    name = os.fspath(path)
    try:
        size = os.path.getsize(name)
        if size > BYTES:
            raise too_large(size, name)
        with open(name, "rb") as stream:
            content = stream.read(BYTES + 1)
    except OSError as error:
        reason = error.strerror or "it can't be read"
        raise SceneError([Fault(f"can't read {quoted(name)}: {reason}", None, "", "file")]) from None
    if len(content) > BYTES:
        raise too_large(len(content), name)
    return decoded(content, name)


def too_large(size: int, name: str) -> SceneError:
    message = f"the file has {size} bytes, more than {BYTES}"
    return SceneError([Fault(message, None, "a scene is a page of text", "limit")], (), name)


def read_text(text: str, file: str = "<text>", settings: Mapping[str, object] | None = None) -> Problem:
    """The problem in a text. Raises SceneError with all faults."""
    return read_tree(*tree_of_text(text, file), file, settings)


def tree_of_text(text: str, file: str) -> tuple[Node, tuple[str, ...]]:
    """The tree of a text and its lines, if it is one that YAML knows."""
    if len(text) > BYTES:
        raise too_large(len(text), file)
    text = text.replace("\r\n", "\n").replace("\r", "\n").removeprefix("\ufeff")
    control = min((text.index(letter) for letter in set(text) if is_control(ord(letter))), default=None)
    if control is not None:
        place = Span(text.count("\n", 0, control) + 1, control - text.rfind("\n", 0, control))
        fault = Fault(
            f"a control character, U+{ord(text[control]):04X}", place, "remove it: a scene is plain text", "file"
        )
        raise SceneError([fault], text.split("\n"), file)
    return compose(text, file)


def is_sheet(root: Node) -> TypeGuard[Map]:
    """Whether a file lists problems, and is none itself."""
    words = {key.value for key, _ in root.entries} if isinstance(root, Map) else set()
    return bool(words & {"sheet", "problems"}) and words.isdisjoint(("find", "bodies"))


def no_scene_but_sheet(root: Map, file: str) -> Fault:
    """What is said of a sheet where a scene is wanted."""
    key, _ = root.entries[0]
    help = f"`rotsolve key {file} -o DIR` makes its pages, `rotsolve check {file} ANSWERS` marks it; a scene is one of its problems"
    return Fault("this file is a sheet of problems, and no scene", key.span, help, "sheet")


def is_control(code: int) -> bool:
    """Whether no text holds a letter, and YAML's parser refuses it: all below a blank but tab and line break, and others."""
    if code < 0x20:
        return code not in (0x09, 0x0A)
    return (0x7F <= code <= 0x9F and code != 0x85) or 0xD800 <= code <= 0xDFFF or code in (0xFFFE, 0xFFFF)


def read_tree(
    root: Node, lines: tuple[str, ...], file: str = "<text>", settings: Mapping[str, object] | None = None
) -> Problem:
    """The problem in the tree of a text."""
    scope = Scope()
    if is_sheet(root):
        raise SceneError([no_scene_but_sheet(root, file)], lines, file)
    root = mended(root, scope) if isinstance(root, Map) else root
    problem = Sections(scope, root, dict(settings or {})).problem(file, lines)
    scope.faults.extend(beyond_ends(problem, scope.numbers) if problem is not None and not scope.blamed else ())
    if scope.faults:
        from rotsolve.scene.aftermath import first_causes  # only a faulty scene pays for it

        raise SceneError(first_causes(scope, lines), lines, file)
    assert problem is not None
    return problem


STANDARD_GRAVITY = "9.8 m/s^2"
NAMED = {
    "given": "given",
    "surfaces": "surface",
    "bodies": "body",
    "connections": "connection",
    "actions": "action",
    "states": "state",
    "phases": "phase",
    "events": "event",
    "find": "find",
}
Entries = dict[str, tuple[Text, Node]]


class Sections:
    """Reads the sections in the order in which they lean on each other."""

    def __init__(self, scope: Scope, root: Node, settings: Mapping[str, object]) -> None:
        self.scope = scope
        self.settings: Mapping[str, object] = settings
        self.written = {key.value for key, _ in root.entries} if isinstance(root, Map) else set()
        self.top: Entries = scope.entries(root, "a scene", SECTIONS) if isinstance(root, Map) else {}
        if not isinstance(root, Map):
            scope.fault(root, "a scene is a map", "begin with `title:`, `given:`, `bodies:`, `find:`", "form")

    def node(self, section: str) -> Node | None:
        return self.top[section][1] if section in self.top else None

    def entries(self, section: str) -> Entries:
        """The entries of a section whose names are new; names were entered by `declare`."""
        node = self.node(section)
        if not isinstance(node, Map):
            return {}
        kind = NAMED[section]
        return {
            key.value: (key, item)
            for key, item in node.entries
            if self.scope.kinds.get(key.value) == kind and self.scope.places.get(key.value) == key.span
            if not (isinstance(item, Text) and item.empty)
        }

    def declare(self) -> None:
        """Enter all names of the file, so that order doesn't matter; a `find` may have the name of an unknown given."""
        nodes = [self.node(section) for section in NAMED]
        self.scope.written = frozenset(key.value for node in nodes if isinstance(node, Map) for key, _ in node.entries)
        for item in self.unknown():
            if isinstance(item, Text):
                self.scope.declare(item, "given")
        for section, kind in NAMED.items():
            node = self.node(section)
            if node is None:
                continue
            self.scope.entries(node, f"`{section}`")
            seen: set[str] = set()
            for key, item in node.entries if isinstance(node, Map) else ():
                empty = isinstance(item, Text) and item.empty
                again = key.value in seen or (section == "find" and self.asked(key.value))
                seen.add(key.value)
                if not empty and not again:
                    self.scope.declare(key, kind)

    def unknown(self) -> tuple[Node, ...]:
        """What the section `unknown` lists."""
        node = self.node("unknown")
        return node.items if isinstance(node, List) else (node,) if isinstance(node, Text) else ()

    def asked(self, name: str) -> bool:
        """Whether the name is a given that is unknown."""
        given = self.node("given")
        item = given.get(name) if isinstance(given, Map) else None
        listed = [entry.value for entry in self.unknown() if isinstance(entry, Text)]
        text = item.value.strip() if isinstance(item, Text) else ""
        nearly = text[:2] == "un" and text.isalpha() and nearest_name(text, ("unknown",)) is not None
        return text == "unknown" or nearly or name in listed

    def problem(self, file: str, lines: tuple[str, ...]) -> Problem | None:
        """All sections; None when the root is no map."""
        if not self.top and self.scope.faults:
            return None
        scope = self.scope
        self.required()
        scope.space = self.choice("up") == "z"
        self.declare()
        self.givens()
        fields: dict[str, Any] = {name: self.text(name) for name in ("title", "source", "text")}
        if any(sign in fields["text"] for sign in ("{", "$", "![")):
            from rotsolve.scene.statement import check_text  # most texts are prose alone

            check_text(scope, self.top["text"][1], lines, "`text`", file)
        fields["gravity"], turning = self.gravity()
        fields["plane"] = self.choice("plane") or "vertical"
        if scope.space and "plane" in self.top:
            in_plane_only(scope, self.top["plane"][0], "plane")
        fields["space"] = scope.space
        fields["surfaces"] = self.each("surfaces", partial(read_element, scope, "surfaces"))
        fields["bodies"] = self.each("bodies", partial(read_body, scope))
        fields["gravity_in"] = self.turned_with(turning)
        for section in ("connections", "actions", "events"):
            fields[section] = self.each(section, partial(read_element, scope, section))
        fields["states"] = self.each("states", partial(read_state, scope))
        fields["phases"] = self.each("phases", partial(read_phase, scope))
        fields["assume"] = self.assume()
        asked: dict[str, Any] = {}
        fields["finds"] = self.finds(asked)
        fields["answers"] = self.answers(asked, asked.keys() - {find.name for find in fields["finds"]})
        fields["ask"] = self.ask(asked, lines, file)
        fields["marking"] = self.marking(asked)
        fields["vary"] = self.vary()
        settings = tuple(self.texts.items())
        problem = Problem(file=file, lines=lines, givens=self.all_givens(), settings=settings, **fields)
        if not scope.space:
            return problem
        from rotsolve.scene.first_rates import with_first_rates

        return with_first_rates(problem, scope)

    def required(self) -> None:
        scope = self.scope
        for section, declared in SECTIONS.items():
            if declared.required and section not in self.written and self.written <= SECTIONS.keys():
                scope.fault(None, f"the scene has no `{section}`", f"add it: {declared.help}", "missing")
        find = self.node("find")
        if isinstance(find, Map) and not find.entries:
            scope.fault(find, "`find` is empty", "ask for something: `a: block.acceleration`", "missing")

    def givens(self) -> None:
        scope = self.scope
        self.texts = settings_in_text(scope, self.node("given"), self.settings)
        read_givens(scope, self.node("given"), self.texts)
        for name in scope.names("given"):
            if name not in scope.givens:
                scope.givens[name] = Given(name, None, None, asked=True, text="unknown", span=scope.places[name])
                scope.dimensions[name] = None

    def each(self, section: str, reader: Callable[[str, Text, Node], Any]) -> tuple[Any, ...]:
        found = [reader(name, key, node) for name, (key, node) in self.entries(section).items()]
        return tuple(item for item in found if item is not None)

    def finds(self, asked: dict[str, Any]) -> tuple[Any, ...]:
        """The asked quantities in order; an earlier answer may stand in a later one."""
        node = self.node("find")
        if not isinstance(node, Map):
            return ()
        own = self.entries("find")
        found = []
        for key, item in node.entries:
            if (isinstance(item, Text) and item.empty) or not (key.value in own or self.asked(key.value)):
                continue
            if isinstance(item, Map):
                from rotsolve.scene.comparisons import read_which_of

                found.append(read_which_of(self.scope, key.value, key, item, asked))
            else:
                found.append(read_find(self.scope, key.value, key, item, asked))
            asked.setdefault(key.value, None)
        return tuple(find for find in found if find is not None)

    def answers(self, asked: dict[str, Any], unread: Container[str]) -> tuple[Any, ...]:
        """The published answers, but for those of questions that could not be read."""
        node = self.node("answers")
        if node is None or not (asked or isinstance(self.node("find"), Map)):
            return ()
        entries = self.scope.entries(node, "`answers`", asked, own=True)
        known = [entry for entry in entries.items() if entry[0] not in unread]
        found = [read_published(self.scope, name, key, item, asked) for name, (key, item) in known]
        return tuple(answer for answer in found if answer is not None)

    def text(self, name: str) -> str:
        node = self.node(name)
        if node is None:
            return ""
        if isinstance(node, Text):
            return node.value.strip()
        self.scope.fault(node, f"`{name}` wants a text", "put it in quotes", "form")
        return ""

    def choice(self, name: str) -> str | None:
        node = self.node(name)
        if node is None:
            return None
        found: str | None = read_value(self.scope, SECTIONS[name], node, name, name)
        return found

    def gravity(self) -> tuple[Formula | None, Node | None]:
        """How large the acceleration of gravity is, and what names the body with which it turns, where it does."""
        node = self.node("gravity")
        if not isinstance(node, Map):
            return self.size_of_gravity(node), None
        from rotsolve.scene.in_space import read_turning_gravity  # few scenes say it

        size, body = read_turning_gravity(self.scope, node)
        found = self.size_of_gravity(size)
        return found, body if found is not None else None

    def turned_with(self, node: Node | None) -> str:
        """The body with which gravity turns; '' where it keeps its direction."""
        name = node.value.strip() if isinstance(node, Text) else ""
        if node is not None and name not in self.scope.bodies:
            self.scope.unknown(node, name, "body", tuple(self.scope.bodies), "bodies")
            return ""
        return name

    def size_of_gravity(self, node: Node | None) -> Formula | None:
        """`none`, a value, the given `g`, or 9.8 m/s² under an automatic letter."""
        scope = self.scope
        if isinstance(node, Text) and node.value.strip() == "none":
            return None
        given = scope.givens.get("g")
        own = given is not None and (given.dimension is None or given.dimension.matches(ACCELERATION))
        if node is not None:
            value = read_scalar(scope, node, Want("gravity", "acceleration", "g", "", "nonnegative"))
            if own and value is not None and "g" not in value.symbols():
                return scope.fault(
                    node, "the given `g` is gravity already", "leave out one of them, or write `gravity: g`"
                )
            return value
        if own:
            assert given is not None
            if given.dimension is None:
                scope.dimensions["g"] = ACCELERATION
            return scope.made.get("g", Symbol("g"))
        if given is not None:
            self.no_gravity(given)
            return None
        return scope.automatic("g", "", parse_quantity(STANDARD_GRAVITY), None)

    def no_gravity(self, given: Given) -> None:
        """A given `g` that is no acceleration: who means gravity by it would have another one without noticing."""
        assert given.dimension is not None
        if "g" in self.scope.blamed:
            return
        shown = quoted(given.text) if given.text else "what is given"
        meant = f"{given.text} m/s^2" if given.value is not None and given.unit is None else STANDARD_GRAVITY
        self.scope.fault(
            self.scope.places.get("g"),
            f"`g` is gravity, an acceleration, but {shown} is {describe(given.dimension, article=True)}",
            f"write `g: {meant}`; for something else take another letter, or add `gravity: {STANDARD_GRAVITY}`",
            "dimension",
        )

    def assume(self) -> tuple[str, ...]:
        """The approximations that the scene asks for."""
        node, scope = self.node("assume"), self.scope
        if node is None:
            return ()
        found = []
        for item in node.items if isinstance(node, List) else (node,):
            word = " ".join(item.value.replace("≪", f" {SMALL_BESIDE} ").split()) if isinstance(item, Text) else ""
            if word in APPROXIMATIONS and scope.space:
                found.append(word)
            elif SMALL_BESIDE in word and not scope.space:
                from rotsolve.scene.assumed import small_beside  # few scenes say it

                found += small_beside(scope, item, word)
            elif word in APPROXIMATIONS:
                in_space_only(scope, self.top["assume"][0], f"assume: {word}")
            else:
                known = APPROXIMATIONS if scope.space else (f"m {SMALL_BESIDE} M",)
                scope.unknown(item, word, "approximation", known, "approximations")
        return tuple(found)

    def ask(self, asked: Mapping[str, Any], lines: tuple[str, ...], file: str) -> tuple[Wording, ...]:
        node = self.node("ask")
        if node is None:
            return ()
        from rotsolve.scene.statement import read_wordings  # few scenes say it

        return read_wordings(self.scope, node, asked, lines, file)

    def marking(self, asked: Mapping[str, Any]) -> tuple[Marking, ...]:
        node = self.node("marking")
        if node is None:
            return ()
        from rotsolve.scene.marking import read_marking  # few scenes say it

        return read_marking(self.scope, node, asked)

    def vary(self) -> Variation | None:
        node = self.node("vary")
        if node is None:
            return None
        from rotsolve.scene.vary import check_told, read_vary  # few scenes have variants

        variation = read_vary(self.scope, node)
        if variation is not None:
            told: dict[str, Node] = {name: self.top[name][1] for name in ("title", "text") if name in self.top}
            check_told(self.scope, variation, told)
        return variation

    def all_givens(self) -> tuple[Given, ...]:
        """The givens with the dimensions that their use has settled."""
        return tuple(
            given if given.dimension is not None else replace(given, dimension=self.scope.dimensions.get(given.name))
            for given in self.scope.givens.values()
        )


TOLERANCE = 1e-12


def beyond_ends(problem: Problem, numbers: Mapping[str, float]) -> Iterator[Fault]:
    """One fault for each point that its rod does not reach."""
    rods = {body.name: body.shape.reach() for body in problem.bodies if body.shape is not None and body.shape.slender}
    known = {name: size(length, numbers) for name, length in rods.items() if length is not None}
    lengths = {name: number for name, number in known.items() if number is not None}
    parts = (problem.connections, problem.actions, problem.states, problem.events, problem.finds)
    for ref in dict.fromkeys(references(parts)):
        place = None if ref.argument is None else size(ref.argument, numbers)
        length = rods.get(ref.owner)
        if place is not None and length is not None and ref.argument is not None:
            note(length - ref.argument)
        if place is not None and ref.point == "at" and place > lengths.get(ref.owner, place) * (1 + TOLERANCE):
            help = f"the rod is {lengths[ref.owner]:g} m long, and x is counted from its start"
            message = f"{quoted(ref.owner)} ends before this point, {place:g} m from its start"
            yield Fault(message, ref.span, help, "limits")
