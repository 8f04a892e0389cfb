"""Random episodes, cheap replacements of the expert's."""

from collections.abc import Iterator
from typing import Any

import cv2
import numpy as np

from generator.errors import SceneError
from tabletopgen_env.recording.episodes import RecordedEpisode

SIZE = 16
CAMERAS = ("front", "wrist")


def made_episode(number: int, steps: int = 0, kinds: tuple[str, ...] = ("rgb",)) -> RecordedEpisode:
    """Return an episode with pictures, equal for equal numbers; later ones are longer."""
    rng = np.random.default_rng(number)
    steps = steps or 3 + number
    rows = steps + 1
    seen: dict[str, Any] = {"state": rng.normal(size=(rows, 279)).astype(np.float32)}
    cameras = {}
    for camera in CAMERAS:
        smooth = cv2.GaussianBlur(rng.random((SIZE + rows, SIZE, 3)), (0, 0), 3)
        smooth = (smooth - smooth.min()) / (smooth.max() - smooth.min())
        window = np.stack([smooth[k : k + SIZE] for k in range(rows)])
        if "rgb" in kinds:
            seen[camera] = (window * 255).astype(np.uint8)
        if "depth" in kinds:
            seen[f"{camera}_depth"] = (0.2 + 3 * window[..., 0]).astype(np.float32)
        if "segmentation" in kinds:
            seen[f"{camera}_segmentation"] = (window[..., 1] * 5).astype(np.uint8)
        cameras[camera] = {
            "intrinsics": np.tile(np.diag([20.0, 20.0, 1.0]), (rows, 1, 1)),
            "extrinsics": np.tile(np.eye(4), (rows, 1, 1)) + np.arange(rows)[:, None, None],
        }
    task = f"lift the {('cup', 'bowl')[number % 2]}"
    infos: Any = {
        "cameras": cameras,
        "success": np.arange(rows) > rows // 2,
        "instruction": [task] * rows,
        "reward_terms": {"lift": rng.random(rows).astype(np.float32)},
    }
    facts = {
        "seed": number, "instruction": task, "scene": "made", "digest": "0" * 64, "target": "cup",
        "goal": "", "certified": True, "success": True, "steps": steps,
    }  # fmt: skip
    actions = rng.uniform(-1, 1, (steps, 5)).astype(np.float32)
    proprio = np.hstack([seen["state"][:, :32], np.zeros((rows, 1), np.float32)])
    rewards = rng.random(steps).astype(np.float32)
    return RecordedEpisode(number, seen, actions, rewards, proprio, infos, facts)


def play_made(
    config: Any, env: Any, workers: int, ray: Any = None, first: int = 0
) -> Iterator[RecordedEpisode | SceneError]:
    """Replace ``play_episodes``: every third episode is missing."""
    number = first
    while True:
        lost = number % 3 == 1
        yield SceneError("lost") if lost else made_episode(number, kinds=config.kinds)
        number += 1
