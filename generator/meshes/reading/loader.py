"""Reading of foreign mesh files in a child process that has limits and returns arrays."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import ParamSpec

from ...errors import BackendError
from ...sandbox import SandboxError, call
from .bounds import LIMITS
from .inspection import open_glb
from .surface import ColoredSurface, read_surface

P = ParamSpec("P")


def check_glb(raw: bytes, what: str) -> None:
    """Check, in a child process, that a GLB file, compressed or not, can be read.

    Raises:
        BackendError: the file cannot be read; see ``inspection``.
    """
    with _as_backend_error(what):
        call(_open, raw, what, limits=LIMITS)


def _open(raw: bytes, what: str) -> None:
    open_glb(raw, what)


@contextmanager
def _as_backend_error(what: str) -> Iterator[None]:
    try:
        yield
    except SandboxError as error:
        raise BackendError(
            f"{what} {error}. Export it again, with fewer triangles or smaller textures."
        ) from error


def _in_child(reader: Callable[P, ColoredSurface]) -> Callable[P, ColoredSurface]:
    """Return a reader that runs in a child process; the arrays that it returns are read-only.

    The reader also raises ``BackendError`` if the child process reaches a limit.
    """
    signature = inspect.signature(reader)

    @functools.wraps(reader)
    def load(*args: P.args, **kwargs: P.kwargs) -> ColoredSurface:
        given = signature.bind(*args, **kwargs)
        given.apply_defaults()
        with _as_backend_error(given.arguments["what"]):
            return call(reader, *given.args, limits=LIMITS, returns=(ColoredSurface,))

    return load


load_surface = _in_child(read_surface)
"""Read a whole GLB or OBJ file as one surface; see ``read_surface`` and ``_in_child``."""
