"""The checks of a category can fail, each for its own reason."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from generator.objects import checks
from generator.objects.checks import CheckResult, check_category, is_closed
from generator.scene import ConvexPart, Mesh, Model
from tabletop_objects import build, get_category
from tabletop_objects.catalogue import find_source, load_category
from tabletop_objects.kit.shapes import Category, Shape, shape
from tabletop_objects.kit.surfaces import Look


def declared(key: str = "mug") -> Category:
    return load_category(get_category(key))


def failures(category: Category, source: Path | None = None) -> dict[str, str]:
    results = check_category(category, source or find_source(get_category("mug"))[0])
    return {r.name: r.detail for r in results if not r.passed}


def test_a_sound_category_passes_all_checks() -> None:
    results = check_category(declared(), find_source(get_category("mug"))[0])
    assert [r for r in results if not r.passed] == []
    assert len({r.name for r in results}) == len(results) > 15
    assert all(r.detail for r in results)


def remade(change: Callable[[Shape], Shape]) -> Category:
    plain = declared()
    return replace(plain, shape=lambda look: change(plain.shape(look)))


def move_parts(made: Shape, z: float) -> Shape:
    parts = tuple(ConvexPart(p.vertices + np.array([0, 0, z])) for p in made.parts)
    return replace(made, parts=parts)


def flip(made: Shape) -> Shape:
    pieces = [(replace(p.solid, faces=p.solid.faces[:, ::-1]), p.tile) for p in made.pieces]
    return shape(pieces, made.parts)


def tear(made: Shape) -> Shape:
    pieces = [(replace(p.solid, faces=p.solid.faces[1:]), p.tile) for p in made.pieces]
    return shape(pieces, made.parts)


def lean(made: Shape) -> Shape:
    """Keep the part of the floor that lies beside the centre of mass."""
    foot = np.array([[x, y, z] for x in (0.03, 0.04) for y in (-0.01, 0.01) for z in (0, 0.05)])
    return replace(made, parts=(ConvexPart(foot),))


CHANGES: dict[str, tuple[Callable[[Shape], Shape], str]] = {
    "torn mesh": (tear, "closed surface"),
    "inside out": (flip, "positive volume"),
    "floating part": (lambda made: move_parts(made, 0.002), "parts reach the bottom"),
    "part outside": (lambda made: move_parts(made, 0.02), "parts within the box"),
    "no parts": (lambda made: replace(made, parts=()), "convex parts"),
    "many parts": (lambda made: replace(made, parts=3 * made.parts), "convex parts"),
    "large": (lambda made: made.scale(3.0), "nominal size"),
    "unstable": (lean, "rest"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CHANGES)
def test_a_wrong_shape_fails(name: str) -> None:
    change, check = CHANGES[name]
    assert check in failures(remade(change))


@pytest.mark.slow
def test_wrong_facts_fail() -> None:
    assert not checks.check_mass(replace(declared(), mass=3.0), build("mug", 0)).passed
    assert "nominal size" in failures(replace(declared(), size=(0.11, 0.083, 0.2)))
    assert "bowl" in failures(replace(declared(), aliases=("salad bowl",)))["names"]
    assert "wine_glass" in failures(replace(declared(), noun="goblet"))["names"]


@pytest.mark.slow
def test_variants_that_look_alike_fail() -> None:
    plain = declared()
    alike = replace(plain, shape=lambda look: plain.shape(Look(np.random.default_rng(0), {})))
    assert {"looks", "seeds"} <= {*failures(alike)}


def test_randomness_without_the_seed_fails() -> None:
    models = [build("mug", seed) for seed in range(3)]
    assert checks.check_seeds(models, models[1]).passed
    assert not checks.check_seeds(models, build("mug", 7)).passed


def test_a_drawing_function_that_raises_fails_one_check() -> None:
    def broken(look: Look) -> Shape:
        raise ZeroDivisionError("no radius")

    found = failures(replace(declared(), shape=broken))
    assert list(found) == ["drawing"]
    assert "no radius" in found["drawing"] and "test_checks.py" in found["drawing"]


def test_the_index_is_compared_with_the_module(tmp_path: Path) -> None:
    source, _ = find_source(get_category("mug"))
    index = tmp_path / "index.json"
    index.write_text(json.dumps({}))
    missing = checks.check_index(declared(), source, index)
    assert not missing.passed and "missing" in missing.detail
    assert "python -m tabletop_objects.index" in missing.detail
    stale = checks.check_index(replace(declared(), mass=0.4), source)
    assert not stale.passed and "out of date" in stale.detail
    assert checks.check_index(declared(), source).passed


def test_a_flat_part_and_far_texture_coordinates_fail() -> None:
    model = build("mug", 0)
    flat = model.parts[0].vertices * [1, 1, 0]
    thin = replace(model, parts=(ConvexPart(flat - [0, 0, 0.5]),))
    assert "parts not flat" in names(checks.check_parts([thin]))
    mesh = model.mesh
    far = replace(model, mesh=Mesh(mesh.vertices, mesh.faces, mesh.uv + 1, mesh.texture))
    assert names(checks.check_shape([far])) == ["uv"]
    large = Mesh(mesh.vertices, mesh.faces, mesh.uv, np.zeros((8, 648, 3), np.uint8))
    assert names(checks.check_shape([replace(model, mesh=large)])) == ["texture"]
    assert names(checks.check_shape([model], 100)) == ["faces"]


def names(results: Iterable[CheckResult]) -> list[str]:
    return [r.name for r in results if not r.passed]


def test_a_torn_surface_is_not_closed() -> None:
    whole = build("book", 0).mesh
    torn = Mesh(whole.vertices, whole.faces[1:], whole.uv, whole.texture)
    assert is_closed(whole)
    assert not is_closed(torn)


def test_a_style_may_not_change_the_size() -> None:
    plain: Model = build("mug", 0)
    styled = build("mug", 0, attributes={"style": "low-poly"})
    assert checks.check_style("low-poly", styled, plain).passed
    wide = replace(styled, size=styled.size * 1.1)
    assert "size" in checks.check_style("low-poly", wide, plain).detail
