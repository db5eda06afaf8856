"""Plain text: the derivation as a textbook sets it, in aligned columns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.core.derivation import Answer, Derivation, ForceLine, LawLine, Move, Section
from rotsolve.render.layout import (
    ARROW,
    GAP,
    HELD,
    Line,
    Row,
    hold,
    labelled,
    page,
    paragraph,
    release,
    table,
    together,
    wrap,
)
from rotsolve.render.options import Options
from rotsolve.render.voice import TEXT, exact, lettered, shown, shown_components

SEPARATOR = "─" * 72


def body(derivation: Derivation, options: Options) -> str:
    """The whole derivation as text."""
    return page(lines(derivation, options))


def document(bodies: Sequence[str]) -> str:
    """Several derivations one below the other."""
    return f"\n{SEPARATOR}\n\n".join(bodies)


def lines(derivation: Derivation, options: Options) -> Iterator[Line]:
    """The derivation line by line, each with its role."""
    width = options.width
    if derivation.title:
        yield from paragraph(derivation.title, 0, width, "title")
        yield Line("")
    yield from opening(derivation, width)
    yield Line("")
    for section in derivation.sections:
        yield from titled(section, width) if section.title else untitled(section, width)
    yield Line("Answers", "heading")
    yield from answer_lines(derivation.answers, options)
    if derivation.checks:
        yield Line("Checks", "heading")
        yield from check_lines(derivation, width)


def opening(derivation: Derivation, width: int) -> Iterator[Line]:
    """Source, givens with the conventions, what is asked, and the states."""
    if derivation.source:
        yield from labelled("Source", [together(derivation.source)], " ", width)
    givens = ", ".join(hold(TEXT.given(given)) for given in shown(derivation.givens))
    conventions = "; ".join(TEXT.words(words) for words in derivation.conventions)
    apart = HELD * 10
    if givens and conventions and 8 + len(givens) + len(apart) + len(conventions) <= width:
        yield from labelled("Given", [givens + apart + conventions.replace(" ", HELD)], "", width)
    else:
        for text in filter(None, (givens, conventions)):
            yield from labelled("Given" if text is givens else "Signs", [text], "", width)
    finds = [TEXT.words(words) for words in derivation.finds]
    if finds:
        yield from labelled("Find", finds, ", " if lettered(derivation.finds) else "; ", width)
    if derivation.states:
        yield from labelled("States", [TEXT.words(words) for words in derivation.states], HELD * 5, width)


def untitled(section: Section, width: int) -> Iterator[Line]:
    """The only instant of a scene: forces, laws and algebra under a heading each."""
    if section.forces:
        yield Line("Forces", "heading")
        yield from force_lines(section.forces, 2, width)
    if section.remarks or section.laws:
        yield Line("Laws", "heading")
        for remark in section.remarks:
            yield from paragraph(TEXT.words(remark), 2, width)
        yield from table([law_row(law) for law in section.laws], 2, width)
    if section.moves:
        yield Line("Solve", "heading")
        yield from table(move_rows(section.moves), 2, width)


def titled(section: Section, width: int) -> Iterator[Line]:
    """One instant, phase or event of several: all below its title, laws and algebra in one table."""
    yield from paragraph(section.title, 0, width, "heading")
    if len(section.forces) == 1 and not section.forces[0].remarks:
        yield from single_body(section.forces[0], width)
    elif section.forces:
        yield Line("  Forces", "", 8)
        yield from force_lines(section.forces, 4, width)
    for remark in section.remarks:
        yield from paragraph(TEXT.words(remark), 2, width)
    yield from table([*map(law_row, section.laws), *move_rows(section.moves)], 2, width)


def single_body(line: ForceLine, width: int) -> Iterator[Line]:
    """The forces of the only body behind the heading."""
    said = [TEXT.words(words) for words in line.forces]
    yield from labelled("Forces", [*said, *([f"positive: {line.positive}"] if line.positive else [])], "; ", width, 2)


def force_lines(forces: tuple[ForceLine, ...], indent: int, width: int) -> Iterator[Line]:
    """One row a body: its forces, its positive sense, and its remarks in brackets below."""
    column = indent + max(len(line.body) for line in forces) + 3
    said = ["; ".join(TEXT.words(words) for words in line.forces) for line in forces]
    positives = [f"positive: {line.positive}" if line.positive else "" for line in forces]
    room = width - column - GAP - max(map(len, positives))
    end = column + max((len(text) for text in said if len(text) <= room), default=0) + GAP
    for line, text, positive in zip(forces, said, positives, strict=True):
        first, *more = wrap(text, width - column, 2) or [""]
        fits = not more and column + len(first) + GAP <= end
        below = more + ([] if fits or not positive else [f"({positive})"])
        head = " " * indent + line.body.ljust(column - indent) + first
        yield Line(release(head.ljust(end) + positive if fits else head))
        below += wrap(f"({'; '.join(map(TEXT.words, line.remarks))})", width - column, 1) if line.remarks else []
        yield from (Line(release(" " * column + part)) for part in below)


def law_row(law: LawLine) -> Row:
    remark = f"({TEXT.words(law.remark)})" if law.remark else ""
    return Row(f"({law.number}) {law.law}", hold(TEXT.equality(law.equation)), remark)


def move_rows(moves: tuple[Move, ...]) -> list[Row]:
    """One row a step, the arrows below each other where there are any."""
    chains = [[hold(TEXT.equality(equality)) for equality in move.chain] for move in moves]
    starts = [len(chain[0]) for chain in chains if len(chain) > 1]
    start = max((length for length in starts if length <= 40), default=0)
    rows = []
    for move, chain in zip(moves, chains, strict=True):
        reason = TEXT.words(move.reason)
        if len(chain) > 1:
            chain = [chain[0].ljust(start, HELD), *chain[1:]]
        steps = f"{HELD * 3} {ARROW}{HELD * 3}".join(chain)  # one blank, at which a long chain may be broken
        number = f"({move.number})" if move.number is not None else ""
        behind = f"({reason})" if reason and move.sources else ""
        rows.append(Row(move.sources or reason, steps, " ".join(filter(None, (number, behind)))))
    return rows


def answer_lines(answers: tuple[Answer, ...], options: Options) -> Iterator[Line]:
    yield from table(
        [row for answer in answers for row in answer_rows(answer, options.digits)], 2, options.width, "answer"
    )


def answer_rows(answer: Answer, digits: int, inset: str = "") -> Iterator[Row]:
    """An answer and, further in, its components: symbol, exact form, certified number, direction."""
    if answer.rows:
        from rotsolve.render.matrix import text_rows

        yield from text_rows(answer, digits)
        return
    formula, amount = exact(answer), TEXT.amount(answer, digits)
    symbol, aside = hold(TEXT.formula(answer.symbol)), TEXT.aside(answer, digits)
    sides = [hold(TEXT.formula(formula))] if formula is not None else []
    if sides and amount:
        yield Row(f"{inset}{symbol} = {sides[0]}", f"= {hold(amount)}{aside}")
    elif sides or amount:
        yield Row(f"{inset}{symbol} = {sides[0] if sides else hold(amount)}{aside}")
    else:
        yield Row(f"{inset}{symbol}: {aside.removeprefix(', ').strip()}")
    for component in shown_components(answer):
        yield from answer_rows(component, digits, inset + HELD * 2)


def check_lines(derivation: Derivation, width: int) -> Iterator[Line]:
    """What holds, in one paragraph; then what fails and what could not be decided, one a line."""
    items = [TEXT.words(check.words) for check in derivation.checks if check.holds]
    good = " · ".join(item.replace(" ", HELD) if len(item) <= width // 2 else item for item in items)
    if good:
        yield from paragraph(good, 2, width, "check")
    for check in derivation.checks:
        if not check.holds:
            verdict = "not decided" if check.holds is None else "does not hold"
            yield from paragraph(f"{verdict}: {TEXT.words(check.words)}", 2, width, "fault")
