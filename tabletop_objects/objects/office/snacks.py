"""Objects of the ``office`` theme: snacks."""

from __future__ import annotations

from ...kit import prints, surfaces
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, lathe
from ...kit.surfaces import Look, readable_on, tint_color
from ..dining.barware import _can


@category("energy_drink", size=(0.0526, 0.0526, 0.144), mass=0.27, material="metal",
          aliases=("energy drink can", "slim can", "can of energy drink"), themes=("office",),
          roles=("round", "tall"), colors=("blue", "black"))  # fmt: skip
def energy_drink(look: Look) -> Shape:
    """A slim can of energy drink."""
    return _can(look, look.between(0.0255, 0.0275), look.between(0.13, 0.15),
                look.pick(["ENERGY", "POWER", "BOOST", "VOLT"]), ("blue", "black", "lime", "red",
                                                                  "silver"))  # fmt: skip


@category("chewing_gum", size=(0.0886, 0.0236, 0.0128), mass=0.015, material="paper",
          aliases=("gum", "pack of gum", "gum packet", "stick of gum", "packet of chewing gum",
          "pack of chewing gum"), themes=("office",), roles=("flat",), colors=("green", "blue"),
          state="lying flat")  # fmt: skip
def chewing_gum(look: Look) -> Shape:
    """A slim packet of chewing gum with one stick pulled out."""
    x, y, h = look.between(0.068, 0.08), look.between(0.02, 0.026), look.between(0.011, 0.014)
    color = look.color("green", "blue", "teal", "red", "yellow", "pink")
    face = prints.canvas(160, 56, color)
    prints.disc(face, 0.2, 0.5, 0.3, tint_color(color, 1.6))
    prints.write(face, look.pick(["GUM", "MINT", "FRESH"]), 0.6, 0.5, 0.5,
                 (250, 250, 248), bold=True)  # fmt: skip
    stick = box(0.02, 0.8 * y, 0.28 * h).move(x=x / 2 + 0.006, z=0.36 * h)
    foil = surfaces.plain((214, 216, 222))
    top = box(x, y, 0.0006).move(z=h - 0.0003)
    return shape([(box(x, y, h), surfaces.speckles(look.rng, color, 4)), (top, face),
                  (stick, foil)], [box_part(x, y, h), hull_of(stick)])  # fmt: skip


def _bar(x: float, y: float, h: float, radius: float) -> Solid:
    return block(x, y, h, radius, 0.3 * h)


@category("granola_bar", size=(0.116, 0.036, 0.0206), mass=0.04, material="food",
          aliases=("energy bar", "protein bar", "cereal bar", "muesli bar", "snack bar", "oat bar"),
          themes=("office",), roles=("edible",), colors=("green", "orange"),
          state="lying flat")  # fmt: skip
def granola_bar(look: Look) -> Shape:
    """A bar of oats and nuts, half unwrapped."""
    x, y, h = look.between(0.1, 0.12), look.between(0.032, 0.038), look.between(0.018, 0.022)
    color = look.color("green", "orange", "blue", "red", "teal", "purple")
    bar = _bar(0.5 * x, y - 0.004, h - 0.004, 0.005).move(x=-0.24 * x, z=0.001)
    oats = surfaces.spots(look.rng, (206, 160, 96), (128, 78, 44), 0.3)
    wrap = _bar(0.56 * x, y, h, 0.004).move(x=0.2 * x)
    fin = box(0.012, 1.02 * y, 0.002).move(x=0.48 * x + 0.005, z=0.4 * h)
    face = prints.canvas(128, 72, color)
    prints.write(face, look.pick(["OATS", "ENERGY", "PROTEIN", "NUTS"]), 0.5, 0.4, 0.34,
                 (250, 250, 246), bold=True)  # fmt: skip
    prints.fill(face, 0, 0.72, 1, 0.12, tint_color(color, 1.5))
    top = box(0.5 * x, 0.8 * y, 0.0007).move(x=0.2 * x, z=h - 0.0003)
    return shape([(bar, oats), (wrap, surfaces.plain(color)), (top, face),
                  (fin, surfaces.plain((208, 210, 214)))],
                 [hull_of(bar), hull_of(wrap)])  # fmt: skip


@category("instant_noodles", size=(0.102, 0.11, 0.109), mass=0.1, material="paper",
          aliases=("cup noodles", "instant noodle cup", "cup of noodles", "instant ramen",
          "cup noodle", "noodle cup", "pot noodle", "instant noodles cup"), themes=("office",),
          roles=("round",), colors=("red",))  # fmt: skip
def instant_noodles(look: Look) -> Shape:
    """A cup of instant noodles with its lid closed or half peeled off."""
    r, h = look.between(0.046, 0.054), look.between(0.1, 0.115)
    color = look.color("red", "orange", "green", "yellow", "purple")
    image = prints.label(look.rng, look.pick(["NOODLES", "RAMEN", "CUP"]), color, (248, 246, 240))
    white = surfaces.plain((248, 246, 240))
    body = lathe([(0, 0), (0.72 * r, 0), (0.96 * r, 0.94 * h), (r, 0.95 * h), (r, h), (0, h)], 32,
                 v=[0, 0.02, 0.93, 0.95, 0.97, 1])  # fmt: skip
    lid = prints.canvas(96, 96, color)
    prints.write(lid, look.pick(["BEEF", "CHICKEN", "SPICY"]), 0.5, 0.5, 0.22, readable_on(color),
                 bold=True)  # fmt: skip
    cover = cylinder(1.01 * r, 0.0012, 32).move(z=h - 0.0004)
    tab = box(0.02, 0.014, 0.0012).move(0, -1.03 * r, h - 0.0004)
    return shape([(body, surfaces.stack((image, 90), (white, 10), side=160)), (cover, lid),
                  (tab, surfaces.plain(color))], [hull_of(body, cover)])  # fmt: skip
