"""Regeneration of the shipped bundles: unchanged ones keep their certificates."""

import shutil
from collections.abc import Mapping
from pathlib import Path

import pytest
from toy import toy_object, toy_scene

from assets_cache import make_starter
from assets_cache.make_starter import Recipe, keep_certificates, remake
from generator.bundle import save
from tabletopgen_env.certificates.certificate import (
    FILE,
    Certificate,
    TaskInstance,
    Terms,
    read_certificate,
    scene_digest,
    write_certificate,
)


def make(folder: Path, recipes: Mapping[str, Recipe]) -> list[Path]:
    """Make bundles of a cube positioned by the seed, instead of composed ones."""
    paths = []
    for name, (_, seed) in recipes.items():
        scene = toy_scene((toy_object("cube_1", (0.04, 0.04, 0.04), (0.01 * seed, 0.0)),))
        paths.append(save(scene.replace(name=name), folder, allow_failed=True))
    return paths


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two bundles, one of them certified."""
    monkeypatch.setattr(make_starter, "make", make)
    remake(tmp_path, {"starter": {"desk": ("", 0), "lab": ("", 1)}})
    certify(named("desk", tmp_path))
    return tmp_path


def named(name: str, here: Path) -> Path:
    [path] = (here / "starter").glob(f"{name}-*")
    return path


def certify(path: Path) -> None:
    instance = TaskInstance("Lift", "cube_1", None, 10, 10)
    write_certificate(path, Certificate(scene_digest(path), Terms(("Lift",)), {}, (instance,)))


def test_a_bundle_that_stays_the_same_keeps_it(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = (named("desk", here) / FILE).read_bytes()
    remake(here, {"starter": {"desk": ("", 0)}})
    assert [p.name for p in (here / "starter").iterdir()] == [named("desk", here).name]
    assert (named("desk", here) / FILE).read_bytes() == before
    assert "1 keep their certificates" in capsys.readouterr().out


def test_another_bundle_does_not_get_it(here: Path) -> None:
    remake(here, {"starter": {"desk": ("", 3)}})
    assert read_certificate(named("desk", here)) is None


@pytest.mark.parametrize("text", ["{", None])
def test_what_does_not_fit_is_left_behind(
    text: str | None, here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    new = shutil.copytree(here / "starter", here / "new", ignore=lambda *_: {FILE})
    foreign = named("lab", here) / FILE  # that of the desk, or what is none
    foreign.write_text((named("desk", here) / FILE).read_text() if text is None else text)
    assert keep_certificates(here / "starter", new) == 1
    assert [p.name[:-13] for p in new.iterdir() if (p / FILE).exists()] == ["desk"]
    assert "not kept" in capsys.readouterr().out
    assert keep_certificates(here / "none", new) == 0
