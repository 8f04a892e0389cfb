"""Conversion between the paper's JSON (Figs. 12 and 14) and placements in this project's frame.

The paper uses centimetres and degrees, with +x left and +y toward the viewer; this project uses
metres and radians, with +x right and +y away. The two frames differ by a half turn about z. A
model's canonical axes turn with the frame, so yaw is unchanged: only x and y change sign.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, cast

import numpy as np

from ..errors import InputError, require_number
from . import Placement

_FRAME = np.array([-1.0, -1.0, 1.0]) / 100.0


def from_paper(
    rotations: Mapping[str, float], alignment: Mapping[str, Any]
) -> tuple[tuple[Placement, ...], str | None]:
    """Convert the paper's DRO (Fig. 12) and TSA (Fig. 14) outputs to placements.

    Args:
        rotations: yaw in degrees by name, e.g. ``{"toy car_1": 29.72}``.
        alignment: ``{"anchor_object": ..., "objects": {name: {"scale", "translation"}}}`` in cm.

    Returns:
        The placements of the objects in ``alignment``, in the same order, and the anchor's name.
        Spaces in names become underscores (the paper prints both forms).

    Raises:
        InputError: An object has no rotation, or a field is missing or malformed.
    """
    given, answer = _mapping(rotations), _mapping(alignment)
    objects = None if answer is None else _mapping(answer.get("objects", {}))
    if given is None or answer is None or objects is None:
        raise InputError(
            'Rotations must be {name: degrees}, and alignments {"objects": {name: {"scale", '
            '"translation"}}}.'
        )
    yaws = {_plain(name): degrees for name, degrees in given.items()}
    placements = tuple(_placement(_plain(raw), entry, yaws) for raw, entry in objects.items())
    anchor = answer.get("anchor_object")
    return placements, None if anchor is None else _plain(anchor)


def _mapping(value: object) -> Mapping[str, Any] | None:
    return cast("Mapping[str, Any]", value) if isinstance(value, Mapping) else None


def _plain(name: object) -> str:
    return str(name).replace(" ", "_")


def _placement(name: str, entry: Any, yaws: Mapping[str, Any]) -> Placement:
    if name not in yaws:
        raise InputError(f"No rotation for {name!r}; rotations are given for {sorted(yaws)}.")
    require_number(f"The rotation of {name!r}", yaws[name])
    try:
        translation = np.asarray(entry["translation"], float) * _FRAME
        scale = np.asarray(entry["scale"], float) / 100.0
    except (KeyError, TypeError, ValueError, OverflowError, IndexError) as error:
        raise InputError(
            f"{name!r} needs 'scale' and 'translation', three numbers each, in cm."
        ) from error
    return Placement(name, float(np.deg2rad(float(yaws[name]))), translation, scale)


def to_paper(
    placements: Iterable[Placement], anchor: str | None = None
) -> tuple[dict[str, float], dict[str, Any]]:
    """Convert placements to the paper's two JSON objects; the inverse of :func:`from_paper`."""
    rotations: dict[str, float] = {}
    objects: dict[str, Any] = {}
    for p in placements:
        rotations[p.name] = round(float(np.rad2deg(p.yaw)) % 360.0, 6)
        objects[p.name] = {
            "scale": np.round(p.scale * 100.0, 6).tolist(),
            "translation": (np.round(p.translation / _FRAME, 6) + 0.0).tolist(),
        }
    return rotations, {"anchor_object": anchor, "objects": objects}
