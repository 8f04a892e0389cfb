"""Make the pictures of the tasks: ``python docs/make_task_pictures.py [NAME ...]``.

Each is a strip of the scripted expert's episode at a shipped table, its instruction below. The
tables and seeds are fixed in ``STRIPS``; the episode is played twice, to know its length first.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from tabletopgen_env.episodes import Held
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.world.composition import FRONT_CAMERA

FOLDER = Path(__file__).parent / "images" / "tasks"

FRAMES, WIDTH, HEIGHT = 5, 320, 240
"""Pictures of a strip, and the size of each, pixels."""

MOST_BYTES = 150_000
"""No strip is larger."""

_FINE = 3  # how much larger frames are drawn than they are shown
_LINE = 28  # height of the caption, pixels
_HAND = 0.20  # metres above the things that stay in view
_MARGIN = 0.10  # metres around them
_NEAREST = 0.5  # least share of the camera's picture that is shown
_HOLD = 25  # steps for which a success has to hold; the hand draws back meanwhile


@dataclass(frozen=True)
class Strip:
    """A task, the table and seed of the episode, and options of its reset."""

    task: str
    scenes: str
    seed: int = 0
    preset: str | None = None
    options: dict[str, Any] = field(default_factory=dict)


STRIPS = {
    "reach": Strip("Reach", "coffee-square", seed=1),
    "lift": Strip("Lift", "coffee-square", options={"target": "candle_1"}),
    "push": Strip("Push", "office-desk", seed=1),
    "pick_place": Strip(
        "PickPlace", "kitchen-cutting", options={"target": "tomato_1", "goal": "bowl_1"}
    ),
    "stack": Strip("Stack", "office-desk"),
    "swap": Strip("Swap", "kitchen-cutting", seed=1),
    "sequence": Strip("Sequence", "coffee-square", seed=2),
    "sequence_kitchen": Strip("Sequence", "kitchen-task-3", preset="kitchen"),
    "sequence_coffee_table": Strip("Sequence", "coffee-table-task-2", preset="coffee_table"),
    "tidy": Strip("Tidy", "tidy-task-1"),
}
"""What is shown, by the name of the picture."""


def make_env(strip: Strip, **settings: Any) -> gym.Env:
    """Return the environment of a strip."""
    more: dict[str, Any] = {"preset": strip.preset} if strip.preset else {}
    name = f"tabletopgen_env:TabletopGen/{strip.task}-v0"
    return gym.make(name, scenes=strip.scenes, **more, **settings)


def play(env: gym.Env, strip: Strip, shown: list[int] | None = None) -> tuple[int, list[Any]]:
    """Play until the hand has drawn back; return when it was done, and pictures at steps ``shown``.

    Raises:
        SystemExit: the expert does not solve it.
    """
    env.reset(seed=strip.seed, options=strip.options or None)
    expert = TaskExpert(env)
    expert.reset()
    pictures = [env.render()] if shown else []
    held, solved, truncated, steps = Held(_HOLD), False, False, 0
    while not (solved or truncated):
        _, _, _, truncated, info = env.step(expert.act())
        solved = held.after(info)
        steps += 1
        if shown and steps in shown:
            pictures.append(env.render())
    if not solved:
        raise SystemExit(f"The expert did not solve {strip}: choose another table or seed.")
    return steps - _HOLD, pictures


def window(env: Any) -> tuple[float, float, float, float]:
    """Return what part of the picture shows all that the goals are about: x0, y0, x1, y1 in [0, 1].

    To be called at the start of an episode.
    """
    world = env.unwrapped.world
    places: list[Float[np.ndarray, "3"]] = []
    for goal in env.unwrapped.episode.goals:
        region = goal.region(world)
        places.append(region.center)
        if goal.target is None:
            places.append(world.data.site_xpos[world.tcp].copy())
        for name in (goal.target, goal.reference):
            if name is not None:
                outline = world.footprints[name]
                low = np.full((len(outline), 1), world.scene.table.height)
                places.extend(np.hstack([outline, low]))
    points = np.array(places)
    low, high = points.min(0) - _MARGIN, points.max(0) + _MARGIN
    high[2] = max(world.scene.table.height + _HAND, points[:, 2].max())
    corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1])
                        for z in (world.scene.table.height, high[2])])  # fmt: skip
    return _box(project(world, corners))


def project(world: Any, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 2"]:
    """Return where the front camera sees points, x and y in [0, 1] of a 4:3 picture."""
    camera = world.model.camera(FRONT_CAMERA).id
    seen = (points - world.data.cam_xpos[camera]) @ world.data.cam_xmat[camera].reshape(3, 3)
    half = np.tan(np.deg2rad(world.model.cam_fovy[camera]) / 2)
    x, y = seen[:, 0] / -seen[:, 2], seen[:, 1] / -seen[:, 2]
    return np.column_stack([0.5 + x / half * HEIGHT / WIDTH / 2, 0.5 - y / half / 2])


def _box(at: Float[np.ndarray, "n 2"]) -> tuple[float, float, float, float]:
    """Return the smallest part of the picture, of its own shape, around points."""
    low, high = at.min(0), at.max(0)
    side = min(max(float((high - low).max()), _NEAREST), 1.0)
    start = np.clip((low + high - side) / 2, 0.0, 1.0 - side)
    return float(start[0]), float(start[1]), float(start[0]) + side, float(start[1]) + side


def strip_picture(
    frames: list[UInt8[np.ndarray, "h w 3"]],
    part: tuple[float, float, float, float],
    caption: str,
) -> Image.Image:
    """Lay the same part of frames side by side, a caption below, in few colours."""
    sheet = Image.new("RGB", (len(frames) * (WIDTH + 4) - 4, HEIGHT + _LINE), "white")
    for k, frame in enumerate(frames):
        full = Image.fromarray(frame)
        x0, y0, x1, y1 = (v * side for v, side in zip(part, full.size * 2, strict=True))
        cut = full.resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS, (x0, y0, x1, y1))
        sheet.paste(cut, (k * (WIDTH + 4), 0))
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(19)
    draw.text((sheet.width / 2, HEIGHT + 4), caption, (40, 44, 52), font, anchor="mt")
    palette = sheet.quantize(256, Image.Quantize.MAXCOVERAGE)
    return sheet.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)  # the haze is smooth


def make(name: str, out: Path) -> Path:
    """Write one strip into a folder; return where."""
    strip = STRIPS[name]
    env = make_env(strip)
    done, _ = play(env, strip)
    _, info = env.reset(seed=strip.seed, options=strip.options or None)
    part = window(env)
    caption = info["instruction"]
    env.close()
    size = (HEIGHT * _FINE, WIDTH * _FINE)
    env = make_env(strip, render_mode="rgb_array", render_size=size)
    shown = [*np.linspace(0, done, FRAMES - 1).round().astype(int).tolist(), done + _HOLD]
    _, frames = play(env, strip, shown)
    env.close()
    out.mkdir(parents=True, exist_ok=True)
    path = out / f"{name}.png"
    strip_picture(frames, part, caption).save(path, optimize=True)
    print(f"{path}: {done} steps, {path.stat().st_size / 1000:.0f} kB: {caption}", flush=True)
    if path.stat().st_size > MOST_BYTES:
        raise SystemExit(f"{path} is larger than {MOST_BYTES} bytes.")
    return path


def main() -> None:
    """Write the strips named, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(STRIPS)}")
    parser.add_argument("--out", type=Path, default=FOLDER, help="folder of the strips")
    args = parser.parse_args()
    names: list[str] = args.names
    if unknown := sorted({*names} - {*STRIPS}):
        parser.error(f"There is no strip {unknown[0]!r}; there are {', '.join(STRIPS)}.")
    for name in names or STRIPS:
        make(name, args.out)


if __name__ == "__main__":
    main()
