"""Queries of the planner's result for a text."""

from __future__ import annotations

from collections import Counter

from generator.language.planner import plan_scene
from generator.scene import PlannedObject, ScenePlan


def plan(text: str) -> ScenePlan:
    return plan_scene(text, 0)


def counts(text: str) -> dict[str, int]:
    """Return the number of objects per category; a stand-in counts by its noun."""
    things = plan(text).objects
    return dict(Counter(o.category if o.category != "generic" else o.noun for o in things))


def found(planned: ScenePlan, name: str) -> PlannedObject:
    return next(o for o in planned.objects if o.name == name)


def related(planned: ScenePlan, name: str) -> set[tuple[str, str]]:
    """Return the relations of one object: (kind, target)."""
    return {(r.kind, r.target) for r in found(planned, name).relations}


def all_related(text: str) -> set[tuple[str, str, str]]:
    """Return every relation of a text: (name, kind, target)."""
    return {(o.name, r.kind, r.target) for o in plan(text).objects for r in o.relations}
