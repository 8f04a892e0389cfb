"""The stage-wise pictures of the paper's Sec. 6.1 (Figs. 8-14)."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from ..geometry import yaw_quaternion
from ..io.files import write_file
from ..io.pictures import write_picture
from ..render.picture import TOP_DOWN, framing_camera, render_scene
from ..render.raster import place, render
from ..render.sheet import draw_boxes, grid
from ..scene import TABLE, Instance, Model, Reference, Rotation, Scene, TopView, View
from ..scene.paper_json import to_paper
from .alignment import Alignment

_STUDIO = View(azimuth=np.deg2rad(30.0), elevation=np.deg2rad(30.0), fov=np.deg2rad(25.0))


def model_picture(
    model: Model, yaw: float = 0.0, view: View = _STUDIO, side: int = 256
) -> UInt8[np.ndarray, "side side 3"]:
    """Draw one canonical model at its commonsense size, turned by ``yaw`` radians."""
    item = place(model.mesh, model.size, np.zeros(3), yaw_quaternion(yaw))
    camera = framing_camera(np.asarray(item.vertices), view, side, side)
    return render([item], camera).image


def bundle_images(
    reference: Reference, top_view: TopView | None, scene: Scene
) -> dict[str, UInt8[np.ndarray, "_h _w 3"]]:
    """Return the pictures a bundle keeps, by file stem."""
    pictures = {"reference": np.asarray(reference.image), "preview": preview(scene)}
    return pictures | ({"top_view": np.asarray(top_view.image)} if top_view else {})


def preview(scene: Scene) -> UInt8[np.ndarray, "h w 3"]:
    """Draw a scene from its reference view: what ``preview.png`` shows."""
    return render_scene(scene, width=960, height=720).image


def save_figures(
    folder: Path,
    reference: Reference,
    instances: tuple[Instance, ...],
    view: View,
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    alignment: Alignment,
    scene: Scene,
) -> tuple[Path, ...]:
    """Write the figures into ``folder`` (made if missing); return their paths.

    Raises:
        StorageError: the folder cannot be written.
    """
    things = [i for i in instances if i.name != TABLE]
    pictures = {
        "fig08_reference": np.asarray(reference.image),
        "fig09_completion": _completion(reference, things),
        "fig10_canonical_models": grid(list(map(model_picture, models.values())), list(models), 5),
        "fig11_rotation": _rotations([i for i in things if i.name in rotations], models,
                                     rotations, view),
        "scene_front": preview(scene),
        "scene_top": render_scene(scene, TOP_DOWN, 960, 720).image,
    }  # fmt: skip
    if alignment.top_view is not None:
        seen = alignment.top_view
        pictures["fig13_top_view"] = draw_boxes(seen.image, seen.boxes)
    written = [write_picture(image, folder / f"{stem}.png") for stem, image in pictures.items()]
    texts = to_paper(alignment.placements, alignment.anchor)
    for stem, value in zip(("fig12_rotation", "fig14_alignment"), texts, strict=True):
        text = json.dumps(value, indent=2) + "\n"
        written.append(write_file(text.encode(), folder / f"{stem}.json"))
    return tuple(written)


def _completion(reference: Reference, things: list[Instance]) -> UInt8[np.ndarray, "h w 3"]:
    """Fig. 9: raw segments (an instance's visible pixels) above, completed crops below."""
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
    """Fig. 11: each instance's crop above its model at the estimated rotation."""
    yaws = [rotations[i.name].yaw for i in things]
    captions = [i.name for i in things] + [f"{np.rad2deg(yaw) % 360:.1f} deg" for yaw in yaws]
    images = [np.asarray(i.crop) for i in things]
    images += [
        model_picture(models[i.name], yaw, view) for i, yaw in zip(things, yaws, strict=True)
    ]
    return grid(images, captions, columns=len(things), cell=200)
