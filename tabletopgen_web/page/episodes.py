"""Episodes of the expert, recorded for playback in the browser."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float32

from generator.errors import SceneError, require_known
from tabletopgen_env.tasks.names import NAMES

CONTROL_HZ = 20
"""Recorded states per second."""

TRIES = 4
"""Maximum number of seeds to try until the expert solves an episode."""


@dataclass(frozen=True, eq=False)
class RecordedPlay:
    """One episode as a sequence of states of the composed model (``robot.robot_document``).

    ``rows`` has a row for the start and one for each control step: qpos of the model (metres,
    radians, quaternions wxyz), then the position of the goal's marker in the world (metres).
    """

    task: str
    instruction: str
    success: bool
    seed: int
    rows: Float32[np.ndarray, "t w"]

    @property
    def seconds(self) -> float:
        """The duration of the episode in seconds."""
        return (len(self.rows) - 1) / CONTROL_HZ

    def to_bytes(self) -> bytes:
        """Return the content of a file: header length (little-endian uint32), header, and rows."""
        header = {
            "task": self.task,
            "instruction": self.instruction,
            "success": self.success,
            "seed": self.seed,
            "hz": CONTROL_HZ,
            "frames": len(self.rows),
            "nq": self.rows.shape[1] - 3,
        }
        text = json.dumps(header, sort_keys=True)
        text += " " * (-(len(text) + 4) % 4)
        raw = text.encode()
        return struct.pack("<I", len(raw)) + raw + self.rows.astype("<f4").tobytes()


@dataclass(frozen=True)
class PlayRow:
    """A recorded episode in the page's data."""

    task: str
    instruction: str
    file: str
    seconds: float
    success: bool

    @staticmethod
    def of(play: RecordedPlay, file: str) -> PlayRow:
        """Return the row of an episode stored in ``file``."""
        return PlayRow(play.task, play.instruction, file, round(play.seconds, 2), play.success)


def record_play(bundle: Path, task: str, seed: int = 0, tries: int = TRIES) -> RecordedPlay:
    """Record the scripted expert in one episode of a task in a bundle's scene.

    At most ``tries`` seeds are tried, starting at ``seed``. The result is the first episode that
    the expert solves, or else the last one that it attempts.

    Raises:
        InputError: the task is unknown.
        SceneError: the scene has no valid instance of this task.
    """
    import gymnasium as gym

    from tabletopgen_env.learning.demonstrations.recorded import demonstrate

    require_known(task, NAMES, "Unknown task")
    env = gym.make(f"tabletopgen_env:TabletopGen/{task}-v0", scenes=str(bundle), action="ee_delta")
    play = None
    try:
        for number in range(seed, seed + tries):
            rows: list[np.ndarray] = []

            def keep(_info: dict[str, object], rows: list[np.ndarray] = rows) -> None:
                data = env.get_wrapper_attr("world").data
                rows.append(np.concatenate([data.qpos, data.mocap_pos[0]]).astype(np.float32))

            shown = demonstrate(env, number, report=keep)
            if shown is None:
                continue
            play = RecordedPlay(task, shown.instruction, shown.solved, number, np.stack(rows))
            if play.success:
                break
    finally:
        env.close()
    if play is None:
        raise SceneError(f"The expert cannot solve {task} in {bundle.name}.")
    return play
