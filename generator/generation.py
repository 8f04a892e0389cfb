"""What a generation is made with, and what comes of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Literal, get_args

from .comparison.doubts import PictureMatch
from .errors import InputError, choices
from .method.alignment import Alignment, AlignmentConfig
from .method.assembly import AssemblyConfig
from .method.extraction import ExtractionConfig
from .method.figures import bundle_images, save_figures
from .method.reference import ReferenceConfig
from .method.refinement import Refinement, RefinementConfig
from .method.rotation import RotationConfig
from .method.stopwatch import Seconds
from .scene import Instance, Model, Reference, Rotation, Scene, SizePrior, View

STAGES = ("reference", "extraction", "view and sizes", "modeling", "rotation", "alignment",
          "refinement", "assembly")  # fmt: skip

Ablation = Literal["dro", "tsa"]
"""A stage that can be left out (Sec. 4.3)."""


@dataclass(frozen=True)
class Config:
    """Settings of every stage; the defaults are the paper's unless a stage says otherwise.

    Attributes:
        rotation: a text's plan puts right what rotations leave open, so that its own are the
            ``quick`` settings, unless others than the defaults are given.
        supplement: put right by a text's plan what no drawing shows, or shows in another size,
            place or relation, or not.
        leave_out: the largest share of what was found that may be left out of a scene that would
            not pass its gate otherwise, in [0, 1]: one of two or more at least, never all. 0
            leaves nothing out.
        without: stages left out as in the paper's ablations (Sec. 4.3, Table 3): the reasoner is
            asked for what "dro" (rotations) or "tsa" (places and sizes) would have found. The
            joint refinement, which would repair that, is then off too (by itself it is turned
            off by ``RefinementConfig(steps=0)``).

    Raises:
        InputError: ``without`` names another stage, or ``leave_out`` is no share.
    """

    reference: ReferenceConfig = field(default_factory=ReferenceConfig)
    extraction: ExtractionConfig = field(default_factory=ExtractionConfig)
    rotation: RotationConfig = field(default_factory=RotationConfig)
    alignment: AlignmentConfig = field(default_factory=AlignmentConfig)
    refinement: RefinementConfig = field(default_factory=RefinementConfig)
    assembly: AssemblyConfig = field(default_factory=AssemblyConfig)
    supplement: bool = True
    leave_out: float = 0.2
    without: tuple[Ablation, ...] = ()

    def __post_init__(self) -> None:
        if not 0 <= self.leave_out <= 1:
            raise InputError(f"Config.leave_out is a share in [0, 1], got {self.leave_out}.")
        known: tuple[Ablation, ...] = get_args(Ablation)
        if isinstance(self.without, str):
            raise InputError(
                f"Config.without is a tuple of {' and '.join(map(repr, known))}, got the text "
                f"{self.without!r}."
            )
        unknown = next((s for s in self.without if s not in known), None)
        if unknown is not None:
            raise InputError(
                f"Config.without: {unknown!r} is no stage to leave out." + choices(unknown, known)
            )
        object.__setattr__(self, "without", tuple(s for s in known if s in self.without))

    def for_text(self) -> Config:
        """Return the settings that a text is reconstructed with."""
        device = self.rotation.device
        if self.rotation != RotationConfig(device=device):
            return self
        return replace(self, rotation=replace(RotationConfig.quick(), device=device))


@dataclass(frozen=True, eq=False)
class Generation:
    """A scene and everything that led to it, in the order it came about (Sec. 6.1).

    ``seconds`` is how long each of ``STAGES`` took (Sec. 6.2); no bundle holds it. ``match``
    tells how the scene's view compares with the picture it was made from; None for a text's scene.
    Its doubts and notes are among the scene's warnings too.
    """

    reference: Reference
    instances: tuple[Instance, ...]
    view: View
    sizes: Mapping[str, SizePrior]
    models: Mapping[str, Model]
    rotations: Mapping[str, Rotation]
    alignment: Alignment
    refinement: Refinement
    scene: Scene
    seconds: Mapping[str, Seconds] = field(default_factory=dict)
    match: PictureMatch | None = None

    def save(self, folder: str | Path, *, allow_failed: bool = False) -> Path:
        """Publish the scene as a bundle under ``folder``; return the bundle's path."""
        from .bundle import Segments, save

        return save(
            self.scene, folder, segments=Segments.of(self.instances), allow_failed=allow_failed,
            images=bundle_images(self.reference, self.alignment.top_view, self.scene),
        )  # fmt: skip

    def save_figures(self, folder: str | Path) -> tuple[Path, ...]:
        """Write the pictures and JSON of the paper's Sec. 6.1 (Figs. 8-14) into ``folder``."""
        return save_figures(Path(folder), {f.name: getattr(self, f.name) for f in fields(self)})
