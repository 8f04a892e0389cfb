"""Records of finished jobs in the folder of a batch.

``.batch/<key>.json`` is the record of a job; its maker holds ``.batch/<key>.lock`` and works in
``.batch/<key>/``. The record is written when the bundle is complete, before the bundle is moved
into place. If a process dies in between, the next one finishes the move.
"""

from __future__ import annotations

import contextlib
import dataclasses
import json
import re
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
from filelock import FileLock, Timeout

from ..bundle import load_fingerprint, load_report, put_in_place
from ..errors import (
    BackendError,
    BudgetError,
    BundleError,
    DryRunError,
    InputError,
    StorageError,
)
from ..io.bounded import is_number, parse_object, read_regular
from ..io.files import is_plain_name, remove_file, remove_tree, write_whole
from .prompts import Job, Maker, key

_KEPT = frozenset({"InputError", "SceneError"})  # permanent failures, retried only on request

CRASH = "Crash"
"""Failure kind of a job whose process died."""

PLACE = ".batch"
"""Subfolder of a batch's folder with its records and its spending."""


def key_of(job: Job, make: Maker) -> str:
    """Return the name of a job's record; it depends on a picture's content if that can be read."""
    from ..method.reference import fetch, is_picture_name

    picture = None
    if is_picture_name(job.text):
        with contextlib.suppress(InputError):  # the maker will report the error
            content = fetch(job.text)
            picture = content if isinstance(content, bytes) else None
    return key(job, make.identity(), picture)


def place_of(folder: Path) -> Path:
    """Create a batch's folder and its record folder if missing; return the latter.

    Raises:
        StorageError: they cannot be created, or the record folder is a link.
    """
    place = folder / PLACE
    if place.is_symlink():
        raise StorageError(f"{place} is a link; the records of a batch must be in its own folder.")
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(
            f"The batch's folder {folder} cannot be created: {error.strerror or error}. Choose "
            "another folder."
        ) from error
    return place


def work(job: Job, folder: Path, make: Maker, retry: bool = False) -> Outcome:
    """Make a job's scene in ``folder``, unless it exists or another process is making it.

    ``retry`` also retries recorded permanent failures.

    Raises:
        StorageError: the folder is not writable, or the disk is full.
    """
    name, place = key_of(job, make), place_of(folder)
    try:
        with FileLock(place / f"{name}.lock", timeout=0):
            _put_in_place(job, folder, name)
            return find_outcome(job, folder, name, retry) or _make(job, folder, name, make)
    except Timeout:
        return Outcome(job, "busy")
    except StorageError:
        raise
    except OSError as error:
        raise StorageError(
            f"The batch's folder {folder} cannot be written: {error.strerror or error}. Free "
            "disk space, or choose another folder."
        ) from error


def find_outcome(job: Job, folder: Path, name: str, retry: bool = False) -> Outcome | None:
    """Return a job's recorded outcome if it is still valid, or None if the job must be run."""
    found = read(job, folder / PLACE, name)
    if found is None:
        return None
    kept = found.kind in _KEPT and not retry
    done = kept if found.bundle is None else _sound(folder / found.bundle)
    return found if done else None


def record_failure(
    job: Job, folder: Path, name: str, error: str, kind: str, seconds: float
) -> Outcome:
    """Record that a job failed and return its outcome."""
    # file names in messages may be invalid Unicode
    error = error.encode("utf-8", "backslashreplace").decode()
    outcome = Outcome(job, "failed", None, kind, error, round(seconds, 2))
    _write(outcome, folder, name)
    return outcome


def _make(job: Job, folder: Path, name: str, make: Maker) -> Outcome:
    """Make a job's scene; record any failure."""
    own = folder / PLACE / name
    _clear(folder / PLACE, name)
    start = time.perf_counter()
    try:
        made = make(job, own)
        report = load_report(made)
    except StorageError:
        raise
    except Exception as error:  # one failed scene must not end the batch
        spent, kind = time.perf_counter() - start, type(error).__name__
        # not recorded, since the scene did not fail
        if isinstance(error, BudgetError | DryRunError):
            return Outcome(job, "unpaid", None, kind, str(error), round(spent, 2))
        kind = "BackendError" if isinstance(error, BackendError) else kind
        return record_failure(job, folder, name, str(error), kind, spent)
    spent = round(time.perf_counter() - start, 2)
    outcome = Outcome(job, "made", made.name, seconds=spent, gate=_figures(report))
    _write(outcome, folder, name)
    _put_in_place(job, folder, name)
    if not _sound(folder / made.name):
        raise StorageError(
            f"The scene of {job.text!r:.80} was made, but its record or its bundle "
            f"{made.name!r:.80} cannot be read back from {folder}. Check that the disk works and "
            "that the bundle has not been renamed."
        )
    return outcome


def _put_in_place(job: Job, folder: Path, name: str) -> None:
    """Move a recorded bundle from its private folder to the batch's folder.

    An existing folder is replaced only if it is a damaged copy of the same bundle, by digest.
    """
    own = folder / PLACE / name
    found = None if own.is_symlink() or not own.is_dir() else read(job, folder / PLACE, name)
    if found is not None and found.bundle is not None:
        made, target = own / found.bundle, folder / found.bundle
        if not made.is_symlink() and _sound(made) and not _sound(target):
            put_in_place(made, target, lambda: _sound(target))
    _clear(folder / PLACE, name)


def _clear(place: Path, name: str) -> None:
    """Remove what an earlier attempt left behind; if it is a link, remove only the link itself."""
    own = place / name
    if own.is_symlink() or own.is_file():
        remove_file(place, name)
    else:
        remove_tree(place, name)


def _sound(bundle: Path) -> bool:
    """Return whether a bundle exists; it is complete, since it is published by a single rename."""
    try:
        load_fingerprint(bundle)
    except BundleError:
        return False
    return True


def _figures(report: Mapping[str, Any]) -> dict[str, float]:
    """Return the summary values of a bundle's gate report, in millimetres and degrees."""
    lengths = ("penetration", "drift", "leaning", "settling", "moved")
    return {
        "objects": report["objects"],
        **{f"{name}_mm": round(1e3 * report[name], 4) for name in lengths},
        "tilt_deg": round(float(np.rad2deg(report["tilt"])), 4),
        "left_out": len(report["dropped"]),
    }


def _write(outcome: Outcome, folder: Path, name: str) -> None:
    facts = dataclasses.asdict(outcome)
    del facts["state"]
    text = json.dumps({**facts.pop("job"), **facts}, indent=1, sort_keys=True) + "\n"
    path = folder / PLACE / f"{name}.json"
    write_whole(path, text, "The record of a scene", "Free disk space, or choose another folder.")


_MOST_BYTES = 2**20  # of a record, whose error text may be long
# the names that ``bundle.save`` gives
_BUNDLE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*-[0-9a-f]{12}")
_RECORDED = ("bundle", "kind", "error", "seconds", "gate")

State = Literal["made", "there", "failed", "unpaid", "busy"]


@dataclass(frozen=True)
class Outcome:
    """The outcome of a job.

    Attributes:
        job: the job.
        state: "made" in this run, "there" already, "failed", "unpaid" (a required call was not
            sent, because of the budget or a dry run), or "busy" (another process is making it).
        bundle: the name of its bundle, if there is one.
        kind: the class of the error, if it failed or is unpaid.
        error: the message of the error.
        seconds: how long it took to make the scene.
        gate: values of the recorded gate; see ``summary``.
    """

    job: Job
    state: State
    bundle: str | None = None
    kind: str | None = None
    error: str | None = None
    seconds: float = 0.0
    gate: Mapping[str, float] = field(default_factory=dict)


def read(job: Job, place: Path, name: str) -> Outcome | None:
    """Return a job's outcome from the record ``name``, or None if it is missing or invalid.

    ``bundle`` is then the plain name of a folder. ``gate`` is empty if the recorded values are not
    numbers.
    """
    path = place / f"{name}.json"
    try:
        raw = read_regular(path, "The record", StorageError, max_bytes=_MOST_BYTES)
        told = parse_object(raw, f"The record {path}", StorageError)
    except StorageError:
        return None
    facts = {key: told[key] for key in _RECORDED if key in told}
    found = Outcome(job, "failed" if facts.get("bundle") is None else "there", **facts)
    texts = all(text is None or isinstance(text, str) for text in (found.kind, found.error))
    named = found.bundle is None or (
        is_plain_name(found.bundle) and _BUNDLE.fullmatch(found.bundle)
    )
    if not (texts and named and is_number(found.seconds)):
        return None
    figures = isinstance(found.gate, dict) and all(
        is_number(value, minimum=-1e12) for value in found.gate.values()
    )
    return found if figures else replace(found, gate={})
