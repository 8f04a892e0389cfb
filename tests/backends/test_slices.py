"""Standing stacks of ellipses: closed solids that reproduce silhouettes."""

import numpy as np
import trimesh

from generator.backends.embedded.shapes.generic import stroke_share
from generator.backends.embedded.shapes.slices import fit_slices
from generator.backends.embedded.shapes.solids import (
    PosedSolid,
    simplify_profile,
    stack_of_ellipses,
)
from generator.geometry import view_direction, view_rotation
from generator.meshes.pixels import mask_iou
from generator.meshes.projection import Projection
from generator.scene import View

VIEW = View(0.0, np.deg2rad(35), np.deg2rad(36))
HEIGHTS = np.linspace(0, 60, 9)
RADII = np.array([22.0, 24, 23, 18, 12, 11, 14, 15, 10])
SHIFTS = np.array([0.0, 0, 1, 4, 8, 11, 12, 12, 12])


def closeup() -> Projection:
    focal = 250.0
    return Projection(
        view_rotation(VIEW), focal * view_direction(VIEW), focal, np.array([70.0, 90.0]), 140, 120
    )


def test_a_stack_is_closed_and_its_parts_fill_it():
    solid = stack_of_ellipses(HEIGHTS, RADII, SHIFTS, 0.6)
    mesh = trimesh.Trimesh(solid.vertices, solid.faces, process=False)
    assert mesh.is_watertight and mesh.volume > 0
    assert all(len(p.vertices) <= 32 for p in solid.parts)
    filled = sum(trimesh.convex.convex_hull(p.vertices).volume for p in solid.parts)
    assert abs(filled / mesh.volume - 1) < 0.1


def test_a_leaning_thing_is_met_again():
    view = closeup()
    truth = PosedSolid("slices", stack_of_ellipses(HEIGHTS, RADII, SHIFTS, 1.0), 0.0, np.zeros(3))
    mask = view.silhouette(truth.world, truth.solid.faces)
    found = fit_slices(mask, view)
    assert found is not None
    assert mask_iou(view.silhouette(found.world, found.solid.faces), mask) > 0.9
    tall = float(np.ptp(found.solid.vertices[:, 2]))
    assert 40 < tall < 80


def test_a_thin_stem_holds_what_is_above_and_below_it():
    view = closeup()
    radii = np.array([14.0, 14, 1.2, 1.2, 1.2, 1.2, 20, 18, 8])
    shifts = np.zeros(9)
    truth = PosedSolid("slices", stack_of_ellipses(HEIGHTS, radii, shifts, 1.0), 0.0, np.zeros(3))
    mask = view.silhouette(truth.world, truth.solid.faces)
    found = fit_slices(mask, view)
    assert found is not None
    assert mask_iou(view.silhouette(found.world, found.solid.faces), mask) > 0.85
    assert np.ptp(found.solid.vertices[:, 2]) > 45


def test_profiles_keep_what_bends():
    profile = np.column_stack([np.ones(9), np.abs(np.arange(9.0) - 4)])
    assert simplify_profile(np.arange(9.0), profile, 5) == [0, 4, 8]


def test_strokes_are_as_wide_as_they_look():
    rows, columns = np.mgrid[:100, :100] - 50
    distance = np.hypot(rows, columns)
    ring, disc = (distance < 45) & (distance > 39), distance < 45
    assert stroke_share(ring) < 0.12 < 0.6 < stroke_share(disc)
