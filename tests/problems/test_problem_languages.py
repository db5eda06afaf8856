"""All bundled problems in other languages: nothing is left in English, and formulas and numbers are those of the English page."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec import Struct

from rotsolve.page.derivation import DerivationPage
from rotsolve.page.languages import ENGLISH, LANGUAGES, language_named
from rotsolve.page.languages.language import Translation
from rotsolve.page.languages.pages import Translator
from solutions import solved

OTHERS = [name for name in LANGUAGES if name != ENGLISH]


def texts(value: Any) -> Iterator[str]:
    """What stands on a page, bit by bit, formulas as they are kept."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple | list):
        for one in value:
            yield from texts(one)
    elif isinstance(value, Struct):
        for field in value.__struct_fields__:
            yield from texts(getattr(value, field))


@pytest.mark.parametrize("name", OTHERS)
def test_nothing_is_left_in_english(problem_file: Path, name: str) -> None:
    solution = solved(problem_file)
    language = language_named(name)
    assert language is not None
    page = DerivationPage(solution.derivation, scene=solution.problem)
    translation = Translation(language, page.names())
    english = list(page.blocks())
    translated = list(map(Translator(translation).block, english))
    assert not translation.lost, f"lines for rotsolve/page/languages/{name}.txt"

    def digits(blocks: Any) -> Counter[str]:
        return Counter(re.findall(r"\d", "".join(texts(blocks)).replace("2. newtonsche", "")))

    assert digits(translated) == digits(english)
