"""LeRobot datasets of played episodes: replayed, killed, by several processes, by the command."""

import json
import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from generator.cli import run
from tabletopgen_env.observations.proprioception import feel
from tabletopgen_env.recording import LeRobotConfig, RecordConfig, record
from tabletopgen_env.recording.lerobot import videos

pytestmark = pytest.mark.slow

CONFIG = RecordConfig(
    "Reach", scenes=("coffee-square-*",), episodes=3, seed=2, cameras=("front", "wrist"),
    image_size=64,
)  # fmt: skip
KILLED = """
import os, signal, sys
from dataclasses import replace
from test_played import CONFIG
from tabletopgen_env.recording import record
from tabletopgen_env.recording.lerobot import assembly, writer

def kill(*arguments, **settings):
    os.kill(os.getpid(), signal.SIGKILL)

encode, calls = writer.encode, []
def encode_some(*arguments, **settings):
    encode(*arguments, **settings)
    calls.append(1)
    if len(calls) == int(sys.argv[2]):
        kill()
writer.encode = encode_some
if sys.argv[2] == "join":
    writer.encode, assembly.join = encode, kill
record(CONFIG, sys.argv[1], "lerobot", resume=True)
"""


LUMA = np.array([0.299, 0.587, 0.114])  # what a codec keeps best


def quality(loss: np.ndarray) -> float:
    """Peak signal to noise, dB."""
    return 10 * np.log10(255**2 / np.mean(loss**2))


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return record(CONFIG, tmp_path_factory.mktemp("data") / "reach", "lerobot")


def contents(folder: Path) -> dict[str, bytes]:
    files = [path for path in folder.rglob("*") if path.is_file()]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def test_seeds_and_actions_give_the_same_episodes_again(dataset: Path) -> None:
    rows = pq.read_table(dataset / "meta" / "episodes").to_pydict()
    steps = pq.read_table(dataset / "data").to_pydict()
    shown = {
        camera: np.stack([*videos.decode(next(dataset.glob(f"videos/*.{camera}/*/*.mp4")))])
        for camera in CONFIG.cameras
    }
    env = CONFIG.environment()
    for episode, seed in enumerate(rows["seed"]):
        first, last = rows["dataset_from_index"][episode], rows["dataset_to_index"][episode]
        seen, info = env.reset(seed=seed)
        assert rows["tasks"][episode] == [info["instruction"]]
        assert rows["digest"][episode] == env.get_wrapper_attr("world").digest
        for k in range(first, last):
            state = np.float32(steps["observation.state"][k])
            assert np.array_equal(state, feel(env.get_wrapper_attr("world")))
            assert np.array_equal(state[:32], seen["state"][:32])
            views = np.float32(steps["camera.wrist.extrinsics"][k]).reshape(4, 4)
            assert np.array_equal(views, np.float32(info["cameras"]["wrist"]["extrinsics"]))
            for camera, frames in shown.items():
                loss = frames[k].astype(float) - seen[camera]
                assert quality(loss) > 27 and quality(loss @ LUMA) > 33, (camera, k)
            seen, reward, _, _, info = env.step(np.float32(steps["action"][k]))
            assert np.float32(reward) == np.float32(steps["next.reward"][k])
            assert info["success"] == steps["next.success"][k]
        assert info["success"] and rows["success"][episode]
    env.close()


def test_workers_do_not_change_it(dataset: Path, tmp_path: Path) -> None:
    assert contents(record(CONFIG, tmp_path / "reach", "lerobot", workers=2)) == contents(dataset)


def test_killed_thrice_and_resumed_it_is_the_same(dataset: Path, tmp_path: Path) -> None:
    out = tmp_path / "reach"
    path = os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])
    for when, kept in (("3", 1), ("1", 1), ("join", 3)):
        done = subprocess.run(
            [sys.executable, "-c", KILLED, str(out), when],
            env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, timeout=250,
        )  # fmt: skip
        assert done.returncode == -signal.SIGKILL, done.stderr
        assert [found.name for found in tmp_path.iterdir()] == [".reach.part"]
        assert len([*(tmp_path / ".reach.part" / "episodes").glob("episode-*")]) == kept
    record(CONFIG, out, "lerobot", resume=True)
    assert contents(out) == contents(dataset)
    assert [found.name for found in tmp_path.iterdir()] == ["reach"]


def test_what_a_robot_has_is_enough(tmp_path: Path) -> None:
    config = replace(CONFIG, episodes=1, cameras=("maniskill",), image_size=32,
                     observation="pixels+proprio", randomization="strong")  # fmt: skip
    path = record(config, tmp_path / "reach", "lerobot", lerobot=LeRobotConfig("none"))
    features = json.loads((path / "meta" / "info.json").read_text())["features"]
    assert features["observation.images.wrist"]["shape"] == [32, 32, 3]
    assert "observation.environment_state" not in features
    rows = pq.read_table(path / "data").to_pydict()
    other = record(replace(config, observation="pixels+state"), tmp_path / "other", "lerobot")
    again = pq.read_table(other / "data").to_pydict()
    assert rows["observation.state"] == again["observation.state"], "the other way to read it"
    env = config.environment()
    seed = pq.read_table(path / "meta" / "episodes")["seed"][0].as_py()
    seen, _ = env.reset(seed=seed)
    for k, action in enumerate(rows["action"]):
        assert np.array_equal(np.float32(rows["observation.state"][k]), seen["proprio"])
        seen = env.step(np.float32(action))[0]
    env.close()


def test_the_command_records_and_resumes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "reach"
    given = ["record", "--task", "Reach", "--scenes", "coffee-square-*", "--episodes", "1",
             "--format", "lerobot", "--out", str(out)]  # fmt: skip
    assert run([*given, "--video", "none", "--resume"]) == 0
    assert f"{out}: 1 of 1 episodes recorded" in capsys.readouterr().out
    features = json.loads((out / "meta" / "info.json").read_text())["features"]
    assert features["observation.environment_state"]["shape"] == [247], "there are no pictures"
    assert run([*given, "--resume"]) == 2
    assert "already exists" in capsys.readouterr().err
