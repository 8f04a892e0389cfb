"""Where an environment's tables come from: one scene, many, or ever new ones.

A source draws *references*: a key, by which a compiled world is reused, and a function that loads
the scene when it is not there yet. Drawing uses the generator it is given and nothing else, so
that a seeded environment sees the same tables again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, runtime_checkable

import numpy as np

from generator.errors import InputError
from generator.scene import Scene

STARTER = "starter"
"""Means every bundle shipped with the package."""

FRESH = "fresh:"
"""What a prompt is preceded by to be composed anew at each draw."""


@dataclass(frozen=True, eq=False)
class SceneRef:
    """One scene that can be loaded. Equal ``key`` means the same scene."""

    key: str
    load: Callable[[], Scene]


@runtime_checkable
class SceneSource(Protocol):
    """Anything that can draw a scene."""

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene with ``rng``."""
        ...


@dataclass(frozen=True)
class FixedScenes:
    """Draws uniformly from a fixed tuple of scenes."""

    refs: tuple[SceneRef, ...]

    def __post_init__(self) -> None:
        if not self.refs:
            raise InputError("A scene source needs at least one scene; the list is empty.")

    def __len__(self) -> int:
        return len(self.refs)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw one of the scenes, all equally likely."""
        return self.refs[int(rng.integers(len(self.refs)))]


@dataclass(frozen=True)
class FreshScenes:
    """Composes a new table for every draw, from a prompt drawn uniformly from ``prompts``.

    ``variants`` bounds the seeds per prompt, so that at most ``len(prompts) * variants`` different
    scenes occur and compiled worlds are met again.
    """

    prompts: tuple[str, ...]
    variants: int = 1_000_000

    def __post_init__(self) -> None:
        if not self.prompts or not all(self.prompts) or self.variants < 1:
            raise InputError("FreshScenes needs at least one prompt, not empty, and one variant.")

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw a prompt and a seed; the scene is composed when it is loaded."""
        prompt = self.prompts[int(rng.integers(len(self.prompts)))]
        seed = int(rng.integers(self.variants))

        def load() -> Scene:
            from generator.compose import compose

            return compose(prompt, seed=seed)

        return SceneRef(f"fresh:{seed}:{prompt}", load)


SceneChoice = str | Path | Scene | SceneSource | Sequence["str | Path | Scene"]
"""What may be passed as ``scenes``."""


def resolve(scenes: SceneChoice) -> SceneSource:
    """Make a scene source of what a user may pass as ``scenes``.

    Args:
        scenes: "starter" (every bundle shipped with the package); a bundle's name, digest, path or
            a glob of these, as ``assets_cache.find`` takes; "fresh:PROMPT" (composed anew at each
            draw); a ``Scene``; a sequence of any of these; or a ``SceneSource``.

    Raises:
        BundleError: no bundle fits; the message says what there is.
        InputError: ``scenes`` is of another kind, or an empty list.
    """
    if isinstance(scenes, SceneSource):
        return scenes
    if isinstance(scenes, str) and scenes.startswith(FRESH):
        return FreshScenes((scenes.removeprefix(FRESH).strip(),))
    if isinstance(scenes, str | Path | Scene):
        return FixedScenes(tuple(_refs(scenes)))
    if isinstance(scenes, Iterable):
        return FixedScenes(tuple(ref for item in scenes for ref in _refs(item)))
    raise InputError(
        f"scenes is of type {type(scenes).__name__}; pass 'starter', a bundle's path, name or "
        "glob, 'fresh:PROMPT', a Scene, a list of these, or a SceneSource."
    )


def _refs(item: str | Path | Scene) -> list[SceneRef]:
    """Return the references that one item stands for, in a fixed order."""
    if isinstance(item, Scene):
        return [SceneRef(f"scene:{id(item)}", lambda: item)]
    if not isinstance(item, str | Path):
        raise InputError(f"A list of scenes holds a {type(item).__name__}: {item!r}.")
    if str(item).startswith(FRESH):
        raise InputError(
            f"A list of scenes holds {str(item)!r}; for several prompts pass "
            "scenes=FreshScenes((prompt, ...)) instead of a list."
        )
    import assets_cache

    return [_bundle(path) for path in assets_cache.find(item)]


def _bundle(path: Path) -> SceneRef:
    def load() -> Scene:
        from generator.bundle import load as load_bundle

        return load_bundle(path)

    return SceneRef(f"bundle:{path.resolve()}", load)
