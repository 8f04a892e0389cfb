"""The judge of the eye's detections: its features, its choices, and its training."""

import numpy as np
import pytest
import torch
from painted import paint

from generator.backends.embedded.eye.judge import (
    ALONE,
    BOTH,
    Clues,
    DetectionJudge,
    EyeDetection,
    clues_of,
)
from research.eye.judging import JudgeLesson, lesson, train_judge

REGION = np.full((4, 40, 60), 0.25)


def detection(x0: int, y0: int, x1: int, y1: int, score: float = 0.5) -> EyeDetection:
    mask = np.zeros(REGION.shape[1:], bool)
    mask[y0:y1, x0:x1] = True
    return EyeDetection(score, score, mask, mask, np.array([0.7, 0.2, 0.1]))


def test_pairs_that_touch_have_clues_the_larger_one_first():
    detections = [detection(10, 10, 20, 20), detection(5, 5, 35, 35), detection(50, 5, 55, 10)]
    clues = clues_of(detections, REGION)
    assert clues.alone.shape == (3, ALONE) and clues.both.shape == (1, BOTH)
    assert clues.pairs.tolist() == [[1, 0]]
    assert np.isfinite(clues.alone).all() and np.isfinite(clues.both).all()


def test_a_lone_detection_is_clueless_about_others():
    alone = clues_of([detection(10, 10, 20, 20)], REGION).alone[0]
    crowded = clues_of([detection(10, 10, 20, 20), detection(8, 8, 30, 30)], REGION).alone[0]
    np.testing.assert_array_equal(alone[:14], crowded[:14])  # what it is itself
    assert not alone[14:26].any() and crowded[14:26].any()  # how others overlap it


@pytest.mark.parametrize("count", [0, 1])
def test_none_and_one_can_be_judged(count: int):
    clues = clues_of([detection(10, 10, 20, 20)][:count], REGION)
    assert len(DetectionJudge().eval().choose(clues, 0.0)) == count


class Given(torch.nn.Module):
    """A panel that answers with given logits."""

    def __init__(self, *logits: float) -> None:
        super().__init__()
        self.logits = torch.tensor([logits])

    def forward(self, clues: torch.Tensor) -> torch.Tensor:
        return self.logits


@pytest.mark.parametrize(("apart", "kept"), [(3.0, [1, 0]), (-3.0, [1])])
def test_a_detection_goes_if_it_is_likely_the_same_as_a_surer_one(apart: float, kept: list[int]):
    judge = DetectionJudge()
    judge.alone, judge.both = Given(1.0, 2.0, -2.0), Given(apart)  # type: ignore[assignment]
    clues = Clues(np.zeros((3, ALONE)), np.array([[0, 1]]), np.zeros((1, BOTH)))
    chosen = judge.choose(clues, 0.5)
    assert [k for k, _ in chosen] == kept
    assert chosen[0][1] == pytest.approx(1 / (1 + np.exp(-2)))


@pytest.mark.slow
def test_a_lesson_is_learned_and_kept(tmp_path):
    rng = np.random.default_rng(0)
    alone = rng.normal(size=(800, ALONE)).astype(np.float32)
    both = rng.normal(size=(800, BOTH)).astype(np.float32)
    counts = np.arange(800) < 600
    right = np.where(counts, alone[:, 0] > 0, alone[:, 0] < 0)  # what does not count misleads
    told = JudgeLesson(alone, right, counts, both, both[:, 1] + both[:, 2] > 0)
    told.save(tmp_path / "lesson.npz")
    kept = JudgeLesson.load(tmp_path / "lesson.npz")
    np.testing.assert_array_equal(kept.right, told.right)
    judge = train_judge(JudgeLesson.join([kept]), 0, steps=150)
    with torch.inference_mode():
        sure = judge.alone(torch.from_numpy(alone)).mean(0).numpy() > 0
        apart = judge.both(torch.from_numpy(both)).mean(0).numpy() > 0
    assert (sure == (alone[:, 0] > 0)).mean() > 0.95
    assert (apart == told.apart).mean() > 0.9


@pytest.mark.slow
def test_a_picture_teaches_which_finds_show_a_thing():
    painted = paint("rectangle", "oak", [("mug", -0.25, 0.0, 0.0), ("book", 0.25, 0.0, 0.0)])
    visible = np.clip(painted.ids, 0, None).astype(np.uint8)
    full = np.stack([visible == 1, visible == 2])
    told = lesson(painted.image, visible, full)
    assert told.right.sum() >= 2 and told.counts.all()
    assert not lesson(painted.image, np.zeros_like(visible), full[:0]).right.any()
    hidden = np.stack([np.ones_like(visible, bool), visible == 2])  # hardly any of it shows
    assert not lesson(painted.image, visible, hidden).counts.all()
