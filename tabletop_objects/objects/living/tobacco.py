"""Objects of the ``living`` theme: tobacco products."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import box_part, hull_above, hull_of, hull_part, open_vessel
from ...kit.primitives import ball, limb, rod, straight
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus
from ...kit.surfaces import Look, plain, tint_color


def _thirds(count: int) -> list[tuple[int, int]]:
    """Return the index ranges that split the ``count`` points of a hose into four equal parts."""
    step = count // 4
    return [(n * step, (n + 1) * step if n < 3 else count) for n in range(4)]


@category("hookah", size=(0.23, 0.171, 0.348), mass=1.5, material="metal", assembled=True,
          aliases=("shisha", "water pipe", "shisha pipe", "nargile"), themes=("living",),
          roles=("tall",), colors=("blue",))  # fmt: skip
def hookah(look: Look) -> Shape:
    """A hookah: a glass vase, a brass stem, a clay bowl and a hose."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "green", "purple", "red", "amber")
    vase = lathe(np.maximum(smooth([(0, 0), (0.055, 0), (0.064, 0.012), (0.06, 0.05), (0.03, 0.1),
                 (0.02, 0.14), (0.023, 0.16), (0, 0.162)], 3), 0), 28)  # fmt: skip
    stem = lathe(np.maximum(smooth([(0, 0.155), (0.018, 0.155), (0.012, 0.18), (0.016, 0.2), (0.009,
                 0.23), (0.014, 0.27), (0.008, 0.3), (0, 0.302)], 3), 0), 20)  # fmt: skip
    tray = cylinder(0.045, 0.004, 28, bevel=0.001).move(z=0.295)
    bowl = lathe([(0, 0.298), (0.012, 0.298), (0.024, 0.32), (0.027, 0.345), (0.022, 0.345), (0,
                  0.335)], 22)  # fmt: skip
    coal = [box(0.013, 0.013, 0.011).turn(2, n).move(0.008 * np.cos(2 * n), 0.008 * np.sin(2 * n),
            0.34) for n in range(3)]  # fmt: skip
    hose = limb([(0.012, 0, 0.2), (0.06, -0.01, 0.19), (0.105, -0.03, 0.1), (0.11, -0.07, 0.012),
                 (0.03, -0.1, 0.008), (-0.06, -0.095, 0.008)], [0.0065] * 6, 8)  # fmt: skip
    tip = straight((-0.05, -0.0955, 0.008), (-0.11, -0.09, 0.008), [0.0075, 0.004])
    brass = surfaces.brushed_metal(look.rng, (206, 166, 82))
    return shape([(vase, surfaces.gradient(tint_color(color, 0.7), tint_color(color, 1.2),
                                           look.rng)), (join([stem, tray, tip]), brass),
                  (bowl, surfaces.plain((160, 90, 60))), (join(coal), surfaces.plain((60, 40, 36))),
                  (hose, surfaces.stripes([color, tint_color(color, 0.6)], 14))],
                 [hull_of(vase), hull_of(stem, bowl), hull_of(tray), hull_above(tip),
                  *(hull_part(np.maximum(hose.vertices[a:b], [-9, -9, 0])) for a,
                    b in _thirds(len(hose.vertices)))]).scale(k)  # fmt: skip


@category("cigar_cutter", size=(0.099, 0.0373, 0.00592), mass=0.06, material="metal",
          aliases=("guillotine cutter",), themes=("living",), roles=("flat",), colors=("silver",),
          state="lying flat")  # fmt: skip
def cigar_cutter(look: Look) -> Shape:
    """A guillotine cigar cutter: a plate with a hole and a finger ring at each end."""
    k, color = look.between(0.9, 1.15), look.color("silver", "black", "gold")
    plate = prism(rectangle(0.05, 0.036, 0.012), 0, 0.005).scale(k, k, 1)
    rings = [torus(0.011 * k, 0.003, 22, 7).move(s * 0.034 * k, 0, 0.003) for s in (-1, 1)]
    hole = cylinder(0.0115 * k, 0.0005, 26).move(z=0.0048)
    blade = prism(arc((0, 0), 0.0115 * k, 0.3, 2.8, 10), 0.0052, 0.0056)
    metal = look.surface(color, "steel")
    return shape([(join([plate, *rings]), metal), (hole, surfaces.plain((20, 20, 22))),
                  (blade, surfaces.plain((226, 228, 232)))], [hull_of(plate),
                      *[hull_of(r) for r in rings]])  # fmt: skip


@category("cigarette_packet", size=(0.055, 0.0315, 0.0882), mass=0.025, material="paper",
          aliases=("pack of cigarettes", "packet of cigarettes", "cigarette pack", "cigarette box",
          "box of cigarettes", "cigarettes"), themes=("living",), colors=("red",))  # fmt: skip
def cigarette_packet(look: Look) -> Shape:
    """A flip-top packet of cigarettes, closed or open with visible filters."""
    color = look.color("red", "blue", "gold", "green", "white", "navy")
    x, y, h = 0.055, look.between(0.021, 0.024), look.between(0.084, 0.09)
    image = prints.canvas(96, 150, (248, 246, 242) if sum(color) < 600 else (40, 60, 120))
    prints.polygon(image, [(0, 0), (1, 0), (1, 0.3), (0.5, 0.5), (0, 0.3)], color)
    prints.write(image, look.pick(["LUCKY", "ROYAL", "GOLD", "WEST", "PRIME"]), 0.5, 0.64, 0.12,
                 tint_color(color, 0.8), bold=True)  # fmt: skip
    prints.fill(image, 0.06, 0.8, 0.88, 0.14, (30, 30, 32))
    skin = surfaces.plain(
        (float(image[100, 4, 0]), float(image[100, 4, 1]), float(image[100, 4, 2]))
    )
    panel = box(x, 0.0005, h)
    if look.chance(0.5):
        pieces = [(box(x, y, h), skin), (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image)]
        return shape(pieces, [box_part(x, y, h)])
    low = 0.8 * h
    lid = box(x, y, 0.2 * h).turn(0, -1.1).move(y=0.9 * y, z=low + 0.004)
    tips = [cylinder(0.0037, 0.01, 8).move((i - 3) * 0.0074, (j - 0.5) * 0.0085 - 0.001, low)
            for i in range(7) for j in range(2)]  # fmt: skip
    front = box(x, 0.0005, low)
    return shape([(box(x, y, low), skin), (front.move(y=-y / 2), image[30:]),
                  (lid, surfaces.plain(color)),
                  (join(tips), surfaces.plain((216, 150, 84)))],
                 [box_part(x, y, low), hull_of(lid), hull_of(*tips)])  # fmt: skip


@category("cigarette_case", size=(0.0995, 0.0816, 0.0162), mass=0.12, material="metal",
          aliases=("cigar case", "metal card case", "card case"), themes=("living",),
          roles=("flat",), colors=("silver",), state="lying flat")  # fmt: skip
def cigarette_case(look: Look) -> Shape:
    """A slim metal cigarette case with rounded corners and an engraved band, lying flat."""
    k, color = look.between(0.92, 1.08), look.color("silver", "gold", "black", "bronze")
    body = block(0.1 * k, 0.08 * k, 0.016, 0.01, 0.003)
    image = surfaces.fit(surfaces.brushed_metal(look.rng, color), 128, 160).copy()
    for n in range(12):
        prints.fill(image, 0, n / 12, 1, 0.012, tint_color(color, 0.75))
    prints.polygon(
        image, [(0.5, 0.3), (0.64, 0.5), (0.5, 0.7), (0.36, 0.5)], tint_color(color, 1.3)
    )
    face = box(0.084 * k, 0.064 * k, 0.0004).move(z=0.0158)
    clasp = box(0.016, 0.004, 0.006).move(y=-0.04 * k, z=0.005)
    metal = look.surface(color, "silver")
    return shape([(body, metal), (face, image), (clasp, metal)], [hull_of(body)])


@category("ashtray", size=(0.115, 0.115, 0.03), mass=0.35, material="glass",
          aliases=("ash tray", "cigarette tray"), themes=("living",), roles=("round",),
          colors=("clear", "black"))  # fmt: skip
def ashtray(look: Look) -> Shape:
    """An ashtray with notches in its rim, empty or with a stub and ash."""
    r, h = look.between(0.05, 0.065), look.between(0.025, 0.035)
    color = look.color("clear", "green", "black", "white", "brown", "amber", "red")
    skin = look.surface(color, look.pick(["ceramic", "ceramic", "stone"]))
    sides = look.pick([30, 30, 6])
    body, parts = open_vessel([(0.92 * r, 0), (r, 0.3 * h), (r, h)], 0.011, 0.008, sides)
    notches = []
    for n in range(3 if sides == 6 else 4):
        a = 2 * np.pi * n / (3 if sides == 6 else 4) + 0.5
        slot = box(0.02, 0.009, 0.006).turn(2, a)
        notches.append(
            slot.move((r - 0.006) * np.cos(a) * 0.97, (r - 0.006) * np.sin(a) * 0.97, h - 0.0052)
        )
    pieces = [(body, skin), (join(notches), surfaces.plain(tint_color(color, 0.6)))]
    if look.chance(0.5):
        ash = ellipsoid(0.9 * r, 0.75 * r, 0.008, 16, 6).move(z=0.0085)
        stub = cylinder(0.0038, 0.03, 12).turn(1, np.pi / 2 - 0.25).move(-0.012, 0.005, 0.018)
        tile = surfaces.stack(
            (surfaces.plain((206, 140, 70)), 45), (surfaces.plain((244, 242, 236)), 55)
        )
        pieces += [(ash, surfaces.speckles(look.rng, (120, 118, 116), 26)), (stub, tile)]
    return shape(pieces, parts)


@category("cigarette_butt", size=(0.0347, 0.0114, 0.00784), mass=0.001, material="paper",
          aliases=("cigarette end", "cigarette stub", "fag end"), themes=("living",),
          colors=("orange",))  # fmt: skip
def cigarette_butt(look: Look) -> Shape:
    """A bent, stubbed-out cigarette end."""
    k = look.between(0.85, 1.2)
    color = look.color("orange", "tan", "white")
    z = 0.0038
    tip = straight((0.0, 0, z), (0.018, 0.001, z), 0.004, 12)
    paper = rod(
        [(-0.012, 0.0035, z), (-0.006, 0.0005, z), (0.0, 0, z)], [0.0034, 0.0039, 0.0039], 12
    )
    ash = ball(0.008, 0.007, 0.006, (-0.0125, 0.004, 0.0032), 8)
    filt = surfaces.spots(look.rng, color, tint_color(color, 1.4), 0.15)
    return put_down([(tip, filt), (paper, plain((240, 236, 228))), (ash, plain((84, 78, 74)))], tip,
                    paper, factor=k, foot=0.3)  # fmt: skip


@category("cigarette", size=(0.085, 0.008, 0.008), mass=0.001, material="paper",
          aliases=("filter cigarette",), themes=("living",), colors=("white",),
          state="lying")  # fmt: skip
def cigarette(look: Look) -> Shape:
    """A cigarette lying flat with its filter on the right."""
    long = look.between(0.076, 0.095)
    color = look.color("white", "cream", "brown", "tan")
    r = 0.004 * look.between(0.9, 1.15)
    paper = straight((-0.5 * long, 0, 0.96 * r), (0.22 * long, 0, 0.96 * r), r, 14)
    tip = straight((0.219 * long, 0, 0.96 * r), (0.5 * long, 0, 0.96 * r), r, 14)
    leaf = straight((-0.5 * long - 0.0006, 0, 0.96 * r), (-0.49 * long, 0, 0.96 * r), 0.8 * r, 10)
    return put_down([(paper, surfaces.plain(color)), (tip, surfaces.spots(look.rng, (222, 160, 90),
                                                                          (246, 206, 140), 0.15)),
                     (leaf, surfaces.plain((110, 76, 46)))], paper, tip)  # fmt: skip


@category("cigar", size=(0.14, 0.018, 0.017), mass=0.012, material="food", aliases=("cuban cigar",),
          themes=("living",), colors=("brown",), state="lying")  # fmt: skip
def cigar(look: Look) -> Shape:
    """A cigar with a band, lying flat."""
    color = look.color("brown", "bronze", "tan", "terracotta")
    body = rod([(-0.07, 0, 0.0083), (-0.03, 0, 0.0083), (0.05, 0, 0.0083), (0.07, 0, 0.0083)],
               [0.0075, 0.0088, 0.0086, 0.0035], 14)  # fmt: skip
    band = straight((0.03, 0, 0.0083), (0.045, 0, 0.0083), 0.0091, 16)
    end = straight((-0.0705, 0, 0.0083), (-0.068, 0, 0.0083), 0.006, 12)
    return put_down([(body, surfaces.scratches(look.rng, tint_color(color, 0.75),
                                               tint_color(color, 0.55), 80)),
                     (band, surfaces.plain(look.own_color("red", "gold", "green"))),
                     (end, surfaces.plain((70, 54, 44)))], body,
                    factor=look.between(0.8, 1.15))  # fmt: skip


@category("smoking_pipe", size=(0.16, 0.042, 0.047), mass=0.05, material="wood", assembled=True,
          aliases=("tobacco pipe", "wooden pipe"), themes=("living",),
          colors=("brown",))  # fmt: skip
def smoking_pipe(look: Look) -> Shape:
    """A tobacco pipe lying on the side of its bowl."""
    color = look.color("brown", "wooden", "bronze", "black", "terracotta")
    bowl, _ = open_vessel([(0.008, 0), (0.017, 0.004), (0.02, 0.02), (0.018, 0.045)], 0.005, 0.012)
    ash = cylinder(0.0125, 0.002, 16).move(z=0.034)
    stem = rod([(0.012, 0, 0.008), (0.05, 0, 0.012), (0.075, 0, 0.02)], [0.008, 0.006, 0.005], 10)
    bit = rod([(0.073, 0, 0.0195), (0.11, 0, 0.03), (0.135, 0, 0.031)], [0.0052, 0.004, 0.003], 10)
    foot = cylinder(0.0105, 0.004, 16)
    return put_down([(join([bowl, stem, foot]), look.surface(color, "wood")),
                     (ash, surfaces.plain((70, 56, 46))), (bit, surfaces.plain((34, 32, 32)))],
                    join([bowl, foot]), stem, bit, factor=look.between(0.9, 1.15),
                    foot=0.3)  # fmt: skip


@category("lighter", size=(0.025, 0.013, 0.079), mass=0.02, material="plastic",
          aliases=("cigarette lighter", "pocket lighter", "gas lighter", "plastic lighter",
          "firesteel", "blowtorch"), themes=("living",), roles=("tall",),
          colors=("red", "blue"))  # fmt: skip
def lighter(look: Look) -> Shape:
    """A pocket lighter standing upright, with a wheel and a button below its metal hood."""
    color = look.color("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")
    body = block(0.024, 0.0125, 0.056, 0.006)
    hood = block(0.022, 0.0115, 0.016, 0.005).move(z=0.0555)
    slot = box(0.01, 0.0118, 0.006).move(-0.004, 0, 0.0605)
    wheel = cylinder(0.0048, 0.006, 14).move(z=-0.003).turn(0, np.pi / 2).move(0.004, 0, 0.0725)
    key = box(0.008, 0.007, 0.006).turn(1, 0.3).move(0.0095, 0, 0.068)
    pieces: Pieces = [(body, look.surface(color, "plastic")),
                      (hood, surfaces.brushed_metal(look.rng, (196, 198, 204))),
                      (join([slot, wheel]), surfaces.plain((66, 66, 70))),
                      (key, surfaces.plain(tint_color(color, 0.6)))]  # fmt: skip
    return put_down(pieces, body, hood, factor=look.between(0.92, 1.12))


@category("match", size=(0.06, 0.0042, 0.0035), mass=0.0003, material="wood",
          aliases=("matchstick", "match stick", "wooden match"), themes=("living",),
          colors=("red",), state="lying")  # fmt: skip
def match(look: Look) -> Shape:
    """A match, lying flat."""
    color = look.color("red", "brown", "blue", "green", "black", "pink")
    long = look.between(0.045, 0.07)
    stick = box(long, 0.0024, 0.0024)
    head = ball(0.006, 0.0042, 0.004, (-long / 2 + 0.001, 0, 0.0015), 10)
    return put_down([(stick, surfaces.wood(look.rng, (226, 196, 140))),
                     (head, surfaces.plain(color))], stick, head)  # fmt: skip


@category("matchbook", size=(0.0411, 0.0587, 0.0476), mass=0.006, material="paper",
          aliases=("book of matches", "paper matches", "book matches"), themes=("living",),
          colors=("red",), state="lying flat")  # fmt: skip
def matchbook(look: Look) -> Shape:
    """An open matchbook lying flat: a folded card with a comb of paper matches."""
    k = look.between(0.94, 1.12)
    color = look.color("red", "navy", "green", "black", "yellow", "white")
    x, y = 0.04 * k, 0.048 * k
    base = box(x, y, 0.003)
    lip = box(x, 0.011 * k, 0.003).move(y=-0.5 * y + 0.0055 * k, z=0.003)
    cover = box(x, y, 0.0014).turn(0, -1.15).move(y=0.46 * y, z=0.021 * k)
    cover = cover.move(z=0.002 - float(cover.bounds[0, 2]))
    rough = box(0.96 * x, 0.005, 0.0004).move(y=-0.5 * y + 0.005, z=0.006)
    sticks = [box(0.0028, 0.036 * k, 0.0016).move((n - 4.5) * 0.0039 * k, -0.002, 0.0032)
              for n in range(10)]  # fmt: skip
    heads = [ball(0.0038, 0.0065, 0.0034, ((n - 4.5) * 0.0039 * k, 0.0165 * k, 0.004), 7)
             for n in range(10)]  # fmt: skip
    tip = surfaces.plain(look.own_color("red", "brown", "green"))
    return shape([(join([base, lip]), surfaces.plain(color)),
                  (cover, surfaces.plain(tint_color(color, 0.9))),
                  (rough, surfaces.plain((90, 60, 50))),
                  (join(sticks), surfaces.plain((240, 232, 214))), (join(heads), tip)],
                 [hull_of(base, lip), hull_of(cover), hull_of(*sticks, *heads)])  # fmt: skip
