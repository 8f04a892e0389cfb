"""Objects of the ``office`` theme: boxes."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, glaze_tile, metal, shine, steel
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_of, hull_part, ring_parts
from ...kit.primitives import at_block, at_box, disc, drum, facing, rod, straight
from ...kit.shapes import Pieces, Shape, category, from_pieces, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, open_box, torus, tube
from ...kit.surfaces import Look, tint_color


@category("safe", size=(0.223, 0.215, 0.203), mass=6.0, material="metal",
          aliases=("mini safe", "small safe", "security box"), themes=("office",),
          roles=("big", "support"), colors=("charcoal",))  # fmt: skip
@from_pieces()
def safe(look: Look) -> Pieces:
    """A small safe with a thick door, a dial and a handle."""
    tile = metal(look, "charcoal", "gray", "black", "green")
    body = at_block(0.22, 0.18, 0.2, 0.008)
    door = at_block(0.17, 0.15, 0.012, 0.006).turn(0, np.pi / 2).move(0, -0.089, 0.102)
    dial = [disc(0.024, 0.014).turn(0, np.pi / 2).move(-0.035, -0.1, 0.115),
            disc(0.008, 0.022).turn(0, np.pi / 2).move(-0.035, -0.1, 0.115)]  # fmt: skip
    bars = [straight((0.035 - 0.028 * np.cos(a), -0.112, 0.115 - 0.028 * np.sin(a)),
                     (0.035 + 0.028 * np.cos(a), -0.112, 0.115 + 0.028 * np.sin(a)), 0.004, 8)
            for a in (0.4, 0.4 + np.pi / 3, 0.4 + 2 * np.pi / 3)]  # fmt: skip
    hub = disc(0.009, 0.02).turn(0, np.pi / 2).move(0.035, -0.098, 0.115)
    hinges = [
        straight((0.088, -0.094, z), (0.088, -0.094, z + 0.03), 0.007, 10) for z in (0.03, 0.14)
    ]
    return [(body, tile), (door, dye(look, "gray", "charcoal")), (dial[0], dye(look, "black")),
            (dial[1], shine(look)), (join([*bars, hub]), shine(look)),
            (join(hinges), shine(look))]  # fmt: skip


@category("lunch_box", size=(0.223, 0.118, 0.172), mass=0.5, material="metal", hollow=True,
          aliases=("lunchbox", "lunch pail", "lunch tin", "vintage lunch box"),
          themes=("office", "kitchen"), colors=("red", "blue"),
          opened="open_lunch_box")  # fmt: skip
def lunch_box(look: Look) -> Shape:
    """A lunch box with a lid, clasps and a handle on top."""
    x, y, h = look.between(0.2, 0.24), look.between(0.1, 0.12), look.between(0.13, 0.15)
    color = look.color("red", "blue", "yellow", "green", "pink", "purple", "teal", "orange")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    body = block(x, y, h, 0.022, 0.006)
    seam = block(1.006 * x, 1.01 * y, 0.005, 0.022).move(z=0.66 * h)
    grip = tube(smooth([(-0.26 * x, 0, h - 0.002), (-0.24 * x, 0, h + 0.028),
                        (0.24 * x, 0, h + 0.028), (0.26 * x, 0, h - 0.002)], 4), 0.0055,
                10)  # fmt: skip
    clasps = [box(0.022, 0.006, 0.03).move(s * 0.3 * x, -y / 2 - 0.001, 0.58 * h) for s in (-1, 1)]
    face = prints.cover(look.rng, look.pick(["LUNCH", "YUM", "SNACK"]), color,
                        look.own_color("white", "yellow", "sky"))  # fmt: skip
    front = box(0.7 * x, 0.001, 0.48 * h).move(y=-y / 2, z=0.08 * h)
    dark = surfaces.plain(look.own_color("black", "white", "silver"))
    return shape([(body, skin), (join([grip, seam, *clasps]), dark),
                  (front, surfaces.fit(face[::1], 112, 160))],
                 [hull_of(body), hull_of(grip)])  # fmt: skip


@category("single_drawer", size=(0.246, 0.199, 0.0858), mass=0.7, material="wood", hollow=True,
          aliases=("small drawer", "open drawer", "wooden drawer", "component drawer"),
          themes=("office",), roles=("container", "big"), colors=("wooden",))  # fmt: skip
def single_drawer(look: Look) -> Shape:
    """A single open drawer with a knob on its front."""
    x, y, h = look.between(0.2, 0.26), look.between(0.15, 0.19), look.between(0.06, 0.08)
    color = look.color("wooden", "white", "brown", "gray", "tan")
    t = 0.009
    front = at_box(x + 0.016, 0.012, h + 0.012, (0, -y / 2 - 0.005, 0))
    knob = drum(0.0125, 0.02, (0, -y / 2 - 0.011, 0.5 * h), 1)
    knob = knob.move(0, -0.02, 0)
    wood = look.surface(color, "wood")
    parts = (*frame_parts(x, y, h, t, t), hull_part(front.vertices), hull_part(knob.vertices))
    return shape([(join([*open_box(x, y, h, t, t), front]), wood),
                  (knob, steel(look, (196, 160, 84)))], parts)  # fmt: skip


@category("collection_tin", size=(0.0907, 0.117, 0.14), mass=0.2, material="metal",
          aliases=("collecting tin", "charity tin", "donation tin", "donation box", "charity box",
          "charity collection tin", "collection box"), themes=("office",), roles=("round", "tall"),
          colors=("red",))  # fmt: skip
def collection_tin(look: Look) -> Shape:
    """A round collection tin with a slot in its lid, a handle and a label."""
    r, h = look.between(0.04, 0.046), look.between(0.12, 0.14)
    color = look.color("red", "blue", "yellow", "green", "purple")
    label = prints.label(look.rng, look.pick(["DONATE", "CHARITY", "HELP", "THANK YOU"]), color,
                         (248, 246, 240))  # fmt: skip
    body = cylinder(r, h, 34)
    lid = cylinder(1.03 * r, 0.012, 34, bevel=0.002).move(z=h - 0.002)
    slot = box(0.036, 0.004, 0.0006).move(z=h + 0.0099)
    grip = torus(0.024, 0.0035, 20, 8).turn(1, np.pi / 2).turn(2, np.pi / 2)
    grip = grip.turn(2, np.pi / 2).scale(1, 1, 1.3).move(y=1.0 * r, z=0.55 * h)
    return shape([(body, label), (join([lid, grip]), surfaces.plain(tint_color(color, 0.7))),
                  (slot, surfaces.plain((24, 24, 28)))],
                 [cylinder_part(1.0 * r, h + 0.01), hull_of(lid), hull_of(grip)])  # fmt: skip


@category("cash_tin", size=(0.207, 0.157, 0.0937), mass=1.1, material="metal", aliases=("cash box",
          "lock box", "lockbox", "petty cash tin", "petty cash box", "metal cash box", "deed box",
          "strongbox", "safe box"), themes=("office",), roles=("support",),
          colors=("red", "black"))  # fmt: skip
def cash_tin(look: Look) -> Shape:
    """A steel cash box with a folding handle and a lock."""
    k = look.between(0.92, 1.1)
    color = look.color("red", "black", "blue", "gray", "green", "navy")
    x, y, h = 0.2 * k, 0.15 * k, 0.08 * k
    low = block(x, y, 0.66 * h, 0.008, 0.002)
    top = block(1.02 * x, 1.02 * y, 0.36 * h, 0.009, 0.004).move(z=0.64 * h)
    grip = rod([(-0.2 * x, 0, h - 0.002), (-0.18 * x, 0, h + 0.008), (0.18 * x, 0, h + 0.008),
                (0.2 * x, 0, h - 0.002)], 0.0034, 8)  # fmt: skip
    lock = cylinder(0.009, 0.003, 18).turn(0, np.pi / 2).move(y=-0.5 * y, z=0.5 * h)
    key = box(0.002, 0.0012, 0.008).move(y=-0.5 * y - 0.0032, z=0.5 * h - 0.004)
    steel = surfaces.brushed_metal(look.rng, (196, 199, 204))
    paint = surfaces.speckles(look.rng, color, 4)
    return shape([(low, surfaces.speckles(look.rng, tint_color(color, 0.9), 4)), (top, paint),
                  (join([grip, lock]), steel), (key, surfaces.plain((30, 30, 32)))],
                 [hull_of(low), hull_of(top), hull_of(grip), hull_of(lock)])  # fmt: skip


@category("box", size=(0.17, 0.125, 0.1), mass=0.35, material="paper", hollow=True,
          aliases=("cardboard box", "parcel", "package", "shoebox", "shoe box", "blade dispenser",
          "shot dispenser", "bit holder", "bug hotel", "chemistry set"),
          themes=("office", "living", "workbench"), roles=("support",), opened="open_box",
          common=True)  # fmt: skip
def box_(look: Look) -> Shape:
    """A closed cardboard parcel with tape, or a gift box in coloured paper with a ribbon."""
    x, y, h = look.between(0.14, 0.2), look.between(0.1, 0.15), look.between(0.08, 0.12)
    asked = look.attributes.get("color", "")
    gift = look.chance(0.34) if not asked else asked not in ("brown", "tan", "beige")
    color = look.color("red", "teal", "navy", "pink", "white", "lavender", "black", "sage")
    ribbon = look.own_color("gold", "white", "red", "green", "pink")
    board = surfaces.cardboard(look.rng)
    if not gift:
        label = prints.canvas(96, 64, (246, 246, 242))
        prints.lines(label, look.rng, (0.08, 0.12, 0.5, 0.5), 4, (80, 80, 84))
        prints.barcode(label, look.rng, 0.5, 0.6, 0.42)
        note = box(0.07, 0.045, 0.0006).move(x=0.1 * x, y=-0.18 * y, z=h - 0.0001)
        return shape([(box(x, y, h), board), (note, label)], [box_part(x, y, h)])
    paper, band = surfaces.fit(glaze_tile(look, color), 128, 128), surfaces.plain(ribbon)
    bow = [torus(0.016, 0.004, 16, 6).scale(1, 0.55, 1).turn(0, 0.9) for _ in range(2)]
    return shape([(box(x, y, h), paper), (box(0.022, y + 0.002, h + 0.001), band),
                  (box(x + 0.002, 0.022, h + 0.001), band), (bow[0].turn(2, 0.5).move(x=-0.016, z=h
                                                                                      + 0.011),
                                                             band),
                  (bow[1].turn(2, -0.5).move(x=0.016, z=h + 0.011), band)],
                 [box_part(x, y, h), box_part(0.05, 0.02, 0.018, (0, 0, h))])  # fmt: skip


WOODS = ("wooden", "brown", "tan", "white", "black", "maroon", "teal")


def _drawer(
    look: Look, wide: float, tall: float, at: tuple[float, float, float], knob: str
) -> tuple[Solid, Solid]:
    """Return a drawer's front and handle; ``at`` is the middle of the front's lower edge."""
    front = box(wide, 0.012, tall).move(*at)
    x, y, z = at
    if knob == "bar":
        pull = [box(0.3 * wide, 0.006, 0.008).move(x, y - 0.02, z + tall / 2),
                *[box(0.008, 0.016, 0.008).move(x + s * 0.12 * wide, y - 0.012, z + tall / 2)
                  for s in (-1, 1)]]  # fmt: skip
        return front, join(pull)
    ball = ellipsoid(0.018, 0.016, 0.018, 14, 8).move(x, y - 0.013, z + tall / 2)
    return front, ball


@category("cabinet", size=(0.275, 0.235, 0.305), mass=3.0, material="wood", hollow=True,
          aliases=("wooden cabinet", "desk cabinet", "small cabinet", "white cabinet",
          "dollhouse cabinet", "chest of drawers", "cupboard", "mini cabinet", "wood cabinet",
          "tabletop cabinet", "filing cabinet"), themes=("office", "living"),
          roles=("big", "support", "tall"), colors=("wooden", "white"))  # fmt: skip
def cabinet(look: Look) -> Shape:
    """A small desk cabinet with drawers, or with drawers below a pair of doors."""
    x, y, h = look.between(0.22, 0.29), look.between(0.18, 0.22), look.between(0.24, 0.32)
    color = look.color(*WOODS)
    skin = look.surface(color, "wood")
    face = look.surface(tint_color(color, look.pick([1.0, 1.12, 0.86])), "wood")
    metal = surfaces.brushed_metal(look.rng, look.own_color("brass", "silver", "charcoal"))
    knob, count, doors = look.pick(["ball", "bar"]), look.pick([2, 3, 3]), look.chance(0.35)
    feet = join([box(0.024, 0.024, 0.014).move(sx * 0.42 * x, sy * 0.4 * y)
                   for sx in (-1, 1) for sy in (-1, 1)])  # fmt: skip
    body = box(x, y, h).move(z=0.012)
    top = block(x + 0.02, y + 0.02, 0.012, 0.005, 0.002).move(z=h + 0.011)
    fronts, pulls = [], []
    floor = 0.03
    room = (0.45 if doors else 0.93) * h
    for k in range(count):
        tall = room / count
        front, pull = _drawer(
            look, 0.88 * x, tall - 0.012, (0, -y / 2 - 0.004, floor + k * tall), knob
        )
        fronts.append(front)
        pulls.append(pull)
    if doors:
        for s in (-1, 1):
            z = floor + room
            fronts.append(box(0.435 * x, 0.012, 0.44 * h).move(s * 0.222 * x, -y / 2 - 0.004, z))
            pulls.append(ellipsoid(0.015, 0.015, 0.015, 12, 8).move(s * 0.04 * x, -y / 2 - 0.016,
                                                                     z + 0.2 * h))  # fmt: skip
    return shape(
        [(join([body, top]), skin), (feet, surfaces.plain(tint_color(color, 0.5))),
         *((front, face) for front in fronts), (join(pulls), metal)],
        [box_part(0.86 * x, 0.82 * y, 0.014), hull_of(body), hull_of(top), hull_of(*fronts),
         *(hull_of(p) for p in pulls)],
    )  # fmt: skip


@category("drawer_box", size=(0.224, 0.217, 0.134), mass=1.1, material="wood", hollow=True,
          aliases=("drawer unit", "box with drawers", "box of drawers", "mini drawers",
          "drawer organizer", "desk drawer", "box with a drawer", "jewelry drawer"),
          themes=("office", "craft", "vanity"), roles=("support", "big"),
          colors=("wooden", "white"))  # fmt: skip
def drawer_box(look: Look) -> Shape:
    """A small box with one or two wide drawers or a grid of small drawers, one of them open."""
    columns, rows = look.pick([(1, 1), (1, 2), (2, 2), (3, 2)])
    x, y, h = look.between(0.2, 0.25), look.between(0.13, 0.17), 0.065 * rows + 0.012
    color = look.color("wooden", "white", "black", "tan", "sky", "pink", "gray", "mint")
    skin = look.surface(color, look.pick(["wood", "plastic"]))
    face = look.surface(tint_color(color, look.pick([1.15, 0.85])), look.pick(["wood", "plastic"]))
    metal = surfaces.brushed_metal(look.rng, look.own_color("brass", "silver", "charcoal"))
    body = box(x, y, h)
    open_ = int(look.rng.integers(columns * rows)) if look.chance(0.7) else -1
    pieces, parts = [(body, skin)], [box_part(x, y, h)]
    wide, tall = (x - 0.012) / columns, (h - 0.01) / rows
    for k in range(columns * rows):
        u = (k % columns - (columns - 1) / 2) * wide
        z = 0.005 + (k // columns) * tall
        out = 0.36 * y if k == open_ else 0.0
        front, pull = _drawer(
            look, wide - 0.006, tall - 0.007, (u, -y / 2 - 0.002 - out, z + 0.003), "ball"
        )
        pieces += [(front, face), (pull, metal)]
        parts.append(hull_of(front, pull))
        if out:
            tray = open_box(wide - 0.016, out, tall - 0.02, 0.004, 0.004)
            moved = [s.move(u, -y / 2 - out / 2, z + 0.004) for s in tray]
            pieces.append((join(moved), face))
            parts += [hull_of(s) for s in moved[:3]]
    return shape(pieces, parts)


@category("waste_bin", size=(0.15, 0.15, 0.19), mass=0.35, material="plastic", hollow=True,
          aliases=("trash can", "trash bin", "dustbin", "garbage can", "wastebasket", "rubbish bin",
          "waste basket", "wastepaper basket", "desk bin", "trashcan", "garbage bin",
          "mini trash can", "recycling bin"), themes=("office", "kitchen"),
          roles=("round", "tall", "big"), colors=("white", "gray"))  # fmt: skip
def waste_bin(look: Look) -> Shape:
    """A small desk bin, open or with a swing lid."""
    r, h = look.between(0.065, 0.08), look.between(0.15, 0.19)
    color = look.color("white", "gray", "black", "silver", "mint", "pink", "sky", "red")
    mesh = look.chance(0.35)
    skin = look.surface(color, "metal" if look.chance(0.4) else "plastic")
    if mesh:
        skin = prints.mesh_holes(color, tint_color(color, 0.35), 24, 40)
    side = [(0.78 * r, 0), (0.9 * r, 0.5 * h), (r, h)]
    body = lathe([(0, 0), *side, (r - 0.003, h), (0.78 * r - 0.003, 0.005), (0, 0.005)], 30)
    rim = torus(r - 0.001, 0.0035, 32, 6).move(z=h)
    plain = surfaces.plain(tint_color(color, 0.85))
    walls = [*ring_parts([side[0], side[2]], [(r - 0.003, h), (0.78 * r - 0.003, 0.005)]),
             cylinder_part(0.78 * r, 0.005)]  # fmt: skip
    if mesh or look.chance(0.4):
        return shape([(body, skin), (rim, plain)], walls)
    t = np.linspace(0, np.pi / 2, 7)
    lid = lathe([(0, h), *((1.03 * r * np.cos(a) ** 0.6, h + 0.5 * r * np.sin(a)) for a in t[:-1]),
                 (0, h + 0.5 * r)], 30)  # fmt: skip
    flap = facing(block(1.1 * r, 0.4 * r, 0.006, 0.006, 0.001)).turn(0, -0.5)
    flap = flap.move(y=-0.82 * r, z=h + 0.26 * r)
    return shape(
        [(body, skin), (join([lid, rim]), plain), (flap, surfaces.plain(tint_color(color, 0.6)))],
        [hull_of(body), hull_of(lid)],
    )
