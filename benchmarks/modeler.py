"""Similarity of a modeler's re-renders to one picture, from the same view and 60 degrees around.

    python benchmarks/modeler.py --seed 10000 --cases 40

Each case is a catalogue object (variant seeds from ``--seed`` on) drawn on a wooden table by the
NumPy renderer at a random position, yaw and camera under a random sun. The modeler gets the crop of
the true mask and the proportions measured by the eye, once with its label and the catalogue's usual
size, once as an "object". Its model, rotated to the most similar yaw and placed on the table, is
drawn under the same light from the same position and from one 60 degrees around. Columns: overlap
(IoU) of the silhouettes, mean CIELAB difference within the overlap.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from generator.backends.embedded.completion import complete
from generator.backends.embedded.eye.proportions import proportion_clues
from generator.backends.embedded.eye.weights import load_proportions, load_weights
from generator.backends.embedded.modeler import EmbeddedModeler
from generator.backends.embedded.plane.measure import sized_extent
from generator.backends.embedded.plane.plane import TablePlane
from generator.backends.embedded.shapes.frames import frame_to_mask, small_mask
from generator.geometry import Camera, mask_box, ray_view, rotation_z, yaw_quaternion
from generator.meshes.pixels import mask_iou
from generator.meshes.projection import Projection
from generator.render.raster import Item, place, render
from generator.render.shading import Light
from generator.scene import Detection, Instance, Mesh, Model, Reference, SizePrior, View
from tabletop_objects import CATEGORIES, build
from tabletop_objects.kit.surfaces import WOODS

WIDTH, HEIGHT = 960, 720
ACROSS = 0.9  # metres of table across the picture's centre
SIDE = 176  # side of the compared pictures, pixels
ROUND = np.deg2rad(60)


@dataclass(frozen=True, eq=False)
class ModelerCase:
    """One object to model: the truth in the world, and the modeler's input."""

    key: str
    truth: Item
    instance: Instance
    view: View
    camera: Camera
    light: Light
    usual: SizePrior
    seen: SizePrior

    def look(self, item: Item, turn: float) -> tuple[UInt8[np.ndarray, "s s 3"], np.ndarray]:
        """Draw an item close up, seen ``turn`` radians around it; return picture and silhouette."""
        low, high = self.truth.vertices.min(0), self.truth.vertices.max(0)
        middle, radius = (low + high) / 2, float(np.linalg.norm(high - low)) / 2
        away = self.camera.position - middle
        view = View(
            float(np.arctan2(away[0], -away[1])),
            float(np.arcsin(away[2] / np.linalg.norm(away))),
            2 * float(np.arctan(1.15 * radius / np.linalg.norm(away))),
        )
        near = Camera.looking_at(middle, view, float(np.linalg.norm(away)), SIDE, SIDE)
        turned = (item.vertices - middle) @ rotation_z(turn).T + middle
        drawn = render(
            [Item(turned, item.faces, item.uv, item.texture, 1, item.opacity)], near,
            light=self.light, background=(128, 128, 128), supersample=1, shadows=False,
        )  # fmt: skip
        return drawn.image, drawn.ids == 1


def ground() -> Item:
    """Return a wooden tabletop at height zero."""
    from tabletop_objects.kit import surfaces

    tile = surfaces.wood(np.random.default_rng(5), WOODS["oak"], side=256, planks=5)
    corners = np.array([[-0.8, -0.6, 0], [0.8, -0.6, 0], [0.8, 0.6, 0], [-0.8, 0.6, 0]])
    faces, uv = np.array([[0, 1, 2], [0, 2, 3]]), np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    return Item(corners, faces, uv, tile, 0)


def draw_case(model: Model, rng: np.random.Generator) -> ModelerCase:
    """Draw ``model`` at a random position on the table, fully inside the picture."""
    view = View(0.0, float(np.deg2rad(rng.uniform(30, 62))), float(np.deg2rad(rng.uniform(30, 45))))
    distance = ACROSS / 2 / np.tan(view.fov / 2) * HEIGHT / WIDTH
    camera = Camera.looking_at(np.zeros(3), view, distance, WIDTH, HEIGHT)
    direction, sun = np.array([*rng.uniform(-0.6, 0.6, 2), 0.8]), float(rng.uniform(0.2, 0.5))
    light = Light(  # exposure: surfaces that face up have the brightness of their colour
        direction=direction,
        sun=sun,
        sky=1.0 - sun * float(direction[2] / np.linalg.norm(direction)),
        tint=tuple(rng.uniform(0.94, 1.0, 3)),
    )
    yaw, turn = float(rng.uniform(-np.pi, np.pi)), yaw_quaternion
    middle = np.array([0, 0, model.size[2] / 2])
    for _ in range(100):
        spot = camera.on_plane(rng.uniform(0.15, 0.85, (1, 2)) * [WIDTH, HEIGHT], 0.0)[0]
        item = place(model.mesh, model.size, spot + middle, turn(yaw), 1)
        pixels = camera.project(item.vertices)
        if (pixels > 2).all() and (pixels < [WIDTH - 2, HEIGHT - 2]).all():
            break
    else:
        raise SystemExit(f"{model.name} of size {model.size} does not fit into the picture.")
    drawn = render([ground(), item], camera, light=light)
    mask = drawn.ids == 1
    found = complete(Reference(drawn.image), Detection(model.label, mask_box(mask), mask), ())
    plane = TablePlane(view, camera, "rectangle", False, (1.6, 1.2), 0.0, 0.0)
    clues = proportion_clues(
        load_weights().eye, drawn.image, [mask], [plane.elevation_at(found.box)],
        float((drawn.ids >= 0).sum()),
    )  # fmt: skip
    (seen,) = load_proportions().tell(clues)
    return ModelerCase(
        model.category, item, found,
        ray_view(view, (found.box[:2] + found.box[2:]) / 2, WIDTH, HEIGHT), camera, light,
        SizePrior("thing", np.array(CATEGORIES[model.category].size), seen=seen),
        SizePrior("object", sized_extent(found.box, seen.extent, plane), seen=seen),
    )  # fmt: skip


def stand(case: ModelerCase, model: Model, yaw: float) -> tuple[Item, float]:
    """Pose a model at ``yaw`` in the world so that its picture fits; also return the overlap."""
    small = Projection.of_instance(case.instance, case.view).resize(128)
    mask = small_mask(case.instance, small)
    shape = model.mesh.vertices * model.size @ rotation_z(yaw).T
    scale, shift = frame_to_mask(shape, small, mask)
    points = shape * scale + shift
    overlap = mask_iou(small.silhouette(points, model.mesh.faces), mask)
    along = points - small.position
    metre = -case.camera.position[2] / along[:, 2].min()
    mesh: Mesh = model.mesh
    placed = case.camera.position + along * metre
    return Item(placed, mesh.faces, mesh.uv, mesh.texture, 1, mesh.opacity), overlap


def difference(
    a: tuple[UInt8[np.ndarray, "s s 3"], Bool[np.ndarray, "s s"]],
    b: tuple[UInt8[np.ndarray, "s s 3"], Bool[np.ndarray, "s s"]],
) -> tuple[float, float]:
    """Return silhouette overlap, and mean CIELAB difference within it (100 if there is none)."""
    both = a[1] & b[1]
    labs = [cv2.cvtColor(x.astype(np.float32) / 255, cv2.COLOR_RGB2LAB) for x in (a[0], b[0])]
    gap = np.linalg.norm(labs[0] - labs[1], axis=-1)
    return mask_iou(a[1], b[1]), float(gap[both].mean()) if both.any() else 100.0


def alike(case: ModelerCase, model: Model) -> tuple[Item, Float[np.ndarray, "4"]]:
    """Return the model at its most similar pose, and the four figures."""
    shown = case.look(case.truth, 0.0)
    yaws = np.arange(36) * np.pi / 18
    overlaps = np.array([stand(case, model, yaw)[1] for yaw in yaws])
    likely = yaws[overlaps > overlaps.max() - 0.04]
    likely = likely[np.argsort(-overlaps[overlaps > overlaps.max() - 0.04], kind="stable")][:12]

    def worth(yaw: float) -> float:
        iou, gap = difference(shown, case.look(stand(case, model, yaw)[0], 0.0))
        return iou - 0.01 * gap

    best = max(likely, key=worth)
    best = max(best + np.deg2rad([-5, -2.5, 0, 2.5, 5]), key=worth)
    item, _ = stand(case, model, best)
    same = difference(shown, case.look(item, 0.0))
    other = [
        difference(case.look(case.truth, turn), case.look(item, turn)) for turn in (ROUND, -ROUND)
    ]
    return item, np.array([*same, *np.mean(other, 0)])


def sheet(case: ModelerCase, items: list[Item]) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the truth above each model, from three sides."""
    turns = (0.0, ROUND, -ROUND, np.pi)
    return np.vstack([np.hstack([case.look(i, t)[0] for t in turns]) for i in (case.truth, *items)])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--seed", type=int, default=10_000)
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--each", action="store_true", help="print every case")
    parser.add_argument("--only", nargs="*", help="categories; random ones by default")
    parser.add_argument("--pictures", type=Path, help="folder for a picture of each case")
    args = parser.parse_args()
    rng = np.random.default_rng(args.seed)
    keys = args.only or list(rng.permutation(sorted(CATEGORIES)))
    rows: dict[str, list[np.ndarray]] = {"label known": [], "label withheld": []}
    kinds = dict.fromkeys(rows, 0)
    for k in range(args.cases):
        key = keys[k % len(keys)]
        own = np.random.default_rng([args.seed, k])
        case = draw_case(build(key, args.seed + k), own)
        items = []
        for name, size in (("label known", case.usual), ("label withheld", case.seen)):
            label = case.instance.label if name == "label known" else "object"
            i = case.instance
            shown = Instance(label, label, i.box, i.mask, i.crop, i.crop_box, i.occluded)
            begin = time.process_time()
            model = EmbeddedModeler().model(shown, size, case.view)
            seconds = time.process_time() - begin
            item, figures = alike(case, model)
            items.append(item)
            rows[name].append(np.array([*figures, seconds]))
            kinds[name] += model.category == case.key
            if args.each:
                print(f"{key:18s} {name:15s} {model.category:10.10s}", *np.round(rows[name][-1], 3),
                      flush=True)  # fmt: skip
        if args.pictures is not None:
            args.pictures.mkdir(parents=True, exist_ok=True)
            picture = cv2.cvtColor(sheet(case, items), cv2.COLOR_RGB2BGR)
            cv2.imwrite(str(args.pictures / f"{k:03d}_{key}.png"), picture)
    print("| crop | objects | IoU, same view | colour, same view | IoU, 60° around | colour, 60° "
        "around | kept its category | CPU seconds, mean (worst) |")  # fmt: skip
    print("|---|---|---|---|---|---|---|---|")
    for name, found in rows.items():
        mean, worst = np.mean(found, 0), np.max(found, 0)
        print(f"| {name} | {len(found)} | {mean[0]:.3f} | {mean[1]:.1f} | {mean[2]:.3f} "
              f"| {mean[3]:.1f} | {kinds[name]} | {mean[4]:.1f} ({worst[4]:.1f}) |")  # fmt: skip


if __name__ == "__main__":
    main()
