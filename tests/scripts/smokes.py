"""The test run of each script in ``benchmarks/``, ``docs/`` and ``examples/``.

A new script needs an entry in ``SMOKES``: the least work that its own options allow, and what it
leaves. It runs in an empty folder, its ``{out}``; nothing else may change.
"""

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from shutil import copy
from types import MappingProxyType

from drawn_shard import write_shard
from extent import EXHAUSTIVE
from taken_picture import take_picture

from generator.method.reference import read_image

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Smoke:
    """One short run of a script.

    Attributes:
        arguments: as a shell takes them; ``{out}`` is the run's own folder, ``{root}`` the
            repository.
        leaves: globs below that folder; each has to match a file that is not empty, and
            no row of a table may have an error.
        prints: text that has to be in what it prints.
        prepare: puts into the folder what the run needs.
        codes: exit codes that are no failure: 1 of a script whose figure missed its mark.
        needs: a package without which it cannot run; the test is then skipped.
        program: likewise a program.
        long: whether only `make test-all` runs it; `make test` prints its help.
    """

    arguments: str = ""
    leaves: Sequence[str] = ()
    prints: str = ""
    prepare: Callable[[Path], None] | None = None
    codes: Sequence[int] = (0,)
    needs: str = ""
    program: str = ""
    long: bool = False


def _texts(folder: Path) -> None:
    (folder / "texts.json").write_text('["A die."]', encoding="utf-8")


def _recipe(folder: Path) -> None:
    (folder / "tiny.toml").write_text(
        """
        task = "Reach"
        algorithm = "clone"
        scenes = "coffee-square"
        held_out = "lab"
        network = { layers = [8] }
        cloning = { rounds = 1, episodes = 1, steps = 2, last_steps = 2 }
        """,
        encoding="utf-8",
    )


def _sheets(folder: Path) -> None:
    picture = (ROOT / "examples/pictures/coffee_table.png").read_bytes()
    for name in ("before", "after"):
        (folder / name).mkdir()
        (folder / name / "table.png").write_bytes(picture)


def _trace(folder: Path) -> None:
    picture = ROOT / "examples" / "pictures" / "coffee_table.png"
    corners = [[300, 300], [380, 300], [380, 400], [300, 400]]
    record = {
        "picture": picture.name,
        "sha256": hashlib.sha256(picture.read_bytes()).hexdigest(),
        "size": read_image(picture).shape[1::-1],
        "things": [{"name": "mug", "mask": [{"outer": corners}], "pose": "standing"}],
    }
    (folder / "coffee_table.json").write_text(json.dumps(record), encoding="utf-8")


def _picture(folder: Path) -> None:
    """Take the shipped picture in an exhaustive run, else one of a single thing."""
    if EXHAUSTIVE:
        copy(ROOT / "examples/pictures/coffee_table.png", folder / "picture.png")
    else:
        take_picture(folder / "picture.png")


def _played(folder: Path) -> None:
    """Give the leaderboard a result of a test suite, which takes long to play."""
    (folder / "bench").mkdir()
    copy(ROOT / "benchmarks/results/bench/reach-test_expert.json", folder / "bench")


def _table(stem: str) -> tuple[str, str]:
    return f"{stem}.csv", f"{stem}.md"


SMOKES: Mapping[str, Smoke] = MappingProxyType({
    "benchmarks/ablation.py": Smoke(
        "--cases 1 --text 'a bowl' --sheet 0 --out {out} --pictures {out}/pictures",
        (*_table("ablation_dev_a_bowl"), "ablation_dev_a_bowl.png", "pictures/*/000.png"),
        long=True,
    ),
    "benchmarks/baselines.py": Smoke(
        "--recipe {out}/tiny.toml --recipe rule-lift --seeds 0 --episodes 1 --validation 1 "
        "--runs {out}/runs --out {out}",
        (*_table("baselines"), "baselines.png", "runs/tiny-0/policy.safetensors"),
        prepare=_recipe,
    ),
    "benchmarks/bench.py": Smoke(
        "--player expert --suite reach-validation --tables {out}/tables --out {out}",
        ("bench/reach-validation_expert.json", "leaderboard.md"), prepare=_played,
    ),
    "benchmarks/bench_suites.py": Smoke(
        "--task Reach --test 0 --validation 1 --work {out}/work --out {out}",
        ("reach.json",),
    ),
    "benchmarks/batch.py": Smoke(
        "--texts {out}/texts.json --cases 1 --route compose --out {out}",
        ("batch_compose.md",), prepare=_texts,
    ),
    "benchmarks/catalogue_digests.py": Smoke(
        "record {out}/digests.json --workers 1 --only mug knife", ("digests.json",)
    ),
    "benchmarks/certificates.py": Smoke(
        "--bundles coffee-square --starts 1 --out {out}", _table("certificates"), codes=(0, 1)
    ),
    "benchmarks/cluster.py": Smoke(
        "--episodes 1 --scenes 3 --out {out}", ("cluster.md",), "| scene bank, 3 fresh tables | 2 ",
        long=True,
    ),
    "benchmarks/compose_speed.py": Smoke(
        "--texts {out}/texts.json --beside {root} --out {out}", ("compose_speed.md",),
        "| import |", _texts,
    ),
    "benchmarks/pages.py": Smoke(
        "--scenes coffee-oval --rounds 1 --out {out}",
        ("pages.md",),
        "| coffee-oval | 4 |",
        program="chromium",
        long=True,
    ),
    "benchmarks/parity.py": Smoke(
        "--bundles vanity --engines MuJoCo --out {out}", _table("parity"), "| vanity | 4 |"
    ),
    "benchmarks/concurrency.py": Smoke("--seconds 2 --out {out}", ("concurrency.md",)),
    "benchmarks/curriculum.py": Smoke(
        "--recipe reach-clone --set cloning.rounds=1 cloning.episodes=1 cloning.last_steps=5 "
        "--variants 12 --seeds 0 --episodes 1 --out {out}",
        _table("curriculum"),
        long=True,
    ),
    "benchmarks/drawn_names.py": Smoke(
        "--texts {out}/texts.json --first 0 --out {out}",
        ("drawn_names.md",),
        "| texts, visible objects | 1, 1 |",
        _texts,
    ),
    "benchmarks/efficiency.py": Smoke(
        "--cases 1 --out {out}", (*_table("efficiency_cpu"), "efficiency_cpu.png"),
        "1 texts of 6 to 9 objects", long=True,
    ),
    "benchmarks/end_to_end.py": Smoke(
        "--texts {out}/texts.json --seeds 1 --out {out}", _table("generate"), prepare=_texts,
        long=True,
    ),
    "benchmarks/expert.py": Smoke(
        "--scenes coffee-square --task Reach --episodes 1 --out {out}",
        _table("expert_coffee-square"),
    ),
    "benchmarks/eye.py": Smoke(
        "--data {out}/data --out {out}", ("eye.md",),
        prepare=lambda out: write_shard(out / "data" / "eval.shard"),
    ),
    "benchmarks/fresh_tables.py": Smoke(
        "--task Tidy --count 1 --out {out}", _table("fresh_tables")
    ),
    "benchmarks/fuzz.py": Smoke("--kind glb --cases 5 --out {out}", ("fuzz.md",)),
    "benchmarks/golden.py": Smoke(
        "record {out}/a --parts environments compose --most 1 --steps 3",
        ("a/environments.json", "a/compose/00/*/scene.json"),
    ),
    "benchmarks/grasps.py": Smoke(
        "--bundles coffee-square --most 2 --count 8 --trials 2 --each 1 --out {out}",
        _table("grasps"),
    ),
    "benchmarks/modeler.py": Smoke(
        "--cases 1 --only mug --pictures {out}", ("000_mug.png",), "| label withheld | 1 |"
    ),
    "benchmarks/pace/episodes.py": Smoke("gymnasium CartPole-v1 50", prints='"wall": '),
    "benchmarks/parallel.py": Smoke(
        "--delay 0.01 --out {out}", ("parallel.md",), codes=(0, 1),
        long=True,
    ),
    "benchmarks/pictures.py": Smoke(
        "{root}/examples/pictures --out {out}", (*_table("pictures"), "coffee_table.png"),
        "| coffee_table | - | 5 | ", long=True,
    ),
    "benchmarks/pose.py": Smoke(
        "single --cases 1 --only mug --out {out}",
        (*_table("pose_single_dev_mug"), "pose_single_dev_mug.png"),
        long=True,
    ),
    "benchmarks/recording.py": Smoke(
        "--task Reach --scenes coffee-square --episodes 1 --rounds 1 --cameras front "
        "--image-size 16 --out {out}",
        ("recording.md",), "| lerobot, h264 | ", codes=(0, 1),
        long=True,
    ),
    "benchmarks/rotation_speed.py": Smoke(
        "--cases 1 --out {out}", ("rotation_speed_cpu.md",), "| wall | 1 |",
        long=True,
    ),
    "benchmarks/side_by_side.py": Smoke(
        "{out}/before {out}/after --out {out}/both", ("both/table.jpg",), "1 sheets in", _sheets
    ),
    "benchmarks/soak.py": Smoke(
        "--steps 20 --scenes 1 --out {out}", _table("soak"), "# Soak: 20 random steps at 1 tables"
    ),
    "benchmarks/soundness.py": Smoke(
        "--texts {out}/texts.json --seeds 1 --out {out}",
        _table("soundness_compose"), "| published | 1 / 1 |", _texts,
    ),
    "benchmarks/speed.py": Smoke(
        "--parts vector pixels resets --out {out}",
        _table("speed_vector_pixels_resets"), "| vector | steps | 8 slots, 2 threads |",
        long=True,
    ),
    "benchmarks/two_environments.py": Smoke(
        "--episodes 2 --worlds 2 --scenes vanity --out {out}", _table("two_environments"),
        "| reach-clone | Reach | 2 | 1 |",
        long=True,
    ),
    "benchmarks/worlds.py": Smoke(
        "--device cpu --worlds 2 --steps 2 --scenes vanity --out {out}", ("worlds_cpu.md",),
        "| 2 | 1 |",
    ),
    "benchmarks/supports.py": Smoke(
        "--texts {out}/texts.json --scenes 1 --out {out}", _table("supports"),
        "| scenes in which all hold | ", _texts,
    ),
    "benchmarks/traced.py": Smoke(
        "{root}/examples/pictures --traces {out} --out {out}",
        ("traced_embedded.md", "coffee_table.png"), "| **all** | 1 |", _trace,
        long=True,
    ),
    "benchmarks/understanding.py": Smoke(
        "--theme terse --limit 1 --sheet 1 --bundles {out}/made --out {out}",
        (*_table("understanding_compose_dev_terse"), "understanding_compose.png", "made/*.json"),
        "| fully correct | ",
        long=True,
    ),
    "docs/make_page_pictures.py": Smoke(
        "page_gallery studio_make --scenes coffee-square --out {out}",
        ("page_gallery.png", "studio_make.png"),
        program="chromium",
    ),
    "docs/make_object_sheets.py": Smoke(
        "pets --workers 1 --out {out}", ("images/objects/pets.webp", "reference/objects.md")
    ),
    "docs/make_task_pictures.py": Smoke("reach --out {out}", ("reach.png",)),
    "examples/demo.py": Smoke(
        "--only text --text 'a die' --out {out}",
        ("report.md", "text.png", "text_panda.png", "scenes/*/scene.json", "text/*.png"),
    ),
    "examples/expert.py": Smoke(
        "--episodes 1 --scenes coffee-square --out {out}/strip.png", ("strip.png",), " of 1; film"
    ),
    "examples/image_to_scene.py": Smoke(
        "{out}/picture.png --out {out}", ("side_by_side.png", "*/scene.json"), "bundle:",
        _picture,
    ),
    "examples/own_backend.py": Smoke(
        "", ("out/own_backend/*/scene.json",), "answered by: "
    ),
    "examples/random_agent.py": Smoke("", prints="return "),
    "examples/readme_pictures.py": Smoke(
        "starters expert --out {out}", ("starters.png", "expert.png")
    ),
    "examples/rllib.py": Smoke(
        "--iterations 1 --steps 128 --scenes coffee-square --out {out}/algorithm",
        ("algorithm/*.pkl",), "iteration 1: return ", needs="ray.rllib",
    ),
    "examples/text_to_scene.py": Smoke(
        "'a die' --out {out}", ("figures/*.png", "*/scene.json"), "bundle:"
    ),
    "examples/train_lift.py": Smoke("1 1 2", ("out/lift.zip",)),
})  # fmt: skip
"""The run of each script, by its path from the repository's root."""
