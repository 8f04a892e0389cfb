"""A painted desk with a book, a mug on it and a pen: instances and their descriptions."""

import re

import numpy as np

from generator.geometry import mask_box
from generator.scene import Detection, Instance, Reference, SizePrior, View

VIEW = View(0.0, np.deg2rad(55), np.deg2rad(35))
THINGS = {
    "table": (20, 60, 300, 220, (150, 110, 70)),
    "book_1": (60, 90, 140, 150, (40, 60, 160)),
    "mug_1": (90, 80, 120, 120, (200, 40, 40)),
    "pen_1": (200, 120, 260, 130, (20, 20, 20)),
}


def reference(plan=None) -> Reference:
    image = np.full((240, 320, 3), 255, np.uint8)
    for x0, y0, x1, y1, color in THINGS.values():
        image[y0:y1, x0:x1] = color
    return Reference(image, plan=plan)


def detections() -> dict[str, Detection]:
    found, above = {}, np.zeros((240, 320), bool)
    for name, (x0, y0, x1, y1, _) in reversed(THINGS.items()):
        mask = np.zeros((240, 320), bool)
        mask[y0:y1, x0:x1] = True
        mask &= ~above
        above |= mask
        found[name] = Detection(name.removesuffix("_1"), mask_box(mask), mask)
    return {name: found[name] for name in THINGS}


def instances() -> tuple[Instance, ...]:
    made = []
    for name, d in detections().items():
        crop = np.full((40, 40, 4), (*THINGS[name][4], 255), np.uint8)
        made.append(Instance(name, d.label, d.box, d.mask, crop, d.box))
    return tuple(made)


SIZES = {
    "table": SizePrior("table", np.array([1.2, 0.7, 0.74])),
    "book_1": SizePrior("book_1", np.array([0.25, 0.18, 0.03]), "lying flat"),
    "mug_1": SizePrior("mug_1", np.array([0.09, 0.08, 0.1])),
    "pen_1": SizePrior("pen_1", np.array([0.14, 0.01, 0.01])),
}


def listed(text: str) -> dict[int, str]:
    """Return the numbered lines of a prompt: number to label."""
    return {int(n): label for n, label in re.findall(r"^(\d+): ([^;\n]+)", text, re.MULTILINE)}
