"""STACK: questions of the plugin STACK for Moodle: formulas, compared by algebra, and numbers of variants that Maxima works out.

A tree of one branch compares the answer with the right one, then with that of each mistake, and says what is known of the first that fits.
With variants, question variables hold the values of all of them; the seed chooses one, and Maxima puts its values into the formulas.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from xml.etree.ElementTree import Element, SubElement

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.grading.comparing.numbers import certified_number
from rotsolve.page.blocks import Math
from rotsolve.platforms.known import KnownFormula, PlatformPart
from rotsolve.platforms.maxima import letters_in_maxima, to_maxima
from rotsolve.platforms.moodle import QuestionFrame, html_in, text_in
from rotsolve.platforms.xml_text import plain_decimal, writable

VERSION = "2020112300"  # of the plugin; later ones read the files of earlier ones
INPUT, TREE = "ans1", "prt1"
CHOSEN = "rotk"  # the variable that holds the number of the variant
SHOWN = f"[[input:{INPUT}]] [[validation:{INPUT}]]"
OPTIONS = (
    ("decimals", "."), ("multiplicationsign", "dot"), ("sqrtsign", "1"), ("complexno", "i"), ("inversetrig", "cos-1"),
    ("logicsymbol", "lang"), ("matrixparens", "["), ("variantsselectionseed", ""),
)  # fmt: skip


class TreeNode(Struct, frozen=True):
    """What an answer is compared with, by which test, the share of the points, and what is said as HTML."""

    test: str
    wanted: str
    option: str
    share: Fraction
    said: str


def formula_question(frame: QuestionFrame, name: str, asked: str, part: PlatformPart, givens: Sequence[str]) -> Element:
    """A question for a formula in the letters of the givens. Raises NoMaxima."""
    letters = letters_in_maxima({*givens, *(one for known in part.formulas for one in known.formula.symbols())})
    right = to_maxima(part.formulas[0].formula, letters)
    branches = [
        TreeNode("AlgEquiv", to_maxima(known.formula, letters), "", known.share, frame.printer.sentence(*known.said))
        for known in part.formulas
    ]
    typed = typing_hint(frame, part, letters)
    question = stack_frame(frame, name, f"{asked}\n{typed}\n<p>{SHOWN}</p>", f"ta:{right};", "", part.part.points)
    add_input(question, "algebraic", "ta", ",".join(sorted(letters.values())))
    add_tree(
        question,
        [TreeNode("AlgEquiv", "ta", "", *one) for one in ((branches[0].share, branches[0].said),)] + branches[1:],
    )
    add_test(question, right)
    return question


def typing_hint(frame: QuestionFrame, part: PlatformPart, letters: dict[str, str]) -> str:
    """Which letters the formula may hold, and how those are typed that are not typed as they look."""
    phrase: list[str | Formula] = ["Write a formula in "]
    for place, (letter, typed) in enumerate(sorted(letters.items())):
        hint = f" (type {typed})" if typed != letter or len(letter) > 1 else ""
        phrase += [", " if place else "", Symbol(letter), hint]
    return frame.printer.sentence((*phrase, "."))


class VariantOfProblem(Struct, frozen=True):
    """One variant: what is told of it, its part, and the values of the letters of its formulas, in SI units."""

    told: str
    part: PlatformPart
    values: Mapping[str, Formula]


def number_question(
    frame: QuestionFrame, name: str, asked: str, variants: Sequence[VariantOfProblem]
) -> Element | None:
    """A question for the number of an answer, in all variants; None where their formulas or letters differ. Raises NoMaxima."""
    part = variants[0].part
    names = [*variants[0].values]
    if any(one.part.formulas[:1] != part.formulas[:1] or [*one.values] != names for one in variants):
        return None
    letters = letters_in_maxima(names)
    if not part.formulas[0].formula.symbols() <= letters.keys():
        return None
    box, known = part.boxes[0], shared_formulas(variants)
    told = "".join(f"[[if test='{CHOSEN}={place}']]{one.told}[[/if]]" for place, one in enumerate(variants, 1))
    unit = f" {frame.printer.math(frame.printer.unit(box.unit))}" if box.unit.text else ""
    line = f"{frame.printer.words((Math((box.symbol, '=')),))} [[input:{INPUT}]]{unit} [[validation:{INPUT}]]"
    variables = "\n".join(variables_of(variants, letters, known))
    bare = QuestionFrame(frame.printer, told, frame.solution)
    question = stack_frame(
        bare, name, f"{asked}\n<p>{line}</p>", variables, f"variant {{#{CHOSEN}#}}", part.part.points
    )
    add_input(question, "numerical", "ta", "")
    add_tree(question, [number_branch(frame, part, place, one) for place, one in enumerate(known)])
    for seed in range(1, len(variants) + 1):
        SubElement(question, "deployedseed").text = str(seed)
    add_test(question, "ta")
    return question


def variables_of(
    variants: Sequence[VariantOfProblem], letters: Mapping[str, str], known: Sequence[KnownFormula]
) -> Iterator[str]:
    """The variables of a question: which variant it is, the values of its letters, and the numbers of all known answers in the unit."""
    factor = to_maxima(variants[0].part.boxes[0].unit.factor, {})
    yield f"{CHOSEN}:rand({len(variants)})+1;"
    for letter, typed in letters.items():
        yield f"rot_{typed}:[{','.join(to_maxima(one.values[letter], {}) for one in variants)}][{CHOSEN}];"
    put_in = ",".join(f"{typed}=rot_{typed}" for typed in letters.values())
    for place, one in enumerate(known):
        yield f"{number_name(place)}:float(subst([{put_in}],{to_maxima(one.formula, letters)})/({factor}));"


def number_name(place: int) -> str:
    """The variable of a known answer, `ta` for the right one."""
    return f"tw{place}" if place else "ta"


def number_branch(frame: QuestionFrame, part: PlatformPart, place: int, known: KnownFormula) -> TreeNode:
    """What a number is compared with, the right one first."""
    from rotsolve.grading.marking.explaining import ALIKE

    test, option = (right_test(part), right_option(part)) if not place else ("NumRelative", f"{float(ALIKE):g}")
    return TreeNode(test, number_name(place), option, known.share, frame.printer.sentence(*known.said))


def shared_formulas(variants: Sequence[VariantOfProblem]) -> tuple[KnownFormula, ...]:
    """The formulas that all variants have: the right one, and those of mistakes, which must have a number in all of them."""

    def has(one: VariantOfProblem, formula: Formula) -> bool:
        shared = formula in [known.formula for known in one.part.formulas]
        return shared and certified_number(formula, one.values) is not None

    right, *mistakes = variants[0].part.formulas
    return (right, *(known for known in mistakes if all(has(one, known.formula) for one in variants)))


def right_test(part: PlatformPart) -> str:
    return "NumRelative" if part.marking.tolerance.share is not None else "NumAbsolute"


def right_option(part: PlatformPart) -> str:
    """How far off an answer may be, as the test takes it: a share, or an amount in its unit."""
    share = part.marking.tolerance.share
    return f"{float(share):.6g}" if share is not None else part.numbers[0].margins[0]


def stack_frame(frame: QuestionFrame, name: str, text: str, variables: str, note: str, points: Fraction) -> Element:
    """A question with all but its input, tree and tests."""
    question = frame.question("stack", name, text, points)
    text_in(SubElement(question, "stackversion"), VERSION)
    text_in(SubElement(question, "questionvariables"), variables)
    html_in(question, "specificfeedback", f"<p>[[feedback:{TREE}]]</p>")
    text_in(SubElement(question, "questionnote"), note)
    for tag, value in (("questionsimplify", "1"), ("assumepositive", "1"), ("assumereal", "1")):
        SubElement(question, tag).text = value
    for tag in ("prtcorrect", "prtpartiallycorrect", "prtincorrect"):
        html_in(
            question,
            tag,
            frame.printer.sentence(({"prtcorrect": "Right.", "prtincorrect": "Wrong."}.get(tag, "Partly right."),)),
        )
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


def add_tree(question: Element, branches: Sequence[TreeNode]) -> None:
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
    fields = (
        ("scoremode", "="),
        ("score", plain_decimal(share)),
        ("penalty", ""),
        ("nextnode", following),
        ("answernote", note),
    )
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
    fields = (
        ("name", TREE),
        ("expectedscore", "1.0000000"),
        ("expectedpenalty", "0.0000000"),
        ("expectedanswernote", f"{TREE}-1-T"),
    )
    for tag, value in fields:
        SubElement(expected, tag).text = value
