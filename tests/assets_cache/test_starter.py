"""The bundles shipped with the package (made by ``python -m assets_cache.make_starter``)."""

from __future__ import annotations

from pathlib import Path

import pytest

import assets_cache
from assets_cache.make_starter import MOST_BYTES, PROMPTS
from generator.bundle import load, verify

THEMES = ("office", "dining", "kitchen", "coffee", "workbench", "craft", "vanity", "lab")


def shipped() -> list[Path]:
    return assets_cache.find(assets_cache.STARTER)


def test_every_theme_is_there_and_nothing_else() -> None:
    names = {path.name[:-13] for path in shipped()}
    assert names == set(PROMPTS)
    assert len(names) >= 12
    assert all(any(name.startswith(theme) for name in names) for theme in THEMES)


def test_they_are_sound_and_their_tables_differ() -> None:
    outlines = set()
    for path in shipped():
        assert verify(path) == []
        scene = load(path)
        assert scene.report is not None
        assert scene.report.passed
        assert len(scene.objects) >= 3
        assert scene.plan is not None
        outlines.add(scene.plan.table.outline)
    assert len(outlines) >= 3


def test_they_are_light() -> None:
    weight = sum(p.stat().st_size for b in shipped() for p in b.rglob("*") if p.is_file())
    assert weight <= MOST_BYTES


@pytest.mark.parametrize("name", sorted(PROMPTS))
def test_each_loads_in_plain_mujoco(name: str) -> None:
    import mujoco

    (path,) = assets_cache.find(name)
    model = mujoco.MjModel.from_xml_path(str(path / "scene.xml"))
    assert model.key("settled").qpos.shape == (model.nq,)
