"""What backends need that run models in this process: their imports, and their failures told."""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Iterator
from types import ModuleType

from ..errors import BackendError


def module(name: str, backend: str, how: str) -> ModuleType:
    """Import what a backend needs (BackendError: it does not load; ``how`` says what to do)."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise BackendError(
            f"{backend} needs {name}, which does not load ({error}). {how}"
        ) from error


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
