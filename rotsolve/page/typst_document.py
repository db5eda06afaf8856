"""A whole Typst document: what stands before its pages: paper, letters and headings, and the functions that set rows.

What is to be measured (which columns there is room for, where a formula is broken) these functions decide: letters have widths there.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from rotsolve.algebra.notation.typst import typst_string

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
  for (place, (label, said)) in rows.pos().enumerate() {
    let text = par(hanging-indent: room, justify: false, box(width: room, strong(label)) + said)
    block(sticky: place + 1 < rows.pos().len(), text)
  }
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

// A formula with its fractions, roots and powers on the line, where they can be broken.
#let flat(body) = {
  if body.has("children") { body.children.map(flat).join() }
  else if body.func() == math.lr { flat(body.body) }
  else if body.func() == math.frac { $($ + flat(body.num) + $) \\/ ($ + flat(body.denom) + $)$ }
  else if body.func() == math.root { $($ + flat(body.radicand) + $)^(1\\/2)$ }
  else if body.func() == math.attach { flat(body.base) + math.attach([], t: body.at("t", default: none), b: body.at("b", default: none)) }
  else { body }
}

// One side of a formula: whole where there is room on a line, else broken at its signs; with smaller letters if a part of it is
// wider than a line, or if these make it fit, where it would be one part that is broken off; flat where they would be tiny.
#let side-of(side, room) = {
  set par(leading: 0em)  // a tall formula keeps its height
  let least = if side.width > room { widest(side.body) }
  if side.width <= room { box(shown(side.body)) }
  else if side.width <= 1.25 * room and least > 0.6 * room { box(text(size: 0.99em * (room / side.width), shown(side.body))) }
  else {
    let body = if least > 1.7 * room { flat(side.body) } else { side.body }
    text(size: 1em * calc.min(1, 0.99 * room / widest(body)), shown(body))
  }
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

// Where the columns of lines stand if what is said takes no more than a share of the width; and of each line, whether it fits into them.
#let columns-by(share, lines, width, inset) = {
  let most(widths, share) = calc.max(0pt, ..widths.filter(one => one <= share * width))
  let said = most(lines.map(it => it.said-width), share)
  let sign = inset + said + most(lines.map(it => it.left.width), 0.3)
  let own(it) = calc.max(sign, inset + said + it.left.width)
  let fit = lines.map(it => own(it) + it.right-width <= it.room)
  let beside = lines.zip(fit).map(((it, fits)) => fits and it.said-width <= said)
  (start: inset + said, own: own, fit: fit, beside: beside)
}

// Lines of formulas with their signs below each other and their numbers at the margin. What is said of one stands before it, or above
// it where there is no room; a line that is too long then begins at the margin.
#let formulas(..lines) = block(above: 1em, below: 1em, layout(size => {
  set par(justify: false, leading: 0.3em, spacing: 0.5em)
  set text(top-edge: 0.75em, bottom-edge: -0.25em)
  let inset = 1.5em.to-absolute()
  let lines = lines.pos().map(measured).map(it => {
    it + (room: size.width - 0.3em.to-absolute() - if it.mark != [] { it.mark-width + inset } else { 0pt })
  })
  let choices = (0.42, 0.55).map(share => columns-by(share, lines, size.width, inset))
  let (start, own, fit, beside) = choices.sorted(key: it => it.beside.filter(one => not one).len()).first()
  for (it, fits, before) in lines.zip(fit, beside) {
    if not before and it.said-width > 0pt { block(sticky: true, it.said) }
    if fits { set-line(it, start, own(it), if before { it.said }, it.room) }
    else { set-line(it, inset, if it.left.width < 0.4 * it.room { inset + it.left.width } else { 2 * inset }, none, it.room) }
  }
}))

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


def picture_page(source: str, wide: float, tall: float, title: str) -> str:
    """A document of one picture, an SVG of this size in points."""
    return (
        f"#set document(title: {typst_string(title)}, date: none)\n"
        f"#set page(width: {wide:.2f}pt, height: {tall:.2f}pt, margin: 0pt)\n"
        f"#image(bytes({typst_string(source)}), width: 100%)\n"
    )


def whole_document(bodies: Sequence[str], language: str, paper: str = "") -> str:
    """A document of pages, each on a sheet of its own, with the title of the first; without a date, so that the same prints the same."""
    found = HEADING.search(bodies[0]) if bodies else None
    title = f"title: [{found[1]}], " if found else ""
    layout = LAYOUT.replace('lang: "en"', f'lang: "{language}"')
    if paper:
        from rotsolve.page.sheet_typst import counted_sheet_in_typst, on_typst_paper

        layout, bodies = on_typst_paper(layout, paper), [*map(counted_sheet_in_typst, bodies)]
    return f"#set document({title}date: none)\n{layout}" + "\n#pagebreak()\n\n".join(bodies)
