"""The stock of scenes: a seeded choice of models, tables and textures, compiled once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float, Int

from generator.geometry import convex_outline
from generator.scene import Mesh, Model, PlannedTable
from generator.tables import LEGS, OUTLINES, build_table
from tabletop_objects import CATEGORIES, build
from tabletop_objects.kit.solids import box
from tabletop_objects.kit.styles import STYLES
from tabletop_objects.kit.surfaces import COLORS, METALS, WOODS

from ..sample import UNKNOWN, UNNAMED
from ..vocabulary import VOCABULARY
from . import patterns
from .pool import Stock, stock
from .strangers import stranger

Split = Literal["train", "eval", "hard"]
SEEDS: dict[str, tuple[int, int]] = {
    "train": (0, 1_000),
    "eval": (10_000, 20_000),
    "hard": (20_000, 30_000),
}
"""Catalogue seeds of each split, which are disjoint between training and evaluation.

In "eval" all objects are of named categories and have the catalogue's looks; in the others a
quarter are of other categories, a sixth of none, many have unusual colours and textures, and some
scenes are entirely white or dark."""

KEYS = VOCABULARY
"""Category keys; a sample's ``category`` is an index into them."""

_OTHERS = tuple(sorted(set(CATEGORIES) - set(KEYS)))

_TABLE_MESHES = 3

REPEATS = (1, 3, 9)
"""Texture repetitions of the unit boxes."""


@dataclass(frozen=True, eq=False)
class Supply:
    """Models and tables with the indices of their meshes in the stock.

    The first meshes are unit boxes, one for each of ``REPEATS``, followed by the tables with three
    meshes each (the part below the top, the top, and the top with a flat texture), and the models.
    ``surfaces``, ``cloths`` and ``prints`` are texture indices. With ``borrows``, objects may have
    other colours and textures than their own.
    """

    stock: Stock
    tables: tuple[Model, ...]
    outlines: tuple[Float[np.ndarray, "k 2"], ...]
    models: tuple[Model, ...]
    categories: tuple[int, ...]
    surfaces: tuple[int, ...]
    cloths: tuple[int, ...]
    prints: tuple[int, ...]
    borrows: bool = True

    def table_mesh(self, index: int) -> int:
        """Return the index of a table's first mesh."""
        return len(REPEATS) + _TABLE_MESHES * index

    def model_mesh(self, index: int) -> int:
        """Return the mesh index of a model."""
        return len(REPEATS) + _TABLE_MESHES * len(self.tables) + index


def supply(seed: int, split: Split, models: int = 170, tables: int = 16) -> Supply:
    """Build a supply: tables, and ``models`` of named, other and (not in "eval") no categories."""
    rng = np.random.default_rng([seed, 11, SEEDS[split][0]])
    low, high = SEEDS[split]
    strangers, others = (0, 0) if split == "eval" else (models // 6, models // 4)
    order = np.concatenate([rng.permutation(len(KEYS)) for _ in range(1 + models // len(KEYS))])
    chosen = [int(k) for k in order[: models - strangers - others]]
    unnamed = rng.choice(len(_OTHERS), others, replace=False).tolist()
    made = [_build(rng, KEYS[k], low, high) for k in chosen]
    made += [_build(rng, _OTHERS[k], low, high) for k in unnamed]
    made += [stranger(int(rng.integers(low, high)) + 7919 * seed) for _ in range(strangers)]
    categories = chosen + [UNNAMED] * others + [UNKNOWN] * strangers
    stands = [_table(rng, low, high) for _ in range(tables)]
    loose = [patterns.surface(rng) for _ in range(14)]
    loose += [patterns.cloth(rng) for _ in range(8)]
    loose += [patterns.clutter(rng, 128, 30) for _ in range(6)]
    boxes = [_unit_box(repeat) for repeat in REPEATS]
    kept = stock(
        [*boxes, *(part for t in stands for part in _halves(t)), *(m.mesh for m in made)], loose
    )
    numbers = [kept.texture(k) for k in range(len(loose))]
    return Supply(
        kept,
        tuple(stands),
        tuple(_outline(t) for t in stands),
        tuple(made),
        tuple(categories),
        tuple(numbers[:14]),
        tuple(numbers[14:22]),
        tuple(numbers[22:]),
        split != "eval",
    )


def _build(rng: np.random.Generator, key: str, low: int, high: int) -> Model:
    """Return a variant of a category, sometimes in one of the catalogue's styles."""
    style = _pick(rng, sorted(STYLES)) if rng.random() < 0.15 else ""
    return build(key, int(rng.integers(low, high)), attributes={"style": style})


def _unit_box(repeat: int) -> Mesh:
    solid = box(1, 1, 1).move(z=-0.5)
    white = np.full((8, 8, 3), 255, np.uint8)
    return Mesh(solid.vertices, solid.faces, solid.uv * repeat, white)


def _outline(table: Model) -> Float[np.ndarray, "k 2"]:
    """Return the top's convex outline in the unit box, from the mesh itself."""
    vertices = table.mesh.vertices
    return convex_outline(vertices[vertices[:, 2] > 0.4999, :2])


def _halves(table: Model) -> tuple[Mesh, Mesh, Mesh]:
    """Return the part below the top, the top, and the top with a flat texture on its upper side."""
    mesh = table.mesh
    slab = 0.5 - 0.036 / float(table.size[2])
    upper = (mesh.vertices[mesh.faces, 2] > slab).all(1)
    flat = mesh.vertices[:, :2] + 0.5

    def part(faces: Int[np.ndarray, "m 3"], uv: Float[np.ndarray, "n 2"]) -> Mesh:
        used, index = np.unique(faces, return_inverse=True)
        return Mesh(mesh.vertices[used], index.reshape(-1, 3), uv[used], mesh.texture)

    top = mesh.faces[upper]
    return part(mesh.faces[~upper], mesh.uv), part(top, mesh.uv), part(top, flat)


def _pick(rng: np.random.Generator, options: Sequence[str]) -> str:
    return str(options[int(rng.integers(len(options)))])


def _table(rng: np.random.Generator, low: int, high: int) -> Model:
    """Return a random table: white, wooden, stone, metal or coloured."""
    outline = _pick(rng, (*OUTLINES, "rectangle", "rectangle", "rectangle"))
    length = float(rng.uniform(0.6, 1.6))
    depth = length * float(rng.uniform(0.45, 0.8))
    if outline in ("square", "round"):
        length = depth = float(rng.uniform(0.55, 1.1))
    kind = rng.random()
    material, color = "oak", None
    if kind < 0.3:
        material = "white"
    elif kind < 0.65:
        material = _pick(rng, sorted(WOODS))
    elif kind < 0.75:
        material = _pick(rng, ("marble", "glass", *sorted(METALS)))
    else:
        material = _pick(rng, sorted(COLORS))
        color = material
    height = float(rng.uniform(0.3, 0.85))
    plan = PlannedTable(
        outline,  # type: ignore[arg-type]
        material,
        _pick(rng, sorted(LEGS)),
        (length, depth, height),
        color,
    )
    return build_table(plan, int(rng.integers(low, high)))
