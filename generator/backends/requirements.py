"""Requirements of backends that run models in this process: imports, folder, and errors."""

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
"""Environment variable that sets the folder of models, such as a Hugging Face cache (``hub``)."""


def module(name: str, backend: str, how: str) -> ModuleType:
    """Import a package for a backend.

    Raises:
        BackendError: the import fails; ``how`` is advice for the message.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise BackendError(
            f"{backend} needs {name}, which cannot be imported ({error}). {how}"
        ) from error


class Once(Generic[T]):
    """A value computed once, on first use, by whichever thread needs it first."""

    def __init__(self, make: Callable[[], T]) -> None:
        self._make, self._made, self._turn = make, list[T](), threading.Lock()

    def __call__(self) -> T:
        """Return the value."""
        with self._turn:
            if not self._made:
                self._made.append(self._make())
            return self._made[0]


@contextlib.contextmanager
def working(what: str) -> Iterator[None]:
    """Convert any exception of a model to a BackendError that names its task."""
    try:
        yield
    except BackendError:
        raise
    except Exception as error:
        said = " ".join(str(error).split())[:300]
        raise BackendError(f"{what} the model failed ({type(error).__name__}: {said}).") from error


def models_folder(given: str | Path | None = None) -> Path:
    """Return ``given``, the environment's folder, or the user's cache folder, in this order."""
    usual = Path(platformdirs.user_cache_dir("tabletopgen")) / "models"
    return Path(given or os.environ.get(MODELS) or usual).expanduser()
