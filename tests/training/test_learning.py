"""Crops with their targets, the terms of the loss, and a run that stops and goes on."""

import argparse

import numpy as np
import pytest
import torch

from generator.backends.embedded.eye.network import REGIONS, STRIDE, Eye
from generator.errors import InputError
from generator.scene import View
from research.eye import losses, train
from research.eye.sample import OBJECT, TOP, Sample
from research.eye.shards import ShardWriter
from research.eye.targets import cut
from research.eye.vocabulary import VOCABULARY


def sample() -> Sample:
    """Return a picture with a red square, half hidden by a blue one, on a tabletop."""
    visible = np.zeros((128, 128), np.uint8)
    visible[40:80, 30:70] = 1
    visible[60:100, 50:90] = 2
    full = np.zeros((2, 128, 128), bool)
    full[0, 40:80, 30:70], full[1, 60:100, 50:90] = True, True
    image = np.full((128, 128, 3), 200, np.uint8)
    image[visible == 1], image[visible == 2] = (200, 30, 30), (30, 30, 200)
    region = np.where(visible > 0, OBJECT, TOP).astype(np.uint8)
    corners = np.array([[0, 0], [128, 0], [128, 128], [0, 128]], np.float32)
    return Sample(
        image, visible, full, np.array([0, -1], np.int16), region, np.ones((128, 128), bool),
        corners, View(0.0, 0.9, 0.6), 200.0, np.zeros(2, np.float32), np.ones(2, bool),
        np.ones((2, 3), np.float32), np.zeros((2, 3), np.float32), np.zeros(2, np.int16),
        np.ones((128, 128), np.float16),
    )  # fmt: skip


@pytest.mark.parametrize("seed", range(6))
def test_targets_belong_together(seed):
    crop = cut(sample(), 96, np.random.default_rng(seed))
    assert crop.image.shape == (96, 96, 3) and crop.heat.shape == (24, 24)
    for (x, y), masks, sides in zip(crop.cells, crop.masks, crop.boxes, strict=True):
        block = masks[0][y * 2 : y * 2 + 2, x * 2 : x * 2 + 2]
        assert block.any(), "a cell answers for a thing that it shows"
        assert (masks[1] | ~masks[0]).all(), "what shows is part of the whole"
        rows = np.flatnonzero(masks[0].any(1)) * 2
        low = (y + 0.5) * STRIDE - sides[1] * STRIDE
        assert low == pytest.approx(rows[0], abs=3)
    assert crop.heat.max() <= 1 and (crop.heat[crop.region != REGIONS.index("thing")] < 0.9).all()


def test_the_same_seed_cuts_the_same_crop():
    first, again = (cut(sample(), 64, np.random.default_rng(3)) for _ in range(2))
    np.testing.assert_array_equal(first.image, again.image)
    np.testing.assert_array_equal(first.masks, again.masks)


def test_the_right_answer_costs_least():
    wished = torch.zeros(2, 16, 16)
    wished[:, 4:9, 3:12] = 1
    right, wrong = 12 * (2 * wished - 1), 12 * (1 - 2 * wished)
    assert losses.overlap_loss(right, wished) < 0.05 < 0.9 < losses.overlap_loss(wrong, wished)
    weight = torch.ones_like(wished)
    assert losses.heat_loss(right, wished, weight) < 1e-3 < losses.heat_loss(wrong, wished, weight)
    assert losses.heat_loss(wrong, wished, 0 * weight) == 0


@pytest.mark.slow
def test_every_term_reaches_the_network():
    torch.manual_seed(0)
    eye = Eye(len(VOCABULARY) + 1)
    rng = np.random.default_rng(0)
    batch = train.collate([cut(sample(), 64, rng) for _ in range(4)])
    found = losses.terms(eye, batch)
    assert set(found) == set(losses.WEIGHTS)
    losses.total(found).backward()
    still = [n for n, p in eye.named_parameters() if p.grad is None or not p.grad.abs().sum()]
    assert not still


def test_a_mask_is_judged_by_the_thing_it_fits_best():
    things = torch.zeros(2, 8, 8, dtype=torch.uint8)
    things[:, 1:5, 1:5], things[:, 5:8, 5:8] = 1, 3
    drawn = torch.zeros(2, 8, 8, dtype=torch.bool)
    drawn[0, 1:5, 1:3], drawn[1, 5:8, 5:8] = True, True
    torch.testing.assert_close(losses.best_overlap(drawn, things), torch.tensor([0.5, 1.0]))


def _args(data, out, minutes: float) -> argparse.Namespace:
    return argparse.Namespace(
        data=data, out=out, minutes=minutes, batch=2, size=64, rate=1e-3, seed=0, workers=0,
        device="cpu", start="imagenet", learn="all",
    )  # fmt: skip


@pytest.mark.slow
def test_a_run_goes_on_where_it_stopped(tmp_path, monkeypatch):
    monkeypatch.setattr(train, "new_eye", lambda: Eye(len(VOCABULARY) + 1))
    with ShardWriter(tmp_path / "a.shard", list(VOCABULARY)) as shard:
        shard.add(sample())
    train.train(_args(tmp_path, tmp_path / "run", 1e-4))
    first = train.TrainingRun(tmp_path / "run", 1e-3, "cpu")
    assert first.steps >= 1 and first.spent > 0
    train.train(_args(tmp_path, tmp_path / "run", 2e-4 + first.spent / 60))
    assert train.TrainingRun(tmp_path / "run", 1e-3, "cpu").steps > first.steps


def test_late_in_a_run_whole_pictures_take_turns_with_crops(tmp_path):
    with ShardWriter(tmp_path / "a.shard", list(VOCABULARY)) as shard:
        shard.add(sample())
    crops = train.Crops(tmp_path, 64, 0)
    early, late = (train.Steps(crops, 8, 10, late=x) for x in (False, True))
    assert [len(early[k].image) for k in range(2)] == [8, 8]
    assert [tuple(late[k].image.shape) for k in range(2)] == [(2, 3, 128, 128), (8, 3, 64, 64)]
    torch.testing.assert_close(late[1].image, early[1].image)


@pytest.mark.slow
def test_settled_norms_keep_their_statistics(tmp_path, monkeypatch):
    monkeypatch.setattr(train, "new_eye", lambda: Eye(len(VOCABULARY) + 1))
    run = train.TrainingRun(tmp_path, 1e-3, "cpu")
    run.settle()
    before = {k: v.clone() for k, v in run.eye.state_dict().items() if "running" in k}
    run.step(train.collate([cut(sample(), 64, np.random.default_rng(0))]), 0.0)
    after = run.eye.state_dict()
    assert before and all(torch.equal(after[k], v) for k, v in before.items())


def test_an_empty_folder_is_refused(tmp_path):
    with pytest.raises(InputError, match="No shards"):
        train.Crops(tmp_path, 64, 0)


def test_new_categories_start_as_unknown_does():
    state = {f"namer.1.{part}": torch.arange(3.0) for part in ("weight", "bias")}
    changed = train.rename_categories(state, ["a", "b"], ["b", "c"])
    assert changed["namer.1.bias"].tolist() == [1.0, 2.0, 2.0]


def test_rough_masks_are_none_of_nothing():
    """The outliner's prompt shows part of the object, at the resolution of the features."""
    torch.manual_seed(0)
    wished = torch.zeros(40, 64, 64)
    wished[:, 20:44, 12:50] = 1
    rough = losses.roughen(wished, torch.zeros(40, 32, 32))
    assert rough.shape == (40, 32, 32)
    inside = torch.nn.functional.avg_pool2d(wished[:, None], 2)[:, 0]
    assert ((rough > 0.5) & (inside > 0.5)).sum((1, 2)).min() >= 4
    assert len({round(float(mask.sum())) for mask in rough}) > 8
