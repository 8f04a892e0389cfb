"""Objects of the ``living`` theme: tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import steel
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part
from ...kit.primitives import at_box, ball, drum, limb, lobe, plate, rod, straight
from ...kit.shapes import Pieces, Shape, category, put_down, settle, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    join,
    lathe,
    loft,
    open_box,
    prism,
    sweep,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, plain, tint_color


@category("watering_can", size=(0.235, 0.115, 0.18), mass=0.4, material="metal", hollow=True,
          aliases=("garden can", "plant waterer", "small watering can"), themes=("living",),
          roles=("tall",), colors=("green", "silver"))  # fmt: skip
def watering_can(look: Look) -> Shape:
    """A watering can with handles on the right and on top, and a spout with a rose on the left."""
    k = look.between(0.85, 1.1)
    color = look.color("green", "teal", "silver", "copper", "red", "yellow", "sky", "white", "pink")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    r, h = 0.058 * k, 0.125 * k
    body = lathe(
        [(0, 0), (r, 0), (0.94 * r, h), (0.9 * r, h), (0.9 * r, 0.8 * h), (0, 0.8 * h)], 30
    )
    around = np.linspace(-np.pi / 2, np.pi / 2, 13)
    half = 0.9 * r * np.column_stack([np.cos(around), np.sin(around)])
    top = prism(half, h - 0.002, h + 0.001)
    spout = tube([(-0.7 * r, 0, 0.16 * h), (-1.5 * r, 0, 0.7 * h), (-2.05 * r, 0, 1.12 * h)],
                 [0.017 * k, 0.011 * k, 0.009 * k], 12)  # fmt: skip
    way = np.arctan2(-0.55 * r, 0.42 * h)
    rose = lathe([(0, 0), (0.008, 0), (0.023, 0.02), (0.021, 0.024), (0, 0.026)], 20).scale(k, k, k)
    rose = rose.turn(1, way).move(-2.0 * r, 0, 1.09 * h)
    brace = tube([(-0.85 * r, 0, 0.9 * h), (-1.62 * r, 0, 0.82 * h)], 0.004 * k, 7)
    bail = sweep(smooth([(-0.55 * r, 0, 0.97 * h), (-0.2 * r, 0, 1.36 * h), (0.7 * r, 0, 1.4 * h),
                         (1.5 * r, 0, 0.95 * h), (1.42 * r, 0, 0.4 * h), (0.93 * r, 0, 0.22 * h)],
                        4), rectangle(0.013 * k, 0.008 * k, 0.003, 2))  # fmt: skip
    rim = torus(0.94 * r, 0.003, 30, 6).move(z=h)
    dark = surfaces.plain(tint_color(color, 0.75))
    x = bail.vertices[:, 0]
    return shape(
        [(join([body, top, spout, brace]), skin), (join([rim, rose]), dark), (bail, skin)],
        [hull_of(body), hull_of(spout), hull_of(rose),
         hull_part(bail.vertices[(x < 0.75 * r)]), hull_part(bail.vertices[x > 0.6 * r])],
    )  # fmt: skip


@category("garden_trowel", size=(0.33, 0.082, 0.032), mass=0.2, material="metal", aliases=("trowel",
          "hand trowel", "garden shovel", "small shovel", "hand shovel", "garden spade", "shovel",
          "trowel set"), themes=("living",), colors=("green", "wooden"),
          state="lying flat")  # fmt: skip
def garden_trowel(look: Look) -> Shape:
    """A garden trowel lying flat with its hollow blade on the left."""
    k = look.between(0.9, 1.1)
    color = look.color("green", "red", "wooden", "black", "orange", "teal", "yellow")
    steel = surfaces.scratches(look.rng, (170, 174, 180), (196, 198, 202), 30)
    t = np.linspace(0, 1, 9)
    wide = 0.041 * k * np.array([0.06, 0.5, 0.78, 0.93, 1.0, 1.0, 0.96, 0.86, 0.6])
    rings = []
    for u, w in zip(t, wide, strict=True):
        x = (-0.15 + 0.145 * u) * k
        lane = np.linspace(-1, 1, 7)
        bow = 0.017 * k * lane**2 * min(w / (0.02 * k), 1) + 0.004 * k * u
        upper = np.column_stack([np.full(7, x), lane * w, bow + 0.0022])
        lower = np.column_stack([np.full(7, x), lane[::-1] * w, bow[::-1]])
        rings.append(np.concatenate([lower, upper]))
    flat = np.concatenate([np.column_stack([np.linspace(1, -1, 7), np.zeros(7)]),
                           np.column_stack([np.linspace(-1, 1, 7), np.full(7, 0.1)])])  # fmt: skip
    scoop = loft(np.stack(rings), flat[::-1])
    neck = tube(smooth([(-0.02 * k, 0, 0.007 * k), (0.02 * k, 0, 0.022 * k),
                        (0.06 * k, 0, 0.016 * k)], 4), 0.0055 * k, 8)  # fmt: skip
    grip = lathe([(0, 0), (0.011, 0), (0.0145, 0.03), (0.012, 0.08), (0.0155, 0.118), (0.009, 0.13),
                  (0, 0.13)], 18).scale(k, k, k)  # fmt: skip
    grip = grip.turn(1, np.pi / 2).move(x=0.05 * k, z=0.0155 * k)
    return shape([(scoop, steel), (neck, steel), (grip, look.surface(color, "wood"))],
                 [hull_of(scoop), hull_of(neck), hull_of(grip)])  # fmt: skip


STEEL = (150, 154, 160)


def _hand_tool(look: Look, kind: str) -> Shape:
    """Return a garden hand fork or rake lying flat with its tines on the left."""
    color = look.color("green", "wooden", "red", "orange", "teal", "brown", "black")
    handle = look.surface(color, look.pick(["wood", "plastic"]) if color[0] > 150 else "plastic")
    steel = surfaces.brushed_metal(look.rng, STEEL)
    grip = rod([(0.03, 0, 0.0135), (0.08, 0, 0.0135), (0.13, 0, 0.0135), (0.155, 0, 0.0135)],
               [0.0115, 0.0135, 0.0125, 0.0105], 12)  # fmt: skip
    neck = rod([(0.035, 0, 0.0135), (-0.01, 0, 0.017), (-0.045, 0, 0.012)], 0.005, 8)
    if kind == "fork":
        tines = [rod([(-0.04, 0.02 * n, 0.012), (-0.09, 0.021 * n, 0.006),
                      (-0.135, 0.02 * n, 0.003)], [0.0042, 0.0038, 0.0012], 7)
                 for n in (-1, 0, 1)]  # fmt: skip
        bar = straight((-0.042, -0.022, 0.012), (-0.042, 0.022, 0.012), 0.0045)
    else:
        tines = [rod([(-0.07, 0.015 * n, 0.024), (-0.1, 0.019 * n, 0.024), (-0.108, 0.02 * n, 0.0)],
                     [0.003, 0.003, 0.0018], 7) for n in (-2, -1, 0, 1, 2)]  # fmt: skip
        fan = [rod([(-0.04, 0, 0.012), (-0.055, 0.009 * n, 0.02), (-0.072, 0.015 * n, 0.024)],
                   0.003, 7) for n in (-2, -1, 0, 1, 2)]  # fmt: skip
        bar = join([straight((-0.07, -0.03, 0.024), (-0.07, 0.03, 0.024), 0.0035), *fan])
    pieces: Pieces = [(grip, handle), (join([neck, bar, *tines]), steel)]
    return put_down(pieces, grip, neck, join([bar, *tines]), factor=look.between(0.9, 1.12))


@category("hand_fork", size=(0.29, 0.05, 0.027), mass=0.18, material="metal", assembled=True,
          aliases=("garden fork", "weeding fork", "gardening fork", "garden hand fork", "dibber"),
          themes=("living",), colors=("green", "wooden"), state="lying flat")  # fmt: skip
def hand_fork(look: Look) -> Shape:
    """A garden hand fork with three tines."""
    return _hand_tool(look, "fork")


@category("hand_rake", size=(0.265, 0.085, 0.027), mass=0.18, material="metal", assembled=True,
          aliases=("rake", "garden rake", "cultivator", "mini rake", "zen rake", "small rake"),
          themes=("living",), colors=("green",), state="lying flat")  # fmt: skip
def hand_rake(look: Look) -> Shape:
    """A small rake or cultivator with five tines."""
    return _hand_tool(look, "rake")


@category("secateurs", size=(0.197, 0.061, 0.015), mass=0.22, material="metal", assembled=True,
          aliases=("pruning shears", "pruner", "garden shears", "garden scissors", "hand pruner",
          "clippers", "garden clippers", "pair of secateurs", "pair of pruning shears"),
          themes=("living",), colors=("red", "green"), state="lying flat")  # fmt: skip
def secateurs(look: Look) -> Shape:
    """Slightly open secateurs lying flat, with curved blades on the left and coloured grips."""
    color = look.color("red", "orange", "green", "yellow", "black", "teal")
    skin = surfaces.speckles(look.rng, color, 4)
    blade = prism([(0.012, -0.008), (0.012, 0.008), (-0.004, 0.014), (-0.03, 0.016), (-0.06, 0.007),
                   (-0.07, 0.001), (-0.04, -0.002), (-0.008, -0.006)], 0.007, 0.011)  # fmt: skip
    hook = prism([(-0.012, -0.004), (-0.035, -0.005), (-0.056, 0.003), (-0.06, -0.001),
                  (-0.042, -0.017), (-0.015, -0.02), (0.012, -0.012), (0.012, 0.008),
                  (0.0, 0.008)], 0.003, 0.0068)  # fmt: skip
    pin = cylinder(0.0085, 0.013, 16).move(z=0.002)
    grips = [rod([(0.005, -s * 0.006, 0.0075), (0.04, s * 0.017, 0.0075), (0.08, s * 0.023, 0.0075),
                  (0.125, s * 0.014, 0.0075)], [0.006, 0.0075, 0.0075, 0.006], 10)
             for s in (-1, 1)]  # fmt: skip
    steel = surfaces.brushed_metal(look.rng, (190, 194, 200))
    coil = join(
        [
            cylinder(0.006, 0.002, 12)
            .turn(0, np.pi / 2)
            .move(0.035, 0.004 + 0.0035 * n - 0.006, 0.0075)
            for n in range(4)
        ]
    )
    pieces: Pieces = [(join([blade, pin, coil]), steel), (hook, surfaces.plain((70, 72, 78))),
                      (join(grips), skin)]  # fmt: skip
    return put_down(pieces, join([hook, blade, pin]), *grips, factor=look.between(0.9, 1.1))


@category("plant_label", size=(0.126, 0.019, 0.0026), mass=0.003, material="plastic",
          aliases=("plant marker", "plant tag", "garden marker", "garden label", "seedling label"),
          themes=("living",), roles=("flat",), colors=("white", "wooden"),
          state="lying flat")  # fmt: skip
def plant_label(look: Look) -> Shape:
    """A plant label lying flat: a pointed stake with a name."""
    color = look.color("white", "wooden", "yellow", "green", "tan")
    outline = np.array([(-0.06, 0), (-0.04, -0.009), (0.055, -0.009), (0.06, -0.005), (0.06, 0.005),
                        (0.055, 0.009), (-0.04, 0.009)])  # fmt: skip
    body = prism(outline, 0, 0.0022)
    sign = prints.canvas(128, 24, color)
    prints.write(sign, look.pick(["BASIL", "MINT", "TOMATO", "ROSE", "THYME", "PEAS"]), 0.5, 0.5,
                 0.7, (40, 60, 40), bold=True)  # fmt: skip
    face = box(0.075, 0.015, 0.0005).move(0.015, 0, 0.002)
    return put_down([(body, look.surface(color, "plastic")), (face, sign)], body,
                   factor=look.between(0.85, 1.25))  # fmt: skip


@category("seed_tray", size=(0.18, 0.12, 0.085), mass=0.5, material="plastic",
          aliases=("seedling tray", "tray of seedlings", "seedling pot", "propagator",
          "starter tray", "coir pellet"), themes=("living",), colors=("black",))  # fmt: skip
def seed_tray(look: Look) -> Shape:
    """A tray of seedlings: six cells of soil with two leaves in each."""
    color = look.color("black", "green", "brown", "terracotta", "charcoal")
    x, y, h = look.between(0.16, 0.2), look.between(0.11, 0.13), 0.05
    walls = open_box(x, y, h, 0.004, 0.004)
    bars = [box(0.004, y - 0.008, h - 0.006).move((n - 1.5) * x / 3, 0, 0.003)
            for n in (1, 2)]  # fmt: skip
    bars.append(box(x - 0.008, 0.004, h - 0.006).move(0, 0, 0.003))
    soil = box(x - 0.006, y - 0.006, h - 0.014).move(z=0.003)
    shoots: list[Solid] = []
    tops: list[Solid] = []
    for i in (-1, 0, 1):
        for j in (-1, 1):
            tall = look.between(0.02, 0.04)
            at = (i * x / 3, j * y / 4)
            shoots.append(straight((*at, h - 0.014), (*at, h + tall - 0.01), 0.0015, 6))
            turn = look.between(0, 3)
            tops += [ball(0.024, 0.012, 0.003, (0.011, 0, 0), 10).turn(1, -0.4).turn(2, turn + a)
                     .move(*at, h + tall - 0.012) for a in (0, np.pi)]  # fmt: skip
    earth = surfaces.speckles(look.rng, (76, 56, 42), 26)
    pieces: Pieces = [(join([*walls, *bars]), look.surface(color, "plastic")), (soil, earth),
                      (join([*shoots, *tops]), surfaces.plain(look.own_color("green",
                                                                             "lime")))]  # fmt: skip
    return shape(pieces, [box_part(x, y, h), hull_of(join(tops))])


@category("hose_nozzle", size=(0.155, 0.125, 0.04), mass=0.15, material="plastic",
          aliases=("spray nozzle", "garden hose nozzle", "hose gun", "garden nozzle",
          "hose sprayer", "sprinkler"), themes=("living",), colors=("green", "yellow"),
          state="lying")  # fmt: skip
def hose_nozzle(look: Look) -> Shape:
    """A hose spray gun, lying on its side."""
    color = look.color("green", "yellow", "blue", "orange", "red")
    barrel = (
        cylinder(0.014, 0.1, 18, top=0.018, bevel=0.002).turn(1, -np.pi / 2).move(0.03, 0, 0.02)
    )
    head = cylinder(0.02, 0.018, 20, bevel=0.002).turn(1, -np.pi / 2).move(-0.068, 0, 0.02)
    grip = rod([(0.02, 0, 0.018), (0.045, 0.04, 0.017), (0.055, 0.085, 0.016)],
               [0.014, 0.013, 0.014], 12)  # fmt: skip
    joint = cylinder(0.012, 0.022, 16).turn(0, -np.pi / 2).move(0.057, 0.09, 0.015)
    lever = rod([(-0.02, 0.012, 0.02), (0.005, 0.04, 0.018), (0.025, 0.07, 0.018)], 0.0055, 8)
    skin = surfaces.speckles(look.rng, color, 4)
    dark = surfaces.plain((52, 54, 58))
    pieces: Pieces = [(join([barrel, grip]), skin), (join([head, joint, lever]), dark)]
    return put_down(pieces, join([barrel, head]), join([grip, joint]), lever,
                   factor=look.between(0.9, 1.1), foot=0.3)  # fmt: skip


@category("keys", size=(0.07, 0.12, 0.0065), mass=0.06, material="metal", assembled=True,
          aliases=("key", "key ring", "keyring", "bunch of keys", "key chain", "keychain",
          "set of keys", "car key", "house key", "chatelaine", "iron key"),
          themes=("living", "office"), roles=("flat",), colors=("red", "blue"), state="lying flat",
          common=True)  # fmt: skip
def keys(look: Look) -> Shape:
    """A ring of keys with a tag."""
    tones = ((196, 198, 202), (206, 172, 92), (176, 148, 110))
    metals = [surfaces.brushed_metal(look.rng, tone) for tone in tones]
    ring = torus(0.014, 0.0013, 28, 6).move(z=0.0035)
    pieces = [(ring, metals[0])]
    parts = [cylinder_part(0.0148, 0.0035, (0, 0, 0.0004))]
    count = int(look.rng.integers(2, 5))
    for k in range(count):
        angle = -np.pi / 2 + (k - count / 2) * 0.55 + look.between(-0.1, 0.1)
        bow = lobe(cylinder(0.0115, 0.0022, 24), int(look.pick([3, 4, 8])), 0.25)
        long = look.between(0.028, 0.036)
        teeth = [(0.009 + long * u, -0.0025 - 0.0016 * (n % 2)) for n, u in
                 enumerate(np.linspace(0.35, 0.96, 8))]  # fmt: skip
        shank = prism([(0.006, -0.0028), *teeth, (0.009 + long, 0.002), (0.006, 0.0032)], 0, 0.002)
        z = 0.0002 + 0.0019 * k
        key = join([bow, shank]).move(x=0.022).turn(2, angle).move(z=z)
        pieces.append((key, metals[int(look.rng.integers(3))]))
        parts.append(hull_of(key))
    color = look.color("red", "blue", "brown", "green", "black", "yellow", "pink")
    kind, turn = int(look.rng.integers(3)), np.pi / 2 + look.between(-0.4, 0.4)
    tag = [block(0.046, 0.024, 0.004, 0.007, 0.001), cylinder(0.017, 0.004, 26, bevel=0.001),
           lobe(cylinder(0.018, 0.006, 40, bevel=0.001), 5, 0.5)][kind]  # fmt: skip
    tag = tag.move(x=0.04).turn(2, turn).move(z=0.0003)
    loop = tube([(0.012, 0, 0.0042), (0.018, 0, 0.005), (0.026, 0, 0.003)], 0.0014, 6)
    loop = loop.turn(2, turn)
    pieces += [(tag, surfaces.speckles(look.rng, color, 8)), (loop, metals[0])]
    return shape(pieces, [*parts, hull_of(tag)])


@category("compass", size=(0.0607, 0.0792, 0.0333), mass=0.07, material="metal", assembled=True,
          aliases=("pocket compass", "magnetic compass", "hiking compass", "navigation compass",
          "sighting compass"), themes=("living", "office"), roles=("flat",),
          colors=("brass", "silver"), state="lying flat")  # fmt: skip
def compass(look: Look) -> Shape:
    """A pocket compass lying flat with its needle up, sometimes with a lid or a base plate."""
    r, h = look.between(0.026, 0.034), look.between(0.011, 0.015)
    color = look.color("brass", "silver", "black", "copper", "gold", "red", "teal")
    metal = look.surface(color, "metal")
    face = prints.canvas(128, 128, look.pick([(246, 242, 228), (250, 250, 248), (34, 38, 46)]))
    ink: RGB = (40, 40, 44) if int(face[0, 0, 0]) > 128 else (240, 240, 236)
    for n in range(36):
        a = np.pi * n / 18
        way = [(0.5 + s * np.sin(a), 0.5 - s * np.cos(a)) for s in (0.4 if n % 3 else 0.37, 0.45)]
        prints.stroke(face, way, 0.008, ink)
    for n, word in enumerate("NESW"):
        a = np.pi / 2 * n
        prints.write(face, word, 0.5 + 0.29 * np.sin(a), 0.5 - 0.29 * np.cos(a), 0.13,
                     (190, 40, 40) if word == "N" else ink, bold=True)  # fmt: skip
    turn = look.between(0, 6.28)
    for s, tone in ((1, (206, 40, 40)), (-1, (70, 90, 130))):
        tip = (0.5 + s * 0.36 * np.sin(turn), 0.5 - s * 0.36 * np.cos(turn))
        sides = [(0.5 + 0.045 * np.cos(turn) * e, 0.5 + 0.045 * np.sin(turn) * e) for e in (-1, 1)]
        prints.polygon(face, [sides[0], tip, sides[1]], tone)
    prints.disc(face, 0.5, 0.5, 0.03, (200, 164, 84))
    kind = look.pick(["plain", "lid", "plate"])
    base = 0.003 if kind == "plate" else 0.0
    body = lathe([(0, 0), (0.96 * r, 0), (r, 0.003), (r, h), (0.9 * r, h), (0.88 * r, h - 0.003),
                  (0, h - 0.003)], 36).move(z=base)  # fmt: skip
    dial = cylinder(0.88 * r, 0.0006, 36).move(z=base + h - 0.0031)
    pieces, parts = [(body, metal), (dial, face)], [cylinder_part(r, h, (0, 0, base))]
    if kind == "lid":
        lid = lathe([(0, 0), (r, 0), (r, 0.003), (0.8 * r, 0.005), (0, 0.005)], 36)
        lid = lid.turn(0, 1.9).move(y=1.05 * r, z=h + 0.9 * r)
        loop = torus(0.007, 0.0014, 18, 6).move(y=-r - 0.006, z=0.5 * h)
        pieces.append((join([lid, loop]), metal))
        hinge = box(0.012, 0.008, 0.006).move(y=r + 0.001, z=h - 0.005)
        pieces.append((hinge, metal))
        parts.append(hull_of(lid))
    elif kind == "plate":
        plate = block(2.3 * r, 3.6 * r, 0.0032, 0.006).move(y=0.4 * r)
        grid = prints.canvas(96, 144, (206, 222, 226))
        prints.fill(grid, 0.49, 0.04, 0.02, 0.3, (200, 40, 40))
        for n in range(24):
            prints.fill(grid, 0.0, 0.04 * n + 0.02, 0.05 + 0.03 * (n % 5 == 0), 0.006, (40, 40, 44))
        top = box(2.2 * r, 3.5 * r, 0.0004).move(y=0.4 * r, z=0.003)
        pieces += [(plate, surfaces.plain((206, 222, 226))), (top, grid)]
        parts.append(hull_of(plate))
    return shape(pieces, parts)


@category("pitchfork", size=(0.39, 0.132, 0.01), mass=0.1, material="plastic", assembled=True,
          aliases=("devil's pitchfork", "pitchfork prop", "toy pitchfork", "trident", "devil fork"),
          themes=("living",), colors=("red",), state="lying flat")  # fmt: skip
def pitchfork(look: Look) -> Shape:
    """A devil's pitchfork lying flat: a shaft with three barbed prongs."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "red", "black")
    shaft = straight((-0.2, 0, 0.006), (0.08, 0, 0.006), 0.0055)
    yoke = limb([(0.15, -0.05, 0.006), (0.09, -0.046, 0.006), (0.076, 0, 0.006),
                 (0.09, 0.046, 0.006), (0.15, 0.05, 0.006)], [0.005] * 5, 8)  # fmt: skip
    prong = straight((0.07, 0, 0.006), (0.16, 0, 0.006), 0.005)
    tips = [prism(np.array([(0.145, y - 0.014), (0.185, y), (0.145, y + 0.014), (0.152, y)]), 0.002,
                  0.01) for y in (-0.051, 0, 0.051)]  # fmt: skip
    return settle([(shaft, surfaces.speckles(look.rng, tint_color(color, 0.9), 6)),
                   (join([yoke, prong, *tips]), surfaces.speckles(look.rng, color, 6))], 0.1,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("mouse_trap", size=(0.105, 0.0502, 0.019), mass=0.03, material="wood",
          aliases=("mousetrap", "rat trap", "spring trap"), themes=("living",), roles=("flat",),
          colors=("tan",))  # fmt: skip
def mouse_trap(look: Look) -> Shape:
    """A spring mousetrap, set and baited with a bit of cheese."""
    color = look.color("tan", "wooden", "beige")
    k = look.between(0.85, 1.25)
    base = at_box(0.1, 0.048, 0.008)
    hoop = rod([(0.002, 0.019, 0.0105), (0.042, 0.019, 0.0105), (0.042, -0.019, 0.0105),
                (0.002, -0.019, 0.0105)], 0.0014, 6, 1)  # fmt: skip
    coil = drum(0.0042, 0.04, (0.0, -0.02, 0.0115), 1, sides=12)
    pin = straight((-0.046, 0, 0.0105), (0.036, 0.004, 0.0125), 0.001, 6)
    pad_, cheese = (at_box(0.018, 0.016, 0.0014, (-0.022, 0, 0.009)),
                    plate([(-0.008, -0.005), (0.008, -0.002), (-0.005, 0.007)], 0.008))  # fmt: skip
    print_ = prints.canvas(96, 48, color)
    prints.write(
        print_, look.pick(["SNAP", "TRAP", "MOUSE"]), 0.75, 0.5, 0.24, (180, 40, 40), bold=True
    )
    return put_down([(base, surfaces.wood(look.rng, color)), (at_box(0.098, 0.046, 0.0006,
                                                                     (0, 0, 0.0077)), print_),
                     (join([hoop, coil, pin]), steel(look)), (pad_, steel(look, (190, 150, 80))),
                     (cheese.move(-0.022, 0, 0.0102), plain((244, 206, 70)))], base, hoop,
                    factor=k)  # fmt: skip
