"""Raters' answers to studies, stored as one JSON file per rater."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from generator.errors import StorageError
from generator.io.bounded import parse_json, read_regular
from generator.io.files import make_private, write_whole

from ...study.answers import MAX_FILE_BYTES
from ..refusals import RefusedError

_NAME = re.compile(r"[a-z0-9-]{1,64}")
_MAX_RATERS, _MAX_STUDIES = 1000, 1000
_MAX_SHARED, _MAX_SHARED_BYTES = 8, 64 * 2**20  # answers per rater; bytes per study


@dataclass(frozen=True)
class AnswerBook:
    """The answers below a folder: ``<study>/<rater>.json``, each with a list of objects."""

    folder: Path

    def add(
        self, study: str, rater: str, answer: Mapping[str, Any], *, shared: bool = False
    ) -> int:
        """Add a rater's answer unless it exists; return the number of the rater's answers.

        ``shared`` marks answers that anyone with the study's address may have sent; their limit is
        lower.

        Raises:
            RefusedError: an id is invalid, or there are too many answers.
            StorageError: the file is not writable or damaged.
        """
        folder, path = self._find(study), self._path(study, rater)
        if not path.exists() and (
            (not folder.exists() and _count(self.folder) >= _MAX_STUDIES)
            or (folder.exists() and _count(folder) >= _MAX_RATERS)
        ):
            raise RefusedError(507, "The limit of raters or studies is reached; none can be added.")
        kept = self._read(path)
        if _text(answer) in map(_text, kept):
            return len(kept)
        kept.append(dict(answer))
        content = json.dumps(kept, ensure_ascii=False, indent=1).encode()
        if len(content) > MAX_FILE_BYTES or (shared and len(kept) > _MAX_SHARED):
            raise RefusedError(507, f"{rater} has sent too many answers; no more are accepted.")
        if shared and _size(folder, path) + len(content) > _MAX_SHARED_BYTES:
            raise RefusedError(507, "The study has too many answers; no more are accepted.")
        make_private(folder)
        write_whole(path, content, "The answer", "Free disk space.")
        return len(kept)

    def read(self, study: str) -> dict[str, list[Any]]:
        """Return the answers to a study, grouped by rater.

        Raises:
            RefusedError: the id is invalid.
            StorageError: a file is damaged.
        """
        folder = self._find(study)
        if not folder.is_dir():
            return {}
        paths = sorted(p for p in folder.glob("*.json") if _NAME.fullmatch(p.stem))
        return {path.stem: self._read(path) for path in paths}

    def _find(self, study: str) -> Path:
        return self.folder / _check(study, "study")

    def _path(self, study: str, rater: str) -> Path:
        return self._find(study) / f"{_check(rater, 'rater')}.json"

    def _read(self, path: Path) -> list[Any]:
        if not path.exists():
            return []
        raw = read_regular(path, "The answers", StorageError, max_bytes=MAX_FILE_BYTES)
        found = parse_json(raw, f"{path}", StorageError)
        if not isinstance(found, list):
            raise StorageError(f"{path} is not a list of answers. The file is unchanged.")
        return found


def _check(name: object, what: str) -> str:
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise RefusedError(422, f"{what} must be 1 to 64 of the characters a-z, 0-9 and -.")
    return name


def _count(folder: Path) -> int:
    return sum(1 for _ in folder.iterdir())


def _size(folder: Path, but: Path) -> int:
    """Return the size in bytes of a folder's files except ``but``, or 0 if there is no folder."""
    paths = [path for path in folder.iterdir() if path != but] if folder.is_dir() else []
    return sum(path.stat().st_size for path in paths)


def _text(answer: Any) -> str:
    return json.dumps(answer, sort_keys=True)
