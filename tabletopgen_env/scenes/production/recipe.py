"""Recipes of scenes generated on demand, and their generation."""

from __future__ import annotations

import dataclasses
import importlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from generator.errors import InputError, SceneError, choices
from generator.language.distribution import SceneDistribution
from generator.scene import Scene, ScenePlan

from ..splits import SplitRule, kinds_of, scene_kinds

COMPOSE, GENERATE = "compose", "generate"

ATTEMPTS = 3
"""Maximum number of seeds tried for a scene."""

MOST_SEEDS = 2**30
"""Exclusive upper bound of recipes' seeds; further attempts use seeds above it."""

Maker = Callable[[str | ScenePlan, int], Scene]
"""A function that generates a scene from a prompt or a plan, and from a seed."""


@dataclass(frozen=True)
class SceneRecipe:
    """All inputs of a scene generated on demand: equal recipes generate equal scenes.

    Attributes:
        what: a prompt, or the distribution from which the plan is drawn.
        seed: seed of the plan and of all later stages, in [0, 2^30).
        making: "compose" (text to plan to layout, about a second), "generate" (all stages of the
            paper, with the embedded backends) or "module:function" for your own function, which
            takes a prompt or a ``ScenePlan``, and a seed, and returns a ``Scene``.
        rules: rules that the scene must satisfy.
    """

    what: str | SceneDistribution
    seed: int
    making: str = COMPOSE
    rules: tuple[SplitRule, ...] = ()

    @property
    def identity(self) -> str:
        """A string that identifies the scene, the same in every process."""
        what = self.what if isinstance(self.what, str) else json.dumps(_facts(self.what))
        making = "fresh" if self.making == COMPOSE else f"fresh by {self.making}"
        return f"{making}:{self.seed}:{what}"

    @property
    def key(self) -> str:
        """The key of the scene's reference."""
        if self.making == COMPOSE:  # a planned scene is generated as planned, whatever the rules
            return self.identity
        return " ".join([self.identity, *(str(r) for r in self.rules if r.by == "category")])

    @property
    def planned(self) -> bool:
        """Whether ``plan`` lists the content of the scene."""
        return self.making in (COMPOSE, GENERATE) or not isinstance(self.what, str)

    def plan(self) -> ScenePlan:
        """Return the objects planned for the table, without generating it.

        Raises:
            InputError: the text cannot be planned.
        """
        if isinstance(self.what, str):
            from generator.composition import plan_scene

            return plan_scene(self.what, self.seed)
        return self.what.plan(np.random.default_rng(self.seed))

    def admitted(self) -> bool:
        """Return whether the rules admit the scene, as far as is known before it is generated."""
        return all(
            rule.admits(lambda: self.identity, self._kinds)
            for rule in self.rules
            if rule.by == "digest" or self.planned
        )

    def _kinds(self) -> frozenset[str]:
        return kinds_of((o.category, o.noun) for o in self.plan().objects)

    def make(self) -> Scene:
        """Generate the scene.

        Raises:
            InputError: the text cannot be planned, or ``making`` is unknown.
            SceneError: no attempt gave a valid scene that the rules admit.
        """
        make = maker(self.making)
        text = isinstance(self.what, str) and self.making != COMPOSE
        what = str(self.what) if text else self.plan()
        failures: list[str] = []
        for attempt in range(ATTEMPTS):
            try:
                return self._check(make(what, self.seed + attempt * MOST_SEEDS))
            except SceneError as error:
                failures.append(str(error))
        raise SceneError(
            f"{ATTEMPTS} attempts at a scene of {self.identity!r} failed: "
            + " ".join(dict.fromkeys(failures))
        )

    def _check(self, scene: Scene) -> Scene:
        """Return the generated scene if the rules admit it, since it may differ from the plan."""
        found = scene_kinds(scene)
        for rule in self.rules:
            if rule.by == "category" and not rule.admits(lambda: "", lambda: found):
                raise SceneError(f"Scene {scene.name!r} does not belong to {rule}.")
        return scene


def _facts(distribution: SceneDistribution) -> dict[str, Any]:
    """Return a distribution as JSON values; omit empty ``needs``, so that old keys stay valid."""
    facts = dataclasses.asdict(distribution)
    return {k: v for k, v in facts.items() if k != "needs" or v}


def maker(making: str) -> Maker:
    """Return the function that ``SceneRecipe.making`` names.

    Raises:
        InputError: the function does not exist.
    """
    if making == COMPOSE:
        from generator.composition import compose

        return compose
    if making == GENERATE:
        return _generate
    module, colon, name = making.partition(":")
    if not colon:
        raise InputError(
            f"Scenes cannot be generated by {making!r}."
            + choices(making, (COMPOSE, GENERATE, "module:function"))
        )
    try:
        return getattr(importlib.import_module(module), name)
    except (ImportError, AttributeError, ValueError) as error:
        raise InputError(
            f"Scenes cannot be generated by {making!r}: {error}. Pass an importable module and a "
            "function in it."
        ) from error


def _generate(what: str | ScenePlan, seed: int) -> Scene:
    """Generate a scene, and check that it passed the physical gate."""
    from generator.pipeline import generate

    scene = generate(what, seed=seed).scene
    if scene.report is None or not scene.report.passed:
        failures = scene.report.failure_text if scene.report else "the physical gate did not run"
        raise SceneError(f"A generated scene failed its physical gate: {failures}.")
    return scene
