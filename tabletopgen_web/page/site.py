"""A static site: the front end, a gallery, and a folder per scene."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from generator.bundle.publication import put_in_place, staging_in
from generator.errors import InputError, StorageError
from generator.scene.provenance import plain, versions

from ..frontend import static_folder
from .options import FolderOptions
from .rows import SCHEMA, SceneRow
from .scene_folder import scene_folder

GALLERY = "gallery.json"
"""The file of a site that lists its scenes."""

_MARKER = ".tabletopgen-page"
_WORDS = "A page that `tabletopgen page` wrote; it may be replaced.\\n"


@dataclass(frozen=True)
class Site:
    """A written site: its folder, the rows of its scenes, and its size in bytes."""

    path: Path
    scenes: tuple[SceneRow, ...]
    bytes: int


def write_site(
    bundles: Sequence[Path],
    out: Path,
    title: str = "Tables",
    options: FolderOptions | None = None,
    report: Callable[[str, str], None] = lambda _scene, _what: None,
) -> Site:
    """Write a static site of bundles to the folder ``out``, atomically.

    An existing site is replaced; any other non-empty folder is rejected. A bundle that cannot be
    read is listed with the reason.

    Args:
        bundles: the bundles' folders, in display order.
        out: the site's folder, created if missing.
        title: title of the gallery.
        options: content of each scene's folder.
        report: called with a scene's name and its current item.

    Raises:
        BackendError: the front end is missing and cannot be built.
        InputError: ``out`` contains something else, or two bundles have the same name.
        StorageError: ``out`` is not writable, or the disk is full.
    """
    static, out = static_folder(), out.absolute()
    _check(bundles, out)
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with staging_in(out.parent) as staging:
            size = _copy_static(static, staging)
            rows: list[SceneRow] = []
            for bundle in bundles:
                folder = scene_folder(bundle, options, lambda what, b=bundle: report(b.name, what))
                size += _write(staging / "scenes" / bundle.name, folder.files)
                rows.append(_relative(folder.row))
            listed: dict[str, Any] = {
                "schema": SCHEMA,
                "title": title,
                "made": f"tabletopgen {versions(('tabletopgen',))['tabletopgen']}",
                "scenes": plain(rows),
            }
            text = json.dumps(listed, sort_keys=True, ensure_ascii=False)
            size += _write(staging, {GALLERY: text.encode(), _MARKER: _WORDS.encode()})
            staging.chmod(0o755)
            put_in_place(staging, out, lambda: False)
    except OSError as error:
        raise StorageError(
            f"The page cannot be written to {out}: {error.strerror or error}. Free disk space, or "
            "choose another folder."
        ) from error
    return Site(out, tuple(rows), size)


def _check(bundles: Sequence[Path], out: Path) -> None:
    names = [bundle.name for bundle in bundles]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"Two bundles are named {twice!r}. Rename one of them.")
    if out.is_dir() and any(out.iterdir()) and not (out / _MARKER).is_file():
        raise InputError(
            f"{out} contains files that do not belong to a page and would be deleted. Choose a new "
            f"folder."
        )
    if out.exists() and not out.is_dir():
        raise InputError(f"{out} is a file. Choose a folder.")


def _relative(row: SceneRow) -> SceneRow:
    """Return a row for the gallery's file, with paths relative to the parent folder."""
    small = row.thumbnail
    return row if small is None else replace(row, thumbnail=f"scenes/{row.id}/{small}")


def _copy_static(static: Path, target: Path) -> int:
    """Copy the front end; the gallery's page becomes ``index.html``."""
    files = {
        path.relative_to(static).as_posix(): path.read_bytes()
        for path in sorted(static.rglob("*"))
        if path.is_file()
    }
    files["index.html"] = files.pop("page.html")
    unused = {"study.html", "studio.html"}
    return _write(target, {name: raw for name, raw in files.items() if name not in unused})


def _write(folder: Path, files: Any) -> int:
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return sum(map(len, files.values()))
