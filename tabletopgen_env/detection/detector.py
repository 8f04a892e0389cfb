"""Grasps detected in height maps, by the network the package ships."""

from __future__ import annotations

import json
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import torch
from torch.nn import functional

from generator.errors import StorageError
from generator.geometry import rotation_z

from ..expert.choosing import Plan, reached
from ..expert.grasps import Grasp, is_like
from ..robot import franka
from .look import Look, look
from .network import TURNS, GraspNetwork, Rated, turned

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from torch import Tensor

    from ..world import World

PATH = Path(__file__).with_name("grasps.safetensors")
"""The weights the package ships."""

CARD = "tabletopgen_grasps"
"""Where the file's header says, as JSON, what the network learned from."""

_MOST_BYTES = 2**22
_MOST = 40  # grasps that the arm is asked for
_POSSIBLE = -2.0  # logit below which nothing is taken for a grasp
_RESTORE = (
    "Install the package again, or train the detector: "
    "python -m tabletopgen_env.detection.training --help"
)


@dataclass(frozen=True, eq=False)
class GraspDetector:
    """Says where to grasp an object, from what a depth camera sees of it."""

    network: GraspNetwork

    def __call__(self, world: World, target: str, failed: tuple[Grasp, ...] = ()) -> Plan | None:
        """Return the grasp rated best that the arm can reach, None if none; as ``choose``.

        Args:
            world: the world; live poses count.
            target: an object's name.
            failed: grasps that failed, which rank last.
        """
        seen = look(world, target)
        found = sorted(self.detect(seen), key=lambda g: any(is_like(g, f) for f in failed))
        return reached(world, world.position(target), found, seen.others)

    def detect(self, seen: Look) -> list[Grasp]:
        """Return the grasps seen in height maps, best first."""
        facing = torch.tensor([seen.facing], dtype=torch.float32)
        with torch.inference_mode(), _one_thread():
            rated = self.network(turned(torch.from_numpy(seen.heights)[None], facing))
            chosen = _peaks(rated)
        middle = np.append(seen.center, seen.floor)
        grasps = []
        for turn, i, j in chosen:
            where = (0, turn, i, j)
            angle = seen.facing + turn * np.pi / TURNS
            width = max(float(rated.width[where]), 0.0)
            opening = min(width + max(float(rated.room[where]), 0.0), 2 * franka.FINGER_STROKE)
            point = middle + rotation_z(angle) @ rated.at[where].double().numpy()
            grasps.append(Grasp(point, angle, opening, width, float(rated.best[where])))
        return grasps


@contextmanager
def _one_thread() -> Iterator[None]:
    """Keep torch to the calling thread: a forked process has none of the others, and would wait."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)


def _peaks(rated: Rated) -> list[list[int]]:
    """Return turn and place of what is rated higher than all beside it, best first."""
    best = rated.best[0]
    around = functional.max_pool2d(best[:, None], 3, stride=1, padding=1)[:, 0]
    scores = torch.where(
        (best == around) & (rated.possible[0] > _POSSIBLE), best, torch.tensor(-torch.inf)
    ).flatten()
    top, rows = scores.topk(_MOST)
    return [list(map(int, np.unravel_index(int(r), best.shape))) for r in rows[top > -torch.inf]]


@cache
def shipped_detector(path: Path = PATH) -> GraspDetector:
    """Read the detector that the package ships; it stays loaded.

    Raises:
        StorageError: the file is missing, damaged or of another network.
    """
    from safetensors import SafetensorError, safe_open

    try:
        if path.stat().st_size > _MOST_BYTES:
            raise ValueError(f"it has more than {_MOST_BYTES} bytes")
        with safe_open(path, framework="pt") as file:
            weights = {key: file.get_tensor(key).float() for key in file.keys()}  # noqa: SIM118
        network = GraspNetwork()
        network.load_state_dict(weights)
    except (SafetensorError, ValueError, RuntimeError, OSError) as error:
        raise StorageError(
            f"The grasp detector's weights {path.name!r} cannot be used ({error}). {_RESTORE}"
        ) from error
    network.eval().requires_grad_(False)
    return GraspDetector(network)


def save_detector(network: GraspNetwork, path: Path, card: Mapping[str, object]) -> None:
    """Write a network's weights in half precision, whole or not at all.

    Args:
        network: what to write.
        path: where.
        card: what it learned from.
    """
    from safetensors.torch import save

    from generator.files import write_whole

    state: dict[str, Tensor] = network.state_dict()
    content = save(
        {key: value.detach().half().contiguous() for key, value in state.items()},
        {CARD: json.dumps(card, sort_keys=True)},
    )
    write_whole(path, content, "The grasp detector", "Choose another folder.")
