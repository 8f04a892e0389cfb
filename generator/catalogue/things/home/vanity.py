"""What stands on a vanity table or by a wash basin."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.outlines import ellipse, rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

PASTELS = ("pink", "lavender", "cream", "mint", "coral", "white", "gold", "navy")


def perfume_bottle(look: Look) -> Shape:
    """A cut-glass bottle with a collar and a cap."""
    x, y, h = look.between(0.05, 0.065), look.between(0.026, 0.034), look.between(0.06, 0.075)
    liquid = look.color("pink", "amber", "lavender", "sky", "mint")
    metal = textures.brushed_metal(look.rng, look.own_color("gold", "silver", "black", "copper"))
    face = prints.canvas(96, 96, tint_color(liquid, 1.25))
    prints.fill(face, 0, 0.0, 1, 0.14, tint_color(liquid, 1.5))
    prints.fill(face, 0.25, 0.42, 0.5, 0.24, (248, 246, 240))
    prints.write(face, look.pick(["FLEUR", "NOIR", "ROSE", "AQUA"]), 0.5, 0.54, 0.11, (60, 50, 50))
    round_one = look.chance(0.35)
    body = (
        prism(ellipse(x, y * 1.25, 24), 0, h, 0.004) if round_one else block(x, y, h, 0.006, 0.004)
    )
    front = box(x * 0.8, y * 1.02, h * 0.86).move(z=h * 0.07) if not round_one else body
    collar = cylinder(0.009, 0.008, 16).move(z=h)
    cap = cylinder(0.0135, 0.026, 20, bevel=0.003).move(z=h + 0.008)
    return shape(
        [
            (body, textures.plain(tint_color(liquid, 1.15))),
            (front, face),
            (collar, metal),
            (cap, metal),
        ],
        [hull_of(body), cylinder_part(0.0135, 0.034, (0, 0, h))],
    )


def lipstick(look: Look) -> Shape:
    """An open lipstick standing: tube, ring and slanted colour."""
    case = textures.speckles(look.rng, look.color("black", "gold", "white", "navy"), 3)
    ring = textures.brushed_metal(look.rng, look.own_color("gold", "silver"))
    pigment = textures.plain(look.own_color("red", "crimson", "pink", "coral", "magenta"))
    base = cylinder(0.011, 0.042, 20, bevel=0.001)
    middle = cylinder(0.0092, 0.018, 20).move(z=0.042)
    stick = cylinder(0.0068, 0.02, 18).bend(
        lambda p: np.column_stack(
            [p[:, :2], np.where(p[:, 2] > 0.01, p[:, 2] + 0.5 * p[:, 1] + 0.003, p[:, 2])]
        )
    )
    return shape(
        [(base, case), (middle, ring), (stick.move(z=0.06), pigment)],
        [cylinder_part(0.011, 0.042), cylinder_part(0.0085, 0.04, (0, 0, 0.042))],
    )


def hairbrush(look: Look) -> Shape:
    """A paddle brush lying on its back, bristles up."""
    wood = look.surface(look.color("black", "pink", "wooden", "teal", "cream"), "plastic")
    pad = textures.grid((60, 52, 58), (196, 150, 160), 12, 8, 96, 2)
    head = prism(ellipse(0.105, 0.07, 24), 0, 0.014, 0.004).move(x=-0.06)
    grip = prism(
        [(-0.03, -0.013), (0.03, -0.009), (0.105, -0.013), (0.118, 0), (0.105, 0.013),
         (0.03, 0.009), (-0.03, 0.013)],
        0, 0.013,
    )  # fmt: skip
    bristles = prism(ellipse(0.084, 0.05, 20), 0.013, 0.03, 0.006).move(x=-0.06)
    return shape(
        [(head, wood), (grip, wood), (bristles, pad)],
        [hull_of(head), hull_of(bristles), box_part(0.15, 0.02, 0.013, (0.043, 0, 0))],
    )


def hand_mirror(look: Look) -> Shape:
    """A round or oval hand mirror lying face up."""
    frame = look.surface(
        look.color("gold", "silver", "pink", "white", "black", "teal", "brown"), "plastic"
    )
    sky = textures.gradient((176, 196, 208), (226, 236, 242), look.rng)
    r, long, oval = look.between(0.046, 0.062), look.between(0.09, 0.13), look.between(1.0, 1.3)
    wide, at = look.between(0.015, 0.024), -0.055
    back = cylinder(r, 0.011, 32, bevel=0.003).scale(oval, 1, 1).move(x=at)
    glass = cylinder(0.84 * r, 0.002, 32).scale(oval, 1, 1).move(x=at, z=0.0105)
    middle = at + oval * r + 0.46 * long
    grip = prism(rectangle(long, wide, 0.45 * wide), 0, 0.011, 0.003).move(x=middle)
    return shape(
        [(back, frame), (glass, sky), (grip, frame)],
        [hull_of(back), hull_of(glass), box_part(long, wide, 0.011, (middle, 0, 0))],
    )


def cream_jar(look: Look) -> Shape:
    """A squat jar with a wide lid."""
    r, h = look.between(0.028, 0.034), look.between(0.028, 0.034)
    color = look.color(*PASTELS)
    word = look.pick(["CREAM", "BALM", "GLOW", "CARE"])
    print_ = prints.label(look.rng, word, tint_color(color, 0.6), tint_color(color, 1.2))
    lid = textures.speckles(look.rng, look.own_color("white", "gold", "black", "silver"), 3)
    top = cylinder(r * 1.04, 0.019, 28, bevel=0.003).move(z=h)
    return shape(
        [(cylinder(r, h, 28, bevel=0.003), print_), (top, lid)],
        [cylinder_part(r, h), cylinder_part(r * 1.04, 0.019, (0, 0, h))],
    )


def soap_dispenser(look: Look) -> Shape:
    """A pump bottle for soap; the spout points to the viewer."""
    r, h = look.between(0.03, 0.036), look.between(0.105, 0.125)
    color = look.color("white", "teal", "amber", "pink", "gray", "sage")
    word = look.pick(["SOAP", "LOTION", "HANDS"])
    print_ = prints.label(look.rng, word, tint_color(color, 0.55), tint_color(color, 1.1))
    body = lathe(
        [
            (0, 0),
            (r - 0.004, 0),
            (r, 0.004),
            (r, 0.8 * h),
            (0.8 * r, 0.93 * h),
            (0.4 * r, h),
            (0, h),
        ],
        v=[0, 0, 0.02, 0.8, 0.9, 0.98, 1],
    )
    pump = textures.speckles(look.rng, look.own_color("white", "black", "silver", "gold"), 3)
    collar = cylinder(0.014, 0.012, 18, bevel=0.001).move(z=h)
    stem = cylinder(0.0045, 0.024, 12).move(z=h + 0.01)
    spout = tube([(0, 0.008, h + 0.036), (0, -0.02, h + 0.036), (0, -0.042, h + 0.03)], 0.0065, 10)
    return shape(
        [(body, print_), (collar, pump), (stem, pump), (spout, pump)],
        [
            cylinder_part(r, 0.82 * h),
            hull_part(body.vertices[body.vertices[:, 2] > 0.75 * h]),
            cylinder_part(0.014, 0.012, (0, 0, h)),
            cylinder_part(0.0045, 0.022, (0, 0, h + 0.012)),
            hull_of(spout),
        ],
    )


def nail_polish(look: Look) -> Shape:
    """A small square bottle with a tall black cap."""
    color = look.color("red", "pink", "violet", "coral", "navy", "teal", "gold")
    body = block(0.028, 0.028, 0.034, 0.006, 0.003)
    cap = cylinder(0.0085, 0.036, 16, top=0.0065, bevel=0.001).move(z=0.034)
    lid = textures.speckles(look.rng, look.own_color("black", "black", "white", "gold"), 3)
    return shape(
        [(body, textures.speckles(look.rng, color, 5)), (cap, lid)],
        [box_part(0.028, 0.028, 0.034), cylinder_part(0.0085, 0.036, (0, 0, 0.034))],
    )


def makeup_compact(look: Look) -> Shape:
    """An open compact: powder below, mirror standing behind."""
    r, t = look.between(0.034, 0.039), 0.009
    case = textures.speckles(look.rng, look.color("black", "pink", "gold", "white"), 3)
    powder = textures.speckles(look.rng, look.own_color("tan", "beige", "coral", "pink"), 6)
    sky = textures.gradient((170, 192, 206), (228, 238, 244), look.rng)
    lift = np.deg2rad(72)
    base = cylinder(r, t, 28, bevel=0.002)
    pan = cylinder(r * 0.84, 0.0015, 28).move(z=t - 0.0005)
    lid = cylinder(r, 0.006, 28, bevel=0.001).move(y=r).turn(0, lift).move(y=r - 0.003, z=t)
    glass = cylinder(r * 0.86, 0.0012, 28).move(y=r, z=0.0053).turn(0, lift)
    glass = glass.move(y=r - 0.003, z=t)
    return shape(
        [(base, case), (pan, powder), (lid, case), (glass, sky)],
        [cylinder_part(r, t), hull_of(lid)],
    )


def toothbrush_cup(look: Look) -> Shape:
    """A tumbler with two toothbrushes standing in it."""
    r, h = 0.036, look.between(0.095, 0.108)
    color = look.color("white", "mint", "sky", "gray", "pink")
    cup = cylinder(r * 0.9, h, 28, top=r, bevel=0.002)
    dark = textures.plain(tint_color(color, 0.45))
    inside = cylinder(r * 0.9, 0.0015, 28).move(z=h - 0.0008)
    pieces = [(cup, look.surface(color, "ceramic")), (inside, dark)]
    parts = [cylinder_part(r, h)]
    for side in (-1, 1):
        tint = textures.plain(look.own_color("blue", "red", "green", "violet", "orange"))
        stick = tube([(side * 0.01, 0, h - 0.02), (side * 0.03, 0.004, h + 0.07)], 0.0042, 8)
        head = box(0.011, 0.012, 0.024).move(side * 0.031, -0.004, h + 0.058)
        pieces += [(stick, tint), (head, textures.plain((240, 242, 244)))]
        parts.append(hull_of(stick, head))
    return shape(pieces, parts)


def ring_box(look: Look) -> Shape:
    """A small open jewellery box with a ring in it."""
    velvet = textures.fabric(look.rng, look.color(
        "navy", "crimson", "green", "black", "violet", "teal", "pink", "white", "brown"
    ))  # fmt: skip
    cushion = textures.plain(look.pick([(236, 228, 214), (40, 40, 46), (150, 30, 50)]))
    gold = textures.plain(look.pick([(214, 176, 88), (204, 206, 210), (216, 150, 120)]))
    base = block(0.056, 0.056, 0.028, 0.006, 0.002)
    pad = box(0.044, 0.044, 0.002).move(z=0.0275)
    lid = block(0.056, 0.02, 0.05, 0.004, 0.002).turn(0, np.deg2rad(-14)).move(y=0.032, z=0.026)
    ring = torus(0.0095, 0.0016, 24, 8).turn(0, np.pi / 2).move(z=0.036)
    gem = ellipsoid(0.006, 0.006, 0.006, 10, 6).move(z=0.048)
    return shape(
        [
            (base, velvet),
            (pad, cushion),
            (lid, velvet),
            (ring, gold),
            (gem, textures.plain((220, 238, 250))),
        ],
        [box_part(0.056, 0.056, 0.029), hull_of(lid), box_part(0.02, 0.005, 0.02, (0, 0, 0.029))],
    )


CATEGORIES = (
    Category("perfume_bottle", perfume_bottle, (0.058, 0.032, 0.1), 0.2, ("perfume", "fragrance",
             "perfume sample", "scent atomiser", "perfume miniature", "atomizer", "scent bottle",
             "room spray"), ("vanity",), (), ("pink", "amber")),
    Category("lipstick", lipstick, (0.022, 0.022, 0.083), 0.025, ("glitter tube", "lip gloss",
             "lip balm", "lip stain", "lipgloss", "chapstick", "lip salve", "brow gel"), ("vanity",
             ), ("round",), ("black", "gold")),
    Category("hairbrush", hairbrush, (0.23, 0.07, 0.03), 0.1, ("paddle brush", "brush",
             "round brush", "hot brush", "detangling brush", "baby brush"), ("vanity",), ("flat",),
             ("black", "pink"), state="lying flat"),
    Category("hand_mirror", hand_mirror, (0.23, 0.116, 0.0125), 0.2, ("mirror", "handheld mirror"),
             ("vanity",), ("flat",), ("gold", "silver"), state="lying flat"),
    Category("cream_jar", cream_jar, (0.064, 0.064, 0.05), 0.12, ("face cream", "cream",
             "moisturizer", "jar of cream", "metal polish tin", "shoe polish tin", "wax polish tin",
             "shoe polish", "moustache wax tin", "aftershave balm", "silver polish jar",
             "hair gel tub", "hair mask tub", "body scrub tub", "nappy cream tub", "boot polish",
             "polish tin", "cold cream jar", "face cream jar", "lip balm pot",
             "petroleum jelly tub", "vaseline"), ("vanity",), ("round",), ("white", "pink")),
    Category("soap_dispenser", soap_dispenser, (0.068, 0.08, 0.155), 0.35, ("hand soap",),
             ("vanity", "kitchen"), ("tall",), ("white", "teal")),
    Category("nail_polish", nail_polish, (0.028, 0.028, 0.07), 0.04, ("nail varnish",
             "nail polish bottle", "nail polish remover"), ("vanity",), (), ("red", "pink")),
    Category("makeup_compact", makeup_compact, (0.074, 0.095, 0.08), 0.07, ("compact",
             "powder compact", "powder", "makeup", "face powder compact", "blush compact",
             "compact mirror", "bronzer", "face powder", "pressed powder", "foundation compact"),
             ("vanity",), (), ("black", "pink"), state="standing open"),
    Category("toothbrush_cup", toothbrush_cup, (0.08, 0.072, 0.18), 0.28, ("toothbrush holder",
             "tumbler for toothbrushes"), ("vanity",), ("tall",), ("white",)),
    Category("ring_box", ring_box, (0.056, 0.07, 0.075), 0.08, ("ring holder", "watch case",
             "earring box", "cufflink box"), ("vanity",), (), ("navy",), state="standing open"),
)  # fmt: skip
