"""The reference image of a plan (Sec. 3, Fig. 8), rendered from catalogue objects.

The backend returns only pixels (``draw``): later stages see no more of the layout than in any other
picture. ``paint`` also returns the pixels of each object, for measuring the accuracy of detections.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import UInt8

from ...geometry import framing_camera, yaw_quaternion
from ...layout import build_models, lay_out
from ...render.raster import Rendered, place, render
from ...render.shading import Light
from ...scene import ScenePlan, View

WIDTH, HEIGHT = 960, 720
"""Size of a painted picture in pixels."""

ELEVATIONS = (50.0, 60.0)
"""Minimum and maximum camera elevation in degrees, as in the paper's prompt."""


def draw(plan: ScenePlan, seed: int) -> UInt8[np.ndarray, "h w 3"]:
    """Render a plan: the whole table with its legs, centred on white, seen from above and in front.

    Raises:
        SceneError: the objects fit on no plausible table.
    """
    return paint(plan, seed)[0].image


def paint(plan: ScenePlan, seed: int) -> tuple[Rendered, tuple[str, ...]]:
    """Return the rendering of ``draw`` with its depths and ids, and the names of the objects.

    The table has id 0, the first name id 1.

    Raises:
        SceneError: the objects fit on no plausible table.
    """
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 17])
    # with the objects' looks as in a composed scene, but other positions
    models = build_models(plan, seed)
    layout, table = lay_out(plan, models, seed + 1)
    center = np.array([0.0, 0.0, float(table.size[2]) / 2])
    upright = yaw_quaternion(0.0)
    items = [place(table.mesh, table.size, center, upright, 0)]
    items += [
        place(models[p.name].mesh, p.scale, p.translation, yaw_quaternion(p.yaw), number)
        for number, p in enumerate(layout.placements, start=1)
    ]
    view = View(0.0, np.deg2rad(rng.uniform(*ELEVATIONS)), np.deg2rad(rng.uniform(35, 40)))
    points = np.concatenate([item.vertices for item in items])
    camera = framing_camera(points, view, WIDTH, HEIGHT, margin=0.05)
    painted = render(items, camera, light=_light(rng), supersample=2)
    return painted, tuple(p.name for p in layout.placements)


def _light(rng: np.random.Generator) -> Light:
    """Return a soft light that varies slightly between pictures."""
    direction = np.array([rng.uniform(-0.5, 0.3), rng.uniform(-0.55, -0.25), 0.85])
    warm = rng.uniform(-0.015, 0.025)
    return Light(
        direction,
        sun=float(rng.uniform(0.32, 0.42)),
        sky=float(rng.uniform(0.58, 0.65)),
        softness=float(rng.uniform(0.016, 0.03)),
        tint=(1.0 + warm, 1.0, 1.0 - warm),
    )
