"""Objects of the ``lab`` theme: medical supplies."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic, shine, wood
from ...kit.primitives import at_block, at_box, ball, disc, pad, plate, rod, spindle, straight
from ...kit.shapes import Category, Drawing, Pieces, category, from_pieces, vary
from ...kit.solids import join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color

BLACK = surfaces.plain((34, 34, 37))


@category("otoscope", size=(0.203, 0.0777, 0.0317), mass=0.12, material="metal",
          aliases=("ophthalmoscope", "ear scope", "dermatoscope", "laryngoscope"), themes=("lab",),
          colors=("black",))  # fmt: skip
@from_pieces(foot=0.08)
def otoscope(look: Look) -> Pieces:
    """An otoscope lying flat: a handle and a round head with a cone."""
    z = 0.016
    grip = spindle((-0.11, 0.012), (-0.1, 0.0155), (0.02, 0.0145), (0.03, 0.011), z=z)
    neck = spindle((0.03, 0.008), (0.055, 0.008), z=z)
    head = disc(0.019, 0.024, (0.07, 0, 0.004))
    cone = straight((0.07, -0.012, z), (0.07, -0.05, z), (0.011, 0.003), 14)
    lens = disc(0.013, 0.014).turn(0, -np.pi / 2).move(0.07, 0.012, z)
    return [(grip, plastic(look, "black", "navy", "silver")), (head, dye(look, "black", "silver")),
            (neck, shine(look)), (cone, BLACK), (lens, shine(look))]  # fmt: skip


@category("tongue_depressor", size=(0.15, 0.018, 0.0016), mass=0.002, material="wood",
          aliases=("tongue spatula", "wooden spatula stick", "ice cream stick wooden"),
          themes=("lab",), roles=("flat",), colors=("beige",))  # fmt: skip
@from_pieces()
def tongue_depressor(look: Look) -> Pieces:
    """A flat wooden tongue depressor with rounded ends."""
    return [(at_block(0.15, 0.018, 0.0016, 0.0088), wood(look, "beige", "cream", "tan"))]


@category("sharps_container", size=(0.136, 0.106, 0.19), mass=0.3, material="plastic",
          aliases=("sharps bin", "sharps box", "biohazard bin", "needle bin"), themes=("lab",),
          roles=("tall",), colors=("yellow",))  # fmt: skip
@from_pieces(bodies=2)
def sharps_container(look: Look) -> Pieces:
    """A yellow sharps container with a lid and a warning sign."""
    body = at_block(0.13, 0.1, 0.16, 0.014)
    lid = at_block(0.136, 0.106, 0.03, 0.016, (0, 0, 0.158))
    slot = at_block(0.06, 0.03, 0.004, 0.01, (0, 0.01, 0.186))
    image = prints.canvas(64, 64, (246, 206, 60))
    prints.disc(image, 0.5, 0.38, 0.24, (30, 30, 32), 0.19)
    for k in range(3):
        a = np.pi / 2 + k * 2.0944
        prints.disc(
            image, 0.5 + 0.15 * np.cos(a), 0.38 - 0.15 * np.sin(a), 0.11, (30, 30, 32), 0.06
        )
    prints.write(image, "SHARPS", 0.5, 0.82, 0.2, (30, 30, 32), True)
    return [(body, plastic(look, "yellow", "yellow", "red")), (lid, dye(look, "red", "orange",
                                                                        "blue")), (slot, BLACK),
            (at_box(0.09, 0.002, 0.1, (0, -0.0505, 0.025)), image)]  # fmt: skip


def _cassette(kind: str) -> Drawing:
    """Return the drawing function of a test strip or cassette whose window shows test lines."""

    def draw(look: Look) -> Pieces:
        lines = look.pick([1, 2])
        if kind == "cassette":
            body = at_block(0.07, 0.02, 0.005, 0.006)
            image = prints.canvas(160, 44, (246, 246, 244))
            prints.fill(image, 0.3, 0.25, 0.3, 0.5, (226, 232, 240))
            for k in range(lines):
                prints.fill(image, 0.38 + 0.1 * k, 0.27, 0.022, 0.46, (200, 40, 70))
            prints.disc(image, 0.8, 0.5, 0.3, (190, 198, 208))
            return [
                (body, plastic(look, "white", "cream")),
                (at_box(0.064, 0.0165, 0.0005, (0, 0, 0.0048)), image),
            ]
        body = at_block(0.12, 0.018, 0.011, 0.007)
        cap = at_block(0.04, 0.02, 0.0125, 0.007, (0.052, 0, 0))
        image = prints.canvas(96, 24, (236, 240, 244))
        for k in range(lines):
            prints.fill(image, 0.35 + 0.2 * k, 0.1, 0.06, 0.8, (214, 60, 120))
        return [(body, plastic(look, "white", "cream")), (cap, dye(look, "pink", "blue", "purple")),
                (at_block(0.034, 0.009, 0.0006, 0.003, (-0.018, 0, 0.0107)), image)]  # fmt: skip

    return draw


@category("test_strip", size=(0.075, 0.0075, 0.0009), mass=0.001, material="plastic",
          aliases=("ph strip", "litmus paper", "urine test strip", "glucose strip", "ph paper",
          "indicator paper"), themes=("lab",), roles=("flat",), colors=("yellow",))  # fmt: skip
@vary(0.08)
@from_pieces()
def test_strip(look: Look) -> Pieces:
    """A narrow white strip with four coloured fields on its left half."""
    image = prints.canvas(160, 16, (246, 244, 236))
    for k, name in enumerate(("yellow", "orange", "green", "teal")):
        prints.fill(image, 0.04 + 0.12 * k, 0, 0.1, 1, look.own_color(name))
    return [(at_box(0.075, 0.0075, 0.0009), image)]


@category("hearing_aid", size=(0.046, 0.05, 0.012), mass=0.005, material="plastic",
          aliases=("cochlear implant", "ear piece", "earpiece"), themes=("lab",),
          colors=("beige",))  # fmt: skip
@from_pieces(foot=0.1)
def hearing_aid(look: Look) -> Pieces:
    """A hearing aid lying flat: a curved case, a thin pale tube and an ear bud at its end."""
    tile = plastic(look, "beige", "gray", "silver", "brown")
    body = rod([(-0.014, -0.006, 0.006), (-0.006, 0.008, 0.006), (0.008, 0.008, 0.006),
                (0.014, -0.002, 0.006)], [0.0045, 0.006, 0.006, 0.0035], 12)  # fmt: skip
    pipe = rod([(0.014, -0.002, 0.006), (0.026, -0.012, 0.004), (0.022, -0.028, 0.003)], 0.0012, 6)
    bud = ball(0.009, 0.009, 0.009, (0.021, -0.031, 0.0044), 12)
    return [(body, tile), (pipe, surfaces.plain((226, 232, 236))),
            (bud, surfaces.plain((214, 222, 226)))]  # fmt: skip


DEFIBRILLATOR_BLACK = surfaces.plain((34, 34, 37))
WHITE = surfaces.plain((244, 243, 240))


@category("bedpan", size=(0.34, 0.27, 0.07), mass=0.35, material="ceramic", hollow=True,
          aliases=("bed pan",), themes=("lab",), roles=("big",), colors=("white",))  # fmt: skip
@from_pieces(bodies=(0, 2))
def bedpan(look: Look) -> Pieces:
    """A low, broad bedpan with a flat rim and a handle."""
    tile = plastic(look, "white", "gray", "sky", "silver")
    floor = at_block(0.22, 0.2, 0.01, 0.08)
    wall = lathe([(0.09, 0), (0.11, 0.06), (0.135, 0.066), (0.135, 0.07), (0.104, 0.068),
                  (0.084, 0.006)], 36, loop=True)  # fmt: skip
    grip = at_block(0.08, 0.05, 0.012, 0.018, (0.155, 0, 0.056))
    return [(floor, tile), (wall.scale(1.05, 1, 1), tile), (grip, tile)]


@category("ultrasound_probe", size=(0.2, 0.11, 0.036), mass=0.15, material="plastic",
          aliases=("ultrasound wand", "ultrasound transducer", "massage gun"), themes=("lab",),
          colors=("white",))  # fmt: skip
@from_pieces(foot=0.06, bodies=3)
def ultrasound_probe(look: Look) -> Pieces:
    """An ultrasound probe with its cord, lying flat."""
    shell = plastic(look, "white", "gray", "sky")
    body = rod([(-0.06, 0, 0.018), (0.0, 0, 0.018), (0.03, 0, 0.018)], [0.013, 0.017, 0.018], 14)
    head = ball(0.05, 0.066, 0.034, (0.045, 0, 0.0175), 18)
    tip = ball(0.02, 0.058, 0.026, (0.066, 0, 0.0175), 16)
    cord = rod([(-0.06, 0, 0.018), (-0.09, 0, 0.012), (-0.12, 0.03, 0.004), (-0.08, 0.07, 0.004),
                (0.0, 0.06, 0.004)], 0.0036, 8, 6)  # fmt: skip
    return [(body, shell), (head, shell), (tip, dye(look, "gray", "navy")),
            (cord, dye(look, "gray", "white"))]  # fmt: skip


@category("defibrillator", size=(0.22, 0.235, 0.082), mass=1.8, material="device",
          aliases=("aed", "aed device", "portable defibrillator"), themes=("lab",), roles=("big",),
          colors=("red", "yellow"))  # fmt: skip
@from_pieces(bodies=2)
def defibrillator(look: Look) -> Pieces:
    """A bright defibrillator case with a heart symbol, a screen, a big button and a handle."""
    shell = plastic(look, "red", "yellow", "orange", "green")
    body = at_block(0.22, 0.2, 0.075, 0.03)
    grip = rod([(-0.06, 0.09, 0.05), (-0.05, 0.125, 0.05), (0.05, 0.125, 0.05), (0.06, 0.09, 0.05)],
               0.01, 10)  # fmt: skip
    screen = prints.canvas(96, 56, (24, 40, 36))
    prints.stroke(screen, [(0, 0.5), (0.3, 0.5), (0.37, 0.2), (0.45, 0.85), (0.52, 0.5), (1, 0.5)],
                  0.05, (110, 240, 140))  # fmt: skip
    badge = prints.canvas(64, 64, (246, 246, 244))
    prints.disc(badge, 0.36, 0.38, 0.17, (206, 36, 40))
    prints.disc(badge, 0.64, 0.38, 0.17, (206, 36, 40))
    prints.polygon(badge, [(0.2, 0.45), (0.8, 0.45), (0.5, 0.85)], (206, 36, 40))
    prints.polygon(badge, [(0.55, 0.3), (0.4, 0.55), (0.5, 0.55), (0.45, 0.75), (0.62, 0.47),
                           (0.52, 0.47)], (250, 240, 120))  # fmt: skip
    knob = disc(0.018, 0.008, (0.06, -0.055, 0.074))
    return [(body, shell), (grip, DEFIBRILLATOR_BLACK), (knob, dye(look, "orange", "green")),
            (at_box(0.09, 0.055, 0.001, (-0.045, 0.04, 0.0746)), screen),
            (at_box(0.055, 0.055, 0.001, (0.06, 0.035, 0.0746)), badge)]  # fmt: skip


@category("nebuliser", size=(0.27, 0.16, 0.085), mass=1.2, material="device",
          aliases=("nebulizer", "inhalation device", "oxygen mask"), themes=("lab",),
          roles=("big",), colors=("white",))  # fmt: skip
@from_pieces(bodies=2)
def nebuliser(look: Look) -> Pieces:
    """A nebuliser: a small pump with a hose and a clear mask."""
    shell = plastic(look, "white", "sky", "gray")
    body = at_block(0.15, 0.12, 0.08, 0.03, (-0.04, 0, 0))
    vents = [at_box(0.05, 0.003, 0.001, (-0.05, 0.02 + 0.01 * k, 0.0796)) for k in range(4)]
    knob = disc(0.012, 0.006, (-0.03, -0.03, 0.0795))
    mask = (lathe([(0.012, 0.045), (0.03, 0.03), (0.042, 0.0), (0.039, 0.0), (0.027, 0.028),
                   (0.009, 0.042)], 26,
                  loop=True).scale(0.85, 1.1, 1).move(0.11, 0, 0))  # fmt: skip
    cup = disc(0.012, 0.03, (0.11, 0, 0.043))
    hose = rod([(0.035, 0.03, 0.03), (0.06, 0.08, 0.006), (0.13, 0.08, 0.006), (0.13, 0.02, 0.05),
                (0.115, 0, 0.06)], 0.003, 8, 6)  # fmt: skip
    return [(body, shell), (mask, surfaces.plain((196, 222, 226))),
            (cup, surfaces.plain((206, 226, 230))), (hose, surfaces.plain((206, 226, 230))),
            (join(vents), DEFIBRILLATOR_BLACK), (knob, dye(look, "green", "blue"))]  # fmt: skip


@category("ampoule", size=(0.061, 0.0116, 0.0116), mass=0.004, material="glass",
          aliases=("glass ampoule", "ampule", "ampul", "ammonia inhalant", "smelling salt ampoule"),
          themes=("lab",), colors=("amber",))  # fmt: skip
@from_pieces(foot=0.1)
def ampoule(look: Look) -> Pieces:
    """A glass ampoule lying flat: a body with a white and blue band, a neck and a narrow tip."""
    color = look.color("amber", "clear", "brown", "sky")
    body = spindle((-0.03, 0.0035), (-0.028, 0.0056), (0.008, 0.0056), (0.013, 0.0026),
                   (0.016, 0.0032), (0.026, 0.0028), (0.031, 0.0008), z=0.0056)  # fmt: skip
    band = spindle((-0.02, 0.0058), (0.0, 0.0058), z=0.0057)
    return [
        (body, surfaces.plain(color)),
        (band, surfaces.stripes([(246, 246, 244), (60, 110, 180)], 1, upright=True)),
    ]


@category("prosthetic_hand", size=(0.21, 0.13, 0.047), mass=0.35, material="plastic",
          aliases=("artificial hand", "hand model", "bionic hand"), themes=("lab",),
          colors=("black",))  # fmt: skip
@from_pieces(foot=0.06)
def prosthetic_hand(look: Look) -> Pieces:
    """An artificial hand with jointed fingers and a wrist ring, lying flat."""
    tile = plastic(look, "black", "gray", "beige", "silver", "white")
    palm = pad(0.085, 0.08, 0.03, 0.02)
    fingers = []
    for y, n in ((-0.03, 0.07), (-0.01, 0.085), (0.011, 0.08), (0.031, 0.062)):
        fingers.append(rod([(0.035, y, 0.016), (0.035 + 0.5 * n, 1.15 * y, 0.022),
                            (0.035 + n, 1.2 * y, 0.011)], [0.0095, 0.009, 0.0075], 10))  # fmt: skip
    thumb = rod([(-0.02, -0.035, 0.014), (0.01, -0.065, 0.016), (0.04, -0.075, 0.011)],
                [0.011, 0.01, 0.008], 10)  # fmt: skip
    wrist = spindle((-0.085, 0.026), (-0.035, 0.024), z=0.0225).scale(1, 1.15, 1)
    rings = [torus(0.0095, 0.0016, 14, 5).turn(1, np.pi / 2).move(0.07, 1.1 * y, 0.0195)
             for y in (-0.03, -0.01, 0.011, 0.031)]  # fmt: skip
    return [(palm, tile), (wrist, dye(look, "charcoal", "silver")), (thumb, tile),
            *((f, tile) for f in fingers), (join(rings), shine(look))]  # fmt: skip


@category("pacemaker", size=(0.1, 0.08, 0.0085), mass=0.03, material="metal",
          aliases=("heart pacemaker",), themes=("lab",), colors=("silver",))  # fmt: skip
@from_pieces()
def pacemaker(look: Look) -> Pieces:
    """A pacemaker: a flat, rounded metal case with a pale head and a thin, winding lead."""
    steel = shine(look, "silver", "gray")
    body = at_block(0.048, 0.042, 0.008, 0.019)
    head = at_block(0.04, 0.014, 0.0085, 0.006, (0, 0.024, 0))
    lead = rod([(0.012, 0.03, 0.004), (0.03, 0.05, 0.002), (0.06, 0.03, 0.002),
                (0.05, -0.02, 0.002), (0.075, -0.03, 0.002)], 0.0014, 6, 6)  # fmt: skip
    return [(body, steel), (head, surfaces.plain((190, 214, 222))),
            (lead, dye(look, "white", "gray"))]  # fmt: skip


@category("speculum", size=(0.15, 0.11, 0.042), mass=0.12, material="metal",
          aliases=("retractor", "surgical retractor", "vaginal speculum"), themes=("lab",),
          colors=("silver",))  # fmt: skip
@from_pieces(foot=0.05)
def speculum(look: Look) -> Pieces:
    """A steel or clear plastic speculum lying flat: two tapered blades, a handle and a screw."""
    tile = shine(look, "silver", "gray") if look.chance(0.6) else surfaces.plain((206, 224, 230))
    bills = [rod([(-0.02, 0, 0.02 + s * 0.004), (0.04, 0, 0.02 + s * 0.008),
                  (0.09, 0, 0.02 + s * 0.003)], [0.018, 0.014, 0.007], 12)
             for s in (-1, 1)]  # fmt: skip
    grip = [
        at_block(0.016, 0.02, 0.012, 0.004, (-0.03, 0, 0.006)),
        rod([(-0.03, 0, 0.012), (-0.045, -0.04, 0.008), (-0.05, -0.09, 0.007)], 0.007, 10),
    ]
    screw = straight((-0.03, -0.02, 0.012), (0.0, -0.03, 0.012), 0.003, 8)
    return [(bills[0], tile), (bills[1], tile), (grip[0], tile), (grip[1], tile),
            (screw, shine(look))]  # fmt: skip


@category("peak_flow_meter", size=(0.18, 0.04, 0.033), mass=0.08, material="plastic",
          aliases=("spirometer", "flow meter", "peak flow"), themes=("lab",),
          colors=("white",))  # fmt: skip
@from_pieces(bodies=2)
def peak_flow_meter(look: Look) -> Pieces:
    """A peak flow meter lying flat: a tube with a scale and a mouthpiece."""
    scale = prints.rule(8, (250, 250, 248), (30, 60, 140))
    body = at_block(0.15, 0.04, 0.03, 0.012)
    mouth = spindle((0.072, 0.0145), (0.105, 0.0145), z=0.0152)
    slider = at_box(0.006, 0.01, 0.003, (look.between(-0.03, 0.03), 0.0, 0.0296))
    return [(body, plastic(look, "white", "blue", "yellow")), (mouth, WHITE),
            (at_box(0.12, 0.026, 0.0006, (-0.005, 0, 0.0297)), scale),
            (slider, surfaces.plain((206, 40, 38)))]  # fmt: skip


TOURNIQUET_BLACK = surfaces.plain((34, 34, 37))
PILL_CUTTER_WHITE = surfaces.plain((244, 243, 240))


@category("spacer_device", size=(0.17, 0.059, 0.0575), mass=0.06, material="plastic",
          aliases=("inhaler spacer", "asthma spacer", "aerochamber"), themes=("lab",),
          colors=("clear",))  # fmt: skip
@from_pieces(foot=0.06)
def spacer_device(look: Look) -> Pieces:
    """A clear inhaler spacer lying flat, with a coloured end on the left and a ring."""
    body = spindle(
        (-0.07, 0.02), (-0.06, 0.028), (0.05, 0.028), (0.065, 0.018), (0.085, 0.014), z=0.028
    )
    back = spindle((-0.085, 0.014), (-0.068, 0.022), z=0.028)
    ring = spindle((0.048, 0.0295), (0.056, 0.0295), z=0.0285)
    return [(body, surfaces.plain(tint_color(look.color("clear", "sky"), 1.1))),
            (back, dye(look, "blue", "gray", "purple")),
            (ring, dye(look, "blue", "gray", "yellow"))]  # fmt: skip


@category("tourniquet", size=(0.165, 0.105, 0.042), mass=0.08, material="fabric",
          aliases=("combat tourniquet", "tourniquet strap"), themes=("lab",),
          colors=("black",))  # fmt: skip
@from_pieces(bodies=(0, 2, 3))
def tourniquet(look: Look) -> Pieces:
    """A tourniquet: a looped strap standing on its edge, with a black rod and a buckle in front."""
    color = look.color("black", "orange", "blue", "red")
    loop = lathe([(0.045, 0), (0.047, 0), (0.047, 0.036), (0.045, 0.036)], 40, loop=True)
    tail = at_box(0.12, 0.0025, 0.036, (0.06, -0.046, 0)).turn(2, 0.04)
    stick = straight((-0.04, -0.053, 0.018), (0.04, -0.053, 0.018), 0.0055, 10)
    buckle = at_block(0.02, 0.008, 0.042, 0.003, (0.052, -0.047, 0))
    return [(loop, surfaces.fabric(look.rng, color)), (tail, surfaces.fabric(look.rng, color)),
            (stick, TOURNIQUET_BLACK), (buckle, TOURNIQUET_BLACK)]  # fmt: skip


@category("ear_plug", size=(0.0245, 0.0132, 0.0128), mass=0.0006, material="fabric",
          aliases=("earplug", "foam ear plug", "foam earplug"), themes=("lab",),
          colors=("orange",))  # fmt: skip
@from_pieces(foot=0.1)
def ear_plug(look: Look) -> Pieces:
    """One soft ear plug, lying flat."""
    return [(spindle((-0.012, 0.006), (-0.011, 0.0066), (0.004, 0.0058), (0.011, 0.0038),
                     (0.0125, 0.002), z=0.0062), plastic(look, "orange", "yellow", "green",
                                                         "pink"))]  # fmt: skip


def _pack(text: tuple[str, ...], size: tuple[float, float, float], *colors: str) -> Drawing:
    """Return the drawing function of a soft, flat packet with a word on it."""

    def draw(look: Look) -> Pieces:
        x, y, h = size
        color = look.color(*colors)
        image = prints.canvas(128, round(128 * y / x), tint_color(color, 1.55))
        prints.fill(image, 0, 0, 1, 0.2, color)
        prints.fill(image, 0, 0.85, 1, 0.15, color)
        prints.write(
            image, look.pick(text), 0.5, 0.5, 0.24 * min(1, x / y), tint_color(color, 0.5), True
        )
        prints.lines(image, look.rng, (0.2, 0.66, 0.6, 0.1), 2, tint_color(color, 0.8))
        body = pad(x, y, h, 0.12 * min(x, y))
        rims = [at_box(0.06 * x, y, 0.0012, (s * 0.49 * x, 0, 0.4 * h)) for s in (-1, 1)]
        return [(body, image), (join(rims), surfaces.plain(tint_color(color, 1.2)))]

    return draw


@category("jade_roller", size=(0.168, 0.0529, 0.0308), mass=0.09, material="plastic",
          aliases=("face roller", "facial roller", "quartz roller", "gua sha"), themes=("lab",),
          colors=("sage", "pink"))  # fmt: skip
@from_pieces(foot=0.06, bodies=3)
def jade_roller(look: Look) -> Pieces:
    """A jade roller lying flat: a handle with a stone at each end."""
    color = look.color("sage", "pink", "green", "purple")
    stone = surfaces.marble(look.rng, color, tint_color(color, 1.5))
    z = 0.016
    grip = spindle((-0.05, 0.006), (0.05, 0.006), z=z)
    gold = [rod([(s * 0.05, 0, z), (s * 0.058, -0.024, z), (s * 0.075, -0.024, z)], 0.0018, 6)
            for s in (-1, 1)]  # fmt: skip
    gold += [rod([(s * 0.05, 0, z), (s * 0.058, 0.024, z), (s * 0.075, 0.024, z)], 0.0018, 6)
             for s in (-1, 1)]  # fmt: skip
    big = (spindle((-0.02, 0.01), (-0.012, 0.016), (0.012, 0.016), (0.02, 0.01),
                   z=z).turn(2, np.pi / 2).move(x=0.075))  # fmt: skip
    small = (spindle((-0.018, 0.005), (-0.01, 0.0085), (0.01, 0.0085), (0.018, 0.005),
                     z=z).turn(2, np.pi / 2).move(x=-0.075))  # fmt: skip
    return [(grip, stone), (big, stone), (small, stone),
            (join(gold), shine(look, "gold", "silver"))]  # fmt: skip


@category("toe_separator", size=(0.085, 0.036, 0.018), mass=0.006, material="fabric",
          aliases=("toe spacer", "toe separators", "pedicure separator"), themes=("lab",),
          colors=("pink",))  # fmt: skip
@from_pieces()
def toe_separator(look: Look) -> Pieces:
    """A toe separator: a soft bar with five rounded teeth at the back."""
    tile = plastic(look, "pink", "purple", "mint", "yellow")
    bar = at_block(0.085, 0.014, 0.018, 0.006)
    posts = [
        at_block(0.01, 0.034, 0.018, 0.0048, (-0.0375 + 0.01875 * k, 0.012, 0)) for k in range(5)
    ]
    return [(bar, tile), *((p, tile) for p in posts)]


@category("pill_cutter", size=(0.0755, 0.0483, 0.0502), mass=0.04, material="plastic",
          aliases=("pill splitter", "pill crusher", "tablet cutter"), themes=("lab",),
          colors=("sky",))  # fmt: skip
@from_pieces()
def pill_cutter(look: Look) -> Pieces:
    """A pill cutter: a box with a tablet and a pale wedge, and a blade under its raised lid."""
    tile = plastic(look, "sky", "clear", "pink", "green", "white")
    low, high = (at_block(0.075, 0.045, 0.016, 0.01),
                 at_block(0.075, 0.045, 0.01, 0.01).turn(0, 0.6).move(0, 0.008, 0.03))  # fmt: skip
    blade = at_box(0.05, 0.002, 0.014, (0, 0.004, 0.02)).turn(0, 0.0)
    slot = plate([(-0.02, -0.012), (0.02, -0.012), (0, 0.012)], 0.0006, 0.0157)
    half = disc(0.006, 0.004, (0, -0.006, 0.0155))
    return [(low, tile), (high, tile), (blade, shine(look)),
            (slot, surfaces.plain((200, 214, 222))), (half, PILL_CUTTER_WHITE)]  # fmt: skip


@category("false_eyelashes", size=(0.11, 0.045, 0.0075), mass=0.008, material="plastic",
          aliases=("false eyelash", "fake lashes", "eyelash extension", "lash tray",
          "false eyelashes case"), themes=("lab",), roles=("flat",), colors=("pink",))  # fmt: skip
@from_pieces(bodies=1)
def false_eyelashes(look: Look) -> Pieces:
    """A pair of false eyelashes in a small tray."""
    tray = at_block(0.11, 0.045, 0.006, 0.01)
    lines = []
    for s in (-1, 1):
        a = np.linspace(0.5, np.pi - 0.5, 15)
        lines.append(tube(np.column_stack([s * 0.027 + 0.019 * np.cos(a), 0.019 * np.sin(a) - 0.016,
                                           0 * a + 0.0068]), 0.0009, 5))  # fmt: skip
        lines += [straight((s * 0.027 + 0.019 * np.cos(t), 0.019 * np.sin(t) - 0.016, 0.0068),
                           (s * 0.027 + 0.028 * np.cos(t), 0.029 * np.sin(t) - 0.016, 0.0072),
                           0.0005, 4) for t in a]  # fmt: skip
    return [(tray, plastic(look, "pink", "white", "purple", "clear")),
            (join(lines), TOURNIQUET_BLACK)]  # fmt: skip


CATEGORIES = (
    Category("covid_test", vary(0.08)(from_pieces()(_cassette("cassette"))),
             size=(0.07, 0.02, 0.0053), mass=0.006, material="plastic",
             aliases=("lateral flow test", "rapid test", "antigen test", "covid test kit",
             "test cassette", "rapid antigen test"), themes=("lab",), roles=("flat",),
             colors=("white",)),
    Category("pregnancy_test", from_pieces(bodies=2)(_cassette("stick")),
             size=(0.134, 0.02, 0.0125), mass=0.012, material="plastic",
             aliases=("test stick", "ovulation test"), themes=("lab",), colors=("white",)),
    Category("cold_pack",
             from_pieces()(_pack(("COLD", "ICE PACK", "COOL"), (0.2, 0.13, 0.025), "sky", "blue")),
             size=(0.2, 0.125, 0.024), mass=0.4, material="plastic",
             aliases=("instant ice pack", "heat pack", "hot pack", "hot cold pack"),
             themes=("lab",), roles=("flat", "big"), colors=("blue",)),
    Category("wipe_packet", from_pieces()(_pack(("WIPE", "ALCOHOL", "STERILE"), (0.06, 0.05, 0.004),
             "sky", "green", "blue")), size=(0.0636, 0.05, 0.004), mass=0.003, material="plastic",
             aliases=("antiseptic wipe", "alcohol wipe", "alcohol pad", "whitener sachet", "condom",
             "gel sachet", "sample sachet", "condiment sachet", "antiseptic pad", "condom packet"),
             themes=("lab",), roles=("flat",), colors=("blue",)),
    Category("cleansing_wipes", from_pieces()(_pack(("WIPES", "CLEANSE", "BABY"), (0.18, 0.1, 0.05),
             "pink", "mint", "sky")), size=(0.19, 0.1, 0.05), mass=0.25, material="plastic",
             aliases=("cleansing wipe packet", "wet wipes pack", "makeup wipes"), themes=("lab",),
             colors=("pink",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
