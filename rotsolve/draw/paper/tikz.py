"""TikZ: a picture for LaTeX, one `tikzpicture` that any document with the package tikz sets; or a document of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.draw.paper.figure import ROLES, Circle, Figure, InkRole, Mark, Point, arrow_heads

COLOURS = {
    "ink": "black", "faint": "black!60", "paper": "white", "body": "black!9", "ground": "black!6",
    "force": "red!65!black", "sense": "green!45!black", "spin": "blue!60!black",
}  # fmt: skip
PREAMBLE = r"""\documentclass[border=4pt]{standalone}
\usepackage{amsmath}
\usepackage{tikz}
\begin{document}
"""


def tikz(figure: Figure) -> str:
    """A picture as a `tikzpicture`."""
    styles = ",\n".join(f"  rs {role.name}/.style={{{tikz_style(role)}}}" for role in ROLES)
    title = " ".join(figure.title.split())  # on one line, so that none of it is more than a comment
    lines = [rf"% {title}", r"\begin{tikzpicture}[x=1pt,y=1pt,line join=round,line cap=round,", styles + "]"]
    for mark in figure.in_layers():
        lines += tikz_mark(mark)
    for label in figure.labels:
        size = rf"\fontsize{{{tikz_number(label.size - 1)}}}{{{tikz_number(label.size)}}}\selectfont"
        colour = "" if label.ink == "ink" else f",text={COLOURS[label.ink]}"
        lines.append(rf"\node[inner sep=0pt{colour}] at {tikz_place(label.at)} {{{size} {label.latex}}};")
    return "\n".join([*lines, r"\end{tikzpicture}", ""])


def document(pictures: Sequence[Figure]) -> str:
    """A document of pictures, each on a sheet as large as it is."""
    return PREAMBLE + "\n".join(tikz(picture) for picture in pictures) + "\\end{document}\n"


def tikz_style(role: InkRole) -> str:
    """The options of a role."""
    ink = f"draw={COLOURS[role.ink]},line width={role.width:g}pt" if role.ink and role.width else "draw=none"
    fill = f",fill={COLOURS[role.fill]}" if role.fill else ""
    dashes = role.dash.split()
    pattern = " ".join(f"{'off' if k % 2 else 'on'} {size}pt" for k, size in enumerate(dashes))
    return ink + fill + (f",dash pattern={pattern}" if pattern else "")


def tikz_number(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def tikz_place(point: Point) -> str:
    return f"({tikz_number(point[0])},{tikz_number(point[1])})"


def tikz_mark(mark: Mark) -> Iterator[str]:
    """A line or a circle, with the heads of arrows."""
    if isinstance(mark, Circle):
        yield rf"\path[rs {mark.role.name}] {tikz_place(mark.centre)} circle[radius={tikz_number(mark.radius)}pt];"
        return
    end = " -- cycle" if mark.closed else ""
    yield rf"\path[rs {mark.role.name}] {' -- '.join(map(tikz_place, mark.points))}{end};"
    for corners in arrow_heads(mark):
        yield rf"\fill[{COLOURS[mark.role.ink]}] {' -- '.join(map(tikz_place, corners))} -- cycle;"
