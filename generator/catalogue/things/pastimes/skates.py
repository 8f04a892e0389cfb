"""What people roll and slide on: skateboards, roller skates, ice skates."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import side_view
from ...build.making import DARK, at_box, drum, steel
from ...build.recipes import leather, put_down
from ...build.shape import Shape
from ...build.solids import Solid, join
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def _boot(h: float) -> Solid:
    """Return a boot's upper from the side, toe towards +x, standing on z = 0."""
    rim = [(-0.055, 0), (0.085, 0), (0.1, 0.012), (0.095, 0.032), (0.045, 0.052), (0.018, 0.075),
           (0.01, h), (-0.052, h), (-0.058, 0.06)]  # fmt: skip
    return side_view(rim, 0.062)


def _laces(h: float) -> list[Solid]:
    return [
        at_box(0.004, 0.04, 0.004, (0.05 - 0.0085 * n, 0, 0.049 + 0.0078 * n)) for n in range(5)
    ]


def skateboard(look: Look) -> Shape:
    """A skateboard on its wheels, its ends turned up."""
    color = look.color("red", "black", "teal", "wooden", "orange", "purple")
    k = look.between(0.35, 0.5)
    x = np.array([-0.39, -0.3, -0.27, 0.27, 0.3, 0.39])
    z = np.array([0.13, 0.1, 0.092, 0.092, 0.1, 0.13])
    deck = side_view(
        np.concatenate([np.column_stack([x, z]), np.column_stack([x, z + 0.012])[::-1]]), 0.2
    )
    grip = at_box(0.54, 0.196, 0.002, (0, 0, 0.1035))
    wheels = [drum(0.028, 0.03, (sx * 0.2, sy * 0.085 - 0.015, 0.028), 1, sides=18, bevel=0.004)
              for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    trucks = [at_box(0.03, 0.14, 0.02, (s * 0.2, 0, 0.018)) for s in (-1, 1)]
    trucks += [at_box(0.07, 0.05, 0.055, (s * 0.2, 0, 0.038)) for s in (-1, 1)]
    return put_down(
        [(deck, look.surface(color, "wood")), (grip, plain((46, 46, 50))), (join(wheels), plain(
            look.own_color("white", "yellow", "lime", "coral"))), (join(trucks), steel(look))],
        deck, *(join(wheels[i : i + 2]) for i in (0, 2)), factor=k)  # fmt: skip


def roller_skate(look: Look) -> Shape:
    """A laced boot on four wheels with a stopper at the toe."""
    color = look.color("white", "pink", "black", "sky", "red", "mint")
    k = look.between(0.95, 1.25)
    boot = _boot(0.13).move(z=0.062)
    sole, heel = (
        at_box(0.155, 0.06, 0.008, (0.02, 0, 0.056)),
        at_box(0.04, 0.056, 0.02, (-0.036, 0, 0.044)),
    )
    plate = at_box(0.14, 0.04, 0.01, (0.015, 0, 0.04))
    wheels = [drum(0.024, 0.024, (x, s * 0.035 - 0.012, 0.024), 1, sides=18, bevel=0.004)
              for x in (-0.036, 0.062) for s in (-1, 1)]  # fmt: skip
    trucks = [at_box(0.02, 0.06, 0.03, (x, 0, 0.018)) for x in (-0.036, 0.062)]
    stop = drum(0.014, 0.03, (0.092, 0, 0.016), top=0.01)
    laces = [one.move(z=0.064) for one in _laces(0)]
    tone = look.own_color("pink", "red", "yellow", "turquoise", "orange")
    return put_down(
        [
            (boot, leather(look.rng, color)),
            (join([sole, heel]), plain(tint_color(color, 0.6))),
            (join([plate, *trucks]), steel(look)),
            (join([*wheels, stop]), plain(tone)),
            (join(laces), plain((250, 248, 244))),
            (at_box(0.046, 0.046, 0.0012, (-0.021, 0, 0.1915)), plain(DARK)),
        ],
        boot,
        join([plate, *wheels]),
        factor=k,
    )


def ice_skate(look: Look) -> Shape:
    """A laced boot on a steel blade, held up by its broad holder."""
    color = look.color("white", "black", "white", "navy")
    k = look.between(0.95, 1.25)
    boot = _boot(0.13).move(z=0.052)
    sole = at_box(0.155, 0.058, 0.008, (0.02, 0, 0.046))
    blade = side_view([(-0.075, 0.006), (-0.07, 0), (0.105, 0), (0.122, 0.014), (0.11, 0.018),
                       (-0.075, 0.016)], 0.006)  # fmt: skip
    posts = [at_box(0.03, 0.03, 0.034, (x, 0, 0.014)) for x in (-0.035, 0.065)]
    laces = [one.move(z=0.054) for one in _laces(0)]
    wide = at_box(0.16, 0.05, 0.004, (0.02, 0, 0))
    return put_down(
        [
            (boot, leather(look.rng, color)),
            (sole, plain(tint_color(color, 0.55))),
            (join([blade, *posts]), steel(look)),
            (join(laces), plain((200, 202, 210))),
            (at_box(0.046, 0.046, 0.0012, (-0.021, 0, 0.1815)), plain((70, 72, 80))),
        ],
        boot,
        blade,
        wide,
        factor=k,
    )


CATEGORIES = (
    Category("skateboard", skateboard, (0.322, 0.0825, 0.0586), 0.4,
             ("toy skateboard", "fingerboard", "mini skateboard", "longboard", "finger skateboard"),
             ("sports", "toys"), ("support",), ("red", "black")),
    Category("roller_skate", roller_skate, (0.181, 0.103, 0.21), 0.8,
             ("rollerskate", "rollerblade", "inline skate", "quad skate"), ("sports",), ("big",),
             ("white", "pink")),
    Category("ice_skate", ice_skate, (0.212, 0.0668, 0.196), 0.7, ("figure skate", "skate",
             "hockey skate"),
             ("sports",), ("big",), ("white",)),
)  # fmt: skip
"""The module's categories."""
