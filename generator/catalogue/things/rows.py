"""Rows of a table of categories that share their theme, state and usual colours."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..build.category import Category
from ..build.making import Bodies, Drawing, of
from ..build.shape import Shape
from ..surfaces.look import Look

Size = tuple[float, float, float]


def wide(size: Size) -> tuple[str, ...]:
    """Return the role of a thing too wide for a small gripper."""
    return ("big",) if max(size[:2]) > 0.18 else ()


def tall(size: Size) -> tuple[str, ...]:
    """Return the role of a thing that is high and slender."""
    return ("tall",) if size[2] > 0.17 and size[2] > 1.2 * max(size[:2]) else ()


@dataclass(frozen=True)
class Rows:
    """Makes the categories of one table.

    Attributes:
        theme: the scenes they belong to.
        colors: the usual colours of those that name none of their own.
        state: how they lie.
        spread: by how much drawn ones are larger and smaller.
        roles: the roles of all of them.
        role: further roles that a nominal size implies.
    """

    theme: str
    colors: tuple[str, ...]
    state: str = "standing upright"
    spread: float = 0.1
    roles: tuple[str, ...] = ()
    role: Callable[[Size], tuple[str, ...]] | None = None

    def of_shape(
        self,
        key: str,
        shape: Callable[[Look], Shape],
        size: Size,
        mass: float,
        aliases: tuple[str, ...],
        colors: tuple[str, ...] = (),
        roles: tuple[str, ...] = (),
    ) -> Category:
        """Return a category of the things that ``shape`` makes; the rest is as in ``Category``."""
        implied = self.role(size) if self.role else ()
        return Category(
            key, shape, size, mass, aliases, (self.theme,), (*self.roles, *roles, *implied),
            colors or self.colors, state=self.state,
        )  # fmt: skip

    def of_drawing(
        self,
        key: str,
        draw: Drawing,
        size: Size,
        mass: float,
        aliases: tuple[str, ...],
        colors: tuple[str, ...] = (),
        foot: float = 0.0,
        bodies: Bodies = None,
        roles: tuple[str, ...] = (),
    ) -> Category:
        """Return a category of the pieces that ``draw`` draws.

        ``foot`` and ``bodies`` are as in ``of``, the rest is as in ``Category``.
        """
        made = of(draw, foot, bodies=bodies, spread=self.spread)
        return self.of_shape(key, made, size, mass, aliases, colors, roles)
