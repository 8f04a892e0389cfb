"""The settings of a generation, and its results."""

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
"""A stage that can be omitted, as in the ablations of the paper (Sec. 4.3)."""


@dataclass(frozen=True)
class Config:
    """Settings of every stage; the defaults are the paper's unless a stage documents others.

    Attributes:
        rotation: settings of the rotation stage. The plan of a text settles what this stage leaves
            open, so a text uses the ``quick`` settings unless you change the defaults.
        supplement: whether the plan of a text corrects what its drawing does not show, or shows
            with another size, place or relation.
        leave_out: maximum fraction of the detected objects, in [0, 1], that may be left out of a
            scene that would otherwise fail its gate. If there are two or more objects, one may
            always be left out, but never all of them. 0 leaves nothing out.
        without: stages to omit, as in the paper's ablations (Sec. 4.3, Table 3): the reasoner
            estimates what "dro" (rotations) or "tsa" (positions and sizes) would have found. The
            joint refinement, which would correct these estimates, is then off too. (To turn off
            only the refinement, use ``RefinementConfig(steps=0)``.)

    Raises:
        InputError: ``without`` names another stage, or ``leave_out`` is out of range.
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
            raise InputError(f"Config.leave_out must be in [0, 1], got {self.leave_out}.")
        known: tuple[Ablation, ...] = get_args(Ablation)
        if isinstance(self.without, str):
            raise InputError(
                f"Config.without must be a tuple of {' and '.join(map(repr, known))}, not the "
                f"string {self.without!r}."
            )
        unknown = next((s for s in self.without if s not in known), None)
        if unknown is not None:
            raise InputError(
                f"Config.without: unknown stage {unknown!r}." + choices(unknown, known)
            )
        object.__setattr__(self, "without", tuple(s for s in known if s in self.without))

    def for_text(self) -> Config:
        """Return the settings for prompts, with quick rotation unless its settings were changed."""
        device = self.rotation.device
        if self.rotation != RotationConfig(device=device):
            return self
        return replace(self, rotation=replace(RotationConfig.quick(), device=device))


@dataclass(frozen=True, eq=False)
class Generation:
    """A scene and all intermediate results, in the order in which they are made (Sec. 6.1).

    ``seconds`` is the duration of each of ``STAGES`` (Sec. 6.2), which bundles do not record.
    ``match`` is how well the scene's view matches the picture that it was made from, or None for
    the scene of a text; its doubts and notes are also among the scene's warnings.
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
