"""Splits into training scenes and held-out scenes, by properties of each scene alone.

By *digest*, a fixed share of all scenes is held out. A hash of the scene determines its side, so
all processes, machines and lists of scenes agree, and new scenes do not change the side of others.
Scenes on disk or in memory are hashed by their table and objects; scenes generated on demand by
their inputs, the prompt (or distribution) and the seed, so that no rejected scene is generated.

By *category*, every scene with an object of a held-out category is held out. An object belongs to a
category by its catalogue key or by its label ("alarm clock" belongs to alarm_clock).
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import partial
from typing import Literal, Protocol, get_args, runtime_checkable

import numpy as np

from generator.bundle import digest
from generator.errors import InputError, SceneError, require_known
from generator.language.distribution import categories_known
from generator.scene import Scene

from .source import Remembered, SceneRef, SceneSource, close, record

Side = Literal["train", "held_out"]
"""The two sides of a split: training scenes and held-out scenes."""

By = Literal["digest", "category"]
"""The property that determines the side of a scene."""

SHARE = 0.2
"""Default fraction of scenes held out by digest."""

DRAWS = 200
"""Maximum number of draws from a user's own source to find one scene on the required side."""


@dataclass(frozen=True)
class SplitRule:
    """One subset of a split: the training scenes or the held-out scenes.

    Attributes:
        side: "train" or "held_out".
        by: "digest" or "category".
        share: by digest, the share of scenes held out, in (0, 1). Scenes held out with one share
            are also held out with any larger share.
        categories: by category, the held-out ones.

    Raises:
        InputError: ``side`` or ``by`` is unknown, or settings are inconsistent.
    """

    side: Side
    by: By = "digest"
    share: float = SHARE
    categories: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        require_known(self.side, get_args(Side), "Unknown Split.side")
        require_known(self.by, get_args(By), "Unknown Split.by")
        if not 0 < self.share < 1:
            raise InputError(f"Split.share must be in (0, 1), got {self.share}.")
        if isinstance(self.categories, str):
            raise InputError(
                f"Split.categories must be a tuple of names, not the string {self.categories!r}."
            )
        if bool(self.categories) != (self.by == "category"):
            raise InputError(
                "Split.categories must be given if and only if Split.by is 'category', got "
                f"by={self.by!r} and categories={tuple(self.categories)}."
            )
        object.__setattr__(self, "categories", tuple(sorted({_key(c) for c in self.categories})))

    def admits(self, identity: Callable[[], str], kinds: Callable[[], frozenset[str]]) -> bool:
        """Return whether a scene is in this subset; only the necessary argument is called.

        Args:
            identity: returns the identity of the scene, the same in every process.
            kinds: returns the result of ``kinds_of``.
        """
        if self.by == "category":
            held_out = not kinds().isdisjoint(self.categories)
        else:
            hashed = hashlib.sha256(identity().encode()).digest()
            held_out = int.from_bytes(hashed[:8], "big") / 2**64 < self.share
        return held_out == (self.side == "held_out")

    def check_categories(self, present: Iterable[str] = ()) -> None:
        """Check that categories exist in the catalogue or are ``present`` in the scenes.

        Raises:
            InputError: a category does not exist.
        """
        known = {*categories_known(), *present}
        for category in self.categories:
            require_known(category, known, "Unknown category")

    def __str__(self) -> str:
        how = f"share={self.share:g}" if self.by == "digest" else f"categories={self.categories}"
        return f"{self.side!r} by {self.by} ({how})"


@runtime_checkable
class Described(Protocol):
    """A ``SceneRef.load`` that can describe a scene without loading it completely."""

    def digest(self) -> str:
        """Return the scene's ``generator.bundle.digest``."""
        ...

    def kinds(self) -> frozenset[str]:
        """Return the categories of the objects; see ``kinds_of``."""
        ...


def admits(rule: SplitRule, ref: SceneRef) -> bool:
    """Return whether a rule admits a scene, loading the scene only if necessary."""
    return rule.admits(lambda: digest_of(ref), lambda: kinds(ref))


def digest_of(ref: SceneRef) -> str:
    """Return the digest of a scene, loading the scene only if necessary."""
    return ref.load.digest() if isinstance(ref.load, Described) else digest(ref.load())


def kinds(ref: SceneRef) -> frozenset[str]:
    """Return the categories of a scene's objects, loading the scene only if necessary."""
    return ref.load.kinds() if isinstance(ref.load, Described) else scene_kinds(ref.load())


def scene_kinds(scene: Scene) -> frozenset[str]:
    """Return the categories of a scene's objects."""
    return kinds_of((o.model.category, o.label) for o in scene.objects)


def kinds_of(objects: Iterable[tuple[str, str]]) -> frozenset[str]:
    """Return a set of keys: the categories and labels in the objects' (category, label) pairs."""
    words = {_key(word) for pair in objects for word in pair}
    return frozenset(words - {"generic"})


def _key(word: str) -> str:
    return "_".join(str(word).lower().replace("_", " ").split())


def admitting(source: SceneSource, rule: SplitRule) -> SceneSource:
    """Return a source of the scenes that a rule admits.

    Raises:
        InputError: no scene is admitted, if this is known, or a category does not exist.
    """
    own = getattr(source, "admitting", None)
    return AdmittedScenes(source, rule) if own is None else own(rule)


@dataclass(eq=False)
class AdmittedScenes:
    """The scenes of any source that a rule admits, found by rejection sampling.

    It is used for sources without ``admitting``. Scenes are loaded for the check, once each.
    """

    source: SceneSource
    rule: SplitRule
    _known: Remembered[bool] = field(default_factory=Remembered, init=False, repr=False)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw scenes until the rule admits one.

        Raises:
            SceneError: none of ``DRAWS`` drawn scenes is.
        """
        for ref in (self.source.draw(rng) for _ in range(DRAWS)):
            if self._known.of(ref, partial(admits, self.rule)):
                return ref
        raise SceneError(
            f"None of {DRAWS} drawn scenes belongs to {self.rule}. Choose another fraction "
            "(share) or other categories, or add scenes to the source."
        )

    def record(self, ref: SceneRef, success: bool) -> None:
        """Forward the result of an episode."""
        record(self.source, ref, success)

    def close(self) -> None:
        """Close the source."""
        close(self.source)
