"""Objects of the ``office`` theme: holders."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, glaze_tile, metal, plastic, shine, wood
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_of, hull_part, open_vessel
from ...kit.primitives import (
    at_block,
    at_box,
    disc,
    hull_solid,
    lay_down,
    plate,
    side_view,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    open_box,
    prism,
    sweep,
    tube,
)
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ...values import Holder
from ..dining.cards import menu_page
from ..kitchen.racks import _boards, centres, choose_slots, read_request


@category("card_holder", size=(0.106, 0.059, 0.063), mass=0.12, material="wood", assembled=True,
          aliases=("business card holder", "card stand", "business card stand",
          "playing card holder", "place card holder", "sim card holder"), themes=("office",),
          colors=("wooden",))  # fmt: skip
def card_holder(look: Look) -> Shape:
    """A stand of wood or acrylic that holds a tilted stack of cards."""
    k = look.between(0.94, 1.06)
    color = look.color("wooden", "black", "silver", "white", "brown")
    x, y = 0.105 * k, 0.05 * k
    foot = block(x, y, 0.01, 0.004, 0.001)
    back = box(x, 0.006, 0.045).turn(0, -0.3).move(y=0.35 * y, z=0.006)
    lip = box(x, 0.006, 0.016).move(y=-0.44 * y, z=0.006)
    cards = box(0.088 * k, 0.016, 0.052).turn(0, -0.3).move(y=0.02 * y, z=0.011)
    image = prints.canvas(150, 90, (250, 249, 244))
    prints.disc(image, 0.18, 0.38, 0.14, look.own_color("teal", "red", "gold"))
    prints.lines(image, look.rng, (0.4, 0.3, 0.5, 0.5), 4, (80, 84, 94))
    return shape([(join([foot, back, lip]), look.surface(color, "wood")), (cards, image)],
                 [hull_of(foot), hull_of(back), hull_of(lip), hull_of(cards)])  # fmt: skip


DARK: RGB = (32, 32, 35)


@category("headphone_stand", size=(0.125, 0.125, 0.25), mass=0.5, material="plastic",
          assembled=True, aliases=("headphone holder", "headset stand", "headphones stand",
          "headphones holder", "headset holder"), themes=("office",), roles=("tall",),
          colors=("black", "wooden"))  # fmt: skip
def headphone_stand(look: Look) -> Shape:
    """A headphone stand with a base, a post and a curved saddle on top."""
    k = look.between(0.88, 1.04)
    color = look.color("black", "wooden", "silver", "white", "charcoal", "wooden")
    tile = look.surface(color, look.pick(["wood", "metal", "plastic"]))
    foot = cylinder(0.065 * k, 0.012 * k, 34, bevel=0.003)
    post = block(0.028 * k, 0.014 * k, 0.24 * k, 0.004).move(z=0.011 * k)
    a = np.linspace(0.35, np.pi - 0.35, 12)
    curve = np.column_stack([0.055 * np.cos(a), 0.21 + 0.05 * np.sin(a)])
    under = (curve - [0, 0.21]) * 0.84 + [0, 0.21]
    saddle = side_view(np.concatenate([curve, under[::-1]]) * k, 0.05 * k)
    halves = [hull_of(side_view(np.concatenate([curve[m], under[m][::-1]]) * k, 0.05 * k))
              for m in (slice(0, 5), slice(4, 8), slice(7, 12))]  # fmt: skip
    return shape([(join([foot, post, saddle]), tile)],
                 [hull_of(foot), hull_of(post), *halves])  # fmt: skip


@category("laptop_stand", size=(0.252, 0.2135, 0.108), mass=1.6, material="metal", assembled=True,
          aliases=("laptop riser", "notebook stand", "laptop holder", "monitor riser",
          "computer stand", "monitor stand", "laptop platform"), themes=("office",),
          roles=("support", "big"), colors=("silver",))  # fmt: skip
def laptop_stand(look: Look) -> Shape:
    """A raised laptop stand: a level plate above a base, joined by two sides and open in front."""
    k = look.between(0.9, 1.04)
    color = look.color("silver", "silver", "black", "white", "wooden", "gray")
    tile = look.surface(color, "metal")
    x, y, h, t = 0.26 * k, 0.22 * k, 0.11 * k, 0.006
    plate = block(x, y, t, 0.012).move(z=h - t)
    foot = block(x, y, t, 0.012)
    sides = [
        box(t, 0.7 * y, h - 2 * t + 0.001).move(s * 0.32 * x, 0.0, t - 0.0005) for s in (-1, 1)
    ]
    pads = [block(0.12 * x, 0.012, 0.0018, 0.004).move(s * 0.3 * x, u * y, h - 0.0006)
            for s in (-1, 1) for u in (-0.35, 0.35)]  # fmt: skip
    return shape([(join([plate, foot, *sides]), tile), (join(pads), surfaces.plain(DARK))],
                 [box_part(x, y, t + 0.001, (0, 0, h - t)), hull_of(foot),
                  *(hull_of(s) for s in sides)])  # fmt: skip


PHONE_STAND_DARK: RGB = (38, 39, 43)


@category("phone_stand", size=(0.08, 0.1, 0.13), mass=0.18, material="device",
          aliases=("phone holder", "tablet stand", "smartphone stand", "cell phone stand",
          "display stand", "mobile phone stand", "tablet holder", "phone dock", "ipad stand"),
          themes=("office",), roles=("tall",), colors=("black", "silver"))  # fmt: skip
def phone_stand(look: Look) -> Shape:
    """A stand for a phone or tablet: a leaning plate with a lip, sometimes with a phone."""
    x, h = look.between(0.07, 0.09), look.between(0.09, 0.12)
    color = look.color("black", "silver", "wooden", "white", "gold", "gray", "teal")
    skin = look.surface(color, look.pick(["metal", "plastic", "wood"]))
    lean = look.between(0.35, 0.5)
    foot = block(x, 0.1, 0.006, 0.012, 0.002)
    plate = block(x, h, 0.006, 0.012, 0.002).turn(0, np.pi / 2 - lean)
    plate = plate.move(y=0.008, z=0.5 * h * np.cos(lean) + 0.012)
    lip = box(0.72 * x, 0.03, 0.005).turn(0, -lean).move(y=-0.025, z=0.016)
    stop = box(0.72 * x, 0.004, 0.014).turn(0, -lean).move(y=-0.038, z=0.012)
    neck = sweep(smooth([(0, 0.035, 0.004), (0, 0.03, 0.4 * h), (0, 0.018, 0.5 * h)], 3),
                 rectangle(0.5 * x, 0.008, 0.002, 2))  # fmt: skip
    pieces = [(join([foot, plate, lip, stop, neck]), skin)]
    parts = [hull_of(foot), hull_of(plate), hull_of(lip), hull_of(stop), hull_of(neck)]
    if look.chance(0.4):
        phone = block(0.072, 0.15, 0.008, 0.01, 0.002).turn(0, np.pi / 2 - lean)
        glass = block(0.068, 0.146, 0.0008, 0.008).turn(0, np.pi / 2 - lean)
        way = np.array([0, -np.cos(lean), np.sin(lean)])
        at = np.array([0, 0.008, 0.075 * np.cos(lean) + 0.022]) + 0.007 * way + [0, 0.012, 0]
        case = phone.move(*at)
        pieces += [(case, surfaces.plain(PHONE_STAND_DARK)), (glass.move(*(at + 0.0077 * way)),
                                                  prints.apps(look.rng))]  # fmt: skip
        parts.append(hull_of(case))
    return shape(pieces, parts)


WHITE = surfaces.plain((244, 243, 240))


@category("rolodex", size=(0.176, 0.155, 0.155), mass=0.7, material="plastic",
          aliases=("rotary card file", "card file", "card index", "address file"),
          themes=("office",), colors=("black",))  # fmt: skip
@from_pieces(bodies=(0, 1, 2, 3, 5))
def rolodex(look: Look) -> Pieces:
    """A rotary card file: a drum of cards between two stands with knobs."""
    tile = plastic(look, "black", "charcoal", "gray")
    stands = [at_block(0.012, 0.1, 0.08, 0.003, (s * 0.066, 0, 0)) for s in (-1, 1)]
    floor = at_box(0.13, 0.1, 0.008)
    leaves = [at_box(0.105, 0.0016, 0.05, (0, 0, 0.022)).turn(0, a).move(0, 0, 0.08)
              for a in np.linspace(-1.9, 1.9, 26)]  # fmt: skip
    tabs = [
        at_box(0.016, 0.002, 0.008, (-0.04 + 0.016 * (k % 6), 0, 0.071)).turn(0, a).move(0, 0, 0.08)
        for k, a in enumerate(np.linspace(-1.7, 1.7, 12))
    ]
    core = spindle((-0.06, 0.024), (0.06, 0.024), z=0.08)
    knobs = [spindle((s * 0.072, 0.018), (s * 0.088, 0.018), z=0.08) if s > 0
             else spindle((-0.088, 0.018), (-0.072, 0.018), z=0.08) for s in (-1, 1)]  # fmt: skip
    return [(floor, tile), (stands[0], tile), (stands[1], tile), (core, dye(look, "gray")),
            (join(knobs), tile), (join(leaves[::2]), WHITE),
            (join(leaves[1::2]), dye(look, "cream", "ivory")),
            (join(tabs), dye(look, "blue", "green", "orange"))]  # fmt: skip


@category("magazine_file", size=(0.24, 0.093, 0.3), mass=0.8, material="plastic",
          aliases=("file holder", "document holder", "file box", "journal holder"),
          themes=("office",), roles=("big", "tall"), colors=("gray",))  # fmt: skip
@from_pieces()
def magazine_file(look: Look) -> Pieces:
    """A magazine file: an open, slanted box with magazines in it."""
    tile = plastic(look, "gray", "white", "blue", "red", "black", "beige")
    side = [(-0.12, 0.0), (0.12, 0.0), (0.12, 0.3), (0.06, 0.3), (-0.12, 0.13)]
    walls = [plate(side, 0.003).turn(0, np.pi / 2).move(0, s * 0.045 + 0.0015, 0) for s in (-1, 1)]
    ends = [at_box(0.003, 0.09, 0.3, (0.1185, 0, 0)), at_box(0.003, 0.09, 0.13, (-0.1185, 0, 0)),
            at_box(0.24, 0.09, 0.003)]  # fmt: skip
    books = [(at_box(0.2, 0.011, 0.26 + 0.004 * (k % 3), (0.012, -0.03 + 0.015 * k, 0.003)),
              dye(look, *PAINTS, "white")) for k in range(5)]  # fmt: skip
    return [(walls[0], tile), (walls[1], tile), (ends[0], tile), (ends[1], tile), (ends[2], tile),
            *books]  # fmt: skip


@category("docket_spike", size=(0.111, 0.123, 0.137), mass=0.2, material="metal",
          themes=("office",), colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def docket_spike(look: Look) -> Pieces:
    """A docket spike: a metal base with an upright spike through four sheets of paper."""
    base = disc(0.045, 0.012)
    pin = standing((0.0018, 0.01), (0.0016, 0.12), (0.0003, 0.135), sides=8)
    notes = [at_box(0.07, 0.1, 0.0012).turn(2, a).move(0.004 * np.cos(3 * a), 0, 0.014 + 0.006 * k)
             for k, a in enumerate((0.1, 0.5, -0.2, 0.3))]  # fmt: skip
    return [(base, metal(look, "black", "brass", "silver")), (pin, shine(look)),
            (join(notes), WHITE)]  # fmt: skip


@category("lectern", size=(0.32, 0.26, 0.265), mass=2.5, material="wood",
          aliases=("tabletop lectern", "podium", "speaker stand lectern", "pulpit",
          "table lectern"), themes=("office",), roles=("big",), colors=("brown",))  # fmt: skip
@from_pieces()
def lectern(look: Look) -> Pieces:
    """A table-top lectern: a slanted top with a lip on a closed base."""
    tile = wood(look, "brown", "wooden", "black", "maroon")
    base = at_block(0.3, 0.22, 0.02, 0.006)
    body = hull_solid([(x, y, z) for x in (-0.12, 0.12) for y, z in ((-0.08, 0.02), (0.09, 0.02),
                                                                     (-0.08, 0.16),
                                                                     (0.09, 0.23))])  # fmt: skip
    top = at_box(0.32, 0.25, 0.014).turn(0, 0.38).move(0, -0.006, 0.195)
    lip = at_box(0.32, 0.012, 0.03).turn(0, 0.38).move(0, -0.122, 0.15)
    return [(base, tile), (body, tile), (top, tile), (lip, tile)]


PAPER: RGB = (248, 247, 242)
CLEAR: RGB = (214, 226, 230)


def _acrylic(page: Callable[[Look, RGB, int, int], surfaces.Tile], form: tuple[float, float],
             pocket: bool) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape function of a leaning holder for a page, or for leaflets if ``pocket``."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        x, h = form[0] * k, form[1] * k
        color = look.color("white", "cream", "sky", "yellow", "red")
        lean = 0.28
        back = box(x, 0.003, h).turn(0, -lean).move(y=0.012)
        sheet = box(0.94 * x, 0.0012, 0.94 * h).move(y=-0.002, z=0.03 * h).turn(0, -lean).move(
            y=0.012)  # fmt: skip
        foot = block(x, 0.075 * k, 0.003, 0.004).move(y=0.02)
        glass = surfaces.plain(CLEAR)
        pieces: Pieces = [(join([back, foot]), glass), (sheet, page(look, color, 120, 170))]
        bodies = [back, foot]
        if pocket:
            stack = box(0.92 * x, 0.018, 0.8 * h).move(y=-0.011, z=0.02).turn(0, -lean).move(
                y=0.012)  # fmt: skip
            front = box(x, 0.003, 0.4 * h).move(y=-0.024).turn(0, -lean).move(y=0.012)
            pieces = [(join([back, foot, front]), glass), (stack, page(look, color, 120, 170))]
            bodies += [stack, front]
        low = min(float(s.bounds[0, 2]) for s in bodies)
        pieces = [(s.move(z=-low), t) for s, t in pieces]
        return shape(pieces, [hull_of(s.move(z=-low)) for s in bodies])

    return make


def _leaflet(look: Look, color: RGB, wide: int, tall: int) -> surfaces.Tile:
    image = prints.canvas(wide, tall, color)
    ink = readable_on(color)
    image[int(0.24 * tall) : int(0.6 * tall)] = surfaces.fit(prints.landscape(look.rng, 120, 60),
        int(0.6 * tall) - int(0.24 * tall), wide)  # fmt: skip
    prints.write(image, look.pick(["WELCOME", "TOURS", "OFFERS", "VISIT"]), 0.5, 0.13, 0.1, ink,
                 bold=True)  # fmt: skip
    prints.lines(image, look.rng, (0.12, 0.66, 0.76, 0.28), 6, ink)
    return image


@category("receipt_spike", size=(0.112, 0.136, 0.146), mass=0.25, material="metal", assembled=True,
          aliases=("bill spike", "paper spike", "spindle of receipts", "order spike", "spike file"),
          themes=("office",), colors=("black",))  # fmt: skip
def receipt_spike(look: Look) -> Shape:
    """A spike with receipts on it, on a round base."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "wooden", "silver", "red")
    foot = cylinder(0.04, 0.012, 28, bevel=0.002)
    needle = straight((0, 0, 0.01), (0, 0, 0.14), [0.0018, 0.0006], 8)
    slips = [box(0.07, 0.1, 0.0012).turn(2, look.between(-0.5, 0.5)).move(
             look.between(-0.006, 0.006), look.between(-0.01, 0.01), 0.013 + 0.005 * n)
             for n in range(6)]  # fmt: skip
    page = prints.canvas(64, 96, PAPER)
    prints.lines(page, look.rng, (0.1, 0.1, 0.8, 0.8), 12, (130, 130, 136))
    return shape([(foot, look.surface(color, "metal")), (needle, surfaces.plain((190, 194, 198))),
                  (join(slips), page)],
                 [hull_of(foot), hull_of(*slips), hull_of(needle)]).scale(k)  # fmt: skip


@category("empty_pencil_holder", size=(0.08, 0.08, 0.098), mass=0.12, material="plastic",
          hollow=True, aliases=("empty pen holder", "empty pen cup"), themes=("office", "craft"),
          roles=("container", "round"), colors=("black", "white"))  # fmt: skip
def empty_pencil_holder(look: Look) -> Shape:
    """An empty cup for pens."""
    r, h = look.between(0.038, 0.043), look.between(0.09, 0.105)
    color = look.color("black", "white", "teal", "wooden", "coral", "silver", "navy", "mustard")
    body, parts = open_vessel([(r, 0), (r, h)], 0.003, 0.005)
    return shape([(body, look.surface(color, look.pick(["plastic", "wood", "metal"])))], parts)


TRIPOD_DARK: RGB = (38, 36, 38)


@category("tripod", size=(0.16, 0.14, 0.229), mass=0.3, material="plastic", assembled=True,
          aliases=("mini tripod", "camera tripod", "phone tripod", "table tripod", "camera stand",
          "gimbal", "helping hands", "phone mount"), themes=("office",), roles=("tall",),
          colors=("black", "silver"))  # fmt: skip
def tripod(look: Look) -> Shape:
    """A small table tripod for a camera or phone, with a ball head and a grip."""
    k = look.between(0.85, 1.15)
    color = look.color("black", "silver", "charcoal", "red", "white", "blue")
    skin = look.surface(color, "metal")
    dark = surfaces.speckles(look.rng, TRIPOD_DARK, 4)
    high = look.between(0.13, 0.2) * k
    legs, tips, parts = [], [], []
    for n in range(3):
        a = -np.pi / 2 + 2 * np.pi * n / 3
        top = np.array([0.012 * k * np.cos(a), 0.012 * k * np.sin(a), high])
        end = np.array([0.085 * k * np.cos(a), 0.085 * k * np.sin(a), 0.008 * k])
        mid = 0.45 * top + 0.55 * end
        upper, lower = tube([top, mid], 0.0075 * k, 10), tube([mid, end], 0.0052 * k, 10)
        tip = ellipsoid(0.016 * k, 0.016 * k, 0.014 * k, 12, 8).move(*end).move(z=-0.001 * k)
        legs += [upper, lower]
        tips.append(tip)
        parts.append(hull_of(upper, lower, tip))
    hub = lathe([(0, 0), (0.02, 0), (0.02, 0.016), (0.012, 0.022), (0, 0.022)], 20).scale(k, k, k)
    hub = hub.move(z=high - 0.008 * k)
    ball = ellipsoid(0.026 * k, 0.026 * k, 0.026 * k, 18, 12).move(z=high + 0.022 * k)
    plate = [cylinder(0.017 * k, 0.006 * k, 24).move(z=high + 0.033 * k),
             cylinder(0.003 * k, 0.006 * k, 10).move(z=high + 0.039 * k)]  # fmt: skip
    knob = lay_down(cylinder(0.006 * k, 0.014 * k, 12), 0.011 * k, high + 0.022 * k)
    top = [hub, ball, *plate]
    clamp_ = []
    if look.chance(0.5):
        clamp_ = [box(0.03 * k, 0.012 * k, 0.006 * k).move(z=high + 0.042 * k),
                  box(0.03 * k, 0.008 * k, 0.06 * k).move(y=0.006 * k, z=high + 0.042 * k),
                  box(0.03 * k, 0.02 * k, 0.006 * k).move(z=high + 0.1 * k)]  # fmt: skip
    pieces = [(join(legs), skin), (join([*tips, *top, knob, *clamp_]), dark)]
    parts += [hull_of(hub), hull_of(ball, *plate)]
    if clamp_:
        parts.append(hull_of(*clamp_))
    return shape(pieces, parts)


@category("bookend", size=(0.115, 0.115, 0.15), mass=0.6, material="metal", assembled=True,
          aliases=("book end", "book stop", "book stand"), themes=("office", "living"),
          roles=("tall",), colors=("black", "silver"))  # fmt: skip
def bookend(look: Look) -> Shape:
    """An L-shaped bookend: of sheet metal, of wood with a brace, or of metal with a marble ball."""
    x, y, h = look.between(0.1, 0.13), look.between(0.1, 0.13), look.between(0.13, 0.17)
    color = look.color("black", "silver", "red", "white", "teal", "gold", "wooden")
    kind = look.pick(["sheet", "wood", "ball"])
    if kind == "sheet":
        foot = box(y, x, 0.0016)
        outline = rectangle(x, h, 0.03, 5) + np.array([0, h / 2])
        hole = rectangle(0.46 * x, 0.46 * h, 0.02, 4) + np.array([0, 0.52 * h])
        wall = prism(outline, 0, 0.0016).turn(0, np.pi / 2).turn(2, np.pi / 2)
        inner = prism(hole, 0, 0.0022).turn(0, np.pi / 2).turn(2, np.pi / 2)
        wall, inner = wall.move(x=-y / 2), inner.move(x=-y / 2 - 0.0003)
        skin = look.surface(color, "metal")
        return shape([(join([foot, wall]), skin), (inner, surfaces.plain(tint_color(color, 0.55)))],
                     [hull_of(foot), hull_of(wall)])  # fmt: skip
    wood = look.surface(color, "wood" if kind == "wood" else "metal")
    foot, wall = box(y, x, 0.014), box(0.016, x, h - 0.014).move(x=-y / 2 + 0.008, z=0.014)
    if kind == "wood":
        prop = side_view(np.array([(-y / 2 + 0.016, 0.014), (0.36 * y, 0.014),
                                   (-y / 2 + 0.016, 0.8 * h)]), 0.02)  # fmt: skip
        return shape(
            [(join([foot, wall, prop]), wood)], [hull_of(foot), hull_of(wall), hull_of(prop)]
        )
    ball = ellipsoid(0.62 * y, 0.62 * y, 0.62 * y, 22, 14).move(x=0.1 * y, z=0.32 * y + 0.01)
    other = look.surface(look.own_color("gold", "white", "silver", "black"), "marble")
    return shape([(join([foot, wall]), wood), (ball, other)],
                 [hull_of(foot), hull_of(wall), hull_of(ball)])  # fmt: skip


@category("desk_tray", size=(0.26, 0.185, 0.045), mass=0.5, material="plastic", hollow=True,
          aliases=("letter tray", "paper tray", "document tray", "organizer", "desk organizer",
          "writing slope", "drawer", "in tray", "in-tray", "out tray"), themes=("office",),
          roles=("container",), colors=("wooden", "white", "black"), common=True)  # fmt: skip
def desk_tray(look: Look) -> Shape:
    """A letter tray or drawer organiser: a low, open box."""
    x, y, h, wall = look.between(0.24, 0.28), look.between(0.17, 0.2), 0.045, 0.005
    tile = look.surface(look.color("wooden", "white", "black", "gray"), "wood")
    walls = open_box(x, y, h, wall, wall)
    return shape([(solid, tile) for solid in walls], frame_parts(x, y, h, wall, wall))


@category("desk_caddy", size=(0.225, 0.135, 0.113), mass=0.5, material="wood", hollow=True,
          aliases=("caddy", "desktop organizer", "desk organiser", "book caddy", "desk tidy",
          "stationery organizer", "pen organizer", "desktop caddy", "stationery holder",
          "drawer organiser", "cutlery organiser", "drawer organizer tray"), themes=("office",),
          roles=("container",), colors=("wooden", "white"))  # fmt: skip
def desk_caddy(look: Look) -> Shape:
    """A desk caddy with compartments of two heights for books or pens."""
    x, y = look.between(0.2, 0.25), look.between(0.12, 0.15)
    low, high, t = look.between(0.055, 0.07), look.between(0.1, 0.125), 0.005
    color = look.color("wooden", "tan", "white", "black", "gray", "sky", "mint", "pink")
    skin = look.surface(color, look.pick(["wood", "plastic"]))
    back, front = 0.5 * y, -0.5 * y
    walls = [box(x, y, t),
             box(x, t, high - t).move(y=back - t / 2, z=t),
             box(x, t, high - t).move(y=0.04 * y, z=t),
             box(x, t, low - t).move(y=front + t / 2, z=t)]  # fmt: skip
    walls += [box(t, 0.46 * y, high - t).move(s * (x / 2 - t / 2), 0.27 * y, t) for s in (-1, 1)]
    walls += [box(t, 0.54 * y, low - t).move(s * (x / 2 - t / 2), -0.23 * y, t) for s in (-1, 1)]
    split = [box(t, 0.44 * y, high - t).move(0.12 * x, 0.27 * y, t),
             box(t, 0.5 * y, low - t).move(-0.1 * x, -0.22 * y, t)]  # fmt: skip
    solids = [*walls, *split]
    return shape([(s, skin) for s in solids], [hull_of(s) for s in solids])


@category("pencil_holder", size=(0.1, 0.1, 0.165), mass=0.25, material="wood", hollow=True,
          assembled=True, aliases=("pen holder", "pen cup", "pencil cup", "pencil pot"),
          themes=("office", "craft"), roles=("tall", "round"), colors=("black", "white"),
          opened="empty_pencil_holder", common=True)  # fmt: skip
def pencil_holder(look: Look) -> Shape:
    """A cup with pens and pencils standing in it."""
    r, h = look.between(0.038, 0.043), look.between(0.09, 0.105)
    color = look.color("black", "white", "teal", "wooden", "coral", "silver", "navy", "mustard")
    wall = look.surface(color, look.pick(["plastic", "wood", "metal"]))
    if look.chance(0.5):
        wall = glaze_tile(look, color)
    elif look.chance(0.4):
        wall = prints.mesh_holes(color, tint_color(color, 0.5), 10, 20)
    cup = lathe([(0, 0), (r, 0), (r, h), (r - 0.003, h), (r - 0.003, 0.005), (0, 0.005)], 28)
    pieces = [(cup, wall)]
    parts = [cylinder_part(r, h)]
    for k in range(int(look.rng.integers(4, 7))):
        angle, tall = 2.4 * k + look.between(0, 0.6), look.between(0.13, 0.17)
        way = np.array([np.cos(angle), np.sin(angle)])
        tint = surfaces.plain(look.own_color("yellow", "red", "blue", "green", "black", "orange"))
        stick = _leaning(way, 0.012, r - 0.007, h, tall)
        tip = _leaning(way, 0.012, r - 0.007, h, tall + 0.012, tall)
        wood = surfaces.plain((222, 186, 132))
        pieces += [(stick, tint), (tip, wood)]
        if k < 5:
            parts.append(hull_part(stick.vertices))
    return shape(pieces, parts)


def _leaning(
    way: np.ndarray, low: float, reach: float, rim: float, top: float, start: float = 0.006
) -> Solid:
    """Return a pen that leans outwards against a cup's rim, or its tip if ``start`` > 1 cm."""
    hexagon = np.array([[np.cos(a), np.sin(a)] for a in np.pi / 3 * np.arange(6)])
    tip = start > 0.01
    rings = []
    for z, radius in [(start, 0.004), (top, 0.0012 if tip else 0.004)]:
        middle = way * (-low + (reach + low) * z / rim)
        rings.append(np.column_stack([hexagon * radius + middle, np.full(6, z)]))
    return loft(np.stack(rings), hexagon)


_PLAY = 0.003  # clearance in a slot beside the object, metres


@category("letter_rack", size=(0.072, 0.158, 0.108), mass=0.4, material="wood",
          aliases=("letter holder", "mail rack", "mail holder", "letter sorter", "envelope holder",
          "magazine rack", "magazine holder", "file rack", "record rack", "book rack",
          "letter stand"), themes=("office",), colors=("wooden", "white"),
          holder=Holder("edge", (0.06, 0.36, 0.32)))  # fmt: skip
def letter_rack(look: Look) -> Shape:
    """A rack of upright boards, higher towards the back, for letters and magazines."""
    count, (a, b, c) = read_request(look, 3, (0.012, 0.19, 0.12))
    color = look.color("wooden", "brown", "white", "black", "gold", "wooden", "teal")
    skin = look.surface(color, look.pick(["wood", "metal"]))
    wall, floor = 0.005, 0.01
    pitch = max(a + _PLAY, 0.014) + wall
    cells = max(count, 2)
    y = 0.78 * b
    base = (cells * pitch + wall + 0.01, y + 0.01, floor, 0.0, 0.0, 0.0)
    heights = np.linspace(0.6, 0.82, cells + 1) * c
    rows = [(wall, y, float(h), u, 0.0, floor)
            for u, h in zip(centres(cells + 1, pitch), heights, strict=True)]  # fmt: skip
    solids, parts = _boards([base, *rows])
    slots = choose_slots(centres(cells, pitch), count, floor)
    return shape([(join(solids), skin)], parts, slots=slots)


CATEGORIES = (
    Category("sign_holder", _acrylic(menu_page, (0.15, 0.2), False), size=(0.15, 0.0865, 0.194),
             mass=0.15, material="plastic", assembled=True, aliases=("menu holder",
             "acrylic sign holder", "menu stand", "table sign", "acrylic sign", "sign stand",
             "table talker", "countertop sign", "menu board"), themes=("office",), roles=("tall",),
             colors=("white",)),
    Category("leaflet_holder", _acrylic(_leaflet, (0.115, 0.19), True), size=(0.114, 0.0823, 0.181),
             mass=0.35, material="plastic", assembled=True, aliases=("brochure holder",
             "leaflet stand", "leaflet dispenser", "brochure stand", "pamphlet holder",
             "flyer holder"), themes=("office",), roles=("tall",), colors=("sky",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
