"""Page: one page of HTML on which a motion moves: its pictures as data, a small script, its quantities and what happens on the way."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence

from rotsolve.draw.paper.reel import Reel
from rotsolve.draw.paper.slots import Slots, slots_of
from rotsolve.draw.paper.svg import SPECIAL, label_line, short_number, style_sheet
from rotsolve.simulation.animation.clock import Clock, clock_for
from rotsolve.simulation.animation.filming import film
from rotsolve.simulation.animation.player import SCRIPT, STYLE
from rotsolve.simulation.animation.reading import MotionReading
from rotsolve.simulation.report import quantity_unit, settled_cells, time_cells, time_text
from rotsolve.simulation.run import Run
from rotsolve.simulation.senses import sense_words

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)  # of the show, beside its usual one
SMALLEST = 10.0  # points of the largest body, below which all are small
SMALL = '<p class="note">The bodies go far beyond their own size, and are drawn small: a shorter time shows them larger.</p>'
CODE = re.compile("`([^`]*)`")  # a name of the scene in a message
MOST_EVENTS = 60  # that have a mark


def animated(run: Run, names: Sequence[str], step: float | None = None) -> str:
    """The page of a motion with the numbers of some quantities, and a picture after each step, or as many as the eye needs."""
    clock = clock_for(run.end, step)
    reading = MotionReading(run, clock.times)
    return animation_page(reading, names, clock, film(reading))


def animation_page(reading: MotionReading, names: Sequence[str], clock: Clock, reel: Reel) -> str:
    """The whole page."""
    run, slots = reading.run, slots_of(reel)
    title = (run.problem.title or run.problem.file or "Motion").translate(SPECIAL)
    lines = [
        "<!DOCTYPE html>",
        '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width,initial-scale=1">',
        f"<title>{title}</title>",
        f"<style>{style_sheet(True)}{STYLE}</style></head>",
        f'<body class="rotsolve"><main><h1>{title}</h1>',
        *picture_lines(slots, reel),
        *control_lines(run, clock),
        *([SMALL] if reel.largest < SMALLEST else []),
        *readout_lines(names, reading),
        *event_lines(run),
        f'<p class="note">{run.signs.translate(SPECIAL)}</p>',
        '<noscript><p class="note">The motion is shown by a script; without it there is the picture at first alone.</p></noscript>',
        "</main>",
        f'<script type="application/json" id="motion">{motion_data(slots, reading, clock, names)}</script>',
        f"<script>{SCRIPT}</script>",
        "</body></html>",
    ]
    return "\n".join([*lines, ""])


def picture_lines(slots: Slots, reel: Reel) -> Iterator[str]:
    """The picture as it is at first; the script moves it."""
    box = f"0 0 {short_number(slots.wide)} {short_number(slots.tall)}"
    yield (
        f'<svg id="picture" viewBox="{box}" width="{short_number(slots.wide * 4 / 3)}" role="img" aria-labelledby="picture-title '
        'picture-words">'
    )
    yield f'<title id="picture-title">{reel.title.translate(SPECIAL)}</title>'
    yield f'<desc id="picture-words">{reel.description.translate(SPECIAL)}</desc>'
    for line in slots.lines:
        role, shape, x, y = (first_of(line[key]) for key in "rsxy")
        yield f'<path class="{slots.roles[role]}" d="M{short_number(x / 10)} {short_number(y / 10)}{slots.shapes[shape]}"/>'
    for label in reel.labels:
        yield f'<g class="label">{label_line(label, slots.origin)}</g>'
    yield "</svg>"


def first_of(told: int | list[int]) -> int:
    return told if isinstance(told, int) else told[0]


def control_lines(run: Run, clock: Clock) -> Iterator[str]:
    """The button, the slider with its marks, the time and the speed."""
    last = len(clock.times) - 1
    yield '<div class="controls" role="group" aria-label="Playback">'
    yield '<button id="play" type="button" aria-label="Play">▶</button>'
    yield '<div class="track">'
    yield f'<input id="time" type="range" min="0" max="{last}" value="0" step="1" aria-label="Time">'
    for event in run.events[:MOST_EVENTS]:
        share = 100 * event.time / run.end if run.end else 0.0
        said = f"{event.state or event.what}, t = {time_text(event.time, event.bound)} s".translate(SPECIAL)
        yield f'<i class="tick" style="--at:{share:.2f}" title="{said}"></i>'
    yield "</div>"
    yield '<output id="clock" for="time">t = 0 s</output>'
    yield '<label>speed <select id="speed" aria-label="Speed">'
    for factor in sorted({*SPEEDS, 1.0}):
        chosen = " selected" if factor == 1.0 else ""
        yield f'<option value="{factor * clock.pace:.9g}"{chosen}>{pace_words(factor * clock.pace)}</option>'
    yield "</select></label></div>"
    yield f'<p class="note">{pace_sentence(clock, run)}</p>'
    yield '<p id="event" class="event" role="status" aria-live="polite"></p>'


def pace_words(pace: float) -> str:
    """How fast a motion is shown beside how it is."""
    if abs(pace - 1.0) < 1e-9:
        return "real time"
    return f"{1 / pace:.3g} times slower" if pace < 1.0 else f"{pace:.3g} times faster"


def pace_sentence(clock: Clock, run: Run) -> str:
    """Whether the motion is shown as fast as it is, and where it ends."""
    shown = "Shown in real time." if clock.pace == 1.0 else f"Shown {pace_words(clock.pace)} than it is."
    ended = f" It ends at t = {time_text(run.end, 0.0)} s: {run.ended}." if run.ended else ""
    return CODE.sub(r"<code>\1</code>", f"{shown}{ended}".translate(SPECIAL))


def readout_lines(names: Sequence[str], reading: MotionReading) -> Iterator[str]:
    """The quantities of the table, with their units, and how they count."""
    yield '<table id="numbers"><caption>Quantities at this time</caption>'
    yield '<thead><tr><th scope="col">quantity</th><th scope="col">value</th><th scope="col">unit</th></tr></thead><tbody>'
    for name in names:
        sense = sense_words(reading.run, name)
        said = f"{name} <small>({sense})</small>" if sense else name
        yield f'<tr><th scope="row">{said}</th><td></td><td>{quantity_unit(name)}</td></tr>'
    yield "</tbody></table>"


def event_lines(run: Run) -> Iterator[str]:
    """What happens on the way, each a button that goes there."""
    if not run.events:
        return
    yield '<h2>On the way</h2><ul class="events">'
    for event in run.events[:MOST_EVENTS]:
        said = (event.state or event.what).translate(SPECIAL)
        when = f"t = {time_text(event.time, event.bound)} s"
        yield f'<li><button type="button" data-at="{event.time!r}">{when}</button> {said}</li>'
    if len(run.events) > MOST_EVENTS:
        yield f"<li>and {len(run.events) - MOST_EVENTS} more</li>"
    yield "</ul>"


def motion_data(slots: Slots, reading: MotionReading, clock: Clock, names: Sequence[str]) -> str:
    """All that the script shows, as JSON."""
    reading.read(tuple(names))
    events = [{"at": event.time, "what": event.state or event.what} for event in reading.run.events]
    data = {
        "end": reading.run.end,
        "step": clock.step,
        "times": time_cells(clock.times),
        "roles": slots.roles,
        "shapes": slots.shapes,
        "lines": slots.lines,
        "labels": slots.labels,
        "names": list(names),
        "values": [settled_cells(reading.balls(name)) for name in names],
        "events": events,
    }
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
