"""Aquariums and what goes into them."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import blade, facing
from ...build.outlines import ellipse, smooth
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def fish_tank(look: Look) -> Shape:
    """An aquarium: water with fish, weed and gravel behind glass, a dark lid and base."""
    k, color = look.between(0.85, 1.05), look.color("sky", "cyan", "teal", "blue")
    x, y, h = 0.32 * k, 0.18 * k, 0.21 * k
    pale = tint_color(color, 1.35)

    def scene(wide: int) -> textures.Tile:
        image = prints.canvas(wide, 128, pale)
        image[64:] = np.array(tint_color(color, 1.15), np.uint8)
        for n in range(wide // 18):
            root, top = look.rng.uniform(0, 1), look.rng.uniform(0.25, 0.6)
            prints.stroke(image, [(root, 0.86), (root + 0.02, 0.5 + 0.5 * top - 0.2),
                                  (root - 0.01, top)],
                          0.03, (50, 130 + 8 * (n % 4), 70))  # fmt: skip
        for _ in range(max(wide // 50, 2)):
            a, b = look.rng.uniform(0.12, 0.86), look.rng.uniform(0.22, 0.7)
            hue = look.own_color("orange", "gold", "red", "yellow", "coral")
            s = 128 / wide
            prints.disc(image, a, b, 0.05, hue)
            prints.disc(image, a + 0.03 * s, b, 0.042, hue)
            prints.polygon(
                image, [(a + 0.06 * s, b), (a + 0.13 * s, b - 0.05), (a + 0.13 * s, b + 0.05)], hue
            )
            prints.disc(image, a - 0.025 * s, b - 0.01, 0.011, (20, 20, 24))
        gravel = textures.fit(
            textures.spots(look.rng, (214, 186, 140), (140, 110, 84), 0.4), 20, wide
        )
        image[108:] = gravel
        return image

    front, side = scene(208), scene(118)
    walls = []
    for n, (w, tile) in enumerate(((x, front), (y, side), (x, front), (y, side))):
        pane = (
            box(w, 0.001, h).move(y=-(y if n % 2 == 0 else x) / 2 + 0.0006).turn(2, n * np.pi / 2)
        )
        walls.append((pane.move(z=0.012), tile))
    lid, base = (
        block(x + 0.006, y + 0.006, 0.02, 0.004).move(z=h + 0.01),
        block(x + 0.006, y + 0.006, 0.014, 0.004),
    )
    posts = [
        box(0.005, 0.005, h).move(i * x / 2, j * y / 2, 0.012) for i in (-1, 1) for j in (-1, 1)
    ]
    hatch = block(0.4 * x, 0.5 * y, 0.006, 0.004).move(0.1 * x, 0, h + 0.028)
    dark = textures.plain((38, 40, 44))
    water = box(0.985 * x, 0.985 * y, h).move(z=0.012)
    return shape([(water, textures.plain(pale)), *walls, (join([lid, base, *posts]), dark),
                  (hatch, textures.plain((66, 70, 76)))],
                 [box_part(x + 0.006, y + 0.006, h + 0.03), hull_of(hatch)])  # fmt: skip


def fish_net(look: Look) -> Shape:
    """A small aquarium net: a wire handle, a square hoop, a sagging net, lying."""
    k, color = look.between(0.85, 1.15), look.color("green", "blue", "white", "black")
    hoop = tube(smooth([(-0.05, -0.04, 0.03), (-0.05, 0.04, 0.03), (0.04, 0.045, 0.03),
                        (0.05, 0.0, 0.03), (0.04, -0.045, 0.03),
                        (-0.05, -0.04, 0.03)], 4), 0.0019, 6)  # fmt: skip
    handle = tube([(0.048, 0, 0.03), (0.09, 0, 0.02), (0.2, 0, 0.003)], 0.0024, 7)
    grip = tube([(0.16, 0, 0.0085), (0.21, 0, 0.004)], 0.005, 9)
    net = lathe(
        [
            (0, 0.0),
            (0.2, 0.0),
            (0.34, 0.25),
            (0.46, 0.7),
            (0.5, 1.0),
            (0.485, 1.0),
            (0.44, 0.7),
            (0.32, 0.28),
            (0, 0.04),
        ],
        22,
    )
    net = net.scale(0.1, 0.086, 0.03).move(x=-0.004)
    mesh = prints.mesh_holes(tint_color(color, 1.1), tint_color(color, 0.6), 14, 30)
    metal = textures.plain((200, 204, 208))
    return settle(
        [(net, mesh), (join([hoop, handle]), metal), (grip, textures.plain((50, 54, 60)))],
        0.02,
        hulls=[[0], [1]],
    ).scale(k)


def aquarium_castle(look: Look) -> Shape:
    """A castle for an aquarium: two round towers and a gate of grey stone, moss on it."""
    k, color = look.between(0.85, 1.15), look.color("gray", "tan", "charcoal", "beige")
    towers, teeth = [], []
    for x, r, h in ((-0.034, 0.02, 0.1), (0.036, 0.018, 0.08)):
        towers.append(
            lathe(
                [
                    (0, 0),
                    (1.15 * r, 0),
                    (r, 0.01),
                    (0.92 * r, 0.8 * h),
                    (1.15 * r, 0.84 * h),
                    (1.15 * r, h),
                    (0, h),
                ],
                16,
            ).move(x=x)
        )
        teeth += [
            box(0.007, 0.007, 0.01).move(x + 1.0 * r * np.cos(a), 1.0 * r * np.sin(a), h)
            for a in np.arange(6) * np.pi / 3
        ]
    wall = block(0.07, 0.03, 0.052, 0.004)
    teeth += [box(0.008, 0.03, 0.009).move(0.016 * i, 0, 0.052) for i in (-1, 0, 1)]
    base = prism(ellipse(0.14, 0.08, 24), 0, 0.01, 0.003)
    gate = facing(cylinder(0.012, 0.002, 16)).move(y=-0.0155, z=0.026)
    door = box(0.024, 0.002, 0.024).move(y=-0.0155, z=0.002)
    holes = [
        box(0.005, 0.004, 0.012).move(x, -0.019 + 0.002 * (x > 0), z)
        for x, z in ((-0.034, 0.055), (0.036, 0.045), (-0.034, 0.03))
    ]
    moss = [
        ellipsoid(0.03, 0.016, 0.014, 8, 5).move(x, y, z)
        for x, y, z in ((-0.05, -0.018, 0.0085), (0.055, -0.01, 0.0085), (0.0, -0.03, 0.0085))
    ]
    y, x = np.mgrid[0:96, 0:96]
    joint = ((y % 12) < 2) | (((x + 8 * ((y // 12) % 2)) % 16) < 2)
    stone = textures.speckles(look.rng, color, 20, 96)
    stone = np.where(joint[..., None], (stone * 0.7).astype(np.uint8), stone)
    return settle([(join([*towers, wall]), stone),
                   (join(teeth), textures.speckles(look.rng, color, 12)),
                   (join([gate, door, *holes]), textures.plain((34, 34, 36))),
                   (base, textures.spots(look.rng, color, tint_color(color, 0.6), 0.3)),
                   (join(moss), textures.speckles(look.rng, (86, 140, 64), 16))], 0.0,
                   hulls=[[0], [3]]).scale(k)  # fmt: skip


def aquarium_heater(look: Look) -> Shape:
    """An aquarium heater: a glass tube with a coil inside, a black head, a cord, lying."""
    k, color = look.between(0.85, 1.1), look.color("black", "charcoal", "gray", "white")
    tube_ = cylinder(0.012, 0.16, 18, bevel=0.004).turn(1, np.pi / 2).move(-0.12, 0, 0.012)
    image = prints.canvas(96, 160, (206, 220, 226))
    for n in range(14):
        prints.fill(image, 0, 0.25 + 0.045 * n, 1, 0.016, (190, 120, 70))
    prints.fill(image, 0.3, 0.06, 0.4, 0.14, (40, 60, 120))
    cap = cylinder(0.0135, 0.045, 18, bevel=0.003).turn(1, np.pi / 2).move(0.035, 0, 0.0135)
    knob = cylinder(0.006, 0.008, 12).move(0.066, 0, 0.024)
    cord = tube(
        smooth(
            [
                (0.078, 0, 0.012),
                (0.1, 0.01, 0.004),
                (0.12, -0.02, 0.003),
                (0.1, -0.045, 0.003),
                (0.04, -0.05, 0.003),
            ],
            5,
        ),
        0.0028,
        7,
    )
    dark = look.surface(color, "plastic")
    return settle([(tube_, image.transpose(1, 0, 2)), (join([cap, cord]), dark),
                   (knob, textures.plain((206, 60, 50)))],
                  0.04, hulls=[[0], [1]]).scale(k)  # fmt: skip


def air_pump(look: Look) -> Shape:
    """An aquarium air pump: a rounded box on rubber feet, a dial, a clear hose."""
    k, color = look.between(0.85, 1.15), look.color("blue", "black", "gray", "white", "teal")
    body = block(0.1, 0.06, 0.045, 0.018, 0.008).move(z=0.005)
    feet = [
        cylinder(0.008, 0.007, 12).move(i * 0.036, j * 0.018, 0) for i in (-1, 1) for j in (-1, 1)
    ]
    dial = facing(cylinder(0.01, 0.006, 18)).move(-0.02, -0.03, 0.026)
    ribs = [box(0.004, 0.04, 0.002).move(0.01 * i, 0, 0.0492) for i in range(-3, 4)]
    hose = tube(
        smooth(
            [
                (0.05, 0, 0.026),
                (0.075, 0.01, 0.02),
                (0.09, 0.05, 0.003),
                (0.05, 0.075, 0.003),
                (0, 0.07, 0.003),
            ],
            5,
        ),
        0.003,
        7,
    )
    return shape([(s.scale(k, k, k), t) for s, t in (
        (body, look.surface(color, "plastic")),
        (join([*feet, *ribs]), textures.plain((34, 34, 38))),
        (dial, textures.plain((220, 222, 226))), (hose, textures.plain((206, 226, 226))))],
        [hull_of(body.scale(k, k, k)), *[hull_of(f.scale(k, k, k)) for f in feet]])  # fmt: skip


def water_plant(look: Look) -> Shape:
    """A plastic plant for an aquarium: waving leaves on a flat stone foot."""
    k, color = look.between(0.85, 1.15), look.color("green", "lime", "crimson", "purple")
    leaves = []
    for n in range(11):
        a, h = 2.4 * n, look.between(0.07, 0.13)
        out = 0.008 + 0.014 * (n % 3)
        x, y = np.cos(a), np.sin(a)
        leaves.append(blade([(0.006 * x, 0.006 * y, 0.01), (out * x + 0.006 * y,
                                                            out * y - 0.006 * x, 0.5 * h),
                                                            (1.5 * out * x, 1.5 * out * y, h)],
                            0.015, thick=0.2))  # fmt: skip
    foot = ellipsoid(0.055, 0.05, 0.026, 16, 8).move(z=0.003)
    return settle([(foot, textures.spots(look.rng, (150, 140, 126), (110, 100, 90), 0.3)),
                   (join(leaves), textures.leaf(look.rng, color))],
                  0.06, hulls=[[0], [1]]).scale(k)  # fmt: skip


_P = ("living",)

CATEGORIES = (
    Category("fish_tank", fish_tank, (0.304, 0.174, 0.23), 9.0, ("aquarium", "small aquarium",
        "goldfish tank", "aquarium tank", "fishtank"), _P, ("big",), ("sky",)),
    Category("fish_net", keep_still(fish_net), (0.268, 0.101, 0.0325), 0.04,
             ("aquarium net", "small fishing net", "hand net", "fishing net"), _P,
             (),
             ("green",), state="lying"),
    Category("aquarium_castle", aquarium_castle, (0.138, 0.0786, 0.121), 0.3,
             ("aquarium ornament", "aquarium decoration", "fish tank castle",
             "fish tank ornament", "miniature castle", "model castle"), _P,
             (), ("gray",)),
    Category("aquarium_heater", aquarium_heater, (0.245, 0.0667, 0.0308), 0.15,
             ("fish tank heater", "submersible heater"), _P, (), ("black",), state="lying"),
    Category("air_pump", air_pump, (0.147, 0.118, 0.0526), 0.3, ("aquarium pump",
        "aquarium air pump", "fish tank pump", "aquarium filter"), _P, (), ("blue",)),
    Category("aquarium_plant", water_plant, (0.0879, 0.083, 0.141), 0.06,
             ("plastic aquarium plant", "water plant", "fake aquarium plant", "seaweed plant"), _P,
             (),
             ("green",)),
)  # fmt: skip
"""The module's categories."""
