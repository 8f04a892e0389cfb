"""Rotational symmetry of objects, determined from their renders rather than from the picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float

from .equations import contour_distance
from .objective import Candidates, Objective, Target

_TURNS = 24  # number of yaws that are compared with the first


def looks_round(
    close: Callable[[], Objective], suspects: Bool[np.ndarray, "s"], flat: float
) -> Bool[np.ndarray, "s"]:
    """Return which of the objects in ``suspects`` look almost the same from all sides.

    ``close`` is a function that makes the objective which renders them; it is called only if there
    are suspects.
    """
    if not suspects.any():
        return np.zeros_like(suspects)
    objective = close()
    changes = [turning_changes(objective, k) if s else np.inf for k, s in enumerate(suspects)]
    return np.array(changes) < flat


def looks_order(objective: Objective, number: int, yaw: float, flat: float) -> int:
    """Return an object's order of symmetry, 1 to 4: it looks the same after 1/order of a full turn.

    If the object is rotated from ``yaw`` (radians) by any multiple of that angle, its own render
    changes by less than ``flat``.
    """
    shares = np.array([0, 1 / 4, 1 / 3, 1 / 2, 2 / 3, 3 / 4])
    same = _changes(objective, number, yaw + 2 * np.pi * shares) < flat
    multiples = {4: (1, 3, 5), 3: (2, 4), 2: (3,)}
    return next((n for n, rows in multiples.items() if same[list(rows)].all()), 1)


def turning_changes(objective: Objective, number: int) -> float:
    """Return the largest change (Eq. 1) that rotation makes to a render, less sampling noise."""
    yaws = np.arange(_TURNS) * (2 * np.pi / _TURNS)
    return float(_changes(objective, number, yaws).max())


def _changes(
    objective: Objective, number: int, yaws: Float[np.ndarray, "n"]
) -> Float[np.ndarray, "n"]:
    """Return how much each render differs from the one at the first yaw, less sampling noise."""
    import torch

    # Half of the points render the first yaw; the other half render all yaws. The loss between the
    # two halves at the same yaw is the sampling noise.

    device = objective.middle.device
    yaw = torch.as_tensor(yaws, dtype=torch.float32, device=device)
    owner = torch.full((len(yaws),), number, device=device)
    poses = Candidates(owner, yaw, torch.zeros_like(yaw))
    still = Candidates(owner[:1], yaw[:1], poses.tilt[:1])
    one, other = (replace(objective, surface=objective.surface.thin(2, first)) for first in (0, 1))
    with torch.no_grad():
        drawn = one.render(still)
        whole, side = drawn.silhouette, drawn.silhouette.shape[-1] * objective.config.edge_unit
        distance = contour_distance(whole[0].cpu().numpy() > 0.5) / side
        features = objective.encoder.features(drawn.image)
        target = Target(
            drawn.image, whole, torch.as_tensor(distance, dtype=whole.dtype, device=device)[None],
            features, torch.ones_like(whole),
            tuple(torch.ones_like(level[:, 0]) for level in features),
            torch.zeros_like(objective.target.cut[:1]),
        )  # fmt: skip
        losses = other.compare(other.render(poses), target, torch.zeros_like(owner))
    return (losses - losses[0]).cpu().numpy()
