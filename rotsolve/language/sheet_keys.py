"""Sheet keys: the keys of a sheet file and of the problems that it lists; its reader and the reference read these tables."""

from __future__ import annotations

from rotsolve.language.keys import Key

PAPERS = A4, LETTER = ("a4", "letter")
NEW = "new"

SHEET: dict[str, Key] = {
    "sheet": Key("text", "the title of the sheet", required=True),
    "course": Key("text", "the course, above the title"),
    "date": Key("text", "the date; a field to fill in where nothing is said"),
    "instructions": Key("text", "what is to be known before the first problem, as `text` of a scene"),
    "paper": Key("choice", "the paper (default a4)", choices=PAPERS),
    "pictures": Key("flag", "whether problems have the picture of their scene (default yes)"),
    "room": Key("room", "the height of the room for each answer, such as `3 cm`, or `none` (default 2 cm)"),
    "ruled": Key("flag", "whether that room has lines to write on (default no)"),
    "problems": Key("problems", "the problems in their order: files, or maps of the keys below", required=True),
}

LISTED: dict[str, Key] = {
    "problem": Key("file", "its file, as seen from the folder of the sheet", required=True),
    "name": Key(
        "word", "its short name, as in the columns of a class: letters, digits, `-` and `_` (default that of its file)"
    ),
    "points": Key("marks", "its points; those of its `marking` are scaled to them (default the sum of these)"),
    "picture": Key("flag", "whether it has the picture of its scene (default as the sheet says)"),
    "room": Key("room", "the height of the room for each of its answers (default as the sheet says)"),
    "ruled": Key("flag", "whether that room has lines (default as the sheet says)"),
    "page": Key("choice", "`new`: it begins a page", choices=(NEW,)),
}
