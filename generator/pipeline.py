"""The whole method (Sec. 3, Fig. 2): each step of :func:`generate` is one stage."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

from .backends import Backends
from .backends.protocols import PoseGuesser
from .comparison.doubts import match_picture, warn_of_eye_level
from .errors import require_seed
from .generation import STAGES, Ablation, Config, Generation
from .method.ablation import ask_rotations, pose_guesser
from .method.alignment import Alignment, align, ask_layout
from .method.extraction import extract
from .method.models import make_models
from .method.publish import Reconstruction, publish
from .method.reference import DepthSource, Source, fetch, fetch_depth, refer, source_digest
from .method.refinement import Refinement, refine_scene
from .method.rotation import estimate_rotation, estimate_rotations
from .method.stopwatch import Stopwatch, Watch
from .scene import (
    Instance,
    Intrinsics,
    Model,
    Provenance,
    Reference,
    Rotation,
    Scene,
    SizePrior,
    View,
)
from .scene.provenance import plain, scene_name, versions

Progress = Callable[[str, int, int], None]
"""A callback at the start of a stage; receives its name, its number and the number of stages."""


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
    watch: Watch | None = None,
) -> Generation:
    """Turn a description or one picture of a tabletop into a simulated table.

    Args:
        source: a text, a plan, or a picture (path, encoded bytes, or uint8 array).
        backends: the backends that answer the stages' questions; None uses the embedded ones.
        config: settings of the stages.
        seed: the same source, backends, config and seed give the same scene.
        depth: the picture's depth map, of the same size: an array of metres (float) or millimetres
            (uint16), or a 16-bit PNG of millimetres; 0 or NaN where unknown. The table, sizes and
            positions are then metric.
        intrinsics: the intrinsics of the picture's camera, to be given with ``depth``.
        name: name of the scene; None makes one from the text, or "picture".
        progress: called as each stage starts.
        watch: called as each stage ends, with its name and the results so far, keyed by fields of
            ``Generation``; ``method.figures.draw_stage`` draws them.

    Raises:
        InputError: the source cannot be used, or the seed is not a whole number in range.
        BackendError: a backend could not answer, or cannot replace an omitted stage.
        SceneError: the scene cannot be built.
    """
    require_seed(seed)
    seed = int(seed)
    b, config = backends or Backends.select("embedded"), config or Config()
    b.check()  # fail before any work if a dependency or a file is missing
    source, depth = fetch(source, config.reference), fetch_depth(depth, config.reference)
    guesser = pose_guesser(b.reasoner) if config.without else None
    clock = Stopwatch(STAGES, progress, watch)
    step = clock.step

    step()  # Sec. 3: text to plan to reference image; a picture passes through
    reference = refer(
        source, b.reasoner, b.imager, seed, config.reference, depth=depth, intrinsics=intrinsics
    )
    if reference.plan is not None and config.supplement:
        b, config = b.for_text(), config.for_text()

    step(reference=reference)  # Sec. 3.1: list, detect, segment, complete
    reference, instances = extract(
        reference, b.reasoner, b.segmenter, b.imager, seed, config.extraction,
        complete_each=b.each("imager"),
    )  # fmt: skip

    step(reference=reference, instances=instances)  # Sec. 3.3: the view; Fig. 22: usual sizes
    view = b.reasoner.estimate_view(reference, instances[0])
    sizes = b.reasoner.estimate_sizes(reference, instances, view)

    step(view=view, sizes=sizes)  # Sec. 3.2: image to 3D, canonical alignment
    models = make_models(
        reference, instances, sizes, view, b.modeler, b.reasoner,
        model_each=b.each("modeler"), review_each=b.each("reasoner"),
    )  # fmt: skip
    run = _Run(b, config, seed, guesser, reference, instances, view, sizes, models)

    step(models=models)  # Sec. 3.3, DRO: Eqs. 1-4
    rotations = run.rotate()

    step(rotations=rotations)  # Sec. 3.3, TSA: Eqs. 5-6
    alignment = run.align(rotations)

    step(alignment=alignment)  # beyond the paper: all objects against all outlines, without depth
    refinement = run.refine(alignment)

    step(refinement=refinement)  # Sec. 3.4: bodies that rest, judged by the gate
    warnings = _warn_hidden(reference, instances) + alignment.warnings
    provenance = _provenance(source, depth, intrinsics, reference, b, config, seed, warnings)
    scene = run.publish(
        rotations, alignment, refinement, provenance, name or scene_name(reference.prompt)
    )
    match = None
    if reference.plan is None:
        match = match_picture(scene, instances, reference)
        scene = _with_warnings(scene, (*warn_of_eye_level(scene), *match.doubts, *match.notes))
    return Generation(
        reference, instances, view, sizes, models, rotations, alignment, refinement, scene,
        clock.stop(scene=scene), match,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Run:
    """The settings of a run and the results of its first stages, which the later stages share."""

    backends: Backends
    config: Config
    seed: int
    guesser: PoseGuesser | None  # stands in for the stages that are left out
    reference: Reference
    instances: tuple[Instance, ...]
    view: View
    sizes: Mapping[str, SizePrior]
    models: Mapping[str, Model]

    def _guesser(self, stage: Ablation) -> PoseGuesser | None:
        """Return the pose guesser that replaces a stage, or None if the stage is to run."""
        return self.guesser if stage in self.config.without else None

    def rotate(self) -> dict[str, Rotation]:
        if guesser := self._guesser("dro"):
            return ask_rotations(self.reference, self.instances, self.sizes, self.view, guesser)
        return estimate_rotations(
            self.reference, self.instances, self.models, self.view, self.backends.encoder,
            self.config.rotation, self.seed,
        )  # fmt: skip

    def align(self, rotations: Mapping[str, Rotation]) -> Alignment:
        known = self.reference, self.instances, self.models, self.sizes, rotations, self.view
        b = self.backends
        if guesser := self._guesser("tsa"):
            return ask_layout(*known, b.reasoner, guesser)
        return align(*known, b.imager, b.segmenter, b.reasoner, self.config.alignment)

    def refine(self, alignment: Alignment) -> Refinement:
        height, width = self.reference.image.shape[:2]
        config = self.config.refinement
        if self.reference.depth is not None or self.config.without:
            config = replace(config, steps=0)
        return refine_scene(
            self.instances, self.models, alignment.placements, alignment.table_scale, self.view,
            (width, height), config, self.seed,
        )  # fmt: skip

    def publish(
        self,
        rotations: Mapping[str, Rotation],
        alignment: Alignment,
        refinement: Refinement,
        provenance: Provenance,
        name: str,
    ) -> Scene:
        turn = partial(
            estimate_rotation, self.reference, self.instances, view=self.view,
            encoder=self.backends.encoder, config=self.config.rotation, seed=self.seed,
        )  # fmt: skip
        reconstruction = Reconstruction(
            self.reference, self.instances, self.sizes, self.models, self.view,
            alignment.table_scale, provenance, name, self.seed,
            assembly=self.config.assembly,
            refinement=self.config.refinement,
            supplements=self.config.supplement,
            of_catalogue=getattr(self.backends.imager, "draws_catalogue", False),
            leave_out=self.config.leave_out,
            rotations=rotations,
            turn=None if self._guesser("dro") else turn,
        )  # fmt: skip
        return publish(reconstruction, refinement, alignment.placements)


def _with_warnings(scene: Scene, warnings: tuple[str, ...]) -> Scene:
    known = scene.provenance
    return scene.replace(provenance=replace(known, warnings=known.warnings + warnings))


def _warn_hidden(reference: Reference, instances: tuple[Instance, ...]) -> tuple[str, ...]:
    """Return a warning if fewer objects were detected than planned."""
    planned = len(reference.plan.objects) if reference.plan else 0
    found = len(instances) - 1
    if found >= planned:
        return ()
    return (f"Only {found} of the {planned} requested objects were found in the drawing.",)


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
        settings["depth"] = {"sha256": source_digest(depth), "intrinsics": plain(intrinsics)}
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
