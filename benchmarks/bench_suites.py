"""Make the suites of TabletopBench: draw tables, certify them with the expert, write the files.

    nice python benchmarks/bench_suites.py                      # all tasks, resumes
    python benchmarks/bench_suites.py --task Lift --workers 2

For each task, tables with the objects it needs (``Task.needs``) are drawn on the held-out side of
the split of "fresh" tables, with seeds that "fresh" never draws. They are selected by difficulty,
in three levels, if the expert solves an instance from each of 30 starts. Tables and certificates
are stored in ``--work``, where a second run resumes; the file of a task is written once its tables
are complete. A version with published results is never regenerated: increment ``VERSION`` in
``tabletopgen_env/bench/suites.py``.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from types import MappingProxyType

from generator.language.distribution import SceneDistribution
from generator.scene.provenance import versions
from tabletopgen_env import STEPS
from tabletopgen_env.actions import CONTROL_HZ
from tabletopgen_env.bench.instances import SuiteLevel, TaskSuites
from tabletopgen_env.bench.suite_drafts import FIRST, Quota, draft
from tabletopgen_env.bench.suites import PLACE, VERSION, write_suites
from tabletopgen_env.certificates.certificate import STARTS, Terms
from tabletopgen_env.episodes import HOLD
from tabletopgen_env.randomization import Randomization
from tabletopgen_env.randomization.settings import PRESETS
from tabletopgen_env.scenes.splits import SHARE
from tabletopgen_env.tasks.names import NAMES
from tabletopgen_env.tasks.registry import task_named

HERE = Path(__file__).parent

LEVELS = (
    SuiteLevel("easy", 0.0, 0.3),
    SuiteLevel("medium", 0.3, 0.35),
    SuiteLevel("hard", 0.35, 1.0),
)
"""Edges of the levels, between the curriculum's bins, with similar numbers of drawn tables."""

TRAINING = 1_000_000
"""Seeds below this are those of ``scenes="fresh"``."""

INSTANCES = MappingProxyType({"Swap": 1, "Sequence": 1, "Tidy": 1})
"""Instances per table; 2 for tasks whose episodes take the expert minutes."""

DRAWN = MappingProxyType({"Reach": 4, "Sequence": 2})
"""Episodes per instance without randomisation; 1 if all would start alike."""

RANDOM = 6
"""Episodes per instance with randomisation."""


def randomization() -> Randomization:
    """Return the suites' randomisation: certified starts, small changes of looks and dynamics."""
    light, starts = PRESETS["light"], PRESETS["starts"]
    return Randomization(
        light_turn=light.light_turn, light_color=light.light_color, ambient=light.ambient,
        camera_move=light.camera_move, camera_turn=light.camera_turn, camera_fov=light.camera_fov,
        tint=light.tint, mass=light.mass, friction=light.friction, stiffness=light.stiffness,
        damping=light.damping, joint_noise=light.joint_noise, position_noise=light.position_noise,
        rotation_noise=light.rotation_noise, start_joints=starts.start_joints,
        start_move=starts.start_move, start_turn=round(starts.start_turn, 6),
    )  # fmt: skip


def blank(task: str, episodes: int) -> TaskSuites:
    """Return the suites of a task without tables; ``episodes`` is the number in a certificate."""
    return TaskSuites(
        version=VERSION, task=task, control_hz=CONTROL_HZ, time_limit=STEPS[task], hold=HOLD,
        randomization=randomization(), episodes={"plain": DRAWN.get(task, 1), "random": RANDOM},
        distribution=SceneDistribution(needs=task_named(task).needs), levels=LEVELS,
        training=TRAINING, share=SHARE, terms=Terms((task,), episodes, INSTANCES.get(task, 2)),
        versions=versions(), tables=(),
    )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--task", action="append", choices=NAMES, help="one task; may be repeated")
    parser.add_argument("--test", type=int, default=4, help="test tables per level")
    parser.add_argument("--validation", type=int, default=1, help="validation tables per level")
    parser.add_argument("--episodes", type=int, default=STARTS, help="starts per certificate")
    parser.add_argument("--first", type=int, default=FIRST, help="seed of the first table")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--work", type=Path, default=HERE.parent / "out" / "bench")
    parser.add_argument("--out", type=Path, default=PLACE / VERSION)
    args = parser.parse_args()
    quota = Quota(args.test, args.validation, args.first)
    args.out.mkdir(parents=True, exist_ok=True)
    for task in args.task or NAMES:
        suites = draft(
            blank(task, args.episodes), args.work, quota, args.workers,
            lambda line: print(line, flush=True),
        )  # fmt: skip
        write_suites(suites, args.out / f"{task.lower()}.json")
        print(f"{task}: {len(suites.tables)} tables", flush=True)


if __name__ == "__main__":
    main()
