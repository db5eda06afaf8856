"""Questions: what a scene asks, or all problems of a sheet, and which answer a heading means: `1.a`, `roll.a`, `a`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.grading.course.handed_in import meant_answer
from rotsolve.language.words import quoted
from rotsolve.page.text import plain_text

IN_BRACKETS = re.compile(r"\s*\(\s*\w+\s*\)\s*")
Asked = tuple[int, str]  # an answer of a sheet: the place of its problem, and its name under `find`


class Task(Struct, frozen=True):
    """One problem that is marked: its title, and what is asked by name with the letter that is printed for it.

    `parts` are the names of the components of vectors in space, each with that of the vector; `points` are those of each answer,
    `dimensions` those of answers and components that have one. On a sheet it has a number and a short name, and its answers the
    labels of its parts, (a), (b), …
    """

    title: str
    letters: Mapping[str, Formula]
    parts: Mapping[str, str] = {}
    points: Mapping[str, Fraction] = {}
    dimensions: Mapping[str, Dimension] = {}
    number: int = 1
    name: str = ""
    labels: Mapping[str, str] = {}

    def letter(self, name: str) -> Words:
        return (self.letters[name],) if name in self.letters else (name,)

    def named(self, word: str) -> str | None:
        """The answer or component that a word means: by its name, else by its label on the sheet; `(a)` is a label alone."""
        name = None if IN_BRACKETS.fullmatch(word) else meant_answer(word, (*self.letters, *self.parts))
        return name or self.labelled(word)

    def labelled(self, word: str) -> str | None:
        """The answer with this label on the sheet."""
        label = word.strip().strip("()").casefold()
        return next((name for name, own in self.labels.items() if own == label), None)


class SheetTask(Struct, frozen=True):
    """All problems that are marked together, those of a sheet or the one of a scene, whose answers need no number before their names."""

    title: str
    tasks: tuple[Task, ...]
    is_sheet: bool = False

    def asked(self) -> Iterator[Asked]:
        """All answers, in the order of the problems and of their questions."""
        return ((place, name) for place, task in enumerate(self.tasks) for name in task.letters)

    def key(self, asked: Asked, *, short: bool = False) -> str:
        """What a column with an answer is called: `1.a`, or in `short` words `roll.a`; of a scene alone `a`."""
        task, name = self.tasks[asked[0]], asked[1]
        return f"{task.name if short else task.number}.{name}" if self.is_sheet else name

    def label(self, asked: Asked) -> Words:
        """What an answer is called on a page: its letter, on a sheet with the number of its problem: 1.α."""
        task = self.tasks[asked[0]]
        return (f"{task.number}.", *task.letter(asked[1])) if self.is_sheet else task.letter(asked[1])

    def heading(self, asked: Asked) -> str:
        """The same as plain text."""
        return plain_text(self.label(asked))

    def problem(self, word: str) -> int | None:
        """The place of the problem with this number or short name."""
        said = word.strip().casefold()
        listed = enumerate(self.tasks)
        return next((place for place, one in listed if said in (str(one.number), one.name.casefold())), None)

    def meant(self, words: str) -> Asked | None:
        """The answer that a heading means. A name without a problem means the only answer of that name on the sheet."""
        head, dot, rest = words.partition(".")
        place = self.problem(head) if dot and self.is_sheet else None
        if place is not None:
            name = self.tasks[place].named(rest)
            return None if name is None else (place, name)
        called = ((place, meant_answer(words, (*one.letters, *one.parts))) for place, one in enumerate(self.tasks))
        found = [(place, name) for place, name in called if name is not None]
        if len(self.tasks) == 1 and (not found or IN_BRACKETS.fullmatch(words)):
            name = self.tasks[0].named(words)
            return None if name is None else (0, name)
        return found[0] if len(found) == 1 else None

    def other_label(self, words: str) -> str:
        """Of a heading that names an answer, and is the label of another one: what is to be said; '' of any other."""
        meant = self.meant(words)
        if meant is None:
            return ""
        task, word = self.tasks[meant[0]], words.rpartition(".")[2] if self.is_sheet else words
        other = task.labelled(word)
        if other in (None, meant[1]) or IN_BRACKETS.fullmatch(word):
            return ""
        own = task.labels.get(task.parts.get(meant[1], meant[1]), "")
        head = words.removesuffix(word)
        said = f"The column {quoted(words)} is taken as the answer named {meant[1]}, which is ({own}) on the sheet"
        return f"{said}; {quoted(f'{head}({word.strip()})')} would be the answer ({word.strip()}) there, {other}."

    def names(self) -> tuple[str, ...]:
        """All that a column may be called, for a suggestion."""
        return tuple(map(self.key, self.asked()))
