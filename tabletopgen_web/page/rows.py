"""Gallery entries of bundles as JSON values; ``web/src/data.ts`` reads them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from generator.bundle import load_verified, steady
from generator.bundle.folder import read_truth
from generator.errors import BundleError, TabletopError
from generator.scene import Scene
from tabletopgen_env.certificates.certificate import Certificate, read_certificate

SCHEMA = 1
"""Version of the page's JSON files."""

_WORD = re.compile(r"[a-z]+")


@dataclass(frozen=True)
class ThingRow:
    """The size along local axes (metres), the mass (kg) and the support of one object."""

    name: str
    label: str
    category: str
    size: tuple[float, ...]
    mass: float
    on: str


@dataclass(frozen=True)
class TableRow:
    """The name of the table, and its extents along x, y and z (metres)."""

    label: str
    size: tuple[float, ...]


@dataclass(frozen=True)
class GateRow:
    """Results of the physical gate, in metres and radians."""

    passed: bool
    failures: tuple[str, ...]
    penetration: float
    drift: float
    tilt: float


@dataclass(frozen=True)
class TaskRow:
    """Certified instances of a task, and the expert's success rate."""

    task: str
    instances: int
    certified: int
    rate: float


@dataclass(frozen=True)
class CertificateRow:
    """Summary of a bundle's certificate."""

    instances: int
    certified: int
    tasks: tuple[TaskRow, ...]


@dataclass(frozen=True)
class SceneRow:
    """Gallery entry of a scene.

    Attributes:
        id: the name of the bundle's folder.
        name, kind, prompt: name and provenance of the scene; ``kind`` is "text", "image",
            "compose", "import" or similar.
        asked: the user's edit requests, in order.
        theme: the kind of table named in the prompt, or else in the scene's name; "" for none.
        seed: the seed of the scene; None if it is not recorded.
        difficulty: difficulty for manipulation, in [0, 1]; None if it was not computed.
        thumbnail: path of a small picture, relative to the page's JSON file; None without one.
        error: reason why the bundle cannot be shown; None if it can.
    """

    id: str
    name: str
    kind: str = ""
    prompt: str = ""
    asked: tuple[str, ...] = ()
    theme: str = ""
    seed: int | None = None
    table: TableRow = TableRow("", (0.0, 0.0, 0.0))
    things: tuple[ThingRow, ...] = ()
    difficulty: float | None = None
    gate: GateRow | None = None
    certificate: CertificateRow | None = None
    warnings: tuple[str, ...] = ()
    thumbnail: str | None = None
    error: str | None = None


@steady
def read_facts(path: str | Path) -> dict[str, Any]:
    """Return the validated content of a bundle's ``scene.json``.

    Raises:
        BundleError: the bundle is missing, damaged or has another schema.
    """
    return read_truth(Path(path))


def read_row(path: Path) -> SceneRow:
    """Return a bundle's row from its ``scene.json`` alone, with an ``error`` if that fails."""
    try:
        return row_of_facts(read_facts(path), path.name)
    except (BundleError, OSError) as error:
        return SceneRow(id=path.name, name=path.name, error=str(error))


def read_whole_row(path: Path) -> tuple[SceneRow, Scene | None]:
    """Validate a bundle; return its row, with difficulty and certificate, and its scene.

    The scene is None if the row has an ``error``.
    """
    from tabletopgen_env.scenes.difficulty import difficulty

    row = read_row(path)
    try:
        scene, certificate = load_verified(path), read_certificate(path)
    except TabletopError as error:
        return SceneRow(id=path.name, name=path.name, error=str(error)), None
    held = None if certificate is None else certificate_row(certificate)
    return replace(row, difficulty=round(difficulty(scene), 3), certificate=held), scene


def row_of_facts(facts: Mapping[str, Any], id: str) -> SceneRow:
    """Return the row of a bundle called ``id`` from the content ``facts`` of its ``scene.json``.

    Raises:
        BundleError: required fields are missing.
    """
    try:
        models, table, made = facts["models"], facts["table"], facts["provenance"]
        name, prompt = str(facts["name"]), str(made.get("prompt") or "")
        seed = made.get("seed")
        return SceneRow(
            id=id,
            name=name,
            kind=str(made["kind"]),
            prompt=prompt,
            asked=tuple(str(edit["asked"]) for edit in made.get("edits") or ()),
            theme=theme_of(prompt) or theme_of(name),
            seed=None if seed is None else int(seed),
            table=TableRow(str(models[table["model"]]["label"]), _round(table["scale"])),
            things=tuple(_thing(entry, models[entry["model"]]) for entry in facts["objects"]),
            gate=_gate(facts.get("report")),
            warnings=tuple(map(str, made.get("warnings") or ())),
        )
    except (TypeError, LookupError, ValueError, AttributeError) as error:
        raise BundleError(f"{id}: scene.json lacks required fields. Create the scene again.") from (
            error
        )


def _thing(entry: Mapping[str, Any], model: Mapping[str, Any]) -> ThingRow:
    placed = entry["placement"]
    return ThingRow(
        str(entry["name"]), str(model["label"]), str(model["category"]), _round(placed["scale"]),
        round(float(entry["mass"]), 3), str(placed.get("on") or ""),
    )  # fmt: skip


def theme_of(words: str) -> str:
    """Return the kind of table that a prompt names, or "" if it names none."""
    from generator.language.semantics.tone import find_theme

    return find_theme(_WORD.findall(words.lower())) or ""


def certificate_row(certificate: Certificate) -> CertificateRow:
    """Return the summary of a certificate."""
    by_task: dict[str, list[Any]] = defaultdict(list)
    for instance in certificate.instances:
        by_task[instance.task].append(instance)
    rows = tuple(
        TaskRow(
            task,
            len(found),
            sum(i.certified for i in found),
            round(sum(i.successes for i in found) / max(sum(i.episodes for i in found), 1), 3),
        )
        for task, found in by_task.items()
    )
    return CertificateRow(
        len(certificate.instances), sum(i.certified for i in certificate.instances), rows
    )


def _gate(report: Mapping[str, Any] | None) -> GateRow | None:
    if report is None:
        return None
    failures = tuple(map(str, report["failures"]))
    numbers = (float(f"{report[name]:.3g}") for name in ("penetration", "drift", "tilt"))
    return GateRow(not failures, failures, *numbers)


def _round(values: Sequence[float]) -> tuple[float, ...]:
    return tuple(round(float(v), 3) for v in values)
