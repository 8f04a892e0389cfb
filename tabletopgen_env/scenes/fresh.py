"""Scenes generated on demand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from generator.errors import InputError, SceneError
from generator.language.distribution import SceneDistribution

from .production.recipe import COMPOSE, GENERATE, MOST_SEEDS, SceneRecipe, maker
from .source import SceneRef
from .splits import SplitRule

DRAWS = 1000
"""Maximum number of draws to find one scene on the required side of a split."""


@dataclass(frozen=True)
class FreshScenes:
    """A source that generates a table for each draw, from one of its prompts or a random plan.

    Attributes:
        prompts: a prompt, a list of prompts, or a distribution of tables.
        variants: number of seeds per prompt or for the distribution, at most 2^30; with few seeds,
            compiled worlds can be reused.
        making: "compose", "generate" or "module:function"; see ``SceneRecipe``.
        rules: rules that all scenes must satisfy, such as one side of a split; see ``admitting``.

    Raises:
        InputError: there is no prompt, a prompt is empty, or a setting is out of range.
    """

    prompts: str | Sequence[str] | SceneDistribution = field(default_factory=SceneDistribution)
    variants: int = 1_000_000
    making: str = COMPOSE
    rules: tuple[SplitRule, ...] = ()

    def __post_init__(self) -> None:
        given = self.prompts
        if not isinstance(given, SceneDistribution):
            texts = (given,) if isinstance(given, str) else tuple(given)
            if not texts or not all(isinstance(t, str) and t.strip() for t in texts):
                raise InputError(
                    "FreshScenes requires one or more non-empty prompts, or a SceneDistribution, "
                    f"got {given!r}. Use, for example, FreshScenes('an office desk')."
                )
            object.__setattr__(self, "prompts", texts)
        if not 1 <= self.variants <= MOST_SEEDS:
            raise InputError(f"FreshScenes.variants must be from 1 to 2^30, got {self.variants}.")
        if self.making not in (COMPOSE, GENERATE):
            maker(self.making)
        object.__setattr__(self, "rules", tuple(self.rules))

    def check(self) -> None:
        """Plan each prompt once, to detect prompts from which no table can ever be generated.

        Raises:
            InputError: a text cannot be planned.
        """
        if not isinstance(self.prompts, SceneDistribution):
            for text in self.prompts:
                recipe = SceneRecipe(text, 0, self.making)
                if recipe.planned:
                    recipe.plan()

    def recipe(self, rng: np.random.Generator) -> SceneRecipe:
        """Draw the recipe of a scene; ``draw`` returns a reference to the scene."""
        for _ in range(DRAWS):
            what = self.prompts
            if not isinstance(what, SceneDistribution):
                what = what[int(rng.integers(len(what)))]
            seed = int(rng.integers(self.variants))
            recipe = SceneRecipe(what, seed, self.making, self.rules)
            if recipe.admitted():
                return recipe
        sides = " and ".join(str(rule) for rule in self.rules)
        raise SceneError(
            f"None of {DRAWS} drawn scenes belongs to {sides}. Choose another fraction (share), "
            f"other categories, other prompts, or more variants than {self.variants}."
        )

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw a reference to a scene, which is generated when it is loaded.

        Raises:
            InputError: a text cannot be planned.
            SceneError: none of ``DRAWS`` drawn scenes is on the required side of every split.
        """
        recipe = self.recipe(rng)
        return SceneRef(recipe.key, recipe.make)

    def admitting(self, rule: SplitRule) -> FreshScenes:
        """Return a source of the scenes that a rule admits.

        Raises:
            InputError: a category does not exist.
        """
        if self.making in (COMPOSE, GENERATE):
            rule.check_categories()
        return replace(self, rules=(*self.rules, rule))
