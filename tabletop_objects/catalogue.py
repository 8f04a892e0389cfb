"""Functions that look up, build and locate the object categories listed in the index."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib import import_module
from pathlib import Path
from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from .errors import InputError, suggestion
from .kit.shapes import Category, Shape, mesh_of
from .kit.solids import signed_volume
from .kit.surfaces import Look, size_factor
from .values import Extent, Holder, Mesh, Model, Physics, parts_to_unit_box, to_unit_box

_VARIATION = 0.5, 2.0  # mass of a variant relative to the nominal mass
_WALL_DENSITY = 2000.0  # kg/m^3; only its product with the wall thickness matters

INDEX = Path(__file__).with_name("index.json")
OBJECTS = f"{__package__}.objects"


@cache
def load_index() -> Mapping[str, Category]:
    """Return all categories by key, ordered by rank; their drawing functions are loaded lazily."""
    return MappingProxyType(
        {key: _read_row(key, dict(row)) for key, row in json.loads(INDEX.read_bytes()).items()}
    )


def _read_row(key: str, row: dict[str, object]) -> Category:
    module = f"{OBJECTS}.{row.pop('module')}"
    if holder := row.pop("holder", None):
        row["holder"] = Holder(holder[0], tuple(holder[1]))  # type: ignore[index]
    facts = {name: tuple(v) if isinstance(v, list) else v for name, v in row.items()}
    return Category(key, _Deferred(module, key), **facts)  # type: ignore[arg-type]


class _Deferred:
    """A drawing function that imports its module on the first call."""

    def __init__(self, module: str, key: str) -> None:
        self.module, self.key = module, key

    def __call__(self, look: Look) -> Shape:
        return self.load().shape(look)

    def load(self) -> Category:
        """Return the category declared in the module."""
        return read_module(self.module)[self.key]


def read_module(module: str) -> Mapping[str, Category]:
    """Return a module's categories: first its decorated functions, then its ``CATEGORIES``."""
    content = vars(import_module(module))
    drawn = [c for c in content.values() if isinstance(c, Category)]
    own = [c for c in drawn if c.shape.__module__ == module]  # skip imported categories
    return {c.key: c for c in (*own, *content.get("CATEGORIES", ()))}


def find_category(word: str) -> Category | None:
    """Return the category with this key, noun or alias (singular, in any case), or None."""
    key = _names().get(word.lower().replace("_", " ").strip())
    return None if key is None else load_index()[key]


def get_category(word: str) -> Category:
    """Return the category with this key, noun or alias (singular, in any case).

    Raises:
        InputError: no category has that name.
    """
    category = find_category(word)
    if category is None:
        near = suggestion(word.replace(" ", "_"), load_index().keys())
        raise InputError(
            f"There is no object {word!r}.{near} tabletop_objects.search lists objects by name."
        )
    return category


def categories(theme: str | None = None, role: str | None = None) -> tuple[Category, ...]:
    """Return the categories of a theme ("kitchen") and a role ("container"), ordered by rank."""
    return tuple(
        c
        for c in load_index().values()
        if (theme is None or theme in c.themes) and (role is None or role in c.roles)
    )


def search(text: str, limit: int = 10) -> tuple[Category, ...]:
    """Return the categories whose names match ``text``, sorted from best to worst match.

    Exact matches come first, then names that contain all words of the text, then names with a
    similar spelling.
    """
    from rapidfuzz import fuzz, process

    word = text.lower().replace("_", " ").strip()
    names = _names()
    scores: dict[str, float] = {}
    for name, score, _ in process.extract(word, names.keys(), scorer=fuzz.WRatio, limit=6 * limit):
        whole = 200.0 if name == word else 50.0 if set(word.split()) <= set(name.split()) else 0.0
        key = names[name]
        scores[key] = max(scores.get(key, 0.0), score + whole)
    best = sorted((key for key in scores if scores[key] >= 70.0), key=lambda key: -scores[key])
    return tuple(load_index()[key] for key in best[:limit])


@cache
def _names() -> Mapping[str, str]:
    """Map names to keys; keys take precedence over aliases, and low ranks over high ranks."""
    known = load_index().values()
    names = {alias: c.key for c in reversed(tuple(known)) for alias in c.aliases}
    names |= {name: c.key for c in known for name in (c.key.replace("_", " "), c.noun)}
    return MappingProxyType(names)


def build(
    key: str,
    seed: int,
    *,
    attributes: Mapping[str, str] = MappingProxyType({}),
    size: Extent | None = None,
) -> Model:
    """Build one variant of a category as a canonical model.

    Args:
        key: a category's key, noun or alias.
        seed: selects proportions, colours and prints; the same seed gives the same bytes.
        attributes: "color", "material" and "size" words that override the seed's choices, and
            "style": "cartoon" or "low-poly" instead of the plain style.
        size: the extent in metres; by default it depends on the seed.

    Raises:
        InputError: no category has that name, or the style is unknown.
    """
    category = load_category(get_category(key))
    return model_of(category, look_of(category, seed, attributes), size)


def look_of(
    category: Category, seed: int, attributes: Mapping[str, str] = MappingProxyType({})
) -> Look:
    """Return the ``Look`` that makes a variant's random choices; ``attributes`` override them."""
    digest = hashlib.sha256(category.key.encode()).digest()
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, int.from_bytes(digest[:4], "big")])
    return Look(rng, attributes)


def load_category(category: Category) -> Category:
    """Return the category with its drawing function loaded."""
    return category.shape.load() if isinstance(category.shape, _Deferred) else category


def find_declaration(key: str) -> Category | None:
    """Return the category declared with a key, even if it is not indexed, or None if there is none.

    Only the module that contains the declaration is imported.
    """
    found = _search_sources(key)
    if found is None:
        return None
    parts = found[0].relative_to(Path(__file__).parent).with_suffix("").parts
    return read_module(".".join((str(__package__), *parts))).get(key)


def find_source(category: Category) -> tuple[Path, int]:
    """Return the file that declares a category and the line number of the declaration, from 1."""
    if isinstance(draw := category.shape, _Deferred):
        path = Path(__file__).parent.joinpath(*draw.module.split(".")[1:]).with_suffix(".py")
        line = _find_line(path, category.key)
        found = (path, line) if line else None
    else:
        found = _search_sources(category.key)
    if found is None:
        raise InputError(f"No module declares {category.key}; rebuild the index.")
    return found


def _search_sources(key: str) -> tuple[Path, int] | None:
    for path in sorted(Path(__file__).with_name("objects").rglob("*.py")):
        if line := _find_line(path, key):
            return path, line
    return None


def _find_line(path: Path, key: str) -> int:
    """Return the number of the line that declares a category in a file, or 0 if none does."""
    text = path.read_text(encoding="utf-8")
    declared = re.search(rf'[cC]ategory\(\s*"{re.escape(key)}",', text)
    return 0 if declared is None else text.count("\n", 0, declared.start()) + 1


def model_of(category: Category, look: Look, size: Extent | None = None) -> Model:
    """Draw one variant in its canonical frame, with a density that yields the expected mass.

    ``size`` overrides the variant's extent and the attribute "size". Hollow objects are shells of
    constant wall thickness, so their mass grows with their surface area when they are scaled.
    """
    made = category.shape(look)
    if style := look.attributes.get("style", ""):
        from .kit.styles import apply_style

        made = apply_style(made, style)
    if "edible" not in category.roles and (color := look.attributes.get("color", "")):
        from .kit.styles import show_color

        made = show_color(made, color)
    mesh = mesh_of(made)
    unit, center, extent = to_unit_box(mesh)
    full = extent * size_factor(look.attributes) if size is None else np.array(size)
    slots = tuple(replace(slot, at=(slot.at - center) / extent) for slot in made.slots)
    return Model(
        name=category.key, label=category.noun, mesh=unit, size=full,
        physics=_physics(category, mesh, extent),
        parts=parts_to_unit_box(made.parts, center, extent), category=category.key,
        container=category.container, slots=slots,
    )  # fmt: skip


def _physics(category: Category, mesh: Mesh, extent: Float[np.ndarray, "3"]) -> Physics:
    """Return the physics of a variant; ``mesh`` is in metres and has the given extent."""
    share = float(np.prod(extent) / np.prod(category.size)) ** category.growth
    mass = category.mass * float(np.clip(share, *_VARIATION))
    if category.hollow:
        shell = mass / mesh.area / _WALL_DENSITY
        return Physics(_WALL_DENSITY, category.sliding_friction, shell)
    volume = signed_volume(mesh.vertices.astype(float), mesh.faces)
    return Physics(float(np.clip(mass / volume, 5, 29000)), category.sliding_friction)
