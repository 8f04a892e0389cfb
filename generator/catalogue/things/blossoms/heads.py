"""Blossoms at the origin that open along +z: layered, faced, clustered, in spikes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...build.forms import blade
from ...build.recipes import Pieces, ball, rod
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..nature.flowers import Head, corolla

Rows = Sequence[tuple[int, float, float, float, float]]
"""Rings of petals: how many, their length and width, how steep, how high up."""

GOLD: RGB = (238, 188, 50)
GREEN: RGB = (84, 126, 64)


def layered_head(rows: Rows, heart: float = 0.0, eye: RGB | None = GOLD, fade: float = 0.1) -> Head:
    """Return rings of petals one over the other, the inner ones deeper in colour."""

    def head(look: Look, color: RGB) -> Pieces:
        made: Pieces = []
        for n, (count, long, wide, lift, z) in enumerate(rows):
            ring = [p.move(z=z) for p in corolla(count, long, wide, lift, 0.5 * n)]
            made.append((join(ring), textures.speckles(look.rng, tint_color(color, 1 - fade * n),
                                                       7)))  # fmt: skip
        if heart:
            top = max(z for *_, z in rows)
            tone = tint_color(color, 0.8) if eye is None else eye
            made.append((ball(2 * heart, 2 * heart, 1.3 * heart, (0, 0, top + 0.3 * heart), 12),
                         textures.spots(look.rng, tone, tint_color(tone, 0.6), 0.2)))  # fmt: skip
        return made

    return head


def open_head(count: int, long: float, wide: float, lift: float, heart: float, eye: RGB,
          ring: RGB | None = None, pistil: float = 0.0) -> Head:  # fmt: skip
    """Return a few broad petals round an eye, with a ring of another colour or a long pistil."""

    def head(look: Look, color: RGB) -> Pieces:
        made: Pieces = [(join(corolla(count, long, wide, lift)),
                         textures.speckles(look.rng, color, 8))]  # fmt: skip
        if ring is not None:
            inner = [p.move(z=0.0012) for p in corolla(count, 0.55 * long, 0.6 * wide, lift)]
            made.append((join(inner), textures.plain(ring)))
        centre = [ball(2 * heart, 2 * heart, 1.4 * heart, (0, 0, 0.4 * heart + 0.002), 10)]
        if pistil:
            centre.append(rod([(0, 0, 0), (0, 0, pistil)], 0.0016, 6, 1))
            centre += [ball(0.004, 0.004, 0.004, (0.003 * np.cos(a), 0.003 * np.sin(a), pistil), 6)
                       for a in (0, 2.1, 4.2)]  # fmt: skip
        made.append((join(centre), textures.plain(eye)))
        return made

    return head


def cluster(count: int, radius: float, size: float, eye: RGB | None = None) -> Head:
    """Return a dome of small four-petalled florets."""

    def head(look: Look, color: RGB) -> Pieces:
        florets, dots = [], []
        for k in range(count):
            up = 1 - 1.25 * (k + 0.5) / count
            flat = np.sqrt(1 - up * up)
            a = 2.4 * k
            at = radius * np.array([flat * np.cos(a), flat * np.sin(a), 0.85 * up + 0.5])
            one = [ellipsoid(size, 0.5 * size, 0.3 * size, 6, 3).turn(2, t) for t in (0, np.pi / 2)]
            both = join(one).turn(1, float(np.arccos(np.clip(up, -1, 1)))).turn(2, a)
            florets.append(both.move(*at))
            if eye is not None:
                dots.append(ball(0.25 * size, 0.25 * size, 0.25 * size, tuple(1.04 * at), 5))
        tile = textures.spots(look.rng, color, tint_color(color, 1.3), 0.3)
        made: Pieces = [(join(florets), tile),
                        (ball(1.7 * radius, 1.7 * radius, 1.4 * radius, (0, 0, 0.5 * radius), 12),
                         textures.plain(tint_color(color, 0.7)))]  # fmt: skip
        if dots and eye is not None:
            made.append((join(dots), textures.plain(eye)))
        return made

    return head


def bell(r: float, long: float) -> Solid:
    """Return an open bell that opens along +z."""
    return lathe([(0, 0), (0.55 * r, 0.12 * long), (0.7 * r, 0.6 * long), (1.15 * r, long),
                  (0.5 * r, 0.7 * long), (0, 0.5 * long)], 8)  # fmt: skip


def spike(count: int, long: float, wide: float, size: float, droop: float, *, one_side: bool = False
          ) -> Head:  # fmt: skip
    """Return bells up a stem, smaller towards the tip; ``droop`` turns them down."""

    def head(look: Look, color: RGB) -> Pieces:
        bells = []
        for k in range(count):
            t = (k + 0.5) / count
            s = size * (1.15 - 0.65 * t)
            a = 0.5 * np.sin(9.0 * k) if one_side else 2.4 * k
            one = bell(s, 1.7 * s).turn(1, droop).move(0.35 * wide * (1.1 - 0.6 * t), 0, 0)
            bells.append(one.turn(2, a).move(z=long * t))
        stalk = rod([(0, 0, -0.004), (0, 0, 0.98 * long)], [0.0026, 0.0014], 6, 2)
        tip = ball(0.7 * size, 0.7 * size, 1.6 * size, (0, 0, long), 8)
        return [(join(bells), textures.gradient(tint_color(color, 0.85), tint_color(color, 1.25),
                                                look.rng)),
                (join([stalk, tip]), textures.plain(GREEN))]  # fmt: skip

    return head


def daffodil(look: Look, color: RGB) -> Pieces:
    """Six petals and a frilled trumpet."""
    horn = lathe([(0, 0), (0.008, 0.002), (0.009, 0.014), (0.0145, 0.024), (0.012, 0.0235),
                  (0.007, 0.013), (0, 0.006)], 14)  # fmt: skip
    deep = look.pick([(238, 130, 30), (246, 170, 30)])
    return [(join([*corolla(3, 0.03, 0.019, 0.12), *corolla(3, 0.03, 0.019, 0.22, np.pi / 3)]),
             textures.speckles(look.rng, color, 6)), (horn, textures.plain(deep))]  # fmt: skip


def iris(look: Look, color: RGB) -> Pieces:
    """Three petals that fall, three that stand, yellow tongues."""
    fall, stand, tongue = [], [], []
    for k in range(3):
        a = 2 * np.pi * k / 3
        fall.append(blade([(0.002, 0, 0), (0.02, 0, 0.012), (0.038, 0, 0.004), (0.046, 0, -0.012)],
                          0.028, thick=0.16).turn(2, a))  # fmt: skip
        stand.append(blade([(0.004, 0, 0), (0.013, 0, 0.02), (0.009, 0, 0.044)], 0.026, thick=0.2)
                     .turn(2, a + np.pi / 3))  # fmt: skip
        tongue.append(rod([(0.008, 0, 0.009), (0.02, 0, 0.0155), (0.029, 0, 0.014)], 0.0026, 6, 2)
                      .turn(2, a))  # fmt: skip
    return [(join(fall), textures.speckles(look.rng, tint_color(color, 0.9), 8)),
            (join(stand), textures.speckles(look.rng, tint_color(color, 1.3), 8)),
            (join(tongue), textures.plain(GOLD))]  # fmt: skip


def cup(count: int, long: float, wide: float, lift: float) -> Head:
    """Return upright petals that close to a cup, with gold stamens."""

    def head(look: Look, color: RGB) -> Pieces:
        ring = [p.move(z=0.001) for p in corolla(count, long, wide, lift)]
        outer = corolla(count, long, wide, lift - 0.12, np.pi / count)
        heart = rod([(0, 0, 0), (0, 0, 0.7 * long)], [0.0035, 0.002], 6, 1)
        return [(join([*ring, *outer]), textures.gradient(tint_color(color, 0.8), color, look.rng)),
                (heart, textures.plain((240, 160, 30)))]  # fmt: skip

    return head


def pansy(look: Look, color: RGB) -> Pieces:
    """Five overlapping round petals, the lower ones with a dark face."""
    other = look.own_color("yellow", "white", "purple", "orange")
    up = [ellipsoid(0.026, 0.026, 0.003, 12, 4).move(s * 0.01, 0.013, 0) for s in (-1, 1)]
    side = [ellipsoid(0.024, 0.022, 0.003, 12, 4).move(s * 0.013, -0.004, 0.0015) for s in (-1, 1)]
    low = ellipsoid(0.028, 0.024, 0.003, 12, 4).move(0, -0.014, 0.003)
    face = [ellipsoid(0.012, 0.011, 0.002, 10, 4).move(x, y, 0.0042)
            for x, y in ((-0.008, -0.005), (0.008, -0.005), (0, -0.011))]  # fmt: skip
    return [(join(up), textures.speckles(look.rng, color, 8)),
            (join([*side, low]), textures.speckles(look.rng, other, 8)),
            (join(face), textures.plain((52, 22, 62))),
            (ball(0.005, 0.005, 0.004, (0, -0.003, 0.0055), 8), textures.plain(GOLD))]  # fmt: skip


def thistle(look: Look, color: RGB) -> Pieces:
    """A spiny green ball with a purple tuft."""
    burr = ellipsoid(0.022, 0.022, 0.024, 12, 8).move(z=0.006)
    spines = [rod([(0.008 * np.cos(2.4 * k), 0.008 * np.sin(2.4 * k), 0.0012 * k - 0.004),
                   (0.017 * np.cos(2.4 * k), 0.017 * np.sin(2.4 * k), 0.0012 * k)],
                  [0.0014, 0.0004], 4, 1) for k in range(18)]  # fmt: skip
    tuft = [rod([(0, 0, 0.014), (0.012 * np.sqrt((k + 1) / 30) * np.cos(2.4 * k),
                 0.012 * np.sqrt((k + 1) / 30) * np.sin(2.4 * k), 0.034)], [0.0016, 0.001], 4, 1)
            for k in range(30)]  # fmt: skip
    return [(join([burr, *spines]), textures.plain((104, 132, 86))),
            (join(tuft), textures.speckles(look.rng, color, 12))]  # fmt: skip


def snowdrop(look: Look, color: RGB) -> Pieces:
    """Three white petals round a small cup, hanging from a green knob."""
    outer = corolla(3, 0.024, 0.012, 1.15)
    inner = lathe([(0, 0.002), (0.005, 0.006), (0.0055, 0.014), (0, 0.013)], 8)
    return [(join(outer), textures.speckles(look.rng, color, 4)),
            (inner, textures.plain((214, 232, 196))),
            (ball(0.008, 0.008, 0.009, (0, 0, -0.001), 8), textures.plain(GREEN))]  # fmt: skip


def crane(look: Look, color: RGB) -> Pieces:
    """A green beak with orange flames and a blue arrow: the bird of paradise flower."""
    beak = rod([(0, 0, -0.01), (0.02, 0, 0.012), (0.075, 0, 0.03)], [0.006, 0.0085, 0.001], 8)
    flames = [blade([(0.016, 0, 0.01), (0.03 - 0.014 * n, 0.004 * (-1) ** n, 0.045),
                     (0.045 - 0.028 * n, 0.008 * (-1) ** n, 0.085 - 0.004 * n)], 0.017, thick=0.25)
              for n in range(4)]  # fmt: skip
    arrow = blade([(0.018, 0, 0.012), (0.045, 0, 0.04), (0.066, 0, 0.066)], 0.01, thick=0.5)
    return [(beak, textures.gradient((96, 132, 80), (180, 70, 60), look.rng)),
            (join(flames), textures.speckles(look.rng, color, 8)),
            (arrow, textures.plain((44, 60, 170)))]  # fmt: skip


def protea(look: Look, color: RGB) -> Pieces:
    """A cone of pale down in a bowl of pointed bracts."""
    bracts: list[Solid] = []
    for n, (count, long, out) in enumerate(((12, 0.05, 0.026), (10, 0.044, 0.02))):
        leaf = blade(
            [(0.008, 0, 0), (out, 0, 0.45 * long), (out * 0.95, 0, long)], 0.014, thick=0.2
        )
        bracts += [leaf.turn(2, 2 * np.pi * k / count + n * 0.25) for k in range(count)]
    down = lathe([(0, 0), (0.015, 0.006), (0.014, 0.026), (0.004, 0.042), (0, 0.043)], 12)
    base = cylinder(0.01, 0.012, 12, top=0.014).move(z=-0.008)
    return [(join(bracts), textures.gradient(tint_color(color, 0.75), tint_color(color, 1.3),
                                             look.rng)),
            (down, textures.scratches(look.rng, (240, 226, 214), (190, 150, 150), 80)),
            (base, textures.plain((120, 140, 90)))]  # fmt: skip
