"""Objects of the ``electronics`` theme: electronic devices."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import facing
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, tint_color

DARK: RGB = (32, 32, 35)


@category("drone", size=(0.27, 0.27, 0.0605), mass=0.3, material="device",
          aliases=("quadcopter", "quadrocopter", "camera drone", "mini drone", "toy drone"),
          themes=("electronics",), roles=("big",), colors=("white", "gray"))  # fmt: skip
def drone(look: Look) -> Shape:
    """A quadcopter standing on its feet: a body, four arms with rotors, and a camera."""
    k = look.between(0.88, 1.08)
    color = look.color("white", "gray", "black", "charcoal", "orange", "red")
    tile = look.surface(color, "plastic")
    z = 0.034 * k
    body = ellipsoid(0.1, 0.075, 0.045, 24, 12).scale(k, k, k).move(z=z + 0.006 * k)
    arms, rotors, parts = [], [], []
    for s in (-1, 1):
        for t in (-1, 1):
            end = (s * 0.085 * k, t * 0.085 * k, z + 0.008 * k)
            arms.append(tube([(s * 0.025 * k, t * 0.02 * k, z + 0.005 * k), end], 0.0062 * k, 8))
            arms.append(cylinder(0.011 * k, 0.026 * k, 18).move(*end[:2], z))
            arms.append(tube([(*end[:2], z + 0.002), (s * 0.09 * k, t * 0.09 * k, 0.0035 * k)],
                             0.0035 * k, 8))  # fmt: skip
            turn = look.between(0, 3)
            blade = prism(rectangle(0.105 * k, 0.012 * k, 0.006 * k, 4), 0, 0.0016)
            rotors.append(blade.turn(2, turn).move(*end[:2], z + 0.027 * k))
            parts += [hull_of(a) for a in arms[-3:]]
            parts.append(hull_of(rotors[-1]))
    low = min(float(a.bounds[0, 2]) for a in arms)
    eye = [ellipsoid(0.026, 0.026, 0.026, 16, 10).scale(k, k, k).move(0, -0.034 * k, z - 0.008 * k)]
    lens = facing(cylinder(0.0065 * k, 0.004 * k, 16)).move(0, -0.0445 * k, z - 0.008 * k)
    stripe = block(0.03 * k, 0.04 * k, 0.003, 0.006).move(z=z + 0.0272 * k)
    parts = [p.__class__(p.vertices - [0, 0, low], p.kind, p.axis) for p in parts]
    drawn = [(join([body, *arms]), tile), (join(rotors), surfaces.plain(DARK)),
             (join(eye), surfaces.plain((60, 62, 66))), (lens, surfaces.plain((20, 22, 40))),
             (stripe, surfaces.plain(look.own_color("red", "cyan", "charcoal",
                 "orange")))]  # fmt: skip
    moved = [(s.move(z=-low), t) for s, t in drawn]
    return shape(moved, [hull_of(moved[0][0].__class__(body.vertices - [0, 0, low], body.faces,
                                                       body.uv)), *parts])  # fmt: skip


@category("power_supply", size=(0.133, 0.209, 0.172), mass=2.5, material="device",
          aliases=("bench power supply", "lab power supply", "dc power supply",
          "variable power supply", "power supply unit", "psu"), themes=("electronics",),
          roles=("big",), colors=("gray",))  # fmt: skip
def power_supply(look: Look) -> Shape:
    """A bench power supply with two displays, knobs and red and black sockets."""
    k = look.between(0.85, 1.05)
    x, y, h = 0.14 * k, 0.2 * k, 0.16 * k
    color = look.color("gray", "white", "charcoal", "blue", "cream")
    body = block(x, y, h - 0.008, 0.005, 0.002).move(z=0.008)
    feet = [cylinder(0.009, 0.009, 12).move(s * 0.36 * x, t * 0.38 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    image = prints.canvas(96, 112, tint_color(color, 0.9))
    for n, (unit, tone) in enumerate((("V", (255, 80, 70)), ("A", (90, 240, 120)))):
        prints.fill(image, 0.1, 0.08 + 0.24 * n, 0.8, 0.2, (22, 20, 22))
        value = f"{look.between(1, 24) if n == 0 else look.between(0, 3):05.2f}"
        prints.write(image, value + unit, 0.5, 0.18 + 0.24 * n, 0.15, tone, bold=True)
    front = box(0.94 * x, 0.0012, 0.92 * (h - 0.008)).move(y=-y / 2, z=0.008 + 0.04 * h)
    knobs = [facing(cylinder(0.012 * k, 0.013 * k, 20, bevel=0.001)).move((n - 0.5) * 0.06 * k,
             -y / 2, 0.43 * h) for n in (0, 1)]  # fmt: skip
    posts = [facing(cylinder(0.0085 * k, 0.018 * k, 16, bevel=0.001)).move(
        (n - 1) * 0.036 * k, -y / 2, 0.2 * h) for n in range(3)]  # fmt: skip
    tones = ((40, 40, 44), (60, 150, 80), (206, 50, 46))
    bow = tube(smooth([(0, -0.3 * y, h - 0.004), (0, -0.24 * y, h + 0.014),
        (0, 0.24 * y, h + 0.014),
                       (0, 0.3 * y, h - 0.004)], 3), 0.005, 8)  # fmt: skip
    return shape([(body, look.surface(color, "metal")), (front, image),
                  (join([*knobs, *feet, bow]), surfaces.plain(DARK)),
                  *[(p, surfaces.plain(c)) for p, c in zip(posts, tones, strict=True)]],
                 [box_part(x, y, h), hull_of(*knobs), hull_of(*posts), hull_of(bow)])  # fmt: skip


@category("security_camera", size=(0.068, 0.125, 0.112), mass=0.3, material="device",
          aliases=("surveillance camera", "cctv camera", "ip camera", "cctv", "baby camera"),
          themes=("electronics",), colors=("white",))  # fmt: skip
def security_camera(look: Look) -> Shape:
    """A bullet-shaped security camera on a base, with a dark glass front."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "white", "black", "gray")
    tile = look.surface(color, "plastic")
    base = cylinder(0.034 * k, 0.014 * k, 28, bevel=0.003)
    post = tube([(0, 0.004, 0.012), (0, 0.0, 0.05 * k)], 0.0075 * k, 12)
    tube_ = facing(lathe(np.array([(0, -0.055), (0.02, -0.055), (0.027, -0.048), (0.027, 0.05),
                                   (0.024, 0.053), (0.021, 0.049), (0, 0.049)]) * k,
                                       28))  # fmt: skip
    tube_ = tube_.turn(0, 0.12).move(z=0.076 * k)
    hood = facing(prism(_half(0.031 * k, 0.0285 * k), -0.045 * k, 0.068 * k)).turn(0, 0.12).move(
        z=0.076 * k)  # fmt: skip
    glass = (
        facing(cylinder(0.0212 * k, 0.0008, 26).move(z=0.0492 * k)).turn(0, 0.12).move(z=0.076 * k)
    )
    lens = (
        facing(cylinder(0.0095 * k, 0.0016, 20).move(z=0.0494 * k)).turn(0, 0.12).move(z=0.076 * k)
    )
    dots = [facing(cylinder(0.0022 * k, 0.0014, 8).move(0.0155 * k * np.cos(a),
        0.0155 * k * np.sin(a),
            0.0495 * k)).turn(0, 0.12).move(z=0.076 * k)
                for a in np.arange(8) * np.pi / 4]  # fmt: skip
    return shape([(join([base, post, tube_, hood]), tile), (glass, surfaces.plain((24, 24, 28))),
                  (lens, surfaces.gradient((30, 30, 60), (90, 110, 190), look.rng)),
                  (join(dots), surfaces.plain((150, 60, 60)))],
                 [hull_of(base), hull_of(post), hull_of(tube_), hull_of(hood)])  # fmt: skip


def _half(outer: float, inner: float) -> np.ndarray:
    a = np.linspace(-0.2, np.pi + 0.2, 18)
    ring = np.column_stack([np.cos(a), np.sin(a)])
    return np.concatenate([outer * ring, inner * ring[::-1]])
