"""A scene's folder in a page: the bundle's data, the robot's model, episodes and downloads.

``view.json`` lists the files (``SceneFiles`` in ``web/src/data.ts``). The studio serves such
folders, too.
"""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from generator.bundle import read_files
from generator.errors import SceneError, TabletopError
from generator.exports import ALONE, WRITERS
from generator.exports.bodies import scene_world
from generator.scene import Scene
from generator.scene.provenance import plain

from .episodes import PlayRow, record_play
from .options import FolderOptions
from .robot import START, robot_document
from .rows import SCHEMA, SceneRow, read_whole_row

VIEW = "view.json"
"""The file that lists the others in a scene's folder."""

THUMBNAIL = "thumbnail.jpg"

SHOWN = ("PickPlace", "Stack", "Tidy", "Swap", "Sequence", "Lift", "Push", "Reach")
"""Tasks with episodes, in order of preference."""

_LABELS = {
    "MJCF with separate mesh files": "MJCF, every mesh a file",
    "urdf": "URDF",
    "sdf": "SDF",
    "glb": "glTF (GLB)",
    "usd": "USD",
    "usdz": "USDZ",
}
_DRAWN = ("meshes/", "textures/")
_DATA = (".json", ".obj", ".png")  # file types that browsers never execute
_PICTURES = ("reference", "preview")  # the first existing one is overlaid on the view
_THUMBNAILS = ("preview", "reference")  # the first existing one becomes the thumbnail
_THUMB = (480, 360)
_QUALITY = 82
_EPOCH = (1980, 1, 1, 0, 0, 0)  # time of all files in an archive


@dataclass(frozen=True, eq=False)
class SceneFolder:
    """The files in a scene's folder, keyed by relative path, and the scene's gallery entry."""

    row: SceneRow
    files: Mapping[str, bytes]


def scene_folder(
    bundle: Path,
    options: FolderOptions | None = None,
    report: Callable[[str], None] = lambda _: None,
) -> SceneFolder:
    """Return the folder of a bundle.

    Args:
        bundle: the bundle's folder, checked as ``load_verified`` does.
        options: additional content.
        report: called with the current item ("PickPlace", "glb").

    Raises:
        BundleError: the bundle is damaged.
    """
    options = options or FolderOptions()
    row, scene = read_whole_row(bundle)
    if scene is None:
        return SceneFolder(row, {})
    held = read_files(bundle)
    files = {f"bundle/{name}": content for name, content in held.items() if _is_data(name)}
    shown = {n: f"bundle/{n}" for n in held if _is_data(n) and n.startswith(_DRAWN)}
    view: dict[str, Any] = {
        "schema": SCHEMA,
        "scene": {"xml": "bundle/scene.xml", "files": shown, "start": "settled"},
        "arm": None,
        "picture": _picture(held),
        "episodes": [],
    }
    if options.robot:
        report("robot")
        view["arm"], view["episodes"] = _robot(bundle, scene, row, options, files, shown, report)
    view["downloads"] = _downloads(bundle.name, scene, held, options.formats, files, report)
    row = replace(row, thumbnail=_thumbnail(held, files))
    view["row"] = plain(row)
    files[VIEW] = json.dumps(view, sort_keys=True, ensure_ascii=False).encode()
    return SceneFolder(row, files)


def _is_data(name: str) -> bool:
    """Return whether a bundle's file is served; scripts and web pages are not.

    The archive of the bundle contains all files.
    """
    return name == "scene.xml" or name.lower().endswith(_DATA)


def _robot(
    bundle: Path,
    scene: Scene,
    row: SceneRow,
    options: FolderOptions,
    files: dict[str, bytes],
    shown: Mapping[str, str],
    report: Callable[[str], None],
) -> tuple[dict[str, Any] | None, list[dict[str, object]]]:
    """Add the episodes' files and the scene with the arm; return their ``view.json`` entries."""
    try:
        files["arm/scene.xml"] = robot_document(scene, frozenset(shown)).encode()
    except SceneError:  # no mount for the arm: show the scene without it
        return None, []
    arm = {"xml": "arm/scene.xml", "files": dict(shown), "start": START}
    rows: list[dict[str, object]] = []
    certified = {t.task for t in row.certificate.tasks if t.certified} if row.certificate else None
    for task in SHOWN:
        if len(rows) >= options.episodes:
            break
        if certified is not None and task not in certified:
            continue
        report(task)
        try:
            play = record_play(bundle, task)
        except TabletopError:  # no valid instance of this task
            continue
        if not play.success:
            continue
        path = f"episodes/{task.lower()}.bin"
        files[path] = play.to_bytes()
        rows.append(plain(PlayRow.of(play, path)))
    return arm, rows


def _downloads(
    name: str,
    scene: Scene,
    held: Mapping[str, bytes],
    formats: Sequence[str],
    files: dict[str, bytes],
    report: Callable[[str], None],
) -> list[dict[str, Any]]:
    """Add the bundle and each export as downloads; return their entries in ``view.json``."""
    made = {f"{name}.zip": ("Bundle (MJCF)", archive(name, held))}
    for kind in formats:
        report(kind)
        written = WRITERS[kind](scene_world(scene))
        if kind in ALONE:
            (content,) = written.values()
            made[f"{name}.{kind}"] = (_LABELS[kind], content)
        else:
            made[f"{name}-{kind}.zip"] = (_LABELS[kind], archive(f"{name}-{kind}", written))
    rows = []
    for file, (label, content) in made.items():
        files[f"downloads/{file}"] = content
        rows.append({"label": label, "file": f"downloads/{file}", "bytes": len(content)})
    return rows


def archive(folder: str, files: Mapping[str, bytes]) -> bytes:
    """Return a zip file of a folder; equal files give equal bytes."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(f"{folder}/{name}", _EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, files[name])
    return made.getvalue()


def _picture(held: Mapping[str, bytes]) -> dict[str, Any] | None:
    """Return the ``view.json`` entry of the picture taken by the scene's camera, or None."""
    from generator.bundle.contents import picture_size

    for kind in _PICTURES:
        if (raw := held.get(f"{kind}.png")) is not None:
            width, height = picture_size(raw, f"{kind}.png")
            return {"file": f"bundle/{kind}.png", "width": width, "height": height, "kind": kind}
    return None


def _thumbnail(held: Mapping[str, bytes], files: dict[str, bytes]) -> str | None:
    """Add a small picture of the simulated scene; return its path, or None if there is none."""
    from PIL import Image

    from generator.bundle.contents import decode_png

    name = next((f"{kind}.png" for kind in _THUMBNAILS if f"{kind}.png" in held), None)
    if name is None:
        return None
    small = Image.fromarray(decode_png(held[name], name))
    small.thumbnail(_THUMB, Image.Resampling.LANCZOS)
    made = io.BytesIO()
    small.save(made, "JPEG", quality=_QUALITY, optimize=True)
    files[THUMBNAIL] = made.getvalue()
    return THUMBNAIL
