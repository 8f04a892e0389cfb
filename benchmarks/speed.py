"""Speed of our environments and of others; resets, refreshing, pictures, vectors, memory.

    python benchmarks/speed.py --setup            # makes the others' virtual environments with pip
    python benchmarks/speed.py                    # uses them
    python benchmarks/speed.py --parts memory --resets 10000
    python benchmarks/speed.py --parts refreshing

The others are FetchPickAndPlace-v4 (gymnasium-robotics) and PandaPickAndPlace-v3 (panda-gym), each
with the versions of ``PEERS`` in its own virtual environment below ``--venvs``. All are timed in
turn, in one process each, with random actions and their own episodes; the measure is simulated
seconds per second spent in ``step``, by wall clock and CPU time, as the median over rounds.

The part ``refreshing`` steps alternately at fixed tables and at those of a ``RefreshingScenes``
that one process keeps refreshing at its usual rate, all with eight objects, for 100 s each. The
cost of refreshing is the loss in the median of the rounds: of the steps alone, and with resets, in
which new tables are compiled; by wall clock and by this process's CPU time. The goal is less than 5
% by wall clock, with the worker on a second core that is otherwise idle.

Rows are written to ``speed.csv``, the table to ``speed.md``, or to ``speed_PART`` without
``stepping``. Run it alone on the machine, or use ``--note`` if it was not.
"""

from __future__ import annotations

import argparse
import csv
import json
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from pace import parts
from posing import tables
from posing.tables import Row

from generator.bundle import save
from generator.composition import compose
from generator.errors import TabletopError

HERE = Path(__file__).parent
FIELDS = ("part", "what", "setting", "value", "unit")
TEXT = (
    "a kitchen table with a mug, a bowl, an apple, a banana, a spoon, a plate, a bottle and a "
    "salt shaker"
)
"""The table of eight objects at which steps, pictures and vectors are timed."""


class Peer(NamedTuple):
    """An environment of another package: installation, construction, control period."""

    module: str
    name: str
    period: float
    pins: tuple[str, ...]


PEERS = (
    Peer(
        "gymnasium_robotics", "FetchPickAndPlace-v4", 0.04,
        ("gymnasium-robotics==1.4.2", "mujoco==3.3.7", "gymnasium[mujoco]==1.2.3"),
    ),
    Peer("panda_gym", "PandaPickAndPlace-v3", 0.04, ("panda-gym==3.0.7", "gymnasium==1.2.3")),
)  # fmt: skip
OURS = "TabletopGen/PickPlace-v0"
PERIOD = 0.05


def set_up(folder: Path) -> None:
    """Make each peer's virtual environment and install its pinned packages."""
    for peer in PEERS:
        at = folder / peer.module
        subprocess.run([sys.executable, "-m", "venv", str(at)], check=True)
        pip = [str(at / "bin" / "python"), "-m", "pip", "install", "--quiet", *peer.pins]
        subprocess.run(pip, check=True)


def episodes(python: str, module: str, name: str, steps: int, words: dict[str, Any]) -> Row:
    """Time one environment in a separate process; see ``pace/episodes.py``."""
    script = str(HERE / "pace" / "episodes.py")
    command = [python, script, module, name, str(steps), json.dumps(words)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=HERE.parent)
    return json.loads(done.stdout.splitlines()[-1])


def stepping(bundle: Path, venvs: Path, steps: int, rounds: int) -> list[Row]:
    """Time all environments in turn, ``rounds`` times; return medians."""
    runs: dict[str, tuple[float, Callable[[], Row]]] = {}
    for peer in PEERS:
        python = str(venvs / peer.module / "bin" / "python")
        runs[peer.name] = (
            peer.period,
            lambda p=peer, python=python: episodes(python, p.module, p.name, steps, {}),
        )
    for action in ("ee_delta", "joint_delta"):
        words = {"scenes": str(bundle), "action": action}
        runs[f"{OURS}, {action}"] = (
            PERIOD,
            lambda w=words: episodes(sys.executable, "tabletopgen_env", OURS, steps, w),
        )
    found: dict[str, list[Row]] = {name: [] for name in runs}
    for number in range(rounds):
        for name, (_, run) in runs.items():
            found[name].append(run())
            print(f"[round {number + 1}/{rounds}] {name}: {found[name][-1]}", flush=True)
    rows = []
    for name, (period, _) in runs.items():
        for kind in ("wall", "cpu"):
            rate = statistics.median(period / seen[kind] for seen in found[name])
            rows.append(row("stepping", name, kind, rate, "simulated s per s"))
        reset = 1e3 * statistics.median(seen["reset"] for seen in found[name])
        rows.append(row("stepping", name, "reset", reset, "ms"))
    return rows


def row(part: str, what: str, setting: str, value: float, unit: str) -> Row:
    return dict(zip(FIELDS, (part, what, setting, f"{value:.5g}", unit), strict=True))


def summary(rows: Sequence[Row], command: str, note: str) -> str:
    """Return the tables as Markdown, ratios first."""
    lines = [
        "# Speed",
        f"`{command}`, {tables.where()}{'; ' + note if note else ''}",
    ]
    steps = [r for r in rows if r["part"] == "stepping"]
    if steps:
        rate = {(r["what"], r["setting"]): float(r["value"]) for r in steps}
        names = list(dict.fromkeys(r["what"] for r in steps))
        fetch = PEERS[0].name
        lines += [
            "",
            f"Simulated seconds per second spent in `step`, as a ratio to {fetch} (one process, "
            f"random actions; ours: {OURS}, 8 objects, state observation). Resets are those of "
            "the first episodes: ours plan grasps at each object once.",
            "",
            "| environment | ratio, clock | ratio, CPU | per second, clock | per CPU second "
            "| reset, ms |",
            "|---|---|---|---|---|---|",
        ]
        for name in names:
            wall, cpu = rate[name, "wall"], rate[name, "cpu"]
            against = wall / rate[fetch, "wall"], cpu / rate[fetch, "cpu"]
            lines.append(
                f"| {name} | {against[0]:.2f} | {against[1]:.2f} | {wall:.1f} | {cpu:.1f} "
                f"| {rate[name, 'reset']:.3g} |"
            )
    others = [r for r in rows if r["part"] != "stepping"]
    if others:
        lines += ["", "| part | what | setting | value | unit |", "|---|---|---|---|---|"]
        lines += ["| " + " | ".join(str(r[f]) for f in FIELDS) + " |" for r in others]
    return "\n".join([*lines, ""])


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument(
        "--setup", action="store_true", help="make the others' virtual environments first"
    )
    p.add_argument(
        "--venvs", type=Path, default=Path(tempfile.gettempdir()) / "tabletopgen-speed",
        help="folder of the others' virtual environments",
    )  # fmt: skip
    p.add_argument(
        "--parts", nargs="+", default=["stepping", *parts.DEFAULT],
        choices=["stepping", *parts.PARTS], help="parts to measure",
    )  # fmt: skip
    p.add_argument("--steps", type=int, default=2000)
    p.add_argument("--rounds", type=int, default=3)
    p.add_argument("--resets", type=int, default=10_000, help="resets of the part memory")
    p.add_argument("--note", default="", help="a remark about the machine")
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    if args.setup:
        set_up(args.venvs)
    missing = [p.module for p in PEERS if not (args.venvs / p.module / "bin" / "python").exists()]
    if "stepping" in args.parts and missing:
        raise SystemExit(
            f"No virtual environments for {missing} below {args.venvs}. Run with --setup."
        )
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        try:
            scene = compose(TEXT, seed=0)
            bundle = save(scene, Path(folder))
            if "stepping" in args.parts:
                rows += stepping(bundle, args.venvs, args.steps, args.rounds)
            for name in args.parts:
                if name in parts.PARTS:
                    found = parts.PARTS[name](scene, args.resets)
                    rows += [row(name, *entry) for entry in found]
                    print(f"{name}: {found}", flush=True)
        except TabletopError as error:
            raise SystemExit(str(error)) from error
    args.out.mkdir(parents=True, exist_ok=True)
    stem = "speed" if "stepping" in args.parts else "speed_" + "_".join(args.parts)
    with (args.out / f"{stem}.csv").open("w", newline="", encoding="utf-8") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)
    text = summary(rows, tables.command_line("--note", "--venvs", "--out"), args.note)
    (args.out / f"{stem}.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
