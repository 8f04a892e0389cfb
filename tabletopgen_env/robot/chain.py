"""Forward kinematics of the arm in MuJoCo: frames and Jacobian, computed in microseconds.

The chain consists of the modified Denavit-Hartenberg transforms (Craig's convention)
``Rot_x(alpha) Trans_x(a) Rot_z(q) Trans_z(d)`` of ``franka.JOINTS``, in the frame of the base.
"""

from __future__ import annotations

import threading
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.physics.spec import new_data

from . import franka

if TYPE_CHECKING:
    import mujoco


class Chain:
    """The kinematic chain at given joints. Results are views that the next ``move`` overwrites."""

    def __init__(self) -> None:
        self._model = _chain_model()
        self._data = data = new_data(self._model)
        self._jacobian = np.zeros((6, 7))
        self.tool = data.site_xpos[0]
        self.hand = data.site_xmat[0].reshape(3, 3)
        self.links = data.xpos[1:]
        self.turns = data.xmat[1:].reshape(7, 3, 3)

    def move(self, joints: Float[np.ndarray, "7"]) -> None:
        """Update ``tool``, ``hand`` (a rotation), ``links`` and ``turns`` for ``joints``."""
        import mujoco

        self._data.qpos[:] = joints
        mujoco.mj_kinematics(self._model, self._data)

    def jacobian(self) -> Float[np.ndarray, "6 7"]:
        """Return the geometric Jacobian of the tool centre point, with the linear rows first."""
        import mujoco

        full = self._jacobian
        mujoco.mj_comPos(self._model, self._data)
        mujoco.mj_jacSite(self._model, self._data, full[:3], full[3:], 0)
        return full


def chain_at(joints: Float[np.ndarray, "7"]) -> Chain:
    """Return the chain of the current thread, moved to ``joints`` (rad)."""
    try:
        chain: Chain = _OF_THREAD.chain
    except AttributeError:
        chain = _OF_THREAD.chain = Chain()
    chain.move(joints)
    return chain


_OF_THREAD = threading.local()  # working memory, not state


@cache
def _chain_model() -> mujoco.MjModel:
    import mujoco

    spec = mujoco.MjSpec()
    body = spec.worldbody
    for joint in franka.JOINTS:
        body = body.add_body(
            pos=joint.place,
            quat=joint.turn,
            explicitinertial=True,
            mass=1.0,
            inertia=[1.0, 1.0, 1.0],
        )
        body.add_joint(axis=[0, 0, 1])
    half = franka.HAND_YAW / 2
    body.add_site(pos=[0, 0, franka.FLANGE + franka.TCP], quat=[np.cos(half), 0, 0, np.sin(half)])
    return spec.compile()
