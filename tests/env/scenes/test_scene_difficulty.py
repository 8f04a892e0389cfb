"""Difficulty of a scene, term by term."""

from dataclasses import replace

import numpy as np
import pytest
from toy import toy_object, toy_scene, toy_table

import assets_cache
from generator.bundle import load
from generator.errors import InputError
from generator.scene import Object
from tabletopgen_env.robot.mount import Mount
from tabletopgen_env.scenes import difficulty, difficulty_terms

CUBE = (0.045, 0.045, 0.045)


def terms(*objects: Object):
    return difficulty_terms(toy_scene(objects))


def cube(name: str, x: float, y: float = -0.05, size=CUBE, **more) -> Object:
    return toy_object(name, size, (x, y), **more)


@pytest.mark.slow
def test_the_starters_spread_over_the_range() -> None:
    bundles = assets_cache.find("starter")
    found = {path.name: difficulty(load(path)) for path in bundles}
    assert all(0 < value < 1 for value in found.values())
    assert max(found.values()) - min(found.values()) > 0.25
    assert found[bundles[0].name] == difficulty(load(bundles[0]))


def test_it_is_the_mean_of_its_terms_and_a_bare_table_is_easy() -> None:
    found = terms(cube("a_1", 0), cube("b_1", 0.1))
    scene = toy_scene((cube("a_1", 0), cube("b_1", 0.1)))
    assert difficulty(scene) == pytest.approx(sum(found.values()) / 6)
    assert set(difficulty_terms(toy_scene(())).values()) == {0.0}
    assert difficulty(toy_scene(())) == 0.0


def test_clutter_is_what_covers_the_table() -> None:
    one, four = (0.1, 0.1, 0.03), (0.2, 0.2, 0.03)
    assert terms(cube("a_1", 0, size=one))["clutter"] == pytest.approx(0.01 / (1.2 * 0.7) / 0.35)
    assert terms(cube("a_1", 0, size=four))["clutter"] == pytest.approx(0.04 / 0.84 / 0.35)
    small = toy_scene((cube("a_1", 0, 0, size=one),), table=toy_table(size=(0.3, 0.3, 0.74)))
    assert difficulty_terms(small)["clutter"] == pytest.approx(0.01 / 0.09 / 0.35)


def test_clearance_is_the_gap_to_the_nearest_neighbour() -> None:
    def clearance(gap: float) -> float:
        return terms(cube("a_1", 0), cube("b_1", 0.045 + gap))["clearance"]

    assert clearance(0.0) == pytest.approx(1.0)
    assert clearance(0.06) == pytest.approx(0.5)
    assert clearance(0.2) == 0.0
    assert terms(cube("a_1", 0))["clearance"] == 0.0
    far = terms(cube("a_1", 0), cube("b_1", 0.105), cube("c_1", 0.5))["clearance"]
    assert far == pytest.approx((0.5 + 0.5 + 0) / 3)


def test_what_stands_on_other_things_covers_no_table() -> None:
    low, high = cube("a_1", 0, size=(0.2, 0.2, 0.03)), cube("b_1", 0, top=0.77)
    high = replace(high, placement=replace(high.placement, on="a_1"))
    together, alone = terms(low, high), terms(low)
    assert together["clutter"] == alone["clutter"]
    assert together["clearance"] == 0.0


def test_distance_grows_away_from_the_robot() -> None:
    distances = [
        difficulty_terms(toy_scene((
            cube("a_1", 0, -0.1), cube("b_1", 0, 0.1), cube("c_1", 0, y),
        )))["distance"] for y in (-0.05, 0.2, 0.3)
    ]  # fmt: skip
    assert distances == sorted(distances) and distances[0] < distances[2]
    long = toy_scene(
        (*(cube(f"a_{k}", 0.1 * k, 0) for k in range(8)), cube("z_1", -1.3, 0)),
        table=toy_table(size=(3.0, 0.7, 0.74)),
    )
    near = difficulty_terms(long.replace(objects=long.objects[:-1]))["distance"]
    assert difficulty_terms(long)["distance"] == pytest.approx((near * 8 + 1) / 9, abs=0.05)


@pytest.mark.parametrize(
    ("size", "expected"),
    [
        ((0.04, 0.04, 0.06), 0.0),
        ((0.062, 0.2, 0.06), 0.5),  # wide: the fingers open 8 cm, 6 mm of them for clearance
        ((0.02, 0.2, 0.06), 0.5),  # narrow
        ((0.04, 0.04, 0.026), 0.5),  # low
        ((0.02, 0.2, 0.012), 1.0),  # the worst of them
        ((0.2, 0.2, 0.2), 1.0),  # nothing can be grasped
    ],
)
def test_size_is_how_it_suits_the_hand(size, expected) -> None:
    assert terms(cube("a_1", 0, size=size))["size"] == pytest.approx(expected)


def test_what_cannot_be_grasped_is_in_the_way_only_and_vessels_have_walls() -> None:
    wide = cube("safe_1", 0.4, size=(0.3, 0.3, 0.3))
    assert terms(cube("a_1", 0), wide)["size"] == 0.0
    assert terms(cube("a_1", 0, mass=0.2), cube("b_1", 0.3, mass=20.0))["size"] == 0.0
    mug = toy_object("mug_1", (0.085, 0.085, 0.095), (0, 0), wall=0.006)
    assert terms(mug)["size"] == pytest.approx(0.5)


def test_more_things_are_harder_up_to_many() -> None:
    def objects(count: int) -> float:
        size = (0.02, 0.02, 0.05)
        return terms(*(cube(f"c_{k}", 0.05 * k - 0.5, size=size) for k in range(count)))["objects"]

    assert objects(4) == pytest.approx(0.2)
    assert objects(21) == 1.0


def test_stacking_counts_what_lies_below() -> None:
    low, middle = cube("a_1", 0, size=(0.2, 0.2, 0.03)), cube("b_1", 0, top=0.77)
    high = cube("c_1", 0, top=0.77 + CUBE[2])
    middle = replace(middle, placement=replace(middle.placement, on="a_1"))
    high = replace(high, placement=replace(high.placement, on="b_1"))
    assert terms(low)["stacking"] == 0.0
    assert terms(low, middle)["stacking"] == pytest.approx(0.25)
    scene = toy_scene((low, middle, high))
    assert difficulty_terms(scene)["stacking"] == pytest.approx(0.5)
    found = [difficulty_terms(scene, name)["stacking"] for name in ("a_1", "b_1", "c_1")]
    assert found == [0.0, 0.5, 1.0]


def test_a_target_has_its_own_difficulty() -> None:
    near, beside = cube("near_1", 0, -0.1), cube("beside_1", 0.065, -0.1)
    far, wide = cube("far_1", 0.4, 0.25), cube("wide_1", -0.4, 0.2, size=(0.2, 0.2, 0.2))
    scene = toy_scene((near, beside, far, wide))
    found = {o.name: difficulty_terms(scene, o.name) for o in scene.objects}
    assert found["near_1"]["clearance"] == pytest.approx(1 - 0.02 / 0.12, abs=0.01)
    assert found["far_1"]["clearance"] == 0.0
    base = Mount.beside(scene).position
    away = {o.name: float(np.hypot(*(o.pose.position - base)[:2])) for o in scene.objects}
    assert found[max(away, key=away.__getitem__)]["distance"] == max(
        terms["distance"] for terms in found.values()
    )
    assert len({terms["distance"] for terms in found.values()}) > 1
    assert found["wide_1"]["size"] == 1.0 > found["near_1"]["size"]
    assert len({term["clutter"] for term in found.values()}) == 1
    assert difficulty(scene, "wide_1") == pytest.approx(sum(found["wide_1"].values()) / 6)
    with pytest.raises(InputError, match="lamp_1"):
        difficulty(scene, "lamp_1")
