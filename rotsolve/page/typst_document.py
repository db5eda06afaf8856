"""A whole Typst document: what stands before its pages: paper, letters and headings, and the functions that set rows.

What is to be measured (which columns there is room for, where a formula has to be broken) these functions decide, where letters have widths.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

HEADING = re.compile(r"^= (.*)$", re.MULTILINE)
LAYOUT = """\
#set page(paper: "a4", margin: (x: 25mm, top: 24mm, bottom: 26mm), numbering: "1")
#set text(font: "New Computer Modern", size: 11pt, lang: "en")
#set par(justify: true, leading: 0.6em, spacing: 0.75em)
#set list(indent: 0.4em, body-indent: 0.6em, spacing: 0.6em)
#show math.equation: set text(font: "New Computer Modern Math", weight: 400)
#show raw: set text(font: "DejaVu Sans Mono", size: 1.1em)
#show heading: set text(hyphenate: false)
#show heading: set par(justify: false)
#show heading.where(level: 1): set text(size: 15pt)
#show heading.where(level: 1): set block(below: 1.1em)
#show heading.where(level: 2): set text(size: 12pt)
#show heading.where(level: 2): set block(above: 1.5em, below: 0.8em)
#show heading.where(level: 3): set text(size: 11pt)
#show heading.where(level: 3): set block(above: 1.2em, below: 0.7em)

#let wide(body) = measure(body).width
#let fault(said) = text(fill: rgb("#a00000"), strong(said))

// Within words a line ends behind a formula, not in it.
#show math.equation.where(block: false, numbering: none): it => context if wide(it) < 70mm { box(it) } else { it }

// A picture in the middle of the page.
#let picture(width, source) = align(center, block(above: 0.8em, below: 1.2em, image(bytes(source), width: width)))

// Labels, each with what belongs to it in a column behind.
#let labels(..rows) = context {
  let room = calc.max(0pt, ..rows.pos().map(((label, said)) => wide(strong(label)))) + 1em.to-absolute()
  for (label, said) in rows.pos() { block(par(hanging-indent: room, justify: false, box(width: room, strong(label)) + said)) }
}

// What is said of formulas, above them.
#let above(said) = block(above: 1em, below: 0.7em, sticky: true, said)

// A line of formulas: what is said of it, its left side, all that equals it, words behind, and its number.
#let line-of(said, left, ..sides, behind: [], mark: []) = (
  said: said, left: left, sides: sides.pos(), behind: behind, mark: mark,
)

// A formula with tall fractions. Its numbering, which is not printed, tells it from those within words.
#let shown(body) = math.equation(math.display(body), numbering: "1")

// The line with its formulas as they are shown, and how wide its parts are.
#let measured(it) = {
  let sides = it.sides.map(side => (body: side.body, width: wide(shown(side.body))))
  let right = sides.map(side => side.width + 0.33em.to-absolute()).sum(default: 0pt)
  let left = (body: it.left.body, width: wide(shown(it.left.body)))
  it + (left: left, sides: sides, said-width: wide(it.said), right-width: right, mark-width: wide(it.mark))
}

// The widest part of a formula within which no line can end.
#let widest(body) = {
  if body.has("children") { calc.max(0pt, ..body.children.map(widest)) }
  else if body.func() == math.lr { widest(body.body) }
  else { wide(shown(body)) }
}

// One side of a formula: whole where there is room on a line, else broken at its signs; with smaller letters if a part of it is wider than a
// line, or if they make it fit, where it would be one part that is broken off.
#let side-of(side, room) = {
  set par(leading: 0em)  // a tall formula keeps its height
  let least = if side.width > room { widest(side.body) }
  if side.width <= room { box(shown(side.body)) }
  else if side.width <= 1.25 * room and least > 0.6 * room { box(text(size: 0.99em * (room / side.width), shown(side.body))) }
  else if least <= room { shown(side.body) }
  else { text(size: 0.99em * (room / least), shown(side.body)) }
}

// One line: `start` is where its left side begins at the earliest, `sign` where it ends.
#let set-line(it, start, sign, said, room) = block(par(hanging-indent: sign + 0.3em, {
  box(width: start, said)
  h(calc.max(0pt, sign - start - it.left.width))
  side-of(it.left, room - start)
  h(0.3em)
  it.sides.map(side => side-of(side, room - sign)).join([ ])
  it.behind
  if it.mark != [] { [ ] + h(1fr) + box(it.mark) }
}))

// Lines of formulas with their signs below each other and their numbers at the margin. What is said of one stands before it, or above it where
// there is no room; a line that is too long then begins at the margin.
#let formulas(..lines) = layout(size => {
  set par(justify: false, leading: 0.3em, spacing: 0.5em)
  set text(top-edge: 0.75em, bottom-edge: -0.25em)
  let inset = 1.5em.to-absolute()
  let lines = lines.pos().map(measured)
  let most(widths, share) = calc.max(0pt, ..widths.filter(width => width <= share * size.width))
  let said-room = most(lines.map(it => it.said-width), 0.42)
  let start = inset + said-room
  let sign = start + most(lines.map(it => it.left.width), 0.3)
  for it in lines {
    let room = size.width - 0.3em.to-absolute() - if it.mark != [] { it.mark-width + inset } else { 0pt }
    let own-sign = calc.max(sign, start + it.left.width)
    let fits = own-sign + it.right-width <= room
    let beside = fits and it.said-width <= said-room
    if not beside and it.said-width > 0pt { block(sticky: true, it.said) }
    if fits { set-line(it, start, own-sign, if beside { it.said }, room) }
    else { set-line(it, inset, calc.min(inset + it.left.width, 0.4 * room), none, room) }
  }
})

// A table with a rule below its head.
#let columns-of(count, ..cells) = table(
  columns: count, stroke: none, inset: (x: 0.5em, y: 0.35em), align: left, ..cells, table.hline(y: 1, stroke: 0.6pt),
)

// What someone wrote with what is thought of it, and below what is said of it.
#let tones = (good: rgb("#006000"), bad: rgb("#a00000"), open: rgb("#805500"))
#let assessed(..rows) = grid(
  columns: (auto, 1fr, auto, auto), column-gutter: 1em, row-gutter: 0.8em,
  ..rows.pos().map(it => {
    let (label, said, verdict, marks, ..remarks) = it.cells
    (label, said, text(fill: tones.at(it.tone), verdict), marks)
    remarks.map(remark => ([], grid.cell(colspan: 3, remark))).flatten()
  }).flatten()
)

"""


def whole_document(bodies: Sequence[str]) -> str:
    """A document of pages, each on a sheet of its own, with the title of the first, and without a date: what is the same prints the same."""
    found = HEADING.search(bodies[0]) if bodies else None
    title = f"title: [{found[1]}], " if found else ""
    return f"#set document({title}date: none)\n{LAYOUT}" + "\n#pagebreak()\n\n".join(bodies)
