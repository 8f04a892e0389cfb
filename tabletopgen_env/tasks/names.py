"""The names of the tasks."""

from __future__ import annotations

from typing import NamedTuple

NAMES = ("Reach", "Lift", "Push", "PickPlace", "Stack", "Swap", "Sequence", "Tidy")
"""The tasks; each is the id ``TabletopGen/<name>-v0``."""


class TaskName(NamedTuple):
    """A task of this package by its name, with its preset if it has one."""

    task: str
    preset: str | None = None
