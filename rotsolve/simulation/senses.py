"""Senses: in words, the way or the turn along which a quantity of a motion counts."""

from __future__ import annotations

from rotsolve.core.vectors.heading import TURNS
from rotsolve.simulation.report import quantity_word
from rotsolve.simulation.run import Run
from rotsolve.simulation.system import PlanarSystem, path_name

AXES = {"x": "right", "y": "up"}
COUNTED = (
    "velocity",
    "acceleration",
    "position",
    "displacement",
    "force",
)  # quantities whose components count along the axes


def sense_words(run: Run, name: str) -> str:
    """`down` of `block.velocity`, `clockwise` of `disc.angular_velocity`; '' of what has no sense, or tells its axis by its name."""
    system = run.regimes[0].system
    if not isinstance(system, PlanarSystem):
        return ""
    owner, component, word = name.partition(".")[0], name.rpartition(".")[2], quantity_word(name)
    if word == "angle":
        return TURNS[0]
    if component in AXES and word in COUNTED:
        return AXES[component]
    if word == "position":
        return system.moment.line_words(owner)[0]
    if word == "rotation":
        return system.moment.turn_words(owner)[0]
    quantities = system.moment.registry.quantities
    letter = next((letter for letter in quantities if path_name(letter) == name), None)
    return quantities[letter].positive if letter is not None else ""
