"""LeRobot datasets: the layout, the pictures, and what an interrupted recording ends in."""

import io
import json
import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

import av
import numpy as np
import pyarrow.parquet as pq
import pytest
from lerobot_doctor.dataset_loader import load_local
from lerobot_doctor.runner import Severity, run_checks
from made_episodes import CAMERAS, SIZE, made_episode, play_made
from PIL import Image

from generator.errors import InputError, StorageError
from tabletopgen_env.recording import LeRobotConfig, RecordConfig, record
from tabletopgen_env.recording.episodes import RecordedEpisode
from tabletopgen_env.recording.lerobot import depth as depths
from tabletopgen_env.recording.lerobot import videos, writer
from tabletopgen_env.recording.lerobot.assembly import Limits
from tabletopgen_env.recording.lerobot.features import features_of
from tabletopgen_env.recording.lerobot.segments import SegmentStore
from tabletopgen_env.recording.recorder import write_dataset

CONFIG = RecordConfig(
    "Lift", scenes=("office-round-*",), episodes=4, cameras=CAMERAS, image_size=SIZE
)
KEPT = (0, 2, 3, 5)  # of the episodes that ``play_made`` gives
STEPS = [3 + number for number in KEPT]
ALL = ("rgb", "depth", "segmentation")


@pytest.fixture(autouse=True)
def made(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", play_made)


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("tabletopgen_env.recording.recorder.play_episodes", play_made)
        return record(CONFIG, tmp_path_factory.mktemp("data") / "set", "lerobot")


def differing(one: Path, other: Path) -> dict[str, int]:
    """Return the files that differ in two folders, and the first differing byte of each."""
    mine, theirs = contents(one), contents(other)
    found: dict[str, int] = {}
    for name in sorted({*mine, *theirs}):
        a, b = mine.get(name, b""), theirs.get(name, b"")
        if a != b:
            pairs = enumerate(zip(a, b, strict=False))
            found[name] = next((k for k, (x, y) in pairs if x != y), min(len(a), len(b)))
    return found


def contents(folder: Path) -> dict[str, bytes]:
    files = [path for path in folder.rglob("*") if path.is_file()]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def told(folder: Path, name: str) -> Any:
    return json.loads((folder / "meta" / name).read_text())


def table(folder: Path, below: str) -> Any:
    """Return the rows of all table files, by column."""
    return pq.read_table(folder / below).to_pydict()


def severities(folder: Path) -> dict[str, Severity]:
    return {result.name: result.severity for result in run_checks(load_local(folder)).results}


def test_the_doctor_finds_no_failure(dataset: Path) -> None:
    found = severities(dataset)
    assert len(found) == 11 and Severity.FAIL not in found.values(), found
    for name in ("Metadata & Format Compliance", "Video Integrity", "Feature Consistency"):
        assert found[name] is Severity.PASS, name


def test_the_doctor_sees_a_damaged_one(dataset: Path, tmp_path: Path) -> None:
    copy = Path(shutil.copytree(dataset, tmp_path / "set"))
    video = next(copy.glob("videos/*wrist/*/*.mp4"))
    video.write_bytes(video.read_bytes()[:200])
    assert severities(copy)["Video Integrity"] is Severity.FAIL


def test_info_tells_features_rate_and_totals(dataset: Path) -> None:
    info = told(dataset, "info.json")
    assert info["codebase_version"] == "v3.0" and info["fps"] == 20
    assert (info["total_episodes"], info["total_frames"]) == (4, sum(STEPS))
    assert info["total_tasks"] == 2 and info["splits"] == {"train": "0:4"}
    features = info["features"]
    assert features["action"]["names"][-1] == "gripper" and features["action"]["shape"] == [5]
    assert features["observation.state"]["shape"] == [33]
    assert len(set(features["observation.state"]["names"])) == 33
    front = features["observation.images.front"]
    assert front["dtype"] == "video" and front["shape"] == [SIZE, SIZE, 3]
    assert front["info"]["video.codec"] == "h264" and front["info"]["is_depth_map"] is False
    assert "observation.environment_state" not in features
    settings = told(dataset, "tabletopgen.json")
    assert settings["settings"]["task"] == "Lift" and settings["lerobot"]["video"] == "h264"


def test_the_tables_hold_each_step_and_a_row_group_each_episode(dataset: Path) -> None:
    (path,) = (dataset / "data").rglob("*.parquet")
    file = pq.ParquetFile(path)
    assert [file.metadata.row_group(k).num_rows for k in range(4)] == STEPS
    rows = file.read().to_pydict()
    assert rows["index"] == [*range(sum(STEPS))]
    assert rows["episode_index"] == [k for k, n in enumerate(STEPS) for _ in range(n)]
    assert rows["frame_index"] == [k for n in STEPS for k in range(n)]
    assert rows["timestamp"] == pytest.approx([k / 20 for n in STEPS for k in range(n)])
    first, second = made_episode(KEPT[0]), made_episode(KEPT[1])
    done = np.concatenate([first.actions, second.actions])
    np.testing.assert_array_equal(np.float32(rows["action"][: len(done)]), done)
    state = np.float32(rows["observation.state"][: STEPS[0]])
    np.testing.assert_array_equal(state, first.proprio[:-1])
    assert rows["next.done"] == rows["next.truncated"]
    assert [k for k, done in enumerate(rows["next.done"]) if done] == [2, 7, 13, 21]
    assert rows["next.success"][:3] == np.asarray(first.infos["success"])[1:].tolist()
    views = np.float32(rows["camera.wrist.extrinsics"][:3]).reshape(3, 4, 4)
    np.testing.assert_array_equal(views, first.cameras["wrist"]["extrinsics"][:-1])


def test_tasks_are_a_frame_indexed_by_its_text(dataset: Path) -> None:
    found = pq.read_table(dataset / "meta" / "tasks.parquet")
    assert found.to_pydict() == {
        "task_index": [0, 1], "task": ["lift the cup", "lift the bowl"]
    }  # fmt: skip
    about = json.loads(found.schema.metadata[b"pandas"])
    assert about["index_columns"] == ["task"]
    rows = table(dataset, "data")
    assert rows["task_index"] == [0] * 3 + [0] * 5 + [1] * 6 + [1] * 8


def test_episodes_are_told_with_seed_scene_and_cameras(dataset: Path) -> None:
    rows = table(dataset, "meta/episodes")
    assert rows["seed"] == [*KEPT] and rows["length"] == STEPS
    assert rows["digest"][0] == "0" * 64 and rows["certified"] == [True] * 4
    assert rows["tasks"][2] == ["lift the bowl"] and rows["target"][0] == "cup"
    ends = np.cumsum(STEPS)
    assert rows["dataset_to_index"] == ends.tolist()
    assert rows["videos/observation.images.wrist/to_timestamp"] == pytest.approx(ends / 20)
    assert rows["cameras/front/intrinsics"][1] == [20.0, 0, 0, 0, 20.0, 0, 0, 0, 1.0]
    assert len(rows["stats/action/q99"][3]) == 5


def test_statistics_are_those_of_all_steps(dataset: Path) -> None:
    stats = told(dataset, "stats.json")
    episodes = [made_episode(number) for number in KEPT]
    actions = np.concatenate([episode.actions for episode in episodes]).astype(float)
    np.testing.assert_allclose(stats["action"]["mean"], actions.mean(0))
    np.testing.assert_allclose(stats["action"]["std"], actions.std(0))
    assert stats["action"]["count"] == [sum(STEPS)]
    colors = np.concatenate([e.pictures["front"][:-1] for e in episodes]) / 255
    front = stats["observation.images.front"]
    np.testing.assert_allclose(np.array(front["mean"]), colors.mean((0, 1, 2))[:, None, None])
    assert np.shape(front["q01"]) == (3, 1, 1)


@pytest.mark.parametrize("video", ["h264", "hevc", "av1"])
def test_frames_are_the_environments_within_the_codecs_loss(video: Any, tmp_path: Path) -> None:
    path = record(replace(CONFIG, episodes=2), tmp_path / "set", "lerobot",
                  lerobot=LeRobotConfig(video=video))  # fmt: skip
    for camera in CAMERAS:
        (file,) = path.glob(f"videos/observation.images.{camera}/*/*.mp4")
        shown = np.stack([*videos.decode(file)])
        true = np.concatenate([made_episode(n).pictures[camera][:-1] for n in KEPT[:2]])
        assert shown.shape == true.shape
        loss = np.mean((shown.astype(float) - true) ** 2)
        assert 10 * np.log10(255**2 / loss) > 30, camera


@pytest.mark.parametrize("codec", [*videos.CODECS.values(), videos.DEPTH_CODEC])
def test_any_frame_of_joined_videos_is_found_by_seeking(
    codec: videos.Codec, tmp_path: Path
) -> None:
    parts, true = [], []
    for number in range(4):
        pictures = made_episode(number, kinds=("rgb", "depth")).pictures
        true.append(
            pictures["front"] if codec.quality else depths.quantize(pictures["front_depth"])
        )
        parts.append(tmp_path / f"{number}.mp4")
        videos.encode(true[-1], parts[-1], 20, codec)
    videos.join(parts, tmp_path / "all.mp4", 20)
    for number, picture in enumerate(np.concatenate(true)):
        frame = sought(tmp_path / "all.mp4", number / 20, "rgb24" if codec.quality else "gray12le")
        assert np.abs(frame.astype(float) - picture).mean() < (10 if codec.quality else 0.1), number


def sought(path: Path, time: float, pixels: str) -> np.ndarray:
    """Return the frame at a time, decoded from its keyframe as LeRobot does."""
    with av.open(str(path)) as file:
        stream = file.streams.video[0]
        base = stream.time_base
        file.seek(round(time / base) - 1, backward=True, any_frame=False, stream=stream)
        for frame in file.decode(stream):
            if float(frame.pts * base) >= time - 1e-4:
                assert float(frame.pts * base) == pytest.approx(time)
                return frame.to_ndarray(format=pixels)
    raise AssertionError(f"no frame at {time}")


@pytest.mark.skipif(not hasattr(os, "sched_getscheduler"), reason="no such schedules here")
@pytest.mark.parametrize("name", videos.CODECS)
def test_encoding_leaves_the_process_scheduled_as_it_was(name: Any, tmp_path: Path) -> None:
    before = os.sched_getscheduler(0)
    pictures = np.random.default_rng(0).integers(0, 255, (3, 64, 64, 3), np.uint8)
    seen = []
    videos.encode((seen.append(os.sched_getscheduler(0)) or p for p in pictures),
                  tmp_path / "a.mp4", 20, videos.CODECS[name])  # fmt: skip
    assert [*seen, os.sched_getscheduler(0)] == [before] * 4


def test_depth_is_a_video_without_loss_of_twelve_bits(tmp_path: Path) -> None:
    path = record(replace(CONFIG, episodes=1, kinds=ALL), tmp_path / "set", "lerobot")
    true = made_episode(0, kinds=ALL).pictures["front_depth"][:-1]
    (file,) = path.glob("videos/observation.images.front_depth/*/*.mp4")
    shown = np.stack([*videos.decode(file, "gray12le")])
    np.testing.assert_array_equal(shown, depths.quantize(true))
    np.testing.assert_allclose(depths.restore(shown), true, atol=2e-3)
    info = told(path, "info.json")["features"]["observation.images.front_depth"]["info"]
    assert info["is_depth_map"] and info["depth_unit"] == "m" and info["video.depth_max"] == 10
    assert severities(path)["Video Integrity"] is Severity.PASS


def test_without_videos_pictures_are_kept_to_the_bit(tmp_path: Path) -> None:
    path = record(replace(CONFIG, episodes=1, kinds=ALL), tmp_path / "set", "lerobot",
                  lerobot=LeRobotConfig(video="none"))  # fmt: skip
    rows, true = table(path, "data"), made_episode(0, kinds=ALL).pictures
    assert not (path / "videos").exists()
    assert told(path, "info.json")["video_path"] is None
    for name, pictures in true.items():
        for step, picture in enumerate(pictures[:-1]):
            raw = rows[f"observation.images.{name}"][step]["bytes"]
            np.testing.assert_array_equal(np.asarray(Image.open(io.BytesIO(raw))), picture)
    found = severities(path)
    assert Severity.FAIL not in found.values(), found


def test_the_privileged_state_is_there_if_asked_for(tmp_path: Path) -> None:
    asked = LeRobotConfig(privileged=True)
    path = record(replace(CONFIG, episodes=1), tmp_path / "set", "lerobot", lerobot=asked)
    rows, first = table(path, "data"), made_episode(0)
    own, rest = rows["observation.state"], rows["observation.environment_state"]
    both = np.hstack([np.array(own)[:, :32], rest])  # the last is how fast the gripper moves
    np.testing.assert_array_equal(np.float32(both), first.state[:-1])
    names = told(path, "info.json")["features"]["observation.environment_state"]["names"]
    assert len(names) == len(set(names)) == 247


def test_every_entry_of_a_state_has_a_name_of_its_own() -> None:
    name = "observation.environment_state"
    for size in (247, 255):  # without and with the grasp hint
        values = {name: np.zeros((3, size), np.float32)}
        names = features_of(values, {}, 20, LeRobotConfig())[name]["names"]
        assert len(names) == len(set(names)) == size
        assert [n for n in names if n.startswith("grasp_hint.")] == names[247:]


def test_files_roll_over_and_rows_name_the_right_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "LIMITS", Limits(data_mb=0.02, video_mb=0.002, files=2))
    path = record(CONFIG, tmp_path / "set", "lerobot")
    rows = table(path, "meta/episodes")
    assert len(sorted((path / "data").rglob("*.parquet"))) > 1
    name = "videos/observation.images.front"
    used = set()
    for episode in range(4):
        place = file_of(rows, "data", episode)
        held = pq.read_table(path / "data" / f"{place}.parquet").to_pydict()
        assert episode in held["episode_index"]
        place = file_of(rows, name, episode)
        used.add(place)
        frames = np.stack([*videos.decode(path / name / f"{place}.mp4")])
        first = round(rows[f"{name}/from_timestamp"][episode] * 20)
        own = frames[first : first + STEPS[episode]]
        true = made_episode(KEPT[episode]).pictures["front"][:-1]
        assert np.abs(own.astype(float) - true).mean() < 8, episode
    assert len(used) > 2
    assert Severity.FAIL not in severities(path).values()


def file_of(rows: Any, what: str, episode: int) -> str:
    chunk, file = (rows[f"{what}/{part}_index"][episode] for part in ("chunk", "file"))
    return f"chunk-{chunk:03d}/file-{file:03d}"


def test_equal_settings_give_equal_bytes(dataset: Path, tmp_path: Path) -> None:
    assert contents(record(CONFIG, tmp_path / "again" / "set", "lerobot")) == contents(dataset)


@pytest.mark.parametrize("after", [1, 2, 3])
@pytest.mark.parametrize("failure", [KeyboardInterrupt, OSError(28, "No space left on device")])
def test_what_was_interrupted_goes_on_to_the_same_bytes(
    after: int, failure: Any, dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, publish = tmp_path / "new" / "set", SegmentStore.publish

    def fail(self: SegmentStore, segment: Any, index: int) -> None:
        if index == after:
            raise failure
        publish(self, segment, index)

    with monkeypatch.context() as patch:
        patch.setattr(SegmentStore, "publish", fail)
        expected = KeyboardInterrupt if failure is KeyboardInterrupt else StorageError
        with pytest.raises(expected, match=None if expected is KeyboardInterrupt else "No space"):
            record(CONFIG, out, "lerobot")
    assert [path.name for path in out.parent.iterdir()] == [".set.part"], "no half dataset"
    with pytest.raises(InputError, match="--resume"):
        record(CONFIG, out, "lerobot")
    with pytest.raises(InputError, match="seed was 0 and is now 1"):
        record(replace(CONFIG, seed=1), out, "lerobot", resume=True)
    reports: list[tuple[int, int]] = []
    record(CONFIG, out, "lerobot", resume=True, report=lambda *n: reports.append(n))
    assert reports[0] == (after, KEPT[after - 1] + 1) and reports[-1] == (4, 6)
    assert contents(out) == contents(dataset)
    assert [path.name for path in out.parent.iterdir()] == ["set"]


def test_every_episode_that_was_kept_is_in_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def played(first: int) -> Iterator[RecordedEpisode]:
        yield from (made_episode(number) for number in range(first, 4))

    def crash(*args: Any) -> None:
        raise OSError(5, "Input/output error")

    config, out = replace(CONFIG, episodes=1), tmp_path / "set"
    with closing(config.environment()) as env:
        with monkeypatch.context() as patch:
            patch.setattr("tabletopgen_env.recording.lerobot.assembly.join", crash)
            with pytest.raises(StorageError):
                write_dataset(config, env, lambda _: map(made_episode, (0, 2)), out, "lerobot")
        write_dataset(config, env, played, out, "lerobot", resume=True)
    assert table(out, "meta/episodes")["seed"] == [0, 2, 3]


@pytest.mark.parametrize("name", ["episodes", "lock", "recording.json", "dataset"])
def test_a_dataset_may_have_any_name(
    name: str, dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / name
    with monkeypatch.context() as patch:
        patch.setattr("tabletopgen_env.recording.lerobot.assembly.join", _interrupt)
        with pytest.raises(KeyboardInterrupt):
            record(CONFIG, out, "lerobot")
    reports: list[tuple[int, int]] = []
    record(CONFIG, out, "lerobot", resume=True, report=lambda *n: reports.append(n))
    assert reports == [(4, 6)] and differing(out, dataset) == {}


def test_none_is_dropped_where_fewer_are_asked_for(
    dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "set"
    with monkeypatch.context() as patch:
        patch.setattr("tabletopgen_env.recording.lerobot.assembly.join", _interrupt)
        with pytest.raises(KeyboardInterrupt):
            record(CONFIG, out, "lerobot")
    with pytest.raises(InputError, match="already has 4 episodes, more than the requested 3"):
        record(replace(CONFIG, episodes=3), out, "lerobot", resume=True)
    assert contents(record(CONFIG, out, "lerobot", resume=True)) == contents(dataset)


def test_a_failure_while_it_is_put_together_loses_nothing(
    dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "new" / "set"

    def full(*args: Any) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr("tabletopgen_env.recording.lerobot.assembly.join", full)
        with pytest.raises(StorageError, match="No space left"):
            record(CONFIG, out, "lerobot")
    assert not out.exists()
    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", full)  # all are there
    record(CONFIG, out, "lerobot", resume=True)
    assert contents(out) == contents(dataset)


def test_a_failure_before_the_first_episode_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*args: Any, **settings: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(writer, "encode", full)
    with pytest.raises(StorageError, match="No space left"):
        record(CONFIG, tmp_path / "set", "lerobot")
    assert list(tmp_path.iterdir()) == []


def test_a_damaged_episode_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tabletopgen_env.recording.lerobot.assembly.join", _interrupt)
    with pytest.raises(KeyboardInterrupt):
        record(CONFIG, tmp_path / "set", "lerobot")
    for text in ("{", '{"number": 1}', '{"number": -1, "length": 1, "task": 2, "facts": {}}'):
        about = tmp_path / ".set.part" / "episodes" / "episode-000001" / "episode.json"
        about.write_text(text)
        with pytest.raises(StorageError, match="recorded episode"):
            record(CONFIG, tmp_path / "set", "lerobot", resume=True)


def _interrupt(*args: Any) -> None:
    raise KeyboardInterrupt


def test_one_recording_at_a_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def again(*args: Any) -> Any:
        with pytest.raises(InputError, match="Another process"):
            record(CONFIG, tmp_path / "set", "lerobot", resume=True)
        raise KeyboardInterrupt
        yield

    monkeypatch.setattr("tabletopgen_env.recording.recorder.play_episodes", again)
    with pytest.raises(KeyboardInterrupt):
        record(CONFIG, tmp_path / "set", "lerobot")
    assert list(tmp_path.iterdir()) == []


def test_a_part_folder_that_leads_elsewhere_is_refused(tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / ".set.part").symlink_to(tmp_path / "other")
    with pytest.raises(InputError, match="is a symbolic link"):
        record(CONFIG, tmp_path / "set", "lerobot", resume=True)
    assert not any((tmp_path / "other").iterdir())


def test_wrong_requests_are_explained(
    tmp_path: Path, dataset: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cases: list[tuple[RecordConfig, dict[str, Any], str]] = [
        (CONFIG, {"out": dataset}, "already exists"),
        (CONFIG, {"lerobot": LeRobotConfig(video="h265")}, "Unknown video codec 'h265'"),  # type: ignore[arg-type]
        (CONFIG, {"lerobot": LeRobotConfig(quality=99)}, "quality must be a whole number"),
        (CONFIG, {"format": "npz", "resume": True}, "'npz' cannot be resumed; only lerobot"),
        (replace(CONFIG, image_size=15), {}, "an even width and height, but 'front' has 15 x 15"),
    ]
    for config, settings, reason in cases:
        with pytest.raises(InputError, match=reason):
            record(config, **{"out": tmp_path / "new", "format": "lerobot", **settings})
    monkeypatch.setattr(videos, "_encoders", lambda: {"libx265"})
    with pytest.raises(InputError, match=r"no libx264, .* available: hevc\. .* --video none"):
        record(CONFIG, tmp_path / "new", "lerobot")
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(InputError, match=r"package av, .* pip install 'tabletopgen\[lerobot\]'"):
        record(CONFIG, tmp_path / "new", "lerobot")
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(InputError, match="needs the package pyarrow"):
        record(CONFIG, tmp_path / "new", "lerobot")
    assert not (tmp_path / "new").exists() and not (tmp_path / ".new.part").exists()
