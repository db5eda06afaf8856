"""Symbolic solving: the equations that the laws write for a scene, all unknowns, by rotsolve and by what else there is.

Every solver is given the very same linear equations; Kane's and Lagrange's methods, which make their own, the same machine. Each runs in
a process of its own, with nothing remembered from run to run; the best of some runs counts. What takes too long is given up.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from concurrent.futures import TimeoutError
from multiprocessing import get_context
from typing import Any, NamedTuple

from pebble import ProcessPool

from costs.clock import best, forget
from costs.machines import MACHINES, Machine
from costs.tables import Part, Target, above, table

OURS, WRITTEN, STEPS = "rotsolve", "rotsolve, in textbook form", "rotsolve, every step kept"
RUNS = 20  # of which the best counts; fewer where they are long
SMALL = "of five to ten equations most of the time goes into what Python does between the calls of FLINT"
LONG = (
    "a new sum of a dozen terms takes 2.5 ms, in which all its groupings are compared for the one that reads best, and a double Atwood "
    "machine has seven of them"
)
FEW, MANY = 12, 30  # unknowns up to which, and from which on, a target holds


class System(NamedTuple):
    """The equations of a scene, each a formula that is zero, its unknowns, and the letters that are positive."""

    equations: list[Any]
    unknowns: list[str]
    positive: frozenset[str]
    values: dict[str, Any]  # of the givens


def system(machine: Machine) -> System:
    """The equations that the answers take; all unknowns in them are settled."""
    from rotsolve.search.answering import answer_all

    search = fresh(machine)
    answer_all(search, search.scene.configuration.problem.finds)
    laws = len(search.scene.equations)
    used = sorted({index for item in search.answered for index in item.used if index < laws})
    equations = [search.planner.pool[index] for index in used]
    unknowns = sorted({name for law in equations for name in law.symbols()} - search.givens.keys())
    return System([law.left - law.right for law in equations], unknowns, search.solver.positive, search.values)


def fresh(machine: Machine) -> Any:
    """a search into a machine that has been asked nothing yet."""
    from rotsolve.equations.scene_equations import SceneEquations
    from rotsolve.pipeline import asked_part
    from rotsolve.scene.read import read_text
    from rotsolve.search.planning import families_for
    from rotsolve.search.search import Search

    return Search(SceneEquations(asked_part(read_text(machine.scene))), families_for(None))


def leading(unknowns: list[str]) -> int:
    """Which unknown is the acceleration of the body that the first coordinate follows."""
    return next(
        place for place, name in enumerate(unknowns) if name.startswith(("acceleration|left", "acceleration|block"))
    )


def eliminated(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """All unknowns as fractions in lowest terms."""
    from rotsolve.algebra.certified.balls import RealBalls
    from rotsolve.algebra.exact.linear import eliminated as solve
    from rotsolve.algebra.exact.normal import Fractions

    equations, unknowns, positive, values = made
    found: list[Any] = []

    def work() -> None:
        problem = Fractions(equations, (), positive, extra=unknowns)
        found.append((problem, solve(problem, unknowns)[unknowns[leading(unknowns)]]))

    spent = best(work, runs, before=forget)
    problem, ratio = found[-1]
    return spent, float(RealBalls(values)(problem.shaper.ratio(ratio)))


def written(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """All unknowns, factored as a textbook would write them."""
    from rotsolve.algebra.certified.balls import RealBalls
    from rotsolve.algebra.exact.linear import solve_all

    equations, unknowns, positive, values = made
    found: list[Any] = []
    spent = best(lambda: found.append(solve_all(equations, unknowns, (), positive)), runs, before=forget)
    return spent, float(RealBalls(values)(found[-1][unknowns[leading(unknowns)]]))


def stepwise(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """All that is asked, planned and solved one unknown after the other with a derivation, as the command does it."""
    from rotsolve.algebra.certified.balls import RealBalls
    from rotsolve.search.answering import answer_all

    searches = [fresh(machine) for _ in range(min(runs, 3))]
    waiting = iter(searches)

    def work() -> None:
        search = next(waiting)
        answer_all(search, search.scene.configuration.problem.finds)

    spent = best(work, len(searches), before=forget)
    found = searches[0].answered[0].found
    if found.formula is None:  # too long to be printed: a number alone
        assert found.number is not None
        return spent, float(found.number.float)
    return spent, float(RealBalls(made.values)(found.formula))


def in_sympy(made: System) -> tuple[list[Any], list[Any], dict[Any, float]]:
    """The equations and unknowns as SymPy has them, and the numbers of the givens."""
    import sympy

    from rotsolve.algebra.certified.ball import evaluate
    from rotsolve.algebra.formula import Symbol
    from rotsolve.algebra.sympy_bridge import to_sympy

    short = {name: Symbol(f"x{number}") for number, name in enumerate(made.unknowns)}
    equations = [to_sympy(equation.substitute(short)) for equation in made.equations]
    unknowns = [to_sympy(short[name]) for name in made.unknowns]
    numbers = {to_sympy(Symbol(name)): evaluate(value, made.values).float for name, value in made.values.items()}
    assert all(isinstance(symbol, sympy.Symbol) for symbol in unknowns)
    return equations, unknowns, numbers


def sympy_solve(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """`sympy.solve`."""
    import sympy

    equations, unknowns, numbers = in_sympy(made)
    found: list[Any] = []
    spent = best(lambda: found.append(sympy.solve(equations, unknowns, dict=True)), runs, before=forget)
    return spent, float(found[-1][0][unknowns[leading(made.unknowns)]].subs(numbers))


def domain_matrix(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """`DomainMatrix.solve_den`, from the equations on."""
    import sympy
    from sympy.polys.matrices import DomainMatrix

    equations, unknowns, numbers = in_sympy(made)
    found: list[Any] = []

    def solve() -> None:
        left, right = sympy.linear_eq_to_matrix(equations, unknowns)
        matrix, column = DomainMatrix.from_Matrix(left).unify(DomainMatrix.from_Matrix(right))
        above_, below = matrix.solve_den(column)
        found.append((above_.to_Matrix()[leading(made.unknowns)], matrix.domain.to_sympy(below)))

    spent = best(solve, runs, before=forget)
    return spent, float((found[-1][0] / found[-1][1]).subs(numbers))


def lagrange(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """`LagrangesMethod`: accelerations alone, no tensions."""
    import sympy
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    letters, q = moving(machine, made)
    found: list[Any] = []

    def solve() -> None:
        time = dynamicsymbols._t
        heights, angles = machine.heights(q, letters), machine.angles(q, letters)
        ways = machine.along(q, letters) if machine.along else heights
        pairs = [*zip(machine.masses, ways, strict=True), *zip(machine.wheels, angles, strict=True)]
        kinetic = sum(letters[name] * sympy.diff(way, time) ** 2 / 2 for name, way in pairs)
        stored = sum(letters[name] * letters["g"] * y for name, y in zip(machine.masses, heights, strict=True))
        method = LagrangesMethod(kinetic - stored, q)
        method.form_lagranges_equations()
        found.append(method.mass_matrix.LUsolve(method.forcing)[0])

    spent = best(solve, runs, before=forget)
    return spent, in_numbers(found[-1], made)


def kane(machine: Machine, made: System, runs: int) -> tuple[float, float]:
    """`KanesMethod`: accelerations alone, no tensions."""
    import sympy
    from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia

    letters, q = moving(machine, made)
    u = dynamicsymbols(f"u:{machine.coordinates}")
    found: list[Any] = []

    def solve() -> None:
        time, frame, origin = dynamicsymbols._t, ReferenceFrame("N"), Point("O")
        origin.set_vel(frame, 0)
        rates = dict(zip((sympy.diff(one, time) for one in q), u, strict=True))
        bodies: list[Any] = []
        loads: list[Any] = []
        heights, angles = machine.heights(q, letters), machine.angles(q, letters)
        ways = machine.along(q, letters) if machine.along else heights
        for name, way, y in zip(machine.masses, ways, heights, strict=True):
            point = Point("P")
            point.set_vel(frame, sympy.diff(way, time).subs(rates) * frame.y)
            bodies.append(Particle("particle", point, letters[name]))
            pull = sympy.diff(y, time).subs(rates) / sympy.diff(way, time).subs(rates) if machine.along else 1
            loads.append((point, -letters[name] * letters["g"] * sympy.simplify(pull) * frame.y))
        for name, angle in zip(machine.wheels, angles, strict=True):
            turned = frame.orientnew("B", "Axis", (angle, frame.z))
            turned.set_ang_vel(frame, sympy.diff(angle, time).subs(rates) * frame.z)
            bodies.append(RigidBody("wheel", origin, turned, 1, (inertia(turned, 0, 0, letters[name]), origin)))
        method = KanesMethod(frame, q_ind=q, u_ind=u, kd_eqs=[one - two for one, two in zip(u, rates, strict=True)])
        method.kanes_equations(bodies, loads)
        found.append(method.mass_matrix.LUsolve(method.forcing)[0])

    spent = best(solve, runs, before=forget)
    return spent, in_numbers(found[-1], made)


def moving(machine: Machine, made: System) -> tuple[dict[str, Any], Any]:
    """The letters of a machine by name, its coordinates, and the functions that its places take."""
    import sympy
    from sympy.physics.mechanics import dynamicsymbols

    letters = {name: sympy.Symbol(name) for name in made.values}
    return {"sin": sympy.sin, **letters}, dynamicsymbols(f"q:{machine.coordinates}")


def in_numbers(value: Any, made: System) -> float:
    """The number that an expression is worth with the givens, whose letters have no assumptions here."""
    numbers = {symbol.name: number for symbol, number in in_sympy(made)[2].items()}
    return float(value.subs({symbol: numbers[symbol.name] for symbol in value.free_symbols if symbol.name in numbers}))


SOLVERS: dict[str, Callable[[Machine, System, int], tuple[float, float]]] = {
    OURS: eliminated,
    WRITTEN: written,
    STEPS: stepwise,
    "sympy.solve": sympy_solve,
    "DomainMatrix.solve_den": domain_matrix,
    "LagrangesMethod": lagrange,
    "KanesMethod": kane,
}


def timed(solver: str, number: int, made: System, runs: int, path: list[str]) -> tuple[float, float]:
    """In a process of its own: seconds and the first acceleration."""
    sys.path[:] = path
    return SOLVERS[solver](MACHINES[number], made, runs)


def part(limit: float, runs: int = RUNS) -> Part:
    """The table of all solvers, and the targets."""
    systems = [system(machine) for machine in MACHINES]
    times: dict[str, list[float | None]] = {solver: [None for _ in MACHINES] for solver in SOLVERS}
    with ProcessPool(1, 1, context=get_context("spawn")) as pool:
        for number, (machine, made) in enumerate(zip(MACHINES, systems, strict=True)):
            agreed: float | None = None
            for solver in SOLVERS:
                future = pool.schedule(timed, (solver, number, made, runs, sys.path), timeout=limit)
                try:
                    spent, value = future.result()
                except TimeoutError:
                    continue
                agreed = value if agreed is None else agreed
                if abs(value - agreed) > 1e-9 * abs(value):
                    sys.exit(f"{solver} gives another acceleration for {machine.name}: {value}, not {agreed}")
                times[solver][number] = spent
    sizes = [len(made.unknowns) for made in systems]
    rows = [[solver, *(shown(spent, limit) for spent in found)] for solver, found in times.items()]
    head = ("ms", *(f"{machine.name}, {size}" for machine, size in zip(MACHINES, sizes, strict=True)))
    text = (
        f"All unknowns of a scene from the same linear equations, processor time in ms, best of {runs} runs (fewer where "
        f"they are long); given up after {limit:g} s, which makes ratios lower bounds. "
        f"Lagrange and Kane give the accelerations alone.\n\n{table(head, rows)}"
    )
    return Part("Symbolic solving", text, tuple(targets(times, sizes, limit)))


def shown(spent: float | None, limit: float) -> str:
    return f"> {1000 * limit:.0f}" if spent is None else f"{1000 * spent:.{1 if spent < 0.1 else 0}f}"


def targets(times: Mapping[str, list[float | None]], sizes: list[int], limit: float) -> list[Target]:
    """How many times faster than SymPy; where that was given up, at least so many."""

    def faster(mine: str, other: str, chosen: Callable[[int], bool]) -> float:
        pairs = zip(times[mine], times[other], sizes, strict=True)
        return min((b or limit) / (a or limit) for a, b, size in pairs if chosen(size))

    few, many = (lambda size: size <= FEW), (lambda size: size >= MANY)
    return [
        above(f"faster than sympy.solve, up to {FEW} unknowns, ×", faster(OURS, "sympy.solve", few), 50),
        above(f"faster than sympy.solve, from {MANY} unknowns on, ×", faster(OURS, "sympy.solve", many), 400),
        above("faster than DomainMatrix, ×", faster(OURS, "DomainMatrix.solve_den", lambda size: True), 15, why=SMALL),
        above(
            "in textbook form, faster than sympy.solve, ×",
            faster(WRITTEN, "sympy.solve", lambda size: True),
            25,
            why=LONG,
        ),
    ]
