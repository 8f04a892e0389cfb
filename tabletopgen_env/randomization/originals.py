"""The state of a compiled world before randomisation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Shaped

if TYPE_CHECKING:
    from generator.scene import Scene

    from ..robot.mount import Mount
    from ..world.world import World

_ARRAYS = (
    # looks
    "light_dir", "light_diffuse", "cam_pos", "cam_quat", "cam_fovy", "mat_rgba",
    # masses, and values that mj_setConst derives from them and from poses
    "body_mass", "body_inertia", "body_subtreemass", "body_invweight0", "dof_invweight0",
    "dof_M0", "dof_length", "tendon_invweight0", "actuator_acc0",
    "cam_poscom0", "cam_pos0", "cam_mat0", "light_poscom0", "light_pos0", "light_dir0",
    # friction, servos
    "geom_friction", "actuator_gainprm", "actuator_biasprm",
    # the base and its pedestal
    "body_pos", "geom_pos", "geom_size", "geom_aabb", "geom_rbound", "bvh_aabb",
    # removed objects
    "geom_contype", "geom_conaffinity", "body_gravcomp",
)  # fmt: skip
_HEADLIGHT = ("ambient", "diffuse")


@dataclass(frozen=True, eq=False)
class Originals:
    """The parts of a world that randomisation may change."""

    arrays: Mapping[str, Shaped[np.ndarray, "..."]]
    headlight: Mapping[str, Shaped[np.ndarray, "3"]]
    scene: Scene
    mount: Mount

    @classmethod
    def of(cls, world: World) -> Originals:
        """Return copies of the current values in ``world``."""
        model, light = world.model, world.model.vis.headlight
        return cls(
            {name: getattr(model, name).copy() for name in _ARRAYS},
            {name: getattr(light, name).copy() for name in _HEADLIGHT},
            world.scene,
            world.mount,
        )

    def restore(self, world: World) -> None:
        """Restore the original values of the world, bit for bit."""
        model = world.model
        for name, array in self.arrays.items():
            getattr(model, name)[:] = array
        for name, array in self.headlight.items():
            getattr(model.vis.headlight, name)[:] = array
        world.absent = frozenset()
        if world.scene is not self.scene:
            world.rearrange(self.scene)
        if world.mount is not self.mount:
            world.seat(self.mount)
