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
FRESH = "fresh:"


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
        if not self.prompts or self.variants < 1:
            raise InputError("FreshScenes needs at least one prompt and one variant.")

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw a prompt and a seed; the scene is composed when it is loaded."""
        prompt = self.prompts[int(rng.integers(len(self.prompts)))]
        seed = int(rng.integers(self.variants))

        def load() -> Scene:
            from generator.compose import compose

            return compose(prompt, seed=seed)

        return SceneRef(f"fresh:{seed}:{prompt}", load)


SceneChoice = str | Path | Scene | SceneSource | Sequence["str | Path | Scene"]


def resolve(scenes: SceneChoice) -> SceneSource:
    """Make a scene source of what a user may pass as ``scenes``.

    Args:
        scenes: "starter" (every bundle shipped with the package), the name or path of a bundle, a
            glob of bundle folders, "fresh:PROMPT" (composed anew at each draw), a ``Scene``, a
            sequence of any of these, or a ``SceneSource``.

    Raises:
        BundleError: nothing of that name exists.
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
        f"scenes is a {type(scenes).__name__}; pass 'starter', a bundle's path, name or glob, "
        "'fresh:PROMPT', a Scene, a list of these, or a SceneSource."
    )


def _refs(item: str | Path | Scene) -> list[SceneRef]:
    """Return the references that one item stands for, in a fixed order."""
    if isinstance(item, Scene):
        return [SceneRef(f"scene:{id(item)}", lambda: item)]
    if not isinstance(item, str | Path):
        raise InputError(f"A list of scenes holds a {type(item).__name__}: {item!r}.")
    return [_bundle(path) for path in find_bundles(item)]


def _bundle(path: Path) -> SceneRef:
    def load() -> Scene:
        from generator.bundle import load_scene

        return load_scene(path)

    return SceneRef(f"bundle:{path.resolve()}", load)


def find_bundles(wanted: str | Path) -> list[Path]:
    """Return the bundle folders of "starter", a path, a glob, or a name in the store."""
    raise NotImplementedError
