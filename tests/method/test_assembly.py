import dataclasses

import numpy as np
import pytest
from shapes import MANUAL, TABLE_SIZE, ball, box, cup, drawn, put, table
from toy import toy_object

from generator.errors import InputError
from generator.geometry import quaternion_matrix
from generator.method.assembly import AssemblyConfig, assemble, body, reassemble
from generator.physics.gate import judge
from generator.physics.settling import on_foot
from generator.physics.standing_height import seat_on_table
from generator.scene import ConvexPart, Model, Placement, PlannedTable, Scene, ScenePlan, View


def boxed(name: str, *where, model: Model | None = None, **more) -> tuple[Model, Placement]:
    """Return a box, or another model, and its position."""
    return model or box(), put(name, *where, **more)


def build(*things: tuple[Model, Placement], **options) -> Scene:
    return assemble(
        {placement.name: model for model, placement in things},
        [placement for _, placement in things],
        table(),
        TABLE_SIZE,
        provenance=MANUAL,
        name="scene",
        **options,
    )


def passing(*things: tuple[Model, Placement], **options) -> Scene:
    scene = build(*things, **options)
    assert scene.report is not None
    assert scene.report.passed, scene.report.failures
    return scene


def bottom(scene: Scene, name: str) -> float:
    thing = scene.object(name)
    return thing.pose.position[2] - thing.scale[2] / 2


def test_a_box_rests_where_it_was_put() -> None:
    scene = passing(boxed("box_1", (0.2, -0.1), (0.1, 0.06, 0.05), yaw=0.4))
    thing = scene.object("box_1")
    np.testing.assert_allclose(thing.pose.position, [0.2, -0.1, 0.765], atol=3e-4)
    np.testing.assert_allclose(thing.pose.quaternion, [np.cos(0.2), 0, 0, np.sin(0.2)], atol=1e-3)
    assert thing.mass == pytest.approx(600 * 0.1 * 0.06 * 0.05)
    assert scene.report.moved == 0
    assert scene.report.settling < 5e-4


def test_what_is_passed_is_kept() -> None:
    plan = ScenePlan("a box", PlannedTable(), ())
    view = View(0.1, 0.9, 0.6)
    scene = build(boxed("box_1", (0, 0), (0.1,) * 3), view=view, plan=plan)
    assert (scene.view, scene.plan, scene.provenance) == (view, plan, MANUAL)
    np.testing.assert_allclose(np.abs(scene.table.outline), [[0.6, 0.35]] * 4)


def test_overlaps_are_freed_and_told() -> None:
    scene = passing(boxed("a_1", (0, 0), (0.1,) * 3), boxed("b_1", (0.09, 0), (0.1,) * 3))
    assert scene.report.moved == pytest.approx(0.0055, abs=3e-4)


def test_a_stack_of_three_survives() -> None:
    scene = passing(
        boxed("top_1", (0.01, 0), (0.05, 0.05, 0.05), on="mid_1"),
        boxed("low_1", (0, 0), (0.2, 0.15, 0.03), yaw=0.3),
        boxed("mid_1", (0, 0.01), (0.15, 0.1, 0.02), on="low_1"),
    )
    for name, height in (("low_1", 0.74), ("mid_1", 0.77), ("top_1", 0.79)):
        assert bottom(scene, name) == pytest.approx(height, abs=5e-4)


def test_a_ball_put_into_a_cup_lies_on_its_floor() -> None:
    scene = passing(
        boxed("cup_1", (0.1, 0.1), (0.1, 0.1, 0.09), model=cup((0.1, 0.1, 0.09))),
        boxed("ball_1", (0.11, 0.1), (0.04,) * 3, on="cup_1", inside=True, model=ball()),
    )
    assert bottom(scene, "ball_1") == pytest.approx(0.746, abs=2e-3)


def test_a_thing_beside_the_opening_is_brought_over_it() -> None:
    """Lowered at its own position, it would stay on the rim."""
    scene = passing(
        boxed("cup_1", (0, 0), (0.1, 0.1, 0.09), model=cup((0.1, 0.1, 0.09))),
        boxed("pen_1", (0.04, 0), (0.01, 0.01, 0.12), on="cup_1", inside=True),
    )
    thing = scene.object("pen_1")
    assert np.linalg.norm(thing.pose.position[:2]) < 0.05
    assert thing.pose.position[2] < 0.74 + 0.08


def test_a_support_that_is_pushed_takes_its_load_along() -> None:
    scene = passing(
        boxed("a_1", (0, 0), (0.1,) * 3),
        boxed("tray_1", (0.11, 0), (0.16, 0.16, 0.02)),
        boxed("egg_1", (0.11, 0), (0.03,) * 3, on="tray_1"),
    )
    tray, egg = scene.object("tray_1").pose.position, scene.object("egg_1").pose.position
    assert tray[0] > 0.115
    np.testing.assert_allclose(egg[:2], tray[:2], atol=1e-3)


def test_what_overhangs_is_pulled_onto_the_table() -> None:
    scene = passing(boxed("box_1", (0.6, 0), (0.1,) * 3))
    assert scene.object("box_1").pose.position[0] == pytest.approx(0.55, abs=1e-3)


@pytest.fixture
def club() -> Model:
    """Collision parts of a club on its thin end, which would fall over."""
    top = [[x, y, 0.5] for x in (-0.5, 0.5) for y in (-0.5, 0.5)]
    parts = (ConvexPart(np.array([[0.3, 0, -0.5], [0.4, 0.1, -0.5], [0.4, -0.1, -0.5], *top])),)
    return dataclasses.replace(box(), parts=parts, mesh=drawn(parts))


def test_a_thing_that_cannot_stand_gets_a_weighted_foot(club: Model) -> None:
    scene = passing(boxed("club_1", (0, 0), (0.06, 0.06, 0.25), model=club))
    assert len(scene.object("club_1").parts) == 2
    assert any("club_1 stands on a weighted foot" in w for w in scene.provenance.warnings)
    assert scene.object("club_1").pose.position[2] == pytest.approx(0.74 + 0.125, abs=2e-3)


def test_a_scene_settled_again_changes_only_what_is_new(club: Model) -> None:
    """Two clubs on their thin ends, one of them new, beside a box at rest."""
    before = build(boxed("box_1", (0.3, 0), (0.1,) * 3))
    places = (("club_1", 0), ("club_2", -0.3))
    new = [body(club, put(name, (x, 0), (0.06, 0.06, 0.25))) for name, x in places]
    seated = [seat_on_table(thing, TABLE_SIZE[2]) for thing in new]
    arranged = before.replace(objects=(*before.objects, *seated))
    after = reassemble(arranged, arranged, ["club_1"])
    assert after.object("box_1") is arranged.object("box_1")
    assert len(after.object("club_1").parts) == 2
    assert len(after.object("club_2").parts) == 1  # it lies, and nothing is made up to prevent it
    assert any("club_2 does not stand" in w for w in after.provenance.warnings)


def test_a_foot_has_its_share_of_weight_and_inertia() -> None:
    """A pole of 1 kg, 0.3 m high, whose foot lowers its centre of mass from a half to a third."""
    pole = toy_object("pole_1", (0.03, 0.04, 0.3), (0, 0), mass=1.0)
    footed = on_foot(dataclasses.replace(pole, com=np.array([0.004, 0.0, 0.0])))
    assert footed.mass == 1.0
    np.testing.assert_allclose(footed.com, [0, 0, -0.05], atol=1e-9)
    thick, arm = 0.01, 0.145
    share = 0.05 / arm
    long = (1 - share) * (0.3**2 + 0.04**2) / 12 + share * (thick**2 + 0.04**2) / 12
    assert footed.inertia[0, 0] == pytest.approx(long + share * (1 - share) * arm**2)
    apart = 0.004 / share  # along x, between the foot's centre and the pole's
    upright = pole.inertia[2, 2] + share * (1 - share) * apart**2
    assert footed.inertia[2, 2] == pytest.approx(upright)


def test_a_foot_under_what_is_low_already_makes_it_lower_and_centres_it() -> None:
    low = dataclasses.replace(
        toy_object("egg_1", (0.05, 0.05, 0.06), (0, 0)), com=np.array([0.006, 0.0, -0.025])
    )
    flat = on_foot(toy_object("card_1", (0.05, 0.05, 0.002), (0, 0)))
    assert np.linalg.eigvalsh(flat.inertia).min() > 0
    footed = on_foot(low)
    np.testing.assert_allclose(footed.com[:2], 0, atol=1e-12)
    assert -0.03 < footed.com[2] < low.com[2]
    assert np.linalg.eigvalsh(footed.inertia).min() > 0


def test_what_stands_but_topples_on_a_leaning_table_gets_one_too() -> None:
    """A goblet: its foot is a sixteenth as wide as its height."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    stem = [[0.08 * x, 0.08 * y, z] for x, y in corners for z in (-0.5, 0.2)]
    stout = [[2 * x, 2 * y, z] for x, y, z in stem]
    cup = ConvexPart(np.array([[0.5 * x, 0.5 * y, z] for x, y in corners for z in (0.2, 0.5)]))

    def goblet(stem: list[list[float]]) -> tuple[Model, Placement]:
        parts = (ConvexPart(np.array(stem)), cup)
        model = dataclasses.replace(box(), parts=parts, mesh=drawn(parts))
        return boxed("goblet_1", (0, 0), (0.1, 0.1, 0.25), model=model)

    scene = passing(goblet(stem))
    assert len(scene.object("goblet_1").parts) == 3
    assert "goblet_1 stands on a weighted foot that is not part of its model" in (
        scene.provenance.warnings
    )
    assert len(build(goblet(stout)).object("goblet_1").parts) == 2


SLABS = [boxed(f"c_{k}", (0, 0), (0.7, 0.6, 0.05)) for k in range(3)]


@pytest.mark.slow
def test_without_room_the_report_fails_and_says_why() -> None:
    scene = build(*SLABS)
    assert scene.report is not None
    assert not scene.report.passed
    assert any("no free place" in w for w in scene.provenance.warnings)


@pytest.mark.slow
def test_without_room_things_are_left_out_if_so_configured() -> None:
    rider = boxed("rider_1", (0, 0), (0.05,) * 3, on="c_2")
    scene = passing(*SLABS, rider, config=AssemblyConfig(drop_failing=True))
    assert scene.objects
    assert scene.report.dropped
    assert len(scene.objects) + len(scene.report.dropped) == len(SLABS) + 1
    assert all(f"{name} was left out" in scene.provenance.warnings for name in scene.report.dropped)


def test_the_report_is_what_the_gate_says_of_the_stored_scene() -> None:
    scene = build(boxed("box_1", (0, 0), (0.1,) * 3))
    assert judge(scene) == scene.report


def test_the_same_input_gives_the_same_scene() -> None:
    things = [boxed(f"c_{k}", (0.03 * k, 0.01 * k), (0.05,) * 3, yaw=k) for k in range(5)]
    first, second = build(*things), build(*things)
    for a, b in zip(first.objects, second.objects, strict=True):
        np.testing.assert_array_equal(a.pose.position, b.pose.position)
        np.testing.assert_array_equal(a.pose.quaternion, b.pose.quaternion)
    assert first.report == second.report


def test_an_empty_table_is_a_scene() -> None:
    assert passing().objects == ()


@pytest.mark.parametrize(
    "wrong",
    [{"attempts": -1}, {"attempts": 0}, {"clearance": float("nan")}, {"settle_seconds": 0.0},
     {"topple": -0.5}],
)  # fmt: skip
def test_settings_out_of_range_are_refused(wrong):
    with pytest.raises(InputError, match=r"^AssemblyConfig\.\w+ must be"):
        AssemblyConfig(**wrong)


def test_bad_placements_are_named() -> None:
    placement = put("box_1", (0, 0), (0.1,) * 3)
    with pytest.raises(InputError, match=r"No model.*'box_1'"):
        assemble({}, [placement], table(), TABLE_SIZE, provenance=MANUAL, name="x")
    for on, told in (("tray_1", "unknown 'tray_1'"), ("box_1", "stands on itself")):
        with pytest.raises(InputError, match=told):
            build(boxed("box_1", (0, 0), (0.1,) * 3, on=on))


def test_a_model_without_parts_is_decomposed(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("platformdirs.user_cache_dir", lambda *a, **k: str(tmp_path))
    bare = dataclasses.replace(box(), parts=())
    scene = passing(boxed("box_1", (0, 0), (0.1, 0.08, 0.05), model=bare))
    (part,) = scene.object("box_1").parts
    np.testing.assert_allclose(np.ptp(part.vertices, axis=0), [0.1, 0.08, 0.05], atol=2e-3)


@pytest.mark.slow
def test_what_stands_free_in_a_cup_is_shaken_against_its_rim() -> None:
    """Lowered upright, it would stand on its end, and fall over on a leaning table."""
    scene = passing(
        boxed("cup_1", (0, 0), (0.09, 0.09, 0.09), model=cup((0.09, 0.09, 0.09))),
        boxed("rod_1", (0, 0), (0.005, 0.005, 0.18), on="cup_1", inside=True),
    )
    up = quaternion_matrix(scene.object("rod_1").pose.quaternion)[2, 2]
    assert np.arccos(up) > np.deg2rad(5)
