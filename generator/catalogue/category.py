"""What the catalogue knows about a kind of object, besides how to shape it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..geometry import parts_to_unit_box, to_unit_box
from ..scene import Model, Physics
from .look import SIZE_FACTORS, Look
from .shape import Shape, mesh_of
from .solids import signed_volume
from .styles import styled


@dataclass(frozen=True, eq=False)
class Category:
    """One kind of tabletop object.

    Attributes:
        key: its unique name, also its place in the seeds ("soup_can").
        shape: makes one variant, in metres, from a ``Look``.
        size: nominal extent (length x, depth y, height z) in metres in its everyday state.
        mass: nominal mass in kilograms at the variant's own size.
        aliases: other words for it, singular.
        themes: scenes it belongs to.
        roles: "container" (things go into it), "support" (things go onto it), "flat", "tall",
            "round" (no front), "big" (too wide for a small gripper), "edible", "screen".
        colors: usual colours, for a plan that names none.
        friction: sliding friction coefficient.
        state: how it lies, for size priors.
    """

    key: str
    shape: Callable[[Look], Shape]
    size: tuple[float, float, float]
    mass: float
    aliases: tuple[str, ...] = ()
    themes: tuple[str, ...] = ()
    roles: tuple[str, ...] = ()
    colors: tuple[str, ...] = ()
    friction: float = 0.6
    state: str = "standing upright"

    @property
    def noun(self) -> str:
        """The word for it in a sentence."""
        return self.key.replace("_", " ")

    @property
    def container(self) -> bool:
        """Whether things can be put into it."""
        return "container" in self.roles

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

    ``size`` replaces the variant's own extent (and the attribute "size" with it).
    """
    made = styled(category.shape(look), look.attributes.get("style", ""))
    mesh = mesh_of(made)
    volume = signed_volume(mesh.vertices.astype(float), mesh.faces)
    unit, center, extent = to_unit_box(mesh)
    words = look.attributes.get("size", "").lower().split()
    factor = next((SIZE_FACTORS[w] for w in words if w in SIZE_FACTORS), 1.0)
    return Model(
        name=category.key,
        label=category.noun,
        mesh=unit,
        size=extent * factor if size is None else np.array(size),
        physics=Physics(float(np.clip(category.mass / volume, 5, 29000)), category.friction),
        parts=parts_to_unit_box(made.parts, center, extent),
        category=category.key,
        container=category.container,
    )
