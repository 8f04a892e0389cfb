"""Objects of the ``vanity`` theme: fixtures."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import DARK, steel
from ...kit.outlines import ellipse, rectangle
from ...kit.parts import cylinder_part, frame_parts, hull_of, hull_part, open_vessel
from ...kit.primitives import ball, drum, facing, rod, standing
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...kit.surfaces import Look, plain, tint_color


@category("soap_dish", size=(0.13, 0.092, 0.028), mass=0.15, material="ceramic", hollow=True,
          aliases=("soap tray", "soap holder", "dish for soap", "empty soap dish"),
          themes=("vanity",), roles=("container", "support"), colors=("white",))  # fmt: skip
def soap_dish(look: Look) -> Shape:
    """An open soap dish with ridges."""
    x, y, h = look.between(0.12, 0.14), look.between(0.085, 0.1), look.between(0.024, 0.032)
    color = look.color("white", "teal", "wooden", "gray", "pink", "navy", "sage")
    outline = rectangle(1, 1, 0.2, 5)
    t = 0.0045
    levels = [(x - 0.02, y - 0.02, 0), (x, y, h), (x - 2 * t, y - 2 * t, h),
              (x - 0.02 - 2 * t, y - 0.02 - 2 * t, t)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b], np.full(len(outline), z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    ribs = join([block(0.007, y - 0.04, 0.003, 0.003).move(x=0.017 * n, z=t - 0.0005)
                 for n in range(-2, 3)])  # fmt: skip
    skin = look.surface(color, "ceramic")
    return shape([(body, skin), (ribs, surfaces.plain(tint_color(color, 0.9)))],
                 frame_parts(x - 0.012, y - 0.012, h, t, t))  # fmt: skip


@category("sink", size=(0.37, 0.44, 0.27), mass=4.0, material="ceramic", aliases=("washbasin",
          "wash basin", "hand basin", "bathroom sink", "kitchen sink", "vessel sink"),
          themes=("vanity",), roles=("container", "big"), colors=("white",))  # fmt: skip
def sink(look: Look) -> Shape:
    """A countertop washbasin with a tap behind it."""
    r, h = look.between(0.17, 0.2), look.between(0.11, 0.13)
    side = [(0.62 * r, 0), (0.8 * r, 0.3 * h), (0.94 * r, 0.7 * h), (r, h)]
    basin, parts = open_vessel(side, 0.012, 0.014)
    reach = r + 0.035
    neck = [(0, reach, 0), (0, reach, 1.7 * h), (0, reach - 0.03, 1.95 * h),
            (0, reach - 0.1, 1.95 * h), (0, reach - 0.12, 1.8 * h)]  # fmt: skip
    tap = join([tube(neck, 0.012, 14), cylinder(0.026, 0.012, 20).move(y=reach),
                cylinder(0.016, 0.03, 16).move(y=reach, z=1.95 * h),
                box(0.05, 0.01, 0.008).move(y=reach, z=1.95 * h + 0.03)])  # fmt: skip
    drain = cylinder(0.022, 0.002, 20).move(z=0.0145)
    steel = surfaces.brushed_metal(look.rng, (196, 200, 204))
    glaze = look.surface(look.color("white", "white", "cream", "charcoal"), "ceramic")
    return shape(
        [(basin, glaze), (join([tap, drain]), steel)],
        [*parts, cylinder_part(0.026, 2 * h, at=(0, reach, 0))],
    )


@category("soap_dispenser", size=(0.068, 0.08, 0.155), mass=0.35, material="plastic",
          aliases=("hand soap",), themes=("vanity", "kitchen"), roles=("tall",),
          colors=("white", "teal"), common=True)  # fmt: skip
def soap_dispenser(look: Look) -> Shape:
    """A soap pump bottle with its spout towards the viewer."""
    r, h = look.between(0.03, 0.036), look.between(0.105, 0.125)
    color = look.color("white", "teal", "amber", "pink", "gray", "sage")
    word = look.pick(["SOAP", "LOTION", "HANDS"])
    print_ = prints.label(look.rng, word, tint_color(color, 0.55), tint_color(color, 1.1))
    body = lathe([(0, 0), (r - 0.004, 0), (r, 0.004), (r, 0.8 * h), (0.8 * r, 0.93 * h),
                  (0.4 * r, h), (0, h)], v=[0, 0, 0.02, 0.8, 0.9, 0.98, 1])  # fmt: skip
    pump = surfaces.speckles(look.rng, look.own_color("white", "black", "silver", "gold"), 3)
    collar = cylinder(0.014, 0.012, 18, bevel=0.001).move(z=h)
    stem = cylinder(0.0045, 0.024, 12).move(z=h + 0.01)
    spout = tube([(0, 0.008, h + 0.036), (0, -0.02, h + 0.036), (0, -0.042, h + 0.03)], 0.0065, 10)
    return shape([(body, print_), (collar, pump), (stem, pump), (spout, pump)],
                 [cylinder_part(r, 0.82 * h), hull_part(body.vertices[body.vertices[:, 2] > 0.75
                                                                      * h]),
                  cylinder_part(0.014, 0.012, (0, 0, h)), cylinder_part(0.0045, 0.022,
                                                                        (0, 0, h + 0.012)),
                  hull_of(spout)])  # fmt: skip


@category("toothbrush_cup", size=(0.08, 0.072, 0.18), mass=0.28, material="ceramic", hollow=True,
          aliases=("toothbrush holder", "tumbler for toothbrushes"), themes=("vanity",),
          roles=("tall",), colors=("white",), opened="plastic_cup", common=True)  # fmt: skip
def toothbrush_cup(look: Look) -> Shape:
    """A tumbler with two toothbrushes standing in it."""
    r, h = 0.036, look.between(0.095, 0.108)
    color = look.color("white", "mint", "sky", "gray", "pink")
    cup = cylinder(r * 0.9, h, 28, top=r, bevel=0.002)
    dark = surfaces.plain(tint_color(color, 0.45))
    inside = cylinder(r * 0.9, 0.0015, 28).move(z=h - 0.0008)
    pieces = [(cup, look.surface(color, "ceramic")), (inside, dark)]
    parts = [cylinder_part(r, h)]
    for side in (-1, 1):
        tint = surfaces.plain(look.own_color("blue", "red", "green", "violet", "orange"))
        stick = tube([(side * 0.01, 0, h - 0.02), (side * 0.03, 0.004, h + 0.07)], 0.0042, 8)
        head = box(0.011, 0.012, 0.024).move(side * 0.031, -0.004, h + 0.058)
        pieces += [(stick, tint), (head, surfaces.plain((240, 242, 244)))]
        parts.append(hull_of(stick, head))
    return shape(pieces, parts)


@category("toilet_brush", size=(0.0843, 0.0843, 0.314), mass=0.4, material="plastic",
          assembled=True, aliases=("loo brush", "toilet brush holder", "lavatory brush"),
          themes=("vanity",), roles=("tall",), colors=("white",))  # fmt: skip
def toilet_brush(look: Look) -> Shape:
    """A toilet brush standing in its holder."""
    color = look.color("white", "black", "silver", "teal", "gray")
    k = look.between(0.75, 0.95)
    pot = standing((0.048, 0), (0.05, 0.004), (0.046, 0.12), (0.04, 0.126), sides=28)
    hole = drum(0.037, 0.0008, (0, 0, 0.1256))
    collar = drum(0.03, 0.006, (0, 0, 0.126), top=0.01)
    stick = drum(0.0075, 0.23, (0, 0, 0.13), top=0.009, sides=14)
    end = ball(0.024, 0.024, 0.02, (0, 0, 0.362), 12)
    return put_down([(pot, look.surface(color, "plastic")), (hole, plain(DARK)),
                     (join([collar, stick, end]), plain(tint_color(color, 0.85)))], pot, stick,
                    factor=k)  # fmt: skip


@category("shower_head", size=(0.238, 0.0935, 0.025), mass=0.25, material="metal",
          aliases=("showerhead", "hand shower", "shower handset"), themes=("vanity",),
          roles=("big",), colors=("silver",))  # fmt: skip
def shower_head(look: Look) -> Shape:
    """A handheld shower head lying with its nozzles up."""
    color = look.color("silver", "white", "black", "gold")
    k = look.between(0.85, 1.1)
    head = standing((0.02, 0), (0.046, 0.012), (0.05, 0.018), (0.05, 0.026), sides=32)
    face = drum(0.045, 0.0012, (0, 0, 0.0255), sides=32)
    handle = rod([(0.03, 0, 0.013), (0.09, 0, 0.012), (0.19, 0, 0.014)], [0.013, 0.011, 0.0125], 14)
    collar = drum(0.0115, 0.02, (0.185, 0, 0.014), 0, sides=14)
    holes = prints.mesh_holes((200, 204, 208), (60, 62, 68), 10, 10)
    return put_down([(join([head, handle]), look.surface(color, "chrome")), (face, holes),
                     (collar, plain((120, 124, 130)))], head, handle, factor=k,
                    foot=0.15)  # fmt: skip


@category("sink_plug", size=(0.13, 0.0503, 0.027), mass=0.04, material="rubber", assembled=True,
          aliases=("bath plug", "basin plug", "bathtub plug", "plug and chain"), themes=("vanity",),
          colors=("black",))  # fmt: skip
def sink_plug(look: Look) -> Shape:
    """A rubber plug with a ball chain."""
    color = look.color("black", "white", "charcoal", "blue")
    k = look.between(0.85, 1.2)
    body = standing((0.018, 0), (0.02, 0.013), (0.024, 0.014), (0.0245, 0.018), sides=26)
    eye = torus(0.0055, 0.0012, 16, 6).turn(0, np.pi / 2).move(0, 0, 0.021)
    beads = []
    for n in range(16):
        t = n / 15
        p = (0.004 + 0.085 * t, 0.02 * np.sin(5 * t), 0.002 + 0.022 * np.clip(1 - 3.2 * t, 0, 1))
        beads.append(ball(0.0045, 0.0045, 0.0042, p, 8))
    ring = torus(0.008, 0.0012, 18, 6).move(0.1, -0.018, 0.0014)
    return put_down([(body, surfaces.speckles(look.rng, color, 4)), (join([eye, *beads, ring]),
                                                                     steel(look))], body,
                    join([*beads[6:], ring]), factor=k)  # fmt: skip


@category("standing_mirror", size=(0.175, 0.145, 0.26), mass=0.6, material="glass", assembled=True,
          aliases=("makeup mirror", "table mirror", "vanity mirror", "stand mirror",
          "cosmetic mirror", "tabletop mirror", "desk mirror", "make up mirror", "shaving mirror"),
          themes=("vanity",), roles=("tall", "big"), colors=("white", "gold"))  # fmt: skip
def standing_mirror(look: Look) -> Shape:
    """A round, oval or square make-up mirror on a base, tilted slightly back."""
    w = look.between(0.075, 0.1)
    color = look.color("white", "gold", "silver", "black", "pink", "wooden", "copper")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    kind = look.pick(["round", "round", "oval", "square"])
    tall = {"round": w, "oval": 1.3 * w, "square": 1.2 * w}[kind]
    outline = (
        rectangle(2 * w, 2 * tall, 0.02, 5) if kind == "square" else ellipse(2 * w, 2 * tall, 40)
    )
    frame = prism(outline, 0, 0.012, 0.003)
    inner = prism(outline * 0.9, 0, 0.0006)
    lean = look.between(0.1, 0.25)
    middle = tall + look.between(0.05, 0.09)
    back = facing(frame).turn(0, -lean).move(z=middle)
    way = np.array([0, -np.cos(lean), np.sin(lean)])
    glass = facing(inner).turn(0, -lean).move(z=middle).move(*(0.0118 * way))
    image = surfaces.gradient((150, 172, 186), (232, 240, 244), look.rng, 3).astype(float)
    image = surfaces.fit(image.astype(np.uint8), 96, 96).copy()
    prints.polygon(image, [(0.2, 1), (0.55, 0), (0.68, 0), (0.33, 1)], (240, 246, 248))
    foot = cylinder(0.8 * w, 0.01, 34, bevel=0.003)
    post = cylinder(0.006, middle - tall + 0.03, 14).move(y=0.008, z=0.008)
    return shape([(join([back, foot, post]), skin), (glass, image)],
                 [cylinder_part(0.8 * w, 0.01), hull_of(post), hull_of(back)])  # fmt: skip
