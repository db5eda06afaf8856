"""Statement: what a student is told of a problem: its text with the givens filled in, the other givens, and what is asked."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping

from msgspec import Struct

from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.letters import greek
from rotsolve.algebra.notation.letters import parts as letter_parts
from rotsolve.core.derivation import Answer
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.writing import spoken
from rotsolve.keys.working import Worked
from rotsolve.language.problem import Find, Given
from rotsolve.render.voice import Voice
from rotsolve.scene.statement import parts, slots

PATH = re.compile(r"[^\W\d]\w*(?:\.at\([^)]*\)|\.\w+)+")  # rod.end.speed
WORD = re.compile(r"(?<![\w./^])(?<!\d )[A-Za-z]\w*(?![\w/^])")  # no unit behind its number
ENGLISH = ("a", "A", "I")
AXES = ("x", "y", "z", "xx", "yy", "zz", "xy", "yz", "zx")


class Statement(Struct, frozen=True):
    """The title, the paragraphs of the text, the givens that it does not name, what is asked, and which way answers are positive, as one
    format sets them."""

    title: str
    text: tuple[str, ...]
    givens: tuple[str, ...]
    finds: tuple[str, ...]
    positive: tuple[str, ...]


def statement(worked: Worked, voice: Voice) -> Statement:
    """What a problem says."""
    problem = worked.problem
    givens = {given.name: given for given in problem.givens}
    letters = frozenset(filter(is_letter, (*givens, *(find.group for find in problem.finds))))
    named = {slot.name for slot in slots(problem.text)}
    others = [
        given
        for given in problem.givens
        if not given.asked and given.name not in named and (not given.automatic or given.name in worked.told)
    ]
    return Statement(
        voice.prose(problem.title),
        tuple(filled(paragraph, givens, letters, voice) for paragraph in paragraphs(problem.text)),
        tuple(voice.math(voice.given(given)) for given in others),
        tuple(asked(problem.finds, voice)),
        tuple(directions(worked.answers, voice)),
    )


def paragraphs(text: str) -> list[str]:
    """The paragraphs of a text: blank lines stand between them where there are any, else each line is one, as YAML folds them."""
    pieces = re.split(r"\n\s*\n", text) if re.search(r"\n\s*\n", text) else text.split("\n")
    return [" ".join(piece.split()) for piece in pieces if piece.strip()]


def is_letter(name: str) -> bool:
    """Whether a name is a letter, perhaps with something below it, and no English word."""
    letter = letter_parts(name)
    return letter is not None and len(greek(letter.head)) == 1 and name not in ENGLISH


def filled(text: str, givens: Mapping[str, Given], letters: Collection[str], voice: Voice) -> str:
    """A paragraph with its givens."""
    said: list[str] = []
    for part in parts(text):
        if isinstance(part, str):
            said += lettered(part, letters, voice)
        else:
            given = givens[part.name]
            alone = part.alone and given.value is not None
            said.append(voice.math(voice.given_value(given) if alone else voice.given(given)))
    return "".join(said)


def lettered(prose: str, letters: Collection[str], voice: Voice) -> Iterator[str]:
    """Prose in which words that are letters of the scene, such as `m2` and `theta`, are set as such."""
    position = 0
    for match in WORD.finditer(prose):
        if match[0] in letters:
            yield voice.prose(prose[position : match.start()])
            yield voice.math(voice.formula(Symbol(match[0])))
            position = match.end()
    yield voice.prose(prose[position:])


def asked(finds: tuple[Find, ...], voice: Voice) -> Iterator[str]:
    """What is asked, by letters and in words: a (acceleration of block); of a choice its options."""
    seen: set[str] = set()
    for find in finds:
        if find.group in seen:
            continue
        seen.add(find.group)
        letter = voice.math(voice.formula(Symbol(find.group)))
        said = options(find) if find.choice is not None else in_words(find.text)
        plain = not said or said.split()[0] == find.group  # a letter of the scene, which the text speaks of
        yield letter if plain else f"{letter} ({voice.prose(said)})"


def directions(answers: tuple[Answer, ...], voice: Voice) -> Iterator[str]:
    """Which way answers are positive: a: down the slope."""
    for answer in answers:
        if answer.positive:
            yield f"{voice.math(voice.formula(answer.symbol))}: {voice.prose(answer.positive)}"


def options(find: Find) -> str:
    """The options of a choice: which is largest: a: speed of rod; b: speed of disc."""
    assert find.choice is not None
    said = []
    for option in find.choice.options:
        sides = [in_words(side.text) for side in option.sides]
        signs = [f" {sign} " for sign in option.signs] + [""]
        said.append(f"{option.label}: {''.join(side + sign for side, sign in zip(sides, signs, strict=True))}")
    bound = f" {in_words(find.choice.bound.text)}" if find.choice.bound is not None else ""
    test = f"which is {find.choice.test}{bound}: " if find.choice.test else "which holds: "
    return test + "; ".join(said)


def in_words(phrase: str) -> str:
    """A phrase of the language for people: `rod.end.speed at lowest` is the speed of rod end at lowest."""
    return spoken(PATH.sub(lambda match: path_in_words(match[0]), phrase))


def path_in_words(path: str) -> str:
    """`rod.end.speed` as speed of rod end, `pivot.force.x` as x component of force of pivot."""
    words = [re.sub(r"at\((.*)\)", r"at \1", word) for word in re.findall(r"at\([^)]*\)|\w+", path)]
    place = max((index for index, word in enumerate(words) if word in QUANTITIES), default=len(words) - 1)
    owner, quantity, part = " ".join(words[:place]), words[place], " ".join(words[place + 1 :])
    told = f"{part} component of {quantity}" if part in AXES else f"{part} {quantity}".strip()
    return f"{told} of {owner}" if owner else told
