"""Calls of models whose repository is installed, whatever its version."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import trimesh

from ...errors import BackendError


def call(function: Callable[..., Any], backend: str, *given: Any, **named: Any) -> Any:
    """Call a function of a model whose signature other versions may have changed.

    Raises:
        BackendError: the installed version takes other arguments.
    """
    try:
        inspect.signature(function).bind(*given, **named)
    except TypeError as error:
        name = getattr(function, "__qualname__", type(function).__name__)
        raise BackendError(
            f"{backend}: the installed version has {name}{inspect.signature(function)}, and was to "
            f"be called otherwise ({error}). Install the version that the documentation names."
        ) from error
    return function(*given, **named)


def only_mesh(made: Any, what: str) -> trimesh.Trimesh:
    """Return a model's answer if it is a mesh.

    Raises:
        BackendError: it is something else.
    """
    if not isinstance(made, trimesh.Trimesh):
        raise BackendError(f"{what} it made {type(made).__name__}, not a trimesh.Trimesh.")
    return made
