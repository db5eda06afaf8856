"""Scenes in a mirror, angles and places too, are answered as large and the other way round."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from trials.outcome import SOLVED, Printed, outcome
from trials.reflect import not_mirrored, reflected
from trials.scene import read, written

ROOT = Path(__file__).parents[2]
ALL = sorted([*ROOT.glob("problems/*/*.yaml"), *ROOT.glob("tests/engine/scenes/*.yaml")])
FILES = [
    file for file in ALL if "\nup: z" not in file.read_text(encoding="utf-8")
]  # of the plane, where left is mirrored to right
ALWAYS = ("chimney-tip-outruns-gravity", "axle-on-a-swinging-rod", "gear-on-a-carrier", "contact-ladder", "rod-falls")
UPRIGHT = ("work-of-weight",)  # which has neither left nor right
SAMPLE = [file for file in FILES if file.stem in ALWAYS] + random.Random(1).sample(FILES, 40)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("file", dict.fromkeys(SAMPLE), ids=lambda file: file.stem)
def test_answers_are_mirrored(file: Path) -> None:
    scene = read(file.read_text(encoding="utf-8"))
    other = reflected(scene)
    if other is not None and file.stem not in UPRIGHT:
        assert written(other) != written(scene)
        assert not list(not_mirrored(outcome(written(scene), 7), outcome(written(other), 7), scene))


def test_most_scenes_have_a_mirror_image() -> None:
    scenes = [reflected(read(file.read_text(encoding="utf-8"))) for file in FILES]
    assert sum(scene is not None for scene in scenes) > len(FILES) / 2


SPUN = """
title: Rod that is pushed round
gravity: none
given: {M: 2 kg, L: 1 m, F: 3 N}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
actions: {push: {force: F, on: rod.end, direction: up}}
states: {now: {rod.angle: 30 deg, at rest: all}}
find: {alpha: rod.angular_acceleration, a: rod.end.acceleration.x}
"""


def test_what_is_not_mirrored_is_found() -> None:
    """Another size, or the same direction, is a difference."""
    scene = read(SPUN)
    other = reflected(scene)
    assert other is not None
    one, image = outcome(written(scene), 7), outcome(written(other), 7)
    assert one.kind == image.kind == SOLVED
    assert not list(not_mirrored(one, image, scene))
    assert list(not_mirrored(one, one, scene))
    image.answers["alpha"] = Printed("1.5", said=image.answers["alpha"].said)
    assert list(not_mirrored(one, image, scene))
