"""Prose: words round the values of a line, and statements that lead to the one that answers: `m g − T = m a, so the tension is T = 11 N`.

Blanks take the place of what says nothing of the value, so that every other character keeps its column. Only words that are known are
passed over: those that lead on, and those that name what is asked. A line with any other word in it stays as it is.
"""

from __future__ import annotations

import re

from rotsolve.grading.reading.records import Names

_LEADING = """
    so hence thus therefore then and since consequently finally now also accordingly this that it which we i one can must will would now
    get gets find finds found obtain obtains have has gives give giving yields yield means implies conclude see say says write leads to
    let put result results answer ans solution value magnitude size amount final required resulting desired its the a an of for in on at
    our my be comes out as follows equal equals given by where from here
    also daher somit folglich damit deshalb dann ist sind beträgt der die das des dem den von ergibt sich wir erhalten es gilt lösung
    ergebnis antwort betrag
"""
LEADING = frozenset(_LEADING.split())  # words that say nothing of a value
SAYS = frozenset(
    ("is", "are", "equals", "ist", "sind", "beträgt", "be", "gives", "yields", "was")
)  # what stands for `=`
_WORD = re.compile(r"[A-Za-zäöüßÄÖÜ]+(?:['’-][A-Za-z]+)*(?!\w)")
JOIN = r"[,;:]|\.(?=\s)|→|⇒|⟹|⟶|=>|[-–]+>|∴|\\(?:Longr|R|r)ightarrow(?![A-Za-z])|\\(?:implies|to|therefore)(?![A-Za-z])"
JOINING = r"so|hence|thus|therefore|then|giving|gives?|yields?|and|which|also|daher|somit|folglich"
_EQUALS = r"(?:[=≈≃]|\\(?:approx|simeq)(?![A-Za-z]))"
_NAME = r"\\?[^\W\d_](?:\w|\{[^{}]*\}|\\(?=[a-z]))*"
# what joins statements, a few words, and a name that is told: `, so we get v =`
_AGAIN = re.compile(
    rf"(?:{JOIN}|(?<![\w\\])(?:{JOINING})(?!\w))(?P<words>(?:[\s$,]*[A-Za-zäöüß'’]+(?=[\s,$]))*[\s$,]*)(?P<name>{_NAME})\s*(?:\(t\))?\s*{_EQUALS}"
)
_FIRST = re.compile(rf"[\s$]*(?P<name>{_NAME})[\s$]*{_EQUALS}")
_SIGN = re.compile(r"[\s$]*(?:∴|⇒|⟹|→|=>|[-–]>|\\(?:Rightarrow|implies|therefore|to)(?![A-Za-z]))[\s$]*")
_FIGURES = re.compile(
    r"(?<![\s,;(])[\s,;(]*(?:(?:correct |rounded )?to |auf )?\d+ ?"
    r"(?:s\.?\s?f|d\.?\s?p|sig(?:nificant)?\.?\s*fig(?:ure)?s?|decimal places?|decimals)[\s.)]*$",
    re.IGNORECASE,
)
SYNONYMS = {  # other words for what is asked
    "velocity": "speed geschwindigkeit",
    "speed": "velocity geschwindigkeit",
    "acceleration": "beschleunigung",
    "angular": "rotational",
    "angular_velocity": "speed rate frequency winkelgeschwindigkeit",
    "angular_acceleration": "winkelbeschleunigung",
    "tension": "force pull spannung seilkraft kraft",
    "force": "pull push kraft",
    "normal_force": "reaction contact normalkraft",
    "friction_force": "frictional reibung reibungskraft",
    "displacement": "distance way weg strecke",
    "distance": "displacement weg strecke",
    "time": "zeit",
    "period": "time periode",
    "angle": "winkel",
    "inertia": "moment trägheitsmoment",
    "kinetic_energy": "energie",
    "energy": "energie",
    "angular_momentum": "drehimpuls",
    "torque": "moment drehmoment couple",
    "ball": "kugel",
    "sphere": "kugel",
    "disc": "scheibe",
    "cylinder": "zylinder walze",
    "block": "klotz quader",
    "rod": "stab stange",
    "ring": "reifen",
    "hoop": "reifen",
    "wheel": "rad",
    "pulley": "rolle",
    "drum": "trommel",
    "string": "seil faden schnur",
    "rope": "seil",
    "cart": "wagen",
    "bucket": "eimer",
    "stone": "stein",
    "man": "mann",
    "table": "tisch drehtisch",
    "plank": "brett",
    "plate": "platte",
    "spring": "feder",
    "power": "leistung",
    "work": "arbeit",
}


def nouns_for(*names: str) -> frozenset[str]:
    """The words of which names are made, `angular_velocity` or `left_string`, and others for the same."""
    own = {word for name in names for word in re.findall(r"[a-z]+", name.lower())}
    more = {word for name in (*names, *own) for word in SYNONYMS.get(name, "").split()}
    return frozenset(own | more)


def last_statement(text: str, names: Names) -> tuple[str, str]:
    """The statement that answers, in the columns where it stands, and the one before it that tells the same; '' where none does.

    `v² = 2 a h = 3.56 → v = 1.89 m/s`: the last that tells the name that is asked for.
    """
    again = [
        match for match in _AGAIN.finditer(text) if names.is_asked(match["name"]) and _is_known(match["words"], names)
    ]
    if not again:
        return text, ""
    first, start = _FIRST.match(text), again[-1].start("name")
    before = text[: again[0].start()] if first is not None and names.is_asked(first["name"]) else ""
    if len(again) > 1:
        before = text[again[-2].start("name") : again[-1].start()]
    return text[start:].rjust(len(text)), before


def without_prose(text: str, names: Names) -> str:
    """The line without the words in front of its value: `the acceleration of the block is 4.36 m/s²`; without what it is rounded to."""
    figures = _FIGURES.search(text)
    if figures is not None and figures.start():
        text = text[: figures.start()].ljust(len(text))
    value, _, behind = text.rpartition("=")
    if any(char.isdigit() for char in value) and "=" not in value and names.is_asked(behind.strip(" $.")):
        text = value.ljust(len(text))  # 3.13 m/s = v
    sign = _SIGN.match(text)
    at = sign.end() if sign is not None else 0
    said, last, says = "", at, False
    while (word := _WORD.match(text, at)) is not None and _known_word(word[0], names):
        said, last = word[0].lower(), word.end()
        says = says or said in SAYS
        at = len(text) - len(text[last:].lstrip(" ,$\t"))
        if said in SAYS and not _more_words(text, at, names):
            break
    rest = text[at:]
    told = _FIRST.match(rest)
    if (told is not None and names.is_asked(told["name"])) or (says and rest) or (rest[:1] in ("=", ":") and said):
        return rest.removeprefix(":").rjust(len(text))
    if sign is not None and not said:
        return text[sign.end() :].rjust(len(text))
    return text


def _more_words(text: str, at: int, names: Names) -> bool:
    """Whether a word that is known follows, or the name that is asked: `the answer is the tension T = …`."""
    word = _WORD.match(text, at)
    return word is not None and _known_word(word[0], names)


def _is_known(words: str, names: Names) -> bool:
    return all(_known_word(word, names) for word in _WORD.findall(words))


def _known_word(word: str, names: Names) -> bool:
    """Whether a word says nothing of a value; a letter of the scene does, and so does what is asked."""
    if word in names.letters or names.is_asked(word) or (len(word) == 1 and word not in "aAIi"):
        return False
    plain = word.lower()
    return plain in LEADING or plain in SAYS or plain in names.nouns
