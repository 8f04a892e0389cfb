"""Requests about many objects: parallel to a server, sequential for local computation."""

import dataclasses
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from asking import Asking, slow_server

from generator.backends import Backends
from generator.calls import Session
from generator.geometry import mask_box
from generator.method.extraction import extract
from generator.method.models import make_models
from generator.scene import Detection, Reference, SizePrior, View

IMAGE = np.full((60, 160, 3), 255, np.uint8)
VIEW = View(0.0, 0.9, 0.6)


def detection(label: str, x: int) -> Detection:
    mask = np.zeros(IMAGE.shape[:2], bool)
    mask[10:30, x : x + 15] = True
    return Detection(label, mask_box(mask), mask)


@dataclasses.dataclass(frozen=True)
class Here:
    """A reasoner and segmenter with a table and six objects, which records its callers."""

    asked_by: list[threading.Thread] = dataclasses.field(default_factory=list)

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        return ("mug",)

    def segment(self, image: Any, labels: Any, *measured: Any) -> tuple[Detection, ...]:
        return (detection("table", 140), *(detection("mug", 20 * k) for k in range(6)))

    def review_orientation(self, mesh: Any, instance: Any, size: Any) -> tuple[()]:
        self.asked_by.append(threading.current_thread())
        return ()

    def plan_scene(self, *known: Any) -> Any:
        raise AssertionError

    estimate_view = estimate_sizes = stacking_order = plan_scene


def backends(session: Session, url: str) -> Backends:
    asking, here = Asking(url, session), Here()
    return Backends.select(reasoner=here, segmenter=here, imager=asking, modeler=asking)


def extracted(b: Backends) -> Any:
    return extract(
        Reference(IMAGE), b.reasoner, b.segmenter, b.imager, complete_each=b.each("imager")
    )[1]


def modelled(b: Backends) -> Any:
    things = tuple(
        dataclasses.replace(Still("").complete(Reference(IMAGE), d, ()), name=f"mug_{k}")
        for k, d in enumerate(b.segmenter.segment(IMAGE, ()))
    )
    sizes = {thing.name: SizePrior(thing.name, np.full(3, 0.1)) for thing in things}
    return make_models(
        Reference(IMAGE), things, sizes, VIEW, b.modeler, b.reasoner,
        model_each=b.each("modeler"), review_each=b.each("reasoner"),
    )  # fmt: skip


class Still(Asking):
    """Returns answers without requests."""

    def _ask(self, question: str, about: list[int]) -> None:
        pass


@pytest.mark.parametrize("stage", [extracted, modelled])
def test_six_things_are_asked_about_at_once(stage: Callable[[Backends], Any]) -> None:
    peaks, made = [], []
    for workers in (1, 8):
        with slow_server(0.3) as server:
            made.append(stage(backends(Session(workers=workers), server.url)))
        peaks.append(server.peak)
    assert peaks[0] == 1 and peaks[1] >= 6
    names = [[getattr(m, "name", m) for m in each] for each in made]
    assert names[0] == names[1] and len(names[0]) == 7


def test_a_reasoner_here_is_asked_in_turn_beside_a_modeler_elsewhere() -> None:
    with slow_server(0.0) as server:
        b = backends(Session(), server.url)
        modelled(b)
    assert isinstance(b.reasoner, Here)
    assert set(b.reasoner.asked_by) == {threading.current_thread()}
    assert len(b.reasoner.asked_by) == 7


def test_an_error_about_one_thing_is_the_stage_s() -> None:
    b = backends(Session(attempts=1), "http://127.0.0.1:9")
    with pytest.raises(Exception, match=r"slow, complete.*cannot be reached"):
        extracted(b)
