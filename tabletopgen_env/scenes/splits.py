"""Splits: scenes to train on, and scenes held out, told apart by what they are.

By *digest*, a fixed share of all scenes is held out: what decides is a hash of the scene, so every
process, machine and list of scenes agrees, and scenes added later move none of the others. Scenes
on disk or in memory are hashed by their table and objects; scenes made on demand by what decides
them, their text (or distribution) and seed, so that none is made in vain.

By *category*, every scene with any object of a held-out category is held out. An object is of a
category by the catalogue's key, or by the words it is called ("alarm clock" is of alarm_clock).
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
"""What a scene is for."""

By = Literal["digest", "category"]
"""What decides the side of a scene."""

SHARE = 0.2
"""Share of all scenes that is held out by digest, unless said otherwise."""

DRAWS = 200
"""How many scenes of a foreign source are looked at for one of the right side."""


@dataclass(frozen=True)
class SplitRule:
    """One side of a split.

    Attributes:
        side: "train" or "held_out".
        by: "digest" or "category".
        share: by digest, the share of scenes held out, in (0, 1). What a share holds out, any
            larger share holds out, too.
        categories: by category, the held-out ones.

    Raises:
        InputError: an unknown word, or settings that do not go together.
    """

    side: Side
    by: By = "digest"
    share: float = SHARE
    categories: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        require_known(self.side, get_args(Side), "A split has no side")
        require_known(self.by, get_args(By), "A split has no by")
        if not 0 < self.share < 1:
            raise InputError(f"A split's share is in (0, 1), got {self.share}.")
        if isinstance(self.categories, str):
            raise InputError(f"categories is a tuple of names, got the text {self.categories!r}.")
        if bool(self.categories) != (self.by == "category"):
            raise InputError(
                "Name the held-out categories with by='category', and only then: by is "
                f"{self.by!r}, categories are {tuple(self.categories)}."
            )
        object.__setattr__(self, "categories", tuple(sorted({_key(c) for c in self.categories})))

    def admits(self, identity: Callable[[], str], kinds: Callable[[], frozenset[str]]) -> bool:
        """Tell whether a scene is on this side; only what decides is asked for.

        Args:
            identity: returns what tells the scene from all others, the same in every process.
            kinds: returns what ``kinds_of`` does.
        """
        if self.by == "category":
            held_out = not kinds().isdisjoint(self.categories)
        else:
            hashed = hashlib.sha256(identity().encode()).digest()
            held_out = int.from_bytes(hashed[:8], "big") / 2**64 < self.share
        return held_out == (self.side == "held_out")

    def check_categories(self, present: Iterable[str] = ()) -> None:
        """Refuse categories that are neither the catalogue's nor ``present`` in the scenes.

        Raises:
            InputError: there is no such category.
        """
        known = {*categories_known(), *present}
        for category in self.categories:
            require_known(category, known, "There is no category")

    def __str__(self) -> str:
        how = f"share={self.share:g}" if self.by == "digest" else f"categories={self.categories}"
        return f"{self.side!r} by {self.by} ({how})"


@runtime_checkable
class Described(Protocol):
    """A ``SceneRef.load`` that knows what a scene is without loading it whole."""

    def digest(self) -> str:
        """Return what ``generator.bundle.digest`` says of the scene."""
        ...

    def kinds(self) -> frozenset[str]:
        """Return the kinds of its objects; see ``kinds_of``."""
        ...


def admits(rule: SplitRule, ref: SceneRef) -> bool:
    """Tell whether a scene is on the side of a rule, loading it only if there is no other way."""
    return rule.admits(lambda: digest_of(ref), lambda: kinds(ref))


def digest_of(ref: SceneRef) -> str:
    """Return the digest of a scene, loading it only if there is no other way."""
    return ref.load.digest() if isinstance(ref.load, Described) else digest(ref.load())


def kinds(ref: SceneRef) -> frozenset[str]:
    """Return the kinds of the objects of a scene, loading it only if there is no other way."""
    return ref.load.kinds() if isinstance(ref.load, Described) else scene_kinds(ref.load())


def scene_kinds(scene: Scene) -> frozenset[str]:
    """Return the kinds of the objects of a scene."""
    return kinds_of((o.model.category, o.label) for o in scene.objects)


def kinds_of(objects: Iterable[tuple[str, str]]) -> frozenset[str]:
    """Return the categories of objects given by (category, label): both, written as keys."""
    words = {_key(word) for pair in objects for word in pair}
    return frozenset(words - {"generic"})


def _key(word: str) -> str:
    return "_".join(str(word).lower().replace("_", " ").split())


def admitting(source: SceneSource, rule: SplitRule) -> SceneSource:
    """Return the source of only those scenes that a rule admits.

    Raises:
        InputError: no scene is admitted, where that can be told, or there is no such category.
    """
    own = getattr(source, "admitting", None)
    return AdmittedScenes(source, rule) if own is None else own(rule)


@dataclass(eq=False)
class AdmittedScenes:
    """Those scenes of any source that a rule admits, found by drawing until one is.

    For sources that do not know how to keep to one side by themselves. Scenes are loaded to be
    judged, each once.
    """

    source: SceneSource
    rule: SplitRule
    _known: Remembered[bool] = field(default_factory=Remembered, init=False, repr=False)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw until a scene is on the side of the rule.

        Raises:
            SceneError: none of ``DRAWS`` drawn scenes is.
        """
        for ref in (self.source.draw(rng) for _ in range(DRAWS)):
            if self._known.of(ref, partial(admits, self.rule)):
                return ref
        raise SceneError(
            f"None of {DRAWS} drawn scenes is for {self.rule}. Choose another share or other "
            "categories, or give the source more scenes."
        )

    def record(self, ref: SceneRef, success: bool) -> None:
        """Pass on how an episode at a scene ended."""
        record(self.source, ref, success)

    def close(self) -> None:
        """Close the source."""
        close(self.source)
