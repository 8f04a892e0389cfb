"""Small jewellery: earrings, brooches, cufflinks, crowns, pocket watches."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part, ring_parts
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, ellipsoid, join, lathe, loft, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GEMS = ("red", "blue", "green", "purple", "teal", "white", "pink", "amber")


def _gold(look: Look, color: tuple[float, float, float]) -> textures.Tile:
    return textures.brushed_metal(look.rng, color)


def _gem(r: float, h: float, sides: int = 8) -> Solid:
    """Return a cut stone on z = 0: a girdle, a table on top."""
    return lathe([(0, 0), (0.55 * r, 0), (r, 0.45 * h), (0.6 * r, h), (0, h)], sides)


def earring(look: Look) -> Shape:
    """An earring lying: a hook, a ring and a drop of stone."""
    metal = _gold(look, look.color("gold", "silver", "copper"))
    stone = look.own_color(*GEMS)
    k = look.between(0.9, 1.4)
    hook = rod(
        [
            (0.012, 0, 0.001),
            (0.018, 0.006, 0.001),
            (0.027, 0.005, 0.001),
            (0.027, -0.004, 0.001),
            (0.018, -0.007, 0.001),
        ],
        0.0007,
        6,
    )
    ring = torus(0.003, 0.0007, 14, 6).move(0.0105, 0, 0.001)
    bezel = ellipsoid(0.019, 0.013, 0.004, 16, 8).move(-0.001, 0, 0.0018)
    drop = ellipsoid(0.015, 0.0095, 0.007, 10, 6).move(-0.001, 0, 0.0032)
    return put_down(
        [
            (join([hook, ring, bezel]), metal),
            (drop, textures.gradient(tint_color(stone, 0.8), tint_color(stone, 1.4), look.rng)),
        ],
        join([bezel, drop]),
        hook,
        factor=k,
    )


def brooch(look: Look) -> Shape:
    """A brooch lying: petals of gold round a stone, or a cameo."""
    color = look.color("gold", "silver", "copper", "bronze")
    stone = look.own_color(*GEMS)
    k = look.between(0.9, 1.3)
    petals = [ellipsoid(0.018, 0.012, 0.006, 10, 6).move(0.0135).turn(2, 2 * np.pi * n / 8)
              .move(z=0.0025) for n in range(8)]  # fmt: skip
    beads = [ball(0.0045, 0.0045, 0.0045, (0.0215 * np.cos(a), 0.0215 * np.sin(a), 0.0045), 8)
             for a in 2 * np.pi * np.arange(8) / 8]  # fmt: skip
    base = cylinder(0.013, 0.005, 22)
    heart = _gem(0.0095, 0.007, 10).move(z=0.0045)
    return put_down(
        [
            (join([*petals, base]), _gold(look, color)),
            (join(beads), textures.plain((246, 242, 234))),
            (heart, textures.plain(stone)),
        ],
        join([*petals, base]),
        heart,
        factor=k,
    )


def cufflink(look: Look) -> Shape:
    """A cufflink standing on its bar: a post, and a disc with a stone above."""
    color = look.color("silver", "gold", "black", "copper")
    k = look.between(0.9, 1.25)
    face = (cylinder(0.0085, 0.004, 22, bevel=0.0008) if look.chance(0.5) else
            block(0.015, 0.015, 0.004, 0.002, 0.0008))  # fmt: skip
    stone = cylinder(0.0062, 0.0012, 18).move(z=0.0035)
    post = straight((0, 0, -0.012), (0, 0, 0.001), 0.0017, 8)
    bar = straight((-0.0075, 0, -0.0125), (0.0075, 0, -0.0125), 0.0026, 10)
    whole = [(s.turn(0, 0.12), t) for s, t in (
        (join([face, post, bar]), _gold(look, color)), (stone, textures.plain(look.own_color(
            "black", "navy", "red", "green", "white"))))]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s, _ in whole)
    whole = [(s.move(z=-low - 0.0004), t) for s, t in whole]
    return put_down(whole, whole[0][0], factor=k, foot=0.3)


def tie_clip(look: Look) -> Shape:
    """A tie clip lying: two flat bars joined at one end."""
    color = look.color("silver", "gold", "black", "copper", "bronze")
    k = look.between(0.9, 1.25)
    low = block(0.052, 0.006, 0.0013, 0.001)
    up = block(0.055, 0.0065, 0.0016, 0.001, 0.0004).move(z=0.0032)
    bend_ = cylinder(0.0024, 0.006, 12).move(z=-0.003).turn(0, np.pi / 2).move(0.027, 0, 0.0024)
    gem = _gem(0.0018, 0.0014).move(-0.02, 0, 0.0047)
    return put_down(
        [(join([low, up, bend_]), _gold(look, color)), (gem, textures.plain((230, 240, 250)))],
        join([low, up]),
        factor=k,
    )


def pocket_watch(look: Look) -> Shape:
    """A pocket watch lying, its crown above, a chain curled beside it."""
    color = look.color("gold", "silver", "brass", "copper", "bronze")
    r = look.between(0.022, 0.027)
    case = lathe(
        [
            (0, 0),
            (0.75 * r, 0),
            (r, 0.005),
            (r, 0.008),
            (0.88 * r, 0.0115),
            (0.84 * r, 0.0105),
            (0, 0.0105),
        ],
        30,
    )
    face = cylinder(0.84 * r, 0.0006, 30).move(z=0.0104)
    dial = prints.clock_face(look.rng, look.pick([(246, 242, 230), (240, 240, 240)]), (40, 38, 40))
    crown = straight((0, r - 0.001, 0.0065), (0, r + 0.006, 0.0065), 0.003, 10)
    bow = torus(0.0055, 0.0011, 16, 6).move(0, r + 0.0095, 0.0065)
    links: list[Solid] = []
    path = np.array([(0.006 + 0.0042 * n, r + 0.012 - 0.00035 * n * n) for n in range(14)])
    for n, (x, y) in enumerate(path):
        links.append(torus(0.0024, 0.0008, 8, 4).turn(0, 0.5 if n % 2 else -0.2).move(x, y, 0.0016))
    return put_down([(join([case, crown, bow]), _gold(look, color)), (face, dial),
                    (join(links), _gold(look, tint_color(color, 0.92)))], case, join([crown, bow]),
                   join(links))  # fmt: skip


def crown(look: Look) -> Shape:
    """A crown or tiara standing: a band with points, balls and stones."""
    color = look.color("gold", "gold", "silver", "copper")
    r, h = look.between(0.06, 0.078), look.between(0.055, 0.075)
    n, count = 60, 10
    a = 2 * np.pi * np.arange(n) / n
    tip = 0.5 * h + 0.5 * h * np.abs(np.cos(count / 2 * a)) ** 3
    outer = np.column_stack([r * np.cos(a), r * np.sin(a)])
    grow = 1.14
    rings = [
        np.column_stack([outer, np.zeros(n)]),
        np.column_stack([outer * grow, tip]),
        np.column_stack([outer * (grow - 0.04), tip]),
        np.column_stack([outer * 0.96, np.zeros(n)]),
    ]
    wall = loft(np.stack(rings), None, loop=True)
    band = torus(r, 0.0035, 44, 8).move(z=0.004)
    rim = torus(1.045 * r, 0.0025, 44, 6).move(z=0.38 * h)
    pearls = [ball(0.009, 0.009, 0.009, (grow * r * np.cos(b), grow * r * np.sin(b), h + 0.002), 8)
              for b in 2 * np.pi * np.arange(count) / count]  # fmt: skip
    stones = [ball(0.011, 0.011, 0.014, (1.03 * r * np.cos(b), 1.03 * r * np.sin(b), 0.2 * h), 8)
              for b in 2 * np.pi * np.arange(count) / count]  # fmt: skip
    half = len(stones) // 2
    first, second = look.own_color("red", "purple"), look.own_color("blue", "green")
    ring = ring_parts([(r, 0), (grow * r, h)], [(1.08 * r, h), (0.955 * r, 0)], 12)
    return shape(
        [
            (join([wall, band, rim]), _gold(look, color)),
            (join(pearls), textures.plain((246, 242, 234))),
            (join(stones[:half]), textures.plain(first)),
            (join(stones[half:]), textures.plain(second)),
        ],
        ring,
    )


def pendant(look: Look) -> Shape:
    """A pendant on its chain lying: a heart, drop or disc with the chain in a loop."""
    color = look.color("gold", "silver", "copper")
    kind = look.pick(["heart", "gem", "disc"])
    a = np.linspace(np.pi / 2 + 0.35, 5 * np.pi / 2 - 0.35, 40)
    loop = np.column_stack([0.045 * np.cos(a), 0.055 * np.sin(a), np.full(40, 0.0012)])
    loop[:, 1] *= -1
    chain = tube(np.concatenate([[(0.0005, -0.0625, 0.0014)], loop, [(-0.0005, -0.0625, 0.0014)]]),
                 0.0011, 6)  # fmt: skip
    eye = torus(0.003, 0.0009, 14, 6).move(0, -0.064, 0.0014)
    if kind == "heart":
        t = np.linspace(0, 2 * np.pi, 30, endpoint=False)
        heart = np.column_stack([16 * np.sin(t) ** 3, 13 * np.cos(t) - 5 * np.cos(2 * t)
                                 - 2 * np.cos(3 * t) - np.cos(4 * t)]) * 0.0007  # fmt: skip
        charm = prism(heart[::-1], 0, 0.004).move(0, -0.079)
    elif kind == "gem":
        charm = _gem(0.011, 0.006, 8).scale(0.85, 1.2, 1).move(0, -0.081)
    else:
        charm = cylinder(0.0115, 0.0025, 26, bevel=0.0006).move(0, -0.0785)
    stone = textures.plain(look.own_color(*GEMS)) if kind != "disc" else _gold(look, color)
    v = chain.vertices
    k = look.between(0.9, 1.25)
    made = shape(
        [(join([chain, eye]), _gold(look, color)), (charm, stone)],
        [hull_part(v[v[:, 0] < 0]), hull_part(v[v[:, 0] > 0]), hull_part(charm.vertices)],
    )
    return made.scale(k)


CATEGORIES = (
    Category("earring", earring, (0.045, 0.016, 0.008), 0.004, ("ear ring", "gold earring",
             "drop earring", "pearl earring", "hoop earring", "stud earring",
             "nose stud", "body piercing", "belly bar"), ("vanity",), (),
             ("gold", "silver"), state="lying"),
    Category("brooch", brooch, (0.052, 0.052, 0.0125), 0.02, ("cameo", "pin badge", "badge",
             "broach", "flower brooch", "lapel pin", "fibula", "press pass", "enamel badge",
             "gold star sticker", "enamel pin", "aigrette"), ("vanity",), (), ("gold", "silver"),
             state="lying"),
    Category("cufflink", cufflink, (0.0169, 0.0172, 0.0211), 0.008, ("cuff link",), ("vanity",), (),
             ("silver", "gold"), state="lying"),
    Category("tie_clip", tie_clip, (0.059, 0.007, 0.0065), 0.008, ("tie pin", "tie bar",
             "tie clasp"), ("vanity",), (), ("silver", "gold"), state="lying"),
    Category("pocket_watch", pocket_watch, (0.088, 0.075, 0.0115), 0.09, ("pocketwatch",
             "fob watch", "watch on a chain", "antique watch",
             "watch movement", "nurse fob watch"), ("vanity", "office"), (),
             ("gold", "silver"), state="lying flat"),
    Category("crown", crown, (0.16, 0.16, 0.07), 0.15, ("tiara", "diadem", "golden crown",
             "gold crown", "king crown", "queen crown"), ("toys", "vanity"), (),
             ("gold",)),
    Category("pendant", pendant, (0.093, 0.149, 0.00421), 0.015, ("locket", "heart pendant",
             "necklace with a pendant", "pendant necklace", "amulet", "gold pendant", "charm",
             "talisman", "amber pendant", "om pendant", "silver cross"),
             ("vanity",), ("flat",), ("gold", "silver"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
