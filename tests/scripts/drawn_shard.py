"""A shard with one picture for the eye's benchmark, drawn without OpenGL."""

from pathlib import Path

import numpy as np
from posing.truth import photograph

from generator.composition import compose
from research.eye.sample import BACKGROUND, OBJECT, TOP, Sample
from research.eye.shards import ShardWriter
from tabletop_objects import CATEGORIES


def write_shard(path: Path) -> None:
    """Write a shard with a composed table's picture and its annotations."""
    keys = tuple(sorted(CATEGORIES))
    truth = photograph("", compose("a mug and an apple on a desk", 0), np.random.default_rng(0))
    things = truth.scene.objects
    visible = np.maximum(truth.ids, 0).astype(np.uint8)
    region = np.where(visible > 0, OBJECT, np.where(truth.ids == 0, TOP, BACKGROUND))
    count = len(things)
    sample = Sample(
        image=truth.picture, visible=visible,
        full=np.array([visible == k + 1 for k in range(count)]),
        category=np.array([keys.index(o.model.category) for o in things], np.int16),
        region=region.astype(np.uint8), top=np.asarray(region != BACKGROUND),
        outline=np.zeros((0, 2), np.float32), view=truth.view, focal=1000.0,
        yaw=np.zeros(count, np.float32), upright=np.ones(count, bool),
        size=np.array([o.scale for o in things], np.float32),
        position=np.array([o.pose.position for o in things], np.float32),
        support=np.zeros(count, np.int16), depth=np.ones(visible.shape, np.float16),
    )  # fmt: skip
    with ShardWriter(path, keys) as writer:
        writer.add(sample)
