"""DRO and TSA left out (Sec. 4.3): the reasoner's guesses in their place, and who cannot guess."""

from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from posing.remembering import digest, remembering

from generator import bundle
from generator.backends import Backends
from generator.backends.protocols import Reasoner
from generator.errors import BackendError, InputError
from generator.generation import STAGES, Ablation, Config
from generator.method.ablation import ask_rotations
from generator.method.alignment import ask_layout
from generator.pipeline import generate
from generator.scene import TABLE, Instance, LayoutBox, Reference, SizePrior, View

TEXT = "a desk with a mug and a pencil"


@pytest.fixture(scope="module")
def backends() -> Backends:
    """Embedded backends that answer equal questions only once for all tests."""
    return remembering(Backends.select("embedded"))


def test_an_unknown_stage_lists_those_that_can_be_left_out() -> None:
    wrong: Any = ("drow",)
    with pytest.raises(InputError, match=r"'drow'.*Did you mean 'dro'.*dro, tsa"):
        Config(without=wrong)
    assert Config(without=("tsa", "dro", "tsa")).without == ("dro", "tsa")
    assert Config().without == ()


@pytest.mark.slow
@pytest.mark.parametrize("without", [("dro",), ("tsa",), ("dro", "tsa")])
def test_a_stage_left_out_is_guessed_and_the_bundle_says_so(
    without: tuple[Ablation, ...], backends: Backends, tmp_path: Path
) -> None:
    made = generate(TEXT, backends, Config(without=without), seed=1)
    assert len(made.scene.objects) == 2
    assert made.refinement.placements == made.alignment.placements
    for rotation in made.rotations.values():
        steps = np.rad2deg(rotation.yaw - made.view.azimuth) / 15
        guessed = abs(steps - round(steps)) < 1e-6 and not rotation.candidates
        assert guessed == ("dro" in without)
    usual = {p.name: np.array_equal(p.scale, made.sizes[p.name].extent)
             for p in made.alignment.placements}  # fmt: skip
    assert all(usual.values()) == ("tsa" in without)
    assert (made.alignment.top_view is None) == ("tsa" in without)
    path = made.save(tmp_path / "scenes", allow_failed=True)
    assert bundle.load(path).provenance.config["without"] == list(without)
    assert (path / "top_view.png").is_file() == ("tsa" not in without)
    figures = {p.name for p in made.save_figures(tmp_path / "figures")}
    assert ("fig13_top_view.png" in figures) == ("tsa" not in without)
    assert "fig14_alignment.json" in figures


def test_a_reasoner_that_cannot_guess_is_refused_before_any_work() -> None:
    own = Backends.select("embedded").reasoner
    six = [name for name in vars(Reasoner) if not name.startswith("_")]
    plain = Backends.select(
        "embedded", reasoner=SimpleNamespace(**{n: getattr(own, n) for n in six})
    )
    begun = []
    with pytest.raises(BackendError, match="does not implement guess_rotations and guess_layout"):
        generate(TEXT, plain, Config(without=("dro",)), progress=lambda *told: begun.append(told))
    assert begun == []


class Guesses:
    """Returns given answers."""

    def __init__(self, yaws: Mapping[str, float], places: Mapping[str, LayoutBox]) -> None:
        self.yaws, self.places = yaws, places

    def guess_rotations(self, *_: Any) -> Mapping[str, float]:
        return self.yaws

    def guess_layout(self, *_: Any) -> Mapping[str, LayoutBox]:
        return self.places

    def stacking_order(self, *_: Any) -> Mapping[str, Any]:
        return {}


def guesses(yaws: Mapping[str, float]) -> Any:
    return Guesses(yaws, {})


REFERENCE = Reference(np.zeros((20, 20, 3), np.uint8))
VIEW = View(0.0, 0.9, 0.6)
SIZES = {n: SizePrior(n, np.array([0.1, 0.2, 0.3])) for n in (TABLE, "mug_1")}


def instances() -> tuple[Instance, ...]:
    mask, crop, box = np.ones((20, 20), bool), np.zeros((4, 4, 4), np.uint8), np.array([0, 0, 9, 9])
    return tuple(Instance(n, n, box, mask, crop, box) for n in SIZES)


@pytest.mark.parametrize("yaws", [{}, {"mug_1": float("nan")}])
def test_a_missing_yaw_is_a_backends_error(yaws: dict[str, float]) -> None:
    with pytest.raises(BackendError, match=r"guess_rotations.*'mug_1'"):
        ask_rotations(REFERENCE, instances(), SIZES, VIEW, guesses(yaws))


def test_a_yaw_is_wrapped() -> None:
    told = ask_rotations(REFERENCE, instances(), SIZES, VIEW, guesses({"mug_1": 7.0}))
    assert told["mug_1"].yaw == pytest.approx(7.0 - 2 * np.pi)
    assert set(told) == {"mug_1"}


def test_a_missing_place_is_a_backends_error() -> None:
    nothing = guesses({})
    with pytest.raises(BackendError, match=r"guess_layout.*'mug_1'"):
        ask_layout(REFERENCE, instances(), {}, SIZES, {}, VIEW, nothing, nothing)


def test_a_layout_box_has_positive_finite_sides() -> None:
    with pytest.raises(InputError, match="positive"):
        LayoutBox(np.zeros(2), np.array([0.1, 0.0, 0.1]))
    with pytest.raises(InputError):
        LayoutBox(np.array([np.nan, 0.0]), np.ones(3))


@pytest.mark.slow
def test_seconds_cover_all_stages(backends: Backends) -> None:
    made = generate(TEXT, backends, Config(without=("dro", "tsa")), seed=1)
    assert tuple(made.seconds) == STAGES
    assert made.seconds["assembly"].wall > 0


def test_equal_content_has_one_digest() -> None:
    a, b = SIZES["mug_1"], SizePrior("mug_1", np.array([0.1, 0.2, 0.3]))
    assert digest(a) == digest(b)
    assert digest(a) != digest(SIZES[TABLE])
    assert digest(((1, 2), 3)) != digest((1, (2, 3)))
    assert digest(np.zeros(4)) != digest(np.zeros((2, 2)))
