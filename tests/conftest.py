"""`--regenerate`: the one option that writes anew all that the tests hold outputs against: goldens, expected files, tables of messages.

In these files the lists of shapes, formats and the like stand by their names, `{shapes}`: one more of them changes no file.
"""

from __future__ import annotations

import gc
from collections import Counter
from collections.abc import Iterator
from functools import cache
from itertools import count
from pathlib import Path

import pytest

DONE, TESTS_PER_LOOK = count(1), 200


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--regenerate", action="store_true", help="write goldens and expected files anew: read the difference"
    )
    parser.addoption(
        "--exhaustive", action="store_true", help="every case of the long sweeps, of which an ordinary run takes a part"
    )


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "sampled(every): of its cases an ordinary run takes every so many")
    config.addinivalue_line("markers", "exhaustive: only with --exhaustive; its kind has shorter tests")
    gc.set_threshold(
        2_000_000
    )  # of all that is kept for other tests little is garbage: looking for it took an eighth of all tests
    if config.getoption("--regenerate") and config.getoption("numprocesses", None):
        raise pytest.UsageError("--regenerate writes files that several tests share: leave -n out")


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(item: pytest.Item) -> None:
    """Look for garbage now and then, and never again through what is left then, which is kept for other tests."""
    if next(DONE) % TESTS_PER_LOOK == 0:
        gc.collect()
        gc.freeze()


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """The tests of one scene behind each other, whatever file they stand in: so each worker solves about half of the scenes."""
    if not (config.getoption("--exhaustive") or config.getoption("--regenerate")):
        left_out = [item for item, taken in zip(items, ordinary(items), strict=True) if not taken]
        config.hook.pytest_deselected(items=left_out)
        out = {*left_out}
        items[:] = [item for item in items if item not in out]
    items.sort(key=scene_of)


def ordinary(items: list[pytest.Item]) -> Iterator[bool]:
    """Whether an ordinary run takes each test: its cases are counted as they are written, so that each worker takes the same."""
    before: Counter[str] = Counter()
    for item in items:
        sampled, name = item.get_closest_marker("sampled"), item.nodeid.partition("[")[0]
        every = sampled.args[0] if sampled else 1
        yield item.get_closest_marker("exhaustive") is None and before[name] % every == 0
        before[name] += 1


def scene_of(item: pytest.Item) -> str:
    """The file of the scene that a test is about; nothing where it is about none."""
    values = item.callspec.params.values() if hasattr(item, "callspec") else ()
    return next((str(value) for value in values if isinstance(value, Path) and value.suffix == ".yaml"), "")


@cache
def lists() -> dict[str, str]:
    """What stands for each name between braces, the longest first."""
    from rotsolve.cli.solve import LAWS
    from rotsolve.core.quantity import BODY, QUANTITIES
    from rotsolve.elements.tables import CONNECTIONS, SHAPES
    from rotsolve.page.formats import FORMATS

    found = {
        "{shapes}": ", ".join(item.word for item in SHAPES),
        "{connections}": ", ".join(item.word for item in CONNECTIONS),
        "{quantities of a body}": ", ".join(word for word, item in QUANTITIES.items() if BODY in item.owners),
        "{formats}": ", ".join(FORMATS),
        "{formats|}": "|".join(FORMATS),
        "{laws}": ", ".join(LAWS),
        "{laws|}": "|".join(LAWS),
    }
    return dict(sorted(found.items(), key=lambda item: -len(item[1])))


class Expected:
    """Holds texts against files, or writes the files anew."""

    def __init__(self, regenerate: bool) -> None:
        self.regenerate = regenerate

    def __call__(self, path: Path, text: str) -> None:
        """The text is that of the file."""
        if self.regenerate:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(named(text), encoding="utf-8")
        assert path.exists(), f"no {path}: write it with --regenerate"
        assert text == filled(path.read_text(encoding="utf-8"))

    def case(self, table: Path, heads: tuple[str, str], messages: tuple[str, str]) -> None:
        """One case of a table of messages: its head and its message, as they stand there and as they came out."""
        if self.regenerate:
            old, new = f"{heads[0]}{messages[0]}".rstrip("\n"), f"{heads[1]}{named(messages[1])}".rstrip("\n")
            text = table.read_text(encoding="utf-8")
            assert text.count(f"{old}\n") == 1
            table.write_text(text.replace(f"{old}\n", f"{new}\n"), encoding="utf-8")
            return
        assert [*heads, messages[1].rstrip("\n")] == [heads[1], heads[1], filled(messages[0]).rstrip("\n")]


def filled(text: str) -> str:
    """A text of a file with its lists."""
    for name, words in lists().items():
        text = text.replace(name, words)
    return text


def named(text: str) -> str:
    """A text with its lists by their names."""
    for name, words in lists().items():
        text = text.replace(words, name)
    return text


@pytest.fixture
def regenerate(request: pytest.FixtureRequest) -> bool:
    return bool(request.config.getoption("--regenerate"))


@pytest.fixture
def expected(regenerate: bool) -> Expected:
    return Expected(regenerate)
