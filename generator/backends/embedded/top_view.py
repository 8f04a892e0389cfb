"""A top view of the table, rendered from models that are fitted to their masks."""

from __future__ import annotations

from collections.abc import Mapping

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8
from scipy.optimize import least_squares

from ...geometry import Camera, hull_points, rotation_z, view_rotation, yaw_quaternion
from ...meshes.pixels import dilate
from ...render.contact import Body
from ...render.raster import Item, place, render
from ...render.sheet import TOP_DOWN
from ...scene import TABLE, Instance, Model, Reference, Rotation, TopView, View
from ..protocols import Instances
from .depth.placement import seat
from .plane.measure import measured_extent, whole_box
from .plane.plane import TablePlane
from .supports import stack
from .survey import floor_of, survey

_PIXELS = 640  # length of the table's longer side
_MARGIN = 0.12  # margin around the table, as a fraction of its longer side
_GROUND = (226, 226, 224)


def top_view(
    reference: Reference,
    instances: Instances,
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    view: View,
) -> TopView:
    """Place each model so that it projects onto its instance's bounding box; render from above.

    Instances without a model get the box of their mask, projected onto the plane. All boxes come
    from geometry, so ``repaired`` is empty; the picture is rendered from the same placements. If
    depth shows an object, its model keeps its size and is moved until its visible part matches the
    depth. For a picture without a text, the table sets the scale.

    Raises:
        SceneError: the picture contains no tabletop.
    """
    length = float(models[TABLE].size[0]) if TABLE in models else None
    known = survey(reference, instances, length, view)
    plane, solids = known.plane, known.solids
    things = [i for i in instances if i.name != TABLE]
    order = stack(instances, lambda label: False, solids)
    image = np.asarray(reference.image)
    covered = np.any([np.zeros(image.shape[:2], bool), *(i.mask for i in things)], axis=0)
    fitted: dict[str, Body] = {}
    footprints: dict[str, np.ndarray] = {}
    for thing in sorted(things, key=lambda i: order[i.name].order):
        name, on = thing.name, order[thing.name].on
        solid, model = solids.get(name), models.get(name)
        yaw = rotations[name].yaw if name in rotations else 0.0
        if model is None:
            extent, middle = measured_extent(np.asarray(thing.mask), plane)
            footprints[name] = np.stack([middle - extent[:2] / 2, middle + extent[:2] / 2])
            continue
        if solid is None:
            floor = _upper_side(fitted[on], models[on].container) if on in fitted else 0.0
            fitted[name] = fit_model(thing, model, yaw, plane, floor)
        else:
            floor, others = floor_of(name, solids, order), covered & ~np.asarray(thing.mask)
            fitted[name] = seat(model, yaw, floor, solid, others, plane)
        footprints[name] = fitted[name].footprint
    scale = _PIXELS / max(plane.size)
    table = np.asarray(plane.size) / 2
    half = table + _MARGIN * max(plane.size)
    boxes = {name: _pixel_box(f, half, scale) for name, f in footprints.items()}
    image = _draw(image, covered, plane, fitted, half, scale)
    table_box = _pixel_box(np.stack([-table, table]), half, scale)
    metric = 1 / scale if reference.plan is None else None
    return TopView(image, table_box, boxes, metres_per_pixel=metric)


def _pixel_box(
    corners: Float[np.ndarray, "2 2"], half: Float[np.ndarray, "2"], scale: float
) -> Float[np.ndarray, "4"]:
    (x0, y0), (x1, y1) = corners
    return np.array([x0 + half[0], half[1] - y1, x1 + half[0], half[1] - y0]) * scale


def _upper_side(below: Body, container: bool) -> float:
    """Return the height at which objects stand on ``below``, or lie in it if it is a container."""
    share = -0.3 if container else 0.5
    return float(below.position[2] + share * below.scale[2])


def fit_model(
    instance: Instance, model: Model, yaw: float, plane: TablePlane, floor: float
) -> Body:
    """Solve for x, y and size so that the model's projection fills the instance's bounding box.

    ``floor`` is the height of the model's support above the tabletop. The size may change by a
    factor; a weak prior keeps it near the model's own.
    """
    box = whole_box(instance)
    solid = hull_points(np.asarray(model.mesh.vertices, float)) + np.array([0, 0, 0.5])
    turned = (solid * np.asarray(model.size)) @ rotation_z(yaw).T
    foot = plane.camera.on_plane(np.array([[(box[0] + box[2]) / 2, box[3]]]), floor)[0]
    span = max(float(np.hypot(*(box[2:] - box[:2]))), 1.0)

    def residuals(p: np.ndarray) -> np.ndarray:
        pixels = plane.camera.project(turned * np.exp(p[2]) + [p[0], p[1], floor])
        off = np.concatenate([pixels.min(0), pixels.max(0)]) - box
        return np.concatenate([off / span * 40.0, [p[2] / 0.5]])

    start = np.array([foot[0], foot[1] + model.size[1] / 2, 0.0])
    found = least_squares(residuals, start, loss="soft_l1", max_nfev=60).x
    factor = float(np.exp(np.clip(found[2], -1.5, 1.5)))
    scale = np.asarray(model.size) * factor
    center = np.array([found[0], found[1], floor + scale[2] / 2])
    return Body(model.mesh, scale, yaw, center)


# --------------------------------------------------------------------------------------- drawing


def _draw(
    image: UInt8[np.ndarray, "h w 3"],
    covered: Bool[np.ndarray, "h w"],
    plane: TablePlane,
    fitted: Mapping[str, Body],
    half: Float[np.ndarray, "2"],
    scale: float,
) -> UInt8[np.ndarray, "a b 3"]:
    """Render the rectified, cleared tabletop with the models on it, from far above."""
    width, height = (round(float(v)) for v in 2 * half * scale)
    top = _bare_top(image, covered, plane, half, scale, (width, height))
    fov = TOP_DOWN.fov / 8
    distance = float(half[1] / np.tan(fov / 2))
    camera = Camera(np.array([0, 0, distance]), view_rotation(TOP_DOWN), fov, width, height)
    items = [_sheet(half, top)]
    for index, thing in enumerate(fitted.values(), start=1):
        turn = yaw_quaternion(thing.yaw)
        items.append(place(thing.mesh, thing.scale, thing.position, turn, index))
    return render(items, camera).image


def _sheet(half: Float[np.ndarray, "2"], texture: UInt8[np.ndarray, "h w 3"]) -> Item:
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)
    vertices = np.column_stack([corners * half, np.zeros(4)])
    return Item(vertices, np.array([[0, 1, 2], [0, 2, 3]]), (corners + 1) / 2, texture)


def _bare_top(
    image: UInt8[np.ndarray, "h w 3"],
    covered: Bool[np.ndarray, "h w"],
    plane: TablePlane,
    half: Float[np.ndarray, "2"],
    scale: float,
    size: tuple[int, int],
) -> UInt8[np.ndarray, "a b 3"]:
    """Return the tabletop from above, inpainted where objects were, on a neutral background."""
    cover = dilate(covered, 7).astype(np.uint8)
    corners = np.array([[-1, 1], [1, 1], [1, -1], [-1, -1]], float) * np.asarray(plane.size) / 2
    here = plane.to_pixels(corners).astype(np.float32)
    there = ((corners * [1, -1] + half) * scale).astype(np.float32)
    warp = cv2.getPerspectiveTransform(here, there)
    flat = cv2.warpPerspective(image, warp, size, flags=cv2.INTER_AREA)
    holes = cv2.warpPerspective(cover, warp, size, flags=cv2.INTER_NEAREST)
    polygon = np.round((plane.top(-0.004) * [1, -1] + half) * scale - 0.5).astype(np.int32)
    inside = np.zeros((size[1], size[0]), np.uint8)
    cv2.fillPoly(inside, [polygon], 1)
    shown = cv2.warpPerspective(np.ones_like(cover), warp, size, flags=cv2.INTER_NEAREST) > 0
    bare = (inside > 0) & (holes == 0) & shown
    usual = np.median(flat[bare], axis=0) if bare.any() else 200
    flat[(inside > 0) & ~bare] = usual
    filled = cv2.inpaint(flat, (holes * inside) * 255, 5, cv2.INPAINT_TELEA)
    return np.where(inside[..., None] > 0, filled, np.array(_GROUND)).astype(np.uint8)
