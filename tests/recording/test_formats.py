"""What Minari, HDF5, npz and robomimic files keep beside observations: cameras, rate, figures."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from made_episodes import CAMERAS, SIZE, made_episode, play_made
from minari import MinariDataset

from tabletopgen_env.recording import RecordConfig, record

CONFIG = RecordConfig(
    "Lift", scenes=("office-round-*",), episodes=3, cameras=CAMERAS, image_size=SIZE,
    kinds=("rgb", "depth"),
)  # fmt: skip
KEPT = (0, 2, 3)
EPISODES = [made_episode(number, kinds=CONFIG.kinds) for number in KEPT]


@pytest.fixture(autouse=True)
def made(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", play_made)


def read(format: Any, path: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the metadata of the dataset, and the second episode's arrays by joined names."""
    arrays: dict[str, Any] = {}
    if format == "npz":
        with np.load(path / "episode_1.npz", allow_pickle=False) as file:
            arrays = dict(file)
        return json.loads((path / "dataset.json").read_text()), arrays
    about: dict[str, Any] = {}
    if format == "minari":
        about = MinariDataset(path / "data").storage.metadata["tabletopgen"]
        path = path / "data" / "main_data.hdf5"
    with h5py.File(path) as file:
        if format == "hdf5":
            about = {"fps": int(file.attrs["fps"]), "statistics": nested(file["statistics"])}
        file["episode_1"].visititems(
            lambda name, item: arrays.update({name: item[()]} if hasattr(item, "dtype") else {})
        )
    return about, arrays


def nested(group: h5py.Group) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, item in group.items():
        if isinstance(item, h5py.Dataset):
            found[name] = item[()].tolist()
        else:
            inner = nested(item)
            whole = not any(isinstance(v, dict) for v in inner.values())
            found |= {name: inner} if whole else {f"{name}/{n}": v for n, v in inner.items()}
    return found


@pytest.mark.parametrize("format", ["minari", "hdf5", "npz"])
def test_calibrations_rate_flags_and_figures_are_there(format: Any, tmp_path: Path) -> None:
    about, arrays = read(format, record(CONFIG, tmp_path / "set-v0", format))
    second = EPISODES[1]
    for camera in CAMERAS:
        for part in ("intrinsics", "extrinsics"):
            found = arrays[f"infos/cameras/{camera}/{part}"]
            np.testing.assert_array_equal(found, second.cameras[camera][part])
            assert found.dtype == np.float64
    np.testing.assert_array_equal(arrays["infos/proprio"], second.proprio)
    steps = len(second.rewards)
    assert arrays["truncations"].tolist() == [False] * (steps - 1) + [True]
    assert arrays["terminations"].tolist() == [False] * steps
    assert about["fps"] == 20
    figures = about["statistics"]
    actions = np.concatenate([e.actions for e in EPISODES]).astype(float)
    np.testing.assert_allclose(figures["actions"]["mean"], actions.mean(0))
    np.testing.assert_allclose(figures["actions"]["max"], actions.max(0))
    assert figures["actions"]["count"] == [len(actions)]
    assert len(figures["proprio"]["q01"]) == 33
    assert len(figures["observations/state"]["std"]) == 279
    colors = np.concatenate([e.pictures["wrist"] for e in EPISODES]).reshape(-1, 3) / 255
    np.testing.assert_allclose(figures["observations/wrist"]["mean"], colors.mean(0))
    assert len(figures["observations/front_depth"]["q50"]) == 1


def test_robomimics_layout(tmp_path: Path) -> None:
    path = record(CONFIG, tmp_path / "set.hdf5", "robomimic")
    with h5py.File(path) as file:
        data = file["data"]
        arguments = json.loads(data.attrs["env_args"])
        assert arguments["env_name"] == "TabletopGen/Lift-v0" and arguments["type"] == 2
        assert arguments["env_kwargs"]["cameras"] == [*CAMERAS]
        assert data.attrs["total"] == sum(len(e.rewards) for e in EPISODES)
        assert file["mask/train"][()].tolist() == [b"demo_0", b"demo_1"]
        assert file["mask/valid"][()].tolist() == [b"demo_2"]
        demo, second = data["demo_1"], EPISODES[1]
        assert demo.attrs["num_samples"] == len(second.rewards) and demo.attrs["seed"] == 2
        np.testing.assert_array_equal(demo["actions"], second.actions)
        np.testing.assert_array_equal(demo["rewards"], second.rewards)
        assert demo["dones"][()].tolist() == [0] * (len(second.rewards) - 1) + [1]
        seen = demo["obs"]
        assert set(seen) == {"proprio", "state"} | {
            f"{c}_{n}" for c in CAMERAS for n in ("image", "depth", "intrinsics", "extrinsics")
        }
        np.testing.assert_array_equal(seen["front_image"], second.pictures["front"][:-1])
        depth = seen["front_depth"][..., 0]
        np.testing.assert_array_equal(depth, second.pictures["front_depth"][:-1])
        np.testing.assert_array_equal(seen["state"], second.state[:-1])
        assert json.loads(data.attrs["tabletopgen"])["fps"] == 20
        assert len(file["statistics/actions/mean"]) == 5


def test_one_of_ten_demonstrations_is_for_validation(tmp_path: Path) -> None:
    path = record(replace(CONFIG, episodes=21), tmp_path / "set.hdf5", "robomimic")
    with h5py.File(path) as file:
        assert file["mask/valid"][()].tolist() == [b"demo_9", b"demo_19"]
        assert len(file["mask/train"]) == 19
    path = record(replace(CONFIG, episodes=1), tmp_path / "one.hdf5", "robomimic")
    with h5py.File(path) as file:
        assert len(file["mask/valid"]) == 0
