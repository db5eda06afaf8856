"""Complete: a refusal that blames the scene's data is held against the assembly of all bodies' equations.

Where that has an answer, nothing is missing and nothing contradicts: the refusal then says what is not solved, and on which way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from rotsolve.confirm import NotConfirmed, OverBudget, Unfit, Unfollowed
from rotsolve.confirm.course.asked import Asker
from rotsolve.confirm.course.astray import LetsGo, MeetAgain
from rotsolve.confirm.course.following import Broken, Course
from rotsolve.confirm.course.node import Budget
from rotsolve.confirm.course.samples import sets_of_numbers, sets_wanted
from rotsolve.confirm.verdicts import SAME
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import UNSOLVED, Fault, Unsolvable
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Find, Problem
from rotsolve.motion.complete import configured
from rotsolve.paths.meaning import NotYet

if TYPE_CHECKING:
    from rotsolve.confirm.space.inquiry import Inquiry

COMPLETE = "nothing is missing in the scene, and nothing in it contradicts the rest: an assembly of all bodies' equations has an answer"
IN_SPACE = "nothing is missing in the scene for that: an assembly of all bodies' equations tells it"
CHANGING = "what drives it changes on the way"
STEADY_DRIVE = "a constant `angular_velocity` is solved"
TOLD = "nothing is missing in the scene: it tells how all bodies stand and move at first, and the laws how they go on"
PARTED = "what comes after that is another motion: ask of what is before it, or end the phase there"
INSTANTS = 2000  # of one body, that a set of numbers may cost
OTHER_SHARE = 0.83  # of the moment about an axis, for what is across it where the scene does not say
STIR = 0.1  # radians, or rates, of what nothing tells
VARYING = "the accelerations vary"


class FollowedCourses:
    """The courses of a scene by its assembly, each followed once for all questions that are looked at."""

    def __init__(self) -> None:
        self.made: list[tuple[Course, Course]] = []
        self.left: Iterator[tuple[Course, Course]] | None = None

    def courses(self, problem: Problem) -> Iterator[tuple[Course, Course]]:
        """With each set of numbers in turn."""
        self.left = courses(problem) if self.left is None else self.left
        yield from self.made
        for pair in self.left:
            self.made.append(pair)
            yield pair


def unsolved(
    problem: Problem, names: Sequence[str], law: str | None, *, whole: bool, followed: FollowedCourses | None = None
) -> Fault | None:
    """What is not solved, where the assembly answers one of some questions, or knows what happens before; None where it does not.

    `whole` asks that it follows all states, as it has to where they are said to contradict each other.
    """
    if problem.space:
        return unsolved_in_space(problem, names, whole=whole)
    try:
        ready = configured(problem).problem
    except (NotYet, Unsolvable):
        return None
    finds = [find for find in ready.finds if find.name in names]
    for course, other in (followed or FollowedCourses()).courses(ready):
        for find in finds:
            if help := answers(course, other, find, whole=whole):
                alone = "" if law is None else f" by {FAMILIES[law].words} alone"
                message = f"`{find.name}` is not solved by these laws{alone}: {hurdle(course, find)}"
                return Fault(message, find.span, help, UNSOLVED)
            if other_way := released_before(course, find):
                return Fault(f"`{find.name}` is not solved by these laws: {other_way}", find.span, PARTED, UNSOLVED)
    return None


def unsolved_in_space(problem: Problem, names: Sequence[str], *, whole: bool) -> Fault | None:
    """The same of a scene in space: what its assembly tells of one of the questions, whatever is drawn for what the scene does not say."""
    from rotsolve.space.complete import configured_in_space

    try:
        ready = configured_in_space(problem).problem
        inquiries = inquiries_in_space(ready)
    except (NotConfirmed, NotYet, Unsolvable):
        return None
    if whole and not all(map(comes_to_states, inquiries)):
        return None
    for find in (find for find in ready.finds if find.name in names and find.where is None):
        try:
            if all(inquiry.tells(find) for inquiry in inquiries) and told_alike(find, inquiries):
                return Fault(f"`{find.name}` is not solved by these laws", find.span, IN_SPACE, UNSOLVED)
        except Unfollowed:
            return Fault(f"`{find.name}` is not solved by these laws: {CHANGING}", find.span, STEADY_DRIVE, UNSOLVED)
        except (NotConfirmed, Unfit, ArithmeticError, ValueError):
            if all(map(told_at_first, inquiries)):
                return Fault(f"`{find.name}` is not solved by these laws", find.span, TOLD, UNSOLVED)
    return None


def comes_to_states(inquiry: Inquiry) -> bool:
    """Whether no state tells beside its time what does not hold where that leads, as far as the motion is followed."""
    for name in (state.name for state in inquiry.problem.states if inquiry.tells_in_time(state.name)):
        try:
            inquiry.followed(name)
        except Unfit:
            return False
        except (NotConfirmed, ArithmeticError, ValueError):
            continue
    return True


def told_at_first(inquiry: Inquiry) -> bool:
    """Whether a scene in space tells how all bodies stand and move at first, and of what comes after when it is, so that the laws tell the
    rest, however long it takes to follow."""
    from rotsolve.confirm.space.motions import by_velocities

    problem = inquiry.problem
    sought = any(given.asked for given in problem.givens) or any(
        isinstance(item.strength(), str) for item in problem.actions
    )
    first, *later = problem.states or (None,)
    if first is None or not later or sought or not inquiry.follows or not all(map(inquiry.only_later, later)):
        return False
    try:
        ways = inquiry.ways(first.name)
    except (NotConfirmed, Unfit, ArithmeticError, ValueError):
        return False
    return len(ways) == 1 and len(by_velocities(ways[0].worlds)) == 1 and not ways[0].worlds[0].stance.open


def inquiries_in_space(problem: Problem) -> tuple[Inquiry, ...]:
    """The scene looked at with numbers that are drawn for its letters; once more with others for what it leaves open, as the inertia of a
    body of which only the mass is said."""
    from rotsolve.confirm.space.inquiry import Inquiry
    from rotsolve.confirm.space.masses import MADE_UP

    sets = list(islice(sets_of_numbers(problem), 2))
    left_open = [given.name for given in problem.givens if given.automatic and given.value is None]
    others = {name: numbers[name] for numbers in sets[1:] for name in left_open if name in numbers}
    return tuple(Inquiry(problem, numbers, {}) for numbers in (sets[0], {**sets[0], **others, MADE_UP: OTHER_SHARE}))


def told_alike(find: Find, inquiries: Sequence[Inquiry]) -> bool:
    """Whether all that is asked is the same each time."""
    one, two = (inquiry.parts(find) for inquiry in inquiries)
    return all(abs(a - b) <= SAME * max(1.0, abs(a)) for a, b in zip(one, two, strict=True))


def released_before(course: Course, find: Find) -> str:
    """What lets go, or meets again, before the states that a question is about, where it certainly does; '' where nothing does."""
    if any(given.value is None for given in course.problem.givens):
        return ""
    try:
        Asker(course.problem, course).answer(find, {})
    except (LetsGo, MeetAgain) as reason:
        return str(reason)
    except (NotConfirmed, ArithmeticError, ValueError):
        return ""
    return ""


def courses(problem: Problem) -> Iterator[tuple[Course, Course]]:
    """The scene followed by the assembly, and once more with what nothing tells otherwise; of letters with several sets of numbers."""
    for numbers in islice(sets_of_numbers(problem), sets_wanted(problem)):
        yield Course(problem, numbers, Budget(INSTANTS)), Course(problem, numbers, Budget(INSTANTS), stir=STIR)


def answers(course: Course, other: Course, find: Find, *, whole: bool) -> str:
    """What says that nothing is missing: the assembly tells what is asked, the same whatever is not told, and no line of a state fails
    in it; or the start tells all. '' where neither is so; `whole` where it has to have followed all states.
    """
    if find.where is not None or find.extreme:
        return ""
    try:
        one, two = (Asker(item.problem, item).answer(find, {}) for item in (course, other))
    except OverBudget:
        return TOLD if not whole and starts_alike(course, other) else ""
    except (NotConfirmed, ArithmeticError, ValueError):
        return ""
    size = max([one.size, *map(abs, one.values.values())])
    if one.word != two.word or any(abs(two.values[key] - own) > SAME * size for key, own in one.values.items()):
        return ""
    try:
        course.hold()
    except Broken:
        return ""
    except (NotConfirmed, ArithmeticError, ValueError):
        return "" if whole else COMPLETE
    return COMPLETE


def starts_alike(course: Course, other: Course) -> bool:
    """Whether the first state tells how all bodies stand and move, so that the laws tell the rest, however long it takes to follow."""
    first, second = (item.node(item.names[0]).placed for item in (course, other))
    pairs = zip((*first.q, *first.speed), (*second.q, *second.speed), strict=True)
    return all(abs(one - two) <= SAME * max(1.0, abs(one)) for one, two in pairs)


def hurdle(course: Course, find: Find) -> str:
    """What the laws have to get over on the way to what is asked: swings, accelerations that vary, a blow, or just the motion."""
    if any(term.path.quantity in OSCILLATING for term in find.terms):
        return "how it swings about its equilibrium"
    last = max((course.names.index(name) for name in asked_states(course, find)), default=0)
    ways = list(zip(course.names[:last], course.names[1 : last + 1], strict=True))
    for start, end in ways:
        if course.event(start, end) is None and varies(course, start, end):
            timed = any(
                line.path is not None and line.path.quantity == "time"
                for line in course.states[course.names.index(end)].conditions
            )
            told = f", and only the time of `{end}` is told" if timed else ""
            return f"{VARYING} from {spoken(start)} to {spoken(end)}{told}"
    for start, end in reversed(ways):
        event = course.event(start, end)
        return f"what `{event.name}` does" if event is not None else f"the motion from {spoken(start)} to {spoken(end)}"
    return (
        f"the forces and accelerations at {spoken(course.names[0])}"
        if course.names[0]
        else "the forces and accelerations"
    )


def asked_states(course: Course, find: Find) -> Iterator[str]:
    """The states of which a question speaks; all where it names none."""
    for term in find.terms:
        names = [name for name in (term.at, term.start, term.end) if name in course.names]
        if term.during is not None:
            names += course.ends(term.during)
        yield from names or course.names


def varies(course: Course, start: str, end: str) -> bool:
    """Whether the accelerations change on the way between two neighbouring states."""
    try:
        return course.varies(start, end)
    except NotConfirmed:
        return True
