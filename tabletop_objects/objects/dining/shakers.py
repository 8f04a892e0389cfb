"""Objects of the ``dining`` theme: shakers."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import cylinder_part, hull_of, hull_part
from ...kit.shapes import Shape, category, shape
from ...kit.solids import cylinder, ellipsoid, lathe
from ...kit.surfaces import RGB, Look


def _shaker(look: Look, letter: str, fill_color: RGB) -> Shape:
    r, h = look.between(0.02, 0.024), look.between(0.068, 0.088)
    style = int(look.rng.integers(3))
    palette = ("white", "cream", "sky") if letter == "S" else ("black", "brown", "gray")
    color = look.color(*palette)
    body = lathe([(0, 0), (r, 0), (r, 0.004), (0.84 * r, 0.72 * h), (0, 0.72 * h)], 24)
    skin = prints.canvas(128, 64, color)
    ink = (40, 40, 44) if sum(color) > 380 else (240, 240, 236)
    middle = skin[:, 48:80]
    prints.write(middle, letter, 0.5, 0.5, 0.5, ink, bold=True)
    if style == 0:  # glass shows the filling
        clear = surfaces.plain((214, 226, 230))
        skin = surfaces.stack((surfaces.plain(fill_color), 6), (clear, 4))
    cap = lathe(
        [(0, 0.7 * h), (0.9 * r, 0.7 * h), (0.9 * r, 0.86 * h), (0.6 * r, 0.97 * h), (0, h)], 24
    )
    steel = surfaces.brushed_metal(look.rng, look.own_color("silver", "silver", "gold"))
    pieces = [(body, skin), (cap, steel)]
    hole = cylinder(0.0013, 0.002, 8)
    dark = surfaces.plain((40, 40, 42))
    for k in range(5 if letter == "S" else 3):
        at = 0.007 * np.array([np.cos(2.1 * k), np.sin(2.1 * k)]) * (k > 0)
        pieces.append((hole.move(at[0], at[1], 0.98 * h - 0.0012), dark))
    return shape(pieces, [hull_of(body), hull_part(cap.vertices)])


@category("salt_shaker", size=(0.044, 0.044, 0.078), mass=0.12, material="glass",
          aliases=("salt", "salt cellar", "sugar pourer"), themes=("dining", "kitchen"),
          roles=("round",), colors=("white",), common=True)  # fmt: skip
def salt_shaker(look: Look) -> Shape:
    """A salt shaker with a metal top."""
    return _shaker(look, "S", (246, 246, 244))


@category("pepper_shaker", size=(0.046, 0.046, 0.1), mass=0.12, material="glass",
          aliases=("pepper",), themes=("dining", "kitchen"), roles=("round",),
          colors=("black", "brown"), common=True)  # fmt: skip
def pepper_shaker(look: Look) -> Shape:
    """A pepper shaker with a metal top, or a turned wooden mill."""
    if look.chance(0.6):
        return _shaker(look, "P", (70, 60, 54))
    r, h = 0.026, look.between(0.13, 0.17)
    t = np.linspace(0, 1, 12)
    waist = r * (0.78 + 0.22 * np.cos(2 * np.pi * t) - 0.06 * np.sin(4 * np.pi * t))
    body = lathe([(0, 0), *np.column_stack([waist, 0.76 * h * t]), (0, 0.76 * h)], 24)
    head = lathe(
        [(0, 0.77 * h), (0.9 * r, 0.77 * h), (0.95 * r, 0.84 * h), (0.7 * r, 0.92 * h),
         (0.2 * r, 0.95 * h), (0, 0.95 * h)], 24,
    )  # fmt: skip
    knob = lathe([(0, 0.94 * h), (0.006, 0.95 * h), (0.007, 0.975 * h), (0, h)], 14)
    tile = look.surface(look.color("brown", "wooden", "black", "maroon"), "wood")
    return shape(
        [(body, tile), (head, tile), (knob, surfaces.brushed_metal(look.rng, (196, 198, 202)))],
        [cylinder_part(r, 0.05 * h), cylinder_part(0.76 * r, 0.72 * h, (0, 0, 0.04 * h)),
         hull_of(head), hull_of(knob)],
    )  # fmt: skip


@category("pepper_mill", size=(0.0528, 0.0528, 0.194), mass=0.2, material="wood",
          aliases=("pepper grinder", "salt mill", "salt grinder", "peppermill", "spice mill",
          "spice grinder", "salt and pepper mill", "nutmeg grinder"), themes=("dining", "kitchen"),
          roles=("tall", "round"), colors=("wooden",))  # fmt: skip
def pepper_mill(look: Look) -> Shape:
    """A turned wooden pepper mill, or a straight one of steel and glass."""
    r, h = look.between(0.024, 0.029), look.between(0.17, 0.22)
    color = look.color("wooden", "brown", "black", "red", "white", "tan")
    skin = look.surface(color, "wood")
    steel = surfaces.brushed_metal(look.rng, (196, 199, 204))
    body = lathe([(0, 0), (r, 0), (r, 0.08 * h), (0.82 * r, 0.2 * h), (0.66 * r, 0.42 * h),
                  (0.9 * r, 0.6 * h), (0.92 * r, 0.68 * h), (0.6 * r, 0.72 * h), (0, 0.72 * h)],
                 28)  # fmt: skip
    head = lathe([(0, 0.72 * h), (0.6 * r, 0.725 * h), (0.86 * r, 0.78 * h), (0.84 * r, 0.88 * h),
                  (0.5 * r, 0.95 * h), (0, 0.96 * h)], 28)  # fmt: skip
    knob = ellipsoid(0.016, 0.016, 0.014, 14, 8).move(z=0.975 * h)
    return shape([(body, skin), (head, skin), (knob, steel)], [hull_of(body), hull_of(head, knob)])
