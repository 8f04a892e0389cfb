"""The direct route: text to plan to layout to scene, without a picture.

Fast; objects are placed without overlap.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from .errors import InputError, SceneError, require_seed
from .language.planner import plan_scene
from .layout import build_models, lay_out
from .layout.relation_check import (
    Rest,
    check_relations,
    list_unmet,
    observe,
    record_relations,
    warn_unmet,
)
from .method.assembly import AssemblyConfig, Rested, bring_to_rest, finish
from .scene import Density, Model, Provenance, Scene, ScenePlan
from .scene.provenance import scene_name, versions

ATTEMPTS = 6
"""Layouts tried until one comes to rest soundly."""

_FULFILLED = 3  # layouts tried until one comes to rest with all relations that were asked for


def compose(
    text: str | ScenePlan,
    seed: int = 0,
    *,
    name: str | None = None,
    density: Density | None = None,
    config: AssemblyConfig | None = None,
) -> Scene:
    """Compose a scene straight from a text (or a plan) with catalogue objects.

    The same text and seed give the same scene. A layout whose objects do not come to rest soundly
    is replaced by another one, and so is one at rest in which not every relation of the plan holds;
    of those the one with most is judged first, and taken with a warning for each that does not
    hold. What each thing stands on is what it rests on. ``density`` says how full the table is
    ("sparse", "normal", "dense"); None takes it from the text.

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
        raise InputError("The plan holds no object; a scene needs at least one.")
    models = build_models(plan, seed)
    failures = ""
    best: Scene | None = None
    waiting: list[tuple[int, int, Rested, Rest]] = []
    for attempt in range(ATTEMPTS):
        rested = _rest_layout(plan, models, seed + 7919 * attempt, seed, name, config)
        seen = observe(rested.scene)
        unmet = sum(not outcome.holds for outcome in check_relations(plan, seen))
        waiting.append((unmet, attempt, rested, seen))
        enough = attempt + 1 >= _FULFILLED
        for unmet, _, rested, seen in sorted(waiting, key=lambda each: each[:2]):
            if unmet and (not enough or (best and len(list_unmet(best)) <= unmet)):
                break  # to judge a layout costs more than to try another
            scene = finish(rested, config)
            waiting = [each for each in waiting if each[2] is not rested]
            assert scene.report is not None
            if not scene.report.passed:
                failures = scene.report.failure_text
                continue
            same = scene.objects is rested.scene.objects
            scene = record_relations(scene, seen if same else None)
            if best is None or len(list_unmet(scene)) < len(list_unmet(best)):
                best = scene
        if best is not None and (enough or not list_unmet(best)):
            break
    if best is not None:
        return warn_unmet(best)
    raise SceneError(
        f"{ATTEMPTS} layouts of {plan.prompt!r} did not come to rest soundly: "
        f"{failures}. Try another seed, or fewer stacked things."
    )


def _rest_layout(
    plan: ScenePlan,
    models: Mapping[str, Model],
    layout_seed: int,
    seed: int,
    name: str | None,
    config: AssemblyConfig | None,
) -> Rested:
    """Return one layout of a plan at rest, not judged yet."""
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
