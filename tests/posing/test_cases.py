"""Stated faults of the input, and cases whose picture tells the pose."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from posing import solving
from posing.cases import VARIANTS, Draw, TurnCase, draw_case, looking_camera, photograph, pose_case
from posing.distinct import DISTINCT, alike
from posing.spoiling import HOLE, Spoiling, erode, occluder, punch, wrong_size
from shapes import cylinder_mesh

from generator.errors import InputError
from generator.geometry import yaw_quaternion
from generator.render.raster import place, render
from generator.render.shading import Light
from generator.scene import Model, View
from tabletop_objects import build

VIEW = View(azimuth=0.0, elevation=np.deg2rad(40.0), fov=np.deg2rad(36.0))


def disc(radius: float) -> np.ndarray:
    rows, columns = np.ogrid[:200, :200]
    return np.hypot(rows - 100, columns - 100) <= radius


def test_erosion_takes_exactly_that_many_pixels() -> None:
    got = erode(disc(60), 5)
    assert (disc(54) & ~got).sum() == 0
    assert (got & ~disc(56)).sum() == 0
    assert erode(disc(60), 0).sum() == disc(60).sum()


def test_holes_take_their_share() -> None:
    mask = disc(80)
    one = punch(mask, 1, np.random.default_rng(3))
    assert (mask & ~one).sum() == pytest.approx(HOLE * mask.sum(), rel=0.2)
    many = punch(mask, 12, np.random.default_rng(3))
    assert 4 * HOLE < (mask & ~many).sum() / mask.sum() <= 12.5 * HOLE
    assert not (many & ~mask).any()


@pytest.mark.parametrize("share", [0.0, 0.1, 0.35, 0.8])
@pytest.mark.parametrize("seed", range(4))
def test_an_occluder_hides_the_stated_share(share: float, seed: int) -> None:
    mask = disc(50)
    mask[:, 130:] = False
    front = occluder(mask, share, np.random.default_rng(seed))
    assert (mask & front).sum() / mask.sum() == pytest.approx(share, abs=0.005)


def test_a_wrong_size_stays_in_its_bounds() -> None:
    rng = np.random.default_rng(0)
    draws = np.array([wrong_size(np.ones(3), 0.2, rng) for _ in range(500)])
    assert draws.min() > 0.8**2 - 1e-9 and draws.max() < 1.2**2 + 1e-9
    assert np.ptp(draws, axis=1).max() > 0.2  # per axis
    assert np.ptp(draws.mean(1)) > 0.3  # and overall


@pytest.mark.parametrize("wrong", [{"occlude": 1.0}, {"erode": -1}, {"elevation": math.nan}])
def test_amounts_out_of_range_are_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=r"must be in"):
        Spoiling(**wrong)


@pytest.mark.slow
def test_the_part_of_the_picture_that_is_drawn_is_the_whole_pictures() -> None:
    model, camera = build("mug", 5), looking_camera(VIEW)
    item = place(model.mesh, model.size, np.array([0.2, 0.1, 0.05]), yaw_quaternion(0.4), 1)
    _, mask = photograph(item, camera, Light(), np.random.default_rng(0))
    whole = render([item], camera, supersample=2, shadows=False).ids == 1
    assert (mask ^ whole).sum() < 0.01 * whole.sum()


def difference_of_mug(yaw: float, hidden: bool = False) -> float:
    """Return the difference to the most similar side of a mug seen from the front, 25 degrees
    up."""
    model = build("mug", 5)
    low = dataclasses.replace(VIEW, elevation=np.deg2rad(25.0))
    camera = looking_camera(low)
    at = np.array([0.0, 0.0, model.size[2] / 2])
    front = np.zeros((camera.height, camera.width), bool)
    if hidden:
        front[:, camera.width // 2 :] = True
    return alike(model, yaw, at, camera, Light(), front)


@pytest.mark.slow
def test_a_case_is_well_posed_if_the_picture_tells_the_side() -> None:
    mug = build("mug", 5).mesh
    body = float(np.median(mug.vertices[np.abs(mug.vertices[:, 1]) > 0.3, 0]))
    assert abs(body) > 0.05  # the handle points along x, away from the body
    right = 0.0 if body < 0 else np.pi
    assert difference_of_mug(right) > DISTINCT
    assert difference_of_mug(right, hidden=True) < difference_of_mug(right)


@pytest.mark.slow
def test_a_round_thing_makes_no_case_and_is_counted() -> None:
    can = Model("can", "can", cylinder_mesh(), np.array([0.08, 0.08, 0.1]))
    got = pose_case(can, "can", 1, Draw(), np.random.default_rng(0))
    assert got == "alike"
    mixed = Draw(models=(can, build("toy_train", 5)))
    cases = [draw_case(mixed, k) for k in range(4)]
    assert {c.variant for c in cases} == {"toy_train"}
    assert ("can", "symmetric") in [d for c in cases for d in c.dropped]


@pytest.mark.slow
def test_cases_come_again_and_splits_share_none() -> None:
    only = ("toy_train", "mug")
    spoiling = Spoiling(elevation=5, azimuth=3, occlude=0.2, erode=1, size_error=0.2)
    dev = [draw_case(Draw("dev", only=only, spoiling=spoiling), k) for k in range(3)]
    again = draw_case(Draw("dev", only=only, spoiling=spoiling), 2)
    test = [draw_case(Draw("test", only=only, spoiling=spoiling), k) for k in range(3)]
    assert (again.yaw, again.variant) == (dev[2].yaw, dev[2].variant)
    assert (np.asarray(again.instance.crop) == np.asarray(dev[2].instance.crop)).all()
    for split, cases in (("dev", dev), ("test", test)):
        low, high = VARIANTS[split]
        assert all(low <= int(c.variant.split(":")[1]) < high for c in cases)
    assert VARIANTS["dev"][1] <= VARIANTS["test"][0]
    assert not {c.yaw for c in dev} & {c.yaw for c in test}
    assert all(0 < c.hidden <= 0.2 and c.instance.occluded for c in dev)
    assert all(not np.allclose(c.model.size, c.true.size) for c in dev)
    for case in dev:
        alpha = np.asarray(case.instance.crop)[..., 3] > 0
        assert alpha.sum() == np.asarray(case.instance.mask).sum()


def plain_case(**spoiled: float) -> TurnCase:
    return draw_case(Draw(only=("toy_train",), spoiling=Spoiling(**spoiled)), 0)  # type: ignore[arg-type]


@pytest.mark.slow
def test_the_true_yaw_implies_the_true_size() -> None:
    case = plain_case()
    assert solving.implied_scale(case, case.yaw) == pytest.approx(1, abs=0.02)
    smaller = dataclasses.replace(
        case, model=dataclasses.replace(case.model, size=case.model.size * 0.8)
    )
    assert solving.implied_scale(smaller, case.yaw) == pytest.approx(1.25, abs=0.03)


@pytest.mark.slow
def test_a_wrong_azimuth_turns_the_world_and_is_no_error_of_the_yaw() -> None:
    case = plain_case(azimuth=10)
    off = case.view.azimuth - solving._azimuth(case.camera.rotation)
    assert abs(off) > 0.01
    assert solving.camera_yaw_error(case, case.yaw + off) == pytest.approx(0, abs=1e-6)
    assert solving.camera_yaw_error(case, case.yaw + off + 0.3) == pytest.approx(np.rad2deg(0.3))
