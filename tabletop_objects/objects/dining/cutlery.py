"""Objects of the ``dining`` theme: cutlery."""

from __future__ import annotations

import itertools

import numpy as np

from ...kit import surfaces
from ...kit.outlines import ellipse, rectangle
from ...kit.parts import cylinder_part, hull_above, hull_of, hull_part
from ...kit.primitives import limb
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, prism, refine, sweep, tube
from ...kit.surfaces import Look, Tile, tint_color
from ...values import ConvexPart


@category("chopsticks", size=(0.224, 0.0273, 0.00755), mass=0.018, material="wood",
          aliases=("pair of chopsticks", "chopstick", "chop sticks"), themes=("dining",),
          roles=("flat",), colors=("wooden", "black"), state="lying flat")  # fmt: skip
def chopsticks(look: Look) -> Shape:
    """A pair of chopsticks lying side by side with their thin ends on the left."""
    long, gap = look.between(0.21, 0.25), look.between(0.012, 0.02)
    color = look.color("wooden", "brown", "black", "red", "tan", "maroon", "white")
    wood = look.surface(color, "wood")
    band = surfaces.plain(look.own_color("gold", "red", "white", "black", "teal"))
    tile = surfaces.stack((wood, 74), (band, 4), (wood, 4), (band, 2), (wood, 16), side=128)
    sticks = []
    for s in (-1, 1):
        stick = loft(np.stack([np.column_stack([rectangle(w, w, 0.25 * w, 1), np.full(8, z)])
                               for w, z in ((0.0036, 0), (0.0052, 0.4 * long), (0.0075, long))]),
                     rectangle(1, 1, 0.25, 1))  # fmt: skip
        stick = stick.turn(1, np.pi / 2 + np.arctan2(0.002, long)).move(x=-long / 2)
        stick = stick.turn(2, s * look.between(0.0, 0.02))
        low = stick.bounds[0, 2]
        sticks.append(stick.move(y=s * gap / 2, z=-low))
    return shape([(s, tile) for s in sticks], [hull_of(s) for s in sticks])


GRIPS = ("black", "wooden", "charcoal", "brown", "white", "red", "teal")
Outline = list[tuple[float, float]]


def _knife(look: Look, long: float, wide: float, share: float, outline: Outline, *,
           metal: float = 0.2, teeth: int = 0, thick: float = 0.016) -> Shape:  # fmt: skip
    """Return a knife with its blade on the left.

    ``outline`` runs from the blade's tip along its edge and back along its spine, in fractions of
    the blade's length (from the tip) and of ``wide`` (negative below the centre line).
    """
    steel = look.surface(look.own_color("silver", "silver", "gray"), "metal")
    all_metal = look.chance(metal)
    color = look.color("silver", "gold") if all_metal else look.color(*GRIPS)
    tile = look.surface(color, "metal" if all_metal else look.pick(["plastic", "wood"]))
    tip, cut = -0.5 * long, -0.5 * long + share * long
    points = [(tip + u * share * long, v * wide) for u, v in outline]
    if teeth:
        low = [p for p in points if p[1] < 0]
        start, end = low[0][0], low[-1][0]
        saw = [(start + (end - start) * n / (2 * teeth), low[-1][1] + (0.05 * wide if n % 2 else 0))
               for n in range(2 * teeth + 1)]  # fmt: skip
        points = [p for p in points if p not in low[:-1]][:1] + saw + [
            p for p in points if p[1] >= 0][1 if points[0][1] >= 0 else 0 :]  # fmt: skip
    blade = prism(np.array(points), 0.0005, 0.0025)
    width = min(0.62 * wide, 0.026) if wide > 0.024 else 0.8 * wide
    grip = block(0.5 * long - cut, max(width, 0.012), thick, 0.4 * width, 0.22 * thick)
    grip = grip.move(x=cut + (0.5 * long - cut) / 2)
    pieces = [(blade, steel), (grip, tile)]
    if not all_metal:
        rivets = [cylinder(0.0026, thick + 0.0005, 10).move(x=cut + u * (0.5 * long - cut))
                  for u in (0.25, 0.5, 0.75)]  # fmt: skip
        pieces.append((join(rivets), surfaces.plain((206, 200, 184))))
    return settle(pieces, 0.02, hulls=[[0], [1]])


@category("steak_knife", size=(0.226, 0.02, 0.0132), mass=0.07, material="metal",
          themes=("dining",), roles=("flat",), colors=("black", "wooden"),
          state="lying flat")  # fmt: skip
def steak_knife(look: Look) -> Shape:
    """A slim, pointed steak knife with a handle of wood or plastic."""
    outline = [(0, 0.45), (0.15, -0.1), (0.35, -0.45), (1, -0.5), (1, 0.4), (0.4, 0.5)]
    return _knife(look, look.between(0.21, 0.235), 0.02, 0.52, outline, metal=0.1, thick=0.013)


@category("butter_knife", size=(0.165, 0.024, 0.0079), mass=0.05, material="metal",
          aliases=("butter spreader", "spreader", "cheese spreader"),
          themes=("dining", "breakfast"), roles=("flat",), colors=("silver",),
          state="lying flat")  # fmt: skip
def butter_knife(look: Look) -> Shape:
    """A short, blunt butter knife with a broad, rounded blade."""
    outline = [(0, 0.1), (0.03, -0.3), (0.14, -0.5), (0.6, -0.45), (1, -0.2), (1, 0.2), (0.7, 0.3),
               (0.3, 0.5), (0.06, 0.42)]  # fmt: skip
    return _knife(look, look.between(0.15, 0.18), 0.024, 0.48, outline, metal=0.8, thick=0.008)


@category("cake_server", size=(0.255, 0.062, 0.015), mass=0.09, material="metal",
          aliases=("pie server", "cake slicer", "cake lifter", "pie slice server", "pizza server",
          "cake spatula"), themes=("dining",), roles=("flat",), colors=("silver", "gold"),
          state="lying flat")  # fmt: skip
def cake_server(look: Look) -> Shape:
    """A triangular cake server with its blade on the left and its handle raised."""
    long, wide = look.between(0.23, 0.27), look.between(0.055, 0.068)
    color = look.color("silver", "gold", "silver", "copper")
    steel = look.surface(color, "metal")
    cut = -0.04 * long
    plate = prism(np.array([(-0.5 * long, -0.004), (cut, -wide / 2), (cut + 0.012, -0.3 * wide),
                            (cut + 0.012, 0.3 * wide), (cut, wide / 2), (-0.5 * long, 0.004)]), 0,
                  0.002)  # fmt: skip
    neck = tube([(cut, 0, 0.002), (cut + 0.022, 0, 0.009), (cut + 0.05, 0, 0.011)], 0.004, 8)
    x = 0.5 * long - cut - 0.04
    grip = block(x, 0.018, 0.011, 0.008, 0.003).turn(1, 0.04).move(cut + 0.04 + x / 2, 0, 0.0055)
    sleeve = steel if look.chance(0.4) else look.surface(
        look.own_color("white", "black", "wooden", "sky"), "wood")  # fmt: skip
    end = min(float(grip.bounds[0, 2]), 0.0055)
    grip = grip.move(z=-end + 0.0002).turn(1, 0.0)
    return shape([(plate, steel), (neck, steel), (grip, sleeve)],
                 [hull_of(plate), hull_of(grip)])  # fmt: skip


@category("cheese_knife", size=(0.217, 0.0306, 0.013), mass=0.07, material="metal",
          aliases=("cheese cutter",), themes=("dining",), roles=("flat",), colors=("silver",),
          state="lying flat")  # fmt: skip
def cheese_knife(look: Look) -> Shape:
    """A cheese knife with a forked tip and holes in its blade."""
    outline = [(0, 0.5), (0.1, 0.2), (0.02, 0.0), (0.16, -0.3), (0.4, -0.5), (1, -0.4), (1, 0.35),
               (0.4, 0.3), (0.12, 0.52)]  # fmt: skip
    long = look.between(0.2, 0.235)
    made = _knife(look, long, 0.03, 0.55, outline, metal=0.3, thick=0.013)
    hole = cylinder(0.0045, 0.0024, 14)
    holes = [hole.scale(1.4, 1, 1).move((-0.5 + u) * long, -0.001, 0.0005) for u in (0.2, 0.3, 0.4)]
    return shape([*((p.solid, p.tile) for p in made.pieces),
                  (join(holes), surfaces.plain(tint_color((120, 116, 110), 0.9)))],
                 made.parts)  # fmt: skip


@category("plastic_fork", size=(0.171, 0.0267, 0.0049), mass=0.005, material="plastic",
          aliases=("disposable fork", "plastic cutlery"), themes=("dining",), roles=("flat",),
          colors=("white",), state="lying flat")  # fmt: skip
def plastic_fork(look: Look) -> Shape:
    """A disposable fork of white or coloured plastic, or of wood, lying flat."""
    long = look.between(0.155, 0.18)
    color = look.color("white", "white", "black", "clear", "red", "green", "tan")
    skin = look.surface(color, "plastic")
    palm = prism(np.array([(-0.34, -0.072), (-0.2, -0.078), (-0.1, -0.022), (0.0, -0.02), (0.5,
                  -0.045), (0.5, 0.045), (0, 0.02), (-0.1, 0.022), (-0.2, 0.078), (-0.34, 0.072)])
                 * long, 0.001, 0.0034)  # fmt: skip
    tines = [tube([(-0.33 * long, y * long, 0.0024), (-0.42 * long, y * long, 0.0016),
                   (-0.5 * long, y * long, 0.004)], [0.0016, 0.0014, 0.0006], 6)
             for y in (-0.06, -0.02, 0.02, 0.06)]  # fmt: skip
    rib = box(0.5 * long, 0.0022, 0.005).move(x=0.24 * long)
    return settle([(join([palm, *tines, rib]), skin)], 0.02)


def hollow(x: float, reach: float, wide: float, deep: float, wall: float) -> Solid:
    """Return the oval bowl of a spoon at ``x``, with its rim at height ``deep``."""
    ring = ellipse(2, 2, 24) * [reach, wide]
    levels = [(0.25, 0), (0.7, 0.25 * deep), (0.94, 0.7 * deep), (1.0, deep),
              (0.9, deep), (0.82, 0.7 * deep + 0.3 * wall), (0.55, 0.25 * deep + wall),
              (0.15, wall)]  # fmt: skip
    rings = np.stack([np.column_stack([ring * k + [x, 0], np.full(24, z)]) for k, z in levels])
    return loft(rings, ring, profile=np.array([(k * reach, z) for k, z in levels]))


def _spoon(look: Look, long: float, reach: float, wide: float, deep: float,
           tile: surfaces.Tile, *, thick: float = 0.004, slots: bool = False) -> Shape:  # fmt: skip
    """Return a spoon with its bowl on the left, resting on the bowl and the end of its handle."""
    middle = -0.5 * long + reach
    head = hollow(middle, reach, wide, deep, 0.3 * deep)
    grip = sweep(
        [(middle + 0.9 * reach, 0, deep - 0.4 * thick), (middle + 1.5 * reach, 0, deep + thick),
         (0.25 * long, 0, 0.55 * deep + 1.2 * thick), (0.5 * long, 0, 0.6 * thick)],
        rectangle(2.6 * thick, 1.2 * thick, 0.5 * thick, 3), [0.9, 0.8, 1.1, 1.2],
    )  # fmt: skip
    pieces = [(head, tile), (grip, tile)]
    if slots:
        dark = surfaces.plain((60, 58, 56))
        bars = [block(0.9 * reach, 0.1 * wide, 0.0012, 0.04 * wide).move(middle, s * 0.3 * wide,
                0.3 * deep + 0.0012 * abs(s)) for s in (-1, 0, 1)]  # fmt: skip
        pieces.append((join(bars), dark))
    v = np.maximum(grip.vertices, (-1, -1, 0))
    return shape(pieces, [hull_of(head), hull_part(v[v[:, 0] < 0.26 * long]),
                          hull_part(v[v[:, 0] > 0.24 * long])])  # fmt: skip


@category("serving_spoon", size=(0.251, 0.048, 0.0167), mass=0.09, material="metal",
          aliases=("tablespoon", "salad spoon"), themes=("dining",), roles=("flat",),
          colors=("silver",), state="lying flat")  # fmt: skip
def serving_spoon(look: Look) -> Shape:
    """A large spoon for serving."""
    tile = look.surface(look.color("silver", "silver", "gold", "copper", "black"), "metal")
    return _spoon(look, look.between(0.22, 0.26), 0.036, 0.024, 0.012, tile, thick=0.0032)


@category("teaspoon", size=(0.122, 0.0282, 0.00768), mass=0.022, material="metal",
          aliases=("coffee spoon", "dessert spoon", "espresso spoon", "tea spoon", "sugar spoon"),
          themes=("dining", "coffee"), roles=("flat",), colors=("silver",),
          state="lying flat")  # fmt: skip
def teaspoon(look: Look) -> Shape:
    """A small spoon: a tablespoon scaled to two thirds of its size."""
    return spoon(look).scale(0.7)


@category("soup_spoon", size=(0.161, 0.0446, 0.0173), mass=0.045, material="metal", assembled=True,
          aliases=("ramen spoon", "chinese spoon", "asian soup spoon"), themes=("dining",),
          roles=("flat",), colors=("silver", "white"), state="lying flat")  # fmt: skip
def soup_spoon(look: Look) -> Shape:
    """A spoon with a round bowl, or a flat-bottomed porcelain spoon."""
    if look.chance(0.6):
        tile = look.surface(look.color("silver", "silver", "gold"), "metal")
        return _spoon(look, look.between(0.165, 0.185), 0.024, 0.0225, 0.009, tile, thick=0.0026)
    tile = look.surface(look.color("white", "red", "black", "sky", "cream"), "ceramic")
    return _spoon(look, look.between(0.13, 0.145), 0.032, 0.022, 0.017, tile, thick=0.0052)


@category("salad_servers", size=(0.274, 0.125, 0.0197), mass=0.12, material="wood",
          aliases=("salad server", "salad tongs", "salad fork and spoon"), themes=("dining",),
          colors=("wooden",), state="lying flat")  # fmt: skip
def salad_servers(look: Look) -> Shape:
    """A salad spoon and a salad fork lying side by side."""
    long = look.between(0.25, 0.29)
    tile = look.surface(look.color("wooden", "brown", "black", "silver", "white"), look.pick(
        ["wood", "plastic"]))  # fmt: skip
    first = _spoon(look, long, 0.04, 0.027, 0.013, tile, thick=0.0045)
    solids = [p.solid.move(y=-0.036) for p in first.pieces]
    tines = [limb([(-0.5 * long, 0.036 + 0.0155 * s, 0.009), (-0.47 * long, 0.036 + 0.0165 * s,
             0.004), (-0.4 * long, 0.036 + 0.015 * s, 0.003)], [0.0035, 0.005, 0.005], 8, 0.8)
             for s in (-1.2, -0.4, 0.4, 1.2)]  # fmt: skip
    palm = prism(ellipse(0.085, 0.053, 22), 0.0005, 0.0075, 0.002).move(-0.33 * long, 0.036)
    grip = first.pieces[1].solid.move(y=0.036)
    low = grip.move(z=-0.004).bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))
    forks = join([*tines, palm, low])
    parts = [hull_of(solids[0]), hull_above(solids[1]), hull_above(palm, *tines), hull_above(low)]
    return shape([(join(solids), tile), (forks, tile)], parts)


def _bend(solid: Solid, length: float, dip: float) -> Solid:
    """Return flat cutlery bent to raise its neck, so that it rests on its two ends."""
    return solid.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] + dip
                                                 * np.clip(np.cos(np.pi * p[:, 0] / length), 0,
                                                           1)]))  # fmt: skip


def _slice(solid: Solid, edges: list[float]) -> list[ConvexPart]:
    x = solid.vertices[:, 0]
    return [hull_part(solid.vertices[(x >= a - 1e-6) & (x <= b + 1e-6)]) for a,
            b in itertools.pairwise(edges)]  # fmt: skip


def _mirror(half: list[tuple[float, float]]) -> np.ndarray:
    """Return a closed, symmetric outline whose lower half is ``half``, from left to right."""
    lower = np.array(half, float)
    upper = lower[::-1] * [1, -1]
    return np.concatenate([lower, upper[np.abs(upper[:, 1]) > 1e-9]])


def _metal(look: Look) -> Tile:
    """Return a bright, brushed, golden, coppery or black metal tile, sometimes scratched."""
    color = look.color(*["silver"] * 5, "gray", "gray", "gold", "black", "copper", spread=6)
    tile = look.surface(color, "metal")
    if look.material:
        return tile
    worn = surfaces.scratches(
        look.rng, color, tint_color(color, 1.25), int(look.rng.integers(4, 26))
    )
    return look.pick([tile, worn])


def _grip_paint(look: Look) -> tuple[str, Tile]:
    """Return the kind of handle, "metal" or "sleeve", and the tile of the sleeve."""
    color = look.own_color("black", "white", "brown", "red", "teal", "sky", "cream")
    sleeve = look.pick([surfaces.wood(look.rng, (150, 98, 60)), surfaces.plain(color),
                        surfaces.speckles(look.rng, color, 5, 32)])  # fmt: skip
    return ("sleeve" if look.chance(0.3) and not look.material else "metal"), sleeve


def _sleeve(long: float, start: float, wide: float) -> Solid:
    """Return the flattened sleeve of a handle from x = ``start`` to the right end."""
    x = 0.5 * long - start
    return block(x, 2 * wide, 0.0052, wide, 0.0012).move(x=start + x / 2)


@category("fork", size=(0.195, 0.023, 0.0104), mass=0.036, material="metal",
          aliases=("salad fork",), themes=("dining", "kitchen"), roles=("flat",),
          colors=("silver", "gold"), state="lying flat", common=True)  # fmt: skip
def fork(look: Look) -> Shape:
    """A fork lying flat with its three or four tines on the left."""
    long, wide = look.between(0.175, 0.21), look.between(0.85, 1.15)
    steel, kind, sleeve = _metal(look), *_grip_paint(look)
    end = look.between(0.005, 0.0105)
    grip = [
        (-0.046, 0.0), (-0.044, -0.007 * wide), (-0.03, -0.0112 * wide), (-0.02, -0.0035),
        (0.02, -0.0028), (0.5 * long - 0.012, -end), (0.5 * long - 0.003, -0.8 * end),
        (0.5 * long, -0.4 * end),
    ]  # fmt: skip
    body = prism(_mirror([(x, y) for x, y in grip if y < 0 or x < -0.045]), 0, 0.0024)
    count = look.pick([3, 4, 4])
    pitch = 0.0174 * wide / (count - 1)
    half = 0.0019 * (1.3 if count == 3 else 1.0)
    tine = prism(np.array([(-0.5 * long, -0.0009), (-0.03, -half), (-0.03, half),
                           (-0.5 * long, 0.0009)]), 0, 0.0022)  # fmt: skip
    tines = [tine.move(y=(k - (count - 1) / 2) * pitch) for k in range(count)]
    fine = _bend(refine(join([body, *tines])), long, 0.008)
    pieces = [(fine, steel)]
    if kind == "sleeve":
        pieces.append((_bend(refine(_sleeve(long, 0.018, max(end, 0.006))), long, 0.008), sleeve))
    return shape(pieces, _slice(fine, [-0.5 * long, -0.04, 0.0, 0.5 * long]))


def spoon(look: Look) -> Shape:
    """A spoon lying flat with its bowl on the left: round, oval or pointed."""
    long = look.between(0.155, 0.2)
    steel, kind, sleeve = _metal(look), *_grip_paint(look)
    reach, wide = look.between(0.026, 0.034), look.between(0.0175, 0.023)
    end, pointed = look.between(0.005, 0.0095), look.between(-0.15, 0.25)
    middle = -0.5 * long + reach
    ring = ellipse(2, 2, 24)
    ring = np.column_stack([ring[:, 0], ring[:, 1] * (1 + pointed * ring[:, 0])]) * [reach, wide]
    levels = [(0.12, 0.0003), (0.62, 0.0014), (1.0, 0.0072), (0.9, 0.0072), (0.55, 0.003),
              (0.12, 0.0018)]  # fmt: skip
    head = loft(
        np.stack([np.column_stack([ring * k + [middle, 0], np.full(24, z)]) for k, z in levels]),
        ring, profile=np.array([(k * reach, z) for k, z in levels]),
    )  # fmt: skip
    neck = middle + 0.93 * reach
    grip = prism(
        _mirror([(neck, -0.0055), (neck + 0.012, -0.0036), (0.0, -0.0026),
                   (0.5 * long - 0.02, -end), (0.5 * long - 0.004, -0.8 * end),
                   (0.5 * long, -0.35 * end)]), 0, 0.0022,
    )  # fmt: skip

    def lift_neck(solid: Solid) -> Solid:
        def raise_neck(p: np.ndarray) -> np.ndarray:
            t = np.clip((p[:, 0] - neck) / (0.5 * long - neck), 0, 1)
            rise = 0.0055 * np.cos(np.pi / 2 * t) ** 0.8 + 0.004 * np.sin(np.pi * t)
            return np.column_stack([p[:, :2], p[:, 2] + rise])

        return refine(refine(solid)).bend(raise_neck)

    lift, hollow = lift_neck(grip), surfaces.plain(tuple(0.62 * c for c in steel.mean((0, 1))))
    pieces = [(head, surfaces.stack((steel, 57), (hollow, 43))),
              (lift, steel)]  # fmt: skip
    if kind == "sleeve":
        pieces.append((lift_neck(_sleeve(long, 0.03, max(end, 0.006))), sleeve))
    x = lift.vertices[:, 0]
    return shape(pieces, [hull_of(head), hull_part(lift.vertices[x <= 0.03]),
                          hull_part(lift.vertices[x >= 0.028])])  # fmt: skip


@category("knife", size=(0.25, 0.028, 0.012), mass=0.09, material="metal",
          aliases=("table knife", "letter opener"), themes=("dining", "kitchen"), roles=("flat",),
          colors=("silver", "black"), state="lying flat", common=True)  # fmt: skip
def knife(look: Look) -> Shape:
    """A table knife lying flat, or a kitchen knife: chef's, santoku, paring, serrated or steak."""
    kind = look.pick(["table", "table", "chef", "santoku", "bread", "steak"])
    long, wide, cut = {"table": (look.between(0.2, 0.23), 0.019, look.between(0.0, 0.03)),
                       "chef": (look.between(0.28, 0.31), 0.04, 0.045),
                       "santoku": (look.between(0.26, 0.29), 0.042, 0.035),
                       "bread": (look.between(0.28, 0.31), 0.028, 0.04),
                       "steak": (look.between(0.2, 0.23), 0.02, 0.005)}[kind]  # fmt: skip
    steel = surfaces.brushed_metal(
        look.rng, look.pick([(196, 199, 204), (176, 179, 184), (90, 92, 98)])
    )
    if look.chance(0.3):
        steel = surfaces.spots(look.rng, (186, 189, 194), (120, 116, 110), 0.03)
    tip = -0.5 * long
    edge = {
        "table": [(0.0, 0.3), (0.06, -0.35), (0.2, -0.5)],
        "chef": [(0.0, 0.42), (0.12, 0.0), (0.3, -0.35), (0.5, -0.5)],
        "santoku": [(0.0, -0.3), (0.03, -0.5), (0.5, -0.5)],
        "bread": [(0.0, -0.1), (0.04, -0.45), (0.3, -0.5)],
        "steak": [(0.0, 0.45), (0.1, -0.1), (0.3, -0.5)],
    }[kind]
    back = {"santoku": [(0.24, 0.5), (0.08, 0.25)], "table": [(0.14, 0.5)]}.get(kind, [(0.1, 0.5)])
    outline = [(tip + u * long, v * wide) for u, v in edge]
    outline += [(cut, -0.5 * wide), (cut, 0.5 * wide)]
    outline += [(tip + u * long, v * wide) for u, v in back]
    blade = prism(np.array(outline), 0.0, 0.002)
    metal = kind == "table" and look.chance(0.7)
    color = look.color("silver", "gray") if metal else look.color(
        "black", "wooden", "red", "charcoal", "brown", "white", "teal", "yellow")  # fmt: skip
    thick = 0.0075 if kind == "table" else 0.016
    grip = block(0.5 * long - cut, 0.8 * min(wide, 0.028), thick, 0.006, 0.002)
    grip = grip.move(x=cut + (0.5 * long - cut) / 2)
    tile = look.surface(color, "metal" if metal else look.pick(["plastic", "wood"]))
    pieces = [(blade, steel), (grip, tile)]
    if not metal and kind != "table":
        rivet = cylinder(0.0028, thick + 0.0004, 10)
        way = 0.5 * long - cut
        pieces += [(rivet.move(x=cut + u * way), surfaces.plain((196, 190, 170)))
                   for u in (0.22, 0.5, 0.78)]  # fmt: skip
    return shape(pieces, [hull_of(blade), hull_of(grip)])


@category("toothpicks", size=(0.04, 0.04, 0.067), mass=0.05, material="wood", assembled=True,
          aliases=("toothpick holder", "box of toothpicks", "cocktail sticks",
          "toothpick dispenser"), themes=("dining",), roles=("round",),
          colors=("white", "wooden"))  # fmt: skip
def toothpicks(look: Look) -> Shape:
    """A round holder with toothpicks standing upright in it."""
    r, h = look.between(0.018, 0.022), look.between(0.04, 0.05)
    color = look.color("white", "red", "wooden", "teal", "silver", "navy", "yellow")
    cup = lathe(
        [(0, 0), (r, 0), (0.95 * r, h), (0.84 * r, h), (0.84 * r, 0.5 * h), (0, 0.5 * h)], 26
    )
    picks = []
    for k in range(20):
        away, turn = 0.62 * r * np.sqrt((k + 0.5) / 20), 2.4 * k
        at = np.array([away * np.cos(turn), away * np.sin(turn)])
        top = (*(1.35 * at), h + 0.02 + look.between(0, 0.003))
        picks.append(tube([(*at, 0.5 * h), top], [0.0011, 0.0004], 5))
    bunch = join(picks)
    return shape([(cup, look.surface(color, "ceramic")),
                  (bunch, surfaces.plain((222, 188, 136)))],
                 [cylinder_part(0.95 * r, h), hull_of(bunch)])  # fmt: skip


CATEGORIES = (
    Category("spoon", spoon, size=(0.18, 0.04, 0.0115), mass=0.04, material="metal",
             themes=("dining", "kitchen", "coffee"), roles=("flat",), colors=("silver", "gold"),
             state="lying flat", common=True),
)  # fmt: skip
"""Objects that share their drawing functions."""
