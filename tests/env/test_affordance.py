"""Affordances of shapes for a gripper: widths, hollows, surfaces, free spots."""

from dataclasses import replace

import numpy as np
import pytest
from toy import corners, ring_parts, toy_object, toy_scene

from generator.geometry import yaw_quaternion
from generator.scene import ConvexPart, Object, Pose
from tabletop_objects import build
from tabletopgen_env.affordance import (
    LEVEL,
    grasp_width,
    is_upright,
    opening,
    part_span,
    resting_height,
    top_surface,
    why_not_graspable,
)
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.workspace import FREE_MARGIN, LEAST_WAY, free_spot
from tabletopgen_env.world.world import World


def unfit(obj) -> str | None:
    return why_not_graspable(obj, opening(obj))


def lying(obj):
    side = np.array([np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0])
    return replace(obj, pose=Pose(obj.pose.position, side))


def test_the_grasp_width_is_the_narrowest_way_across() -> None:
    book = toy_object("book_1", (0.2, 0.05, 0.15), (0.0, 0.0), yaw=0.7)
    assert grasp_width(book) == pytest.approx(0.05, abs=2e-3)
    assert grasp_width(lying(book)) == pytest.approx(0.15, abs=5e-3)
    assert resting_height(lying(book)) == pytest.approx(0.05)


@pytest.mark.parametrize(
    ("size", "mass", "wall", "reason"),
    [
        ((0.05, 0.3, 0.1), 0.2, None, None),
        ((0.12, 0.12, 0.1), 0.2, None, "the object is 12.0 cm wide"),
        ((0.05, 0.05, 0.008), 0.02, None, "the height of 8 mm is less"),
        ((0.05, 0.05, 0.1), 4.0, None, "the mass of 4 kg exceeds"),
        ((0.16, 0.16, 0.07), 0.3, 0.006, None),
    ],
)
def test_what_can_be_grasped(size, mass, wall, reason) -> None:
    found = unfit(toy_object("thing_1", size, (0.0, 0.0), mass=mass, wall=wall))
    assert found is None if reason is None else found is not None and found.startswith(reason)


def test_the_opening_of_a_cup_is_its_clear_hollow() -> None:
    cup = toy_object("cup_1", (0.09, 0.07, 0.1), (0.3, 0.1), wall=0.006)
    hollow = opening(cup)
    assert hollow is not None
    assert np.allclose(hollow.center, 0.0, atol=1e-3)
    assert np.allclose(hollow.semi, [0.039, 0.03], atol=2.5e-3)
    assert hollow.rim == pytest.approx(0.05) and hollow.floor == pytest.approx(-0.044)
    assert hollow.depth == pytest.approx(0.094) and hollow.thickness == pytest.approx(0.006)


def test_a_hairline_gap_in_the_wall_is_no_way_out() -> None:
    cup = toy_object("cup_1", (0.09, 0.09, 0.1), (0.0, 0.0), wall=0.006)
    parts = ring_parts(np.array([0.09, 0.09, 0.1]), 0.006, 0.006)
    shrunk = tuple(
        ConvexPart(p.vertices.mean(0) + 0.995 * (p.vertices - p.vertices.mean(0))) for p in parts
    )
    assert opening(replace(cup, parts=shrunk)) is not None


@pytest.mark.parametrize("missing", [3, 4, 5])
def test_a_cup_with_a_wide_gap_is_none(missing) -> None:
    cup = toy_object("cup_1", (0.2, 0.2, 0.1), (0.0, 0.0), wall=0.01)
    floor, walls = cup.parts[-1], list(cup.parts[:-1])
    del walls[missing]
    assert opening(replace(cup, parts=(*walls, floor))) is None


def pan(*, wall: float = 0.003, gap: float = 1.0, container: bool = True) -> Object:
    """A pan 20 cm wide and 4 cm high whose handle rises 2 cm above it, its parts shrunk by gap."""
    handle = ConvexPart(corners([0.095, -0.012, 0.0], [0.28, 0.012, 0.04]), "box")
    parts = (*ring_parts(np.array([0.2, 0.2, 0.04]), wall, 0.005), handle)
    shrunk = (p.vertices.mean(0) + gap * (p.vertices - p.vertices.mean(0)) for p in parts)
    made = toy_object("pan_1", (0.2, 0.2, 0.04), (0.0, 0.0), wall=wall)
    model = replace(made.model, container=container)
    return replace(made, model=model, parts=tuple(map(ConvexPart, shrunk)))


@pytest.mark.parametrize("gap", [1.0, 0.995])
def test_a_pan_is_open_up_to_where_it_would_spill(gap) -> None:
    hollow = opening(pan(gap=gap))
    assert hollow is not None
    assert np.allclose(hollow.center, 0.0, atol=2e-3)
    assert np.allclose(hollow.semi, 0.097, atol=4e-3)
    assert 0.02 - 2 * LEVEL <= hollow.rim <= 0.02, "not that of the handle"
    assert hollow.floor == pytest.approx(-0.015, abs=1e-3)


def test_only_what_is_called_a_container_is_searched_for_a_lower_rim() -> None:
    assert opening(pan(container=False)) is None


def test_a_pan_without_a_floor_or_a_piece_of_wall_has_no_opening() -> None:
    whole = pan()
    *walls, floor, handle = whole.parts
    assert opening(replace(whole, parts=(*walls, handle))) is None
    assert opening(replace(whole, parts=(*walls[:5], *walls[6:], floor, handle))) is None


def test_a_full_cup_has_no_opening() -> None:
    cup = toy_object("cup_1", (0.12, 0.12, 0.1), (0.0, 0.0), wall=0.0022)
    angles = np.arange(12) * np.pi / 6
    ring = 0.058 * np.column_stack([np.cos(angles), np.sin(angles)])
    # The drink is lower at its hem, which alone lies deep enough.
    drink = [
        [*(share * xy), z] for xy in ring for share, z in ((1, -0.05), (1, 0.025), (0.8, 0.038))
    ]
    assert opening(cup) is not None
    assert opening(replace(cup, parts=(*cup.parts, ConvexPart(np.array(drink))))) is None


@pytest.mark.parametrize("key", ["pan", "tray"])
@pytest.mark.parametrize("size", ["small", "large"])
def test_pans_and_trays_of_the_catalogue_are_open(key, size) -> None:
    for seed in range(4, 7):
        model = build(key, seed, attributes={"size": size})
        parts = tuple(ConvexPart(p.vertices * model.size) for p in model.parts)
        made = toy_object(key, tuple(model.size), (0.0, 0.0))
        hollow = opening(replace(made, model=model, parts=parts))
        assert hollow is not None and hollow.rim <= model.size[2] / 2
        assert hollow.semi.min() > 0.3 * model.size[1]


def test_solids_and_plates_have_no_opening() -> None:
    assert opening(toy_object("cube_1", (0.05, 0.05, 0.05), (0.0, 0.0))) is None
    assert opening(toy_object("plate_1", (0.2, 0.2, 0.018), (0.0, 0.0), wall=0.01)) is None


def test_the_top_surface_is_that_of_the_highest_part() -> None:
    step = (
        ConvexPart(corners([0, 0, 0], [2, 1, 1]), "box"),
        ConvexPart(corners([0, 0, 1], [1, 1, 3]), "box"),
    )
    heights = top_surface(step, np.array([[0.5, 0.5], [1.5, 0.5], [2.5, 0.5]]))
    assert np.allclose(heights, [3.0, 1.0, -np.inf])


def test_a_slope_is_measured_at_the_point() -> None:
    wedge = ConvexPart(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 1], [1, 1, 1]]))
    assert np.allclose(top_surface((wedge,), np.array([[0.25, 0.5], [0.75, 0.5]])), [0.25, 0.75])


def test_a_part_reaches_as_far_over_many_points_as_over_each() -> None:
    part = ConvexPart(np.random.default_rng(0).uniform(-1, 1, (60, 3)))
    points = np.random.default_rng(1).uniform(-1, 1, (3000, 2))
    hit, ground, ceiling = part_span(part, points)
    assert 100 < len(hit) < 2900
    for k in range(0, len(hit), 100):
        alone = part_span(part, points[hit[k]][None])
        np.testing.assert_allclose(np.ravel(alone), [0, ground[k], ceiling[k]])
    missed = np.setdiff1d(np.arange(3000), hit)[::100]
    assert not any(len(part_span(part, points[k][None])[0]) for k in missed)


def test_upright_is_within_twenty_degrees() -> None:
    mug = toy_object("mug_1", (0.08, 0.08, 0.1), (0.0, 0.0), wall=0.006)
    assert is_upright(replace(mug, pose=Pose(mug.pose.position, yaw_quaternion(2.0))))
    assert not is_upright(lying(mug))


def test_free_spots_keep_clear_of_everything() -> None:
    cube = toy_object("cube_1", (0.06, 0.06, 0.06), (0.0, -0.1))
    wall = toy_object("wall_1", (0.6, 0.04, 0.2), (0.0, 0.1), yaw=0.5)
    world = World(toy_scene((cube, wall)), Panda())
    radius = 0.03 * np.sqrt(2)
    c, s = np.cos(0.5), np.sin(0.5)
    for seed in range(30):
        spot = free_spot(world, "cube_1", np.random.default_rng(seed))
        assert spot is not None
        assert np.linalg.norm(spot - [0.0, -0.1]) >= LEAST_WAY
        across = abs(-s * spot[0] + c * (spot[1] - 0.1))
        along = abs(c * spot[0] + s * (spot[1] - 0.1))
        assert across >= 0.02 + radius + FREE_MARGIN - 1e-9 or along >= 0.3
        assert world.mount.reaches(np.array([[*spot, 0.74]]))[0]


def test_a_full_table_has_no_free_spot() -> None:
    cube = toy_object("cube_1", (0.06, 0.06, 0.06), (0.0, 0.0), top=0.78)
    board = toy_object("board_1", (1.2, 0.7, 0.04), (0.0, 0.0), mass=5.0)
    world = World(toy_scene((cube, board)), Panda())
    assert free_spot(world, "cube_1", np.random.default_rng(0)) is None
