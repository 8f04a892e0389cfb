"""Jobs that create a file from a scene: episodes and exports."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from generator.io.files import make_private, write_whole

from ...page.scene_folder import archive
from ..page_parts import play_episode
from ..specs import EpisodeSpec, ExportSpec
from .order import JobOrder, Telling


def record(spec: EpisodeSpec, order: JobOrder, telling: Telling) -> dict[str, Any]:
    """Run a job of the kind "episode"."""
    telling.stage("playing", 1, 1)
    played = play_episode(order.start, spec.task, spec.seed)
    facts = {"success": played.success, "steps": len(played.rows) - 1, "task": spec.task}
    return _keep(order, f"{spec.task.lower()}-{spec.seed}.bin", played.to_bytes(), facts)


def export_scene(spec: ExportSpec, order: JobOrder, telling: Telling) -> dict[str, Any]:
    """Run a job of the kind "export"; the result is a file, or a zip archive of a folder."""
    from generator.bundle import load
    from generator.exports import export

    telling.stage("exporting", 1, 1)
    scene = load(order.start)
    make_private(order.files)
    with tempfile.TemporaryDirectory(dir=order.files, prefix=".export-") as folder:
        made = export(scene, spec.format, folder, order.start.name)
        if made.is_file():
            return _keep(order, made.name, made.read_bytes(), {})
        return _keep(order, f"{made.name}.zip", _pack(made), {})


def _pack(folder: Path) -> bytes:
    paths = sorted(p for p in folder.rglob("*") if p.is_file())
    held = {p.relative_to(folder).as_posix(): p.read_bytes() for p in paths}
    return archive(folder.name, held)


def _keep(order: JobOrder, name: str, content: bytes, facts: dict[str, Any]) -> dict[str, Any]:
    make_private(order.files)
    write_whole(order.files / name, content, "The file", "Free disk space.")
    return {"file": name, "bytes": len(content), "facts": facts}
