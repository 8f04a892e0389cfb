"""Edits of finished scenes: changed parts, unchanged parts, and rejections."""

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from changed import kept

import assets_cache
from generator import bundle, editing
from generator.errors import BundleError, InputError, PlaceError
from generator.physics.gate import judge

DESK = {"laptop_1", "computer_mouse_1", "notebook_1", "pen_1", "mug_1", "stapler_1"}


@pytest.fixture(scope="module")
def desk() -> Path:
    (path,) = assets_cache.find("office-desk")
    return path


@pytest.fixture(scope="module")
def swapped(desk: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    edited = editing.swap(desk, "mug_1", "a small teapot", 3)
    return edited.save(tmp_path_factory.mktemp("swapped"))


@pytest.mark.slow
def test_a_swap_touches_one_thing(desk: Path, swapped: Path) -> None:
    assert kept(desk, swapped) == DESK - {"mug_1"}
    before, after = bundle.load(desk), bundle.load(swapped)
    (new,) = {o.name for o in after.objects} - DESK
    assert after.object(new).model.category == "teapot"
    apart = after.object(new).pose.position[:2] - before.object("mug_1").pose.position[:2]
    assert np.linalg.norm(apart) < 0.02
    assert bundle.verify(swapped) == []
    assert judge(after).failures == ()


@pytest.mark.slow
def test_provenance_is_chained(desk: Path, swapped: Path, tmp_path: Path) -> None:
    edited = editing.add(swapped, "a red mug behind the notebook")
    twice = edited.save(tmp_path)
    scene = bundle.load(twice)
    first, second = scene.provenance.edits
    for edit, path in ((first, desk), (second, swapped)):
        assert edit.edited == hashlib.sha256((path / "scene.json").read_bytes()).hexdigest()
    assert (first.kind, first.names, first.seed) == ("swap", ("mug_1", "teapot_1"), 3)
    assert (second.kind, second.asked) == ("add", "a red mug behind the notebook")
    assert scene.provenance.prompt == bundle.load(desk).provenance.prompt

    assert kept(swapped, twice) == {o.name for o in bundle.load(swapped).objects}
    mug, notebook = scene.object(second.names[0]), scene.object("notebook_1")
    front = mug.pose.position[1] - mug.scale[1] / 2
    assert front > notebook.pose.position[1] + notebook.scale[1] / 4
    assert scene.plan is not None
    assert {o.name for o in scene.plan.objects} == {o.name for o in scene.objects}
    assert scene.plan.objects[-1].attributes == {"color": "red"}


@pytest.mark.slow
def test_restyling_keeps_size_and_all_else(desk: Path, tmp_path: Path) -> None:
    path = editing.restyle(desk, "low-poly", ["mug_1"]).save(tmp_path)
    assert kept(desk, path) == DESK - {"mug_1"}
    before, after = bundle.load(desk).object("mug_1"), bundle.load(path).object("mug_1")
    assert len(after.model.mesh.faces) < len(before.model.mesh.faces)
    assert np.allclose(after.scale, before.scale, rtol=0.05)
    assert np.allclose(after.pose.position, before.pose.position, atol=0.01)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("edit", "error", "words"),
    [
        (lambda b: editing.swap(b, "mug", "a teapot"), InputError, "Did you mean 'mug_1'"),
        (lambda b: editing.swap(b, "table", "a teapot"), InputError, "table cannot be edited"),
        (lambda b: editing.swap(b, "mug_1", "a clavichord"), InputError, "clavichord"),
        (lambda b: editing.swap(b, "mug_1", "  "), InputError, "empty"),
        (
            lambda b: editing.swap(b, "mug_1", "a vase left of the pen"),
            InputError,
            "contains a position",
        ),
        (
            lambda b: editing.add(b, "a clavichord left of the laptop"),
            InputError,
            "no 'clavichord'",
        ),
        (lambda b: editing.add(b, "a mug next to the teapot"), InputError, "no teapot on the"),
        (lambda b: editing.add(b, "a mug and a vase"), InputError, "several objects"),
        (lambda b: editing.remove(b, "stapler"), InputError, "Did you mean 'stapler_1'"),
        (lambda b: editing.move(b, "mug_1"), InputError, "Specify a position"),
        (lambda b: editing.move(b, "mug_1", (float("nan"), 0.0)), InputError, "finite"),
        (lambda b: editing.move(b, "mug_1", "nowhere"), InputError, "nowhere"),
        (lambda b: editing.move(b, "mug_1", (3.0, 0.0)), PlaceError, "off the table"),
        (lambda b: editing.restyle(b, "low poly"), InputError, "Did you mean 'low-poly'"),
        (lambda b: editing.restyle(b, "cartoon", ["cup"]), InputError, "no object 'cup'"),
        (lambda b: editing.remove(b / "nothing", "mug_1"), BundleError, "no bundle"),
    ],
)
def test_what_cannot_be_done_is_refused(
    desk: Path, edit: Callable[[Path], Any], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        edit(desk)


@pytest.mark.slow
def test_a_taken_place_names_the_nearest_free_one(desk: Path) -> None:
    laptop = bundle.load(desk).object("laptop_1").pose.position
    with pytest.raises(PlaceError, match=r"in the way. The nearest free position is ") as e:
        editing.move(desk, "mug_1", (laptop[0], laptop[1]))
    assert e.value.reason == "occupied"
    assert e.value.free is not None
    assert str(e.value).endswith("is ({:.3f}, {:.3f}) m.".format(*e.value.free))
    edited = editing.move(desk, "mug_1", e.value.free)
    assert edited.scene.report is not None
    assert edited.scene.report.passed
