"""Facts about a category of objects, besides its shape."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from ...geometry import parts_to_unit_box, to_unit_box
from ...scene import Mesh, Model, Physics
from ...scene.triangles import areas
from ..holder import Holder
from ..matter import HOLLOW, friction, growth
from ..surfaces.look import SIZE_FACTORS, Look
from .painting import show_color
from .shape import Shape, mesh_of
from .solids import signed_volume
from .styles import apply_style

_VARIATION = 0.5, 2.0  # a variant's mass, in nominal ones
_WALL_DENSITY = 2000.0  # kg/m^3; only its product with the wall's thickness counts

SETS: Mapping[str, str] = MappingProxyType(
    {
        "coins": "pile of coins",
        "dominoes": "set of dominoes",
        "paper_clips": "pile of paper clips",
        "thumbtacks": "pile of thumbtacks",
    }
)
"""Categories of several things at once and their nouns; the plural alone means single things."""


@dataclass(frozen=True, eq=False)
class Category:
    """One kind of tabletop object.

    Attributes:
        key: its unique name, also its place in the seeds ("soup_can").
        shape: makes one variant, in metres, from a ``Look``.
        size: nominal extent (length x, depth y, height z) in metres in its everyday state.
        mass: mass in kilograms at the nominal size; variants and scaled ones weigh more or less
            as ``matter`` says.
        aliases: other words for it, singular.
        themes: scenes it belongs to.
        roles: "container" (things go into it), "support" (things go onto it), "flat", "tall",
            "round" (no front), "big" (too wide for a small gripper), "edible", "screen".
        colors: usual colours, for a plan that names none.
        friction: sliding friction coefficient; None takes that of its material.
        state: how it lies, for size priors.
        holder: what things it has a place each for, if it is a rack or the like.
    """

    key: str
    shape: Callable[[Look], Shape]
    size: tuple[float, float, float]
    mass: float
    aliases: tuple[str, ...] = ()
    themes: tuple[str, ...] = ()
    roles: tuple[str, ...] = ()
    colors: tuple[str, ...] = ()
    friction: float | None = None
    state: str = "standing upright"
    holder: Holder | None = None

    @property
    def noun(self) -> str:
        """The word for it in a sentence."""
        return SETS.get(self.key, self.key.replace("_", " "))

    @property
    def container(self) -> bool:
        """Whether things can be put into it."""
        return "container" in self.roles

    @property
    def ball(self) -> bool:
        """Whether it is about as wide as high and round, so that it rolls."""
        full = "round" in self.roles and not self.container
        return full and max(self.size) < 1.3 * min(self.size)

    @property
    def density(self) -> float:
        """Effective density of a likeness that fills two fifths of its box, kg/m^3."""
        return float(np.clip(self.mass / (0.4 * np.prod(self.size)), 20.0, 8000.0))


def model_of(
    category: Category,
    look: Look,
    size: tuple[float, float, float] | None = None,
) -> Model:
    """Shape one variant and normalise it; density makes it weigh what it should.

    ``size`` replaces the variant's own extent (and the attribute "size" with it). What is hollow is
    a shell: at another scale it weighs by its area, with walls as thick as before.
    """
    made = apply_style(category.shape(look), look.attributes.get("style", ""))
    if "edible" not in category.roles:
        made = show_color(made, look.attributes.get("color", ""))
    mesh = mesh_of(made)
    unit, center, extent = to_unit_box(mesh)
    words = look.attributes.get("size", "").lower().split()
    factor = next((SIZE_FACTORS[w] for w in words if w in SIZE_FACTORS), 1.0)
    return Model(
        name=category.key,
        label=category.noun,
        mesh=unit,
        size=extent * factor if size is None else np.array(size),
        physics=_physics(category, mesh, extent),
        parts=parts_to_unit_box(made.parts, center, extent),
        category=category.key,
        container=category.container,
        slots=tuple(replace(slot, at=(slot.at - center) / extent) for slot in made.slots),
    )


def _physics(category: Category, mesh: Mesh, extent: Float[np.ndarray, "3"]) -> Physics:
    """Return the material of a variant whose ``mesh`` is in metres and fills ``extent``."""
    share = float(np.prod(extent) / np.prod(category.size)) ** growth(category.key)
    mass = category.mass * float(np.clip(share, *_VARIATION))
    slide = friction(category.key) if category.friction is None else category.friction
    vertices = mesh.vertices.astype(float)
    if category.key in HOLLOW:
        area = float(areas(vertices, mesh.faces).sum()) / 2
        return Physics(_WALL_DENSITY, slide, mass / area / _WALL_DENSITY)
    volume = signed_volume(vertices, mesh.faces)
    return Physics(float(np.clip(mass / volume, 5, 29000)), slide)
