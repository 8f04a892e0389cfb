"""Detections compared with depth: flat ones, spilled and broken masks, missed objects."""

from dataclasses import replace

import numpy as np
import pytest
from shots import THINGS, Shot, scene_of, shoot

from generator.backends.embedded.depth.plane import find_depth_plane
from generator.backends.embedded.depth.things import confirm, height_above_floor
from generator.backends.embedded.imager import EmbeddedImager
from generator.backends.embedded.plane.plane import TablePlane
from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.geometry import mask_box
from generator.meshes.pixels import mask_iou
from generator.method.alignment import Alignment, align
from generator.method.models import align_canonically
from generator.scene import Detection, Model, Rotation
from tabletop_objects import build


@pytest.fixture(scope="module")
def shot() -> Shot:
    return shoot()


@pytest.fixture(scope="module")
def plane(shot: Shot) -> TablePlane:
    return find_depth_plane(shot.depth, shot.intrinsics)


def detection(mask: np.ndarray, label: str = "thing", score: float = 0.5) -> Detection:
    return Detection(label, mask_box(mask), mask, score)


def truth(shot: Shot) -> list[np.ndarray]:
    return [shot.picture.ids == number for number in range(1, len(THINGS) + 1)]


def grown(mask: np.ndarray, pixels: int) -> np.ndarray:
    out = mask.copy()
    for _ in range(pixels):
        padded = np.pad(out, 1)
        out = padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:] | out
    return out


def test_things_are_proposed_by_depth_alone(shot, plane):
    masks = [d.mask for d in confirm([], shot.depth, plane)]
    for number in range(1, 4):
        true = shot.picture.ids == number
        assert max((true & m).sum() / (true | m).sum() for m in masks) > 0.5
    assert len(masks) <= 5


def test_right_masks_stay_as_they_are(shot, plane):
    found = [detection(m) for m in truth(shot)]
    got = confirm(found, shot.depth, plane)
    assert len(got) == len(found)
    for before, after in zip(found, got, strict=True):
        assert mask_iou(before.mask, after.mask) > 0.95


def test_a_flat_find_needs_more_certainty(shot, plane):
    patch = np.zeros(shot.depth.shape, bool)
    ((x, y),) = plane.to_pixels(np.array([[-0.35, -0.2]])).astype(int)
    patch[y - 5 : y + 5, x - 10 : x + 10] = True
    assert (shot.picture.ids[patch] == 0).all()
    things = [detection(m) for m in truth(shot)]
    labels = [d.label for d in confirm([*things, detection(patch, "shadow")], shot.depth, plane)]
    assert labels == ["thing"] * 3
    sure = confirm([*things, detection(patch, "card", 0.9)], shot.depth, plane)
    assert [d.label for d in sure] == ["thing"] * 3 + ["card"]


def test_masks_lose_the_tabletop_around_a_thing(shot, plane):
    masks = truth(shot)
    wide = [detection(grown(m, 8)) for m in masks]
    for true, before, after in zip(masks, wide, confirm(wide, shot.depth, plane), strict=True):
        assert mask_iou(true, after.mask) > mask_iou(true, before.mask) + 0.08
        assert (after.mask & true).sum() > 0.97 * true.sum()


def test_an_upper_part_that_stands_on_nothing_joins_the_lower(shot, plane):
    bowl, mug, apple = truth(shot)
    rows = np.arange(len(mug))[:, None]
    _, top, _, low = mask_box(mug)
    upper = mug & (rows < top + 0.45 * (low - top))
    parts = [detection(bowl), detection(upper), detection(mug & ~upper), detection(apple)]
    got = confirm(parts, shot.depth, plane)
    assert len(got) == 3
    assert max(mask_iou(d.mask, mug) for d in got) > 0.95


def halves(shot: Shot, number: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the upper and the lower half of an object's mask."""
    mask = shot.picture.ids == number
    _, top, _, low = mask_box(mask)
    upper = mask & (np.arange(len(mask))[:, None] < (top + low) / 2)
    return upper, mask & ~upper


@pytest.mark.slow
def test_a_print_on_a_box_is_the_box_however_certain():
    shot = shoot(things=[("cereal_box", 0.0, 0.0, 0.0)], elevation=20)
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    upper, lower = halves(shot, 1)
    x0, y0, x1, y1 = mask_box(lower).astype(int)
    printed = np.zeros_like(lower)
    printed[y0 : y0 + (y1 - y0) // 2, x0 + (x1 - x0) // 4 : x1 - (x1 - x0) // 4] = True
    got = confirm([detection(m, score=0.98) for m in (upper, printed)], shot.depth, plane)
    assert len(got) == 1
    assert (got[0].mask & upper).sum() > 0.95 * upper.sum()


@pytest.mark.slow
@pytest.mark.parametrize(("certainty", "things"), [(0.5, 1), (0.95, 2)])
def test_what_is_certain_joins_only_what_continues_its_flat_side(certainty, things):
    near, far = build("book", 1).size, build("bottle", 1).size
    gap = float(near[1] + far[1]) / 2 + 0.005
    shot = shoot(things=[("bottle", 0.0, gap, 0.0), ("book", 0.0, 0.0, 0.0)], elevation=12)
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    upper, lower = halves(shot, 1)
    book = lower | (shot.picture.ids == 2)
    found = [detection(upper, score=certainty), detection(book, score=0.95)]
    assert len(confirm(found, shot.depth, plane)) == things


@pytest.mark.slow
def test_a_thing_on_another_stays_a_thing():
    height = build("book", 1).size[2]
    shot = shoot(things=[("book", -0.2, 0.0, 0.0), ("apple", -0.2, 0.0, height)])
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    found = [detection(shot.picture.ids == number) for number in (1, 2)]
    assert len(confirm(found, shot.depth, plane)) == 2


def test_what_nobody_saw_is_added(shot, plane):
    bowl, mug, apple = truth(shot)
    got = confirm([detection(mug), detection(bowl)], shot.depth, plane)
    assert len(got) == 3
    assert mask_iou(got[-1].mask, apple) > 0.6


@pytest.mark.slow
@pytest.mark.parametrize(("azimuth", "elevation"), [(0, 30), (20, 45)])
def test_the_floor_tells_the_height_of_the_table(azimuth, elevation):
    shot = shoot(azimuth=azimuth, elevation=elevation)
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    assert height_above_floor(shot.depth, plane) == pytest.approx(0.74, abs=0.02)


def test_no_floor_in_sight_leaves_the_height_open(shot, plane):
    floor = ~np.isfinite(shot.picture.depth)
    assert height_above_floor(np.where(floor, 0, shot.depth), plane) is None


# --------------------------------------------------------------------------- into the scene
def aligned(shot: Shot, names: tuple[str, ...], wrong: np.ndarray) -> Alignment:
    """Compute sizes, models and positions from true masks; the modeler's sizes are off by
    ``wrong``."""
    reference, instances = scene_of(shot, names)
    reasoner, imager = EmbeddedReasoner(), EmbeddedImager()
    view = reasoner.estimate_view(reference, instances[0])
    sizes = reasoner.estimate_sizes(reference, instances, view)
    models: dict[str, Model] = {}
    for instance in instances[1:]:
        made = build(instance.label, 1)
        raw = replace(made, size=np.asarray(made.size) * wrong)
        models[instance.name] = align_canonically(raw, instance, sizes[instance.name], reasoner)
    rotations = {name: Rotation(name, 0.4, 0.0) for name in names}
    nobody: object = None
    return align(reference, instances, models, sizes, rotations, view, imager, nobody, reasoner)


@pytest.mark.slow
@pytest.mark.parametrize(
    "things",
    [
        [("bowl", 0.2, 0.15, 0.0), ("mug", -0.25, 0.05, 0.0), ("apple", 0.1, -0.15, 0.0)],
        [("book", -0.3, 0.1, 0.0), ("bottle", 0.3, 0.2, 0.0), ("bowl", 0.0, -0.15, 0.0)],
    ],
)
def test_scenes_have_the_measured_places_and_sizes(things):
    """Whatever the modeler's sizes: positions within 2 cm, sizes within 15 %."""
    shot = shoot(things=things, noise=0.002, elevation=42, azimuth=15)
    names = tuple(key for key, *_ in things)
    found = aligned(shot, names, np.array([1.5, 1.5, 1.2]))
    assert found.table_scale[2] == pytest.approx(0.74, abs=0.02)
    for placement, (key, x, y, _) in zip(found.placements, things, strict=True):
        assert np.hypot(*(placement.translation[:2] - [x, y])) < 0.02, key
        np.testing.assert_allclose(placement.scale, build(key, 1).size, rtol=0.15, err_msg=key)
