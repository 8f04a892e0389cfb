"""Refused requests with specific HTTP statuses, and the statuses of other errors by type."""

from __future__ import annotations

from generator.errors import (
    BackendError,
    BundleError,
    InputError,
    MissingError,
    SceneError,
    StorageError,
    TabletopError,
)


class RefusedError(InputError):
    """A refused request: ``status`` is the HTTP status, and the message is one sentence."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


_STATUSES: tuple[tuple[type[TabletopError], int], ...] = (
    (MissingError, 404),
    (StorageError, 507),
    (InputError, 422),
    (BundleError, 422),
    (SceneError, 422),
    (BackendError, 422),
)


def status_of(error: TabletopError) -> int:
    """Return the HTTP status for an error."""
    if isinstance(error, RefusedError):
        return error.status
    return next((status for kind, status in _STATUSES if isinstance(error, kind)), 500)
