"""Objects of the ``sports`` theme: fishing tackle."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import BRASS_TONE, DARK, steel
from ...kit.outlines import ellipse
from ...kit.primitives import at_box, ball, drum, lies, plate, rod, standing, straight
from ...kit.shapes import Shape, category, put_down
from ...kit.solids import Solid, block, join, torus
from ...kit.surfaces import Look, plain, tint_color


def _hook(x: float, z: float = 0.0015, size: float = 1.0) -> Solid:
    """Return a fish hook lying flat, with the eye at ``x`` and the bend on the left."""
    s = 0.012 * size
    path = [(x, 0, z), (x - 1.6 * s, 0, z), (x - 2.3 * s, 0.35 * s, z), (x - 2.1 * s, 0.9 * s, z),
            (x - 1.5 * s, 0.95 * s, z)]  # fmt: skip
    return rod(path, [0.0009, 0.0009, 0.0009, 0.0003], 6)


@category("fishing_reel", size=(0.152, 0.102, 0.0734), mass=0.25, material="plastic",
          assembled=True, aliases=("fly reel", "spinning reel", "reel"), themes=("sports",),
          colors=("black", "silver"))  # fmt: skip
def fishing_reel(look: Look) -> Shape:
    """A fishing reel on its side: a spool of line, a bail, a foot and a crank."""
    color = look.color("black", "silver", "gold", "navy", "red")
    k = look.between(0.85, 1.15)
    body = block(0.04, 0.045, 0.044, 0.012, 0.005)
    rotor = drum(0.025, 0.03, (0.02, 0, 0.028), 0, top=0.028, sides=24)
    spool = drum(0.022, 0.03, (0.048, 0, 0.028), 0, sides=24)
    lip = [drum(0.0255, 0.004, (x, 0, 0.028), 0, sides=24) for x in (0.048, 0.077)]
    knob = drum(0.011, 0.012, (0.08, 0, 0.028), 0, sides=14, bevel=0.002)
    bail = rod([(0.04, 0.026, 0.028), (0.072, 0.032, 0.038), (0.082, 0, 0.058),
                (0.072, -0.032, 0.038), (0.04, -0.026, 0.028)], 0.0015, 6)  # fmt: skip
    stem = at_box(0.012, 0.014, 0.03, (-0.008, 0, 0.04))
    foot = at_box(0.075, 0.014, 0.005, (-0.008, 0, 0.068))
    arm = [straight((-0.004, -0.02, 0.026), (-0.004, -0.042, 0.026), 0.0045, 8),
           straight((-0.004, -0.042, 0.026), (-0.05, -0.046, 0.012), 0.0038, 8),
           ball(0.02, 0.026, 0.02, (-0.05, -0.054, 0.0095), 10)]  # fmt: skip
    line = surfaces.stripes([(226, 232, 210), (190, 200, 176)], 12)
    shell = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    return put_down(
        [(join([body, rotor, stem, foot]), shell), (spool, line), (join([*lip, bail]), steel(look)),
         (join([knob, *arm]), plain(DARK))], body, rotor, join([spool, *lip]), stem, foot, arm[2],
        factor=k, foot=0.2)  # fmt: skip


@category("fishing_float", size=(0.0852, 0.0234, 0.0226), mass=0.01, material="plastic",
          aliases=("bobber", "fishing bobber", "bite alarm"), themes=("sports",),
          colors=("red",))  # fmt: skip
def fishing_float(look: Look) -> Shape:
    """A red and white float on a thin stem, lying flat."""
    color = look.color("red", "orange", "yellow", "green", "pink")
    k = look.between(0.75, 1.25)
    body = ball(0.032, 0.028, 0.028, (0, 0, 0.0132), 20)
    if look.chance(0.5):
        body = ball(0.05, 0.02, 0.02, (0, 0, 0.0094), 20)
    z = float(body.bounds.mean(0)[2])
    halves = surfaces.stripes([(244, 242, 236), color], 1)
    r = float(body.bounds[1, 2] - z)
    shell = standing((0.0012, -1.6 * r), (0.62 * r, -1.25 * r), (r, -0.2 * r), (r, 0.2 * r),
                    (0.62 * r, 1.25 * r), (0.0012, 1.6 * r), sides=22)  # fmt: skip
    shell = lies(shell, 0, 0, 0.94 * r)
    stem = straight((-1.5 * r - 0.022, 0, 0.94 * r), (1.5 * r + 0.03, 0, 0.94 * r), 0.0012, 8)
    tip = straight((1.5 * r + 0.018, 0, 0.94 * r), (1.5 * r + 0.032, 0, 0.94 * r), 0.0021, 8)
    return put_down([(shell, halves), (stem, plain((60, 50, 44))), (tip, plain((250, 120, 40)))],
                    shell, factor=k, foot=0.2)  # fmt: skip


@category("fishing_lure", size=(0.115, 0.052, 0.0206), mass=0.02, material="plastic",
          aliases=("lure", "crankbait", "plug lure", "soft bait", "minnow lure", "fishing bait"),
          themes=("sports",), colors=("silver", "green"))  # fmt: skip
def fishing_lure(look: Look) -> Shape:
    """A fish-shaped lure with hooks below it, lying flat."""
    color = look.color("silver", "green", "gold", "red", "blue", "orange")
    k = look.between(0.8, 1.2)
    body = ball(0.075, 0.022, 0.02, (0, 0, 0.0095), 18)
    tail = plate(
        [(-0.032, 0), (-0.052, 0.014), (-0.047, 0), (-0.052, -0.014)], 0.004, at=(0, 0, 0.0075)
    )
    lip = plate([(0.032, -0.006), (0.05, -0.009), (0.05, 0.009), (0.032, 0.006)], 0.002).move(
        0, 0, 0.006
    )
    eyes = [drum(0.0035, 0.0012, (0.026, 0.0, 0.0163), sides=10)]
    hooks = [_hook(0.0, 0.0015, 0.9).turn(2, 1.1 + 0.5 * n).move(x, -0.009, 0)
             for x in (-0.022, 0.014) for n in (0, 1)]  # fmt: skip
    loop = torus(0.003, 0.0008, 12, 5).move(0.053, 0, 0.007)
    skin = surfaces.gradient(tint_color(color, 0.6), tint_color(color, 1.4), look.rng)
    return put_down([(join([body, tail]), skin), (lip, plain((220, 234, 238))),
                     (join(eyes), plain((240, 200, 60))),
                     (join([*hooks, loop]), steel(look, (110, 112, 118)))], body, tail, factor=k,
                    foot=0.2)  # fmt: skip


@category("spoon_lure", size=(0.0888, 0.0225, 0.00436), mass=0.012, material="metal",
          aliases=("spinner lure", "fishing spoon", "fishing spinner", "jig", "fishing jig",
          "fish hook", "fishing hook", "swivel"), themes=("sports",), roles=("flat",),
          colors=("silver",))  # fmt: skip
def spoon_lure(look: Look) -> Shape:
    """A spoon lure lying flat: a bright hammered blade with rings and a hook."""
    color = look.color("silver", "gold", "copper", "red")
    k = look.between(0.8, 1.25)
    blade = plate(ellipse(0.05, 0.02, 26), 0.0022, bevel=0.0005)
    ridge = ball(0.04, 0.012, 0.004, (0, 0, 0.0022), 14)
    rings = [torus(0.0035, 0.0008, 14, 5).move(x, 0, 0.0009) for x in (-0.0265, 0.0265)]
    hooks = [_hook(-0.029, 0.0012, 0.9), _hook(-0.029, 0.0012, 0.9).scale(1, 1, 1).turn(0, np.pi)
             .move(z=0.0024)]  # fmt: skip
    tuft = plate(
        [(-0.03, -0.004), (-0.048, -0.009), (-0.052, 0), (-0.048, 0.009), (-0.03, 0.004)], 0.0012
    )
    return put_down([(join([blade, ridge]), steel(look, color)),
                     (join([*rings, *hooks]), steel(look)), (tuft, plain(look.own_color("red",
                                                                                        "yellow",
                                                                                        "white")))],
                    blade, tuft, factor=k)  # fmt: skip


@category("fishing_fly", size=(0.0395, 0.026, 0.0144), mass=0.002, material="plastic",
          aliases=("fly", "dry fly", "trout fly", "salmon fly"), themes=("sports",),
          colors=("brown",))  # fmt: skip
def fishing_fly(look: Look) -> Shape:
    """An artificial fly lying flat: a hook with a thread body, hackles and wings."""
    color = look.color("brown", "red", "olive", "black", "yellow")
    k = look.between(0.85, 1.35)
    hook = _hook(0.018, 0.005, 1.3)
    body = rod([(-0.004, 0, 0.005), (0.012, 0, 0.0052)], [0.0022, 0.003], 10)
    hackles = []
    for n in range(14):
        a = n * 2 * np.pi / 14
        tip = (0.011, 0.0085 * np.cos(a), 0.0052 + 0.0085 * np.sin(a))
        hackles.append(
            straight((0.013, 0, 0.0052), (tip[0], tip[1], max(tip[2], 0.0003)), 0.0004, 4)
        )
    wings = [plate([(0.012, s * 0.001), (0.0, s * 0.009), (-0.012, s * 0.007), (0.002, s * 0.001)],
                   0.0006, at=(0, 0, 0.008)) for s in (-1, 1)]  # fmt: skip
    tail = [straight((-0.004, 0, 0.005), (-0.018, 0.004 * n, 0.008), 0.0004, 4) for n in (-1, 0, 1)]
    tone = look.own_color("red", "mustard", "navy", "coral")
    thread = surfaces.stripes([color, tint_color(tone, 0.9)], 4, upright=False)
    whole = [hook, body, *hackles, *wings, *tail]
    return put_down([(hook, steel(look, (90, 92, 98))), (body, thread),
                     (join([*hackles, *tail]), plain(color)),
                     (join(wings), plain(tint_color(color, 1.5)))], join(whole), factor=k,
                    foot=0.35)  # fmt: skip


@category("sinker", size=(0.0576, 0.027, 0.0257), mass=0.04, material="metal",
          aliases=("lead weight", "fishing weight", "split shot", "lead sinker", "plumb bob",
          "plummet"), themes=("sports",), colors=("gray",))  # fmt: skip
def sinker(look: Look) -> Shape:
    """A lead weight with a wire eye, lying flat."""
    color = look.color("gray", "charcoal", "silver")
    k = look.between(0.8, 1.3)
    body = lies(standing((0.004, 0), (0.0105, 0.007), (0.0125, 0.016), (0.009, 0.034),
                         (0.0035, 0.044), sides=18), -0.022, 0, 0.0115)  # fmt: skip
    eye = torus(0.0045, 0.001, 14, 5).turn(0, np.pi / 2).move(0.026, 0, 0.0115)
    return put_down([(body, surfaces.speckles(look.rng, color, 9)), (eye, steel(look, BRASS_TONE))],
                    body, factor=k, foot=0.35)  # fmt: skip


@category("landing_net", size=(0.295, 0.132, 0.015), mass=0.15, material="wood", assembled=True,
          aliases=("keep net", "net", "pond net"), themes=("sports",), roles=("flat", "big"),
          colors=("wooden", "green"))  # fmt: skip
def landing_net(look: Look) -> Shape:
    """A small net on a hoop with a handle, lying flat."""
    color = look.color("wooden", "green", "blue", "black", "red")
    k = look.between(0.7, 0.95)
    hoop = torus(0.085, 0.005, 36, 8).scale(1.15, 0.9, 1).move(0.09, 0, 0.0048)
    handle = straight((-0.17, 0, 0.009), (-0.005, 0, 0.007), [0.0095, 0.007], 12)
    net = []
    for n in range(-6, 7):
        u = n / 6.6
        half = np.sqrt(1 - u**2)
        for flat in (True, False):
            a, b = (0.096 * half, 0.077 * u) if flat else (0.096 * u, 0.077 * half)
            ends = [(0.09 - a, b), (0.09 + a, b)] if flat else [(0.09 + a, -b), (0.09 + a, b)]
            net.append(straight((*ends[0], 0.0032), (*ends[1], 0.0032), 0.0009, 4))
    mesh = plain(look.own_color("green", "white", "black", "navy"))
    return put_down([(join([hoop, handle]), look.surface(color, "wood")), (join(net), mesh)],
                    join([hoop, *net]), handle, factor=k, foot=0.25)  # fmt: skip


@category("fishing_rod", size=(0.405, 0.0768, 0.0286), mass=0.2, material="plastic", assembled=True,
          aliases=("fishing pole", "toy fishing rod", "rod and reel", "fly rod", "angling rod"),
          themes=("sports",), roles=("big",), colors=("black",))  # fmt: skip
def fishing_rod(look: Look) -> Shape:
    """A short fishing rod with a reel and line guides, lying flat."""
    color = look.color("black", "red", "green", "navy", "brown")
    k = look.between(0.75, 1.0)
    blank = straight((-0.05, 0, 0.0115), (0.3, 0, 0.002), [0.005, 0.0018], 10)
    grip = straight((-0.15, 0, 0.014), (-0.01, 0, 0.014), [0.012, 0.0105], 14)
    seat = straight((-0.1, 0, 0.014), (-0.05, 0, 0.014), 0.0128, 14)
    guides = [torus(0.006 - 0.001 * n, 0.001, 12, 5).turn(1, np.pi / 2).move(0.06 + 0.075 * n,
                                                                             -0.008, 0.0085 - 0.002
                                                                             * n)
              for n in range(4)]  # fmt: skip
    spool = drum(0.016, 0.02, (-0.085, -0.034, 0.016), 0, sides=18)
    stem = at_box(0.01, 0.02, 0.01, (-0.075, -0.018, 0.01))
    arm = straight((-0.075, -0.034, 0.016), (-0.095, -0.062, 0.008), 0.003, 6)
    knob = ball(0.012, 0.014, 0.012, (-0.097, -0.066, 0.0058), 8)
    return put_down([(blank, plain(color)), (grip, surfaces.spots(look.rng, (206, 168, 118),
                                                                  (150, 110, 70), 0.15)),
                     (join([seat, knob, arm]), plain(DARK)), (join([*guides, stem]), steel(look)),
                     (spool, surfaces.stripes([(226, 232, 210), (180, 190, 170)], 8))],
                    straight((-0.15, 0, 0.0138), (0.3, 0, 0.0022), [0.0124, 0.0022], 10), spool,
                    knob, factor=k, foot=0.3)  # fmt: skip
