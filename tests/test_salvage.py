"""A scene that fails its gate gives up what spoils it, and says so."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from generator.errors import InputError
from generator.generation import Config
from generator.method.salvage import allowance, misfit, salvaged, without
from generator.method.supplement import NOTHING, Supplement
from generator.scene import TABLE, Placement, Provenance, Report, Scene, SizePrior, Table


def placement(name: str, on: str = TABLE, side: float = 0.1, *, inside: bool = False) -> Placement:
    return Placement(name, 0.0, np.array([0.0, 0.0, 0.8]), np.full(3, side), on, inside)


def prior(name: str, side: float = 0.1) -> SizePrior:
    return SizePrior(name, np.full(3, side))


class Builder:
    """Judges what it is given: fails, in these words, while any of its troublemakers is there."""

    def __init__(self, table: Table, failures: dict[str, str]) -> None:
        self.table, self.failures = table, failures
        self.built: list[tuple[str, ...]] = []

    def __call__(
        self, placed: tuple[Placement, ...], extra: Supplement, told: tuple[str, ...]
    ) -> Scene:
        names = tuple(p.name for p in (*placed, *extra.placements))
        self.built.append(names)
        failures = tuple(text for name, text in self.failures.items() if name in names)
        warnings = extra.warnings + told
        return Scene(
            "made", self.table, (), Provenance("text", 0, "made", warnings=warnings),
            report=Report(0.0, 0.0, 0.0, failures=failures),
        )  # fmt: skip


def nothing(_: tuple[Placement, ...], _gone: tuple[str, ...]) -> Supplement:
    return NOTHING


@pytest.fixture(scope="module")
def table() -> Table:
    from generator.compose import compose

    return compose("a mug", 0).table


FOUND = (placement("mug_1"), placement("berry_1", side=0.4), placement("melon_1", side=0.2))
SIZES = {p.name: prior(p.name, side) for p, side in zip(FOUND, (0.1, 0.1, 0.2), strict=True)}


@pytest.mark.slow
def test_a_scene_that_passes_keeps_everything(table):
    build = Builder(table, {})
    scene = salvaged(build, nothing, FOUND, SIZES, 3)
    assert build.built == [("mug_1", "berry_1", "melon_1")]
    assert scene.report and not scene.report.dropped and not scene.provenance.warnings


def test_what_fits_its_kind_least_goes_of_two_that_overlap(table):
    build = Builder(table, {"berry_1": "melon_1 overlaps berry_1 by 3.0 mm"})
    scene = salvaged(build, nothing, FOUND, SIZES, 1)
    assert build.built[-1] == ("mug_1", "melon_1")
    assert scene.report and scene.report.passed and scene.report.dropped == ("berry_1",)
    assert "berry_1 was left out: melon_1 overlaps berry_1 by 3.0 mm." in scene.provenance.warnings


def test_what_was_added_goes_before_what_was_seen(table):
    more = Supplement({}, (placement("fork_1"),), ())
    build = Builder(table, {"fork_1": "fork_1 overlaps mug_1 by 3.0 mm"})
    scene = salvaged(build, lambda *_: more, FOUND, SIZES, 3)
    assert build.built[-1] == tuple(p.name for p in FOUND)
    assert scene.report and scene.report.passed and not scene.report.dropped


def test_what_goes_is_asked_for_anew(table):
    def add(placed: tuple[Placement, ...], gone: tuple[str, ...]) -> Supplement:
        if any(p.name == "berry_1" for p in placed):
            return NOTHING
        return Supplement({}, (placement("berry_2"),), (f"berry_2 for {gone}.",))

    build = Builder(table, {"berry_1": "berry_1 floats"})
    scene = salvaged(build, add, FOUND, SIZES, 1)
    assert build.built[-1] == ("mug_1", "melon_1", "berry_2")
    assert "berry_2 for ('berry_1',)." in scene.provenance.warnings


def test_with_too_much_to_leave_out_the_whole_scene_fails(table):
    build = Builder(table, {"berry_1": "berry_1 floats", "mug_1": "mug_1 moved 9.0 mm in 5 s"})
    scene = salvaged(build, nothing, FOUND, SIZES, 1)
    assert scene.report and len(scene.report.failures) == 2 and not scene.report.dropped
    none = salvaged(Builder(table, {"mug_1": "mug_1 floats"}), nothing, FOUND, SIZES, 0)
    assert none.report and none.report.failures


def test_failures_that_name_nothing_cost_nothing(table):
    build = Builder(table, {"mug_1": "the table has no top"})
    scene = salvaged(build, nothing, FOUND, SIZES, 3)
    assert len(build.built) == 1 and scene.report and not scene.report.passed


def test_the_most_named_is_the_misfit():
    failures = ["mug_1 overlaps melon_1 by 1.0 mm", "mug_1 overlaps the table by 2.0 mm"]
    assert misfit(failures, FOUND, SIZES) == "mug_1"
    assert misfit(["mug_10 floats"], FOUND, SIZES) is None


def test_what_stood_on_it_stands_where_it_stood():
    stack = (
        placement("tray_1"),
        placement("book_1", "tray_1", inside=True),
        placement("egg_1", "book_1"),
    )
    left = without(stack, "book_1")
    assert [(p.name, p.on, p.inside) for p in left] == [
        ("tray_1", TABLE, False), ("egg_1", "tray_1", True),
    ]  # fmt: skip


def test_what_was_in_it_goes_with_it(table):
    stack = (
        placement("mug_1", side=0.3),
        placement("pen_1", "mug_1", inside=True),
        placement("cap_1", "pen_1"),
        placement("mug_2"),
    )
    left = without(stack, "mug_1")
    assert [(p.name, p.on, p.inside) for p in left] == [
        ("cap_1", TABLE, False), ("mug_2", TABLE, False),
    ]  # fmt: skip
    build = Builder(table, {"mug_1": "mug_1 floats"})
    scene = salvaged(build, nothing, stack, SIZES, 1)
    assert scene.report and scene.report.passed
    assert scene.report.dropped == ("mug_1", "pen_1")
    assert "pen_1 was left out with mug_1." in scene.provenance.warnings


@pytest.mark.parametrize(
    ("share", "count", "most"),
    [(0.2, 1, 0), (0.2, 2, 1), (0.2, 9, 1), (0.2, 10, 2), (0.07, 100, 7), (1, 3, 2), (0, 9, 0),
     (0.5, 0, 0)],
)  # fmt: skip
def test_never_all_and_none_if_so_told(share, count, most):
    assert allowance(share, count) == most


@pytest.mark.slow
@pytest.mark.parametrize("overlap", [False, True])
def test_the_pipeline_leaves_out_what_fails_in_earnest(monkeypatch, overlap, tmp_path):
    """A thing that is stuck in the table, and cannot be freed, costs itself and not the scene."""
    from generator.backends import Backends
    from generator.bundle import load
    from generator.method import assembly
    from generator.pipeline import generate

    real = assembly.judge

    def judge(scene, limits=None):
        report = real(scene, limits)
        if overlap and any(o.name == "mug_1" for o in scene.objects):
            failure = "mug_1 overlaps the table by 3.0 mm"
            report = dataclasses.replace(report, failures=(*report.failures, failure))
        return report

    monkeypatch.setattr(assembly, "judge", judge)
    made = generate("A desk with a mug, a laptop and a book", Backends.select("embedded"), seed=0)
    names = {o.name for o in made.scene.objects}
    assert ("mug_1" in names) != overlap
    assert made.scene.report.dropped == (("mug_1",) if overlap else ())
    told = [w for w in made.scene.provenance.warnings if "left out" in w]
    if overlap:
        assert "mug_1 was left out: mug_1 overlaps the table by 3.0 mm." in told
        assert "mug_2 is in place of what was left out; it stands where the plan has it." in told
        assert "mug_2" in names
    else:
        assert not told
    assert {o.name for o in load(made.save(tmp_path)).objects} == names


def test_the_share_is_a_share():
    with pytest.raises(InputError, match=r"leave_out.*\[0, 1\]"):
        Config(leave_out=1.5)
