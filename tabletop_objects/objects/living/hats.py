"""Objects of the ``living`` theme: hats."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import hull_above, hull_of, hull_part, ring_parts
from ...kit.primitives import ball, drum, limb, lobe, plate, rod, standing
from ...kit.shapes import Pieces, Shape, category, put_down, shape, vary
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain, readable_on, tint_color


@category("santa_hat", size=(0.238, 0.207, 0.166), mass=0.06, material="fabric", hollow=True,
          aliases=("santa's hat", "christmas hat", "father christmas hat", "santa claus hat"),
          themes=("living",), colors=("red",))  # fmt: skip
@vary()
def santa_hat(look: Look) -> Shape:
    """A red cap with a white fur brim, a folded tip and a bobble."""
    k = look.between(0.92, 1.08)
    color = look.color("red", "red", "crimson")
    cone = limb([(0, 0, 0.02), (0, 0, 0.07), (0.015, 0, 0.125), (0.065, 0, 0.135),
                 (0.105, 0, 0.09)], [0.082, 0.07, 0.042, 0.024, 0.01], 20)  # fmt: skip
    brim = torus(0.082, 0.022, 36, 10).move(z=0.022)
    bob = ball(0.046, 0.046, 0.046, (0.112, 0, 0.07), 16)
    fur = surfaces.scratches(look.rng, (250, 248, 244), (226, 224, 220), 120)
    return shape([(cone, surfaces.fabric(look.rng, color)), (join([brim, bob]), fur)],
                 [hull_of(brim), hull_above(cone), hull_of(bob)]).scale(k)  # fmt: skip


@category("elf_hat", size=(0.191, 0.191, 0.196), mass=0.06, material="fabric", hollow=True,
          aliases=("elf's hat", "pixie hat", "gnome hat", "christmas elf hat"), themes=("living",),
          roles=("tall",), colors=("green",))  # fmt: skip
def elf_hat(look: Look) -> Shape:
    """A pointed elf cap with a zigzag collar and a bell at its tip."""
    k = look.between(0.92, 1.08)
    color = look.color("green", "green", "red")
    cone = limb([(0, 0, 0.004), (0, 0, 0.06), (0.01, 0, 0.13), (0.04, 0, 0.18)],
                [0.085, 0.068, 0.034, 0.006], 20)  # fmt: skip
    collar = lathe([(0.086, 0), (0.095, 0.004), (0.084, 0.03), (0.076, 0.03)], 40, loop=True)
    zigzag = collar.bend(lambda p: p * np.column_stack([np.ones((len(p), 2)), 1 + 0.35 * np.sign(
        p[:, 2] - 0.01) * np.cos(10 * np.arctan2(p[:, 1], p[:, 0]))]))  # fmt: skip
    bell = ball(0.022, 0.022, 0.022, (0.044, 0, 0.184), 12)
    trim = surfaces.fabric(look.rng, look.own_color("red", "yellow") if color[1] > color[0]
                           else look.own_color("green", "yellow"))  # fmt: skip
    return shape([(cone, surfaces.fabric(look.rng, color)), (zigzag, trim),
                  (bell, surfaces.plain((222, 182, 80)))],
                 [hull_of(zigzag), hull_above(cone), hull_of(bell)]).scale(k)  # fmt: skip


@category("paper_crown", size=(0.175, 0.172, 0.076), mass=0.004, material="paper", hollow=True,
          aliases=("cracker crown", "christmas cracker hat", "tissue paper crown", "cracker hat",
          "cardboard crown"), themes=("living",), roles=("round",), colors=("yellow",))  # fmt: skip
def paper_crown(look: Look) -> Shape:
    """A thin paper crown from a cracker: a ring with points, standing upright."""
    k = look.between(0.92, 1.08)
    color = look.color("yellow", "red", "green", "purple", "orange", "blue")
    r, h, t = 0.085, 0.075, 0.0022
    ring = lathe([(r, 0), (r, 0.6 * h), (r, h), (r - t, h), (r - t, 0.6 * h), (r - t, 0)], 72,
                 loop=True)  # fmt: skip
    points = ring.bend(lambda p: (p * np.column_stack([np.ones((len(p), 2)),
                                                       np.where(p[:, 2] > 0.8 * h, 0.8 + 0.2
                                                                * np.cos(9
                                                                         * np.arctan2(p[:, 1],
                                                                                      p[:, 0])),
                                                                1.0)])))  # fmt: skip
    folds = [tube([((r + 0.0006) * np.cos(a), (r + 0.0006) * np.sin(a), 0.001), ((r + 0.0006) *
             np.cos(a), (r + 0.0006) * np.sin(a), 0.6 * h)], 0.0008, 4)
             for a in 2 * np.pi * np.arange(6) / 6]  # fmt: skip
    return shape([(points, surfaces.speckles(look.rng, color, 5)),
                  (join(folds), surfaces.plain(tint_color(color, 0.8)))],
                 ring_parts([(r, 0), (r, 0.92 * h)], [(r - t, 0.92 * h), (r - t, 0)], 14)
                 ).scale(k)  # fmt: skip


@category("top_hat", size=(0.232, 0.264, 0.132), mass=0.15, material="fabric", hollow=True,
          aliases=("topper", "magician's hat", "silk hat", "magician hat"), themes=("living",),
          roles=("big",), colors=("black",))  # fmt: skip
def top_hat(look: Look) -> Shape:
    """A top hat with a silk band."""
    color = look.color("black", "gray", "navy", "maroon", "white")
    k = look.between(0.85, 1.1)
    brim = standing((0.085, 0.006), (0.125, 0.0), (0.13, 0.005), (0.09, 0.012), sides=32)
    brim = brim.scale(0.92, 1.05, 1)
    crown = standing((0.078, 0.004), (0.076, 0.06), (0.082, 0.13), (0.08, 0.136), sides=32).scale(
        0.95, 1.05, 1
    )
    band = standing((0.0795, 0.01), (0.0785, 0.036), sides=32).scale(0.955, 1.055, 1)
    return put_down([(join([brim, crown]), surfaces.speckles(look.rng, color, 4)),
                     (band, plain(look.own_color("maroon", "gray", "red", "white")))], brim, crown,
                    factor=k)  # fmt: skip


@category("bowler_hat", size=(0.224, 0.258, 0.11), mass=0.12, material="fabric", hollow=True,
          aliases=("bowler", "derby hat", "derby"), themes=("living",), roles=("big",),
          colors=("black",))  # fmt: skip
def bowler_hat(look: Look) -> Shape:
    """A hat with a round crown and a rolled brim."""
    color = look.color("black", "brown", "gray", "charcoal")
    k = look.between(0.85, 1.1)
    crown = standing(
        (0.085, 0.006), (0.084, 0.05), (0.07, 0.085), (0.045, 0.105), (0.015, 0.112), sides=30
    )
    brim = standing(
        (0.08, 0.006), (0.11, 0.0), (0.122, 0.008), (0.115, 0.012), (0.085, 0.014), sides=30
    )
    rim = torus(0.119, 0.004, 32, 6).move(z=0.011)
    band = standing((0.0865, 0.012), (0.0858, 0.034), sides=30)
    felt = surfaces.speckles(look.rng, color, 5)
    whole = [one.scale(0.93, 1.07, 1) for one in (crown, brim, rim, band)]
    return put_down([(join(whole[:2]), felt), (join(whole[2:]), plain(tint_color(color, 0.6)))],
                    whole[0], whole[1], factor=k)  # fmt: skip


@category("fez", size=(0.159, 0.16, 0.125), mass=0.08, material="fabric", hollow=True,
          aliases=("tarboosh", "fez hat"), themes=("living",), roles=("big",),
          colors=("crimson",))  # fmt: skip
def fez(look: Look) -> Shape:
    """A fez with a tassel."""
    color = look.color("crimson", "red", "maroon", "black")
    k = look.between(0.9, 1.1)
    body = standing((0.078, 0), (0.08, 0.004), (0.06, 0.115), (0.057, 0.118), sides=30)
    cord = tube(smooth([(0, 0, 0.119), (0.04, -0.03, 0.122), (0.058, -0.042, 0.1),
                        (0.062, -0.045, 0.075)], 5), 0.0022, 6)  # fmt: skip
    tuft = drum(0.009, 0.04, (0.065, -0.047, 0.035), top=0.005, sides=12)
    return put_down([(body, surfaces.speckles(look.rng, color, 5)),
                     (join([cord, tuft]), plain((36, 34, 36)))], body, tuft, factor=k)  # fmt: skip


@category("mortarboard", size=(0.322, 0.322, 0.0695), mass=0.15, material="fabric",
          aliases=("graduation cap", "graduation hat", "academic cap", "square academic cap"),
          themes=("living",), roles=("big",), colors=("black",))  # fmt: skip
def mortarboard(look: Look) -> Shape:
    """A mortarboard: a flat, square board on a skull cap, with a tassel."""
    color = look.color("black", "navy", "maroon", "green")
    k = look.between(0.85, 1.05)
    skull = standing((0.088, 0), (0.09, 0.02), (0.085, 0.06), sides=28)
    board = block(0.235, 0.235, 0.007, 0.004).turn(2, np.pi / 4).move(z=0.058)
    knob = ball(0.018, 0.018, 0.01, (0, 0, 0.066), 12)
    tone = look.own_color("gold", "gold", "white", "red")
    cord = rod([(0, 0, 0.068), (0.06, -0.05, 0.068), (0.1, -0.084, 0.066), (0.106, -0.088, 0.04)],
               0.0022, 6)  # fmt: skip
    tuft = drum(0.009, 0.034, (0.106, -0.088, 0.01), top=0.005, sides=12)
    cloth = surfaces.speckles(look.rng, color, 4)
    return put_down([(join([skull, board]), cloth), (join([knob, cord, tuft]), plain(tone))], skull,
                    board, factor=k)  # fmt: skip


@category("sun_visor", size=(0.173, 0.257, 0.0436), mass=0.06, material="fabric",
          aliases=("tennis visor", "visor cap"), themes=("living",), roles=("big",),
          colors=("white",))  # fmt: skip
def sun_visor(look: Look) -> Shape:
    """A sun visor: a peak on a band, open at the top."""
    color = look.color("white", "red", "navy", "pink", "green", "yellow")
    k = look.between(0.9, 1.1)
    a = np.linspace(0, 2 * np.pi, 33)[:-1]
    path = np.column_stack([0.08 * np.cos(a), 0.09 * np.sin(a), 0.024 + 0 * a])
    band = tube(path, 0.0035, 8, squash=6, loop=True)
    b = np.linspace(-np.pi + 0.45, -0.45, 12)
    outer = np.column_stack([0.085 * np.cos(b), -0.02 + 0.135 * np.sin(b)])
    inner = np.column_stack([0.078 * np.cos(b), 0.088 * np.sin(b)])[::-1]
    peak = plate(np.concatenate([outer, inner]), 0.004, at=(0, 0, 0.003))
    peak = peak.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.022
                                                * np.clip(1 - (p[:, 0] / 0.088) ** 2, 0,
                                                          1)]))  # fmt: skip
    bits = [tube(np.roll(path, -4 * n, 0)[:6], 0.0035, 8, squash=6) for n in range(8)]
    return put_down([(band, surfaces.fabric(look.rng, color)),
                     (peak, plain(tint_color(color, 0.85)))], *bits, peak, factor=k)  # fmt: skip


@category("flat_cap", size=(0.192, 0.25, 0.0769), mass=0.1, material="fabric", hollow=True,
          aliases=("tweed cap", "newsboy cap", "driving cap", "paperboy cap"), themes=("living",),
          roles=("big",), colors=("gray", "brown"))  # fmt: skip
def flat_cap(look: Look) -> Shape:
    """A flat cap of checked cloth with a short peak."""
    color = look.color("gray", "brown", "tan", "charcoal", "olive", "navy")
    k = look.between(0.9, 1.1)
    body = ball(0.19, 0.21, 0.085, (0, 0.01, 0.028), 22)
    body = body.bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] - 0.12 * np.clip(-p[:, 1], 0, 0.1)])
    )
    peak = plate([(-0.075, -0.06), (-0.06, -0.105), (0, -0.128), (0.06, -0.105), (0.075, -0.06)],
                 0.006, at=(0, 0, 0.006))  # fmt: skip
    band = standing((0.083, 0), (0.085, 0.02), sides=26).scale(0.95, 1.1, 1)
    knob = ball(0.014, 0.014, 0.008, (0, 0.012, 0.0705), 10)
    return put_down([(join([body, knob]), surfaces.fabric(look.rng, color,
                                                          tint_color(color, 1.35))),
                     (join([peak, band]), plain(tint_color(color, 0.8)))], body, band, peak,
                    factor=k)  # fmt: skip


@category("earmuffs", size=(0.183, 0.0858, 0.124), mass=0.08, material="fabric",
          aliases=("ear muffs", "pair of earmuffs", "ear warmer", "fluffy earmuffs"),
          themes=("living",), roles=("big",), colors=("pink", "white"))  # fmt: skip
def earmuffs(look: Look) -> Shape:
    """Fluffy earmuffs on a band, lying on their pads."""
    color = look.color("pink", "white", "gray", "brown", "red", "sky")
    k = look.between(0.85, 1.1)
    pads = [ball(0.038, 0.088, 0.085, (s * 0.075, 0, 0.041), 16) for s in (-1, 1)]
    a = np.linspace(0, np.pi, 15)
    band = tube(
        np.column_stack([0.077 * np.cos(a), 0 * a, 0.045 + 0.075 * np.sin(a)]), 0.007, 8, squash=0.5
    )
    fur = surfaces.scratches(look.rng, color, tint_color(color, 1.4), 140)
    return put_down(
        [(join(pads), fur), (band, plain(tint_color(color, 0.6)))], *pads, band, factor=k, foot=0.1
    )


GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


@category("party_hat", size=(0.125, 0.125, 0.155), mass=0.02, material="paper", hollow=True,
          aliases=("birthday hat", "paper hat", "cone hat", "cardboard hat"), themes=("living",),
          roles=("tall",), colors=("red", "blue"))  # fmt: skip
def party_hat(look: Look) -> Shape:
    """A paper cone with a pattern, a frill and a pompom."""
    r, h = look.between(0.05, 0.062), look.between(0.13, 0.165)
    paper = surfaces.fit(glaze_tile(look, look.color(*GAY)), 128, 128)
    cone = cylinder(r, h, 28, top=0.003)
    frill = lobe(torus(r, 0.006, 36, 6), 24, 0.06).move(z=0.0058)
    tuft = [ball(0.022, 0.009, 0.009, (0.008, 0, 0), 8).turn(1, 0.5 * n).turn(2, 1.3 * n).move(z=h)
            for n in range(10)]  # fmt: skip
    other = surfaces.plain(look.own_color(*GAY))
    return put_down([(cone, paper), (frill, other), (join(tuft), other)], cone, join(tuft))


@category("witch_hat", size=(0.21, 0.21, 0.152), mass=0.08, material="fabric", hollow=True,
          aliases=("wizard hat", "halloween hat", "pointed hat"), themes=("living",),
          colors=("black",))  # fmt: skip
def witch_hat(look: Look) -> Shape:
    """A witch's hat with a wide brim, a bent cone and a band with a buckle."""
    color = look.color("black", "black", "purple", "charcoal")
    cloth = surfaces.fabric(look.rng, color)
    k = look.between(0.85, 1.15)
    brim = lathe([(0, 0), (0.1, 0), (0.105, 0.004), (0.1, 0.006), (0, 0.01)], 32)
    cone = rod([(0, 0, 0.004), (0, 0, 0.06), (0.008, 0, 0.11), (0.035, 0, 0.15)],
               [0.058, 0.036, 0.02, 0.004], 22, 5)  # fmt: skip
    band = cylinder(0.0575, 0.018, 28, top=0.052).move(z=0.008)
    buckle = box(0.026, 0.004, 0.02).move(0, -0.054, 0.008)
    inner = box(0.016, 0.004, 0.011).move(0, -0.0551, 0.0125)
    hue = surfaces.plain(look.own_color("purple", "orange", "green", "red"))
    return put_down([(join([brim, cone]), cloth), (band, hue),
                     (buckle, surfaces.plain((224, 184, 80))), (inner, hue)], brim, cone,
                    factor=k)  # fmt: skip


@category("cap", size=(0.18, 0.275, 0.12), mass=0.09, material="fabric", hollow=True,
          assembled=True, aliases=("baseball cap", "ball cap", "baseball hat", "green visor",
          "visor", "beret", "peaked cap", "shower cap", "swimming cap"), themes=("living",),
          roles=("big",), colors=("navy", "red"), common=True)  # fmt: skip
def cap(look: Look) -> Shape:
    """A baseball cap with its visor towards the viewer."""
    r, h = look.between(0.085, 0.095), look.between(0.105, 0.125)
    color = look.color("navy", "red", "black", "tan", "green", "white", "pink")
    cloth = surfaces.fabric(look.rng, color)
    a = np.linspace(0, np.pi / 2, 9)
    bow = np.column_stack([r * np.cos(a) ** 0.75, h * np.sin(a)])[:-1]
    crown = lathe([(0, 0), *bow, (0, h)], 32).scale(1, 1.12, 1)
    t = np.linspace(-1, 1, 15)
    front = np.column_stack([0.86 * r * t, -1.0 * r - 0.075 * (1 - t**4) ** 0.8 + 0.4 * r * t**2])
    inner = np.column_stack([0.86 * r * t, -0.95 * r * np.sqrt(1 - (0.82 * t) ** 2)])[::-1]
    visor = prism(np.concatenate([front, inner[1:-1]]), 0, 0.0035)
    visor = visor.bend(lambda p: p + np.column_stack(
        [np.zeros((len(p), 2)), 0.014 * (1 - (p[:, 0] / (0.86 * r)) ** 2)]))  # fmt: skip
    button = ellipsoid(0.013, 0.013, 0.008, 12, 6).move(z=h)
    seams = [tube(np.column_stack([1.005 * r * np.cos(a) ** 0.75 * np.cos(w),
                                   1.125 * r * np.cos(a) ** 0.75 * np.sin(w),
                                   1.005 * h * np.sin(a)])[:-1], 0.001, 4)
             for w in np.pi * np.arange(6) / 3 + np.pi / 2]  # fmt: skip
    badge = look.own_color("white", "yellow", "red", "navy")
    patch = prints.canvas(64, 48, badge)
    letter = look.pick(["A", "NY", "LA", "7", "K"])
    prints.write(patch, letter, 0.5, 0.5, 0.62, readable_on(badge), bold=True)
    front_patch = box(0.05, 0.004, 0.036).turn(0, -0.3).move(y=-1.115 * r, z=0.36 * h)
    peak = look.own_color("navy", "red", "black", "tan") if look.chance(0.4) else color
    return shape(
        [(crown, cloth), (visor, surfaces.fabric(look.rng, peak)),
         (join([button, *seams]), surfaces.plain(tint_color(color, 0.8))), (front_patch, patch)],
        [hull_of(crown), hull_of(visor)],
    )  # fmt: skip


@category("hat", size=(0.283, 0.322, 0.103), mass=0.12, material="fabric", aliases=("straw hat",
          "fedora", "sun hat", "cowboy hat", "panama hat", "easter bonnet", "fascinator", "bonnet",
          "trilby"), themes=("living",), roles=("big",), colors=("tan", "black"))  # fmt: skip
def hat(look: Look) -> Shape:
    """A straw hat, fedora or sun hat with a brim and a ribbon around its crown."""
    k = look.between(0.9, 1.05)
    color = look.color("tan", "beige", "brown", "black", "white", "gray", "navy", "cream")
    kind = look.pick(["fedora", "sun", "bowler"])
    brim = {"fedora": 0.155, "sun": 0.19, "bowler": 0.135}[kind] * k
    h = {"fedora": 0.115, "sun": 0.1, "bowler": 0.115}[kind] * k
    r = 0.088 * k
    side = {
        "fedora": [(r, 0.004), (0.92 * r, 0.8 * h), (0.72 * r, h), (0.3 * r, 0.93 * h)],
        "sun": [(r, 0.004), (0.94 * r, 0.5 * h), (0.7 * r, 0.9 * h), (0.3 * r, h)],
        "bowler": [(r, 0.004), (1.0 * r, 0.5 * h), (0.78 * r, 0.88 * h), (0.35 * r, h)],
    }[kind]
    curl = 0.012 if kind != "sun" else 0.0
    body = lathe([(0, 0), (0.9 * brim, 0), (brim, max(curl, 0)), (0.995 * brim, max(curl, 0)
                                                                  + 0.003), (0.85 * brim, 0.004),
                  *side, (0, side[-1][1])], 36)  # fmt: skip
    straw = (surfaces.basketwork(look.rng, color, 20) if look.chance(0.5) and sum(color) > 330
             else surfaces.fabric(look.rng, color))  # fmt: skip
    pinch = 0.3 if kind == "fedora" else 0.0

    def dent(p: np.ndarray) -> np.ndarray:
        up = np.clip((p[:, 2] / h - 0.55) / 0.45, 0, 1)
        middle = np.exp(-((p[:, 0] / (0.35 * r)) ** 2))
        return p * np.column_stack([1 - 0.1 * pinch * up, np.ones(len(p)),
                                    1 - pinch * 0.4 * up * middle])  # fmt: skip

    band = lathe([(r - 0.003, 0.005), (r + 0.0022, 0.005), (0.97 * r + 0.0022, 0.032),
                  (0.96 * r - 0.003, 0.032)], 36, loop=True).scale(0.88, 1, 1)  # fmt: skip
    ribbon = surfaces.plain(look.own_color("black", "navy", "red", "brown", "white", "green"))
    body = body.scale(0.88, 1, 1).bend(dent)
    low = body.vertices[body.vertices[:, 2] < 0.02]
    high = body.vertices[body.vertices[:, 2] > 0.0039]
    high = high[np.hypot(high[:, 0] / 0.88, high[:, 1]) < 1.01 * r]
    return shape([(body, straw), (band, ribbon)], [hull_part(low), hull_part(high)])


@category("beanie", size=(0.194, 0.165, 0.15), mass=0.09, material="fabric", aliases=("bobble hat",
          "winter hat", "wool hat", "knit hat", "knitted hat", "woolly hat", "knit cap", "wool cap",
          "watch cap", "snood", "hair net"), themes=("living",), roles=("big",),
          colors=("red", "navy"))  # fmt: skip
def beanie(look: Look) -> Shape:
    """A knitted beanie with a turned-up brim and a pompom, lying on its rim."""
    color = look.color("red", "navy", "gray", "mustard", "teal", "black", "orange", "green")
    k = look.between(0.9, 1.1)
    crown = lathe([(0, 0), (0.088, 0), (0.09, 0.05), (0.07, 0.1), (0.03, 0.126), (0, 0.13)], 30)
    brim = lathe(
        [(0.08, 0), (0.094, 0), (0.097, 0.02), (0.094, 0.045), (0.08, 0.045)], 30, loop=True
    )
    tuft = ball(0.05, 0.05, 0.046, (0, 0, 0.142), 12)
    pieces: Pieces = [(crown.scale(1, 0.85, 1), surfaces.knitting(look.rng, color, 22)),
                      (brim.scale(1, 0.85, 1), surfaces.stripes([color, tint_color(color, 0.8)], 40,
                                                                upright=True,
                                                                side=160))]  # fmt: skip
    if look.chance(0.6):
        pieces.append((tuft, surfaces.scratches(look.rng, (240, 236, 226), (206, 200, 190), 90)))
    return put_down(pieces, pieces[0][0], pieces[1][0], factor=k)
