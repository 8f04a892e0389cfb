"""Edits by backends: the object is drawn, cut out, modelled and rotated through the protocols."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from changed import kept
from toy import cube_mesh, toy_object, toy_scene

from generator import bundle, editing
from generator.backends import Backends
from generator.bundle import Segments
from generator.geometry import mask_box
from generator.physics.gate import judge
from generator.scene import (
    Detection,
    Instance,
    Model,
    PlannedObject,
    PlannedTable,
    ScenePlan,
    SizePrior,
    View,
)

pytestmark = pytest.mark.usefixtures("small")
PICTURE = np.full((60, 80, 3), 255, np.uint8)
VIEW = View(0.0, 0.9, 0.6)


def seen(label: str, rows: slice, columns: slice) -> Detection:
    mask = np.zeros(PICTURE.shape[:2], bool)
    mask[rows, columns] = True
    return Detection(label, mask_box(mask), mask)


@dataclass(frozen=True)
class Painter:
    """Answers all requests about a banjo, and records them."""

    name: str = "painter"
    asked: list[str] = field(default_factory=list, repr=False)

    def plan_scene(self, prompt: str, seed: int) -> ScenePlan:
        self.asked.append("plan_scene")
        return ScenePlan(prompt, PlannedTable(), (PlannedObject("banjo_1", "banjo", "generic"),))

    def draw(self, plan: ScenePlan, seed: int) -> np.ndarray:
        self.asked.append("draw")
        assert [o.noun for o in plan.objects] == ["banjo"]
        return PICTURE

    def list_objects(self, reference: Any) -> tuple[str, ...]:
        return ("table", "banjo")

    def segment(self, *about: Any) -> tuple[Detection, ...]:
        table = seen("table", slice(5, 55), slice(5, 75))
        return table, seen("banjo", slice(20, 40), slice(25, 55))

    def complete(self, reference: Any, detection: Detection, others: Any) -> Instance:
        self.asked.append(f"complete {detection.label}")
        crop = np.full((32, 32, 4), 255, np.uint8)
        d = detection
        return Instance(d.label, d.label, d.box, d.mask, crop, d.box)

    def estimate_view(self, *about: Any) -> View:
        return VIEW

    def estimate_sizes(self, reference: Any, instances: Any, view: View) -> dict[str, SizePrior]:
        return {i.name: SizePrior(i.name, np.array([0.2, 0.08, 0.05])) for i in instances}

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        self.asked.append(f"model {instance.label}")
        return Model(instance.name, instance.label, cube_mesh(), np.asarray(size.extent))

    def review_orientation(self, *about: Any) -> tuple[()]:
        return ()

    def features(self, images: torch.Tensor) -> tuple[torch.Tensor, ...]:
        return (images,)

    def stacking_order(self, *about: Any) -> Any:
        raise AssertionError

    top_view = stacking_order


@pytest.fixture
def pictured(tmp_path: Path) -> Path:
    """A bundle with its input picture and detections."""
    scene = toy_scene(
        (
            toy_object("ukulele_1", (0.18, 0.07, 0.05), (-0.2, 0.0), yaw=0.3),
            toy_object("can_1", (0.06, 0.06, 0.1), (0.2, 0.0), kind="cylinder"),
        )
    )
    table = np.ones((4, 6), bool)
    things = [
        Instance(name, name, np.array([0.0, 0, 6, 4]), table, np.zeros((2, 2, 4)), np.zeros(4))
        for name in ("table", "ukulele_1")
    ]
    return bundle.save(
        scene.replace(report=judge(scene)), tmp_path / "before",
        images={"reference": PICTURE, "preview": PICTURE}, segments=Segments.of(things),
    )  # fmt: skip


@pytest.mark.slow
def test_only_the_new_thing_is_asked_for(pictured: Path, tmp_path: Path) -> None:
    painter = Painter()
    roles = ("reasoner", "imager", "segmenter", "modeler", "encoder")
    backends = Backends.select(**dict.fromkeys(roles, painter))
    done = editing.swap(pictured, "ukulele_1", "a banjo", 5, backends)
    assert painter.asked == ["plan_scene", "draw", "complete table", "complete banjo",
                             "model banjo"]  # fmt: skip
    path = done.save(tmp_path / "after")
    assert kept(pictured, path) == {"can_1"}
    scene = bundle.load(path)
    banjo = scene.object("banjo_1")
    assert banjo.label == "banjo"
    assert np.allclose(banjo.scale, [0.2, 0.08, 0.05])
    assert abs(np.sin(banjo.placement.yaw - 0.3)) < 1e-6  # it lies as the ukulele did
    (edit,) = scene.provenance.edits
    assert edit.seed == 5
    assert edit.backends["imager"]["name"] == "painter"


def test_the_picture_and_what_was_found_in_it_are_kept(pictured: Path, tmp_path: Path) -> None:
    path = editing.remove(pictured, "ukulele_1").save(tmp_path / "after")
    assert (path / "reference.png").read_bytes() == (pictured / "reference.png").read_bytes()
    assert (path / "preview.png").read_bytes() != (pictured / "preview.png").read_bytes()
    before, after = bundle.load_segments(pictured), bundle.load_segments(path)
    assert before is not None
    assert after is not None
    assert after.names == before.names
    assert (after.index == before.index).all()
