"""Layouts: inside the table, without overlap, with relations, reproducible by seed."""

from dataclasses import replace

import numpy as np
import pytest
from shapely.geometry import MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from generator.errors import SceneError
from generator.geometry import rotation_z
from generator.language.planner import plan_scene
from generator.layout import (
    arrange,
    arrange_more,
    build_models,
    build_top,
    lay_out,
    table_size,
    unmet_relations,
)
from generator.layout.footprint import footprint, gaps, margins, rim_distance
from generator.layout.furniture import outline_of
from generator.layout.rest import GAP, MARGIN
from generator.scene import (
    Model,
    Placement,
    PlannedObject,
    PlannedTable,
    Relation,
    RelationKind,
    ScenePlan,
)

TEXTS = (
    "an office desk",
    "a dining table for two",
    "a workbench with some tools",
    "a bowl with two apples, a mug with a pencil in it and a stack of three books on a round table",
    "six mugs, four plates and a laptop on a triangular table",
    "two lemons on a tray, a yellow mug left of the tray, on a slatted table",
)


def polygon(model: Model, placement: Placement) -> BaseGeometry:
    points = model.mesh.vertices * placement.scale @ rotation_z(placement.yaw).T
    return MultiPoint((points + placement.translation)[:, :2]).convex_hull


@pytest.mark.slow
@pytest.mark.parametrize("text", TEXTS)
@pytest.mark.parametrize("seed", range(5))
def test_everything_stands_free_and_inside(text: str, seed: int) -> None:
    plan = plan_scene(text, seed)
    models = build_models(plan, seed)
    layout, table = lay_out(plan, models, seed)
    assert [p.name for p in layout.placements] == [o.name for o in plan.objects]
    top = Polygon(outline_of(table))
    standing = [p for p in layout.placements if p.on == "table"]
    shapes = [polygon(models[p.name], p) for p in standing]
    for i, shape in enumerate(shapes):
        assert top.buffer(-MARGIN + 1e-4).contains(shape), standing[i].name
        for j in range(i):
            assert shape.distance(shapes[j]) >= GAP - 1e-4, (standing[i].name, standing[j].name)
    for p in standing:
        assert p.translation[2] - p.scale[2] / 2 == pytest.approx(table.size[2])


def planned(*relations: tuple[str, RelationKind, str]) -> ScenePlan:
    targets = {target for _, _, target in relations} - {"table"}
    first = {name for name, _, _ in relations}
    objects = [
        PlannedObject(name, name, name.split("_")[0], {},
                      tuple(Relation(k, t) for n, k, t in relations if n == name))
        for name in sorted(first | targets)
    ]  # fmt: skip
    return ScenePlan("toy", PlannedTable(), tuple(objects))


SIDES: dict[RelationKind, tuple[float, float]] = {
    "left_of": (-1, 0), "right_of": (1, 0), "behind": (0, 1), "in_front_of": (0, -1),
}  # fmt: skip


@pytest.mark.parametrize("kind", SIDES)
def test_sides_hold_for_every_seed(kind: RelationKind) -> None:
    plan = planned(("mug_1", kind, "book_1"), ("apple_1", "next_to", "mug_1"))
    models = build_models(plan, 0)
    table = build_top(plan, models, 0)
    for seed in range(15):
        places = {p.name: p for p in arrange(plan, models, table, seed).placements}
        shapes = {name: polygon(models[name], p) for name, p in places.items()}
        offset = (places["mug_1"].translation - places["book_1"].translation)[:2]
        along = float(offset @ SIDES[kind])
        across = float(np.abs(offset @ np.array(SIDES[kind])[::-1]))
        assert along > across, (seed, offset)
        assert shapes["mug_1"].distance(shapes["book_1"]) < 0.15
        assert shapes["mug_1"].distance(shapes["apple_1"]) < 0.12


@pytest.mark.slow
def test_relations_to_the_table() -> None:
    plan = planned(("mug_1", "left_of", "table"), ("book_1", "center", "table"),
                   ("apple_1", "edge", "table"), ("bowl_1", "behind", "table"))  # fmt: skip
    models = build_models(plan, 0)
    for seed in range(8):
        layout, table = lay_out(plan, models, seed)
        at = {p.name: p.translation[:2] for p in layout.placements}
        outline = outline_of(table)
        assert at["mug_1"][0] < -0.1
        assert at["bowl_1"][1] > 0.05
        assert np.hypot(*at["book_1"]) < 0.08
        rim = margins(footprint(models["apple_1"], 0.0), at["apple_1"][None], outline)[0]
        assert rim < 0.09


@pytest.mark.slow
def test_on_is_on_top_and_in_is_inside() -> None:
    plan = planned(("mug_1", "on", "book_1"), ("apple_1", "in", "bowl_1"),
                   ("pencil_1", "in", "glass_1"))  # fmt: skip
    models = build_models(plan, 0)
    for seed in range(6):
        layout, table = lay_out(plan, models, seed)
        assert not layout.warnings
        at = {p.name: p for p in layout.placements}

        def bottom(name: str, at: dict[str, Placement] = at) -> float:
            return float(at[name].translation[2] - at[name].scale[2] / 2)

        height = float(table.size[2])
        assert bottom("mug_1") == pytest.approx(height + at["book_1"].scale[2], abs=0.002)
        assert at["mug_1"].on == "book_1" and not at["mug_1"].inside
        assert height < bottom("apple_1") < height + 0.5 * at["bowl_1"].scale[2]
        assert at["apple_1"].inside and at["apple_1"].on == "bowl_1"
        assert at["pencil_1"].scale[2] > 0.1, "a pencil stands upright in a glass"
        assert bottom("pencil_1") < height + 0.03
        book = polygon(models["book_1"], at["book_1"])
        assert book.contains(polygon(models["mug_1"], at["mug_1"]).centroid)


def test_what_does_not_fit_in_stands_beside_with_a_warning() -> None:
    plan = planned(("box_1", "in", "mug_1"))
    models = build_models(plan, 0)
    layout, _ = lay_out(plan, models, 0)
    assert all(p.on == "table" for p in layout.placements)
    assert "next to" in layout.warnings[0]


def test_same_seed_same_layout_and_seeds_differ() -> None:
    plan = plan_scene("an office desk", 0)
    models = build_models(plan, 0)
    table = build_top(plan, models, 0)
    one, two, other = (arrange(plan, models, table, seed).placements for seed in (3, 3, 4))
    assert all(np.array_equal(a.translation, b.translation) and a.yaw == b.yaw
               for a, b in zip(one, two, strict=True))  # fmt: skip
    assert any(not np.allclose(a.translation, b.translation)
               for a, b in zip(one, other, strict=True))  # fmt: skip


@pytest.mark.slow
def test_a_crowded_table_grows_and_an_impossible_one_is_refused() -> None:
    few, many = plan_scene("two plates", 0), plan_scene("14 plates", 0)
    models = build_models(many, 0)
    assert table_size(many, models).size[0] > many.table.size[0]
    assert table_size(few, build_models(few, 0)).size == few.table.size
    boards = ScenePlan(
        "boards", PlannedTable("triangle", size=(0.5, 0.5, 0.7)),
        tuple(PlannedObject(f"monitor_{i}", "monitor", "monitor") for i in range(20)),
    )  # fmt: skip
    with pytest.raises(SceneError, match="do not fit"):
        lay_out(boards, build_models(boards, 0), 0)


def test_a_table_too_small_names_what_finds_no_place() -> None:
    plan = planned(("mug_1", "on", "table"), ("laptop_1", "on", "table"))
    models = build_models(plan, 0)
    small = build_top(ScenePlan("s", PlannedTable(size=(0.3, 0.25, 0.7)), ()), {}, 0)
    with pytest.raises(SceneError, match="laptop_1"):
        arrange(plan, models, small, 0)


def test_fronts_face_the_viewer_and_cutlery_points_away() -> None:
    plan = plan_scene("a laptop, and a plate with a fork to its left and a knife to its right", 0)
    models = build_models(plan, 0)
    for seed in range(6):
        yaw = {p.name: np.rad2deg(p.yaw) for p in lay_out(plan, models, seed)[0].placements}
        assert abs(yaw["laptop_1"]) < 10
        assert abs(yaw["fork_1"] + 90) < 10 and abs(yaw["knife_1"] + 90) < 10


def test_equal_things_share_a_look_and_unknown_ones_have_their_size() -> None:
    plan = plan_scene("two red mugs, a green mug and a 20 cm long quuxel on a table", 0)
    models = build_models(plan, 0)
    textures = [models[f"mug_{i}"].mesh.texture for i in (1, 2, 3)]
    assert np.array_equal(textures[0], textures[1])
    assert textures[2].shape != textures[0].shape or not np.array_equal(textures[1], textures[2])
    assert models["quuxel_1"].size.max() == pytest.approx(0.2)
    assert models["quuxel_1"].label == "quuxel"


def test_gaps_bound_the_true_distance_from_below() -> None:
    rng = np.random.default_rng(0)
    models = build_models(plan_scene("a book, a banana and a fork", 0), 0)
    for _ in range(60):
        first, second = rng.choice(sorted(models), 2)
        a = Placement(
            first, rng.uniform(-3, 3), np.append(rng.uniform(-0.3, 0.3, 2), 0), models[first].size
        )
        b = Placement(second, rng.uniform(-3, 3), np.append(rng.uniform(-0.3, 0.3, 2), 0),
                      models[second].size)  # fmt: skip
        bound = gaps(footprint(models[first], a.yaw), a.translation[None, :2],
                     footprint(models[second], b.yaw), b.translation[:2])[0]  # fmt: skip
        true = polygon(models[first], a).distance(polygon(models[second], b))
        assert bound <= true + 1e-6
        assert true - bound < 0.02 or bound < 0


def test_the_plans_style_is_how_its_objects_are_drawn() -> None:
    plan = plan_scene("a mug and a book on a table", 0)
    plain = build_models(plan, 0)["mug_1"]
    drawn = build_models(replace(plan, style="cartoon"), 0)["mug_1"]
    assert (plain.mesh.texture.shape != drawn.mesh.texture.shape) or (
        plain.mesh.texture != drawn.mesh.texture
    ).any()
    rustic = build_models(replace(plan, style="rustic"), 0)["mug_1"]
    np.testing.assert_array_equal(rustic.mesh.texture, plain.mesh.texture)


def test_one_more_thing_faces_as_told_and_stands_where_it_was_asked_for() -> None:
    plan = plan_scene("a mug left of a laptop on a desk", 0)
    models = build_models(plan, 0)
    table = build_top(plan, models, 0)
    height = float(table.size[2] + models["laptop_1"].size[2] / 2)
    laptop = Placement("laptop_1", 0.0, np.array([0, 0, height]), models["laptop_1"].size)
    placed = {"laptop_1": laptop}
    (mug,) = arrange_more(plan, placed, models, table, 0, {"mug_1": 1.25}).placements
    assert mug.yaw == 1.25
    planned = next(o for o in plan.objects if o.name == "mug_1")
    assert unmet_relations(planned, mug, placed, models, table) == ()
    other = replace(mug, translation=mug.translation * [-1, 1, 1])
    assert unmet_relations(planned, other, placed, models, table) == planned.relations


def test_cups_on_saucers_stand_around_a_teapot() -> None:
    plan = plan_scene("Three cups, each on a saucer, around a teapot.", 0)
    layout, _ = lay_out(plan, build_models(plan, 0), 0)
    at = {p.name: p.translation[:2] for p in layout.placements}
    ways = [at[f"saucer_{k}"] - at["teapot_1"] for k in (1, 2, 3)]
    distances = [float(np.hypot(*way)) for way in ways]
    assert max(distances) - min(distances) < 0.02
    angles = np.sort([np.arctan2(way[1], way[0]) for way in ways])
    assert np.diff(angles).min() > 1.5


@pytest.mark.parametrize(
    ("text", "front", "behind"),
    [
        ("a microscope in the centre and a textbook in front of it", "textbook_1", "microscope_1"),
        ("a stack of four bowls and a whisk lying in front of the stack", "whisk_1", "bowl_1"),
    ],
)
@pytest.mark.parametrize("seed", range(3))
def test_what_is_in_front_of_a_thing_is_not_aside(
    text: str, front: str, behind: str, seed: int
) -> None:
    plan = plan_scene(text, seed)
    models = build_models(plan, seed)
    layout, _ = lay_out(plan, models, seed)
    places = {p.name: p.translation for p in layout.placements}
    x, y, _ = places[behind] - places[front]
    assert y > 1.2 * abs(x)
    assert layout.strain < 1.0


@pytest.mark.parametrize("seed", range(3))
def test_sides_hold_on_what_carries_both(seed: int) -> None:
    text = "everything placed on a grey cloth: a skull, an hourglass to the right of the skull"
    plan = plan_scene(text, seed)
    models = build_models(plan, seed)
    layout, _ = lay_out(plan, models, seed)
    places = {p.name: p for p in layout.placements}
    told = next(o for o in plan.objects if o.name == "hourglass_1").relations
    (other,) = [r.target for r in told if r.kind == "right_of"]
    assert places["hourglass_1"].on == "cloth_1" == places[other].on
    assert places["hourglass_1"].translation[0] > places[other].translation[0]


def test_distance_to_the_rim_along_a_direction() -> None:
    square = np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1]])
    points = np.array([[0.0, 0.5], [0.5, 0.0]])
    assert rim_distance(points, np.array([1.0, 0]), square).tolist() == [1.0, 0.5]
    diagonal = np.array([1.0, 1]) / np.sqrt(2)
    assert np.allclose(rim_distance(points, diagonal, square), np.sqrt(0.5))
