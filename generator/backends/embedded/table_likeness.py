"""Model the table of a picture: outline and legs by silhouette, material and colours by pixels."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from ...catalogue import build_table
from ...catalogue.tables import LEGS
from ...scene import Instance, Mesh, Model, OutlineKind, PlannedTable, SizePrior, View
from . import baking
from .framing import frame_to_mask
from .painting import base_colors
from .pixels import mask_iou
from .projection import Projection
from .tabletops import top_faces, turned_about, with_corners, with_thickness
from .unshading import estimate_shading
from .unwrap import unwrap

_MATERIALS = ("oak", "walnut", "pine", "marble", "steel", "white")
_WORKING = 140
_SKETCH = 160  # texture side at which materials are compared
_FINE = 300  # longer side of the silhouettes that tell thickness and corners
_THICKNESSES = (0.012, 0.02, 0.05, 0.07, 0.1)  # metres
_RADII = (0.06, 0.12, 0.2, 0.3, 0.42)  # of the narrower side
_GAIN = 0.002  # overlap that a change of thickness or corners must gain
_LEGLESS = 0.03  # by how much silhouettes must agree better before legs count as unseen


@dataclass(frozen=True)
class _Form:
    """What a table looks like: its plan, and how it leaves the catalogue's (metres; None: not)."""

    plan: PlannedTable
    about: bool = False
    thickness: float | None = None
    radius: float | None = None

    def built(self, seed: int) -> Model:
        """Return the canonical model."""
        model = build_table(self.plan, seed)
        model = model if self.thickness is None else with_thickness(model, self.thickness)
        model = model if self.radius is None else with_corners(model, self.radius)
        return turned_about(model) if self.about else model


@dataclass(frozen=True, eq=False)
class _Seen:
    """A table model placed under the picture: vertices in the object frame, overlap, legs seen."""

    form: _Form
    model: Model
    world: Float[np.ndarray, "n 3"]
    iou: float
    legs: bool


def model_table(instance: Instance, size: SizePrior, view: View, seed: int, texture: int) -> Model:
    """Return a table of the prior's size that looks like the picture's, yaw zero.

    Outline and legs are those whose silhouette agrees best together, the usual straight legs if
    it shows none; then the thickness of the top and the rounding of its corners. Top and legs
    take their colours from the picture, each for itself. Of a table that the frame cuts, only the
    material is taken: its silhouette does not show its shape.
    """
    projection = Projection.of_instance(instance, view)
    length, width, height = (float(np.clip(s, 0.2, 4.0)) for s in size.extent)
    even = _outlines(length, width)
    plan = PlannedTable(outline=even[0], size=(length, width, height))
    small = projection.resized(_WORKING)
    best = _place(_Form(plan), seed, _mask(instance, small), small)
    if not is_cut(np.asarray(instance.mask)):
        best = _fitted(best, even, seed, instance, projection)
    models = [
        dataclasses.replace(best.form, plan=dataclasses.replace(best.form.plan, material=m)).built(
            seed
        )
        for m in _MATERIALS
    ]
    gaps = [_paint(best, m, instance, projection, _SKETCH)[1] for m in models]
    model = models[int(np.argmin(gaps))]
    mesh, _ = _paint(best, model, instance, projection, texture)
    return dataclasses.replace(model, mesh=mesh, size=np.array(size.extent))


def is_cut(mask: Bool[np.ndarray, "h w"]) -> bool:
    """Tell whether the picture's frame cuts a mask."""
    rim = np.concatenate([mask[0], mask[-1], mask[:, 0], mask[:, -1]])
    return bool(rim.sum() > 0.02 * sum(mask.shape))


def _fitted(
    best: _Seen,
    outlines: tuple[OutlineKind, ...],
    seed: int,
    instance: Instance,
    projection: Projection,
) -> _Seen:
    """Return the table whose silhouette agrees best, tried feature by feature."""
    small = projection.resized(_WORKING)
    mask = _mask(instance, small)

    def best_of(forms: list[_Form]) -> _Seen:
        return max((_place(f, seed, mask, small) for f in forms), key=lambda s: s.iou)

    plan = best.form.plan
    forms = [
        _Form(dataclasses.replace(plan, outline=outline, legs=legs), about)
        for outline in outlines
        for legs in LEGS
        for about in ((False, True) if outline == "triangle" else (False,))
    ]
    best = max(best, best_of(forms), key=lambda s: s.iou)
    small = projection.resized(_FINE)
    mask = _mask(instance, small)
    best = _place(best.form, seed, mask, small)
    finer = best_of([dataclasses.replace(best.form, thickness=t) for t in _THICKNESSES])
    best = finer if finer.iou > best.iou + _GAIN else best
    if best.form.plan.outline in ("rectangle", "square"):
        side = min(plan.size[:2])
        finer = best_of([dataclasses.replace(best.form, radius=r * side) for r in _RADII])
        best = finer if finer.iou > best.iou + _GAIN else best
    return best


def _mask(instance: Instance, small: Projection) -> Bool[np.ndarray, "h w"]:
    """Return the crop's silhouette at the size of ``small``."""
    return baking.opaque_colors(_shrunk(instance, small))[1]


def _shrunk(instance: Instance, small: Projection) -> UInt8[np.ndarray, "h w 4"]:
    return cv2.resize(instance.crop, (small.width, small.height), interpolation=cv2.INTER_AREA)


def _outlines(length: float, width: float) -> tuple[OutlineKind, ...]:
    """Return the outlines that a top of these sides can have."""
    even = abs(np.log(length / width)) < 0.06
    return ("square", "round", "triangle") if even else ("rectangle", "oval", "triangle")


def _place(form: _Form, seed: int, mask: np.ndarray, small: Projection) -> _Seen:
    """Put a table under the silhouette, by all of it or by its top alone."""
    model = form.built(seed)
    top = top_faces(model.mesh)
    shape = model.mesh.vertices * model.size
    found = []
    for legs, faces in ((True, model.mesh.faces), (False, model.mesh.faces[top])):
        used: Int[np.ndarray, "k"] = np.unique(faces)
        scale, shift = frame_to_mask(shape[used], small, mask)
        world = shape * scale + shift
        iou = mask_iou(small.silhouette(world, faces), mask)
        found.append(_Seen(form, model, world, iou, legs))
    whole, bare = found
    return bare if bare.iou > whole.iou + _LEGLESS else whole


def _paint(
    seen: _Seen, model: Model, instance: Instance, projection: Projection, size: int
) -> tuple[Mesh, float]:
    """Recolour a table like the picture; also return how far its material was from it."""
    mesh = model.mesh
    image, mask = baking.opaque_colors(instance.crop)
    atlas = unwrap(mesh.vertices * model.size, mesh.faces, size)
    surface = baking.surface_of(atlas, seen.world)
    sight = baking.Sight.of(seen.world, mesh.faces, projection)
    pixels = projection.project(surface.point)
    inside = baking.sample(mask[..., None].astype(np.uint8), pixels)[:, 0] > 0.5
    visible = sight.sees(surface) & inside
    colors, base = baking.sample(image, pixels), base_colors(mesh, atlas)
    colors = estimate_shading(colors, surface.normal, visible).removed(colors, surface.normal)
    on_top = top_faces(mesh)[atlas.face]
    cell = _cells(surface.point)
    upper = visible & on_top & (surface.normal[:, 2] > 0.9)
    gap = _material_gap(base[upper], colors[upper], cell[upper]) if upper.sum() > 40 else 0.0
    texels = base.copy()
    for part in (on_top, ~on_top):
        if (visible & part).sum() > 40:
            base[part] = _calmed(base[part], visible[part], colors[part], cell[part])
            texels[part] = baking.recolor(base[part], visible[part], colors[part])[0]
    return baking.textured(atlas, mesh.vertices, baking.lay_out(atlas, texels)), gap


def _cells(point: Float[np.ndarray, "t 3"], count: int = 10) -> Int[np.ndarray, "t"]:
    """Number the squares of a grid over the table, ``count`` along its longest side."""
    flat = point[:, :2] - point[:, :2].min(0)
    index = np.minimum((flat / max(float(flat.max()), 1e-9) * count).astype(int), count - 1)
    return index[:, 0] * count + index[:, 1]


def _unrest(colors: Float[np.ndarray, "t 3"], cell: Int[np.ndarray, "t"]) -> float:
    """Return the usual spread of brightness within cells of the surface, in grey levels.

    Light that fades across the table is the same within a cell and does not count.
    """
    brightness = colors.mean(1)
    spreads = []
    for k in np.unique(cell):
        own = brightness[cell == k]
        if len(own) >= 12:
            spreads.append(float(np.subtract(*np.quantile(own, [0.97, 0.03]))))
    return float(np.median(spreads)) if spreads else 0.0


def _calmed(
    base: Float[np.ndarray, "t 3"],
    seen: Bool[np.ndarray, "t"],
    colors: Float[np.ndarray, "t 3"],
    cell: Int[np.ndarray, "t"],
) -> Float[np.ndarray, "t 3"]:
    """Return base colours whose pattern is no stronger than the picture's."""
    found, own = _unrest(colors[seen], cell[seen]), _unrest(base[seen], cell[seen])
    gain = min(1.0, max(found - 1.0, 0.0) / max(own, 1.0))
    middle = np.median(base[seen], 0)
    return middle + (base - middle) * gain


def _material_gap(
    base: Float[np.ndarray, "t 3"], colors: Float[np.ndarray, "t 3"], cell: Int[np.ndarray, "t"]
) -> float:
    """Return how unlike two surfaces' colours and unrest are, in grey levels."""
    tone = np.linalg.norm(np.median(base, 0) - np.median(colors, 0))
    return float(tone + 2.0 * abs(_unrest(base, cell) - _unrest(colors, cell)))
