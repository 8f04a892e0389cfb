"""Objects of the ``electronics`` theme: switches."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import steel
from ...kit.parts import hull_of
from ...kit.primitives import at_box, drum, standing
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import block, cylinder, ellipsoid, join, lathe, torus
from ...kit.surfaces import RGB, Look, plain

STEEL: RGB = (196, 198, 202)


@category("push_button", size=(0.093, 0.093, 0.036), mass=0.15, material="plastic",
          aliases=("button switch", "red button", "emergency button", "buzzer", "arcade button",
          "quiz buzzer", "emergency stop", "emergency stop button", "keycap", "door bell button"),
          themes=("electronics",), roles=("round",), colors=("red",))  # fmt: skip
def push_button(look: Look) -> Shape:
    """A big, round push button on a square or round base."""
    k = look.between(0.75, 1.15)
    color = look.color("red", "red", "green", "blue", "yellow")
    base_tone = look.own_color("black", "charcoal", "white", "yellow", "gray")
    r = 0.045 * k
    base = block(2.1 * r, 2.1 * r, 0.45 * r, 0.2 * r, 0.05 * r) if look.chance(0.5) else cylinder(
        1.1 * r, 0.45 * r, 36, bevel=0.05 * r)  # fmt: skip
    ring = lathe([(0.86 * r, 0.44 * r), (0.98 * r, 0.44 * r), (0.92 * r, 0.56 * r),
                  (0.86 * r, 0.56 * r)], 36, loop=True)  # fmt: skip
    dome = ellipsoid(1.66 * r, 1.66 * r, 0.66 * r, 32, 14).move(z=0.5 * r)
    dome = dome.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.4 * r)]))
    return shape([(base, surfaces.speckles(look.rng, base_tone, 3, 32)),
                  (ring, surfaces.brushed_metal(look.rng, STEEL)),
                  (dome, surfaces.speckles(look.rng, color, 3, 32))],
                 [hull_of(base), hull_of(dome)])  # fmt: skip


@category("toggle_switch", size=(0.0347, 0.0223, 0.071), mass=0.02, material="metal",
          aliases=("lever switch", "switch"), themes=("electronics",),
          colors=("red", "blue"))  # fmt: skip
def toggle_switch(look: Look) -> Shape:
    """A toggle switch: a body with terminals, a threaded collar and a lever."""
    color = look.color("red", "blue", "black", "green")
    k = look.between(0.9, 1.5)
    body = at_box(0.028, 0.016, 0.018, (0, 0, 0.007))
    top = at_box(0.028, 0.016, 0.002, (0, 0, 0.0245))
    bush = drum(0.006, 0.011, (0, 0, 0.026), sides=16)
    nut = drum(0.009, 0.0025, (0, 0, 0.028), sides=6)
    lean = 0.35 * look.pick([-1, 1])
    lever = (standing((0.0022, 0), (0.0022, 0.006), (0.0036, 0.018), (0.002, 0.022),
                      sides=12).turn(1, lean).move(z=0.036))  # fmt: skip
    pins = join([at_box(0.0012, 0.004, 0.008, (x, 0, 0)) for x in (-0.009, 0, 0.009)])
    return put_down([(body, plain(color)), (join([top, bush, nut, lever, pins]), steel(look))],
                    body, bush, pins, factor=k)  # fmt: skip


@category("rocker_switch", size=(0.0382, 0.0292, 0.0391), mass=0.012, material="plastic",
          aliases=("power switch", "push switch", "dip switch", "on-off switch"),
          themes=("electronics",), colors=("black",))  # fmt: skip
def rocker_switch(look: Look) -> Shape:
    """A rocker switch in a frame, marked 0 and 1."""
    color = look.color("black", "red", "green", "white")
    k = look.between(0.9, 1.4)
    body = at_box(0.028, 0.02, 0.02, (0, 0, 0.006))
    frame = block(0.034, 0.026, 0.004, 0.002, 0.001).move(z=0.025)
    rock = [at_box(0.014, 0.018, 0.004,
                   (0, 0, 0)).turn(1, s * 0.28).move(s * 0.007, 0, 0.028 + 0.001 * s)
            for s in (-1, 1)]  # fmt: skip
    marks = [at_box(0.001, 0.006, 0.0006, (0.008, 0, 0.0318))]
    zero = torus(0.003, 0.0006, 14, 5).turn(1, -0.25).move(-0.008, 0, 0.0322)
    pins = join([at_box(0.0012, 0.005, 0.008, (x, 0, 0)) for x in (-0.008, 0.008)])
    return put_down([(join([body, frame]), plain((44, 44, 48))), (join(rock), plain(color)),
                     (join([*marks, zero]), plain((240, 240, 240) if sum(color) < 560
                                                  else (40, 40, 44))), (pins, steel(look))], body,
                    frame, pins, factor=k)  # fmt: skip


@category("knob", size=(0.0385, 0.0385, 0.0216), mass=0.012, material="plastic",
          aliases=("control knob", "drawer knob", "volume knob", "dial knob", "doorknob",
          "cabinet knob", "dial"), themes=("electronics",), roles=("round",),
          colors=("black",))  # fmt: skip
def knob(look: Look) -> Shape:
    """A round knob with a ribbed rim and an indicator line."""
    color = look.color("black", "silver", "red", "cream", "blue", "brown")
    k = look.between(0.8, 1.6)
    skirt = drum(0.018, 0.004, sides=28, bevel=0.001)
    body = drum(0.0145, 0.016, (0, 0, 0.003), top=0.013, sides=24)
    ribs = [
        at_box(0.0024, 0.0018, 0.014, (0.0142, 0, 0.004)).turn(2, n * np.pi / 10) for n in range(20)
    ]
    cap = drum(0.0105, 0.0012, (0, 0, 0.0186), sides=24)
    line = at_box(0.0018, 0.008, 0.0014, (0, 0.008, 0.0188))
    paint = look.surface(color, "plastic")
    return put_down([(join([skirt, body, *ribs]), paint), (cap, steel(look)),
                     (line, plain((240, 60, 50)))], skirt, body, factor=k)  # fmt: skip
