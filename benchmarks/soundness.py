"""Whether a scene is answered right, or refused by name: random compositions of all elements, and what must hold of them.

    python benchmarks/soundness.py [--scenes N] [--seed S] [--first K] [--jobs J] [--failures FOLDER] [--space] [--write]

Bodies of all kinds are held, joined, driven, told of and asked at random (benchmarks/compositions). Each scene is answered, and the answer
confirmed by the independent assembly of all bodies' equations; or it is refused. One that is answered must have the same answers said in
another way (benchmarks/compositions/relations.py) and by other laws. What is wrong is written into FOLDER as a scene, as small as leaving
out lines makes it. `--space` does the same with bodies in space (benchmarks/compositions/space.py, turned.py). `--write` puts the table
into docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter
from pathlib import Path

from compositions import compose, space, turned
from compositions.judge import (
    BROKEN,
    NAMED,
    RIGHT,
    SAID,
    SILENT,
    SLOW,
    UNCONFIRMED,
    UNTELLABLE,
    UNTRUE,
    VERDICTS,
    judged,
    run,
)
from report import machine, write_section
from trials.crew import run_all
from trials.outcome import outcome
from trials.scene import Scene, read, written
from trials.shrink import shrunk
from trials.trial import Result

IN_SPACE = "## The same in space: `python benchmarks/soundness.py --space`"
HEAD = "## Answered right, or refused by name: `python benchmarks/soundness.py`"
WRONG = (SAID, SILENT, SLOW, BROKEN)
MEANING = {
    RIGHT: "answered, confirmed by the assembly, and the same when said otherwise",
    UNCONFIRMED: "answered, and said that the assembly can't tell",
    NAMED: "refused with the word or law that is missing",
    UNTRUE: "as incomplete, contradictory or never reached, though the assembly answers",
    UNTELLABLE: "as incomplete, contradictory or never reached",
    SAID: "the assembly contradicts: the answer is withheld",
    SILENT: "another answer when the scene is said otherwise",
    SLOW: "more than 2 s of CPU, or no end of it and of the same said otherwise after 20 s",
    BROKEN: "internal error, or a scene that can't be read",
}


def smallest(scene: Scene, verdict: str, why: str) -> Scene:
    """The scene without what can be left out while its verdict stays, with the same reason."""

    def same(other: Scene) -> bool:
        found, reason = judged(other, outcome(written(other), 7), random.Random(0))
        return found == verdict and plain(reason) == plain(why)

    return shrunk(scene, same) if verdict in (SAID, BROKEN) else scene


def report(options: argparse.Namespace, result: Result, verdict: str) -> None:
    """Print what is wrong, and write the scene that shows it."""
    why = result.faults[0] if result.faults else ""
    print(f"scene {result.number} ({result.kind}): {verdict}: {why.splitlines()[0] if why else ''}", flush=True)
    options.failures.mkdir(parents=True, exist_ok=True)
    drawn = space.drawn if options.space else compose.drawn
    scene = read(result.text) if result.text else drawn(options.seed, result.number)[1]
    text = written(smallest(scene, verdict, why))
    head = "".join(f"# {line}\n" for line in (verdict, *why.splitlines()))
    file = options.failures / f"{verdict.split()[-1]}-{options.seed}-{result.number}.yaml"
    file.write_text(head + text, encoding="utf-8")


def table(counts: Counter[str], reasons: Counter[str]) -> str:
    total = sum(counts.values())
    lines = ["| | scenes | share | |", "| --- | ---: | ---: | --- |"]
    lines += [
        f"| {verdict} | {counts[verdict]} | {counts[verdict] / total:.2%} | {MEANING[verdict]} |"
        for verdict in VERDICTS
    ]
    lines += ["", "The commonest reasons of refusals and of what is not confirmed:", ""]
    lines += [f"- {count} × {reason}" for reason, count in reasons.most_common(12)]
    return "\n".join(lines)


def plain(reason: str) -> str:
    """A reason without the names and numbers of its scene."""
    words = (reason.splitlines() or [""])[0].removeprefix("error: ").split("`")
    return "…".join(words[::2]).split(": ")[0]


def main() -> None:
    """Judge the scenes, and print or write the table."""
    parser = argparse.ArgumentParser(description="Whether a scene is answered right, or refused by name.")
    parser.add_argument("--scenes", type=int, default=1000, help="random scenes (1000)")
    parser.add_argument("--seed", type=int, default=1, help="of the random scenes (1)")
    parser.add_argument("--first", type=int, default=0, help="number of the first scene (0)")
    parser.add_argument("--jobs", type=int, default=2, help="processes (2)")
    parser.add_argument(
        "--time-limit", type=float, default=20.0, help="seconds of CPU after which a scene is given up (20)"
    )
    parser.add_argument("--failures", type=Path, default=Path("soundness-failures"), help="where wrong scenes go")
    parser.add_argument("--space", action="store_true", help="scenes in space")
    parser.add_argument("--write", action="store_true", help="write the table into docs/benchmarks.md")
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    reasons: Counter[str] = Counter()
    started = time.monotonic()
    for result in run_all(
        turned.run if options.space else run,
        options.seed,
        range(options.first, options.first + options.scenes),
        options.jobs,
        options.time_limit,
    ):
        verdict = SLOW if result.outcome == "hang" else result.outcome
        counts[verdict] += 1
        if verdict in WRONG:
            report(options, result, verdict)
        elif result.faults:
            reasons[plain(result.faults[0])] += 1
        if sum(counts.values()) % 500 == 0:
            print(f"{dict(counts)}, {time.monotonic() - started:.0f} s", flush=True)
    page = "\n\n".join(
        (
            IN_SPACE if options.space else HEAD,
            machine(),
            f"{options.scenes} scenes of seed {options.seed}:",
            table(counts, reasons),
        )
    )
    print(page)
    if options.write:
        write_section("soundness-in-space" if options.space else "soundness", page)
    sys.exit(1 if any(counts[verdict] for verdict in (SILENT, SLOW, BROKEN)) else 0)


if __name__ == "__main__":
    main()
