"""Removal of lighting from colours: estimated lighting, and unchanged colours."""

import numpy as np

from generator.meshes.shading import Shading, estimate_shading


def sphere(count: int = 1500) -> np.ndarray:
    normal = np.random.default_rng(0).normal(size=(count, 3))
    normal[:, 1:] = np.abs(normal[:, 1:]) * [-1, 1]  # what a camera in front and above sees
    return normal / np.linalg.norm(normal, axis=1, keepdims=True)


def test_the_light_on_a_plain_thing_is_found_and_removed():
    normal, light = sphere(), Shading(np.array([0.15, -0.1, 0.35]))
    colors = np.array([90.0, 140.0, 200.0]) * light.at(normal)[:, None]
    found = estimate_shading(colors, normal, np.ones(len(normal), bool))
    plain = found.remove(colors, normal)
    before, after = colors.std(0) / colors.mean(0), plain.std(0) / plain.mean(0)
    assert (after < 0.4 * before).all()
    assert np.abs(plain.mean(0) / [90, 140, 200] - 1).max() < 0.08


def test_what_faces_up_keeps_its_colour():
    up = np.tile([0.0, 0.0, 1.0], (50, 1))
    colors = np.full((50, 3), 120.0)
    shading = estimate_shading(colors, up, np.ones(50, bool))
    np.testing.assert_allclose(shading.remove(colors, up), colors)


def test_differently_coloured_sides_are_not_taken_for_light():
    """A red lid on a blue body: brightness differs, but so does the hue."""
    up, side = np.tile([0.0, 0.0, 1.0], (400, 1)), np.tile([0.0, -1.0, 0.0], (400, 1))
    normal = np.concatenate([up, side])
    colors = np.concatenate([np.tile([230.0, 60, 50], (400, 1)), np.tile([20.0, 30, 90], (400, 1))])
    every = np.ones(len(normal), bool)
    usual = estimate_shading(colors[:400], normal[:400], every[:400])
    np.testing.assert_allclose(estimate_shading(colors, normal, every).slope, usual.slope)
