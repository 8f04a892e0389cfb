"""Yaw of rendered catalogue objects without symmetry: error and seconds of the rotation stage.

    python benchmarks/pose.py --seed 1 --cases 60

Each case is a catalogue object of random category and variant, drawn by the numpy renderer (not
the optimiser's own) under a random sun at a random place, yaw and camera; the estimator gets the
cut-out, the true mesh and a camera whose elevation is off by up to 3 degrees. Objects that look
nearly the same from another side are left out, judged by pictures alone.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from generator.backends.embedded.encoder import Encoder
from generator.catalogue import CATEGORIES, build
from generator.geometry import Camera, mask_box, wrap, yaw_quaternion
from generator.render.raster import place, render
from generator.render.shading import Light
from generator.scene import Instance, Model, View
from generator.stages.rotation import RotationConfig, optimise_rotation

WIDTH, HEIGHT = 1024, 768
TABLE_WIDTH = 1.2  # metres across the picture's middle
DISTINCT = 0.04  # least difference of two views of an object without symmetry


@dataclass(frozen=True, eq=False)
class Case:
    """One object to turn: what the estimator gets, and its true yaw."""

    model: Model
    instance: Instance
    view: View
    yaw: float


def views(model: Model, count: int = 24, size: int = 72) -> Float[np.ndarray, "v h w 4"]:
    """Return RGBA pictures of a model from ``count`` yaws under a light from nowhere."""
    light = Light(sun=0.0, sky=1.0, gloss=0.0)
    view = View(0.0, np.deg2rad(55.0), np.deg2rad(20.0))
    distance = 1.15 * float(np.linalg.norm(model.size)) / (2 * np.tan(view.fov / 2))
    camera = Camera.looking_at(np.zeros(3), view, distance, size, size)
    pictures = []
    for yaw in np.arange(count) * (2 * np.pi / count):
        item = place(model.mesh, model.size, np.zeros(3), yaw_quaternion(yaw))
        drawn = render([item], camera, light=light, shadows=False)
        pictures.append(np.dstack([drawn.image / 255.0, drawn.ids >= 0]))
    return np.array(pictures)


def distinctness(model: Model) -> float:
    """Return how much, in the median over views, the most similar other view differs.

    Views at least 30 degrees apart are compared; the difference is the mean over both silhouettes
    of the largest colour difference, 1 where only one of them is.
    """
    pictures = views(model)
    count = len(pictures)
    least = np.ones(count)
    for i, a in enumerate(pictures):
        for j, b in enumerate(pictures):
            if min((i - j) % count, (j - i) % count) * 360 / count < 30:
                continue
            inside, both = np.maximum(a[..., 3], b[..., 3]), a[..., 3] * b[..., 3]
            colour = np.abs(a[..., :3] - b[..., :3]).max(-1)
            difference = (inside - both + both * colour).sum() / inside.sum()
            least[i] = min(least[i], float(difference))
    return float(np.median(least))


def draw_case(model: Model, rng: np.random.Generator) -> Case:
    """Draw ``model`` at a random yaw and place, wholly inside the picture."""
    view = View(
        float(rng.uniform(-0.2, 0.2)),
        float(np.deg2rad(rng.uniform(45, 65))),
        float(np.deg2rad(rng.uniform(30, 45))),
    )
    distance = TABLE_WIDTH / 2 / np.tan(view.fov / 2) * HEIGHT / WIDTH
    camera = Camera.looking_at(np.zeros(3), view, distance, WIDTH, HEIGHT)
    light = Light(
        direction=np.array([*rng.uniform(-0.6, 0.6, 2), 0.8]),
        sun=float(rng.uniform(0.2, 0.5)),
        tint=tuple(rng.uniform(0.9, 1.0, 3)),
    )
    red, green, blue = (int(c) for c in rng.integers(60, 256, 3))
    yaw = float(rng.uniform(-np.pi, np.pi))
    for _ in range(100):
        pixel = rng.uniform(0.1, 0.9, (1, 2)) * [WIDTH, HEIGHT]
        position = camera.on_plane(pixel, 0.0)[0] + [0, 0, model.size[2] / 2]
        item = place(model.mesh, model.size, position, yaw_quaternion(yaw))
        drawn = render([item], camera, light=light, background=(red, green, blue))
        mask = drawn.ids >= 0
        whole = mask[1:-1, 1:-1].sum() == mask.sum() > 0
        if whole:
            break
    else:
        raise SystemExit(f"{model.name} of size {model.size} does not fit into the picture.")
    box, border = mask_box(mask), np.array([-8, -8, 8, 8])
    x0, y0, x1, y1 = np.clip(box + border, 0, [WIDTH, HEIGHT] * 2).astype(int)
    crop = np.dstack([drawn.image, mask.astype(np.uint8) * 255])[y0:y1, x0:x1]
    instance = Instance(model.name, model.label, box, mask, crop, np.array([x0, y0, x1, y1]))
    off = float(np.deg2rad(rng.uniform(-3, 3)))
    return Case(model, instance, View(view.azimuth, view.elevation + off, view.fov), yaw)


def draw_cases(count: int, seed: int, quiet: bool = False) -> list[Case]:
    """Draw ``count`` cases over random categories and variants, leaving out symmetric objects."""
    rng = np.random.default_rng(seed)
    cases: list[Case] = []
    left_out: set[str] = set()
    keys = sorted(CATEGORIES)
    while len(cases) < count:
        key = keys[int(rng.integers(len(keys)))]
        model = build(key, int(rng.integers(10_000)))
        if distinctness(model) < DISTINCT:
            left_out.add(key)
            continue
        cases.append(draw_case(model, rng))
    if not quiet:
        print(f"categories with variants left out as symmetric: {', '.join(sorted(left_out))}")
    return cases


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cases", type=int, default=60)
    parser.add_argument("--paper", action="store_true", help="use the paper's settings (slow)")
    parser.add_argument("--each", action="store_true", help="print every case")
    args = parser.parse_args()
    config = RotationConfig.paper() if args.paper else RotationConfig()
    errors, seconds = [], []
    for case in draw_cases(args.cases, args.seed):
        begin = time.perf_counter()
        found = optimise_rotation(
            case.model, case.instance, case.view, Encoder(), config, (WIDTH, HEIGHT)
        )
        seconds.append(time.perf_counter() - begin)
        errors.append(abs(np.rad2deg(wrap(found.yaw - case.yaw))))
        if args.each:
            print(
                f"{case.model.category:20s} yaw {np.rad2deg(case.yaw):7.1f} error {errors[-1]:6.1f}"
            )
    e = np.array(errors)
    print("| cases | median | within 2° | within 5° | within 10° | flips | seconds, median |")
    print("|---|---|---|---|---|---|---|")
    shares = " | ".join(f"{100 * (e <= limit).mean():.0f} %" for limit in (2, 5, 10))
    print(
        f"| {len(e)} (seed {args.seed}) | {np.median(e):.2f}° | {shares} "
        f"| {int((e > 170).sum())} | {np.median(seconds):.1f} |"
    )


if __name__ == "__main__":
    main()
