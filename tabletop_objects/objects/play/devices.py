"""Objects of the ``play`` theme: electronic devices."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Shape, category, shape
from ...kit.solids import box, cylinder, prism
from ...kit.surfaces import Look, tint_color

DARK = (40, 41, 45)


@category("game_controller", size=(0.156, 0.1, 0.047), mass=0.23, material="device",
          aliases=("gamepad", "controller", "game pad"), themes=("play", "living"),
          colors=("black", "white"), state="lying flat", common=True)  # fmt: skip
def game_controller(look: Look) -> Shape:
    """A game pad lying flat, with two grips, sticks and buttons."""
    color = look.color("black", "white", "blue", "red", "purple", "teal", "pink", "gray", "lime")
    shell = surfaces.speckles(look.rng, color, 3, 32)
    dark = surfaces.plain(
        look.pick([tint_color(DARK, 0.8), (226, 226, 228), tint_color(color, 0.5)])
    )
    rear = look.pick([shell, surfaces.speckles(look.rng, tint_color(color, 0.55), 3, 32)])
    low = look.pick([0.0, 0.0, -0.02])  # position of the left stick
    span = look.between(0.92, 1.06)
    half = np.array(  # from the middle of the front around to the middle of the back
        [
            (0, -0.018),
            (0.028, -0.02),
            (0.042, -0.048),
            (0.058, -0.062),
            (0.073, -0.056),
            (0.078, -0.036),
            (0.072, 0.012),
            (0.056, 0.036),
            (0.026, 0.038),
        ]
    ) * [1.0, span]
    outline = np.concatenate([half, half[:0:-1] * [-1, 1]])
    body = prism(outline, 0.004, 0.03)
    back = prism(outline * 0.93, 0.0, 0.034)
    pieces = [(body, rear), (back, shell)]
    for x, y in [(-0.026 + low, -0.004 - 0.6 * low), (0.026, -0.004)]:
        pieces.append((cylinder(0.0095, 0.014, 18, bevel=0.002).move(x, y, 0.033), dark))
    paints = [(206, 52, 46), (70, 160, 80), (60, 110, 200), (230, 190, 60)]
    for k, paint in enumerate(paints):
        angle = np.pi / 2 * k
        at = (0.05 + 0.0095 * np.cos(angle), 0.015 + 0.0095 * np.sin(angle))
        pieces.append((cylinder(0.0045, 0.005, 12).move(*at, 0.033), surfaces.plain(paint)))
    cross = [box(*size, 0.004) for size in ((0.022, 0.0075), (0.0075, 0.022))]
    pieces += [(bar.move(-0.05 - 1.1 * low, 0.015 + low, 0.033), dark) for bar in cross]
    right = prism(half[1:], 0.0, 0.034)
    left = prism((half[1:] * [-1, 1])[::-1], 0.0, 0.034)
    return shape(
        pieces,
        [hull_of(right), hull_of(left), box_part(0.056, 0.05 * span, 0.034, (0, 0.009 * span, 0))],
    )
