"""Where a batch's folder keeps what is no bundle: its records, and what it has spent."""

from __future__ import annotations

from pathlib import Path

from ..calls.money.budget import SharedBudget
from ..calls.money.prices import Prices
from ..errors import StorageError

PLACE = ".batch"
"""The folder within a batch's folder."""


def place_of(folder: Path) -> Path:
    """Return where a batch's folder keeps its records; both are made if missing.

    Raises:
        StorageError: they cannot be made, or the records are a link to elsewhere.
    """
    place = folder / PLACE
    if place.is_symlink():
        raise StorageError(f"{place} is a link; a batch keeps its records in its own folder.")
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(
            f"The batch's folder {folder} cannot be made: {error.strerror or error}. Choose "
            "another folder."
        ) from error
    return place


def shared_budget(folder: str | Path, prices: Prices | None = None) -> SharedBudget:
    """Return the budget that all batches in a folder spend from, begun if there is none.

    Raises:
        InputError: what was spent there is in another currency than ``prices``.
        StorageError: it cannot be read, or the folder not be written.
    """
    return SharedBudget.open(place_of(Path(folder)), (prices or Prices.default()).currency)
