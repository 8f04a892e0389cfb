"""Sports kit of many kinds: skates, boards, goggles, clubs, stumps, pads, arrows."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import side_view
from ...build.outlines import ellipse
from ...build.recipes import ball, leather, pad, put_down, rod, straight
from ...build.shape import Shape
from ...build.sketch import DARK, bar, cut, disc, lies, plain, steel, turned
from ...build.solids import Solid, block, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")


def _boot(h: float) -> Solid:
    """Return a boot's upper from the side, toe towards +x, standing on z = 0."""
    rim = [(-0.055, 0), (0.085, 0), (0.1, 0.012), (0.095, 0.032), (0.045, 0.052), (0.018, 0.075),
           (0.01, h), (-0.052, h), (-0.058, 0.06)]  # fmt: skip
    return side_view(rim, 0.062)


def _laces(h: float) -> list[Solid]:
    return [bar(0.004, 0.04, 0.004, (0.05 - 0.0085 * n, 0, 0.049 + 0.0078 * n)) for n in range(5)]


def skateboard(look: Look) -> Shape:
    """A skateboard on its wheels, its ends turned up."""
    color = look.color("red", "black", "teal", "wooden", "orange", "purple")
    k = look.between(0.35, 0.5)
    x = np.array([-0.39, -0.3, -0.27, 0.27, 0.3, 0.39])
    z = np.array([0.13, 0.1, 0.092, 0.092, 0.1, 0.13])
    deck = side_view(
        np.concatenate([np.column_stack([x, z]), np.column_stack([x, z + 0.012])[::-1]]), 0.2
    )
    grip = bar(0.54, 0.196, 0.002, (0, 0, 0.1035))
    wheels = [disc(0.028, 0.03, (sx * 0.2, sy * 0.085 - 0.015, 0.028), 1, fine=18, bevel=0.004)
              for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    trucks = [bar(0.03, 0.14, 0.02, (s * 0.2, 0, 0.018)) for s in (-1, 1)]
    trucks += [bar(0.07, 0.05, 0.055, (s * 0.2, 0, 0.038)) for s in (-1, 1)]
    return put_down(
        [(deck, look.surface(color, "wood")), (grip, plain((46, 46, 50))), (join(wheels), plain(
            look.own_color("white", "yellow", "lime", "coral"))), (join(trucks), steel(look))],
        deck, *(join(wheels[i : i + 2]) for i in (0, 2)), factor=k)  # fmt: skip


def roller_skate(look: Look) -> Shape:
    """A laced boot on four wheels with a stopper at the toe."""
    color = look.color("white", "pink", "black", "sky", "red", "mint")
    k = look.between(0.95, 1.25)
    boot = _boot(0.13).move(z=0.062)
    sole, heel = (
        bar(0.155, 0.06, 0.008, (0.02, 0, 0.056)),
        bar(0.04, 0.056, 0.02, (-0.036, 0, 0.044)),
    )
    plate = bar(0.14, 0.04, 0.01, (0.015, 0, 0.04))
    wheels = [disc(0.024, 0.024, (x, s * 0.035 - 0.012, 0.024), 1, fine=18, bevel=0.004)
              for x in (-0.036, 0.062) for s in (-1, 1)]  # fmt: skip
    trucks = [bar(0.02, 0.06, 0.03, (x, 0, 0.018)) for x in (-0.036, 0.062)]
    stop = disc(0.014, 0.03, (0.092, 0, 0.016), top=0.01)
    laces = [one.move(z=0.064) for one in _laces(0)]
    tone = look.own_color("pink", "red", "yellow", "turquoise", "orange")
    return put_down(
        [
            (boot, leather(look.rng, color)),
            (join([sole, heel]), plain(tint_color(color, 0.6))),
            (join([plate, *trucks]), steel(look)),
            (join([*wheels, stop]), plain(tone)),
            (join(laces), plain((250, 248, 244))),
            (bar(0.046, 0.046, 0.0012, (-0.021, 0, 0.1915)), plain(DARK)),
        ],
        boot,
        join([plate, *wheels]),
        factor=k,
    )


def ice_skate(look: Look) -> Shape:
    """A laced boot on a steel blade, held up by its broad holder."""
    color = look.color("white", "black", "white", "navy")
    k = look.between(0.95, 1.25)
    boot = _boot(0.13).move(z=0.052)
    sole = bar(0.155, 0.058, 0.008, (0.02, 0, 0.046))
    blade = side_view([(-0.075, 0.006), (-0.07, 0), (0.105, 0), (0.122, 0.014), (0.11, 0.018),
                       (-0.075, 0.016)], 0.006)  # fmt: skip
    posts = [bar(0.03, 0.03, 0.034, (x, 0, 0.014)) for x in (-0.035, 0.065)]
    laces = [one.move(z=0.054) for one in _laces(0)]
    wide = bar(0.16, 0.05, 0.004, (0.02, 0, 0))
    return put_down(
        [
            (boot, leather(look.rng, color)),
            (sole, plain(tint_color(color, 0.55))),
            (join([blade, *posts]), steel(look)),
            (join(laces), plain((200, 202, 210))),
            (bar(0.046, 0.046, 0.0012, (-0.021, 0, 0.1815)), plain((70, 72, 80))),
        ],
        boot,
        blade,
        wide,
        factor=k,
    )


def goggles(look: Look) -> Shape:
    """Swimming goggles lying: two lenses, a nose piece and a strap behind."""
    color = look.color(*BRIGHT)
    k = look.between(0.9, 1.15)
    cups, lenses = [], []
    for s in (-1, 1):
        cups.append(
            torus(0.0225, 0.006, 24, 8)
            .scale(1.25, 0.9, 1.6)
            .turn(0, 0.85)
            .move(s * 0.035, -0.02, 0.018)
        )
        lenses.append(
            cut(ellipse(0.054, 0.038, 22), 0.004, (0, 0, 0.003))
            .turn(0, 0.85)
            .move(s * 0.035, -0.021, 0.018)
        )
    nose = bar(0.02, 0.008, 0.006, (0, -0.024, 0.018))
    a = np.linspace(0.15, np.pi - 0.15, 18)
    path = np.column_stack([0.068 * np.cos(a), -0.01 + 0.075 * np.sin(a), 0.013 + 0 * a])
    path = np.concatenate([[(0.06, -0.022, 0.018)], path, [(-0.06, -0.022, 0.018)]])
    strap = [
        tube(path, 0.0025, 8),
        tube(path - np.array([0, 0, 0.006]), 0.0025, 8),
        tube(path - np.array([0, 0, 0.0105]), 0.0025, 8),
    ]
    tint = look.pick([(150, 190, 210), (90, 100, 120), (220, 170, 90)])
    return put_down(
        [
            (join([*cups, nose]), plain(color)),
            (join(lenses), textures.gradient(tint, tint_color(tint, 1.5), look.rng)),
            (join(strap), plain(tint_color(color, 0.7))),
        ],
        *cups,
        join(strap),
        factor=k,
    )


def snorkel(look: Look) -> Shape:
    """A snorkel lying: a bent tube with a mouthpiece and a bright end."""
    color = look.color("blue", "black", "yellow", "green", "orange")
    k = look.between(0.85, 1.1)
    pipe = rod([(0.2, 0, 0.012), (0.0, 0.0, 0.012), (-0.12, 0, 0.012), (-0.17, 0.03, 0.012),
                (-0.15, 0.075, 0.012)], 0.0115, 14, 6)  # fmt: skip
    end = disc(0.0135, 0.03, (0.19, 0, 0.0135), 0, fine=16)
    mouth = pad(0.05, 0.026, 0.016, 0.008).move(-0.148, 0.082, 0.006)
    clip = torus(0.0125, 0.004, 18, 6).turn(1, np.pi / 2).move(0.02, 0, 0.0135)
    return put_down(
        [(pipe, plain(color)), (end, plain((240, 120, 40))), (join([mouth, clip]), plain(DARK))],
        straight((0.2, 0, 0.012), (-0.12, 0, 0.012), 0.0115, 12),
        mouth,
        pipe,
        factor=k,
        foot=0.3,
    )


def golf_club(look: Look) -> Shape:
    """A short club lying: head, shaft and grip."""
    color = look.color("silver", "black", "gold", "charcoal")
    k = look.between(0.4, 0.5)
    shaft = straight((-0.32, 0, 0.012), (0.42, 0, 0.012), [0.006, 0.0075], 10)
    grip = straight((0.2, 0, 0.012), (0.43, 0, 0.012), [0.0105, 0.0125], 12)
    if look.chance(0.5):
        head = cut(
            [(-0.36, -0.1), (-0.31, -0.1), (-0.305, 0.012), (-0.335, 0.014)], 0.03, (0, 0, 0), 0.004
        )
    else:
        head = ball(0.09, 0.12, 0.06, (-0.34, -0.045, 0.028), 18)
    neck = straight((-0.325, 0, 0.012), (-0.3, 0, 0.012), 0.0095, 10)
    return put_down(
        [
            (shaft, steel(look)),
            (grip, textures.scratches(look.rng, (44, 44, 48), (90, 90, 94), 60)),
            (join([head, neck]), look.surface(color, "metal")),
        ],
        shaft,
        grip,
        head,
        factor=k,
        foot=0.3,
    )


def cricket_stumps(look: Look) -> Shape:
    """Three stumps in a base with two bails on them."""
    color = look.color("wooden", "tan", "yellow", "red", "blue")
    k = look.between(0.85, 1.15)
    base = block(0.1, 0.05, 0.014, 0.006, 0.003)
    stumps = [disc(0.006, 0.2, (x, 0, 0.012), fine=14) for x in (-0.034, 0, 0.034)]
    bails = [
        straight((x - 0.017, 0, 0.2135), (x + 0.017, 0, 0.2135), 0.003, 8) for x in (-0.018, 0.018)
    ]
    wood = look.surface(color, "wood")
    return put_down(
        [
            (base, plain(look.own_color("black", "green", "charcoal"))),
            (join([*stumps, *bails]), wood),
        ],
        base,
        join(stumps),
        factor=k,
    )


def foam_roller(look: Look) -> Shape:
    """A ribbed foam roller standing on its end."""
    color = look.color("black", "teal", "purple", "orange", "blue", "gray")
    k = look.between(0.8, 1.15)
    outer = [(0.058, 0), (0.06, 0.004)]
    for n in range(5):
        z = 0.02 + 0.05 * n
        outer += [(0.062, z), (0.062, z + 0.034), (0.057, z + 0.037), (0.057, z + 0.047)]
    outer += [(0.062, 0.27), (0.058, 0.276)]
    body = lathe([(0, 0), *outer, (0.042, 0.276), (0.042, 0.262), (0, 0.262)], 30)
    inner = disc(0.041, 0.0008, (0, 0, 0.2616))
    return put_down(
        [(body, textures.speckles(look.rng, color, 8)), (inner, plain(DARK))], body, factor=k
    )


def resistance_band(look: Look) -> Shape:
    """A flat loop of rubber lying in a soft oval."""
    color = look.color(*BRIGHT)
    k = look.between(0.8, 1.2)
    a = np.linspace(0, 2 * np.pi, 41)[:-1]
    wave = look.between(0.0, 0.2)
    r = 1 + wave * np.cos(2 * a + 0.5) + 0.5 * wave * np.cos(3 * a)
    path = np.column_stack([0.09 * r * np.cos(a), 0.06 * r * np.sin(a), 0.0125 + 0 * a])
    ring = tube(path, 0.0024, 8, loop=True, squash=5.2)
    bits = [tube(np.roll(path, -5 * n, 0)[:7], 0.0024, 8, squash=5.2) for n in range(8)]
    return put_down([(ring, textures.speckles(look.rng, color, 4))], *bits, factor=k)


def knee_pad(look: Look) -> Shape:
    """A padded guard with a hard cap and two straps, lying."""
    color = look.color("black", "navy", "red", "charcoal", "pink")
    k = look.between(0.85, 1.15)
    body = pad(0.13, 0.18, 0.04, 0.05, soft=0.8)
    cap = turned(
        [(0.045, 0), (0.044, 0.01), (0.034, 0.022), (0.014, 0.029)], (0, 0, 0.036), 22
    ).scale(1, 1.25, 1)
    straps = [bar(0.19, 0.03, 0.006, (0, s * 0.055, 0.012)) for s in (-1, 1)]
    cuts = [bar(0.05, 0.006, 0.004, (0, y, 0.0635)) for y in (-0.012, 0.012)]
    return put_down(
        [
            (body, textures.fabric(look.rng, color)),
            (cap, plain(tint_color(color, 0.7) if sum(color) > 250 else (90, 92, 98))),
            (join([*straps, *cuts]), plain(DARK)),
        ],
        body,
        cap,
        *straps,
        factor=k,
    )


def juggling_club(look: Look) -> Shape:
    """A juggling club lying, with coloured rings."""
    color = look.color("red", "blue", "yellow", "green", "pink", "orange", "white")
    k = look.between(0.75, 1.0)
    profile = [
        (0.011, 0),
        (0.016, 0.008),
        (0.012, 0.02),
        (0.011, 0.1),
        (0.02, 0.16),
        (0.042, 0.26),
        (0.043, 0.31),
        (0.03, 0.38),
        (0.018, 0.4),
    ]
    bands = textures.stack(
        (plain((240, 240, 236)), 0.3),
        (plain(color), 0.42),
        (plain(tint_color(color, 0.6)), 0.06),
        (plain((244, 240, 230)), 0.22),
    )
    body = lies(turned(profile, fine=22), -0.2, 0, 0.04)
    knob = ball(0.03, 0.03, 0.03, (-0.196, 0, 0.014), 12)
    body = body.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] - 0.024 * np.clip((0.06 - p[:, 0]) / 0.26, 0, 1)]
        )
    )
    return put_down([(body, bands), (knob, plain((60, 60, 64)))], body, knob, factor=k, foot=0.16)


def beanbag(look: Look) -> Shape:
    """A small square beanbag, plump, for throwing."""
    color = look.color(*BRIGHT)
    k = look.between(0.8, 1.2)
    body = pad(0.1, 0.1, 0.034, 0.022, soft=0.95)
    seam = [bar(0.098, 0.0015, 0.002, (0, 0, 0.0332)), bar(0.0015, 0.098, 0.002, (0, 0, 0.0332))]
    quarter = bar(0.03, 0.03, 0.001, (0.02, 0.02, 0.0333))
    return put_down(
        [
            (body, textures.fabric(look.rng, color)),
            (join(seam), plain(tint_color(color, 0.6))),
            (quarter, plain(look.own_color("white", "yellow", "teal"))),
        ],
        body,
        factor=k,
    )


def arrow(look: Look) -> Shape:
    """An arrow lying: shaft, point and three feathers."""
    color = look.color("red", "yellow", "green", "white", "blue", "orange")
    k = look.between(0.45, 0.62)
    shaft = straight((-0.32, 0, 0.009), (0.34, 0, 0.009), 0.0042, 10)
    tip = lies(turned([(0.0055, 0), (0.0055, 0.02), (0.0008, 0.045)], fine=12), 0.33, 0, 0.009)
    vane = [(-0.31, 0.003), (-0.23, 0.003), (-0.25, 0.016), (-0.315, 0.02)]
    vanes = [
        cut(np.array(vane) * [1, t] if t > 0 else (np.array(vane) * [1, t])[::-1], 0.0012)
        .turn(0, t * lean)
        .move(z=0.009)
        for t, lean in ((1, 0.3), (-1, 0.3), (1, 1.57))
    ]
    nock = disc(0.005, 0.014, (-0.334, 0, 0.009), 0, fine=10)
    return put_down(
        [
            (shaft, textures.wood(look.rng, (206, 168, 112))),
            (tip, steel(look)),
            (join(vanes), plain(color)),
            (nock, plain(tint_color(color, 0.7))),
        ],
        straight((-0.33, 0, 0.0085), (0.37, 0, 0.0085), 0.0045, 8),
        join(vanes),
        factor=k,
        foot=0.5,
    )


def quiver(look: Look) -> Shape:
    """A leather quiver standing, with a few arrows in it."""
    color = look.color("brown", "tan", "black", "maroon")
    k = look.between(0.85, 1.15)
    body = disc(0.032, 0.17, top=0.04)
    bands = [
        disc(0.0345 + 0.001 * n, 0.012, (0, 0, 0.012 + 0.138 * n), top=0.035 + 0.006 * n)
        for n in range(2)
    ]
    hole = disc(0.036, 0.0008, (0, 0, 0.1698))
    strap = rod([(0.034, 0, 0.02), (0.06, 0, 0.06), (0.062, 0, 0.12), (0.04, 0, 0.155)], 0.005, 8)
    shafts, vanes = [], []
    for n in range(4):
        x, y = 0.016 * np.cos(1.7 * n), 0.016 * np.sin(1.7 * n)
        shafts.append(straight((x, y, 0.16), (1.5 * x, 1.5 * y, 0.24), 0.0028, 8))
        vanes += [
            bar(0.022, 0.0015, 0.034, (1.4 * x, 1.4 * y, 0.2)).turn(2, 0.0),
            bar(0.0015, 0.022, 0.034, (1.4 * x, 1.4 * y, 0.2)),
        ]
    return put_down(
        [
            (body, leather(look.rng, color)),
            (join([*bands, strap]), leather(look.rng, tint_color(color, 0.6))),
            (hole, plain(DARK)),
            (join(shafts), plain((206, 168, 112))),
            (join(vanes), plain(look.own_color("red", "white", "yellow", "green"))),
        ],
        body,
        strap,
        join(shafts),
        factor=k,
    )


def foam_finger(look: Look) -> Shape:
    """A big foam hand with one finger up, lying."""
    color = look.color("blue", "red", "green", "yellow", "purple")
    k = look.between(0.8, 1.1)
    rim = [
        (-0.055, -0.12),
        (0.055, -0.12),
        (0.065, 0.0),
        (0.06, 0.05),
        (0.02, 0.06),
        (0.02, 0.15),
        (0.005, 0.17),
        (-0.014, 0.15),
        (-0.02, 0.04),
        (-0.05, 0.03),
        (-0.085, 0.045),
        (-0.09, 0.025),
        (-0.06, -0.02),
    ]
    hand = cut(rim, 0.024)
    face = prints.canvas(128, 96, color)
    prints.write(face, look.pick(["No. 1", "GO!", "#1"]), 0.5, 0.5, 0.5, (250, 246, 230), bold=True)
    badge = bar(0.09, 0.06, 0.001, (0, -0.06, 0.0236))
    lines = [bar(0.003, 0.05, 0.001, (0.02 + 0.016 * n, 0.02, 0.0236)) for n in range(2)]
    return put_down(
        [
            (hand, textures.speckles(look.rng, color, 4)),
            (badge, face),
            (join(lines), plain(tint_color(color, 0.5))),
        ],
        hand,
        factor=k,
    )


CATEGORIES = (
    Category("skateboard", skateboard, (0.322, 0.0825, 0.0586), 0.4,
             ("toy skateboard", "fingerboard", "mini skateboard", "longboard", "finger skateboard"),
             ("sports", "toys"), ("support",), ("red", "black")),
    Category("roller_skate", roller_skate, (0.181, 0.103, 0.21), 0.8,
             ("rollerskate", "rollerblade", "inline skate", "quad skate"), ("sports",), ("big",),
             ("white", "pink")),
    Category("ice_skate", ice_skate, (0.212, 0.0668, 0.196), 0.7, ("figure skate", "skate",
             "hockey skate"),
             ("sports",), ("big",), ("white",)),
    Category("goggles", goggles, (0.144, 0.114, 0.0369), 0.05,
             ("swim goggles", "diving goggles", "ski goggles"), ("sports",),
             (), ("blue", "black")),
    Category("snorkel", snorkel, (0.402, 0.111, 0.0297), 0.15, ("snorkel tube", "diving snorkel"),
             ("sports",), ("big",), ("blue",)),
    Category("golf_club", golf_club, (0.375, 0.0543, 0.0222), 0.25,
             ("golf putter", "putter", "golf iron", "golf driver", "mini golf club",
             "toy golf club"),
             ("sports",), ("big",), ("silver",)),
    Category("cricket_stumps", cricket_stumps, (0.108, 0.0542, 0.235), 0.2,
             ("cricket stump", "wicket", "cricket wicket", "cricket bail", "set of stumps"),
             ("sports",), ("tall",), ("wooden",)),
    Category("foam_roller", foam_roller, (0.119, 0.119, 0.266), 0.3, ("massage roller",
             "fitness roller", "exercise roller"),
             ("sports",), ("tall", "round"), ("black", "blue")),
    Category("resistance_band", resistance_band, (0.185, 0.111, 0.0234), 0.04,
             ("exercise band", "loop band", "workout band"), ("sports",), (),
             ("red", "blue")),
    Category("knee_pad", knee_pad, (0.184, 0.174, 0.0653), 0.15,
             ("kneepad", "elbow pad", "shin pad", "shin guard", "shinpad", "arm guard",
             "protective pad", "wrist guard"),
             ("sports",), (), ("black",)),
    Category("juggling_club", juggling_club, (0.348, 0.0728, 0.0699), 0.2, ("juggling pin",
             "indian club", "exercise club"),
             ("sports", "toys"), ("big",), ("red", "blue")),
    Category("beanbag", beanbag, (0.0997, 0.0997, 0.0351), 0.12,
             ("bean bag", "hacky sack", "juggling beanbag", "juggling bag", "cornhole bag",
             "sandbag", "small sandbag"),
             ("sports", "toys"), (), ("red", "blue")),
    Category("arrow", arrow, (0.381, 0.0205, 0.0137), 0.03, ("archery arrow", "wooden arrow",
             "crossbow bolt"),
             ("sports",), ("big",), ("red", "yellow")),
    Category("quiver", quiver, (0.115, 0.0854, 0.25), 0.3, ("arrow quiver", "quiver of arrows"),
             ("sports",), ("tall",), ("brown",)),
    Category("foam_finger", foam_finger, (0.149, 0.279, 0.0237), 0.06, ("foam hand", "fan finger",
             "giant foam finger"),
             ("sports",), ("flat", "big"), ("blue", "red")),
)  # fmt: skip
"""The module's categories."""
