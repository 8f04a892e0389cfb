"""A swap at each of five starter tables: one object changes, everything else is identical."""

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from changed import kept
from extent import part_of

import assets_cache
from generator import bundle, editing
from generator.backends import Backends
from generator.generation import Config
from generator.method.rotation.config import RotationConfig
from generator.physics.gate import judge

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("small")]

SWAPS = {
    "coffee-oval": ("plate_1", "a small teapot", "teapot"),
    "lab": ("notebook_1", "a mug", "mug"),
    "vanity": ("hand_mirror_1", "a candle", "candle"),
    "kitchen-cutting": ("bowl_1", "a wine glass", "wine glass"),
    "workbench-toys": ("bowl_1", "a mug", "mug"),
}
"""By starter: what goes, what is asked for, and what then stands there."""

QUICK = Config(
    rotation=RotationConfig(
        coarse_step=np.deg2rad(15.0), candidates=2, coarse_steps=0, steps=5, rival_steps=2,
        close_steps=0, points=1000,
    )
)  # fmt: skip
"""A coarse search for the yaw of what was drawn; nothing else is left out."""


# What is drawn differs by what is asked for: a hollow mug, and a candle at a round table.
@pytest.mark.parametrize(
    ("starter", "backend"),
    part_of(product(SWAPS, [None, "embedded"]),
            *((starter, None) for starter in SWAPS), ("lab", "embedded"), ("vanity", "embedded")),
)  # fmt: skip
def test_a_swap_at_a_starter_keeps_all_else(
    starter: str, backend: str | None, tmp_path: Path
) -> None:
    (before,) = assets_cache.find(starter)
    old, text, noun = SWAPS[starter]
    backends = None if backend is None else Backends.select(backend)
    after = editing.swap(before, old, text, 1, backends, QUICK).save(tmp_path)
    names = {o.name for o in bundle.load(before).objects}
    scene = bundle.load(after)
    assert kept(before, after) == names - {old}
    (new,) = {o.name for o in scene.objects} - (names - {old})
    assert scene.object(new).label == noun
    assert bundle.verify(after) == []
    assert scene.report is not None and scene.report.passed
    assert judge(scene).failures == ()
    assert (scene.provenance.edits[-1].kind, scene.provenance.edits[-1].asked) == ("swap", text)
