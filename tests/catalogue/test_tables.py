"""Tables of every outline and leg style."""

import itertools

import numpy as np
import pytest

from generator.errors import InputError
from generator.geometry import inside_margin
from generator.objects.checks import fingerprint, is_closed
from generator.scene import PlannedTable
from generator.tables import LEGS, OUTLINES, build_table, outline_of


@pytest.mark.slow
@pytest.mark.parametrize(("outline", "legs"), [*itertools.product(OUTLINES, LEGS)])
def test_table_is_sound(outline: str, legs: str):
    size = (0.9, 0.9, 0.74) if outline in ("round", "square") else (1.3, 0.8, 0.72)
    plan = PlannedTable(outline, "walnut", legs, size)  # type: ignore[arg-type]
    table = build_table(plan, 3)
    assert is_closed(table.mesh)
    np.testing.assert_allclose(table.size, size)
    bounds = np.stack([p.bounds for p in table.parts])
    assert np.abs(bounds).max() <= 0.5 + 1e-6
    top = table.parts[0].bounds
    assert top[1, 2] == pytest.approx(0.5)
    assert top[0, 2] * size[2] > 0.25
    lowest = bounds[:, 0, 2].min()
    assert lowest == pytest.approx(-0.5, abs=1e-3), "no leg reaches the floor"
    assert len(table.parts) <= 12
    assert max(len(p.vertices) for p in table.parts) <= 32


@pytest.mark.parametrize("outline", OUTLINES)
def test_top_is_flat_and_has_its_outline(outline: str):
    plan = PlannedTable(outline, "pine", "tapered", (1.0, 0.8, 0.74))  # type: ignore[arg-type]
    table = build_table(plan, 0)
    high = table.mesh.vertices[table.mesh.vertices[:, 2] > 0.49]
    assert (high[:, 2] == 0.5).all()
    points = high[:, :2] * table.size[:2]
    assert inside_margin(points, outline_of(plan)).min() > -0.02
    corner = np.array([[0.495, 0.395]])
    inside = inside_margin(corner, outline_of(plan))[0] > 0
    assert inside == (outline in ("rectangle", "square", "slatted"))


def test_triangle_has_three_legs():
    plan = PlannedTable("triangle", "oak", "straight", (1.0, 0.9, 0.74))
    assert len(build_table(plan, 0).parts) == 1 + 3


def test_materials_and_colors_show():
    def mean(**words: str) -> np.ndarray:
        table = build_table(PlannedTable(**words), 0)  # type: ignore[arg-type]
        return table.mesh.texture.reshape(-1, 3).mean(0)

    assert mean(material="walnut").sum() < mean(material="pine").sum()
    assert mean(material="black").max() < 80 < 180 < mean(material="white").min()
    teal = mean(material="oak", color="teal")
    assert teal[1] > teal[0]


def test_same_seed_same_bytes():
    plan = PlannedTable()
    assert fingerprint(build_table(plan, 5)) == fingerprint(build_table(plan, 5))
    assert fingerprint(build_table(plan, 5)) != fingerprint(build_table(plan, 6))


def test_impossible_tables_are_refused():
    with pytest.raises(InputError, match=r"0\.2 to 4 m"):
        build_table(PlannedTable(size=(1.0, 9.0, 0.7)), 0)
    with pytest.raises(InputError, match="Available: hairpin"):
        build_table(PlannedTable(legs="antler"), 0)
    with pytest.raises(InputError, match="Unknown table outline 'hexagon'"):
        build_table(PlannedTable(outline="hexagon"), 0)  # type: ignore[arg-type]
