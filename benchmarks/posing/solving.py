"""Runs the rotation stage on a case and measures its errors."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from generator.backends.embedded.encoder import EmbeddedEncoder
from generator.evaluation.surfaces.symmetry import yaw_error
from generator.geometry import hull_points, mask_box, rotation_z
from generator.method.rotation import RotationConfig, optimise_rotation

from .cases import TurnCase, looking_camera

FIELDS = (
    "case", "config", "object", "order", "yaw_deg", "found_deg", "error_deg", "flip",
    "margin", "width_deg", "scale_error_percent", "cpu_seconds", "hidden",
    "elevation_off_deg", "azimuth_off_deg", "pixels", "apart", "dropped_symmetric",
    "dropped_alike", "dropped_other", "error",
)  # fmt: skip


@dataclass(frozen=True)
class SolvedPose:
    """Result of the stage: yaw in radians in the assumed world frame, its loss, and its certainty.

    ``margin`` and ``width`` are those of ``generator.scene.Rotation``.
    """

    yaw: float
    loss: float
    margin: float = 0.0
    width: float = float(np.pi)


def solve(case: TurnCase, config: str) -> SolvedPose:
    """Estimate the yaw of a case with the rotation stage, for settings given by name."""
    settings = RotationConfig.paper() if config == "paper" else RotationConfig()
    height, width = case.reference.image.shape[:2]
    found = optimise_rotation(
        case.model, case.instance, case.view, EmbeddedEncoder(), settings, (width, height),
        hidden=case.front if case.hidden else None,
    )  # fmt: skip
    return SolvedPose(found.yaw, found.loss, found.margin, found.width)


def implied_scale(case: TurnCase, yaw: float) -> float:
    """Return the scale of the assumed size at which the object, with this yaw, fits its crop.

    The object stands on the table as seen by the assumed camera; centre and area of its box match
    those of the visible mask.
    """
    camera = looking_camera(case.view)
    box = mask_box(np.asarray(case.instance.mask))
    shape = hull_points(case.model.mesh.vertices * case.model.size) @ rotation_z(yaw).T
    aim, area = (box[:2] + box[2:]) / 2, float(np.prod(box[2:] - box[:2]))
    factor, pixel = 1.0, aim
    for _ in range(30):
        foot = camera.on_plane(pixel[None], 0.0)[0]
        if not np.isfinite(foot).all():
            return float("nan")
        points = factor * (shape - [0, 0, shape[:, 2].min()]) + foot
        shown = camera.project(points)
        low, high = shown.min(0), shown.max(0)
        pixel = pixel + aim - (low + high) / 2
        factor *= float(np.sqrt(area / np.prod(high - low)))
    return factor


def camera_yaw_error(case: TurnCase, yaw: float) -> float:
    """Return the error of a yaw in the assumed world, degrees, modulo the symmetry.

    Both yaws are compared relative to the camera: a wrong assumed azimuth rotates the whole world,
    including the table, and no object relative to another.
    """
    true = case.yaw - _azimuth(case.camera.rotation)
    return yaw_error(yaw - case.view.azimuth, true, case.order)


def _azimuth(rotation: Float[np.ndarray, "3 3"]) -> float:
    return float(np.arctan2(rotation[0, 1], rotation[0, 0]))


def row_of(case: TurnCase, number: int, config: str) -> dict[str, Any]:
    """Solve a case and return its row of the table."""
    begin = time.process_time()
    found = solve(case, config)
    seconds = time.process_time() - begin
    error = camera_yaw_error(case, found.yaw)
    sizes = np.prod(case.model.size / case.true.size) ** (1 / 3)
    scale = implied_scale(case, found.yaw) * sizes
    box = case.instance.box
    elevation = float(np.arcsin(np.clip(-case.camera.rotation[2, 2], -1, 1)))
    reasons = [reason for _, reason in case.dropped]
    return start_of_row(number, config) | {
        "object": case.variant,
        "order": f"{case.order:g}",
        "yaw_deg": round(float(np.rad2deg(case.yaw)), 2),
        "found_deg": round(float(np.rad2deg(found.yaw)), 2),
        "error_deg": round(error, 3),
        "flip": int(case.order == 1 and error > 170),
        "margin": round(found.margin, 4),
        "width_deg": round(float(np.rad2deg(found.width)), 3),
        "scale_error_percent": round(100 * abs(float(scale) - 1), 2),
        "cpu_seconds": round(seconds, 2),
        "hidden": round(case.hidden, 3),
        "elevation_off_deg": round(_off(case.view.elevation, elevation), 2),
        "azimuth_off_deg": round(_off(case.view.azimuth, _azimuth(case.camera.rotation)), 2),
        "pixels": round(float((box[2:] - box[:2]).max())),
        "apart": round(case.apart, 3),
        "dropped_symmetric": reasons.count("symmetric"),
        "dropped_alike": reasons.count("alike"),
        "dropped_other": len(reasons) - reasons.count("symmetric") - reasons.count("alike"),
    }


def start_of_row(number: int, config: str) -> dict[str, Any]:
    """Return a row with only the identifiers of its case."""
    return dict.fromkeys(FIELDS, "") | {"case": number, "config": config}


def _off(believed: float, true: float) -> float:
    return float(np.rad2deg(believed - true))
