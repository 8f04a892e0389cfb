"""Objects of the ``living`` theme: pet supplies."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import leather
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import above, box_part, hull_of, hull_part, ring_parts
from ...kit.primitives import ball, blade, facing, limb, pad, rod, side_view, straight
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, put_down, settle, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, readable_on, tint_color


@category("birdhouse", size=(0.125, 0.145, 0.16), mass=0.45, material="wood", hollow=True,
          aliases=("bird house", "nest box", "nesting box", "bird box"), themes=("living",),
          roles=("tall",), colors=("wooden", "blue"))  # fmt: skip
def birdhouse(look: Look) -> Shape:
    """A wooden birdhouse with a round hole and a perch."""
    color = look.color("wooden", "blue", "red", "white", "yellow", "green", "teal")
    w, d, h = look.between(0.09, 0.11), look.between(0.085, 0.1), look.between(0.1, 0.12)
    walls = side_view([(-w / 2, 0), (w / 2, 0), (w / 2, h), (0, h + 0.45 * w), (-w / 2, h)], d)
    s45 = 0.733
    slope = 0.72 * w
    roof = [box(slope, d + 0.03, 0.007).move(x=-slope / 2 + 0.0035).turn(1, -s45)
            .move(0.0, 0, h + 0.45 * w + 0.002),
            box(slope, d + 0.03, 0.007).move(x=slope / 2 - 0.0035).turn(1, s45)
            .move(0.0, 0, h + 0.45 * w + 0.002)]  # fmt: skip
    hole = cylinder(0.018, 0.002, 22).turn(0, np.pi / 2).move(0, -d / 2 + 0.0008, 0.68 * h)
    rim = cylinder(0.022, 0.0015, 22).turn(0, np.pi / 2).move(0, -d / 2 + 0.0006, 0.68 * h)
    perch = straight((0, -d / 2 + 0.002, 0.4 * h), (0, -d / 2 - 0.03, 0.4 * h), 0.004)
    floor = box(w + 0.02, d + 0.02, 0.007)
    other = look.own_color("brown", "red", "charcoal", "white", "teal")
    pieces: Pieces = [
        (walls, look.surface(color, "wood")),
        (join(roof), surfaces.wood(look.rng, other)),
        (hole, surfaces.plain((30, 26, 24))),
        (join([rim, perch, floor]), surfaces.wood(look.rng, tint_color(color, 0.8))),
    ]
    return put_down(pieces, walls, floor, *roof)


@category("bird_feeder", size=(0.145, 0.145, 0.185), mass=0.4, material="wood", assembled=True,
          aliases=("birdfeeder", "feeder"), themes=("living",), roles=("tall",),
          colors=("green", "wooden"))  # fmt: skip
def bird_feeder(look: Look) -> Shape:
    """A bird feeder on a stand: a tray with seeds, a tube and a roof."""
    color = look.color("wooden", "green", "red", "black", "copper", "teal")
    r = look.between(0.062, 0.075)
    tray = cylinder(r, 0.014, 28, bevel=0.002)
    seeds = cylinder(0.9 * r, 0.004, 28).move(z=0.0125)
    pipe = cylinder(0.034, 0.11, 24).move(z=0.014)
    ports = [cylinder(0.008, 0.003, 12).turn(0, np.pi / 2).move(0, -0.0325, z).turn(2, a)
             for z in (0.045, 0.09) for a in (0, np.pi / 2, np.pi, -np.pi / 2)]  # fmt: skip
    roof = cylinder(1.05 * r, 0.042, 28, top=0.008).move(z=0.122)
    hook = torus(0.01, 0.0022, 16, 6).turn(0, np.pi / 2).move(z=0.17)
    grain = surfaces.spots(look.rng, (196, 154, 92), (74, 60, 48), 0.3)
    skin = look.surface(color, "metal")
    pieces: Pieces = [(join([tray, roof]), skin), (join([seeds, pipe]), grain),
                      (join([*ports, hook]), surfaces.plain((52, 52, 56)))]  # fmt: skip
    return put_down(pieces, tray, pipe, roof, factor=look.between(0.9, 1.15))


@category("bird_cage", size=(0.175, 0.175, 0.25), mass=0.6, material="metal", hollow=True,
          aliases=("birdcage", "cage", "small bird cage", "bird in a cage"), themes=("living",),
          roles=("tall",), colors=("white", "gold"))  # fmt: skip
def bird_cage(look: Look) -> Shape:
    """A small bird cage: a round tray, bars that meet in a dome and a bird on its perch."""
    color = look.color("white", "black", "gold", "brass", "mint", "silver")
    r, h = look.between(0.075, 0.09), look.between(0.2, 0.25)
    wire = look.surface(color, "metal")
    base = cylinder(1.06 * r, 0.02, 28, bevel=0.002)
    bars = [rod([(r, 0, 0.018), (r, 0, 0.4 * h), (0.92 * r, 0, 0.75 * h), (0.4 * r, 0, 0.96 * h),
                 (0.01, 0, h)], 0.0016, 5, 2).turn(2, 2 * np.pi * k / 16)
            for k in range(16)]  # fmt: skip
    hoops = [torus(r, 0.0018, 28, 6).move(z=z) for z in (0.25 * h, 0.55 * h)]
    ring = torus(0.014, 0.0024, 18, 6).turn(0, np.pi / 2).move(z=h + 0.013)
    perch = straight((-0.97 * r, 0, 0.36 * h), (0.97 * r, 0, 0.36 * h), 0.0032, 8)
    hue = surfaces.plain(look.own_color("yellow", "blue", "green", "orange"))
    bird = [ball(0.03, 0.028, 0.046, (0, 0, 0.36 * h + 0.022), 12),
            ball(0.026, 0.025, 0.025, (0, -0.003, 0.36 * h + 0.05), 12),
            box(0.012, 0.006, 0.05).turn(0, -0.5).move(0, 0.006, 0.36 * h - 0.026)]  # fmt: skip
    beak = cylinder(0.005, 0.01, 8, top=0.0006).turn(0, np.pi / 2).move(0, -0.014, 0.36 * h + 0.05)
    pieces: Pieces = [(join([base, *bars, *hoops, ring]), wire), (join(bird), hue),
                      (join([perch, beak]), surfaces.wood(look.rng, (190, 144, 94)))]  # fmt: skip
    return put_down(pieces, base, join(bars))


@category("fish_tank", size=(0.304, 0.174, 0.23), mass=9.0, material="glass",
          aliases=("aquarium", "small aquarium", "goldfish tank", "aquarium tank", "fishtank"),
          themes=("living",), roles=("big",), colors=("sky",))  # fmt: skip
def fish_tank(look: Look) -> Shape:
    """An aquarium with fish, plants and gravel behind glass, and a dark lid and base."""
    k, color = look.between(0.85, 1.05), look.color("sky", "cyan", "teal", "blue")
    x, y, h = 0.32 * k, 0.18 * k, 0.21 * k
    pale = tint_color(color, 1.35)

    def scene(wide: int) -> surfaces.Tile:
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
        gravel = surfaces.fit(
            surfaces.spots(look.rng, (214, 186, 140), (140, 110, 84), 0.4), 20, wide
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
    lid, base = (block(x + 0.006, y + 0.006, 0.02, 0.004).move(z=h + 0.01),
                 block(x + 0.006, y + 0.006, 0.014, 0.004))  # fmt: skip
    posts = [
        box(0.005, 0.005, h).move(i * x / 2, j * y / 2, 0.012) for i in (-1, 1) for j in (-1, 1)
    ]
    hatch = block(0.4 * x, 0.5 * y, 0.006, 0.004).move(0.1 * x, 0, h + 0.028)
    dark = surfaces.plain((38, 40, 44))
    water = box(0.985 * x, 0.985 * y, h).move(z=0.012)
    return shape([(water, surfaces.plain(pale)), *walls, (join([lid, base, *posts]), dark),
                  (hatch, surfaces.plain((66, 70, 76)))],
                 [box_part(x + 0.006, y + 0.006, h + 0.03), hull_of(hatch)])  # fmt: skip


@category("fish_net", size=(0.268, 0.101, 0.0325), mass=0.04, material="plastic", assembled=True,
          aliases=("aquarium net", "small fishing net", "hand net", "fishing net"),
          themes=("living",), colors=("green",), state="lying")  # fmt: skip
@keep_still
def fish_net(look: Look) -> Shape:
    """A small aquarium net lying flat: a wire handle and a square hoop with a sagging net."""
    k, color = look.between(0.85, 1.15), look.color("green", "blue", "white", "black")
    hoop = tube(smooth([(-0.05, -0.04, 0.03), (-0.05, 0.04, 0.03), (0.04, 0.045, 0.03),
                        (0.05, 0.0, 0.03), (0.04, -0.045, 0.03),
                        (-0.05, -0.04, 0.03)], 4), 0.0019, 6)  # fmt: skip
    handle = tube([(0.048, 0, 0.03), (0.09, 0, 0.02), (0.2, 0, 0.003)], 0.0024, 7)
    grip = tube([(0.16, 0, 0.0085), (0.21, 0, 0.004)], 0.005, 9)
    net = lathe([(0, 0.0), (0.2, 0.0), (0.34, 0.25), (0.46, 0.7), (0.5, 1.0), (0.485, 1.0),
                 (0.44, 0.7), (0.32, 0.28), (0, 0.04)], 22)  # fmt: skip
    net = net.scale(0.1, 0.086, 0.03).move(x=-0.004)
    mesh = prints.mesh_holes(tint_color(color, 1.1), tint_color(color, 0.6), 14, 30)
    metal = surfaces.plain((200, 204, 208))
    return settle([(net, mesh), (join([hoop, handle]), metal),
                   (grip, surfaces.plain((50, 54, 60)))], 0.02,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("aquarium_castle", size=(0.138, 0.0786, 0.121), mass=0.3, material="stone",
          aliases=("aquarium ornament", "aquarium decoration", "fish tank castle",
          "fish tank ornament", "miniature castle", "model castle"), themes=("living",),
          colors=("gray",))  # fmt: skip
def aquarium_castle(look: Look) -> Shape:
    """An aquarium castle of grey, mossy stone: two round towers and a gate."""
    k, color = look.between(0.85, 1.15), look.color("gray", "tan", "charcoal", "beige")
    towers, teeth = [], []
    for x, r, h in ((-0.034, 0.02, 0.1), (0.036, 0.018, 0.08)):
        towers.append(lathe([(0, 0), (1.15 * r, 0), (r, 0.01), (0.92 * r, 0.8 * h),
                             (1.15 * r, 0.84 * h), (1.15 * r, h), (0, h)],
                            16).move(x=x))  # fmt: skip
        teeth += [box(0.007, 0.007, 0.01).move(x + 1.0 * r * np.cos(a), 1.0 * r * np.sin(a), h)
                  for a in np.arange(6) * np.pi / 3]  # fmt: skip
    wall = block(0.07, 0.03, 0.052, 0.004)
    teeth += [box(0.008, 0.03, 0.009).move(0.016 * i, 0, 0.052) for i in (-1, 0, 1)]
    base = prism(ellipse(0.14, 0.08, 24), 0, 0.01, 0.003)
    gate = facing(cylinder(0.012, 0.002, 16)).move(y=-0.0155, z=0.026)
    door = box(0.024, 0.002, 0.024).move(y=-0.0155, z=0.002)
    holes = [box(0.005, 0.004, 0.012).move(x, -0.019 + 0.002 * (x > 0), z) for x,
             z in ((-0.034, 0.055), (0.036, 0.045), (-0.034, 0.03))]  # fmt: skip
    moss = [
        ellipsoid(0.03, 0.016, 0.014, 8, 5).move(x, y, z)
        for x, y, z in ((-0.05, -0.018, 0.0085), (0.055, -0.01, 0.0085), (0.0, -0.03, 0.0085))
    ]
    y, x = np.mgrid[0:96, 0:96]
    joint = ((y % 12) < 2) | (((x + 8 * ((y // 12) % 2)) % 16) < 2)
    stone = surfaces.speckles(look.rng, color, 20, 96)
    stone = np.where(joint[..., None], (stone * 0.7).astype(np.uint8), stone)
    return settle([(join([*towers, wall]), stone),
                   (join(teeth), surfaces.speckles(look.rng, color, 12)),
                   (join([gate, door, *holes]), surfaces.plain((34, 34, 36))),
                   (base, surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.3)),
                   (join(moss), surfaces.speckles(look.rng, (86, 140, 64), 16))], 0.0,
                   hulls=[[0], [3]]).scale(k)  # fmt: skip


@category("aquarium_heater", size=(0.245, 0.0667, 0.0308), mass=0.15, material="plastic",
          aliases=("fish tank heater", "submersible heater"), themes=("living",), colors=("black",),
          state="lying")  # fmt: skip
def aquarium_heater(look: Look) -> Shape:
    """An aquarium heater lying flat: a glass tube with a coil inside, a black head and a cord."""
    k, color = look.between(0.85, 1.1), look.color("black", "charcoal", "gray", "white")
    tube_ = cylinder(0.012, 0.16, 18, bevel=0.004).turn(1, np.pi / 2).move(-0.12, 0, 0.012)
    image = prints.canvas(96, 160, (206, 220, 226))
    for n in range(14):
        prints.fill(image, 0, 0.25 + 0.045 * n, 1, 0.016, (190, 120, 70))
    prints.fill(image, 0.3, 0.06, 0.4, 0.14, (40, 60, 120))
    cap = cylinder(0.0135, 0.045, 18, bevel=0.003).turn(1, np.pi / 2).move(0.035, 0, 0.0135)
    knob = cylinder(0.006, 0.008, 12).move(0.066, 0, 0.024)
    cord = tube(smooth([(0.078, 0, 0.012), (0.1, 0.01, 0.004), (0.12, -0.02, 0.003),
                        (0.1, -0.045, 0.003), (0.04, -0.05, 0.003)], 5), 0.0028, 7)  # fmt: skip
    dark = look.surface(color, "plastic")
    return settle([(tube_, image.transpose(1, 0, 2)), (join([cap, cord]), dark),
                   (knob, surfaces.plain((206, 60, 50)))],
                  0.04, hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("air_pump", size=(0.147, 0.118, 0.0526), mass=0.3, material="plastic",
          aliases=("aquarium pump", "aquarium air pump", "fish tank pump", "aquarium filter"),
          themes=("living",), colors=("blue",))  # fmt: skip
def air_pump(look: Look) -> Shape:
    """An aquarium air pump: a rounded box on rubber feet with a dial and a clear hose."""
    k, color = look.between(0.85, 1.15), look.color("blue", "black", "gray", "white", "teal")
    body = block(0.1, 0.06, 0.045, 0.018, 0.008).move(z=0.005)
    feet = [
        cylinder(0.008, 0.007, 12).move(i * 0.036, j * 0.018, 0) for i in (-1, 1) for j in (-1, 1)
    ]
    dial = facing(cylinder(0.01, 0.006, 18)).move(-0.02, -0.03, 0.026)
    ribs = [box(0.004, 0.04, 0.002).move(0.01 * i, 0, 0.0492) for i in range(-3, 4)]
    hose = tube(smooth([(0.05, 0, 0.026), (0.075, 0.01, 0.02), (0.09, 0.05, 0.003),
                        (0.05, 0.075, 0.003), (0, 0.07, 0.003)], 5), 0.003, 7)  # fmt: skip
    return shape([(s.scale(k, k, k), t) for s, t in (
        (body, look.surface(color, "plastic")),
        (join([*feet, *ribs]), surfaces.plain((34, 34, 38))),
        (dial, surfaces.plain((220, 222, 226))), (hose, surfaces.plain((206, 226, 226))))],
        [hull_of(body.scale(k, k, k)), *[hull_of(f.scale(k, k, k)) for f in feet]])  # fmt: skip


@category("aquarium_plant", size=(0.0879, 0.083, 0.141), mass=0.06, material="plastic",
          aliases=("plastic aquarium plant", "water plant", "fake aquarium plant", "seaweed plant"),
          themes=("living",), colors=("green",))  # fmt: skip
def aquarium_plant(look: Look) -> Shape:
    """A plastic aquarium plant: wavy leaves on a flat stone base."""
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
    return settle([(foot, surfaces.spots(look.rng, (150, 140, 126), (110, 100, 90), 0.3)),
                   (join(leaves), surfaces.leaf(look.rng, color))],
                  0.06, hulls=[[0], [1]]).scale(k)  # fmt: skip


STEEL: RGB = (190, 194, 200)


@category("pet_carrier", size=(0.248, 0.349, 0.254), mass=1.4, material="plastic", hollow=True,
          aliases=("cat carrier", "dog carrier", "pet crate", "dog crate", "cat crate",
          "animal carrier", "pet cage"), themes=("living",), roles=("big",),
          colors=("gray",))  # fmt: skip
def pet_carrier(look: Look) -> Shape:
    """A pet carrier: a plastic shell with slits, a barred door in front and a handle on top."""
    k, color = look.between(0.9, 1.1), look.color("gray", "beige", "blue", "pink", "teal")
    x, y, h = 0.24 * k, 0.34 * k, 0.22 * k
    low = block(x, y, 0.5 * h, 0.04 * k, 0.008)
    rings = [(1.0, 0.5), (1.0, 0.7), (0.94, 0.88), (0.8, 0.99), (0.7, 1.0)]

    outline = rectangle(0.97 * x, 0.97 * y, 0.04 * k)
    top = loft(np.stack([np.column_stack([outline * s, np.full(len(outline), z * h)]) for s,
                         z in rings]), outline)  # fmt: skip
    rim = block(1.03 * x, 1.02 * y, 0.05 * h, 0.04 * k).move(z=0.48 * h)
    door = facing(prism(rectangle(0.62 * x, 0.62 * h, 0.02 * k), 0, 0.004)).move(
        y=-0.497 * y, z=0.47 * h
    )
    bars = [
        box(0.004, 0.004, 0.58 * h).move(i * 0.06 * x, -0.51 * y, 0.18 * h) for i in range(-5, 6)
    ]
    bars += [box(0.62 * x, 0.004, 0.004).move(y=-0.51 * y, z=z * h) for z in (0.2, 0.47, 0.74)]
    slits = [box(0.002, 0.05 * k, 0.01 * k).move(s * 0.486 * x, j * 0.075 * k,
                                                 (0.58 + 0.09 * i) * h)
             for s in (-1, 1) for j in (-1, 0, 1) for i in range(2)]  # fmt: skip
    grip = tube(smooth([(0, -0.07 * k, 0.98 * h), (0, -0.06 * k, 1.1 * h), (0, 0.06 * k, 1.1 * h),
                        (0, 0.07 * k, 0.98 * h)], 4), 0.008 * k, 8)  # fmt: skip
    pale, deep = (surfaces.speckles(look.rng, tint_color(color, 1.35), 4),
                  surfaces.speckles(look.rng, color, 4))  # fmt: skip
    dark = surfaces.plain((40, 42, 46))
    return shape([(low, deep), (top, pale), (rim, deep), (door, dark), (join(slits), dark),
                  (join(bars), surfaces.plain(STEEL)), (grip, deep)],
                 [hull_of(low, rim), hull_of(top), hull_of(grip), hull_of(*bars)])  # fmt: skip


@category("pet_bed", size=(0.312, 0.281, 0.0897), mass=0.5, material="fabric", hollow=True,
          aliases=("dog bed", "cat bed", "puppy bed", "pet basket", "dog basket", "cat basket"),
          themes=("living",), roles=("container", "big"), colors=("gray",))  # fmt: skip
def pet_bed(look: Look) -> Shape:
    """A round or oval pet bed: a cushion inside a thick, soft rim that is lower in front."""
    k, color = (look.between(0.85, 1.05), look.color("gray", "beige", "brown", "blue", "pink",
                                                     "teal"))  # fmt: skip
    r, t, wide = 0.15 * k, 0.042 * k, look.between(1.0, 1.2)
    rim = torus(r - t, t, 40, 12).move(z=0.9 * t)
    rim = rim.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] * (1 + 0.28 * p[:, 1] / r)])).scale(
        wide, 1, 1
    )
    bed = ellipsoid(2 * (r - t), 2 * (r - t), 0.05 * k, 28, 10).move(z=0.024 * k).scale(wide, 1, 1)
    outside = surfaces.fabric(look.rng, color)
    soft = surfaces.scratches(look.rng, tint_color(color, 1.5), tint_color(color, 1.3), 200)
    inner = [(r - 2 * t, 1.4 * t), (r - 2 * t, 0.3 * t)]
    wall = ring_parts(
        [(r - 0.6 * t, 0), (0.98 * r, 0.3 * t), (0.98 * r, 1.4 * t)], inner, 14, stretch=(wide, 1.0)
    )
    return shape([(rim, outside), (bed, soft)], [*wall, hull_part(above(bed.vertices))])


@category("hamster_wheel", size=(0.134, 0.108, 0.15), mass=0.15, material="plastic", hollow=True,
          aliases=("running wheel", "exercise wheel", "pet wheel"), themes=("living",),
          colors=("blue",))  # fmt: skip
def hamster_wheel(look: Look) -> Shape:
    """A hamster wheel: a ribbed drum between two rims on an upright stand."""
    k, color = (look.between(0.85, 1.1), look.color("blue", "pink", "green", "yellow", "purple",
                                                    "orange"))  # fmt: skip
    r, w = 0.07 * k, 0.05 * k
    z = r + 0.016
    drum = lathe([(0.94 * r, 0), (r, 0), (r, w), (0.94 * r, w)], 36, loop=True)
    back = cylinder(0.98 * r, 0.003, 36)
    spokes = [box(1.9 * r, 0.008, 0.004).turn(2, a).move(z=0.003) for a in np.pi / 3 * np.arange(3)]
    rungs = [
        box(0.006, 0.01, w).move(x=0.95 * r).turn(2, a) for a in 2 * np.pi * np.arange(18) / 18
    ]
    wheel = [facing(s).move(y=w / 2, z=z) for s in (drum, back, *spokes)]
    bars = [facing(s).move(y=w / 2, z=z) for s in rungs]
    axle = facing(cylinder(0.007, 0.02, 14)).move(y=w / 2 + 0.014, z=z)
    leg = prism(
        np.array([(-0.055, 0), (0.055, 0), (0.008, 1), (-0.008, 1)]) * [k, z + 0.008], 0, 0.008
    ).turn(0, np.pi / 2)
    leg = leg.move(y=w / 2 + 0.016)
    foot = block(0.12 * k, w + 0.06, 0.006, 0.01).move(y=0.008)
    tile, other = (
        surfaces.speckles(look.rng, color, 4),
        surfaces.plain(look.own_color("white", "yellow", "gray")),
    )
    return shape([(join(wheel), tile), (join(bars), surfaces.plain(tint_color(color, 0.75))),
                  (join([axle, leg, foot]), other)],
                 [hull_of(foot), hull_of(leg), hull_of(wheel[0])])  # fmt: skip


@category("scratching_post", size=(0.189, 0.189, 0.303), mass=1.2, material="fabric",
          assembled=True,
          aliases=("cat scratching post", "scratch post", "cat tree", "cat post", "cat scratcher"),
          themes=("living",), roles=("tall",), colors=("beige",))  # fmt: skip
def scratching_post(look: Look) -> Shape:
    """A scratching post: a sisal post with a plush base, a plush top and a hanging ball."""
    k, color = look.between(0.85, 1.05), look.color("beige", "gray", "brown", "cream", "pink")
    r, h, side = 0.028 * k, 0.3 * k, 0.2 * k
    base, top = (block(side, side, 0.022, 0.02, 0.004),
                 block(0.12 * k, 0.12 * k, 0.02, 0.02, 0.004).move(z=h))  # fmt: skip
    post = cylinder(r, h - 0.015, 24).move(z=0.018)
    cord = tube([(0.045 * k, -0.03 * k, h), (0.046 * k, -0.031 * k, h - 0.07 * k)], 0.001, 5)
    ball = ellipsoid(0.03 * k, 0.03 * k, 0.03 * k, 14, 9).move(0.046 * k, -0.031 * k, h - 0.08 * k)
    plush = surfaces.scratches(look.rng, color, tint_color(color, 0.85), 220)
    sisal = surfaces.stripes([(206, 178, 128), (186, 156, 104)], 20, side=120)
    return shape([(join([base, top]), plush), (post, sisal),
                  (cord, surfaces.plain((240, 238, 233))),
                  (ball, surfaces.plain(look.own_color("red", "blue", "white")))],
                 [hull_of(base), hull_of(post), hull_of(top)])  # fmt: skip


@category("muzzle", size=(0.132, 0.225, 0.0979), mass=0.12, material="plastic", hollow=True,
          aliases=("dog muzzle", "basket muzzle"), themes=("living",),
          colors=("black",))  # fmt: skip
def muzzle(look: Look) -> Shape:
    """A dog muzzle standing on its rim: bars around the snout and a strap behind."""
    k, color = look.between(0.85, 1.15), look.color("black", "brown", "tan", "red")
    hoops = [torus(r, 0.0026, 26, 6).scale(1, 1.2, 1).move(z=z) for r, z in
             ((0.05, 0.003), (0.049, 0.03), (0.045, 0.058), (0.032, 0.084))]  # fmt: skip
    bars = [tube(smooth([(0.05 * np.cos(a), 0.06 * np.sin(a), 0.003), (0.049 * np.cos(a),
        0.059 * np.sin(a), 0.03),
                         (0.045 * np.cos(a), 0.054 * np.sin(a), 0.058),
                         (0.03 * np.cos(a), 0.036 * np.sin(a), 0.086),
                         (0, 0, 0.093)], 3), 0.0024,
                         6) for a in 2 * np.pi * np.arange(10) / 10]  # fmt: skip
    strap = (lathe([(0.062, 0), (0.0645, 0), (0.0645, 0.014), (0.062, 0.014)], 28,
                   loop=True).scale(1, 1.25, 1).move(y=0.075))  # fmt: skip
    tile = look.surface(color, "plastic")
    return settle([(join([*hoops, *bars]), tile), (strap, surfaces.plain(tint_color(color, 0.7)))],
                  0.0, hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("puppy_pad", size=(0.219, 0.168, 0.0169), mass=0.08, material="fabric",
          aliases=("puppy training pad", "pee pad", "training pad", "pet pad"), themes=("living",),
          roles=("flat",), colors=("blue",), state="lying folded")  # fmt: skip
def puppy_pad(look: Look) -> Shape:
    """A folded puppy pad lying flat: white quilted layers with a coloured edge."""
    x, y, t = look.between(0.2, 0.24), look.between(0.15, 0.18), look.between(0.01, 0.02)
    color = look.color("blue", "sky", "pink", "green")
    image = surfaces.fit(surfaces.grid((222, 226, 230), (250, 250, 250), 9, 12), 128, 176).copy()
    for a, b, w, h in ((0, 0, 1, 0.06), (0, 0.94, 1, 0.06), (0, 0, 0.045, 1), (0.955, 0, 0.045, 1)):
        prints.fill(image, a, b, w, h, color)
    layers = [block(x - 0.004 * n, y - 0.003 * n, t / 4, 0.01, 0.0005).move(0, 0.001 * n, n * t / 4)
              for n in range(4)]  # fmt: skip
    return shape([(join(layers), surfaces.plain(tint_color(color, 1.2))),
                  (box(0.93 * x, 0.92 * y, 0.0006).move(y=0.003, z=t - 0.0002), image)],
                 [box_part(x, y, t)])  # fmt: skip


@category("bird_perch", size=(0.223, 0.132, 0.234), mass=0.5, material="wood", assembled=True,
          aliases=("bird stand", "parrot stand", "parrot perch"), themes=("living",),
          roles=("tall",), colors=("wooden",))  # fmt: skip
def bird_perch(look: Look) -> Shape:
    """A bird perch: a wooden bar with a cup at each end, on a post that stands on a tray."""
    k, color = look.between(0.85, 1.1), look.color("wooden", "brown", "tan")
    tray = block(0.18 * k, 0.13 * k, 0.012, 0.02, 0.002)
    post = cylinder(0.009 * k, 0.19 * k, 14).move(z=0.01)
    bar = tube([(-0.11 * k, 0, 0.2 * k), (0.11 * k, 0, 0.2 * k)], 0.01 * k, 12)
    cups = [lathe([(0, 0), (0.018, 0), (0.022, 0.026), (0.02, 0.026), (0.017, 0.003), (0, 0.003)],
                  18).move(s * 0.085 * k, 0, 0.205 * k)
            for s in (-1, 1)]  # fmt: skip
    wood = look.surface(color, "wood")
    return shape([(join([tray, post, bar]), wood),
                  (join(cups), surfaces.brushed_metal(look.rng, STEEL))],
                 [hull_of(tray), hull_of(post), hull_of(bar),
                  *[hull_of(c) for c in cups]])  # fmt: skip


def tin(
    words: tuple[str, ...], r: float, h: float, palette: tuple[str, ...], sign: str
) -> Callable[[Look], Shape]:
    """Return the shape function of a tin with a ring pull and a label that names its contents."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.93, 1.07), look.color(*palette)
        image = prints.canvas(320, 128, color)
        for start in (0.0, 0.5):
            part = image[:, int(320 * start) : int(320 * start) + 160]
            prints.disc(part, 0.5, 0.64, 0.27, tint_color(color, 1.6))
            _sign(part, sign, tint_color(color, 0.5))
            prints.write(part, look.pick(list(words)), 0.5, 0.2, 0.2, readable_on(color), bold=True)
        image = np.roll(image, 80, axis=1)
        rim = surfaces.plain((200, 202, 206))
        body = lathe([(0, 0), (r, 0), (r, h), (0, h)], 32, v=[0, 0, 1, 1])
        rings = [torus(r, 0.0014, 32, 6).move(z=z) for z in (0.0015, h - 0.0005)]
        lid = cylinder(0.97 * r, 0.001, 28).move(z=h - 0.0004)
        pull = [torus(0.0085, 0.0013, 16, 6).scale(1.2, 0.9, 1).move(0.3 * r, 0, h + 0.002),
                box(0.016, 0.008, 0.002).move(0.0, 0, h)]  # fmt: skip
        made = [(body, image), (join([*rings, lid, *pull]), rim)]
        return shape([(s.scale(k, k, k), t) for s, t in made], [hull_of(body.scale(k, k, k))])

    return make


def _sign(image: prints.Canvas, sign: str, ink: RGB) -> None:
    if sign == "cat":
        prints.disc(image, 0.5, 0.68, 0.15, ink)
        for s in (-1, 1):
            prints.polygon(
                image, [(0.5 + 0.12 * s, 0.64), (0.5 + 0.11 * s, 0.43), (0.5 + 0.02 * s, 0.55)], ink
            )
    elif sign == "dog":
        prints.fill(image, 0.4, 0.6, 0.2, 0.09, ink)
        for x in (0.38, 0.62):
            for y in (0.58, 0.71):
                prints.disc(image, x, y, 0.07, ink)
    else:
        prints.disc(image, 0.48, 0.64, 0.13, ink)
        prints.polygon(image, [(0.56, 0.64), (0.68, 0.52), (0.68, 0.76)], ink)


SLICKER_BRUSH_STEEL: RGB = (190, 194, 200)


@category("slicker_brush", size=(0.174, 0.0499, 0.0255), mass=0.09, material="plastic",
          aliases=("cat brush", "dog brush", "pet brush", "grooming brush", "dog grooming brush",
          "pin brush", "pet comb"), themes=("living",), colors=("blue",),
          state="lying")  # fmt: skip
def slicker_brush(look: Look) -> Shape:
    """A pet brush lying with its pins up: a handle and a flat head full of wire pins."""
    k, color = (look.between(0.9, 1.1), look.color("blue", "pink", "green", "purple", "orange",
                                                   "red"))  # fmt: skip
    grip = limb([(0.03, 0, 0.011), (0.07, 0, 0.011), (0.12, 0, 0.011), (0.135, 0, 0.011)],
                [0.008, 0.0085, 0.011, 0.006], 12)  # fmt: skip
    head = block(0.08, 0.05, 0.012, 0.008, 0.002)
    bed = box(0.068, 0.04, 0.002).move(z=0.012)
    pins = [cylinder(0.0006, 0.011, 4).turn(1, 0.25).move(0.008 * i - 0.028, 0.0072 * j, 0.0135)
            for i in range(8) for j in range(-2, 3)]  # fmt: skip
    tips = [ellipsoid(0.0022, 0.0022, 0.0022, 6, 4).move(0.008 * i - 0.0255, 0.0072 * j, 0.0245)
            for i in range(8) for j in range(-2, 3)]  # fmt: skip
    return settle([(join([grip, head]), look.surface(color, "plastic")),
                   (bed, surfaces.plain((54, 54, 60))),
                   (join(pins), surfaces.plain(SLICKER_BRUSH_STEEL)),
                   (join(tips), surfaces.plain(tint_color(color, 1.3)))],
                  0.0, hulls=[[0], [1, 3]]).scale(k)  # fmt: skip


@category("ball_thrower", size=(0.42, 0.0641, 0.0585), mass=0.2, material="plastic",
          aliases=("ball launcher", "tennis ball thrower", "dog ball launcher", "dog ball thrower",
          "chuckit"), themes=("living",), roles=("big",), colors=("blue",),
          state="lying")  # fmt: skip
def ball_thrower(look: Look) -> Shape:
    """A dog ball thrower lying flat: a long, curved stick with a cup that holds a tennis ball."""
    k, color = look.between(0.85, 1.0), look.color("blue", "orange", "red", "purple", "green")
    stick = limb([(-0.24, 0, 0.012), (-0.1, 0.01, 0.012), (0.06, 0.02, 0.014), (0.14, 0.01, 0.018)],
                 [0.012, 0.008, 0.0075, 0.009], 10, 0.7)  # fmt: skip
    cup = lathe([(0.0, -0.034), (0.02, -0.028), (0.0345, 0), (0.03, 0.014), (0.0335, 0),
                 (0.019, -0.026), (0, -0.031)], 22)  # fmt: skip
    cup = cup.turn(1, -1.9).move(0.178, 0.006, 0.033)
    ball = ellipsoid(0.063, 0.063, 0.063, 20, 12).move(0.176, 0.006, 0.0325)
    felt = surfaces.scratches(look.rng, (204, 222, 62), (180, 200, 50), 150)
    return settle(
        [(join([stick, cup]), look.surface(color, "plastic")), (ball, felt)], 0.03, hulls=[[0], [1]]
    ).scale(k)


@category("cat_wand", size=(0.475, 0.0659, 0.0108), mass=0.03, material="plastic", assembled=True,
          aliases=("cat teaser", "feather wand", "feather toy", "cat feather toy",
          "cat teaser wand"), themes=("living",), roles=("big",), colors=("pink",),
          state="lying")  # fmt: skip
@keep_still
def cat_wand(look: Look) -> Shape:
    """A cat wand lying flat: a thin rod with a cord, feathers and a bell at its end."""
    k, color = (look.between(0.85, 1.0), look.color("pink", "blue", "green", "orange", "purple",
                                                    "red"))  # fmt: skip
    rod = tube([(-0.24, 0, 0.004), (0.08, 0, 0.004)], [0.004, 0.0026], 8)
    grip = tube([(-0.25, 0, 0.005), (-0.15, 0, 0.005)], 0.0055, 10)
    cord = limb([(0.08, 0, 0.003), (0.12, 0.03, 0.0015), (0.16, -0.01, 0.0015),
                 (0.19, 0.01, 0.003)], [0.001] * 4, 5)  # fmt: skip
    feathers = [blade([(0.19, 0.01, 0.005), (0.22, 0.01 + 0.02 * s, 0.009),
                       (0.26, 0.01 + 0.035 * s, 0.003)], 0.022, thick=0.15)
                for s in (-1, 0, 1)]  # fmt: skip
    bell = ellipsoid(0.012, 0.012, 0.012, 12, 8).move(0.188, 0.01, 0.006)
    hue = look.own_color("yellow", "red", "sky", "lime")
    return settle([(rod, surfaces.plain(tint_color(color, 0.9))), (grip,
        surfaces.speckles(look.rng, tint_color(color, 0.7), 6)),
                   (cord, surfaces.plain((60, 60, 66))), (join(feathers),
                                                          surfaces.scratches(look.rng, hue,
                                                              tint_color(hue, 0.75), 60)),
                   (bell, surfaces.plain((212, 172, 82)))], 0.05, hulls=[[0, 1],
                       [3, 4]]).scale(k)  # fmt: skip


@category("rope_toy", size=(0.243, 0.0531, 0.0299), mass=0.1, material="fabric", assembled=True,
          aliases=("dog rope", "rope chew", "dog rope toy", "tug toy", "dog toy", "rope dog toy"),
          themes=("living",), colors=("blue",), state="lying")  # fmt: skip
def rope_toy(look: Look) -> Shape:
    """A dog's rope toy: a thick, twisted rope with knotted and frayed ends."""
    k, color = look.between(0.85, 1.15), look.color("blue", "red", "green", "orange", "teal")
    bend = look.between(0.0, 0.03)
    u = np.linspace(-1, 1, 13)
    rope = tube(np.column_stack([0.07 * u, bend * (u * u - 0.5), 0 * u]), 0.011, 10)
    knots = [ellipsoid(0.032, 0.04, 0.036, 14, 9).move(s * 0.072, bend / 2, 0) for s in (-1, 1)]
    frays = [limb([(s * 0.08, bend / 2, 0), (s * 0.1, bend / 2 + 0.009 * np.cos(a),
                                             0.007 * np.sin(a)),
                   (s * 0.125, bend / 2 + 0.022 * np.cos(a), 0.012 * np.sin(a))],
                   [0.005, 0.004, 0.0015], 6)
             for s in (-1, 1) for a in np.arange(7) * 0.9]  # fmt: skip
    y, x = np.mgrid[0:96, 0:96]
    twist = (x / 96 * 3 + y / 96 * 14) % 1
    tile = np.where((twist < 0.35)[..., None], np.array(color), np.array((244, 240, 228))).astype(
        np.uint8
    )
    return settle([(rope, tile), (join(knots), tile),
                   (join(frays), surfaces.stripes([color, (244, 240, 228)], 5, upright=True))],
                  0.14, hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("cuttlebone", size=(0.155, 0.0627, 0.0206), mass=0.02, material="stone",
          aliases=("cuttle bone", "cuttlefish bone"), themes=("living",), colors=("white",),
          state="lying")  # fmt: skip
def cuttlebone(look: Look) -> Shape:
    """A cuttlebone lying flat: a white oval with a harder rim."""
    k, color = look.between(0.85, 1.2), look.color("white", "ivory", "cream")
    body = ellipsoid(0.14, 0.052, 0.022, 26, 12).bend(lambda p: p * np.column_stack([
        np.ones(len(p)), 1 - 1.8 * p[:, 0], np.ones(len(p))]))  # fmt: skip
    rim = ellipsoid(0.15, 0.06, 0.006, 26, 8).bend(lambda p: p * np.column_stack([
        np.ones(len(p)), 1 - 1.8 * p[:, 0], np.ones(len(p))]))  # fmt: skip
    lines = surfaces.stripes([color, color, tint_color(color, 0.9)], 14, upright=True)
    return settle([(body, lines), (rim, surfaces.plain(tint_color(color, 0.86)))], 0.1).scale(k)


@category("clicker", size=(0.12, 0.0371, 0.0237), mass=0.02, material="plastic",
          aliases=("training clicker", "dog clicker", "dog training clicker"), themes=("living",),
          colors=("blue",))  # fmt: skip
def clicker(look: Look) -> Shape:
    """A training clicker: a small, rounded box with a button and a wrist loop."""
    k, color = (look.between(0.9, 1.15), look.color("blue", "red", "yellow", "green", "black",
                                                    "purple"))  # fmt: skip
    body = pad(0.06, 0.036, 0.018, 0.014)
    button = ellipsoid(0.022, 0.02, 0.01, 16, 8).move(-0.012, 0, 0.018)
    loop = tube(smooth([(0.029, 0.003, 0.009), (0.06, 0.014, 0.002), (0.085, 0, 0.002),
                        (0.06, -0.014, 0.002),
                        (0.029, -0.003, 0.009)], 5), 0.0016, 6)  # fmt: skip
    return settle([(body, look.surface(color, "plastic")),
                   (button, surfaces.plain(look.own_color("white", "yellow", "black"))),
                   (loop, surfaces.plain((40, 40, 44)))], 0.0, hulls=[[0],
                       [1]]).scale(k)  # fmt: skip


DOG_COLLAR_STEEL = (196, 200, 206)


@category("dog_bone", size=(0.14, 0.064, 0.03), mass=0.06, material="ceramic", aliases=("bone",
          "chew bone", "dog treat", "dog biscuit", "chew toy", "rawhide chew", "dog chew",
          "rawhide", "treat"), themes=("living",), colors=("ivory",), state="lying")  # fmt: skip
def dog_bone(look: Look) -> Shape:
    """A bone with two knobs at each end."""
    color = look.color("ivory", "white", "tan", "beige", "brown")
    k = look.between(0.85, 1.25)
    shaft = straight((-0.045, 0, 0.0125), (0.045, 0, 0.0125), 0.0105, 14)
    knobs = [ball(0.034, 0.034, 0.03, (sx * 0.05, sy * 0.0135, 0.0135), 14) for sx in (-1, 1)
             for sy in (-1, 1)]  # fmt: skip
    skin = surfaces.speckles(look.rng, color, 7)
    return put_down(
        [(join([shaft, *knobs]), skin)], shaft, join(knobs[:2]), join(knobs[2:]), factor=k
    )


@category("dog_collar", size=(0.113, 0.145, 0.024), mass=0.05, material="leather", assembled=True,
          aliases=("collar", "cat collar", "pet collar", "dog harness", "harness", "cat harness"),
          themes=("living",), colors=("red", "blue"), state="lying")  # fmt: skip
def dog_collar(look: Look) -> Shape:
    """A pet collar lying in a ring: a strap with a buckle and a tag."""
    color = look.color("red", "blue", "brown", "black", "pink", "green", "teal")
    r, w = look.between(0.045, 0.062), 0.018
    strap = lathe(
        [(r - 0.0012, 0), (r + 0.0012, 0), (r + 0.0012, w), (r - 0.0012, w)], 40, loop=True
    )
    studs = [ball(0.006, 0.006, 0.006, ((r + 0.001) * np.cos(a), (r + 0.001) * np.sin(a), w / 2), 8)
             for a in 2 * np.pi * np.arange(14) / 14]  # fmt: skip
    buckle = box(0.02, 0.004, w + 0.006).move(0, r + 0.001, 0)
    ring = torus(0.005, 0.0011, 14, 6).move(0, -r - 0.006, 0.004)
    tag = cylinder(0.012, 0.0018, 22).move(0, -r - 0.02, 0.0005)
    metal = surfaces.plain((206, 172, 96) if look.chance(0.5) else DOG_COLLAR_STEEL)
    wall = ring_parts([(r + 0.0015, 0), (r + 0.0015, w)], [(r - 0.0015, w), (r - 0.0015, 0)], 12)
    return shape([(strap, leather(look.rng, color)), (join([*studs, buckle, ring, tag]), metal)],
                 [*wall, hull_of(tag)])  # fmt: skip


@category("leash", size=(0.15, 0.16, 0.018), mass=0.12, material="fabric", assembled=True,
          aliases=("dog leash", "dog lead", "pet leash"), themes=("living",),
          colors=("red", "blue"), state="lying coiled")  # fmt: skip
def leash(look: Look) -> Shape:
    """A coiled dog lead with a clip at one end and a loop at the other."""
    color = look.color("red", "blue", "black", "brown", "green", "orange", "pink")
    a = np.linspace(0, 2 * np.pi * 3, 80)
    r = 0.045 + 0.009 * a / (2 * np.pi)
    coil = tube(
        np.column_stack([r * np.cos(a), r * np.sin(a), np.full(80, 0.0035) + 0.0005 * a]), 0.0038, 7
    )
    end = np.array([r[-1], 0, 0.0035 + 0.0005 * a[-1]])
    clip = [
        straight(tuple(end), tuple(end + np.array([0.004, 0.02, -0.006])), 0.0042, 8),
        torus(0.0085, 0.002, 16, 6).scale(1, 1.5, 1).move(end[0] + 0.004, end[1] + 0.03, 0.0045),
    ]
    loop = rod([(0.045, 0, 0.0036), (0.03, -0.03, 0.0036), (-0.01, -0.028, 0.0036),
                (-0.012, 0.006, 0.0036), (0.02, 0.012, 0.0036), (0.044, 0.002, 0.0036)], 0.0036,
               7)  # fmt: skip
    return put_down([(join([coil, loop]), surfaces.fabric(look.rng, color)),
                    (join(clip), surfaces.plain((206, 208, 212)))], coil, join(clip),
                   factor=look.between(0.9, 1.15))  # fmt: skip


@category("cat_toy", size=(0.168, 0.0472, 0.046), mass=0.02, material="fabric",
          aliases=("toy mouse", "cat toy mouse", "pet toy", "cloth mouse", "pet mouse"),
          themes=("living", "toys"), colors=("gray",))  # fmt: skip
def cat_toy(look: Look) -> Shape:
    """A cat toy: a cloth mouse with a cord as its tail."""
    color = look.color("gray", "white", "pink", "blue", "brown", "red")
    k = look.between(0.9, 1.3)
    body = ball(0.07, 0.036, 0.034, (0, 0, 0.0155), 18)
    head = lathe([(0, 0), (0.0155, 0), (0.012, 0.014), (0.003, 0.026), (0, 0.027)], 14)
    head = head.turn(1, -np.pi / 2).move(-0.022, 0, 0.0155)
    ears = [ball(0.005, 0.02, 0.02, (-0.018, s * 0.012, 0.032), 10) for s in (-1, 1)]
    eyes = [ball(0.004, 0.004, 0.004, (-0.036, s * 0.0075, 0.021), 8) for s in (-1, 1)]
    nose = ball(0.006, 0.006, 0.006, (-0.0495, 0, 0.0155), 8)
    tail = rod([(0.034, 0, 0.014), (0.055, 0.006, 0.006), (0.08, -0.006, 0.002),
                (0.1, 0.004, 0.002)], 0.0015, 6)  # fmt: skip
    fur = surfaces.scratches(look.rng, color, tint_color(color, 0.8), 90)
    return put_down([(join([body, head]), fur), (join([*ears, tail, nose]),
                                                 surfaces.plain((236, 160, 170))),
                     (join(eyes), surfaces.plain((30, 30, 32)))], body, head, tail,
                    factor=k)  # fmt: skip


@category("fish_bowl", size=(0.165, 0.165, 0.135), mass=2.0, material="glass",
          aliases=("fishbowl", "goldfish bowl"), themes=("living",), roles=("round",),
          colors=("sky",))  # fmt: skip
def fish_bowl(look: Look) -> Shape:
    """A round fish bowl with a glass rim: goldfish in coloured water, and gravel at the bottom."""
    color = look.color("sky", "blue", "teal", "cyan", "turquoise")
    r = look.between(0.07, 0.09)
    water = lathe([(0, 0), (0.55 * r, 0), (0.9 * r, 0.4 * r), (r, 0.85 * r), (0.9 * r, 1.3 * r),
                   (0, 1.3 * r)], 30)  # fmt: skip
    neck = lathe([(0.86 * r, 1.28 * r), (0.9 * r, 1.28 * r), (0.72 * r, 1.55 * r),
                  (0.8 * r, 1.66 * r), (0.75 * r, 1.67 * r), (0.67 * r, 1.55 * r)], 30,
                 loop=True)  # fmt: skip
    sides: list[Solid] = []
    tails: list[Solid] = []
    for a, z in ((-1.9, 0.85), (-0.7, 1.0), (1.4, 0.7)):
        fish = ball(0.034, 0.012, 0.02, (0, 0, 0), 12)
        tail = prism([(0.012, 0), (0.026, -0.011), (0.026, 0.011)], -0.003, 0.003).turn(
            0, np.pi / 2
        )
        for solid, group in ((fish, sides), (tail, tails)):
            group.append(
                solid.turn(2, a + np.pi / 2).move(0.98 * r * np.cos(a), 0.98 * r * np.sin(a), z * r)
            )
    top = [ball(0.036, 0.018, 0.006, (0.2 * r, -0.25 * r, 1.3 * r), 12)]
    gravel = lathe([(0, 0.0), (0.56 * r, 0.0), (0.72 * r, 0.16 * r), (0, 0.17 * r)], 28)
    gravel = gravel.scale(1.02, 1.02, 1)
    pale = tint_color(color, 1.45)
    return put_down([(water, surfaces.gradient(tint_color(color, 1.1), pale, look.rng)),
                    (neck, surfaces.plain((226, 238, 244))),
                    (join([*sides, *tails, *top]), surfaces.plain((240, 130, 40))),
                    (gravel, surfaces.spots(look.rng, (226, 206, 170), (150, 120, 90), 0.3))],
                   water, neck)  # fmt: skip


CATEGORIES = (
    Category("cat_food_tin", tin(("CAT", "MIAOW", "TUNA", "KITTY"), 0.038, 0.05, ("purple",
             "orange", "teal", "red", "yellow"), "cat"), size=(0.0783, 0.0783, 0.0528), mass=0.2,
             material="metal",
             aliases=("tin of cat food", "can of cat food", "cat food can", "wet cat food"),
             themes=("living",), roles=("round",), colors=("purple",)),
    Category("dog_food_tin", tin(("DOG", "WOOF", "BEEF", "CHUM"), 0.038, 0.1, ("red", "brown",
             "blue", "green", "yellow"), "dog"), size=(0.0778, 0.0778, 0.102), mass=0.42,
             material="metal", aliases=("tin of dog food", "can of dog food", "dog food can",
             "wet dog food", "pet food tin", "pet food can"), themes=("living",), roles=("round",),
             colors=("red",)),
    Category("fish_food_tub", tin(("FLAKES", "FISH", "AQUA"), 0.03, 0.09, ("yellow", "blue",
             "orange", "teal"), "fish"), size=(0.0627, 0.0627, 0.0929), mass=0.06,
             material="plastic", aliases=("fish food", "tub of fish food", "fish flake",
             "mealworm tub", "tub of mealworms", "fish food container"), themes=("living",),
             roles=("round",), colors=("yellow",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
