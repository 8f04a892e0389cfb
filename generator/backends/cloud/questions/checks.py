"""A check by the chat model that a drawn top view shows each object exactly once."""

from __future__ import annotations

import numpy as np
from jaxtyping import UInt8

from ....geometry import Camera
from ....render.raster import Item, render
from ....render.sheet import grid
from ....scene import Mesh
from ..prompts import prompt
from ..server.answers import OrientationAnswer, TopViewAnswer
from ..server.json_text import Wrong
from ..server.typed_question import Chat
from .labelled import GRID, Labelled

_SAME = 0.85  # overlap from which two boxes count as the same place


def faults(chat: Chat, things: Labelled, drawn: UInt8[np.ndarray, "h w 3"]) -> tuple[str, ...]:
    """Return the faults of a drawn top view as sentences.

    Raises:
        BackendError: the model gave no usable answer.
    """

    def sentences(answer: TopViewAnswer) -> tuple[str, ...]:
        seen = things.match(answer.things, without=(0,)).values()
        _check_places([(a.id, np.array(box)) for a in seen for box in a.boxes])
        found = [] if answer.from_above else ["The view was not from straight above."]
        for sight in seen:
            called = f"The {things.by_number[sight.id].label} (number {sight.id})"
            if not sight.boxes and not sight.covered:
                found.append(f"{called} was missing.")
            elif len(sight.boxes) > 1:
                found.append(f"{called} appeared {len(sight.boxes)} times.")
        found += [
            f"There was a {word}, which does not belong in the picture." for word in answer.extra
        ]
        return tuple(found)

    text = prompt("check_top_view", listing=things.names())
    return chat.ask("top_view", text, (things.picture(), drawn), TopViewAnswer, sentences)


def _check_places(places: list[tuple[int, np.ndarray]]) -> None:
    """Raise Wrong if a box is invalid, or if two objects are in the same place."""
    for number, (x0, y0, x1, y1) in places:
        if not (x0 < x1 and y0 < y1):
            raise Wrong(
                f"a box of number {number} is invalid: it must be [x0, y0, x1, y1] with values "
                f"from 0 to {GRID}, x0 < x1 and y0 < y1."
            )
    for k, (one, a) in enumerate(places):
        for other, b in places[:k]:
            if one != other and _overlap(a, b) > _SAME:
                raise Wrong(f"numbers {other} and {one} must not have the same box; look again.")


def _overlap(a: np.ndarray, b: np.ndarray) -> float:
    """Return the intersection over union of two boxes."""
    low, high = np.maximum(a[:2], b[:2]), np.minimum(a[2:], b[2:])
    both = float(np.prod(np.maximum(high - low, 0)))
    return both / (float(np.prod(a[2:] - a[:2]) + np.prod(b[2:] - b[:2])) - both)


_SIDE = 224  # pixels per view
_DISTANCE = 12.0  # in half diagonals of the model, which gives hardly any perspective

_UP: dict[str, tuple[tuple[str, int], ...]] = {
    "+z": (),
    "-z": (("x", 180),),
    "+x": (("y", -90),),
    "-x": (("y", 90),),
    "+y": (("x", 90),),
    "-y": (("x", -90),),
}
"""For each axis, the rotation about a fixed axis, in degrees, that turns it upward."""

_VIEWS: dict[str, tuple[tuple[int, int, int], tuple[int, int, int]]] = {
    "+z": ((1, 0, 0), (0, 0, -1)),
    "-z": ((1, 0, 0), (0, 0, 1)),
    "+x": ((0, 1, 0), (-1, 0, 0)),
    "-x": ((0, -1, 0), (1, 0, 0)),
    "+y": ((-1, 0, 0), (0, -1, 0)),
    "-y": ((1, 0, 0), (0, 1, 0)),
}
"""For each axis that points to the camera: the direction to the right, and the view direction."""


def six_sides(mesh: Mesh) -> UInt8[np.ndarray, "h w 3"]:
    """Return a sheet of a mesh's six views, each labelled with the axis towards the camera."""
    middle = (mesh.bounds[0] + mesh.bounds[1]) / 2
    radius = float(np.linalg.norm(mesh.extent)) / 2
    item = Item(mesh.vertices - middle, mesh.faces, mesh.uv, mesh.texture, 0, mesh.opacity)
    fov = 2 * float(np.arctan(1.1 / _DISTANCE))
    views = []
    for right, forward in _VIEWS.values():
        ahead = np.array(forward, float)
        rows = np.stack([np.array(right, float), np.cross(ahead, right), ahead])
        camera = Camera(-ahead * _DISTANCE * radius, rows, fov, _SIDE, _SIDE)
        views.append(render([item], camera, shadows=False).image)
    return grid(views, tuple(_VIEWS), columns=3, cell=_SIDE + 16)


def turns(answer: OrientationAnswer) -> tuple[tuple[str, int], ...]:
    """Return the rotations that turn the axis ``up`` upwards and then the axis ``along`` to x.

    Raises:
        Wrong: both directions are on one axis.
    """
    if answer.up[1] == answer.along[1]:
        raise Wrong(f'"along" ({answer.along}) and "up" ({answer.up}) must be different axes.')
    steps = _UP[answer.up]
    lies = "xyz".index(answer.along[1])
    for axis, degrees in steps:
        if degrees % 180 and axis != "xyz"[lies]:
            lies = 3 - lies - "xyz".index(axis)
    return (*steps, ("z", 90)) if lies == 1 else steps
