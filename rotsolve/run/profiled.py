"""Profiled: what `--profile` prints: where the time of a run went, and what it has not done."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from time import process_time

import rotsolve
from rotsolve.profile import IMPORT, Profile, recording
from rotsolve.run.attempt import SolveRequest

STAGES = (
    ("start", "the interpreter and the command line"),
    (IMPORT, "{imported} modules of rotsolve, and what they need"),
    ("read", "the scene as a problem, with all its faults"),
    ("arrange", "what acts at which state, and what is asked for"),
    ("friction", "what sticks and what slips"),
    ("laws", "facts and equations"),
    ("plan", "the fewest equations that settle what is asked"),
    ("solve", "one unknown at a time"),
    ("verify", "a second law, all equations, limits, dimensions"),
    ("compose", "letters, sections, answers"),
    ("confirm", "an assembly of all bodies' equations held against the answers"),
    ("render", "the page"),
    ("rest", "files read and written"),
)
HEAVY = ("sympy", "numpy", "rich", "matplotlib", "pebble")
NAMED = 10  # of the bodies that were left out
PACKAGE = Path(rotsolve.__file__).parent


def with_profile(work: Callable[[SolveRequest], int], request: SolveRequest) -> int:
    """Do the work of a command, and say on standard error where its time went."""
    with recording() as profile:
        code = work(request)
    sys.stdout.flush()
    print("\n".join(profile_report(profile, len(request.files))), file=sys.stderr)
    return code


def profile_report(profile: Profile, files: int) -> Iterator[str]:
    """The time of each stage, and what was skipped."""
    total, imported = process_time(), len(modules()[0])
    told = {"start": profile.began, **profile.spent}
    told["rest"] = total - sum(told.values())
    yield f"Processor time of {files} {'file' if files == 1 else 'files'}: {1000 * total:.1f} ms"
    for name, words in STAGES:
        if name in told:
            about = words.format(imported=imported)
            yield f"  {name:<9}{1000 * told[name]:8.1f} ms {told[name] / total:5.0%}  {about}"
    for kind, spent in profile.within.items():
        yield f"  of which {1000 * spent:.1f} ms {kind}"
    yield "Skipped"
    yield from what_was_skipped(profile)


def what_was_skipped(profile: Profile) -> Iterator[str]:
    """What was not done, since nothing that is asked needs it."""
    for what, names in profile.skipped.items():
        more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
        yield f"  {what}: {', '.join(names[:NAMED]) or 'none'}{more}"
    written, used = (profile.counts.get(f"equations {what}", 0) for what in ("written", "used"))
    yield f"  equations: {written - used} of {written} serve as checks alone"
    loaded, there = modules()
    packages = sorted({parent(name) for name in there} - {parent(name) for name in loaded})
    yield f"  modules: {len(there) - len(loaded)} of {len(there)}, among them all of {', '.join(packages) or 'none'}"
    yield f"  packages: {', '.join(name for name in HEAVY if name not in sys.modules)}"


def parent(module: str) -> str:
    """The package of a module."""
    return module.rpartition(".")[0]


def modules() -> tuple[list[str], list[str]]:
    """The modules of rotsolve that are imported, and all that there are."""
    paths = (path.relative_to(PACKAGE.parent).with_suffix("").parts for path in PACKAGE.rglob("*.py"))
    there = sorted(".".join(parts[:-1] if parts[-1] == "__init__" else parts) for parts in paths)
    return [name for name in there if name in sys.modules], there
