"""Which sides of an object look the same, judged by its own renders, not by the picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float

from .equations import contour_distance
from .objective import Candidates, Objective, Target

_TURNS = 24  # yaws compared with the first


def looks_round(
    close: Callable[[], Objective], suspects: Bool[np.ndarray, "s"], flat: float
) -> Bool[np.ndarray, "s"]:
    """Tell which suspects look the same from all sides: those that turning changes too little.

    ``close`` makes the objective that draws them; it is called only if there are suspects.
    """
    if not suspects.any():
        return np.zeros_like(suspects)
    objective = close()
    changes = [turning_changes(objective, k) if s else np.inf for k, s in enumerate(suspects)]
    return np.array(changes) < flat


def looks_order(objective: Objective, number: int, yaw: float, flat: float) -> int:
    """Return by what share of a whole turn, 1 over 1 to 4, an object turns and looks the same.

    Turned from ``yaw`` (radians) by any number of these, its own render changes by less than
    ``flat``.
    """
    shares = np.array([0, 1 / 4, 1 / 3, 1 / 2, 2 / 3, 3 / 4])
    same = _changes(objective, number, yaw + 2 * np.pi * shares) < flat
    multiples = {4: (1, 3, 5), 3: (2, 4), 2: (3,)}
    return next((n for n, rows in multiples.items() if same[list(rows)].all()), 1)


def turning_changes(objective: Objective, number: int) -> float:
    """Return how much more than chance turning one object changes its own render, by Eq. 1."""
    yaws = np.arange(_TURNS) * (2 * np.pi / _TURNS)
    return float(_changes(objective, number, yaws).max())


def _changes(
    objective: Objective, number: int, yaws: Float[np.ndarray, "n"]
) -> Float[np.ndarray, "n"]:
    """Return how much more than chance an object's render differs from that at the first yaw."""
    import torch

    # Half of its points draw it at the first yaw, the other half at all of them. The loss of the
    # two halves at one yaw is what their scatter alone makes.

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
