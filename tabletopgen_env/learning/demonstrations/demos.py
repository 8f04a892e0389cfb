"""Grasp demonstrations: objects as observed by a policy, with the expert's grasps.

They are used to train a policy's grasp head (``networks.grasp_head``). No episode is played: the
expert lists its grasps of each object on a table at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

import numpy as np
from jaxtyping import Float32, UInt8

from generator.errors import BundleError, InputError, SceneError
from generator.geometry import rotation_yaw, rotation_z
from generator.io.bounded import read_arrays
from generator.io.files import write_file

from ...expert.planning.choice import choose
from ...expert.planning.grasps import plan_grasps
from ...goals.goal import Raised
from ...observations.height_map import CELLS, HeightLook
from ...robot.panda import Panda
from ...scenes.source import SceneSource
from ...tasks.candidates import liftable
from ...world.world import World
from ...world.worlds import WorldCache

COLUMNS = ("angle", "x", "y", "z", "opening", "width", "score")
"""Columns of a grasp. "angle" is the bearing, in radians, of the direction in which the fingers
open. "x", "y" and "z" are the tool's position in the target's heading frame, in metres from the
centre of the target's box (z from its lowest point). The other columns are as in ``Grasp``."""

CHUNK = 100
"""Number of tables per file of demonstrations."""

MOST = 200
"""The maximum number of grasps per object; the best grasps are kept."""

_MAX_BYTES = 512 * 2**20  # per file


@dataclass(frozen=True, eq=False)
class GraspShowing:
    """A demonstration: a policy's inputs ``maps`` and ``stands``, and the expert's grasps.

    ``maps`` are the first two maps of ``observations.height_map``. ``stands`` holds the position of
    the robot's base relative to the centre of the object's box (x, y, heading frame), the height of
    the box's lowest corner above the table top, and the height of the table top above the base, all
    in metres. ``grasps`` has the columns ``COLUMNS``: first the grasp that the expert chooses, then
    those with a lower score, best first. Grasps with a higher score that the arm cannot reach are
    left out.
    """

    maps: UInt8[np.ndarray, "2 48 48"]
    stands: Float32[np.ndarray, "4"]
    grasps: Float32[np.ndarray, "g 7"]


def showings(source: SceneSource, tables: int, seed: int) -> Iterator[list[GraspShowing]]:
    """Yield the demonstrations of ``tables`` random tables, one list per table."""
    rng, look = np.random.default_rng((seed, 6)), HeightLook()
    worlds = WorldCache(Panda(), 1)
    for _ in range(tables):
        try:
            world = worlds.get(source.draw(rng), lambda _: None)
            names = [name for name, why in liftable(world).items() if why is None]
        except SceneError:
            yield []
            continue
        world.reset()
        found = [showing(world, name, look) for name in names]
        yield [each for each in found if each is not None]


def showing(world: World, name: str, look: HeightLook) -> GraspShowing | None:
    """Return a demonstration for an object at its current pose, or None if it cannot be grasped."""
    plan = choose(world, name)
    if plan is None:
        return None
    center, heading = world.position(name), rotation_yaw(world.rotation(name))
    turn = rotation_z(-heading)
    planned = plan_grasps(world, name)
    first = next(k for k, g in enumerate(planned) if g.score <= plan.grasp.score)
    low = float(center[2] - np.abs(world.rotation(name)[2]) @ world.half_extent[world.index(name)])
    middle, table = np.array([*center[:2], low]), world.scene.table.height
    rows = [
        (g.angle - heading, *(turn @ (g.point - middle)), g.opening, g.width, g.score)
        for g in planned[first : first + MOST]
    ]  # fmt: skip
    base = turn @ (world.base_position - center)
    stands = np.array([*base[:2], low - table, table - world.base_position[2]], np.float32)
    maps = look.maps(world, Raised(name, center))[:2]
    return GraspShowing(maps, stands, np.array(rows, np.float32))


def gather(
    source: SceneSource, number: int, folder: Path, heed: Callable[[], None] | None = None
) -> list[GraspShowing]:
    """Return the demonstrations of chunk ``number``; generate and save them if they are missing.

    ``heed`` is called after each generated table.

    Raises:
        BundleError: the file is damaged.
        StorageError: the file cannot be written.
    """
    path = folder / f"showings-{number:03d}.npz"
    if not path.is_file():
        shown: list[GraspShowing] = []
        for each in showings(source, CHUNK, number):
            shown += each
            if heed is not None:
                heed()
        write_showings(shown, path)
    return read_showings(path)


def write_showings(shown: Sequence[GraspShowing], path: Path) -> None:
    """Write demonstrations to a file atomically; raise StorageError if it cannot be written."""
    content = BytesIO()
    np.savez_compressed(
        content,
        maps=np.array([one.maps for one in shown], np.uint8).reshape(-1, 2, CELLS, CELLS),
        stands=np.array([one.stands for one in shown], np.float32).reshape(-1, 4),
        grasps=np.concatenate([np.empty((0, 7), np.float32), *(one.grasps for one in shown)]),
        counts=np.array([len(one.grasps) for one in shown], np.int64),
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    write_file(content.getvalue(), path.with_suffix(".part")).replace(path)


def read_showings(path: Path) -> list[GraspShowing]:
    """Read a file of demonstrations; raise BundleError if it is damaged."""
    try:
        kept = read_arrays(path, "The file of demonstrations", InputError, max_bytes=_MAX_BYTES)
        maps, stands, grasps, counts = (kept[k] for k in ("maps", "stands", "grasps", "counts"))
        n, total = len(counts), int(counts.sum())
        shapes = (maps.shape, stands.shape, grasps.shape)
        if (
            shapes != ((n, 2, CELLS, CELLS), (n, 4), (total, len(COLUMNS)))
            or counts.min(initial=1) < 1
        ):
            raise ValueError(f"unexpected array shapes: {shapes}")
        if not (np.isfinite(stands).all() and np.isfinite(grasps).all()):
            raise ValueError("non-finite numbers")
    except (ValueError, KeyError, TypeError, InputError) as error:
        raise BundleError(
            f"{path} is not a valid file of demonstrations ({error}). Delete it."
        ) from error
    parts = np.split(grasps.astype(np.float32), np.cumsum(counts)[:-1]) if n else []
    return [GraspShowing(*row) for row in zip(maps, stands.astype(np.float32), parts, strict=True)]
