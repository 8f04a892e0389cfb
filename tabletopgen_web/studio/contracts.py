"""What the studio answers, as values; ``encode`` makes JSON of them.

``web/src/studio/api.ts`` has the same types for the page.
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
    """The stage that a job is at: its name, its number from 1, and how many there are."""

    name: str
    number: int
    total: int


@dataclass(frozen=True)
class FigureRow:
    """A picture of what a stage found."""

    name: str
    stage: str
    url: str


@dataclass(frozen=True)
class JobResult:
    """What a job made: a scene of the workspace, or a file to fetch from ``url``.

    ``facts`` are more about it: ``spent`` (what calls to servers cost), of an episode ``success``
    and ``steps``, of an edit ``not_understood`` (words of what it did not take), of a scene of a
    picture ``mean_iou`` (how like the picture its view is, in [0, 1] or None) and ``doubts`` (why
    it is not the picture's).
    """

    scene: str | None = None
    file: str | None = None
    url: str | None = None
    bytes: int | None = None
    facts: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class JobRow:
    """A job. Times are seconds since 1970; ``runs`` is how often it was begun.

    ``request`` is what was asked for, ``log`` the end of what its process wrote, of a single job
    alone.
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
    """Something that happened to a job; ``data`` stands beside the other fields in JSON.

    state: ``state`` (of a job that was removed "deleted"), ``error``; stage: ``name``, ``number``,
    ``total``; figure: a ``FigureRow``; log: ``text``; result: a ``JobResult``.
    """

    seq: int
    job: str
    type: EventType
    time: float
    data: Mapping[str, Any]


@dataclass(frozen=True)
class StudioScene(SceneRow):
    """A scene of the list: what a gallery shows of it, and more.

    ``place``, in JSON ``in``, is where its bundle lies, ``saved`` whether the user's store has it,
    too; ``digest`` ends its name; ``parent`` is the scene it was edited from, which need not exist
    any more, after ``edits`` edits, of which ``last_edit`` says the last in words.
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
    """A step of a scene's history: the scene after it, and what was asked for.

    ``kind`` is "made" for how it began, else that of the edit; ``exists`` whether its bundle is
    there.
    """

    id: str
    digest: str
    kind: str
    asked: str
    names: tuple[str, ...]
    exists: bool


@dataclass(frozen=True)
class PictureRow:
    """An uploaded picture: its id, and its size upright in pixels."""

    picture: str
    width: int
    height: int


@dataclass(frozen=True)
class ExplainedRow:
    """How a phrase of a text was read."""

    role: str
    phrase: str
    meaning: str


@dataclass(frozen=True)
class Explanation:
    """What would be put on which table, in a sentence, and how each phrase was read."""

    summary: str
    rows: tuple[ExplainedRow, ...]


@dataclass(frozen=True)
class RoleRow:
    """Who answers a role's questions, and the settings that decide the answers."""

    role: str
    backend: str
    settings: Mapping[str, Any]


@dataclass(frozen=True)
class EstimateRow:
    """What a job would ask servers first, and for at most how much. Nothing was sent.

    ``calls`` is a line each; what comes after them depends on the answers. ``asks_servers`` is
    false where a job costs nothing.
    """

    roles: tuple[RoleRow, ...]
    calls: tuple[str, ...]
    asks_servers: bool


@dataclass(frozen=True)
class BackendRow:
    """A backend: its roles, what it needs, what of that is missing, whether calls cost money."""

    name: str
    roles: tuple[str, ...]
    needs: str
    lacks: str
    charges: bool
    available: bool


@dataclass(frozen=True)
class StudioState:
    """What this studio is and can do."""

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
    """Return an answer as JSON values."""
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
