"""What a list of scenes says of a bundle, by its ``scene.json`` alone."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from generator.bundle import steady
from generator.bundle.folder import read_truth
from generator.errors import BundleError
from generator.language.themes import THEMES

from ..contracts import ScenePlace, SceneRow, TableRow, ThingRow


def read_row(path: Path, place: ScenePlace) -> SceneRow:
    """Return the row of a bundle; ``error`` says why, where it cannot be read."""
    name, digest = path.name[:-13], path.name[-12:]
    thumbnail = f"/api/scenes/{path.name}/thumbnail.png"
    try:
        return _row(read_facts(path), path.name, digest, place, thumbnail)
    except (BundleError, OSError) as error:
        said = str(error)
    except (TypeError, LookupError, ValueError, AttributeError):
        said = "scene.json does not say what a scene has. Make it again."
    return SceneRow(path.name, name, digest, place, thumbnail, error=said)


@steady
def read_facts(path: str | Path) -> dict[str, Any]:
    """Return the checked content of a bundle's ``scene.json``.

    Raises:
        BundleError: there is no bundle, or it is damaged or of another schema.
    """
    return read_truth(Path(path))


def list_edits(facts: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Return the edits of a scene, the first one first."""
    return list((facts.get("provenance") or {}).get("edits") or ())


def theme_of(prompt: str | None) -> str:
    """Return the kind of table that a text's words mean; "" if they mean none."""
    text = f" {' '.join(re.findall(r'[a-z]+', (prompt or '').lower()))} "
    found = [(len(words), name) for name, theme in THEMES.items() for words in theme.words
             if f" {words} " in text]  # fmt: skip
    return max(found)[1] if found else ""


def _row(
    facts: Mapping[str, Any], scene: str, digest: str, place: ScenePlace, thumbnail: str
) -> SceneRow:
    models, table = facts["models"], facts["table"]
    provenance, report = facts["provenance"], facts.get("report")
    edits = list_edits(facts)
    things = tuple(
        ThingRow(str(o["name"]), str(models[o["model"]]["label"])) for o in facts["objects"]
    )
    prompt = provenance.get("prompt")
    size = tuple(round(float(v), 4) for v in table["scale"])
    return SceneRow(
        scene, str(facts["name"]), digest, place, thumbnail, theme_of(prompt), prompt,
        TableRow(str(models[table["model"]]["label"]), size), things, len(things),
        None if report is None else not report["failures"], report,
        tuple(map(str, provenance.get("warnings") or ())), True,
        f"{facts['name']}-{edits[-1]['edited'][:12]}" if edits else None,
    )  # fmt: skip
