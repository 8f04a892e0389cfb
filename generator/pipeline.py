"""The method as one page (Sec. 3, Fig. 2): each line of :func:`generate` is a stage."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from .backends import Backends
from .comparison.doubts import match_picture, warn_of_eye_level
from .errors import require_seed
from .generation import STAGES, Config, Generation
from .method.ablation import ask_rotations, pose_guesser
from .method.alignment import align, ask_layout
from .method.extraction import extract
from .method.models import make_models
from .method.publish import Reconstruction, publish
from .method.reference import DepthSource, Source, fetch, fetch_depth, refer, source_digest
from .method.refinement import refine_scene
from .method.rotation import estimate_rotation, estimate_rotations
from .method.stopwatch import Stopwatch, Watch
from .scene import Instance, Intrinsics, Provenance, Reference, Scene
from .scene.provenance import plain, scene_name, versions

Progress = Callable[[str, int, int], None]
"""Called with the name of the stage that starts, its number, and how many there are."""


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
        watch: called as each stage ends, with its name and what was found until then, by names of
            fields of ``Generation``; ``method.figures.draw_stage`` makes pictures of it.

    Raises:
        InputError: the source cannot be used, or the seed is not a whole number in range.
        BackendError: a backend could not answer, or cannot stand in for a stage left out.
        SceneError: the scene cannot be built.
    """
    require_seed(seed)
    seed = int(seed)
    b = backends or Backends.select("embedded")
    config = config or Config()
    b.check()  # fail before any work if a dependency or a file is missing
    source = fetch(source, config.reference)
    depth = fetch_depth(depth, config.reference)
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

    step(models=models)  # Sec. 3.3, DRO: Eqs. 1-4; left out (Sec. 4.3), the reasoner says the yaws
    if guesser is not None and "dro" in config.without:
        rotations = ask_rotations(reference, instances, sizes, view, guesser)
    else:
        rotations = estimate_rotations(
            reference, instances, models, view, b.encoder, config.rotation, seed
        )

    step(rotations=rotations)  # Sec. 3.3, TSA: Eqs. 5-6; left out, the reasoner says the layout
    if guesser is not None and "tsa" in config.without:
        alignment = ask_layout(
            reference, instances, models, sizes, rotations, view, b.reasoner, guesser
        )
    else:
        alignment = align(
            reference, instances, models, sizes, rotations, view,
            b.imager, b.segmenter, b.reasoner, config.alignment,
        )  # fmt: skip

    step(alignment=alignment)  # beyond the paper: all together against all outlines, without depth
    unrefined = depth is not None or config.without
    placements = alignment.placements
    height, width = reference.image.shape[:2]
    refined = refine_scene(
        instances, models, placements, alignment.table_scale, view, (width, height),
        replace(config.refinement, steps=0) if unrefined else config.refinement, seed,
    )  # fmt: skip

    step(refinement=refined)  # Sec. 3.4: bodies with mass, friction, convex parts; settled, judged
    warnings = _warn_hidden(reference, instances) + alignment.warnings
    found = Reconstruction(
        reference, instances, sizes, models, view, alignment.table_scale,
        _provenance(source, depth, intrinsics, reference, b, config, seed, warnings),
        name or scene_name(reference.prompt), seed,
        config.assembly, config.refinement, config.supplement,
        getattr(b.imager, "draws_catalogue", False), config.leave_out, rotations,
        None if guesser is not None and "dro" in config.without else partial(
            estimate_rotation, reference, instances, view=view, encoder=b.encoder,
            config=config.rotation, seed=seed,
        ),
    )  # fmt: skip
    scene = publish(found, refined, alignment.placements)
    match = None
    if reference.plan is None:
        match = match_picture(scene, instances, reference)
        told = (*warn_of_eye_level(scene), *match.doubts, *match.notes)
        scene = _with_warnings(scene, told)
    return Generation(
        reference, instances, view, sizes, models, rotations, alignment, refined, scene,
        clock.stop(scene=scene), match,
    )  # fmt: skip


def _with_warnings(scene: Scene, warnings: tuple[str, ...]) -> Scene:
    known = scene.provenance
    return scene.replace(provenance=replace(known, warnings=known.warnings + warnings))


def _warn_hidden(reference: Reference, instances: tuple[Instance, ...]) -> tuple[str, ...]:
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
