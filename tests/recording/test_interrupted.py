"""Episodes played elsewhere: what was kept outlasts Ctrl-C and whatever goes wrong."""

import json
import signal
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

import gymnasium as gym
import h5py
import numpy as np
import pytest
from made_episodes import made_episode

from generator.errors import InputError, SceneError, StorageError
from tabletopgen_env.recording.config import Format, RecordConfig
from tabletopgen_env.recording.episodes import RecordedEpisode
from tabletopgen_env.recording.formats.npz_writer import NpzWriter
from tabletopgen_env.recording.recorder import write_dataset

CONFIG = RecordConfig("Reach", scenes=("office-desk",))


@pytest.fixture
def env() -> Iterator[gym.Env]:
    with closing(CONFIG.environment()) as made:
        yield made


def seeds(path: Path) -> list[int]:
    return [facts["seed"] for facts in json.loads((path / "dataset.json").read_text())["episodes"]]


def interrupt() -> None:
    signal.raise_signal(signal.SIGINT)


@pytest.mark.parametrize("method", ["add", "finish", "close"])
def test_an_interrupt_while_writing_loses_nothing(
    method: str, env: gym.Env, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = getattr(NpzWriter, method)

    def interrupted(self: NpzWriter, *args: Any) -> None:
        interrupt()
        write(self, *args)
        interrupt()

    monkeypatch.setattr(NpzWriter, method, interrupted)
    played = map(made_episode, range(3))
    path = write_dataset(CONFIG, env, lambda _: played, tmp_path / "set", "npz")
    assert seeds(path) == ([0] if method == "add" else [0, 1, 2])
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert [found.name for found in tmp_path.iterdir()] == ["set"]


def test_an_interrupt_while_playing_ends_the_recording(env: gym.Env, tmp_path: Path) -> None:
    def played(first: int) -> Iterator[RecordedEpisode]:
        yield made_episode(0)
        interrupt()
        yield made_episode(1)

    assert seeds(write_dataset(CONFIG, env, played, tmp_path / "set", "npz")) == [0]
    with pytest.raises(InputError, match="No episode was kept"):
        write_dataset(CONFIG, env, lambda _: (interrupt() for _ in "a"), tmp_path / "none", "npz")  # type: ignore[misc]


def broken(first: int) -> Iterator[RecordedEpisode]:
    yield made_episode(first)
    raise SceneError("the next table is damaged")


def test_what_goes_wrong_later_is_told_and_loses_nothing(env: gym.Env, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="the next table"):
        write_dataset(CONFIG, env, broken, tmp_path / "set", "npz")
    assert seeds(tmp_path / "set") == [0]


def test_where_it_can_be_resumed_it_waits_for_that(env: gym.Env, tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    with pytest.raises(SceneError, match="the next table"):
        write_dataset(CONFIG, env, broken, tmp_path / "set", "lerobot")
    assert [found.name for found in tmp_path.iterdir()] == [".set.part"]
    path = write_dataset(CONFIG, env, lambda first: [made_episode(first)], tmp_path / "set",
                         "lerobot", resume=True)  # fmt: skip
    assert json.loads((path / "meta" / "info.json").read_text())["total_episodes"] == 2


@pytest.mark.parametrize(
    ("format", "group", "held"),
    [("hdf5", "/", {"episode_0", "statistics"}), ("robomimic", "data", {"demo_0"})],
)
def test_an_episode_that_cannot_be_written_leaves_nothing_of_itself(
    format: Format, group: str, held: set[str], env: gym.Env, tmp_path: Path
) -> None:
    odd = replace(made_episode(1), rewards=np.array([object()] * 4))
    with pytest.raises(TypeError):
        write_dataset(CONFIG, env, lambda _: [made_episode(0), odd], tmp_path / "set", format)
    with h5py.File(tmp_path / "set") as file:
        there: Any = file[group]
        assert {*there} == held


def test_a_full_disk_leaves_no_half_file(
    env: gym.Env, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save = np.savez_compressed

    def full(path: Path, **arrays: Any) -> None:
        save(path, **arrays)
        if path.name == "episode_1.npz":
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez_compressed", full)
    with pytest.raises(StorageError, match="No space left"):
        write_dataset(CONFIG, env, lambda _: map(made_episode, range(3)), tmp_path / "set", "npz")
    assert seeds(tmp_path / "set") == [0]
    assert not (tmp_path / "set" / "episode_1.npz").exists()
