"""The key of a study: the method behind each code. The experimenter keeps it private."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from generator.errors import InputError
from generator.io.bounded import is_count, is_number, parse_object, printable, read_regular

from .design import SCHEMA, check_methods

CODE = re.compile(r"[a-z][0-9a-f]{10}")
"""Pattern of the codes that stand for scenes and results in the page."""

STUDY = re.compile(r"[0-9a-f]{12}")

_MAX_BYTES = 4 * 2**20


@dataclass(frozen=True)
class KeyScene:
    """A scene of a study: its name, and the method of each result by code."""

    name: str
    digest: str
    results: Mapping[str, str]


@dataclass(frozen=True)
class StudyKey:
    """The private key of a study; ``scenes`` maps the codes of scenes to their data."""

    study: str
    title: str
    seed: int
    methods: tuple[str, ...]
    scenes_each: int
    attention: int
    min_seconds: float
    scenes: Mapping[str, KeyScene]

    def text(self) -> str:
        """Return the key as JSON; equal keys give equal bytes."""
        facts = {
            "schema": SCHEMA, "study": self.study, "title": self.title, "seed": self.seed,
            "methods": list(self.methods), "scenes_each": self.scenes_each,
            "attention": self.attention, "min_seconds": self.min_seconds,
            "scenes": {
                code: {"name": s.name, "input_sha256": s.digest, "results": dict(s.results)}
                for code, s in self.scenes.items()
            },
        }  # fmt: skip
        return json.dumps(facts, indent=1, ensure_ascii=False) + "\n"


def read_key(path: Path) -> StudyKey:
    """Read a study's key.

    Raises:
        InputError: the file cannot be read, or is not a key.
    """
    raw = read_regular(path, "The key", InputError, max_bytes=_MAX_BYTES)
    facts = parse_object(raw, f"The key {str(path)!r}", InputError)
    try:
        return _key(facts)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise InputError(
            f"{str(path)!r} is not the key of a study ({error!s:.200}). `tabletopgen study new` "
            "writes it as FILE.key.json beside FILE.html."
        ) from error


def _key(facts: Mapping[str, Any]) -> StudyKey:
    if facts["schema"] != SCHEMA:
        raise ValueError(f"the schema is {facts['schema']!r:.20}, not {SCHEMA}")
    methods = check_methods(facts["methods"])
    counts = facts["seed"], facts["scenes_each"], facts["attention"]
    if not (type(facts["seed"]) is int and all(map(is_count, counts[1:]))):
        raise ValueError("seed, scenes_each and attention must be integers")
    if not is_number(facts["min_seconds"]):
        raise ValueError("min_seconds must be a number")
    if not STUDY.fullmatch(facts["study"]):
        raise ValueError("study must be 12 hexadecimal digits")
    scenes = {code: _scene(code, scene, methods) for code, scene in facts["scenes"].items()}
    if not 1 <= facts["scenes_each"] <= len(scenes):
        raise ValueError("scenes_each must be from 1 to the number of scenes")
    title = printable(facts["title"], "title", InputError)
    return StudyKey(facts["study"], title, counts[0], methods, counts[1], counts[2],
                    float(facts["min_seconds"]), scenes)  # fmt: skip


def _scene(code: str, facts: Mapping[str, Any], methods: tuple[str, ...]) -> KeyScene:
    results = facts["results"]
    if not all(CODE.fullmatch(one) for one in (code, *results)):
        raise ValueError("codes must be a letter and 10 hexadecimal digits")
    if sorted(results.values()) != sorted(methods):
        raise ValueError("each scene must have one result for each method")
    name = printable(facts["name"], "name", InputError)
    if not re.fullmatch("[0-9a-f]{64}", facts["input_sha256"]):
        raise ValueError("input_sha256 must be 64 hexadecimal digits")
    return KeyScene(name, facts["input_sha256"], dict(results))
