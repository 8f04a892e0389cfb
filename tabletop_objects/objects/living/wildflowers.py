"""Objects of the ``living`` theme: wildflowers."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.primitives import ball, rod
from ...kit.shapes import Category, Pieces, vary
from ...kit.solids import ellipsoid, join, lathe
from ...kit.surfaces import RGB, Look
from .flowers import cluster, corolla, layered_head, on_stem, open_head, spike

GREEN: RGB = (84, 126, 64)


def thistle(look: Look, color: RGB) -> Pieces:
    """Return a thistle head: a spiny green ball with a purple tuft."""
    burr = ellipsoid(0.022, 0.022, 0.024, 12, 8).move(z=0.006)
    spines = [rod([(0.008 * np.cos(2.4 * k), 0.008 * np.sin(2.4 * k), 0.0012 * k - 0.004),
                   (0.017 * np.cos(2.4 * k), 0.017 * np.sin(2.4 * k), 0.0012 * k)],
                  [0.0014, 0.0004], 4, 1) for k in range(18)]  # fmt: skip
    tuft = [rod([(0, 0, 0.014), (0.012 * np.sqrt((k + 1) / 30) * np.cos(2.4 * k),
                 0.012 * np.sqrt((k + 1) / 30) * np.sin(2.4 * k), 0.034)], [0.0016, 0.001], 4, 1)
            for k in range(30)]  # fmt: skip
    return [(join([burr, *spines]), surfaces.plain((104, 132, 86))),
            (join(tuft), surfaces.speckles(look.rng, color, 12))]  # fmt: skip


def snowdrop(look: Look, color: RGB) -> Pieces:
    """Return a snowdrop head: three white petals around a small cup, hanging from a green knob."""
    outer = corolla(3, 0.024, 0.012, 1.15)
    inner = lathe([(0, 0.002), (0.005, 0.006), (0.0055, 0.014), (0, 0.013)], 8)
    return [(join(outer), surfaces.speckles(look.rng, color, 4)),
            (inner, surfaces.plain((214, 232, 196))),
            (ball(0.008, 0.008, 0.009, (0, 0, -0.001), 8), surfaces.plain(GREEN))]  # fmt: skip


DARK = (34, 26, 40)
_DANDELION = layered_head([(22, 0.02, 0.0045, 0.05, 0), (20, 0.018, 0.0045, 0.45, 0.001),
                      (14, 0.014, 0.004, 0.85, 0.002)], 0.005, None, 0.06)  # fmt: skip
_CORNFLOWER = layered_head([(11, 0.025, 0.009, 0.2, 0), (9, 0.018, 0.006, 0.6, 0.001)], 0.006,
                      (70, 40, 120), 0.1)  # fmt: skip
_EDELWEISS = layered_head([(9, 0.024, 0.008, 0.05, 0), (6, 0.016, 0.007, 0.2, 0.002)], 0.007,
                     (214, 196, 100), 0.03)  # fmt: skip
_BLADE = (0.11, 0.011)


CATEGORIES = (
    Category("poppy", on_stem(open_head(5, 0.034, 0.034, 0.35, 0.0075, DARK), ("red", "red",
             "orange", "coral"), 0.19, leaves=1, nod=1.1, leaf=(0.06, 0.018)),
             size=(0.2, 0.0699, 0.0346), mass=0.008, material="food", assembled=True,
             aliases=("poppies", "red poppy", "poppy flower", "remembrance poppy"),
             themes=("living",), colors=("red", "red"), state="lying flat"),
    Category("dandelion", vary()(on_stem(_DANDELION, ("yellow", "gold"), 0.16, leaves=1, nod=0.9,
             leaf=(0.06, 0.014))), size=(0.169, 0.0495, 0.0328), mass=0.006, material="food",
             assembled=True, aliases=("dandelion flower",), themes=("living",),
             colors=("yellow", "gold"), state="lying flat"),
    Category("cornflower", on_stem(_CORNFLOWER, ("blue", "indigo", "blue"), 0.18, leaves=2, nod=0.9,
             leaf=(0.06, 0.006)), size=(0.188, 0.0558, 0.0343), mass=0.006, material="food",
             assembled=True, aliases=("knapweed", "bachelor's button"), themes=("living",),
             colors=("blue", "indigo"), state="lying flat"),
    Category("edelweiss", vary()(on_stem(_EDELWEISS, ("white", "ivory"), 0.12, leaves=2, nod=1.05,
             leaf=(0.04, 0.008))), size=(0.163, 0.0543, 0.0266), mass=0.006, material="food",
             assembled=True, aliases=("edelweiss flower",), themes=("living",),
             colors=("white", "ivory"), state="lying flat"),
    Category("primrose", vary()(on_stem(open_head(5, 0.02, 0.018, 0.1, 0.004, (240, 180, 40),
             (246, 214, 80)), ("yellow", "pink", "purple", "white"), 0.12, leaves=2, nod=1.1,
             leaf=(0.06, 0.028))), size=(0.159, 0.0487, 0.0199), mass=0.006, material="food",
             assembled=True, aliases=("primula", "buttercup", "cowslip", "oxlip"),
             themes=("living",), colors=("yellow", "pink"), state="lying flat"),
    Category("forget_me_not", vary()(on_stem(cluster(18, 0.015, 0.012, (250, 220, 80)), ("sky",
             "sky", "blue"), 0.12, leaves=2, nod=0.4, leaf=(0.04, 0.01))),
             size=(0.166, 0.0406, 0.0377), mass=0.004, material="food", assembled=True,
             aliases=("forget-me-not", "statice", "statice bunch", "baby's breath", "gypsophila"),
             themes=("living",), colors=("sky", "sky"), state="lying flat"),
    Category("foxglove", on_stem(spike(18, 0.12, 0.024, 0.0115, 2.2), ("purple", "pink", "magenta",
             "white"), 0.17, leaves=2, nod=0.06, leaf=(0.08, 0.03)), size=(0.3, 0.0726, 0.0761),
             mass=0.02, material="food", assembled=True,
             aliases=("foxglove flower", "penstemon", "snapdragon"), themes=("living",),
             colors=("purple", "pink"), state="lying flat"),
    Category("bluebell", vary()(on_stem(spike(10, 0.07, 0.018, 0.009, 2.5, one_side=True),
             ("indigo", "blue", "violet"), 0.15, leaves=2, nod=0.2, leaf=_BLADE)),
             size=(0.232, 0.0562, 0.0327), mass=0.006, material="food", assembled=True,
             aliases=("bluebell flower", "harebell", "lily of the valley"), themes=("living",),
             colors=("indigo", "blue"), state="lying flat"),
    Category("snowdrop", vary()(on_stem(snowdrop, ("white", "white", "ivory"), 0.11, leaves=2,
             nod=-0.5, leaf=(0.07, 0.006))), size=(0.168, 0.0398, 0.0234), mass=0.003,
             material="food", assembled=True, aliases=("snowdrop flower",), themes=("living",),
             colors=("white", "white"), state="lying flat"),
    Category("thistle", on_stem(thistle, ("purple", "magenta", "violet"), 0.17, leaves=2, nod=0.2,
             leaf=(0.07, 0.014)), size=(0.19, 0.0483, 0.0404), mass=0.01, material="food",
             assembled=True, aliases=("scottish thistle", "thistle head", "sea holly"),
             themes=("living",), colors=("purple", "magenta"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
