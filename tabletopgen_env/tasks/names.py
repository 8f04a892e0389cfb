"""The names of the tasks."""

from __future__ import annotations

from typing import NamedTuple

NAMES = ("Reach", "Lift", "Push", "PickPlace", "Stack", "Swap", "Sequence", "Tidy")
"""The task names; each task has the id ``TabletopGen/<name>-v0``."""


class TaskName(NamedTuple):
    """The name of a task, with its preset, if any."""

    task: str
    preset: str | None = None
