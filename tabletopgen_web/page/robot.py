"""A bundle's scene with the Panda, as a document that refers to the files of the bundle."""

from __future__ import annotations

import re

from generator.physics.mjcf import document
from generator.physics.spec import spec_of
from generator.scene import Scene, hold_supports
from tabletopgen_env.robot.mount import Mount
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.composition import compose
from tabletopgen_env.world.world import World

_FILE = re.compile(r'\bfile="([^"]+)"')

START = "home"
"""The keyframe at which episodes start: objects settled, arm at home."""


def robot_document(scene: Scene, files: frozenset[str]) -> str:
    """Return the MJCF of ``scene`` with the arm mounted as in the environments.

    It is the model that environments simulate, so recorded states match. It refers only to the
    files of the bundle, ``files``.

    Raises:
        SceneError: MuJoCo cannot compile the scene, or there is no mount for the arm.
    """
    scene = hold_supports(scene)
    mount = Mount.beside(scene)
    spec = compose(scene, Panda(), mount, spec_of(document(scene), scene.name))
    world = World(scene, Panda(), mount)
    world.reset()
    for key in list(spec.keys):
        spec.delete(key)
    spec.add_key(name=START, qpos=world.data.qpos, ctrl=world.data.ctrl)
    spec.compile()
    text = spec.to_xml()
    foreign = {named[1] for named in _FILE.finditer(text)} - files
    assert not foreign, f"files that are not in the bundle: {sorted(foreign)}"
    return text
