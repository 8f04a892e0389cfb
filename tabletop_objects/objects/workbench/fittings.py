"""Objects of the ``workbench`` theme: fittings."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import metal, plastic, shine, steel, wood
from ...kit.outlines import arc
from ...kit.parts import box_part, flat_foot, hull_of
from ...kit.primitives import (
    at_block,
    at_box,
    disc,
    drum,
    facing,
    lay_down,
    rod,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain, tint_color


@category("tap", size=(0.063, 0.156, 0.136), mass=0.7, material="metal",
          aliases=("faucet", "water tap", "bathroom tap", "kitchen tap", "sink tap", "mixer tap"),
          themes=("workbench",), roles=("tall",), colors=("silver",))  # fmt: skip
def tap(look: Look) -> Shape:
    """An upright tap with a body, a curved spout and a handle."""
    color = look.color("silver", "silver", "gold", "black", "copper")
    k = look.between(0.85, 1.1)
    base = standing((0.028, 0), (0.028, 0.006), (0.018, 0.014), (0.0165, 0.1), (0.019, 0.106),
                    (0.017, 0.115), sides=24)  # fmt: skip
    spout = rod([(0, 0, 0.085), (0, -0.04, 0.12), (0, -0.09, 0.115), (0, -0.105, 0.082)],
                [0.013, 0.012, 0.011, 0.0115], 14)  # fmt: skip
    tip = drum(0.0132, 0.01, (0, -0.106, 0.075), sides=18)
    if look.chance(0.5):
        handle = [rod([(-0.036, 0, 0.127), (0.036, 0, 0.127)], 0.0075, 10),
                  rod([(0, -0.036, 0.127), (0, 0.036, 0.127)], 0.0075, 10)]  # fmt: skip
    else:
        handle = [rod([(0, 0, 0.12), (0, 0.05, 0.145)], [0.009, 0.006], 10)]
    stem, dot = drum(0.009, 0.018, (0, 0, 0.112)), drum(0.006, 0.003, (0, 0, 0.132))
    foot = at_box(0.05, 0.1, 0.003, (0, -0.02, 0))
    return put_down([(join([base, spout, tip, *handle, stem]), steel(look, color)),
                     (dot, plain(look.pick([(60, 110, 200), (210, 60, 50)]))),
                     (foot, steel(look, tint_color(color, 0.9)))], base, foot, spout, join(handle),
                    factor=k)  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("hasp", size=(0.118, 0.0353, 0.0146), mass=0.08, material="metal",
          aliases=("hasp and staple", "lock hasp", "toggle latch", "clasp"), themes=("workbench",),
          colors=("silver",), state="lying")  # fmt: skip
@from_pieces(bodies=3)
def hasp(look: Look) -> Pieces:
    """A hasp lying flat: a plate with four screw holes, a hinge and a slotted flap on a staple."""
    steel = metal(look, "silver", "black", "brass")
    left = at_block(0.035, 0.034, 0.002, 0.003, (-0.045, 0, 0))
    flap = at_block(0.075, 0.03, 0.003, 0.008, (0.014, 0, 0.002))
    hinge = straight((-0.026, -0.017, 0.003), (-0.026, 0.017, 0.003), 0.0032, 10)
    loop = (tube([(*p, 0.0) for p in arc((0, 0), 0.008, 0, np.pi, 10)], 0.002,
                 6).turn(0, np.pi / 2).turn(2, np.pi / 2).move(0.034, 0, 0.004))  # fmt: skip
    slot = at_box(0.006, 0.018, 0.0008, (0.034, 0, 0.0046))
    holes = [disc(0.0028, 0.0008, (x, y, 0.0018), sides=10) for x in (-0.054, -0.038)
             for y in (-0.01, 0.01)]  # fmt: skip
    return [(left, steel), (flap, steel), (hinge, steel), (loop, shine(look)),
            (join([slot, *holes]), BLACK)]  # fmt: skip


@category("castor", size=(0.06, 0.05, 0.072), mass=0.12, material="metal",
          aliases=("caster", "castor wheel", "caster wheel", "furniture wheel", "furniture castor"),
          themes=("workbench",), colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def castor(look: Look) -> Pieces:
    """A castor standing on its wheel, with a fork and a plate on top."""
    steel = metal(look, "silver", "gray", "black")
    wheel = (lathe([(0, 0), (0.02, 0), (0.025, 0.005), (0.025, 0.015), (0.02, 0.02), (0, 0.02)],
                   26).turn(0, np.pi / 2).move(0.012, 0.01, 0.024))  # fmt: skip
    fork = [at_block(0.02, 0.003, 0.045, 0.001, (0.008, s * 0.0135, 0.02)) for s in (-1, 1)]
    bridge = at_block(0.034, 0.032, 0.006, 0.004, (0.003, 0, 0.06))
    top = at_block(0.05, 0.05, 0.004, 0.004, (0, 0, 0.068))
    stem = disc(0.011, 0.01, (0, 0, 0.06))
    foot = at_box(0.03, 0.02, 0.003, (0.012, 0, 0))
    return [(wheel, BLACK), (foot, BLACK), (join(fork), steel), (join([bridge, stem]), steel),
            (top, steel)]  # fmt: skip


@category("door_knob", size=(0.058, 0.058, 0.06), mass=0.2, material="metal",
          aliases=("round knob", "furniture knob"), themes=("workbench",), colors=("brass",),
          state="lying")  # fmt: skip
@from_pieces()
def door_knob(look: Look) -> Pieces:
    """A round door knob standing on its back plate."""
    steel = metal(look, "brass", "silver", "gold", "white", "black")
    return [(standing((0.029, 0), (0.028, 0.005), (0.013, 0.009), (0.011, 0.024), (0.02, 0.03),
                      (0.027, 0.042), (0.026, 0.052), (0.014, 0.06), sides=30), steel)]  # fmt: skip


@category("door_handle", size=(0.139, 0.202, 0.0495), mass=0.35, material="metal",
          aliases=("door lever",), themes=("workbench",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces(bodies=3)
def door_handle(look: Look) -> Pieces:
    """A lever handle on a long plate with a keyhole, lying flat."""
    steel = metal(look, "silver", "brass", "black")
    base = at_block(0.045, 0.2, 0.006, 0.012)
    neck = disc(0.012, 0.035, (0, 0.045, 0.005))
    lever = rod([(0, 0.045, 0.036), (-0.03, 0.045, 0.04), (-0.115, 0.042, 0.037)],
                [0.0095, 0.0095, 0.007], 10)  # fmt: skip
    hole = [disc(0.005, 0.0008, (0, -0.03, 0.0056)), at_box(0.004, 0.012, 0.0008,
                                                            (0, -0.036, 0.0056))]  # fmt: skip
    return [(base, steel), (neck, steel), (lever, steel), (join(hole), BLACK)]


@category("drawer_pull", size=(0.128, 0.018, 0.034), mass=0.06, material="metal",
          aliases=("drawer handle", "cabinet handle", "cupboard handle", "pull handle"),
          themes=("workbench",), colors=("silver",), state="lying")  # fmt: skip
@from_pieces(foot=0.05)
def drawer_pull(look: Look) -> Pieces:
    """A drawer pull: a curved metal bar on two round feet."""
    steel = metal(look, "silver", "brass", "black", "gold")
    bar = rod([(-0.055, 0, 0.0), (-0.053, 0, 0.02), (-0.035, 0, 0.028), (0.035, 0, 0.028),
               (0.053, 0, 0.02), (0.055, 0, 0.0)], 0.0055, 10, 5)  # fmt: skip
    feet = [disc(0.009, 0.004, (s * 0.055, 0, 0)) for s in (-1, 1)]
    return [(bar, steel), (feet[0], steel), (feet[1], steel)]


@category("furniture_leg", size=(0.32, 0.044, 0.043), mass=0.2, material="wood",
          aliases=("chair leg", "sofa leg", "turned leg", "table leg spare"), themes=("workbench",),
          colors=("wooden",), state="lying")  # fmt: skip
@from_pieces(foot=0.08, bodies=1)
def furniture_leg(look: Look) -> Pieces:
    """A turned wooden leg lying flat, with a bolt at its thick end."""
    tile = wood(look, "wooden", "brown", "tan")
    leg = spindle((-0.15, 0.013), (-0.13, 0.012), (0.05, 0.02), (0.09, 0.022), (0.1, 0.018),
                  (0.11, 0.022), (0.14, 0.022), z=0.0215)  # fmt: skip
    return [(leg, tile), (spindle((0.14, 0.004), (0.165, 0.004), z=0.0215), shine(look)),
            (spindle((-0.155, 0.008), (-0.149, 0.011), z=0.0215), BLACK)]  # fmt: skip


@category("latch", size=(0.102, 0.03, 0.022), mass=0.08, material="metal",
          aliases=("barrel bolt", "slide bolt", "door bolt", "door latch", "door lock bolt"),
          themes=("workbench",), colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def latch(look: Look) -> Pieces:
    """A barrel bolt: a plate with two loops and a sliding bolt with a knob."""
    steel = metal(look, "silver", "brass", "black", "gray")
    base = at_block(0.08, 0.03, 0.002, 0.004)
    keep = at_block(0.016, 0.03, 0.002, 0.003, (0.054, 0, 0))
    loops = [at_block(0.01, 0.02, 0.012, 0.004, (x, 0, 0.001)) for x in (-0.025, 0.022, 0.054)]
    bolt = spindle((-0.036, 0.004), (0.066, 0.004), z=0.0065)
    knob = standing((0.003, 0.006), (0.003, 0.016), (0.005, 0.018), (0.005, 0.022), sides=12).move(
        x=-0.004
    )
    screws = [disc(0.0028, 0.001, (x, y, 0.0018), sides=10) for x in (-0.036, 0.036)
              for y in (-0.01, 0.01)]  # fmt: skip
    return [(base, steel), (keep, steel), *((p, steel) for p in loops), (bolt, shine(look)),
            (knob, steel), (join(screws), shine(look))]  # fmt: skip


@category("magnet_catch", size=(0.065, 0.0175, 0.014), mass=0.02, material="plastic",
          aliases=("magnetic catch", "cabinet catch", "door magnet"), themes=("workbench",),
          colors=("white",), state="lying")  # fmt: skip
@from_pieces(bodies=2)
def magnet_catch(look: Look) -> Pieces:
    """A magnetic catch: a plastic block with a lug at each end and two metal strips in front."""
    body = at_block(0.045, 0.016, 0.014, 0.003)
    ears = at_block(0.065, 0.012, 0.004, 0.005)
    face = [at_box(0.034, 0.002, 0.003, (0, -0.0085, z)) for z in (0.003, 0.009)]
    return [(body, plastic(look, "white", "brown", "black")), (ears, plastic(look, "white", "brown",
                                                                             "black")),
            (join(face), shine(look))]  # fmt: skip


@category("padlock", size=(0.044, 0.02, 0.07), mass=0.14, material="metal", assembled=True,
          aliases=("lock", "combination lock", "pad lock", "d-lock", "bike lock", "key safe"),
          themes=("workbench",), colors=("brass", "silver"))  # fmt: skip
def padlock(look: Look) -> Shape:
    """An upright padlock: a body with a keyhole or number wheels, and a shackle."""
    k = look.between(0.85, 1.25)
    color = look.color("brass", "gold", "silver", "black", "red", "blue", "charcoal")
    metal = look.surface(color, "metal")
    x, y, h = 0.042 * k, 0.018 * k, 0.036 * k
    body = block(x, y, h, 0.005, 0.002)
    a = np.linspace(0, np.pi, 11)
    bow = np.column_stack([0.0125 * k * np.cos(a), 0 * a, h + 0.018 * k + 0.0125 * k * np.sin(a)])
    path = np.concatenate([[(0.0125 * k, 0, h - 0.002)], bow, [(-0.0125 * k, 0, h - 0.002)]])
    shackle = tube(path, 0.0036 * k, 10)
    pieces = [(body, metal), (shackle, surfaces.brushed_metal(look.rng, (200, 203, 208)))]
    if look.chance(0.65):
        plate = facing(cylinder(0.0075 * k, 0.001, 22)).move(y=-y / 2, z=0.42 * h)
        hole = [facing(cylinder(0.0022 * k, 0.0012, 12)).move(y=-y / 2 - 0.0006, z=0.46 * h),
                box(0.0018 * k, 0.0012, 0.006 * k).move(y=-y / 2 - 0.001, z=0.28 * h)]  # fmt: skip
        pieces += [(plate, surfaces.plain(tint_color(color, 1.25))),
                   (join(hole), surfaces.plain((26, 26, 28)))]  # fmt: skip
    else:
        for n in range(3):
            wheel = prints.canvas(32, 48, (236, 236, 232))
            prints.write(
                wheel, str(int(look.rng.integers(10))), 0.5, 0.5, 0.55, (30, 30, 34), bold=True
            )
            pieces.append((box(0.008 * k, 0.002, 0.014 * k).move((n - 1) * 0.011 * k, -y / 2
                                                                 - 0.0006, 0.3 * h),
                           wheel))  # fmt: skip
    return shape(pieces, [box_part(x, y, h), hull_of(shackle)])


def _holes(places: list[tuple[float, float]], z: float, r: float = 0.003) -> Solid:
    return join([cylinder(r, 0.0005, 14).move(x, y, z - 0.0001) for x, y in places])


@category("hinge", size=(0.063, 0.074, 0.0083), mass=0.05, material="metal",
          aliases=("door hinge", "butt hinge", "cabinet hinge"), themes=("workbench",),
          roles=("flat",), colors=("brass", "silver"))  # fmt: skip
def hinge(look: Look) -> Shape:
    """An open door hinge lying flat: two plates and a knuckle."""
    k = look.between(0.85, 1.12)
    metal = look.surface(look.color(*METALS), "metal")
    long, wide, h = 0.075 * k, 0.03 * k, 0.0026
    plates = [block(wide, long, h, 0.004).move(x=s * (wide / 2 + 0.002)) for s in (-1, 1)]
    r = 0.0042 * k
    knuckle = [cylinder(r, long / 5 - 0.0006, 16).turn(0, -np.pi / 2).move(
        y=-long / 2 + n * long / 5, z=r) for n in range(5)]  # fmt: skip
    spots = [(s * x * wide, y * long) for s in (-1, 1) for x, y in ((0.6, -0.34), (0.75, 0.0),
                                                                    (0.6, 0.34))]  # fmt: skip
    return shape([(join([*plates, *knuckle]), metal), (_holes(spots, h), surfaces.plain((36, 34,
                                                                                         34)))],
                 [*(hull_of(s) for s in plates), hull_of(*knuckle)])  # fmt: skip


@category("bracket", size=(0.06, 0.022, 0.06), mass=0.05, material="metal", assembled=True,
          aliases=("angle bracket", "l bracket", "corner bracket", "shelf bracket", "metal bracket",
          "stabiliser"), themes=("workbench",), colors=("silver",))  # fmt: skip
def bracket(look: Look) -> Shape:
    """An angle bracket with one arm flat on the table and the other upright."""
    k = look.between(0.85, 1.15)
    metal = look.surface(look.color(*METALS, "white", "black"), "metal")
    a, wide, t = 0.06 * k, 0.022 * k, 0.0028
    foot = box(a, wide, t)
    wall = box(t, wide, a).move(x=-a / 2 + t / 2)
    dark = surfaces.plain((36, 34, 34))
    spots = _holes([(-0.012 * k, 0), (0.016 * k, 0)], t)
    side = _holes([(0.02 * k, 0), (0.046 * k, 0)], 0.0).turn(1, -np.pi / 2).scale(1, 1, 1)
    side = side.move(x=-a / 2 + t + 0.0003)
    rib = prism(np.array([(0, 0), (0.018, 0), (0, 0.018)]) * k, -0.003 * k, 0.003 * k)
    rib = rib.turn(0, np.pi / 2).move(x=-a / 2 + t, z=t)
    return shape([(join([foot, wall, rib]), metal), (join([spots, side]), dark)],
                 [hull_of(foot), hull_of(wall)])  # fmt: skip


@category("wall_hook", size=(0.026, 0.075, 0.046), mass=0.05, material="metal", assembled=True,
          aliases=("hook", "coat hook", "metal hook", "towel hook", "key hook",
          "picture hanging kit", "wall peg"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
def wall_hook(look: Look) -> Shape:
    """A coat hook lying on its plate with the hook up."""
    k = look.between(0.85, 1.15)
    metal = look.surface(look.color(*METALS, "black", "white"), "metal")
    plate = block(0.026 * k, 0.075 * k, 0.005 * k, 0.008, 0.001)
    way = np.array([(0, -0.012, 0.004), (0, -0.018, 0.02), (0, -0.01, 0.036), (0, 0.008, 0.04),
                    (0, 0.022, 0.034)]) * k  # fmt: skip
    arm = tube(way, np.array([0.006, 0.0052, 0.005, 0.005, 0.0045]) * k, 10)
    tip = lathe([(0, -0.007 * k), (0.0055 * k, -0.004 * k), (0.007 * k, 0.0),
                 (0.0055 * k, 0.004 * k), (0, 0.007 * k)], 14).move(*way[-1])  # fmt: skip
    dark = surfaces.plain((40, 38, 38))
    return shape([(join([plate, arm, tip]), metal), (_holes([(0, 0.03 * k), (0, -0.031 * k)],
                                                            0.005 * k), dark)],
                 [hull_of(plate), hull_of(arm), hull_of(tip)])  # fmt: skip


METALS = ("silver", "silver", "brass", "charcoal", "gray", "copper")


@category("pipe_fitting", size=(0.062, 0.052, 0.03), mass=0.08, material="metal", assembled=True,
          aliases=("pipe elbow", "elbow joint", "pipe connector", "pipe joint", "elbow pipe",
          "pipe tee", "u-bend", "u bend", "hose coupling", "hose connector"), themes=("workbench",),
          colors=("copper",))  # fmt: skip
def pipe_fitting(look: Look) -> Shape:
    """An elbow or tee pipe fitting, lying flat."""
    k = look.between(0.85, 1.15)
    color = look.color("copper", "silver", "white", "brass", "charcoal", "gray")
    r = 0.013 * k
    tile = look.surface(color, "metal")
    if look.chance(0.6):
        way = arc((0.024, 0.024), 0.024, np.pi, 1.5 * np.pi, 8)
        way = np.concatenate([[(0, 0.036)], way, [(0.036, 0)]]) * k
    else:
        way = np.array([(-0.036, 0), (0.036, 0)]) * k
    path = np.column_stack([way, np.full(len(way), 1.16 * r)])
    pieces = [tube(path, r, 20)]
    ends = [(path[0], path[1]), (path[-1], path[-2])]
    if len(way) == 2:
        stem = np.array([(0, 0, 1.16 * r), (0, 0.036 * k, 1.16 * r)])
        pieces.append(tube(stem, r, 20))
        ends.append((stem[1], stem[0]))
    holes = []
    for tip, inner in ends:
        way_out = (tip - inner) / np.linalg.norm(tip - inner)
        pieces.append(tube([tip - 0.012 * k * way_out, tip], 1.16 * r, 20))
        holes.append(tube([tip - 0.002 * way_out, tip + 0.0004 * way_out], 0.84 * r, 20))
    hulls = [hull_of(s) for s in pieces[1:]]
    thirds = len(path) // 2 + 1
    hulls += [hull_of(tube(path[:thirds], r, 12)), hull_of(tube(path[thirds - 1 :], r, 12))] if (
        len(path) > 2) else [hull_of(pieces[0])]  # fmt: skip
    return shape([(join(pieces), tile), (join(holes), surfaces.plain((24, 24, 26)))], hulls)


@category("valve", size=(0.079, 0.0475, 0.07), mass=0.2, material="metal", assembled=True,
          aliases=("gate valve", "water valve", "stopcock", "shutoff valve"), themes=("workbench",),
          colors=("brass",))  # fmt: skip
def valve(look: Look) -> Shape:
    """A valve lying flat: a short pipe with a nut at each end and a handwheel on top."""
    k = look.between(0.85, 1.12)
    color = look.color("brass", "brass", "silver", "copper")
    wheel = look.own_color("red", "blue", "red", "green")
    r = 0.0125 * k
    z = 1.35 * r
    body = lay_down(cylinder(r, 0.07 * k, 20), -0.035 * k, z)
    nuts = [lay_down(cylinder(1.42 * r, 0.016 * k, 6).turn(2, np.pi / 6), x * k, z)
            for x in (-0.04, 0.024)]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s in nuts)
    neck = cylinder(0.011 * k, 0.03 * k, 18, top=0.007 * k).move(z=z)
    stem = cylinder(0.003 * k, 0.03 * k, 10).move(z=z + 0.028 * k)
    top = z + 0.05 * k
    rim = torus(0.021 * k, 0.0034 * k, 28, 8).move(z=top)
    spokes = [box(0.04 * k, 0.004 * k, 0.003 * k).turn(2, a).move(z=top - 0.0015 * k)
              for a in (0.3, 0.3 + np.pi / 2)]  # fmt: skip
    solids = [s.move(z=-low) for s in (body, *nuts, neck, stem, rim, *spokes)]
    metal = look.surface(color, "metal")
    return shape([(join(solids[:5]), metal), (join(solids[5:]), surfaces.speckles(
                  look.rng, wheel, 4, 32))],
                 [hull_of(solids[0]), *(flat_foot(s.vertices, 0.15) for s in solids[1:3]),
                     hull_of(solids[3]), hull_of(solids[4]),
                     hull_of(solids[5])])  # fmt: skip


@category("grommet", size=(0.032, 0.032, 0.011), mass=0.004, material="rubber",
          aliases=("cable grommet", "rubber grommet", "cable gland", "eyelet"),
          themes=("workbench",), colors=("black",), state="lying")  # fmt: skip
@from_pieces()
def grommet(look: Look) -> Pieces:
    """A grommet lying flat: a ring with a groove around its outside."""
    tile = plastic(look, "black", "gray", "white", "charcoal")
    body = lathe([(0.008, 0), (0.015, 0), (0.016, 0.003), (0.013, 0.004), (0.013, 0.007),
                  (0.016, 0.008), (0.015, 0.011), (0.008, 0.011)], 28, loop=True)  # fmt: skip
    return [(body, tile)]
