"""Fixed scenes by what users call them: names, digests, paths, globs, "starter" and its sides."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import get_args

from generator.errors import BundleError, InputError, choices
from generator.scene import Scene

from .fixed import FixedScenes, bundle_ref
from .source import HeldRef, SceneRef
from .splits import Side, SplitRule

STARTER = "starter"
"""Means the shipped bundles that are for any task."""

FRESH = "fresh"
"""Means scenes made again for each draw; after a colon comes what they are of."""

REFRESHING = "refreshing"
"""Means a pool that is renewed in the background; after a colon comes what it is of."""

CURRICULUM = "curriculum"
"""Means scenes of the difficulty at which most is learned now; after a colon comes of which."""

_SIDES: dict[str, Side] = {f"{STARTER}:{side}": side for side in get_args(Side)}
FORMS = (
    STARTER, *_SIDES, FRESH, f"{FRESH}:PROMPT", REFRESHING, f"{REFRESHING}:PROMPT",
    CURRICULUM, f"{CURRICULUM}:SCENES",
)  # fmt: skip
"""What ``scenes`` may say besides bundles."""

FixedChoice = str | Path | Scene | Sequence["str | Path | Scene"]
"""What fixed scenes may be called."""


def fixed_scenes(scenes: FixedChoice) -> FixedScenes:
    """Find fixed scenes, in a fixed order; ``selection.resolve`` says what they may be called.

    Raises:
        BundleError: no bundle fits; the message says what there is.
        InputError: ``scenes`` is of another kind, or an empty list.
    """
    if isinstance(scenes, str | Path | Scene):
        return FixedScenes(tuple(_find(scenes)))
    if isinstance(scenes, Iterable):
        return FixedScenes(tuple(ref for item in scenes for ref in _find(item)))
    raise InputError(
        f"scenes is of type {type(scenes).__name__}; pass a bundle's path, name or glob, "
        f"{', '.join(map(repr, FORMS))}, a Scene, a list of these, or a SceneSource."
    )


def on_demand(scenes: object) -> bool:
    """Return whether tables are made: ``scenes`` is a form of ``FRESH`` or ``REFRESHING``.

    Or a curriculum of one, as ``CURRICULUM`` alone is.
    """
    if not isinstance(scenes, str):
        return False
    return (graded_of(scenes) or scenes).partition(":")[0] in (FRESH, REFRESHING)


def graded_of(scenes: str) -> str | None:
    """Return of which scenes a form of ``CURRICULUM`` is one, None for what is none.

    Raises:
        InputError: nothing follows the colon, or another curriculum.
    """
    head, colon, inner = scenes.partition(":")
    if head != CURRICULUM:
        return None
    if not colon:
        return FRESH
    if not inner.strip() or inner.strip().partition(":")[0] == CURRICULUM:
        raise InputError(
            f"scenes={scenes!r} does not say of which scenes it is a curriculum. Pass for example "
            f"'{CURRICULUM}:{STARTER}:train', '{CURRICULUM}:{FRESH}:an office desk', or just "
            f"{CURRICULUM!r}."
        )
    return inner.strip()


def _find(item: str | Path | Scene) -> list[SceneRef]:
    """Return the references that one item stands for, in a fixed order."""
    if isinstance(item, Scene):
        return [HeldRef(item)]
    if not isinstance(item, str | Path):
        raise InputError(f"A list of scenes holds a {type(item).__name__}: {item!r}.")
    if on_demand(item) or (isinstance(item, str) and graded_of(item)):
        raise InputError(
            f"{item!r} is no fixed scene, and cannot be one of a list; for several prompts pass "
            "scenes=FreshScenes([prompt, ...])."
        )
    if item in _SIDES:
        return list(fixed_scenes(STARTER).admitting(SplitRule(_SIDES[str(item)])).refs)
    import assets_cache

    try:
        return [bundle_ref(path) for path in assets_cache.find(item)]
    except BundleError as error:
        raise _explain(str(item), error) from error


def _explain(text: str, error: BundleError) -> BundleError | InputError:
    """Return the error for a text that names no bundle: perhaps it was to be one of the forms."""
    head, colon, _ = text.partition(":")
    if colon and head.isidentifier() and len(head) > 1:
        meant = text if head == STARTER else f"{head}:PROMPT"
        return InputError(f"scenes cannot be {text!r}." + choices(meant, FORMS))
    from rapidfuzz import fuzz, process

    if near := process.extractOne(text, FORMS, scorer=fuzz.ratio, score_cutoff=75):
        return BundleError(f"{error} Or did you mean scenes={near[0]!r}?")
    return BundleError(f"{error} Besides bundles, scenes can be {', '.join(map(repr, FORMS))}.")
