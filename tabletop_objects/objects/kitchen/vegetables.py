"""Objects of the ``kitchen`` theme: vegetables."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import arc, smooth
from ...kit.parts import above, cylinder_part, flat_foot, hull_of, hull_part, resting_ball
from ...kit.primitives import bent_rod, blade, lay_down, limb, lobe, press_flat
from ...kit.shapes import Category, Shape, category, keep_still, settle, shape
from ...kit.solids import Solid, cylinder, ellipsoid, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, speck, streaks, tint_color
from ...values import ConvexPart
from .nuts import Heap, heap


@category("tomato", size=(0.067, 0.067, 0.062), mass=0.13, material="food", themes=("kitchen",),
          roles=("round", "edible"), colors=("red",), common=True)  # fmt: skip
def tomato(look: Look) -> Shape:
    """A tomato with green leaves around its stem."""
    d, tall = look.between(0.058, 0.076), look.between(0.74, 0.98)
    color = look.color("red", "red", "coral", "crimson")
    body = press_flat(ellipsoid(d, d, tall * d, 24, 14), 0.45 * tall * d)
    top = float(body.vertices[:, 2].max())
    green = surfaces.plain((70, 120, 50))
    leaves = [ellipsoid(0.024, 0.006, 0.002, 8, 4).move(x=0.012).turn(1, 0.25).turn(2, 1.257 * k)
              for k in range(5)]  # fmt: skip
    stem = tube([(0, 0, 0), (0.001, 0, 0.006), (0.003, 0, 0.011)], 0.0016, 6)
    star = join([*leaves, stem]).move(z=top + 0.0005)
    return shape([(body, skin(look, color, tint_color(color, 1.12), 0.5)), (star, green)],
                 [resting_ball(d, d, top)])  # fmt: skip


def root(look: Look, length: float, radii: list[float]) -> Solid:
    """Return a slightly bent, round root along x, with ``radii`` at evenly spaced points."""
    bend = look.between(-0.008, 0.008)
    t = np.linspace(-1, 1, len(radii))
    radius = max(radii)
    return tube(
        np.column_stack([t * length / 2, bend * (1 - t**2), np.full(len(t), 0.92 * radius)]),
        radii, 12, squash=0.92,
    )  # fmt: skip


def halves(body: Solid, pieces: int) -> list[ConvexPart]:
    """Return hulls of ``pieces`` equal sections of a body along x, with flat bases at z = 0."""
    p = body.vertices
    cuts = np.linspace(p[:, 0].min(), p[:, 0].max(), pieces + 1)
    width = (cuts[1] - cuts[0]) * 0.55
    middles = (cuts[1:] + cuts[:-1]) / 2
    return [flat_foot(p[np.abs(p[:, 0] - m) <= width + 0.004]) for m in middles]


@category("cucumber", size=(0.19, 0.04, 0.038), mass=0.16, material="food", themes=("kitchen",),
          roles=("edible",), colors=("green",), state="lying flat", common=True)  # fmt: skip
def cucumber(look: Look) -> Shape:
    """A cucumber, lying flat."""
    length, r = look.between(0.17, 0.21), look.between(0.018, 0.021)
    color = look.color("green", "green", "olive")
    dark = tint_color(color, 0.72)
    rind = surfaces.stripes([dark, dark, tint_color(color, 0.95)], 7, upright=True)
    body = root(look, length, [0.4 * r, 0.8 * r, r, r, r, r, r, 0.85 * r, 0.45 * r])
    return shape([(body, rind)], halves(body, 3))


@category("eggplant", size=(0.237, 0.0665, 0.065), mass=0.3, material="food",
          aliases=("aubergine", "brinjal"), themes=("kitchen", "food"), roles=("edible",),
          colors=("purple",), state="lying flat")  # fmt: skip
def eggplant(look: Look) -> Shape:
    """An aubergine lying flat: a dark, glossy club shape with a green cap."""
    k = look.between(0.88, 1.12)
    color = look.color("purple", "indigo", "indigo", "maroon", "violet")
    skin = surfaces.gradient(tint_color(color, 0.5), tint_color(color, 0.7), look.rng, 4)
    t = np.linspace(0, 1, 16)
    wide = 0.037 * k * np.sqrt(np.clip(1 - (2 * t - 1) ** 4, 0.002, 1)) * (1 - 0.42 * t)
    path = np.column_stack([0.2 * k * (t - 0.5), 0.012 * k * np.sin(np.pi * t),
                            0.036 * k - 0.013 * k * t])  # fmt: skip
    body = tube(path, wide, 20).bend(above)
    leaf = surfaces.speckles(look.rng, (96, 136, 62), 10)
    end = np.array([0.1 * k, 0, 0.023 * k])
    cap = lobe(lathe([(0, 0), (0.021 * k, 0), (0.019 * k, 0.012 * k), (0.006 * k, 0.022 * k),
                       (0, 0.022 * k)], 40), 5, 0.6)  # fmt: skip
    cap = cap.turn(1, np.pi / 2).move(*(end - [0.018 * k, 0, 0]))
    bend, tip = np.array([0.02 * k, 0.002, 0.004]), np.array([0.034 * k, 0.006, 0.012])
    stalk = tube(smooth([end, end + bend, end + tip], 3), 0.005 * k, 8)
    x = body.vertices[:, 0]
    return shape([(body, skin), (join([cap, stalk]), leaf)],
                 [flat_foot(body.vertices[x < 0.02 * k], 0.1),
                  hull_part(body.vertices[x > -0.02 * k]),
                  hull_of(stalk)])  # fmt: skip


LEAF: RGB = (78, 130, 58)


@category("onion", size=(0.074, 0.074, 0.085), mass=0.16, material="food",
          aliases=("red onion", "white onion", "shallot"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("amber", "maroon"), common=True)  # fmt: skip
def onion(look: Look) -> Shape:
    """An onion with papery skin and a dry neck."""
    r = look.between(0.032, 0.042)
    h = look.between(1.5, 1.85) * r
    color = look.color("amber", "maroon", "cream", "tan", "amber")
    body = lathe(
        [(0, 0), (0.35 * r, 0), (0.8 * r, 0.16 * h), (r, 0.42 * h), (0.9 * r, 0.66 * h),
         (0.5 * r, 0.88 * h), (0.16 * r, h), (0.07 * r, 1.16 * h), (0.1 * r, 1.28 * h),
         (0, 1.26 * h)],
        24,
    )  # fmt: skip
    paper = streaks(look.rng, color, tint_color(color, look.pick([0.66, 1.4])), 24)
    return shape([(body, paper)], [hull_of(body)])


@category("garlic", size=(0.058, 0.058, 0.064), mass=0.05, material="food",
          aliases=("garlic bulb", "bulb of garlic"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("white",), common=True)  # fmt: skip
def garlic(look: Look) -> Shape:
    """A bulb of garlic."""
    r = look.between(0.026, 0.032)
    h = 1.25 * r
    color = look.color("white", "cream", "ivory", "lavender")
    bulb = lathe(
        [(0, 0), (0.45 * r, 0), (0.9 * r, 0.2 * h), (r, 0.45 * h), (0.8 * r, 0.75 * h),
         (0.35 * r, 1.02 * h), (0.17 * r, 1.3 * h), (0.14 * r, 1.75 * h), (0, 1.77 * h)],
        40,
    )  # fmt: skip
    bulb = lobe(bulb, int(look.rng.integers(7, 10)), 0.2)
    paper = streaks(
        look.rng, color, tint_color(look.own_color("lavender", "beige", "pink"), 1.2), 12
    )
    return shape([(bulb, paper)], [hull_of(bulb)])


@category("corn", size=(0.19, 0.08, 0.046), mass=0.25, material="food", aliases=("corn cob",
          "ear of corn", "corn on the cob", "maize", "sweetcorn", "sweetcorn cob", "cob of corn"),
          themes=("kitchen", "food"), roles=("edible",), colors=("yellow",), state="lying flat",
          common=True)  # fmt: skip
def corn(look: Look) -> Shape:
    """An ear of corn in its open husk, lying flat."""
    length, r = look.between(0.15, 0.19), look.between(0.02, 0.025)
    color = look.color("yellow", "golden", "yellow", "cream")
    y, x = np.mgrid[0:128, 0:128] / 128
    grain = np.abs(np.sin(14 * np.pi * x)) ** 0.5 * np.abs(np.sin(26 * np.pi * y)) ** 0.5
    shade = 0.62 + 0.45 * grain + 0.06 * surfaces.noise(look.rng, 128, 128, (16, 16), 1)
    kernels = np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)
    cob = lay_down(
        lathe([(0, 0), (0.8 * r, 0), (r, 0.15 * length), (0.97 * r, 0.6 * length),
               (0.7 * r, 0.88 * length), (0.2 * r, length), (0, length)], 22),
        -0.4 * length, r,
    )  # fmt: skip
    green = surfaces.leaf(look.rng, look.own_color("lime", "green", "sage"))
    start = -0.42 * length
    husk = [
        blade([(start, 0.3 * s * r, 0.9 * r), (start + 0.28 * length, 1.35 * s * r, 0.8 * r),
               (start + 0.7 * length, 1.9 * s * r, 0.35 * r)], 1.9 * r, thick=0.22)
        for s in (-1, 1)
    ]  # fmt: skip
    stalk = lay_down(cylinder(0.5 * r, 0.03, 12, top=0.6 * r), start - 0.024, 0.95 * r)
    keel = ellipsoid(0.55 * length, 1.9 * r, 0.7 * r, 16, 8).move(-0.18 * length, 0, 0.35 * r)
    return shape(
        [(cob, kernels), (join([*husk, keel]), green), (stalk, surfaces.plain((176, 190, 110)))],
        [flat_foot(cob.vertices), hull_part(husk[0].vertices.clip(min=(-1, -1, 0))),
         hull_part(husk[1].vertices.clip(min=(-1, -1, 0)))],
    )  # fmt: skip


@category("bell_pepper", size=(0.08, 0.08, 0.105), mass=0.16, material="food",
          aliases=("sweet pepper", "capsicum", "red pepper", "green pepper"),
          themes=("kitchen", "food"), roles=("round", "edible"), colors=("red", "yellow", "green"),
          common=True)  # fmt: skip
def bell_pepper(look: Look) -> Shape:
    """A bell pepper standing upright with its stalk on top."""
    r, h = look.between(0.035, 0.043), look.between(0.075, 0.1)
    color = look.color("red", "yellow", "green", "orange")
    body = lathe(
        [(0, 0.003), (0.35 * r, 0), (0.66 * r, 0.05 * h), (0.82 * r, 0.25 * h), (0.95 * r, 0.6 * h),
         (r, 0.82 * h), (0.86 * r, 0.96 * h), (0.5 * r, h), (0.2 * r, 0.93 * h), (0, 0.92 * h)],
        36,
    )  # fmt: skip
    body = lobe(body, int(look.rng.integers(3, 5)), 0.22)
    cap = lobe(cylinder(0.3 * r, 0.006, 20, bevel=0.001), 5, 0.4).move(z=0.925 * h)
    stalk = tube(smooth([(0, 0, 0.92 * h), (0.002, 0, 1.06 * h), (0.009, 0, 1.2 * h)], 3),
                 np.linspace(0.0055, 0.0042, 7), 8)  # fmt: skip
    shine = skin(look, color, tint_color(color, look.pick([0.8, 1.25])), 0.6)
    green = surfaces.plain(LEAF)
    return shape([(body, shine), (cap, green), (stalk, green)], [hull_of(body), hull_of(stalk)])


@category("broccoli", size=(0.11, 0.11, 0.105), mass=0.25, material="food",
          aliases=("broccoli head",), themes=("kitchen", "food"), roles=("round", "edible"),
          colors=("green",), common=True)  # fmt: skip
def broccoli(look: Look) -> Shape:
    """A head of broccoli, standing on its cut stalk."""
    r, h = look.between(0.045, 0.058), look.between(0.075, 0.09)
    color = look.color("green", "green", "olive", "sage", "cream")
    pale = surfaces.speckles(look.rng, (168, 190, 110), 6)
    trunk = lathe([(0, 0), (0.36 * r, 0), (0.34 * r, 0.35 * h), (0.66 * r, 0.62 * h),
                   (0, 0.7 * h)], 16)  # fmt: skip
    tops = [ellipsoid(1.1 * r, 1.1 * r, 0.95 * r, 14, 8).move(z=h)]
    for ring, (count, away, z, d) in enumerate([(8, 0.72, 0.72, 0.66), (6, 0.46, 1.0, 0.66)]):
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5 * ring) / count
            size = d * r * look.between(0.88, 1.1)
            at = away * r * np.array([np.cos(angle), np.sin(angle)])
            tops.append(ellipsoid(size, size, 0.88 * size, 12, 8).move(at[0], at[1], z * h))
    bud = surfaces.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.62), 0.3)
    return shape([(trunk, pale), (join(tops), bud)], [cylinder_part(0.35 * r, 0.6 * h),
                                                      hull_of(*tops)])  # fmt: skip


@category("mushroom", size=(0.056, 0.056, 0.052), mass=0.021, material="food",
          aliases=("champignon", "toadstool"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("cream",), common=True)  # fmt: skip
def mushroom(look: Look) -> Shape:
    """A mushroom, standing on its stalk."""
    r, h = look.between(0.022, 0.034), look.between(0.045, 0.06)
    color = look.color("cream", "white", "brown", "tan", "beige")
    s = 0.42 * r
    stalk = lathe([(0, 0), (s, 0), (0.9 * s, 0.3 * h), (s, 0.66 * h), (0, 0.66 * h)], 18)
    cap = lathe([(0, 0.52 * h), (0.6 * r, 0.5 * h), (0.93 * r, 0.47 * h), (r, 0.55 * h),
                 (0.9 * r, 0.76 * h), (0.55 * r, 0.95 * h), (0, h)], 26)  # fmt: skip
    top = skin(look, color, tint_color(color, 0.75), 0.7)
    return shape([(stalk, surfaces.speckles(look.rng, (238, 230, 212), 6)), (cap, top)],
                 [cylinder_part(s, 0.55 * h), hull_of(cap)])  # fmt: skip


@category("pickle_spear", size=(0.101, 0.0242, 0.015), mass=0.025, material="food",
          aliases=("dill pickle spear", "pickle wedge", "cucumber stick", "cucumber spear"),
          themes=("kitchen", "food"), roles=("edible",), colors=("olive",),
          state="lying")  # fmt: skip
@keep_still
def pickle_spear(look: Look) -> Shape:
    """A quarter of a pickled cucumber, cut lengthwise."""
    long, r = look.between(0.085, 0.11), look.between(0.015, 0.019)
    color = look.color("olive", "green", "sage")
    outline = np.array([(0.0, 0.0), *arc((0, 0), r, 0.0, np.pi / 2, 6)])
    body = prism(outline, 0, long).turn(1, np.pi / 2)
    body = body.turn(0, -np.pi / 4).move(-0.5 * long)
    low = float(body.bounds[0, 2])
    inner = surfaces.spots(look.rng, color, (206, 208, 130), 0.14)
    return settle([(body.move(z=-low), inner)], 0.12)


GREEN: RGB = (70, 132, 62)


@category("romanesco", size=(0.155, 0.136, 0.114), mass=0.5, material="food",
          aliases=("romanesco broccoli", "romanesco cauliflower"), themes=("kitchen", "food"),
          roles=("edible", "round"), colors=("lime",))  # fmt: skip
def romanesco(look: Look) -> Shape:
    """A romanesco: spirals of small cones on a leafy base."""
    r = look.between(0.055, 0.068)
    color = look.color("lime", "green", "lime")
    core = lathe(
        [(0, 0), (0.8 * r, 0.02), (0.86 * r, 0.5 * r), (0.4 * r, 1.2 * r), (0, 1.55 * r)], 20
    )
    buds = []
    for k in range(46):
        t = (k + 0.5) / 46
        out, z = r * (0.08 + 0.86 * t**0.8), 1.5 * r * (1 - t) + 0.28 * r
        a = 2.4 * k
        s = r * (0.12 + 0.18 * t)
        bud = cylinder(s, 1.7 * s, 7, top=0.05 * s).turn(1, 0.25 + 0.8 * t).turn(2, a)
        buds.append(bud.move(out * np.cos(a) * 0.82, out * np.sin(a) * 0.82, z - 0.3 * s))
    leaves = [blade([(0.5 * r, 0, 0.006), (1.05 * r, 0, 0.2 * r), (1.3 * r, 0, 0.75 * r)], 0.7 * r,
                    thick=0.15).turn(2, 2 * np.pi * k / 6) for k in range(6)]  # fmt: skip
    tile = surfaces.spots(look.rng, color, tint_color(color, 1.3), 0.2)
    return settle([(join([core, *buds]), tile), (join(leaves), leafy(look, GREEN))], 0.03)


OKRA_GREEN: RGB = (92, 140, 62)


@dataclass(frozen=True)
class Pod:
    """A long fruit, vegetable or pod; ``long`` is the range of its length in metres.

    ``r`` gives its radii from left to right and ``bend`` how far it curves, both relative to its
    length; ``skin`` names its surface and ``end`` the shape of its right end.
    """

    long: tuple[float, float]
    r: tuple[float, ...]
    colors: tuple[str, ...]
    bend: float = 0.05
    skin: str = "speckles"
    end: str = ""


def _skin(look: Look, pod: Pod, color: RGB) -> surfaces.Tile:
    if pod.skin == "rings":
        return surfaces.stripes([color, color, color, tint_color(color, 0.8)], 9)
    if pod.skin == "ribs":
        return surfaces.stripes([color, tint_color(color, 0.78)], 7, upright=True)
    if pod.skin == "streaks":
        return streaks(look.rng, tint_color(color, 0.8), tint_color(color, 1.3), 12)
    if pod.skin == "white foot":
        return surfaces.gradient((246, 244, 226), color, look.rng)
    return surfaces.speckles(look.rng, color, 10)


def pod_of(pod: Pod) -> Callable[[Look], Shape]:
    """Return the shape function of the fruit, vegetable or pod that ``pod`` describes."""

    def make(look: Look) -> Shape:
        long, color = look.between(*pod.long), look.color(*pod.colors)
        bend = long * pod.bend * look.between(0.6, 1.4)
        x = np.linspace(-0.5, 0.5, len(pod.r))
        path = np.column_stack([x * long, bend * 4 * x * x, 0 * x])
        body = limb(path, [long * r for r in pod.r], 14)
        pieces = [(body, _skin(look, pod, color))]
        r, tip = long * max(pod.r), (0.5 * long, bend, 0.0)
        if pod.end == "stub":
            stub = limb([(tip[0] - 0.3 * r, bend, 0), (tip[0] + 0.5 * r, bend, 0),
                         (tip[0] + 1.1 * r, 1.1 * bend, 0.1 * r)], [0.6 * r, 0.4 * r, 0.34 * r],
                         8)  # fmt: skip
            pieces.append((stub, surfaces.plain((140, 158, 88))))
        elif pod.end == "stem":
            stem = limb([tip, (tip[0] + 0.12 * long, 1.5 * bend, 0)], [0.16 * r, 0.12 * r], 6)
            pieces.append((stem, surfaces.plain(tint_color(color, 0.6))))
        elif pod.end == "leaves":
            tuft = [blade([(tip[0] - 0.4 * r, bend, 0), (tip[0] + 1.5 * r, bend + 1.2 * r * s, 0),
                           (tip[0] + 4 * r, bend + 2 * r * s, -0.6 * r)], 0.9 * r, thick=0.25)
                    for s in (-1, -0.4, 0.3, 1)]  # fmt: skip
            pieces.append((join(tuft), surfaces.leaf(look.rng, OKRA_GREEN)))
        elif pod.end == "head":
            head = ellipsoid(3.2 * r, 3 * r, 3 * r, 14, 8).move(tip[0] + 0.8 * r, bend, 0)
            pieces.append((head, surfaces.plain((236, 206, 104))))
        return settle(pieces, 0.14, hulls=[[0]])

    return make


@category("pumpkin", size=(0.219, 0.209, 0.151), mass=1.2, material="food",
          aliases=("halloween pumpkin",), themes=("kitchen", "food"),
          roles=("round", "edible", "big"), colors=("orange",))  # fmt: skip
def pumpkin(look: Look) -> Shape:
    """A ribbed pumpkin with a stalk."""
    r, h = look.between(0.085, 0.11), look.between(0.12, 0.15)
    color = look.color("orange", "orange", "terracotta", "ivory", "amber")
    t = np.linspace(-np.pi / 2, np.pi / 2, 15)
    radius = np.maximum(r * np.cos(t) ** 0.6, 0)
    z = 0.5 * h * (1 + np.sin(t)) - 0.14 * h * np.exp(-((radius / (0.35 * r)) ** 2)) * np.sign(
        np.sin(t)) * (np.abs(np.sin(t)) > 0.5)  # fmt: skip
    radius[[0, -1]] = 0
    body = lobe(lathe(np.column_stack([radius, z]), 60), 10, 0.2)
    rind = surfaces.stripes([tint_color(color, 0.85), color, tint_color(color, 1.08), color], 10,
                            upright=True, side=80)  # fmt: skip
    stalk = limb([(0, 0, 0.82 * h), (0.004, 0, 1.0 * h), (0.022, 0.004, 1.14 * h)],
                 [0.018, 0.011, 0.009], 8)  # fmt: skip
    return settle([(body, rind), (stalk, surfaces.speckles(look.rng, (116, 122, 66), 12))], 0.04)


WHITE: RGB = (240, 238, 222)


def leafy(look: Look, color: RGB) -> surfaces.Tile:
    """Return a texture of a leaf of the given colour, with paler veins."""
    tile = surfaces.noise(look.rng, 96, 96, (5, 5), 3)[..., None] * 22
    veins = np.abs(np.sin(np.linspace(0, 22, 96)))[None, :, None] < 0.16
    image = np.where(veins, np.array(tint_color(color, 1.45)), np.array(color) + tile)
    return np.clip(image, 0, 255).astype(np.uint8)


@category("celery", size=(0.239, 0.145, 0.046), mass=0.35, material="food", aliases=("celery stalk",
          "bunch of celery", "celery stick", "stick of celery", "rhubarb", "fennel"),
          themes=("kitchen", "food"), roles=("edible",), colors=("lime",),
          state="lying flat")  # fmt: skip
def celery(look: Look) -> Shape:
    """A bunch of celery lying flat with its leaves on the right."""
    long = look.between(0.24, 0.3)
    color = look.color("lime", "green", "sage")
    stalks, tops = [], []
    for k in range(7):
        a = 2 * np.pi * k / 6
        y, z = (0.017 * np.cos(a), 0.015 * np.sin(a)) if k < 6 else (0.0, 0.0)
        stalks.append(limb([(-0.5 * long, 0.7 * y, 0.7 * z), (-0.2 * long, y, z),
                            (0.25 * long, 1.5 * y, 1.4 * z)], [0.011, 0.0105, 0.006],
                           9))  # fmt: skip
        for s in (-1, 0, 1):
            tip = (0.25 * long, 1.5 * y, 1.4 * z)
            tops.append(blade([tip, (0.34 * long, 2.2 * y + 0.012 * s, 1.6 * z + 0.004),
                               (0.46 * long, 2.6 * y + 0.028 * s, 1.4 * z)], 0.03, thick=0.3,
                              sides=5))  # fmt: skip
    ribs = surfaces.stripes([tint_color(color, 1.35), tint_color(color, 1.15)], 7, upright=True)
    return settle([(join(stalks), ribs), (join(tops), surfaces.speckles(look.rng,
                  tint_color(color, 0.72), 14))], 0.12, hulls=[[0], [1]])  # fmt: skip


def _stalk(look: Look, long: float, r: float, count: int, fan: float) -> Shape:
    """Return leeks or spring onions with white shafts on the left and green leaves on the right."""
    color = look.color("green", "green", "sage")
    whites, leaves, roots = [], [], []
    for k in range(count):
        y, z = (k - (count - 1) / 2) * 2.05 * r, 0.0
        if count > 3 and k % 2:
            z = 1.2 * r
        whites.append(limb([(-0.5 * long, y, z), (-0.4 * long, y, z), (-0.2 * long, y, z),
                            (0.02 * long, y, z)], [0.8 * r, 1.15 * r, r, r], 12))  # fmt: skip
        for s in (-1, 0, 1):
            leaf = [(-0.02 * long, y, z), (0.2 * long, y + 0.4 * s * fan, z + 0.2 * r),
                    (0.5 * long, y + s * fan, z - 0.1 * r)]  # fmt: skip
            root = [(-0.5 * long, y, z), (-0.5 * long - 0.012, y + 0.4 * s * r, z),
                    (-0.5 * long - 0.02, y + s * r, z - 0.3 * r)]  # fmt: skip
            leaves.append(limb(leaf, [0.9 * r, 0.85 * r, 0.1 * r], 6, 0.35))
            roots.append(limb(root, [0.0012, 0.0008, 0.0005], 4))
    pale = surfaces.gradient(WHITE, tint_color(color, 1.4), look.rng)
    return settle([(join(whites), pale), (join(leaves), surfaces.stripes(
        [tint_color(color, 0.85), tint_color(color, 1.1)], 5, upright=True)),
        (join(roots), surfaces.plain((226, 216, 190)))], 0.12, hulls=[[0], [1]])  # fmt: skip


@category("leek", size=(0.326, 0.0632, 0.0331), mass=0.2, material="food",
          themes=("kitchen", "food"), roles=("edible",), colors=("green",),
          state="lying flat")  # fmt: skip
def leek(look: Look) -> Shape:
    """A leek lying flat with its leaves fanned out on the right."""
    return _stalk(look, look.between(0.27, 0.33), look.between(0.0145, 0.018), 1, 0.03)


@category("spring_onion", size=(0.269, 0.058, 0.0165), mass=0.06, material="food",
          aliases=("scallion", "green onion", "chive", "bunch of spring onions", "bunch of chives",
          "chive bunch"), themes=("kitchen", "food"), roles=("edible",), colors=("green",),
          state="lying flat")  # fmt: skip
def spring_onion(look: Look) -> Shape:
    """A few spring onions lying side by side."""
    return _stalk(look, look.between(0.22, 0.28), look.between(0.0048, 0.006), 4, 0.012)


@category("asparagus", size=(0.2, 0.035, 0.0299), mass=0.2, material="food",
          aliases=("bunch of asparagus", "bundle of asparagus", "asparagus spear",
          "asparagus bundle"), themes=("kitchen", "food"), roles=("edible",), colors=("green",),
          state="lying flat")  # fmt: skip
def asparagus(look: Look) -> Shape:
    """A bundle of asparagus tied with a band, with its tips on the right."""
    long, r = look.between(0.18, 0.22), look.between(0.0048, 0.006)
    color = look.color("green", "green", "sage", "white")
    at = [(0, 0), *((2.05 * r * np.cos(a), 2.05 * r * np.sin(a))
                    for a in np.arange(6) * np.pi / 3)]  # fmt: skip
    spears, tips, scales = [], [], []
    for y, z in at:
        end = look.between(0.44, 0.5) * long
        spears.append(limb([(-0.5 * long, y, z), (0.1 * long, y, z), (end - 0.03, y, z)],
                           [r, r, 0.95 * r], 10))  # fmt: skip
        tips.append(limb([(end - 0.032, y, z), (end - 0.015, y, z), (end, y, z)],
                         [0.95 * r, 1.2 * r, 0.15 * r], 8))  # fmt: skip
        scales += [ellipsoid(0.01, 0.004, 0.003, 6, 4).move(u * long, y, z + 0.95 * r)
                   for u in (-0.2, 0.05, 0.2)]  # fmt: skip
    band = cylinder(3.12 * r, 0.016, 24).turn(1, np.pi / 2).move(-0.16 * long)
    tone = surfaces.plain(look.own_color("purple", "blue", "red", "tan"))
    return settle([(join(spears), surfaces.speckles(look.rng, color, 8)),
                   (join([*tips, *scales]), surfaces.speckles(look.rng, tint_color(
                       color, 0.68), 14)), (band, tone)], 0.1)  # fmt: skip


@category("cauliflower", size=(0.139, 0.14, 0.104), mass=0.6, material="food",
          aliases=("head of cauliflower", "cauliflower head"), themes=("kitchen", "food"),
          roles=("edible", "round"), colors=("ivory",))  # fmt: skip
def cauliflower(look: Look) -> Shape:
    """A white head of cauliflower in green leaves."""
    r = look.between(0.06, 0.072)
    color = look.color("ivory", "cream", "white", "purple")
    curds = [ellipsoid(1.5 * r, 1.5 * r, 1.1 * r, 16, 10).move(z=0.9 * r)]
    for ring, (count, away, z) in enumerate([(1, 0, 1.42), (6, 0.42, 1.28), (11, 0.72, 0.98)]):
        for k in range(count):
            a = 2 * np.pi * (k + 0.5 * ring) / count
            d = 0.5 * r * look.between(0.9, 1.1)
            curds.append(ellipsoid(d, d, 0.8 * d, 10, 6).move(
                away * r * np.cos(a), away * r * np.sin(a), z * r))  # fmt: skip
    leaves = [blade([(0.3 * r * np.cos(a), 0.3 * r * np.sin(a), 0.12 * r),
                     (0.95 * r * np.cos(a), 0.95 * r * np.sin(a), 0.5 * r),
                     (1.08 * r * np.cos(a), 1.08 * r * np.sin(a), 1.25 * r)], 0.8 * r, thick=0.14)
              for a in np.arange(7) * 0.9]  # fmt: skip
    stub = cylinder(0.35 * r, 0.5 * r, 16)
    bud = surfaces.spots(look.rng, color, tint_color(color, 0.86), 0.25)
    green = surfaces.leaf(look.rng, (116, 164, 84))
    return settle([(join(curds), bud), (join(leaves), green), (stub, surfaces.plain(WHITE))],
                  0.02, hulls=[[0, 2], [1, 2]])  # fmt: skip


@category("artichoke", size=(0.0805, 0.0805, 0.091), mass=0.25, material="food",
          aliases=("globe artichoke",), themes=("kitchen", "food"), roles=("edible", "round"),
          colors=("sage",))  # fmt: skip
def artichoke(look: Look) -> Shape:
    """An artichoke with overlapping scales, standing upright."""
    r = look.between(0.042, 0.052)
    color = look.color("sage", "green", "olive")
    scales = []
    for ring, (count, z, away, size, lean) in enumerate(
        [(8, 0.15, 0.72, 0.9, 0.25), (8, 0.55, 0.74, 0.9, 0.0), (7, 0.95, 0.6, 0.85, -0.25),
         (5, 1.3, 0.36, 0.7, -0.5)]
    ):  # fmt: skip
        for k in range(count):
            a = 2 * np.pi * (k + 0.5 * (ring % 2)) / count
            leaf = ellipsoid(0.75 * size * r, 0.16 * r, size * r, 10, 6).turn(0, lean)
            leaf = leaf.move(y=-away * r, z=z * r + 0.45 * r)
            scales.append(leaf.turn(2, a))
    core = ellipsoid(1.5 * r, 1.5 * r, 1.9 * r, 18, 10).move(z=0.95 * r)
    stub = cylinder(0.26 * r, 0.4 * r, 12)
    skin_ = surfaces.gradient(tint_color(color, 1.1), tint_color(color, 0.82), look.rng, 8)
    return settle([(join([core, *scales]), skin_), (stub, surfaces.plain((150, 164, 110)))],
                  0.06)  # fmt: skip


@category("olive", size=(0.0257, 0.0169, 0.0142), mass=0.004, material="food",
          themes=("kitchen", "food"), roles=("edible",), colors=("olive",),
          state="lying flat")  # fmt: skip
def olive(look: Look) -> Shape:
    """An olive lying flat, plain or stuffed with red pepper."""
    long, r = look.between(0.021, 0.026), look.between(0.0078, 0.0095)
    color = look.color("olive", "olive", "black", "purple", "green")
    body = bent_rod(long, r, blunt=2.4)
    red = ellipsoid(0.006, 0.007, 0.007, 10, 6).move(x=0.47 * long)
    tone = surfaces.plain((206, 56, 40) if look.chance(0.6) else (60, 50, 40))
    return settle([(body, skin(look, color, tint_color(color, 0.85), 0.6)), (red, tone)], 0.14)


@category("pickle", size=(0.0776, 0.0267, 0.0226), mass=0.03, material="food",
          aliases=("gherkin", "pickled cucumber", "dill pickle", "cornichon"),
          themes=("kitchen", "food"), roles=("edible",), colors=("olive",),
          state="lying flat")  # fmt: skip
def pickle(look: Look) -> Shape:
    """A warty pickled gherkin, lying flat."""
    long, r = look.between(0.07, 0.09), look.between(0.011, 0.014)
    color = look.color("olive", "green", "olive")
    body = bent_rod(long, r, blunt=4, bend=look.between(0.004, 0.01))
    warts = [ellipsoid(0.003, 0.003, 0.002, 6, 4).move(u * long, 0.004 * (4 * u * u - 0.5) + v * r,
             0.98 * r * np.sqrt(1 - v * v)) for u in np.linspace(-0.36, 0.36, 9)
             for v in (-0.6, 0.0, 0.6)]  # fmt: skip
    tile = streaks(look.rng, tint_color(color, 0.85), tint_color(color, 1.3), 14)
    return settle([(body, tile), (join(warts), surfaces.plain(tint_color(color, 0.75)))], 0.12)


CHILI_GREEN: RGB = (92, 150, 62)


@category("zucchini", size=(0.208, 0.0446, 0.0376), mass=0.2, material="food",
          aliases=("courgette",), themes=("kitchen", "food"), roles=("edible",), colors=("green",),
          state="lying flat")  # fmt: skip
def zucchini(look: Look) -> Shape:
    """A courgette lying flat with its stem on the right."""
    long, r = look.between(0.17, 0.21), look.between(0.019, 0.023)
    color = look.color("green", "green", "olive", "yellow")
    body = bent_rod(long, r, blunt=9, taper=-0.12, bend=0.006)
    stub = lathe([(0, 0), (0.62 * r, 0), (0.42 * r, 0.012), (0.5 * r, 0.026), (0, 0.026)], 8)
    stub = stub.turn(1, np.pi / 2).move(x=0.475 * long, y=0.003)
    dark = streaks(look.rng, tint_color(color, 0.62), tint_color(color, 0.95), 12)
    return settle([(body, dark), (stub, surfaces.plain((150, 164, 100)))], 0.1)


@category("chili", size=(0.127, 0.028, 0.0168), mass=0.015, material="food", aliases=("chilli",
          "chili pepper", "chilli pepper", "jalapeno", "hot pepper", "chile", "chile pepper",
          "cayenne pepper", "jalapeno pepper", "habanero", "scotch bonnet", "birds eye chilli"),
          themes=("kitchen", "food"), roles=("edible",), colors=("red", "green"),
          state="lying flat")  # fmt: skip
def chili(look: Look) -> Shape:
    """A chilli pepper lying flat with its green stalk on the right."""
    long, r = look.between(0.085, 0.125), look.between(0.0075, 0.011)
    bend = look.between(0.008, 0.02)
    color = look.color("red", "red", "green", "crimson", "yellow", "orange")
    body = limb([(-0.5 * long, bend, 0), (-0.2 * long, -0.2 * bend, 0),
                 (0.2 * long, -0.4 * bend, 0),
                 (0.44 * long, 0, 0), (0.48 * long, 0, 0)],
                [0.0008, 0.66 * r, 0.95 * r, r, 0.4 * r], 16)  # fmt: skip
    cap = limb([(0.44 * long, 0, 0), (0.49 * long, 0, 0), (0.56 * long, 0.002, 0.002),
                (0.7 * long, 0.004, 0.006)], [0.95 * r, 0.72 * r, 0.24 * r, 0.22 * r],
               10)  # fmt: skip
    return settle([(body, skin(look, color, tint_color(color, 0.8), 0.5)),
                   (cap, surfaces.plain(CHILI_GREEN))], 0.12)  # fmt: skip


@category("gourd", size=(0.12, 0.12, 0.12), mass=0.4, material="food",
          aliases=("gourd ornament", "squash", "calabash", "ornamental gourd", "butternut squash"),
          themes=("kitchen", "living"), roles=("round",), colors=("orange", "amber"),
          common=True)  # fmt: skip
def gourd(look: Look) -> Shape:
    """An ornamental gourd: a ribbed pumpkin, or a bottle gourd with two bulbs."""
    color = look.color("orange", "amber", "white", "green", "teal", "tan", "terracotta")
    other = tint_color(color, look.pick([0.72, 1.3]))
    stem_tile = surfaces.speckles(look.rng, (118, 112, 66), 10)
    if look.chance(0.6):
        r, h = look.between(0.045, 0.085), look.between(0.068, 0.1)
        body = lathe([(0, 0.08 * h), (0.3 * r, 0), (0.55 * r, 0), (0.9 * r, 0.22 * h), (r, 0.5 * h),
                      (0.88 * r, 0.8 * h), (0.5 * r, h), (0.16 * r, 0.93 * h), (0, 0.92 * h)],
                     48)  # fmt: skip
        body = lobe(body, int(look.rng.integers(8, 12)), 0.22)
        path = smooth([(0, 0, 0.9 * h), (0.004, 0, 1.08 * h), (0.02, 0, 1.24 * h)], 3)
        stem = tube(path, np.linspace(0.16, 0.1, 7) * r, 8)
    else:
        r, h = look.between(0.035, 0.05), look.between(0.11, 0.16)
        body = lathe([(0, 0.004), (0.4 * r, 0), (0.85 * r, 0.1 * h), (r, 0.27 * h),
                      (0.8 * r, 0.45 * h), (0.42 * r, 0.58 * h), (0.45 * r, 0.66 * h),
                      (0.6 * r, 0.78 * h),
                      (0.5 * r, 0.9 * h), (0.2 * r, 0.98 * h), (0, h)], 28)  # fmt: skip
        path = smooth([(0, 0, 0.97 * h), (0.002, 0, 1.06 * h), (0.012, 0, 1.14 * h)], 3)
        stem = tube(path, 0.004, 7)
    rind = streaks(look.rng, color, other, 20)
    if look.chance(0.3):
        rind = speck(rind, look.rng, tint_color(color, 1.6), 40, 4)
    return shape([(body, rind), (stem, stem_tile)], [hull_of(body), hull_of(stem)])


CATEGORIES = (
    Category("chopped_onion",
             heap(Heap((0.03, 0.042), 0.007, "cube", ("white", "ivory", "lavender"))),
             size=(0.0859, 0.0862, 0.0251), mass=0.06, material="food", aliases=("diced onion",
             "chopped shallot", "chopped garlic", "minced garlic", "heap of chopped onion",
             "pile of chopped onion", "mound of chopped onion", "chopped onion heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("white",), state="heaped"),
    Category("chopped_pepper", heap(Heap((0.03, 0.042), 0.009, "chip", ("red", "green", "yellow"))),
             size=(0.0877, 0.0879, 0.0248), mass=0.06, material="food", aliases=("diced pepper",
             "chopped chilli", "chopped tomato", "diced tomato", "chopped bell pepper",
             "chopped vegetable", "heap of chopped pepper", "pile of chopped pepper",
             "mound of chopped pepper", "chopped pepper heap"), themes=("kitchen", "food"),
             roles=("edible",), colors=("red",), state="heaped"),
    Category("sliced_spring_onion",
             heap(Heap((0.024, 0.034), 0.007, "ring", ("lime", "green", "sage"))),
             size=(0.0668, 0.0666, 0.0182), mass=0.01, material="food",
             aliases=("chopped spring onion", "sliced leek", "sliced scallion",
             "heap of sliced spring onion", "pile of sliced spring onion",
             "mound of sliced spring onion", "sliced spring onion heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("lime",), state="heaped"),
    Category("okra", keep_still(pod_of(Pod((0.08, 0.11), (0.004, 0.05, 0.075, 0.085, 0.08),
             ("green", "lime", "green", "maroon"), 0.05, "ribs", "stub"))),
             size=(0.105, 0.0203, 0.0136), mass=0.012, material="food",
             aliases=("lady finger", "okra pod"), themes=("kitchen", "food"), roles=("edible",),
             colors=("green",), state="lying flat"),
    Category("marrow", keep_still(pod_of(Pod((0.25, 0.32), (0.06, 0.14, 0.16, 0.165, 0.15, 0.07),
             ("green", "lime", "green"), 0.02, "streaks", "stub"))), size=(0.339, 0.0939, 0.0786),
             mass=1.2, material="food", aliases=("vegetable marrow",), themes=("kitchen", "food"),
             roles=("edible",), colors=("green",), state="lying flat"),
    Category("bean_sprout", keep_still(pod_of(Pod((0.05, 0.065), (0.004, 0.016, 0.024, 0.026),
             ("ivory", "white", "cream"), 0.16, "speckles", "head"))),
             size=(0.0618, 0.0126, 0.0039), mass=0.001, material="food",
             aliases=("beansprout", "mung bean sprout"), themes=("kitchen", "food"),
             roles=("edible",), colors=("ivory",), state="lying flat"),
    Category("bamboo_shoot", keep_still(pod_of(Pod((0.12, 0.16), (0.14, 0.15, 0.11, 0.06, 0.006),
             ("tan", "cream", "olive"), 0.02, "rings"))), size=(0.143, 0.0436, 0.0359), mass=0.2,
             material="food", themes=("kitchen", "food"), roles=("edible",), colors=("tan",),
             state="lying flat"),
    Category("baby_corn", keep_still(pod_of(Pod((0.08, 0.1), (0.05, 0.075, 0.075, 0.06, 0.008),
             ("yellow", "gold", "cream"), 0.02, "rings"))), size=(0.0887, 0.0138, 0.0115),
             mass=0.012, material="food", aliases=("babycorn",), themes=("kitchen", "food"),
             roles=("edible",), colors=("yellow",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
