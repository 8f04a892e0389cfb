"""Objects of the ``living`` theme: props."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc, smooth
from ...kit.parts import box_part, hull_above, hull_of, lift_parts, open_vessel
from ...kit.primitives import at_box, ball, limb, spread, standing_plate, straight
from ...kit.shapes import (
    Category,
    Pieces,
    Shape,
    at_rest,
    category,
    from_pieces,
    keep_still,
    put_down,
    settle,
    shape,
    vary,
)
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color
from .religious_items import tome


@category("devil_horns", size=(0.151, 0.181, 0.0298), mass=0.04, material="plastic", assembled=True,
          aliases=("horned headband", "devil horn headband", "devil headband"), themes=("living",),
          colors=("red",), state="lying flat")  # fmt: skip
@vary()
def devil_horns(look: Look) -> Shape:
    """A headband with two red horns, lying flat."""
    k = look.between(0.94, 1.06)
    color = look.color("red", "red", "black", "purple")
    band = limb([(-0.065, 0.05, 0.004), (-0.07, 0, 0.004), (-0.04, -0.055, 0.004),
                 (0.0, -0.07, 0.004), (0.04, -0.055, 0.004), (0.07, 0, 0.004),
                 (0.065, 0.05, 0.004)], [0.0042] * 7, 8)  # fmt: skip
    horns = [limb([(s * 0.03, -0.06, 0.012), (s * 0.045, -0.085, 0.016), (s * 0.04, -0.115, 0.014),
                   (s * 0.03, -0.13, 0.012)], [0.0155, 0.012, 0.006, 0.001], 12)
             for s in (-1, 1)]  # fmt: skip
    return settle([(band, surfaces.plain((30, 28, 30))),
                   (join(horns), surfaces.stripes([color, tint_color(color, 0.82)], 6))], 0.06,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("eye_patch", size=(0.162, 0.154, 0.00524), mass=0.008, material="fabric", assembled=True,
          aliases=("pirate eye patch", "eyepatch", "eye patch for pirate"), themes=("living",),
          roles=("flat",), colors=("black",), state="lying flat")  # fmt: skip
@vary()
def eye_patch(look: Look) -> Shape:
    """A black eye patch with an elastic band, plain or with a skull, lying flat."""
    k = look.between(0.94, 1.08)
    color = look.color("black", "black", "brown")
    half = smooth([(0.0, -0.036), (0.024, -0.022), (0.034, 0.008), (0.03, 0.026), (0.0, 0.028)], 4)
    outline = np.concatenate([half, (half * [-1, 1])[-2:0:-1]])
    patch = prism(outline, 0, 0.004, 0.0015)
    cord = limb([(-0.03, 0.022, 0.002), (-0.08, 0.05, 0.002), (-0.05, 0.11, 0.002), (0.05, 0.11,
                0.002), (0.08, 0.05, 0.002), (0.03, 0.022, 0.002)], [0.0018] * 6, 6)  # fmt: skip
    bone = [ellipsoid(0.022, 0.019, 0.002, 12, 4).move(0, 0.004, 0.004),
            block(0.012, 0.01, 0.001, 0.002).move(0, -0.009, 0.0037)]  # fmt: skip
    eyes = [cylinder(0.0028, 0.0006, 10).move(s * 0.0046, 0.004, 0.0047) for s in (-1, 1)]
    cloth = surfaces.fabric(look.rng, tint_color(color, 0.8))
    return put_down([(patch, cloth), (cord, surfaces.plain((24, 24, 26))),
                     (join(bone), surfaces.plain((244, 242, 234))),
                     (join(eyes), surfaces.plain((24, 24, 26)))], patch, cord,
                    factor=k)  # fmt: skip


@category("hook_hand", size=(0.175, 0.133, 0.0805), mass=0.09, material="metal", assembled=True,
          aliases=("pirate hook", "hand hook", "captain hook's hook"), themes=("living",),
          colors=("black",), state="lying flat")  # fmt: skip
@at_rest
def hook_hand(look: Look) -> Shape:
    """A pirate's hook lying flat: a cuff with a bent steel hook."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "brown", "red")
    cuff = lathe([(0, 0), (0.04, 0), (0.034, 0.07), (0, 0.07)], 26).turn(1, np.pi / 2)
    rim = torus(0.039, 0.004, 26, 6).turn(1, np.pi / 2)
    stem = limb([(0.065, 0, 0), (0.11, 0, 0), (0.15, 0.02, 0), (0.165, 0.055, 0), (0.14, 0.085, 0),
                 (0.105, 0.075, 0)], [0.007, 0.007, 0.0068, 0.006, 0.0045, 0.001], 10)  # fmt: skip
    return settle([(cuff, look.surface(color, "plastic")), (rim, surfaces.plain((214, 176, 90))),
                   (stem, surfaces.brushed_metal(look.rng, (200, 203, 208)))], 0.06,
                  hulls=[[0, 1], [2]]).scale(k)  # fmt: skip


@category("photo_prop", size=(0.114, 0.203, 0.00651), mass=0.006, material="paper", assembled=True,
          aliases=("photo booth prop", "moustache on a stick", "party prop", "fake moustache",
          "selfie prop", "fake moustaches"), themes=("living",), colors=("black",),
          state="lying flat")  # fmt: skip
def photo_prop(look: Look) -> Shape:
    """A cardboard photo prop on a stick: a moustache, lips, glasses or a top hat."""
    k = look.between(0.9, 1.1)
    kind = look.pick(["moustache", "lips", "hat", "moustache"])
    color = look.color("black", "red", "black", "purple")
    if kind == "moustache":
        half = smooth([(0, 0.004), (0.02, 0.014), (0.045, 0.006), (0.06, 0.018), (0.056, -0.006),
                       (0.03, -0.016), (0, -0.006)], 4)  # fmt: skip
    elif kind == "lips":
        half = smooth([(0, 0.012), (0.012, 0.018), (0.034, 0.006), (0.045, 0), (0.03, -0.012),
                       (0, -0.02)], 4)  # fmt: skip
    else:
        half = np.array([(0, 0.07), (0.03, 0.07), (0.027, 0.008), (0.05, 0.006), (0.05, -0.006),
                         (0, -0.006)], float)  # fmt: skip
    outline = np.concatenate([half[::-1], (half * [-1, 1])[1:-1]])
    card = prism(outline, 0.0042, 0.0066)
    stick = tube([(0, -0.004, 0.0024), (0, -0.17, 0.0024)], 0.0024, 8)
    pieces: Pieces = [(card, surfaces.speckles(look.rng, color, 4)),
                      (stick, surfaces.wood(look.rng, (222, 188, 136)))]  # fmt: skip
    if kind == "hat":
        pieces.append((box(0.056, 0.012, 0.0005).move(0, 0.018, 0.0064), surfaces.plain(
            (206, 40, 50))))  # fmt: skip
    return settle(pieces, 0.02, hulls=[[0], [1]]).scale(k)


@category("clapperboard", size=(0.223, 0.237, 0.0102), mass=0.25, material="wood",
          aliases=("clapper board", "film slate", "movie clapper", "clapboard", "film clapper"),
          themes=("living",), roles=("flat", "big"), colors=("black",))  # fmt: skip
def clapperboard(look: Look) -> Shape:
    """A film clapperboard lying flat, with its striped clapper slightly open."""
    k = look.between(0.75, 0.95)
    color = look.color("black", "charcoal", "white")
    board = block(0.26, 0.18, 0.008, 0.003)
    ink = (240, 240, 236) if sum(color) < 400 else (40, 40, 44)
    face = prints.canvas(208, 144, color)
    for n, word in enumerate(("SCENE", "TAKE", "ROLL")):
        prints.write(face, word, 0.18 + 0.32 * n, 0.28, 0.09, ink)
        prints.write(
            face, str(int(look.rng.integers(1, 30))), 0.18 + 0.32 * n, 0.44, 0.17, ink, bold=True
        )
    prints.fill(face, 0.03, 0.6, 0.94, 0.015, ink)
    prints.write(face, look.pick(["DIRECTOR", "PRODUCTION", "CAMERA"]), 0.5, 0.76, 0.1, ink)
    sheet = at_box(0.255, 0.175, 0.0008, (0, 0, 0.0077))
    stripes = surfaces.stripes([(244, 244, 240), (26, 26, 28)], 6, upright=True)
    low = at_box(0.26, 0.03, 0.012, (0, 0.105, 0))
    high = at_box(0.26, 0.03, 0.012, (0.13, 0, 0)).turn(2, 0.18).move(-0.13, 0.128, 0)
    return put_down([(board, plain(color)), (sheet, face), (join([low, high]), stripes)], board,
                    low, high, factor=k)  # fmt: skip


@category("skull", size=(0.083, 0.11, 0.11), mass=0.35, material="plastic", aliases=("human skull",
          "skull decoration", "halloween skull", "decorative skull", "plastic skull",
          "skull model"), themes=("living",), colors=("ivory",))  # fmt: skip
def skull(look: Look) -> Shape:
    """A skull with dark eye sockets and teeth, facing the viewer."""
    color = look.color("ivory", "white", "cream", "black", "silver", "gold")
    bone = surfaces.speckles(look.rng, color, 8)
    hollow = surfaces.plain((28, 24, 24) if sum(color) > 250 else (190, 40, 40))
    brain = ball(0.086, 0.104, 0.084, (0, 0.008, 0.072), 22)
    face = ball(0.066, 0.05, 0.06, (0, -0.03, 0.05), 16)
    cheeks = [ball(0.026, 0.03, 0.02, (s * 0.027, -0.034, 0.045), 10) for s in (-1, 1)]
    jaw = lathe([(0, 0), (0.022, 0), (0.027, 0.012), (0.024, 0.028), (0, 0.03)], 18)
    jaw = jaw.move(0, -0.026, 0)
    back = cylinder(0.026, 0.04, 16).move(0, 0.012, 0)
    eyes = [ball(0.024, 0.014, 0.022, (s * 0.0165, -0.0475, 0.066), 12) for s in (-1, 1)]
    nose = standing_plate([(-0.0065, 0), (0.0065, 0), (0, 0.014)], 0.006).move(0, -0.0545, 0.041)
    teeth = [box(0.005, 0.004, 0.0085).move(0.0058 * n, -0.052 + 0.0009 * n * n, z)
             for n in (-3, -2, -1, 0, 1, 2, 3) for z in (0.0225, 0.013)]  # fmt: skip
    gap = box(0.04, 0.004, 0.022).move(0, -0.0485, 0.012)
    pieces: Pieces = [(join([brain, face, *cheeks, jaw, back]), bone),
                      (join([*eyes, nose, gap]), hollow),
                      (join(teeth), surfaces.plain(tint_color(color, 1.2)))]  # fmt: skip
    return put_down(pieces, brain, join([face, jaw]), back, factor=look.between(0.8, 1.1))


@category("rabbit_foot", size=(0.12, 0.0254, 0.017), mass=0.015, material="fabric", assembled=True,
          aliases=("rabbit's foot", "lucky rabbit foot", "rabbits foot keychain"),
          themes=("living",), colors=("white",), state="lying")  # fmt: skip
def rabbit_foot(look: Look) -> Shape:
    """A rabbit's foot on a key chain: a furry paw with a metal cap and a ring."""
    k, color = look.between(0.9, 1.15), look.color("white", "tan", "gray", "brown", "pink")
    paw = limb([(-0.034, 0, 0), (-0.026, 0, 0), (0, 0.003, 0), (0.022, 0, 0), (0.03, 0, 0)],
               [0.002, 0.0085, 0.0098, 0.0075, 0.006], 14)  # fmt: skip
    cap = lathe([(0, 0), (0.0076, 0), (0.0076, 0.007), (0.003, 0.012), (0, 0.012)], 16)
    cap = cap.turn(1, np.pi / 2).move(x=0.027)
    links = [torus(0.0035, 0.0008, 12, 5).move(x=0.041 + 0.0055 * n, z=-0.004) for n in range(4)]
    ring = torus(0.0115, 0.001, 22, 6).move(x=0.073, z=-0.006)
    fur = surfaces.scratches(look.rng, color, tint_color(color, 0.82), 200)
    gold = surfaces.brushed_metal(look.rng, (206, 172, 90))
    return settle([(paw, fur), (join([cap, *links, ring]), gold)], 0.12, hulls=[[0], [1]]).scale(k)


@category("shackle", size=(0.285, 0.0874, 0.0151), mass=0.6, material="metal", assembled=True,
          aliases=("iron shackle", "pair of shackles", "handcuffs", "pair of handcuffs", "manacle"),
          themes=("living",), roles=("flat",), colors=("gray",))  # fmt: skip
def shackle(look: Look) -> Shape:
    """A pair of iron shackles joined by a short chain, lying flat."""
    k = look.between(0.85, 1.15)
    color = look.color("charcoal", "gray", "brown", "black")
    cuffs = [torus(0.034, 0.0065, 30, 8).move(s * 0.085, 0, 0.0062) for s in (-1, 1)]
    locks = [at_box(0.02, 0.026, 0.014, (s * 0.122, 0, 0)) for s in (-1, 1)]
    links = []
    for n in range(5):
        one = torus(0.009, 0.0028, 14, 6).scale(1.25, 0.85, 1)
        one = one.turn(0, 0.5 * (-1) ** n).move(-0.035 + 0.0175 * n, 0, 0.0065)
        links.append(one)
    iron = surfaces.spots(look.rng, color, (112, 76, 54), 0.1)
    return put_down([(join([*cuffs, *locks, *links]), iron)], *cuffs, join(links), factor=k,
                    foot=0.3)  # fmt: skip


@category("bunny_ears", size=(0.132, 0.228, 0.015), mass=0.05, material="plastic", assembled=True,
          aliases=("bunny ear headband", "rabbit ears", "bunny ears headband",
          "rabbit ear headband", "cat ears headband", "bunny ear"), themes=("living",),
          colors=("white",), state="lying")  # fmt: skip
@keep_still
def bunny_ears(look: Look) -> Shape:
    """A headband with two bunny ears, lying on its back."""
    k, color = look.between(0.88, 1.08), look.color("white", "pink", "gray", "brown", "black")
    a = np.linspace(-0.25, np.pi + 0.25, 19)
    band = tube(
        np.column_stack([0.065 * np.cos(a), 0.07 * np.sin(a) - 0.05, np.full(19, 0.004)]), 0.004, 8
    )
    ears, inner = [], []
    for s in (-1, 1):
        path = [(0.026 * s, 0.015, 0.005), (0.04 * s, 0.07, 0.009), (0.046 * s, 0.13, 0.008),
                (0.048 * s, 0.17, 0.005)]  # fmt: skip
        ears.append(limb(path, [0.012, 0.023, 0.02, 0.002], 12, 0.32))
        inner.append(
            limb([(x, y, z + 0.0035) for x, y, z in path], [0.007, 0.014, 0.011, 0.001], 10, 0.3)
        )
    return settle([(join([band, *ears]), surfaces.scratches(look.rng, color, tint_color(color, 0.9),
                                                            120)),
                   (join(inner), surfaces.plain((240, 168, 186)))], 0.06,
                  hulls=[[0]]).scale(k)  # fmt: skip


@category("tombstone", size=(0.116, 0.0454, 0.136), mass=0.3, material="stone",
          aliases=("gravestone", "gravestone prop", "headstone", "fake gravestone", "grave stone"),
          themes=("living",), roles=("tall",), colors=("gray",))  # fmt: skip
def tombstone(look: Look) -> Shape:
    """A round-topped gravestone on a base, engraved with RIP."""
    k = look.between(0.85, 1.15)
    color = look.color("gray", "gray", "silver", "charcoal")
    x, h, t = 0.09 * k, 0.12 * k, 0.02 * k
    outline = np.concatenate([[(-x / 2, 0), (x / 2, 0)], arc((0, h - x / 2), x / 2, 0, np.pi, 14)])
    slab = standing_plate(outline, t, bevel=0.002).move(z=0.012)
    foot = block(1.25 * x, 2.2 * t, 0.014, 0.003, 0.002)
    image = prints.canvas(120, 140, color)
    image[:] = surfaces.fit(surfaces.marble(look.rng, color, tint_color(color, 0.7)), 140, 120)
    dark = tint_color(color, 0.35)
    prints.write(image, "R.I.P.", 0.5, 0.4, 0.24, dark, bold=True)
    prints.stroke(image, [(0.5, 0.06), (0.5, 0.24)], 0.03, dark)
    prints.stroke(image, [(0.42, 0.12), (0.58, 0.12)], 0.03, dark)
    prints.lines(image, look.rng, (0.25, 0.62, 0.5, 0.22), 3, dark)
    face = box(0.84 * x, 0.0008, 0.74 * h).move(y=-t / 2, z=0.02)
    moss = [ball(0.02 * k, 0.014 * k, 0.008, (s * 0.5 * x, -0.6 * t, 0.014), 8) for s in (-1, 1)]
    stone = surfaces.marble(look.rng, color, tint_color(color, 0.7))
    return shape([(join([slab, foot]), stone), (face, image),
                  (join(moss), surfaces.spots(look.rng, (92, 120, 60), (70, 96, 46), 0.3))],
                 [hull_of(slab), hull_of(foot)])  # fmt: skip


@category("coffin", size=(0.201, 0.0905, 0.0469), mass=0.2, material="wood",
          aliases=("toy coffin", "coffin prop", "mini coffin", "coffin box"), themes=("living",),
          roles=("support",), colors=("brown",))  # fmt: skip
def coffin(look: Look) -> Shape:
    """A small six-sided coffin lying flat, with a cross on its lid."""
    k = look.between(0.85, 1.15)
    color = look.color("brown", "black", "wooden", "purple")
    outline = (np.array([(-0.1, -0.022), (0.045, -0.045), (0.1, -0.026), (0.1, 0.026),
                         (0.045, 0.045), (-0.1, 0.022)]) * k)  # fmt: skip
    body = prism(outline * 0.97, 0, 0.036 * k)
    lid = prism(outline * 1.03, 0.034 * k, 0.046 * k, 0.003)
    cross = [box(0.09 * k, 0.011 * k, 0.003).move(x=0.0, z=0.045 * k),
             box(0.011 * k, 0.045 * k, 0.003).move(x=0.025 * k, z=0.045 * k)]  # fmt: skip
    wood = look.surface(color, "wood")
    return shape([(body, wood), (lid, wood), (join(cross), surfaces.plain((206, 172, 90)))],
                 [hull_of(body), hull_of(lid)])  # fmt: skip


@category("spirit_board", size=(0.358, 0.249, 0.0175), mass=0.5, material="wood",
          aliases=("ouija board", "ouija", "talking board", "witch board"), themes=("living",),
          roles=("big", "support"), colors=("tan",), state="lying flat")  # fmt: skip
def spirit_board(look: Look) -> Shape:
    """A spirit board with letters, digits, the words YES and NO, and a heart-shaped pointer."""
    k = look.between(0.94, 1.06)
    color = look.color("tan", "beige", "wooden", "brown")
    x, y = 0.36 * k, 0.25 * k
    image = surfaces.fit(surfaces.wood(look.rng, color), 200, 280).copy()
    ink = readable_on(color)
    prints.fill(image, 0.03, 0.04, 0.94, 0.012, ink)
    prints.fill(image, 0.03, 0.95, 0.94, 0.012, ink)
    prints.write(image[:, :80], "YES", 0.5, 0.15, 0.1, ink, bold=True)
    prints.write(image[:, 200:], "NO", 0.5, 0.15, 0.1, ink, bold=True)
    prints.disc(image, 0.08, 0.15, 0.04, ink)
    prints.disc(image, 0.92, 0.15, 0.05, ink, 0.035)
    for n, c in enumerate("ABCDEFGHIJKLMNOPQRSTUVWXYZ"):
        t = (n % 13) / 12
        u, v = 0.1 + 0.8 * t, 0.36 + 0.18 * (n // 13) - 0.1 * np.sin(np.pi * t)
        left = int(280 * u) - 12
        prints.write(image[:, left : left + 24], c, 0.5, v + 0.08, 0.1, ink, bold=True)
    prints.write(image, "1 2 3 4 5 6 7 8 9 0", 0.5, 0.73, 0.09, ink, bold=True)
    prints.write(image, "GOOD BYE", 0.5, 0.87, 0.09, ink, bold=True)
    board = block(x, y, 0.008, 0.008, 0.0015)
    face = box(0.98 * x, 0.97 * y, 0.0006).move(z=0.0077)
    pointer = pointer_solid(k).move(0.06 * k, -0.03 * k, 0.0125)
    legs = [cylinder(0.003, 0.0045, 8).move(0.06 * k + u, -0.03 * k + v, 0.0082)
            for u, v in ((0.02, -0.02), (-0.02, -0.02), (0, 0.028))]  # fmt: skip
    pale = look.own_color("ivory", "wooden", "black")
    return shape([(board, surfaces.wood(look.rng, tint_color(color, 0.8))), (face, image),
                  (join([pointer, *legs]), surfaces.wood(look.rng, pale))],
                 [box_part(x, y, 0.0082), hull_of(pointer, *legs)])  # fmt: skip


def pointer_solid(k: float) -> Solid:
    """Return a heart-shaped pointer for a spirit board, 5 mm thick and scaled by ``k``."""
    half = smooth(
        [(0.0, 0.055), (0.026, 0.016), (0.036, -0.014), (0.024, -0.034), (0.0, -0.026)], 4
    )
    outline = np.concatenate([half[::-1], (half * [-1, 1])[1:-1]]) * k
    return prism(outline, 0, 0.005, 0.001)


@category("planchette", size=(0.0825, 0.102, 0.0116), mass=0.03, material="wood",
          aliases=("ouija planchette", "ouija pointer"), themes=("living",),
          colors=("wooden",))  # fmt: skip
def planchette(look: Look) -> Shape:
    """A planchette: a heart-shaped pointer on three small feet, with a window."""
    k = look.between(0.95, 1.2)
    color = look.color("wooden", "ivory", "brown", "black")
    plate = pointer_solid(k).move(z=0.006)
    feet = [cylinder(0.004, 0.007, 10).move(u * k, v * k) for u,
            v in ((0.02, -0.02), (-0.02, -0.02), (0, 0.034))]  # fmt: skip
    window = cylinder(0.011 * k, 0.0056, 20).move(z=0.006)
    return shape([(join([plate, *feet]), look.surface(color, "wood")),
                  (window, surfaces.plain((210, 226, 230)))],
                 [hull_of(plate), hull_of(*feet)])  # fmt: skip


STRAW: RGB = (206, 164, 96)


@category("witch_broom", size=(0.397, 0.0573, 0.0381), mass=0.08, material="wood", assembled=True,
          aliases=("witch's broom", "witches broom", "broomstick", "toy broom", "besom",
          "mini broom", "hand broom", "broom"), themes=("living",), colors=("brown",),
          state="lying flat")  # fmt: skip
@at_rest
def witch_broom(look: Look) -> Shape:
    """A small witch's broom lying flat: a crooked stick with a bound bundle of twigs."""
    k = look.between(0.9, 1.1)
    color = look.color("brown", "brown", "black", "wooden")
    stick = limb([(-0.2, 0.004, 0.02), (-0.08, -0.005, 0.022), (0.06, 0.004, 0.022)],
                 [0.006, 0.0065, 0.006], 8)  # fmt: skip
    twigs = []
    for n in range(38):
        away, a = np.sqrt((n + 0.5) / 38), 2.4 * n
        y, z = away * np.cos(a), away * np.sin(a)
        twigs.append(tube([(0.04, 0.008 * y, 0.022 + 0.008 * z), (0.1, 0.02 * y, 0.022 + 0.016 * z),
                           (0.165 + 0.012 * ((n * 7) % 3), 0.03 * y, 0.022 + 0.02 * z)],
                          [0.0022, 0.0024, 0.001], 5))  # fmt: skip
    rings = [torus(0.0115, 0.003, 18, 6).turn(1, np.pi / 2).move(x, 0, 0.022)
             for x in (0.055, 0.064)]  # fmt: skip
    return settle([(stick, look.surface(color, "wood")),
                   (join(twigs), surfaces.scratches(look.rng, STRAW, (150, 108, 56), 80)),
                   (join(rings), surfaces.plain((86, 60, 40)))], 0.06,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("cauldron", size=(0.19, 0.134, 0.123), mass=0.35, material="metal", hollow=True,
          aliases=("witch's cauldron", "plastic cauldron", "mini cauldron", "toy cauldron",
          "black cauldron"), themes=("living",), roles=("container", "round"),
          colors=("black",))  # fmt: skip
def cauldron(look: Look) -> Shape:
    """A round, open black cauldron on three feet with a ring on each side."""
    r, h = look.between(0.06, 0.08), look.between(0.1, 0.12)
    color = look.color("black", "black", "charcoal", "green")
    foot = 0.016
    side = [(0.3 * r, foot), (0.86 * r, foot + 0.12 * h), (1.04 * r, foot + 0.42 * h),
            (0.86 * r, foot + 0.84 * h), (0.96 * r, foot + h)]  # fmt: skip
    body, parts = open_vessel([(x, z - foot) for x, z in side], 0.006, 0.01, 30)
    body = body.move(z=foot)
    feet = [
        cylinder(0.009, foot + 0.02, 12, top=0.013).move(0.6 * r * np.cos(a), 0.6 * r * np.sin(a))
        for a in (0.5, 2.6, 4.7)
    ]
    rim = torus(0.95 * r, 0.005, 34, 8).move(z=foot + h - 0.004)
    ears = [torus(0.015, 0.0035, 16, 6).turn(0, np.pi / 2).move(s * (r + 0.012), 0, foot + 0.78 * h)
            for s in (-1, 1)]  # fmt: skip
    iron = surfaces.speckles(look.rng, tint_color(color, 0.9), 8)
    return shape([(body, iron), (join([*feet, rim, *ears]), iron)],
                 [*lift_parts(parts, foot), *(hull_of(f) for f in feet)])  # fmt: skip


@category("vampire_fangs", size=(0.067, 0.0507, 0.0323), mass=0.012, material="plastic",
          aliases=("vampire teeth", "fangs", "plastic fangs", "fake teeth", "plastic teeth"),
          themes=("living",), colors=("white",))  # fmt: skip
def vampire_fangs(look: Look) -> Shape:
    """A set of plastic vampire teeth: two arches of gums and teeth with two long fangs."""
    k = look.between(0.95, 1.2)
    color = look.color("white", "white", "lime", "ivory")
    gums, teeth = [], []
    for level, way in ((0.005, 1), (0.026, -1)):
        curve = [(0.026 * np.cos(a), -0.03 * np.sin(a) + 0.01, level)
                 for a in np.linspace(-0.15, np.pi + 0.15, 9)]  # fmt: skip
        gums.append(limb(curve, [0.0052] * 9, 8))
        for n, a in enumerate(np.linspace(0.25, np.pi - 0.25, 8)):
            fang = way < 0 and n in (2, 5)
            long = 0.019 if fang else 0.0075
            at = (0.026 * np.cos(a), -0.03 * np.sin(a) + 0.007, level)
            tip = (at[0], at[1] - 0.001, level + way * long)
            teeth.append(tube([at, tip], [0.0042, 0.0008 if fang else 0.0034], 8))
    hinge = [
        tube([(s * 0.026, 0.013, 0.005), (s * 0.026, 0.016, 0.026)], 0.004, 8) for s in (-1, 1)
    ]
    return settle([(join([*gums, *hinge]), surfaces.speckles(look.rng, (206, 70, 84), 8)),
                   (join(teeth), surfaces.speckles(look.rng, color, 4))],
                  0.05).scale(k)  # fmt: skip


@category("clown_nose", size=(0.0516, 0.0529, 0.0465), mass=0.004, material="rubber",
          aliases=("red nose", "foam nose", "clown's nose"), themes=("living",), roles=("round",),
          colors=("red",))  # fmt: skip
def clown_nose(look: Look) -> Shape:
    """A red foam clown nose with a slit."""
    r = look.between(0.023, 0.027)
    color = look.color("red", "red", "red")
    body = ball(2 * r, 2 * r, 2 * r, (0, 0, 0), 24)
    hole = ball(0.9 * r, 0.5 * r, 0.9 * r, (0, 0.8 * r, 0.2 * r), 12)
    return settle([(body, surfaces.speckles(look.rng, color, 6)),
                   (hole, surfaces.plain(tint_color(color, 0.4)))], 0.1, hulls=[[0]])  # fmt: skip


@category("cobweb", size=(0.251, 0.251, 0.013), mass=0.01, material="paper", assembled=True,
          aliases=("spider web", "spider's web", "fake cobweb", "spiderweb"), themes=("living",),
          roles=("flat",), colors=("white",), state="lying flat")  # fmt: skip
def cobweb(look: Look) -> Shape:
    """A cobweb lying flat: spokes and sagging rings with a small spider."""
    k = look.between(0.85, 1.2)
    color = look.color("white", "white", "silver", "black")
    spokes, rings = [], []
    angles = 2 * np.pi * np.arange(8) / 8
    spokes += [tube([(0, 0, 0.0018), (0.115 * np.cos(a), 0.115 * np.sin(a), 0.0014)], 0.0014, 5)
               for a in angles]  # fmt: skip
    for r in (0.025, 0.048, 0.072, 0.098):
        points = []
        for a in angles:
            b = a + np.pi / 8
            points += [(r * np.cos(a), r * np.sin(a), 0.0014),
                       (0.82 * r * np.cos(b), 0.82 * r * np.sin(b), 0.0014)]  # fmt: skip
        rings.append(tube(np.array(points), 0.0012, 5, loop=True))
    bug = join([ball(0.014, 0.012, 0.01, (0.03, 0.012, 0.007), 10),
                ball(0.008, 0.008, 0.007, (0.022, 0.012, 0.006), 8)])  # fmt: skip
    net = join([*spokes, *rings])
    return put_down([(net, surfaces.plain(color)), (bug, surfaces.plain((30, 28, 32)))], net,
                    factor=k)  # fmt: skip


WHITE = surfaces.plain((248, 246, 238))
BLACK = surfaces.plain((24, 22, 26))


@category("skeleton", size=(0.136, 0.271, 0.0328), mass=0.05, material="plastic", assembled=True,
          aliases=("toy skeleton", "plastic skeleton", "glow-in-the-dark skeleton",
          "skeleton figure", "mini skeleton", "halloween skeleton"), themes=("living",),
          colors=("ivory",), state="lying flat")  # fmt: skip
def skeleton(look: Look) -> Shape:
    """A toy skeleton, lying on its back."""
    k = look.between(0.9, 1.15)
    color = look.color("ivory", "white", "lime", "cream")
    bone = surfaces.speckles(look.rng, color, 6)
    skull = join([ellipsoid(0.032, 0.036, 0.03, 14, 8).move(0, 0.106, 0.015),
                  ellipsoid(0.022, 0.02, 0.018, 10, 6).move(0, 0.09, 0.011)])  # fmt: skip
    eyes = [ball(0.008, 0.008, 0.006, (s * 0.007, 0.104, 0.0275), 8) for s in (-1, 1)]
    mouth = ellipsoid(0.012, 0.003, 0.004, 8, 4).move(0, 0.087, 0.019)
    spine = straight((0, 0.085, 0.007), (0, -0.005, 0.007), 0.0034)
    ribs = [torus(0.02 - 0.0022 * abs(n - 1), 0.0018, 18, 6).turn(0, np.pi / 2).scale(1, 1, 0.45)
            .move(0, 0.066 - 0.011 * n, 0.0095) for n in range(5)]  # fmt: skip
    hips = ellipsoid(0.038, 0.018, 0.012, 12, 6).move(0, -0.006, 0.007)
    arms, legs = [], []
    for s in (-1, 1):
        arms.append(limb([(0, 0.074, 0.008), (s * 0.03, 0.07, 0.007), (s * 0.05, 0.03, 0.006),
                          (s * 0.055, -0.01, 0.005)], [0.003, 0.0038, 0.0034, 0.0028],
                         6))  # fmt: skip
        legs.append(limb([(s * 0.012, -0.008, 0.007), (s * 0.018, -0.055, 0.006),
                          (s * 0.02, -0.11, 0.005)], [0.0045, 0.004, 0.0034], 6))  # fmt: skip
        arms += [tube([(s * 0.055, -0.01, 0.005), (s * 0.057 + 0.005 * n, -0.026, 0.003)], 0.0015,
                      5) for n in (-1, 0, 1)]  # fmt: skip
        legs.append(ellipsoid(0.012, 0.026, 0.009, 8, 5).move(s * 0.023, -0.116, 0.0045))
        arms.append(ball(0.009, 0.009, 0.009, (s * 0.0495, 0.031, 0.006), 8))
        legs.append(ball(0.011, 0.011, 0.01, (s * 0.018, -0.055, 0.0065), 8))
    return shape([(join([skull, spine, *ribs, hips]), bone), (join([*arms, *legs]), bone),
                  (join([*eyes, mouth]), BLACK)],
                 [hull_above(skull), hull_above(spine, *ribs, hips), hull_above(*arms[: len(arms)
                  // 2]), hull_above(*arms[len(arms) // 2 :]), hull_above(*legs[:3]),
                  hull_above(*legs[3:])]).scale(k)  # fmt: skip


@category("ghost", size=(0.0999, 0.0823, 0.103), mass=0.08, material="ceramic", hollow=True,
          aliases=("ghost figure", "ghost figurine", "halloween ghost", "ghost decoration",
          "toy ghost"), themes=("living",), colors=("white",))  # fmt: skip
def ghost(look: Look) -> Shape:
    """A white ghost with a wavy hem, round eyes and an open mouth."""
    k = look.between(0.85, 1.15)
    color = look.color("white", "white", "ivory", "lime")
    side = smooth([(0.0, 0), (0.03, 0), (0.037, 0.002), (0.033, 0.02), (0.027, 0.05), (0.026, 0.07),
                   (0.021, 0.09), (0.01, 0.1), (0, 0.102)], 3)  # fmt: skip
    side = np.maximum(side, 0)
    body = lathe(side, 40)
    wavy = body.bend(lambda p: (p * np.column_stack([*[1 + 0.13 * np.clip(1 - p[:, 2] / 0.05, 0, 1)
                                                       * np.cos(7 * np.arctan2(p[:, 1], p[:, 0]))]
                                                     * 2, np.ones(len(p))])))  # fmt: skip
    arms = [limb([(s * 0.02, -0.004, 0.056), (s * 0.036, -0.012, 0.06), (s * 0.046, -0.02, 0.07)],
                 [0.01, 0.0085, 0.004], 8) for s in (-1, 1)]  # fmt: skip
    eyes = [ellipsoid(0.009, 0.006, 0.013, 10, 6).move(s * 0.0095, -0.0225, 0.076) for s in (-1, 1)]
    mouth = ellipsoid(0.011, 0.006, 0.013, 10, 6).move(0, -0.0255, 0.057)
    return shape([(join([wavy, *arms]), surfaces.speckles(look.rng, color, 4)),
                  (join([*eyes, mouth]), BLACK)],
                 [hull_of(wavy), hull_of(*arms)]).scale(k)  # fmt: skip


@category("mummy", size=(0.0896, 0.0825, 0.136), mass=0.12, material="ceramic",
          aliases=("mummy figure", "mummy figurine", "toy mummy", "zombie figure", "zombie",
          "zombies"), themes=("living",), colors=("cream",))  # fmt: skip
def mummy(look: Look) -> Shape:
    """A standing mummy wrapped in bandages, with visible eyes."""
    k = look.between(0.85, 1.15)
    color = look.color("cream", "ivory", "beige", "tan")
    body = lathe(np.maximum(smooth([(0, 0), (0.02, 0), (0.02, 0.01), (0.026, 0.045), (0.03, 0.075),
                 (0.018, 0.092), (0.0, 0.096)], 3), 0), 22).scale(1, 0.75, 1)  # fmt: skip
    head = ellipsoid(0.036, 0.036, 0.042, 18, 10).move(z=0.11)
    arms = [limb([(s * 0.027, -0.004, 0.08), (s * 0.03, -0.03, 0.076), (s * 0.024, -0.055, 0.078)],
                 [0.0095, 0.009, 0.008], 10) for s in (-1, 1)]  # fmt: skip
    feet = ellipsoid(0.046, 0.034, 0.016, 14, 6).move(0, -0.004, 0.008)
    bands = surfaces.stripes([color, color, color, tint_color(color, 0.68)], 9)
    gap = ellipsoid(0.03, 0.012, 0.008, 12, 6).move(0, -0.0135, 0.113)
    eyes = [ball(0.0065, 0.005, 0.006, (s * 0.0065, -0.018, 0.113), 8) for s in (-1, 1)]
    loose = tube(smooth([(0.022, 0.004, 0.05), (0.04, 0.0, 0.04), (0.046, -0.004, 0.02)], 3), 0.004,
                 6, squash=0.25)  # fmt: skip
    pieces: Pieces = [(body, bands), (head, bands), (join([*arms, feet, loose]), bands),
                      (gap, BLACK), (join(eyes), surfaces.plain((246, 230, 120)))]  # fmt: skip
    return shape(pieces, [hull_of(body, feet), hull_of(head), hull_of(*arms)]).scale(k)


@category("severed_hand", size=(0.113, 0.174, 0.0351), mass=0.15, material="plastic",
          aliases=("fake hand", "zombie hand", "mannequin hand", "rubber hand", "plastic hand",
          "hand prop"), themes=("living",), state="lying flat")  # fmt: skip
@vary()
def severed_hand(look: Look) -> Shape:
    """A severed hand lying palm down with spread fingers and a red stump."""
    k = look.between(0.85, 1.05)
    color = look.color("beige", "lime", "tan", "ivory")
    flesh = tint_color((222.0, 184.0, 150.0), 1.0) if "color" not in look.attributes else color
    if look.chance(0.3) and "color" not in look.attributes:
        flesh = (150.0, 170.0, 120.0)
    palm = ellipsoid(0.08, 0.085, 0.034, 18, 10).move(0, 0, 0.016)
    wrist = cylinder(0.026, 0.05, 18).turn(0, np.pi / 2).scale(1, 1, 0.75).move(0, -0.022, 0.018)
    fingers = [limb([(x, 0.03, 0.016), (1.3 * x, 0.03 + 0.55 * n, 0.022),
                     (1.45 * x, 0.03 + n, 0.006)], [0.01, 0.0095, 0.0065], 9) for x,
               n in ((-0.028, 0.052), (-0.01, 0.068), (0.01, 0.064), (0.028, 0.046))]  # fmt: skip
    thumb = limb([(0.03, -0.015, 0.015), (0.052, 0.008, 0.015), (0.062, 0.03, 0.007)],
                 [0.012, 0.0105, 0.007], 9)  # fmt: skip
    nails = [ellipsoid(0.009, 0.012, 0.004, 8, 4).move(1.44 * x, 0.026 + n, 0.011) for x,
             n in ((-0.028, 0.052), (-0.01, 0.068), (0.01, 0.064), (0.028, 0.046))]  # fmt: skip
    stump = cylinder(0.0235, 0.003, 18).turn(0, np.pi / 2).scale(1, 1, 0.75).move(0, -0.0705, 0.018)
    bone = cylinder(0.008, 0.006, 12).turn(0, np.pi / 2).move(0, -0.0705, 0.018)
    skin = surfaces.speckles(look.rng, flesh, 9)
    return settle([(join([palm, wrist]), skin), (join([*fingers, thumb]), skin),
                   (stump, surfaces.spots(look.rng, (160, 24, 28), (110, 10, 16), 0.3)),
                   (join([bone, *nails]), WHITE)], 0.08, hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("severed_finger", size=(0.0772, 0.0207, 0.0199), mass=0.012, material="plastic",
          aliases=("fake finger", "rubber finger", "zombie finger", "plastic finger"),
          themes=("living",), state="lying flat")  # fmt: skip
@vary()
def severed_finger(look: Look) -> Shape:
    """A severed finger lying flat, with a nail and a red end."""
    k = look.between(0.9, 1.15)
    color = look.color("beige", "tan", "lime")
    flesh: RGB = (222, 184, 150) if "color" not in look.attributes else color
    rod_ = limb([(-0.035, 0, 0.0095), (-0.005, 0, 0.012), (0.02, 0, 0.011), (0.036, 0, 0.009)],
                [0.0095, 0.0098, 0.009, 0.005], 12)  # fmt: skip
    nail = ellipsoid(0.015, 0.01, 0.004, 10, 5).move(0.028, 0, 0.0165)
    end = cylinder(0.0085, 0.002, 14).turn(1, np.pi / 2).move(-0.0365, 0, 0.0095)
    folds = [tube([(x, -0.006, 0.0185), (x, 0, 0.0212), (x, 0.006, 0.0185)], 0.0008, 5)
             for x in (-0.008, -0.005, 0.012)]  # fmt: skip
    return settle([(rod_, surfaces.speckles(look.rng, flesh, 9)),
                   (nail, surfaces.plain((240, 214, 200))), (end, surfaces.plain((150, 20, 26))),
                   (join(folds), surfaces.plain(tint_color(flesh, 0.75)))], 0.14,
                  hulls=[[0]]).scale(k)  # fmt: skip


@category("eyeball", size=(0.0316, 0.0311, 0.0275), mass=0.01, material="plastic",
          aliases=("fake eyeball", "glass eye", "plastic eyeball", "rubber eyeball",
          "candy eyeball"), themes=("living",), roles=("round",), colors=("blue",))  # fmt: skip
def eyeball(look: Look) -> Shape:
    """A staring eyeball with red veins, looking up and to the front."""
    r = look.between(0.013, 0.019)
    color = look.color("blue", "green", "brown", "teal")
    globe = ball(2 * r, 2 * r, 2 * r, (0, 0, 0), 22)
    lean = 0.75

    def cap(share: float, out: float) -> Solid:
        a = np.linspace(0, share, 6)
        ring = np.column_stack([out * r * np.sin(a), out * r * np.cos(a)])[::-1]
        inner = np.column_stack([0.97 * r * np.sin(a), 0.97 * r * np.cos(a)])
        profile = np.concatenate([[(0, inner[0, 1])], inner[1:], ring[:-1], [(0, ring[-1, 1])]])
        return lathe(profile, 20).turn(0, lean)

    veins = [tube(smooth([(0.72 * r * np.cos(t), 0.72 * r * np.sin(t), 0.7 * r), (0.9 * r * np.cos(
             t + 0.15), 0.9 * r * np.sin(t + 0.15), 0.44 * r), (1.0 * r * np.cos(t - 0.1), 1.0 * r *
             np.sin(t - 0.1), 0.08 * r)], 3), 0.035 * r, 4).turn(0, lean)
             for t in np.arange(8) * 0.785]  # fmt: skip
    return settle([(globe, WHITE), (cap(0.62, 1.03), surfaces.plain(color)),
                   (cap(0.28, 1.06), BLACK), (join(veins), surfaces.plain((200, 50, 50)))], 0.12,
                  hulls=[[0]])  # fmt: skip


BRASS = (206, 172, 96)


@category("folding_fan", size=(0.384, 0.193, 0.00833), mass=0.05, material="paper", assembled=True,
          aliases=("hand fan", "paper fan", "japanese fan", "folding hand fan", "spanish fan"),
          themes=("living",), roles=("flat", "big"), colors=("red",),
          state="lying open")  # fmt: skip
def folding_fan(look: Look) -> Shape:
    """An open, pleated folding fan lying flat, with sticks that meet at a rivet."""
    color = look.color("red", "black", "pink", "blue", "white", "green", "purple")
    n = 19
    k = look.between(0.85, 1.1)
    a = np.linspace(0.12, np.pi - 0.12, n)
    rows = []
    for r in (0.075, 0.13, 0.185):
        z = 0.004 + 0.004 * (np.arange(n) % 2)
        rows.append(np.column_stack([-r * np.cos(a), r * np.sin(a) - 0.09, z]))
    leaf = spread(np.stack(rows), 0.0012)
    sticks = [
        box(0.19 if i in (0, n - 1) else 0.09, 0.006, 0.0018)
        .move(0.095 if i in (0, n - 1) else 0.045)
        .turn(2, float(np.pi - a[i]))
        .move(0, -0.09, 0.0025 + 0.00009 * i)
        for i in range(0, n, 2)
    ]
    pin = cylinder(0.005, 0.006, 14).move(0, -0.09, 0.001)
    image = prints.canvas(160, 96, color)
    ink = tint_color(color, 1.7) if sum(color) < 560 else (200, 60, 70)
    for j in range(5):
        prints.disc(image, 0.15 + 0.175 * j, 0.5 + 0.16 * (-1) ** j, 0.1, ink)
        prints.disc(image, 0.15 + 0.175 * j, 0.5 + 0.16 * (-1) ** j, 0.04, color)
    return put_down([(leaf, image), (join(sticks), surfaces.wood(look.rng, (110, 74, 48))),
                     (pin, surfaces.plain(BRASS))], leaf, join([*sticks, pin]),
                    factor=k)  # fmt: skip


GILT: RGB = (206, 168, 84)


def _pentagram(image: prints.Canvas) -> None:
    a = np.pi / 2 + np.arange(5) * 4 * np.pi / 5
    points = [(0.5 + 0.3 * np.cos(t), 0.5 - 0.22 * np.sin(t)) for t in a]
    prints.disc(image, 0.5, 0.5, 0.25, GILT, 0.235)
    prints.stroke(image, [*points, points[0]], 0.014, GILT)


CATEGORIES = (
    Category("grimoire",
             from_pieces(bodies=2)(tome(_pentagram, "maroon", "purple", "black", "brown")),
             size=(0.136, 0.219, 0.0392), mass=0.7, material="paper", aliases=("spell book",
             "spellbook", "magic book", "book of spells", "old tome", "tome", "wizard book"),
             themes=("living",), roles=("flat", "support"), colors=("maroon",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
