"""What records, films and talks: megaphones, clapperboards, camcorders, earbuds."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import DARK, at_box, drum, lies, plate, steel
from ...build.outlines import rectangle
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def megaphone(look: Look) -> Shape:
    """A megaphone lying on its grip."""
    color = look.color("white", "red", "yellow", "blue", "black")
    k = look.between(0.8, 1.05)
    flare = [(0.024, 0), (0.026, 0.09), (0.05, 0.16), (0.088, 0.2)]
    horn = lathe([(0, 0), *flare, *[(r - 0.004, z) for r, z in flare[::-1]][:-1], (0, 0.02)], 28)
    horn = lies(horn, -0.06, 0, 0.087)
    back = drum(0.034, 0.05, (-0.1, 0, 0.087), 0, sides=22)
    rim = torus(0.087, 0.005, 30, 6).turn(1, np.pi / 2).move(0.139, 0, 0.087)
    grip = at_box(0.03, 0.024, 0.075, (-0.055, 0, 0))
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
    sheet = at_box(0.255, 0.175, 0.0008, (0, 0, 0.0077))
    stripes = textures.stripes([(244, 244, 240), (26, 26, 28)], 6, upright=True)
    low = at_box(0.26, 0.03, 0.012, (0, 0.105, 0))
    high = at_box(0.26, 0.03, 0.012, (0.13, 0, 0)).turn(2, 0.18).move(-0.13, 0.128, 0)
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
    lens = [drum(0.024, 0.03, (0.05, 0, 0.034), 0), drum(0.018, 0.001, (0.0795, 0, 0.034), 0)]
    screen = at_box(0.07, 0.006, 0.045, (0.0, -0.062, 0.01)).turn(2, 0.0)
    hinge = at_box(0.012, 0.04, 0.03, (0.038, -0.04, 0.016))
    view = at_box(0.062, 0.0012, 0.037, (0.0, -0.0655, 0.014))
    strap = rod(
        [(0.04, 0.027, 0.035), (0.02, 0.05, 0.035), (-0.03, 0.05, 0.035), (-0.05, 0.027, 0.035)],
        0.006,
        8,
    )
    button = drum(0.007, 0.004, (-0.045, 0, 0.061))
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
    hole = plate(rectangle(0.034, 0.034, 0.008), 0.0006, at=(-0.05, 0.014, 0.0097))
    rim = plate(rectangle(0.038, 0.038, 0.01), 0.0012, at=(-0.05, 0.014, 0.0092))
    image = textures.speckles(look.rng, color, 4).copy()
    spots = []
    if look.chance(0.6):
        tone = look.own_color("white", "coral", "navy", "mustard")
        spots = [
            drum(
                look.between(0.003, 0.007),
                0.0006,
                (look.between(-0.02, 0.06), look.between(-0.026, 0.026), 0.0097),
                sides=14,
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
    end = drum(0.0032, 0.0015, (-0.0235, 0, 0.0032), 0, sides=10)
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
    body, top = plate(rim, 0.02), plate(0.82 * rim, 0.016, at=(0, 0, 0.019))
    grille = drum(0.042, 0.006, (0, 0.005, 0.034), sides=28)
    keys = [
        at_box(0.01, 0.007, 0.003, (-0.013 + 0.013 * (n % 3), -0.052 - 0.0095 * (n // 3), 0.0345))
        for n in range(6)
    ]
    screen = at_box(0.038, 0.018, 0.0014, (0, 0.062, 0.0346))
    lamps = [
        drum(0.0035, 0.002, (0.082 * np.cos(q), 0.082 * np.sin(q), 0.034))
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
    front = at_box(0.172, 0.002, 0.037, (0, -0.0505, 0.004))
    jacks = [drum(0.0105, 0.004, (x, -0.0545, 0.022), 1) for x in (-0.066, -0.008)]
    knobs = [drum(0.009, 0.013, (x, -0.0635, 0.024), 1) for x in (-0.038, 0.02)]
    big = drum(0.014, 0.014, (0.056, -0.0645, 0.022), 1)
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
)  # fmt: skip
"""The module's categories."""
