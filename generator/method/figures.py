"""The stage-wise pictures of the paper's Sec. 6.1 (Figs. 8-14), from a ``Generation``."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

import numpy as np
from jaxtyping import UInt8

from ..geometry import yaw_quaternion
from ..io.files import write_file
from ..io.pictures import write_picture
from ..render.picture import TOP_DOWN, framing_camera, render_scene
from ..render.raster import place, render
from ..render.sheet import draw_boxes, grid
from ..scene import TABLE, Instance, Model, Reference, Rotation, Scene, View
from ..scene.paper_json import to_paper
from .alignment import Alignment


class Stagewise(Protocol):
    """The part of a ``Generation`` that the figures need."""

    @property
    def reference(self) -> Reference: ...  # noqa: D102
    @property
    def instances(self) -> tuple[Instance, ...]: ...  # noqa: D102
    @property
    def view(self) -> View: ...  # noqa: D102
    @property
    def models(self) -> Mapping[str, Model]: ...  # noqa: D102
    @property
    def rotations(self) -> Mapping[str, Rotation]: ...  # noqa: D102
    @property
    def alignment(self) -> Alignment: ...  # noqa: D102
    @property
    def scene(self) -> Scene: ...  # noqa: D102


_STUDIO = View(azimuth=np.deg2rad(30.0), elevation=np.deg2rad(30.0), fov=np.deg2rad(25.0))


def model_picture(
    model: Model, yaw: float = 0.0, view: View = _STUDIO, side: int = 256
) -> UInt8[np.ndarray, "side side 3"]:
    """Draw one canonical model at its commonsense size, turned by ``yaw`` radians."""
    item = place(model.mesh, model.size, np.zeros(3), yaw_quaternion(yaw))
    camera = framing_camera(np.asarray(item.vertices), view, side, side)
    return render([item], camera).image


def bundle_images(generation: Stagewise) -> dict[str, UInt8[np.ndarray, "h w 3"]]:
    """Return the pictures a bundle keeps, by file stem."""
    pictures = {
        "reference": np.asarray(generation.reference.image),
        "preview": preview(generation.scene),
    }
    if generation.alignment.top_view is not None:
        pictures["top_view"] = np.asarray(generation.alignment.top_view.image)
    return pictures


def preview(scene: Scene) -> UInt8[np.ndarray, "h w 3"]:
    """Draw a scene from its reference view: what ``preview.png`` shows."""
    return render_scene(scene, width=960, height=720).image


def save_figures(generation: Stagewise, folder: Path) -> tuple[Path, ...]:
    """Write the figures into ``folder`` (made if missing); return their paths.

    Raises:
        StorageError: the folder cannot be written.
    """
    g = generation
    pictures = {
        "fig08_reference": np.asarray(g.reference.image),
        "fig09_completion": _completion(g),
        "fig10_canonical_models": _models(g),
        "fig11_rotation": _rotations(g),
        "scene_front": preview(g.scene),
        "scene_top": render_scene(g.scene, TOP_DOWN, 960, 720).image,
    }
    if g.alignment.top_view is not None:
        seen = g.alignment.top_view
        pictures["fig13_top_view"] = draw_boxes(seen.image, seen.boxes)
    rotations, alignment = to_paper(g.alignment.placements, g.alignment.anchor)
    texts = {"fig12_rotation": rotations, "fig14_alignment": alignment}
    written = [write_picture(image, folder / f"{stem}.png") for stem, image in pictures.items()]
    for stem, value in texts.items():
        text = json.dumps(value, indent=2) + "\n"
        written.append(write_file(text.encode(), folder / f"{stem}.json"))
    return tuple(written)


def _others(g: Stagewise) -> list[Instance]:
    return [instance for instance in g.instances if instance.name != TABLE]


def _cut(g: Stagewise, instance: Instance) -> UInt8[np.ndarray, "h w 4"]:
    """The raw segmentation of an instance: its visible pixels alone."""
    x0, y0, x1, y1 = (round(float(v)) for v in instance.box)
    alpha = instance.mask[y0:y1, x0:x1].astype(np.uint8) * 255
    return np.dstack([g.reference.image[y0:y1, x0:x1], alpha])


def _completion(g: Stagewise) -> np.ndarray:
    """Fig. 9: raw segments above, completed crops below."""
    things = _others(g)
    images = [_cut(g, i) for i in things] + [np.asarray(i.crop) for i in things]
    captions = [i.name for i in things] + [
        "completed" if i.occluded else "complete" for i in things
    ]
    return grid(images, captions, columns=len(things), cell=200)


def _models(g: Stagewise) -> np.ndarray:
    """Fig. 10: every model upright in its canonical frame."""
    return grid([model_picture(m) for m in g.models.values()], list(g.models), columns=5)


def _rotations(g: Stagewise) -> np.ndarray:
    """Fig. 11: each instance's crop above its model at the estimated rotation."""
    things = [i for i in _others(g) if i.name in g.rotations]
    renders = [
        model_picture(g.models[i.name], g.rotations[i.name].yaw, g.view, 256) for i in things
    ]
    captions = [i.name for i in things] + [
        f"{np.rad2deg(g.rotations[i.name].yaw) % 360:.1f} deg" for i in things
    ]
    images = [np.asarray(i.crop) for i in things] + renders
    return grid(images, captions, columns=len(things), cell=200)
