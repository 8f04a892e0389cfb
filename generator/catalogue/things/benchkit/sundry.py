"""Devices and props of several kinds: megaphones, clapperboards, camcorders, phone cases."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.outlines import rectangle
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.sketch import BRASS, DARK, bar, cut, disc, lies, plain, steel, turned, vessel
from ...build.solids import block, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def megaphone(look: Look) -> Shape:
    """A megaphone lying on its grip."""
    color = look.color("white", "red", "yellow", "blue", "black")
    k = look.between(0.8, 1.05)
    flare = [(0.024, 0), (0.026, 0.09), (0.05, 0.16), (0.088, 0.2)]
    horn = lathe([(0, 0), *flare, *[(r - 0.004, z) for r, z in flare[::-1]][:-1], (0, 0.02)], 28)
    horn = lies(horn, -0.06, 0, 0.087)
    back = disc(0.034, 0.05, (-0.1, 0, 0.087), 0, fine=22)
    rim = torus(0.087, 0.005, 30, 6).turn(1, np.pi / 2).move(0.139, 0, 0.087)
    grip = bar(0.03, 0.024, 0.075, (-0.055, 0, 0))
    tone = look.own_color("red", "black", "gray")
    return put_down([(horn, plain(color)), (join([back, rim]), plain(tone)), (grip, plain(DARK))],
                    horn, back, grip, factor=k)  # fmt: skip


def clapperboard(look: Look) -> Shape:
    """A film clapperboard lying, its striped clapper a little open."""
    k = look.between(0.75, 0.95)
    color = look.color("black", "charcoal", "white")
    board = block(0.26, 0.18, 0.008, 0.003)
    ink = (240, 240, 236) if sum(color) < 400 else (40, 40, 44)
    face = prints.canvas(208, 144, color)
    for n, word in enumerate(("SCENE", "TAKE", "ROLL")):
        prints.write(face, word, 0.18 + 0.32 * n, 0.28, 0.09, ink)
        prints.write(
            face, str(int(look.rng.integers(1, 30))), 0.18 + 0.32 * n, 0.44, 0.17, ink, bold=True
        )
    prints.fill(face, 0.03, 0.6, 0.94, 0.015, ink)
    prints.write(face, look.pick(["DIRECTOR", "PRODUCTION", "CAMERA"]), 0.5, 0.76, 0.1, ink)
    sheet = bar(0.255, 0.175, 0.0008, (0, 0, 0.0077))
    stripes = textures.stripes([(244, 244, 240), (26, 26, 28)], 6, upright=True)
    low = bar(0.26, 0.03, 0.012, (0, 0.105, 0))
    high = bar(0.26, 0.03, 0.012, (0.13, 0, 0)).turn(2, 0.18).move(-0.13, 0.128, 0)
    return put_down(
        [(board, plain(color)), (sheet, face), (join([low, high]), stripes)],
        board,
        low,
        high,
        factor=k,
    )


def camcorder(look: Look) -> Shape:
    """A camcorder with its screen folded out."""
    color = look.color("black", "silver", "charcoal", "white")
    k = look.between(0.85, 1.1)
    body = block(0.12, 0.055, 0.062, 0.016, 0.008)
    lens = [disc(0.024, 0.03, (0.05, 0, 0.034), 0), disc(0.018, 0.001, (0.0795, 0, 0.034), 0)]
    screen = bar(0.07, 0.006, 0.045, (0.0, -0.062, 0.01)).turn(2, 0.0)
    hinge = bar(0.012, 0.04, 0.03, (0.038, -0.04, 0.016))
    view = bar(0.062, 0.0012, 0.037, (0.0, -0.0655, 0.014))
    strap = rod(
        [(0.04, 0.027, 0.035), (0.02, 0.05, 0.035), (-0.03, 0.05, 0.035), (-0.05, 0.027, 0.035)],
        0.006,
        8,
    )
    button = disc(0.007, 0.004, (-0.045, 0, 0.061))
    return put_down(
        [
            (join([body, hinge, screen]), look.surface(color, "plastic")),
            (lens[0], plain(DARK)),
            (lens[1], plain((60, 70, 110))),
            (view, plain((60, 110, 150))),
            (strap, plain((52, 52, 56))),
            (button, plain((210, 40, 40))),
        ],
        body,
        lens[0],
        join([screen, hinge]),
        strap,
        factor=k,
    )


def phone_case(look: Look) -> Shape:
    """A phone case lying on its rims, its back up, with a cut-out for the cameras."""
    color = look.color("pink", "black", "sky", "mint", "red", "lavender", "clear")
    k = look.between(0.92, 1.08)
    back = block(0.148, 0.073, 0.01, 0.01, 0.003)
    hole = cut(rectangle(0.034, 0.034, 0.008), 0.0006, (-0.05, 0.014, 0.0097))
    rim = cut(rectangle(0.038, 0.038, 0.01), 0.0012, (-0.05, 0.014, 0.0092))
    image = textures.speckles(look.rng, color, 4).copy()
    spots = []
    if look.chance(0.6):
        tone = look.own_color("white", "coral", "navy", "mustard")
        spots = [
            disc(
                look.between(0.003, 0.007),
                0.0006,
                (look.between(-0.02, 0.06), look.between(-0.026, 0.026), 0.0097),
                fine=14,
            )
            for _ in range(9)
        ]
        return put_down(
            [
                (back, image),
                (rim, plain(tint_color(color, 0.7))),
                (hole, plain((40, 42, 46))),
                (join(spots), plain(tone)),
            ],
            back,
            factor=k,
        )
    return put_down(
        [(back, image), (rim, plain(tint_color(color, 0.7))), (hole, plain((40, 42, 46)))],
        back,
        factor=k,
    )


def earbud(look: Look) -> Shape:
    """A wireless earbud lying: a bud with a soft tip and a stem."""
    color = look.color("white", "black", "white", "pink", "silver")
    k = look.between(0.9, 1.25)
    bud = ball(0.018, 0.016, 0.016, (0.012, 0, 0.0075), 16)
    tip = ball(0.011, 0.012, 0.011, (0.02, 0.005, 0.0085), 12)
    stem = rod(
        [(0.008, 0, 0.006), (-0.006, 0, 0.0042), (-0.022, 0, 0.0032)], [0.0042, 0.0034, 0.003], 10
    )
    end = disc(0.0032, 0.0015, (-0.0235, 0, 0.0032), 0, fine=10)
    return put_down(
        [
            (join([bud, stem]), plain(color)),
            (tip, plain(tint_color(color, 0.8))),
            (end, steel(look)),
        ],
        bud,
        stem,
        factor=k,
        foot=0.25,
    )


def conference_phone(look: Look) -> Shape:
    """A conference phone: a three-armed body with a speaker, keys and a small screen."""
    color = look.color("charcoal", "black", "gray", "white")
    k = look.between(0.8, 1.0)
    a = np.linspace(0, 2 * np.pi, 61)[:-1]
    r = 0.1 + 0.035 * np.cos(3 * (a - np.pi / 2)) ** 3
    rim = np.column_stack([r * np.cos(a), r * np.sin(a)])
    body, top = cut(rim, 0.02), cut(0.82 * rim, 0.016, (0, 0, 0.019))
    grille = disc(0.042, 0.006, (0, 0.005, 0.034), fine=28)
    keys = [
        bar(0.01, 0.007, 0.003, (-0.013 + 0.013 * (n % 3), -0.052 - 0.0095 * (n // 3), 0.0345))
        for n in range(6)
    ]
    screen = bar(0.038, 0.018, 0.0014, (0, 0.062, 0.0346))
    lamps = [
        disc(0.0035, 0.002, (0.082 * np.cos(q), 0.082 * np.sin(q), 0.034))
        for q in np.pi / 2 + np.arange(3) * 2.0944
    ]
    return put_down(
        [
            (body, plain(tint_color(color, 0.8))),
            (top, textures.speckles(look.rng, color, 3)),
            (grille, prints.mesh_holes((84, 86, 92), (30, 30, 34))),
            (join(keys), plain((206, 208, 212))),
            (screen, plain((120, 180, 200))),
            (join(lamps), plain((80, 200, 110))),
        ],
        body,
        top,
        factor=k,
    )


def audio_interface(look: Look) -> Shape:
    """An audio interface: a flat box with sockets and knobs at its front."""
    color = look.color("red", "black", "silver", "charcoal")
    k = look.between(0.85, 1.1)
    body = block(0.18, 0.1, 0.045, 0.006, 0.003)
    front = bar(0.172, 0.002, 0.037, (0, -0.0505, 0.004))
    jacks = [disc(0.0105, 0.004, (x, -0.0545, 0.022), 1) for x in (-0.066, -0.008)]
    knobs = [disc(0.009, 0.013, (x, -0.0635, 0.024), 1) for x in (-0.038, 0.02)]
    big = disc(0.014, 0.014, (0.056, -0.0645, 0.022), 1)
    rings = [
        torus(0.0105, 0.0012, 18, 5).turn(0, np.pi / 2).move(x, -0.0515, 0.024)
        for x in (-0.038, 0.02)
    ]
    return put_down(
        [
            (body, look.surface(color, "metal")),
            (front, plain((34, 34, 38))),
            (join(jacks), plain((120, 122, 128))),
            (join([*knobs, big]), steel(look)),
            (join(rings), plain((90, 210, 110))),
        ],
        body,
        join([*knobs, big]),
        factor=k,
    )


def amphora(look: Look) -> Shape:
    """An amphora on a small foot, with two handles and a painted band."""
    color = look.color("terracotta", "tan", "brown", "cream")
    k = look.between(0.85, 1.1)
    side = [
        (0.032, 0),
        (0.026, 0.01),
        (0.03, 0.03),
        (0.062, 0.09),
        (0.068, 0.125),
        (0.052, 0.165),
        (0.022, 0.185),
        (0.019, 0.215),
        (0.028, 0.226),
    ]
    pot = turned([*side, (0.022, 0.226)], fine=28)
    mouth = disc(0.02, 0.0008, (0, 0, 0.2256))
    handles = [
        rod(
            [
                (s * 0.02, 0, 0.212),
                (s * 0.052, 0, 0.214),
                (s * 0.062, 0, 0.185),
                (s * 0.054, 0, 0.155),
            ],
            0.0058,
            8,
        )
        for s in (-1, 1)
    ]
    image = textures.speckles(look.rng, color, 8, 128).copy()
    ink = look.own_color("black", "brown", "navy")
    for v, h in ((0.02, 0.02), (0.4, 0.02), (0.56, 0.02), (0.72, 0.05)):
        prints.fill(image, 0, v, 1, h, ink)
    prints.stroke(image, [(n / 16, 0.49 + 0.035 * (-1) ** n) for n in range(17)], 0.02, ink)
    return put_down(
        [
            (pot, image),
            (mouth, plain((50, 36, 30))),
            (join(handles), plain(tint_color(color, 0.8))),
        ],
        pot,
        *handles,
        factor=k,
    )


def butter_churn(look: Look) -> Shape:
    """A butter churn: a staved tub with hoops and a plunger through its lid."""
    color = look.color("wooden", "tan", "brown")
    k = look.between(0.8, 1.05)
    tub = turned([(0.07, 0), (0.056, 0.18), (0.054, 0.18)], fine=20)
    hoops = [
        turned([(r, 0), (r - 0.0012, 0.014)], (0, 0, z), 20)
        for r, z in ((0.0705, 0.02), (0.0645, 0.09), (0.0595, 0.15))
    ]
    lid, stick = disc(0.058, 0.014, (0, 0, 0.178)), disc(0.008, 0.12, (0, 0, 0.19), fine=12)
    staves = textures.stripes(
        [color, tint_color(color, 0.82), tint_color(color, 1.12)], 6, upright=True
    )
    return put_down(
        [
            (tub, staves),
            (join(hoops), steel(look, (120, 110, 100))),
            (join([lid, stick]), textures.wood(look.rng, color)),
        ],
        tub,
        lid,
        stick,
        factor=k,
    )


def gnome(look: Look) -> Shape:
    """A garden gnome with a pointed hat and a white beard."""
    color = look.color("red", "blue", "green", "red")
    k = look.between(0.85, 1.15)
    coat = turned([(0.038, 0.014), (0.042, 0.03), (0.036, 0.075), (0.024, 0.09)], fine=22)
    feet = [ball(0.034, 0.05, 0.028, (s * 0.018, -0.012, 0.012), 12) for s in (-1, 1)]
    belt = turned([(0.0415, 0), (0.041, 0.01)], (0, 0, 0.045), 22)
    head = ball(0.05, 0.048, 0.046, (0, 0, 0.104), 16)
    nose = ball(0.016, 0.016, 0.015, (0, -0.026, 0.104), 10)
    beard = ball(0.05, 0.03, 0.06, (0, -0.018, 0.082), 14)
    hat = turned([(0.03, 0), (0.031, 0.006), (0.016, 0.045), (0.002, 0.085)], (0, 0.002, 0.114), 20)
    arms = [
        rod(
            [(s * 0.028, 0, 0.083), (s * 0.045, -0.008, 0.06), (s * 0.03, -0.032, 0.055)], 0.0105, 8
        )
        for s in (-1, 1)
    ]
    eyes = [ball(0.005, 0.004, 0.006, (s * 0.01, -0.0225, 0.111), 6) for s in (-1, 1)]
    tone = look.own_color("blue", "green", "mustard", "brown", "teal")
    return put_down(
        [
            (join([coat, *arms]), plain(tone)),
            (join([*feet, belt, *eyes]), plain((50, 40, 36))),
            (join([head, nose]), plain((240, 196, 164))),
            (beard, plain((244, 242, 236))),
            (hat, textures.speckles(look.rng, color, 4)),
        ],
        join(feet),
        coat,
        head,
        hat,
        factor=k,
        foot=0.3,
    )


def potty(look: Look) -> Shape:
    """A child's potty with a raised back, open above."""
    color = look.color("blue", "pink", "green", "white", "yellow")
    k = look.between(0.75, 0.95)
    profile = [(0.1, 0), (0.098, 0.01), (0.09, 0.09), (0.12, 0.125), (0.125, 0.13)]
    back = (
        cut([(-0.07, 0), (0.07, 0), (0.05, 0.07), (0, 0.085), (-0.05, 0.07)], 0.012)
        .turn(0, np.pi / 2)
        .move(0, 0.118, 0.12)
    )
    return vessel(
        profile,
        0.02,
        0.02,
        plain(color),
        extra=[(back, plain(tint_color(color, 0.85)))],
        bodies=[back],
        factor=k,
    )


def volcano(look: Look) -> Shape:
    """A model volcano with lava running down its sides."""
    color = look.color("brown", "charcoal", "gray", "terracotta")
    k = look.between(0.85, 1.15)
    cone = turned([(0.11, 0), (0.1, 0.008), (0.062, 0.06), (0.032, 0.115), (0.022, 0.115)], fine=26)
    pool = disc(0.026, 0.004, (0, 0, 0.113))
    streams = []
    for n in range(6):
        a = 1.05 * n + look.between(-0.2, 0.2)
        long = look.between(0.35, 0.9)
        path = [
            (0.024, 0, 0.117),
            (0.036, 0, 0.111),
            (0.036 + 0.034 * long, 0, 0.111 - 0.06 * long),
            (0.036 + 0.055 * long, 0, 0.111 - 0.088 * long),
        ]
        streams.append(rod(path, [0.007, 0.007, 0.006, 0.008], 8).turn(2, a))
    base = disc(0.125, 0.008, fine=32)
    return put_down(
        [
            (cone, textures.spots(look.rng, color, tint_color(color, 0.6), 0.25)),
            (base, plain((96, 140, 70))),
            (join([pool, *streams]), textures.gradient((200, 40, 24), (250, 160, 40), look.rng)),
        ],
        base,
        cone,
        factor=k,
    )


def table_easel(look: Look) -> Shape:
    """A small table easel standing, empty, with a ledge."""
    color = look.color("wooden", "tan", "brown", "white", "black")
    k = look.between(0.8, 1.05)
    legs = [rod([(s * 0.09, -0.05, 0.005), (s * 0.02, 0.02, 0.27)], 0.007, 6) for s in (-1, 1)]
    rear = rod([(0, 0.12, 0.005), (0, 0.018, 0.25)], 0.007, 6)
    ledge = [bar(0.2, 0.034, 0.01, (0, -0.05, 0.06)), bar(0.2, 0.006, 0.018, (0, -0.066, 0.06))]
    cross, top = (
        bar(0.085, 0.012, 0.014, (0, -0.002, 0.17)),
        block(0.06, 0.014, 0.03, 0.004).move(0, 0.018, 0.255),
    )
    chain = rod([(0, 0.075, 0.11), (0, 0.03, 0.095), (0, -0.02, 0.1)], 0.0015, 6)
    return put_down(
        [
            (join([*legs, rear, *ledge, cross, top]), look.surface(color, "wood")),
            (chain, steel(look, BRASS)),
        ],
        *legs,
        rear,
        *ledge,
        top,
        factor=k,
    )


CATEGORIES = (
    Category("megaphone", megaphone, (0.227, 0.172, 0.167), 0.5, ("loudhailer", "bullhorn",
             "loud hailer"), ("living",), ("big",), ("white", "red")),
    Category("clapperboard", clapperboard, (0.223, 0.237, 0.0102), 0.25, ("clapper board",
             "film slate", "movie clapper", "clapboard", "film clapper"), ("living",),
             ("flat", "big"), ("black",)),
    Category("camcorder", camcorder, (0.135, 0.12, 0.0622), 0.35, ("video camera", "handycam"),
             ("office",), (), ("black",)),
    Category("phone_case", phone_case, (0.147, 0.0725, 0.0103), 0.03, ("phone cover",
             "smartphone case", "mobile phone case", "iphone case", "screen protector"),
             ("office",), ("flat",), ("pink", "black")),
    Category("earbud", earbud, (0.0503, 0.0195, 0.0159), 0.006, ("wireless earbud", "earphone",
             "airpod", "in-ear headphone"), ("office",), (), ("white",)),
    Category("conference_phone", conference_phone, (0.214, 0.203, 0.036), 0.6,
             ("conference speaker", "speakerphone", "conference telephone", "meeting phone"),
             ("office",), ("big",), ("charcoal",)),
    Category("audio_interface", audio_interface, (0.178, 0.113, 0.0446), 0.6, ("sound card",
             "audio mixer box", "sound interface", "usb audio interface"), ("music",),
             (), ("red", "black")),
    Category("amphora", amphora, (0.13, 0.13, 0.217), 0.8, ("greek amphora", "roman amphora",
             "clay amphora", "kylix", "greek urn"), ("living",), ("tall",),
             ("terracotta",)),
    Category("butter_churn", butter_churn, (0.129, 0.129, 0.284), 0.9, ("churn", "milk churn"),
             ("kitchen",), ("tall",), ("wooden",)),
    Category("garden_gnome", gnome, (0.114, 0.0863, 0.205), 0.35, ("gnome", "garden dwarf",
             "dwarf", "gnome figurine"), ("living",), ("tall",), ("red",)),
    Category("potty", potty, (0.209, 0.209, 0.171), 0.3, ("baby potty", "child's potty",
             "chamber pot"), ("living",), ("container", "big"), ("blue", "pink")),
    Category("volcano", volcano, (0.241, 0.241, 0.119), 0.4, ("toy volcano",
             "model volcano", "volcano kit"), ("toys", "lab"), ("big",), ("brown",)),
    Category("easel", table_easel, (0.196, 0.191, 0.277), 0.4, ("table easel", "wooden easel",
             "mini easel", "display easel", "tabletop easel", "artist's easel"),
             ("craft",), ("tall",), ("wooden",)),
)  # fmt: skip
"""The module's categories."""
