"""Imports do not depend on the names of objects."""

from pathlib import Path

import pytest
from foreign_models import TABLE, write

from generator.imports import ImportOptions, import_scene

NAMES = [
    ("cube", "tower"), ("the", "moved"), ("turned", "my tower"), ("on a leaning table", "cube"),
    ("tower overlaps", "tower"), ("1.0 mm", "floats"),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("sound", "sunk"), NAMES)
def test_what_fails_is_left_out_whatever_it_is_called(
    sound: str, sunk: str, tmp_path: Path
) -> None:
    """The second object is a pin that tips when gravity leans."""
    path = write(
        tmp_path,
        TABLE + f'<body name="{sound}" pos="1 2 .77"><freejoint/>'
        '<geom type="box" size=".03 .03 .03"/></body>'
        f'<body name="{sunk}" pos="1.2 2.1 .94"><freejoint/>'
        '<geom type="box" size=".002 .002 .2"/></body>',
    )  # fmt: skip
    scene = import_scene(path, ImportOptions(drop_failing=True, lean=2.0))
    assert [o.name for o in scene.objects] == [sound]
    assert scene.report is not None
    assert scene.report.passed and scene.report.dropped == (sunk,)
