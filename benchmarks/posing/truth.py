"""Composed tables with a picture of each, as ground truth for scenes from pictures."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int, UInt8
from shapely.geometry import Polygon

from generator.composition import compose
from generator.errors import SceneError
from generator.evaluation.surfaces.symmetry import order, yaw_error
from generator.geometry import (
    Camera,
    convex_outline,
    framing_camera,
    quaternion_matrix,
    quaternion_yaw,
    rotation_z,
    turned_quaternion,
    wrap,
)
from generator.language.planner import plan_scene
from generator.language.themes import THEMES
from generator.render.raster import render
from generator.render.shading import Light
from generator.render.sheet import scene_items
from generator.scene import TABLE, Object, Pose, Scene, View

from .cases import STREAMS, VARIANTS
from .distinct import alike

WIDTH, HEIGHT = 960, 720
_TRIES = 20
_CLEAR = 0.01  # minimum gap between rotated objects, metres
_TILTED = np.deg2rad(5.0)


@dataclass(frozen=True, eq=False)
class Truth:
    """A scene, its picture, and each pixel's index (0 the table, k ``scene.objects[k - 1]``)."""

    text: str
    scene: Scene
    view: View
    camera: Camera
    light: Light
    picture: UInt8[np.ndarray, "h w 3"]
    ids: Int[np.ndarray, "h w"]


def draw_truth(split: str, seed: int, number: int, text: str = "") -> Truth:
    """Compose, rotate and draw scene ``number`` of a split: a theme's, or one of a given ``text``.

    Raises:
        SceneError: no scene can be composed, after many tries.
    """
    rng = np.random.default_rng([STREAMS[split], seed, number, 7])
    words = [theme.words[0] for theme in THEMES.values()]
    for _ in range(_TRIES):
        asked = text or f"a {words[int(rng.integers(len(words)))]}"
        variant = int(rng.integers(*VARIANTS[split]))
        try:
            scene = compose(plan_scene(asked, variant), variant)
        except SceneError:
            continue
        return photograph(asked, turned_about(scene, rng), rng)
    raise SceneError(f"No scene could be composed in {_TRIES} tries.")


def turned_about(scene: Scene, rng: np.random.Generator) -> Scene:
    """Return a scene with objects in random directions, since layouts turn most to the viewer.

    Objects that stand on the table, support nothing, and have space to rotate are rotated.
    """
    bearing = {o.placement.on for o in scene.objects}
    shapes = {o.name: _outline(o) for o in scene.objects}
    top = Polygon(scene.table.outline)
    objects = []
    for thing in scene.objects:
        angle = float(rng.uniform(-np.pi, np.pi))
        alone = thing.placement.on == TABLE and thing.name not in bearing
        turned = _turn(thing, angle)
        shape = _outline(turned)
        others = [s for name, s in shapes.items() if name != thing.name]
        free = top.contains(shape) and all(s.distance(shape) > _CLEAR for s in others)
        if alone and free:
            shapes[thing.name] = shape
            objects.append(turned)
        else:
            objects.append(thing)
    return scene.replace(objects=tuple(objects))


def _turn(thing: Object, angle: float) -> Object:
    """Return an object rotated about the vertical in place."""
    quaternion = turned_quaternion(thing.pose.quaternion, angle)
    placement = dataclasses.replace(thing.placement, yaw=wrap(thing.placement.yaw + angle))
    pose = Pose(thing.pose.position, quaternion / np.linalg.norm(quaternion))
    return dataclasses.replace(thing, placement=placement, pose=pose)


def _outline(thing: Object) -> Polygon:
    points = thing.model.mesh.vertices * thing.scale @ quaternion_matrix(thing.pose.quaternion).T
    return Polygon(convex_outline((points + thing.pose.position)[:, :2]))


def photograph(text: str, scene: Scene, rng: np.random.Generator) -> Truth:
    """Draw a scene on a light ground from the front above, slightly from the side."""
    view = View(
        float(np.deg2rad(rng.uniform(-25, 25))),
        float(np.deg2rad(rng.uniform(32, 60))),
        float(np.deg2rad(rng.uniform(30, 50))),
    )
    items = scene_items(scene)
    points = np.concatenate([item.vertices for item in items])
    camera = framing_camera(points, view, WIDTH, HEIGHT, margin=float(rng.uniform(0.02, 0.1)))
    light = Light(
        np.array([rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.2), 0.85]),
        sun=float(rng.uniform(0.25, 0.5)),
        sky=float(rng.uniform(0.55, 0.68)),
        tint=(1.0, float(rng.uniform(0.96, 1)), float(rng.uniform(0.92, 1))),
    )
    grey = int(rng.integers(215, 256))
    drawn = render(items, camera, light=light, background=(grey, grey, grey), ground_shadow=0.15)
    return Truth(text, scene, view, camera, light, drawn.image, drawn.ids)


def apart(truth: Truth, index: int, symmetry: float) -> float:
    """Return the difference to an object's most similar other side in the scene's picture.

    Pixels of other objects are ignored. See ``alike``.
    """
    thing = truth.scene.objects[index]
    model = dataclasses.replace(thing.model, size=thing.scale)
    front = (truth.ids > 0) & (truth.ids != index + 1)
    yaw = quaternion_yaw(thing.pose.quaternion)
    return alike(model, yaw, thing.pose.position, truth.camera, truth.light, front, symmetry)


# ----------------------------------------------------------------------- as the camera sees it


@dataclass(frozen=True, eq=False)
class SeenObject:
    """An object in its table's frame, rotated to the camera: +x right, +y away, metres, radians.

    ``place`` is relative to the table's centre, ``reach`` the square root of the product of its two
    longest sides. ``upright`` is true if it stands like its model.
    """

    place: Float[np.ndarray, "2"]
    yaw: float
    reach: float
    upright: bool


def see(thing: Object, azimuth: float) -> SeenObject:
    """Return an object in the frame of a camera with this azimuth (radians)."""
    place = rotation_z(-azimuth)[:2, :2] @ thing.pose.position[:2]
    turn = quaternion_matrix(thing.pose.quaternion)
    reach = float(np.sqrt(np.prod(np.sort(thing.scale)[1:])))
    upright = bool(np.arccos(np.clip(turn[2, 2], -1, 1)) < _TILTED)
    return SeenObject(place, wrap(quaternion_yaw(thing.pose.quaternion) - azimuth), reach, upright)


def azimuth_error(truth: Truth, azimuth: float) -> float | None:
    """Return the error of an azimuth (radians), degrees, modulo the table's own symmetry.

    None for a round table, which has no front.
    """
    table = truth.scene.table
    symmetry = order(table.model.mesh, np.asarray(table.scale), prints=False)
    if math.isinf(symmetry):
        return None
    return yaw_error(azimuth, truth.view.azimuth, symmetry)


def table_width(scene: Scene, azimuth: float) -> float:
    """Return the width of a scene's tabletop from left to right in the camera's frame, metres."""
    outline = scene.table.outline @ rotation_z(-azimuth)[:2, :2].T
    return float(np.ptp(outline[:, 0]))
