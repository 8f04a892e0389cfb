"""Shards give back what was put in, and say clearly when they are damaged."""

import dataclasses
import zipfile
from pathlib import Path

import numpy as np
import pytest

from generator.errors import StorageError
from generator.scene import View
from research.eye.sample import OBJECT, TOP, Sample, fill, latitude
from research.eye.shards import ShardReader, ShardWriter

SIDE = 64


def sample(seed: int) -> Sample:
    rng = np.random.default_rng(seed)
    outline = np.array([[4, 10], [60, 10], [70, 50], [-8, 50]], np.float32)
    top = fill(outline, SIDE, SIDE)
    full = np.zeros((2, SIDE, SIDE), bool)
    full[0, 20:40, 10:30] = True
    full[1, 25:45, 22:50] = True
    visible = np.where(full[1], 2, np.where(full[0], 1, 0)).astype(np.uint8)
    region = np.where(top, TOP, 0).astype(np.uint8)
    region[visible > 0] = OBJECT
    depth = rng.uniform(0.5, 3, (SIDE // 2, SIDE // 2)).repeat(2, 0).repeat(2, 1)
    depth[:8] = np.inf
    smooth = np.linspace(0, 255, SIDE)[:, None, None] * np.ones((1, SIDE, 3))
    return Sample(
        image=smooth.astype(np.uint8),
        visible=visible,
        full=full,
        category=np.array([3, -1], np.int16),
        region=region,
        top=top,
        outline=outline,
        view=View(0.1, 0.6, 0.7),
        focal=88.0,
        yaw=np.array([0.5, -1.0], np.float32),
        upright=np.array([True, False]),
        size=np.array([[0.1, 0.1, 0.2], [0.3, 0.2, 0.1]], np.float32),
        position=rng.uniform(-1, 1, (2, 3)).astype(np.float32),
        support=np.array([0, 1], np.int16),
        depth=depth.astype(np.float16),
    )


@pytest.fixture
def shard(tmp_path: Path) -> Path:
    path = tmp_path / "a.shard"
    with ShardWriter(path, ("book", "mug", "pen", "plate")) as writer:
        for seed in range(3):
            writer.add(sample(seed))
    return path


def test_a_sample_comes_back_as_it_was(shard: Path) -> None:
    reader = ShardReader(shard)
    assert len(reader) == 3
    assert reader.keys == ("book", "mug", "pen", "plate")
    for index in (2, 0):
        put, got = sample(index), reader[index]
        for name in ("visible", "full", "category", "region", "top", "upright", "support"):
            assert np.array_equal(getattr(got, name), getattr(put, name)), name
        for name in ("outline", "yaw", "size", "position"):
            assert np.allclose(getattr(got, name), getattr(put, name), atol=0.006), name
        assert (got.view, got.focal) == (put.view, put.focal)
        assert np.abs(got.image.astype(int) - put.image).max() <= 6
        assert np.array_equal(np.isinf(got.depth), np.isinf(put.depth))
        near = np.isfinite(put.depth)
        assert np.allclose(got.depth[near], put.depth[near], rtol=0.02)


def test_depth_may_be_left_out(shard: Path) -> None:
    assert ShardReader(shard).read(1, depth=False).depth.shape == (0, 0)


def test_same_samples_same_bytes(shard: Path, tmp_path: Path) -> None:
    again = tmp_path / "b.shard"
    with ShardWriter(again, ("book", "mug", "pen", "plate")) as writer:
        for seed in range(3):
            writer.add(sample(seed))
    assert again.read_bytes() == shard.read_bytes()


def test_an_unfinished_shard_leaves_nothing(tmp_path: Path) -> None:
    with (
        pytest.raises(RuntimeError, match="stopped"),
        ShardWriter(tmp_path / "c.shard", ()) as writer,
    ):
        writer.add(sample(0))
        raise RuntimeError("stopped")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("harm", ["cut", "flipped", "gone", "foreign"])
def test_a_damaged_shard_says_so(shard: Path, harm: str) -> None:
    content = bytearray(shard.read_bytes())
    if harm == "cut":
        shard.write_bytes(content[: len(content) // 2])
    elif harm == "flipped":
        content[300:400] = bytes(100)  # inside the first picture
        shard.write_bytes(content)
    elif harm == "gone":
        shard.unlink()
    else:
        shard.write_bytes(b"not a shard")
    with pytest.raises(StorageError, match=r"a\.shard.*render again"):
        ShardReader(shard)[0]


def test_an_index_outside_is_refused(shard: Path) -> None:
    with pytest.raises(IndexError, match="3 samples"):
        ShardReader(shard)[3]


def test_latitude_is_the_elevation_at_the_middle_and_grows_downwards() -> None:
    view = View(0.3, 0.6, 0.8)
    angle = latitude(view, 101, 101)
    assert angle[50, 50] == pytest.approx(0.6, abs=1e-3)
    assert (np.diff(angle[:, 50]) > 0).all()
    assert angle[100, 50] - angle[0, 50] == pytest.approx(0.8, abs=0.02)


def test_no_outline_fills_nothing() -> None:
    empty = dataclasses.replace(sample(0), outline=np.zeros((0, 2), np.float32))
    assert not fill(empty.outline, 8, 8).any()


@pytest.mark.parametrize("version", ["true", "2"])
def test_shards_of_another_format_are_refused(tmp_path: Path, version: str) -> None:
    path = tmp_path / "shard.zip"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("shard.json", f'{{"format": {version}, "count": 0, "keys": []}}')
    with pytest.raises(StorageError, match="shard format"):
        ShardReader(path)
