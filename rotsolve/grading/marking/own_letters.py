"""Own letters: what an answer says by the letters as its student defined them, `m g/(m + I/R²) with I = M R²`, `… with g = 10 m/s²`.

A letter of the student's, or of the laws, stands for what is said of it. A letter of the scene that gets another number changes nothing
of a formula, but it is judged with that number: the tolerance decides. What differs from the scene is always said.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, Formula, Symbol
from rotsolve.algebra.units.quantities import number_in_unit, unit_for
from rotsolve.core.derivation import Words
from rotsolve.grading.comparing.numbers import certified_number
from rotsolve.grading.comparing.scalars import Same
from rotsolve.grading.marking.target import SceneLetters, Target
from rotsolve.grading.reading.definitions import Defined
from rotsolve.grading.reading.records import FORMULA, NUMBER, LineReading
from rotsolve.grading.verdict import Remark

DEFINED = "defined"  # the kind of the remark on a letter that is not what it is in the scene
EXACTLY, ROUNDED, NEAR = (
    1e-12,
    1 / 400,
    1 / 20,
)  # the shares by which a given, and what is worked out, may differ; a rounded given


class OwnLetters(Struct, frozen=True):
    """The definitions of a student: `forms` are put in for their letters, `numbers` are other numbers for letters that the scene gives."""

    forms: dict[str, Formula]
    numbers: dict[str, Formula]
    remarks: tuple[Remark, ...]
    near: bool = True  # whether all numbers are so near to those of the scene that they may be rounded ones

    @classmethod
    def of(cls, defined: Defined, letters: SceneLetters, target: Target, same: Same) -> OwnLetters:
        """Those of an answer; what is told by the answer itself is a law, not a definition."""
        forms, numbers, remarks = dict[str, Formula](), dict[str, Formula](), list[Remark]()
        for name, typed in defined:
            form = letters.spelled_out(typed)
            if form is None or target.name in form.symbols():
                continue
            meaning = Symbol(name) if name in letters.givens else letters.meaning(name)
            if form.symbols() or meaning is None or certified_number(meaning, letters.values) is None:
                forms[name] = form
                if meaning is not None and form != Symbol(name) and same(form, meaning) is False:
                    remarks.append(Remark(DEFINED, differs_in_words(name, form, letters)))
            elif is_without_unit(name, form, letters):
                remarks.append(Remark(DEFINED, (Symbol(name), " is taken in the unit that it has in the scene")))
            elif not is_near_scene(form, meaning, letters, EXACTLY if name in letters.givens else ROUNDED):
                numbers[name] = form
                remarks.append(Remark(DEFINED, other_number(name, form, letters)))
        near = all(is_near_scene(form, Symbol(name), letters, NEAR) for name, form in numbers.items())
        return cls(forms, numbers, tuple(remarks), near)

    def worked_out(self, reading: LineReading, letters: SceneLetters, target: Target) -> LineReading:
        """A formula, or one with components, as the number that it has with the student's own numbers."""
        parts = tuple(self.worked_out(part, letters, target) for part in reading.parts)
        asked = target.parts[0] if target.parts else target.whole
        if reading.kind != FORMULA or reading.formula is None or asked is None:
            return replace(reading, parts=parts)
        closed = {name: form for name, form in letters.closed.items() if name not in letters.givens}
        formula = reading.formula.substitute({**closed, **self.numbers}).substitute({**letters.values, **self.numbers})
        return reading if formula.symbols() else LineReading(NUMBER, formula=formula, unit=asked.si)


def in_own_letters(reading: LineReading, forms: Mapping[str, Formula]) -> LineReading:
    """A reading with what the student says that letters stand for."""
    formula = None if reading.formula is None else reading.formula.substitute(forms)
    parts = tuple(in_own_letters(part, forms) for part in reading.parts)
    return replace(reading, written=reading.text, formula=formula, parts=parts)


def holds_letters(reading: LineReading, names: Mapping[str, Formula]) -> bool:
    """Whether a reading has one of these letters in it."""
    own = reading.formula is not None and not reading.formula.symbols().isdisjoint(names)
    return own or any(holds_letters(part, names) for part in reading.parts)


def is_near_scene(form: Formula, meaning: Formula, letters: SceneLetters, share: float) -> bool:
    """Whether a number is that of the scene but for a share of it."""
    own, wanted = certified_number(form, {}), certified_number(meaning, letters.values)
    if own is None or wanted is None:
        return False
    return abs(own.float - wanted.float) <= share * abs(wanted.float)


def is_without_unit(name: str, form: Formula, letters: SceneLetters) -> bool:
    """Whether a number is that of a given, but for its unit: L = 80 where L is 80 cm."""
    given = next((one for one in letters.problem.givens if one.name == name), None)
    if given is None or given.unit is None or given.unit.factor == ONE:
        return False
    return is_near_scene(form * given.unit.factor, Symbol(name), letters, EXACTLY)


def differs_in_words(name: str, form: Formula, letters: SceneLetters) -> Words:
    """What is said of a letter that is another formula than in the scene."""
    if name in letters.constants and (meaning := letters.meaning(name)) is not None:
        return (Symbol(name), " is taken as you say, ", form, "; in the scene it is ", meaning)
    return (Symbol(name), " is taken as you say, ", form, ", which is not what it is in the scene")


def other_number(name: str, form: Formula, letters: SceneLetters) -> Words:
    """What is said of a letter that has another number than in the scene."""
    given = next((one for one in letters.problem.givens if one.name == name), None)
    dimension = letters.dimensions.get(name)
    unit = given.unit if given is not None else None if dimension is None else unit_for(dimension)
    values = [form] if given is None or given.value is None else [form, given.value]
    shown = []
    for value in values:
        number = certified_number(value if unit is None else number_in_unit(value, unit), {})
        text = "" if number is None else format(number.float, ".6g")
        shown.append(text if unit is None else unit.after(text))
    there = f"; in the scene it is {shown[1]}" if len(shown) > 1 else ", which is not its number in the scene"
    return (Symbol(name), f" is taken as you say, {shown[0]}{there}")
