"""The certificate of a bundle: the file, checked when it is read. ``certify`` makes it."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from generator import bundle
from generator.errors import BundleError, InputError, choices, require, require_seed
from generator.io.bounded import parse_object, printable
from generator.io.files import write_whole

from ..files import check_type
from ..tasks.names import NAMES, TaskName

FILE = "certificate.json"
"""The certificate's name in a bundle's folder."""

SCHEMA = 4
"""Version of the file. Older ones certify nothing: before 3 starts hardly differed, and before 4
an instance was certified that had failed from one of its starts."""

STARTS = 30
"""An instance played from fewer starts is not certified, nor is one that failed from any.

What would fail from more than one start in ten is solved from 30 with a chance below 5 %.
"""

MOST_INSTANCES, MOST_EPISODES = 4096, 10_000
"""A certificate lists no more instances, and no more episodes of one."""

_MOST_FILE, _DEPTH = 2**20, 4


@dataclass(frozen=True)
class TaskInstance:
    """One thing to do at a table, as ``reset`` takes it, and how often the expert did it.

    ``goal`` is an object's name, "spot" (drawn anew for each episode) or None, ``target`` an
    object's name or None, as the task's page says. Reach is one instance without either, drawn,
    and so is Sequence, with one more for each ``preset``.
    """

    task: str
    target: str | None
    goal: str | None
    successes: int = 0
    episodes: int = 0
    preset: str | None = None

    @property
    def name(self) -> TaskName:
        """The task, with its preset."""
        return TaskName(self.task, self.preset)

    @property
    def options(self) -> dict[str, Any]:
        """The options of ``reset`` that ask for it."""
        both = {"target": self.target, "goal": self.goal}
        return {name: value for name, value in both.items() if value is not None}

    @property
    def certified(self) -> bool:
        """Whether the expert solved it from each of at least ``STARTS`` starts."""
        return self.successes == self.episodes >= STARTS


@dataclass(frozen=True)
class Terms:
    """What a certificate is made for; the same terms give the same certificate of a scene.

    Args:
        tasks: names of tasks, kept in the order of ``NAMES``; Sequence goes with its presets.
        episodes: how many of each instance, at most ``MOST_EPISODES``: the first from where the
            scene has things, each other from a perturbed start of its own; none after a failure.
            Less than ``STARTS`` certify nothing.
        most: how many instances of each task, and of each preset, at most.
        seed: draws instances and starts.

    Raises:
        InputError: an unknown task or none at all, or a number out of range.
    """

    tasks: tuple[str, ...] = NAMES
    episodes: int = STARTS
    most: int = 8
    seed: int = 0

    def __post_init__(self) -> None:
        for task in self.tasks:
            if task not in NAMES:
                raise InputError(f"Unknown task {task!r}." + choices(str(task), NAMES))
        require(self, "episodes", minimum=1, maximum=MOST_EPISODES, integer=True)
        require(self, "most", minimum=1, maximum=MOST_INSTANCES // (2 * len(NAMES)), integer=True)
        require_seed(self.seed)
        if not self.tasks:
            raise InputError("A certificate needs at least one task." + choices("", NAMES))
        object.__setattr__(self, "tasks", tuple(name for name in NAMES if name in self.tasks))
        for name in ("episodes", "most", "seed"):  # NumPy's integers are no JSON
            object.__setattr__(self, name, int(getattr(self, name)))


@dataclass(frozen=True)
class Certificate:
    """What was seen at one table.

    ``scene`` is the sha256 of the bundle's ``scene.json``; ``terms`` and ``versions`` say how it
    can be seen again. A task of the terms of which nothing is listed has nothing to do there.
    """

    scene: str
    terms: Terms
    versions: Mapping[str, str]
    instances: tuple[TaskInstance, ...]

    @property
    def certified(self) -> tuple[TaskInstance, ...]:
        """Those of the instances that count as certified."""
        return tuple(i for i in self.instances if i.certified)


def read_certificate(path: str | Path) -> Certificate | None:
    """Return a bundle's certificate, checked; None if it has none, or one of an older schema.

    Raises:
        BundleError: it is damaged, too large, of an unknown schema, or another scene's.
    """
    folder = Path(path)
    if not os.path.lexists(folder / FILE):
        return None
    raw = bundle.read_inside(folder, FILE, _MOST_FILE)
    try:
        payload = parse_object(raw, "It", BundleError, max_bytes=_MOST_FILE, max_depth=_DEPTH)
        schema = check_type(payload.get("schema"), int)
        if 1 <= schema < SCHEMA:
            return None
        if schema != SCHEMA:
            raise ValueError(f"it is of schema {schema}, not {SCHEMA}")
        found = _decode(payload)
    except (ValueError, TypeError, KeyError, BundleError) as error:
        raise BundleError(
            f"{folder}: {FILE} is no sound certificate ({type(error).__name__}: {error}). "
            "Remove it, or certify the bundle again."
        ) from error
    if found.scene != scene_digest(folder):
        raise BundleError(
            f"{folder}: {FILE} was made for another scene. Remove it, or certify the bundle again."
        )
    return found


def scene_digest(folder: Path) -> str:
    """Return the sha256 of a bundle's ``scene.json``."""
    return hashlib.sha256(
        bundle.read_inside(folder, "scene.json", bundle.BOUNDS.file_bytes)
    ).hexdigest()


def write_certificate(folder: Path, certificate: Certificate) -> None:
    """Write the certificate, whole or not at all.

    Raises:
        StorageError: the folder cannot be written.
    """
    payload = {"schema": SCHEMA, **asdict(certificate)}
    text = json.dumps(payload, indent=1, sort_keys=True, allow_nan=False) + "\n"
    write_whole(folder / FILE, text, "The certificate", "Certify a copy of the bundle.")


def _decode(payload: dict[str, Any]) -> Certificate:
    scene, terms = check_type(payload["scene"], str), check_type(payload["terms"], dict)
    asked = Terms(
        tuple(check_type(task, str) for task in check_type(terms["tasks"], list)),
        *(check_type(terms[name], int) for name in ("episodes", "most", "seed")),
    )
    versions = {
        printable(k, "A package", BundleError): printable(v, "A version", BundleError)
        for k, v in check_type(payload["versions"], dict).items()
    }
    listed = check_type(payload["instances"], list)
    if len(listed) > MOST_INSTANCES:
        raise ValueError(f"it lists more than {MOST_INSTANCES} instances")
    return Certificate(
        scene, asked, versions, tuple(_decoded_instance(check_type(i, dict), asked) for i in listed)
    )


def _decoded_instance(entry: dict[str, Any], terms: Terms) -> TaskInstance:
    target, goal, preset = entry["target"], entry["goal"], entry["preset"]
    for name in (target, goal, preset):
        if name is not None:
            printable(name, "A name", BundleError)
    task = check_type(entry["task"], str)
    from ..tasks.registry import task_named  # loads all of the expert

    task_named(task, preset)  # refuses what there is not
    if task not in terms.tasks:
        raise ValueError(f"it lists {task}, which it was not made for")
    solved, played = check_type(entry["successes"], int), check_type(entry["episodes"], int)
    if not 0 <= solved <= played <= MOST_EPISODES:
        raise ValueError(f"{solved} of {played} episodes cannot be")
    return TaskInstance(task, target, goal, solved, played, preset)
