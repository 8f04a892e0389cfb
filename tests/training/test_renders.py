"""Rendered samples agree with the scene they show; skipped where there is no OpenGL."""

import dataclasses
import itertools
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from scipy.ndimage import binary_dilation, binary_erosion

from generator.errors import BackendError
from research.eye.pictures import gl, renders
from research.eye.pictures.gl import GlPainter
from research.eye.pictures.rendering import draw, render_sample
from research.eye.pictures.staging import stage
from research.eye.pictures.supply import KEYS, SEEDS, Supply, supply
from research.eye.sample import BACKGROUND, OBJECT, TABLE_REST, TOP, Sample

SIDE = 256


@pytest.fixture(scope="module")
def kept() -> Supply:
    return supply(5, "train", models=24, tables=3)


@pytest.fixture(scope="module")
def painter(kept: Supply) -> Iterator[GlPainter]:
    try:
        made = GlPainter(kept.stock, SIDE)
    except BackendError as error:
        pytest.skip(str(error))
    yield made
    made.close()


@pytest.fixture(scope="module")
def samples(kept: Supply, painter: GlPainter) -> list[Sample]:
    return [render_sample(np.random.default_rng([3, k]), kept, painter) for k in range(3)]


@pytest.mark.slow
def test_masks_fit_together(samples: list[Sample]) -> None:
    assert sum(len(s.full) for s in samples) > 5
    for s in samples:
        assert s.image.shape == (SIDE, SIDE, 3)
        assert s.visible.max() == len(s.full) == len(s.category) == len(s.size) == len(s.support)
        for k, mask in enumerate(s.full):
            assert mask[s.visible == k + 1].all()
            assert (s.visible == k + 1).any()
        assert np.array_equal(s.region == OBJECT, s.visible > 0)
        assert s.top[s.region == TOP].mean() > 0.99
        assert not s.top[s.region == TABLE_REST].any()
        assert ((s.category >= -2) & (s.category < len(KEYS))).all()
        assert (s.support <= len(s.full)).all()


@pytest.mark.slow
def test_whole_masks_lie_where_the_camera_sees_the_boxes(samples: list[Sample]) -> None:
    for s in samples:
        for k, mask in enumerate(s.full):
            reach = np.linalg.norm(s.size[k]) / 2 * s.focal
            rows, columns = np.nonzero(mask)
            distance = float(np.median(s.depth[s.visible == k + 1].astype(float)))
            extent = max(np.ptp(rows), np.ptp(columns))
            assert extent <= 2.6 * reach / distance + 4


def test_the_top_lies_on_its_plane(kept: Supply, painter: GlPainter) -> None:
    """The depth of visible pixels of the table top is that of the plane of its outline."""
    staging = stage(np.random.default_rng(4), kept, SIDE)
    s = draw(np.random.default_rng(0), staging, kept, painter)
    sure = binary_erosion(s.region == TOP, iterations=3)
    rows, columns = np.nonzero(sure)
    assert len(rows) > 300
    pixels = np.column_stack([columns, rows]) + 0.5
    points = staging.camera.on_plane(pixels, float(staging.outline[0, 2]))
    expected = staging.camera.to_camera(points)[:, 2]
    assert np.allclose(s.depth[sure].astype(float), expected, rtol=0.01)


def test_an_object_alone_covers_what_it_shows(kept: Supply, painter: GlPainter) -> None:
    """Without occlusion, an object's complete mask equals its visible one."""
    staging = stage(np.random.default_rng(8), kept, SIDE)
    assert staging.objects
    alone = dataclasses.replace(
        staging, objects=staging.objects[:1], placed=staging.placed[:1], cartoon=False
    )
    s = draw(np.random.default_rng(0), alone, kept, painter)
    if len(s.full):
        seen = s.visible == 1
        assert not (s.full[0] & ~binary_dilation(seen, iterations=2)).any()


def test_samples_depend_on_their_seed_alone(
    kept: Supply, painter: GlPainter, samples: list[Sample]
) -> None:
    again = render_sample(np.random.default_rng([3, 1]), kept, painter)
    for name in ("image", "visible", "full", "region", "outline", "depth", "category"):
        assert np.array_equal(getattr(again, name), getattr(samples[1], name)), name
    assert not np.array_equal(again.image, samples[0].image)


def test_nothing_floats_or_leaves_the_table(kept: Supply) -> None:
    for seed in range(6):
        staging = stage(np.random.default_rng(seed), kept, SIDE)
        height = float(staging.outline[0, 2])
        for placed in staging.placed:
            low = float(placed.vertices(kept.models[placed.model])[:, 2].min())
            assert low >= height - 1e-6
            if placed.support == 0:
                assert low == pytest.approx(height, abs=1e-6)


@pytest.mark.slow
def test_finished_shards_are_not_made_again(
    tmp_path: Path, painter: GlPainter, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(renders, "SIDE", 64)
    monkeypatch.setattr(renders, "PER_SHARD", 2)
    monkeypatch.setattr(
        renders, "supply", lambda seed, split: supply(seed, split, models=12, tables=2)
    )
    jobs = renders.plan(tmp_path, 3, 1, "eval")
    assert [(job.number, job.samples) for job in jobs] == [(0, 2), (1, 1)]
    assert [renders.render(job) for job in jobs] == [2, 1]
    first = [path.read_bytes() for path in sorted(tmp_path.iterdir())]
    assert renders.plan(tmp_path, 3, 1, "eval") == ()
    (tmp_path / "eval-1-00001.shard").unlink()
    left = renders.plan(tmp_path, 3, 1, "eval")
    assert [(job.number, job.samples) for job in left] == [(1, 1)]
    renders.render(left[0])
    assert [path.read_bytes() for path in sorted(tmp_path.iterdir())] == first


def test_splits_share_no_catalogue_seed() -> None:
    ranges = sorted(SEEDS.values())
    assert all(last <= first for (_, last), (first, _) in itertools.pairwise(ranges))


@pytest.mark.slow
def test_evaluated_things_look_as_the_catalogue_makes_them() -> None:
    kept = supply(5, "eval", models=24, tables=3)
    for seed in range(4):
        staging = stage(np.random.default_rng(seed), kept, SIDE)
        for thing, placed in zip(staging.objects, staging.placed, strict=True):
            assert thing.texture == thing.mesh == kept.model_mesh(placed.model)
            assert thing.color[:3] == (1.0, 1.0, 1.0)


def test_without_opengl_the_error_names_the_packages(
    kept: Supply, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(gl.importlib, "import_module", refuse)
    with pytest.raises(BackendError, match="libegl1"):
        GlPainter(kept.stock, SIDE)


def test_background_is_there(samples: list[Sample]) -> None:
    assert any((s.region == BACKGROUND).any() for s in samples)
