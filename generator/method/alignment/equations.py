"""Eqs. 5 and 6: the anchor instance, and scales computed from top-view boxes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from jaxtyping import Float

from ...errors import SceneError
from ...geometry import rotated_extent, rotation_z
from ...scene import Mesh


def pixel_area_and_ratio_error(
    box: Float[np.ndarray, "4"], size: Float[np.ndarray, "3"], yaw: float
) -> tuple[float, float]:
    """Return A_px and epsilon_ratio of Eq. 5.

    A_px = w_img h_img and epsilon_ratio = |log r_phys - log r_img|, with r = width / height; r_phys
    is the ratio of the physical ``size`` (metres) after rotation by ``yaw`` and projection onto the
    XY-plane.
    """
    w_img, h_img = box[2] - box[0], box[3] - box[1]
    w_phys, h_phys = rotated_extent(np.asarray(size), yaw)
    error = abs(np.log(w_phys / h_phys) - np.log(w_img / h_img))
    return float(w_img * h_img), float(error)


def rma_score(area: float, ratio_error: float, tau: float = 0.25) -> float:
    """Return the Ratio-Matched and Area-Weighted Score, Eq. 6: A_px / (1 + (eps / tau)^2)."""
    return area / (1.0 + (ratio_error / tau) ** 2)


def select_anchor(scores: Mapping[str, float]) -> str:
    """Return the name with the highest RMA-Score, or the first of several with equal scores."""
    if not scores:
        raise SceneError("The top view shows no object from which its scale can be determined.")
    return max(scores, key=lambda name: scores[name])


def metres_per_pixel(
    box: Float[np.ndarray, "4"], size: Float[np.ndarray, "3"], yaw: float
) -> float:
    """Return alpha, the metres per top-view pixel: the square root of the anchor's area ratio."""
    w_phys, h_phys = rotated_extent(np.asarray(size), yaw)
    return float(np.sqrt(w_phys * h_phys / ((box[2] - box[0]) * (box[3] - box[1]))))


def own_extent(
    across: Float[np.ndarray, "2"], yaw: float, size: Float[np.ndarray, "3"]
) -> Float[np.ndarray, "3"]:
    """Return an object's extent along its own axes, derived from its axis-aligned top-view extent.

    Args:
        across: width and height of the box in the top view, metres (along world x and y).
        yaw: the object's yaw, radians.
        size: commonsense extent; supplies the proportions if the box does not determine them.

    The box is W = |cos| l + |sin| w, H = |sin| l + |cos| w. The inverse is used if it is
    well-conditioned (|cos 2 yaw| near 1) and agrees with the proportions of ``size`` to within a
    factor of 1.4. Otherwise, as near 45 degrees, these proportions are used. The height is scaled
    by the mean of the horizontal scales.
    """
    c, s = abs(np.cos(yaw)), abs(np.sin(yaw))
    box = rotated_extent(size, yaw)
    factor = float(np.sqrt(across.prod() / box.prod()))
    kept = size * factor
    det = c * c - s * s
    trust = float(np.clip((abs(det) - 0.3) / 0.5, 0.0, 1.0))
    if trust > 0:
        solved = np.array([c * across[0] - s * across[1], c * across[1] - s * across[0]]) / det
        change = np.log(np.maximum(solved, 1e-6) / kept[:2])
        if (solved > 0).all() and np.abs(change).max() < np.log(1.4):
            kept[:2] *= np.exp(trust * change)
    return kept


def rectangle_box(
    box: Float[np.ndarray, "4"], mesh: Mesh, size: Float[np.ndarray, "3"], yaw: float
) -> Float[np.ndarray, "4"]:
    """Return the top-view box of an object's rotated rectangle, given the box of its outline.

    Eqs. 5 and 6 project the box of the physical size. The top view shows the outline of the object
    itself. The box of this outline is smaller if the object is rotated (a mug by 45 degrees, say),
    and may be off-centre (because of the mug's handle). ``mesh`` is canonical, ``size`` in metres,
    ``yaw`` in radians.
    """
    points = mesh.vertices[:, :2] * size[:2] @ rotation_z(yaw)[:2, :2].T
    low, high = points.min(0), points.max(0)
    pixels = (box[2:] - box[:2]) / np.maximum(high - low, 1e-6)  # per metre, along u and v
    middle = (box[:2] + box[2:]) / 2 - (low + high) / 2 * [1, -1] * pixels
    half = rotated_extent(size, yaw) / 2 * pixels
    return np.concatenate([middle - half, middle + half])
