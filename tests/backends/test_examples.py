"""Classification of unlearned words by examples and sizes."""

from collections.abc import Mapping

import numpy as np
import pytest
from extent import count, part_of

from generator.backends.embedded import painter
from generator.backends.embedded.examples import compare_sizes, rate_words
from generator.backends.embedded.eye.judge import EyeDetection
from generator.backends.embedded.eye.weights import load_weights
from generator.backends.embedded.plane.tabletop import find_tabletop
from generator.backends.embedded.segmenter import EmbeddedSegmenter
from generator.language.planner import plan_scene
from generator.meshes.pixels import mask_iou
from generator.scene import TABLE
from tabletop_objects import find_category


def draw_with_truth(text: str, seed: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Return a text's drawing, and the position of each noun's object in it."""
    plan = plan_scene(text, seed)
    painted, order = painter.paint(plan, seed)
    nouns = {planned.name: planned.noun for planned in plan.objects}
    return painted.image, {nouns[n]: painted.ids == k for k, n in enumerate(order, start=1)}


def wrong_names(image: np.ndarray, masks: Mapping[str, np.ndarray]) -> list[tuple[str, str]]:
    """Return the misclassified objects: (true word, predicted word)."""
    found = EmbeddedSegmenter().segment(image, (TABLE, *masks))
    wrong = []
    for detection in found[1:]:
        own = max(masks, key=lambda noun: mask_iou(masks[noun], np.asarray(detection.mask)))
        if own != detection.label and mask_iou(masks[own], np.asarray(detection.mask)) > 0.4:
            wrong.append((own, detection.label))
    return wrong


@pytest.mark.parametrize("seed", part_of([0, 2], 2))
def test_a_bowl_of_cereal_is_no_napkin(seed: int) -> None:
    text = (
        "A breakfast table with a bowl of cereal, a glass of orange juice to the right of the "
        "bowl, a spoon on a napkin and a candle behind the bowl"
    )
    cereal = find_category("bowl of cereal")
    assert cereal is not None and cereal.key not in load_weights().categories
    assert wrong_names(*draw_with_truth(text, seed)) == []


@pytest.mark.slow
def test_few_things_change_names() -> None:
    texts = (
        "A carafe, a ramekin, a rice cooker and a spatula on a kitchen table.",
        "A violin, a metronome, binoculars and a telescope on a desk.",
        "A cactus, a shoe, a toothbrush and a soap bar on a table.",
        "A vise, an axe, a paint roller and a hand plane on a workbench.",
    )[: count(4, 2)]
    wrong = [w for text in texts for w in wrong_names(*draw_with_truth(text, 1))]
    assert len(wrong) <= len(texts) // 2, wrong


def test_words_outside_the_catalogue_are_as_likely_as_the_unknown() -> None:
    image, masks = draw_with_truth("A mug and a bowl.", 0)
    categories = len(load_weights().categories)
    names = np.full(categories + 1, 0.4 / categories)
    names[-1] = 0.6
    mask = masks["mug"]
    edge = np.zeros_like(mask)
    edge[100:200, :50] = True
    things = [EyeDetection(1.0, 1.0, m, m, names) for m in (mask, edge)]
    plane = find_tabletop(image)
    assert find_category("gizmo") is None
    rated = rate_words(things, ("mug", "gizmo"), plane)
    assert (rated[:, 1] == names[-1]).all()
    assert ((rated >= 0) & (rated <= 1 + 1e-6)).all()
    sizes = compare_sizes(things, ("mug", "gizmo"), plane)
    assert np.isfinite(sizes[0, 0]).all()
    assert np.isnan(sizes[0, 1]).all(), "its size is not known"
    assert np.isnan(sizes[1]).all(), "the frame cuts it"
