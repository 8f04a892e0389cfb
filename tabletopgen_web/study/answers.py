"""Raters' answers, read from untrusted files; each excluded file is listed with the reason."""

from __future__ import annotations

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from generator.errors import InputError
from generator.io.bounded import is_number, parse_json, parse_object, read_regular

from .design import CRITERIA, LEVELS, SCHEMA
from .key import StudyKey

MAX_ANSWER_BYTES = 2**20
"""Maximum size of one rater's answers, in bytes; 200 scenes of 8 methods take less."""

MAX_FILE_BYTES = 16 * MAX_ANSWER_BYTES
"""Maximum size of a rater's list of answers from a studio, in bytes."""

_MAX_FILES = 5_000
_RATER = re.compile(r"[0-9a-f]{16}")
_LANGUAGE = re.compile(r"[a-z]{2,3}(-[A-Za-z]{2,8})?")
_MAX_SECONDS = 30 * 86400.0


@dataclass(frozen=True)
class SceneAnswers:
    """A rater's answers about a scene.

    ``order`` lists the methods in display order, ``ratings`` each method's scores in the order of
    ``CRITERIA``, and ``choice`` is the preferred method.
    """

    scene: str
    seconds: float
    order: tuple[str, ...]
    ratings: Mapping[str, tuple[int, ...]]
    choice: str


@dataclass(frozen=True)
class RaterAnswers:
    """All answers of one rater; ``failed`` is the number of failed attention checks.

    ``seconds`` is the time for which the page was visible.
    """

    rater: str
    language: str
    seconds: float
    scenes: tuple[SceneAnswers, ...]
    failed: int


@dataclass(frozen=True)
class Refusal:
    """An excluded file, and the reason."""

    file: str
    reason: str


def read_all(paths: Sequence[Path], key: StudyKey) -> tuple[list[RaterAnswers], list[Refusal]]:
    """Read answers from files and from folders' ``*.json`` files; also return excluded files.

    A rater counts once: duplicates of the same answers, in any language, are excluded; if a rater's
    answers differ between files, all of them are excluded, since none is known to be right. Raters
    are sorted by id.

    Raises:
        InputError: there are no files or too many, or a folder cannot be read.
    """
    files = [file for path in paths for file in _files(path)]
    if not files:
        raise InputError(
            "No answers were found. Pass files named answers-STUDY-RATER.json, or a folder that "
            "contains them."
        )
    if len(files) > _MAX_FILES:
        raise InputError(f"There are {len(files)} files of answers; the maximum is {_MAX_FILES}.")
    left: list[Refusal] = []
    by_rater: dict[str, list[tuple[Path, RaterAnswers]]] = defaultdict(list)
    for file in dict.fromkeys(files):
        try:
            raw = read_regular(file, "The file", InputError, max_bytes=MAX_FILE_BYTES)
            found = [parse_answers(each, key) for each in _split(raw)]
        except InputError as error:
            left.append(Refusal(str(file), str(error)))
        else:
            for answers in found:
                by_rater[answers.rater].append((file, answers))
    kept = [_once(found, left) for _, found in sorted(by_rater.items())]
    return [answers for answers in kept if answers is not None], left


def parse_answers(raw: bytes, key: StudyKey) -> RaterAnswers:
    """Parse and validate one rater's complete answers to the study of ``key``.

    Raises:
        InputError: the answers are invalid; the message gives the reason.
    """
    facts = parse_object(raw, "It", InputError, max_bytes=MAX_ANSWER_BYTES, max_depth=6)
    _expect(facts.get("schema") == SCHEMA, f"the file has schema {facts.get('schema')!r:.20}")
    _expect(
        facts.get("study") == key.study, f"the file belongs to study {facts.get('study')!r:.40}"
    )
    names = {"schema", "study", "rater", "language", "seconds", "scenes", "checks"}
    _expect(facts.keys() == names, "the file has missing or unexpected entries")
    rater, language = facts["rater"], facts["language"]
    _expect(_matches(_RATER, rater), "the rater must be 16 hexadecimal digits")
    _expect(_matches(_LANGUAGE, language), "the language is unknown")
    _expect(is_number(facts["seconds"], maximum=_MAX_SECONDS), "the duration is out of range")
    scenes = tuple(_scene(entry, key) for entry in _list(facts["scenes"], "scenes"))
    codes = [scene.scene for scene in scenes]
    _expect(len(set(codes)) == len(codes), "a scene occurs twice")
    _expect(
        len(codes) == key.scenes_each, f"the file rates {len(codes)} of {key.scenes_each} scenes"
    )
    failed = _count_failed(_list(facts["checks"], "checks"), codes, key)
    return RaterAnswers(rater, language, float(facts["seconds"]), scenes, failed)


def _split(raw: bytes) -> list[bytes]:
    """Return the answers in a file: one object, or a list of them from a studio."""
    if not raw.lstrip().startswith(b"["):
        return [raw]
    found = _list(parse_json(raw, "It", InputError), "answers")
    _expect(bool(found), "the list is empty")
    return [json.dumps(each).encode() for each in found]


def _files(path: Path) -> Iterable[Path]:
    try:
        return sorted(path.glob("*.json")) if path.is_dir() else [path]
    except OSError as error:
        raise InputError(f"{str(path)!r} cannot be read: {error.strerror or error}.") from error


def _once(found: Sequence[tuple[Path, RaterAnswers]], left: list[Refusal]) -> RaterAnswers | None:
    (first, answers), *others = found
    same = all(replace(other, language=answers.language) == answers for _, other in others)
    if same:
        left += [Refusal(str(p), f"rater {answers.rater} has the same answers in {first}")
                 for p, _ in others]  # fmt: skip
        return answers
    left += [Refusal(str(p), f"rater {answers.rater} has different answers in another file")
             for p, _ in found]  # fmt: skip
    return None


def _scene(entry: Any, key: StudyKey) -> SceneAnswers:
    _expect(isinstance(entry, dict), "a scene is not an object")
    _expect(entry.keys() == {"scene", "seconds", "order", "ratings", "choice"},
            "a scene has missing or unexpected entries")  # fmt: skip
    code = entry["scene"]
    scene = key.scenes.get(code) if isinstance(code, str) else None
    if scene is None:
        raise InputError(f"the file rates the unknown scene {code!r:.40}.")
    _expect(is_number(entry["seconds"], maximum=_MAX_SECONDS), "a scene's duration is out of range")
    order = _list(entry["order"], "order")
    _expect(all(isinstance(one, str) for one in order), "an order contains an invalid code")
    _expect(sorted(order) == sorted(scene.results),
            f"the displayed results of {code} do not match the study's")  # fmt: skip
    ratings = entry["ratings"]
    _expect(isinstance(ratings, dict) and ratings.keys() == scene.results.keys(),
            f"the rated results of {code} do not match the study's")  # fmt: skip
    choice = entry["choice"]
    _expect(isinstance(choice, str) and choice in scene.results,
            f"the preferred result of {code} is not in the study")  # fmt: skip
    return SceneAnswers(
        code,
        float(entry["seconds"]),
        tuple(scene.results[one] for one in order),
        {scene.results[one]: _marks(marks, code) for one, marks in ratings.items()},
        scene.results[choice],
    )


def _marks(marks: Any, code: str) -> tuple[int, ...]:
    _expect(isinstance(marks, dict) and marks.keys() == {*CRITERIA},
            f"the questions for {code} do not match the study's")  # fmt: skip
    _expect(all(_is_level(marks[c]) for c in CRITERIA), f"a score of {code} is not from 1 to 7")
    return tuple(marks[criterion] for criterion in CRITERIA)


def _count_failed(checks: Sequence[Any], codes: Sequence[str], key: StudyKey) -> int:
    _expect(
        len(checks) == key.attention,
        f"the file has {len(checks)} of {key.attention} attention checks",
    )
    for check in checks:
        _expect(isinstance(check, dict) and check.keys() == {"scene", "asked", "given"},
                "an attention check has missing or unexpected entries")  # fmt: skip
        _expect(_is_level(check["asked"]) and _is_level(check["given"]),
                "an attention check is not from 1 to 7")  # fmt: skip
    scenes = [check["scene"] for check in checks]
    _expect(all(isinstance(one, str) and one in codes for one in scenes)
            and len(set(scenes)) == len(scenes), "a check belongs to another scene")  # fmt: skip
    return sum(check["asked"] != check["given"] for check in checks)


def _is_level(value: Any) -> bool:
    return type(value) is int and value in LEVELS


def _matches(pattern: re.Pattern[str], value: Any) -> bool:
    return isinstance(value, str) and pattern.fullmatch(value) is not None


def _list(value: Any, what: str) -> list[Any]:
    _expect(isinstance(value, list), f"the {what} must be a list")
    return value


def _expect(fine: bool, reason: str) -> None:
    if not fine:
        raise InputError(f"{reason}.")
