"""The page of a study: one HTML file with all pictures and no method names."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from generator.errors import InputError, StorageError
from generator.io.files import check_target, write_whole

from .collection import RatedScene
from .design import SCHEMA, SECONDS_A_SCENE, StudyOptions, check_methods
from .key import KeyScene, StudyKey, read_key
from .page_data import fill


@dataclass(frozen=True)
class StudyFiles:
    """The page of a study as HTML, and its key."""

    page: str
    key: StudyKey


def make_study(
    scenes: Sequence[RatedScene], methods: Sequence[str], options: StudyOptions, template: str
) -> StudyFiles:
    """Create a study; equal scenes, methods, options and template give equal bytes.

    ``template`` is the built page, ``static/study.html``. In the page, codes stand for scenes and
    results, sorted by code. The position of a result in its scene determines its method, so the
    page can balance the display positions of the methods; only the key names them.

    Raises:
        InputError: the options do not fit the scenes, the title names a method, or the page is too
            large.
    """
    names = check_methods(methods)
    _check_title(options.title, names)
    count = options.scenes_of(len(scenes))
    coded = sorted((_code("s", options.seed, one.digest), one) for one in scenes)
    columns = sorted(names, key=lambda name: _code("c", options.seed, name, *_digests(scenes)))
    keyed = {
        code: KeyScene(one.name, one.digest, {
            _result_code(options.seed, one, method): method for method in columns
        }) for code, one in coded
    }  # fmt: skip
    least = SECONDS_A_SCENE * count if options.min_seconds is None else options.min_seconds
    key = StudyKey("", options.title, options.seed, names, count, options.attention, float(least),
                   keyed)  # fmt: skip
    shown = [_scene_facts(code, one, columns, options.seed) for code, one in coded]
    parts = key.text() + json.dumps([shown, options.post])
    key = replace(key, study=hashlib.sha256(parts.encode()).hexdigest()[:12])
    facts = {
        "schema": SCHEMA, "study": key.study, "title": options.title, "scenesEach": count,
        "attention": options.attention, "scenes": shown,
        "post": options.post and options.post.replace("{study}", key.study),
    }  # fmt: skip
    return StudyFiles(fill(template, facts), key)


def write_study(files: StudyFiles, out: Path) -> tuple[Path, Path]:
    """Write the page and, beside it, its key; return both paths.

    Raises:
        InputError: the key of another study exists, and its answers would be lost without it.
        StorageError: the files cannot be written; neither file remains.
    """
    key = key_path(out)
    for path in (out, key):
        check_target(path)
    new = not key.is_file()
    if not new and read_key(key).study != files.key.study:
        raise InputError(
            f"{str(key)!r} is the key of another study, whose answers cannot be read without that "
            "key. Choose another --out, or move the key."
        )
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{out.parent} cannot be created: {error.strerror or error}.") from error
    write_whole(key, files.key.text(), "The key", "Choose another --out.")
    try:
        write_whole(out, files.page, "The page", "Choose another --out.")
    except BaseException:
        if new:
            key.unlink(missing_ok=True)
        raise
    return out, key


def key_path(out: Path) -> Path:
    """Return the path of a page's key: ``FILE.key.json`` beside ``FILE.html``."""
    return out.with_suffix(".key.json")


def _check_title(title: str, methods: Sequence[str]) -> None:
    for name in methods:
        if re.search(rf"(?<!\w){re.escape(name.casefold())}(?!\w)", title.casefold()):
            raise InputError(
                f"The title {title!r} contains the name of the method {name!r}, which raters must "
                "not see. Choose another --title."
            )


def _digests(scenes: Sequence[RatedScene]) -> list[str]:
    return sorted(one.digest for one in scenes)


def _code(letter: str, seed: int, *parts: str) -> str:
    text = "\0".join([letter, str(seed), *parts])
    return letter + hashlib.sha256(text.encode()).hexdigest()[:10]


def _result_code(seed: int, scene: RatedScene, method: str) -> str:
    pictures = [hashlib.sha256(raw).hexdigest() for raw in scene.results[method]]
    return _code("r", seed, scene.digest, method, *pictures)


def _scene_facts(code: str, scene: RatedScene, columns: Sequence[str], seed: int) -> dict[str, Any]:
    """Return a scene's data for the page."""
    return {
        "id": code,
        "input": _data_url(scene.picture),
        "results": [
            {"id": _result_code(seed, scene, m), "views": [_data_url(v) for v in scene.results[m]]}
            for m in columns
        ],
    }


def _data_url(raw: bytes) -> str:
    return "data:image/jpeg;base64," + base64.b64encode(raw).decode()
