"""Headings: what a section of a derivation is called, by its place in time: "At the start", "Just before the hit", "From start to end"."""

from __future__ import annotations

from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.motion.timeline import Timeline

MOMENTS = (
    frozenset(  # names of states that are moments or places: the others say how it stands or goes then, "when released"
        (
            "start",
            "beginning",
            "end",
            "finish",
            "stop",
            "top",
            "bottom",
            "foot",
            "middle",
            "side",
            "edge",
            "reversal",
            "impact",
            "launch",
        )
    )
)
ALONE = frozenset(("now", "later", "before", "after", "first", "then", "steadily", "outside", "inside"))
SHORT = 2  # letters of a name that is no word: "just after b2", "just after the hit"


def section_title(key: str, scene: SceneEquations) -> str:
    """Heading of a section."""
    timeline = scene.configuration.timeline
    interval = timeline.interval(key)
    swings = scene.swings.values()
    for swing in swings:
        if swing.title(key):
            several = len({other.body for other in swings}) > 1
            return swing.title(key) + (f", {spoken(swing.body)}" if several else "")
    if interval is None:
        return moment_title(key, timeline) if key else ""
    if interval.event is not None:
        return f"The {spoken(interval.name)}"
    return f"From {spoken(interval.start)} to {spoken(interval.end)}"


def moment_title(state: str, timeline: Timeline) -> str:
    """When a state is: just before or after an event where it says no more, at a moment or place, or when something is so."""
    name = spoken(state)
    beside = {"before": timeline.after(state), "after": timeline.before(state)}.get(state)
    if beside is not None and beside.event is not None:
        event = spoken(beside.name)
        return f"Just {name} {event if len(event) <= SHORT or event[-1:].isdigit() else f'the {event}'}"
    if name in ALONE:
        return name.capitalize()
    return f"At the {name}" if name in MOMENTS else f"When {name}"
