"""What the studio takes from the pages' package: a scene as the viewer loads it, and an episode."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from generator.bundle.bounds import BOUNDS


@dataclass(frozen=True)
class PlayedEpisode:
    """An episode as the viewer plays it back, and what is told of it beside."""

    content: bytes
    success: bool
    steps: int


def write_view(bundle: Path, folder: Path) -> None:
    """Write a bundle into an empty folder as the viewer loads it: ``view.json`` and its files.

    Raises:
        BundleError: the bundle is damaged.
        OSError: the disk refuses.
    """
    from generator.bundle import load, read_inside
    from generator.bundle.folder import read_truth

    load(bundle)
    for name in (*read_truth(bundle)["files"], "scene.json"):
        target = folder / "bundle" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(read_inside(bundle, name, BOUNDS.file_bytes))
    files = sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file())
    sizes = {name: (folder / name).stat().st_size for name in files}
    view = {"schema": 1, "id": bundle.name, "files": sizes}
    (folder / "view.json").write_text(json.dumps(view), encoding="utf-8")


def play_episode(bundle: Path, task: str, seed: int) -> PlayedEpisode:
    """Have the scripted expert play one episode of a task at a scene.

    Raises:
        SceneError: the scene offers nothing to do, or the expert knows no way.
    """
    import gymnasium as gym

    from generator.errors import SceneError
    from tabletopgen_env.learning.demonstrations.recorded import demonstrate

    env = gym.make(f"tabletopgen_env:TabletopGen/{task}-v0", scenes=str(bundle))
    infos: list[dict[str, Any]] = []
    try:
        played = demonstrate(env, seed, report=infos.append)
    finally:
        env.close()
    if played is None:
        raise SceneError(
            f"The expert knows no way to do {task} at {bundle.name} with seed {seed}. Try another "
            "seed or task."
        )
    success = bool(infos[-1].get("success"))
    facts = {
        "schema": 1, "task": task, "seed": seed, "success": success,
        "instruction": infos[0].get("instruction"),
        "actions": [[float(v) for v in row] for row in played.actions],
    }  # fmt: skip
    return PlayedEpisode(json.dumps(facts).encode(), success, len(played.actions))
