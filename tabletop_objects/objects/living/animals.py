"""Objects of the ``living`` theme: animals."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ...kit import surfaces
from ...kit.parts import hull_above, hull_of, open_vessel
from ...kit.primitives import ball, blade, limb, lobe, rod, straight
from ...kit.shapes import Category, Pieces, Shape, category, put_down, settle, shape
from ...kit.solids import Solid, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...kit.surfaces import RGB, Look, tint_color


@category("seashell", size=(0.125, 0.08, 0.035), mass=0.03, material="stone", aliases=("shell",
          "sea shell", "conch", "clam shell", "scallop shell", "sea snail shell", "whelk", "winkle",
          "periwinkle"), themes=("living",), colors=("cream", "pink"), state="lying")  # fmt: skip
def seashell(look: Look) -> Shape:
    """A scallop shell lying with its ribs up, or a spiral whelk shell."""
    color = look.color("white", "cream", "pink", "coral", "tan", "beige", "lavender")
    other = tint_color(color, 0.72)
    if look.chance(0.6):
        n, m = 25, 7
        a = np.linspace(-1.25, 1.25, n)
        rings = []
        for t in np.linspace(0.06, 1, m):
            rib = 1 + 0.05 * np.abs(np.cos(7 * a))
            r = 0.075 * t * (0.92 + 0.08 * np.cos(a * 1.3)) * rib
            z = 0.026 * np.sin(np.pi * (0.08 + 0.92 * t)) * (0.55 + 0.45 * np.cos(1.1 * a)) * rib
            top = np.column_stack([r * np.sin(a), r * np.cos(a) - 0.04, z + 0.002])
            low = top[::-1] * [0.97, 0.97, 0]
            rings.append(np.concatenate([top[::-1], low[::-1]]))
        section = np.concatenate([np.column_stack([np.sin(a[::-1]), np.ones(n)]),
                                  np.column_stack([np.sin(a), -np.ones(n)])])  # fmt: skip
        fan = loft(np.stack(rings), section)
        hinge = ball(0.03, 0.012, 0.01, (0, -0.036, 0.004), 10)
        tile = surfaces.stripes([color, other], 16, upright=True, side=128)
        return put_down([(fan, tile), (hinge, surfaces.plain(other))], fan, hinge,
                       factor=look.between(0.85, 1.2))  # fmt: skip
    t = np.linspace(0, 1, 60)
    a = 2 * np.pi * 3.2 * t
    r = 0.019 * (1 - t) ** 1.1 + 0.0005
    path = np.column_stack([-0.03 + 0.07 * t, r * np.cos(a), r * np.sin(a) + 0.02])
    coil = tube(path, 0.019 * (1 - t) + 0.002, 10)
    lip = ball(0.036, 0.03, 0.04, (-0.034, 0.008, 0.018), 14)
    mouth = ball(0.02, 0.014, 0.026, (-0.046, -0.003, 0.018), 10)
    tile = surfaces.stripes([color, other, color], 8, side=96)
    return put_down([(coil, tile), (lip, surfaces.speckles(look.rng, color, 6)),
                    (mouth, surfaces.plain((240, 190, 170)))], coil, lip,
                   factor=look.between(0.85, 1.2))  # fmt: skip


@category("starfish", size=(0.11, 0.115, 0.021), mass=0.04, material="stone",
          aliases=("sea star", "dried starfish"), themes=("living",), colors=("orange",),
          state="lying flat")  # fmt: skip
def starfish(look: Look) -> Shape:
    """A five-armed starfish, lying flat."""
    color = look.color("orange", "coral", "red", "tan", "beige", "purple", "terracotta")
    n = 40
    a = 2 * np.pi * np.arange(n) / n
    r = 0.5 * (0.32 + 0.68 * np.abs(np.cos(2.5 * a)) ** 2.2)
    outline = np.column_stack([r * np.cos(a), r * np.sin(a)])
    levels = [(1.0, 0.0), (1.02, 0.05), (0.8, 0.11), (0.3, 0.17)]
    body = loft(
        np.stack([np.column_stack([outline * g, np.full(n, z)]) for g, z in levels]), outline
    )
    dots = [ball(0.045, 0.045, 0.03, (d * np.cos(w), d * np.sin(w), 0.16 - 0.2 * d), 6)
            for w in 2 * np.pi * np.arange(5) / 5 for d in (0.14, 0.24, 0.34)]  # fmt: skip
    skin = surfaces.spots(look.rng, color, tint_color(color, 1.4), 0.1)
    return put_down([(body, skin), (join(dots), surfaces.plain(tint_color(color, 1.5)))], body,
                   factor=look.between(0.09, 0.15))  # fmt: skip


@category("coral", size=(0.085, 0.085, 0.135), mass=0.2, material="stone", assembled=True,
          aliases=("piece of coral", "coral branch", "red coral"), themes=("living",),
          roles=("tall",), colors=("coral",))  # fmt: skip
def coral(look: Look) -> Shape:
    """A branching coral on a stone base."""
    color = look.color("coral", "red", "white", "pink", "orange")
    branches: list[Solid] = [rod([(0, 0, 0.01), (0.004, 0, 0.05), (0, 0.004, 0.12)],
                                 [0.012, 0.009, 0.005], 8)]  # fmt: skip
    for k in range(9):
        a, z = 2.4 * k, 0.03 + 0.008 * k
        out = look.between(0.03, 0.045) * (1.1 - 0.05 * k)
        tip = np.array([out * np.cos(a), out * np.sin(a), z + 0.045])
        branches.append(rod([(0, 0, z), 0.6 * tip * [1, 1, 0] + [0, 0, z + 0.015], tip],
                            [0.0075, 0.006, 0.0045], 7, 3))  # fmt: skip
        branches.append(ball(0.011, 0.011, 0.011, tuple(tip), 8))
    foot = lobe(cylinder(0.036, 0.014, 16, top=0.02), 5, 0.15)
    skin = surfaces.spots(look.rng, color, tint_color(color, 1.4), 0.25)
    return put_down([(join(branches), skin), (foot, surfaces.speckles(look.rng, (196, 188, 172),
                                                                      12))], foot, join(branches),
                    factor=look.between(0.85, 1.15))  # fmt: skip


DARK = surfaces.plain((34, 32, 34))


def bird(look: Look) -> Shape:
    """A bird figurine standing on its feet and facing left."""
    color = look.color("blue", "red", "yellow", "teal", "brown", "white", "sky")
    skin = surfaces.speckles(look.rng, color, 8)
    chest = surfaces.plain(look.pick([(240, 196, 140), (250, 246, 236), tint_color(color, 1.5)]))
    wing = surfaces.plain(tint_color(color, 0.7))
    body = ball(0.074, 0.048, 0.05, (0, 0, 0.027), 18)
    breast = ball(0.04, 0.042, 0.042, (-0.017, 0, 0.024), 14)
    head = ball(0.036, 0.034, 0.034, (-0.028, 0, 0.056), 16)
    beak = cylinder(0.006, 0.016, 10, top=0.0006).turn(1, -np.pi / 2).move(-0.043, 0, 0.055)
    tail = prism([(0, -0.008), (0.045, -0.014), (0.045, 0.014), (0, 0.008)], 0, 0.005)
    tail = tail.turn(1, -0.25).move(0.03, 0, 0.028)
    wings = [ball(0.052, 0.01, 0.028, (0.006, s * 0.023, 0.031), 12) for s in (-1, 1)]
    eyes = [ball(0.005, 0.004, 0.005, (-0.036, s * 0.0135, 0.061), 8) for s in (-1, 1)]
    foot = cylinder(0.019, 0.004, 14)
    pieces: Pieces = [(body, skin), (breast, chest), (head, skin), (tail, wing),
                      (join(wings), wing), (join([beak, foot]), surfaces.plain((226, 150, 50))),
                      (join(eyes), DARK)]  # fmt: skip
    return put_down(pieces, body, foot, head, beak, tail, factor=look.between(0.9, 1.15))


HAMSTER_DARK: RGB = (26, 24, 26)


def eyes(x: float, y: float, z: float, d: float) -> Solid:
    """Return two round eyes of diameter ``d``, centred at (x, y, z) and (x, -y, z)."""
    return join([ball(d, d, d, (x, s * y, z), 8) for s in (-1, 1)])


def _fur(look: Look, color: RGB) -> surfaces.Tile:
    return surfaces.scratches(look.rng, color, tint_color(color, 0.84), 160)


def _rodent(
    long: float, ears: float, tail: float, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a plump, furry rodent facing left."""

    def make(look: Look) -> Shape:
        k, color = long * look.between(0.88, 1.12), look.color(*palette)
        body = ball(k, 0.62 * k, 0.56 * k, (0.06 * k, 0, 0.27 * k), 20)
        head = ball(0.46 * k, 0.42 * k, 0.4 * k, (-0.42 * k, 0, 0.3 * k), 18)
        snout = ball(0.2 * k, 0.2 * k, 0.16 * k, (-0.62 * k, 0, 0.26 * k), 12)
        ear = [ball(0.05 * k, ears * k, ears * k, (-0.36 * k, s * 0.15 * k, 0.49 * k), 10)
               for s in (-1, 1)]  # fmt: skip
        feet = [ball(0.16 * k, 0.1 * k, 0.08 * k, (x * k, s * 0.18 * k, 0.03 * k), 10)
                for x in (-0.32, 0.3) for s in (-1, 1)]  # fmt: skip
        nose = ball(0.05 * k, 0.06 * k, 0.04 * k, (-0.72 * k, 0, 0.28 * k), 8)
        pink = [*ear, *feet, nose]
        if tail > 0.2:
            pink.append(limb([(0.52 * k, 0, 0.14 * k), (0.75 * k, 0.06 * k, 0.04 * k),
                              ((0.5 + tail) * k, -0.06 * k, 0.03 * k)],
                             [0.03 * k, 0.025 * k, 0.008 * k], 7))  # fmt: skip
        belly = ball(0.7 * k, 0.5 * k, 0.4 * k, (0, 0, 0.19 * k), 16)
        patch = (
            tint_color(color, 1.6)
            if look.chance(0.6)
            else look.own_color("white", "brown", "black")
        )
        return settle([(join([body, head]), _fur(look, color)),
                       (join([snout, belly]), surfaces.plain(patch)),
                       (join(pink), surfaces.plain((232, 164, 160))),
                       (eyes(-0.54 * k, 0.14 * k, 0.39 * k, 0.065 * k),
                        surfaces.plain(HAMSTER_DARK))], 0.03, hulls=[[0, 1]])  # fmt: skip

    return make


def _bird(
    tall: float, palette: tuple[str, ...], *, tail: float, crest: bool, fluffy: bool
) -> Callable[[Look], Shape]:
    """Return the shape function of a small bird standing and facing left."""

    def make(look: Look) -> Shape:
        k, color = tall * look.between(0.88, 1.12), look.color(*palette)
        legs = 0.14 * k if fluffy else 0.08 * k
        pieces: Pieces = []
        if fluffy:
            body = ball(0.62 * k, 0.56 * k, 0.54 * k, (0.06 * k, 0, legs + 0.25 * k), 18)
            head = ball(0.42 * k, 0.4 * k, 0.4 * k, (-0.13 * k, 0, legs + 0.62 * k), 16)
            bill, eye = (-0.36 * k, legs + 0.6 * k), (-0.24 * k, 0.14 * k, legs + 0.68 * k)
        else:
            body = (
                ellipsoid(0.4 * k, 0.4 * k, 0.78 * k, 18, 12)
                .turn(1, 0.3)
                .move(0.02 * k, 0, legs + 0.36 * k)
            )
            head = ball(0.34 * k, 0.32 * k, 0.32 * k, (-0.14 * k, 0, legs + 0.76 * k), 16)
            bill, eye = (-0.3 * k, legs + 0.72 * k), (-0.2 * k, 0.125 * k, legs + 0.8 * k)
        feathers = (_fur(look, color) if fluffy else surfaces.gradient(color,
                                                                       tint_color(color, 1.3),
                                                                       look.rng))  # fmt: skip
        pieces.append((join([body, head]), feathers))
        wings = [ellipsoid(0.4 * k, 0.06 * k, 0.24 * k if fluffy else 0.3 * k, 12, 7).turn(1,
            0.5 if not fluffy else 0.2)
                 .move(0.1 * k, s * (0.27 if fluffy else 0.19) * k,
                       legs + (0.28 if fluffy else 0.38) * k)
                 for s in (-1, 1)]  # fmt: skip
        extra = list(wings)
        if tail:
            extra.append(blade([(0.12 * k, 0, legs + 0.14 * k), (0.2 * k, 0, 0.08 * k),
                                ((0.2 + tail) * k, 0, 0.02 * k)], 0.18 * k, thick=0.3))  # fmt: skip
        pieces.append(
            (join(extra), surfaces.stripes([tint_color(color, 0.72), tint_color(color, 1.1)], 6))
        )
        horn = (cylinder(0.06 * k, 0.14 * k, 8, top=0.004
                         * k).turn(1, -np.pi / 2 - 0.3).move(bill[0] + 0.03 * k, 0,
                                                             bill[1]))  # fmt: skip
        feet = [limb([(0.04 * k, s * 0.1 * k, legs + 0.06 * k), (0.03 * k, s * 0.1 * k, 0.03 * k),
                      (-0.08 * k, s * 0.1 * k, 0.012 * k)], [0.02 * k] * 3, 6) for s in (-1,
                          1)]  # fmt: skip
        toes = [ball(0.2 * k, 0.12 * k, 0.03 * k, (-0.02 * k, s * 0.1 * k, 0.015 * k), 8)
                for s in (-1, 1)]  # fmt: skip
        if crest:
            extra_comb = ball(0.16 * k, 0.05 * k, 0.12 * k, (-0.1 * k, 0, legs + 0.94 * k), 8)
            pieces.append((extra_comb, surfaces.plain((206, 40, 44) if not fluffy else color)))
        pieces += [(join([horn, *feet, *toes]), surfaces.plain((238, 150, 50))),
                   (eyes(*eye, 0.06 * k), surfaces.plain(HAMSTER_DARK))]  # fmt: skip
        made = settle(pieces, 0.0, hulls=[[0]])
        low = cylinder(0.15 * k, 0.3 * k, 12).move(x=0.03 * k)
        return Shape(made.pieces, (*made.parts, hull_of(low)), made.opacity)

    return make


TORTOISE_DARK: RGB = (26, 24, 26)


def _shelled_animal(flippers: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a tortoise, or of a turtle with flippers, facing left."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.85, 1.2), look.color("olive", "green", "brown", "tan", "bronze")
        shell = ellipsoid(0.1, 0.082, 0.07 if not flippers else 0.05, 22, 14).move(z=0.018)
        y, x = np.mgrid[0:96, 0:144]
        cell = np.maximum(np.abs(np.sin(np.pi * x / 24)), 0) * np.abs(
            np.sin(np.pi * (y + 12 * ((x // 24) % 2)) / 24)
        )
        plates = np.where((cell < 0.22)[..., None], np.array(tint_color(color, 0.5)),
                          np.array(color) * (0.75 + 0.5 * cell[..., None]))  # fmt: skip
        skin: RGB = tint_color(look.own_color("olive", "sage", "tan"), 0.95)
        head = [limb([(-0.04, 0, 0.02), (-0.055, 0, 0.026), (-0.062, 0, 0.032)],
                     [0.011, 0.009, 0.009], 10),
                ball(0.026, 0.02, 0.019, (-0.067, 0, 0.034), 12)]  # fmt: skip
        feet = []
        for s in (-1, 1):
            for front in (-1, 1):
                if flippers:
                    reach = 0.075 if front < 0 else 0.055
                    feet.append(blade([(front * 0.028, s * 0.03, 0.013),
                                       (front * 0.034, s * 0.5 * (reach + 0.03), 0.012),
                                       (front * (0.02 if front < 0 else 0.05), s * reach, 0.006)],
                                      0.026, thick=0.3))  # fmt: skip
                else:
                    feet.append(limb([(front * 0.03, s * 0.028, 0.018),
                                      (front * 0.035, s * 0.036, 0.008),
                                      (front * 0.038, s * 0.038, 0.002)], [0.011, 0.01, 0.011],
                                      9))  # fmt: skip
        tail = limb([(0.044, 0, 0.014), (0.06, 0, 0.008)], [0.006, 0.001], 7)
        return settle([(shell, np.clip(plates, 0, 255).astype(np.uint8)),
                       (join([*head, *feet, tail]), surfaces.spots(look.rng, skin,
                           tint_color(skin, 0.75), 0.12)),
                       (eyes(-0.073, 0.0075, 0.038, 0.0045), surfaces.plain(TORTOISE_DARK))],
                      0.03, hulls=[[0], [1]]).scale(k)  # fmt: skip

    return make


def _lizard(
    long: float, palette: tuple[str, ...], *, spotted: bool, fat: float
) -> Callable[[Look], Shape]:
    """Return the shape function of a lizard lying flat, with its tail curved to the right."""

    def make(look: Look) -> Shape:
        k, color = long * look.between(0.88, 1.12), look.color(*palette)
        s = look.pick([-1, 1])
        spine = np.array([(-0.5, 0, 0.05), (-0.42, 0, 0.05), (-0.33, 0, 0.04), (-0.24, 0, 0.045),
                          (-0.1, 0.01 * s, 0.045),
                          (0.04, 0, 0.04), (0.18, 0.05 * s, 0.025), (0.34, 0.1 * s, 0.015),
                          (0.5, 0.0, 0.01)]) * k  # fmt: skip
        body = limb(spine, [k * r * fat for r in (0.008, 0.045, 0.03, 0.042, 0.048, 0.036, 0.028,
                                                  0.016, 0.002)], 12, 0.8)  # fmt: skip
        legs = []
        for x in (-0.2, 0.03):
            for t in (-1, 1):
                legs.append(limb([(x * k, t * 0.03 * k, 0.04 * k), ((x - 0.02) * k, t * 0.1 * k,
                    0.045 * k),
                                  ((x - 0.05) * k, t * 0.13 * k, 0.008 * k)],
                                  [0.016 * k, 0.013 * k, 0.01 * k], 7))  # fmt: skip
                legs += [limb([((x - 0.05) * k, t * 0.13 * k, 0.006 * k),
                               ((x - 0.05 - 0.04 * np.cos(a)) * k,
                                t * (0.13 + 0.035 * np.sin(a)) * k, 0.005 * k)],
                              [0.006 * k, 0.006 * k], 5) for a in (-0.7, 0.1, 0.9)]  # fmt: skip
        hide = (surfaces.spots(look.rng, color, tint_color(color, 0.45), 0.16) if spotted else
                surfaces.stripes([color, color, tint_color(color, 0.75)], 8))  # fmt: skip
        return settle([(body, hide), (join(legs), surfaces.plain(tint_color(color, 0.9))),
                       (eyes(-0.43 * k, 0.03 * k * fat, 0.075 * k, 0.018 * k),
                        surfaces.plain(TORTOISE_DARK))],
                      0.06, hulls=[[0], [1]])  # fmt: skip

    return make


@category("tarantula", size=(0.113, 0.12, 0.0376), mass=0.05, material="plastic", assembled=True,
          aliases=("pet spider",), themes=("living",), colors=("brown",))  # fmt: skip
def tarantula(look: Look) -> Shape:
    """A hairy tarantula with a two-part round body and eight bent legs."""
    k, color = look.between(0.8, 1.2), look.color("brown", "black", "bronze", "maroon")
    back = ball(0.042, 0.034, 0.03, (0.03, 0, 0.02), 14)
    front = ball(0.028, 0.026, 0.018, (-0.004, 0, 0.018), 12)
    legs, bands = [], []
    for s in (-1, 1):
        for n, a in enumerate((-0.95, -0.35, 0.3, 0.9)):
            x, y = np.sin(a), np.cos(a)
            reach = 0.07 if n in (0, 3) else 0.062
            legs.append(limb([(0.01 * x - 0.004, s * 0.01, 0.018), (0.4 * reach * x,
                s * 0.45 * reach * y, 0.036),
                              (0.75 * reach * x, s * 0.8 * reach * y, 0.02),
                              (reach * x, s * reach * y, 0.002)],
                             [0.0042, 0.004, 0.0034, 0.002], 6))  # fmt: skip
            bands.append(
                ball(0.009, 0.009, 0.009, (0.4 * reach * x, s * 0.45 * reach * y, 0.036), 8)
            )
    fangs = [limb([(-0.016, s * 0.005, 0.016), (-0.024, s * 0.005, 0.006)], [0.004, 0.002], 6)
             for s in (-1, 1)]  # fmt: skip
    hair = surfaces.scratches(look.rng, color, tint_color(color, 1.35), 220)
    return settle([(join([back, front, *legs, *fangs]), hair), (join(bands),
        surfaces.plain(tint_color(color, 1.4))),
                   (eyes(-0.015, 0.003, 0.025, 0.003), surfaces.plain(TORTOISE_DARK))], 0.04,
                   hulls=[[0]]).scale(k)  # fmt: skip


@category("stick_insect", size=(0.166, 0.106, 0.0317), mass=0.005, material="plastic",
          assembled=True, aliases=("walking stick insect", "praying mantis"), themes=("living",),
          colors=("brown",))  # fmt: skip
def stick_insect(look: Look) -> Shape:
    """A stick insect with a thin body on six long, thin legs."""
    k, color = look.between(0.85, 1.2), look.color("brown", "green", "tan", "olive")
    body = limb([(-0.06, 0, 0.02), (-0.03, 0, 0.021), (0.02, 0, 0.021), (0.06, 0, 0.018)],
                [0.0022, 0.0026, 0.003, 0.0012], 8)  # fmt: skip
    legs = [limb([(x, 0, 0.02), (x + 0.4 * dx, s * 0.025, 0.03), (x + dx, s * 0.05, 0.001)],
                 [0.0014, 0.0012, 0.001], 5)
            for x, dx in ((-0.035, -0.04), (-0.01, 0.01), (0.012, 0.045)) for s in (-1,
                1)]  # fmt: skip
    horns = [
        limb([(-0.06, 0, 0.021), (-0.1, s * 0.012, 0.028)], [0.0007, 0.0004], 4) for s in (-1, 1)
    ]
    bark = surfaces.stripes([color, color, tint_color(color, 0.75)], 9)
    return settle(
        [(join([body, *legs]), bark), (join(horns), surfaces.plain(color))], 0.02, hulls=[[0]]
    ).scale(k)


@category("goldfish", size=(0.0872, 0.0598, 0.0214), mass=0.04, material="food", assembled=True,
          aliases=("gold fish", "koi", "toy goldfish"), themes=("living",), colors=("orange",),
          state="lying on its side")  # fmt: skip
def goldfish(look: Look) -> Shape:
    """A goldfish lying on its side, with a round body and flowing tail and fins."""
    k, color = (look.between(0.85, 1.2), look.color("orange", "orange", "gold", "coral", "red",
                                                    "white"))  # fmt: skip
    body = lathe([(0, 0), (0.008, 0.004), (0.016, 0.02), (0.0155, 0.034), (0.008, 0.05),
                  (0.004, 0.056), (0, 0.057)], 18)  # fmt: skip
    body = body.turn(1, np.pi / 2).scale(1, 1.15, 0.75).move(-0.03, 0, 0.012)
    fins = [blade([(0.022, 0, 0.012), (0.04, s * 0.014, 0.008), (0.062, s * 0.026, 0.002)], 0.024,
                  thick=0.12) for s in (-1, 0.15, 1)]  # fmt: skip
    fins += [blade([(-0.006, 0.014, 0.012), (0.006, 0.026, 0.01), (0.02, 0.026, 0.008)], 0.02,
                   thick=0.14),
             blade([(0.0, -0.014, 0.012), (0.01, -0.024, 0.009), (0.018, -0.026, 0.006)], 0.014,
                   thick=0.14),
             blade([(-0.008, -0.004, 0.023), (0.004, -0.008, 0.024), (0.012, -0.012, 0.021)],
                   0.012, thick=0.2)]  # fmt: skip
    y, x = np.mgrid[0:64, 0:96]
    scale = 0.82 + 0.22 * np.abs(np.sin(np.pi * (x / 8 + 0.5 * ((y // 8) % 2)))) * np.abs(
        np.sin(np.pi * y / 8)
    )
    scales = np.clip(np.array(color) * scale[..., None], 0, 255).astype(np.uint8)
    eye = [ball(0.0065, 0.0065, 0.004, (-0.021, 0.006, 0.019), 8)]
    white = [ball(0.009, 0.009, 0.003, (-0.021, 0.006, 0.0185), 10)]
    return settle([(body, scales), (join(fins), surfaces.stripes([color, tint_color(color, 1.35)],
        6)),
                   (join(white), surfaces.plain((248, 244, 226))), (join(eye),
                       surfaces.plain(TORTOISE_DARK))],
                  0.08, hulls=[[0], [1]]).scale(k)  # fmt: skip


BLACK = surfaces.plain((24, 22, 26))


@category("spider", size=(0.104, 0.123, 0.0379), mass=0.015, material="plastic", assembled=True,
          aliases=("plastic spider", "rubber spider", "toy spider", "halloween spider",
          "fake spider"), themes=("living",), colors=("black",))  # fmt: skip
def spider(look: Look) -> Shape:
    """A plastic spider standing on eight bent legs."""
    k = look.between(0.85, 1.25)
    color = look.color("black", "black", "charcoal", "purple", "orange")
    body = ellipsoid(0.036, 0.032, 0.028, 16, 10).move(0.024, 0, 0.019)
    head = ellipsoid(0.022, 0.02, 0.017, 14, 8).move(-0.006, 0, 0.015)
    legs = []
    for s in (-1, 1):
        for n, a in enumerate((0.75, 1.3, 1.85, 2.4)):
            way = np.array([-np.cos(a), s * np.sin(a)])
            reach = 0.056 + 0.006 * (n in (0, 3))
            legs.append(limb([(*(0.006 * way), 0.014), (*(0.45 * reach * way), 0.032),
                              (*(0.8 * reach * way), 0.02), (*(reach * way), 0.0012)],
                             [0.003, 0.0024, 0.002, 0.0011], 6))  # fmt: skip
    eyes = [ball(0.0042, 0.0042, 0.0042, (-0.015, s * 0.0045, 0.0195), 8) for s in (-1, 1)]
    tile = surfaces.speckles(look.rng, tint_color(color, 0.85), 8)
    mark = ellipsoid(0.012, 0.01, 0.004, 10, 4).move(0.026, 0, 0.0325)
    return shape([(join([body, head]), tile), (join(legs), tile),
                  (join([*eyes, mark]), surfaces.plain((206, 40, 40)))],
                 [hull_of(body, head), *(hull_above(*legs[n : n + 4])
                                         for n in (0, 4))]).scale(k)  # fmt: skip


@category("toy_bat", size=(0.213, 0.0745, 0.0192), mass=0.03, material="plastic", assembled=True,
          aliases=("rubber bat", "plastic bat", "vampire bat", "halloween bat", "bat decoration"),
          themes=("living",), colors=("black",), state="lying flat")  # fmt: skip
def toy_bat(look: Look) -> Shape:
    """A rubber bat lying flat with its wings spread."""
    k = look.between(0.9, 1.2)
    color = look.color("black", "black", "charcoal", "purple")
    side = [(0.0, 0.012), (0.03, 0.022), (0.06, 0.034), (0.1, 0.028), (0.094, 0.002),
            (0.078, -0.012), (0.066, 0.0), (0.05, -0.02), (0.038, -0.004), (0.02, -0.026),
            (0.012, -0.012)]  # fmt: skip
    outline = np.array([(x, y) for x, y in side[::-1]] + [(-x, y) for x, y in side[1:]])
    wings = prism(outline, 0, 0.003, 0.0008)
    body = ellipsoid(0.024, 0.046, 0.02, 14, 8).move(0, -0.003, 0.008)
    head = ball(0.022, 0.022, 0.018, (0, 0.024, 0.0085), 12)
    ears = [blade([(s * 0.006, 0.03, 0.009), (s * 0.009, 0.038, 0.011), (s * 0.01, 0.044, 0.01)],
                  0.009) for s in (-1, 1)]  # fmt: skip
    ribs = [tube([(s * 0.012, 0.014, 0.0034), (s * x, y, 0.0034)], 0.0012, 5) for s in (-1, 1)
            for x, y in ((0.06, 0.032), (0.078, -0.01), (0.05, -0.017))]  # fmt: skip
    eyes = [ball(0.004, 0.004, 0.004, (s * 0.005, 0.028, 0.016), 8) for s in (-1, 1)]
    dark = surfaces.speckles(look.rng, color, 8)
    return put_down([(join([wings, body, head, *ears]), dark),
                     (join(ribs), surfaces.plain(tint_color(color, 1.25))),
                     (join(eyes), surfaces.plain((220, 40, 40)))], wings, join([body, head]),
                    factor=k)  # fmt: skip


@category("raven", size=(0.205, 0.0864, 0.113), mass=0.2, material="plastic", aliases=("crow",
          "raven figure", "plastic raven", "fake crow", "blackbird", "raven ornament"),
          themes=("living",), colors=("black",))  # fmt: skip
def raven(look: Look) -> Shape:
    """A standing black raven."""
    thing = bird(Look(look.rng, {"color": "black", **look.attributes})).scale(1.5)
    dark = [replace(p, tile=(p.tile * 0.22 + 14).astype(np.uint8)) for p in thing.pieces[1:6]]
    return replace(thing, pieces=(thing.pieces[0], *dark, thing.pieces[6]))


@category("rat", size=(0.221, 0.0505, 0.0505), mass=0.04, material="plastic",
          aliases=("plastic rat", "rubber rat", "toy rat", "fake rat", "mouse figurine",
          "rat figurine", "plush mouse"), themes=("living",), colors=("gray",))  # fmt: skip
def rat(look: Look) -> Shape:
    """A rat or toy mouse on its belly, with raised ears and a long tail."""
    k = look.between(0.85, 1.15)
    color = look.color("gray", "gray", "brown", "charcoal", "white")
    body = ellipsoid(0.09, 0.05, 0.046, 18, 10).move(0.012, 0, 0.022)
    head = limb([(-0.02, 0, 0.024), (-0.045, 0, 0.022), (-0.068, 0, 0.014)], [0.02, 0.016, 0.004],
                12)  # fmt: skip
    ears = [ellipsoid(0.006, 0.018, 0.02, 10, 6).move(-0.034, s * 0.014, 0.04) for s in (-1, 1)]
    feet = [ellipsoid(0.02, 0.01, 0.008, 8, 5).move(x, s * 0.02, 0.004) for x in (-0.024, 0.035)
            for s in (-1, 1)]  # fmt: skip
    tail = limb([(0.052, 0, 0.012), (0.085, 0.014, 0.004), (0.115, -0.006, 0.003), (0.145, 0.008,
                0.002)], [0.0045, 0.0032, 0.0025, 0.0012], 6)  # fmt: skip
    eyes = [ball(0.005, 0.005, 0.005, (-0.05, s * 0.0105, 0.0275), 8) for s in (-1, 1)]
    nose = ball(0.006, 0.006, 0.005, (-0.0705, 0, 0.0145), 8)
    fur = surfaces.scratches(look.rng, color, tint_color(color, 0.8), 120)
    pink = surfaces.plain((226, 160, 156))
    return shape([(join([body, head]), fur), (join([*ears, *feet, tail, nose]), pink),
                  (join(eyes), BLACK)], [hull_above(body), hull_above(head), hull_above(tail),
                                         hull_above(*feet)]).scale(k)  # fmt: skip


@category("snake", size=(0.158, 0.13, 0.0692), mass=0.08, material="plastic", assembled=True,
          aliases=("rubber snake", "toy snake", "plastic snake", "fake snake", "coiled snake",
          "snake figurine", "cobra"), themes=("living",), colors=("green",))  # fmt: skip
def snake(look: Look) -> Shape:
    """A coiled rubber snake with its head raised."""
    k = look.between(0.9, 1.2)
    color = look.color("green", "lime", "black", "brown", "orange", "red")
    t = np.linspace(0, 1, 12)
    turn = 4.4 * np.pi * t
    away = 0.062 - 0.04 * t
    path = np.column_stack([away * np.cos(turn), away * np.sin(turn), 0.006 + 0.02 * t])
    path = np.concatenate([[(0.09, 0.012, 0.004)], path, [(0.006, -0.004, 0.05), (-0.02, -0.03,
                           0.056)]])  # fmt: skip
    radii = [0.0015, *np.interp(t, [0, 0.3, 1], [0.005, 0.009, 0.0095]), 0.0095, 0.0105]
    body = limb(path, radii, 10)
    body = body.move(z=-float(body.bounds[0, 2]))
    head = ellipsoid(0.03, 0.024, 0.017, 14, 8).turn(2, 0.85).move(-0.026, -0.036, 0.056)
    eyes = [ball(0.005, 0.005, 0.005, (-0.033 + s * 0.0065, -0.036 - s * 0.0065, 0.063), 8)
            for s in (-1, 1)]  # fmt: skip
    fork = [tube([(-0.035, -0.047, 0.054), (-0.044 + s * 0.002, -0.058 - s * 0.002, 0.052)], 0.0008,
                 5) for s in (-1, 1)]  # fmt: skip
    bands = surfaces.stripes([color, color, tint_color(color, 0.55)], 9)
    made = shape([(join([body, head]), bands), (join(eyes), BLACK),
                  (join(fork), surfaces.plain((206, 30, 50)))], [hull_above(body.scale(1, 1, 0.42)),
                                                                 hull_of(head)])  # fmt: skip
    return made.scale(k)


@category("nest", size=(0.135, 0.135, 0.05), mass=0.06, material="wood", hollow=True,
          aliases=("bird nest", "birds nest", "bird's nest", "easter nest"), themes=("living",),
          roles=("container", "round"), colors=("brown",))  # fmt: skip
def nest(look: Look) -> Shape:
    """An open bird's nest of straw, sometimes with three eggs."""
    color = look.color("brown", "tan", "bronze", "beige", "terracotta")
    r = look.between(0.06, 0.075)
    body, parts = open_vessel([(0.6 * r, 0), (0.92 * r, 0.014), (r, 0.032), (0.92 * r, 0.042)],
                              0.022, 0.012)  # fmt: skip
    straws: list[Solid] = []
    for k in range(46):
        a, z = 2.4 * k, 0.01 + 0.034 * ((k * 7) % 46) / 46
        out = 0.93 * r + look.between(-0.004, 0.003)
        b = a + look.between(0.35, 0.6)
        straws.append(straight((out * np.cos(a), out * np.sin(a), z),
                               (out * np.cos(b), out * np.sin(b), z + look.between(-0.008, 0.008)),
                               0.0016, 4))  # fmt: skip
    straw = surfaces.scratches(look.rng, color, tint_color(color, 0.6), 90)
    return shape([(body, straw), (join(straws), surfaces.plain(tint_color(color, 1.25)))], parts)


CATEGORIES = (
    Category("hamster", _rodent(0.085, 0.13, 0.0, ("tan", "amber", "white", "gray", "brown")),
             size=(0.11, 0.0522, 0.0462), mass=0.12, material="plastic",
             aliases=("gerbil", "toy hamster", "dormouse"), themes=("living",), colors=("tan",)),
    Category("guinea_pig", _rodent(0.19, 0.1, 0.0, ("brown", "black", "white", "tan")),
             size=(0.249, 0.118, 0.104), mass=0.8, material="plastic",
             aliases=("cavy", "toy guinea pig"), themes=("living",), roles=("big",),
             colors=("brown",)),
    Category("chick",
             _bird(0.06, ("yellow", "yellow", "gold", "amber"), tail=0.0, crest=False, fluffy=True),
             size=(0.05, 0.0363, 0.0587), mass=0.03, material="plastic", aliases=("baby chick",
             "chick toy", "fluffy chick", "toy chick", "easter chick", "ceramic chick",
             "yellow chick", "chick figurine", "chick ornament", "marshmallow chick", "duckling"),
             themes=("living",), colors=("yellow",)),
    Category("budgie", _bird(0.15, ("green", "lime", "blue", "yellow", "sky", "white"), tail=0.3,
             crest=False, fluffy=False), size=(0.136, 0.0658, 0.151), mass=0.04, material="plastic",
             assembled=True, aliases=("budgerigar", "parakeet", "canary", "parrot", "cockatiel",
             "lovebird", "toy parrot"), themes=("living",), colors=("green",)),
    Category("hen", _bird(0.14, ("brown", "white", "copper", "black"), tail=0.12, crest=True,
             fluffy=False), size=(0.0986, 0.0596, 0.148), mass=0.3, material="plastic",
             aliases=("toy hen", "ceramic hen", "hen figurine", "rooster", "cockerel",
             "toy chicken", "hen ornament", "ceramic chicken", "ceramic rooster"),
             themes=("living",), colors=("brown",)),
    Category("tortoise", _shelled_animal(False), size=(0.137, 0.0948, 0.0662), mass=0.3,
             material="plastic", aliases=("toy tortoise", "tortoise figurine", "terrapin"),
             themes=("living",), colors=("olive",)),
    Category("turtle", _shelled_animal(True), size=(0.152, 0.163, 0.053), mass=0.3,
             material="plastic", assembled=True,
             aliases=("sea turtle", "toy turtle", "turtle figurine"), themes=("living",),
             colors=("green",)),
    Category("gecko", _lizard(0.17, ("yellow", "amber", "tan", "lime"), spotted=True, fat=1.15),
             size=(0.174, 0.0561, 0.0151), mass=0.05, material="plastic", assembled=True,
             aliases=("leopard gecko", "salamander", "newt"), themes=("living",),
             colors=("yellow",), state="lying"),
    Category("lizard", _lizard(0.24, ("green", "brown", "olive", "teal"), spotted=False, fat=0.9),
             size=(0.235, 0.0757, 0.0187), mass=0.08, material="plastic", assembled=True,
             aliases=("toy lizard", "bearded dragon", "chameleon", "iguana", "rubber lizard"),
             themes=("living",), colors=("green",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
