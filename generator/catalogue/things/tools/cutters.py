"""Tools that cut, scrape, staple and turn."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    box,
    cylinder,
    join,
    lathe,
    prism,
    sweep,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .handtools import DARK
from .tools import GRIPS, lying, steel


def putty_knife(look: Look) -> Shape:
    """A putty knife lying: a broad steel blade, a riveted handle."""
    k = look.between(0.88, 1.08)
    wide = look.between(0.03, 0.075) * k
    color = look.color("wooden", "black", "red", "wooden", "blue", "yellow")
    blade = prism(np.array([(0.0, -0.011 * k), (0.085 * k, -wide / 2), (0.1 * k, -wide / 2),
                            (0.1 * k, wide / 2), (0.085 * k, wide / 2), (0.0, 0.011 * k)]),
                  0.0, 0.0016)  # fmt: skip
    blade = blade.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.007 * np.clip(
        1 - p[:, 0] / (0.1 * k), 0, 1)]))  # fmt: skip
    grip = prism(rectangle(0.105 * k, 0.026 * k, 0.009 * k), 0, 0.016 * k, 0.003).move(x=-0.05 * k)
    rivets = [cylinder(0.0032 * k, 0.0012, 12).move((-0.025 - 0.035 * n) * k, 0, 0.0155 * k)
              for n in range(3)]  # fmt: skip
    metal = steel(look)
    return shape([(blade, metal), (grip, look.surface(color, "wood")), (join(rivets), metal)],
                 [hull_of(blade), hull_of(grip)])  # fmt: skip


def _cutters(beak: list[tuple[float, float]], long: float, thick: float) -> Callable[[Look], Shape]:
    """Two crossed levers lying, grips to the left: cutters, snips, strippers."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.08)
        color = look.color(*GRIPS)
        rubber = look.surface(color, "plastic")
        h = thick * k
        heads, grips, parts = [], [], []
        for s in (-1, 1):
            head = np.array(beak) * [1, s] * k
            head = head if s > 0 else head[::-1]
            heads.append(prism(head, 0.1 * h + 0.0 * s, 0.9 * h))
            way = smooth(np.array([(0, s * -0.004, 0), (-0.03, s * -0.013, 0), (-0.5 * long, s *
                         -0.026, 0), (-long, s * -0.021, 0)]) * k + [0, 0, h / 2], 4)  # fmt: skip
            grips.append(sweep(way, rectangle(0.011 * k, h, 0.003, 2)))
            parts += [hull_of(heads[-1]), hull_of(grips[-1])]
        pivot = cylinder(0.0065 * k, h + 0.0015, 18).move(x=0.002 * k)
        return shape([(join(heads), steel(look)), (join(grips), rubber),
                      (pivot, textures.plain((120, 124, 130)))], parts)  # fmt: skip

    return make


def staple_gun(look: Look) -> Shape:
    """A staple gun lying on its side."""
    k = look.between(0.9, 1.06)
    color = look.color("silver", "red", "yellow", "black", "blue", "gray")
    h = 0.026 * k
    outline = np.array([(-0.085, 0.005), (-0.08, -0.016), (0.07, -0.02), (0.088, -0.02),
                        (0.088, 0.045), (0.05, 0.062), (0.02, 0.05), (-0.03, 0.028)])  # fmt: skip
    hole = prism(np.array([(-0.06, 0.0), (0.02, -0.004), (0.03, 0.022), (-0.02, 0.018)]) * k,
                 -0.0004, h + 0.0006)  # fmt: skip
    lever = prism(np.array([(0.055, 0.058), (0.058, 0.07), (-0.085, 0.062), (-0.092, 0.052),
                            (-0.03, 0.05)]) * k, 0.15 * h, 0.85 * h)  # fmt: skip
    body = prism(outline * k, 0, h)
    return shape([(body, look.surface(color, "metal")), (hole, textures.plain(DARK)),
                  (lever, textures.plain(tint_color(color, 0.55)))],
                 [hull_of(body), hull_of(lever)])  # fmt: skip


def oil_can(look: Look) -> Shape:
    """An oil can standing: a flat cone with a long bent spout."""
    k = look.between(0.88, 1.08)
    color = look.color("red", "green", "blue", "copper", "silver", "yellow")
    body = lathe(np.array([(0, 0), (0.04, 0), (0.042, 0.003), (0.042, 0.04), (0.034, 0.05),
                           (0.01, 0.068), (0.009, 0.076), (0, 0.076)]) * k, 30)  # fmt: skip
    spout = smooth([(0, 0, 0.072), (0.005, 0, 0.1), (0.04, 0, 0.14), (0.075, 0, 0.165)], 5) * k
    nose = tube(spout, np.linspace(0.006, 0.0018, len(spout)) * k, 10)
    handle = tube(smooth([(-0.04, 0, 0.035), (-0.07, 0, 0.045), (-0.065, 0, 0.075),
                          (-0.012, 0, 0.072)], 4) * k, 0.0042 * k, 8)  # fmt: skip
    return shape([(body, look.surface(color, "metal")), (nose, steel(look)),
                  (handle, textures.plain(tint_color(color, 0.7)))],
                 [cylinder_part(0.042 * k, 0.042 * k), hull_of(body), hull_of(nose),
                  hull_of(handle)])  # fmt: skip


def socket_wrench(look: Look) -> Shape:
    """A ratchet lying, a socket on its head."""
    k = look.between(0.88, 1.05)
    color = look.color("silver", "black", "red", "blue", "silver")
    metal = textures.brushed_metal(look.rng, (186, 189, 194))
    z = 0.015 * k
    head = cylinder(0.0185 * k, 0.02 * k, 28, bevel=0.003).move(x=0.08 * k, z=0.005 * k)
    dial = cylinder(0.011 * k, 0.004 * k, 20).move(x=0.08 * k, z=0.0245 * k)
    neck = lying(cylinder(0.0065 * k, 0.09 * k, 14), -0.015 * k, z)
    grip = lying(lathe(np.array([(0, 0), (0.012, 0.001), (0.0145, 0.01), (0.012, 0.05),
                                 (0.0145, 0.09), (0.008, 0.1), (0, 0.1)]) * k, 18), -0.11 * k,
                                     z)  # fmt: skip
    switch = box(0.016 * k, 0.005 * k, 0.003 * k).turn(2, 0.6).move(x=0.08 * k, z=0.028 * k)
    socket = cylinder(0.0125 * k, 0.006 * k, 22).move(x=0.08 * k)
    knurl = textures.stripes([tint_color(color, 0.8), tint_color(color, 1.15)], 14)
    return shape([(join([head, neck, socket]), metal), (join([dial, switch]), textures.plain(DARK)),
                  (grip, knurl)],
                 [hull_of(head, socket), hull_of(neck), flat_foot(grip.vertices, 0.1)])  # fmt: skip


def pipe_wrench(look: Look) -> Shape:
    """A pipe wrench lying: a toothed hook jaw over a fixed one, a long handle."""
    k = look.between(0.88, 1.05)
    color = look.color("red", "red", "orange", "blue", "green")
    h = 0.02 * k
    body = prism(np.array([(-0.15, -0.011), (-0.05, -0.008), (0.02, -0.014), (0.075, -0.02),
                           (0.08, -0.004), (0.05, 0.004), (0.05, 0.016), (0.015, 0.018),
                           (-0.05, 0.009), (-0.15, 0.011)]) * k, 0, h)  # fmt: skip
    hook = prism(np.array([(0.02, 0.012), (0.046, 0.012), (0.092, 0.014), (0.104, -0.002),
                           (0.098, -0.022), (0.116, -0.02), (0.124, 0.006), (0.105, 0.032),
                           (0.02, 0.032)]) * k, 0.15 * h, 0.85 * h)  # fmt: skip
    teeth = [box(0.003 * k, 0.012 * k, 0.8 * h).turn(2, 0.1).move(x, -0.013 * k, 0.1 * h)
             for x in (0.0815 * k, 0.094 * k)]  # fmt: skip
    nut = lying(cylinder(0.0125 * k, 0.014 * k, 16), 0.022 * k, 0.0125 * k).move(y=0.022 * k)
    return shape([(body, look.surface(color, "plastic")), (join([hook, *teeth]), steel(look)),
                  (nut, textures.stripes([(90, 92, 96), (150, 152, 156)], 8))],
                 [hull_of(body), hull_of(hook)])  # fmt: skip


def hacksaw(look: Look) -> Shape:
    """A hacksaw lying on its side: bow, thin blade, pistol grip."""
    k = look.between(0.85, 1.0)
    color = look.color("red", "blue", "black", "yellow", "orange", "green")
    z = 0.008 * k
    way = np.array([(0.17, 0.0), (0.172, 0.07), (0.16, 0.085), (-0.09, 0.085), (-0.11, 0.07),
                    (-0.115, 0.0)])  # fmt: skip
    bow = sweep(np.column_stack([way, np.full(6, z / k)]) * k, rectangle(0.008 * k, 0.014 * k))
    blade = box(0.285 * k, 0.012 * k, 0.0012).move(0.028 * k, -0.004 * k, z)
    teeth = prints.canvas(128, 16, (150, 154, 160))
    for n in range(32):
        prints.polygon(
            teeth, [(n / 32, 1), (n / 32 + 0.03, 1), (n / 32 + 0.015, 0.6)], (70, 72, 76)
        )
    grip = prism(np.array([(-0.11, 0.075), (-0.115, -0.015), (-0.15, -0.035), (-0.17, -0.02),
                           (-0.16, 0.05), (-0.145, 0.082)])[::-1] * k, 0, 2 * z)  # fmt: skip
    return shape([(bow, steel(look)), (blade, teeth), (grip, look.surface(color, "plastic"))],
                 [hull_of(grip), box_part(0.26 * k, 0.008 * k, 0.014 * k,
                                          (0.03 * k, 0.085 * k, 0.001 * k)),
                  box_part(0.008 * k, 0.085 * k, 0.014 * k, (0.17 * k, 0.042 * k, 0.001 * k)),
                  hull_of(blade)])  # fmt: skip


CATEGORIES = (
    Category("putty_knife", putty_knife, (0.198, 0.051, 0.016), 0.1, ("scraper", "filling knife",
             "paint scraper", "stripping knife", "wall scraper", "spackle knife",
             "drywall knife"), ("workbench",), (), ("wooden", "black"), None, "lying flat"),
    Category("wire_cutters", _cutters([(-0.006, 0.009), (0.004, -0.004), (0.038, -0.0005),
             (0.04, 0.003), (0.024, 0.013), (0.006, 0.014)], 0.105, 0.012),
             (0.143, 0.064, 0.0135), 0.18, ("wire cutter", "diagonal cutter", "side cutter",
             "diagonal pliers", "nippers", "side cutters", "snips", "bolt cutter", "tile cutter",
             "litter picker", "hot wire cutter"),
             ("workbench",), (),
             ("red", "blue"), None, "lying flat"),
    Category("tin_snips", _cutters([(-0.006, 0.01), (0.004, -0.004), (0.075, -0.001),
        (0.078, 0.001),
             (0.06, 0.011), (0.02, 0.016)], 0.14, 0.014), (0.216, 0.064, 0.0155), 0.35,
             ("tin snip", "metal shears", "metal snips", "aviation snips"), ("workbench",), (),
                 ("red",),
             None, "lying flat"),
    Category("wire_stripper", _cutters([(-0.006, 0.009), (0.004, -0.004), (0.02, -0.001),
             (0.026, 0.004), (0.034, -0.001), (0.066, -0.0005), (0.068, 0.006), (0.03, 0.013),
             (0.006, 0.014)], 0.115, 0.01), (0.181, 0.064, 0.0115), 0.15, ("wire strippers",
             "crimping tool", "crimper", "cable stripper", "crimping pliers"), ("workbench",), (),
             ("red", "yellow"), None, "lying flat"),
    Category("staple_gun", staple_gun, (0.176, 0.088, 0.026), 0.6, ("tacker", "stapler gun"),
             ("workbench",), (), ("silver",), None, "lying flat"),
    Category("oil_can", oil_can, (0.142, 0.083, 0.164), 0.3, ("oiler", "oil dispenser can",
             "lubricant can"), ("workbench",), ("tall",), ("red", "copper")),
    Category("socket_wrench", socket_wrench, (0.201, 0.0365, 0.03), 0.35, ("ratchet",
             "ratchet wrench", "socket spanner", "ratchet spanner"), ("workbench",), (),
             ("silver",), None, "lying flat"),
    Category("pipe_wrench", pipe_wrench, (0.266, 0.056, 0.024), 0.8, ("plumber wrench",
             "plumber's wrench", "stillson wrench", "monkey wrench"), ("workbench",), (),
             ("red",), None, "lying flat"),
    Category("hacksaw", hacksaw, (0.32, 0.118, 0.016), 0.5, ("hack saw", "metal saw"),
        ("workbench",), ("big",), ("red", "blue"), None, "lying flat"),
)  # fmt: skip
"""The module's categories."""
