"""Dishes ready to eat: pizza, burger, hot dog, sushi, fries, pancakes, biscuits, chocolate."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of
from ...build.forms import lobe, speck
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .food import skin

CRUST: RGB = (206, 152, 86)


def pizza(look: Look) -> Shape:
    """A round pizza on a board or bare, cut into slices."""
    r = look.between(0.12, 0.155)
    sauce = textures.noise(look.rng, 192, 192, (7, 7), 3)[..., None]
    cheese = np.where(sauce > -0.25, (240, 200, 104), (202, 82, 46)) + sauce * 12
    face = np.clip(cheese, 0, 255).astype(np.uint8)
    toppings: list[RGB] = [(178, 40, 34), (64, 116, 48), (46, 40, 44), (236, 222, 190)]
    first = look.own_color("crimson", "red", "maroon")
    spots = int(look.rng.integers(9, 15))
    for k in range(spots):
        a, away = 2.4 * k, 0.41 * np.sqrt((k + 0.5) / spots)
        prints.disc(
            face, 0.5 + away * np.cos(a), 0.5 + away * np.sin(a), 0.055, tint_color(first, 0.8)
        )
        prints.disc(face, 0.5 + away * np.cos(a), 0.5 + away * np.sin(a), 0.046, first)
    for color in toppings[1 : int(look.rng.integers(2, 5))]:
        face = speck(face, look.rng, color, 26, 6)
    for k in range(4):
        t = np.linspace(-0.5, 0.5, 300)
        rows = (96 + 188 * t * np.sin(np.pi * k / 4 + 0.3)).astype(int)
        face[rows, (96 + 188 * t * np.cos(np.pi * k / 4 + 0.3)).astype(int)] = (120, 66, 30)
    crust = skin(look, CRUST, (150, 92, 44))
    base = cylinder(r, 0.01, 40, bevel=0.003)
    rim = torus(0.94 * r, 0.0105, 40, 8).scale(1, 1, 0.85).move(z=0.012)
    top = cylinder(0.9 * r, 0.004, 40).move(z=0.0095)
    pieces = [(join([base, rim]), crust), (top, face)]
    if look.chance(0.5):
        return shape(pieces, [cylinder_part(r, 0.0155)])
    board = cylinder(1.12 * r, 0.014, 40, bevel=0.002)
    wood = textures.wood(look.rng, look.own_color("wooden", "tan", "beige"))
    pieces = [(solid.move(z=0.0135), tile) for solid, tile in pieces] + [(board, wood)]
    return shape(pieces, [cylinder_part(1.12 * r, 0.014), cylinder_part(r, 0.016, (0, 0, 0.0135))])


def _bun(look: Look) -> textures.Tile:
    return skin(look, look.own_color("amber", "tan", "copper"), (160, 96, 44), 0.6)


def _drooping(p: np.ndarray, r: float) -> np.ndarray:
    """Return points, those beyond radius ``r`` hanging down."""
    beyond = np.maximum(np.hypot(p[:, 0], p[:, 1]) - r, 0)
    return np.column_stack([p[:, :2], p[:, 2] - 0.7 * beyond])


def burger(look: Look) -> Shape:
    """A hamburger: buns, lettuce, tomato, cheese and a patty."""
    r = look.between(0.042, 0.055)
    bread = _bun(look)
    layers: list[tuple[Solid, textures.Tile]] = [(cylinder(r, 0.016, 28, bevel=0.005), bread)]
    z = 0.015
    patty = textures.spots(look.rng, (98, 58, 36), (62, 34, 22), 0.15)
    for _ in range(2 if look.chance(0.3) else 1):
        layers.append((cylinder(1.04 * r, 0.014, 26, bevel=0.004).move(z=z), patty))
        z += 0.013
        flat = prism(rectangle(1.62 * r, 1.62 * r, 0.002, 1), z, z + 0.003).turn(2, 0.5)
        layers.append((flat.bend(lambda p: _drooping(p, r)), textures.plain((244, 184, 62))))
        z += 0.002
    tomato = cylinder(0.98 * r, 0.005, 24, bevel=0.001).move(z=z)
    wave = lobe(cylinder(1.13 * r, 0.004, 48, bevel=0.001), 13, 0.16).move(z=z + 0.004)
    wavy = wave.bend(lambda p: p + np.column_stack([np.zeros((len(p), 2)), 0.0025 * np.sin(
        9 * np.arctan2(p[:, 1], p[:, 0])) * (np.hypot(p[:, 0], p[:, 1]) > 0.6 * r)]))  # fmt: skip
    layers += [(tomato, textures.plain((200, 52, 40))),
               (wavy, textures.speckles(
                   look.rng, look.own_color("green", "lime"), 14))]  # fmt: skip
    z += 0.007
    a = np.linspace(0, np.pi / 2, 8)
    curve = np.column_stack([1.03 * r * np.cos(a), 0.006 + 0.62 * r * np.sin(a)])[:-1]
    dome = lathe([(0, 0), (0.95 * r, 0), *curve, (0, 0.006 + 0.62 * r)], 28)
    seeds = []
    for _ in range(26):
        lift, turn = look.rng.uniform(0.5, 1.45), look.rng.uniform(0, 6.3)
        at = np.array(
            [
                1.03 * r * np.cos(lift) * np.cos(turn),
                1.03 * r * np.cos(lift) * np.sin(turn),
                0.0065 + 0.62 * r * np.sin(lift),
            ]
        )
        seeds.append(ellipsoid(0.0042, 0.0028, 0.0022, 6, 4).turn(2, turn).move(*at))
    layers += [(dome.move(z=z), bread),
               (join(seeds).move(z=z), textures.plain((244, 228, 180)))]  # fmt: skip
    return shape(layers, [cylinder_part(r, z), hull_of(dome.move(z=z))])


def hot_dog(look: Look) -> Shape:
    """A sausage in a split bun with a line of mustard or ketchup."""
    length, r = look.between(0.14, 0.17), look.between(0.018, 0.022)
    bread = _bun(look)
    halves = [
        ellipsoid(length, 1.7 * r, 2.1 * r, 22, 12).turn(0, s * 0.25).move(y=s * 0.78 * r, z=r)
        for s in (-1, 1)
    ]
    base = ellipsoid(0.94 * length, 2.6 * r, 1.1 * r, 22, 10).move(z=0.5 * r)
    x = np.linspace(-0.54, 0.54, 9) * length
    lift = 1.55 * r + 0.25 * r * (2 * x / length) ** 2
    sausage = tube(np.column_stack([x, 0 * x, lift]),
                   0.6 * r * np.array([0.3, 0.85, 1, 1, 1, 1, 1, 0.85, 0.3]), 14)  # fmt: skip
    t = np.linspace(-0.44, 0.44, 60)
    wave = np.column_stack([t * length, 0.3 * r * np.sin(2 * np.pi * 7 * t),
                            2.16 * r + 0.25 * r * (2 * t) ** 2])  # fmt: skip
    line = tube(wave, 0.0022, 6)
    meat = skin(look, look.own_color("terracotta", "copper", "maroon"), (128, 54, 34))
    bun = join([*halves, base])
    return shape(
        [(bun, bread), (sausage, meat),
         (line, textures.plain(look.own_color("yellow", "red", "mustard")))],
        [flat_foot(bun.vertices), hull_of(sausage)],
    )  # fmt: skip


def sushi_plate(look: Look) -> Shape:
    """A board of sushi: rolls, and rice topped with fish or shrimp."""
    x, y = look.between(0.2, 0.24), look.between(0.1, 0.12)
    board = look.pick([
        textures.wood(look.rng, look.own_color("tan", "wooden", "brown")),
        textures.speckles(look.rng, look.own_color("black", "charcoal", "teal"), 4),
    ])  # fmt: skip
    plate = box(x, y, 0.008).move(z=0.01)
    feet = [box(0.012, 0.94 * y, 0.011).move(x=s * 0.36 * x) for s in (-1, 1)]
    rice_tile = textures.spots(look.rng, (244, 242, 232), (222, 218, 204), 0.25)
    fish, rice, rolls, dots = [], [], [], []
    for k in range(4):
        px = (k - 1.5) * 0.23 * x
        rice.append(block(0.022, 0.046, 0.02, 0.009, 0.005).move(px, 0.23 * y, 0.0175))
        top = ellipsoid(0.028, 0.064, 0.014, 14, 8).move(px, 0.23 * y, 0.04)
        fish.append(top.bend(lambda p: p - (p[:, 1:2] - 0.23 * y) ** 2 * [0, 0, 7.2]))
    for k in range(5):
        at = ((k - 2) * 0.185 * x, -0.2 * y, 0.0175)
        rolls.append(cylinder(0.0165, 0.025, 20).move(*at))
        rice.append(cylinder(0.0145, 0.0262, 18).move(*at))
        dots.append(cylinder(0.0065, 0.0275, 12).move(*at))
    stripes = [look.own_color("coral", "orange", "red"), look.own_color("coral", "pink", "cream")]
    salmon = textures.stripes([stripes[0]] * 3 + [tint_color(stripes[1], 1.5)], 7, side=96)
    filling = textures.plain(look.own_color("coral", "lime", "yellow", "orange"))
    return shape(
        [(join([plate, *feet]), board), (join(rice), rice_tile), (join(fish), salmon),
         (join(rolls), textures.speckles(look.rng, (30, 40, 34), 5)), (join(dots), filling)],
        [box_part(x, y, 0.018), hull_of(*fish, *rice[:4]), hull_of(*rolls)],
    )  # fmt: skip


def fries(look: Look) -> Shape:
    """A paper cup of French fries."""
    w, h = look.between(0.06, 0.075), look.between(0.07, 0.09)
    color = look.color("red", "white", "yellow", "blue", "tan")
    paper = textures.stripes([color, look.own_color("white", "yellow", "cream")], 5, upright=True)
    if look.chance(0.5):
        paper = prints.canvas(64, 64, color)
        prints.disc(paper, 0.5, 0.55, 0.22, look.own_color("yellow", "white", "red"))
    cup = box(w, 0.55 * w, h).bend(lambda p: p * np.column_stack(
        [0.74 + 0.26 * p[:, 2] / h, 0.74 + 0.26 * p[:, 2] / h, np.ones(len(p))]))  # fmt: skip
    sticks = []
    for k in range(26):
        x = ((k % 9) - 4) / 4 * 0.4 * w + look.rng.uniform(-2, 2) * 1e-3
        y = (k // 9 - 1) * 0.14 * w
        lift = look.between(0.28, 0.62) * h
        stick = box(0.0085, 0.0085, lift + 0.02).turn(1, 0.34 * x / w + look.rng.normal(0, 0.07))
        sticks.append(stick.turn(0, look.rng.normal(0, 0.07)).move(x, y, h - 0.02))
    gold = textures.gradient((206, 150, 60), (246, 208, 108), look.rng)
    top = hull_of(*[s.bend(lambda p: np.minimum(p, [1, 1, 1.42 * h])) for s in sticks])
    return shape([(cup, paper), (join(sticks), gold)], [hull_of(cup), top])


CATEGORIES = (
    Category("pizza", pizza, (0.29, 0.29, 0.028), 0.7, ("pepperoni pizza", "whole pizza"),
             ("dining", "food"), ("round", "flat", "big", "edible"), (), state="lying flat"),
    Category("burger", burger, (0.108, 0.108, 0.08), 0.28,
             ("hamburger", "cheeseburger", "beef burger"), ("dining", "food"),
             ("round", "edible")),
    Category("hot_dog", hot_dog, (0.165, 0.065, 0.05), 0.13, ("hotdog",),
             ("dining", "food"), ("edible",), state="lying flat"),
    Category("sushi_plate", sushi_plate, (0.22, 0.11, 0.046), 0.6,
             ("sushi", "sushi board", "sushi set"),
             ("dining", "food"), ("edible",), state="lying flat"),
    Category("fries", fries, (0.072, 0.042, 0.125), 0.14,
             ("french fries", "chip cup", "box of fries", "french fry", "paper cone of chips",
             "cone of chips", "cone of fries"), ("dining", "food"),
             ("edible",), ("red", "white")),
)  # fmt: skip
"""The module's categories."""
