"""Objects of the ``kitchen`` theme: seafood."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import ellipse, smooth
from ...kit.parts import box_part, hull_above, hull_of
from ...kit.primitives import ball, bent_rod, blade, limb, lobe, side_view
from ...kit.shapes import Category, Shape, at_rest, category, settle, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from ..dining.seafood import claw, lobster
from .meats import dome


@category("crab_claw", size=(0.135, 0.0412, 0.0207), mass=0.05, material="food",
          aliases=("lobster claw", "claw of a crab"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("coral",), state="lying flat")  # fmt: skip
def crab_claw(look: Look) -> Shape:
    """A cooked crab claw, lying flat."""
    k = look.between(0.9, 1.1)
    color = look.color("coral", "orange", "red")
    pinch = claw(1, (-0.01, 0), 0.055, np.pi)
    arm = limb([(0.012, 0, 0.012), (0.035, 0.006, 0.012), (0.06, -0.012, 0.01)],
               [0.01, 0.0105, 0.007], 8)  # fmt: skip
    return settle([(join([pinch, arm]), surfaces.gradient(tint_color(color, 1.3), color,
                                                          look.rng))], 0.12).scale(k)  # fmt: skip


@category("lobster_tail", size=(0.182, 0.0757, 0.0369), mass=0.15, material="food",
          aliases=("tail of a lobster",), themes=("kitchen", "dining"), roles=("edible",),
          colors=("red",), state="lying flat")  # fmt: skip
def lobster_tail(look: Look) -> Shape:
    """A lobster tail with red rings, a tail fan and white meat at the front."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "coral", "crimson")
    rings = [ellipsoid(0.032, 0.056 - 0.004 * n, 0.04 - 0.003 * n, 14, 8).move(-0.05 + 0.02 * n, 0,
             0.019 - 0.001 * n) for n in range(6)]  # fmt: skip
    fan = [blade([(0.055, 0, 0.008), (0.072, 0.022 * s, 0.007), (0.1, 0.036 * s, 0.004)], 0.03,
                 thick=0.25) for s in (-1, -0.5, 0.02, 0.5, 1)]  # fmt: skip
    meat = ellipsoid(0.04, 0.044, 0.032, 14, 8).move(-0.062, 0, 0.017)
    return settle([(join([*rings, *fan]), surfaces.spots(look.rng, color, tint_color(color, 0.7),
                                                         0.08)),
                   (meat, surfaces.plain((250, 240, 228)))], 0.08).scale(k)  # fmt: skip


@category("crayfish", size=(0.179, 0.0666, 0.0224), mass=0.06, material="food", assembled=True,
          aliases=("langoustine", "crawfish", "dublin bay prawn", "yabby"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("red",),
          state="lying flat")  # fmt: skip
def crayfish(look: Look) -> Shape:
    """A crayfish or langoustine, shaped like a small, slim lobster."""
    thing = lobster(look)
    return thing.scale(0.5)


@category("fish_finger", size=(0.0907, 0.0272, 0.0171), mass=0.028, material="food",
          aliases=("fish stick", "fishfinger", "potato croquette", "croquette", "mozzarella stick"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("amber",),
          state="lying flat")  # fmt: skip
@vary()
def fish_finger(look: Look) -> Shape:
    """A breaded fish finger."""
    k = look.between(0.92, 1.08)
    x, y, h = 0.09 * k, 0.027 * k, 0.017 * k
    crumb = surfaces.spots(look.rng, tint_color(look.color("amber", "orange"), 1.02),
                           (186, 112, 44), 0.3)  # fmt: skip
    return shape([(block(x, y, h, 0.005, 0.003), crumb)], [box_part(x, y, h)])


@category("fishcake", size=(0.0769, 0.0775, 0.0227), mass=0.08, material="food",
          aliases=("fish cake", "crab cake", "hash brown", "potato cake", "rosti", "latke",
          "potato pancake", "fritter", "rostis"), themes=("kitchen", "dining"),
          roles=("edible", "round", "flat"), colors=("amber",), state="lying flat")  # fmt: skip
def fishcake(look: Look) -> Shape:
    """A round, breaded cake of fish or potato."""
    r, h = look.between(0.034, 0.042), look.between(0.02, 0.025)
    body = lathe([(0, 0), (0.85 * r, 0), (r, 0.35 * h), (r, 0.7 * h), (0.85 * r, h), (0, h)], 26)
    crumb = surfaces.spots(look.rng, look.color("amber", "copper"), (166, 98, 40), 0.35)
    return shape([(body, crumb)], [hull_of(body)])


@category("rollmop", size=(0.0757, 0.0507, 0.0384), mass=0.06, material="food", assembled=True,
          aliases=("pickled herring", "rollmops", "rolled herring"), themes=("kitchen", "dining"),
          roles=("edible",))  # fmt: skip
def rollmop(look: Look) -> Shape:
    """A rolled herring fillet, silver on the outside, with a stick through it."""
    r, h = look.between(0.022, 0.026), look.between(0.036, 0.042)
    t = np.linspace(1.2, 4.6 * np.pi, 50)
    away = r * t / t[-1]
    roll = tube(np.column_stack([away * np.cos(t), away * np.sin(t), np.zeros(50)]), 0.0042, 8)
    body = roll.scale(1, 1, 0.5 * h / 0.0042).move(z=0.5 * h)
    core = cylinder(0.7 * r, 0.9 * h, 20)
    pick = tube([(-1.5 * r, 0.2 * r, 0.55 * h), (1.6 * r, -0.2 * r, 0.62 * h)], 0.0012, 6)
    return settle([(body, surfaces.stripes([(180, 188, 198), (230, 226, 220)], 3)),
                   (core, surfaces.plain((232, 206, 196))),
                   (pick, surfaces.plain((214, 180, 128)))], 0.02, hulls=[[0, 1]])  # fmt: skip


@category("fish_and_chips", size=(0.299, 0.219, 0.0518), mass=0.8, material="food",
          aliases=("plate of fish and chips", "fish supper", "fish & chips"),
          themes=("kitchen", "dining"), roles=("edible", "big"), colors=("white",))  # fmt: skip
def fish_and_chips(look: Look) -> Shape:
    """Battered fish, chips, peas and lemon on an oval plate."""
    k = look.between(0.95, 1.05)
    plate = lathe([(0, 0), (0.6, 0), (1, 0.12), (0.98, 0.135), (0.62, 0.04), (0, 0.04)], 36).scale(
        0.15, 0.11, 0.15)  # fmt: skip
    fish = limb([(-0.09, 0.02, 0.028), (-0.04, 0.03, 0.034), (0.03, 0.026, 0.032),
                 (0.085, 0.014, 0.022)], [0.014, 0.029, 0.025, 0.01], 12, squash=0.6)  # fmt: skip
    chips = [box(0.055, 0.01, 0.01).turn(2, look.between(-1.2, 1.2)).turn(1, look.between(
             -0.15, 0.15)).move(look.between(-0.06, 0.06), look.between(-0.055, -0.015),
             0.01 + 0.008 * (n % 3)) for n in range(20)]  # fmt: skip
    peas = [ball(0.009, 0.009, 0.009, (0.075 + 0.009 * (n % 4), -0.028 + 0.009 * (n // 4), 0.015 +
            0.004 * (n % 2)), 7) for n in range(16)]  # fmt: skip
    lemon = ellipsoid(0.04, 0.02, 0.022, 14, 8).turn(2, 0.6).move(-0.09, -0.03, 0.02)
    batter = surfaces.spots(look.rng, (222, 160, 70), (176, 110, 40), 0.35)
    food = [(fish, batter), (join(chips), surfaces.speckles(look.rng, (240, 206, 110), 12)),
            (join(peas), surfaces.plain((96, 158, 62))),
            (lemon, surfaces.plain((246, 222, 70)))]  # fmt: skip
    glaze = look.surface(look.color("white", "white", "sky", "cream"), "ceramic")
    return shape([(plate, glaze), *food], [hull_of(plate), hull_of(fish, *chips)]).scale(k)


@category("smoked_salmon", size=(0.124, 0.0864, 0.0196), mass=0.05, material="food",
          aliases=("smoked salmon slice", "slice of smoked salmon", "gravlax", "lox"),
          themes=("kitchen", "dining"), roles=("edible", "flat"), colors=("coral",),
          state="lying flat")  # fmt: skip
@at_rest
def smoked_salmon(look: Look) -> Shape:
    """Draped slices of smoked salmon."""
    k = look.between(0.9, 1.1)
    color = look.color("coral", "coral", "orange")
    sheets = []
    for n in range(3):
        t = np.linspace(-0.055, 0.055, 14)
        path = np.column_stack([t, 0.014 * (n - 1) + 0.006 * np.sin(60 * t + n), 0.004 + 0.004 * n +
                                0.0028 * np.sin(90 * t + 2 * n)])  # fmt: skip
        sheets.append(tube(path, 0.024, 10, squash=0.1))
    grain = surfaces.stripes([color, tint_color(color, 1.2), color], 6, upright=True)
    return settle([(join(sheets), grain)], 0.05).scale(k)


FRIED: RGB = (222, 160, 74)


@category("mussel", size=(0.0713, 0.0362, 0.0367), mass=0.025, material="food",
          aliases=("mussel shell", "open mussel"), themes=("kitchen", "dining"), roles=("edible",),
          colors=("navy",), state="lying flat")  # fmt: skip
def mussel(look: Look) -> Shape:
    """A blue-black mussel, half open and orange inside."""
    k = look.between(0.9, 1.15)
    ring = (smooth(np.array([(-0.5, 0), (-0.3, -0.2), (0.1, -0.27), (0.45, -0.18), (0.5, 0.05),
                             (0.35, 0.2), (0, 0.2), (-0.3, 0.12), (-0.5, 0)]), 4)[:-1]
            * 0.068)  # fmt: skip
    half = dome(ring, 0.014)
    low = half.bend(lambda p: np.column_stack([p[:, :2], 0.014 - p[:, 2]]))
    low = Solid(low.vertices, low.faces[:, ::-1], low.uv)
    lift = half.turn(0, 0.55).move(y=0.004, z=0.022)
    meat = ellipsoid(0.044, 0.018, 0.012, 14, 8).move(0.003, -0.002, 0.015)
    color = look.color("navy", "charcoal", "black")
    shell = surfaces.stripes([tint_color(color, 0.7), tint_color(color, 1.15)], 7)
    inside = prism(ring * 0.94, 0.0125, 0.0146)
    return settle([(join([low, lift]), shell), (meat, surfaces.plain((236, 150, 70))),
                   (inside, surfaces.plain((196, 200, 214)))], 0.05,
                  hulls=[[0]]).scale(k)  # fmt: skip


@category("scallop", size=(0.0977, 0.0749, 0.0223), mass=0.07, material="food",
          aliases=("king scallop", "scallop in its shell"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("coral",), state="lying flat")  # fmt: skip
def scallop(look: Look) -> Shape:
    """A fan-shaped scallop in its half shell with white meat and orange roe."""
    k = look.between(0.9, 1.1)
    a = np.linspace(-0.25, np.pi + 0.25, 25)
    fan = np.column_stack([0.05 * np.cos(a), 0.048 * np.sin(a)]) * (1 + 0.03 * np.cos(24 * a))[
        :, None]  # fmt: skip
    outline = np.concatenate([[(0.016, -0.024)], fan, [(-0.016, -0.024)]])
    dish = prism(outline, 0.0, 0.006, 0.002)
    wall = lobe(torus(0.045, 0.0035, 60, 6), 24, 0.04).move(y=0.004, z=0.008)
    wall = wall.bend(lambda p: np.column_stack([p[:, 0], np.maximum(p[:, 1], -0.018), p[:, 2]]))
    color = look.color("coral", "beige", "cream", "terracotta")
    meat = cylinder(0.02, 0.018, 24, bevel=0.004).move(0, 0.006, 0.005)
    roe = bent_rod(0.04, 0.008, bend=0.014, blunt=4).move(0, 0.034, 0.012)
    return shape([(dish, surfaces.stripes([color, tint_color(color, 0.85)], 12, upright=True)),
                  (wall, surfaces.speckles(look.rng, color, 8)),
                  (meat, surfaces.speckles(look.rng, (248, 240, 222), 5)),
                  (roe, surfaces.plain((232, 110, 60)))],
                 [hull_of(dish), hull_of(meat)]).scale(k)  # fmt: skip


@category("squid", size=(0.249, 0.138, 0.0351), mass=0.2, material="food",
          aliases=("cuttlefish", "raw squid", "whole squid"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("pink",), state="lying flat")  # fmt: skip
def squid(look: Look) -> Shape:
    """A squid lying flat: a pale mantle with fins, and arms on the right."""
    k = look.between(0.9, 1.1)
    color = look.color("pink", "beige", "coral", "ivory")
    mantle = limb([(-0.13, 0, 0.0), (-0.08, 0, 0), (0, 0, 0), (0.03, 0, 0)],
                  [0.004, 0.024, 0.032, 0.027], 16, squash=0.65)  # fmt: skip
    fins = [blade([(-0.05, s * 0.01, 0), (-0.085, s * 0.05, 0), (-0.125, s * 0.012, 0)], 0.05,
                  thick=0.08) for s in (-1, 1)]  # fmt: skip
    head = ellipsoid(0.042, 0.036, 0.03, 14, 8).move(x=0.045)
    arms = [limb([(0.055, 0.004 * n, -0.004), (0.09, 0.011 * n, -0.008), (0.12, 0.016 * n +
                  0.01 * (-1) ** n, -0.012)], [0.0055, 0.004, 0.0012], 6)
            for n in (-3, -2, -1, 0, 1, 2, 3)]  # fmt: skip
    eyes = [ball(0.01, 0.01, 0.008, (0.045, s * 0.014, 0.01), 10) for s in (-1, 1)]
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.1)
    return settle([(join([mantle, *fins, head]), tile), (join(arms), tile),
                   (join(eyes), surfaces.plain((26, 24, 30)))], 0.15,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("octopus", size=(0.178, 0.178, 0.0962), mass=0.4, material="food",
          aliases=("baby octopus", "toy octopus", "rubber octopus"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("crimson",))  # fmt: skip
def octopus(look: Look) -> Shape:
    """An octopus with a bulging head and eight curling arms with suckers."""
    k = look.between(0.9, 1.1)
    color = look.color("crimson", "coral", "purple", "pink")
    head = join([ellipsoid(0.07, 0.064, 0.075, 20, 12).move(0, 0.006, 0.058),
                 ellipsoid(0.06, 0.05, 0.04, 16, 8).move(0, 0, 0.022)])  # fmt: skip
    arms, cups = [], []
    for n in range(8):
        a = 2 * np.pi * (n + 0.5) / 8
        b = a + 0.5 * (-1) ** n
        path = [(0.02 * np.cos(a), 0.02 * np.sin(a), 0.018), (0.06 * np.cos(a), 0.06 * np.sin(a),
                0.009), (0.1 * np.cos(b), 0.1 * np.sin(b), 0.006), (0.09 * np.cos(b + 0.35),
                0.09 * np.sin(b + 0.35), 0.004)]  # fmt: skip
        arms.append(limb(path, [0.013, 0.0095, 0.006, 0.0018], 8))
        cups += [ball(0.006, 0.006, 0.004, (r * np.cos(a + 0.12), r * np.sin(a + 0.12), 0.006), 6)
                 for r in (0.05, 0.062)]  # fmt: skip
    eyes = [ball(0.014, 0.012, 0.014, (s * 0.02, -0.026, 0.05), 10) for s in (-1, 1)]
    pupils = [ball(0.007, 0.006, 0.007, (s * 0.021, -0.031, 0.05), 8) for s in (-1, 1)]
    tile = surfaces.spots(look.rng, color, tint_color(color, 1.3), 0.08)
    return shape([(head, tile), (join(arms), tile), (join(cups), surfaces.plain((246, 214, 206))),
                  (join(eyes), surfaces.plain((248, 244, 230))),
                  (join(pupils), surfaces.plain((24, 22, 28)))],
                 [hull_of(head), *(hull_above(*arms[n : n + 2])
                                   for n in (0, 2, 4, 6))]).scale(k)  # fmt: skip


@category("octopus_tentacle", size=(0.115, 0.0835, 0.0243), mass=0.1, material="food",
          aliases=("tentacle", "squid tentacle", "grilled octopus"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("crimson",), state="lying flat")  # fmt: skip
def octopus_tentacle(look: Look) -> Shape:
    """One curled octopus arm with rows of suckers."""
    k = look.between(0.9, 1.1)
    color = look.color("crimson", "purple", "coral")
    t = np.linspace(0, 1, 8)
    turn = 0.4 + 4.4 * t**1.4
    away = 0.075 * (1 - 0.8 * t)
    path = np.column_stack([away * np.cos(turn), away * np.sin(turn), 0 * t])
    radii = 0.013 * (1 - 0.85 * t) + 0.001
    arm = limb(path, list(radii), 10)
    points, wide = smooth(path, 4), np.interp(np.linspace(0, 1, 29), t, radii)
    cups = [cylinder(0.4 * w, 0.3 * w, 8).move(*(p + np.array([0, 0, 0.85 * w])))
            for p, w in zip(points, wide, strict=True)]  # fmt: skip
    return settle([(arm, surfaces.spots(look.rng, color, tint_color(color, 1.25), 0.1)),
                   (join(cups), surfaces.plain((246, 210, 206)))], 0.15).scale(k)  # fmt: skip


@category("sea_urchin", size=(0.0918, 0.0919, 0.062), mass=0.1, material="food", assembled=True,
          aliases=("urchin", "sea urchin shell"), themes=("kitchen", "dining"), roles=("round",),
          colors=("purple",))  # fmt: skip
def sea_urchin(look: Look) -> Shape:
    """A sea urchin with its spines."""
    k = look.between(0.9, 1.1)
    color = look.color("purple", "black", "maroon", "navy")
    core = ellipsoid(0.05, 0.05, 0.036, 20, 10).move(z=0.024)
    spines = []
    for n in range(90):
        up = 1 - 1.55 * (n + 0.5) / 90
        flat = np.sqrt(1 - up * up)
        way = np.array([flat * np.cos(2.4 * n), flat * np.sin(2.4 * n), up])
        a = np.array([0, 0, 0.024]) + way * [0.022, 0.022, 0.016]
        b = a + way * 0.024
        spines.append(tube([a, [b[0], b[1], max(b[2], 0.001)]], [0.0014, 0.0004], 4))
    dark = surfaces.speckles(look.rng, tint_color(color, 0.8), 9)
    return shape([(join([core, *spines]), dark)], [hull_of(core, *spines)]).scale(k)


@category("eel", size=(0.372, 0.12, 0.0293), mass=0.3, material="food",
          aliases=("smoked eel", "moray", "lamprey"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("olive",), state="lying flat")  # fmt: skip
def eel(look: Look) -> Shape:
    """A long, smooth eel in a loose S shape."""
    k = look.between(0.9, 1.1)
    color = look.color("olive", "charcoal", "brown", "gray")
    body = limb([(-0.17, 0.0, 0), (-0.11, 0.045, 0), (-0.02, 0.01, 0), (0.06, -0.045, 0),
                 (0.14, -0.01, 0), (0.19, 0.03, 0)], [0.011, 0.015, 0.016, 0.014, 0.01, 0.002],
                12)  # fmt: skip
    fin = limb([(-0.08, 0.04, 0.014), (0.0, -0.004, 0.016), (0.07, -0.045, 0.013),
                (0.15, -0.006, 0.008)], [0.001, 0.0035, 0.0035, 0.001], 5)  # fmt: skip
    eyes = [ball(0.005, 0.005, 0.004, (-0.163, 0.002 + 0.009 * s, 0.008), 8) for s in (-1, 1)]
    return settle([(body, surfaces.gradient(tint_color(color, 1.4), tint_color(color, 0.8),
                                            look.rng)),
                   (fin, surfaces.plain(tint_color(color, 0.6))),
                   (join(eyes), surfaces.plain((240, 220, 120)))], 0.18).scale(k)  # fmt: skip


@category("flatfish", size=(0.247, 0.166, 0.0177), mass=0.3, material="food", aliases=("plaice",
          "flounder", "dover sole", "lemon sole", "turbot", "halibut", "flat fish", "sole fish",
          "sole"), themes=("kitchen", "dining"), roles=("edible", "flat"), colors=("brown",),
          state="lying flat")  # fmt: skip
def flatfish(look: Look) -> Shape:
    """A plaice or sole: an oval, flat, spotted fish with fins along its edge."""
    k = look.between(0.9, 1.1)
    color = look.color("brown", "olive", "tan", "gray")
    body = ellipsoid(0.2, 0.13, 0.024, 28, 10)
    fringe = prism(ellipse(0.21, 0.165, 32), -0.0022, 0.0022).move(x=0.006)
    tail = prism(np.array([(0.095, -0.01), (0.145, -0.034), (0.14, 0.034), (0.095, 0.01)]), -0.0022,
                 0.0022)  # fmt: skip
    eyes = [ball(0.011, 0.011, 0.01, (-0.075, y, 0.0085), 10) for y in (-0.008, 0.012)]
    pupils = [ball(0.005, 0.005, 0.005, (-0.076, y, 0.0125), 8) for y in (-0.008, 0.012)]
    dots = [ellipsoid(0.011, 0.011, 0.002, 10, 4).move(x, y, 0.0115 * np.sqrt(max(
            1 - (x / 0.1) ** 2 - (y / 0.065) ** 2, 0.1)))
            for x, y in ((-0.03, 0.03), (0.01, -0.03), (0.04, 0.02), (0.0, 0.008), (-0.04, -0.02),
                         (0.06, -0.015))]  # fmt: skip
    return settle([(body, skin(look, color, tint_color(color, 0.8), 0.8)),
                   (join([fringe, tail]), surfaces.speckles(look.rng, tint_color(color, 0.7), 8)),
                   (join(eyes), surfaces.plain((230, 220, 190))),
                   (join(pupils), surfaces.plain((22, 22, 26))),
                   (join(dots), surfaces.plain((222, 120, 50)))], 0.35).scale(k)  # fmt: skip


def ring(look: Look) -> Shape:
    """A battered squid ring."""
    r, t = look.between(0.021, 0.027), look.between(0.007, 0.009)
    body = torus(r, t, 26, 10).scale(1, 0.92, 1.0)
    batter = surfaces.spots(look.rng, tint_color(look.color("amber", "tan"), 1.1), FRIED, 0.35)
    return settle([(body, batter)], 0.12)


@category("fish", size=(0.205, 0.0866, 0.0272), mass=0.35, material="food", aliases=("whole fish",
          "trout", "mackerel", "sea bass", "herring", "grilled fish", "raw fish", "sardine",
          "anchovy", "cod", "haddock", "sea bream", "red snapper", "whole trout", "kipper",
          "tilapia", "perch", "pollock", "carp"), themes=("kitchen",), roles=("edible",),
          colors=("silver", "gray"), state="lying flat")  # fmt: skip
def fish(look: Look) -> Shape:
    """A whole fish lying on its side with its head on the left."""
    long, tall, t = look.between(0.2, 0.26), look.between(0.066, 0.085), look.between(0.026, 0.034)
    color = look.color("silver", "gray", "sky", "teal", "coral", "gold", "olive")
    body = bent_rod(0.8 * long, tall / 2, blunt=2.0, squash=t / tall, sides=16)
    body = body.bend(lambda p: np.column_stack([p[:, 0], p[:, 1] * (1 - 0.5 * np.clip(
        p[:, 0] / (0.4 * long), 0, 1)), p[:, 2]]))  # fmt: skip
    tail = prism(np.array([(0.32, -0.005), (0.39, -0.024), (0.5, -0.2), (0.465, 0), (0.5, 0.2),
                           (0.39, 0.024), (0.32, 0.005)]) * [long, 0.5 * long], -0.0025,
                 0.0025)  # fmt: skip
    top = prism(np.array([(-0.12, 0.16), (0.12, 0.14), (0.1, 0.22), (-0.02, 0.25)]) * [
        long, 0.86 * tall / 0.2 * 0.55], -0.0025, 0.0025)  # fmt: skip
    low = prism(np.array([(0.12, -0.25), (0.18, -0.22), (0.16, -0.1), (0.04, -0.12)]) * [
        long, 0.86 * tall / 0.2 * 0.5], -0.0025, 0.0025)  # fmt: skip
    side = blade([(-0.14 * long, 0, 0.43 * t), (-0.08 * long, -0.004, 0.5 * t),
                  (-0.03 * long, -0.01, 0.49 * t)], 0.028, thick=0.25)  # fmt: skip
    eye = [cylinder(0.0065, 0.003, 14).move(-0.29 * long, 0.009, 0.3 * t)]
    pupil = [cylinder(0.0035, 0.0036, 12).move(-0.29 * long, 0.009, 0.3 * t)]
    gill = limb([(-0.19 * long, -0.3 * tall, 0.3 * t), (-0.175 * long, 0, 0.485 * t),
                 (-0.19 * long, 0.3 * tall, 0.3 * t)], [0.0012] * 3, 6)  # fmt: skip
    y, x = np.mgrid[0:128, 0:128]
    net = np.abs(np.sin(np.pi * (x / 8 + y / 6)) * np.sin(np.pi * (x / 8 - y / 6)))
    around = 0.5 + 0.5 * np.cos(2 * np.pi * x / 128)
    shade = (0.74 + 0.3 * net)[..., None] * (1 - 0.25 * around[..., None])
    scales = np.clip(np.array(color) * shade, 0, 255).astype(np.uint8)
    fin = surfaces.speckles(look.rng, tint_color(color, 0.68), 10)
    return settle([(body, scales), (join([tail, top, low, side, gill]), fin),
                   (join(eye), surfaces.plain((250, 248, 240))),
                   (join(pupil), surfaces.plain((24, 24, 28)))], 0.18,
                  hulls=[[0], [1]])  # fmt: skip


@category("salmon", size=(0.128, 0.0627, 0.023), mass=0.15, material="food",
          aliases=("salmon fillet", "salmon steak", "fish fillet", "fillet", "fillet of fish",
          "tuna steak", "cod fillet", "monkfish tail", "salmon portion", "trout fillet"),
          themes=("kitchen",), roles=("edible",), colors=("coral",),
          state="lying flat")  # fmt: skip
def salmon(look: Look) -> Shape:
    """A pink salmon fillet with pale lines, lying on its skin."""
    x, y, h = look.between(0.12, 0.15), look.between(0.055, 0.07), look.between(0.02, 0.027)
    side = np.array([(-0.5, 0), (0.5, 0), (0.47, 0.7), (0.2, 1.0), (-0.2, 0.9), (-0.47, 0.4)])
    body = side_view(side * [y, h], x, 0.004).turn(2, np.pi / 2)
    color = look.color("coral", "coral", "orange", "white", "pink")
    rows = np.linspace(0, 1, 128)
    line = np.abs(np.sin(np.pi * (9 * rows[:, None] + 1.2 * np.abs(rows[None] - 0.5)))) < 0.2
    flesh = np.where(line[..., None], np.array(tint_color(color, 1.5)), np.array(color))
    skin = block(x, 0.98 * y, 0.0022, 0.006)
    return shape([(body, flesh.astype(np.uint8)), (skin, surfaces.plain((126, 130, 136)))],
                 [hull_of(body)])  # fmt: skip


CATEGORIES = (
    Category("calamari_ring", ring, size=(0.063, 0.0584, 0.0136), mass=0.015, material="food",
             aliases=("calamari", "squid ring"), themes=("kitchen", "dining"),
             roles=("edible", "flat"), colors=("amber",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
