"""The method as one page (Sec. 3, Fig. 2): each line of :func:`generate` is a stage."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, get_args

from .backends import Backends
from .errors import InputError, choices, require_seed
from .method.ablation import ask_rotations, pose_guesser
from .method.alignment import (
    Alignment,
    AlignmentConfig,
    align,
    ask_layout,
)
from .method.assembly import AssemblyConfig, assemble
from .method.extraction import ExtractionConfig, extract
from .method.finishing import finished
from .method.ledger import Seconds, Stopwatch
from .method.modeling import make_models
from .method.reference import (
    DepthSource,
    ReferenceConfig,
    Source,
    depth_digest,
    fetch,
    fetch_depth,
    refer,
    source_digest,
)
from .method.refinement import (
    Refinement,
    RefinementConfig,
    outline_misfit,
    refine_scene,
)
from .method.rotation import RotationConfig, estimate_rotations
from .method.salvage import allowance, salvaged
from .method.supplement import NOTHING, Supplement, supplement
from .scene import (
    TABLE,
    Instance,
    Intrinsics,
    Model,
    Placement,
    Provenance,
    Reference,
    Rotation,
    Scene,
    SizePrior,
    View,
)
from .scene.provenance import plain, scene_name, versions

Progress = Callable[[str, int, int], None]
"""Called with the name of the stage that starts, its number, and how many there are."""

STAGES = ("reference", "extraction", "view and sizes", "modeling", "rotation", "alignment",
          "refinement", "assembly")  # fmt: skip

Ablation = Literal["dro", "tsa"]
"""A stage that can be left out (Sec. 4.3)."""


@dataclass(frozen=True)
class Config:
    """Settings of every stage; the defaults are the paper's unless a stage says otherwise.

    ``supplement``: put what a text asks for and no drawing shows where the plan has it; False
    leaves it out.

    ``leave_out``: the largest share of what was found that may be left out of a scene that would
    not pass its gate otherwise, in [0, 1]: one of two or more at least, never all. 0 leaves
    nothing out.

    ``without``: stages left out as in the paper's ablations (Sec. 4.3, Table 3): the reasoner is
    asked for what "dro" (rotations) or "tsa" (places and sizes) would have found. The joint
    refinement, which would repair what was left out, is then off too. By itself it is turned off
    by ``RefinementConfig(steps=0)``.

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


@dataclass(frozen=True, eq=False)
class Generation:
    """A scene and everything that led to it, in the order it came about (Sec. 6.1).

    ``seconds`` is how long each of ``STAGES`` took (Sec. 6.2); no bundle holds it.
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

    def save(self, folder: str | Path, *, allow_failed: bool = False) -> Path:
        """Publish the scene as a bundle under ``folder``; return the bundle's path."""
        from .bundle import Segments, save
        from .method.figures import bundle_images

        found = Segments.of(self.instances)
        return save(
            self.scene, folder, images=bundle_images(self), segments=found,
            allow_failed=allow_failed,
        )  # fmt: skip

    def save_figures(self, folder: str | Path) -> tuple[Path, ...]:
        """Write the pictures and JSON of the paper's Sec. 6.1 (Figs. 8-14) into ``folder``."""
        from .method.figures import save_figures

        return save_figures(self, Path(folder))


def generate(
    source: Source,
    backends: Backends | None = None,
    config: Config | None = None,
    seed: int = 0,
    *,
    depth: DepthSource | None = None,
    intrinsics: Intrinsics | None = None,
    name: str | None = None,
    progress: Progress | None = None,
) -> Generation:
    """Turn a text or one picture of a tabletop into a simulated table.

    Args:
        source: a text, a plan, or a picture (path, encoded bytes, or uint8 array).
        backends: who answers the stages' questions; None for the embedded ones.
        config: settings of the stages.
        seed: the same source, backends, config and seed give the same scene.
        depth: the picture's depth map, of the same size: an array of metres (float) or
            millimetres (uint16), or a 16-bit PNG of millimetres; 0 or NaN where unknown. Table,
            sizes and places are then metric.
        intrinsics: of the picture; they go with ``depth``.
        name: name of the scene; None makes one from the text, or "picture".
        progress: called as each stage starts.

    Raises:
        InputError: the source cannot be used, or the seed is none.
        BackendError: a backend could not answer, or cannot stand in for a stage left out.
        SceneError: the scene cannot be built.
    """
    require_seed(seed)
    seed = int(seed)
    b = backends or Backends.select("embedded")
    config = config or Config()
    guesser = pose_guesser(b.reasoner) if config.without else None  # refused before any work
    clock = Stopwatch(STAGES, progress)
    step = clock.step

    step()  # Sec. 3: text to plan to reference image; a picture passes through
    source = fetch(source, config.reference)
    depth = fetch_depth(depth, config.reference)
    reference = refer(
        source, b.reasoner, b.imager, seed, config.reference, depth=depth, intrinsics=intrinsics
    )

    step()  # Sec. 3.1: list, detect, segment, complete
    reference, instances = extract(
        reference, b.reasoner, b.segmenter, b.imager, seed, config.extraction,
        complete_each=b.each("imager"),
    )  # fmt: skip

    step()  # Sec. 3.3: the camera's azimuth and elevation; Fig. 22: commonsense sizes
    view = b.reasoner.estimate_view(reference, _table(instances))
    sizes = b.reasoner.estimate_sizes(reference, instances, view)

    step()  # Sec. 3.2: image to 3D, canonical alignment
    models = make_models(
        reference, instances, sizes, view, b.modeler, b.reasoner,
        model_each=b.each("modeler"), review_each=b.each("reasoner"),
    )  # fmt: skip

    step()  # Sec. 3.3, DRO: Eqs. 1-4; left out (Sec. 4.3), the reasoner says the yaws
    if guesser is not None and "dro" in config.without:
        rotations = ask_rotations(reference, instances, sizes, view, guesser)
    else:
        rotations = estimate_rotations(
            reference, instances, models, view, b.encoder, config.rotation, seed
        )

    step()  # Sec. 3.3, TSA: Eqs. 5-6; left out (Sec. 4.3), the reasoner says places and sizes
    if guesser is not None and "tsa" in config.without:
        alignment = ask_layout(
            reference, instances, models, sizes, rotations, view, b.reasoner, guesser
        )
    else:
        alignment = align(
            reference, instances, models, sizes, rotations, view,
            b.imager, b.segmenter, b.reasoner, config.alignment,
        )  # fmt: skip

    step()  # beyond the paper: everything together against all outlines; depth knows better
    unrefined = depth is not None or config.without
    placements = alignment.placements
    height, width = reference.image.shape[:2]
    refined = refine_scene(
        instances, models, placements, alignment.table_scale, view, (width, height),
        replace(config.refinement, steps=0) if unrefined else config.refinement, seed,
    )  # fmt: skip

    warnings = _hidden(reference, instances) + alignment.warnings

    def added(placed: tuple[Placement, ...], gone: tuple[str, ...]) -> Supplement:
        plan, scale = reference.plan, alignment.table_scale
        if not config.supplement:
            return NOTHING
        return supplement(plan, instances, models, placed, scale, seed, gone)

    def assembled(placed: tuple[Placement, ...], extra: Supplement, told: tuple[str, ...]) -> Scene:
        told = warnings + extra.warnings + told
        return assemble(
            {n: model for n, model in {**models, **extra.models}.items() if n != TABLE},
            (*placed, *extra.placements),
            models[TABLE],
            alignment.table_scale,
            provenance=_provenance(source, depth, intrinsics, reference, b, config, seed, told),
            name=name or scene_name(reference.prompt),
            config=config.assembly,
            view=view,
            plan=reference.plan,
        )

    def built(placed: tuple[Placement, ...], told: tuple[str, ...]) -> Scene:
        return salvaged(
            lambda placed, extra, more: assembled(placed, extra, told + more),
            added, placed, sizes, allowance(config.leave_out, len(placed)),
        )  # fmt: skip

    def misfit(scene: Scene) -> float:
        size = width, height
        return outline_misfit(instances, scene.objects, view, size, config.refinement, seed)

    step()  # Sec. 3.4: bodies with mass, friction and convex parts; settled and judged
    scene = finished(built, misfit, refined, alignment.placements)
    return Generation(
        reference, instances, view, sizes, models, rotations, alignment, refined, scene,
        clock.stop(),
    )  # fmt: skip


def _table(instances: tuple[Instance, ...]) -> Instance:
    for instance in instances:
        if instance.name == TABLE:
            return instance
    raise InputError("No table was found in the picture. Show the whole tabletop.")


def _hidden(reference: Reference, instances: tuple[Instance, ...]) -> tuple[str, ...]:
    """Return a warning if fewer things were found than planned."""
    planned = len(reference.plan.objects) if reference.plan else 0
    found = len(instances) - 1
    if found >= planned:
        return ()
    return (f"Found {found} of the {planned} things asked for in the picture drawn of them.",)


def _provenance(
    source: Source,
    depth: DepthSource | None,
    intrinsics: Intrinsics | None,
    reference: Reference,
    backends: Backends,
    config: Config,
    seed: int,
    warnings: tuple[str, ...],
) -> Provenance:
    planned = reference.plan.warnings if reference.plan else ()
    settings = plain(config)
    if depth is not None:
        settings["depth"] = {"sha256": depth_digest(depth), "intrinsics": plain(intrinsics)}
    return Provenance(
        kind="image" if reference.plan is None else "text",
        seed=seed,
        prompt=reference.prompt,
        source_sha256=source_digest(source),
        backends=backends.identity(),
        config=settings,
        versions=versions(),
        warnings=planned + warnings,
    )
