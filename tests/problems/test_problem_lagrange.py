"""Every bundled problem by Lagrange's equations: answered as published (test_problem_answers), or refused for one of a few reasons.

Which problems are refused, and why, stands here by name, so that none is lost without notice.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from rotsolve.core.derivation import NEXT, sentences
from rotsolve.core.equation import FAMILIES, LAGRANGE
from rotsolve.core.faults import Fault, Unsolvable
from solutions import solved

GOLDEN = Path(__file__).resolve().parent / "lagrange"
RAW = re.compile(r"[a-z_]\|[a-z_]|…")  # the key of a quantity of the laws, which no reader should see
SAID = FAMILIES[LAGRANGE].words

BLOWS = """pencil-rolls-over-its-edges
disc-into-a-corner ball-strikes-a-double-pendulum balls-in-a-row double-pendulum-struck-below folding-door-at-a-stop
jointed-rods-caught-at-an-end puck-sticks-to-jointed-rods three-jointed-rods-struck two-balls-strike-a-rod-at-once door-at-its-stop
rod-falls-on-an-edge rod-lands-on-two-pegs rod-falls-slanting-on-a-rough-floor hinged-rod-falls-on-a-rough-floor
ball-with-backspin-bounces dumbbell-hits-a-wall super-ball-under-a-table hinged-plates-that-are-struck meteorite-that-stays-in-a-probe
bat-sweet-spot block-trips-over-ridge blow-on-rod-on-ice bullet-in-rod-swing bullet-on-ice centre-of-percussion disc-drop
bullet-in-a-bar-in-pounds plate-caught-at-corner projectile-into-rod rod-caught-at-end rod-on-ice-blow ball-rolls-over-step
blow-on-a-box blow-on-a-plate-at-a-corner disc-struck-at-its-rim cube-caught-at-an-edge plate-struck-where-its-hinges-feel-nothing"""
INERTIA_CHANGES = """ball-bounces-twice
bead-flung-along-a-bar beads-drawn-inwards beads-to-double-speed man-walks-inwards man-walks-round man-with-weights
sand-on-a-turntable sleeve-on-a-driven-rod wheel-on-a-stool carpet-unrolls skater-pulls-in
satellite-with-a-reaction-wheel"""
REACTIONS = """arm-rocked-by-a-crank bead-in-a-driven-tube bead-in-a-driven-tube-at-a-time scotch-yoke
wheel-with-rolling-resistance bar-on-two-skew-rods disc-on-an-axle-that-sways coin-that-trembles gyrocompass-that-swings
hookes-joint rod-on-two-cords
ladder-inside plank-on-trestles plank-tips whirled-rod incline-pulley-rest
plate-moved-by-machine cylinder-like-a-sphere oblique-cylinder plate-diagonal plate-normal plates-on-their-diagonals propeller
rotor-in-a-turning-frame skew-disc skew-rod train-on-a-curve turbine-of-a-ship wheel-on-step-pulled wheel-on-step-pushed
fan-with-two-blades propeller-that-turns-two-ways shaft-out-of-balance two-plane-balancing masses-that-balance-a-rotor
sign-held-by-two-cables"""
FRICTION = """spinning-wheel-set-down spool-largest-pull bar-kept-on-a-driven-prism hawser-round-a-bollard"""
NO_LAW = """puck-of-given-momentum coin-on-a-turntable top-that-creeps-to-the-vertical
disc-through-60-degrees earth-turning moon-turning wheel-acceleration-by-angle wheel-angle-polynomial wheel-angle-quadratic
wheel-constant-acceleration wheel-falling-acceleration wheel-reversed wheel-runs-back wheel-slowed-by-its-speed wheel-speed-from-angle
which-pair-of-angles stone-from-a-tower shell-fired-east"""
NO_COORDINATES = """force-off-the-centre spherical-top plate-that-wobbles-in-time pole-of-the-earth-in-time
tennis-racket wing-nut between-both-cases between-both-cases-in-space tennis-racket-in-the-hand"""  # of ω along own axes
DISTURBED = "book-about-its-middle-axis stability-of-three-axes"  # by Euler's equations
NUTATION = "sleeping-top-touched spherical-pendulum-nods top-that-trembles"  # small, in the effective potential
NONHOLONOMIC = "coin-in-a-circle ball-across-a-slope ball-on-a-turntable ball-on-a-tilted-turntable"
TOLD_BY_POWER = "flywheel-constant-power"
UNKNOWN_TRACK = "loop-the-loop rough-slide-then-smooth-one"
GIVEN_TURN = "momentum-as-a-function-of-time"
ROUND_SIDES = (
    "particle-in-a-free-bowl particle-off-a-free-dome bead-in-a-hoop-on-ice"  # v = V + u t ties rates at one moment
)

NOTHING, ALONE = "do not settle anything that is asked here", "alone can not tell"
REASONS = {  # the problems, and what the message and its help say
    BLOWS: (ALONE, "angular momentum gives it"),
    INERTIA_CHANGES: (ALONE, "angular momentum gives it|energy gives it|more than one law"),
    REACTIONS: (NOTHING, "it takes Newton's laws"),
    FRICTION: (f"{NOTHING}|{ALONE}", "it takes Newton's laws|angular momentum gives it"),
    NO_LAW: (NOTHING, "none of the laws"),
    NO_COORDINATES: (NOTHING, "whose parts are no rates of coordinates"),
    DISTURBED: (NOTHING, "it takes Newton's laws"),
    NUTATION: (ALONE, "energy gives it"),
    NONHOLONOMIC: (NOTHING, "ties its rates, and not its coordinates"),
    TOLD_BY_POWER: (NOTHING, "does not tie places"),
    UNKNOWN_TRACK: (ALONE, "energy gives it"),
    ROUND_SIDES: (f"{ALONE}|is not solved by these laws", "more than one law|an assembly"),
    GIVEN_TURN: (NOTHING, "it takes Newton's laws|none of the laws"),
}
REFUSED = {name: reason for names, reason in REASONS.items() for name in names.split()}


def refusals(file: Path) -> Iterator[Fault]:
    """Why Lagrange's equations do not answer questions of a problem."""
    try:
        yield from (reason.fault for reason in solved(file, LAGRANGE).refused.values())
    except Unsolvable as error:
        yield error.fault


@pytest.mark.sampled(3)
def test_it_is_answered_or_refused_for_a_known_reason(problem_file: Path) -> None:
    found = list(refusals(problem_file))
    message, help = REFUSED.get(problem_file.stem, ("", ""))
    assert bool(found) == (problem_file.stem in REFUSED), [fault.message for fault in found]
    for fault in found:
        assert SAID in fault.message and re.search(message, fault.message), fault.message
        assert fault.help and re.search(help, fault.help), fault.help


@pytest.mark.sampled(3)
def test_its_page_has_printed_letters_alone(problem_file: Path) -> None:
    try:
        solution = solved(problem_file, LAGRANGE)
    except Unsolvable:
        return
    assert not RAW.search(solution.to("text"))
    assert [check for check in solution.checks if check.holds is False] == []


@pytest.mark.parametrize(
    "path", ["pulleys/atwood", "rolling/cylinder-on-incline", "space/leaning-top", "space/top-let-go"]
)
def test_whole_pages(path: str, regenerate: bool) -> None:
    file = Path(__file__).resolve().parents[2] / "problems" / f"{path}.yaml"
    text, golden = solved(file, LAGRANGE).to("text", width=100), GOLDEN / f"{file.stem}.txt"
    if regenerate:
        GOLDEN.mkdir(exist_ok=True)
        golden.write_text(text, encoding="utf-8")
    assert text == golden.read_text(encoding="utf-8")


def test_a_remark_is_as_many_sentences_as_are_parted() -> None:
    assert sentences(("a", NEXT, "b ", "c")) == (("a",), ("b ", "c"))
