"""Scenes that are there: bundles on disk, and scenes in memory."""

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
    """Loads the bundle at a path, which need not be there any more."""

    path: Path

    def __call__(self) -> Scene:
        """Read the whole scene, every file checked.

        Raises:
            BundleError: the bundle is gone or damaged.
        """
        return load(self.path)

    def exists(self) -> bool:
        """Tell whether the bundle is still there; says nothing of damage."""
        return (self.path / "scene.json").is_file()

    def digest(self) -> str:
        """Return the digest of what is on the table."""
        return load_digest(self.path)

    def kinds(self) -> frozenset[str]:
        """Return the kinds of its objects."""
        return kinds_of(load_kinds(self.path))


def bundle_ref(path: Path) -> SceneRef:
    """Refer to the bundle at a path; the working directory may change afterwards."""
    place = path.resolve()
    return SceneRef(f"bundle:{place}", Bundle(place))


def folder(ref: SceneRef) -> Path | None:
    """Return the folder of a scene's bundle; None for other scenes."""
    return ref.load.path if isinstance(ref.load, Bundle) else None


def is_there(ref: SceneRef) -> bool:
    """Tell whether a scene can still be loaded, as far as a glance at the disk tells."""
    return not isinstance(ref.load, Bundle) or ref.load.exists()


@dataclass(eq=False)
class FixedScenes:
    """Draws uniformly from fixed scenes.

    A bundle that is deleted while the environment runs is passed over, with one warning, as long
    as other scenes are left; when it comes back it is drawn again. A damaged one is an error.
    """

    refs: tuple[SceneRef, ...]
    _warned: bool = field(default=False, init=False, repr=False)

    def __post_init__(self) -> None:
        self.refs = tuple(self.refs)
        if not self.refs:
            raise InputError("A scene source needs at least one scene; the list is empty.")

    def __len__(self) -> int:
        return len(self.refs)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw one of the scenes, all equally likely.

        Raises:
            BundleError: every scene was a bundle, and all are gone.
        """
        ref = self.refs[int(rng.integers(len(self.refs)))]
        if is_there(ref):
            return ref
        left = [other for other in self.refs if is_there(other)]
        missing = f"The bundle {folder(ref)} is gone since the environment was made"
        if not left:
            others = f", and so are the other {len(self) - 1}" if len(self) > 1 else ""
            raise BundleError(f"{missing}{others}. Put it back, or pass other scenes.")
        if not self._warned:
            self._warned = True
            warnings.warn(
                f"{missing}; continuing with the {len(left)} of {len(self)} scenes that are left.",
                RuntimeWarning, stacklevel=2,
            )  # fmt: skip
        return left[int(rng.integers(len(left)))]

    def admitting(self, rule: SplitRule) -> FixedScenes:
        """Return only the scenes that a rule admits.

        Raises:
            InputError: none is left, or there is no such category.
            BundleError: a bundle is gone or damaged.
        """
        if rule.categories:
            rule.check_categories(word for ref in self.refs for word in kinds(ref))
        kept = tuple(ref for ref in self.refs if admits(rule, ref))
        if not kept:
            raise InputError(
                f"None of the {len(self)} scenes is for {rule}. Choose another share or other "
                "categories, or give more scenes."
            )
        return FixedScenes(kept)
