"""A model seen from six sides, and the quarter turns that an answer about them implies."""

from __future__ import annotations

import numpy as np
from jaxtyping import UInt8

from ....geometry import Camera
from ....render.raster import Item, render
from ....render.sheet import grid
from ....scene import Mesh
from ..server.answers import OrientationAnswer
from ..server.json_text import Wrong

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
"""The rotation about a fixed axis that turns each axis upward."""

_VIEWS: dict[str, tuple[tuple[int, int, int], tuple[int, int, int]]] = {
    "+z": ((1, 0, 0), (0, 0, -1)),
    "-z": ((1, 0, 0), (0, 0, 1)),
    "+x": ((0, 1, 0), (-1, 0, 0)),
    "-x": ((0, -1, 0), (1, 0, 0)),
    "+y": ((-1, 0, 0), (0, -1, 0)),
    "-y": ((1, 0, 0), (0, 1, 0)),
}
"""By the axis towards the camera: the axis to the right in the picture, and the camera's direction.
"""


def six_sides(mesh: Mesh) -> UInt8[np.ndarray, "h w 3"]:
    """Return a sheet of a mesh seen along each axis, labelled by the axis towards the camera."""
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
    """Return the steps that turn ``up`` upward, then ``along`` to x (Wrong: both are one axis)."""
    if answer.up[1] == answer.along[1]:
        raise Wrong(f'"along" is {answer.along}, but {answer.up} is up: they must be two axes.')
    steps = _UP[answer.up]
    lies = "xyz".index(answer.along[1])
    for axis, degrees in steps:
        if degrees % 180 and axis != "xyz"[lies]:
            lies = 3 - lies - "xyz".index(axis)
    return (*steps, ("z", 90)) if lies == 1 else steps
