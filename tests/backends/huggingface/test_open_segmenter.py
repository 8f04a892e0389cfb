"""The segmenter with open models: with correct answers from players, and with real classes."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
import transformers
from painted import paint
from played_models import play, tokenizer

from generator.backends.huggingface.detection.detections import BoxDetection
from generator.backends.huggingface.detection.grounding_dino import GroundingDino
from generator.backends.huggingface.detection.sam2 import Sam2, enlarge
from generator.backends.huggingface.detection.tiles import tiles_of
from generator.backends.huggingface.segmenter import HuggingFaceSegmenter
from generator.backends.huggingface.weights.loader import load_model
from generator.backends.huggingface.weights.pins import pins
from generator.backends.protocols import Segmenter as Protocol
from generator.errors import BackendError, SceneError
from generator.geometry import mask_box
from generator.meshes.pixels import mask_iou
from generator.scene import TABLE, Detection

PLACES = [("mug", -0.3, -0.1, 0.0), ("book", 0.1, 0.0, 0.0), ("apple", 0.35, -0.15, 0.0)]
WORDS = ("mug", "book", "apple")
DETECTORS = ("grounding-dino-tiny", "sam3")


@dataclass(frozen=True, eq=False)
class Desk:
    """A painted table with three objects, and the mask of each."""

    image: np.ndarray
    masks: dict[str, np.ndarray]


@pytest.fixture(scope="module")
def desk() -> Desk:
    picture = paint("rectangle", "oak", PLACES)
    names = (TABLE, *WORDS)
    return Desk(picture.image, {n: picture.ids == k for k, n in enumerate(names)})


def block(shape: tuple[int, int], x0: int, y0: int, x1: int, y1: int) -> np.ndarray:
    mask = np.zeros(shape, bool)
    mask[y0:y1, x0:x1] = True
    return mask


def noise(height: int = 120, width: int = 160) -> np.ndarray:
    """Return a picture whose parts all look different."""
    return np.random.default_rng(1).integers(0, 256, (height, width, 3)).astype(np.uint8)


def asked(
    image: np.ndarray,
    truth: list[tuple[str, np.ndarray]],
    *labels: str,
    detector: str = DETECTORS[0],
    **settings: Any,
) -> tuple[Detection, ...]:
    segmenter = HuggingFaceSegmenter(detector, **settings)
    play(segmenter, image, truth)
    return segmenter.segment(image, labels)


# ------------------------------------------------------------------------------------ the players
@pytest.mark.slow
@pytest.mark.parametrize("detector", DETECTORS)
def test_what_the_models_see_is_found_whole_and_once(desk: Desk, detector: str) -> None:
    """Every object is in the whole picture and in one to four tiles."""
    segmenter = HuggingFaceSegmenter(detector, side=96)
    play(segmenter, desk.image, list(desk.masks.items()))
    table, *things = segmenter.segment(desk.image, (TABLE, *WORDS, "mug"))
    assert table.label == TABLE
    assert mask_iou(table.mask, desk.masks[TABLE]) > 0.9
    assert sorted(d.label for d in things) == sorted(WORDS)
    for thing in things:
        assert mask_iou(thing.mask, desk.masks[thing.label]) > 0.8
        np.testing.assert_array_equal(thing.box, mask_box(thing.mask))
        assert not (thing.mask & table.mask).any()
        assert 0.7 < thing.score <= 1
    assert [d.box[3] for d in things] == sorted(d.box[3] for d in things)


@pytest.mark.slow
def test_small_things_are_masked_in_the_part_that_shows_them_large() -> None:
    image, shape = noise(480, 640), (480, 640)
    y, x = np.mgrid[:480, :640]
    ring = (np.hypot(x - 110, y - 310) < 12) & ~(np.hypot(x - 110, y - 310) < 5)
    truth = [(TABLE, block(shape, 20, 40, 620, 460)), ("ring", ring)]
    closely, far = (asked(image, truth, "ring", tiles=n, side=96)[1].mask for n in (4, 1))
    assert mask_iou(closely, ring) > 0.88 > 0.8 > mask_iou(far, ring)


def test_what_a_part_cuts_is_found_in_the_whole() -> None:
    """Tiles of 2 x 2 with an overlap of a quarter are 92 of 160 pixels wide."""
    shape = (120, 160)
    truth = [(TABLE, block(shape, 5, 5, 155, 115)), ("tray", block(shape, 30, 40, 130, 80))]
    found = asked(noise(), truth, "tray", side=96)
    assert [d.label for d in found] == [TABLE, "tray"]
    assert mask_iou(found[1].mask, truth[1][1]) > 0.9


@pytest.mark.slow
def test_anything_is_called_as_the_catalogue_s_categories_where_it_looks_like_one() -> None:
    shape = (120, 160)
    mug, thing = block(shape, 20, 20, 50, 50), block(shape, 90, 60, 130, 100)
    truth = [(TABLE, block(shape, 5, 5, 155, 115)), ("object", mug), ("object", thing)]
    truth += [("mug", mug), ("table", truth[0][1])]
    found = asked(noise(), truth, TABLE, "object", side=96, words=40)
    assert [d.label for d in found] == [TABLE, "mug", "object"]
    named = asked(noise(), truth, TABLE, "object", detector="sam3")
    assert [d.label for d in named] == [TABLE, "mug", "object"]


@pytest.mark.parametrize("detector", DETECTORS)
def test_the_table_by_another_word_is_no_thing_on_it_and_takes_no_table_away(detector: str) -> None:
    shape = (120, 160)
    table, mug = block(shape, 5, 5, 155, 115), block(shape, 60, 50, 90, 80)
    truth = [("desk", table), (TABLE, block(shape, 5, 5, 152, 115)), ("mug", mug)]
    found = asked(noise(), truth, "desk", "mug", detector=detector, side=96)
    assert [d.label for d in found] == [TABLE, "mug"]


@pytest.mark.parametrize(("right", "kept"), [(158, False), (115, True)])
def test_what_stands_beside_the_table_is_left_out(right: int, kept: bool) -> None:
    shape = (120, 160)
    table = block(shape, 5, 60, 125, 115)
    truth = [(TABLE, table), ("lamp", block(shape, right - 25, 10, right, 90))]
    found = asked(noise(), truth, "lamp", detector="sam3")
    assert [d.label for d in found] == [TABLE, *(["lamp"] if kept else [])]


@pytest.mark.parametrize(
    ("truth", "settings", "told"),
    [
        ({"mug": (60, 50, 90, 80)}, {"side": 96}, "No table found"),
        ({TABLE: (20, 20, 140, 100), "left": (20, 20, 80, 100), "right": (80, 20, 140, 100)},
         {"detector": "sam3"}, "hide the whole table"),
    ],
)  # fmt: skip
def test_a_picture_without_a_table_or_with_one_wholly_hidden_is_told(truth, settings, told) -> None:
    seen = [(label, block((120, 160), *box)) for label, box in truth.items()]
    with pytest.raises(SceneError, match=told):
        asked(noise(), seen, *(label for label in truth if label != TABLE), **settings)


@pytest.mark.parametrize("detector", DETECTORS)
def test_a_model_that_fails_names_backend_and_question(
    detector: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    segmenter = HuggingFaceSegmenter(detector)
    players = play(segmenter, noise(), [])

    def fail(*_: Any, **__: Any) -> None:
        raise RuntimeError("CUDA out of memory")

    monkeypatch.setattr(type(players["finder"]), "__call__", fail)
    monkeypatch.setattr(type(players["finder"]), "tile", fail)
    with pytest.raises(
        BackendError, match=r"huggingface, segment: the model failed \(RuntimeError: CUDA"
    ):
        segmenter.segment(noise(), (TABLE,))


# --------------------------------------------------------------------------------- the real classes
@pytest.mark.slow
@pytest.mark.parametrize("detector", DETECTORS)
def test_tiny_models_of_the_real_classes_answer_and_repeat_themselves(
    tiny_models: Path, detector: str
) -> None:
    """Their weights are random, so only the form of the answer is meaningful."""
    settings = {"threshold": 0.2, "side": 64, "words": 2, "folder": str(tiny_models)}
    answers = []
    for _ in range(2):
        segmenter = HuggingFaceSegmenter(detector, device="cpu", **settings)
        assert isinstance(segmenter, Protocol)
        answers.append(segmenter.segment(noise(60, 80), (TABLE, "mug", "red book")))
    first, second = answers
    assert [d.label for d in first].count(TABLE) == 1
    assert first[0].label == TABLE
    assert sum(d.mask.astype(int) for d in first).max() == 1
    for one, other in zip(first, second, strict=True):
        assert one.label == other.label
        assert one.score == other.score
        np.testing.assert_array_equal(one.mask, other.mask)
        np.testing.assert_array_equal(one.box, mask_box(one.mask))


@pytest.mark.slow
def test_boxes_and_scores_are_those_of_transformers_own_processor(tiny_models: Path) -> None:
    network = load_model(pins()["grounding-dino-tiny"], tiny_models, "who:")
    image, words = noise(60, 80), ("table", "mug", "red book")
    found = GroundingDino(network, tokenizer(), 0.05, 64, 24).find(
        image, words, tiles_of(80, 60, 1, 0.25)
    )
    images = transformers.GroundingDinoImageProcessorPil(
        size={"shortest_edge": 64, "longest_edge": 107}
    )
    processor = transformers.GroundingDinoProcessor(images, tokenizer())
    given = processor(images=image, text="table. mug. red book.", return_tensors="pt")
    with torch.inference_mode():
        (right,) = processor.post_process_grounded_object_detection(
            network(**given), given["input_ids"], threshold=0.05, target_sizes=[(60, 80)]
        )
    assert len(found) == len(right["scores"]) > 5
    boxes = right["boxes"].numpy().clip(0, [80, 60, 80, 60])
    for find in found:  # the processor's score may be that of a dot between two words
        k = int(np.abs(boxes - find.box).max(1).argmin())
        np.testing.assert_allclose(find.box, boxes[k], atol=1e-3)
        assert find.score <= float(right["scores"][k]) + 1e-5


@pytest.mark.slow
def test_many_boxes_at_once_are_masked_as_each_by_itself(
    tiny_models: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("generator.backends.huggingface.detection.sam2._BATCH", 2)
    masker = Sam2(load_model(pins()["sam2"], tiny_models, "who:"))
    image, tiles = noise(60, 80), tiles_of(80, 60, 2, 0.25)
    boxes = [(4, 4, 20, 30), (50, 20, 75, 55), (0, 0, 80, 60), (30, 25, 36, 30), (8, 6, 24, 20)]
    finds = [BoxDetection("thing", 1.0, np.array(b, float)) for b in boxes]
    together = masker.mask(image, finds, tiles)
    alone = [made for find in finds for made in masker.mask(image, [find], tiles)]
    assert [f.box.tolist() for f in together] == [f.box.tolist() for f in alone]
    assert len(together) > 2
    for one, other in zip(together, alone, strict=True):
        assert (one.mask != other.mask).mean() < 0.01


@pytest.mark.slow
def test_a_box_s_mask_is_that_of_the_network_given_the_pixels(tiny_models: Path) -> None:
    """The cached encoding of the picture gives the result of the whole network for every box."""
    network = load_model(pins()["sam2"], tiny_models, "who:")
    image, box = noise(64, 64), np.array([10.0, 12, 40, 50])
    (found,) = Sam2(network).mask(image, [BoxDetection("a", 1.0, box)], tiles_of(64, 64, 1, 0.25))
    from generator.backends.huggingface.detection.detections import IMAGENET, to_batch

    with torch.inference_mode():
        answer = network(
            pixel_values=to_batch(image, 64, 64, IMAGENET),
            input_boxes=torch.tensor(box[None, None]).float(),
            multimask_output=False,
        )
    (right,) = enlarge(answer.pred_masks[0, :, 0], (64, 64), 0.0)
    np.testing.assert_array_equal(found.mask, right)


def test_maps_are_stretched_as_pictures_are() -> None:
    logits = torch.tensor([[[1.0, -1.0], [1.0, -1.0]]])
    (mask,) = enlarge(logits, (8, 4), 0.0)
    assert mask.shape == (4, 8)
    np.testing.assert_array_equal(mask, np.arange(8)[None].repeat(4, 0) < 4)
