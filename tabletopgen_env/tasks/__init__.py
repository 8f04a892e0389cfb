"""What is asked of the robot: one file per task, made of the goals in ``goals``."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from generator.errors import InputError, choices

if TYPE_CHECKING:
    from .task import Task

NAMES = ("Reach", "Lift", "Push", "PickPlace", "Stack", "Swap", "Sequence", "Tidy")
"""The tasks; each is the id ``TabletopGen/<name>-v0``."""


class TaskName(NamedTuple):
    """A task of this package by its name, and its preset if it has one."""

    task: str
    preset: str | None = None


def task_named(name: str, preset: str | None = None) -> Task:
    """Return the task of a name; ``preset`` is Sequence's.

    Raises:
        InputError: no such task or preset, or a preset for another task.
    """
    from .lift import Lift
    from .pick_place import PickPlace
    from .push import Push
    from .reach import Reach
    from .sequence import Sequence
    from .stack import Stack
    from .swap import Swap
    from .tidy import Tidy

    kinds = dict(
        zip(NAMES, (Reach, Lift, Push, PickPlace, Stack, Swap, Sequence, Tidy), strict=True)
    )
    if name not in kinds:
        raise InputError(f"Unknown task {name!r}." + choices(str(name), NAMES))
    if name == "Sequence":
        return Sequence(preset)
    if preset is not None:
        raise InputError(f"{name} has no presets; leave 'preset' out or use 'Sequence'.")
    return kinds[name]()
