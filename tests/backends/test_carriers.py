"""Boards and mats under objects: detected by colour and shape, unlike shadows and inlays."""

from __future__ import annotations

import cv2
import numpy as np

from generator.backends.embedded.carriers import find_carriers
from generator.meshes.pixels import mask_iou

SHAPE = (240, 320)
TOP = (205, 205, 200)
BOARD = np.array([[120, 80], [220, 80], [240, 160], [110, 160]], np.int32)


def fill(polygon: np.ndarray) -> np.ndarray:
    return cv2.fillPoly(np.zeros(SHAPE, np.uint8), [polygon], 1) > 0


def disc(x: int, y: int, radius: int) -> np.ndarray:
    return cv2.circle(np.zeros(SHAPE, np.uint8), (x, y), radius, 1, -1) > 0


def paint(*layers: tuple[np.ndarray, tuple[int, int, int]]) -> np.ndarray:
    image = np.full((*SHAPE, 3), TOP, np.uint8)
    for mask, colour in layers:
        image[mask] = colour
    return image


TABLE = fill(np.array([[20, 30], [300, 30], [310, 220], [10, 220]]))
THINGS = [disc(150, 115, 14), disc(195, 120, 16), disc(60, 120, 14)]


def test_a_board_with_things_on_it_is_found_whole() -> None:
    board = fill(BOARD)
    image = paint((board, (150, 95, 50)), *((thing, (200, 30, 30)) for thing in THINGS))
    (found,) = find_carriers(image, TABLE, THINGS)
    assert mask_iou(found, board) > 0.85


def test_things_across_a_board_do_not_cut_it() -> None:
    board = fill(np.array([[110, 70], [220, 70], [220, 190], [110, 190]]))
    bars = [fill(np.array([[100, y], [230, y], [230, y + 8], [100, y + 8]])) for y in (100, 140)]
    lowest = disc(160, 170, 9)
    things = [*bars, lowest]
    image = paint((board, (150, 95, 50)), *((thing, (200, 30, 30)) for thing in things))
    (found,) = find_carriers(image, TABLE, things)
    assert mask_iou(found, board) > 0.85


def test_what_carries_nothing_is_no_carrier() -> None:
    image = paint((fill(BOARD), (150, 95, 50)), (THINGS[2], (200, 30, 30)))
    assert not find_carriers(image, TABLE, THINGS[2:])


def test_a_shadow_is_no_carrier() -> None:
    image = paint((fill(BOARD), (150, 150, 146)), *((thing, (200, 30, 30)) for thing in THINGS))
    assert not find_carriers(image, TABLE, THINGS)


def test_without_things_or_table_there_is_none() -> None:
    image = paint((fill(BOARD), (150, 95, 50)))
    assert not find_carriers(image, TABLE, [])
    assert not find_carriers(image, np.zeros(SHAPE, bool), THINGS)
