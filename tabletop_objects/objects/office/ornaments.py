"""Objects of the ``office`` theme: ornaments."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye
from ...kit.outlines import lift, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part
from ...kit.primitives import at_block, ball, planter, rod, standing
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, loft, tube
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color
from ...values import ConvexPart
from ..living.plants import cactus_plant, leaf_blade


@category("picture_frame", size=(0.15, 0.085, 0.155), mass=0.25, material="wood", assembled=True,
          aliases=("photo frame", "frame", "framed photo", "picture", "photo", "photograph", "loom",
          "knitting loom", "weaving loom", "painting", "framed print", "framed painting",
          "oil painting", "framed picture", "digital photo frame", "framed certificate"),
          themes=("office", "living", "vanity"), colors=("wooden", "black"),
          state="standing, leaning back", common=True)  # fmt: skip
def picture_frame(look: Look) -> Shape:
    """A framed picture leaning on its stand, facing the viewer."""
    x, z = look.between(0.11, 0.16), look.between(0.15, 0.2)
    if look.chance(0.35):
        x, z = z, x
    color = look.color("wooden", "black", "white", "gold", "silver", "teal", "brown", "pink")
    rim, t = look.between(0.007, 0.02), look.between(0.01, 0.016)
    frame = look.surface(color, "wood" if look.chance(0.5) else "plastic")
    lean = -np.deg2rad(14)
    bars = [
        box(x, t, rim), box(x, t, rim).move(z=z - rim),
        box(rim, t, z - 2 * rim).move(x=-(x - rim) / 2, z=rim),
        box(rim, t, z - 2 * rim).move(x=(x - rim) / 2, z=rim),
    ]  # fmt: skip
    back = box(x - rim, 0.6 * t, z - rim).move(y=0.15 * t, z=rim / 2)
    mat = box(x - 2 * rim, 0.001, z - 2 * rim).move(y=-0.18 * t, z=rim)
    inner = rim + look.pick([0.001, 0.01, 0.018])
    view = box(x - 2 * inner, 0.001, z - 2 * inner).move(y=-0.22 * t, z=inner)
    art = prints.artwork(look.rng, round(128 * x / max(x, z)), round(128 * z / max(x, z)))
    plain, white = surfaces.plain(tint_color(color, 0.6)), surfaces.plain((246, 244, 238))
    pieces = [(s, frame) for s in bars] + [(back, plain), (mat, white), (view, art)]
    tilted = [(solid.turn(0, lean), tile) for solid, tile in pieces]
    low = min(solid.bounds[0, 2] for solid, _ in tilted)
    tilted = [(solid.move(z=-low), tile) for solid, tile in tilted]
    slope = np.tan(-lean)
    strut = loft(
        np.stack([lift(rectangle(0.03, 0.004) + np.array([0, y]), h)
                  for y, h in [(0.5 * z, 0.0), (0.62 * z * slope + 0.4 * t, 0.62 * z)]]),
        rectangle(0.03, 0.004),
    )  # fmt: skip
    panel = hull_of(*[solid for solid, _ in tilted])
    return shape([*tilted, (strut, plain)], [panel, hull_of(strut)])


@category("globe", size=(0.165, 0.145, 0.215), mass=0.6, material="device", hollow=True,
          aliases=("world globe", "desk globe"), themes=("office", "living"), roles=("tall",),
          colors=("blue",), common=True)  # fmt: skip
def globe(look: Look) -> Shape:
    """A terrestrial globe with a tilted axis, on a base."""
    r = look.between(0.065, 0.08)
    sea: RGB = look.color("blue", "sky", "teal", "tan", "charcoal", "cream", "navy")
    land = surfaces.noise(look.rng, 96, 192, (4, 7), 3)
    land[:, -24:] += (land[:, :1] - land[:, -1:]) * np.linspace(0, 1, 24)
    image = prints.canvas(192, 96, sea)
    lands = [((122, 160, 84), (196, 170, 110)), ((214, 190, 140), (170, 120, 80)),
             ((226, 200, 90), (206, 110, 80)), ((236, 232, 220), (190, 186, 176))]  # fmt: skip
    low, high = look.pick(lands)
    image[land > 0.12] = low
    image[land > 0.5] = high
    image[:7] = image[-7:] = (240, 244, 246)
    image[::16] = (image[::16] * 0.9).astype(np.uint8)
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).turn(1, 0.41).move(z=r + 0.06)
    metal = surfaces.brushed_metal(look.rng, look.own_color("brass", "silver", "brown"))
    bow = tube(
        np.column_stack([np.sin(t := np.linspace(-0.3, 2.9, 20) + 0.41) * 1.12 * r, 0 * t,
                         -np.cos(t) * 1.12 * r + r + 0.06]), 0.0045, 8,
    )  # fmt: skip
    foot = lathe([(0, 0), (0.72 * r, 0), (0.72 * r, 0.008), (0.2 * r, 0.02), (0.1 * r, 0.058),
                  (0, 0.058)], 28)  # fmt: skip
    return shape([(ball, image), (bow, metal), (foot, metal)], [cylinder_part(0.72 * r, 0.009),
                                                                cylinder_part(0.16 * r, 0.05,
                                                                              (0, 0, 0.009)),
                                                                hull_of(ball)])  # fmt: skip


@category("hourglass", size=(0.094, 0.094, 0.14), mass=0.22, material="glass",
          aliases=("sand timer", "sandglass", "sand clock"), themes=("office", "living", "games"),
          roles=("tall", "round"), colors=("brown", "gold"), common=True)  # fmt: skip
def hourglass(look: Look) -> Shape:
    """An hourglass: two bulbs with sand between wooden or metal ends."""
    r, h = look.between(0.03, 0.042), look.between(0.11, 0.17)
    color = look.color("brown", "black", "wooden", "gold", "copper", "white")
    frame = look.surface(color, "oak" if color[0] > color[2] + 30 else "plastic")
    ends = [cylinder(1.3 * r, 0.011, 32, bevel=0.003).move(z=z) for z in (0, h - 0.011)]
    posts = [cylinder(0.0042, h - 0.012, 10).move(1.1 * r * np.cos(a), 1.1 * r * np.sin(a), 0.006)
             for a in 2 * np.pi * np.arange(3) / 3 + np.pi / 2 + 0.45]  # fmt: skip
    low, up, mid = 0.011, h - 0.011, h / 2
    glass = lathe(
        [(0, low), (0.6 * r, low), (0.92 * r, low + 0.12 * h), (0.88 * r, low + 0.22 * h),
         (0.35 * r, mid - 0.05 * h), (0.1 * r, mid), (0.35 * r, mid + 0.05 * h),
         (0.88 * r, up - 0.22 * h), (0.92 * r, up - 0.12 * h), (0.6 * r, up), (0, up)],
        26, v=[0, 0, 0.14, 0.25, 0.44, 0.5, 0.56, 0.75, 0.86, 1, 1],
    )  # fmt: skip
    sand = look.own_color("beige", "coral", "sky", "white", "gold", "black", "pink")
    level = look.between(0.14, 0.3)
    clear = surfaces.plain((206, 222, 226))
    grain = surfaces.speckles(look.rng, sand, 8)
    tile = surfaces.stack((grain, level), (clear, 0.52 - level), (grain, 0.36 - level),
                            (clear, 0.12 + level))  # fmt: skip
    return shape(
        [(join([*ends, *posts]), frame), (glass, tile)],
        [cylinder_part(1.3 * r, 0.011), cylinder_part(1.3 * r, 0.011, (0, 0, h - 0.011)),
         cylinder_part(0.95 * r, h - 0.02, (0, 0, 0.01))],
    )  # fmt: skip


@category("trophy", size=(0.15, 0.105, 0.235), mass=0.9, material="metal", hollow=True,
          aliases=("prize cup", "cup trophy", "award", "trophy cup"), themes=("office", "living"),
          roles=("tall",), colors=("gold", "silver"), common=True)  # fmt: skip
def trophy(look: Look) -> Shape:
    """A trophy cup with two handles, on a plinth with a nameplate."""
    r, h = look.between(0.045, 0.06), look.between(0.2, 0.27)
    metal = surfaces.brushed_metal(look.rng, look.color("gold", "gold", "silver", "bronze"))
    base = look.between(0.24, 0.32) * h
    plinth = block(1.5 * r, 1.5 * r, base, 0.004, 0.003)
    dark = surfaces.marble(
        look.rng, look.own_color("black", "brown", "maroon", "navy"), (120, 112, 106)
    )
    plate = prints.canvas(64, 32, (212, 178, 96))
    prints.write(
        plate, look.pick(["1st", "WINNER", "BEST", "No 1", "2nd"]), 0.5, 0.5, 0.5, (60, 44, 20)
    )
    label = box(0.9 * r, 0.002, 0.4 * base).move(y=-0.75 * r - 0.0006, z=0.3 * base)
    top = h - base
    bowl = lathe(
        [(0, 0), (0.6 * r, 0), (0.55 * r, 0.04 * top), (0.14 * r, 0.12 * top),
         (0.12 * r, 0.26 * top), (0.3 * r, 0.33 * top), (0.66 * r, 0.45 * top),
         (0.86 * r, 0.66 * top), (r, top),
         (0.93 * r, top), (0.78 * r, 0.66 * top), (0.5 * r, 0.5 * top), (0, 0.46 * top)],
        30,
    ).move(z=base)  # fmt: skip
    bows = [
        tube(smooth([(s * 0.9 * r, 0, base + 0.9 * top), (s * 1.35 * r, 0, base + 0.94 * top),
                     (s * 1.45 * r, 0, base + 0.7 * top), (s * 0.68 * r, 0, base + 0.48 * top)], 4),
             0.0042, 8)
        for s in (-1, 1)
    ]  # fmt: skip
    stem = cylinder_part(0.5 * r, 0.4 * top, (0, 0, base))
    cup = hull_of(bowl.bend(lambda p: np.maximum(p, [-1, -1, base + 0.33 * top])))
    return shape(
        [(plinth, dark), (label, plate), (join([bowl, *bows]), metal)],
        [box_part(1.5 * r, 1.5 * r, base), stem, cup, *(hull_of(b) for b in bows)],
    )


KINDS = ("leafy", "leafy", "broad", "succulent", "cactus", "blades", "bonsai", "flowering")


@category("potted_plant", size=(0.17, 0.17, 0.185), mass=0.6, material="ceramic", assembled=True,
          aliases=("plant", "houseplant", "flower pot", "pot plant"),
          themes=("office", "living", "coffee"), roles=("tall",), colors=("terracotta", "white"),
          common=True)  # fmt: skip
def potted_plant(look: Look) -> Shape:
    """A leafy, broad-leaved, grassy or flowering pot plant, a succulent, a cactus or a bonsai."""
    r, h = look.between(0.042, 0.062), look.between(0.065, 0.095)
    pieces = planter(look, r, h)
    green = look.own_color("green", "green", "green", "olive", "sage", spread=16)
    if look.chance(0.12):
        green = look.own_color("maroon", "crimson", "lime")
    kind = look.pick(KINDS)
    grow = {"cactus": cactus_plant, "blades": _blades, "bonsai": _bonsai}.get(kind)
    plant, hulls = grow(look, green, h, r) if grow else _leaves(look, green, h, r, kind)
    return shape([*pieces, *plant], [hull_of(pieces[0][0]), *hulls])


def _leaves(
    look: Look, green: RGB, h: float, r: float, kind: str
) -> tuple[Pieces, list[ConvexPart]]:
    """Return a plant's leaves on a short trunk or in a rosette, and their collision parts."""
    rosette = kind == "succulent"
    count = {"succulent": 24, "broad": 12}.get(kind, 22)
    tile = surfaces.leaf(look.rng, green).transpose(1, 0, 2)
    solids: list[Solid] = []
    for k in range(count):
        share = k / count
        long = 0.066 * (1.2 - 0.7 * share) if rosette else look.between(0.07, 0.115)
        wide = {"succulent": 0.55, "broad": 0.8}.get(kind, look.between(0.35, 0.5)) * long
        base = h * 0.9 + (0.012 * share if rosette else look.between(0.0, 0.06))
        steep = 0.75 + 0.9 * share if rosette else 0.5 + look.between(-0.3, 0.75)
        solids.append(leaf_blade(long, wide, 2.4 * k, steep).move(z=base))
    crown = join(solids)
    pieces: Pieces = [(crown, tile)]
    if not rosette:
        trunk = cylinder(0.0045, 0.075, 8).move(z=0.86 * h)
        pieces.append((trunk, surfaces.plain((96, 84, 52))))
    if kind == "flowering":
        pieces += _blossoms(look, green, h)
    near = crown.vertices[np.hypot(*crown.vertices[:, :2].T) < 1.15 * r]
    return pieces, [hull_part(near)]


def _blossoms(look: Look, green: RGB, h: float) -> Pieces:
    """Return six blossoms on stems above a pot of height ``h``."""
    hue = look.own_color("red", "pink", "yellow", "violet", "white")
    petal, heart = surfaces.speckles(look.rng, hue, 8), surfaces.plain((226, 180, 60))
    pieces: Pieces = []
    for k in range(6):
        angle, out = 2.1 * k, look.between(0.012, 0.05)
        at = (out * np.cos(angle), out * np.sin(angle), h + look.between(0.075, 0.11))
        one = ellipsoid(0.02, 0.013, 0.006, 6, 4).move(x=0.01)
        bloom = join([one.turn(2, np.pi / 3 * m) for m in range(6)])
        stem = tube(np.array([(0.3 * at[0], 0.3 * at[1], 0.88 * h), at]), 0.0015, 5)
        middle = ellipsoid(0.01, 0.01, 0.008, 8, 4)
        pieces += [(bloom.move(*at), petal), (stem, surfaces.plain(green)),
                   (middle.move(*at), heart)]  # fmt: skip
    return pieces


def _blades(look: Look, green: RGB, h: float, r: float) -> tuple[Pieces, list[ConvexPart]]:
    """Return upright blades with pale edges, or fine grass, and their collision parts."""
    fine = look.chance(0.35)
    edge = tint_color(green, 1.4) if fine else look.pick([(222, 206, 110), tint_color(green, 1.5)])
    image = surfaces.stripes([edge, green, tint_color(green, 0.75), green, edge], 1, upright=True)
    section = np.array([(-1.0, 0.0), (0.0, -0.18), (1.0, 0.0), (0.0, 0.1)])
    blades: list[Solid] = []
    for k in range(34 if fine else 10):
        tall = look.between(0.07, 0.15) if fine else look.between(0.1, 0.18)
        wide = 0.003 if fine else look.between(0.009, 0.014)
        t = np.linspace(0, 1, 6)
        width = wide * np.clip(1.15 - t**2, 0.05, 1)
        out = (0.35 if fine else 0.12) * tall * t**2 + 0.25 * r
        rings = np.stack([np.column_stack([x + section[:, 1] * w, section[:, 0] * w, np.full(4, z)])
                          for x, w, z in zip(out, width, 0.86 * h + tall * t,
                                             strict=True)])  # fmt: skip
        blade = loft(rings, section, profile=np.column_stack([out, tall * t]))
        blades.append(blade.turn(2, 2.4 * k + look.between(-0.3, 0.3)))
    tuft = join(blades)
    return [(tuft, image)], [hull_of(tuft)]


def _bonsai(look: Look, green: RGB, h: float, r: float) -> tuple[Pieces, list[ConvexPart]]:
    """Return a bonsai: a bent trunk with clouds of leaves, and the collision parts of both."""
    z, lean = 0.86 * h, look.between(-0.02, 0.02)
    path = smooth(
        [(0, 0, z), (0.016 + lean, 0.004, z + 0.035), (lean - 0.012, 0, z + 0.07),
         (lean, 0, z + 0.1)], 4,
    )  # fmt: skip
    trunk = tube(path, np.linspace(0.009, 0.004, len(path)), 10)
    bark = surfaces.scratches(look.rng, (110, 80, 56), (70, 50, 36), 70)
    needles = surfaces.spots(look.rng, green, tint_color(green, 1.35), 0.3)

    def knobbly(p: np.ndarray) -> np.ndarray:
        return p * (1 + 0.09 * np.sin(160 * p[:, :1]) * np.cos(190 * p[:, 1:2]))

    clouds = []
    for k in range(5):
        wide = look.between(0.045, 0.075)
        puff = ellipsoid(wide, 0.9 * wide, 0.5 * wide, 12, 7).bend(knobbly)
        out = 0.0 if k == 0 else look.between(0.02, 0.04)
        at = (lean + out * np.cos(2.4 * k), out * np.sin(2.4 * k), z + 0.1 - 0.009 * k)
        clouds.append(puff.move(*at))
    crown = join(clouds)
    return [(trunk, bark), (crown, needles)], [hull_of(trunk), hull_of(crown)]


@category("paperweight", size=(0.0759, 0.0759, 0.0491), mass=0.25, material="glass",
          aliases=("glass paperweight", "paper weight", "dome paperweight"),
          themes=("office", "living"), colors=("blue", "purple"))  # fmt: skip
def paperweight(look: Look) -> Shape:
    """A glass dome with coloured swirls and flowers inside."""
    color = look.color("blue", "purple", "green", "red", "amber", "teal", "pink")
    k = look.between(0.85, 1.15)
    dome = standing((0.03, 0), (0.036, 0.008), (0.037, 0.02), (0.032, 0.034), (0.02, 0.044),
                   (0.008, 0.0478), sides=28)  # fmt: skip
    image = prints.canvas(160, 96, tint_color(color, 1.3))
    for n in range(16):
        tone = look.own_color("white", "yellow", "pink", "navy", "mint", "coral")
        x, y = (n % 8 + 0.5 * (n // 8)) / 8, 0.3 + 0.3 * (n // 8)
        prints.disc(image, x, y, 0.13, color)
        prints.disc(image, x, y, 0.09, tone)
        prints.disc(image, x, y, 0.035, (250, 230, 120))
    prints.fill(image, 0, 0.86, 1, 0.14, tint_color(color, 0.6))
    gleam = ball(0.02, 0.008, 0.004, (-0.008, -0.012, 0.0425), 10)
    return put_down([(dome, image), (gleam, plain((250, 252, 252)))], dome, factor=k)


@category("shop_sign", size=(0.197, 0.151, 0.00648), mass=0.12, material="wood", assembled=True,
          aliases=("open sign", "closed sign", "hanging sign", "door sign", "open closed sign",
          "sign", "name plaque", "house sign"), themes=("office",), roles=("flat",),
          colors=("red", "green"), state="lying flat")  # fmt: skip
def shop_sign(look: Look) -> Shape:
    """A hanging sign, lettered OPEN or CLOSED, lying flat with its cord."""
    k = look.between(0.92, 1.08)
    word = look.pick(["OPEN", "OPEN", "CLOSED"])
    color = look.color("red", "green", "navy", "black", "white", "wooden")
    x, y = 0.2 * k, 0.1 * k
    board = block(x, y, 0.006, 0.01, 0.001)
    image = prints.canvas(200, 100, color)
    ink = readable_on(color)
    prints.fill(image, 0.03, 0.06, 0.94, 0.88, ink)
    prints.fill(image, 0.045, 0.09, 0.91, 0.82, color)
    prints.write(image, word, 0.5, 0.5, 0.42, ink, bold=True)
    face = box(0.95 * x, 0.92 * y, 0.0006).move(z=0.0057)
    cord = rod([(-0.4 * x, 0.46 * y, 0.005), (-0.1 * x, 0.95 * y, 0.0022), (0.1 * x, 0.95 * y,
                0.0022), (0.4 * x, 0.46 * y, 0.005)], 0.0017, 6)  # fmt: skip
    return shape([(board, look.surface(color, "wood")), (face, image),
                  (cord, surfaces.plain((206, 184, 140)))],
                 [box_part(x, y, 0.006), hull_of(cord)])  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("planet_model", size=(0.14, 0.15, 0.115), mass=0.2, material="wood",
          aliases=("model planet", "saturn model", "planet", "model of saturn", "moon globe",
          "mars globe"), themes=("office",), colors=("tan",))  # fmt: skip
@from_pieces()
def planet_model(look: Look) -> Pieces:
    """A ringed planet on a stand."""
    color = look.color("tan", "orange", "teal", "purple", "terracotta")
    bands = surfaces.stripes(
        [color, tint_color(color, 1.3), tint_color(color, 0.85), color, tint_color(color, 1.15)], 2
    )
    foot = standing((0.035, 0), (0.034, 0.006), (0.006, 0.012), (0.005, 0.04))
    globe = ball(0.08, 0.08, 0.08, (0, 0, 0), 26).turn(1, 0.4).move(z=0.075)
    ring = (lathe([(0.05, -0.001), (0.075, -0.001), (0.075, 0.001), (0.05, 0.001)], 44,
                  loop=True).turn(1, 0.4).move(z=0.075))  # fmt: skip
    return [(foot, BLACK), (globe, bands), (ring, surfaces.plain(tint_color(color, 1.5)))]


@category("volcano_model", size=(0.21, 0.21, 0.12), mass=0.5, material="wood", themes=("office",),
          colors=("brown",))  # fmt: skip
@from_pieces(bodies=2)
def volcano_model(look: Look) -> Pieces:
    """A volcano model: a rock cone on a square base with lava in its crater and on its slopes."""
    color = look.color("brown", "charcoal", "terracotta")
    rock = standing((0.09, 0.008), (0.075, 0.025), (0.05, 0.07), (0.03, 0.115), (0.018, 0.115),
                    (0.012, 0.1), sides=18)  # fmt: skip
    rock = rock.bend(lambda p: (p
                                * np.column_stack([*(2
                                                     * [1 + 0.07
                                                        * np.sin(5 * np.arctan2(p[:, 1], p[:, 0])
                                                                 + 20 * p[:, 2])]),
                                                   np.ones(len(p))])))  # fmt: skip
    lava = [tube(smooth([(0.008 * np.cos(a), 0.008 * np.sin(a), 0.112),
                         (0.033 * np.cos(a), 0.033 * np.sin(a), 0.113),
                         (0.054 * np.cos(a + 0.1), 0.054 * np.sin(a + 0.1), 0.075),
                         (0.08 * np.cos(a), 0.08 * np.sin(a), 0.034)], 5), 0.008, 8)
            for a in (-2.2, -1.3, 0.3, 1.9)]  # fmt: skip
    base = at_block(0.21, 0.21, 0.01, 0.02)
    return [
        (base, dye(look, "green", "wooden", "sage")),
        (rock, surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.2)),
        (join([*lava, ball(0.04, 0.04, 0.014, (0, 0, 0.112), 14)]), surfaces.plain((240, 92, 30))),
    ]
