"""The whole method once, from a text and from a picture; and what it refuses."""

import dataclasses
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import torch
from extent import EXHAUSTIVE

from generator.backends import Backends
from generator.errors import InputError, SceneError, TabletopError
from generator.generation import STAGES, Config, Generation
from generator.method.figures import bundle_images, draw_stage
from generator.method.publish import WORSE
from generator.method.refinement import outline_misfit
from generator.method.rotation import RotationConfig
from generator.method.stopwatch import Seconds
from generator.pipeline import generate
from generator.scene import TABLE
from generator.scene.provenance import scene_name

LABELS = ["book", "laptop", "mug"] if EXHAUSTIVE else ["book", "mug"]
TEXT = "a wooden desk with a red mug" + (", a laptop" if EXHAUSTIVE else "") + " and a book"


@pytest.fixture(scope="module")
def from_text() -> Generation:
    return generate(TEXT, seed=3)


@pytest.mark.slow
def test_a_text_becomes_a_sound_scene(from_text: Generation) -> None:
    scene = from_text.scene
    assert scene.report is not None
    assert scene.report.passed, scene.report.failures
    assert scene.plan is not None
    assert len(scene.objects) == len(scene.plan.objects) == len(LABELS)
    assert sorted(o.label for o in scene.objects) == LABELS
    assert scene.provenance.kind == "text"
    assert scene.provenance.prompt == TEXT


@pytest.mark.slow
def test_every_intermediate_is_kept(from_text: Generation) -> None:
    names = {i.name for i in from_text.instances}
    assert TABLE in names
    assert set(from_text.models) == names
    assert set(from_text.sizes) == names
    assert set(from_text.rotations) == names - {TABLE}
    assert from_text.alignment.anchor in names - {TABLE}


@pytest.mark.slow
def test_the_reconstruction_keeps_the_arrangement(from_text: Generation) -> None:
    """Objects have the left-right order of their masks in the picture."""
    objects = {o.name: o.pose.position for o in from_text.scene.objects}
    feet = {
        i.name: ((i.box[0] + i.box[2]) / 2, i.box[3])
        for i in from_text.instances
        if i.name != TABLE
    }
    by_picture = sorted(feet, key=lambda n: feet[n][0])
    by_scene = sorted(objects, key=lambda n: objects[n][0])
    assert by_picture == by_scene


@pytest.mark.slow
def test_figures_and_bundle(from_text: Generation, tmp_path: Path) -> None:
    written = from_text.save_figures(tmp_path / "figures")
    assert {p.name for p in written} >= {"fig08_reference.png", "fig12_rotation.json"}
    assert all(p.stat().st_size > 0 for p in written)
    bundle = from_text.save(tmp_path / "scenes")
    assert (bundle / "scene.xml").is_file()
    kept = bundle_images(from_text.reference, from_text.alignment.top_view, from_text.scene)
    assert {p.name for p in bundle.glob("*.png")} == {f"{k}.png" for k in kept}


@pytest.mark.slow
def test_seconds_are_in_no_bundle(from_text: Generation, tmp_path: Path) -> None:
    slow = {stage: Seconds(60.0, 90.0) for stage in STAGES}
    later = dataclasses.replace(from_text, seconds=slow)
    first, second = from_text.save(tmp_path / "a"), later.save(tmp_path / "b")
    assert first.name == second.name
    names = sorted(p.relative_to(first) for p in first.rglob("*") if p.is_file())
    assert names
    assert all((first / n).read_bytes() == (second / n).read_bytes() for n in names)


MAKES = """
import sys
from generator.pipeline import generate
print(generate(sys.argv[1], seed=3).save(sys.argv[2]).name)
"""


@pytest.mark.slow
def test_no_byte_depends_on_how_many_threads_compute(from_text: Generation, tmp_path: Path) -> None:
    """A scene is the same on any number of cores, and in batch workers with one thread."""
    other = "3" if torch.get_num_threads() == 1 else "1"
    variables = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), other)
    made = subprocess.run(
        [sys.executable, "-c", MAKES, TEXT, str(tmp_path / "other")],
        env=os.environ | variables, capture_output=True, text=True, check=True, timeout=300,
    )  # fmt: skip
    assert made.stdout.split()[-1] == from_text.save(tmp_path / "here").name


@pytest.mark.slow
def test_a_picture_alone_is_enough(from_text: Generation) -> None:
    """The drawn picture is used again without its plan, as pixels only."""
    stages, ended = [], []
    begin = time.perf_counter()
    again = generate(
        np.asarray(from_text.reference.image),
        seed=3,
        progress=lambda stage, number, total: stages.append((stage, number, total)),
        watch=lambda stage, found: ended.append((stage, found)),
    )
    assert again.scene.plan is None
    assert again.scene.provenance.source_sha256
    assert again.scene.report is not None
    assert again.scene.report.passed, again.scene.report.failures
    assert len(again.scene.objects) == len(LABELS)
    whole = time.perf_counter() - begin
    assert [s for s, _, _ in stages] == list(again.seconds) == list(STAGES)
    assert 0.95 * whole < sum(s.wall for s in again.seconds.values()) < whole
    assert all(s.wall > 0 and s.cpu >= 0 for s in again.seconds.values())
    assert [s for s, _ in ended] == list(STAGES)
    known = [len(found) for _, found in ended]
    assert known == sorted(known) and known[-1] == len(dataclasses.fields(Generation)) - 2
    figures = {stem: stage for stage, found in ended for stem in draw_stage(stage, found)}
    assert {figures["fig09_detection"], figures["fig11_rotation"]} == {"extraction", "rotation"}
    before, after = again.scene.report.misfit or (0.0, 0.0)
    assert 0 < after <= before + WORSE
    shown = again.reference.image.shape[1::-1]
    there = outline_misfit(again.instances, again.scene.objects, again.view, shown, seed=3)
    assert after == pytest.approx(there, abs=1e-6), "the finished scene's, not the refinement's"


def test_a_text_is_reconstructed_with_less_effort_unless_told_otherwise() -> None:
    assert Config().for_text().rotation == RotationConfig.quick()
    told = Config(rotation=RotationConfig.paper())
    assert told.for_text() is told
    usual = Backends.select("embedded")
    quick = usual.for_text()
    assert quick.modeler != usual.modeler and quick.identity() == usual.identity()


@pytest.mark.parametrize("picture", ["white", "noise"])
def test_a_picture_without_a_table_is_refused(picture: str) -> None:
    rng = np.random.default_rng(0)
    image = np.full((300, 400, 3), 255, np.uint8)
    if picture == "noise":
        image = rng.integers(0, 255, (300, 400, 3)).astype(np.uint8)
    with pytest.raises((InputError, SceneError)):
        generate(image)


@pytest.mark.parametrize("text", ["", "   ", "x" * 10_000, "200 mugs", "机の上のマグカップ"])
def test_unusable_texts_are_refused(text: str) -> None:
    with pytest.raises(TabletopError):
        generate(text)


def test_scene_names_are_file_safe() -> None:
    assert scene_name("A mug, on/../a desk!") == "a-mug-on-a-desk"
    assert scene_name(None) == "picture"
    assert scene_name("机") == "scene"
    long = "a workbench in a robotics lab, a laptop in the middle"
    assert scene_name(long) == "a-workbench-in-a-robotics-lab-a-laptop", "no word is cut"
    assert scene_name("a" * 50) == "a" * 40
