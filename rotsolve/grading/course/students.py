"""Students: who handed in a paper, when two rows are of one student, and what tells apart those of the same name."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

IDENTITIES = ("number", "email", "login")  # what one student alone has, the surest first


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
            own, theirs = getattr(self, kind).casefold(), getattr(other, kind).casefold()
            if own and theirs:
                return bool(own == theirs)
        return None

    def named_alike(self, other: Student) -> bool:
        """Whether the names can be those of one person: one may have words that the other leaves out."""
        return not self.words or not other.words or self.words <= other.words or other.words <= self.words

    def completed(self, earlier: Student) -> Student:
        """This student, with what only an earlier row has said."""
        said = {field: getattr(self, field) or getattr(earlier, field) for field in self.__struct_fields__}
        return Student(**said)


def names_apart(students: Sequence[tuple[Student, str]]) -> list[str]:
    """What each student is called, no two alike: the name, with the number or else the row where several have it."""
    names = [student.called or row for student, row in students]
    count: dict[str, int] = {}
    for name in names:
        count[name.casefold()] = count.get(name.casefold(), 0) + 1
    found = []
    for name, (student, row) in zip(names, students, strict=True):
        sure = next(filter(None, (getattr(student, kind) for kind in IDENTITIES)), row)
        found.append(f"{name} ({sure})" if count[name.casefold()] > 1 else name)
    seen: dict[str, int] = {}
    for label in found:
        seen[label.casefold()] = seen.get(label.casefold(), 0) + 1
    rows = [row for _, row in students]
    return [f"{label}, {row}" if seen[label.casefold()] > 1 else label for label, row in zip(found, rows, strict=True)]
