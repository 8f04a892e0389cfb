"""Datasets read by the libraries they are for, in environments of their own.

    TABLETOPGEN_LEROBOT_PYTHON=~/lerobot/bin/python pytest -m real tests/recording

LeRobot 0.6.1 needs Python 3.12 and older releases of torch and NumPy than this package, so it is
run by the interpreter that ``TABLETOPGEN_LEROBOT_PYTHON`` names, robomimic 0.3.0 by that of
``TABLETOPGEN_ROBOMIMIC_PYTHON``.
"""

import json
import os
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from made_episodes import CAMERAS, SIZE, made_episode, play_made

from tabletopgen_env.recording import LeRobotConfig, RecordConfig, record

pytestmark = [pytest.mark.real, pytest.mark.slow]

ALL = ("rgb", "depth", "segmentation")
CONFIG = RecordConfig(
    "Lift", scenes=("office-round-*",), episodes=3, cameras=CAMERAS, image_size=SIZE, kinds=ALL
)
LEROBOT = """
import json, sys
from lerobot.datasets.lerobot_dataset import LeRobotDataset

data = LeRobotDataset("local/made", root=sys.argv[1], video_backend="pyav")
items = [data[k] for k in range(len(data))]
ahead = {"action": [0.0, 0.05, 0.1]}
window = LeRobotDataset("local/made", root=sys.argv[1], video_backend="pyav", episodes=[1],
                        delta_timestamps=ahead)[0]
names = ["front", "front_depth", "front_segmentation"]
print(json.dumps({
    "episodes": data.num_episodes, "fps": data.fps, "seeds": list(data.meta.episodes["seed"]),
    "tasks": [item["task"] for item in items],
    "action": [item["action"].tolist() for item in items],
    "window": window["action"].tolist(),
    **{n: [item["observation.images." + n].tolist() for item in items] for n in names},
}))
"""
ROBOMIMIC = """
import json, sys
import robomimic.utils.file_utils as files
import robomimic.utils.obs_utils as observations
from robomimic.utils.dataset import SequenceDataset

keys = {"rgb": ["front_image"], "depth": ["front_depth"], "low_dim": ["proprio", "state"]}
every = [name for names in keys.values() for name in names]
observations.initialize_obs_utils_with_obs_specs({"obs": keys})
shapes = files.get_shape_metadata_from_dataset(sys.argv[1], all_obs_keys=every)
kind = files.get_env_metadata_from_dataset(sys.argv[1])["type"]
found = {}
for split in ("train", "valid"):
    data = SequenceDataset(
        sys.argv[1], obs_keys=every, dataset_keys=("actions", "rewards", "dones"),
        load_next_obs=False, filter_by_attribute=split, hdf5_cache_mode=None,
    )
    items = [data[k] for k in range(len(data))]
    found[split] = {"demos": data.n_demos, "actions": [i["actions"][0].tolist() for i in items],
                    "front": items[0]["obs"]["front_image"][0].tolist()}
print(json.dumps({"shapes": shapes["all_shapes"], "type": kind, **found}))
"""


@pytest.fixture(autouse=True)
def made(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", play_made)


def read(variable: str, script: str, path: Path) -> Any:
    python = os.environ.get(variable)
    if not python:
        pytest.skip(f"{variable} names no Python")
    own = {n: v for n, v in os.environ.items() if n != "PYTHONPATH"} | {"HF_HUB_OFFLINE": "1"}
    done = subprocess.run(
        [python, "-c", script, str(path)], capture_output=True, text=True, timeout=280, env=own
    )
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.parametrize("video", ["h264", "hevc", "av1", "none"])
def test_lerobot_reads_every_frame(video: Any, tmp_path: Path) -> None:
    path = record(CONFIG, tmp_path / "set", "lerobot", lerobot=LeRobotConfig(video=video))
    found = read("TABLETOPGEN_LEROBOT_PYTHON", LEROBOT, path)
    episodes = [made_episode(number, kinds=ALL) for number in (0, 2, 3)]
    assert (found["episodes"], found["fps"], found["seeds"]) == (3, 20, [0, 2, 3])
    tasks = [e.facts["instruction"] for e in episodes for _ in e.rewards]
    assert found["tasks"] == tasks
    actions = np.concatenate([e.actions for e in episodes])
    np.testing.assert_array_equal(np.float32(found["action"]), actions)
    np.testing.assert_array_equal(np.float32(found["window"]), episodes[1].actions[:3])
    true = {n: np.concatenate([e.pictures[n][:-1] for e in episodes]) for n in episodes[0].pictures}
    colors = np.moveaxis(np.array(found["front"]), 1, -1) * 255
    exact = video == "none"
    assert np.abs(colors - true["front"]).mean() < (1e-4 if exact else 8)
    metres = np.array(found["front_depth"])[:, 0] / 1000
    np.testing.assert_allclose(metres, true["front_depth"], atol=1e-6 if exact else 2e-3)
    labels = np.array(found["front_segmentation"])[:, 0] * 255
    np.testing.assert_allclose(labels, true["front_segmentation"], atol=1e-4)


def test_robomimic_reads_it(tmp_path: Path) -> None:
    path = record(replace(CONFIG, kinds=("rgb", "depth")), tmp_path / "set.hdf5", "robomimic")
    found = read("TABLETOPGEN_ROBOMIMIC_PYTHON", ROBOMIMIC, path)
    assert found["type"] == 2
    assert found["shapes"]["front_image"] == [3, SIZE, SIZE]
    assert found["shapes"]["state"] == [279] and found["shapes"]["proprio"] == [33]
    first, second, last = (made_episode(n, kinds=("rgb", "depth")) for n in (0, 2, 3))
    assert (found["train"]["demos"], found["valid"]["demos"]) == (2, 1)
    done = np.concatenate([first.actions, second.actions])
    np.testing.assert_array_equal(np.float32(found["train"]["actions"]), done)
    np.testing.assert_array_equal(np.float32(found["valid"]["actions"]), last.actions)
    np.testing.assert_array_equal(found["valid"]["front"], last.pictures["front"][0])
