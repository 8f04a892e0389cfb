"""Poses estimated naively from the picture, which replace DRO and TSA in an ablation.

The paper (Sec. 4.3) uses a multimodal language model. This module reads masks and boxes directly;
it knows the camera's direction, but no perspective and no 3D models. Its results compare the stages
of this project with one another, not with the paper's Table 3.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float

from ...errors import InputError
from ...geometry import rotated_extent, rotation_z, wrap
from ...scene import TABLE, LayoutBox, View
from ..protocols import Instances, Sizes

_STEP = np.deg2rad(15.0)  # angles are rounded to this step
_LONG = 1.2  # ratio of a mask's axes above which it has a direction


def guess_rotations(instances: Instances, sizes: Sizes, view: View) -> dict[str, float]:
    """Return each object's yaw in radians; for a lying object, the direction of its mask.

    The mask's long axis is read in the picture as if it were a plan, without foreshortening, and
    rounded to 15 degrees; front and back are not distinguished. An object that is as tall as it is
    long, or that shows no direction, faces the camera.
    """
    return {
        i.name: wrap(view.azimuth + _turn(np.asarray(i.mask), sizes[i.name].extent))
        for i in instances
        if i.name != TABLE
    }


def guess_layout(instances: Instances, sizes: Sizes, view: View) -> dict[str, LayoutBox]:
    """Return typical sizes, and positions interpolated linearly in the table's bounding box.

    The far edge of the tabletop is the upper side of the table's box; its near edge follows from
    the table's proportions and the camera's elevation. An object's foot is the lower side of its
    own box, and its centre is half its typical width behind that. No object is placed beyond the
    tabletop.

    Raises:
        InputError: no instance is the table.
    """
    table = next((np.asarray(i.box) for i in instances if i.name == TABLE), None)
    if table is None:
        raise InputError("A layout needs a table, but the instances contain none.")
    # extent seen from the camera, in metres
    across = rotated_extent(sizes[TABLE].extent, -view.azimuth)
    scale = (table[2] - table[0]) / across[0]  # pixels per metre
    deep = min(scale * across[1] * np.sin(view.elevation), table[3] - table[1])
    half = sizes[TABLE].extent[:2] / 2
    places = {}
    for instance in instances:
        if instance.name == TABLE:
            continue
        box, size = np.asarray(instance.box), sizes[instance.name].extent
        right = ((box[0] + box[2]) - (table[0] + table[2])) / 2 / scale
        away = (0.5 - (box[3] - table[1]) / deep) * across[1] + size[:2].mean() / 2
        center = np.clip(rotation_z(view.azimuth)[:2, :2] @ [right, away], -half, half)
        places[instance.name] = LayoutBox(center, size)
    return places


def _turn(mask: Bool[np.ndarray, "h w"], extent: Float[np.ndarray, "3"]) -> float:
    """Return the yaw relative to the camera that a mask suggests, in (-pi/2, pi/2]."""
    rows, columns = np.nonzero(mask)
    if extent[2] >= extent[:2].max() or len(rows) < 3:
        return 0.0
    spread, axes = np.linalg.eigh(np.cov(np.stack([columns, -rows]).astype(float)))
    if spread[1] <= _LONG**2 * max(spread[0], 1e-9):
        return 0.0
    angle = float(np.arctan2(axes[1, 1], axes[0, 1]))
    if extent[1] > extent[0]:
        angle -= np.pi / 2
    turn = (round(angle / _STEP) * _STEP) % np.pi
    return float(turn - np.pi if turn > np.pi / 2 + 1e-9 else turn)
