"""Pages in other languages: whole goldens, words of the scene, numbers, and what stays in English because no table says it."""

from __future__ import annotations

from pathlib import Path

import pytest

import rotsolve
from rotsolve.page.languages import LANGUAGES, language_named
from rotsolve.page.languages.language import Translation
from rotsolve.page.languages.patterns import SLOT

ROOT = Path(__file__).resolve().parents[2]
EXPECTED = Path(__file__).parent / "expected"
GOLDEN = ("pulleys/double-atwood", "hinged/rod-30", "rolling/ball-on-incline")


def german(*names: str) -> Translation:
    language = language_named("de")
    assert language is not None
    return Translation(language, frozenset(names))


@pytest.mark.parametrize("problem", GOLDEN)
def test_whole_pages(problem: str, regenerate: bool) -> None:
    text = rotsolve.solve(ROOT / "problems" / f"{problem}.yaml").to(language="de")
    file = EXPECTED / f"{Path(problem).name}.de.txt"
    if regenerate:
        file.write_text(text, encoding="utf-8")
    assert text == file.read_text(encoding="utf-8")


def test_words_of_the_scene_stay_as_they_are() -> None:
    page = german("rod", "down")
    assert page.translate("Newton's second law for rod and down") == "2. newtonsches Gesetz für rod und down"
    assert page.translate("moment of inertia, rod about its end") == "Trägheitsmoment, Stab um das eigene Ende"


def test_what_no_table_says_stays_in_english_and_is_told() -> None:
    page = german()
    assert (
        page.translate("dimensions agree; the moon is made of cheese")
        == "die Dimensionen stimmen; the moon is made of cheese"
    )
    assert page.lost == {"the moon is made of cheese"}


def test_numbers_have_the_sign_of_the_language() -> None:
    solution = rotsolve.solve(ROOT / "problems/pulleys/block-on-disc.yaml")
    assert "4,356 m/s²" in solution.to(language="de")
    assert "4{,}356" in solution.to("latex", language="de", pictures=False)
    html = solution.to("html", language="de", pictures=False)
    assert "<mn>4,356</mn>" in html and '<html lang="de">' in html and 'width="0.22em"' in html
    assert solution.to("json", language="de") == solution.to("json")


def test_an_unknown_language_is_told_with_those_there_are() -> None:
    with pytest.raises(KeyError, match="en, de"):
        language_named("xx")


@pytest.mark.parametrize("name", [name for name in LANGUAGES if name != "en"])
def test_lines_have_the_same_slots_on_both_sides(name: str) -> None:
    language = language_named(name)
    assert language is not None
    for pattern in language.patterns:
        assert set(SLOT.findall(pattern.target)) == set(pattern.slots), pattern
        assert len(set(pattern.slots)) == len(pattern.slots), pattern
