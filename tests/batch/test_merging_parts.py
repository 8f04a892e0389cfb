"""Merging of convex parts: fewer parts that cover the same volume and keep hollows open."""

import numpy as np
import pytest
from scipy.spatial import Delaunay
from toy import corners, ring_parts, toy_objects, toy_scene

from generator.errors import InputError
from generator.physics.gate import judge
from generator.scene import ConvexPart
from tabletopgen_env.parallel.batch.union.simplification import cap_parts, merge_parts

CUP = ring_parts(np.array([0.09, 0.09, 0.1]), wall=0.006, floor=0.006)


@pytest.mark.parametrize("most", [1, 5, 8, 12])
def test_no_more_than_asked_for_cover_what_was_covered(most: int) -> None:
    merged = merge_parts(CUP, most)
    assert len(CUP) == 13 and len(merged) == most
    solids = [Delaunay(part.vertices) for part in merged]
    for part in CUP:
        inner = 0.999 * part.vertices + 0.001 * part.vertices.mean(0)
        assert any((solid.find_simplex(inner) >= 0).all() for solid in solids)


def test_a_cup_stays_hollow() -> None:
    inside = np.array([[0.0, 0.0, z] for z in np.linspace(-0.04, 0.05, 10)])
    places = [[0, 0, 0], [0.03, 0, 0], [0, -0.03, 0]]
    inside = np.concatenate([inside + place for place in places])
    for part in merge_parts(CUP, 7):
        assert (Delaunay(part.vertices).find_simplex(inside) < 0).all()


def test_parts_that_stand_apart_are_merged_last() -> None:
    boxes = [ConvexPart(corners([x, 0, 0], [x + 0.01, 0.01, 0.01]), "box") for x in (0, 0.01, 0.5)]
    beside, alone = sorted(merge_parts(boxes, 2), key=lambda part: float(part.vertices[0, 0]))
    assert np.allclose(np.ptp(beside.vertices, axis=0), [0.02, 0.01, 0.01]) and alone is boxes[2]
    (whole,) = merge_parts(boxes, 1)
    assert np.allclose(np.ptp(whole.vertices, axis=0), [0.51, 0.01, 0.01])


def test_few_parts_stay_as_they_are() -> None:
    assert merge_parts(CUP, 13) == CUP
    scene = toy_scene()
    assert cap_parts(scene, 13) is scene
    with pytest.raises(InputError, match="most"):
        cap_parts(scene, 0)


def test_a_scene_keeps_all_else() -> None:
    scene = toy_scene()
    capped = cap_parts(scene, 6)
    for before, after in zip(scene.objects, capped.objects, strict=True):
        assert len(after.parts) <= 6
        assert (after.parts == before.parts) == (len(before.parts) <= 6)
        assert after.mass == before.mass and after.pose is before.pose
        assert np.array_equal(after.inertia, before.inertia)
    assert judge(capped).passed
    assert len(toy_objects()) == len(capped.objects)
