"""Objects of the ``dining`` theme: glasses."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import contents, drink_color, glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of, open_vessel, ring_parts
from ...kit.shapes import Shape, category, shape
from ...kit.solids import Solid, cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from ...values import ConvexPart

Pieces = list[tuple[Solid, surfaces.Tile]]


def _stem_profile(
    side: list[tuple[float, float]], foot: float, wet: tuple[RGB, float], clear: surfaces.Tile
) -> tuple[Pieces, list[ConvexPart]]:
    """Return a stemmed glass with cup profile ``side``; ``wet`` is the drink's colour and level."""
    (low, cup), (rim, h) = side[0], side[-1]
    outer = np.array(side)
    inner = np.column_stack([np.maximum(outer[:, 0] - 0.0022, 0.001), outer[:, 1] + 0.003])[::-1]
    inner[0, 1] = h
    stem = [(0, 0), (foot, 0), (foot, 0.0016), (0.006, 0.008), (0.0038, 0.03), (0.0038, cup - 0.01)]
    n, (drink, share) = len(outer), wet
    up = 0.2 + 0.35 * (outer[:, 1] - cup) / (h - cup)
    body = lathe([*stem, *outer, *inner, (0, cup + 0.003)], 28,
                 v=[*np.linspace(0, 0.18, 6), *up, *np.linspace(0.56, 0.99, n), 1])  # fmt: skip
    shown = surfaces.stack((clear, 0.2), (surfaces.plain(drink), 0.35 * share),
                             (clear, 0.8 - 0.35 * share), side=128)  # fmt: skip
    level = cup + 0.004 + share * (h - cup)
    below = [
        (max(float(r) - 0.003, 0.0012), float(z) + 0.004) for r, z in outer if z + 0.004 < level
    ]
    top = max(float(np.interp(level, outer[:, 1] + 0.004, outer[:, 0])) - 0.003, 0.002)
    fill = lathe([(0, below[0][1]), *below, (top, level), (0, level)], 24)
    wedges = ring_parts([(low, cup), *side[len(side) // 2 : -1][:2], (rim, h)],
                        [(rim - 0.0022, h), (max(low - 0.002, 0.002), cup + 0.003)])  # fmt: skip
    return [(body, shown), (fill, surfaces.plain(drink))], [
        *wedges, cylinder_part(foot, 0.004), cylinder_part(0.0042, cup, (0, 0, 0.002)),
    ]  # fmt: skip


@category("cocktail_glass", size=(0.104, 0.104, 0.165), mass=0.2, material="glass", hollow=True,
          aliases=("martini glass", "margarita glass", "cocktail", "martini", "margarita",
          "coupe glass", "coupe"), themes=("dining",), roles=("round", "tall"),
          colors=("clear",))  # fmt: skip
def cocktail_glass(look: Look) -> Shape:
    """A martini glass or a coupe with a drink and an olive, a cherry or a slice of lime."""
    r, h = look.between(0.046, 0.056), look.between(0.15, 0.18)
    color = look.color("clear", "clear", "sky", "pink", "mint", "amber")
    drink = look.pick([(220, 226, 200), (230, 110, 130), (240, 160, 60), (90, 180, 200),
                       (130, 190, 90), (200, 40, 50)])  # fmt: skip
    cup = 0.55 * h
    if look.chance(0.7):
        side = [(0.005, cup), (0.35 * r, cup + 0.33 * (h - cup)), (0.7 * r, cup + 0.68 * (h - cup)),
                (r, h)]  # fmt: skip
    else:
        t = np.linspace(0, 1, 6)
        side = [(max(r * float(np.sin(np.pi / 2 * min(1.3 * u, 1))), 0.005),
                 cup + (0.3 + 0.1 * u) * 0 + u**1.6 * 0.8 * (h - cup)) for u in t]  # fmt: skip
        side.append((1.02 * r, h))
    pieces, parts = _stem_profile(
        side, 0.72 * r, (drink, 0.72), surfaces.plain(tint_color(color, 1.2))
    )
    kind, z = look.pick(["olive", "cherry", "lime", "none"]), h - 0.012
    stick = tube([(-0.02, 0, z - 0.01), (0.9 * r, 0.01, h + 0.012)], 0.0012, 6)
    if kind in ("olive", "cherry"):
        ball = ellipsoid(0.017, 0.017, 0.02, 14, 8).move(-0.004, 0, z)
        tone = (120, 140, 50) if kind == "olive" else (180, 20, 36)
        pieces += [(ball, surfaces.plain(tone)), (stick, surfaces.plain((220, 190, 130)))]
    elif kind == "lime":
        wheel = cylinder(0.02, 0.004, 20).turn(0, np.pi / 2).move(0.93 * r, 0, h)
        pieces.append((wheel, surfaces.plain((140, 190, 60))))
    return shape(pieces, parts, opacity=0.6)


@category("champagne_flute", size=(0.064, 0.064, 0.22), mass=0.16, material="glass", hollow=True,
          aliases=("champagne glass", "flute glass", "prosecco glass", "glass of champagne",
          "sparkling wine glass", "mimosa", "bellini"), themes=("dining",), roles=("round", "tall"),
          colors=("clear",))  # fmt: skip
def champagne_flute(look: Look) -> Shape:
    """A tall, slim champagne flute, often with sparkling wine."""
    r, h = look.between(0.024, 0.029), look.between(0.2, 0.24)
    color = look.color("clear", "clear", "sky", "pink", "amber", "mint")
    cup = look.between(0.36, 0.42) * h
    t = np.linspace(0, 1, 7)
    bulge = look.pick([0.0, 0.14])
    side = [(float(0.006 + (r - 0.006) * (np.sin(np.pi / 2 * min(1.5 * u, 1)) + bulge
                                         * np.sin(np.pi * u))), float(cup + (h - cup) * u))
            for u in t]  # fmt: skip
    wine = look.pick([(238, 208, 120), (244, 176, 160), (238, 214, 140)])
    pieces, parts = _stem_profile(side, 1.15 * r, (wine, look.between(0.4, 0.85)),
                             surfaces.plain(tint_color(color, 1.2)))  # fmt: skip
    return shape(pieces, parts, opacity=0.55)


@category("beer_mug", size=(0.14, 0.096, 0.155), mass=0.9, material="glass", hollow=True,
          aliases=("beer stein", "tankard", "stein", "glass of beer", "mug of beer",
          "beer tankard"), themes=("dining",), roles=("round", "tall"),
          colors=("amber",))  # fmt: skip
def beer_mug(look: Look) -> Shape:
    """A heavy glass mug of beer with a head of foam, or a stoneware stein."""
    r, h = look.between(0.042, 0.05), look.between(0.13, 0.165)
    color = look.color("amber", "gold", "amber", "brown", "mustard")
    stein = look.chance(0.2)
    body, parts = open_vessel([(1.02 * r, 0), (r, 0.1 * h), (0.98 * r, 0.6 * h), (r, h)], 0.005,
                              0.012, 14 if not stein else 28)  # fmt: skip
    ear = tube(smooth([(0.95 * r, 0, 0.86 * h), (r + 0.04, 0, 0.84 * h), (r + 0.042, 0, 0.3 * h),
                       (0.97 * r, 0, 0.2 * h)], 5), 0.008, 10)  # fmt: skip
    lug = box_part(0.03, 0.016, 0.6 * h, (r + 0.028, 0, 0.22 * h))
    if stein:
        grey = look.surface(tint_color(color, 1.2), "stoneware")
        other = prints.canvas(128, 64, tint_color(color, 1.2))
        prints.fill(other, 0, 0.1, 1, 0.08, (40, 60, 120))
        prints.fill(other, 0, 0.8, 1, 0.08, (40, 60, 120))
        prints.disc(other, 0.5, 0.5, 0.24, (40, 60, 120))
        skin = surfaces.stack((other, 50), (grey, 50), side=128)
        return shape([(body, skin), (ear, grey)], [*parts, lug])
    clear = surfaces.plain((214, 226, 230))
    foam = surfaces.spots(look.rng, (250, 244, 226), (232, 220, 190), 0.08)
    beer = surfaces.stack((clear, 0.03), (surfaces.plain(color), 0.37), (clear, 0.6), side=128)
    tall = look.between(1.05, 1.12) * h
    head = lathe([(0, 0.76 * h), (0.84 * r, 0.76 * h), (0.86 * r, h), (0.6 * r, 0.98 * tall),
                  (0, tall)], 24)  # fmt: skip
    return shape([(body, beer), (ear, clear), (head, foam)],
                 [*parts, lug, hull_of(head)], opacity=0.75)  # fmt: skip


@category("shot_glass", size=(0.046, 0.046, 0.058), mass=0.09, material="glass", hollow=True,
          aliases=("tequila glass", "vodka glass", "schnapps glass", "shot of tequila",
          "tequila shot", "shot of vodka"), themes=("dining",), roles=("round", "container"),
          colors=("clear",))  # fmt: skip
def shot_glass(look: Look) -> Shape:
    """A small thick glass for spirits."""
    r, h = look.between(0.021, 0.025), look.between(0.05, 0.066)
    color = look.color("clear", "clear", "clear", "sky", "amber", "green", "red")
    body, parts = open_vessel([(0.76 * r, 0), (0.84 * r, 0.35 * h), (0.92 * r, 0.7 * h), (r, h)],
                              0.0025, 0.011, look.pick([24, 24, 8]))  # fmt: skip
    clear = surfaces.plain(tint_color(color, 1.15))
    pieces: Pieces = [(body, clear)]
    if look.chance(0.6):
        drink = look.pick([(214, 140, 50), (236, 240, 240), (120, 40, 30), (90, 160, 90)])
        wet, top = surfaces.plain(drink), 0.78 * h
        pieces = [(body, surfaces.stack((clear, 0.06), (wet, 0.31), (clear, 0.63), side=128))]
        pieces.append((lathe([(0, 0.0115), (0.6 * r, 0.0115), (0.78 * r, top), (0, top)], 18),
                       wet))  # fmt: skip
    return shape(pieces, parts, opacity=0.6)


def _open_glass(look: Look, side: list[tuple[float, float]], wall: float, bottom: float,
                sides: int = 32) -> Shape:  # fmt: skip
    color = look.color("clear", "clear", "clear", "sky", "amber")
    clear = surfaces.plain(tint_color(color, 1.15))
    drink = look.pick([(222, 150, 50), (214, 146, 40), (196, 222, 234), (196, 222, 234)])
    full = look.chance(0.5)
    body, parts = open_vessel(side, wall, bottom, sides)
    h = side[-1][1]
    level = 0.62 * h
    at = float(np.interp(level, [z for _, z in side], [r for r, _ in side])) - wall + 0.0004
    said = contents(look, at, level)
    pieces = [(body, clear)]
    if said is not None:
        pieces += said
    elif full:
        low = side[0][0] - wall
        fill = lathe([(0, bottom), (low, bottom), (at, level), (0, level)], 26)
        pieces.append((fill, surfaces.plain(drink)))
    return shape(pieces, parts, opacity=0.7)


@category("pint_glass", size=(0.0897, 0.0897, 0.152), mass=0.35, material="glass", hollow=True,
          aliases=("pint", "beer glass", "pint of beer", "highball glass", "long drink glass"),
          themes=("dining",), roles=("container", "round", "tall"), colors=("clear",))  # fmt: skip
def pint_glass(look: Look) -> Shape:
    """A tall glass that widens towards its rim, with or without beer."""
    r, h = look.between(0.041, 0.046), look.between(0.145, 0.165)
    side = [(0.7 * r, 0), (0.78 * r, 0.3 * h), (0.9 * r, 0.7 * h), (r, h)]
    return _open_glass(look, side, 0.003, 0.01)


@category("whiskey_glass", size=(0.0813, 0.0834, 0.0872), mass=0.3, material="glass", hollow=True,
          aliases=("whisky glass", "tumbler", "whisky tumbler", "rocks glass",
          "old fashioned glass", "whiskey tumbler", "glass of whiskey", "glass of whisky"),
          themes=("dining",), roles=("container", "round"), colors=("clear",))  # fmt: skip
def whiskey_glass(look: Look) -> Shape:
    """A low, heavy tumbler with a thick bottom, round or faceted."""
    r, h = look.between(0.039, 0.045), look.between(0.08, 0.095)
    side = [(0.88 * r, 0), (0.93 * r, 0.3 * h), (0.97 * r, 0.7 * h), (r, h)]
    return _open_glass(look, side, 0.004, 0.016, look.pick([10, 12, 32]))


@category("plastic_cup", size=(0.0888, 0.0888, 0.103), mass=0.012, material="plastic", hollow=True,
          aliases=("disposable plastic cup", "solo cup", "party cup"), themes=("dining",),
          roles=("container", "round", "tall"), colors=("red",))  # fmt: skip
def plastic_cup(look: Look) -> Shape:
    """A disposable cup with a rolled rim and grooves."""
    r, h = look.between(0.04, 0.047), look.between(0.095, 0.12)
    color = look.color("red", "red", "white", "blue", "clear", "yellow", "green", "orange")
    skin = look.surface(color, "plastic")
    side = [(0.7 * r, 0), (0.78 * r, 0.35 * h), (0.86 * r, 0.65 * h), (0.96 * r, h)]
    body, parts = open_vessel(side, 0.0016, 0.003, 32)
    rings = [torus(k * r, 0.0012, 32, 6).move(z=z * h) for k, z in ((0.755, 0.25), (0.8, 0.42),
             (0.845, 0.6))]  # fmt: skip
    rim = torus(0.965 * r, 0.0022, 36, 8).move(z=h - 0.002)
    inside = surfaces.plain((246, 246, 244)) if look.chance(0.7) else skin
    return shape([(body, surfaces.stack((skin, 50), (inside, 50))), (join([*rings, rim]), skin)],
                 parts)  # fmt: skip


@category("sake_cup", size=(0.0519, 0.0519, 0.0405), mass=0.06, material="ceramic", hollow=True,
          aliases=("ochoko", "sake glass", "yunomi", "green tea cup", "japanese tea cup", "finjan",
          "arabic coffee cup"), themes=("dining", "tea"), roles=("container", "round"),
          colors=("white", "navy"))  # fmt: skip
def sake_cup(look: Look) -> Shape:
    """A tiny cup without a handle, for sake or green tea."""
    r, h = look.between(0.024, 0.03), look.between(0.034, 0.046)
    color = look.color("white", "navy", "black", "sage", "sky", "terracotta", "cream")
    plain = look.surface(color, "ceramic")
    body, parts = open_vessel([(0.62 * r, 0), (0.8 * r, 0.25 * h), (0.95 * r, 0.65 * h), (r, h)],
                              0.0026, 0.004)  # fmt: skip
    return shape([(body, surfaces.stack((glaze_tile(look, color), 50), (plain, 50), side=160))],
                 parts)  # fmt: skip


@category("glass", size=(0.074, 0.074, 0.12), mass=0.24, material="glass", hollow=True,
          aliases=("drinking glass", "water glass", "glass of water"), themes=("dining", "kitchen"),
          roles=("container", "round", "tall"), colors=("clear",), common=True)  # fmt: skip
def glass(look: Look) -> Shape:
    """A tapered, straight, waisted or faceted drinking glass, sometimes with a drink in it."""
    r, h, wall = look.between(0.034, 0.042), look.between(0.095, 0.15), 0.0028
    kind = look.pick(["taper", "taper", "straight", "tulip", "faceted"])
    low = r * {"taper": look.between(0.7, 0.9), "tulip": 0.75}.get(kind, 0.98)
    color = look.color("clear", "clear", "clear", "sky", "mint", "amber", "pink", "green")
    t = np.linspace(0, 1, 6)
    swell = low + (r - low) * (t if kind != "tulip" else np.sin(np.pi * (0.05 + 0.62 * t)))
    outer = np.column_stack([swell, h * t])
    inner = np.column_stack([swell - wall, 0.009 + (h - 0.009) * t])[::-1]
    body = lathe([(0, 0), *outer, *inner, (0, 0.009)], 9 if kind == "faceted" else 32,
                 v=[0, *np.linspace(0.01, 0.95, 6), *np.linspace(0.96, 0.99, 6), 1])  # fmt: skip
    clear, hue = tint_color(color, 1.2), look.pick([(214, 120, 30), (150, 40, 40), (230, 200, 90)])
    tile = surfaces.plain(clear)
    if look.chance(0.4):  # the drink is visible through the wall and from above
        level = look.between(0.45, 0.85)
        wet = surfaces.plain(look.pick([hue, hue, (204, 220, 226)]))
        tile = surfaces.stack((wet, 0.94 * level), (tile, 1.02 - 0.94 * level), (wet, 0.04))
    if drink := drink_color(look):
        wet = surfaces.plain(drink)
        tile = surfaces.stack((wet, 0.62), (surfaces.plain(clear), 0.34), (wet, 0.04))
    elif look.attributes.get("state") == "empty":
        tile = surfaces.plain(clear)
    top = float(outer[-1, 0]) * (np.cos(np.pi / 9) if kind == "faceted" else 1.0)
    foot = low * (np.cos(np.pi / 9) if kind == "faceted" else 1.0)
    middle = (float(outer[3, 0]) * top / float(outer[-1, 0]), float(outer[3, 1]))
    return shape([(body, tile)], [*ring_parts([(foot, 0), middle, (top, h)],
                                              [(top - wall, h), (foot - wall, 0.009)]),
                                  cylinder_part(foot, 0.009)], opacity=0.45)  # fmt: skip


@category("wine_glass", size=(0.078, 0.078, 0.2), mass=0.15, material="glass", hollow=True,
          aliases=("goblet", "wineglass"), themes=("dining",), roles=("round", "tall"),
          colors=("clear",), common=True)  # fmt: skip
def wine_glass(look: Look) -> Shape:
    """A stemmed wine glass (a tulip, balloon, flute or coupe), sometimes with wine."""
    r, h, wall = look.between(0.034, 0.044), look.between(0.175, 0.22), 0.0022
    kind = look.pick(["tulip", "tulip", "balloon", "flute", "cone"])
    r = {"flute": 0.84 * r, "balloon": 1.05 * r}.get(kind, r)
    cup = {"flute": 0.38, "balloon": 0.45, "cone": 0.6}.get(kind, look.between(0.42, 0.5)) * h
    foot = 0.9 * r if kind != "flute" else 1.05 * r
    t = np.linspace(0, 1, 8)
    swell = {"tulip": np.sin(0.2 + 2.05 * t), "balloon": np.sin(0.2 + 2.25 * t),
             "flute": np.sin(0.3 + 1.6 * t) ** 0.7, "cone": 0.12 + 0.88 * t}[kind]  # fmt: skip
    outer = np.column_stack([r * swell, cup + (h - cup) * t])
    outer[0, 0] = 0.006
    inner = np.column_stack([np.maximum(outer[:, 0] - wall, 0.001), outer[:, 1] + 0.004])[::-1]
    inner[0, 1] = h
    stem = [(0, 0), (foot, 0), (foot, 0.0015), (0.006, 0.008), (0.0042, 0.03), (0.0042, cup - 0.02)]
    up, down = np.linspace(0.3, 0.8, 8), np.linspace(0.82, 0.99, 8)
    body = lathe(
        [*stem, *outer, *inner, (0, cup + 0.004)], 28, v=[*np.linspace(0, 0.28, 6), *up, *down, 1]
    )
    color = look.color("clear", "clear", "clear", "sky", "pink", "amber", "green")
    clear = surfaces.plain(tint_color(color, 1.2))
    wine = surfaces.plain(look.pick([(110, 16, 34), (226, 200, 110), (230, 150, 140)]))
    level = look.between(0.12, 0.3) if look.chance(0.5) else 0.0
    tile = clear
    if level:
        tile = surfaces.stack((clear, 0.3), (wine, level), (clear, 0.66 - level), (wine, 0.04))
    rim = float(outer[-1, 0])
    wedges = ring_parts([(0.006, cup), tuple(outer[3]), tuple(outer[5]), (rim, h)],
                        [(rim - wall, h), (0.003, cup + 0.004)])  # fmt: skip
    return shape(
        [(body, tile)],
        [*wedges, cylinder_part(foot, 0.004), cylinder_part(0.0042, cup, (0, 0, 0.002))],
        opacity=0.45,
    )


@category("brandy_snifter", size=(0.0877, 0.0877, 0.125), mass=0.18, material="glass", hollow=True,
          aliases=("snifter", "cognac glass", "brandy glass", "balloon glass", "glass of brandy",
          "glass of cognac"), themes=("dining",), roles=("round",), colors=("clear",))  # fmt: skip
def brandy_snifter(look: Look) -> Shape:
    """A brandy snifter with a wide bowl on a short stem, empty or with brandy."""
    k, color = look.between(0.9, 1.08), look.color("clear", "clear", "amber", "sky")
    side = [(0.034 * k, 0), (0.034 * k, 0.004), (0.005 * k, 0.012 * k), (0.0055 * k, 0.03 * k),
            (0.026 * k, 0.04 * k), (0.044 * k, 0.07 * k), (0.042 * k, 0.095 * k),
            (0.031 * k, 0.125 * k)]  # fmt: skip
    inner = [(0.0295 * k, 0.125 * k), (0.0405 * k, 0.095 * k), (0.0425 * k, 0.07 * k),
             (0.024 * k, 0.043 * k), (0, 0.04 * k)]  # fmt: skip
    body = lathe([(0, 0), *side, *inner], 32)
    drink = lathe(
        [(0, 0.041 * k), (0.024 * k, 0.044 * k), (0.0415 * k, 0.068 * k), (0, 0.069 * k)], 28
    )
    state = look.attributes.get("state", "")
    pieces = [(body, surfaces.plain(tint_color(color, 1.2)))]
    if state != "empty":
        pieces.append((drink, surfaces.plain((176, 92, 30))))
    return shape(pieces, [hull_of(lathe([(0, 0), side[0], side[1], (0, 0.004)], 16)),
                          hull_of(lathe([(0, 0.004), side[2], side[3], (0, 0.03 * k)], 10)),
                          hull_of(lathe([(0, 0.03 * k), *side[4:], (0, 0.125 * k)], 20))],
                 0.55)  # fmt: skip
