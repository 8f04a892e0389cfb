"""Detection of the objects that stand on the table."""

import numpy as np

from generator.backends.huggingface.detection.detections import BoxDetection, on_table
from generator.geometry import mask_box

SHAPE = (120, 160)


def find(label: str, x0: int, y0: int, x1: int, y1: int) -> BoxDetection:
    mask = np.zeros(SHAPE, bool)
    mask[y0:y1, x0:x1] = True
    return BoxDetection(label, 1.0, mask_box(mask), mask)


TABLE = find("table", 20, 60, 140, 110).mask


def kept(*things: BoxDetection, table: np.ndarray = TABLE) -> list[str]:
    return [f.label for f in on_table(things, table)]


def test_a_tall_thing_stands_where_its_foot_is() -> None:
    assert kept(find("vase", 50, 5, 70, 70)) == ["vase"]
    assert kept(find("picture", 50, 5, 70, 55)) == []  # on the wall
    assert kept(find("chair", 60, 90, 100, 120)) == []  # before the table
    assert kept(find("lamp", 139, 20, 159, 90)) == []


def test_a_hole_in_the_table_s_mask_where_a_thing_stands_is_table() -> None:
    table = TABLE.copy()
    table[70:90, 60:80] = False
    assert kept(find("mug", 60, 70, 80, 90), table=table) == ["mug"]


def test_what_stands_on_or_behind_things_on_the_table_is_on_it_too() -> None:
    """Far back, a pile projects above the table's edge in the picture."""
    pile = [
        find("clock", 52, 10, 68, 30),
        find("box", 50, 30, 70, 50),
        find("book", 48, 50, 72, 68),
    ]
    assert kept(*pile) == ["clock", "box", "book"]
    assert kept(*pile[:2]) == []


def test_nothing_stands_on_what_is_not_on_the_table() -> None:
    assert kept(find("shelf", 0, 40, 60, 50), find("vase", 10, 10, 30, 40)) == []
    assert kept() == []
