"""Objects of the ``office`` theme: stationery."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, metal, plastic, shine, tool_steel, wood
from ...kit.outlines import arc, ellipse, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, frame_parts, hull_of, hull_part
from ...kit.primitives import (
    at_block,
    at_box,
    disc,
    drum,
    facing,
    hull_solid,
    plate,
    rod,
    side_view,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import Pieces, Shape, at_rest, category, from_pieces, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, open_box, prism, tube
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color

BLACK = surfaces.plain((34, 34, 37))


@category("guillotine", size=(0.335, 0.34, 0.13), mass=1.8, material="plastic",
          aliases=("paper guillotine", "paper cutter", "paper trimmer", "trimmer board"),
          themes=("office",), roles=("big",), colors=("black",))  # fmt: skip
@from_pieces(bodies=4)
def guillotine(look: Look) -> Pieces:
    """A paper cutter: a ruled board with a long arm and blade."""
    board = at_block(0.32, 0.26, 0.018, 0.008)
    image = surfaces.grid((140, 160, 170), (206, 216, 214), 14, 18)
    tile = plastic(look, "black", "gray", "blue", "green")
    rail = at_box(0.012, 0.26, 0.008, (0.15, 0, 0.018))
    arm = at_block(0.02, 0.29, 0.012, 0.004, (0, -0.14, 0)).turn(0, -0.28).move(0.165, 0.12, 0.022)
    blade = at_box(0.003, 0.26, 0.022, (0, -0.13, -0.012)).turn(0, -0.28).move(0.158, 0.12, 0.024)
    grip = rod([(0.165, -0.145, 0.105), (0.165, -0.19, 0.118)], [0.01, 0.012], 10)
    stop = at_box(0.3, 0.012, 0.008, (-0.01, 0.122, 0.018))
    return [(board, tile), (arm, tile), (grip, BLACK), (stop, shine(look)), (rail, shine(look)),
            (blade, shine(look)), (at_box(0.29, 0.23, 0.0006, (-0.01, -0.005, 0.0178)),
                                   image)]  # fmt: skip


@category("plastic_sleeve", size=(0.225, 0.305, 0.0015), mass=0.01, material="plastic",
          aliases=("sheet protector", "plastic wallet", "punched pocket", "document sleeve",
          "page protector", "clear sleeve", "plastic folder"), themes=("office",), roles=("flat",),
          colors=("clear",))  # fmt: skip
@from_pieces()
def plastic_sleeve(look: Look) -> Pieces:
    """A clear sleeve with holes along its edge and a page in it."""
    color = look.color("clear", "clear", "sky")
    page = prints.sheet(look.rng, picture=look.chance(0.5))
    base = at_box(0.225, 0.305, 0.0012)
    holes = [disc(0.003, 0.0004, (-0.107, y, 0.001), sides=12) for y in np.linspace(-0.12, 0.12, 8)]
    return [(base, surfaces.plain(tint_color(color, 1.1))), (at_box(0.2, 0.29, 0.0005,
                                                                    (0.008, 0, 0.001)), page),
            (join(holes), surfaces.plain((120, 130, 140)))]  # fmt: skip


@category("pen_nib", size=(0.034, 0.0084, 0.0019), mass=0.001, material="metal",
          aliases=("nib", "fountain pen nib", "calligraphy nib", "dip pen nib"), themes=("office",),
          roles=("flat",), colors=("gold",))  # fmt: skip
@from_pieces()
def pen_nib(look: Look) -> Pieces:
    """A metal nib lying flat with its point on the right, a dark slit and a small hole."""
    steel = metal(look, "gold", "silver", "bronze")
    body = plate([(-0.016, -0.0035), (0.0, -0.0042), (0.018, -0.0002), (0.018, 0.0002),
                  (0.0, 0.0042), (-0.016, 0.0035)], 0.0016)  # fmt: skip
    slit = [at_box(0.015, 0.0004, 0.0004, (0.009, 0, 0.0015)),
            disc(0.001, 0.0004, (0.001, 0, 0.0015), sides=10)]  # fmt: skip
    return [(body, steel), (join(slit), BLACK)]


@category("blotter", size=(0.14, 0.06, 0.068), mass=0.25, material="wood",
          aliases=("ink blotter", "rocker blotter", "desk blotter"), themes=("office",),
          colors=("brown",))  # fmt: skip
@from_pieces(foot=0.06)
def blotter(look: Look) -> Pieces:
    """A rocker blotter: a curved wooden base with a knob."""
    a = np.linspace(-0.75, 0.75, 16)
    outline = np.column_stack([0.1 * np.sin(a), 0.1 - 0.1 * np.cos(a)])
    body = plate([*outline, (0.07, 0.036), (-0.07, 0.036)], 0.06).turn(0, np.pi / 2).move(y=0.03)
    knob = standing((0.008, 0.034), (0.008, 0.046), (0.017, 0.056), (0.014, 0.068), sides=18)
    foot = at_box(0.06, 0.058, 0.004)
    return [(body, wood(look, "brown", "wooden", "maroon")), (foot, dye(look, "cream", "green")),
            (knob, wood(look, "brown", "black"))]  # fmt: skip


@category("pencil_grip", size=(0.041, 0.0148, 0.0146), mass=0.003, material="plastic",
          aliases=("pen grip", "writing grip"), themes=("office",),
          colors=("red", "blue"))  # fmt: skip
@from_pieces(foot=0.1, bodies=1)
def pencil_grip(look: Look) -> Pieces:
    """A short plastic grip lying flat, narrower in the middle, with a dark hole on the right."""
    return [(spindle((-0.02, 0.0058), (-0.016, 0.0075), (0.0, 0.0062), (0.016, 0.0075),
                     (0.02, 0.0058), sides=12, z=0.0073), plastic(look, *PAINTS)),
            (spindle((0.0199, 0.0036), (0.0205, 0.0036), z=0.0073), BLACK)]  # fmt: skip


@category("staple_remover", size=(0.0603, 0.0282, 0.0455), mass=0.04, material="plastic",
          aliases=("staple puller", "de stapler", "staple extractor"), themes=("office",),
          colors=("black", "red"))  # fmt: skip
@at_rest
@from_pieces()
def staple_remover(look: Look) -> Pieces:
    """A staple remover: two hinged jaws with teeth."""
    shell = plastic(look, "black", "red", "blue", "gray")
    pads = [at_block(0.045, 0.026, 0.008, 0.008).turn(1, s * 0.28).move(0, 0, 0.013 - s * 0.013)
            for s in (-1, 1)]  # fmt: skip
    low = min(float(p.bounds[0, 2]) for p in pads)
    pads = [p.move(z=-low) for p in pads]
    fangs = [hull_solid([(0.018, y - 0.002, z), (0.018, y + 0.002, z), (0.036, y, z - d),
                         (0.034, y, z + d), (0.018, y, z + 1.6 * d)]) for y in (-0.008, 0.008)
             for z, d in ((0.012, 0.004), (0.03, -0.004))]  # fmt: skip
    hinge = straight((-0.02, -0.014, 0.018), (-0.02, 0.014, 0.018), 0.004, 10)
    return [(pads[0], shell), (pads[1], shell), (join(fangs), shine(look)), (hinge, shine(look))]


@category("safety_pin_card", size=(0.07, 0.1, 0.0034), mass=0.01, material="paper",
          aliases=("card of safety pins", "card of pins", "pin card", "needle card",
          "card of needles"), themes=("office",), roles=("flat",), colors=("sky",))  # fmt: skip
@from_pieces(bodies=1)
def safety_pin_card(look: Look) -> Pieces:
    """A card titled PINS with six metal pins in a column."""
    card = at_box(0.07, 0.1, 0.0014)
    image = prints.canvas(64, 92, look.color("sky", "cream", "pink", "yellow"))
    prints.write(image, "PINS", 0.5, 0.12, 0.1, (40, 40, 60), True)
    pins = []
    for k in range(6):
        y = 0.024 - 0.012 * k
        pins += [straight((-0.022, y, 0.0024), (0.02, y, 0.0024), 0.0007, 6),
                 straight((-0.022, y - 0.005, 0.0024), (0.02, y - 0.003, 0.0024), 0.0007, 6),
                 at_block(0.007, 0.007, 0.0022, 0.002, (0.022, y - 0.0015, 0.0012))]  # fmt: skip
    return [(card, image), (join(pins), shine(look))]


@category("inkwell", size=(0.101, 0.0656, 0.208), mass=0.15, material="ceramic", assembled=True,
          aliases=("inkstand", "ink well", "inkpot", "ink pot", "standish"),
          themes=("office", "living"), roles=("tall",), colors=("white",))  # fmt: skip
def inkwell(look: Look) -> Shape:
    """An inkwell with a feather pen standing in it."""
    color = look.color("white", "navy", "black", "cream", "crimson", "teal")
    k = look.between(0.85, 1.15)
    pot = standing((0.026, 0), (0.03, 0.006), (0.03, 0.024), (0.016, 0.036), (0.014, 0.042),
                  (0.018, 0.045), (0.018, 0.047))  # fmt: skip
    ink = drum(0.0135, 0.001, (0, 0, 0.0465))
    tip = np.array([0.05, 0.01, 0.19])
    shaft = rod([(0, 0, 0.03), (0.012, 0.002, 0.085), tuple(tip)], [0.0022, 0.0014], 6)
    rim = [(0.0, 0.0), (0.012, 0.014), (0.016, 0.06), (0.004, 0.125), (-0.012, 0.075),
           (-0.011, 0.02)]  # fmt: skip
    vane = plate(rim, 0.0012).turn(0, np.pi / 2).turn(1, 0.36).move(0.015, 0.004, 0.07)
    glass = look.pick([(70, 84, 110), (60, 60, 66), (120, 150, 150), (196, 160, 84)])
    return put_down(
        [(pot, surfaces.speckles(look.rng, glass, 5)), (ink, plain((28, 30, 52))),
         (shaft, plain((230, 222, 200))), (vane, surfaces.scratches(look.rng, color,
          tint_color(color, 0.85), 80))], pot, shaft, vane, factor=k)  # fmt: skip


STEEL: RGB = (186, 189, 194)


@category("whiteboard", size=(0.31, 0.126, 0.243), mass=0.7, material="plastic", assembled=True,
          aliases=("dry erase board", "white board", "desk whiteboard", "mini whiteboard",
          "chalkboard slate", "blackboard", "writing slate", "slate board"), themes=("office",),
          roles=("big", "tall"), colors=("silver",))  # fmt: skip
def whiteboard(look: Look) -> Shape:
    """A small whiteboard with a drawing on it, standing on feet."""
    k = look.between(0.88, 1.06)
    color = look.color("silver", "wooden", "black", "blue", "white", "red")
    x, h = 0.32 * k, 0.23 * k
    image = prints.canvas(192, 136, (250, 250, 249))
    inks = [(40, 70, 170), (200, 50, 50), (40, 130, 70)]
    kind = int(look.rng.integers(3))
    if kind == 0:
        prints.stroke(image, [(0.1, 0.85), (0.1, 0.2)], 0.02, inks[0])
        prints.stroke(image, [(0.1, 0.85), (0.9, 0.85)], 0.02, inks[0])
        t = np.linspace(0, 1, 20)
        curve = zip(0.12 + 0.74 * t, 0.8 - 0.5 * t**2 - 0.06 * np.sin(9 * t), strict=True)
        prints.stroke(image, list(curve), 0.025, inks[1])
    elif kind == 1:
        prints.write(image, look.pick(["TO DO", "IDEAS", "MONDAY", "a2+b2=c2", "E = mc2"]), 0.5,
            0.2,
                     0.18, inks[0], bold=True)  # fmt: skip
        for n in range(4):
            prints.disc(image, 0.14, 0.42 + 0.14 * n, 0.02, inks[1])
            prints.fill(image, 0.2, 0.41 + 0.14 * n, look.between(0.3, 0.66), 0.025, (60, 64, 80))
    else:
        for n, (u, v) in enumerate(((0.22, 0.3), (0.75, 0.28), (0.5, 0.75))):
            prints.disc(image, u, v, 0.16, inks[n], 0.135)
        prints.stroke(image, [(0.36, 0.3), (0.62, 0.3)], 0.02, (60, 60, 66))
        prints.stroke(image, [(0.28, 0.45), (0.42, 0.62)], 0.02, (60, 60, 66))
    lift, t = 0.02 * k, 0.01
    frame = box(x, t, h).move(z=lift)
    face = box(0.95 * x, 0.0012, 0.93 * h).move(y=-t / 2, z=lift + 0.035 * h)
    feet = [block(0.02 * k, 0.13 * k, lift + 0.006, 0.004).move(x=s * 0.36 * x) for s in (-1, 1)]
    return shape([(frame, look.surface(color, "plastic")), (face, image),
                  (join(feet), surfaces.plain(tint_color(color, 0.6)))],
                 [hull_of(frame), *(hull_of(s) for s in feet)])  # fmt: skip


@category("whiteboard_eraser", size=(0.125, 0.05, 0.0315), mass=0.05, material="fabric",
          aliases=("board eraser", "blackboard eraser", "chalkboard eraser", "chalk eraser",
          "board rubber", "dry eraser", "whiteboard rubber"), themes=("office",),
          colors=("blue",))  # fmt: skip
def whiteboard_eraser(look: Look) -> Shape:
    """A board eraser: a grip on a felt pad."""
    k = look.between(0.9, 1.1)
    color = look.color("blue", "wooden", "black", "red", "green", "yellow")
    x, y = 0.125 * k, 0.05 * k
    felt = block(x, y, 0.016 * k, 0.005)
    grip = block(0.98 * x, 0.96 * y, 0.016 * k, 0.008, 0.004).move(z=0.0155 * k)
    return shape([(felt, surfaces.fabric(look.rng, look.own_color("charcoal", "gray", "navy"))),
                  (grip, look.surface(color, "plastic"))],
                 [hull_of(felt), hull_of(grip)])  # fmt: skip


@category("highlighter", size=(0.118, 0.0258, 0.0155), mass=0.018, material="plastic",
          aliases=("highlighter pen", "highlighter marker", "text marker"), themes=("office",),
          roles=("flat",), colors=("yellow", "pink"), state="lying flat")  # fmt: skip
def highlighter(look: Look) -> Shape:
    """A highlighter with a bright cap, lying flat."""
    k = look.between(0.92, 1.06)
    color = look.color("yellow", "lime", "pink", "orange", "cyan", "yellow")
    x, y, h = 0.118 * k, 0.026 * k, 0.014 * k
    bright = surfaces.speckles(look.rng, color, 3, 32)
    body = block(0.62 * x, y, h, 0.006, 0.003).move(x=-0.19 * x)
    cap = block(0.4 * x, 0.92 * y, 0.92 * h, 0.006, 0.003).move(x=0.3 * x, z=0.0)
    clip = box(0.3 * x, 0.008 * k, 0.003).move(x=0.24 * x, z=0.9 * h)
    dark = surfaces.plain((44, 44, 48))
    band = prints.canvas(96, 32, tint_color(color, 0.8))
    prints.write(band, look.pick(["MARK", "LUMI", "TEXT"]), 0.5, 0.5, 0.5, (30, 30, 34), bold=True)
    sign = box(0.45 * x, 0.6 * y, 0.0006).move(x=-0.2 * x, z=h - 0.0003)
    return shape([(body, bright), (cap, dark if look.chance(0.4) else bright), (clip, dark),
                  (sign, band)], [hull_of(body), hull_of(cap)])  # fmt: skip


@category("push_pin", size=(0.0284, 0.0126, 0.0126), mass=0.001, material="metal", assembled=True,
          aliases=("pushpin", "map pin", "board pin"), themes=("office",), colors=("red", "blue"),
          state="lying flat")  # fmt: skip
def push_pin(look: Look) -> Shape:
    """A push pin lying on its side, larger than life-size."""
    k = look.between(1.0, 1.3)
    color = look.color("red", "blue", "yellow", "green", "white", "orange", "clear")
    head = lathe(np.array([(0, 0), (0.0055, 0), (0.0055, 0.0018), (0.0032, 0.004), (0.0036, 0.0105),
                           (0.005, 0.012), (0.005, 0.0135), (0, 0.0138)]) * k, 18)  # fmt: skip
    needle = lathe(np.array([(0, -0.011), (0.0006, -0.009), (0.0006, 0.0), (0, 0.0)]) * k, 8)
    lean = np.arctan2(0.0005, 0.0118)
    solids = [s.turn(1, np.pi / 2 - lean) for s in (head, needle)]
    low = min(float(s.bounds[0, 2]) for s in solids)
    head, needle = (s.move(z=-low) for s in solids)
    return shape([(head, surfaces.speckles(look.rng, color, 3, 32)),
        (needle, surfaces.plain(STEEL))],
                 [flat_foot(head.vertices, 0.1), hull_of(needle)])  # fmt: skip


@category("paper_clip", size=(0.039, 0.0105, 0.0017), mass=0.001, material="metal", assembled=True,
          aliases=("paperclip", "clip", "single paper clip", "metal clip", "carabiner",
          "cycle clip", "toe clip", "mudguard clip", "baby gate latch"), themes=("office",),
          roles=("flat",), colors=("silver",))  # fmt: skip
def paper_clip(look: Look) -> Shape:
    """A single paper clip, lying flat."""
    k = look.between(1.0, 1.5)
    color = look.color("silver", "silver", "red", "blue", "green", "yellow", "gold", "pink")
    r = 0.0007 * k
    way = [(-0.008, 0.0036), (0.01, 0.0036), *map(tuple, arc((0.0115, 0), 0.0036, np.pi / 2, -np.pi
           / 2, 6)), (-0.012, -0.0036), *map(tuple, arc((-0.013, -0.0006), 0.003, -np.pi / 2, -1.5 *
           np.pi, 6)), (0.007, 0.0024), *map(tuple, arc((0.0075, 0.0), 0.0024, np.pi / 2,
               -np.pi / 2,
                                                        5)), (-0.006, -0.0022)]  # fmt: skip
    path = np.array([(x, y, 0) for x, y in way]) * k + [0, 0, r]
    return shape([(tube(path, r, 6), surfaces.plain(color))],
                 [box_part(0.031 * k, 0.0082 * k, 1.7 * r,
                     (-0.0005 * k, 0, 0.15 * r))])  # fmt: skip


RAINBOW = ("red", "orange", "yellow", "green", "teal", "blue", "purple", "pink", "brown", "black")


@category("paper_clips", size=(0.0768, 0.0844, 0.00257), mass=0.004, material="metal",
          assembled=True, aliases=("box of paper clips",), themes=("office",), roles=("flat",),
          colors=("silver",), state="lying flat", noun="pile of paper clips")  # fmt: skip
def paper_clips(look: Look) -> Shape:
    """A few paper clips, lying flat."""
    color = look.color("silver", "silver", "red", "blue", "gold", "green", "pink")
    mixed = look.chance(0.4)
    pieces, parts = [], []
    k = look.between(0.9, 1.15)
    path = [(-0.4, -0.5), (0.9, -0.5), (1.25, -0.2), (1.25, 0.2), (0.9, 0.5), (-1.0, 0.5),
            (-1.3, 0.2), (-1.3, -0.05), (-1.0, -0.3), (0.7, -0.3), (0.95, 0), (0.7, 0.27),
            (-0.6, 0.27)]  # fmt: skip
    for n in range(int(look.rng.integers(4, 7))):
        points = np.column_stack([np.array(path) * [0.0125 * k, 0.0075 * k],
                                  0.0006 + 0.0014 * (np.arange(13) > 6)])  # fmt: skip
        away, turn = 0.021 * k * np.sqrt(n), 2.4 * n + look.between(-0.4, 0.4)
        wire = tube(points, 0.0006, 5).turn(2, look.between(0, 6.28))
        wire = wire.move(away * np.cos(turn), away * np.sin(turn), 0.0002 * n)
        wire = wire.move(z=-float(wire.bounds[0, 2]))
        tone = look.own_color(*RAINBOW[:8]) if mixed else color
        pieces.append((wire, surfaces.plain(tone)))
        parts.append(hull_of(wire))
    return shape(pieces, parts)


@category("binder_clip", size=(0.0323, 0.0335, 0.0483), mass=0.015, material="metal",
          aliases=("bulldog clip", "foldback clip", "fold back clip", "document clip"),
          themes=("office",), colors=("black",))  # fmt: skip
def binder_clip(look: Look) -> Shape:
    """A binder clip: a folded black or coloured spring with two wire arms."""
    k = look.between(0.8, 1.25)
    color = look.color("black", "black", "red", "blue", "green", "pink", "yellow", "gold")
    x, y, h = 0.032 * k, 0.02 * k, 0.016 * k
    wedge = side_view(np.array([(-y / 2, 0), (y / 2, 0), (0.14 * y, h), (-0.14 * y, h)]), x)
    body = wedge.turn(2, np.pi / 2)
    lips = [cylinder(0.0016 * k, x, 8).turn(1, np.pi / 2).move(-x / 2, s * 0.12 * y, h)
            for s in (-1, 1)]  # fmt: skip
    steel = surfaces.plain((186, 188, 194))
    path = np.array([(-0.3, 0), (-0.14, 0.6), (-0.3, 1.0), (-0.18, 1.25), (0.18, 1.25), (0.3, 1.0),
                     (0.14, 0.6), (0.3, 0)]) * 0.8 * x  # fmt: skip
    wire = tube(np.column_stack([path[:, 0], np.zeros(8), path[:, 1]]), 0.0009 * k, 6)
    folded = look.pick([0.25, 0.25, 2.05])
    loops = [wire.turn(0, -0.25).move(y=0.12 * y, z=h),
             wire.turn(0, folded).move(y=-0.12 * y, z=h)]  # fmt: skip
    skin = surfaces.speckles(look.rng, color, 3, 32)
    return shape([(join([body, *lips]), skin), (join(loops), steel)],
                 [hull_of(body, *lips), *(hull_of(loop) for loop in loops)])  # fmt: skip


@category("hole_punch", size=(0.17, 0.1, 0.0716), mass=0.3, material="metal",
          aliases=("hole puncher", "paper punch", "puncher", "hole-punch", "paper puncher",
          "corner rounder", "embossing tool", "leather hole punch"), themes=("office",),
          colors=("black", "red"))  # fmt: skip
def hole_punch(look: Look) -> Shape:
    """A two-hole punch: a base with a ruler and two punches under a broad lever."""
    k = look.between(0.92, 1.12)
    color = look.color("black", "red", "blue", "silver", "gray", "teal", "green")
    skin, dark = look.surface(color, "metal"), surfaces.speckles(look.rng, (48, 49, 53), 4)
    base = block(0.13 * k, 0.085 * k, 0.012 * k, 0.012, 0.002)
    stand = [box(0.018 * k, 0.035 * k, 0.035 * k).move(s * 0.04 * k, 0.018 * k, 0.011 * k)
             for s in (-1, 1)]  # fmt: skip
    pins = [cylinder(0.004 * k, 0.03 * k, 12).move(s * 0.04 * k, -0.002 * k, 0.014 * k)
            for s in (-1, 1)]  # fmt: skip
    lever = block(0.125 * k, 0.1 * k, 0.014 * k, 0.016, 0.004).turn(0, -0.32)
    lever = lever.move(y=-0.012 * k, z=0.044 * k)
    guide = box(0.1 * k, 0.008 * k, 0.002).move(x=0.055 * k, y=-0.025 * k, z=0.011 * k)
    steel = surfaces.brushed_metal(look.rng, (192, 195, 200))
    return shape([(join([base]), dark), (join([*stand, *pins, guide]), steel), (lever, skin)],
                 [hull_of(base), hull_of(*stand), hull_of(lever)])  # fmt: skip


@category("stamp", size=(0.045, 0.028, 0.08), mass=0.05, material="wood", aliases=("rubber stamp",
          "seal", "self inking stamp", "wooden stamp", "seal stamp", "ink stamp", "seal matrix",
          "date stamp", "signet seal"), themes=("office",), roles=("tall",),
          colors=("wooden", "black"))  # fmt: skip
def stamp(look: Look) -> Shape:
    """A rubber stamp with a turned wooden grip, or a self-inking stamp."""
    color = look.color("wooden", "brown", "black", "red", "tan", "blue")
    if look.chance(0.65):
        h = look.between(0.07, 0.09)
        x, y = (look.between(0.036, 0.05), look.between(0.022, 0.03))
        wood = look.surface(color, "wood")
        foot = block(x, y, 0.012, 0.003, 0.001).move(z=0.004)
        rubber = block(0.94 * x, 0.92 * y, 0.0045, 0.002)
        grip = lathe([(0, 0.014), (0.011, 0.014), (0.0065, 0.03), (0.0055, 0.042), (0.012, 0.9 * h),
                      (0.0125, 0.95 * h), (0.008, h), (0, h)], 22)  # fmt: skip
        red = surfaces.plain(look.own_color("crimson", "red", "navy"))
        return shape([(join([foot, grip]), wood), (rubber, red)],
                     [hull_of(foot), hull_of(rubber), hull_of(grip)])  # fmt: skip
    x, y, h = 0.05, 0.032, look.between(0.075, 0.09)
    frame = join([box(0.008, y, 0.03).move(x=s * (x / 2 - 0.004)) for s in (-1, 1)])
    rail = [box(x, 0.006, 0.004).move(y=s * (y / 2 - 0.003)) for s in (-1, 1)]
    cap = block(x + 0.004, y + 0.002, h - 0.028, 0.01, 0.004).move(z=0.028)
    face = prints.canvas(64, 48, (246, 246, 242))
    prints.fill(face, 0.06, 0.1, 0.88, 0.8, (196, 42, 40))
    prints.fill(face, 0.1, 0.16, 0.8, 0.68, (246, 246, 242))
    prints.write(
        face, look.pick(["PAID", "COPY", "OK", "SENT"]), 0.5, 0.5, 0.4, (196, 42, 40), True
    )
    window = box(0.8 * x, 0.0006, 0.4 * h).move(y=-y / 2 - 0.001, z=0.42 * h)
    return shape([(join([frame, *rail]), surfaces.plain((50, 51, 55))),
                  (cap, look.surface(color)), (window, face)],
                 [box_part(x, y, 0.03), hull_of(cap)])  # fmt: skip


@category("ink_pad", size=(0.0984, 0.105, 0.0668), mass=0.09, material="metal", assembled=True,
          aliases=("inkpad", "stamp pad", "stamp ink pad", "ink"), themes=("office",),
          colors=("black", "navy"), state="lying open")  # fmt: skip
def ink_pad(look: Look) -> Shape:
    """An ink pad with its lid open behind it."""
    x, y, h = look.between(0.085, 0.11), look.between(0.058, 0.075), 0.014
    color = look.color("black", "navy", "red", "silver", "green", "purple")
    ink = look.own_color("navy", "black", "red", "blue", "purple", "green")
    tray = join(open_box(x, y, h, 0.004, 0.003))
    pad = block(x - 0.009, y - 0.009, h - 0.004, 0.002).move(z=0.0025)
    lid = block(x, y, 0.01, 0.003, 0.001).turn(0, -1.85).move(y=y / 2 + 0.45 * y * 0.28, z=0.0)
    lid = lid.move(y=0.2 * y, z=-float(lid.bounds[0, 2]) + 0.002)
    sign = surfaces.plain(tint_color(color, 0.8))
    felt = surfaces.fabric(look.rng, tint_color(ink, 0.8))
    skin = look.surface(color, "metal")
    return shape([(tray, skin), (pad, felt), (lid, sign)],
                 [*frame_parts(x, y, h, 0.004, h - 0.003), hull_of(lid)])  # fmt: skip


@category("thumbtacks", size=(0.0752, 0.074, 0.0118), mass=0.004, material="metal", assembled=True,
          aliases=("brad fastener", "box of thumbtacks", "box of drawing pins"), themes=("office",),
          roles=("flat",), colors=("red", "blue"), state="lying flat",
          noun="pile of thumbtacks")  # fmt: skip
def thumbtacks(look: Look) -> Shape:
    """A small heap of push pins."""
    color = look.color(*RAINBOW[:8])
    mixed = look.chance(0.7)
    pin = lathe([(0, 0), (0.005, 0), (0.005, 0.0015), (0.0028, 0.003), (0.0032, 0.009),
                 (0.0046, 0.0105), (0.0046, 0.012), (0, 0.012)], 12)  # fmt: skip
    needle = cylinder(0.0006, 0.0105, 6, top=0.0001).move(z=0.012)
    lean = np.pi / 2 + np.arctan2(0.0045, 0.0225)
    pieces, parts = [], []
    for n in range(int(look.rng.integers(5, 9))):
        away, turn = 0.016 * np.sqrt(n), 2.4 * n + look.between(-0.4, 0.4)
        spin = look.between(0, 6.28)
        both = [s.turn(1, lean).turn(2, spin) for s in (pin, needle)]
        low = min(float(s.bounds[0, 2]) for s in both)
        both = [s.move(away * np.cos(turn), away * np.sin(turn), -low) for s in both]
        tone = look.own_color(*RAINBOW[:8]) if mixed else color
        pieces += [(both[0], surfaces.plain(tone)), (both[1], surfaces.plain((190, 192, 198)))]
        parts.append(hull_of(*both))
    return shape(pieces, parts)


@category("folder", size=(0.311, 0.251, 0.013), mass=0.12, material="paper",
          aliases=("document folder", "file folder", "manila folder", "paper folder", "dossier",
          "folder of documents", "portfolio", "file"), themes=("office",),
          roles=("flat", "support", "big"), colors=("tan", "blue"), state="lying flat")  # fmt: skip
def folder(look: Look) -> Shape:
    """A manila or coloured folder lying flat, with a tab at its back and visible sheets."""
    x, y, h = look.between(0.3, 0.32), look.between(0.225, 0.245), look.between(0.006, 0.014)
    color = look.color("tan", "beige", "beige", "red", "blue", "green", "yellow", "gray")
    card = surfaces.speckles(look.rng, color, 5, 64)
    low = box(x, y, 0.001)
    at = look.pick([-0.3, 0.0, 0.3])
    tab = prism(np.array([(-0.16 * x, 0), (0.16 * x, 0), (0.12 * x, 0.018), (-0.12 * x, 0.018)]),
                0, 0.001).move(x=at * x, y=y / 2)  # fmt: skip
    sheets = box(0.95 * x, 0.94 * y, h - 0.002).move(x=0.006, y=0.008, z=0.001)
    cover = box(x, y - 0.004, 0.001).bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.004 * (p[:, 1] < 0)])
    ).move(y=-0.002, z=h - 0.001)  # fmt: skip
    image = surfaces.fit(card, 128, 176).copy()
    kind = int(look.rng.integers(3))
    if kind == 0:
        prints.write(image, look.pick(["TOP SECRET", "REPORT", "INVOICES", "2026"]), 0.5, 0.4, 0.12,
                     (176, 40, 40), bold=True)  # fmt: skip
    elif kind == 1:
        prints.fill(image, 0.3, 0.3, 0.4, 0.24, (248, 247, 242))
        prints.lines(image, look.rng, (0.34, 0.36, 0.32, 0.14), 3, (90, 90, 96))
    sign = prints.canvas(64, 16, (248, 247, 242))
    prints.lines(sign, look.rng, (0.1, 0.3, 0.8, 0.5), 1, (60, 60, 66))
    slip = box(0.2 * x, 0.01, 0.0004).move(x=at * x, y=y / 2 + 0.008, z=0.001)
    return shape([(join([low, tab]), card), (sheets, prints.pages(look.rng, (246, 244, 238))),
                  (cover, image), (slip, sign)], [box_part(x, y, h)])  # fmt: skip


@category("tape_dispenser", size=(0.15, 0.05, 0.085), mass=0.4, material="plastic",
          aliases=("sticky tape dispenser", "scotch tape dispenser", "adhesive tape dispenser",
          "tape gun"), themes=("office", "craft"), colors=("black", "teal"),
          common=True)  # fmt: skip
def tape_dispenser(look: Look) -> Shape:
    """A desk dispenser with a roll of adhesive tape."""
    k = look.between(0.92, 1.12)
    color = look.color("black", "teal", "red", "white", "blue", "gray", "pink")
    shell = surfaces.speckles(look.rng, color, 4)
    side = [(-0.075, 0), (0.066, 0), (0.072, 0.018), (0.066, 0.05), (0.052, 0.052), (0.03, 0.026),
            (-0.004, 0.02), (-0.03, 0.03), (-0.056, 0.05), (-0.07, 0.042)]  # fmt: skip
    outline = np.array(side) * k
    walls = [side_view(outline, 0.012 * k).move(y=s * 0.018 * k) for s in (-1, 1)]
    low = np.array([(-0.072, 0), (0.064, 0), (0.064, 0.014), (-0.072, 0.016)])
    base = side_view(low * k, 0.04 * k)
    nose = side_view(np.array([(0.048, 0.012), (0.068, 0.012), (0.064, 0.046), (0.05, 0.044)]) * k,
                     0.03 * k)  # fmt: skip
    roll = lathe([(0.016 * k, -0.0095 * k), (0.034 * k, -0.0095 * k), (0.034 * k, 0.0095 * k),
                  (0.016 * k, 0.0095 * k)], 30, loop=True)  # fmt: skip
    core = cylinder(0.0165 * k, 0.022 * k, 22, bevel=0.001).move(z=-0.011 * k)
    at = (-0.022 * k, 0, 0.05 * k)
    strip = box(0.07 * k, 0.019 * k, 0.0006).turn(1, 0.42).move(0.034 * k, 0, 0.062 * k)
    blade = box(0.002, 0.024 * k, 0.008 * k).move(0.069 * k, 0, 0.044 * k)
    film = surfaces.stripes([(222, 208, 168), (206, 190, 148)], 20)
    hub = surfaces.plain(look.own_color("white", "charcoal", "red"))
    return shape(
        [(join([*walls, base, nose]), shell), (facing(roll).move(*at), film),
         (facing(core).move(*at), hub), (strip, surfaces.plain((216, 204, 170))),
         (blade, tool_steel(look))],
        [hull_of(base), hull_of(nose), hull_of(facing(roll).move(*at)),
         box_part(0.04 * k, 0.04 * k, 0.03 * k, (-0.05 * k, 0, 0.012 * k))],
    )  # fmt: skip


@category("clipboard", size=(0.225, 0.32, 0.0165), mass=0.28, material="wood",
          aliases=("clip board", "checklist"), themes=("office", "medical"), roles=("flat", "big"),
          colors=("brown",), state="lying flat", common=True)  # fmt: skip
def clipboard(look: Look) -> Shape:
    """A clipboard with sheets under its steel clip."""
    x, y = look.between(0.215, 0.235), look.between(0.3, 0.325)
    color = look.color("brown", "wooden", "black", "blue", "pink", "teal")
    word = "oak" if color[0] > color[2] + 40 else "plastic"
    board = block(x, y, 0.004, 0.014)
    sheet = prints.sheet(look.rng, picture=look.chance(0.3))
    if look.chance(0.5):
        sheet = prints.canvas(128, 176, (248, 247, 242))
        for k in range(9):
            prints.fill(sheet, 0.12, 0.18 + 0.085 * k, 0.06, 0.045, (70, 72, 80))
            prints.fill(sheet, 0.135, 0.189 + 0.085 * k, 0.03, 0.026, (248, 247, 242))
            long = look.between(0.3, 0.62)
            prints.fill(sheet, 0.24, 0.194 + 0.085 * k, long, 0.014, (120, 122, 130))
    paper = box(0.21, 0.285, 0.002).move(y=-0.006, z=0.0039)
    plate = block(0.12, 0.03, 0.009, 0.006, 0.002).move(y=y / 2 - 0.02, z=0.004)
    lip = block(0.1, 0.012, 0.012, 0.004, 0.002).move(y=y / 2 - 0.035, z=0.0035)
    bow = tube([(-0.02, y / 2 - 0.01, 0.012), (-0.016, y / 2 + 0.008, 0.014),
                (0.016, y / 2 + 0.008, 0.014), (0.02, y / 2 - 0.01, 0.012)], 0.003, 8)  # fmt: skip
    return shape(
        [(board, look.surface(color, word)), (paper, sheet),
         (join([plate, lip, bow]), tool_steel(look))],
        [box_part(x, y, 0.0058), hull_of(plate), hull_of(lip)],
    )  # fmt: skip


@category("binder", size=(0.065, 0.275, 0.31), mass=0.7, material="paper",
          aliases=("ring binder", "lever arch file", "box file", "file divider"),
          themes=("office",), roles=("tall",), colors=("blue", "black"), common=True)  # fmt: skip
def binder(look: Look) -> Shape:
    """An upright ring binder with its labelled spine towards the viewer."""
    x, y, z = look.between(0.05, 0.08), look.between(0.26, 0.29), look.between(0.3, 0.32)
    color = look.color("blue", "black", "red", "green", "gray", "yellow", "white")
    spine = prints.canvas(48, 200, color)
    prints.fill(spine, 0.14, 0.14, 0.72, 0.4, (246, 245, 240))
    prints.lines(spine, look.rng, (0.24, 0.2, 0.52, 0.2), 4, (70, 72, 90))
    year = str(look.rng.integers(2015, 2027))
    prints.write(spine[82:104, 8:40], year, 0.5, 0.5, 0.6, (60, 60, 70))
    prints.disc(spine, 0.5, 0.84, 0.055, (176, 180, 186))
    prints.disc(spine, 0.5, 0.84, 0.036, tint_color(color, 0.4))
    cover = surfaces.speckles(look.rng, color, 5)
    sides = [box(0.0035, y, z).move(x=s * (x / 2 - 0.00175)) for s in (-1, 1)]
    back = box(x, 0.004, z).move(y=-y / 2 + 0.002)
    front = box(0.96 * x, 0.001, 0.98 * z).move(y=-y / 2 - 0.0004, z=0.01 * z)
    leaves = box(x * look.between(0.5, 0.9), 0.86 * y, 0.94 * z).move(y=-0.05 * y, z=0.004)
    return shape(
        [(join([*sides, back]), cover), (front, spine),
         (leaves, np.rot90(prints.pages(look.rng)).copy())],
        [box_part(x, y, z)],
    )  # fmt: skip


@category("stapler", size=(0.138, 0.034, 0.055), mass=0.2, material="plastic",
          aliases=("electric stapler",), themes=("office",), colors=("black", "red"),
          common=True)  # fmt: skip
def stapler(look: Look) -> Shape:
    """A desk stapler with its jaws slightly open on the left."""
    color = look.color("black", "red", "blue", "teal", "gray", "white", "pink", "yellow", "mint")
    shell, dark = surfaces.speckles(look.rng, color, 4, 32), surfaces.plain((52, 52, 56))
    steel = surfaces.brushed_metal(look.rng, (182, 184, 190))
    length, width = look.between(0.115, 0.155), look.between(0.029, 0.038)
    base = block(length, width, 0.009, 0.012, 0.002)
    rail = block(length * 0.9, width * 0.42, 0.008, 0.004).turn(1, np.deg2rad(3.5))
    arm = block(length * 0.95, width * 0.78, 0.019, 0.012, 0.006).turn(1, np.deg2rad(6))
    hinge = block(0.03, width * 0.86, 0.03, 0.006, 0.003).move(x=length / 2 - 0.016, z=0.006)
    rail, arm = rail.move(x=0.002, z=0.019), arm.move(x=0.004, z=0.033)
    return shape([(base, dark), (rail, steel), (arm, shell), (hinge, shell)],
                 [hull_of(base), hull_of(arm), hull_of(hinge), hull_of(rail)])  # fmt: skip


@category("ruler", size=(0.26, 0.032, 0.0036), mass=0.03, material="plastic",
          aliases=("metre rule", "metre stick", "yardstick", "set square ruler", "scale rule"),
          themes=("office", "craft"), roles=("flat",), state="lying flat", common=True)  # fmt: skip
def ruler(look: Look) -> Shape:
    """A flat ruler with its scale up."""
    wooden = look.material in ("wood", "wooden") or (not look.material and look.chance(0.4))
    color = look.color("wooden") if wooden else look.color("sky", "clear", "yellow", "silver")
    long = look.pick([20, 30])
    x, y, h = long / 100 + 0.012, 0.032, 0.0032
    face = prints.rule(long, color, readable_on(color))
    return shape([(box(x, y, h), surfaces.plain(color)), (box(x, y, 0.0004).move(z=h), face)],
                 [box_part(x, y, h + 0.0004)])  # fmt: skip


@category("rubber_band", size=(0.058, 0.0405, 0.0028), mass=0.001, material="rubber",
          assembled=True,
          aliases=("elastic band", "elastic", "hair band", "elastic band roll", "loom bands"),
          themes=("office",), roles=("flat",), colors=("tan", "red"))  # fmt: skip
def rubber_band(look: Look) -> Shape:
    """A rubber band in a loose loop."""
    k = look.between(0.9, 1.25)
    color = look.color("tan", "red", "blue", "green", "yellow", "tan", "pink")
    a = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    r = 0.022 * k * (1 + 0.14 * np.cos(2 * a + look.between(0, 6)) + 0.06 * np.cos(3 * a))
    h = 0.0028
    way = np.column_stack([1.25 * r * np.cos(a), 0.85 * r * np.sin(a)])
    rings = []
    for x, y in way:
        n = np.array([x, y]) / np.hypot(x, y)
        rings.append([(*(np.array([x, y]) + n * s), z) for s, z in (
            (-0.0006, 0), (0.0006, 0), (0.0006, h), (-0.0006, h))])  # fmt: skip
    band = loft(np.array(rings), np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * 1.0,
                profile=np.column_stack([a, 0 * a]), loop=True)  # fmt: skip
    hulls = []
    for m in range(8):
        index = np.arange(5 * m, 5 * m + 6) % 40
        hulls.append(hull_of(Solid(np.array(rings)[index].reshape(-1, 3), np.zeros((0, 3), int),
                                   np.zeros((24, 2)))))  # fmt: skip
    return shape([(band, surfaces.plain(color))], hulls)


@category("eraser", size=(0.053, 0.0217, 0.0127), mass=0.018, material="rubber",
          aliases=("rubber", "pencil eraser", "rubber eraser"), themes=("office", "craft"),
          roles=("flat",), colors=("white", "pink"), state="lying flat")  # fmt: skip
def eraser(look: Look) -> Shape:
    """An eraser: white in a printed sleeve, pink and slanted, or in two colours."""
    x, y, h = look.between(0.045, 0.06), look.between(0.019, 0.024), look.between(0.011, 0.014)
    kind = look.pick(["sleeve", "sleeve", "pink", "two"])
    if kind == "sleeve":
        color = look.color("blue", "black", "green", "red", "navy", "teal", "orange")
        core = block(x, y, h, 0.002, 0.001)
        image = prints.canvas(96, 40, color)
        prints.fill(image, 0, 0, 0.3, 1, tint_color(color, 0.6))
        prints.fill(image, 0.3, 0, 0.05, 1, (248, 248, 246))
        prints.write(image[:, 36:], look.pick(["ERASER", "SOFT", "PLAST", "RUB"]), 0.5, 0.5, 0.42,
                     (248, 248, 246), bold=True)  # fmt: skip
        sleeve = box(0.66 * x, y + 0.0008, h + 0.0006).move(x=0.14 * x)
        white = surfaces.speckles(look.rng, look.pick([(246, 246, 244), (232, 238, 246)]), 4, 32)
        return shape([(core.move(z=0.0003), white), (sleeve, image)],
                     [box_part(x, y, h, (0, 0, 0.0003)), box_part(0.66 * x, y, h + 0.0003,
                                                                  (0.14 * x, 0, 0))])  # fmt: skip
    outline = np.array([(-0.5 * x, 0), (0.38 * x, 0), (0.5 * x, h), (-0.38 * x, h)])
    body = side_view(outline, y, 0.001)
    color = look.color("pink", "coral", "pink", "sky", "lime")
    tile = surfaces.speckles(look.rng, color, 5, 32)
    if kind == "pink":
        sign = prints.canvas(96, 32, color)
        prints.write(
            sign, look.pick(["PINK", "SCHOOL", "RUBBER"]), 0.5, 0.5, 0.5, tint_color(color, 0.4)
        )
        plate = box(0.6 * x, 0.7 * y, 0.0003).move(z=h - 0.0001)
        return shape([(body, tile), (plate, sign)], [hull_of(body)])
    half = surfaces.speckles(look.rng, look.own_color("blue", "navy", "gray"), 5, 32)
    cut = side_view(np.array([(0.1 * x, -0.0002), (0.39 * x, -0.0002), (0.505 * x, h + 0.0004),
                              (0.1 * x, h + 0.0004)]), y + 0.0006,
                    0.001).move(z=0.0002)  # fmt: skip
    return shape([(body, tile), (cut, half)], [hull_of(body, cut)])


@category("pencil_sharpener", size=(0.032, 0.0331, 0.029), mass=0.015, material="plastic",
          assembled=True, aliases=("sharpener", "electric sharpener"), themes=("office", "craft"),
          colors=("red", "silver"))  # fmt: skip
def pencil_sharpener(look: Look) -> Shape:
    """A pencil sharpener: a small wedge with a blade, a tub, or a machine with a crank."""
    color = look.color("red", "blue", "silver", "green", "yellow", "pink", "black", "orange")
    steel = surfaces.brushed_metal(look.rng, (196, 199, 204))
    dark = surfaces.plain((36, 36, 40))
    kind = look.pick(["wedge", "wedge", "tub", "crank"])
    if kind == "wedge":
        x, y, h = 0.027, 0.0155, 0.0125
        body = prism(np.array([(-x / 2, -y / 2), (x / 2, -0.36 * y), (x / 2, 0.36 * y),
                               (-x / 2, y / 2)]), 0, h, 0.001)  # fmt: skip
        ribs = [box(0.0016, 1.04 * y, 0.7 * h).move(0.1 * x + 0.004 * k, 0, 0.15 * h)
                for k in range(-1, 3)]  # fmt: skip
        blade = box(0.023, 0.009, 0.0012).turn(2, 0.12).move(0, -0.001, h - 0.0002)
        screw = cylinder(0.0024, 0.002, 14).move(0.001, -0.001, h)
        slot = box(0.004, 0.0006, 0.0004).move(0.001, -0.001, h + 0.0018)
        hole = cylinder(0.0042, 0.0006, 16).turn(1, np.pi / 2).move(x=-x / 2 - 0.0003, z=0.5 * h)
        skin = look.surface(color, look.pick(["plastic", "metal"]))
        return shape([(join([body, *ribs]), skin), (join([blade, screw]), steel),
                      (join([hole, slot]), dark)],
                     [hull_of(body), hull_of(blade)]).scale(1.15)  # fmt: skip
    if kind == "tub":
        r, h = 0.019, look.between(0.034, 0.044)
        tub = lathe([(0, 0), (0.9 * r, 0), (r, 0.004), (r, 0.7 * h), (0, 0.7 * h)], 26)
        lid = lathe([(0, 0.7 * h), (1.03 * r, 0.7 * h), (1.03 * r, 0.86 * h), (0.7 * r, h),
                     (0, h)], 26)  # fmt: skip
        hole = cylinder(0.0045, 0.0006, 16).move(x=0.005, z=h - 0.0002)
        shavings = surfaces.speckles(look.rng, (222, 206, 176), 20, 32)
        clear = surfaces.stack((shavings, 4), (surfaces.plain(tint_color(color, 1.6)), 6))
        return shape([(tub, clear), (lid, surfaces.plain(color)), (hole, dark)],
                     [hull_of(tub), hull_of(lid)])  # fmt: skip
    body = block(0.055, 0.07, 0.09, 0.012, 0.004)
    drawer = box(0.04, 0.003, 0.035).move(y=-0.036, z=0.012)
    face = cylinder(0.02, 0.012, 26, bevel=0.002).turn(0, np.pi / 2).move(y=-0.034, z=0.067)
    hole = cylinder(0.0048, 0.001, 16).turn(0, np.pi / 2).move(y=-0.0458, z=0.067)
    arm = [
        cylinder(0.005, 0.02, 12).turn(0, -np.pi / 2).move(y=0.034, z=0.06),
        tube([(0, 0.052, 0.06), (0.02, 0.052, 0.095)], 0.004, 8),
        cylinder(0.007, 0.024, 12, bevel=0.001).turn(0, -np.pi / 2).move(0.02, 0.05, 0.095),
    ]
    skin = surfaces.speckles(look.rng, color, 3, 32)
    return shape([(body, skin), (drawer, surfaces.plain(tint_color(color, 1.5))),
                  (join([face, *arm]), steel), (hole, dark)],
                 [hull_of(body), hull_of(face), hull_of(*arm)]).scale(0.55)  # fmt: skip


def _lying(profile: list[tuple[float, float]], sides: int) -> Solid:
    """Return a solid of revolution with ``sides`` facets, lying along x on z = 0."""
    rod = lathe(profile, sides).turn(1, np.pi / 2)
    low, high = rod.bounds
    return rod.move(x=-(low[0] + high[0]) / 2, z=-low[2])


@category("pen", size=(0.145, 0.0105, 0.0125), mass=0.012, material="plastic",
          aliases=("ballpoint pen", "fountain pen", "stylus", "tablet pen", "rollerball pen",
          "four colour pen", "four-colour pen", "red pen", "blue pen", "fineliner", "pen refill",
          "stylus pen", "black pen", "gel pen", "biro"), themes=("office",), roles=("flat",),
          colors=("blue", "black", "red"), state="lying flat", common=True)  # fmt: skip
def pen(look: Look) -> Shape:
    """A ballpoint pen lying flat, with a tip, a barrel, a grip and a clip."""
    r, length = look.between(0.0048, 0.0056), look.between(0.138, 0.15)
    color = look.color(
        "blue", "black", "red", "green", "silver", "white", "teal", "pink", "gold", "purple"
    )
    metal = look.pick([(188, 190, 196), (188, 190, 196), (200, 164, 84), (50, 50, 54)])
    barrel = _lying([(0, 0), (0.0012, 0), (r, 0.026), (r, length - 0.008),
                     (0.6 * r, length - 0.007), (0.6 * r, length), (0, length)], 12)  # fmt: skip
    tile = surfaces.stripes([metal, look.pick([tint_color(color, 0.6), (44, 44, 48)]), color, color,
                             look.pick([color, tint_color(color, 1.5)]), color, color, metal],
                            side=64)  # fmt: skip
    clip = box(0.045, 0.0028, 0.0016).move(x=length / 2 - 0.034, z=2 * r + 0.0006)
    knob = box(0.006, 0.0028, 0.0022).move(x=length / 2 - 0.014, z=2 * r - 0.001)
    return shape([(barrel, tile), (clip, surfaces.plain(metal)), (knob, surfaces.plain(metal))],
                 [box_part(length - 0.03, 1.7 * r, 2 * r, (0.014, 0, 0)),
                  hull_part(barrel.vertices[barrel.vertices[:, 0] < -length / 2
                                            + 0.03])])  # fmt: skip


@category("pencil", size=(0.173, 0.0078, 0.0068), mass=0.006, material="wood",
          aliases=("colored pencil", "carpenter pencil", "mechanical pencil", "pencil extender",
          "lead refill tube"), themes=("office", "craft"), roles=("flat",),
          colors=("yellow", "red"), state="lying flat", common=True)  # fmt: skip
def pencil(look: Look) -> Shape:
    """A painted, six-sided wooden pencil lying on a facet, with a lead, a ferrule and an eraser."""
    r, length = 0.0039, look.between(0.16, 0.185)
    color = look.color(
        *("yellow", "yellow", "red", "blue", "green", "black", "orange", "wooden", "pink", "white")
    )
    rod = _lying([(0, 0), (0.0009, 0.004), (r, 0.022), (r, length - 0.016), (r, length - 0.002),
                  (0.9 * r, length), (0, length)], 6)  # fmt: skip
    tile = surfaces.stripes([(50, 50, 54), (222, 186, 132), (222, 186, 132), *[color] * 24,
                             (190, 170, 90), (190, 170, 90), (226, 140, 146), (226, 140, 146),
                             (226, 140, 146)])  # fmt: skip
    return shape([(rod, tile)], [hull_of(rod)])


@category("marker", size=(0.128, 0.018, 0.018), mass=0.02, material="plastic",
          aliases=("felt pen", "whiteboard marker", "felt-tip pen", "felt tip", "felt tip pen"),
          themes=("office", "craft"), roles=("flat",), colors=("red", "blue", "green"),
          state="lying flat", common=True)  # fmt: skip
def marker(look: Look) -> Shape:
    """A thick felt-tip pen with its cap on, lying flat."""
    r, length = look.between(0.0085, 0.0095), look.between(0.12, 0.135)
    color = look.color(
        "red", "blue", "green", "black", "purple", "orange", "pink", "yellow", "teal"
    )
    barrel = look.pick([(240, 240, 236), (240, 240, 236), (44, 44, 48), color])
    body = _lying([(0, 0), (r * 0.92, 0), (r * 0.92, length * 0.66), (0, length * 0.66)], 16)
    cap = _lying(
        [(0, 0), (r, 0), (r, 0.32 * length), (0.72 * r, 0.38 * length), (0, 0.38 * length)], 16
    )
    shell = surfaces.stripes([color, barrel, barrel, color, barrel, color], side=48)
    return shape([(body.move(x=-0.17 * length, z=0.08 * r), shell), (cap.move(x=0.31 * length),
                                                                     surfaces.plain(color))],
                 [box_part(0.66 * length, 1.5 * r, 1.84 * r, (-0.17 * length, 0, 0.08 * r)),
                  box_part(0.36 * length, 1.5 * r, 2 * r, (0.31 * length, 0, 0))])  # fmt: skip


@category("pencil_case", size=(0.2, 0.072, 0.052), mass=0.15, material="fabric", hollow=True,
          aliases=("pencil pouch", "pouch", "razor case", "crayon roll", "recorder case",
          "tool roll", "baby pouch"), themes=("office", "craft"), colors=("navy", "teal"),
          state="lying flat", common=True)  # fmt: skip
def pencil_case(look: Look) -> Shape:
    """A soft, zipped pencil case, lying flat."""
    x, y, h = look.between(0.19, 0.21), look.between(0.065, 0.08), look.between(0.045, 0.055)
    cloth = surfaces.fabric(look.rng, look.color("navy", "teal", "red", "gray", "pink", "mustard"))
    body = prism(rectangle(x, y, 0.03), 0, h, 0.012)
    zipper = box(0.8 * x, 0.007, 0.0015).move(z=h - 0.0005)
    teeth = surfaces.stripes([(60, 60, 64), (190, 190, 194)], 24, upright=True)
    pull = prism(ellipse(0.016, 0.008, 12), 0, 0.002).move(x=0.36 * x, z=h)
    return shape([(body, cloth), (zipper, teeth), (pull, surfaces.plain((196, 170, 90)))],
                 [hull_of(body)])  # fmt: skip


@category("desk_bell", size=(0.0862, 0.0862, 0.0835), mass=0.2, material="metal", aliases=("bell",
          "call bell", "service bell", "reception bell", "counter bell", "table bell",
          "hotel bell"), themes=("office", "dining"), roles=("round",),
          colors=("silver", "gold"))  # fmt: skip
def desk_bell(look: Look) -> Shape:
    """A reception bell (a metal dome with a button on a round base), or a hand bell."""
    r = look.between(0.037, 0.045)
    color = look.color("silver", "silver", "gold", "brass", "copper", "red", "black")
    metal = look.surface(color, "metal")
    if look.chance(0.7):
        base = lathe([(0, 0), (1.1 * r, 0), (1.1 * r, 0.006), (0.95 * r, 0.012), (0, 0.012)], 32)
        t = np.linspace(0, np.pi / 2, 9)
        dome = lathe([(0, 0.02), *((r * np.cos(a) ** 0.75, 0.02 + 0.62 * r * np.sin(a))
                                   for a in t[:-1]), (0, 0.02 + 0.62 * r)], 32)  # fmt: skip
        post = cylinder(0.009, 0.012, 14).move(z=0.011)
        knob = lathe(
            [(0, 0), (0.004, 0), (0.004, 0.006), (0.009, 0.008), (0.008, 0.013), (0, 0.015)], 18
        )
        knob = knob.move(z=0.018 + 0.62 * r)
        dark = surfaces.speckles(look.rng, look.own_color("black", "brown", "black"), 3, 32)
        return shape([(base, dark), (join([dome, post, knob]), metal)],
                     [hull_of(base), cylinder_part(0.009, 0.012, (0, 0, 0.011)), hull_of(dome),
                      hull_of(knob)])  # fmt: skip
    bell = lathe([(0, 0.006), (0.85 * r, 0), (r, 0.001), (0.7 * r, 0.6 * r), (0.5 * r, 1.4 * r),
                  (0.2 * r, 1.6 * r), (0, 1.62 * r)], 28)  # fmt: skip
    grip = lathe([(0, 1.6 * r), (0.1 * r, 1.6 * r), (0.24 * r, 1.9 * r), (0.16 * r, 2.5 * r),
                  (0.26 * r, 3.0 * r), (0, 3.1 * r)], 16)  # fmt: skip
    wood = surfaces.wood(look.rng, look.pick([(112, 76, 50), (60, 46, 42), (176, 128, 80)]))
    return shape([(bell, metal), (grip, wood)], [hull_of(bell), hull_of(grip)])


WHITE = surfaces.plain((244, 243, 240))


@category("watercolour_set", size=(0.189, 0.108, 0.078), mass=0.2, material="metal",
          aliases=("watercolor set", "watercolour box", "watercolor box", "watercolour pan set",
          "paint set", "paint box", "watercolor palette", "watercolour palette", "face paint set",
          "watercolor paint set", "watercolour paints"), themes=("office",),
          colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def watercolour_set(look: Look) -> Pieces:
    """An open watercolour box with two rows of pans, a lid behind and a brush."""
    case = metal(look, "black", "white", "silver", "red")
    body, lid = (at_block(0.19, 0.075, 0.014, 0.006),
                 at_block(0.19, 0.075, 0.008, 0.006).turn(0, 1.1))  # fmt: skip
    lid = lid.move(0, 0.055, 0.042)
    inner = at_block(0.178, 0.066, 0.001, 0.004, (0, 0, 0.0137))
    names = ("yellow", "orange", "red", "pink", "purple", "blue", "sky", "teal", "green", "lime",
             "brown", "black")  # fmt: skip
    pieces: Pieces = [(body, case), (lid.move(z=-min(float(lid.bounds[0, 2]), 0.0)), case),
                      (inner, WHITE)]  # fmt: skip
    for k, name in enumerate(names):
        pieces.append((at_block(0.023, 0.019, 0.003, 0.003, (-0.0725 + 0.029 * (k % 6), 0.019
                                                             - 0.024 * (k // 6), 0.0145)),
                       dye(look, name)))  # fmt: skip
    brush = [spindle((-0.06, 0.0022), (0.03, 0.003), z=0.0185).move(y=-0.027),
             spindle((0.03, 0.0028), (0.05, 0.0006), z=0.0185).move(y=-0.027)]  # fmt: skip
    return [*pieces, (brush[0], dye(look, "red", "black")), (brush[1], dye(look, "brown"))]


@category("stencil", size=(0.2, 0.13, 0.0014), mass=0.015, material="paper",
          aliases=("letter stencil", "drawing stencil", "lettering stencil", "stencil sheet",
          "shape template"), themes=("office",), roles=("flat",), colors=("green",))  # fmt: skip
@from_pieces()
def stencil(look: Look) -> Pieces:
    """A thin coloured stencil with cut-out letters, or with circles above rectangles."""
    color = look.color("green", "blue", "orange", "yellow", "beige")
    image = prints.canvas(144, 96, color)
    hole = (246, 244, 238)
    kind = int(look.rng.integers(2))
    if kind:
        for k, letter in enumerate("ABCDEFGHIJKL"):
            prints.write(
                image, letter, 0.13 + 0.15 * (k % 6), 0.32 + 0.36 * (k // 6), 0.26, hole, True
            )
    else:
        for k in range(4):
            prints.disc(image, 0.16 + 0.225 * k, 0.3, 0.05 + 0.035 * k, hole)
            s = 0.06 + 0.03 * k
            prints.fill(image, 0.16 + 0.225 * k - s / 2, 0.74 - s * 0.75, s, 1.5 * s, hole)
    return [
        (at_block(0.2, 0.13, 0.0012, 0.006), surfaces.plain(color)),
        (at_box(0.19, 0.12, 0.0004, (0, 0, 0.001)), image),
    ]


@category("french_curve", size=(0.217, 0.103, 0.0022), mass=0.02, material="plastic",
          aliases=("curve template", "drawing template", "drawing curve"), themes=("office",),
          colors=("clear",))  # fmt: skip
@from_pieces(bodies=1)
def french_curve(look: Look) -> Pieces:
    """A French curve: a clear template with swirls and cut-outs."""
    color = look.color("clear", "green", "orange", "sky")
    outline = smooth([(-0.1, -0.02), (-0.06, -0.05), (0.0, -0.03), (0.05, -0.045), (0.11, -0.03),
                      (0.115, 0.0), (0.08, 0.012), (0.05, 0.0), (0.0, 0.028), (-0.04, 0.052),
                      (-0.085, 0.04), (-0.1, -0.02)], 6)[:-1]  # fmt: skip
    body = plate(outline, 0.002)
    holes = [disc(r, 0.0004, sides=20).scale(1.5, 1, 1).move(x, y, 0.0018) for r, x,
             y in ((0.016, -0.06, 0.005), (0.009, 0.01, -0.01), (0.009, 0.075, -0.02))]  # fmt: skip
    return [(body, surfaces.plain(tint_color(color, 1.2))),
            (join(holes), surfaces.plain(tint_color(color, 0.75)))]  # fmt: skip


@category("t_square", size=(0.42, 0.2, 0.008), mass=0.15, material="wood",
          aliases=("tee square", "drafting square", "t-square"), themes=("office",),
          colors=("wooden",))  # fmt: skip
@from_pieces()
def t_square(look: Look) -> Pieces:
    """A wooden T-square lying flat: a head on the left and a long blade with a scale."""
    tile = wood(look, "wooden", "tan", "beige")
    blade = at_box(0.4, 0.04, 0.003, (0.02, 0, 0.004))
    head = at_box(0.03, 0.2, 0.008, (-0.185, 0, 0))
    scale = prints.rule(20, (236, 214, 166), (60, 46, 34))
    foot = at_box(0.03, 0.03, 0.0045, (0.2, 0, 0))
    return [(blade, tile), (head, tile), (foot, tile), (at_box(0.39, 0.01, 0.0005,
                                                               (0.02, 0.014, 0.0068)),
                                                        scale)]  # fmt: skip


@category("geometry_set", size=(0.2, 0.13, 0.095), mass=0.25, material="metal",
          aliases=("maths set", "math set", "compass set", "drawing set", "geometry tin",
          "mathematical instruments"), themes=("office",), colors=("silver",))  # fmt: skip
@from_pieces(bodies=6)
def geometry_set(look: Look) -> Pieces:
    """An open tin of drawing tools: compasses, a set square, a protractor, a ruler and a pencil."""
    tile = metal(look, "silver", "blue", "red", "gold")
    floor = at_box(0.2, 0.1, 0.002)
    sides = [at_box(0.2, 0.002, 0.018, (0, s * 0.049, 0)) for s in (-1, 1)] + [
        at_box(0.002, 0.1, 0.018, (s * 0.099, 0, 0)) for s in (-1, 1)
    ]
    lid = at_box(0.2, 0.1, 0.002).turn(0, 1.9).move(0, 0.066, 0.046)
    ruler = at_box(0.17, 0.022, 0.002, (0, 0.034, 0.002))
    square = plate([(-0.09, -0.03), (-0.02, -0.03), (-0.09, 0.015)], 0.002, 0.003)
    half = plate(arc((0.045, -0.008), 0.036, 0, np.pi, 16), 0.002, 0.003)
    legs = [
        straight((0.0, -0.02, 0.008), (0.08, -0.03 + 0.014 * k, 0.006), 0.0026, 8) for k in (0, 1)
    ]
    pencil = spindle((-0.06, 0.0035), (0.06, 0.0035), (0.07, 0.0004), sides=6, z=0.008).move(
        y=-0.04
    )
    return [(floor, tile), *((s, tile) for s in sides), (lid.move(z=-float(lid.bounds[0, 2])),
                                                         tile),
            (ruler, prints.rule(15, (244, 232, 160), (50, 50, 54))),
            (square, surfaces.plain((150, 206, 180))), (half, surfaces.plain((240, 170, 150))),
            (join(legs), shine(look)), (pencil, surfaces.plain((240, 190, 50)))]  # fmt: skip
