"""The certificate of a bundle, created by ``certify`` and validated when read."""

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
"""Name of the certificate in a bundle's folder."""

SCHEMA = 4
"""Version of the file format. Older certificates are not accepted: before version 3, initial states
hardly differed; before version 4, an instance was certified even if one of its episodes failed.
"""

STARTS = 30
"""Minimum number of episodes of a certified instance, all of which must succeed.

If an instance fails from more than 10 % of its initial states, the probability that it passes all
30 episodes is below 5 %.
"""

MOST_INSTANCES, MOST_EPISODES = 4096, 10_000
"""Maximum number of instances of a certificate, and of episodes per instance."""

_MOST_FILE, _DEPTH = 2**20, 4


@dataclass(frozen=True)
class TaskInstance:
    """A task instance on a table, as selected by options of ``reset``, and the expert's results.

    ``goal`` is an object's name, "spot" (a random position per episode) or None; ``target`` is an
    object's name or None, depending on the task. Reach has a single instance with neither, whose
    goals are random. So has Sequence, in addition to one instance for each ``preset``.
    """

    task: str
    target: str | None
    goal: str | None
    successes: int = 0
    episodes: int = 0
    preset: str | None = None

    @property
    def name(self) -> TaskName:
        """The name of the task and its preset."""
        return TaskName(self.task, self.preset)

    @property
    def options(self) -> dict[str, Any]:
        """The options of ``reset`` that select the instance."""
        both = {"target": self.target, "goal": self.goal}
        return {name: value for name, value in both.items() if value is not None}

    @property
    def certified(self) -> bool:
        """Whether there were at least ``STARTS`` episodes and the expert solved all of them."""
        return self.successes == self.episodes >= STARTS


@dataclass(frozen=True)
class Terms:
    """The settings of a certification; equal settings give equal certificates for the same scene.

    Args:
        tasks: names of tasks, stored in the order of ``NAMES``; Sequence includes its presets.
        episodes: number of episodes per instance, at most ``MOST_EPISODES``: the first from the
            scene's own state, the others from perturbed initial states. After a failure, no more
            episodes of the instance are played. Fewer than ``STARTS`` episodes certify nothing.
        most: maximum number of instances of each task, and of each preset.
        seed: seed of instances and initial states.

    Raises:
        InputError: there is no task or an unknown one, or a number is out of range.
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
        for name in ("episodes", "most", "seed"):  # NumPy integers are not JSON
            object.__setattr__(self, name, int(getattr(self, name)))


@dataclass(frozen=True)
class Certificate:
    """The expert's results on one table.

    ``scene`` is the sha256 of the bundle's ``scene.json``; ``terms`` and ``versions`` allow the
    results to be reproduced. A task of the terms without instances has no valid goal on the table.
    """

    scene: str
    terms: Terms
    versions: Mapping[str, str]
    instances: tuple[TaskInstance, ...]

    @property
    def certified(self) -> tuple[TaskInstance, ...]:
        """The certified instances."""
        return tuple(i for i in self.instances if i.certified)


def read_certificate(path: str | Path) -> Certificate | None:
    """Return a bundle's validated certificate, or None if it is missing or has an older schema.

    Raises:
        BundleError: it is damaged, too large, of an unknown schema, or belongs to another scene.
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
            raise ValueError(f"the schema is {schema}, not {SCHEMA}")
        found = _decode(payload)
    except (ValueError, TypeError, KeyError, BundleError) as error:
        raise BundleError(
            f"{folder}: {FILE} is not a valid certificate ({type(error).__name__}: {error}). "
            "Remove it, or certify the bundle again."
        ) from error
    if found.scene != scene_digest(folder):
        raise BundleError(
            f"{folder}: {FILE} belongs to another scene. Remove it, or certify the bundle again."
        )
    return found


def scene_digest(folder: Path) -> str:
    """Return the sha256 of a bundle's ``scene.json``."""
    return hashlib.sha256(
        bundle.read_inside(folder, "scene.json", bundle.BOUNDS.file_bytes)
    ).hexdigest()


def write_certificate(folder: Path, certificate: Certificate) -> None:
    """Write the certificate atomically.

    Raises:
        StorageError: the folder cannot be written.
    """
    payload = {"schema": SCHEMA, **asdict(certificate)}
    text = json.dumps(payload, indent=1, sort_keys=True, allow_nan=False) + "\n"
    write_whole(
        folder / FILE, text, "The certificate", "Certify a copy of the bundle in a writable folder."
    )


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
        raise ValueError(f"the certificate lists more than {MOST_INSTANCES} instances")
    return Certificate(
        scene, asked, versions, tuple(_decoded_instance(check_type(i, dict), asked) for i in listed)
    )


def _decoded_instance(entry: dict[str, Any], terms: Terms) -> TaskInstance:
    target, goal, preset = entry["target"], entry["goal"], entry["preset"]
    for name in (target, goal, preset):
        if name is not None:
            printable(name, "A name", BundleError)
    task = check_type(entry["task"], str)
    from ..tasks.registry import task_named  # imports the whole expert

    task_named(task, preset)  # raises for unknown names
    if task not in terms.tasks:
        raise ValueError(f"an instance has the task {task}, which the settings do not list")
    solved, played = check_type(entry["successes"], int), check_type(entry["episodes"], int)
    if not 0 <= solved <= played <= MOST_EPISODES:
        raise ValueError(f"invalid counts: {solved} of {played} episodes")
    return TaskInstance(task, target, goal, solved, played, preset)
