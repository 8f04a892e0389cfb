"""Entries of bundles in the scene list, read from their ``scene.json`` alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from generator.errors import BundleError

from ...page.rows import SceneRow, read_facts, row_of_facts
from ..contracts import ScenePlace, StudioScene


def read_scene(path: Path, place: ScenePlace) -> StudioScene:
    """Return the row of a bundle; ``error`` gives the reason if it cannot be read."""
    digest = path.name[-12:]
    try:
        facts = read_facts(path)
        row, edits = row_of_facts(facts, path.name), _tell_edits(facts)
    except (BundleError, OSError) as error:
        return StudioScene(path.name, path.name[:-13], error=str(error), place=place, digest=digest)
    except (TypeError, LookupError, AttributeError):
        message = "The scene's history is damaged. Create the scene again."
        return StudioScene(path.name, path.name[:-13], error=message, place=place, digest=digest)
    row = replace(row, thumbnail=f"/api/scenes/{path.name}/thumbnail.png")
    values = {field.name: getattr(row, field.name) for field in fields(SceneRow)}
    return StudioScene(**values, place=place, digest=digest, editable=True, **edits)


def list_edits(facts: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Return the edits of a scene in order."""
    return list((facts.get("provenance") or {}).get("edits") or ())


def _tell_edits(facts: Mapping[str, Any]) -> dict[str, Any]:
    edits = list_edits(facts)
    if not edits:
        return {}
    last = edits[-1]
    names = [*map(str, last["names"])]
    words = " ".join([str(last["kind"]), *(names if len(names) < 4 else [f"{len(names)} things"])])
    asked = f": {last['asked']}" if last["asked"] else ""
    parent = f"{facts['name']}-{last['edited'][:12]}"
    return {"parent": parent, "edits": len(edits), "last_edit": words + asked}
