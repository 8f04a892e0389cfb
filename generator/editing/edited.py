"""A bundle opened for editing, and the edited result."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from ..bundle import Segments, load, load_fingerprint, load_pictures, load_segments, save
from ..errors import InputError, SceneError
from ..layout.relation_check import describe_unmet, list_unmet, record_relations
from ..method.figures import preview
from ..scene import TABLE, Edit, Object, Scene


@dataclass(frozen=True, eq=False)
class Opened:
    """A bundle's scene, the sha256 of its ``scene.json``, and the bundle's other contents."""

    scene: Scene
    sha256: str
    pictures: Mapping[str, bytes]
    segments: Segments | None

    @classmethod
    def read(cls, bundle: str | Path) -> Opened:
        """Read a bundle and check all of its files.

        Raises:
            BundleError: The bundle does not exist or is damaged.
        """
        pictures = load_pictures(bundle)
        return cls(load(bundle), load_fingerprint(bundle), pictures, load_segments(bundle))

    def thing(self, name: str) -> Object:
        """Return the object with this name.

        Raises:
            InputError: There is no such object, or it is the table.
        """
        if name == TABLE:
            raise InputError("The table cannot be edited, only the objects on it.")
        return self.scene.object(name)


@dataclass(frozen=True, eq=False)
class Edited:
    """An edited scene that passed the gate, with the pictures and segments of its bundle.

    The pictures of the original bundle are kept; they show the scene before the edit.
    """

    scene: Scene
    pictures: Mapping[str, bytes]
    segments: Segments | None

    @classmethod
    def of(cls, opened: Opened, scene: Scene, edit: Edit, warnings: tuple[str, ...]) -> Edited:
        """Return a settled and checked scene, with the edit recorded in its provenance.

        For a composed scene, the relation outcomes in the report are updated.

        Raises:
            SceneError: The scene failed the gate.
        """
        if scene.report is None or not scene.report.passed:
            failures = "" if scene.report is None else scene.report.failure_text
            raise SceneError(
                f"After this edit, {scene.name!r} fails its physical gate: {failures}. Nothing was "
                "published. Try another seed, or make room first."
            )
        if scene.provenance.kind == "compose":  # plan and scene share object names
            scene = record_relations(scene)
            warnings = (*warnings, *_list_broken(opened.scene, scene))
        past = scene.provenance
        merged = past.warnings + tuple(w for w in warnings if w not in past.warnings)
        provenance = replace(past, edits=(*past.edits, edit), warnings=merged)
        pictures = {stem: png for stem, png in opened.pictures.items() if stem != "preview"}
        return cls(scene.replace(provenance=provenance), pictures, opened.segments)

    def save(self, folder: str | Path) -> Path:
        """Publish the scene as a bundle in ``folder``; return the bundle's path.

        Raises:
            StorageError: The folder cannot be written, or the disk is full.
        """
        images = {**self.pictures, "preview": preview(self.scene)}
        return save(self.scene, folder, images=images, segments=self.segments)


def _list_broken(before: Scene, after: Scene) -> list[str]:
    """Return a warning for each planned relation that an edit broke."""
    known = {(o.name, o.kind, o.target) for o in list_unmet(before)}
    return [
        describe_unmet(o, after)
        for o in list_unmet(after)
        if (o.name, o.kind, o.target) not in known
    ]
