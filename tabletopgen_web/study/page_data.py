"""The built page filled with a study's data, and validation of such a page as an untrusted file.

A page is valid if filling the template with its data gives the same bytes. All code and markup of a
served page therefore come from the built page.
"""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from generator.errors import InputError
from generator.io.bounded import is_count, parse_object, printable, read_regular

from .answers import parse_answers
from .design import MAX_METHODS, MAX_SCENES, SCHEMA
from .key import CODE, STUDY, KeyScene, StudyKey

MARK = '<script id="study" type="application/json">null</script>'
"""Placeholder of the study's data in the built page."""

_BEFORE, _AFTER = MARK.split("null")
_CHARSET = '<meta charset="utf-8" />'
_SCRIPT = re.compile(r'<script type="module"[^>]*>(.*?)</script>', re.DOTALL)
_STYLE = re.compile(r"<style[^>]*>(.*?)</style>", re.DOTALL)
_PICTURE = re.compile(r"data:image/jpeg;base64,[A-Za-z0-9+/]++={0,2}")
_MAX_BYTES = 200 * 2**20  # maximum size of a written page
_MAX_READ = 64 * 2**20


@dataclass(frozen=True)
class StudyPage:
    """A validated page.

    Attributes:
        study: The study's id.
        content: The page, the bytes of its file.
        policy: The value of the header Content-Security-Policy.
        key: The public part of the study's key: its methods are numbers.
    """

    study: str
    content: bytes
    policy: str
    key: StudyKey

    def check(self, answers: Mapping[str, Any]) -> None:
        """Check that a rater's answers belong to this study and are complete.

        Raises:
            InputError: the answers are invalid; the message gives the reason.
        """
        try:
            parse_answers(json.dumps(answers).encode(), self.key)
        except InputError as error:
            raise InputError(f"The answers do not match the study: {error}") from error


def read_template() -> str:
    """Return the built page without a study.

    Raises:
        BackendError: the front end is missing and cannot be built.
    """
    from ..frontend import static_folder

    return (static_folder() / "study.html").read_text(encoding="utf-8")


def fill(template: str, facts: Mapping[str, Any]) -> str:
    """Fill the built page with a study's data and a security policy that allows only its code.

    Raises:
        InputError: the built page has no placeholder, or the result is too large.
    """
    if template.count(MARK) != 1 or template.count(_CHARSET) != 1:
        raise InputError(
            "The built page has no placeholder for a study's data. Run `make web` again."
        )
    data = json.dumps(facts, ensure_ascii=True, separators=(",", ":")).replace("<", "\\u003c")
    if len(data) > _MAX_BYTES:
        raise InputError(
            f"The page would have {len(data) >> 20} MiB; the maximum is {_MAX_BYTES >> 20}. Use "
            "a smaller --side or fewer scenes."
        )
    policy = _policy(template, posts=bool(facts["post"]))
    meta = f'<meta http-equiv="Content-Security-Policy" content="{policy}" />'
    page = template.replace(_CHARSET, f"{_CHARSET}\n    {meta}")
    return page.replace(MARK, f"{_BEFORE}{data}{_AFTER}")


def read_page(path: Path, template: str, post: str) -> StudyPage:
    """Read a page that ``study new`` created from ``template`` and that sends answers to ``post``.

    ``{study}`` in the path stands for the study's id.

    Raises:
        InputError: the file is not such a page; the message gives the reason and a remedy.
    """
    raw = read_regular(path, "The study's page", InputError, max_bytes=_MAX_READ)
    try:
        text = raw.decode()
    except ValueError:
        text = ""
    data = text.partition(_BEFORE)[2].partition(_AFTER)[0]
    if data in ("", "null"):
        raise InputError(
            f"{str(path)!r} is not the page of a study. Pass a file written by `tabletopgen study "
            f"new`."
        )
    try:
        facts = parse_object(data, "Its data", InputError, max_bytes=_MAX_READ)
        key = _blind_key(facts)
    except (InputError, AttributeError, KeyError, TypeError, ValueError) as error:
        raise InputError(
            f"{str(path)!r} contains no valid study ({error!s:.200}). Create it again with "
            "`tabletopgen study new`."
        ) from error
    if fill(template, facts) != text:
        raise InputError(
            f"{str(path)!r} differs from the output of this version's `tabletopgen study new`: it "
            f"was created by another version, or modified. Create it again with the same options."
        )
    if facts["post"] != post.replace("{study}", key.study):
        raise InputError(
            f"{str(path)!r} does not send its answers to the studio. Create it again with --post "
            f"'{post}'."
        )
    return StudyPage(key.study, raw, f"{_policy(template, posts=True)}; frame-ancestors 'none'",
                     key)  # fmt: skip


def _policy(template: str, *, posts: bool) -> str:
    return (
        "default-src 'none'; img-src data:; "
        f"script-src {_hashes(_SCRIPT, template)}; style-src {_hashes(_STYLE, template)}; "
        f"connect-src '{'self' if posts else 'none'}'; "
        "base-uri 'none'; form-action 'none'"
    )


def _hashes(element: re.Pattern[str], template: str) -> str:
    """Return the security policy's sources that allow the inline elements of the built page."""
    digests = [hashlib.sha256(text.encode()).digest() for text in element.findall(template)]
    return " ".join(f"'sha256-{base64.b64encode(d).decode()}'" for d in digests) or "'none'"


def _blind_key(facts: Mapping[str, Any]) -> StudyKey:
    if facts["schema"] != SCHEMA:
        raise ValueError(f"the schema is {facts['schema']!r:.20}, not {SCHEMA}")
    names = {"schema", "study", "title", "scenesEach", "attention", "scenes", "post"}
    scenes, each, attention = facts["scenes"], facts["scenesEach"], facts["attention"]
    if facts.keys() != names or not STUDY.fullmatch(facts["study"]):
        raise ValueError("the study has missing or unexpected entries")
    if not (isinstance(scenes, list) and 1 <= len(scenes) <= MAX_SCENES):
        raise ValueError(f"a study must have 1 to {MAX_SCENES} scenes")
    if not (is_count(each) and is_count(attention) and attention <= each <= len(scenes) and each):
        raise ValueError("the counts do not match the scenes")
    keyed = dict(_blind_scene(scene) for scene in scenes)
    columns = {tuple(one.results.values()) for one in keyed.values()}
    if len(keyed) < len(scenes) or len(columns) != 1:
        raise ValueError("the scenes do not have the same methods")
    title = printable(facts["title"], "title", InputError)
    return StudyKey(facts["study"], title, 0, columns.pop(), each, attention, 0.0, keyed)


def _blind_scene(scene: Mapping[str, Any]) -> tuple[str, KeyScene]:
    results = scene["results"]
    if not (isinstance(results, list) and 2 <= len(results) <= MAX_METHODS):
        raise ValueError(f"a scene must have 2 to {MAX_METHODS} results")
    codes = [scene["id"], *(one["id"] for one in results)]
    if not all(CODE.fullmatch(code) for code in codes) or len(set(codes)) < len(codes):
        raise ValueError("codes must be a letter and 10 hexadecimal digits, without repetition")
    views = [view for one in results for view in one["views"]]
    if not all(_PICTURE.fullmatch(picture) for picture in (scene["input"], *views)):
        raise ValueError("pictures must be embedded JPEG data")
    named = {one["id"]: str(k) for k, one in enumerate(results, 1)}
    return codes[0], KeyScene(codes[0], "0" * 64, named)
