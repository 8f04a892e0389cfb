"""Pictures of a scene: its meshes as render items, a camera that frames them, previews."""

from __future__ import annotations

import numpy as np

from ..geometry import Camera, framing_camera
from ..scene import Scene, View
from .raster import Item, Rendered, place, render

_UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])

TOP_DOWN = View(azimuth=0.0, elevation=np.pi / 2, fov=np.deg2rad(20.0))
"""A view from straight above, nearly without perspective."""


def scene_items(scene: Scene) -> list[Item]:
    """Return the table (id 0) and the objects (ids 1..n, in order) at their settled poses."""
    table = scene.table
    middle = np.array([0.0, 0.0, table.height / 2])
    items = [place(table.model.mesh, table.scale, middle, _UPRIGHT, 0)]
    for index, thing in enumerate(scene.objects, start=1):
        pose = thing.pose
        items.append(place(thing.model.mesh, thing.scale, pose.position, pose.quaternion, index))
    return items


def render_scene(
    scene: Scene,
    view: View | None = None,
    width: int = 960,
    height: int = 720,
    *,
    camera: Camera | None = None,
    supersample: int = 2,
) -> Rendered:
    """Draw a whole scene on white; ``view`` defaults to the scene's own, framed to fit.

    Ids: 0 the table, ``k`` the object ``scene.objects[k - 1]``, -1 nothing.
    """
    items = scene_items(scene)
    if camera is None:
        points = np.concatenate([item.vertices for item in items])
        camera = framing_camera(points, view or scene.view, width, height)
    return render(items, camera, supersample=supersample, ground_shadow=0.1)
