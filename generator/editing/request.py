"""Interpretation of an edit's text: the new object and the existing objects it refers to."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from ..errors import InputError, choices
from ..method.planned import fresh_names
from ..scene import TABLE, Object, PlannedObject, Scene, ScenePlan
from .plans import planned_things

Planner = Callable[[str, int], ScenePlan]
"""A reasoner's ``plan_scene`` method."""


@dataclass(frozen=True)
class Asked:
    """An object that the text of an edit requests.

    Unless an existing object is moved, its name is new to the scene. Its relations refer to the
    scene's objects by name, or to the table.
    """

    planned: PlannedObject
    style: str
    warnings: tuple[str, ...]


def understand(scene: Scene, text: str, planner: Planner, seed: int) -> Asked:
    """Return the single new object described by a text ("a red mug left of the laptop").

    The text refers to objects of the scene by their nouns or by their names ("mug_2").

    Raises:
        InputError: The text names no object or several, or a reference matches no object or
            several.
        BackendError: The planner failed.
    """
    words, named = _in_words(scene, text)
    plan = planner(words, seed)
    subject = _subject(plan, words)
    by_name = {o.name: o for o in plan.objects}
    targets = [r.target for r in subject.relations if r.target != TABLE]
    meant = {t: _resolve(scene, by_name[t], named) for t in dict.fromkeys(targets)}
    relations = tuple(replace(r, target=meant.get(r.target, TABLE)) for r in subject.relations)
    taken = {TABLE, *(o.name for o in (*scene.objects, *planned_things(scene)))}
    name = fresh_names([subject], taken)[subject.name]
    style = plan.style if plan.style != "plain" or not scene.plan else scene.plan.style
    return Asked(replace(subject, name=name, relations=relations), style, plan.warnings)


def whereabouts(scene: Scene, thing: Object, where: str, planner: Planner, seed: int) -> Asked:
    """Return an object of the scene with the relations described by a text ("left of the laptop").

    Raises:
        InputError: The text contains no position, or a reference matches no object or several.
        BackendError: The planner failed.
    """
    asked = understand(scene, f"a {thing.label} {where}", planner, seed)
    relations = asked.planned.relations
    if not relations:
        raise InputError(
            f"{where!r} does not describe a position. Use, for example, 'left of the laptop', 'on "
            "the book', 'in the middle of the table', or x and y in metres."
        )
    return replace(asked, planned=replace(as_planned(scene, thing), relations=relations))


def as_planned(scene: Scene, thing: Object) -> PlannedObject:
    """Return the planned object for an object in the scene, without relations."""
    planned = next((o for o in planned_things(scene) if o.name == thing.name), None)
    if planned is not None and planned.category == thing.model.category:
        return replace(planned, relations=())
    return PlannedObject(thing.name, thing.label, thing.model.category)


def _in_words(scene: Scene, text: str) -> tuple[str, dict[str, str]]:
    """Replace the names of objects in a text with nouns; also return the name for each noun."""
    named: dict[str, str] = {}
    for thing in scene.objects:
        pattern = rf"(?<![\w-])(?:the )?{re.escape(thing.name)}(?![\w-])"
        text, count = re.subn(pattern, f"a {thing.label}", text)
        if count:
            named[thing.label] = thing.name
    return text, named


def _subject(plan: ScenePlan, text: str) -> PlannedObject:
    """Return the requested object, which comes first; the others only describe its position."""
    if not plan.objects:
        raise InputError(
            f"{text!r} names no object to put on the table. Use, for example, 'a mug'."
        )
    place = {o.name: text.lower().find(o.noun.lower()) for o in plan.objects}
    subject = min(plan.objects, key=lambda o: place[o.name] if place[o.name] >= 0 else len(text))
    targets = {r.target for r in subject.relations}
    # Objects of the target's kind belong to it: "behind the two books".
    kinds = {(o.category, o.noun) for o in plan.objects if o.name in targets}
    others = [o for o in plan.objects if o is not subject and (o.category, o.noun) not in kinds]
    if others:
        raise InputError(
            f"{text!r} names several objects: {subject.noun}, {', '.join(o.noun for o in others)}. "
            "Edit one object at a time."
        )
    return subject


def _resolve(scene: Scene, target: PlannedObject, named: dict[str, str]) -> str:
    """Return the name of the object in the scene that a planned target refers to."""
    if target.noun in named:
        return named[target.noun]
    fits = [o for o in scene.objects if _fits(o, target)]
    if not fits:
        words = sorted({o.label for o in scene.objects} | {o.name for o in scene.objects})
        raise InputError(f"There is no {target.noun} on the table." + choices(target.noun, words))
    matching = _of_look(scene, fits, target) if len(fits) > 1 else fits
    if len(matching) > 1:
        raise InputError(
            f"{target.noun!r} could be {' or '.join(o.name for o in matching)}. Use the object's "
            f"name, as in 'next to {matching[0].name}'."
        )
    return matching[0].name


def _fits(thing: Object, target: PlannedObject) -> bool:
    same = target.category == thing.model.category != "generic"
    return same or target.noun.lower() == thing.label.lower()


def _of_look(scene: Scene, things: Sequence[Object], target: PlannedObject) -> Sequence[Object]:
    """Return the objects with the target's attributes in the scene's plan, or all if none match."""
    looks = {o.name: dict(o.attributes) for o in planned_things(scene)}
    alike = [t for t in things if target.attributes.items() <= looks.get(t.name, {}).items()]
    return alike or things
