"""Grasp detection in height maps with the network shipped in the package."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Float32

from generator.errors import StorageError
from generator.geometry import rotation_z
from generator.io.files import write_whole

from ..expert.planning.choice import GraspPlan, first_reachable
from ..expert.planning.grasps import TIP, Grasp, is_like
from ..robot import franka
from .look import HeightView, look
from .network import LAYERS, TURNS, Rated, rate, turn_views

if TYPE_CHECKING:
    from ..world.world import World

PATH = Path(__file__).with_name("grasps.safetensors")
"""The weights shipped with the package."""

CARD = "tabletopgen_grasps"
"""The key of the JSON training summary in the file's header."""

_MAX_BYTES = 2**22
_WIDEST = 2 * franka.FINGER_STROKE
_MAX_GRASPS = 40  # grasps that are checked for reachability
_POSSIBLE = -2.0  # minimum logit of a grasp
_RESTORE = (
    "Install the package again, or train the detector: python -m research.grasps.training --help"
)


@dataclass(frozen=True, eq=False)
class GraspDetector:
    """A detector of grasps in height maps of an object; ``weights`` are described in ``rate``."""

    weights: Mapping[str, Float32[np.ndarray, "..."]]

    def __call__(
        self, world: World, target: str, failed: tuple[Grasp, ...] = ()
    ) -> GraspPlan | None:
        """Return an object's best-rated grasp within the arm's reach, or None if there is none.

        Grasps in ``failed`` rank last, as in ``choose``.
        """
        found = self.detect(look(world, target))
        found.sort(key=lambda grasp: any(is_like(grasp, other) for other in failed))
        return first_reachable(world, target, found)

    def detect(self, seen: HeightView) -> list[Grasp]:
        """Return the grasps detected in height maps, best first."""
        rated = rate(self.weights, turn_views(seen.heights, seen.facing))
        middle = np.append(seen.center, seen.floor)
        grasps = []
        for where in _peaks(rated):
            angle = seen.facing + where[0] * np.pi / TURNS
            width = min(max(float(rated.width[where]), 0.0), _WIDEST)
            opening = min(width + max(float(rated.room[where]), 0.0), _WIDEST)
            height = max(float(rated.height[where]), TIP)
            at = np.array([rated.along[where], rated.across[where], height], float)
            point = middle + rotation_z(angle) @ at
            grasps.append(Grasp(point, angle, opening, width, float(rated.best[where])))
        return grasps


def _peaks(rated: Rated) -> list[tuple[int, int, int]]:
    """Return the (rotation, row, column) indices of the rating's local maxima, best first."""
    from scipy.ndimage import maximum_filter

    around = maximum_filter(rated.best, (1, 3, 3), mode="nearest")
    chosen = np.argwhere((rated.best == around) & (rated.possible > _POSSIBLE))
    order = np.argsort(-rated.best[tuple(chosen.T)], kind="stable")[:_MAX_GRASPS]
    return [(int(turn), int(i), int(j)) for turn, i, j in chosen[order]]


@cache
def read_detector(path: Path = PATH) -> GraspDetector:
    """Read a detector, by default the shipped one, and cache it.

    Raises:
        StorageError: the file is missing, damaged or belongs to another network.
    """
    from safetensors import SafetensorError
    from safetensors.numpy import load

    try:
        if path.stat().st_size > _MAX_BYTES:
            raise ValueError(f"the file has more than {_MAX_BYTES} bytes")
        weights = {key: value.astype(np.float32) for key, value in load(path.read_bytes()).items()}
        if {key: value.shape for key, value in weights.items()} != _shapes():
            raise ValueError("the file belongs to another network")
        if not all(np.isfinite(value).all() for value in weights.values()):
            raise ValueError("some weights are not finite")
    except (SafetensorError, ValueError, OSError) as error:
        raise StorageError(
            f"The grasp detector's weights {path.name!r} cannot be used ({error}). {_RESTORE}"
        ) from error
    return GraspDetector(weights)


def shipped_digest() -> str:
    """Return a digest that identifies the shipped weights, since they determine the detections."""
    return hashlib.sha256(PATH.read_bytes()).hexdigest()[:16]


def save_weights(
    weights: Mapping[str, Float[np.ndarray, "..."]], path: Path, card: Mapping[str, object]
) -> None:
    """Write the weights and the training summary of a network atomically.

    Raises:
        StorageError: the file cannot be written.
    """
    from safetensors.numpy import save

    content = save(dict(weights), {CARD: json.dumps(card, sort_keys=True)})
    write_whole(path, content, "The grasp detector", "Choose another folder.")


def _shapes() -> dict[str, tuple[int, ...]]:
    """Return the shapes of the network's weights by name."""
    shapes: dict[str, tuple[int, ...]] = {}
    for k, layer in enumerate(LAYERS):
        shapes[f"{k}.weight"] = (layer.outputs, layer.inputs, layer.side, layer.side)
        shapes[f"{k}.bias"] = (layer.outputs,)
    return shapes
