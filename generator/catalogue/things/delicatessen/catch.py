"""Sea food as it is served: tails and claws, fried pieces, slices."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import blade
from ...build.recipes import ball
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, tube
from ...build.variants import at_rest, vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..fare.seafood import _claw
from .shore import ring


def claw(look: Look) -> Shape:
    """A cooked crab's claw lying."""
    k = look.between(0.9, 1.1)
    color = look.color("coral", "orange", "red")
    pinch = _claw(1, (-0.01, 0), 0.055, np.pi)
    arm = limb([(0.012, 0, 0.012), (0.035, 0.006, 0.012), (0.06, -0.012, 0.01)],
               [0.01, 0.0105, 0.007], 8)  # fmt: skip
    return settle([(join([pinch, arm]), textures.gradient(tint_color(color, 1.3), color,
                                                          look.rng))], 0.12).scale(k)  # fmt: skip


def lobster_tail(look: Look) -> Shape:
    """A lobster's tail: red rings, a fan, white meat at the front."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "coral", "crimson")
    rings = [ellipsoid(0.032, 0.056 - 0.004 * n, 0.04 - 0.003 * n, 14, 8).move(-0.05 + 0.02 * n, 0,
             0.019 - 0.001 * n) for n in range(6)]  # fmt: skip
    fan = [blade([(0.055, 0, 0.008), (0.072, 0.022 * s, 0.007), (0.1, 0.036 * s, 0.004)], 0.03,
                 thick=0.25) for s in (-1, -0.5, 0.02, 0.5, 1)]  # fmt: skip
    meat = ellipsoid(0.04, 0.044, 0.032, 14, 8).move(-0.062, 0, 0.017)
    return settle([(join([*rings, *fan]), textures.spots(look.rng, color, tint_color(color, 0.7),
                                                         0.08)),
                   (meat, textures.plain((250, 240, 228)))], 0.08).scale(k)  # fmt: skip


def crayfish(look: Look) -> Shape:
    """A crayfish or langoustine: like a small slim lobster."""
    from ..fare.seafood import lobster

    thing = lobster(look)
    return thing.scale(0.5)


def finger(look: Look) -> Shape:
    """A breaded finger of fish."""
    k = look.between(0.92, 1.08)
    x, y, h = 0.09 * k, 0.027 * k, 0.017 * k
    crumb = textures.spots(look.rng, tint_color(look.color("amber", "orange"), 1.02),
                           (186, 112, 44), 0.3)  # fmt: skip
    return shape([(block(x, y, h, 0.005, 0.003), crumb)], [box_part(x, y, h)])


def cake(look: Look) -> Shape:
    """A round breaded cake of fish or potato."""
    r, h = look.between(0.034, 0.042), look.between(0.02, 0.025)
    body = lathe([(0, 0), (0.85 * r, 0), (r, 0.35 * h), (r, 0.7 * h), (0.85 * r, h), (0, h)], 26)
    crumb = textures.spots(look.rng, look.color("amber", "copper"), (166, 98, 40), 0.35)
    return shape([(body, crumb)], [hull_of(body)])


def rollmop(look: Look) -> Shape:
    """A herring fillet rolled up, silver outside, with a stick through it."""
    r, h = look.between(0.022, 0.026), look.between(0.036, 0.042)
    t = np.linspace(1.2, 4.6 * np.pi, 50)
    away = r * t / t[-1]
    roll = tube(np.column_stack([away * np.cos(t), away * np.sin(t), np.zeros(50)]), 0.0042, 8)
    body = roll.scale(1, 1, 0.5 * h / 0.0042).move(z=0.5 * h)
    core = cylinder(0.7 * r, 0.9 * h, 20)
    pick = tube([(-1.5 * r, 0.2 * r, 0.55 * h), (1.6 * r, -0.2 * r, 0.62 * h)], 0.0012, 6)
    return settle([(body, textures.stripes([(180, 188, 198), (230, 226, 220)], 3)),
                   (core, textures.plain((232, 206, 196))),
                   (pick, textures.plain((214, 180, 128)))], 0.02, hulls=[[0, 1]])  # fmt: skip


def fish_and_chips(look: Look) -> Shape:
    """Battered fish on chips with peas and lemon, on an oval plate."""
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
    batter = textures.spots(look.rng, (222, 160, 70), (176, 110, 40), 0.35)
    food = [(fish, batter), (join(chips), textures.speckles(look.rng, (240, 206, 110), 12)),
            (join(peas), textures.plain((96, 158, 62))),
            (lemon, textures.plain((246, 222, 70)))]  # fmt: skip
    glaze = look.surface(look.color("white", "white", "sky", "cream"), "ceramic")
    return shape([(plate, glaze), *food], [hull_of(plate), hull_of(fish, *chips)]).scale(k)


def slices(look: Look) -> Shape:
    """Draped slices of smoked salmon."""
    k = look.between(0.9, 1.1)
    color = look.color("coral", "coral", "orange")
    sheets = []
    for n in range(3):
        t = np.linspace(-0.055, 0.055, 14)
        path = np.column_stack([t, 0.014 * (n - 1) + 0.006 * np.sin(60 * t + n), 0.004 + 0.004 * n +
                                0.0028 * np.sin(90 * t + 2 * n)])  # fmt: skip
        sheets.append(tube(path, 0.024, 10, squash=0.1))
    grain = textures.stripes([color, tint_color(color, 1.2), color], 6, upright=True)
    return settle([(join(sheets), grain)], 0.05).scale(k)


_K = ("kitchen", "dining")
_E = ("edible",)
_L = "lying flat"


CATEGORIES = (
    Category("crab_claw", claw, (0.135, 0.0412, 0.0207), 0.05, ("lobster claw", "claw of a crab"),
             _K, _E, ("coral",), state=_L),
    Category("lobster_tail", lobster_tail, (0.182, 0.0757, 0.0369), 0.15, ("tail of a lobster",),
             _K, _E, ("red",), state=_L),
    Category("crayfish", crayfish, (0.179, 0.0666, 0.0224), 0.06, ("langoustine", "crawfish",
             "dublin bay prawn", "yabby"), _K, _E, ("red",), state=_L),
    vary(Category("fish_finger", finger, (0.0907, 0.0272, 0.0171), 0.028, ("fish stick",
             "fishfinger",
             "potato croquette", "croquette", "mozzarella stick"), _K, _E, ("amber",), state=_L)),
    Category("fishcake", cake, (0.0769, 0.0775, 0.0227), 0.08, ("fish cake", "crab cake",
             "hash brown", "potato cake", "rosti", "latke", "potato pancake", "fritter",
             "rostis"), _K, ("edible", "round", "flat"), ("amber",), state=_L),
    Category("rollmop", rollmop, (0.0757, 0.0507, 0.0384), 0.06, ("pickled herring", "rollmops",
             "rolled herring"), _K, _E, ()),
    Category("calamari_ring", ring, (0.063, 0.0584, 0.0136), 0.015, ("calamari", "squid ring"), _K,
             ("edible", "flat"), ("amber",), state=_L),
    Category("fish_and_chips", fish_and_chips, (0.299, 0.219, 0.0518), 0.8,
             ("plate of fish and chips", "fish supper", "fish & chips"), _K, ("edible", "big"),
             ("white",)),
    at_rest(Category("smoked_salmon", slices, (0.124, 0.0864, 0.0196), 0.05, ("smoked salmon slice",
             "slice of smoked salmon", "gravlax", "lox"), _K, ("edible", "flat"), ("coral",),
             state=_L)),
)  # fmt: skip
"""The module's categories."""
