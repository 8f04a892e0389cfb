"""Lookup of fixed scenes by name, digest, path or glob, or by "starter" and its two splits."""

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
"""Name of the shipped bundles that suit any task."""

FRESH = "fresh"
"""Name for scenes generated for each draw; a prompt can follow after a colon."""

REFRESHING = "refreshing"
"""Name for a pool renewed in the background; a prompt can follow after a colon."""

CURRICULUM = "curriculum"
"""Name for a curriculum of scenes; the scenes can follow after a colon."""

_SIDES: dict[str, Side] = {f"{STARTER}:{side}": side for side in get_args(Side)}
FORMS = (
    STARTER, *_SIDES, FRESH, f"{FRESH}:PROMPT", REFRESHING, f"{REFRESHING}:PROMPT",
    CURRICULUM, f"{CURRICULUM}:SCENES",
)  # fmt: skip
"""Values of ``scenes`` that do not name bundles."""

FixedChoice = str | Path | Scene | Sequence["str | Path | Scene"]
"""Identifiers of fixed scenes."""


def fixed_scenes(scenes: FixedChoice) -> FixedScenes:
    """Find fixed scenes by the identifiers that ``selection.resolve`` lists; their order is fixed.

    Raises:
        BundleError: no bundle matches; the message lists the available ones.
        InputError: ``scenes`` has an unsupported type, or is an empty list.
    """
    if isinstance(scenes, str | Path | Scene):
        return FixedScenes(tuple(_find(scenes)))
    if isinstance(scenes, Iterable):
        return FixedScenes(tuple(ref for item in scenes for ref in _find(item)))
    raise InputError(
        f"scenes has type {type(scenes).__name__}; pass a bundle's path, name or glob, "
        f"{', '.join(map(repr, FORMS))}, a Scene, a list of these, or a SceneSource."
    )


def on_demand(scenes: object) -> bool:
    """Return whether ``scenes`` stands for generated (``FRESH`` or ``REFRESHING``) scenes.

    A curriculum of such scenes counts as well; so does ``CURRICULUM`` alone.
    """
    if not isinstance(scenes, str):
        return False
    return (graded_of(scenes) or scenes).partition(":")[0] in (FRESH, REFRESHING)


def graded_of(scenes: str) -> str | None:
    """Return the part of a ``CURRICULUM`` string that names its scenes, or None for other strings.

    Raises:
        InputError: nothing follows the colon, or another curriculum follows it.
    """
    head, colon, inner = scenes.partition(":")
    if head != CURRICULUM:
        return None
    if not colon:
        return FRESH
    if not inner.strip() or inner.strip().partition(":")[0] == CURRICULUM:
        raise InputError(
            f"scenes={scenes!r} does not specify the curriculum's scenes. Pass, for example, "
            f"'{CURRICULUM}:{STARTER}:train', '{CURRICULUM}:{FRESH}:an office desk', or just "
            f"{CURRICULUM!r}."
        )
    return inner.strip()


def _find(item: str | Path | Scene) -> list[SceneRef]:
    """Return references to the scenes that one item identifies, in a fixed order."""
    if isinstance(item, Scene):
        return [HeldRef(item)]
    if not isinstance(item, str | Path):
        raise InputError(
            f"A list of scenes cannot contain an item of type {type(item).__name__}: {item!r}."
        )
    if on_demand(item) or (isinstance(item, str) and graded_of(item)):
        raise InputError(
            f"{item!r} is not a fixed scene and cannot be part of a list; for several prompts "
            "pass scenes=FreshScenes([prompt, ...])."
        )
    if item in _SIDES:
        return list(fixed_scenes(STARTER).admitting(SplitRule(_SIDES[str(item)])).refs)
    import assets_cache

    try:
        return [bundle_ref(path) for path in assets_cache.find(item)]
    except BundleError as error:
        raise _explain(str(item), error) from error


def _explain(text: str, error: BundleError) -> BundleError | InputError:
    """Return the error for a name that matches no bundle, with a hint about similar values."""
    head, colon, _ = text.partition(":")
    if colon and head.isidentifier() and len(head) > 1:
        meant = text if head == STARTER else f"{head}:PROMPT"
        return InputError(f"scenes={text!r} is not supported." + choices(meant, FORMS))
    from rapidfuzz import fuzz, process

    if near := process.extractOne(text, FORMS, scorer=fuzz.ratio, score_cutoff=75):
        return BundleError(f"{error} Did you mean scenes={near[0]!r}?")
    return BundleError(f"{error} Besides bundles, scenes can be {', '.join(map(repr, FORMS))}.")
