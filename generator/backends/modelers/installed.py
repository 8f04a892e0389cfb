"""Calls to models whose repositories are installed, in any version."""

from __future__ import annotations

import inspect
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import trimesh

from ...errors import BackendError
from ...meshes.canonical import Normal, foreign_model, normal_trimesh
from ...meshes.reading.surface import Axis
from ...scene import Instance, Model, SizePrior


@dataclass(frozen=True)
class Installed:
    """A model that runs in this process, on one instance at a time."""

    _turn: threading.Lock = field(
        default_factory=threading.Lock, init=False, repr=False, compare=False
    )


def call(function: Callable[..., Any], backend: str, *given: Any, **named: Any) -> Any:
    """Call a function of a model whose signature may differ between versions.

    Raises:
        BackendError: the installed version takes other arguments.
    """
    try:
        inspect.signature(function).bind(*given, **named)
    except TypeError as error:
        name = getattr(function, "__qualname__", type(function).__name__)
        raise BackendError(
            f"{backend}: the installed version has {name}{inspect.signature(function)}, which "
            f"does not accept the expected arguments ({error}). Install the documented version."
        ) from error
    return function(*given, **named)


def as_model(
    made: Any, what: str, instance: Instance, size: SizePrior, *, up: Axis, to: Normal
) -> Model:
    """Convert the output for an instance to a model; ``what`` is the start of error messages.

    Raises:
        BackendError: the output is not a mesh, or is unusable.
    """
    if not isinstance(made, trimesh.Trimesh):
        raise BackendError(f"{what} the output is {type(made).__name__}, not a trimesh.Trimesh.")
    return foreign_model(normal_trimesh(made, what, up=up, to=to), instance, size)
