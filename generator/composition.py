"""The direct route from a text prompt to a plan, a layout and a scene, without a picture.

This route is fast, and it places objects without overlap.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from .errors import InputError, SceneError, require_seed
from .language.planner import plan_scene
from .layout import build_models, lay_out
from .layout.relation_check import (
    Rest,
    check_relations,
    observe,
    record_relations,
    warn_unmet,
)
from .method.assembly import AssemblyConfig, Rested, bring_to_rest, finish
from .method.attempts import ATTEMPTS, Candidate, try_layouts
from .scene import Density, Model, Provenance, Scene, ScenePlan
from .scene.provenance import scene_name, versions

_FULFILLED = 3  # layouts tried until a sound one will do in which not all relations hold


def compose(
    text: str | ScenePlan,
    seed: int = 0,
    *,
    name: str | None = None,
    density: Density | None = None,
    config: AssemblyConfig | None = None,
) -> Scene:
    """Compose a scene directly from a text (or a plan) with catalogue objects.

    The same text and seed give the same scene. If the objects of a layout do not come to rest
    properly, or if some relation of the plan does not hold once they are at rest, another layout is
    tried. If every layout violates a relation, the one that satisfies the most relations is checked
    first, and is returned with a warning for each relation that does not hold. The recorded support
    of each object is the one that it rests on. ``density`` is how full the table is ("sparse",
    "normal", "dense"); None takes it from the text.

    Raises:
        InputError: the text cannot be planned, or the seed is not a whole number in range.
        SceneError: the objects fit on no plausible table, or no layout comes to rest.
    """
    require_seed(seed)
    seed = int(seed)
    if isinstance(text, ScenePlan):
        plan = replace(text, density=density or text.density)
    else:
        plan = plan_scene(text, seed, density)
    if not plan.objects:
        raise InputError("The plan contains no objects; a scene must have at least one.")
    models = build_models(plan, seed)

    def lay_out_again(layout_seed: int) -> Candidate:
        rested = _rest_layout(plan, models, layout_seed, seed, name, config)
        seen = observe(rested.scene)
        unmet = sum(not outcome.holds for outcome in check_relations(plan, seen))
        return Candidate(partial(_judge, rested, seen, config), unmet)

    attempts = try_layouts(lay_out_again, seed, fulfilled=_FULFILLED)
    if attempts.best is not None:
        return warn_unmet(attempts.best)
    report = attempts.failed[-1].report
    raise SceneError(
        f"{ATTEMPTS} layouts of {plan.prompt!r} failed the physical gate: "
        f"{report.failure_text if report else ''}. Try another seed, or fewer stacked objects."
    )


def _judge(rested: Rested, seen: Rest, config: AssemblyConfig | None) -> Scene:
    """Run the physical gate on a scene; if that passes, its report also records the relations."""
    scene = finish(rested, config)
    assert scene.report is not None
    if not scene.report.passed:
        return scene
    return record_relations(scene, seen if scene.objects is rested.scene.objects else None)


def _rest_layout(
    plan: ScenePlan,
    models: Mapping[str, Model],
    layout_seed: int,
    seed: int,
    name: str | None,
    config: AssemblyConfig | None,
) -> Rested:
    """Lay out a plan and bring its objects to rest, without running the physical gate."""
    layout, table = lay_out(plan, models, layout_seed)
    provenance = Provenance(
        "compose", seed, plan.prompt, backends={"planner": "embedded"}, versions=versions(),
        warnings=tuple(dict.fromkeys([*plan.warnings, *layout.warnings])),
    )  # fmt: skip
    return bring_to_rest(
        models, layout.placements, table, table.size, provenance=provenance,
        name=name or scene_name(plan.prompt), config=config,
        plan=replace(plan, table=replace(plan.table, size=tuple(map(float, table.size)))),
    )  # fmt: skip
