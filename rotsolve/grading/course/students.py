"""Students: who handed in a paper, when two rows are of one student, and what tells apart those of the same name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from msgspec import Struct

NUMBER = "number"
IDENTITIES = (NUMBER, "email", "login")  # what one student alone has, the surest first


class Student(Struct, frozen=True):
    """What a class says of a student; `canvas` is the number by which Canvas knows them, '' stands for what is not said."""

    name: str = ""
    number: str = ""
    email: str = ""
    login: str = ""
    section: str = ""
    canvas: str = ""

    @property
    def called(self) -> str:
        """The name, or what there is in its place."""
        return self.name or self.number or self.email or self.login

    @property
    def words(self) -> frozenset[str]:
        """The words of the name, in whatever order: `Lovelace, Ada` is `Ada Lovelace`."""
        return frozenset(self.name.casefold().replace(",", " ").split())

    def same_identity(self, other: Student) -> bool | None:
        """Whether the surest mark that both have is the same; None where they share none."""
        for kind in IDENTITIES:
            own, theirs = self.identity(kind), other.identity(kind)
            if own and theirs:
                return bool(own == theirs)
        return None

    def identity(self, kind: str) -> str:
        """A number, address or name for the login as it is compared: spreadsheets drop the zeros that a number begins with."""
        text: str = getattr(self, kind).casefold()
        return (text.lstrip("0") or "0") if kind == NUMBER and text.isdecimal() else text

    def named_alike(self, other: Student) -> bool:
        """Whether the names can be those of one person: one may have words that the other leaves out."""
        return not self.words or not other.words or self.words <= other.words or other.words <= self.words

    def completed(self, earlier: Student) -> Student:
        """This student, with what only an earlier row has said."""
        said = {field: getattr(self, field) or getattr(earlier, field) for field in self.__struct_fields__}
        return Student(**said)


def names_apart(students: Sequence[tuple[Student, str]]) -> list[str]:
    """What each student is called, no two alike: the name, with the number or else the row where several have it."""
    names = [name_and_identity(student, row) for student, row in students]
    called = Counter(name.casefold() for name, _ in names)
    alike = Counter((name.casefold(), sure.casefold()) for name, sure in names)
    return [
        name_apart((name, sure), row, called[name.casefold()], alike[name.casefold(), sure.casefold()])
        for (name, sure), (_, row) in zip(names, students, strict=True)
    ]


def name_and_identity(student: Student, row: str) -> tuple[str, str]:
    """What a student is called, and the surest that tells them from others; the row in the place of either."""
    sure = next(filter(None, (getattr(student, kind) for kind in IDENTITIES)), row)
    return student.called or row, sure


def name_apart(name: tuple[str, str], row: str, called: int, alike: int) -> str:
    """The name as it tells apart those that are called so, and those of them with the same number."""
    if called == 1:
        return name[0]
    label = f"{name[0]} ({name[1]})"
    return label if alike == 1 else f"{label}, {row}"
