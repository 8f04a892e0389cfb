"""The state of a batch as torch tensors on its device."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from .union.template import Addresses

POSES = ("xpos", "xquat", "xmat", "site_xpos", "site_xmat")
"""Arrays computed from the joints."""

ARRAYS = (
    *POSES, "qpos", "qvel", "ctrl", "mocap_pos", "geom_xpos", "geom_xmat", "overflow", "nacon",
    "contact.geom", "contact.worldid",
)  # fmt: skip
"""The simulator's arrays that a batch reads and writes."""

FACTS = ("filled", "half_extent", "table", "yaw")
"""Arrays of a ``SceneBank`` with one row per scene."""


@dataclass(frozen=True, eq=False)
class BatchState:
    """The current state of the worlds in the base frame (metres, radians, seconds; float32).

    The first axis is the world (w); s is the slot. All but the last group are views of the
    simulator's arrays: a step changes them, and writing ``qpos``, ``qvel`` or ``marker`` changes
    the worlds. Poses (of bodies, sites, slots and tool) lag ``qpos`` by one simulation step, as
    MuJoCo's do after ``mj_step``; right after ``BatchWorld.load`` they agree. Empty slots are
    parked out of reach.

    Attributes:
        qpos, qvel: positions and velocities of all joints, in the order of the union model.
        xpos, xmat: position and rotation of every body; site_xpos, site_xmat: of every site.
        ctrl: commands of seven servos (rad) and of the gripper (0 closed, 255 open).
        arm_qpos, arm_qvel: the seven joints.
        finger_qpos: the two finger slides.
        slot_qpos: position and quaternion (wxyz) of each object.
        slot_qvel: linear velocity of each object, and angular velocity in its own frame.
        slot_pos, slot_mat: centre of each object's box, and rotation from body to base.
        tcp_pos, tcp_mat: the tool centre point, and the hand's rotation.
        marker: position of the goal marker, which is only rendered; loading a scene hides it.
        touches: whether the left finger, the right finger, or any part of the robot touched each
            object in the last step; False after a scene is loaded.
        scene: index of each world's scene in the bank.
        filled, half_extent, table, yaw: see ``SceneBank``.
    """

    qpos: Float[Tensor, "w nq"]
    qvel: Float[Tensor, "w nv"]
    xpos: Float[Tensor, "w nbody 3"]
    xmat: Float[Tensor, "w nbody 3 3"]
    site_xpos: Float[Tensor, "w nsite 3"]
    site_xmat: Float[Tensor, "w nsite 3 3"]
    ctrl: Float[Tensor, "w 8"]
    arm_qpos: Float[Tensor, "w 7"]
    arm_qvel: Float[Tensor, "w 7"]
    finger_qpos: Float[Tensor, "w 2"]
    slot_qpos: Float[Tensor, "w s 7"]
    slot_qvel: Float[Tensor, "w s 6"]
    slot_pos: Float[Tensor, "w s 3"]
    slot_mat: Float[Tensor, "w s 3 3"]
    tcp_pos: Float[Tensor, "w 3"]
    tcp_mat: Float[Tensor, "w 3 3"]
    marker: Float[Tensor, "w 3"]
    touches: Bool[Tensor, "w s 3"]
    scene: Int[Tensor, "w"]
    filled: Bool[Tensor, "w s"]
    half_extent: Float[Tensor, "w s 3"]
    table: Float[Tensor, "w 3"]
    yaw: Float[Tensor, "w"]

    @classmethod
    def of(cls, arrays: Mapping[str, Tensor], at: Addresses, worlds: int) -> BatchState:
        """Return a state with views of a simulator's arrays, and zeros for the bank's fields."""
        qpos, qvel = arrays["qpos"], arrays["qvel"]
        slots = at.slot_bodies.stop - at.slot_bodies.start

        def empty(*shape: int, of: torch.dtype = torch.float32) -> Tensor:
            return torch.zeros(worlds, *shape, dtype=of, device=qpos.device)

        return cls(
            qpos=qpos,
            qvel=qvel,
            **{name: arrays[name] for name in ("xpos", "xmat", "site_xpos", "site_xmat")},
            ctrl=arrays["ctrl"],
            arm_qpos=qpos[:, at.arm_qpos],
            arm_qvel=qvel[:, at.arm_dof],
            finger_qpos=qpos[:, at.finger_qpos],
            slot_qpos=qpos[:, at.slot_qpos].unflatten(1, (slots, 7)),
            slot_qvel=qvel[:, at.slot_dof].unflatten(1, (slots, 6)),
            slot_pos=arrays["xpos"][:, at.slot_bodies],
            slot_mat=arrays["xmat"][:, at.slot_bodies],
            tcp_pos=arrays["site_xpos"][:, at.tcp],
            tcp_mat=arrays["site_xmat"][:, at.tcp],
            marker=arrays["mocap_pos"][:, 0],
            touches=empty(slots, 3, of=torch.bool),
            scene=empty(of=torch.long),
            filled=empty(slots, of=torch.bool),
            half_extent=empty(slots, 3),
            table=empty(3),
            yaw=empty(),
        )
