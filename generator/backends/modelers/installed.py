"""Models that run in this process where their repository is installed."""

from __future__ import annotations

import contextlib
import importlib
import inspect
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import trimesh

from ...errors import BackendError


def module(name: str, backend: str, how: str) -> ModuleType:
    """Import a module of a model's repository.

    Args:
        name: the module.
        backend: who needs it.
        how: how to install it, as a sentence.

    Raises:
        BackendError: it is not installed, or something that it needs is not.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise BackendError(
            f"{backend} needs {name}, which does not load ({error}). {how}"
        ) from error


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


@contextlib.contextmanager
def working(what: str) -> Iterator[None]:
    """Turn whatever a model raises into a BackendError that says what it worked on."""
    try:
        yield
    except BackendError:
        raise
    except Exception as error:
        said = " ".join(str(error).split())[:300]
        raise BackendError(f"{what} it failed ({type(error).__name__}: {said}).") from error


def only_mesh(made: Any, what: str) -> trimesh.Trimesh:
    """Return a model's answer if it is a mesh.

    Raises:
        BackendError: it is something else.
    """
    if not isinstance(made, trimesh.Trimesh):
        raise BackendError(f"{what} it made {type(made).__name__}, not a trimesh.Trimesh.")
    return made
