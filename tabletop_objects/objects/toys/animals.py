"""Objects of the ``toys`` theme: animals."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...kit import surfaces
from ...kit.outlines import smooth
from ...kit.parts import above, hull_part
from ...kit.primitives import ball, drum, plate, rod, straight
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, cylinder, ellipsoid, join, prism, tube
from ...kit.surfaces import Look, Tile, plain, tint_color
from ..living.animals import bird


@category("balloon_animal", size=(0.239, 0.0687, 0.208), mass=0.01, material="plastic",
          assembled=True, aliases=("balloon dog", "balloon poodle", "balloon sculpture"),
          themes=("toys",), roles=("big",), colors=("pink", "red"))  # fmt: skip
@from_pieces(foot=0.05)
def balloon_animal(look: Look) -> Pieces:
    """A dog twisted from long balloons."""
    color = look.color("pink", "red", "blue", "yellow", "green", "orange")

    def sausage(a: tuple[float, float, float], b: tuple[float, float, float], r: float) -> Solid:
        p, q = np.array(a), np.array(b)
        t = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 13))
        path = p + (q - p) * ((t + 1) / 2)[:, None]
        return tube(path, r * np.maximum(1 - np.abs(t) ** 5, 0.02) ** 0.5, 14)

    limbs = [sausage((x, y, 0.012), (0.8 * x, 0.7 * y, 0.085), 0.016) for x in (-0.06, 0.06)
             for y in (-0.02, 0.02)]  # fmt: skip
    body = sausage((-0.06, 0, 0.1), (0.06, 0, 0.1), 0.019)
    neck = sausage((0.055, 0, 0.105), (0.085, 0, 0.165), 0.016)
    ears = [sausage((0.08, s * 0.005, 0.165), (0.062, s * 0.022, 0.215), 0.014) for s in (-1, 1)]
    nose = sausage((0.085, 0, 0.17), (0.135, 0, 0.168), 0.016)
    tail = sausage((-0.062, 0, 0.105), (-0.095, 0, 0.17), 0.012)
    skin = surfaces.gradient(tint_color(color, 0.85), tint_color(color, 1.25), look.rng)
    return [
        *((s, skin) for s in limbs),
        (body, skin),
        (neck, skin),
        (nose, skin),
        (tail, skin),
        (join(ears), skin),
    ]  # type: ignore[arg-type]


DARK = (44, 38, 36)


def _legs(reach: float, at: tuple[float, ...], z: float, thick: float = 0.0011) -> list[Solid]:
    """Return an insect's bent legs, with one pair at each of the x positions ``at``."""
    made = []
    for n, x in enumerate(at):
        lean = (0.35, 0.0, -0.35)[n % 3] * reach
        for s in (-1, 1):
            path = [(x, s * 0.1 * reach, z), (x + 0.6 * lean, s * 0.6 * reach, z + 0.12 * reach),
                    (x + lean, s * reach, 0.9 * thick)]  # fmt: skip
            made.append(rod(path, thick, 6, 3))
    return made


def _feelers(x: float, z: float, long: float) -> list[Solid]:
    return [rod([(x, s * 0.002, z), (x + 0.5 * long, s * 0.3 * long, z + 0.5 * long),
                 (x + long, s * 0.45 * long, z + 0.55 * long)], 0.0008, 5, 3)
            for s in (-1, 1)]  # fmt: skip


@category("ladybird", size=(0.0484, 0.0445, 0.0215), mass=0.012, material="plastic",
          aliases=("ladybug", "lady bird", "lady bug", "toy ladybird", "ladybird beetle"),
          themes=("toys",), colors=("red",))  # fmt: skip
def ladybird(look: Look) -> Shape:
    """A ladybird: a spotted dome with a dark head and legs."""
    color = look.color("red", "orange", "yellow", "crimson")
    k = look.between(0.8, 1.25)
    shell = ball(0.034, 0.03, 0.03, (0, 0, 0.005), 22)
    head = ball(0.014, 0.018, 0.014, (0.016, 0, 0.006), 14)
    places = [(0.35, 0.7), (-0.25, 0.8), (-0.8, 0.5), (0.05, 1.15), (-0.55, 1.15)]
    spots = []
    for x, s in places:
        for side in (-1, 1):
            a, b = 0.55 * x, side * s * 0.62
            p = np.array([0.017 * np.sin(a * 1.6), 0.015 * np.sin(b) * np.cos(a), 0.0])
            p[2] = 0.005 + 0.015 * np.sqrt(max(1 - (p[0] / 0.017) ** 2 - (p[1] / 0.015) ** 2, 0.03))
            spots.append(
                ball(0.006, 0.006, 0.0045, (float(p[0]), float(p[1]), float(p[2]) - 0.0008), 8)
            )
    seam = tube(smooth([(0.013, 0, 0.0152), (0, 0, 0.0202), (-0.0165, 0, 0.0062)], 4), 0.0007, 5)
    eyes = [ball(0.004, 0.004, 0.004, (0.021, s * 0.006, 0.009), 8) for s in (-1, 1)]
    legs = _legs(0.021, (0.008, 0.0, -0.008), 0.004)
    return put_down(
        [(shell, surfaces.speckles(look.rng, color, 4)), (join([head, *spots, seam, *legs,
          *_feelers(0.02, 0.01, 0.01)]), plain(DARK)), (join(eyes), plain((244, 240, 232)))],
        shell, head, factor=k)  # fmt: skip


@category("beetle", size=(0.0892, 0.0712, 0.0257), mass=0.015, material="plastic", assembled=True,
          aliases=("toy beetle", "stag beetle", "bug", "plastic bug", "cockroach", "insect",
          "toy insect"), themes=("toys",), colors=("brown", "black"))  # fmt: skip
def beetle(look: Look) -> Shape:
    """A large beetle with ridged wing cases and a horn."""
    color = look.color("brown", "black", "green", "navy", "maroon", "teal")
    k = look.between(0.8, 1.2)
    back = ball(0.05, 0.034, 0.03, (-0.01, 0, 0.008), 20)
    neck = ball(0.022, 0.03, 0.022, (0.018, 0, 0.009), 16)
    head = ball(0.014, 0.016, 0.012, (0.03, 0, 0.008), 12)
    horn = rod([(0.034, 0, 0.01), (0.047, 0, 0.014), (0.052, 0, 0.025)], [0.0028, 0.0008], 8)
    lines = [tube(smooth([(0.008, s * 0.003, 0.0205), (-0.01, s * 0.0045, 0.0232),
                          (-0.033, s * 0.003, 0.0125)], 4), 0.0006, 5)
             for s in (-2, 0, 2)]  # fmt: skip
    legs = _legs(0.034, (0.016, -0.002, -0.016), 0.006, 0.0016)
    gloss = surfaces.gradient(tint_color(color, 0.7), tint_color(color, 1.3), look.rng)
    return put_down([(join([back, neck]), gloss), (join([head, horn, *legs, *lines]), plain(
        tint_color(color, 0.4)))], back, neck, join([head, horn]), factor=k)  # fmt: skip


@category("bee", size=(0.0694, 0.0792, 0.0359), mass=0.01, material="plastic", assembled=True,
          aliases=("bumblebee", "bumble bee", "honeybee", "honey bee", "wasp", "toy bee"),
          themes=("toys",), colors=("yellow",))  # fmt: skip
def bee(look: Look) -> Shape:
    """A bee with a striped, furry body and clear wings."""
    color = look.color("yellow", "amber", "mustard")
    k = look.between(0.85, 1.25)
    stripes = surfaces.stripes([color, DARK], 4, upright=False)
    tail = ball(0.021, 0.022, 0.032, (0, 0, 0), 18).turn(1, np.pi / 2).move(-0.014, 0, 0.011)
    chest = ball(0.02, 0.02, 0.019, (0.006, 0, 0.012), 14)
    head = ball(0.012, 0.016, 0.014, (0.018, 0, 0.011), 12)
    eyes = [ball(0.006, 0.005, 0.008, (0.02, s * 0.007, 0.012), 8) for s in (-1, 1)]
    rim = [(0, 0), (0.012, 0.007), (0.015, 0.026), (0.006, 0.034), (-0.004, 0.022)]
    wings = [plate(np.array(rim) * [1, s] if s > 0 else (np.array(rim) * [1, s])[::-1], 0.0009)
             .turn(0, s * 0.35).move(-0.004, s * 0.003, 0.0195) for s in (-1, 1)]  # fmt: skip
    legs = _legs(0.015, (0.01, 0.004, -0.004), 0.006, 0.001)
    return put_down([(tail, stripes), (chest, surfaces.scratches(look.rng, tint_color(color, 0.85),
                                                                 (90, 66, 30), 90)),
                     (join([head, *eyes, *legs, *_feelers(0.022, 0.015, 0.009)]), plain(DARK)),
                     (join(wings), plain((226, 234, 238)))], tail, chest, head, factor=k,
                    foot=0.2)  # fmt: skip


@category("butterfly", size=(0.0614, 0.0889, 0.0287), mass=0.008, material="plastic",
          assembled=True, aliases=("toy butterfly", "moth", "paper butterfly"), themes=("toys",),
          colors=("orange", "blue"))  # fmt: skip
def butterfly(look: Look) -> Shape:
    """A butterfly with its wings half raised."""
    color = look.color("orange", "blue", "yellow", "pink", "purple", "turquoise", "white")
    k = look.between(0.8, 1.2)
    fore = np.array([(0.004, 0), (0.022, 0.008), (0.034, 0.032), (0.03, 0.052), (0.018, 0.05),
                     (0.002, 0.02)])  # fmt: skip
    hind = np.array([(0.003, 0), (0.002, 0.02), (-0.006, 0.04), (-0.022, 0.042), (-0.032, 0.024),
                     (-0.012, 0.004)])  # fmt: skip
    wings, marks, edges = [], [], []
    for s in (-1, 1):
        for rim, inner in ((fore, (0.024, 0.034)), (hind, (-0.016, 0.026))):
            way = rim if s > 0 else (rim * [1, -1])[::-1]
            mid = way.mean(0)
            for scale, thick, where in ((1.0, 0.0012, edges), (0.8, 0.0018, wings)):
                slab = plate(mid + (way - mid) * scale, thick, at=(0, 0, -thick / 2))
                where.append(slab.turn(0, s * 0.5).move(0, s * 0.002, 0.008))
            dot = drum(0.0045, 0.0026, (inner[0], s * inner[1], -0.0013), sides=10)
            marks.append(dot.turn(0, s * 0.5).move(0, s * 0.002, 0.008))
    body = ball(0.05, 0.007, 0.008, (-0.004, 0, 0.0065), 12)
    dark = plain(DARK if sum(color) > 250 else tint_color(color, 0.4))
    spot = look.own_color("white", "yellow", "cream", "coral")
    return put_down(
        [(join(edges), dark), (join(wings), surfaces.gradient(tint_color(color, 0.85),
          tint_color(color, 1.2), look.rng)), (join(marks), plain(spot)),
         (join([body, *_feelers(0.02, 0.008, 0.014)]), dark)],
        body, *edges, factor=k, foot=0.2)  # fmt: skip


@category("dragonfly", size=(0.0951, 0.116, 0.0145), mass=0.008, material="plastic", assembled=True,
          aliases=("toy dragonfly", "damselfly"), themes=("toys",),
          colors=("blue", "green"))  # fmt: skip
def dragonfly(look: Look) -> Shape:
    """A dragonfly with a long jointed tail and four clear wings."""
    color = look.color("blue", "green", "red", "turquoise", "purple")
    k = look.between(0.8, 1.2)
    tail = rod([(-0.06, 0, 0.004), (-0.02, 0, 0.006), (0.01, 0, 0.007)], [0.0024, 0.0032], 10)
    chest = ball(0.024, 0.014, 0.014, (0.014, 0, 0.0068), 14)
    eyes = [ball(0.009, 0.008, 0.009, (0.028, s * 0.005, 0.0075), 10) for s in (-1, 1)]
    wings = []
    for x, lean in ((0.018, 0.12), (0.006, -0.12)):
        for s in (-1, 1):
            one = ball(0.016, 0.055, 0.0012, (0, s * 0.03, 0), 14)
            wings.append(one.turn(2, -s * lean).move(x, 0, 0.0135))
    legs = _legs(0.012, (0.02, 0.014, 0.008), 0.005, 0.0008)
    return put_down(
        [(join([tail, chest]), surfaces.stripes([color, tint_color(color, 0.6)], 6, upright=True)),
         (join([*eyes, *legs]), plain(DARK)), (join(wings), plain((216, 230, 234)))],
        chest, tail, join(wings), factor=k, foot=0.3)  # fmt: skip


@category("ant", size=(0.054, 0.0405, 0.0174), mass=0.01, material="plastic", assembled=True,
          aliases=("toy ant", "plastic ant"), themes=("toys",), colors=("black",))  # fmt: skip
def ant(look: Look) -> Shape:
    """An ant with a three-part body, six legs and jaws."""
    color = look.color("black", "brown", "maroon", "red")
    k = look.between(0.8, 1.2)
    tail = ball(0.022, 0.016, 0.015, (-0.017, 0, 0.009), 14)
    waist = ball(0.015, 0.009, 0.009, (0.001, 0, 0.008), 12)
    head = ball(0.014, 0.013, 0.011, (0.015, 0, 0.009), 12)
    legs = _legs(0.02, (0.006, 0.001, -0.004), 0.007, 0.0011)
    jaws = [rod([(0.02, s * 0.003, 0.007), (0.027, s * 0.003, 0.006)], 0.001, 6) for s in (-1, 1)]
    body = [tail, waist, head]
    return put_down([(join([*body, *legs, *jaws, *_feelers(0.018, 0.012, 0.01)]),
                      surfaces.gradient(tint_color(color, 0.7), tint_color(color, 1.2), look.rng))],
                    join(body), *legs[:2], *legs[-2:], factor=k)  # fmt: skip


@category("caterpillar", size=(0.124, 0.029, 0.0307), mass=0.03, material="plastic",
          aliases=("toy caterpillar", "wooden caterpillar"), themes=("toys",),
          colors=("green",))  # fmt: skip
def caterpillar(look: Look) -> Shape:
    """A caterpillar: a row of plump rings with a face and antennae."""
    color, other = look.color("green", "lime", "yellow", "teal"), look.own_color("yellow", "orange")
    k = look.between(0.85, 1.2)
    rings, feet = [], []
    for n in range(7):
        d = 0.022 - 0.0007 * abs(n - 3)
        y = 0.005 * np.sin(1.1 * n)
        rings.append(ball(d, d, d, (0.0145 * (n - 3.4), y, 0.0095 + 0.003 * (n % 2)), 14))
        feet += [ball(0.005, 0.005, 0.006, (0.0145 * (n - 3.4), y + s * 0.007, 0.002), 6)
                 for s in (-1, 1)]  # fmt: skip
    head = ball(0.023, 0.024, 0.024, (0.0145 * 3.7, 0, 0.015), 16)
    eyes = [ball(0.005, 0.005, 0.007, (0.0145 * 3.7 + 0.009, s * 0.006, 0.019), 8) for s in (-1, 1)]
    return put_down(
        [(join(rings[::2]), plain(color)), (join(rings[1::2]), plain(tint_color(color, 1.3))),
         (head, plain(other)), (join([*feet, *eyes, *_feelers(0.056, 0.024, 0.012)]), plain(DARK))],
        join(rings), head, factor=k, foot=0.25)  # fmt: skip


@category("worm", size=(0.0942, 0.0289, 0.00711), mass=0.006, material="rubber",
          aliases=("lugworm", "soft plastic worm", "rubber worm", "maggot", "grub"),
          themes=("toys",), roles=("flat",), colors=("pink",))  # fmt: skip
def worm(look: Look) -> Shape:
    """A curved earthworm, lying flat."""
    color = look.color("pink", "terracotta", "brown", "coral", spread=14)
    k, a = look.between(0.8, 1.25), look.between(0.7, 1.3)
    x = np.linspace(-0.045, 0.045, 44)
    path = np.column_stack([x, 0.011 * a * np.sin(x * 110), 0.0031 + 0 * x])
    t = np.linspace(0, 1, 44)
    radii = 0.0034 * np.clip(6 * np.minimum(t, 1 - t) + 0.2, 0, 1) * (1 + 0.05 * np.cos(44 * t * 3))
    saddle = tube(path[26:32], 0.0039, 10)
    rings = surfaces.stripes([color, tint_color(color, 0.85)], 22)
    half = [tube(path[i : i + 12], 0.0034, 8) for i in (0, 11, 22, 32)]
    return put_down([(tube(path, radii, 10), rings), (saddle, plain(tint_color(color, 0.75)))],
                    *half, factor=k, foot=0.4)  # fmt: skip


@category("snail", size=(0.0794, 0.0237, 0.0503), mass=0.03, material="plastic",
          aliases=("toy snail", "garden snail", "ceramic snail", "snail figurine"),
          themes=("toys",), colors=("tan", "brown"))  # fmt: skip
def snail(look: Look) -> Shape:
    """A snail: a coiled shell on a soft foot with two eye stalks."""
    color = look.color("tan", "brown", "amber", "cream", "olive")
    k = look.between(0.75, 1.2)
    foot = rod([(-0.034, 0, 0.003), (-0.01, 0, 0.005), (0.02, 0, 0.007), (0.032, 0, 0.012)],
               [0.003, 0.009, 0.009, 0.006], 12)  # fmt: skip
    t = np.linspace(0, 5 * np.pi, 70)
    r = 0.0025 + 0.0135 * (t / t[-1]) ** 1.2
    y = 0.011 * (1 - t / t[-1]) * look.pick([-1, 1])
    path = np.column_stack([r * np.cos(t + 0.4) - 0.006, y, 0.0245 + r * np.sin(t + 0.4)])
    shell = tube(path, 0.0018 + 0.0075 * (t / t[-1]), 10)
    stalks = [
        rod([(0.031, s * 0.003, 0.014), (0.037, s * 0.005, 0.024)], 0.0013, 6) for s in (-1, 1)
    ]
    tips = [ball(0.0045, 0.0045, 0.0045, (0.037, s * 0.005, 0.0245), 8) for s in (-1, 1)]
    coil = surfaces.stripes([color, tint_color(color, 0.65), tint_color(color, 1.2)], 8)
    return put_down([(join([foot, *stalks]), surfaces.speckles(look.rng, (190, 170, 140), 8)),
                     (shell, coil), (join(tips), plain(DARK))], foot, shell, factor=k,
                    foot=0.2)  # fmt: skip


@dataclass(frozen=True)
class Beast:
    """The form of a four-legged animal that faces left; the unit of length is its body's length.

    ``body`` is its length, width and height; ``legs`` is their length and radius. ``neck`` is the
    position of the head's centre in front of the body (x) and above its centre (z), and the neck's
    radius. ``head`` is the length, width and height, and ``snout`` the length and height.
    """

    colors: tuple[str, ...]
    body: tuple[float, float, float] = (1.0, 0.42, 0.46)
    legs: tuple[float, float] = (0.42, 0.085)
    neck: tuple[float, float, float] = (0.2, 0.34, 0.13)
    head: tuple[float, float, float] = (0.3, 0.26, 0.27)
    snout: tuple[float, float] = (0.2, 0.17)
    ears: tuple[float, float] = (0.1, 0.13)
    tail: tuple[tuple[float, float], ...] = ((0.52, 0.08), (0.66, -0.05), (0.68, -0.25))
    skin: str = "plain"
    extras: tuple[str, ...] = ()
    long: float = 0.09


BEASTS: Mapping[str, Beast] = MappingProxyType(
    {
        "horse": Beast(("brown", "tan", "black", "white"), (1.0, 0.34, 0.38), (0.55, 0.07),
                       (0.16, 0.5, 0.12), (0.34, 0.2, 0.24), (0.3, 0.18), (0.07, 0.13),
                       extras=("mane", "hooves", "brush")),
        "unicorn": Beast(("white", "pink", "lavender"), (1.0, 0.36, 0.4), (0.5, 0.08),
                         (0.16, 0.48, 0.13), (0.34, 0.22, 0.26), (0.28, 0.18), (0.07, 0.13),
                         extras=("rainbow", "hooves", "horn", "brush")),
        "zebra": Beast(("white",), (1.0, 0.36, 0.4), (0.5, 0.075), (0.16, 0.46, 0.13),
                       (0.34, 0.2, 0.24), (0.28, 0.18), (0.08, 0.13), skin="bands",
                       extras=("mane", "hooves", "brush")),
        "cow": Beast(("white", "white", "brown"), (1.0, 0.44, 0.48), (0.4, 0.085),
                     (0.2, 0.26, 0.14), (0.34, 0.26, 0.28), (0.2, 0.2), (0.13, 0.08),
                     skin="patches", extras=("horns", "muzzle", "hooves")),
        "pig": Beast(("pink",), (1.0, 0.56, 0.58), (0.26, 0.1), (0.1, 0.1, 0.2),
                     (0.42, 0.42, 0.42), (0.14, 0.18), (0.15, 0.14),
                     ((0.5, 0.12), (0.58, 0.18), (0.56, 0.24)), extras=("muzzle",), long=0.08),
        "sheep": Beast(("white", "cream"), (1.0, 0.62, 0.62), (0.32, 0.075), (0.14, 0.22, 0.14),
                       (0.3, 0.24, 0.28), (0.14, 0.16), (0.16, 0.07), ((0.5, 0.1), (0.58, 0.06)),
                       skin="wool", extras=("dark head",), long=0.08),
        "elephant": Beast(("gray", "gray", "sky"), (1.0, 0.62, 0.64), (0.42, 0.13),
                          (0.16, 0.22, 0.2), (0.44, 0.4, 0.46), (0.0, 0.0), (0.0, 0.0),
                          ((0.5, 0.14), (0.58, 0.0), (0.58, -0.2)), extras=("trunk",), long=0.1),
        "giraffe": Beast(("amber", "gold"), (1.0, 0.4, 0.44), (0.8, 0.075), (0.2, 1.25, 0.11),
                         (0.34, 0.2, 0.22), (0.26, 0.15), (0.13, 0.07), skin="patches",
                         extras=("horns", "hooves"), long=0.075),
        "lion": Beast(("amber", "tan"), (1.0, 0.38, 0.4), (0.4, 0.085), (0.16, 0.28, 0.15),
                      (0.36, 0.3, 0.32), (0.16, 0.17), (0.08, 0.08),
                      ((0.48, 0.08), (0.64, 0.14), (0.7, 0.34)), extras=("ruff",)),
        "tiger": Beast(("orange",), (1.0, 0.38, 0.4), (0.38, 0.085), (0.16, 0.26, 0.15),
                       (0.36, 0.32, 0.32), (0.15, 0.17), (0.09, 0.1),
                       ((0.48, 0.08), (0.66, 0.1), (0.74, 0.3)), skin="bands"),
        "dog": Beast(("brown", "tan", "black", "white", "gray"), (1.0, 0.4, 0.42), (0.42, 0.085),
                     (0.16, 0.36, 0.14), (0.38, 0.32, 0.34), (0.22, 0.18), (0.15, 0.1),
                     ((0.46, 0.12), (0.6, 0.26), (0.64, 0.44)), extras=("muzzle",), long=0.08),
        "cat": Beast(("gray", "orange", "black", "white", "tan"), (1.0, 0.38, 0.4), (0.38, 0.075),
                     (0.14, 0.34, 0.13), (0.36, 0.36, 0.34), (0.1, 0.13), (0.15, 0.12),
                     ((0.46, 0.1), (0.62, 0.22), (0.6, 0.5), (0.66, 0.6)), long=0.075),
        "rabbit": Beast(("white", "brown", "gray", "tan"), (1.0, 0.62, 0.66), (0.16, 0.13),
                        (0.06, 0.46, 0.2), (0.48, 0.42, 0.44), (0.12, 0.16), (0.17, 0.34),
                        ((0.5, 0.1), (0.56, 0.12)), extras=("puff",), long=0.065),
        "fox": Beast(("orange",), (1.0, 0.36, 0.38), (0.4, 0.07), (0.16, 0.34, 0.13),
                     (0.38, 0.34, 0.3), (0.26, 0.12), (0.13, 0.18),
                     ((0.46, 0.08), (0.72, 0.1), (1.0, 0.22)), extras=("bushy", "hooves")),
    }
)  # fmt: skip
"""The animals by key."""


_RAINBOW = ((236, 96, 130), (250, 196, 90), (110, 190, 150), (120, 150, 220), (170, 120, 210))


def _coat(look: Look, beast: Beast, color: tuple[float, float, float]) -> Tile:
    """Return the texture of an animal's coat."""
    dark = tint_color(color, 0.45)
    if beast.skin == "bands":
        return surfaces.stripes([color, color, (40, 38, 40)], 7, side=96)
    if beast.skin == "patches":
        patch = dark if sum(color) < 600 else look.pick([(44, 42, 44), (110, 74, 50)])
        mask = surfaces.noise(look.rng, 64, 64, (6, 6), 1)
        image = np.broadcast_to(np.array(color), (64, 64, 3)).copy()
        image[mask > 0.12] = patch
        return np.clip(image, 0, 255).astype(np.uint8)
    if beast.skin == "wool":
        return surfaces.spots(look.rng, color, tint_color(color, 0.82), 0.3)
    return surfaces.speckles(look.rng, color, 6)


def beast_shape(key: str) -> Callable[[Look], Shape]:
    """Return the shape function of the four-legged animal named ``key``."""

    def make(look: Look) -> Shape:
        return _beast(look, BEASTS[key])

    return make


def _beast(look: Look, b: Beast) -> Shape:
    color = look.color(*b.colors)
    coat, dark = _coat(look, b, color), surfaces.plain((34, 32, 34))
    pale = surfaces.plain(tint_color(color, 1.6) if sum(color) < 640 else (246, 206, 200))
    plain = surfaces.plain((60, 56, 56) if "dark head" in b.extras else color)
    (long, wide, tall), (leg, thick) = b.body, b.legs
    mid = leg + 0.42 * tall
    body = ellipsoid(tall, wide, long, 20, 12).turn(1, np.pi / 2).move(z=mid)
    hx, hz = -long / 2 - b.neck[0] + 0.12, mid + b.neck[1]
    head = ball(*b.head, (hx, 0, hz))
    neck = straight((-0.3 * long, 0, mid + 0.05), (hx + 0.04, 0, hz - 0.02),
                    [b.neck[2] * 1.25, b.neck[2]], 10)  # fmt: skip
    sx, sy = 0.32 * long, 0.5 * wide - 0.9 * thick
    feet = [(x, y) for x in (-sx, sx) for y in (-sy, sy)]
    legs = [cylinder(thick, mid, 12, top=1.15 * thick).move(x, y) for x, y in feet]
    skin = dark if "dark head" in b.extras else coat
    pieces = [(body, coat), (neck, coat), (head, plain), (join(legs), skin)]
    tail = rod([(x, 0, mid + z) for x, z in b.tail],
               0.1 if "bushy" in b.extras else 0.03, 8)  # fmt: skip
    pieces.append((tail, coat if b.skin != "wool" else plain))
    front = hx - 0.5 * b.head[0]
    if b.snout[0]:
        at = (front + 0.1 * b.head[0], 0, hz - 0.12 * b.head[2])
        pieces.append((ball(1.5 * b.snout[0], 0.75 * b.head[1], b.snout[1], at),
                       pale if "muzzle" in b.extras else plain))  # fmt: skip
        tip = at[0] - 0.74 * b.snout[0]
        pieces.append((ball(0.05, 0.08, 0.05, (tip, 0, at[2] + 0.04), 8), dark))
    eyes = [ball(0.05, 0.05, 0.06, (hx - 0.36 * b.head[0], s * 0.33 * b.head[1],
                                    hz + 0.16 * b.head[2]), 8) for s in (-1, 1)]  # fmt: skip
    pieces.append((join(eyes), dark))
    if b.ears[0]:
        ears = [ball(0.07, b.ears[0], 2 * b.ears[1], (0, 0, 0), 10).turn(0, -0.45 * s)
                .move(hx + 0.2 * b.head[0], s * 0.36 * b.head[1],
                      hz + 0.4 * b.head[2] + 0.4 * b.ears[1]) for s in (-1, 1)]  # fmt: skip
        pieces.append((join(ears), plain))
    pieces += _extras(look, b, (hx, hz, mid), feet)
    low = join(legs)
    hulls = [body, head, join([low.scale(1, 1, 0.6)]), neck]
    return shape(pieces, [hull_part(above(s.vertices)) for s in hulls]).scale(
        b.long * look.between(0.86, 1.16)
    )


def _extras(
    look: Look, b: Beast, at: tuple[float, float, float], feet: list[tuple[float, float]]
) -> list[tuple[Solid, Tile]]:
    """Return the additional parts of an animal, such as a mane, horns or a trunk."""
    hx, hz, mid = at
    dark, pale = surfaces.plain((44, 38, 36)), surfaces.plain((242, 234, 214))
    made: list[tuple[Solid, Tile]] = []
    back = [(hx + 0.2 * b.head[0], 0, hz + 0.5 * b.head[2]), (hx + 0.3, 0, hz - 0.02),
            (-0.26, 0, mid + 0.3 * b.body[2])]  # fmt: skip
    if "mane" in b.extras or "rainbow" in b.extras:
        tile = surfaces.stripes(_RAINBOW, 1) if "rainbow" in b.extras else dark
        made.append((rod(back, [0.05, 0.075, 0.04], 8), tile))
    if "brush" in b.extras:
        tile = surfaces.stripes(_RAINBOW, 1) if "rainbow" in b.extras else dark
        made.append((rod([(x + 0.01, 0, mid + z) for x, z in b.tail], [0.04, 0.07, 0.02], 8), tile))
    if "hooves" in b.extras:
        hooves = [cylinder(1.2 * b.legs[1], 0.09, 12).move(x, y) for x, y in feet]
        made.append((join(hooves), dark))
    if "horn" in b.extras:
        horn = cylinder(0.045, 0.3, 10, top=0.004).turn(1, -0.5)
        made.append((horn.move(hx - 0.12, 0, hz + 0.4 * b.head[2]), surfaces.plain((236, 190, 80))))
    if "horns" in b.extras:
        horns = [cylinder(0.035, 0.15, 8, top=0.02).turn(0, -0.35 * s)
                 .move(hx + 0.06, s * 0.07, hz + 0.4 * b.head[2]) for s in (-1, 1)]  # fmt: skip
        made.append((join(horns), pale))
    if "ruff" in b.extras:
        ruff = ball(0.24, 0.56, 0.58, (hx + 0.14, 0, hz), 16)
        made.append((ruff, surfaces.scratches(look.rng, (126, 76, 40), (90, 52, 28), 60)))
        made.append((ball(0.13, 0.11, 0.13, (b.tail[-1][0], 0, mid + b.tail[-1][1]), 8), dark))
    if "puff" in b.extras:
        made.append((ball(0.2, 0.2, 0.2, (0.52, 0, mid), 10), surfaces.plain((246, 244, 240))))
    if "bushy" in b.extras:
        made.append((ball(0.26, 0.17, 0.17, (1.02, 0, mid + 0.23), 10), pale))
    if "trunk" in b.extras:
        x = hx - 0.2
        nose = rod([(x, 0, hz), (x - 0.16, 0, hz - 0.22), (x - 0.16, 0, hz - 0.5),
                    (x - 0.26, 0, hz - 0.56)], [0.12, 0.09, 0.065, 0.05], 10)  # fmt: skip
        grey = surfaces.plain(look.own_color("gray"))
        ears = [ball(0.1, 0.09, 0.5, (hx + 0.16, s * 0.26, hz), 12).scale(1, 1, 1)
                for s in (-1, 1)]  # fmt: skip
        flaps = [ball(0.08, 0.36, 0.46, (0, 0, 0), 14).turn(2, s * 0.5)
                 .move(hx + 0.12, s * 0.34, hz) for s in (-1, 1)]  # fmt: skip
        tusks = [rod([(x, s * 0.12, hz - 0.16), (x - 0.14, s * 0.13, hz - 0.24),
                      (x - 0.24, s * 0.13, hz - 0.18)], [0.035, 0.028, 0.01], 6)
                 for s in (-1, 1)]  # fmt: skip
        made += [(join([nose, *ears]), grey), (join(flaps), grey), (join(tusks), pale)]
    return made


TOY_DINOSAUR_DARK = surfaces.plain((34, 32, 34))


@category("toy_dinosaur", size=(0.165, 0.047, 0.12), mass=0.08, material="plastic",
          aliases=("dinosaur", "dinosaur toy", "dinosaur figure", "dino", "t rex", "t-rex",
          "tyrannosaurus", "brontosaurus", "plastic dinosaur", "tyrannosaurus rex"),
          themes=("toys",), colors=("green",))  # fmt: skip
def toy_dinosaur(look: Look) -> Shape:
    """A toy dinosaur facing left: a long-necked sauropod, or a tyrannosaur on its hind legs."""
    color = look.color("green", "olive", "teal", "orange", "violet", "blue", "red")
    skin = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.12)
    pale = surfaces.plain(tint_color(color, 1.5))
    k = look.between(0.92, 1.1)
    plates = []
    if look.chance(0.5):  # sauropod
        body = ball(0.075, 0.044, 0.046, (0, 0, 0.042), 18)
        neck = rod([(-0.025, 0, 0.048), (-0.05, 0, 0.068), (-0.062, 0, 0.1)],
                   [0.015, 0.011, 0.008], 10)  # fmt: skip
        head = ball(0.03, 0.018, 0.017, (-0.07, 0, 0.105), 12)
        tail = rod([(0.025, 0, 0.045), (0.06, 0, 0.034), (0.1, 0, 0.022)],
                   [0.016, 0.009, 0.002], 10)  # fmt: skip
        legs = join([cylinder(0.0095, 0.04, 12, top=0.011).move(x, y)
                     for x in (-0.02, 0.022) for y in (-0.013, 0.013)])  # fmt: skip
        eyes = join([ball(0.004, 0.004, 0.004, (-0.075, s * 0.008, 0.109), 8) for s in (-1, 1)])
        spine = [(-0.04, 0.08), (-0.02, 0.064), (0, 0.066), (0.02, 0.064), (0.045, 0.052)]
    else:  # tyrannosaur
        body = ball(0.04, 0.036, 0.07, (0, 0, 0.06), 18).turn(1, -0.25).move(x=0.015)
        neck = rod([(-0.005, 0, 0.08), (-0.015, 0, 0.098), (-0.02, 0, 0.106)], 0.013, 10)
        head = join([ball(0.046, 0.028, 0.028, (-0.03, 0, 0.112), 14),
                     ball(0.03, 0.022, 0.012, (-0.034, 0, 0.099), 12)])  # fmt: skip
        tail = rod([(0.012, 0, 0.05), (0.05, 0, 0.026), (0.09, 0, 0.006)],
                   [0.018, 0.011, 0.003], 10)  # fmt: skip
        feet = [ball(0.034, 0.018, 0.016, (-0.006, s * 0.016, 0.005), 10) for s in (-1, 1)]
        thighs = [ball(0.03, 0.018, 0.045, (0.006, s * 0.016, 0.03), 12) for s in (-1, 1)]
        arms = [straight((-0.01, s * 0.014, 0.074), (-0.026, s * 0.014, 0.066), 0.004, 6)
                for s in (-1, 1)]  # fmt: skip
        legs = join([*feet, *thighs, *arms])
        eyes = join([ball(0.006, 0.004, 0.006, (-0.034, s * 0.012, 0.12), 8) for s in (-1, 1)])
        spine = [(0.0, 0.108), (0.014, 0.09), (0.024, 0.07), (0.036, 0.05), (0.054, 0.032)]
    for x, z in spine:
        plates.append(cylinder(0.007, 0.012, 4, top=0.0006).scale(1, 0.4, 1).move(x, 0, z - 0.004))
    pieces: Pieces = [(body, skin), (neck, skin), (head, skin), (tail, skin), (legs, skin),
                      (join(plates), pale), (eyes, TOY_DINOSAUR_DARK)]  # fmt: skip
    return put_down(pieces, body, head, tail, legs, factor=k)


@category("toy_dragon", size=(0.115, 0.085, 0.125), mass=0.09, material="plastic",
          aliases=("dragon", "dragon figure", "dragon figurine", "dragon statue", "dragon toy"),
          themes=("toys",), colors=("red", "green"))  # fmt: skip
def toy_dragon(look: Look) -> Shape:
    """A sitting toy dragon with raised wings."""
    color = look.color("red", "green", "purple", "teal", "black", "blue")
    skin = surfaces.spots(look.rng, color, tint_color(color, 1.3), 0.15)
    belly = surfaces.plain(look.pick([(236, 196, 110), tint_color(color, 1.6)]))
    body = ball(0.056, 0.05, 0.076, (0, 0, 0.034), 18)
    front = ball(0.03, 0.036, 0.06, (-0.016, 0, 0.034), 14)
    neck = rod([(0, 0, 0.06), (-0.006, 0, 0.08), (-0.016, 0, 0.096)], [0.015, 0.011, 0.01], 10)
    head = join([ball(0.034, 0.03, 0.028, (-0.018, 0, 0.102), 14),
                 ball(0.028, 0.02, 0.015, (-0.036, 0, 0.097), 12)])  # fmt: skip
    horns = [cylinder(0.004, 0.02, 8, top=0.0008).turn(1, 0.6).move(-0.01, s * 0.01, 0.112)
             for s in (-1, 1)]  # fmt: skip
    feet = [ball(0.03, 0.02, 0.014, (-0.024, s * 0.02, 0.005), 10) for s in (-1, 1)]
    tail = rod([(0.02, 0, 0.012), (0.05, 0.01, 0.008), (0.062, -0.02, 0.007),
                (0.04, -0.046, 0.007)], [0.014, 0.009, 0.006, 0.003], 8)  # fmt: skip
    outline = np.array([(0, 0), (0.05, 0.005), (0.042, 0.018), (0.05, 0.04), (0.03, 0.036),
                        (0.012, 0.05)])  # fmt: skip
    wings = [prism(outline, -0.001, 0.001).turn(0, np.pi / 2).turn(2, s * 0.6)
             .move(0.012, s * 0.016, 0.045) for s in (-1, 1)]  # fmt: skip
    eyes = join([ball(0.006, 0.005, 0.006, (-0.027, s * 0.011, 0.109), 8) for s in (-1, 1)])
    pieces: Pieces = [(join([body, neck, *feet]), skin), (front, belly), (head, skin),
                      (join(horns), belly), (tail, skin), (join(wings), belly),
                      (eyes, TOY_DINOSAUR_DARK)]  # fmt: skip
    return put_down(pieces, join([body, *feet]), join([neck, head]), tail, *wings,
                   factor=look.between(0.95, 1.2))  # fmt: skip


@category("frog", size=(0.0965, 0.111, 0.0695), mass=0.15, material="ceramic",
          aliases=("ceramic frog", "toy frog", "frog figurine", "frog figure", "toad",
          "frog statue", "garden frog", "stone frog", "frog model"), themes=("toys", "living"),
          colors=("green",))  # fmt: skip
def frog(look: Look) -> Shape:
    """A crouching ceramic frog."""
    color = look.color("green", "lime", "olive", "teal", "green")
    skin = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.1)
    pale = surfaces.plain(tint_color(color, 1.7))
    body = ball(0.066, 0.06, 0.048, (0, 0, 0.022), 18).turn(1, 0.2).move(z=0.002)
    head = ball(0.04, 0.054, 0.034, (-0.028, 0, 0.04), 16)
    bulges = [ball(0.017, 0.017, 0.017, (-0.032, s * 0.017, 0.056), 12) for s in (-1, 1)]
    pupils = [ball(0.009, 0.008, 0.01, (-0.038, s * 0.019, 0.058), 8) for s in (-1, 1)]
    legs = [ball(0.044, 0.022, 0.03, (0.018, s * 0.03, 0.013), 12) for s in (-1, 1)]
    feet = [ball(0.03, 0.02, 0.008, (x, s * y, 0.002), 10)
            for s in (-1, 1) for x, y in ((-0.036, 0.022), (0.0, 0.042))]  # fmt: skip
    arms = [straight((-0.026, s * 0.02, 0.03), (-0.034, s * 0.022, 0.004), 0.006) for s in (-1, 1)]
    mouth = ball(0.032, 0.05, 0.003, (-0.033, 0, 0.036), 14)
    pieces: Pieces = [(join([body, head, *bulges, *legs, *feet, *arms]), skin),
                      (mouth, pale), (join(pupils), TOY_DINOSAUR_DARK)]  # fmt: skip
    return put_down(pieces, join([body, *legs, *feet]), join([head, *bulges]),
                   factor=look.between(0.9, 1.2))  # fmt: skip


CATEGORIES = (
    Category("toy_horse", beast_shape("horse"), size=(0.15, 0.035, 0.115), mass=0.06,
             material="plastic", assembled=True, aliases=("horse", "horse figure", "plastic horse",
             "wooden horse", "horse statue", "pony", "toy pony"), themes=("toys",),
             colors=("brown", "tan")),
    Category("toy_unicorn", beast_shape("unicorn"), size=(0.15, 0.035, 0.12), mass=0.06,
             material="plastic", assembled=True, aliases=("unicorn", "unicorn figure",
             "plastic unicorn", "wooden unicorn", "unicorn statue"), themes=("toys",),
             colors=("white", "pink")),
    Category("toy_zebra", beast_shape("zebra"), size=(0.15, 0.035, 0.11), mass=0.06,
             material="plastic", assembled=True,
             aliases=("zebra", "zebra figure", "plastic zebra", "wooden zebra", "zebra statue"),
             themes=("toys",), colors=("white",)),
    Category("toy_cow", beast_shape("cow"), size=(0.15, 0.04, 0.095), mass=0.06, material="plastic",
             aliases=("cow", "cow figure", "plastic cow", "wooden cow", "cow statue", "bull"),
             themes=("toys",), colors=("white", "white")),
    Category("toy_pig", beast_shape("pig"), size=(0.113, 0.0496, 0.0776), mass=0.05,
             material="plastic", aliases=("pig", "pig figure", "plastic pig", "wooden pig",
             "pig statue", "piglet", "toy piglet"), themes=("toys",), colors=("pink",)),
    Category("toy_sheep", beast_shape("sheep"), size=(0.11, 0.05, 0.07), mass=0.05,
             material="plastic", aliases=("sheep", "sheep figure", "plastic sheep", "wooden sheep",
             "sheep statue", "lamb", "toy lamb"), themes=("toys",), colors=("white", "cream")),
    Category("toy_elephant", beast_shape("elephant"), size=(0.17, 0.085, 0.095), mass=0.09,
             material="plastic", aliases=("elephant", "elephant figure", "plastic elephant",
             "wooden elephant", "elephant statue"), themes=("toys",), colors=("gray", "gray")),
    Category("toy_giraffe", beast_shape("giraffe"), size=(0.125, 0.03, 0.17), mass=0.06,
             material="plastic", assembled=True, aliases=("giraffe", "giraffe figure",
             "plastic giraffe", "wooden giraffe", "giraffe statue"), themes=("toys",),
             colors=("amber", "gold")),
    Category("toy_lion", beast_shape("lion"), size=(0.165, 0.05, 0.085), mass=0.06,
             material="plastic",
             aliases=("lion", "lion figure", "plastic lion", "wooden lion", "lion statue"),
             themes=("toys",), colors=("amber", "tan")),
    Category("toy_tiger", beast_shape("tiger"), size=(0.17, 0.035, 0.085), mass=0.06,
             material="plastic",
             aliases=("tiger", "tiger figure", "plastic tiger", "wooden tiger", "tiger statue"),
             themes=("toys",), colors=("orange",)),
    Category("toy_dog", beast_shape("dog"), size=(0.14, 0.035, 0.09), mass=0.05, material="plastic",
             aliases=("dog", "dog figure", "plastic dog", "wooden dog", "dog statue", "puppy",
             "toy puppy", "pull along dog"), themes=("toys",), colors=("brown", "tan")),
    Category("toy_cat", beast_shape("cat"), size=(0.115, 0.03, 0.09), mass=0.04, material="plastic",
             aliases=("cat", "cat figure", "plastic cat", "wooden cat", "cat statue", "kitten",
             "toy kitten", "ceramic cat"), themes=("toys",), colors=("gray", "orange")),
    Category("toy_rabbit", beast_shape("rabbit"), size=(0.0868, 0.0506, 0.1), mass=0.04,
             material="plastic", aliases=("rabbit", "rabbit figure", "plastic rabbit",
             "wooden rabbit", "rabbit statue", "bunny", "bunny figure", "toy bunny"),
             themes=("toys",), colors=("white", "brown")),
    Category("toy_fox", beast_shape("fox"), size=(0.192, 0.0413, 0.118), mass=0.05,
             material="plastic",
             aliases=("fox", "fox figure", "plastic fox", "wooden fox", "fox statue"),
             themes=("toys",), colors=("orange",)),
    Category("bird", bird, size=(0.12, 0.05, 0.076), mass=0.08, material="ceramic",
             aliases=("bird figure", "toy bird", "wooden bird", "ceramic bird", "bird statue",
             "robin", "songbird", "robin ornament", "bird ornament"), themes=("toys", "living"),
             colors=("blue", "red")),
)  # fmt: skip
"""Objects that share their drawing functions."""
