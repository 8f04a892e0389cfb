"""Objects of the ``living`` theme: drums."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, shine, wood
from ...kit.primitives import at_box, disc, standing, straight
from ...kit.shapes import Category, Drawing, Pieces, category, from_pieces
from ...kit.solids import join, torus
from ...kit.surfaces import Look

HIDE = surfaces.plain((232, 216, 184))


def _shell(profile: list[tuple[float, float]], *palette: str) -> Drawing:
    """Return the drawing function of an upright drum with a body, a skin, hoops and ropes."""

    def draw(look: Look) -> Pieces:
        tile = wood(look, *palette)
        r, top = profile[-1]
        body = standing(*profile)
        head = disc(0.97 * r, 0.002, (0, 0, top))
        hoops = [torus(r * 1.01, 0.004, 32, 6).move(z=top - d) for d in (0.004, 0.02)]
        low = profile[len(profile) // 2]
        cords = []
        for k in range(16):
            a, b = k * np.pi / 8, (k + 0.5) * np.pi / 8
            cords += [straight((1.01 * r * np.cos(c), 1.01 * r * np.sin(c), top - 0.02),
                               ((low[0] + 0.001) * np.cos(b), (low[0] + 0.001) * np.sin(b), low[1]),
                               0.0014, 4) for c in (a, b)]  # fmt: skip
        return [(body, tile), (join(hoops), dye(look, "black", "red", "brown")), (head, HIDE),
                (join(cords), surfaces.plain((226, 214, 186)))]  # fmt: skip

    return draw


@category("bongos", size=(0.275, 0.155, 0.122), mass=1.2, material="wood", hollow=True,
          aliases=("bongo", "bongo drum", "pair of bongos", "set of bongos"), themes=("living",),
          roles=("big",), colors=("brown",))  # fmt: skip
@from_pieces(bodies=3)
def bongos(look: Look) -> Pieces:
    """Bongos: a small and a large drum joined by a bar, with hide heads, metal hoops and rods."""
    tile = wood(look, "brown", "wooden", "red", "maroon")
    pieces: Pieces = []
    rims, heads = [], []
    for x, r in ((-0.072, 0.062), (0.068, 0.072)):
        pieces.append((disc(0.86 * r, 0.12, (x, 0, 0), top=r), tile))
        heads.append(disc(0.95 * r, 0.002, (x, 0, 0.12)))
        rims += [torus(r, 0.005, 32, 6).move(x, 0, z) for z in (0.116, 0.09)]
        rims += [straight((x + r * np.cos(a), r * np.sin(a), 0.115),
                          (x + 0.95 * r * np.cos(a), 0.95 * r * np.sin(a), 0.04), 0.003, 6)
                 for a in np.arange(5) * 1.257]  # fmt: skip
    bar = at_box(0.06, 0.04, 0.04, (0, 0, 0.05))
    return [*pieces, (bar, tile), (join(rims), shine(look)), (join(heads), HIDE)]


CATEGORIES = (
    Category("djembe", from_pieces(bodies=2)(_shell([(0.05, 0), (0.036, 0.06), (0.034, 0.1),
             (0.075, 0.17), (0.08, 0.24)], "brown", "wooden", "maroon")), size=(0.17, 0.17, 0.242),
             mass=1.2, material="wood", hollow=True,
             aliases=("goblet drum", "darbuka", "african drum", "doumbek"), themes=("living",),
             roles=("tall", "big"), colors=("brown",)),
    Category("tabla", from_pieces(bodies=2)(_shell([(0.05, 0), (0.08, 0.03), (0.085, 0.07),
             (0.078, 0.13)], "brown", "copper", "silver")), size=(0.17, 0.17, 0.132), mass=1.0,
             material="wood", hollow=True, aliases=("indian drum",), themes=("living",),
             roles=("support",), colors=("brown",)),
    Category("conga", from_pieces(bodies=2)(_shell([(0.05, 0), (0.065, 0.08), (0.074, 0.17),
             (0.066, 0.28)], "red", "wooden", "brown")), size=(0.148, 0.148, 0.282), mass=1.5,
             material="wood", hollow=True,
             aliases=("conga drum", "timpani", "bass drum", "tall drum"), themes=("living",),
             roles=("tall",), colors=("red",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
