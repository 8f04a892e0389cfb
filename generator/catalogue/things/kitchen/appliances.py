"""Small electric appliances of a kitchen: microwave, hot plate, blender, cookers, mixer, scale."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import facing
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

DARK: RGB = (40, 42, 46)
SHELLS = ("silver", "white", "black", "red", "cream", "mint", "sky")


def _time(look: Look) -> str:
    return f"{int(look.rng.integers(1, 13))}:{int(look.rng.integers(60)):02d}"


def microwave(look: Look) -> Shape:
    """A microwave oven: a dark window in its door, a handle, a clock and keys or two dials."""
    x, y, h = look.between(0.42, 0.5), look.between(0.3, 0.36), look.between(0.24, 0.29)
    color = look.color(*SHELLS)
    shell = look.surface(color, "metal" if look.chance(0.3) else "plastic")
    face = prints.canvas(240, 144, tint_color(color, 0.92) if look.chance(0.5) else DARK)
    ground = tuple(float(c) for c in face[0, 0])
    prints.fill(face, 0.05, 0.12, 0.62, 0.76, (22, 23, 26))
    prints.fill(face, 0.1, 0.2, 0.52, 0.6, (58, 56, 54))
    prints.polygon(face, [(0.14, 0.8), (0.3, 0.2), (0.36, 0.2), (0.2, 0.8)], (84, 84, 84))
    prints.fill(face, 0.745, 0, 0.008, 1, tint_color(ground, 0.5))  # type: ignore[arg-type]
    prints.fill(face, 0.79, 0.08, 0.17, 0.14, (14, 24, 18))
    prints.write(face[:, 188:232], _time(look), 0.5, 0.15, 0.09, (120, 240, 150), bold=True)
    dials = look.chance(0.4)
    if not dials:
        for k in range(12):
            prints.fill(face, 0.785 + 0.062 * (k % 3), 0.3 + 0.12 * (k // 3), 0.05, 0.085,
                        (206, 208, 212) if sum(ground) < 300 else (96, 98, 104))  # fmt: skip
        prints.fill(face, 0.785, 0.82, 0.174, 0.1, (90, 190, 110))
    front = box(x, 0.008, h).move(y=-y / 2 - 0.004, z=0.008)
    grip = tube(smooth([(0.19 * x, -y / 2, 0.2 * h), (0.19 * x, -y / 2 - 0.035, 0.26 * h),
                        (0.19 * x, -y / 2 - 0.035, 0.86 * h), (0.19 * x, -y / 2, 0.92 * h)], 3),
                0.007, 8)  # fmt: skip
    feet = [cylinder(0.014, 0.01, 12).move(sx * 0.4 * x, sy * 0.38 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    pieces = [(box(x, y, h).move(z=0.008), shell), (front, face),
              (join(feet), textures.plain(DARK)),
              (grip, textures.brushed_metal(
                  look.rng, look.own_color("silver", "charcoal")))]  # fmt: skip
    if dials:
        knob = facing(cylinder(0.026, 0.02, 24, top=0.022, bevel=0.002))
        pieces += [(knob.move(0.375 * x, -y / 2 - 0.007, z * h), textures.plain((200, 202, 206)))
                   for z in (0.28, 0.56)]  # fmt: skip
    return shape(pieces, [box_part(0.84 * x, 0.8 * y, 0.01), box_part(x, y + 0.008, h,
                                                                      (0, -0.004, 0.008)),
                          hull_of(grip)])  # fmt: skip


def _burner(look: Look, kind: str, r: float, z: float) -> list[tuple[Solid, textures.Tile]]:
    """Return a burner of radius ``r`` whose underside is at height ``z``."""
    dark = textures.plain((34, 35, 38))
    if kind == "coil":
        hot = look.pick([(52, 50, 50), (52, 50, 50), (206, 62, 34)])
        bowl = cylinder(1.08 * r, 0.003, 32).move(z=z)
        coils = join([torus(r * k, 0.0055, 30, 8).move(z=z + 0.007) for k in (0.3, 0.6, 0.92)])
        return [
            (bowl, textures.brushed_metal(look.rng, (186, 188, 192))),
            (coils, textures.plain(hot)),
        ]
    if kind == "gas":
        cap = [cylinder(0.46 * r, 0.01, 26, bevel=0.002), cylinder(0.3 * r, 0.016, 26, bevel=0.002)]
        bars = [box(2.1 * r, 0.008, 0.009).turn(2, a).move(z=0.018) for a in (0, np.pi / 2)]
        posts = [box(0.008, 0.008, 0.02).move(1.02 * r * c, 1.02 * r * s)
                 for c, s in ((1, 0), (-1, 0), (0, 1), (0, -1))]  # fmt: skip
        ring = torus(0.86 * r, 0.004, 30, 6).move(z=0.022)
        return [(join(cap).move(z=z), textures.plain((70, 72, 78))),
                (join([*bars, *posts, ring]).move(z=z), dark)]  # fmt: skip
    disc = cylinder(r, 0.012, 34, bevel=0.002).move(z=z)
    mark = torus(0.55 * r, 0.0012, 30, 5).move(z=z + 0.0115)
    iron = textures.speckles(look.rng, (44, 44, 48), 4)
    return [(disc, iron), (mark, textures.plain((90, 90, 90)))]


def stove(look: Look) -> Shape:
    """A table-top stove with one or two burners and its knobs in front."""
    count, kind = look.pick([1, 1, 2]), look.pick(["plate", "plate", "coil", "gas"])
    r = look.between(0.08, 0.095)
    x, y, h = 0.3 if count == 1 else 0.47, look.between(0.28, 0.31), look.between(0.06, 0.08)
    color = look.color("white", "silver", "black", "cream", "red", "charcoal")
    skin = look.surface(color, "metal")
    body = block(x, y, h - 0.01, 0.016, 0.005).move(z=0.01)
    feet = [cylinder(0.013, 0.012, 12).move(sx * 0.4 * x, sy * 0.4 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    pieces = [(body, skin), (join(feet), textures.plain(DARK))]
    at = [0.0] if count == 1 else [-0.115, 0.115]
    burners = [(solid.move(x=u, y=0.025), tile) for u in at
               for solid, tile in _burner(look, kind, r, h - 0.001)]  # fmt: skip
    knob = facing(join([cylinder(0.021, 0.018, 22, bevel=0.002),
                          box(0.008, 0.034, 0.026)]))  # fmt: skip
    ink = textures.plain(look.pick([DARK, DARK, (206, 208, 212), (196, 42, 40)]))
    if sum(color) < 200:
        ink = textures.plain((206, 208, 212))
    knobs = [knob.move(u if count == 2 else 0.2 * x, -y / 2, 0.5 * h) for u in at]
    lamp = box(0.012, 0.002, 0.006).move(-0.2 * x if count == 1 else 0, -y / 2, 0.5 * h)
    pieces += [*burners, (join(knobs), ink), (lamp, textures.plain((220, 60, 40)))]
    plates = [hull_of(*(s for s, _ in burners[2 * k : 2 * k + 2])) for k in range(count)]
    return shape(pieces, [box_part(0.84 * x, 0.84 * y, 0.012), hull_of(body), *plates,
                          *(hull_of(k) for k in knobs)])  # fmt: skip


def blender(look: Look) -> Shape:
    """A blender: motor base with buttons or a dial, a jug with a scale and a handle, a lid."""
    r, h = look.between(0.068, 0.078), look.between(0.34, 0.4)
    color = look.color("silver", "black", "red", "white", "cream", "mint", "charcoal")
    skin, dark = look.surface(color, look.pick(["metal", "plastic"])), textures.plain(DARK)
    z = 0.36 * h
    sides = look.pick([28, 28, 4])
    grow = 1.12 if sides == 4 else 1.0
    base = lathe([(0, 0), (1.1 * r * grow, 0), (1.1 * r * grow, 0.02), (0.84 * r * grow, 0.82 * z),
                  (0.7 * r * grow, z), (0, z)], sides)  # fmt: skip
    jug = lathe([(0, z), (0.66 * r, z), (0.7 * r, z + 0.02), (r, 0.9 * h), (0, 0.9 * h)], 26,
                v=[0, 0.01, 0.05, 0.99, 1])  # fmt: skip
    clear, juice = (206, 218, 222), look.own_color("pink", "orange", "green", "purple", "red")
    glass = prints.canvas(128, 128, clear)
    if look.chance(0.55):
        prints.fill(glass, 0, look.between(0.25, 0.6), 1, 1, juice)
    for k in range(7):
        prints.fill(glass, 0.5, 0.2 + 0.1 * k, 0.04 if k % 2 else 0.07, 0.014, (250, 250, 250))
    lid = lathe([(0, 0.9 * h), (1.02 * r, 0.9 * h), (1.0 * r, 0.945 * h), (0.42 * r, 0.95 * h),
                 (0.4 * r, h), (0, h)], 26)  # fmt: skip
    ear = tube(smooth([(0.9 * r, 0, 0.86 * h), (1.6 * r, 0, 0.84 * h), (1.56 * r, 0, 0.56 * h),
                       (0.76 * r, 0, 0.47 * h)], 4), 0.01, 8)  # fmt: skip
    front = facing(block(0.9 * r, 0.34 * z, 0.03, 0.006, 0.002)).move(y=-0.97 * r, z=0.36 * z)
    panel = prints.canvas(96, 48, DARK)
    for k in range(4):
        prints.disc(panel, 0.17 + 0.22 * k, 0.5, 0.17, (214, 216, 220) if k else (220, 60, 50))
    ring = torus(0.69 * r, 0.004, 28, 6).move(z=z)
    turn = 0.0 if sides == 28 else np.pi / 4
    return shape(
        [(base.turn(2, turn), skin), (jug, glass), (join([lid, ear, ring]), dark),
         (front, panel)],
        [hull_of(base.turn(2, turn)), hull_of(jug), hull_of(lid),
         box_part(0.7 * r, 0.02, 0.36 * h, (1.27 * r, 0, 0.48 * h))],
    )  # fmt: skip


def rice_cooker(look: Look) -> Shape:
    """A rice cooker: a bellied pot with a domed lid, a handle over it and a switch in front."""
    r, h = look.between(0.115, 0.135), look.between(0.17, 0.2)
    color = look.color("white", "white", "red", "silver", "black", "pink", "mint", "cream")
    skin = look.surface(color, "plastic")
    trim = textures.plain(look.own_color("silver", "charcoal", "gold", "gray"))
    body = lathe([(0, 0), (0.8 * r, 0), (0.93 * r, 0.08 * h), (r, 0.4 * h), (0.97 * r, 0.74 * h),
                  (0, 0.74 * h)], 32)  # fmt: skip
    band = torus(0.965 * r, 0.005, 34, 6).move(z=0.74 * h)
    lid = lathe([(0, 0.745 * h), (0.96 * r, 0.745 * h), (0.9 * r, 0.86 * h), (0.6 * r, 0.97 * h),
                 (0, h)], 32)  # fmt: skip
    vent = cylinder(0.014, 0.012, 16, bevel=0.002).move(y=0.4 * r, z=0.94 * h)
    a = np.linspace(0.12, np.pi - 0.12, 13)
    bail = tube(
        np.column_stack(
            [1.04 * r * np.cos(a), np.full(13, 0.1 * r), 0.66 * h + 0.5 * h * np.sin(a)]
        ),
        0.008,
        8,
        squash=0.6,
    )
    if look.chance(0.4):
        bail = tube([(-0.045, 0, 0.985 * h), (-0.04, 0, 1.1 * h), (0.04, 0, 1.1 * h),
                     (0.045, 0, 0.985 * h)], 0.008, 8)  # fmt: skip
    panel = prints.canvas(96, 72, (232, 232, 230) if sum(color) < 560 else (72, 76, 84))
    ink = readable_on(tuple(float(c) for c in panel[0, 0]))  # type: ignore[arg-type]
    prints.write(panel, look.pick(["COOK", "RICE", "WARM"]), 0.5, 0.22, 0.2, ink, bold=True)
    prints.disc(panel, 0.3, 0.55, 0.1, (240, 130, 40))
    prints.disc(panel, 0.7, 0.55, 0.1, (90, 190, 110))
    prints.fill(panel, 0.3, 0.76, 0.4, 0.16, (196, 60, 50))
    front = facing(block(0.09, 0.075, 0.02, 0.012, 0.003)).move(y=-0.9 * r, z=0.34 * h)
    ears = [box(0.03, 0.06, 0.014).move(s * (r + 0.006), 0, 0.66 * h) for s in (-1, 1)]
    return shape(
        [(body, skin), (lid, skin), (join([band, bail]), trim), (front, panel),
         (join([vent, *ears]), textures.plain(DARK))],
        [hull_of(body), hull_of(lid), hull_of(front), *(hull_of(e) for e in ears)],
    )  # fmt: skip


def stand_mixer(look: Look) -> Shape:
    """A stand mixer, its head to the left over a steel bowl."""
    k = look.between(0.92, 1.08)
    color = look.color("red", "mint", "cream", "black", "silver", "pink", "sky", "white", "teal")
    skin, steel = look.surface(color, "plastic"), textures.brushed_metal(look.rng, (190, 193, 198))
    foot = block(0.33 * k, 0.2 * k, 0.035 * k, 0.06, 0.01)
    neck = block(0.09 * k, 0.11 * k, 0.24 * k, 0.03, 0.006).move(x=0.11 * k, z=0.02 * k)
    t = np.linspace(-1, 1, 15)
    wide = (1 - np.abs(t) ** 4) ** 0.4 * (0.9 - 0.12 * t)
    head = lathe([(max(w, 0.0), u) for w, u in zip(wide, t, strict=True)], 24)
    head = head.scale(0.062 * k, 0.066 * k, 0.17 * k).turn(1, np.pi / 2)
    head = head.move(x=-0.012 * k, z=0.3 * k)
    band = lathe([(0.2, -0.012), (0.98, -0.012), (0.98, 0.012), (0.2, 0.012)], 24, loop=True)
    band = band.scale(0.062 * k, 0.067 * k, 1).turn(1, np.pi / 2).move(x=-0.04 * k, z=0.3 * k)
    side = [(0.05 * k, 0), (0.085 * k, 0.03 * k), (0.1 * k, 0.08 * k), (0.105 * k, 0.125 * k)]
    inner = [(r - 0.003, max(z, 0.005)) for r, z in side[::-1]]
    bowl = lathe([(0, 0), *side, *inner, (0, 0.005)], 30).move(x=-0.07 * k, z=0.034 * k)
    shaft = cylinder(0.012 * k, 0.06 * k, 14).move(x=-0.07 * k, z=0.19 * k)
    beater = lathe(
        [(0, 0), (0.012, 0.004), (0.032, 0.05), (0.03, 0.07), (0.006, 0.1), (0, 0.1)], 16
    )
    beater = beater.scale(k, 0.3 * k, k).move(x=-0.07 * k, z=0.1 * k)
    lever = facing(cylinder(0.012, 0.02, 16, bevel=0.002)).move(0.05 * k, -0.06 * k, 0.29 * k)
    return shape(
        [(join([foot, neck, head]), skin), (join([bowl, shaft, band, beater]), steel),
         (lever, textures.plain(DARK))],
        [hull_of(foot), hull_of(neck), hull_of(head), hull_of(bowl)],
    )  # fmt: skip


def kitchen_scale(look: Look) -> Shape:
    """A kitchen scale: a flat digital one, or one with a dial and a pan."""
    color = look.color("white", "black", "silver", "red", "mint", "sky", "cream")
    if look.chance(0.6):
        x, y, h = look.between(0.16, 0.18), look.between(0.2, 0.23), look.between(0.018, 0.026)
        face = prints.canvas(128, 160, color)
        prints.disc(face, 0.5, 0.4, 0.3, tint_color(color, 0.85), 0.285)
        prints.fill(face, 0.26, 0.78, 0.48, 0.14, (182, 198, 176))
        grams = f"{int(look.rng.integers(0, 999))} g"
        prints.write(face[:, 36:92], grams, 0.5, 0.855, 0.09, (36, 40, 36), bold=True)
        for u in (0.14, 0.86):
            prints.disc(face, u, 0.855, 0.04, tint_color(color, 0.6))
        body = block(x, y, h, 0.02, 0.003)
        top = block(x - 0.008, y - 0.008, 0.001, 0.018).move(z=h - 0.0004)
        plate = cylinder(0.42 * x, 0.008, 36, bevel=0.001).move(y=0.1 * y, z=h)
        steel = textures.brushed_metal(look.rng, (192, 194, 198))
        return shape(
            [(body, look.surface(color)), (top, face), (plate, steel)],
            [box_part(x, y, h), cylinder_part(0.42 * x, 0.008, (0, 0.1 * y, h))],
        )
    k = look.between(0.92, 1.08)
    body = lathe([(0, 0), (0.1 * k, 0), (0.1 * k, 0.02), (0.07 * k, 0.1 * k), (0.03 * k, 0.15 * k),
                  (0, 0.15 * k)], 4).turn(2, np.pi / 4)  # fmt: skip
    dial = facing(cylinder(0.048 * k, 0.02, 32, bevel=0.002)).turn(0, -0.26)
    dial = dial.move(y=-0.045 * k, z=0.068 * k)
    face = prints.clock_face(look.rng, (248, 248, 244), (40, 40, 44))
    pan = lathe([(0, 0), (0.06, 0), (0.1, 0.03), (0.097, 0.032), (0.058, 0.004), (0, 0.004)], 32)
    pan = pan.scale(k, k, 1).move(z=0.149 * k)
    return shape(
        [
            (body, look.surface(color)),
            (dial, face),
            (pan, textures.brushed_metal(look.rng, (192, 194, 198))),
        ],
        [hull_of(body), hull_part(pan.vertices[pan.vertices[:, 2] < 0.17 * k])],
    )


CATEGORIES = (
    Category("microwave", microwave, (0.46, 0.37, 0.274), 11.0, ("microwave oven",
             "countertop microwave"), ("kitchen",), ("big",), ("white", "silver")),
    Category("stove", stove, (0.385, 0.316, 0.0865), 2.6, ("hot plate", "hotplate",
                 "portable stove", "flat stove", "toy stove", "cooktop", "hob",
                 "electric stove", "gas stove", "cooker", "camping stove", "stovetop",
                 "plate warmer", "burner", "hot plate stirrer", "magnetic stirrer",
                 "hotplate stirrer"), ("kitchen",),
             ("big", "support"), ("white", "silver")),
    Category("blender", blender, (0.213, 0.181, 0.374), 2.4, ("smoothie maker", "mixer jug",
             "smoothie blender"), ("kitchen",), ("tall", "big"), ("silver",
             "black")),
    Category("rice_cooker", rice_cooker, (0.299, 0.265, 0.222), 2.2, ("multi cooker",
                 "electric steamer", "food steamer", "vegetable steamer"),
             ("kitchen",), ("big",), ("white",
             "red")),
    Category("stand_mixer", stand_mixer, (0.34, 0.21, 0.36), 7.0, ("food mixer", "kitchen mixer",
             "mixer", "cake mixer"), ("kitchen",), ("tall", "big"), ("red", "mint")),
    Category("kitchen_scale", kitchen_scale, (0.176, 0.216, 0.0503), 0.6, ("scale",
             "weighing scale", "digital scale", "food scale", "kitchen scales", "scales",
             "electronic scale"), ("kitchen",), ("support",), ("white", "black")),
)  # fmt: skip
"""The module's categories."""
