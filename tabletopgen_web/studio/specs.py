"""Job requests: JSON objects with known fields, parsed into dataclasses."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from textwrap import shorten
from typing import Any, cast, get_args

from generator.backends import Mix
from generator.backends.select import PROTOCOLS, TABLE
from generator.errors import InputError
from generator.scene import Density, EditKind
from tabletopgen_env.tasks.names import NAMES

from ..page.options import PageFormat
from .contracts import JobKind
from .fields import Fields

FORMATS: tuple[str, ...] = get_args(PageFormat)
"""Export formats of scenes."""

_LONGEST_TITLE = 120

MOST_TEXT = 4000
"""Maximum number of characters of a description."""

SCENE_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,79}-[0-9a-f]{12}")
"""A scene's id: the name of its bundle's folder."""

PICTURE_ID = re.compile(r"[0-9a-f]{32}")

_MAX_BUDGET = 1e6
_FAR = 10.0  # maximum distance from a table's centre, metres
_EDITS = {
    "swap": "words [NAME, WHAT]",
    "add": "words [WHAT AND WHERE]",
    "remove": "words [NAME]",
    "move": "words [NAME, WHERE], or [NAME] with to or turn",
    "restyle": "words [STYLE, NAME, ...]",
}


@dataclass(frozen=True)
class Paid:
    """The backends of a job, and its cost limit (None for no limit)."""

    mix: Mix
    budget: float | None = None


@dataclass(frozen=True)
class GenerateSpec:
    """A scene generated from a prompt or an uploaded picture with the full method."""

    text: str | None
    picture: str | None
    seed: int
    name: str | None
    paid: Paid


@dataclass(frozen=True)
class ComposeSpec:
    """A scene composed of catalogue objects directly from a prompt."""

    text: str
    seed: int
    density: Density | None
    name: str | None


@dataclass(frozen=True)
class EditSpec:
    """An edit of a scene; without ``paid.mix``, new objects come from the catalogue."""

    scene: str
    action: EditKind
    words: tuple[str, ...]
    to: tuple[float, float] | None
    turn: float | None
    seed: int
    paid: Paid


@dataclass(frozen=True)
class EpisodeSpec:
    """An episode of a task in a scene, played by the scripted expert."""

    scene: str
    task: str
    seed: int


@dataclass(frozen=True)
class ExportSpec:
    """A scene in the format of another program."""

    scene: str
    format: str


JobSpec = GenerateSpec | ComposeSpec | EditSpec | EpisodeSpec | ExportSpec


def read_spec(payload: object) -> JobSpec:
    """Return the job described by a JSON object.

    Raises:
        InputError: a field is missing, unknown, has another type or is out of range.
        BackendError: a role's backend is unknown.
        SceneError: the scene's name is invalid.
    """
    fields = Fields(payload, "A job")
    kind = fields.choice("kind", get_args(JobKind))
    spec = _READERS[kind](fields)
    fields.end()
    return spec


def title_of(spec: JobSpec) -> str:
    """Return a short title of a job."""
    if isinstance(spec, GenerateSpec):
        return shorten(spec.text or "a picture", _LONGEST_TITLE, placeholder=" …")
    if isinstance(spec, ComposeSpec):
        return shorten(spec.text, _LONGEST_TITLE, placeholder=" …")
    if isinstance(spec, EditSpec):
        place = "" if spec.to is None else f" to {spec.to[0]:g} {spec.to[1]:g}"
        turn = "" if spec.turn is None else f" turned {spec.turn:g}°"
        words = f"{spec.action} {' '.join(spec.words)}{place}{turn}"
        return shorten(words, _LONGEST_TITLE, placeholder=" …")
    if isinstance(spec, EpisodeSpec):
        return f"{spec.task} on {spec.scene}"
    return f"{spec.scene} as {spec.format}"


def scene_of(spec: JobSpec) -> str | None:
    """Return the id of the job's input scene, if any."""
    return None if isinstance(spec, GenerateSpec | ComposeSpec) else spec.scene


def _read_generate(fields: Fields) -> GenerateSpec:
    text = fields.optional_text("text", MOST_TEXT, multiline=True)
    picture = _identifier(fields, "picture", PICTURE_ID, "an uploaded picture")
    if (text is None) == (picture is None):
        raise InputError("generate requires either text or picture.")
    return GenerateSpec(text, picture, fields.seed(), _read_name(fields), _read_paid(fields, True))


def _read_compose(fields: Fields) -> ComposeSpec:
    text = fields.text("text", MOST_TEXT, multiline=True)
    density = cast("Density | None", fields.optional_choice("density", get_args(Density)))
    return ComposeSpec(text, fields.seed(), density, _read_name(fields))


def _read_edit(fields: Fields) -> EditSpec:
    from generator.editing.edits import WordedEdit

    scene, action = _scene(fields), cast("EditKind", fields.choice("action", get_args(EditKind)))
    words = fields.texts("words", 99, 400)
    to, turn = fields.pair("to", _FAR), fields.number("turn", -360, 360)
    seed, paid = fields.seed(), _read_paid(fields, False)
    if not WordedEdit(action, words, to, turn, seed).is_complete:
        raise InputError(f"{action} requires {_EDITS[action]}; only move accepts to and turn.")
    return EditSpec(scene, action, words, to, turn, seed, paid)


def _read_episode(fields: Fields) -> EpisodeSpec:
    return EpisodeSpec(_scene(fields), fields.choice("task", NAMES), fields.seed())


def _read_export(fields: Fields) -> ExportSpec:
    return ExportSpec(_scene(fields), fields.choice("format", FORMATS))


_READERS: Mapping[str, Any] = {
    "generate": _read_generate,
    "compose": _read_compose,
    "edit": _read_edit,
    "episode": _read_episode,
    "export": _read_export,
}


def _identifier(fields: Fields, name: str, shape: re.Pattern[str], what: str) -> str | None:
    found = fields.optional_text(name, 120)
    if found is not None and not shape.fullmatch(found):
        raise InputError(f"{name} must be the id of {what}.")
    return found


def _scene(fields: Fields) -> str:
    found = _identifier(fields, "scene", SCENE_ID, "a scene")
    if found is None:
        raise InputError("The job must have the field scene, the id of a scene.")
    return found


def _read_name(fields: Fields) -> str | None:
    from generator.bundle import check_name

    name = fields.optional_text("name", 80)
    if name is not None:
        check_name(name)
    return name


def _read_paid(fields: Fields, always: bool) -> Paid:
    """Read the backends and the cost limit; with ``always``, default to the embedded backend."""
    from generator.backends.select import check_names

    names = {name: fields.optional_choice(name, TABLE) for name in ("backend", *PROTOCOLS)}
    if always and names["backend"] is None:
        names["backend"] = "embedded"
    mix = Mix(**names)
    check_names(mix.default, mix.roles())
    return Paid(mix, fields.number("budget", 0, _MAX_BUDGET))
