"""What friction holds at first and no longer once forces have grown in time: axles, brakes, contacts, clutches, geared and stacked; in
numbers against integrals by hand, and in letters with the condition of each branch."""

from __future__ import annotations

import math

import pytest

from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8


def values(text: str) -> dict[str, float | None]:
    """The answers of a scene, none of them withheld."""
    solution = solve("title: by hand\n" + text)
    assert not solution.refused
    return {name: answer.float for name, answer in solution.answers.items()}


WHEEL = """
bodies: {wheel: {inertia: 2 kg m^2, radius: 0.5 m%(turns)s}}
connections: {axle: {axle: wheel%(rough)s}}
actions: {motor: {couple: %(couple)s, on: wheel}%(brake)s}
states: {start: {wheel.angular_velocity: %(first)s}, end: {%(end)s}}
find: {w: wheel.angular_velocity at end, t: time from start to end}
"""
ROUGH = ", friction_torque: 10 N m"


def wheel(couple: str, *, end: str = "time: 6 s", rough: str = ROUGH, **more: str) -> str:
    return WHEEL % {"turns": "", "brake": "", "first": "0", **more, "couple": couple, "end": end, "rough": rough}


@pytest.mark.parametrize("turns", ["", ", turns: clockwise"])
@pytest.mark.parametrize("sign", [1, -1])
def test_an_axle_gives_way_to_a_growing_couple(sign: int, turns: str) -> None:
    """I ω̇ = c t − τ from τ/c = 2 s on, either way round."""
    assert values(wheel(f"{5 * sign} N m/s * time", turns=turns))["w"] == pytest.approx(sign * 20)
    assert values(wheel(f"{5 * sign} N m/s * time", turns=turns, end="time: 1.9 s"))["w"] == 0


def test_it_does_so_up_to_a_state_that_no_time_tells() -> None:
    assert values(wheel("5 N m/s * time", end="wheel.angular_velocity: 20 rad/s"))["t"] == pytest.approx(6)


def test_a_couple_that_grows_in_another_way() -> None:
    """5 t² = 10 at √2 s; 8 sin 2t passes 3 and is back below it where the phase ends."""
    root = math.sqrt(2)
    found = values(wheel("5 N m/s^2 * time^2", end="time: 3 s"))
    assert found["w"] == pytest.approx((5 * (27 - root**3) / 3 - 10 * (3 - root)) / 2)
    first = math.asin(3 / 8) / 2
    gained = (4 * (math.cos(2 * first) - math.cos(3)) - 3 * (1.5 - first)) / 2
    found = values(wheel("8 N m * sin(2 rad/s * time)", rough=", friction_torque: 3 N m", end="time: 1.5 s"))
    assert found["w"] == pytest.approx(gained)


def test_a_brake_gives_way_to_a_couple_and_where_it_is_let_go() -> None:
    """The block holds up to μ P R: 0.4 · 50 · 0.5 = 10 N m; 0.2 (50 − 4 t) = 6 at 5 s."""
    brake = ", brake: {press: %s, on: wheel.rim, friction: 0.4}"
    assert values(wheel("5 N m/s * time", rough="", brake=brake % "50 N"))["w"] == pytest.approx(20)
    found = values(wheel("6 N m", rough="", brake=brake % "50 N - 4 N/s * time", end="time: 8 s"))
    assert found["w"] == pytest.approx(0.5 * 0.8 * (8 - 5) ** 2 / 2)


def test_what_comes_to_rest_is_started_again() -> None:
    """I ω̇ = c t − τ: 3 − 5 t + t²/4 = 0 at 0.62 s, at rest until 10 s; with 26 rad/s at first it never rests."""
    found = values(wheel("1 N m/s * time", first="3 rad/s", end="time: 25 s"))
    assert found["w"] == pytest.approx(15**2 / 4)
    found = values(wheel("1 N m/s * time", first="26 rad/s", end="time: 25 s"))
    assert found["w"] == pytest.approx(26 - 5 * 25 + 25**2 / 4)


def test_a_fading_couple_drives_it_to_and_fro() -> None:
    """15 − 2 t − 10: it starts at once, rests at 5 s, and is held until 2 t − 15 = 10, at 12.5 s."""
    assert values(wheel("15 N m - 2 N m/s * time", end="time: 10 s"))["w"] == 0
    found = values(wheel("15 N m - 2 N m/s * time", end="time: 14 s"))
    assert found["w"] == pytest.approx(-(1.5**2) / 2)


def test_a_rest_without_a_closed_form_is_refused_by_name() -> None:
    with pytest.raises(Unsolvable, match=r"wheel comes to rest .* at a time without a closed form"):
        solve("title: x" + wheel("8 N m * sin(2 rad/s * time)", rough=", friction_torque: 3 N m"))


BLOCK = """
given: {m: 2 kg, beta: %(beta)s deg}
surfaces: {ramp: {slope: beta}}
bodies: {block: {mass: m, moves: %(moves)s}}
connections: {base: {contact: [block, ramp], friction: {static: 0.5, kinetic: 0.4}}}
actions: {pull: {force: 3 N/s * time, on: block}}
states: {start: at rest, end: {time: 8 s}}
find: {v: block.velocity at end, f: base.friction_force at end}
"""


@pytest.mark.parametrize(("moves", "up"), [("up", 1), ("down", -1)])
def test_a_block_is_pulled_harder_and_harder_along_a_slope(moves: str, up: int) -> None:
    """It rests while c t ≤ m g (μₛ cos β ± sin β)."""
    sine, cosine = math.sin(math.radians(20)), math.cos(math.radians(20))
    start = 2 * G * (0.5 * cosine + up * sine) / 3
    gained = 3 * (64 - start**2) / (2 * 2) - G * (0.4 * cosine + up * sine) * (8 - start)
    found = values(BLOCK % {"beta": "20", "moves": moves})
    assert found["v"] == pytest.approx(gained)
    assert found["f"] == pytest.approx(0.4 * 2 * G * cosine)


ROLLER = """
given: {m: 4 kg, R: 10 cm, c: 8 N/s, mu: 0.2, T: 5 s}
surfaces: {floor: level}
bodies: {roller: {shape: cylinder, mass: m, radius: R, moves: %s}}
connections: {base: {contact: [roller, floor], friction: mu}}
actions: {pull: {force: c*time, on: roller.center, direction: %s}}
states: {start: at rest, end: {time: T}}
find: {v: roller.velocity at end, w: roller.angular_velocity at end}
"""


@pytest.mark.parametrize(("moves", "pulled"), [("right", "right"), ("left", "left"), ("right", "left")])
def test_a_roller_slips_where_rolling_takes_more_friction_than_there_is(moves: str, pulled: str) -> None:
    """Rolling takes c t/3."""
    start = 3 * 0.2 * 4 * G / 8
    speed = 8 * 25 / (2 * 4) - 0.2 * G * (5 - start) - (8 * start**2 / (2 * 4) - 8 * start**2 / (3 * 4))
    spin = (8 * start**2 / (3 * 4)) / 0.1 + 0.2 * 4 * G * 0.1 / (4 * 0.01 / 2) * (5 - start)
    found, sign = values(ROLLER % (moves, pulled)), 1 if moves == pulled else -1
    assert found["v"] == pytest.approx(sign * speed)
    assert found["w"] == pytest.approx(sign * spin)


STACKED = """
given: {m: 2 kg, M: 6 kg, mu: 0.3, c: 10 N/s, T: 4 s}
surfaces: {ice: level}
bodies: {plank: {mass: M, moves: right}, block: {mass: m, moves: right}}
connections: {below: {contact: [plank, ice]%s}, grip: {contact: [block, plank], friction: mu}}
actions: {pull: {force: c*time, on: plank, direction: right}}
states: {start: at rest, end: {time: T}}
find: {v: block.velocity at end, V: plank.velocity at end}
"""


def test_a_block_slips_on_a_plank_that_is_pulled_harder_and_harder() -> None:
    start = 0.3 * G * 8 / 10  # while both go together, c t/(m + M) ≤ μ g
    found = values(STACKED % "")
    assert found["v"] == pytest.approx(10 * start**2 / 16 + 0.3 * G * (4 - start))
    assert found["V"] == pytest.approx(10 * start**2 / 16 + 10 * (16 - start**2) / 12 - 0.3 * 2 * G / 6 * (4 - start))


def test_first_the_plank_gives_way_then_the_block_on_it() -> None:
    """Both stay at rest up to μ₂ (m + M) g, and go together while (c t − μ₂ (m + M) g)/(m + M) ≤ μ g."""
    first, second = 0.1 * 8 * G / 10, 0.4 * 8 * G / 10
    both = 10 * (second - first) ** 2 / 16
    found = values(STACKED % ", friction: 0.1")
    assert found["v"] == pytest.approx(both + 0.3 * G * (4 - second))
    drag = 0.3 * 2 * G + 0.1 * 8 * G
    assert found["V"] == pytest.approx(both + (10 * (16 - second**2) / 2 - drag * (4 - second)) / 6)


GEARED = """
given: {I: 0.2 kg m^2, J: 0.3 kg m^2, a: 0.1 m, b: 0.2 m, tau: 4 N m, c: 1 N m/s, T: 5 s}
bodies: {one: {inertia: I, radius: a}, two: {inertia: J, radius: b}}
connections: {s1: {axle: one%s}, s2: {axle: two, friction_torque: tau}, teeth: {gear: [one, two]}}
actions: {motor: {couple: c*time, on: one}}
states: {start: at rest, end: {time: T}}
find: {w1: one.angular_velocity at end, w2: two.angular_velocity at end}
"""


@pytest.mark.parametrize("own", [0, 1])
def test_geared_wheels_start_where_the_couple_overcomes_all_friction(own: float) -> None:
    """(I + J a²/b²) ω̇ = c t − τ a/b − τ₁: how friction is shared among the axles while they rest is not asked."""
    rest = 4 * 0.1 / 0.2 + own
    found = values(GEARED % (f", friction_torque: {own} N m" if own else ""))
    spin = (5 - rest) ** 2 / 2 / (0.2 + 0.3 / 4)
    assert found["w1"] == pytest.approx(spin)
    assert found["w2"] == pytest.approx(-spin / 2)


def test_a_clutch_slips_where_it_takes_a_disc_along_too_fast() -> None:
    """c t J/(I + J) = τ at 3 s: ω₂ grows by τ/J from there on."""
    found = values("""
bodies: {plate: {inertia: 1 kg m^2}, disc: {inertia: 1 kg m^2}}
connections: {shaft: {axle: [plate, disc]}, clutch: {clutch: [plate, disc], friction_torque: 6 N m}}
actions: {motor: {couple: 4 N m/s * time, on: plate}}
states: {start: at rest, end: {time: 6 s}}
find: {w1: plate.angular_velocity at end, w2: disc.angular_velocity at end}
""")
    assert found["w2"] == pytest.approx(9 + 6 * 3)
    assert found["w1"] == pytest.approx(4 * 36 / 2 - 27)


@pytest.mark.parametrize("at", [2, 2.5, 1])
def test_a_state_that_the_scene_names_on_the_way_changes_nothing(at: float) -> None:
    """Also where it is that at which friction gives way."""
    text = wheel("5 N m/s * time", end=f"time: {6 - at} s").replace("end: {", f"mid: {{time: {at} s}}, end: {{")
    assert values(text)["w"] == pytest.approx(20)


@pytest.mark.parametrize(
    ("text", "forms"),
    [
        (
            "given: {I: kg m^2, tau: N m, c: N m/s, T: s}"
            + wheel("c*time", end="time: T", rough=", friction_torque: tau").replace("2 kg m^2", "I"),
            {"0": ["τ ≥ c T"], "(τ − c T)²/(2 I c)": ["τ < c T"]},
        ),
        (
            ROLLER.replace("4 kg", "kg").replace("8 N/s", "N/s").replace("mu: 0.2", "mu: number") % ("right", "right"),
            {"c T²/(3 m)": ["μ ≥ c T/(3 m g)"], "3 μ² m g²/(2 c) + c T²/(2 m) − μ g T": ["μ < c T/(3 m g)"]},
        ),
    ],
)
def test_letters_tell_up_to_where_it_holds(text: str, forms: dict[str, list[str]]) -> None:
    solution = solve("title: letters\n" + text.replace("T: 5 s", "T: s"))
    name = "w" if "wheel" in text else "v"
    answer = solution.answers[name]
    found = {case.exact: [str(line) for line in case.conditions] for case in (answer, *answer.otherwise)}
    assert found == forms


def test_letters_of_a_fading_couple_tell_all_that_can_happen() -> None:
    """It is held to the end, never rests again, is driven back at once, or after a while at rest."""
    text = wheel("Q - c*time", end="time: T", rough=", friction_torque: tau").replace("2 kg m^2", "I")
    solution = solve("title: letters\ngiven: {I: kg m^2, tau: N m, Q: N m, c: N m/s, T: s}" + text)
    ends, couples = [10.0, 14.0, 4.0, 25.0, 40.0], [15.0, 15.0, 15.0, 40.0, 40.0]
    many = solution.evaluate_many({"I": 2.0, "tau": 10.0, "c": 2.0, "Q": couples, "T": ends})["w"]
    assert list(many) == pytest.approx([0.0, -(1.5**2) / 2, 2.0, (30 * 25 - 25**2) / 2, -100.0])


DRIVEN = {  # what is driven, its greatest friction R, and the mass or inertia that is set going
    "an axle": ("bodies: {it: {inertia: M}}\nconnections: {pin: {axle: it, friction_torque: R}}", "couple"),
    "a wheel the other way": (
        "bodies: {it: {inertia: M, turns: clockwise}}\nconnections: {pin: {axle: it, friction_torque: R}}",
        "couple",
    ),
    "a gear train": (
        "bodies: {it: {inertia: 0.5*M, radius: 2 m}, other: {inertia: 0.125*M, radius: 1 m, turns: clockwise}}\n"
        "connections: {pin: {axle: it, friction_torque: R}, second: {axle: other}, teeth: {gear: [it, other]}}",
        "couple",
    ),
    "a brake": ("bodies: {it: {inertia: M, radius: 2 m}}\nconnections: {pin: {axle: it}}", "couple"),
    "a contact": (
        "surfaces: {floor: level}\nbodies: {it: {mass: M, moves: right}}\n"
        "connections: {base: {contact: [it, floor], friction: R/(M*g)}}",
        "force",
    ),
}
BRAKE = ", block: {press: R, on: it.rim, friction: 0.5}"


STATES = {1: "mid: {time: 0.5*T}, more: {time: 0.5*T}", 2: "mid: {time: T}"}


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    ("kind", "power"),
    [*zip(DRIVEN, (1, 2, 1, 2, 1), strict=True), ("a contact", 2)],  # a force and a couple with each power
)
def test_what_friction_holds_up_to_a_time_is_held_from_then_on(kind: str, power: int) -> None:
    """v → ((Q − R)/c)^(1/n) where Q > R, by as much at T as M v̇ = Q − R − c vⁿ gives; else nothing moves at all."""
    bodies, word = DRIVEN[kind]
    speed = "velocity" if word == "force" else "angular_velocity"
    size = "kg" if word == "force" else "kg m^2"
    unit = ("N" if word == "force" else "N m", ("m" if word == "force" else "rad"))
    along = ", direction: right" if word == "force" else ""
    brake = BRAKE if kind == "a brake" else ""
    states = STATES[power]
    last = states.split(":")[-3].split()[-1] if "more" in states else "mid"
    solution = solve(f"""
title: {kind}
given: {{M: {size}, R: {"N" if brake else unit[0]}, Q: {unit[0]}, c: {unit[0]} s^{power}/{unit[1]}^{power}, T: s}}
{bodies}
actions: {{motor: {{{word}: Q, on: it{along}}}, air: {{{word}: -c*it.{speed}^{power}, on: it{along}}}{brake}}}
states: {{start: at rest, {states}, end: {{it.{speed}: largest}}}}
find: {{e: it.{speed} at end, v: it.{speed} at {last}}}
""")
    assert not solution.refused
    assert any(check.holds and "solved with numbers" in str(check.words) for check in solution.checks)
    for held in (0.3, 0.99, 1.01, 2.5):
        numbers = {
            "g": G,
            "M": 1.7,
            "R": 2.0,
            "Q": 2.0 * held,
            "c": 0.9,
            "T": 1.3,
            "R_it": 2.0,
            "R_other": 1.0,
            "mu_block": 0.5,
        }
        end = max(0.0, 2.0 * held - 2.0) / 0.9
        rate = 0.9 * 1.3 / 1.7
        if power == 2:
            end = math.sqrt(end)
            right = {"e": end, "v": end * math.tanh(rate * end)}
        else:
            right = {"e": end, "v": end * (1 - math.exp(-rate))}
        for name, true in right.items():
            case = holding(solution.answers[name].answer, numbers)
            assert case is not None and case.formula is not None
            assert value_of(case.formula, numbers) == pytest.approx(true)
