"""The scenes of a studio: its workspace, the shipped bundles, and the user's store."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import assets_cache
from generator.bundle import copy, discard, load_pictures, load_verified, put_in_place
from generator.bundle.publication import staging_in
from generator.errors import BundleError, StorageError
from generator.io.bounded import read_regular
from generator.io.files import remove_tree, write_whole
from generator.scene.provenance import versions

from ...page.rows import SCHEMA, read_facts
from ..contracts import EditRow, ScenePlace, StudioScene
from ..folder import StudioFolder
from ..page_parts import write_view
from ..refusals import RefusedError
from ..specs import SCENE_ID
from .rows import list_edits, read_scene

_Stamp = tuple[int, int, int]

_MAKER = "made-by"  # the file that records which version prepared the scenes


class SceneLibrary:
    """Thread-safe access to scenes by id, and changes to those of the workspace."""

    def __init__(self, folder: StudioFolder) -> None:
        self._folder = folder
        self._lock, self._preparing = threading.Lock(), threading.Lock()
        self._rows: dict[Path, tuple[_Stamp, StudioScene]] = {}

    def find(self, scene: str) -> tuple[Path, ScenePlace]:
        """Return a scene's bundle and its location.

        Raises:
            RefusedError: the scene does not exist.
        """
        found = self._places().get(scene) if SCENE_ID.fullmatch(scene) else None
        if found is None:
            raise RefusedError(404, f"There is no scene {scene[:120]!r}.")
        return found

    def list_rows(self) -> list[StudioScene]:
        """Return a row for every scene, beginning with the newest ones of the workspace."""
        stored = _stored_names()
        rows = [(path, replace(self._read_row(path, place), saved=path.name in stored))
                for path, place in self._places().values()]  # fmt: skip
        order = {"workspace": 0, "store": 1, "shipped": 2}
        rows.sort(key=lambda each: (order[each[1].place], _rank(*each), each[1].id))
        return [row for _, row in rows]

    def row(self, scene: str) -> StudioScene:
        """Return a scene's row; raise RefusedError if the scene does not exist."""
        return replace(self._read_row(*self.find(scene)), saved=scene in _stored_names())

    def read_thumbnail(self, scene: str) -> bytes:
        """Return a scene's thumbnail as PNG.

        Raises:
            RefusedError: the scene does not exist, or has no picture.
            BundleError: the scene is damaged.
        """
        picture = load_pictures(self.find(scene)[0]).get("preview")
        if picture is None:
            raise RefusedError(404, f"{scene} has no picture.")
        return picture

    def view_file(self, scene: str, name: str) -> Path:
        """Return the path of a scene's file for the viewer, preparing the scene on first use.

        Raises:
            RefusedError: the scene or file does not exist.
            BundleError: the scene is damaged.
            StorageError: the folder is not writable.
        """
        folder = self._prepare(scene)
        files = {p.relative_to(folder).as_posix(): p for p in folder.rglob("*") if p.is_file()}
        if name not in files:
            raise RefusedError(404, f"{scene} has no file {name[:120]!r}.")
        return files[name]

    def save(self, scene: str) -> StudioScene:
        """Validate a scene of the workspace, and copy it atomically into the user's store.

        Raises:
            RefusedError: the scene does not exist, or is not in the workspace.
            BundleError: the scene is damaged.
            StorageError: the store is not writable.
        """
        path, place = self.find(scene)
        if place != "workspace":
            raise RefusedError(
                409, f"{scene} is already saved; only scenes in the workspace can be saved."
            )
        load_verified(path)
        return replace(self._read_row(copy(path, assets_cache.user_root()), "store"), saved=True)

    def delete(self, scene: str) -> None:
        """Remove a scene from the workspace.

        Raises:
            RefusedError: the scene does not exist, or is not in the workspace.
            StorageError: the scene cannot be removed.
        """
        path, place = self.find(scene)
        if place != "workspace":
            raise RefusedError(409, f"{scene} is not in the workspace; only scenes in the "
            f"workspace can be removed.")  # fmt: skip
        try:
            discard(path)
        except OSError as error:
            raise StorageError(
                f"{scene} cannot be removed: {error.strerror or error}. Remove it manually."
            ) from error
        remove_tree(self._folder.views, scene)

    def history(self, scene: str) -> tuple[list[EditRow], list[str]]:
        """Return the editing steps that end with a scene, and the scenes that were edited from it.

        The scenes edited from it are sorted: the workspace's first, from new to old.

        Raises:
            RefusedError: the scene does not exist.
            BundleError: the scene is damaged.
        """
        path, _ = self.find(scene)
        facts = read_facts(path)
        known = self._places()
        try:
            steps = _list_steps(facts, scene, {name[-12:]: name for name in known})
        except (TypeError, LookupError, AttributeError) as error:
            raise BundleError(
                f"The history of {scene} is damaged. Create the scene again."
            ) from error
        children = [row.id for row in self.list_rows() if row.parent and row.parent[-12:]
                    == scene[-12:]]  # fmt: skip
        return steps, children

    def sweep(self) -> None:
        """Remove viewer files that another version of the package prepared; errors are ignored."""
        views = self._folder.views
        maker = f"{versions(('tabletopgen',))['tabletopgen']}, schema {SCHEMA}".encode()
        with contextlib.suppress(StorageError):
            if (views / _MAKER).exists() and read_regular(
                views / _MAKER, "The version", StorageError, max_bytes=4096
            ) == maker:
                return
            for path in views.iterdir():
                if path.is_dir():
                    remove_tree(views, path.name)
            write_whole(views / _MAKER, maker, "The version", "Free disk space.")

    # ------------------------------------------------------------------------------------ helpers

    def _places(self) -> dict[str, tuple[Path, ScenePlace]]:
        """Return all bundles by id, with those of the workspace first."""
        found: dict[str, tuple[Path, ScenePlace]] = {}
        own = assets_cache.user_root().resolve()
        for path in assets_cache.entries():
            if SCENE_ID.fullmatch(path.name):
                found[path.name] = path, "store" if path.parent.resolve() == own else "shipped"
        for path in self._folder.scenes.iterdir():
            if SCENE_ID.fullmatch(path.name) and not path.is_symlink():
                found[path.name] = path, "workspace"
        return found

    def _read_row(self, path: Path, place: ScenePlace) -> StudioScene:
        try:
            status = (path / "scene.json").stat()
            stamp = status.st_mtime_ns, status.st_size, status.st_ino
        except OSError:
            return read_scene(path, place)
        with self._lock:
            kept = self._rows.get(path)
        if kept is not None and kept[0] == stamp and kept[1].place == place:
            return kept[1]
        row = read_scene(path, place)
        with self._lock:
            self._rows[path] = stamp, row
        return row

    def _prepare(self, scene: str) -> Path:
        path, _ = self.find(scene)
        target = self._folder.views / scene
        with self._preparing:
            if (target / "view.json").is_file():
                return target
            try:
                with staging_in(self._folder.views) as staging:
                    write_view(path, staging)
                    staging.chmod(0o755)
                    put_in_place(staging, target, lambda: False)
            except BundleError:
                raise
            except OSError as error:
                raise StorageError(
                    f"{scene} cannot be prepared for the viewer: {error.strerror or error}. Free "
                    "disk space."
                ) from error
        return target


def _list_steps(
    facts: Mapping[str, Any], scene: str, by_digest: Mapping[str, str]
) -> list[EditRow]:
    edits = list_edits(facts)
    digests = [str(edit["edited"])[:12] for edit in edits] + [scene[-12:]]
    asked: list[tuple[str, str, tuple[str, ...]]] = [
        ("made", str(facts["provenance"].get("prompt") or ""), ())
    ]
    asked += [(str(e["kind"]), str(e["asked"]), tuple(map(str, e["names"]))) for e in edits]
    return [
        EditRow(by_digest.get(digest, f"{facts['name']}-{digest}"), digest, kind, words, names,
                digest in by_digest)
        for digest, (kind, words, names) in zip(digests, asked, strict=True)
    ]  # fmt: skip


def _stored_names() -> frozenset[str]:
    """Return the names of the bundles in the user's store."""
    root = assets_cache.user_root()
    return frozenset(p.name for p in root.iterdir()) if root.is_dir() else frozenset()


def _rank(path: Path, row: StudioScene) -> float:
    """Return a sort key that puts newer bundles of the workspace first."""
    try:
        return -path.stat().st_mtime if row.place == "workspace" else 0.0
    except OSError:  # removed concurrently
        return 0.0
