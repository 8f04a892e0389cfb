"""On, in, behind and in front of, inferred from visible and complete masks."""

import numpy as np

from generator.backends.embedded.supports import stack, whole_mask
from generator.geometry import mask_box
from generator.scene import Instance


def box(x0: int, y0: int, x1: int, y1: int) -> np.ndarray:
    mask = np.zeros((100, 100), bool)
    mask[y0:y1, x0:x1] = True
    return mask


def instance(name: str, whole: np.ndarray, hidden: np.ndarray | None = None) -> Instance:
    visible = whole if hidden is None else whole & ~hidden
    crop = np.zeros((*whole.shape, 4), np.uint8)
    crop[..., 3] = whole * 255
    occluded = bool((whole != visible).any())
    frame = np.array([0, 0, 100, 100])
    return Instance(name, name.split("_")[0], mask_box(visible), visible, crop, frame, occluded)


def found(*things: Instance):
    table = instance("table", np.ones((100, 100), bool))
    return stack((table, *things), lambda label: label in ("bowl", "mug"))


def test_a_whole_mask_is_carried_back_from_its_crop():
    whole = box(20, 30, 70, 80)
    np.testing.assert_array_equal(whole_mask(instance("a_1", whole, box(40, 0, 60, 100))), whole)


def test_on_something_differs_from_behind_and_before_it():
    book, cup = box(20, 40, 80, 80), box(40, 30, 60, 65)
    order = found(instance("book_1", book, cup), instance("cup_1", cup))
    assert (order["cup_1"].on, order["cup_1"].inside) == ("book_1", False)
    assert order["cup_1"].order > order["book_1"].order > order["table"].order
    vase = box(40, 10, 60, 55)
    assert found(instance("book_1", book), instance("vase_1", vase, book))["vase_1"].on == "table"
    front = box(40, 50, 60, 95)
    order = found(instance("book_1", book, front), instance("cup_1", front))
    assert order["cup_1"].on == "table"


def test_in_something_shows_in_part():
    bowl, apple = box(20, 40, 80, 80), box(40, 35, 60, 60)
    front = box(20, 50, 80, 80)
    order = found(instance("bowl_1", bowl, apple & ~front), instance("apple_1", apple, front))
    assert (order["apple_1"].on, order["apple_1"].inside) == ("bowl_1", True)
    order = found(instance("book_1", bowl, apple & ~front), instance("apple_1", apple, front))
    assert order["apple_1"].on == "table"


def test_layers_are_numbered_from_the_table_up():
    low, middle, high = box(10, 50, 90, 95), box(20, 35, 80, 75), box(35, 20, 65, 55)
    order = found(
        instance("tray_1", low, middle), instance("book_1", middle, high), instance("cup_1", high)
    )
    assert [order[n].order for n in ("table", "tray_1", "book_1", "cup_1")] == [1, 2, 3, 4]
    assert order["cup_1"].on == "book_1"
