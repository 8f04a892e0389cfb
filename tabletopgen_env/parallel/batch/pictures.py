"""Camera pictures of a batch, rendered for all worlds at once by MuJoCo Warp's ray tracer."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np
import torch
from jaxtyping import UInt8
from torch import Tensor

from ...rendering.config import ObservationConfig
from ...rendering.views import CAMERAS
from ...tasks.task import Task
from ...world.composition import marker_kind
from ...world.room import HAZE
from .engine import Engine, to_device
from .state import BatchState
from .union.look import LOOKING
from .union.look_union import LookRows, LookUnion


class BatchPictures:
    """A renderer of a batch's pictures, with haze but no shadows, as in ``TabletopEnv``'s pictures.

    Glass is opaque, and so is the goal marker, which marks the episode's first goal.

    Args:
        union: the model for rendering.
        config: cameras and picture size.
        worlds: number of worlds.
        device: device of the worlds.
        task: the task whose marker is shown.
    """

    def __init__(
        self,
        union: LookUnion,
        config: ObservationConfig,
        worlds: int,
        device: torch.device,
        task: Task,
    ) -> None:
        self._engine = engine = Engine.load()
        self._torch_device = device
        self._device = engine.warp.device_from_torch(device)
        self._marker = union.marker
        self._keys = [config.key(camera, "rgb") for camera in config.sizes]
        height, width = next(iter(config.sizes.values()))
        self._shape = worlds, len(config.cameras), height, width
        self._bodies = to_device(union.bodies, device)
        self._camera_bodies = to_device(union.camera_bodies, device)
        self._rows = {
            f.name: to_device(getattr(union.rows, f.name), device) for f in fields(LookRows)
        }
        self._rows["size"][:, self._marker, 0] = task.marker_radius
        union.model.geom_type[self._marker] = marker_kind(task.marker_shape)
        batched = ("geom_size", "geom_dataid", "geom_matid", "cam_fovy")
        warp, physics = engine.warp, engine.physics
        active = [LOOKING.index(CAMERAS[camera]) for camera in config.cameras]
        with warp.ScopedDevice(self._device):
            self._model = physics.put_model(
                union.model, batch_sizes=dict.fromkeys(batched, max(2, worlds))
            )
            self._data = physics.make_data(union.model, nworld=worlds, nconmax=1, njmax=1)
            self._context = physics.create_render_context(
                union.model, nworld=worlds, cam_res=(width, height), render_rgb=True,
                render_depth=True, render_seg=False, cam_active=active,
                use_precomputed_rays=False, background_color=(*HAZE, 1.0),
            )  # fmt: skip
        self._fields = {f: self._tensor(getattr(self._model, f))[:worlds] for f in batched}
        placed = ("geom_xpos", "geom_xmat", "cam_xpos", "cam_xmat", "light_xpos", "light_xdir")
        self._placed = {name: self._tensor(getattr(self._data, name)) for name in placed}
        self._packed = self._tensor(self._context.rgb_data).view(self._shape)
        self._depth = self._tensor(self._context.depth_data).view(self._shape)
        self._haze = to_device(255 * np.array(HAZE), device)

    def draw(self, state: BatchState) -> dict[str, UInt8[Tensor, "w h v 3"]]:
        """Render all cameras; return the pictures (0 to 255) keyed by ``ObservationConfig.key``."""
        self._place(state)
        warp, physics = self._engine.warp, self._engine.physics
        with warp.ScopedDevice(self._device):
            physics.refit_bvh(self._model, self._data, self._context)
            physics.render(self._model, self._data, self._context)
        colors = torch.stack([(self._packed >> shift) & 255 for shift in (16, 8, 0)], -1).float()
        begin, end = self._rows["haze"][state.scene].T[:, :, None, None, None]
        hidden = ((self._depth - begin) / (end - begin)).clamp(0, 1)[..., None]
        pictures = (colors + hidden * (self._haze - colors)).round().to(torch.uint8)
        return {key: pictures[:, k] for k, key in enumerate(self._keys)}

    def _place(self, state: BatchState) -> None:
        """Set the poses of geoms, cameras and lights from the state of the worlds."""
        scene = state.scene
        row = {name: values[scene] for name, values in self._rows.items()}
        for name, source in (("geom_size", "size"), ("geom_dataid", "data"),
                             ("geom_matid", "material"), ("cam_fovy", "fovy")):  # fmt: skip
            self._fields[name].copy_(row[source])
        for kind, bodies, at, turn in (
            ("geom", self._bodies, row["pos"], row["mat"]),
            ("cam", self._camera_bodies, row["camera_pos"], row["camera_mat"]),
        ):
            own = state.xmat[:, bodies]
            turned = (own @ at[..., None])[..., 0]
            self._placed[f"{kind}_xpos"].copy_(state.xpos[:, bodies] + turned)
            self._placed[f"{kind}_xmat"].copy_(own @ turn)
        self._placed["geom_xpos"][:, self._marker] = state.marker
        self._placed["light_xpos"].copy_(row["sun"][:, :1])
        self._placed["light_xdir"].copy_(row["sun"][:, 1:])

    def _tensor(self, array: Any) -> Tensor:
        """Return a Warp array as a tensor that shares its memory; packed colours become int32."""
        warp = self._engine.warp
        found = array.view(warp.int32) if getattr(array, "dtype", None) is warp.uint32 else array
        return warp.to_torch(found)
