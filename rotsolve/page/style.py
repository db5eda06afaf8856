"""Style: the style sheets of HTML pages, which they hold themselves."""

from __future__ import annotations

STYLE = """\
body { font: 11.5pt/1.5 Georgia, "Times New Roman", serif; color: #111; background: #fff; }
body { max-width: 50em; margin: 1.5em auto; padding: 0 1em; }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math; }
h1, h2, h3 { line-height: 1.25; break-after: avoid; }
h1 { font-size: 1.5em; margin: 0 0 .6em; }
h2 { font-size: 1.15em; margin: 1.3em 0 .4em; border-bottom: 1px solid #bbb; }
h3 { font-size: 1em; margin: 1em 0 .3em; }
p, ul { margin: .4em 0; }
table { border-collapse: collapse; margin: .3em 0; }
td { padding: .25em .6em .25em 0; vertical-align: baseline; }
td.left { text-align: right; padding-right: .1em; white-space: nowrap; }
td.right { padding-right: 1.2em; white-space: nowrap; }
td.said { color: #333; min-width: 8em; }
td.then { text-align: right; }
td.left math, td.right math { math-style: normal; }
tr { break-inside: avoid; }
.wide { overflow-x: auto; }
.label { font-weight: bold; margin-right: .5em; }
.fault { font-weight: bold; color: #a00; }
article + article { break-before: page; border-top: 2px solid #888; margin-top: 3em; padding-top: 2em; }
@media print {
  body { margin: 0; max-width: none; font-size: 10.5pt; }
  .wide { overflow: visible; }
  article + article { border: 0; margin: 0; padding: 0; }
}
"""
JUDGED_STYLE = """\
code { font: .95em/1.4 "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
td:not(.remark) > code { display: block; width: max-content; max-width: 32em; }
mark { background: #fff3a3; border-bottom: 2px solid #c80; }
th { text-align: left; padding: .25em .6em .25em 0; border-bottom: 1px solid #bbb; font-weight: normal; color: #555; }
td.verdict, td.marks { white-space: nowrap; padding-left: 1em; }
td.marks { width: 100%; }
td.good { color: #060; } td.bad { color: #a00; font-weight: bold; } td.open { color: #850; font-weight: bold; }
td.remark { padding-top: 0; }
"""  # of pages with student's texts or tables
