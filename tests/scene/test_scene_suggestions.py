"""What a message says to write is written, and the scene reads: each kind of mistake is made in a good scene, and mended so."""

from __future__ import annotations

import re

import pytest

from rotsolve.core.faults import Fault, SceneError, Span
from rotsolve.scene.read import read_text

SCENE = """title: Block on a disc
given: {m: 2 kg, M: 5 kg, R: 20 cm, w: 3 rad/s}
bodies:
  block:
    mass: m
    moves: down
  disc: {shape: disc, mass: M, radius: R, turns: clockwise}
connections:
  axle: {axle: disc}
  cord: {string: [disc, block]}
states:
  now: {disc.angular_velocity: w}
find:
  a: block.acceleration at now
  T: cord.tension at now
"""
MISTAKES = {  # what is written in place of what
    "unit missing": ("m: 2 kg", "m: 2"),
    "unit missing in place": ("radius: R", "radius: 20"),
    "unit misspelt": ("5 kg", "5 kgg"),
    "sign": ("R: 20 cm", "R: -20 cm"),
    "sign in place": ("radius: R", "radius: -20 cm"),
    "brace never closed": ("20 cm, w: 3 rad/s}", "20 cm, w: 3 rad/s"),
    "brace never closed in a section": ("turns: clockwise}", "turns: clockwise"),
    "bracket never closed": ("block]", "block"),
    "both never closed": ("disc, block]}", "disc, block"),
    "brace too many": ("{axle: disc}", "{axle: disc}}"),
    "bracket for a brace": ("3 rad/s}", "3 rad/s]"),
    "comma left out": ("2 kg, M", "2 kg M"),
    "semicolon": ("2 kg, M", "2 kg; M"),
    "equals sign": ("m: 2 kg", "m = 2 kg"),
    "colon left out": ("m: 2 kg", "m 2 kg"),
    "colon of a line left out": ("    mass: m", "    mass m"),
    "colon of a name left out": ("  block:\n", "  block\n"),
    "colon of a section left out": ("states:\n", "states\n"),
    "colon before a brace left out": ("axle: {axle", "axle {axle"),
    "blank behind a colon": ("m: 2 kg", "m:2 kg"),
    "blank behind the colon of a line": ("    mass: m", "    mass:m"),
    "decimal comma": ("R: 20 cm", "R: 0,2 m"),
    "decimal comma in quotes": ("R: 20 cm", 'R: "0,2 m"'),
    "thousands": ("m: 2 kg", 'm: "1,000 kg"'),
    "both signs": ("m: 2 kg", 'm: "1.000,5 kg"'),
    "blank in a number": ("m: 2 kg", "m: 1 000 kg"),
    "underscore in a number": ("m: 2 kg", "m: 1_000 kg"),
    "hexadecimal": ("m: 2 kg", "m: 0x10 kg"),
    "unit in front": ("m: 2 kg", "m: kg 2"),
    "power without its sign": ("w: 3 rad/s", "w: 3 rad/s, b: 9.8 m/s2"),
    "letter for nought": ("R: 20 cm", "R: 2O cm"),
    "two points": ("R: 20 cm", "R: 0..2 m"),
    "uncertainty": ("m: 2 kg", "m: 2 ± 0.1 kg"),
    "equals sign in front": ("m: 2 kg", "m: = 2 kg"),
    "section": ("given:", "givens:"),
    "section in capitals": ("bodies:", "BODIES:"),
    "section by another word": ("bodies:", "objects:"),
    "key": ("turns:", "turn:"),
    "key in capitals": ("mass: m", "Mass: m"),
    "shape": ("shape: disc", "shape: disk"),
    "connection": ("{axle: disc}", "{axel: disc}"),
    "choice": ("moves: down", "moves: Down"),
    "letter": ("radius: R", "radius: r"),
    "body": ("[disc, block]", "[disc, blok]"),
    "quantity": ("block.acceleration", "block.accelaration"),
    "state": ("a: block.acceleration at now", "a: block.acceleration at nwo"),
    "word of a phrase": ("a: block.acceleration at now", "a: block.acceleration att now"),
    "given twice": ("M: 5 kg", "m: 5 kg"),
    "body twice": ("  disc: {", "  block: {"),
}


def faults_in(text: str) -> tuple[Fault, ...]:
    try:
        read_text(text, "s.yaml")
    except SceneError as error:
        return error.faults
    return ()


def replaced(text: str, span: Span, new: str) -> str:
    """The text with what stands at a place replaced."""
    lines = text.split("\n")
    line, start = lines[span.line - 1], span.column - 1
    lines[span.line - 1] = f"{line[:start]}{new}{line[start + span.length :]}"
    return "\n".join(lines)


def mended(text: str, fault: Fault) -> str:
    """The text as the help of a fault says that it should be."""
    assert fault.span is not None
    if at_end := re.match(r"write `(.+)` at the end of line (\d+)", fault.help):
        lines = text.split("\n")
        lines[int(at_end[2]) - 1] += at_end[1]
        return "\n".join(lines)
    if fault.help == "leave it out":
        return replaced(text, fault.span, "")
    if told := re.match(r"(?:write a unit|leave out the sign): `((\w+): .+)`", fault.help):
        return re.sub(rf"\b{told[2]}: -?\d+[^,}}\n]*", told[1], text, count=1)
    meant = re.match(r"(?:did you mean|write|write a decimal point:) `(.+?)`", fault.help)
    assert meant is not None, fault.help
    missing = fault.related and "never closed" in fault.message
    return replaced(text, fault.related[0].span if missing else fault.span, meant[1])


def test_the_scene_is_good() -> None:
    assert faults_in(SCENE) == ()


@pytest.mark.parametrize("kind", MISTAKES)
def test_what_the_help_says_makes_the_scene_good(kind: str) -> None:
    old, new = MISTAKES[kind]
    assert SCENE.count(old) >= 1
    wrong = SCENE.replace(old, new, 1)
    found = faults_in(wrong)
    assert len(found) == 1, found
    assert faults_in(mended(wrong, found[0])) == (), found


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_line_breaks_and_a_mark_in_front_change_nothing(mark: str, ending: str) -> None:
    text = SCENE.replace("5 kg", "5 kgg")
    other = mark + text.replace("\n", ending)
    assert faults_in(mark + SCENE.replace("\n", ending)) == ()
    assert [(fault.message, fault.span) for fault in faults_in(other)] == [
        (fault.message, fault.span) for fault in faults_in(text)
    ]
