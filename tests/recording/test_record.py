"""Recorded demonstrations: what is in them, that they load and play again, and clear errors."""

import json
import os
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import h5py
import minari
import numpy as np
import pytest
from minari import MinariDataset

from assets_cache import find
from generator.bundle import load_digest
from generator.cli import run
from generator.errors import InputError, SceneError, StorageError
from tabletopgen_env.learning.demonstrations.recorded import demonstrate
from tabletopgen_env.recording import RecordConfig, record
from tabletopgen_env.recording.episodes import play_episodes

TABLE = "office-round-*"
LIFT = RecordConfig("Lift", scenes=(TABLE,), episodes=2, seed=4)
SEEN = replace(LIFT, episodes=1, cameras=("wrist",), kinds=("rgb", "segmentation"), image_size=32)


@pytest.fixture(scope="module")
def lift(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return record(LIFT, tmp_path_factory.mktemp("data") / "lift-v0")


@pytest.fixture(scope="module")
def first() -> Any:
    """Return the first episode of ``SEEN``."""
    env = SEEN.environment()
    episodes = play_episodes(SEEN, env, 1)
    episode = next(episodes)
    env.close()
    return episode


@pytest.mark.slow
def test_minari_loads_it_by_its_id(lift: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(lift.parent))
    assert "lift-v0" in minari.list_local_datasets()
    dataset = minari.load_dataset("lift-v0")
    assert dataset.total_episodes == 2 and dataset.observation_space.shape == (279,)
    for episode in dataset.iterate_episodes():
        steps = len(episode.rewards)
        assert episode.observations.shape == (steps + 1, 279)
        assert episode.actions.shape == (steps, 5)
        assert not episode.terminations.any()
        assert episode.truncations.tolist() == [False] * (steps - 1) + [True]
        assert episode.infos["success"][-10:].all() and not episode.infos["success"][:-10].all()
        assert len(episode.infos["reward_terms"]["lift"]) == steps + 1
        assert episode.rewards[-1] == pytest.approx(1.0)
    assert list(lift.parent.iterdir()) == [lift], "nothing else is left"


def test_the_facts_are_the_episodes_metadata(lift: Path) -> None:
    dataset = MinariDataset(lift / "data")
    facts = list(dataset.storage.get_episode_metadata([0, 1]))
    assert all(f["success"] and f["digest"] == load_digest(find(TABLE)[0]) for f in facts)
    assert facts[0]["seed"] != facts[1]["seed"] and facts[0]["scene"] == "office-round"
    assert facts[0]["instruction"].startswith("lift the ") and facts[0]["goal"] == ""
    said = dataset[0].infos["instruction"]
    assert {text.decode() for text in said} == {facts[0]["instruction"]}
    assert len(said) == facts[0]["steps"] + 1


@pytest.mark.slow
def test_the_recovered_environment_plays_it_again(lift: Path) -> None:
    dataset = MinariDataset(lift / "data")
    env = dataset.recover_environment()
    [facts] = dataset.storage.get_episode_metadata([1])
    episode = dataset[1]
    seen = [env.reset(seed=facts["seed"])[0]]
    seen += [env.step(action)[0] for action in episode.actions]
    assert np.array_equal(np.stack(seen), episode.observations)
    env.close()


@pytest.mark.slow
def test_the_same_seed_gives_the_same_arrays_whatever_the_workers(
    lift: Path, tmp_path: Path
) -> None:
    again = record(LIFT, tmp_path / "again-v0", workers=2)
    assert contents(again / "data/main_data.hdf5") == contents(lift / "data/main_data.hdf5")
    other = record(replace(LIFT, seed=5, episodes=1), tmp_path / "other-v0")
    assert contents(other / "data/main_data.hdf5") != contents(lift / "data/main_data.hdf5")


@pytest.mark.slow
def test_starts_differ_unless_asked_not_to() -> None:
    def starts(config: RecordConfig) -> set[bytes]:
        env = config.environment()
        targets = {"target": env.reset(seed=0)[1]["target"]}
        seen = {env.reset(seed=k, options=targets)[0].tobytes() for k in range(4)}
        env.close()
        return seen

    assert len(starts(LIFT)) == 4
    assert len(starts(replace(LIFT, randomization=None))) == 1


@dataclass(frozen=True)
class Counted(RecordConfig):
    """Records in a folder, by process, each created and closed environment."""

    folder: str = ""

    def environment(self) -> Any:
        env = super().environment()
        self.note("made")
        close = env.close

        def closing() -> None:
            self.note("closed")
            close()

        env.close = closing  # type: ignore[method-assign]
        return env

    def note(self, what: str) -> None:
        with (Path(self.folder) / f"{what}-{os.getpid()}").open("a") as file:
            file.write("x")


class Fatal(Counted):
    """Kills any process except the one for which it was created."""

    def environment(self) -> Any:
        if str(os.getpid()) != Path(self.folder).name:
            os._exit(9)
        return super().environment()


@pytest.mark.slow
def test_each_process_makes_one_environment_and_closes_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tabletopgen_env.recording.episodes.CHUNK", 1)
    config = Counted("Lift", scenes=(TABLE,), episodes=3, seed=4, folder=str(tmp_path))
    record(config, tmp_path / "data", "npz", workers=2)
    notes = {path.name: path.read_text() for path in tmp_path.glob("*-*")}
    assert len(notes) == 6, "this process and two more"
    assert set(notes.values()) == {"x"}


@pytest.mark.slow
def test_a_process_that_dies_is_an_error_of_the_project(tmp_path: Path) -> None:
    folder = tmp_path / str(os.getpid())
    folder.mkdir()
    with pytest.raises(SceneError, match="ended abruptly"):
        record(Fatal("Lift", scenes=(TABLE,), folder=str(folder)), tmp_path / "data", "npz", 2)
    assert list(tmp_path.iterdir()) == [folder]


def contents(path: Path) -> dict[str, Any]:
    """Return every array and attribute of an HDF5 file, by name."""
    found: dict[str, Any] = {}

    def visit(name: str, item: h5py.Group | h5py.Dataset) -> None:
        if isinstance(item, h5py.Dataset):
            found[name] = item[()].tolist()
        found[name + "@"] = dict(item.attrs)

    with h5py.File(path) as file:
        file.visititems(visit)
    return found


@pytest.mark.slow
@pytest.mark.parametrize("format", ["minari", "hdf5", "npz"])
def test_every_format_keeps_pictures_to_the_bit(format: Any, first: Any, tmp_path: Path) -> None:
    path = record(SEEN, tmp_path / "seen-v0", format)
    if format == "minari":
        episode = MinariDataset(path / "data")[0]
        seen, done = episode.observations, episode.actions
        [facts] = MinariDataset(path / "data").storage.get_episode_metadata([0])
    elif format == "hdf5":
        with h5py.File(path) as file:
            group = file["episode_0"]
            seen = {name: array[()] for name, array in group["observations"].items()}
            done, facts = group["actions"][()], dict(group.attrs)
            assert group["infos/instruction"].asstr()[0] == facts["instruction"]
            assert json.loads(file.attrs["settings"])["seed"] == 4
    else:
        arrays = np.load(path / "episode_0.npz", allow_pickle=False)
        seen = {n.removeprefix("observations/"): arrays[n] for n in arrays if "observations" in n}
        done = arrays["actions"]
        [facts] = json.loads((path / "dataset.json").read_text())["episodes"]
        assert arrays["infos/instruction"][0] == facts["instruction"]
    assert set(seen) == {"state", "wrist", "wrist_segmentation"}
    assert seen["wrist"].dtype == np.uint8 and seen["wrist"][0].shape == (32, 32, 3)
    for name, array in first.observations.items():
        assert np.array_equal(seen[name], array), name
    assert np.array_equal(done, first.actions)
    assert {name: facts[name] for name in first.facts} == first.facts


@pytest.mark.slow
def test_failures_are_kept_if_asked_and_else_passed_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    solved = iter([False, True, False, True])

    def other(*args: Any, **kwargs: Any) -> Any:
        shown = demonstrate(*args, **kwargs)
        return shown and replace(shown, solved=next(solved))

    monkeypatch.setattr("tabletopgen_env.recording.episodes.demonstrate", other)
    told: list[tuple[int, int]] = []
    record(replace(LIFT, episodes=1), tmp_path / "a", "npz", report=lambda *n: told.append(n))
    assert told == [(0, 0), (0, 1), (1, 2)]
    path = record(replace(LIFT, episodes=1, keep_failures=True), tmp_path / "b", "npz")
    assert json.loads((path / "dataset.json").read_text())["episodes"][0]["success"] is False


@pytest.mark.slow
@pytest.mark.parametrize("format", ["minari", "hdf5", "npz", "robomimic"])
@pytest.mark.parametrize("failure", [KeyboardInterrupt, OSError("full")])
def test_what_goes_wrong_leaves_nothing_behind(
    format: Any, failure: Any, tmp_path: Path, first: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    def some(*args: Any) -> Any:
        yield first
        raise failure

    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", some)
    expected = KeyboardInterrupt if failure is KeyboardInterrupt else StorageError
    with pytest.raises(expected):
        record(replace(SEEN, episodes=2), tmp_path / "new" / "seen-v0", format)
    assert list((tmp_path / "new").iterdir()) == []


def test_it_gives_up_where_the_expert_solves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none(*args: Any) -> Any:
        while True:
            yield SceneError("the expert did not 'fly'")

    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", none)
    with pytest.raises(SceneError, match=r"50 consecutive episodes .* did not 'fly'"):
        record(LIFT, tmp_path / "none", "npz")
    assert list(tmp_path.iterdir()) == []


def test_wrong_requests_are_explained(tmp_path: Path, lift: Path) -> None:
    cases: list[tuple[RecordConfig, dict[str, Any], str]] = [
        (RecordConfig("TabletopGen/Lifft-v0"), {}, "Unknown task .* Did you mean 'Lift'"),
        (replace(LIFT, episodes=0), {}, "episodes must be a whole number >= 1"),
        (replace(LIFT, noise=-1.0), {}, "noise"),
        (LIFT, {"format": "hdf"}, "Did you mean 'hdf5'"),
        (LIFT, {"format": "npz", "out": None}, "Set 'out'"),
        (LIFT, {"workers": 0}, "workers must be a whole number >= 1"),
        (LIFT, {"out": lift}, "already exists"),
        (LIFT, {"out": tmp_path / "lift"}, "not a valid name of a Minari dataset.*'lift-v0'"),
        (replace(LIFT, cameras=("back",)), {}, "Unknown camera 'back'"),  # type: ignore[arg-type]
        (replace(LIFT, observation="pixels"), {}, "Unknown observation 'pixels'"),  # type: ignore[arg-type]
        (replace(LIFT, randomization="lihgt"), {}, "Did you mean 'light'"),
    ]
    for config, settings, reason in cases:
        with pytest.raises(InputError, match=reason):
            record(config, **{"out": tmp_path / "data-v0", **settings})
    assert list(tmp_path.iterdir()) == []


def test_a_missing_package_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "minari", None)
    with pytest.raises(InputError, match=r"minari, .* pip install 'tabletopgen\[record\]'"):
        record(LIFT, tmp_path / "lift-v0")
    monkeypatch.setitem(sys.modules, "h5py", None)
    with pytest.raises(InputError, match="needs the package h5py"):
        record(LIFT, tmp_path / "lift.hdf5", "hdf5")


@pytest.mark.slow
def test_without_a_place_it_goes_into_minaris_store(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path / "store"))
    assert record(replace(LIFT, episodes=1)) == tmp_path / "store" / "TabletopGen-Lift-v0"
    assert os.environ["MINARI_DATASETS_PATH"] == str(tmp_path / "store")
    assert minari.load_dataset("TabletopGen-Lift-v0").total_episodes == 1


@pytest.mark.slow
def test_the_command_records_and_says_where(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "lift"
    given = ["record", "--task", "Lift", "--scenes", TABLE, "--format", "npz"]
    assert run([*given, "--episodes", "1", "--out", str(out)]) == 0
    told = capsys.readouterr()
    assert json.loads((out / "dataset.json").read_text())["settings"]["randomization"] == "starts"
    plain = ["--episodes", "1", "--randomization", "None", "--out", f"{out}-plain"]
    assert run([*given, *plain]) == 0
    settings = json.loads(Path(f"{out}-plain/dataset.json").read_text())["settings"]
    assert settings["randomization"] is None
    capsys.readouterr()
    assert f"{out}: 1 of 1 episodes recorded" in told.out and "1/1" in told.err
    wrong = {
        "already exists": [*given, "--out", str(out)],
        "Did you mean 'Lift'": ["record", "--task", "Lifft"],
        "Did you mean 'light'": [*given, "--randomization", "lihgt", "--out", f"{out}-b"],
    }
    for reason, arguments in wrong.items():
        assert run(arguments) == 2
        (line,) = capsys.readouterr().err.splitlines()  # no progress
        assert line.startswith("error: ") and reason in line


@pytest.mark.slow
def test_the_command_line_loads_no_formats() -> None:
    code = "import sys; from generator import cli; cli.app('record'); "
    code += "print({'minari', 'h5py', 'av', 'pyarrow'} & set(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300
    )
    assert done.stdout.strip() == "set()"
