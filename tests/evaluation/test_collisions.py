"""Overlaps of visual meshes: known depths, hollow objects, and contacts."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import sphere_mesh
from toy import cube_mesh, toy_object, toy_scene

from generator.errors import InputError
from generator.evaluation.surfaces.collisions import (
    Collisions,
    Overlap,
    colliding,
    collisions,
    overlap_depth,
    rates,
)
from generator.evaluation.surfaces.shells import (
    SurfaceShell,
    nearest_on_triangles,
    shells,
    solid_angles,
)
from generator.geometry import yaw_quaternion
from generator.scene import Mesh, Object, Placement, Pose
from tabletop_objects import build

UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])


def body(mesh: Mesh, size, position=(0, 0, 0), yaw: float = 0.0) -> tuple[SurfaceShell, ...]:
    return shells(mesh, np.array(size, float), np.array(position, float), yaw_quaternion(yaw))


def box(size, position=(0, 0, 0), yaw: float = 0.0) -> tuple[SurfaceShell, ...]:
    return body(cube_mesh(), size, position, yaw)


def joined(*meshes: Mesh) -> Mesh:
    """Several meshes as one, without a boolean operation."""
    start = np.cumsum([0, *(len(m.vertices) for m in meshes)])
    return Mesh(
        np.concatenate([m.vertices for m in meshes]),
        np.concatenate([m.faces + k for m, k in zip(meshes, start, strict=False)]),
        np.concatenate([m.uv for m in meshes]),
        meshes[0].texture,
    )


def moved(mesh: Mesh, scale, shift) -> Mesh:
    return dataclasses.replace(mesh, vertices=mesh.vertices * np.array(scale) + np.array(shift))


def turned_inside_out(mesh: Mesh) -> Mesh:
    return dataclasses.replace(mesh, faces=mesh.faces[:, ::-1])


def test_boxes_pushed_into_each_other_are_as_deep_as_they_were_pushed() -> None:
    a, b = box([0.1, 0.1, 0.1]), box([0.1, 0.1, 0.1], [0.097, 0.02, 0.01])
    assert overlap_depth(a, b) == pytest.approx(0.003, abs=1e-4)
    assert overlap_depth(b, a) == pytest.approx(0.003, abs=1e-4)


@pytest.mark.slow
@settings(deadline=None, max_examples=25)
@given(st.floats(0.001, 0.02), st.floats(0, 2 * np.pi), st.floats(-1, 1))
def test_balls_overlap_by_their_radii_less_their_distance(
    deep: float, way: float, up: float
) -> None:
    flat = np.sqrt(1 - up**2)
    apart = (0.1 - deep) * np.array([flat * np.cos(way), flat * np.sin(way), up])
    a, b = (body(sphere_mesh(), [0.1] * 3, p) for p in (np.zeros(3), apart))
    assert overlap_depth(a, b) == pytest.approx(deep, abs=4e-4 + 0.03 * deep)


def test_touching_is_no_overlap() -> None:
    assert overlap_depth(box([0.1] * 3), box([0.1] * 3, [0.1, 0, 0])) == 0
    assert overlap_depth(box([0.1] * 3), box([0.1] * 3, [0.0996, 0, 0])) == 0
    assert overlap_depth(box([0.1] * 3), box([0.1] * 3, [0.0994, 0, 0])) > 0


def test_crossed_bars_overlap_without_a_corner_inside() -> None:
    along, across = box([0.2, 0.02, 0.02]), box([0.02, 0.2, 0.02], [0, 0, 0.005], yaw=0.3)
    assert overlap_depth(along, across) > 0.004


@pytest.mark.slow
def test_things_in_the_same_place_overlap_though_their_surfaces_coincide() -> None:
    assert overlap_depth(box([0.1] * 3), box([0.1] * 3)) > 0.01
    mug = build("mug", 0)
    assert overlap_depth(body(mug.mesh, mug.size), body(mug.mesh, mug.size)) > 5e-4


def test_a_small_thing_wholly_inside_a_solid_is_deep() -> None:
    assert overlap_depth(box([0.02] * 3), box([0.1] * 3)) == pytest.approx(0.05, abs=0.011)


@pytest.mark.slow
def test_a_rod_in_a_mug_is_no_collision_but_through_its_wall_or_floor_it_is() -> None:
    mug = build("mug", 0)
    vessel = body(mug.mesh, mug.size)
    rod, low = [0.006, 0.006, 0.12], -mug.size[2] / 2
    inside = box(rod, [0, 0, low + 0.012 + 0.06])
    assert overlap_depth(vessel, inside) == 0
    through_floor = box(rod, [0, 0, low - 0.002 + 0.06])
    assert overlap_depth(vessel, through_floor) > 1e-3
    wall = next(
        x for x in np.linspace(0, 0.06, 121) if overlap_depth(vessel, box(rod, [0, x, 0.03]))
    )
    assert 0.02 < wall < 0.05


@pytest.mark.slow
def test_a_spoon_that_stands_in_a_mug_is_no_collision() -> None:
    mug, spoon = (
        dataclasses.replace(thing, model=model, placement=placed(thing, model.size))
        for thing, model in (
            (toy_object("mug_1", (0.1,) * 3, (0, 0)), build("mug", 0)),
            (toy_object("spoon_1", (0.1,) * 3, (0, 0)), build("spoon", 0)),
        )
    )
    on_end = np.array([np.sqrt(0.5), 0.0, np.sqrt(0.5), 0.0])
    stands = Pose(np.array([0, 0, 0.74 + 0.012 + spoon.scale[0] / 2]), on_end)
    mug = dataclasses.replace(
        mug, pose=Pose(np.array([0, 0, 0.74 + mug.scale[2] / 2]), mug.pose.quaternion)
    )
    spoon = dataclasses.replace(spoon, pose=stands)
    assert not collisions(toy_scene((mug, spoon))).col_s
    low = Pose(stands.position - np.array([0, 0, 0.01]), on_end)
    found = collisions(toy_scene((mug, dataclasses.replace(spoon, pose=low))))
    assert [(o.a, o.b) for o in found.overlaps] == [("mug_1", "spoon_1")]


def placed(thing: Object, extent) -> Placement:
    return dataclasses.replace(thing.placement, scale=extent)


def test_pieces_of_one_thing_count_as_one_solid() -> None:
    """Two overlapping blocks: a point deep in both is inside the object once."""
    bar = moved(cube_mesh(), [1, 0.2, 1], [0, 0, 0])
    post = moved(cube_mesh(), [0.2, 1, 1], [0, 0, 0])
    cross = body(joined(bar, post), [0.1, 0.1, 0.1])
    assert len(cross) == 2
    assert overlap_depth(cross, box([0.03] * 3, [0.04, 0.04, 0])) == 0
    assert overlap_depth(cross, box([0.03] * 3, [0.04, 0.02, 0])) == pytest.approx(0.005, abs=2e-4)


def test_a_mesh_inside_out_or_open_still_has_an_inside() -> None:
    probe = box([0.02] * 3, [0.05, 0, 0])
    flipped = body(turned_inside_out(cube_mesh()), [0.1] * 3)
    assert overlap_depth(flipped, probe) == pytest.approx(0.01, abs=2e-4)
    whole = sphere_mesh()
    open_ = dataclasses.replace(whole, faces=whole.faces[:-90])
    assert not shells(open_, np.full(3, 0.1), np.zeros(3), UPRIGHT)[0].closed
    assert overlap_depth(body(open_, [0.1] * 3), probe) == pytest.approx(0.01, abs=5e-4)
    assert overlap_depth(body(open_, [0.1] * 3), box([0.02] * 3, [0.065, 0, 0])) == 0


def test_a_sealed_hollow_counts_as_filled() -> None:
    hollow = joined(cube_mesh(), turned_inside_out(moved(cube_mesh(), [0.8] * 3, [0, 0, 0])))
    assert len(body(hollow, [0.1] * 3)) == 1
    assert overlap_depth(body(hollow, [0.1] * 3), box([0.02] * 3)) > 0.01


def test_faces_back_to_back_bound_nothing() -> None:
    """Two cubes with a common side, which is not a surface of the whole."""
    left, right = (moved(cube_mesh(), [0.5, 1, 1], [x, 0, 0]) for x in (-0.25, 0.25))
    pair = joined(left, right)
    (whole,) = body(pair, [0.1] * 3)
    assert len(whole.corners) == 20
    assert whole.depths(np.zeros((1, 3)))[0] == pytest.approx(0.05)


@pytest.mark.parametrize("turned", [False, True])
def test_nothing_lies_inside_a_sheet(turned: bool) -> None:
    """A post under a sheet without thickness, whose two sides have different diagonals."""
    post = moved(cube_mesh(), [0.1, 0.1, 1.0], [-0.45, -0.45, 0.0])
    corners = np.array([[-0.4, -0.4, 0.5], [0.5, -0.4, 0.5], [0.5, 0.5, 0.5], [-0.4, 0.5, 0.5]])
    faces = np.array([[0, 1, 2], [0, 2, 3], [1, 0, 3], [1, 3, 2]])
    sheet = Mesh(corners, faces[::-1] if turned else faces, np.zeros((4, 2)), post.texture)
    (flag,) = body(joined(post, sheet), [0.1] * 3)
    beside = np.array([[0.02, 0.01, z] for z in (-0.04, 0.0, 0.04)])
    assert flag.closed and (flag.depths(beside)[0] < 0).all()
    assert (flag.depths(np.array([[-0.045, -0.045, 0.0]]))[0] > 0.004).all()
    assert overlap_depth((flag,), box([0.02] * 3, [0.02, 0.01, 0.0])) == 0.0


def test_depths_agree_with_a_search_over_all_triangles() -> None:
    thing = build("teapot", 1)
    rng = np.random.default_rng(0)
    for shell in body(thing.mesh, thing.size):
        low, high = shell.bounds
        points = rng.uniform(low, high, (200, 3))
        depth, face = shell.depths(points)
        count = len(shell.corners)
        places, _ = nearest_on_triangles(
            points.repeat(count, 0), np.tile(shell.corners, (len(points), 1, 1))
        )
        away = np.linalg.norm(points[:, None] - places.reshape(len(points), count, 3), axis=2)
        assert np.allclose(np.abs(depth), away.min(1), atol=1e-9)
        assert np.array_equal(depth > 0, solid_angles(points, shell.corners) > 0.5)
        assert (face >= 0).all()


def test_scenes_and_their_rates() -> None:
    sound = collisions(toy_scene())
    assert (sound.pairs, sound.col_o, sound.col_s) == (15, 0.0, False)
    a, b, c = (toy_object(f"cube_{k}", (0.05,) * 3, (x, 0)) for k, x in enumerate((0, 0.04, 0.3)))
    spoiled = collisions(toy_scene((a, b, c)))
    assert [(o.a, o.b) for o in spoiled.overlaps] == [("cube_0", "cube_1")]
    assert spoiled.overlaps[0].depth == pytest.approx(0.01, abs=3e-4)
    assert spoiled.col_o == pytest.approx(1 / 3)
    both = rates([sound, spoiled])
    assert (both.scenes, both.pairs) == (2, 18)
    assert both.col_o == pytest.approx(1 / 18)
    assert both.col_s == 0.5


def test_what_sinks_into_the_table_is_told_apart_from_pairs() -> None:
    found = collisions(toy_scene((toy_object("cube_1", (0.05,) * 3, (0, 0), top=0.735),)))
    assert found.overlaps == ()
    assert [(o.a, o.b) for o in found.sunk] == [("cube_1", "table")]
    assert found.sunk[0].depth == pytest.approx(0.005, abs=2e-4)
    assert colliding(found) == ["cube_1"]
    assert found.col_s
    assert found.facts()["sunk_into_table"][0]["depth_mm"] == pytest.approx(5, abs=0.2)


def test_turned_poses_are_heeded() -> None:
    """Two parallel long bars that only overlap when one is rotated."""
    a = toy_object("bar_1", (0.2, 0.02, 0.02), (0, 0))
    b = toy_object("bar_2", (0.2, 0.02, 0.02), (0, 0.05))
    assert not collisions(toy_scene((a, b))).col_s
    turn = Pose(b.pose.position, yaw_quaternion(np.pi / 2))
    across: Object = dataclasses.replace(b, pose=turn)
    assert collisions(toy_scene((a, across))).col_s


@pytest.mark.parametrize("threshold", [0.0, -1.0, float("nan"), float("inf")])
def test_a_threshold_that_is_no_length_is_refused(threshold: float) -> None:
    with pytest.raises(InputError, match="positive length"):
        collisions(toy_scene(), threshold)


def test_rates_need_a_scene() -> None:
    with pytest.raises(InputError, match="at least one"):
        rates([])


def test_a_scene_without_pairs_has_a_rate() -> None:
    assert Collisions(0, (), ()).col_o == 0
    assert Collisions(1, (Overlap("a", "b", 0.01),), ()).col_o == 1
