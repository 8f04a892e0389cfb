"""Fixed scenes: bundles on disk and scenes in memory."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from generator.bundle import load, load_digest, load_kinds
from generator.errors import BundleError, InputError
from generator.scene import Scene

from .source import SceneRef
from .splits import SplitRule, admits, kinds, kinds_of


@dataclass(frozen=True)
class Bundle:
    """A loader of the bundle at a path, which may have been deleted in the meantime."""

    path: Path

    def __call__(self) -> Scene:
        """Read the whole scene, and check every file.

        Raises:
            BundleError: the bundle is missing or damaged.
        """
        return load(self.path)

    def exists(self) -> bool:
        """Return whether the bundle exists; damage is not detected."""
        return (self.path / "scene.json").is_file()

    def digest(self) -> str:
        """The digest of the table and its objects."""
        return load_digest(self.path)

    def kinds(self) -> frozenset[str]:
        """The categories of the objects."""
        return kinds_of(load_kinds(self.path))


def bundle_ref(path: Path) -> SceneRef:
    """Return a reference to the bundle at a path, independent of the working directory."""
    place = path.resolve()
    return SceneRef(f"bundle:{place}", Bundle(place))


def folder(ref: SceneRef) -> Path | None:
    """Return the folder of a scene's bundle, or None for other scenes."""
    return ref.load.path if isinstance(ref.load, Bundle) else None


def is_there(ref: SceneRef) -> bool:
    """Return whether a scene can still be loaded, by a quick check of the disk."""
    return not isinstance(ref.load, Bundle) or ref.load.exists()


@dataclass(eq=False)
class FixedScenes:
    """A uniform sampler of fixed scenes.

    A bundle that is deleted while the environment runs is skipped, with one warning, as long as
    other scenes remain; if it reappears, it is drawn again. A damaged bundle raises an error.
    """

    refs: tuple[SceneRef, ...]
    _warned: bool = field(default=False, init=False, repr=False)

    def __post_init__(self) -> None:
        self.refs = tuple(self.refs)
        if not self.refs:
            raise InputError("The list of scenes must not be empty.")

    def __len__(self) -> int:
        return len(self.refs)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw one of the scenes uniformly.

        Raises:
            BundleError: all scenes were bundles that no longer exist.
        """
        ref = self.refs[int(rng.integers(len(self.refs)))]
        if is_there(ref):
            return ref
        left = [other for other in self.refs if is_there(other)]
        missing = f"The bundle {folder(ref)} no longer exists"
        if not left:
            others = f", nor do the other {len(self) - 1}" if len(self) > 1 else ""
            raise BundleError(f"{missing}{others}. Restore it, or pass other scenes.")
        if not self._warned:
            self._warned = True
            warnings.warn(
                f"{missing}; continuing with the remaining {len(left)} of {len(self)} scenes.",
                RuntimeWarning, stacklevel=2,
            )  # fmt: skip
        return left[int(rng.integers(len(left)))]

    def admitting(self, rule: SplitRule) -> FixedScenes:
        """Return the scenes that a rule admits.

        Raises:
            InputError: no scene is left, or a category does not exist.
            BundleError: a bundle is missing or damaged.
        """
        if rule.categories:
            rule.check_categories(word for ref in self.refs for word in kinds(ref))
        kept = tuple(ref for ref in self.refs if admits(rule, ref))
        if not kept:
            raise InputError(
                f"None of the {len(self)} scenes belongs to {rule}. Choose another fraction "
                "(share) or other categories, or pass more scenes."
            )
        return FixedScenes(kept)
