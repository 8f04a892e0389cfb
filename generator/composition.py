"""The direct route: text to plan to layout to scene, without a picture.

Fast; objects are placed without overlap.
"""

from __future__ import annotations

from dataclasses import replace

from .errors import InputError, SceneError, require_seed
from .language.planner import plan_scene
from .layout import build_models, lay_out
from .layout.checking import list_unmet, record_relations, warn_unmet
from .method.assembly import AssemblyConfig, assemble
from .scene import Provenance, Scene, ScenePlan
from .scene.provenance import scene_name, versions

ATTEMPTS = 6
"""Layouts tried until one comes to rest soundly."""

_FULFILLED = 3  # layouts tried until one comes to rest with all relations that were asked for


def compose(
    text: str | ScenePlan,
    seed: int = 0,
    *,
    name: str | None = None,
    config: AssemblyConfig | None = None,
) -> Scene:
    """Compose a scene straight from a text (or a plan) with catalogue objects.

    The same text and seed give the same scene. A layout whose objects do not come to rest soundly
    is replaced by another one, and so is one at rest in which not every relation of the plan holds;
    of those the one with most is taken, with a warning for each that does not hold. What each thing
    stands on is what it rests on.

    Raises:
        InputError: the text cannot be planned, or the seed is not a whole number in range.
        SceneError: the objects fit on no plausible table, or no layout comes to rest.
    """
    require_seed(seed)
    seed = int(seed)
    plan = text if isinstance(text, ScenePlan) else plan_scene(text, seed)
    if not plan.objects:
        raise InputError("The plan holds no object; a scene needs at least one.")
    models = build_models(plan, seed)
    failures: tuple[str, ...] = ()
    best: Scene | None = None
    for attempt in range(ATTEMPTS):
        layout, table = lay_out(plan, models, seed + 7919 * attempt)
        provenance = Provenance(
            "compose", seed, plan.prompt, backends={"planner": "embedded"}, versions=versions(),
            warnings=tuple(dict.fromkeys([*plan.warnings, *layout.warnings])),
        )  # fmt: skip
        scene = assemble(
            models, layout.placements, table, table.size, provenance=provenance,
            name=name or scene_name(plan.prompt), config=config,
            plan=replace(plan, table=replace(plan.table, size=tuple(map(float, table.size)))),
        )  # fmt: skip
        assert scene.report is not None
        if not scene.report.passed:
            failures = scene.report.failures
            continue
        scene = record_relations(scene)
        if best is None or len(list_unmet(scene)) < len(list_unmet(best)):
            best = scene
        if not list_unmet(best) or attempt + 1 >= _FULFILLED:
            break
    if best is not None:
        return warn_unmet(best)
    raise SceneError(
        f"{ATTEMPTS} layouts of {plan.prompt!r} did not come to rest soundly: "
        f"{'; '.join(failures)}. Try another seed, or fewer stacked things."
    )
