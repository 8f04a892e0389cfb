"""What backends need that run models in this process: imports, their folder, readable failures."""

from __future__ import annotations

import contextlib
import importlib
import os
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Generic, TypeVar

import platformdirs

from ..errors import BackendError

T = TypeVar("T")

MODELS = "TABLETOPGEN_MODELS"
"""The environment's name for the folder; a cache of Hugging Face (``hub``) can be one."""


def module(name: str, backend: str, how: str) -> ModuleType:
    """Import what a backend needs (BackendError: it does not load; ``how`` says what to do)."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise BackendError(
            f"{backend} needs {name}, which does not load ({error}). {how}"
        ) from error


class Once(Generic[T]):
    """What is made when it is first asked for, once, whichever thread asks first."""

    def __init__(self, make: Callable[[], T]) -> None:
        self._make, self._made, self._turn = make, list[T](), threading.Lock()

    def __call__(self) -> T:
        """Return it."""
        with self._turn:
            if not self._made:
                self._made.append(self._make())
            return self._made[0]


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


def models_folder(given: str | Path | None = None) -> Path:
    """Return ``given``, else the environment's folder, else the one in this user's cache."""
    usual = Path(platformdirs.user_cache_dir("tabletopgen")) / "models"
    return Path(given or os.environ.get(MODELS) or usual).expanduser()
