"""Extraction: names, cleaning, and missing objects."""

from typing import Any

import numpy as np
import pytest

from generator.errors import InputError, SceneError
from generator.geometry import mask_box
from generator.meshes.pixels import fill_holes
from generator.method.extraction import ExtractionConfig, clean, extract, unique_names
from generator.scene import Detection, Instance, PlannedObject, PlannedTable, Reference, ScenePlan

IMAGE = np.full((100, 120, 3), 255, np.uint8)


def detection(label: str, x0: int, y0: int, x1: int, y1: int) -> Detection:
    mask = np.zeros(IMAGE.shape[:2], bool)
    mask[y0:y1, x0:x1] = True
    return Detection(label, mask_box(mask), mask)


class Answers:
    """A reasoner, segmenter and imager with given answers."""

    def __init__(self, *found: Detection) -> None:
        self.found = found
        self.asked: tuple[str, ...] = ()
        self.others: dict[str, int] = {}

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        return ("mug",)

    def segment(
        self, image: np.ndarray, labels: tuple[str, ...], *measured: object
    ) -> tuple[Detection, ...]:
        self.asked = labels
        return self.found

    def complete(self, reference: Reference, d: Detection, others: tuple) -> Instance:
        self.others[d.label] = len(others)
        crop = np.zeros((8, 8, 4), np.uint8)
        return Instance(d.label, d.label, d.box, d.mask, crop, d.box)


def run(*found: Detection) -> tuple[tuple[Instance, ...], Answers]:
    answers: Any = Answers(*found)
    return extract(Reference(IMAGE), answers, answers, answers)[1], answers


def test_table_comes_first_and_names_are_unique_and_file_safe():
    instances, answers = run(
        detection("toy car", 10, 10, 20, 20),
        detection("table", 0, 30, 120, 80),
        detection("toy car", 40, 10, 50, 20),
    )
    assert [i.name for i in instances] == ["table", "toy_car_1", "toy_car_2"]
    assert answers.asked == ("table", "mug")
    assert answers.others["table"] == 2


def test_specks_go_and_pin_holes_are_filled_but_handles_stay():
    mug = detection("mug", 20, 20, 80, 80)
    mask = np.array(mug.mask)
    mask[40, 40] = False
    mask[50:70, 50:70] = False
    mask[5, 5] = True
    found = clean(Detection("mug", mask_box(mask), mask))
    assert found is not None
    assert found.mask[40, 40] and not found.mask[60, 60] and not found.mask[5, 5]
    np.testing.assert_array_equal(found.box, [20, 20, 80, 80])
    assert clean(detection("dust", 3, 3, 4, 4)) is None


def test_holes_open_to_the_border_are_kept():
    mask = np.ones((20, 20), bool)
    mask[0, 5] = False
    assert not fill_holes(mask, 1.0)[0, 5]


def test_missing_table_or_things_are_named():
    with pytest.raises(SceneError, match="No table found"):
        run(detection("mug", 10, 10, 20, 20))
    with pytest.raises(SceneError, match="Nothing found on the table"):
        run(detection("table", 0, 30, 120, 80))


def test_names_of_odd_labels():
    assert unique_names(["Café cup!", "", "a/b", "a b"]) == [
        "caf_cup_1",
        "object_1",
        "a_b_1",
        "a_b_2",
    ]


class Painter(Answers):
    """An imager that draws the numbers of mugs in ``shown``, one drawing after another."""

    def __init__(self, *shown: int) -> None:
        super().__init__()
        self.shown = shown
        self.seeds: list[int] = []

    def draw(self, plan: ScenePlan, seed: int) -> np.ndarray:
        self.seeds.append(seed)
        return np.full_like(IMAGE, len(self.seeds))

    def segment(
        self, image: np.ndarray, labels: tuple[str, ...], *measured: object
    ) -> tuple[Detection, ...]:
        count = self.shown[int(image[0, 0, 0])]
        if count < 0:
            raise SceneError("No tabletop in the picture.")
        mugs = [detection("mug", 10 + 20 * k, 10, 20 + 20 * k, 20) for k in range(count)]
        return detection("table", 0, 30, 120, 80), *mugs


def drawn(config: ExtractionConfig, *shown: int) -> tuple[Reference, int, list[int]]:
    """Return the chosen reference for a plan of two mugs, the detections, and the drawn seeds."""
    painter: Any = Painter(*shown)
    mugs = tuple(PlannedObject(f"mug_{k}", "mug", "mug") for k in (1, 2))
    plan = ScenePlan("two mugs", PlannedTable(), mugs)
    first = Reference(np.zeros_like(IMAGE), "two mugs", plan)
    chosen, instances = extract(first, painter, painter, painter, 7, config)
    return chosen, len(instances) - 1, painter.seeds


@pytest.mark.parametrize(
    ("config", "shown", "best", "count", "drawings"),
    [
        (ExtractionConfig(), (2, 2, 2), 0, 2, 0),
        (ExtractionConfig(), (1, 2, 2), 1, 2, 1),
        (ExtractionConfig(drawings=3), (0, 1, 1), 1, 1, 2),
        (ExtractionConfig(drawings=3), (1, -1, -1), 0, 1, 2),
    ],
    ids=["shows all", "hides something", "shows most", "useless second drawing"],
)
def test_a_drawing_that_hides_something_is_drawn_again_and_the_one_that_shows_most_stays(
    config, shown, best, count, drawings
):
    chosen, found, seeds = drawn(config, *shown)
    assert (int(chosen.image[0, 0, 0]), found) == (best, count)
    assert len(set(seeds)) == len(seeds) == drawings and 7 not in seeds
    assert chosen.prompt == "two mugs" and chosen.plan is not None


def test_drawings_are_limited():
    with pytest.raises(SceneError, match="Nothing found"):
        drawn(ExtractionConfig(drawings=1), 0, 1)


@pytest.mark.parametrize("drawings", [0, 1.5])
def test_settings_out_of_range_are_refused(drawings) -> None:
    with pytest.raises(InputError, match=r"ExtractionConfig\.drawings must"):
        ExtractionConfig(drawings=drawings)
