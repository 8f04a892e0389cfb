"""Old arms, instruments and machines: daggers, pistols, scrolls, typewriters, gramophones."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import side_view
from ...build.making import (
    BRASS_TONE,
    DARK,
    GLASS_TONE,
    STEEL_TONE,
    at_box,
    drum,
    plate,
    standing,
    steel,
)
from ...build.outlines import ellipse
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def dagger(look: Look) -> Shape:
    """A dagger lying: a pointed blade with a ridge, guard, grip and pommel."""
    k = look.between(0.85, 1.2)
    color = look.color("brown", "black", "maroon", "wooden", "navy")
    rim = [(0.02, -0.014), (0.13, -0.011), (0.19, 0), (0.13, 0.011), (0.02, 0.014)]
    blade = plate(rim, 0.003, at=(0, 0, 0.006))
    ridge = plate([(0.02, -0.003), (0.17, 0), (0.02, 0.003)], 0.0045, at=(0, 0, 0.0052))
    guard = block(0.012, 0.075, 0.012, 0.003).move(0.014, 0, 0.0015)
    grip = rod([(0.01, 0, 0.0075), (-0.04, 0, 0.0075), (-0.08, 0, 0.0075)],
               [0.007, 0.0095, 0.007], 12)  # fmt: skip
    bands = [drum(0.0102, 0.003, (-0.02 - 0.02 * n, 0, 0.0075), 0, sides=14) for n in range(3)]
    pommel = ball(0.022, 0.022, 0.02, (-0.088, 0, 0.009), 14)
    hilt = steel(look, look.pick([BRASS_TONE, STEEL_TONE, (150, 110, 62)]))
    metal = look.pick([STEEL_TONE, (150, 110, 62), (160, 164, 168)])
    return put_down(
        [(join([blade, ridge]), steel(look, metal)), (join([guard, *bands, pommel]), hilt),
         (grip, textures.speckles(look.rng, color, 8))],
        blade, guard, grip, pommel, factor=k, foot=0.25,
    )  # fmt: skip


def flintlock_pistol(look: Look) -> Shape:
    """A muzzle-loading pistol lying on its side."""
    k = look.between(0.85, 1.15)
    color = look.color("brown", "wooden", "maroon")
    stock = plate([(-0.11, -0.045), (-0.085, -0.052), (-0.055, -0.018), (0.0, -0.006), (0.1, 0.0),
                 (0.1, 0.01), (-0.05, 0.012), (-0.085, -0.01)], 0.02, at=(0, 0, 0))  # fmt: skip
    barrel = drum(0.0085, 0.2, (-0.045, 0.014, 0.0105), 0, top=0.0075, sides=16)
    bore = drum(0.005, 0.0012, (0.1545, 0.014, 0.0105), 0, sides=12)
    lock = plate(ellipse(0.06, 0.018, 16), 0.004, at=(-0.03, 0.002, 0.019))
    cock = rod([(-0.035, 0.002, 0.023), (-0.04, 0.022, 0.024), (-0.026, 0.03, 0.024)], 0.0035, 8)
    guard = rod([(-0.045, -0.01, 0.01), (-0.03, -0.033, 0.01), (-0.005, -0.028, 0.01),
                 (0.0, -0.006, 0.01)], 0.002, 6)  # fmt: skip
    cap = ball(0.034, 0.022, 0.022, (-0.098, -0.048, 0.01), 12)
    bands = [at_box(0.008, 0.03, 0.022, (x, 0.008, 0)) for x in (0.045, 0.095)]
    return put_down(
        [(stock, textures.wood(look.rng, color)), (join([barrel, lock, cock]), steel(look)),
         (bore, plain(DARK)), (join([guard, cap, *bands]), steel(look, BRASS_TONE))],
        stock, barrel, guard, factor=k,
    )  # fmt: skip


def shackle(look: Look) -> Shape:
    """Two iron cuffs joined by a short chain, lying."""
    k = look.between(0.85, 1.15)
    color = look.color("charcoal", "gray", "brown", "black")
    cuffs = [torus(0.034, 0.0065, 30, 8).move(s * 0.085, 0, 0.0062) for s in (-1, 1)]
    locks = [at_box(0.02, 0.026, 0.014, (s * 0.122, 0, 0)) for s in (-1, 1)]
    links = []
    for n in range(5):
        one = torus(0.009, 0.0028, 14, 6).scale(1.25, 0.85, 1)
        one = one.turn(0, 0.5 * (-1) ** n).move(-0.035 + 0.0175 * n, 0, 0.0065)
        links.append(one)
    iron = textures.spots(look.rng, color, (112, 76, 54), 0.1)
    return put_down([(join([*cuffs, *locks, *links]), iron)], *cuffs, join(links), factor=k,
                    foot=0.3)  # fmt: skip


def astrolabe(look: Look) -> Shape:
    """A brass disc of rings and a pointer, lying, its ring for hanging above."""
    k = look.between(0.85, 1.2)
    color = look.color("gold", "bronze", "copper", "brass")
    disk = drum(0.06, 0.005, sides=36, bevel=0.001)
    rim = torus(0.056, 0.003, 36, 8).move(z=0.005)
    inner = torus(0.032, 0.0016, 28, 6).move(0.008, 0.01, 0.0064)
    pointer = [
        plate(
            [(-0.054, -0.003), (0.054, -0.0045), (0.054, 0.0045), (-0.054, 0.003)],
            0.0015,
            at=(0, 0, 0.0075),
        ).turn(2, look.between(0.2, 2.8)),
        drum(0.005, 0.005, (0, 0, 0.005)),
    ]
    loop = torus(0.009, 0.002, 18, 6).move(0, 0.072, 0.0022)
    neck = plate([(-0.014, 0.054), (0.014, 0.054), (0.006, 0.068), (-0.006, 0.068)], 0.005)
    face = prints.canvas(128, 128, color)
    for r in (0.46, 0.36, 0.24):
        prints.disc(face, 0.5, 0.5, r, tint_color(color, 0.6), r - 0.012)
    for a in np.arange(24) * np.pi / 12:
        tip = [(0.5 + r * np.cos(a), 0.5 + r * np.sin(a)) for r in (0.37, 0.44)]
        prints.stroke(face, tip, 0.012, tint_color(color, 0.5))
    return put_down([(disk, face), (join([rim, inner, *pointer, loop, neck]), steel(look, color))],
                    disk, neck, factor=k)  # fmt: skip


def scroll(look: Look) -> Shape:
    """A parchment scroll, half unrolled, written on."""
    color = look.color("cream", "beige", "tan", "ivory")
    k, w = look.between(0.85, 1.15), look.between(0.1, 0.14)
    long = look.between(0.11, 0.17)
    sheet = at_box(long, w, 0.0016, (0, 0, 0.0005))
    image = prints.canvas(176, 128, color)
    ink = look.own_color("brown", "black", "maroon")
    prints.lines(image, look.rng, (0.1, 0.14, 0.8, 0.72), 9, ink, 0.5)
    rolls, rods, knobs = [], [], []
    for s, r in ((-1, 0.013), (1, look.between(0.009, 0.015))):
        x = s * (long / 2 + 0.4 * r)
        rolls.append(drum(r, w, (x, -w / 2, 0.96 * r), 1, sides=18))
        rods.append(drum(0.36 * r, w + 0.024, (x, -w / 2 - 0.012, 0.96 * r), 1, sides=12))
        knobs += [ball(0.8 * r, 0.8 * r, 0.8 * r, (x, t * (w / 2 + 0.013), 0.96 * r), 10)
                  for t in (-1, 1)]  # fmt: skip
    paper = textures.spots(look.rng, color, tint_color(color, 0.8), 0.1, 64)
    return put_down(
        [(sheet, image), (join(rolls), paper), (join([*rods, *knobs]), textures.wood(look.rng,
         (120, 78, 48)))], sheet, *rolls, factor=k, foot=0.12)  # fmt: skip


def typewriter(look: Look) -> Shape:
    """A portable typewriter with a sheet of paper in its carriage."""
    color = look.color("teal", "black", "mint", "red", "cream", "sky", "gray")
    k = look.between(0.85, 1.05)
    side = [(-0.16, 0), (0.13, 0), (0.13, 0.085), (0.02, 0.075), (-0.16, 0.03)]
    body = side_view(np.array(side), 0.3).turn(2, np.pi / 2)
    keys = []
    for row in range(4):
        for n in range(10):
            y = -0.135 + 0.026 * row
            z = 0.03 + (y + 0.16) * 0.25 - 0.001
            keys.append(drum(0.0085, 0.006, (-0.117 + 0.0255 * n + 0.004 * row, y, z), sides=10))
    space = at_box(0.13, 0.012, 0.01, (0, -0.153, 0.027))
    well = at_box(0.13, 0.05, 0.012, (0, 0.0, 0.072))
    roller = drum(0.017, 0.3, (-0.15, 0.08, 0.1), 0, sides=20)
    ends = [drum(0.013, 0.018, (x, 0.08, 0.1), 0, sides=14) for x in (-0.168, 0.15)]
    carriage = at_box(0.29, 0.05, 0.02, (0, 0.095, 0.078))
    lever = rod([(-0.15, 0.07, 0.1), (-0.175, 0.03, 0.118), (-0.18, 0.0, 0.122)], 0.003, 6)
    page = at_box(0.2, 0.0012, 0.13).turn(0, 0.28).move(0, 0.085, 0.11)
    text = prints.sheet(look.rng)
    paint = textures.speckles(look.rng, color, 4)
    dark = plain((44, 44, 48) if sum(color) > 240 else (226, 220, 200))
    chrome = steel(look)
    return put_down(
        [(body, paint), (join(keys), dark), (join([space, roller, well]), plain(DARK)),
         (join([*ends, lever]), chrome), (carriage, chrome), (page, text)],
        body, carriage, roller, page, factor=k,
    )  # fmt: skip


def gramophone(look: Look) -> Shape:
    """A gramophone: a wooden box, a record on its plate and a brass horn."""
    color = look.color("brown", "wooden", "maroon", "black")
    k = look.between(0.85, 1.1)
    base, top = block(0.24, 0.24, 0.012, 0.008, 0.003), block(0.215, 0.215, 0.08, 0.005, 0.004)
    slab = drum(0.092, 0.006, (0, 0, 0.088), sides=36)
    record = drum(0.088, 0.003, (0, 0, 0.094), sides=36)
    badge = drum(0.03, 0.001, (0, 0, 0.0967), sides=24)
    flare = [(0.009, 0.0), (0.012, 0.05), (0.024, 0.1), (0.052, 0.15), (0.095, 0.19),
             (0.125, 0.2)]  # fmt: skip
    inner = [(r - 0.003, z + 0.0005) for r, z in flare]
    horn = lathe([(0, 0), *flare, *inner[::-1], (0, 0.002)], 30)
    horn = horn.turn(0, 0.75).move(0, 0.07, 0.19)
    arm = rod([(0, 0.1, 0.086), (0, 0.102, 0.16), (0, 0.085, 0.2), (0, 0.06, 0.192)], 0.009, 10)
    tone = rod([(0.02, 0.095, 0.14), (0.07, 0.06, 0.13), (0.062, 0.0, 0.102)], 0.005, 8)
    head = drum(0.013, 0.012, (0.06, -0.004, 0.0985))
    crank = rod([(0.107, 0, 0.05), (0.14, 0, 0.05), (0.14, 0, 0.02), (0.165, 0, 0.02)], 0.004, 8)
    groove = prints.canvas(96, 96, (30, 30, 32))
    for r in np.arange(0.18, 0.5, 0.05):
        prints.disc(groove, 0.5, 0.5, float(r), (58, 58, 62), float(r) - 0.012)
    label = plain(look.own_color("crimson", "navy", "mustard", "green"))
    brass = steel(look, look.pick([BRASS_TONE, (206, 170, 90), (188, 116, 76)]))
    return put_down(
        [
            (join([base, top.move(z=0.01)]), look.surface(color, "wood")),
            (slab, plain((70, 96, 70))),
            (record, groove),
            (badge, label),
            (join([horn, arm, tone, head, crank]), brass),
        ],
        base,
        top.move(z=0.01),
        horn,
        arm,
        factor=k,
    )


def stereoscope(look: Look) -> Shape:
    """A hand viewer for paired photographs: a hooded lens board, a bar and a picture card."""
    color = look.color("brown", "wooden", "maroon")
    k = look.between(0.85, 1.15)
    rail = at_box(0.03, 0.26, 0.014, (0, 0.05, 0.03))
    foot = [at_box(0.1, 0.17, 0.006, (0, 0.05, 0)), at_box(0.02, 0.03, 0.03, (0, 0.05, 0.004))]
    rim = [(-0.075, 0), (0.075, 0), (0.07, 0.062), (0.025, 0.062), (0, 0.048), (-0.025, 0.062),
           (-0.07, 0.062)]  # fmt: skip
    hood = plate(rim, 0.055).turn(0, np.pi / 2).move(0, -0.035, 0.036)
    eyes = [drum(0.019, 0.003, (s * 0.034, -0.0925, 0.068), 1) for s in (-1, 1)]
    card = at_box(0.165, 0.003, 0.085, (0, 0.15, 0.042))
    holder = at_box(0.12, 0.02, 0.01, (0, 0.15, 0.04))
    image = prints.canvas(160, 84, (206, 180, 140))
    for x in (0.06, 0.52):
        prints.fill(image, x, 0.1, 0.42, 0.8, (160, 130, 96))
        prints.disc(image, x + 0.21, 0.42, 0.2, (100, 78, 58))
        prints.fill(image, x, 0.66, 0.42, 0.24, (86, 66, 48))
    wood = look.surface(color, "wood")
    return put_down(
        [(join([rail, *foot, holder]), wood), (hood, steel(look, (150, 110, 72))),
         (join(eyes), plain(GLASS_TONE)), (card, image)],
        *foot, rail, hood, card, factor=k)  # fmt: skip


def display_case(look: Look) -> Shape:
    """A glass case on a dark base, for small things."""
    x, y, h = look.between(0.17, 0.23), look.between(0.13, 0.17), look.between(0.12, 0.17)
    color = look.color("brown", "black", "wooden", "white")
    base = block(x + 0.012, y + 0.012, 0.02, 0.003, 0.002)
    panes = [at_box(x, 0.003, h, (0, s * (y / 2 - 0.0015), 0.02)) for s in (-1, 1)]
    panes += [at_box(0.003, y - 0.006, h, (s * (x / 2 - 0.0015), 0, 0.02)) for s in (-1, 1)]
    panes += [at_box(x, y, 0.003, (0, 0, 0.02 + h))]
    posts = [at_box(0.005, 0.005, h + 0.003, (s * x / 2, t * y / 2, 0.02))
             for s in (-1, 1) for t in (-1, 1)]  # fmt: skip
    edges = [at_box(x, 0.005, 0.005, (0, s * y / 2, 0.02 + h)) for s in (-1, 1)]
    edges += [at_box(0.005, y, 0.005, (s * x / 2, 0, 0.02 + h)) for s in (-1, 1)]
    felt = at_box(x - 0.01, y - 0.01, 0.001, (0, 0, 0.0198))
    trim = steel(look, BRASS_TONE) if look.chance(0.5) else plain(tint_color(color, 0.8))
    return put_down(
        [
            (base, look.surface(color, "wood")),
            (felt, plain(look.own_color("maroon", "navy", "cream"))),
            (join(panes), plain((226, 236, 238))),
            (join([*posts, *edges]), trim),
        ],
        base,
        join(panes),
        opacity=0.55,
    )


def butterfly_case(look: Look) -> Shape:
    """A shallow framed case lying, with a pinned butterfly in it."""
    color = look.color("brown", "black", "wooden", "white")
    k = look.between(0.85, 1.15)
    wing = look.own_color("blue", "orange", "turquoise", "yellow", "coral")
    back = at_box(0.2, 0.15, 0.02)
    bars = [at_box(0.2, 0.014, 0.026, (0, s * 0.068, 0)) for s in (-1, 1)]
    bars += [at_box(0.014, 0.15, 0.026, (s * 0.093, 0, 0)) for s in (-1, 1)]
    fore = [(0.002, 0.004), (0.03, 0.006), (0.058, 0.034), (0.05, 0.046), (0.02, 0.03)]
    hind = [(0.002, -0.018), (0.026, -0.03), (0.04, -0.012), (0.03, 0.004), (0.002, 0.004)]
    wings = [np.array(w) * [s, 1] for w in (fore, hind) for s in (1, -1)]
    flat = [plate(w if s > 0 else w[::-1], 0.0015, at=(0, 0, 0.0205))
            for w, s in zip(wings, (1, -1, 1, -1), strict=True)]  # fmt: skip
    spots = [drum(0.0045, 0.001, (s * x, y, 0.0217)) for s in (-1, 1)
             for x, y in ((0.043, 0.03), (0.026, -0.012))]  # fmt: skip
    body = ball(0.008, 0.05, 0.008, (0, 0.0, 0.022), 10)
    return put_down(
        [(back, plain((244, 240, 228))), (join(bars), look.surface(color, "wood")),
         (join(flat), textures.gradient(tint_color(wing, 0.8), tint_color(wing, 1.2), look.rng)),
         (join([*spots, body]), plain((36, 32, 32)))], back, *bars, factor=k)  # fmt: skip


def quill(look: Look) -> Shape:
    """An inkwell with a feather pen standing in it."""
    color = look.color("white", "navy", "black", "cream", "crimson", "teal")
    k = look.between(0.85, 1.15)
    pot = standing((0.026, 0), (0.03, 0.006), (0.03, 0.024), (0.016, 0.036), (0.014, 0.042),
                  (0.018, 0.045), (0.018, 0.047))  # fmt: skip
    ink = drum(0.0135, 0.001, (0, 0, 0.0465))
    tip = np.array([0.05, 0.01, 0.19])
    shaft = rod([(0, 0, 0.03), (0.012, 0.002, 0.085), tuple(tip)], [0.0022, 0.0014], 6)
    rim = [
        (0.0, 0.0),
        (0.012, 0.014),
        (0.016, 0.06),
        (0.004, 0.125),
        (-0.012, 0.075),
        (-0.011, 0.02),
    ]
    vane = plate(rim, 0.0012).turn(0, np.pi / 2).turn(1, 0.36).move(0.015, 0.004, 0.07)
    glass = look.pick([(70, 84, 110), (60, 60, 66), (120, 150, 150), (196, 160, 84)])
    return put_down(
        [(pot, textures.speckles(look.rng, glass, 5)), (ink, plain((28, 30, 52))),
         (shaft, plain((230, 222, 200))), (vane, textures.scratches(look.rng, color,
          tint_color(color, 0.85), 80))], pot, shaft, vane, factor=k)  # fmt: skip


CATEGORIES = (
    Category("dagger", dagger, (0.293, 0.0763, 0.0193), 0.35, ("bronze dagger", "dirk", "poniard",
             "ceremonial dagger", "sword hilt", "short sword"), ("living",), ("flat",), ("brown",)),
    Category("flintlock_pistol", flintlock_pistol, (0.257, 0.0876, 0.0262), 0.6, ("flintlock",
             "duelling pistol", "dueling pistol", "antique pistol", "pirate pistol",
             "starting pistol", "starter pistol"), ("living",), ("flat",), ("brown",)),
    Category("shackle", shackle, (0.285, 0.0874, 0.0151), 0.6, ("iron shackle", "pair of shackles",
             "handcuffs", "pair of handcuffs", "manacle"), ("living",), ("flat",), ("gray",)),
    Category("astrolabe", astrolabe, (0.124, 0.148, 0.0103), 0.4, ("astrolabe replica",
             "brass astrolabe"), ("living",), ("flat",), ("gold",)),
    Category("scroll", scroll, (0.176, 0.153, 0.0259), 0.08, ("papyrus scroll", "parchment scroll",
             "papyrus", "paper scroll", "ancient scroll"), ("living", "office"), (), ("cream",)),
    Category("typewriter", typewriter, (0.33, 0.289, 0.221), 4.5, ("portable typewriter",
             "manual typewriter", "vintage typewriter", "toy typewriter"), ("office",), ("big",),
             ("teal", "black")),
    Category("gramophone", gramophone, (0.284, 0.272, 0.413), 3.0, ("phonograph",
             "gramophone player", "wind-up gramophone"), ("living",), ("big",), ("brown",)),
    Category("stereoscope", stereoscope, (0.165, 0.273, 0.127), 0.4, ("stereo viewer",
             "stereoscopic viewer"), ("living",), (), ("brown",)),
    Category("display_case", display_case, (0.21, 0.163, 0.174), 0.8, ("glass case",
             "glass display case", "showcase", "museum case", "vitrine"), ("living",), ("big",),
             ("brown", "black")),
    Category("butterfly_case", butterfly_case, (0.2, 0.15, 0.026), 0.4, ("framed butterfly",
             "butterfly frame", "mounted butterfly", "insect case"), ("living",), ("flat", "big"),
             ("brown",)),
    Category("inkwell", quill, (0.101, 0.0656, 0.208), 0.15, ("inkstand", "ink well", "inkpot",
             "ink pot", "standish"), ("office", "living"), ("tall",), ("white",)),
)  # fmt: skip
"""The module's categories."""
