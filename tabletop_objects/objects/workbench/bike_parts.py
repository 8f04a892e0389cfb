"""Objects of the ``workbench`` theme: bike parts."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import DARK, steel
from ...kit.outlines import ellipse, rectangle
from ...kit.primitives import at_box, ball, drum, lies, plate, rod, standing
from ...kit.shapes import Shape, category, put_down
from ...kit.solids import Solid, block, join, loft, torus
from ...kit.surfaces import Look, plain, tint_color


def _teeth(radius: float, count: int, deep: float, thick: float) -> Solid:
    """Return a toothed disc lying on z = 0."""
    a = 2 * np.pi * np.arange(4 * count) / (4 * count)
    r = np.tile([radius, radius, radius - deep, radius - deep], count)
    return plate(np.column_stack([r * np.cos(a), r * np.sin(a)]), thick)


@category("pedal", size=(0.102, 0.119, 0.0279), mass=0.18, material="plastic",
          aliases=("bike pedal", "bicycle pedal", "clipless pedal", "cycle pedal", "flat pedal"),
          themes=("workbench",), colors=("black",))  # fmt: skip
def pedal(look: Look) -> Shape:
    """A bicycle pedal lying flat: a cage around a barrel, with a threaded axle."""
    color = look.color("black", "silver", "red", "blue", "charcoal")
    k = look.between(0.9, 1.15)
    rails = [at_box(0.012, 0.09, 0.024, (s * 0.042, 0, 0)) for s in (-1, 1)]
    rails += [at_box(0.086, 0.01, 0.02, (0, s * 0.041, 0.002)) for s in (-1, 1)]
    barrel = drum(0.012, 0.09, (0, -0.045, 0.0125), 1, sides=16)
    axle = [drum(0.0065, 0.025, (0, 0.044, 0.0125), 1, sides=12),
            drum(0.009, 0.004, (0, 0.046, 0.0125), 1)]  # fmt: skip
    teeth = [
        at_box(0.008, 0.006, 0.027, (s * 0.042, y, 0)) for s in (-1, 1) for y in (-0.03, 0, 0.03)
    ]
    marks = [at_box(0.0015, 0.03, 0.012, (s * 0.0487, 0, 0.006)) for s in (-1, 1)]
    return put_down([(join([*rails, barrel]), look.surface(color, "plastic")),
                     (join([*axle, *teeth]), steel(look)), (join(marks), plain((240, 150, 40)))],
                    join(rails), axle[0], factor=k)  # fmt: skip


@category("saddle", size=(0.267, 0.14, 0.0681), mass=0.35, material="leather",
          aliases=("bike saddle", "bicycle saddle", "bike seat", "bicycle seat", "cycle saddle"),
          themes=("workbench",), roles=("big",), colors=("black", "brown"))  # fmt: skip
def saddle(look: Look) -> Shape:
    """A bicycle saddle with its rails."""
    color = look.color("black", "brown", "tan", "white", "red")
    k = look.between(0.9, 1.1)
    outline = np.array([(-0.13, -0.055), (-0.11, -0.072), (-0.06, -0.066), (0.0, -0.03),
                        (0.1, -0.017), (0.13, -0.012), (0.137, 0), (0.13, 0.012), (0.1, 0.017),
                        (0.0, 0.03), (-0.06, 0.066), (-0.11, 0.072), (-0.13, 0.055),
                        (-0.138, 0)])  # fmt: skip
    levels = [(0.96, 0.034), (1.0, 0.045), (0.95, 0.062), (0.78, 0.07)]
    rings = [np.column_stack([outline * [f**0.5, f], np.full(len(outline), z)]) for f, z in levels]
    top = loft(np.stack(rings), outline)
    rails = [rod([(0.12, 0, 0.04), (0.07, s * 0.02, 0.008), (-0.04, s * 0.022, 0.005),
                  (-0.1, s * 0.03, 0.04)], 0.0042, 8) for s in (-1, 1)]  # fmt: skip
    clamp = at_box(0.036, 0.05, 0.024, (0, 0, 0))
    return put_down([(top, surfaces.speckles(look.rng, color, 6)),
                     (join([*rails, clamp]), steel(look))], top, clamp, *rails, factor=k,
                    foot=0.25)  # fmt: skip


@category("derailleur", size=(0.0945, 0.171, 0.0251), mass=0.25, material="metal",
          aliases=("rear derailleur", "rear mech", "front derailleur", "bike derailleur",
          "jockey wheel"), themes=("workbench",), colors=("silver",))  # fmt: skip
def derailleur(look: Look) -> Shape:
    """A rear derailleur lying flat: a body with two jockey wheels in a cage."""
    color = look.color("silver", "black", "charcoal")
    k = look.between(0.85, 1.15)
    cage = plate(rectangle(0.028, 0.1, 0.013), 0.003, at=(0, -0.02, 0.008))
    low = plate(rectangle(0.028, 0.1, 0.013), 0.003, at=(0, -0.02, 0.0))
    wheels = [_teeth(0.019, 11, 0.004, 0.005).move(0, y, 0.003) for y in (-0.056, 0.012)]
    caps = [drum(0.006, 0.004, (0, y, 0.01)) for y in (-0.056, 0.012)]
    body = block(0.04, 0.06, 0.02, 0.006, 0.003).turn(2, 0.5).move(0.02, 0.045, 0)
    joint = drum(0.014, 0.024, (0.035, 0.075, 0), bevel=0.003)
    cable = rod([(0.03, 0.06, 0.015), (0.06, 0.04, 0.012), (0.07, 0.01, 0.005)], 0.0018, 6)
    return put_down([(join([cage, low]), steel(look)), (join(wheels), plain(DARK)),
                     (join([body, joint]), look.surface(color, "metal")),
                     (join([*caps, cable]), plain((70, 72, 78)))], join([low, cage]), body, joint,
                    factor=k)  # fmt: skip


@category("handlebar_grip", size=(0.125, 0.0369, 0.0354), mass=0.06, material="plastic",
          aliases=("bike grip", "handle bar grip", "rubber grip", "hand grip", "bicycle grip"),
          themes=("workbench",), colors=("black",))  # fmt: skip
def handlebar_grip(look: Look) -> Shape:
    """A ribbed rubber handlebar grip, lying flat."""
    color = look.color("black", "brown", "red", "blue", "green", "gray")
    k = look.between(0.85, 1.15)
    body = drum(0.0145, 0.12, (-0.06, 0, 0.0165), 0, sides=20)
    ribs = [torus(0.0145, 0.0016, 20, 6).turn(1, np.pi / 2).move(-0.05 + 0.011 * n, 0, 0.0165)
            for n in range(9)]  # fmt: skip
    flange = drum(0.018, 0.006, (0.055, 0, 0.0165), 0, sides=20)
    hole = drum(0.0105, 0.0008, (0.0608, 0, 0.0165), 0, sides=16)
    return put_down([(body, plain(color)), (join([*ribs, flange]), plain(tint_color(color, 0.8))),
                     (hole, plain((24, 24, 26)))], body, flange, factor=k, foot=0.3)  # fmt: skip


@category("brake_lever", size=(0.205, 0.0841, 0.0401), mass=0.1, material="metal",
          aliases=("bike brake lever", "bicycle brake", "shifter", "gear shifter", "brake handle"),
          themes=("workbench",), colors=("black",))  # fmt: skip
def brake_lever(look: Look) -> Shape:
    """A brake lever with its clamp, lying flat."""
    color = look.color("black", "silver", "charcoal")
    k = look.between(0.85, 1.15)
    clamp = torus(0.014, 0.005, 20, 8).turn(1, np.pi / 2).move(0.05, 0.0, 0.019)
    body = block(0.034, 0.024, 0.016, 0.005, 0.002).move(0.045, -0.03, 0.004)
    lever = rod([(0.04, -0.035, 0.011), (0.0, -0.05, 0.008), (-0.05, -0.042, 0.006),
                 (-0.085, -0.048, 0.007)], [0.006, 0.005, 0.0045, 0.0055], 10)  # fmt: skip
    cable = rod([(0.06, -0.03, 0.012), (0.09, -0.034, 0.008), (0.1, -0.06, 0.004)], 0.0025, 8)
    tip = ball(0.014, 0.014, 0.013, (-0.086, -0.048, 0.0065), 10)
    return put_down([(join([clamp, body]), look.surface(color, "metal")),
                     (join([lever, tip]), steel(look)), (cable, plain(DARK))], clamp, body, lever,
                    tip, factor=k, foot=0.2)  # fmt: skip


@category("reflector", size=(0.0748, 0.061, 0.0134), mass=0.03, material="plastic",
          aliases=("bike reflector", "wheel reflector", "bicycle reflector", "spoke reflector",
          "rear reflector"), themes=("workbench",), roles=("flat",), colors=("red",))  # fmt: skip
def reflector(look: Look) -> Shape:
    """A round or oblong reflector lying with its prisms up."""
    color = look.color("red", "amber", "white", "orange")
    k = look.between(0.85, 1.2)
    rim = ellipse(0.07, 0.07, 28) if look.chance(0.5) else rectangle(0.085, 0.045, 0.012)
    back, lens = plate(rim, 0.011), plate(0.88 * rim, 0.004, at=(0, 0, 0.0095))
    grid = surfaces.grid(tint_color(color, 0.65), tint_color(color, 1.15), 9, 9, 96, 3)
    return put_down([(back, plain(DARK)), (lens, grid)], back, factor=k)


@category("bike_pump", size=(0.287, 0.0507, 0.0303), mass=0.2, material="plastic",
          aliases=("bicycle pump", "mini pump", "tyre pump", "tire pump", "lilo pump",
          "cycle pump"), themes=("workbench", "sports"), colors=("silver", "black"))  # fmt: skip
def bike_pump(look: Look) -> Shape:
    """A hand pump with a slightly extended handle, lying flat."""
    color = look.color("silver", "black", "red", "blue", "yellow")
    k = look.between(0.85, 1.15)
    barrel = drum(0.0135, 0.17, (-0.09, 0, 0.0155), 0, sides=20)
    rod_ = drum(0.006, 0.05, (0.07, 0, 0.0155), 0, sides=12)
    grip = drum(0.0155, 0.07, (0.1, 0, 0.0155), 0, sides=18, bevel=0.004)
    ends = [drum(0.0155, 0.016, (x, 0, 0.0155), 0, sides=18) for x in (-0.1, 0.072)]
    head = [at_box(0.024, 0.034, 0.026, (-0.11, 0.006, 0.0)),
            drum(0.008, 0.014, (-0.11, 0.022, 0.0135), 1)]  # fmt: skip
    return put_down([(barrel, look.surface(color, "steel" if look.chance(0.5) else "plastic")),
                     (rod_, steel(look)), (join([grip, *ends, *head]), plain(DARK))],
                    barrel, grip, head[0], factor=k, foot=0.3)  # fmt: skip


@category("bike_light", size=(0.0486, 0.0788, 0.0728), mass=0.1, material="plastic",
          aliases=("bicycle light", "bike lamp", "rear light", "front light", "cycle light",
          "tail light", "bicycle lamp"), themes=("workbench",), colors=("black",))  # fmt: skip
def bike_light(look: Look) -> Shape:
    """A bicycle lamp with its clamp."""
    color = look.color("black", "charcoal", "red", "silver", "white")
    k = look.between(0.85, 1.15)
    lamp = look.pick([(236, 240, 244), (210, 40, 40), (236, 240, 244)])
    body = drum(0.021, 0.062, (0, -0.03, 0.048), 1, top=0.017)
    ring = drum(0.024, 0.012, (0, -0.04, 0.048), 1, bevel=0.002)
    lens = ball(0.04, 0.012, 0.04, (0, -0.04, 0.048), 18)
    knob = drum(0.008, 0.004, (0, 0.0, 0.066))
    stem = at_box(0.024, 0.026, 0.02, (0, 0, 0.016))
    clamp = [at_box(0.044, 0.034, 0.012), at_box(0.034, 0.03, 0.01, (0, 0, 0.01))]
    paint = surfaces.speckles(look.rng, color, 4)
    return put_down([(join([body, ring, stem]), paint), (lens, plain(lamp)),
                     (knob, plain((220, 60, 50))), (join(clamp), plain(DARK))], clamp[0], stem,
                    body, ring, factor=k)  # fmt: skip


@category("co2_cartridge", size=(0.0833, 0.0184, 0.0176), mass=0.05, material="metal",
          aliases=("gas cartridge", "co2 canister", "soda charger", "cream charger", "gas capsule"),
          themes=("workbench",), colors=("silver",))  # fmt: skip
def co2_cartridge(look: Look) -> Shape:
    """A small steel gas cartridge, lying flat."""
    color = look.color("silver", "gray", "gold", "blue")
    k = look.between(0.85, 1.15)
    profile = [(0.004, 0), (0.0085, 0.003), (0.0095, 0.008), (0.0095, 0.062), (0.006, 0.074),
               (0.0042, 0.078), (0.0042, 0.087)]  # fmt: skip
    body = lies(standing(*profile, sides=20), -0.043, 0, 0.0088)
    band = drum(0.0096, 0.018, (-0.02, 0, 0.0088), 0, sides=20)
    return put_down([(body, steel(look, color)), (band, plain(look.own_color("red", "blue",
                                                                             "black")))], body,
                    factor=k, foot=0.4)  # fmt: skip
