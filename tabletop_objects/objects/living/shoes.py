"""Objects of the ``living`` theme: shoes."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import BRASS_TONE, DARK, leather, steel
from ...kit.outlines import smooth
from ...kit.parts import above, hull_of, hull_part
from ...kit.primitives import at_box, ball, drum, plate, rod
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import Solid, box, join, loft, prism, tube
from ...kit.surfaces import RGB, Look, plain, tint_color

FOOT = np.array([(-0.12, -0.03), (-0.06, -0.034), (0.0, -0.03), (0.07, -0.046), (0.115, -0.036),
                 (0.135, -0.005), (0.12, 0.03), (0.06, 0.042), (0.0, 0.03), (-0.06, 0.034),
                 (-0.12, 0.03), (-0.135, 0)])  # fmt: skip
"""The outline of a sole, its toe towards +x."""


@category("shoelace", size=(0.135, 0.0909, 0.00892), mass=0.01, material="fabric",
          aliases=("shoe lace", "boot lace", "bootlace", "pair of shoelaces"), themes=("living",),
          roles=("flat",), colors=("white",))  # fmt: skip
def shoelace(look: Look) -> Shape:
    """A pair of laces with capped ends, lying in loops."""
    color = look.color("white", "black", "red", "yellow", "brown", "blue")
    k = look.between(0.85, 1.15)
    t = np.linspace(0, 2 * np.pi, 70)
    path = np.column_stack(
        [0.065 * np.sin(t), 0.038 * np.sin(2 * t + 0.2), 0.0024 + 0.0018 * (1 + np.cos(t))]
    )
    path = path + np.column_stack([0 * t, 0.006 * t - 0.02, 0 * t])
    lace = tube(path, 0.0027, 7)
    tips = [
        tube([path[i], path[i] + w], 0.0029, 8)
        for i, w in ((0, [-0.018, -0.008, 0]), (-1, [0.018, 0.008, 0]))
    ]
    lines = surfaces.stripes([color, tint_color(color, 0.8)], 24)
    bits = [tube(path[i : i + 8], 0.0027, 6) for i in range(0, 63, 7)]
    return put_down(
        [(lace, lines), (join(tips), plain((70, 72, 78)))], *bits, *tips, factor=k, foot=0.3
    )


@category("insole", size=(0.27, 0.0879, 0.00699), mass=0.03, material="fabric",
          aliases=("shoe insole", "inner sole", "shoe insert"), themes=("living",), roles=("flat",),
          colors=("blue",))  # fmt: skip
def insole(look: Look) -> Shape:
    """An insole, lying flat."""
    color = look.color("blue", "tan", "gray", "green", "black", "cream")
    k, s = look.between(0.85, 1.08), look.pick([-1, 1])
    rim = smooth(np.concatenate([FOOT, FOOT[:1]]) * [1, s], 4)[:-1]
    sole, top = plate(rim, 0.005), plate(0.965 * rim, 0.0014, at=(0, 0, 0.0048))
    image = surfaces.fabric(look.rng, color)
    arch = [at_box(0.03, 0.012, 0.0012, (-0.09, 0, 0.0058))]
    return put_down([(sole, plain(tint_color(color, 0.6))), (top, image),
                     (join(arch), plain((244, 240, 230)))], sole, factor=k)  # fmt: skip


@category("shoe_tree", size=(0.267, 0.0832, 0.0517), mass=0.35, material="wood",
          aliases=("shoe stretcher", "boot tree", "glove stretcher"), themes=("living",),
          colors=("tan",))  # fmt: skip
def shoe_tree(look: Look) -> Shape:
    """A wooden shoe tree lying flat: a split toe, a spring tube and a heel with a knob."""
    color = look.color("tan", "wooden", "brown")
    k = look.between(0.85, 1.05)
    toes = [ball(0.12, 0.04, 0.05, (0.075, s * 0.023, 0.022), 16) for s in (-1, 1)]
    heel = ball(0.06, 0.055, 0.055, (-0.1, 0, 0.026), 16)
    pole = rod([(-0.1, 0, 0.028), (0.05, 0, 0.026)], 0.0055, 10)
    knob = ball(0.022, 0.022, 0.022, (-0.13, 0, 0.042), 12)
    wood = surfaces.wood(look.rng, color)
    return put_down([(join([*toes, heel]), wood), (join([pole, knob]), steel(look, BRASS_TONE))],
                    *toes, heel, pole, factor=k)  # fmt: skip


@category("clog", size=(0.287, 0.1, 0.077), mass=0.35, material="wood",
          aliases=("wooden shoe", "wooden clog", "dutch clog"), themes=("living",), roles=("big",),
          colors=("tan",))  # fmt: skip
def clog(look: Look) -> Shape:
    """A wooden clog with a turned-up toe."""
    color = look.color("wooden", "tan", "yellow", "red", "blue")
    k = look.between(0.85, 1.1)
    rim = smooth(np.concatenate([FOOT, FOOT[:1]]), 4)[:-1]
    sole = prism(0.98 * rim, 0, 0.03)
    front = ball(0.17, 0.092, 0.085, (0.055, -0.002, 0.036), 20)
    toe = rod([(0.1, 0, 0.04), (0.14, 0, 0.044), (0.152, 0, 0.062)], [0.02, 0.012, 0.004], 10)
    heel = [tube(smooth([(0.0, s * 0.042, 0.05), (-0.07, s * 0.04, 0.045), (-0.12, s * 0.02, 0.048),
                         (-0.128, 0, 0.05)], 4), 0.009, 8, squash=2.6)
            for s in (-1, 1)]  # fmt: skip
    hole = ball(0.1, 0.06, 0.03, (-0.035, 0, 0.052), 16)
    blocks = [at_box(0.05, 0.06, 0.012, (-0.09, 0, 0)), at_box(0.06, 0.07, 0.012, (0.06, 0, 0))]
    paint = look.surface(color, "wood")
    return put_down([(join([sole, front, toe, *heel, *blocks]), paint),
                     (hole, plain((70, 50, 36)))], sole, front, join(heel), factor=k)  # fmt: skip


@category("shoe_horn", size=(0.169, 0.0413, 0.00926), mass=0.05, material="metal",
          aliases=("shoehorn",), themes=("living",), roles=("flat",),
          colors=("silver",))  # fmt: skip
def shoe_horn(look: Look) -> Shape:
    """A shoehorn lying flat: a curved blade with a hole in its handle."""
    color = look.color("silver", "brown", "black", "gold", "tan")
    k = look.between(0.8, 1.2)
    n = 15
    x = np.linspace(-0.085, 0.085, n)
    half = np.interp(x, [-0.085, -0.06, 0.0, 0.06, 0.085], [0.008, 0.014, 0.013, 0.021, 0.015])
    rims = []
    for a, w in zip(x, half, strict=True):
        deep = 0.42 * w
        y = np.array([-w, -0.5 * w, 0.5 * w, w, 0.5 * w, -0.5 * w])
        z = np.array(
            [deep, 0.12 * deep, 0.12 * deep, deep, 0.12 * deep + 0.0022, 0.12 * deep + 0.0022]
        )
        z[[0, 3]] += 0.001
        rims.append(np.column_stack([np.full(6, a), y, z]))
    made = loft(np.stack(rims), rims[0][:, 1:])
    hole = drum(0.004, 0.001, (-0.072, 0, 0.0035))
    tile = look.surface(color, "steel" if min(color) > 130 else "plastic")
    return put_down([(made, tile), (hole, plain(DARK))], made, factor=k)


@category("shoe", size=(0.27, 0.095, 0.095), mass=0.32, material="rubber", aliases=("sneaker",
          "trainer", "running shoe", "sports shoe", "tennis shoe", "gym shoe", "loafer", "brogue",
          "moccasin", "espadrille", "ballet flat", "plimsoll", "miniature shoe"),
          themes=("living",), colors=("white", "black"))  # fmt: skip
def shoe(look: Look) -> Shape:
    """A laced trainer with its toe on the left, sometimes a pair of them."""
    k = look.between(0.9, 1.05)
    color = look.color("white", "black", "red", "blue", "gray", "navy", "green", "pink", "tan")
    other: RGB = look.own_color("white", "black", "orange", "lime", "navy", "red")
    upper_tile = (surfaces.fabric(look.rng, color) if look.chance(0.5)
                  else surfaces.speckles(look.rng, color, 4))  # fmt: skip

    def foot(grow: float, x: float) -> np.ndarray:
        half = [(-0.14, 0.0), (-0.13, 0.03), (-0.085, 0.048), (-0.03, 0.045), (0.04, 0.036),
                (0.1, 0.036), (0.128, 0.02), (0.132, 0.0)]  # fmt: skip
        curve = smooth(half, 3) * grow
        curve[:, 0] += x
        outline = np.concatenate([curve * [1, -1], curve[::-1][1:-1]])
        return outline * k

    base = foot(1.0, 0.0)
    count = len(base)
    sole = loft(np.stack([np.column_stack([foot(g, 0.0), np.full(count, z * k)])
                          for g, z in ((0.97, 0), (1.0, 0.006), (0.99, 0.028))]), base)  # fmt: skip
    levels = [(0.97, 0.0, 0.026, 0.0), (0.93, 0.002, 0.045, 0.012), (0.82, 0.012, 0.06, 0.04),
              (0.6, 0.05, 0.075, 0.07), (0.46, 0.068, 0.095, 0.09)]  # fmt: skip
    rings = []
    for g, x, z, _ in levels:
        outline = foot(g, x / 1.0)
        rings.append(np.column_stack([outline, np.full(count, z * k)]))
    upper = loft(np.stack(rings), base)
    mouth = loft(np.stack([np.column_stack([foot(0.38, 0.068), np.full(count, 0.0945 * k)]),
                           np.column_stack([foot(0.38, 0.068), np.full(count, 0.0958 * k)])]),
                 base)  # fmt: skip
    tongue = box(0.07 * k, 0.034 * k, 0.006).turn(1, -0.62).move(-0.018 * k, 0, 0.07 * k)
    laces = [tube([(x * k, -0.02 * k, z * k), (x * k, 0, (z + 0.006) * k),
                   (x * k, 0.02 * k, z * k)], 0.0026 * k, 6) for x,
             z in ((-0.046, 0.062), (-0.03, 0.071), (-0.014, 0.081), (0.002, 0.091))]  # fmt: skip
    stripe = [box(0.02 * k, 0.004, 0.035 * k).turn(1, 0.4).move((0.03 + 0.03 * n) * k, s * 0.0355
                                                                * k, 0.03 * k) for n in range(2)
              for s in (-1, 1)]  # fmt: skip
    pieces = [(sole, surfaces.plain(look.pick([(240, 240, 236), (240, 240, 236),
                                               tint_color(color, 0.6)]))), (upper, upper_tile),
              (mouth, surfaces.plain((46, 44, 46))),
              (join([tongue, *stripe]), surfaces.plain(other)),
              (join(laces), surfaces.plain((244, 244, 240)))]  # fmt: skip
    low = [hull_of(sole), hull_part(upper.vertices[upper.vertices[:, 2] < 0.065 * k]),
           hull_part(upper.vertices[upper.vertices[:, 2] > 0.055 * k])]  # fmt: skip
    return shape(pieces, low)


def _sole(grow: float = 1.0) -> np.ndarray:
    """Return the outline of a shoe sole, ``grow`` times 0.26 m long, with its toe on the left."""
    half = smooth([(-0.13, 0.0), (-0.115, 0.03), (-0.07, 0.046), (-0.01, 0.038), (0.05, 0.032),
                   (0.1, 0.034), (0.125, 0.02), (0.13, 0.0)], 2)  # fmt: skip
    curve = half * [1, 1] * grow
    return np.concatenate([curve * [1, -1], curve[::-1][1:-1]])


def _upper(levels: list[tuple[float, float, float, float]]) -> Solid:
    """Return a shoe's upper; ``levels`` lists (x scale, y scale, x shift, z) from bottom to top."""
    base = _sole()
    return loft(np.stack([np.column_stack([base * [a, b] + [x, 0], np.full(len(base), z)])
                          for a, b, x, z in levels]), base)  # fmt: skip


@category("boot", size=(0.213, 0.075, 0.158), mass=0.45, material="leather", aliases=("ankle boot",
          "leather boot", "hiking boot", "winter boot", "rain boot", "wellington boot",
          "cowboy boot", "work boot", "wellie", "welly", "gumboot"), themes=("living",),
          colors=("brown", "black"))  # fmt: skip
def boot(look: Look) -> Shape:
    """A laced, heeled ankle boot with its toe on the left."""
    color = look.color("brown", "black", "tan", "red", "olive", "navy", "yellow")
    k = look.between(0.75, 0.9)
    hide = leather(look.rng, color)
    sole = _upper([(0.99, 0.99, 0, 0), (1.0, 1.0, 0, 0.006), (1.0, 1.0, 0, 0.026)])
    foot = _upper([(0.96, 0.94, 0, 0.024), (0.93, 0.9, 0.004, 0.055), (0.72, 0.84, 0.03, 0.085),
                   (0.5, 0.82, 0.062, 0.11)])  # fmt: skip
    shaft = _upper([(0.5, 0.82, 0.062, 0.1), (0.47, 0.84, 0.066, 0.15), (0.5, 0.9, 0.064, 0.19),
                    (0.44, 0.78, 0.064, 0.192), (0.42, 0.74, 0.064, 0.17)])  # fmt: skip
    hole = _upper([(0.42, 0.74, 0.064, 0.188), (0.42, 0.74, 0.064, 0.1905)])
    laces = [rod([(-0.03 + 0.012 * n, -0.022, 0.08 + 0.017 * n),
                  (-0.035 + 0.012 * n, 0, 0.09 + 0.017 * n),
                  (-0.03 + 0.012 * n, 0.022, 0.08 + 0.017 * n)], 0.0032, 6)
             for n in range(4)]  # fmt: skip
    laces += [rod([(0.004, -0.026, 0.15 + 0.016 * n), (-0.002, 0, 0.154 + 0.016 * n),
                   (0.004, 0.026, 0.15 + 0.016 * n)], 0.0032, 6) for n in range(2)]  # fmt: skip
    pieces: Pieces = [(sole, surfaces.plain((62, 50, 42))), (join([foot, shaft]), hide),
                      (hole, surfaces.plain((40, 34, 32))),
                      (join(laces), surfaces.plain(look.own_color("yellow", "black", "white",
                                                                  "red")))]  # fmt: skip
    return put_down(pieces, sole, foot, shaft, factor=k)


@category("sandal", size=(0.237, 0.091, 0.0609), mass=0.18, material="leather",
          aliases=("flip flop", "flip-flop", "leather sandal", "beach sandal", "thong sandal",
          "flip-flops"), themes=("living",), colors=("brown", "red"))  # fmt: skip
def sandal(look: Look) -> Shape:
    """A sandal or flip-flop with its toe on the left."""
    color = look.color("brown", "tan", "red", "blue", "black", "teal", "pink", "yellow")
    sole = _upper([(0.98, 0.98, 0, 0), (1.0, 1.0, 0, 0.012), (0.99, 0.99, 0, 0.018)])
    bed = _upper([(0.93, 0.9, 0, 0.0175), (0.93, 0.9, 0, 0.0195)])
    strap = surfaces.plain(tint_color(color, 0.6) if sum(color) > 300 else (230, 210, 180))
    if look.chance(0.5):  # flip-flop
        bands = [rod([(-0.07, 0, 0.02), (-0.045, s * 0.012, 0.036), (0.0, s * 0.034, 0.032),
                      (0.03, s * 0.034, 0.016)], [0.0045, 0.006, 0.0065, 0.005], 8)
                 for s in (-1, 1)]  # fmt: skip
    else:
        bands = [rod([(x, -w, 0.014), (x, -0.7 * w, 0.04), (x, 0, 0.052), (x, 0.7 * w, 0.04),
                      (x, w, 0.014)], 0.008, 8).scale(1, 1, 1) for x,
                 w in ((-0.065, 0.044), (-0.02, 0.042))]  # fmt: skip
        bands.append(rod([(0.03, -0.033, 0.015), (0.07, -0.036, 0.06), (0.115, 0, 0.07),
                          (0.07, 0.036, 0.06), (0.03, 0.033, 0.015)], 0.006, 8))  # fmt: skip
    pieces: Pieces = [(sole, surfaces.speckles(look.rng, color, 5)),
                      (bed, surfaces.plain(tint_color(color, 1.25))),
                      (join(bands), strap)]  # fmt: skip
    return put_down(pieces, sole, join(bands), factor=look.between(0.75, 1.0))


@category("slipper", size=(0.235, 0.09, 0.058), mass=0.12, material="fabric",
          aliases=("house slipper", "house shoe", "bedroom slipper", "fluffy slipper",
          "glass slipper"), themes=("living",), colors=("pink", "gray"))  # fmt: skip
def slipper(look: Look) -> Shape:
    """A soft slipper, open at the heel."""
    color = look.color("pink", "gray", "navy", "red", "cream", "teal", "brown")
    plush = surfaces.scratches(look.rng, color, tint_color(color, 0.8), 120)
    sole = _upper([(0.97, 0.97, 0, 0), (1.0, 1.0, 0, 0.008), (0.98, 0.98, 0, 0.02)])
    bed = _upper([(0.92, 0.88, 0, 0.0195), (0.92, 0.88, 0, 0.0215)])
    cap = ball(0.14, 0.1, 0.095, (-0.062, 0, 0.016), 20)
    cap = cap.bend(
        lambda p: np.column_stack([np.minimum(p[:, 0], 0.0), p[:, 1], np.maximum(p[:, 2], 0.006)])
    )
    mouth = ball(0.006, 0.074, 0.062, (0.0, 0, 0.02), 16)
    mouth = mouth.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.02)]))
    rim = rod([(0.0, -0.045, 0.014), (0.0, -0.036, 0.046), (0, 0, 0.062), (0.0, 0.036, 0.046),
               (0.0, 0.045, 0.014)], 0.0075, 8)  # fmt: skip
    pieces: Pieces = [(sole, surfaces.plain(tint_color(color, 0.5))),
                      (bed, surfaces.plain(tint_color(color, 1.4))), (cap, plush),
                      (mouth, surfaces.plain((52, 44, 44))),
                      (rim, surfaces.plain((246, 242, 234)))]  # fmt: skip
    return put_down(pieces, sole, cap, factor=look.between(0.8, 1.0))


@category("high_heel", size=(0.21, 0.068, 0.11), mass=0.2, material="leather",
          aliases=("high heels", "stiletto", "high heeled shoe", "court shoe", "dress shoe",
          "ladies shoe", "high heel shoe"), themes=("living",),
          colors=("red", "black"))  # fmt: skip
def high_heel(look: Look) -> Shape:
    """A woman's high-heeled shoe with its toe on the left."""
    color = look.color("red", "black", "gold", "silver", "pink", "navy", "white")
    base = _sole()
    n = len(base)

    def arch(p: np.ndarray) -> np.ndarray:
        t = np.clip((p[:, 0] + 0.06) / 0.17, 0, 1)
        rise = 0.075 * t * t * (3 - 2 * t)
        return np.column_stack([p[:, 0] * 0.88, p[:, 1] * 0.85, p[:, 2] + rise])

    sole = loft(np.stack([np.column_stack([base * g, np.full(n, z)]) for g, z in (
        (0.97, 0), (1.0, 0.003), (1.0, 0.007))]), base).bend(arch)  # fmt: skip
    toe = ball(0.12, 0.078, 0.06, (-0.07, 0, 0.006), 18)
    toe = toe.bend(
        lambda p: np.column_stack([np.minimum(p[:, 0], -0.03), p[:, 1], np.maximum(p[:, 2], 0.004)])
    )
    heel_cup = [rod([(-0.02, s * 0.033, 0.02), (0.04, s * 0.029, 0.07), (0.09, s * 0.024, 0.1),
                     (0.112, 0, 0.112)], [0.004, 0.01, 0.016, 0.016], 8)
                for s in (-1, 1)]  # fmt: skip
    heel = rod([(0.094, 0, 0.08), (0.1, 0, 0.045), (0.098, 0, 0.0)], [0.018, 0.009, 0.006], 12)
    skin = surfaces.gradient(tint_color(color, 0.9), tint_color(color, 1.12), look.rng, 2)
    inner = loft(
        np.stack([np.column_stack([base * 0.85, np.full(n, z)]) for z in (0.0068, 0.0085)]), base
    )
    pieces: Pieces = [(join([sole, toe, *heel_cup, heel]), skin),
                      (inner.bend(arch), surfaces.plain((226, 200, 170)))]  # fmt: skip
    v = above(sole.vertices)
    return shape(
        pieces,
        [
            hull_part(above(np.concatenate([v[v[:, 0] < -0.02], toe.vertices]))),
            hull_part(v[v[:, 0] > -0.05]),
            hull_part(above(heel.vertices)),
            hull_part(join(heel_cup).vertices),
        ],
    ).scale(look.between(0.8, 0.95))
