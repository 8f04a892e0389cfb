"""Record the package's outputs, and compare two records: a refactoring changes no byte.

    python benchmarks/golden.py record before --pictures photos/*.png
    python benchmarks/golden.py compare before after

A record has bundles composed and generated from texts and pictures, edited, imported, and made in a
batch; exports in every format; a static page; digests of observations and rewards of environments
under seeded actions; and a policy cloned for one round. Everything uses the commands and
Gymnasium's ids, so that the same script records before and after modules move. Existing parts are
not recorded again. ``compare`` ignores backend names and package versions in a bundle's provenance,
the scripts in exports, and the page's own code. It prints every other difference, and exits with 1
if there is one.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import subprocess
import sys
import zipfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
COMMAND = (sys.executable, "-m", "generator")
DIGEST = re.compile(r"-[0-9a-f]{12}$")
COMPOSED, GENERATED, BATCHED = 20, 8, 6
EDITS = (
    ("add", "office-desk", "add", "a red mug left of the laptop"),
    ("move", "office-desk", "move", "stapler_1", "behind the notebook"),
    ("swap", "dining-fruit", "swap", "vase_1", "a teapot"),
)
SCENES = ("office-desk", "kitchen-cutting", "workbench", "dining-fruit")
MODES = ("state", "goal", "pixels", "pixels+state", "point_cloud", "point_cloud+state")
STEPS = 200
FORMATS = ("mjcf", "urdf", "sdf", "glb", "usd", "usdz")
IMPORTED = ("{0}-mjcf/scene.xml", "{0}.glb")
"""Exports of a scene that are imported again."""
PARTS = (
    "environments", "cloning", "compose", "generate", "edits", "batch",
    "exports", "imports", "page",
)  # fmt: skip
CODE = (".py", ".js", ".css", ".wasm", ".html", ".md", ".map")
"""Files of exports and pages that belong to the program."""
DATA = (".obj", ".png", ".safetensors", ".xml")
"""Recorded files of bundles and trainings."""
CLONING = (
    "cloning.rounds=1", "cloning.episodes=6", "cloning.steps=60", "cloning.last_steps=60",
)  # fmt: skip
FREE = ("backends", "versions", "edits")
"""Ignored parts of a provenance: module names and digests."""


def texts() -> list[str]:
    """Return the texts of ``texts.json``, spread over its themes."""
    content = [entry["text"] for entry in json.loads((HERE / "texts.json").read_text())]
    return [content[k * len(content) // COMPOSED] for k in range(COMPOSED)]


def run(*arguments: str) -> None:
    """Run a command; its output is shown if it fails."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    done = subprocess.run(arguments, capture_output=True, text=True, env=environment)
    if done.returncode:
        print(f"{' '.join(arguments)} ended with {done.returncode}:\n{done.stderr}", flush=True)


def bundle_jobs(
    out: Path, parts: Sequence[str], pictures: Sequence[str], maximum: int
) -> Iterator[tuple[Path, tuple[str, ...]]]:
    """Yield the bundle folders of ``out``, each with the command that makes its bundles."""
    for number, text in enumerate(texts()[:maximum] if "compose" in parts else ()):
        place = out / "compose" / f"{number:02}"
        yield place, (*COMMAND, "compose", text, "--seed", str(number), "--out", str(place))
    for number, text in enumerate(
        texts()[1::2][:GENERATED][:maximum] if "generate" in parts else ()
    ):
        place = out / "generate" / f"{number:02}"
        yield place, (*COMMAND, "generate", text, "--seed", str(number), "--out", str(place))
    for picture in pictures[:maximum]:
        place = out / "pictures" / Path(picture).stem
        yield place, (*COMMAND, "generate", picture, "--out", str(place))
    for name, bundle, *change in EDITS[:maximum] if "edits" in parts else ():
        place = out / "edits" / name
        yield place, (*COMMAND, "edit", bundle, *change, "--out", str(place))
    if "page" in parts:
        place = out / "page"
        yield place, (*COMMAND, "page", *SCENES[:2][:maximum], "--out", str(place))
    if "batch" in parts:
        place, prompts = out / "batch", out / "prompts.txt"
        prompts.write_text("\n".join(texts()[:BATCHED][:maximum]))
        yield place, (*COMMAND, "batch", str(prompts), "--route", "compose", "--out", str(place))


def record_bundles(jobs: Iterable[tuple[Path, tuple[str, ...]]], workers: int) -> None:
    """Make the missing bundles."""

    def make(job: tuple[Path, tuple[str, ...]]) -> None:
        place, command = job
        if not place.exists():
            run(*command)
            print(place, flush=True)

    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(make, jobs))


def record_exports(out: Path, parts: Sequence[str], maximum: int) -> None:
    """Export scenes in every format, and import some of the files again."""
    exports = out / "exports"
    for scene in SCENES[:maximum] if "exports" in parts else ():
        if not list(exports.glob(f"{scene}-*.usdz")):
            run(*COMMAND, "export", scene, "--to", *FORMATS, "--out", str(exports))
            print(exports, scene, flush=True)
    for scene in SCENES[:maximum] if "imports" in parts else ():
        for number, pattern in enumerate(IMPORTED):
            place = out / "imports" / f"{scene}-{number}"
            for source in exports.glob(pattern.format(f"{scene}-" + 12 * "[0-9a-f]")):
                if not place.exists():
                    options = ("--allow-failed", "--name", scene, "--out", str(place))
                    run(*COMMAND, "import", str(source), *options)
                    print(place, flush=True)


def record_environments(out: Path, modes: Sequence[str], scenes: Sequence[str], steps: int) -> None:
    """Write digests of the observations and rewards of environments."""
    import gymnasium as gym
    import numpy as np

    import tabletopgen_env  # noqa: F401

    found = json.loads(out.read_text()) if out.exists() else {}
    for mode in modes:
        for scene in scenes:
            key = f"{mode} {scene}"
            if key in found:
                continue
            task = "PickPlace" if mode == "goal" else "Lift"
            env = gym.make(
                f"TabletopGen/{task}-v0", scenes=scene, observation=mode, randomization="starts"
            )
            rng = np.random.default_rng(0)
            digest, rewards = hashlib.sha256(), []
            observation, info = env.reset(seed=0)
            for _ in range(steps):
                _add(digest, observation)
                action = rng.uniform(-1, 1, env.action_space.shape).astype(np.float32)
                observation, reward, terminated, truncated, info = env.step(action)
                rewards.append(float(reward))
                if terminated or truncated:
                    observation, info = env.reset()
            _add(digest, observation)
            env.close()
            found[key] = {
                "observations": digest.hexdigest(), "rewards": rewards,
                "instruction": info["instruction"],
            }  # fmt: skip
            out.write_text(json.dumps(found, indent=1))
            print(key, flush=True)


def _add(digest: Any, value: Any) -> None:
    import numpy as np

    if isinstance(value, Mapping):
        for key in sorted(value):
            digest.update(key.encode())
            _add(digest, value[key])
    else:
        array = np.ascontiguousarray(value)
        digest.update(f"{array.dtype.str}{array.shape}".encode() + array.tobytes())


def record_cloning(out: Path) -> None:
    """Clone the expert for one round."""
    if out.exists():
        return
    run(
        sys.executable, "-m", "tabletopgen_env", "train", "lift-clone-planned",
        "--scenes", *SCENES[:2], "--held-out", SCENES[2], "--out", str(out), "--episodes", "2",
        "--set", *CLONING,
    )  # fmt: skip
    print(out, flush=True)


def facts(record: Path) -> dict[str, Any]:
    """Return the content of a record: a digest of each file, values of each JSON file."""
    found: dict[str, Any] = {}
    for path in sorted(p for p in record.rglob("*") if p.is_file()):
        place = Path(*(DIGEST.sub("", part) for part in path.relative_to(record).parts))
        foreign = place.parts[0] in ("exports", "page")
        if path.name == "scene.json":
            found |= {f"{place}:{k}": v for k, v in _scene(path).items()}
        elif path.name == "environments.json":
            content = json.loads(path.read_text())
            found |= {f"{place}:{a}:{b}": v for a in content for b, v in content[a].items()}
        elif foreign and path.suffix == ".zip":
            found |= {f"{place}:{name}": digest for name, digest in _archive_digests(path)}
        elif path.suffix in CODE or (not foreign and path.suffix not in DATA):
            continue
        else:
            found[str(place)] = hashlib.sha256(path.read_bytes()).hexdigest()
    return found


def _archive_digests(path: Path) -> Iterator[tuple[str, str]]:
    """Yield the digests of the files in an archive."""
    with zipfile.ZipFile(path) as archive:
        for name in sorted(archive.namelist()):
            if Path(name).suffix not in CODE and Path(name).name != "scene.json":
                yield name, hashlib.sha256(archive.read(name)).hexdigest()


def _scene(path: Path) -> dict[str, Any]:
    content = json.loads(path.read_text())
    content.pop("files")
    content["provenance"] = {k: v for k, v in content["provenance"].items() if k not in FREE}
    return content


def compare(one: Path, other: Path) -> int:
    """Print the differences between two records; return their number."""
    before, after = facts(one), facts(other)
    differing = [key for key in sorted(before | after) if before.get(key) != after.get(key)]
    for key in differing:
        what = (
            "changed" if key in before and key in after else ("missing" if key in before else "new")
        )
        print(f"{what}: {key}")
    print(f"{len(before)} facts, {len(differing)} differ")
    return len(differing) + (not before)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    commands = parser.add_subparsers(dest="command", required=True)
    recording = commands.add_parser("record")
    recording.add_argument("out", type=Path)
    recording.add_argument(
        "--pictures", nargs="*", type=Path, default=[], help="pictures to generate from"
    )
    recording.add_argument("--parts", nargs="*", choices=PARTS, default=PARTS)
    recording.add_argument("--most", type=int, default=100, help="scenes, modes, ... of each part")
    recording.add_argument("--steps", type=int, default=STEPS, help="steps per environment")
    recording.add_argument("--workers", type=int, default=2)
    comparing = commands.add_parser("compare")
    comparing.add_argument("one", type=Path)
    comparing.add_argument("other", type=Path)
    args = parser.parse_args()
    if args.command == "compare":
        return int(compare(args.one, args.other) > 0)
    args.out.mkdir(parents=True, exist_ok=True)
    if "environments" in args.parts:
        record_environments(
            args.out / "environments.json", MODES[: args.most], SCENES[: args.most], args.steps
        )
    if "cloning" in args.parts:
        record_cloning(args.out / "cloning")
    pictures = sorted(map(str, args.pictures))
    record_bundles(bundle_jobs(args.out, args.parts, pictures, args.most), args.workers)
    record_exports(args.out, args.parts, args.most)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
