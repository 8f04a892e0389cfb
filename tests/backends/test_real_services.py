"""Real services and installed models; paid calls only with an explicit budget.

    TABLETOPGEN_TEST_BUDGET=2 pytest -m real tests/backends/test_real_services.py

asks the cloud whose key is in the environment, and Tencent's where its keys are, for no more than
that together, in the currency of the price table. A local Hunyuan3D server is asked where
``TABLETOPGEN_HUNYUAN3D_URL`` says where it is, an installed model where its package is there.
"""

import os
from importlib.util import find_spec
from typing import Any

import numpy as np
import pytest
from painted import as_shown, detections, paint

from generator.backends import Backends
from generator.backends.cloud.server import configuration
from generator.backends.modelers.ai3d import SECRET_ID, SECRET_KEY
from generator.backends.modelers.hunyuan3d import ADDRESS
from generator.backends.modelers.sam3d import HOME
from generator.calls import Session
from generator.calls.store import CallStore
from generator.physics.inertia import is_watertight
from generator.render.crop import in_reference, tight_box
from generator.scene import TABLE, Detection, Instance, Reference, SizePrior, View

pytestmark = pytest.mark.real

BUDGET = "TABLETOPGEN_TEST_BUDGET"
ELEVATION, FOV = 52.0, 36.0
PLACES = [("mug", -0.3, -0.1, 0.0), ("book", 0.1, 0.0, 0.0), ("apple", 0.35, -0.15, 0.0)]
NAMES = (TABLE, "mug_1", "book_1", "apple_1")
USUAL = {TABLE: (1.2, 0.7, 0.74), "mug_1": (0.12, 0.09, 0.1), "book_1": (0.15, 0.21, 0.03),
         "apple_1": (0.08, 0.08, 0.08)}  # fmt: skip


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Session:
    """The session of all calls, with their cost limit."""
    budget = float(os.environ.get(BUDGET, "0"))
    return Session(store=CallStore(tmp_path_factory.mktemp("calls")), budget=budget)


@pytest.fixture(scope="module")
def cloud(session: Session) -> Backends:
    keys = configuration.key_variables(configuration.chat_base_url(), "chat")
    if BUDGET not in os.environ or not any(os.environ.get(key) for key in keys):
        pytest.skip(f"set {BUDGET}, and one of {', '.join(keys)}")
    return Backends.select("embedded", session=session, reasoner="cloud", imager="cloud")


@pytest.fixture(scope="module")
def desk() -> tuple[Reference, dict[str, Detection]]:
    """A painted table with three objects, and their positions."""
    picture = paint("rectangle", "oak", PLACES, elevation=ELEVATION)
    return Reference(picture.image), detections(picture, NAMES)


@pytest.fixture(scope="module")
def instances(desk: Any) -> tuple[Instance, ...]:
    """The visible part of each object."""
    reference, found = desk
    return tuple(as_shown(reference.image, name, d) for name, d in found.items())


VIEW = View(0.0, float(np.deg2rad(ELEVATION)), float(np.deg2rad(FOV)))


def test_the_cloud_plans_and_draws_a_table(cloud: Backends) -> None:
    plan = cloud.reasoner.plan_scene("a desk with a mug left of a book", 0)
    assert {"mug", "book"} <= {thing.noun for thing in plan.objects}
    drawn = cloud.imager.draw(plan, 0)
    assert drawn.dtype == np.uint8 and drawn.shape[2] == 3 and drawn.std() > 10


def test_the_cloud_reads_a_picture(cloud: Backends, desk: Any, instances: Any) -> None:
    reference, _ = desk
    labels = cloud.reasoner.list_objects(reference)
    assert TABLE in labels and {"mug", "book", "apple"} <= set(labels)
    view = cloud.reasoner.estimate_view(reference, instances[0])
    assert np.rad2deg(view.elevation) == pytest.approx(ELEVATION, abs=20)
    sizes = cloud.reasoner.estimate_sizes(reference, instances, VIEW)
    for name, usual in USUAL.items():
        near = np.sort(sizes[name].extent) / np.sort(usual)
        assert ((near > 1 / 3) & (near < 3)).all(), (name, sizes[name].extent)
    stacking = cloud.reasoner.stacking_order(reference, instances, VIEW)
    assert {stacking[name].on for name in NAMES[1:]} == {TABLE}


def test_the_cloud_completes_a_thing(cloud: Backends, desk: Any) -> None:
    reference, found = desk
    others = tuple(d for name, d in found.items() if name != "mug_1")
    made = cloud.imager.complete(reference, found["mug_1"], others)
    assert {0, 255} <= set(np.unique(made.crop[..., 3]).tolist())
    box = found["mug_1"].box
    there = in_reference(made, tight_box(made))
    np.testing.assert_allclose(there, box, atol=0.3 * float((box[2:] - box[:2]).max()))


HERE = {
    "hunyuan3d": (f"set {ADDRESS}", lambda: ADDRESS in os.environ),
    "tencent": (
        f"set {BUDGET}, {SECRET_ID} and {SECRET_KEY}",
        lambda: all(name in os.environ for name in (BUDGET, SECRET_ID, SECRET_KEY)),
    ),
    "trellis": ("install TRELLIS", lambda: find_spec("trellis") is not None),
    "triposr": ("install TripoSR", lambda: find_spec("tsr") is not None),
    "sam3d": (f"set {HOME}", lambda: HOME in os.environ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", HERE)
def test_a_modeler_makes_a_mug(name: str, session: Session, instances: Any) -> None:
    how, there = HERE[name]
    if not there():
        pytest.skip(how)
    mug = instances[1]
    chosen = Backends.select("embedded", session=session, modeler=name)
    made = chosen.modeler.model(mug, SizePrior("mug_1", np.array(USUAL["mug_1"])), VIEW)
    assert made.label == "mug" and is_watertight(made.mesh)
    assert 100 < len(made.mesh.faces) <= 24_000 and max(made.mesh.texture.shape) <= 2048
    near = np.sort(made.size) / np.sort(USUAL["mug_1"])
    assert ((near > 0.5) & (near < 2)).all()
    seen = mug.crop[mug.crop[..., 3] > 0][:, :3].mean(0)
    assert np.abs(made.mesh.texture[..., :3].reshape(-1, 3).mean(0) - seen).max() < 90
