"""A scene with its picture, and the same scene with deliberate faults."""

import dataclasses
from dataclasses import dataclass

import numpy as np
from jaxtyping import UInt8
from toy import toy_object, toy_scene

from generator.bundle import Segments
from generator.geometry import Camera, yaw_quaternion
from generator.render.sheet import render_scene
from generator.scene import TABLE, Object, Pose, Scene, View

FOUR = {"can_1": "overlap", "bottle_1": "float", "mug_1": "shrink", "strut_1": "turn"}
"""What is spoiled in ``spoiled_four_ways``, and how."""

VIEW = View(azimuth=0.2, elevation=0.8, fov=0.6)


@dataclass(frozen=True, eq=False)
class Shot:
    """A valid scene, its camera's picture, and the masks of its objects."""

    scene: Scene
    picture: UInt8[np.ndarray, "h w 3"]
    segments: Segments


def sound() -> Scene:
    """Return a scene with a mug, a can, a bottle, a long bar and a wide box, well apart."""
    things = (
        toy_object("mug_1", (0.09, 0.09, 0.095), (-0.3, 0.05), wall=0.006, mass=0.3),
        toy_object("can_1", (0.066, 0.066, 0.12), (0.1, 0.12), mass=0.3, kind="cylinder"),
        toy_object("bottle_1", (0.075, 0.075, 0.24), (-0.15, 0.15), mass=0.4, kind="cylinder"),
        toy_object("strut_1", (0.22, 0.04, 0.04), (0.0, -0.15), yaw=0.4, color=(40, 90, 160)),
        toy_object("box_1", (0.2, 0.14, 0.1), (0.4, 0.05), mass=2.0, color=(90, 110, 140)),
    )
    return toy_scene(things, name="sound").replace(view=VIEW)


def shot(scene: Scene) -> Shot:
    """Return the scene's picture, with the masks of its objects."""
    camera = Camera.looking_at(np.array([0.05, -0.02, 0.72]), VIEW, 1.9, 480, 360)
    drawn = render_scene(scene, camera=camera, supersample=1)
    names = (TABLE, *(thing.name for thing in scene.objects))
    labels = (TABLE, *(thing.label for thing in scene.objects))
    index = (np.asarray(drawn.ids) + 1).astype(np.uint8)
    return Shot(scene, np.asarray(drawn.image), Segments(names, labels, index))


def spoiled(scene: Scene, name: str, change: str) -> Scene:
    """Damage one object: overlap, float, hang, sink, shrink, turn, lift or remove it."""
    thing = scene.object(name)
    if change == "lose":
        return scene.replace(objects=tuple(o for o in scene.objects if o.name != name))
    objects = [_changed(thing, scene, change) if o is thing else o for o in scene.objects]
    return scene.replace(objects=tuple(objects))


def spoiled_four_ways() -> Scene:
    """Return the valid scene with an overlapping, a floating, a shrunken and a turned object."""
    scene = sound()
    for name, change in FOUR.items():
        scene = spoiled(scene, name, change)
    return scene.replace(name="spoiled")


def _changed(thing: Object, scene: Scene, change: str) -> Object:
    position, yaw = thing.pose.position.copy(), thing.placement.yaw
    if change == "shrink":
        extent = 0.45 * thing.scale
        small = toy_object(
            thing.name, tuple(extent), tuple(position[:2]), yaw=yaw, kind=thing.parts[0].kind
        )
        return dataclasses.replace(small, model=thing.model)
    if change == "turn":
        return dataclasses.replace(thing, pose=Pose(position, yaw_quaternion(yaw + np.pi / 2)))
    if change == "overlap":  # 3 mm into the box's side
        box = scene.object("box_1")
        position[:2] = box.pose.position[:2] - [(box.scale[0] + thing.scale[0]) / 2 - 3e-3, 0]
    moves = {"float": [0, 0, 0.02], "sink": [0, 0, -0.004], "hang": [0, 0.6, 0], "overlap": 0}
    return dataclasses.replace(
        thing, pose=Pose(position + np.array(moves[change]), thing.pose.quaternion)
    )
