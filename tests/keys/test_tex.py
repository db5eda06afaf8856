"""Formulas in texts: what is understood of TeX, as every format prints it, and what is refused at its place."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.page.formats import FORMATS, format_named
from rotsolve.page.text import plain_text
from rotsolve.scene.tex import KNOWN, tex_phrase

UNDERSTOOD = [
    (r"v_0 = 3\,\mathrm{m/s}", "v₀ = 3 m/s"),
    (r"\theta = 30^\circ", "θ = 30°"),
    (r"\theta = 30^{\circ}, \phi = 0{,}5", "θ = 30°, φ = 0.5"),
    (r"\mu_\mathrm{s} \le 0.30", "μₛ ≤ 0.30"),
    (r"\tfrac12 m v^2", "½ m v²"),
    (r"\frac{1}{2} M R^2 \omega_0^2 = mgh", "½ M R² ω₀² = m g h"),
    (r"\frac{2}{4} m", "2/4 m"),
    (r"x(t) = A\cos(\omega t)", "x(t) = A cos(ω t)"),
    (r"F(t) = F_0 e^{-t/\tau}", "F(t) = F₀ e^(−t/τ)"),
    (r"\sin^2\theta + \cos^2\theta = 1", "sin² θ + cos² θ = 1"),
    (r"\sin 30^\circ", "sin 30°"),
    (r"a = \frac{m_1 - m_2}{m_1 + m_2} g", "a = ((m₁ − m₂)/(m₁ + m₂)) g"),
    (r"1.2\times10^{-3}\,\mathrm{kg\,m^2}", "1.2×10⁻³ kg m²"),
    (r"v \text{ for } t > 0", "v for t > 0"),
    (r"\left(a+b\right)c", "(a + b) c"),
    (r"|x| < L", "|x| < L"),
    (r"\sqrt{2gh}", "√(2 g h)"),
    (r"\sqrt[3]{x}", "x^(1/3)"),
    (r"\Delta\theta = 2\pi", "Δθ = 2 π"),
    (r"x' = v_{\text{end}}", "x′ = v_end"),
    (r"20\,\mathrm{N} \pm 1\,\mathrm{N}", "20 N ± 1 N"),
    (r"-3\,\text{m}", "−3 m"),
    (r"5\,\%", "5%"),
    (r"a/b c", "(a/b) c"),
    (r"x = 3 m", "x = 3 m"),
    ("m ≤ 2", "m ≤ 2"),
]
REFUSED = [
    (r"\vec F", "`\\vec` is not understood in a text", 0, 4),
    (r"\sin\omega t", "write brackets round what the function is taken of", 11, 12),
    (r"\sin 2\theta", "write brackets round what the function is taken of", 6, 12),
    (r"\frac{a}{b", "this `{` is never closed", 8, 9),
    (r"x^12", "write braces round a number of several digits", 2, 4),
    (r"v_12", "write braces round an index of several digits", 2, 4),
    (r"\input{x}", "`\\input` is not understood in a text", 0, 6),
    (r"\write18{ls}", "`\\write` is not understood in a text", 0, 6),
    (r"a \\ c", "`\\\\` is not understood in a text", 2, 4),
    ("a))", "`)` can't stand here", 1, 2),
    (r"5 \mathrm{kgg}", "`kgg` is no unit", 10, 13),
    ('#eval("x")', "`#` can't stand here", 0, 1),
    ("a_{b_c}", "can't stand below a letter", 2, 7),
    (r"\delta_x", "is no letter that can be printed", 0, 8),
    ("x +", "the formula ends too early", 3, 4),
    (r"(x, y)", "`,` can't stand here", 2, 3),
    (r"x^{30^\circ}", "an angle in degrees stands alone, or behind sin, cos, tan", 6, 11),
    (r"\text{\input{x}}", "within upright letters stand letters alone", 5, 14),
    ("(" * 40 + "x" + ")" * 40, "nested too deep", 30, 31),
]


@pytest.mark.parametrize(("tex", "said"), UNDERSTOOD)
def test_what_is_understood(tex: str, said: str) -> None:
    assert plain_text(tex_phrase(tex)) == said


@pytest.mark.parametrize(("tex", "message", "start", "end"), REFUSED)
def test_what_is_refused_at_its_place(tex: str, message: str, start: int, end: int) -> None:
    with pytest.raises(FormulaError) as caught:
        tex_phrase(tex)
    assert message in caught.value.message
    assert (caught.value.start, caught.value.end) == (start, end)


@pytest.mark.parametrize(("tex", "said"), UNDERSTOOD)
def test_latex_that_is_printed_is_read_as_the_same(tex: str, said: str) -> None:
    """What Markdown and LaTeX print is TeX again."""
    printed = format_named("latex").printer.words(tex_phrase(tex))
    again = (
        printed.strip("$")
        .replace("$, $", ", ")
        .replace(r"\mathrm{^{\circ}}", r"^{\circ}")
        .replace(r"\mathrm{\%}", r"\%")
    )
    if "$" not in again:  # no words between
        assert plain_text(tex_phrase(again)) == said


@settings(max_examples=300, deadline=None)
@given(
    st.lists(st.sampled_from([*KNOWN, *"abxyF0123(){}[]^_/+-=,|' ", "{end}", "$", "\\", "#", "%", "\n"]), max_size=12)
)
def test_any_text_is_understood_or_refused(pieces: list[str]) -> None:
    text = "".join(pieces)
    try:
        phrase = tex_phrase(text)
    except FormulaError as error:
        assert 0 <= error.start <= len(text)
        return
    for name in ("text", "markdown", "latex", "typst", "html"):
        assert isinstance(FORMATS[name].printer.words(phrase), str)
