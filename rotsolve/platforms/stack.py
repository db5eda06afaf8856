"""STACK: questions of the plugin STACK for Moodle: formulas, compared by algebra, and numbers of variants that Maxima works out.

A tree of one branch compares the answer with the right one, then with that of each mistake, and says what is known of the first that fits.
With variants, question variables hold the values of all of them; the seed chooses one, and Maxima puts its values into the formulas.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from xml.etree.ElementTree import Element, SubElement

from msgspec import Struct

from rotsolve.language import marks
from rotsolve.page.blocks import Math, Phrase
from rotsolve.platforms.fragments import writable
from rotsolve.platforms.known import KnownFormula, PlatformPart
from rotsolve.platforms.maxima import letters_in_maxima, to_maxima
from rotsolve.platforms.moodle import Frame, decimal_text, html_in, text_in

VERSION = "2020112300"  # of the plugin; later ones read the files of earlier ones
INPUT, TREE = "ans1", "prt1"
CHOSEN = "rotk"  # the variable that holds the number of the variant
SHOWN = f"[[input:{INPUT}]] [[validation:{INPUT}]]"
OPTIONS = (
    ("decimals", "."), ("multiplicationsign", "dot"), ("sqrtsign", "1"), ("complexno", "i"), ("inversetrig", "cos-1"),
    ("logicsymbol", "lang"), ("matrixparens", "["), ("variantsselectionseed", ""),
)  # fmt: skip


class Branch(Struct, frozen=True):
    """What an answer is compared with, by which test, the share of the points, and what is said as HTML."""

    test: str
    wanted: str
    option: str
    share: Fraction
    said: str


def formula_question(frame: Frame, name: str, asked: str, part: PlatformPart, givens: Sequence[str]) -> Element:
    """A question for a formula in the letters of the givens. Raises NoMaxima."""
    letters = letters_in_maxima({*givens, *(one for known in part.formulas for one in known.formula.symbols())})
    right = to_maxima(part.formulas[0].formula, letters)
    branches = [
        Branch("AlgEquiv", to_maxima(known.formula, letters), "", known.share, frame.printer.sentence(*known.said))
        for known in part.formulas
    ]
    typed = typing_hint(frame, part, letters)
    question = stack_frame(frame, name, f"{asked}\n{typed}\n<p>{SHOWN}</p>", f"ta:{right};", "", part.part.points)
    add_input(question, "algebraic", "ta", ",".join(sorted(letters.values())))
    add_tree(question, [Branch("AlgEquiv", "ta", "", *one) for one in ((branches[0].share, branches[0].said),)] + branches[1:])
    add_test(question, right)
    return question


def typing_hint(frame: Frame, part: PlatformPart, letters: dict[str, str]) -> str:
    """Which letters the formula may hold, and how those are typed that are not typed as they look."""
    from rotsolve.algebra.formula import Symbol

    phrase: list[object] = ["Write a formula in "]
    for place, (letter, typed) in enumerate(sorted(letters.items())):
        phrase += [", " if place else "", Symbol(letter), *((f" (type {typed})",) if typed != letter or len(letter) > 1 else ())]
    return frame.printer.sentence((*phrase, "."))  # type: ignore[arg-type]


class VariantOfProblem(Struct, frozen=True):
    """One variant: what is told of it, its parts, and the SI values of the letters of its formulas, as Maxima reads them."""

    told: str
    part: PlatformPart
    values: dict[str, str]


def number_question(
    frame: Frame, name: str, asked: str, variants: Sequence[VariantOfProblem]
) -> Element | None:
    """A question for the number of an answer, in all variants; None where their formulas or letters differ. Raises NoMaxima."""
    part = variants[0].part
    names = [*variants[0].values]
    if any(one.part.formulas[:1] != part.formulas[:1] or [*one.values] != names for one in variants):
        return None
    letters = letters_in_maxima(names)
    if not part.formulas[0].formula.symbols() <= letters.keys():
        return None
    box = part.boxes[0]
    factor = to_maxima(box.unit.factor, {})
    variables = [f"{CHOSEN}:rand({len(variants)})+1;"]
    for letter in names:
        listed = ",".join(one.values[letter] for one in variants)
        variables.append(f"rot_{letters[letter]}:[{listed}][{CHOSEN}];")
    put_in = ",".join(f"{typed}=rot_{typed}" for typed in letters.values())
    for place, known in enumerate(shared_formulas(variants)):
        variables.append(f"t{place or 'a'}:float(subst([{put_in}],{to_maxima(known.formula, letters)})/({factor}));")
    branches = [
        Branch("NumRelative" if place else right_test(part), f"t{place or 'a'}", right_option(part) if not place else "0.002",
               known.share, frame.printer.sentence(*known.said))
        for place, known in enumerate(shared_formulas(variants))
    ]  # fmt: skip
    told = "".join(f"[[if test='{CHOSEN}={place}']]{one.told}[[/if]]" for place, one in enumerate(variants, 1))
    unit = f" {frame.printer.math(frame.printer.unit(box.unit))}" if box.unit.text else ""
    text = f"{told}\n{asked}\n<p>{frame.printer.words((Math((box.symbol, '=')),))} [[input:{INPUT}]]{unit} [[validation:{INPUT}]]</p>"
    note = f"variant {{#{CHOSEN}#}}"
    question = stack_frame(frame, name, text, "\n".join(variables), note, part.part.points)
    add_input(question, "numerical", "ta", "")
    add_tree(question, branches)
    for seed in range(1, len(variants) + 1):
        SubElement(question, "deployedseed").text = str(seed)
    add_test(question, "ta")
    return question


def shared_formulas(variants: Sequence[VariantOfProblem]) -> tuple[KnownFormula, ...]:
    """The formulas that all variants have: the right one, and those of mistakes."""
    first, *others = variants
    return tuple(
        known
        for place, known in enumerate(first.part.formulas)
        if not place or all(known.formula in [one.formula for one in other.part.formulas] for other in others)
    )


def right_test(part: PlatformPart) -> str:
    return "NumRelative" if part.marking.tolerance.share is not None else "NumAbsolute"


def right_option(part: PlatformPart) -> str:
    """How far off an answer may be, as the test takes it: a share, or an amount in its unit."""
    share = part.marking.tolerance.share
    return f"{float(share):.6g}" if share is not None else part.numbers[0].margins[0]


def stack_frame(frame: Frame, name: str, text: str, variables: str, note: str, points: Fraction) -> Element:
    """A question with all but its input, tree and tests."""
    question = frame.question("stack", name, text, points)
    text_in(SubElement(question, "stackversion"), VERSION)
    text_in(SubElement(question, "questionvariables"), variables)
    html_in(question, "specificfeedback", f"<p>[[feedback:{TREE}]]</p>")
    text_in(SubElement(question, "questionnote"), note)
    for tag, value in (("questionsimplify", "1"), ("assumepositive", "1"), ("assumereal", "1")):
        SubElement(question, tag).text = value
    for tag in ("prtcorrect", "prtpartiallycorrect", "prtincorrect"):
        html_in(question, tag, frame.printer.sentence(({"prtcorrect": "Right.", "prtincorrect": "Wrong."}.get(tag, "Partly right."),)))
    for tag, value in OPTIONS:
        SubElement(question, tag).text = value
    return question


def add_input(question: Element, kind: str, answer: str, letters: str) -> None:
    """The field for the answer."""
    field = SubElement(question, "input")
    fields = (
        ("name", INPUT), ("type", kind), ("tans", answer), ("boxsize", "20"), ("strictsyntax", "1"), ("insertstars", "1"),
        ("syntaxhint", ""), ("syntaxattribute", "0"), ("forbidwords", ""), ("allowwords", letters), ("forbidfloat", "0"),
        ("requirelowestterms", "0"), ("checkanswertype", "0"), ("mustverify", "1"), ("showvalidation", "1"), ("options", ""),
    )  # fmt: skip
    for tag, value in fields:
        SubElement(field, tag).text = value


def add_tree(question: Element, branches: Sequence[Branch]) -> None:
    """The tree of comparisons, one after the other."""
    tree = SubElement(question, "prt")
    for tag, value in (("name", TREE), ("value", "1.0000000"), ("autosimplify", "1"), ("feedbackstyle", "1")):
        SubElement(tree, tag).text = value
    text_in(SubElement(tree, "feedbackvariables"), "")
    for place, branch in enumerate(branches):
        node = SubElement(tree, "node")
        last = place == len(branches) - 1
        fields = (
            ("name", str(place)), ("answertest", branch.test), ("sans", INPUT), ("tans", branch.wanted),
            ("testoptions", branch.option), ("quiet", "1"),
        )  # fmt: skip
        for tag, value in fields:
            SubElement(node, tag).text = value
        add_side(node, "true", branch.share if place else Fraction(1), "-1", f"{TREE}-{place + 1}-T", branch.said)
        add_side(node, "false", Fraction(0), "-1" if last else str(place + 1), f"{TREE}-{place + 1}-F", "")


def add_side(node: Element, side: str, share: Fraction, following: str, note: str, said: str) -> None:
    """What follows from a comparison that holds, or does not."""
    fields = (("scoremode", "="), ("score", decimal_text(share)), ("penalty", ""), ("nextnode", following), ("answernote", note))
    for tag, value in fields:
        SubElement(node, side + tag).text = value
    html_in(node, f"{side}feedback", said)


def add_test(question: Element, answer: str) -> None:
    """A test that STACK runs itself: the right answer has all marks."""
    test = SubElement(question, "qtest")
    SubElement(test, "testcase").text = "1"
    field = SubElement(test, "testinput")
    for tag, value in (("name", INPUT), ("value", writable(answer))):
        SubElement(field, tag).text = value
    expected = SubElement(test, "expected")
    fields = (("name", TREE), ("expectedscore", "1.0000000"), ("expectedpenalty", "0.0000000"), ("expectedanswernote", f"{TREE}-1-T"))
    for tag, value in fields:
        SubElement(expected, tag).text = value
