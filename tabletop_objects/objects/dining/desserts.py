"""Objects of the ``dining`` theme: desserts."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part
from ...kit.primitives import lobe
from ...kit.shapes import Shape, category, settle, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, tube
from ...kit.surfaces import RGB, Look, speck, tint_color


@category("jalebi", size=(0.0748, 0.0611, 0.012), mass=0.02, material="food",
          aliases=("jilebi", "zalabia", "jalebis"), themes=("dining",), roles=("edible", "flat"),
          state="lying flat")  # fmt: skip
@vary()
def jalebi(look: Look) -> Shape:
    """A loose, syrupy, bright orange spiral of jalebi."""
    r = look.between(0.032, 0.04)
    t = np.linspace(0.5, 6.2 * np.pi, 70)
    away = 0.9 * r * t / t[-1]
    path = np.column_stack([away * np.cos(t), away * np.sin(t), 0.002 * np.sin(7 * t)])
    cross = tube([(-r, 0.1 * r, 0.003), (0, -0.1 * r, 0.0045), (r, 0.15 * r, 0.003)], 0.0032, 6)
    syrup = surfaces.gradient((226, 110, 20), (246, 156, 40), look.rng)
    return settle([(join([tube(path, 0.004, 7), cross]), syrup)], 0.1)


@category("halva", size=(0.109, 0.0627, 0.0415), mass=0.25, material="food",
          aliases=("halva block", "halwa", "block of halva", "piece of halva"), themes=("dining",),
          roles=("edible",), colors=("beige",))  # fmt: skip
def halva(look: Look) -> Shape:
    """A block of halva with pistachios."""
    x, y, h = look.between(0.09, 0.12), look.between(0.055, 0.07), look.between(0.035, 0.045)
    tile = speck(surfaces.scratches(look.rng, look.color("beige", "tan"), (214, 190, 150), 90),
                 look.rng, (130, 160, 76), 26, 5)  # fmt: skip
    return shape([(block(x, y, h, 0.003, 0.001), tile)], [box_part(x, y, h)])


@category("panettone", size=(0.169, 0.17, 0.133), mass=0.8, material="food",
          aliases=("panettone cake", "pandoro"), themes=("dining",), roles=("edible", "round"),
          colors=("amber",))  # fmt: skip
def panettone(look: Look) -> Shape:
    """A tall domed loaf in a paper case."""
    r, h = look.between(0.068, 0.08), look.between(0.12, 0.14)
    case = lathe([(0, 0), (0.93 * r, 0), (r, 0.6 * h), (0, 0.6 * h)], 32)
    dome = lathe([(0, 0.5 * h), (0.97 * r, 0.59 * h), (1.14 * r, 0.7 * h), (1.08 * r, 0.84 * h),
                  (0.7 * r, 0.97 * h), (0, h)], 30)  # fmt: skip
    bars: list[Solid] = [box(1.0 * r, 0.006, 0.004).turn(2, a).move(z=0.985 * h) for a in (0, 1.57)]
    brown = surfaces.speckles(look.rng, (96, 58, 38), 8)
    return shape([(case, surfaces.stripes([(120, 76, 46), (142, 94, 58)], 12, upright=True)),
                  (dome, skin(look, look.color("copper", "amber"), (130, 70, 30), 0.9)),
                  (join(bars), brown)], [hull_of(case), hull_of(dome)])  # fmt: skip


@category("jelly", size=(0.124, 0.124, 0.0573), mass=0.18, material="ceramic", aliases=("jello",
          "panna cotta", "gelatin dessert", "flan", "jelly dessert", "blancmange", "jelly bowl",
          "bowl of jelly"), themes=("dining",), roles=("edible", "round"),
          colors=("red", "green"))  # fmt: skip
def jelly(look: Look) -> Shape:
    """A fluted dome of jelly on a small plate."""
    r, h = look.between(0.042, 0.055), look.between(0.045, 0.06)
    color = look.color("red", "green", "orange", "purple", "yellow", "pink")
    dome = lathe([(0, 0), (r, 0), (0.92 * r, 0.5 * h), (0.78 * r, 0.86 * h), (0.6 * r, h),
                  (0.28 * r, h), (0.18 * r, 0.9 * h), (0, 0.9 * h)], 60)  # fmt: skip
    dome = lobe(dome, int(look.pick([10, 12, 14])), 0.1)
    plate = lathe([(0, 0), (0.9 * r, 0), (1.35 * r, 0.009), (1.35 * r, 0.011), (0, 0.005)], 32)
    tile = surfaces.gradient(tint_color(color, 0.85), tint_color(color, 1.25), look.rng)
    return shape([(plate, surfaces.plain((246, 244, 240))), (dome.move(z=0.0045), tile)],
                 [hull_of(plate), hull_of(dome.move(z=0.0045))])  # fmt: skip


@category("cake", size=(0.19, 0.19, 0.09), mass=0.9, material="food", themes=("dining", "coffee"),
          roles=("edible", "round", "big"), colors=("white", "pink"), common=True)  # fmt: skip
def cake(look: Look) -> Shape:
    """A round cake with icing and berries."""
    r, h = look.between(0.085, 0.1), look.between(0.06, 0.075)
    icing = look.color("white", "pink", "brown", "cream")
    sponge = surfaces.speckles(look.rng, look.own_color("tan", "brown", "amber"), 8)
    frost = surfaces.speckles(look.rng, icing, 4)
    side = surfaces.stack((frost, 2), (sponge, 3), (frost, 1), (sponge, 3), (frost, 2))
    top = cylinder(r + 0.002, 0.01, 32, bevel=0.003).move(z=h)
    pieces = [(cylinder(r, h, 32), side), (top, frost)]
    red = surfaces.plain(look.own_color("red", "crimson", "indigo"))
    berries = [ellipsoid(0.018, 0.018, 0.017, 10, 6).move(0.78 * r * np.cos(0.785 * k), 0.78 * r
                                                          * np.sin(0.785 * k), h + 0.016)
               for k in range(8)]  # fmt: skip
    return shape(
        [*pieces, (join(berries), red)],
        [cylinder_part(r, h + 0.01), cylinder_part(0.84 * r, 0.012, (0, 0, h + 0.01))],
    )


@category("ice_cream", size=(0.0994, 0.0981, 0.116), mass=0.3, material="ceramic",
          aliases=("gelato", "ice cream bowl", "sundae", "ice cream sundae", "bowl of ice cream",
          "cup of ice cream", "ice cream cup", "frozen yogurt", "affogato"),
          themes=("dining", "food"), roles=("edible", "tall"),
          colors=("pink", "white"))  # fmt: skip
def ice_cream(look: Look) -> Shape:
    """Scoops of ice cream in a glass dish with a wafer, sauce or a cherry."""
    tones: dict[str, RGB] = {"vanilla": (246, 234, 196), "strawberry": (240, 168, 180),
                             "chocolate": (112, 72, 50), "mint": (176, 220, 190),
                             "mango": (246, 196, 90), "berry": (170, 120, 180)}  # fmt: skip
    r, h = look.between(0.044, 0.052), look.between(0.06, 0.085)
    color = look.color("clear", "white", "sky", "pink", "mint", "yellow")
    side = [(0.72 * r, 0), (0.2 * r, 0.16 * h), (0.2 * r, 0.34 * h), (0.62 * r, 0.5 * h),
            (0.92 * r, 0.76 * h), (r, h)]  # fmt: skip
    dish = lathe([(0, 0), *side, (0.94 * r, h), (0.8 * r, 0.8 * h), (0, 0.7 * h)], 30)
    pieces = [(dish, surfaces.plain(tint_color(color, 1.15)))]
    names = list(tones)
    places = [(-0.36, 0.1, 0.0), (0.36, 0.1, 0.0), (0.0, -0.28, 0.0), (0.0, 0.05, 0.62)]
    balls = []
    for a, b, lift in places[: look.pick([3, 4])]:
        tone = tones[look.pick(names)]
        ball = ellipsoid(1.02 * r, 1.02 * r, 0.96 * r, 18, 12)
        ball = ball.move(a * r, b * r, h + (0.16 + lift) * r)
        balls.append(ball)
        pieces.append((ball, surfaces.spots(look.rng, tone, tint_color(tone, 0.86), 0.12)))
    top = max(float(b.bounds[1, 2]) for b in balls)
    kind = look.pick(["wafer", "cherry", "plain"])
    if kind == "wafer":
        wafer = block(0.03, 0.006, 0.085, 0.004).turn(1, 0.35).move(0.4 * r, 0.35 * r, h)
        pieces.append((wafer, surfaces.grid((176, 116, 56), (222, 168, 98), 10, 5, 64, 3)))
    elif kind == "cherry":
        cherry = ellipsoid(0.02, 0.02, 0.02, 14, 8).move(0, -0.05 * r, top + 0.005)
        pieces.append((cherry, surfaces.plain((190, 24, 40))))
    return shape(pieces, [cylinder_part(0.72 * r, 0.1 * h), hull_part(dish.vertices),
                          hull_part(np.concatenate([b.vertices for b in balls]))])  # fmt: skip
