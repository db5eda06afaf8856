"""Texts with a small Markdown: what it is in every format, that nothing of it is markup there, and faults at their places."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from struct import pack
from xml.etree.ElementTree import fromstring
from zlib import compress, crc32

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve.core.faults import SceneError
from rotsolve.page.blocks import FixedPage, PageBlock
from rotsolve.page.formats import FORMATS
from rotsolve.scene.read import read_file, read_text
from rotsolve.scene.statement import Slot, Tex, statement_blocks, wording_phrase
from rotsolve.scene.tex import tex_phrase

Key = Callable[..., tuple[int, str]]
SCENE = """\
title: T
given: {m: 2 kg}
bodies: {block: {mass: m, moves: down}}
find: {a: block.acceleration}
text: |
"""
TEXTS = ("text", "markdown", "latex", "typst", "html")


def chunk(kind: bytes, data: bytes) -> bytes:
    return pack(">I", len(data)) + kind + data + pack(">I", crc32(kind + data))


PNG = (
    b"\x89PNG\r\n\x1a\n"
    + chunk(b"IHDR", pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0))
    + chunk(b"IDAT", compress(b"\0\0"))
    + chunk(b"IEND", b"")
)
SVG = b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="5" height="5"/></svg>'


def plainly(piece: str | Slot | Tex) -> tuple[object, ...]:
    return (piece,) if isinstance(piece, str) else tex_phrase(piece.tex) if isinstance(piece, Tex) else ("SLOT",)


def printed(text: str, format: str) -> str:
    blocks: tuple[PageBlock, ...] = tuple(statement_blocks(text, plainly))  # type: ignore[arg-type]
    return FORMATS[format].body(FixedPage(blocks))


MARKED = [  # text, HTML, plain text
    ("**bold** word", "<p><b>bold</b> word</p>", "bold word"),
    ("*light* and ***both***", "<p><i>light</i> and <b><i>both</i></b></p>", "light and both"),
    ("a_x and b_y stay", "<p>a_x and b_y stay</p>", "a_x and b_y stay"),
    ("2 * 3 * 4", "<p>2 * 3 * 4</p>", "2 * 3 * 4"),
    (r"\*no\* \$5", "<p>*no* $5</p>", "*no* $5"),
    ("It costs 5 $, or $6.", "<p>It costs 5 $, or $6.</p>", "It costs 5 $, or $6."),
    (
        "- one\n- **two**\n  1. a\n  2. b",
        '<ul>\n<li>one</li>\n<li><b>two</b>\n<ol start="1">',
        "- one\n- two\n  1. a\n  2. b",
    ),
    ("Take\n- one\n- two\nso", "<p>Take</p>\n<ul>\n<li>one</li>", "Take\n- one\n- two\nso"),
    ("3. third\n4. fourth", '<ol start="3">\n<li>third</li>', "3. third\n4. fourth"),
    ("one\ntwo", "<p>one</p>\n<p>two</p>", "one\ntwo"),
    ("one\ntwo\n\nthree", "<p>one two</p>\n<p>three</p>", "one two\nthree"),
    (
        "**with $m$ and {m} in**",
        "<p><b>with</b> <math><mi>m</mi></math> <b>and</b> <b>SLOT</b> <b>in</b></p>",
        "with m and SLOT in",
    ),
    ("<b>no</b> & [l](u) `c` # h", "<p>&lt;b&gt;no&lt;/b&gt; &amp; [l](u) `c` # h</p>", "<b>no</b> & [l](u) `c` # h"),
    ("# no title", "<p># no title</p>", "# no title"),
    ("> no quote", "<p>&gt; no quote</p>", "> no quote"),
    ("$v_{0}$ of {{x}}", "<p><math><msub><mi>v</mi><mn>0</mn></msub></math> of {x}</p>", "v₀ of {x}"),
]


@pytest.mark.parametrize(("text", "html", "plain"), MARKED, ids=[case[0][:20] for case in MARKED])
def test_markdown(text: str, html: str, plain: str) -> None:
    assert html in printed(text, "html")
    assert printed(text, "text").rstrip("\n") == plain


HOSTILE = (
    r"""<script>alert(1)</script> " onload="x" &amp; &#60; `#` #eval("1") #import "a" \input{a} \write18{ls} \end{document} $(x)
%% \\ ^^41 ~ _ { } [ ] @ref <end-of-sheet> // /* */ = - + 1. ]] }} \] \} ''' ``` --- #set page(width: 1pt) ![a] **""".replace(
        "{", "{{"
    )
    .replace("}", "}}")
    .replace("$", r"\$")
)


def test_nothing_of_a_text_is_markup(key: Key, page: Path) -> None:
    typst = pytest.importorskip("typst")
    text = HOSTILE.replace("![a]", "! [a]")
    words = "\n".join(f"    {line}" for line in text.splitlines())
    scene = (page / "plain.yaml").read_text("utf-8").replace("Pendulum without a text", "'<i> #x \\y $z$ **'")
    (page / "plain.yaml").write_text(f"{scene}text: |\n{words}\nask:\n  v: |\n{words}\n", encoding="utf-8")
    title = "<script> #eval \\end{document} $x$"
    formats = [f"-f{name}" for name in (*TEXTS, "pdf", "json", "csv")]
    assert key("plain.yaml", "-o", "out", "--solutions", "--title", title, *formats) == (0, "")
    out = page / "out"
    html = (out / "sheet.html").read_text("utf-8")
    assert "<script" not in html.replace("<title>", "") and 'onload="' not in html
    fromstring(re.sub(r"<meta[^>]*>|<!DOCTYPE html>", "", html).replace('alt=""', ""))  # well formed
    latex = (out / "sheet.tex").read_text("utf-8")
    assert not re.search(r"\\(input|write|eval|import)\b", latex) and latex.count(r"\end{document}") == 1
    for name in ("sheet", "key", "solutions"):
        typst.compile(str(out / f"{name}.typ"), format="pdf")
    pypdf = pytest.importorskip("pypdf")
    said = "".join(sheet.extract_text() for sheet in pypdf.PdfReader(out / "sheet.pdf").pages)
    for piece in ("<script>alert(1)</script>", "#eval(", "#import", r"\input{a}", "#set page(width: 1pt)", "@ref"):
        assert piece.replace(" ", "") in re.sub(r"\s", "", said)


@settings(max_examples=200, deadline=None)
@given(st.text(st.sampled_from("ab $*_\\{}[]()<>#&%~^`-+1.\n!\"'/=@"), max_size=40))
def test_any_text_is_printed_or_refused(text: str) -> None:
    try:
        pages = {name: printed(text, name) for name in TEXTS}
    except (ValueError, KeyError):  # FormulaError, NoMarkdown
        return
    fromstring(pages["html"].replace("&nbsp;", " "))
    assert wording_phrase("x", plainly) == ("x",)  # type: ignore[arg-type]


@pytest.fixture
def images(tmp_path: Path) -> Path:
    (tmp_path / "dot.png").write_bytes(PNG)
    (tmp_path / "dot.svg").write_bytes(SVG)
    (tmp_path / "no.png").write_text("no image")
    (tmp_path / "a.gif").write_bytes(b"GIF89a")
    return tmp_path


FAULTS = [
    ("the mass {q}", "error: `{q}` in `text` names no given\n  --> t.yaml:6:12"),
    (
        "the speed $v = \\vec u$",
        "error: the formula `$v = \\vec u$`: `\\vec` is not understood in a text\n  --> t.yaml:6:18",
    ),
    ("the speed $v and", "error: a formula begins in `text` and does not end\n  --> t.yaml:6:13"),
    ("![a dot](none.png)", "error: there is no image `none.png` in `.`\n  --> t.yaml:6:12"),
    ("![](dot.png)", "error: the image `dot.png` has no words for those who do not see it"),
    ("![a dot](http://x.org/a.png)", "is no file: nothing is fetched from a network"),
    ("![a dot](a.gif)", "error: the image `a.gif` is of no kind that every format can print: .png, .jpg, .jpeg, .svg"),
    ("![a dot](no.png)", "error: `no.png` holds no image, or one of more than 5 MB"),
    ("![a dot](two words.png)", "error: this is no image in `text`\n  --> t.yaml:6:3"),
    ("- ![a dot](dot.png)", "error: an image stands between paragraphs, not in a list or a line in `text`"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS, ids=[fault[0] for fault in FAULTS])
def test_faults_of_texts(images: Path, monkeypatch: pytest.MonkeyPatch, text: str, message: str) -> None:
    monkeypatch.chdir(images)
    Path("t.yaml").write_text(f"{SCENE}  {text}\n", encoding="utf-8")
    with pytest.raises(SceneError) as caught:
        read_file("t.yaml")
    assert message in str(caught.value)


def test_a_wording_is_one_line_without_images() -> None:
    with pytest.raises(SceneError) as caught:
        read_text(f"{SCENE}  x\nask:\n  a: 'this ![dot](dot.png) here'\n")
    assert "error: an image stands between paragraphs, not in a list or a line in the wording of `a`" in str(
        caught.value
    )


def test_images_are_within_or_beside_the_pages(key: Key, page: Path, images: Path) -> None:
    scene = f'{SCENE}  Look:\n\n  ![a "dot"](dot.png)\n\n  ![a box](dot.svg)\n'
    (page / "dots.yaml").write_text(scene, encoding="utf-8")
    formats = [f"-f{name}" for name in (*TEXTS, "pdf", "json")]
    assert key("dots.yaml", "-o", "out", "--solutions", *formats) == (0, "")
    out = page / "out"
    names = sorted(
        path.name for path in out.iterdir() if path.suffix in (".png", ".svg") or path.name.startswith("dot")
    )
    assert sorted(re.sub("-[0-9a-f]{8}", "", name) for name in names) == ["dot.pdf", "dot.png", "dot.svg"]
    for sheet in ("sheet", "solutions"):
        html = (out / f"{sheet}.html").read_text("utf-8")
        assert 'src="data:image/png;base64,iVBOR' in html and 'alt="a &quot;dot&quot;"' in html
        assert 'src="data:image/svg+xml;base64,' in html and "http" not in re.sub(
            r"http://www\.w3\.org/[\w/]+", "", html
        )
        assert re.search(r"!\[a \"dot\"\]\(dot-[0-9a-f]{8}\.png\)", (out / f"{sheet}.md").read_text("utf-8"))
        latex = (out / f"{sheet}.tex").read_text("utf-8")
        assert re.search(r"\\includegraphics\[.*alt=\{a box\}\]\{dot-[0-9a-f]{8}\.pdf\}", latex)
        assert '[a "dot"]' in (out / f"{sheet}.txt").read_text("utf-8")
        assert re.search(r'image\("dot-[0-9a-f]{8}\.svg", alt: "a box"\)', (out / f"{sheet}.typ").read_text("utf-8"))
