"""Concurrent writers, removers and readers of one bundle store, and what they observe.

    python benchmarks/concurrency.py --seconds 60

Five processes save the same few scenes repeatedly, two remove bundles while more than a few exist,
one lists and loads, one verifies; another one saves and is killed at random (SIGKILL), and its
staging folders are made to look old, so that others remove them. Each process counts its actions.
Violations are counted as broken: a save or removal that fails; a reader that sees a partial bundle,
or hardly ever a complete one; a staging folder that is left at the end. Writes the table to
``concurrency.md``; the exit code is 1 if anything was broken.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import multiprocessing
import os
import random
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.process import BaseProcess
from pathlib import Path

from posing import tables

import assets_cache
from generator.bundle import load, save, verify
from generator.errors import MissingError
from generator.scene import Scene

HERE = Path(__file__).parent
COUNTS = {"save": 5, "remove": 2, "list": 1, "verify": 1}
"""Number of processes per role."""

SCENES, KEPT = 8, 4
"""Number of bundles that are saved, and that removers leave for the readers."""

WHOLE = {"list": "loaded whole", "verify": "sound"}
"""Minimum observations of a reader per two seconds; with fewer the test is inconclusive."""

Step = Callable[[Path, Sequence[Scene], random.Random], str]


def do_save(store: Path, scenes: Sequence[Scene], rng: random.Random) -> str:
    """Save one of the scenes."""
    save(rng.choice(scenes), store)
    return "saved"


def do_remove(store: Path, scenes: Sequence[Scene], rng: random.Random) -> str:
    """Remove a bundle; another process may have removed it already."""
    time.sleep(rng.uniform(0, 0.08))
    names = sorted(p.name for p in store.iterdir() if not p.name.startswith("."))
    if len(names) <= KEPT:
        return _wait()
    try:
        assets_cache.remove(store / rng.choice(names), store)
    except MissingError:
        return "was removed already"
    return "removed"


def do_list(store: Path, scenes: Sequence[Scene], rng: random.Random) -> str:
    """List the store and load a bundle of it."""
    found = [p for p in assets_cache.entries(store) if p.parent == store]
    if not found:
        return _wait()
    try:
        load(rng.choice(found))
    except MissingError:
        return "was removed meanwhile"
    return "loaded whole"


def do_verify(store: Path, scenes: Sequence[Scene], rng: random.Random) -> str:
    """Verify a bundle of the store by its path, whether or not it still exists."""
    found = sorted(store.glob("[!.]*"))
    if not found:
        return _wait()
    reasons = verify(rng.choice(found))
    wrong = [r for r in reasons if not r.startswith("There is no bundle")]
    if wrong:
        raise AssertionError("; ".join(wrong))
    return "removed meanwhile" if reasons else "sound"


def _wait() -> str:
    time.sleep(0.002)
    return "too few bundles"


STEPS: dict[str, Step] = {
    "save": do_save, "remove": do_remove, "list": do_list, "verify": do_verify,
}  # fmt: skip


def work(kind: str, seed: int, store: Path, scenes: Sequence[Scene], end: float, log: Path) -> None:
    """Repeat a step until ``end``; record the counts of its results and failures."""
    rng, counts, broken = random.Random(seed), Counter[str](), list[str]()
    while time.monotonic() < end:
        try:
            counts[STEPS[kind](store, scenes, rng)] += 1
        except Exception:
            broken.append(traceback.format_exc(limit=-4))
    log.write_text(json.dumps({"kind": kind, "counts": counts, "broken": broken}))


def kill_savers(store: Path, scenes: Sequence[Scene], end: float, log: Path) -> Counter[str]:
    """Start and kill writers until ``end``; return the counts."""
    context, rng, counts = multiprocessing.get_context("fork"), random.Random(99), Counter[str]()
    while time.monotonic() < end:
        args = ("save", rng.randrange(2**30), store, scenes, end, log / "killed.json")
        saver = context.Process(target=work, args=args, daemon=True)
        saver.start()
        time.sleep(rng.uniform(0.05, 0.6))
        saver.kill()
        saver.join()
        counts["killed"] += 1
        counts["staging folders made to look old"] += age(store)
    return counts


def age(store: Path) -> int:
    """Make all staging folders, including those in use, look an hour old; return their number."""
    past, count = time.time() - 3600, 0
    for staging in store.glob(".staging-*"):
        with contextlib.suppress(OSError):
            os.utime(staging, (past, past))
            count += 1
    return count


def race(store: Path, seconds: float) -> tuple[dict[str, Counter[str]], list[str]]:
    """Run all roles at once; return each role's counts, and the violations."""
    context = multiprocessing.get_context("fork")
    shipped = sorted(assets_cache.find("starter"), key=lambda p: (p / "scene.json").stat().st_size)
    first = [only_first(load(path)) for path in shipped[:2]]
    scenes = [first[k % 2].replace(name=f"scene-{k}") for k in range(SCENES)]
    expected = {save(scene, store).name for scene in scenes}
    counts, broken = {kind: Counter[str]() for kind in COUNTS}, list[str]()
    with tempfile.TemporaryDirectory(prefix="tabletopgen-race-") as folder:
        log, end = Path(folder), time.monotonic() + seconds
        pool = [
            context.Process(
                target=work, args=(kind, n, store, scenes, end, log / f"{kind}_{n}.json"),
                daemon=True,
            )
            for kind, number in COUNTS.items() for n in range(number)
        ]  # fmt: skip
        for process in pool:
            process.start()
        counts["kill"] = kill_savers(store, scenes, end, log)
        broken += [f"process {p.name} exited with code {p.exitcode}" for p in _late(pool)]
        for counted in (json.loads(path.read_bytes()) for path in log.glob("*_*.json")):
            counts[counted["kind"]].update(counted["counts"])
            broken += [f"{counted['kind']}: {text}" for text in counted["broken"]]
    broken += [
        f"{kind} had only {counts[kind][what]} of {what}"
        for kind, what in WHOLE.items()
        if counts[kind][what] < seconds / 2
    ]
    age(store)
    for scene in scenes:
        save(scene, store)
    left = {p.name for p in store.iterdir()} ^ expected
    broken += [f"left over or missing at the end: {name}" for name in sorted(left)]
    return counts, broken


def only_first(scene: Scene) -> Scene:
    """Return a scene with one object, which is saved and read quickly."""
    first = next(o for o in scene.objects if o.placement.on == "table")
    return scene.replace(objects=(first,))


def _late(
    pool: Sequence[BaseProcess],
) -> Iterator[BaseProcess]:
    """Wait for processes; yield those that failed."""
    for process in pool:
        process.join(60)
        if process.exitcode != 0:
            process.kill()
            yield process


def table(counts: dict[str, Counter[str]], broken: Sequence[str], head: str) -> str:
    """Return the counts as Markdown."""
    rows = [
        f"| {kind} | {COUNTS.get(kind, 1)} | {what} | {count} |"
        for kind, counted in counts.items()
        for what, count in counted.most_common()
    ]
    titles = "| process | number | result | count |"
    lines = [head, "", titles, "|---|---|---|---|", *rows, "", f"Broken: {len(broken)}.", ""]
    return "\n".join([*lines, *(f"- {text}" for text in broken[:10])])


def main() -> int:
    """Run the test, print and write the table; return 1 if anything was broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()

    with tempfile.TemporaryDirectory(prefix="tabletopgen-store-") as store:
        counts, broken = race(Path(store), args.seconds)
    text = table(counts, broken, f"`{tables.command_line('--out')}`, {tables.where()}.")
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "concurrency.md").write_text(text, encoding="utf-8")
    print(text)
    return 1 if broken else 0


if __name__ == "__main__":
    raise SystemExit(main())
