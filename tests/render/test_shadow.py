"""Soft shadows: tiles decide most points, and never differently from samples of the map."""

import numpy as np
import pytest
import trimesh

from generator.render.shading import Light
from generator.render.shadow import Shadow

_BALL = trimesh.creation.icosphere(2, 0.15)
_BOX = trimesh.creation.box((0.8, 0.5, 0.1))
_BALL.apply_translation([0.3, 0.1, 0.2])
_SURFACES = [(np.asarray(m.vertices), np.asarray(m.faces)) for m in (_BALL, _BOX)]
_POINTS = np.concatenate([vertices for vertices, _ in _SURFACES])


def _shadow(softness: float) -> Shadow:
    return Shadow(_POINTS, _SURFACES, Light(softness=softness))


@pytest.mark.parametrize("softness", [0.0, 0.018, 0.2])
def test_tiles_give_the_share_that_samples_give(softness: float) -> None:
    shadow = _shadow(softness)
    rng = np.random.default_rng(0)
    first, second = rng.choice(_POINTS, 20_000), rng.choice(_POINTS, 20_000)
    points = first + rng.random((20_000, 1)) * (second - first)  # these lie on the map
    normals = rng.normal(size=points.shape)
    shares = shadow.lit_share(points, normals)
    shadow._highest[:], shadow._lowest[:] = np.inf, -np.inf  # no tile decides
    assert np.array_equal(shares, shadow.lit_share(points, normals))
    assert shares.max() == 1 and 0 <= shares.min() < 0.5 and len(set(shares)) > 3


def test_points_off_the_map_are_lit() -> None:
    far = np.array([[50.0, 0.0, 0.0], [-50.0, 3.0, 0.0], [0.0, 80.0, -1e6]])
    assert (_shadow(0.018).lit_share(far, np.tile([0.0, 0.0, 1.0], (3, 1))) == 1).all()
