"""Objects of the ``bedroom`` theme: clocks."""

from __future__ import annotations

from ...kit import prints, surfaces
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, box
from ...kit.surfaces import Look, tint_color


@category("clock_radio", size=(0.17, 0.0905, 0.064), mass=0.4, material="device",
          aliases=("radio alarm clock", "digital clock", "digital alarm clock", "radio clock",
          "led clock"), themes=("bedroom",), colors=("black",))  # fmt: skip
def clock_radio(look: Look) -> Shape:
    """A radio alarm clock with large illuminated digits."""
    k = look.between(0.9, 1.1)
    x, y, h = 0.17 * k, 0.09 * k, 0.06 * k
    color = look.color("black", "charcoal", "white", "wooden", "gray", "cream")
    image = prints.canvas(160, 56, (18, 16, 18))
    light = look.own_color("red", "lime", "cyan", "orange", "red")
    hour, minute = int(look.rng.integers(1, 13)), int(look.rng.integers(60))
    prints.write(image, f"{hour}:{minute:02d}", 0.5, 0.5, 0.62, light, bold=True)
    body = block(x, y, h, 0.012, 0.004)
    front = box(0.9 * x, 0.0012, 0.74 * h).move(y=-y / 2 - 0.0002, z=0.13 * h)
    dots = surfaces.fit(prints.mesh_holes(color, tint_color(color, 0.4), 6, 12), 64, 128)
    grille = box(0.6 * x, 0.35 * y, 0.0008).move(y=0.2 * y, z=h - 0.0003)
    bar = block(0.5 * x, 0.2 * y, 0.005, 0.004, 0.001).move(y=-0.2 * y, z=h - 0.001)
    return shape([(body, look.surface(color, "plastic")), (front, image), (grille, dots),
                  (bar, surfaces.plain(tint_color(color, 0.7)))],
                 [box_part(x, y, h), hull_of(bar)])  # fmt: skip
