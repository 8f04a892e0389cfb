"""Raters' answers, read as foreign files: what does not fit is left out, with a reason."""

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
"""Of one rater's answers; 200 scenes of 8 methods take less."""

MAX_FILE_BYTES = 16 * MAX_ANSWER_BYTES
"""Of a rater's list of answers, as a studio keeps them."""

_MAX_FILES = 5_000
_RATER = re.compile(r"[0-9a-f]{16}")
_LANGUAGE = re.compile(r"[a-z]{2,3}(-[A-Za-z]{2,8})?")
_MAX_SECONDS = 30 * 86400.0


@dataclass(frozen=True)
class SceneAnswers:
    """What a rater answered of a scene.

    ``order`` are the methods as they were shown, ``ratings`` each method's marks in the order of
    ``CRITERIA``, ``choice`` the preferred method.
    """

    scene: str
    seconds: float
    order: tuple[str, ...]
    ratings: Mapping[str, tuple[int, ...]]
    choice: str


@dataclass(frozen=True)
class RaterAnswers:
    """All answers of one rater; ``failed`` counts attention checks answered otherwise than asked.

    ``seconds`` is how long the page was looked at.
    """

    rater: str
    language: str
    seconds: float
    scenes: tuple[SceneAnswers, ...]
    failed: int


@dataclass(frozen=True)
class Refusal:
    """A file that does not count, and why."""

    file: str
    reason: str


def read_all(paths: Sequence[Path], key: StudyKey) -> tuple[list[RaterAnswers], list[Refusal]]:
    """Read answers of files, and of the ``*.json`` files in folders; return what was left out, too.

    A rater counts once: the same answers again, in whatever language, are left out, and answers
    that differ are left out all, since none of them is known to be the right one. Raters are in
    the order of their ids.

    Raises:
        InputError: there are no files, too many, or a folder cannot be read.
    """
    files = [file for path in paths for file in _files(path)]
    if not files:
        raise InputError("There are no answers. Name files answers-STUDY-RATER.json, or a folder.")
    if len(files) > _MAX_FILES:
        raise InputError(f"{len(files)} files of answers: at most {_MAX_FILES} are read.")
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
    """Return one rater's answers, complete and of this study.

    Raises:
        InputError: they are not; the message says why.
    """
    facts = parse_object(raw, "It", InputError, max_bytes=MAX_ANSWER_BYTES, max_depth=6)
    _expect(facts.get("schema") == SCHEMA, f"it has schema {facts.get('schema')!r:.20}")
    _expect(facts.get("study") == key.study, f"it is of study {facts.get('study')!r:.40}")
    names = {"schema", "study", "rater", "language", "seconds", "scenes", "checks"}
    _expect(facts.keys() == names, "its entries are not those of answers")
    rater, language = facts["rater"], facts["language"]
    _expect(_matches(_RATER, rater), "its rater is not 16 hexadecimal digits")
    _expect(_matches(_LANGUAGE, language), "its language is none")
    _expect(is_number(facts["seconds"], maximum=_MAX_SECONDS), "its seconds are out of range")
    scenes = tuple(_scene(entry, key) for entry in _list(facts["scenes"], "scenes"))
    codes = [scene.scene for scene in scenes]
    _expect(len(set(codes)) == len(codes), "a scene is there twice")
    _expect(len(codes) == key.scenes_each, f"it has {len(codes)} of {key.scenes_each} scenes")
    failed = _count_failed(_list(facts["checks"], "checks"), codes, key)
    return RaterAnswers(rater, language, float(facts["seconds"]), scenes, failed)


def _split(raw: bytes) -> list[bytes]:
    """Return the answers of a file: one object, or a list of them, which a studio keeps."""
    if not raw.lstrip().startswith(b"["):
        return [raw]
    found = _list(parse_json(raw, "It", InputError), "answers")
    _expect(bool(found), "its list holds no answers")
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
        left += [Refusal(str(p), f"rater {answers.rater} answers the same in {first}")
                 for p, _ in others]  # fmt: skip
        return answers
    left += [Refusal(str(p), f"rater {answers.rater} has different answers in another file")
             for p, _ in found]  # fmt: skip
    return None


def _scene(entry: Any, key: StudyKey) -> SceneAnswers:
    _expect(isinstance(entry, dict), "a scene is no object")
    _expect(entry.keys() == {"scene", "seconds", "order", "ratings", "choice"},
            "the entries of a scene are others")  # fmt: skip
    code = entry["scene"]
    scene = key.scenes.get(code) if isinstance(code, str) else None
    if scene is None:
        raise InputError(f"it rates the unknown scene {code!r:.40}.")
    _expect(is_number(entry["seconds"], maximum=_MAX_SECONDS), "a scene's seconds are out of range")
    order = _list(entry["order"], "order")
    _expect(all(isinstance(one, str) for one in order), "an order holds other than codes")
    _expect(sorted(order) == sorted(scene.results), f"the results shown of {code} are others")
    ratings = entry["ratings"]
    _expect(isinstance(ratings, dict) and ratings.keys() == scene.results.keys(),
            f"the results rated of {code} are others")  # fmt: skip
    choice = entry["choice"]
    _expect(isinstance(choice, str) and choice in scene.results,
            f"the result preferred of {code} is another")  # fmt: skip
    return SceneAnswers(
        code,
        float(entry["seconds"]),
        tuple(scene.results[one] for one in order),
        {scene.results[one]: _marks(marks, code) for one, marks in ratings.items()},
        scene.results[choice],
    )


def _marks(marks: Any, code: str) -> tuple[int, ...]:
    _expect(isinstance(marks, dict) and marks.keys() == {*CRITERIA},
            f"the questions answered of {code} are others")  # fmt: skip
    _expect(all(_is_level(marks[c]) for c in CRITERIA), f"a mark of {code} is not 1 to 7")
    return tuple(marks[criterion] for criterion in CRITERIA)


def _count_failed(checks: Sequence[Any], codes: Sequence[str], key: StudyKey) -> int:
    _expect(len(checks) == key.attention, f"it has {len(checks)} of {key.attention} checks")
    for check in checks:
        _expect(isinstance(check, dict) and check.keys() == {"scene", "asked", "given"},
                "the entries of a check are others")  # fmt: skip
        _expect(_is_level(check["asked"]) and _is_level(check["given"]), "a check is not 1 to 7")
    scenes = [check["scene"] for check in checks]
    _expect(all(isinstance(one, str) and one in codes for one in scenes)
            and len(set(scenes)) == len(scenes), "a check is of another scene")  # fmt: skip
    return sum(check["asked"] != check["given"] for check in checks)


def _is_level(value: Any) -> bool:
    return type(value) is int and value in LEVELS


def _matches(pattern: re.Pattern[str], value: Any) -> bool:
    return isinstance(value, str) and pattern.fullmatch(value) is not None


def _list(value: Any, what: str) -> list[Any]:
    _expect(isinstance(value, list), f"its {what} are no list")
    return value


def _expect(fine: bool, reason: str) -> None:
    if not fine:
        raise InputError(f"{reason}.")
