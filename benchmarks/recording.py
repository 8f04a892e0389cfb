"""Recording: the cost of writing a dataset relative to playing the same episodes.

    python benchmarks/recording.py --episodes 10 --rounds 3
    python benchmarks/recording.py --episodes 10 --image-size 256 --kinds rgb depth

In each round the episodes are played without recording, then recorded in every format, each time in
a new environment and in this process alone. Times are CPU seconds of the process; the ratio is the
median over rounds of a recording to the plain run of its round, with a goal of at most 2.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from itertools import islice
from pathlib import Path
from statistics import median
from typing import NamedTuple, get_args

from posing import tables

from generator.errors import SceneError
from tabletopgen_env.recording import LeRobotConfig, RecordConfig, record
from tabletopgen_env.recording.config import Format
from tabletopgen_env.recording.episodes import play_episodes
from tabletopgen_env.rendering.config import CameraName
from tabletopgen_env.rendering.kinds import Kind

HERE = Path(__file__).parent
AIM = 2.0


class Way(NamedTuple):
    """A format, and the storage of pictures in a LeRobot dataset."""

    format: Format
    lerobot: LeRobotConfig = LeRobotConfig()

    @property
    def name(self) -> str:
        """Name in the table."""
        return f"lerobot, {self.lerobot.video}" if self.format == "lerobot" else self.format


WAYS = (
    Way("lerobot", LeRobotConfig("h264")), Way("lerobot", LeRobotConfig("hevc")),
    Way("lerobot", LeRobotConfig("av1")), Way("lerobot", LeRobotConfig("none")),
    Way("robomimic"), Way("hdf5"), Way("npz"), Way("minari"),
)  # fmt: skip


def parser() -> argparse.ArgumentParser:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--task", default="Lift")
    p.add_argument("--scenes", nargs="*", default=["office-round-*"])
    p.add_argument("--episodes", type=int, default=10)
    p.add_argument("--rounds", type=int, default=3)
    p.add_argument("--cameras", nargs="+", default=["front", "wrist"], choices=get_args(CameraName))
    p.add_argument("--kinds", nargs="+", default=["rgb"], choices=get_args(Kind))
    p.add_argument("--image-size", type=int, default=128)
    p.add_argument("--out", type=Path, default=HERE / "results")
    return p


def play(config: RecordConfig) -> int:
    """Play the episodes of a recording without storing them; return their steps."""
    env = config.environment()
    with closing(env), closing(play_episodes(config, env, 1)) as episodes:
        kept = (e for e in episodes if not isinstance(e, SceneError))
        return sum(len(e.rewards) for e in islice(kept, config.episodes))


def seconds(work: Callable[[], object]) -> float:
    """Return the CPU seconds of a call."""
    begun = time.process_time()
    work()
    return time.process_time() - begun


def size(path: Path) -> int:
    """Return the bytes of a file, or of all files in a folder."""
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(file.stat().st_size for file in files if file.is_file())


def main() -> int:
    given = parser().parse_args()
    config = RecordConfig(
        given.task, scenes=tuple(given.scenes), episodes=given.episodes,
        cameras=tuple(given.cameras), kinds=tuple(given.kinds), image_size=given.image_size,
    )  # fmt: skip
    steps = play(config)  # warm-up of imports and caches, as for the formats
    for way in WAYS:
        with tempfile.TemporaryDirectory() as folder:
            write(replace(config, episodes=1), Path(folder) / "set-v0", way)
    plain: list[float] = []
    took: dict[Way, list[float]] = {way: [] for way in WAYS}
    bytes_of: dict[Way, int] = {}
    for number in range(given.rounds):
        plain.append(seconds(lambda: play(config)))
        for way in WAYS:
            with tempfile.TemporaryDirectory() as folder:
                out = Path(folder) / "set-v0"
                took[way].append(seconds(lambda w=way, o=out: write(config, o, w)))
                bytes_of[way] = size(out)
        print(f"[{number + 1}/{given.rounds}] played in {plain[-1]:.1f} CPU s", flush=True)
    ratios = {way: median(t / p for t, p in zip(took[way], plain, strict=True)) for way in WAYS}
    lines = [
        f"`{tables.command_line('--out')}`, {tables.where()}. {given.episodes} episodes of "
        f"{given.task}, {steps} steps, {len(given.cameras)} cameras of {given.image_size} pixels "
        f"({', '.join(given.kinds)}): played without recording in {median(plain):.1f} CPU s "
        f"(median of {given.rounds} rounds). The goal is a ratio of at most {AIM:g}.",
        "",
        "| format | CPU s | ratio to playing | kB per step |",
        "|---|---|---|---|",
        *(
            f"| {way.name} | {median(took[way]):.1f} | {ratios[way]:.2f} | "
            f"{bytes_of[way] / steps / 1000:.1f} |"
            for way in WAYS
        ),
    ]
    text = "\n".join(lines) + "\n"
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "recording.md").write_text(text, encoding="utf-8")
    print(text)
    return int(max(ratios.values()) > AIM)


def write(config: RecordConfig, out: Path, way: Way) -> Path:
    """Record in a format."""
    return record(config, out, way.format, lerobot=way.lerobot)


if __name__ == "__main__":
    sys.exit(main())
