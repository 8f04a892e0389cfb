"""The grasp labels of a bundle: their values and their file, which is validated when read."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
from jaxtyping import Bool, Float, Int

from generator import bundle
from generator.errors import BundleError, InputError, require, require_seed
from generator.geometry import quaternion_matrix
from generator.io.bounded import is_number, parse_object, printable
from generator.io.files import write_whole
from generator.scene import Pose

from ..files import check_type
from ..robot import franka

FILE = "grasps.json"
"""File name of the labels in a bundle's folder."""

SCHEMA = 1
"""File format version; other versions are rejected."""

MOST_GRASPS, MOST_TRIALS = 1000, 1000
"""Maximum number of labels per object, and of trials per label."""

_MAX_FILE, _DEPTH = 64 * 2**20, 6
_FARTHEST = 10.0  # maximum distance of a grasp from the object's centre, metres
_COLUMNS = {"position": 3, "quaternion": 4, "width": 0, "opening": 0, "quality": 0, "lifted": 0}
_DIGITS = {"position": 6, "quaternion": 8, "width": 5, "opening": 5, "quality": 6, "lifted": 6}


@dataclass(frozen=True)
class GraspTerms:
    """Settings of the labels; the same settings give the same labels for a scene.

    Args:
        count: maximum number of labels per object, at most ``MOST_GRASPS``.
        trials: trials per label, at most ``MOST_TRIALS``. Quality is a share of them.
        directions: approach directions in addition to the six along the object's axes, spread
            evenly over the sphere.
        seed: seed for the rotation of the directions, and for the pose errors and friction of every
            trial.

    Raises:
        InputError: a number is out of range.
    """

    count: int = 24
    trials: int = 8
    directions: int = 12
    seed: int = 0

    def __post_init__(self) -> None:
        require(self, "count", minimum=1, maximum=MOST_GRASPS, integer=True)
        require(self, "trials", minimum=1, maximum=MOST_TRIALS, integer=True)
        require(self, "directions", minimum=0, maximum=1000, integer=True)
        require_seed(self.seed)
        for name in ("count", "trials", "directions", "seed"):  # NumPy integers are not JSON
            object.__setattr__(self, name, int(getattr(self, name)))


@dataclass(frozen=True, eq=False)
class GraspLabels:
    """The grasps of one object, best first.

    Attributes:
        position: the tool centre point in the object's frame, metres.
        quaternion: the hand's rotation in the object's frame, unit wxyz: +z approaches, +y opens.
        width: width between the closed fingers, metres; the planned width if no trial held.
        opening: opening of the fingers before the approach, metres.
        quality: share of the trials in which the object stayed in the hand to the end (closing,
            lift, turn and shake); in [0, 1].
        lifted: share of the trials in which the object was lifted; in [0, 1], at least ``quality``.

    Raises:
        InputError: the arrays' shapes do not match, or numbers are out of range.
    """

    position: Float[np.ndarray, "n 3"]
    quaternion: Float[np.ndarray, "n 4"]
    width: Float[np.ndarray, "n"]
    opening: Float[np.ndarray, "n"]
    quality: Float[np.ndarray, "n"]
    lifted: Float[np.ndarray, "n"]

    def __post_init__(self) -> None:
        for name, side in _COLUMNS.items():
            array = np.array(getattr(self, name), np.float64)
            array.setflags(write=False)
            object.__setattr__(self, name, array)
            shape = (len(self), side) if side else (len(self),)
            if array.shape != shape:
                raise InputError(f"GraspLabels.{name} must have shape {shape}, got {array.shape}.")
            if not np.isfinite(array).all():
                raise InputError(f"GraspLabels.{name} must be finite.")
        stroke = 2 * franka.FINGER_STROKE + 1e-6
        ranges = {"width": stroke, "opening": stroke, "quality": 1.0, "lifted": 1.0}
        for name, most in ranges.items():
            array = getattr(self, name)
            if ((array < 0) | (array > most)).any():
                raise InputError(f"GraspLabels.{name} must be in [0, {most:g}].")
        if (np.abs(self.position) > _FARTHEST).any():
            raise InputError(f"GraspLabels.position must be in [-{_FARTHEST:g}, {_FARTHEST:g}] m.")
        if (np.abs(np.linalg.norm(self.quaternion, axis=1) - 1) > 1e-4).any():
            raise InputError("GraspLabels.quaternion must have length 1.")

    def __len__(self) -> int:
        return len(self.position)

    def pick(self, which: Int[np.ndarray, "k"] | Bool[np.ndarray, "n"]) -> GraspLabels:
        """Return the labels of the grasps selected by indices or a mask."""
        return GraspLabels(**{name: getattr(self, name)[which] for name in _COLUMNS})

    def poses_at(self, pose: Pose) -> tuple[Float[np.ndarray, "n 3"], Float[np.ndarray, "n 3 3"]]:
        """Return the hand's positions (m) and rotations in the world for an object at ``pose``.

        Column 2 of a rotation is the approach direction, column 1 the opening direction.
        """
        turn = quaternion_matrix(pose.quaternion)
        hands = np.stack([quaternion_matrix(q) for q in self.quaternion] or [np.eye(3)])
        return self.position @ turn.T + pose.position, turn @ hands[: len(self)]


@dataclass(frozen=True)
class GraspFile:
    """The content of a bundle's label file: the grasp labels by object name, and their settings.

    ``scene`` is the sha256 of the bundle's ``scene.json``.
    """

    scene: str
    terms: GraspTerms
    versions: Mapping[str, str]
    labels: Mapping[str, GraspLabels]


def read_grasps(path: str | Path) -> Mapping[str, GraspLabels]:
    """Return a bundle's grasp labels by object name, or an empty dict if the bundle has no labels.

    Raises:
        BundleError: the bundle does not exist, or its labels are damaged, too large, or belong to
            another scene.
    """
    found = read_file(path)
    return found.labels if found else {}


def read_file(path: str | Path) -> GraspFile | None:
    """Return the validated content of a bundle's label file, or None if there is no such file.

    Raises:
        BundleError: see ``read_grasps``.
    """
    folder = Path(path)
    scene = bundle.load_fingerprint(folder)
    if not os.path.lexists(folder / FILE):
        return None
    raw = bundle.read_inside(folder, FILE, _MAX_FILE)
    advice = "Remove it, or label the bundle again (tabletopgen grasps --again)."
    try:
        payload = parse_object(raw, "It", BundleError, max_bytes=_MAX_FILE, max_depth=_DEPTH)
        if check_type(payload.get("schema"), int) != SCHEMA:
            raise ValueError(f"the schema is {payload['schema']}, not {SCHEMA}")
        found = _decode_file(payload)
    except (ValueError, TypeError, KeyError, BundleError, InputError) as error:
        raise BundleError(
            f"{folder}: {FILE} contains no valid labels ({type(error).__name__}: {error}). {advice}"
        ) from error
    if found.scene != scene:
        raise BundleError(f"{folder}: {FILE} was made for another scene. {advice}")
    return found


def write_file(folder: Path, file: GraspFile) -> None:
    """Write the labels of a bundle atomically.

    Raises:
        StorageError: the folder is not writable.
    """
    head = {
        "schema": SCHEMA,
        "scene": file.scene,
        "terms": asdict(file.terms),
        "versions": dict(file.versions),
    }
    lines = [f" {json.dumps(key)}: {json.dumps(head[key], sort_keys=True)}" for key in head]
    rows = [
        f"  {json.dumps(name)}: {json.dumps(encode_labels(labels), allow_nan=False)}"
        for name, labels in sorted(file.labels.items())
    ]
    lines.append(' "objects": {\n' + ",\n".join(rows) + "\n }")
    text = "{\n" + ",\n".join(lines) + "\n}\n"
    write_whole(folder / FILE, text, "The grasp labels", "Label a copy of the bundle.")


def encode_labels(labels: GraspLabels) -> dict[str, Any]:
    """Return the labels of an object as JSON values, with lengths rounded to a micrometre."""
    return {name: (getattr(labels, name).round(_DIGITS[name]) + 0.0).tolist() for name in _COLUMNS}


def decode_labels(entry: object) -> GraspLabels:
    """Decode the labels of an object from the JSON values of ``encode_labels``.

    Raises:
        ValueError, TypeError, KeyError, InputError: the values are invalid.
    """
    columns = check_type(entry, dict)
    if {*columns} != {*_COLUMNS}:
        raise ValueError(f"an object has missing or unexpected columns: {sorted(columns)[:8]}")
    if len(check_type(columns["width"], list)) > MOST_GRASPS:
        raise ValueError(f"an object has more than {MOST_GRASPS} grasps")
    return GraspLabels(**{name: _decode_column(columns[name], _COLUMNS[name]) for name in columns})


def _decode_column(values: object, side: int) -> Float[np.ndarray, "n *k"]:
    rows = check_type(values, list)
    if not side:
        return np.array([_number(value) for value in rows], np.float64)
    if any(len(check_type(row, list)) != side for row in rows):
        raise ValueError(f"a row must have {side} numbers")
    return np.array([[_number(v) for v in row] for row in rows], np.float64).reshape(-1, side)


def _number(value: object) -> float:
    if not is_number(value, minimum=-_FARTHEST, maximum=_FARTHEST):
        raise ValueError(f"{value!r:.40} is not a valid number")
    return float(cast("float", value))


def _decode_file(payload: dict[str, Any]) -> GraspFile:
    terms = check_type(payload["terms"], dict)
    names = ("count", "trials", "directions", "seed")
    asked = GraspTerms(**{name: check_type(terms[name], int) for name in names})
    known = {
        printable(k, "A package", BundleError): printable(v, "A version", BundleError)
        for k, v in check_type(payload["versions"], dict).items()
    }
    objects = check_type(payload["objects"], dict)
    if len(objects) > bundle.BOUNDS.objects:
        raise ValueError(f"the file lists more than {bundle.BOUNDS.objects} objects")
    labels = {
        printable(name, "An object", BundleError): decode_labels(entry)
        for name, entry in objects.items()
    }
    return GraspFile(check_type(payload["scene"], str), asked, known, labels)
