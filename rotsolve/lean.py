"""Lean: what a process of our own leaves out of the packages that it imports: half a package each, a seventh of a cold run.

Only `start.process` asks for it, where no other program shares the process. A module that is put off is loaded whole as soon as
something is asked of it that it can't tell yet, so whatever runs finds what it would find without this file:

- PyYAML: its parser in C needs the events and a few errors, but not the loaders in Python, whose patterns take 6 ms to compile;
- msgspec: records need none of its encoders;
- inspect: flint's modules ask it for the flags of functions alone, and `platform`, which uuid asks for the name of the system;
- datetime: all that msgspec asks of it is in C; up to Python 3.11 it is made in Python too before that takes its place;
- FLINT: of its 9000 calls from one function to another a scene makes a few dozen, so that each is bound when it is first made (1.1 ms).

Our own modules, two hundred to a scene, are loaded from where they are known to be: looking for them would take a twentieth of a cold run.
What all runs have loaded is read in one piece (`together`), which saves another tenth.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from importlib import import_module
from importlib._bootstrap_external import MAGIC_NUMBER
from importlib.machinery import ModuleSpec, SourceFileLoader
from marshal import dumps, loads
from types import CodeType, ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from mmap import mmap

CODE_FLAGS = {  # of CPython's functions, as `inspect` has them
    "CO_OPTIMIZED": 1,
    "CO_NEWLOCALS": 2,
    "CO_VARARGS": 4,
    "CO_VARKEYWORDS": 8,
    "CO_NESTED": 16,
    "CO_GENERATOR": 32,
    "CO_NOFREE": 64,
    "CO_COROUTINE": 128,
    "CO_ITERABLE_COROUTINE": 256,
    "CO_ASYNC_GENERATOR": 512,
}
ENCODERS = ("inspect", "json", "msgpack", "toml", "yaml")  # of msgspec
ERRORS = {  # of PyYAML, by the modules that its parser in C has them from; whether they tell a place
    "reader": ("ReaderError", False),
    "scanner": ("ScannerError", True),
    "parser": ("ParserError", True),
    "composer": ("ComposerError", True),
    "constructor": ("ConstructorError", True),
    "emitter": ("EmitterError", False),
    "serializer": ("SerializerError", False),
    "representer": ("RepresenterError", False),
}


LARGE = 1_000_000  # bytes
UNCHANGED = MAGIC_NUMBER + bytes(4)  # how bytecode begins that goes by the time and size of its source


class Near(SourceFileLoader):
    """Loads a module of ours by its bytecode, where that is as new as its source; else as Python does it."""

    together: ClassVar[
        dict[str, tuple[tuple[int, int], CodeType]]
    ] = {}  # by the file of the source: its time and size, its bytecode
    loaded: ClassVar[dict[str, tuple[tuple[int, int], CodeType]]] = {}  # of this run

    def __init__(self, name: str, path: str, source: os.stat_result, kept: str) -> None:
        super().__init__(name, path)
        self.source, self.kept = source, kept

    @classmethod
    def find_spec(cls, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """Where a module or a package within one of our packages is; None where it is in no such file."""
        if path is None or not name.startswith("rotsolve."):
            return None
        last = name.rpartition(".")[2]
        return cls.spec_in(name, path[0], last) or cls.spec_in(name, f"{path[0]}{os.sep}{last}", "__init__")

    @classmethod
    def spec_in(cls, name: str, folder: str, last: str) -> ModuleSpec | None:
        """Where module `name` is, if `last` is its file in `folder`."""
        file = f"{folder}{os.sep}{last}.py"
        try:
            source = os.stat(file)
        except OSError:
            return None
        kept = f"{folder}{os.sep}__pycache__{os.sep}{last}.{sys.implementation.cache_tag}.pyc"
        package = last == "__init__"
        spec = ModuleSpec(name, cls(name, file, source, kept), origin=file, is_package=package)
        spec.has_location, spec.cached = True, kept
        if package:
            spec.submodule_search_locations = [folder]
        return spec

    def get_code(self, fullname: str) -> CodeType | None:
        marks = (int(self.source.st_mtime), self.source.st_size)
        known = self.together.get(self.path)
        code = known[1] if known is not None and known[0] == marks else self.read_code(bytecode_head(marks))
        code = super().get_code(fullname) if code is None else code
        if code is not None:
            self.loaded[self.path] = marks, code
        return code

    def read_code(self, head: bytes) -> CodeType | None:
        """The bytecode from a file of its own that begins with `head`."""
        try:
            data = contents(self.kept)
        except OSError:
            return None
        if data[:16] != head:
            return None
        code: CodeType = loads(memoryview(data)[16:])
        return code if code.co_filename == self.path else None


def contents(path: str) -> bytes | mmap:
    """What is in a file; a large one is looked at where the system holds it, for to read it into new memory takes 2 ms for each 4 MB."""
    with open(path, "rb", 0) as file:
        if os.fstat(file.fileno()).st_size < LARGE:
            return file.read()
        from mmap import ACCESS_READ, mmap

        return mmap(file.fileno(), 0, access=ACCESS_READ)


def bytecode_head(marks: tuple[int, int]) -> bytes:
    """How bytecode begins that goes by a source of this time and size."""
    return UNCHANGED + b"".join((mark & 0xFFFFFFFF).to_bytes(4, "little") for mark in marks)


def take_together() -> None:
    """Have at hand what is kept in one piece, where modules of ours are loaded as `Near` does it."""
    if Near in sys.meta_path:
        from rotsolve.together import KEPT

        Near.loaded.clear()  # the piece is no part of itself
        Near.together = {file: (marks, code) for file, marks, code in KEPT}


def keep_together() -> None:
    """After a run that has loaded what a scene needs: keep it in one piece; of what is kept, only what this run needed too.

    So what few runs need is soon left out, and a source that has changed begins a new piece.
    """
    kept, loaded, module = Near.together, Near.loaded, sys.modules.get("rotsolve.together")
    changed = any(marks != loaded.get(file, (marks,))[0] for file, (marks, _) in kept.items())
    if module is None or sys.dont_write_bytecode or not (changed or kept.keys() - loaded.keys() or not kept):
        return
    pieces = tuple((file, *piece) for file, piece in loaded.items() if changed or not kept or file in kept)
    assert module.__spec__ is not None and module.__file__ is not None and module.__spec__.cached is not None
    loader, source = SourceFileLoader(module.__name__, module.__file__), os.stat(module.__file__)
    code = loader.source_to_code(loader.get_data(module.__file__), module.__file__)
    code = code.replace(co_consts=tuple(pieces if const == () else const for const in code.co_consts))
    loader.set_data(module.__spec__.cached, bytecode_head((int(source.st_mtime), source.st_size)) + dumps(code))


class PutOff(ModuleType):
    """Stands for a module of which a few things are known, until another one is asked for: then the module takes its place."""

    def __init__(self, name: str, **known: Any) -> None:
        super().__init__(name)
        self.__dict__.update(known)
        sys.modules[name] = self

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def leave_out() -> None:
    """Put off what no scene needs; what is imported already stays."""
    if sys.pycache_prefix is None and not sys.flags.optimize and Near not in sys.meta_path:
        sys.meta_path.insert(0, Near)
    if hasattr(sys, "setdlopenflags"):
        sys.setdlopenflags(os.RTLD_LAZY)
    if "datetime" not in sys.modules:
        PutOff("datetime", **public(import_module("_datetime")))
    for name in ENCODERS:
        if "msgspec" not in sys.modules:
            PutOff(f"msgspec.{name}")
    if "inspect" not in sys.modules:
        PutOff("inspect", **CODE_FLAGS)
    if "platform" not in sys.modules and hasattr(os, "uname"):
        PutOff("platform", system=lambda: os.uname().sysname)
    if "yaml" not in sys.modules:
        put_off_yaml()


def public(module: ModuleType) -> dict[str, Any]:
    """What a module has, but what Python knows of it."""
    return {name: item for name, item in vars(module).items() if not name.startswith("__")}


def put_off_yaml() -> None:
    """PyYAML with its parser in C alone; the whole package where there is none."""
    from importlib.machinery import PathFinder

    spec = PathFinder.find_spec("yaml")
    if spec is None or spec.submodule_search_locations is None:
        return
    package = PutOff("yaml", __path__=list(spec.submodule_search_locations), __spec__=spec)
    error, events, *_ = (import_module(f"yaml.{name}") for name in ("error", "events", "nodes", "tokens"))
    for module, (name, marked) in ERRORS.items():
        base = error.MarkedYAMLError if marked else error.YAMLError
        setattr(package, module, SimpleNamespace(**{name: type(name, (base,), {})}))
    try:
        from yaml._yaml import CParser
    except ImportError:
        del sys.modules["yaml"]
        return

    def parse(source: str, Loader: Any) -> Iterator[Any]:
        loader = Loader(source)
        while loader.check_event():
            yield loader.get_event()

    package.__dict__.update(public(error), **public(events), CSafeLoader=CParser, parse=parse)
