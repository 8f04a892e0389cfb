"""The tasks by name."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from generator.errors import InputError, require_known

from .lift import Lift
from .pick_place import PickPlace
from .push import Push
from .reach import Reach
from .sequence import Sequence
from .stack import Stack
from .swap import Swap
from .task import Task
from .tidy import Tidy

_ALL = (Reach, Lift, Push, PickPlace, Stack, Swap, Sequence, Tidy)
TASKS: Mapping[str, type[Task]] = MappingProxyType({task.__name__: task for task in _ALL})


def task_named(name: str, preset: str | None = None) -> Task:
    """Return the task with the given name; ``preset`` is for the task "Sequence".

    Raises:
        InputError: the task or preset is unknown, or the task has no presets.
    """
    require_known(name, TASKS, "Unknown task")
    if name == "Sequence":
        return Sequence(preset)
    if preset is not None:
        raise InputError(f"{name} has no presets; omit 'preset', or use the task 'Sequence'.")
    return TASKS[name]()
