"""Objects of the ``dining`` theme: seafood."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import smooth
from ...kit.parts import hull_above, hull_of
from ...kit.primitives import blade, limb, lobe
from ...kit.shapes import Shape, category, settle, shape, vary
from ...kit.solids import Solid, ellipsoid, join, lathe, loft
from ...kit.surfaces import Look, tint_color


@category("shrimp", size=(0.0583, 0.0738, 0.0183), mass=0.02, material="food",
          aliases=("prawn", "king prawn"), themes=("dining",), roles=("edible",), colors=("coral",),
          state="lying flat")  # fmt: skip
def shrimp(look: Look) -> Shape:
    """A cooked prawn curled on its side, with its tail fan and legs spread."""
    k = look.between(0.9, 1.2)
    a = np.linspace(-0.5, 3.5, 9)
    r = 0.021
    path = np.column_stack([r * np.cos(a), r * np.sin(a) * 0.9, 0 * a])
    body = limb(path, [0.0105 * s for s in (0.25, 0.7, 0.95, 1, 1, 0.94, 0.82, 0.66, 0.42)], 12)
    color = look.color("coral", "pink", "orange", "gray")
    bands = surfaces.stripes([color, color, tint_color(color, 1.5)], 6)
    end = path[-1]
    fan = [blade(end + np.array([(0, 0, 0), (0.009 * np.cos(t), 0.009 * np.sin(t), 0.001),
                              (0.018 * np.cos(t), 0.018 * np.sin(t), 0.0)]), 0.011, thick=0.3)
           for t in (-1.2, -0.75, -0.3)]  # fmt: skip
    legs = [limb([(0.55 * r * np.cos(t), 0.5 * r * np.sin(t), -0.002),
                  (0.1 * r * np.cos(t), 0.1 * r * np.sin(t) - 0.003, -0.004)],
                 [0.0014, 0.0006], 5) for t in (0.4, 1.0, 1.6, 2.2)]  # fmt: skip
    feel = [limb([(*path[0, :2], 0.002), (0.028, -0.028, 0.004), (0.008 + 0.006 * s, -0.042, 0)],
                 [0.0009, 0.0007, 0.0005], 5) for s in (-1, 1)]  # fmt: skip
    eye = ellipsoid(0.0035, 0.0035, 0.0035, 8, 6).move(path[0, 0] + 0.002, path[0, 1], 0.0035)
    trim = surfaces.plain(tint_color(color, 0.8))
    return settle([(body, bands), (join([*fan, *legs, *feel]), trim),
                   (eye, surfaces.plain((26, 24, 26)))], 0.16,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


def claw(s: int, at: tuple[float, float], size: float, turn: float) -> Solid:
    """Return an open claw at the end of an arm, on the side ``s`` (-1 or 1)."""
    palm = ellipsoid(1.0, 0.62, 0.42, 12, 6)
    finger = limb([(0.3, 0.16, 0), (0.7, 0.24, 0), (1.05, 0.06, 0)], [0.16, 0.13, 0.03], 6)
    thumb = limb([(0.3, -0.16, 0), (0.62, -0.26, 0), (0.95, -0.1, 0)], [0.12, 0.1, 0.03], 6)
    made = join([palm, finger, thumb]).scale(size, size, size)
    return made.turn(2, turn).move(at[0], at[1], 0.24 * size)


@category("lobster", size=(0.354, 0.132, 0.0442), mass=0.6, material="food",
          aliases=("boiled lobster",), themes=("dining",), roles=("edible", "big"), colors=("red",),
          state="lying flat")  # fmt: skip
def lobster(look: Look) -> Shape:
    """A red lobster lying on its belly, with its claws on the left."""
    k = look.between(0.85, 1.1)
    color = look.color("red", "red", "crimson", "coral", "blue")
    head = ellipsoid(0.1, 0.05, 0.045, 18, 10).move(-0.02, 0, 0.02)
    rings = [ellipsoid(0.03, 0.048 - 0.003 * n, 0.034 - 0.002 * n, 12, 6).move(
        0.034 + 0.02 * n, 0, 0.017 - 0.001 * n) for n in range(6)]  # fmt: skip
    fan = [blade([(0.138, 0, 0.008), (0.155, 0.02 * s, 0.007), (0.182, 0.034 * s, 0.004)], 0.026,
                 thick=0.25) for s in (-1, -0.5, 0.02, 0.5, 1)]  # fmt: skip
    arms, legs, feel = [], [], []
    for s in (-1, 1):
        arms.append(limb([(-0.045, s * 0.018, 0.02), (-0.07, s * 0.05, 0.02),
                          (-0.105, s * 0.052, 0.016)], [0.007, 0.008, 0.009], 8))  # fmt: skip
        arms.append(claw(s, (-0.128, s * 0.05), 0.056, np.pi + s * 0.12))
        for n in range(4):
            x = -0.03 + 0.018 * n
            legs.append(limb([(x, s * 0.02, 0.016), (x + 0.002, s * 0.045, 0.022),
                              (x + 0.008, s * 0.068, 0.002)], [0.0036, 0.003, 0.0014],
                             5))  # fmt: skip
        feel.append(limb([(-0.068, s * 0.008, 0.024), (-0.11, s * 0.018, 0.045),
                          (-0.16, s * 0.02, 0.03)], [0.0017, 0.0013, 0.0006], 5))  # fmt: skip
    eyes = [ellipsoid(0.007, 0.007, 0.007, 8, 6).move(-0.06, s * 0.012, 0.035) for s in (-1, 1)]
    shell = surfaces.spots(look.rng, color, tint_color(color, 0.62), 0.08)
    body, limbs = join([head, *rings, *fan]), join([*arms, *legs, *feel])
    claws = [hull_above(arms[1]), hull_above(arms[3])]
    made = shape([(body, shell), (limbs, shell), (join(eyes), surfaces.plain((24, 22, 24)))],
                 [hull_above(body), *claws])  # fmt: skip
    return made.scale(k)


@category("crab", size=(0.216, 0.197, 0.0478), mass=0.4, material="food",
          aliases=("boiled crab", "king crab"), themes=("dining",), roles=("edible", "big"),
          colors=("red",), state="lying flat")  # fmt: skip
def crab(look: Look) -> Shape:
    """A crab lying flat, with its claws in front."""
    k = look.between(0.85, 1.12)
    color = look.color("red", "orange", "coral", "crimson", "blue")
    shell = ellipsoid(0.12, 0.085, 0.046, 24, 12).move(z=0.024)
    arms, legs, claws = [], [], []
    for s in (-1, 1):
        arms.append(limb([(s * 0.045, -0.025, 0.02), (s * 0.08, -0.035, 0.022),
                          (s * 0.072, -0.062, 0.016)], [0.008, 0.0095, 0.01], 8))  # fmt: skip
        claws.append(claw(s, (s * 0.06, -0.078), 0.046, -np.pi / 2 - s * 0.6))
        for n in range(4):
            y = -0.015 + 0.017 * n
            out = 0.02 * (n - 1.2)
            legs.append(limb([(s * 0.048, y, 0.02), (s * 0.08, y + 0.4 * out, 0.03),
                              (s * 0.105, y + out, 0.001)], [0.0055, 0.0045, 0.0018],
                             6))  # fmt: skip
    eyes = [ellipsoid(0.007, 0.007, 0.009, 8, 6).move(s * 0.014, -0.04, 0.038) for s in (-1, 1)]
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.66), 0.1)
    made = shape([(shell, tile), (join([*arms, *claws, *legs]), tile),
                  (join(eyes), surfaces.plain((24, 22, 24)))],
                 [hull_above(shell), *(hull_above(c) for c in claws),
                  *(hull_above(join(legs[4 * n : 4 * n + 4])) for n in (0, 1))])  # fmt: skip
    return made.scale(k)


@category("oyster", size=(0.0878, 0.0551, 0.0177), mass=0.06, material="food",
          aliases=("oyster shell", "raw oyster"), themes=("dining",), roles=("edible",),
          state="lying flat")  # fmt: skip
@vary()
def oyster(look: Look) -> Shape:
    """Half an oyster shell with the oyster in it, lying flat."""
    k = look.between(0.9, 1.15)
    ring = (smooth(np.array([(0.5, 0), (0.4, 0.26), (0, 0.34), (-0.38, 0.24), (-0.52, 0),
                             (-0.36, -0.2), (0, -0.3), (0.4, -0.24), (0.5, 0)]), 3)[:-1]
            * 0.085)  # fmt: skip
    levels = [(0.5, 0), (0.85, 0.006), (1, 0.014), (0.92, 0.014), (0.7, 0.007), (0.3, 0.006)]
    cup = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
               ring)  # fmt: skip
    rough = surfaces.spots(look.rng, (136, 130, 120), (86, 82, 78), 0.3)
    pearl = surfaces.speckles(look.rng, (238, 236, 230), 6)
    meat = ellipsoid(0.056, 0.034, 0.013, 18, 10).move(z=0.01)
    dark = ellipsoid(0.03, 0.018, 0.006, 12, 6).move(-0.004, 0.002, 0.0145)
    return shape([(cup, surfaces.stack((rough, 52), (pearl, 48))),
                  (meat, surfaces.speckles(look.rng, (206, 198, 178), 8)),
                  (dark, surfaces.plain((150, 142, 128)))], [hull_of(cup)]).scale(k)  # fmt: skip


@category("clam", size=(0.0453, 0.0468, 0.0406), mass=0.02, material="food",
          aliases=("cockle", "shellfish"), themes=("dining",), roles=("edible",),
          state="lying flat")  # fmt: skip
def clam(look: Look) -> Shape:
    """A ribbed, half-open cockle."""
    k = look.between(0.85, 1.15)
    color = look.color("beige", "cream", "tan", "terracotta", "charcoal")
    half = lobe(lathe([(0, 0), (0.022, 0), (0.02, 0.006), (0.012, 0.012), (0, 0.014)], 60), 26,
                0.07)  # fmt: skip
    low = half.bend(lambda p: np.column_stack([p[:, :2], 0.0135 - p[:, 2] * 0.95]))
    low = Solid(low.vertices, low.faces[:, ::-1], low.uv)
    up = half.turn(0, -0.6).move(y=0.004, z=0.0255)
    meat = ellipsoid(0.026, 0.024, 0.011, 14, 8).move(z=0.0165)
    tile = surfaces.stripes([color, tint_color(color, 0.8)], 8)
    body = join([low, up])
    return settle([(body, tile), (meat, surfaces.plain((236, 176, 110)))], 0.04).scale(k)
