"""Objects of the ``living`` theme: party supplies."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import above, flat_foot, hull_above, hull_of, hull_part
from ...kit.primitives import drum, limb, plate, rod, straight
from ...kit.shapes import Pieces, Shape, at_rest, category, keep_still, put_down, settle, shape
from ...kit.solids import cylinder, join, lathe, loft, prism, torus, tube
from ...kit.surfaces import Look, plain, tint_color
from .decorations import BALLOON_GAY


@category("foil_balloon", size=(0.246, 0.355, 0.0607), mass=0.03, material="plastic",
          assembled=True,
          aliases=("mylar balloon", "star balloon", "heart balloon", "helium balloon"),
          themes=("living",), colors=("silver", "gold"), state="lying flat")  # fmt: skip
def foil_balloon(look: Look) -> Shape:
    """A shiny foil balloon lying flat: a heart, a star or a disc, with a tail and a ribbon."""
    k = look.between(0.9, 1.1)
    color = look.color("silver", "gold", "pink", "red", "blue")
    kind = look.pick(["star", "heart", "star"])
    n = 60
    a = 2 * np.pi * np.arange(n) / n
    if kind == "star":
        away = 0.1 + 0.032 * np.cos(5 * a - np.pi / 2 * 5)
        ring = np.column_stack([away * np.cos(a), away * np.sin(a)])
    else:
        ring = 0.0075 * np.column_stack([16 * np.sin(a) ** 3, 13 * np.cos(a) - 5 * np.cos(
            2 * a) - 2 * np.cos(3 * a) - np.cos(4 * a)])[::-1]  # fmt: skip
    levels = [(0.35, 0), (0.7, 0.004), (0.93, 0.018), (1.0, 0.03), (0.93, 0.042), (0.7, 0.056),
              (0.35, 0.062)]  # fmt: skip
    body = loft(np.stack([np.column_stack([ring * f, np.full(n, z)]) for f, z in levels]), ring)
    tail = prism(
        np.array([(-0.012, -0.125), (0.012, -0.125), (0.005, -0.08), (-0.005, -0.08)]), 0.026, 0.03
    )
    string = limb([(0, -0.122, 0.026), (0.02, -0.15, 0.004), (-0.01, -0.19, 0.003), (0.02, -0.23,
                  0.003)], [0.0015] * 4, 5)  # fmt: skip
    foil = surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.4), look.rng)
    return shape([(join([body, tail]), foil), (string, surfaces.plain((240, 240, 236)))],
                 [hull_of(body), hull_above(tail), hull_above(string)]).scale(k)  # fmt: skip


@category("streamer", size=(0.324, 0.0443, 0.0688), mass=0.01, material="paper", assembled=True,
          aliases=("paper streamer", "party streamer", "roll of streamers", "crepe streamer",
          "serpentine streamer"), themes=("living",), colors=("pink",),
          state="lying flat")  # fmt: skip
@at_rest
def streamer(look: Look) -> Shape:
    """A paper streamer that has sprung open into curls."""
    k = look.between(0.9, 1.1)
    color = look.color("pink", "yellow", "sky", "red", "lime", "purple", "orange")
    t = np.linspace(0, 1, 110)
    r = 0.026 + 0.004 * np.sin(9 * t)
    turn = 2 * np.pi * 6.5 * t
    path = np.column_stack([0.24 * (t - 0.5) + r * np.cos(turn), 0.02 * np.sin(5 * t),
                            0.0305 + r * np.sin(turn) * 0.95])  # fmt: skip
    ribbon = tube(path, 0.0065, 6, squash=0.18)
    roll = cylinder(0.024, 0.014, 26).turn(0, np.pi / 2).move(0.16, 0.006, 0.024)
    spun = surfaces.stripes([color, tint_color(color, 0.85)], 6)
    return settle([(ribbon, spun), (roll, spun)], 0.01, hulls=[[0], [1]]).scale(k)


@category("party_blower", size=(0.162, 0.0363, 0.0554), mass=0.006, material="paper",
          assembled=True,
          aliases=("party blowout", "blowout", "party whistle", "noisemaker", "party noisemaker"),
          themes=("living",), colors=("red",), state="lying flat")  # fmt: skip
def party_blower(look: Look) -> Shape:
    """A party blower lying flat: a mouthpiece and a curled paper tongue."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "blue", "gold", "pink", "green", "purple")
    mouth = cylinder(0.0055, 0.04, 14, top=0.009).turn(1, np.pi / 2).move(-0.08, 0, 0.013)
    t = np.linspace(0, 1, 60)
    turn = 2.6 * 2 * np.pi * t
    away = 0.026 * (1 - 0.72 * t)
    coil = np.column_stack([0.05 + away * np.sin(turn), 0 * t, 0.03 - away * np.cos(turn)])
    path = np.concatenate([[(-0.042, 0, 0.013), (-0.01, 0, 0.008), (0.02, 0, 0.005)], coil])
    tongue = tube(path, 0.011, 8, squash=0.17)
    wide = surfaces.stripes([color, (250, 248, 240), tint_color(color, 0.7), (250, 214, 80)], 9)
    fringe = [tube([(-0.044, 0, 0.013), (-0.058, 0.017 * np.cos(a), 0.013 + 0.012 * np.sin(a))],
                   [0.0016, 0.0008], 5) for a in np.arange(12) * 0.524]  # fmt: skip
    return settle([(mouth, surfaces.plain((246, 246, 240))), (tongue, wide),
                   (join(fringe), surfaces.plain(tint_color(color, 1.3)))], 0.01,
                  hulls=[[0, 2], [1]]).scale(k)  # fmt: skip


@category("party_horn", size=(0.213, 0.0754, 0.0711), mass=0.015, material="paper", assembled=True,
          aliases=("paper horn", "toy horn", "party trumpet"), themes=("living",), colors=("red",),
          state="lying flat")  # fmt: skip
@at_rest
def party_horn(look: Look) -> Shape:
    """A paper party horn with a fringe at its wide end, lying flat."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "gold", "blue", "pink", "silver", "green")
    cone = cylinder(0.006, 0.17, 24, top=0.031).turn(1, np.pi / 2).move(x=-0.09)
    mouth = cylinder(0.0045, 0.022, 12).turn(1, np.pi / 2).move(x=-0.11)
    dark = cylinder(0.028, 0.001, 22).turn(1, np.pi / 2).move(x=0.0796)
    fringe = [tube([(0.075, 0.031 * np.cos(a), 0.031 * np.sin(a)), (0.1, 0.036 * np.cos(a + 0.1),
                   0.036 * np.sin(a + 0.1))], [0.003, 0.0015], 4)
              for a in 2 * np.pi * np.arange(22) / 22]  # fmt: skip
    bands = surfaces.stripes([color, (250, 246, 236), color, (246, 206, 80)], 5)
    return settle([(cone, bands), (join([mouth]), surfaces.plain((240, 240, 236))),
                   (dark, surfaces.plain(tint_color(color, 0.4))),
                   (join(fringe), surfaces.plain(tint_color(color, 1.2)))],
                  0.06).scale(k)  # fmt: skip


@category("balloon_pump", size=(0.253, 0.0624, 0.0451), mass=0.12, material="plastic",
          assembled=True, aliases=("hand pump", "inflator", "ball pump"), themes=("living",),
          colors=("blue",), state="lying flat")  # fmt: skip
def balloon_pump(look: Look) -> Shape:
    """A balloon pump lying flat: a barrel with a nozzle and an extended T-shaped handle."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "red", "yellow", "green", "pink")
    barrel = cylinder(0.021, 0.15, 26, bevel=0.002).turn(1, np.pi / 2).move(x=-0.09)
    nozzle = cylinder(0.012, 0.035, 18, top=0.004).turn(1, -np.pi / 2).move(x=-0.088)
    shaft = cylinder(0.006, 0.06, 12).turn(1, np.pi / 2).move(x=0.058)
    bar = cylinder(0.0085, 0.062, 16).turn(0, np.pi / 2).move(0.12, 0.031, 0)
    ring = torus(0.021, 0.0028, 24, 8).turn(1, np.pi / 2)
    return settle([(join([barrel]), surfaces.speckles(look.rng, color, 4)),
                   (join([nozzle, bar, ring.move(x=0.056), ring.move(x=-0.086)]),
                    surfaces.plain(tint_color(color, 0.6))),
                   (shaft, surfaces.plain((236, 236, 232)))], 0.06,
                  hulls=[[0], [1, 2]]).scale(k)  # fmt: skip


@category("balloon", size=(0.15, 0.15, 0.31), mass=0.15, material="plastic", assembled=True,
          aliases=("party balloon", "birthday balloon"), themes=("living",), roles=("tall",),
          colors=("red", "blue"))  # fmt: skip
def balloon(look: Look) -> Shape:
    """A balloon on a stick in a small weight."""
    color = look.color(*BALLOON_GAY, "white", "gold")
    d = look.between(0.13, 0.17)
    weight = lathe(
        [(0, 0), (0.042, 0), (0.044, 0.01), (0.034, 0.034), (0.008, 0.04), (0, 0.04)], 22
    )
    stick = straight((0, 0, 0.036), (0, 0, 0.13), 0.0025)
    body = lathe(np.concatenate([[(0, 0)], smooth([(0.01, 0.004), (0.3 * d, 0.22 * d),
                 (0.5 * d, 0.68 * d), (0.34 * d, 1.05 * d), (0.04 * d, 1.18 * d)], 5),
                 [(0, 1.18 * d)]]), 26).move(z=0.13)  # fmt: skip
    knot = cylinder(0.008, 0.01, 12, top=0.003).move(z=0.124)
    skin = surfaces.gradient(tint_color(color, 0.88), tint_color(color, 1.15), look.rng, 2)
    pieces: Pieces = [(body, skin), (knot, surfaces.plain(tint_color(color, 0.8))),
                      (stick, surfaces.plain((244, 244, 240))),
                      (weight, surfaces.speckles(look.rng, look.own_color("silver", "gold", "red",
                                                                          "blue"), 5))]  # fmt: skip
    return put_down(pieces, weight, stick, body)


@category("party_popper", size=(0.05, 0.047, 0.095), mass=0.015, material="paper",
          aliases=("confetti popper", "confetti cannon"), themes=("living",),
          colors=("red", "gold"))  # fmt: skip
def party_popper(look: Look) -> Shape:
    """A party popper standing on its cap, with its string on top."""
    color = look.color(*BALLOON_GAY, "gold")
    paper = surfaces.stripes(
        [color, tint_color(color, 1.6), look.own_color(*BALLOON_GAY)], 3, side=96
    )
    body = cylinder(0.022, 0.05, 24, top=0.018)
    neck = cylinder(0.0175, 0.03, 20, top=0.007).move(z=0.049)
    rim = cylinder(0.0235, 0.006, 24)
    string = rod([(0, 0, 0.078), (0.006, 0, 0.09), (0.02, 0, 0.082), (0.026, 0, 0.062)], 0.0013, 6)
    pieces: Pieces = [(join([body, neck]), paper), (rim, surfaces.plain((240, 220, 130))),
                      (string, surfaces.plain((250, 250, 246)))]  # fmt: skip
    return put_down(pieces, join([body, rim]), neck, factor=look.between(0.9, 1.2))


@category("sparkler", size=(0.235, 0.0364, 0.025), mass=0.006, material="metal", assembled=True,
          aliases=("lit sparkler", "party sparkler", "cake sparkler"), themes=("living",),
          colors=("gray",), state="lying flat")  # fmt: skip
@keep_still
def sparkler(look: Look) -> Shape:
    """A sparkler lying flat, burning at its tip."""
    k = look.between(0.9, 1.1)
    color = look.color("gray", "silver", "gold")
    wire = straight((-0.11, 0, 0.0025), (0.0, 0, 0.0025), 0.0011, 6)
    coat = straight((-0.005, 0, 0.0025), (0.11, 0, 0.0025), 0.0025, 7)
    sparks = [tube([(0.11, 0, 0.004), (0.11 + d * np.cos(a) * np.cos(b), d * np.sin(a) * np.cos(b),
                   0.004 + d * abs(np.sin(b)))], [0.0011, 0.0004], 4)
              for a, b, d in ((2.4 * n, 0.35 + 0.9 * ((n * 5) % 7) / 7, 0.016 + 0.012 * (n % 3) / 3)
                              for n in range(26))]  # fmt: skip
    return settle([(wire, surfaces.plain((180, 182, 186))),
                   (coat, surfaces.speckles(look.rng, tint_color(color, 0.8), 14)),
                   (join(sparks), surfaces.plain((255, 226, 120)))], 0.02,
                  hulls=[[0, 1], [2]]).scale(k)  # fmt: skip


@category("christmas_cracker", size=(0.27, 0.05, 0.047), mass=0.03, material="paper",
          aliases=("party cracker", "paper cracker", "bonbon cracker"), themes=("living",),
          colors=("red", "green"), state="lying")  # fmt: skip
def christmas_cracker(look: Look) -> Shape:
    """A Christmas cracker lying flat: a paper roll twisted at both ends, with gold bands."""
    color = look.color("red", "green", "gold", "crimson", "silver", "blue", "white")
    paper = surfaces.fit(glaze_tile(look, color), 128, 128)
    side = [(0, -0.14), (0.026, -0.14), (0.024, -0.115), (0.009, -0.078), (0.023, -0.062),
            (0.023, 0.062), (0.009, 0.078), (0.024, 0.115), (0.026, 0.14), (0, 0.14)]  # fmt: skip
    roll = lathe(side, 22).turn(1, np.pi / 2).move(z=0.0225)
    bands = [cylinder(0.0236, 0.009, 22).move(z=z - 0.0045).turn(1, np.pi / 2).move(z=0.0225)
             for z in (-0.05, 0.05)]  # fmt: skip
    ties = [torus(0.0095, 0.0026, 16, 6).turn(1, np.pi / 2).move(x, 0, 0.0225)
            for x in (-0.078, 0.078)]  # fmt: skip
    gold = surfaces.plain((224, 184, 90) if color[2] > 60 else (240, 240, 236))
    x = roll.vertices[:, 0]
    foot = [flat_foot(above(roll.vertices[np.abs(x) < 0.07]), 0.05),
            *[hull_part(above(roll.vertices[s * x > 0.075])) for s in (-1, 1)]]  # fmt: skip
    made = shape([(roll, paper), (join([*bands, *ties]), gold)], foot)
    return made.scale(look.between(0.85, 1.1))


@category("rosette", size=(0.086, 0.129, 0.0157), mass=0.02, material="fabric",
          aliases=("paper rosette", "award ribbon", "prize ribbon", "ribbon rosette",
          "winner's rosette"), themes=("living",), roles=("flat",),
          colors=("red", "blue"))  # fmt: skip
def rosette(look: Look) -> Shape:
    """A pleated ribbon rosette with two tails, lying flat."""
    color = look.color("red", "blue", "green", "yellow", "purple", "pink")
    k = look.between(0.8, 1.2)
    a = np.linspace(0, 2 * np.pi, 49)[:-1]
    r = 0.04 + 0.0025 * np.cos(24 * a)
    ruff = plate(np.column_stack([r * np.cos(a), r * np.sin(a)]), 0.006, at=(0, 0, 0.003))
    r = 0.03 + 0.002 * np.cos(24 * a)
    inner = plate(np.column_stack([r * np.cos(a), r * np.sin(a)]), 0.004, at=(0, 0, 0.0085))
    badge = drum(0.021, 0.004, (0, 0, 0.0115), sides=28, bevel=0.001)
    face = prints.canvas(96, 96, (250, 240, 206))
    prints.disc(face, 0.5, 0.5, 0.44, color, 0.4)
    prints.write(face, look.pick(["1st", "2nd", "WIN", "BEST", "VOTE"]), 0.5, 0.5, 0.3,
                 (90, 60, 40), bold=True)  # fmt: skip
    tails = [plate([(-0.012, -0.085), (0, -0.076), (0.012, -0.085), (0.012, 0), (-0.012, 0)], 0.003)
             .turn(2, s * 0.24) for s in (-1, 1)]  # fmt: skip
    rays = surfaces.stripes([color, tint_color(color, 0.8)], 4, upright=True)
    return put_down([(join([ruff, *tails]), rays), (inner, plain(tint_color(color, 1.5))),
                     (badge, face)], join([ruff, badge]), *tails, factor=k)  # fmt: skip
