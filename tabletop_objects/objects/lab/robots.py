"""Objects of the ``lab`` theme: robots."""

from __future__ import annotations

from ...kit import prints, surfaces
from ...kit.materials import DARK, steel
from ...kit.primitives import at_box, drum, rod
from ...kit.shapes import Shape, category, put_down
from ...kit.solids import block, join
from ...kit.surfaces import Look, plain, tint_color


@category("gripper", size=(0.173, 0.124, 0.067), mass=0.6, material="metal", assembled=True,
          aliases=("robot gripper", "robot hand", "gripper finger", "parallel gripper",
          "robotic gripper", "robotic hand"), themes=("lab", "workbench"), roles=("big",),
          colors=("white", "black"))  # fmt: skip
def gripper(look: Look) -> Shape:
    """A parallel gripper lying flat: a flange, a body and two fingers with pads."""
    color = look.color("white", "black", "silver", "orange", "blue")
    k, open_ = look.between(0.85, 1.15), look.between(0.02, 0.04)
    flange = drum(0.032, 0.012, (-0.07, 0, 0.033), 0, sides=24)
    body = block(0.075, 0.075, 0.05, 0.01, 0.005).move(-0.022, 0, 0.008)
    rail = at_box(0.016, 0.12, 0.026, (0.022, 0, 0.02))
    fingers = [at_box(0.075, 0.014, 0.03, (0.06, s * (open_ + 0.007), 0.018)) for s in (-1, 1)]
    pads = [at_box(0.03, 0.004, 0.026, (0.08, s * (open_ - 0.001), 0.02)) for s in (-1, 1)]
    foot = at_box(0.06, 0.06, 0.01, (-0.02, 0, 0))
    light = drum(0.006, 0.002, (-0.03, 0, 0.057))
    return put_down([(join([body, foot]), surfaces.speckles(look.rng, color, 4)),
                     (join([flange, rail, *fingers]), steel(look)), (join(pads), plain(DARK)),
                     (light, plain((80, 200, 240)))], foot, body, rail, flange, *fingers,
                    factor=k)  # fmt: skip


@category("robot_arm", size=(0.179, 0.123, 0.237), mass=1.5, material="plastic", assembled=True,
          aliases=("robotic arm", "hydraulic arm kit", "toy robot arm", "arm robot"),
          themes=("lab", "workbench"), roles=("tall", "big"),
          colors=("white", "orange"))  # fmt: skip
def robot_arm(look: Look) -> Shape:
    """A small jointed robot arm on a base, with a gripper at its end."""
    color = look.color("white", "orange", "blue", "yellow", "gray")
    k = look.between(0.85, 1.1)
    base = [drum(0.06, 0.018, bevel=0.003), drum(0.042, 0.05, (0, 0, 0.016), top=0.036)]
    low = rod([(0, 0, 0.08), (0.0, 0.0, 0.11), (-0.035, 0, 0.19)], [0.022, 0.02, 0.018], 12)
    high = rod([(-0.035, 0, 0.19), (0.03, 0, 0.215), (0.09, 0, 0.2)], [0.018, 0.016, 0.014], 12)
    last = rod([(0.09, 0, 0.2), (0.1, 0, 0.17), (0.1, 0, 0.145)], [0.014, 0.013, 0.013], 12)
    joints = [drum(r, 0.062 - 0.006 * n, (x, -0.031 + 0.003 * n, z), 1, sides=20) for n,
              (x, z, r) in enumerate(((0, 0.085, 0.028), (-0.035, 0.19, 0.024),
                                      (0.09, 0.2, 0.019)))]  # fmt: skip
    palm = at_box(0.02, 0.06, 0.014, (0.1, 0, 0.132))
    claws = [at_box(0.012, 0.008, 0.04, (0.1, s * 0.022, 0.094)) for s in (-1, 1)]
    tone = look.own_color("charcoal", "black", "navy", "teal")
    return put_down([(join([*base, low, high, last]), surfaces.speckles(look.rng, color, 3)),
                     (join(joints), plain(tone)), (join([palm, *claws]), steel(look))], *base, low,
                    high, join([last, palm]), *claws, factor=k)  # fmt: skip


@category("calibration_board", size=(0.205, 0.146, 0.00683), mass=0.2, material="plastic",
          aliases=("calibration target", "checkerboard target", "apriltag board", "aruco marker",
          "aruco board", "apriltag", "calibration pattern", "charuco board", "aruco tag"),
          themes=("lab",), roles=("flat", "big"), colors=("white",))  # fmt: skip
def calibration_board(look: Look) -> Shape:
    """A flat board with a checkerboard pattern or with square black markers."""
    color = look.color("white", "white", "cream")
    x, y = look.between(0.18, 0.24), look.between(0.13, 0.17)
    image = prints.canvas(192, 144, color)
    ink = (24, 24, 28)
    if look.chance(0.5):
        for row in range(7):
            for n in range(10):
                if (row + n) % 2 == 0:
                    prints.fill(image, 0.06 + 0.088 * n, 0.06 + 0.126 * row, 0.088, 0.126, ink)
    else:
        for row in range(3):
            for n in range(4):
                u, v = 0.05 + 0.238 * n, 0.06 + 0.31 * row
                prints.fill(image, u, v, 0.19, 0.253, ink)
                for i in range(4):
                    for j in range(4):
                        if look.chance(0.5):
                            place = u + 0.032 + 0.0317 * i, v + 0.042 + 0.0422 * j
                            prints.fill(image, *place, 0.0317, 0.0422, color)
    board = block(x, y, look.between(0.004, 0.008), 0.003)
    top = float(board.bounds[1, 2])
    sheet = at_box(0.97 * x, 0.96 * y, 0.0008, (0, 0, top - 0.0003))
    edge = look.own_color("gray", "black", "silver", "tan")
    return put_down([(board, plain(edge)), (sheet, image)], board)


@category("task_board", size=(0.242, 0.171, 0.0507), mass=0.9, material="plastic",
          aliases=("robot task board", "assembly task board", "knob panel", "control panel",
          "busy board", "button panel"), themes=("lab", "workbench"), roles=("big",),
          colors=("white", "gray"))  # fmt: skip
def task_board(look: Look) -> Shape:
    """A test board: a panel with a button, a slider, a knob, a door and a plugged-in cable."""
    color = look.color("white", "gray", "charcoal", "sky")
    k = look.between(0.85, 1.1)
    board = block(0.24, 0.17, 0.03, 0.006, 0.003)
    buttons = [drum(0.012, 0.008, (-0.09 + 0.035 * n, 0.055, 0.029), bevel=0.002) for n in (0, 1)]
    slot = at_box(0.1, 0.008, 0.0008, (0.045, 0.055, 0.0296))
    slider = at_box(0.014, 0.022, 0.014, (0.02 + look.between(0, 0.05), 0.055, 0.029))
    knob = drum(0.017, 0.016, (-0.08, 0.0, 0.029), top=0.014)
    door = at_box(0.07, 0.05, 0.005, (0.02, -0.005, 0.0295))
    handle = at_box(0.03, 0.006, 0.008, (0.02, -0.02, 0.034))
    sockets = [at_box(0.022, 0.022, 0.008, (x, -0.055, 0.0295)) for x in (-0.09, 0.09)]
    cable = rod([(-0.09, -0.055, 0.036), (-0.04, -0.06, 0.046), (0.04, -0.052, 0.046),
                 (0.09, -0.055, 0.036)], 0.003, 8)  # fmt: skip
    screen = at_box(0.05, 0.03, 0.002, (0.088, 0.01, 0.0292))
    return put_down([(board, surfaces.speckles(look.rng, color, 3)),
                     (buttons[0], plain((206, 50, 46))), (buttons[1], plain((50, 100, 190))),
                     (join([slot, *sockets]), plain(DARK)),
                     (join([slider, knob]), plain((240, 180, 50))),
                     (door, plain(tint_color(color, 0.75))),
                     (join([handle, cable]), plain((60, 62, 68))), (screen, plain((40, 110, 90)))],
                    board, knob, *buttons, join([door, handle]), cable, factor=k)  # fmt: skip
