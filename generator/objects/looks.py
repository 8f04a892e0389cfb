"""A measure of how different the variants of a category look."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from jaxtyping import Float

from ..scene import Model
from ..scene.triangles import areas

_SIZE, _COLOR, _SPREAD = 0.05, 8.0, 6.0  # visible steps of log size and of colour values (0 to 255)


def appearance(model: Model) -> Float[np.ndarray, "9"]:
    """Return log size and the mean and spread of the surface's colours, in visible steps."""
    mesh = model.mesh
    area = areas(mesh.vertices.astype(float) * model.size, mesh.faces)
    height, width = mesh.texture.shape[:2]
    colors = []
    for weights in np.array([(4, 1, 1), (1, 4, 1), (1, 1, 4), (2, 2, 2)]) / 6:
        u, v = np.einsum("k,fkd->df", weights, mesh.uv[mesh.faces])
        rows = np.clip(((1 - v) * height).astype(int), 0, height - 1)
        colors.append(mesh.texture[rows, np.clip((u * width).astype(int), 0, width - 1)])
    seen, share = np.concatenate(colors).astype(float), np.tile(area, 4) / area.sum() / 4
    mean = share @ seen
    spread = np.sqrt(share @ (seen - mean) ** 2)
    return np.concatenate([np.log(model.size) / _SIZE, mean / _COLOR, spread / _SPREAD])


def count_looks(models: Iterable[Model]) -> int:
    """Count the models that differ by a visible step or more from all previously counted ones."""
    looks: list[Float[np.ndarray, "9"]] = []
    for model in models:
        here = appearance(model)
        if all(np.abs(here - other).max() > 1 for other in looks):
            looks.append(here)
    return len(looks)
