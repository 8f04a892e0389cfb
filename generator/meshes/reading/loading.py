"""A foreign mesh file read in a child process with limits, which hands back finished arrays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from types import MappingProxyType

from ...errors import BackendError
from ...sandbox import SandboxError, call
from .bounds import LIMITS, MOST_FACES
from .inspection import open_glb
from .surface import ColoredSurface, Kind, read_surface


def check_glb(raw: bytes, what: str) -> None:
    """Check, in a child process, that a GLB file can be read: one with compression, too.

    Raises:
        BackendError: it is not such a file; see ``inspection``.
    """
    with _explained(what):
        call(_open, raw, what, limits=LIMITS)


def _open(raw: bytes, what: str) -> None:
    open_glb(raw, what)


def load_surface(
    raw: bytes,
    what: str,
    kind: Kind,
    beside: Mapping[str, bytes] = MappingProxyType({}),
    most_faces: int = MOST_FACES,
) -> ColoredSurface:
    """Return everything in a GLB or OBJ file as one surface, read in a child process.

    Arguments, result and errors are those of ``read_surface``; the arrays are read-only.

    Raises:
        BackendError: the file cannot be read, or its reader reaches a limit.
    """
    with _explained(what):
        return call(
            read_surface, raw, what, kind, dict(beside), most_faces,
            limits=LIMITS, returns=(ColoredSurface,),
        )  # fmt: skip


@contextmanager
def _explained(what: str) -> Iterator[None]:
    try:
        yield
    except SandboxError as error:
        raise BackendError(
            f"{what} {error}. Export it again, with fewer triangles or smaller textures."
        ) from error
