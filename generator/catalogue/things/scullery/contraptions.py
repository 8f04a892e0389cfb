"""Kitchen gadgets with cranks and blades: spinners, pasta machines, mincers, slicers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import facing, side_view
from ...build.outlines import smooth
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, torus, tube
from ...build.variants import keep_still, vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (190, 194, 200)


HUES = ("white", "green", "red", "gray", "black", "teal", "yellow")


def metal(look: Look, color: RGB = STEEL) -> textures.Tile:
    """Return brushed metal."""
    return textures.brushed_metal(look.rng, color)


def salad_spinner(look: Look) -> Shape:
    """A salad spinner: a wide clear bowl, a slotted basket with leaves, a lid with a knob."""
    k, color = look.between(0.88, 1.06), look.color("green", "white", "red", "gray", "lime", "teal")
    bowl = lathe([(0, 0), (0.08, 0), (0.1, 0.01), (0.122, 0.1), (0.124, 0.12), (0, 0.12)], 36)
    image = prints.canvas(192, 96, (222, 230, 232))
    for n in range(40):
        prints.fill(image, n / 40, 0.2, 0.01, 0.62, (120, 170, 110) if n % 3 else (200, 210, 206))
    lid = lathe([(0, 0.118), (0.128, 0.118), (0.126, 0.13), (0.06, 0.145), (0, 0.147)], 36)
    knob = lathe(
        [(0, 0.14), (0.03, 0.14), (0.026, 0.158), (0.03, 0.17), (0.018, 0.182), (0, 0.184)], 24
    )
    ring = torus(0.08, 0.003, 36, 6).move(z=0.139)
    tile = look.surface(color, "plastic")
    made = [
        (bowl, image),
        (lid, tile),
        (join([knob, ring]), textures.plain(tint_color(color, 0.7))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0]), hull_of(knob.scale(k, k, k))])


def pasta_machine(look: Look) -> Shape:
    """A pasta machine: chrome cheeks and rollers, a dial, a crank, a sheet of dough coming out."""
    k, color = look.between(0.9, 1.06), look.color("silver", "silver", "red", "black")
    cheeks = [side_view(np.array([(-0.055, 0), (0.055, 0), (0.05, 0.09), (0.03, 0.125),
                                  (-0.03, 0.125), (-0.05, 0.1)]), 0.014)
              .turn(2, np.pi / 2).move(x=s * 0.085) for s in (-1, 1)]  # fmt: skip
    rollers = [
        cylinder(0.017, 0.16, 22).turn(1, np.pi / 2).move(-0.08, y, 0.1) for y in (-0.018, 0.018)
    ]
    tray = box(0.16, 0.09, 0.006).turn(0, 0.35).move(0, -0.045, 0.04)
    foot = [box(0.19, 0.03, 0.012).move(y=y) for y in (-0.045, 0.045)]
    dial = cylinder(0.02, 0.02, 20).turn(1, -np.pi / 2).move(-0.09, 0, 0.075)
    crank = tube(
        [(0.09, 0, 0.08), (0.115, 0, 0.08), (0.118, 0, 0.15), (0.125, 0, 0.152)], 0.0045, 8
    )
    grip = (
        lathe([(0, 0), (0.01, 0.002), (0.012, 0.03), (0.009, 0.05), (0, 0.05)], 16)
        .turn(1, np.pi / 2)
        .move(0.122, 0, 0.152)
    )
    dough = box(0.13, 0.11, 0.0022).turn(0, 0.55).move(0, -0.075, 0.038)
    made = [(join([*cheeks, *foot]), look.surface(color, "chrome")),
            (join([*rollers, tray, crank]), metal(look)), (join([dial, grip]),
                                                            textures.plain((30, 30, 34))),
            (dough, textures.speckles(look.rng, (244, 222, 150), 8))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(made[0][0]),
            hull_of(crank.scale(k, k, k), grip.scale(k, k, k)),
            hull_of(made[3][0]),
        ],
    )


def mincer(look: Look) -> Shape:
    """A hand mincer: a funnel on a barrel, a plate with holes, a crank, a table foot."""
    k, color = look.between(0.88, 1.06), look.color("silver", "silver", "red", "white", "cream")
    foot = block(0.11, 0.09, 0.014, 0.02, 0.003)
    neck = lathe([(0, 0), (0.03, 0), (0.018, 0.04), (0.022, 0.1), (0, 0.1)], 18).move(z=0.01)
    barrel = (
        lathe([(0, 0), (0.03, 0), (0.033, 0.03), (0.042, 0.09), (0.042, 0.11), (0, 0.11)], 22)
        .turn(1, -np.pi / 2)
        .move(0.05, 0, 0.125)
    )
    hopper = lathe(
        [
            (0, 0.14),
            (0.022, 0.14),
            (0.026, 0.17),
            (0.06, 0.21),
            (0.058, 0.212),
            (0.02, 0.172),
            (0, 0.172),
        ],
        24,
    )
    plate = cylinder(0.036, 0.003, 22).turn(1, -np.pi / 2).move(-0.06, 0, 0.125)
    meat = [limb([(-0.062, 0.024 * np.cos(a), 0.125 + 0.024 * np.sin(a)),
                  (-0.076, 0.024 * np.cos(a), 0.118 + 0.024 * np.sin(a)),
                  (-0.082, 0.024 * np.cos(a), 0.1 + 0.018 * np.sin(a))], [0.005, 0.005, 0.004],
                  6) for a in np.arange(7) * 0.9]  # fmt: skip
    crank = tube([(0.05, 0, 0.125), (0.085, 0, 0.125), (0.09, 0, 0.05), (0.1, 0, 0.048)], 0.006, 8)
    grip = (
        lathe([(0, 0), (0.011, 0.003), (0.013, 0.05), (0, 0.055)], 14)
        .turn(1, np.pi / 2)
        .move(0.096, 0, 0.048)
    )
    made = [(join([foot, neck, barrel, hopper]), look.surface(color, "metal")),
            (plate, prints.mesh_holes((200, 202, 206), (60, 60, 64), 7, 7)),
            (join(meat), textures.plain((206, 92, 84))),
            (crank, metal(look)), (grip, textures.wood(look.rng, (150, 96, 60)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(foot.scale(k, k, k)),
            hull_of(neck.scale(k, k, k)),
            hull_of(barrel.scale(k, k, k)),
            hull_of(hopper.scale(k, k, k)),
            hull_of(made[3][0], made[4][0]),
        ],
    )


def meat_slicer(look: Look) -> Shape:
    """A slicer: a big round blade on a motor block, a sliding tray with a sausage."""
    k, color = look.between(0.88, 1.02), look.color("silver", "red", "white", "black")
    base = block(0.3, 0.18, 0.05, 0.03, 0.006)
    motor = block(0.1, 0.1, 0.1, 0.03, 0.01).move(0.08, 0.03, 0.045)
    blade = facing(cylinder(0.095, 0.003, 44)).move(0.02, -0.03, 0.145)
    hub = facing(cylinder(0.03, 0.012, 24)).move(0.02, -0.03, 0.145)
    guard = facing(torus(0.098, 0.006, 36, 7)).move(0.02, -0.026, 0.145)
    tray = box(0.13, 0.09, 0.008).turn(1, -0.12).move(-0.06, -0.075, 0.065)
    wall = box(0.008, 0.09, 0.07).move(-0.12, -0.075, 0.06)
    ham = cylinder(0.032, 0.08, 20).turn(0, np.pi / 2).move(-0.05, -0.04, 0.108)
    made = [(join([base, motor]), look.surface(color, "plastic")), (join([blade, tray, wall]),
        metal(look, (206, 210, 214))), (join([guard]), textures.plain((70, 72, 76))),
            (hub, textures.plain(tint_color(color, 0.8))),
            (ham, textures.spots(look.rng, (206, 100, 96), (240, 200, 190), 0.2))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(base.scale(k, k, k)),
            hull_of(motor.scale(k, k, k)),
            hull_of(blade.scale(k, k, k)),
            hull_of(tray.scale(k, k, k), wall.scale(k, k, k)),
        ],
    )


def spiralizer(look: Look) -> Shape:
    """A spiralizer: a frame with a crank, a courgette against a toothed blade, curls before it."""
    k, color = look.between(0.88, 1.05), look.color(*HUES)
    rails = [box(0.26, 0.014, 0.018).move(y=s * 0.05, z=0.008) for s in (-1, 1)]
    ends = [block(0.018, 0.12, 0.13, 0.006).move(x) for x in (-0.09, 0.06)]
    feet = [
        cylinder(0.014, 0.01, 14, top=0.01).move(i * 0.12, j * 0.05, 0)
        for i in (-1, 1)
        for j in (-1, 1)
    ]
    blade = cylinder(0.05, 0.004, 28).turn(1, -np.pi / 2).move(-0.099, 0, 0.075)
    veg = limb([(-0.08, 0, 0.075), (-0.02, 0, 0.075), (0.05, 0, 0.075)], [0.022, 0.023, 0.02], 14)
    crank = tube([(0.05, 0, 0.075), (0.11, 0, 0.075), (0.112, 0, 0.14), (0.12, 0, 0.142)], 0.005, 8)
    grip = cylinder(0.01, 0.04, 14).turn(1, np.pi / 2).move(0.118, 0, 0.142)
    a = np.linspace(0, 18, 60)
    curl = tube(
        np.column_stack(
            [-0.125 - 0.0012 * a + 0.02 * np.cos(a), 0.03 * np.sin(a), 0.004 + 0.0012 * a]
        ),
        0.003,
        5,
    )
    made = [(join([*rails, *ends]), look.surface(color, "plastic")), (blade,
        prints.mesh_holes((206, 210, 214), (120, 124, 130), 5, 5)), (veg,
            textures.stripes([(86, 140, 66), (110, 164, 84)], 8, upright=True)),
            (join([crank]), metal(look)), (join([grip, *feet]), textures.plain((40, 42, 46))),
            (curl, textures.plain((176, 206, 120)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(*[s.scale(k, k, k) for s in (*rails, *feet)]),
            *[hull_of(e.scale(k, k, k)) for e in ends],
            hull_of(made[3][0], grip.scale(k, k, k)),
            hull_of(made[5][0]),
        ],
    )


def ricer(look: Look) -> Shape:
    """A potato ricer lying: a pierced cup between two long handles."""
    k, color = (
        look.between(0.9, 1.08),
        look.color("silver", "black", "red", "green", "blue", "white"),
    )
    cup = lathe(
        [(0, 0), (0.038, 0), (0.042, 0.07), (0.039, 0.07), (0.035, 0.003), (0, 0.003)], 26
    ).move(-0.06, 0, 0)
    press = cylinder(0.036, 0.012, 24).move(-0.06, 0, 0.075)
    arms = [tube(smooth([(-0.02, 0, 0.062), (0.06, 0, 0.05), (0.16, 0, 0.012)], 4), 0.006, 8)]
    link = tube([(-0.105, 0, 0.064), (-0.06, 0, 0.1), (0.02, 0, 0.085), (0.16, 0, 0.068)], 0.006, 8)
    made = [
        (join([cup]), prints.mesh_holes((196, 200, 206), (90, 94, 100), 14, 34)),
        (join([press, *arms, link]), look.surface(color, "steel")),
    ]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0], [1]])


_K = ("kitchen",)


_B = ("big",)

CATEGORIES = (
    Category("salad_spinner", salad_spinner, (0.247, 0.247, 0.178), 0.9,
             ("lettuce spinner", "salad dryer", "salad drier"), _K, ("big", "round"),
             ("green", "white")),
    vary(Category("pasta_machine", pasta_machine, (0.27, 0.175, 0.157), 2.5,
             ("pasta maker", "pasta roller", "noodle maker"), _K, _B, ("silver",))),
    Category("mincer", mincer, (0.233, 0.118, 0.209), 1.6, ("meat grinder", "meat mincer",
                                                            "hand mincer", "sausage maker"), _K,
                                                            ("tall",), ("silver",)),
    Category("meat_slicer", meat_slicer, (0.277, 0.194, 0.23), 4.0, ("food slicer", "bread slicer",
        "ham slicer", "deli slicer"), _K, _B, ("silver",)),
    Category("spiralizer", spiralizer, (0.324, 0.128, 0.151), 0.8, ("spiraliser",
        "vegetable spiralizer", "spiral slicer"), _K, _B, ("white", "green")),
    Category("ricer", keep_still(ricer), (0.268, 0.0832, 0.105), 0.5, ("potato ricer",
        "potato press", "spaetzle press"), _K, (), ("silver",), state="lying"),
)  # fmt: skip
"""The module's categories."""
