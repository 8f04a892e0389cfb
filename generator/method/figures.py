"""The pictures of each stage, as in Sec. 6.1 of the paper (Figs. 8-14)."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from jaxtyping import UInt8

from ..geometry import yaw_quaternion
from ..io.files import write_file
from ..io.pictures import write_picture
from ..render.raster import place, render
from ..render.sheet import BOX_COLORS, TOP_DOWN, draw_boxes, framing_camera, grid, render_scene
from ..scene import TABLE, Instance, Model, Reference, Rotation, Scene, TopView, View
from ..scene.paper_json import to_paper
from .alignment import Alignment

_STUDIO = View(azimuth=np.deg2rad(30.0), elevation=np.deg2rad(30.0), fov=np.deg2rad(25.0))
_Pictures = dict[str, UInt8[np.ndarray, "_h _w 3"]]


def model_picture(
    model: Model, yaw: float = 0.0, view: View = _STUDIO, side: int = 256
) -> UInt8[np.ndarray, "side side 3"]:
    """Draw one canonical model at its commonsense size, rotated by ``yaw`` radians."""
    item = place(model.mesh, model.size, np.zeros(3), yaw_quaternion(yaw))
    camera = framing_camera(np.asarray(item.vertices), view, side, side)
    return render([item], camera).image


def bundle_images(
    reference: Reference, top_view: TopView | None, scene: Scene
) -> dict[str, UInt8[np.ndarray, "_h _w 3"]]:
    """Return the pictures that a bundle stores, keyed by file stem."""
    pictures = {"reference": np.asarray(reference.image), "preview": preview(scene)}
    return pictures | ({"top_view": np.asarray(top_view.image)} if top_view else {})


def preview(scene: Scene) -> UInt8[np.ndarray, "h w 3"]:
    """Draw a scene from its reference view, as in ``preview.png``."""
    return render_scene(scene, width=960, height=720).image


def draw_stage(stage: str, found: Mapping[str, Any]) -> dict[str, UInt8[np.ndarray, "_h _w 3"]]:
    """Return the pictures of a stage of ``pipeline.generate`` by file stem; some stages have none.

    ``found`` is what ``watch`` receives at the end of the stage: fields of a ``Generation``.
    """
    return _DRAWERS[stage](found) if stage in _DRAWERS else {}


def save_figures(folder: Path, found: Mapping[str, Any]) -> tuple[Path, ...]:
    """Write the figures for all fields of a ``Generation`` into ``folder``; return their paths.

    The folder is created if it does not exist.

    Raises:
        StorageError: the folder cannot be written.
    """
    pictures = {k: v for draw in _DRAWERS.values() for k, v in draw(found).items()}
    written = [write_picture(image, folder / f"{stem}.png") for stem, image in pictures.items()]
    alignment: Alignment = found["alignment"]
    texts = to_paper(alignment.placements, alignment.anchor)
    for stem, value in zip(("fig12_rotation", "fig14_alignment"), texts, strict=True):
        text = json.dumps(value, indent=2) + "\n"
        written.append(write_file(text.encode(), folder / f"{stem}.json"))
    return tuple(written)


# --------------------------------------------------------------------------------------- by stage


def _draw_reference(found: Mapping[str, Any]) -> _Pictures:
    return {"fig08_reference": np.asarray(found["reference"].image)}


def _draw_extraction(found: Mapping[str, Any]) -> _Pictures:
    reference, things = found["reference"], _things(found)
    return {
        "fig09_detection": _detection(reference, things),
        "fig09_completion": _completion(reference, things),
    }


def _draw_modeling(found: Mapping[str, Any]) -> _Pictures:
    models: Mapping[str, Model] = found["models"]
    return {
        "fig10_canonical_models": grid(list(map(model_picture, models.values())), list(models), 5)
    }


def _draw_rotation(found: Mapping[str, Any]) -> _Pictures:
    rotations = found["rotations"]
    things = [i for i in _things(found) if i.name in rotations]
    return {"fig11_rotation": _rotations(things, found["models"], rotations, found["view"])}


def _draw_alignment(found: Mapping[str, Any]) -> _Pictures:
    seen: TopView | None = found["alignment"].top_view
    return {} if seen is None else {"fig13_top_view": draw_boxes(seen.image, seen.boxes)}


def _draw_assembly(found: Mapping[str, Any]) -> _Pictures:
    scene: Scene = found["scene"]
    top = render_scene(scene, TOP_DOWN, 960, 720).image
    return {"scene_front": preview(scene), "scene_top": top}


_DRAWERS: Mapping[str, Callable[[Mapping[str, Any]], _Pictures]] = MappingProxyType({
    "reference": _draw_reference,
    "extraction": _draw_extraction,
    "modeling": _draw_modeling,
    "rotation": _draw_rotation,
    "alignment": _draw_alignment,
    "assembly": _draw_assembly,
})  # fmt: skip


def _things(found: Mapping[str, Any]) -> list[Instance]:
    return [i for i in found["instances"] if i.name != TABLE]


def _detection(reference: Reference, things: list[Instance]) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the detections: each instance's box and its tinted visible pixels."""
    image = np.array(reference.image)
    for index, thing in enumerate(things):
        tint = np.array(BOX_COLORS[index % len(BOX_COLORS)], float)
        image[thing.mask] = (0.55 * image[thing.mask] + 0.45 * tint).astype(np.uint8)
    return draw_boxes(image, {thing.name: thing.box for thing in things})


def _completion(reference: Reference, things: list[Instance]) -> UInt8[np.ndarray, "h w 3"]:
    """Draw Fig. 9: the visible pixels of each instance above its completed crop."""
    cuts: list[np.ndarray] = []
    for thing in things:
        x0, y0, x1, y1 = (round(float(v)) for v in thing.box)
        alpha = thing.mask[y0:y1, x0:x1].astype(np.uint8) * 255
        cuts.append(np.dstack([reference.image[y0:y1, x0:x1], alpha]))
    captions = [i.name for i in things]
    captions += ["completed" if i.occluded else "complete" for i in things]
    return grid([*cuts, *(np.asarray(i.crop) for i in things)], captions, len(things), cell=200)


def _rotations(
    things: list[Instance],
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    view: View,
) -> UInt8[np.ndarray, "h w 3"]:
    """Draw Fig. 11: each instance's crop above its model at the estimated rotation."""
    yaws = [rotations[i.name].yaw for i in things]
    captions = [i.name for i in things] + [f"{np.rad2deg(yaw) % 360:.1f} deg" for yaw in yaws]
    images = [np.asarray(i.crop) for i in things]
    images += [
        model_picture(models[i.name], yaw, view) for i, yaw in zip(things, yaws, strict=True)
    ]
    return grid(images, captions, columns=len(things), cell=200)
