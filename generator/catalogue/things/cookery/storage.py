"""What food is kept and carried in: crates, bread boxes, jars, lunch boxes, pizza boxes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of
from ...build.outlines import rectangle, smooth
from ...build.settled import limb, scatter
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def crate(look: Look) -> Shape:
    """An open wooden crate of slats, or a plastic one with holes."""
    x, y, h = look.between(0.28, 0.34), look.between(0.2, 0.24), look.between(0.11, 0.14)
    color = look.color("wooden", "tan", "brown", "beige", "wooden")
    skin = look.surface(color, "wood")
    t = 0.008
    slats = [box(x, t, 0.25 * h).move(y=s * (y / 2 - t / 2), z=(0.02 + 0.34 * k) * h)
             for s in (-1, 1) for k in range(3)]  # fmt: skip
    slats += [box(t, y - 2 * t, 0.25 * h).move(x=s * (x / 2 - t / 2), z=(0.02 + 0.34 * k) * h)
              for s in (-1, 1) for k in range(3)]  # fmt: skip
    floor = [box(x - 2 * t, 0.17 * y, t).move(y=(k - 2) * 0.185 * y) for k in range(5)]
    posts = [box(0.016, 0.016, h).move(a * (x / 2 - t - 0.008), b * (y / 2 - t - 0.008))
             for a in (-1, 1) for b in (-1, 1)]  # fmt: skip
    return shape([(join([*slats, *floor]), skin),
                  (join(posts), textures.plain(tint_color(color, 0.7)))],
                 frame_parts(x, y, 0.95 * h, t, t))  # fmt: skip


def bread_box(look: Look) -> Shape:
    """A bread bin with a rounded roll front and a knob."""
    x, y, h = look.between(0.34, 0.4), look.between(0.22, 0.26), look.between(0.17, 0.2)
    color = look.color("cream", "silver", "red", "mint", "black", "wooden", "white")
    skin = look.surface(color, look.pick(["metal", "metal", "wood"]))
    a = np.linspace(0, np.pi / 2, 8)
    arch = np.column_stack([0.25 * y - 0.75 * y * np.sin(a), 0.25 * h + 0.75 * h * np.cos(a)])
    side = np.concatenate([[(-0.5 * y, 0), (0.5 * y, 0), (0.5 * y, h)], arch])
    body = prism(side, -x / 2, x / 2)
    body = body.turn(0, np.pi / 2).turn(2, np.pi / 2)
    ends = [box(0.006, y * 1.02, 0.012).move(s * 0.49 * x) for s in (-1, 1)]
    grip = box(0.11, 0.012, 0.012).move(0, -0.47 * y, 0.48 * h)
    sign = prints.canvas(160, 48, color)
    prints.write(sign, "BREAD", 0.5, 0.5, 0.66, readable_on(color), bold=True)
    plate = box(0.16, 0.0012, 0.048).move(0, -0.5005 * y, 0.02 * h)
    dark = textures.plain(tint_color(color, 0.55))
    return shape([(body, skin), (join(ends), dark), (grip, look.surface(look.own_color(
        "wooden", "silver", "black"), "wood")), (plate, sign)], [hull_of(body)])  # fmt: skip


def cookie_jar(look: Look) -> Shape:
    """A bellied jar with a lid and a knob, COOKIES on its front."""
    r, h = look.between(0.075, 0.09), look.between(0.16, 0.19)
    color = look.color("white", "red", "cream", "sky", "yellow", "mint", "brown")
    body = lathe(
        [
            (0, 0),
            (0.72 * r, 0),
            (0.95 * r, 0.14 * h),
            (r, 0.38 * h),
            (0.9 * r, 0.62 * h),
            (0.68 * r, 0.76 * h),
            (0, 0.76 * h),
        ],
        34,
        v=[0, 0.02, 0.18, 0.5, 0.8, 0.95, 1],
    )
    lid = lathe([(0, 0.75 * h), (0.76 * r, 0.75 * h), (0.74 * r, 0.8 * h), (0.4 * r, 0.88 * h),
                 (0, 0.9 * h)], 34)  # fmt: skip
    knob = ellipsoid(0.3 * r, 0.3 * r, 0.26 * r, 16, 10).move(z=0.93 * h)
    image = prints.canvas(256, 128, color)
    front = image[:, 84:172]
    prints.write(front, "COOKIES", 0.5, 0.42, 0.24, readable_on(color), bold=True)
    prints.disc(front, 0.5, 0.7, 0.13, (206, 152, 88))
    for u, v in ((-0.06, -0.03), (0.04, 0.04), (0.05, -0.05), (-0.03, 0.06)):
        prints.disc(front, 0.5 + u, 0.7 + v, 0.022, (90, 54, 34))
    plain = look.surface(tint_color(color, 0.9), "ceramic")
    return shape([(body, image), (join([lid, knob]), plain)], [hull_of(body), hull_of(lid, knob)])


def cool_box(look: Look) -> Shape:
    """A cool box with a white lid and a carrying handle."""
    x, y, h = look.between(0.3, 0.36), look.between(0.2, 0.24), look.between(0.2, 0.24)
    color = look.color("blue", "red", "teal", "navy", "orange", "green")
    low = block(x, y, 0.78 * h, 0.03, 0.004)
    band = block(1.01 * x, 1.01 * y, 0.012, 0.03).move(z=0.74 * h)
    lid = block(1.03 * x, 1.04 * y, 0.2 * h, 0.03, 0.008).move(z=0.78 * h)
    arm = tube(smooth([(-0.52 * x, -0.03, 0.76 * h), (-0.5 * x, -0.5 * y - 0.012, 0.7 * h),
                       (0.5 * x, -0.5 * y - 0.012, 0.7 * h), (0.52 * x, -0.03, 0.76 * h)], 4),
               0.008, 8)  # fmt: skip
    snow = prints.canvas(96, 64, color)
    for k in range(3):
        a = k * np.pi / 3
        prints.stroke(snow, [(0.5 - 0.2 * np.cos(a), 0.5 - 0.32 * np.sin(a)),
                             (0.5 + 0.2 * np.cos(a), 0.5 + 0.32 * np.sin(a))], 0.06,
                      (250, 250, 252))  # fmt: skip
    front = box(0.5 * x, 0.001, 0.42 * h).move(y=-y / 2, z=0.16 * h)
    white = textures.speckles(look.rng, (240, 240, 238), 3)
    return shape([(low, look.surface(color, "plastic")), (join([band, lid, arm]), white),
                  (front, snow)], [hull_of(low), hull_of(lid), hull_of(arm)])  # fmt: skip


def lunch_box(look: Look) -> Shape:
    """A lunch box with a lid, clasps and a handle on top."""
    x, y, h = look.between(0.2, 0.24), look.between(0.1, 0.12), look.between(0.13, 0.15)
    color = look.color("red", "blue", "yellow", "green", "pink", "purple", "teal", "orange")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    body = block(x, y, h, 0.022, 0.006)
    seam = block(1.006 * x, 1.01 * y, 0.005, 0.022).move(z=0.66 * h)
    grip = tube(
        smooth(
            [
                (-0.26 * x, 0, h - 0.002),
                (-0.24 * x, 0, h + 0.028),
                (0.24 * x, 0, h + 0.028),
                (0.26 * x, 0, h - 0.002),
            ],
            4,
        ),
        0.0055,
        10,
    )
    clasps = [box(0.022, 0.006, 0.03).move(s * 0.3 * x, -y / 2 - 0.001, 0.58 * h) for s in (-1, 1)]
    face = prints.cover(look.rng, look.pick(["LUNCH", "YUM", "SNACK"]), color,
                        look.own_color("white", "yellow", "sky"))  # fmt: skip
    front = box(0.7 * x, 0.001, 0.48 * h).move(y=-y / 2, z=0.08 * h)
    dark = textures.plain(look.own_color("black", "white", "silver"))
    return shape([(body, skin), (join([grip, seam, *clasps]), dark),
                  (front, textures.fit(face[::1], 112, 160))],
                 [hull_of(body), hull_of(grip)])  # fmt: skip


def bento_box(look: Look) -> Shape:
    """An open lacquered box with compartments: rice, fish, egg and greens."""
    x, y, h = look.between(0.21, 0.25), look.between(0.15, 0.17), look.between(0.045, 0.055)
    color = look.color("black", "black", "red", "maroon", "wooden", "navy")
    skin = look.surface(color, "plastic")
    walls = [box(x, 0.006, h).move(y=s * (y / 2 - 0.003)) for s in (-1, 1)]
    walls += [box(0.006, y - 0.012, h).move(x=s * (x / 2 - 0.003)) for s in (-1, 1)]
    walls += [box(0.005, y - 0.012, 0.85 * h).move(x=0.02), box(0.5 * x - 0.02, 0.005, 0.85 * h)
              .move(0.26 * x + 0.007, 0.01)]  # fmt: skip
    floor = box(x, y, 0.006)
    z = 0.55 * h
    rice = block(0.5 * x, 0.88 * y, z, 0.01, 0.006).move(-0.225 * x, 0, 0.006)
    plum = ellipsoid(0.024, 0.024, 0.016, 16, 8).move(-0.22 * x, 0, z + 0.009)
    fish = [block(0.026, 0.055, 0.01, 0.008, 0.003).turn(1, -0.3).move(0.14 * x + 0.024 * k,
            0.26 * y, z) for k in range(3)]  # fmt: skip
    egg = [block(0.02, 0.03, 0.022, 0.005, 0.003).move(0.16 * x + 0.022 * k, -0.16 * y, 0.4 * z)
           for k in range(2)]  # fmt: skip
    green = scatter(look, 0.022, 9, (0.014, 0.018), z).move(0.38 * x, -0.2 * y)
    fill = box(0.36 * x, 0.86 * y, 0.75 * z).move(0.27 * x, 0, 0.006)
    return shape(
        [(join([*walls, floor]), skin),
         (rice, textures.spots(look.rng, (248, 246, 238), (226, 222, 210), 0.3)),
         (plum, textures.plain((190, 40, 56))), (join(fish), textures.plain((240, 128, 96))),
         (join(egg), textures.plain((248, 208, 80))), (green, textures.plain((96, 158, 70))),
         (fill, textures.plain((120, 150, 84)))],
        [box_part(x, y, h)],
    )  # fmt: skip


def spice_jar(look: Look) -> Shape:
    """A small glass jar of spice with a pierced or screwed lid and a label."""
    r, h = look.between(0.02, 0.025), look.between(0.085, 0.105)
    color = look.color("red", "amber", "brown", "green", "mustard", "orange", "maroon")
    word = look.pick(["PAPRIKA", "CURRY", "CUMIN", "BASIL", "CHILI", "OREGANO", "SPICE"])
    print_ = prints.label(look.rng, word, look.own_color("black", "red", "green", "navy"),
                          (246, 244, 236))  # fmt: skip
    spice = textures.spots(look.rng, color, tint_color(color, 0.75), 0.25)
    glass = textures.plain((206, 218, 222))
    tile = textures.stack((spice, 22), (print_, 40), (spice, 14), (glass, 24), side=160)
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.03 * h), (r, 0.7 * h), (0.8 * r, 0.78 * h),
                  (0, 0.78 * h)], 28, v=[0, 0.01, 0.03, 0.9, 0.98, 1])  # fmt: skip
    cap = cylinder(0.92 * r, 0.23 * h, 28, bevel=0.001).move(z=0.77 * h)
    tone = look.own_color("black", "silver", "red", "white", "green", "wooden")
    return shape([(body, tile), (cap, textures.plain(tone))], [hull_of(body), hull_of(cap)])


def spice_rack(look: Look) -> Shape:
    """A small wooden rack of two steps with spice jars in it."""
    x, y, h = look.between(0.26, 0.31), look.between(0.095, 0.11), look.between(0.2, 0.23)
    color = look.color("wooden", "brown", "tan", "black", "white")
    wood = look.surface(color, "wood")
    ends = [box(0.01, y, h).move(x=s * (x / 2 - 0.005)) for s in (-1, 1)]
    shelves = [box(x - 0.02, y, 0.008).move(z=z) for z in (0.004, 0.52 * h)]
    bars = [box(x - 0.02, 0.005, 0.018).move(y=-y / 2 + 0.0025, z=z + 0.016)
            for z in (0.004, 0.52 * h)]  # fmt: skip
    back = box(x - 0.02, 0.005, h).move(y=y / 2 - 0.0025)
    pieces = [(join([*ends, *shelves, *bars, back]), wood)]
    tones = [(184, 60, 30), (206, 150, 40), (110, 76, 44), (84, 120, 56), (150, 40, 36)]
    caps = []
    for i, z in enumerate((0.012, 0.52 * h + 0.008)):
        for k in range(5):
            u = (k - 2) * 0.185 * x
            jar = cylinder(0.02, 0.3 * h, 18).move(u, 0, z)
            pieces.append((jar, textures.plain(tones[(k + 2 * i) % 5])))
            caps.append(cylinder(0.019, 0.07 * h, 18).move(u, 0, z + 0.3 * h))
    pieces.append((join(caps), textures.plain(look.own_color("black", "silver", "white"))))
    return shape(pieces, [box_part(x, y, h)])


def pizza_box(look: Look) -> Shape:
    """A flat square cardboard box with PIZZA on its lid."""
    x, h = look.between(0.3, 0.34), look.between(0.038, 0.046)
    color = look.color("red", "green", "orange", "navy", "red")
    card = textures.speckles(look.rng, look.pick([(244, 240, 230), (206, 170, 122)]), 5)
    face = np.asarray(textures.fit(card, 160, 160)).copy()
    prints.disc(face, 0.5, 0.58, 0.27, (206, 152, 86))
    prints.disc(face, 0.5, 0.58, 0.24, (240, 196, 96))
    for a, d in ((0.2, 0.13), (1.5, 0.15), (2.7, 0.12), (3.9, 0.15), (5.2, 0.14), (0, 0)):
        prints.disc(face, 0.5 + d * np.cos(a), 0.58 + d * np.sin(a), 0.035, (190, 44, 34))
    prints.write(face, "PIZZA", 0.5, 0.17, 0.2, color, bold=True)
    body = block(x, x, h, 0.006, 0.002)
    top = box(0.97 * x, 0.97 * x, 0.001).move(z=h - 0.0004)
    flap = box(0.3 * x, 0.004, 0.6 * h).move(y=-x / 2, z=0.2 * h)
    return shape([(body, card), (top, face), (flap, textures.plain((190, 156, 112)))],
                 [box_part(x, x, h)])  # fmt: skip


def takeaway_box(look: Look) -> Shape:
    """A folded paper pail for takeaway food with a wire handle, or a clamshell box."""
    color = look.color("white", "red", "white", "tan", "black")
    if look.chance(0.6):
        x, h = look.between(0.085, 0.1), look.between(0.09, 0.105)
        unit = rectangle(1, 1, 0.05, 2)
        rings = np.stack([np.column_stack([unit * [x * k, 0.85 * x * k], np.full(len(unit), z)])
                          for k, z in ((0.72, 0), (1.0, h), (0.96, h + 0.002))])  # fmt: skip
        pail = loft(rings, unit)
        roof = prism(np.array([(-0.5 * x, 0), (0.5 * x, 0), (0.2 * x, 0.02), (-0.2 * x, 0.02)]),
                     -0.4 * x, 0.4 * x).turn(0, np.pi / 2).move(z=h)  # fmt: skip
        wire = limb(
            [
                (-0.49 * x, 0, 0.85 * h),
                (-0.44 * x, 0, h + 0.035),
                (0, 0, h + 0.052),
                (0.44 * x, 0, h + 0.035),
                (0.49 * x, 0, 0.85 * h),
            ],
            [0.0012] * 5,
            6,
        )
        face = prints.canvas(96, 96, color)
        ink = (196, 42, 40) if sum(color) > 380 else (250, 240, 220)
        prints.disc(face, 0.5, 0.52, 0.26, ink)
        prints.polygon(face, [(0.3, 0.55), (0.5, 0.3), (0.7, 0.55)], color)
        prints.fill(face, 0.38, 0.55, 0.24, 0.12, color)
        front = box(0.6 * x, 0.001, 0.6 * h)
        lean = np.arctan2(0.14 * 0.85 * x, h)
        front = front.turn(0, lean).move(y=-0.36 * 0.85 * x - 0.0006, z=0.16 * h)
        front = front.move(y=-0.14 * 0.85 * x * 0.16)
        return shape([(pail, textures.speckles(look.rng, color, 4)), (roof, textures.plain(
            tint_color(color, 0.9))), (wire, textures.plain((180, 184, 190))), (front, face)],
            [hull_of(pail), hull_of(roof), hull_of(wire)])  # fmt: skip
    x, h = look.between(0.15, 0.18), look.between(0.06, 0.075)
    unit = rectangle(1, 1, 0.12, 4)
    rings = np.stack([np.column_stack([unit * x * k, np.full(len(unit), z)]) for k, z in (
        (0.86, 0), (0.98, 0.5 * h - 0.003), (1.03, 0.5 * h - 0.003), (1.03, 0.5 * h + 0.003),
        (0.98, 0.5 * h + 0.003), (0.8, h))])  # fmt: skip
    body = loft(rings, unit)
    tab = box(0.03, 0.012, 0.005).move(0, -0.52 * x, 0.5 * h - 0.0025)
    return shape([(body, textures.speckles(look.rng, color, 4)),
                  (tab, textures.plain(tint_color(color, 0.85)))], [hull_of(body)])  # fmt: skip


def storage_jar(look: Look) -> Shape:
    """A canister with a tight lid, FLOUR or the like on its front."""
    r, h = look.between(0.05, 0.06), look.between(0.14, 0.18)
    color = look.color("white", "cream", "sage", "silver", "red", "navy", "terracotta")
    word = look.pick(["FLOUR", "SUGAR", "RICE", "OATS", "PASTA", "COFFEE"])
    image = prints.canvas(256, 128, color)
    prints.write(image[:, 88:168], word, 0.5, 0.5, 0.22, readable_on(color), bold=True)
    body = cylinder(r, 0.86 * h, 36, bevel=0.003)
    wood = look.surface(look.own_color("wooden", "tan", "black"), "wood")
    lid = cylinder(1.02 * r, 0.12 * h, 36, bevel=0.003).move(z=0.86 * h)
    return shape([(body, image), (lid, wood)], [cylinder_part(r, 0.86 * h), hull_of(lid)])


_K = ("kitchen",)
CATEGORIES = (
    Category("crate", crate, (0.31, 0.225, 0.125), 0.9, ("wooden crate", "fruit crate",
             "apple crate", "vegetable crate", "produce crate", "wine crate", "milk crate"), _K,
             ("container", "big"), ("wooden",)),
    Category("bread_box", bread_box, (0.356, 0.242, 0.185), 2.2, ("bread bin", "breadbox",
             "breadbin"), _K, ("big",), ("cream", "silver")),
    Category("cookie_jar", cookie_jar, (0.164, 0.165, 0.171), 0.9, ("biscuit jar", "jar of cookies",
             "biscuit tin", "biscuit barrel", "cookie tin", "easter tin"), _K, ("round", "tall"),
             ("white", "red")),
    Category("cool_box", cool_box, (0.394, 0.254, 0.216), 2.2, ("cooler", "coolbox", "ice chest",
             "cooler box", "ice box"), _K, ("big",), ("blue", "red")),
    Category("lunch_box", lunch_box, (0.223, 0.118, 0.172), 0.5, ("lunchbox", "lunch pail",
             "lunch tin", "vintage lunch box"), ("office", "kitchen"), (), ("red", "blue")),
    Category("bento_box", bento_box, (0.225, 0.163, 0.0482), 0.6, ("bento", "japanese lunch box",
             "airline meal"), ("dining",), ("edible",), ("black", "red")),
    Category("spice_jar", spice_jar, (0.0446, 0.0446, 0.0949), 0.12, ("spice bottle",
             "jar of spices", "spice", "paprika", "cinnamon", "spice shaker", "spice tin",
             "jar of paprika", "herb jar", "jar of spice", "hundreds and thousands pot",
             "sprinkles pot", "pot of sprinkles", "jar of sprinkles", "masala jar", "paprika tin",
             "fennel seed jar", "mustard seed jar", "cumin jar", "turmeric jar", "nutmeg jar",
             "saffron jar"), _K, ("round", "tall"), ("red", "amber")),
    Category("spice_rack", spice_rack, (0.28, 0.102, 0.21), 1.6, ("spice shelf", "rack of spices",
             "spice holder"), _K, ("tall", "big"), ("wooden",)),
    Category("pizza_box", pizza_box, (0.323, 0.325, 0.0403), 0.35, ("pizza carton", "box of pizza",
             "boxed pizza"), ("dining",), ("flat", "support", "big"), ("red",), state="lying flat"),
    Category("takeaway_box", takeaway_box, (0.112, 0.103, 0.129), 0.3, ("takeout box",
             "take out box", "chinese takeout", "takeaway container", "takeout container",
             "noodle box", "to go box", "take away box", "chinese takeaway", "doggy bag",
             "chinese takeout box"), ("dining",), (), ("white", "red")),
    Category("storage_jar", storage_jar, (0.112, 0.112, 0.156), 0.7, ("flour jar", "canister",
             "kitchen canister", "rice jar", "pasta jar", "flour canister", "sugar canister"), _K,
             ("round", "tall"), ("white",)),
)  # fmt: skip
"""The module's categories."""
