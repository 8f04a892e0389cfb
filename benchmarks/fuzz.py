"""Hostile input of every kind, thousands of cases each, and its outcomes.

    python benchmarks/fuzz.py --cases 5000
    python benchmarks/fuzz.py --cases 500 --kind glb --kind obj
    python benchmarks/fuzz.py --kind glb --case 17 --seed 0

Each case runs in a monitored process (see ``tests/fuzz/hostile``). One row per kind is written to
``fuzz.csv`` when it finishes, replacing an existing row; ``fuzz.md`` shows all rows. With
``--case`` a single case is run and its outcome printed. The exit code is 1 if a case had a bad
outcome.
"""

from __future__ import annotations

import argparse
import csv
import shlex
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tests" / "fuzz"))

from hostile.harness import MOST_MIB, SECONDS, Tally, Worker, report, run_cases  # noqa: E402
from hostile.targets import KINDS  # noqa: E402

Row = dict[str, str]
FIELDS: tuple[str, ...] = (
    "kind", "cases", "accepted", "refused", "foreign", "late", "heavy", "outside", "slowest_s",
    "heaviest_mib", "seconds", "seed", "date",
)  # fmt: skip
HEADS = ("kind", "cases", "accepted", "refused", "foreign exceptions", "time-outs", "over memory",
         "changes outside", "slowest (s)", "largest growth (MiB)", "in all (s)", "seed",
         "date")  # fmt: skip


def row(tally: Tally, seconds: float) -> Row:
    """Return a row of the table."""
    ends = ("accepted", "refused", "foreign", "late", "heavy", "outside")
    return {
        "kind": tally.kind, "cases": str(len(tally.outcomes)),
        **{end: str(tally.count(end)) for end in ends},
        "slowest_s": f"{tally.slowest:.2f}", "heaviest_mib": f"{tally.heaviest:.0f}",
        "seconds": f"{seconds:.0f}", "seed": str(tally.seed), "date": date.today().isoformat(),
    }  # fmt: skip


def run(kind: str, cases: Sequence[int], seed: int) -> tuple[Tally, float]:
    """Run cases of a kind in a separate worker."""
    began = time.monotonic()
    with Worker() as worker:
        tally = run_cases(worker, kind, seed, cases)
    return tally, time.monotonic() - began


def read(table: Path) -> dict[str, Row]:
    """Return the existing rows, by kind."""
    if not table.is_file():
        return {}
    with table.open(newline="") as file:
        return {found["kind"]: found for found in csv.DictReader(file)}


def write(rows: dict[str, Row], folder: Path, machine: str, command: str) -> None:
    """Write the rows as CSV and as a page."""
    folder.mkdir(parents=True, exist_ok=True)
    kept = [rows[kind] for kind in KINDS if kind in rows]
    with (folder / "fuzz.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(kept)
    (folder / "fuzz.md").write_text(page(kept, machine, command))


def page(rows: Sequence[Row], machine: str, command: str) -> str:
    """Return the table as Markdown."""
    sums = {name: sum(int(r[name]) for r in rows) for name in FIELDS[1:8]}
    total = {"kind": "**all**", **{name: str(value) for name, value in sums.items()}}
    lines = [
        "# Hostile input",
        "",
        f"`{command}`, {machine}, {date.today().isoformat()}.",
        "",
        "A case is one hostile input, read by the package's own entry points in a monitored "
        f"process. Its outcome is good if it ends within {SECONDS:g} s of processor time and "
        f"{MOST_MIB:g} MiB, including child processes, with a result or an error of the package, "
        "and changes nothing outside its folder. A foreign exception is any other one, or a "
        "crash. `python benchmarks/fuzz.py --kind KIND --case N --seed SEED` repeats one case.",
        "",
        "| " + " | ".join(HEADS) + " |",
        "|" + "---|" * len(HEADS),
        *("| " + " | ".join(r.get(name, "") for name in FIELDS) + " |" for r in (*rows, total)),
    ]
    return "\n".join(lines) + "\n"


def again(kind: str, number: int, seed: int) -> int:
    """Run one case and print its outcome; return the exit code."""
    tally, _ = run(kind, [number], seed)
    print(tally.outcomes[0].told())
    return len(tally.bad)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--cases", type=int, default=300, help="cases per kind")
    parser.add_argument("--kind", action="append", help="a kind; may be repeated; all by default")
    parser.add_argument("--case", type=int, help="run only this case of a kind")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--workers", type=int, default=2, help="kinds in parallel")
    parser.add_argument("--machine", default="this machine", help="a remark on the page")
    parser.add_argument("--out", type=Path, default=HERE / "results")
    chosen = parser.parse_args(arguments)
    kinds = chosen.kind or list(KINDS)
    if chosen.case is not None:
        return again(kinds[0], chosen.case, chosen.seed)
    given = sys.argv[1:] if arguments is None else list(arguments)
    command = shlex.join(["python", "benchmarks/fuzz.py", *given])
    rows, bad = read(chosen.out / "fuzz.csv"), 0
    with ThreadPoolExecutor(chosen.workers) as pool:
        for tally, seconds in pool.map(
            lambda kind: run(kind, range(chosen.cases), chosen.seed), kinds
        ):
            rows[tally.kind] = row(tally, seconds)
            write(rows, chosen.out, chosen.machine, command)
            print(", ".join(f"{k} {v}" for k, v in rows[tally.kind].items()), flush=True)
            slowest = sorted(tally.outcomes, key=lambda o: -o.seconds)[:5]
            print("  slowest: " + ", ".join(f"{o.number} ({o.seconds:.1f} s)" for o in slowest))
            bad += len(tally.bad)
            print(report(tally), end="", flush=True)
    return int(bool(bad))


if __name__ == "__main__":
    raise SystemExit(main())
