"""Cloze: all parts of a problem as one question of Moodle, with a box for each number and a list for each choice, as its text.

So one variant is one question, and whoever draws it has the same numbers in all its parts. Such boxes know no units: they stand behind.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import lcm
from xml.etree.ElementTree import Element

from rotsolve.page.blocks import Math, Phrase
from rotsolve.platforms.known import PlatformPart
from rotsolve.platforms.moodle import QuestionFrame, known_share

WHOLE = (100, 90, 80, 75, 70, 60, 50, 40, 30, 25, 20, 10, 5, 0)  # percents that have no decimals
OWN = str.maketrans(
    {"&": "&amp;", "}": r"\}", "#": r"\#", "~": r"&amp;\#126;", "\\": r"&amp;\#92;", "\n": " "}
)  # HTML within a box: Moodle undoes entities there once, then `\}` and `\#`; a `~` or a `\` would be its own


def cloze(frame: QuestionFrame, name: str, parts: tuple[PlatformPart, ...]) -> Element:
    """One question with all parts that have a number or options; nothing of the others."""
    held = [part for part in parts if part.numbers or part.options]
    weights = box_weights(held)
    asked = "\n".join(part_html(frame, part, weights, len(parts) > 1) for part in held)
    question = frame.question("cloze", name, asked, Fraction(sum(map(box_count, held)) or 1))
    grade = question.find("defaultgrade")
    if grade is not None:
        question.remove(grade)  # Moodle adds up the boxes
    return question


def box_count(part: PlatformPart) -> int:
    return len(part.boxes) if part.numbers else 1


def box_weights(parts: list[PlatformPart]) -> dict[str, int]:
    """The weights of the boxes of each part, the least whole numbers that are to each other as their points."""
    shares = {part.part.name: part.part.points / box_count(part) for part in parts}
    whole = lcm(*(share.denominator for share in shares.values())) if shares else 1
    return {name: max(1, int(share * whole)) for name, share in shares.items()}


def part_html(frame: QuestionFrame, part: PlatformPart, weights: dict[str, int], labelled: bool) -> str:
    """What is asked in a part, and its boxes."""
    label: Phrase = (f"({part.part.label}) ",) if labelled else ()
    asked = frame.printer.sentence((*label, *part.asked))
    weight = weights[part.part.name]
    if not part.numbers:
        return f"{asked}\n<p>{choice_box(frame, part, weight)}</p>"
    return "\n".join((asked, *number_boxes(frame, part, weight)))


def number_boxes(frame: QuestionFrame, part: PlatformPart, weight: int) -> Iterator[str]:
    """A line for each number: its letter, its box, its unit."""
    for place, box in enumerate(part.boxes):
        known = "~".join(number_answers(frame, part, place))
        unit = f" {frame.printer.math(frame.printer.unit(box.unit))}" if box.unit.text else ""
        yield f"<p>{frame.printer.words((Math((box.symbol, '=')),))} {{{weight}:NUMERICAL:{known}}}{unit}</p>"


def number_answers(frame: QuestionFrame, part: PlatformPart, place: int) -> Iterator[str]:
    """The answers of one box, the right one first."""
    seen: set[tuple[str, str]] = set()
    for known in part.numbers:
        share, told = known_share(part, known, place), (known.numbers[place], known.margins[place])
        if share is None or told in seen:
            continue
        seen.add(told)
        yield f"{mark_of(share)}{told[0]}:{told[1]}{feedback_of(frame, known.said)}"


def choice_box(frame: QuestionFrame, part: PlatformPart, weight: int) -> str:
    """A choice, one option below the other, which Moodle shuffles unless they have labels."""
    answers = (
        f"{mark_of(part.options[place].share if place else Fraction(1))}"
        f"{frame.printer.words(part.options[place].shown).translate(OWN)}{feedback_of(frame, part.options[place].said)}"
        for place in part.order
    )
    return f"{{{weight}:{'MULTICHOICE_V' if part.in_words else 'MULTICHOICE_VS'}:{'~'.join(answers)}}}"


def mark_of(share: Fraction) -> str:
    """What an answer is worth: `=`, or in percent, the nearest that Moodle knows; nothing for a wrong one."""
    percent = min(WHOLE, key=lambda known: abs(known - share * 100))
    return "=" if percent == 100 else f"%{percent}%"


def feedback_of(frame: QuestionFrame, said: tuple[Phrase, ...]) -> str:
    return f"#{frame.printer.sentence(*said).translate(OWN)}" if said else ""
