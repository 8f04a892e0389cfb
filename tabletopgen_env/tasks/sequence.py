"""Sequence: several steps at one table, in the order in which an instruction states them.

Without a preset, two or three steps are drawn: objects are placed into containers, on flat tops of
others or on marked spots, each object once. A preset has fixed steps:

================  ==============================================================================
``kitchen``       the cucumber into the bowl, then the carrot and the salt shaker onto the cutting
                  board
``coffee_table``  the cup and the apple change places
================  ==============================================================================

Both are from the paper (Sec. 11); their tables are the shipped bundles in ``PRESETS``. The task
succeeds if all steps hold at once, regardless of their order. ``reset`` has only the option
"scene". Goals: `Into`, `OnTop`, `OnSpot`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

import numpy as np

from generator.errors import InputError, SceneError, require_known
from generator.language.distribution import Needs
from generator.scene import Object

from ..expert.planning.choice import has_grasp
from ..goals.goal import SPOT, Goal
from ..goals.needs import FLAT, SMALL, TRAYS
from ..world.world import World
from .candidates import (
    NO_GRASP,
    blocking_reason,
    containers,
    into,
    liftable,
    nothing,
    on_spot,
    spot_of,
)
from .names import TaskName
from .stack import on_top, supports
from .swap import Swap
from .task import Choice, Episode, Task, episode

NEEDS: Needs = (SMALL, SMALL, (*FLAT, *TRAYS))
"""Objects that a table must contain if the steps are drawn: two to move, and a destination."""

_APART = 0.2  # minimum distance of two marked spots, metres


@dataclass(frozen=True)
class Step:
    """One step of a preset: the labels of the object and of its destination."""

    target: str
    relation: Literal["into", "onto"]
    place: str


@dataclass(frozen=True)
class Preset:
    """A task preset: a sentence, its steps, a glob of bundles, and requirements on new tables."""

    instruction: str
    scenes: str
    needs: Needs
    steps: tuple[Step, ...] = ()
    swap: tuple[str, str] | None = None


PRESETS: Mapping[str, Preset] = MappingProxyType(
    {
        "kitchen": Preset(
            "put the cucumber into the bowl, then the carrot and the salt shaker onto the cutting "
            "board",
            "kitchen-task-*",
            (
                ("large bowl",),
                ("large cutting board",),
                ("small cucumber",),
                ("carrot",),
                ("salt shaker",),
            ),
            (
                Step("cucumber", "into", "bowl"),
                Step("carrot", "onto", "cutting board"),
                Step("salt shaker", "onto", "cutting board"),
            ),
        ),
        "coffee_table": Preset(
            "swap the cup and the apple",
            "coffee-table-task-*",
            (("cup",), ("small apple",)),
            swap=("cup", "apple"),
        ),
    }
)
"""The presets by name."""


class Sequence(Task):
    """Perform several steps in order; see the module docstring.

    Args:
        preset: a key of ``PRESETS``; None draws steps.

    Raises:
        InputError: the preset is unknown.
    """

    weights = Swap.weights
    most = 3

    def __init__(self, preset: str | None = None) -> None:
        if preset is not None:
            require_known(preset, PRESETS, "Sequence has no preset")
        self._name = preset
        self.preset = None if preset is None else PRESETS[preset]
        self.scenes = Task.scenes if self.preset is None else self.preset.scenes
        self.needs = NEEDS if self.preset is None else self.preset.needs
        self.aside = Swap.aside if self.preset and self.preset.swap else Task.aside

    @property
    def listed_as(self) -> TaskName | None:
        """The name in certificates, which includes the preset."""
        listed = super().listed_as
        return listed and listed._replace(preset=self._name)

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw steps, or find the objects of the preset; see ``Task.sample``."""
        if target is not None or goal is not None:
            raise InputError(
                "Sequence draws its steps or takes them from a preset; omit 'target' and 'goal'."
            )
        if self.preset is None:
            return _draw(world, rng, int(rng.integers(2, self.most + 1)))
        if self.preset.swap:
            first, second = (_movable(world, label, broad=True) for label in self.preset.swap)
            return Swap().sample(world, rng, first.name, second.name)
        for step in self.preset.steps:
            _movable(world, step.target)
        return episode(world, tuple(_goal(world, step) for step in self.preset.steps))

    def instruction(self, world: World, goals: tuple[Goal, ...]) -> str:
        """Return the sentence of the preset, or the instructions for the drawn ``goals``."""
        if self.preset is None:
            return super().instruction(world, goals)
        return Swap().instruction(world, goals) if self.preset.swap else self.preset.instruction


def _resolve_label(world: World, label: str) -> Object:
    """Return the object whose label or category matches a label of the preset."""
    category = label.replace(" ", "_")
    for obj in world.scene.objects:
        if label == obj.label or category == obj.model.category:
            return obj
    there = ", ".join(sorted({o.label for o in world.scene.objects}))
    raise SceneError(
        f"Scene {world.scene.name!r} has no {label}, which this task requires; it has {there}."
    )


def _movable(world: World, label: str, broad: bool = False) -> Object:
    """Return the object with a label, which must be movable; ``broad`` skips the width check."""
    obj = _resolve_label(world, label)
    reason = blocking_reason(world, obj) if broad else liftable(world)[obj.name]
    if reason is None and not has_grasp(world, obj.name):
        reason = NO_GRASP
    if reason is not None:
        raise nothing(world, {obj.name: reason})
    return obj


def _goal(world: World, step: Step) -> Goal:
    obj, place = _resolve_label(world, step.target), _resolve_label(world, step.place)
    return into(world, obj, place) if step.relation == "into" else on_top(world, obj, place)


def _draw(world: World, rng: np.random.Generator, count: int) -> Episode:
    """Draw ``count`` steps with distinct objects that stay clear of each other."""
    reasons = liftable(world)
    names = [name for name, why in reasons.items() if why is None]
    goals: list[Goal] = []
    busy: set[str] = set()
    for k in map(int, rng.permutation(len(names))):
        obj = world.scene.object(names[k])
        if obj.name in busy or not has_grasp(world, obj.name):
            reasons[obj.name] = NO_GRASP
            continue
        goal = _step(world, obj, rng, busy, goals)
        if goal is None:
            reasons[obj.name] = "no destination for it"
            continue
        goals.append(goal)
        busy |= {obj.name} | ({goal.reference} if goal.reference else set())
        if len(goals) == count:
            break
    if len(goals) >= 2:
        return episode(world, tuple(goals))
    for goal in goals:
        reasons[str(goal.target)] = "no other object can be moved"
    raise nothing(world, reasons)


def _step(
    world: World, obj: Object, rng: np.random.Generator, busy: set[str], before: list[Goal]
) -> Goal | None:
    """Return a goal for ``obj`` that avoids ``busy`` objects and spots in ``before``, or None."""
    hollow = [c for c in containers(world, obj) if c.name not in busy]
    flat = [s for s in supports(world, obj) if s.name not in busy]
    ways: list[Goal] = []
    if hollow:
        ways.append(into(world, obj, hollow[int(rng.integers(len(hollow)))]))
    if flat:
        ways.append(on_top(world, obj, flat[int(rng.integers(len(flat)))]))
    spot = None if ways else spot_of(world, obj, SPOT, rng)
    if spot is not None and all(
        g.spot is None or np.linalg.norm(g.spot - spot) >= _APART for g in before
    ):
        ways.append(on_spot(world, obj, spot))
    return ways[int(rng.integers(len(ways)))] if ways else None
