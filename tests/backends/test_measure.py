"""Sizes of objects and of the table, from a picture and the plane of the table top."""

import numpy as np
import pytest
from painted import SIZES, Picture, paint

from generator.backends.embedded.plane.measure import apparent_scale, usual_solid
from generator.backends.embedded.plane.tabletop import find_tabletop
from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.geometry import mask_box
from generator.scene import Instance, Reference
from tabletop_objects import CATEGORIES, build

THINGS = [
    ("mug", -0.3, 0.1, 0.0),
    ("bowl", 0.2, 0.2, 0.0),
    ("book", 0.1, -0.15, 0.0),
    ("banana", -0.15, -0.15, 0.0),
]


@pytest.fixture(scope="module")
def picture() -> Picture:
    return paint("rectangle", "oak", THINGS)


@pytest.mark.slow
@pytest.mark.parametrize("number", range(1, 5))
def test_a_thing_of_its_usual_size_looks_like_it(picture: Picture, number: int) -> None:
    plane = find_tabletop(picture.image, picture.plan)
    key = THINGS[number - 1][0]
    box = mask_box(picture.ids == number)
    solid = usual_solid(key) * np.asarray(build(key, 1).size) / CATEGORIES[key].size
    scale, off = apparent_scale(box, solid, plane)
    assert scale == pytest.approx(1.0, abs=0.1) and off < 0.15
    half, _ = apparent_scale(box, 2 * solid, plane)
    assert half == pytest.approx(scale / 2, rel=0.25)


def instance(name: str, label: str, picture: Picture, number: int) -> Instance:
    mask = picture.ids == number
    crop = np.full((4, 4, 4), 255, np.uint8)
    return Instance(name, label, mask_box(mask), mask, crop, mask_box(mask))


@pytest.mark.slow
@pytest.mark.parametrize("names", ["true", "one wrong", "two of a kind nobody knows"])
def test_the_table_is_sized_by_what_stands_on_it(picture: Picture, names: str) -> None:
    labels = [key for key, *_ in THINGS]
    if names == "one wrong":
        labels[1] = "monitor"
    if names == "two of a kind nobody knows":
        labels[2:] = ["flat object", "flat object"]
    instances = (
        instance("table", "table", picture, 0),
        *(instance(f"thing_{k}", n, picture, k) for k, n in enumerate(labels, start=1)),
    )
    reference = Reference(picture.image)
    view = find_tabletop(picture.image).view
    sizes = EmbeddedReasoner().estimate_sizes(reference, instances, view)
    assert sizes["table"].extent[0] == pytest.approx(SIZES["rectangle"][0], rel=0.2)


@pytest.mark.slow
def test_things_that_look_half_their_size_stand_on_a_table_twice_as_large() -> None:
    far = paint("rectangle", "oak", [(k, 2 * x, 2 * y, 0) for k, x, y, _ in THINGS], table=2.0)
    instances = tuple(
        instance(f"thing_{k}" if k else "table", THINGS[k - 1][0] if k else "table", far, k)
        for k in range(5)
    )
    sizes = EmbeddedReasoner().estimate_sizes(
        Reference(far.image), instances, find_tabletop(far.image).view
    )
    assert sizes["table"].extent[0] == pytest.approx(2 * SIZES["rectangle"][0], rel=0.2)
