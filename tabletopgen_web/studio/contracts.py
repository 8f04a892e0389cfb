"""Types of the studio's responses; ``encode`` converts them to JSON.

``web/src/studio/api.ts`` defines the same types for the page.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from ..page.rows import SceneRow

JobKind = Literal["generate", "compose", "edit", "episode", "export"]
JobState = Literal["queued", "running", "done", "failed", "cancelled", "interrupted"]
EventType = Literal["state", "stage", "figure", "log", "result"]
ScenePlace = Literal["workspace", "store", "shipped"]


@dataclass(frozen=True)
class StageRow:
    """The current stage of a job: its name, its number from 1, and the total number of stages."""

    name: str
    number: int
    total: int


@dataclass(frozen=True)
class FigureRow:
    """A picture of a stage's result."""

    name: str
    stage: str
    url: str


@dataclass(frozen=True)
class JobResult:
    """Result of a job: a scene of the workspace, or a file to fetch from ``url``.

    A failed job has a result, with ``facts`` alone, if its error has more to tell than its message.

    ``facts`` hold details: ``spent`` (cost of calls to servers); for an episode ``success`` and
    ``steps``; for an edit ``not_understood`` (ignored words); for an edit that failed because an
    object cannot stand at the requested position, ``place`` ("occupied" or "off the table") and
    ``free_position`` (nearest free x, y in metres, or None); for a scene from a picture
    ``mean_iou`` (similarity of its view to the picture, in [0, 1] or None) and ``doubts`` (reasons
    why it may not match the picture).
    """

    scene: str | None = None
    file: str | None = None
    url: str | None = None
    bytes: int | None = None
    facts: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class JobRow:
    """A job. Times are seconds since 1970; ``runs`` is the number of starts.

    ``request`` is the original request; ``log``, the end of the process's output, is present only
    in responses about a single job.
    """

    id: str
    kind: JobKind
    state: JobState
    title: str
    request: Mapping[str, Any]
    created: float
    started: float | None = None
    finished: float | None = None
    runs: int = 0
    stage: StageRow | None = None
    figures: tuple[FigureRow, ...] = ()
    error: str | None = None
    result: JobResult | None = None
    log: str = ""


@dataclass(frozen=True)
class JobEvent:
    """An event of a job; in JSON, the entries of ``data`` are at the top level.

    state: ``state`` ("deleted" for a removed job), ``error``; stage: ``name``, ``number``,
    ``total``; figure: a ``FigureRow``; log: ``text``; result: a ``JobResult``.
    """

    seq: int
    job: str
    type: EventType
    time: float
    data: Mapping[str, Any]


@dataclass(frozen=True)
class StudioScene(SceneRow):
    """A scene in the studio's list: its gallery entry and further properties.

    ``place`` (``in`` in JSON) is the location of its bundle, ``saved`` whether the user's store
    also has it; ``digest`` is the end of its name; ``parent`` is the scene from which it was
    edited, which may no longer exist; ``edits`` is the number of edits, and ``last_edit`` describes
    the last one.
    """

    place: ScenePlace = "workspace"
    digest: str = ""
    editable: bool = False
    parent: str | None = None
    saved: bool = False
    edits: int = 0
    last_edit: str = ""


@dataclass(frozen=True)
class EditRow:
    """A step of a scene's history: the request and the resulting scene.

    ``kind`` is "made" for the original scene, else the kind of the edit; ``exists`` is whether its
    bundle exists.
    """

    id: str
    digest: str
    kind: str
    asked: str
    names: tuple[str, ...]
    exists: bool


@dataclass(frozen=True)
class PictureRow:
    """An uploaded picture: its id, and its upright size in pixels."""

    picture: str
    width: int
    height: int


@dataclass(frozen=True)
class ExplainedRow:
    """The interpretation of a phrase in a prompt."""

    role: str
    phrase: str
    meaning: str


@dataclass(frozen=True)
class Explanation:
    """The interpretation of a prompt: a summary of the table and objects, and each phrase."""

    summary: str
    rows: tuple[ExplainedRow, ...]


@dataclass(frozen=True)
class RoleRow:
    """The backend that performs a role, and the settings that affect its answers."""

    role: str
    backend: str
    settings: Mapping[str, Any]


@dataclass(frozen=True)
class EstimateRow:
    """The first requests that a job would send to servers, and their maximum cost.

    Nothing was sent. ``calls`` has a line per call; later calls depend on the answers.
    ``asks_servers`` is false if a job is free.
    """

    roles: tuple[RoleRow, ...]
    calls: tuple[str, ...]
    asks_servers: bool


@dataclass(frozen=True)
class BackendRow:
    """A backend: its roles, what it requires and lacks, and whether its calls cost money."""

    name: str
    roles: tuple[str, ...]
    needs: str
    lacks: str
    charges: bool
    available: bool


@dataclass(frozen=True)
class StudioState:
    """Properties and capabilities of this studio."""

    version: str
    roles: tuple[str, ...]
    backends: tuple[BackendRow, ...]
    formats: tuple[str, ...]
    tasks: tuple[str, ...]
    store: str
    folder: str
    workers: int
    queue_limit: int
    last_event: int


def encode(value: Any) -> Any:
    """Return a response as JSON values."""
    if isinstance(value, StudioScene):
        row = {k: encode(v) for k, v in _fields(value).items()}
        row["in"] = row.pop("place")
        return row
    if isinstance(value, JobEvent):
        own = {k: v for k, v in _fields(value).items() if k != "data"}
        return {**encode(dict(value.data)), **own}
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {k: encode(v) for k, v in _fields(value).items()}
    if isinstance(value, Mapping):
        return {str(k): encode(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [encode(v) for v in value]
    return value


def _fields(value: Any) -> dict[str, Any]:
    return {f.name: getattr(value, f.name) for f in dataclasses.fields(value)}
