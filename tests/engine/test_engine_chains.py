"""Random machines of strings, pulleys, drums, blocks, slopes and rollers against a small assembler and solver of its own."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from time import process_time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve import solve
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.matching import cheapest_plan
from rotsolve.motion.complete import completed
from rotsolve.motion.configuration import Configuration
from rotsolve.scene.read import read_text
from rotsolve.search.answering import answer
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

G = 9.8
Row = dict[str, float]
sizes = st.integers(1, 40).map(lambda number: number / 10)
angles = st.integers(5, 80)
flips = st.sampled_from((1, -1))


@dataclass
class Machine:
    """The lines of a scene, the equations of its own assembler (Σ coefficient · unknown = value), and what to compare."""

    bodies: list[str] = field(default_factory=list)
    surfaces: list[str] = field(default_factory=list)
    connections: list[str] = field(default_factory=list)
    finds: dict[str, tuple[str, Row]] = field(default_factory=dict)  # path, and what it is in the unknowns
    rows: list[tuple[Row, float]] = field(default_factory=list)

    def add(self, row: Row, value: float = 0.0) -> None:
        self.rows.append((row, value))

    def ask(self, path: str, row: Row) -> None:
        self.finds[f"x{len(self.finds)}"] = (path, row)

    def text(self) -> str:
        parts = [("surfaces", self.surfaces), ("bodies", self.bodies), ("connections", self.connections)]
        found = [f"  {name}: {path}" for name, (path, _) in self.finds.items()]
        lines = ["title: A machine"]
        for word, entries in (*parts, ("find", [line.strip() for line in found])):
            if entries:
                lines += [f"{word}:", *(f"  {entry}" for entry in entries)]
        return "\n".join(lines) + "\n"

    def check(self) -> None:
        unknowns = self.solved()
        answers = numbers(self.text())
        scale = max(1.0, *(abs(value) for value in unknowns.values()))
        for name, (path, row) in self.finds.items():
            expected = sum(share * unknowns[unknown] for unknown, share in row.items())
            number = answers[name]
            assert math.isclose(number, expected, rel_tol=1e-7, abs_tol=1e-9 * scale), (
                path,
                number,
                expected,
                self.text(),
            )

    def solved(self) -> dict[str, float]:
        """Gauss-Jordan with pivots."""
        names = sorted({name for row, _ in self.rows for name in row})
        table = [[row.get(name, 0.0) for name in names] + [value] for row, value in self.rows]
        assert len(table) == len(names), "the assembler needs as many equations as unknowns"
        for column in range(len(names)):
            pivot = max(range(column, len(table)), key=lambda index: abs(table[index][column]))
            table[column], table[pivot] = table[pivot], table[column]
            for index in range(len(table)):
                if index != column and table[index][column]:
                    share = table[index][column] / table[column][column]
                    table[index] = [one - share * other for one, other in zip(table[index], table[column], strict=True)]
        return {name: table[index][-1] / table[index][index] for index, name in enumerate(names)}


def numbers(text: str) -> dict[str, float]:
    """What the engine answers, without its own checks."""
    configuration = Configuration(completed(read_text(text)))
    search = Search(SceneEquations(configuration), families_for(None))
    for find in configuration.problem.finds:
        answer(search, find)
    found = {item.asked.find.name: item.found for item in search.answered}
    return {
        name: item.number.float if item.formula is None else evaluate(item.formula, search.values).float  # type: ignore[union-attr]
        for name, item in found.items()
    }


# chains: bodies in a row from left to right, a pulley or a stepped drum between neighbours


@dataclass(frozen=True)
class Body:
    kind: str  # hanging, level, slope, roller (on a slope)
    mass: float
    angle: int
    sign: int  # +1 where the positive sense is downstream, from left to right along the strings


@dataclass(frozen=True)
class Turning:
    kind: str  # light, disc, ring, drum
    mass: float
    radius: float
    inner: float
    sign: int  # +1 where clockwise is positive


ends = st.builds(Body, st.sampled_from(("hanging", "level", "slope", "roller")), sizes, angles, flips)
middles = st.builds(Body, st.just("level"), sizes, angles, flips)
turnings = st.builds(Turning, st.sampled_from(("light", "disc", "ring", "drum")), sizes, sizes, sizes, flips)
chains = st.integers(1, 3).flatmap(
    lambda count: st.tuples(st.tuples(ends, *[middles] * (count - 1), ends), st.tuples(*[turnings] * count))
)


def place_body(machine: Machine, index: int, body: Body, last: int) -> None:
    """The scene's lines for a body, and Newton's second law for it, downstream positive."""
    name, left = f"b{index}", index == 0
    if body.kind == "level":
        word = "right" if body.sign > 0 else "left"
        machine.connections.append(f"touch{index}: {{contact: [{name}, table]}}")
    else:
        word = "up" if (body.sign > 0) == left else "down"
    machine.bodies.append(f"{name}: {{{shape_of(body)}mass: {body.mass} kg, moves: {word}}}")
    if body.kind in ("slope", "roller"):
        side = "left" if left else "right"
        machine.surfaces.append(f"ramp{index}: {{slope: {body.angle} deg, down: {side}}}")
        touch = "rolls" if body.kind == "roller" else "contact"
        machine.connections.append(f"touch{index}: {{{touch}: [{name}, ramp{index}]}}")
    pull = {"hanging": G, "level": 0.0}.get(body.kind, G * math.sin(math.radians(body.angle)))
    row: Row = {f"a{index}": body.mass * (1.5 if body.kind == "roller" else 1)}
    if not left:
        row[f"R{index}"] = 1.0  # the string on its left holds it back
    if index < last:
        row[f"L{index + 1}"] = -1.0
    machine.add(row, body.mass * pull * (-1 if left else 1))
    machine.ask(f"{name}.acceleration", {f"a{index}": body.sign})


def shape_of(body: Body) -> str:
    return "shape: cylinder, radius: 0.2 m, " if body.kind == "roller" else ""


def reference(index: int, body: Body) -> str:
    return f"b{index}.center" if body.kind == "roller" else f"b{index}"


def place_turning(machine: Machine, index: int, item: Turning, before: str, after: str, names: tuple[str, str]) -> None:
    """A pulley or drum between bodies index − 1 and index: lines, law of rotation, and the two rules."""
    name, drum = f"p{index}", item.kind == "drum"
    machine.connections.append(f"axle{index}: {{axle: {name}}}")
    turns = "clockwise" if item.sign > 0 else "counterclockwise"
    inner = item.inner if drum else item.radius
    share = {"light": 0.0, "disc": 0.5, "ring": 1.0}.get(item.kind, 0.0)
    inertia = round(item.mass * 0.15, 4) if drum else share * item.mass * item.radius**2
    if drum:
        machine.bodies.append(
            f"{name}: {{mass: 1 kg, inertia: {inertia} kg m^2, radii: {{small: {inner} m, big: {item.radius} m}}, turns: {turns}}}"
        )
        machine.connections.append(f"s{index}: {{string: [{before}, {name}.small]}}")
        machine.connections.append(f"t{index}: {{string: [{name}.big, {after}]}}")
        machine.ask(f"s{index}.tension", {f"L{index}": 1})
        machine.ask(f"t{index}.tension", {f"R{index}": 1})
    else:
        mass = "mass: 0, " if item.kind == "light" else f"shape: {item.kind}, mass: {item.mass} kg, "
        machine.bodies.append(f"{name}: {{{mass}radius: {item.radius} m, turns: {turns}}}")
        machine.connections.append(f"s{index}: {{string: [{before}, {name}, {after}]}}")
        ends = ("tension", "tension") if item.kind == "light" else tuple(f"{end}.tension" for end in names)
        machine.ask(f"s{index}.{ends[0]}", {f"L{index}": 1})
        machine.ask(f"s{index}.{ends[1]}", {f"R{index}": 1})
    machine.add({f"w{index}": inertia, f"R{index}": -item.radius, f"L{index}": inner})
    machine.add({f"a{index - 1}": 1, f"w{index}": -inner})
    machine.add({f"a{index}": 1, f"w{index}": -item.radius})
    if item.kind != "light":
        machine.ask(f"{name}.angular_acceleration", {f"w{index}": item.sign})


@settings(max_examples=90, deadline=None)
@given(chains)
def test_chains(chain: tuple[tuple[Body, ...], tuple[Turning, ...]]) -> None:
    bodies, between = chain
    machine = Machine(surfaces=["table: level"])
    for index, body in enumerate(bodies):
        place_body(machine, index, body, len(bodies) - 1)
    for index, item in enumerate(between, 1):
        pair = bodies[index - 1], bodies[index]
        before, after = reference(index - 1, pair[0]), reference(index, pair[1])
        place_turning(machine, index, item, before, after, (f"b{index - 1}", f"b{index}"))
    machine.check()


# trees: a pulley hangs from a pulley


@dataclass(frozen=True)
class Node:
    """A block, or a pulley with a node at each end of its string."""

    mass: float
    radius: float
    share: float  # of m R² in its moment of inertia; 0 is a light pulley
    sign: int  # +1 where down is positive
    turn: int  # +1 where clockwise is positive
    left: Node | None = None
    right: Node | None = None


shares = st.sampled_from((0.0, 0.5, 1.0))
blocks = st.builds(Node, sizes, st.just(0.0), st.just(0.0), flips, flips)
lows = st.builds(Node, sizes, sizes, shares, flips, flips, blocks, blocks)
tops = st.builds(Node, sizes, sizes, shares, flips, flips, st.one_of(blocks, lows), st.one_of(blocks, lows))


def hang(machine: Machine, node: Node, name: str, parent: str) -> None:
    """Lines and equations of a node that hangs from the tension `parent`; '' for the top pulley, whose axle is fixed."""
    moves = f", moves: {'down' if node.sign > 0 else 'up'}" if parent else ""
    if parent:
        machine.ask(f"{name}.acceleration", {f"a{name}": node.sign})
    if node.left is None or node.right is None:
        machine.bodies.append(f"{name}: {{mass: {node.mass} kg{moves}}}")
        machine.add({f"a{name}": node.mass, parent: 1}, node.mass * G)
        return
    shape = {0.0: "mass: 0", 0.5: f"shape: disc, mass: {node.mass} kg", 1.0: f"shape: ring, mass: {node.mass} kg"}[
        node.share
    ]
    turns = "clockwise" if node.turn > 0 else "counterclockwise"
    machine.bodies.append(f"{name}: {{{shape}, radius: {node.radius} m, turns: {turns}{moves}}}")
    mass = node.mass if node.share else 0.0
    left, right = f"L{name}", f"R{name}"
    if parent:
        machine.add({f"a{name}": mass, left: -1, right: -1, parent: 1}, mass * G)
    else:
        machine.connections.append(f"axle: {{axle: {name}}}")
        machine.add({f"a{name}": 1})
    machine.add({f"w{name}": node.share * node.mass * node.radius**2, right: -node.radius, left: node.radius})
    machine.add({f"a{name}l": 1, f"a{name}": -1, f"w{name}": node.radius})
    machine.add({f"a{name}r": 1, f"a{name}": -1, f"w{name}": -node.radius})
    ends = [
        f"{name}{side}" + (".center" if child.left else "") for side, child in (("l", node.left), ("r", node.right))
    ]
    machine.connections.append(f"s{name}: {{string: [{ends[0]}, {name}, {ends[1]}]}}")
    machine.ask(f"s{name}.{name}l.tension" if node.share else f"s{name}.tension", {left: 1})
    hang(machine, node.left, f"{name}l", left)
    hang(machine, node.right, f"{name}r", right)


@pytest.mark.exhaustive
@settings(max_examples=60, deadline=None)
@given(tops)
def test_pulleys_that_hang_from_pulleys(top: Node) -> None:
    machine = Machine()
    hang(machine, top, "q", "")
    machine.check()


def wheels(number: int, *, alike: bool) -> str:
    """Two blocks on a string over a row of wheels, all alike or each of its own size."""
    names = [f"w{place}" for place in range(1, number + 1)]
    sizes = {name: ("I", "R") if alike else (f"I{name}", f"R{name}") for name in names}
    letters = dict.fromkeys(
        pair for sizes_ in sizes.values() for pair in zip(sizes_, ("2 kg m^2", "5 cm"), strict=True)
    )
    given = ", ".join(f"{letter}: {value}" for letter, value in letters)
    bodies = "".join(
        f"  {name}: {{inertia: {inertia}, radius: {radius}}}\n" for name, (inertia, radius) in sizes.items()
    )
    axles = "".join(f"  axle{name}: {{axle: {name}}}\n" for name in names)
    return (
        f"given: {{m: 2 kg, M: 3 kg, {given}}}\nbodies:\n  left: {{mass: m, moves: up}}\n{bodies}  right: {{mass: M, moves: down}}\n"
        f"connections:\n{axles}  rope: {{string: [left, {', '.join(names)}, right]}}\nfind: {{a: left.acceleration}}\n"
    )


def test_an_answer_that_no_page_would_hold_is_never_told_by_itself() -> None:
    solution = solve(wheels(11, alike=False))
    answer = solution.answers["a"]
    assert answer.formula is not None and answer.float is not None
    numbers = {one.name: one.value for one in solution.problem.givens if one.value is not None}
    assert evaluate(answer.formula, numbers).float == pytest.approx(answer.float, rel=1e-12)  # so it holds givens alone


def test_the_time_of_a_chain_grows_no_faster_than_the_square_of_its_length() -> None:
    def spent(number: int) -> float:
        text = wheels(number, alike=True)
        cheapest_plan.cache_clear()  # plans that other tests have left behind
        start = process_time()
        solve(text)
        return process_time() - start

    spent(2)
    assert spent(40) < 16 * spent(10)
