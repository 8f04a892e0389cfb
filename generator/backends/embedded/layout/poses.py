"""Poses guessed by a naive look at the picture: what stands in for DRO and TSA in an ablation.

The paper (Sec. 4.3) asks a multimodal language model. This is a plain reading of masks and boxes
that knows the camera's direction but no perspective and no 3D models: its figures compare the
stages of this project with one another, not with the paper's Table 3.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float

from ....errors import InputError
from ....geometry import rotated_extent, rotation_z, wrap
from ....scene import TABLE, LayoutBox, View
from ...protocols import Instances, Sizes

_STEP = np.deg2rad(15.0)  # angles are told in such steps
_LONG = 1.2  # ratio of a mask's axes from which it has a direction


def guess_rotations(instances: Instances, sizes: Sizes, view: View) -> dict[str, float]:
    """Return each thing's yaw, radians: of what lies, the direction of its mask's long axis.

    The axis is read in the picture as if it were a plan, without foreshortening, and rounded to 15
    degrees; which end is the front is not told. What is as tall as it is long, or shows no
    direction, faces the camera.
    """
    return {
        i.name: wrap(view.azimuth + _turn(np.asarray(i.mask), sizes[i.name].extent))
        for i in instances
        if i.name != TABLE
    }


def guess_layout(instances: Instances, sizes: Sizes, view: View) -> dict[str, LayoutBox]:
    """Return each thing's place by linear interpolation in the table's box, and its usual size.

    The far edge of the tabletop is the upper side of the table's box, its near edge where the
    table's proportions and the camera's elevation put it. A thing's foot is the lower side of its
    own box, and its middle half its usual width behind that. Nothing is put beyond the tabletop.

    Raises:
        InputError: no instance is the table.
    """
    table = next((np.asarray(i.box) for i in instances if i.name == TABLE), None)
    if table is None:
        raise InputError("A layout is told on a table; the instances hold none.")
    across = rotated_extent(sizes[TABLE].extent, -view.azimuth)  # as the camera sees it, metres
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
    """Return the yaw against the camera's own right that a mask suggests, in (-pi/2, pi/2]."""
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
