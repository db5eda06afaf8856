"""SVG: a picture as a browser shows it: text stays text, the same picture gives the same bytes, on dark and on light paper.

Written with the standard library alone: to import a drawing library takes twenty times as long as to make a picture (docs/decisions.md).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from zlib import crc32

from rotsolve.draw.paper.figure import ROLES, Circle, Figure, Label, Line, Mark, Point, arrow_heads
from rotsolve.draw.paper.lettering import letter_runs

SPECIAL = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})
LIGHT = {
    "ink": "#1c1c1e", "faint": "#6a6a70", "paper": "#ffffff", "body": "#dfe6ee", "ground": "#eeeae2",
    "force": "#b3261e", "sense": "#1f6f43", "spin": "#1d4f91",
}  # fmt: skip
DARK = {
    "ink": "#ececee", "faint": "#a0a0a8", "paper": "#17181b", "body": "#3a4450", "ground": "#2e2b26",
    "force": "#ff8a80", "sense": "#7bd6a2", "spin": "#8ab8f5",
}  # fmt: skip
FONTS = "'STIX Two Text','Latin Modern Roman',Georgia,'Times New Roman',serif"
TYPST_FONT = "'New Computer Modern'"
VARIABLE = re.compile(r"var\(--(\w+)\)")
BASELINE = 0.34  # of a text's size, from its middle down to its line


def colours(table: dict[str, str]) -> str:
    return ";".join(f"--{name}:{colour}" for name, colour in table.items())


def style_sheet(adapts: bool) -> str:
    """The style sheet: a class for each role; dark colours where the reader's paper is dark, if the picture stands for itself."""
    rules = [f".rotsolve{{{colours(LIGHT)};font-family:{FONTS}}}"]
    if adapts:
        rules.append(f"@media (prefers-color-scheme:dark){{.rotsolve{{{colours(DARK)}}}}}")
    rules.append(".rotsolve path,.rotsolve circle{fill:none;stroke-linejoin:round;stroke-linecap:round}")
    for role in ROLES:
        ink = f"stroke:var(--{role.ink});stroke-width:{role.width:g}" if role.ink and role.width else "stroke:none"
        fill = f";fill:var(--{role.fill})" if role.fill else ""
        dash = f";stroke-dasharray:{role.dash}" if role.dash else ""
        rules.append(f".rotsolve .{role.name}{{{ink}{fill}{dash}}}")
    rules += [
        f".rotsolve .to-{name}{{fill:var(--{name});stroke:none}}" for name in ("ink", "faint", "force", "sense", "spin")
    ]
    rules.append(".rotsolve text{text-anchor:middle;stroke:none}.rotsolve i,.rotsolve .l{font-style:italic}")
    return "".join(rules)


def svg(figure: Figure, *, adapts: bool = True) -> str:
    """A picture as an SVG element; `adapts` to dark paper by itself. Its title has a name of its own among others on a page."""
    left, low, right, high = figure.box()
    wide, tall = right - left, high - low
    name = f"rs{crc32(repr(figure.marks).encode()):08x}"
    title = figure.title.translate(SPECIAL)
    room = f'width="{short_number(wide * 4 / 3)}" height="{short_number(tall * 4 / 3)}"'
    box = f'viewBox="0 0 {short_number(wide)} {short_number(tall)}" aria-labelledby="{name}-t {name}-d"'
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" class="rotsolve" role="img" {room} {box}>',
        f'<title id="{name}-t">{title}</title>',
        f'<desc id="{name}-d">{figure.description.translate(SPECIAL)}</desc>',
        f"<style>{style_sheet(adapts)}</style>",
    ]
    if adapts:
        lines.append('<rect width="100%" height="100%" style="fill:var(--paper)"/>')
    origin = (left, high)
    for mark in figure.in_layers():
        lines += svg_mark(mark, origin)
    lines += [label_line(label, origin) for label in figure.labels]
    return "\n".join([*lines, "</svg>", ""])


def plain_svg(figure: Figure) -> str:
    """A picture for programs that know no variables in style sheets, on light paper, with the letters of a Typst document."""
    text = svg(figure, adapts=False).replace(f"{colours(LIGHT)};", "").replace(FONTS, TYPST_FONT)
    return VARIABLE.sub(lambda found: LIGHT[found[1]], text)


def short_number(value: float) -> str:
    """A number with two digits behind the point, and no more of them than it needs."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def svg_place(point: Point, origin: Point) -> str:
    return f"{short_number(point[0] - origin[0])} {short_number(origin[1] - point[1])}"


def svg_mark(mark: Mark, origin: Point) -> Iterator[str]:
    """A line or a circle, with the heads of arrows."""
    if isinstance(mark, Circle):
        x, y = svg_place(mark.centre, origin).split()
        yield f'<circle class="{mark.role.name}" cx="{x}" cy="{y}" r="{short_number(mark.radius)}"/>'
        return
    yield f'<path class="{mark.role.name}" d="{path(mark, origin)}"/>'
    for triangle in arrow_heads(mark):
        corners = " ".join(svg_place(corner, origin) for corner in triangle)
        yield f'<path class="to-{mark.role.ink}" style="fill:var(--{mark.role.ink})" d="M{corners}Z"/>'


def path(line: Line, origin: Point) -> str:
    points = list(line.points)
    return f"M{' '.join(svg_place(point, origin) for point in points)}{'Z' if line.closed else ''}"


def label_line(label: Label, origin: Point) -> str:
    """Words, with the pieces that lean or stand below the line."""
    x, y = label.at[0] - origin[0], origin[1] - label.at[1] + BASELINE * label.size
    pieces, low = [], False
    prose = label.latex[:1] != "$"
    for run in letter_runs(label.text, prose):
        shift = (
            f' dy="{short_number(0.25 * label.size if run.below else -0.25 * label.size)}"' if run.below != low else ""
        )
        small = f' font-size="{short_number(0.72 * label.size)}"' if run.below else ""
        leans = ' class="l"' if run.leans else ""
        said = run.text.translate(SPECIAL)
        pieces.append(f"<tspan{leans}{shift}{small}>{said}</tspan>" if shift or small or leans else said)
        low = run.below
    return (
        f'<text x="{short_number(x)}" y="{short_number(y)}" font-size="{short_number(label.size)}" style="fill:var(--{label.ink})">'
        f"{''.join(pieces)}</text>"
    )
