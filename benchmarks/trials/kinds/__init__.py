"""Kinds: families of random scenes, each with the physics of its answers worked out by hand."""

from __future__ import annotations

from collections.abc import Callable

from trials.case import Case
from trials.draw import Draw
from trials.kinds import blows, hinged, rolling, strings, swings, turning

KINDS: tuple[Callable[[Draw], Case], ...] = (
    strings.train,
    strings.stepped_drum,
    strings.moving_pulley,
    strings.double_atwood,
    strings.yoyo,
    rolling.on_slope,
    rolling.pulled,
    rolling.thrown,
    rolling.slides_down,
    hinged.released,
    hinged.falls,
    hinged.held,
    hinged.ladder,
    swings.small,
    swings.wide,
    swings.torsion,
    swings.sprung,
    blows.joined,
    blows.bounced,
    blows.struck,
    turning.gears,
    turning.speeded,
    turning.dragged,
    turning.reversed_turn,
    turning.pieces,
)
