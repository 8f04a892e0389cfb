"""What a gallery shows of a bundle, as JSON values; ``web/src/data.ts`` reads them."""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float

from generator.bundle import load, load_verified
from generator.errors import TabletopError
from generator.scene import Scene
from tabletopgen_env.certificates.certificate import Certificate, read_certificate

SCHEMA = 1
"""Version of the page's JSON files."""

_WORD = re.compile(r"[a-z]+")


@dataclass(frozen=True)
class ThingRow:
    """One object: its size along its own axes (metres), its mass (kg), and what it stands on."""

    name: str
    label: str
    category: str
    size: tuple[float, ...]
    mass: float
    on: str


@dataclass(frozen=True)
class TableRow:
    """The table: what it is called, and its extent in x, y and z (metres)."""

    label: str
    size: tuple[float, ...]


@dataclass(frozen=True)
class GateRow:
    """The figures of the physical gate: metres and radians."""

    passed: bool
    failures: tuple[str, ...]
    penetration: float
    drift: float
    tilt: float


@dataclass(frozen=True)
class TaskRow:
    """How many of a task's instances the expert is certified at, and its share of episodes."""

    task: str
    instances: int
    certified: int
    rate: float


@dataclass(frozen=True)
class CertificateRow:
    """A bundle's certificate in a few numbers."""

    instances: int
    certified: int
    tasks: tuple[TaskRow, ...]


@dataclass(frozen=True)
class SceneRow:
    """What the gallery shows of a scene.

    Attributes:
        id: the name of the bundle's folder.
        name, kind, prompt: of the scene and its provenance; ``kind`` is "text", "image", "compose",
            "import" or the like.
        theme: the kind of table that the text names, "" if it names none.
        difficulty: how hard it is to work at, in [0, 1]; None for a scene that cannot be read.
        thumbnail: path of a small picture, relative to the page's JSON file; None without one.
        error: why the bundle cannot be shown; None if it can.
    """

    id: str
    name: str
    kind: str = ""
    prompt: str = ""
    theme: str = ""
    table: TableRow = TableRow("", (0.0, 0.0, 0.0))
    things: tuple[ThingRow, ...] = ()
    difficulty: float | None = None
    gate: GateRow | None = None
    certificate: CertificateRow | None = None
    warnings: tuple[str, ...] = ()
    thumbnail: str | None = None
    error: str | None = None


def read_row(path: Path, *, verified: bool = False) -> tuple[SceneRow, Scene | None]:
    """Return a bundle's row and its scene, which is None where the row has an ``error``.

    ``verified``: the bundle is read as ``load_verified`` does, with everything that is drawn.
    """
    try:
        scene = (load_verified if verified else load)(path)
        certificate = read_certificate(path)
    except TabletopError as error:
        return SceneRow(id=path.name, name=path.name, error=str(error)), None
    return row_of(scene, path.name, certificate), scene


def row_of(scene: Scene, id: str, certificate: Certificate | None = None) -> SceneRow:
    """Return the row of a scene that is called ``id`` on the page."""
    from tabletopgen_env.scenes.difficulty import difficulty

    made = scene.provenance
    return SceneRow(
        id=id,
        name=scene.name,
        kind=made.kind,
        prompt=made.prompt or "",
        theme=theme_of(made.prompt or ""),
        table=TableRow(scene.table.model.label, _rounded(scene.table.scale)),
        things=tuple(
            ThingRow(
                o.name, o.model.label, o.model.category, _rounded(o.scale), round(o.mass, 3),
                o.placement.on or "",
            )
            for o in scene.objects
        ),
        difficulty=round(difficulty(scene), 3),
        gate=_gate(scene),
        certificate=None if certificate is None else certificate_row(certificate),
        warnings=tuple(made.warnings),
    )  # fmt: skip


def theme_of(prompt: str) -> str:
    """Return the kind of table that a text names, "" if it names none."""
    from generator.language.semantics.tone import find_theme

    return find_theme(_WORD.findall(prompt.lower())) or ""


def certificate_row(certificate: Certificate) -> CertificateRow:
    """Return a certificate in a few numbers."""
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


def _gate(scene: Scene) -> GateRow | None:
    report = scene.report
    if report is None:
        return None
    numbers = (float(f"{v:.3g}") for v in (report.penetration, report.drift, report.tilt))
    return GateRow(report.passed, report.failures, *numbers)


def _rounded(values: Float[np.ndarray, "3"]) -> tuple[float, ...]:
    return tuple(round(float(v), 3) for v in values)
