"""Every output format, whole: two derivations compared with the files in `expected/`."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.notation.parse import parse
from rotsolve.core.derivation import Answer, Check, Derivation
from rotsolve.page.blocks import Bullets, Paragraph, Table, Title
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.formats import FORMATS, WIDTH, Format, format_named, format_of_file
from rotsolve.page.printer import simplified
from rotsolve.page.tex import LATEX_SPECIAL, MATHEMATICS
from rotsolve.page.text import plain_text
from rotsolve.page.values import given_equation

EXPECTED = Path(__file__).parent / "expected"
TEXTS = [item.name for item in FORMATS.values() if not item.binary]
SUFFIXES = {item.name: item.suffixes[0] for item in FORMATS.values()}


def body(derivation: Derivation, format: str = "text", width: int = WIDTH, file: str = "") -> str:
    """The derivation in a format, with four digits."""
    return format_named(format).body(DerivationPage(derivation, file=file), width)


@pytest.mark.parametrize("name", ["block_on_disc", "rod_released"])
@pytest.mark.parametrize("format", TEXTS)
def test_a_derivation_is_printed_as_expected(
    name: str, format: str, request: pytest.FixtureRequest, expected: Callable[[Path, str], None]
) -> None:
    printed = body(request.getfixturevalue(name), format, file=f"{name}.yaml")
    expected(EXPECTED / (name + SUFFIXES[format]), format_named(format).document([printed]))


@pytest.mark.parametrize("width", [50, 72])
def test_narrow_text_is_folded_at_good_places(
    crowded: Derivation, width: int, expected: Callable[[Path, str], None]
) -> None:
    expected(EXPECTED / f"crowded-{width}.txt", body(crowded, "text", width))


@pytest.mark.parametrize("width", range(50, 130))
def test_no_line_is_wider_than_the_page(
    crowded: Derivation, block_on_disc: Derivation, rod_released: Derivation, width: int
) -> None:
    for derivation in (crowded, block_on_disc, rod_released):
        text = body(derivation, "text", width)
        assert max(map(len, text.splitlines())) <= width
        assert all(line == line.rstrip() for line in text.splitlines())


@pytest.mark.parametrize("format", TEXTS)
def test_several_derivations_make_one_document(
    block_on_disc: Derivation, rod_released: Derivation, format: str
) -> None:
    bodies = [body(item, format) for item in (block_on_disc, rod_released)]
    document = format_named(format).document(bodies)
    if format == "json":
        assert [item["title"] for item in json.loads(document)] == [block_on_disc.title, rod_released.title]
    else:
        first, second = map(document.index, bodies)
        assert 0 <= first < second
    assert document.count(r"\begin{document}") == (format == "latex")


def test_json_holds_certified_digits_and_both_notations(rod_released: Derivation) -> None:
    data = json.loads(body(rod_released, "json", file="rod.yaml"))
    assert data["file"] == "rod.yaml"
    assert data["answers"][2] == {
        "name": "omega",
        "symbol": "ω",
        "exact": {"text": "−√(3 g (1 + sin θ₀)/L)", "ascii": "-sqrt(3*g*(1 + sin(theta0))/L)"},
        "value": "-6.641",
        "note": "",
        "unit": "rad/s",
        "direction": "clockwise",
        "angle": None,
        "word": "",
        "remark": "",
        "components": [],
    }


def answers(derivation: Derivation, *items: Answer) -> Derivation:
    return replace(derivation, answers=items, sections=(), checks=())


def printed(derivation: Derivation, format: str = "text") -> str:
    return body(derivation, format).rpartition("Answers\n")[2]


def test_an_answer_without_a_closed_form(block_on_disc: Derivation, made: Any) -> None:
    assert printed(answers(block_on_disc, made.answer("t", None, "1.234", "s"))) == "  t = 1.234 s\n"


def test_an_answer_without_a_number(block_on_disc: Derivation, made: Any) -> None:
    text = printed(answers(block_on_disc, made.answer("a", "m g/M", None, "", "down")))
    assert text == "  a = m g/M, down\n"


def test_an_answer_that_is_a_word(block_on_disc: Derivation, made: Any) -> None:
    assert printed(answers(block_on_disc, made.answer("w", None, None, "", word="slips"))) == "  w: slips\n"


def test_an_answer_with_components(block_on_disc: Derivation, made: Any) -> None:
    parts = (made.answer("F_x", "m g", "−3.1", "N"), made.answer("F_y", "2 m g", "6.2", "N"))
    angle = evaluate(parse("atan(2)*180/pi"), {})
    vector = replace(made.answer("F", "sqrt(5) m g", "6.9", "N", "up and to the left", components=parts), angle=angle)
    assert printed(answers(block_on_disc, vector)).splitlines() == [
        "  F = √5 m g       = 6.9 N, up and to the left, at 63.43° to the horizontal",
        "    Fₓ = m g       = −3.1 N",
        "    F_y = 2 m g    = 6.2 N",
    ]
    data = json.loads(body(answers(block_on_disc, vector), "json"))["answers"][0]
    assert data["angle"] == "63.43"
    assert [part["name"] for part in data["components"]] == ["F_x", "F_y"]


@pytest.mark.parametrize("format", ["text", "markdown", "latex"])
def test_a_brief_vector_is_told_by_size_and_direction(block_on_disc: Derivation, made: Any, format: str) -> None:
    parts = (made.answer("F_x", "0", "0", "N"), made.answer("F_y", "m g", "6.2", "N"))
    vector = made.answer("F", "m g", "6.2", "N", "up", components=parts)
    brief = body(answers(block_on_disc, replace(vector, brief=True)), format)
    assert "F_y" not in brief.replace("_{y}", "_y")
    assert "F_y" in body(answers(block_on_disc, vector), format).replace("_{y}", "_y")


def test_a_small_number_has_a_power_of_ten(block_on_disc: Derivation, made: Any) -> None:
    small = answers(block_on_disc, made.answer("d", None, "−4.5×10⁻⁵", "m"))
    assert printed(small) == "  d = −4.5×10⁻⁵ m\n"
    assert r"$d = -4.5 \times 10^{-5}\,\mathrm{m}$" in body(small, "markdown")
    assert json.loads(body(small, "json"))["answers"][0]["value"] == "-4.5e-5"


def test_digits_that_can_not_be_certified_are_not_printed(block_on_disc: Derivation, made: Any) -> None:
    answer = replace(made.answer("x", None, None, "m"), value=made.Fuzzy(2))
    assert printed(answers(block_on_disc, answer)) == "  x = 1.2 m (only 2 digits can be certified)\n"
    answer = replace(answer, value=made.Fuzzy(0))
    assert (
        printed(answers(block_on_disc, answer))
        == "  x: (≈ 1.23, not certified: its bounds are too wide at the highest precision)\n"
    )


def test_checks_that_fail_are_said_apart(block_on_disc: Derivation) -> None:
    checks = (Check(("dimensions agree",)), Check((parse("T"), " < 0"), False), Check(("energy",), None))
    text = body(replace(block_on_disc, checks=checks), "text")
    assert text.endswith("Checks\n  dimensions agree\n  does not hold: T < 0\n  not decided: energy\n")


def test_givens_that_were_not_given_are_not_printed(block_on_disc: Derivation, made: Any) -> None:
    asked = replace(made.given("m", "2", "kg"), value=None, asked=True)
    made_up = replace(made.given("c", "2", "kg"), value=None, automatic=True)
    letter = replace(made.given("k", "2", "kg"), value=None)
    other = replace(made.given("L", "2", "m"), value=parse("2 R"), text="2*R", unit=None)
    text = body(replace(block_on_disc, givens=(asked, made_up, letter, other)), "text")
    assert "\nGiven   k, L = 2 R\n" in text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        ("0.20", "m", "q = 0.20 m"),
        ("1e-3", "kg", "q = 1×10⁻³ kg"),
        ("30", "deg", "q = 30°"),
        ("2 π", "rad", "q = 2 π rad"),
        ("3/4", "m", "q = ¾ m"),
        ("-5", "m/s", "q = −5 m/s"),
        ("120", "rev/min", "q = 120 rev/min"),
        ("0.3", "", "q = 0.3"),
    ],
)
def test_a_given_is_printed_as_it_was_written(made: Any, value: str, unit: str, text: str) -> None:
    assert plain_text((given_equation(made.given("q", value, unit)),)) == text


def test_prose_is_escaped(block_on_disc: Derivation) -> None:
    derivation = replace(block_on_disc, title="50% of m_1 & $2 * #3 <b>")
    assert body(derivation, "markdown").startswith("# 50% of m\\_1 & \\$2 \\* \\#3 \\<b\\>\n")
    latex = body(derivation, "latex")
    assert latex.startswith("\\section*{50\\% of m\\_1 \\& \\$2 * \\#3 \\textless{}b\\textgreater{}}\n")


def test_formats_are_found_by_name_and_by_file() -> None:
    assert [format_named(name) for name in FORMATS] == list(FORMATS.values())
    with pytest.raises(KeyError, match=f"unknown format 'docx': {', '.join(FORMATS)}"):
        format_named("docx")
    assert format_of_file("out/Answers.TEX") == format_named("latex")
    assert format_of_file("answers") is None


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no LaTeX here")
def test_latex_compiles(crowded: Derivation, rod_released: Derivation, tmp_path: Path) -> None:
    """Also with every letter that prose may hold."""
    letters = "".join((*LATEX_SPECIAL, *MATHEMATICS, "éžł中\x07"))
    bodies = [body(item, "latex") for item in (replace(crowded, source=letters), rod_released)]
    (tmp_path / "page.tex").write_text(format_named("latex").document(bodies), encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "page.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 0, done.stdout.decode(errors="replace")[-2000:]


@pytest.mark.parametrize("format", FORMATS.values(), ids=FORMATS)
def test_a_format_is_one_short_file(format: Format) -> None:
    file = find_spec(format.module)
    assert file is not None and file.origin is not None
    assert len(Path(file.origin).read_text(encoding="utf-8").splitlines()) <= 100


@pytest.mark.parametrize("page", ["README.md", "docs/checking.md", "docs/keys.md"])
def test_the_docs_tell_every_format(page: str) -> None:
    text = (Path(__file__).resolve().parents[2] / page).read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if re.match(r"\| `(-f|… --format) text`", line)]
    assert rows and set(FORMATS) <= set(re.findall(r"\w+", rows[0]))


def test_what_a_format_does_not_print_is_said_in_plain_blocks(rod_released: Derivation) -> None:
    plain = {Title, Paragraph, Bullets, Table}
    found = [*simplified(DerivationPage(rod_released).blocks(), plain)]
    assert {type(block) for block in found} == {Title, Paragraph, Bullets}
    with pytest.raises(NotImplementedError, match="every format has to print it"):
        Title(1, ("Rod",)).simpler()
