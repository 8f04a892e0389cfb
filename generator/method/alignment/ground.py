"""Top-view boxes derived from the reference picture, on a plane below its camera.

The plane is that of the tabletop. It is one unit below the camera, since a single picture has no
metric scale. If an object's model is rotated by its yaw and must match the object's box in the
picture, it can stand on that plane at only one size and position, which determine its top-view box.
Boxes are (left, far, right, near), +x right and +y towards the viewer as in a top view.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from jaxtyping import Float

from ...geometry import Camera, hull_points, rotation_z, view_rotation
from ...render.crop import in_reference, tight_box
from ...scene import TABLE, Instance, Model, Rotation, Stacking, View

_LEAST = 0.05  # minimum depth of an object's foot below the camera, as a fraction of its distance
_INSIDE = 0.2  # height of a container's contents above its foot, as a fraction of its height


def boxes_on_ground(
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    stacking: Mapping[str, Stacking],
    view: View,
    image_size: tuple[int, int],
) -> dict[str, Float[np.ndarray, "4"]]:
    """Return each object's top-view box, in units of the camera's height above the tabletop.

    Instances without a model, without visible pixels or above the camera's horizon are omitted.
    ``image_size`` is (width, height) of the reference picture.
    """
    eye = Camera(np.zeros(3), view_rotation(view), view.fov, *image_size)
    rank = {i.name: stacking.get(i.name, Stacking(2)) for i in instances if i.name != TABLE}
    shown = {i.name: i for i in instances if i.name in rank and i.name in models}
    boxes: dict[str, Float[np.ndarray, "4"]] = {}
    tops: dict[str, tuple[float, float]] = {}  # the heights of the objects' feet and tops
    for name in sorted(shown, key=lambda n: rank[n].order):
        low, high = tops.get(rank[name].on, (0.0, 0.0))
        floor = low + _INSIDE * (high - low) if rank[name].inside else high
        yaw = rotations[name].yaw if name in rotations else 0.0
        found = _stand(shown[name], models[name], yaw, floor, eye)
        if found is not None:
            boxes[name], tall = found
            tops[name] = floor, floor + tall
    return boxes


def table_on_ground(
    table: Instance, view: View, image_size: tuple[int, int]
) -> Float[np.ndarray, "3"] | None:
    """Return the positions of the tabletop's left, right and far ends in the tabletop's plane.

    Returns None if the picture's border cuts off one of the ends, or if no table is visible. The
    legs and the side of the tabletop lie below the plane and therefore appear nearer. They extend
    the outline only at the near end, which is not used.
    """
    mask = np.asarray(table.mask)
    rows, columns = np.nonzero(mask)
    if not len(rows) or mask[:, [0, -1]].any() or mask[0].any():
        return None
    eye = Camera(np.zeros(3), view_rotation(view), view.fov, *image_size)
    edge = hull_points(np.column_stack([columns, rows]).astype(float)) + 0.5
    points = eye.on_plane(edge, -1.0)
    points = points[np.isfinite(points).all(1) & (np.linalg.norm(points, axis=1) < 1 / _LEAST)]
    if len(points) < 3:
        return None
    return np.array([points[:, 0].min(), points[:, 0].max(), -points[:, 1].max()])


def _stand(
    thing: Instance, model: Model, yaw: float, floor: float, eye: Camera
) -> tuple[Float[np.ndarray, "4"], float] | None:
    """Return an object's top-view box and height, in units of the camera's height, or None."""
    import torch

    from ...render.soft import fit_center, object_to_camera

    if not (thing.crop[..., 3] > 127).any():
        return None
    box = in_reference(thing, tight_box(thing)).reshape(2, 2)
    corners = hull_points(np.asarray(model.mesh.vertices, float) * np.asarray(model.size))

    def tensor(array: object) -> torch.Tensor:
        return torch.tensor(np.asarray(array), dtype=torch.float64)[None]

    turn = object_to_camera(tensor(yaw), tensor(0.0), tensor(eye.rotation)[0])
    middle, span = (box.mean(0) - eye.center) / eye.focal, (box[1] - box[0]) / eye.focal
    center = fit_center(tensor(corners), turn, tensor(middle), tensor(np.maximum(span, 1e-6)))
    place = center[0].numpy() @ eye.rotation
    below = float(corners[:, 2].min() + place[2])
    if below > -_LEAST * float(np.linalg.norm(place)):
        return None
    unit = (1 - floor) / -below
    across = (corners[:, :2] @ rotation_z(yaw)[:2, :2].T + place[:2]) * unit * [1, -1]
    return np.concatenate([across.min(0), across.max(0)]), float(np.ptp(corners[:, 2])) * unit
