"""Objects of the ``living`` theme: tiles."""

from __future__ import annotations

import numpy as np

from ...kit import materials, prints, surfaces
from ...kit.outlines import rectangle
from ...kit.primitives import at_box, plate
from ...kit.shapes import Category, Drawing, Pieces, Shape, category, from_pieces, put_down
from ...kit.solids import block
from ...kit.surfaces import Look, plain, tint_color


def _tile(sides: int) -> Drawing:
    def draw(look: Look) -> Pieces:
        """A glazed tile with a pattern."""
        color = look.color("white", "blue", "teal", "terracotta", "cream", "green", "mustard")
        image = materials.glaze_tile(look, color)
        image = surfaces.fit(image, 96, 96).copy()
        other = look.own_color("navy", "white", "mustard", "teal", "terracotta")
        for k in range(4):
            a = k * np.pi / 2
            prints.disc(image, 0.5 + 0.28 * np.cos(a), 0.5 + 0.28 * np.sin(a), 0.12, other)
        prints.disc(image, 0.5, 0.5, 0.14, tint_color(other, 1.3))
        if sides == 4:
            outline = rectangle(0.1, 0.1)
        else:
            a = np.arange(sides) * 2 * np.pi / sides + np.pi / 2
            outline = 0.056 * np.column_stack([np.cos(a), np.sin(a)])
        return [(plate(outline, 0.008), surfaces.plain(tint_color(color, 0.8))),
                (plate(0.985 * outline, 0.0006, 0.0077), image)]  # fmt: skip

    return draw


@category("mirror_tile", size=(0.152, 0.152, 0.0053), mass=0.3, material="glass",
          aliases=("mirrored tile", "square mirror", "mirror plate", "flat mirror"),
          themes=("living",), roles=("support", "flat"), colors=("silver",))  # fmt: skip
def mirror_tile(look: Look) -> Shape:
    """A square mirror tile with a ground edge, lying flat."""
    s = look.between(0.13, 0.19)
    glass = block(s, s, 0.005, 0.003, 0.001)
    face = at_box(0.94 * s, 0.94 * s, 0.0006, (0, 0, 0.0047))
    y, x = np.mgrid[0:96, 0:96] / 96
    gleam = np.clip(1 - np.abs((x - y + look.between(-0.3, 0.3)) * 5), 0, 1)[..., None] * 60
    sheen = np.clip(np.array([168, 190, 200]) + 26 * (y[..., None] - 0.5) + gleam, 0, 250)
    edge = look.color("silver", "gray", "sky")
    return put_down([(glass, plain(edge)), (face, sheen.astype(np.uint8))], glass)


CATEGORIES = (
    Category("ceramic_tile", from_pieces()(_tile(4)), size=(0.1, 0.1, 0.0083), mass=0.18,
             material="ceramic", aliases=("square tile", "bathroom tile", "floor tile",
             "glazed tile", "azulejo", "kitchen tile"), themes=("living",),
             roles=("flat", "support"), colors=("white", "blue")),
    Category("hexagonal_tile", from_pieces()(_tile(6)), size=(0.097, 0.112, 0.0083), mass=0.15,
             material="ceramic", themes=("living",), roles=("flat", "support"), colors=("teal",)),
    Category("triangular_tile", from_pieces()(_tile(3)), size=(0.097, 0.084, 0.0083), mass=0.09,
             material="ceramic", aliases=("triangle tile",), themes=("living",),
             roles=("flat", "support"), colors=("terracotta",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
