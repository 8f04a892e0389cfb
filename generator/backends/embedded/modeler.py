"""Analysis by synthesis for image-to-3D: shapes are fitted, and the most similar one is kept."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from tabletop_objects import Category
from tabletop_objects.values import parts_to_unit_box, to_unit_box

from ...geometry import rotation_z
from ...language.names import known_category
from ...meshes import texture_bake
from ...meshes.canonical import metric
from ...meshes.projection import Projection
from ...scene import TABLE, Instance, Model, Physics, SizePrior, View
from .shapes.frames import bounded_gap, small_mask
from .shapes.generic import best_solid, oddness, score
from .shapes.likeness import FEW, VARIANTS, Likeness, fit_likeness
from .shapes.paint import PROJECT, paint
from .shapes.solids import PosedSolid
from .table_likeness import model_table

_COARSE = 100  # likewise, during the search of catalogue shapes
_WORKING = 200  # longer side in pixels of the compared silhouettes
_ALIKE = 0.6  # minimum silhouette overlap of a catalogue shape
# overlap minus the penalty for odd proportions, above which a label is accepted at once
_SURE = 0.83
_TRUST = 0.12  # otherwise a label is rejected if a generic solid's score is better by this margin
_UNLIKE = 0.4  # difference from measured proportions above which a label is rejected


@dataclass(frozen=True)
class EmbeddedModeler:
    """The embedded image-to-3D backend. ``texture`` is the side length of baked textures in texels.

    ``quick`` is for scenes whose plan names the objects and corrects errors: labels are trusted,
    and fewer shapes are tried.
    """

    seed: int = 0
    texture: int = 384
    quick: bool = dataclasses.field(default=False, repr=False)

    def for_text(self) -> EmbeddedModeler:
        """Return a faster variant of this modeler, for pictures drawn from a text prompt."""
        return dataclasses.replace(self, quick=True)

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Reconstruct one instance from its crop (Sec. 3.2); see ``protocols.Modeler``."""
        if TABLE in (instance.name, instance.label):
            return model_table(instance, size, view, self.seed, 2 * self.texture, self.quick)
        projection = Projection.of_instance(instance, view)
        category = known_category(instance, size)
        found = None if category is None else self._likeness(category, instance, size, projection)
        worth = -np.inf if found is None else found.iou - oddness(found.extent, size)
        if found is not None and (self.quick or worth >= _SURE):
            return likeness_model(found, instance, projection, size, self.texture)
        small = projection.resize(_WORKING)
        mask = small_mask(instance, small)
        posed = best_solid(mask, small, size)
        if found is not None and worth > score(posed, mask, small, size) - _TRUST:
            return likeness_model(found, instance, projection, size, self.texture)
        return solid_model(posed, instance, projection, size, self.texture)

    def _likeness(
        self, category: Category, instance: Instance, size: SizePrior, projection: Projection
    ) -> Likeness | None:
        """Return the catalogue shape most similar to the crop, or None if none is similar."""
        coarse = projection.resize(_COARSE)
        found = fit_likeness(
            category, self.seed, instance.crop, small_mask(instance, coarse), coarse,
            instance.occluded, FEW if self.quick else VARIANTS,
        )  # fmt: skip
        if found.iou < _ALIKE:
            return None
        # A book has different resting poses than a box.
        belied = size.measured and bounded_gap(found.extent, size.extent) > _UNLIKE
        return None if belied else found


def likeness_model(
    found: Likeness, instance: Instance, projection: Projection, size: SizePrior, texture: int
) -> Model:
    """Return a ``Likeness``'s catalogue model with the crop's proportions and colours."""
    mesh = paint(
        found.model.mesh, found.extent, found.yaw, found.position, instance.crop, projection,
        texture, found.iou >= PROJECT,
    )  # fmt: skip
    label, extent = instance.label, metric(found.extent, size)
    return dataclasses.replace(found.model, name=label, label=label, mesh=mesh, size=extent)


def solid_model(
    posed: PosedSolid, instance: Instance, projection: Projection, size: SizePrior, texture: int
) -> Model:
    """Paint a posed solid from the crop and convert it to the canonical frame."""
    planes = mirror_planes(posed, projection)
    atlas, picture = texture_bake.paint(
        posed.world, posed.solid.faces, instance.crop, projection, planes, texture,
        posed.kind != "carved",
    )  # fmt: skip
    mesh, center, extent = to_unit_box(
        texture_bake.apply_texture(atlas, posed.solid.vertices, picture)
    )
    parts = parts_to_unit_box(posed.solid.parts, center, extent)
    label, physics = instance.label, Physics(density=500.0, friction=0.6)
    return Model(label, label, mesh, metric(extent, size), physics, parts)


def mirror_planes(posed: PosedSolid, projection: Projection) -> tuple[Float[np.ndarray, "4"], ...]:
    """Return the vertical planes about which a solid may be considered symmetric."""
    low, high = posed.solid.vertices.min(0), posed.solid.vertices.max(0)
    turn = rotation_z(posed.yaw)
    middle = turn @ ((low + high) / 2) + posed.position
    normals = [turn[:, 1], turn[:, 0]]
    if posed.kind == "revolution":
        normals = [projection.away, projection.right]
    return tuple(np.array([*n, n @ middle]) for n in normals)
